"""Sketches for lessons: frames, points and vectors that knobs move, with formulas under them.

A sketch collects what a lesson wants to show and ends in a live view:

>>> sketch = Sketch("A frame that slides")
>>> slide = sketch.knob(Knob.length("o_x", "oₓ", -3, 3, home=2))
>>> frame = sketch.frame("1", x=slide)
>>> point = sketch.point("c", frame, (1, 1))
>>> sketch.reading("c0", "c⁰ = {}", sketch.vector(0, point))
>>> sketch.view()["o_x"].value = 1
"""
from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from ..arms.motions import ROTATE, TRANSLATE, X, Y, Z
from ..views.live import Knob, LiveView
from .scene import (
    ARROW,
    LINE,
    PLANAR,
    SPATIAL,
    TEXT,
    Item,
    Point,
    Reading,
    Scene,
    Step,
    Vector,
    at,
    subscript,
)

_AXES = np.eye(3)


class Sketch:
    """A picture under construction; lengths in the lesson's unit, angles in radians.

    Parameters
    ----------
    name : str
        What the picture shows, for its description.
    radius : float
        Half the width of what is shown about the origin.
    planar : bool
        Seen from the top, with x and y axes only.
    unit : str
        Unit of lengths.
    """

    def __init__(self, name: str, radius: float = 4.0, *, planar: bool = True,
                 unit: str = "") -> None:
        self.name, self.radius, self.planar, self.unit = name, radius, planar, unit
        self.steps: list[Step] = []
        self.items: list[Item] = []
        self.knobs: list[Knob] = []
        self.readings: list[Reading] = []
        self.tip = 0  # the frame that a table shows: the last one made
        self._ground()

    def knob(self, knob: Knob) -> int:
        """Add a slider; the number it is known by."""
        self.knobs.append(knob)
        return len(self.knobs) - 1

    def move(self, kind: str, axis: int, amount: float = 0.0, knob: int | None = None,
             parent: int | None = None, **scrub: float) -> int:
        """Add one elementary motion after `parent` (or the frame before); its frame."""
        self.steps.append(Step(kind, axis, amount, knob, parent=parent, **scrub))
        return len(self.steps)

    def frame(self, name: str, parent: int = 0, *, x: int | None = None, y: int | None = None,
              theta: int | None = None, origin: Sequence[float] = (0, 0), angle: float = 0.0,
              length: float | None = None) -> int:
        """A planar frame that slides along x and y, then turns, each by a knob if one is named."""
        frame = self.move(TRANSLATE, X, origin[0], x, parent)
        frame = self.move(TRANSLATE, Y, origin[1], y)
        frame = self.move(ROTATE, Z, angle, theta)
        self.axes(name, frame, length)
        self.tip = frame
        return frame

    def axes(self, name: str, frame: int, length: float | None = None) -> None:
        """Draw the axes of a frame, with their names."""
        length = length or 0.3 * self.radius
        for letter, axis in zip("xy" if self.planar else "xyz", _AXES):
            label = (length + 0.05 * self.radius) * axis
            self._add(f"frame-{name}-{letter}", ARROW, letter, at(frame, (0, 0, 0), length * axis))
            self._add(f"label-{name}-{letter}", TEXT, letter, at(frame, label),
                      letter + subscript(name), lift=self.radius)

    def point(self, name: str, frame: int, place: Sequence[float], style: str = "tool") -> Point:
        """A dot with its name."""
        (point,) = at(frame, (*place, 0)[:3])
        beside = (point[0], *(np.array(point[1:]) + 0.07 * self.radius * np.array([1, 1, 0])))
        # A dot is a line too short to see, with round ends. Agg draws none of a line without
        # length, nor of one along a row of pixels, which it rounds to whole pixels.
        (end,) = at(frame, np.array(point[1:]) + 1e-3 * self.radius)
        self._add(f"point-{name}", LINE, style, (point, end), lift=self.radius)
        self._add(f"name-{name}", TEXT, "ink", (beside,), name, lift=self.radius)
        return point

    def line(self, name: str, points: Iterable[Point], style: str = "dashed") -> None:
        """A line through points, each in its own frame."""
        self._add(name, LINE, style, tuple(points))

    def arrow(self, name: str, tail: Point, head: Point, style: str = "vector") -> None:
        """An arrow from point to point."""
        self._add(name, ARROW, style, (tail, head), lift=0.1 * self.radius)

    def label(self, text: str, place: Point, style: str = "ink") -> None:
        """Words at a point."""
        self._add(f"words-{len(self.items)}", TEXT, style, (place,), text, lift=self.radius)

    def components(self, name: str, point: Point, frame: int) -> None:
        """Dashed legs from a frame's origin to a point of that frame, along its axes."""
        if point[0] != frame:
            raise ValueError(f"point: expected a point of frame {frame}, got one of {point[0]}")
        corner = (frame, point[1], 0.0, 0.0)
        self.line(f"legs-{name}", ((frame, 0.0, 0.0, 0.0), corner, point))

    def sweep(self, name: str, step: int, place: Sequence[float], style: str = "arc",
              text: str = "") -> list[int]:
        """The path that a point takes as motion number `step` (its frame) is carried out.

        For a rotation an arc, for a slide a line; `text` stands at its middle. The frames along it.
        """
        motion, before = self.steps[step - 1], self._before(step)
        marks = [self._part(motion, before, share) for share in np.linspace(0, 1, 17)]
        self.line(name, [at(frame, place)[0] for frame in marks], style)
        if text:
            outside = (1.25 if motion.kind == ROTATE else 1.0) * np.array(place, dtype=float)
            self.label(text, at(marks[8], outside)[0])
        return marks

    def vector(self, tail: Point | int, head: Point | int, frame: int = 0) -> Vector:
        """For formulas: components in `frame`; a frame's number stands for its origin."""
        ends = [at(end, (0, 0, 0))[0] if isinstance(end, int) else end for end in (tail, head)]
        return Vector(*ends, frame, 2 if self.planar else 3)

    def reading(self, name: str, text: str, *vectors: Vector) -> None:
        """A formula under the picture, with a ``{}`` for each vector."""
        self.readings.append(Reading(name, text, vectors))

    def scene(self) -> Scene:
        """What has been sketched so far."""
        presets = PLANAR if self.planar else SPATIAL
        return Scene(tuple(self.steps), tuple(self.items), self.tip, (0.0, 0.0, 0.0),
                     self.radius, presets=dict(presets), readings=tuple(self.readings))

    def view(self, **options) -> LiveView:
        """The live view of the sketch; options go to `LiveView`."""
        return LiveView(self.scene(), self.knobs, name=self.name, **options)

    def _before(self, step: int) -> int:
        parent = self.steps[step - 1].parent
        return step - 1 if parent is None else parent

    def _part(self, motion: Step, before: int, share: float) -> int:
        return self.move(motion.kind, motion.axis, share * motion.amount, motion.joint, before,
                         gain=share * motion.gain, start=motion.start, scrub=motion.scrub)

    def _add(self, gid: str, shape: str, style: str, points: Iterable[Point], text: str = "",
             lift: float = 0.0) -> None:
        body = len(self.items)
        self.items.append(Item(gid, shape, style, tuple(points), body, "", text, lift))

    def _ground(self) -> None:
        reach = math.floor(0.9 * self.radius)
        for k in range(-reach, reach + 1):
            for line in (((k, -reach, 0), (k, reach, 0)), ((-reach, k, 0), (reach, k, 0))):
                self.items.append(Item(f"ground-{len(self.items)}", LINE, "ground", at(0, *line)))
