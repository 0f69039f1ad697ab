"""Many descents at once: from joint values, step by step, to the pose that is wanted.

Each start is a lane: a place in arrays whose last axis runs over the lanes. Lanes that are done
leave, so that the arrays stay full of work.
"""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .task import Task

CROWD = 512    # lanes that targets share among their restarts when few are left
MOST = 32      # lanes of one target at a time
REVIEW = 5     # a lane that has not halved its error in so many steps leaves its place to another
LEAST, SOFTER, HARDER = 0.1, 0.5, 4.0  # damping, as a multiple of the error
LARGE = 0.3    # an error beyond this is damped no harder
FEW = 12      # lanes: up to here LAPACK is ahead
FLOOR = 1e-12  # keeps the damped equations solvable where the error is zero
SINGULAR = 1e-9  # times the largest singular value: less counts as zero
IDLE = 1e-12     # what moves the tool less, in parts of the reach per radian, does not move it
TINY = np.finfo(float).tiny

Damping = np.ndarray | float  # of each lane
Rule = Callable[[np.ndarray, np.ndarray, Damping], np.ndarray]


@dataclass
class Lanes:
    """Starts under way. Every array's last axis runs over them."""

    owner: np.ndarray       # which target
    seen: np.ndarray        # (4, 3, m): the room seen from the target
    q: np.ndarray           # (n, m)
    best_q: np.ndarray
    best_error: np.ndarray
    error: np.ndarray       # half the squared length of e
    mark: np.ndarray        # the error at the last review
    damping: np.ndarray     # as a multiple of the error
    age: np.ndarray         # steps taken
    still: np.ndarray       # whether the last step moved nothing

    @classmethod
    def begin(cls, owner: np.ndarray, seen: np.ndarray, q: np.ndarray) -> Lanes:
        m = len(owner)
        worst = np.full(m, np.inf)
        return cls(owner, seen, q, q, worst, worst, worst, np.full(m, LEAST),
                   np.zeros_like(owner), np.zeros(m, bool))

    def __len__(self) -> int:
        return len(self.owner)

    def only(self, these: np.ndarray) -> Lanes:
        return Lanes(*(values[..., these] for values in vars(self).values()))

    def beside(self, others: Lanes) -> Lanes:
        return Lanes(*(np.concatenate(pair, axis=-1)
                       for pair in zip(vars(self).values(), vars(others).values())))

    def judge(self, error: np.ndarray) -> None:
        """Damp harder where the error grew, softer where it fell; remember the best."""
        self.damping = np.maximum(self.damping * np.where(error > self.error, HARDER, SOFTER),
                                  LEAST)
        better = error < self.best_error
        self.best_q = np.where(better, self.q, self.best_q)
        self.best_error = np.where(better, error, self.best_error)
        self.error = error

    def review(self) -> np.ndarray:
        """Lanes that have not halved their error since the last review."""
        due = self.age % REVIEW == 0
        slow = due & (self.error > 0.5 * self.mark)
        self.mark = np.where(due, self.error, self.mark)
        return slow

    def step(self, task: Task, rule: Rule, J: np.ndarray, e: np.ndarray) -> None:
        """Move by the rule; joints at a limit that would leave it stay where they are."""
        low, high = task.walls
        outward = np.einsum("ikm,km->im", J, e)
        stuck = (self.q <= low) & (outward > 0) | (self.q >= high) & (outward < 0)
        step = rule(J * ~stuck[:, None], e, self.damping * np.minimum(self.error, LARGE))
        q = task.allowed(self.q + step)
        self.still = np.all(q == self.q, axis=0)
        self.q, self.age = q, self.age + 1


