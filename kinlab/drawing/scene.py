"""What is drawn: a list of items that matplotlib draws once and the browser at every frame.

A scene holds elementary motions, which the knobs of a view drive, and items, each made of points
in the frames along those motions (frame 0 is the room, frame k stands after motion k). Whoever can
follow the motions and project points can draw the scene at any setting, from any side.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import MISSING, asdict, dataclass, field, fields
from typing import Any

import numpy as np

from ..arms.kinematics import twist
from ..arms.motions import Frame, Motion, Numbers, matrix
from .chart import Chart
from .controls import Handle, Knob, PoseTable, Switch, Target, decimals
from .paints import PAINTS
from .readings import Point, Reading
from .timed import Timed

LINE, FACE, HULL, ARROW, TEXT, TRACE = "line", "face", "hull", "arrow", "text", "trace"
TUBE, BALL, BOX, AXIS, NAME = "tube", "ball", "box", "axis", "name"
AREA, SWEEP, PATCH, WAY, CLOUD = "area", "sweep", "patch", "way", "cloud"
SOLIDS = (TUBE, BALL, BOX)  # bodies with a surface that light falls on
SPATIAL = {"3-D": (-60.0, 24.0), "top": (-90.0, 90.0), "front": (-90.0, 0.0), "side": (0.0, 0.0)}
PLANAR = {"top": (-90.0, 90.0)}
SIZE = (580.0, 520.0)
_MARGIN = 10.0  # px: half a name of an axis
_FLAT = 1e-12  # of the ellipsoid's size: what is thinner is flat


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

    def value(self, q: Numbers) -> float:
        """Angle (rad) or length of the motion at the knobs' values `q`."""
        share = 1.0 if self.scrub is None else _run(q[self.scrub[0]] - self.scrub[1])
        if self.joint is None:
            return share * self.amount
        if self.track is not None:
            return float(np.interp(q[self.joint], np.arange(len(self.track)), self.track))
        turned = q[self.joint] if self.start is None else _run(q[self.joint] - self.start)
        return share * (self.amount + self.gain * turned)

    def frame(self, motions: Sequence, frames: Sequence[Frame], q: Numbers) -> Frame:
        """The frame that the motion leads to, given all motions and the frames before it."""
        parent = frames[-1 if self.parent is None else self.parent]
        return parent.moved(Motion(self.kind, self.axis, self.value(q)), ())

    def data(self) -> dict:
        """Plain data for the browser."""
        scrub = {"scrub": dict(zip(("knob", "start"), self.scrub))} if self.scrub else {}
        return _told(self) | scrub


def _told(part: Step | Velocity | Item) -> dict:
    """What the browser has to be told of a motion or an item: fields that are not the usual ones.

    A lesson's picture holds a thousand motions.
    """
    values = {each.name: getattr(part, each.name) for each in fields(part)}
    return {each.name: values[each.name] for each in fields(part)
            if each.default is MISSING or values[each.name] != each.default}


def _run(since: float) -> float:
    return min(1.0, max(0.0, since))


@dataclass(frozen=True)
class Velocity:
    """A frame that shows how fast the origin of frame `of` moves.

    Every joint i moves at `rates[i]` (rad or length per second). With `joint`, the frame stands
    where the origin would be after one second at the velocity that this joint gives it now: an
    arrow from one origin to the other is a column of the Jacobian. Without, its columns L span
    the velocity ellipsoid: L u for unit vectors u are the velocities of joint rates whose squares,
    each divided by its rate's, add up to 1. L is lower triangular.
    """

    of: int
    rates: tuple[float, ...]
    joint: int | None = None

    def frame(self, motions: Sequence[Any], frames: Sequence[Frame], q: Numbers) -> Frame:
        """The frame, given all motions and the frames before it."""
        columns = velocities(motions, frames, self.of, len(self.rates)) * self.rates
        tip = matrix(frames[self.of])[:3, 3]
        if self.joint is not None:
            return _frame(np.eye(3), tip + columns[:, self.joint])
        return _frame(_root(columns @ columns.T), tip)

    def data(self) -> dict:
        """Plain data for the browser."""
        return {"kind": "velocity", **_told(self)}


def velocities(motions: Sequence[Any], frames: Sequence[Frame], of: int, n: int) -> np.ndarray:
    """Velocity of the origin of frame `of` for a unit rate of each of n knobs, shape (3, n)."""
    columns, tip = np.zeros((3, n)), matrix(frames[of])[:3, 3]
    while of > 0:
        motion, pose = motions[of - 1], matrix(frames[of])
        if motion.joint is not None:
            velocity = twist(motion.kind, pose[:3, motion.axis], tip - pose[:3, 3])[:3]
            columns[:, motion.joint] += motion.gain * np.array(velocity)
        of = of - 1 if motion.parent is None else motion.parent
    return columns


