"""Numerical inverse kinematics: joint values that bring the tool where it is wanted.

A result is called a success only after `forward_kinematics` at the joint values found was held
against the target.
"""
from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from ..arms import inputs
from ..arms.arm import Arm, check_arm
from ..arms.joints import given_joints
from ..arms.kinematics import tool_poses
from . import single
from .attempt import RESTARTS, STEPS, Attempt, Iterate
from .descent import METHODS, search
from .single import Step
from .task import Task, seen_from

BATCH = 4096  # targets worked on at a time: bounds the memory


@dataclass(frozen=True, eq=False)
class InverseResult:
    """What was found for one target.

    Attributes
    ----------
    q : array, shape (n,)
        Joint values; those of the nearest pose found if the target was not reached.
    success : bool
        Whether the tool is at the target, within the tolerance and the limits.
    iterations : int
        Steps taken, those of all starts together.
    position_error, rotation_error : float
        How far the tool is from the target (arm's unit, rad), in the directions that count.
    pose : array, shape (4, 4)
        The tool's pose at `q`.
    history : tuple of Iterate
        Every step of the start that led to `q`.
    message : str
        Reached, or why not. The reason is looked for when the message is first read.
    """

    q: np.ndarray
    success: bool
    iterations: int
    position_error: float
    rotation_error: float
    pose: np.ndarray = field(repr=False)
    _attempt: Attempt = field(repr=False)
    _trail: list[Step] = field(repr=False)

    @cached_property
    def history(self) -> tuple[Iterate, ...]:
        return self._attempt.history(self._trail)

    @cached_property
    def message(self) -> str:
        return self._attempt.messages()[0]


@dataclass(frozen=True, eq=False)
class InverseBatch:
    """What was found for m targets: `InverseResult`'s attributes, one row or entry for each."""

    q: np.ndarray
    success: np.ndarray
    iterations: np.ndarray
    position_error: np.ndarray
    rotation_error: np.ndarray
    _attempts: tuple[Attempt, ...] = field(repr=False)

    @cached_property
    def message(self) -> tuple[str, ...]:
        return tuple(message for attempt in self._attempts for message in attempt.messages())


def inverse_kinematics(arm: Arm, target: Any, q0: Any = None, *, method: str = "damped",
                       weights: Any = None, limits: str = "keep", restarts: int | None = None,
                       seed: int = 0, tolerance: float = 1e-6, steps: int = STEPS
                       ) -> InverseResult:
    """Joint values that bring the tool to a pose, or to a point, found step by step.

    Parameters
    ----------
    arm : Arm
    target : array, shape (4, 4) or (3,)
        Pose of the tool in the room, or the tool point alone.
    q0 : array, shape (n,), optional
        Where to begin; the arm's home if left out.
    method : {"damped", "newton", "pseudoinverse", "transpose"}
        "damped" is Levenberg-Marquardt with damping that follows the error. "newton" inverts
        the Jacobian, and needs as many joints as directions that count.
    weights : six numbers, or three for a point, optional
        How much an error along x, y, z and about x, y, z of the target counts. 0 leaves that
        direction free, as an arm of fewer than six joints needs.
    limits : {"keep", "ignore"}
        Whether joint limits hold. A locked joint stays locked either way.
    restarts : int, optional
        How many random starts may follow `q0`: 30 for "damped", none for the others.
    seed : int
        Of the random starts: the same seed gives the same result.
    tolerance : float
        Largest position error, as a part of the arm's reach, and largest rotation error (rad).
    steps : int
        At most so many from each start; 100 if left out.

    Returns
    -------
    InverseResult

    Raises
    ------
    ValueError
        If an argument does not fit the arm or is not finite.

    Examples
    --------
    >>> from kinlab import forward_kinematics, robots
    >>> arm = robots.intelledex_660t()
    >>> target = forward_kinematics(arm, [0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    >>> inverse_kinematics(arm, target).success
    True
    >>> inverse_kinematics(robots.two_link(), [3, 0, 0]).message
    'out of reach: the target is 3 m from the base, all links end to end are 2 m'
    """
    check_arm(arm)
    poses, count = given_targets("target", target, ())
    task, options = _task(arm, count, weights, limits, tolerance, method, restarts, seed, steps)
    starts = _starts(arm, q0, ())
    found = single.search(task, seen_from(poses), starts.T, **options)
    attempt = Attempt(task, poses, starts, found.q, found.steps, **options)
    position, rotation = attempt.misses[:, 0].tolist()
    return InverseResult(attempt.q[0], bool(attempt.success[0]), int(attempt.iterations[0]),
                         position, rotation, tool_poses(arm, attempt.q[0]), attempt, found.trail)


