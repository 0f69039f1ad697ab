"""Lesson 01 with other numbers."""
from __future__ import annotations

from ...answers.varied import Draw, Varied
from ..translation import between_judge, there_and_back_judge

Pair = tuple[int, int]


def _there_and_back(draw: Draw) -> dict[str, Pair]:
    """Three points whose coordinates are all different, so that no slip looks right."""
    x, y = draw.whole(1, 4), -draw.whole(1, 4)
    c_x = -draw.whole(1, 5, but=(0, x))
    return {"o": (x, y), "c_1": (c_x, draw.whole(2, 6, but=(0, c_x))),
            "d_0": (draw.whole(-3, 6, but=(0, x, 2 * x)), draw.whole(1, 5))}


def _between(draw: Draw) -> dict[str, Pair]:
    """Two points with whole numbers midway between them, and that not at the origin."""
    middle, half = (draw.whole(1, 3), draw.whole(1, 3)), (draw.whole(1, 3), -draw.whole(1, 3))
    return {"c": (middle[0] + half[0], middle[1] + half[1]),
            "d": (middle[0] - half[0], middle[1] - half[1])}


VARIED = {
    "translation.1": Varied(
        lambda o, c_1, d_0: (
            f"The origin of frame 1 is at $o_1^0 = {o}$, and the axes are parallel. Give a list of "
            f"three points, each a list `[x, y]`.\n\n"
            f"- The point $c$ has $c^1 = {c_1}$. What is $c^0$?\n"
            f"- The point $d$ has $d^0 = {d_0}$. What is $d^1$?\n"
            "- Where does frame 1 see the origin of frame 0, $o_0^1$?"),
        _there_and_back, there_and_back_judge),
    "translation.3": Varied(
        lambda c, d: (
            f"Two points stay in the room at $c^0 = {c}$ and $d^0 = {d}$. Slide frame 1 so that it "
            "sees them in exactly opposite directions, equally far away: $c^1 = -d^1$. Where is "
            "$o_1^0$? A list `[x, y]`."),
        _between, between_judge),
}
