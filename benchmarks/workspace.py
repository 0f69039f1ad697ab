"""Workspace of six-joint arms: a million tool points by kinlab and by Robotics Toolbox.

The same joint values for all; Robotics Toolbox in a Python loop (on fewer poses) and in batch.
Memory is the peak of a fresh process that samples a million poses, over one that samples one.

    python benchmarks/workspace.py [samples]
"""
from __future__ import annotations

import resource
import subprocess
import sys
from functools import partial
from math import pi
from statistics import median

import numpy as np
from forward_kinematics import PUMA, toolbox
from measure import NOT_INSTALLED, goal, header, interleaved, peer, progress, ratio, table

import kinlab as kl
from kinlab.arms.workspace import r_sequence

SAMPLES = int(sys.argv[1]) if len(sys.argv) > 1 and sys.argv[1].isdigit() else 1_000_000
LOOP_AT_MOST = 20_000  # poses one call after the other
ROUNDS = 3
GOAL_MB, GOAL_SECONDS = 500, 1.2
OURS = {"PUMA 560": lambda: PUMA, "Intelledex 660T": kl.robots.intelledex_660t}


def values(arm: kl.Arm) -> np.ndarray:
    """The joint values that kinlab sweeps."""
    return pi * (2 * r_sequence(arm.n, 0, SAMPLES, 0).T - 1)


def loop(fkine: object, q: np.ndarray) -> np.ndarray:
    return np.array([fkine(row)[:3, 3] for row in q[:LOOP_AT_MOST]])


def batch(eval_all: object, q: np.ndarray) -> np.ndarray:
    return eval_all(q)[:, :3, 3]


def peers(q: np.ndarray) -> dict[str, object]:
    if peer("roboticstoolbox") is None:
        return {}
    motions = toolbox()["ETS.eval, stored"]
    return {"ETS.eval, batch": partial(batch, motions, q),
            "ETS.eval, loop": partial(loop, motions, q)}


def poses(name: str) -> int:
    return min(LOOP_AT_MOST, SAMPLES) if "loop" in name else SAMPLES


def memory(samples: int) -> float:
    """Peak memory (MB) of a fresh process that samples the Intelledex."""
    run = subprocess.run([sys.executable, __file__, "memory", str(samples)], check=True,
                         capture_output=True, text=True)
    return float(run.stdout)


def show_memory(samples: int) -> None:
    """Run in a fresh process."""
    kl.workspace(kl.robots.intelledex_660t(), samples)
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)


def measured() -> dict[str, list[float]]:
    """Seconds per pose, round by round; the points of all solvers agree."""
    q = values(PUMA)
    solvers = {f"kinlab, {name}": partial(kl.workspace, make(), SAMPLES)
               for name, make in OURS.items()} | peers(q)
    want = kl.workspace(PUMA, SAMPLES).points
    for name, solve in solvers.items():
        if "ETS" in name:
            found = solve()
            assert np.allclose(found, want[:len(found)], atol=1e-9), name
    times = interleaved(solvers, ROUNDS)
    return {name: [t / poses(name) for t in seconds] for name, seconds in times.items()}


def main() -> None:
    header(f"Workspace, {SAMPLES} six-joint poses", "roboticstoolbox-python")
    before, after = memory(1), memory(SAMPLES)  # first: a child starts from its parent's peak
    times = measured()
    ours = times["kinlab, PUMA 560"]
    progress()
    table(["solver", "poses", "median us/pose", "best us/pose", "times kinlab"],
          [[name, poses(name), 1e6 * median(t), 1e6 * min(t), ratio(t, ours)]
           for name, t in times.items()])
    seconds = median(ours) * SAMPLES
    goal(f"{SAMPLES} poses in about a second: {seconds:.2f} s", seconds <= GOAL_SECONDS)
    goal(f"under {GOAL_MB} MB: {after:.0f} MB, of which {before:.0f} MB before sampling",
         after < GOAL_MB)
    for name in ("ETS.eval, batch", "ETS.eval, loop"):
        x = ratio(times[name], ours) if name in times else None
        goal(f"ahead of {name}: {f'{x:.1f} times' if x else NOT_INSTALLED}", x and x > 1)


if __name__ == "__main__":
    show_memory(int(sys.argv[2])) if "memory" in sys.argv else main()
