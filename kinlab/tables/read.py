"""A DH table from text as people have it: what it says is kept, what it leaves open is asked."""
from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from ..arms import inputs
from ..arms.arm import CONVENTIONS
from ..arms.link import PARAMETERS, PRISMATIC
from .as_code import LONGEST_FILE, from_code
from .cells import (
    ANGLES,
    LARGEST_RADIANS,
    MILLIMETRES,
    angle_hint,
    is_plain,
    length_in,
    line,
)
from .commas import reader_of_commas
from .headings import Heading, headings
from .measures import angle_of, length_text, unit_of, value_of, with_names
from .own import own_table, table_of
from .question import Ambiguous
from .remarks import UNIT_WORDS, listed, remark_of
from .rows import Cells, cells_of
from .settings import said_in
from .sheet import Sheet, find_sheet
from .spelling import plain
from .table import COLUMNS, LIMITS, MOST_LENGTHS, MOST_ROWS, DHTable, Row
from .variables import variable

_CHOICES = {"angles": tuple(ANGLES), "convention": tuple(CONVENTIONS), "decimal": (".", ",")}
# The orders in which books print the columns.
_ORDERS = ("theta d a alpha", "a alpha d theta", "d theta a alpha", "alpha a d theta",
           "alpha a theta d")
MOST_LINES = 500
_IMPORTS = ("import ", "from ")
_SHAPE = "a header such as theta,d,a,alpha and one line per joint"
_HAS_UNIT = re.compile(r"°|\b(?:deg|rad|pi)\b|[0-9](?:deg|rad)\b")


@dataclass(frozen=True)
class Loaded:
    """A table that was read, and what was assumed on the way: "" or one line."""

    table: DHTable
    remark: str = ""


def read_table(text: str, like: DHTable, **choices: str) -> Loaded:
    """The table that a text describes; what it leaves open is as in the table `like`.

    Read are CSV, semicolons, tabs, blanks, Markdown, LaTeX, HTML, what kinlab prints, and kinlab
    code, which is never run. Columns may stand in any order, under the names that books give
    them, with units in the headings, in the cells or in the words around.

    Parameters
    ----------
    text : str
        At most 500 lines and 100,000 characters.
    like : DHTable
        The table that is there: its convention, units and named lengths hold unless the text says
        otherwise.
    **choices : str
        Answers to what an `Ambiguous` text left open: ``angles`` ("deg" or "rad"), ``convention``
        ("standard" or "modified"), ``decimal`` ("." or ","), ``columns`` such as
        "theta d a alpha".

    Returns
    -------
    Loaded

    Raises
    ------
    ValueError
        If the text is no table; an `Ambiguous` one if it may be read in more than one way.

    Examples
    --------
    >>> text = "α(i-1) | a(i-1) | d | θ\\n0 | 0 | 0.75 | q1\\n-90 | 0 | d2* | 0"
    >>> read_table(text, DHTable((Row(),))).remark
    'Read as modified DH, angles in degrees, lengths in m; row 2 slides.'
    """
    answers = _checked(choices)
    if not isinstance(text, str) or len(text) > LONGEST_FILE:
        raise ValueError(f"text: expected {_SHAPE}, at most {LONGEST_FILE} characters, "
                         f"got {inputs.brief(text)}")
    text = text.replace("\r\n", "\n").replace("\r", "\n").replace("\0", " ")
    if own := own_table(text):
        return Loaded(_limited(table_of(*own)))
    if text.count("\n") > MOST_LINES:
        raise ValueError(f"text: expected {_SHAPE}, at most {MOST_LINES} lines, got "
                         f"{text.count(chr(10))}; take the lines of the table alone")
    text = re.sub(r"\A\ufeff?sep=.\n", "", text).removeprefix("\ufeff").replace("\u00a0", " ")
    text = _unquoted(text)
    if ("Arm(" in text and "DHTableEditor(" not in text) or text.lstrip().startswith(_IMPORTS):
        return Loaded(_limited(from_code(text, like.angles)))
    return _Reading(text, like, answers).loaded()


def _unquoted(text: str) -> str:
    """A text without the signs that a mail or Markdown puts before each of its lines."""
    quoted = all(line.startswith(">") for line in text.splitlines() if line.strip())
    return re.sub(r"(?m)^> ?", "", text) if quoted else text


