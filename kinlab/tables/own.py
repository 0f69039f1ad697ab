"""What kinlab wrote, read back as it was: CSV, Markdown and LaTeX that say all of themselves."""
from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Sequence

from ..arms.link import FIXED, KINDS, variable_of
from .as_csv import as_typed
from .as_document import LATEX_SIGNS
from .cells import line
from .grid import Lines
from .headings import LABEL, heading
from .settings import Said, settings_in
from .table import COLUMNS, MOST_LENGTHS, MOST_ROWS, DHTable, Row

_START = re.compile(r"\ufeff?(% |- |)(?:name|convention)(?:,|: )")
_VARIABLE = re.compile(r"-?(?:θ|d)(?:_\{)?[0-9]+(?:\}\^\{)?\*\}? ?(.*)")
_FLIPPED = re.compile(r"-(?:θ|d)(?:_\{)?[0-9]")
_LATEX_SIGNS = {spelled: sign for sign, spelled in LATEX_SIGNS.items()} | {
    r"{\cdot}": "*", r"\pi": "pi", r"\theta": "θ", "$": ""}
_LATEX_SIGN = re.compile("|".join(map(re.escape, sorted(_LATEX_SIGNS, key=len, reverse=True))))
_MOST_LINES = MOST_ROWS + MOST_LENGTHS + 20
_COLUMNS = ("joint", "flip", *COLUMNS, "name")


def own_table(text: str) -> tuple[Said, list[Row]] | None:
    """What such a text says and its rows, cells as they are; None if it is no such text.

    Examples
    --------
    >>> settings = "convention,standard\\nangles,deg\\nlengths,m\\n"
    >>> said, rows = own_table(settings + "joint,theta,d,a,alpha\\nrevolute,0,x,1,0")
    >>> said.unit, rows[0].d
    ('m', 'x')
    """
    start = _START.match(text)
    if not start or text.count("\n") > _MOST_LINES:
        return None
    lines = _LINES[start[1]](text.removeprefix("\ufeff"))
    head = next((k for k, cells in enumerate(lines) if "joint" in cells[:2]), None)
    if head is None:
        return None
    columns = [_column(cell) for cell in lines[head]]
    stars = lines[head][0] != "joint"
    rows = [_row(columns, cells, stars) for cells in lines[head + 1:] if any(cells)]
    try:
        said = settings_in(cells for cells in lines[:head] if any(cells))
    except KeyError:
        return None
    good = [row for row in rows if row]
    return (said, good) if said.says_all and len(good) == len(rows) else None


def table_of(said: Said, rows: Sequence[Row]) -> DHTable:
    """The table of rows and of what was said beside them."""
    return DHTable(tuple(rows), said.convention or "standard", said.angles or "deg",
                   "m" if said.unit is None else said.unit, said.lengths, said.name, said.base,
                   said.tool)


def _column(head: str) -> str:
    return head if head in _COLUMNS else heading(head).column.replace(LABEL, "")


def _row(columns: Sequence[str], cells: Sequence[str], stars: bool) -> Row | None:
    """A row; None if it is none that kinlab wrote."""
    texts = {column: line(cell) for column, cell in zip(columns, cells) if column}
    kind, flip = texts.pop("joint", ""), texts.pop("flip", "")
    if kind not in KINDS or flip not in ("", "-") or not texts.keys() < {*COLUMNS, "name",
                                                                         "."} or any(
            cells[len(columns):]):
        return None
    own = variable_of(kind)
    if stars and own and (match := _VARIABLE.fullmatch(texts.get(own, ""))):
        flip, texts[own] = "-" * bool(_FLIPPED.match(texts[own])), match[1]
    return Row(kind, flip=bool(flip) and kind != FIXED).with_cells(texts)


# ---- the three forms ----


def _csv_lines(text: str) -> Lines:
    try:
        return list(csv.reader(io.StringIO(text)))
    except csv.Error:
        return []


def _sheet_lines(text: str) -> Lines:
    return [list(map(as_typed, cells)) for cells in _csv_lines(text)]


def _said(words: str) -> list[str]:
    word, _, given = words.partition(": ")
    return [word, *(_csv_lines(given) or [[""]])[0]]


def _markdown_lines(text: str) -> Lines:
    return [_said(_unescaped(words[2:])) if words.startswith("- ") else
            [_unescaped(cell.strip()) for cell in re.split(r"(?<!\\)\|", words)[1:-1]]
            for words in text.splitlines() if words.startswith(("- ", "| "))]


def _unescaped(text: str) -> str:
    return re.sub(r"\\(.)", r"\1", text)


def _latex_lines(text: str) -> Lines:
    return [_said(words[2:]) if words.startswith("% ") else
            [_LATEX_SIGN.sub(_sign, cell.strip())
             for cell in re.split(r"(?<!\\)&", words.removesuffix(r"\\"))]
            for words in text.splitlines() if words.startswith("% ") or words.endswith(r" \\")]


def _sign(match: re.Match[str]) -> str:
    return _LATEX_SIGNS[match[0]]


_LINES: dict[str, Callable[[str], Lines]] = {
    "": _sheet_lines, "- ": _markdown_lines, "% ": _latex_lines}
