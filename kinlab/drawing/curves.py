"""Curves that knobs shape: where a motion carries a point, and a way as far as it has gone."""
from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from ..arms.motions import ROTATE, Numbers
from .scene import PATCH, SWEEP, WAY, Item, Step

_FINE = math.pi / 60  # rad from corner to corner of an arc: a tenth of a pixel beside it


def is_there(item: Item, q: Numbers) -> bool:
    """Whether a knob lets an item be seen."""
    if item.when is None:
        return True
    knob, low, high = item.when
    return low <= q[knob] <= high or (low > high and not high < q[knob] < low)


def corners(item: Item, motions: Sequence[Any], frames: np.ndarray, q: Numbers) -> np.ndarray:
    """Points of an item in the room, shape (m, 3)."""
    local = np.array([(*point[1:], 1.0) for point in item.points])
    room = np.einsum("kij,kj->ki", frames[[int(point[0]) for point in item.points], :3], local)
    made = _MADE.get(item.shape)
    return made(room, item.size, motions, frames, q) if made else room


class _Carrier:
    """What carries points from where a motion leaves them to where another one would.

    Both begin at the same frame and are of one kind, about or along the same axis.
    """

    def __init__(self, ends: Sequence[float], motions: Sequence[Step], frames: np.ndarray,
                 q: Numbers) -> None:
        first, last = map(int, ends)
        motion, end = motions[first - 1], motions[last - 1]
        self.turns = motion.kind == ROTATE
        self.way = end.value(q) - motion.value(q)
        self.axis, self.origin = frames[first][:3, motion.axis], frames[first][:3, 3]

    @property
    def shares(self) -> np.ndarray:
        """Shares of the way at which a curve has its corners."""
        pieces = math.ceil(abs(self.way) / _FINE - 1e-9) if self.turns else 1
        return np.linspace(0, 1, max(1, pieces) + 1)

    def carried(self, points: np.ndarray, shares: np.ndarray) -> np.ndarray:
        """Each point at its share of the way."""
        way = (shares * self.way)[:, None]
        if not self.turns:
            return points + way * self.axis
        arm = points - self.origin
        along = (arm @ self.axis)[:, None] * self.axis
        return (self.origin + along + np.cos(way) * (arm - along)
                + np.sin(way) * np.cross(self.axis, arm))


def _sweep(room: np.ndarray, size: tuple[float, ...], *at: Any) -> np.ndarray:
    carrier = _Carrier(size, *at)
    return carrier.carried(room, carrier.shares)


def _patch(room: np.ndarray, size: tuple[float, ...], *at: Any) -> np.ndarray:
    """The outline of what a point sweeps with two motions: each at an end while the other goes."""
    near, far = _Carrier(size[:2], *at), _Carrier(size[2:], *at)
    s, t = near.shares, far.shares
    sides = [(s, 0 * s), (1 + 0 * t, t), (1 - s, 1 + 0 * s), (0 * t, 1 - t)]
    return np.concatenate([near.carried(far.carried(room, t), s) for s, t in sides])


def _way(room: np.ndarray, size: tuple[float, ...], motions: Sequence[Any], frames: np.ndarray,
         q: Numbers) -> np.ndarray:
    place = min(max(q[int(size[0])], 0.0), len(room) - 1.0)
    k = math.floor(place)
    if k == place:
        return room[:k + 1]
    return np.vstack([room[:k + 1], room[k] + (place - k) * (room[k + 1] - room[k])])


_MADE: dict[str, Callable[..., np.ndarray]] = {SWEEP: _sweep, PATCH: _patch, WAY: _way}
