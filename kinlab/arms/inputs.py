"""Refuse bad input once, at the public entry, in one sentence a student understands."""
from __future__ import annotations

import math
import sys
import warnings
from dataclasses import FrozenInstanceError
from numbers import Integral
from typing import Any, NoReturn, TypeVar
from unicodedata import category

import numpy as np
from numpy.typing import ArrayLike

# A matrix may be off by this much without a word: well above the rounding of float32, below any
# number that was read off a page.
RIGID_TOLERANCE = 1e-6
# Numbers read off a page have 3 decimals or more: each is off by at most half of the last one.
PRINTED = 0.5e-3
# Far beyond any arm; products of three such numbers are still finite.
LARGEST = 1e100
MOST = 10**9
_PLAIN = "give plain numbers"
TWO_TURNS = 4 * math.pi  # rad: few joints go farther, and most angles in degrees do
_NO_TEXT = ("Cc", "Cs", "Zl", "Zp")  # control characters, halves of one, ends of a line
_PACKAGE = __name__.split(".")[0]
_NOT_SPATIAL = {(2, 2): "a planar rotation has one angle, atan2(r21, r11)",
                (4, 4): "take T[:3, :3], the rotation of a pose T"}


class Note(UserWarning):
    """A word about an input that was taken, but not quite as it was given."""


def note(text: str) -> None:
    """Say a word that is no error, as a warning at the student's own line."""
    warnings.warn(text, Note, stacklevel=_levels_up_to_the_student())


def _levels_up_to_the_student() -> int:
    """The stacklevel at which the caller of this warns of the first line outside the package."""
    level, frame = 1, sys._getframe(1)
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] == _PACKAGE:
        level, frame = level + 1, frame.f_back
    return level


Class = TypeVar("Class", bound=type)


def lasting(cls: Class) -> Class:
    """A frozen dataclass that says how to make another one of it to who tries to change it."""
    def refuse(self: Any, name: str, *value: Any) -> NoReturn:
        raise FrozenInstanceError(f"{name}: this {cls.__name__} does not change; make another one "
                                  f"with dataclasses.replace(..., {name}=...)")
    cls.__setattr__ = cls.__delattr__ = refuse  # type: ignore[assignment]
    return cls


def real_array(name: str, value: Any, expected: str,
               for_symbols: str = _PLAIN) -> np.ndarray:
    """The value as a new array of finite floats, or a ValueError that says what was wrong.

    `for_symbols` says what to do with sympy's symbols.
    """
    try:
        array = np.asarray(value)
        if array.dtype.kind in "USMmcV":  # numpy would read the text "1" as a number
            raise TypeError
        array = _floats(array) if array.dtype == object else np.array(array, dtype=float)
    except (TypeError, ValueError, OverflowError):
        advice = for_symbols if _holds_symbols(value) else _PLAIN
        raise ValueError(f"{name}: expected {expected}, got {brief(value)}; {advice}") from None
    if within(array, LARGEST):
        return array
    if not np.isfinite(farthest(array)):
        raise ValueError(f"{name}: expected finite numbers, got {brief(value)}; "
                         "look for a division by zero or an empty cell")
    raise ValueError(f"{name}: expected numbers up to {LARGEST:g}, got {brief(value)}; "
                     "look for a slip in a unit or an exponent")


def _floats(array: np.ndarray) -> np.ndarray:
    """Objects as floats, one by one: numpy reads text among them, and warns of sympy's nan."""
    if any(isinstance(entry, str | bytes) for entry in array.flat):
        raise TypeError
    return np.array([float(entry) for entry in array.flat], dtype=float).reshape(array.shape)


def shaped(name: str, value: Any, shape: tuple[int, ...], expected: str) -> np.ndarray:
    """A finite array of exactly the given shape."""
    array = real_array(name, value, expected)
    if array.shape != shape:
        raise ValueError(f"{name}: expected {expected}, got shape {array.shape}")
    return array


def number(name: str, value: Any, for_symbols: str = _PLAIN) -> float:
    """One finite number."""
    if type(value) in (int, float) and -LARGEST <= value <= LARGEST:
        return float(value)
    array = real_array(name, value, "a number", for_symbols)
    if array.shape != ():
        raise ValueError(f"{name}: expected one number, got shape {array.shape}")
    return float(array)


def positive(name: str, value: Any) -> float:
    """One finite number above zero."""
    if not (result := number(name, value)) > 0:
        raise ValueError(f"{name}: expected a number above zero, got {result:g}")
    return result


