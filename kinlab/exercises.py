"""Checks for students' answers: they never raise, they come back, and they name the slip.

`answers` makes judges from references and slips; `lessons` holds those of each lesson.
"""
from __future__ import annotations

import warnings
from dataclasses import replace
from typing import Any

from . import lessons
from .answers.judges import Judge
from .answers.time_limit import Ended, TimeIsOver, within
from .answers.verdict import NOT_YET, Verdict
from .arms import inputs

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
    judge, what = _judge(name), "function" if callable(answer) else "answer"
    seconds = SECONDS if seconds is None else seconds
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


def _judge(name: Any) -> Judge:
    lesson = inputs.choice("name", name.partition(".")[0] if isinstance(name, str) else name,
                           lessons.names())
    known = lessons.judges(lesson)
    return known[inputs.choice("name", name, tuple(known))]
