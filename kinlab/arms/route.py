"""One pose in plain floats: the recurrence of `Frame`, for those who wait for it.

`Frame` asks of every component whether it is a number, a batch or a symbol, and whether it is 0
or 1 for ever. A single pose in numbers needs no answer to that: the same turns and slides in the
same order give the same floats, twenty times sooner. A test compares them to the last bit.
"""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import accumulate

from .motions import ROTATE, Motion, cos_sin

Vector = Sequence[float]
Place = tuple[Sequence[Vector], Vector]  # axis columns and origin of a frame

ROOM: Place = (((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), (0.0, 0.0, 0.0))


@dataclass(frozen=True, eq=False)
class Route:
    """The motions of a chain that are not idle, ready to be followed again and again.

    Attributes
    ----------
    steps : tuple
        Of each motion: does it turn, its axis, amount, joint and sign.
    ends : tuple of int
        How many steps lead to the end of each stretch of the chain.
    """

    steps: tuple[tuple[bool, int, float, int | None, int], ...]
    ends: tuple[int, ...]

    @classmethod
    def along(cls, chain: Iterable[Iterable[Motion]]) -> Route:
        """The route along the stretches of a chain."""
        stretches = [[m for m in motions if not m.idle] for motions in chain]
        return cls(tuple((m.kind == ROTATE, m.axis, m.amount, m.joint, m.sign)
                         for motions in stretches for m in motions),
                   tuple(accumulate(map(len, stretches))))

    def pose(self, q: Vector) -> list[tuple[float, ...]]:
        """The homogeneous matrix at the end, row by row."""
        return _rows(self.places(q)[-1])

    def frames(self, q: Vector) -> list[list[tuple[float, ...]]]:
        """The homogeneous matrices after each stretch but the last, which is the tool's."""
        places = self.places(q)
        return [_rows(places[end]) for end in self.ends[:-1]]

    def jacobian(self, q: Vector) -> list[tuple[float, ...]]:
        """The Jacobian of the end, row by row."""
        return [*zip(*self.twists(self.places(q)))]

    def places(self, q: Vector, start: Place = ROOM) -> list[Place]:
        """Where the frame is at the start and after each step, at the joint values `q`."""
        axes, origin = start
        about, angle, before, places = None, 0.0, axes, [start]
        for turns, axis, amount, joint, sign in self.steps:
            if joint is not None:
                amount += sign * q[joint]
            if not turns:
                (x, y, z), (u, v, w) = origin, axes[axis]
                origin = (x + amount * u, y + amount * v, z + amount * w)
            else:
                if axis != about:  # else it goes on with the turn that is under way
                    about, angle, before = axis, 0.0, axes
                angle += amount
                axes = _turned(before, axis, angle)
            places.append((axes, origin))
        return places

    def twists(self, places: Sequence[Place]) -> list[tuple[float, ...]]:
        """Each joint's column of the Jacobian, (v, w), as in `kinematics.twist`."""
        px, py, pz = places[-1][1]
        twists: list[tuple[float, ...]] = []
        for (turns, axis, _, joint, sign), (axes, (x, y, z)) in zip(self.steps, places[1:]):
            if joint is None:
                continue
            u, v, w = axes[axis] if sign > 0 else [-component for component in axes[axis]]
            if turns:
                x, y, z = px - x, py - y, pz - z
                twists.append((v * z - w * y, w * x - u * z, u * y - v * x, u, v, w))
            else:
                twists.append((u, v, w, 0.0, 0.0, 0.0))
        return twists


def _rows(place: Place) -> list[tuple[float, ...]]:
    """The homogeneous matrix of a frame."""
    (x, y, z), origin = place
    return [*zip(x, y, z, origin), (0.0, 0.0, 0.0, 1.0)]


def _turned(axes: Sequence[Vector], axis: int, angle: float) -> list[Vector]:
    """Axis columns turned about one of them."""
    i, j = axis - 2, axis - 1  # the next two, in cyclic order
    c, s = cos_sin(angle)
    (a, b, d), (u, v, w), turned = axes[i], axes[j], [*axes]
    turned[i] = (c * a + s * u, c * b + s * v, c * d + s * w)
    turned[j] = (c * u - s * a, c * v - s * b, c * w - s * d)
    return turned
