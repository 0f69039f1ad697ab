"""Pictures of a workspace: slices, the reach envelope, density. Plain matplotlib figures."""
from __future__ import annotations

import io
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap, LogNorm
from matplotlib.figure import Figure

from ..arms import inputs
from ..arms.kinematics import forward_kinematics, link_frames, reach
from ..arms.workspace import Workspace
from .paints import COLOURS

# Told apart by line style too.
INNER, OUTER = COLOURS["second"].line, COLOURS["first"].line
FILL, ARM, LINK = "#cfe6f6", "#39434d", "#b3bec9"  # what is reached; edge and face of the arm
_FAR = "distance from the base's axis"

See = Callable[[np.ndarray], np.ndarray]  # points of the room as two numbers each


class Picture(Figure):
    """A matplotlib figure that a notebook shows by itself, with words for those who cannot see it.

    Attributes
    ----------
    about, words : str
        What kind of picture it is, and what it shows.
    """

    about = "Picture of a workspace."
    words = ""

    def __repr__(self) -> str:
        return self.words

    def _repr_mimebundle_(self, **kwargs: Any) -> tuple[dict, dict]:
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=90, facecolor="white", bbox_inches="tight")
        return ({"text/plain": self.words, "image/png": buffer.getvalue()},
                {"image/png": {"alt": f"{self.about} {self.words}"}})


def slice_picture(reached: Workspace, axis: str = "y", at: float = 0.0) -> Picture:
    """A slab across x, y or z of the room: its points, and the cells that hold any.

    The arm at home is drawn over it, as seen along the axis.

    Parameters
    ----------
    reached : Workspace
    axis, at
        As in `Workspace.slice`.

    Returns
    -------
    matplotlib.figure.Figure
    """
    _check(reached)
    points, unit = reached.slice(axis, at), reached.arm.unit
    across, up = sides = [k for k in range(3) if "xyz"[k] != axis]
    title = f"{_name(reached)}: slice {axis} = {at:g} {unit}"
    names, flat = ("xyz"[across], "xyz"[up]), points[:, sides]
    fig, ax = _figure(title, names, unit)
    _cells(ax, flat, max(np.ptp(reached.points, axis=0).max() / 60, 1e-9))
    dot = float(np.clip(200 / (len(flat) + 1) ** 0.5, 1.2, 4))  # fewer points, larger dots
    ax.plot(*flat.T, ".", color=OUTER, markersize=dot, alpha=0.6, markeredgewidth=0)
    _arm(ax, reached, lambda room: room[:, sides])
    return _said(fig, flat, names, unit)


def envelope_picture(reached: Workspace, bins: int = 60) -> Picture:
    """Nearest and farthest reach from the base's axis at each height.

    For an arm that stays in one level plane, nearest and farthest reach in each direction.

    Parameters
    ----------
    reached : Workspace
    bins : int
        As in `Workspace.envelope`.

    Returns
    -------
    matplotlib.figure.Figure
    """
    _check(reached)
    unit, (names, see) = reached.arm.unit, _sight(reached)
    near, far = _by_direction(reached, bins) if _is_flat(reached) else _by_height(reached, bins)
    fig, ax = _figure(f"{_name(reached)}: reach envelope", names, unit)
    ax.fill(*np.concatenate([near, far[::-1]]).T, color=FILL, linewidth=0)
    ax.plot(*far.T, color=OUTER, linewidth=2, label="farthest")
    ax.plot(*near.T, color=INNER, linewidth=2, linestyle="--", label="nearest")
    _arm(ax, reached, see)
    ax.legend(loc="upper left", bbox_to_anchor=(1.02, 1), borderaxespad=0, frameon=False)
    return _said(fig, np.concatenate([near, far]), names, unit)


def density_picture(reached: Workspace, bins: int = 120) -> Picture:
    """How often each distance and height is reached; in a level plane, each place.

    Parameters
    ----------
    reached : Workspace
    bins : int
        As in `Workspace.density`.

    Returns
    -------
    matplotlib.figure.Figure
    """
    _check(reached)
    unit, (names, see) = reached.arm.unit, _sight(reached)
    if flat := _is_flat(reached):
        x, y = see(reached.points).T
        counts, right, up = np.histogram2d(x, y, bins=inputs.whole("bins", bins, 1))
        counts /= counts.max()
    else:
        counts, right, up = reached.density(bins)
    fig, ax = _figure(f"{_name(reached)}: density", names, unit)
    mesh = ax.pcolormesh(right, up, np.ma.masked_equal(counts, 0).T, cmap="viridis",
                         rasterized=True, norm=LogNorm(np.percentile(counts[counts > 0], 2), 1))
    _arm(ax, reached, see)
    fig.colorbar(mesh, ax=ax, label=f"poses per {'area' if flat else 'volume'}, largest = 1")
    return _said(fig, np.stack([right, up], axis=1), names, unit)


