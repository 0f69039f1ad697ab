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
from ..answers.matrices import (
    BY_ENTRY,
    entry_by_entry,
    link_matrix,
    matrix_entry,
    matrix_place,
    motions,
    sign_slips,
)
from ..answers.table_judge import column, table, with_columns
from ..arms import euler, inputs, kinematics, robots
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
    ("The last column is that of the standard matrix. Here the slide along x comes before the turn "
     "by theta, so the column begins with a.", lambda al, a, d, t: np.column_stack(
         [_M(al, a, d, t)[:, :3], _standard(al, a, d, t)[:, 3]])),
    ("theta and alpha have changed places: theta turns about z, alpha about x.",
     lambda al, a, d, t: _M(t, a, d, al)),
    ("Sine and cosine of theta have changed places.", lambda al, a, d, t: _M(al, a, d, pi / 2 - t)),
    ("Sine and cosine of alpha have changed places.", lambda al, a, d, t: _M(pi / 2 - al, a, d, t)),
    ("The slide a along x is left out.", lambda al, a, d, t: _M(al, 0, d, t)),
    ("The slide d along z is left out.", lambda al, a, d, t: _M(al, a, 0, t)),
    (BY_ENTRY, lambda al, a, d, t: entry_by_entry(motions(t, d, a, al))),
    (BY_ENTRY, lambda al, a, d, t: entry_by_entry([_M(al, a, 0, 0), _M(0, 0, d, t)])),
    *sign_slips(_M, [[(1, 2), (1, 3)], [(2, 0), (2, 1)]],
                "The sign of sin(alpha) is wrong in one of its rows: in Rx(alpha) the minus stands "
                "at the upper sine."),
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
            links: slice = slice(None), times: Callable = np.matmul,
            point: Callable = lambda T, tool: T @ [*tool, 1], end: Any = 0) -> np.ndarray:
    """T and p side by side; `end` is the part of the tool that T already holds."""
    table, vector = _task(*q)
    T = reduce(times, [link(*row) for row in table[links]][::order], np.eye(4))
    T = T @ _slid(vector * end)
    return np.column_stack([T, np.append(point(T, vector * tool), 1)[:4]])


def _slid(o: Any) -> np.ndarray:
    T = np.eye(4)
    T[:3, 3] = o
    return T


def _tool_unturned(T: np.ndarray, tool: np.ndarray) -> np.ndarray:
    return T[:3, 3] + tool


def _from_first_link(*q: float) -> np.ndarray:
    """`*` for `@` without an identity before it."""
    table, vector = _task(*q)
    T = entry_by_entry([_M(*row) for row in table])
    return np.column_stack([T, np.append((T @ [*vector, 1])[:3], 1)])


def _as_printed(*q: float) -> np.ndarray:
    table, vector = _task(*q)
    following = [*table[1:, 0], 0.0]
    T = reduce(np.matmul, [_with(_M(*row), 2, 2, np.cos(alpha))
                           for row, alpha in zip(table, following)])
    return np.column_stack([T, T @ [*vector, 1]])


_POINTS = ((3,), (4,), (3, 1), (4, 1))  # shapes


def _joined(result: Any) -> Any:
    """T and p side by side, the point with its 1, for the comparison entry by entry."""
    if not isinstance(result, (tuple, list)) or len(result) != 2:
        raise ValueError("two results are asked for, T and p; your function gave "
                         f"{_how_many(result)}. End with return T, p")
    T, p = result
    if np.shape(T) in _POINTS and np.shape(p) == (4, 4):
        raise ValueError("T and p have changed places: end with return T, p")
    rows = [[...] * 4] * 4 if is_stub(T) else _matrix(T).tolist()
    return [[*row, x] for row, x in zip(rows, [*([...] * 3 if is_stub(p) else _point(p)), 1.0])]


def _how_many(result: Any) -> str:
    if isinstance(result, (tuple, list)):
        return str(len(result))
    return "one, a matrix" if np.shape(result) == (4, 4) else "one"


def _matrix(T: Any) -> np.ndarray:
    if np.shape(T) != (4, 4):
        raise ValueError(f"T should be a 4x4 matrix; yours is {_size(T)}")
    return inputs.real_array("T", T, "a 4x4 matrix of numbers")


