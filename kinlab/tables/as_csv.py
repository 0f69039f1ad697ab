"""DH tables as CSV: what a spreadsheet opens, and what it saves."""
from __future__ import annotations

import csv
import io

from .ends import ENDS
from .table import COLUMNS, DHTable

_OTHERS = ("low", "high", "home", "name")  # columns that are left out where all is empty


def to_csv(table: DHTable) -> str:
    """The table as CSV: what it is, named lengths, a header, and one line per joint.

    Examples
    --------
    >>> from .table import Row
    >>> print(to_csv(DHTable((Row(a="1"),))), end="")
    convention,standard
    angles,deg
    lengths,m
    joint,theta,d,a,alpha
    revolute,0,0,1,0
    """
    flips = ["flip"] * any(row.flip for row in table.rows)
    columns = [*COLUMNS[:4], *other_columns(table)]
    rows = [[row.kind, *["-" * row.flip for _ in flips],
             *(getattr(row, column) for column in columns)] for row in table.rows]
    return "".join(map(csv_line, [*settings(table), ["joint", *flips, *columns], *rows]))


def settings(table: DHTable) -> list[list[str]]:
    """What a table is besides its rows: a word each, and what it says."""
    lines = [["name", table.name]] * bool(table.name)
    lines += [["convention", table.convention], ["angles", table.angles], ["lengths", table.unit]]
    lines += [["length", *pair] for pair in table.lengths]
    frames = ((end, getattr(table, end)) for end in ENDS)
    return lines + [[end, *frame.words] for end, frame in frames if frame]


def other_columns(table: DHTable) -> list[str]:
    """The columns besides theta, d, a and alpha in which something stands."""
    return [column for column in _OTHERS if any(getattr(row, column) for row in table.rows)]


def csv_line(cells: list[str]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(cells)
    return text.getvalue()
