"""What a check has to say: a word, and a sentence the student acts on."""
from __future__ import annotations

from dataclasses import dataclass
from html import escape

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
