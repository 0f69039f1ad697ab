"""What a check has to say: a word, a sentence the student acts on, and where the fault is."""
from __future__ import annotations

from dataclasses import dataclass, field
from html import escape

CORRECT, NOT_YET, BLANK = "Correct", "Not yet", "Not attempted yet"
# Symbol and colour of the bar. The word says it too, and the text keeps the page's own colour,
# so that it reads in a light and in a dark theme and without colours.
_LOOKS = {CORRECT: ("✓", "0, 158, 115"), NOT_YET: ("✗", "213, 94, 0"),
          BLANK: ("○", "128, 128, 128")}


@dataclass(frozen=True)
class Fault:
    """Where an answer is wrong.

    Attributes
    ----------
    row : int
        Of the table as the student wrote it, counted from 1.
    column : {"theta", "d", "a", "alpha", "kind"} or None
        None where the row as a whole is meant.
    value, expected : float or str, optional
        What stands there and what should: in radians or in the arm's unit, or the kind of joint.
        Two faults in the same place are equal, whatever stands there.
    """

    row: int
    column: str | None = None
    value: float | str | None = field(default=None, compare=False)
    expected: float | str | None = field(default=None, compare=False)


@dataclass(frozen=True)
class Verdict:
    """What a check has to say.

    Attributes
    ----------
    word : {"Correct", "Not yet", "Not attempted yet"}
    message : str
    ok : bool
    fault : Fault or None
        Where the answer is wrong, if that is one place of a table.

    Examples
    --------
    >>> Verdict(NOT_YET, "Joint 2: the length a2 is 170; it should be 177.8.", Fault(2, "a"))
    ✗ Not yet. Joint 2: the length a2 is 170; it should be 177.8.
    """

    word: str
    message: str
    fault: Fault | None = None

    @property
    def ok(self) -> bool:
        return self.word == CORRECT

    def __repr__(self) -> str:
        return f"{_LOOKS[self.word][0]} {self.word}. {self.message}"

    def _repr_html_(self) -> str:
        symbol, colour = _LOOKS[self.word]
        return (f'<div role="status" style="border-left: 6px solid rgb({colour}); '
                f'padding: 0.5em 0.9em; background: rgba({colour}, 0.12)">'
                f"<strong>{symbol} {self.word}.</strong> "
                f"{escape(self.message)}</div>")
