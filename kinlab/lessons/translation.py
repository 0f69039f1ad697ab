"""Lesson 01, translation: its views, predictions, exercises' references and typical slips."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..answers.judges import Judge, expressions, values
from ..answers.prediction import Asked, Choice, Mark, Number, Several, Signs
from ..arms.motions import TRANSLATE, Numbers, X, Y
from ..drawing.controls import Knob
from ..drawing.readings import Point
from ..drawing.scene import origin_of
from ..drawing.sketch import Sketch
from ..views.live import LiveView
from .asked import pair, said

_WORDS = {"vector": "ink"}  # the style of an arrow's name, where it is not the arrow's own

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
    half = origin_of(_slide(sketch, *second, parent=half_one)[1])
    for name, text, tail, head, places, style in (
            ("o1", "o₁⁰", start, corner, (origin_of(half_one), end), "length"),
            ("o2", "o₂¹", corner, end, (origin_of(half_two), start), "length"),
            ("sum", "o₂⁰", start, end, (half, corner), "vector")):
        sketch.arrow(f"arrow-{name}", tail, head, style)
        sketch.label(text, places, _WORDS.get(style, style))
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

    The name of each stands at its middle, outside the triangle. The slide of the frame has the
    colour of lengths, as its sliders do, what frame 1 measures that of points; the sum is black.
    """
    room, origin = origin_of(0), origin_of(frame)
    for name, text, tail, head, middle, across, style in zip(
            ("o", "c1", "c0"), ("o₁⁰", "c¹", "c⁰"), (room, origin, room), (origin, point, point),
            middles, (point, room, origin), ("length", "point", "vector")):
        sketch.arrow(f"arrow-{name}", tail, head, style)
        sketch.label(text, (middle, across), _WORDS.get(style, style))


def _sum(sketch: Sketch, frame: int, point: Point) -> None:
    sketch.reading("c0", "c⁰ = o₁⁰ + c¹ = {} + {} = {}", sketch.vector(0, frame),
                   sketch.vector(frame, point), sketch.vector(0, point))


# ---- Predictions --------------------------------------------------------------------------

_GROWS = {"+": "grows", "-": "falls", "0": "stays"}


def _change(axis: str, way: str, right: tuple[str, str], why: str, before: float,
            after: float) -> Signs:
    """How components change as a frame slides."""
    return Signs(
        ask=f"Frame 1 slides {way}. How do the components of the three arrows change?", why=why,
        rows=("x", "y"), columns=("o₁⁰", "c¹", "c⁰"), right=right, among=_GROWS,
        start={f"o_{axis}": before}, shows={f"o_{axis}": after})


def _origin(c_1: tuple[float, float], place: tuple[float, float], why: str) -> Mark:
    """Where the origin of frame 1 must be to see the point like that."""
    x, y = c_1
    start = {"o_x": -1.0, "o_y": -1.0}
    return Mark(
        ask=f"The point c stays at c⁰ = (1, 2). Frame 1 slides until it sees c at "
            f"c¹ = {pair(*c_1)}. Where is its origin then?",
        why=why, start=start, shows={"o_x": place[0], "o_y": place[1]}, of="frame-1-x",
        tolerance=0.25, slips=[
            *[((1 + x, 2 + y, 0), "You added c¹; to get to the origin, go back from c: c⁰ − c¹.")
              ] * any(c_1),
            ((x, y, 0), "That is c¹, measured from frame 0; it must be measured from frame 1.")])


def _carried(place: tuple[float, float], why: str) -> Mark:
    """Where the point is after a slide of the frame that it rides on."""
    x, y = place
    return Mark(
        ask=f"The point c rides along, with c¹ = (1, 2). Frame 1 slides to o₁⁰ = {pair(x, y)}. "
            "Where is c then?",
        why=why, start={"o_x": 1, "o_y": 0.5}, shows={"o_x": x, "o_y": y}, of="point-c",
        tolerance=0.25, slips=[
            ((1, 2, 0), "That is c¹, measured from frame 0; it begins at frame 1."),
            ((2, 2.5, 0), "There c was before. It rides along."),
            ((2 + x, 2.5 + y, 0), "You added the slide to where c was; o₁⁰ says where frame 1 is, "
                                  "not how far it went.")])


