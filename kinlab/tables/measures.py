"""The units and the named lengths in the cells of a table that was read."""
from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from .cells import ANGLES, MILLIMETRES, angle_in, is_plain, length_in
from .headings import UNITS
from .numbers import name_refused

_MEASURE = re.compile(r"([-+]?\s?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)\s?"
                      r"[\[(]?(mm|cm|m|in|inch|inches|meters?|metres?)[\])]?")
_ANGLE_UNIT = re.compile(r"(?<=[\w).]) ?[\[(]?(deg|rad)(?:ree|ian)?s?[\])]?(?![A-Za-z])")
_DEGREES = re.compile(r"([-+]?)\s?([0-9.]+) deg")
_NAME = re.compile(r"(?<![\w.])[A-Za-z_][A-Za-z_0-9]*")  # 1e3 has none
_TIMES = re.compile(r"(?<![\w.])([0-9]+(?:\.[0-9]+)?)\s?(?=[A-DF-Za-df-z]_?[A-Za-z0-9])")
_NOT_LENGTHS = re.compile(r"(?:pi|deg|rad|sqrt|sin|cos|(?:theta|q|t|th)_?[0-9]*)")


def unit_of(text: str) -> str:
    """The unit behind a length's number, or "".

    Examples
    --------
    >>> unit_of("100 mm"), unit_of("0.1"), unit_of("2*L1")
    ('mm', '', '')
    """
    match = _MEASURE.fullmatch(text)
    return UNITS[match[2]] if match else ""


def length_text(text: str, of_column: str, of_table: str) -> str:
    """A length in the table's unit; `of_column` is the unit of a number without one."""
    match = _MEASURE.fullmatch(text)
    number, unit = (match[1].replace(" ", ""), UNITS[match[2]]) if match else (text, of_column)
    text = _TIMES.sub(r"\1*", number)
    both = unit in MILLIMETRES and of_table in MILLIMETRES and unit != of_table
    return length_in(text, unit, of_table, {}, {}) if both and is_plain(text) else text


def angle_of(text: str, of_column: str, of_table: str) -> str:
    """An angle as a table in the unit `of_table` holds it.

    Examples
    --------
    >>> angle_of("-90°", "deg", "deg"), angle_of("-90°", "rad", "rad"), angle_of("90", "deg", "rad")
    ('-90', '-pi/2', 'pi/2')
    """
    text = " ".join(_ANGLE_UNIT.sub(r" \1 ", text.replace("°", " deg ")).split())
    if match := _DEGREES.fullmatch(text):
        return angle_in(match[1].strip("+") + match[2], "deg", of_table) if of_table == "rad" \
            else match[1].strip("+") + match[2]
    return angle_in(text, of_column, of_table) if of_column != of_table in ANGLES else text


def with_names(texts: Sequence[str], known: Iterable[str]) -> tuple[list[str], list[str]]:
    """Lengths with the names that are known, however they are written, and the others they name.

    Examples
    --------
    >>> with_names(["a_2", "L1 + d4"], ["a2"])
    (['a2', 'L1 + d4'], ['L1', 'd4'])
    """
    by_form = {_form(name): name for name in known}
    others: dict[str, str] = {}

    def named(match: re.Match[str]) -> str:
        name, form = match[0], _form(match[0])
        if _NOT_LENGTHS.fullmatch(name) or name_refused(name):
            return name
        return by_form.get(form) or others.setdefault(form, _shorter(name))

    return [_NAME.sub(named, text) for text in texts], list(others.values())


def _shorter(name: str) -> str:
    """d1 for d_1."""
    return re.sub(r"(?<=[A-Za-z])_(?=[0-9]+$)", "", name)


def value_of(name: str, named: Mapping[str, str]) -> str:
    """What the words around a table say a length is; "" if they do not."""
    return next((text for other, text in named.items() if _form(other) == _form(name)), "")


def _form(name: str) -> str:
    return name.replace("_", "").lower()
