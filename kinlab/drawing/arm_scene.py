"""The textbook drawing of an arm: joints, links, frames, axes, ground, trace and ghost."""
from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import accumulate, pairwise
from typing import Any

import numpy as np

from ..arms.arm import Arm
from ..arms.joints import joint_range, joint_ranges
from ..arms.kinematics import forward_kinematics, link_frames
from ..arms.link import PRISMATIC, REVOLUTE
from ..arms.motions import TRANSLATE, Frame, Motion, Numbers, along, follow, matrix
from .controls import arm_switches, joint_knobs, subscript, tool_table, tour
from .scene import ARROW, FACE, HULL, LINE, TEXT, TRACE, Item, Scene, Step, at

_AXES = np.eye(3)
_SIDES = 20


def is_planar(arm: Arm) -> bool:
    """True when all joints turn about parallel axes along the room's z."""
    frames = link_frames(arm, np.full(arm.n, 0.3))
    revolute = all(link.kind == REVOLUTE for link in arm.links)
    return revolute and bool(np.allclose(np.abs(frames[:, 2, 2]), 1))


def arm_scene(arm: Arm, q: Numbers | None = None, *, show: Any = (),
              preset: str = "") -> Scene:
    """The textbook drawing of an arm: joints, links, frames, axes, ground, trace, ghost.

    It begins at joint values `q`, the arm's home if left out; the ghost stays there. The layers
    in `show` are on.
    """
    switches, layout = arm_switches(show), _Layout(arm, q)
    size = layout.radius * 0.9
    items = [*_ground(layout, size), *_ghost(layout), *_links(layout), *_joints(layout),
             *_gripper(layout), *_axes(layout, size), *_triads(layout, size), *_trace(layout)]
    radius, knobs = _fit(layout, items), tuple(joint_knobs(arm))
    return Scene(
        tuple(map(_step, layout.motions)), tuple(items), len(layout.motions),
        tuple(layout.center.tolist()), radius, name=arm.name or "Arm", knobs=knobs,
        start=None if q is None else tuple(map(float, q)), switches=switches,
        pose=tool_table(arm, radius), poses=tuple(map(tuple, tour(knobs).tolist())),
        preset=preset or ("top" if is_planar(arm) else "3-D"))


def link_ends(arm: Arm) -> list[int]:
    """Frames of its picture at which the arm's base, each link and the tool end."""
    return list(accumulate(sum(not motion.idle for motion in part) for part in arm.chain))


def _step(motion: Motion) -> Step:
    return Step(motion.kind, motion.axis, motion.amount, motion.joint)


class _Layout:
    """Where the parts of an arm lie along its motions, and how large the drawing is."""

    def __init__(self, arm: Arm, q: Numbers | None) -> None:
        self.arm, self.start = arm, arm.home if q is None else np.asarray(q)
        self.motions: list[Motion] = []
        self.joints = [0] * arm.n            # frame just before each joint moves
        self.ends = [self._walk(stretch) for stretch in arm.chain]
        self.poses = _poses_tried(arm)
        self.center, self.radius = _reach(arm, self.poses)
        self.thick = 0.036 * self.radius
        self.bodies = 0
        self.home = self.frames(arm.home)

    def frames(self, q: np.ndarray) -> list[np.ndarray]:
        """The frames along the motions at joint values within their ranges."""
        within = np.clip(q, *joint_ranges(self.arm)).tolist()
        return [matrix(f) for f in along(((), *((m,) for m in self.motions)), within)]

    def _walk(self, stretch: Iterable[Motion]) -> int:
        """Add the motions of a link, and say at which frame they end."""
        for motion in stretch:
            if motion.joint is not None:
                self.joints[motion.joint] = len(self.motions)
            if not motion.idle:
                self.motions.append(motion)
        return len(self.motions)

    def body(self) -> int:
        """A new number for things that stay together."""
        self.bodies += 1
        return self.bodies - 1


def _poses_tried(arm: Arm) -> np.ndarray:
    """Poses all over the joint ranges; in half of them every slide is right in or right out."""
    low, high = joint_ranges(arm)
    slides = [i for i, link in enumerate(arm.links) if link.kind == PRISMATIC]
    spread = np.random.default_rng(0).random((2000, arm.n))
    spread[::2, slides] = spread[::2, slides].round()
    return np.vstack([low + spread * (high - low), arm.home, np.clip(0, low, high)])


