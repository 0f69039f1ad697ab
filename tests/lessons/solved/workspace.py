"""Answers to the exercises of lesson 09: right ones, and the usual slips."""
from math import pi

import numpy as np

import kinlab as kl


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


# ---- Slips that classes are likely to make ------------------------------------------------------

ASKEW = np.arctan(0.6)  # how far the tool appears beside link 1 with the elbow at 90°

WRONG += [
    ("workspace.1", but(lambda near, far, _: (near, far, 2 * pi * (far**2 - near**2))),
     "pi r², without a 2"),
    ("workspace.1", but(lambda near, far, _: (near, far, pi * (far**2 + near**2))), "not added"),
    ("workspace.1", but(lambda near, far, _: (near, far, pi * near**2)), "that of the hole"),
    ("workspace.1", lambda a, b: (min(a, b), max(a, b), pi * (max(a, b)**2 - min(a, b)**2)),
     "are not the two links"),
    ("workspace.1", lambda a, b: (min(a, b), a + b, pi * ((a + b)**2 - min(a, b)**2)),
     "lie on each other"),
    ("workspace.1", but(lambda near, far, _: (near, far)), "you"),
    ("workspace.1", lambda links: (0, sum(links), 1), "takes 1 arguments and was given 2"),
    ("workspace.2", [130, 90], "in metres"),
    ("workspace.2", [1300, 900], "in metres"),
    ("workspace.2", [1.4, 0.8], "folded its tool is 0.6 m from the base"),
    ("workspace.2", [1.1, 1.1], "Links of equal length leave no hole"),
    ("workspace.2", [1.3], "two lengths, l_1 and l_2"),
    ("workspace.2", [1.3, ...], "still to do"),
    ("workspace.3", [0, ASKEW], "take it from 180°"),
    ("workspace.3", [0, pi / 2 + ASKEW], "Opposite over adjacent"),
    ("workspace.3", [ASKEW, pi], "bends to the other side"),
    ("workspace.3", [0, 180], "np.radians"),
    ("workspace.3", [0, 2.5], "could be wider"),
    ("workspace.3", [0, ...], "still to do"),
    ("workspace.4", np.radians([0, 0, 135, 45, 0]), "from the wrist to the shoulder"),
    ("workspace.4", np.radians([0, 0, 90, 45, 0]), "as far as its limit lets it"),
    ("workspace.4", np.radians([0, 0, 0, -90, 0]), "485.1 mm from the shoulder"),
    ("workspace.4", np.radians([0, 0, 135, 22.5 + 360, 0]), "beyond its limits"),
    ("workspace.4", kl.inverse_kinematics(kl.robots.alpha_ii(), [0, 0, 215]), "Hand over its .q"),
    ("workspace.5", [0, -np.arctan2(600, 285), 0, -pi / 2, 0], "the two have changed places"),
    ("workspace.5", [0.2, -np.arctan2(285, 600), 0, -pi / 2, 0], "straight ahead"),
    ("workspace.5", [0, -np.arctan2(285, 600), 0.5, -pi / 2, 0], "A bent arm is shorter"),
    ("workspace.5", [0, -np.arctan2(285, 600), 0, -pi / 2], "you gave four"),
    ("workspace.5", kl.inverse_kinematics(kl.robots.alpha_ii(), [600, 0, 500]),
     "Hand over its .q"),
]

ALSO = [
    ("workspace.2", [0.9, 1.3], "links exchanged"),
    ("workspace.3", np.radians([0, 149]), "As wide as can be"),  # what sliders show
    ("workspace.5", np.radians([0, -25.4, 0, -90, 30]), "Stretched"),
]
