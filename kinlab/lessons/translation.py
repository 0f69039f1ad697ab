"""Lesson 01, translation: its views, its exercises' references and typical slips."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..answers.judges import Judge, expressions, values
from ..arms.motions import TRANSLATE, X, Y
from ..drawing.controls import Knob
from ..drawing.readings import Point
from ..drawing.scene import origin_of
from ..drawing.sketch import Sketch
from ..views.live import LiveView

# ---- Views --------------------------------------------------------------------------


def sliding_view() -> LiveView:
    """Frame 1 slides; the point c keeps its place in the room."""
    sketch = Sketch("A frame that slides, a point that does not", 3.3)
    sketch.follows = True
    x, y = _knobs(sketch, "o", "o", (2, -1))
    frame, halfway = _frame(sketch, "1", x, y)
    point = sketch.point("c", 0, (1, 2))
    beside = sketch.move(TRANSLATE, Y, 0.0, y, parent=0)  # as high as the origin of frame 1
    sketch.line("legs-c1", [origin_of(frame), (beside, 1.0, 0.0, 0.0), point])
    _triangle(sketch, frame, point, origin_of(halfway), (halfway, 0.5, 1.0, 0.0),
              (0, 0.5, 1.0, 0.0))
    _sum(sketch, frame, point)
    sketch.decimals = 2
    return LiveView(sketch.scene())


def riding_view() -> LiveView:
    """Frame 1 slides and takes the point c along."""
    sketch = Sketch("A frame that slides and takes a point along", 3.8)
    sketch.follows = True
    x, y = _knobs(sketch, "o", "o", (-2, -1))
    frame, halfway = _frame(sketch, "1", x, y)
    point = sketch.point("c", frame, (1, 2))
    sketch.components("c1", point, frame)
    sketch.handle("point c", point, x, y)
    _triangle(sketch, frame, point, origin_of(halfway), (frame, 0.5, 1.0, 0.0),
              (halfway, 0.5, 1.0, 0.0))
    _sum(sketch, frame, point)
    sketch.decimals = 2
    return LiveView(sketch.scene())


def chain_view() -> LiveView:
    """Two slides one after the other; dashed, the same two in the other order."""
    sketch = Sketch("Two slides, and the same two in the other order", 5.3)
    sketch.follows = True
    first = _knobs(sketch, "o1", "o₁", (1.5, -1))
    second = _knobs(sketch, "o2", "o₂", (-0.5, 1.5))
    one, half_one = _frame(sketch, "1", *first)
    two, half_two = _frame(sketch, "2", *second, parent=one)
    other, _ = _slide(sketch, *second, parent=0)
    start, corner, middle, end = map(origin_of, (0, one, other, two))
    sketch.line("other-order", [start, middle, end])
    for name, tail, head in (("o1", start, corner), ("o2", corner, end), ("sum", start, end)):
        sketch.arrow(f"arrow-{name}", tail, head)
    half = origin_of(_slide(sketch, *second, parent=half_one)[1])
    sketch.label("o₁⁰", (origin_of(half_one), end))
    sketch.label("o₂¹", (origin_of(half_two), start))
    sketch.label("o₂⁰", (half, corner))
    sketch.reading("o2", "o₂⁰ = o₁⁰ + o₂¹ = {} + {} = {}", sketch.vector(0, one),
                   sketch.vector(one, two), sketch.vector(0, two))
    sketch.reading("other", "o₂¹ + o₁⁰ = {} + {} = {}", sketch.vector(0, other),
                   sketch.vector(other, two), sketch.vector(0, two))
    sketch.decimals = 2
    return LiveView(sketch.scene())


def _knobs(sketch: Sketch, name: str, letter: str, home: tuple[float, float]) -> tuple[int, int]:
    reach = 2.5 if name == "o" else 2.0
    lower = {"o": ("oₓ", "oᵧ")}.get(letter, (f"{letter} x", f"{letter} y"))
    x, y = (sketch.knob(Knob.length(f"{name}_{axis}", label, -reach, reach, start))
            for axis, label, start in zip("xy", lower, home))
    return x, y


def _frame(sketch: Sketch, name: str, x: int, y: int, parent: int = 0) -> tuple[int, int]:
    """A frame that slides, with its axes beside those of the room; and a frame halfway to it."""
    if parent == 0:
        sketch.axes("0", 0, 1.0)
    frame, halfway = _slide(sketch, x, y, parent)
    sketch.axes(name, frame, 1.0)
    sketch.handle(f"origin of frame {name}", frame, x, y)
    return frame, halfway


def _slide(sketch: Sketch, x: int, y: int, parent: int) -> tuple[int, int]:
    ends = []
    for share in (1.0, 0.5):
        sketch.move(TRANSLATE, X, 0.0, x, parent, gain=share)
        ends.append(sketch.move(TRANSLATE, Y, 0.0, y, gain=share))
    return ends[0], ends[1]


def _triangle(sketch: Sketch, frame: int, point: Point, *middles: Point) -> None:
    """The arrows to frame 1, from there to the point, and from the room's origin to the point.

    The name of each stands at its middle, outside the triangle.
    """
    room, origin = origin_of(0), origin_of(frame)
    for name, text, tail, head, middle, across in zip(
            ("o", "c1", "c0"), ("o₁⁰", "c¹", "c⁰"), (room, origin, room), (origin, point, point),
            middles, (point, room, origin)):
        sketch.arrow(f"arrow-{name}", tail, head)
        sketch.label(text, (middle, across))


def _sum(sketch: Sketch, frame: int, point: Point) -> None:
    sketch.reading("c0", "c⁰ = o₁⁰ + c¹ = {} + {} = {}", sketch.vector(0, frame),
                   sketch.vector(frame, point), sketch.vector(0, point))


# ---- Exercise 1: there and back ------------------------------------------------------

_O, _C1, _D0 = np.array([[3, -1], [-2, 4], [1, 2]])
_ROWS = ("c_0", "d_1", "o_0 as frame 1 sees it")


def _entry(index: tuple) -> str:
    return f"the {'xy'[index[1]]} of {_ROWS[index[0]]}"


_THERE_AND_BACK = np.array([_O + _C1, _D0 - _O, -_O])
_SLIPS = [
    ("Sum and difference have changed places: c⁰ = o₁⁰ + c¹, and so c¹ = c⁰ - o₁⁰.",
     [_C1 - _O, _D0 + _O, -_O]),
    ("From frame 1 to the room o₁⁰ is added.", [_C1 - _O, _D0 - _O, -_O]),
    ("From the room to frame 1 o₁⁰ is subtracted.", [_O + _C1, _D0 + _O, -_O]),
    ("The difference is the wrong way round: it is d⁰ - o₁⁰.", [_O + _C1, _O - _D0, -_O]),
    ("The third one is where frame 1 sees the origin of frame 0, and you gave where frame 0 sees "
     "that of frame 1.", [_O + _C1, _D0 - _O, _O]),
    ("A frame sees its own origin at (0, 0); asked is where frame 1 sees that of frame 0.",
     [_O + _C1, _D0 - _O, 0 * _O]),
    ("x and y have changed places.", _THERE_AND_BACK[:, ::-1]),
]

# ---- Exercise 2: what the camera sees, told to the robot --------------------------------

_CAMERA_SYMBOLS = ("k_x", "k_y", "b_x", "b_y", "p_x", "p_y")
_CAMERA_POINTS = [dict(zip(_CAMERA_SYMBOLS, numbers))
                  for numbers in ((4, 3, 1, -2, -2, 1.5), (0.3, -1, 2, 0.7, 1.1, 5))]


def _camera(k_sign: int, b_sign: int, p_sign: int) -> Callable[..., list[float]]:
    """Sums of the three vectors, each with a sign."""
    return lambda k_x, k_y, b_x, b_y, p_x, p_y: [
        k_sign * k + b_sign * b + p_sign * p for k, b, p in ((k_x, b_x, p_x), (k_y, b_y, p_y))]


_CAMERA_SLIPS = [
    ("This is where the room sees the part. The robot counts from its own base.",
     _camera(1, 0, 1)),
    ("The base is subtracted, not added: from the room to the robot's frame.", _camera(1, 1, 1)),
    ("The camera is added: from its frame to the room. You subtracted it.", _camera(-1, 1, 1)),
    ("The camera is added and the base is subtracted; you subtracted both.", _camera(-1, -1, 1)),
    ("The camera sees the part at p, but is not itself at the room's origin.", _camera(0, -1, 1)),
    ("All signs are turned round: this is where the part sees the robot.", _camera(-1, 1, -1)),
    ("This is where the robot sees the camera. Where is the part?", _camera(1, -1, 0)),
]

# ---- Exercise 3: where must the frame be? ---------------------------------------------

_C, _D = np.array([[3.0, 1.0], [-1.0, 3.0]])
_BETWEEN_SLIPS = [
    ("This is the vector from d to c. Write down c¹ = -d¹ with c¹ = c⁰ - o₁⁰.", _C - _D),
    ("This is the vector from c to d. Write down c¹ = -d¹ with c¹ = c⁰ - o₁⁰.", _D - _C),
    ("You are close: the origin stands twice in the equation.", _C + _D),
    ("This is half the way from d to c, counted from the room's origin. From where does it "
     "start?", (_C - _D) / 2),
    ("This is half the way from c to d, counted from the room's origin. From where does it "
     "start?", (_D - _C) / 2),
    ("From the room's origin both points are equally far, but do the two arrows point in "
     "opposite directions?", 0 * _C),
]

JUDGES: dict[str, Judge] = {
    "translation.1": values(
        _THERE_AND_BACK, entry=_entry, slips=_SLIPS,
        praise="Add on the way to the room, subtract on the way back."),
    "translation.2": expressions(
        ("x", "y"), _camera(1, -1, 1), _CAMERA_POINTS, constants={}, slips=_CAMERA_SLIPS,
        praise="Up into the room by the camera, down into the robot's frame by its base: "
               "p^B = o_K^0 - o_B^0 + p^K."),
    "translation.3": values(
        (_C + _D) / 2, slips=_BETWEEN_SLIPS,
        entry=lambda index: f"the {'xy'[index[0]]} of o_1",
        praise="The frame stands midway. From there the two points lie in opposite directions, "
               "equally far."),
}
