"""Closed forms of an arm's matrices, exact and in textbook notation.

The frame recurrence of `motions` is followed with symbols for the joints. Angles that stand for
multiples of pi/12 (`rounded`) are taken as those, lengths as the decimals they were typed as.
"""
from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from math import prod
from numbers import Integral
from typing import Any

import sympy as sp

from . import inputs, notation
from .arm import Arm, check_arm
from .kinematics import tool_and_twists
from .letters import cell_of, exact_number, joint_symbol, letters, names
from .motions import ROTATE, Motion, follow, keep_whole, matrix
from .rounded import looks_rounded, meant, plain_angle

# Beside the arm's size, or beside 1 in a direction: what rounding leaves of nothing.
NEGLIGIBLE = 1e-12
# Products in one entry of a Jacobian: with more it is not multiplied out, nobody could read it.
MOST_TERMS = 100
LONG = 5_000  # products in an entry: with more, seconds become minutes


@dataclass(frozen=True, eq=False)
class ClosedForm:
    """A homogeneous matrix, or a Jacobian, in closed form.

    Attributes
    ----------
    matrix : sympy.Matrix, shape (4, 4), or (6, n) for a Jacobian
    joints : tuple of sympy.Symbol
        All joint variables of the arm, theta_i (rad) or d_i (length), in order.
    lengths : dict
        The value of each other symbol (length or rad); empty when numbers stand in the matrix.
    remark : str
        One line on angles that look rounded, and as what they are taken; empty if there are none.
    text, latex : str
        The matrix in textbook notation: ``C1`` is cos(theta_1), ``S23`` is sin(theta_2 + theta_3).
    entries : tuple of tuple of str
        The text entry by entry.
    """

    matrix: sp.Matrix
    joints: tuple[sp.Symbol, ...]
    lengths: dict[sp.Symbol, float]
    remark: str = ""

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
        return f"{self.text}\n{self.remark}".rstrip()

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex}$\n\n{self.remark}".rstrip()


def closed_form(arm: Arm, start: int = 0, stop: int | None = None, *,
                lengths: str | Mapping[str, float] = "numbers",
                symbols: str | Collection[str] | Mapping[tuple[int, str], Any] = ()) -> ClosedForm:
    """The matrix T_start^stop of a stretch of the chain, exactly, as a function of the joints.

    Parameters
    ----------
    arm : Arm
    start, stop : int
        Frames 0 to n. ``start=0`` begins in the room (the base included, as in
        `link_frames`); leaving `stop` out ends at the tool, as `forward_kinematics` does.
    lengths : {"numbers", "symbols"} or {name: length}
        "symbols" writes a_i and d_i for the arm's lengths (of positive value: -0.5 in row 2
        becomes -d_2). Row i of a modified table holds a_{i-1}. A tool along x or z of the last
        frame takes the free names a_n, d_n; other tool and base lengths are x_E, ..., z_B.
        Names of your own with their lengths stand where the arm has just that length:
        ``{"L1": 0.5}``.
    symbols : "all", some of {"theta", "d", "a", "alpha"}, or {(row, parameter): text}
        Further numbers to write as symbols. "alpha" writes alpha_i for all twists that are not
        zero, "theta" theta_i or, where the joint turns, offset_i. To say what stands in which
        cell of the table, give its row and parameter, and a text or a sympy expression:
        ``{(1, "a"): "L1", (2, "a"): "2*L1", (1, "alpha"): "beta"}``. Values follow from the arm,
        or are given as `lengths`.

    Returns
    -------
    ClosedForm

    Raises
    ------
    ValueError
        If the frames are not 0 <= start <= stop <= n, or names and cells do not fit the arm.

    Examples
    --------
    >>> from kinlab import revolute, robots
    >>> closed_form(robots.alpha_ii()).entries[0][3]
    'C1*(177.8*C2 + 177.8*C23 - 129.5*S234)'
    >>> closed_form(robots.alpha_ii(), 3, 5, lengths="symbols").entries[0][3]
    '-d5*S4'
    >>> closed_form(Arm([revolute(alpha=0.7)]), symbols="alpha").entries[0]
    ('C1', '-S1*cos(alpha1)', 'S1*sin(alpha1)', '0')

    A typed 1.5708 counts as pi/2, and the form says so:

    >>> print(closed_form(Arm([revolute(a=2, alpha=1.5708)])))
    [C1, 0, S1 , 2*C1]
    [S1, 0, -C1, 2*S1]
    [0 , 1, 0  , 0]
    [0 , 0, 0  , 1]
    alpha1 = 1.5708 looks rounded: it is taken as pi/2.
    """
    check_arm(arm)
    chain = _exact_chain(arm, _stretch(arm, start, stop), lengths, symbols)
    frame = matrix(follow(chain.motions, chain.joints)).astype(object)
    _say_how_long(frame.flat)
    return chain.form(sp.Matrix(keep_whole(frame)[0]), range(3), [3])


def jacobian_form(arm: Arm, *, lengths: str | Mapping[str, float] = "numbers",
                  symbols: str | Collection[str] | Mapping[tuple[int, str], Any] = ()
                  ) -> ClosedForm:
    """The geometric Jacobian of the tool point, exactly, as a function of the joints.

    Parameters
    ----------
    arm : Arm
    lengths, symbols
        As in `closed_form`.

    Returns
    -------
    ClosedForm
        Its matrix has rows [v; w] in base axes and one column per joint, as in `jacobian`. Entries
        are multiplied out unless they become very long.

    Examples
    --------
    >>> from kinlab import robots
    >>> jacobian_form(robots.two_link(), lengths="symbols").entries[0]
    ('-a1*S1 - a2*S12', '-a2*S12')
    """
    check_arm(arm)
    chain = _exact_chain(arm, slice(0, len(arm.chain)), lengths, symbols)
    tool, twists = tool_and_twists(chain.motions, chain.joints)
    _say_how_long(tool.origin)
    position = [_multiplied_out(component) for component in tool.origin]
    columns = [[*(component.diff(joint) for component in position),
                *map(_multiplied_out, twist[3:])]
               for joint, twist in zip(chain.joints, twists)]
    return chain.form(sp.Matrix(columns).T, range(3), range(len(columns)))


