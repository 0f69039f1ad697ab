"""The picture at one pose, as marks on paper: what is painted where, from the back to the front.

kinlab/browser/picture.js does the same at every step of a drag. Here nothing moves: names are
placed once, and layers that are switched off are left out.
"""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from ..arms.motions import Numbers
from .camera import Camera, Extents, Lens, lens
from .cloud import FADES, SLICE, layers, unpacked
from .curves import corners, is_there
from .floor import Drop, Ground, drop, faded, give_way, ground, said_once, shadow
from .floor import Solid as Shading
from .labels import Bar, Label, place, text_size
from .order import Body, back_to_front
from .paints import COLOURS, INK, PAINTS, Paint, pen
from .scene import (
    AREA,
    ARROW,
    AXIS,
    BOX,
    CLOUD,
    FACE,
    HULL,
    LINE,
    NAME,
    PATCH,
    SOLIDS,
    SWEEP,
    TEXT,
    TRACE,
    TUBE,
    WAY,
    Floor,
    Item,
    Scene,
)
from .solids import Across, Face, Round, faces, hull, pale, shades
from .vectors import unit

_AXIS = (0.075, 30.0, 54.0)     # length of an arrow: of the smaller side; at least; at most (px)
_PER_SHARED = 0.36              # longer for each frame at the same origin
_NAME, _MORE = 10.0, 1.25       # px: part of a name; the scale falls while arrows are framed
_SKIN = 1.04                    # where an arrow begins, in radii of the solid that it comes out of
_HEAD = 9.0                     # px: of an arrow
_LEAST_CUT = 0.02               # of a tube: shorter ends are not cut off at the floor
_TOUCH = 0.05                   # of a joint's radius: what is sunk by less lies on the floor
_COME = 13.0                    # px: from where words come that stand beside a point
_KEPT_OFF = ("arc", "line")     # lines that words keep off,
_PIECE = 4                      # in pieces of so many steps
_SAME = 1e-6                    # px: strokes whose depths differ less keep their order
_PANE = 0.7                     # how much of what lies beyond the floor is covered
_OPEN, _CLOSED = (LINE, TRACE, SWEEP, WAY), (ARROW, FACE, HULL, AREA, PATCH)
_STROKES = (*_OPEN, *_CLOSED)
_UNFRAMED = ("axes", "ghost", "trace")  # layers that may leave the picture
_GRID, _SHADE = "#c3ccd5", "#1d2a38"
_DROPPED = pen(COLOURS["point"].line, 1.4, dash=(5, 3))
_GUIDE, _FOOT = pen(COLOURS["point"].line, 1.0, dash=(2, 3)), pen(COLOURS["point"].line, 1.4)
_STRIPE = pen("#ffffff", 1.7)

Segment = tuple[np.ndarray, np.ndarray]


@dataclass(frozen=True, eq=False)
class Mark:
    """Lines or outlines in px, or words that have their `side` at the first point.

    Only what is closed is filled. With a gradient, `fill` holds a colour for each of its levels.
    """

    lines: list[np.ndarray]
    paint: Paint
    closed: bool = False
    light: Across | Round | None = None
    fill: tuple[str, ...] = ()
    text: str = ""
    weight: str = "bold"
    side: str = "middle"
    opacity: float = 1.0


@dataclass(frozen=True, eq=False)
class Drawn:
    """All marks of one thing, under its name."""

    gid: str
    marks: list[Mark]
    item: Item | None = None


def still(scene: Scene, q: Numbers, preset: str = "",
          show: Sequence[str] = ("frames", "labels", "floor"),
          size: tuple[float, float] | None = None) -> list[Drawn]:
    """All that is painted at the knobs' values `q`, from the back to the front.

    Parameters
    ----------
    scene : Scene
    q : sequence of float
        In the scene's units.
    preset : str
        Where the picture is seen from; the scene's own if left out.
    show : sequence of str
        Layers that are switched on.
    size : pair of float, optional
        Width and height (px); the scene's if left out.
    """
    return _Still(scene, q, preset or scene.seen_from, show, size or scene.size).painted()


