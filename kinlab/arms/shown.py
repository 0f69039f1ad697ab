"""Results as a lesson shows them: named, rounded, a matrix in rows."""
from __future__ import annotations

from typing import Any

import numpy as np

from . import inputs

_DIGITS = 4


class Shown:
    """Named results, to be read: what `show` returns."""

    def __init__(self, values: dict[str, Any], digits: int) -> None:
        self._values, self._digits = values, digits

    def __repr__(self) -> str:
        return "\n".join(_named(name, value, self._digits)
                         for name, value in self._values.items())


def show(*, digits: int = _DIGITS, **values: Any) -> Shown:
    """Results under their names, rounded; a matrix in rows, a list of points in lines.

    Parameters
    ----------
    digits : int
        Decimals that are left.
    **values : number, array or anything else
        What is to be shown, in this order. Anything but numbers is shown as it is printed.

    Returns
    -------
    Shown
        Its text is the last value of a cell.

    Raises
    ------
    ValueError
        If `digits` is no whole number from 0 on.

    Examples
    --------
    >>> import numpy as np
    >>> show(c_0=[-0.5, 1.2], angle=np.degrees(np.pi / 6))
    c_0 = (-0.5, 1.2)
    angle = 30
    >>> show(R=[[0, -1], [1, 1e-17]])
    R =  0  -1
         1   0
    """
    return Shown(values, inputs.whole("digits", digits, 0))


def _named(name: str, value: Any, digits: int) -> str:
    lines = _lines(value, digits)
    return "\n".join(f"{name + ' = ' if k == 0 else ' ' * (len(name) + 3)}{line}"
                     for k, line in enumerate(lines))


def _lines(value: Any, digits: int) -> list[str]:
    """What stands behind the name, a line for each row."""
    try:
        array = np.asarray(value)
    except ValueError:
        return str(value).splitlines() or [""]
    if array.dtype.kind not in "fiu":
        return str(value).splitlines() or [""]
    words = np.vectorize(lambda one: _short(one, digits), otypes=[object])(array)
    if array.ndim == 0:
        return [str(words)]
    if array.ndim == 1:
        return [f"({', '.join(words)})"]
    if array.ndim > 2:
        return str(np.round(array, digits) + 0.0).splitlines()
    widths = [max(map(len, column)) for column in words.T]
    return ["  ".join(f"{word:>{max(width, 2)}}" for word, width in zip(row, widths))
            for row in words]


def _short(value: float, digits: int) -> str:
    """A number with no more decimals than it needs, and no negative zero."""
    return f"{round(float(value), digits) + 0.0:.{digits}f}".rstrip("0").rstrip(".") \
        if digits else f"{round(float(value)) + 0:d}"
