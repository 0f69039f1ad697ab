"""Base and tool frames as typed: x, y, z and three turns, one DH row, or a matrix carried along."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..arms import inputs
from ..arms.arm import CONVENTIONS
from ..arms.arm import row_of as standard_row_of
from ..arms.link import PARAMETERS
from ..arms.motions import ROTATE, TRANSLATE, Motion, X, Y, Z, follow, matrix, motions_of
from ..arms.transforms import inverse
from .cells import angle_text, number_text

ENDS = ("base", "tool")
POSE, ROW = "pose", "row"
# Turns about the fixed axes x, y, z, one after the other: about its own axes, z comes first.
_POSE = ((TRANSLATE, X, "x"), (TRANSLATE, Y, "y"), (TRANSLATE, Z, "z"),
         (ROTATE, Z, "yaw"), (ROTATE, Y, "pitch"), (ROTATE, X, "roll"))
FORMS = {POSE: ("x", "y", "z", "roll", "pitch", "yaw"), ROW: PARAMETERS}
TURNS = ("roll", "pitch", "yaw", "theta", "alpha")
_FORM_OF = {len(columns): form for form, columns in FORMS.items()}
_SAME = 1e-9  # in entries, as part of the largest one

Matrix = tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class End:
    """A base or tool frame of a table.

    Attributes
    ----------
    texts : tuple of str
        What is typed: six texts (x, y, z, roll, pitch, yaw), or four (theta, d, a, alpha).
    given : 4x4 tuple or None
        A matrix that came from elsewhere; it stays as it is until a cell is typed.

    Examples
    --------
    >>> End(("0", "0", "0.303", "0", "0", "0")).form
    'pose'
    """

    texts: tuple[str, ...] = ()
    given: Matrix | None = None

    @classmethod
    def of(cls, T: np.ndarray) -> End | None:
        """The frame of a matrix; None where it changes nothing."""
        if np.array_equal(T, np.eye(4)):
            return None
        return cls(given=tuple(map(tuple, (T + 0.0).tolist())))  # no -0.0

    @classmethod
    def empty(cls, form: str) -> End:
        """A frame to type into, which changes nothing yet."""
        return cls(("0",) * len(FORMS[form]))

    @classmethod
    def read(cls, end: str, words: Sequence[Any]) -> End | None:
        """The frame that `words` wrote: its form and its cells, or 16 numbers, row by row.

        Raises
        ------
        ValueError
            If it is none of them, or the numbers are no rigid matrix.
        """
        given = list(words)
        while given and given[-1] == "":  # a spreadsheet adds empty cells, or leaves them out
            given.pop()
        form, *texts = given or [""]
        if form in FORMS and len(texts) <= (size := len(FORMS[form])):
            return cls((*texts, *[""] * size)[:size])
        try:
            rows = np.array([float(word) for word in given]).reshape(4, 4).tolist()
        except (TypeError, ValueError):
            raise ValueError(f"{end}: expected 16 numbers, row by row, or pose, x, y, z, roll, "
                             "pitch, yaw, or row, theta, d, a, alpha; "
                             f"got {inputs.brief(given)}") from None
        return cls.of(inputs.rigid(end, rows))

    @property
    def form(self) -> str:
        """What is typed: 'pose' or 'row'. A given matrix is shown as a pose."""
        return _FORM_OF.get(len(self.texts), POSE)

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of its cells."""
        return FORMS[self.form]

    @property
    def words(self) -> tuple[str, ...]:
        """The frame as a file keeps it: its form and its texts, or 16 numbers."""
        return tuple(map(repr, sum(self.given, ()))) if self.given else (self.form, *self.texts)

    def cells(self, angles: str) -> dict[str, str]:
        """The text of each cell; those of a given matrix are worked out."""
        if self.given is None:
            return dict(zip(self.columns, self.texts))
        values = pose_of(np.array(self.given))
        return {column: cell_text(column, value, angles) for column, value in values.items()}

    def with_cells(self, cells: dict[str, str], angles: str) -> End:
        """Some cells typed: from now on the texts count."""
        return End(tuple((self.cells(angles) | cells)[column] for column in self.columns))

    def in_form(self, form: str, T: np.ndarray, angles: str, convention: str) -> End:
        """The same frame, whose matrix is T, to be typed in another form.

        Raises
        ------
        ValueError
            If the frame is more than one DH row.
        """
        values = pose_of(T) if form == POSE else row_of(T, convention)
        return End(tuple(cell_text(column, values[column], angles) for column in FORMS[form]))

    def matrix(self, values: Mapping[str, float], convention: str) -> np.ndarray:
        """The frame, shape (4, 4), of what its cells say (rad, lengths)."""
        if self.given is not None:
            return np.array(self.given)
        order = _POSE if self.form == POSE else CONVENTIONS[convention]
        return _built(order, values)

    def scaled(self, factor: float) -> End:
        """A given matrix with its lengths in another unit; texts stay as they are."""
        if self.given is None:
            return self
        scaled = np.array(self.given)
        scaled[:3, 3] *= factor
        return replace(self, given=tuple(map(tuple, scaled.tolist())))


def pose_of(T: np.ndarray) -> dict[str, float]:
    """x, y, z and the turns roll, pitch, yaw about the fixed axes x, y, z (rad) of a frame.

    Examples
    --------
    >>> from math import pi
    >>> pose_of(np.diag([-1.0, -1, 1, 1]))["yaw"] == pi
    True
    """
    found = {(motion.kind, motion.axis): float(motion.amount) for motion in motions_of(T)}
    values = {name: found.get((kind, axis), 0.0) for kind, axis, name in _POSE}
    return {name: values[name] for name in FORMS[POSE]}


def row_of(T: np.ndarray, convention: str) -> dict[str, float]:
    """theta, d, a, alpha of the DH row that makes a frame.

    Raises
    ------
    ValueError
        If no row does.

    Examples
    --------
    >>> T = np.eye(4)
    >>> T[:3, 3] = 1, 0, 2
    >>> row_of(T, "standard")
    {'theta': 0.0, 'd': 2.0, 'a': 1.0, 'alpha': 0.0}
    """
    # Read backwards, a modified row is a standard one with its signs changed.
    sign, read = (1, T) if convention == "standard" else (-1, inverse(T))
    row = {name: sign * value + 0.0 for name, value in standard_row_of(read).items()}
    largest = max(1.0, float(np.abs(T).max()))
    if np.abs(_built(CONVENTIONS[convention], row) - T).max() > _SAME * largest:
        raise ValueError("form: expected a frame that one DH row makes, got one with more turns or "
                         "shifts; keep x, y, z and three turns")
    return row


def cell_text(column: str, value: float, angles: str) -> str:
    """The text of a number in a cell of an end."""
    return angle_text(value, angles) if column in TURNS else number_text(value)


def _built(order: Sequence[tuple[str, int, str]], values: Mapping[str, float]) -> np.ndarray:
    return matrix(follow([Motion(kind, axis, values[name]) for kind, axis, name in order], ()))
