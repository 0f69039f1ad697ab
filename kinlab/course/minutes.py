"""How long a notebook takes, part by part, for a student who reads English as a second language.

A class hour holds one part. A cell tagged "part" opens it and states its minutes:
``**Part 2 of 4 · 40 minutes.**``; the first cell of the notebook states their sum:
``Time: 160 minutes in 4 parts.`` What stands before the first such cell belongs to part 1.
"""
from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil

from nbformat import NotebookNode

WORDS_A_MINUTE = 25
CELL, EXERCISE = 2, 10  # minutes; an exercise is run with its check
MOST = 45               # minutes of work in a class hour
STEP = 5                # what is stated is a multiple of it

_HEADING = re.compile(r"\*\*Part (\d+) of (\d+) · (\d+) minutes\.\*\*")
OPENING = re.compile(r"^Time: (\d+) minutes(?: in (\d+) parts?)?\b", re.MULTILINE)
_UNREAD = re.compile(r"<details>.*?</details>|<!--.*?-->", re.DOTALL)
_ONE_WORD = re.compile(r"\$\$.*?\$\$|\$[^$]*\$|`[^`]*`", re.DOTALL)
_ADDRESS = re.compile(r"\]\([^)]*\)|<[^>]+>")
_WORD = re.compile(r"[^\W\d_]+(?:['’][^\W\d_]+)*")


@dataclass(frozen=True)
class Part:
    """What a part says of itself, and the minutes that it takes by our estimate."""

    name: str
    stated: int
    estimate: float

    @property
    def honest(self) -> int:
        """The minutes that it should state: the estimate, rounded up."""
        return STEP * ceil(round(self.estimate, 6) / STEP)


def words(markdown: str) -> int:
    """How many words there are to read; a formula is one, and what is folded is not counted.

    Examples
    --------
    >>> words("The point $c^0 = o_1^0 + c^1$ is [here](#kl:frame=1).")
    5
    >>> words("Ask.<details><summary>Look</summary>at the answer</details>")
    1
    """
    read = _ONE_WORD.sub(" formula ", _UNREAD.sub(" ", markdown))
    return len(_WORD.findall(_ADDRESS.sub(" ", read)))


def cell_minutes(cell: NotebookNode) -> float:
    """The minutes that one cell takes."""
    if cell.cell_type == "markdown":
        return words(cell.source) / WORDS_A_MINUTE
    tags = cell.metadata.get("tags", ())
    return EXERCISE if "exercise" in tags else 0 if "check" in tags else CELL


def parts(notebook: NotebookNode) -> list[Part]:
    """The parts of a notebook; the whole is one if no cell opens a part."""
    made = [_part(cells) for cells in _split(notebook)]
    if len(made) > 1 or made[0].name:
        return made
    total, _ = opening(notebook)
    return [Part("the whole", total, made[0].estimate)]


def opening(notebook: NotebookNode) -> tuple[int, int]:
    """The minutes and the number of parts that the first cell states.

    Raises
    ------
    ValueError
        If it has no line like "Time: 160 minutes in 4 parts."
    """
    found = OPENING.search(notebook.cells[0].source)
    if not found:
        raise ValueError('the first cell has no line like "Time: 160 minutes in 4 parts."')
    return int(found[1]), int(found[2] or 1)


def faults(notebook: NotebookNode) -> Iterator[str]:
    """All that is not true or not honest in what a notebook says of its time, in words."""
    found = parts(notebook)
    total, number = opening(notebook)
    for k, part in enumerate(found, start=1):
        if part.name != f"Part {k} of {len(found)}" and len(found) > 1:
            yield f"{part.name}: expected Part {k} of {len(found)}"
        if part.honest > MOST:
            yield f"{part.name} takes {part.honest} minutes; a class hour holds {MOST}"
        elif part.stated != part.honest:
            yield f"{part.name} takes {part.estimate:.1f} minutes, so state {part.honest}"
    if (total, number) != (sum(part.stated for part in found), len(found)):
        yield (f"the first cell says {total} minutes in {number} parts; its {len(found)} parts "
               f"say {sum(part.stated for part in found)}")


def _split(notebook: NotebookNode) -> list[list[NotebookNode]]:
    """The cells of each part; what stands before part 1 goes with it."""
    starts = [k for k, cell in enumerate(notebook.cells) if "part" in cell.metadata.get("tags", ())]
    ends = [*starts[1:], len(notebook.cells)]
    return [notebook.cells[start:end] for start, end in zip([0, *starts[1:]], ends)]


def _part(cells: list[NotebookNode]) -> Part:
    estimate = sum(map(cell_minutes, cells))
    for cell in cells:
        if "part" in cell.metadata.get("tags", ()):
            found = _HEADING.search(cell.source)
            if not found:
                raise ValueError(f'{cell.id}: no line like "**Part 2 of 4 · 40 minutes.**"')
            return Part(f"Part {found[1]} of {found[2]}", int(found[3]), estimate)
    return Part("", 0, estimate)