def _reach(arm: Arm, poses: np.ndarray) -> tuple[np.ndarray, float]:
    """Centre and radius of a sphere that holds the arm at every pose."""
    points = np.concatenate([link_frames(arm, poses)[..., :3, 3].reshape(-1, 3),
                             forward_kinematics(arm, poses)[..., :3, 3], np.zeros((1, 3))])
    center = (points.min(axis=0) + points.max(axis=0)) / 2
    center[np.abs(center) < 0.05 * np.ptp(points)] = 0
    farthest = float(np.max(np.linalg.norm(points - center, axis=1)))
    return center, 1.17 * farthest or 1.0


def _fit(layout: _Layout, items: Iterable[Item]) -> float:
    """Radius about the centre that holds all that is drawn, however its frame may be turned."""
    away = []
    for frame in along(((), *((m,) for m in layout.motions)), list(layout.poses.T)):
        origin = np.stack(np.broadcast_arrays(*frame.origin), axis=-1)
        away.append(np.max(np.linalg.norm(origin - layout.center, axis=-1)))
    sizes = [away[k] + math.hypot(*point) if k else math.dist(point, layout.center)
             for item in items for k, *point in item.points]
    return 1.03 * float(max(sizes))  # room for poses not tried


def _ground(layout: _Layout, size: float) -> list[Item]:
    step = _nice(size / 4)
    steps = step * np.arange(-3, 4)
    ends = [((x, steps[0], 0), (x, steps[-1], 0)) for x in steps]
    ends += [((steps[0], y, 0), (steps[-1], y, 0)) for y in steps]
    return [Item(f"ground-{k}", LINE, "ground", at(0, *pair)) for k, pair in enumerate(ends)]


def _ghost(layout: _Layout) -> list[Item]:
    origins = [frame[:3, 3] for frame in layout.frames(layout.start)]
    return [Item("ghost", LINE, "ghost", at(0, *origins), layer="ghost")]


def _links(layout: _Layout) -> list[Item]:
    """Strokes along the slides, in short pieces, so that each lies as near as it is."""
    items = []
    for k, motion in enumerate(layout.motions):
        if motion.kind != TRANSLATE:
            continue
        if motion.joint is not None:
            items.append(Item(f"link-{k}-0", LINE, "rod", ((k, 0, 0, 0), (k + 1, 0, 0, 0)),
                              layout.body()))
            continue
        pieces = math.ceil(abs(motion.amount) / (5 * layout.thick))
        marks = np.linspace(0, motion.amount, pieces + 1)[:, None] * _AXES[motion.axis]
        items += [Item(f"link-{k}-{piece}", LINE, "link", at(k, *ends), layout.body())
                  for piece, ends in enumerate(pairwise(marks))]
    return items


def _joints(layout: _Layout) -> list[Item]:
    items: list[Item] = []
    taken: list[np.ndarray] = []
    for i, link in enumerate(layout.arm.links):
        frame, body, t = layout.joints[i], layout.body(), layout.thick
        place = _free_place(layout, i, taken)
        if link.kind == PRISMATIC:  # its rod is one stroke, as long as the joint is far out
            solid, lift = _box(place, t), t + max(map(abs, joint_range(layout.arm, i))) / 2
        else:
            solid, lift = _cylinder(place, t), 3 * t
        items += [Item(f"joint-{i + 1}-{k}", shape, style, at(frame, *points), body, lift=lift)
                  for k, (shape, style, points) in enumerate(solid)]
    return items


def _free_place(layout: _Layout, i: int, taken: list[np.ndarray]) -> float:
    """Where along its axis a joint is drawn, so that it hides none drawn before."""
    link, home, t = layout.arm.links[i], layout.home[layout.joints[i]], layout.thick
    along_link = 0.35 * link.d if link.kind == REVOLUTE and abs(link.d) > 5 * t else 0.0
    ahead = home[:3, :3].T @ (layout.home[-1][:3, 3] - home[:3, 3])
    step = math.copysign(2.6 * t, ahead[2] if abs(ahead[2]) > t else -1)
    for place in along_link + step * np.array([0, 1, -1, 2, -2]):
        point = home[:3, 3] + place * home[:3, 2]
        if all(np.linalg.norm(point - other) > 2 * t for other in taken):
            break
    taken.append(point)
    return float(place)


