"""Forward kinematics: frames, the tool's pose and the Jacobian, for one pose or a million."""
from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import chain
from typing import Any

import numpy as np

from .arm import Arm, check_arm
from .joints import given_joints
from .link import PRISMATIC, REVOLUTE, Link
from .motions import ROTATE, Frame, Motion, Values, along, cross, difference

# Poses worked on at a time, so that all components of a frame stay in the processor's cache.
CHUNK = 4096
FEW = 8  # poses: up to here one after the other in plain floats is ahead of arrays


def forward_kinematics(arm: Arm, q: Any) -> np.ndarray:
    """Pose of the tool in the room, T_0E: base, every link, and the tool.

    Parameters
    ----------
    arm : Arm
    q : array, shape (..., n)
        Joint values, radians for revolute and the arm's unit for prismatic joints. Values
        beyond the limits are allowed: limits belong to the hardware, not to the formula.

    Returns
    -------
    array, shape (..., 4, 4)

    Raises
    ------
    ValueError
        If `q` does not fit the arm or is not finite.

    Examples
    --------
    >>> from kinlab import robots
    >>> forward_kinematics(robots.alpha_ii(), [0, 0, 0, -np.pi / 2, 0])[:3, 3]
    array([485.1,   0. , 215. ])
    """
    return tool_poses(arm, given_joints(arm, q))


def tool_poses(arm: Arm, q: np.ndarray) -> np.ndarray:
    """`forward_kinematics` at joint values that were checked, or worked out."""
    if _few(arm, q):
        return _one_by_one(arm.route.pose, q, 4, 4)
    return _matrices([tuple(chain(*arm.chain))], q)[..., 0, :, :]


def link_frames(arm: Arm, q: Any) -> np.ndarray:
    """Poses of frames 0 to n in the room: T_00 (the base), T_01, ..., T_0n, without the tool.

    Every row of the table has a frame, a fixed one too.

    Parameters
    ----------
    arm : Arm
    q : array, shape (..., n)
        Joint values, radians or the arm's unit.

    Returns
    -------
    array, shape (..., len(arm.links) + 1, 4, 4)

    Raises
    ------
    ValueError
        If `q` does not fit the arm or is not finite.

    Examples
    --------
    >>> from kinlab import robots
    >>> link_frames(robots.two_link(), [0, 0])[:, 0, 3]
    array([0., 0., 1.])
    """
    return frame_poses(arm, given_joints(arm, q))


def frame_poses(arm: Arm, q: np.ndarray) -> np.ndarray:
    """`link_frames` at joint values that were checked, or worked out."""
    if _few(arm, q):
        return _one_by_one(arm.route.frames, q, len(arm.links) + 1, 4, 4)
    return _matrices(arm.chain[:-1], q)


def jacobian(arm: Arm, q: Any) -> np.ndarray:
    """Geometric Jacobian of the tool point, rows [v; w] in base axes.

    Column i is [z x (p - o); z] for a revolute joint and [z; 0] for a prismatic one, with z
    and o the joint's axis and a point on it (Spong, Hutchinson and Vidyasagar, chapter 4).

    Parameters
    ----------
    arm : Arm
    q : array, shape (..., n)
        Joint values, radians or the arm's unit.

    Returns
    -------
    array, shape (..., 6, n)
        Velocity (unit per joint unit) over angular velocity (radian per joint unit).

    Raises
    ------
    ValueError
        If `q` does not fit the arm or is not finite.

    Examples
    --------
    >>> from kinlab import robots
    >>> jacobian(robots.two_link(), [0, 0])[:2]
    array([[0., 0.],
           [2., 1.]])
    """
    q = given_joints(arm, q)
    if _few(arm, q):
        return _one_by_one(arm.route.jacobian, q, 6, arm.n)
    motions = tuple(chain(*arm.chain))
    J = np.empty((*q.shape[:-1], 6, arm.n))
    flat, out = q.reshape(-1, arm.n), J.reshape(-1, 6, arm.n)
    for start in range(0, len(flat), CHUNK):
        part = slice(start, start + CHUNK)
        columns = np.ascontiguousarray(flat[part].T)
        for i, twist in enumerate(tool_and_twists(motions, columns)[1]):
            for row, component in enumerate(twist):
                out[part, row, i] = component
    return J


