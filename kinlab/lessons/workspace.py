"""Lesson 09, the workspace: the judges of its exercises, its predictions and its views."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import degrees, pi, radians, sin
from typing import Any

import numpy as np

from ..answers.conditions import (
    degrees_slip,
    exactly,
    meet,
    one_of_many,
    one_pose,
    within_limits,
)
from ..answers.judges import Judge, function
from ..arms import inputs, kinematics, robots
from ..arms.joints import joint_range
from .asked.workspace import PREDICTIONS
from .views.reach import reach_view
from .views.workspace import L1, L2, dexterous_view, limits_view, ring_view

__all__ = ["JUDGES", "PREDICTIONS", "dexterous_view", "limits_view", "reach_view", "ring_view"]

# ---- Exercise 1: the ring of two lengths ----------------------------------------------


def _ring(l1: float, l2: float) -> np.ndarray:
    near, far = abs(l1 - l2), l1 + l2
    return np.array([near, far, pi * (far**2 - near**2)])


def _with_area(area: Callable) -> Callable:
    def wrong(l1: float, l2: float) -> np.ndarray:
        near, far, _ = _ring(l1, l2)
        return np.array([near, far, area(near, far)])
    return wrong


_RING_CASES = [dict(zip(("l_1", "l_2"), case)) for case in ((1.0, 0.6), (0.5, 0.8), (1.0, 1.0))]

_RING_SLIPS = [
    ("A radius is never negative: what if link 2 is the longer one?",
     lambda l1, l2: np.array([l1 - l2, *_ring(l1, l2)[1:]])),
    ("The folded arm leaves a hole only if the links differ; it is not always closed.",
     lambda l1, l2: np.array([0, l1 + l2, pi * (l1 + l2) ** 2])),
    ("The area is that of the whole disc: the hole in its middle is not reached.",
     _with_area(lambda near, far: pi * far**2)),
    ("The hole is taken off as a length. Subtract areas: radii are squared first.",
     _with_area(lambda near, far: pi * (far - near) ** 2)),
    ("The area lacks the factor pi.", _with_area(lambda near, far: far**2 - near**2)),
    ("This is a circumference: an area takes the squares of the radii.",
     _with_area(lambda near, far: 2 * pi * (far - near))),
    ("Nearest and farthest have changed places.", lambda l1, l2: _ring(l1, l2)[[1, 0, 2]]),
    ("These are diameters.", lambda l1, l2: _ring(l1, l2) * [2, 2, 1]),
    ("The area of a disc is pi r², without a 2.", _with_area(
        lambda near, far: 2 * pi * (far**2 - near**2))),
    ("The area of the hole is taken off, not added.", _with_area(
        lambda near, far: pi * (far**2 + near**2))),
    ("The area is that of the hole.", _with_area(lambda near, far: pi * near**2)),
    ("Nearest and farthest are not the two links: folded, the arm is |l_1 - l_2| long, and "
     "stretched l_1 + l_2.", lambda l1, l2: np.array(
         [min(l1, l2), max(l1, l2), pi * (max(l1, l2)**2 - min(l1, l2)**2)])),
    ("Nearest is where the links lie on each other: |l_1 - l_2|. The shorter link alone is not "
     "enough.", lambda l1, l2: np.array(
         [min(l1, l2), l1 + l2, pi * ((l1 + l2)**2 - min(l1, l2)**2)])),
]

# ---- Exercise 2: an arm for a given ring ----------------------------------------------



_two_lengths = exactly((2,), "two lengths, l_1 and l_2")


def _lengths(answer: Any) -> np.ndarray:
    lengths = _two_lengths(answer)
    if min(lengths) <= 0:
        raise ValueError(f"lengths: expected two lengths above 0, got {lengths.tolist()}")
    return lengths


def _reaches_out(target: float, lengths: np.ndarray) -> str:
    far = sum(lengths)
    return "" if abs(far - target) <= 1e-3 else (f"Stretched, this arm reaches {far:.4g} m out; "
                                                 f"it should be {target} m.")


def _leaves_the_hole(target: float, out: float, lengths: np.ndarray) -> str:
    near = abs(lengths[0] - lengths[1])
    return "" if abs(near - target) <= 1e-3 else (
        f"It reaches {out} m out, but folded its tool is {near:.4g} m from the base; it should "
        f"be {target} m.")


def design_judge(near: float, far: float) -> Judge:
    """Judge of the lengths of an arm that reaches from `near` to `far`, in metres."""
    radii = (partial(_reaches_out, far), partial(_leaves_the_hole, near, far))
    slips = [
        ("These are the radii themselves. Their sum and difference are the wrong way round: "
         "l_1 + l_2 and |l_1 - l_2| are the radii.",
         lambda q: np.allclose(sorted(q), [near, far], atol=1e-3)),
        (f"They are half of what they should be: {near} m and {far} m are radii, not diameters.",
         lambda q: meet(radii, 2 * q)),
        ("They are twice what they should be: halve the sum and the difference.",
         lambda q: meet(radii, q / 2)),
        ("Lengths are in metres.", lambda q: meet(radii, q / 100) or meet(radii, q / 1000)),
        ("Links of equal length leave no hole: folded, the tool is at the base.",
         lambda q: np.isclose(q[0], q[1], atol=1e-3)),
    ]
    return one_of_many(
        _lengths, radii, slips=slips, noun="two lengths",
        praise="This arm reaches just that ring. So does the one with its links exchanged.")


# ---- Exercise 3: a wall ---------------------------------------------------------------

_BENDS = np.radians(np.linspace(0, 90, 91))
_NARROWEST = radians(0.1)


_two_limits = exactly((2,), "the lowest and the highest theta_1")


def _range(answer: Any) -> np.ndarray:
    limits = _two_limits(answer)
    if limits[0] >= limits[1]:
        raise ValueError("limits: expected the lowest value before the highest, got "
                         f"{inputs.brief(limits.tolist())}")
    return limits


def _stays_above(l_1: float, l_2: float, limits: np.ndarray) -> str:
    """The lowest place of the tool, at a limit of joint 1 or wherever between them it is."""
    turns = np.linspace(limits[0], limits[1], 721)[:, None]
    height = l_1 * np.sin(turns) + l_2 * np.sin(turns + _BENDS)
    if height.min() >= -1e-3:
        return ""
    i, j = np.unravel_index(height.argmin(), height.shape)
    return (f"At theta_1 = {degrees(turns[i, 0]):.4g}°, theta_2 = {degrees(_BENDS[j]):.3g}° the "
            f"tool is at y = {height[i, j]:.3f} m, in the wall.")


def _is_widest(askew: float, limits: np.ndarray) -> str:
    spare = (pi - askew) - (limits[1] - limits[0])
    return "" if spare <= _NARROWEST else (
        "The tool stays clear of the wall, but the range could be wider by "
        f"{degrees(spare):.3g}°.")


def wall_judge(l_1: float, l_2: float) -> Judge:
    """Judge of the widest limits of joint 1 that keep the tool before a wall (m)."""
    askew = float(np.arctan2(l_2 * np.sin(_BENDS), l_1 + l_2 * np.cos(_BENDS)).max())
    clear = (partial(_stays_above, l_1, l_2), partial(_is_widest, askew))
    slips = [
        degrees_slip(clear, subject="These", hint="write np.radians([...])"),
        ("These are the limits for an elbow that bends to the other side.",
         lambda q: np.allclose(q, [askew, pi], atol=2e-3)),
        ("At 180° link 1 lies along the wall; where does link 2 point once it is bent?",
         lambda q: np.isclose(q[1], pi, atol=1e-2)),
        ("Link 2 may point down, as long as its end stays above the wall.",
         lambda q: np.isclose(q[1], pi / 2, atol=1e-2)),
        ("That is for an elbow that bends as far as it likes; this one stops at 90°.",
         lambda q: np.isclose(q[1], pi - np.arcsin(l_2 / l_1), atol=1e-3)),
        ("This is the angle at which the tool appears. The upper limit is where that direction "
         "lies along the wall: take it from 180°.", lambda q: np.isclose(q[1], askew, atol=2e-3)),
        (f"Opposite over adjacent: at 90° the tool is l_2 = {l_2:g} m beside the end of link 1, "
         f"which is l_1 = {l_1:g} m long.", lambda q: np.isclose(q[1], pi / 2 + askew, atol=2e-3)),
    ]
    return one_of_many(
        _range, clear, slips=slips, noun="two limits",
        praise="As wide as can be. The upper limit is where the bent arm points along the wall.")


# ---- Exercises 4 and 5: the Alpha II, close to its shoulder and towards a far point -----

_ARM = robots.alpha_ii()
_SHOULDER = np.array([0, 0, _ARM.links[0].d])
_FORE, _TOOL = _ARM.links[2].a, _ARM.links[4].d
_CLOSEST = 2 * _FORE * sin((pi - joint_range(_ARM, 2)[1]) / 2) - _TOOL


def _gap(q: np.ndarray, point: np.ndarray) -> float:
    return float(np.linalg.norm(kinematics.forward_kinematics(_ARM, q)[:3, 3] - point))


def _close(point: np.ndarray, least: float, what: str) -> Callable[[np.ndarray], str]:
    def condition(q: np.ndarray) -> str:
        gap = _gap(q, point)
        return "" if gap <= least + 0.5 else (f"The tip is {gap:.1f} mm from {what}; it can come "
                                              "closer.")
    return condition


_POSE = one_pose(_ARM)
_NEAR_SHOULDER = (within_limits(_ARM), _close(_SHOULDER, _CLOSEST, "the shoulder"))

_FOLD_SLIPS = [
    degrees_slip(_NEAR_SHOULDER),
    ("The elbow is bent as far as it goes, but the tool points away from the shoulder.",
     lambda q: _gap(q, _SHOULDER) > _CLOSEST + 1.9 * _TOOL and abs(abs(q[2]) - 3 * pi / 4) < 1e-3),
    ("Bent to this side, the tool pitch cannot follow far enough: its range is not the same to "
     "both sides of the straight tool.", lambda q: q[2] < -1),
    ("The tool is straight at theta_4 = -90°, not at 0: count its bend from there.",
     lambda q: meet(_NEAR_SHOULDER, q - [0, 0, 0, pi / 2, 0])),
    ("Fold the elbow as far as its limit lets it.", lambda q: q[2] < radians(134)),
    ("The elbow is folded. Now let the tool point from the wrist to the shoulder: two sides of "
     "that triangle are equal.", lambda q: abs(q[2] - 3 * pi / 4) < 1e-3),
]


def misses(ahead: float, high: float) -> float:
    """How far from such a point the stretched arm ends (mm)."""
    return float(np.linalg.norm([ahead, 0.0, high] - _SHOULDER)) - 2 * _FORE - _TOOL


def nearest_judge(ahead: float, high: float) -> Judge:
    """Judge of the pose nearest to a point that is out of reach, at y = 0 (mm)."""
    target, above, short = np.array([ahead, 0.0, high]), high - _SHOULDER[2], misses(ahead, high)
    conditions = (within_limits(_ARM), _close(target, short, "the target"))
    slips = [
        degrees_slip(conditions),
        ("The sign of theta_2 is wrong: positive angles lower the arm.",
         lambda q: meet(conditions, q * [1, -1, 1, 1, 1])),
        ("The arm points to the target as seen from the floor; see it from the shoulder.",
         lambda q: np.isclose(q[1], -np.arctan2(high, ahead), atol=1e-3)),
        ("The tool is straight at theta_4 = -90°, not at 0.",
         lambda q: meet(conditions, q - [0, 0, 0, pi / 2, 0])),
        ("The target lies straight ahead, at y = 0: joint 1 has nothing to turn.",
         lambda q: meet(conditions, q * [0, 1, 1, 1, 1])),
        ("The angle of a line is atan2(height, distance): the two have changed places.",
         lambda q: np.isclose(q[1], -np.arctan2(ahead, above), atol=1e-3)),
        ("A bent arm is shorter than a stretched one.",
         lambda q: abs(np.sin(q[2])) > 0.02 or abs(np.cos(q[3])) > 0.02),
    ]
    return one_of_many(
        _POSE, conditions, slips=slips,
        praise="Stretched straight towards the target, as seen from the shoulder, and still "
               f"{short:.0f} mm short. The tool roll is free.")


JUDGES: dict[str, Judge] = {
    "workspace.1": function(
        _ring, _RING_CASES, slips=_RING_SLIPS,
        entry=lambda index: ("nearest", "farthest", "the area")[index[0]],
        praise="The area is also 4 pi l_1 l_2: for a given reach l_1 + l_2 it is largest when "
               "both links are equally long."),
    "workspace.2": design_judge(0.4, 2.2),
    "workspace.3": wall_judge(L1, L2),
    "workspace.4": one_of_many(
        _POSE, _NEAR_SHOULDER, slips=_FOLD_SLIPS,
        praise="About 6.6 mm: elbow at its limit, tool folded back. Joints 1, 2 and 5 are free; "
               "they do not change the distance from the shoulder."),
    "workspace.5": nearest_judge(600, 500),
}
