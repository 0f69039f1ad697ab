"""Lesson 07, the Alpha II: its views, its exercises' references and typical slips."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import cos, pi, sin

import numpy as np

from ..answers.conditions import (
    degrees_slip,
    meet,
    one_of_many,
    one_pose,
    straight_down,
    within_limits,
)
from ..answers.judges import Judge, Slip, choices, expressions, function
from ..answers.matrices import (
    BY_ENTRY,
    entry_by_entry,
    link_matrix,
    matrix_entry,
    motions,
    sign_slips,
)
from ..arms import kinematics, robots
from .asked.alpha_ii import PREDICTIONS
from .views.four_motions import four_motions
from .views.reach import level_view
from .views.reach import reach_view as workspace_view

__all__ = ["JUDGES", "PREDICTIONS", "four_motions", "level_view", "workspace_view"]

# ---- Exercise 1: the link transform -------------------------------------------------

_A, _modified = link_matrix, partial(link_matrix, convention="modified")


def _rotation_transposed(T: np.ndarray) -> np.ndarray:
    return np.block([[T[:3, :3].T, T[:3, 3:]], [T[3:]]])


def _slide_before_turn(theta: float, d: float, a: float, alpha: float) -> np.ndarray:
    T = _A(theta, 0, 0, alpha)
    T[:3, 3] = a, 0, d
    return T


_LINK_CASES = [dict(theta=0.0, d=0.0, a=0.0, alpha=0.0),
               dict(theta=pi / 6, d=0.0, a=177.8, alpha=0.0),
               dict(theta=0.7, d=215.0, a=0.0, alpha=-pi / 2),
               dict(theta=-0.4, d=12.0, a=30.0, alpha=0.9)]

_LINK_SLIPS: list[Slip] = [
    ("The angles arrive in radians; do not convert them.",
     lambda t, d, a, al: _A(t * pi / 180, d, a, al * pi / 180)),
    ("This is the transpose: the axes of frame k are columns, not rows.",
     lambda t, d, a, al: _A(t, d, a, al).T),
    ("The rotation is transposed: the axes of frame k are its columns, not its rows.",
     lambda t, d, a, al: _rotation_transposed(_A(t, d, a, al))),
    ("This is the inverse: it takes coordinates from frame k-1 to frame k.",
     lambda t, d, a, al: np.linalg.inv(_A(t, d, a, al))),
    ("The factors stand in the reverse order: this is the modified (Craig) link matrix, or the "
     "four motions about fixed axes.", _modified),
    ("The sign of alpha is wrong: in Rx(alpha) the minus stands at the upper sine.",
     lambda t, d, a, al: _A(t, d, a, -al)),
    ("The sign of theta is wrong: in Rz(theta) the minus stands at the upper sine.",
     lambda t, d, a, al: _A(-t, d, a, al)),
    ("a and d have changed places: d is a slide along z, a is one along x.",
     lambda t, d, a, al: _A(t, a, d, al)),
    ("The slide along x comes after the turn by theta, so the last column begins with "
     "a cos(theta), a sin(theta).", _slide_before_turn),
    ("The slide d along z is left out.", lambda t, d, a, al: _A(t, 0, a, al)),
    ("The slide a along x is left out.", lambda t, d, a, al: _A(t, d, 0, al)),
    ("theta and alpha have changed places: theta turns about z, alpha about x.",
     lambda t, d, a, al: _A(al, d, a, t)),
    ("The last column is that of the modified matrix. Here the turn by theta comes first, so the "
     "column is a cos(theta), a sin(theta), d.", lambda t, d, a, al: np.column_stack(
         [_A(t, d, a, al)[:, :3], _modified(t, d, a, al)[:, 3]])),
    ("a lies along x, which theta turns towards y: the last column has a cos(theta) above "
     "a sin(theta).", lambda t, d, a, al: np.column_stack(
         [_A(t, d, a, al)[:, :3], [a * sin(t), a * cos(t), d, 1]])),
    ("Sine and cosine of theta have changed places.", lambda t, d, a, al: _A(pi / 2 - t, d, a, al)),
    ("Sine and cosine of alpha have changed places.", lambda t, d, a, al: _A(t, d, a, pi / 2 - al)),
    (BY_ENTRY, lambda *row: entry_by_entry(motions(*row))),
    (BY_ENTRY, lambda t, d, a, al: entry_by_entry([_A(t, d, 0, 0), _A(0, 0, a, al)])),
    *sign_slips(_A, [[(0, 2)], [(1, 2)], [(2, 1)]],
                "The sign of sin(alpha) is wrong in one of its rows: in Rx(alpha) the minus stands "
                "at the upper sine."),
]

# ---- Exercise 2: the tip when the tool points straight down -------------------------

_ALPHA_II = robots.alpha_ii()
_L1, _L2, _L3, _, _L5 = _ALPHA_II.links
_D1, _A2, _A3, _D5 = _L1.d, _L2.a, _L3.a, _L5.d


def _tip_below(q1: float, q2: float, q3: float) -> np.ndarray:
    return kinematics.forward_kinematics(_ALPHA_II, [q1, q2, q3, -q2 - q3, 0])[:3, 3]


def _at(q1: float, reach: float, height: float) -> list[float]:
    return [cos(q1) * reach, sin(q1) * reach, height]


def _out(q2: float, q3: float) -> float:
    return _A2 * cos(q2) + _A3 * cos(q2 + q3)


def _drop(q2: float, q3: float) -> float:
    return _A2 * sin(q2) + _A3 * sin(q2 + q3)


_LENGTHS = dict(d_1=_D1, a_2=_A2, a_3=_A3, d_5=_D5)  # for students who write symbols

_TIP_POINTS = [dict(zip(("theta_1", "theta_2", "theta_3"), q))
               for q in ((0.3, -0.5, 0.8), (-1.1, 0.4, 0.6), (2.0, 0.9, -1.3))]



def _forearm(across: Callable, down: Callable) -> Callable:
    """The tip with other formulas for the forearm's C23 and S23."""
    return lambda q1, q2, q3: _at(q1, _A2 * cos(q2) + _A3 * across(q2, q3),
                                  _D1 - _A2 * sin(q2) - _A3 * down(q2, q3) - _D5)


