"""What was assumed while a table was read, in one line."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from ..arms import inputs
from ..arms.link import FIXED, PRISMATIC
from .sheet import Sheet
from .table import DHTable, Row

UNIT_WORDS = {"deg": "degrees", "rad": "radians"}
_FACTS: tuple[tuple[Callable[[Row], bool], str, str], ...] = (
    (lambda row: row.kind == PRISMATIC, "slides", "slide"),
    (lambda row: row.kind == FIXED, "is fixed", "are fixed"),
    (lambda row: row.flip, "counts the other way", "count the other way"))


def remark_of(table: DHTable, sheet: Sheet, notes: Sequence[str] = ()) -> str:
    """How a table was read: its convention and units, its joints, and what was left out.

    Examples
    --------
    >>> remark_of(DHTable((Row(), Row("prismatic"), Row("prismatic"))), Sheet((), ()))
    'Read as standard DH, angles in degrees, lengths in m; rows 2 and 3 slide.'
    """
    parts = [f"Read as {table.convention} DH, angles in {UNIT_WORDS[table.angles]}, "
             f"lengths in {table.unit or 'a unit without a name'}", *_facts(table.rows)]
    parts += ["the first of the tables"] * sheet.another
    if out := [head.text for head in sheet.heads if not head.column and head.text.strip()]:
        parts.append(f"left out: {listed(map(inputs.brief, out))}")
    return f"{'; '.join([*parts, *notes])}."


def listed(words: Iterable[str]) -> str:
    """Words as a sentence lists them: one, two and three."""
    *first, last = words
    return f"{', '.join(first)} and {last}" if first else last


def _facts(rows: Sequence[Row]) -> Iterable[str]:
    for test, one, more in _FACTS:
        if numbers := [str(i) for i, row in enumerate(rows, start=1) if test(row)]:
            plural = len(numbers) > 1
            yield f"row{'s' * plural} {listed(numbers)} {more if plural else one}"
