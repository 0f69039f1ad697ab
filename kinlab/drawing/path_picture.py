"""A motion in time: the arm on its way, and its joints, rates and tip over time."""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any, Protocol

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import frame_poses
from ..arms.link import REVOLUTE
from .arm_scene import arm_scene
from .controls import Knob, joint_knobs
from .scene import LINE, SOLIDS, TRACE, WAY, Fit, Item, Scene, Step, at
from .timed import Band, Bound, Course, Panel, Remark, Timed

# Of the joints, one after the other: three inks, and another dash where an ink comes again.
STYLES = ("first", "second", "angle", "first-dots", "second-solid", "angle-dash", "first-dash",
          "second-dots", "angle-dots")
STRIDE, BLIND = 6, 2e-3  # samples that one line stands for; of a range: what nobody sees
STOPS = 10    # of the way in time, which steps go through
BODIES = 12   # samples at which all bodies are looked at
EDGE = 0.12   # of the picture's radius: round all that moves
KINDS = ("limit", "speed", "acceleration")
_SAYS = ({True: "joint angles (deg)", False: "slides ({})"},
         {True: "rates (deg/s)", False: "rates of slides ({}/s)"},
         {True: "accelerations (deg/s²)", False: "accelerations of slides ({}/s²)"})


class Broken(Protocol):
    """A stretch of time in which a joint is beyond a limit."""

    @property
    def joint(self) -> int: ...
    @property
    def kind(self) -> str: ...
    @property
    def start(self) -> float: ...
    @property
    def end(self) -> float: ...


class Moved(Protocol):
    """A motion in time, as a path has it."""

    @property
    def duration(self) -> float: ...
    @property
    def t(self) -> np.ndarray: ...
    @property
    def q(self) -> np.ndarray: ...
    @property
    def rates(self) -> np.ndarray: ...
    @property
    def accelerations(self) -> np.ndarray: ...
    @property
    def tip(self) -> np.ndarray: ...
    @property
    def tip_speed(self) -> np.ndarray: ...
    @property
    def broken(self) -> Sequence[Broken]: ...


@dataclass(frozen=True)
class Samples:
    """Some of the samples of a motion."""

    duration: float
    t: np.ndarray
    q: np.ndarray
    rates: np.ndarray
    accelerations: np.ndarray
    tip: np.ndarray
    tip_way: np.ndarray
    tip_speed: np.ndarray
    broken: Sequence[Broken]


def seen(path: Moved) -> Samples:
    """Those samples without which a picture or a curve would be seen to be another one."""
    steps = np.linalg.norm(np.diff(path.tip, axis=0), axis=1)
    way = np.concatenate([[0.0], np.cumsum(steps)])
    series = (path.q, path.rates, path.accelerations, path.tip, path.tip_speed[:, None])
    shares = [weight * _shares(values) for weight, values in zip((4, 1, 1, 4, 1), series)]
    kept = _kept(path.t, np.hstack(shares))  # the arm itself is seen four times as well
    return Samples(path.duration, path.t[kept], path.q[kept], path.rates[kept],
                   path.accelerations[kept], path.tip[kept], way[kept], path.tip_speed[kept],
                   path.broken)


def _shares(values: np.ndarray) -> np.ndarray:
    """Values as parts of the range of all of them together; what is infinite lies at its end."""
    finite = values[np.isfinite(values)]
    low, high = (finite.min(), finite.max()) if len(finite) else (0.0, 0.0)
    return np.clip(values, low, high) / ((high - low) or 1.0)


def _kept(t: np.ndarray, values: np.ndarray) -> list[int]:
    """Numbers of samples between which straight lines are as good as all of them."""
    kept, last = [0], len(t) - 1
    while kept[-1] < last:
        start = kept[-1]
        ends = range(min(start + STRIDE, last), start, -1)
        kept.append(next(end for end in ends if _straight(t, values, start, end)))
    return kept


def _straight(t: np.ndarray, values: np.ndarray, start: int, end: int) -> bool:
    share = ((t[start:end + 1] - t[start]) / (t[end] - t[start]))[:, None]
    line = values[start] + share * (values[end] - values[start])
    return bool(np.abs(line - values[start:end + 1]).max() <= BLIND)


def path_scene(arm: Arm, motion: Moved, *, name: str = "", show: Any = (),
               preset: str = "") -> Scene:
    """The arm, moved along a path by the knob "time", with its tip's way and curves over time."""
    path = seen(motion)
    scene = arm_scene(arm, path.q[0], show=show, preset=preset)
    tracks = path.q.T
    motions = tuple(_tracked(step, tracks) for step in scene.motions)
    items = tuple(item for item in scene.items if item.shape != TRACE)
    end = path.duration
    return replace(
        scene, name=name or f"{arm.name or 'Arm'}: a path of {end:g} s", motions=motions,
        items=(*items, *_way(path, scene.radius)), knobs=(_clock(end),), start=(0.0,), handles=(),
        joints=(), poses=tuple((end * k / STOPS,) for k in range(STOPS + 1)),
        switches=tuple(switch for switch in scene.switches if switch.layer != "trace"),
        fit=_fit(arm, path, scene),
        timed=Timed(tuple(path.t.tolist()), tuple(_panels(arm, path)),
                    tuple(Remark(str(breach), breach.joint) for breach in path.broken)))


