"""The builder of scenes: frames, points and vectors that knobs move, with formulas under them.

A sketch collects what a picture is to show, on a plane of its own or over an arm, and ends in a
scene:

>>> sketch = Sketch("A frame that slides")
>>> slide = sketch.knob(Knob.length("o_x", "oₓ", -3, 3, home=2))
>>> frame = sketch.frame("1", x=slide)
>>> point = sketch.point("c", frame, (1, 1))
>>> sketch.reading("c0", "c⁰ = {}", sketch.vector(0, point))
>>> sketch.scene().read([1.0])["c0"]
(array([2., 1.]),)
"""
from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import is_planar
from ..arms.motions import ROTATE, TRANSLATE, Numbers, X, Y, Z
from .arm_scene import arm_scene
from .bodies import HALF, PLATE, SKIN, TAPER, THIN
from .controls import Handle, Knob, PoseTable, Switch, Target, subscript
from .curves import corners
from .paints import PAINTS
from .readings import Part, Point, Reading, Vector
from .scene import (
    ARROW,
    AXIS,
    LINE,
    NAME,
    PATCH,
    PLANAR,
    SIZE,
    SOLIDS,
    SPATIAL,
    SWEEP,
    TEXT,
    TRACE,
    TUBE,
    Fit,
    Floor,
    Item,
    Scene,
    Step,
    Velocity,
    at,
    origin_of,
)

_AXES = np.eye(3)
_THICK = 0.034              # radius of a joint, as a part of the sketch's


