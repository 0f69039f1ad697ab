"""Lesson 00 with other numbers."""
from __future__ import annotations

from math import cos, radians, sin

from ...answers.varied import Draw, Varied
from ..start_here import PARTS, two_ways_judge, units_judge


def _units(draw: Draw) -> dict[str, int]:
    return {"turn": draw.one_of([30, 45, 70, 75, 80, 90, 100, 120]),
            "lift": draw.one_of(list(PARTS)), "reach": draw.one_of([15, 35, 45])}


def _target(draw: Draw) -> dict[str, tuple[float, float]]:
    first, bend = radians(5 * draw.whole(1, 9)), radians(5 * draw.whole(10, 19))
    return {"target": (round(cos(first) + cos(first + bend), 2),
                       round(sin(first) + sin(first + bend), 2))}


VARIED = {
    "start_here.2": Varied(
        lambda turn, lift, reach: (
            f"Set the cylindrical arm to $\\theta_1 = {turn}°$, lift $d_2 = {lift}$ mm, reach "
            f"$d_3 = {reach}$ cm. Write the joint values as `kl.forward_kinematics` wants them."),
        _units, units_judge),
    "start_here.5": Varied(
        lambda target: (
            f"The tip of the two-link arm, with two links of 1 m, must come within 2 cm of "
            f"$({target[0]:g},\\; {target[1]:g})$. Find both pairs $(\\theta_1, \\theta_2)$, in "
            "radians: `[[..., ...], [..., ...]]`."),
        _target, two_ways_judge),
}
