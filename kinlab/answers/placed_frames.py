"""Frames that a student places on a drawn arm: the rules checked one by one, then the table."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from math import degrees
from typing import Any

import numpy as np

from ..arms import inputs
from ..arms.arm import Arm, row_of
from ..arms.joints import joint_array
from ..arms.kinematics import axis_frames, forward_kinematics, link_frames
from ..arms.link import REVOLUTE, with_numbers
from .fixed_rows import joints_only
from .verdict import CORRECT, NOT_YET, Verdict

# In rad, and of the drawing's size: frames typed with four decimals pass (each entry is off by
# half of the fourth, and several add up). What passes is laid upon the arm's own axes, so that
# the table that follows is exact.
FOURTH_DECIMAL = 3e-4
ROUNDING, PARALLEL = 1e-9, 1e-6


@dataclass(frozen=True, eq=False, repr=False)
class Placement(Verdict):
    """What `examine_frames` has to say.

    Attributes
    ----------
    word, message, ok, fault
        As in every verdict.
    arm : Arm or None
        The standard DH table that follows from valid frames. Its joint variables carry no
        offset: `arm.home` holds the values of the drawn pose. Frame 0 is the arm's base.
    """

    arm: Arm | None = None


def examine_frames(frames: Sequence, reference: Arm, q: Any = None) -> Placement:
    """Check frames placed on a drawn arm by the rules of Denavit and Hartenberg (standard).

    Frame i sits on the axis of joint i + 1 with z along it, x_i is perpendicular to z_{i-1}
    (rule 1) and meets it (rule 2). The axis of a prismatic joint has a direction and no place:
    its frame may sit anywhere. The last frame has no joint of its own: rules 1 and 2 hold.
    Four decimals are enough: what is nearer than 0.017° and 3e-4 of the arm's size counts.

    Parameters
    ----------
    frames : sequence of n + 1 frames (z, x, origin)
        Frames 0 to n in room coordinates: two directions, of any length, and a point.
    reference : Arm
        The arm that is drawn, in either convention. Its fixed rows need no frames.
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
    drawing = _drawing(frames, reference, q)
    fault = _first_fault(drawing, len(drawing.z))
    return (Placement(NOT_YET, fault) if fault else
            Placement(CORRECT, "All frames keep the rules.", arm=_table(drawing)))


def first_fault(frames: Sequence, reference: Arm, q: Any = None) -> str:
    """The first broken rule of frames 0, 1, ..., where the last ones are still to come, or ""."""
    frames = [*frames]
    missing = reference.n + 1 - len(frames)
    return _first_fault(_drawing(frames + frames[-1:] * missing, reference, q), len(frames))


def _drawing(frames: Sequence, reference: Arm, q: Any) -> _Drawing:
    q = joint_array(reference, getattr(reference, "home", None) if q is None else q)
    if q.ndim > 1:
        raise ValueError(f"q: expected one pose of {reference.n} joint values, got {q.shape}; "
                         "give the pose that is drawn")
    if reference.n < len(reference.links):
        reference = joints_only(reference)
    z, x, origins = _vectors(frames, reference.n)
    return _Drawing(z, x, origins, np.zeros(len(z), dtype=bool), reference, q)


def _first_fault(drawing: _Drawing, count: int) -> str:
    """What is wrong with the first of so many frames that breaks a rule, or ""."""
    for i in range(count):
        for check, settle in ((_own, _settle_on_axis), (_towards, _settle_across)):
            if fault := check(drawing, i):
                return fault
            settle(drawing, i)
    return ""


