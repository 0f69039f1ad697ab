"""Closed forms of an arm's matrices, exact and in textbook notation.

The frame recurrence of `motions` is followed with symbols for the joints. Angles that are
multiples of pi/12 within 1e-12 are taken as exact, lengths as the decimals they were typed as.
"""
from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from numbers import Integral
from typing import Any

import sympy as sp

from . import inputs, notation
from .arm import Arm, check_arm
from .kinematics import tool_and_twists
from .link import REVOLUTE
from .motions import ROTATE, Motion, X, Y, Z, follow, keep_whole, matrix


@dataclass(frozen=True, eq=False)
class ClosedForm:
    """A homogeneous matrix, or a Jacobian, in closed form.

    Attributes
    ----------
    matrix : sympy.Matrix, shape (4, 4), or (6, n) for a Jacobian
    joints : tuple of sympy.Symbol
        All joint variables of the arm, theta_i (rad) or d_i (length), in order.
    lengths : dict
        The value of each length symbol; empty when numbers stand in the matrix.
    text, latex : str
        The matrix in textbook notation: ``C1`` is cos(theta_1), ``S23`` is sin(theta_2 + theta_3).
    entries : tuple of tuple of str
        The text entry by entry.
    """

    matrix: sp.Matrix
    joints: tuple[sp.Symbol, ...]
    lengths: dict[sp.Symbol, float]

    @cached_property
    def entries(self) -> tuple[tuple[str, ...], ...]:
        return tuple(tuple(notation.text(entry, self.joints) for entry in self.matrix.row(i))
                     for i in range(self.matrix.rows))

    @property
    def text(self) -> str:
        widths = [max(map(len, column)) for column in zip(*self.entries)]
        return "\n".join("[" + ", ".join(e.ljust(w) for e, w in zip(row, widths)).rstrip() + "]"
                         for row in self.entries)

    @property
    def latex(self) -> str:
        rows = (" & ".join(notation.latex(entry, self.joints) for entry in self.matrix.row(i))
                for i in range(self.matrix.rows))
        return r"\begin{bmatrix}" + r" \\ ".join(rows) + r"\end{bmatrix}"

    def __repr__(self) -> str:
        return self.text

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex}$"


def closed_form(arm: Arm, start: int = 0, stop: int | None = None, *,
                lengths: str = "numbers") -> ClosedForm:
    """The matrix T_start^stop of a stretch of the chain, exactly, as a function of the joints.

    Parameters
    ----------
    arm : Arm
    start, stop : int
        Frames 0 to n. ``start=0`` begins in the room (the base included, as in
        `link_frames`); leaving `stop` out ends at the tool, as `forward_kinematics` does.
    lengths : {"numbers", "symbols"}
        "symbols" writes a_i and d_i for the arm's lengths (of positive value: -0.5 in row 2
        becomes -d_2). Row i of a modified table holds a_{i-1}. A tool along x or z of the last
        frame takes the free names a_n, d_n; other tool and base lengths are x_E, ..., z_B.

    Returns
    -------
    ClosedForm

    Raises
    ------
    ValueError
        If the frames are not 0 <= start <= stop <= n, or `lengths` is another word.

    Examples
    --------
    >>> from kinlab import robots
    >>> closed_form(robots.alpha_ii()).entries[0][3]
    'C1*(177.8*C2 + 177.8*C23 - 129.5*S234)'
    >>> closed_form(robots.alpha_ii(), 3, 5, lengths="symbols").entries[0][3]
    '-d5*S4'
    """
    check_arm(arm)
    joints, motions, values = _exact_chain(arm, *_stretch(arm, start, stop), lengths)
    frame = follow(motions, joints)
    return ClosedForm(sp.Matrix(keep_whole(matrix(frame).astype(object))[0]), joints, values)


