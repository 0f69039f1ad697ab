"""Answers to the lesson on inverse kinematics: right, typically wrong, and not attempted."""
import numpy as np

import kinlab as kl

TWO, ALPHA_II = kl.robots.two_link(), kl.robots.alpha_ii()
PICK = np.array([[1, 0, 0, 120], [0, -1, 0, 100], [0, 0, -1, 40], [0, 0, 0, 1]])
PICKED = kl.inverse_kinematics(ALPHA_II, PICK, weights=[1, 1, 1, 1, 1, 0]).q


def loop(step, once=False):
    def newton(q, target, steps):
        J = kl.jacobian(TWO, q)[:2]
        for _ in range(steps):
            J = J if once else kl.jacobian(TWO, q)[:2]
            q = q + step(J, target - kl.forward_kinematics(TWO, q)[:2, 3])
        return q
    return newton


newton = loop(lambda J, e: np.linalg.inv(J) @ e)


def damped(J, e, damping):
    return np.linalg.solve(J.T @ J + damping**2 * np.eye(J.shape[1]), J.T @ e)


def other(J, e, damping):
    return np.linalg.inv(J) @ e


ELBOW = np.arccos(0.125)
TURN = np.arctan2(0.9, 1.2)
BOTH = np.array([[TURN - ELBOW / 2, ELBOW], [TURN + ELBOW / 2, -ELBOW]])

RIGHT = {
    "inverse.1": newton,
    "inverse.2": damped,
    "inverse.3": [set(), {1}, {2, 3, 4}],
    "inverse.4": BOTH,
    "inverse.5": PICKED,
}

WRONG = [
    ("inverse.1", loop(lambda J, e: -np.linalg.solve(J, e)), "wrong way round"),
    ("inverse.1", loop(lambda J, e: J.T @ e), "transpose"),
    ("inverse.1", loop(lambda J, e: J @ e), "not its inverse"),
    ("inverse.1", loop(lambda J, e: e @ np.linalg.inv(J)), "wrong side"),
    ("inverse.1", loop(np.linalg.solve, once=True), "afresh"),
    ("inverse.1", lambda q, target, steps: newton(q, target, 1), "one step"),
    ("inverse.1", loop(lambda J, e: np.degrees(np.linalg.solve(J, e))), "degrees"),
    ("inverse.1", lambda q, target, steps: newton(q, target, steps) - q, "sum of the steps"),
    ("inverse.1", lambda q, target: q, "raised TypeError"),
    ("inverse.1", lambda q, target, steps: q[:1], "expected two numbers; your function gave"),
    ("inverse.2", lambda J, e, damping: damped(J, e, damping**0.5), "square"),
    ("inverse.2", lambda J, e, damping: np.linalg.pinv(J) @ e, "pseudoinverse"),
    ("inverse.2", lambda J, e, damping: J.T @ e, "bracket is missing"),
    ("inverse.2", lambda J, e, damping: -damped(J, e, damping), "sign"),
    ("inverse.2", lambda J, e, damping: J.T @ np.linalg.solve(J @ J.T + damping**2, e), "diagonal"),
    ("inverse.2", other, "raised LinAlgError"),
    ("inverse.3", [{1}, {1}, {2, 3, 4}], "perpendicular"),
    ("inverse.3", [set(), {1, 5}, {2, 3, 4}], "not joint 5"),
    ("inverse.3", [set(), {1}, {2, 3}], "one is missing"),
    ("inverse.3", [0, {1}, {2, 3, 4}], "set of joint numbers"),
    ("inverse.4", np.degrees(BOTH), "degrees"),
    ("inverse.4", BOTH[[0, 0]], "same side"),
    ("inverse.4", BOTH[0] * [[1, 1], [1, -1]], "unless joint 1 turns"),
    ("inverse.4", BOTH[0], "two rows"),
    ("inverse.4", BOTH + 0.1, "first joint values the tool misses"),
    ("inverse.5", np.degrees(PICKED), "degrees"),
    ("inverse.5", kl.inverse_kinematics(ALPHA_II, [120, 100, 40]).q, "whole pose"),
    ("inverse.5", PICKED + [0, 0, 0, 0.2, 0], "away from straight down"),
    ("inverse.5", PICKED + [0.3, 0, 0, 0, 0], "mm from the part"),
    ("inverse.5", PICKED + [4, 0, 0, 0, 0], "beyond its limits"),
    ("inverse.5", "down", "plain numbers"),
]

STUBS = [("inverse.1", ...), ("inverse.1", lambda q, target, steps: ...),
         ("inverse.2", lambda J, e, damping: ...), ("inverse.3", [..., ..., ...]),
         ("inverse.4", ...), ("inverse.5", ...)]
