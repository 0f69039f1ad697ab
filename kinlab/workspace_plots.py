"""Pictures of a workspace: slices, the reach envelope, density. Plain matplotlib figures."""
from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from . import checks
from .sampling import Workspace

# Okabe-Ito blue and vermilion, told apart by line style too.
INNER, OUTER, FILL = "#D55E00", "#0072B2", "#9fc5e3"


def slice_picture(reached: Workspace, axis: str = "y", at: float = 0.0,
                  thickness: float | None = None) -> Figure:
    """The points of a slab across x, y or z of the room.

    Parameters
    ----------
    reached : Workspace
    axis, at, thickness
        As in `Workspace.slice`.

    Returns
    -------
    matplotlib.figure.Figure
    """
    _check(reached)
    points = reached.slice(axis, at, thickness)
    across, up = (k for k in range(3) if "xyz"[k] != axis)
    unit = reached.arm.unit
    fig, ax = _figure(f"{_name(reached)}: slice {axis} = {at:g} {unit}",
                      f"{'xyz'[across]} ({unit})", f"{'xyz'[up]} ({unit})")
    ax.plot(points[:, across], points[:, up], ".", color=OUTER, markersize=2, alpha=0.5,
            markeredgewidth=0)
    return fig


def envelope_picture(reached: Workspace, bins: int = 60) -> Figure:
    """Nearest and farthest reach from the base's axis at each height.

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
    heights, nearest, farthest = reached.envelope(bins)
    unit = reached.arm.unit
    fig, ax = _figure(f"{_name(reached)}: reach envelope",
                      f"distance from the base's axis ({unit})", f"height ({unit})")
    ax.fill_betweenx(heights, nearest, farthest, color=FILL, alpha=0.5, linewidth=0)
    ax.plot(farthest, heights, color=OUTER, label="farthest")
    ax.plot(nearest, heights, color=INNER, linestyle="--", label="nearest")
    ax.legend(frameon=False)
    return fig


def density_picture(reached: Workspace, bins: int = 120) -> Figure:
    """How often each distance and height is reached.

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
    counts, radii, heights = reached.density(bins)
    unit = reached.arm.unit
    fig, ax = _figure(f"{_name(reached)}: density",
                      f"distance from the base's axis ({unit})", f"height ({unit})")
    reached_cells = np.ma.masked_equal(counts, 0).T
    mesh = ax.pcolormesh(radii, heights, reached_cells, cmap="viridis", rasterized=True,
                         norm=LogNorm(np.percentile(counts[counts > 0], 2), 1))
    fig.colorbar(mesh, ax=ax, label="poses per volume, largest = 1")
    return fig


def _figure(title: str, across: str, up: str) -> tuple[Figure, Axes]:
    fig = Figure(figsize=(6, 5), layout="constrained")
    ax = fig.add_subplot(title=title, xlabel=across, ylabel=up)
    ax.set_aspect("equal", adjustable="box")
    return fig, ax


def _name(reached: Workspace) -> str:
    return reached.arm.name or "This arm"


def _check(reached: Workspace) -> None:
    if not isinstance(reached, Workspace):
        raise ValueError(f"reached: expected a Workspace, got {checks.brief(reached)}; "
                         "make one with workspace(arm)")
