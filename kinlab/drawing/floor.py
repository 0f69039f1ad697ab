"""The ground as points of the picture: a grid with numbers, shadows, and lines dropped on it.

kinlab/browser/floor.js does the same.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Decimal
from typing import NamedTuple

import numpy as np

from ..arms.motions import Numbers
from .camera import Lens
from .labels import Box, text_size
from .scene import BALL, TUBE, Floor
from .solids import circle, hull

# How strongly the floor is drawn, so far from its middle: shares of the radius, opacities.
FADE = ((0.0, 1.0), (0.55, 0.8), (1.0, 0.0))

_MOST_LINES, _RIM_SIDES, _DISC_SIDES, _RING_SIDES, _FLATTEST = 200, 48, 16, 18, 0.2
_RING, _NUMBER_GAP, _BETWEEN, _PALEST, _SHORTEST, _INSIDE = 5.0, 5.0, 6.0, 0.3, 1e-3, 2.0  # px
_FOOT_DOWN, _FOOT_ASIDE, _NEAR_MIDDLE, _HIGH_ASIDE, _LONG = 15.0, 44.0, 150.0, 6.0, 40.0   # px
_EVERY = (1, 2, 5, 10, 20, 50, 100)
_SQUARE = np.array([[1, 1], [1, -1], [-1, -1], [-1, 1]])

Size = Sequence[float]


class Words(NamedTuple):
    """Text with its middle, width and height."""

    text: str
    place: tuple[float, float]
    w: float
    h: float

    @property
    def box(self) -> Box:
        """What the words cover."""
        return *self.place, self.w, self.h


class RulerNumber(NamedTuple):
    """A number beside a ruler."""

    axis: str
    words: Words
    opacity: float


class Fade(NamedTuple):
    """A circle, flattened, towards whose rim the floor fades."""

    center: tuple[float, float]
    radius: float
    squeeze: float


@dataclass(frozen=True, eq=False)
class Ground:
    """What stands on the floor and is seen through a lens.

    `rim` is the outline of all of it, rulers are lines along x and y, and `below` says that the
    viewer looks at it from underneath.
    """

    below: bool
    grid: np.ndarray   # of each line its ends
    rulers: np.ndarray
    rim: np.ndarray
    numbers: list[RulerNumber]
    fade: Fade


class Solid(NamedTuple):
    """A tube, ball or box with its points in the room and its size, as its item tells of it."""

    shape: str
    ends: np.ndarray
    size: Sequence[float]


@dataclass(frozen=True, eq=False)
class Drop:
    """A line from a point to the floor, with its ends in the room and on the picture.

    With a ring round its foot, guides from there to the rulers, and at most two texts: where the
    foot stands, and how high the point.
    """

    ends: np.ndarray
    line: np.ndarray
    foot: np.ndarray
    guides: np.ndarray
    texts: list[Words]


def number(value: float, decimals: int) -> str:
    """A number with so many decimals, a true minus sign and no negative zero.

    A half is rounded away from zero, as the browser does.
    """
    text = f"{Decimal(value).quantize(Decimal(1).scaleb(-decimals), ROUND_HALF_UP):f}"
    return text.replace("-", "−" if float(text) else "")


def _laid(flat: np.ndarray, height: float) -> np.ndarray:
    """Points of the floor with their height."""
    return np.concatenate([flat, np.full((*flat.shape[:-1], 1), height)], axis=-1)


def _seen(lens: Lens, points: np.ndarray) -> np.ndarray:
    return lens.see(points)[..., :2]


# ---- grid and numbers ----

def ground(floor: Floor, lens: Lens, size: Size) -> Ground:
    """The floor as seen through a lens, on a picture of this size."""
    middle = np.array([0.0, 0.0, floor.height])
    fade, below = _fade(floor, lens), bool(lens.eye(middle)[2] < 0)
    x, y = (_numbers(floor, lens, size, axis, fade, below) for axis in "xy")
    y = [one for one in give_way(y, [one.words.box for one in x]) if one.opacity > 0]
    at = floor.step * np.array(_marks(floor))
    grid = np.concatenate([_lines(floor, 1, at), _lines(floor, 0, at)])
    rulers = np.concatenate([_lines(floor, k, np.zeros(1)) for k in (0, 1)])
    rim = _laid(floor.reach * circle(_RIM_SIDES), floor.height)
    return Ground(below, _seen(lens, grid), _seen(lens, rulers), _seen(lens, rim), x + y, fade)


def _marks(floor: Floor) -> list[int]:
    """Numbers of the lines on either side of the middle."""
    count = min(_MOST_LINES, int(floor.reach / floor.step + 1e-9))
    return [k for k in range(-count, count + 1) if k]


def _lines(floor: Floor, k: int, at: np.ndarray) -> np.ndarray:
    """Lines across the floor: along x at values of y, or for k = 1 along y at values of x."""
    half = np.sqrt(np.maximum(0, floor.reach**2 - at**2))
    along, across = np.stack([-half, half], axis=-1), np.stack([at, at], axis=-1)
    return _laid(np.stack([across, along] if k else [along, across], axis=-1), floor.height)


def _fade(floor: Floor, lens: Lens) -> Fade:
    right, down, large = map(float, lens.see(np.array([0.0, 0.0, floor.height])))
    steep = abs(float(lens.turn(np.array([0.0, 0.0, 1.0]))[2]))
    return Fade((right, down), floor.reach * lens.scale * large, max(_FLATTEST, steep))


def strength(fade: Fade, points: np.ndarray) -> np.ndarray:
    """How strongly the floor is drawn at points of the picture, from 0 to 1."""
    away = (np.asarray(points) - fade.center) / [1, fade.squeeze]
    return np.interp(np.hypot(away[..., 0], away[..., 1]) / fade.radius, *np.transpose(FADE))


def faded(fade: Fade, lines: np.ndarray, length: float = 16.0) -> tuple[np.ndarray, np.ndarray]:
    """Lines cut into pieces no longer than so many px, and how strongly each is drawn.

    For whoever has no gradients: ends of the pieces, shape (n, 2, 2), and n opacities.
    """
    cut = [_pieces(line, length) for line in lines]
    pieces = np.concatenate(cut) if cut else np.zeros((0, 2, 2))
    opacity = strength(fade, pieces.mean(axis=1))
    return pieces[opacity > 0], opacity[opacity > 0]


def _pieces(line: np.ndarray, length: float) -> np.ndarray:
    start, end = line
    count = max(1, int(np.ceil(np.hypot(*(end - start)) / length)))
    points = start + np.linspace(0, 1, count + 1)[:, None] * (end - start)
    return np.stack([points[:-1], points[1:]], axis=1)


def give_way(numbers: Sequence[RulerNumber], boxes: Sequence[Box]) -> list[RulerNumber]:
    """Numbers of which those that a box covers are not to be seen."""
    return [one._replace(opacity=0.0) if any(_covers(box, one.words) for box in boxes) else one
            for one in numbers]


def _covers(box: Box, words: Words) -> bool:
    (x, y, w, h), (u, v) = box, words.place
    return 2 * abs(x - u) < w + words.w and 2 * abs(y - v) < h + words.h


def _numbers(floor: Floor, lens: Lens, size: Size, axis: str, fade: Fade,
             below: bool) -> list[RulerNumber]:
    """Numbers beside a ruler on the viewer's side: as many as have room, paler farther out."""
    marks, direction = _marks(floor), np.array([axis == "x", axis == "y"], dtype=float)
    points = _seen(lens, _laid(floor.step * np.outer([0, 1, *marks], direction), floor.height))
    along = points[1] - points[0]
    gap = float(np.hypot(*along))
    if gap < _SHORTEST or not marks:
        return []
    way = (float(along[0] / gap), float(along[1] / gap))
    side, every = _side(way, below), _spacing(floor, way, gap, marks[0])
    numbers, digits = [], _decimals(floor.step)
    for i, point, opacity in zip(marks, points[2:], strength(fade, points[2:])):
        words = _beside(_marked(i * floor.step, digits), point, side)
        if i % every == 0 and opacity >= _PALEST and _fits(words, size):
            numbers.append(RulerNumber(axis, words, float(opacity)))
    return numbers