def _cylinder(place: float, t: float) -> list[tuple[str, str, np.ndarray]]:
    angles = np.linspace(0, 2 * np.pi, _SIDES, endpoint=False)
    ring = np.stack([t * np.cos(angles), t * np.sin(angles), np.zeros(_SIDES)], axis=-1)
    top, bottom = ring + [0, 0, place + 1.25 * t], ring + [0, 0, place - 1.25 * t]
    return [(HULL, "joint", np.concatenate([top, bottom])), (FACE, "cap", top),
            (FACE, "cap", bottom[::-1])]


def _box(place: float, t: float) -> list[tuple[str, str, np.ndarray]]:
    half = np.array([t, t, 1.7 * t])
    faces = []
    for axis in range(3):
        u, v = _AXES[(axis + 1) % 3], _AXES[(axis + 2) % 3]
        face = np.array([u + v, v - u, -u - v, u - v]) + _AXES[axis]
        faces += [face, -face[::-1]]  # point mirrored and order reversed: still seen from outside
    return [(FACE, "cap" if k > 3 else "joint", face * half + [0, 0, place])
            for k, face in enumerate(faces)]


def _gripper(layout: _Layout) -> list[Item]:
    """Two fingers that close along y, reaching for the tool point along the last slide."""
    frame, g = layout.ends[-1], 1.5 * layout.thick
    approach = _approach(layout)
    across = _AXES[1] if abs(approach[1]) < 0.9 else _AXES[0]
    hand = [(0, 0.6), (-1, 0.6), (-1, -0.6), (0, -0.6)]
    points = [g * (x * approach + y * across) for x, y in hand]
    body = layout.body()
    return [Item("gripper", LINE, "gripper", at(frame, *points), body),
            Item("tool", LINE, "tool", at(frame, (0, 0, 0), (0, 0, 0)), body)]


def _approach(layout: _Layout) -> np.ndarray:
    """Direction of the last slide in the tool frame; z where a joint turns after it."""
    turned = max(k for k, motion in enumerate(layout.motions) if motion.joint is not None)
    slides = [k for k, m in enumerate(layout.motions) if m.kind == TRANSLATE and k >= turned]
    if not slides:
        return _AXES[2]
    last = layout.motions[slides[-1]]
    rest = matrix(follow(layout.motions[slides[-1] + 1:], (), Frame()))
    sign = -1 if last.joint is None and last.amount < 0 else 1
    return sign * rest[:3, :3].T @ _AXES[last.axis]


def _axes(layout: _Layout, size: float) -> list[Item]:
    return [Item(f"axis-{i + 1}", LINE, "axis",
                 at(frame, (0, 0, -0.3 * size), (0, 0, 0.3 * size)), layout.body(), "axes")
            for i, frame in enumerate(layout.joints)]


def _triads(layout: _Layout, size: float) -> list[Item]:
    """Axes of frames 0 to n, and of the tool where it has a frame of its own."""
    names = {str(i): end for i, end in enumerate(layout.ends[:-1])}
    if layout.ends[-1] != layout.ends[-2]:
        names["E"] = layout.ends[-1]
    items: list[Item] = []
    origins: list[np.ndarray] = []
    for name, frame in names.items():
        origin = layout.home[frame][:3, 3]
        sharing = sum(np.linalg.norm(origin - other) < layout.thick for other in origins)
        origins.append(origin)
        items += _triad(layout, name, frame, 0.14 * size * (1 + 0.4 * sharing))
    return items


def _triad(layout: _Layout, name: str, frame: int, length: float) -> list[Item]:
    items = []
    for letter, axis in zip("xyz", _AXES):
        items += [
            Item(f"frame-{name}-{letter}", ARROW, letter, at(frame, (0, 0, 0), length * axis),
                 layout.body(), "frames", lift=layout.radius),
            Item(f"label-{name}-{letter}", TEXT, letter,
                 at(frame, (length + 0.033 * layout.radius) * axis), layout.body(), "labels",
                 letter + subscript(name), lift=3 * layout.radius),
        ]
    return items


def _trace(layout: _Layout) -> list[Item]:
    return [Item("trace", TRACE, "trace", at(layout.ends[-1], (0, 0, 0)), layer="trace")]


def _nice(length: float) -> float:
    """The largest of 1, 2, 5, 10, ... that is no longer than `length`."""
    power = 10.0 ** math.floor(math.log10(length))
    return max(step * power for step in (1, 2, 5) if step * power <= length)
