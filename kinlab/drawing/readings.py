"""Formulas under a picture, whose numbers follow its frames and its knobs."""
from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from typing import ClassVar

import numpy as np

from ..arms.motions import ROTATE, Numbers
from .turned import axis_and_angle, followed, roll_pitch_yaw

Point = tuple[int, float, float, float]


@dataclass(frozen=True)
class _Part:
    """A number, a vector or a word in a formula; `kind` tells the browser how to read it."""

    kind: ClassVar[str] = ""

    def data(self) -> dict:
        """Plain data for the browser."""
        return {"kind": self.kind, **asdict(self)}


@dataclass(frozen=True)
class Vector(_Part):
    """The vector from one point to another, with its first `size` components in a frame.

    What stands for it on the picture may be drawn smaller; `scale` makes up for that.
    """

    kind = "vector"
    tail: Point
    head: Point
    frame: int = 0
    size: int = 2
    scale: float = 1.0

    def read(self, motions: Sequence, frames: np.ndarray, q: Numbers) -> np.ndarray:
        tail, head = (frames[k] @ (*local, 1.0) for k, *local in (self.tail, self.head))
        return self.scale * (frames[self.frame][:3, :3].T @ (head - tail)[:3])[:self.size]


@dataclass(frozen=True)
class Distance(_Part):
    """How far one point is from another; never negative."""

    kind = "distance"
    tail: Point
    head: Point

    def read(self, motions: Sequence, frames: np.ndarray, q: Numbers) -> np.ndarray:
        tail, head = ((frames[k] @ (*local, 1.0))[:3] for k, *local in (self.tail, self.head))
        return np.array([np.linalg.norm(head - tail)])


@dataclass(frozen=True)
class Amount(_Part):
    """How far motion number `step` goes: a length, or an angle in degrees."""

    kind = "amount"
    step: int

    def read(self, motions: Sequence, frames: np.ndarray, q: Numbers) -> np.ndarray:
        motion = motions[self.step - 1]
        return np.array([motion.value(q) * (math.degrees(1) if motion.kind == ROTATE else 1)])


@dataclass(frozen=True)
class Volume(_Part):
    """The product of the half axes of a velocity ellipsoid (or ellipse, `size` 2)."""

    kind = "volume"
    ellipsoid: int
    size: int = 2
    scale: float = 1.0

    def read(self, motions: Sequence, frames: np.ndarray, q: Numbers) -> np.ndarray:
        sides = np.diagonal(frames[self.ellipsoid])[:self.size]
        return np.array([self.scale * np.prod(sides)])


@dataclass(frozen=True)
class Entry(_Part):
    """One of several texts, by the whole number that a knob stands at."""

    kind = "entry"
    knob: int
    texts: tuple[str, ...]

    def read(self, motions: Sequence, frames: np.ndarray, q: Numbers) -> str:
        return self.texts[min(max(round(q[self.knob]), 0), len(self.texts) - 1)]


@dataclass(frozen=True)
class Turned(_Part):
    """How a frame is turned from the room: its unit quaternion (w, x, y, z).

    No sign jumps while a knob moves; see `turned.followed`.
    """

    kind = "quaternion"
    frame: int

    def read(self, motions: Sequence, frames: np.ndarray, q: Numbers) -> np.ndarray | str:
        return followed(motions, self.frame, q)


@dataclass(frozen=True)
class TurnAxis(Turned):
    """The axis of the one turn that leads from the room to a frame, of length 1."""

    kind = "axis"

    def read(self, motions: Sequence, frames: np.ndarray, q: Numbers) -> np.ndarray | str:
        axis, _ = axis_and_angle(followed(motions, self.frame, q))
        return "any axis" if axis is None else axis


@dataclass(frozen=True)
class TurnAngle(Turned):
    """Its angle about that axis, in degrees from 0 to 360."""

    kind = "angle"

    def read(self, motions: Sequence, frames: np.ndarray, q: Numbers) -> np.ndarray | str:
        return np.array([axis_and_angle(followed(motions, self.frame, q))[1]])


@dataclass(frozen=True)
class RollPitchYaw(Turned):
    """Roll, pitch and yaw of a frame in degrees, read off its axes; what is left where pitch = 90°.
    """

    kind = "rpy"

    def read(self, motions: Sequence, frames: np.ndarray, q: Numbers) -> np.ndarray | str:
        return roll_pitch_yaw(frames[self.frame][:3, :3])


Part = Vector | Distance | Amount | Volume | Entry | Turned
TURNS = {part.kind for part in (Turned, TurnAxis, TurnAngle, RollPitchYaw)}


@dataclass(frozen=True)
class Reading:
    """A formula under the picture: text with a ``{}`` for each part."""

    name: str
    text: str
    parts: tuple[Part, ...]

    @property
    def words(self) -> list[str]:
        """What stands before, between and after the parts; braces of a name are only letters."""
        return self.text.split("{}", len(self.parts))

    def data(self) -> dict:
        """Plain data for the browser."""
        return {"name": self.name, "words": self.words,
                "parts": [part.data() for part in self.parts]}

    def said(self, parts: Iterable[str]) -> str:
        """The formula with these texts for its parts."""
        first, *rest = self.words
        return first + "".join(part + words for part, words in zip(parts, rest))
