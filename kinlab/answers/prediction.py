"""Questions that are asked before something moves: what may be answered, and what is said to it.

A case is a question with its right answer, plain data: the browser judges by the same data where
no Python runs (kinlab/browser/verdicts.js), in the same words. The right place of a mark in the
picture is not written down: it is where the picture has it in the end, and is handed over.
"""
from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, NamedTuple

from ..arms import inputs

NO_GUESS = "No guess."
_TURN = 360.0


class Told(NamedTuple):
    """What is said to an answer: whether it is right, and a sentence or two."""

    ok: bool
    said: str


@dataclass(frozen=True, kw_only=True)
class Case:
    """One question, and where its picture stands before and after.

    Attributes
    ----------
    ask : str
        The question, plain text.
    why : str
        The sentence that explains; said to everybody.
    start, shows : {knob: value}
        Where knobs of the view stand while the question is open, and where they go once it is
        answered, in the units of their sliders; others stay where the view begins.
    seen : str
        The preset that the picture is seen from while the question is open; the view's own if
        left out.
    """

    kind: ClassVar[str] = ""
    ask: str
    why: str
    start: Mapping[str, float] = field(default_factory=dict)
    shows: Mapping[str, float] = field(default_factory=dict)
    seen: str = ""

    def read(self, answer: Any) -> Any:
        """The answer in its plain form, or a ValueError that says what was expected."""
        raise NotImplementedError

    def told(self, answer: Any, truth: Any = None) -> Told:
        """What there is to say to an answer that was read; None is no guess.

        `truth` is the right place of a mark, or the right direction of an arrow.
        """
        if answer is None:
            return Told(False, f"{NO_GUESS} {self._answer(truth)}")
        return self._told(answer, truth)

    def _told(self, answer: Any, truth: Any) -> Told:
        raise NotImplementedError

    def _answer(self, truth: Any) -> str:
        """The right answer in a sentence."""
        raise NotImplementedError

    def lines(self) -> list[str]:
        """What there is to choose from, in words."""
        return []

    def data(self) -> dict:
        """Plain data for the browser."""
        return {"kind": self.kind, "ask": self.ask, "why": self.why, "seen": self.seen}


@dataclass(frozen=True, kw_only=True)
class Choice(Case):
    """One of several texts.

    Attributes
    ----------
    options : {text: sentence}
        What is said to whoever takes it.
    right : str
        One of the texts.
    """

    kind = "choice"
    options: Mapping[str, str]
    right: str

    def read(self, answer: Any) -> str:
        return inputs.choice("answer", answer, tuple(self.options))

    def _told(self, answer: str, truth: Any) -> Told:
        ok = answer == self.right
        return Told(ok, _joined("Right." if ok else "Not so.", self.options[answer],
                                "" if ok else self._answer(truth)))

    def _answer(self, truth: Any) -> str:
        return f"The answer: {_stopped(self.right)}"

    def lines(self) -> list[str]:
        return [f"( ) {option}" for option in self.options]

    def data(self) -> dict:
        return super().data() | {"options": list(self.options.items()), "right": self.right}


@dataclass(frozen=True, kw_only=True)
class Several(Case):
    """Any number of several texts.

    Attributes
    ----------
    options : {text: sentence}
        What is said where it is wrongly taken, or wrongly left.
    right : sequence of str
        The texts that belong.
    """

    kind = "several"
    options: Mapping[str, str]
    right: Sequence[str]

    def read(self, answer: Any) -> list[str]:
        if isinstance(answer, str) or not isinstance(answer, list | tuple | set | frozenset):
            raise ValueError(f"answer: expected a list of texts, got {inputs.brief(answer)}")
        taken = {inputs.choice("answer", one, tuple(self.options)) for one in answer}
        return [option for option in self.options if option in taken]

    def _told(self, answer: list[str], truth: Any) -> Told:
        wrong = [_joined(f"“{option}” {'does not belong' if option in answer else 'is missing'}.",
                         said)
                 for option, said in self.options.items()
                 if (option in answer) != (option in self.right)]
        return Told(not wrong, _joined("Not quite." if wrong else "Right.", *wrong))

    def _answer(self, truth: Any) -> str:
        belong = [f"“{option}”" for option in self.options if option in self.right]
        return f"The answer: {', '.join(belong) or 'none of them'}."

    def lines(self) -> list[str]:
        return [f"[ ] {option}" for option in self.options]

    def data(self) -> dict:
        return super().data() | {"options": list(self.options.items()), "right": list(self.right)}


