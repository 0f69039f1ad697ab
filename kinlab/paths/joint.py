"""Paths in joint space: each joint goes straight from its first value to its last."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arms.arm import Arm
from .path import Path, States, given_pose, sample_times
from .profiles import RAMP, Profile, given_duration, given_profile


@dataclass(frozen=True, eq=False)
class _Straight:
    """From q0 by `way`: all joints start and stop together."""

    q0: np.ndarray
    way: np.ndarray
    duration: float
    profile: Profile

    def joints(self, times: np.ndarray) -> np.ndarray:
        return self.states(times)[0]

    def states(self, times: np.ndarray) -> States:
        s, ds, dds = (part[:, None] for part in self.profile.curve(times / self.duration))
        return (self.q0 + s * self.way, ds / self.duration * self.way,
                dds / self.duration**2 * self.way)


def joint_path(arm: Arm, q0: Any, q1: Any, duration: float, profile: str = "quintic", *,
               ramp: float = RAMP) -> Path:
    """The path on which all joints go from q0 to q1 in step with each other, from rest to rest.

    Parameters
    ----------
    arm : Arm
    q0, q1 : array, shape (n,)
        Joint values (rad or the arm's unit) at the start and at the end.
    duration : float
        Seconds.
    profile : {"cubic", "quintic", "trapezoidal"}
        How the motion spends its time. The rates begin and end at 0; those of "quintic" without
        a jerk. "trapezoidal" speeds up evenly, goes evenly, and slows down evenly.
    ramp : float
        For "trapezoidal": the part of the time in which it speeds up, and again in which it slows
        down; up to 0.5.

    Returns
    -------
    Path
        Its rates and accelerations are exact. Where it leaves a limit, `broken` says so.

    Raises
    ------
    ValueError
        If an argument does not fit the arm.

    Notes
    -----
    Source: Spong, Hutchinson and Vidyasagar, section 5.5; Craig, section 7.3.

    Examples
    --------
    >>> from kinlab import revolute
    >>> arm = Arm([revolute(a=1, speed=1)])
    >>> joint_path(arm, [0], [1], duration=1, profile="cubic").broken[0].text
    'joint 1 is faster than 57.3 deg/s from 0.211 s to 0.789 s'
    """
    start, end = given_pose(arm, q0, "q0"), given_pose(arm, q1, "q1")
    duration, chosen = given_duration(duration), given_profile(profile, ramp)
    motion, t = _Straight(start, end - start, duration, chosen), sample_times(duration, chosen)
    return Path(arm, chosen.name, duration, t, *motion.states(t), motion)
