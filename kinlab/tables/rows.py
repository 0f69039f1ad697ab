"""Rows of cells as people write them: what kind of joint each is, and what its cells hold."""
from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..arms import inputs
from ..arms.link import FIXED, PARAMETERS, PRISMATIC, REVOLUTE
from .headings import IGNORED, KIND, LABEL, OFFSET, Heading
from .numbers import LONGEST
from .spelling import plain
from .variables import Variable, variable

_KIND_WORDS = {
    REVOLUTE: "revolute r rev rotational rotary rotation rotating rotative hinge turn rotatorisch "
              "dreh drehgelenk rotoide rotacional revoluta rotatoire rr continuous",
    PRISMATIC: "prismatic p pris translational translation linear sliding slider slide t "
               "translatorisch schub schubgelenk prismatica prismatique lineal",
    FIXED: "fixed f fix none static rigid fest"}
KINDS = {word: kind for kind,
         words in _KIND_WORDS.items() for word in words.split()} | {"": REVOLUTE}
_SIGMA = {"0": REVOLUTE, "1": PRISMATIC, "2": FIXED}
_COUNTED = re.compile(r"(?:joint|link|axis|frame|achse|gelenk|glied|row|body|dof|theta|[a-z])?"
                      r"[\s_.#-]{0,3}[0-9]{1,3}(?:\s?(?:-|->|→|to|,|/)?>?\s?[a-z]?_?[0-9]{1,3})?"
                      r"|[0-9a-z]{1,3}(?:\s?(?:->|→|-|/)\s?[0-9a-z+-]{1,4})?", re.IGNORECASE)
# A symbol is one letter with an index; sin(2) is no symbol with its value.
_WITH_VALUE = re.compile(r"[A-Za-z]\w{0,20}\s?:?=([^=]{1,200})|(?:[A-Za-z]|alpha|theta)"
                         r"(?:[0-9]\w{0,9}|_\w{1,20})?\s?\(([-+]?[0-9.]{1,20})\)")
_RANGE = re.compile(r"\+?\s?\([^()]{0,30}(?:->|→|\bto\b|\.\.)[^()]{0,30}\)")
_EMPTY = Variable(None, False, "0")
_NOTHING = ("", "-", "--", "/", "n/a", "na", "none", "null", "nil", ".", "...")


@dataclass(frozen=True)
class Cells:
    """One row's texts by column, plain, and what is known of its joint.

    `texts` hold the offset alone in the cell of the joint variable.
    """

    texts: Mapping[str, str]
    kind: str = REVOLUTE
    flip: bool = False
    name: str = ""


def columns_of(heads: Sequence[Heading]) -> dict[str, int]:
    """Where each known column stands; the first of several labels."""
    columns: dict[str, int] = {}
    for k, head in enumerate(heads):
        if head.column and head.column != LABEL and head.column in columns:
            raise ValueError(f"text: the header has {inputs.brief(head.text)} twice; expected each "
                             "of theta, d, a and alpha once")
        columns.setdefault(head.column, k)
    return columns


def cells_of(heads: Sequence[Heading], rows: Sequence[Sequence[str]], first: int) -> list[Cells]:
    """The rows under headings; `first` is the line of the first of them.

    Raises
    ------
    ValueError
        If a row has more cells than there are headings, or a kind of joint that nobody knows.
    """
    columns = columns_of(heads)
    for number, row in enumerate(rows, start=first):
        if len(row) > len(heads):
            raise ValueError(f"text: line {number} has {len(row)} cells under {len(heads)} heads; "
                             "put a text that has a comma into quotes")
        if longest := next((cell for cell, head in zip(row, heads) if len(cell) > LONGEST
                            and head.column not in (IGNORED, LABEL)), ""):
            raise ValueError(f"text: line {number} has {inputs.brief(longest)}; expected cells of "
                             f"at most {LONGEST} characters")
    padded = [[*row, *[""] * (len(heads) - len(row))] for row in rows]
    kinds = _kinds(heads, padded, first)
    texts = [_sorted({column: value_text(row[k]) for column, k in columns.items()})
             for row in padded]
    found = _found(texts, kinds)
    labels = [plain(row[columns[LABEL]]) if LABEL in columns else "" for row in padded]
    found = _numbered(found, labels)
    names = _names(heads, padded)
    return [_cells(text, kind, its, name, column)
            for text, (kind, column, its), name in zip(texts, found, names)]


def _sorted(texts: dict[str, str]) -> dict[str, str]:
    """A row with d3 under d, where a column names the variable of each joint."""
    theta = texts.get("theta", "")
    if variable(theta, "theta") or not variable(theta, "d"):
        return texts
    return texts | {"theta": "0", "d": texts["d"] if texts.get("d") not in ("0", None) else theta}


def value_text(cell: str) -> str:
    """What a cell says, plain; of a name with its value, ``d1 = 0.75`` or ``L (1.0)``, the value.

    Examples
    --------
    >>> value_text("θ2 = θ2 - 90"), value_text("$L_1$ (0.5)"), value_text("90 + (-44 -> +132)")
    ('theta2 - 90', '0.5', '90')
    """
    text = _RANGE.sub("", plain(cell))
    match = _WITH_VALUE.fullmatch(text)
    return (match[1] or match[2]).strip() if match else text.strip()


