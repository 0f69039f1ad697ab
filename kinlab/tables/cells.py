"""The text of a DH table's cells: read as angles and lengths, and rewritten in another unit.

A number without a unit is in the table's angle unit; where pi stands in it, it is in radians.
"""
from __future__ import annotations

import math
import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction

from ..arms import inputs
from .numbers import LONGEST, read_number

ANGLES = {"deg": math.pi / 180, "rad": 1.0}
MILLIMETRES = {"mm": Decimal(1), "cm": Decimal(10), "m": Decimal(1000), "in": Decimal("25.4")}
LARGEST_ANGLE = 1e4  # rad, some 1,600 turns
SMALLEST_LENGTH, LARGEST_LENGTH = 1e-9, 1e9
_PLAIN = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]{1,3})?")
_PI = re.compile(r"π|\bpi\b")
_PART_OF_PI = re.compile(r"-?([0-9]+\*)?pi(/[0-9]+)?")


def read_angle(text: str, unit: str) -> float:
    """An angle in radians.

    Examples
    --------
    >>> read_angle("-90", "deg") == read_angle("-pi/2", "deg") == read_angle("-90 deg", "rad")
    True
    """
    angle = _angle(text, unit)
    if abs(angle) > LARGEST_ANGLE:
        raise ValueError(f"{inputs.brief(text)}: expected an angle of at most 1,600 turns; "
                         "look for a slip in a unit or an exponent")
    return angle


def read_length(text: str, names: Mapping[str, float] | None = None) -> float:
    """A length in the table's unit; `names` are the lengths given beside.

    Examples
    --------
    >>> read_length("-d2", {"d2": 500})
    -500.0
    """
    length, angle = read_number(text, names)
    if angle:
        raise ValueError(f"{inputs.brief(text)}: expected a length, got an angle; "
                         "leave out deg and rad")
    if abs(length) < SMALLEST_LENGTH and length and not is_plain(text):
        return 0.0  # 177.8*cos(pi/2)
    if length and not SMALLEST_LENGTH <= abs(length) <= LARGEST_LENGTH:
        raise ValueError(f"{inputs.brief(text)}: expected a length from {SMALLEST_LENGTH:g} to "
                         f"{LARGEST_LENGTH:g}, or 0; look for a slip in the exponent")
    return length


def is_plain(text: str) -> bool:
    """Whether the text is one number, such as -177.8."""
    return bool(_PLAIN.fullmatch(text))


def number_text(value: float) -> str:
    """The shortest text of a number.

    Examples
    --------
    >>> number_text(215.0), number_text(0.1778)
    ('215', '0.1778')
    """
    return repr(value + 0.0).removesuffix(".0")


def angle_text(angle: float, unit: str) -> str:
    """The text of an angle given in radians: degrees, or a part of pi where it is one.

    Examples
    --------
    >>> angle_text(-math.pi / 2, "deg"), angle_text(-math.pi / 2, "rad")
    ('-90', '-pi/2')
    """
    if unit == "rad":
        return _part_of_pi(angle) or number_text(angle)
    texts = (f"{math.degrees(angle):.{digits}g}" for digits in range(6, 18))
    return next((number_text(float(text)) for text in texts
                 if math.isclose(float(text) * ANGLES["deg"], angle, rel_tol=1e-15)),
                number_text(math.degrees(angle)))


def angle_in(text: str, old: str, new: str) -> str:
    """The text of the same angle in another unit; what cannot be read stays as it is.

    Examples
    --------
    >>> [angle_in(text, "deg", "rad") for text in ("-90", "2*45", "pi/3")]
    ['-pi/2', '(2*45) deg', 'pi/3']
    """
    try:
        value, has_unit = read_number(text)
    except ValueError:
        return text
    if is_plain(text):
        return angle_text(value * ANGLES[old], new)
    if _PART_OF_PI.fullmatch(text):
        return angle_text(value, new) if new == "deg" else text
    if has_unit or _PI.search(text):
        return text
    longer = f"({text}) {old}"
    return longer if len(longer) <= LONGEST else angle_text(value * ANGLES[old], new)


def length_in(text: str, old: str, new: str, names: Mapping[str, float],
              new_names: Mapping[str, float]) -> str:
    """The text of the same length in another unit; what cannot be read stays as it is.

    Examples
    --------
    >>> length_in("177.8", "mm", "m", {}, {})
    '0.1778'
    >>> length_in("d2 + 100", "mm", "m", {"d2": 500}, {"d2": 0.5})
    '((d2*1000) + 100)/1000'
    """
    if is_plain(text):
        return number_text(float(Decimal(text) * MILLIMETRES[old] / MILLIMETRES[new]))
    value = _length(text, names)
    if value is None:
        return text
    wanted = value * float(MILLIMETRES[old] / MILLIMETRES[new])
    choices = (text, _unwrapped(text, old, new, names), _wrapped(text, old, new, names))
    return next((choice for choice in choices if _means(choice, wanted, new_names)),
                number_text(wanted))


def _angle(text: str, unit: str) -> float:
    value, has_unit = read_number(text)
    return value if has_unit or _PI.search(text) else value * ANGLES[unit]


def _part_of_pi(angle: float) -> str:
    twelfths = round(angle * 12 / math.pi)
    if not twelfths or not math.isclose(angle, twelfths * math.pi / 12, rel_tol=1e-15):
        return ""
    part = Fraction(twelfths, 12)
    times = {1: "pi", -1: "-pi"}.get(part.numerator, f"{part.numerator}*pi")
    return times if part.denominator == 1 else f"{times}/{part.denominator}"


def _length(text: str, names: Mapping[str, float]) -> float | None:
    try:
        value, angle = read_number(text, names)
    except ValueError:
        return None
    return None if angle else value


def _means(text: str, wanted: float, names: Mapping[str, float]) -> bool:
    value = _length(text, names)
    return value is not None and math.isclose(value, wanted, rel_tol=1e-12)


def _ratio(old: str, new: str) -> tuple[str, str]:
    """How a number goes into the new unit, and how it comes back: ('/1000', '*1000')."""
    more = MILLIMETRES[new] / MILLIMETRES[old]
    if more >= 1:
        return f"/{more:f}", f"*{more:f}"
    less = MILLIMETRES[old] / MILLIMETRES[new]
    return f"*{less:f}", f"/{less:f}"


def _wrapped(text: str, old: str, new: str, names: Mapping[str, float]) -> str:
    there, back = _ratio(old, new)
    return f"({_each_name(text, names, lambda name: f'({name}{back})')}){there}"


def _unwrapped(text: str, old: str, new: str, names: Mapping[str, float]) -> str:
    """The text that was wrapped when the unit was changed the other way."""
    there, back = _ratio(old, new)
    inner = text.removesuffix(back)
    for name in names:
        inner = inner.replace(f"({name}{there})", name)
    return inner[1:-1]


def _each_name(text: str, names: Mapping[str, float], write) -> str:
    return re.sub(r"[A-Za-z_][A-Za-z_0-9]*",
                  lambda match: write(match[0]) if match[0] in names else match[0], text)
