"""Judges of answers of which many are right: numbers that must meet conditions.

A condition takes the numbers and says what fails and by how much, or "". Those that several
lessons ask of an arm's joint values are here.
"""
from __future__ import annotations

from collections.abc import Callable, Sequence
from math import degrees
from typing import Any

import numpy as np

from ..arms.arm import Arm
from ..arms.inputs import TWO_TURNS
from ..arms.joints import joint_limits
from ..arms.kinematics import forward_kinematics
from .given import numbers, untouched
from .judges import Judge, Slip, first_of
from .verdict import BLANK, CORRECT, NOT_YET, Verdict
from .words import counted, plain, right_but, to_do

Condition = Callable[[np.ndarray], str]
Reader = Callable[[Any], np.ndarray]


def one_of_many(read: Reader, conditions: Sequence[Condition], *, slips: Sequence[Slip] = (),
                noun: str = "joint values", praise: str, parts: Sequence[str] = (),
                each: Sequence[Condition] = ()) -> Judge:
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
    parts : sequence of str
        What the numbers are called, or the rows of numbers.
    each : sequence of callables
        What each part must meet by itself, if that can be told before the others are there.
    """
    def judge(answer: Any) -> Verdict:
        if untouched(answer):
            return Verdict(BLANK, f"Replace the ... by your {noun}.")
        try:
            q = read(answer)
        except ValueError as error:
            return Verdict(NOT_YET, f"{error}.")
        if np.isnan(q).any():
            return _unfinished(q, parts, each)
        for condition in conditions:
            if failure := condition(q.copy()):
                return Verdict(NOT_YET, " ".join([
                    failure, *first_of(slips, lambda test: bool(test(q.copy())))]))
        return Verdict(CORRECT, praise)
    return judge


def _unfinished(q: np.ndarray, parts: Sequence[str], each: Sequence[Condition]) -> Verdict:
    """What there is to say of numbers of which some are still to come."""
    gaps = np.isnan(q.reshape(len(q), -1)).any(axis=1)
    names = parts or [f"number {i + 1}" for i in range(len(q))]
    missing = [name for name, gap in zip(names, gaps) if gap]
    there = [(name, condition) for name, condition, gap in zip(names, each, gaps) if not gap]
    failures = [failure for _, condition in there if (failure := condition(q))]
    if failures or not there:
        return Verdict(NOT_YET, " ".join([*failures, "Besides," if failures else "Your answer:",
                                          f"{to_do(missing)}."]))
    return Verdict(NOT_YET, right_but([name for name, _ in there], missing))


def meet(conditions: Sequence[Condition], q: np.ndarray) -> bool:
    """Whether numbers meet all conditions."""
    return not any(condition(q) for condition in conditions)


def degrees_slip(conditions: Sequence[Condition] = (), most: float = TWO_TURNS, *,
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


def exactly(shape: tuple[int, ...], wanted: str = "") -> Reader:
    """A reader of an array of numbers; `wanted` says in words what it holds."""
    return lambda answer: numbers(answer, shape, wanted=wanted).numbers


def one_pose(arm: Arm) -> Reader:
    """A reader of the joint values of one pose."""
    return exactly((arm.n,), counted(arm.n, "joint value"))


def within_limits(arm: Arm) -> Condition:
    """All joints within their limits."""
    def condition(q: np.ndarray) -> str:
        for i, (value, low, high) in enumerate(zip(q, *joint_limits(arm)), start=1):
            if (excess := max(low - value, value - high)) > 1e-9:
                at, least, most = (plain(degrees(angle)) for angle in (value, low, high))
                return (f"Joint {i} is at {at}°, {degrees(excess):.4g}° beyond its limits, "
                        f"{least}° and {most}°.")
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
