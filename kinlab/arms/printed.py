"""A DH table on paper: its rows as text, its lines, its HTML, and the pattern of its signs."""
from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import accumulate
from typing import Protocol

from .link import FIXED, Link

# The columns as each convention's books print them; a modified row i holds a and alpha of i-1.
HEADS = {"standard": {"theta": "θ", "d": "d", "a": "a", "alpha": "α"},
         "modified": {"alpha": "α(i-1)", "a": "a(i-1)", "d": "d", "theta": "θ"}}
_ANGLES = ("theta", "alpha")


class HasKind(Protocol):
    """A row of a table, as numbers or as typed."""

    @property
    def kind(self) -> str: ...


def number_rows(links: Sequence[Link], convention: str) -> list[list[str]]:
    """A header and one row per joint: degrees and lengths, with * behind the joint variable."""
    return _rows(links, HEADS[convention], _number)


def sign_rows(links: Sequence[Link]) -> list[list[str]]:
    """The table with only the signs of its numbers; * marks the joint variable.

    Examples
    --------
    >>> from kinlab import robots
    >>> for row in sign_rows(robots.exam_2018().links):
    ...     print(*row)
    i θ d a α
    1 * + 0 +
    2 *+ + + +
    3 + * 0 0
    """
    return _rows(links, HEADS["standard"], _sign)


def title(name: str, convention: str, unit: str) -> str:
    """What stands above a table; `name` may be empty."""
    start = f"{name}: " if name else ""
    return f"{start}{convention} DH, lengths in {unit}, * marks the joint variable"


def lines(rows: Sequence[Sequence[str]], words: int | None = None) -> list[str]:
    """Rows of text, one under the other, each column as wide as it must be.

    Numbers end at the right; column number `words`, if there is one, begins at the left.
    """
    widths = [max(map(len, column)) for column in zip(*rows)]
    return ["  ".join(cell.ljust(w) if k == words else cell.rjust(w)
                      for k, (cell, w) in enumerate(zip(row, widths))) for row in rows]


def html(rows: Sequence[Sequence[str]], start: str = "<table>") -> str:
    """Rows of HTML as a table that begins with `start`; the first row is its header."""
    head, *body = (_tagged(row, cell) for row, cell in zip(rows, ["th", *["td"] * len(rows)]))
    return f"{start}<thead>{head}</thead><tbody>{''.join(body)}</tbody></table>"


def _tagged(row: Sequence[str], tag: str) -> str:
    return f"<tr>{''.join(f'<{tag}>{cell}</{tag}>' for cell in row)}</tr>"


def _rows(links: Sequence[Link], heads: Mapping[str, str],
          cell: Callable[[Link, str, int], str]) -> list[list[str]]:
    return [["i", *heads.values()]] + [
        [str(i), *(cell(link, parameter, joint) for parameter in heads)]
        for i, (link, joint) in enumerate(zip(links, joint_numbers(links)), start=1)]


def joint_numbers(links: Sequence[HasKind]) -> list[int]:
    """The number of each row's joint, from 1; a fixed row has that of the joint before it."""
    return list(accumulate(int(link.kind != FIXED) for link in links))


def _number(link: Link, parameter: str, i: int) -> str:
    value = getattr(link, parameter) + 0.0  # no -0
    text = f"{math.degrees(value):.6g}°" if parameter in _ANGLES else _length(value)
    if parameter != link.variable:
        return text
    variable = f"{'-' * link.flip}{HEADS['standard'][parameter]}{i}*"
    return f"{variable} {'-' if value < 0 else '+'} {text.lstrip('-')}" if value else variable


def _length(value: float) -> str:
    """Six digits, or all before the point: 1234567, not 1.23457e+06."""
    return f"{value:.0f}" if abs(value) >= 1e6 else f"{value:.6g}"


def _sign(link: Link, parameter: str, _: int) -> str:
    value = getattr(link, parameter)
    sign = "+" if value > 0 else "−" if value < 0 else "0"
    if parameter != link.variable:
        return sign
    star = "−*" if link.flip else "*"
    return f"{star}{sign}" if value else star
