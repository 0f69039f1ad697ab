"""An arm, the ring that it is to reach, and what is missing."""
from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import forward_kinematics
from ..arms.motions import TRANSLATE, Numbers
from .controls import Knob, Target
from .readings import Point, Vector
from .scene import LINE, TEXT, Scene, at, circle, origin_of
from .sketch import Sketch


def target_scene(arm: Arm, q: Numbers) -> Scene:
    """The arm at joint values `q`, a ring at its tool, and a dashed line between them.

    The coordinates of the ring are knobs after the joints: x and y of a planar arm, else x, y, z.
    """
    sketch = Sketch.of(arm, q, show=("frames", "labels", "names"))
    axes, places = 2 if sketch.planar else 3, [*sketch.poses, sketch.start]
    tools = forward_kinematics(arm, np.array(places))[:, :3, 3]
    *sketch.poses, sketch.start = ([*pose, *tool[:axes]] for pose, tool in zip(places, tools))
    ring = _ring_frame(sketch, axes, tools[-1])
    _ring(sketch, ring)
    tip, goal = map(origin_of, (sketch.tip, ring))
    sketch.add("miss", LINE, "miss", (tip, goal), lift=4 * sketch.radius)
    _coordinates(sketch, axes, ("target", "p*", goal), ("tool", "p", tip))
    if sketch.floor:
        sketch.floor = replace(sketch.floor, drops=(sketch.tip, ring))
    sketch.handles = []  # the target lies at the tool
    sketch.handle("target", goal, *range(arm.n, arm.n + axes))
    sketch.target = Target(ring, sketch.tip, arm.n, tuple(range(arm.n, arm.n + axes)), arm.unit)
    return sketch.scene()


def _ring_frame(sketch: Sketch, axes: int, place: np.ndarray) -> int:
    """A frame at the target: a knob moves it along each axis; a planar arm keeps its height."""
    for axis in range(3):
        knob = sketch.knob(_knob(sketch, axis, place)) if axis < axes else None
        height = 0.0 if axis < axes else float(place[axis])
        sketch.move(TRANSLATE, axis, height, knob, None if axis else 0)
    return len(sketch.steps)


def _knob(sketch: Sketch, axis: int, place: np.ndarray) -> Knob:
    low, high = (sketch.center[axis] + side * sketch.radius for side in (-1, 1))
    letter = "xyz"[axis]
    knob = Knob.length(letter, f"{letter}*", low, high, float(place[axis]), sketch.unit,
                       f"target along {letter}")
    return replace(knob, quantity="target")


def _ring(sketch: Sketch, frame: int) -> None:
    """Three circles, so that a ring is seen from every side, and a star beside it."""
    body, size = sketch.body(), sketch.radius
    for k in range(3):
        ring = np.roll(0.045 * size * circle(25), k, axis=1)
        sketch.add(f"target-{k}", LINE, "target", at(frame, *ring), lift=5 * size, body=body)
    sketch.add("target-name", TEXT, "target", at(frame, (0.09 * size, 0.05 * size, 0.05 * size)),
               "p*")


def _coordinates(sketch: Sketch, axes: int, *named: tuple[str, str, Point]) -> None:
    """Where something is, seen from the room."""
    for name, letter, place in named:
        sketch.reading(name, f"{name} {letter} = {{}} {sketch.unit}",
                       Vector(origin_of(0), place, size=axes))
