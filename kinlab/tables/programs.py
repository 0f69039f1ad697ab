"""Tables in programs: rows in brackets, and comments that name the columns. Nothing is run."""
from __future__ import annotations

import re

from ..arms.link import PARAMETERS
from .headings import OFFSET, headings

_COLUMNS = {*PARAMETERS, OFFSET}
_COMMENT = re.compile(r"^(.*?)(?:%+|#+|//+)(.*)$")
_BRACKETS = re.compile(r"[\[({]([^\[\](){};]{3,80})[\])};]|[\[({]([^\[\](){};]{3,80})$")
_START = re.compile(r"^\s*(?:return\s+)?(?:[A-Za-z_][\w.]{0,40}(?:\([0-9]{1,2}\))?\s?=)?"
                    r"\s*(?:[A-Za-z_][\w.]{0,40}\s?\()?\s*[\[({][\s\[({]*")
_NAMED = re.compile(r"^\s*[A-Za-z][\w ]{2,40}:\s*[\[(]")
_WORD = re.compile(r"[(\"'*#]*[A-Za-z][A-Za-z'-]+[.,:;)*\"']*")
_MOST = 60  # cells of a row


def program_lines(text: str) -> list[list[str]]:
    """The lines of a program as cells: its rows without brackets, its comments as words.

    Examples
    --------
    >>> program_lines("% [theta, d]\\nDH = [q1, 0.1;\\n 0, q[2]]; % the last")
    [['[theta, d]'], ['q1', '0.1'], ['0', 'q[2]']]
    """
    lines: list[list[str]] = []
    begun = False
    for line in text.splitlines():
        match = _COMMENT.match(line)
        code, comment = (match[1], match[2]) if match else (line, "")
        if _NAMED.match(code):
            code, comment = "", code
        if _is_prose(code):
            lines.append([code.strip()])
            continue
        rows = [_cells(_closed(row)) for row in re.split(
            r";|\]\s*,\s*\[|\)\s*,\s*\(", _closed(_START.sub("", code))) if _closed(row)]
        begun = begun or any(len(cells) > 2 for cells in rows)
        lines += _columns(comment.strip(), begun or bool(rows)) + rows
    return lines


def _is_prose(code: str) -> bool:
    """Whether a line says something: more than half of it are words of letters alone."""
    words = code.split()
    return len(words) > 3 and 2 * sum(map(bool, map(_WORD.fullmatch, words))) > len(words)


def _columns(comment: str, begun: bool) -> list[list[str]]:
    """The columns that a comment names in brackets, behind a colon, or in all of it.

    Where rows have begun, only those in brackets count: other words name a joint.
    """
    inside = _BRACKETS.search(comment)
    named = _cells((inside[1] or inside[2]).strip("| ")) if inside else []
    if len(named) < 3 and not begun:
        named = _cells(comment.rsplit(":", 1)[-1].strip("| "))
    return [[comment]] * (bool(comment) and not begun) + [named] * (
        2 < len(named) < _MOST and len({head.column for head in headings(named)} & _COLUMNS) > 1)


def _closed(code: str) -> str:
    """A row without the brackets that were opened before it, and what else stands at its end."""
    code = code.strip()
    while code[-1:] in tuple(";,") or (code[-1:] in tuple(")]}") and _excess(code) > 0):
        code = code[:-1].rstrip()
    return code


def _excess(code: str) -> int:
    """How many more brackets are closed than opened."""
    return sum(map(code.count, ")]}")) - sum(map(code.count, "([{"))


def _cells(words: str) -> list[str]:
    for sign in "|,":
        if sign in words:
            return [cell.strip() for cell in words.split(sign)]
    return re.split(r"\s{2,}", words) if re.search(r"\s[-+]\s", words) else words.split()
