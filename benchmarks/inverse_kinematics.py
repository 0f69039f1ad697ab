"""Inverse kinematics: kinlab, one by one and in batch, against Robotics Toolbox's solvers.

The same reachable poses and the same starts for all. What a solver returns is judged by one
check: the DH matrices at its joint values, multiplied out here, within the joint limits.
Robotics Toolbox is called as its documentation does, with default settings: its tolerance
1e-6 bounds half the squared error, so its error may be 1.4e-3 (m and rad); kinlab's is within
1e-6 of the reach and 1e-6 rad. The row "tight" asks Robotics Toolbox for as much. Times are
processor times of one thread; for the batch, the time of all targets shared out among them.

    python benchmarks/inverse_kinematics.py [targets]
"""
from __future__ import annotations

import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import pi
from statistics import median

import numpy as np
from measure import NOT_INSTALLED, goal, header, peer, progress, table

import kinlab as kl

TARGETS = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000
BLOCK = 100          # targets that a solver takes at a stretch, so that its caches are warm
SLOW_AT_MOST = 100   # targets for the solvers that take milliseconds
LOOSE = 1.5e-3       # what the toolbox's default tolerance allows, in m and rad
TIGHT = 0.5 * (1e-6) ** 2
SINGLE_MS = 1  # goal for one solve
OURS, BATCH = "kinlab, one by one", "kinlab, batch"
FAST = ("ik_LM", "ik_NR", "ik_GN")


@dataclass(frozen=True)
class Answer:
    """What one call said."""

    q: np.ndarray
    claimed: bool
    iterations: int
    seconds: float


@dataclass(frozen=True)
class Problem:
    arm: kl.Arm
    targets: np.ndarray
    q0: np.ndarray
    metres: float  # of the arm's unit


def rows_of(robot: object) -> kl.Arm:
    """Robotics Toolbox's own DH model, as a kinlab arm."""
    links = [kl.revolute(theta=link.offset, d=link.d, a=link.a, alpha=link.alpha,
                         limits=tuple(limits)) for link, limits in zip(robot.links, robot.qlim.T)]
    return kl.Arm(links, convention="modified" if robot.mdh else "standard", name=robot.name,
                  tool=rigid(robot.tool.A))


def rigid(T: np.ndarray) -> np.ndarray:
    return None if np.allclose(T, np.eye(4)) else np.array(T)


def course_arm(arm: kl.Arm) -> kl.Arm:
    """With limits of half a turn, which Robotics Toolbox takes where none are given."""
    links = [kl.revolute(theta=link.theta, d=link.d, a=link.a, alpha=link.alpha,
                         limits=link.limits or (-pi, pi)) for link in arm.links]
    return kl.Arm(links, convention=arm.convention, name=arm.name, unit=arm.unit, tool=arm.tool)


def arms(rtb: object) -> list[kl.Arm]:
    course = [course_arm(kl.robots.practical_six_link()), course_arm(kl.robots.intelledex_660t())]
    if rtb is None:
        return course
    models = rtb.models.DH
    return [*map(rows_of, (models.Puma560(), models.Panda(), models.UR5())), *course]


def problem(arm: kl.Arm, seed: int = 0) -> Problem:
    rng = np.random.default_rng(seed)
    low, high = np.array([link.limits for link in arm.links]).T
    q, q0 = rng.uniform(low, high, (2, TARGETS, arm.n))
    return Problem(arm, np.array([pose(arm, row) for row in q]), q0,
                   1e-3 if arm.unit == "mm" else 1.0)


def pose(arm: kl.Arm, q: np.ndarray) -> np.ndarray:
    """DH matrices multiplied out, apart from kinlab's own way."""
    T = arm.base
    for link, value in zip(arm.links, q):
        z, x = screw(2, value + link.theta, link.d), screw(0, link.alpha, link.a)
        T = T @ (z @ x if arm.convention == "standard" else x @ z)
    return T @ arm.tool


def screw(axis: int, angle: float, length: float) -> np.ndarray:
    T, i, j = np.eye(4), (axis + 1) % 3, (axis + 2) % 3
    T[i, i] = T[j, j] = np.cos(angle)
    T[j, i] = np.sin(angle)
    T[i, j], T[axis, 3] = -T[j, i], length
    return T


def toolbox_solvers(rtb: object, case: Problem) -> dict[str, Callable]:
    """Robotics Toolbox on the same arm, in metres: it mixes lengths with radians as they are."""
    ets = rtb.ETS(elementary(rtb, case))
    ets.qlim = np.array([link.limits for link in case.arm.links]).T
    calls = {name: partial(getattr(ets, name)) for name in FAST}
    calls["ik_LM, tight"] = partial(ets.ik_LM, tol=TIGHT)
    calls["ikine_LM"] = partial(ets.ikine_LM, seed=0)
    return {name: partial(toolbox_call, call, case.metres) for name, call in calls.items()}


def elementary(rtb: object, case: Problem) -> list:
    """The arm as Robotics Toolbox's elementary transforms."""
    ET, arm, out = rtb.ET, case.arm, []
    for link in arm.links:
        z = [ET.Rz(link.theta), ET.Rz(qlim=list(link.limits)), ET.tz(link.d * case.metres)]
        x = [ET.tx(link.a * case.metres), ET.Rx(link.alpha)]
        out += z + x if arm.convention == "standard" else x[::-1] + z
    tool = arm.tool.copy()
    tool[:3, 3] *= case.metres
    return [*out, ET.SE3(tool)]


