"""Checks for students' answers: they never raise, they come back, and they name the slip.

`answers` makes judges from references and slips; `lessons` holds those of each lesson, and of some
exercises other numbers. `marks` keeps what was solved.
"""
from __future__ import annotations

import os
import re
import secrets
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import MappingProxyType
from typing import Any

from . import lessons
from .answers.judges import Judge
from .answers.time_limit import Ended, TimeIsOver, within
from .answers.varied import Draw
from .answers.verdict import BLANK, NOT_YET, Verdict
from .arms import files, inputs
from .marks import record
from .marks.report import FILE, Report, read, who, write

SECONDS = 4.0  # for one check
LONGEST = 1200  # characters of a message


def check(name: str, answer: Any, *, seconds: float | None = None) -> Verdict:
    """Judge the answer to one exercise.

    Parameters
    ----------
    name : str
        Lesson and number, such as "alpha_ii.1".
    answer : anything
        What the exercise asked for. Whatever is handed over, no exception comes back, nothing of
        it is changed, and the same answer gets the same verdict.
    seconds : float, optional
        How long the answer may take; 4 seconds if left out.

    Returns
    -------
    Verdict
        With `ok` and `message`, and with `fault` where one place of a table is wrong; in a
        notebook it shows itself as a coloured line.

    Raises
    ------
    ValueError
        If there is no exercise of this name.

    Examples
    --------
    >>> check("alpha_ii.1", ...)
    ○ Not attempted yet. Replace the ... by your function.
    >>> check("alpha_ii.4", [0, 0, 0, 0, 0]).ok
    False
    """
    return _recorded(name, _judge(name), answer, seconds)


def _recorded(name: str, judge: Judge, answer: Any, seconds: float | None) -> Verdict:
    verdict = _checked(judge, answer, SECONDS if seconds is None else seconds)
    if verdict.word != BLANK:
        record.WORK.checked(name, verdict.ok)
    return verdict


def _checked(judge: Judge, answer: Any, seconds: float) -> Verdict:
    what = "function" if callable(answer) else "answer"
    try:
        return within(seconds, lambda: judged(judge, answer))
    except TimeIsOver:
        cause = ("is there an endless loop?" if what == "function" else
                 "is it very large, or does a part of it never end?")
        return Verdict(NOT_YET, f"Your {what} did not come back within {seconds:g} seconds: "
                                f"{cause}")
    except Ended:
        return Verdict(NOT_YET, f"Your {what} ended Python instead of coming back.")
    except KeyboardInterrupt:
        return Verdict(NOT_YET, "Interrupted. Run the check again when you are ready.")


def judged(judge: Judge, answer: Any) -> Verdict:
    """What a judge says of an answer, in words of a bearable length, whatever the answer does."""
    try:
        with warnings.catch_warnings(action="ignore", category=inputs.Note):
            verdict = judge(answer)  # the verdict has the words
    except KeyboardInterrupt:
        return Verdict(NOT_YET, "Interrupted. Run the check again when you are ready.")
    except MemoryError:
        return Verdict(NOT_YET, "Your answer takes more memory than a check has.")
    except BaseException as error:  # the answer's own methods may raise anything
        verdict = Verdict(NOT_YET, "Your answer could not be read: it raised "
                                   f"{type(error).__name__[:LONGEST // 2]}. Hand over what the "
                                   "exercise asks for.")
    if len(verdict.message) > LONGEST:
        verdict = replace(verdict, message=f"{verdict.message[:LONGEST]}...")
    return verdict


