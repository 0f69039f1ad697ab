"""The solids of an arm: a base, joints along their axes, links between them, a gripper.

All sizes are multiples of the radius t of a joint. A joint that turns is a drum on its axis; one
that slides is a sleeve with a rod of constant length in it, or, where the link before it runs the
same way, the outer tube of a telescope. A link leads from its joint through the origins of its
frames to the next joint; its tubes end at the skin of what they meet, with balls in the corners.
"""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..arms.motions import ROTATE, TRANSLATE
from .hand import GRIP, Hand, flanged_hand, free_hand
from .layout import Layout
from .readings import Point
from .scene import BALL, BOX, TUBE, Item, at
from .vectors import unit

_AXES = np.eye(3)
HALF, SKIN = 1.02, 0.93      # of a drum: half its height, and where links beside it begin
_SLEEVE, _WIDE = 1.9, 1.15   # half length and half width of a sleeve
_OUTER, _SLIM = 1.2, 1.05    # the same of a telescope's outer tube
_ROD = 0.6             # half width of a rod
THIN, TAPER = 0.7, 0.56  # radius of a link where it begins and where it ends
_STEM = 1.45           # radius of the column on the base
PLATE = 0.32           # height of the base
_FLANGE = 0.3          # half the height of a joint that turns a hand right before the wrist
_SHORT = 3.6           # nearer than this to its wrist, a tool has no room for joint and gripper
_UPRIGHT = 0.9         # cosine: nearer than this to an axis counts as along it


@dataclass(frozen=True)
class Place:
    """Where along its axis a joint's body is drawn, and whether it is a telescope's outer tube or
    only the flange of a hand.
    """

    along: float
    telescope: bool = False
    flange: bool = False


