"""Labels that make room for each other; kinlab/browser/labels.js does the same at every frame.

A spring draws each label to where it wants to stand, strokes and solids push it off, and no two
may overlap.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

Px = tuple[float, float]
Box = Sequence[float]  # its middle, then its width and height

_LETTER_WIDTHS = (("₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ⁰¹²³⁻′", 5.4), (" .,:;'|!ijlI()[]ft/-r·", 5.0),
                  ("mwMW@%—−", 11.6), ("ABCDEFGHKNOPQRSTUVXYZ=+<>×°θ", 9.2))
_LETTER, _LINE_HEIGHT = 8.3, 14.0
_BESIDE, _ASIDE, _END_ON, _LEADER_GAP = 3.0, 4.0, 12.0, 8.5  # px
_SPRING, _OFF_STROKE, _OFF_SOLID, _DEEPEST = 0.22, 0.5, 0.34, 12.0
_EASE = 0.5  # of a step: nobody trembles between two others
_TOUCH, _OVERLAP, _RIM, _STILL, _TINY = 1.0, 1.0, 2.0, 0.01, 1e-6
_NEW_STEPS, _AGAIN, _ROUNDS, _NEW_PX, _MOST_PX = 140, 40, 4, 3.0, 2.0
_QUIET, _PATIENCE, _SLOWER = 0.06, 90, 60  # pictures
_GAPS, _WAYS = (4.0, 12.0, 22.0, 34.0, 48.0), 8
_SPOTS = len(_GAPS) * _WAYS
_UP_RIGHT = np.sqrt(0.5) * np.array([1, -1])  # the way off a bar that one stands on


@dataclass(frozen=True)
class LabelState:
    """What the next picture has to know of a label.

    Where it stands seen from its anchor, which spot it wants, for how many pictures all have
    stood still, and where its anchor was.
    """

    x: float
    y: float
    spot: int
    age: int
    anchor: Px


@dataclass(frozen=True)
class Label:
    """Words at the tip of an arrow that comes `start` somewhere, or else at their own anchor.

    `state` is what the last picture gave them; without one they are new.
    """

    anchor: Px
    start: Px | None
    w: float
    h: float
    state: LabelState | None = None


@dataclass(frozen=True)
class Bar:
    """A stroke from a to b, or a solid with its radius."""

    a: Px
    b: Px
    radius: float = 0.0


@dataclass(frozen=True)
class Placed:
    """The middle of a label, and the line that leads to it if it stands far off."""

    x: float
    y: float
    leader: tuple[Px, Px] | None
    state: LabelState


def text_size(text: str) -> tuple[float, float]:
    """Width and height of words in bold letters of 12.5 px, by a rule that needs no page."""
    return sum(map(_letter_width, text)), _LINE_HEIGHT


def _letter_width(letter: str) -> float:
    if "\u0300" <= letter < "\u0370":  # stands on the one before
        return 0.0
    return next((width for some, width in _LETTER_WIDTHS if letter in some), _LETTER)


def place(labels: Sequence[Label], strokes: Sequence[Bar], solids: Sequence[Bar],
          fixed: Sequence[Box], size: tuple[float, float],
          steps: int = 3) -> tuple[list[Placed | None], bool]:
    """Where labels stand on a picture of this size, and whether they are still on their way.

    New labels find their places at once; others go on by `steps` steps of 2 px at most. A label
    whose anchor is outside the picture gets None. The labels' own arrows are strokes for others,
    and what is `fixed` stays where it is.
    """
    seats = [k for k, label in enumerate(labels) if _within(label.anchor, size)]
    crowd = _crowd([labels[k] for k in seats], seats, _obstacles(labels, strokes, solids), fixed,
                   size)
    fresh = np.array([labels[k].state is None for k in seats], dtype=bool)
    age = _age(crowd.labels, fresh)
    _settle_new(crowd, fresh)
    calm = min(1.0, max(0.0, (_PATIENCE - age) / _SLOWER))
    moved = _walk(crowd, ~fresh, steps, _MOST_PX * calm)
    turned = calm > 0 and moved < _QUIET and any(
        _moves(crowd, int(one), jump=False) for one in np.flatnonzero(~fresh))
    places: list[Placed | None] = [None] * len(labels)
    for one, k in enumerate(seats):
        places[k] = _placed(crowd, one, age)
    return places, bool(turned or moved >= _QUIET or fresh.any())


def _within(point: Px, size: tuple[float, float]) -> bool:
    return 0 <= point[0] <= size[0] and 0 <= point[1] <= size[1]


@dataclass
class _Bars:
    """Strokes and solids; the stroke of a label's own arrow does not push it."""

    a: np.ndarray
    b: np.ndarray
    radius: np.ndarray
    gain: np.ndarray
    owner: np.ndarray

    @cached_property
    def along(self) -> np.ndarray:
        """From one end to the other."""
        return self.b - self.a

    @cached_property
    def shares(self) -> np.ndarray:
        """What gives how far along a bar a point lies; nothing for a bar without length."""
        square = np.sum(self.along**2, axis=-1)[:, None]
        return np.where(square > _TINY, self.along / np.where(square > _TINY, square, 1), 0)


