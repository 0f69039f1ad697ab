"""matplotlib's hand: the still picture of a scene, with named parts."""
from __future__ import annotations

import io
from collections.abc import Iterable, Iterator, Sequence

import matplotlib
import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backend_bases import RendererBase
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from matplotlib.patheffects import withStroke
from matplotlib.text import Text
from matplotlib.transforms import Affine2D
from PIL import Image

from ..arms.motions import Numbers
from .paints import Paint
from .scene import Scene
from .solids import Across, Round
from .still import Drawn, Mark, still

_PIXELS = 32                                # of a gradient, from its first level to its last
_OFFSETS = {3: (0.0, 0.5, 1.0), 5: (0.0, 0.175, 0.5, 0.825, 1.0)}  # of its levels, as in solids.py
_COLOURS = 256                              # of a still picture: a lesson holds ten of them


def figure(scene: Scene, q: Numbers, preset: str = "",
           show: Sequence[str] = ("frames", "labels", "floor")) -> Figure:
    """The scene drawn at joint values `q`, every part carrying its `gid`."""
    width, height = scene.size
    fig = Figure(figsize=(width / 72, height / 72), dpi=72)
    ax = fig.add_axes((0, 0, 1, 1), xlim=(0, width), ylim=(height, 0))
    ax.axis("off")
    for depth, drawn in enumerate(still(scene, q, preset, show), start=1):
        ax.add_artist(_Part(ax, drawn)).set_zorder(depth)
    return fig


def png(fig: Figure) -> bytes:
    """The figure as a PNG picture, in so many colours that the axes keep theirs."""
    drawn, small = io.BytesIO(), io.BytesIO()
    with matplotlib.rc_context({"path.simplify": False}):
        fig.savefig(drawn, format="png", dpi=108, facecolor="white")
    picture = Image.open(drawn).convert("RGB")
    fewer = picture.quantize(_COLOURS, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    fewer.save(small, "PNG", optimize=True)
    return small.getvalue()


class _Part(Artist):
    """All marks of one thing, in one named group."""

    def __init__(self, ax: Axes, drawn: Drawn) -> None:
        super().__init__()
        self.set_gid(drawn.gid)
        self.pieces = [piece for mark in drawn.marks for piece in _artists(ax, mark)]

    def draw(self, renderer: RendererBase) -> None:
        renderer.open_group("part", gid=self.get_gid())
        for piece in self.pieces:
            piece.draw(renderer)
        renderer.close_group("part")


def _artists(ax: Axes, mark: Mark) -> Iterator[Artist]:
    if mark.light is not None:
        yield _shaded(ax, mark.lines[0], mark.light, mark.fill)
    if mark.text:
        yield _placed(ax, _text(mark))
    elif any(len(line) for line in mark.lines):
        yield _placed(ax, PathPatch(
            _path(mark.lines, closed=mark.closed), fill="fill" in mark.paint, capstyle="round",
            alpha=mark.opacity, **_patch(mark.paint)))


def _placed(ax: Axes, artist: Artist) -> Artist:
    artist.set_figure(ax.figure)
    artist.axes = ax
    artist.set_transform(ax.transData)
    return artist


def _text(mark: Mark) -> Text:
    ((x, y),) = mark.lines[0]
    return Text(x, y, mark.text, color=mark.paint["fill"], fontsize=12.5, weight=mark.weight,
                ha="center", va="center", family="sans-serif", alpha=mark.opacity,
                path_effects=[withStroke(linewidth=3, foreground="white", alpha=0.85)])


def _path(lines: Iterable[np.ndarray], *, closed: bool) -> Path:
    return Path.make_compound_path(*(
        Path(np.vstack([line, line[:1]]) if closed else line, closed=closed)
        for line in lines if len(line)))


def _patch(paint: Paint) -> dict:
    """A paint in matplotlib's words; its dashes are multiples of the line's width."""
    width = paint.get("stroke-width", 1.0)
    dash = [length / width for length in paint.get("stroke-dasharray", ())]
    return {"edgecolor": paint["stroke"], "linewidth": width,
            "joinstyle": paint.get("stroke-linejoin", "round"),
            "facecolor": paint.get("fill", "none"), "linestyle": (0, dash) if dash else "-"}


# ---- gradients ----

def _shaded(ax: Axes, outline: np.ndarray, light: Across | Round,
            colours: Sequence[str]) -> AxesImage:
    """The gradient within an outline, as a picture of its own that is cut out."""
    stops, where = np.array([to_rgb(colour) for colour in colours]), _OFFSETS[len(colours)]
    image, extent, place = (_across(light, outline) if isinstance(light, Across)
                            else _round(light))
    shaded = AxesImage(ax, interpolation="bilinear", extent=extent, origin="lower")
    shaded.set_data(np.stack([np.interp(image, where, stop) for stop in stops.T], axis=-1))
    shaded.set_transform(place + ax.transData)
    shaded.set_clip_path(Path(np.vstack([outline, outline[:1]]), closed=True), ax.transData)
    return shaded


def _across(light: Across, outline: np.ndarray) -> tuple[np.ndarray, tuple, Affine2D]:
    """How far along the gradient each pixel lies, and where they lie on the picture."""
    (x, y), (u, v) = light.start, np.asarray(light.end) - light.start
    square = (u * u + v * v) or 1.0
    wide = float(np.abs((outline - light.start) @ [-v, u]).max()) / square + 0.1
    share = np.linspace(-0.1, 1.1, _PIXELS)
    return (np.tile(share, (2, 1)), (-0.1, 1.1, -wide, wide),
            Affine2D(np.array([[u, -v, x], [v, u, y], [0, 0, 1]])))


def _round(light: Round) -> tuple[np.ndarray, tuple, Affine2D]:
    """How far from the middle of the gradient each pixel lies."""
    side = np.linspace(-1, 1, _PIXELS)
    return (np.hypot(side, side[:, None]), (-1, 1, -1, 1),
            Affine2D().scale(light.radius).translate(*light.center))
