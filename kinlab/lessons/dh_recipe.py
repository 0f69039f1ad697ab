"""Lesson 05, the DH recipe: its views, what it asks before they move, and its judges."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial, reduce
from itertools import product
from math import degrees, pi, radians
from typing import Any

import numpy as np

from ..answers.given import is_stub, length, unfinished, untouched
from ..answers.judges import Judge, choices, evaluated, expressions, first_of, values
from ..answers.matrices import link_matrix, matrix_place
from ..answers.placed_frames import examine_frames, first_fault
from ..answers.prediction import Asked, Choice, Direction, Mark, Several, Signs
from ..answers.table_judge import examined, with_columns
from ..answers.verdict import BLANK, CORRECT, NOT_YET, Fault, Verdict
from ..answers.words import counted, listed, to_do
from ..arms import robots
from ..arms.arm import Arm
from ..arms.kinematics import forward_kinematics, link_frames
from ..arms.link import prismatic, revolute
from ..arms.motions import ROTATE, TRANSLATE, X, Z
from ..drawing.controls import Knob, PoseTable
from ..drawing.scene import at, origin_of
from ..drawing.sketch import Sketch
from ..views.arm_view import ArmView
from ..views.link_view import link_view
from ..views.live import LiveView
from ..views.studies import parameters_view
from .asked import angle
from .views.dh_recipe import rules_view

__all__ = ["JUDGES", "PREDICTIONS", "numbers_view", "parameters_view",
           "printed_matrix", "rules_view"]


def numbers_view() -> LiveView:
    """Frame 1 where the four numbers say, with a slider for each of them."""
    sketch = Sketch("Four numbers, one frame", 1.6, center=(0, 0, 0.25), planar=False,
                    grid=0.5)
    sketch.follows = True
    theta = sketch.knob(Knob.angle("theta", "θ", home=radians(40)))
    d = sketch.knob(Knob.length("d", "d", -1.0, 1.0, 0.6))
    a = sketch.knob(Knob.length("a", "a", -1.0, 1.0, 0.9))
    alpha = sketch.knob(Knob.angle("alpha", "α", home=radians(30)))
    sketch.line("z-line", at(0, (0, 0, -0.4), (0, 0, 1.2)))
    turned = sketch.move(ROTATE, Z, 0, theta)
    lifted = sketch.move(TRANSLATE, Z, 0, d)
    out = sketch.move(TRANSLATE, X, 0, a)
    frame = sketch.tip = sketch.move(ROTATE, X, 0, alpha)
    _length(sketch, "d", turned, lifted, sketch.move(TRANSLATE, Z, 0, d, turned, gain=0.5))
    _length(sketch, "a", lifted, out, sketch.move(TRANSLATE, X, 0, a, lifted, gain=0.5))
    sketch.sweep("arc-theta", turned, (0.4, 0, 0), text="θ")
    sketch.sweep("arc-alpha", frame, (0, 0, 0.4), text="α")
    sketch.axes("0", 0, 0.5)
    sketch.axes("1", frame, 0.5)
    sketch.pose = PoseTable.of_frame("A₁, frame 1 seen from frame 0", "1", "xyz")
    return LiveView(sketch.scene())


def _length(sketch: Sketch, name: str, tail: int, head: int, middle: int) -> None:
    """An arrow from origin to origin, with its name at the middle."""
    sketch.arrow(name, origin_of(tail), origin_of(head), "length")
    sketch.label(name, at(middle, (0, 0, 0), (0, 0.3, 0)), "length")


def printed_matrix(theta: Any, d: Any, a: Any, alpha: Any) -> Any:
    """Equation (3.10) of the lecture, typed from its page."""
    import sympy as sp  # takes a while

    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
    return sp.Matrix([[c, -s * ca, s * sa, a * c],
                      [s, c * ca, -c * sa, a * s],
                      [0, sa, ca, d],
                      [0, 0, 0, 1]])


# ---- Predictions ------------------------------------------------------------------------


def _exam_link() -> LiveView:
    return parameters_view(robots.exam_2018(), 2, [radians(-20), radians(-35), 0.4])


def _exam_stages() -> LiveView:
    return link_view(robots.exam_2018(), 2, [0, 0, 0.4])


def _alpha_ii() -> ArmView:
    return ArmView(robots.alpha_ii(), np.radians([0, -40, 60, -90, 0]), show=("frames", "labels"))


def _twist(alpha: float, theta: float, about: str, why: str, slip: tuple[float, str]) -> Direction:
    """Which way z₁ points once α has grown from zero."""
    ahead = "y₀" if theta else "x₀"
    return Direction(
        ask=f"α is 0, and x₁ points along {ahead}. z₁ points up. Now α goes to {angle(alpha)}. "
            "Turn the arrow to where z₁ will point.",
        why=why, of="frame-1-z", about=about, begin={"x": 90, "y": 0}[about], slips=[slip],
        start=dict(theta=theta, alpha=0), shows=dict(alpha=alpha))


_RIGHT_HAND = "Right thumb along x₁: the fingers show which way z turns."
_TWISTS = [
    _twist(90, 0, "x", "About x the turn goes from y to z, so z goes on to −y₀: sin α is in column "
           "3 with a minus.", (0, _RIGHT_HAND)),
    _twist(-90, 0, "x", "A negative α turns the other way, against the fingers of the right hand: "
           "z₁ points along y₀.", (180, _RIGHT_HAND)),
    _twist(90, 90, "y", "x₁ points along y₀ now, and α turns about x₁: z₁ falls to x₀.",
           (-90, _RIGHT_HAND)),
]

_FOUR = {"θ₂": "θ₂ is the angle from x₁ to x₂ about z₁.",
         "d₂": "d₂ is the step along z₁. Joint 2 turns, so it is fixed in the link.",
         "a₂": "a₂ is the length of the link, and links are stiff.",
         "α₂": "α₂ is the angle between the two joint axes of one stiff link.",
         "none of them": "Look at joint 2 itself: one of its numbers is the joint."}


def _which(joint: str, right: str, why: str, **shows: float) -> Choice:
    """Which number of link 2 changes with a joint."""
    return Choice(ask=f"You will drag {joint}. Which of the four numbers of link 2 changes?",
                  why=why, options=_FOUR | {right: ""}, right=right, shows=shows)


_WHICH = [
    _which("θ₂", "θ₂", "Joint 2 turns about z₁, and θ₂ is measured about z₁.", theta_2=20),
    _which("θ₁", "none of them", "Joint 1 carries the whole link about; its numbers belong to the "
           "link.", theta_1=40),
    _which("d₃", "none of them", "d₃ is a number of link 3: it stands in row 3.", d_3=0.7),
]


def _x_2(theta: float, why: str) -> Direction:
    return Direction(
        ask=f"θ₂* = {angle(theta)}, and z₁ points at you. You see the axes z₁ and z₂ of one link. "
            "Turn the arrow to where x₂ will point.",
        why=why, of="frame-2-x", about="y", begin=90, seen="front",
        slips=[(180 - theta, "Along the common normal, but the other way: x₂ leads from z₁ to z₂."),
               (90 - theta, "There z₂ points. x₂ is perpendicular to z₁ and to z₂.")],
        start=dict(theta_1=0, theta_2=theta, stage=0), shows=dict(stage=2))


_NORMAL = "x₂ lies along the common normal, from z₁ to z₂:"
_X_2 = [_x_2(40, f"{_NORMAL} up, and to the left by 40°."),
        _x_2(-60, f"{_NORMAL} up, and to the right by 60°."),
        _x_2(110, f"{_NORMAL} to the left, and down by 20°.")]


def _zeros(link: int, said: dict[str, str], right: tuple[str, ...], why: str, **shows: float,
           ) -> Several:
    """Which numbers of a link of the Alpha II are zero in every pose."""
    return Several(
        ask=f"Look at frames {link - 1} and {link}. Which of the four numbers of link {link} are "
            "zero in every pose?",
        why=why, options=said, right=right, shows=shows)


_ZEROS = [
    _zeros(2, {"θ₂": "It is the joint's own angle, and the joint turns.",
               "d₂": "The line of x₂ leaves z₁ in O₁ itself.",
               "a₂": "O₂ is 177.8 mm from z₁: that is the upper arm.",
               "α₂": "Shoulder and elbow turn about parallel axes."},
           ("d₂", "α₂"), "z₁ and z₂ are parallel, and x₂ was put through O₁.", theta_2=20),
    _zeros(4, {"θ₄": "It is the joint's own angle, and the joint turns.",
               "d₄": "O₃ and O₄ are one point.", "a₄": "O₃ and O₄ are one point.",
               "α₄": "z₃ and z₄ are 90° apart."},
           ("d₄", "a₄"), "O₃ and O₄ are one point, so both lengths are zero.", theta_4=-30),
    _zeros(5, {"θ₅": "It is the joint's own angle, and the joint turns.",
               "d₅": "O₅ is 129.5 mm along z₄: that is the tool.",
               "a₅": "O₅ lies on z₄.", "α₅": "z₄ and z₅ point the same way."},
           ("a₅", "α₅"), "z₄ and z₅ are one line, and O₅ is 129.5 mm along it.", theta_5=60),
]

_PARALLEL, _MEET, _NOTHING = ("They are parallel.", "They meet, or are one line.",
                              "Nothing: it says how the frames were put.")


def _says(ask: str, right: str, why: str, **said: str) -> Choice:
    options = dict(zip((_PARALLEL, _MEET, _NOTHING), (
        said.get(word, "") for word in ("parallel", "meet", "nothing"))))
    return Choice(ask=ask, why=why, options=options, right=right)


_SAYS = [
    _says("In some row αᵢ = 0. What does that say about the axes zᵢ₋₁ and zᵢ?", _PARALLEL,
          "αᵢ is the angle between the two axes.", meet="Whether they meet is a matter of aᵢ.",
          nothing="αᵢ is the angle between the two axes: it is not free."),
    _says("In some row dᵢ = 0. What does that say about the axes zᵢ₋₁ and zᵢ?", _NOTHING,
          "dᵢ is the step along zᵢ₋₁ from Oᵢ₋₁ to xᵢ: it depends on where Oᵢ₋₁ was put.",
          parallel="Between parallel axes x may be put so that d = 0; but d = 0 with any twist is "
                   "possible, too.",
          meet="How far apart the axes are is aᵢ, not dᵢ."),
    _says("In some row aᵢ = 0. What does that say about the axes zᵢ₋₁ and zᵢ?", _MEET,
          "aᵢ is the length of the common normal, the shortest way from one axis to the other.",
          parallel="The angle between them is αᵢ, not aᵢ.",
          nothing="aᵢ is the distance of two lines. Frames cannot change it."),
]


def _broken(ask: str, right: str, why: str, options: dict[str, str], tilt: float, miss: float,
            ) -> Choice:
    return Choice(ask=ask, why=why, options=options, right=right, shows=dict(tilt=tilt, miss=miss))


_WHICH_RULE = {"none": "One of the two is still wrong in this frame.",
               "only rule 1": "Rule 1 asks for a right angle between x₁ and z₀.",
               "only rule 2": "Rule 2 asks that the line of x₁ meets z₀.",
               "both": "The rules are independent: one can hold without the other."}
_BROKEN = [
    _broken("Frame 1 breaks both rules. In the matrix of frame 1, seen from frame 0, which entry "
            "shows that rule 1 is broken?", "row 3, column 1",
            "Row 3, column 1 is x₁ · z₀. Rule 1 asks that it is 0.",
            {"row 1, column 3": "Column 3 is z₁. Rule 1 speaks of x₁.", "row 3, column 1": "",
             "row 3, column 3": "That is z₁ · z₀, the cosine of the twist. It may be anything.",
             "row 3, column 4": "That is the height of O₁. It may be anything."}, 40, 1),
    _broken("The tilt goes to 0, and the miss to 0.5. Which rule does frame 1 break then?",
            "only rule 2", "x₁ is level, but its line passes z₀ at a distance of 0.5.",
            _WHICH_RULE, 0, 0.5),
    _broken("The tilt stays at 25°, and the miss goes to 0. Which rule does frame 1 break then?",
            "only rule 1", "The line of x₁ meets z₀, but not at a right angle.",
            _WHICH_RULE, 25, 0),
]


def _origin(done: int, ask: str, why: str, slip: tuple[tuple[float, float, float], str]) -> Mark:
    """Where the travelling frame's origin is; θ₁ and θ₂* are 0, seen along x₀."""
    return Mark(ask=f"{ask} Set the mark where the travelling frame's origin is then.", why=why,
                of="frame--x", axes="yz", tolerance=0.07, begin=(0, -0.35, 0.75), seen="side",
                slips=[slip],
                start=dict(theta_1=0, theta_2=0, stage=2), shows=dict(stage=2 + done))


