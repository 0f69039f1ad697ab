"""The joint variable in a cell that holds its offset: q1, θ2* - 90, -d3."""
from __future__ import annotations

import re
from dataclasses import dataclass

from .spelling import plain

_LETTERS = {"theta": "theta|vartheta|tet|th|varphi|phi|joints?|axis|q|t|j|a",
            "d": "d|q|s|joints?"}
_TOKENS = {column: re.compile(
    rf"(?<![\w.])(?:{letters})(\^?\*)?(?:_?([0-9]{{1,3}})|_?[ijkn]|(?<=theta)\s([0-9]{{1,2}})|[\[(]([0-9]{{1,3}})[\])])?"
    r"(\s?\^?\*)?(?:\(t\))?(?![\w(\[])", re.IGNORECASE) for column, letters in _LETTERS.items()}
_WORDS = re.compile(r"\*|var\.?|variable|joint variable", re.IGNORECASE)
_STARRED = re.compile(r"(-?[0-9][0-9.,]*\s?°?)\s?\^?\*")


@dataclass(frozen=True)
class Variable:
    """A joint variable found in a cell.

    Attributes
    ----------
    number : int or None
        The joint that it names.
    flip : bool
        Whether a minus stands before it.
    offset : str
        What else the cell holds; "0" if nothing.
    marked : bool
        Whether a star or a word says that it is the variable.
    """

    number: int | None
    flip: bool
    offset: str
    marked: bool = False


def variable(text: str, column: str) -> Variable | None:
    """The one joint variable of a cell of theta or d, if it stands there plus or minus a rest.

    Examples
    --------
    >>> variable("90 - q2", "theta")
    Variable(number=2, flip=True, offset='90', marked=False)
    >>> variable("2*q2", "theta") is None, variable("q2 + q3", "theta") is None
    (True, True)
    """
    text = _bare(plain(text))
    if _WORDS.fullmatch(text):
        return Variable(None, False, "0", True)
    if star := _STARRED.fullmatch(text):
        return Variable(None, False, star[1], True)
    found = list(_TOKENS[column].finditer(text))
    if len(found) != 1:
        return None
    marked = bool(found[0][1] or found[0][5])
    parted = _parted(text[:found[0].start()].rstrip(), text[found[0].end():].lstrip(), marked)
    if parted is None:
        return None
    number = found[0][2] or found[0][3] or found[0][4]
    return Variable(int(number) if number else None, *parted, marked)


def _bare(text: str) -> str:
    """The text without brackets around all of it."""
    inside = text[1:-1]
    return inside.strip() if text[:1] + text[-1:] == "()" and not set(inside) & set("()") else text


def _parted(before: str, after: str, marked: bool) -> tuple[bool, str] | None:
    """The sign in front of the variable, and the offset beside it; None if it is no such sum."""
    flip = before.endswith("-")
    rest = before[:-1].rstrip() if before[-1:] in ("-", "+") and before else before
    if (rest and rest == before) or rest[-1:] in tuple("+-*/(^"):
        return None
    if after[:1] not in ("", "+", "-") and not (marked and not rest and after[0] not in "*/)^"):
        return None
    after = after.rstrip("* ")
    sum_ = f"{rest} {after}".strip() if rest else re.sub(r"^([+-])\s+", r"\1", after)
    return flip, sum_.removeprefix("+").strip() or "0"
