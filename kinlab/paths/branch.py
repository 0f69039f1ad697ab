"""Joint values along a line: each posture from the one before, never from another branch.

The line says how the tool goes on with s, and the Jacobian turns that into dq/ds. A step along it
(Runge and Kutta's) leads to where the joints should be, and inverse kinematics from there puts the
tool on the line. Where the two are far apart the step was too long, and is halved. So a posture
that has another one near it, close to a singular place, is not left for that one.
"""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

import numpy as np

from ..arms.joints import joint_limits
from ..arms.kinematics import tool_poses
from ..arms.route import Place, Vector
from ..ik import single
from ..ik.task import Task
from .line import Line

SINGULAR = 1e-5  # smallest over largest singular value: no step follows dq/ds from there
UNSURE = 1e-13   # weighted error that a posture on the line may have
OFF = 1e-3       # of dq/ds: by so much it may be wrong
RANK = 1e-9      # times the largest singular value: less is zero for any arm like this
CLOSE = 1e-9     # weighted error of a posture that is on the line
TURN = 0.08      # rad between postures: half a pixel of a picture's arm that is drawn straight
AGREED = 0.3     # of the step: how far off its end may have been foreseen
SLACK = 1e-5     # rad that is always allowed
LEAP = 0.2       # rad that may be gone from a place that says nothing of the way on
NUDGE = 0.01     # rad from a place that inverse kinematics does not leave by itself
MOST = 60        # steps of inverse kinematics
HALVES = 30      # times a step is halved


Slope = TypeVar("Slope", np.ndarray, np.ndarray | None)


class Lost(Exception):
    """No posture leads on from that at the part `s` of the line."""

    def __init__(self, s: float) -> None:
        super().__init__(s)
        self.s = s