def _forearm_slips(message: str, across: Callable, down: Callable) -> list[Slip]:
    """A slip in the reach, in the height, or in both."""
    def c23(q2: float, q3: float) -> float:
        return cos(q2 + q3)

    def s23(q2: float, q3: float) -> float:
        return sin(q2 + q3)
    return [(message, _forearm(*pair)) for pair in ((across, down), (across, s23), (c23, down))]


_TIP_SLIPS: list[Slip] = [
    ("This is the wrist: the tool, d5 = 129.5 mm, is forgotten.",
     lambda q1, q2, q3: _at(q1, _out(q2, q3), _D1 - _drop(q2, q3))),
    ("The tool hangs down from the wrist, so d5 lowers the tip.",
     lambda q1, q2, q3: _at(q1, _out(q2, q3), _D1 - _drop(q2, q3) + _D5)),
    ("The tool hangs down from the wrist: d5 belongs to the height, not to the reach.",
     lambda q1, q2, q3: _at(q1, _out(q2, q3) + _D5, _D1 - _drop(q2, q3))),
    ("Positive angles of joints 2 and 3 lower the arm: their sines are subtracted.",
     lambda q1, q2, q3: _at(q1, _out(q2, q3), _D1 + _drop(q2, q3) - _D5)),
    *_forearm_slips("The forearm is turned by theta_2 + theta_3, not by theta_3 alone.",
                    lambda q2, q3: cos(q3), lambda q2, q3: sin(q3)),
    *_forearm_slips("C23 is cos(theta_2 + theta_3), not a product of two cosines.",
                    lambda q2, q3: cos(q2) * cos(q3), lambda q2, q3: sin(q2) * sin(q3)),
    *_forearm_slips("C23 is cos(theta_2 + theta_3), not cos(theta_2) + cos(theta_3).",
                    lambda q2, q3: cos(q2) + cos(q3), lambda q2, q3: sin(q2) + sin(q3)),
    *_forearm_slips("The forearm is turned by theta_2 + theta_3, not by their difference.",
                    lambda q2, q3: cos(q2 - q3), lambda q2, q3: sin(q2 - q3)),
    ("The forearm, a3 = 177.8 mm, is forgotten.",
     _forearm(lambda q2, q3: 0, lambda q2, q3: 0)),
    ("The upper arm, a2 = 177.8 mm, is forgotten.",
     lambda q1, q2, q3: _at(q1, _A3 * cos(q2 + q3), _D1 - _A3 * sin(q2 + q3) - _D5)),
    ("The height of the shoulder, d1 = 215 mm, is missing in p_z.",
     lambda q1, q2, q3: _at(q1, _out(q2, q3), -_drop(q2, q3) - _D5)),
    ("p_x and p_y lack joint 1: the reach is turned by theta_1.",
     lambda q1, q2, q3: [_out(q2, q3), 0, _D1 - _drop(q2, q3) - _D5]),
    ("Sines and cosines of joints 2 and 3 have changed places.",
     lambda q1, q2, q3: _at(q1, _drop(q2, q3), _D1 - _out(q2, q3) - _D5)),
    ("p_x and p_y have changed places.",
     lambda q1, q2, q3: _tip_below(q1, q2, q3)[[1, 0, 2]]),
    ("Lengths are in millimetres.", lambda q1, q2, q3: _tip_below(q1, q2, q3) / 1000),
]