_ORIGINS = [
    _origin(2, "Two motions are done: the turn by θ₂, and the slide by d₂ = 0.2 m.",
            "A turn moves no origin. The slide goes along z₁, and z₁ points along −y₀.",
            ((0, 0.2, 0.5), "z₁ points along −y₀, and d₂ is positive.")),
    _origin(1, "One motion is done: the turn by θ₂.",
            "The frame turns about its own z, and its origin lies on that axis.",
            ((0, 0, 0.9), "That is a slide along the new x. It comes later.")),
    _origin(3, "Three motions are done: the turn by θ₂, the slides by d₂ = 0.2 m and a₂ = 0.4 m.",
            "First 0.2 m along z₁, then 0.4 m along x, which points up now: that is O₂.",
            ((0, -0.2, 0.5), "The slide by a₂ along x is done as well.")),
]

_SWAPS = [Several(
    ask="Four motions: turn by θ and slide by d along z, slide by a along x and turn by α about "
        "x. Which may change places, with the same result in the end?",
    why="A turn and a slide along one axis are like the two motions of a screw: their order is "
        "free. Slides without a turn may change places, too.",
    options={"the turn by θ and the slide by d": "Both have the same axis, z.",
             "the slide by a and the turn by α": "Both have the same axis, x.",
             "the slide by d and the slide by a":
                 "Slides alone may be swapped: as neighbours, between the two turns.",
             "the pair of z and the pair of x":
                 "Turn a quarter, then go one step ahead. The other way round you end elsewhere."},
    right=("the turn by θ and the slide by d", "the slide by a and the turn by α",
           "the slide by d and the slide by a"))]


