"""Paths in space: the tool goes along a straight line, and the joints follow."""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..arms.arm import Arm, check_arm
from ..arms.kinematics import is_planar, tool_poses
from ..ik.solve import InverseResult, direction_weights, given_targets, inverse_kinematics
from ..ik.task import Task
from .along import Along
from .branch import CLOSE, Branch, Lost, Walk
from .breaches import brief
from .core import Core
from .line import Line
from .path import Path, given_pose, sample_times
from .profiles import RAMP, given_duration, given_profile

SAME = 1e-3        # rad, or of the arm's length: so near to a posture q0 is one
TOLERANCE = 1e-13  # of the arm's reach, and rad: what joint values on the line may miss it by
AHEAD = (0.05, 0.01, 0.002)  # of the line: so far on it is asked whether the arm gets there at all


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
        If it is such a posture, it is the first one, beyond limits too.
    weights : six numbers, or three for a point, optional
        As in `inverse_kinematics`: 0 leaves a direction free, as an arm of fewer than six joints
        needs. If left out, all count.
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
    directions the shortest rates are taken, those of slides counted in parts of the arm's reach.
    The accelerations are as exact as 1e-6 of themselves and better. Where the Jacobian loses rank,
    both are read off the path close by.

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
    start, end, count = _ends(T0, T1)
    first = arm.home if q0 is None else given_pose(arm, q0, "q0")
    core = Core.of(arm, np.array([start, end]))
    if weights is None and is_planar(core.arm):
        _in_plane(core, T0=start, T1=end)
    task = Task(core.arm, direction_weights(weights, count), TOLERANCE, keep_limits=False)
    branch = Branch(task, Line.between(core.pose(start), core.pose(end)))
    tried = _Tried(arm, core, Line.between(start, end), count, weights,
                   duration)
    times = sample_times(duration, chosen)
    along = Along(core, branch, duration, chosen, times, np.empty((0, core.arm.n)))
    walk = Walk(branch, along.share, [0.0], [_first(branch, core.within(first), tried)])
    try:
        for time in times[1:].tolist():
            walk.on(time)
        motion = replace(along, times=np.array(walk.times), values=np.array(walk.joints))
        states = motion.samples()
    except Lost as lost:
        raise ValueError(_refusal(walk, lost, tried)) from None
    return Path(arm, chosen.name, duration, motion.times, *states, motion)


def _ends(T0: Any, T1: Any) -> tuple[np.ndarray, np.ndarray, int]:
    """Both ends as poses (4, 4), and how many directions they have: 6, or 3 for points."""
    ((start,), count), ((end,), other) = given_targets("T0", T0, ()), given_targets("T1", T1, ())
    if count != other:
        raise ValueError("T0, T1: expected two poses (4, 4) or two points (3,), got one of each; "
                         "take the point of a pose, T[:3, 3]")
    return start, end, count


def _in_plane(core: Core, **ends: np.ndarray) -> None:
    """A word about an end that lies above or below the plane in which an arm moves."""
    z = core.length * tool_poses(core.arm, core.arm.home)[2, 3]
    for name, T in ends.items():
        if abs(T[2, 3] - z) > CLOSE * core.length:
            raise ValueError(f"{name}: expected a place in the plane in which this arm moves, z = "
                             f"{z + 0.0:.6g}, got z = {T[2, 3]:.6g}; write z = {z + 0.0:.6g}, or "
                             "leave z free by weights")


@dataclass(frozen=True, eq=False)
class _Tried:
    """What inverse kinematics says of single places of a line."""

    arm: Arm
    core: Core
    line: Line   # in the room
    count: int   # of directions
    weights: Any
    duration: float

    def at(self, s: float, q: np.ndarray, limits: str) -> InverseResult:
        """What is found from values of the core's joints."""
        return self._of(self.core.arm, self.core.pose(self.line.pose(s)), q, limits, CLOSE)

    def why_not(self, s: float, q: np.ndarray) -> str:
        """Why nothing is found there, in the arm's unit."""
        (joints,) = self.core.joints(q[None])
        found = self._of(self.arm, self.line.pose(s), joints, "ignore", CLOSE)
        return "out of reach" if found.success else found.message

    def _of(self, arm: Arm, T: np.ndarray, q: np.ndarray, limits: str, tolerance: float
            ) -> InverseResult:
        return inverse_kinematics(arm, T if self.count == 6 else T[:3, 3], q, limits=limits,
                                  weights=self.weights, tolerance=tolerance)


def _first(branch: Branch, q0: np.ndarray, tried: _Tried) -> np.ndarray:
    """The posture at the start of the line: q0 if it is one, or else one within the limits."""
    own = branch.on_line(0.0, q0)
    if own is not None and np.abs(own - q0).max() <= SAME:
        return own
    for limits in ("keep", "ignore"):
        found = tried.at(0.0, q0, limits)
        if found.success:
            exact = branch.on_line(0.0, found.q)
            return found.q if exact is None else exact
    raise ValueError(f"T0: expected a start that the arm reaches, got one that is "
                     f"{tried.why_not(0.0, q0)}; choose another start")


def _refusal(walk: Walk, lost: Lost, tried: _Tried) -> str:
    """Why the arm cannot go on: whether it could be at all where it should be a little later."""
    size, q = tried.core.length, walk.joints[-1]
    place = ", ".join(brief(x, size, 4) for x in tried.line.pose(lost.s)[:3, 3].tolist())
    time = float(np.interp(lost.s, [*map(walk.share, walk.times)], walk.times))
    where = (f"at {lost.s:.0%} of its way, after {brief(time, tried.duration)} s, "
             f"at ({place}) {tried.arm.unit}")
    beyond = next((s for s in (min(1.0, lost.s + part) for part in AHEAD)
                   if not tried.at(s, q, "ignore").success), None)
    if beyond is None:
        return (f"T0, T1: expected a line that one posture of the arm can follow, got one that "
                f"needs a jump of the joints {where}; begin in another posture by q0=..., or go by "
                "kl.joint_path")
    poses = tried.count == 6 and tried.core.arm.n < 6
    advice = "hand over the tool points alone, T[:3, 3]," if poses else (
        "choose ends whose line stays within reach,")
    return (f"T0, T1: expected a line within reach, got one that leaves it {where} "
            f"({tried.why_not(beyond, q)}); {advice} or go by kl.joint_path")
