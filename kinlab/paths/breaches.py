"""Where a path leaves the limits of a joint: from when to when, and how far."""
from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import degrees, floor, log10

import numpy as np

from ..arms.arm import Arm
from ..arms.link import REVOLUTE, Link

CLOSE = 1e-9   # of a limit: what is nearer to it keeps it
HALVINGS = 40  # of the time between two samples, to find where a limit is passed
LIMIT, SPEED, ACCELERATION = "limit", "speed", "acceleration"
_SAYS = {LIMIT: "is beyond its limit of", SPEED: "is faster than",
         ACCELERATION: "speeds up or slows down by more than"}
_PER = {LIMIT: "", SPEED: "/s", ACCELERATION: "/s²"}

Series = Callable[[np.ndarray], Sequence[np.ndarray]]  # q, rates and accelerations at times


@dataclass(frozen=True)
class Breach:
    """A stretch of time in which a joint is beyond one of its limits.

    Attributes
    ----------
    joint : int
        Its number, from 1.
    kind : {"limit", "speed", "acceleration"}
    start, end : float
        Seconds.
    worst : float
        The value farthest beyond: of the joint (rad or the arm's unit), or the size of its rate
        or of its acceleration.
    limit : float
        The limit that is passed, in the same unit.
    text : str
        The sentence that says all this, with angles in degrees; what `str` gives.
    """

    joint: int
    kind: str
    start: float
    end: float
    worst: float
    limit: float
    text: str

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class Bound:
    """One limit of a joint: `way` is 1 for the highest value allowed, -1 for the lowest one, and
    0 for the largest size. `order` counts derivatives by time.
    """

    joint: int
    order: int
    limit: float
    way: int = 0

    def beyond(self, values: np.ndarray) -> np.ndarray:
        """How far values are beyond the limit."""
        return (self.way * (values - self.limit) if self.way else np.abs(values) - self.limit)

    def breaks(self, values: np.ndarray) -> np.ndarray:
        """Whether they are beyond it."""
        return self.beyond(values) > CLOSE * max(1.0, abs(self.limit))


def bounds(arm: Arm) -> Iterator[Bound]:
    """All limits that the arm's joints have."""
    for i, link in enumerate(arm.joints):
        for way, limit in zip((-1, 1), link.limits or ()):
            yield Bound(i, 0, limit, way)
        for order, most in ((1, link.speed), (2, link.acceleration)):
            if most is not None:
                yield Bound(i, order, most)


def breaches(arm: Arm, t: np.ndarray, samples: Sequence[np.ndarray], series: Series
             ) -> Iterator[Breach]:
    """All breaches of a path, joint by joint, given its samples and what it does at any time.

    A breach begins and ends where halving the time between two samples finds it.
    """
    for bound in bounds(arm):
        def breaks(time: float, bound: Bound = bound) -> bool:
            return bool(bound.breaks(series(np.array([time]))[bound.order][:, bound.joint])[0])

        values = samples[bound.order][:, bound.joint]
        broken = np.flatnonzero(bound.breaks(values))
        for run in np.split(broken, np.flatnonzero(np.diff(broken) > 1) + 1):
            if len(run):
                first, last = int(run[0]), int(run[-1])
                start = t[0] if first == 0 else _edge(breaks, t[first], t[first - 1])
                end = t[-1] if last == len(t) - 1 else _edge(breaks, t[last], t[last + 1])
                worst = values[run][bound.beyond(values[run]).argmax()]
                yield _breach(arm.joints[bound.joint], arm.unit, bound, (start, end), worst, t[-1])


def brief(value: float, whole: float, digits: int = 3) -> str:
    """A number in a few digits, and no more of them than are seen beside what it is a part of.

    Examples
    --------
    >>> brief(1.2345e-05, 2), brief(-4e-9, 1), brief(0.21132, 1), brief(1234.5, 3600)
    ('0', '0', '0.211', '1230')
    """
    rounded = float(f"{round(value, digits - floor(log10(whole))):.{digits}g}")
    return f"{rounded + 0.0:g}"


def _edge(breaks: Callable[[float], bool], inside: float, outside: float) -> float:
    """Where a breach ends between a time inside and one outside."""
    for _ in range(HALVINGS):
        middle = (inside + outside) / 2
        inside, outside = (middle, outside) if breaks(middle) else (inside, middle)
    return inside


def _breach(link: Link, unit: str, bound: Bound, times: tuple[float, float], worst: float,
            duration: float) -> Breach:
    kind = (LIMIT, SPEED, ACCELERATION)[bound.order]
    size = degrees(bound.limit) if link.kind == REVOLUTE else bound.limit
    of = "deg" if link.kind == REVOLUTE else unit
    text = (f"joint {bound.joint + 1} {_SAYS[kind]} {size:.4g} {of}{_PER[kind]} "
            f"from {brief(times[0], duration)} s to {brief(times[1], duration)} s")
    return Breach(bound.joint + 1, kind, float(times[0]), float(times[1]),
                  float(worst if bound.way else abs(worst)), bound.limit, text)
