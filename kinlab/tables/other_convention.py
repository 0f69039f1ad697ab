"""A DH table beside the same numbers in the other convention."""
from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from ..answers.same_mechanism import same_mechanism
from ..arms.arm import CONVENTIONS, Arm, to_modified, to_standard
from ..arms.kinematics import axis_frames, forward_kinematics, link_frames
from ..arms.link import REVOLUTE


@dataclass(frozen=True, eq=False)
class OtherReading:
    """An arm's numbers in the other convention.

    Attributes
    ----------
    numbers : Arm
        The same numbers read in the other convention.
    converted : Arm
        The same arm written in the other convention.
    same : bool
        Whether both readings are the same mechanism.
    moved : list of str
        What stands elsewhere when the numbers are read in the other convention.
    """

    numbers: Arm
    converted: Arm
    same: bool
    moved: list[str]


def other_reading(arm: Arm, q: np.ndarray) -> OtherReading:
    """What the same numbers mean in the other convention, seen at joint values q.

    Examples
    --------
    >>> from kinlab import robots
    >>> reading = other_reading(robots.alpha_ii(), robots.alpha_ii().home)
    >>> reading.same, reading.moved[0]
    (False, 'the axis of joint 1 is turned by 90°')
    """
    other, = set(CONVENTIONS) - {arm.convention}
    numbers = replace(arm, convention=other)
    converted = (to_modified if other == "modified" else to_standard)(arm)
    same = same_mechanism(numbers, arm, tip=False).ok
    return OtherReading(numbers, converted, same, _moved(arm, numbers, q))


def _moved(arm: Arm, other: Arm, q: np.ndarray) -> list[str]:
    here, there = (link_frames(one, q)[axis_frames(one)] for one in (arm, other))
    found = [f"the axis of joint {i} is {how}" for i, how in enumerate(
        (_axis_moved(link.kind, a, b, arm.unit) for link, a, b in zip(arm.links, here, there)), 1)
        if how]
    T, U = forward_kinematics(arm, q), forward_kinematics(other, q)
    apart, turn = float(np.linalg.norm(T[:3, 3] - U[:3, 3])), _turn(T, U)
    how = [f"{apart:.4g} {arm.unit} away"] * (apart > 1e-9) + [f"turned by {turn}"] * bool(turn)
    return found + [f"the tool is {' and '.join(how)}"] * bool(how)


def _axis_moved(kind: str, a: np.ndarray, b: np.ndarray, unit: str) -> str:
    """How a joint's axis, a line if it turns and a direction if it slides, is moved."""
    cross = np.cross(a[:3, 2], b[:3, 2])
    angle = math.degrees(math.atan2(np.linalg.norm(cross), a[:3, 2] @ b[:3, 2]))
    if angle > 1e-6:
        return f"turned by {angle:.4g}°"
    apart = float(np.linalg.norm(np.cross(a[:3, 2], b[:3, 3] - a[:3, 3])))
    return f"shifted by {apart:.4g} {unit}" if kind == REVOLUTE and apart > 1e-9 else ""


def _turn(T: np.ndarray, U: np.ndarray) -> str:
    chord = float(np.linalg.norm(T[:3, :3] - U[:3, :3])) / math.sqrt(8)  # sin of half the angle
    angle = math.degrees(2 * math.asin(min(1.0, chord)))
    return f"{angle:.4g}°" if angle > 1e-6 else ""


def frame_text(T: np.ndarray, unit: str) -> str:
    """Where a base or tool frame stands, in words; "" where it changes nothing.

    Examples
    --------
    >>> frame_text(np.diag([1.0, -1, -1, 1]), "m")
    'turned by 180°'
    """
    point, turn = T[:3, 3], _turn(T, np.eye(4))
    place = ", ".join(f"{value:.6g}" for value in point + 0.0)
    return " and ".join([f"moved by ({place}) {unit}"] * bool(point.any())
                        + [f"turned by {turn}"] * bool(turn))
