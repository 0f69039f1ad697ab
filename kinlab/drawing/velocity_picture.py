"""What each joint does to the tool: the Jacobian's columns and the velocity ellipse, drawn."""
from __future__ import annotations

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import typical_length
from ..arms.link import REVOLUTE
from ..arms.motions import Numbers
from .controls import Switch, subscript
from .readings import Vector, Volume
from .scene import ARROW, HULL, TEXT, Scene, Velocity, at, circle, origin_of
from .sketch import Sketch

SECONDS = 0.3  # of motion that an arrow shows
_SWITCHES = [Switch("columns", "Columns", "Columns of the Jacobian", True),
             Switch("ellipse", "Ellipse", "All velocities of joint rates of length 1", True)]


def velocity_scene(arm: Arm, q: Numbers) -> Scene:
    """The arm, an arrow for each column of its Jacobian, and the ellipse of all velocities."""
    sketch = Sketch.of(arm, q, name=f"{arm.name or 'Arm'}: velocities")
    sketch.switches = _SWITCHES + sketch.switches
    rates = tuple(SECONDS * (1.0 if link.kind == REVOLUTE else typical_length(arm))
                  for link in arm.joints)
    _ellipse(sketch, rates)
    for i, rate in enumerate(rates):
        _column(sketch, i, rates)
        _column_reading(sketch, i, arm.joints[i].kind == REVOLUTE, rate)
    if sketch.planar:
        formula = "|det J|" if arm.n == 2 else "√det(J Jᵀ)"
        sketch.reading("w", f"w = {formula} = {{}} {arm.unit}²",
                       Volume(sketch.tip + 1, 2, SECONDS ** -2))
    return sketch.scene()


def _ellipse(sketch: Sketch, rates: tuple[float, ...]) -> None:
    """The image of a circle, or of points all over a sphere, under everything."""
    sketch.steps.append(Velocity(sketch.tip, rates))
    points = circle(61)[:-1] if sketch.planar else _sphere(100)
    sketch.add("ellipse", HULL, "ellipse", at(len(sketch.steps), *points), body=-1,
               layer="ellipse", part="ellipse")


def _column(sketch: Sketch, i: int, rates: tuple[float, ...]) -> None:
    """An arrow with its name, nearer than the arm."""
    sketch.steps.append(Velocity(sketch.tip, rates, i))
    frame = len(sketch.steps)
    sketch.add(f"column-{i + 1}", ARROW, "vector",
               (origin_of(sketch.tip), origin_of(frame)), lift=2 * sketch.radius,
               layer="columns", part="column", joint=i + 1)
    sketch.add(f"column-name-{i + 1}", TEXT, "ink", (origin_of(frame), origin_of(sketch.tip)),
               f"J{subscript(i + 1)}", layer="columns", part="label", joint=i + 1)


def _column_reading(sketch: Sketch, i: int, turns: bool, rate: float) -> None:
    """The column in its own unit."""
    tail, head = map(origin_of, (sketch.tip, len(sketch.steps)))
    vector = Vector(tail, head, size=2 if sketch.planar else 3,
                    scale=1 / (SECONDS if turns else rate))
    unit = f" {sketch.unit}/rad" if turns else ""
    sketch.reading(f"J{i + 1}", f"J{subscript(i + 1)} = {{}}{unit}", vector)


def _sphere(count: int) -> np.ndarray:
    """Points spread evenly over the unit sphere, along a spiral, and on three great circles.

    A flat ellipsoid has one of those as its rim.
    """
    height = 1 - 2 * (np.arange(count) + 0.5) / count
    angles, radius = np.pi * (1 + 5 ** 0.5) * np.arange(count), np.sqrt(1 - height ** 2)
    spiral = np.stack([radius * np.cos(angles), radius * np.sin(angles), height], axis=-1)
    rims = [np.roll(circle(61)[:-1], k, axis=1) for k in range(3)]
    return np.round(np.concatenate([spiral, *rims]), 4)
