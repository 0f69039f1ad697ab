"""Lesson 02, rotation: its views, its exercises' references and typical slips."""
from __future__ import annotations

import math
from math import cos, pi, radians, sin

import numpy as np

from ..answers.judges import Judge, choices, function, values
from ..answers.matrices import matrix_entry
from ..arms.motions import Numbers
from ..arms.transforms import rotation_2d
from .asked.rotation import PREDICTIONS
from .views.rotation import (
    axes_view,
    book_view,
    mirror_view,
    riding_view,
    spatial_view,
    still_view,
    turning_view,
    two_turns_view,
)

__all__ = ["JUDGES", "PREDICTIONS", "axes_view", "book_view", "mirror_view", "riding_view",
           "spatial_view", "still_view", "turning_view", "two_turns_view"]

# ---- Exercise 1: the matrix -----------------------------------------------------------

_TURN_SLIPS = [
    ("The angle arrives in radians; do not convert it.", lambda t: rotation_2d(radians(t))),
    ("The angle arrives in radians already: no conversion is needed.",
     lambda t: rotation_2d(math.degrees(t))),
    ("This is the transpose: it turns clockwise. The axes of frame 1 are columns, not rows.",
     lambda t: rotation_2d(t).T),
    ("Sine and cosine have changed places: the first column is x₁ = (cos θ, sin θ).",
     lambda t: np.array([[sin(t), -cos(t)], [cos(t), sin(t)]])),
    ("No sine has a minus sign: y₁ points to the left of x₁, so its x component is -sin θ.",
     lambda t: np.array([[cos(t), sin(t)], [sin(t), cos(t)]])),
    ("This is a mirror image: its second column is -y₁.", lambda t: rotation_2d(t) * [1, -1]),
]

# ---- Exercises 2 and 3: a frame given by its x axis ------------------------------------


def read_off_judge(x_1: Numbers) -> Judge:
    """Judge of the matrix of a frame whose x axis points along `x_1`, of length 1."""
    x, y = x_1
    R = np.array([[x, -y], [y, x]])
    slips = [
        ("The axes stand in the rows. They belong in the columns.", R.T),
        ("Your y axis lies to the right of the x axis: a left-handed frame, a mirror image.",
         R * [1, -1]),
        ("The second column repeats the x axis with its entries exchanged; it must be "
         "perpendicular to the first.", np.array([[x, y], [y, x]])),
        ("The columns have changed places: x₁ comes first.", R[:, ::-1]),
    ]
    return values(
        R, entry=matrix_entry, slips=slips,
        praise="One axis was enough: the other one follows by a quarter turn to the left.")


def seen_judge(x_1: Numbers, c_0: Numbers) -> Judge:
    """Judge of the coordinates of a point in that frame."""
    x, y = x_1
    R, c_0 = np.array([[x, -y], [y, x]]), np.asarray(c_0, dtype=float)
    slips = [
        ("You multiplied by R: that takes coordinates from frame 1 to frame 0.", R @ c_0),
        ("x₁ · c is right. Check y₁ · c.", (R.T @ c_0) * [1, -1]),
        ("A point that stands still still changes its coordinates: the frame has turned.", c_0),
    ]
    return values(
        R.T @ c_0, entry=lambda index: f"the {'xy'[index[0]]} of c_1", slips=slips,
        praise="Each component is a dot product of c with an axis of frame 1.")


# ---- Exercise 4: which are rotations? ---------------------------------------------------

_RIGHT_ROTATIONS = {1, 4, 6}
_ROTATION_HINTS = {
    ("rotations", 1): "Test matrix 1: lengths of the columns, their product, the determinant.",
    ("rotations", 2): "The columns of matrix 2 are perpendicular and of length 1. "
                      "What is its determinant?",
    ("rotations", 3): "How long are the columns of matrix 3?",
    ("rotations", 4): "Matrix 4 is a turn by -90°. Where does it take x?",
    ("rotations", 5): "The columns of matrix 5 have length 1. Are they perpendicular?",
    ("rotations", 6): "Two minus signs: is that a mirror image, or a turn by half a circle?",
}

# ---- Exercise 5: a camera that looks ahead ----------------------------------------------

_CAMERA = np.array([[0.0, 0, 1], [-1, 0, 0], [0, -1, 0]])
_CAMERA_SLIPS = [
    ("The axes stand in the rows. They belong in the columns.", _CAMERA.T),
    ("Your x axis points to the other side: x × y is -z, a left-handed frame.",
     _CAMERA * [-1, 1, 1]),
    ("Your y axis points up; in the camera's image y points down.", _CAMERA * [-1, -1, 1]),
    ("Your y axis points up, and the frame is left-handed.", _CAMERA * [1, -1, 1]),
    ("Nothing is turned here: the camera would look up along z₀.", np.eye(3)),
    ("All signs are turned round: each axis points the opposite way, and three opposite axes are a "
     "left-handed frame.", -_CAMERA),
]

JUDGES: dict[str, Judge] = {
    "rotation.1": function(
        rotation_2d, [{"theta": t} for t in (0.0, pi / 6, -2.0, 4.0)], entry=matrix_entry,
        slips=_TURN_SLIPS,
        without="The task says without kinlab: build the matrix from np.cos and np.sin.",
        praise="Your function agrees at every angle. kinlab's own is rotation_2d."),
    "rotation.2": read_off_judge((0.6, 0.8)),
    "rotation.3": seen_judge((0.6, 0.8), (2, 1)),
    "rotation.4": choices(
        {"rotations": _RIGHT_ROTATIONS}, {1, 2, 3, 4, 5, 6}, _ROTATION_HINTS, noun="matrix",
        praise="Columns of length 1, perpendicular, determinant +1: all three are needed."),
    "rotation.5": values(
        _CAMERA, entry=matrix_entry, slips=_CAMERA_SLIPS,
        praise="This is how most cameras on robots are described. What the camera sees at "
               "(0, 0, 2), the robot finds two units ahead."),
}
