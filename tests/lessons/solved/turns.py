"""Answers to the exercises on turns in space: right, typically wrong, and not attempted."""
from math import atan2, cos, degrees, hypot, pi, radians, sin

import numpy as np
from textbook import turn

import kinlab as kl

ROUND = np.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
LOCKED = np.array([[0, -0.6, 0.8], [0, 0.8, 0.6], [-1, 0, 0]])
X, _, Z = np.eye(3)
DIAGONAL = np.ones(3) / 3**0.5
LEFT = atan2(0.6, 0.8)  # yaw - roll where the gimbal is locked


def mixed(alpha, beta, gamma):
    return turn(X, beta) @ turn(Z, alpha) @ turn(Z, gamma)


def rpy(R):
    return [atan2(R[2, 1], R[2, 2]), atan2(-R[2, 0], hypot(R[0, 0], R[1, 0])),
            atan2(R[1, 0], R[0, 0])]


def changed(k, angle):
    """The right angles, but for one."""
    def other(R):
        angles = rpy(R)
        angles[k] = angle(R)
        return angles
    return other


def quaternion(axis, angle):
    axis = np.array(axis) / np.linalg.norm(axis)
    return [cos(angle / 2), *sin(angle / 2) * axis]


def other_branch(R):
    roll, pitch, yaw = rpy(R)
    return [roll - pi, pi - pitch, yaw + pi]


RIGHT = {
    "turns.1": mixed,
    "turns.2": rpy,
    "turns.3": [DIAGONAL, pi / 3],
    "turns.4": quaternion,
    "turns.5": [0, pi / 2, LEFT],
}

# (exercise, answer, words of the praise)
ALSO = [
    ("turns.1", lambda a, b, c: turn(X, b) @ turn(Z, a + c), "to the left"),
    ("turns.2", other_branch, "in its quadrant"),
    ("turns.2", lambda R: np.array(rpy(R)) + 2 * pi, "in its quadrant"),
    ("turns.2", lambda R: [*rpy(R)[:1], np.arcsin(-R[2, 0]), *rpy(R)[2:]], "in its quadrant"),
    ("turns.3", [-DIAGONAL, -pi / 3], "keeps this axis"),
    ("turns.3", (DIAGONAL.tolist(), pi / 3 - 2 * pi), "keeps this axis"),
    ("turns.3", [-DIAGONAL, 5 * pi / 3], "keeps this axis"),
    ("turns.3", [[0.57735, 0.57735, 0.57735], 1.0472], "keeps this axis"),
    ("turns.4", lambda axis, angle: np.negative(quaternion(axis, angle)), "the same turn"),
    ("turns.4", lambda axis, angle: quaternion(np.negative(axis), -angle), "the same turn"),
    ("turns.4", lambda axis, angle: quaternion(axis, angle + 2 * pi), "the same turn"),
    ("turns.5", [-LEFT, pi / 2, 0], "infinitely many"),
    ("turns.5", [1, pi / 2, 1 + LEFT], "infinitely many"),
    ("turns.5", [1 + pi, pi / 2, 1 + LEFT - pi], "infinitely many"),
    ("turns.5", [0, 1.5708, 0.6435], "infinitely many"),
]

