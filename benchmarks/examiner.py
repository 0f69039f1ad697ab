"""Time per judgement of the examiner: right and wrong tables of the course's arms.

Right answers are the other convention; wrong ones have one twist or one length off. Figures are
processor time of this thread, so that other work on the machine counts less; the median over
many rounds.
"""
from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from statistics import median

from measure import goal, header, progress, table

import kinlab as kl
from kinlab.arms import robots

ARMS = (robots.two_link, robots.exam_2018, robots.alpha_ii, robots.practical_six_link,
        robots.intelledex_660t)
ROUNDS = 200
GOAL_MS = 5


def other_convention(arm: kl.Arm) -> kl.Arm:
    convert = kl.to_modified if arm.convention == "standard" else kl.to_standard
    return convert(arm)


def changed(arm: kl.Arm, number: int, **changes: float) -> kl.Arm:
    """The arm with some numbers of one row made larger."""
    links = list(arm.links)
    old = links[number - 1]
    links[number - 1] = replace(old, **{name: getattr(old, name) + by
                                        for name, by in changes.items()})
    return replace(arm, links=links)


def answers(arm: kl.Arm) -> dict[str, kl.Arm]:
    row = 2 if arm.convention == "modified" else 1
    return {"right, other convention": other_convention(arm),
            "one twist off": changed(arm, row, alpha=0.1),
            "one length off": changed(arm, row, a=0.1),
            "convention mixed up": replace(arm, convention=other_convention(arm).convention)}


def milliseconds(task: Callable) -> float:
    """Median processor time of a call."""
    times = []
    for _ in range(ROUNDS):
        start = time.thread_time()
        task()
        times.append(time.thread_time() - start)
    return 1e3 * median(times)


def main() -> None:
    header("Judging DH tables")
    rows = []
    for make in ARMS:
        arm = make()
        for name, answer in answers(arm).items():
            progress(f"{arm.name}: {name}")
            verdict = kl.same_mechanism(answer, arm)
            rows.append([arm.name, arm.n, name, verdict.word,
                         milliseconds(partial(kl.same_mechanism, answer, arm))])
    progress()
    table(["arm", "joints", "answer", "verdict", "ms"], rows)
    slowest = max(row[-1] for row in rows if row[1] == 6)
    goal(f"a judgement of 6 joints under {GOAL_MS} ms: at most {slowest:.2g} ms",
         slowest < GOAL_MS)


if __name__ == "__main__":
    main()