def _point(p: Any) -> np.ndarray:
    """Three numbers, in a row or in a column, with or without the 1 behind them."""
    if np.shape(p) not in _POINTS:
        raise ValueError(f"p should be three numbers; yours is {_size(p)}")
    return inputs.real_array("p", p, "three numbers").ravel()[:3]


def _size(value: Any) -> str:
    shape = np.shape(value)
    return f"a matrix of {shape[0]} x {shape[1]}" if len(shape) == 2 else (
        f"a list of {shape[0]}" if len(shape) == 1 else inputs.brief(value))


_CHAIN_SLIPS: list[Slip] = [
    ("T is right, but p is the origin of frame n: the tool vector is forgotten.",
     partial(_answer, tool=0)),
    ("T is right, but the tool vector is given in frame n: turn it by R before you add it to o.",
     partial(_answer, point=_tool_unturned)),
    ("p lacks the origin of frame n: the fourth number of a point is 1, that of a direction 0.",
     partial(_answer, point=lambda T, tool: (T @ [*tool, 0])[:3])),
    ("p is right, but T reaches to the tip. It should end at frame n, so the tool vector stays "
     "outside.", partial(_answer, tool=0, end=1)),
    ("The tool vector is counted twice: once in T, and once in p.", partial(_answer, end=1)),
    ("p is right, but T is transposed.", lambda *q: np.column_stack(
        [_answer(*q)[:, :4].T, _answer(*q)[:, 4]])),
    (BY_ENTRY, partial(_answer, times=np.multiply)),
    (BY_ENTRY, _from_first_link),
    ("The link matrix is the standard one; the table is modified.",
     partial(_answer, link=_standard)),
    ("The angles arrive in radians; do not convert them.", partial(_answer, link=_in_degrees)),
    ("This is the hint as printed, with the cosine of alpha_i in row 3, column 3. It has to be "
     "that of alpha_(i-1), the alpha of the same row.", _as_printed),
    ("The factors stand in the reverse order: frame 1 comes first, frame n last.",
     partial(_answer, order=-1)),
    ("The last link is missing.", partial(_answer, links=slice(None, -1))),
    ("The first link is missing.", partial(_answer, links=slice(1, None))),
    ("Only the first two rows of the table are used. Take as many as there are.",
     partial(_answer, links=slice(2))),
    ("This is the last link alone: multiply what you have by the next one.",
     partial(_answer, links=slice(-1, None))),
    ("The columns of a row are alpha, a, d, theta, in this order.",
     partial(_answer, link=lambda *row: _M(*row[::-1]))),
]


def _chain_entry(index: tuple) -> str:
    row, column = index
    return f"{'xyz1'[row]} of p_E" if column == 4 else f"the entry of T in {matrix_place(index)}"


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


def _first(psi: Callable) -> Callable:
    """Both branches, with another formula for psi of the first one."""
    def wrong(*angles: float) -> np.ndarray:
        branches = _branches(*angles)
        branches[0, 2] = psi(euler.zyz_matrix(*angles))
        return branches
    return wrong


def _changed(change: Callable, *columns: int, rows: Any = slice(None)) -> Callable:
    """Both branches, with some angles changed in some of them."""
    def wrong(*angles: float) -> np.ndarray:
        branches = _branches(*angles)
        for k in columns:
            branches[rows, k] = change(branches[rows, k])
        return branches
    return wrong


def _quadrant_lost(angle: np.ndarray) -> np.ndarray:
    """What arctan(y / x) makes of the angle that arctan2(y, x) gives."""
    return np.arctan(np.tan(angle))


def _signs_lost(angles: np.ndarray) -> np.ndarray:
    return np.arcsin(np.sin(angles))


_SOME = [(0,), (1,), (2,), (0, 1), (0, 2), (1, 2), (0, 1, 2)]
_ROWS = (slice(None), slice(1), slice(1, None))


