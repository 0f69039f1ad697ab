"""Answers to the exercises of "Start here": right, typically wrong, and not attempted."""
from math import pi

import numpy as np
import sympy as sp

from . import notation

FORWARD, INVERSE = {1, 4, 5}, {2, 3, 6}
WAYS = np.radians([[20, 60], [80, -60]])

RIGHT = {
    "start_here.1": [FORWARD, INVERSE],
    "start_here.2": [sp.pi / 3, 0.25, sp.Rational(9, 20)],
    **{old: notation.RIGHT[new] for old, new in notation.OLD_NAMES.items()},
    "start_here.5": WAYS,
}

# (exercise, answer, words of the praise)
ALSO = [("start_here.2", [7 * pi / 3, 0.25, 0.45], "Radians"),
        ("start_here.2", [[pi / 3], [0.25], [0.45]], "Radians")]

# (exercise, answer, words of the message)
WRONG = [
    *((old, *case[1:]) for old, new in notation.OLD_NAMES.items()
      for case in notation.WRONG if case[0] == new),
    ("start_here.1", [INVERSE, FORWARD], "forward: got {2, 3, 6}, but not question 2"),
    ("start_here.1", [{1, 5}, INVERSE], "one is missing. Question 4"),
    ("start_here.1", [{1, 4, 5, 6}, {2, 3}], "not question 6"),
    ("start_here.1", [{0, 1, 4, 5}, INVERSE], "no question 0; choose from {1, 2, 3, 4, 5, 6}"),
    ("start_here.1", [FORWARD, ...], "forward is right; inverse is still to do."),
    ("start_here.2", [60, 0.25, 0.45], "still in degrees"),
    ("start_here.2", [60 * 180 / pi, 0.25, 0.45], "wrong way"),
    ("start_here.2", [60, 250, 45], "not in metres"),
    ("start_here.2", [pi / 3, 250, 450], "in millimetres"),
    ("start_here.2", [pi / 3, 250, 45], "arm's unit, metres"),
    ("start_here.2", [pi / 3, 2.5, 0.45], "quarter of a metre"),
    ("start_here.2", [pi / 3, 250, 0.45], "quarter of a metre"),
    ("start_here.2", [pi / 3, 0.25, 45], "less than half a metre"),
    ("start_here.2", [pi / 3, 0.25, 0.045], "100 cm"),
    ("start_here.2", [pi / 3, 0.45, 0.25], "changed places"),
    ("start_here.2", [1.047, 0.25, 0.45], "np.radians turns degrees into all of them"),
    ("start_here.2", [pi / 3, ..., ...], "q[0] is right; q[1] and q[2] are still to do."),
    ("start_here.2", [60, ..., ...], "still in degrees: use np.radians. Besides, q[1] and"),
    ("start_here.5", [[0, 0], [0, 0]], "Pair 1 puts the tip at (2.000, 0.000) m"),
    ("start_here.5", [WAYS[0], ...], "pair 1 is right; pair 2 is still to do."),
    ("start_here.5", [[..., ...], [0, 0]], "Pair 2 puts the tip at (2.000, 0.000) m"),
    ("start_here.2", [1.0, 0.25, 0.45], "q[0] is not 1."),
    ("start_here.2", [pi / 3, 0.25], "expected three numbers; you gave two numbers"),
    ("start_here.2", ["60 deg", 0.25, 0.45], "plain numbers"),
    ("start_here.5", np.degrees(WAYS), "look like degrees"),
    ("start_here.5", WAYS.T, "have to be rows"),
    ("start_here.5", [WAYS[0], WAYS[0]], "in the same way"),
    ("start_here.5", [WAYS[0], WAYS[0] * [1, -1]], "Only the sign of θ₂ has changed"),
    ("start_here.5", [WAYS[0], [0, -pi / 2]], "Pair 2 puts the tip at (1.000, -1.000) m, 2.330 m"),
    ("start_here.5", WAYS[0], "two pairs of joint values"),
    ("start_here.5", "both", "plain numbers"),
]

STUBS = [("start_here.1", [..., ...]), ("start_here.2", ...), ("start_here.2", [..., ..., ...]),
         ("start_here.3", [...]), ("start_here.4", [None]), ("start_here.5", ...)]
