"""What each joint does to the tool: the Jacobian's columns and the velocity ellipse, drawn."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..arms.arm import Arm
from ..arms.joints import first_pose
from ..arms.kinematics import typical_length
from ..arms.link import REVOLUTE
from ..drawing.arm_scene import arm_scene, is_planar
from ..drawing.scene import (
    ARROW,
    PLANAR,
    SOLID,
    TEXT,
    Item,
    Reading,
    Scene,
    Vector,
    Volume,
    at,
    circle,
    subscript,
)
from ..drawing.velocity import Velocity
from .arm_view import joint_knob, layers, pose_table, switches, tour
from .live import LiveView

SECONDS = 0.3  # of motion that an arrow shows
_SWITCHES = (("columns", "Columns", "Columns of the Jacobian"),
             ("ellipse", "Ellipse", "All velocities of joint rates of length 1"))


def velocity_view(arm: Arm, q: Any = None, *, show: Sequence[str] = ()) -> LiveView:
    """The columns of the Jacobian as arrows at the tool, and the velocity ellipse round it.

    Column i is the velocity of the tool point while joint i alone moves: at 1 rad/s if it turns,
    at one reach of the arm per second if it slides. The ellipse (in space an ellipsoid) holds the
    velocities of all joint rates whose squares add up to at most 1. The arrows show 0.3 s.

    Parameters
    ----------
    arm : Arm
    q : array, shape (n,), optional
        Joint values to begin with (rad or length); the arm's home if left out.
    show : sequence of {"frames", "labels", "axes", "trace", "ghost"}
        What is switched on besides.

    Returns
    -------
    LiveView
        Its knobs are the arm's joints, its readings the columns "J1", "J2", ... (length per rad,
        or without unit), and "w", the manipulability, for a planar arm.

    Raises
    ------
    ValueError
        If an argument does not fit the arm.

    Examples
    --------
    >>> from kinlab import robots
    >>> view = velocity_view(robots.two_link(), q=[0, np.pi / 2])
    >>> view.readings["J2"][0].round(3) + 0.0
    array([-1.,  0.])
    >>> view.readings["w"][0].round(3)
    array([1.])
    """
    start = first_pose(arm, q)
    on = (*layers(show), *(layer for layer, *_ in _SWITCHES))
    scene = _scene(arm)
    joints = [joint_knob(arm, i) for i in range(arm.n)]
    extra = [{"layer": layer, "label": label, "title": title, "on": True}
             for layer, label, title in _SWITCHES]
    panels = {"layers": [*extra, *switches(on)], "poses": tour(joints).tolist(),
              "pose": pose_table(arm, scene.radius)}
    knobs = [replace(knob, home=value) for knob, value in zip(joints, start.tolist())]
    return LiveView(scene, knobs, name=f"{arm.name or 'Arm'}: velocities", panels=panels, show=on)


def _scene(arm: Arm) -> Scene:
    scene, planar = arm_scene(arm), is_planar(arm)
    tip, size = len(scene.motions), 2 if planar else 3
    turns = [link.kind == REVOLUTE for link in arm.links]
    rates = tuple(SECONDS * (1.0 if turn else typical_length(arm)) for turn in turns)
    columns = tuple(Velocity(tip, rates, i) for i in range(arm.n))
    ellipse = tip + arm.n + 1
    items = (*_ellipse(ellipse, size), *(item for i in range(arm.n)
                                         for item in _column(i, tip, scene.radius)))
    ground = sum(item.style == "ground" for item in scene.items)
    return replace(
        scene, motions=(*scene.motions, *columns, Velocity(tip, rates)),
        items=(*scene.items[:ground], *items, *scene.items[ground:]),
        presets=dict(PLANAR) if planar else scene.presets,
        readings=tuple(_readings(arm, tip, size, rates)))


def _column(i: int, tip: int, radius: float) -> list[Item]:
    """An arrow with its name, nearer than the arm."""
    frame, body = tip + 1 + i, 9000 + i
    name = (frame, 0.045 * radius, 0.045 * radius, 0.0)
    return [Item(f"column-{i + 1}", ARROW, "vector", (*at(tip, (0, 0, 0)), *at(frame, (0, 0, 0))),
                 body, "columns", lift=2 * radius),
            Item(f"column-name-{i + 1}", TEXT, "ink", (name,), body, "columns",
                 f"J{subscript(str(i + 1))}", lift=4 * radius)]


def _ellipse(frame: int, size: int) -> list[Item]:
    """The image of a circle, or of points all over a sphere, under everything."""
    points = circle(61)[:-1] if size == 2 else _sphere(300)
    return [Item("ellipse", SOLID, "ellipse", at(frame, *points), layer="ellipse")]


def _sphere(count: int) -> np.ndarray:
    """Points spread evenly over the unit sphere, along a spiral."""
    height = 1 - 2 * (np.arange(count) + 0.5) / count
    angles, radius = np.pi * (1 + 5 ** 0.5) * np.arange(count), np.sqrt(1 - height ** 2)
    return np.stack([radius * np.cos(angles), radius * np.sin(angles), height], axis=-1)


def _readings(arm: Arm, tip: int, size: int, rates: Sequence[float]) -> list[Reading]:
    """Each column in its own unit, and the manipulability of a planar arm."""
    lines = []
    for i, (link, rate) in enumerate(zip(arm.links, rates)):
        turns, name = link.kind == REVOLUTE, f"J{subscript(str(i + 1))}"
        vector = Vector((tip, 0.0, 0.0, 0.0), (tip + 1 + i, 0.0, 0.0, 0.0), size=size,
                        scale=1 / (SECONDS if turns else rate))
        unit = f" {arm.unit}/rad" if turns else ""
        lines.append(Reading(f"J{i + 1}", f"{name} = {{}}{unit}", (vector,)))
    if size == 2:
        formula = "|det J|" if arm.n == 2 else "√det(J Jᵀ)"
        lines.append(Reading("w", f"w = {formula} = {{}} {arm.unit}²",
                             (Volume(tip + arm.n + 1, 2, SECONDS ** -2),)))
    return lines
