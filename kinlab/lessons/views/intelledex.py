"""Views of lesson 08: the Intelledex with some of its frames, in a plane of its own, its axes."""
from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...arms import robots
from ...arms.arm import Arm
from ...drawing.scene import AREA, at, circle, origin_of
from ...drawing.sketch import Sketch
from ...views.arm_view import ArmView
from ...views.live import LiveView

_SHOULDER = 5                # frame 2 of the table, at the top of the column
_LONG, _WIDE = 300.0, 420.0  # mm, of the arrows u, v, w, and of the plane


def turned_round() -> Arm:
    """The same arm from another table: z₂, z₃ and z₄ point the other way."""
    arm = robots.intelledex_660t()
    signs = (1, -1, 1, 1, -1, 1)  # α₂ and α₅ lead to, or from, an axis that has turned round
    links = tuple(replace(link, alpha=sign * link.alpha) for link, sign in zip(arm.links, signs))
    return replace(arm, links=links, name="Turned round", home=arm.home * [1, 1, -1, -1, -1, 1])


def names_view() -> ArmView:
    """The arm at soft home, its joints named and its axes not drawn."""
    return ArmView(robots.intelledex_660t(), show=("names",))


def frames_view(*frames: str) -> LiveView:
    """The arm at soft home, with these of its frames and no others."""
    arm = robots.intelledex_660t()
    sketch = Sketch.of(arm, arm.home, name=f"{arm.name}: frames {', '.join(frames)}",
                       show=("frames", "labels"),
                       keep=lambda item: item.part not in ("frame", "label")
                       or item.frame in frames)
    sketch.trace(sketch.tip)
    return LiveView(sketch.scene())


def pitch_view() -> LiveView:
    """The frame of the tool pitch, whose z axis the shoulder roll carries round."""
    return frames_view("4")


def wrist_view() -> LiveView:
    """The frame at the wrist, and that of the tool."""
    return frames_view("5", "6")


def yaw_view() -> ArmView:
    """The arm at soft home; Play rolls the shoulder, yaws with the tool pitch, and goes back."""
    steps = [[90, -90, 90, 0, 90, 0], [90, 0, 90, 0, 90, 0], [90, 0, 90, 0, 0, 0],
             [90, 0, 90, 0, 180, 0], [90, 0, 90, 0, 90, 0]]
    return ArmView(robots.intelledex_660t(), poses=np.radians(steps),
                   show=("frames", "labels", "axes"))


def plane_view() -> LiveView:
    """The directions u, v and w at the shoulder, and the plane of u and v, in which the arm bends.

    u is where an unbent link would point, v the axis of the shoulder roll, w that of the pitch.
    """
    arm = robots.intelledex_660t()
    sketch = Sketch.of(arm, np.radians([0, 0, 50, -70, 100, 0]), name=f"{arm.name}: u, v, w",
                       keep=lambda item: not item.layer)
    sketch.bare()
    turned = _SHOULDER
    for name, axis, way in zip("uvw", "xyz", np.eye(3)):
        head = at(turned, _LONG * way)[0]
        sketch.arrow(name, origin_of(turned), head, axis)
        sketch.label(name, (head, origin_of(turned)), axis)
        sketch.reading(name, f"{name} = {{}}",
                       sketch.vector(origin_of(turned), at(turned, way)[0]))
    sketch.add("plane", AREA, "region", at(turned, *(_WIDE * circle(73))), body=-1, part="region")
    return LiveView(sketch.scene())


def meeting_view() -> LiveView:
    """The axes of all joints, long, with their numbers: where do three of them meet?"""
    arm = robots.intelledex_660t()
    sketch = Sketch.of(arm, np.radians([110, -70, 120, -60, 60, 0]), name=f"{arm.name}: its axes",
                       keep=lambda item: not item.layer or item.layer == "axes")
    sketch.items = [replace(item, layer="") for item in sketch.items]
    sketch.bare()
    return LiveView(sketch.scene())
