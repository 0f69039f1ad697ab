"""Matrices that several lessons ask for: the link matrix, and how the entries are called."""
from __future__ import annotations

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import forward_kinematics
from ..arms.link import revolute


def link_matrix(theta: float, d: float, a: float, alpha: float,
                convention: str = "standard") -> np.ndarray:
    """The pose of a link's frame in the frame before it.

    Examples
    --------
    >>> link_matrix(0, 0.5, 0.2, 0)[:3, 3]
    array([0.2, 0. , 0.5])
    """
    return forward_kinematics(Arm([revolute(d=d, a=a, alpha=alpha)], convention=convention),
                              [theta])


def matrix_place(index: tuple[int, int]) -> str:
    """Where an entry of a matrix stands."""
    row, column = index
    return f"row {row + 1}, column {column + 1}"


def matrix_entry(index: tuple[int, int]) -> str:
    """What an entry of a matrix is called in a message."""
    return f"the entry in {matrix_place(index)}"