def toolbox_call(call: Callable, metres: float, target: np.ndarray, q0: np.ndarray) -> Answer:
    target = target.copy()
    target[:3, 3] *= metres
    start = time.process_time()
    found = call(target, q0=q0)
    seconds = time.process_time() - start
    return Answer(np.asarray(found.q), bool(found.success), int(found.iterations), seconds)


def one_by_one(case: Problem, target: np.ndarray, q0: np.ndarray) -> Answer:
    start = time.process_time()
    found = kl.inverse_kinematics(case.arm, target, q0, restarts=100)
    seconds = time.process_time() - start
    return Answer(found.q, found.success, found.iterations, seconds)


def in_batch(case: Problem) -> list[Answer]:
    start = time.process_time()
    found = kl.inverse_kinematics_batch(case.arm, case.targets, case.q0, restarts=100)
    each = (time.process_time() - start) / len(case.targets)
    return [Answer(q, bool(ok), int(k), each)
            for q, ok, k in zip(found.q, found.success, found.iterations)]


def is_right(case: Problem, target: np.ndarray, q: np.ndarray, tolerance: float) -> bool:
    """Within the limits, and the tool within the tolerance (m and rad) of the target."""
    low, high = np.array([link.limits for link in case.arm.links]).T
    if not np.all((low - 1e-6 <= q) & (q <= high + 1e-6)):
        return False
    T = pose(case.arm, q)
    spin = T[:3, :3].T @ target[:3, :3]
    angle = np.arctan2(np.linalg.norm(spin - spin.T) / 8 ** 0.5, (np.trace(spin) - 1) / 2)
    offset = np.linalg.norm(T[:3, 3] - target[:3, 3]) * case.metres
    return bool(np.hypot(offset, angle) <= tolerance)


def measured(rtb: object, case: Problem) -> dict[str, list[Answer]]:
    """Answers of every solver, block by block in turn, so that all meet the same moods."""
    solvers = {OURS: partial(one_by_one, case)}
    solvers |= toolbox_solvers(rtb, case) if rtb else {}
    answers, batches = {name: [] for name in solvers}, []
    for first in range(0, len(case.targets), BLOCK):
        progress(f"{case.arm.name}: target {first} of {len(case.targets)}")
        batches.append(in_batch(case))
        block = range(first, min(first + BLOCK, len(case.targets)))
        for name, solve in solvers.items():
            if first < SLOW_AT_MOST or name.startswith("ik_"):
                answers[name] += [solve(case.targets[k], case.q0[k]) for k in block]
    progress()
    typical = sorted(batches, key=lambda batch: batch[0].seconds)[len(batches) // 2]
    return {BATCH: typical, **answers}


def summary(case: Problem, name: str, answers: list[Answer]) -> dict[str, float]:
    tolerance = 1e-5 if "kinlab" in name or "tight" in name else LOOSE
    right = [is_right(case, target, answer.q, tolerance)
             for target, answer in zip(case.targets, answers)]
    solved = sum(a.claimed and ok for a, ok in zip(answers, right))
    return {"of": len(answers), "solved": solved,
            "false": sum(a.claimed and not ok for a, ok in zip(answers, right)),
            "iterations": median(a.iterations for a in answers),
            "median": median(a.seconds for a in answers),
            "per solved": sum(a.seconds for a in answers) / max(solved, 1)}


def show_goals(name: str, figures: dict[str, dict]) -> None:
    batch, peers = figures[BATCH], {k: f for k, f in figures.items() if "kinlab" not in k}
    for ours in (BATCH, OURS):
        goal(f"{name}: no false success, {ours}: {figures[ours]['false']}",
             figures[ours]["false"] == 0)
    single = 1e3 * figures[OURS]["median"]
    goal(f"{name}: one by one in at most {SINGLE_MS} ms: {single:.2f} ms", single <= SINGLE_MS)
    if not peers:
        goal(f"{name}: ahead of Robotics Toolbox: {NOT_INSTALLED}", None)
        return
    compiled = figures["ik_LM, tight"]["median"]
    interpreted = figures["ikine_LM"]["median"]
    goal(f"{name}: one by one ahead of ikine_LM, which is Python too, "
         f"{1e3 * interpreted / single:.1f} times faster; {single / 1e3 / compiled:.0f} times the "
         "compiled ik_LM of the same tolerance", 1e3 * interpreted > single)
    best = max(f["solved"] / f["of"] for f in peers.values())
    rate = batch["solved"] / batch["of"]
    goal(f"{name}: success at least equal to its best: {rate:.1%} to {best:.1%}", rate >= best)
    for kind in ("per solved", "median"):
        fastest = min(peers, key=lambda peer_name: peers[peer_name][kind])
        x = peers[fastest][kind] / batch["per solved"]
        goal(f"{name}: batch time per solved target ahead of {fastest}'s {kind}: {x:.2f} times",
             x > 1)


def main() -> None:
    header(f"Inverse kinematics, {TARGETS} reachable poses", "roboticstoolbox-python")
    rtb = peer("roboticstoolbox")
    figures = {}
    for arm in arms(rtb):
        case = problem(arm)
        figures[arm.name] = {name: summary(case, name, answers)
                             for name, answers in measured(rtb, case).items()}
        table([arm.name, "solved", "of", "false", "iterations", "median us", "us per solved"],
              [[name, f["solved"], f["of"], f["false"], f"{f['iterations']:g}",
                1e6 * f["median"], 1e6 * f["per solved"]]
               for name, f in figures[arm.name].items()])
    for name, found in figures.items():
        show_goals(name, found)


if __name__ == "__main__":
    main()