@dataclass(frozen=True, eq=False)
class _Drawing:
    """Frames in room coordinates, beside the arm's axes; `_settle_...` writes into them."""

    z: np.ndarray
    x: np.ndarray
    origins: np.ndarray
    placed: np.ndarray  # whether the line on which a frame sits is settled
    reference: Arm
    q: np.ndarray

    @cached_property
    def size(self) -> float:
        """Of the arm; where all of it meets in one point, of the frames placed on it."""
        tip = forward_kinematics(self.reference, self.q)[:3, 3]
        arm = np.vstack([link_frames(self.reference, self.q)[:, :3, 3], tip])
        noise = max(1e-6 * np.abs(arm).max(), 1e-6)
        sizes = (np.ptp(points, axis=0).max() for points in (arm, self.origins))
        return next((size for size in sizes if size > noise), noise)

    @cached_property
    def joints(self) -> np.ndarray:
        """Poses whose z lies along the axis of each joint."""
        return link_frames(self.reference, self.q)[axis_frames(self.reference)]

    def turns(self, i: int) -> bool:
        """Whether frame i sits on a revolute joint, whose axis has a place."""
        return i < self.reference.n and self.reference.links[i].kind == REVOLUTE

    def away(self, i: int, k: int) -> float:
        """How far the origin of frame i is from the axis of joint k + 1."""
        joint = self.joints[k]
        return float(np.linalg.norm(np.cross(joint[:3, 2], self.origins[i] - joint[:3, 3])))

    def normal(self, i: int) -> np.ndarray | None:
        """The direction across z_{i-1} and z_i, or None where they are parallel."""
        normal = np.cross(self.z[i - 1], self.z[i])
        size = np.linalg.norm(normal)
        return normal / size if size > PARALLEL else None

    def length(self, value: float) -> str:
        return f"{value + 0.0:.6g} {self.reference.unit}"


