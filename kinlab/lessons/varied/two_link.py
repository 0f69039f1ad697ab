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
        lambda draw: {"l_1": draw.whole(18, 32) / 10, "l_2": draw.whole(6, 16, but=(10,)) / 10},
        level_judge),
}