class Bodies:
    """The solids of one arm, and the height of the ground that it stands on."""

    def __init__(self, layout: Layout) -> None:
        self.layout, self.t = layout, layout.thick
        self.taken: list[np.ndarray] = []
        self.places = [self._place(i) for i in range(layout.arm.n)]
        self.ground = self._ground()
        self.hand = self._hand()

    def items(self) -> list[Item]:
        """Base, links, joints and gripper."""
        n = self.layout.arm.n
        parts = [self._base(), *(part for i in range(-1, n) for part in self._link(i)),
                 *(self._joint(i) for i in range(n)), *self._gripper()]
        return parts

    def crowded(self, frame: int) -> bool:
        """Whether a joint's body lies about the origin of a frame, at home."""
        return self._covered(self.layout.home[frame][:3, 3])

    # ---- where joints are drawn ----

    def _place(self, i: int) -> Place:
        if self._telescopes(i):
            self.taken.append(self._point(i, -3.1 * self.t))
            return Place(-3.1 * self.t, True)
        if i + 1 == self.layout.arm.n and (flange := self._flange(i)):
            return flange
        first, step = self._wish(i), 2.3 * self.t * self._forward(i)
        for place in first + step * np.array([0, 1, -1, 2, -2, 3, -3]):
            if all(np.linalg.norm(self._point(i, place) - other) > 2 * self.t
                   for other in self.taken):
                break
        self.taken.append(self._point(i, place))
        return Place(float(place))

    def _point(self, i: int, along: float) -> np.ndarray:
        """A point of joint i's axis at home, in the room."""
        frame = self.layout.home[self.layout.joints[i]]
        return frame[:3, 3] + along * frame[:3, 2]

    def _wish(self, i: int) -> float:
        """Part of the way along a long offset, or up to a first joint's frame that is high; below
        the frame where that stands on the ground.
        """
        long = self._offset(i)
        if abs(long) > 4.5 * self.t:
            return 0.35 * long
        upright = i == 0 and self.layout.home[self.layout.joints[0]][2, 2] > _UPRIGHT
        if not upright or self.layout.slides(0):
            return 0.0
        high = float(self._point(0, 0)[2])
        if high > 4.5 * self.t:
            return -0.65 * high
        return -2.3 * self.t if high < 2.3 * self.t else 0.0

    def _flange(self, i: int) -> Place | None:
        """The flange of a last joint that turns a hand in the midst of a wrist: another joint is
        in its place, and the tool is on its axis, so near that a whole drum would cover the hand.
        """
        frame, tip = self.layout.home[self.layout.joints[i]], self.layout.home[-1][:3, 3]
        aside = np.linalg.norm(np.cross(frame[:3, 2], tip - frame[:3, 3]))
        if self.layout.slides(i) or aside > 1e-3 * self.t or abs(self._along(i)) > _SHORT * self.t:
            return None
        along = (-1 if self._along(i) < -1e-3 * self.t else 1) * (HALF + _FLANGE) * self.t
        point = self._point(i, along)
        away = [float(np.linalg.norm(point - other)) / self.t for other in self.taken]
        if not self._covered(frame[:3, 3]) or min(away) < HALF:
            return None
        self.taken.append(point)
        return Place(along, flange=True)

    def _covered(self, point: np.ndarray) -> bool:
        """Whether a joint's body lies about a point, at home."""
        return any(np.linalg.norm(point - place) < 0.5 * self.t for place in self.taken)

    def _offset(self, i: int) -> float:
        """The constant slide along the axis of a joint that turns, right after it."""
        following = self.layout.motions[self.layout.joints[i] + 1:][:1]
        if self.layout.slides(i) or not following:
            return 0.0
        (motion,) = following
        constant = motion.kind == TRANSLATE and motion.axis == 2 and motion.joint is None
        return motion.amount if constant else 0.0

    def _forward(self, i: int) -> int:
        """The side of the axis on which the rest of the arm lies: 1 or -1."""
        return 1 if self._along(i) > self.t else -1

    def _along(self, i: int) -> float:
        """How far along the axis of a joint the tool is."""
        frame = self.layout.home[self.layout.joints[i]]
        return float(frame[:3, 2] @ (self.layout.home[-1][:3, 3] - frame[:3, 3]))

    def _telescopes(self, i: int) -> bool:
        """Whether a joint slides out of the link before it, or straight up out of the base."""
        if not self.layout.slides(i) or self.layout.range(i)[0] < 0:
            return False
        if i == 0:
            return bool(self.layout.home[self.layout.joints[0]][2, 2] > _UPRIGHT)
        before = [motion for motion in self.layout.motions[:self.layout.joints[i]]
                  if motion.kind != ROTATE or motion.axis != 2]
        return bool(before) and before[-1].kind == TRANSLATE and before[-1].axis == 2

    def _ground(self) -> float:
        """Height of the ground: 0, or lower where the first joint needs room above it."""
        frame = self.layout.home[self.layout.joints[0]]
        tall = HALF if not self.layout.slides(0) else _OUTER if self.places[0].telescope \
            else _SLEEVE
        upright = abs(frame[2, 2])
        lowest = self.taken[0][2] - self.t * (tall * upright + 1.1 * (1 - upright))
        return 0.0 if lowest > 0.5 * self.t else float(lowest - 0.58 * self.t)

    def _hand(self) -> Hand:
        along = self.places[-1].along
        if not self.places[-1].flange:
            return free_hand(self.layout)
        face = along + np.sign(along) * _FLANGE * self.t
        return flanged_hand(self.layout, float(face), self._along(self.layout.arm.n - 1))

    # ---- base, links, gripper ----

    def _base(self) -> Item:
        low, high = self.ground, self.ground + PLATE * self.t
        return self._item("base", TUBE, "base", at(0, (0, 0, low), (0, 0, high)), 0,
                          (2.2 * self.t, 2.1 * self.t))

    def _link(self, i: int) -> Iterator[Item]:
        """The link after joint i (from 0; the base's for -1): rods, then tubes and balls."""
        frame, corners = self._corners(i)
        if i >= 0 and self.layout.slides(i):
            yield from self._rods(i, frame, bare=len(corners) == 1)
        for k, (a, b) in enumerate(pairwise(corners)):
            first, last = k == 0, k == len(corners) - 2
            if not first:
                yield self._item(f"corner-{i + 1}-{k}", BALL, "steel", at(frame, a), i + 1,
                                 (0.72 * self.t,))
            yield from self._limb(i, frame, k, (a, b), first, last)

    def _corners(self, i: int) -> tuple[int, list[np.ndarray]]:
        """The frame that carries a link, and the way that the link takes in it."""
        home, joints = self.layout.home, self.layout.joints
        end = i + 1 == self.layout.arm.n
        frame = 0 if i < 0 else joints[i] + 1
        stop = self.layout.last if end else joints[i + 1]
        start = (np.array([0, 0, self.ground + PLATE * self.t]) if i < 0 else
                 self.places[i].along * (0 if self.layout.slides(i) else 1) * _AXES[2])
        way = [start, *(self._seen(frame, home[k][:3, 3]) for k in range(frame, stop + 1))]
        if end and self.places[i].flange:
            tip = home[-1][:3, 3] + home[-1][:3, :3] @ self.hand.tip
            return frame, [start, self._seen(frame, tip)]
        if not end:
            way.append(self._seen(frame, self._point(i + 1, self.places[i + 1].along)))
        return frame, _straightened(way, 1e-3 * self.t)

    def _seen(self, frame: int, point: np.ndarray) -> np.ndarray:
        """A point of the room as a frame sees it at home."""
        pose = self.layout.home[frame]
        return pose[:3, :3].T @ (point - pose[:3, 3])

    def _limb(self, i: int, frame: int, k: int, ends: tuple[np.ndarray, np.ndarray],
              first: bool, last: bool) -> Iterator[Item]:
        """One straight tube of a link, cut off at the skin of what it meets."""
        a, b = ends
        length = float(np.linalg.norm(b - a))
        way, t = (b - a) / (length or 1.0), self.t
        skip = (0 if i < 0 or self.layout.slides(i) else self._skin(i, way[2])) if first \
            else 0.35 * t
        stop = self._end(i, frame, way) if last else 0.35 * t
        if length - skip - stop < 0.04 * t:
            return
        begin, end = (_STEM, 1.0) if i < 0 and first else (THIN, TAPER if last else THIN)
        yield self._item(f"link-{i + 1}-{k}", TUBE, "steel",
                         at(frame, a + skip * way, b - stop * way), i + 1, (begin * t, end * t))

    def _end(self, i: int, frame: int, way: np.ndarray) -> float:
        """How far before its end a link stops: at the next joint, or at the gripper."""
        if i + 1 == self.layout.arm.n:
            return (GRIP + 0.14) * self.hand.size
        home, joint = self.layout.home, self.layout.joints[i + 1]
        axis = home[frame][:3, :3].T @ home[joint][:3, 2]
        return self._skin(i + 1, float(way @ axis))

    def _skin(self, i: int, cosine: float) -> float:
        """Distance from the middle of a joint to its surface, along a link."""
        straight = abs(cosine) > _UPRIGHT
        if self.layout.slides(i):
            half = _OUTER if self.places[i].telescope else 1.8
            return (half if straight else 1.15) * self.t
        return (self._half(i) if straight else SKIN) * self.t

    def _half(self, i: int) -> float:
        return _FLANGE if self.places[i].flange else HALF

    def _rods(self, i: int, frame: int, *, bare: bool) -> Iterator[Item]:
        """A rod of constant length through the sleeve: what stands out ahead and behind.

        It ends where the arm goes on, for a `bare` one at the gripper, or so far beyond the sleeve
        that it never slips out.
        """
        (low, high), place, t = self.layout.range(i), self.places[i], self.t
        half = (_OUTER if place.telescope else _SLEEVE) * t
        hand = (0.5 - GRIP) * t if bare and i + 1 == self.layout.arm.n else 0.0
        ahead = 2.5 * t - low if low < 0 else hand
        behind = -high - 2.5 * t if high > 0 else -hand
        yield self._rod(f"rod-{i + 1}", i, (frame - 1, place.along + half), (frame, ahead))
        if not place.telescope:
            yield self._rod(f"tail-{i + 1}", i, (frame, behind), (frame - 1, place.along - half))

    def _rod(self, gid: str, i: int, a: tuple[int, float], b: tuple[int, float]) -> Item:
        s = _ROD * self.t
        corners = ((a, (0, 0)), (b, (0, 0)), (a, (s, 0)), (a, (0, s)))
        points: tuple[Point, ...] = tuple((frame, x, y, z) for (frame, z), (x, y) in corners)
        return self._item(gid, BOX, "steel", points, i + 1, (1.0,))

    def _joint(self, i: int) -> Item:
        place, t, frame = self.places[i], self.t, self.layout.joints[i]
        if self.layout.slides(i):
            half, wide = (_OUTER, _SLIM) if place.telescope else (_SLEEVE, _WIDE)
            low, high = place.along - half * t, place.along + half * t
            points = at(frame, (0, 0, low), (0, 0, high), (wide * t, 0, low), (0, wide * t, low))
            return self._item(f"joint-{i + 1}", BOX, "sleeve", points, i, joint=i + 1)
        low, high = place.along - self._half(i) * t, place.along + self._half(i) * t
        return self._item(f"joint-{i + 1}", TUBE, "iron", at(frame + 1, (0, 0, low), (0, 0, high)),
                          i + 1, (t, t), i + 1)

    def _gripper(self) -> Iterator[Item]:
        for gid, corners in self.hand.bars():
            yield self._item(gid, BOX, "grip", at(self.layout.last, *corners),
                             self.layout.arm.n)

    def _item(self, gid: str, shape: str, style: str, points: tuple[Point, ...], link: int,
              size: tuple[float, ...] = (), joint: int | None = None) -> Item:
        part = {"iron": "joint", "sleeve": "joint", "steel": "link", "grip": "gripper"}
        return Item(gid, shape, style, points, size=size,
                    part=part.get(style, style), joint=joint, link=link)


def _straightened(way: list[np.ndarray], near: float) -> list[np.ndarray]:
    """The corners of a way: no point twice, none on the line through those beside it."""
    kept = way[:1]
    for point in way[1:]:
        if np.linalg.norm(point - kept[-1]) > near:
            kept.append(point)
    corners = kept[:1]
    for before, point, after in zip(kept, kept[1:], kept[2:]):
        if np.linalg.norm(np.cross(unit(after - point), unit(point - before))) > 1e-3:
            corners.append(point)
    return corners + kept[1:][-1:]