def _column(ask: str, why: str, axes: str, slips: list, start: dict, **shows: float) -> Mark:
    return Mark(ask=f"{ask} Set the mark where O₁ will be.", why=why, of="frame-1-x", axes=axes,
                tolerance=0.15, begin=(0.3, 0.3, 1.1), slips=slips,
                seen={"xz": "front", "yz": "side"}[axes],
                start=dict(alpha=0) | start, shows=shows)


_LAST_COLUMN = [
    _column("a = 1 along x₀, and d = 0. Now θ goes to 90° and d to 0.5.",
            "(1, 0, 0), turned by 90°, is (0, 1, 0); lifted by 0.5 it is (0, 1, 0.5).", "yz",
            [((0, 0.5, 1), "d lifts along z₀, a goes along x₁."),
             ((0, -1, 0.5), "About z the turn goes from x₀ to y₀.")],
            dict(theta=0, d=0, a=1), theta=90, d=0.5),
    _column("θ = 0, d = 0.5, a = 1. Now α goes to 90°.",
            "The turn by α comes last, about x₁. It moves no origin: no α in column 4.", "xz",
            [((1, 0, 1), "α turns frame 1 about its own x axis, and O₁ is on that axis."),
             ((1, 0, -0.5), "α turns frame 1 about its own x axis, and O₁ is on that axis.")],
            dict(theta=0, d=0.5, a=1), alpha=90),
    _column("θ = 180°, d = 0.5, a = 0.8. Now a goes to −0.8.",
            "x₁ points along −x₀. A negative a goes against x₁: O₁ is at (0.8, 0, 0.5).", "xz",
            [((-0.8, 0, 0.5), "a is negative: against x₁.")],
            dict(theta=180, d=0.5, a=0.8), a=-0.8),
]