@dataclass(frozen=True, eq=False)
class Branch:
    """Postures of an arm on a line, its lengths as parts of its own: of a `Core`."""

    task: Task
    line: Line

    @cached_property
    def rank(self) -> int:
        """Directions that the joints master together where nothing is singular: at most so many
        as at random joint values, seen from the tool itself.
        """
        counts = []
        for q in self.task.starts(np.random.default_rng(0), 4).T:
            T = tool_poses(self.task.arm, q)
            place, still = Line.between(T, T).seen(0.0)
            sizes = np.linalg.svd(self.task.pull(place, q.tolist(), still)[0], compute_uv=False)
            counts.append(int(np.sum(sizes > RANK * sizes[0])))
        return max(1, *counts)

    def slopes(self, shares: np.ndarray, joints: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """dq/ds (m, n) at places on the line, and how far each is from a singular one (m,): its
        smallest singular value over its largest. Of many dq/ds it is the shortest.
        """
        slopes, ratios, _ = self._solved(shares, joints)
        return slopes, ratios

    def sure(self, shares: np.ndarray, joints: np.ndarray) -> np.ndarray:
        """Where dq/ds is known (m,). Beside a singular place a posture is known to `UNSURE` over
        the smallest singular value; there dq/ds is known if it is the same so far away.
        """
        slopes, ratios, idle = self._solved(shares, joints)
        moved = self._solved(shares, joints + UNSURE / np.maximum(ratios, RANK)[:, None] * idle)[0]
        off = np.linalg.norm(moved - slopes, axis=1)
        return (ratios > RANK) & (off <= OFF * np.linalg.norm(slopes, axis=1) + UNSURE)

    def _solved(self, shares: np.ndarray, joints: np.ndarray
                ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """dq/ds, the ratios, and the directions of joints that move the tool least."""
        pulls = [self.task.pull(*self._seen(s, q)) for s, q in zip(shares.tolist(), joints)]
        U, sizes, Vt = np.linalg.svd(np.array([J for J, _ in pulls]), full_matrices=False)
        U, sizes, Vt = U[..., :self.rank], sizes[:, :self.rank], Vt[:, :self.rank]
        drift = np.einsum("mkr,mr->mk", Vt, np.array([d for _, d in pulls]))
        least = np.maximum(RANK * sizes[:, :1], 1e-300)
        return (-np.einsum("mnk,mk->mn", U, drift / np.maximum(sizes, least)),
                sizes[:, -1] / np.maximum(sizes[:, 0], 1e-300), U[..., -1])

    def slope(self, s: float, q: np.ndarray, other: Slope) -> Slope:
        """dq/ds at one place, or `other` at a singular one."""
        (slope,), (ratio,) = self.slopes(np.array([s]), q[None])
        return slope if ratio > SINGULAR else other

    def ahead(self, s: float, q: np.ndarray, to: float, slope: np.ndarray) -> np.ndarray:
        """Where the joints should be at `to`, by one step of Runge and Kutta's."""
        h, middle = to - s, (s + to) / 2
        second = self.slope(middle, q + h / 2 * slope, slope)
        third = self.slope(middle, q + h / 2 * second, slope)
        fourth = self.slope(to, q + h * third, slope)
        return q + h / 6 * (slope + 2 * second + 2 * third + fourth)

    def on_line(self, s: float, q: np.ndarray) -> np.ndarray | None:
        """The posture at s that inverse kinematics finds from q; None if there is none near."""
        (axes, origin), _ = self.line.seen(s)
        seen = np.array([*axes, origin])[..., None]
        found = single.search(self.task, seen, q[:, None], method="damped", restarts=0,
                              steps=MOST, seed=0)
        close = min(error for _, error in found.trail) <= CLOSE**2 / 2
        return found.q[:, 0] if close else None

    def nudged(self, s: float, q: np.ndarray, to: float) -> np.ndarray | None:
        """The posture at `to` from a singular one at s, where two ways lead on: the one that keeps
        within the limits, and else the one in which the joint that turns most grows.
        """
        U = np.linalg.svd(self.task.pull(*self._seen(s, q))[0], full_matrices=False)[0]
        idle = U[:, self.rank - 1]
        idle = NUDGE * np.sign(idle[np.abs(idle).argmax()]) * idle
        found = [self.on_line(to, start) for start in (q + idle, q - idle)]
        low, high = joint_limits(self.task.arm)
        return min((q for q in found if q is not None),
                   key=lambda q: bool(np.any((q < low) | (q > high))), default=None)

    def _seen(self, s: float, q: np.ndarray) -> tuple[Place, Vector, np.ndarray]:
        place, twist = self.line.seen(s)
        return place, q.tolist(), twist


@dataclass
class Walk:
    """A branch followed in time: what was passed so far."""

    branch: Branch
    share: Callable[[float], float]  # the part s of the line that is gone at a time
    times: list[float]
    joints: list[np.ndarray]
    slope: np.ndarray | None = None  # dq/ds of the last step

    def on(self, time: float, halved: int = 0) -> None:
        """Go on to a time, by more steps than one where the joints turn far.

        Raises
        ------
        Lost
            If no posture leads on.
        """
        start, q = self.times[-1], self.joints[-1]
        s, to = self.share(start), self.share(time)
        slope = self.branch.slope(s, q, self.slope)
        if self._step(time, s, q, to, slope):
            return
        if halved == HALVES:
            raise Lost(s)
        self.on((start + time) / 2, halved + 1)
        self.on(time, halved + 1)

    def _step(self, time: float, s: float, q: np.ndarray, to: float,
              slope: np.ndarray | None) -> bool:
        """Go on in one step, if it is short enough."""
        foreseen = q if slope is None else self.branch.ahead(s, q, to, slope)
        found = self.branch.on_line(to, foreseen)
        if found is None and slope is None:
            found = self.branch.nudged(s, q, to)
        if found is None:
            return False
        step, off = (float(np.abs(gap).max())
                     for gap in (found - q, found - foreseen))
        longest, agreed = (LEAP, LEAP) if slope is None else (TURN, AGREED * step + SLACK)
        if step > longest or off > agreed:
            return False
        self.times.append(time)
        self.joints.append(found)
        if to > s:
            self.slope = (found - q) / (to - s)
        return True
