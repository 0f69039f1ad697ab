"""A rotation as one turn about one axis: axis and angle, and the unit quaternion of both."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import sqrt
from typing import Any

import numpy as np

from . import inputs
from .motions import cos_sin, keep_whole, stack


@dataclass(frozen=True, eq=False, repr=False)
class AxisAngle:
    """Axis and angle of one rotation or of many: ``axis, angle = axis_angle(R)``.

    Attributes
    ----------
    axis : array, shape (..., 3)
        Unit vector. Where R is the identity, z.
    angle : float or array, shape (...)
        Radians, from 0 to pi.
    singular : bool or array of bool, shape (...)
        True where the angle is no larger than what R itself may be off by: any axis will do.
    solutions : tuple
        (axis, angle) and (-axis, -angle), the same turn seen from the other side.
    """

    axis: np.ndarray
    angle: Any
    singular: Any

    @property
    def solutions(self) -> tuple[tuple[np.ndarray, Any], ...]:
        return (self.axis, self.angle), (-self.axis, -self.angle)

    @property
    def message(self) -> str:
        """What the turn is, in degrees, in one sentence."""
        if np.ndim(self.singular):
            return (f"{np.size(self.singular)} rotations, {np.sum(self.singular)} of them by 0 "
                    "degrees; see .axis, .angle and .singular")
        if self.singular:
            return "0 degrees about any axis"
        turn, axis = np.degrees(self.angle), "({:.4f}, {:.4f}, {:.4f})".format(*self.axis + 0.0)
        return f"{turn:.4f} degrees about {axis}, or {-turn:.4f} degrees about the opposite axis"

    def member(self, axis: Any) -> tuple[np.ndarray, Any]:
        """The solution with this axis, where the angle is 0 and any axis will do."""
        if not np.all(self.singular):
            raise ValueError("axis: expected a rotation by 0 degrees, got one with an axis of its "
                             "own; take one of .solutions")
        unit = _unit_axis(inputs.shaped("axis", axis, (3,), "three numbers"))
        return np.broadcast_to(unit, self.axis.shape), 0 * self.angle

    def __iter__(self) -> Iterator[Any]:
        return iter((self.axis, self.angle))

    def __repr__(self) -> str:
        return f"Axis and angle: {self.message}"


@dataclass(frozen=True, eq=False, repr=False)
class Quaternion:
    """The unit quaternion w + x i + y j + z k of one rotation or of many, scalar w first.

    It stands for the array of its numbers (w, x, y, z) wherever numpy takes one.

    Attributes
    ----------
    array : array, shape (..., 4)
        With w >= 0. For half a turn w = 0, and the first of x, y, z that is not 0 is positive.
    solutions : tuple of two arrays
        q and -q: each rotation has two unit quaternions. There is no singular place.
    """

    array: np.ndarray

    @property
    def solutions(self) -> tuple[np.ndarray, np.ndarray]:
        return self.array, -self.array

    @property
    def message(self) -> str:
        """Both quaternions, scalar first, in one sentence."""
        if self.array.ndim > 1:
            return (f"{self.array[..., 0].size} rotations; see .solutions for both signs, "
                    "each (w, x, y, z)")
        return " or ".join("({:.4f}, {:.4f}, {:.4f}, {:.4f})".format(*q + 0.0)
                           for q in self.solutions)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        return np.array(self.array, dtype=dtype)

    def __neg__(self) -> Quaternion:
        return Quaternion(-self.array)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.array)

    def __len__(self) -> int:
        return len(self.array)

    def __getitem__(self, key: Any) -> Any:
        return self.array[key]

    def __repr__(self) -> str:
        return f"(w, x, y, z) = {self.message}"


def axis_angle(R: Any) -> AxisAngle:
    """Axis and angle of a rotation.

    Parameters
    ----------
    R : array, shape (..., 3, 3)

    Returns
    -------
    AxisAngle
        Iterates over axis and angle; `rotation_about` takes them back. Where the angle is 0, or
        no larger than what R itself may be off by (1e-6, and more if R is rounded), it says so.

    Raises
    ------
    ValueError
        If `R` is no rotation, not even one rounded to 3 decimals.

    Notes
    -----
    Source: Spong, Hutchinson and Vidyasagar, section 2.5.3; Craig, section 2.8. Their formula
    divides by sin(angle), which fails at 0 and at 180 degrees. Here it is read off the
    quaternion, with all digits near both.

    Examples
    --------
    >>> axis, angle = axis_angle(rotation_about([0, 0, 1], 0.1))
    >>> axis, round(angle, 12)
    (array([0., 0., 1.]), 0.1)
    >>> axis_angle(np.eye(3))
    Axis and angle: 0 degrees about any axis
    """
    R, error = inputs.spatial_rotation_and_error("R", R)
    q = _quaternion(R)
    length = np.hypot.reduce(q[..., 1:], axis=-1)
    axis = np.where(length[..., None] > 0, _direction(q[..., 1:]), (0.0, 0.0, 1.0))
    angle = 2 * np.arctan2(length, q[..., 0])
    # Half of r32 - r23 and of its two sisters make sin(angle). Each may be off by R's error.
    singular = angle <= sqrt(3) * error
    if singular.ndim:
        return AxisAngle(axis, angle, singular)
    return AxisAngle(axis, float(angle), bool(singular))


def rotation_about(axis: Any, angle: Any) -> np.ndarray:
    """The rotation about an axis by an angle (Rodrigues' formula).

    Parameters
    ----------
    axis : array, shape (..., 3)
        Direction of the axis, of any length above 0; numbers or sympy expressions.
    angle : float, array (...) or sympy expression
        Radians, by the right-hand rule; the leading axes broadcast.

    Returns
    -------
    array, shape (..., 3, 3)

    Raises
    ------
    ValueError
        If the axis has no direction, or the shapes do not fit together.

    Notes
    -----
    Source: Craig, Introduction to Robotics, section 2.8, equivalent angle-axis.

    Examples
    --------
    >>> rotation_about([0, 0, 2], np.pi / 2)
    array([[ 0., -1.,  0.],
           [ 1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    >>> import sympy as sp
    >>> rotation_about([0, 0, 1], sp.Symbol("theta"))[0, 1]
    -sin(theta)
    """
    axis = inputs.components("axis", axis, "an axis of three numbers")
    if axis.shape[-1:] != (3,):
        raise ValueError(f"axis: expected three numbers, shape (..., 3), got {axis.shape}; "
                         "give the axis first, then the angle")
    unit = _unit_axis(axis)
    angle = inputs.angle("angle", angle)
    inputs.fit_together("axis, angle", axis.shape[:-1], np.shape(angle))
    c, s = cos_sin(angle)
    return _rodrigues(unit, s, 1 - c)


def quaternion(R: Any) -> Quaternion:
    """The unit quaternion (w, x, y, z) of a rotation, scalar first.

    Parameters
    ----------
    R : array, shape (..., 3, 3)

    Returns
    -------
    Quaternion
        Shape (..., 4), with w >= 0; its negative is the same rotation. numpy takes it as an
        array. Other libraries may put the scalar last: ROS and SciPy do.

    Raises
    ------
    ValueError
        If `R` is no rotation, not even one rounded to 3 decimals.

    Notes
    -----
    Source: Corke, Robotics, Vision and Control, section 2.2.1.7. Shepperd, Quaternion from
    rotation matrix, 1978: divide by the largest component, so that no digits are lost.

    Examples
    --------
    >>> quaternion(rotation_about([0, 0, 1], np.pi / 2))
    (w, x, y, z) = (0.7071, 0.0000, 0.0000, 0.7071) or (-0.7071, 0.0000, 0.0000, -0.7071)
    >>> w, x, y, z = quaternion(np.diag([1, -1, -1]))
    >>> float(w), float(x)
    (0.0, 1.0)
    """
    R, _ = inputs.spatial_rotation_and_error("R", R)
    return Quaternion(_quaternion(R))


def quaternion_matrix(q: Any) -> np.ndarray:
    """The rotation of a unit quaternion (w, x, y, z), scalar first.

    Parameters
    ----------
    q : Quaternion or array, shape (..., 4)
        Numbers of length 1, or sympy expressions (whose length is taken as 1). Numbers that are
        rounded to 3 decimals or more are taken at length 1, with a word.

    Returns
    -------
    array, shape (..., 3, 3)
        The same for q and -q.

    Raises
    ------
    ValueError
        If the numbers are no unit quaternion.

    Examples
    --------
    >>> quaternion_matrix([0, 1, 0, 0])
    array([[ 1.,  0.,  0.],
           [ 0., -1.,  0.],
           [ 0.,  0., -1.]])
    """
    q = inputs.components("q", q, "a quaternion (w, x, y, z)")
    if q.shape[-1:] != (4,):
        raise ValueError(f"q: expected shape (..., 4), four numbers (w, x, y, z), got {q.shape}")
    if not inputs.has_symbols(q):
        q = _unit_quaternion(q.astype(float))
    return _rodrigues(q[..., 1:], 2 * q[..., 0], 2)


def _unit_axis(axis: np.ndarray) -> np.ndarray:
    if not np.all(np.any(axis != 0, axis=-1)):
        raise ValueError("axis: expected a direction, got (0, 0, 0); give at least one component "
                         "that is not 0")
    return _direction(axis)


def _unit_quaternion(q: np.ndarray) -> np.ndarray:
    length = np.hypot.reduce(q, axis=-1)
    off = np.abs(length**2 - 1)
    if np.any(off > inputs.rounding(4)):
        raise ValueError("q: expected a unit quaternion (w, x, y, z), got one of length "
                         f"{length.flat[off.argmax()]:.4g}; give numbers whose squares add up to "
                         "1, with at least 3 decimals")
    if np.any(off > inputs.RIGID_TOLERANCE):
        inputs.note(f"q: taken at length 1; its numbers are rounded, off by {off.max():.2g}")
    return _direction(q)


def _quaternion(R: np.ndarray) -> np.ndarray:
    """Quaternions (..., 4) whose first number that is not 0 is positive.

    The entries of R and their sums give 4 q q^T. Each of its columns is q times a number: that
    of the largest component of q loses no digits.
    """
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = np.moveaxis(R, (-2, -1), (0, 1))
    products = np.stack([
        1 + xx + yy + zz, zy - yz, xz - zx, yx - xy,
        zy - yz, 1 + xx - yy - zz, xy + yx, xz + zx,
        xz - zx, xy + yx, 1 - xx + yy - zz, yz + zy,
        yx - xy, xz + zx, yz + zy, 1 - xx - yy + zz], axis=-1).reshape(*R.shape[:-2], 4, 4)
    largest = np.diagonal(products, axis1=-2, axis2=-1).argmax(axis=-1)[..., None, None]
    q = _direction(np.take_along_axis(products, largest, axis=-1)[..., 0])
    first = (q != 0).argmax(axis=-1)[..., None]
    return q * np.sign(np.take_along_axis(q, first, axis=-1)) + 0.0


def _direction(vector: np.ndarray) -> np.ndarray:
    """The vectors at length 1, numbers or symbols; that of length 0 stays."""
    if vector.dtype == object:
        return vector / (vector**2).sum(axis=-1, keepdims=True) ** Fraction(1, 2)
    largest = np.abs(vector).max(axis=-1, keepdims=True)
    vector = vector / np.where(largest > 0, largest, 1.0)  # the tiniest numbers have no squares
    return vector / np.maximum(np.sqrt((vector**2).sum(axis=-1, keepdims=True)), 1e-300)


def _rodrigues(vector: np.ndarray, s: Any, v: Any) -> np.ndarray:
    """The matrix I + s K + v K^2, where K p is the cross product of the vector and p."""
    vector, s, v = keep_whole(vector, np.asarray(s), np.asarray(v))
    x, y, z = np.moveaxis(vector, -1, 0)
    return stack([[1 - v * (y * y + z * z), v * x * y - s * z, v * x * z + s * y],
                  [v * x * y + s * z, 1 - v * (x * x + z * z), v * y * z - s * x],
                  [v * x * z - s * y, v * y * z + s * x, 1 - v * (x * x + y * y)]])