def _clock(end: float) -> Knob:
    """A slider through the time, in steps of a hundredth of it or so."""
    step = 10.0 ** math.floor(math.log10(end / 100))
    return Knob("time", "t", 0.0, end, 0.0, "s", 1.0, step, "time", quantity="time")


def _tracked(step: Any, tracks: np.ndarray) -> Any:
    if not isinstance(step, Step) or step.joint is None:
        return step
    values = step.amount + step.gain * tracks[step.joint]
    return replace(step, joint=0, track=tuple(round(float(value), 6) for value in values))


def _way(path: Samples, radius: float) -> list[Item]:
    """The tip's way, pale, and what is gone of it, strong."""
    points = at(0, *np.round(path.tip, _digits(radius)))
    few = [*points[:-1:3], points[-1]]
    return [Item("way", LINE, "coming", tuple(few), body=-1, lift=2 * radius, part="trace"),
            Item("way-gone", WAY, "trace", points, body=0, lift=2.1 * radius, size=(0,),
                 part="trace")]


def _digits(size: float) -> int:
    """Decimals that tell a place in a picture of this size."""
    return 5 - math.floor(math.log10(size))


def _fit(arm: Arm, path: Samples, scene: Scene) -> Fit | None:
    """A frame that holds the arm at all times: the outermost points in 26 directions."""
    some = path.q[::max(1, len(path.q) // BODIES)]
    places = np.concatenate([frame_poses(arm, path.q)[..., :3, 3].reshape(-1, 3), path.tip,
                             *(_bodies(scene, q) for q in some)])
    ways = np.array([way for way in product((-1, 0, 1), repeat=3) if any(way)], float)
    ways /= np.linalg.norm(ways, axis=1)[:, None]
    outermost = places[(places @ ways.T).argmax(axis=0)] + EDGE * scene.radius * ways
    low, high = outermost.min(axis=0), outermost.max(axis=0)
    thick = scene.fit.thick if scene.fit else 0.0
    return Fit((*((low + high) / 2).tolist(),), float(np.sort(high - low)[1]) / 2, thick,
               at(0, *np.round(outermost, _digits(scene.radius))))


def _bodies(scene: Scene, q: np.ndarray) -> np.ndarray:
    """The ends of all solids, a rod's far one, too, shape (k, 3)."""
    frames = scene.frames(q.tolist())
    return np.array([(frames[k] @ (*local, 1.0))[:3] for item in scene.items
                     if item.shape in SOLIDS for k, *local in item.points])


def _panels(arm: Arm, path: Samples) -> list[Panel]:
    """Joint values, rates, accelerations, how far the tip has gone, and how fast it goes."""
    labels = [knob.label for knob in joint_knobs(arm)]
    panels = []
    for order, values in enumerate((path.q, path.rates, path.accelerations)):
        for turns, words in _SAYS[order].items():
            joints = [i for i, link in enumerate(arm.joints) if (link.kind == REVOLUTE) == turns]
            if joints:
                panels.append(_panel(arm, path, order, joints, labels, values,
                                     words.replace("{}", arm.unit)))
    way, speed = (Course("tip", "trace", tuple(values.tolist()), unit) for values, unit in
                  ((path.tip_way, arm.unit), (path.tip_speed, f"{arm.unit}/s")))
    return [*panels, Panel(f"way of the tip ({arm.unit})", (way,)),
            Panel(f"speed of the tip ({arm.unit}/s)", (speed,), layer="speed of the tip")]


def _panel(arm: Arm, path: Samples, order: int, joints: list[int], labels: list[str],
           values: np.ndarray, title: str) -> Panel:
    """The curves of some joints, with their bounds."""
    turns = arm.joints[joints[0]].kind == REVOLUTE
    scale, unit = (math.degrees(1), "°") if turns else (1.0, arm.unit)
    courses = tuple(Course(labels[i], style(i), tuple((scale * values[:, i]).tolist()), unit, i + 1)
                    for i in joints)
    bounds = tuple(Bound(scale * level, style(i), i + 1)
                   for i in joints for level in _levels(arm, i, order))
    bands = tuple(Band(breach.start, breach.end, breach.joint) for breach in path.broken
                  if breach.kind == KINDS[order] and breach.joint - 1 in joints)
    return Panel(title, courses, bounds, bands, "acceleration" if order == 2 else "")


def _levels(arm: Arm, i: int, order: int) -> tuple[float, ...]:
    """The limits of a joint, of its rate, or of its acceleration."""
    link = arm.joints[i]
    most = (None, link.speed, link.acceleration)[order]
    return (link.limits or ()) if order == 0 else () if most is None else (-most, most)


def style(i: int) -> str:
    """How the curve of joint i is drawn."""
    return STYLES[i % len(STYLES)]