def _two_slides(first: tuple[float, float], second: tuple[float, float], why: str) -> Mark:
    """Where two slides lead to."""
    (a, b), (c, d) = first, second
    return Mark(
        ask=f"Frame 1 slides to o₁⁰ = {pair(a, b)}. From there frame 2 slides by "
            f"o₂¹ = {pair(c, d)}. Where is the origin of frame 2?",
        why=why, start={"o1_x": 0.5, "o1_y": 0.0, "o2_x": 1.0, "o2_y": 1.0},
        shows={"o1_x": a, "o1_y": b, "o2_x": c, "o2_y": d}, of="frame-2-x", tolerance=0.25,
        slips=[((c, d, 0), "That would be from frame 0; the second slide begins at frame 1."),
               ((a - c, b - d, 0), "You went back by the second slide."),
               ((a, b, 0), "That is frame 1. Frame 2 goes on from there.")])


def _seen_back(o_01: tuple[float, float], why: str) -> Choice:
    """Where frame 1 sees the origin of frame 0."""
    x, y = o_01
    return Choice(
        ask=f"Frame 0 sees the origin of frame 1 at o₁⁰ = {pair(x, y)}. Where does frame 1 see "
            "the origin of frame 0?",
        why=why, start={"o_x": x, "o_y": y}, right=pair(-x, -y), options={
            pair(x, y): "Stand at frame 1 and look back: the way back has the other signs.",
            pair(-x, -y): "", pair(0, 0): "There a frame sees its own origin.",
            pair(y, x): "x and y do not trade places: the axes are parallel."})


def _height(drone: float, seen: float, right: float, why: str) -> Number:
    """A third component."""
    return Number(
        ask=f"A drone hovers {said(drone)} m above the ground. Its camera, whose axes are "
            f"parallel to those of the room, sees a bird at c¹ = (0, 2, {said(seen)}). How high "
            "above the ground is the bird?",
        why=why, right=right, unit="m", tolerance=0.01, slips=[
            (drone - seen, "From frame 1 to the room the origin is added, not subtracted."),
            (seen, "That is what the drone sees; its own height comes on top."),
            (drone + 2, "The height is the third component; 2 is along y.")])


PREDICTIONS: dict[str, Asked] = {
    "translation.sliding": Asked(sliding_view, [
        _change("x", "to the right", ("+-0", "000"), before=-2, after=2,
                why="What o₁⁰ gains, c¹ loses, and c⁰ stays: the point has not moved."),
        _change("y", "down the page", ("000", "-+0"), before=1.5, after=-1.5,
                why="What o₁⁰ loses, c¹ gains, and c⁰ stays: the point has not moved."),
        _change("x", "to the left", ("-+0", "000"), before=2, after=-1,
                why="What o₁⁰ loses, c¹ gains, and c⁰ stays: the point has not moved.")]),
    "translation.origin": Asked(sliding_view, [
        _origin((-1, 1), (2, 1), "One step left and one up from (2, 1) is (1, 2)."),
        _origin((2, 1), (-1, 1), "Two steps right and one up from (−1, 1) is (1, 2)."),
        _origin((0, 0), (1, 2), "A point that is seen at (0, 0) is at the origin itself.")]),
    "translation.back": Asked(sliding_view, [
        _seen_back((2, -1), "The way back is the same arrow turned round: −o₁⁰ = (−2, 1)."),
        _seen_back((-2, 1.5), "The way back is the same arrow turned round: −o₁⁰ = (2, −1.5).")]),
    "translation.riding": Asked(riding_view, [
        _change("x", "to the right and takes c along", ("+0+", "000"), before=-2, after=1,
                why="The frame and the point move alike; what frame 1 sees, c¹, stays."),
        _change("y", "down the page and takes c along", ("000", "-0-"), before=1, after=-2,
                why="The frame and the point move alike; what frame 1 sees, c¹, stays.")]),
    "translation.carried": Asked(riding_view, [
        _carried((-0.5, -0.5), "c⁰ = (−0.5, −0.5) + (1, 2) = (0.5, 1.5)."),
        _carried((0.5, -1.5), "c⁰ = (0.5, −1.5) + (1, 2) = (1.5, 0.5)."),
        _carried((-1, -1), "c⁰ = (−1, −1) + (1, 2) = (0, 1).")]),
    "translation.rate": Asked(None, [Several(
        ask="Frame 1 slides by a small step along x₀ and takes three points along: a near its "
            "origin, b far away, c on its y axis. Which of them make the same step?",
        why="In a translation all points of a body move alike. In a turn they do not.",
        options={"a": "c⁰ = o₁⁰ + c¹ holds for it, and its c¹ stays.",
                 "b": "Far away or near: its c¹ stays, so c⁰ changes as o₁⁰ does.",
                 "c": "Its c¹ stays, so c⁰ changes as o₁⁰ does."}, right=["a", "b", "c"])]),
    "translation.chain": Asked(chain_view, [
        _two_slides((1.5, -1), (-0.5, 2), "(1.5, −1) + (−0.5, 2) = (1, 1)."),
        _two_slides((-0.5, -0.5), (0.5, 1.5), "(−0.5, −0.5) + (0.5, 1.5) = (0, 1)."),
        _two_slides((2, 1), (-1.5, -2), "(2, 1) + (−1.5, −2) = (0.5, −1).")]),
    "translation.order": Asked(None, [Choice(
        ask="Two slides lead to a frame: first (1.5, −1), then (1, 1.5). Carry them out in the "
            "other order. Does the frame end in the same place?",
        why="Sums are the same in any order: the two ways are the sides of one parallelogram.",
        options={"no, it ends beside it": "Draw both ways on squared paper.", "yes, always": "",
                 "yes, but only for these numbers": "a + b = b + a holds for all numbers."},
        right="yes, always")]),
    "translation.height": Asked(None, [
        _height(3, -1, 2, "3 + (−1) = 2: the bird is below the drone."),
        _height(5, 1.5, 6.5, "5 + 1.5 = 6.5: the bird is above the drone."),
        _height(2, -0.5, 1.5, "2 + (−0.5) = 1.5: the bird is below the drone.")]),
}

