"""Solids as lit faces on the picture, as in kinlab/browser/solids.js.

A round body is one outline with a gradient across it: it looks like many narrow faces, without
their seams.
"""
from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import NamedTuple

import numpy as np

from .camera import Lens
from .paints import Paint
from .scene import BALL, BOX, TUBE
from .vectors import cross, norm, unit


class Across(NamedTuple):
    """Levels from one place on the picture (px) straight to another."""

    start: np.ndarray
    end: np.ndarray
    levels: tuple[int, ...]


class Round(NamedTuple):
    """Levels from a place on the picture (px) outwards."""

    center: np.ndarray
    radius: float
    levels: tuple[int, ...]


class Face(NamedTuple):
    """A part of a solid on the picture, with one level of its ramp or a gradient.

    `role` is side, cap, hub (with a ramp of its own), face, or mark, which is a plain line and not
    a closed outline.
    """

    role: str
    points: np.ndarray
    level: int | None = None
    gradient: Across | Round | None = None


# ---- light ----

_BRIGHTEST = 27                                # levels go from 0, which lies in the shade
_LIGHT = np.array([-0.5, 0.72, 0.62])          # to the right, up, towards the viewer
_LIGHT /= math.sqrt(_LIGHT @ _LIGHT)
_EDGE_ON = 1e-9                                # what is turned away by less is not seen


def _shine(normal: np.ndarray) -> float:
    """How bright a surface is, from 0 to 1, that looks in a direction (right, up, near).

    Without the last term a drum whose end points at the light would look flat.
    """
    lit = max(0.0, 0.5 + 0.5 * float(normal @ _LIGHT))
    return min(1.0, max(0.0, -0.06 + 0.76 * lit ** 1.3 + 0.36 * max(0.0, float(normal[2]))))


def _level(brightness: float) -> int:
    return int(_BRIGHTEST * brightness + 0.5)


def shades(ramp: Sequence[str]) -> list[str]:
    """The colours of all levels, made from those in the shade, between, and in the light."""
    return list(_shades(tuple(ramp)))


@cache
def _shades(ramp: tuple[str, ...]) -> tuple[str, ...]:
    known = [[int(colour[k:k + 2], 16) for k in (1, 3, 5)] for colour in ramp]
    where = np.linspace(0, 2, _BRIGHTEST + 1)
    channels = np.transpose([np.interp(where, (0, 1, 2), values) for values in zip(*known)])
    return tuple("#" + bytes(colour).hex()
                 for colour in np.floor(channels + 0.5).astype(np.uint8))


def pale(colour: str) -> str:
    """A colour that steps back half of the way into white paper."""
    mixed = [0.45 * int(colour[k:k + 2], 16) + 0.55 * 255 for k in (1, 3, 5)]
    return "#" + bytes(round(channel) for channel in mixed).hex()


# ---- outlines ----

_COARSE, _FINE, _SMALL = 18, 36, 34.0          # sides of a circle, and px: the most of a coarse one


def _circle(radius: float) -> np.ndarray:
    """Corners of a circle round 0 of radius 1 that is drawn with a radius in px."""
    return circle(_FINE if radius > _SMALL else _COARSE)


@cache
def circle(count: int) -> np.ndarray:
    """So many corners of a circle round 0 of radius 1; not to be written to."""
    angles = 2 * np.pi * np.arange(count) / count
    return np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def hull(points: Iterable[Sequence[float]] | np.ndarray) -> np.ndarray:
    """Corners of the convex outline round points of the picture, by Andrew's monotone chain."""
    ordered = sorted(map(tuple, np.asarray(points, dtype=float).tolist()))
    return np.reshape(_half(ordered)[:-1] + _half(reversed(ordered))[:-1], (-1, 2))


def _half(chain: Iterable[tuple]) -> list[tuple]:
    kept: list[tuple] = []
    for x, y in chain:
        while len(kept) > 1:
            (u, v), (s, t) = kept[-2:]
            if (s - u) * (y - v) - (t - v) * (x - u) > 0:  # the chain bends to the left
                break
            kept.pop()
        kept.append((x, y))
    return kept


