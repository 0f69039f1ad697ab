"""Answers to the exercises of lesson 09: right ones, and the usual slips."""
from math import pi

import numpy as np


def ring(l_1, l_2):
    near, far = abs(l_1 - l_2), l_1 + l_2
    return near, far, pi * (far**2 - near**2)


def but(change):
    return lambda l_1, l_2: change(*ring(l_1, l_2))


RIGHT = {
    "workspace.1": ring,
    "workspace.2": [1.3, 0.9],
    "workspace.3": [0, pi - np.arctan(0.6)],
    "workspace.4": np.radians([0, 0, 135, 22.5, 0]),
    "workspace.5": [0, -np.arctan2(285, 600), 0, -pi / 2, 0],
}

WRONG = [
    ("workspace.1", lambda a, b: (a - b, a + b, 4 * pi * a * b), "never negative"),
    ("workspace.1", lambda a, b: (0, a + b, pi * (a + b) ** 2), "leaves a hole"),
    ("workspace.1", but(lambda near, far, _: (near, far, pi * far**2)), "whole disc"),
    ("workspace.1", but(lambda near, far, _: (near, far, pi * (far - near) ** 2)),
     "Subtract areas"),
    ("workspace.1", but(lambda near, far, _: (near, far, far**2 - near**2)), "factor pi"),
    ("workspace.1", but(lambda near, far, _: (near, far, 2 * pi * (far - near))),
     "circumference"),
    ("workspace.1", but(lambda near, far, area: (far, near, area)), "changed places"),
    ("workspace.1", but(lambda near, far, area: (2 * near, 2 * far, area)), "diameters"),
    ("workspace.1", but(lambda near, far, area: (near, far, area + 1)),
     "the area should be 7.53982, got 8.53982"),
    ("workspace.2", [2.2, 0.4], "These are the radii themselves"),
    ("workspace.2", [0.65, 0.45], "half of what they should be"),
    ("workspace.2", [2.6, 1.8], "twice what they should be"),
    ("workspace.2", [1.1, 1.1], "folded its tool is 0 m from the base"),
    ("workspace.2", [-1.3, 3.5], "two lengths above 0"),
    ("workspace.2", 2.2, "two lengths, l_1 and l_2"),
    ("workspace.3", [0, 149.036], "np.radians"),
    ("workspace.3", [0, pi], "once it is bent"),
    ("workspace.3", [0, pi / 2], "could be wider by 59"),
    ("workspace.3", [0, pi / 2], "as long as its end stays above"),
    ("workspace.3", [0, pi - np.arcsin(0.6)], "this one stops at 90"),
    ("workspace.3", [-0.1, 2.6], "y = -0.160 m, in the wall"),
    ("workspace.3", [2.6, 0], "the lowest value before the highest"),
    ("workspace.4", [0, 0, 135, 22.5, 0], "np.radians"),
    ("workspace.4", np.radians([0, 0, 135, -135, 0]), "points away from the shoulder"),
    ("workspace.4", np.radians([0, 0, -135, -135, 0]), "not the same to both sides"),
    ("workspace.4", np.radians([0, 0, 135, 112.5, 0]), "straight at theta_4 = -90"),
    ("workspace.4", np.radians([0, 0, 120, 30, 0]), "as far as its limit lets it"),
    ("workspace.4", np.radians([0, 0, 137.3, 21, 0]), "beyond its limits"),
    ("workspace.4", np.radians([0, 0, 135, 22.5]), "expected five joint values; you gave four"),
    ("workspace.5", np.degrees([0, -0.44, 0, -pi / 2, 0]), "np.radians"),
    ("workspace.5", [0, np.arctan2(285, 600), 0, -pi / 2, 0], "positive angles lower the arm"),
    ("workspace.5", [0, -np.arctan2(500, 600), 0, -pi / 2, 0], "see it from the shoulder"),
    ("workspace.5", [0, -np.arctan2(285, 600), 0, 0, 0], "not at 0"),
    ("workspace.5", [0.1, -np.arctan2(285, 600), 0, -pi / 2, 0], "it can come closer"),
]

STUBS = [("workspace.1", ...), ("workspace.1", lambda l_1, l_2: ...), ("workspace.2", ...),
         ("workspace.3", None), ("workspace.4", ...), ("workspace.5", ...)]
