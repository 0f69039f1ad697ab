"""Lesson 00, start here: its view, its exercises' references and typical slips."""
from __future__ import annotations

from functools import partial
from math import cos, inf, pi, radians, sin
from typing import Any

import numpy as np

from ..answers.conditions import degrees_slip, meet, one_of_many
from ..answers.judges import Judge, choices, values
from ..arms import inputs, kinematics, robots
from ..drawing.scene import LINE, at, circle, origin_of
from ..drawing.sketch import Sketch
from ..views.live import LiveView
from . import notation

_ARM = robots.two_link()
TARGET = np.array([cos(radians(20)) + cos(radians(80)), sin(radians(20)) + sin(radians(80))])
NEAR = 0.02  # m

# ---- View: the same arm, asked forwards and backwards ----------------------------------


def reach_view() -> LiveView:
    """The two-link arm and a target that its tip may reach."""
    sketch = Sketch.of(_ARM, np.radians([-40, 60]), name="Two-link arm and a target",
                       keep=lambda item: not item.layer)
    sketch.bare()
    tip, (target,) = origin_of(sketch.tip), at(0, (*TARGET, 0))
    ring = 0.1 * circle(33) + [*TARGET, 0]
    sketch.add("target", LINE, "target", at(0, *ring), lift=sketch.radius)
    sketch.label("target", at(0, (*(TARGET + [0.07, 0.07]), 0), (*TARGET, 0)), "target")
    sketch.add("gap", LINE, "miss", (tip, target), lift=sketch.radius)
    sketch.reading("p", "forward: the tip is at p = {} m", sketch.vector(0, tip))
    sketch.reading("gap", "inverse: still to go, target - p = {} m", sketch.vector(tip, target))
    return LiveView(sketch.scene())


def colours() -> Any:
    """A picture of what the colours of all pictures, formulas and numbers mean."""
    from ..drawing.legend import colours_picture  # matplotlib: only who asks waits for it

    return colours_picture()


# ---- Exercise 1: forward or inverse? -----------------------------------------------------

_QUESTIONS = {"forward": {1, 4, 5}, "inverse": {2, 3, 6}}
_JOINTS_KNOWN = "Question {}: are the joint values given, or asked for?"
_QUESTION_HINTS = {(name, k): _JOINTS_KNOWN.format(k) for name in _QUESTIONS for k in range(1, 7)}

# ---- Exercise 2: units -------------------------------------------------------------------

_Q = np.array([pi / 3, 0.25, 0.45])
_UNIT_SLIPS = [
    ("The angle is in degrees and the lengths are not in metres.", [60, 250, 45]),
    ("The angle is still in degrees: use np.radians.", [60, 0.25, 0.45]),
    ("The angle was converted the wrong way: np.degrees makes degrees of radians.",
     [60 * 180 / pi, 0.25, 0.45]),
    ("The lengths belong in the arm's unit, metres.", [pi / 3, 250, 45]),
    ("250 mm is a quarter of a metre.", [pi / 3, 250, 0.45]),
    ("250 mm is a quarter of a metre.", [pi / 3, 2.5, 0.45]),
    ("45 cm is less than half a metre.", [pi / 3, 0.25, 45]),
    ("45 cm is less than half a metre; a metre has 100 cm.", [pi / 3, 0.25, 0.045]),
    ("The lengths are in millimetres; this arm's unit is the metre.", [pi / 3, 250, 450]),
    ("The lengths have changed places: joint 2 lifts, joint 3 reaches.", [pi / 3, 0.45, 0.25]),
]

# ---- Exercise 3: two ways to reach --------------------------------------------------------


def _two_ways(answer: Any) -> np.ndarray:
    return inputs.shaped("your answer", answer, (2, 2), "two pairs of joint values, shape (2, 2)")


def _reaches(k: int, q: np.ndarray) -> str:
    p = kinematics.forward_kinematics(_ARM, q[k])[:2, 3]
    gap = np.linalg.norm(TARGET - p)
    return "" if gap <= NEAR else (
        f"Pair {k + 1} puts the tip at ({p[0] + 0.0:.3f}, {p[1] + 0.0:.3f}) m, {gap:.3f} m from "
        f"the target; {NEAR} m is allowed.")


def _elbows_differ(q: np.ndarray) -> str:
    return "" if np.prod(np.sin(q[:, 1])) < 0 else (
        "Both pairs reach the target, but in the same way. Bend the elbow to the other side.")


_BOTH_REACH = (partial(_reaches, 0), partial(_reaches, 1))
_WAY_SLIPS = [
    degrees_slip(_BOTH_REACH, inf, subject="These"),
    ("The pairs have to be rows: each holds θ₁ and θ₂.", lambda q: meet(_BOTH_REACH, q.T)),
    ("Only the sign of θ₂ has changed; θ₁ has to make up for it.",
     lambda q: np.allclose(q[1], q[0] * [1, -1], atol=0.02)),
]

JUDGES: dict[str, Judge] = {
    "start_here.1": choices(
        _QUESTIONS, {1, 2, 3, 4, 5, 6}, _QUESTION_HINTS, noun="question",
        praise="Joint values given: forward. Joint values asked for: inverse."),
    "start_here.2": values(
        _Q, entry=lambda index: f"q[{index[0]}]", slips=_UNIT_SLIPS,
        praise="Radians for the revolute joint, metres for the two that slide."),
    "start_here.3": notation.JUDGES["notation.1"],  # under these names in copies of lesson 00
    "start_here.4": notation.JUDGES["notation.2"],  # from before lesson 03b
    "start_here.5": one_of_many(
        _two_ways, (*_BOTH_REACH, _elbows_differ), slips=_WAY_SLIPS,
        praise="One position, two answers. Forward kinematics never has that trouble: each pair "
               "of joint values has one tip."),
}
