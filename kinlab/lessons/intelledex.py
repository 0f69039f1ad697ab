"""Lesson 08, the Intelledex 660T: views, predictions, references of its exercises, and slips."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import cos, degrees, pi, radians, sin

import numpy as np

from ..answers.conditions import degrees_slip, one_of_many, one_pose
from ..answers.judges import Judge, Slip, choices, expressions
from ..answers.table_judge import column, table, with_columns
from ..arms import kinematics, robots
from .asked.intelledex import PREDICTIONS
from .views.intelledex import meeting_view, plane_view, turned_round, wrist_view, yaw_view

__all__ = ["JUDGES", "PREDICTIONS", "meeting_view", "plane_view", "turned_round", "wrist_view",
           "yaw_view"]

_ARM = robots.intelledex_660t()
_JOINTS = tuple(f"theta_{i}" for i in range(1, 7))

# ---- Exercise 1: the table ----------------------------------------------------------------------

_table = partial(with_columns, _ARM)
_ALPHA, _A, _D = (column(_ARM, name) for name in ("alpha", "a", "d"))
_TABLE_SLIPS = [
    ("The twist of row 5 is missing: z5, the tool roll, is perpendicular to z4.",
     _table(alpha=_ALPHA * [1, 1, 1, 1, 0, 1])),
    ("The twist of row 2 is missing: the pitch axis z2 is perpendicular to the roll axis z1.",
     _table(alpha=_ALPHA * [1, 0, 1, 1, 1, 1])),
    ("The tool is forgotten: d = 228.6 in row 6.", _table(d=_D * [1, 1, 1, 1, 1, 0])),
    ("The tool lies along z, so 228.6 is a link offset d, not a link length a.",
     _table(a=_A + [0, 0, 0, 0, 0, 228.6], d=_D * [1, 1, 1, 1, 1, 0])),
    ("The column is forgotten: d = 373.4 in row 1.", _table(d=_D * [0, 1, 1, 1, 1, 1])),
    ("The links lie along x, so 304.8 is a link length a, not a link offset d.",
     _table(a=0 * _A, d=_D + [0, 0, 304.8, 304.8, 0, 0])),
    ("The links stand one row too high: a = 304.8 belongs to rows 3 and 4.",
     _table(a=np.roll(_A, -1))),
]

# ---- Exercise 2: the wrist ----------------------------------------------------------------------


def _wrist(t1: float, t2: float, t3: float, t4: float, *, height: float = 373.4,
           forearm: Callable = lambda t3, t4: t3 + t4, forearm_length: float = 304.8,
           upper_arm: float = 304.8, side: int = 1, c34: Callable | None = None,
           s34: Callable | None = None) -> list[float]:
    swing = forearm(t3, t4)
    out = upper_arm * cos(t3) + forearm_length * (c34(t3, t4) if c34 else cos(swing))
    along = upper_arm * sin(t3) + forearm_length * (s34(t3, t4) if s34 else sin(swing))
    return [out * cos(t1) * cos(t2) + side * along * sin(t1),
            out * sin(t1) * cos(t2) - side * along * cos(t1), height + out * sin(t2)]


def _some(c34: Callable, s34: Callable) -> list[tuple]:
    """A wrong formula for the cosine, for the sine, or for both."""
    return [(c34, s34), (c34, None), (None, s34)]


_WRIST_POINTS = [dict(zip(_JOINTS, q)) for q in
                 ((0.3, -0.5, 0.8, -1.1), (-1.2, 0.9, 0.4, 0.7), (2.0, 0.2, -0.6, 1.5))]
_WRIST_SLIPS: list[Slip] = [
    ("The forearm is forgotten: joint 4 swings a4 = 304.8.", partial(_wrist, forearm_length=0.0)),
    ("The forearm is turned by theta_3 + theta_4, not by theta_4 alone.",
     partial(_wrist, forearm=lambda t3, t4: t4)),
    ("The forearm is turned by theta_3 + theta_4, not by theta_3 alone.",
     partial(_wrist, forearm=lambda t3, t4: t3)),
    *(("The forearm is turned by theta_3 + theta_4: C34 is the cosine of the sum, not the sum of "
       "two cosines.", partial(_wrist, c34=c34, s34=s34)) for c34, s34 in _some(
           lambda t3, t4: cos(t3) + cos(t4), lambda t3, t4: sin(t3) + sin(t4))),
    *(("C34 is cos(theta_3 + theta_4), not a product of two cosines.",
       partial(_wrist, c34=c34, s34=s34)) for c34, s34 in _some(
           lambda t3, t4: cos(t3) * cos(t4), lambda t3, t4: sin(t3) * sin(t4))),
    ("The upper arm is forgotten: joint 3 swings a3 = 304.8.", partial(_wrist, upper_arm=0.0)),
    ("This is the tip of a tool held straight; the wrist is where the forearm ends.",
     partial(_wrist, forearm_length=304.8 + 228.6)),
    ("The roll of the shoulder, theta_2, is left out: it tilts the plane in which the arm bends.",
     lambda t1, t2, t3, t4: _wrist(t1, 0, t3, t4)),
    ("Joint 1 is left out: it turns the whole arm about the vertical.",
     lambda t1, t2, t3, t4: _wrist(0, t2, t3, t4)),
    ("theta_1 and theta_2 have changed places.", lambda t1, t2, t3, t4: _wrist(t2, t1, t3, t4)),
    ("The sign in w_z is wrong: u = (C1 C2, S1 C2, S2), so the part along u adds to the height.",
     lambda t1, t2, t3, t4: _wrist(t1, -t2, t3, t4)),
    ("The height of the shoulder, 373.4, is missing in w_z.", partial(_wrist, height=0.0)),
    ("The sign of the part along v is wrong: v = (S1, -C1, 0).", partial(_wrist, side=-1)),
    ("The components w_x and w_y have changed places.",
     lambda *q: [_wrist(*q)[k] for k in (1, 0, 2)]),
    ("This is in metres; the lengths are in millimetres.",
     lambda *q: [part / 1000 for part in _wrist(*q)]),
]

# ---- Exercise 3: which joints -------------------------------------------------------------------

_CHANGES = {"wrist": {1, 2, 3, 4}, "p_z": {2, 3, 4, 5}, "a": {1, 2, 3, 4, 5}}
_HINTS = {
    ("wrist", 4): "The elbow pitch swings the forearm, and the wrist is at its end.",
    ("wrist", 5): "The wrist lies on the axis of joint 5.",
    ("wrist", 6): "The wrist lies on the axis of joint 6.",
    ("p_z", 1): "Joint 1 turns about the vertical.",
    ("p_z", 2): "Bend the arm first; then roll the shoulder.",
    ("p_z", 6): "The tip lies on the axis of joint 6.",
    ("a", 2): "Bend the tool first; then roll the shoulder.",
    ("a", 6): "The approach vector lies along the axis of joint 6.",
}

# ---- Exercise 4: yaw ----------------------------------------------------------------------------

_WRIST_HOME = np.array([609.6, 0.0, 373.4])


def _wrist_stays(q: np.ndarray) -> str:
    away = float(np.linalg.norm(kinematics.link_frames(_ARM, q)[5, :3, 3] - _WRIST_HOME))
    return f"The wrist is {away:.4g} mm away from (609.6, 0, 373.4)." if away > 0.1 else ""


def _points(q: np.ndarray, wanted: np.ndarray) -> bool:
    """Whether the wrist is in place and the tool points there."""
    a = kinematics.forward_kinematics(_ARM, q)[:3, 2]
    return not _wrist_stays(q) and np.allclose(a, wanted, atol=1e-4)


def _points_left(yaw: float, q: np.ndarray) -> str:
    a, left = kinematics.forward_kinematics(_ARM, q)[:3, 2], _level(yaw)
    angle = degrees(np.arctan2(np.linalg.norm(np.cross(a, left)), a @ left))
    return (f"The approach vector is ({a[0]:.3f}, {a[1]:.3f}, {a[2]:.3f}), {angle:.4g}° away from "
            f"{yaw}° to the left." if angle > 0.01 else "")


def _level(yaw: float) -> np.ndarray:
    return np.array([cos(radians(yaw)), sin(radians(yaw)), 0.0])


def yaw_judge(yaw: int) -> Judge:
    """Judge of joint values that yaw the tool to the left (degrees) while the wrist stays."""
    conditions = (_wrist_stays, partial(_points_left, yaw))
    slips = [
        degrees_slip(conditions, 4 * pi),
        (f"It points {yaw}° to the right; joint 5 turns the other way.",
         lambda q: _points(q, _level(-yaw))),
        ("The tool is still in line with the forearm, as it is at theta_5 = 90°. Bend it from "
         "there.", lambda q: _points(q, _level(0))),
        ("Without a roll of the shoulder the tool can only nod up and down.",
         lambda q: not _wrist_stays(q) and abs(cos(q[1])) < 1e-6),
        ("Turning the base swings the whole arm. The wrist has to stay.",
         lambda q: not np.allclose(q[0], pi / 2)),
    ]
    return one_of_many(
        one_pose(_ARM), conditions, slips=slips,
        praise="A pitch joint has yawed the tool, and the wrist has not moved.")


JUDGES: dict[str, Judge] = {
    "intelledex.1": table(
        _ARM, ends=True, slips=_TABLE_SLIPS,
        praise="Add a cell with kl.ArmView(my_arm) and see it."),
    "intelledex.2": expressions(
        ("w_x", "w_y", "w_z"), _wrist, _WRIST_POINTS,
        constants={"d_1": 373.4, "a_3": 304.8, "a_4": 304.8}, slips=_WRIST_SLIPS,
        praise="Four joints place the wrist of this arm."),
    "intelledex.3": choices(
        _CHANGES, set(range(1, 7)), _HINTS,
        praise="The wrist needs four joints, so no three joints place it."),
    "intelledex.4": yaw_judge(45),
}
