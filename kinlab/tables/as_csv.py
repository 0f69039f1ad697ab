"""DH tables as CSV: what a spreadsheet opens, and what it saves."""
from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import replace

from ..arms import inputs
from ..arms.arm import CONVENTIONS
from ..arms.link import PRISMATIC, REVOLUTE
from .cells import ANGLES, line
from .ends import End
from .table import COLUMNS, MOST_LENGTHS, MOST_ROWS, DHTable, Row

LONGEST_FILE = 50_000
_HEADS = {"θ": "theta", "α": "alpha", "type": "joint", "θ*": "theta"}
_KINDS = {"": REVOLUTE, "r": REVOLUTE, "p": PRISMATIC, REVOLUTE: REVOLUTE, PRISMATIC: PRISMATIC}
_SHAPE = "a header such as joint,theta,d,a,alpha and one line per joint"


def to_csv(table: DHTable) -> str:
    """The table as CSV: what it is, named lengths, a header, and one line per joint.

    Examples
    --------
    >>> print(to_csv(DHTable((Row(a="1"),))), end="")
    convention,standard
    angles,deg
    lengths,m
    joint,theta,d,a,alpha
    revolute,0,0,1,0
    """
    lines = [["name", table.name]] * bool(table.name)
    lines += [["convention", table.convention], ["angles", table.angles], ["lengths", table.unit]]
    lines += [["length", *pair] for pair in table.lengths]
    lines += [[end, *frame.words]
              for end, frame in (("base", table.base), ("tool", table.tool)) if frame]
    columns = [column for column in (*COLUMNS, "name")
               if column in COLUMNS[:4] or any(getattr(row, column) for row in table.rows)]
    lines += [["joint", *columns]]
    lines += [[row.kind, *(getattr(row, column) for column in columns)] for row in table.rows]
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(lines)
    return text.getvalue()


def from_csv(text: str) -> DHTable:
    """The table that `to_csv` or a spreadsheet wrote; wrong cells are kept as they are.

    Only the header and its lines are needed. Commas, semicolons or tabs may stand between cells.

    Raises
    ------
    ValueError
        If the text is no such table; the line is named.

    Examples
    --------
    >>> from_csv("theta;d;a;alpha\\n0;215;0;-90").rows[0].d
    '215'
    """
    lines = _lines(text)
    head = next((k for k, cells in enumerate(lines) if "alpha" in _named(cells)), None)
    if head is None:
        raise ValueError(f"text: expected {_SHAPE}, got no header with alpha in it")
    columns = _columns(lines[head])
    rows = [_row(columns, cells, k) for k, cells in enumerate(lines[head + 1:], start=head + 2)
            if any(cells)]
    if not 1 <= len(rows) <= MOST_ROWS:
        raise ValueError(f"text: expected 1 to {MOST_ROWS} joints under the header, "
                         f"got {len(rows)}")
    table = DHTable(tuple(rows))
    for k, cells in enumerate(lines[:head], start=1):
        table = _told(table, cells, k) if any(cells) else table
    return table


def _lines(text: str) -> list[list[str]]:
    if not isinstance(text, str) or len(text) > LONGEST_FILE:
        raise ValueError(f"text: expected {_SHAPE}, at most {LONGEST_FILE} characters, "
                         f"got {inputs.brief(text)}")
    text = text.removeprefix("\ufeff").replace("\0", " ")
    head = next((words for words in text.splitlines() if "alpha" in words or "α" in words), "")
    try:
        lines = list(csv.reader(io.StringIO(text), delimiter=max(",;\t", key=head.count)))
    except csv.Error as error:
        raise ValueError(f"text: expected {_SHAPE}, got text that is no CSV: {error}") from None
    return [[line(cell) for cell in cells] for cells in lines]


def _named(cells: Sequence[str]) -> list[str]:
    words = [cell.lower() for cell in cells]
    return [_HEADS.get(word, word) for word in words]


def _columns(cells: Sequence[str]) -> list[str]:
    columns, known = _named(cells), ("joint", *COLUMNS, "name")
    while columns and not columns[-1]:
        columns.pop()
    for column in columns:
        if column not in known or columns.count(column) > 1:
            raise ValueError(f"text: the header has {inputs.brief(column)}; expected each of "
                             f"{', '.join(known)} at most once")
    return columns


def _row(columns: Sequence[str], texts: Sequence[str], number: int) -> Row:
    if any(texts[len(columns):]):
        raise ValueError(f"text: line {number} has {len(texts)} cells under {len(columns)} heads; "
                         "put a text that has a comma into quotes")
    cells = dict(zip(columns, texts))
    kind = cells.pop("joint", "").lower()
    if kind not in _KINDS:
        raise ValueError(f"text: line {number} has a joint {inputs.brief(kind)}; "
                         "expected revolute or prismatic")
    return Row(_KINDS[kind]).with_cells(cells)


def _told(table: DHTable, cells: Sequence[str], number: int) -> DHTable:
    """The table with what a line above the header says of it."""
    word, given = cells[0].lower(), list(cells[1:])
    while given and not given[-1]:
        given.pop()
    one = given[0] if given else ""
    match word:
        case "name":
            return replace(table, name=one)
        case "convention" if one in CONVENTIONS:
            return replace(table, convention=one)
        case "angles" if one in ANGLES:
            return replace(table, angles=one)
        case "lengths" if one:
            return replace(table, unit=one)
        case "length" if len(given) <= 2 and len(table.lengths) < MOST_LENGTHS:
            return table.with_length(len(table.lengths) + 1, *(*given, "", "")[:2])
        case "base" | "tool":
            return table.with_frame(word, End.read(word, given))
    raise ValueError(f"text: line {number} says {inputs.brief(','.join(cells))}; expected name, "
                     "convention, angles, lengths, length, base, tool or a header")
