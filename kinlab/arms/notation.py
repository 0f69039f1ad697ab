"""Textbook notation for expressions in the joints: C1*(177.8*C2 + 177.8*C23 - 129.5*S234).

C1 is cos(theta_1), S23 is sin(theta_2 + theta_3). Terms follow the chain from base to tool, a
factor that all terms share goes in front. Short fractions and roots stay as they are, all other
numbers are decimals of up to twelve digits.
"""
from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from decimal import Decimal, localcontext
from functools import lru_cache, reduce

import sympy as sp

DIGITS = 12  # of decimals; on paper those of sines and cosines of odd angles have fewer
_LARGEST_WHOLE = 999  # in a fraction or a root that still tells more than its decimal


@dataclass(frozen=True)
class Style:
    """How the parts of an expression are put on paper; `other` writes what is none of them."""

    times: str
    subscript: str
    group: str
    power: str
    function: str
    digits: int
    name: Callable[[str], str]
    other: Callable[[sp.Expr], str]

    def symbol(self, letter: str, index: str) -> str:
        return letter + self.subscript.format(index) if index else letter


def plain_name(name: str) -> str:
    """a_1 and x_E without the line below; a name of somebody's own as it was given."""
    return re.sub("_([0-9]+|[A-Z])$", r"\1", name)


def _latex_name(name: str) -> str:
    """The first word of a name, with what follows it lowered: L1, L_1 and L_off."""
    word, index = re.findall("^([A-Za-z]*)_?(.*)$", name, re.DOTALL)[0]
    letter = sp.latex(sp.Symbol(word)) if word else ""
    return letter + (f"_{{{index.replace('_', ',')}}}" if index else "")


TEXT = Style(times="*", subscript="{}", group="({})", power="{}**{}", function="{}({})",
             digits=DIGITS, name=plain_name, other=sp.sstr)