def _vectors(frames: Sequence, n: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    expected = f"{n + 1} frames (z, x, origin) of three numbers each, frame 0 to frame {n}"
    array = inputs.shaped("frames", frames, (n + 1, 3, 3), expected)
    lengths = np.linalg.norm(array[:, :2], axis=2)
    if not np.all(lengths > 0):
        i, k = np.argwhere(lengths == 0)[0]
        raise ValueError(f"frames[{i}]: expected a direction for {'zx'[k]}, got zeros; "
                         "give a vector along it")
    return array[:, 0] / lengths[:, :1], array[:, 1] / lengths[:, 1:], array[:, 2]


def _own(drawing: _Drawing, i: int) -> str:
    """What is wrong with a frame by itself and on its joint, or ""."""
    z, x = drawing.z[i], drawing.x[i]
    if i < drawing.reference.n:
        angle = _between_lines(z, drawing.joints[i][:3, 2])
        if angle > FOURTH_DECIMAL:
            return (f"z{i} must lie along the axis of joint {i + 1}, either way: "
                    f"turn it by {degrees(angle):.4g}°.")
        away = drawing.away(i, i)
        if drawing.turns(i) and away > FOURTH_DECIMAL * drawing.size:
            return (f"The origin of frame {i} is {drawing.length(away)} away from the axis of "
                    f"joint {i + 1}: move it onto the axis.")
    tilt = _angle(x, z)
    if abs(tilt - np.pi / 2) > FOURTH_DECIMAL:
        return (f"x{i} and z{i} are {degrees(tilt):.4g}° apart: the axes of a frame are "
                f"perpendicular. Turn x{i} by {abs(90 - degrees(tilt)):.4g}°.")
    return ""


def _settle_on_axis(drawing: _Drawing, i: int) -> None:
    """Lay z exactly along the joint's axis, and the origin upon it where it has a place."""
    z, n = drawing.z, drawing.reference.n
    axis = drawing.joints[i][:3, 2] if i < n else z[n - 1]
    if i < n or _between_lines(z[n], axis) <= FOURTH_DECIMAL:
        z[i] = np.copysign(1, z[i] @ axis) * axis
    for k in [i] if drawing.turns(i) else _near(drawing, i):
        point = drawing.joints[k][:3, 3]
        drawing.origins[i] = point + (drawing.origins[i] - point) @ z[i] * z[i]
        drawing.placed[i] = True


def _near(drawing: _Drawing, i: int) -> list[int]:
    """The turning axis, if any, on which the frame of a parallel slide was meant to sit."""
    found = [k for k, joint in enumerate(drawing.joints) if drawing.turns(k)
             and np.linalg.norm(np.cross(joint[:3, 2], drawing.z[i])) <= PARALLEL
             and drawing.away(i, k) <= FOURTH_DECIMAL * drawing.size]
    return found[:1]


def _towards(drawing: _Drawing, i: int) -> str:
    """How frame i breaks rule 1 or 2 towards the frame before it, or ""."""
    if i == 0:
        return ""
    z0, z, x = drawing.z[i - 1], drawing.z[i], drawing.x[i]
    span, normal = drawing.origins[i] - drawing.origins[i - 1], drawing.normal(i)
    tilt = _angle(x, z0)
    if normal is not None and abs(tilt - np.pi / 2) > FOURTH_DECIMAL:
        return (f"Rule 1: x{i} is not perpendicular to z{i - 1} (they are {degrees(tilt):.4g}° "
                f"apart): turn x{i} by {_turn(x, normal, z):.4g}° about z{i}.")
    miss = np.cross(x, z0)
    if abs(span @ miss) <= FOURTH_DECIMAL * drawing.size:
        return ""
    start = f"Rule 2: x{i} is perpendicular to z{i - 1} but does not meet it: "
    if normal is None:
        return (f"{start}z{i - 1} and z{i} are parallel, so point x{i} straight from one to the "
                f"other. Turn it by {_turn(x, span - span @ z * z, z):.4g}° about z{i}.")
    return f"{start}slide the origin by {drawing.length(-(span @ miss) / (z @ miss))} along z{i}."


def _settle_across(drawing: _Drawing, i: int) -> None:
    """Lay x exactly across both axes, and the origin where x meets the axis before."""
    z, x, normal = drawing.z[i], drawing.x[i], drawing.normal(i) if i else None
    span = drawing.origins[i] - drawing.origins[i - 1] if i else np.zeros(3)
    across = span - span @ z * z
    if normal is not None:
        x = np.copysign(1, x @ normal) * normal
        miss = np.cross(x, drawing.z[i - 1])
        drawing.origins[i] -= (span @ miss) / (z @ miss) * z
    elif drawing.placed[i] and np.linalg.norm(across) > ROUNDING * drawing.size:
        x = np.copysign(1, x @ across) * across
    else:
        x = x - x @ z * z
        if not drawing.placed[i]:
            drawing.origins[i] -= across - across @ x / (x @ x) * x
    drawing.x[i] = x / np.linalg.norm(x)


def _table(drawing: _Drawing) -> Arm:
    poses = [_pose(*frame) for frame in zip(drawing.z, drawing.x, drawing.origins)]
    rows = [row_of(np.linalg.inv(before) @ after) for before, after in pairwise(poses)]
    links, home = [], []
    for link, row in zip(drawing.reference.links, rows):
        home.append(row.pop(str(link.variable)))
        links.append(with_numbers(replace(link, theta=0.0, d=0.0, limits=None, flip=False),
                                  **row))
    reference = drawing.reference
    return Arm(links, name=reference.name, unit=reference.unit, base=poses[0], home=home)


def _pose(z: np.ndarray, x: np.ndarray, origin: np.ndarray) -> np.ndarray:
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = x, np.cross(z, x), z, origin
    return T


def _angle(u: np.ndarray, v: np.ndarray) -> float:
    return float(np.arctan2(np.linalg.norm(np.cross(u, v)), u @ v))


def _turn(x: np.ndarray, wanted: np.ndarray, axis: np.ndarray) -> float:
    """Degrees about an axis from x to the nearer end of another direction across that axis."""
    wanted = np.copysign(1, x @ wanted) * wanted
    return degrees(np.arctan2(axis @ np.cross(x, wanted), x @ wanted))


def _between_lines(u: np.ndarray, v: np.ndarray) -> float:
    """The angle between two lines, whichever way their directions point."""
    return float(np.arctan2(np.linalg.norm(np.cross(u, v)), abs(u @ v)))
