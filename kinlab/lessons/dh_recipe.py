"""Lesson 05, the DH recipe: a view of its two rules, and the judges of its exercises."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from itertools import product
from math import degrees, pi, radians
from typing import Any

import numpy as np

from ..answers.judges import Judge, choices, evaluated, expressions, first_of, is_stub, values
from ..answers.matrices import link_matrix, matrix_place
from ..answers.placed_frames import examine_frames
from ..answers.table_judge import examined, with_columns
from ..answers.verdict import BLANK, CORRECT, NOT_YET, Fault, Verdict
from ..arms import robots
from ..arms.arm import Arm
from ..arms.kinematics import forward_kinematics, link_frames
from ..arms.link import prismatic, revolute
from ..arms.motions import ROTATE, TRANSLATE, X, Y, Z
from ..drawing.controls import Knob, PoseTable
from ..drawing.readings import Vector
from ..drawing.scene import at, origin_of
from ..drawing.sketch import Sketch
from ..views.live import LiveView
from ..views.studies import motions_view, parameters_view

__all__ = ["JUDGES", "motions_view", "parameters_view", "rules_view"]


def rules_view() -> LiveView:
    """Frame 1 that may break the rules: its x axis tilts towards z0, or misses it."""
    sketch = Sketch("The two rules", 2.5, center=(0, 0, 1), planar=False)
    tilt = sketch.knob(Knob.angle("tilt", "tilt", -radians(50), radians(50), radians(25)))
    miss = sketch.knob(Knob.length("miss", "miss", -1.5, 1.5, 1.0))
    upright = sketch.move(ROTATE, Y, -pi / 2)  # its x axis is z0
    sketch.move(ROTATE, Z, radians(20), parent=0)
    foot = sketch.move(TRANSLATE, Z, 1.5)
    side = sketch.move(TRANSLATE, Y, 0, miss)
    sketch.move(ROTATE, Y, 0, tilt)
    sketch.move(TRANSLATE, X, 2.0)
    frame = sketch.move(ROTATE, X, -radians(60))
    across = sketch.move(ROTATE, Z, pi / 2, parent=foot)  # its x axis points along the miss
    sketch.line("z-line", at(0, (0, 0, -0.6), (0, 0, 2.8)), "axis")
    sketch.line("x-line", at(frame, (-3, 0, 0), (0, 0, 0)))
    tail, head = map(origin_of, (foot, side))
    sketch.arrow("gap", tail, head)
    sketch.axes("0", 0)
    sketch.axes("1", frame)
    sketch.tip = frame
    origin, unit = at(frame, (0, 0, 0), (1, 0, 0))
    sketch.reading("rule 1", "Rule 1: x₁ · z₀ = {}, should be 0",
                   Vector(origin, unit, upright, 1))
    sketch.reading("rule 2", "Rule 2: x₁ passes z₀ at {}, should be 0",
                   Vector(tail, head, across, 1))
    sketch.pose = PoseTable.of_frame("H, frame 1 seen from frame 0", "1", "xyz")
    return LiveView(sketch.scene())


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


def _twisted_back(rows: Rows) -> None:
    rows[:, 3] *= -1


def _lengths_swapped(rows: Rows) -> None:
    rows[:, [1, 2]] = rows[:, [2, 1]]


def _moved_down(rows: Rows) -> None:
    rows[:, 2:] = np.vstack([[0, 0], rows[:-1, 2:]])


_OFFSET = ("The offset of joint 2 is missing: when theta_2* is 0, x2 already stands 90° away from "
           "x1.", _without_offset)
_TWIST = ("The sign of alpha is wrong: turn z_{i-1} to z_i about x_i by the right-hand rule.",
          _twisted_back)
_SWAPPED = ("d and a have changed places: d is measured along z, a along x.", _lengths_swapped)
_MOVED = ("a and alpha stand one row too low: that is the modified (Craig) table. In the standard "
          "one row i holds a_i and alpha_i.", _moved_down)

# ---- Exercise 2: the table --------------------------------------------------------------

_COLUMNS = ("theta", "d", "a", "alpha")
_CELLS = [f"{name} of row {i}" for i in (1, 2, 3) for name in _COLUMNS]


def _table(numbers: list[list[float]]) -> Verdict:
    """What there is to say of a table, known with all joints at zero and at the points."""
    tables = np.reshape(numbers, (-1, 3, 4))
    moved = tables[1:] - tables[0]
    places = [np.flatnonzero(np.abs(moved[:, i]).max(axis=0) > 1e-9).tolist() for i in range(3)]
    if misplaced := _misplaced(moved, places):
        return misplaced
    arm = _arm_of(tables[0], [(revolute, prismatic)[place] for place, in places])
    slips = [(message, _arm_of(_changed(change, 0, 0, 0)))
             for message, change in (_SWAPPED, _MOVED)]
    verdict = examined(arm, _EXAM, ends=True, slips=slips,
                       praise="Twelve numbers, three of them variables.")
    if not verdict.ok or stands_as(arm, _EXAM):
        return verdict
    hints = first_of((_OFFSET, _TWIST), lambda change: stands_as(
        arm, _arm_of(_changed(change, 0, 0, 0))))
    said, fault = _other_zero(arm)
    return Verdict(NOT_YET, " ".join(["The mechanism is right, but where theta_2* = 0 and d_3* = 0 "
                                      "it does not stand as in the view.", *hints, *said]), fault)


def _other_zero(arm: Arm) -> tuple[list[str], Fault | None]:
    """Which constant beside a joint variable makes the arm stand as in the view, in any frames."""
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
    """Whether the tip is as far from the floor's origin as it should be, in every pose.

    That depends on the zeros of theta_2 and d_3, but neither on frames nor on signs of joints.
    """
    poses = np.random.default_rng(0).uniform(-2, 2, (9, 3))
    wanted = np.linalg.norm(forward_kinematics(reference, poses)[:, :3, 3], axis=1)
    return any(np.allclose(np.linalg.norm(forward_kinematics(answer, poses * signs)[:, :3, 3],
                                          axis=1), wanted) for signs in product((1, -1), repeat=3))


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
          for message, change in (_OFFSET, _TWIST, _SWAPPED)),
    ]
    return expressions(_ENTRIES, right, _POINTS, constants=_LENGTHS, slips=known, praise=praise)


_ENTRIES = [matrix_place(index) for index in np.ndindex(4, 4)]
_REVERSED = [("The factors stand in the wrong order: H_2^0 is A_1 times A_2.",
              lambda *q: _product(slice(1, None, -1), _rows(*q)))]

# ---- Exercise 6: parameters from a matrix ---------------------------------------------

_MEASURED = np.array([radians(150), 0.3, -0.5, radians(-60)])
_MEASURE_SLIPS = [
    ("The angles are in degrees; give radians.", np.degrees(_MEASURED) * [1, 0, 0, 1]
     + _MEASURED * [0, 1, 1, 0]),
    ("a is a signed length: O_i lies against x_i here.", np.abs(_MEASURED) * [1, 1, 1, -1]),
    ("A tangent leaves two quadrants open: np.arctan2 takes sine and cosine.",
     _MEASURED - [pi, 0, 0, 0]),
    ("theta would fit the origin, but not the x axis: column 1 is (cos theta, sin theta, 0).",
     [radians(-30), 0.3, 0.5, radians(-60)]),
    ("The sign of alpha is wrong: sin alpha stands in row 3, column 2.", _MEASURED * [1, 1, 1, -1]),
    ("d and a have changed places.", _MEASURED[[0, 2, 1, 3]]),
]

# ---- Exercise 7: frames of one's own ----------------------------------------------------


def _frames(answer: Any) -> Verdict:
    if _untouched(answer):
        return Verdict(BLANK, "Replace every ... by three numbers.")
    try:
        placement = examine_frames(answer, _EXAM)
    except ValueError as error:
        return Verdict(NOT_YET, f"{error}.")
    if placement.arm is None:
        return placement
    view, own = link_frames(_EXAM, _EXAM.home), link_frames(placement.arm, placement.arm.home)
    turned = [i for i in range(3) if view[i, :3, 2] @ own[i, :3, 2] < 0]
    if not turned:
        return Verdict(NOT_YET, "All frames keep the rules, but every z points as in the view: "
                                "turn z0, z1 or z2 round, and see which x axes may stay.")
    return Verdict(CORRECT, " ".join([placement.message, *(
        f"z{i} points the other way, so joint {i + 1} counts backwards." for i in turned)]))


def _untouched(answer: Any) -> bool:
    """Whether all that is in nested lists is still the stub."""
    if isinstance(answer, (list, tuple)):
        return bool(answer) and all(map(_untouched, answer))
    return is_stub(answer)


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
    "dh_recipe.6": values(
        _MEASURED, entry=lambda index: _COLUMNS[index[0]], slips=_MEASURE_SLIPS,
        praise="Four numbers out, and the four motions lead back to the same matrix."),
    "dh_recipe.7": _frames,
}