@dataclass(frozen=True, kw_only=True)
class Number(Case):
    """A number with its unit.

    Attributes
    ----------
    right, tolerance : float
    unit : str
    slips : sequence of (float, sentence)
        Wrong numbers, and what is said to them.
    turn : float
        Numbers that differ by a multiple of it are the same: 360 for an angle; 0 for none.
    """

    kind = "number"
    right: float
    tolerance: float
    unit: str = ""
    slips: Sequence[tuple[float, str]] = ()
    turn: float = 0.0

    def read(self, answer: Any) -> float:
        return _number(answer)

    def _told(self, answer: float, truth: Any) -> Told:
        off = _beyond(answer, self.right, self.turn)
        if abs(off) <= self.tolerance:
            return Told(True, f"Right. {self._answer(truth)}")
        size = f"{_short(abs(off))}{self._suffix}"
        how = f"{size} off" if self.turn else f"{size} too {'much' if off > 0 else 'little'}"
        near = _slip(self.slips, lambda wrong: abs(_beyond(answer, wrong, self.turn)),
                     self.tolerance)
        return Told(False, _joined(f"You said {_short(answer)}{self._suffix}, {how}.", near,
                                   self._answer(truth)))

    def _answer(self, truth: Any) -> str:
        return f"It is {_short(self.right)}{self._suffix}."

    @property
    def _suffix(self) -> str:
        return _suffix(self.unit)

    def data(self) -> dict:
        return super().data() | {"right": self.right, "tolerance": self.tolerance,
                                 "unit": self.unit, "slips": list(self.slips), "turn": self.turn}


@dataclass(frozen=True, kw_only=True)
class Signs(Case):
    """A letter for each entry of a matrix: which are zero, which will change, and how.

    Attributes
    ----------
    rows, columns : sequence of str
        Their names.
    right : sequence of str
        A string for each row, a letter for each entry.
    among : {letter: meaning}
    """

    kind = "signs"
    rows: Sequence[str]
    columns: Sequence[str]
    right: Sequence[str]
    among: Mapping[str, str]

    def read(self, answer: Any) -> list[str]:
        wanted = (f"answer: expected {len(self.rows)} texts of {len(self.columns)} letters, each "
                  f"one of {' '.join(self.among)}; got {inputs.brief(answer)}")
        if isinstance(answer, str) or not isinstance(answer, list | tuple):
            raise ValueError(wanted)
        if len(answer) != len(self.rows) or not all(
                isinstance(row, str) and len(row) == len(self.columns) and set(row) <= {*self.among}
                for row in answer):
            raise ValueError(wanted)
        return list(answer)

    def _told(self, answer: list[str], truth: Any) -> Told:
        pairs = [(given, right) for rows in zip(answer, self.right)
                 for given, right in zip(*rows)]
        wrong = sum(given != right for given, right in pairs)
        if not wrong:
            return Told(True, "Right, in every entry.")
        return Told(False, f"{len(pairs) - wrong} of {len(pairs)} entries are as you said; the "
                           "others are marked.")

    def _answer(self, truth: Any) -> str:
        return "The table shows the right ones."

    def lines(self) -> list[str]:
        meanings = ", ".join(f"{letter} {meaning}" for letter, meaning in self.among.items())
        return [f"{' '.join(self.columns)} in the columns, {' '.join(self.rows)} in the rows; "
                f"{meanings}"]

    def data(self) -> dict:
        return super().data() | {"rows": list(self.rows), "columns": list(self.columns),
                                 "right": list(self.right), "among": list(self.among.items())}


