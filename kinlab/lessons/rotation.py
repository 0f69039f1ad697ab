"""Lesson 02, rotation: its views, its exercises' references and typical slips."""
from __future__ import annotations

import math
from math import cos, pi, radians, sin

import numpy as np

from ..answers.judges import Judge, choices, function, values
from ..answers.matrices import matrix_entry
from ..arms.motions import ROTATE, TRANSLATE, X, Y, Z
from ..arms.transforms import rotation_2d
from ..drawing.controls import Knob, PoseTable
from ..drawing.readings import Point
from ..drawing.scene import at, origin_of
from ..drawing.sketch import Sketch
from ..views.live import LiveView

# ---- Views --------------------------------------------------------------------------


def axes_view() -> LiveView:
    """The unit axes of a turning frame, and their components in the room."""
    sketch, theta, frame = _turning("The axes of a frame that turns")
    sketch.line("circle", _circle(1.0))
    for name, start in (("x", 0.0), ("y", pi / 2)):
        foot = _crank(sketch, theta, 0.5, 0.5, start)
        tip = at(frame, (cos(start), sin(start), 0))[0]
        sketch.line(f"legs-{name}", [origin_of(0), origin_of(foot), tip])
    for text, place, (x, y) in (("cos θ", (0.25, 0.25), (0, 1)), ("sin θ", (0.75, 0.25), (-1, 0))):
        middle = _crank(sketch, theta, *place)
        sketch.label(text, at(middle, (0, 0, 0), (x, y, 0)))
    for letter, axis in (("x", (1, 0, 0)), ("y", (0, 1, 0))):
        sketch.reading(letter, letter + "₁ seen from frame 0 = {}",
                       sketch.vector(0, at(frame, axis)[0]))
    return _shown(sketch, "xy")


def riding_view() -> LiveView:
    """The frame turns and takes the point c along."""
    sketch, theta, frame = _turning("A frame that turns and takes a point along")
    point = sketch.point("c", frame, (1.2, 0.5))
    sketch.handle("point c", point, theta)
    corner = at(frame, (1.2, 0, 0))[0]
    sketch.components("c1", point, frame)
    sketch.line("circle", _circle(1.3))
    sketch.arrow("arrow-c", origin_of(0), point)
    sketch.reading("c1", "c¹ = {}, always", sketch.vector(frame, point, frame))
    sketch.reading("c0", "c⁰ = 1.2 x₁ + 0.5 y₁ = {} + {} = {}",
                   sketch.vector(0, corner), sketch.vector(corner, point),
                   sketch.vector(0, point))
    sketch.decimals = 2
    return _shown(sketch, "xy")


def still_view() -> LiveView:
    """The frame turns; the point c keeps its place in the room."""
    sketch, theta, frame = _turning("A frame that turns, a point that does not")
    point = sketch.point("c", 0, (0.5, 1.2))
    # The foot of c on x₁: half of c and half of its mirror image, which turns twice as fast.
    sketch.move(TRANSLATE, X, 0.25, parent=0)
    sketch.move(TRANSLATE, Y, 0.6)
    mirror = sketch.move(ROTATE, Z, 0.0, theta, gain=2.0)
    foot = at(mirror, (0.25, -0.6, 0))[0]
    sketch.line("legs-c1", [origin_of(0), foot, point])
    sketch.arrow("arrow-c", origin_of(0), point)
    sketch.reading("c0", "c⁰ = {}, always", sketch.vector(0, point))
    sketch.reading("c1", "c¹ = (R₁⁰)ᵀ c⁰ = {}", sketch.vector(0, point, frame))
    return _shown(sketch, "xy")


def spatial_view(axis: str) -> LiveView:
    """The elementary rotation about one of the axes "x", "y", "z"."""
    k = "xyz".index(axis)
    sketch = Sketch(f"Rotation about {axis}", 1.32, center=(0.2, 0.2, 0.2), planar=False)
    theta = sketch.knob(Knob.angle("theta", "θ", home=radians(35)))
    sketch.axes("0", 0, 1.4)
    frame = sketch.tip = sketch.move(ROTATE, k, 0.0, theta)
    sketch.axes("1", frame, 1.0)
    for other in sorted({0, 1, 2} - {k}):
        sketch.handle(f"tip of {'xyz'[other]}₁", at(frame, np.eye(3)[other])[0], theta)
        sketch.sweep(f"arc-{other}", frame, 0.75 * np.eye(3)[other], text="θ")
    for letter, unit in zip("xyz", np.eye(3)):
        sketch.reading(letter, letter + "₁ seen from frame 0 = {}",
                       sketch.vector(0, at(frame, unit)[0]))
    return _shown(sketch, "xyz")


def _turning(name: str) -> tuple[Sketch, int, int]:
    """A sketch with frame 0, the knob theta, and frame 1 turned by it."""
    sketch = Sketch(name, 1.45)
    theta = sketch.knob(Knob.angle("theta", "θ", home=radians(35)))
    sketch.axes("0", 0, 1.0)
    frame = sketch.frame("1", theta=theta, length=1.0)
    sketch.sweep("arc", frame, (0.35, 0, 0), text="θ")
    return sketch, theta, frame