def exact_angle(angle: float) -> sp.Expr:
    """The angle as a multiple of pi/12 if it stands for one, rounded or not, else as a float."""
    multiple = plain_angle(angle)
    return sp.Float(angle) if multiple is None else sp.Rational(multiple) * sp.pi


def exact_length(length: float) -> sp.Expr:
    """The length as the decimal that was typed: 177.8 is 889/5."""
    return exact_number(length)


@dataclass(frozen=True)
class _Chain:
    """Joint symbols and exact motions of some stretches of an arm, and what they stand for."""

    joints: tuple[sp.Symbol, ...]
    motions: list[Motion]
    lengths: dict[sp.Symbol, float]
    remark: str
    size: float

    def form(self, entries: sp.Matrix, rows: Collection[int], columns: Collection[int]
             ) -> ClosedForm:
        """The closed form of a matrix which has lengths in some rows and columns."""
        tidy = sp.Matrix(*entries.shape, lambda i, j: _without_noise(
            entries[i, j], self.size if i in rows and j in columns else 1.0))
        return ClosedForm(tidy, self.joints, self.lengths, self.remark)


def _exact_chain(arm: Arm, stretches: slice, lengths: Any, symbols: Any) -> _Chain:
    cells, values = letters(arm, lengths, symbols)
    size = max((abs(motion.amount) for motions in arm.chain for motion in motions
                if motion.kind != ROTATE), default=0.0) or 1.0
    moves = [(cell_of(arm, stretch, motion), motion)
             for stretch in range(len(arm.chain))[stretches] for motion in arm.chain[stretch]]
    motions = [replace(motion, amount=cells.get(cell, _exact(motion, size)))
               for cell, motion in moves]
    used = {symbol for cell, _ in moves for symbol in cells.get(cell, sp.S.Zero).free_symbols}
    rounded = {names(arm)[cell]: motion.amount for cell, motion in moves
               if cell not in cells and motion.kind == ROTATE and looks_rounded(motion.amount)}
    joints = tuple(joint_symbol(link.kind, i) for i, link in enumerate(arm.joints, start=1))
    return _Chain(joints, motions, {s: value for s, value in values.items() if s in used},
                  _remark(rounded), size)


def _exact(motion: Motion, size: float) -> sp.Expr:
    if motion.kind == ROTATE:
        return exact_angle(motion.amount)
    return exact_length(motion.amount) if abs(motion.amount) > NEGLIGIBLE * size else sp.S.Zero


def _remark(rounded: Mapping[str, float]) -> str:
    """Which angles look rounded, and as what they are taken."""
    if not rounded:
        return ""
    *more, last = (f"{name.replace('_', '')} = {angle:.10g}" for name, angle in rounded.items())
    taken = [meant(angle) for angle in rounded.values()]
    if not more:
        return f"{last} looks rounded: it is taken as {taken[0]}."
    return f"{', '.join(more)} and {last} look rounded: they are taken as {', '.join(taken)}."


def _multiplied_out(component: Any) -> sp.Expr:
    """A sum of products, unless there would be too many to read."""
    component = sp.sympify(component)
    return sp.expand(component) if _products(component) <= MOST_TERMS else component


def _say_how_long(entries: Iterable[Any]) -> None:
    """A word before a formula that takes minutes; the work can be interrupted."""
    longest = max(_products(sp.sympify(entry)) for entry in entries)
    if longest > LONG:
        inputs.note(f"this formula has entries of {longest} products, writing it takes minutes; "
                    "a stretch of the chain is shorter: kl.closed_form(arm, start, stop)")


@lru_cache(maxsize=4096)
def _products(expression: sp.Expr) -> int:
    """How many products the expression becomes at most when it is multiplied out."""
    if expression.is_Add:
        return sum(map(_products, expression.args))
    if expression.is_Mul:
        return prod(map(_products, expression.args))
    return 1


def _without_noise(expression: sp.Expr, size: float) -> sp.Expr:
    """The expression without terms that are nothing beside numbers of this size."""
    if not expression.has(sp.Float):
        return expression
    kept = []
    for term in sp.Add.make_args(expression):
        factors = sp.Mul.make_args(term)
        scale = 1.0 if any(factor.is_Symbol for factor in factors) else size
        weight = abs(float(sp.Mul(*(factor for factor in factors if factor.is_number))))
        if weight > NEGLIGIBLE * scale:
            kept.append(sp.Mul(*(_without_noise(factor, scale / weight) if factor.is_Add else factor
                                 for factor in factors)))
    return sp.Add(*kept)


def _stretch(arm: Arm, start: int, stop: int | None) -> slice:
    """Stretches of `arm.chain` from frame start to frame stop."""
    last = len(arm.links)
    end = last if stop is None else stop
    if not all(isinstance(k, Integral) for k in (start, end)) or not 0 <= start <= end <= last:
        raise ValueError(f"start, stop: expected frames 0 <= start <= stop <= {last}, "
                         f"got start={inputs.brief(start)}, stop={inputs.brief(stop)}")
    return slice(start + 1 if start else 0, None if stop is None else end + 1)
