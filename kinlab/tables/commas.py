"""Decimal commas and commas between thousands in the cells of a table."""
from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from .question import Ambiguous

_COMMA = re.compile(r"(?<![0-9.,])([0-9]{0,9}),([0-9]{1,15})(?![0-9,])(\.[0-9])?")
_GROUPS = re.compile(r"(?<![0-9.,])[0-9]{1,3}(?:,[0-9]{3})+(?![0-9])")
_POINTS = re.compile(r"(?<![0-9.,])([0-9]{1,3})\.([0-9]{3})(?=,[0-9])")


def reader_of_commas(cells: Iterable[str], decimal: str | None) -> Callable[[str], str]:
    """What makes points of the decimal commas in a table's cells, and drops other commas.

    Raises
    ------
    Ambiguous
        If all that is there looks like 1,250: the comma may part the thousands or the decimals.

    Examples
    --------
    >>> reader_of_commas(["1,5", "0,250"], None)("-0,250")
    '-0.250'
    >>> reader_of_commas(["1,250", "0.5"], None)("1,250")
    '1250'
    """
    texts = [cell for cell in cells if "," in cell or "." in cell]
    if not any("," in text for text in texts):
        return lambda text: text
    found = [match for text in texts for match in _COMMA.finditer(_POINTS.sub(r"\1\2", text))]
    decimal = decimal or _decimal(texts, found)
    if decimal == ",":
        return lambda text: _COMMA.sub(r"\1.\2", _POINTS.sub(r"\1\2", text))
    return lambda text: _GROUPS.sub(lambda group: group[0].replace(",", ""), text)


def _decimal(texts: list[str], found: list[re.Match[str]]) -> str:
    if any(len(match[2]) != 3 or match[1] in ("", "0") or len(match[1]) > 3 for match in found
           if not match[3]):
        return ","
    if not found or any("." in text for text in texts) or any(
            _GROUPS.search(text) and text.count(",") > 1 for text in texts):
        return "."
    example = found[0][0]
    raise Ambiguous(f"Is {example} a decimal number, or are these thousands?",
                    ((f"decimal: {example.replace(',', '.')}", {"decimal": ","}),
                     (f"thousands: {example.replace(',', '')}", {"decimal": "."})))