_ZERO_OR_NOT = {"·": "need not be zero", "0": "is zero for every θ and d"}


def _pattern(ask: str, why: str, right: Sequence[str], **start: float) -> Signs:
    return Signs(ask=ask, why=why, rows=("x", "y", "z"), columns=("x₁", "y₁", "z₁", "o₁"),
                 right=right, among=_ZERO_OR_NOT, shows=start)


_PATTERN = [
    _pattern("Which entries of A₁ are zero whatever the four numbers are?",
             "Only x₁ · z₀: rule 1. The rest depends on the four numbers.",
             ("····", "····", "0···")),
    _pattern("α₁ = 0. Which entries of A₁ are zero for every θ, d and a?",
             "sin α = 0: z₁ stays along z₀, and x₁ and y₁ stay level.",
             ("··0·", "··0·", "00··"), alpha=0),
    _pattern("α₁ = 90° and a = 0. Which entries of A₁ are zero for every θ and d?",
             "cos α = 0: y₁ points along z₀, z₁ is level. With a = 0, O₁ is on z₀.",
             ("·0·0", "·0·0", "0·0·"), alpha=90, a=0),
]

PREDICTIONS: dict[str, Asked] = {
    "dh_recipe.twist": Asked(numbers_view, _TWISTS),
    "dh_recipe.which": Asked(_exam_link, _WHICH),
    "dh_recipe.x2": Asked(_exam_stages, _X_2),
    "dh_recipe.zeros": Asked(_alpha_ii, _ZEROS),
    "dh_recipe.says": Asked(None, _SAYS),
    "dh_recipe.broken": Asked(rules_view, _BROKEN),
    "dh_recipe.origin": Asked(_exam_stages, _ORIGINS),
    "dh_recipe.swaps": Asked(None, _SWAPS),
    "dh_recipe.column": Asked(numbers_view, _LAST_COLUMN),
    "dh_recipe.pattern": Asked(numbers_view, _PATTERN),
}


