"""When two arms are the same mechanism: their joint axes compared, whatever frames were chosen.

An arm moves its tool by T(q) = exp(S_1 q_1) ... exp(S_n q_n) T(0), with S_i the axis of joint i
at q = 0: a line if it turns, a direction if it slides. Let c be joint offsets, s signs, B a base
placement and E a tool transform. Offsets carry the axes into another pose, S_i(c), so

    T(s q + c) = exp(s_1 S_1(c) q_1) ... exp(s_n S_n(c) q_n) T(c).

Two arms therefore move alike for all q, B T(s q + c) E = T'(q), exactly when B carries the axes
s_i S_i(c) onto S'_i: derivatives at q = 0 show that this is necessary, the formula that it is
enough (E makes up for the tool). So there must be a pose c in which the axes of one arm lie on
those of the other. That asks for

* equal twists between neighbouring axes, and equal bends (the angle about an axis between the
  planes of its two twists) at prismatic axes: a revolute joint makes up for any bend;
* between one revolute axis and the next, equal steps in the basis that these directions span, up
  to slides along either revolute axis and along the prismatic axes between. A slide along a
  revolute axis is shared by both its neighbours. So the steps of all links, stacked, may differ
  only by an element of one linear space: the rest of the difference is what is wrong.

Flipped axes change signs of these numbers. All sign patterns that the twists allow are tried.
"""
from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import NamedTuple, TypeVar

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import link_frames
from ..arms.link import REVOLUTE
from .fixed_rows import joints_only

# Half of the sixth decimal: an angle typed as 1.570796 counts as pi/2. Lengths: of each itself.
SIXTH_DECIMAL = 5e-7
ROUNDING = 1e-9  # of the longest length
FLAT = 1e-6  # a smaller singular value or slope is rounding noise
MOST_PATTERNS, MOST_COMPARED = 4096, 256
Angles = TypeVar("Angles", float, np.ndarray)
WORDS = {"alpha": "twist", "theta": "angle", "a": "length", "d": "offset"}


