"""A cloud of dots in the room, cut open by a plane; the nearer, the stronger.

Dots lie on a lattice, and a letter stands for each coordinate: a page holds thousands of them.
"""
from __future__ import annotations

import numpy as np

from .readings import Point

SLICE = "slice"                 # the layer that cuts a cloud open while it is on
_FIRST = 0x100                  # code of the letter for the lowest place
FADES = (0.3, 0.45, 0.65, 0.9)  # of layers of dots, from far to near


def layers(dots: np.ndarray, plane: np.ndarray | None, near: np.ndarray, middle: np.ndarray,
           radius: float) -> list[np.ndarray]:
    """The dots in layers from far to near.

    With a frame `plane`, those on the negative side of its y axis are cut away. `near` is the
    direction towards the viewer, `middle` and `radius` are those of the cloud.
    """
    kept = dots
    if plane is not None:
        kept = dots[(dots - plane[:3, 3]) @ plane[:3, 1] >= -1e-9 * radius]
    depth = np.floor(((kept - middle) @ near / radius + 1) / 2 * len(FADES))
    layer = np.clip(depth, 0, len(FADES) - 1)
    return [kept[layer == k] for k in range(len(FADES))]


def packed(dots: np.ndarray, step: float) -> tuple[Point, str]:
    """Dots (m, 3) on a lattice of this step: its lowest corner in the room, and their letters."""
    x, y, z = corner = np.floor(dots.min(axis=0))
    places = np.round((dots - corner) / step).astype(int)
    return (0, float(x), float(y), float(z)), "".join(chr(_FIRST + k) for k in places.ravel())


def unpacked(corner: Point, letters: str, step: float) -> np.ndarray:
    """The dots that letters stand for, shape (m, 3)."""
    places = np.array([ord(letter) - _FIRST for letter in letters]).reshape(-1, 3)
    return np.array(corner[1:]) + step * places
