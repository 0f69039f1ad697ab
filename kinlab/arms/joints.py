"""Joint values: of one pose or of many, checked, and how far each joint goes."""
from __future__ import annotations

import math
from bisect import bisect_left
from typing import Any

import numpy as np

from . import inputs
from .arm import Arm, check_arm
from .link import REVOLUTE

Range = tuple[float, float]
ANY: Range = (-math.inf, math.inf)
WHOLE_TURN: Range = (-math.pi, math.pi)


def joint_array(arm: Arm, q: Any, name: str = "q") -> np.ndarray:
    """Joint values as an array (..., n), or a ValueError that says what was wrong."""
    check_arm(arm)
    who = f"arm '{arm.name}'" if arm.name else "this arm"
    q = inputs.real_array(name, q, f"{arm.n} joint values in radians or {arm.unit}",
                          "for symbols take kl.closed_form(arm) or kl.jacobian_form(arm)")
    if q.shape[-1:] != (arm.n,):
        raise ValueError(f"{name}: expected shape (..., {arm.n}) for {who}, got {q.shape}; "
                         "give one value per joint")
    return q


def given_joints(arm: Arm, q: Any, name: str = "q") -> np.ndarray:
    """Joint values as in `joint_array`, with a word where they look like degrees."""
    q = joint_array(arm, q, name)
    if not inputs.within(q, inputs.TWO_TURNS):  # or a slide in millimetres
        inputs.in_radians(name, q[..., [link.kind == REVOLUTE for link in arm.joints]])
    return q


def one_pose(arm: Arm, q: Any) -> np.ndarray:
    """Joint values of one pose, checked."""
    q = given_joints(arm, q)
    if q.ndim != 1:
        raise ValueError(f"q: expected one pose, shape ({arm.n},), got {q.shape}; "
                         "a view shows one pose at a time")
    return q


def first_pose(arm: Arm, q: Any) -> np.ndarray:
    """Joint values that a view begins with, checked; the arm's home if there are none."""
    return one_pose(arm, arm.home if isinstance(arm, Arm) and q is None else q)


def joints_before(arm: Arm, row: int) -> int:
    """How many joints carry the frame of a row (from 1): the number of the link it sits on."""
    return bisect_left(arm.rows, row)


def joint_limits(arm: Arm, *, turn: Range = ANY, slide: Range = ANY) -> np.ndarray:
    """Lowest and highest value of each joint, shape (2, n).

    `turn` and `slide` stand in for the limits of a joint that has none.
    """
    return np.array([link.limits or (turn if link.kind == REVOLUTE else slide)
                     for link in arm.joints]).T


def joint_ranges(arm: Arm) -> np.ndarray:
    """Limits, or ranges that show what a joint does where the arm states none, shape (2, n)."""
    lengths = sum(abs(link.a) + abs(link.d) for link in arm.links)
    return joint_limits(arm, turn=WHOLE_TURN, slide=(0.0, lengths or 1.0))


def joint_range(arm: Arm, i: int) -> Range:
    """Lowest and highest value of joint i, as in `joint_ranges`."""
    low, high = joint_ranges(arm)[:, i].tolist()
    return low, high
