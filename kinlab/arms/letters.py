"""Letters for an arm's numbers: which symbol stands for which number, and what it is worth."""
from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Collection, Iterable, Mapping
from typing import Any

import sympy as sp

from . import inputs
from .arm import CONVENTIONS, Arm
from .link import PARAMETERS, PRISMATIC, REVOLUTE
from .motions import ROTATE, TRANSLATE, Motion
from .notation import plain_name

# A number of the arm: stretch of its chain, and theta, d, a, alpha of a row or x, y, z of an end.
Cell = tuple[int, str]
Values = dict[sp.Symbol, float]

_ROW = {(kind, axis): parameter for kind, axis, parameter in CONVENTIONS["standard"]}
_END = {(kind, axis): letter + "xyz"[axis]
        for kind, letter in ((TRANSLATE, ""), (ROTATE, "r")) for axis in range(3)}
_LENGTHS, _ENDS = ("d", "a"), ("x", "y", "z")
_NAME = re.compile("[A-Za-z][A-Za-z0-9_]*")
_TAKEN = re.compile("[CS][0-9]+|pi|sqrt|sin|cos")  # they mean something else in a formula
_LONGEST, _LARGEST_POWER = 200, 20
_FAITHFUL = 1e-9
_OPERATORS: dict[type, Callable] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
    ast.Pow: operator.pow, ast.UAdd: operator.pos, ast.USub: operator.neg}
_FUNCTIONS: dict[str, Callable] = {"sqrt": sp.sqrt, "sin": sp.sin, "cos": sp.cos}


def letters(arm: Arm, lengths: Any, symbols: Any) -> tuple[dict[Cell, sp.Expr], Values]:
    """What stands for some of the arm's numbers, and the value of each symbol in it.

    `lengths` and `symbols` are those of `closed_form`.
    """
    values: Values = {}
    cells: dict[Cell, sp.Expr] = {}
    if isinstance(lengths, Mapping) and lengths:
        values |= {_symbol("lengths", name): inputs.number(f"lengths[{name!r}]", value)
                   for name, value in lengths.items()}
        cells |= _found(arm, values) if symbols == () else {}
    elif inputs.choice("lengths", lengths, ("numbers", "symbols")) == "symbols":
        cells |= _textbook(arm, _LENGTHS + _ENDS, values)
    if isinstance(symbols, Mapping):
        cells |= _given(arm, symbols, values)
    else:
        cells |= _textbook(arm, _parameters(symbols), values)
    _check_names(arm, {symbol for cell in cells.values() for symbol in cell.free_symbols})
    return cells, values


def joint_symbol(kind: str, i: int) -> sp.Symbol:
    """theta_i for a revolute joint, d_i for a prismatic one."""
    return sp.Symbol(f"theta_{i}" if kind == REVOLUTE else f"d_{i}")


def exact_number(number: float) -> sp.Rational:
    """The number as the decimal that was typed: 177.8 is 889/5."""
    return sp.Rational(repr(float(number)))


def cell_of(arm: Arm, stretch: int, motion: Motion) -> Cell:
    """Which of the arm's numbers a motion of its chain goes by."""
    names = _ROW if 0 < stretch < len(arm.chain) - 1 else _END
    return stretch, names[motion.kind, motion.axis]


def names(arm: Arm) -> dict[Cell, str]:
    """The textbook's name of each number: a_2, or a_1 in row 2 of a modified table."""
    tool, modified, last = len(arm.chain) - 1, arm.convention == "modified", arm.links[-1]
    found = {(end, axis): f"{axis}_{letter}"
             for end, letter in ((0, "B"), (tool, "E")) for axis in _END.values()}
    joints = {joint_symbol(link.kind, i).name for i, link in enumerate(arm.joints, start=1)}
    for row, link in enumerate(arm.links, start=1):
        found |= {(row, parameter): f"{parameter}_{row}" for parameter in PARAMETERS}
        found |= {(row, parameter): f"{parameter}_{row - modified}" for parameter in ("a", "alpha")}
        found |= {(row, parameter): f"offset_{row}" for parameter in PARAMETERS
                  if parameter == link.variable or found[row, parameter] in joints}
    if modified or last.a == 0:
        found[tool, "x"] = f"a_{len(arm.links)}"
    if modified and last.kind != PRISMATIC and last.d == 0:
        found[tool, "z"] = f"d_{len(arm.links)}"
    return found


def _numbers(arm: Arm) -> dict[Cell, float]:
    return {cell_of(arm, stretch, motion): motion.amount
            for stretch, motions in enumerate(arm.chain) for motion in motions}


def _textbook(arm: Arm, parameters: Collection[str], values: Values) -> dict[Cell, sp.Expr]:
    """The textbook's names. A length's is positive, an angle's has its sign; zeros stay."""
    cells, book = {}, names(arm)
    for cell, number in _numbers(arm).items():
        if number and cell[1] in parameters:
            sign = -1 if number < 0 and cell[1] in _LENGTHS + _ENDS else 1
            symbol = sp.Symbol(book[cell])
            cells[cell], values[symbol] = sign * symbol, sign * number
    return cells


def _parameters(symbols: Any) -> list[str]:
    """Some of theta, d, a and alpha."""
    try:
        words = PARAMETERS if symbols == "all" else (
            (symbols,) if isinstance(symbols, str) else tuple(symbols))
    except TypeError:
        raise ValueError("symbols: expected 'all', some of theta, d, a, alpha, or what stands in "
                         f"which cell, got {inputs.brief(symbols)}; write {{(1, 'a'): 'L1'}}"
                         ) from None
    return [inputs.choice("symbols", word, PARAMETERS) for word in words]


