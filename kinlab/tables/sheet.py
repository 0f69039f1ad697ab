"""Where the table stands in a text: its headings, its rows, and the words around it."""
from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

from ..arms.link import PARAMETERS
from .grid import Lines, grids
from .headings import KIND, LABEL, UNITS, Heading, headings
from .spelling import plain

_MOST_COLUMNS, _MOST_HEADS, _LONGEST_HEAD, _WORDS_NEAR, _MOST_LINES = 40, 60, 60, 12, 500
_LABEL_OF_ROW = re.compile(r"[A-Za-z]{1,8}[ _]?[0-9]{1,2}:?|[0-9]{1,2}\s?(?:->?|→|:)\s?[0-9]{0,2}")
_NUMBER = re.compile(r"\s*[-+−–]?\s?[0-9.]")


@dataclass(frozen=True)
class Sheet:
    """A table of texts.

    Attributes
    ----------
    heads : tuple of Heading
        Empty where the text has no headings.
    rows : tuple of tuple of str
        The cells under the headings.
    around : tuple of tuple of str
        The lines above and below, in cells.
    first : int
        The line of the first row, from 1.
    another : bool
        Whether other headings follow, of a table that is not read.
    """

    heads: tuple[Heading, ...]
    rows: tuple[tuple[str, ...], ...]
    around: tuple[tuple[str, ...], ...] = ()
    first: int = 1
    another: bool = False

    @property
    def is_whole(self) -> bool:
        """Whether there are rows, and none has more cells than there are headings."""
        return bool(self.rows) and all(len(row) <= len(self.heads) for row in self.rows)


def find_sheet(text: str) -> Sheet | None:
    """The table in a text, whatever parts its cells; None if there is none.

    Examples
    --------
    >>> sheet = find_sheet("The arm:\\ntheta;d;a;alpha\\n0;215;0;-90\\n")
    >>> [head.column for head in sheet.heads], sheet.rows, sheet.around
    (['theta', 'd', 'a', 'alpha'], (('0', '215', '0', '-90'),), (('The arm:',),))
    """
    cuts = list(grids(text))
    found = list(_until_whole(map(_headed, cuts)))
    found = found or list(_until_whole(_headed(_turned(lines)) for lines in cuts))
    whole = [sheet for sheet in found if sheet.is_whole]
    return next(iter([*whole, *found]), None) or next(filter(None, map(_bare, cuts)), None)


def _until_whole(sheets: Iterable[Sheet | None]) -> Iterator[Sheet]:
    """The tables up to the first that is whole."""
    for sheet in filter(None, sheets):
        yield sheet
        if sheet.is_whole:
            return


def _headed(lines: Lines) -> Sheet | None:
    """The table under the first line with the most headings."""
    k, heads = _best_heads(lines)
    if not heads:
        return None
    while heads and not heads[-1].text.strip():
        heads = heads[:-1]
    first = k + 1
    if first < len(lines) and (units := _units(lines[first], len(heads))):
        heads, first = _with_units(heads, units), first + 1
    rows, end = _rows(lines, first, len(heads))
    around = lines[max(0, k - _WORDS_NEAR):k] + lines[end:end + _WORDS_NEAR]
    another = any(map(_is_head, lines[end:end + _WORDS_NEAR]))
    return _with_index(Sheet(heads, rows, tuple(tuple(line) for line in around if any(line)),
                             first + 1, another))


def _best_heads(lines: Lines) -> tuple[int, tuple[Heading, ...]]:
    """The first line with the most headings among the first that may be such, or no headings."""
    words = [(k, cells) for k, cells in enumerate(lines) if _may_be_heads(cells)]
    best: tuple[int, tuple[Heading, ...]] = (0, ())
    for k, cells in words[:_MOST_HEADS]:
        heads = headings(cells)
        if _are_heads(heads) and _parameters(heads) > _parameters(best[1]):
            best = k, heads
        if _parameters(best[1]) == len(PARAMETERS):
            break
    return best


def _may_be_heads(cells: Sequence[str]) -> bool:
    """Whether a line may hold headings: some short cells, of which few are numbers."""
    return 2 <= len(cells) <= _MOST_COLUMNS and 2 * sum(
        len(cell) > _LONGEST_HEAD or bool(_NUMBER.match(cell)) for cell in cells) < len(cells)