def jacobian_form(arm: Arm, *, lengths: str = "numbers") -> ClosedForm:
    """The geometric Jacobian of the tool point, exactly, as a function of the joints.

    Parameters
    ----------
    arm : Arm
    lengths : {"numbers", "symbols"}
        As in `closed_form`.

    Returns
    -------
    ClosedForm
        Its matrix has rows [v; w] in base axes and one column per joint, as in `jacobian`.

    Examples
    --------
    >>> from kinlab import robots
    >>> jacobian_form(robots.two_link(), lengths="symbols").entries[0]
    ('-a1*S1 - a2*S12', '-a2*S12')
    """
    check_arm(arm)
    joints, motions, values = _exact_chain(arm, 0, arm.n + 2, lengths)
    _, twists = tool_and_twists(motions, joints)
    columns = [[_pythagoras(component) for component in twist] for twist in twists]
    return ClosedForm(sp.Matrix(columns).T, joints, values)


def joint_symbol(kind: str, i: int) -> sp.Symbol:
    """theta_i for a revolute joint, d_i for a prismatic one."""
    return sp.Symbol(f"theta_{i}" if kind == REVOLUTE else f"d_{i}")


def exact_angle(angle: float) -> sp.Expr:
    """The angle as a multiple of pi/12 if it is one within 1e-12, else as a float."""
    twelfths = round(angle * 12 / math.pi)
    exact = abs(angle - twelfths * math.pi / 12) <= 1e-12
    return sp.Rational(twelfths, 12) * sp.pi if exact else sp.Float(angle)


def exact_length(length: float) -> sp.Expr:
    """The length as the decimal that was typed: 177.8 is 889/5."""
    return sp.Rational(repr(float(length)))


def _exact_chain(arm: Arm, first: int, last: int, lengths: str) -> tuple[tuple, list, dict]:
    """Joint symbols, the exact motions of a slice of `arm.chain`, and the lengths' values."""
    inputs.choice("lengths", lengths, ("numbers", "symbols"))
    joints = tuple(joint_symbol(link.kind, i) for i, link in enumerate(arm.links, start=1))
    names = _length_names(arm) if lengths == "symbols" else {}
    values: dict[sp.Symbol, float] = {}
    motions = [_exact(motion, names.get((part, motion.axis)), values)
               for part in range(first, last) for motion in arm.chain[part]]
    return joints, motions, values


def _pythagoras(component: Any) -> sp.Expr:
    """Multiplied out, with sin^2 written as 1 - cos^2: all squares of a cross product cancel."""
    squares = lambda e: e.is_Pow and e.exp == 2 and isinstance(e.base, sp.sin)  # noqa: E731
    expanded = sp.expand(sp.sympify(component))
    return sp.expand(expanded.replace(squares, lambda e: 1 - sp.cos(e.base.args[0]) ** 2))


def _stretch(arm: Arm, start: int, stop: int | None) -> tuple[int, int]:
    """Slice of `arm.chain` from frame start to frame stop."""
    end = arm.n if stop is None else stop
    if not all(isinstance(k, Integral) for k in (start, end)) or not 0 <= start <= end <= arm.n:
        raise ValueError(f"start, stop: expected frames 0 <= start <= stop <= {arm.n}, "
                         f"got start={inputs.brief(start)}, stop={inputs.brief(stop)}")
    return (start + 1 if start else 0), (arm.n + 2 if stop is None else end + 1)


def _exact(motion: Motion, name: str | None, values: dict[sp.Symbol, float]) -> Motion:
    if motion.kind == ROTATE:
        return replace(motion, amount=exact_angle(motion.amount))
    if not name or not motion.amount:
        return replace(motion, amount=exact_length(motion.amount))
    symbol = sp.Symbol(name)
    values[symbol] = abs(motion.amount)
    return replace(motion, amount=symbol if motion.amount > 0 else -symbol)


def _length_names(arm: Arm) -> dict[tuple[int, int], str]:
    """The textbook's name for each length, by stretch of the chain and axis of the slide."""
    tool, modified, last = arm.n + 1, arm.convention == "modified", arm.links[-1]
    names = {(end, axis): f"{'xyz'[axis]}_{letter}"
             for end, letter in ((0, "B"), (tool, "E")) for axis in (X, Y, Z)}
    for i, link in enumerate(arm.links, start=1):
        names[i, X] = f"a_{i - modified}"
        names[i, Z] = f"d_{i}" if link.kind == REVOLUTE else f"offset_{i}"
    if modified or last.a == 0:
        names[tool, X] = f"a_{arm.n}"
    if modified and last.kind == REVOLUTE and last.d == 0:
        names[tool, Z] = f"d_{arm.n}"
    return names
