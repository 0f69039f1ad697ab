"""Lesson 12 with other numbers."""
from __future__ import annotations

from ...answers.varied import Draw, Varied
from ..motion import cubic_judge


def _motion(draw: Draw) -> dict[str, int]:
    start = draw.one_of([-40, -20, 10, 20, 40])
    return {"start": start, "end": start + draw.one_of([60, 80, 90, 120]),
            "T": draw.one_of([2, 3, 4])}


VARIED = {
    "motion.1": Varied(
        lambda start, end, T: (
            f"A joint goes from ${start}°$ to ${end}°$ in {T} s, by a cubic, from rest to rest: "
            "$q(t) = a_0 + a_1 t + a_2 t^2 + a_3 t^3$, with $t$ in seconds and $q$ in **radians**. "
            "Give the four coefficients, $a_0$ first."),
        _motion, cubic_judge),
}
