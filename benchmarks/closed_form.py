"""Closed forms of three arms: kinlab, sympy.trigsimp of the product, Robotics Toolbox.

Then Jacobians in closed form, also of six joints with odd twists, whose entries are long.

Every figure is the best of three fresh processes with their libraries loaded: the first call is
cold, those after it are warm. A process that takes longer than TIMEOUT is stopped and said so.
"""
from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable
from math import prod
from pathlib import Path
from statistics import median

import numpy as np
import sympy as sp
from measure import NOT_INSTALLED, goal, header, peer, progress, table

import kinlab as kl
from kinlab.arms import robots
from kinlab.arms.arm import CONVENTIONS
from kinlab.arms.symbolic import exact_angle, exact_length

ARMS = ("alpha_ii", "practical_six_link", "intelledex_660t")
ROUNDS = 3
TIMEOUT = 180  # seconds
GOAL_MS, GOAL_RATIO = 20, 100
GOAL_JACOBIAN = 10  # seconds, with text and LaTeX


def kinlab_matrix(arm: kl.Arm) -> sp.Matrix:
    return kl.closed_form(arm).matrix


def kinlab_written(arm: kl.Arm) -> sp.Matrix:
    """The matrix, and its text and LaTeX."""
    form = kl.closed_form(arm)
    assert form.text and form.latex
    return form.matrix


def kinlab_jacobian(arm: kl.Arm) -> sp.Matrix:
    """The Jacobian, and its text and LaTeX."""
    form = kl.jacobian_form(arm)
    assert form.text and form.latex
    return form.matrix


def six_odd_twists() -> kl.Arm:
    """Six joints with twists of 40 degrees."""
    return kl.Arm([kl.revolute(d=0.1, a=0.1, alpha=np.radians(40)) for _ in range(6)])


def trigsimp(arm: kl.Arm) -> sp.Matrix:
    """The product of the DH matrices, exact constants in them, simplified entry by entry."""
    links = (link_matrix(arm, row, q) for row, q in zip(arm.links, joints(arm)))
    return prod(links, start=sp.eye(4)).multiply(exact(arm.tool)).applyfunc(sp.trigsimp)


def toolbox(arm: kl.Arm) -> sp.Matrix:
    """Robotics Toolbox: symbolic fkine, then simplify()."""
    rtb, spatialmath = peer("roboticstoolbox"), peer("spatialmath")
    kind = rtb.RevoluteDH if arm.convention == "standard" else rtb.RevoluteMDH
    links = [kind(d=row.d, a=row.a, alpha=exact_angle(row.alpha)) for row in arm.links]
    robot = rtb.DHRobot(links, symbolic=True, tool=spatialmath.SE3(arm.tool))
    return sp.Matrix(robot.fkine(list(joints(arm))).simplify().A)


Solver = Callable[[kl.Arm], sp.Matrix]
SOLVERS: dict[str, tuple[Solver, int]] = {  # the solver and how many warm calls
    "kinlab, matrix": (kinlab_matrix, 20),
    "kinlab, matrix + text + LaTeX": (kinlab_written, 20),
    "sympy.trigsimp": (trigsimp, 1),
    "Robotics Toolbox simplify()": (toolbox, 1),
}
OURS, WRITTEN, *PEERS = SOLVERS
JACOBIAN = "kinlab, Jacobian + text + LaTeX"
WORK = SOLVERS | {JACOBIAN: (kinlab_jacobian, 1)}
NEEDS = {"Robotics Toolbox simplify()": "roboticstoolbox"}


def joints(arm: kl.Arm) -> tuple[sp.Symbol, ...]:
    return sp.symbols(f"theta_1:{arm.n + 1}")


def link_matrix(arm: kl.Arm, row: kl.arms.arm.Link, q: sp.Symbol) -> sp.Matrix:
    """The product of the four elementary matrices of a DH row."""
    values = dict(theta=q + exact_angle(row.theta), d=exact_length(row.d),
                  a=exact_length(row.a), alpha=exact_angle(row.alpha))
    return prod((elementary(kind, axis, values[parameter])
                 for kind, axis, parameter in CONVENTIONS[arm.convention]), start=sp.eye(4))


def elementary(kind: str, axis: int, amount: sp.Expr) -> sp.Matrix:
    """The 4x4 matrix of one rotation about, or slide along, an axis."""
    matrix = sp.eye(4)
    if kind == "translate":
        matrix[axis, 3] = amount
        return matrix
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix[i, i] = matrix[j, j] = sp.cos(amount)
    matrix[i, j], matrix[j, i] = -sp.sin(amount), sp.sin(amount)
    return matrix


def exact(T: np.ndarray) -> sp.Matrix:
    return sp.Matrix(4, 4, [exact_length(entry) for entry in T.flat])


