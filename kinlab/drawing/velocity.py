"""Frames that show velocities: a column of a Jacobian, and the ellipsoid of all velocities."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arms.kinematics import twist
from ..arms.motions import Frame, matrix

_FLAT = 1e-12  # of the ellipsoid's size: what is thinner is flat


@dataclass(frozen=True)
class Velocity:
    """A frame that shows how fast the origin of frame `of` moves.

    Every joint i moves at `rates[i]` (rad or length per second). With `joint`, the frame stands
    where the origin would be after one second at the velocity that this joint gives it now: an
    arrow from one origin to the other is a column of the Jacobian. Without, its columns L span
    the velocity ellipsoid: L u for unit vectors u are the velocities of joint rates whose squares,
    each divided by its rate's, add up to 1. L is lower triangular.
    """

    of: int
    rates: tuple[float, ...]
    joint: int | None = None

    def frame(self, motions: Sequence[Any], frames: Sequence[Frame], q: Sequence[float]) -> Frame:
        """The frame, given all motions and the frames before it."""
        columns = velocities(motions, frames, self.of, len(self.rates)) * self.rates
        tip = matrix(frames[self.of])[:3, 3]
        if self.joint is not None:
            return _frame(np.eye(3), tip + columns[:, self.joint])
        return _frame(_root(columns @ columns.T), tip)

    def data(self, k: int) -> list:
        """Plain data for the browser."""
        return [2, self.of, self.rates, -1 if self.joint is None else self.joint]


def velocities(motions: Sequence[Any], frames: Sequence[Frame], of: int, n: int) -> np.ndarray:
    """Velocity of the origin of frame `of` for a unit rate of each of n knobs, shape (3, n)."""
    columns, tip = np.zeros((3, n)), matrix(frames[of])[:3, 3]
    while of > 0:
        motion, pose = motions[of - 1], matrix(frames[of])
        if motion.joint is not None:
            velocity = twist(motion.kind, pose[:3, motion.axis], tip - pose[:3, 3])[:3]
            columns[:, motion.joint] += motion.gain * np.array(velocity)
        of = of - 1 if motion.parent is None else motion.parent
    return columns


def _frame(axes: np.ndarray, origin: np.ndarray) -> Frame:
    return Frame(tuple(map(tuple, axes.T.tolist())), tuple(origin.tolist()))


def _root(square: np.ndarray) -> np.ndarray:
    """The lower triangle L with L L^T = `square`; a direction that is flat gets zeros."""
    L, size = np.zeros((3, 3)), np.trace(square)
    for k in range(3):
        left = square[:, k] - L @ L[k]
        if left[k] > _FLAT * size:
            L[k:, k] = left[k:] / np.sqrt(left[k])
    return L
