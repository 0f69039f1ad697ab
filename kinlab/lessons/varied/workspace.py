"""Lesson 09 with other numbers."""
from __future__ import annotations

from ...answers.varied import Draw, Varied
from ..workspace import design_judge, nearest_judge, wall_judge


def _ring(draw: Draw) -> dict[str, float]:
    """Radii of which the larger one is more than three times the smaller one."""
    return {"near": draw.whole(2, 7) / 10, "far": draw.whole(23, 29) / 10}


def _links(draw: Draw) -> dict[str, float]:
    return {"l_1": draw.whole(8, 16, but=(10,)) / 10, "l_2": draw.whole(3, 7, but=(6,)) / 10}


def _far_point(draw: Draw) -> dict[str, int]:
    return {"ahead": 10 * draw.whole(47, 65), "high": 10 * draw.whole(40, 60)}


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