# ---- tubes ----

_HUB = 0.66                                    # radius of the disc on an end
_LIGHTER = 5                                   # levels by which an end stands out
_STOPS = (-1.0, -0.65, 0.0, 0.65, 1.0)         # across a tube, where its levels are told
# Where a gradient's levels stand on its way, from 0 to 1.
OFFSETS = {Across: tuple((u + 1) / 2 for u in _STOPS), Round: (0.0, 0.5, 1.0)}


@dataclass(frozen=True)
class _Tube:
    lens: Lens
    ends: np.ndarray
    radii: Sequence[float]
    frame: np.ndarray

    @cached_property
    def length(self) -> float:
        return norm(self.ends[1] - self.ends[0])

    @cached_property
    def direction(self) -> np.ndarray:
        return unit(self.ends[1] - self.ends[0]) if self.length > 0 else self.frame[:3, 2]

    @cached_property
    def sideways(self) -> np.ndarray:
        """Two directions at right angles to the tube; they turn with its frame."""
        along, guide = self.direction, self.frame[:3, 2]
        if abs(guide @ along) > 0.9:
            guide = self.frame[:3, 0]
        first = unit(guide - (guide @ along) * along)
        return np.array([first, cross(along, first)])

    @cached_property
    def seen_end(self) -> int | None:
        """The end that looks at the viewer."""
        near = [float(self.direction @ self.lens.eye(end)) for end in self.ends]
        return 1 if near[1] > _EDGE_ON else 0 if near[0] < -_EDGE_ON else None

    def rim(self, end: int, share: float = 1.0) -> np.ndarray:
        """A circle round one end, on the picture; `share` of the tube's radius there."""
        middle = self.ends[end]
        circle = _circle(max(self.radii) * self.lens.scale * self.lens.see(middle)[2])
        return self.lens.see(middle + share * self.radii[end] * circle @ self.sideways)[:, :2]

    def skin(self, side: np.ndarray, direction: np.ndarray) -> np.ndarray:
        """Where the skin looks where `side` lies: a cone's leans to its thin end."""
        return unit(self.length * side + (self.radii[0] - self.radii[1]) * direction)


def _tube(lens: Lens, points: np.ndarray, radii: Sequence[float], paint: Paint,
          frame: np.ndarray) -> list[Face]:
    tube, cap, hub = _Tube(lens, points[:2], radii, frame), paint.get("cap"), paint.get("hub")
    outline, end = hull(np.vstack([tube.rim(0), tube.rim(1)])), tube.seen_end
    all_ = [Face("side", outline, gradient=_flank(tube, open_=not cap))]
    if end is not None:
        level = _level(_shine(lens.turn(tube.direction if end else -tube.direction)))
        if cap:
            all_.append(Face("cap", tube.rim(end), min(_BRIGHTEST, level + _LIGHTER)))
        if hub:
            all_.append(Face("hub", tube.rim(end, _HUB), level))
    stripe = _stripe(tube, end) if hub else []
    return [*all_, Face("mark", np.array(stripe))] if stripe else all_


def _flank(tube: _Tube, *, open_: bool) -> Across:
    """The gradient across a tube.

    An end that has no disc of its own (`open_`) lends the tube its brightness, the more the more
    of it is seen.
    """
    lens, middle, n = tube.lens, tube.ends.mean(axis=0), tube.lens.turn(tube.direction)
    eye, (*place, size) = unit(lens.turn(lens.eye(middle))), lens.see(middle)
    near, tall = float(n @ eye), norm(cross(n, eye))
    across = unit(cross(n, eye)) if tall > _EDGE_ON else np.array([1.0, 0.0, 0.0])
    deep = 2 * tube.radii[1 if near > 0 else 0] * near
    share = _disc_share(tall * tube.length, deep) if open_ else 0.0
    end = _shine(n if near > 0 else -n)
    ahead = cross(across, n)
    sides = [u * across + math.sqrt(1 - u * u) * ahead for u in _STOPS]
    levels = tuple(_level((1 - share) * _shine(tube.skin(side, n)) + share * end)
                   for side in sides)
    reach = max(tube.radii) * lens.scale * size * across[:2] * (1, -1)
    return Across(place - reach, place + reach, levels)