def _checked(choices: Mapping[str, str]) -> dict[str, str]:
    for name, value in choices.items():
        inputs.choice("load", name, (*_CHOICES, "columns"))
        if name == "columns":
            _columns_given(value)
        else:
            inputs.choice(name, value, _CHOICES[name])
    return dict(choices)


def _columns_given(value: str) -> tuple[Heading, ...]:
    words = value.split() if isinstance(value, str) else []
    if sorted(words) != sorted(PARAMETERS):
        raise ValueError("columns: expected theta, d, a and alpha in the order of the text, such "
                         f"as 'theta d a alpha', got {inputs.brief(value)}")
    return headings(words)


def _limited(table: DHTable) -> DHTable:
    if not 1 <= len(table.rows) <= MOST_ROWS:
        raise ValueError(f"text: expected 1 to {MOST_ROWS} rows under the headings, "
                         f"got {len(table.rows)}")
    return table


class _Reading:
    """One text on its way to a table."""

    def __init__(self, text: str, like: DHTable, answers: Mapping[str, str]) -> None:
        self.like, self.answers = like, answers
        found = _found(text)
        self.sheet = _with_heads(found, answers)
        self.said = said_in(self.sheet.around)
        self.notes = [] if found.heads else [
            f"columns read as {' '.join(head.column for head in self.sheet.heads)}"]

    def loaded(self) -> Loaded:
        sheet = self._without_commas()
        cells = cells_of(sheet.heads, sheet.rows, sheet.first)
        convention, angles, unit = self._convention(), self._angles(cells), self._unit(cells)
        rows, lengths = self._with_lengths([self._in_units(row, angles, unit) for row in cells],
                                           unit)
        table = DHTable(tuple(_row(row) for row in rows), convention, angles, unit, lengths,
                        self.said.name, self.said.base, self.said.tool)
        return Loaded(_limited(table), remark_of(table, self.sheet, self.notes))

    def _without_commas(self) -> Sheet:
        """The table with points where it has decimal commas, in the columns of numbers."""
        numbers = [head.column in (*PARAMETERS, *LIMITS) for head in self.sheet.heads]
        cells = [cell for row in self.sheet.rows for cell, is_number in zip(row, numbers)
                 if is_number]
        read = reader_of_commas(cells, self.answers.get("decimal"))
        rows = (tuple(read(cell) if k < len(numbers) and numbers[k] else cell
                      for k, cell in enumerate(row)) for row in self.sheet.rows)
        return replace(self.sheet, rows=tuple(rows))

    # ---- what holds for all of it ----

    def _convention(self) -> str:
        by_heads = any(head.previous for head in self.sheet.heads)
        if "convention" in self.answers:
            return self.answers["convention"]
        if by_heads and self.said.convention == "standard":
            raise Ambiguous("Which convention is it: the words say standard DH, the headings with "
                            "i-1 modified DH?", tuple((word, {"convention": word})
                                                      for word in CONVENTIONS))
        return "modified" if by_heads else self.said.convention or self.like.convention

    def _angles(self, cells: Sequence[Cells]) -> str:
        """The unit of angles without one; asked where numbers speak against the editor's."""
        heads = self._units_of("theta", "alpha")
        told = self.answers.get("angles") or self.said.angles or next(filter(None, heads), "")
        if told:
            return told
        texts = [row.texts.get(column, "0") for row in cells for column in ("theta", "alpha")]
        bare = [text for text in texts if is_plain(text) and float(text)]
        if bare and any("°" in text for text in texts):
            return "deg"
        small = [text for text in bare if "." in text and abs(float(text)) < LARGEST_RADIANS]
        hints = [text for text in bare if angle_hint(text, self.like.angles)] or small * (
            self.like.angles == "deg" and any("pi" in text for text in texts))
        if hints:
            raise Ambiguous(
                f"Are the angles in degrees or in radians? One is {hints[0]}.",
                tuple((UNIT_WORDS[unit], {"angles": unit}) for unit in ANGLES))
        return self.like.angles

    def _unit(self, cells: Sequence[Cells]) -> str:
        heads = next(filter(None, self._units_of("d", "a")), None)
        in_cells = (unit_of(row.texts.get(column, "")) for row in cells for column in ("d", "a"))
        return (self.said.unit or heads or next(filter(None, in_cells), None) or self.like.unit)

    def _units_of(self, *columns: str) -> list[str]:
        return [head.unit for head in self.sheet.heads if head.column in columns]

    # ---- cells ----

    def _in_units(self, row: Cells, angles: str, unit: str) -> Cells:
        """A row with its angles and lengths in the table's units."""
        own = {head.column: head.unit for head in self.sheet.heads}
        texts = dict(row.texts)
        for column, text in row.texts.items():
            is_angle = column in ("theta", "alpha") or (column in LIMITS and row.kind != PRISMATIC)
            if column in PARAMETERS or (column in LIMITS and text):
                texts[column] = angle_of(text, own.get(column) or angles, angles) if is_angle \
                    else length_text(text, own.get(column) or unit, unit)
        return replace(row, texts=texts)

    def _with_lengths(self, rows: list[Cells], unit: str
                      ) -> tuple[list[Cells], tuple[tuple[str, str], ...]]:
        """The rows with the names of lengths that are known, and the lengths of the table."""
        lengths = {**_lengths_in(self.like, unit), **dict(self.said.lengths)}
        places = [(k, column) for k, row in enumerate(rows) for column in ("d", "a")]
        texts, others = with_names([rows[k].texts.get(column, "0") for k, column in places],
                                   lengths)
        for (k, column), text in zip(places, texts):
            rows[k] = replace(rows[k], texts={**rows[k].texts, column: text})
        new = {name: value_of(name, self.said.named) for name in others}
        if empty := [name for name, text in new.items() if not text]:
            self.notes.append(f"give {listed(empty)} a value")
        if len(lengths) + len(new) > MOST_LENGTHS:
            raise ValueError(f"text: expected at most {MOST_LENGTHS} named lengths, "
                             f"got {len(lengths) + len(new)}")
        return rows, tuple((lengths | new).items())