def _found(arm: Arm, values: Values) -> dict[Cell, sp.Expr]:
    """Lengths known by their values, either way: 0.5 is L1, -0.5 is -L1."""
    cells: dict[Cell, sp.Expr] = {}
    for cell, number in _numbers(arm).items():
        alike = [sign * symbol for symbol, value in values.items() for sign in (1, -1)
                 if number and number == sign * value]
        if cell[1] not in _LENGTHS + _ENDS or not alike:
            continue
        if len(alike) > 1:
            raise ValueError(f"lengths: both {alike[0]} and {alike[1]} are {number:g}; say which "
                             f"stands where, symbols={{({cell[0]}, {cell[1]!r}): '{alike[0]}'}}")
        cells[cell] = alike[0]
    if not cells:
        raise ValueError("lengths: expected 'numbers' or 'symbols', or names of lengths that the "
                         f"arm has, got {inputs.brief({str(s): v for s, v in values.items()})}")
    return cells


def _given(arm: Arm, symbols: Mapping, values: Values) -> dict[Cell, sp.Expr]:
    """What somebody wrote into cells; the values that follow from it are added to `values`."""
    cells = {_row_cell(arm, cell): _read(text) for cell, text in symbols.items()}
    for cell in sorted(cells, key=lambda cell: len(cells[cell].free_symbols)):
        _agree(cell, cells[cell], getattr(arm.links[cell[0] - 1], cell[1]), values)
    return cells


def _row_cell(arm: Arm, cell: Any) -> Cell:
    rows = range(1, len(arm.links) + 1)
    if not isinstance(cell, tuple) or len(cell) != 2 or cell[0] not in rows \
            or cell[1] not in PARAMETERS:
        raise ValueError(f"symbols: expected cells such as (1, 'a'), rows 1 to {len(arm.links)}, "
                         f"columns {', '.join(PARAMETERS)}, got {inputs.brief(cell)}")
    return int(cell[0]), cell[1]


def _agree(cell: Cell, written: sp.Expr, number: float, values: Values) -> None:
    """Work out a value that is not known yet, and check that the cell says what the arm does."""
    rest = written.subs(values)
    if len(rest.free_symbols) == 1:
        (symbol,) = rest.free_symbols
        slope = rest.diff(symbol)
        if slope.is_number and slope:
            values[symbol] = float((number - rest.subs(symbol, 0)) / slope)
            return
    if rest.free_symbols:
        missing = " and ".join(sorted(map(str, rest.free_symbols)))
        raise ValueError(f"symbols: {written} in row {cell[0]} does not say what {missing} are; "
                         "give their values, lengths={...}")
    if abs(float(rest) - number) > _FAITHFUL * max(1.0, abs(number)):
        raise ValueError(f"symbols: row {cell[0]} has {cell[1]} = {number:.6g}, but {written} is "
                         f"{float(rest):.6g}; correct one of them")


def _read(text: Any) -> sp.Expr:
    """A cell's text, such as 2*L1 + 0.1, as an expression; nothing is evaluated as code."""
    if isinstance(text, sp.Expr):
        return text
    try:
        if not isinstance(text, str) or len(text) > _LONGEST or not text.isprintable():
            raise SyntaxError
        return _expression(ast.parse(text.strip(), mode="eval").body)
    except (SyntaxError, KeyError, TypeError, MemoryError, RecursionError):
        raise ValueError("symbols: expected names and numbers with + - * / **, such as '2*L1', "
                         f"got {inputs.brief(text)}") from None


def _expression(node: ast.AST) -> sp.Expr:
    match node:
        case ast.Constant(value=int() | float()) if not isinstance(node.value, bool):
            return exact_number(inputs.number("symbols", node.value))
        case ast.Name(id="pi"):
            return sp.pi
        case ast.Name():
            return _symbol("symbols", node.id)
        case ast.UnaryOp():
            return _OPERATORS[type(node.op)](_expression(node.operand))
        case ast.BinOp(op=ast.Pow(), right=ast.Constant(value=int(power))) \
                if power <= _LARGEST_POWER:
            return _within_reason(_expression(node.left) ** power)
        case ast.BinOp() if not isinstance(node.op, ast.Pow):
            return _within_reason(
                _OPERATORS[type(node.op)](_expression(node.left), _expression(node.right)))
        case ast.Call(func=ast.Name(id=name), args=[argument], keywords=[]):
            return _FUNCTIONS[name](_expression(argument))
    raise SyntaxError


def _within_reason(expression: sp.Expr) -> sp.Expr:
    """Not divided by zero, and not so large that the next power would take for ever."""
    if expression.has(sp.zoo, sp.nan) or (
            expression.is_number and not abs(float(expression)) <= inputs.LARGEST):
        raise SyntaxError
    return expression


def _symbol(argument: str, name: Any) -> sp.Symbol:
    if not isinstance(name, str) or not _NAME.fullmatch(name) or _TAKEN.fullmatch(name):
        raise ValueError(f"{argument}: {inputs.brief(name)} cannot stand for a number; "
                         "use letters and digits, such as L1")
    return sp.Symbol(name)


def _check_names(arm: Arm, symbols: Iterable[sp.Symbol]) -> None:
    """A name that reads like a joint's variable would say two things."""
    variables = {plain_name(joint_symbol(link.kind, i).name): i
                 for i, link in enumerate(arm.joints, start=1)}
    for symbol in symbols:
        if joint := variables.get(plain_name(symbol.name)):
            raise ValueError(f"symbols: {symbol} is the variable of joint {joint}; "
                             "take another name")

