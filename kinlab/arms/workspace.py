"""The workspace by sampling: joint ranges are swept evenly, and where the tool gets is kept."""
from __future__ import annotations

import builtins
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from itertools import chain
from typing import Any

import numpy as np

from . import inputs
from .arm import Arm, check_arm
from .joints import WHOLE_TURN, joint_limits
from .kinematics import CHUNK
from .link import PRISMATIC
from .motions import follow

# Seconds before a bar appears. A browser's Python is not heard while it works: a bar would come
# there when it has gone.
PATIENCE = float("inf") if sys.platform == "emscripten" else 1.0


@dataclass(frozen=True, eq=False)
class Workspace:
    """Points that the tool reaches.

    Attributes
    ----------
    arm : Arm
    points : array, shape (m, 3)
        Tool points in the room, in the arm's unit.
    """

    arm: Arm
    points: np.ndarray

    def slice(self, axis: str, at: float, thickness: float | None = None) -> np.ndarray:
        """Points within a slab across an axis of the room.

        Parameters
        ----------
        axis : {"x", "y", "z"}
        at : float
            Where along the axis, in the arm's unit.
        thickness : float, optional
            Of the slab; a fiftieth of the workspace's extent if left out.

        Returns
        -------
        array, shape (k, 3)
        """
        k = "xyz".index(inputs.choice("axis", axis, ("x", "y", "z")))
        if thickness is None:
            thickness = max(np.ptp(self.points[:, k]) / 50, 1e-9)
        half = 0.5 * inputs.positive("thickness", thickness)
        return self.points[np.abs(self.points[:, k] - inputs.number("at", at)) <= half]

    def radii_and_heights(self) -> tuple[np.ndarray, np.ndarray]:
        """Distance from the base's z axis and height above the base, each of shape (m,)."""
        x, y, z = self.arm.base[:3, :3].T @ (self.points - self.arm.base[:3, 3]).T
        return np.hypot(x, y), z

    def envelope(self, bins: int = 60) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Nearest and farthest reach from the base's z axis, layer by layer.

        Parameters
        ----------
        bins : int
            How many layers of equal height.

        Returns
        -------
        heights, nearest, farthest : arrays, shape (k,)
            Middle of each layer that holds points, and its smallest and largest radius.
        """
        bins = inputs.whole("bins", bins, 1)
        radius, height = self.radii_and_heights()
        low, extent = height.min(), max(np.ptp(height), 1e-12)
        layer = np.minimum(((height - low) / extent * bins).astype(int), bins - 1)
        nearest, farthest = np.full(bins, np.inf), np.full(bins, -np.inf)
        np.minimum.at(nearest, layer, radius)
        np.maximum.at(farthest, layer, radius)
        held = farthest >= 0
        middles = low + extent * (np.arange(bins) + 0.5) / bins
        return middles[held], nearest[held], farthest[held]

    def density(self, bins: int = 120) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """How often each place is reached, by distance from the base's z axis and height.

        Returns
        -------
        counts : array, shape (bins, bins)
            Points per unit of volume, as a part of the largest.
        radii, heights : arrays, shape (bins + 1,)
            Edges of the cells.
        """
        counts, radii, heights = np.histogram2d(*self.radii_and_heights(),
                                                bins=inputs.whole("bins", bins, 1))
        counts /= np.diff(radii[:, None] ** 2, axis=0)  # outer rings are larger
        return counts / counts.max(), radii, heights


def workspace(arm: Arm, samples: int = 100_000, *, seed: int = 0,
              progress: Callable[[int, int], Any] | None = None) -> Workspace:
    """Where the tool gets when every joint sweeps its range.

    Joint values follow an additive recurrence (the R sequence), which fills the ranges more
    evenly than random numbers do. A revolute joint without limits makes a whole turn.

    Parameters
    ----------
    arm : Arm
    samples : int
        How many poses.
    seed : int
        Where the sequence begins: the same seed gives the same points.
    progress : callable, optional
        Called with how many poses are done and how many there are. Left out, a bar appears in
        a notebook or a terminal once the work has taken a second, and goes when it is done.

    Returns
    -------
    Workspace

    Raises
    ------
    ValueError
        If a prismatic joint has no limits.

    Examples
    --------
    >>> from kinlab import robots
    >>> reached = workspace(robots.two_link(), 10_000)
    >>> bool(abs(np.linalg.norm(reached.points, axis=1).max() - 2) < 1e-3)
    True
    """
    check_arm(arm)
    samples, seed = inputs.whole("samples", samples, 1), inputs.whole("seed", seed, 0)
    if any(link.kind == PRISMATIC and link.limits is None for link in arm.links):
        raise ValueError("arm: expected limits on every prismatic joint, got one without; "
                         "give prismatic(limits=(lowest, highest))")
    low, high = joint_limits(arm, turn=WHOLE_TURN)[..., None]
    motions, points = tuple(chain(*arm.chain)), np.empty((samples, 3))
    with ProgressBar("workspace") as bar:
        report = progress or bar
        for start in range(0, samples, CHUNK):
            part = points[start:start + CHUNK]
            q = low + (high - low) * r_sequence(arm.n, start, len(part), seed)
            for i, component in enumerate(follow(motions, q).origin):
                part[:, i] = component
            report(start + len(part), samples)
    return Workspace(arm, points)


def r_sequence(dimensions: int, start: int, count: int, seed: int) -> np.ndarray:
    """Evenly spread numbers in [0, 1), shape (dimensions, count), from number `start` on.

    After M. Roberts (2018): steps are powers of 1/g, where g^(dimensions + 1) = g + 1.
    """
    g = 2.0
    for _ in range(60):
        g = (1 + g) ** (1 / (dimensions + 1))
    steps = g ** -np.arange(1.0, dimensions + 1)[:, None]
    offset = np.random.default_rng(seed).random((dimensions, 1))
    return (offset + steps * np.arange(start, start + count)) % 1.0


class ProgressBar(ExitStack):
    """tqdm's bar, made once the work has taken a while; as a context it leaves nothing behind.

    With tqdm's own `delay`, short work in a notebook would make the bar's widgets too, and what
    `leave=False` leaves there is still saved. So a cell's output is the same whether its work was
    long or short.
    """

    def __init__(self, title: str) -> None:
        super().__init__()
        self.title, self.begun = title, time.perf_counter()
        self.bar: Any = None

    def __call__(self, done: int, total: int) -> None:
        if self.bar is None and done < total and time.perf_counter() - self.begun > PATIENCE:
            self.bar = self._shown(done, total)
        if self.bar is not None:
            self.bar.update(done - self.bar.n)

    def _shown(self, done: int, total: int) -> Any:
        from tqdm.auto import tqdm  # late: short work and `import kinlab` do without

        class Bar(tqdm):
            monitor_interval = 0  # no thread beside it: a browser's Python has none

        # With a delay, tqdm waits for the first refresh: a notebook's bar can be shown here, in a
        # place that is emptied.
        bar = self.enter_context(Bar(desc=self.title, initial=done, total=total, leave=False,
                                     delay=1e-9, disable=None if sys.stderr else True))
        if hasattr(bar, "container"):
            bar.displayed, place = True, vars(builtins)["display"](bar.container, display_id=True)
            self.callback(place.update, {}, raw=True)
            for part in (*bar.container.children, bar.container):
                self.callback(part.close)
        bar.refresh()
        return bar