def _frame(axes: np.ndarray, origin: np.ndarray) -> Frame:
    return Frame(tuple(map(tuple, axes.T.tolist())), tuple(origin.tolist()))


def _root(square: np.ndarray) -> np.ndarray:
    """The lower triangle L with L L^T = `square`; a direction that is flat gets zeros."""
    L, size = np.zeros((3, 3)), np.trace(square)
    for k in range(3):
        left = square[:, k] - L @ L[k]
        if left[k] > _FLAT * size:
            L[k:, k] = left[k:] / np.sqrt(left[k])
    return L


@dataclass(frozen=True)
class Item:
    """One drawn thing, made of points in the frames along the motions.

    ====== ================================== ================================================
    shape  points                             size
    ====== ================================== ================================================
    line   its corners; never filled
    face   corners, seen from one side only
    hull   any; drawn is the outline of all
    arrow  tail, tip; or its corners, if it
           is bent
    trace  one, whose way is drawn
    text   one, where the words want to       number of a knob, to stand there with its value
           stand, and one to keep off
    tube   middles of its two ends            radius at the first, radius at the second
    ball   its middle                         radius
    box    middles of two opposite faces A    1.0 if it is shown only while B lies on the z
           and B; then A plus half the width  side of A (a rod that may be wholly inside its
           of A one way, and the other way    sleeve)
    axis   origin O, and O plus a unit        where outside the arm it begins (length), and
           vector: an arrow of constant size  how many frames before it have the same origin
    name   those of the axis that it names    those of that axis
    sweep  one, carried along a curve         numbers of two motions from one frame: the first
                                              carries the point, the curve leads to where the
                                              second would
    patch  one; drawn is what it sweeps       the same for two pairs of motions, the first one
                                              nearer to the room
    way    its corners, one for each step     number of the knob that says how far it has gone
    area   its corners; seen from both sides
    cloud  the lowest corner of a lattice in  number of a frame, on the negative side of whose y
           the room, on which its dots lie;   axis dots are cut away while the layer "slice" is on,
           its text is what `packed` gives    and the lattice's step
    ====== ================================== ================================================

    `shape` says how its points become a path, `style` how that is painted, `layer` which switch
    shows it ('' for always). Solids and axes cover each other as they stand in the room, words
    lie over all. Of the other shapes, those of one `body` stay together when nearer ones are
    laid over farther ones (body -1 lies under everything, in its order), and `lift` brings a
    body nearer to the viewer than it is (length unit): a target lies over the way to it.

    `part`, `frame`, `joint` and `link` say what it is a picture of: a kind of thing such as
    "joint", the name of a frame, the number of a joint from 1, and of the link that it moves
    with, 0 for the base. With `when`, a knob's number and two of its values, it is there only
    while the knob stands between them.
    """

    gid: str
    shape: str
    style: str
    points: tuple[Point, ...]
    body: int = -1
    layer: str = ""
    text: str = ""
    lift: float = 0.0
    size: tuple[float, ...] = ()
    part: str = ""
    frame: str = ""
    joint: int | None = None
    link: int | None = None
    when: tuple[int, float, float] | None = None

    def data(self) -> dict:
        """Plain data for the browser."""
        return _told(self)


@dataclass(frozen=True)
class Floor:
    """The ground: a grid with numbers, the shadow of all solids, and lines dropped on it.

    Lines are `step` apart and reach `reach` from the room's origin, at the height `height`. From
    the origin of each frame in `drops` a line falls to its foot; numbers have `decimals`.
    """

    height: float
    step: float
    reach: float
    drops: tuple[int, ...] = ()
    decimals: int = 2


@dataclass(frozen=True)
class Fit:
    """The picture follows the solids: at home they fill it, and no pose leaves it.

    `middle` and `radius` are those of a ball round the arm at home, `thick` the radius of its
    joints. The `points` stay in the picture as well.
    """

    middle: tuple[float, float, float]
    radius: float
    thick: float
    points: tuple[Point, ...] = ()


