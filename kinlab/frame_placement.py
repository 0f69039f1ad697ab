"""Frames that a student places on a drawn arm: the rules checked one by one, then the table."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import atan2, degrees
from typing import Any

import numpy as np

from . import checks
from .arm import REVOLUTE, Arm
from .kinematics import axis_frames, joint_values, link_frames
from .verdict import CORRECT, NOT_YET, Verdict

TOLERANCE = 1e-6  # rad, and of the drawing's size


@dataclass(frozen=True, eq=False, repr=False)
class Placement(Verdict):
    """What `examine_frames` has to say.

    Attributes
    ----------
    word, message, ok
        As in every verdict.
    arm : Arm or None
        The standard DH table that follows from valid frames. Its joint variables carry no
        offset: `arm.home` holds the values of the drawn pose. Frame 0 is the arm's base.
    """

    arm: Arm | None = None


def examine_frames(frames: Sequence, reference: Arm, q: Any = None) -> Placement:
    """Check frames placed on a drawn arm by the rules of Denavit and Hartenberg (standard).

    Frame i sits on the axis of joint i + 1 with z along it, x_i is perpendicular to z_{i-1}
    (rule 1) and meets it (rule 2). The last frame has no joint of its own: rules 1 and 2 hold.

    Parameters
    ----------
    frames : sequence of n + 1 frames (z, x, origin)
        Frames 0 to n in room coordinates: two directions, of any length, and a point.
    reference : Arm
        The arm that is drawn, in either convention.
    q : n floats, optional
        The drawn pose (rad or length); the reference's home if left out.

    Returns
    -------
    Placement
        With `ok`, `message` (the first broken rule and what to do) and `arm`.

    Raises
    ------
    ValueError
        If the reference is no Arm, q does not fit it, or the frames are not n + 1 triples of
        finite vectors.

    Examples
    --------
    >>> from kinlab import robots
    >>> up, ahead = (0, 0, 1), (1, 0, 0)
    >>> frames = [(up, ahead, (0, 0, 0)), (up, ahead, (1, 0, 0)), (up, ahead, (2, 0, 0))]
    >>> examine_frames(frames, robots.two_link(), [0, 0])
    ✓ Correct. All frames keep the rules.
    >>> [link.a for link in examine_frames(frames, robots.two_link(), [0, 0]).arm.links]
    [1.0, 1.0]
    """
    q = joint_values(reference, getattr(reference, "home", None) if q is None else q)
    if q.ndim > 1:
        raise ValueError(f"q: expected one pose of {reference.n} joint values, got {q.shape}; "
                         "give the pose that is drawn")
    z, x, origins = _vectors(frames, reference.n)
    joints = link_frames(reference, q)[axis_frames(reference)]
    drawing = _Drawing(z, x, origins, joints, reference)
    for i in range(reference.n + 1):
        fault = _own(drawing, i) or (i and _towards(drawing, i)) or ""
        if fault:
            return Placement(NOT_YET, fault)
    return Placement(CORRECT, "All frames keep the rules.", _table(drawing))


@dataclass(frozen=True, eq=False)
class _Drawing:
    z: np.ndarray
    x: np.ndarray
    origins: np.ndarray
    joints: np.ndarray
    reference: Arm

    @property
    def size(self) -> float:
        """Of what is drawn; where all meets in one point, rounding leaves some noise."""
        points = np.vstack([self.origins, self.joints[:, :3, 3]])
        return max(np.ptp(points, axis=0).max(), 1e-6 * np.abs(points).max(), 1e-6)

    def length(self, value: float) -> str:
        return f"{value + 0.0:.6g} {self.reference.unit}"


def _vectors(frames: Sequence, n: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    expected = f"{n + 1} frames (z, x, origin) of three numbers each, frame 0 to frame {n}"
    array = checks.shaped("frames", frames, (n + 1, 3, 3), expected)
    lengths = np.linalg.norm(array[:, :2], axis=2)
    if not np.all(lengths > 0):
        i, k = np.argwhere(lengths == 0)[0]
        raise ValueError(f"frames[{i}]: expected a direction for {'zx'[k]}, got zeros; "
                         "give a vector along it")
    return array[:, 0] / lengths[:, :1], array[:, 1] / lengths[:, 1:], array[:, 2]


def _own(drawing: _Drawing, i: int) -> str:
    """What is wrong with a frame by itself and on its joint, or ""."""
    z, x, origin = drawing.z[i], drawing.x[i], drawing.origins[i]
    if i < drawing.reference.n:
        joint, kind = drawing.joints[i], drawing.reference.links[i].kind
        angle = _between_lines(z, joint[:3, 2])
        if angle > TOLERANCE:
            return (f"z{i} must lie along the axis of joint {i + 1}, either way: "
                    f"turn it by {degrees(angle):.4g}°.")
        away = np.linalg.norm(np.cross(joint[:3, 2], origin - joint[:3, 3]))
        if kind == REVOLUTE and away > TOLERANCE * drawing.size:
            return (f"The origin of frame {i} is {drawing.length(away)} away from the axis of "
                    f"joint {i + 1}: move it onto the axis.")
    tilt = _angle(x, z)
    if abs(tilt - np.pi / 2) > TOLERANCE:
        return (f"x{i} and z{i} are {degrees(tilt):.4g}° apart: the axes of a frame are "
                f"perpendicular. Turn x{i}.")
    return ""


def _towards(drawing: _Drawing, i: int) -> str:
    """How frame i breaks rule 1 or 2 towards the frame before it, or ""."""
    z0, z, x = drawing.z[i - 1], drawing.z[i], drawing.x[i]
    span = drawing.origins[i] - drawing.origins[i - 1]
    normal, tilt = np.cross(z0, z), _angle(x, z0)
    parallel = np.linalg.norm(normal) <= TOLERANCE
    if not parallel and abs(tilt - np.pi / 2) > TOLERANCE:
        turn = _between_lines(x, normal)
        return (f"Rule 1: x{i} is not perpendicular to z{i - 1} (they are {degrees(tilt):.4g}° "
                f"apart): turn x{i} by {degrees(turn):.4g}° about z{i}.")
    miss = np.cross(x, z0)
    if abs(span @ miss) <= TOLERANCE * drawing.size:
        return ""
    start = f"Rule 2: x{i} is perpendicular to z{i - 1} but does not meet it: "
    if parallel:
        return (f"{start}z{i - 1} and z{i} are parallel, so point x{i} straight from one "
                "to the other.")
    return f"{start}slide the origin by {drawing.length(-(span @ miss) / (z @ miss))} along z{i}."


def _table(drawing: _Drawing) -> Arm:
    poses = [_pose(*frame) for frame in zip(drawing.z, drawing.x, drawing.origins)]
    rows = [_row(np.linalg.inv(before) @ after) for before, after in pairwise(poses)]
    links, home = [], []
    for link, row in zip(drawing.reference.links, rows):
        home.append(row.pop(link.variable))
        links.append(replace(link, **({"theta": 0.0, "d": 0.0} | row), limits=None))
    reference = drawing.reference
    return Arm(links, name=reference.name, unit=reference.unit, base=poses[0], home=home)


def _pose(z: np.ndarray, x: np.ndarray, origin: np.ndarray) -> np.ndarray:
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = x, np.cross(z, x), z, origin
    return T


def _row(A: np.ndarray) -> dict[str, float]:
    """The four numbers of a DH matrix."""
    return {"theta": atan2(A[1, 0], A[0, 0]), "d": float(A[2, 3]),
            "a": float(A[:2, 3] @ A[:2, 0]), "alpha": atan2(A[2, 1], A[2, 2])}


def _angle(u: np.ndarray, v: np.ndarray) -> float:
    return float(np.arctan2(np.linalg.norm(np.cross(u, v)), u @ v))


def _between_lines(u: np.ndarray, v: np.ndarray) -> float:
    """The angle between two lines, whichever way their directions point."""
    return float(np.arctan2(np.linalg.norm(np.cross(u, v)), abs(u @ v)))
