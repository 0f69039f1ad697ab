"""Textbook notation for expressions in the joints: C1*(177.8*C2 + 177.8*C23 - 129.5*S234).

C1 is cos(theta_1), S23 is sin(theta_2 + theta_3). Terms follow the chain from base to tool, a
factor that all terms share goes in front, exact decimals are written as decimals.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal, localcontext
from functools import lru_cache, reduce

import sympy as sp


@dataclass(frozen=True)
class Style:
    """How the parts of an expression are put on paper."""

    times: str
    subscript: str
    group: str
    power: str
    fraction: str

    def symbol(self, letter: str, index: str) -> str:
        return letter + self.subscript.format(index) if index else letter


TEXT = Style(times="*", subscript="{}", group="({})", power="{}**{}", fraction="{}/{}")
LATEX = Style(times=" ", subscript="_{{{}}}", group=r"\left({}\right)", power="{}^{{{}}}",
              fraction=r"\frac{{{}}}{{{}}}")


def text(expression: sp.Expr, joints: Sequence[sp.Symbol]) -> str:
    """The expression as plain text, such as 'C1*C234*C5 + S1*S5'."""
    return _Writer(TEXT, joints).sum(sp.sympify(expression))


def latex(expression: sp.Expr, joints: Sequence[sp.Symbol]) -> str:
    """The expression as LaTeX, such as 'C_{1} C_{234} C_{5} + S_{1} S_{5}'."""
    return _Writer(LATEX, joints).sum(sp.sympify(expression))


class _Writer:
    def __init__(self, style: Style, joints: Sequence[sp.Symbol]) -> None:
        self.style = style
        self.places = {joint: i for i, joint in enumerate(joints, start=1)}

    def sum(self, expression: sp.Expr) -> str:
        terms = sp.Add.make_args(expression)
        shared = reduce(set.intersection, (set(_factors(term)) for term in terms))
        if len(terms) > 1 and shared:
            inner = sp.Add(*(sp.Mul(*(f for f in sp.Mul.make_args(term) if f not in shared))
                             for term in terms))
            return self._term(sp.Mul(*shared, inner, evaluate=False))
        pure = all(abs(_constant(term)) == 1 and not self._last_length(term)
                   for term in terms)
        order = (lambda term: (-_degree(term), self._term_order(term))) if pure \
            else self._term_order
        return " + ".join(map(self._term, sorted(terms, key=order))).replace("+ -", "- ")

    def _term(self, term: sp.Expr) -> str:
        coefficient = _constant(term)
        factors = [self._factor(f) for f in sorted(_factors(term), key=self._factor_order)]
        sign = "-" if coefficient < 0 else ""
        if abs(coefficient) != 1 or not factors:
            factors.insert(0, self._number(abs(coefficient)))
        return sign + self.style.times.join(factors)

    def _factor(self, factor: sp.Expr) -> str:
        if isinstance(factor, (sp.cos, sp.sin)):
            return self._trig(factor)
        if isinstance(factor, sp.Symbol):
            return self.style.symbol(*factor.name.partition("_")[::2])
        if isinstance(factor, sp.Add):
            return self.style.group.format(self.sum(factor))
        if isinstance(factor, sp.Pow) and factor.exp.is_Integer:
            return self.style.power.format(self._factor(factor.base), factor.exp)
        return sp.latex(factor) if self.style is LATEX else sp.sstr(factor)

    def _trig(self, function: sp.Function) -> str:
        letter, places = type(function).__name__[0].upper(), self._places(function)
        if not places:
            return sp.latex(function) if self.style is LATEX else sp.sstr(function)
        signs = [sign for _, sign in places]
        if all(sign > 0 for sign in signs):
            joiner = "," if len(self.places) > 9 else ""  # C12 there is cos(theta_12)
            return self.style.symbol(letter, joiner.join(str(place) for place, _ in places))
        index = "".join(f"{'+' if sign > 0 else '-'}{place}" for place, sign in places)
        return self.style.symbol(letter, f"({index.lstrip('+')})")

    def _places(self, function: sp.Function) -> list[tuple[int, int]]:
        """(joint number, sign) of each angle in the argument; empty if it is not such a sum."""
        places = []
        for term in sp.Add.make_args(function.args[0]):
            sign, angle = term.as_coeff_Mul()
            if abs(sign) != 1 or angle not in self.places:
                return []
            places.append((self.places[angle], int(sign)))
        return sorted(places)

    def _number(self, number: sp.Expr) -> str:
        if number.has(sp.Float):
            return f"{float(number):.6g}"
        if not number.is_Rational:
            surd = sp.latex(number) if self.style is LATEX else sp.sstr(number)
            return self.style.group.format(surd) if number.is_Add else surd
        if set(sp.factorint(number.q)) <= {2, 5}:
            return _decimal(number) if number.q <= 10**9 else f"{float(number):.12g}"
        return self.style.fraction.format(number.p, number.q)

    def _factor_order(self, factor: sp.Expr) -> tuple:
        """Lengths, then sines and cosines along the chain, then sliding joints, then groups."""
        if isinstance(factor, (sp.cos, sp.sin)):
            return (1, self._places(factor), isinstance(factor, sp.sin))
        if factor in self.places:
            return (2, [(self.places[factor], 1)], False)
        return (3 if isinstance(factor, sp.Add) else 0, [], _ByText(factor))

    def _term_order(self, term: sp.Expr) -> tuple:
        """Along the chain: by the last length in the term, then by its sines and cosines."""
        trig = sorted(key for key in map(self._factor_order, _factors(term)) if key[0])
        return self._last_length(term), trig, _ByText(term)

    def _last_length(self, term: sp.Expr) -> int:
        names = [f.name for f in _factors(term) if isinstance(f, sp.Symbol)]
        return max((int(index) if index.isdigit() else len(self.places) + 1
                    for index in (name.partition("_")[2] for name in names)), default=0)


class _ByText:
    """Sorts an expression by sympy's text of it, written only where a tie asks for it: slow."""

    def __init__(self, expression: sp.Expr) -> None:
        self.expression = expression

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _ByText) and self.expression == other.expression

    def __lt__(self, other: _ByText) -> bool:
        return str(self.expression) < str(other.expression)


@lru_cache(maxsize=1024)
def _factors(term: sp.Expr) -> tuple[sp.Expr, ...]:
    return tuple(factor for factor in sp.Mul.make_args(term) if not factor.is_number)


@lru_cache(maxsize=1024)
def _constant(term: sp.Expr) -> sp.Expr:
    """The number in front of a term: -177.8, or sqrt(3)/2 for an angle of 30 degrees."""
    return sp.expand(sp.Mul(*(factor for factor in sp.Mul.make_args(term) if factor.is_number)))


def _degree(expression: sp.Expr) -> int:
    """How many factors the longest product in the expression has."""
    return max(sum(_degree(f) if isinstance(f, sp.Add) else 1 for f in _factors(term))
               for term in sp.Add.make_args(expression))


def _decimal(number: sp.Rational) -> str:
    with localcontext(prec=40):
        return f"{(Decimal(int(number.p)) / Decimal(int(number.q))).normalize():f}"
