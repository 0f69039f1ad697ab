"""Curves over time as marks on paper, under the still picture, with what is said of them.

kinlab/browser/timed.js draws the same.
"""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import groupby

import numpy as np

from .chart_marks import frame_lines, words
from .labels import text_size
from .paints import COLOURS, INK, PAINTS, STEEL, Paint, pen
from .still import Drawn, Mark
from .timed import Laid, Timed, laid

HIGH = 150.0                       # px of a panel
_ROW, _SAMPLE, _GAP = 24.0, 30.0, 16.0   # px: of names and of remarks; a piece of a curve; a gap
_PALE = 0.38                       # of a curve that is still to come
_DOT, _LEAST = 3.6, 1.5                  # px: a dot's radius, and a band's width
_ROUND = np.exp(1j * np.linspace(0, 2 * np.pi, 16, endpoint=False))
_NOW, _ZERO = pen(INK, 1.0), pen(STEEL, 0.8)
_BAND: Paint = {"fill": COLOURS["target"].line, "stroke": "none"}
_PAPER: Paint = {"fill": "#ffffff", "stroke": "none"}
_BOUND = {"stroke-width": 1.2, "stroke-dasharray": (7.0, 4.0)}


def timed_height(timed: Timed, width: float) -> float:
    """How high all of it is under a picture of this width (px)."""
    shown = sum(not panel.layer for panel in timed.panels)
    return HIGH * shown + _ROW * (len(_rows(timed, width)) + len(timed.remarks))


def timed_marks(timed: Timed, time: float, size: tuple[float, float]) -> list[Drawn]:
    """All that is painted under a picture of this size at a time; layers are left out."""
    width, y = size
    end = y + timed_height(timed, width)
    paper = np.array([(0, y), (width, y), (width, end), (0, end)])
    drawn = [Drawn("paper", [Mark([paper], _PAPER, closed=True)])]
    for remark in timed.remarks:
        said = words(f"! {remark.text}", 8, y + _ROW / 2, "left", COLOURS["target"].words)
        drawn.append(Drawn("remark", [said]))  # in thin letters: bold ones leave the picture
        y += _ROW
    for row in _rows(timed, width):
        drawn += [_name(*one, y + _ROW / 2) for one in row]
        y += _ROW
    for k, panel in enumerate(timed.data()["panels"]):
        if not panel["layer"]:
            marks = list(_panel(panel, laid(panel, timed.times, (width, HIGH), time)))
            drawn.append(Drawn(f"panel-{k}", [
                replace(mark, lines=[line + [0, y] for line in mark.lines]) for mark in marks]))
            y += HIGH
    return drawn


def _rows(timed: Timed, width: float) -> list[list[tuple[str, str, float]]]:
    """The names of the curves with their styles, in rows: where each begins."""
    styles = {course.name: course.style for panel in timed.panels for course in panel.courses}
    placed, x, row = [], 8.0, 0
    for name, style in styles.items():
        wide = _SAMPLE + 6 + text_size(name)[0] + _GAP
        if x + wide > width:
            x, row = 8.0, row + 1
        placed.append((row, (name, style, x)))
        x += wide
    return [[one for _, one in row] for _, row in groupby(placed, key=lambda one: one[0])]


def _name(name: str, style: str, x: float, y: float) -> Drawn:
    return Drawn(f"name-{name}", [
        Mark([np.array([(x, y), (x + _SAMPLE, y)])], PAINTS[style]),
        words(name, x + _SAMPLE + 6, y, "left", PAINTS[style].get("words", INK))])


def _panel(panel: dict, at: Laid) -> Iterator[Mark]:
    """Bands, frame, bounds, curves, and signs over all of them."""
    left, top, right, bottom = at.box
    spans = [(start, max(end, start + _LEAST)) for start, end in at.bands]
    for start, end in spans:
        corners = [(start, top), (end, top), (end, bottom), (start, bottom)]
        yield Mark([np.array(corners)], _BAND, closed=True, opacity=0.16)
    yield from frame_lines(at.box, at.across, at.up)
    yield words(panel["title"], 4, top - 15, "left")
    if at.zero is not None:
        yield Mark([np.array([(left, at.zero), (right, at.zero)])], _ZERO)
    for bound, y in zip(panel["bounds"], at.bounds):
        yield Mark([np.array([(left, y), (right, y)])],
                   PAINTS[bound["style"]] | _BOUND)  # type: ignore[arg-type]
    yield Mark([np.array([(at.now, top), (at.now, bottom)])], _NOW)
    for course, whole, gone in zip(panel["courses"], at.whole, at.gone):
        paint = PAINTS[course["style"]]
        yield Mark([np.array(whole)], paint, opacity=_PALE)
        yield Mark([np.array(gone)], paint)
        dot = np.array(gone[-1]) + _DOT * np.stack([_ROUND.real, _ROUND.imag], axis=-1)
        yield Mark([dot], pen(paint["stroke"], 0.0, fill=paint["stroke"]), closed=True)
    names = {course["joint"]: course["name"] for course in panel["courses"]}
    for band, (x, y) in zip(panel["bands"], at.signs):
        yield words(f"! {names[band['joint']]}", x, y, "middle", COLOURS["target"].words)
