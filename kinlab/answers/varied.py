"""Exercises with other numbers: a seed draws them, and the same seed draws the same ones again."""
from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from .judges import Judge

T = TypeVar("T")


class Draw:
    """Numbers by chance, the same for a seed in every Python: `random()` alone promises that.

    Examples
    --------
    >>> Draw("Ada").one_of([30, 45, 60]) == Draw("Ada").one_of([30, 45, 60])
    True
    """

    def __init__(self, seed: str) -> None:
        self._random = random.Random(seed)

    def one_of(self, values: Sequence[T]) -> T:
        return values[int(self._random.random() * len(values))]

    def whole(self, low: int, high: int, *, but: Sequence[int] = (0,)) -> int:
        """A whole number from `low` to `high`, none of those in `but`."""
        return self.one_of([k for k in range(low, high + 1) if k not in but])


@dataclass(frozen=True)
class Varied:
    """An exercise whose numbers may be others.

    Attributes
    ----------
    ask : callable
        Takes the numbers by their names and returns the task, as Markdown.
    draw : callable
        Takes a `Draw` and returns the numbers by their names.
    judge : callable
        Takes the numbers by their names and returns the judge of an answer.
    given : callable
        Takes the numbers by their names and returns those that the task gives; all of them if left
        out. Where the numbers are what is asked for, it is what was made of them.
    """

    ask: Callable[..., str]
    draw: Callable[[Draw], Mapping[str, Any]]
    judge: Callable[..., Judge]
    given: Callable[..., Mapping[str, Any]] = dict
