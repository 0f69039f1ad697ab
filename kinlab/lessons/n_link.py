"""Lesson 06, Practical 3: its views, its exercises' references and typical slips."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import degrees, pi
from typing import Any

import numpy as np

from ..answers.judges import function, joint_values
from ..answers.table_judge import table
from ..arms import euler, kinematics, robots
from ..arms.arm import Arm
from ..arms.joints import joint_array
from . import _n_link_programs
from ._n_link_programs import GIVEN, through
from .views.n_link import both_conventions, misread, zyz_view

__all__ = ["JUDGES", "both_conventions", "misread", "zyz_view"]

# ---- Exercise 3: the six-link arm ------------------------------------------------------

_SIX = robots.practical_six_link()


def _six(tool: Any = None, **columns: Any) -> Arm:
    """The arm with some columns of its table replaced."""
    links = [replace(link, **{name: float(column[i]) for name, column in columns.items()})
             for i, link in enumerate(_SIX.links)]
    return replace(_SIX, links=links, tool=_SIX.tool if tool is None else tool)


_ALPHA, _A, _D = (np.array([getattr(link, name) for link in _SIX.links])
                  for name in ("alpha", "a", "d"))
_SIX_SLIPS = [
    ("The arm is right, but the tool is forgotten: tool=kl.translation([0, 0, 1]).",
     _six(tool=np.eye(4))),
    ("The arm is right, but its tool lies along z6, not along x6.",
     _six(tool=np.eye(4) + np.outer([1, 0, 0, 0], [0, 0, 0, 1]))),
    ("The sign of d in row 2 is wrong: the table says -d2.", _six(d=np.abs(_D))),
    ("The signs of alpha in rows 2, 4, 5, 6 are all turned round.", _six(alpha=-_ALPHA)),
    ("alpha and a stand one row too high: row i of a modified table holds those of i-1.",
     _six(alpha=np.roll(_ALPHA, -1), a=np.roll(_A, -1))),
    ("The values in brackets are the given joint angles. They are q, not offsets in the table.",
     _six(theta=GIVEN)),
]

# ---- Exercise 4: ZYZ angles, both branches ----------------------------------------------

_ANGLES = ("phi", "theta", "psi")
_ZYZ_CASES = [dict(zip(_ANGLES, angles)) for angles in
              ((0.4, 0.9, -0.7), (-2.1, 1.3, 2.5), (1.0, 2.2, 0.3))]


def _branches(*angles: float) -> np.ndarray:
    return np.array(euler.zyz_angles(euler.zyz_matrix(*angles)).solutions)


def _second(psi: Callable) -> Callable:
    """Both branches, with another formula for psi of the second one."""
    def wrong(*angles: float) -> np.ndarray:
        branches = _branches(*angles)
        branches[1, 2] = psi(euler.zyz_matrix(*angles))
        return branches
    return wrong


def _psi_unsigned(*angles: float) -> np.ndarray:
    R, branches = euler.zyz_matrix(*angles), _branches(*angles)
    branches[0, 2] = np.arctan2(R[2, 1], R[2, 0])
    return branches


_ZYZ_SLIPS = [
    ("psi of the second branch is the printed atan2(-r23, r31). It takes -r32: both of its "
     "entries come from the last row.", _second(lambda R: np.arctan2(-R[1, 2], R[2, 0]))),
    ("psi of the second branch is that of the first. Both signs of its arguments turn round.",
     _second(lambda R: np.arctan2(R[2, 1], -R[2, 0]))),
    ("psi of the first branch is atan2(r32, -r31): the minus is missing.", _psi_unsigned),
    ("The angles are in degrees; leave them in radians.", lambda *q: np.degrees(_branches(*q))),
    ("The branches have changed places: sin(theta) > 0 comes first.",
     lambda *q: _branches(*q)[::-1]),
    ("phi and psi have changed places.", lambda *q: _branches(*q)[:, ::-1]),
    ("This is the transpose's answer: R[1, 2] is row 2, column 3.",
     lambda *q: np.array(euler.zyz_angles(euler.zyz_matrix(*q).T).solutions)),
]


def _zyz_entry(index: tuple) -> str:
    return f"{_ANGLES[index[1]]} of the {('first', 'second')[index[0]]} branch"


# ---- Exercise 5: degenerate angles, regular wrist ------------------------------------------


def _one_pose(answer: Any) -> np.ndarray:
    q = joint_array(_SIX, answer)
    if q.ndim != 1:
        raise ValueError(f"q: expected six joint values, got shape {q.shape}")
    return q


def _off_vertical(q: np.ndarray) -> float:
    x, y, z = kinematics.forward_kinematics(_SIX, q)[:3, 2]
    return degrees(np.arctan2(np.hypot(x, y), z))


def _within_a_turn(q: np.ndarray) -> str:
    """Degrees would pass otherwise: the angles' sum is zero in any unit."""
    i = int(np.argmax(np.abs(q)))
    return "" if abs(q[i]) <= 2 * pi else f"theta_{i + 1} is {q[i]:.4g} rad, over a full turn."


def _straight_up(q: np.ndarray) -> str:
    off = _off_vertical(q)
    return "" if off <= 0.01 else f"z6 is {off:.4g}° away from straight up; 0.01° is allowed."


def _bent(q: np.ndarray) -> str:
    bend = degrees(abs(np.arctan2(np.sin(q[4]), np.cos(q[4]))))
    return "" if 30 <= bend <= 150 else (
        f"theta_5 bends the wrist by {bend:.4g}°; between 30° and 150° are asked for.")


def _meets(q: np.ndarray) -> bool:
    return not (_within_a_turn(q) or _straight_up(q) or _bent(q))


_UP_SLIPS = [
    ("These numbers look like degrees: q is in radians, so write np.radians([...]).",
     lambda q: _meets(np.radians(q)) or np.max(np.abs(q)) > 2 * pi),
    ("The sign of theta_5 is wrong.", lambda q: _meets(q * [1, 1, 1, 1, -1, 1])),
    ("It points straight down, where r33 = -1.", lambda q: abs(_off_vertical(q) - 180) < 0.01),
    ("With the wrist straight only theta_2 + theta_3 = 0 is left. Bend the wrist, and let joints "
     "2 and 3 lean the forearm the other way.", lambda q: abs(np.sin(q[4])) < 1e-9),
]

JUDGES: dict[str, Callable[[Any], str]] = {
    **_n_link_programs.JUDGES,
    "n_link.3": table(
        _SIX, strict=True, slips=_SIX_SLIPS,
        praise="Add a cell with kl.ArmView(my_arm): it is your sketch."),
    "n_link.4": through(lambda *angles: [euler.zyz_matrix(*angles)], function(
        _branches, _ZYZ_CASES, slips=_ZYZ_SLIPS, entry=_zyz_entry,
        praise="Both branches, with the printed slip put right.")),
    "n_link.5": joint_values(
        _one_pose, (_within_a_turn, _straight_up, _bent), slips=_UP_SLIPS,
        praise="The angles are degenerate, the wrist is bent. So the trouble lies in the three "
               "numbers, not in the arm."),
}
