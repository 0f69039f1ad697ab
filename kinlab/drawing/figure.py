"""matplotlib's hand: the scene at one pose, as a figure whose parts the browser can move."""
from __future__ import annotations

import io
import re
from collections.abc import Sequence

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from matplotlib.patheffects import withStroke

from .scene import ARROW, FACE, SOLID, TEXT, Item, Scene, camera

# Okabe-Ito colours; axes are also labelled, so colour is never the only cue.
INK, STEEL, PALE, FAINT = "#2b3138", "#7d8b99", "#dfe6ee", "#d5dae0"
AXIS_COLOURS = {"x": "#D55E00", "y": "#009E73", "z": "#0072B2"}
_FILLED = dict(edgecolor=INK, linewidth=1.0, joinstyle="round")
STYLES = {
    "ground": dict(edgecolor=FAINT, linewidth=0.8),
    "mesh": dict(edgecolor="#a9bccd", linewidth=1.0),
    "ghost": dict(edgecolor=FAINT, linewidth=6, joinstyle="round"),
    "link": dict(edgecolor=STEEL, linewidth=8, joinstyle="round"),
    "rod": dict(edgecolor=STEEL, linewidth=5, joinstyle="round"),
    "joint": dict(facecolor="#b4c1cf", **_FILLED),
    "cap": dict(facecolor=PALE, **_FILLED),
    "gripper": dict(edgecolor=INK, linewidth=3.2, joinstyle="miter"),
    "tool": dict(edgecolor="#CC79A7", linewidth=6),
    "axis": dict(edgecolor=INK, linewidth=1, linestyle=(0, (6, 3, 1.5, 3))),
    "dashed": dict(edgecolor=STEEL, linewidth=1.4, linestyle=(0, (4, 3))),
    "arc": dict(edgecolor=INK, linewidth=1.4),
    "vector": dict(edgecolor=INK, facecolor=INK, linewidth=2, joinstyle="round"),
    "ellipse": dict(edgecolor="#56B4E9", facecolor=(0.34, 0.71, 0.91, 0.25), linewidth=1.6,
                    joinstyle="round"),
    "target": dict(edgecolor="#D55E00", linewidth=2.2),
    "miss": dict(edgecolor="#D55E00", linewidth=1.4, linestyle=(0, (4, 3))),
    "first": dict(edgecolor="#D55E00", linewidth=2, joinstyle="round"),
    "second": dict(edgecolor="#0072B2", linewidth=2, joinstyle="round", linestyle=(0, (5, 2))),
    "first-dot": dict(edgecolor="#D55E00", linewidth=8),
    "second-dot": dict(edgecolor="#0072B2", linewidth=8),
    "trace": dict(edgecolor="#CC79A7", linewidth=1.6, joinstyle="round"),
} | {axis: dict(edgecolor=colour, facecolor=colour, linewidth=1.8, joinstyle="round")
     for axis, colour in AXIS_COLOURS.items()}
# Text stays text, so that it can move; the salt keeps the file the same from run to run.
_SVG = {"svg.fonttype": "none", "svg.hashsalt": "kinlab", "path.simplify": False}


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
    return {SOLID: _hull, ARROW: _arrow}.get(shape, lambda p: p)(flat)


def figure(scene: Scene, q: Sequence[float], preset: str = "3-D",
           show: Sequence[str] = ("frames", "labels")) -> Figure:
    """The scene drawn at joint values `q`, every part carrying its `gid`."""
    width, height = scene.size
    fig = Figure(figsize=(width / 72, height / 72), dpi=72)
    ax = fig.add_axes((0, 0, 1, 1), xlim=(0, width), ylim=(height, 0))
    ax.axis("off")
    frames, view = scene.frames(q), camera(*scene.presets[preset])
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


def _save(fig: Figure, kind: str, **options) -> bytes:
    buffer = io.BytesIO()
    with matplotlib.rc_context(_SVG):
        fig.savefig(buffer, format=kind, **options)
    return buffer.getvalue()


def _far_to_near(placed: list) -> list:
    """What lies under everything first, then whole bodies from far to near."""
    depths: dict[int, list[float]] = {}
    for item, points in placed:
        depths.setdefault(item.body, []).append(item.lift + float(points[:, 2].mean()))
    depth = {body: -np.inf if body < 0 else np.mean(near) for body, near in depths.items()}
    return sorted(placed, key=lambda pair: depth[pair[0].body])


def _add(ax, item: Item, points: np.ndarray):
    if item.shape == TEXT:
        colour = AXIS_COLOURS.get(item.style, INK)
        return ax.text(*points[0, :2], item.text, color=colour, fontsize=11, ha="center",
                       va="center", family="sans-serif")
    corners, closed = outline(item.shape, points), item.shape in (FACE, SOLID, ARROW)
    # A face turned away is an empty path that keeps its paint, for when it turns to the viewer.
    corners = np.empty((0, 2)) if corners is None else corners
    path = np.vstack([corners, corners[:1]]) if closed else corners
    return ax.add_patch(PathPatch(Path(path, closed=closed and len(path) > 0), fill=closed,
                                  capstyle="round", clip_on=False, **STYLES[item.style]))


def _arrow(points: np.ndarray) -> np.ndarray:
    """Shaft and head; the head shrinks as the arrow turns towards the viewer."""
    tail, tip = points
    shaft = tip - tail
    length = float(np.hypot(*shaft))
    along = shaft / length if length > 1e-9 else np.zeros(2)
    head = min(9.0, 0.5 * length)
    neck, side = tip - head * along, 0.36 * head * np.array([-along[1], along[0]])
    return np.array([tail, neck, neck + side, tip, neck - side, neck, tail])


def _hull(points: np.ndarray) -> np.ndarray:
    """Convex hull of points in the plane, by Andrew's monotone chain."""
    ordered = sorted(map(tuple, points))

    def half(chain):
        hull: list = []
        for p in chain:
            while len(hull) > 1 and _turn(hull[-2], hull[-1], p) <= 0:
                hull.pop()
            hull.append(p)
        return hull[:-1]

    return np.array(half(ordered) + half(reversed(ordered)))


def _turn(o, a, b) -> float:
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])
