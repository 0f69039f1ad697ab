"""matplotlib's hand: the still picture of a scene, with named parts.

Marks are painted as they are, without an artist for each: a picture has hundreds, and the first
view of a lesson waits for it.
"""
from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from matplotlib.backend_bases import GraphicsContextBase, RendererBase
from matplotlib.backends.backend_agg import RendererAgg
from matplotlib.colors import to_rgba
from matplotlib.font_manager import FontProperties
from matplotlib.path import Path
from matplotlib.textpath import text_to_path
from matplotlib.transforms import Affine2D, Transform, TransformedPath
from PIL import Image

from ..arms.motions import Numbers
from .chart_marks import HEIGHT, chart_marks
from .paints import Paint
from .scene import Scene
from .solids import OFFSETS, Across, Round
from .still import Drawn, Mark, still
from .timed_marks import timed_height, timed_marks

_DPI = 108                                  # of a still picture
_COLOURS = 256                              # of it: a lesson holds ten of them
_SIDES = 36                                 # of a round gradient
_BEYOND = 1.0                               # how far a gradient goes on beyond its ends
_LETTERS, _RISE, _RIM = 12.5, 0.28, 3.0     # px; of their size: from a baseline to the middle; px
_RIM_COLOUR = "#ffffffd9"
_FAINT, _EDGE = 10, 12                      # of 255: no more from white is empty; px: left round
_BAND, _PILL = 44.0, 30.0                   # px: height of the words' place, and of what holds them
_PAPER: Paint = {"fill": "white", "stroke": "none"}
_WORDS: Paint = {"fill": "#1f3a56"}
_BEHIND: Paint = {"fill": "#f7fafd", "stroke": "#8fa9c0", "stroke-width": 1.0}


@dataclass(frozen=True)
class Figure:
    """A picture to be drawn, part by part, in px of its own.

    Not matplotlib's: that one loads axes of all kinds, for which a first picture would wait.
    """

    parts: list[Part]
    size: tuple[float, float]

    def draw(self, renderer: RendererBase, px: Transform) -> None:
        """Draw all of it; `px` leads from its px to those of the renderer."""
        for part in self.parts:
            part.draw(renderer, px)


def figure(scene: Scene, q: Numbers, preset: str = "",
           show: Sequence[str] = ("frames", "labels", "floor")) -> Figure:
    """The scene drawn at joint values `q`, every part with its name."""
    drawn, (width, height) = still(scene, q, preset, show), scene.size
    if scene.chart:
        drawn, height = [*drawn, *chart_marks(scene.chart, q, scene.size)], height + HEIGHT
    if scene.timed:
        drawn = [*drawn, *timed_marks(scene.timed, float(q[0]), (width, height))]
        height += timed_height(scene.timed, width)
    return Figure([Part(one) for one in drawn], (width, height))


def prepare() -> None:
    """Load the letters, which takes a moment, before the first picture is wanted."""
    for weight in ("bold", "normal"):
        _letters("x", weight)


