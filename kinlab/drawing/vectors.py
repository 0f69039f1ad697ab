"""Arithmetic with single vectors: numpy's own norm and cross product take longer to be called."""
from __future__ import annotations

import math

import numpy as np


def norm(vector: np.ndarray) -> float:
    """The length of a vector."""
    return math.sqrt(vector @ vector)


def unit(vector: np.ndarray) -> np.ndarray:
    """The direction of a vector; one without length stays what it is."""
    return vector / (norm(vector) or 1.0)


def cross(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """The cross product of two vectors."""
    (a, b, c), (d, e, f) = one.tolist(), other.tolist()
    return np.array((b * f - c * e, c * d - a * f, a * e - b * d))