# ---- Exercise 1: there and back ------------------------------------------------------

_ROWS = ("c_0", "d_1", "o_10")


def _entry(index: tuple) -> str:
    return f"the {'xy'[index[1]]} of {_ROWS[index[0]]}"


def there_and_back_judge(**points: Numbers) -> Judge:
    """Judge of what frame 0 and frame 1 see: `o` is the origin of frame 1, then `c_1` and `d_0`."""
    o, c_1, d_0 = (np.asarray(points[name]) for name in ("o", "c_1", "d_0"))
    right = np.array([o + c_1, d_0 - o, -o])
    slips = [
        ("Sum and difference have changed places: c⁰ = o₁⁰ + c¹, and so c¹ = c⁰ - o₁⁰.",
         [c_1 - o, d_0 + o, -o]),
        ("From frame 1 to the room o₁⁰ is added.", [c_1 - o, d_0 - o, -o]),
        ("From the room to frame 1 o₁⁰ is subtracted.", [o + c_1, d_0 + o, -o]),
        ("The difference is the wrong way round: it is d⁰ - o₁⁰.", [o + c_1, o - d_0, -o]),
        ("The third one is where frame 1 sees the origin of frame 0, and you gave where frame 0 "
         "sees that of frame 1.", [o + c_1, d_0 - o, o]),
        ("A frame sees its own origin at (0, 0); asked is where frame 1 sees that of frame 0.",
         [o + c_1, d_0 - o, 0 * o]),
        ("x and y have changed places.", right[:, ::-1]),
    ]
    return values(right, entry=_entry, slips=slips, parts=_ROWS,
                  praise="Add on the way to the room, subtract on the way back.")


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
    ("x and y have changed places.", lambda *numbers: _camera(1, -1, 1)(*numbers)[::-1]),
]

# ---- Exercise 3: where must the frame be? ---------------------------------------------


def between_judge(**points: Numbers) -> Judge:
    """Judge of the place that sees `c` and `d` in opposite directions, equally far away."""
    c, d = np.array([points["c"], points["d"]], dtype=float)
    slips = [
        ("This is the vector from d to c. Write down c¹ = -d¹ with c¹ = c⁰ - o₁⁰.", c - d),
        ("This is the vector from c to d. Write down c¹ = -d¹ with c¹ = c⁰ - o₁⁰.", d - c),
        ("You are close: the origin stands twice in the equation.", c + d),
        ("This is half the way from d to c, counted from the room's origin. From where does it "
         "start?", (c - d) / 2),
        ("This is half the way from c to d, counted from the room's origin. From where does it "
         "start?", (d - c) / 2),
        ("From the room's origin both points are equally far, but do the two arrows point in "
         "opposite directions?", 0 * c),
    ]
    return values(
        (c + d) / 2, slips=slips, entry=lambda index: f"the {'xy'[index[0]]} of o_1",
        praise="The frame stands midway. From there the two points lie in opposite directions, "
               "equally far.")


JUDGES: dict[str, Judge] = {
    "translation.1": there_and_back_judge(o=(3, -1), c_1=(-2, 4), d_0=(1, 2)),
    "translation.2": expressions(
        ("x", "y"), _camera(1, -1, 1), _CAMERA_POINTS, constants={}, slips=_CAMERA_SLIPS,
        praise="Up into the room by the camera, down into the robot's frame by its base: "
               "p^B = o_K^0 - o_B^0 + p^K."),
    "translation.3": between_judge(c=(3, 1), d=(-1, 3)),
}
