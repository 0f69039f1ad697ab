"""Lesson 07 with other numbers."""
from __future__ import annotations

from ...answers.varied import Varied
from ..alpha_ii import table_judge

VARIED = {
    "alpha_ii.4": Varied(
        lambda height: (
            "Find joint values of the Alpha II, **in radians**, for which the tool points straight "
            f"down (within 0.01°), its tip touches a table at $z = {height}$ mm (within 0.5 mm), "
            "and every joint is inside its limits."),
        lambda draw: {"height": draw.whole(10, 120)}, table_judge),
}
