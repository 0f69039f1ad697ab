"""Lesson 03b with other numbers."""
from __future__ import annotations

from math import radians
from typing import Any

from ...answers.judges import Judge
from ...answers.varied import Draw, Varied
from ...arms.transforms import homogeneous, rotation_2d
from ..notation import missing_judge


def _two_poses(draw: Draw) -> dict[str, Any]:
    return {"turn_1": draw.one_of([30, 60, 90, -60]), "turn_2": draw.one_of([45, 120, 150, -30]),
            "o_1": (draw.whole(1, 3), draw.whole(1, 3)), "o_2": (draw.whole(1, 4),
                                                                draw.whole(4, 6))}


def _judge(turn_1: float, turn_2: float, o_1: Any, o_2: Any) -> Judge:
    return missing_judge(*(homogeneous(rotation_2d(radians(turn)), o)
                           for turn, o in ((turn_1, o_1), (turn_2, o_2))))


VARIED = {
    "notation.3": Varied(
        lambda turn_1, turn_2, o_1, o_2: (
            f"In the plane frame 1 is turned by {turn_1}°, with its origin at {o_1}; frame 2 is "
            f"turned by {turn_2}°, with its origin at {o_2}. Both are seen from frame 0. You need "
            "the pose of frame 2, seen from frame 1: `T_12`, a $3 \\times 3$ array."),
        _two_poses, _judge),
}
