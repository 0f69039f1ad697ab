"""Forward kinematics and Jacobians of a PUMA 560: kinlab, Robotics Toolbox, Pinocchio, the floor.

The floor is taking the twelve sines and cosines of each pose, and nothing else.
"""
from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import pi
from statistics import median

import numpy as np
from measure import NOT_INSTALLED, goal, header, interleaved, peer, progress, ratio, table

import kinlab as kl
from kinlab.arms.kinematics import CHUNK

BATCHES = (1, 1_000, 1_000_000)
ROUNDS = {1: 9, 1_000: 9, 1_000_000: 5}
POSE_US, JACOBIAN_US = 25, 30  # goals for a single pose, its arguments checked
FKINE_AT_MOST = 10_000  # poses; a million would take fkine minutes, and per pose it is no faster

ROWS = [dict(d=0.6718299999999999, alpha=pi / 2), dict(a=0.4318),
        dict(d=0.15005, a=0.0203, alpha=-pi / 2), dict(d=0.4318, alpha=pi / 2),
        dict(alpha=-pi / 2), dict()]
PUMA = kl.Arm([kl.revolute(**row) for row in ROWS], name="PUMA 560")

Solver = Callable[[np.ndarray], np.ndarray]


def floor_chunked(q: np.ndarray) -> None:
    """Sines and cosines in the chunks and the memory layout that kinlab uses."""
    for start in range(0, len(q), CHUNK):
        angles = np.ascontiguousarray(q[start:start + CHUNK].T)
        np.cos(angles), np.sin(angles)


def floor_naive(q: np.ndarray) -> None:
    """Sines and cosines of the whole array at once."""
    np.cos(q), np.sin(q)


def kinlab_poses(q: np.ndarray) -> np.ndarray:
    return kl.forward_kinematics(PUMA, q if len(q) > 1 else q[0])


def toolbox() -> dict[str, Solver]:
    """Robotics Toolbox's own PUMA 560, in its two ways that take a batch."""
    rtb = peer("roboticstoolbox")
    if rtb is None:
        return {}
    robot = rtb.models.DH.Puma560()
    motions = robot.ets()
    return {"ETS.eval, stored": motions.eval, "DHRobot.fkine, stored": partial(fkine, robot)}


def fkine(robot: object, q: np.ndarray) -> np.ndarray:
    """DHRobot.fkine makes a list of matrices; here they are gathered into one array."""
    return np.asarray(robot.fkine(q[:FKINE_AT_MOST]).A).reshape(-1, 4, 4)


def pinocchio() -> dict[str, Solver]:
    """Pinocchio, which takes one pose per call: in a Python loop."""
    pin = peer("pinocchio")
    if pin is None:
        return {}
    model = pinocchio_model(pin)
    data = model.createData()
    return {"Pinocchio, called only": partial(pinocchio_loop, pin, model, data),
            "Pinocchio, stored": partial(pinocchio_stored, pin, model, data)}


def pinocchio_model(pin: object) -> object:
    """A turn about z per joint; what is constant in a DH row places the joint after it."""
    model, place = pin.Model(), pin.SE3.Identity()
    for i, row in enumerate(ROWS):
        model.addJoint(i, pin.JointModelRZ(), place, f"joint{i + 1}")
        place = pin.SE3(kl.forward_kinematics(kl.Arm([kl.revolute(**row)]), [0.0]))
    return model  # the last row is all zeros: joint 6 carries the tool frame


def pinocchio_loop(pin: object, model: object, data: object, q: np.ndarray) -> None:
    for row in q:
        pin.forwardKinematics(model, data, row)


def pinocchio_stored(pin: object, model: object, data: object, q: np.ndarray) -> np.ndarray:
    poses = np.empty((len(q), 4, 4))
    for row, pose in zip(q, poses):
        pin.forwardKinematics(model, data, row)
        pose[:] = data.oMi[6].homogeneous
    return poses


def jacobians() -> dict[str, Solver]:
    """The Jacobian of a single pose, rows [v; w] in base axes: kinlab's, and the peers' own."""
    rtb, pin = peer("roboticstoolbox"), peer("pinocchio")
    solvers = {"kinlab": partial(kl.jacobian, PUMA)}
    if rtb is not None:
        solvers["ETS.jacob0"] = rtb.models.DH.Puma560().ets().jacob0
    if pin is not None:
        model = pinocchio_model(pin)
        solvers["Pinocchio"] = partial(pinocchio_jacobian, pin, model, model.createData())
    return solvers


