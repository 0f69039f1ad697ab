"""What is drawn: a list of items that matplotlib draws once and the browser moves.

A scene holds elementary motions, which the knobs of a view drive, and items, each made of points
in the frames along those motions (frame 0 is the room, frame k stands after motion k). Whoever can
follow the motions and project points can draw the scene at any setting, from any side.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from ..arms.motions import ROTATE, TRANSLATE, Frame, Motion, matrix
from .velocity import Velocity

LINE, FACE, SOLID, ARROW, TEXT, TRACE = "line", "face", "solid", "arrow", "text", "trace"
SPATIAL = {"3-D": (-60.0, 24.0), "top": (-90.0, 90.0), "front": (-90.0, 0.0), "side": (0.0, 0.0)}
PLANAR = {"top": (-90.0, 90.0)}
SIZE = (580.0, 520.0)
_MARGIN = 10.0  # px: half a name of an axis

Point = tuple[int, float, float, float]


@dataclass(frozen=True)
class Step:
    """An elementary motion that a knob may drive: by ``amount + gain * q[joint]``.

    With `start` the knob scrubs: the motion runs from 0 to `gain` while the knob goes from `start`
    to ``start + 1``. With `scrub`, a knob and where it starts, another knob does that to the
    whole motion. It begins at the frame `parent`, or at the one before it.
    """

    kind: str
    axis: int
    amount: float = 0.0
    joint: int | None = None
    gain: float = 1.0
    start: float | None = None
    parent: int | None = None
    scrub: tuple[int, float] | None = None
    track: tuple[float, ...] | None = None

    def value(self, q: Sequence[float]) -> Any:
        """Angle (rad) or length of the motion at the knobs' values `q`."""
        if self.track is not None:
            return float(np.interp(q[self.joint], np.arange(len(self.track)), self.track))
        share = 1.0 if self.scrub is None else _run(q[self.scrub[0]] - self.scrub[1])
        if self.joint is None:
            return share * self.amount
        turned = q[self.joint] if self.start is None else _run(q[self.joint] - self.start)
        return share * (self.amount + self.gain * turned)

    def frame(self, motions: Sequence, frames: Sequence[Frame], q: Sequence[float]) -> Frame:
        """The frame that the motion leads to, given all motions and the frames before it."""
        parent = frames[-1 if self.parent is None else self.parent]
        return parent.moved(Motion(self.kind, self.axis, self.value(q)), ())

    def data(self, k: int) -> list:
        """Plain data for the browser; the motion begins at frame k unless it says otherwise."""
        return [int(self.kind == TRANSLATE), self.axis, float(self.amount),
                -1 if self.joint is None else self.joint, float(self.gain), self.start,
                k if self.parent is None else self.parent, self.scrub, self.track]


def _run(since: float) -> float:
    return min(1.0, max(0.0, since))


@dataclass(frozen=True)
class Item:
    """One drawn thing.

    `shape` says how its points become a path, `style` how that is painted, `layer` which switch
    shows it ('' for always), and items of one `body` stay together when nearer ones are
    laid over farther ones (body -1 lies under everything, in its order). `lift` brings a body
    nearer to the viewer than it is (length unit): a joint covers the link that ends in it,
    frames lie on the arm and their names on both, so that they stay readable. What is on `paper`
    stays where it is however the picture is turned: x to the right, y up.
    """

    gid: str
    shape: str
    style: str
    points: tuple[Point, ...]
    body: int = -1
    layer: str = ""
    text: str = ""
    lift: float = 0.0
    paper: bool = False


@dataclass(frozen=True)
class Vector:
    """The vector from one point to another, with its first `size` components in a frame.

    What stands for it on the picture may be drawn smaller; `scale` makes up for that.
    """

    tail: Point
    head: Point
    frame: int = 0
    size: int = 2
    scale: float = 1.0

    def read(self, scene: Scene, frames: np.ndarray, q: Sequence[float]) -> np.ndarray:
        tail, head = (frames[k] @ (*local, 1.0) for k, *local in (self.tail, self.head))
        return self.scale * (frames[self.frame][:3, :3].T @ (head - tail)[:3])[:self.size]


@dataclass(frozen=True)
class Amount:
    """How far motion number `step` goes: a length, or an angle in degrees."""

    step: int

    def read(self, scene: Scene, frames: np.ndarray, q: Sequence[float]) -> np.ndarray:
        motion = scene.motions[self.step - 1]
        return np.array([motion.value(q) * (math.degrees(1) if motion.kind == ROTATE else 1)])


