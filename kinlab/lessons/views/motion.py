"""The views of lesson 12: four ways to spend one second."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ...arms.motions import TRANSLATE, X, Y
from ...drawing.controls import Knob
from ...drawing.scene import SIZE, WAY, at
from ...drawing.sketch import Sketch
from ...drawing.timed import Timed
from ...paths.profiles import cubic, given_profile, quintic
from ...views.live import LiveView

_N = 120                                  # steps of the second
_TOP, _APART = 0.5, 0.12                  # of the highest rail; from rail to rail
_WIDE, _HIGH, _LOW = 0.42, 0.48, -0.56    # of a chart, and where it stands
_TITLE = 0.09                             # how far over it; between stands an ∞
_STYLES = {"constant rate": "dashed", "cubic": "first", "quintic": "second",
           "trapezoidal": "angle"}
_SHARES = np.linspace(0, 1, _N + 1)
_CURVES = {"cubic": cubic, "quintic": quintic, "trapezoidal": given_profile("trapezoidal").curve}


def dots_view() -> LiveView:
    """Four dots on rails, which start and arrive together; a mark reaches both ends of a rail."""
    return _second(_dots, radius=0.42, middle=0.3, size=(580.0, 330.0))


def race_view() -> LiveView:
    """The dots, and under them charts of rate and acceleration."""
    return _second(_dots, _charts)


def _second(*parts: Callable[[Sketch, int], None], radius: float = 0.62, middle: float = 0.0,
            size: tuple[float, float] = SIZE) -> LiveView:
    """A second that a knob runs through, and what is drawn in it."""
    sketch = Sketch("Four ways to go 1 rad in 1 s", radius, center=(0.5, middle, 0), grid=0)
    sketch.size = size
    time = sketch.knob(Knob("time", "t", 0.0, 1.0, 0.0, "s", 1.0, 0.01, "time since the start"))
    for part in parts:
        part(sketch, time)
    sketch.poses, sketch.joints = [[k / 10] for k in range(11)], ()
    return LiveView(replace(sketch.scene(), timed=Timed(tuple(_SHARES.tolist()), ())))


def _dots(sketch: Sketch, time: int) -> None:
    rails = [_dot(sketch, 0, "constant rate", _SHARES, time),
             *(_dot(sketch, k, name, curve(_SHARES)[0], time)
               for k, (name, curve) in enumerate(_CURVES.items(), start=1))]
    for place, word in ((0, "0"), (1, "1 rad")):
        sketch.label(word, at(rails[-1], (place, 0, 0), (place, 0.1, 0)))


def _charts(sketch: Sketch, time: int) -> None:
    rate = _Chart(sketch, "rate (rad/s)", 0.0, (0.0, 2.0), 1.0)
    acceleration = _Chart(sketch, "acceleration (rad/s²)", 1 - _WIDE, (-6.0, 6.0), 6.0)
    rate.curve("constant rate", np.ones(_N + 1), time)
    acceleration.leaps(time)
    for name, curve in _CURVES.items():
        _, *derivatives = curve(_SHARES)
        rate.curve(name, derivatives[0], time)
        acceleration.curve(name, derivatives[1], time)


def _dot(sketch: Sketch, k: int, name: str, way: np.ndarray, time: int) -> int:
    """A dot on its rail, where the time has brought it; the rail's frame."""
    rail = sketch.move(TRANSLATE, Y, _TOP - _APART * k, None, 0)
    sketch.line(f"rail-{name}", at(rail, (0, 0, 0), (1, 0, 0)), _STYLES[name])
    sketch.point(name, sketch.move(TRANSLATE, X, 0.0, time, rail, track=tuple(way.tolist())),
                 (0, 0))
    return rail


class _Chart:
    """A small chart on the sketch, over one second."""

    def __init__(self, sketch: Sketch, title: str, left: float, ends: tuple[float, float],
                 tick: float) -> None:
        self.sketch, self.title, self.left, self.ends = sketch, title, left, ends
        for value in np.arange(ends[0], ends[1] + tick / 2, tick):
            row = [self._place(time, value) for time in (0.0, 1.0)]
            sketch.line(f"{title}-{value:g}", at(0, *row), "mesh")
            sketch.label(f"{value:g}".replace("-", "−"), at(0, row[0] - [0.02, 0, 0], row[1]))
        low, high = self._place(0.5, ends[0]), self._place(0.5, ends[1])
        sketch.label(title, at(0, high + [0, _TITLE, 0], low))
        for time, word in ((0.0, "0"), (1.0, "1 s")):
            foot = self._place(time, ends[0])
            sketch.label(word, at(0, foot, foot + [0, 0.1, 0]))

    def curve(self, name: str, values: np.ndarray, time: int) -> None:
        """A curve, as far as the time has gone."""
        corners = [self._place(*pair) for pair in zip(np.linspace(0, 1, _N + 1), values)]
        self.sketch.add(f"{self.title}-{name}", WAY, _STYLES[name], at(0, *corners), size=(time,),
                        lift=1.0, part="line")

    def leaps(self, time: int) -> None:
        """What a constant rate asks for at both ends: more than the chart holds."""
        for share, value, since in ((0.0, self.ends[1], 1), (1.0, self.ends[0], _N)):
            there = (time, since, _N)
            zero, end = (self._place(share, height) for height in (0.0, 1.1 * value))
            self.sketch.line(f"{self.title}-leap-{share:g}", at(0, zero, end), when=there)
            self.sketch.label("∞", at(0, end, zero), when=there)

    def _place(self, time: float, value: float) -> np.ndarray:
        """Where a value stands on the sketch."""
        low, high = self.ends
        return np.array([self.left + _WIDE * time, _LOW + _HIGH * (value - low) / (high - low),
                         0.0])