@dataclass
class _Crowd:
    """Labels on their way from `at` to `next`, wanting to be at `want`."""

    labels: list[Label]
    index: np.ndarray
    half: np.ndarray   # half the width and height of each
    bars: _Bars
    fixed: np.ndarray
    size: np.ndarray
    anchor: np.ndarray
    want: np.ndarray
    at: np.ndarray
    spot: list[int]
    next: np.ndarray = field(default_factory=lambda: np.zeros((0, 2)))


def _crowd(labels: list[Label], index: list[int], bars: _Bars, fixed: Sequence[Box],
           size: tuple[float, float]) -> _Crowd:
    anchor = np.array([label.anchor for label in labels], dtype=float).reshape(-1, 2)
    spot = [label.state.spot if label.state else 0 for label in labels]
    want = [_wanted(label, k) for label, k in zip(labels, spot)]
    stood = [(label.state.x, label.state.y) if label.state else wish
             for label, wish in zip(labels, want)]
    half = np.array([(label.w / 2, label.h / 2) for label in labels]).reshape(-1, 2)
    boxes = np.array([list(box) for box in fixed], dtype=float).reshape(-1, 4)
    return _Crowd(labels, np.array(index), half, bars, boxes, np.array(size, dtype=float), anchor,
                  anchor + np.reshape(want, (-1, 2)), anchor + np.reshape(stood, (-1, 2)), spot)


