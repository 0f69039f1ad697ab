"""Views of lesson 09: the ring that two links reach, and what joint limits leave of it."""
from __future__ import annotations

from dataclasses import replace
from math import pi, radians

import numpy as np

from ...arms.motions import ROTATE, TRANSLATE, X, Z
from ...drawing.controls import Knob, Switch, subscript
from ...drawing.readings import Distance
from ...drawing.scene import AREA, PATCH, SWEEP, at, circle, origin_of
from ...drawing.sketch import Sketch
from ...views.live import LiveView

L1, L2, L3 = 1.0, 0.6, 0.2  # m, the arm of the lesson, and a tool
_THICK = 0.06      # m, radius of its joints
_LINES = np.linspace(0, 1, 9)  # of the mesh, as shares of a joint's range
_TRACE = Switch("trace", "Trace", "Path of the tool")


def ring_view() -> LiveView:
    """The two-link arm, its two lengths, and the circles of the stretched and the folded arm."""
    sketch = Sketch("Two links and the ring they reach", 2.3, unit="m", grid=0.5)
    t1, t2 = sketch.theta(1, 35), sketch.theta(2, 60)
    l1, l2 = (sketch.knob(Knob.length(f"l_{k}", f"l{subscript(k)}", 0.2, 1.05, home, "m"))
              for k, home in ((1, L1), (2, L2)))
    swept = sketch.knob(Knob("swept", "swept", 0, 1, 1, "%", 0.01, 1.0,
                             "how much of a whole turn the arm has swept"))
    sketch.joints = (t1, t2)
    _ring(sketch, l1, l2, swept)
    first = sketch.move(ROTATE, Z, 0, t1, 0)
    straight = sketch.move(TRANSLATE, X, 0, l1)
    elbow = sketch.move(ROTATE, Z, 0, t2)
    tool = sketch.move(TRANSLATE, X, 0, l2)
    _arm(sketch, first, straight, elbow, tool)
    sketch.handle("tool Q", tool, t1, t2)
    sketch.handle("P", elbow, t1)
    sketch.line("reach", map(origin_of, (0, tool)))
    _circle_names(sketch, l1, l2)
    sketch.reading("p", "tool: p⁰ = {} m", sketch.vector(0, tool))
    sketch.reading("p_1", "seen along link 1: (l₁ + l₂C₂, l₂S₂) = {} m",
                   sketch.vector(first, tool, first))
    return _with_trace(sketch, _sweeps())


def limits_view(theta_1: tuple[float, float] = (-20, 130),
                theta_2: tuple[float, float] = (0, 150)) -> LiveView:
    """What a two-link arm (1 m and 0.6 m) reaches within its joint limits.

    Curves of constant joint values fill the region. Its edge is made of the curves at the four
    limits and the one where the arm is as straight as it can be.

    Parameters
    ----------
    theta_1, theta_2 : pairs of float
        Limits to begin with, in degrees: from -180...0 to 0...180, and from -180...50 to
        60...180.
    """
    sketch = Sketch("Two links with joint limits", 1.8, unit="m", grid=0.5)
    sketch.follows = True
    ends = ((-180, 0, 0, 180), (-180, 50, 60, 180))
    sketch.joints = ()
    limits = [_limits(sketch, k, *pair) for k, pair in enumerate(zip((theta_1, theta_2), ends), 1)]
    sweeps = [sketch.knob(Knob(f"s_{k}", f"s{subscript(k)}", 0, 1, home, "%", 0.01, 1.0,
                               f"how far joint {k} is from its lowest to its highest value"))
              for k, home in ((1, 0.5), (2, 0.4))]
    for part in (_region, _mesh, _names):
        part(sketch, *limits)
    first = _swept(sketch, 0, limits[0], sweeps[0])
    straight = sketch.move(TRANSLATE, X, L1)
    elbow = _swept(sketch, straight, limits[1], sweeps[1])
    tool = sketch.move(TRANSLATE, X, L2)
    _arm(sketch, first, straight, elbow, tool)
    sketch.handle("tool Q", tool, *sweeps)
    sketch.handle("P", elbow, sweeps[0])
    sketch.reading("p", "tool: p⁰ = {} m", sketch.vector(0, tool))
    closing = [(-180, 180, -180, 180), (-90, 90, -180, 180), (-90, 90, 0, 180), (-90, 90, 0, 120),
               (-90, 90, 45, 120), (-20, 130, 0, 150)]
    return _with_trace(sketch, [[*np.radians(pose), 0.5, 0.4] for pose in closing])


