"""What the appendix asks, held against numbers worked out here."""
import math

import numpy as np

from . import Held


def ride(degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return Held((1.2 * c - 0.5 * s, 1.2 * s + 0.5 * c, 0),
                [((1.2, 0.5, 0), "the printed chain"), ((0, 1.3, 0), "away")])


def arm(theta_1, theta_2):
    """The tip of two links of 1 m; what the appendix finds printed has cos in the second row."""
    one, both = math.radians(theta_1), math.radians(theta_1 + theta_2)
    x, y = math.cos(one) + math.cos(both), math.sin(one) + math.sin(both)
    return Held((x, y, 0), [((x, math.sin(one) + math.cos(both), 0), "the printed formula"),
                            ((1, 1, 0), "away")])


def bar(theta_1, theta_2):
    """One link of 1 m that two joints at one point turn."""
    one, both = math.radians(theta_1), math.radians(theta_1 + theta_2)
    right = (math.cos(one) + math.cos(both), math.sin(one) + math.sin(both), 0)
    return Held((math.cos(both), math.sin(both), 0),
                [(right, "There the right arm"), ((0.5, 0.2, 0), "away")])


def hint(after):
    """Rx(0) Rz(t) with the wrong cosine in entry (3, 3)."""
    R = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, np.cos(np.radians(after))]])
    return Held(np.linalg.det(R), [(1, "determinant of a rotation"), (-1, "too little")])


PREDICTED = {
    "errata.chain": [ride(90), ride(180)],
    "errata.tip": [arm(0, 0), arm(90, 0)],
    "errata.hint": [hint(-90), hint(60)],
    "errata.bar": [bar(0, 90), bar(90, 90)],
    "errata.zero": [
        Held(math.degrees(math.atan2(0.0, -0.0)), [(0, "second zero"), (90, "It is 180°")]),
        Held(math.degrees(math.atan2(0.0, 0.0)), [(180, "second zero"), (90, "It is 0°")])],
    "errata.order": [Held((1, math.sqrt(3), 0),
                          [((2, 0, 0), "it slides first"), ((1, 1, 0), "away")])],
}
