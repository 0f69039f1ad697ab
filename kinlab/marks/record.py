"""What has been tried, solved and predicted, as plain data: in this kernel, or in several.

A session is what one kernel has seen. Sessions are put together when a report is read, and never
added up in a file: who writes a report twice has not tried twice.
"""
from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, fields
from datetime import UTC, datetime
from typing import Any
from uuid import uuid4

from .. import __version__


def now() -> str:
    """The time, to the second, as every clock in the world writes it."""
    return datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%SZ")


@dataclass
class Work:
    """What has been done, by the names of exercises and predictions.

    Attributes
    ----------
    tries : {exercise: int}
        How often it was checked until it was right.
    solved : {exercise: str}
        When it was right for the first time.
    seeds : {exercise: list of str}
        Variants that were solved.
    predicted : {prediction: {case: bool}}
        Whether the first answer to each case was right.
    """

    tries: dict[str, int] = field(default_factory=dict)
    solved: dict[str, str] = field(default_factory=dict)
    seeds: dict[str, list[str]] = field(default_factory=dict)
    predicted: dict[str, dict[str, bool]] = field(default_factory=dict)

    def checked(self, name: str, ok: bool, seed: str | None = None) -> None:
        """An attempt at an exercise; those after it was solved no longer count."""
        if name not in self.solved:
            self.tries[name] = self.tries.get(name, 0) + 1
        if ok:
            self.solved.setdefault(name, now())
            if seed is not None and seed not in (seeds := self.seeds.setdefault(name, [])):
                seeds.append(seed)

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
        for name, seeds in part.seeds.items():
            whole.seeds[name] = list(dict.fromkeys([*whole.seeds.get(name, []), *seeds]))
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
        began, version = told.get("began"), told.get("version")
        if not isinstance(began, str) or not isinstance(version, str):
            raise ValueError("expected when it began, and the version")
        return cls(began, version, _work(_dictionary(told.get("work"))))


KEY, THIS = uuid4().hex[:12], Session(now(), __version__, Work())  # this kernel's
WORK = THIS.work


def _work(data: dict[str, Any]) -> Work:
    work = Work(**{each.name: _dictionary(data.get(each.name)) for each in fields(Work)})
    kinds: list[tuple[dict[str, Any], type]] = [
        (work.tries, int), (work.solved, str), (work.seeds, list),
        *((_dictionary(cases), bool) for cases in work.predicted.values())]
    for values, kind in kinds:
        if not all(type(value) is kind for value in values.values()):
            raise ValueError(f"expected values of the kind {kind.__name__}")
    if not all(isinstance(seed, str) for seeds in work.seeds.values() for seed in seeds):
        raise ValueError("expected seeds as texts")
    return work


def _dictionary(value: Any) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise ValueError("expected names with values")
    return value