# (exercise, answer, words of the message)
WRONG = [
    ("turns.1", lambda a, b, c: turn(Z, a) @ turn(X, b) @ turn(Z, c), "where own axes stand"),
    ("turns.1", lambda a, b, c: turn(Z, c) @ turn(X, b) @ turn(Z, a), "about the camera's own z"),
    ("turns.1", lambda a, b, c: turn(Z, c) @ turn(Z, a) @ turn(X, b), "Left and right"),
    ("turns.1", lambda *q: mixed(*q).T, "This is the transpose"),
    ("turns.1", lambda *q: mixed(*np.radians(q)), "in radians; do not convert"),
    ("turns.1", lambda *q: mixed(*np.degrees(q)), "in radians already"),
    ("turns.1", lambda a, b, c: turn(X, b) @ turn(Z, a), "The last turn is missing"),
    ("turns.1", lambda a, b, c: turn(X, b) * turn(Z, a) * turn(Z, c), "entry by entry"),
    ("turns.2", changed(0, lambda R: atan2(R[2, 2], R[2, 1])), "Roll takes y first"),
    ("turns.2", changed(2, lambda R: atan2(R[0, 0], R[1, 0])), "Yaw takes y first"),
    ("turns.2", lambda R: [atan2(R[2, 2], R[2, 1]), atan2(hypot(R[0, 0], R[1, 0]), -R[2, 0]),
                           atan2(R[0, 0], R[1, 0])], "np.arctan2 takes y first"),
    ("turns.2", changed(1, lambda R: atan2(R[2, 0], hypot(R[0, 0], R[1, 0]))), "sign of pitch"),
    ("turns.2", lambda R: rpy(R.T), "angles of the transpose"),
    ("turns.2", lambda R: rpy(R)[::-1], "The order is roll, pitch, yaw"),
    ("turns.2", lambda R: [degrees(angle) for angle in rpy(R)], "leave np.degrees out"),
    ("turns.2", lambda R: [np.arctan(R[2, 1] / R[2, 2]), rpy(R)[1], np.arctan(R[1, 0] / R[0, 0])],
     "opposite quadrants"),
    ("turns.2", changed(0, lambda R: np.arctan(R[2, 1] / R[2, 2])), "np.arctan2 for roll"),
    ("turns.2", changed(2, lambda R: np.arctan(R[1, 0] / R[0, 0])), "np.arctan2 for yaw"),
    ("turns.2", lambda R: rpy(R)[:2], "expected three numbers"),
    ("turns.2", lambda R: kl.rpy_angles(R)[0], "calls kinlab's own `rpy_angles`"),
    ("turns.3", [[1, 1, 1], pi / 3], "has length 1.732"),
    ("turns.3", [[1, 1, 1], pi / 3], "Divide the axis by its length"),
    ("turns.3", [DIAGONAL, 60], "looks like degrees"),
    ("turns.3", [DIAGONAL, -pi / 3], "This is the turn back"),
    ("turns.3", [-DIAGONAL, pi / 3], "This is the turn back"),
    ("turns.3", [DIAGONAL, 0], "cos(angle) = (trace - 1) / 2"),
    ("turns.3", [DIAGONAL, pi / 2], "look at the angle"),
    ("turns.3", [[0, 0, 1], pi / 3], "an axis stays where it is"),
    ("turns.3", [[0, 0, 0], pi / 3], "has no direction"),
    ("turns.3", [DIAGONAL, ...], "the angle is still to do"),
    ("turns.3", [1, 1, 1], "the axis and the angle: [axis, angle]"),
    ("turns.3", [[1, 1], 1], "The axis: expected three numbers"),
    ("turns.4", lambda axis, angle: quaternion(axis, 2 * angle), "half of the angle"),
    ("turns.4", lambda axis, angle: quaternion(axis, angle / 2), "halved twice"),
    ("turns.4", lambda axis, angle: [cos(angle / 2), *sin(angle / 2) * np.array(axis)],
     "has to have length 1"),
    ("turns.4", lambda axis, angle: np.roll(quaternion(axis, angle), -1), "w comes first"),
    ("turns.4", lambda axis, angle: quaternion(axis, -angle), "This is the turn back"),
    ("turns.4", lambda axis, angle: [sin(angle / 2), *cos(angle / 2) * np.array(axis)
                                     / np.linalg.norm(axis)], "changed places"),
    ("turns.4", lambda axis, angle: quaternion(axis, radians(angle)), "do not convert it"),
    ("turns.4", lambda axis, angle: quaternion(axis, degrees(angle)), "in radians already"),
    ("turns.4", lambda axis, angle: [cos(angle / 2), *sin(angle) * np.array(axis)
                                     / np.linalg.norm(axis)], "Halve both"),
    ("turns.4", lambda axis, angle: [cos(angle), *sin(angle / 2) * np.array(axis)
                                     / np.linalg.norm(axis)], "in the cosine, too"),
    ("turns.4", lambda axis, angle: quaternion(axis, angle)[:3], "expected four numbers"),
    ("turns.4", lambda axis, angle: kl.quaternion(kl.rotation_about(axis, angle)),
     "calls kinlab's own `"),
    ("turns.5", [0, pi / 2, 0], "np.arctan2(0, 0) among them"),
    ("turns.5", np.degrees([0, pi / 2, LEFT]), "look like degrees"),
    ("turns.5", [0, -pi / 2, LEFT], "The sign of pitch"),
    ("turns.5", [1, pi / 2, LEFT - 1], "The sum is right where the difference counts"),
    ("turns.5", [0, pi / 2, -LEFT], "has the wrong sign"),
    ("turns.5", [0, 0, LEFT], "Pitch must be a quarter turn"),
    ("turns.5", [0, pi / 2, 1], "at row 1, column 3, where R has 0.8"),
    ("turns.5", [0, pi / 2, ...], "yaw is still to do"),
]

STUBS = [("turns.1", ...), ("turns.1", lambda alpha, beta, gamma: ...), ("turns.2", ...),
         ("turns.2", lambda R: [..., ..., ...]), ("turns.3", ...), ("turns.3", [..., ...]),
         ("turns.4", lambda axis, angle: ...), ("turns.5", ...), ("turns.5", [..., ..., ...])]
