"""Paths: joint values along a straight line and between two poses, against Robotics Toolbox.

PUMA 560 goes from one pose to another in 2 s: by kinlab with rates and accelerations; by the
toolbox, which gives joint values alone along a line, with `ctraj` and its compiled solver from pose
to pose (`ik_LM`), at as many poses. Between joint values the toolbox has `jtraj`. How far the tool
is from the line at most, halfway between samples too, stands beside it.

    python benchmarks/paths.py [rounds]
"""
from __future__ import annotations

import sys
from statistics import median

import numpy as np
from measure import NOT_INSTALLED, goal, header, interleaved, peer, ratio, table

import kinlab as kl

ROUNDS = int(sys.argv[1]) if len(sys.argv) > 1 else 7
Q0, Q1 = np.array([0, 0.8, -0.3, 0.2, 0.9, 0]), np.array([0.7, 1.1, -0.6, -0.3, 0.6, 0.5])
DURATION, LINE_MS = 2.0, 250

rtb = peer("roboticstoolbox")


def arm_of(robot: object) -> kl.Arm:
    """The toolbox's own DH model, as a kinlab arm."""
    return kl.Arm([kl.revolute(theta=link.offset, d=link.d, a=link.a, alpha=link.alpha)
                   for link in robot.links])


def toolbox_line(robot: object, T0: np.ndarray, T1: np.ndarray, count: int) -> np.ndarray:
    """Joint values along the line, each solve from the one before."""
    from spatialmath import SE3

    q, found = Q0, []
    for T in rtb.ctraj(SE3(T0), SE3(T1), count):
        q = robot.ik_LM(T, q0=q, tol=1e-12)[0]
        found.append(q)
    return np.array(found)


def off_line(arm: kl.Arm, q: np.ndarray, T0: np.ndarray, T1: np.ndarray) -> float:
    """How far the tool is from the line between two poses at most, between samples too (m)."""
    between = np.vstack([q, (q[1:] + q[:-1]) / 2])
    way = kl.forward_kinematics(arm, between)[:, :3, 3] - T0[:3, 3]
    along = T1[:3, 3] - T0[:3, 3]
    return float(np.linalg.norm(np.cross(way, along), axis=1).max() / np.linalg.norm(along))


def main() -> None:
    header("Paths in time", "roboticstoolbox-python")
    robot = rtb and rtb.models.DH.Puma560()
    arm = arm_of(robot) if robot else kl.robots.puma_560()
    T0, T1 = (kl.forward_kinematics(arm, q) for q in (Q0, Q1))

    def line() -> kl.Path:
        return kl.straight_path(arm, T0, T1, DURATION, q0=Q0)

    count = len(line().t)
    tasks = {"line, kinlab": line, "joints, kinlab": lambda: kl.joint_path(arm, Q0, Q1, DURATION)}
    if rtb:
        tasks["line, toolbox"] = lambda: toolbox_line(robot, T0, T1, count)
        tasks["joints, toolbox"] = lambda: rtb.jtraj(Q0, Q1, count)
    times = interleaved(tasks, ROUNDS)
    off = {"line, kinlab": off_line(arm, line().q, T0, T1)}
    if rtb:
        off["line, toolbox"] = off_line(arm, toolbox_line(robot, T0, T1, count), T0, T1)
    names = ("line, kinlab", "line, toolbox", "joints, kinlab", "joints, toolbox")
    table(("path", "ms", "off the line (mm)"), [
        (name, f"{1e3 * median(times[name]):.2f}", f"{1e3 * off[name]:.4f}" if name in off else "")
        if name in times else (name, NOT_INSTALLED, "") for name in names])
    if rtb:
        print(f"\nline: kinlab takes {ratio(times['line, kinlab'], times['line, toolbox']):.2f} of "
              f"the toolbox's time, for {count} samples with rates and accelerations")
    goal(f"a line in {LINE_MS} ms", 1e3 * median(times["line, kinlab"]) <= LINE_MS)


if __name__ == "__main__":
    main()
