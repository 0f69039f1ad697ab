"""A path: where all joints are, how fast they move and speed up, at every time of a motion."""
from __future__ import annotations

import os
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Protocol

import numpy as np

from ..arms import files, inputs
from ..arms.arm import Arm
from ..arms.joints import given_joints
from ..arms.kinematics import jacobian, tool_poses
from .breaches import Breach, breaches
from .profiles import Profile
from .table import as_csv

RATE, FEWEST, MOST = 60.0, 120, 600  # samples: one for each picture of a screen (per s), and bounds

States = tuple[np.ndarray, np.ndarray, np.ndarray]  # q, rates and accelerations, each (m, n)


class Motion(Protocol):
    """What a path follows."""

    def joints(self, times: np.ndarray) -> np.ndarray: ...
    def states(self, times: np.ndarray) -> States: ...


@inputs.lasting
@dataclass(frozen=True, eq=False, repr=False)
class Path:
    """A motion of an arm in time. Make it with `joint_path` or `straight_path`.

    Attributes
    ----------
    arm : Arm
    profile : str
        "cubic", "quintic" or "trapezoidal".
    duration : float
        Seconds.
    t : array, shape (m,)
        Times of the samples (s), from 0 to the duration. They lie closer where joints turn
        fast, and stand where a rate or an acceleration is largest.
    q, rates, accelerations : array, shape (m, n)
        Joint values (rad or the arm's unit), and their first and second derivative by time. Where
        a derivative has no finite value, because the arm is singular, it is infinite.

    Examples
    --------
    >>> from kinlab import joint_path, robots
    >>> path = joint_path(robots.two_link(), [0, 0], [1, -0.5], duration=2)
    >>> path
    Path of Two-link: 2 s, quintic, keeps within the limits
    >>> path.at(1)
    array([ 0.5 , -0.25])
    """

    arm: Arm
    profile: str
    duration: float
    t: np.ndarray
    q: np.ndarray
    rates: np.ndarray
    accelerations: np.ndarray
    _motion: Motion = field(repr=False)

    def __post_init__(self) -> None:
        for values in (self.t, self.q, self.rates, self.accelerations):
            values.flags.writeable = False

    @cached_property
    def T(self) -> np.ndarray:
        """Pose of the tool in the room at the samples, shape (m, 4, 4)."""
        return tool_poses(self.arm, self.q)

    @property
    def tip(self) -> np.ndarray:
        """The tool point in the room at the samples, shape (m, 3)."""
        return self.T[:, :3, 3]

    @cached_property
    def tip_speed(self) -> np.ndarray:
        """How fast the tool point moves at the samples (unit/s), shape (m,)."""
        finite = np.isfinite(self.rates).all(axis=1)  # elsewhere the tip's way must do
        rates = np.where(finite[:, None], self.rates, 0.0)[..., None]
        velocities = (jacobian(self.arm, self.q)[:, :3] @ rates)[..., 0]
        by_way = np.gradient(self.tip, self.t, axis=0)
        return np.linalg.norm(np.where(finite[:, None], velocities, by_way), axis=-1)

    @cached_property
    def broken(self) -> tuple[Breach, ...]:
        """Where joints leave their limits of position, speed and acceleration, joint by joint."""
        return tuple(breaches(self.arm, self.t, (self.q, self.rates, self.accelerations),
                              self._motion.states))

    def at(self, time: Any) -> np.ndarray:
        """Joint values at any time of the path: as exact as those of the samples.

        Parameters
        ----------
        time : float or array, shape (k,)
            Seconds, from 0 to the duration.

        Returns
        -------
        array, shape (n,) or (k, n)

        Raises
        ------
        ValueError
            If a time lies outside the path.
        """
        times = inputs.real_array("time", time, "a time in seconds, or an array of times")
        if times.ndim > 1 or np.any((times < 0) | (times > self.duration)):
            raise ValueError(f"time: expected seconds from 0 to {self.duration:g}, "
                             f"got {inputs.brief(time)}")
        q = self._motion.joints(np.atleast_1d(times))
        return q if times.ndim else q[0]

    def save_csv(self, path: str | os.PathLike) -> Any:
        """Write the samples as a table: times, joint values, rates, accelerations and the tip.

        Angles are in radians and lengths in the arm's unit, as the headings say. An older file of
        this name is replaced.

        Parameters
        ----------
        path : str or path
            Where to write it; ends in ``.csv``.

        Returns
        -------
        pathlib.Path

        Raises
        ------
        ValueError
            If the name does not end in ``.csv``, or the file cannot be written there.
        """
        target = files.target("path", path, (".csv",), "spreadsheets open a table by its ending")
        text = as_csv(self.arm, self.t, (self.q, self.rates, self.accelerations, self.tip))
        return files.write("path", target, text.encode("utf-8", "replace"))

    def __repr__(self) -> str:
        who = self.arm.name or "an arm"
        kept = "; ".join(map(str, self.broken)) or "keeps within the limits"
        return f"Path of {who}: {self.duration:g} s, {self.profile}, {kept}"


def given_pose(arm: Arm, q: Any, name: str) -> np.ndarray:
    """Joint values at an end of a path, checked, shape (n,)."""
    q = given_joints(arm, q, name)
    if q.ndim != 1:
        raise ValueError(f"{name}: expected one pose, shape ({arm.n},), got {q.shape}; "
                         "give one value per joint")
    return q


def sample_times(duration: float, profile: Profile) -> np.ndarray:
    """Times of a path's samples: so close that straight lines between them look like the curve.

    Between two of N samples a straight line misses a quintic by 0.72 / N^2 of its way at most: by
    0.01 degrees of half a turn, with the fewest.
    """
    count = int(np.clip(np.ceil(RATE * duration), FEWEST, MOST))
    shares = np.linspace(0.0, 1.0, count + 1)
    marks = np.array(profile.marks)
    free = np.abs(shares[:, None] - marks).min(axis=1) > 0.1 / count
    return duration * np.unique(np.concatenate([shares[free], marks]))
