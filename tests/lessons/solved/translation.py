"""Answers to the exercises on translation: right, typically wrong, and not attempted."""
import numpy as np
import sympy as sp

k_x, k_y, b_x, b_y, p_x, p_y = sp.symbols("k_x k_y b_x b_y p_x p_y")
K, B, P = np.array([[k_x, k_y], [b_x, b_y], [p_x, p_y]])

RIGHT = {
    "translation.1": [[1, 3], [-2, 3], [-3, 1]],
    "translation.2": [p_x + k_x - b_x, k_y - (b_y - p_y)],
    "translation.3": np.array([1, 2]),
}

# (exercise, answer, words of the praise)
ALSO = [
    ("translation.1", [np.array([[1], [3]]), [-2, 3], [-3, 1]], "Add on the way"),
    ("translation.2", sp.Matrix([p_x + k_x - b_x, p_y + k_y - b_y]), "Up into the room"),
    ("translation.3", [[1], [2]], "midway"),
]

# (exercise, answer, words of the message)
WRONG = [
    ("translation.1", [[1, 3], ..., ...], "c_0 is right; d_1 and o_10 are still to do."),
    ("translation.1", [[1, 4], ..., ...], "Besides, d_1 and o_10 are still to do."),
    ("translation.1", [[1, ...], [-2, 3], [-3, 1]], "the y of c_0 is still to do"),
    ("translation.1", [[1, 3], [-2, 3], [-4, 1]], "the x of o_10 is not -4"),
    ("translation.1", [[1, 3], [-2, 3], [-3, 1, 0]], "o_10: expected two numbers; you gave three"),
    ("translation.2", [p_x + k_x - b_x, ...], "x is right; y is still to do."),
    ("translation.2", [p_y + k_y - b_y, p_x + k_x - b_x], "x and y have changed places"),
    ("translation.1", [[-5, 5], [4, 1], [-3, 1]], "Sum and difference have changed places"),
    ("translation.1", [[-5, 5], [-2, 3], [-3, 1]], "o₁⁰ is added"),
    ("translation.1", [[1, 3], [4, 1], [-3, 1]], "o₁⁰ is subtracted"),
    ("translation.1", [[1, 3], [2, -3], [-3, 1]], "wrong way round"),
    ("translation.1", [[1, 3], [-2, 3], [3, -1]], "where frame 0 sees that of frame 1"),
    ("translation.1", [[1, 3], [-2, 3], [0, 0]], "its own origin at (0, 0)"),
    ("translation.1", [[3, 1], [3, -2], [1, -3]], "x and y have changed places"),
    ("translation.1", [[1, 3], [-2, 4], [-3, 1]], "the y of d_1 is not 4"),
    ("translation.1", [[1, 3], [-2, 3], 0], "o_10: expected two numbers; you gave one number"),
    ("translation.1", [[1, 3], [-2, 3], ...], "c_0 and d_1 are right; o_10 is still to do."),
    ("translation.2", K + P, "where the room sees the part"),
    ("translation.2", K + B + P, "subtracted, not added"),
    ("translation.2", P - K - B, "you subtracted both"),
    ("translation.2", P - K + B, "You subtracted it"),
    ("translation.2", P - B, "not itself at the room's origin"),
    ("translation.2", B - K - P, "All signs"),
    ("translation.2", K - B, "where the robot sees the camera"),
    ("translation.2", [p_x + k_x - b_x, k_y], "y should be"),
    ("translation.2", [p_x + k_x - b_x, sp.Symbol("z")], "y holds z; only k_x, k_y"),
    ("translation.2", [1, 6.5], "x should be -0.6, got 1"),
    ("translation.3", [4, -2], "vector from d to c"),
    ("translation.3", [-4, 2], "vector from c to d"),
    ("translation.3", [2, 4], "stands twice"),
    ("translation.3", [2, -1], "half the way from d to c"),
    ("translation.3", [-2, 1], "half the way from c to d"),
    ("translation.3", [0, 0], "opposite directions"),
    ("translation.3", [1, 3], "the y of o_1 is not 3"),
    ("translation.3", [1, 2, 0], "expected two numbers; you gave three numbers"),
]

STUBS = [("translation.1", [..., ..., ...]), ("translation.2", [..., ...]),
         ("translation.3", ...), ("translation.3", [..., ...])]