# ---- Exercise 1: which transforms keep the rules --------------------------------------

_KEPT = {"rule 1": {1, 3, 4, 5}, "rule 2": {1, 2, 4}, "links": {1, 4}}
_BOTH = "A link keeps both rules, and a transform that keeps both is a link."
_RULE_HINTS = {
    ("rule 1", 2): "Where does Ry(90°) take the x axis?",
    ("rule 1", 3): "A slide turns no axis.",
    ("rule 1", 4): "Rz turns x, but only in the plane perpendicular to z.",
    ("rule 1", 5): "Rx(90°) leaves the x axis where it is.",
    ("rule 1", 6): "Ry tilts the x axis out of the plane perpendicular to z.",
    ("rule 2", 2): "The two lines share the origin: they meet, even if not at a right angle.",
    ("rule 2", 3): "The line through (0, 1, 0) along x0: how near does it come to z0?",
    ("rule 2", 4): "x1 points along y0 and starts at (0, 1, 0): follow the line backwards.",
    ("rule 2", 5): "Tz slides along the z axis after the turn, which is -y0: x1 is carried off.",
    ("rule 2", 6): "The slide by 1 along the new y carries x1 off sideways.",
    **{("links", k): _BOTH for k in range(1, 7)},
}

# ---- Exercises 2 to 5 and 7: the 2018 exam arm ----------------------------------------

_EXAM = robots.exam_2018()
_LENGTHS = dict(d_1=0.5, L_off=0.2, a_2=0.4)
_D1, _L, _A2 = _LENGTHS.values()
_JOINTS = ("theta_1", "theta_2", "d_3")
_POINTS = [dict(zip(_JOINTS, q)) for q in ((0.3, 0.7, 0.45), (-1.2, 0.4, 0.6), (2.0, -0.9, 0.25))]
Rows = np.ndarray


def _rows(q1: float, q2: float, q3: float) -> Rows:
    """The table: a row (theta, d, a, alpha) for each link."""
    return np.array([[q1, _D1, 0, pi / 2], [q2 + pi / 2, _L, _A2, pi / 2], [pi / 2, q3, 0, 0]])


def _changed(change: Callable[[Rows], Any], *q: float) -> Rows:
    rows = _rows(*q)
    change(rows)
    return rows


def _without_offset(rows: Rows) -> None:
    rows[1, 0] -= pi / 2


def _offset_back(rows: Rows) -> None:
    rows[1, 0] -= pi


def _in_degrees(rows: Rows) -> None:
    rows[1, 0] += 90 - pi / 2
    rows[2, 0] = 90
    rows[:2, 3] = 90


def _twisted_back(rows: Rows) -> None:
    rows[:, 3] *= -1


def _lengths_swapped(rows: Rows) -> None:
    rows[:, [1, 2]] = rows[:, [2, 1]]


def _moved_down(rows: Rows) -> None:
    rows[:, 2:] = np.vstack([[0, 0], rows[:-1, 2:]])


_OFFSET = ("The offset of joint 2 is missing: when theta_2* is 0, x2 already stands 90° away from "
           "x1.", _without_offset)
_TURNED_OFFSET = ("The offset of joint 2 has the wrong sign: when theta_2* is 0, x2 stands at +90° "
                  "from x1.", _offset_back)
_TWIST = ("The sign of alpha is wrong: turn z_{i-1} to z_i about x_i by the right-hand rule.",
          _twisted_back)
