"""What wrong numbers look like, whatever the exercise is: rounded, in degrees, turned round.

A hint is given only if it explains every number that is there.
"""
from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from itertools import permutations
from typing import NamedTuple

import numpy as np

from .given import Given
from .words import listed

# Relative, and absolute near zero: what was printed with six decimals and typed again counts as
# right, and so does the rounding of any formula that a student may have taken.
SAME_NUMBER = 1e-6
Names = Callable[[tuple], str]
UNITS = (1000.0, 100.0, 10.0, 0.1, 0.01, 0.001)


class Results(NamedTuple):
    """What an answer gave, beside what is right: an array for each case."""

    given: Sequence[Given]
    right: Sequence[np.ndarray]
    angles: np.ndarray | bool = False  # where an angle stands: whole turns make no difference

    def same(self, k: int, other: object) -> np.ndarray:
        """Where the numbers of a case are those of another array, or still to come."""
        numbers, other = self.given[k].numbers, np.asarray(other, dtype=float)
        gap = other - numbers
        turned = np.where(self.angles, (gap + np.pi) % (2 * np.pi) - np.pi, gap)
        size = np.where(self.angles, 1, np.abs(other))
        return (np.abs(turned) <= SAME_NUMBER * (1 + size)) | self.given[k].missing

    def all_same(self, others: Sequence[object]) -> bool:
        return all(np.all(self.same(k, other)) for k, other in enumerate(others))

    def all_after(self, change: Callable[[np.ndarray], np.ndarray]) -> bool:
        """Whether all numbers are the right ones after a change."""
        changed = [change(right) for right in self.right]
        return all(new.shape == right.shape for new, right in zip(changed, self.right)) and (
            self.all_same(changed))


def hint(results: Results, name: Names, verb: str) -> list[str]:
    """The first hint that explains all results, as a list of one, or an empty list.

    Parameters
    ----------
    results : Results
    name : callable
        Names an entry by its index.
    verb : str
        What the student has to do with the numbers: "give" or "return".
    """
    for look in (_whole, _rounded, _in_degrees, _opposite, _transposed, _reordered, _scaled):
        if words := look(results, name, verb):
            return [words]
    return []


def _whole(results: Results, name: Names, verb: str) -> str:
    """An array of whole numbers cuts off what is written into it."""
    cut = any(given.whole for given in results.given) and all(
        np.all(np.where(given.whole, given.numbers == np.trunc(right), results.same(k, right)))
        for k, (given, right) in enumerate(zip(results.given, results.right)))
    return ("Your array holds whole numbers, and decimals written into it are cut off: begin with "
            "np.zeros or np.eye, or write 1.0 for 1.") if cut else ""


def _rounded(results: Results, name: Names, verb: str) -> str:
    angles = False
    for k, (given, right) in enumerate(zip(results.given, results.right)):
        same = results.same(k, right)
        rounded = np.any([np.isclose(given.numbers, np.round(right, decimals), rtol=1e-12,
                                     atol=1e-12) & (np.abs(right) > 0.5 * 10.0**-decimals)
                          for decimals in range(1, 7)], axis=0)
        if not np.all(same | rounded):
            return ""
        angles |= bool(np.any(~same & results.angles))
    return f"It looks rounded: {verb} all digits" + (
        "; np.radians turns degrees into all of them." if angles else ".")


def _in_degrees(results: Results, name: Names, verb: str) -> str:
    in_degrees = np.any(results.angles) and results.all_after(
        lambda right: np.where(results.angles, np.degrees(right), right))
    return "Angles are in radians: np.radians(90) for 90°." if in_degrees else ""


def _opposite(results: Results, name: Names, verb: str) -> str:
    if not results.all_after(np.negative):
        return ""
    return "Its sign is turned round." if results.right[0].size == 1 else (
        "All signs are turned round.")


def _transposed(results: Results, name: Names, verb: str) -> str:
    flat = results.right[0].ndim == 2 and results.all_after(np.transpose)
    return "Rows and columns have changed places: this is the transpose." if flat else ""


def _reordered(results: Results, name: Names, verb: str) -> str:
    size = results.right[0].size
    if results.right[0].ndim != 1 or not 1 < size < 5:
        return ""
    orders = permutations(range(size))
    if not any(results.all_after(partial(np.take, indices=order)) for order in orders):
        return ""
    names = [name((i,)) for i in range(size)]
    return f"The numbers are right but in another order: asked are {listed(names)}."


def _scaled(results: Results, name: Names, verb: str) -> str:
    factor = next((factor for factor in UNITS
                   if results.all_after(partial(np.multiply, factor))), 0)
    size = f"{factor:g} times too large" if factor > 1 else f"{1 / (factor or 1):g} times too small"
    return f"All numbers are {size}: look at the unit." if factor else ""
