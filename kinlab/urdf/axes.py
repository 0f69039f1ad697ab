"""The joint axes of a chain, as lines in space at q = 0, each looking the way its table needs."""
from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from .chain import Chain
from .robot import SLIDES
from .rows import STEEP, Line

_AGAINST = -1 + 1e-6  # the cosine of axes that look against each other, or almost


class Axis(NamedTuple):
    """A joint's axis.

    Attributes
    ----------
    line : Line
    flip : bool
        Whether the joint counts the other way about it.
    slides : bool
    x : array, shape (3,)
        x of the file's own frame of the link that it moves, if that has its z on the axis; else 0.
    """

    line: Line
    flip: bool
    slides: bool
    x: np.ndarray


def axes_of(chain: Chain) -> list[Axis]:
    """The axes of the joints that move.

    A joint that counts about -z of the axis before it, or about -z of the root, is flipped: its z
    looks the same way, and it moves by -q.
    """
    axes: list[Axis] = []
    before = np.array([0.0, 0.0, 1.0])
    for k in chain.moving:
        pose, joint = chain.poses[k + 1], chain.joints[k]
        z = pose[:3, :3] @ joint.axis()
        flip = bool(z @ before < _AGAINST)
        before = -z if flip else z
        own = pose[:3, 0] * (pose[:3, 2] @ before > 1 - 1e-9)
        axes.append(Axis(Line(pose[:3, 3], before), flip, joint.kind in SLIDES, own))
    return _placed(axes, chain.poses[-1])


def size_of(chain: Chain) -> float:
    """The length of the arm: from joint to joint to the tip."""
    ends = [*chain.poses[chain.moving], chain.poses[-1]]
    return float(sum(np.linalg.norm(b[:3, 3] - a[:3, 3]) for a, b in pairwise(ends))) or 1.0


def _placed(axes: list[Axis], tool: np.ndarray) -> list[Axis]:
    """The axes with those that slide where they are handy: such an axis has a direction only."""
    placed, after = [], Line(tool[:3, 3], tool[:3, 2])
    for k in reversed(range(len(axes))):
        axis = axes[k]
        if axis.slides:
            before = axes[k - 1].line if k else Line(np.zeros(3), np.array([0.0, 0.0, 1.0]))
            point, z = _handy(axis.line, before, after), axis.line.z
            height = (axis.line.point - point) @ z  # along the axis it stays where the file has it
            axis = axis._replace(line=Line(point + height * z, z))
        placed.append(axis)
        after = axis.line
    return placed[::-1]


def _handy(line: Line, before: Line, after: Line) -> np.ndarray:
    """A point through which a sliding axis meets its neighbours, or as many of them as it can."""
    if _same_way(line, after):
        return after.point
    if _same_way(line, before):
        return before.point
    normal = np.cross(before.z, line.z)  # of the plane in which it meets the axis before
    slope = normal @ after.z
    if abs(slope) < STEEP:
        return after.point
    return after.point + normal @ (before.point - after.point) / slope * after.z


def _same_way(one: Line, other: Line) -> bool:
    return float(np.linalg.norm(np.cross(one.z, other.z))) < 1e-6
