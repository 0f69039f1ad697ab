"""Angles that were meant as parts of pi and came rounded: 1.5708 is pi/2.

Nothing here changes an arm's numbers. A formula is written with the angle that was meant, and
says so; advice names it.
"""
from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache

PRECISE = 1e-12  # rad: what the arithmetic of doubles leaves of a part of pi
SINGLE = 5e-7    # rad: what single precision, or seven digits of a turn, leave of it
LARGEST = 1e4    # rad, some 1,600 turns; in larger numbers parts of pi lie everywhere
_DIGITS = 7      # decimals after which SINGLE takes over


def plain_angle(angle: float) -> Fraction | None:
    """The multiple of pi that an angle stands for, if it is one of 15°, rounded or not.

    An angle counts as rounded where its digits are those of such a multiple, rounded or cut off
    behind the third decimal or a later one: 1.0472 and 1.047 are pi/3, 1.05 is not. Quarter turns
    are recognised from two decimals on, as 1.57. Fewer than one in a hundred numbers with so many
    decimals looks so by chance. A multiple worked out from a rounded pi, or from a rounded degree
    of 0.01745 or 57.3, counts too: 3.14159/2, 90*0.0174533, 90/57.3.

    Examples
    --------
    >>> [str(plain_angle(angle)) for angle in (1.5708, -2.094, math.radians(30), 1.5)]
    ['1/2', '-2/3', '1/6', 'None']
    """
    if not abs(angle) <= LARGEST:
        return None
    twelfths = round(abs(angle) * 12 / math.pi)
    if abs(abs(angle) - twelfths * math.pi / 12) > SINGLE and not any(
            abs(abs(angle) - rounded) <= PRECISE * (1 + rounded) for rounded in _rounded(twelfths)):
        return None
    return Fraction(twelfths if angle > 0 else -twelfths, 12)


def looks_rounded(angle: float) -> bool:
    """True for an angle that stands for a multiple of 15° and is not one."""
    return bool(meant(angle))


def meant(angle: float) -> str:
    """What a rounded angle was meant to be, as it is typed; nothing for any other.

    Examples
    --------
    >>> meant(-1.5708), meant(-math.pi / 2), meant(1.5)
    ('-pi/2', '', '')
    """
    multiple = plain_angle(angle)
    if multiple is None or abs(angle - multiple * math.pi) <= PRECISE:
        return ""
    return pi_text(multiple)


def pi_text(multiple: Fraction) -> str:
    """A multiple of pi as it is typed.

    Examples
    --------
    >>> [pi_text(Fraction(twelfths, 12)) for twelfths in (6, -12, 8, -3, 0)]
    ['pi/2', '-pi', '2*pi/3', '-pi/4', '0']
    """
    if not multiple:
        return "0"
    times = {1: "pi", -1: "-pi"}.get(multiple.numerator, f"{multiple.numerator}*pi")
    return times if multiple.denominator == 1 else f"{times}/{multiple.denominator}"


@lru_cache(maxsize=256)
def _rounded(twelfths: int) -> tuple[float, ...]:
    """What becomes of a multiple of 15° where it, or what it is worked out from, is rounded."""
    if not twelfths:
        return ()
    part, degrees = twelfths / 12, 15 * twelfths
    return (*_shortened(part * math.pi, 3 if twelfths % 6 else 2),
            *(part * pi for pi in _shortened(math.pi, 2)),
            *(degrees * degree for degree in _shortened(math.radians(1), 5)),
            *(degrees / radian for radian in _shortened(math.degrees(1), 1)))


def _shortened(exact: float, fewest: int) -> Iterator[float]:
    """The number rounded and cut off behind each of its decimals, from the fewest allowed on."""
    for decimals in range(fewest, _DIGITS + 1):
        scale = 10 ** decimals
        for whole in {round(exact * scale), math.floor(exact * scale)}:
            if whole % 10 or decimals > fewest:  # 5.760 is typed as 5.76
                yield whole / scale