def _wanted(label: Label, spot: int) -> tuple[float, float]:
    """Where a label wants to stand, seen from its anchor.

    Spot 0 is beside the arrowhead, the others lie round it in eight directions, ever farther out.
    """
    if spot:
        return _around(label, (spot - 1) % _WAYS, _GAPS[(spot - 1) // _WAYS])
    if label.start is None:
        return 0.0, 0.0
    dx, dy = label.anchor[0] - label.start[0], label.anchor[1] - label.start[1]
    d = float(np.hypot(dx, dy))
    share = min(1.0, d / _END_ON)
    x, y = (dx / d, dy / d) if d > _TINY else (0.0, 0.0)
    far, rest = share * (_extent(label, x, y) + _BESIDE), 1 - share  # end-on: up, right
    return (far * x - share * _ASIDE * y + rest * 10, far * y + share * _ASIDE * x - rest * 9)


def _around(label: Label, way: int, gap: float) -> tuple[float, float]:
    x, y = float(np.cos(2 * np.pi * way / _WAYS)), float(np.sin(2 * np.pi * way / _WAYS))
    far = _extent(label, x, y) + gap
    return far * x, far * y


def _extent(label: Label, x: float, y: float) -> float:
    """How far a box reaches from its middle in a direction."""
    return (abs(x) * label.w + abs(y) * label.h) / 2


def _obstacles(labels: Sequence[Label], strokes: Sequence[Bar], solids: Sequence[Bar]) -> _Bars:
    own = [(k, Bar(label.start, label.anchor)) for k, label in enumerate(labels)
           if label.start is not None]
    bars = [bar for _, bar in own] + [*strokes, *solids]
    gain = [_OFF_STROKE] * (len(own) + len(strokes)) + [_OFF_SOLID] * len(solids)
    owner = [k for k, _ in own] + [-1] * (len(strokes) + len(solids))
    a, b = (np.array([ends(bar) for bar in bars], dtype=float).reshape(-1, 2)
            for ends in (lambda bar: bar.a, lambda bar: bar.b))
    return _Bars(a, b, np.array([bar.radius for bar in bars]), np.array(gain), np.array(owner))


def _age(labels: list[Label], fresh: np.ndarray) -> int:
    """For how many pictures no anchor has moved; a new label begins anew."""
    states = [label.state for label in labels if label.state is not None]
    if fresh.any() or not all(_stands(label) for label in labels):
        return 0
    return 1 + max([state.age for state in states], default=0)


def _stands(label: Label) -> bool:
    return label.state is not None and all(
        abs(was - now) < 0.01 for was, now in zip(label.state.anchor, label.anchor))


def _settle_new(crowd: _Crowd, fresh: np.ndarray) -> None:
    """Places for new labels: a long walk, then other spots for those that still overlap."""
    if not fresh.any():
        return
    _walk(crowd, fresh, _NEW_STEPS, _NEW_PX)
    for _ in range(_ROUNDS):
        if not sum(_moves(crowd, int(one), jump=True) for one in np.flatnonzero(fresh)):
            return
        _walk(crowd, fresh, _AGAIN, _NEW_PX)


def _walk(crowd: _Crowd, free: np.ndarray, steps: int, most: float) -> float:
    """Go some steps, each at most so far; gives how far the last one went."""
    moved = 0.0
    for _ in range(steps if free.any() else 0):
        crowd.next = crowd.at + free[:, None] * _cut(_drawn(crowd), most)
        for _ in range(2):
            crowd.next = crowd.next + free[:, None] * _parted(crowd, free)
        at = _kept(crowd, crowd.at + _cut(crowd.next - crowd.at, most, _EASE))
        at = np.where(free[:, None], at, crowd.at)
        moved = float(np.hypot(*(at - crowd.at).T).max())
        crowd.at = at
        if moved <= _STILL:
            break
    return moved


def _cut(moves: np.ndarray, most: float, ease: float = 1.0) -> np.ndarray:
    far = np.hypot(*moves.T)
    return moves * np.minimum(ease, most / np.where(far > 0, far, 1))[:, None]


def _drawn(crowd: _Crowd) -> np.ndarray:
    push, way = _off_bars(crowd.half, crowd.at, crowd.bars, crowd.index)
    return _SPRING * (crowd.want - crowd.at) + np.einsum("ij,ijk->ik", push, way)


def _off_bars(half: np.ndarray, at: np.ndarray, bars: _Bars,
              index: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """How hard each bar pushes each label, and which way."""
    since = at[:, None] - bars.a
    share = np.minimum(1, np.maximum(0, np.einsum("ijk,jk->ij", since, bars.shares)))
    away = since - share[..., None] * bars.along
    d = np.sqrt(np.einsum("ijk,ijk->ij", away, away))
    on_it = d <= _TINY
    way = away / np.where(on_it, 1, d)[..., None]
    way[on_it] = _UP_RIGHT
    deep = bars.radius + _TOUCH + np.einsum("ijk,ik->ij", np.abs(way), half) - d
    push = bars.gain * np.minimum(np.maximum(deep, 0), _DEEPEST)
    return np.where(bars.owner == index[:, None], 0, push), way


def _parted(crowd: _Crowd, free: np.ndarray) -> np.ndarray:
    """The way of each out of those it overlaps, half of it each, and out of what is fixed."""
    count = np.arange(len(crowd.next))
    order = np.sign(count[:, None] - count)
    ways = _parting(crowd.half, crowd.next, crowd.half, crowd.next, order)
    ways *= np.where(free, 0.5, 1.0)[:, None]
    boxes = _parting(crowd.half, crowd.next, crowd.fixed[:, 2:] / 2, crowd.fixed[:, :2],
                     np.ones((1, 1)))
    return ways.sum(axis=1) + boxes.sum(axis=1)


def _parting(half: np.ndarray, at: np.ndarray, halves: np.ndarray, middles: np.ndarray,
             order: np.ndarray) -> np.ndarray:
    """The shortest ways of boxes out of others.

    `order` decides between two in one place; where it is zero, a box meets itself.
    """
    away = at[:, None] - middles
    deep = half[:, None] + halves + _TOUCH - np.abs(away)
    ways = np.zeros(deep.shape)
    i, j = ((deep[..., 0] > 0) & (deep[..., 1] > 0) & (order != 0)).nonzero()
    if not len(i):
        return ways  # as most of the time
    across, up = deep[i, j].T
    axis = np.where(across < up - _TINY, 0, 1)
    off = away[i, j, axis]
    side = np.where(np.broadcast_to(order, deep.shape[:2])[i, j] < 0, -1, 1)
    ways[i, j, axis] = deep[i, j, axis] * np.where(np.abs(off) > _TINY, np.sign(off), side)
    return ways


def _kept(crowd: _Crowd, at: np.ndarray) -> np.ndarray:
    half = np.minimum(crowd.half + _RIM, crowd.size / 2)
    return np.clip(at, half, crowd.size - half)


def _moves(crowd: _Crowd, one: int, *, jump: bool) -> bool:
    """Whether a label takes another spot.

    One that overlaps takes the best of all, one that stands aside goes back to its usual one when
    that is free. A new label jumps there, another walks.
    """
    spot, now = crowd.spot[one], crowd.at[one]
    crowded = _clash(crowd, one, now[None])[0] > _OVERLAP
    if not crowded and (jump or not spot):
        return False
    spots = _kept_spots(crowd, one, _SPOTS if crowded else 0)
    best = _costs(crowd, one, now[None])[0] - (0.5 if crowded else 10)
    for k, price in enumerate(_costs(crowd, one, spots)):
        if k != spot and price < best - _TINY:
            best, crowd.spot[one], crowd.want[one] = price, k, spots[k]
    if jump and crowd.spot[one] != spot:
        crowd.at[one] = crowd.want[one]
    return crowd.spot[one] != spot


def _kept_spots(crowd: _Crowd, one: int, last: int) -> np.ndarray:
    label = crowd.labels[one]
    spots = crowd.anchor[one] + [_wanted(label, k) for k in range(last + 1)]
    half = np.minimum(crowd.half[one] + _RIM, crowd.size / 2)
    return np.clip(spots, half, crowd.size - half)


def _clash(crowd: _Crowd, one: int, spots: np.ndarray) -> np.ndarray:
    """How deep a label would lie in others and in what is fixed, added up, at each spot."""
    others = np.delete(np.hstack([crowd.at, crowd.half]), one, axis=0)
    fixed = crowd.fixed / [1, 1, 2, 2]
    boxes = np.vstack([others, fixed])
    ways = _parting(crowd.half[one][None], spots, boxes[:, 2:], boxes[:, :2], np.ones((1, 1)))
    return np.maximum(0, np.abs(ways).sum(axis=-1) - _TOUCH).sum(axis=-1)


def _costs(crowd: _Crowd, one: int, spots: np.ndarray) -> np.ndarray:
    deep = _clash(crowd, one, spots)
    push, _ = _off_bars(crowd.half[one][None], spots, crowd.bars, crowd.index[one:one + 1])
    far = np.hypot(*(spots - crowd.anchor[one]).T)
    return np.where(deep > 0, 20 + 10 * deep, 0) + 3 * push.sum(axis=-1) + 0.5 * far


def _placed(crowd: _Crowd, one: int, age: int) -> Placed:
    label, (x, y) = crowd.labels[one], crowd.at[one].tolist()
    dx, dy = x - label.anchor[0], y - label.anchor[1]
    return Placed(x, y, _leader(label, dx, dy),
                  LabelState(dx, dy, crowd.spot[one], age, label.anchor))


def _leader(label: Label, dx: float, dy: float) -> tuple[Px, Px] | None:
    """The line from an anchor to the rim of words that stand far from it."""
    wide, high = max(label.w, _TINY), max(label.h, _TINY)
    (x, y), out = label.anchor, max(2 * abs(dx) / wide, 2 * abs(dy) / high)
    d = float(np.hypot(dx, dy))
    if out <= 1 or d * (1 - 1 / out) <= _LEADER_GAP:
        return None
    start, end = 2 / d, 1 - 1 / out
    return (x + start * dx, y + start * dy), (x + end * dx, y + end * dy)