def tool_and_twists(motions: Iterable[Motion], q: Values) -> tuple[Frame, list[tuple]]:
    """The frame at the end of the motions, and the twist (v, w) that each joint gives it.

    Components are floats, arrays or sympy expressions, as the joint values are.
    """
    tool, joints = tool_and_joints(motions, q)
    return tool, [twist(kind, z, difference(tool.origin, o)) for kind, z, o in joints]


def twist(kind: str, axis: Values, lever: Values) -> tuple:
    """A joint's column of the Jacobian: velocity and angular velocity that its unit rate gives.

    `axis` is its unit vector, `lever` goes from a point on the axis to the point that moves. Each
    is a sequence of three components, as in `motions`.
    """
    return (*cross(axis, lever), *axis) if kind == ROTATE else (*axis, 0, 0, 0)


def tool_and_joints(motions: Iterable[Motion], q: Values, frame: Frame | None = None
                    ) -> tuple[Frame, list[tuple]]:
    """The frame at the end of the motions, and each joint's kind, axis and a point on it.

    The axis is the one about or along which the joint moves as its value grows.
    """
    frame, joints = frame or Frame(), []
    for motion in motions:
        frame = frame.moved(motion, q)
        if motion.joint is not None:
            axes = frame.axes if frame.about == motion.axis else frame.settled()
            axis = axes[motion.axis]
            way = axis if motion.sign > 0 else tuple(-component for component in axis)
            joints.append((motion.kind, way, frame.origin))
    return frame, joints


def reach(arm: Arm) -> float:
    """No pose puts the tool farther than this from the base: links and slides laid end to end.

    Infinite if a prismatic joint has no limits.
    """
    check_arm(arm)
    links = sum(math.hypot(link.a, _longest(link)) for link in arm.links)
    return links + float(np.linalg.norm(arm.tool[:3, 3]))


def typical_length(arm: Arm) -> float:
    """The length beside which a turn by one radian counts: the reach, if that is a length."""
    length = reach(arm)
    return length if 0 < length < math.inf else 1.0


def is_planar(arm: Arm) -> bool:
    """True when all joints turn about parallel axes along the room's z."""
    frames = link_frames(arm, np.full(arm.n, 0.3))
    revolute = all(link.kind == REVOLUTE for link in arm.joints)
    return revolute and bool(np.allclose(np.abs(frames[:, 2, 2]), 1))


def axis_frames(arm: Arm) -> list[int]:
    """Index of the link frame whose z is the axis of each joint."""
    first = 0 if arm.convention == "standard" else 1
    return [row + first for row in arm.rows]


def _few(arm: Arm, q: np.ndarray) -> bool:
    return q.size <= FEW * arm.n


def _one_by_one(made: Callable[[list[float]], Sequence], q: np.ndarray, *shape: int) -> np.ndarray:
    """What is made of the joint values of each pose, shape (..., *shape)."""
    each = [made(pose) for pose in q.reshape(-1, q.shape[-1]).tolist()]
    # With one nought: -0.0 is the other, and would be printed so.
    return np.array(each).reshape(*q.shape[:-1], *shape) + 0.0


def _matrices(stretches: Sequence[Sequence[Motion]], q: np.ndarray) -> np.ndarray:
    """Frames after each stretch of motions, shape (..., len(stretches), 4, 4)."""
    poses = np.empty((*q.shape[:-1], len(stretches), 4, 4))
    flat, out = q.reshape(-1, q.shape[-1]), poses.reshape(-1, len(stretches), 4, 4)
    for start in range(0, len(flat), CHUNK):
        part = slice(start, start + CHUNK)
        columns = np.ascontiguousarray(flat[part].T)
        for k, frame in enumerate(along(stretches, columns)):
            _write(frame, out[part, k])
    return poses


def _write(frame: Frame, out: np.ndarray) -> None:
    for j, column in enumerate((*frame.settled(), frame.origin)):
        for i, component in enumerate(column):
            out[:, i, j] = component
    out[:, 3] = 0, 0, 0, 1


def _longest(link: Link) -> float:
    """The largest link offset, whatever the joint does."""
    if link.kind != PRISMATIC:
        return abs(link.d)
    sign = -1 if link.flip else 1
    return max(abs(link.d + sign * end) for end in link.limits) if link.limits else math.inf