def _crank(sketch: Sketch, theta: int, first: float, second: float, start: float = 0.0) -> int:
    """A frame, parallel to the room, at first*(cos, sin) + second*(cos, -sin) of start + theta."""
    sketch.move(ROTATE, Z, start, theta, parent=0)
    sketch.move(TRANSLATE, X, first)
    sketch.move(ROTATE, Z, -2 * start, theta, gain=-2.0)
    sketch.move(TRANSLATE, X, second)
    return sketch.move(ROTATE, Z, start, theta)


def _circle(radius: float) -> list[Point]:
    return [at(0, (radius * cos(t), radius * sin(t), 0))[0] for t in np.linspace(0, 2 * pi, 73)]


def _shown(sketch: Sketch, letters: str) -> LiveView:
    """The view, with the rotation matrix beside it."""
    sketch.pose = PoseTable.of_frame("R₁⁰, the axes of frame 1 as columns", "1", letters,
                                     rows=len(letters))
    return LiveView(sketch.scene())


# ---- Exercise 1: the matrix -----------------------------------------------------------

_TURN_SLIPS = [
    ("The angle arrives in radians; do not convert it.", lambda t: rotation_2d(radians(t))),
    ("The angle arrives in radians already: no conversion is needed.",
     lambda t: rotation_2d(math.degrees(t))),
    ("This is the transpose: it turns clockwise. The axes of frame 1 are columns, not rows.",
     lambda t: rotation_2d(t).T),
    ("Sine and cosine have changed places: the first column is x₁ = (cos θ, sin θ).",
     lambda t: np.array([[sin(t), -cos(t)], [cos(t), sin(t)]])),
    ("No sine has a minus sign: y₁ points to the left of x₁, so its x component is -sin θ.",
     lambda t: np.array([[cos(t), sin(t)], [sin(t), cos(t)]])),
    ("This is a mirror image: its second column is -y₁.", lambda t: rotation_2d(t) * [1, -1]),
]

# ---- Exercises 2 and 3: a frame given by its x axis ------------------------------------

_R = np.array([[0.6, -0.8], [0.8, 0.6]])
_C0 = np.array([2.0, 1.0])

_READ_SLIPS = [
    ("The axes stand in the rows. They belong in the columns.", _R.T),
    ("Your y axis lies to the right of the x axis: a left-handed frame, a mirror image.",
     _R * [1, -1]),
    ("The second column repeats the x axis with its entries exchanged; it must be perpendicular "
     "to the first.", np.array([[0.6, 0.8], [0.8, 0.6]])),
    ("The columns have changed places: x₁ comes first.", _R[:, ::-1]),
]
_SEEN_SLIPS = [
    ("You multiplied by R: that takes coordinates from frame 1 to frame 0.", _R @ _C0),
    ("x₁ · c is right. Check y₁ · c.", (_R.T @ _C0) * [1, -1]),
    ("A point that stands still still changes its coordinates: the frame has turned.", _C0),
]

# ---- Exercise 4: which are rotations? ---------------------------------------------------

_RIGHT_ROTATIONS = {1, 4, 6}
_ROTATION_HINTS = {
    ("rotations", 1): "Test matrix 1: lengths of the columns, their product, the determinant.",
    ("rotations", 2): "The columns of matrix 2 are perpendicular and of length 1. "
                      "What is its determinant?",
    ("rotations", 3): "How long are the columns of matrix 3?",
    ("rotations", 4): "Matrix 4 is a turn by -90°. Where does it take x?",
    ("rotations", 5): "The columns of matrix 5 have length 1. Are they perpendicular?",
    ("rotations", 6): "Two minus signs: is that a mirror image, or a turn by half a circle?",
}

# ---- Exercise 5: a camera that looks ahead ----------------------------------------------

_CAMERA = np.array([[0.0, 0, 1], [-1, 0, 0], [0, -1, 0]])
_CAMERA_SLIPS = [
    ("The axes stand in the rows. They belong in the columns.", _CAMERA.T),
    ("Your x axis points to the other side: x × y is -z, a left-handed frame.",
     _CAMERA * [-1, 1, 1]),
    ("Your y axis points up; in the camera's image y points down.", _CAMERA * [-1, -1, 1]),
    ("Your y axis points up, and the frame is left-handed.", _CAMERA * [1, -1, 1]),
    ("Nothing is turned here: the camera would look up along z₀.", np.eye(3)),
]

JUDGES: dict[str, Judge] = {
    "rotation.1": function(
        rotation_2d, [{"theta": t} for t in (0.0, pi / 6, -2.0, 4.0)], entry=matrix_entry,
        slips=_TURN_SLIPS,
        praise="Your function agrees at every angle. kinlab's own is rotation_2d."),
    "rotation.2": values(
        _R, entry=matrix_entry, slips=_READ_SLIPS,
        praise="One axis was enough: the other one follows by a quarter turn to the left."),
    "rotation.3": values(
        _R.T @ _C0, entry=lambda index: f"the {'xy'[index[0]]} of c_1", slips=_SEEN_SLIPS,
        praise="Each component is a dot product of c with an axis of frame 1."),
    "rotation.4": choices(
        {"rotations": _RIGHT_ROTATIONS}, {1, 2, 3, 4, 5, 6}, _ROTATION_HINTS, noun="matrix",
        praise="Columns of length 1, perpendicular, determinant +1: all three are needed."),
    "rotation.5": values(
        _CAMERA, entry=matrix_entry, slips=_CAMERA_SLIPS,
        praise="This is how most cameras on robots are described. What the camera sees at "
               "(0, 0, 2), the robot finds two units ahead."),
}