def inverse_kinematics_batch(arm: Arm, targets: Any, q0: Any = None, *, method: str = "damped",
                             weights: Any = None, limits: str = "keep",
                             restarts: int | None = None, seed: int = 0,
                             tolerance: float = 1e-6, steps: int = STEPS) -> InverseBatch:
    """`inverse_kinematics` for many targets at once, far faster than one by one.

    Parameters
    ----------
    arm : Arm
    targets : array, shape (m, 4, 4) or (m, 3)
        Poses of the tool, or tool points.
    q0 : array, shape (n,) or (m, n), optional
        Where to begin, for all targets or for each; the arm's home if left out.
    method, weights, limits, restarts, seed, tolerance, steps
        As in `inverse_kinematics`.

    Returns
    -------
    InverseBatch

    Examples
    --------
    >>> from kinlab import robots
    >>> inverse_kinematics_batch(robots.two_link(), [[1, 1, 0], [3, 0, 0]]).success
    array([ True, False])
    """
    check_arm(arm)
    poses, count = given_targets("targets", targets, (-1,))
    task, options = _task(arm, count, weights, limits, tolerance, method, restarts, seed, steps)
    starts = _starts(arm, q0, (len(poses),))
    parts = [slice(k, k + BATCH) for k in range(0, max(len(poses), 1), BATCH)]
    found = [search(task, seen_from(poses[part]), starts[part].T, **options) for part in parts]
    attempts = tuple(Attempt(task, poses[part], starts[part], these.q, these.steps, **options)
                     for part, these in zip(parts, found))
    position, rotation = np.concatenate([attempt.misses for attempt in attempts], axis=1)
    return InverseBatch(np.concatenate([attempt.q for attempt in attempts]),
                        np.concatenate([attempt.success for attempt in attempts]),
                        np.concatenate([attempt.iterations for attempt in attempts]),
                        position, rotation, attempts)


def _task(arm: Arm, count: int, weights: Any, limits: str, tolerance: Any, method: str,
          restarts: Any, seed: Any, steps: Any) -> tuple[Task, dict]:
    """The task, and the options of its attempt."""
    inputs.choice("limits", limits, ("keep", "ignore"))
    inputs.choice("method", method, tuple(METHODS))
    task = Task(arm, direction_weights(weights, count),
                inputs.positive("tolerance", tolerance), limits == "keep")
    directions = np.count_nonzero(task.weights)
    if method == "newton" and directions != arm.n:
        raise ValueError(f"method: expected as many joints as directions for 'newton', got {arm.n} "
                         f"and {directions}; take 'damped', or leave directions free by weights")
    if restarts is None:
        restarts = RESTARTS if method == "damped" else 0
    return task, dict(method=method, restarts=inputs.whole("restarts", restarts, 0),
                      seed=inputs.whole("seed", seed, 0), steps=inputs.whole("steps", steps, 1))


def direction_weights(weights: Any, count: int) -> np.ndarray:
    """Six weights, the largest 1; those of rotation are 0 for a point."""
    given = np.ones(count) if weights is None else inputs.shaped(
        "weights", weights, (count,), f"{count} numbers, one per direction")
    if given.min() < 0 or given.max() == 0 or np.any((given > 0) & (given < 1e-6 * given.max())):
        raise ValueError("weights: expected 0, or numbers above 0 within a factor of a million, "
                         f"got {inputs.brief(given.tolist())}")
    return np.concatenate([given / given.max(), np.zeros(6 - count)])


def given_targets(name: str, value: Any, lead: tuple[int, ...]) -> tuple[np.ndarray, int]:
    """Poses (m, 4, 4) and how many directions each has: 6, or 3 for a point."""
    shapes = "a pose (4, 4) or a point (3,)" if not lead else "poses (m, 4, 4) or points (m, 3)"
    array = inputs.real_array(name, value, shapes)
    if array.shape[len(lead):] == (3,) and array.ndim == 1 + len(lead):
        poses = np.tile(np.eye(4), (array.size // 3, 1, 1))
        poses[:, :3, 3] = array
        return poses, 3
    if array.shape[len(lead):] != (4, 4):
        raise ValueError(f"{name}: expected {shapes}, got shape {array.shape}")
    return inputs.rigids(name, array.reshape(-1, 4, 4)), 6


def _starts(arm: Arm, q0: Any, lead: tuple[int, ...]) -> np.ndarray:
    """Joint values to begin at, shape (m, n)."""
    shape = (*lead, arm.n)
    if q0 is None:
        return np.broadcast_to(arm.home, (*(lead or (1,)), arm.n))
    q0 = given_joints(arm, q0, "q0")
    if q0.shape not in (shape, (arm.n,)):
        raise ValueError(f"q0: expected shape {shape}, got {q0.shape}; give one value per joint")
    return np.broadcast_to(q0, (*(lead or (1,)), arm.n))
