"""How a frame is turned from the room: as a quaternion, an axis and an angle, roll-pitch-yaw.

kinlab/browser/turned.js does the same at every step of a drag.
"""
from __future__ import annotations

from collections.abc import Sequence
from math import atan2, cos, degrees, sin

import numpy as np

from ..arms.euler import rpy_angles
from ..arms.motions import ROTATE, Numbers

_LEAST = -179.95  # degrees: below, -180.0 would be shown
_NO_AXIS = 1e-6   # sine of half an angle: none that can be told from 0


def followed(motions: Sequence, frame: int, q: Numbers) -> np.ndarray:
    """The unit quaternion (w, x, y, z) of a frame, followed along the motions that lead to it.

    Each turn by an angle v about an axis e is (cos v/2, e sin v/2), and turns about moving axes are
    multiplied in their order. So it moves smoothly with every knob, and its sign never jumps: after
    one whole turn of a knob it is the opposite one, which is the same rotation.

    Parameters
    ----------
    motions : sequence of Step
    frame : int
    q : sequence of float
        Values of the knobs.
    """
    whole = np.array([1.0, 0.0, 0.0, 0.0])
    while frame > 0:
        motion = motions[frame - 1]
        if motion.kind == ROTATE:
            half = motion.value(q) / 2
            turn = np.array([cos(half), 0.0, 0.0, 0.0])
            turn[1 + motion.axis] = sin(half)
            whole = _product(turn, whole)
        frame = frame - 1 if motion.parent is None else motion.parent
    return whole


def _product(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    return np.array([p[0] * q[0] - p[1:] @ q[1:],
                     *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])


def axis_and_angle(q: np.ndarray) -> tuple[np.ndarray | None, float]:
    """Axis, or None where any axis will do, and angle (degrees, 0 to 360) of a unit quaternion.

    The angle may be more than 180, so that both go on smoothly there: the quaternion tells one axis
    from the opposite one.
    """
    sine = float(np.linalg.norm(q[1:]))
    return (None if sine <= _NO_AXIS else q[1:] / sine), degrees(2 * atan2(sine, q[0]))


def roll_pitch_yaw(R: np.ndarray) -> np.ndarray | str:
    """Roll, pitch and yaw of a rotation in degrees, pitch within 90; at 90 what is left, in words.
    """
    angles = rpy_angles(R)
    if not angles.singular:
        return np.array([_one_sign(degrees(angle)) for angle in angles[0]])
    pitch, left = degrees(angles[0][1]), _one_sign(degrees(angles.fixed))
    return f"pitch {_said(pitch)}, yaw {'+' if angles.sign > 0 else '−'} roll = {_said(left)}"


def _one_sign(angle: float) -> float:
    """Degrees, above -180 as they are shown: half a turn has one sign, else it would flicker."""
    return angle + 360 if angle < _LEAST else angle


def _said(angle: float) -> str:
    """Degrees with one decimal, as the browser writes them."""
    text = f"{angle:.1f}"
    return "0.0" if float(text) == 0 else text.replace("-", "−")
