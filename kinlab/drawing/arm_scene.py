"""The picture of an arm: its solids, frames, joint axes, ground, trace and ghost."""
from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import accumulate
from typing import Any

import numpy as np

from ..arms.arm import Arm
from ..arms.joints import joints_before
from ..arms.kinematics import is_planar
from ..arms.motions import Motion, Numbers
from .bodies import Bodies
from .controls import arm_switches, joint_knobs, subscript, tip_handle, tool_table, tour
from .layout import Layout
from .scene import AXIS, LINE, NAME, TEXT, TRACE, Fit, Floor, Item, Scene, Step, at

_AXES = np.eye(3)
_LONGEST = 20  # letters of a joint's name in the picture


def arm_scene(arm: Arm, q: Numbers | None = None, *, show: Any = (),
              preset: str = "") -> Scene:
    """The picture of an arm: solids, frames, axes, names, ground, trace, ghost.

    It begins at joint values `q`, the arm's home if left out; the ghost stays there. The layers
    in `show` are on.
    """
    layout = Layout(arm, q)
    bodies, knobs = Bodies(layout), tuple(joint_knobs(arm))
    named = any(link.name for link in arm.joints)
    items = [*_ghost(layout), *bodies.items(), *_axes(layout, bodies), *_triads(layout, bodies),
             *(_names(layout, bodies) if named else ()), *_trace(layout)]
    switches = tuple(switch for switch in arm_switches(show) if named or switch.layer != "names")
    return Scene(
        tuple(map(_step, layout.motions)), tuple(items), layout.last,
        tuple(layout.center.tolist()), layout.reach, name=arm.name or "Arm", knobs=knobs,
        start=None if q is None else tuple(map(float, q)), switches=switches,
        pose=tool_table(arm, layout.reach), poses=tuple(map(tuple, tour(knobs).tolist())),
        preset=preset or ("top" if is_planar(arm) else "3-D"), floor=_floor(layout, bodies),
        handles=(tip_handle(arm, layout.last),),
        fit=Fit(tuple(layout.middle.tolist()), layout.radius + 1.1 * layout.thick, layout.thick))


def link_ends(arm: Arm) -> list[int]:
    """Frames of its picture at which the arm's base, each link and the tool end."""
    return list(accumulate(sum(not motion.idle for motion in part) for part in arm.chain))


def _step(motion: Motion) -> Step:
    return Step(motion.kind, motion.axis, motion.amount, motion.joint, gain=float(motion.sign))


def _floor(layout: Layout, bodies: Bodies) -> Floor:
    """A grid through the arm's unit, as far as the arm can reach."""
    step = _nice(layout.radius / 2.4)
    reach = layout.reach + math.hypot(*layout.center[:2])
    decimals = max(0, 1 - math.floor(math.log10(layout.reach)) + 1)
    return Floor(bodies.ground, step, step * math.ceil(1.1 * reach / step), (layout.last,),
                 decimals)


def _ghost(layout: Layout) -> list[Item]:
    origins = [frame[:3, 3] for frame in layout.frames(layout.start)]
    return [Item("ghost", LINE, "ghost", at(0, *origins), layer="ghost", part="ghost")]


def _axes(layout: Layout, bodies: Bodies) -> Iterator[Item]:
    """A line along each joint's axis, through its body, with its number."""
    for i, frame in enumerate(layout.joints):
        place, long = bodies.places[i].along, 0.42 * layout.radius
        ends = at(frame, (0, 0, place - long), (0, 0, place + long))
        yield Item(f"axis-{i + 1}", LINE, "axis", ends, layout.body(), "axes",
                   lift=layout.reach, part="axis", joint=i + 1, link=i)
        yield Item(f"axis-name-{i + 1}", TEXT, "ink", at(frame, (0, 0, place + 1.1 * long)),
                   layer="axes", text=f"axis {i + 1}", part="label", joint=i + 1, link=i)


def _triads(layout: Layout, bodies: Bodies) -> list[Item]:
    """Axes of frames 0 to n, and of the tool where it has a frame of its own."""
    frames = [(str(row), frame, joints_before(layout.arm, row))
              for row, frame in enumerate(layout.ends[:-1])]
    if layout.ends[-1] != layout.ends[-2]:
        frames.append(("E", layout.last, layout.arm.n))
    items: list[Item] = []
    origins: list[np.ndarray] = []
    for name, frame, link in frames:
        origin = layout.home[frame][:3, 3]
        sharing = sum(bool(np.linalg.norm(origin - other) < 0.5 * layout.thick)
                      for other in origins)
        origins.append(origin)
        inside = layout.thick * (1.0 if bodies.crowded(frame) else 0.6)
        items += _triad(layout, (name, frame, link), (inside, float(sharing)))
    return items


def _triad(layout: Layout, which: tuple[str, int, int], size: tuple[float, float]) -> list[Item]:
    name, frame, link = which
    items = []
    for letter, axis in zip("xyz", _AXES):
        points = at(frame, (0, 0, 0), axis)
        items += [
            Item(f"frame-{name}-{letter}", AXIS, letter, points, layer="frames", size=size,
                  part="frame", frame=name, link=link),
            Item(f"label-{name}-{letter}", NAME, letter, points, layer="labels",
                 text=letter + subscript(name), size=size, part="label", frame=name, link=link),
        ]
    return items


def _names(layout: Layout, bodies: Bodies) -> Iterator[Item]:
    """The name of each joint that has one, at its body."""
    for i, link in enumerate(layout.arm.joints):
        if link.name:
            place = at(layout.joints[i], (0, 0, bodies.places[i].along))
            yield Item(f"name-{i + 1}", TEXT, "ink", place, layer="names", text=_brief(link.name),
                       part="label", joint=i + 1, link=i)


def _brief(name: str) -> str:
    """A name that covers no more than a part of the picture; its slider has it in full."""
    return name if len(name) <= _LONGEST else f"{name[:_LONGEST - 1]}…"


def _trace(layout: Layout) -> list[Item]:
    dot = at(layout.last, (0, 0, 0), (1e-3 * layout.thick,) * 3)
    return [Item("tool", LINE, "tool", dot, layout.body(), lift=layout.reach, part="tip",
                 link=layout.arm.n),
            Item("trace", TRACE, "trace", dot[:1], layer="trace", part="trace")]


def _nice(length: float) -> float:
    """The largest of 1, 2, 5, 10, ... that is no longer than `length`."""
    power = 10.0 ** math.floor(math.log10(length))
    return max(step * power for step in (1, 2, 5) if step * power <= length)