@dataclass(frozen=True)
class Volume:
    """The product of the half axes of a velocity ellipsoid (or ellipse, `size` 2)."""

    ellipsoid: int
    size: int = 2
    scale: float = 1.0

    def read(self, scene: Scene, frames: np.ndarray, q: Sequence[float]) -> np.ndarray:
        sides = np.diagonal(frames[self.ellipsoid])[:self.size]
        return np.array([self.scale * np.prod(sides)])


@dataclass(frozen=True)
class Entry:
    """One of several texts, by the whole number that a knob stands at."""

    knob: int
    texts: tuple[str, ...]

    def read(self, scene: Scene, frames: np.ndarray, q: Sequence[float]) -> str:
        return self.texts[min(max(round(q[self.knob]), 0), len(self.texts) - 1)]


@dataclass(frozen=True)
class Reading:
    """A formula under the picture: text with a ``{}`` for each part."""

    name: str
    text: str
    vectors: tuple[Vector | Amount | Volume | Entry, ...]


@dataclass(frozen=True)
class Scene:
    """All that is needed to draw something at any setting of its knobs, from any side.

    `center` is the point in the middle of the picture, or, with `focus`, the origin of that frame,
    wherever it goes. `tip` is the frame that a table shows and whose path a trace draws.
    """

    motions: tuple[Step | Velocity, ...]
    items: tuple[Item, ...]
    tip: int
    center: tuple[float, float, float]
    radius: float
    size: tuple[float, float] = SIZE
    presets: dict[str, tuple[float, float]] = field(default_factory=lambda: dict(SPATIAL))
    readings: tuple[Reading, ...] = ()
    focus: int | None = None
    place: tuple[float, float] | None = None  # of the centre on the picture (px), if not its middle

    @property
    def scale(self) -> float:
        """Pixels per length unit: the sphere around all that is drawn just fits the picture."""
        return (min(self.size) / 2 - _MARGIN) / self.radius

    @property
    def wide(self) -> bool:
        """Whether the picture wants the whole width of the page."""
        return self.size[0] > SIZE[0]

    @property
    def heart(self) -> tuple[float, float]:
        """Where the centre lies on the picture (px)."""
        return self.place or (self.size[0] / 2, self.size[1] / 2)

    def frames(self, q: Sequence[float]) -> np.ndarray:
        """Pose of every frame in the room, shape (len(motions) + 1, 4, 4)."""
        frames = [Frame()]
        for step in self.motions:
            frames.append(step.frame(self.motions, frames, q))
        return np.stack([matrix(frame) for frame in frames])

    def middle(self, frames: np.ndarray) -> np.ndarray:
        """The point in the middle of the picture."""
        return np.array(self.center) if self.focus is None else frames[self.focus][:3, 3]

    def read(self, q: Sequence[float]) -> dict[str, tuple[np.ndarray, ...]]:
        """The vectors and amounts of every reading, by its name."""
        frames = self.frames(q)
        return {reading.name: tuple(part.read(self, frames, q) for part in reading.vectors)
                for reading in self.readings}

    def data(self) -> dict:
        """The scene as plain data for the browser."""
        return {
            "motions": [motion.data(k) for k, motion in enumerate(self.motions)],
            "items": [asdict(item) for item in self.items],
            "readings": [asdict(reading) for reading in self.readings],
            "tip": self.tip, "center": self.center, "scale": self.scale, "size": self.size,
            "presets": self.presets, "focus": self.focus, "place": self.heart,
            "wide": self.wide,
        }


def at(frame: int, *points: Sequence[float]) -> tuple[Point, ...]:
    """Points of a frame, as items hold them."""
    return tuple((frame, *(float(x) for x in point)) for point in points)


def subscript(name: str) -> str:
    """Digits lowered as in print: '12' becomes '₁₂'; the tool's E becomes 'ₑ'."""
    return name.translate(str.maketrans("0123456789E", "₀₁₂₃₄₅₆₇₈₉ₑ"))


def circle(count: int) -> np.ndarray:
    """Points round a unit circle in the xy plane; the last one lies on the first."""
    angles = np.linspace(0, 2 * np.pi, count)
    return np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=-1)


def camera(azimuth: float, elevation: float) -> np.ndarray:
    """Rows right, up and towards the viewer of an orthographic view, angles in degrees."""
    a, e = np.radians([azimuth, elevation])
    ca, sa, ce, se = np.cos(a), np.sin(a), np.cos(e), np.sin(e)
    return np.array([[-sa, ca, 0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]])
