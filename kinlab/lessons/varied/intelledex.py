"""Lesson 08 with other numbers."""
from __future__ import annotations

from ...answers.varied import Varied
from ..intelledex import yaw_judge

VARIED = {
    "intelledex.4": Varied(
        lambda yaw: (
            "Find joint values of the Intelledex 660T, **in radians**, for which the wrist $O_5$ "
            "stays where it is at soft home, $(609.6, 0, 373.4)$, within 0.1 mm, and the tool "
            f"points level and {yaw}° to the left, within 0.01°."),
        lambda draw: {"yaw": draw.whole(10, 60, but=(45,))}, yaw_judge),
}
