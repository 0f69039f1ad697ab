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
