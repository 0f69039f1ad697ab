"""Answers to the appendix's exercises: right, typically wrong, and not attempted."""
from math import pi

import numpy as np
import sympy as sp

theta, d, a, alpha = sp.symbols("theta d a alpha")
c, s = sp.cos(theta), sp.sin(theta)

RIGHT = {
    "errata.1": [{3, 4}],
    "errata.2": [a * c, a * s, d],
    "errata.3": [pi / 2, -pi / 2, pi / 2, pi / 2],
}

# (exercise, answer, words of the message)
WRONG = [
    ("errata.1", [{1, 3, 4}], "both joints at zero"),
    ("errata.1", [{2, 3, 4}], "Multiply the two rotations"),
    ("errata.1", [{4}], "one is missing"),
    ("errata.1", [{3}], "Where is the origin"),
    ("errata.2", [a * c, a * s * sp.cos(alpha), d], "no alpha"),
    ("errata.2", [a * c, a * c * sp.sin(alpha), d], "printed entry"),
    ("errata.2", [a * s, a * c, d], "Sine and cosine"),
    ("errata.2", [a, -d * sp.sin(alpha), d * sp.cos(alpha)], "modified"),
    ("errata.2", [d * c, d * s, a], "a and d"),
    ("errata.3", [90, 90, 90, 45], "np.radians"),
    ("errata.3", [0, 0, 0, 0], "alpha_0 is zero"),
    ("errata.3", np.radians([90, 90, 45, 45]), "In link 2"),
    ("errata.3", np.radians([10, 20, 30, 40]), "cosines must be equal"),
    ("errata.3", [pi / 2, pi / 2], "four angles"),
]

STUBS = [("errata.1", ...), ("errata.1", [...]), ("errata.2", [..., ..., ...]), ("errata.3", ...)]


# ---- Slips that classes are likely to make ------------------------------------------------------

WRONG += [
    ("errata.1", [{1, 2}], "not line 1"),
    ("errata.1", [{2, 3}], "not line 2"),
    ("errata.1", [set()], "two are missing"),
    ("errata.1", [{3, 4, 5}], "no line 5"),
    ("errata.1", {3, 4}, "in a list"),
    ("errata.2", [a, 0, d], "after the turn by theta"),
    ("errata.2", [a * c, -a * s, d], "sign of theta"),
    ("errata.2", [a * c, a * s, 0], "d is the third component"),
    ("errata.2", [a * c, a * s, d * sp.cos(alpha)], "alpha comes last"),
    ("errata.2", [a * sp.cos(alpha), a * sp.sin(alpha), d], "Theta and alpha"),
    ("errata.2", [c, s, 0], "first column of the rotation"),
    ("errata.2", [a * c, a * s, ...], "p_x and p_y are right; p_z is still to do"),
    ("errata.2", [a * c, a * s], "got 2"),
    ("errata.3", [90, 90, -90, 90], "looks like degrees"),
    ("errata.3", [60, -60, 60, 60], "looks like degrees"),
    ("errata.3", [22.5, 22.5, -22.5, 22.5], "looks like degrees"),
    ("errata.3", [pi / 2, -pi / 2, pi / 2, 0], "alpha_3 is zero"),
    ("errata.3", [pi / 3, pi / 3, 2 * pi / 3, pi / 3], "In link 2"),
    ("errata.3", [pi / 2, pi / 2, pi / 2, ...], "still to do"),
]

ALSO = [
    ("errata.3", [1, -1, 1, -1], "Equal cosines"),
    ("errata.3", [pi / 3, 5 * pi / 3, 7 * pi / 3, -pi / 3], "Equal cosines"),
    ("errata.3", np.radians([60, -60, 60, 60]), "Equal cosines"),
]