def _side(way: tuple[float, float], below: bool) -> tuple[float, float]:
    """The direction to the viewer's side of a ruler.

    Down, or up if he looks from below; to the left of one that goes straight up.
    """
    x, y = way
    turned = (-x if below else x) < 0 if abs(x) > 1e-6 else y < 0
    return (y, -x) if turned else (-y, x)


def _spacing(floor: Floor, way: tuple[float, float], gap: float, last: int) -> float:
    """Every which line has a number."""
    for every in _EVERY:
        w, h = text_size(number(last * floor.step, _decimals(every * floor.step)))
        if every * gap * abs(way[0]) >= w + _BETWEEN or every * gap * abs(way[1]) >= h + 2:
            return every
    return np.inf


def _beside(text: str, point: np.ndarray, side: tuple[float, float]) -> Words:
    (x, y), (w, h) = side, text_size(text)
    far = (abs(x) * w + abs(y) * h) / 2 + _NUMBER_GAP
    return Words(text, (float(point[0]) + far * x, float(point[1]) + far * y), w, h)


def _fits(words: Words, size: Size) -> bool:
    return all(middle - length / 2 >= _INSIDE and middle + length / 2 <= room - _INSIDE
               for middle, length, room in zip(words.place, (words.w, words.h), size))


def _decimals(step: float) -> int:
    """Decimals of a ruler's step."""
    return next((k for k in range(9) if abs(float(f"{step:.{k}f}") - step) <= 1e-9 * step), 9)


