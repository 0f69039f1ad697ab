"""Lesson 05 with other numbers."""
from __future__ import annotations

import numpy as np

from ...answers.matrices import link_matrix
from ...answers.varied import Draw, Varied
from ..dh_recipe import lost_row_judge
from . import given, latex


def _row(draw: Draw) -> dict[str, float]:
    """theta beyond 90° and a below 0: the row that the two obvious ways miss."""
    return {"theta": draw.one_of([120, 150]), "d": draw.one_of([0.2, 0.3, 0.6, 0.7]),
            "a": draw.one_of([-0.4, -0.5, -0.8]), "alpha": draw.one_of([-60, -30, 30, 60])}


def _matrix(theta: float, d: float, a: float, alpha: float) -> np.ndarray:
    return link_matrix(np.radians(theta), d, a, np.radians(alpha))


VARIED = {
    "dh_recipe.6": Varied(
        lambda **row: (
            "Someone hands you a link matrix and has lost its table:\n\n"
            f"$$T = {latex(_matrix(**row))}$$\n\n"
            "Find $\\theta, d, a, \\alpha$ (angles in radians). Each angle is a multiple of 30°: "
            "give it exactly, with `np.radians`."),
        _row, lost_row_judge, lambda **row: {"T": given(_matrix(**row))}),
}