_DEGREES = ("Angles are in radians: write sp.pi/2 for 90°.", _in_degrees)
_SWAPPED = ("d and a have changed places: d is measured along z, a along x.", _lengths_swapped)
_MOVED = ("a and alpha stand one row too low: that is the modified (Craig) table. In the standard "
          "one row i holds a_i and alpha_i.", _moved_down)

# ---- Exercise 2: the table --------------------------------------------------------------

_COLUMNS = ("theta", "d", "a", "alpha")
_CELLS = [f"{name} of row {i}" for i in (1, 2, 3) for name in _COLUMNS]


def _table(numbers: list[list[float]]) -> Verdict:
    """What there is to say of a table, known with all joints at zero and at the points."""
    if gaps := [name for name, number in zip(_CELLS, numbers[0]) if np.isnan(number)]:
        return _begun(numbers, gaps)
    tables = np.reshape(numbers, (-1, 3, 4))
    moved = tables[1:] - tables[0]
    places = [np.flatnonzero(np.abs(moved[:, i]).max(axis=0) > 1e-9).tolist() for i in range(3)]
    if misplaced := _misplaced(moved, places):
        return misplaced
    if np.abs(tables[0][:, [0, 3]]).max() > 3 * pi:
        return Verdict(NOT_YET, _DEGREES[0])
    arm = _arm_of(tables[0], [(revolute, prismatic)[place] for place, in places])
    backwards = [moved[0, i, place] * q < 0 for i, ((place,), q) in enumerate(
        zip(places, _POINTS[0].values()))]
    arm = replace(arm, links=tuple(replace(link, flip=bool(flip))
                                   for link, flip in zip(arm.links, backwards)))
    slips = [(message, _arm_of(_changed(change, 0, 0, 0)))
             for message, change in (_SWAPPED, _MOVED)]
    verdict = examined(arm, _EXAM, ends=True, slips=slips,
                       praise="Twelve numbers, three of them variables.")
    if not verdict.ok or stands_as(arm, _EXAM):
        return verdict
    hints = first_of((_OFFSET, _TURNED_OFFSET, _TWIST), partial(_made, tables[0]))
    said, fault = _other_zero(arm)
    return Verdict(NOT_YET, " ".join(["The mechanism is right, but where theta_2* = 0 and d_3* = 0 "
                                      "it does not stand as in the view.", *hints, *said]), fault)


def _made(rows: Rows, change: Callable[[Rows], Any]) -> bool:
    """Whether the student's own cells show a slip: they are the view's but for that change."""
    wrong = _changed(change, 0, 0, 0)
    angles = np.exp(1j * rows[:, [0, 3]]), np.exp(1j * wrong[:, [0, 3]])
    return np.allclose(*angles) and np.allclose(rows[:, 1:3], wrong[:, 1:3])


def _begun(numbers: list[list[float]], gaps: list[str]) -> Verdict:
    """What there is to say of a table with cells that are still to do.

    It is judged as a whole, for its frames may be chosen; only the view's own can be told before.
    """
    rights = [_rows(*point.values()).ravel() for point in (dict.fromkeys(_JOINTS, 0.0), *_POINTS)]
    there = ~np.isnan(numbers[0])
    as_seen = np.allclose(np.array(numbers)[:, there], np.array(rights)[:, there])
    start = "What is there is right, for the frames of the view; " if as_seen else ""
    more = "" if as_seen else " A table is judged as a whole, since its frames may be chosen."
    return Verdict(NOT_YET, f"{start}{to_do(gaps)}.{more}")


def _other_zero(arm: Arm) -> tuple[list[str], Fault | None]:
    """Which constant beside a joint variable makes the arm stand as in the view, in any frames."""
    for i, name in ((1, "d"), (1, "a"), (2, "a")):
        column = [getattr(link, name) for link in arm.links]
        if column[i] and stands_as(with_columns(arm, **{name: np.where(
                np.arange(3) == i, -np.array(column), column)}), _EXAM):
            return [f"Row {i + 1}: the sign of {name} is wrong."], Fault(i + 1, name, column[i],
                                                                         -column[i])
    turn, slide = arm.links[1].theta, arm.links[2].d
    quarters = [k * pi / 2 for k in (1, -1, 0, 2)]
    for theta, d in [(turn, 0.0), *product(quarters, (slide, 0.0))]:
        rows = with_columns(arm, theta=[arm.links[0].theta, theta, arm.links[2].theta],
                            d=[arm.links[0].d, arm.links[1].d, d])
        if stands_as(rows, _EXAM):
            here = Fault(3, "d", slide, d) if theta == turn else Fault(2, "theta", turn, theta)
            was, should = ((f"{degrees(value):.6g}°" for value in (turn, theta)) if here.row == 2
                           else (f"{value:.6g}" for value in (slide, d)))
            return [f"Row {here.row}: the constant in {here.column} is {was}; it should be "
                    f"{should}."], here
    return [], None


