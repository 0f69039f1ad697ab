"""How a link comes by its frame and its four numbers, in seven stages that a knob goes through.

First the axes of action, then their common normal, then the x axis on it. Then a frame goes the
same way by four motions, and each leaves its arc or its dimension line behind.
"""
from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import axis_frames
from ..arms.motions import ROTATE, X, Z
from .controls import Knob, subscript
from .link_picture import LinkSketch
from .readings import Entry
from .scene import WAY, at, origin_of

GIVEN = 3     # stages before the first of the four motions is done
_SQUARE = 0.055  # side of a right-angle mark, as a part of the picture's radius
_SMALL = 1e-9  # rad, and parts of the radius: less is nothing


def stages_sketch(arm: Arm, link: int, q: Any) -> StagesSketch:
    """A link in stages, as far as the knob "stage" says."""
    sketch = StagesSketch(arm, link, q)
    sketch.axes_of_action()
    sketch.common_normal()
    sketch.both()
    sketch.carry()
    sketch.reading("stage", "{}", Entry(sketch.stage, tuple(sketch.words())))
    sketch.tell()
    sketch.pose = sketch.table("Product so far", "")
    sketch.poses = [[*sketch.start[:-1], float(stage)] for stage in range(GIVEN + 4)]
    return sketch


class StagesSketch(LinkSketch):
    """A link's picture, whose parts come one after another as its last knob grows."""

    def __init__(self, arm: Arm, link: int, q: Any) -> None:
        super().__init__(arm, link, q)
        self.standard = arm.convention == "standard"
        self.along = self.parameters.index("a")  # the slide that leads along the common normal
        self.old, self.new = (subscript(k) for k in (self.link - 1, self.link))
        self.shared = self.new if self.standard else self.old  # whose x axis lies on the normal
        names = ("Axes", "Normal", "x", *map(self.name_of, range(4)))
        self.stage = self.knob(Knob("stage", "stage", 0, len(names) - 1, step=0.1, title="Stages",
                                    whole=True, names=names))
        self.start.append(0.0)
        self.sights = (f"z{self.old if self.standard else self.new}", f"x{self.shared}")

    @contextmanager
    def since(self, stage: float) -> Iterator[None]:
        """What is drawn meanwhile is there from a stage on."""
        first = len(self.items)
        yield
        self.items[first:] = [replace(item, when=(self.stage, stage, GIVEN + 3.0))
                              for item in self.items[first:]]

    # ---- where the frame is put ----

    def common_normal(self) -> None:
        """The line that meets both axes at right angles, growing from the first to the second."""
        foot, end = self.frames[self.along], self.frames[self.along + 1]
        if self.crossing:
            reach = 0.25 * self.radius
            ends = at(foot, (-reach, 0, 0), (reach, 0, 0))
        else:
            ends = (origin_of(foot), origin_of(end))
        self.add("normal", WAY, "first", ends, size=(float(self.stage),), lift=0.1 * self.radius,
                 part="normal")
        way = 1 if self.crossing or self.arm.links[self.link - 1].a > 0 else -1
        before, after = (foot, end + 1) if self.standard else (self.first, end)
        with self.since(0.5):
            self._square("first", before, way)
            self._square("second", after, way if self.crossing else -way)

    @property
    def crossing(self) -> bool:
        """Whether the common normal has no length."""
        return abs(self.arm.links[self.link - 1].a) < _SMALL * self.radius

    @property
    def parallel(self) -> bool:
        """Whether the axes of action are parallel."""
        return abs(math.sin(self.arm.links[self.link - 1].alpha)) < _SMALL

    def _square(self, name: str, frame: int, way: int) -> None:
        """A right-angle mark between z and x of a frame."""
        x, z = _SQUARE * self.radius * np.eye(3)[[X, Z]] * [[way], [1]]
        self.line(f"right-{name}", at(frame, z, z + x, x), "arc", part="right")

    def both(self) -> None:
        """Both frames; what the common normal decides of them comes with the x axis."""
        old, new = self.both_frames()
        for letter in "xyz":
            for (name, frame, length), early in ((old, self.standard), (new, False)):
                with self.since(-1.0 if early or letter == "z" else 1.5):
                    self.axis(name, frame, length, letter)

    # ---- the way there ----

    def carry(self) -> None:
        """A frame that goes from frame i-1 to frame i, with the arcs and lengths of its way."""
        frames = [self.first]
        for k, motion in enumerate(self.motions):
            frames.append(self.move(motion.kind, motion.axis, motion.amount, motion.joint,
                                    frames[-1], gain=float(motion.sign),
                                    scrub=(self.stage, k + GIVEN - 1)))
        for k in range(4):
            with self.since(k + GIVEN - 1 + 0.05):
                self.mark(k, frames)
        with self.since(GIVEN - 1.0):
            self.line("path", map(origin_of, frames), "trace")
            self.axes("", frames[-1], 0.3 * self.radius)
        self.tip = frames[-1]

    # ---- in words ----

    def factor(self, k: int) -> str:
        """The k-th motion as a factor of the product, in HTML: Rot(z, θ₂)."""
        motion = self.motions[k]
        name = "0" if motion.idle else self.name_of(k)
        kind, colour = ("Rot", "angle") if motion.kind == ROTATE else ("Trans", "length")
        return f'<span class="kl-of-{colour}">{kind}({"xyz"[motion.axis]}, {name})</span>'

    def words(self) -> list[str]:
        """A sentence or two for each stage."""
        return [f"{k}. {text}" for k, text in enumerate(
            [self._axes(), self._normal(), self._x(), *map(self._motion, range(4))], start=1)]

    def _axes(self) -> str:
        joints = {frame: f"the axis of joint {joint}"
                  for joint, frame in enumerate(axis_frames(self.arm), start=1)}
        old, new = (joints.get(k, "no joint's axis: it is ours to choose")
                    for k in (self.link - 1, self.link))
        return f"Axes of action. z{self.old} is {old}, z{self.new} is {new}."

    def _normal(self) -> str:
        z = f"z{self.old} and z{self.new}"
        if self.crossing and self.parallel:
            what = f"{z} are one line: every direction across it will do."
        elif self.crossing:
            what = f"{z} meet, so it has no length. Its direction is across both."
        elif self.parallel:
            what = f"{z} are parallel and have many, all equally long. This one is chosen."
        else:
            what = f"It meets {z} at right angles. There is only one."
        return f"Common normal. {what}"

    def _x(self) -> str:
        y = f"y{self.new} = z{self.new} × x{self.new}"
        if self.standard:
            return (f"x axis. x{self.new} lies on the common normal; O{self.new} is where that "
                    f"meets z{self.new}. {y}.")
        return (f"x axis. x{self.old} lies on the common normal; O{self.old} is where that meets "
                f"z{self.old}. x{self.new} lies on the next one. {y}.")

    def _motion(self, k: int) -> str:
        motion, name, (i, j) = self.motions[k], self.name_of(k), (self.old, self.new)
        about = f"z{i if self.standard else j}" if motion.axis == Z else f"x{self.shared}"
        verb = "Turn about" if motion.kind == ROTATE else "Slide along"
        until = {"standard": {"theta": f"x is parallel to x{j}", "d": f"x lies on the line of x{j}",
                              "a": f"the origin is at O{j}", "alpha": f"z lies on z{j}"},
                 "modified": {"alpha": f"z is parallel to z{j}", "a": f"z lies on z{j}",
                              "theta": f"x is parallel to x{j}", "d": f"the origin is at O{j}"}}
        done = until[self.arm.convention][self.parameters[k]]
        if motion.idle:
            return f"{name} = 0: nothing moves."
        return f"{verb} {about} by {name}, until {done}."