@dataclass(frozen=True)
class Scene:
    """All that is needed to draw something at any setting of its knobs, from any side.

    `center` is the point in the middle of the picture, or, with `focus`, the origin of that frame,
    wherever it goes. `tip` is the frame that a table shows and whose path a trace draws. The rest
    stands beside the picture: whoever shows a scene has nothing to ask elsewhere.
    """

    motions: tuple[Step | Velocity, ...]
    items: tuple[Item, ...]
    tip: int
    center: tuple[float, float, float]
    radius: float
    size: tuple[float, float] = SIZE
    presets: dict[str, tuple[float, float]] = field(default_factory=lambda: dict(SPATIAL))
    preset: str = ""                          # to begin with; the first one if left out
    sights: tuple[str, ...] = ()              # axes that one looks along by a button, "z₁"
    readings: tuple[Reading, ...] = ()
    focus: int | None = None
    name: str = ""
    knobs: tuple[Knob, ...] = ()
    start: tuple[float, ...] | None = None    # values of the knobs; their homes if left out
    switches: tuple[Switch, ...] = ()
    pose: PoseTable | None = None
    poses: tuple[tuple[float, ...], ...] = () # that Play moves between
    joints: tuple[int, ...] | None = None     # knobs that Zero sets; all of them if left out
    target: Target | None = None
    handles: tuple[Handle, ...] = ()          # points that a hand may drag
    decimals: int | None = None               # of formulas; what fits the size if left out
    floor: Floor | None = None
    fit: Fit | None = None                    # how the picture is framed; by the radius if left out
    chart: Chart | None = None                # beside the picture
    timed: Timed | None = None                # curves over time, which the first knob runs through

    @property
    def scale(self) -> float:
        """Pixels per length unit: the sphere around all that is drawn just fits the picture."""
        return (min(self.size) / 2 - _MARGIN) / self.radius

    @property
    def wide(self) -> bool:
        """Whether the picture wants the whole width of the page."""
        return self.size[0] > SIZE[0]

    def frames(self, q: Numbers) -> np.ndarray:
        """Pose of every frame in the room, shape (len(motions) + 1, 4, 4)."""
        frames, q = [Frame()], self.places(q)
        for step in self.motions:
            frames.append(step.frame(self.motions, frames, q))
        return np.stack([matrix(frame) for frame in frames])

    def places(self, q: Numbers) -> Numbers:
        """The knobs' values as motions and items take them: of a time the number of its sample."""
        return [self.timed.place(float(q[0])), *q[1:]] if self.timed else q

    def middle(self, frames: np.ndarray) -> np.ndarray:
        """The point in the middle of the picture."""
        return np.array(self.center) if self.focus is None else frames[self.focus][:3, 3]

    @property
    def seen_from(self) -> str:
        """The preset to begin with."""
        return self.preset or next(iter(self.presets))

    @property
    def begin(self) -> list[float]:
        """Values of the knobs to begin with, within their limits; Home leads back to them."""
        start = [knob.home for knob in self.knobs] if self.start is None else self.start
        return [knob.within(float(value)) for knob, value in zip(self.knobs, start)]

    @property
    def shown(self) -> tuple[str, ...]:
        """Layers that are switched on to begin with."""
        return tuple(switch.layer for switch in self.switches if switch.on)

    def read(self, q: Numbers) -> dict[str, tuple[np.ndarray | str, ...]]:
        """The vectors and amounts of every reading, by its name."""
        frames, q = self.frames(q), self.places(q)
        return {reading.name: tuple(part.read(self.motions, frames, q)
                                    for part in reading.parts)
                for reading in self.readings}

    def _styles(self) -> dict[str, None]:
        curves = self.chart.curves if self.chart else ()
        courses = [course for panel in self.timed.panels for course in panel.courses
                   ] if self.timed else ()
        return dict.fromkeys(["amber", *(item.style for item in self.items),
                              *(curve.style for curve in (*curves, *courses))])

    def _zero(self) -> list[float | None] | None:
        """Where Zero moves the knobs; None for those that stay, or for all of them."""
        joints = range(len(self.knobs)) if self.joints is None else self.joints
        moved = [knob.within(0.0) if k in joints else None for k, knob in enumerate(self.knobs)]
        return moved if len(joints) else None

    def data(self) -> dict:
        """The scene as plain data for the browser."""
        plain = ("name", "tip", "center", "radius", "scale", "size", "presets", "focus", "wide",
                 "poses", "sights")
        return {key: getattr(self, key) for key in plain} | {
            "motions": [motion.data() for motion in self.motions],
            "items": [item.data() for item in self.items],
            "paints": {style: PAINTS[style] for style in self._styles()},
            "readings": [reading.data() for reading in self.readings],
            "preset": self.seen_from,
            "knobs": [knob.data() for knob in self.knobs],
            "home": self.begin, "zero": self._zero(),
            "layers": [asdict(switch) for switch in self.switches],
            "pose": self.pose and self.pose.data(),
            "target": self.target and asdict(self.target),
            "handles": [asdict(handle) for handle in self.handles],
            "chart": self.chart and self.chart.data(),
            **({"timed": self.timed.data()} if self.timed else {}),
            "floor": self.floor and asdict(self.floor), "fit": self.fit and asdict(self.fit),
            "decimals": decimals(self.radius) if self.decimals is None else self.decimals,
        }


def at(frame: int, *points: Numbers) -> tuple[Point, ...]:
    """Points of a frame, as items hold them."""
    return tuple((frame, float(x), float(y), float(z)) for x, y, z in points)


def origin_of(frame: int) -> Point:
    """The origin of a frame, as items hold it."""
    return (frame, 0.0, 0.0, 0.0)


def circle(count: int) -> np.ndarray:
    """Points round a unit circle in the xy plane; the last one lies on the first."""
    angles = np.linspace(0, 2 * np.pi, count)
    return np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=-1)
