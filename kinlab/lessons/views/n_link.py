"""Views of Practical 3: its arms, a cube pressed flat, two conventions, the three ZYZ angles."""
from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from math import radians
from typing import Any

import numpy as np

from ...arms import robots
from ...arms.arm import Arm, to_modified, to_standard
from ...arms.joints import joint_array
from ...arms.link import revolute
from ...arms.motions import ROTATE, TRANSLATE, Y, Z
from ...arms.transforms import translation
from ...drawing.arm_scene import arm_scene, link_ends
from ...drawing.controls import Knob, PoseTable, subscript
from ...drawing.readings import Amount
from ...drawing.scene import AREA, Item, at, origin_of
from ...drawing.sketch import Sketch
from ...views.arm_view import ArmView
from ...views.live import LiveView

_PLATES = 5  # of the cube


def two_view() -> ArmView:
    """The practical's planar arm, both links 1 m long."""
    return ArmView(two_link(), [radians(30), radians(45)])


def two_link() -> Arm:
    """Its table is modified, so the second length is the tool."""
    return Arm([revolute(), revolute(a=1)], convention="modified",
               tool=translation([1, 0, 0]), name="Two-link")


def six_view(q: Any = None) -> LiveView:
    """The practical's six-link arm with the frames 0, 3 and 6; the wrist has one frame only."""
    arm = robots.practical_six_link()
    start = joint_array(arm, arm.home if q is None else q).tolist()
    sketch = Sketch.of(arm, start, show=("frames", "labels"), keep=_is_shown)
    return LiveView(sketch.scene())


def _is_shown(item: Item) -> bool:
    return item.layer not in ("frames", "labels") or item.frame in ("0", "3", "6")


def flat_view() -> LiveView:
    """A cube, and where the printed hint takes it if the twist before is 0 and the next is not.

    The hint has the cosine of the next twist where the height's own cosine should be, so all
    heights shrink alike.
    """
    sketch = Sketch("A cube, and the printed link matrix", 1.2, planar=False,
                    center=(0, 0, 0.4), grid=0.5)
    twist = sketch.knob(Knob("alpha_i", "αᵢ", 0, 90, 0, "°", quantity="angle"))
    theta = sketch.knob(Knob.angle("theta_i", "θᵢ"))
    turned = sketch.move(ROTATE, Z, 0.0, theta, 0)
    cosines = np.cos(np.radians(np.arange(91)))
    plates = [sketch.move(TRANSLATE, Z, 0.0, twist, turned, track=tuple(height * cosines))
              for height in np.linspace(0, 1, _PLATES)]
    corners = ((-0.5, -0.5, 0), (0.5, -0.5, 0), (0.5, 0.5, 0), (-0.5, 0.5, 0))
    for k, plate in enumerate(plates):
        sketch.add(f"plate-{k}", AREA, "section", at(plate, *corners), part="region")
    for k, corner in enumerate(corners):
        sketch.line(f"edge-{k}", (at(plates[0], corner)[0], at(plates[-1], corner)[0]))
    sketch.axes("0", 0, 0.9)
    sketch.arrow("column", at(turned, (0, 0, 0))[0], at(plates[-1], (0, 0, 0))[0])
    sketch.label("third column", at(plates[-1], (0, 0, 0), (0, 0, -1)))
    point = sketch.point("P", plates[-1], corners[1])
    sketch.reading("P", "corner P = {}", sketch.vector(0, point))
    sketch.reading("det", "determinant, the volume of the cube: {}", Amount(plates[-1]))
    return LiveView(sketch.scene())


