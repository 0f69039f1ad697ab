"""A Denavit-Hartenberg table for a chain of joints, by the common normals of their axes."""
from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from ..arms.arm import Arm, row_of, to_modified
from ..arms.kinematics import link_frames
from ..arms.link import PRISMATIC, REVOLUTE, Link, fixed
from ..arms.transforms import inverse
from .axes import Axis, axes_of, size_of
from .chain import Chain
from .robot import Joint
from .rows import PARALLEL, Numbers, clean, clean_length, plain_turn, steps_to

_ALIKE = 1e-9  # entries of frames that are one and the same


def arm_of(chain: Chain) -> tuple[Arm, str]:
    """The arm whose table leaves least over, in its convention, and why in that."""
    standard = standard_arm(chain)
    modified = to_modified(standard)
    modified = replace(modified, tool=tidy(modified.tool, size_of(chain)))
    left, right = (_left_over(arm) for arm in (standard, modified))
    if len(left) < len(right):
        return standard, f"modified would need a matrix for the {right[-1]}, too"
    if len(right) < len(left):
        return modified, f"standard would need a matrix for the {left[0]}, too"
    if _all_own(modified, chain):
        return modified, "its frames are the file's own"
    return standard, "both conventions fit alike"


def standard_arm(chain: Chain) -> Arm:
    """The arm in the standard convention: frame i stands on the axis of joint i + 1."""
    axes, size = axes_of(chain), size_of(chain)
    joints = [chain.joints[k] for k in chain.moving]
    base, own = _first(axes[0])
    frame, links = base, list[Link]()
    for (axis, after), joint in zip(pairwise(axes), joints):
        first = not links
        steps = steps_to(frame, after.line, size, level=axis.slides or not first)
        if len(steps) == 1:
            steps = [_plainer(steps[0], frame, after.x)]
        if first and not own:  # x of the base is free: the joint may count from 0
            base = frame = frame @ Numbers(theta=steps[0].theta).matrix()
            steps[0] = steps[0]._replace(theta=0.0)
        links += [_link(joint, axis, steps[0]), *(fixed(**row._asdict()) for row in steps[1:])]
        for row in steps:
            frame = frame @ row.matrix()
    last = _last(inverse(frame) @ chain.poses[-1], size, axes[-1].slides)
    tool = tidy(inverse(frame @ last.matrix()) @ chain.poses[-1], size)
    links.append(_link(joints[-1], axes[-1], last))
    return Arm(links, name=chain.robot.name, base=tidy(base, size), tool=tool,
               home=[np.clip(0, *(link.limits or (0, 0))) for link in links if link.variable])


def _first(axis: Axis) -> tuple[np.ndarray, bool]:
    """Frame 0, on the first axis where it is nearest to the root, and whether its x is the root's.

    If it is not, any will do.
    """
    (point, z), frame = axis.line, np.eye(4)
    own = abs(z[0]) <= PARALLEL
    x = np.eye(3)[0] if own else np.cross(z, np.eye(3)[np.argmin(np.abs(z))])
    x = x - x @ z * z
    x = x / np.linalg.norm(x)
    frame[:3] = np.column_stack([x, np.cross(z, x), z, point - point @ z * z])
    return frame, own


def _plainer(row: Numbers, frame: np.ndarray, own: np.ndarray) -> Numbers:
    """The row or its other way: x as in the file's own frame, or with the smaller joint offset."""
    if not (row.a or row.alpha):
        return row
    agree = float((frame @ row.matrix())[:3, 0] @ own)
    if abs(agree) > 1 - _ALIKE:
        return row if agree > 0 else row.other_way()
    return min(row, row.other_way(),
               key=lambda one: (round(abs(one.theta), 9), one.a < 0, one.alpha < 0))


def _last(T: np.ndarray, size: float, slides: bool) -> Numbers:
    """The last row: all the way to the tool if a row can be, else to the tool's height."""
    row = clean(size, **row_of(T))
    if np.allclose(row.matrix(), T, rtol=0, atol=PARALLEL * max(size, 1.0)):
        return row
    return clean(size, 0.0, 0.0 if slides else T[2, 3], 0.0, 0.0)


def _link(joint: Joint, axis: Axis, row: Numbers) -> Link:
    kind, limits = PRISMATIC if axis.slides else REVOLUTE, joint.limits()
    if limits and not axis.slides:
        limits = plain_turn(limits[0]), plain_turn(limits[1])
    return Link(kind, **row._asdict(), limits=limits, name=joint.name, flip=axis.flip,
                speed=joint.speed())


def tidy(T: np.ndarray, size: float) -> np.ndarray:
    """The pose without what rounding left in it: no 1e-17, and right angles as they are."""
    tidied, near = np.eye(4), np.round(T[:3, :3])
    whole = np.abs(T[:3, :3] - near).max() <= PARALLEL
    tidied[:3, :3] = near if whole else np.round(T[:3, :3], 15)
    tidied[:3, 3] = [clean_length(length, size) for length in T[:3, 3]]
    return tidied + 0.0


def _left_over(arm: Arm) -> list[str]:
    """Which of base and tool is a matrix that the table does not hold."""
    return [end for end, T in (("base", arm.base), ("tool", arm.tool))
            if not np.array_equal(T, np.eye(4))]


def _all_own(arm: Arm, chain: Chain) -> bool:
    """Whether all frames, perhaps without the last, are those of the file's links."""
    frames = link_frames(arm, np.zeros(arm.n))[[row + 1 for row in arm.rows]]
    theirs = chain.poses[[k + 1 for k in chain.moving]]
    return arm.n > 1 and np.allclose(frames[:-1], theirs[:-1], rtol=0, atol=_ALIKE)
