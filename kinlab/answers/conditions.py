"""Judges of answers of which many are right: numbers that must meet conditions.

A condition takes the numbers and says what fails and by how much, or "". Those that several
lessons ask of an arm's joint values are here.
"""
from __future__ import annotations

from collections.abc import Callable, Sequence
from math import degrees, pi
from typing import Any

import numpy as np

from ..arms.arm import Arm
from ..arms.joints import joint_array, joint_limits
from ..arms.kinematics import forward_kinematics
from .judges import Judge, Slip, first_of, is_stub
from .verdict import BLANK, CORRECT, NOT_YET, Verdict

Condition = Callable[[np.ndarray], str]
Reader = Callable[[Any], np.ndarray]


def one_of_many(read: Reader, conditions: Sequence[Condition], *, slips: Sequence[Slip] = (),
                noun: str = "joint values", praise: str) -> Judge:
    """Judge of numbers that must meet all conditions.

    Parameters
    ----------
    read : callable
        Makes an array of the answer, or raises a ValueError that says what was wrong.
    conditions : sequence of callables
    slips : sequence of (message, test of the numbers)
        The first one that is true is named once a condition fails.
    noun : str
        What the answer holds.
    praise : str
    """
    def judge(answer: Any) -> Verdict:
        if is_stub(answer):
            return Verdict(BLANK, f"Replace the ... by your {noun}.")
        try:
            q = read(answer)
        except ValueError as error:
            return Verdict(NOT_YET, f"{error}.")
        for condition in conditions:
            if failure := condition(q):
                return Verdict(NOT_YET, " ".join([failure, *first_of(slips, lambda test: test(q))]))
        return Verdict(CORRECT, praise)
    return judge


def meet(conditions: Sequence[Condition], q: np.ndarray) -> bool:
    """Whether numbers meet all conditions."""
    return not any(condition(q) for condition in conditions)


def degrees_slip(conditions: Sequence[Condition] = (), most: float = 2 * pi, *,
                 subject: str = "These numbers",
                 hint: str = "q is in radians, so write np.radians([...])") -> Slip:
    """The slip of angles in degrees.

    Parameters
    ----------
    conditions : sequence of callables
        What the numbers meet once they are taken for degrees, if that can be told.
    most : float
        An angle beyond is none in radians.
    subject, hint : str
        What looks like degrees, and what to do.
    """
    def test(q: np.ndarray) -> bool:
        meant = bool(conditions) and meet(conditions, np.radians(q))
        return meant or bool(np.max(np.abs(q)) > most)
    return f"{subject} look like degrees: {hint}.", test


# ---- What lessons ask of an arm -----------------------------------------------------------


def one_pose(arm: Arm, words: str) -> Reader:
    """A reader of the joint values of one pose; `words` say how many, such as "five"."""
    def read(answer: Any) -> np.ndarray:
        q = joint_array(arm, answer)
        if q.ndim != 1:
            raise ValueError(f"q: expected {words} joint values, got shape {q.shape}")
        return q
    return read


def within_limits(arm: Arm) -> Condition:
    """All joints within their limits."""
    def condition(q: np.ndarray) -> str:
        for i, (value, low, high) in enumerate(zip(q, *joint_limits(arm)), start=1):
            if (excess := max(low - value, value - high)) > 1e-9:
                return (f"Joint {i} is at {degrees(value):.6g}°, {degrees(excess):.4g}° beyond its "
                        f"limits, {degrees(low):.6g}° and {degrees(high):.6g}°.")
        return ""
    return condition


def straight_down(arm: Arm) -> Condition:
    """The tool straight down."""
    def condition(q: np.ndarray) -> str:
        x, y, z = forward_kinematics(arm, q)[:3, 2]
        off = degrees(np.arctan2(np.hypot(x, y), -z))
        return "" if off <= 0.01 else (f"The tool is {off:.4g}° away from straight down; "
                                       "0.01° is allowed.")
    return condition
