"""Views of lesson 02: frames that turn, in the plane and in space."""
from __future__ import annotations

import math
from math import cos, pi, radians, sin

import numpy as np

from ...arms.motions import ROTATE, TRANSLATE, X, Y, Z
from ...drawing.controls import Knob, PoseTable, subscript
from ...drawing.readings import Point
from ...drawing.scene import ARROW, FACE, at, origin_of
from ...drawing.sketch import Sketch
from ...views.live import LiveView

_LETTER = [(0.65, 0.6, 0), (0.3, 0.6, 0), (0.3, 0.2, 0), (0.3, 1.0, 0), (0.8, 1.0, 0)]  # an F

# Where c = (0.5, 1.2) has positive and where negative components in frame 1.
_EDGE = math.atan2(1.2, 0.5)
_SIDES = [(-pi, _EDGE - pi, -1, -1), (_EDGE - pi, _EDGE - pi / 2, -1, 1),
          (_EDGE - pi / 2, _EDGE, 1, 1), (_EDGE, _EDGE + pi / 2, 1, -1),
          (_EDGE + pi / 2, pi, -1, -1)]

_BOOK = (0.5, 0.7, 0.13)  # half of its sides
# Corners of each side, counter-clockwise from outside: the covers, the spine, and the pages.
_SIDES_OF_BOOK = [((4, 5, 6, 7), "cover"), ((3, 2, 1, 0), "cover"), ((0, 4, 7, 3), "cover"),
                  ((1, 2, 6, 5), "pages"), ((0, 1, 5, 4), "pages"), ((2, 3, 7, 6), "pages")]
_TITLE = [(-0.6, 0.4), (0.6, 0.4), (0.6, 0.7), (-0.6, 0.7)]  # shares of those halves


def turning_view() -> LiveView:
    """A frame that turns, and the circle of its tips."""
    return _shown(_on_circle("A frame that turns")[0], "xy")


def axes_view() -> LiveView:
    """The unit axes of a turning frame, and their components in the room."""
    sketch, theta, frame = _on_circle("The axes of a frame that turns")
    for name, start, texts in (("x", 0.0, ("cos θ", "sin θ")), ("y", pi / 2, ("−sin θ", "cos θ"))):
        foot = _crank(sketch, theta, 0.5, 0.5, start)
        tip = at(frame, (cos(start), sin(start), 0))[0]
        sketch.line(f"legs-{name}", [origin_of(0), origin_of(foot), tip], f"{name}-leg")
        for text, first, away in zip(texts, (0.25, 0.75), ((0, 1, 0), (-1, 0, 0))):
            middle = _crank(sketch, theta, first, 0.25, start)
            _beside_leg(sketch, text, at(middle, (0, 0, 0), away), name, theta)
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
    _multiple(sketch, "1.2 x₁", origin_of(0), corner, at(frame, (0.6, 0, 0), (0.6, 1, 0)))
    _multiple(sketch, "0.5 y₁", corner, point, at(frame, (1.2, 0.25, 0), (0, 0.25, 0)))
    sketch.line("circle", _circle(1.3))
    sketch.arrow("arrow-c", origin_of(0), point, "point")
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
    # The feet of c on x₁ and y₁: half of c, and half of its mirror image, which turns twice as
    # fast, to one side or to the other.
    sketch.move(TRANSLATE, X, 0.25, parent=0)
    sketch.move(TRANSLATE, Y, 0.6)
    mirror = sketch.move(ROTATE, Z, 0.0, theta, gain=2.0)
    for letter, name, foot, away in (("x", "c¹ₓ", (0.25, -0.6, 0), (0, 1, 0)),
                                     ("y", "c¹ᵧ", (-0.25, 0.6, 0), (1, 0, 0))):
        sketch.line(f"drop-{letter}", [at(mirror, foot)[0], point])
        middle = _halfway(sketch, theta, foot)
        _multiple(sketch, name, origin_of(0), at(mirror, foot)[0], at(middle, (0, 0, 0), away))
    _square_marks(sketch, theta, mirror)
    sketch.arrow("arrow-c", origin_of(0), point, "point")
    sketch.reading("c0", "c⁰ = {}, always", sketch.vector(0, point))
    sketch.reading("c1", "c¹ = (R₁⁰)ᵀ c⁰ = {}", sketch.vector(0, point, frame))
    return _shown(sketch, "xy")


