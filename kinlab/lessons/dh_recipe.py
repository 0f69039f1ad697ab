"""Lesson 05, the DH recipe: a view of its two rules, and the judges of its exercises."""
from __future__ import annotations

from collections.abc import Callable
from math import pi, radians
from typing import Any

import numpy as np

from ..answers.judges import choices, values
from ..arms.motions import ROTATE, TRANSLATE, X, Y, Z
from ..drawing.scene import Vector, at
from ..drawing.sketch import Sketch
from ..views.link_view import motions_view, parameters_view
from ..views.live import Knob, LiveView
from . import _dh_recipe_exam

__all__ = ["JUDGES", "motions_view", "parameters_view", "rules_view"]


def rules_view() -> LiveView:
    """Frame 1 that may break the rules: its x axis tilts towards z0, or misses it."""
    sketch = Sketch("The two rules", 3.0, planar=False)
    tilt = sketch.knob(Knob.angle("tilt", "tilt", -radians(50), radians(50), radians(25)))
    miss = sketch.knob(Knob.length("miss", "miss", -1.5, 1.5, 1.0))
    upright = sketch.move(ROTATE, Y, -pi / 2)  # its x axis is z0
    sketch.move(ROTATE, Z, radians(20), parent=0)
    foot = sketch.move(TRANSLATE, Z, 1.5)
    side = sketch.move(TRANSLATE, Y, 0, miss)
    sketch.move(ROTATE, Y, 0, tilt)
    sketch.move(TRANSLATE, X, 2.0)
    frame = sketch.move(ROTATE, X, -radians(60))
    across = sketch.move(ROTATE, Z, pi / 2, parent=foot)  # its x axis points along the miss
    sketch.line("z-line", at(0, (0, 0, -1), (0, 0, 2.8)), "axis")
    sketch.line("x-line", at(frame, (-4, 0, 0), (0, 0, 0)))
    ends = [at(end, (0, 0, 0))[0] for end in (foot, side)]
    sketch.arrow("gap", *ends)
    sketch.axes("0", 0)
    sketch.axes("1", frame)
    sketch.tip = frame
    sketch.reading("rule 1", "Rule 1: x₁ · z₀ = {}, should be 0", Vector(
        *at(frame, (0, 0, 0), (1, 0, 0)), upright, 1))
    sketch.reading("rule 2", "Rule 2: x₁ passes z₀ at {}, should be 0",
                   Vector(*ends, across, 1))
    columns = [{"name": f"{name}₁", "title": f"{name} of frame 1"} for name in "xyzo"]
    return sketch.view(panels={"pose": {"title": "H, frame 1 seen from frame 0", "unit": "",
                                        "columns": columns, "decimals": 3}})


# ---- Exercise 1: which transforms keep the rules --------------------------------------

_KEPT = {"rule 1": {1, 3, 4, 5}, "rule 2": {1, 2, 4}, "links": {1, 4}}
_BOTH = "A link keeps both rules, and a transform that keeps both is a link."
_RULE_HINTS = {
    ("rule 1", 2): "Where does Ry(90°) take the x axis?",
    ("rule 1", 3): "A slide turns no axis.",
    ("rule 1", 4): "Rz turns x, but only in the plane perpendicular to z.",
    ("rule 1", 5): "Rx(90°) leaves the x axis where it is.",
    ("rule 1", 6): "Ry tilts the x axis out of the plane perpendicular to z.",
    ("rule 2", 2): "The two lines share the origin: they meet, even if not at a right angle.",
    ("rule 2", 3): "The line through (0, 1, 0) along x0: how near does it come to z0?",
    ("rule 2", 4): "x1 points along y0 and starts at (0, 1, 0): follow the line backwards.",
    ("rule 2", 5): "Tz slides along the z axis after the turn, which is -y0: x1 is carried off.",
    ("rule 2", 6): "The slide by 1 along the new y carries x1 off sideways.",
    **{("links", k): _BOTH for k in range(1, 7)},
}

# ---- Exercise 6: parameters from a matrix ---------------------------------------------

_MEASURED = np.array([radians(150), 0.3, -0.5, radians(-60)])
_MEASURE_SLIPS = [
    ("The angles are in degrees; give radians.", np.degrees(_MEASURED) * [1, 0, 0, 1]
     + _MEASURED * [0, 1, 1, 0]),
    ("a is a signed length: O_i lies against x_i here.", np.abs(_MEASURED) * [1, 1, 1, -1]),
    ("A tangent leaves two quadrants open: np.arctan2 takes sine and cosine.",
     _MEASURED - [pi, 0, 0, 0]),
    ("theta would fit the origin, but not the x axis: column 1 is (cos theta, sin theta, 0).",
     [radians(-30), 0.3, 0.5, radians(-60)]),
    ("The sign of alpha is wrong: sin alpha stands in row 3, column 2.", _MEASURED * [1, 1, 1, -1]),
    ("d and a have changed places.", _MEASURED[[0, 2, 1, 3]]),
]

JUDGES: dict[str, Callable[[Any], str]] = {
    "dh_recipe.1": choices(
        _KEPT, {1, 2, 3, 4, 5, 6}, _RULE_HINTS, noun="transform",
        praise="Each rule takes away one freedom; 4 shows that turning x can repair a miss."),
    **_dh_recipe_exam.JUDGES,
    "dh_recipe.6": values(
        _MEASURED, entry=lambda index: ("theta", "d", "a", "alpha")[index[0]],
        slips=_MEASURE_SLIPS,
        praise="Four numbers out, and the four motions lead back to the same matrix."),
}
