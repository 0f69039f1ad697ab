"""A rotation as three turns: ZYZ and roll-pitch-yaw angles, and the families where two meet."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import reduce
from math import sqrt
from typing import Any, ClassVar, TypeVar

import numpy as np

from . import inputs
from .motions import X, Y, Z, keep_whole, rotation

_ZYZ = (Z, Y, Z)
_ORDERS = {"zyx": (Z, Y, X), "xyz": (X, Y, Z), "yxz": (Y, X, Z),
           "xzy": (X, Z, Y), "yzx": (Y, Z, X), "zxy": (Z, X, Y),
           "vehicle": (Z, Y, X), "arm": (X, Y, Z), "camera": (Y, X, Z)}


@dataclass(frozen=True)
class EulerAngles:
    """Three angles (rad) of one rotation or of many: iterate over the solutions.

    For one rotation the angles are floats; for rotations of shape (..., 3, 3) they are arrays of
    shape (...), as are `singular` and `fixed`.

    Attributes
    ----------
    solutions : tuple of three angles each
        Two branches. Where the rotation is singular: one member of the family, the one whose
        last turn is 0 (among many rotations, both branches are this member).
    singular : bool or array of bool
        True where the first and the last turn have the same axis, so that only their sum or
        their difference is defined.
    fixed : float, array or None
        There, the value of that sum or difference, in radians; elsewhere None (NaN in an array).
    sign : float or array
        1 where `fixed` is a sum, -1 where it is a difference.
    """

    solutions: tuple[tuple[Any, ...], ...]
    singular: Any = False
    fixed: Any = None
    sign: Any = 1.0

    turns: ClassVar[tuple[str, str, str]]  # names of the first, the middle and the last turn
    listed: ClassVar[slice] = slice(None)  # from the order of turns to that of a solution

    @property
    def message(self) -> str:
        """What the angles are, in degrees, in one sentence."""
        if np.ndim(self.singular):
            return (f"{np.size(self.singular)} rotations, {np.sum(self.singular)} of them "
                    "singular; see .solutions and .singular")
        return self._family() if self.singular else self._branches()

    def _branches(self) -> str:
        return " or ".join("({:.4f}, {:.4f}, {:.4f})".format(*np.degrees(solution))
                           for solution in self.solutions) + " degrees"

    def _family(self) -> str:
        (first, middle, last), sign = self.turns, "+" if self.sign > 0 else "-"
        return (f"{middle} = {np.degrees(self.solutions[0][1]):.0f} degrees: any {first} and "
                f"{last} with {first} {sign} {last} = {np.degrees(self.fixed) + 0.0:.4f} degrees")

    def _member(self, first: Any) -> tuple[Any, ...]:
        """The member of the family whose first turn is this."""
        name = self.turns[0]
        if not np.all(self.singular):
            raise ValueError(f"{name}: expected a singular rotation, got one with two solutions; "
                             "take one of .solutions")
        first = inputs.number(name, first) + 0 * self.fixed
        return (first, self.solutions[0][1], self.sign * (self.fixed - first))[self.listed]

    def __iter__(self) -> Iterator[tuple[Any, ...]]:
        return iter(self.solutions)

    def __len__(self) -> int:
        return len(self.solutions)

    def __getitem__(self, k: int) -> tuple[Any, ...]:
        return self.solutions[k]


@dataclass(frozen=True)
class ZYZAngles(EulerAngles):
    """ZYZ angles (phi, theta, psi) of one rotation or of many, in radians: `EulerAngles`.

    The first branch has sin(theta) > 0, the second sin(theta) < 0. Singular is theta = 0, where
    only phi + psi is defined, and theta = pi, where only phi - psi is: psi = 0 in `solutions`.
    """

    turns = ("phi", "theta", "psi")

    def member(self, phi: float) -> tuple[Any, ...]:
        """The solution (phi, theta, psi) of a singular family with this `phi`."""
        return self._member(phi)

    def __repr__(self) -> str:
        return f"ZYZ: {self.message}"


@dataclass(frozen=True)
class RPYAngles(EulerAngles):
    """Roll, pitch and yaw of one rotation or of many, in radians: `EulerAngles`.

    The first branch has cos(pitch) > 0, the second cos(pitch) < 0. Singular is pitch = 90 or -90
    degrees, where only yaw - roll or yaw + roll is defined: roll = 0 in `solutions`.

    Attributes
    ----------
    order : str
        The axes of yaw, pitch and roll, as it was asked for.
    """

    order: str = "zyx"

    turns = ("yaw", "pitch", "roll")
    listed = slice(None, None, -1)

    def member(self, yaw: float) -> tuple[Any, ...]:
        """The solution (roll, pitch, yaw) of a singular family with this `yaw`."""
        return self._member(yaw)

    def __repr__(self) -> str:
        return f"(roll, pitch, yaw), order {self.order}: {self.message}"


def zyz_angles(R: Any) -> ZYZAngles:
    """ZYZ Euler angles of a rotation: R = Rz(phi) Ry(theta) Rz(psi).

    Parameters
    ----------
    R : array, shape (..., 3, 3)

    Returns
    -------
    ZYZAngles
        Both branches, or the family of solutions where r33 = 1 or -1: where sin(theta) is no
        larger than what R itself may be off by (1.4e-6, and more if R is rounded).

    Raises
    ------
    ValueError
        If `R` is no rotation, not even one rounded to 3 decimals.

    Notes
    -----
    Source: IIT Jodhpur, Robotics, Practical 3, with psi of the second branch corrected to
    atan2(-r32, r31).

    Examples
    --------
    >>> zyz_angles(zyz_matrix(0.1, 0.2, 0.3))
    ZYZ: (5.7296, 11.4592, 17.1887) or (-174.2704, -11.4592, -162.8113) degrees
    >>> zyz_angles(np.eye(3))
    ZYZ: theta = 0 degrees: any phi and psi with phi + psi = 0.0000 degrees
    >>> phi, theta, psi = zyz_angles(zyz_matrix([0.1, 0.2, 0.3], 0.5, 0))[0]
    >>> phi
    array([0.1, 0.2, 0.3])
    """
    return _solved(ZYZAngles, R, _ZYZ)


def zyz_matrix(phi: Any, theta: Any, psi: Any) -> np.ndarray:
    """The rotation Rz(phi) Ry(theta) Rz(psi).

    Parameters
    ----------
    phi, theta, psi : float, array (...) or sympy expression
        Angles in radians; they broadcast.

    Returns
    -------
    array, shape (..., 3, 3)

    Examples
    --------
    >>> zyz_matrix(0, np.pi, 0)
    array([[-1.,  0.,  0.],
           [ 0.,  1.,  0.],
           [ 0.,  0., -1.]])
    """
    return _product(_ZYZ, phi=phi, theta=theta, psi=psi)


def rpy_angles(R: Any, order: str = "zyx") -> RPYAngles:
    """Roll, pitch and yaw of a rotation, in the order in which `rpy_matrix` takes them.

    Parameters
    ----------
    R : array, shape (..., 3, 3)
    order : str, default "zyx"
        The axes of yaw, pitch and roll: see `rpy_matrix`.

    Returns
    -------
    RPYAngles
        Both branches (roll, pitch, yaw), or the family of solutions where pitch = 90 or -90
        degrees: where cos(pitch) is no larger than what R itself may be off by (1.4e-6, and more
        if R is rounded).

    Raises
    ------
    ValueError
        If `R` is no rotation, not even one rounded to 3 decimals, or the order is unknown.

    Notes
    -----
    Source: Craig, Introduction to Robotics, section 2.8, X-Y-Z fixed angles; Corke, Robotics,
    Vision and Control, section 2.2.1.2.

    Examples
    --------
    >>> rpy_angles(rpy_matrix(0.1, 0.2, 0.3))
    (roll, pitch, yaw), order zyx: (5.7296, 11.4592, 17.1887) or (-174.2704, 168.5408, -162.8113)
    degrees
    >>> rpy_angles(rpy_matrix(0, np.pi / 2, 0))
    (roll, pitch, yaw), order zyx: pitch = 90 degrees: any yaw and roll with yaw - roll = 0.0000
    degrees
    """
    return _solved(RPYAngles, R, _axes(order), order=order)


def rpy_matrix(roll: Any, pitch: Any, yaw: Any, order: str = "zyx") -> np.ndarray:
    """The rotation by yaw, pitch and roll, each about an axis that the turns before have moved.

    Parameters
    ----------
    roll, pitch, yaw : float, array (...) or sympy expression
        Angles in radians; they broadcast.
    order : str, default "zyx"
        The axes of yaw, pitch and roll, in this sequence, about *moving* axes:

        - "zyx" or "vehicle": R = Rz(yaw) Ry(pitch) Rx(roll), x ahead and z up or down.
        - "xyz" or "arm": R = Rx(yaw) Ry(pitch) Rz(roll), z out of the gripper.
        - "yxz" or "camera": R = Ry(yaw) Rx(pitch) Rz(roll), z along the view.
        - "xzy", "yzx", "zxy" likewise: pitch is always the turn in the middle.

        About *fixed* axes the same turns come the other way round: moving axes "zyx" are the
        fixed axes x by roll, then y by pitch, then z by yaw (Craig's "X-Y-Z fixed angles").

    Returns
    -------
    array, shape (..., 3, 3)

    Raises
    ------
    ValueError
        If an angle is no number or symbol, or the order is unknown.

    Notes
    -----
    Source: Craig, Introduction to Robotics, section 2.8; Corke, Robotics, Vision and Control,
    section 2.2.1.2, for the names "vehicle", "arm" and "camera". Spong's roll phi, pitch theta
    and yaw psi with R = Rz(phi) Ry(theta) Rx(psi) is ``rpy_matrix(psi, theta, phi)``: he calls
    the turn about z roll.

    Examples
    --------
    >>> rpy_matrix(0, 0, np.pi / 2)
    array([[ 0., -1.,  0.],
           [ 1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    >>> import sympy as sp
    >>> roll, pitch, yaw = sp.symbols("gamma beta alpha")
    >>> sp.Matrix(rpy_matrix(roll, pitch, yaw))[2, :]
    Matrix([[-sin(beta), sin(gamma)*cos(beta), cos(beta)*cos(gamma)]])
    """
    return _product(_axes(order), yaw=yaw, pitch=pitch, roll=roll)


def _axes(order: Any) -> tuple[int, int, int]:
    return _ORDERS[inputs.choice("order", order, tuple(_ORDERS))]


def _product(axes: tuple[int, int, int], **angles: Any) -> np.ndarray:
    """The product of three turns about moving axes."""
    values = [inputs.angle(name, angle) for name, angle in angles.items()]
    inputs.fit_together(", ".join(angles), *map(np.shape, values))
    return reduce(np.matmul, keep_whole(*map(rotation, axes, values)))


Angles = TypeVar("Angles", bound=EulerAngles)


def _solved(kind: type[Angles], R: Any, axes: tuple[int, int, int], **also: str) -> Angles:
    R, error = inputs.spatial_rotation_and_error("R", R)
    M, quarter = _as_zyz(R, axes)
    tilt = np.hypot(M[0, 2], M[1, 2])
    # Each of the two entries may be off by R's own error, so a tilt of sqrt(2) times this may be
    # none at all: the first and the last angle would be read off the error.
    singular = tilt <= sqrt(2) * error
    up = np.where(M[2, 2] > 0, 1.0, -1.0)
    fixed = _angle(up * M[1, 0], up * M[0, 0])
    none = np.zeros(up.shape)
    family = (fixed, _middle(none, up, quarter), none)
    side = quarter or 1
    branches = [tuple(np.where(singular, *pair) for pair in zip(family, branch))[kind.listed]
                for branch in (_branch(M, side * tilt, side, quarter),
                               _branch(M, -side * tilt, -side, quarter))]
    if singular.ndim:
        return kind(tuple(branches), singular, np.where(singular, fixed, np.nan), up, **also)
    solutions = tuple(tuple(map(float, branch)) for branch in branches)
    if singular:
        return kind(solutions[:1], True, float(fixed), float(up), **also)
    return kind(solutions, **also)


def _as_zyz(R: np.ndarray, axes: tuple[int, int, int]) -> tuple[np.ndarray, int]:
    """R = Ri(first) Rj(middle) Rk(last) in frames where it is Rz(first) Ry(theta) Rz(last).

    L has its z along axis i and its y along j, N its z along k and its y along j. So N is L
    turned about y by a number of quarter turns, and theta in L^T R N is the middle angle and
    these. The entries come first, (3, 3, ...).
    """
    first, middle, last = np.eye(3)[list(axes)]
    L, N = (np.stack([np.cross(middle, z), middle, z], axis=-1) for z in (first, last))
    return np.moveaxis(L.T @ R @ N, (-2, -1), (0, 1)), round((L.T @ N)[0, 2])


def _branch(M: np.ndarray, sine: np.ndarray, side: int, quarter: int) -> tuple[np.ndarray, ...]:
    """The angles where sin(theta) has this sign."""
    return (_angle(side * M[1, 2], side * M[0, 2]), _middle(sine, M[2, 2], quarter),
            _angle(side * M[2, 1], -side * M[2, 0]))


def _middle(sine: Any, cosine: Any, quarter: int) -> np.ndarray:
    """The angle theta without the quarter turn, from its sine and cosine: exact near 0."""
    return _angle(*(((sine, cosine), (-cosine, sine), (cosine, -sine))[quarter]))


def _angle(sine: Any, cosine: Any) -> np.ndarray:
    """The angle in (-pi, pi]: a zero has no sign here."""
    return np.arctan2(sine + 0.0, cosine + 0.0)
