"""Lesson 05, the DH recipe: a view of its two rules, and the judges of its exercises."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from math import pi, radians
from typing import Any

import numpy as np

from ..arm import Arm, revolute
from ..judging import choices, expressions, values
from ..kinematics import forward_kinematics
from ..link_view import motions_view, parameters_view
from ..live import Knob, LiveView
from ..motions import ROTATE, TRANSLATE, X, Y, Z
from ..scene import Vector, at
from ..sketch import Sketch

__all__ = ["JUDGES", "motions_view", "parameters_view", "rules_view"]


def rules_view() -> LiveView:
    """Frame 1 that may break the rules: its x axis tilts towards z0, or misses it."""
    sketch = Sketch("The two rules", 3.0, planar=False)
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
    sketch.line("z-line", at(0, (0, 0, -1), (0, 0, 2.8)), "axis")
    sketch.line("x-line", at(frame, (-4, 0, 0), (0, 0, 0)))
    ends = [at(end, (0, 0, 0))[0] for end in (foot, side)]
    sketch.arrow("gap", *ends)
    sketch.axes("0", 0)
    sketch.axes("1", frame)
    sketch.tip = frame
    sketch.reading("rule 1", "Rule 1: x₁ · z₀ = {}, should be 0", Vector(
        *at(frame, (0, 0, 0), (1, 0, 0)), upright, 1))
    sketch.reading("rule 2", "Rule 2: x₁ passes z₀ at {}, should be 0",
                   Vector(*ends, across, 1))
    columns = [{"name": f"{name}₁", "title": f"{name} of frame 1"} for name in "xyzo"]
    return sketch.view(panels={"pose": {"title": "H, frame 1 seen from frame 0", "unit": "",
                                        "columns": columns, "decimals": 3}})


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

# ---- Exercises 2 to 5: the arm of the 2018 exam ---------------------------------------

_LENGTHS = dict(d_1=0.5, L_off=0.2, a_2=0.4)
_D1, _L, _A2 = _LENGTHS.values()
_POINTS = [dict(theta_1=0.3, theta_2=0.7, d_3=0.45), dict(theta_1=-1.2, theta_2=0.4, d_3=0.6),
           dict(theta_1=2.0, theta_2=-0.9, d_3=0.25)]
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


def _in_degrees(rows: Rows) -> None:
    rows[:, 3] *= 180 / pi
    rows[2, 0] *= 180 / pi
    rows[1, 0] += 90 - pi / 2


_OFFSET = ("The offset of joint 2 is missing: when theta_2* is 0, x2 already stands 90° away from "
           "x1.", _without_offset)
_TWIST = ("The sign of alpha is wrong: turn z_{i-1} to z_i about x_i by the right-hand rule.",
          _twisted_back)
_SWAPPED = ("d and a have changed places: d is measured along z, a along x.", _lengths_swapped)
_TABLE_SLIPS = [
    ("The angles are in degrees; write sp.pi/2 for 90°.", _in_degrees), _OFFSET, _TWIST,
    _SWAPPED,
    ("a and alpha stand one row too low: that is the modified (Craig) table. In the standard one "
     "row i holds a_i and alpha_i.", _moved_down),
]


def _link(row: Any, convention: str = "standard") -> np.ndarray:
    theta, d, a, alpha = row
    return forward_kinematics(Arm([revolute(d=d, a=a, alpha=alpha)], convention=convention),
                              [theta])


def _product(links: slice, rows: Rows, convention: str = "standard") -> np.ndarray:
    """The transform over a stretch of links, its entries row by row."""
    return reduce(np.matmul, [_link(row, convention) for row in rows[links]]).ravel()


def _matrix_judge(links: slice, praise: str, slips: Sequence = ()) -> Callable[[Any], str]:
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


_ENTRIES = tuple(f"row {i}, column {j}" for i in range(1, 5) for j in range(1, 5))
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

JUDGES: dict[str, Callable[[Any], str]] = {
    "dh_recipe.1": choices(
        _KEPT, {1, 2, 3, 4, 5, 6}, _RULE_HINTS, noun="transform",
        praise="Each rule takes away one freedom; 4 shows that turning x can repair a miss."),
    "dh_recipe.2": expressions(
        [f"{name} of row {i}" for i in (1, 2, 3) for name in ("theta", "d", "a", "alpha")],
        lambda *q: _rows(*q).ravel(), _POINTS, constants=_LENGTHS,
        slips=[(message, lambda *q, change=change: _changed(change, *q).ravel())
               for message, change in _TABLE_SLIPS],
        praise="This is the lecture's table: twelve numbers, three of them variables."),
    "dh_recipe.3": _matrix_judge(slice(0, 1), "A_1 turns the column and lifts it by d_1."),
    "dh_recipe.4": _matrix_judge(slice(1, 2), "The offset has turned cosines into sines."),
    "dh_recipe.5": _matrix_judge(
        slice(0, 2), "Column 4 is the elbow, column 3 the direction in which joint 3 will slide.",
        _REVERSED),
    "dh_recipe.6": values(
        _MEASURED, entry=lambda index: ("theta", "d", "a", "alpha")[index[0]],
        slips=_MEASURE_SLIPS,
        praise="Four numbers out, and the four motions lead back to the same matrix."),
}