def dexterous_view() -> LiveView:
    """A tool of 0.2 m at Q, the circle on which its wrist may stand, and the ring of two links.

    Wherever the circle lies in the ring, the tool can point in every direction.
    """
    sketch = Sketch("A circle of wrists in the ring of two links", 2.0, unit="m", grid=0.5)
    r = sketch.knob(Knob.length("r", "r", 0.0, 2.0, 0.9, "m", "distance of Q from O"))
    phi = sketch.knob(Knob.angle("phi", "φ", home=radians(50), title="where the tool points"))
    sketch.joints = ()
    _still_ring(sketch)
    place = sketch.move(TRANSLATE, X, 0, r, 0)
    wrist = sketch.move(TRANSLATE, X, -L3, None, sketch.move(ROTATE, Z, 0, phi))
    sketch.line("circle", at(place, *(L3 * circle(73))), "target")
    sketch.arrow("tool", origin_of(wrist), origin_of(place), "point")
    for name, frame in (("O", 0), ("Q", place), ("W", wrist)):
        sketch.point(name, frame, (0, 0))
    sketch.handle("Q", place, r)
    sketch.handle("wrist W", wrist, phi)
    sketch.reading("w", "wrist: |OW| = {} m; the two links reach from 0.4 to 1.6 m",
                   Distance(origin_of(0), origin_of(wrist)))
    return LiveView(sketch.scene())


def _still_ring(sketch: Sketch) -> None:
    """What two links reach that do not move here."""
    for name, radius, style in (("stretched", L1 + L2, "first"), ("folded", L1 - L2, "second")):
        sketch.line(name, at(0, *(radius * circle(121))), style, part="edge")
    rims = [at(0, *(radius * circle(121))) for radius in (L1 + L2, L1 - L2)]
    sketch.add("region", AREA, "region", (*rims[0], *rims[1][::-1]), body=-1, part="region")


# ---- Parts of both ------------------------------------------------------------------------


def _arm(sketch: Sketch, first: int, straight: int, elbow: int, tool: int) -> None:
    """The two links, along the frames turned by joint 1, at the elbow, turned by joint 2, at Q."""
    sketch.thick, sketch.tip = _THICK, tool
    sketch.base()
    sketch.limb(1, first, straight)
    sketch.limb(2, elbow, tool, last=True)
    for joint, frame in ((1, first), (2, elbow)):
        sketch.hinge(joint, frame)
    for name, frame in (("O", 0), ("P", elbow), ("Q", tool)):
        sketch.point(name, frame, (0, 0))


def _with_trace(sketch: Sketch, poses: list) -> LiveView:
    sketch.trace(sketch.tip)
    sketch.switches, sketch.poses = [_TRACE], poses
    return LiveView(sketch.scene())


# ---- The ring -----------------------------------------------------------------------------


def _ring(sketch: Sketch, l1: int, l2: int, swept: int) -> None:
    """All that the tool reaches, and its edges: the straight and the folded arm turn once."""
    first = sketch.move(ROTATE, Z, 0, None, 0)
    last = sketch.move(ROTATE, Z, 0, swept, 0, gain=2 * pi)
    elbow = sketch.move(TRANSLATE, X, 0, l1, first)
    folded = sketch.move(TRANSLATE, X, 0, l2, gain=-1)
    half = sketch.move(ROTATE, Z, pi, None, elbow)
    straight = sketch.move(ROTATE, Z, 0, None, elbow)
    stretched = sketch.move(TRANSLATE, X, 0, l2)
    sketch.add("region", PATCH, "region", (origin_of(stretched),), body=-1, part="region",
               size=(first, last, straight, half))
    for name, frame, style in (("stretched", stretched, "first"), ("folded", folded, "second")):
        sketch.add(name, SWEEP, style, (origin_of(frame),), size=(first, last), part="edge")


def _circle_names(sketch: Sketch, l1: int, l2: int) -> None:
    """The radii of both circles under the picture."""
    for name, text, gain in (("stretched", "stretched: l₁ + l₂ = {} m", 1),
                             ("folded", "folded: |l₁ − l₂| = {} m", -1)):
        sketch.move(TRANSLATE, X, 0, l1, 0)
        end = sketch.move(TRANSLATE, X, 0, l2, gain=gain)
        sketch.reading(name, text, Distance(origin_of(0), origin_of(end)))


def _sweeps() -> list[list[float]]:
    """Joint 1 there and back, while joint 2 bends a little more each time."""
    bends = np.radians(np.linspace(0, 180, 7))
    turns = (-pi, 0.0, pi)  # half a turn at a time: slow enough for a smooth trace
    return [[turn, bend, L1, L2, 1]
            for k, bend in enumerate(bends) for turn in turns[::1 - k % 2 * 2]]


