"""Views of lesson 11: books turned about fixed and about moving axes, an aircraft, one axis."""
from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from math import atan, pi, radians, sqrt
from typing import NamedTuple

import numpy as np

from ...arms.motions import ROTATE, TRANSLATE, X, Y, Z
from ...drawing.controls import Knob, PoseTable
from ...drawing.readings import RollPitchYaw, TurnAngle, TurnAxis, Turned
from ...drawing.scene import BOX, SWEEP, at, circle, origin_of
from ...drawing.sketch import Sketch
from ...views.live import LiveView
from .rotation import draw_book

DIAGONAL = (45.0, np.degrees(atan(sqrt(0.5))))  # where (1, 1, 1) points: azimuth, elevation
_SEEN = 0.05                                    # rad: of an arc that can be seen
_CORNER = (0.5, 0.7, 0.13)                      # of a book
_RINGS = {1: ("grip", 1.0, (Y, Z)), 2: ("steel", 0.84, (X, Y))}  # style, radius, plane
_PIECES, _THICK = 36, 0.024                     # of a ring


# ---- Books: fixed and moving axes -----------------------------------------------------------


class _Book(NamedTuple):
    """A book in its place, and the axes that it is turned about: the left one of the product first.

    Each axis comes with the turn at which it is reached: 0 for the first one.
    """

    name: str
    place: tuple[float, float]
    said: str
    turns: tuple[tuple[int, int], tuple[int, int]]


# Turns about axes of the room stand to the left of those before, about the book's own to the right.
_BOOKS = (
    _Book("A", (-1.5, 1.35), "room: z, then x", ((X, 1), (Z, 0))),
    _Book("B", (1.5, 1.35), "room: x, then z", ((Z, 1), (X, 0))),
    _Book("C", (-1.5, -1.35), "own: z, then x", ((Z, 0), (X, 1))),
    _Book("D", (1.5, -1.35), "own: x, then z", ((X, 0), (Z, 1))),
)


def books_view() -> LiveView:
    """Four books: turned about axes of the room and about their own, in both orders."""
    sketch = Sketch("Two quarter turns, four ways", 3.0, planar=False, grid=0)
    sketch.presets["3-D"] = (-75.0, 24.0)
    knob = sketch.knob(Knob("t", "turns", 0, 2, 0, step=0.1, whole=True))
    sketch.axes("0", 0, 0.8)
    for book in _BOOKS:
        place = sketch.move(TRANSLATE, X, book.place[0], parent=0)
        frame = stand = sketch.move(TRANSLATE, Z, book.place[1], parent=place)
        for axis, start in book.turns:
            frame = sketch.move(ROTATE, axis, 0, knob, frame, gain=pi / 2, start=start)
        draw_book(sketch, book.name, frame)
        sketch.axes(book.name, frame, 1.0)
        sketch.label(f"{book.name}, {book.said}", at(stand, (0, 0, -1.08), (0, 0, 0)))
        sketch.handle(f"corner of book {book.name}", at(frame, _CORNER)[0], knob)
        sketch.reading(book.name, f"book {book.name} ({book.said}): z{book.name} = {{}}",
                       sketch.vector(frame, at(frame, (0, 0, 1))[0]))
    return LiveView(sketch.scene())


# ---- An aircraft: yaw, pitch and roll -------------------------------------------------------


def attitude_view() -> LiveView:
    """An aircraft that is turned by yaw, pitch and roll, each drawn as an arc."""
    sketch, turns = _aircraft("Yaw, pitch, roll", (15, -25, 25))
    for k, (step, place, name) in enumerate(zip(
            turns, ((0.95, 0, 0), (0.95, 0, 0), (0, 0.75, 0)), ("yaw", "pitch", "roll"))):
        middle = sketch.sweep(f"arc-{name}", step, place)[8]
        for low, high in ((-pi, -_SEEN), (_SEEN, pi)):  # an arc without length has no name
            sketch.label(name, at(middle, place, (0, 0, 0)), "angle", joint=k + 1,
                         when=(k, low, high))
    return LiveView(sketch.scene())


def gimbal_view() -> LiveView:
    """The aircraft in two rings: the outer one yaws, the inner one pitches, and in it it rolls."""
    sketch, (yaw, pitch, _) = _aircraft("An aircraft in rings", (-15, 25, 20))
    for k, frame in ((1, yaw), (2, pitch)):
        style, radius, plane = _RINGS[k]
        _ring(sketch, f"ring-{k}", frame, radius, plane, style, k)
    for k, (frame, axis, inner, outer) in enumerate(
            ((0, Z, 1.0, 1.2), (yaw, Y, 0.84, 1.0), (pitch, X, 0.5, 0.84))):
        for side in (1, -1):
            ends = (side * reach * np.eye(3)[axis] for reach in (inner, outer))
            sketch.solid(f"pin-{k}-{side}", "grip", at(frame, *ends), (0.022, 0.022),
                         part="pin", link=k)
    return LiveView(sketch.scene())


