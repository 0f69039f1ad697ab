"""Forward kinematics: frames, the tool's pose and the Jacobian, for one pose or a million."""
from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any

import numpy as np

from . import checks
from .arm import REVOLUTE, Arm, _check_arm
from .motions import Frame, Motion, along, matrix

# Poses worked on at a time, so that all components of a frame stay in the processor's cache.
CHUNK = 4096


def joint_values(arm: Arm, q: Any, name: str = "q") -> np.ndarray:
    """Joint values as an array (..., n), or a ValueError that says what was wrong."""
    _check_arm(arm)
    who = f"arm '{arm.name}'" if arm.name else "this arm"
    q = checks.real_array(name, q, f"{arm.n} joint values in radians or {arm.unit}")
    if q.shape[-1:] != (arm.n,):
        raise ValueError(f"{name}: expected shape (..., {arm.n}) for {who}, got {q.shape}; "
                         "give one value per joint")
    return q


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
    q = joint_values(arm, q)
    return _matrices([tuple(chain(*arm.chain))], q)[..., 0, :, :]


def link_frames(arm: Arm, q: Any) -> np.ndarray:
    """Poses of frames 0 to n in the room: T_00 (the base), T_01, ..., T_0n, without the tool.

    Parameters
    ----------
    arm : Arm
    q : array, shape (..., n)
        Joint values, radians or the arm's unit.

    Returns
    -------
    array, shape (..., n + 1, 4, 4)

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
    q = joint_values(arm, q)
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
    q = joint_values(arm, q)
    frames = _matrices(arm.chain, q)
    joints = frames[..., axis_frames(arm), :, :]
    z, lever = joints[..., :3, 2], frames[..., -1:, :3, 3] - joints[..., :3, 3]
    turns = np.array([link.kind == REVOLUTE for link in arm.links])[:, None]
    columns = np.concatenate([np.where(turns, np.cross(z, lever), z), np.where(turns, z, 0)], -1)
    return np.swapaxes(columns, -1, -2)


def axis_frames(arm: Arm) -> list[int]:
    """Index of the link frame whose z is the axis of each joint."""
    first = 0 if arm.convention == "standard" else 1
    return list(range(first, first + arm.n))


def _matrices(stretches: Sequence[Sequence[Motion]], q: np.ndarray) -> np.ndarray:
    """Frames after each stretch of motions, shape (..., len(stretches), 4, 4)."""
    if q.ndim == 1:  # plain floats are faster than arrays of one
        return np.stack([matrix(frame) for frame in along(stretches, q.tolist())])
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
