"""Whether two arms of the same mechanism stand alike at q = 0 and carry the same tool."""
from __future__ import annotations

import numpy as np

from ..arms.kinematics import forward_kinematics
from .mechanism import SIXTH_DECIMAL, Axes


def stand_alike(mine: Axes, theirs: Axes) -> bool:
    """Whether all axes lie on each other once the tool frames do."""
    G = _tool(mine) @ np.linalg.inv(_tool(theirs))
    z, points = theirs.z @ G[:3, :3].T, _points(theirs) @ G[:3, :3].T + G[:3, 3]
    away = np.cross(mine.z, _points(mine) - points)
    away[~mine.turns] = 0  # a prismatic joint has a direction, not a place
    reach = np.abs(mine.steps()).sum() + mine.longest
    turned = np.linalg.norm(np.cross(mine.z, z), axis=1) > mine.n * SIXTH_DECIMAL
    moved = np.linalg.norm(away, axis=1) > mine.n * SIXTH_DECIMAL * reach
    return not np.any(turned | moved)


def _tool(axes: Axes) -> np.ndarray:
    """The tool at q = 0 in axes like the room's, at the origin of frame 0."""
    T = forward_kinematics(axes.arm, np.zeros(axes.n))
    T[:3, 3] -= axes.arm.base[:3, 3]
    return T


def _points(axes: Axes) -> np.ndarray:
    """A point on each axis at q = 0, in the same frame."""
    return np.vstack([np.zeros(3), np.cumsum(axes.steps(), axis=0)[:-1]])
