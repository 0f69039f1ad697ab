"""The view of all that the Alpha II reaches: a cloud of points, cut open, with its exact edge."""
from __future__ import annotations

from math import pi

import numpy as np

from ...arms import robots
from ...arms.joints import joint_range, joint_ranges
from ...arms.motions import ROTATE, Z
from ...arms.section import Arc, Chain, edge
from ...arms.workspace import workspace
from ...drawing.cloud import SLICE, packed
from ...drawing.controls import Knob, Switch
from ...drawing.scene import AREA, CLOUD, at
from ...drawing.sketch import Sketch
from ...views.live import LiveView

_SAMPLES, _CELL = 40_000, 68.0  # of the cloud, of which one is kept in each cube (mm)
_STEP = 3.0                     # mm, of the lattice on which its dots lie
_FINE = 0.15                    # mm: how far an edge drawn by corners may be from its arc
_SWITCHES = [Switch("cloud", "Cloud", "Points that the tool reaches", True),
             Switch(SLICE, "Slice", "All that it reaches in an upright plane", True),
             Switch("trace", "Trace", "Path of the tool")]


def reach_view() -> LiveView:
    """The Alpha II in a cloud of the points that it reaches, cut open by an upright plane.

    The plane turns about the axis of the base by the knob "slice", or by its rim. The line in
    it is the exact edge: arcs about shoulder and elbow. As long as the plane is within 30° of x,
    each of its sides is reached with one value of joint 1 only; beyond that, with two.
    """
    arm = robots.alpha_ii()
    sketch = Sketch.of(arm, name="What the Alpha II reaches", keep=lambda item: not item.layer)
    shoulder, chain = arm.links[0].d, _chain()
    sketch.bare()
    sketch.presets["3-D"] = (-38.0, 20.0)  # half of the cloud is seen beside the plane
    sketch.fit, sketch.center, sketch.radius = None, (0.0, 0.0, shoulder), 1.06 * chain.reach
    turn = sketch.knob(Knob.angle("slice", "slice", -pi / 2, pi / 2, 0.0,
                                  "how far the plane is turned from x about the base's axis"))
    sketch.start = [*sketch.start, 0.0]
    plane = sketch.move(ROTATE, Z, 0.0, turn, 0)
    corner, letters = packed(_cloud(), _STEP)
    sketch.add("cloud", CLOUD, "cloud", (corner,), letters, body=-1, layer="cloud", part="cloud",
               size=(plane, _STEP))
    alone = pi - joint_range(arm, 0)[1]  # within this angle joint 1 has one value only
    for name, both, low, high in (("front", False, -alone, alone), ("left", True, -pi, -alone),
                                  ("right", True, alone, pi)):
        _section(sketch, name, plane, edge(chain, both_sides=both), (turn, low, high))
    rim = chain.reach / 2 ** 0.5
    sketch.handle("slice", sketch.point("slice", plane, (rim, 0, shoulder + rim)), turn)
    sketch.reading("p", "tool: p⁰ = {} mm", sketch.vector(0, sketch.tip))
    sketch.trace(sketch.tip)
    sketch.switches, sketch.poses = list(_SWITCHES), _tour()
    return LiveView(sketch.scene())


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
