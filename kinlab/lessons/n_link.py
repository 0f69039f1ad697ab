"""Lesson 06, Practical 3: its views, its exercises' references and typical slips."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial, reduce
from math import degrees, pi
from typing import Any

import numpy as np

from ..answers.conditions import degrees_slip, meet, one_of_many, one_pose
from ..answers.judges import Judge, Slip, function, is_stub
from ..answers.matrices import link_matrix, matrix_entry, matrix_place
from ..answers.table_judge import column, table, with_columns
from ..answers.verdict import Verdict
from ..arms import euler, kinematics, robots
from ..arms.arm import Arm
from .asked.n_link import PREDICTIONS
from .views.four_motions import four_motions
from .views.n_link import both_conventions, flat_view, misread, six_view, zyz_view

__all__ = ["JUDGES", "PREDICTIONS", "both_conventions", "flat_view", "four_motions", "misread",
           "six_view", "zyz_view"]

# ---- Exercise 1: the link matrix ------------------------------------------------------


def _M(alpha: float, a: float, d: float, theta: float, convention: str = "modified") -> np.ndarray:
    return link_matrix(theta, d, a, alpha, convention)


_standard = partial(_M, convention="standard")


def _in_degrees(alpha: float, a: float, d: float, theta: float) -> np.ndarray:
    return _M(alpha * pi / 180, a, d, theta * pi / 180)


def _with(T: np.ndarray, row: int, column: int, value: float) -> np.ndarray:
    T[row, column] = value
    return T


_ROW = ("alpha", "a", "d", "theta")
_LINK_CASES = [dict(zip(_ROW, row)) for row in (
    (0.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.6), (pi / 2, 0.0, -0.5, 0.7), (-0.9, 0.3, 0.4, -0.4))]
_LINK_SLIPS: list[Slip] = [
    ("This is the standard link matrix. The practical's table is modified: first the turn about x "
     "and the slide along x, then those of z.", _standard),
    ("The angles arrive in radians; do not convert them.", _in_degrees),
    ("The arguments come in the order of the table: alpha, a, d, theta.",
     lambda al, a, d, t: _M(t, d, a, al)),
    ("a and d have changed places: a is a slide along x, d is one along z.",
     lambda al, a, d, t: _M(al, d, a, t)),
    ("This is the transpose: the axes of frame i are columns, not rows.",
     lambda *row: _M(*row).T),
    ("This is the inverse: it takes coordinates from frame i-1 to frame i.",
     lambda *row: np.linalg.inv(_M(*row))),
    ("The sign of alpha is wrong: in Rx(alpha) the minus stands at the upper sine.",
     lambda al, a, d, t: _M(-al, a, d, t)),
    ("The sign of theta is wrong: in Rz(theta) the minus stands at the upper sine.",
     lambda al, a, d, t: _M(al, a, d, -t)),
    ("The entry in row 3, column 3 is the cosine of alpha, not of theta.",
     lambda al, a, d, t: _with(_M(al, a, d, t), 2, 2, np.cos(t))),
    ("The slide d goes along the new z, which alpha has tilted: it enters rows 2 and 3.",
     lambda al, a, d, t: _with(_M(al, a, 0, t), 2, 3, d)),
]

# ---- Exercise 2: n links ---------------------------------------------------------------

_Three = tuple[float, float, float]
# By their number of links: table rows (alpha, a, d) and tool vector.
_ARMS: dict[int, tuple[list[_Three], _Three]] = {
    2: ([(0, 0, 0), (0, 1, 0)], (1, 0, 0)),
    3: ([(0.3, 0.2, 0.1), (-0.5, 0.4, 0.3), (0.9, 0.1, -0.2)], (0.1, 0.2, 0.3)),
    6: ([(0, 0, 0), (pi / 2, 0, -0.5), (0, 0.5, 0), (-pi / 2, 0, 1), (pi / 2, 0, 0),
         (-pi / 2, 0, 0)], (0, 0, 1)),
}
_GIVEN, _REGULAR = np.radians([[0, 90, -90, 0, 0, 0], [30, 40, -20, 50, 60, 70]])
_ARM_CASES = [{f"theta_{i}": float(value) for i, value in enumerate(q, start=1)}
              for q in ((0.5, 0.8), (0.3, -0.6, 1.1), _GIVEN, _REGULAR)]


def _task(*q: float) -> tuple[np.ndarray, np.ndarray]:
    """What the student's function is handed: a table with its angles filled in, and a tool."""
    rows, tool = _ARMS[len(q)]
    return np.column_stack([rows, q]).astype(float), np.array(tool, dtype=float)


def _answer(*q: float, link: Callable = _M, tool: Any = (1, 1, 1), order: int = 1,
            links: slice = slice(None)) -> np.ndarray:
    table, vector = _task(*q)
    T = reduce(np.matmul, [link(*row) for row in table[links]][::order], np.eye(4))
    return np.column_stack([T, T @ [*(vector * tool), 1]])


def _tool_unturned(*q: float) -> np.ndarray:
    joined = _answer(*q, tool=0)
    joined[:3, 4] += _task(*q)[1]
    return joined


def _as_printed(*q: float) -> np.ndarray:
    table, vector = _task(*q)
    following = [*table[1:, 0], 0.0]
    T = reduce(np.matmul, [_with(_M(*row), 2, 2, np.cos(alpha))
                           for row, alpha in zip(table, following)])
    return np.column_stack([T, T @ [*vector, 1]])


def _joined(result: Any) -> Any:
    """T and p side by side, the point with its 1, for the comparison entry by entry."""
    if is_stub(result):
        return result
    if not isinstance(result, (tuple, list)) or len(result) != 2:
        raise ValueError("expected two results; end with return T, p")
    T, p = (np.asarray(part, dtype=float) for part in result)
    if T.shape != (4, 4) or p.shape not in ((3,), (4,)):
        raise ValueError(f"expected T of shape (4, 4) and p of shape (3,), got {T.shape} and "
                         f"{p.shape}")
    return np.column_stack([T, [*p[:3], 1]])


