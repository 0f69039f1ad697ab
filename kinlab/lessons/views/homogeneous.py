"""Views of lesson 03: frames that slide and turn, and the arrows between them."""
from __future__ import annotations

from math import pi, radians

import numpy as np

from ...arms.motions import ROTATE, TRANSLATE, X, Y, Z
from ...drawing.controls import Knob, PoseTable, subscript, superscript
from ...drawing.readings import Point
from ...drawing.scene import at, origin_of
from ...drawing.sketch import Sketch
from ...views.live import LiveView


def combined() -> LiveView:
    """A frame that slides and turns, with a point that is fixed in it."""
    sketch, frame, half = _sliding_and_turning("Translation and rotation together", (1.5, -1.0))
    c = sketch.point("c", frame, (1.5, 1.0))
    sketch.handle("point c", c, 2)
    sketch.components("c", c, frame)
    sketch.arrow("c0", origin_of(0), c, "point")
    turned = sketch.move(ROTATE, Z, 0, 2, half)
    sketch.label("c⁰", (*at(turned, (0.75, 0.5, 0)), origin_of(frame)), "point")
    sketch.arrow("rotated", origin_of(frame), c)
    sketch.label("R₁⁰ c¹", (*at(frame, (0.75, 0.5, 0)), origin_of(0)))
    sketch.reading("c1", "c¹ = {}", sketch.vector(frame, c, frame))
    sketch.reading("o", "o₁⁰ = {}", sketch.vector(0, frame))
    sketch.reading("rotated", "R₁⁰ c¹ = {}", sketch.vector(frame, c))
    sketch.reading("c0", "c⁰ = o₁⁰ + R₁⁰ c¹ = {}", sketch.vector(0, c))
    sketch.pose = PoseTable.of_frame("H₁⁰", "1", "xy")
    return LiveView(sketch.scene())


def seen_back() -> LiveView:
    """A point that stands still, seen from a frame that slides and turns."""
    sketch, frame, half = _sliding_and_turning("A fixed point, seen from frame 1", (-1.2, -1.0))
    c = sketch.point("c", 0, (1.0, 2.0))
    sketch.arrow("c0", origin_of(0), c, "point")
    sketch.label("c⁰", ((0, 0.5, 1.0, 0.0), origin_of(frame)), "point")
    sketch.arrow("difference", origin_of(frame), c)
    sketch.label("c⁰ − o₁⁰", (*at(half, (0.5, 1.0, 0)), origin_of(0)))
    sketch.reading("difference", "c⁰ − o₁⁰ = {}", sketch.vector(frame, c))
    sketch.reading("c1", "c¹ = (R₁⁰)ᵀ (c⁰ − o₁⁰) = {}", sketch.vector(frame, c, frame))
    sketch.reading("o0", "o₀¹ = −(R₁⁰)ᵀ o₁⁰ = {}", sketch.vector(frame, 0, frame))
    sketch.pose = PoseTable.of_frame("H₁⁰", "1", "xy")
    return LiveView(sketch.scene())


def chain(n: int = 3) -> LiveView:
    """A chain of n frames: every term of the successive expansion is one arrow."""
    sketch, offset = Sketch(f"A chain of {n} frames", 1.45 * (n + 1)), (1.2, 0.9)
    sketch.follows = True
    homes = (50, -80, 60, -100, 60, 40)
    knobs = [sketch.theta(k, homes[k - 1]) for k in range(1, n + 1)]
    frame, turns = 0, ""
    sketch.axes("0", 0)
    for k, knob in enumerate(knobs, start=1):
        before = frame
        frame = sketch.frame(str(k), before, theta=knob, origin=offset)
        if k > 1:
            sketch.handle(f"origin of frame {k}", frame, knobs[k - 2])
        name = f"o{_indices(k)}"
        _term(sketch, name, turns, before, origin_of(frame))
        turns += f"R{_indices(k)}"
    c = sketch.point("c", frame, offset)
    sketch.handle("point c", c, *knobs)
    _term(sketch, f"c{superscript(n)}", turns, frame, c)
    sketch.reading("c0", "c⁰ = sum of the rows above = {}", sketch.vector(0, c))
    return LiveView(sketch.scene())


def order() -> LiveView:
    """The same slide and turn in both orders, each along the frame's own axes."""
    sketch, knob = _scrubbed("Slide and turn in both orders", 2.3, (1.05, 0.9, 0))
    a = _motions(sketch, "A", knob, 1.05, (TRANSLATE, 0), (ROTATE, 1))
    b = _motions(sketch, "B", knob, 1.05, (ROTATE, 0), (TRANSLATE, 1))
    return _compared(sketch, ("A (slide, turn)", a), ("B (turn, slide)", b))


def fixed() -> LiveView:
    """Slide, then turn: about the frame's own axes and about those of the room."""
    sketch, knob = _scrubbed("Slide, then turn, about moving and about fixed axes", 1.9,
                             (1.5, 1.35, 0))
    a = _motions(sketch, "A", knob, 1.05, (TRANSLATE, 0), (ROTATE, 1))
    f = _motions(sketch, "F", knob, 2.0, (ROTATE, 1), (TRANSLATE, 0))  # the later on the left
    return _compared(sketch, ("A (own axes)", a), ("F (fixed axes)", f))


