"""The exact edge of what three parallel joints reach in their plane, within their limits.

On the edge the tool cannot move outwards: every joint is at a limit, or the links that can turn
lie in one line with the tool. So the edge is made of arcs, drawn by one joint while all others
stand at such values. All these arcs are cut where they meet, and a piece is on the edge if the
tool reaches only one of its sides.
"""
from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise, product

import numpy as np

Inside = Callable[[np.ndarray], np.ndarray]
_SLACK = 1e-9   # rad, and parts of the reach
_ASIDE = 1e-5   # of the reach: how far beside a piece it is asked what is reached
_TURN = 2 * np.pi


@dataclass(frozen=True)
class Arc:
    """Part of a circle, from the angle `start` on, counter-clockwise for `sweep` > 0 (rad)."""

    center: complex
    radius: float
    start: float
    sweep: float

    def at(self, shares: np.ndarray | float) -> np.ndarray:
        """Points at shares of the way, as complex numbers."""
        return self.center + self.radius * np.exp(1j * (self.start + np.asarray(shares)
                                                        * self.sweep))

    def corners(self, near: float) -> np.ndarray:
        """Points along the arc, such that lines between them are as `near` to it as that."""
        step = 2 * np.arccos(max(0.0, 1 - near / self.radius))
        return self.at(np.linspace(0, 1, 1 + max(1, int(np.ceil(abs(self.sweep) / step)))))

    def mirrored(self) -> Arc:
        """The arc with left and right exchanged."""
        return Arc(-self.center.conjugate(), self.radius, np.pi - self.start, -self.sweep)

    def reversed(self) -> Arc:
        """The arc run through from its end."""
        return Arc(self.center, self.radius, self.start + self.sweep, -self.sweep)


@dataclass(frozen=True)
class Chain:
    """Three links in a plane; points of it are complex numbers, angles counter-clockwise (rad).

    At 0 a joint carries its link straight on: the first one along the real axis.
    """

    lengths: tuple[float, float, float]
    limits: tuple[tuple[float, float], ...]

    @property
    def reach(self) -> float:
        return sum(self.lengths)

    def tip(self, q: np.ndarray) -> np.ndarray:
        """Where the tool is at joint values (..., 3)."""
        return np.exp(1j * np.cumsum(q, axis=-1)) @ np.array(self.lengths)

    def arcs(self) -> list[Arc]:
        """All arcs that may be part of the edge."""
        arcs = []
        for k in range(3):
            for ends in product(*([*self.limits[i]] for i in range(k))):
                arcs += self._arcs_of(k, ends)
        return arcs

    def _arcs_of(self, k: int, before: tuple[float, ...]) -> list[Arc]:
        """The arcs that joint k draws while joints before it stand still.

        Each later joint stands at a limit, or turns what is beyond it into line with joint k.
        """
        heading = sum(before)
        center = complex(np.exp(1j * np.cumsum(before)) @ np.array(self.lengths[:k]))
        low, high = self.limits[k]
        arcs = []
        for rest in self._stretched(k):
            arm = _end(self.lengths[k:], rest)
            arcs.append(Arc(center, abs(arm), heading + low + np.angle(arm), high - low))
        return arcs

    def _stretched(self, k: int) -> Iterable[tuple[float, ...]]:
        """Values of the joints after k: each at a limit, or in line."""
        if k == 2:
            return [()]
        if k == 1:
            return [(c,) for c in self._values(2, (0.0, np.pi))]
        l1, l2, l3 = self.lengths
        found = [(b, c) for b in self._values(1, ()) for c in self._values(2, ())]
        for b in self._values(1, (0.0, np.pi)):  # the tool in line with shoulder and wrist
            wrist = np.angle(l1 + l2 * np.exp(1j * b))
            found += [(b, wrist - b), (b, wrist - b + np.pi)]
        for c in self._values(2, (0.0, np.pi)):  # forearm and tool, as one piece, in line with 1
            piece = np.angle(l2 + l3 * np.exp(1j * c))
            found += [(-piece, c), (np.pi - piece, c)]
        return [q for q in found if self._holds(1, q[0]) and self._holds(2, q[1])]

    def _values(self, joint: int, more: tuple[float, ...]) -> list[float]:
        """A joint's limits, and those of some other values that it may have."""
        return [*self.limits[joint], *(value for value in more if self._holds(joint, value))]

    def _holds(self, joint: int, angle: np.ndarray | float) -> np.ndarray:
        """Whether a joint may have an angle, or one that differs by whole turns."""
        low, high = self.limits[joint]
        return (np.asarray(angle) - low + _SLACK) % _TURN <= high - low + 2 * _SLACK

    def inside(self, points: np.ndarray) -> np.ndarray:
        """Whether the tool reaches each point.

        The joint values that lead to a point form curves. A curve that keeps within all limits
        has a place where the tool is in line with shoulder and wrist, or the elbow is straight
        or folded; any other one ends where some joint is at its limit.
        """
        points = np.asarray(points, complex)
        reached = np.zeros(points.shape, bool)
        for q in self._ways(points):
            reached |= np.all([self._holds(k, q[k]) for k in range(3)], axis=0)
        return reached

    def inside_either_way(self, points: np.ndarray) -> np.ndarray:
        """Whether the tool or its mirror image reaches each point."""
        return self.inside(points) | self.inside(-np.conjugate(points))

    def _ways(self, points: np.ndarray) -> Iterable[Sequence[np.ndarray]]:
        l1, l2, l3 = self.lengths
        for a in self.limits[0]:
            for u, v in _two(l2, l3, points - l1 * np.exp(1j * a)):
                yield np.full(points.shape, a), u - a, v - u
        for b in (*self.limits[1], 0.0, np.pi):
            arm = l1 + l2 * np.exp(1j * b)
            for u, v in _two(abs(arm), l3, points):
                a = u - np.angle(arm)
                yield a, np.full(points.shape, b), v - a - b
        for c in self.limits[2]:
            piece = l2 + l3 * np.exp(1j * c)
            for u, v in _two(l1, abs(piece), points):
                yield u, v - np.angle(piece) - u, np.full(points.shape, c)
        for sign in (1, -1):
            heading = np.angle(sign * points)
            for u, v in _two(l1, l2, points - l3 * np.exp(1j * heading)):
                yield u, v - u, heading - v