# ---- Exercise 3: which joints change what -------------------------------------------

_CHANGES = {"p_z": {2, 3, 4}, "a": {1, 2, 3, 4}, "n": {1, 2, 3, 4, 5}}

_JOINT_HINTS = {
    ("p_z", 1): "Joint 1 turns the arm about the vertical z0: can that change a height?",
    ("p_z", 2): "What does the shoulder do to the height?",
    ("p_z", 3): "What does the elbow do to the height?",
    ("p_z", 4): "The tool has a length: what happens to the tip as the tool pitches?",
    ("p_z", 5): "Joint 5 rolls the tool about z4, and the tip lies on that axis.",
    ("a", 1): "Turn the base: does the tool still point the same way?",
    ("a", 2): "Look for theta_2 inside S234.",
    ("a", 3): "Look for theta_3 inside S234.",
    ("a", 4): "Look for theta_4 inside S234.",
    ("a", 5): "Joint 5 rolls the tool about z4, and the approach vector lies along that axis.",
    ("n", 5): "Joint 5 rolls the tool: what does the normal vector do then?",
}

# ---- Exercise 4: touch the table, tool straight down --------------------------------

# mm. A slider stops at tenths of a degree, and a tenth of joint 2 moves the tip by up to 0.6 mm.
TOUCH = 0.5


def _on_the_table(height: float, q: np.ndarray) -> str:
    z = kinematics.forward_kinematics(_ALPHA_II, q)[2, 3] - height
    side = "above" if z > 0 else "below"
    return "" if abs(z) <= TOUCH else (f"The tool points straight down, but its tip is "
                                       f"{abs(z):.4g} mm {side} the table; {TOUCH} mm is allowed.")


_DOWN = straight_down(_ALPHA_II)


def table_judge(height: float) -> Judge:
    """Judge of joint values with the tool straight down on a table of that height (mm)."""
    conditions = (within_limits(_ALPHA_II), _DOWN, partial(_on_the_table, height))
    slips = [
        degrees_slip(conditions),
        ("It points straight up.", lambda q: not _DOWN(q + [0, 0, 0, pi, 0])),
        ("It is the wrist that touches the table: the tip is d5 = 129.5 mm farther on.",
         lambda q: abs(kinematics.link_frames(_ALPHA_II, q)[3, 2, 3] - height) <= TOUCH),
        ("The sign of theta_4 is wrong.", lambda q: meet(conditions, q * [1, 1, 1, -1, 1])),
    ]
    return one_of_many(
        one_pose(_ALPHA_II), conditions, slips=slips,
        praise="Straight down, on the table and inside the limits. This is one of many answers: "
               "two conditions leave three of the five joints free.")


JUDGES: dict[str, Judge] = {
    "alpha_ii.1": function(
        _A, _LINK_CASES, slips=_LINK_SLIPS, entry=matrix_entry,
        without="Write the matrix of section 2, or multiply four matrices of your own.",
        praise="Your function agrees in every case. It serves every link of every arm in "
               "standard DH parameters."),
    "alpha_ii.2": expressions(
        ("p_x", "p_y", "p_z"), _tip_below, _TIP_POINTS, constants=_LENGTHS, slips=_TIP_SLIPS,
        praise="With the tool straight down theta_4 is gone, and the height depends on theta_2 "
               "and theta_3 alone."),
    "alpha_ii.3": choices(
        _CHANGES, {1, 2, 3, 4, 5}, _JOINT_HINTS,
        praise="The height needs the three parallel joints, the direction adds the base, and "
               "only the full orientation feels the roll."),
    "alpha_ii.4": table_judge(0),
}