def _misplaced(moved: np.ndarray, places: list[list[int]]) -> Verdict | None:
    """The first row whose joint variable does not stand by itself in theta or d."""
    for i, (joint, place) in enumerate(zip(_JOINTS, places)):
        q = [point[joint] for point in _POINTS]
        if place not in ([0], [1]) or not np.allclose(np.abs(moved[:, i, place[0]]), np.abs(q)):
            hint = f" {_SWAPPED[0]}" * (place == [2])
            return Verdict(NOT_YET, f"Row {i + 1}: its joint variable is {joint}. It stands in "
                           "theta or in d, alone or with a constant added, and in no other "
                           f"place.{hint}", Fault(i + 1))
    return None


def _arm_of(rows: Rows, kinds: Sequence[Callable] = (revolute, revolute, prismatic)) -> Arm:
    return Arm([make(**dict(zip(_COLUMNS, row))) for make, row in zip(kinds, rows)])


def stands_as(answer: Arm, reference: Arm) -> bool:
    """Whether a turn about the floor's origin carries all tips to where they should be.

    That depends on the zeros of theta_2 and d_3 and on which way the slide leads, but neither on
    frames nor on signs of the joints that turn.
    """
    poses = np.random.default_rng(0).uniform(-2, 2, (9, 3))
    wanted = forward_kinematics(reference, poses)[:, :3, 3]
    return any(_turned(forward_kinematics(answer, poses * signs)[:, :3, 3], wanted)
               for signs in product((1, -1), (1, -1), (1,)))


def _turned(points: np.ndarray, wanted: np.ndarray) -> bool:
    """Whether a rotation carries points to other ones; a mirror image is none."""
    U, _, V = np.linalg.svd(points.T @ wanted)
    R = U @ np.diag([1, 1, np.linalg.det(U @ V)]) @ V
    return np.allclose(points @ R, wanted)


# ---- Exercises 3 to 5: the matrices of the view's frames --------------------------------


def _product(links: slice, rows: Rows, convention: str = "standard") -> np.ndarray:
    """The transform over a stretch of links, its entries row by row."""
    return reduce(np.matmul, [link_matrix(theta, d, a, alpha, convention)
                              for theta, d, a, alpha in rows[links]]).ravel()


def _matrix_judge(links: slice, praise: str, slips: Sequence = ()) -> Judge:
    """Judge of the sixteen entries of a product of link matrices."""
    def right(*q: float) -> np.ndarray:
        return _product(links, _rows(*q))

    known = [
        *slips,
        ("This is the transpose: the axes of the new frame are columns.",
         lambda *q: right(*q).reshape(4, 4).T.ravel()),
        ("This is the inverse: it takes coordinates the other way.",
         lambda *q: np.linalg.inv(right(*q).reshape(4, 4)).ravel()),
        ("This is the modified (Craig) order, Rx Tx Rz Tz; the lecture's is Rz Tz Tx Rx.",
         lambda *q: _product(links, _rows(*q), "modified")),
        *((message, lambda *q, change=change: _product(links, _changed(change, *q)))
          for message, change in (_DEGREES, _OFFSET, _TURNED_OFFSET, _TWIST, _SWAPPED)),
    ]
    return expressions(_ENTRIES, right, _POINTS, constants=_LENGTHS, slips=known, praise=praise)


_ENTRIES = [matrix_place(index) for index in np.ndindex(4, 4)]
_REVERSED = [("The factors stand in the wrong order: H_2^0 is A_1 times A_2.",
              lambda *q: _product(slice(1, None, -1), _rows(*q)))]

# ---- Exercise 6: parameters from a matrix ---------------------------------------------