LATEX = Style(times=" ", subscript="_{{{}}}", group=r"\left({}\right)", power="{}^{{{}}}",
              function=r"\{}{{\left({} \right)}}", digits=6, name=_latex_name, other=sp.latex)


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
        self.written: dict[sp.Expr, str] = {}  # groups come again and again in a long entry

    def sum(self, expression: sp.Expr) -> str:
        if expression not in self.written:
            self.written[expression] = self._sum(expression)
        return self.written[expression]

    def _sum(self, expression: sp.Expr) -> str:
        terms = sp.Add.make_args(expression)
        shared = reduce(set.intersection, (set(_factors(term)) for term in terms))
        if len(terms) > 1 and shared:
            inner = sp.Add(*(sp.Mul(*(f for f in sp.Mul.make_args(term) if f not in shared))
                             for term in terms))
            return self._term(sp.Mul(*shared, inner, evaluate=False))
        pure = all(abs(_constant(term)) == 1 and not any(f.is_Symbol for f in _factors(term))
                   for term in terms)
        order = (lambda term: (-_degree(term), self._term_order(term))) if pure \
            else self._term_order
        return " + ".join(map(self._term, sorted(terms, key=order))).replace("+ -", "- ")

    def _term(self, term: sp.Expr) -> str:
        coefficient = _constant(term)
        factors = [self._factor(f) for f in sorted(_factors(term), key=self._factor_order)]
        sign, number = "-" if coefficient < 0 else "", self._number(abs(coefficient))
        if number != "1" or not factors:
            factors.insert(0, number)
        return sign + self.style.times.join(factors)

    def _factor(self, factor: sp.Expr) -> str:
        if isinstance(factor, (sp.cos, sp.sin)):
            return self._trig(factor)
        if isinstance(factor, sp.Symbol):
            return self.style.name(factor.name)
        if isinstance(factor, sp.Add):
            return self.style.group.format(self.sum(factor))
        if isinstance(factor, sp.Pow) and factor.exp.is_Integer:
            return self.style.power.format(self._factor(factor.base), factor.exp)
        return self.style.other(factor)

    def _trig(self, function: sp.Function) -> str:
        letter, places = type(function).__name__[0].upper(), self._places(function)
        if not places:
            return self.style.function.format(type(function).__name__, self._angle(function))
        signs = [sign for _, sign in places]
        if all(sign > 0 for sign in signs):
            joiner = "," if len(self.places) > 9 else ""  # C12 there is cos(theta_12)
            return self.style.symbol(letter, joiner.join(str(place) for place, _ in places))
        index = "".join(f"{'+' if sign > 0 else '-'}{place}" for place, sign in places)
        return self.style.symbol(letter, f"({index.lstrip('+')})")

    def _angle(self, function: sp.Function) -> str:
        """The argument written out: theta_1 + 0.3."""
        terms = [term.as_coeff_Mul() for term in sp.Add.make_args(function.args[0])]
        terms.sort(key=lambda term: (not term[1].free_symbols, term[1] not in self.places,
                                     str(term[1])))
        return " + ".join(self._part(*term) for term in terms).replace("+ -", "- ")

    def _part(self, number: sp.Expr, angle: sp.Expr) -> str:
        """One term of an angle: a multiple of a variable or of pi, or a number."""
        if angle is sp.pi:
            return self.style.other(number * angle)
        if angle is sp.S.One:
            return self._decimal(number)
        if not angle.is_Symbol:
            return self.style.other(number * angle)
        name = self.style.other(angle) if angle in self.places else self.style.name(angle.name)
        return {1: name, -1: f"-{name}"}.get(number) or (
            self._decimal(number) + self.style.times + name)

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
        if number is sp.S.One:
            return "1"
        wholes = [whole for part in number.atoms(sp.Rational) for whole in (part.p, part.q)]
        if number.has(sp.Float) or _is_decimal(number) or any(
                abs(whole) > _LARGEST_WHOLE for whole in wholes):
            return self._decimal(number)
        written = self.style.other(number)
        return self.style.group.format(written) if number.is_Add else written

    def _decimal(self, number: sp.Expr) -> str:
        """A number as a decimal, without an exponent."""
        with localcontext(prec=self.style.digits if number.has(sp.Float) else DIGITS):
            return f"{(+Decimal(str(sp.N(number, 2 * DIGITS)))).normalize():f}"

    def _factor_order(self, factor: sp.Expr) -> tuple:
        """Lengths, then sines and cosines along the chain, then sliding joints, then groups."""
        if isinstance(factor, (sp.cos, sp.sin)):
            return (1, self._along(factor), isinstance(factor, sp.sin), _ByText(factor))
        if factor in self.places:
            return (2, [(self.places[factor], 1)], False)
        return (3 if isinstance(factor, sp.Add) else 0, [], _ByText(factor))

    def _along(self, function: sp.Function) -> list[tuple[int, int]]:
        """The joints in the argument, those of no joint behind all others."""
        angle = function.args[0]
        return (self._places(function) or
                sorted((self.places[s], 1) for s in angle.free_symbols if s in self.places) or
                [(len(self.places) + 1, 1)])

    def _term_order(self, term: sp.Expr) -> tuple:
        """Along the chain: by the last length in the term, then by its sines and cosines."""
        trig = sorted(key for key in map(self._factor_order, _factors(term)) if key[0])
        return self._last_length(term), trig, bool(_factors(term)), _ByText(term)

    def _last_length(self, term: sp.Expr) -> int:
        """The highest row in a textbook's name; names of base and tool count behind all rows."""
        indices = [f.name.partition("_")[2] for f in _factors(term) if f.is_Symbol]
        return max((int(index) if index.isdigit() else len(self.places) + 1
                    for index in indices if index), default=0)


class _ByText:
    """Sorts an expression by sympy's text of it, written only where a tie asks for it: slow."""

    def __init__(self, expression: sp.Expr) -> None:
        self.expression = expression

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _ByText) and self.expression == other.expression

    def __lt__(self, other: _ByText) -> bool:
        return _sympy_text(self.expression) < _sympy_text(other.expression)


@lru_cache(maxsize=16384)
def _sympy_text(expression: sp.Expr) -> str:
    return str(expression)


@lru_cache(maxsize=16384)
def _factors(term: sp.Expr) -> tuple[sp.Expr, ...]:
    return tuple(factor for factor in sp.Mul.make_args(term) if not factor.is_number)


@lru_cache(maxsize=16384)
def _constant(term: sp.Expr) -> sp.Expr:
    """The number in front of a term: -177.8, or sqrt(3)/2 for an angle of 30 degrees."""
    return sp.expand(sp.Mul(*(factor for factor in sp.Mul.make_args(term) if factor.is_number)))


def _degree(expression: sp.Expr) -> int:
    """How many factors the longest product in the expression has."""
    return max(sum(_degree(f) if isinstance(f, sp.Add) else 1 for f in _factors(term))
               for term in sp.Add.make_args(expression))


def _is_decimal(number: sp.Expr) -> bool:
    return number.is_Rational and set(sp.factorint(number.q)) <= {2, 5}