@dataclass(frozen=True)
class Variant:
    """An exercise with numbers of its own. Shown in a notebook, it asks.

    Attributes
    ----------
    name : str
    seed : str
        The same name and seed have the same numbers, on every machine.
    ask : str
        The task, as Markdown.
    numbers : {name: number, tuple of numbers or array}
        Those that the task gives.
    judge : Judge
        What judges an answer to these numbers.
    """

    name: str
    seed: str
    ask: str
    numbers: Mapping[str, Any] = field(compare=False)  # name and seed say which
    judge: Judge = field(repr=False, compare=False)

    def check(self, answer: Any, *, seconds: float | None = None) -> Verdict:
        """Judge the answer to this variant, as `check` does that of the lesson's exercise."""
        return _recorded(f"{self.name} {self.seed}", self.judge, answer, seconds)

    def __repr__(self) -> str:
        return f"{self._title()}\n{self.ask}"

    def _repr_markdown_(self) -> str:
        return f"**{self._title()}**\n\n{self.ask}"

    def _title(self) -> str:
        seed = re.sub(r"[^\w .,-]", "?", self.seed)  # nothing in it can be Markdown or HTML
        return f"Exercise {self.name}, variant {seed}"


def variant(name: str, seed: int | str | None = None) -> Variant:
    """An exercise with other numbers: to try it again, or for each student their own.

    Parameters
    ----------
    name : str
        Of an exercise with numbers, such as "translation.1".
    seed : int or str, optional
        A number, or a text such as a student's name; by chance if left out.

    Returns
    -------
    Variant
        It shows its task. Hand your answer to its `check`.

    Raises
    ------
    ValueError
        If this exercise has no variants; the message names those that have.

    Examples
    --------
    >>> mine = variant("translation.3", seed="Ada")
    >>> mine.numbers == variant("translation.3", seed="Ada").numbers
    True
    >>> mine.check(...)
    ○ Not attempted yet. Replace the ... by your numbers.
    """
    known = lessons.variants()
    one = known[inputs.choice("name", name, tuple(known))]
    if seed is None:
        seed = secrets.randbelow(10**6)
    if isinstance(seed, bool) or not isinstance(seed, int | str):
        raise ValueError(f"seed: expected a whole number or a text, got {inputs.brief(seed)}")
    seed = inputs.line("seed", str(seed)).strip()
    drawn = one.draw(Draw(f"{name} {seed}"))
    return Variant(name, seed, one.ask(**drawn), MappingProxyType(one.given(**drawn)),
                   one.judge(**drawn))


def report(name: str = "", path: str | os.PathLike = FILE) -> Report:
    """Show what you have solved, tried and predicted, and write it into one small file.

    Run it at the end of each lesson, in the same folder: the file grows with your work. Hand it in
    as it is; its seal no longer fits after an edit by hand. A variant that was solved stands beside
    its exercise, with its seed.

    Parameters
    ----------
    name : str, optional
        Your name; if left out, the one in the file, or whoever is logged in.
    path : str or path
        Where the file is; ``kinlab_report.json`` in this folder if left out.

    Returns
    -------
    Report

    Raises
    ------
    ValueError
        If the file cannot be written, or is there already and is no report that can be trusted.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     report("Ada", folder + "/ada.json").name
    'Ada'
    """
    inputs.line("name", name)
    target = files.target("path", path, (".json",), "reports are found by their ending")
    before = _kept(target) or Report("", {})
    whose = name or before.name or who()
    formerly = dict.fromkeys([*before.formerly, before.name])
    made = Report(whose, {**before.sessions, record.KEY: record.THIS},
                  formerly=tuple(one for one in formerly if one not in ("", whose)),
                  path=target)
    write(made, target)
    return made


def _kept(path: Path) -> Report | None:
    """The report that is in a file, if there is one."""
    if not os.path.lexists(path):
        return None
    try:
        kept = read(path)
    except ValueError as error:
        raise ValueError(f"path: {str(path)!r} is there and is no report ({error}); it stays as it "
                         "is: give another name with path=") from None
    if kept.edited:
        raise ValueError(f"path: {str(path)!r} was edited by hand; it stays as it is: give another "
                         "name with path=, or take the file away")
    return kept


def _judge(name: Any) -> Judge:
    lesson = inputs.choice("name", name.partition(".")[0] if isinstance(name, str) else name,
                           lessons.names())
    known = lessons.judges(lesson)
    return known[inputs.choice("name", name, tuple(known))]
