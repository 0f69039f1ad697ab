"""Lesson 03b, notation: its exercises' references and typical slips."""
from __future__ import annotations

from math import radians

from ..answers.judges import Judge, choices, values
from ..arms.transforms import homogeneous, inverse, rotation_2d

# ---- Exercise 1: one pose, many names ------------------------------------------------------

_NOTATION_HINTS = {
    ("same pose", 1): "In Robotics and Controls the upper index is the frame you look from.",
    ("same pose", 2): "In Robotics and Controls the upper index is the frame you look from.",
    ("same pose", 3): "In lecture 2.8 the lower index is the frame you look from.",
    ("same pose", 4): "In lecture 2.8 the lower index is the frame you look from.",
    ("same pose", 5): "With an index on each side, the upper left one is the frame you look from.",
    ("same pose", 6): "kinlab writes the frame you look from first.",
}

# ---- Exercise 2: what fits together -------------------------------------------------------

_PRODUCT_HINTS = {
    ("meaningful", 1): "T_01 @ T_12: the inner indices are 1 and 1.",
    ("meaningful", 2): "T_12 @ T_01: the inner indices are 2 and 0.",
    ("meaningful", 3): "T_01 takes coordinates in frame 1. Which ones does p_0 hold?",
    ("meaningful", 4): "T_02 takes coordinates in frame 2, and p_2 holds just those.",
    ("meaningful", 5): "An inverse exchanges the two indices: what is the inverse of T_01?",
    ("meaningful", 6): "First exchange the indices of T_21, then compare the inner ones.",
}

# ---- Exercise 3: the pose that is missing --------------------------------------------------

T_01 = homogeneous(rotation_2d(radians(90)), [2, 1])
T_02 = homogeneous(rotation_2d(radians(120)), [1, 4])
T_12 = inverse(T_01) @ T_02
_MISSING_SLIPS = [
    ("The factors have changed places: T_02 @ T_10 has 2 and 1 as neighbours.",
     T_02 @ inverse(T_01)),
    ("The pose of frame 1 was not inverted: T_01 @ T_02 has 1 and 0 as neighbours.",
     T_01 @ T_02),
    ("The factors have changed places, and none is inverted: T_02 @ T_01.", T_02 @ T_01),
    ("This is T_21, the pose of frame 1 seen from frame 2: the inverse.", inverse(T_12)),
    ("This is T_02 itself. From which frame is it seen?", T_02),
    ("The origin is o_02 - o_01 with the axes of frame 0; frame 1 measures along its own axes.",
     homogeneous(T_12[:2, :2], T_02[:2, 2] - T_01[:2, 2])),
    ("A transpose inverts a rotation, not a pose: use kl.inverse.", T_01.T @ T_02),
]

JUDGES: dict[str, Judge] = {
    "notation.1": choices(
        {"same pose": {1, 3, 5, 6}}, {1, 2, 3, 4, 5, 6}, _NOTATION_HINTS, noun="symbol",
        praise="Four ways to write one pose: where frame 2 is, seen from frame 1."),
    "notation.2": choices(
        {"meaningful": {1, 4, 5, 6}}, {1, 2, 3, 4, 5, 6}, _PRODUCT_HINTS, noun="line",
        praise="Neighbouring indices must agree. The last line is T_01 @ T_12 in disguise."),
    "notation.3": values(
        T_12, entry=lambda index: f"row {index[0] + 1}, column {index[1] + 1} of T_12",
        slips=_MISSING_SLIPS,
        praise="T_10 @ T_02: the two zeros are neighbours and drop out."),
}
