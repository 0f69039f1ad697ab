"""What has been tried, solved and predicted, as plain data: in this kernel, or in several.

A session is what one kernel has seen. Sessions are put together when a report is read, and never
added up in a file: who writes a report twice has not tried twice.
"""
from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field, fields
from datetime import UTC, datetime
from typing import Any
from uuid import uuid4

from .. import __version__
from ..arms import inputs

_TIME = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ")


def now() -> str:
    """The time, to the second, as every clock in the world writes it."""
    return datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%SZ")


@dataclass
class Work:
    """What has been done, by the names of exercises and predictions.

    A variant has a name of its own: that of its exercise, a space, and its seed.

    Attributes
    ----------
    tries : {exercise: int}
        How often it was checked until it was right.
    solved : {exercise: str}
        When it was right for the first time.
    predicted : {prediction: {case: bool}}
        Whether the first answer to each case was right.
    """

    tries: dict[str, int] = field(default_factory=dict)
    solved: dict[str, str] = field(default_factory=dict)
    predicted: dict[str, dict[str, bool]] = field(default_factory=dict)

    @property
    def unsolved(self) -> set[str]:
        """What was tried and not solved."""
        return set(self.tries) - set(self.solved)

    @property
    def first_answers(self) -> list[bool]:
        """Whether the first answer was right, of all cases of all predictions."""
        return [ok for cases in self.predicted.values() for ok in cases.values()]

    def checked(self, name: str, ok: bool) -> None:
        """An attempt at an exercise; those after it was solved no longer count."""
        if name not in self.solved:
            self.tries[name] = self.tries.get(name, 0) + 1
        if ok:
            self.solved.setdefault(name, now())

    def answered(self, name: str, case: int, ok: bool) -> None:
        """A prediction that was committed; an answer is not changed afterwards."""
        self.predicted.setdefault(name, {}).setdefault(str(case), ok)


def together(parts: Iterable[Work]) -> Work:
    """All that was done in several sessions, the earliest first."""
    whole = Work()
    for part in parts:
        for name, tries in part.tries.items():
            if name not in whole.solved:
                whole.tries[name] = whole.tries.get(name, 0) + tries
        whole.solved = part.solved | whole.solved
        for name, cases in part.predicted.items():
            whole.predicted[name] = cases | whole.predicted.get(name, {})
    return whole


@dataclass(frozen=True)
class Session:
    """What one kernel has seen: since when, with which kinlab, and the work itself."""

    began: str
    version: str
    work: Work

    @classmethod
    def of(cls, data: Any) -> Session:
        """A session out of a file; ValueError where there is anything else."""
        told = _dictionary(data)
        return cls(time_of(told.get("began")), inputs.line("version", told.get("version")),
                   _work(_dictionary(told.get("work"))))


KEY, THIS = uuid4().hex[:12], Session(now(), __version__, Work())  # this kernel's
WORK = THIS.work


def time_of(text: Any) -> str:
    """A time as `now` writes it; ValueError for anything else."""
    if not isinstance(text, str) or not _TIME.fullmatch(text):
        raise ValueError("expected a time")
    return text


def _work(data: dict[str, Any]) -> Work:
    work = Work(**{each.name: _dictionary(data.get(each.name)) for each in fields(Work)})
    kinds: list[tuple[dict[str, Any], type]] = [
        (work.tries, int), (work.solved, str),
        *((_dictionary(cases), bool) for cases in work.predicted.values())]
    for values, kind in kinds:
        if not all(type(value) is kind for value in values.values()):
            raise ValueError(f"expected values of the kind {kind.__name__}")
    return work


def _dictionary(value: Any) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise ValueError("expected names with values")
    return value
