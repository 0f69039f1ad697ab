"""The numbers that an answer holds, and where one is still to come.

What is handed over is never written to: all that is read here is a copy.
"""
from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from ..arms import inputs
from .words import of_shape

DEEPEST = 8  # lists in lists
MOST = 1000  # things in an answer; who gives more is not read on


class Given(NamedTuple):
    """Numbers of an answer; nan where it has a stub."""

    numbers: np.ndarray
    whole: bool = False  # they come in an array that can hold whole numbers only

    @property
    def missing(self) -> np.ndarray:
        return np.isnan(self.numbers)


def is_stub(value: Any) -> bool:
    """True for what stands in an exercise before it is done: ... or None."""
    return value is None or value is ...


def length(value: Any) -> int:
    """How many things an array or a list holds, lists in lists aside."""
    if isinstance(value, np.ndarray):
        return value.size
    return len(value) if isinstance(value, (list, tuple, str, bytes)) else 0


def untouched(value: Any) -> bool:
    """Whether there is nothing but stubs in nested lists or arrays."""
    stubs = _stubs(value)
    return next(stubs, False) and all(stubs)


def unfinished(value: Any) -> bool:
    """Whether there is a stub somewhere in nested lists or arrays."""
    return any(_stubs(value))


def _stubs(value: Any, depth: int = 0) -> Iterator[bool]:
    """Of each thing in nested lists whether it is a stub."""
    if isinstance(value, np.ndarray) and value.dtype != object:
        yield from [False] * bool(value.size)
    elif isinstance(value, (list, tuple)) or (isinstance(value, np.ndarray) and value.ndim):
        for part in value if depth < DEEPEST else ():
            yield from _stubs(part, depth + 1)
    else:
        yield is_stub(value)


def numbers(value: Any, shape: tuple[int, ...], *, wanted: str = "", start: str = "Your answer",
            who: str = "you") -> Given:
    """The numbers of an answer in a shape, or a ValueError that says what was wrong.

    A column, or a row in brackets of its own, is taken for a list of its numbers.

    Parameters
    ----------
    value : anything
    shape : tuple of int
    wanted : str
        What should be there; the shape in words if left out.
    start, who : str
        How the message begins, and who gave the value.

    Examples
    --------
    >>> numbers([[1], [2]], (2,)).numbers
    array([1., 2.])
    >>> numbers([1, 2], (3,))
    Traceback (most recent call last):
        ...
    ValueError: Your answer: expected three numbers; you gave two numbers
    """
    wanted = wanted or of_shape(shape)
    if (size := length(value)) > MOST:
        raise ValueError(f"{start}: expected {wanted}; {who} gave {size}")
    if unfinished(value):
        return Given(_filled(value, shape, f"{start}: expected {wanted}; {who} gave another shape"))
    if hasattr(value, "q") and hasattr(value, "success"):
        raise ValueError(f"{start}: expected {wanted}; {who} gave a solver's whole result. "
                         "Hand over its .q")
    array = inputs.real_array(start, value, wanted)
    if array.size != np.prod(shape) or _long_axes(array.shape) != _long_axes(shape):
        raise ValueError(f"{start}: expected {wanted}; {who} gave {of_shape(array.shape)}")
    whole = isinstance(value, np.ndarray) and value.dtype.kind in "iu"
    return Given(array.reshape(shape), whole)


def _long_axes(shape: tuple[int, ...]) -> tuple[int, ...]:
    return tuple(size for size in shape if size != 1)


def _filled(value: Any, shape: tuple[int, ...], refusal: str) -> np.ndarray:
    """The numbers, with nan in place of each stub."""
    if is_stub(value):
        return np.full(shape, np.nan)
    if not unfinished(value):
        return numbers(value, shape).numbers
    if not shape or len(value) != shape[0]:
        raise ValueError(refusal)
    return np.array([_filled(part, shape[1:], refusal) for part in value])