def lost_row_judge(theta: float, d: float, a: float, alpha: float) -> Judge:
    """Judge of a row, angles in degrees here, with theta beyond 90° and a below 0."""
    row = np.array([radians(theta), d, a, radians(alpha)])
    slips = [
        ("The angles are in degrees; give radians.", [theta, d, a, alpha]),
        ("a is a signed length: O_i lies against x_i here.", row * [1, 1, -1, 1]),
        ("A tangent leaves two quadrants open: np.arctan2 takes sine and cosine.",
         row - [pi, 0, 0, 0]),
        ("theta would fit the origin, but not the x axis: column 1 is (cos theta, sin theta, 0).",
         row * [1, 1, -1, 1] - [pi, 0, 0, 0]),
        ("The sign of alpha is wrong: sin alpha stands in row 3, column 2.", row * [1, 1, 1, -1]),
        ("d and a have changed places.", row[[0, 2, 1, 3]]),
    ]
    return values(row, entry=lambda index: _COLUMNS[index[0]], slips=slips,
                  angles=[True, False, False, True],
                  praise="Four numbers out, and the four motions lead back to the same matrix.")


# ---- Exercise 7: frames of one's own ----------------------------------------------------


def _frames(answer: Any) -> Verdict:
    if untouched(answer):
        return Verdict(BLANK, "Replace every ... by three numbers.")
    try:
        if missing := _still_to_place(answer):
            return _placed_so_far(answer, missing)
        placement = examine_frames(answer, _EXAM)
    except ValueError as error:
        return Verdict(NOT_YET, f"{error}.")
    if placement.arm is None:
        return placement
    view, own = link_frames(_EXAM, _EXAM.home), link_frames(placement.arm, placement.arm.home)
    away = np.linalg.norm(own[3, :3, 3] - view[3, :3, 3])
    if away > 1e-3:
        return Verdict(NOT_YET, f"All frames keep the rules, but O_3 is {away:.4g} m away from the "
                                "tip, which is at (0.4, -0.2, 0.9). The last frame belongs there.")
    turned = [i for i in range(3) if view[i, :3, 2] @ own[i, :3, 2] < 0]
    if not turned:
        return Verdict(NOT_YET, "All frames keep the rules, but every z points as in the view: "
                                "turn z0, z1 or z2 round, and see which x axes may stay.")
    return Verdict(CORRECT, " ".join([placement.message, *(
        f"z{i} points the other way, so joint {i + 1} counts backwards." for i in turned)]))


def _placed_so_far(answer: Any, missing: Sequence[str]) -> Verdict:
    """What there is to say of the frames before the first that is still to do."""
    done = answer[:int(missing[0][1:])]
    fault = first_fault(done, _EXAM) if done else ""
    names = [f"frame {i}" for i in range(len(done))]
    praise = [f"{counted(len(done), 'frame').capitalize()} placed well so far: {listed(names)}."]
    return Verdict(NOT_YET, " ".join([*([fault] if fault else praise * bool(done)),
                                      f"Still to do: {listed(missing)}."]))


def _still_to_place(answer: Any) -> list[str]:
    """Names of the axes and origins that are stubs, where the answer has four frames."""
    if length(answer) != 4 or not all(is_stub(frame) or length(frame) == 3 for frame in answer):
        return []
    return [f"{name}{i}" for i, frame in enumerate(answer)
            for name, part in zip("zxO", [frame] * 3 if is_stub(frame) else frame)
            if unfinished(part)]


JUDGES: dict[str, Judge] = {
    "dh_recipe.1": choices(
        _KEPT, {1, 2, 3, 4, 5, 6}, _RULE_HINTS, noun="transform",
        praise="Each rule takes away one freedom; 4 shows that turning x can repair a miss."),
    "dh_recipe.2": evaluated(
        _CELLS, [dict.fromkeys(_JOINTS, 0.0), *_POINTS], _LENGTHS, _table),
    "dh_recipe.3": _matrix_judge(slice(0, 1), "A_1 turns the column and lifts it by d_1."),
    "dh_recipe.4": _matrix_judge(slice(1, 2), "The offset has turned cosines into sines."),
    "dh_recipe.5": _matrix_judge(
        slice(0, 2), "Column 4 is the elbow, column 3 the direction in which joint 3 will slide.",
        _REVERSED),
    "dh_recipe.6": lost_row_judge(150, 0.3, -0.5, -60),
    "dh_recipe.7": _frames,
}
