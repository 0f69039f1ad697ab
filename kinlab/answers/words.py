"""Numbers and shapes in the words of a message."""
from __future__ import annotations

from collections.abc import Sequence

_WORDS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
          "eleven", "twelve")
NOTHING = 1e-12  # what is nearer to zero is rounding


def counted(n: int, noun: str) -> str:
    """A number of things.

    Examples
    --------
    >>> counted(3, "number"), counted(1, "row")
    ('three numbers', 'one row')
    """
    word = _WORDS[n] if n < len(_WORDS) else str(n)
    return f"{word} {noun}{'s' * (n != 1)}"


def of_shape(shape: tuple[int, ...]) -> str:
    """What an array of a shape holds.

    Examples
    --------
    >>> of_shape((3,)), of_shape((2, 4)), of_shape(())
    ('three numbers', 'two rows of four numbers', 'one number')
    """
    if len(shape) > 2:
        return f"an array of shape {shape}"
    numbers = counted(shape[-1] if shape else 1, "number")
    return numbers if len(shape) < 2 else f"{counted(shape[0], 'row')} of {numbers}"


def plain(value: float, digits: int = 6) -> str:
    """A number as people write it: no minus before zero, and no rounding noise for it.

    Examples
    --------
    >>> plain(1.2e-16), plain(-0.0), plain(0.1234567)
    ('0', '0', '0.123457')
    """
    return f"{0.0 if abs(value) < NOTHING else float(value) + 0.0:.{digits}g}"


def fixed(value: float, decimals: int = 3) -> str:
    """A number with so many decimals, and no minus before zero.

    Examples
    --------
    >>> fixed(-0.0001), fixed(2.5)
    ('0.000', '2.500')
    """
    return f"{round(float(value), decimals) + 0.0:.{decimals}f}"


def apart(a: float, b: float) -> tuple[str, str]:
    """Two numbers, with as many digits as it takes to tell them apart.

    Examples
    --------
    >>> apart(1.0, 1.00000012), apart(0.5, 6e-17)
    (('1', '1.00000012'), ('0.5', '0'))
    """
    for digits in (6, 9, 12):
        one, other = plain(a, digits), plain(b, digits)
        if one != other:
            break
    return one, other


def listed(names: Sequence[str], most: int = 4) -> str:
    """Names in a sentence.

    Examples
    --------
    >>> listed(["c_0", "d_1"]), listed("abcdef")
    ('c_0 and d_1', 'a, b, c, d and 2 more')
    """
    if len(names) > most:
        return f"{', '.join(names[:most])} and {len(names) - most} more"
    return " and ".join(filter(None, [", ".join(names[:-1]), *names[-1:]]))


def to_do(names: Sequence[str]) -> str:
    """That things are still to do.

    Examples
    --------
    >>> to_do(["o_10"])
    'o_10 is still to do'
    """
    return f"{listed(names)} {'is' if len(names) == 1 else 'are'} still to do"


def right_but(right: Sequence[str], missing: Sequence[str]) -> str:
    """What there is to say where all that is there is right.

    Examples
    --------
    >>> right_but(["c_0", "d_1"], ["o_10"])
    'c_0 and d_1 are right; o_10 is still to do.'
    """
    start = (f"{listed(right)} {'is' if len(right) == 1 else 'are'} right" if len(right) < 5
             else "What is there is right")
    return f"{start}; {to_do(missing)}."
