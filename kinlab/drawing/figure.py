"""matplotlib's hand: the scene at one pose, as a still figure with named parts."""
from __future__ import annotations

import io
import re
from collections.abc import Sequence
from typing import Any

import matplotlib
import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from matplotlib.patheffects import withStroke

from ..arms.motions import Numbers
from .camera import Camera
from .paints import INK, PAINTS, Paint
from .scene import ARROW, FACE, HULL, TEXT, Item, Scene
from .solids import hull

_Placed = tuple[Item, np.ndarray]


def project(scene: Scene, frames: np.ndarray, view: np.ndarray, item: Item) -> np.ndarray:
    """The item's points on the picture: x right, y down (px), and nearness (length unit)."""
    index = [int(point[0]) for point in item.points]
    local = np.array([(*point[1:], 1.0) for point in item.points])
    room = np.einsum("kij,kj->ki", frames[index][:, :3], local)
    right, up, near = (np.eye(3) if item.paper else view) @ (room - scene.middle(frames)).T
    (x, y), s = scene.heart, scene.scale
    return np.stack([x + s * right, y - s * up, near], axis=-1)


def outline(shape: str, points: np.ndarray) -> np.ndarray | None:
    """Corners of the path that a shape makes on the picture; None where it cannot be seen."""
    flat = points[:, :2]
    if shape == FACE:
        (x, y), (u, v) = flat.T, np.roll(flat, -1, axis=0).T
        return flat if np.sum(x * v - u * y) < 0 else None  # y points down
    return {HULL: hull, ARROW: _arrow}.get(shape, lambda p: p)(flat)


def figure(scene: Scene, q: Numbers, preset: str = "3-D",
           show: Sequence[str] = ("frames", "labels")) -> Figure:
    """The scene drawn at joint values `q`, every part carrying its `gid`."""
    width, height = scene.size
    fig = Figure(figsize=(width / 72, height / 72), dpi=72)
    ax = fig.add_axes((0, 0, 1, 1), xlim=(0, width), ylim=(height, 0))
    ax.axis("off")
    frames, view = scene.frames(q), Camera(*scene.presets[preset]).axes
    placed = [(item, project(scene, frames, view, item)) for item in scene.items]
    for depth, (item, points) in enumerate(_far_to_near(placed), start=1):
        _add(ax, item, points).set(gid=item.gid, zorder=depth,
                                   visible=not item.layer or item.layer in show)
    return fig


def svg(fig: Figure) -> str:
    """The figure as SVG text in pixels, to be put into a page.

    The XML prologue is left out, and so is matplotlib's style sheet: within a page it would
    restyle the lines of every other picture there.
    """
    bare = dict.fromkeys(("Creator", "Date", "Format", "Type"))
    text = _save(fig, "svg", metadata=bare, transparent=True).decode()
    return re.sub(r"<defs>\s*<style.*?</defs>", "", text[text.index("<svg"):], flags=re.DOTALL)


def png(fig: Figure) -> bytes:
    """The figure as a PNG picture, with a rim around its letters as the browser draws it."""
    for text in fig.axes[0].texts:
        text.set_path_effects([withStroke(linewidth=3, foreground="white")])
    return _save(fig, "png", dpi=108, facecolor="white")


def _save(fig: Figure, kind: str, **options: Any) -> bytes:
    buffer = io.BytesIO()
    # Text stays text, in the page's own fonts; the salt keeps the file the same from run to run.
    with matplotlib.rc_context({"svg.fonttype": "none", "svg.hashsalt": "kinlab",
                                "path.simplify": False}):
        fig.savefig(buffer, format=kind, **options)
    return buffer.getvalue()


def _far_to_near(placed: list[_Placed]) -> list[_Placed]:
    """What lies under everything first, then whole bodies from far to near."""
    depths: dict[int, list[float]] = {}
    for item, points in placed:
        depths.setdefault(item.body, []).append(item.lift + float(points[:, 2].mean()))
    depth = {body: -np.inf if body < 0 else np.mean(near) for body, near in depths.items()}
    return sorted(placed, key=lambda pair: depth[pair[0].body])


def _add(ax: Axes, item: Item, points: np.ndarray) -> Artist:
    if item.shape == TEXT:
        x, y = points[0, :2]
        paint = PAINTS[item.style]
        return ax.text(x, y, item.text, color=paint.get("words", paint.get("fill", INK)),
                       fontsize=11, ha="center", va="center", family="sans-serif")
    corners, closed = outline(item.shape, points), item.shape in (FACE, HULL, ARROW)
    # A face turned away is an empty path: every item has its part in the figure.
    corners = np.empty((0, 2)) if corners is None else corners
    path = np.vstack([corners, corners[:1]]) if closed else corners
    return ax.add_patch(PathPatch(Path(path, closed=closed and len(path) > 0), fill=closed,
                                  capstyle="round", clip_on=False, **_patch(PAINTS[item.style])))


def _patch(paint: Paint) -> dict:
    """A paint in matplotlib's words; its dashes are multiples of the line's width."""
    width = paint["stroke-width"]
    dash = [length / width for length in paint.get("stroke-dasharray", ())]
    return {"edgecolor": paint["stroke"], "linewidth": width, "joinstyle": paint["stroke-linejoin"],
            "facecolor": paint.get("fill", "none"), "linestyle": (0, dash) if dash else "-"}


def _arrow(points: np.ndarray) -> np.ndarray:
    """Shaft and head; the head shrinks as the arrow turns towards the viewer."""
    tail, tip = points
    shaft = tip - tail
    length = float(np.hypot(*shaft))
    along = shaft / length if length > 1e-9 else np.zeros(2)
    head = min(9.0, 0.5 * length)
    neck, side = tip - head * along, 0.36 * head * np.array([-along[1], along[0]])
    return np.array([tail, neck, neck + side, tip, neck - side, neck, tail])