def _is_head(cells: Sequence[str]) -> bool:
    """Whether a line is surely the head of another table."""
    return _may_be_heads(cells) and _parameters(headings(cells)) > 2


def _are_heads(heads: Sequence[Heading]) -> bool:
    """Whether there are two parameters, one of them an angle, and no crowd of other words."""
    known = sum(bool(head.column) for head in heads)
    return (_parameters(heads) > 1 and (2 * known > len(heads) or _parameters(heads) > 3)
            and any(head.column in ("theta", "alpha") for head in heads))


def _parameters(heads: Sequence[Heading]) -> int:
    return len({head.column for head in heads} & set(PARAMETERS))


def _units(cells: Sequence[str], most: int) -> list[str]:
    """The units in a line that holds nothing else, a column each; [] if it is no such line."""
    if len(cells) > most:
        return []
    words = [plain(cell).lower().strip("[]()<> ") for cell in cells]
    known = [UNITS.get(word, "") for word in words]
    return known if any(known) and all(map(_is_unit_or_nothing, words)) else []


def _is_unit_or_nothing(word: str) -> bool:
    return word in UNITS or word in ("", "-", "--", "1")


def _with_units(heads: Sequence[Heading], units: Sequence[str]) -> tuple[Heading, ...]:
    return tuple(replace(head, unit=head.unit or unit)
                 for head, unit in zip(heads, [*units, *[""] * len(heads)]))


def _rows(lines: Lines, first: int, columns: int) -> tuple[tuple[tuple[str, ...], ...], int]:
    """The rows from a line on, and the line where they end: at words, or at other headings."""
    rows: list[tuple[str, ...]] = []
    for k, line in enumerate(lines[first:first + _MOST_LINES], start=first):
        cells = list(line)
        while len(cells) > columns and not cells[-1].strip():
            cells.pop()
        if len(cells) < min(2, columns) and any(cells):
            if not _NUMBER.match(cells[0]):
                return tuple(rows), k
        elif _is_head(cells) or (rows and not any(lines[k - 1]) and _is_sentence(cells)):
            return tuple(rows), k
        if any(cells):
            rows.append(tuple(cells))
    return tuple(rows), len(lines)


def _is_sentence(cells: Sequence[str]) -> bool:
    """Whether a line is words alone: each row of a table has a digit somewhere."""
    return any(cells) and not any(letter.isdigit() for cell in cells for letter in cell)


def _with_index(sheet: Sheet) -> Sheet:
    """With a heading for a first column that counts, or a last one of zeros and ones."""
    firsts = [plain(row[0]) for row in sheet.rows if len(row) == len(sheet.heads) + 1]
    counted = len(firsts) == len(sheet.rows) > 1 and all(
        word == str(k + int(firsts[0] or 0)) for k, word in enumerate(firsts)
        if firsts[0].isdecimal() and len(firsts[0]) < 4)
    named = len(firsts) == len(sheet.rows) > 1 and all(map(_LABEL_OF_ROW.fullmatch, firsts))
    if named or (counted and firsts[0].isdecimal()):
        return replace(sheet, heads=(Heading(LABEL), *sheet.heads))
    lasts = {row[-1].strip() for row in sheet.rows if len(row) == len(sheet.heads) + 1}
    if len(firsts) == len(sheet.rows) > 0 and lasts <= {"0", "1"}:  # as Link([th d a alpha 0])
        return replace(sheet, heads=(*sheet.heads, Heading(KIND, "sigma")))
    return sheet


def _turned(lines: Lines) -> Lines:
    """Rows as columns: the headings may stand one under the other."""
    rows = [line for line in lines if len(line) > 1 and any(line)][:_MOST_COLUMNS]
    width = max(map(len, rows), default=0)
    padded = [[*line, *[""] * (width - len(line))] for line in rows]
    return [list(column) for column in zip(*padded)] if width <= 200 else []


def _bare(lines: Lines) -> Sheet | None:
    """Rows of numbers without headings: four columns, or five of which the first counts."""
    runs = (tuple(map(tuple, run)) for width, run in groupby(filter(any, lines), len)
            if width in (4, 5))
    rows = max(filter(_is_of_numbers, runs), key=len, default=())
    return Sheet((), rows) if rows else None


def _is_of_numbers(rows: Iterable[Sequence[str]]) -> bool:
    return all(sum(bool(_NUMBER.match(cell)) for cell in row) > 1 for row in rows)