def _figure(title: str, names: tuple[str, str], unit: str) -> tuple[Picture, Axes]:
    fig = Picture(figsize=(6, 5), layout="constrained")
    labels = [f"{name} ({unit})" for name in names]
    ax = fig.add_subplot(title=title, xlabel=labels[0], ylabel=labels[1])
    ax.set_aspect("equal", adjustable="box")
    ax.use_sticky_edges = False  # cells, too, keep off the frame
    ax.margins(0.04)
    return fig, ax


def _said(fig: Picture, points: np.ndarray, names: tuple[str, str], unit: str) -> Picture:
    """The figure, with words for what it shows."""
    title = fig.axes[0].get_title()
    if not len(points):
        fig.words = f"{title}, no points"
        return fig
    decimals = 0 if np.abs(points).max() > 50 else 2
    ends = np.round(np.transpose([points.min(axis=0), points.max(axis=0)]), decimals) + 0.0
    spans = [f"{name} from {low:.{decimals}f} to {high:.{decimals}f} {unit}"
             for name, (low, high) in zip(names, ends)]
    fig.words = ", ".join([title, *spans])
    return fig


def _by_height(reached: Workspace, bins: int) -> tuple[np.ndarray, np.ndarray]:
    heights, nearest, farthest = reached.envelope(bins)
    return np.stack([nearest, heights], 1), np.stack([farthest, heights], 1)


def _by_direction(reached: Workspace, bins: int) -> tuple[np.ndarray, np.ndarray]:
    """Nearest and farthest point in every direction of the plane; a closed line if all are there.

    Directions begin after the widest gap, so that an arm with limits gets one open line.
    """
    x, y = _in_base(reached, reached.points)[:, :2].T
    sector = np.floor((np.arctan2(y, x) / (2 * np.pi) + 0.5) * inputs.whole("bins", bins, 1))
    radius, sector = np.hypot(x, y), np.minimum(sector, bins - 1).astype(int)
    held = np.unique(sector)
    gaps = np.diff(held, append=held[0] + bins)
    held = np.roll(held, -1 - np.argmax(gaps))
    if gaps.max() == 1:
        held = np.append(held, held[0])
    angles = ((held + 0.5) / bins - 0.5) * 2 * np.pi
    rays = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    sectors = [radius[sector == k] for k in held]
    return (rays * np.array([[ring.min()] for ring in sectors]),
            rays * np.array([[ring.max()] for ring in sectors]))


def _cells(ax: Axes, points: np.ndarray, side: float) -> None:
    """Squares that hold a point."""
    low = np.floor(points.min(axis=0) / side) if len(points) else np.zeros(2)
    places = np.floor(points / side).astype(int) - low.astype(int)
    held = np.zeros(places.max(axis=0) + 1 if len(points) else (1, 1), dtype=bool)
    held[tuple(places.T)] = True
    edges = [(start + np.arange(count + 1)) * side for start, count in zip(low, held.shape)]
    ax.pcolormesh(*edges, np.ma.masked_equal(held, False).T, cmap=ListedColormap([FILL]),
                  rasterized=True)


def _arm(ax: Axes, reached: Workspace, see: See) -> None:
    """The arm at home, from joint to joint."""
    arm = reached.arm
    joints = np.concatenate([link_frames(arm, arm.home)[:, :3, 3],
                             forward_kinematics(arm, arm.home)[None, :3, 3]])
    shares = np.linspace(0, 1, 20)[:, None]
    line = see(np.concatenate([a + shares * (b - a) for a, b in pairwise(joints)])).T
    for width, colour in ((8, "white"), (6.5, ARM), (4.5, LINK)):  # a rim, an edge, the links
        ax.plot(*line, color=colour, linewidth=width, solid_capstyle="round")
    ax.plot(*see(joints).T, "o", color=LINK, markeredgecolor=ARM, markersize=7,
            label="arm at home")


def _sight(reached: Workspace) -> tuple[tuple[str, str], See]:
    """How envelope and density look at a point, and the names of the two numbers they see."""
    if _is_flat(reached):
        return ("x", "y"), lambda room: _in_base(reached, room)[:, :2]
    return (_FAR, "height"), lambda room: np.stack(
        [np.hypot(*_in_base(reached, room).T[:2]), _in_base(reached, room)[:, 2]], axis=1)


def _in_base(reached: Workspace, room: np.ndarray) -> np.ndarray:
    base = reached.arm.base
    return (room - base[:3, 3]) @ base[:3, :3]


def _is_flat(reached: Workspace) -> bool:
    return bool(np.ptp(_in_base(reached, reached.points)[:, 2]) < 1e-9 * reach(reached.arm))


def _name(reached: Workspace) -> str:
    return reached.arm.name or "This arm"


def _check(reached: Workspace) -> None:
    if not isinstance(reached, Workspace):
        raise ValueError(f"reached: expected a Workspace, got {inputs.brief(reached)}; "
                         "make one with workspace(arm)")
