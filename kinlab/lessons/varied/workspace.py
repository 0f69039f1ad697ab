"""Lesson 09 with other numbers."""
from __future__ import annotations

from ...answers.varied import Draw, Varied
from ..workspace import design_judge, nearest_judge, wall_judge


def _ring(draw: Draw) -> dict[str, float]:
    """Radii that are not three times each other: then a link would be as long as the hole."""
    return {"near": draw.one_of([0.2, 0.3, 0.5, 0.7]), "far": draw.one_of([1.4, 1.8, 2.0, 2.3])}


def _links(draw: Draw) -> dict[str, float]:
    return {"l_1": draw.one_of([0.9, 1.2, 1.5]), "l_2": draw.one_of([0.4, 0.5, 0.7, 0.8])}


def _far_point(draw: Draw) -> dict[str, int]:
    return {"ahead": draw.one_of([450, 500, 550, 650]), "high": draw.one_of([400, 450, 550, 600])}


VARIED = {
    "workspace.2": Varied(
        lambda near, far: (
            f"A two-link arm without limits must reach everything from {near} m to {far} m around "
            "its base, and nothing else. Choose $l_1$ and $l_2$, in metres: a list of two."),
        _ring, design_judge),
    "workspace.3": Varied(
        lambda l_1, l_2: (
            f"A straight wall runs along the $x$ axis. The arm has $l_1 = {l_1}$ m and "
            f"$l_2 = {l_2}$ m, and its elbow bends from $0°$ to $90°$. Find the *widest* limits of "
            "$\\theta_1$, the lowest and the highest value **in radians**, for which the tool "
            "never gets behind the wall: $y \\ge 0$ in every pose."),
        _links, wall_judge),
    "workspace.5": Varied(
        lambda ahead, high: (
            f"The point $({ahead}, 0, {high})$ mm is outside the workspace of the Alpha II. Which "
            "pose brings the tip nearest to it? Give the joint values **in radians**."),
        _far_point, nearest_judge),
}