def png(fig: Figure, words: str = "") -> bytes:
    """The figure as a PNG picture, in so many colours that the axes keep theirs.

    With words the picture has no empty frame, and they stand under it.
    """
    picture, small = _pixels(fig), io.BytesIO()
    if words:
        picture = _under(_cropped(picture), words)
    fewer = picture.quantize(_COLOURS, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    fewer.save(small, "PNG")
    return small.getvalue()


def _pixels(fig: Figure) -> Image.Image:
    width, height = fig.size
    px = Affine2D().translate(0, -height).scale(1 / 72, -1 / 72).scale(_DPI)
    canvas = RendererAgg(width / 72 * _DPI, height / 72 * _DPI, _DPI)
    _stroke(canvas, Path.unit_rectangle(), Affine2D().scale(width, height) + px, _PAPER)
    fig.draw(canvas, px)
    return Image.fromarray(np.asarray(canvas.buffer_rgba())).convert("RGB")


def _cropped(picture: Image.Image) -> Image.Image:
    """What is drawn in a picture, with a little room round it; all of it if that is nothing."""
    drawn = np.asarray(picture).min(axis=2) < 255 - _FAINT
    if not drawn.any():
        return picture
    down, right = np.nonzero(drawn)
    edge = _EDGE * _DPI // 72
    return picture.crop((max(0, right.min() - edge), max(0, down.min() - edge),
                         min(picture.width, right.max() + edge),
                         min(picture.height, down.max() + edge)))


def _under(picture: Image.Image, words: str) -> Image.Image:
    """The picture with words under it, and the sign for run."""
    _, middle = _letters(words, "bold")
    long, scale = 2 * middle + 2 * _PILL, _DPI / 72
    width, y = max(picture.width / scale, long + 2 * _EDGE), _BAND / 2
    x, r = (width - long) / 2, _PILL / 2
    turn = np.linspace(np.pi / 2, 3 * np.pi / 2, _SIDES)
    end = r * np.stack([np.cos(turn), np.sin(turn)], axis=-1)
    pill = np.vstack([end + (x + r, y), -end + (x + long - r, y)])
    run = np.array([[0, -6], [0, 6], [10, 0]]) + (x + 0.75 * _PILL, y)
    place = np.array([[x + 1.5 * _PILL + middle, y]])
    line = Part(Drawn("words", [
        Mark([pill], _BEHIND, closed=True), Mark([run], _WORDS, closed=True),
        Mark([place], _WORDS, text=words)]))
    below = _pixels(Figure([line], (width, _BAND)))
    both = Image.new("RGB", (below.width, picture.height + below.height), "white")
    both.paste(picture, ((below.width - picture.width) // 2, 0))
    both.paste(below, (0, picture.height))
    return both


class Part:
    """All marks of one thing, in one named group."""

    def __init__(self, drawn: Drawn) -> None:
        self.gid = drawn.gid
        # A path that clips has to outlast the picture: Agg knows it again by its address.
        self.marks = [(mark, _path(mark.lines, closed=mark.closed)) for mark in drawn.marks
                      if any(len(line) for line in mark.lines)]

    def draw(self, renderer: RendererBase, px: Transform) -> None:
        renderer.open_group("part", gid=self.gid)
        for mark, path in self.marks:
            _paint(renderer, mark, path, px)
        renderer.close_group("part")


def _paint(renderer: RendererBase, mark: Mark, path: Path, px: Transform) -> None:
    if mark.light is not None:
        _light(renderer, path, mark.light, mark.fill, px)
    if mark.text:
        _write(renderer, mark, px)
    else:
        _stroke(renderer, path, px, mark.paint, mark.opacity, filled=mark.closed)


def _stroke(renderer: RendererBase, path: Path, px: Transform, paint: Paint,
            opacity: float = 1.0, *, filled: bool = True) -> None:
    """Fill a path and draw it, in so far as it has the paint for either."""
    fill = _colour(paint["fill"], opacity) if filled and "fill" in paint else None
    gc = renderer.new_gc()
    gc.set_foreground(_colour(paint.get("stroke", "none"), opacity), isRGBA=True)
    _set_pen(gc, paint)
    renderer.draw_path(gc, path, px, fill)
    gc.restore()


def _set_pen(gc: GraphicsContextBase, paint: Paint) -> None:
    gc.set_linewidth(paint.get("stroke-width", 1.0) if paint.get("stroke") != "none" else 0.0)
    gc.set_joinstyle(paint.get("stroke-linejoin", "round"))  # type: ignore[arg-type]
    gc.set_capstyle("round")
    gc.set_dashes(0, list(paint.get("stroke-dasharray", ())) or None)


@lru_cache(1000)
def _colour(name: str, opacity: float) -> tuple[float, float, float, float]:
    red, green, blue, own = to_rgba(name)
    return red, green, blue, own * opacity


def _path(lines: Sequence[np.ndarray], *, closed: bool) -> Path:
    """One path of several lines."""
    lines = [np.vstack([line, line[:1]]) if closed else line for line in lines if len(line)]
    corners = np.concatenate(lines)
    codes = np.full(len(corners), Path.LINETO, dtype=Path.code_type)
    ends = np.cumsum([len(line) for line in lines])
    codes[ends[:-1]] = codes[0] = Path.MOVETO
    if closed:
        codes[ends - 1] = Path.CLOSEPOLY
    return Path(corners, codes)


# ---- words ----

def _write(renderer: RendererBase, mark: Mark, px: Transform) -> None:
    """Words with a rim that keeps off what lies under them."""
    letters, side = _letters(mark.text, mark.weight, mark.side)
    ((x, y),) = mark.lines[0]
    where = Affine2D().translate(-side, 0).scale(1, -1).translate(x, y + _RISE * _LETTERS) + px
    rim: Paint = {"stroke": _RIM_COLOUR, "stroke-width": _RIM}
    _stroke(renderer, letters, where, rim, mark.opacity)
    _stroke(renderer, letters, where, {**mark.paint, "stroke": "none"}, mark.opacity)


@lru_cache(1000)
def _letters(text: str, weight: str, side: str = "middle") -> tuple[Path, float]:
    """The outlines of words in px, and how far their side, or their middle, lies to the right."""
    corners, codes = text_to_path.get_text_path(_font(weight), text)
    corners = np.asarray(corners).reshape(-1, 2) * _LETTERS / text_to_path.FONT_SCALE
    across = corners[:, 0] if len(corners) else np.zeros(1)  # some signs leave no ink
    low, high = float(across.min()), float(across.max())
    return Path(corners, codes), {"left": low, "right": high, "middle": (low + high) / 2}[side]


@lru_cache
def _font(weight: str) -> FontProperties:
    return FontProperties(family="sans-serif", weight=weight, size=_LETTERS)


# ---- gradients ----

def _light(renderer: RendererBase, outline: Path, light: Across | Round,
           colours: Sequence[str], px: Transform) -> None:
    """The gradient within an outline."""
    stops = np.array([_colour(colour, 1.0) for colour in colours])
    corners, shades = (_across(light, np.asarray(outline.vertices), stops)
                       if isinstance(light, Across) else _round(light, stops))
    gc = renderer.new_gc()
    gc.set_clip_path(TransformedPath(outline, px))
    renderer.draw_gouraud_triangles(gc, _triangles(corners), _triangles(shades), px)
    gc.restore()


def _triangles(grid: np.ndarray) -> np.ndarray:
    """Two triangles in every cell of a grid of corners, or their colours."""
    a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, :-1], grid[1:, 1:]
    corners = np.stack([a, b, c, b, c, d], axis=2)
    return corners.reshape(-1, 3, grid.shape[-1])


def _across(light: Across, outline: np.ndarray,
            stops: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Corners of a strip along the gradient, two for each stop, and their colours."""
    way = np.asarray(light.end) - light.start
    aside = np.array([-way[1], way[0]])
    square = float(way @ way) or 1.0
    wide = float(np.abs((outline - light.start) @ aside).max()) / square + 0.1
    share = np.array([-_BEYOND, *OFFSETS[Across], 1 + _BEYOND])
    along = light.start + share[:, None] * way
    corners = along[:, None] + np.array([[-wide], [wide]]) * aside
    colours = stops[[0, *range(len(stops)), -1]]
    return corners, np.repeat(colours[:, None], 2, axis=1)


def _round(light: Round, stops: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Corners of rings round the middle of the gradient, one for each stop, and their colours."""
    angles = np.linspace(0, 2 * np.pi, _SIDES + 1)
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    share = np.array([*OFFSETS[Round], 1 + _BEYOND])
    corners = np.asarray(light.center) + light.radius * share[:, None, None] * circle
    colours = stops[[*range(len(stops)), -1]]
    return corners, np.repeat(colours[:, None], len(angles), axis=1)
