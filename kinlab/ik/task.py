"""How far the tool is from its target, and how that changes with the joints, at many places.

Motions begin at the inverse of the target's pose, so the tool's frame at their end *is* the
error, in the target's own axes. Lengths are measured in the arm's reach, so that they compare
with radians. Arrays keep their last axis for the places, called m.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import Any

import numpy as np

from ..arms.arm import Arm
from ..arms.joints import WHOLE_TURN, joint_limits
from ..arms.kinematics import reach, tool_and_joints, twist, typical_length
from ..arms.link import REVOLUTE
from ..arms.motions import ROTATE, TRANSLATE, Frame, cross
from ..arms.route import Place, Vector

Places = slice | np.ndarray
AIM = 0.99  # of the tolerance, so that rounding does not undo what was reached
HALF = -0.9999  # a rotation whose cosine is below this has no sine to tell its axis by


@dataclass(frozen=True)
class Task:
    """What all starts have in common: the arm, its limits, and what counts as reached."""

    arm: Arm
    weights: np.ndarray
    tolerance: float
    keep_limits: bool = True

    @cached_property
    def motions(self) -> tuple:
        return tuple(motion for motion in chain(*self.arm.chain) if not motion.idle)

    @cached_property
    def rows(self) -> Places:
        """The directions that count."""
        return _where(self.weights)

    @cached_property
    def length(self) -> float:
        """The length that counts as much as a radian."""
        return typical_length(self.arm)

    @cached_property
    def scale(self) -> np.ndarray:
        lengths = np.repeat([self.length, 1.0], 3)
        return (self.weights / lengths)[self.rows, None]

    @cached_property
    def limits(self) -> tuple[np.ndarray, np.ndarray]:
        """Lowest and highest joint values that are allowed, shape (n, 1)."""
        low, high = joint_limits(self.arm)[..., None]
        held = self.keep_limits | (low == high)  # a lock holds, whatever becomes of limits
        return np.where(held, low, -np.inf), np.where(held, high, np.inf)

    @cached_property
    def walls(self) -> tuple[np.ndarray, np.ndarray]:
        """Limits that hold a descent back: not those with room for a whole turn."""
        low, high = self.limits
        free = self.revolute & (high - low >= 2 * np.pi - 1e-9)
        return np.where(free, -np.inf, low), np.where(free, np.inf, high)

    @cached_property
    def revolute(self) -> np.ndarray:
        """Which joints turn, shape (n, 1)."""
        return np.array([[link.kind == REVOLUTE] for link in self.arm.joints])

    @cached_property
    def kinds(self) -> tuple[tuple[str, Places], ...]:
        """The motions of joints, and which joints make each."""
        turns = self.revolute[:, 0]
        return tuple((kind, _where(these)) for kind, these in ((ROTATE, turns), (TRANSLATE, ~turns))
                     if these.any())

    def starts(self, rng: np.random.Generator, count: int) -> np.ndarray:
        """Random joint values within the limits, shape (n, count)."""
        slide = -self.length, self.length
        low, high = joint_limits(self.arm, turn=WHOLE_TURN, slide=slide)[..., None]
        return rng.uniform(low, high, (self.arm.n, count))

    @cached_property
    def reach(self) -> float:
        """Farther from the base no target is reached; infinite if that cannot be said."""
        bounded = self.weights[:3].all() and (self.keep_limits or self.revolute.all())
        return reach(self.arm) if bounded else np.inf

    @cached_property
    def middle(self) -> np.ndarray:
        """The middle of the limits, and 0 where there are none."""
        low, high = self.limits
        bounded = np.isfinite(high)
        return 0.5 * (np.where(bounded, low, 0) + np.where(bounded, high, 0))

    def allowed(self, q: np.ndarray) -> np.ndarray:
        """The nearest joint values between the walls; angles are near across a whole turn too."""
        low, high = self.walls
        return np.clip(q - np.isfinite(high) * self._turns(q - self.middle), low, high)

    @cached_property
    def gates(self) -> list[tuple[float, float, float | None]]:
        """Of each joint its walls, and the angle about which whole turns are taken off."""
        low, high = self.walls
        wraps = self.revolute & np.isfinite(high)
        return [(*ends, middle if wrap else None) for *ends, middle, wrap
                in np.hstack([low, high, self.middle, wraps]).tolist()]

    def kept(self, q: Vector) -> list[float]:
        """`allowed` at one place, in plain floats."""
        near = [x if middle is None else x - math.tau * round((x - middle) / math.tau)
                for x, (_, _, middle) in zip(q, self.gates)]
        return [min(max(x, low), high) for x, (low, high, _) in zip(near, self.gates)]

    def settled(self, q: np.ndarray, near: np.ndarray) -> np.ndarray:
        """The same pose, whole turns taken off: within the limits, or else nearest to `near`."""
        low, high = self.limits
        bounded = np.isfinite(high)
        outside = ~bounded | (q < low) | (q > high)
        return np.clip(q - outside * self._turns(q - np.where(bounded, self.middle, near)),
                       low, high)

    def _turns(self, q: np.ndarray) -> np.ndarray:
        """The whole turns in angles; none in lengths."""
        return self.revolute * (2 * np.pi) * np.round(q / (2 * np.pi))

    def errors(self, seen: np.ndarray, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Jacobian (n, rows, m) and weighted error (rows, m) at joint values (n, m).

        `seen`, shape (4, 3, m), is the room as the targets see it: its axes and its origin.
        """
        tool, joints = tool_and_joints(self.motions, q, _vectors(seen))
        J, e = np.empty((self.arm.n, 6, q.shape[1])), np.empty((6, q.shape[1]))
        (e[:3],), z = tool.origin, np.array([axis for _, (axis,), _ in joints])
        lever = e[:3] - np.array([point for *_, (point,) in joints])
        for kind, these in self.kinds:
            for row, component in enumerate(twist(kind, _apart(z[these]), _apart(lever[these]))):
                J[these, row] = component
        if self.turns:
            e[3:] = rotation_vectors(np.array([axis for (axis,) in tool.settled()]))
        if self.lopsided:
            J[:, 3:] = np.einsum("klm,nlm->nkm", _rates(e[3:]), J[:, 3:])
        return J[:, self.rows] * self.scale, e[self.rows] * self.scale

    def error(self, seen: Place, q: Vector) -> tuple[np.ndarray, np.ndarray]:
        """`errors` at one place, by plain floats: Jacobian (n, rows) and error (rows)."""
        J, e = self._twists(seen, q)
        return self._counted(J, e), e[self.rows] * self.scale[:, 0]

    def pull(self, seen: Place, q: Vector, twist: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The Jacobian (n, rows) as in `error`, and the rate (rows) of the error as the target
        moves: by the twist (v, w) of its origin, in its own axes.
        """
        J, e = self._twists(seen, q)
        v, w = twist[:3], twist[3:]
        back = -np.concatenate([v + cross(w, e[:3]), w])  # how the target sees the tool go
        rates = self._counted(np.vstack([J, back]), e)
        return rates[:-1], rates[-1]

    def _twists(self, seen: Place, q: Vector) -> tuple[np.ndarray, np.ndarray]:
        """Jacobian (n, 6) and error (6) at one place, in plain lengths and radians."""
        places = self.arm.route.places(q, seen)
        axes, origin = places[-1]
        turned = rotation_vector(axes) if self.turns else (0.0, 0.0, 0.0)
        return np.array(self.arm.route.twists(places)), np.array([*origin, *turned])

    def _counted(self, twists: np.ndarray, e: np.ndarray) -> np.ndarray:
        """What twists (k, 6) do to the error, in the directions that count, weighted."""
        if self.lopsided:
            twists[:, 3:] = twists[:, 3:] @ _rates(e[3:].tolist()).T
        return twists[:, self.rows] * self.scale[:, 0]

    @cached_property
    def turns(self) -> bool:
        return bool(self.weights[3:].any())

    @cached_property
    def lopsided(self) -> bool:
        """Rotations that count unequally: the axis of the error is then not free to choose."""
        return len(set(self.weights[3:])) > 1

    def reached(self, e: np.ndarray) -> np.ndarray:
        """Whether weighted errors (rows, m) are within the tolerance."""
        squares = np.square(e / self.weights[self.rows, None])
        places = np.count_nonzero(self.weights[:3])
        return ((squares[:places].sum(axis=0) <= self.most)
                & (squares[places:].sum(axis=0) <= self.most))

    def is_reached(self, e: np.ndarray) -> bool:
        """`reached` at one place; a glance at the weighted error tells while it is large."""
        return bool(e @ e <= 4 * self.most and self.reached(e[:, None])[0])

    @cached_property
    def most(self) -> float:
        """The largest squared error in position, and in rotation."""
        return (AIM * self.tolerance) ** 2


def seen_from(targets: np.ndarray) -> np.ndarray:
    """Axes and origin of the room, seen from targets (m, 4, 4): shape (4, 3, m)."""
    R, o = targets[:, :3, :3], targets[:, :3, 3]
    origin = -np.einsum("mji,mj->mi", R, o)
    return np.ascontiguousarray(np.concatenate([R, origin[:, None]], axis=1).transpose(1, 2, 0))


def rotation_vectors(R: np.ndarray) -> np.ndarray:
    """Axis times angle (3, m) of rotations given by axes (3, 3, m); also where it nears pi."""
    v = 0.5 * np.stack([R[1, 2] - R[2, 1], R[2, 0] - R[0, 2], R[0, 1] - R[1, 0]])
    cos, sin = 0.5 * (R[0, 0] + R[1, 1] + R[2, 2] - 1), np.sqrt(np.sum(v * v, axis=0))
    angle = np.arctan2(sin, cos)
    vectors = v * np.where(sin > 1e-9, angle / np.maximum(sin, 1e-9), 1)
    half = cos < HALF  # here v fades, but the symmetric part of R shows the axis
    if half.any():
        vectors[:, half] = angle[half] * _axes_of_half_turns(R[..., half], v[:, half])
    return vectors


def rotation_vector(axes: Sequence[Vector]) -> Vector:
    """`rotation_vectors` of one rotation, given by its axes, in plain floats."""
    (a, b, c), (d, e, f), (g, h, i) = axes
    v = 0.5 * (f - h), 0.5 * (g - c), 0.5 * (b - d)
    cos, sin = 0.5 * (a + e + i - 1), math.hypot(*v)
    if cos < HALF:
        return rotation_vectors(np.array(axes)[..., None])[:, 0].tolist()
    stretch = math.atan2(sin, cos) / sin if sin > 1e-9 else 1.0
    return [stretch * component for component in v]


def _axes_of_half_turns(R: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Unit axes of rotations by nearly pi; `v` is axis times sine and tells the sign."""
    B = 0.5 * (R + np.swapaxes(R, 0, 1))
    B -= np.eye(3)[..., None] * 0.5 * (np.trace(R) - 1)  # left is a multiple of axis axis^T
    longest = np.argmax(np.einsum("iim->im", B), axis=0)
    axes = B[:, longest, np.arange(B.shape[-1])]
    sign = np.where(np.sum(axes * v, axis=0) < 0, -1, 1)
    return sign * axes / np.sqrt(np.sum(axes * axes, axis=0))


def _rates(v: Any) -> np.ndarray:
    """What makes rates of a rotation vector v (3, ...) of angular velocities, shape (3, 3, ...).

    v' = w - (v x w) / 2 + b v x (v x w), Bullo and Murray (1995), exactly.
    """
    x, y, z = v
    square = x * x + y * y + z * z
    angle = np.maximum(np.sqrt(square), 1e-4)
    b = (1 - 0.5 * angle / np.tan(0.5 * angle)) / angle ** 2
    k, x_, y_, z_ = 1 - b * square, 0.5 * x, 0.5 * y, 0.5 * z
    return np.array([[k + b * x * x, b * x * y + z_, b * x * z - y_],
                     [b * x * y - z_, k + b * y * y, b * y * z + x_],
                     [b * x * z + y_, b * y * z - x_, k + b * z * z]])


def _apart(vectors: np.ndarray) -> np.ndarray:
    """Vectors (n, 3, m) component by component, shape (3, n, m); or back."""
    return vectors.swapaxes(0, 1)


def _where(these: np.ndarray) -> Places:
    """Where the entries are not zero; everywhere as a slice, which copies nothing."""
    return slice(None) if these.all() else np.flatnonzero(these)


def _vectors(seen: np.ndarray) -> Frame:
    """A frame whose axes and origin have one component: a whole vector, shape (3, m)."""
    x, y, z, origin = seen
    return Frame(((x,), (y,), (z,)), (origin,))