@dataclass(frozen=True, eq=False)
class _Piece:
    """A solid, or a part of one that goes through the floor."""

    item: Item
    ends: np.ndarray
    size: tuple[float, ...]
    faces: list[Face] = field(default_factory=list)

    @property
    def body(self) -> Body:
        """As a body that others are drawn before or behind."""
        p, q = self.ends[0], self.ends[min(1, len(self.ends) - 1)]
        plane = (unit(q - p), q) if self.item.part == "base" else None
        wide = np.linalg.norm(self.ends[2:] - p, axis=1).max(initial=0.0)
        return Body(p, q, float(1.1 * wide if self.item.shape == BOX else max(self.size)), plane)


class _Still:
    def __init__(self, scene: Scene, q: Numbers, preset: str, show: Sequence[str],
                 size: tuple[float, float]) -> None:
        self.scene, self.size, self.q, self.show = scene, size, q, show
        self.frames = scene.frames(q)
        self.items = [self._worded(item) for item in scene.items
                      if (not item.layer or item.layer in show)
                      and is_there(item, scene.places(q))]
        self.floor: Floor | None = scene.floor if "floor" in show or not any(
            switch.layer == "floor" for switch in scene.switches) else None
        self.lens = self.framed(Camera(*scene.presets[preset]))

    def _worded(self, item: Item) -> Item:
        """Words that tell a knob's value, with what it is now."""
        if item.shape != TEXT or not item.size:
            return item
        k = int(item.size[0])
        return replace(item, text=self.scene.knobs[k].said(float(self.q[k])))

    def framed(self, camera: Camera) -> Lens:
        """The lens through which nothing leaves the picture.

        How far arrows reach depends on its scale: a first lens tells that well enough.
        """
        scene, middle = self.scene, self.scene.middle(self.frames)
        now, home = (self._extents(q) for q in (self.q, scene.begin))
        first = lens(scene, camera, self.size, now, home, middle)
        if not scene.fit:
            return first
        now, home = ([*balls, *self._tips(q, first.scale / camera.zoom)]
                     for q, balls in ((self.q, now), (scene.begin, home)))
        return lens(scene, camera, self.size, now, home, middle)

    def _tips(self, q: Numbers, scale: float) -> Extents:
        """What of long arrows would not have room in the picture's margin."""
        share, least, most = _AXIS
        long = min(most, max(least, share * min(self.size)))
        frames, balls = self.scene.frames(q), list[tuple[Numbers, float]]()
        for item in self.scene.items:
            if item.shape == AXIS:
                origin, beyond = corners(item, self.scene.motions, frames, self.scene.places(q))
                inside, rank = item.size
                over = long * _PER_SHARED * rank + _NAME
                balls.append((origin + (inside + _MORE * over / scale) * (beyond - origin), 0.0))
        return balls

    def painted(self) -> list[Drawn]:
        pieces = [self._lit(piece) for item in self._of(SOLIDS) for piece in self._pieces(item)]
        sunk, standing = self._ordered(pieces)
        strokes = self._of(_STROKES)
        below, over = ([item for item in strokes if (item.body >= 0) is above]
                       for above in (False, True))
        under = [*map(self._dots, self._of([CLOUD])), *map(self._stroke, below)]
        numbers, *words = self._words(pieces)
        return [*sunk, *self._ground(pieces, bool(sunk)), numbers, *under,
                *standing, *self._hints(), *map(self._stroke, self._far_to_near(over)), *words]

    def _of(self, shapes: Sequence[str]) -> list[Item]:
        return [item for item in self.items if item.shape in shapes]

    def _room(self, item: Item) -> np.ndarray:
        """Where an item's points are in the room."""
        return corners(item, self.scene.motions, self.frames, self.scene.places(self.q))

    def _extents(self, q: Numbers) -> Extents:
        """Balls that have to be seen.

        Ends of solids, what is drawn beside the arm, feet, and points that the scene names.
        """
        floor, frames, at = self.scene.floor, self.scene.frames(q), self.scene.places(q)
        balls: list[tuple[Numbers, float]] = []
        for item in self.scene.items:
            if item.shape in SOLIDS and "faded" not in PAINTS[item.style]:
                ends = corners(item, self.scene.motions, frames, at)
                radii = item.size if item.shape != BOX else (
                    float(np.linalg.norm(ends[2] - ends[0])),) * 2
                balls += zip(ends, radii)
            elif item.shape in _STROKES and item.layer not in _UNFRAMED:
                balls += ((point, 0.0) for point in corners(item, self.scene.motions, frames, at))
        for k in floor.drops if floor else ():
            assert floor
            x, y, z = frames[k][:3, 3]
            balls += [((x, y, z), 0.0), ((x, y, floor.height), 0.0)]
        for k, *local in self.scene.fit.points if self.scene.fit else ():
            balls.append(((frames[k] @ (*local, 1.0))[:3], 0.0))
        return balls

    # ---- solids, axes, drop lines ----

    def _pieces(self, item: Item) -> list[_Piece]:
        """A solid, in two where it is a tube that goes through the floor."""
        ends, size = self._room(item), item.size
        if item.shape == TUBE and self.floor:
            a, b = ends
            way = b[2] - a[2]
            share = (self.floor.height - a[2]) / way if way else -1.0
            if _LEAST_CUT < share < 1 - _LEAST_CUT:
                middle, radius = a + share * (b - a), size[0] + share * (size[1] - size[0])
                return [_Piece(item, np.array([a, middle]), (size[0], radius)),
                        _Piece(item, np.array([middle, b]), (radius, size[1]))]
        return [_Piece(item, ends, size)]

    def _lit(self, piece: _Piece) -> _Piece:
        item = piece.item
        seen = faces(item.shape, self.lens, piece.ends, piece.size, PAINTS[item.style],
                     self.frames[int(item.points[0][0])])
        return replace(piece, faces=seen)

    def _ordered(self, pieces: list[_Piece]) -> tuple[list[Drawn], list[Drawn]]:
        """What lies beyond the floor, and what stands on the viewer's side of it."""
        things = [(piece.body, _skins(piece)) for piece in pieces]
        for item in self._of([AXIS]):
            _, skin, tip = self._axis(item)
            things.append((Body(skin, tip, 0.0),
                           Drawn(item.gid, [self._arrow(item, skin, tip)], item)))
        things += [self._dropped(k) for k in self._drops]
        order = back_to_front([body for body, _ in things], self.lens)
        sides: tuple[list[Drawn], list[Drawn]] = [], []
        for k in order:
            body, drawn = things[k]
            sides[not self._sunk(body)].append(drawn)
        return sides

    def _sunk(self, body: Body) -> bool:
        """Whether a body lies on the other side of the floor than the viewer."""
        if not self.floor:
            return False
        above = (body.p[2] + body.q[2]) / 2 - self.floor.height
        touch = _TOUCH * self.scene.fit.thick if self.scene.fit else 0.0
        return above < -touch if self.lens.near[2] >= 0 else above > touch

    def _axis(self, item: Item) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Origin of an axis, where it leaves the solids there, and its tip."""
        share, least, most = _AXIS
        origin, beyond = self._room(item)
        inside, rank = item.size
        length = min(most, max(least, share * min(self.size))) * (1 + _PER_SHARED * rank)
        way = beyond - origin
        return (origin, origin + _SKIN * inside * way,
                origin + (inside + length / self.lens.scale) * way)

    def _arrow(self, item: Item, tail: np.ndarray, tip: np.ndarray) -> Mark:
        ends = self.lens.see(np.array([tail, tip]))[:, :2]
        return Mark([arrow(ends)], PAINTS[item.style], closed=True)

    def _dropped(self, k: int) -> tuple[Body, Drawn]:
        assert self.floor
        (x, y, z), height = self.frames[k][:3, 3], self.floor.height
        body = Body((x, y, z - 0.02 * (z - height)), (x, y, height), 0.0)
        return body, Drawn(f"dropline-{k}", [Mark([self._drops[k].line], _DROPPED)])

    @cached_property
    def _drops(self) -> dict[int, Drop]:
        """The lines dropped on the floor, by the frame that each comes from."""
        return {k: drop(self.floor, self.lens, self.size, self.frames[k][:3, 3])
                for k in self.floor.drops} if self.floor else {}

    def _hints(self) -> Iterator[Drawn]:
        """The arrows of frames once more, dashed, over what hides them."""
        for item in self._of([AXIS]):
            origin, _, tip = self._axis(item)
            mark = self._arrow(item, origin, tip)
            paint: Paint = {**mark.paint, "stroke-dasharray": (3, 2.5)}
            yield Drawn(f"{item.gid}-hint", [replace(mark, paint=paint, opacity=0.6)], item)

    # ---- the floor ----

    @cached_property
    def _seen_ground(self) -> Ground:
        assert self.floor
        return ground(self.floor, self.lens, self.size)

    def _ground(self, pieces: list[_Piece], sunk: bool) -> Iterator[Drawn]:
        if not self.floor:
            return
        seen = self._seen_ground
        if sunk:
            paper: Paint = {"stroke": "none", "fill": "#ffffff"}
            yield Drawn("pane", [Mark([seen.rim], paper, closed=True, opacity=_PANE)])
        colours = (COLOURS["x"].line, COLOURS["y"].line)
        yield Drawn("ground", [
            *_fading(faded(seen.fade, seen.grid), _GRID, 1.0),
            *(mark for line, colour in zip(seen.rulers, colours)
              for mark in _fading(faded(seen.fade, line[None]), colour, 1.4))])
        shapes = [Shading(piece.item.shape, piece.ends, piece.size)
                  for piece in pieces if piece.faces]
        outlines = [line for line in shadow(self.floor, self.lens, shapes) if len(line)]
        soft, hard = pen(_SHADE, 7, fill=_SHADE), pen("none", 7, fill=_SHADE)
        yield Drawn("shadow", [Mark(outlines, soft, closed=True, opacity=0.09),
                               Mark(outlines, hard, closed=True, opacity=0.12)])
        drops = self._drops.values()
        yield Drawn("foot", [Mark([line for one in drops for line in one.guides], _GUIDE),
                             Mark([one.foot for one in drops], _FOOT, closed=True)])

    # ---- strokes and words ----

    def _stroke(self, item: Item) -> Drawn:
        points = self.lens.see(self._room(item))[:, :2]
        return Drawn(item.gid, [Mark(outline(item.shape, points), PAINTS[item.style],
                                     item.shape in _CLOSED)], item)

    def _dots(self, item: Item) -> Drawn:
        """A cloud, each dot a stroke too short to see: Agg draws none without length."""
        plane = self.frames[int(item.size[0])] if SLICE in self.show else None
        dots = unpacked(item.points[0], item.text, item.size[1])
        marks = []
        for layer, fade in zip(layers(dots, plane, self.lens.near, np.array(self.scene.center),
                                      self.scene.radius), FADES):
            ends = self.lens.see(layer)[:, None, :2] + np.array([[0, 0], [0.02, 0.02]])
            marks.append(Mark(list(ends), PAINTS[item.style], opacity=fade))
        return Drawn(item.gid, marks, item)

    def _far_to_near(self, items: list[Item]) -> list[Item]:
        """Whole bodies from far to near."""
        depths: dict[int, list[float]] = {}
        for item in items:
            near = (self._room(item) @ self.lens.near).mean()
            depths.setdefault(item.body, []).append(item.lift + float(near))
        exact = self.lens.scale / _SAME
        return sorted(items, key=lambda item: np.floor(exact * np.mean(depths[item.body]) + 0.5))

    def _words(self, pieces: list[_Piece]) -> Iterator[Drawn]:
        """The numbers on the rulers that others leave room for, then names and coordinates."""
        items = self._of([TEXT, NAME])
        coordinates = said_once(list(self._drops.values()))
        labels = [*map(self._label, items),
                  *(Label(words.place, None, words.w, words.h) for words in coordinates)]
        places, _ = place(labels, self._strokes(),
                          [self._bar(piece.body) for piece in pieces if piece.faces], [],
                          self.size)
        yield self._numbers([(spot.x, spot.y, label.w, label.h)
                             for label, spot in zip(labels, places) if spot])
        for item, spot in zip(items, places):
            if spot:
                yield Drawn(item.gid, _lettering(item, spot.leader, (spot.x, spot.y)), item)
        yield Drawn("coordinates", [
            _text(words.text, (spot.x, spot.y), {"fill": INK})
            for words, spot in zip(coordinates, places[len(items):]) if spot])

    def _numbers(self, taken: list) -> Drawn:
        numbers = give_way(self._seen_ground.numbers, taken) if self.floor else []
        return Drawn("numbers", [
            replace(_text(one.words.text, one.words.place, {"fill": COLOURS[one.axis].words}),
                    weight="normal", opacity=one.opacity) for one in numbers if one.opacity])

    def _label(self, item: Item) -> Label:
        if item.shape == NAME:
            origin, _, tip = self._axis(item)
            start, anchor = self.lens.see(np.array([origin, tip]))[:, :2].tolist()
        else:
            anchor, *away = self.lens.see(self._room(item))[:, :2].tolist()
            start = _beside(anchor, *away) if away else None
        return Label(tuple(anchor), start and tuple(start), *text_size(item.text))

    def _strokes(self) -> list[Bar]:
        ends = [self.lens.see(np.array(self._axis(item))[[0, 2]]) for item in self._of([AXIS])]
        for item in self._of([LINE, ARROW]):
            if item.shape == ARROW or item.part in _KEPT_OFF:
                corners = self.lens.see(self._room(item))
                stops = [*range(0, len(corners) - 1, _PIECE), len(corners) - 1]
                ends += [corners[[k, m]] for k, m in pairwise(stops)]
        return [Bar(tuple(a[:2]), tuple(b[:2])) for a, b in ends]

    def _bar(self, body: Body) -> Bar:
        a, b = self.lens.see(np.array([body.p, body.q]))
        return Bar(tuple(a[:2]), tuple(b[:2]), body.r * self.lens.scale * max(a[2], b[2]))


def _skins(piece: _Piece) -> Drawn:
    """The faces of a solid in their colours."""
    paint = PAINTS[piece.item.style]
    back = pale if paint.get("faded") else str
    ramp = [back(colour) for colour in shades(paint["ramp"])]
    hub = [back(colour) for colour in shades(paint["hub"])] if "hub" in paint else ramp
    edge = pen(back(paint["stroke"]), paint["stroke-width"])
    marks = []
    for face in piece.faces:
        colours = hub if face.role == "hub" else ramp
        if face.role == "mark":
            marks.append(Mark([face.points], _STRIPE))
        elif face.gradient:
            levels = tuple(colours[level] for level in face.gradient.levels)
            marks.append(Mark([face.points], edge, True, face.gradient, levels))
        else:
            assert face.level is not None
            marks.append(Mark([face.points], {**edge, "fill": colours[face.level]}, True))
    return Drawn(piece.item.gid, marks, piece.item)


def _fading(pieces: tuple[np.ndarray, np.ndarray], colour: str, width: float) -> Iterator[Mark]:
    """Pieces of lines, those together that are equally strong."""
    lines, opacity = pieces
    steps = np.ceil(10 * opacity).astype(int)
    for step in np.unique(steps):
        yield Mark(list(lines[steps == step]), pen(colour, width), opacity=0.1 * float(step))


def _lettering(item: Item, leader: Sequence | None, at: tuple[float, float]) -> list[Mark]:
    paint = PAINTS[item.style]
    thin = pen(paint.get("stroke", "#5b6770"), 0.8)
    words: Paint = {"fill": paint.get("words") or paint.get("fill", INK)}
    lines = [Mark([np.array(leader)], thin)] if leader else []
    return [*lines, _text(item.text, at, words)]


def _beside(anchor: Sequence[float], away: Sequence[float]) -> list[float]:
    """From where words at a point come that stand away from another point."""
    dx, dy = anchor[0] - away[0], anchor[1] - away[1]
    d = float(np.hypot(dx, dy))
    far = _COME / d if d >= 1 else 0.0
    return [anchor[0] - far * dx, anchor[1] - far * dy]


def _text(text: str, at: Sequence[float], paint: Paint) -> Mark:
    return Mark([np.array([at], dtype=float)], paint, text=text)


def outline(shape: str, points: np.ndarray) -> list[np.ndarray]:
    """Corners of the path that a shape makes on the picture; none where it cannot be seen."""
    if shape == FACE:
        (x, y), (u, v) = points.T, np.roll(points, -1, axis=0).T
        return [points] if np.sum(x * v - u * y) < 0 else []  # y points down
    return [{HULL: hull, ARROW: arrow}.get(shape, lambda p: p)(points)]


def arrow(points: np.ndarray) -> np.ndarray:
    """Shaft and head; the head shrinks as the arrow turns towards the viewer.

    The shaft runs through all the points, and back again, so that only the head can be filled.
    """
    pieces, tip = np.hypot(*np.diff(points, axis=0).T), points[-1]
    left = np.cumsum(pieces[::-1])[::-1]  # from each point to the tip
    head = min(_HEAD, 0.5 * float(left[0]))
    k = max(0, int(np.sum(left > head + _SAME)) - 1)
    share = (left[k] - head) / pieces[k] if pieces[k] > 0 else 0.0
    neck = points[k] + share * (points[k + 1] - points[k])
    along = unit(tip - neck)
    shaft, side = [*points[:k + 1], neck], 0.36 * head * np.array([-along[1], along[0]])
    return np.array([*shaft, neck + side, tip, neck - side, *shaft[::-1]])
