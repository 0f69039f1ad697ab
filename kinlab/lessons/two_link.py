"""Lesson 04, the two-link arm by both methods: views, predictions, judges of its exercises."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import cos, degrees, pi, radians, sin
from numbers import Real
from typing import Any

import numpy as np

from ..answers.conditions import degrees_slip, exactly, meet, one_of_many
from ..answers.given import is_stub, untouched
from ..answers.judges import Judge, expressions, function
from ..answers.verdict import NOT_YET, Verdict
from ..arms import inputs, transforms
from .asked.two_link import PREDICTIONS
from .views.two_link import both_methods, n_links

__all__ = ["JUDGES", "PREDICTIONS", "both_methods", "n_links"]

# ---- Exercise 1: P and Q by trigonometry ----------------------------------------------


def _polar(length: float, angle: float) -> np.ndarray:
    return length * np.array([cos(angle), sin(angle)])


def _PQ(t1: float, t2: float, l1: float, l2: float) -> np.ndarray:
    P = _polar(l1, t1)
    return np.array([P, P + _polar(l2, t1 + t2)])


def _printed(t1: float, t2: float, l1: float, l2: float) -> np.ndarray:
    P, Q = _PQ(t1, t2, l1, l2)
    return np.array([P, [Q[0], P[1] + l2 * cos(t1 + t2)]])


_PQ_CASES = [dict(zip(("theta_1", "theta_2", "l_1", "l_2"), case))
             for case in ((0.0, 0.0, 2.0, 1.0), (pi / 2, -pi / 2, 2.0, 1.5), (0.6, 0.9, 1.0, 1.0),
                          (-2.0, 0.7, 1.4, 0.8))]

_PQ_SLIPS = [
    ("The angles arrive in radians; do not convert them.",
     lambda t1, t2, l1, l2: _PQ(radians(t1), radians(t2), l1, l2)),
    ("Link 2 is turned by theta_1 + theta_2: its own angle counts from link 1.",
     lambda t1, t2, l1, l2: np.array([_polar(l1, t1), _polar(l1, t1) + _polar(l2, t2)])),
    ("The second component of Q takes the sine; the lecture's print has a cosine there.", _printed),
    ("Q begins at P, not at O: add P.",
     lambda t1, t2, l1, l2: np.array([_polar(l1, t1), _polar(l2, t1 + t2)])),
    ("P and Q have changed places.", lambda *case: _PQ(*case)[::-1]),
    ("Sine and cosine have changed places.", lambda *case: _PQ(*case)[:, ::-1]),
    ("Give P and Q as rows: [[P_x, P_y], [Q_x, Q_y]].", lambda *case: _PQ(*case).T),
    ("l_1 and l_2 have changed places.", lambda t1, t2, l1, l2: _PQ(t1, t2, l2, l1)),
    ("The sign of theta_2 is wrong.", lambda t1, t2, l1, l2: _PQ(t1, -t2, l1, l2)),
]

# ---- Exercise 2: a point beside link 2 -------------------------------------------------


def _H(theta: float, x: float) -> np.ndarray:
    return transforms.homogeneous(transforms.rotation_2d(theta), [x, 0])


def _beside(t1: float, t2: float, l1: float, l2: float, h: float) -> np.ndarray:
    return transforms.apply(_H(t1, 0) @ _H(t2, l1), [l2, h])


def _with(offset: Callable) -> Callable:
    return lambda t1, t2, l1, l2, h: _PQ(t1, t2, l1, l2)[1] + offset(t1, t2, h)


_BESIDE_POINTS = [dict(zip(("theta_1", "theta_2", "l_1", "l_2", "h"), case))
                  for case in ((0.5, 0.8, 1.3, 0.9, 0.4), (-1.1, 0.4, 2.0, 1.0, 0.3),
                               (2.0, -0.9, 0.7, 1.1, 0.5))]

_BESIDE_SLIPS = [
    ("This is Q: the step h is forgotten.", _with(lambda t1, t2, h: 0)),
    ("h is measured along y_2, which turns with the arm, not along y_0.",
     _with(lambda t1, t2, h: np.array([0, h]))),
    ("The sign of h is wrong: y_2 points to the left of link 2.",
     lambda t1, t2, l1, l2, h: _beside(t1, t2, l1, l2, -h)),
    ("y_2 is turned by theta_1 + theta_2, not by theta_2 alone.",
     _with(lambda t1, t2, h: _polar(h, t2 + pi / 2))),
    ("h is added along link 2: that direction is x_2.",
     _with(lambda t1, t2, h: _polar(h, t1 + t2))),
    ("Link 1 is forgotten: the last column of H_2^1 holds l_1.",
     lambda t1, t2, l1, l2, h: _beside(t1, t2, 0, l2, h)),
    ("The factors stand in the wrong order: it is H_1^0 H_2^1.",
     lambda t1, t2, l1, l2, h: transforms.apply(_H(t2, l1) @ _H(t1, 0), [l2, h])),
]

# ---- Exercise 3: n links ---------------------------------------------------------------


def _sum(lengths: Any, directions: Any, phi: float) -> np.ndarray:
    lengths = np.array(lengths)
    return np.array([lengths @ np.cos(directions), lengths @ np.sin(directions), phi])


def _tip(lengths: Any, angles: Any) -> np.ndarray:
    return _sum(lengths, np.cumsum(angles), sum(angles))


_TIP_CASES = [dict(lengths=lengths, angles=angles) for lengths, angles in (
    ((1.0,), (0.5,)), ((2.0, 1.0), (0.3, 0.4)), ((1.5, 1.0, 0.5), (0.5, -0.9, 0.7)),
    ((1.0, 0.8, 0.6, 0.4, 0.2), (0.2, 0.3, -0.8, 0.5, 1.1)))]

_TIP_SLIPS = [
    ("The angles arrive in radians; do not convert them.",
     lambda lengths, angles: _tip(lengths, np.radians(angles))),
    ("Each link is turned by all the angles up to its own: add them up.",
     lambda lengths, angles: _sum(lengths, angles, sum(angles))),
    ("Each link is turned by all the angles up to its own: add them up.",
     lambda lengths, angles: _sum(lengths, angles, angles[-1])),
    ("The sum of angles stops one too early: a link's own angle counts for it.",
     lambda lengths, angles: _sum(lengths, np.cumsum(angles) - angles, sum(angles))),
    ("The last link is forgotten.",
     lambda lengths, angles: _sum(lengths[:-1], np.cumsum(angles)[:-1], sum(angles))),
    ("The direction of the last link is the sum of all angles.",
     lambda lengths, angles: _sum(lengths, np.cumsum(angles), angles[-1])),
    ("phi is in degrees; give it in radians, as the angles come.",
     lambda lengths, angles: _tip(lengths, angles) * [1, 1, degrees(1)]),
    ("x takes the cosine, y the sine.",
     lambda lengths, angles: _tip(lengths, angles)[[1, 0, 2]]),
]

# ---- Exercise 4: link 2 level, Q on the y axis -----------------------------------------

_two_angles = exactly((2,), "two angles, theta_1 and theta_2")


def _points_back(q: np.ndarray) -> str:
    off = degrees(abs(sum(q) % (2 * pi) - pi))
    return "" if off <= 0.01 else (f"Link 2 is {off:.4g}° away from the direction -x_0; "
                                   "0.01° is allowed.")


def _on_the_axis(l1: float, l2: float, q: np.ndarray) -> str:
    x = _PQ(q[0], q[1], l1, l2)[1, 0]
    return "" if abs(x) <= 1e-3 else (f"Link 2 points along -x_0, but Q is at x = {x:.4g}; "
                                      "0.001 is allowed.")


def level_judge(l_1: float, l_2: float) -> Judge:
    """Judge of two angles that make link 2 point against x_0, with Q on the y axis."""
    level = (_points_back, partial(_on_the_axis, l_1, l_2))
    slips = [
        degrees_slip(level, 4 * pi, hint="write np.radians([...])"),
        ("theta_2 counts from link 1, not from x_0.", lambda q: meet(level, q - [0, q[0]])),
        ("The signs of the two angles do not go together.", lambda q: meet(level, q * [1, -1])),
        ("It points along +x_0.", lambda q: not _points_back(q + [0, pi])),
    ]
    return one_of_many(
        _two_angles, level, slips=slips, parts=("theta_1", "theta_2"),
        praise="Link 2 is level and Q lies on the axis. There is a second answer, with P on the "
               "other side of x_0.")


_HOW_MANY = {
    1: "Where does P lie? It may be above x_0 or below it.",
    4: "theta_1 decides theta_2, since their sum is 180°: count the values of theta_1.",
    0: "You have just given one."}


def _with_number(judge: Judge) -> Judge:
    """A judge of the two angles, and of how many answers there are if that is given too."""
    def judged(answer: Any) -> Verdict:
        if untouched(answer) or not (isinstance(answer, (list, tuple)) and len(answer) == 2
                                     and (np.ndim(answer[0]) or np.ndim(answer[1])
                                          or (isinstance(answer[1], int) and is_stub(answer[0])))):
            return judge(answer)
        angles, number = answer
        if is_stub(angles):
            return Verdict(NOT_YET, "The two angles are still to do.")
        verdict = judge(angles)
        if not verdict.ok:
            return verdict
        if is_stub(number):
            return Verdict(NOT_YET, "The two angles are right; how many answers there are is still "
                                    "to do.")
        if np.ndim(number) or not isinstance(number, Real) or number != 2:
            said = ("The two angles are right. The number of answers, whole turns aside, is not "
                    f"{inputs.brief(number)}.")
            hint = next((hint for n, hint in _HOW_MANY.items() if np.ndim(number) == 0
                         and number == n), "")
            return Verdict(NOT_YET, f"{said} {hint}".rstrip())
        return Verdict(verdict.word, "Two answers: link 2 is level and Q lies on the axis, with P "
                                     "on either side of x_0.")
    return judged


JUDGES: dict[str, Judge] = {
    "two_link.1": function(
        _PQ, _PQ_CASES, entry=lambda index: f"{'PQ'[index[0]]}_{'xy'[index[1]]}",
        slips=_PQ_SLIPS, praise="P and Q are right in every case."),
    "two_link.2": expressions(
        ("x", "y"), _beside, _BESIDE_POINTS, constants={}, slips=_BESIDE_SLIPS,
        praise="The two matrices stay as they are; only the last column vector changed."),
    "two_link.3": function(
        _tip, _TIP_CASES, entry=lambda index: ("x", "y", "phi")[index[0]], slips=_TIP_SLIPS,
        angles=[False, False, True],
        praise="It serves planar arms with any number of links."),
    "two_link.4": _with_number(level_judge(2, 1)),
}