_ZYZ_SLIPS = [
    ("psi of the second branch is the printed atan2(-r23, r31). It takes -r32: both of its "
     "entries come from the last row.", _second(lambda R: np.arctan2(-R[1, 2], R[2, 0]))),
    ("psi of the second branch is that of the first. Both signs of its arguments turn round.",
     _second(lambda R: np.arctan2(R[2, 1], -R[2, 0]))),
    ("psi of the first branch is atan2(r32, -r31): the minus is missing.",
     _first(lambda R: np.arctan2(R[2, 1], R[2, 0]))),
    ("psi of the first branch is atan2(r32, -r31): the first argument is y, the second one x.",
     _first(lambda R: np.arctan2(-R[2, 0], R[2, 1]))),
    ("The second branch is the first with theta turned round alone. phi and psi change by half a "
     "turn as well.", lambda *q: _branches(*q)[[0, 0]] * [[1, 1, 1], [1, -1, 1]]),
    ("theta is the same in both branches. In the second its sine is negative: atan2(-s, r33).",
     _changed(np.negative, 1, rows=slice(1, None))),
    ("atan2 takes y first, then x: np.arctan2(r23, r13).", _changed(lambda q: pi / 2 - q, 0)),
    *((f"arctan({y} / {x}) cannot tell opposite directions apart. Take np.arctan2({y}, {x}), which "
       "looks at both signs.", _changed(_quadrant_lost, *some, rows=rows))
      for rows in _ROWS for some in _SOME
      for y, x in [(("r23", "r13"), ("s", "r33"), ("r32", "-r31"))[some[0]]]),
    ("arcsin cannot tell 80° from 100°. Take atan2(s, r33), which knows the cosine, too.",
     _changed(_signs_lost, 1)),
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


def _in_radians(q: np.ndarray) -> str:
    """Degrees would pass otherwise: the angles' sum is zero in any unit."""
    i = int(np.argmax(np.abs(q)))
    return (f"theta_{i + 1} is {q[i]:.4g} rad, more than a full turn."
            if abs(q[i]) > 2 * pi and meet(_POSED, np.radians(q)) else "")


def _straight_up(q: np.ndarray) -> str:
    off = _off_vertical(q)
    return "" if off <= 0.01 else f"z6 is {off:.4g}° away from straight up; 0.01° is allowed."


def _bent(q: np.ndarray) -> str:
    bend = degrees(abs(np.arctan2(np.sin(q[4]), np.cos(q[4]))))
    return "" if 30 <= bend <= 150 else (
        f"theta_5 bends the wrist by {bend:.4g}°; between 30° and 150° are asked for.")


_POSED = (_straight_up, _bent)
_UP = (_in_radians, *_POSED)
_UP_SLIPS = [
    degrees_slip(_POSED),
    ("The sign of theta_5 is wrong.", lambda q: meet(_UP, q * [1, 1, 1, 1, -1, 1])),
    ("It points straight down, where r33 = -1.", lambda q: abs(_off_vertical(q) - 180) < 0.01),
    ("With the wrist straight only theta_2 + theta_3 = 0 is left. Bend the wrist, and let joints "
     "2 and 3 lean the forearm the other way.", lambda q: abs(np.sin(q[4])) < 1e-9),
]

JUDGES: dict[str, Judge] = {
    "n_link.1": function(
        _M, _LINK_CASES, slips=_LINK_SLIPS, entry=matrix_entry,
        praise="This is the practical's link matrix, with its four rows."),
    "n_link.2": function(
        _answer, _ARM_CASES, slips=_CHAIN_SLIPS, entry=_chain_entry, prepare=_task, read=_joined,
        part=lambda index: "p" if index[1] == 4 else "T",
        praise="Your program does what the practical asks for, for two, three and six links."),
    "n_link.3": table(
        _SIX, strict=True, upright=True, slips=_SIX_SLIPS,
        praise="Add a cell with kl.ArmView(my_arm): it is your sketch."),
    "n_link.4": function(
        _branches, _ZYZ_CASES, slips=_ZYZ_SLIPS, entry=_zyz_entry, angles=True,
        prepare=lambda *angles: [euler.zyz_matrix(*angles)],
        part=lambda index: f"the {('first', 'second')[index[0]]} branch",
        without="Write the formulas of section 7 yourself.",
        praise="Both branches, with the printed slip put right."),
    "n_link.5": one_of_many(
        one_pose(_SIX), _UP, slips=_UP_SLIPS,
        praise="The angles are degenerate, the wrist is bent. So the trouble lies in the three "
               "numbers, not in the arm."),
}
