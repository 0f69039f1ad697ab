"""Views of lesson 04: planar arms, by trigonometry and through their frames."""
from __future__ import annotations

from ...arms.motions import ROTATE, TRANSLATE, X, Z
from ...drawing.controls import Knob, PoseTable, subscript
from ...drawing.scene import at, origin_of
from ...drawing.sketch import Sketch
from ...views.live import LiveView

_HOME = (30, 40, -65, 80, -70, 60)  # degrees
_LENGTH = 1.2
_SHARES = tuple(share / 8 for share in range(9))


def both_methods(*, middle: bool = False) -> LiveView:
    """The two-link arm: its dashed legs are the trigonometry, its frames the matrices.

    With `middle` the middle of link 2 is marked and read as well.
    """
    sketch = Sketch("Two-link arm, by both methods", 4)
    sketch.follows = True
    t1, t2 = sketch.theta(1, 35), sketch.theta(2, 25)
    l1, l2 = (sketch.knob(Knob.length(f"l_{k}", f"l{subscript(k)}", 0.5, high, home))
              for k, home, high in ((1, 2.0, 2.2), (2, 1.5, 1.8)))
    first = sketch.frame("1", theta=t1)
    second = sketch.frame("2", first, x=l1, theta=t2)
    end = sketch.move(TRANSLATE, X, 0, l2)
    sketch.axes("0", 0, inside=sketch.thick, sharing=1)
    _links(sketch, [(first, second - 1), (second, end)], "OPQ")
    _legs(sketch, ("l₁C₁", "l₁S₁"), first, l1, [t1])
    _legs(sketch, ("l₂C₁₂", "l₂S₁₂"), second, l2, [t1, t2])
    sketch.sweep("theta-1", first, (0.85, 0, 0), text="θ₁")
    sketch.line("ahead", at(second - 1, (0, 0, 0), (1.1, 0, 0)))
    sketch.sweep("theta-2", second, (0.75, 0, 0), text="θ₂")
    sketch.handles = []  # lengths stay as they are while a hand moves the arm
    sketch.handle("Q", end, t1, t2)
    sketch.handle("P", second, t1)
    _both_readings(sketch, second, end, (t1, t2, l1, l2))
    if middle:
        half = sketch.move(TRANSLATE, X, 0, l2, second, gain=0.5)
        sketch.point("M", half, (0, 0))
        sketch.reading("M_H", "M⁰ = H₂⁰ M² = {}", sketch.vector(0, half))
    sketch.pose = PoseTable("H₂⁰ = H₁⁰ H₂¹", (
        ("x₂", "x axis of frame 2"), ("y₂", "y axis of frame 2"), ("P", "its origin, P")))
    return LiveView(sketch.scene())


def n_links(n: int = 4) -> LiveView:
    """A planar arm of n links; arcs show how far each link is turned from the x axis."""
    sketch = Sketch(f"Planar arm with {n} links", _LENGTH * n * 1.05)
    sketch.follows = True
    knobs = [sketch.theta(k, home) for k, home in enumerate(_HOME[:n], start=1)]
    sketch.axes("0", 0, inside=sketch.thick)
    frame, links = 0, []
    for k, knob in enumerate(knobs, start=1):
        index, before = subscript(k), frame
        turned = sketch.move(ROTATE, Z, 0, knob, before)
        frame = sketch.move(TRANSLATE, X, _LENGTH)
        links.append((turned, frame))
        _bearing(sketch, f"φ{index}", _turned(sketch, before, knobs[:k - 1], -1), knobs[:k])
        sketch.reading(f"link-{k}", f"l{index} (cos φ{index}, sin φ{index}) = {{}}",
                       sketch.vector(turned, frame))
    _links(sketch, links)
    sketch.point("Q", frame, (0, 0))
    sketch.handle("Q", frame, *knobs)
    sketch.reading("Q", "Q⁰ = sum of the rows above = {}", sketch.vector(0, frame))
    return LiveView(sketch.scene())


