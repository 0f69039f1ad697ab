"""Lesson 11, turns in space: its views, its exercises' references and typical slips."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from math import cos, degrees, pi, radians, sin
from typing import Any

import numpy as np

from ..answers.conditions import Condition, degrees_slip, exactly, meet, one_of_many
from ..answers.given import numbers
from ..answers.judges import Judge, Slip, function
from ..answers.matrices import BY_ENTRY, entry_by_entry, matrix_entry
from ..answers.words import counted
from ..arms.euler import rpy_matrix
from ..arms.quaternions import rotation_about
from ..arms.transforms import rotation_x, rotation_z
from .asked.turns import PREDICTIONS
from .views.turns import attitude_view, axis_view, books_view, gimbal_view

__all__ = ["JUDGES", "PREDICTIONS", "attitude_view", "axis_view", "books_view", "gimbal_view"]

_NEAR = 2e-4  # of an entry: what is typed with four decimals is near enough

# ---- Exercise 1: fixed and own axes in one product ---------------------------------------


def _mixed(a: float, b: float, c: float) -> np.ndarray:
    return rotation_x(b) @ rotation_z(a) @ rotation_z(c)


_MIXED_CASES = [dict(zip(("alpha", "beta", "gamma"), angles)) for angles in
                ((0.0, 0.0, 0.0), (0.5, 0.8, 0.0), (0.5, 0.8, -1.2), (2.0, -0.7, 3.0))]
_MIXED_SLIPS: list[Slip] = [
    ("The turn about x of the room stands on the right, where own axes stand. About an axis of the "
     "room: to the left.", lambda a, b, c: rotation_z(a) @ rotation_x(b) @ rotation_z(c)),
    ("The last turn is about the camera's own z: to the right of all that is there.",
     lambda a, b, c: rotation_z(c) @ rotation_x(b) @ rotation_z(a)),
    ("Left and right have changed places: an axis of the room to the left, an own axis to the "
     "right.", lambda a, b, c: rotation_z(c) @ rotation_z(a) @ rotation_x(b)),
    ("This is the transpose, the way back.", lambda *q: _mixed(*q).T),
    ("The angles arrive in radians; do not convert them.", lambda *q: _mixed(*map(radians, q))),
    ("The angles arrive in radians already: no conversion is needed.",
     lambda *q: _mixed(*map(degrees, q))),
    ("The last turn is missing: the camera turns about its own z by gamma.",
     lambda a, b, c: _mixed(a, b, 0)),
    (BY_ENTRY, lambda a, b, c: entry_by_entry([rotation_x(b), rotation_z(a), rotation_z(c)])),
]

# ---- Exercise 2: roll, pitch and yaw of a matrix ------------------------------------------


def _first_branch(angles: Any) -> Any:
    """The same turn with cos(pitch) above zero, where three angles are given."""
    try:
        roll, pitch, yaw = np.ravel(np.asarray(angles, dtype=float))
    except (TypeError, ValueError):  # whoever reads it next says what is wrong
        return angles
    return [roll + pi, pi - pitch, yaw + pi] if cos(pitch) < 0 else [roll, pitch, yaw]


def _read_off(formula: Callable[[np.ndarray], Any]) -> Callable:
    """A slip: another formula for the angles of the matrix."""
    return lambda *angles: _first_branch(formula(rpy_matrix(*angles)))


def _right_angles(R: np.ndarray) -> list:
    return [np.arctan2(R[2, 1], R[2, 2]), np.arctan2(-R[2, 0], np.hypot(R[2, 1], R[2, 2])),
            np.arctan2(R[1, 0], R[0, 0])]


def _with(k: int, angle: Callable[[np.ndarray], Any]) -> Callable:
    """A slip in one of the three angles."""
    def formula(R: np.ndarray) -> list:
        angles = _right_angles(R)
        angles[k] = angle(R)
        return angles
    return _read_off(formula)


_ANGLES = ("roll", "pitch", "yaw")
_RPY_CASES = [dict(zip(_ANGLES, angles)) for angles in
              ((0.3, 0.5, 0.7), (2.5, -0.4, -2.0), (-1.9, 1.1, 2.9), (-0.6, -1.3, 0.4))]
_RPY_SLIPS: list[Slip] = [
    ("Roll takes y first, then x: np.arctan2(r32, r33).",
     _with(0, lambda R: np.arctan2(R[2, 2], R[2, 1]))),
    ("Yaw takes y first, then x: np.arctan2(r21, r11).",
     _with(2, lambda R: np.arctan2(R[0, 0], R[1, 0]))),
    ("np.arctan2 takes y first, then x.", _read_off(lambda R: [
        np.arctan2(R[2, 2], R[2, 1]), np.arctan2(np.hypot(R[2, 1], R[2, 2]), -R[2, 0]),
        np.arctan2(R[0, 0], R[1, 0])])),
    ("np.arctan2 takes y first, then x.", _read_off(lambda R: [
        np.arctan2(R[2, 2], R[2, 1]), _right_angles(R)[1], np.arctan2(R[0, 0], R[1, 0])])),
    ("The sign of pitch is wrong: r31 is minus the sine of pitch.",
     lambda roll, pitch, yaw: [roll, -pitch, yaw]),
    ("These are the angles of the transpose: R[2, 1] is row 3, column 2.",
     _read_off(lambda R: _right_angles(R.T))),
    ("The order is roll, pitch, yaw: roll belongs to x, yaw to z.",
     lambda roll, pitch, yaw: _first_branch([yaw, pitch, roll])),
    ("Give radians: leave np.degrees out.", lambda *q: _first_branch(np.degrees(q))),
    ("np.arctan of a quotient cannot tell opposite quadrants apart: take np.arctan2.",
     _read_off(lambda R: [np.arctan(R[2, 1] / R[2, 2]), _right_angles(R)[1],
                          np.arctan(R[1, 0] / R[0, 0])])),
    ("np.arctan of a quotient cannot tell opposite quadrants apart: take np.arctan2 for roll.",
     _with(0, lambda R: np.arctan(R[2, 1] / R[2, 2]))),
    ("np.arctan of a quotient cannot tell opposite quadrants apart: take np.arctan2 for yaw.",
     _with(2, lambda R: np.arctan(R[1, 0] / R[0, 0]))),
]

# ---- Exercise 3: the axis and the angle ---------------------------------------------------

_ROUND = np.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3  # by 60 degrees about (1, 1, 1)


def _axis_and_angle(answer: Any) -> np.ndarray:
    """Four numbers of an answer [axis, angle]; nan for those still to come."""
    if isinstance(answer, (str, bytes, dict, set)) or not hasattr(answer, "__len__") \
            or len(answer) != 2:
        raise ValueError("Your answer: expected two things, the axis and the angle: [axis, angle]")
    axis, angle = answer
    return np.append(numbers(axis, (3,), start="The axis").numbers,
                     numbers(angle, (), wanted="one number, radians", start="The angle").numbers)


def _length_one(q: np.ndarray) -> str:
    length = float(np.linalg.norm(q[:3]))
    return "" if abs(length - 1) < _NEAR else (
        f"Your axis has length {length:.4g}; the task asks for one of length 1.")


def _turns_to(wanted: np.ndarray) -> Condition:
    """A turn by an axis and an angle that gives a matrix."""
    def condition(q: np.ndarray) -> str:
        axis, angle = q[:3], q[3]
        if not np.any(axis):
            return "The axis (0, 0, 0) has no direction."
        if np.allclose(rotation_about(axis, angle), wanted, atol=_NEAR):
            return ""
        stays = np.allclose(wanted @ axis, axis, atol=1e-3)
        return "Put into kl.rotation_about, these do not give R." + (
            " R keeps your axis, so look at the angle." if stays else
            " R @ axis is not the axis: an axis stays where it is.")
    return condition


def _meets_after(conditions: Sequence[Condition],
                 change: Callable[[np.ndarray], Any]) -> Callable[[np.ndarray], bool]:
    """Whether numbers are right after a change."""
    return lambda q: meet(conditions, np.asarray(change(q)))


def axis_judge(R: np.ndarray) -> Judge:
    """Judge of the axis and the angle of a rotation."""
    turns = (_turns_to(R),)
    slips: list[Slip] = [
        ("Divide the axis by its length, np.linalg.norm(axis).",
         lambda q: bool(_length_one(q)) and meet(turns, q)),
        ("The angle looks like degrees: give radians, np.radians(...).",
         _meets_after(turns, lambda q: np.append(q[:3], radians(q[3])))),
        ("This is the turn back: turn round the sign of the axis or of the angle, not of both.",
         _meets_after(turns, lambda q: q * [-1, -1, -1, 1])),
        ("The trace of R is 1 + 2 cos(angle), so cos(angle) = (trace - 1) / 2.",
         lambda q: any(abs(cos(q[3]) - c) < _NEAR for c in (np.trace(R) - 1, np.trace(R) / 2))),
    ]
    return one_of_many(
        _axis_and_angle, (*turns, _length_one), slips=slips, noun="axis and angle",
        parts=("x of the axis", "y of the axis", "z of the axis", "the angle"),
        praise="R keeps this axis and turns all else about it. The opposite axis with the opposite "
               "angle is the same turn.")


# ---- Exercise 4: a quaternion ----------------------------------------------------------------


def _one_of_both(q: Any) -> Any:
    """Of q and -q the one whose first number that is not 0 is positive."""
    try:
        array = np.ravel(np.asarray(q, dtype=float))
    except (TypeError, ValueError):
        return q
    far = array[np.abs(array) > 1e-9]
    return array * np.sign(far[0]) if far.size and np.isfinite(far[0]) else q


def _made(half: float = 0.5, *, scale: Callable = np.linalg.norm) -> Callable:
    """A quaternion by the formula, or by one that has gone wrong."""
    def made(axis: Any, angle: float) -> np.ndarray:
        unit = np.asarray(axis, float) / scale(axis)
        return _one_of_both([cos(half * angle), *sin(half * angle) * unit])
    return made


_quaternion = _made()


def _reordered(order: Any, signs: Any = 1) -> Callable:
    return lambda axis, angle: _one_of_both(_quaternion(axis, angle)[order] * signs)


_QUATERNION_CASES = [
    {"axis": [0.0, 0.0, 1.0], "angle": pi / 2}, {"axis": [1.0, 2.0, 2.0], "angle": 0.8},
    {"axis": [0.0, -3.0, 4.0], "angle": -1.9}, {"axis": [2.0, -1.0, 2.0], "angle": 4.0}]
_QUATERNION_SLIPS: list[Slip] = [
    ("It takes half of the angle, in the cosine and in the sine.", _made(1.0)),
    ("The angle is halved twice.", _made(0.25)),
    ("The axis has to have length 1: divide it by np.linalg.norm(axis).",
     _made(scale=lambda axis: 1.0)),
    ("The scalar w comes first here: w, x, y, z. (ROS and SciPy put it last.)",
     _reordered([1, 2, 3, 0])),
    ("This is the turn back: only the signs of x, y, z are turned round.",
     _reordered([0, 1, 2, 3], [1, -1, -1, -1])),
    ("Sine and cosine have changed places: w is the cosine of half the angle.",
     lambda axis, angle: _one_of_both([sin(angle / 2), *cos(angle / 2) * np.asarray(axis, float)
                                       / np.linalg.norm(axis)])),
    ("The angle arrives in radians; do not convert it.",
     lambda axis, angle: _quaternion(axis, radians(angle))),
    ("The angle arrives in radians already: no conversion is needed.",
     lambda axis, angle: _quaternion(axis, degrees(angle))),
    ("w is the cosine of half the angle, without the axis; x, y, z are the sine of half the angle "
     "times the axis. Halve both.",
     lambda axis, angle: _one_of_both([cos(angle / 2), *sin(angle) * np.asarray(axis, float)
                                       / np.linalg.norm(axis)])),
    ("Halve the angle in the cosine, too.",
     lambda axis, angle: _one_of_both([cos(angle), *sin(angle / 2) * np.asarray(axis, float)
                                       / np.linalg.norm(axis)])),
]

# ---- Exercise 5: angles where the gimbal is locked ---------------------------------------------

_LOCKED = np.array([[0, -0.6, 0.8], [0, 0.8, 0.6], [-1, 0, 0]])


def _gives(R: np.ndarray, q: np.ndarray) -> str:
    off = np.abs(rpy_matrix(*q) - R)
    if off.max() <= _NEAR:
        return ""
    row, column = np.unravel_index(off.argmax(), off.shape)
    got = rpy_matrix(*q)[row, column] + 0.0
    return (f"kl.rpy_matrix makes {got:.4g} of your angles at row {row + 1}, column {column + 1}, "
            f"where R has {R[row, column]:.4g}.")


def locked_judge(R: np.ndarray) -> Judge:
    """Judge of roll, pitch and yaw of a rotation whose pitch is 90 degrees."""
    lock, left = (partial(_gives, R),), degrees(np.arctan2(-R[0, 1], R[1, 1]))
    slips: list[Slip] = [
        degrees_slip(lock, subject="Your angles", hint="give radians, np.radians([...])"),
        ("These are the usual formulas, np.arctan2(0, 0) among them. They do not apply here: read "
         "yaw - roll off the other entries.",
         lambda q: abs(q[0]) < _NEAR and abs(q[2]) < _NEAR and abs(sin(q[1]) - 1) < _NEAR),
        ("The sign of pitch is wrong: r31 = -1 is minus the sine of pitch.",
         _meets_after(lock, lambda q: q * [1, -1, 1])),
        ("The sum is right where the difference counts: at pitch = 90° it is yaw - roll.",
         _meets_after(lock, lambda q: q * [-1, 1, 1])),
        ("yaw - roll has the wrong sign, or roll and yaw have changed places: "
         "r12 = -sin(yaw - roll).", _meets_after(lock, lambda q: q[::-1])),
        ("Pitch must be a quarter turn here: r31 = -1.", lambda q: abs(sin(q[1]) - 1) > _NEAR),
    ]
    return one_of_many(
        exactly((3,), counted(3, "angle")), lock, slips=slips, noun="three angles", parts=_ANGLES,
        praise=f"One of infinitely many answers: only yaw - roll is fixed here, at {left:.2f}°.")


JUDGES: dict[str, Judge] = {
    "turns.1": function(
        _mixed, _MIXED_CASES, entry=matrix_entry, slips=_MIXED_SLIPS,
        praise="About axes of the room to the left, about own axes to the right."),
    "turns.2": function(
        lambda *angles: np.array(angles), _RPY_CASES, entry=lambda index: _ANGLES[index[0]],
        slips=_RPY_SLIPS, angles=True, prepare=lambda *angles: [rpy_matrix(*angles)],
        read=_first_branch, without="Write the three formulas yourself.",
        praise="Each angle in its quadrant. kinlab's own is kl.rpy_angles, which also tells when "
               "the gimbal is locked."),
    "turns.3": axis_judge(_ROUND),
    "turns.4": function(
        _quaternion, _QUATERNION_CASES, entry=lambda index: "wxyz"[index[0]],
        slips=_QUATERNION_SLIPS, read=_one_of_both, without="Write the formula yourself.",
        praise="q and -q are both right: they are the same turn."),
    "turns.5": locked_judge(_LOCKED),
}