def spatial() -> LiveView:
    """A frame in space: it slides along x, y, z, then turns about its z, then about its x."""
    sketch = Sketch("A frame in space", 3.4, planar=False)
    sketch.presets["3-D"] = (-40.0, 24.0)  # from -60 the two arrows seem to be one
    sketch.follows = True
    slides = [sketch.knob(Knob.length(f"o_{axis}", f"o₁⁰, {axis}", -1.2, 1.2, home))
              for axis, home in zip("xyz", (1.0, 0.5, 0.8))]
    theta = sketch.knob(Knob.angle("theta", "θ", home=radians(-30), title="turn about own z"))
    phi = sketch.knob(Knob.angle("phi", "φ", home=radians(40), title="turn about own x"))
    sketch.axes("0", 0, 1.0)
    for axis, knob in zip((X, Y, Z), slides):
        sketch.move(TRANSLATE, axis, 0, knob)
    sketch.move(ROTATE, Z, 0, theta)
    sketch.tip = frame = sketch.move(ROTATE, X, 0, phi)
    sketch.axes("1", frame, 1.0)
    sketch.drop(frame)
    sketch.handle("origin of frame 1", frame, *slides)
    for axis, letter, knob in ((X, "x", theta), (Y, "y", phi), (Z, "z", phi)):
        sketch.handle(f"tip of {letter}₁", at(frame, np.eye(3)[axis])[0], knob)
    c = sketch.point("c", frame, (1.0, 0.6, 0.5))
    sketch.arrow("o", origin_of(0), origin_of(frame))
    sketch.arrow("rotated", origin_of(frame), c)
    sketch.reading("c0", "c⁰ = o₁⁰ + R₁⁰ c¹ = {}", sketch.vector(0, c))
    sketch.pose = PoseTable.of_frame("H₁⁰", "1", "xyz")
    return LiveView(sketch.scene())


def _sliding_and_turning(name: str, home: tuple[float, float]) -> tuple[Sketch, int, int]:
    """Frame 1 with its knobs, and a frame half-way to it that does not turn."""
    sketch = Sketch(name, 3.8)
    sketch.follows = True
    x, y = (sketch.knob(Knob.length(f"o_{axis}", label, -2, 2, value))
            for axis, label, value in zip("xy", ("oₓ", "oᵧ"), home))
    theta = sketch.knob(Knob.angle("theta", "θ", home=radians(30)))
    half, near = (_part_way(sketch, x, y, share) for share in (0.5, 0.3))
    sketch.axes("0", 0, 1.0)
    frame = sketch.frame("1", x=x, y=y, theta=theta, length=1.0)
    sketch.arrow("o", origin_of(0), origin_of(frame))
    sketch.label("o₁⁰", at(near, (0, 0, 0), (0, 1, 0)))
    sketch.sweep("theta", frame, (0.7, 0, 0), text="θ")
    return sketch, frame, half


def _part_way(sketch: Sketch, x: int, y: int, share: float) -> int:
    """A frame at a share of the way to a frame that slides."""
    sketch.move(TRANSLATE, X, 0, x, 0, gain=share)
    return sketch.move(TRANSLATE, Y, 0, y, gain=share)


def _indices(k: int) -> str:
    return subscript(k) + superscript(k - 1)


def _term(sketch: Sketch, name: str, turns: str, frame: int, head: Point) -> None:
    """One arrow of the chain, with its name beside it and its numbers in a row of their own."""
    sketch.arrow(f"arrow-{name}", origin_of(frame), head)
    sketch.label(name, at(frame, (0.6, 0.45, 0), (0.4, 0.7, 0)))
    sketch.reading(name, f"{turns} {name} = {{}}".strip(), sketch.vector(origin_of(frame), head))


def _scrubbed(name: str, radius: float, center: tuple) -> tuple[Sketch, int]:
    sketch = Sketch(name, radius, center=center)
    sketch.poses = [[0], [1], [2]]
    sketch.axes("0", 0, 1.0)
    return sketch, sketch.knob(Knob("t", "motion", 0, 2, 0, step=0.1, whole=True))


def _motions(sketch: Sketch, name: str, knob: int, arc: float,
             *order: tuple[str, int]) -> int:
    """A slide by 2 along x and a turn by 60 degrees, each while the knob passes its start.

    Dashed: the way of the origin in the slide, and of the point (arc, 0) in the turn.
    """
    frame = 0
    for kind, start in order:
        axis, gain = (X, 2.0) if kind == TRANSLATE else (Z, pi / 3)
        frame = sketch.move(kind, axis, 0, knob, frame, gain=gain, start=start)
        marked = (0, 0, 0) if kind == TRANSLATE else (arc, 0, 0)
        sketch.sweep(f"path-{name}-{kind}", frame, marked, "dashed")
    sketch.axes(name, frame, 1.0)
    sketch.handle(f"frame {name}", at(frame, (1.0, 0, 0))[0], knob)
    return frame


def _compared(sketch: Sketch, *named: tuple[str, int]) -> LiveView:
    for words, frame in named:
        sketch.reading(words[0], f"{words}: origin {{}}, x axis {{}}", sketch.vector(0, frame),
                       sketch.vector(frame, at(frame, (1, 0, 0))[0]))
    return LiveView(sketch.scene())
