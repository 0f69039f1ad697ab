"""One target: descents one after the other, in plain floats.

Each step is that of `descent`, whose arrays would cost a single start ten times the arithmetic.
A test holds the two against each other.
"""
from __future__ import annotations

from dataclasses import dataclass, field
from math import inf, isfinite

import numpy as np

from ..arms.route import Place
from .descent import HARDER, IDLE, LARGE, LEAST, METHODS, REVIEW, SOFTER, Rule
from .task import Task

Step = tuple[list[float], float]  # joint values, and half the squared error there


@dataclass
class Descent:
    """Where a start led, step by step."""

    trail: list[Step] = field(default_factory=list)
    reached: bool = False

    @property
    def best(self) -> Step:
        """The target, or the nearest that the start came to it."""
        return (self.trail[-1][0], -1.0) if self.reached else min(self.trail, key=_error)


@dataclass
class Search:
    """What came of all descents together, as in `descent.Search`, and the way to the best."""

    q: np.ndarray      # (n, 1)
    steps: np.ndarray  # (1,)
    trail: list[Step]


def search(task: Task, seen: np.ndarray, q0: np.ndarray, *, method: str, restarts: int,
           steps: int, seed: int) -> Search:
    """Descend from q0, then from random starts, until the target is reached or none is left.

    `seen` has shape (4, 3, 1) and `q0` (n, 1).
    """
    *axes, origin = seen[..., 0].tolist()
    way = Way(task, METHODS[method], (axes, origin), steps)
    best = way.down(task.kept(q0[:, 0].tolist()), patient=not restarts)
    if restarts and not best.reached:
        best = way.again(best, task.starts(np.random.default_rng(seed), restarts))
    return Search(np.array([best.best[0]]).T, np.array([way.taken]), best.trail)


@dataclass
class Way:
    """To one target, by one rule. `seen` is the room as the target sees it."""

    task: Task
    rule: Rule
    seen: Place
    most: int       # steps from one start
    taken: int = 0  # steps from all starts together

    def again(self, best: Descent, starts: np.ndarray) -> Descent:
        """From random starts (n, m), and where they fail from the best that was found."""
        for q in starts.T:
            run = self.down(self._counting(q, best.best[0]))
            best = min(best, run, key=lambda run: run.best[1])
            if run.reached:
                return run
        last = self.down(best.best[0], patient=True)
        return Descent(best.trail + last.trail, last.reached)

    def down(self, q: list[float], patient: bool = False) -> Descent:
        """From joint values to the target, until nothing moves or the steps are used up.

        The impatient also stop where they are slow, to begin anew elsewhere.
        """
        run, before, mark, damping, still = Descent(), inf, inf, LEAST, False
        for age in range(self.most + 1):
            J, e = self.task.error(self.seen, q)
            error = 0.5 * float(e @ e)
            run.trail.append((q, error))
            run.reached = self.task.is_reached(e)
            if run.reached or still or age == self.most:
                break
            if age % REVIEW == 0:
                if not patient and error > 0.5 * mark:
                    break
                mark = error
            damping = max(damping * (HARDER if error > before else SOFTER), LEAST)
            step = self._step(J, e, q, damping * min(error, LARGE))
            if not isfinite(sum(step)):
                break
            moved = self.task.kept([x + dx for x, dx in zip(q, step)])
            q, before, still = moved, error, moved == q
        self.taken += age
        return run

    def _step(self, J: np.ndarray, e: np.ndarray, q: list[float], damping: float) -> list[float]:
        """By the rule; joints at a limit that would leave it stay where they are."""
        stuck = [(x <= low and out > 0) or (x >= high and out < 0)
                 for x, out, (low, high, _) in zip(q, (J @ e).tolist(), self.task.gates)]
        if any(stuck):
            J = J * ~np.array(stuck)[:, None]
        return self.rule(J[..., None], e[:, None], damping)[:, 0].tolist()

    def _counting(self, q: np.ndarray, stay: list[float]) -> list[float]:
        """A joint that does not count, such as a tool's roll for a point, stays where it was."""
        J, _ = self.task.error(self.seen, q.tolist())
        return np.where(np.abs(J).max(axis=1) > IDLE, q, stay).tolist()


def _error(step: Step) -> float:
    return step[1]
