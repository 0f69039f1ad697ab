"""Lesson 04 with other numbers."""
from __future__ import annotations

from ...answers.varied import Varied
from ..two_link import level_judge

VARIED = {
    "two_link.4": Varied(
        lambda l_1, l_2: (
            f"Now $l_1 = {l_1:g}$ and $l_2 = {l_2:g}$. Find $\\theta_1$ and $\\theta_2$, **in "
            "radians**, for which link 2 points exactly against $x_0$ (within 0.01°) and $Q$ lies "
            "on the $y_0$ axis (within 0.001). Give one of the answers."),
        lambda draw: {"l_1": draw.one_of([2, 2.5, 3]), "l_2": draw.one_of([0.8, 1.2, 1.5, 1.6])},
        level_judge),
}