def _marked(value: float, digits: int) -> str:
    text = number(value, digits)
    return text.rstrip("0").rstrip(".") if digits else text


# ---- shadows ----

def shadow(floor: Floor, lens: Lens, solids: Sequence[Solid]) -> list[np.ndarray]:
    """The outline of every solid's shadow, straight under it."""
    return [hull(_seen(lens, _laid(_casting(solid), floor.height))) for solid in solids]


def _casting(solid: Solid) -> np.ndarray:
    """Points, seen from above, whose shadows' outline is that of the solid."""
    ends = np.asarray(solid.ends, dtype=float)
    if solid.shape == BALL:
        return _disc(ends[0], solid.size[0], np.array([0.0, 0.0, 1.0]))
    a, b, *sides = ends
    if solid.shape == TUBE:
        return np.concatenate([_disc(end, r, b - a) for end, r in zip((a, b), solid.size)])
    corners = _SQUARE @ (np.array(sides) - a)
    return np.concatenate([a + corners, b + corners])[:, :2]


def _disc(middle: np.ndarray, radius: float, direction: np.ndarray) -> np.ndarray:
    """A disc at right angles to a direction, seen from above."""
    flat, length = np.hypot(*direction[:2]), np.linalg.norm(direction)
    u, v = direction[:2] / flat if flat > 1e-9 * length else (1.0, 0.0)
    thin = direction[2] / length if length else 1.0
    turned = np.array([[thin * u, thin * v], [-v, u]])
    return middle[:2] + radius * circle(_DISC_SIDES) @ turned


# ---- lines dropped on the floor ----

def drop(floor: Floor, lens: Lens, size: Size, point: Numbers) -> Drop:
    """The line dropped on the floor from a point of the room."""
    x, y, z = map(float, point)
    ends = np.array([[x, y, z], [x, y, floor.height]])
    line = _seen(lens, ends)
    far = _seen(lens, _laid(np.array([[x, 0.0], [0.0, y], [0.0, 0.0]]), floor.height))
    ring = ends[1] + _laid(_RING / lens.scale * circle(_RING_SIDES), 0.0)
    p, q, r = (number(value, floor.decimals) for value in (x, y, z))
    texts = (_foot_words(f"({p}, {q})", line, far[2], size),
             _height_words(f"z {r}", line, far[2], size))
    return Drop(ends, line, _seen(lens, ring), np.array([[line[1], far[0]], [line[1], far[1]]]),
                [words for words in texts if words is not None])


def _foot_words(text: str, line: np.ndarray, origin: np.ndarray, size: Size) -> Words | None:
    """Below the foot, above it if the line comes from below; near the arm's base away from it."""
    foot = line[1]
    if np.any(foot < 0) or np.any(foot > size):
        return None
    dx, dy = foot - origin
    away = np.clip(dx / 30, -1, 1) * np.clip((_NEAR_MIDDLE - np.hypot(dx, dy)) / 60, 0, 1)
    down = 1 - 2 * np.clip((line[0, 1] - foot[1] - 5) / 20, 0, 1)
    return _words(text, foot + [_FOOT_ASIDE * away, _FOOT_DOWN * down], size)


def _height_words(text: str, line: np.ndarray, origin: np.ndarray, size: Size) -> Words | None:
    """Beside the middle of a line that is long enough, on the side away from the arm's base."""
    if np.hypot(*(line[0] - line[1])) <= _LONG:
        return None
    w, y = text_size(text)[0], np.clip(line[:, 1], 0, size[1]).mean()
    side = np.clip((line[0, 0] - origin[0] + 12) / 12, -1, 1)
    return _words(text, np.array([line[:, 0].mean() + side * (w / 2 + _HIGH_ASIDE), y]), size)


def _words(text: str, place: np.ndarray, size: Size) -> Words:
    box = text_size(text)
    half = np.minimum(np.array(box) / 2 + _INSIDE, np.array(size) / 2)
    x, y = np.clip(place, half, np.array(size) - half)
    return Words(text, (float(x), float(y)), *box)


def said_once(drops: Sequence[Drop]) -> list[Words]:
    """The texts of all drops; what stands on itself, as a target's on the tool's, is said once."""
    said: list[Words] = []
    for words in (words for one in drops for words in one.texts):
        if not any(words.text == other.text and math.dist(words.place, other.place) < other.h
                   for other in said):
            said.append(words)
    return said