def whole(name: str, value: Any, least: int, most: int = MOST) -> int:
    """A whole number, not below the least and not beyond the most: that of all use."""
    if not isinstance(value, Integral) or not least <= int(value) <= most:
        raise ValueError(f"{name}: expected a whole number from {least} to {most}, "
                         f"got {brief(value)}")
    return int(value)


def rotation(name: str, value: Any) -> np.ndarray:
    """A proper rotation, 2x2 or 3x3: columns of length 1, perpendicular, right-handed."""
    return rotation_and_error(name, value)[0]


def rotation_and_error(name: str, value: Any) -> tuple[np.ndarray, np.ndarray]:
    """Proper rotations (..., n, n), and how far off the entries of each may be, shape (...).

    Rounded ones are taken as the nearest rotation; all others stay as they are, bit for bit.
    """
    matrix = real_array(name, value, "a rotation matrix")
    n = matrix.shape[-1] if matrix.ndim > 1 else 0
    if n not in (2, 3) or matrix.shape[-2] != n:
        raise ValueError(f"{name}: expected a rotation matrix 2x2 or 3x3, got shape {matrix.shape}")
    gap = np.abs(np.swapaxes(matrix, -1, -2) @ matrix - np.eye(n)).max(axis=(-2, -1))
    if (off := gap.max(initial=0.0)) > rounding(n):
        raise ValueError(f"{name}: expected a rotation (columns of length 1, perpendicular), "
                         f"got one that is off by {off:.2g}; check its entries, "
                         "or give at least 3 decimals")
    if np.any(np.linalg.det(matrix) < 0):
        raise ValueError(f"{name}: expected a right-handed rotation (determinant +1), "
                         "got a mirror image; change the sign of one column")
    if np.any(rounded := gap > RIGID_TOLERANCE):
        matrix[rounded] = _nearest_rotation(matrix[rounded])
        note(f"{name}: taken as the nearest rotation; its entries are rounded, "
             f"off by {off:.2g}")
    return matrix, np.maximum(gap, RIGID_TOLERANCE)


def spatial_rotation_and_error(name: str, value: Any) -> tuple[np.ndarray, np.ndarray]:
    """Proper rotations (..., 3, 3), and how far off the entries of each may be, shape (...)."""
    matrix = real_array(name, value, "a rotation matrix")
    if matrix.shape[-2:] != (3, 3):
        raise ValueError(f"{name}: expected a rotation of shape (..., 3, 3), got {matrix.shape}; "
                         + _NOT_SPATIAL.get(matrix.shape[-2:], "give three rows of three numbers"))
    return rotation_and_error(name, matrix)


def rounding(n: int) -> float:
    """The most by which printed unit vectors of n numbers, u + e, miss u.u = 1 and u.v = 0.

    It is the largest 2 u.e + e.e, at a u whose entries are all alike.
    """
    e = math.sqrt(n) * PRINTED
    return 2 * e + e**2


def _nearest_rotation(matrix: np.ndarray) -> np.ndarray:
    """The orthogonal factor of matrices that are nearly rotations.

    Each Newton-Schulz step squares the error: 1e-3, 1e-6, 1e-12, rounding. Unlike a singular
    value decomposition it leaves the zeros of a matrix alone.
    """
    for _ in range(3):
        matrix = matrix @ (1.5 * np.eye(matrix.shape[-1])
                           - 0.5 * np.swapaxes(matrix, -1, -2) @ matrix)
    return matrix


def rigid(name: str, value: Any) -> np.ndarray:
    """A rigid 4x4 homogeneous matrix: a rotation, an origin and the row 0 0 0 1."""
    return rigids(name, shaped(name, value, (4, 4),
                               "a 4x4 homogeneous matrix, as homogeneous(R, o) makes it"))


def rigids(name: str, matrices: np.ndarray) -> np.ndarray:
    """Rigid homogeneous matrices, shape (..., 4, 4)."""
    R = rotation(f"{name}[:3, :3]", matrices[..., :3, :3])
    off = np.any(np.abs(matrices[..., 3, :] - [0, 0, 0, 1]) > RIGID_TOLERANCE, axis=-1)
    if np.any(off):
        raise ValueError(f"{name}: expected the last row 0 0 0 1, "
                         f"got {matrices[off][0, 3].tolist()}; the origin is the last column")
    matrices = matrices.copy()
    matrices[..., :3, :3] = R
    return matrices