_CHAIN_SLIPS: list[Slip] = [
    ("T is right, but p is the origin of frame n: the tool vector is forgotten.",
     partial(_answer, tool=0)),
    ("T is right, but the tool vector is given in frame n: turn it by R before you add it to o.",
     _tool_unturned),
    ("The link matrix is the standard one; the table is modified.",
     partial(_answer, link=_standard)),
    ("The angles arrive in radians; do not convert them.", partial(_answer, link=_in_degrees)),
    ("This is the hint as printed, with the cosine of alpha_i in row 3, column 3. It has to be "
     "that of alpha_(i-1), the alpha of the same row.", _as_printed),
    ("The factors stand in the reverse order: frame 1 comes first, frame n last.",
     partial(_answer, order=-1)),
    ("The last link is missing.", partial(_answer, links=slice(None, -1))),
    ("The first link is missing.", partial(_answer, links=slice(1, None))),
]


def _through(prepare: Callable, judge: Judge, read: Callable = lambda result: result) -> Judge:
    """A judge of functions whose arguments `prepare` makes of a case's numbers."""
    def judged(answer: Any) -> Verdict:
        if not callable(answer):
            return judge(answer)
        return judge(lambda *numbers: read(answer(*prepare(*numbers))))
    return judged


def _chain_entry(index: tuple) -> str:
    row, column = index
    return f"{'xyz'[row]} of p_E" if column == 4 else f"the entry of T in {matrix_place(index)}"


# ---- Exercise 3: the six-link arm ------------------------------------------------------

_SIX = robots.practical_six_link()


def _six(tool: Any = None, **columns: Any) -> Arm:
    """The arm with another tool, or with some columns of its table replaced."""
    return replace(with_columns(_SIX, **columns), tool=_SIX.tool if tool is None else tool)


_ALPHA, _A, _D = (column(_SIX, name) for name in ("alpha", "a", "d"))
_SIX_SLIPS = [
    ("The arm is right, but the tool is forgotten: tool=kl.translation([0, 0, 1]).",
     _six(tool=np.eye(4))),
    ("The arm is right, but its tool lies along z6, not along x6.",
     _six(tool=np.eye(4) + np.outer([1, 0, 0, 0], [0, 0, 0, 1]))),
    ("The sign of d in row 2 is wrong: the table says -d2.", _six(d=np.abs(_D))),
    ("The sign of alpha in row 2 is wrong: so the arm hangs upside down, with z0 pointing down.",
     _six(alpha=_ALPHA * [1, -1, 1, 1, 1, 1])),
    ("The signs of alpha in rows 2, 4, 5, 6 are all turned round.", _six(alpha=-_ALPHA)),
    ("a2 = 0.5 stands in row 2. It belongs in row 3: row i of a modified table holds a_(i-1).",
     _six(a=np.roll(_A, -1))),
    ("a2 = 0.5 stands in row 4. It belongs in row 3: row i of a modified table holds a_(i-1).",
     _six(a=np.roll(_A, 1))),
    ("a and d have changed places: a is a slide along x, d is one along z.", _six(a=_D, d=_A)),
    ("d6 = 1 is counted twice: in row 6, and in the tool. The practical's table leaves d of row 6 "
     "at 0.", _six(d=_D + [0, 0, 0, 0, 0, 1])),
    ("The tool points backwards: it lies along +z6.", _six(tool=np.eye(4) - np.outer(
        [0, 0, 1, 0], [0, 0, 0, 1]))),
    ("alpha and a stand one row too high: row i of a modified table holds those of i-1.",
     _six(alpha=np.roll(_ALPHA, -1), a=np.roll(_A, -1))),
    ("The values in brackets are the given joint angles. They are q, not offsets in the table.",
     _six(theta=_GIVEN)),
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


_UP = (_within_a_turn, _straight_up, _bent)
_UP_SLIPS = [
    degrees_slip(_UP),
    ("The sign of theta_5 is wrong.", lambda q: meet(_UP, q * [1, 1, 1, 1, -1, 1])),
    ("It points straight down, where r33 = -1.", lambda q: abs(_off_vertical(q) - 180) < 0.01),
    ("With the wrist straight only theta_2 + theta_3 = 0 is left. Bend the wrist, and let joints "
     "2 and 3 lean the forearm the other way.", lambda q: abs(np.sin(q[4])) < 1e-9),
]

JUDGES: dict[str, Judge] = {
    "n_link.1": function(
        _M, _LINK_CASES, slips=_LINK_SLIPS, entry=matrix_entry,
        praise="This is the practical's link matrix, with its four rows."),
    "n_link.2": _through(_task, function(
        _answer, _ARM_CASES, slips=_CHAIN_SLIPS, entry=_chain_entry,
        praise="Your program does what the practical asks for, for two, three and six links."),
        read=_joined),
    "n_link.3": table(
        _SIX, strict=True, upright=True, slips=_SIX_SLIPS,
        praise="Add a cell with kl.ArmView(my_arm): it is your sketch."),
    "n_link.4": _through(lambda *angles: [euler.zyz_matrix(*angles)], function(
        _branches, _ZYZ_CASES, slips=_ZYZ_SLIPS, entry=_zyz_entry,
        praise="Both branches, with the printed slip put right.")),
    "n_link.5": one_of_many(
        one_pose(_SIX, "six"), _UP, slips=_UP_SLIPS,
        praise="The angles are degenerate, the wrist is bent. So the trouble lies in the three "
               "numbers, not in the arm."),
}
