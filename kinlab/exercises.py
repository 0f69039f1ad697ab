"""Checks for students' answers: they never raise, and they name the slip.

`judging` makes judges from references and slips; `lessons` holds those of each lesson.
"""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from html import escape
from typing import Any

from . import checks, lessons
from .judging import Blank, Wrong

CORRECT, NOT_YET, BLANK = "Correct", "Not yet", "Not attempted yet"
# Symbol and colour of the bar. The word says it too, and the text keeps the page's own colour,
# so that it reads in a light and in a dark theme and without colours.
_LOOKS = {CORRECT: ("✓", "0, 158, 115"), NOT_YET: ("✗", "213, 94, 0"),
          BLANK: ("○", "128, 128, 128")}


@dataclass(frozen=True)
class Verdict:
    """What a check has to say.

    Attributes
    ----------
    word : {"Correct", "Not yet", "Not attempted yet"}
    message : str
    ok : bool
    """

    word: str
    message: str

    @property
    def ok(self) -> bool:
        return self.word == CORRECT

    def __repr__(self) -> str:
        return f"{_LOOKS[self.word][0]} {self.word}. {self.message}"

    def _repr_html_(self) -> str:
        symbol, colour = _LOOKS[self.word]
        return (f'<div style="border-left: 6px solid rgb({colour}); padding: 0.5em 0.9em; '
                f'background: rgba({colour}, 0.12)"><strong>{symbol} {self.word}.</strong> '
                f"{escape(self.message)}</div>")


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
        With `ok` and `message`; in a notebook it shows itself as a coloured line.

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
        return Verdict(CORRECT, judge(answer))
    except Blank as blank:
        return Verdict(BLANK, str(blank))
    except Wrong as wrong:
        return Verdict(NOT_YET, str(wrong))
    except (Exception, SystemExit) as error:  # the answer's own methods may raise anything
        return Verdict(NOT_YET, "Your answer could not be read: it raised "
                                f"{type(error).__name__}. Hand over what the exercise asks for.")


def _judge(name: Any) -> Callable[[Any], str]:
    lesson = checks.choice("name", name.partition(".")[0] if isinstance(name, str) else name,
                           lessons.names())
    known = lessons.judges(lesson)
    return known[checks.choice("name", name, tuple(known))]
