"""One row of a standard table, from a frame to a line in space: the common normal.

Rz(theta) Tz(d) Tx(a) Rx(alpha) brings a frame's z axis onto any line: theta turns x along the
common normal, d slides to its foot, a goes along it, alpha tilts z (Spong, Hutchinson and
Vidyasagar, section 3.2). Parallel lines have many common normals, and almost parallel ones have
theirs far away, where digits are lost; then two rows share the work.
"""
from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ..arms.arm import CONVENTIONS
from ..arms.motions import Frame, Motion, follow, matrix

PARALLEL = 3e-11  # rad: what pi/2 with twelve digits, a few times over, leaves of a right angle
STEEP = 0.1       # the sine of a tilt from which on a common normal is near enough
FAR = 10          # lengths of the arm: a foot beyond is no use in a table
_NEAR = 1.5e-10   # a length that is nothing: far below the 1e-9 that poses may be off
_TWELFTH = math.pi / 12


class Line(NamedTuple):
    """A line in space, as an axis has it: a point and a unit vector."""

    point: np.ndarray
    z: np.ndarray


class Numbers(NamedTuple):
    """The four numbers of a row."""

    theta: float = 0.0
    d: float = 0.0
    a: float = 0.0
    alpha: float = 0.0

    def matrix(self) -> np.ndarray:
        motions = [Motion(kind, axis, getattr(self, parameter))
                   for kind, axis, parameter in CONVENTIONS["standard"]]
        return matrix(follow(motions, (), Frame()))

    def other_way(self) -> Numbers:
        """The row to the same line whose x points the other way."""
        return Numbers(clean_angle(self.theta + math.pi), self.d, 0.0 - self.a,
                       clean_angle(-self.alpha))


def clean(size: float, theta: float, d: float, a: float, alpha: float) -> Numbers:
    """The numbers without what rounding left of them: no 1e-17, and pi/2 as it is."""
    return Numbers(clean_angle(theta), clean_length(d, size), clean_length(a, size),
                   clean_angle(alpha))


def clean_angle(angle: float) -> float:
    """The angle from above -pi to pi, a multiple of 15 degrees if it nearly is one."""
    angle = plain_turn(math.remainder(angle, 2 * math.pi))
    return math.pi if angle == -math.pi else angle


def plain_turn(angle: float) -> float:
    """The angle, a multiple of 15 degrees if it nearly is one."""
    plain = round(angle / _TWELFTH) * math.pi / 12
    return plain if abs(angle - plain) < PARALLEL else float(angle)


def clean_length(length: float, size: float) -> float:
    """The length, with nine decimals if it nearly has no more."""
    if abs(length) <= _nothing(size):
        return 0.0
    plain = round(float(length), 9)
    return plain if abs(plain - length) <= PARALLEL * min(size, 1.0) else float(length)


def _nothing(size: float) -> float:
    """Up to here a length is left by rounding, in an arm of this size."""
    return _NEAR * min(size, 1.0)


def steps_to(frame: np.ndarray, line: Line, size: float, level: bool) -> list[Numbers]:
    """The row, or the row and a fixed one, from a frame to a line whose z looks the same way.

    `level` asks for the row's d to be 0 where the lines are parallel and any d would do; else the
    next origin is at the line's own point.
    """
    z, point = frame[:3, :3].T @ line.z, frame[:3, :3].T @ (line.point - frame[:3, 3])
    tilt = math.hypot(z[0], z[1])
    if tilt <= PARALLEL:
        return [_across(point, 0.0 if level else point[2], size)]
    theta = math.atan2(z[0], -z[1])
    alpha = math.atan2(tilt, z[2])
    along = (point[0] * z[0] + point[1] * z[1]) / tilt**2
    d = point[2] - along * z[2]
    if tilt > STEEP or max(abs(along), abs(d - point[2])) <= FAR * size:
        a = point[0] * math.cos(theta) + point[1] * math.sin(theta)
        return [clean(size, theta, d, a, alpha)]
    height = 0.0 if level else point[2]
    first = _across(point + (height - point[2]) / z[2] * z, height, size)
    return [first, clean(size, theta - first.theta, 0.0, 0.0, alpha)]


def _across(point: np.ndarray, d: float, size: float) -> Numbers:
    """The row to a parallel line through a point."""
    a = math.hypot(point[0], point[1])
    if a <= _nothing(size):
        return clean(size, 0.0, d, 0.0, 0.0)
    return clean(size, math.atan2(point[1], point[0]), d, a, 0.0)
