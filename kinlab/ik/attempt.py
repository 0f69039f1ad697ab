"""What came of an attempt: the check by forward kinematics, the reason, the way there."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import degrees

import numpy as np

from ..arms.kinematics import tool_poses
from .descent import search, singular_values
from .single import Step
from .task import Task, rotation_vectors, seen_from

RESTARTS, STEPS = 30, 100  # of the damped method, unless asked otherwise
RANK_TOLERANCE = 1e-6  # times the largest singular value, as in `rank`


@dataclass(frozen=True, eq=False)
class Iterate:
    """Where a descent stood after one of its steps.

    Attributes
    ----------
    q : array, shape (n,)
        Joint values.
    error : float
        Length of position error (as a part of the arm's reach) and rotation error (rad)
        together, weighted: what the methods bring down.
    condition : float
        Largest over smallest singular value of the Jacobian; infinite where it loses rank.
    position_error, rotation_error : float
        How far the tool is from the target (arm's unit, rad), in the directions that count.
    """

    q: np.ndarray
    error: float
    condition: float
    position_error: float
    rotation_error: float


class Attempt:
    """Targets (m, 4, 4) looked for from q0 (m, n), and what came of it.

    `q` (n, m) and `iterations` (m,) are what a search found, and how many steps it took.
    """

    def __init__(self, task: Task, targets: np.ndarray, q0: np.ndarray, q: np.ndarray,
                 iterations: np.ndarray, *, method: str, seed: int, **_: int) -> None:
        self.task, self.targets, self.q0 = task, targets, q0
        self.method, self.seed = method, seed
        self.q, self.iterations = task.settled(q, q0.T).T, iterations
        self.misses = self._misses(self.q, targets)
        position, rotation = self.misses
        self.success = ((position <= task.tolerance * task.length)
                        & (rotation <= task.tolerance))

    def history(self, trail: Sequence[Step]) -> tuple[Iterate, ...]:
        """The steps of the start that led to the first target's result."""
        q = np.array([q for q, _ in trail])
        first = np.zeros(len(trail), int)
        about = (np.sqrt(2 * np.array([error for _, error in trail])),
                 _condition(self._sizes(q.T, first)), *self._misses(q, self.targets[first]))
        return tuple(Iterate(row, *map(float, rest)) for row, *rest in zip(q, *about))

    def messages(self) -> list[str]:
        """For each target: reached, or why not."""
        reasons = np.full(len(self.targets), "", object)
        self._explain(reasons, np.flatnonzero(~self.success))
        return [f"reached in {steps} steps" if ok else reason
                for ok, steps, reason in zip(self.success, self.iterations, reasons)]

    def _misses(self, q: np.ndarray, targets: np.ndarray) -> np.ndarray:
        """Position error (arm's unit) and rotation error (rad) at joint values (m, n): (2, m)."""
        poses = tool_poses(self.task.arm, q)
        R, R_target = poses[:, :3, :3], targets[:, :3, :3]
        offset = np.einsum("mji,mj->im", R_target, poses[:, :3, 3] - targets[:, :3, 3])
        turn = rotation_vectors(np.einsum("mki,mkj->jim", R_target, R))
        counts = self.task.weights[:, None] > 0
        return np.linalg.norm([offset * counts[:3], turn * counts[3:]], axis=1)

    def _explain(self, reasons: np.ndarray, open_: np.ndarray) -> None:
        """Write the reasons of targets not reached: what holds them back is tried in turn."""
        arm, distance = self.task.arm, np.linalg.norm(
            self.targets[:, :3, 3] - self.task.arm.base[:3, 3], axis=1)
        far = distance > self.task.reach * (1 + self.task.tolerance)
        for k in open_[far[open_]]:
            reasons[k] = (f"out of reach: the target is {distance[k]:.4g} {arm.unit} from the "
                          f"base, all links end to end are {self.task.reach:.4g} {arm.unit}")
        open_ = open_[~far[open_]]
        within = self._reachable(self.task, open_)
        for k in open_[within]:
            reasons[k] = self._stopped(k)
        open_ = open_[~within]
        beyond = self._reachable(replace(self.task, keep_limits=False), open_)
        for k, reachable in zip(open_, beyond):
            reasons[k] = (f"out of limits: reached only beyond the joint limits; {self._nearest(k)}"
                          if reachable else f"out of reach: {self._nearest(k)}{self._hint()}")

    def _reachable(self, task: Task, these: np.ndarray) -> np.ndarray:
        """Whether damped steps from many starts reach some of the targets."""
        if not len(these):
            return np.zeros(0, bool)
        found = search(task, seen_from(self.targets[these]), self.q0[these].T, method="damped",
                       restarts=RESTARTS, steps=STEPS, seed=self.seed)
        return found.reached

    def _stopped(self, k: int) -> str:
        """Why this method stopped on the way to a target that another start reaches."""
        ranks = _ranks(self._sizes(np.stack([self.q0[k], self.q[k]], axis=1), np.array([k, k])))
        full = min(self.task.arm.n, np.count_nonzero(self.task.weights))
        if min(ranks) == full:
            return (f"not reached in {self.iterations[k]} steps of '{self.method}'; "
                    f"allow restarts or more steps, or begin elsewhere; {self._nearest(k)}")
        place, r = ("singular start", ranks[0]) if ranks[0] < full else ("singular pose", ranks[1])
        return (f"{place}: the Jacobian has rank {r} there, not {full}, and '{self.method}' "
                f"found no way on; allow restarts, or begin elsewhere; {self._nearest(k)}")

    def _nearest(self, k: int) -> str:
        position, rotation = self.misses[:, k]
        misses = (f"{position:.3g} {self.task.arm.unit}", f"{degrees(rotation):.3g} degrees")
        counted = np.any(np.reshape(self.task.weights, (2, 3)) > 0, axis=1)
        return ("the nearest pose found misses it by "
                + " and ".join(miss for miss, counts in zip(misses, counted) if counts))

    def _hint(self) -> str:
        if self.task.arm.n >= np.count_nonzero(self.task.weights):
            return ""
        return (f"; {self.task.arm.n} joints do not reach every pose, leave a direction free by "
                "weights")

    def _sizes(self, q: np.ndarray, owner: np.ndarray) -> np.ndarray:
        """Singular values (m, k) of the weighted Jacobian at joint values (n, m)."""
        return singular_values(self.task.errors(seen_from(self.targets[owner]), q)[0])


def _ranks(sizes: np.ndarray) -> np.ndarray:
    return np.sum(sizes > RANK_TOLERANCE * sizes[:, :1], axis=1)


def _condition(sizes: np.ndarray) -> np.ndarray:
    lost = sizes[:, -1] <= np.finfo(float).eps * sizes[:, 0]
    return np.where(lost, np.inf, sizes[:, 0] / np.where(lost, 1, sizes[:, -1]))