def _cells(texts: dict[str, str], kind: str, its: Variable | None, name: str,
           column: str) -> Cells:
    offset = texts.pop(OFFSET, "")
    if its:
        texts[column] = its.offset
    if offset not in _NOTHING and offset != "0" and column:
        its_own = texts.get(column, "")
        texts[column] = offset if its_own in (*_NOTHING, "0") else f"{its_own} + {offset}"
    for parameter in PARAMETERS:
        if texts.get(parameter, "").lower() in _NOTHING:
            texts[parameter] = "0"
    flip = texts.pop("flip", "") == "-" or bool(its and its.flip)
    return Cells(texts, kind, flip, name)


# ---- kinds of joints ----


def _kinds(heads: Sequence[Heading], rows: Sequence[Sequence[str]],
           first: int) -> list[str] | None:
    """What a column says of the joints' kinds; None if no column does."""
    for k, head in enumerate(heads):
        words = [plain(row[k]).lower() for row in rows]
        if head.column == KIND and set(words) <= _SIGMA.keys():
            return [_SIGMA[word] for word in words]
        long = any(len(word) > 2 and KINDS.get(word) in (REVOLUTE, PRISMATIC) for word in words)
        if head.column == KIND or (head.column == LABEL and any(words) and (
                long or set(words) <= {"r", "p", "f", "t"})):
            return [_kind(word, number) for number, word in enumerate(words, start=first)]
    return None


def _kind(word: str, number: int) -> str:
    if word not in KINDS:
        raise ValueError(f"text: line {number} has a joint {inputs.brief(word)}; "
                         "expected revolute, prismatic or fixed")
    return KINDS[word]


def _found(texts: Sequence[Mapping[str, str]], kinds: Sequence[str] | None
           ) -> list[tuple[str, str, Variable | None]]:
    """Each row's kind, the column of its variable, and the variable if its cell shows it."""
    pairs = [(variable(text.get("theta", ""), "theta"), variable(text.get("d", ""), "d"))
             for text in texts]
    if kinds is not None:
        return [_of_kind(kind, *pair) for kind, pair in zip(kinds, pairs)]
    turns = any(theta for theta, _ in pairs)
    if turns:  # then an empty cell is a variable without an offset, and 0 is not
        pairs = [(theta or _EMPTY if text.get("theta") == "" and not d else theta, d)
                 for text, (theta, d) in zip(texts, pairs)]
    slides = all(d and d.number == k for k, (_, d) in enumerate(pairs, start=1))
    return [_guessed(theta, d, text, turns, slides or turns)
            for text, (theta, d) in zip(texts, pairs)]


def _of_kind(kind: str, theta: Variable | None, d: Variable | None
             ) -> tuple[str, str, Variable | None]:
    if kind == FIXED:
        return kind, "", None
    return (kind, "theta", theta) if kind == REVOLUTE else (kind, "d", d)


def _guessed(theta: Variable | None, d: Variable | None, text: Mapping[str, str], turns: bool,
             slides: bool) -> tuple[str, str, Variable | None]:
    """The kind of a row by the cell that holds a variable; d1 beside θ1 is only a length."""
    sure = d is not None and (d.marked or text["d"].lstrip("-( ").startswith("q"))
    if theta and not (d and sure and not theta.marked):
        return REVOLUTE, "theta", theta
    if d and (sure or slides):
        return PRISMATIC, "d", d
    return (FIXED, "", None) if turns else (REVOLUTE, "theta", None)


def _numbered(found: list[tuple[str, str, Variable | None]], labels: Sequence[str]
              ) -> list[tuple[str, str, Variable | None]]:
    """The rows whose variable is another joint's lose it: their cell stays as it is."""
    moving = [(i, its) for i, (_, column, its) in enumerate(found) if column]
    shown = [(joint, i, its.number) for joint, (i, its) in enumerate(moving)
             if its and its.number is not None]
    by_joints = {number - joint for joint, _, number in shown}
    by_rows = {number - i for _, i, number in shown}
    one = len(shown) == 1 and by_joints | by_rows <= {0, 1}
    if (len(shown) > 1 and 1 in (len(by_joints), len(by_rows))) or one or all(
            str(number) == labels[i] for _, i, number in shown):
        return found
    wrong = {i for joint, i, number in shown if number != joint + 1}
    return [(kind, column, None if i in wrong else its)
            for i, (kind, column, its) in enumerate(found)]


# ---- names ----


def _names(heads: Sequence[Heading], rows: Sequence[Sequence[str]]) -> list[str]:
    """The joints' names: a column of names, or labels that are words."""
    for column in ("name", LABEL):
        for k, head in enumerate(heads):
            words = [" ".join(row[k].replace("*", "").split()) for row in rows]
            if head.column == column and any(map(_is_name, words)):
                return [word if column == "name" or _is_name(word) else "" for word in words]
    return [""] * len(rows)


def _is_name(word: str) -> bool:
    plainly = plain(word)
    return (len(plainly) > 1 and any(c.isalpha() for c in plainly) and len(word) <= 60
            and not _COUNTED.fullmatch(plainly) and plainly.lower() not in KINDS)