def _aircraft(name: str, home: tuple[float, float, float]) -> tuple[Sketch, list[int]]:
    """An aircraft whose nose lies along x₁, the frames after yaw, pitch and roll."""
    sketch = Sketch(name, 1.34, planar=False, grid=0)
    knobs = [sketch.knob(Knob.angle(word, word, home=radians(angle), title=f"turn about {axis}"))
             for word, axis, angle in zip(("yaw", "pitch", "roll"), ("z₀", "y after yaw", "x₁"),
                                          home)]
    sketch.axes("0", 0, 1.26)
    turns = [sketch.move(ROTATE, axis, 0.0, knob) for axis, knob in zip((Z, Y, X), knobs)]
    body = sketch.tip = turns[-1]
    _fly(sketch, body)
    sketch.axes("1", body, 1.2)
    yaw, pitch, roll = knobs
    # Two knobs carry a tip over its sphere; a third one would leave it between two places.
    for letter, unit, driven in zip("xyz", np.eye(3), ((yaw, pitch), (yaw, roll), (pitch, roll))):
        sketch.handle(f"tip of {letter}₁", at(body, 1.2 * unit)[0], *driven)
    _describe(sketch, body)
    return sketch, turns


def _fly(sketch: Sketch, frame: int) -> None:
    """A small aircraft: nose along x, left wing along y, fin along z."""
    for name, ends, radii in (("fuselage", (-0.5, 0.3), (0.035, 0.075)),
                              ("nose", (0.3, 0.52), (0.075, 0.01))):
        sketch.solid(name, "steel", at(frame, *((x, 0, 0) for x in ends)), radii, part="link",
                     link=3)
    for name, root, tip, long, thick in (
            ("wings", (0.02, -0.5, 0), (0.02, 0.5, 0), 0.11, (0, 0, 0.012)),
            ("tail", (-0.42, -0.2, 0), (-0.42, 0.2, 0), 0.07, (0, 0, 0.012)),
            ("fin", (-0.42, 0, 0.02), (-0.46, 0, 0.24), 0.07, (0, 0.012, 0))):
        corners = (root, tip, np.add(root, (long, 0, 0)), np.add(root, thick))
        sketch.add(name, BOX, "sleeve", at(frame, *corners), part="link", link=3)


def _ring(sketch: Sketch, name: str, frame: int, radius: float, plane: Iterable[int], style: str,
          link: int) -> None:
    """A ring in a plane of a frame, which turns with a joint."""
    u, v = (np.eye(3)[axis] for axis in plane)
    corners = [radius * (x * u + y * v) for x, y, _ in circle(_PIECES + 1)]
    for k, ends in enumerate(pairwise(corners)):
        sketch.solid(f"{name}-{k}", style, at(frame, *ends), (_THICK, _THICK), part="link",
                     link=link)


# ---- One axis, one angle ---------------------------------------------------------------------


def axis_view() -> LiveView:
    """A frame turned about any axis by any angle; the tips of its axes run on circles about it."""
    sketch = Sketch("One axis, one angle", 1.3, planar=False, grid=0)
    azimuth = sketch.knob(Knob.angle("azimuth", "azimuth of u", home=radians(30)))
    elevation = sketch.knob(Knob.angle("elevation", "elevation of u", -pi / 2, pi / 2,
                                       radians(50)))
    angle = sketch.knob(Knob.angle("angle", "angle", -2 * pi, 2 * pi, radians(60)))
    sketch.axes("0", 0, 1.0)
    sketch.move(ROTATE, Z, 0.0, azimuth, 0)
    along = sketch.move(ROTATE, Y, 0.0, elevation, gain=-1.0)  # its x axis is u
    still, turned = (sketch.move(ROTATE, X, 0.0, knob, along) for knob in (None, angle))
    sketch.move(ROTATE, Y, 0.0, elevation, turned)
    frame = sketch.tip = sketch.move(ROTATE, Z, 0.0, azimuth, gain=-1.0)
    (tip,) = at(along, (1.22, 0, 0))
    sketch.line("behind u", (at(along, (-1.2, 0, 0))[0], origin_of(along)), "axis")
    sketch.arrow("u", origin_of(along), tip)
    sketch.label("u", (tip, origin_of(along)))
    sketch.handle("tip of u", tip, azimuth, elevation)
    sketch.axes("1", frame, 1.0)
    for letter, unit in zip("xyz", np.eye(3)):
        sketch.add(f"way-{letter}", SWEEP, f"{letter}-leg", at(0, unit), size=(still, turned),
                   part="arc", joint=3)
        sketch.handle(f"tip of {letter}₁", at(frame, unit)[0], angle)
    _describe(sketch, frame)
    return LiveView(sketch.scene())


def _describe(sketch: Sketch, frame: int) -> None:
    """The matrix of a frame beside the picture, and the other three descriptions under it."""
    sketch.pose = PoseTable.of_frame("R₁⁰, the axes of frame 1 as columns", "1", "xyz", rows=3)
    sketch.reading("rpy", "roll, pitch, yaw (°): {}", RollPitchYaw(frame))
    sketch.reading("turn", "one turn, by {}° about u = {}", TurnAngle(frame), TurnAxis(frame))
    sketch.reading("quaternion", "quaternion (w, x, y, z) = {}", Turned(frame))