def difference(arm: kl.Arm, matrix: sp.Matrix) -> float:
    """Largest difference from the numbers at random points, in the arm's unit."""
    q = np.random.default_rng(1).uniform(-np.pi, np.pi, (50, arm.n))
    poses = (kl.forward_kinematics if matrix.rows == 4 else kl.jacobian)(arm, q)
    function = sp.lambdify(joints(arm), matrix, "numpy", cse=True)
    return max(np.abs(function(*row) - T).max() for row, T in zip(q, poses))


def work(solver: str, arm_name: str) -> None:
    """Run in a fresh process: time one solver on one arm, print the figures as JSON."""
    solve, warm_calls = WORK[solver]
    arm = six_odd_twists() if arm_name == six_odd_twists.__name__ else getattr(robots, arm_name)()
    kl.closed_form, peer(NEEDS.get(solver, "sympy"))  # loading is not timed
    times = []
    for _ in range(1 + warm_calls):
        start = time.perf_counter()
        matrix = solve(arm)
        times.append(time.perf_counter() - start)
    print(json.dumps({"cold": times[0], "warm": median(times[1:]),
                      "difference": difference(arm, matrix)}))


def run(solver: str, arm_name: str) -> dict[str, float] | str:
    """The figures of a fresh process, or a word on why there are none."""
    if solver in NEEDS and peer(NEEDS[solver]) is None:
        return NOT_INSTALLED
    command = [sys.executable, str(Path(__file__)), solver, arm_name]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=TIMEOUT)
    except subprocess.TimeoutExpired:
        return f"over {TIMEOUT} s"
    return json.loads(done.stdout.splitlines()[-1])


def measured(arm_name: str) -> dict[str, list]:
    """Figures of every solver, interleaved; one that has none is not run again."""
    figures = {solver: [] for solver in SOLVERS}
    for turn in range(1, ROUNDS + 1):
        for solver, found in figures.items():
            if not any(isinstance(figure, str) for figure in found):
                progress(f"{arm_name}, round {turn} of {ROUNDS}: {solver}")
                found.append(run(solver, arm_name))
    progress()
    return {solver: found[-1] if isinstance(found[-1], str) else best(found)
            for solver, found in figures.items()}


def best(figures: list[dict[str, float]]) -> dict[str, float]:
    """The best times of several processes, and the largest difference."""
    return {"cold": min(f["cold"] for f in figures), "warm": min(f["warm"] for f in figures),
            "difference": max(f["difference"] for f in figures)}


def rows(arm_name: str, figures: dict[str, dict | str]) -> list[list]:
    ours = figures[OURS]
    return [[arm_name, solver, figure, "", "", ""] if isinstance(figure, str) else
            [arm_name, solver, 1e3 * figure["cold"], 1e3 * figure["warm"],
             figure["warm"] / ours["warm"], figure["difference"]]
            for solver, figure in figures.items()]


def show_goals(arm_name: str, figures: dict[str, dict | str]) -> None:
    for solver in (OURS, WRITTEN):
        ms = 1e3 * figures[solver]["warm"]
        goal(f"{arm_name}: {solver} under {GOAL_MS} ms warm: {ms:.2g} ms", ms < GOAL_MS)
    for solver in PEERS:
        figure = figures[solver]
        if figure == NOT_INSTALLED:
            goal(f"{arm_name}: {GOAL_RATIO} times faster than {solver}: {figure}", None)
            continue
        stopped = isinstance(figure, str)
        slowest = TIMEOUT if stopped else figure["warm"]
        times = [slowest / figures[ours]["warm"] for ours in (OURS, WRITTEN)]
        goal(f"{arm_name}: {GOAL_RATIO} times faster than {solver}: {'over ' * stopped}"
             f"{times[0]:.0f} times, with text and LaTeX {times[1]:.0f} times",
             min(times) >= GOAL_RATIO)
    equal = max(f["difference"] for f in figures.values() if isinstance(f, dict))
    goal(f"{arm_name}: all entries equal at 50 random points: within {equal:.1g}", equal < 1e-9)


def main() -> None:
    header("Closed forms", "sympy", "roboticstoolbox-python")
    figures = {arm_name: measured(arm_name) for arm_name in ARMS}
    table(["arm", "solver", "cold ms", "warm ms", "times kinlab", "largest difference"],
          [row for arm_name in ARMS for row in rows(arm_name, figures[arm_name])])
    for arm_name in ARMS:
        show_goals(arm_name, figures[arm_name])
    for arm_name in (*ARMS, six_odd_twists.__name__):
        show_jacobian(arm_name)


def show_jacobian(arm_name: str) -> None:
    figure = run(JACOBIAN, arm_name)
    if isinstance(figure, str):
        return goal(f"{arm_name}: {JACOBIAN}: {figure}", False)
    goal(f"{arm_name}: {JACOBIAN} under {GOAL_JACOBIAN} s, cold: {figure['cold']:.2g} s, equal to "
         f"the numbers within {figure['difference']:.1g}",
         figure["cold"] < GOAL_JACOBIAN and figure["difference"] < 1e-9)


if __name__ == "__main__":
    work(*sys.argv[1:]) if len(sys.argv) > 1 else main()