def mirror_view() -> LiveView:
    """A letter on a sheet of paper, which can be turned on the table and flipped over."""
    sketch = Sketch("A letter, and its mirror image", 1.45)
    theta = sketch.knob(Knob.angle("theta", "θ", title="turn the sheet on the table"))
    phi = sketch.knob(Knob.angle("phi", "φ", 0, pi, title="flip the sheet over, about x₁"))
    sketch.axes("0", 0, 1.2)
    turned = sketch.move(ROTATE, Z, 0.0, theta, 0)
    sheet = sketch.tip = sketch.move(ROTATE, X, 0.0, phi)
    sketch.axes("1", sheet, 1.0)
    sketch.handle("tip of x₁", at(turned, (1, 0, 0))[0], theta)
    sketch.line("outline", at(0, *_LETTER))
    sketch.line("letter", at(sheet, *_LETTER), "first")
    point = sketch.point("c", sheet, _LETTER[-1][:2])
    sketch.reading("c0", "c⁰ = {}", sketch.vector(0, point))
    return _shown(sketch, "xy")


def two_turns_view() -> LiveView:
    """Frame 2 turned in frame 1, and frame 1 in frame 0, with a point that is fixed in frame 2."""
    sketch = Sketch("Two turns in the plane", 1.45)
    knobs = [sketch.theta(k, home) for k, home in ((1, 35), (2, 50))]
    sketch.axes("0", 0, 1.25)
    before = 0
    for k, (knob, length, radius) in enumerate(zip(knobs, (1.1, 0.95), (0.75, 0.5)), start=1):
        frame = sketch.move(ROTATE, Z, 0.0, knob, before)
        sketch.sweep(f"arc-{k}", frame, (radius, 0, 0), text=f"θ{subscript(k)}")
        sketch.axes(str(k), frame, length)
        sketch.handle(f"tip of x{subscript(k)}", at(frame, (length, 0, 0))[0], knob)
        before, inner = frame, before
    sketch.tip = frame
    point = sketch.point("c", frame, (1.2, 0.3))
    for text, seen in (("c² = {}, always", frame), ("c¹ = R₂¹ c² = {}", inner),
                       ("c⁰ = R₁⁰ c¹ = {}", 0)):
        sketch.reading(text[:2], text, sketch.vector(0, point, seen))
    sketch.pose = PoseTable.of_frame("R₂⁰, the axes of frame 2 as columns", "2", "xy", rows=2)
    return LiveView(sketch.scene())


def book_view() -> LiveView:
    """Two books that are turned about z and about x of the room, in both orders."""
    sketch = Sketch("Two quarter turns of a book, in both orders", 2.6, center=(0, 0, 0),
                    planar=False)
    sketch.presets["3-D"] = (-62.0, 30.0)
    knob = sketch.knob(Knob("t", "turns", 0, 2, 0, step=0.1, whole=True))
    sketch.poses = [[0], [1], [2]]
    sketch.axes("0", 0, 0.9)
    for name, where, words, turns in (("A", -1.6, "z, then x", ((X, 1), (Z, 0))),
                                      ("B", 1.6, "x, then z", ((Z, 1), (X, 0)))):
        book = sketch.move(TRANSLATE, X, where, parent=0)
        for axis, start in turns:  # a turn about axes of the room stands left of the one before
            book = sketch.move(ROTATE, axis, 0, knob, gain=pi / 2, start=start)
        draw_book(sketch, name, book)
        sketch.axes(name, book, 1.15)
        sketch.reading(name, f"book {name} ({words}): z{name} = {{}}",
                       sketch.vector(book, at(book, (0, 0, 1))[0]))
    return LiveView(sketch.scene())


