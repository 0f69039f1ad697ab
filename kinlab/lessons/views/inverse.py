"""Views of lesson 10: one method on its way, eight answers to one question, a tilted tool."""
from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from ...arms import kinematics, robots
from ...arms.motions import ROTATE, TRANSLATE, X, Z
from ...drawing.arm_scene import arm_scene
from ...drawing.controls import Knob
from ...drawing.readings import Entry
from ...drawing.scene import Step
from ...drawing.sketch import Sketch
from ...drawing.solve_picture import solve_scene
from ...ik.solve import inverse_kinematics, inverse_kinematics_batch
from ...views.live import LiveView
from ...views.studies import solve_view

_PLANE = (1, 1, 0)
_BEGAN = (0.3, 0.4, -0.5, 0.6, 0.5, 0.3)  # rad, of the Intelledex
TILT, PLACE = 20.0, (300.0, 0.0, 80.0)    # degrees and mm, of the tilted tool


def steps_view(target: tuple[float, float], q0: tuple[float, float], method: str = "newton",
               steps: int = 12) -> LiveView:
    """The two-link arm on its way to a target by one method, with the error of each step."""
    arm, goal = robots.two_link(), np.array([*target, 0.0])
    found = inverse_kinematics(arm, goal, q0, method=method, weights=_PLANE, restarts=0,
                               steps=steps)
    return LiveView(solve_scene(arm, goal, {method: found.history}))


def newton_view() -> LiveView:
    """Newton's steps from a bent arm: few, and each far better than the one before."""
    return steps_view((1.2, 0.9), (0.5, 1.0))


def leap_view() -> LiveView:
    """Newton's steps from an almost stretched arm: the first one is a leap."""
    return steps_view((0.5, 1.0), (0.2, 0.1))


def unreachable_view() -> LiveView:
    """Newton's steps towards a point that the arm does not reach."""
    return steps_view((2.0, 1.0), (0.2, 0.4))


def stop_view() -> LiveView:
    """Damped steps towards the same point."""
    return steps_view((2.0, 1.0), (0.2, 0.4), "damped", steps=15)


def race_view() -> LiveView:
    """Newton's and damped steps, from the almost stretched arm."""
    return solve_view(robots.two_link(), [0.5, 1, 0], [0.2, 0.1])


@cache
def eight_ways() -> tuple[tuple[float, ...], ...]:
    """The joint values of the Intelledex (rad) that give one pose, those of one shape together."""
    arm = robots.intelledex_660t()
    wanted = kinematics.forward_kinematics(arm, _BEGAN)
    begin = np.random.default_rng(0).uniform(-2, 2, (40, 6))
    found = inverse_kinematics_batch(arm, np.tile(wanted, (40, 1, 1)), begin)
    q = np.angle(np.exp(1j * found.q[found.success]))
    _, first = np.unique(np.round(np.exp(1j * q), 3), axis=0, return_index=True)
    return tuple(map(tuple, sorted(q[first].tolist(), key=lambda row: (_elbow(row), row))))


def _elbow(q: Any) -> float:
    """How high the elbow is (mm)."""
    return -round(float(kinematics.link_frames(robots.intelledex_660t(), q)[3, 2, 3]))


def eight_view() -> LiveView:
    """The Intelledex in all eight ways to one pose; frame 2 tells apart what looks the same."""
    arm, ways = robots.intelledex_660t(), eight_ways()
    drawing = arm_scene(arm, ways[0])
    sketch = Sketch(f"{arm.name}: eight ways to one pose", planar=False, unit=arm.unit, grid=0)
    sketch.center, sketch.radius, sketch.fit = drawing.center, drawing.radius, drawing.fit
    sketch.floor, sketch.tip = drawing.floor, drawing.tip
    sketch.presets, sketch.joints = dict(drawing.presets), ()
    sketch.steps = [_tracked(step, ways) for step in drawing.motions]
    sketch.lay(replace(item, layer="") for item in drawing.items
               if not item.layer or item.frame in ("2", "6"))
    sketch.knob(Knob("way", "way", 1.0, 8.0, 1.0, title="which of the eight ways", whole=True))
    degrees = ["(" + ", ".join(f"{value:.1f}°" for value in np.degrees(way)) + ")"
               for way in ways]
    sketch.reading("q", "q = {}", Entry(0, (degrees[0], *degrees)))
    sketch.poses = [[float(k)] for k in range(1, 9)]
    return LiveView(sketch.scene())


def _tracked(step: Any, ways: tuple[tuple[float, ...], ...]) -> Any:
    """A motion that goes from way to way where a joint drives it; way 1 stands at 0, too."""
    if not isinstance(step, Step) or step.joint is None:
        return step
    values = [step.amount + step.gain * way[step.joint] for way in (ways[0], *ways)]
    return replace(step, joint=0, track=tuple(values))


def tilt_view() -> LiveView:
    """The Alpha II above a part, and the frame of a tool that is tilted to the side."""
    arm = robots.alpha_ii()
    sketch = Sketch.of(arm, np.radians([0, -30, 60, 0, 0]), name="A tool tilted to the side",
                       keep=lambda item: not item.layer or item.frame == "5")
    sketch.items = [replace(item, layer="") for item in sketch.items]
    sketch.switches = []
    frame = sketch.move(TRANSLATE, X, PLACE[0], None, 0)
    sketch.move(TRANSLATE, Z, PLACE[2], None, frame)
    sketch.axes("*", sketch.move(ROTATE, X, np.radians(180 - TILT)), 130.0)
    return LiveView(sketch.scene())