@dataclass
class Search:
    """The best of each target so far, and what may still be tried."""

    task: Task
    seen: np.ndarray        # (4, 3, m): the room seen from each target
    q: np.ndarray           # (n, m)
    restarts: int
    seed: int

    def __post_init__(self) -> None:
        m = self.q.shape[1]
        self.error = np.full(m, np.inf)  # -1 where reached
        self.steps = np.zeros(m, int)    # of all starts together
        self.left = np.full(m, self.restarts)
        self.failed = np.zeros(m, bool)  # by at least one start
        self.rng = np.random.default_rng(self.seed)

    @property
    def reached(self) -> np.ndarray:
        return self.error < 0

    def first(self) -> Lanes:
        return self._begin(np.arange(len(self.error)), self.task.allowed(self.q))

    def again(self) -> Lanes:
        """From the best that was found, for the targets that were not reached."""
        unreached = np.flatnonzero(~self.reached)
        return self._begin(unreached, self.q[:, unreached])

    def fresh(self, lanes: Lanes) -> Lanes:
        """Random starts for targets that have failed: one each, or as many as there is room."""
        waiting = self.failed & ~self.reached & (self.left > 0)
        if not waiting.any():
            return lanes
        busy = np.bincount(lanes.owner, minlength=len(waiting))
        each = np.clip(CROWD // int(waiting.sum()), 1, MOST)
        wanted = np.where(waiting, np.clip(each - busy, 0, self.left), 0)
        owner = np.repeat(np.arange(len(wanted)), wanted)
        if not len(owner):
            return lanes
        self.left = self.left - wanted
        return lanes.beside(self._begin(owner, self._starts(owner)))

    def note(self, ended: Lanes, reached: np.ndarray) -> None:
        """Take in where lanes ended; the best of several for one target is written last."""
        self.failed[ended.owner] = True
        np.add.at(self.steps, ended.owner, ended.age)
        q = np.where(reached, ended.q, ended.best_q)
        error = np.where(reached, -1, ended.best_error)
        order = np.argsort(-error, kind="stable")
        order = order[error[order] < self.error[ended.owner[order]]]
        owner = ended.owner[order]
        self.q[:, owner], self.error[owner] = q[:, order], error[order]

    def _starts(self, owner: np.ndarray) -> np.ndarray:
        """Random starts; a joint that does not count, such as a tool's roll for a point, stays."""
        q = self.task.starts(self.rng, len(owner))
        J, _ = self.task.errors(self.seen[..., owner], q)
        return np.where(np.abs(J).max(axis=1) > IDLE, q, self.q[:, owner])

    def _begin(self, owner: np.ndarray, q: np.ndarray) -> Lanes:
        return Lanes.begin(owner, self.seen[..., owner], q)


def search(task: Task, seen: np.ndarray, q0: np.ndarray, *, method: str, restarts: int,
           steps: int, seed: int) -> Search:
    """Descend from q0, then from random starts, until each target is reached or none is left.

    `seen` has shape (4, 3, m) and `q0` (n, m).
    """
    found, rule = Search(task, seen, q0.copy(), restarts, seed), METHODS[method]
    if restarts:
        descend(found, found.first(), rule, steps)
    lanes = found.again() if restarts else found.first()
    descend(found, lanes, rule, steps, patient=True)
    return found


def descend(found: Search, lanes: Lanes, rule: Rule, steps: int, *, patient: bool = False) -> None:
    """Step all lanes until each has reached its target, is stuck, or has used up its steps.

    The impatient also leave a lane that is slow, to begin anew elsewhere; the patient go on
    to the nearest pose, however slowly it comes.
    """
    while len(lanes):
        J, e = found.task.errors(lanes.seen, lanes.q)
        lanes.judge(0.5 * np.sum(e * e, axis=0))
        reached = found.task.reached(e)
        stop = reached | lanes.still | (lanes.age == steps)
        if not patient:
            stop |= lanes.review()
        if stop.any():
            found.note(lanes.only(stop), reached[stop])
            go = ~stop & ~found.reached[lanes.owner]
            lanes, J, e = lanes.only(go), J[..., go], e[..., go]
        lanes.step(found.task, rule, J, e)
        if stop.any() and not patient:
            lanes = found.fresh(lanes)


def damped(J: np.ndarray, e: np.ndarray, damping: Damping) -> np.ndarray:
    """Levenberg-Marquardt: -(J^T J + damping)^-1 J^T e, with damping that falls with the error.

    After Chan and Lawrence (1988), who take the damping in proportion to the squared error.
    """
    A = np.einsum("ikm,jkm->ijm", J, J)
    diagonal = np.einsum("iim->im", A)
    diagonal += damping + FLOOR * (1 + diagonal.sum(axis=0))
    return -_solve(A, np.einsum("ikm,km->im", J, e))


def newton(J: np.ndarray, e: np.ndarray, _: Damping) -> np.ndarray:
    """-J^-1 e; no step where J has no inverse."""
    inverse_exists = singular_values(J)[:, -1] > SINGULAR * singular_values(J)[:, 0]
    safe = np.where(inverse_exists[:, None, None], _matrices(J), np.eye(len(J)))
    steps = np.linalg.solve(safe, e.T[..., None])[..., 0]
    return -np.where(inverse_exists[:, None], steps, 0).T


def pseudoinverse(J: np.ndarray, e: np.ndarray, _: Damping) -> np.ndarray:
    """-J^+ e, the shortest step among those that come nearest."""
    return -(np.linalg.pinv(_matrices(J), rcond=SINGULAR) @ e.T[..., None])[..., 0].T


def transpose(J: np.ndarray, e: np.ndarray, _: Damping) -> np.ndarray:
    """-c J^T e, with the c that would bring J dq nearest to -e."""
    down = np.einsum("ikm,km->im", J, e)
    moved = np.einsum("ikm,im->km", J, down)
    return -down * np.sum(down * down, axis=0) / np.maximum(np.sum(moved * moved, axis=0), TINY)


METHODS = {"damped": damped, "newton": newton, "pseudoinverse": pseudoinverse,
           "transpose": transpose}


def _matrices(J: np.ndarray) -> np.ndarray:
    """Jacobians (m, rows, n) from lanes (n, rows, m)."""
    return np.transpose(J, (2, 1, 0))


def singular_values(J: np.ndarray) -> np.ndarray:
    """Singular values (m, k) of Jacobians (n, rows, m), the largest first."""
    return np.linalg.svd(_matrices(J), compute_uv=False)


def _solve(A: np.ndarray, g: np.ndarray) -> np.ndarray:
    """A^-1 g for symmetric positive A (n, n, m) and g (n, m); both are used up.

    Elimination over all lanes is faster than LAPACK, one small matrix after the other.
    """
    n, m = g.shape
    if m <= FEW:
        return np.linalg.solve(A.transpose(2, 0, 1), g.T[..., None])[..., 0].T
    for j in range(n - 1):
        factors = A[j + 1:, j] / A[j, j]
        A[j + 1:, j + 1:] -= factors[:, None] * A[None, j, j + 1:]
        g[j + 1:] -= factors * g[j]
    for j in reversed(range(n)):
        g[j] /= A[j, j]
        g[:j] -= A[:j, j] * g[j]
    return g
