"""Judges of the two programs of Practical 3: the link matrix, and the chain of n links."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial, reduce
from math import pi
from typing import Any

import numpy as np

from ..answers.judges import Judge, function, is_stub
from ..arms import kinematics
from ..arms.arm import Arm
from ..arms.link import revolute

# ---- Exercise 1: the link matrix ------------------------------------------------------


def _link(convention: str, alpha: float, a: float, d: float, theta: float) -> np.ndarray:
    arm = Arm([revolute(d=d, a=a, alpha=alpha)], convention=convention)
    return kinematics.forward_kinematics(arm, [theta])


_M, _standard = partial(_link, "modified"), partial(_link, "standard")


def _in_degrees(alpha: float, a: float, d: float, theta: float) -> np.ndarray:
    return _M(alpha * pi / 180, a, d, theta * pi / 180)


def _with(T: np.ndarray, row: int, column: int, value: float) -> np.ndarray:
    T[row, column] = value
    return T


_ROW = ("alpha", "a", "d", "theta")
_LINK_CASES = [dict(zip(_ROW, row)) for row in (
    (0.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.6), (pi / 2, 0.0, -0.5, 0.7), (-0.9, 0.3, 0.4, -0.4))]
_LINK_SLIPS = [
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

# By their number of links: table rows (alpha, a, d) and tool vector.
_ARMS = {
    2: ([(0, 0, 0), (0, 1, 0)], (1, 0, 0)),
    3: ([(0.3, 0.2, 0.1), (-0.5, 0.4, 0.3), (0.9, 0.1, -0.2)], (0.1, 0.2, 0.3)),
    6: ([(0, 0, 0), (pi / 2, 0, -0.5), (0, 0.5, 0), (-pi / 2, 0, 1), (pi / 2, 0, 0),
         (-pi / 2, 0, 0)], (0, 0, 1)),
}
GIVEN, REGULAR = np.radians([[0, 90, -90, 0, 0, 0], [30, 40, -20, 50, 60, 70]])
ARM_CASES = [{f"theta_{i}": float(value) for i, value in enumerate(q, start=1)}
              for q in ((0.5, 0.8), (0.3, -0.6, 1.1), GIVEN, REGULAR)]


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


_CHAIN_SLIPS = [
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


def through(prepare: Callable, judge: Judge, read: Callable = lambda result: result) -> Judge:
    """A judge of functions whose arguments `prepare` makes of a case's numbers."""
    def judged(answer: Any) -> str:
        if not callable(answer):
            return judge(answer)
        return judge(lambda *numbers: read(answer(*prepare(*numbers))))
    return judged


def _entry(index: tuple) -> str:
    row, column = index
    place = f"row {row + 1}, column {column + 1}"
    return f"{'xyz'[row]} of p_E" if column == 4 else f"the entry of T in {place}"


JUDGES = {
    "n_link.1": function(
        _M, _LINK_CASES, slips=_LINK_SLIPS,
        entry=lambda index: f"the entry in row {index[0] + 1}, column {index[1] + 1}",
        praise="This is the practical's link matrix, with its four rows."),
    "n_link.2": through(_task, function(
        _answer, ARM_CASES, slips=_CHAIN_SLIPS, entry=_entry,
        praise="Your program does what the practical asks for, for two, three and six links."),
        read=_joined),
}
