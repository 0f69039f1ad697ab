"""A picture in which something is predicted: a dot or an arrow that a hand moves, and the gap to
what comes.

They are parts of the scene like all others, moved by knobs of their own behind the scene's: so both
hands draw them, and they are dragged, moved by keys and told to a screen reader as handles are.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..arms.motions import ROTATE, TRANSLATE, Numbers
from .controls import Handle, Knob
from .readings import Point
from .scene import ARROW, LINE, TEXT, Item, Scene, Step, at, origin_of

YOURS, GAP = "guess-", "gap-"  # how the names of their items begin
TIP = "tip"
_LONG = 0.45   # of an arrow, as a part of the picture's radius
_ZERO = {"z": 0, "x": 1, "y": 2}  # the axis of the room from which turns about another are counted


@dataclass(frozen=True)
class Wanted:
    """What a case wants to be set: a dot to where `of` will be, or with `about` an arrow."""

    of: str
    about: str = ""
    unit: str = ""


@dataclass(frozen=True)
class Guess:
    """A scene with what is set in it.

    Attributes
    ----------
    scene : Scene
    first : int
        Number of its first own knob: x, y and z of the mark, and how far it is turned.
    """

    scene: Scene
    first: int

    def place(self, of: str, q: Numbers) -> list[float]:
        """Where the thing `of` is, in the room, at the knobs' values `q`."""
        return _room(self.scene.frames(self._all(q)), _points(self.scene, of)[0]).tolist()

    def turn(self, of: str, about: str, q: Numbers) -> float:
        """Where the axis `of` points, in degrees about an axis of the room."""
        way, zero = self._way(of, q), _ZERO[about]
        return math.degrees(math.atan2(way[(zero + 1) % 3], way[zero]))

    def slant(self, of: str, about: str, q: Numbers) -> float:
        """How far, in degrees, the axis `of` points out of the plane in which the arrow turns."""
        way = self._way(of, q)
        out = way["xyz".index(about)] / np.linalg.norm(way)
        return math.degrees(math.asin(np.clip(out, -1, 1)))

    def _way(self, of: str, q: Numbers) -> np.ndarray:
        """From the origin of the axis `of` to its tip, in the room."""
        frames = self.scene.frames(self._all(q))
        tail, head = (_room(frames, point) for point in _points(self.scene, of)[:2])
        return head - tail

    def _all(self, q: Numbers) -> list[float]:
        return [*map(float, q), *[0.0] * (len(self.scene.knobs) - len(q))]


def with_guess(scene: Scene, wanted: Sequence[Wanted]) -> Guess:
    """The scene with the dot and the arrows that the cases want, and with the gaps.

    Raises
    ------
    ValueError
        If the scene has nothing of a name that is wanted.
    """
    first, motions = len(scene.knobs), list(scene.motions)
    if not wanted:
        return Guess(scene, first)
    for axis in range(3):
        motions.append(Step(TRANSLATE, axis, 0.0, first + axis, parent=None if axis else 0))
    mark, items, handles = len(motions), [], []
    unit = next((one.unit for one in wanted), "")
    for one in dict.fromkeys(wanted):
        points = _points(scene, one.of)
        if one.about:
            motions.append(Step(ROTATE, "xyz".index(one.about), 0.0, first + 3, parent=mark))
            arrow, gap = _arrow(scene, one, points, len(motions))
            items += [*arrow, gap]
            handles.append(Handle("your arrow", arrow[0].points[1], (first + 3,)))
        else:
            items += [*_dot(scene, mark), _gap(scene, one.of, origin_of(mark), points[0])]
            handles.append(Handle("your mark", origin_of(mark), (first, first + 1, first + 2),
                                  one.unit))
    own = list({item.gid: item for item in items}.values())
    fit = scene.fit and replace(scene.fit, points=(*scene.fit.points, origin_of(mark)))
    start = None if scene.start is None else (*scene.start, *[0.0] * 4)
    return Guess(replace(scene, motions=tuple(motions), items=(*scene.items, *own), fit=fit,
                         knobs=(*scene.knobs, *_knobs(scene, unit)), start=start,
                         poses=tuple((*pose, *[0.0] * 4) for pose in scene.poses),
                         handles=(*scene.handles, *dict.fromkeys(handles))), first)


def still(scene: Scene, names: Sequence[str]) -> Scene:
    """The scene with no more of what belongs to the guess than these."""
    return replace(scene, items=tuple(
        item for item in scene.items
        if item.gid in names or not item.gid.startswith((YOURS, GAP))))


def _knobs(scene: Scene, unit: str) -> list[Knob]:
    """Knobs of the mark: its coordinates, as far as the picture goes, and a turn."""
    places = []
    for axis, letter in enumerate("xyz"):
        low, high = (scene.center[axis] + side * 1.2 * scene.radius for side in (-1, 1))
        knob = Knob.length(f"mark_{letter}", f"your {letter}", low, high, 0.0, unit,
                           f"{letter} of your mark")
        places.append(replace(knob, quantity="mark"))
    turn = Knob.angle("mark_turn", "your arrow", -math.pi, math.pi, 0.0, "turn of your arrow")
    return [*places, replace(turn, quantity="mark")]


def _dot(scene: Scene, mark: int) -> list[Item]:
    place = at(mark, (0, 0, 0), (1e-3 * scene.radius,) * 3)
    return [Item(f"{YOURS}dot", LINE, "guess", place, body=_body(scene), lift=4 * scene.radius,
                 part="guess"),
            Item(f"{YOURS}dot-name", TEXT, "ink", (place[0], place[0]), text="you", part="guess")]


def _arrow(scene: Scene, one: Wanted, points: tuple[Point, ...],
           frame: int) -> tuple[list[Item], Item]:
    """The arrow, as long as the axis if that has a length; its name; the gap between both tips."""
    axis = np.subtract(points[1][1:], points[0][1:])
    long = float(np.linalg.norm(axis))
    drawn = any(item.gid == one.of and item.shape == ARROW for item in scene.items)
    length = long if drawn else _LONG * scene.radius
    tip = at(frame, length * np.eye(3)[_ZERO[one.about]])[0]
    end = (points[0][0], *(np.array(points[0][1:]) + axis / long * length))
    name = f"{YOURS}arrow-{one.about}"
    items = [Item(name, ARROW, "vector", (origin_of(frame), tip), body=_body(scene),
                  lift=4 * scene.radius, part="guess"),
             Item(f"{name}-name", TEXT, "ink", (tip, origin_of(frame)), text="you", part="guess")]
    return items, _gap(scene, one.of, tip, end)


def _gap(scene: Scene, of: str, yours: Point, there: Point) -> Item:
    return Item(f"{GAP}{of}", LINE, "miss", (yours, there), body=_body(scene),
                lift=4 * scene.radius, part="gap")


def _body(scene: Scene) -> int:
    return 1 + max((item.body for item in scene.items), default=-1)


def _points(scene: Scene, of: str) -> tuple[Point, ...]:
    if of == TIP:
        return (origin_of(scene.tip),)
    found = next((item.points for item in scene.items if item.gid == of), None)
    if found is None:
        raise ValueError(f"view: {scene.name!r} has nothing called {of!r}, of which the question "
                         "is; hand over the view of its lesson, or none")
    return found


def _room(frames: np.ndarray, point: Point) -> np.ndarray:
    return (frames[point[0]] @ (*point[1:], 1.0))[:3]