def _end(lengths: Sequence[float], angles: Sequence[float]) -> complex:
    """Where some links end, the first along the real axis, for the angles of the others."""
    return complex(np.exp(1j * np.cumsum([0.0, *angles])) @ np.array(lengths))


def _two(one: float, other: float, points: np.ndarray) -> Iterable[tuple[np.ndarray, np.ndarray]]:
    """Headings of two links that lead to each point, bent one way and the other; nan if none."""
    r = np.abs(points)
    with np.errstate(divide="ignore", invalid="ignore"):
        cosine = (one * one + r * r - other * other) / (2 * one * r)
        bend = np.arccos(np.where(np.abs(cosine) < 1 + _SLACK, np.clip(cosine, -1, 1), np.nan))
    for sign in (1, -1):
        first = np.angle(points) + sign * bend
        yield first, np.angle(points - one * np.exp(1j * first))


def edge(chain: Chain, *, both_sides: bool = False) -> list[list[Arc]]:
    """The edge of what the chain reaches, as closed rows of arcs, the inside on their left.

    With `both_sides` its mirror image counts as reached, too: a base that can turn half round.
    """
    arcs, inside = chain.arcs(), chain.inside
    if both_sides:
        arcs += [arc.mirrored() for arc in arcs]
        inside = chain.inside_either_way
    small = _ASIDE * chain.reach
    pieces = [piece for arc in arcs if arc.radius > small
              for piece in _cut(arc, arcs, chain.reach)]
    rows = _rows(_edges(pieces, inside, small), small)
    return sorted(rows, key=lambda row: -max(arc.radius for arc in row))


def _cut(arc: Arc, others: Iterable[Arc], reach: float) -> list[Arc]:
    """The pieces of an arc between all places where others meet it or end on it."""
    cuts = [0.0, abs(arc.sweep)]
    for other in others:
        meets = [*_meetings(arc, other), *other.at(np.array([0.0, 1.0]))]
        on = [p for p in meets if abs(abs(p - arc.center) - arc.radius) < 1e-7 * reach]
        cuts += [_along(arc, p) for p in on]
    places = np.unique(np.round([c for c in cuts if 0 <= c <= abs(arc.sweep)], 7)).tolist()
    sign = np.sign(arc.sweep)
    return [Arc(arc.center, arc.radius, arc.start + sign * a, sign * (b - a))
            for a, b in pairwise(places) if b - a > 1e-6]


def _along(arc: Arc, point: complex) -> float:
    """How far along the arc, as an angle, a point on its circle lies."""
    return float(np.sign(arc.sweep) * (np.angle(point - arc.center) - arc.start) % _TURN)


def _meetings(arc: Arc, other: Arc) -> list[complex]:
    """Where two circles meet."""
    way = other.center - arc.center
    d = abs(way)
    if d < 1e-12 * (arc.radius + other.radius):
        return []
    along = (d * d + arc.radius**2 - other.radius**2) / (2 * d)
    square = arc.radius**2 - along**2
    if square < -1e-9 * arc.radius**2:
        return []
    aside = max(square, 0.0) ** 0.5
    return [arc.center + way / d * (along + side * 1j * aside) for side in (1, -1)]


def _edges(pieces: list[Arc], inside: Inside, aside: float) -> list[Arc]:
    """The pieces with the inside on one side alone, turned so that it is their left one; once."""
    middles = np.array([complex(piece.at(0.5)) for piece in pieces])
    outwards = np.array([(m - piece.center) / piece.radius for m, piece in zip(middles, pieces)])
    within, beyond = inside(middles - aside * outwards), inside(middles + aside * outwards)
    kept: list[int] = []
    for k in np.flatnonzero(within != beyond):
        if not kept or np.abs(middles[kept] - middles[k]).min() > 0.1 * aside:
            kept.append(int(k))
    return [pieces[k] if (pieces[k].sweep > 0) == within[k] else pieces[k].reversed()
            for k in kept]


def _rows(arcs: list[Arc], gap: float) -> list[list[Arc]]:
    """Arcs one after another, each row ending where it began."""
    rows, left = [], list(arcs)
    while left:
        row = [left.pop(0)]
        while abs(row[-1].at(1) - row[0].at(0)) > gap and left:
            near = min(left, key=lambda arc: abs(arc.at(0) - row[-1].at(1)))
            if abs(near.at(0) - row[-1].at(1)) > gap:
                break
            left.remove(near)
            row.append(near)
        rows.append(row)
    return rows
