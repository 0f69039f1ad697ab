"""Charts as marks on paper, under the still picture; kinlab/browser/chart.js and timed.js draw the
same.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..arms.motions import Numbers
from .chart import LINE, Chart, Curve, Plot, Px, Track, plot
from .paints import FAINT, INK, PAINTS, pen
from .still import Drawn, Mark

Ticks = Sequence[tuple[float, str]]

HEIGHT = 260.0                      # px of a chart under a picture
_SMALL, _LARGE = 2.4, 4.6           # px: half a marker of the steps, and of this one
_GRID = pen(FAINT, 0.8)
_ROUND = np.exp(1j * np.linspace(0, 2 * np.pi, 16, endpoint=False))
_MARKERS = {"dot": np.stack([_ROUND.real, _ROUND.imag], axis=-1),
            "square": np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])}


def chart_marks(chart: Chart, q: Numbers, size: tuple[float, float]) -> list[Drawn]:
    """All that is painted of a chart under a picture of this size."""
    width, top = size
    laid = plot(chart, (width, HEIGHT), q)
    drawn = [Drawn("chart", _frame(chart, laid))]
    for curve, track, (x, name) in zip(chart.curves, laid.tracks, laid.legend):
        y = laid.box[1] - 22
        said = words(name, x + LINE + 6, y, "left", PAINTS[curve.style].get("words", INK))
        drawn.append(Drawn(f"chart-{name}", [*_curve(curve, track), *_sample(curve, x, y), said]))
    return [Drawn(part.gid, [replace(mark, lines=[line + [0, top] for line in mark.lines])
                             for mark in part.marks]) for part in drawn]


def _frame(chart: Chart, laid: Plot) -> list[Mark]:
    """Grid, numbers and titles."""
    left, top, right, bottom = laid.box
    return [*frame_lines(laid.box, laid.across, laid.up), words(chart.up, 4, top - 22, "left"),
            words(chart.across, (left + right) / 2, bottom + 31, "middle")]


def frame_lines(box: tuple[float, float, float, float], across: Ticks, up: Ticks) -> list[Mark]:
    """Grid and numbers round a chart."""
    left, _, right, bottom = box
    lines = [np.array([(left, y), (right, y)]) for y, _ in up]
    lines += [np.array([(x, bottom), (x, bottom + 4)]) for x, _ in across]
    return [Mark(lines, _GRID), *(words(text, left - 7, y, "right") for y, text in up),
            *(words(text, x, bottom + 13, "middle") for x, text in across)]


def words(text: str, x: float, y: float, side: str, colour: str = INK) -> Mark:
    """Words that begin, end or have their middle at a place."""
    return Mark([np.array([(x, y)])], {"fill": colour}, text=text, weight="normal", side=side)


def _curve(curve: Curve, track: Track) -> list[Mark]:
    """The curve as far as it has gone, and the markers."""
    return [Mark([np.array(track.gone)], PAINTS[curve.style]),
            *_marked(curve, track.markers, _SMALL), *_marked(curve, track.gone[-1:], _LARGE)]


def _sample(curve: Curve, x: float, y: float) -> list[Mark]:
    """A piece of the curve with its marker."""
    return [Mark([np.array([(x, y), (x + LINE, y)])], PAINTS[curve.style]),
            *_marked(curve, ((x + LINE / 2, y),), _SMALL)]


def _marked(curve: Curve, places: tuple[Px, ...], half: float) -> list[Mark]:
    ink = PAINTS[curve.style]["stroke"]
    return [Mark([np.array(place) + half * _MARKERS[curve.marker] for place in places],
                 pen(ink, 0.0, fill=ink), closed=True)]