def _links(sketch: Sketch, links: list[tuple[int, int]], names: str = "") -> None:
    """Solid links, each along the frame that its joint turns, and a dot at every joint and the tip.

    A link is known by that frame and the one at its end, which the next joint has not turned.
    """
    sketch.base()
    for k, (turned, end) in enumerate(links, start=1):
        sketch.limb(k, turned, end, last=k == len(links))
        sketch.hinge(k, turned)
    for name, frame in zip(names, [*(turned for turned, _ in links), links[-1][1]]):
        sketch.point(name, frame, (0, 0))


def _legs(sketch: Sketch, names: tuple[str, str], frame: int, length: int,
          turns: list[int]) -> None:
    """Dashed legs of a link, along x and y of the room, and their names.

    Half the link as it is and half of its mirror image add up to the leg along x; the one less
    the other is the leg along y.
    """
    corner = _folded(sketch, frame, length, turns, (0.5, -2, 0.5))
    end = sketch.move(TRANSLATE, X, 0, length, frame)
    sketch.line(f"legs-{names[0]}", map(origin_of, (frame, corner, end)))
    below = _turned(sketch, _folded(sketch, frame, length, turns, (0.25, -2, 0.25)), turns, 1)
    beside = _turned(sketch, _folded(sketch, corner, length, turns, (-0.25, 2, 0.25)), turns, -1)
    sketch.label(names[0], at(below, (0, 0, 0), (0, 1, 0)))
    sketch.label(names[1], at(beside, (0, 0, 0), (-1, 0, 0)))


def _folded(sketch: Sketch, frame: int, length: int, turns: list[int],
            gains: tuple[float, float, float]) -> int:
    """A part of the link, a turn by a multiple of all angles, another part of the link."""
    before, turned, after = gains
    frame = sketch.move(TRANSLATE, X, 0, length, frame, gain=before)
    return sketch.move(TRANSLATE, X, 0, length, _turned(sketch, frame, turns, turned), gain=after)


def _turned(sketch: Sketch, frame: int, turns: list[int], gain: float) -> int:
    """The frame turned by a multiple of some angles; by -1 a link's frame becomes level."""
    for turn in turns:
        frame = sketch.move(ROTATE, Z, 0, turn, frame, gain=gain)
    return frame


def _bearing(sketch: Sketch, name: str, level: int, turns: list[int]) -> None:
    """An arc from the level direction by the sum of the turns."""
    arc = [_turned(sketch, level, turns, share) for share in _SHARES]
    sketch.line(f"level-{name}", at(level, (0, 0, 0), (0.7, 0, 0)))
    sketch.line(f"arc-{name}", [at(frame, (0.5, 0, 0))[0] for frame in arc], "arc")
    sketch.label(name, at(arc[4], (0.5, 0, 0), (0, 0, 0)), "angle")


def _both_readings(sketch: Sketch, second: int, end: int, knobs: tuple[int, ...]) -> None:
    """Trigonometry from absolute angles, on a branch of its own; matrices along the frames."""
    t1, t2, l1, l2 = knobs
    p = sketch.move(TRANSLATE, X, 0, l1, sketch.move(ROTATE, Z, 0, t1, 0))
    swung = _turned(sketch, _turned(sketch, p, [t1], -1), [t1, t2], 1)
    q = sketch.move(TRANSLATE, X, 0, l2, swung)
    first = second - 3  # frame 2 is two slides and a turn after frame 1
    sketch.reading("P_trig", "By trigonometry: P⁰ = (l₁C₁, l₁S₁) = {}", sketch.vector(0, p))
    sketch.reading("leg", "legs of link 2 = (l₂C₁₂, l₂S₁₂) = {}", sketch.vector(p, q))
    sketch.reading("Q_trig", "Q⁰ = sum of these two = {}", sketch.vector(0, q))
    sketch.reading("P_H", "By matrices: P⁰ = H₁⁰ P¹ = {}", sketch.vector(0, second))
    sketch.reading("Q_1", "Q¹ = H₂¹ Q² = {}", sketch.vector(first, end, first))
    sketch.reading("Q_H", "Q⁰ = H₁⁰ Q¹ = {}", sketch.vector(0, end))
