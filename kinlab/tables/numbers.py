"""Numbers as a student types them: read through a whitelist, never evaluated as code."""
from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Callable, Mapping
from keyword import iskeyword
from typing import Any

from ..arms import inputs

LONGEST = 200  # characters; what is longer is no number in a table
LARGEST_POWER = 100
_UNITS = {"deg": math.pi / 180, "rad": 1.0}
_FUNCTIONS = {"sqrt": math.sqrt, "sin": math.sin, "cos": math.cos, "atan": math.atan,
              "arctan": math.atan}
_ARCS = ("atan", "arctan")
_RESERVED = {"pi", *_UNITS, *_FUNCTIONS}
_OPERATORS: dict[type[ast.operator], Callable[[float, float], float]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
    ast.Div: operator.truediv, ast.Pow: operator.pow}
_SIGNS: dict[type[ast.unaryop], Callable[[float], float]] = {
    ast.UAdd: operator.pos, ast.USub: operator.neg}
# What keyboards, word processors and other programs write for the same signs.
_SPELLINGS = {"°": " deg ", "º": " deg ", "π": " pi ", "−": "-", "–": "-", "×": "*", "·": "*",
              "^": "**", "θ": "theta", "ϑ": "theta"}
_JOINT = re.compile(r"(?:q|theta)_?[0-9]{0,3}")
_TOKEN = re.compile(r"\s*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)"
                    r"|(?P<name>[A-Za-z_][A-Za-z_0-9]*)|(?P<sign>\*\*|[-+*/()]))")


def parse_number(text: str, names: Mapping[str, float] | None = None) -> float:
    """The number that a student typed.

    Numbers, pi, named lengths, ``+ - * / **``, brackets, ``sqrt sin cos atan``, and the units
    ``deg``, ``°`` and ``rad`` behind what they belong to. Degrees become radians; a number without
    a unit stays as it is. Nothing is evaluated as code.

    Parameters
    ----------
    text : str
        At most 200 characters.
    names : {name: number}, optional
        Lengths that may stand in the text, such as ``{"d2": 500}``.

    Returns
    -------
    float
        Finite, at most 1e100. ``90 deg`` is the same double as ``pi/2``.

    Raises
    ------
    ValueError
        With the reason in one line, whatever was typed.

    Examples
    --------
    >>> parse_number("-90 deg"), parse_number("pi/2"), parse_number("177.8")
    (-1.5707963267948966, 1.5707963267948966, 177.8)
    >>> parse_number("-d2", {"d2": 500})
    -500.0
    """
    return read_number(text, names)[0]


def read_number(text: str, names: Mapping[str, float] | None = None) -> tuple[float, bool]:
    """The number that `parse_number` gives, and whether it carries an angle's unit."""
    if not isinstance(text, str):
        raise ValueError(f"text: expected text, got {inputs.brief(text)}; put it in quotes")
    if len(text) > LONGEST:
        raise ValueError(f"text: expected at most {LONGEST} characters, got {len(text)}; "
                         "work part of it out first")
    known = _known({} if names is None else names)
    try:
        value, angle = _value(ast.parse(_spelled(text, known), mode="eval").body, known)
        _refuse_if(not abs(value) <= inputs.LARGEST, "it is too large")
    except _UNREADABLE as error:
        reason = _REASONS.get(type(error), "look for a missing operator or bracket")
        raise ValueError(f"{inputs.brief(text)}: expected a number such as -90 deg, pi/2 or 177.8; "
                         f"{reason or error}") from None
    return value + 0.0, angle  # no -0.0


def scales_with_pi(text: str) -> bool:
    """Whether a formula that can be read is a multiple of pi, so that all of it is in radians.

    Examples
    --------
    >>> scales_with_pi("-3*pi/2"), scales_with_pi("pi/2 + 90")
    (True, False)
    """
    known = _known({})
    formula = ast.parse(_spelled(text, known), mode="eval").body
    try:
        once, twice = (_value(formula, {**known, "pi": turn})[0] for turn in (math.pi, 2 * math.pi))
    except _UNREADABLE:
        return False
    return math.isclose(twice, 2 * once, rel_tol=1e-12, abs_tol=1e-12)


def name_refused(name: Any) -> str:
    """Why a length cannot be called so, or ""."""
    match = _TOKEN.fullmatch(name) if isinstance(name, str) else None
    if match and match["name"] == name and not iskeyword(name) and name not in _RESERVED:
        return ""
    return f"{inputs.brief(name)} cannot be a length's name; use letters and digits, such as d2"


def names_in(text: str) -> set[str]:
    """The names that stand in a text.

    Examples
    --------
    >>> sorted(names_in("2*L1 + d2"))
    ['L1', 'd2']
    """
    return set(re.findall(r"[A-Za-z_][A-Za-z_0-9]*", text))


