"""Calls of a student's function: with copies of the numbers, and with an eye on what it calls."""
from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from copy import deepcopy
from types import FrameType
from typing import Any, NamedTuple

import numpy as np

_PACKAGE, _JUDGES = __name__.partition(".")[0], __name__.rpartition(".")[0]


class Call(NamedTuple):
    """What came of a call: a result, or the error that was raised."""

    result: Any = None
    error: BaseException | None = None
    changed: tuple[int, ...] = ()  # the arguments that the function wrote into
    helper: str = ""  # the first of kinlab's own functions that it called


def called(function: Callable, arguments: Sequence[Any], *, watched: bool = False) -> Call:
    """Call a function with copies of some arguments; it may do with them what it likes.

    Parameters
    ----------
    function : callable
    arguments : sequence
    watched : bool
        Whether to look for kinlab's own functions among those that it calls.

    Examples
    --------
    >>> called(lambda numbers: numbers.pop(), [[1, 2]])
    Call(result=2, error=None, changed=(0,), helper='')
    """
    copies, watch = deepcopy(list(arguments)), _Watch()
    before = sys.getprofile()
    try:
        if watched:
            sys.setprofile(watch)
        try:
            result = function(*copies)
        finally:
            if watched:
                sys.setprofile(before)
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # the student's own code: a check says what it said
        return Call(error=error, helper=watch.helper)
    changed = tuple(i for i, pair in enumerate(zip(copies, arguments)) if not _alike(*pair))
    return Call(deepcopy(result) if isinstance(result, _MUTABLE) else result, None, changed,
                watch.helper)


_MUTABLE = (list, np.ndarray)  # that a function may hand out again and write into


def _alike(one: Any, other: Any) -> bool:
    """Whether two arguments, made of numbers in arrays and lists, are the same."""
    return np.array_equal(one, other)


class _Watch:
    """Remembers the first public function of kinlab that is called."""

    helper = ""

    def __call__(self, frame: FrameType, event: str, argument: Any) -> None:
        name = frame.f_code.co_name
        if event == "call" and not (self.helper or name.startswith(("_", "<"))) and _is_ours(frame):
            self.helper = name


def _is_ours(frame: FrameType) -> bool:
    """Whether it is kinlab's, and not of the judges: what is printed meanwhile goes to them."""
    name = frame.f_globals.get("__name__")
    return (isinstance(name, str) and name.partition(".")[0] == _PACKAGE
            and name.rpartition(".")[0] != _JUDGES)
