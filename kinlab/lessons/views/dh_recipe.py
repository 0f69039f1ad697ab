"""Views of the lessons on the DH recipe: its two rules."""
from __future__ import annotations

from dataclasses import replace
from math import pi, radians

from ...arms.motions import ROTATE, TRANSLATE, X, Y, Z
from ...drawing.controls import Knob, PoseTable
from ...drawing.readings import Vector
from ...drawing.scene import at, circle, origin_of
from ...drawing.sketch import Sketch
from ...views.live import LiveView

_SIDE = 0.32       # of a right-angle mark
_LEVEL, _NEAR = radians(0.5), 0.01  # as far as a rule counts as kept
_LEANS, _PASSES = radians(50), 1.5


def rules_view() -> LiveView:
    """Frame 1 that may break the rules: its x axis tilts towards z0, or misses it.

    The tilt is an arc, the miss a dimension line, each with its value. A right-angle mark and a
    ring where the lines meet are green while their rule is kept.
    """
    sketch = Sketch("The two rules", 2.25, center=(0.3, 0.3, 1.1), planar=False)
    tilt = sketch.knob(Knob.angle("tilt", "tilt", -_LEANS, _LEANS, radians(25),
                                  "how far x₁ leans out of square with z₀"))
    miss = sketch.knob(Knob.length("miss", "miss", -_PASSES, _PASSES, 1.0,
                                   title="how far the line of x₁ passes z₀"))
    upright = sketch.move(ROTATE, Y, -pi / 2)  # its x axis is z0
    sketch.move(ROTATE, Z, radians(20), parent=0)
    foot = sketch.move(TRANSLATE, Z, 1.5)
    side = sketch.move(TRANSLATE, Y, 0, miss)
    leaning = sketch.move(ROTATE, Y, 0, tilt)
    sketch.move(TRANSLATE, X, 2.0)
    frame = sketch.move(ROTATE, X, -radians(60))
    across = sketch.move(ROTATE, Z, pi / 2, parent=foot)  # its x axis points along the miss
    sketch.line("z-line", at(0, (0, 0, -0.6), (0, 0, 2.8)), "axis")
    sketch.line("x-line", at(frame, (-3, 0, 0), (0, 0, 0)))
    _square(sketch, side, leaning, tilt)
    _gap(sketch, foot, side, miss)
    sketch.axes("0", 0)
    sketch.axes("1", frame)
    sketch.tip = frame
    sketch.sights = ("z₀", "x₁")
    origin, unit = at(frame, (0, 0, 0), (1, 0, 0))
    sketch.reading("rule 1", "Rule 1, x₁ ⊥ z₀: x₁ · z₀ = {}, should be 0. Tilt is how far x₁ leans "
                   "out of square.", Vector(origin, unit, upright, 1))
    sketch.reading("rule 2", "Rule 2, x₁ meets z₀: they pass at {}, should be 0. That is the miss.",
                   Vector(origin_of(foot), origin_of(side), across, 1))
    sketch.pose = PoseTable.of_frame("H, frame 1 seen from frame 0", "1", "xyz")
    return LiveView(sketch.scene())


def _square(sketch: Sketch, side: int, leaning: int, tilt: int) -> None:
    """The corner between x1 and the direction of z0, and the tilt that spoils it."""
    sketch.move(TRANSLATE, Z, _SIDE, parent=side)
    corner = sketch.move(ROTATE, Y, 0, tilt)
    mark = (*at(side, (0, 0, _SIDE)), *at(corner, (_SIDE, 0, 0)), *at(leaning, (_SIDE, 0, 0)))
    sketch.line("z-beside", at(side, (0, 0, -0.3), (0, 0, 0.8)), "axis")
    sketch.line("square-kept", mark, "holds", part="right", when=(tilt, -_LEVEL, _LEVEL))
    sketch.label("90°", (*at(corner, (_SIDE, 0, 0)), origin_of(side)), "holds",
                 when=(tilt, -_LEVEL, _LEVEL))
    place, first = (1.1, 0, 0), len(sketch.items)
    half = sketch.sweep("tilt", leaning, place)[8]
    sketch.label("", at(half, place, (0, 0, 0)), "angle", size=(tilt,))
    sketch.line("level", at(side, (0, 0, 0), (1.3, 0, 0)))
    sketch.line("square-broken", mark, "miss", part="right")
    _unless(sketch, first, tilt, _LEVEL)


def _gap(sketch: Sketch, foot: int, side: int, miss: int) -> None:
    """The way from z0 to the line of x1, or a ring where they meet."""
    ring = [at(foot, (0.13 * c, 0, 0.13 * s))[0] for c, s, _ in circle(33)]
    sketch.line("meeting", ring, "holds", part="right", when=(miss, -_NEAR, _NEAR))
    first = len(sketch.items)
    sketch.arrow("gap", origin_of(foot), origin_of(side), "length")
    half = sketch.move(TRANSLATE, Y, 0, miss, foot, gain=0.5)
    sketch.label("", at(half, (0, 0, 0), (0, 0, 0.2)), "length", size=(miss,))
    _unless(sketch, first, miss, _NEAR)


def _unless(sketch: Sketch, first: int, knob: int, near: float) -> None:
    """Items from a number on are there unless a knob is this near to 0."""
    sketch.items[first:] = [replace(item, when=(knob, near, -near))
                            for item in sketch.items[first:]]
