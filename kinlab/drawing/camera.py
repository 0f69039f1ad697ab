"""Where a picture is seen from, and how the room is framed: the camera and what it makes of points.

kinlab/browser/camera.js does the same in the browser.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..arms.motions import Numbers
from .scene import Fit, Scene

Extents = Sequence[tuple[Numbers, float]]   # balls: middle in the room, and radius

_DISTANCE = 3.4                 # of the viewer, in radii of the scene
_NEAREST = 0.2                  # of it: what is nearer stays before the viewer
_MARGIN = 10.0                  # px: half a name of an axis
_ROOM, _LEAST, _MOST = 0.075, 24.0, 50.0    # of a side, and px: room for names
_BOX, _BALL = 0.5, 1.5          # in radii: the least box, and the least ball
_SOFT = 0.2                     # radii over which one bound relieves another


@dataclass(frozen=True)
class Camera:
    """Where a picture is seen from; angles in degrees."""

    azimuth: float
    elevation: float
    zoom: float = 1.0
    perspective: bool = False

    @property
    def axes(self) -> np.ndarray:
        """Rows right, up and towards the viewer, as directions of the room."""
        a, e = np.radians([self.azimuth, self.elevation])
        ca, sa, ce, se = np.cos(a), np.sin(a), np.cos(e), np.sin(e)
        return np.array([[-sa, ca, 0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]])


@dataclass(frozen=True, eq=False)
class _Gaze:
    """Axes of a camera, the point it looks at, and one over the viewer's distance from there."""

    axes: np.ndarray
    middle: np.ndarray
    closer: float

    def ahead(self, d: np.ndarray) -> np.ndarray:
        """How far before the viewer points lie, as a part of the middle's distance."""
        return np.maximum(_NEAREST, 1 - self.closer * (d @ self.axes[2]))

    def spans(self, balls: Extents) -> np.ndarray:
        """How far balls reach to the right and up on a picture of scale 1: rows low, high.

        At least to the middle.
        """
        if not len(balls):
            return np.zeros((2, 2))
        points, radii = zip(*balls)
        d, radius = np.array(points) - self.middle, np.array(radii)[:, None]
        x, f = d @ self.axes[:2].T, 1 / self.ahead(d)[:, None]
        low, high = f * (x - radius), f * (x + radius)
        return np.stack([np.minimum(0, low.min(axis=0)), np.maximum(0, high.max(axis=0))], axis=1)


@dataclass(frozen=True, eq=False)
class Lens:
    """What a camera makes of the room at one pose.

    Directions and points of the room have shape (..., 3). `scale` is in pixels per length unit
    where things have their own size, `shrunk` that scale as a part of the scale at home; `heart`
    is the place on the picture (px) of the point that the camera looks at.
    """

    right: np.ndarray
    up: np.ndarray
    near: np.ndarray
    scale: float
    shrunk: float
    heart: np.ndarray
    gaze: _Gaze

    def see(self, points: Numbers) -> np.ndarray:
        """Right and down on the picture (px), and the size of things there, 1 at the middle."""
        seen = (np.asarray(points, dtype=float) - self.gaze.middle) @ self.gaze.axes.T
        size = 1 / np.maximum(_NEAREST, 1 - self.gaze.closer * seen[..., 2])
        seen *= (self.scale * size)[..., None]
        seen[..., 1] *= -1
        seen[..., :2] += self.heart
        seen[..., 2] = size
        return seen

    def eye(self, points: Numbers) -> np.ndarray:
        """Directions from points to the viewer, not of unit length."""
        return self.near + self.gaze.closer * (self.gaze.middle - np.asarray(points, dtype=float))

    def turn(self, directions: Numbers) -> np.ndarray:
        """Components of directions to the right, up and towards the viewer."""
        return np.asarray(directions, dtype=float) @ self.gaze.axes.T


def lens(scene: Scene, camera: Camera, size: tuple[float, float], extents: Extents = (),
         home: Extents = (), middle: Numbers | None = None) -> Lens:
    """The lens for a picture of a size (px).

    A scene with a `fit` is framed round `extents`, the balls that have to be seen; `home` are
    those at its home. Others stand with `middle`, their centre if left out, in its place.
    """
    middle = scene.center if middle is None else middle
    gaze = _gaze(scene, camera, scene.fit.middle if scene.fit else middle)
    scale, shrunk, heart = (
        _fitted(scene, scene.fit, camera, gaze, size, extents, home) if scene.fit
        else _standing(scene, camera, gaze, size))
    right, up, near = gaze.axes
    return Lens(right, up, near, scale, shrunk, heart, gaze)


def _gaze(scene: Scene, camera: Camera, middle: Numbers) -> _Gaze:
    closer = 1 / (_DISTANCE * scene.radius) if camera.perspective else 0.0
    return _Gaze(camera.axes, np.asarray(middle, dtype=float), closer)


def _standing(scene: Scene, camera: Camera, gaze: _Gaze,
              size: Sequence[float]) -> tuple[float, float, np.ndarray]:
    """The ball round a scene just fits the picture."""
    room = min(size)
    # In perspective a ball looks larger than the circle round its middle.
    ball = scene.radius / np.sqrt(1 - (gaze.closer * scene.radius) ** 2)
    scale = camera.zoom * max(room / 2 - _MARGIN, room / 4) / ball
    return float(scale), 1.0, np.array(size) / 2


def _fitted(scene: Scene, fit: Fit, camera: Camera, gaze: _Gaze, size: Sequence[float],
            extents: Extents, home: Extents) -> tuple[float, float, np.ndarray]:
    """The balls fill the picture, and none leaves it.

    What they need is joined smoothly with what home needs, from here and in the view that the
    scene begins with: what folds is not drawn larger.
    """
    sides, radius = np.array(size), fit.radius
    free = np.maximum(sides / 2, sides - 2 * np.clip(_ROOM * sides, _LEAST, _MOST))
    azimuth, elevation = scene.presets[scene.seen_from]
    first = _gaze(scene, replace(camera, azimuth=azimuth, elevation=elevation), gaze.middle)
    here, there = gaze.spans(home), first.spans(home)
    soft = _SOFT * radius / np.min(free)
    least = max(_BALL * radius / np.min(free), *_lengths_per_pixel(here, free),
                *_lengths_per_pixel(there, free))

    def needed(box: np.ndarray) -> float:
        wide, high = _lengths_per_pixel(box, free)
        return _smooth_max(_smooth_max(wide, high, soft), least, soft)

    box = _widened(gaze.spans(extents), radius)
    need = needed(box)
    off = camera.zoom * box.mean(axis=1) / need * [-1, 1]
    return float(camera.zoom / need), float(needed(_widened(here, radius)) / need), sides / 2 + off


def _lengths_per_pixel(box: np.ndarray, free: np.ndarray) -> np.ndarray:
    return np.diff(box)[:, 0] / free


def _widened(box: np.ndarray, radius: float) -> np.ndarray:
    """Spans that hold a box round the middle as well, and change smoothly."""
    return _smooth_max(np.abs(box), _BOX * radius, _SOFT * radius) * [-1, 1]


def _smooth_max(a: Any, b: Any, soft: float) -> Any:
    """A smooth maximum, never below either."""
    return (a + b + np.sqrt((a - b) ** 2 + soft**2)) / 2