def yes_or_no(name: str, value: Any) -> bool:
    """True or False."""
    if not isinstance(value, bool | np.bool_):
        raise ValueError(f"{name}: expected True or False, got {brief(value)}")
    return bool(value)


def choice(name: str, value: Any, options: tuple[str, ...]) -> str:
    """One of a few words."""
    if not isinstance(value, str) or value not in options:
        words = " or ".join(repr(option) for option in options)
        raise ValueError(f"{name}: expected {words}, got {brief(value)}")
    return value


def line(name: str, value: Any) -> str:
    """One line of text, for a name or a unit, that every file and every screen can hold."""
    if not isinstance(value, str):
        raise ValueError(f"{name}: expected one line of text, got {brief(value)}")
    if bad := next((sign for sign in value if category(sign) in _NO_TEXT), ""):
        raise ValueError(f"{name}: expected one line of text, got {brief(value)}; "
                         f"take out {bad!r}")
    return value


def brief(value: Any, most: int = 60) -> str:
    """The value as it would be typed, shortened to fit a sentence."""
    try:
        if isinstance(value, str | bytes | list | tuple):
            value = value[:10 * most]  # of the rest nothing would be seen
        text = " ".join(repr(value).split())
    except ValueError:  # Python writes out no whole number of more than 4300 digits
        return f"a value of type {type(value).__name__[:most]} that is too long to show"
    except Exception:  # its own repr, which may raise anything
        return f"a value of type {type(value).__name__[:most]} that cannot be shown"
    return text if len(text) <= most else text[: most - 3] + "..."


def components(name: str, value: Any, expected: str) -> np.ndarray:
    """An array of finite numbers or of sympy expressions."""
    try:
        array = np.asarray(value)
    except ValueError:  # rows of different lengths
        return real_array(name, value, expected)
    if array.dtype != object or not any(map(_is_sympy, array.flat)):
        return real_array(name, value, expected)
    if not all(_is_open(entry) or _is_finite(entry) for entry in array.flat):
        raise ValueError(f"{name}: expected {expected}, got {brief(value)}; "
                         "mix only symbols and finite numbers")
    return array


def angle(name: str, value: Any) -> Any:
    """An angle in radians: a plain number (so that quarter turns are exact), a batch, a symbol."""
    array = components(name, value, "an angle in radians")
    if array.dtype != object:
        in_radians(name, array)
    return array[()].item() if array.ndim == 0 and array.dtype != object else array[()]


def in_radians(name: str, angles: ArrayLike) -> None:
    """Say a word where angles go so far that they are degrees, most likely."""
    angles = np.ravel(angles)
    if not within(angles, TWO_TURNS):
        angle = float(angles[np.abs(angles).argmax()])
        note(f"{name}: {angle:.6g} is {abs(angle) / (2 * math.pi):.3g} turns; "
             f"angles are in radians: np.radians({angle:.6g})")


def within(numbers: np.ndarray, most: float) -> bool:
    """Whether all numbers are finite and none is farther from 0 than the most."""
    # Of one pose or one matrix the sum of squares tells it sooner.
    few = numbers.size < 100 and np.vdot(numbers, numbers) <= most * most
    return bool(few or farthest(numbers) <= most)


def farthest(numbers: np.ndarray) -> float:
    """The largest of the numbers, whatever their signs; of none it is 0."""
    return max(numbers.max(initial=0.0), -numbers.min(initial=0.0))


def has_symbols(array: np.ndarray) -> bool:
    """True where a sympy symbol stands in place of a number."""
    return array.dtype == object and any(map(_is_open, array.flat))


def fit_together(names: str, *shapes: tuple[int, ...]) -> None:
    """Leading axes that broadcast: one pose for all, or equally many of each."""
    try:
        np.broadcast_shapes(*shapes)
    except ValueError:
        raise ValueError(f"{names}: expected leading axes that fit together, got "
                         f"{' and '.join(map(str, shapes))}; give one for all, "
                         "or equally many of each") from None


def _is_sympy(entry: Any) -> bool:
    return hasattr(entry, "as_coefficient")  # an expression: equations and sets have none


def _is_open(entry: Any) -> bool:
    return _is_sympy(entry) and bool(entry.free_symbols)


def _holds_symbols(value: Any) -> bool:
    try:
        return has_symbols(np.asarray(value))
    except ValueError:  # rows of different lengths
        return False


def _is_finite(entry: Any) -> bool:
    try:
        return not isinstance(entry, str) and math.isfinite(float(entry))
    except (TypeError, ValueError, OverflowError):
        return False