def _disc_share(tall: float, deep: float) -> float:
    """How much of what is seen of a tube is its end: all of it when one looks along the tube."""
    whole = deep ** 2 + tall ** 2
    return deep ** 2 / whole if whole > 0 else 0.0


def _stripe(tube: _Tube, end: int | None) -> list[np.ndarray]:
    """A line on the seen end and down the skin, where either is seen: it shows the turning."""
    lens, (u, _), shown = tube.lens, tube.sideways, 1 if end is None else end
    rims = [middle + radius * u for middle, radius in zip(tube.ends, tube.radii)]
    down = float(tube.skin(u, tube.direction) @ lens.eye((rims[0] + rims[1]) / 2)) > _EDGE_ON
    hub = [] if end is None else [tube.ends[end] + _HUB * tube.radii[end] * u]
    line = hub + ([rims[shown]] if hub or down else []) + ([rims[1 - shown]] if down else [])
    return [lens.see(point)[:2] for point in line]


# ---- balls ----

_SPOT = np.array([-0.3, 0.43])                 # where a ball is brightest: right, up
_SPREAD = 1 + float(np.hypot(*_SPOT))          # from there to the farthest rim


def _ball_level(share: float) -> int:
    """The level of every ball so far on the way from its spot through its middle to the rim."""
    side = _SPOT * (1 - share * _SPREAD / (_SPREAD - 1))
    return _level(_shine(np.array([*side, np.sqrt(max(0.0, 1 - float(side @ side)))])))


_BALL = tuple(map(_ball_level, OFFSETS[Round]))


def _ball(lens: Lens, points: np.ndarray, size: Sequence[float], paint: Paint,
          frame: np.ndarray) -> list[Face]:
    *place, near = lens.see(points[0])
    r = size[0] * lens.scale * near
    gradient = Round(place + r * _SPOT * (1, -1), r * _SPREAD, _BALL)
    return [Face("side", place + r * _circle(r), gradient=gradient)]


# ---- boxes ----

_HAIR = 1e-3                                   # of a box's width: what is shorter is hidden
_CORNERS = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])


def _box(lens: Lens, points: np.ndarray, size: Sequence[float], paint: Paint,
         frame: np.ndarray) -> list[Face]:
    along, u, v = points[1:] - points[0]
    ahead = tuple(size[:1]) == (1.0,)
    if norm(along) <= _HAIR * max(norm(u), norm(v)):
        return []
    if ahead and along @ frame[:3, 2] < 0:
        return []
    halves, middle = [along / 2, u, v], points[0] + along / 2
    hand, seen = -1 if along @ cross(u, v) < 0 else 1, []
    for k, half in enumerate(halves):
        p, q = halves[(k + 1) % 3], halves[(k + 2) % 3]
        for side in (-1, 1):
            at, normal = middle + side * half, unit(side * hand * cross(p, q))
            if normal @ lens.eye(at) > _EDGE_ON:
                corners = lens.see(at + _CORNERS @ np.array([p, q]))[:, :2]
                role = "hub" if k == 0 and paint.get("hub") else "face"
                seen.append(Face(role, corners, _level(_shine(lens.turn(normal)))))
    return seen


# ---- all of them ----

_MAKERS = {TUBE: _tube, BALL: _ball, BOX: _box}


def faces(shape: str, lens: Lens, points: np.ndarray, size: Sequence[float], paint: Paint,
          frame: np.ndarray) -> list[Face]:
    """What is seen of a solid, in the order of painting; nothing where it is hidden.

    Parameters
    ----------
    shape : str
        ``tube``, ``ball`` or ``box``, as in `Item`.
    lens : Lens
        What the camera makes of the room.
    points : (n, 3) ndarray
        The item's points, in the room.
    size : sequence of float
        The item's size.
    paint : Paint
        Says whether a solid has caps and hubs.
    frame : (4, 4) ndarray
        Pose of the frame in which the first point stands.
    """
    return _MAKERS[shape](lens, points, size, paint, frame)