class Sketch:
    """A picture under construction; lengths in its own unit, angles in radians.

    Parameters
    ----------
    name : str
        What the picture shows, for its description.
    radius : float
        Half the width of what is shown about the centre.
    center : array_like, shape (3,)
        The point in the middle.
    planar : bool
        Seen from the top, with x and y axes only.
    unit : str
        Unit of lengths.
    grid : float
        How far apart the lines on the ground are, with their numbers; 0 for none.

    Attributes
    ----------
    follows : bool
        Whether the picture follows what is drawn: that fills it at home and never leaves it.
        Otherwise the room stands still.
    """

    def __init__(self, name: str, radius: float = 4.0, *, center: Numbers = (0, 0, 0),
                 planar: bool = True, unit: str = "", grid: float = 1.0) -> None:
        self.name, self.radius, self.planar, self.unit = name, radius, planar, unit
        self.steps: list[Step | Velocity] = []
        self.items: list[Item] = []
        self.knobs: list[Knob] = []
        self.readings: list[Reading] = []
        self.tip = 0  # the frame that a table shows: the last one made
        self.center = (float(center[0]), float(center[1]), float(center[2]))
        self.thick = _THICK * radius  # radius of a joint
        self.floor = Floor(0.0, grid, grid * math.ceil(2 * radius / grid),
                           decimals=0 if grid >= 1 else 1) if grid else None
        self.fit: Fit | None = None
        self.follows = False
        self.focus: int | None = None
        self.size = SIZE
        self.presets = dict(PLANAR if planar else SPATIAL)
        self.sights: tuple[str, ...] = ()  # axes worth looking along, such as "z₁"
        self.start: list[float] = []  # values of the knobs; their homes if there are none
        self.switches: list[Switch] = []
        self.pose: PoseTable | None = None
        self.poses: list[list[float]] = []
        self.joints: tuple[int, ...] | None = None  # knobs that Zero sets; all if left out
        self.target: Target | None = None
        self.handles: list[Handle] = []
        self.decimals: int | None = None
        self._bodies = 0

    @classmethod
    def of(cls, arm: Arm, q: Numbers | None = None, *, name: str = "", show: Any = (),
           keep: Callable[[Item], bool] = lambda item: True) -> Sketch:
        """A sketch that begins with the picture of an arm; see `lay_arm`."""
        sketch = cls(name or arm.name or "Arm", planar=is_planar(arm), unit=arm.unit, grid=0)
        sketch.lay_arm(arm, q, show=show, keep=keep)
        return sketch

    def lay_arm(self, arm: Arm, q: Numbers | None = None, *, show: Any = (),
                keep: Callable[[Item], bool] = lambda item: True) -> None:
        """Begin with an arm: its motions, its knobs and what stands beside them, the parts to keep.

        `q` and `show` are those of `arm_scene`.
        """
        scene = arm_scene(arm, q, show=show)
        self.center, self.radius, self.tip = scene.center, scene.radius, scene.tip
        self.knobs, self.switches, self.start = list(scene.knobs), list(scene.switches), scene.begin
        self.pose, self.steps = scene.pose, list(scene.motions)
        self.floor, self.fit = scene.floor, scene.fit
        self.poses = [list(pose) for pose in scene.poses]
        self.handles = list(scene.handles)
        self.lay(filter(keep, scene.items))

    def drop(self, *frames: int) -> None:
        """Lines from the origins of frames to the ground, with their coordinates."""
        if self.floor is not None:
            self.floor = replace(self.floor, drops=frames, decimals=2)

    def bare(self) -> None:
        """Leave out what stands beside an arm: switches, Play and the table of the tool."""
        self.switches, self.poses, self.pose = [], [], None

    def lay(self, items: Iterable[Item], root: int = 0, prefix: str = "") -> None:
        """Put parts of another picture into this one, whose frames begin at frame `root`."""
        first = self._bodies
        for item in items:
            body = item.body if item.body < 0 else item.body + first
            points = tuple((frame + root, x, y, z) for frame, x, y, z in item.points)
            self.items.append(replace(item, gid=prefix + item.gid, points=points, body=body))
            self._bodies = max(self._bodies, body + 1)

    def knob(self, knob: Knob) -> int:
        """Add a slider; the number it is known by."""
        self.knobs.append(knob)
        return len(self.knobs) - 1

    def theta(self, k: int, home: float) -> int:
        """Add a slider for θ with the index k, which begins at `home` degrees; its number."""
        return self.knob(Knob.angle(f"theta_{k}", f"θ{subscript(k)}", home=math.radians(home)))

    def move(self, kind: str, axis: int, amount: float = 0.0, knob: int | None = None,
             parent: int | None = None, *, gain: float = 1.0, start: float | None = None,
             scrub: tuple[int, float] | None = None,
             track: tuple[float, ...] | None = None) -> int:
        """Add one elementary motion after `parent` (or the frame before); its frame."""
        self.steps.append(Step(kind, axis, amount, knob, gain, start, parent, scrub, track))
        return len(self.steps)

    def frame(self, name: str, parent: int = 0, *, x: int | None = None, y: int | None = None,
              theta: int | None = None, origin: Numbers = (0, 0),
              length: float | None = None) -> int:
        """A planar frame that slides along x and y, then turns, each by a knob if one is named.

        A hand drags its origin, and turns it by the tips of axes that have a `length`.
        """
        frame = self.move(TRANSLATE, X, origin[0], x, parent)
        frame = self.move(TRANSLATE, Y, origin[1], y)
        frame = self.move(ROTATE, Z, 0.0, theta)
        self.axes(name, frame, length)
        self.handle(f"origin of frame {name}", frame, x, y)
        for letter, axis in zip("xy" if length else "", _AXES):
            self.handle(f"tip of {letter}{subscript(name)}", at(frame, (length or 0) * axis)[0],
                        theta)
        self.tip = frame
        return frame

    def axes(self, name: str, frame: int, length: float | None = None, *, inside: float = 0.0,
             sharing: int = 0) -> None:
        """Draw the axes of a frame, with their names.

        With a `length` they are arrows so long, such as vectors of length 1. Without, they have
        the same size however near one is, begin `inside` of their origin, and are longer for each
        of the frames `sharing` it.
        """
        for letter in "xy" if self.planar else "xyz":
            self.axis(name, frame, length, letter, (inside, float(sharing)))

    def axis(self, name: str, frame: int, length: float | None, letter: str,
             size: tuple[float, ...] = ()) -> None:
        """One axis of a frame, with its name; `size` is that of an axis without a length."""
        ends = at(frame, (0, 0, 0), (length or 1.0) * _AXES["xyz".index(letter)])
        size = () if length else size
        self.add(f"frame-{name}-{letter}", ARROW if length else AXIS, letter, ends, size=size,
                 part="frame", frame=name)
        self.add(f"label-{name}-{letter}", TEXT if length else NAME, letter,
                 ends[::-1] if length else ends, letter + subscript(name),
                 size=size, part="label", frame=name)

    def point(self, name: str, frame: int, place: Numbers) -> Point:
        """A dot with its name."""
        (point,) = at(frame, (*place, 0)[:3])
        # A dot is a line too short to see, with round ends. Agg draws none of a line without
        # length, nor of one along a row of pixels, which it rounds to whole pixels.
        (end,) = at(frame, np.array(point[1:]) + 1e-3 * self.radius)
        self.add(f"point-{name}", LINE, "tool", (point, end), lift=self.radius, part="point",
                 frame=name)
        self.add(f"name-{name}", TEXT, "ink", (point, point), name, part="label", frame=name)
        return point

    def handle(self, name: str, point: Point | int, *knobs: int | None) -> None:
        """Let a hand drag a point, or a frame's origin: these knobs bring it there."""
        point = origin_of(point) if isinstance(point, int) else point
        driven = tuple(knob for knob in knobs if knob is not None)
        if driven:
            self.handles.append(Handle(name, point, driven, self.unit))

    # ---- a solid arm ----

    def base(self) -> None:
        """The plate on which the first joint stands, with the floor below it."""
        low = -(HALF + 0.26 + PLATE) * self.thick
        self.solid("base", "base", at(0, (0, 0, low), (0, 0, low + PLATE * self.thick)),
                   (1.7 * self.thick, 1.6 * self.thick), part="base", link=0)
        if self.floor is not None:
            self.floor = replace(self.floor, height=low)

    def hinge(self, joint: int, frame: int) -> None:
        """A joint that turns about the z axis of a frame, the one after its motion."""
        half = (0, 0, HALF * self.thick)
        self.solid(f"joint-{joint}", "iron", at(frame, np.negative(half), half),
                   (self.thick, self.thick), part="joint", joint=joint, link=joint)

    def limb(self, link: int, start: int, end: int, last: bool = False) -> None:
        """A link along the x axes of two frames, from a joint to the next or to the arm's tip."""
        skin = SKIN * self.thick
        ends = ((start, skin, 0.0, 0.0), (end, 0.0 if last else -skin, 0.0, 0.0))
        self.solid(f"link-{link}", "steel", ends, (THIN * self.thick, TAPER * self.thick),
                   part="link", link=link)

    def solid(self, gid: str, style: str, ends: Iterable[Point], radii: tuple[float, float],
              **about: Any) -> None:
        """A round body along the line between two points, with a radius at each of them."""
        self.add(gid, TUBE, style, ends, size=radii, **about)

    # ---- strokes and words ----

    def line(self, name: str, points: Iterable[Point], style: str = "dashed",
             **about: Any) -> None:
        """A line through points, each in its own frame; `about` is what `add` takes."""
        self.add(name, LINE, style, tuple(points), **{"part": "line"} | about)

    def arrow(self, name: str, tail: Point, head: Point, style: str = "vector") -> None:
        """An arrow from point to point."""
        self.add(name, ARROW, style, (tail, head), lift=0.1 * self.radius, part="arrow")

    def label(self, text: str, places: Iterable[Point], style: str = "ink", **about: Any) -> None:
        """Words beside a point, away from a second one; `about` is what `add` takes."""
        self.add(f"words-{len(self.items)}", TEXT, style, places, text,
                 **{"part": "label"} | about)

    def components(self, name: str, point: Point, frame: int) -> None:
        """Dashed legs from a frame's origin to a point of that frame, along its axes."""
        if point[0] != frame:
            raise ValueError(f"point: expected a point of frame {frame}, got one of {point[0]}")
        corner = (frame, point[1], 0.0, 0.0)
        self.line(f"legs-{name}", (origin_of(frame), corner, point))

    def sweep(self, name: str, step: int, place: Numbers, style: str = "angle",
              text: str = "") -> list[int]:
        """The path that a point takes as motion number `step` (its frame) is carried out.

        For a rotation an arc, for a slide a line; `text` stands at its middle. Its arrow head says
        which way it goes; a path that is dashed has none. The frames along it.
        """
        motion, before = self._step(step), self._before(step)
        marks = [self._part(motion, before, share) for share in np.linspace(0, 1, 17)]
        joint = None if motion.joint is None else motion.joint + 1
        self.add(name, LINE if style == "dashed" else ARROW, style,
                 [at(frame, place)[0] for frame in marks], part="arc", joint=joint)
        if text:
            self.label(text, at(marks[8], place, (0, 0, 0)),
                       "angle" if motion.kind == ROTATE else "length", joint=joint)
        return marks

    def vector(self, tail: Point | int, head: Point | int, frame: int = 0) -> Vector:
        """For formulas: components in `frame`; a frame's number stands for its origin."""
        tail, head = (origin_of(end) if isinstance(end, int) else end for end in (tail, head))
        return Vector(tail, head, frame, 2 if self.planar else 3)

    def trace(self, frame: int) -> None:
        """The way of a frame's origin, once it is switched on."""
        self.add("trace", TRACE, "trace", at(frame, (0, 0, 0)), layer="trace", part="trace")

    def reading(self, name: str, text: str, *parts: Part) -> None:
        """A formula under the picture, with a ``{}`` for each part."""
        self.readings.append(Reading(name, text, parts))

    def scene(self) -> Scene:
        """What has been sketched so far."""
        scene = Scene(
            name=self.name, motions=tuple(self.steps), items=tuple(self.items), tip=self.tip,
            center=self.center, radius=self.radius, size=self.size,
            focus=self.focus, presets=dict(self.presets), sights=self.sights,
            knobs=tuple(self.knobs), start=tuple(self.start) or None,
            switches=tuple(self.switches), pose=self.pose, target=self.target,
            poses=tuple(tuple(map(float, pose)) for pose in self.poses), joints=self.joints,
            readings=tuple(self.readings), decimals=self.decimals,
            floor=self.floor, fit=self.fit, handles=tuple(self.handles))
        return replace(scene, fit=self._fitting(scene)) if self.follows else scene

    def _fitting(self, scene: Scene) -> Fit:
        """A frame round all that is drawn, words aside, as large as that is at home."""
        q, frames = scene.begin, scene.frames(scene.begin)
        places = np.concatenate([corners(item, scene.motions, frames, q) for item in self.items
                                 if item.shape in (ARROW, LINE, SWEEP, PATCH, *SOLIDS)
                                 and "faded" not in PAINTS[item.style]])
        low, high = places.min(axis=0), places.max(axis=0)
        middle = tuple(((low + high) / 2).tolist())
        return Fit(middle, float(np.linalg.norm(high - low)) / 2, self.thick)

    def _step(self, frame: int) -> Step:
        """The elementary motion that leads to a frame."""
        step = self.steps[frame - 1]
        assert isinstance(step, Step)
        return step

    def _before(self, step: int) -> int:
        parent = self._step(step).parent
        return step - 1 if parent is None else parent

    def _part(self, motion: Step, before: int, share: float) -> int:
        return self.move(motion.kind, motion.axis, share * motion.amount, motion.joint, before,
                         gain=share * motion.gain, start=motion.start, scrub=motion.scrub)

    def body(self) -> int:
        """A new number for things that stay together when nearer ones are laid over farther."""
        self._bodies += 1
        return self._bodies - 1

    def add(self, gid: str, shape: str, style: str, points: Iterable[Point], text: str = "", *,
            body: int | None = None, **about: Any) -> None:
        """Add one drawn thing, as `Item` has it; a body of its own unless one is given."""
        body = self.body() if body is None else body
        self.items.append(Item(gid, shape, style, tuple(points), body, text=text, **about))