def pinocchio_jacobian(pin: object, model: object, data: object, q: np.ndarray) -> np.ndarray:
    pin.computeJointJacobians(model, data, q)
    return pin.getJointJacobian(model, data, 6, pin.LOCAL_WORLD_ALIGNED)


def measured_jacobians() -> dict[str, list[float]]:
    """Seconds of a single Jacobian, round by round, once all were found to agree."""
    q, solvers = np.random.default_rng(1).uniform(-pi, pi, 6), jacobians()
    ours = solvers["kinlab"](q)
    assert all(np.abs(solve(q) - ours).max() < 1e-9 for solve in solvers.values())
    return interleaved({name: partial(solve, q) for name, solve in solvers.items()}, ROUNDS[1])


def largest_difference(solvers: dict[str, Solver], q: np.ndarray) -> float:
    """Largest entry by which any solver differs from kinlab."""
    ours = kinlab_poses(q)
    return max((np.abs(solve(q) - ours).max() for name, solve in solvers.items()
                if name.endswith("stored")), default=0.0)


def measured(solvers: dict[str, Solver], batch: int) -> dict[str, list[float]]:
    """Seconds per pose of every solver, round by round."""
    q = np.random.default_rng(batch).uniform(-pi, pi, (batch, 6))
    times = interleaved({name: partial(solve, q) for name, solve in solvers.items()},
                        ROUNDS[batch])
    return {name: [t / poses(name, batch) for t in seconds] for name, seconds in times.items()}


def poses(name: str, batch: int) -> int:
    """How many poses a solver was given of a batch."""
    return min(batch, FKINE_AT_MOST) if "fkine" in name else batch


def rows(times: dict[int, dict[str, list[float]]]) -> list[list]:
    """Table rows: microseconds per pose, and how many times kinlab's."""
    return [[name, batch, poses(name, batch), 1e6 * median(t), 1e6 * min(t),
             ratio(t, by_name["kinlab, stored"])]
            for batch, by_name in times.items() for name, t in by_name.items()]


def missing() -> list[list]:
    return [[name, NOT_INSTALLED, "", "", "", ""] for name, module in
            (("Robotics Toolbox", "roboticstoolbox"), ("Pinocchio", "pinocchio"))
            if peer(module) is None]


def show_goals(times: dict[int, dict[str, list[float]]], jacobian: dict[str, list[float]]) -> None:
    largest = times[BATCHES[-1]]
    for kind in ("chunked", "naive"):
        x = ratio(largest["kinlab, stored"], largest[f"floor, {kind}"])
        goal(f"a million poses take at most 3 times the {kind} floor: {x:.2f} times", x <= 3)
    for peer_name in ("ETS.eval, stored", "DHRobot.fkine, stored", "Pinocchio, stored"):
        for batch in BATCHES[1:]:
            t = times[batch].get(peer_name)
            x = ratio(t, times[batch]["kinlab, stored"]) if t else None
            how = f"{x:.1f} times faster" if x else NOT_INSTALLED
            goal(f"ahead of {peer_name.split(',')[0]} per pose, batch of {batch}: {how}",
                 x and x > 1)
    for what, t, most in (("pose", times[1]["kinlab, stored"], POSE_US),
                          ("Jacobian", jacobian["kinlab"], JACOBIAN_US)):
        goal(f"a single {what} in at most {most} us, its arguments checked: {1e6 * min(t):.1f} us",
             1e6 * min(t) <= most)


def main() -> None:
    header("Forward kinematics of a PUMA 560", "roboticstoolbox-python", "pin")
    stored = {"kinlab, stored": kinlab_poses, **toolbox(), **pinocchio()}
    check = np.random.default_rng(0).uniform(-pi, pi, (1_000, 6))
    difference = largest_difference(stored, check)
    assert difference < 1e-9, f"results differ by {difference}: nothing to compare"
    print(f"All that store results agree over 1000 poses, within {difference:.1g}.\n")
    solvers = {"floor, chunked": floor_chunked, "floor, naive": floor_naive, **stored}
    times = {batch: measured(solvers, batch) for batch in BATCHES}
    jacobian = measured_jacobians()
    progress()
    table(["PUMA 560", "batch", "measured on", "median us/pose", "best us/pose",
           "times kinlab"], rows(times) + missing())
    table(["Jacobian of one pose", "median us", "best us", "times kinlab"],
          [[name, 1e6 * median(t), 1e6 * min(t), ratio(t, jacobian["kinlab"])]
           for name, t in jacobian.items()])
    show_goals(times, jacobian)


if __name__ == "__main__":
    main()
