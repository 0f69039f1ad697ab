"""The test before and after the course: twelve questions, each in two versions.

A version is a prediction of one case: "pretest.shift" before the course and "pretest.shift_again"
after it ask the same idea with other numbers. docs/teaching.md has the key.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..answers.prediction import Asked, Case, Choice, Direction, Mark, Number, Several, Signs
from ..arms.motions import ROTATE, TRANSLATE, X, Z
from ..drawing.controls import Knob
from ..drawing.sketch import Sketch
from ..views.live import LiveView
from ..views.prediction import Prediction
from .asked import angle, pair, said

# ---- Pictures --------------------------------------------------------------------------------


def turned_view() -> LiveView:
    """Frame 1 turns about the origin of frame 0 and takes the point c along, at (2, 1)."""
    return _riding((2, 1))


def turned_again_view() -> LiveView:
    """The same, with the point at (1, 2)."""
    return _riding((1, 2))


def walk_view() -> LiveView:
    """Frame 1 turns, then slides along its own x axis."""
    sketch = Sketch("A frame that turns, then slides", 3.5)
    sketch.axes("0", 0, 1.0)
    slide = sketch.knob(Knob.length("d", "d", -2.5, 2.5, 0))
    sketch.move(ROTATE, Z, 0.0, sketch.theta(1, 0))
    frame = sketch.move(TRANSLATE, X, 0.0, slide)
    sketch.axes("1", frame, 0.8)
    return LiveView(sketch.scene())


def _riding(place: tuple[float, float]) -> LiveView:
    sketch = Sketch("A frame that turns, with a point", 3.0)
    sketch.axes("0", 0, 1.4)
    frame = sketch.frame("1", theta=sketch.theta(1, 0), length=1.0)
    sketch.components("c1", sketch.point("c", frame, place), frame)
    return LiveView(sketch.scene())


# ---- Questions -------------------------------------------------------------------------------


def _shift(o: tuple[float, float], c: tuple[float, float]) -> Choice:
    (x, y), (u, v) = o, c
    return Choice(
        ask=f"Frame 1 has its origin at {pair(x, y)} in frame 0, and axes parallel to those of "
            f"frame 0. A point is at {pair(u, v)} in frame 0. Where is it in frame 1?",
        why="Subtract the origin of frame 1: its own zero is there.", right=pair(u - x, v - y),
        options={pair(u + x, v + y): "The origin is added on the way from frame 1 to frame 0.",
                 pair(x - u, y - v): "This is the way from the point back to the origin.",
                 pair(u, v): "Coordinates belong to a frame; another frame measures others.",
                 pair(u - x, v - y): ""})


def _turned(theta: float, c: tuple[float, float], right: str) -> Mark:
    x, y = c
    back = (y, -x) if theta > 0 else (-y, x)
    return Mark(
        ask=f"The point c is fixed in frame 1, at {pair(x, y)}. Frame 1 turns by "
            f"{angle(theta)} about the common origin. Where is c then?",
        why=f"c is still {said(x)} along x₁ and {said(y)} along y₁: {right}.",
        start={"theta_1": 0}, shows={"theta_1": theta}, of="point-c", tolerance=0.3, slips=[
            ((*back, 0), "This is a turn the other way round."),
            ((-x, -y, 0), "This is half a turn.")])


def _axis(rows: str, theta: float, along_row: float, column: str) -> Direction:
    return Direction(
        ask=f"R is the rotation of frame 1, seen from frame 0; its rows are {rows}. Which way does "
            "y₁ point, as frame 0 sees it?",
        why=f"The second column holds y₁: {column}.", start={"theta_1": 0},
        shows={"theta_1": theta - 90}, of="frame-1-y", tolerance=12, begin=-45,
        slips=[(along_row, "You read along the row. The axes of frame 1 are the columns."),
               (theta - 90, "This is x₁, the first column.")])


def _walk(theta: float, d: float, right: str, wrong: tuple[float, float]) -> Mark:
    return Mark(
        ask=f"Frame 1 starts on frame 0. It turns by {angle(theta)}, then it slides by "
            f"{said(d)} along its own x axis. Where is its origin then?",
        why=f"After the turn its own x axis points {right}.", start={"theta_1": 0, "d": 0},
        shows={"theta_1": theta, "d": d}, of="frame-1-x", tolerance=0.3, slips=[
            ((d, 0, 0), "You slid along x₀; its own axis has turned with it."),
            ((-wrong[0], -wrong[1], 0), "This is a turn the other way round.")])


def _factor(own: bool) -> Choice:
    own_side, room_side = "T R: R stands on the right", "R T: R stands on the left"
    right, wrong = (own_side, room_side) if own else (room_side, own_side)
    axis = "its own z axis" if own else "the z axis of the room"
    return Choice(
        ask=f"A frame stands at the pose T. Then it turns about {axis}; R is the matrix of this "
            "turn. What is its new pose?",
        why="A motion about the frame's own axes is multiplied on the right, one about those of "
            "the room on the left.", right=right, options={
            right: "", wrong: "This is the turn about "
            + ("the z axis of the room." if own else "its own z axis."),
            "either: the order does not matter": "Matrices do not commute; try T with a slide.",
            "T + R": "Motions are carried out one after the other: their matrices are "
                     "multiplied."})


def _book(first: str, second: str, arrow: str, right: str, swapped: str, why: str) -> Choice:
    options = {f"along {right}": "", f"along {swapped}": "This is the other order of the turns.",
               f"along {arrow}": "Each of the turns is by 90°; at least one of them moves it.",
               f"against {right}": "This is a turn clockwise; count by the right hand."}
    return Choice(
        ask=f"An arrow on a book points along {arrow}. The book turns by 90° about the {first} "
            f"axis of the room, then by 90° about the {second} axis of the room. Where does the "
            "arrow point?", why=why, options=options, right=f"along {right}")


def _belong(axis: str, right: tuple[str, str], why: str) -> Several:
    return Several(
        ask=f"Denavit-Hartenberg parameters, standard convention: which are measured about or "
            f"along {axis}?", why=why, right=right, options={
            "θᵢ": "θ is the angle about zᵢ₋₁, from xᵢ₋₁ to xᵢ.",
            "dᵢ": "d is the distance along zᵢ₋₁, from xᵢ₋₁ to xᵢ.",
            "aᵢ": "a is the distance along xᵢ, from zᵢ₋₁ to zᵢ.",
            "αᵢ": "α is the angle about xᵢ, from zᵢ₋₁ to zᵢ."})


def _link(drawn: str, right: str, why: str, slips: dict[str, str]) -> Choice:
    return Choice(ask=f"Two neighbouring joint axes, zᵢ₋₁ and zᵢ, {drawn}. Which length and twist "
                      "has the link between them?", why=why, right=right,
                  options=slips | {right: ""})


def _offset(sign: str, other: str, k: str) -> Choice:
    drawn, right = "90°" if sign == "+" else "−90°", f"θ = q{k} {sign} 90°"
    return Choice(
        ask=f"At q{k} = 0 the drawing shows an angle of {drawn} about z, from the "
            "old x axis to the new one. What stands in the row of this joint?",
        why=f"At q{k} = 0 the parameter must be what the drawing shows, and it grows with the "
            "joint.", right=right, options={
            f"θ = q{k}": "Then the arm of the table stands turned by 90° against the drawing.",
            f"θ = {drawn}": "Then the joint would not turn at all.",
            f"θ = q{k} {other} 90°": "The sign: put q = 0 and compare with the drawing.",
            right: ""})


def _twist(z: str, right: float, why: str) -> Number:
    return Number(
        ask=f"xᵢ points to the east, and zᵢ₋₁ points up. zᵢ points to the {z}. What is the twist "
            "αᵢ, the angle from zᵢ₋₁ to zᵢ about xᵢ?", why=why, right=right, unit="°", tolerance=1,
        turn=360, slips=[
            (-right, "The sign: the thumb of the right hand along x, then turn from the old z to "
                     "the new one."),
            (0, "The two axes are not parallel."), (180, "The two axes are not parallel.")])


def _signs(theta: float, right: tuple[str, str], why: str) -> Signs:
    return Signs(
        ask=f"Frame 1 is turned by {angle(theta)} about z. Which signs have the entries of its "
            "rotation matrix, seen from frame 0?", why=why, rows=("x₀", "y₀"),
        columns=("x₁", "y₁"), right=right, among={"+": "positive", "-": "negative", "0": "zero"})


def _misread(written: str, read: str, rows: str, right: str, why: str) -> Choice:
    return Choice(
        ask=f"A planar arm has two links of 1 m. Its table is written in the {written} convention: "
            f"{rows}. A program reads the same numbers in the {read} one. What comes out?",
        why=why, right=right, options={
            "an error": "No rule is broken: both conventions read any four numbers.",
            "the same arm": "The four motions of a row are carried out in another order.",
            "the mirror image of the arm": "No sign has changed; the order of the motions has.",
            right: ""})


_VERSIONS: dict[str, tuple[Case, Case]] = {
    "shift": (_shift((3, 1), (1, 4)), _shift((2, -1), (-1, 3))),
    "turned": (_turned(90, (2, 1), "at (−1, 2)"), _turned(-90, (1, 2), "at (2, −1)")),
    "axis": (_axis("(0.87, −0.5) and (0.5, 0.87)", 120, 60, "(−0.5, 0.87)"),
             _axis("(0.5, −0.87) and (0.87, 0.5)", 150, 30, "(−0.87, 0.5)")),
    "walk": (_walk(90, 2, "along y₀", (0, 2)), _walk(-90, 1.5, "against y₀", (0, -1.5))),
    "side": (_factor(own=True), _factor(own=False)),
    "book": (_book("z", "x", "x₀", "z₀", "y₀", "The first turn takes it from x₀ to y₀, the second "
                                               "one from there to z₀."),
             _book("x", "y", "y₀", "x₀", "z₀", "The first turn takes it from y₀ to z₀, the second "
                                               "one from there to x₀.")),
    "belong": (_belong("zᵢ₋₁", ("θᵢ", "dᵢ"), "One pair belongs to the old z, the other to the new "
                                             "x: θ and d to z."),
               _belong("xᵢ", ("aᵢ", "αᵢ"), "One pair belongs to the old z, the other to the new "
                                           "x: a and α to x.")),
    "link": (_link("are parallel, 0.4 m apart", "aᵢ = 0.4 m, αᵢ = 0",
                   "a is the distance of the axes, α the angle between them.",
                   {"aᵢ = 0.4 m, αᵢ = 90° or −90°": "Parallel axes enclose no angle.",
                    "aᵢ = 0, αᵢ = 0": "Then both would be one line; d slides along z only."}),
             _link("stand at a right angle and are 0.3 m apart", "aᵢ = 0.3 m, αᵢ = 90° or −90°",
                   "a is the distance of the axes, α the angle between them.",
                   {"aᵢ = 0.3 m, αᵢ = 0": "That is for parallel axes.",
                    "aᵢ = 0, αᵢ = 90° or −90°": "That is for axes that meet."})),
    "offset": (_offset("+", "−", "₂"), _offset("−", "+", "₃")),
    "twist": (_twist("north", -90, "About the thumb along east, up turns to the south; north is "
                                   "the other way."),
              _twist("south", 90, "About the thumb along east, up turns to the south.")),
    "signs": (_signs(30, ("+-", "++"), "The columns are x₁ = (0.87, 0.5) and y₁ = (−0.5, 0.87)."),
              _signs(120, ("--", "+-"), "The columns are x₁ = (−0.5, 0.87) and "
                                        "y₁ = (−0.87, −0.5).")),
    "misread": (
        _misread("modified", "standard", "rows (α, a, d, θ) = (0, 0, 0, θ₁) and (0, 1 m, 0, θ₂), "
                 "and a tool 1 m further on",
                 "both joints turn about the same axis, at the base",
                 "In the standard convention a slides after the turn of its row, so nothing stands "
                 "between the two turns."),
        _misread("standard", "modified", "rows (θ, d, a, α) = (θ₁, 0, 1 m, 0) and (θ₂, 0, 1 m, 0)",
                 "the first joint stands 1 m beside the base, and the last link is missing",
                 "In the modified convention a slides before the turn of its row.")),
}
_VIEWS = {"turned": (turned_view, turned_again_view), "axis": (walk_view, walk_view),
          "walk": (walk_view, walk_view)}
IDEAS = {
    "frames (lessons 01 to 03)": ("shift", "turned", "axis"),
    "order of motions (lessons 02, 03)": ("walk", "side", "book"),
    "DH parameters (lesson 05)": ("belong", "link", "offset"),
    "signs (lessons 02, 05)": ("twist", "signs"),
    "the other convention (lessons 05, 06)": ("misread",),
}



def _in_order(case: Case) -> Case:
    """The same, a choice with its texts by the alphabet: it does not tell the right one."""
    if not isinstance(case, Choice):
        return case
    return replace(case, options=dict(sorted(case.options.items())))


PREDICTIONS: dict[str, Asked] = {
    f"pretest.{word}{version}": Asked(_VIEWS.get(word, (None, None))[k], [_in_order(cases[k])])
    for k, version in enumerate(("", "_again")) for word, cases in _VERSIONS.items()}


class Result:
    """How a test went: all in all, and idea by idea."""

    def __init__(self, predictions: Sequence[Prediction]) -> None:
        self.told = {one.name.removeprefix("pretest.").removesuffix("_again"): one.told
                     for one in predictions}

    @property
    def right(self) -> int:
        """The number of right answers."""
        return self._right(self.told)

    def __repr__(self) -> str:
        still = sum(told is None for told in self.told.values())
        if still:
            return f"{still} of {len(self.told)} questions are still open."
        ideas = [f"  {self._right(words)} of {len(words)}  {idea}" for idea, words in IDEAS.items()]
        return "\n".join([f"{self.right} of {len(self.told)} right", *ideas])

    def _right(self, words: Sequence[str] | dict) -> int:
        return sum(bool(told and told.ok) for told in map(self.told.get, words))


def result(*predictions: Prediction) -> Result:
    """How the test went, once all its questions have been answered."""
    return Result(predictions)
