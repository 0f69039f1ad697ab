"""Answers to the exercises of "Notation": right, typically wrong, and not attempted."""
import numpy as np

# What copies of lesson 00 ask for that are older than lesson 03b.
OLD_NAMES = {"start_here.3": "notation.1", "start_here.4": "notation.2"}

S = np.sqrt(3) / 2
T_12 = [[S, -0.5, 3], [0.5, S, 1], [0, 0, 1]]  # turned by 30°, its origin at (3, 1)
T_01 = np.array([[0, -1, 2], [1, 0, 1], [0, 0, 1]])
T_02 = np.array([[-0.5, -S, 1], [S, -0.5, 4], [0, 0, 1]])
T_10 = np.array([[0, 1, -1], [-1, 0, 2], [0, 0, 1]])

RIGHT = {"notation.1": [{1, 3, 5, 6}], "notation.2": [{1, 4, 5, 6}], "notation.3": T_12}

# (exercise, answer, words of the message)
WRONG = [
    ("notation.1", [{1, 3, 5}], "one is missing. kinlab writes the frame you look from first"),
    ("notation.1", [{1, 2, 3, 5, 6}], "not symbol 2. In Robotics and Controls the upper index"),
    ("notation.1", [{1, 4, 5, 6}], "not symbol 4. In lecture 2.8 the lower index"),
    ("notation.1", {1, 3, 5, 6}, "in a list"),
    ("notation.2", [{1, 2, 4, 5, 6}], "not line 2. T_12 @ T_01"),
    ("notation.2", [{1, 3, 4, 5, 6}], "not line 3. T_01 takes coordinates in frame 1"),
    ("notation.2", [{1, 4, 5}], "one is missing. First exchange the indices of T_21"),
    ("notation.3", T_01 @ T_02, "1 and 0 as neighbours"),
    ("notation.3", T_02 @ T_10, "2 and 1 as neighbours"),
    ("notation.3", T_02 @ T_01, "none is inverted"),
    ("notation.3", np.linalg.inv(T_12), "This is T_21"),
    ("notation.3", T_02, "From which frame"),
    ("notation.3", [[S, -0.5, -1], [0.5, S, 3], [0, 0, 1]], "along its own axes"),
    ("notation.3", T_01.T @ T_02, "not a pose"),
    ("notation.3", [[S, -0.5, 3], [0.5, S, 2], [0, 0, 1]], "row 2, column 3"),
]

STUBS = [("notation.1", [...]), ("notation.2", [None]), ("notation.3", ...)]
