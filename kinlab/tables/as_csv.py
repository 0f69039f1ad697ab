"""DH tables as CSV: what a spreadsheet opens, and what it saves."""
from __future__ import annotations

import csv
import io
import re

from ..arms.link import PARAMETERS
from .ends import ENDS
from .table import LIMITS, RATES, DHTable

_OTHERS = (*LIMITS, *RATES, "name")  # columns that are left out where all is empty
# A spreadsheet works out what begins with such a sign, and may ask the network or run a command.
# An apostrophe before it makes it text. Sums of numbers and names, such as -d2, do no harm.
_WORKED_OUT = re.compile("'*[=+@\uff1d\uff0b\uff20\uff0d-]")
_SUM = re.compile(r"[-+](?:[-+*/^.()\s°]|(?!\w+\s*\()\w+|(?:sqrt|sin|cos|a(?:rc)?tan)\s*\()*+")


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
    columns = [*PARAMETERS, *other_columns(table)]
    rows = [[row.kind, *["-" * row.flip for _ in flips],
             *(getattr(row, column) for column in columns)] for row in table.rows]
    lines = [*settings(table), ["joint", *flips, *columns], *rows]
    return "".join(csv_line(list(map(as_text, line))) for line in lines)


def as_text(cell: str) -> str:
    """A cell that no spreadsheet works out; `own_table` takes the apostrophe away again.

    Examples
    --------
    >>> as_text("=1+1"), as_text("-pi/2"), as_text("-WEBSERVICE(A1)")
    ("'=1+1", '-pi/2', "'-WEBSERVICE(A1)")
    """
    return f"'{cell}" if _WORKED_OUT.match(cell) and not _SUM.fullmatch(cell) else cell


def as_typed(cell: str) -> str:
    """A cell of such a line as it was."""
    return cell[1:] if cell.startswith("'") and as_text(cell[1:]) == cell else cell


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
