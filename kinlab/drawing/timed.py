"""Curves over time beside a picture, with the limits that they should keep.

Each is drawn whole, and strongly as far as the time has gone. kinlab/browser/timed.js lays out the
same.
"""
from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from itertools import count

Px = tuple[float, float]

LEFT, RIGHT, TOP, BOTTOM = 54.0, 12.0, 26.0, 22.0  # px of the margins round the curves
_WIDE, _HIGH = 44.0, 26.0  # px that a number wants on an axis
_AIR = 0.06                # of the range: beyond the farthest values
_NEAR = 0.2                # of the range: a limit that is no farther beyond a curve is drawn
_LONG, _FINE = 5, 4        # powers of ten, and decimals: beyond these a number on an axis has an e
_DIGITS = 5                # of a value: more are not seen
_SIGN_WIDE, _SIGN_HIGH, _SIGN_DOWN = 34.0, 15.0, 9.0  # px of a band's sign, and to the first row


@dataclass(frozen=True)
class Course:
    """A named curve: its values at the times; `joint` counts from 1."""

    name: str
    style: str
    values: tuple[float, ...]
    unit: str
    joint: int | None = None


@dataclass(frozen=True)
class Bound:
    """A value that a joint's curve should not pass."""

    level: float
    style: str
    joint: int


@dataclass(frozen=True)
class Band:
    """A stretch of time in which a joint's curve is beyond its bound."""

    start: float
    end: float
    joint: int


@dataclass(frozen=True)
class Panel:
    """Curves of one kind over the same times, under a title; with a `layer` a button shows it."""

    title: str
    courses: tuple[Course, ...]
    bounds: tuple[Bound, ...] = ()
    bands: tuple[Band, ...] = ()
    layer: str = ""

    @property
    def near(self) -> tuple[Bound, ...]:
        """The bounds that are drawn: those to which their joint's curve comes near."""
        values = [v for course in self.courses for v in _finite(course)]
        room = _NEAR * (max(values, default=0.0) - min(values, default=0.0))
        ends = {course.joint: (min(_finite(course), default=0.0) - room,
                               max(_finite(course), default=0.0) + room)
                for course in self.courses}
        return tuple(bound for bound in self.bounds
                     if ends[bound.joint][0] <= bound.level <= ends[bound.joint][1])

    @property
    def ends(self) -> tuple[float, float]:
        """Lowest and highest value that is seen: those of curves and bounds."""
        seen = [*(v for course in self.courses for v in _finite(course)),
                *(bound.level for bound in self.near)] or [0.0]
        low, high = min(seen), max(seen)
        air = _AIR * (high - low) or 0.1 * abs(high) or 1.0
        return low - air, high + air

    def data(self) -> dict:
        """Plain data for the browser: what is infinite ends at the edge."""
        low, high = self.ends
        courses = [asdict(course) | {"values": [_short(min(max(v, low), high))
                                                for v in course.values]}
                   for course in self.courses]
        bounds = [asdict(bound) for bound in self.near]
        return {"title": self.title, "layer": self.layer, "low": low, "high": high,
                "courses": courses, "bounds": bounds, "bands": [asdict(b) for b in self.bands]}


@dataclass(frozen=True)
class Remark:
    """A sentence under the curves, about a joint."""

    text: str
    joint: int


@dataclass(frozen=True)
class Timed:
    """Panels over the same times, which the scene's first knob runs through, and what is said.

    Motions that follow a track, and ways, have a value for each of the times.
    """

    times: tuple[float, ...]
    panels: tuple[Panel, ...]
    remarks: tuple[Remark, ...] = ()

    def place(self, time: float) -> float:
        """The number of the sample at a time; between two of them a part of one."""
        return place(self.times, time)

    def data(self) -> dict:
        """Plain data for the browser."""
        return {"times": [_short(time, 6) for time in self.times],
                "panels": [panel.data() for panel in self.panels],
                "remarks": [asdict(remark) for remark in self.remarks]}


