"""Lesson 10 with other numbers."""
from __future__ import annotations

from ...answers.varied import Draw, Varied
from ..inverse import both_ways_judge, pick_judge


def _point(draw: Draw) -> dict[str, float]:
    return {"x": draw.whole(4, 13) / 10, "y": draw.whole(5, 13) / 10}


def _part(draw: Draw) -> dict[str, int]:
    """On the floor in front of the arm, not on the diagonal: x and y can be told apart."""
    return {"x": draw.one_of([130, 140, 150]), "y": draw.one_of([70, 80, 90, -80]),
            "z": draw.one_of([20, 30, 50, 60])}


VARIED = {
    "inverse.4": Varied(
        lambda x, y: (
            "Find both answers of the two-link arm, with two links of 1 m, for the point "
            f"$({x}, {y})$ by geometry, **in radians**, as two rows $(\\theta_1, \\theta_2)$."),
        _point, both_ways_judge),
    "inverse.5": Varied(
        lambda x, y, z: (
            f"A small part lies at $({x}, {y}, {z})$ mm. The Alpha II must take it from straight "
            "above: its tip at the part, its approach vector pointing down, all joints within "
            "their limits. Give the joint values in radians."),
        _part, pick_judge),
}
