"""Tables whose numbers stand behind names: ``alpha1 = pi/2``, ``Link(d=0.1)``. Nothing is run."""
from __future__ import annotations

import re
from collections.abc import Iterator

_KEYS = r"alpha|theta|offset|[adr]"
_VALUE = r"['\"]?\s?(?:[:=,]|:=)\s?['\"]?([^,;:={}\[\]\n'\"]{1,60})"
_NUMBERED = re.compile(rf"(?<![\w.])(alpha|theta|[adqr])_?([0-9]{{1,2}}){_VALUE}", re.IGNORECASE)
_KEYED = re.compile(rf"(?<![\w.])['\"]?({_KEYS}){_VALUE}", re.IGNORECASE)
_SLIDES = re.compile(r"prismatic|['\"](?:P|prismatic)['\"]|sigma['\"]?\s?[:=,]\s?1", re.IGNORECASE)
_MODIFIED = re.compile(r"MDH\s?\(|['\"]modified['\"]")
_OF_JOINT, _OF_LINK = ("d", "theta", "q"), ("alpha", "a", "r")
_FEWEST = 2  # columns, besides the number of the row


def assigned_lines(text: str) -> Iterator[list[list[str]]]:
    """The lines of a table whose cells stand behind their names, with headings above them.

    Examples
    --------
    >>> list(assigned_lines("alpha0: 0, a0: 0, d1: 0.75, alpha1: -pi/2, a1: 0.35, d2: 0"))[0]
    [['alpha(i-1)', 'a(i-1)', 'd'], ['0', '0', '0.75'], ['-pi/2', '0.35', '0']]
    """
    if found := _numbered(text):
        yield found
    if found := _records(text):
        yield found


def _numbered(text: str) -> list[list[str]]:
    """Rows of names with numbers; where those of alpha and a are one less, they are of i-1."""
    cells: dict[str, dict[int, str]] = {}
    for name, number, value in _NUMBERED.findall(text):
        cells.setdefault(name.lower(), {}).setdefault(int(number), _closed(value))
    if len(cells) < _FEWEST or len(cells.get("alpha", ())) < _FEWEST:
        return []
    start = {group: min((min(cells[name]) for name in group if name in cells), default=1)
             for group in (_OF_JOINT, _OF_LINK)}
    before = start[_OF_LINK] == start[_OF_JOINT] - 1
    heads = [f"{name}(i-1)" if before and name in _OF_LINK else name for name in cells]
    first = {name: start[_OF_LINK if name in _OF_LINK else _OF_JOINT] for name in cells}
    count = max(max(rows) - first[name] + 1 for name, rows in cells.items())
    return [heads, *([rows.get(first[name] + k, "") for name, rows in cells.items()]
                     for k in range(count))]


def _records(text: str) -> list[list[str]]:
    """Rows of named numbers, one a line or one in brackets: of a dictionary, or of a call."""
    rows = [(_unique(_KEYED.findall(part)), bool(_SLIDES.search(part))) for part in _parts(text)]
    rows = [(row, slides) for row, slides in rows if len(row) >= _FEWEST]
    heads = list(dict.fromkeys(name for row, _ in rows for name in row))
    if len(rows) < 2 or not {"alpha", "theta"} & set(heads):
        return []
    index = "(i-1)" if _MODIFIED.search(text) else ""
    named = [f"{name}{index}" if name in ("alpha", "a") else name for name in heads]
    return [[*named, "type"], *([*(row.get(name, "0") for name in heads),
                                 "prismatic" if slides else "revolute"] for row, slides in rows)]


def _parts(text: str) -> list[str]:
    """A line each; several lines where a bracket holds them together."""
    if blocks := re.findall(r"\{([^{}]{10,400})\}", text):
        return [" ".join(block.split()) for block in blocks]
    return text.splitlines()


def _unique(pairs: list[tuple[str, str]]) -> dict[str, str]:
    return {name.lower(): _closed(value) for name, value in reversed(pairs)}


def _closed(value: str) -> str:
    """A value without a bracket that was opened before it."""
    value = value.strip()
    while value.endswith(")") and value.count(")") > value.count("("):
        value = value[:-1].rstrip()
    return value
