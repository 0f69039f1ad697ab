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


# ---- Slips that classes are likely to make ------------------------------------------------------

def position(q):
    return kl.forward_kinematics(TWO, q)[:2, 3]


def in_place(q, target, steps):
    for _ in range(steps):
        q += np.linalg.solve(kl.jacobian(TWO, q)[:2], target - position(q))
    return q


def all_from_the_start(q, target, steps):
    J, e = kl.jacobian(TWO, q)[:2], target - position(q)
    for _ in range(steps):
        q = q + np.linalg.solve(J, e)
    return q


def error_from_the_start(q, target, steps):
    e = target - position(q)
    for _ in range(steps):
        q = q + np.linalg.solve(kl.jacobian(TWO, q)[:2], e)
    return q


def last_step(q, target, steps):
    for _ in range(steps):
        step = np.linalg.solve(kl.jacobian(TWO, q)[:2], target - position(q))
        q = q + step
    return step


def all_rows(q, target, steps):
    for _ in range(steps):
        e = np.array([*(target - position(q)), 0, 0, 0, 0])
        q = q + np.linalg.pinv(kl.jacobian(TWO, q)) @ e
    return q


def factors_exchanged(J, e, damping):
    return np.linalg.inv(J @ J.T + damping**2 * np.eye(len(J))) @ J.T @ e


def grams_exchanged(J, e, damping):
    return J.T @ np.linalg.inv(J.T @ J + damping**2 * np.eye(J.shape[1])) @ e


def bracket_as_it_is(J, e, damping):
    return J.T @ (J @ J.T + damping**2 * np.eye(len(e))) @ e


ALSO = [
    ("inverse.1", in_place, "Jacobian inverse technique"),
    ("inverse.1", lambda q, target, steps: newton(q, target, steps) + [2 * np.pi, 0],
     "Jacobian inverse technique"),
    ("inverse.1", lambda q, target, steps: newton(q, target, steps)[:, None], "inverse technique"),
    ("inverse.4", BOTH[::-1], "One point, two arms"),
    ("inverse.4", BOTH + [[2 * np.pi, 0], [0, -2 * np.pi]], "One point, two arms"),
    ("inverse.3", [[], (1,), range(2, 5)], "No joint moves the tip along x"),
    ("inverse.5", np.round(np.degrees(PICKED), 1) * np.pi / 180, "The tip is at the part"),
]

WRONG += [
    ("inverse.1", lambda q, target, steps: in_place(q, target, 1), "Only one step"),
    ("inverse.1", all_from_the_start, "J and the error are computed once"),
    ("inverse.1", error_from_the_start, "The error is computed once"),
    ("inverse.1", lambda q, target, steps: newton(q, target, steps + 1), "one step too many"),
    ("inverse.1", lambda q, target, steps: newton(q, target, steps - 1), "one step too few"),
    ("inverse.1", lambda q, target, steps: newton(q, target, 100), "until it arrives"),
    ("inverse.1", lambda q, target, steps: kl.inverse_kinematics(
        TWO, [*target, 0], q, steps=99).q, "until it arrives"),
    ("inverse.1", lambda q, target, steps: q, "It does not move"),
    ("inverse.1", last_step, "last step alone"),
    ("inverse.1", all_rows, "J has six rows"),
    ("inverse.1", loop(lambda J, e: np.linalg.solve(J, e) / 2), "Half a step"),
    ("inverse.1", loop(lambda J, e: np.linalg.inv(J) * e), "work entry by entry"),
    ("inverse.1", lambda q, target, steps: q + np.linalg.inv(kl.jacobian(TWO, q)) @ target,
     "only a square matrix has an inverse"),
    ("inverse.1", lambda q, target, steps: q + kl.jacobian(TWO, q) @ (target - position(q)),
     "do not fit"),
    ("inverse.1", lambda q, target, steps: kl.inverse_kinematics(TWO, [*target, 0], q),
     "Hand over its .q"),
    ("inverse.2", factors_exchanged, "The factors have changed places"),
    ("inverse.2", grams_exchanged, "The factors have changed places"),
    ("inverse.2", bracket_as_it_is, "The bracket is not inverted"),
    ("inverse.2", lambda J, e, damping: J.T @ np.linalg.solve(
        J @ J.T - damping**2 * np.eye(len(e)), e), "subtracted; it is added"),
    ("inverse.2", lambda J, e, damping: J.T * np.linalg.solve(
        J @ J.T + damping**2 * np.eye(len(e)), e), "numbers; your function gave"),
    ("inverse.2", lambda J, e, damping: J.T @ np.linalg.solve(
        J * J.T + damping**2 * np.eye(len(e)), e), "work entry by entry"),
    ("inverse.2", lambda J, e, damping: np.linalg.solve(J + damping * np.eye(len(e)), e),
     "do not fit"),
    ("inverse.3", [set(), {0}, {1, 2, 3}], "Joints count from 1, not from 0"),
    ("inverse.3", [set(), {1}, set()], "three are missing"),
    ("inverse.3", [set(), {1}, {2, 3, 4, 5}], "not joint 5"),
    ("inverse.3", [{2, 3, 4}, {1}, {2, 3, 4}], "perpendicular"),
    ("inverse.3", [set(), {1}, ...], "still to do"),
    ("inverse.4", BOTH.T, "Rows and columns have changed places"),
    ("inverse.4", BOTH[:, ::-1], "theta_1 comes first"),
    ("inverse.4", BOTH * [1, -1], "bends to the wrong side"),
    ("inverse.4", [[TURN - ELBOW, ELBOW], [TURN + ELBOW, -ELBOW]], "half the bend"),
    ("inverse.4", [[TURN - ELBOW / 2, TURN + ELBOW / 2], [TURN + ELBOW / 2, TURN - ELBOW / 2]],
     "counted from link 1"),
    ("inverse.4", [[TURN - ELBOW / 2, np.pi - ELBOW], [TURN + ELBOW / 2, ELBOW - np.pi]],
     "angle between the links"),
    ("inverse.4", [BOTH[0], ...], "still to do"),
    ("inverse.4", kl.inverse_kinematics(TWO, [1.2, 0.9, 0]), "Hand over its .q"),
    ("inverse.5", kl.inverse_kinematics(ALPHA_II, [120, 100, 40]).q, "39.43° away from straight"),
    ("inverse.5", kl.inverse_kinematics(ALPHA_II, PICK), "Hand over its .q"),
    ("inverse.5", kl.inverse_kinematics(
        ALPHA_II, [[1, 0, 0, 100], [0, -1, 0, 120], [0, 0, -1, 40], [0, 0, 0, 1]],
        weights=[1, 1, 1, 1, 1, 0]).q, "x and y have changed places"),
    ("inverse.5", PICKED * [-1, 1, 1, 1, 1], "on the other side"),
    ("inverse.5", PICKED[:4], "you gave four"),
    ("inverse.5", PICKED + [2 * np.pi, 0, 0, 0, 0], "beyond its limits"),
]