def in_python(text: str, names: Mapping[str, float]) -> str:
    """A text that can be read, in the spelling of Python; whole numbers stay whole.

    Examples
    --------
    >>> in_python("−2·L1^2", {"L1": 0.5})
    '- 2 * L1 ** 2'
    """
    tokens = _spelled(text, _known(names)).split()
    return " ".join(token.removesuffix(".0") for token in tokens)


class _Refused(Exception):
    """Why the text is no number."""


_REASONS: dict[type[Exception], str] = {
    OverflowError: "it is too large", ZeroDivisionError: "it divides by zero", _Refused: ""}
_UNREADABLE: tuple[type[Exception], ...] = (*_REASONS, SyntaxError, MemoryError, RecursionError)


def _refuse_if(condition: bool, reason: str) -> None:
    if condition:
        raise _Refused(reason)


def _known(names: Mapping[str, float]) -> dict[str, float]:
    """The values of all names that may stand in the text."""
    if not isinstance(names, Mapping):
        raise ValueError(f"names: expected names with their lengths, got {inputs.brief(names)}; "
                         "write {'d2': 500}")
    if reason := next(filter(None, map(name_refused, names)), ""):
        raise ValueError(f"names: {reason}")
    return {name: inputs.number(f"names[{name!r}]", value)
            for name, value in names.items()} | {"pi": math.pi} | _UNITS


def _spelled(text: str, known: Mapping[str, float]) -> str:
    """The text as tokens that Python's grammar reads as the student meant them."""
    for written, meant in _SPELLINGS.items():
        text = text.replace(written, meant)
    text, tokens, position, before = text.rstrip(), [], 0, ""
    _refuse_if(not text, "the cell is empty")
    while position < len(text):
        match = _TOKEN.match(text, position)
        if not match:
            strange = inputs.brief(text[position:].lstrip()[0])
            raise _Refused("write the decimal point as . and not as ," if strange == "','"
                           else f"{strange} has no place in a number")
        kind = str(match.lastgroup)  # one of the three always
        position, token = match.end(), match[kind]
        tokens.append(_read(token, kind, before, known))
        before = token
    return " ".join(tokens)


def _read(token: str, kind: str, before: str, known: Mapping[str, float]) -> str:
    ended = before[-1:] == ")" or before[-1:].isalnum() or before[-1:] in tuple("._")
    if kind == "number":
        _refuse_if(math.isinf(float(token)), "it is too large")
        return repr(float(token))  # also 007, which Python's grammar refuses
    if kind == "name":
        _refuse_if(token not in known | _FUNCTIONS.keys(), _unknown(token, known))
        _refuse_if(token in _UNITS and not ended, f"put a number before {token}")
    _refuse_if(ended and token not in _UNITS and (kind == "name" or token == "(")
               and before not in _FUNCTIONS, f"put an operator before {token}")
    return f"* {token}" if token in _UNITS else token


def _unknown(name: str, known: Mapping[str, float]) -> str:
    if _JOINT.fullmatch(name):
        return (f"leave {name} out: each row has a joint variable of its own, "
                "and its cell holds only the offset")
    return f"{inputs.brief(name)} is not known; known are {', '.join(known)}"


def _value(node: ast.AST, known: Mapping[str, float]) -> tuple[float, bool]:
    """The value of a part, and whether it carries an angle's unit."""
    match node:
        case ast.Constant(value=float(number)):
            return number, False
        case ast.Name() if node.id in known:
            return known[node.id], node.id in _UNITS
        case ast.UnaryOp():
            value, angle = _value(node.operand, known)
            return _SIGNS[type(node.op)](value), angle
        case ast.BinOp():
            return _combined(node.op, _value(node.left, known), _value(node.right, known))
        case ast.Call(func=ast.Name(id=name), args=[argument], keywords=[]):
            value, angle = _value(argument, known)
            root = name == "sqrt"
            _refuse_if(root and angle, "an angle has no square root")
            _refuse_if(root and value < 0, "a root of a negative number is not real")
            turn = known["pi"] / math.pi if name in _ARCS else 1.0  # as pi, arcs are in radians
            return _FUNCTIONS[name](value) * turn, False
    raise _Refused("write a function with its argument in brackets, such as sqrt(2)")


def _combined(op: ast.operator, left: tuple, right: tuple) -> tuple[float, bool]:
    (a, a_angle), (b, b_angle) = left, right
    if isinstance(op, ast.Add | ast.Sub):
        _refuse_if(a_angle != b_angle, "give every angle of the sum its unit: deg or rad")
    else:
        _refuse_if(b_angle and (a_angle or not isinstance(op, ast.Mult)),
                   "an angle may be multiplied or divided only by a number")
    if isinstance(op, ast.Pow):
        _refuse_if(a_angle or abs(b) > LARGEST_POWER,
                   f"expected a power of a number, up to {LARGEST_POWER}")
        _refuse_if(a < 0 and b != int(b), "a root of a negative number is not real")
    value = _OPERATORS[type(op)](a, b)
    _refuse_if(not abs(value) <= inputs.LARGEST, "it is too large")  # nor is it nan
    return value, a_angle or b_angle