def spatial_view(axis: str) -> LiveView:
    """The elementary rotation about one of the axes "x", "y", "z"."""
    k = "xyz".index(axis)
    sketch = Sketch(f"Rotation about {axis}", 1.32, center=(0.2, 0.2, 0.2), planar=False)
    theta = sketch.knob(Knob.angle("theta", "θ", home=radians(35)))
    sketch.axes("0", 0, 1.4)
    frame = sketch.tip = sketch.move(ROTATE, k, 0.0, theta)
    sketch.axes("1", frame, 1.0)
    for other, radius in zip(sorted({0, 1, 2} - {k}), (0.75, 0.55)):
        letter, unit = "xyz"[other], np.eye(3)[other]
        sketch.handle(f"tip of {letter}₁", at(frame, unit)[0], theta)
        sketch.sweep(f"arc-{letter}", frame, radius * unit, letter, text="θ")
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


def _on_circle(name: str) -> tuple[Sketch, int, int]:
    sketch, theta, frame = _turning(name)
    sketch.line("circle", _circle(1.0))
    return sketch, theta, frame


def _beside_leg(sketch: Sketch, text: str, place: tuple[Point, ...], style: str,
                theta: int) -> None:
    """The name of a leg; at an angle of zero one leg has no length, and none has a name."""
    for low, high in ((-pi, -0.05), (0.05, pi)):
        sketch.label(text, place, style, when=(theta, low, high))


def _multiple(sketch: Sketch, text: str, tail: Point, head: Point,
              place: tuple[Point, ...]) -> None:
    """A multiple of an axis of frame 1, under the axis, with its name."""
    letter = "y" if "y" in text or "ᵧ" in text else "x"
    sketch.add(f"sum-{letter}", ARROW, f"{letter}-wide", (tail, head), lift=-0.1, part="arrow")
    sketch.label(text, place, letter)


def _halfway(sketch: Sketch, theta: int, foot: tuple[float, ...]) -> int:
    """A frame, parallel to frame 1, on half the way to a foot of c."""
    sketch.move(TRANSLATE, X, 0.125, parent=0)
    sketch.move(TRANSLATE, Y, 0.3)
    sketch.move(ROTATE, Z, 0.0, theta, gain=2.0)
    sketch.move(TRANSLATE, X, foot[0] / 2)
    sketch.move(TRANSLATE, Y, foot[1] / 2)
    return sketch.move(ROTATE, Z, 0.0, theta, gain=-1.0)


def _square_marks(sketch: Sketch, theta: int, mirror: int) -> None:
    """The right angles at both feet, inside the rectangle that they make with c."""
    for letter, place in (("x", (0.25, -0.6)), ("y", (-0.25, 0.6))):
        sketch.move(TRANSLATE, X, place[0], parent=mirror)
        sketch.move(TRANSLATE, Y, place[1])
        foot = sketch.move(ROTATE, Z, 0.0, theta, gain=-1.0)
        for k, (low, high, x, y) in enumerate(_SIDES):
            inward = (-x, y) if letter == "x" else (x, -y)
            u, v = (0.09 * way for way in inward)
            sketch.line(f"right-angle-{letter}-{k}", at(foot, (u, 0, 0), (u, v, 0), (0, v, 0)),
                        "arc", part="right angle", when=(theta, low, high))


def draw_book(sketch: Sketch, name: str, frame: int) -> None:
    """A closed book about the origin of a frame, its cover on the side of z."""
    body, (w, h, t) = sketch.body(), _BOOK
    corners = [(x, y, z) for z in (-t, t) for x, y in ((-w, -h), (w, -h), (w, h), (-w, h))]
    for k, (side, style) in enumerate(_SIDES_OF_BOOK):
        sketch.add(f"book-{name}-{k}", FACE, style, at(frame, *(corners[one] for one in side)),
                   body=body, part="book")
    title = [(x * w, y * h, t) for x, y in _TITLE]
    sketch.add(f"title-{name}", FACE, "print", at(frame, *title), body=body, part="book")


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
