"""ZYZ Euler angles: both branches, and the one-parameter family where they meet."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import reduce
from math import atan2, degrees, hypot, pi
from typing import Any

import numpy as np

from . import inputs
from .motions import keep_whole
from .transforms import rotation_y, rotation_z

# Below this |sin(theta)| rounding noise in R would pass for phi and psi.
SINGULAR = 1e-9


@dataclass(frozen=True)
class ZYZAngles:
    """ZYZ angles of a rotation (rad): iterate over the solutions (phi, theta, psi).

    Attributes
    ----------
    solutions : tuple of (phi, theta, psi)
        The branch with sin(theta) > 0, then the one with sin(theta) < 0. Where the rotation
        is singular: one member of the family, the one with psi = 0.
    singular : bool
        True where r33 = 1 or -1 and only a sum or difference of angles is defined.
    fixed : float or None
        There, the value of phi + psi (r33 = 1) or phi - psi (r33 = -1), in radians.
    """

    solutions: tuple[tuple[float, float, float], ...]
    fixed: float | None = None

    @property
    def singular(self) -> bool:
        return self.fixed is not None

    @property
    def message(self) -> str:
        """What the angles are, in degrees, in one sentence."""
        if self.fixed is None:
            return " or ".join("({:.4f}, {:.4f}, {:.4f})".format(*map(degrees, solution))
                               for solution in self.solutions) + " degrees"
        theta = round(degrees(self.solutions[0][1]))
        sign = "+" if theta == 0 else "-"
        return (f"theta = {theta} degrees: any phi and psi with "
                f"phi {sign} psi = {degrees(self.fixed) + 0.0:.4f} degrees")

    def member(self, phi: float) -> tuple[float, float, float]:
        """The solution of a singular family with this `phi`."""
        if self.fixed is None:
            raise ValueError("phi: expected a singular rotation, got one with two solutions; "
                             "take one of .solutions")
        phi, theta = inputs.number("phi", phi), self.solutions[0][1]
        return (phi, theta, self.fixed - phi if theta == 0 else phi - self.fixed)

    def __iter__(self) -> Iterator[tuple[float, float, float]]:
        return iter(self.solutions)

    def __len__(self) -> int:
        return len(self.solutions)

    def __getitem__(self, k: int) -> tuple[float, float, float]:
        return self.solutions[k]

    def __repr__(self) -> str:
        return f"ZYZ: {self.message}"


def zyz_angles(R: Any) -> ZYZAngles:
    """ZYZ Euler angles of a rotation: R = Rz(phi) Ry(theta) Rz(psi).

    Parameters
    ----------
    R : array, shape (3, 3)

    Returns
    -------
    ZYZAngles
        Both branches, or the family of solutions where r33 = 1 or -1 (sin(theta) below 1e-9).

    Raises
    ------
    ValueError
        If `R` is not one rotation matrix.

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
    """
    R = inputs.rotation("R", R)
    if R.shape != (3, 3):
        raise ValueError(f"R: expected shape (3, 3), got {R.shape}; give one rotation at a time")
    (r11, _, r13), (r21, _, r23), (r31, r32, r33) = (R + 0.0).tolist()
    sine = hypot(r13, r23)
    if sine < SINGULAR:
        return _family(r11, r21, r33)
    first = (atan2(r23, r13), atan2(sine, r33), atan2(r32, -r31))
    second = (atan2(-r23, -r13), atan2(-sine, r33), atan2(-r32, r31))
    return ZYZAngles((first, second))


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
    phi, theta, psi = (inputs.components(name, angle, "an angle in radians") for name, angle
                       in (("phi", phi), ("theta", theta), ("psi", psi)))
    inputs.fit_together("phi, theta, psi", phi.shape, theta.shape, psi.shape)
    turns = keep_whole(rotation_z(phi), rotation_y(theta), rotation_z(psi))
    return reduce(np.matmul, turns)


def _family(r11: float, r21: float, r33: float) -> ZYZAngles:
    theta, fixed = (0.0, atan2(r21, r11)) if r33 > 0 else (pi, atan2(-r21, -r11))
    return ZYZAngles(((fixed, theta, 0.0),), fixed)
