"""Answers to the exercises on rotation: right, typically wrong, and not attempted."""
from math import cos, degrees, radians, sin

import numpy as np


def turn(theta):
    return np.array([[cos(theta), -sin(theta)], [sin(theta), cos(theta)]])


CAMERA = np.array([[0, 0, 1], [-1, 0, 0], [0, -1, 0]])

RIGHT = {
    "rotation.1": turn,
    "rotation.2": [[0.6, -0.8], [0.8, 0.6]],
    "rotation.3": [2, -1],
    "rotation.4": [{1, 4, 6}],
    "rotation.5": CAMERA,
}

# (exercise, answer, words of the praise)
ALSO = [
    ("rotation.3", [[2], [-1]], "dot product"),
    ("rotation.3", np.array([[2, -1]]), "dot product"),
]

# (exercise, answer, words of the message)
WRONG = [
    ("rotation.2", [[0.6, ...], [0.8, 0.6]], "row 1, column 2 is still to do"),
    ("rotation.5", -CAMERA, "All signs are turned round"),
    ("rotation.2", [[-0.6, 0.8], [-0.8, -0.6]], "All signs are turned round"),
    ("rotation.3", [-1, 2], "in another order: asked are the x of c_1 and the y of c_1"),
    ("rotation.4", [{1}], "two are missing"),
    ("rotation.4", [set()], "three are missing"),
    ("rotation.1", lambda t: np.round(turn(t), 3), "It looks rounded: return all digits"),
    ("rotation.1", lambda t: turn(radians(t)), "in radians; do not convert"),
    ("rotation.1", lambda t: turn(degrees(t)), "in radians already"),
    ("rotation.1", lambda t: turn(t).T, "transpose"),
    ("rotation.1", lambda t: np.array([[sin(t), -cos(t)], [cos(t), sin(t)]]), "changed places"),
    ("rotation.1", lambda t: np.array([[cos(t), sin(t)], [sin(t), cos(t)]]), "minus sign"),
    ("rotation.1", lambda t: turn(t) * [1, -1], "mirror image"),
    ("rotation.1", lambda t: 2 * turn(t), "row 1, column 1 should be 1, got 2"),
    ("rotation.1", lambda t: turn(t)[0], "two rows of two numbers; your function gave two"),
    ("rotation.1", turn(1.0), "Expected a function"),
    ("rotation.2", [[0.6, 0.8], [-0.8, 0.6]], "rows"),
    ("rotation.2", [[0.6, 0.8], [0.8, -0.6]], "left-handed"),
    ("rotation.2", [[0.6, 0.8], [0.8, 0.6]], "perpendicular to the first"),
    ("rotation.2", [[-0.8, 0.6], [0.6, 0.8]], "x₁ comes first"),
    ("rotation.2", [[0.6, 0], [0.8, 1]], "row 1, column 2 is not 0."),
    ("rotation.2", [0.6, 0.8], "two rows of two numbers; you gave two numbers"),
    ("rotation.3", [0.4, 2.2], "multiplied by R"),
    ("rotation.3", [2, 1], "Check y₁ · c"),
    ("rotation.3", [-2, -1], "the x of c_1 is not -2."),
    ("rotation.4", [{1, 2, 4, 6}], "What is its determinant?"),
    ("rotation.4", [{1, 3, 4, 6}], "How long are the columns"),
    ("rotation.4", [{1, 4, 5, 6}], "Are they perpendicular?"),
    ("rotation.4", [{1, 6}], "Matrix 4 is a turn"),
    ("rotation.4", [{1, 4}], "turn by half a circle"),
    ("rotation.4", [{7}], "no matrix 7"),
    ("rotation.5", CAMERA.T, "rows"),
    ("rotation.5", CAMERA * [-1, 1, 1], "left-handed"),
    ("rotation.5", CAMERA * [-1, -1, 1], "y points down"),
    ("rotation.5", CAMERA * [1, -1, 1], "points up, and the frame is left-handed"),
    ("rotation.5", np.eye(3), "look up along z₀"),
    ("rotation.5", CAMERA * [1, 1, -1], "row 1, column 3 is not -1."),
]

STUBS = [("rotation.1", ...), ("rotation.1", lambda theta: ...), ("rotation.2", ...),
         ("rotation.3", ...), ("rotation.3", [..., ...]), ("rotation.4", [...]),
         ("rotation.5", None)]
