"""The text of a DH table's cells: read as angles and lengths, and rewritten in another unit.

A number without a unit is in the table's angle unit; where pi stands in it, it is in radians.
"""
from __future__ import annotations

import math
import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from typing import Any

from ..arms import inputs
from ..arms.rounded import pi_text, plain_angle
from .numbers import LONGEST, read_number, scales_with_pi

ANGLES = {"deg": math.pi / 180, "rad": 1.0}
MILLIMETRES = {"mm": Decimal(1), "cm": Decimal(10), "m": Decimal(1000), "in": Decimal("25.4")}
LARGEST_ANGLE = 1e4  # rad, some 1,600 turns
LARGEST_RADIANS = 6.3  # of a plain number in a table in radians, some one turn; more is unlikely
SMALLEST_LENGTH, LARGEST_LENGTH = 1e-9, 1e9
_PLAIN = re.compile(r"[-+]?([0-9]+(?:\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]{1,3})?")
_PI = re.compile(r"π|\b(?:pi|atan|arctan)\b")  # what holds these is in radians
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


def angle_hint(text: str, unit: str) -> str:
    """What an angle without a unit may have been meant to be, in a table in the other unit; or "".

    Examples
    --------
    >>> angle_hint("-1.5708", "deg"), angle_hint("90", "rad"), angle_hint("45", "deg")
    ('did you mean -pi/2?', 'did you mean 90 deg?', '')
    """
    if not is_plain(text) or not abs(value := float(text)) <= LARGEST_ANGLE:
        return ""
    if unit == "rad":
        return f"did you mean {text} deg?" if abs(value) > LARGEST_RADIANS else ""
    part = plain_angle(value) if "." in text else None
    return f"did you mean {pi_text(part)}?" if part else ""


def is_plain(text: str) -> bool:
    """Whether the text is one number, such as -177.8."""
    return bool(_PLAIN.fullmatch(text))


def line(text: Any) -> str:
    """Text without line breaks and other characters that a cell cannot show."""
    if not isinstance(text, str) or len(text) > LONGEST:
        raise ValueError(f"text: expected text of at most {LONGEST} characters, "
                         f"got {inputs.brief(text)}")
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())


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

    So does what scales with its names, such as -d2. Any other formula becomes its value.

    Examples
    --------
    >>> length_in("177.8", "mm", "m", {}, {})
    '0.1778'
    >>> [length_in(text, "mm", "m", {"d2": 500}, {"d2": 0.5}) for text in ("-d2", "d2 + 100")]
    ['-d2', '0.6']
    """
    if is_plain(text):
        return number_text(float(Decimal(text) * MILLIMETRES[old] / MILLIMETRES[new]))
    value, unchanged = _length(text, names), _length(text, new_names)
    if value is None:
        return text
    wanted = value * float(MILLIMETRES[old] / MILLIMETRES[new])
    if unchanged is not None and math.isclose(unchanged, wanted, rel_tol=1e-12):
        return text
    return number_text(float(f"{wanted:.15g}"))  # 0.6, not 0.6000000000000001


def _angle(text: str, unit: str) -> float:
    value, has_unit = read_number(text)
    if has_unit or not _PI.search(text):
        return value if has_unit else value * ANGLES[unit]
    if unit == "deg" and not scales_with_pi(text):
        raise ValueError(f"{inputs.brief(text)}: pi is in radians and other numbers are in "
                         "degrees; write pi/2 rad + 90 deg, or write pi as 180")
    return value


def _part_of_pi(angle: float) -> str:
    twelfths = round(angle * 12 / math.pi)
    if not twelfths or not math.isclose(angle, twelfths * math.pi / 12, rel_tol=1e-15):
        return ""
    return pi_text(Fraction(twelfths, 12))


def _length(text: str, names: Mapping[str, float]) -> float | None:
    try:
        return read_length(text, names)
    except ValueError:
        return None
