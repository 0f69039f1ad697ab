"""Lesson 11 with other numbers."""
from __future__ import annotations

from typing import Any

import numpy as np

from ...answers.judges import Judge
from ...answers.varied import Draw, Varied
from ...arms.euler import rpy_matrix
from ...arms.quaternions import rotation_about
from ..turns import axis_judge, locked_judge
from . import given, latex


def _turn(draw: Draw) -> dict[str, Any]:
    """An axis along whole numbers, and an angle that the trace tells from its half and double."""
    axis = draw.one_of([(1, 2, 2), (2, 1, -2), (-2, 2, 1), (2, 3, 6), (6, -2, 3), (3, 6, -2)])
    return {"axis": axis, "angle": draw.one_of([40, 50, 70, 80, 100, 110, 130])}


def _round(axis: Any, angle: float) -> np.ndarray:
    return rotation_about(axis, np.radians(angle))


def _axis_judge(axis: Any, angle: float) -> Judge:
    return axis_judge(_round(axis, angle))


def _locked(left: float) -> np.ndarray:
    return rpy_matrix(0, np.pi / 2, np.radians(left))


VARIED = {
    "turns.3": Varied(
        lambda **turn: (
            f"$$R = {latex(_round(**turn))}$$\n\n"
            "Give its axis, three numbers of length 1, and its angle in radians: `[axis, angle]`."),
        _turn, _axis_judge, lambda **turn: {"R": given(_round(**turn))}),
    "turns.5": Varied(
        lambda left: (
            f"$$R = {latex(_locked(left))}$$\n\n"
            "Give roll, pitch and yaw, in radians, so that `kl.rpy_matrix` makes this matrix of "
            "them. There are infinitely many right answers; give one."),
        lambda draw: {"left": draw.whole(15, 75, but=(45,))},
        lambda left: locked_judge(_locked(left)),
        lambda left: {"R": given(_locked(left))}),
}
