"""A chart beside a picture: curves over counted steps, drawn as far as a knob has gone.

Heights are powers of ten: what falls from step to step by the same factor is a straight line.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from itertools import accumulate

from ..arms.motions import Numbers
from .controls import superscript

Px = tuple[float, float]

LEFT, RIGHT, TOP, BOTTOM = 48.0, 16.0, 34.0, 42.0  # px of the margins round the curves
_WIDE, _HIGH = 34.0, 24.0                          # px that a number wants on an axis
_APART = 7.0                                       # px between markers
LINE, _GAP, _LETTER = 26.0, 14.0, 7.0              # px: a piece of a curve, a gap, a letter
_LOWEST = -300                                     # decade of what is smaller still, and of zero


@dataclass(frozen=True)
class Curve:
    """A named curve: its values at the steps 0, 1, 2, ..., and the marker that stands on each."""

    name: str
    style: str
    marker: str  # "dot" or "square"
    values: tuple[float, ...]


@dataclass(frozen=True)
class Chart:
    """Curves over the same steps, with the titles of both axes.

    Knob number `knob` says up to which step the curves are drawn.
    """

    curves: tuple[Curve, ...]
    across: str
    up: str
    knob: int = 0

    @property
    def last(self) -> int:
        """The last step of the longest curve."""
        return max(1, *(len(curve.values) - 1 for curve in self.curves))

    @property
    def decades(self) -> tuple[int, int]:
        """Powers of ten between which all values lie; zero lies at the lower one."""
        heights = [_height(value) for curve in self.curves for value in curve.values if value > 0]
        low, high = (math.floor(min(heights, default=0)), math.ceil(max(heights, default=0)))
        return min(low, high - 1), high

    def data(self) -> dict:
        """Plain data for the browser."""
        low, high = self.decades
        return asdict(self) | {"last": self.last, "low": low, "high": high}


@dataclass(frozen=True)
class Track:
    """A curve on the picture as far as the knob has gone, and markers on its steps (px)."""

    gone: tuple[Px, ...]
    markers: tuple[Px, ...]


@dataclass(frozen=True)
class Plot:
    """A chart laid out on a picture: places in px from its upper left corner.

    `across` and `up` are the ticks of the axes: how far to the right, or down, and what they say.
    `legend` says where a piece of each curve begins, with its name behind.
    """

    box: tuple[float, float, float, float]  # left, top, right, bottom
    across: tuple[tuple[float, str], ...]
    up: tuple[tuple[float, str], ...]
    tracks: tuple[Track, ...]
    legend: tuple[tuple[float, str], ...]


def plot(chart: Chart, size: tuple[float, float], q: Numbers) -> Plot:
    """The chart on a picture of this size, at the knobs' values `q`."""
    width, height = size
    left, top, right, bottom = box = (LEFT, TOP, width - RIGHT, height - BOTTOM)
    (low, high), wide = chart.decades, (right - left) / chart.last
    deep = (bottom - top) / (high - low)
    steps = range(0, chart.last + 1, _nice(_WIDE / wide))
    decades = range(high, low - 1, -math.ceil(_HIGH / deep))
    tracks = []
    for curve in chart.curves:
        points = [(left + j * wide, bottom - (max(_height(value), low) - low) * deep)
                  for j, value in enumerate(curve.values)]
        tracks.append(_track(points, q[chart.knob], math.ceil(_APART / wide)))
    return Plot(box, tuple((left + j * wide, str(j)) for j in steps),
                tuple((top + (high - k) * deep, f"10{superscript(k)}") for k in decades),
                tuple(tracks), _legend(chart.curves, right))


def _track(points: Sequence[Px], at: float, every: int) -> Track:
    at = min(max(at, 0.0), len(points) - 1.0)
    k = math.floor(at)
    here = [] if at == k else [_between(points[k], points[k + 1], at - k)]
    return Track((*points[:k + 1], *here), tuple(points[:k + 1:every]))


def _legend(curves: Sequence[Curve], right: float) -> tuple[tuple[float, str], ...]:
    wide = [LINE + 6 + _LETTER * len(curve.name) + _GAP for curve in curves]
    begins = accumulate(wide, initial=right + _GAP - sum(wide))
    return tuple((x, curve.name) for x, curve in zip(begins, curves))


def _between(one: Px, other: Px, share: float) -> Px:
    (x, y), (u, v) = one, other
    return x + share * (u - x), y + share * (v - y)


def _height(value: float) -> float:
    """The value as a power of ten."""
    return math.log10(value) if value > 0 else _LOWEST


def _nice(least: float) -> int:
    """The smallest of 1, 2, 5, 10, 20, ... that is no less than `least`."""
    tens = 10 ** max(0, math.floor(math.log10(least)))
    return next(step * tens for step in (1, 2, 5, 10) if step * tens >= least)