def cross(u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """The cross product of two vectors; numpy's own takes ten times as long for so few."""
    (a, b, c), (d, e, f) = u.tolist(), v.tolist()
    return np.array([b * f - c * e, c * d - a * f, a * e - b * d])


class Axes(NamedTuple):
    """Joint axes of an arm at q = 0, with the standard table, a row for each joint, of them."""

    arm: Arm
    turns: np.ndarray  # (n,) revolute or not
    z: np.ndarray  # (n, 3) direction of each axis
    x: np.ndarray  # (n, 3) x of frames 1 to n
    a: np.ndarray
    d: np.ndarray

    @property
    def n(self) -> int:
        return len(self.turns)

    @property
    def longest(self) -> float:
        """The longest length of the table; where it has none, rounding leaves some noise."""
        ends = np.abs([self.arm.base[:3, 3], self.arm.tool[:3, 3]]).max()
        return max(np.abs(self.a).max(), np.abs(self.d).max(), 1e-6 * ends, 1e-6)

    def twist(self, i: int) -> float:
        """Angle from axis i to axis i + 1, in [0, pi]."""
        return float(np.arctan2(np.linalg.norm(self.normal(i)), self.z[i] @ self.z[i + 1]))

    def normal(self, i: int) -> np.ndarray:
        return cross(self.z[i], self.z[i + 1])

    def bend(self, k: int, m: int) -> float:
        """Angle about axis k from the normal before it to the one after axis m, parallel to k."""
        before, after = self.normal(k - 1), self.normal(m)
        return float(np.arctan2(self.z[k] @ cross(before, after), before @ after))

    def steps(self) -> np.ndarray:
        """From each frame's origin to the next, along z and then along x: (n, 3)."""
        return self.d[:, None] * self.z + self.a[:, None] * self.x


def axes_of(arm: Arm) -> Axes:
    """The joint axes of an arm."""
    arm = joints_only(arm)
    frames = link_frames(arm, np.zeros(arm.n))
    values = np.array([(link.a, link.d) for link in arm.links])
    turns = np.array([link.kind == REVOLUTE for link in arm.links])
    return Axes(arm, turns, frames[:-1, :3, 2], frames[1:, :3, 0], *values.T)


class Group(NamedTuple):
    """From one revolute axis to the next; `third` is the first axis not parallel to the first."""

    first: int
    last: int
    third: int | None


@dataclass(frozen=True)
class Layout:
    """What the reference decides: which axes are parallel, and what may slide where."""

    axes: Axes

    @cached_property
    def parallel(self) -> np.ndarray:
        """(n - 1,) whether axis i and axis i + 1 are parallel."""
        return np.array([np.sin(t) <= SIXTH_DECIMAL for t in self.twists], dtype=bool)

    @cached_property
    def twists(self) -> list[float]:
        return [self.axes.twist(i) for i in range(self.axes.n - 1)]

    @cached_property
    def runs(self) -> list[range]:
        """Neighbouring axes that are parallel."""
        cuts = [0, *(np.flatnonzero(~self.parallel) + 1), self.axes.n]
        return [range(start, stop) for start, stop in pairwise(cuts)]

    @cached_property
    def bends(self) -> dict[tuple[int, int], float]:
        """Bends that no revolute joint makes up for."""
        held = [run for run in self.runs[1:-1] if not self.axes.turns[run].any()]
        return {(run[0], run[-1]): self.axes.bend(run[0], run[-1]) for run in held}

    @cached_property
    def groups(self) -> list[Group]:
        turning = np.flatnonzero(self.axes.turns).tolist()
        start_of_next = {i: run.stop for run in self.runs for i in run}
        return [Group(p, q, start_of_next[p] if start_of_next[p] <= q else None)
                for p, q in pairwise(turning)]

    @cached_property
    def steps(self) -> np.ndarray:
        return stacked(self.axes, self)[0]

    @cached_property
    def fixed(self) -> np.ndarray:
        """Projector onto what no slide along an axis changes in the stacked steps."""
        slides = np.zeros((self.axes.n, 3 * len(self.groups)))
        for g, group in enumerate(self.groups):
            E, block = basis(self.axes, group), slice(3 * g, 3 * g + 3)
            for i in range(group.first, group.last + 1):
                slides[i, block] = self.axes.z[i] @ E.T * (-1 if i == group.first else 1)
        U, sizes, _ = np.linalg.svd(slides.T, full_matrices=False)
        U = U[:, sizes > FLAT]
        return np.eye(len(U)) - U @ U.T


@lru_cache(maxsize=16)
def layout_of(reference: Arm) -> Layout:
    """The layout of a reference, which is asked for again with every answer."""
    return Layout(axes_of(reference))


def basis(axes: Axes, group: Group) -> np.ndarray:
    """Rows e1, e2, e3: e3 along the group's first axis, e2 normal to it and to the third one."""
    first, last, third = group
    z, step = axes.z[first], axes.steps()[first:last].sum(axis=0)
    across = step - (step @ z) * z
    if third is None:
        e1 = across if np.linalg.norm(across) > 0 else axes.x[first]
        e2 = cross(z, e1)
    else:
        e2 = cross(z, axes.z[third])
        if np.linalg.norm(e2) <= SIXTH_DECIMAL:  # parallel where the reference's are not
            e2 = across if np.linalg.norm(across) > 0 else axes.x[first]
    e2 = e2 / np.linalg.norm(e2)
    return np.array([cross(e2, z), e2, z])


def stacked(axes: Axes, layout: Layout) -> tuple[np.ndarray, np.ndarray]:
    """Steps of all groups, each in its own basis, and their slopes by every length.

    The slopes have two rows for each link, by a and by d.
    """
    steps, slopes = np.zeros(3 * len(layout.groups)), np.zeros((axes.n, 2, 3 * len(layout.groups)))
    for g, group in enumerate(layout.groups):
        E, block = basis(axes, group), slice(3 * g, 3 * g + 3)
        links = slice(group.first, group.last)
        steps[block] = E @ axes.steps()[links].sum(axis=0)
        slopes[links, 0, block], slopes[links, 1, block] = axes.x[links] @ E.T, axes.z[links] @ E.T
    return steps, slopes


def flips(signs: np.ndarray, layout: Layout) -> np.ndarray:
    """What sign patterns (m, n) do to the stacked steps: factors (m, 3 groups)."""
    factors = np.ones((len(signs), 3 * len(layout.groups)))
    for g, (first, _, third) in enumerate(layout.groups):
        side = np.ones(len(signs)) if third is None else signs[:, third]
        turn = np.ones(len(signs)) if third is None else side * signs[:, first]
        factors[:, 3 * g:3 * g + 3] = np.stack([side, turn, signs[:, first]], axis=-1)
    return factors


def turned_bend(bend: float, signs: np.ndarray, k: int, m: int) -> np.ndarray:
    """The bend between axes of which some are flipped; its own inverse."""
    both = signs[..., k - 1] * signs[..., k] * signs[..., m] * signs[..., m + 1]
    return np.arctan2(both * signs[..., k] * np.sin(bend), both * np.cos(bend))


def differ(a: Angles, b: float) -> np.ndarray | np.bool_:
    """Whether angles differ, whole turns aside."""
    return np.abs(wrapped(a - b)) > SIXTH_DECIMAL


def wrapped(angle: Angles) -> Angles:
    """The angle between -pi and pi."""
    return np.angle(np.exp(1j * angle))


def own_row(i: int, parameter: str, convention: str) -> int:
    """The row, from 1, of a table that holds a number of row i, from 0, of the standard one."""
    return i + 1 + (convention == "modified" and parameter in ("alpha", "a"))


def apart(a: float, b: float) -> tuple[str, str]:
    """Two values as texts, with as many digits as it takes to tell them apart."""
    for digits in (6, 9, 12):
        one, other = (f"{round(value, 12) + 0.0:.{digits}g}" for value in (a, b))
        if one != other:
            break
    return one, other


def fitting(answer: Axes, layout: Layout) -> np.ndarray:
    """Signs (m, n) by which the axes of one arm lie on those of another with the same joints.

    None are left, (0, n), where the mechanisms differ.
    """
    signs = _patterns(answer, layout)
    steps, slopes = stacked(answer, layout)
    flipped = flips(signs, layout)
    gaps = (flipped * steps - layout.steps) @ layout.fixed
    nearest = np.argsort(np.linalg.norm(gaps, axis=1), kind="stable")[:MOST_COMPARED]
    bars = (flipped[nearest][:, None] * slopes.reshape(2 * answer.n, -1)) @ layout.fixed
    return signs[nearest][_no_longer(answer, layout.axes, gaps[nearest], bars)]


def _patterns(answer: Axes, layout: Layout) -> np.ndarray:
    """Sign patterns (m, n) that leave no angle off."""
    signs = np.array([[1], [-1]])
    for i in range(1, answer.n):
        signs = np.column_stack([np.tile(signs, (2, 1)), np.repeat([1, -1], len(signs))])
        twist, expected = answer.twist(i - 1), layout.twists[i - 1]
        straight = signs[:, i - 1] == signs[:, i]
        off = differ(np.where(straight, twist, np.pi - twist), expected)
        for (k, m), expected in layout.bends.items():
            if m + 1 == i:
                off = off | differ(turned_bend(answer.bend(k, m), signs, k, m), expected)
        signs = signs[~off][:MOST_PATTERNS]
    return signs


def _no_longer(answer: Axes, reference: Axes, gaps: np.ndarray, bars: np.ndarray) -> np.ndarray:
    """Whether rounding in the lengths explains the gap of each sign pattern."""
    values = np.stack([answer.a, answer.d], axis=1).ravel()
    noise, sizes = ROUNDING * max(answer.longest, reference.longest), (bars ** 2).sum(axis=-1)
    change = (bars @ gaps[..., None])[..., 0] / np.maximum(sizes, FLAT ** 2)
    change[sizes <= FLAT ** 2] = 0
    return np.all(np.abs(change) <= SIXTH_DECIMAL * np.abs(values) + noise, axis=1) & (
        np.linalg.norm(gaps, axis=1) <= noise * FLAT / ROUNDING)
