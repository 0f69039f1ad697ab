"""Views of all that the Alpha II reaches: a cloud of points, cut open, with its exact edge."""
from __future__ import annotations

from math import pi

import numpy as np

from ...arms import robots
from ...arms.joints import joint_range, joint_ranges
from ...arms.motions import ROTATE, TRANSLATE, X, Z
from ...arms.section import Arc, Chain, edge
from ...arms.workspace import workspace
from ...drawing.cloud import SLICE, packed
from ...drawing.controls import Knob, Switch
from ...drawing.scene import AREA, CLOUD, PATCH, SWEEP, at, origin_of
from ...drawing.sketch import Sketch
from ...views.live import LiveView

_SAMPLES, _CELL = 40_000, 68.0  # of the cloud, of which one is kept in each cube (mm)
_STEP = 3.0                     # mm, of the lattice on which its dots lie
_FINE = 0.15                    # mm: how far an edge drawn by corners may be from its arc
_RISE = 5.0                     # mm, from one level plane to the next
_HEIGHTS = np.arange(0.0, 695.0, _RISE)
_SWITCHES = [Switch("cloud", "Cloud", "Points that the tool reaches", True),
             Switch(SLICE, "Slice", "All that it reaches in an upright plane", True),
             Switch("trace", "Trace", "Path of the tool")]


def reach_view() -> LiveView:
    """The Alpha II in a cloud of the points that it reaches, cut open by an upright plane.

    The plane turns about the axis of the base by the knob "slice", or by its rim. The line in
    it is the exact edge: arcs about shoulder and elbow. As long as the plane is within 30° of x,
    each of its sides is reached with one value of joint 1 only; beyond that, with two.
    """
    chain, shoulder = _chain(), robots.alpha_ii().links[0].d
    turn = Knob.angle("slice", "slice", -pi / 2, pi / 2, 0.0,
                      "how far the plane is turned from x about the base's axis")
    sketch, knob = _opened(turn, "What the Alpha II reaches")
    sketch.presets["3-D"] = (-38.0, 20.0)  # half of the cloud is seen beside the plane
    plane = sketch.move(ROTATE, Z, 0.0, knob, 0)
    _cut(sketch, plane)
    alone = pi - joint_range(robots.alpha_ii(), 0)[1]  # joint 1 has one value only within this
    for name, both, low, high in (("front", False, -alone, alone), ("left", True, -pi, -alone),
                                  ("right", True, alone, pi)):
        _section(sketch, name, plane, edge(chain, both_sides=both), (knob, low, high))
    rim = chain.reach / 2 ** 0.5
    sketch.handle("slice", sketch.point("slice", plane, (rim, 0, shoulder + rim)), knob)
    sketch.poses = _tour()
    return LiveView(sketch.scene())


def level_view() -> LiveView:
    """The same cloud, cut open by a level plane that slides up and down by the knob "height".

    In the plane the tool reaches a part of a disc with the arm leaning forwards, and of a smaller
    one with the arm leaning backwards over its base; where both ways lead, the blue is darker.
    """
    knob = Knob("height", "height", 0, len(_HEIGHTS) - 1, 43, "mm", 1 / _RISE, _RISE,
                "how high the plane is above the table", quantity="length")
    sketch, height = _opened(knob, "What the Alpha II reaches at one height")
    sketch.presets["3-D"] = (-50.0, 32.0)
    level = sketch.move(TRANSLATE, Z, 0.0, height, 0, gain=_RISE)
    _cut(sketch, sketch.move(ROTATE, X, -pi / 2, None, level))  # what is above is cut away
    near, hole, far = _radii()
    most = joint_range(robots.alpha_ii(), 0)[1]
    for name, middle, radii in (("forwards", 0.0, far), ("backwards", pi, near)):
        first, last = (sketch.move(ROTATE, Z, middle + end, None, level) for end in (-most, most))
        ends = [sketch.move(TRANSLATE, X, 0.0, height, first, track=track)
                for track in ((0.0,) * len(radii), radii)]
        sketch.add(name, PATCH, "section", (origin_of(ends[0]),), body=-1, layer=SLICE,
                   part="region", size=(first, last, *ends))
    _ring(sketch, level, height, hole)
    aside = sketch.move(ROTATE, Z, -pi / 4, None, level)  # where the tool does not hide it
    rim = sketch.move(TRANSLATE, X, 0.0, height, aside, track=far)
    sketch.handle("height", sketch.point("height", rim, (0, 0, 0)), height)
    sketch.poses = [[*pose[:5], float(stop)] for pose, stop in zip(_tour(), (43, 0, 80, 130))]
    return LiveView(sketch.scene())


