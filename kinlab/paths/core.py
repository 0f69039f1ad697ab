"""What of an arm goes along a line: the joints that move, and lengths as parts of its own length.

A path must not depend on the unit of lengths, though of many ways to go along a line it takes the
one on which joints move least, and turns and slides count together there. So they are counted in
radians and in parts of the arm's length. A locked joint is a row without a joint.
"""
from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import reach
from ..arms.link import FIXED, PRISMATIC, REVOLUTE, Link


@dataclass(frozen=True, eq=False)
class Core:
    """An arm without its locks and its unit.

    Attributes
    ----------
    arm : Arm
        It has a value for each joint that moves; lengths are parts of `length`.
    length : float
        How far the arm reaches, in its own unit.
    moving : array of bool, shape (n,)
        Which joints move.
    rest : array, shape (n,)
        Values of locked joints, and 0 for those that move.
    units : array, shape (k,)
        What 1 is of each joint that moves: 1 rad, or the length.
    """

    arm: Arm
    length: float
    moving: np.ndarray
    rest: np.ndarray
    units: np.ndarray

    @classmethod
    def of(cls, arm: Arm, ends: np.ndarray) -> Core:
        """The core of an arm whose tool goes between poses, shape (2, 4, 4)."""
        locks = [link.lock for link in arm.joints]
        moving = np.array([lock is None for lock in locks])
        if not moving.any():  # then inverse kinematics holds them where they are
            moving, locks = ~moving, [None] * arm.n
        bare = replace(arm, links=_held(arm, moving), home=arm.home[moving])
        length = _length(bare, ends)
        units = np.array([1.0 if link.kind == REVOLUTE else length for link in bare.joints])
        return cls(_shrunk(bare, length, units), length, moving,
                   np.array([lock or 0.0 for lock in locks]), units)

    def pose(self, T: np.ndarray) -> np.ndarray:
        """A pose of the room, its lengths as parts of the arm's."""
        return _moved_near(T, self.length)

    def within(self, q: np.ndarray) -> np.ndarray:
        """The values (k,) of the joints that move, of joint values (n,)."""
        return q[self.moving] / self.units

    def joints(self, q: np.ndarray) -> np.ndarray:
        """Joint values (m, n) of values (m, k) of those that move."""
        return self.rest + self.rates(q)

    def rates(self, rates: np.ndarray) -> np.ndarray:
        """Rates or accelerations (m, n) of those (m, k) of the joints that move."""
        whole = np.zeros((len(rates), len(self.rest)))
        whole[:, self.moving] = rates * self.units
        return whole


def _held(arm: Arm, moving: np.ndarray) -> tuple[Link, ...]:
    """The rows, those of joints that do not move without a joint."""
    links = list(arm.links)
    for row, moves in zip(arm.rows, moving):
        if not moves:
            links[row] = _fixed(links[row])
    return tuple(links)


def _fixed(link: Link) -> Link:
    """The row of a locked joint as one without a joint."""
    value = -(link.lock or 0.0) if link.flip else link.lock or 0.0
    theta, d = ((link.theta + value, link.d) if link.kind == REVOLUTE
                else (link.theta, link.d + value))
    return Link(FIXED, theta, d, link.a, link.alpha)


def _length(arm: Arm, ends: np.ndarray) -> float:
    """The arm's reach; if slides have no end, that of its links and of the line beside them."""
    length = reach(arm)
    if not np.isfinite(length):
        still = tuple(replace(link, limits=(0, 0)) if link.kind == PRISMATIC and not link.limits
                      else link for link in arm.links)
        far = np.linalg.norm(ends[:, :3, 3] - arm.base[:3, 3], axis=1).max()
        length = reach(replace(arm, links=still)) + float(far)
    return length or 1.0


def _shrunk(arm: Arm, length: float, units: np.ndarray) -> Arm:
    """The arm with its lengths as parts of one."""
    return replace(arm, links=tuple(_small(link, length) for link in arm.links),
                   home=arm.home / units, base=_moved_near(arm.base, length),
                   tool=_moved_near(arm.tool, length))


def _small(link: Link, length: float) -> Link:
    unit = length if link.kind == PRISMATIC else 1.0
    limits = link.limits and (link.limits[0] / unit, link.limits[1] / unit)
    return replace(link, d=link.d / length, a=link.a / length, limits=limits)


def _moved_near(T: np.ndarray, length: float) -> np.ndarray:
    near = T.copy()
    near[:3, 3] /= length
    return near