@dataclass(frozen=True)
class Laid:
    """A panel on a picture: places in px from its upper left corner.

    `across` and `up` are the ticks of the axes, `zero` where a value is 0. Of each course the whole
    curve and the part that is gone; of bounds how far down, of bands where they begin and end, and
    where their signs stand.
    """

    box: tuple[float, float, float, float]  # left, top, right, bottom
    across: tuple[tuple[float, str], ...]
    up: tuple[tuple[float, str], ...]
    zero: float | None
    whole: tuple[tuple[Px, ...], ...]
    gone: tuple[tuple[Px, ...], ...]
    bounds: tuple[float, ...]
    bands: tuple[tuple[float, float], ...]
    signs: tuple[Px, ...]
    now: float


def laid(panel: dict, times: Sequence[float], size: tuple[float, float], time: float) -> Laid:
    """A panel's plain data on a picture of this size, at a time."""
    width, height = size
    left, top, right, bottom = box = (LEFT, TOP, width - RIGHT, height - BOTTOM)
    low, high, last = panel["low"], panel["high"], times[-1]
    wide, deep = (right - left) / last, (bottom - top) / (high - low)

    def down(value: float) -> float:
        return bottom - (value - low) * deep

    whole = tuple(tuple((left + t * wide, down(v)) for t, v in zip(times, course["values"]))
                  for course in panel["courses"])
    at = place(times, time)
    bands = tuple((left + band["start"] * wide, left + band["end"] * wide)
                  for band in panel["bands"])
    return Laid(box, tuple((left + t * wide, text if t else f"{text} s")
                           for t, text in _ticks(0.0, last, _WIDE / wide)),
                tuple((down(v), text) for v, text in _ticks(low, high, _HIGH / deep)),
                down(0.0) if low <= 0 <= high else None, whole,
                tuple(_gone(points, at) for points in whole),
                tuple(down(bound["level"]) for bound in panel["bounds"]),
                bands, tuple(_signs(bands, box)), left + min(max(time, 0.0), last) * wide)


def _signs(bands: Sequence[tuple[float, float]],
           box: tuple[float, float, float, float]) -> Iterator[Px]:
    """In the middle of each band, within the panel, and in a row where no other sign is."""
    left, top, right, _ = box
    taken: list[tuple[float, int]] = []
    for start, end in bands:
        x = min(max((start + end) / 2, left + _SIGN_WIDE / 2), right - _SIGN_WIDE / 2)
        row = next(row for row in count()
                   if all(row != other or abs(x - u) >= _SIGN_WIDE for u, other in taken))
        taken.append((x, row))
        yield x, top + _SIGN_DOWN + row * _SIGN_HIGH


def place(times: Sequence[float], time: float) -> float:
    """The number of the sample at a time, or between which two it is."""
    if time >= times[-1]:
        return len(times) - 1.0
    k = max(0, bisect_right(times, time) - 1)
    return k + max(0.0, (time - times[k]) / (times[k + 1] - times[k]))


def _gone(points: Sequence[Px], at: float) -> tuple[Px, ...]:
    k = math.floor(at)
    if at == k:
        return tuple(points[:k + 1])
    (x, y), (u, v) = points[k:k + 2]
    return (*points[:k + 1], (x + (at - k) * (u - x), y + (at - k) * (v - y)))


def _ticks(low: float, high: float, least: float) -> list[tuple[float, str]]:
    """Round numbers from low to high, at least so far apart, and how they are written."""
    tens = math.floor(math.log10(least))
    part, e = next((k, e) for e in (tens, tens + 1) for k in (1, 2, 5)
                   if k * 10.0 ** e >= least * (1 - 1e-9))
    step = part * 10.0 ** e
    first = math.ceil(low / step - 1e-9)
    count = math.floor(high / step + 1e-9) - first + 1
    return [((first + k) * step, _number((first + k) * part, e)) for k in range(count)]


def _number(value: int, tens: int) -> str:
    """A value times a power of ten; with an e if it is too long for an axis."""
    sign, digits = "−" if value < 0 else "", str(abs(value))
    power = tens + len(digits) - 1
    if value and (power >= _LONG or tens < -_FINE):
        first, rest = digits[0], digits[1:].rstrip("0")
        return f"{sign}{first}{'.' if rest else ''}{rest}e{power}".replace("-", "−")
    if tens < -_FINE:
        return "0"
    return f"{sign}{abs(value) * 10.0 ** tens:.{max(0, -tens)}f}"


def _finite(course: Course) -> list[float]:
    return [value for value in course.values if math.isfinite(value)]


def _short(value: float, digits: int = _DIGITS) -> float:
    return float(f"{value:.{digits}g}")
