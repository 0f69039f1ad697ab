"""Checks for students' answers: they never raise, and they name the slip.

`answers` makes judges from references and slips; `lessons` holds those of each lesson.
"""
from __future__ import annotations

import warnings
from typing import Any

from . import lessons
from .answers.judges import Judge
from .answers.verdict import NOT_YET, Verdict
from .arms import inputs


def check(name: str, answer: Any) -> Verdict:
    """Judge the answer to one exercise.

    Parameters
    ----------
    name : str
        Lesson and number, such as "alpha_ii.1".
    answer : anything
        What the exercise asked for. Whatever is handed over, no exception comes back.

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
    judge = _judge(name)
    try:
        with warnings.catch_warnings(action="ignore", category=inputs.Note):
            return judge(answer)  # the verdict has the words
    except (Exception, SystemExit) as error:  # the answer's own methods may raise anything
        return Verdict(NOT_YET, "Your answer could not be read: it raised "
                                f"{type(error).__name__}. Hand over what the exercise asks for.")


def _judge(name: Any) -> Judge:
    lesson = inputs.choice("name", name.partition(".")[0] if isinstance(name, str) else name,
                           lessons.names())
    known = lessons.judges(lesson)
    return known[inputs.choice("name", name, tuple(known))]
