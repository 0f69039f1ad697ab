"""The straight way from one pose to another: evenly along a line, evenly about one axis."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arms.quaternions import axis_angle, rotation_about
from ..arms.route import Place


@dataclass(frozen=True, eq=False)
class Line:
    """Poses from `start` on: moved by `way`, and turned by `angle` about `axis`, in the room."""

    start: np.ndarray  # (4, 4)
    way: np.ndarray    # (3,)
    axis: np.ndarray   # (3,)
    angle: float

    @classmethod
    def between(cls, start: np.ndarray, end: np.ndarray) -> Line:
        """The line from one pose (4, 4) to another; it turns the shorter way round."""
        axis, angle = axis_angle(end[:3, :3] @ start[:3, :3].T)
        return cls(start, end[:3, 3] - start[:3, 3], axis, angle)

    def pose(self, s: float) -> np.ndarray:
        """The pose at the part s of the way."""
        T = self.start.copy()
        T[:3, 3] += s * self.way
        if self.angle:
            T[:3, :3] = rotation_about(self.axis, s * self.angle) @ self.start[:3, :3]
        return T

    def seen(self, s: float) -> tuple[Place, np.ndarray]:
        """The room, and the twist (v, w) per unit of s, as the pose at s sees them."""
        T = self.pose(s)
        R, o = T[:3, :3], T[:3, 3]
        twist = np.concatenate([self.way @ R, self.angle * self.axis @ R])
        return (R.tolist(), (-o @ R).tolist()), twist
