"""Paths in space: the tool goes along a straight line, and the joints follow."""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..arms.arm import Arm, check_arm
from ..arms.kinematics import is_planar
from ..ik.solve import direction_weights, given_targets, inverse_kinematics
from ..ik.task import Task
from .branch import SINGULAR, Branch, Lost, Walk
from .line import Line
from .path import Path, States, sample_times
from .profiles import RAMP, Profile, given_duration, given_profile

TOLERANCE = 1e-13  # of the arm's reach, and rad: what joint values on the line may miss it by
STRIDE = 1e-3      # rad: how far joints are moved along the line to see dq/ds change
AHEAD = 0.05       # of the line
NEAR = 5e-4        # of the duration: the times beside a singular one that say what holds there


@dataclass(frozen=True, eq=False)
class _Along:
    """Joints that follow a line in time. Samples are known; what lies between starts from one."""

    branch: Branch
    duration: float
    profile: Profile
    times: np.ndarray   # (m,)
    joints: np.ndarray  # (m, n)

    def states(self, times: np.ndarray) -> States:
        """Joint values, rates and accelerations."""
        return self.derived(times, np.array([self._posture(time) for time in times.tolist()]))

    def derived(self, times: np.ndarray, q: np.ndarray) -> States:
        """The same, of joint values that are known."""
        rates, accelerations, regular = self._regular(times, q)
        for k in np.flatnonzero(~regular):
            rates[k], accelerations[k] = self._limits(float(times[k]))
        return q, rates, accelerations

    def _regular(self, times: np.ndarray, q: np.ndarray
                 ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Rates and accelerations by the Jacobian, and where they hold.

        The rate is dq/ds s', exactly. d2q/ds2 is how dq/ds changes on a stride along the line, by
        four of its values (an error of the fourth order); a stride is short beside the way to a
        singular place.
        """
        s, ds, dds = self.profile.curve(times / self.duration)
        slopes, ratios = self.branch.slopes(s, q)
        size = np.abs(slopes * self.branch.scale).max(axis=1)
        h = STRIDE * np.minimum(1.0, 10 * ratios + 1e-6) / np.maximum(1.0, size)
        bends = sum(weight * self.branch.slopes(s + k * h, q + (k * h)[:, None] * slopes)[0]
                    for k, weight in ((-2, 1), (-1, -8), (1, 8), (2, -1))) / (12 * h)[:, None]
        rate, acceleration = ds[:, None] / self.duration, dds[:, None] / self.duration**2
        return (slopes * rate, bends * rate**2 + slopes * acceleration,
                ratios > SINGULAR)

    def _posture(self, time: float) -> np.ndarray:
        """Joint values at a time, by a step from the sample before."""
        k = int(np.searchsorted(self.times, time, "right")) - 1
        if self.times[k] == time:
            return self.joints[k]
        ahead = self.share(self.times[k + 1]) - self.share(self.times[k])
        slope = (self.joints[k + 1] - self.joints[k]) / ahead if ahead else None
        walk = Walk(self.branch, self.share, [float(self.times[k])], [self.joints[k]], slope)
        walk.on(time)
        return walk.joints[-1]

    def share(self, time: float) -> float:
        """The part of the line that is gone."""
        return float(self.profile.curve(np.asarray(time / self.duration))[0])

    def _limits(self, time: float) -> tuple[np.ndarray, np.ndarray]:
        """What rates and accelerations come to near a singular place, from the side of the path
        that is longer.
        """
        side = NEAR * self.duration * (1 if time < self.duration / 2 else -1)
        times = time + side * np.array([1, 2, 4])
        rates, accelerations, _ = self._regular(times, np.array([*map(self._posture, times)]))
        return _limit(*rates), _limit(*accelerations)


def _limit(near: np.ndarray, middle: np.ndarray, far: np.ndarray) -> np.ndarray:
    """Where three values go that were read at 1, 2 and 4 steps from a place (Aitken's rule).

    Infinite if they grow without end: by steps that do not become shorter.
    """
    last, before = near - middle, middle - far
    ratio = last / np.where(before == 0, 1, before)
    moves = np.abs(last) > 1e-9 * (1 + np.abs(near))
    grows = moves & (np.abs(ratio) >= 0.999) & (np.abs(near) > np.abs(middle))
    steady = np.where(moves & (np.abs(ratio) < 0.999), ratio, 0)
    return np.where(grows, np.copysign(np.inf, near), near + last * steady / (1 - steady))


def straight_path(arm: Arm, T0: Any, T1: Any, duration: float, profile: str = "quintic",
                  q0: Any = None, *, weights: Any = None, ramp: float = RAMP) -> Path:
    """The path on which the tool goes from T0 to T1 along a straight line, from rest to rest.

    The tool point moves along the line, and the tool turns about one axis that stays. The joints
    follow by inverse kinematics, each posture from the one before: the arm keeps its branch.

    Parameters
    ----------
    arm : Arm
    T0, T1 : array, shape (4, 4) or (3,)
        Poses of the tool in the room, or tool points alone: two of a kind.
    duration : float
        Seconds.
    profile : {"cubic", "quintic", "trapezoidal"}
        How the tool spends its time on the line, as in `joint_path`.
    q0 : array, shape (n,), optional
        Where inverse kinematics begins to look for a posture at T0; the arm's home if left out.
        If it is such a posture, it is the first one.
    weights : six numbers, or three for a point, optional
        As in `inverse_kinematics`: 0 leaves a direction free, as an arm of fewer than six joints
        needs. If left out, all count; of a planar arm x and y and, if it has three joints or
        more, the turn about z.
    ramp : float
        As in `joint_path`.

    Returns
    -------
    Path
        Where it leaves a limit, `broken` says so.

    Raises
    ------
    ValueError
        If an argument does not fit the arm, or the line leaves what the arm reaches.

    Notes
    -----
    The rates solve J dq/dt = (v, w) of the tool, and are exact to rounding; of more joints than
    directions the shortest rates are taken. The accelerations are as exact as 1e-6 of themselves
    and better. Where the Jacobian loses rank, both are read off the path close by.

    Source: Spong, Hutchinson and Vidyasagar, section 5.5; Craig, section 7.4.

    Examples
    --------
    >>> from kinlab import robots
    >>> path = straight_path(robots.two_link(), [1.5, 0.5, 0], [0.5, 1.5, 0], duration=2)
    >>> path.tip[[0, -1]].round(6)
    array([[1.5, 0.5, 0. ],
           [0.5, 1.5, 0. ]])
    """
    check_arm(arm)
    duration, chosen = given_duration(duration), given_profile(profile, ramp)
    (start,), (end,), count = _ends(T0, T1)
    weights = _usual(arm, count) if weights is None else weights
    task = Task(arm, direction_weights(weights, count), TOLERANCE, keep_limits=False)
    branch = Branch(task, Line.between(start, end))
    times = sample_times(duration, chosen)
    along = _Along(branch, duration, chosen, times, np.empty((0, arm.n)))
    walk = Walk(branch, along.share, [0.0], [_first(branch, T0, q0, weights)])
    try:
        for time in times[1:].tolist():
            walk.on(time)
        t, q = np.array(walk.times), np.array(walk.joints)
        motion = replace(along, times=t, joints=q)
        states = motion.derived(t, q)  # beside a singular place it goes on from a posture, too
    except Lost as lost:
        raise ValueError(_refusal(walk, lost, weights, count)) from None
    return Path(arm, chosen.name, duration, t, *states, motion)


def _ends(T0: Any, T1: Any) -> tuple[np.ndarray, np.ndarray, int]:
    """Both ends as poses (1, 4, 4), and how many directions they have: 6, or 3 for points."""
    (start, count), (end, other) = given_targets("T0", T0, ()), given_targets("T1", T1, ())
    if count != other:
        raise ValueError("T0, T1: expected two poses (4, 4) or two points (3,), got one of each; "
                         "take the point of a pose, T[:3, 3]")
    return start, end, count


def _usual(arm: Arm, count: int) -> tuple[float, ...]:
    """The weights of directions, if none are given."""
    if not is_planar(arm):
        return (1.0,) * count
    return (1.0, 1.0, 0.0, 0.0, 0.0, float(arm.n > 2))[:count]


def _first(branch: Branch, T0: Any, q0: Any, weights: Any) -> np.ndarray:
    """The posture at the start of the line: within the limits, if there is one."""
    arm = branch.task.arm
    found = inverse_kinematics(arm, T0, q0, weights=weights)
    if not found.success:
        beyond = inverse_kinematics(arm, T0, q0, weights=weights, limits="ignore")
        if not beyond.success:
            raise ValueError(f"T0: expected a start that the arm reaches, got one that is "
                             f"{found.message}; choose another start")
        found = beyond
    exact = branch.on_line(0.0, found.q)
    return found.q if exact is None else exact


def _refusal(walk: Walk, lost: Lost, weights: Any, count: int) -> str:
    """Why the arm cannot go on: whether it could be at all where it should be a little later."""
    arm, line = walk.branch.task.arm, walk.branch.line
    beyond = line.pose(min(1.0, lost.s + AHEAD))
    place = ", ".join(f"{x:.4g}" for x in line.pose(lost.s)[:3, 3] + 0.0)
    time = np.interp(lost.s, [*map(walk.share, walk.times)], walk.times)
    where = f"at {lost.s:.0%} of its way, after {time:.3g} s, at ({place}) {arm.unit}"
    found = inverse_kinematics(arm, beyond if count == 6 else beyond[:3, 3], walk.joints[-1],
                               weights=weights, limits="ignore")
    if found.success:
        return (f"T0, T1: expected a line that one posture of the arm can follow, got one that "
                f"needs a jump of the joints {where}; begin in another posture by q0=..., or go by "
                "kl.joint_path")
    return (f"T0, T1: expected a line within reach, got one that leaves it {where} "
            f"({found.message}); choose ends whose line stays within reach, or go by "
            "kl.joint_path")
