"""The same arm in a table that has rows for joints only.

A fixed row before the first joint belongs to the base, one behind the last joint to the tool; the
other rows stay as they are. One between two joints moves the next axis: frames are set anew then.
"""
from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from ..arms.arm import Arm, row_of, to_standard
from ..arms.kinematics import axis_frames, forward_kinematics, link_frames
from ..arms.link import FIXED, with_numbers


def kinds(arm: Arm) -> list[str]:
    return [link.kind for link in arm.links]


def without_ends(arm: Arm) -> tuple[Arm, int]:
    """The arm with its first and last fixed rows in base and tool, and how many came first."""
    first, last = arm.rows[0], arm.rows[-1]
    if first == 0 and last == len(arm.links) - 1:
        return arm, 0
    frames = link_frames(arm, np.zeros(arm.n))
    tool = np.linalg.inv(frames[last + 1]) @ forward_kinematics(arm, np.zeros(arm.n))
    return replace(arm, links=arm.links[first:last + 1], base=frames[first], tool=tool), first


def joints_only(arm: Arm) -> Arm:
    """The same arm in the standard convention, with a row for each joint.

    Examples
    --------
    >>> from kinlab import fixed, revolute
    >>> arm = Arm([revolute(), fixed(theta=1, a=2), revolute(a=1), fixed(d=3)])
    >>> [link.a for link in joints_only(arm).links]
    [2.0, 0.0]
    """
    arm, _ = without_ends(arm)
    if FIXED not in kinds(arm):
        return to_standard(arm)
    axes = link_frames(arm, np.zeros(arm.n))[axis_frames(arm)]
    frames = [axes[0]]
    for axis in axes[1:]:
        frames.append(_next(frames[-1], axis))
    rows = [with_numbers(link, **row_of(np.linalg.inv(before) @ after))
            for link, (before, after) in zip(arm.joints, pairwise(frames))]
    tool = np.linalg.inv(frames[-1]) @ forward_kinematics(arm, np.zeros(arm.n))
    last = with_numbers(arm.joints[-1], theta=0, d=0, a=0, alpha=0)
    return Arm([*rows, last], name=arm.name, unit=arm.unit, base=frames[0], tool=tool,
               home=arm.home)


def _next(before: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """The frame on an axis that keeps the rules of the standard convention."""
    z0, z, span = before[:3, 2], axis[:3, 2], axis[:3, 3] - before[:3, 3]
    normal = np.cross(z0, z)
    if np.linalg.norm(normal) > 1e-9:
        x, origin = normal, axis[:3, 3] - span @ np.cross(normal, z0) / (normal @ normal) * z
    else:
        across, origin = span - span @ z0 * z0, axis[:3, 3]
        x = across if np.linalg.norm(across) > 1e-12 else axis[:3, 0]
    x = x / np.linalg.norm(x) * (-1 if x @ axis[:3, 0] < 0 else 1)
    T = np.eye(4)
    T[:3] = np.column_stack([x, np.cross(z, x), z, origin])
    return T