# ---- Limits -------------------------------------------------------------------------------


def _limits(sketch: Sketch, k: int, homes: tuple, ends: tuple) -> tuple[int, int]:
    """The two knobs of a joint's limits. They cannot pass each other."""
    low, most, least, high = ends
    index = subscript(k)
    ranges = (("from", low, most), ("to", least, high))
    first, last = (sketch.knob(replace(
        Knob.angle(f"{word}_{k}", f"θ{index} {word}", radians(a), radians(b), radians(home)),
        pair=f"θ{index}")) for (word, a, b), home in zip(ranges, homes))
    return first, last


def _share(sketch: Sketch, before: int, limits: tuple[int, int], share: float) -> int:
    """A turn to a fixed share of the way from the lowest value to the highest."""
    frame = sketch.move(ROTATE, Z, 0, limits[0], before, gain=1 - share)
    return sketch.move(ROTATE, Z, 0, limits[1], frame, gain=share)


def _swept(sketch: Sketch, before: int, limits: tuple[int, int], sweep: int) -> int:
    """The same where a knob says how far; a sum, since a motion is scrubbed as a whole."""
    frame = sketch.move(ROTATE, Z, 0, limits[0], before)
    frame = sketch.move(ROTATE, Z, 0, limits[0], frame, gain=-1, scrub=(sweep, 0))
    return sketch.move(ROTATE, Z, 0, limits[1], frame, scrub=(sweep, 0))


def _ends(sketch: Sketch, before: int, limits: tuple[int, int]) -> tuple[int, int]:
    """Two turns that begin at one frame: to the lowest value, and to the highest."""
    low, high = (sketch.move(ROTATE, Z, 0, limit, before) for limit in limits)
    return low, high


def _region(sketch: Sketch, first: tuple[int, int], second: tuple[int, int]) -> None:
    """All that the tool reaches, the elbow bent one way or the other; the straightest arm.

    Where both ways lead, the two halves lie over each other.
    """
    turns = _ends(sketch, 0, first)
    elbow = sketch.move(TRANSLATE, X, L1, None, turns[0])
    low, high = _ends(sketch, elbow, second)
    straight = sketch.move(ROTATE, Z, 0, second[0], elbow, start=0.0)  # or the lowest if above
    for k, bend in enumerate(((low, straight), (straight, high))):
        sketch.add(f"region-{k}", PATCH, "region", at(bend[0], (L2, 0, 0)), body=-1,
                   part="region", size=(*turns, *bend))
    sketch.add("straightest", SWEEP, "first", at(straight, (L2, 0, 0)), size=turns, part="edge")


def _mesh(sketch: Sketch, first: tuple[int, int], second: tuple[int, int]) -> None:
    """Curves of constant joint values; those at the limits are the coloured edges."""
    turns = _ends(sketch, 0, first)
    elbow = sketch.move(TRANSLATE, X, L1, None, turns[0])
    for k, share in enumerate(_LINES):
        edge = share in (0, 1)
        bent = _share(sketch, elbow, second, share)
        sketch.add(f"bend-{k}", SWEEP, "limit" if edge else "mesh", at(bent, (L2, 0, 0)),
                   size=turns, part="edge" if edge else "mesh", joint=2)
        bends = _ends(sketch, _shoulder(sketch, first, share), second)
        sketch.add(f"turn-{k}", SWEEP, "angle" if edge else "mesh", at(bends[0], (L2, 0, 0)),
                   size=bends, part="edge" if edge else "mesh", joint=1)


def _shoulder(sketch: Sketch, limits: tuple[int, int], share: float) -> int:
    """A frame at the elbow, for a share of joint 1's range."""
    return sketch.move(TRANSLATE, X, L1, None, _share(sketch, 0, limits, share))


def _names(sketch: Sketch, first: tuple[int, int], second: tuple[int, int]) -> None:
    """The names of the five edges, beside them."""
    bent = sketch.move(ROTATE, Z, 0, second[0], _shoulder(sketch, first, 0.6), start=0.0)
    sketch.label("straightest", at(bent, (L2, 0, 0), (0, 0, 0)), "first")
    for k, word in enumerate(("from", "to")):
        elbow, other = (_shoulder(sketch, first, share) for share in (k, 0.25 + 0.5 * k))
        for text, frame, share, side in ((f"θ₁ {word}", elbow, 0.7 - 0.2 * k, -1),
                                         (f"θ₂ {word}", other, k, 1)):
            edge = _share(sketch, frame, second, share)
            sketch.label(text, at(edge, (L2, 0, 0), (L2 + 0.1 * side, 0, 0)), "angle")