def both_conventions(arm: Arm, *links: int, q: Any = None) -> LiveView:
    """Frames of some links in both conventions on one arm; a prime marks the standard ones."""
    modified, standard = to_modified(arm), to_standard(arm)
    sketch = _over(modified, f"{arm.name}, frames of both conventions", q,
                   {f"axis-{joint}" for i in links for joint in (i, i + 1)})
    far, near = _branch(sketch, standard), link_ends(modified)
    for i in links:
        sketch.axes(str(i), near[i], sharing=1)
        sketch.axes(f"{i}′", far[i])
        for prime, frame in (("", near[i]), ("′", far[i])):
            sketch.reading(f"o{i}{prime}", f"o{subscript(i)}{prime} = {{}} {arm.unit}",
                           sketch.vector(0, frame))
    return LiveView(sketch.scene())


def misread(arm: Arm, q: Any = None) -> LiveView:
    """The arm, and as a thin line what its table means in the other convention."""
    other = "standard" if arm.convention == "modified" else "modified"
    wrong = replace(arm, convention=other)
    sketch = _over(arm, f"{arm.name}, its table read in both conventions", q)
    right = sketch.tip
    tip = _branch(sketch, wrong)[-1]
    sketch.line("misread", map(origin_of, (0, *range(right + 1, tip + 1))), "trace")
    sketch.point("p′", tip, (0, 0, 0))
    for prime, frame, convention in (("", right, arm.convention), ("′", tip, other)):
        sketch.reading(f"p{prime}", f"{convention}: p{prime} = {{}} {arm.unit}",
                       sketch.vector(0, frame))
    reach = arm_scene(wrong)
    away = float(np.linalg.norm(np.subtract(reach.center, sketch.center)))
    sketch.radius = max(sketch.radius, away + reach.radius)
    return LiveView(sketch.scene())


def _over(arm: Arm, name: str, q: Any, axes: Collection[str] = ()) -> Sketch:
    """A sketch over an arm, whose own frames are left out, and its axes but for some."""
    start = joint_array(arm, arm.home if q is None else q).tolist()
    sketch = Sketch.of(arm, start, name=name,
                       keep=lambda item: not item.layer or item.gid in axes)
    sketch.items = [replace(item, layer="") for item in sketch.items]
    sketch.bare()
    return sketch


def _branch(sketch: Sketch, arm: Arm) -> list[int]:
    """Follow all motions of an arm from the room; the frames where its links and tool end."""
    frame, ends = 0, []
    for stretch in arm.chain:
        for motion in stretch:
            frame = sketch.move(motion.kind, motion.axis, motion.amount, motion.joint, frame)
        ends.append(frame)
    return ends


def zyz_view() -> LiveView:
    """A frame turned by the three ZYZ angles, each drawn as an arc."""
    sketch = Sketch("ZYZ angles", 1.45, center=(0.1, 0.1, 0.1), planar=False)
    knobs = [sketch.knob(Knob.angle(name, letter, home=radians(home)))
             for name, letter, home in (("phi", "φ", 40), ("theta", "θ", 50), ("psi", "ψ", 30))]
    sketch.axes("0", 0, 1.3)
    turns = [sketch.move(ROTATE, axis, 0.0, knob) for axis, knob in zip((Z, Y, Z), knobs)]
    sketch.axes("", turns[-1], 1.0)
    sketch.tip = turns[-1]
    sketch.handle("tip of z", at(turns[-1], (0, 0, 1))[0], *knobs[:2])
    sketch.handle("tip of x", at(turns[-1], (1, 0, 0))[0], knobs[2])
    for step, place, letter in zip(turns, ((0.55, 0, 0), (0, 0, 0.6), (0.75, 0, 0)), "φθψ"):
        sketch.sweep(f"arc-{letter}", step, place, text=letter)
        sketch.line(f"ray-{letter}", at(step, (0, 0, 0), place))
    for axis, place in (("x", (1, 0, 0)), ("z", (0, 0, 1))):
        sketch.reading(axis, f"{axis} axis = {{}}", sketch.vector(0, at(turns[-1], place)[0]))
    sketch.pose = PoseTable("R = Rz(φ) Ry(θ) Rz(ψ)",
                            tuple((axis, f"{axis} axis") for axis in "xyz"), rows=3)
    return LiveView(sketch.scene())