def _opened(knob: Knob, name: str) -> tuple[Sketch, int]:
    """The arm in the middle of the picture, and a knob that says where the cloud is cut."""
    arm, reach = robots.alpha_ii(), _chain().reach
    sketch = Sketch.of(arm, name=name, keep=lambda item: not item.layer)
    sketch.bare()
    sketch.fit, sketch.center, sketch.radius = None, (0.0, 0.0, arm.links[0].d), 1.06 * reach
    number = sketch.knob(knob)
    sketch.start = [*sketch.start, knob.home]
    sketch.reading("p", "tool: p⁰ = {} mm", sketch.vector(0, sketch.tip))
    sketch.trace(sketch.tip)
    sketch.switches = list(_SWITCHES)
    return sketch, number


def _cut(sketch: Sketch, plane: int) -> None:
    """The cloud, without the dots on the negative side of a frame's y axis."""
    corner, letters = packed(_cloud(), _STEP)
    sketch.add("cloud", CLOUD, "cloud", (corner,), letters, body=-1, layer="cloud", part="cloud",
               size=(plane, _STEP))


def _ring(sketch: Sketch, level: int, height: int, radii: tuple[float, ...]) -> None:
    """The hole round the shoulder, which the folded arm cannot reach."""
    first, last = (sketch.move(ROTATE, Z, turn, None, level) for turn in (0.0, 2 * pi))
    end = sketch.move(TRANSLATE, X, 0.0, height, first, track=radii)
    sketch.add("hole", SWEEP, "hole", (origin_of(end),), body=-1, layer=SLICE, part="region",
               size=(first, last))


def _radii() -> tuple[tuple[float, ...], ...]:
    """At each height: how far backwards, how wide the hole is, how far forwards (mm)."""
    outer, hole = (_loop(row) for row in edge(_chain()))
    cuts = np.array([(*_crossings(outer, height), *(_crossings(hole, height) or (0.0, 0.0)))
                     for height in _HEIGHTS])
    return tuple(tuple(np.round(values, 1).tolist())
                 for values in (-cuts[:, 0], cuts[:, 3], cuts[:, 1]))


def _crossings(corners: np.ndarray, height: float) -> tuple[float, ...]:
    """Where a closed row of corners in the plane y = 0 crosses a height, from left to right."""
    after = np.roll(corners, -1, axis=0)
    there = (corners[:, 2] <= height) != (after[:, 2] <= height)
    one, other = corners[there], after[there]
    share = (height - one[:, 2]) / (other[:, 2] - one[:, 2])
    return tuple(np.sort(one[:, 0] + share * (other[:, 0] - one[:, 0])).tolist())


def _chain() -> Chain:
    """Upper arm, forearm and tool in the plane that joint 1 turns; there, up is to the left.

    Positive joint values lower the arm, and the tool is straight at its home.
    """
    arm = robots.alpha_ii()
    ends = [(home - high, home - low) for low, high, home in zip(*joint_ranges(arm), arm.home)]
    return Chain((arm.links[1].a, arm.links[2].a, arm.links[4].d), tuple(ends[1:4]))


def _cloud() -> np.ndarray:
    """Points that the tool reaches, spread evenly: one sample of each cube."""
    points = workspace(robots.alpha_ii(), _SAMPLES, progress=lambda done, count: None).points
    _, first = np.unique(np.floor(points / _CELL), axis=0, return_index=True)
    return points[np.sort(first)]


def _section(sketch: Sketch, name: str, plane: int, rows: list[list[Arc]],
             when: tuple[int, float, float]) -> None:
    """All that is reached in the plane, and its edge, while the knob stands between two values.

    The first row is the outer edge, any other one that of a hole.
    """
    for k, row in enumerate(rows):
        sketch.add(f"{name}-{'hole' if k else 'section'}", AREA, "hole" if k else "section",
                   at(plane, *_loop(row)), body=-1, layer=SLICE, part="region", when=when)


def _loop(row: list[Arc]) -> np.ndarray:
    """Corners of a closed row of arcs in the slice."""
    corners = np.concatenate([arc.corners(_FINE)[:-1] for arc in row])
    shoulder = robots.alpha_ii().links[0].d
    places = np.stack([corners.real, 0 * corners.real, shoulder + corners.imag], axis=-1)
    return np.round(places, 1)


def _tour() -> list[list[float]]:
    """Poses at the edge, and turns of the slice; the arm keeps in the plane."""
    degrees = [(0, 0, 0, -90, 0, 0), (0, -120, 0, -90, 0, 0), (0, -120, -60, -90, 0, 0),
               (0, -90, 0, -90, 0, 0), (90, -30, 0, -90, 0, 90), (90, 60, 90, -45, 0, 90),
               (-60, 0, 60, -45, 0, -60)]
    return np.radians(degrees).tolist()
