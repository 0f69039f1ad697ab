"""Lesson 02 with other numbers."""
from __future__ import annotations

from ...answers.varied import Draw, Varied
from ..rotation import read_off_judge, seen_judge

# Right triangles with whole sides: cosine and sine come out even.
_LEGS = [(0.6, 0.8), (0.8, 0.6), (0.28, 0.96), (0.96, 0.28), (0.352, 0.936), (0.936, 0.352)]
_AXES = [(right * x, up * y) for x, y in _LEGS for right in (1, -1) for up in (1, -1)][1:]


def _axis(draw: Draw) -> dict[str, tuple[float, float]]:
    return {"x_1": draw.one_of(_AXES)}


def _axis_and_point(draw: Draw) -> dict[str, tuple[float, float]]:
    x, y = draw.whole(1, 5), draw.whole(1, 5)
    return _axis(draw) | {"c_0": (x, y)}


VARIED = {
    "rotation.2": Varied(
        lambda x_1: (
            f"The axis $x_1$ of a frame points along $({x_1[0]},\\; {x_1[1]})$, seen from frame 0. "
            "Write $R_1^0$ as a $2 \\times 2$ array. You need no angle."),
        _axis, read_off_judge),
    "rotation.3": Varied(
        lambda x_1, c_0: (
            f"The axis $x_1$ of a frame points along $({x_1[0]},\\; {x_1[1]})$, seen from frame 0. "
            f"A point stands at $c^0 = {c_0}$. What are its coordinates $c^1$? Two numbers."),
        _axis_and_point, seen_judge),
}