def _found(text: str) -> Sheet:
    sheet = find_sheet(text)
    if sheet is None or not sheet.rows:
        raise ValueError(f"text: expected {_SHAPE}, got "
                         f"{'no such header' if sheet is None else 'no line under it'}")
    _check_units(sheet.heads)
    if len(sheet.rows) > MOST_ROWS:
        raise ValueError(f"text: expected 1 to {MOST_ROWS} rows under the headings, "
                         f"got {len(sheet.rows)}")
    return sheet


def _check_units(heads: Iterable[Heading]) -> None:
    for head in heads:
        is_angle = head.column in ("theta", "alpha")
        if head.unit and head.column in PARAMETERS and is_angle != (head.unit in ANGLES):
            raise ValueError(f"text: the header has {inputs.brief(head.text)}; expected "
                             "an angle in deg or rad, or a length in mm, cm, m or in")


def _with_heads(sheet: Sheet, answers: Mapping[str, str]) -> Sheet:
    """The table with its headings; asked for where it has none."""
    if "columns" in answers:
        return _reordered(sheet, _columns_given(answers["columns"]))
    if sheet.heads:
        return sheet
    orders = [order for order in _ORDERS if _fits(order.split(), sheet.rows)]
    if len(orders) == 1:
        return _reordered(sheet, headings(orders[0].split()))
    raise Ambiguous("The columns have no headings; in which order do they stand?",
                    tuple((order, {"columns": order}) for order in orders or _ORDERS))


def _reordered(sheet: Sheet, given: tuple[Heading, ...]) -> Sheet:
    """The table with theta, d, a and alpha in the order that was given."""
    if not sheet.heads:
        return replace(sheet, heads=given, rows=tuple(row[-len(given):] for row in sheet.rows))
    left = iter(given)
    heads = (replace(head, column=next(left, head).column) if head.column in PARAMETERS else head
             for head in sheet.heads)
    return replace(sheet, heads=tuple(heads))


def _fits(order: Sequence[str], rows: Iterable[Sequence[str]]) -> bool:
    """Whether no angle stands under a length, and no joint variable under a or alpha."""
    return all(_may_stand(column, cell) for row in rows for column, cell in zip(order, row[-4:]))


def _may_stand(column: str, cell: str) -> bool:
    if column in ("d", "a") and _HAS_UNIT.search(plain(cell)):
        return False
    return column == "theta" or variable(cell, "theta") is None


def _row(cells: Cells) -> Row:
    texts = {column: line(text) for column, text in cells.texts.items() if column in COLUMNS}
    return Row(cells.kind, flip=cells.flip, name=line(cells.name)).with_cells(texts)


def _lengths_in(table: DHTable, unit: str) -> dict[str, str]:
    """The named lengths of a table, in another unit where both are known."""
    both = {table.unit, unit} <= MILLIMETRES.keys()
    return {name: length_in(text, table.unit, unit, {}, {}) if both else text
            for name, text in table.lengths}