@dataclass(frozen=True, kw_only=True)
class Mark(Case):
    """A dot that is set in the picture, to where a thing will be.

    Attributes
    ----------
    of : str
        The thing: the name (`gid`) of an item of the scene, whose first point is meant, or "tip".
    tolerance : float
        How far off still counts, in the view's unit.
    unit : str
        That of the view's table, if left out.
    axes : str
        The coordinates of the room in which a hand moves the mark, such as "xy"; the others are
        those of the right place.
    begin : (x, y, z), optional
        Where the mark waits; where the thing is at the start, if left out.
    slips : sequence of ((x, y, z), sentence)
    """

    kind = "mark"
    of: str = "tip"
    tolerance: float
    axes: str = "xy"
    begin: tuple[float, float, float] | None = None
    slips: Sequence[tuple[Sequence[float], str]] = ()
    unit: str = ""

    def read(self, answer: Any) -> list[float]:
        return inputs.shaped("answer", answer, (3,), "a point (x, y, z)").tolist()

    def _told(self, answer: list[float], truth: Any) -> Told:
        off = math.dist(answer, truth)
        far = f"Your mark is {_short(off)}{_suffix(self.unit)} away."
        if off <= self.tolerance:
            return Told(True, f"Right. {far}")
        near = _slip(self.slips, lambda wrong: math.dist(answer, wrong), self.tolerance)
        return Told(False, _joined(far, near, self._answer(truth)))

    def _answer(self, truth: Any) -> str:
        there = [_short(truth["xyz".index(axis)]) for axis in self.axes]
        return f"It is at {', '.join(self.axes)} = {', '.join(there)}{_suffix(self.unit)}."

    def data(self) -> dict:
        return super().data() | {"of": self.of, "tolerance": self.tolerance, "axes": self.axes,
                                 "unit": self.unit,
                                 "slips": [[list(place), said] for place, said in self.slips]}


@dataclass(frozen=True, kw_only=True)
class Direction(Case):
    """An arrow that is turned in the picture, to where an axis will point.

    Attributes
    ----------
    of : str
        The name (`gid`) of the axis, such as "frame-1-x".
    about : {"x", "y", "z"}
        The axis of the room about which it turns. Degrees are counted from x about z, from y about
        x, from z about y.
    tolerance, begin : float
        Degrees: how far off still counts, and where the arrow waits.
    slips : sequence of (degrees, sentence)
    """

    kind = "direction"
    of: str
    about: str = "z"
    tolerance: float = 15.0
    begin: float = 0.0
    slips: Sequence[tuple[float, str]] = ()

    def read(self, answer: Any) -> float:
        return _number(answer)

    def _told(self, answer: float, truth: Any) -> Told:
        off = abs(_beyond(answer, truth, _TURN))
        far = f"Your arrow is {_short(off)}° off."
        if off <= self.tolerance:
            return Told(True, f"Right. {far}")
        near = _slip(self.slips, lambda wrong: abs(_beyond(answer, wrong, _TURN)), self.tolerance)
        return Told(False, _joined(far, near))

    def _answer(self, truth: Any) -> str:
        return "The picture shows it."

    def data(self) -> dict:
        return super().data() | {"of": self.of, "about": self.about, "tolerance": self.tolerance,
                                 "slips": list(self.slips)}


@dataclass(frozen=True)
class Asked:
    """A prediction of a lesson: its view, and the cases that "try another" goes through.

    Attributes
    ----------
    view : callable or None
        Makes the view whose picture stands under the question; None for a question without one.
    cases : sequence of Case
    """

    view: Callable[[], Any] | None
    cases: Sequence[Case]


def _number(answer: Any) -> float:
    if isinstance(answer, bool):
        raise ValueError(f"answer: expected a number, got {answer}")
    return float(inputs.number("answer", answer))


def _slip(slips: Sequence[tuple[Any, str]], far: Callable[[Any], float], tolerance: float) -> str:
    """What is said to the nearest of the wrong answers, if it is near."""
    near = min(slips, key=lambda slip: far(slip[0]), default=None)
    return near[1] if near and far(near[0]) <= tolerance else ""


def _beyond(answer: float, right: float, turn: float) -> float:
    """How much an answer is more than the right one; with a turn, the short way round."""
    off = answer - right
    return off - turn * math.floor(off / turn + 0.5) if turn else off


def _short(value: float) -> str:
    """A number with four digits and four decimals at most; halves go up, as in the browser."""
    short = float(f"{round(value * (1 + 1e-12), 4):.4g}") + 0.0
    return (f"{short:.0f}" if short.is_integer() else repr(short)).replace("-", "−")


def _suffix(unit: str) -> str:
    return unit if unit[:1] in ("", "°") else f" {unit}"


def _stopped(text: str) -> str:
    """A text that ends like a sentence."""
    return text if text.endswith((".", "!", "?")) else f"{text}."


def _joined(*parts: str) -> str:
    return " ".join(part for part in parts if part)
