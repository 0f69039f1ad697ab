"""What the predictions of "Notation" are held against: matrices, and what the lectures write."""
import numpy as np

from . import Held

FROM_0, FROM_3 = "the pose of frame 3, seen from frame 0", "the pose of frame 0, seen from frame 3"
LEAVE = "it depends on the page"


def T(theta, x, y):
    c, s = np.cos(np.radians(theta)), np.sin(np.radians(theta))
    return np.array([[c, -s, x], [s, c, y], [0, 0, 1]])


def landed(theta, x, y):
    """Where (1, 0) of frame 1 is in frame 0, in the plane of the room."""
    return [*(T(theta, x, y) @ (1, 0, 1))[:2].tolist(), 0]


def seen(theta, x, y, *point):
    """The first coordinate of a point of frame 0 in frame 1."""
    return np.linalg.solve(T(theta, x, y), (*point, 1))[0]


PREDICTED = {
    "notation.columns": [
        Held(180, [(90, "first column"), (0, "not along the row"), (-90, "90° off")]),
        Held(-90, [(0, "second column"), (90, "not along the row")]),
        Held(-90, [(180, "first column"), (0, "90° off")])],
    "notation.landing": [
        Held(landed(90, 2, 1), [([3, 1, 0], "which has turned"), ([2, 1, 0], "origin of frame 1"),
                                ([1, 0, 0], "measured from frame 0")]),
        Held([-1, 0.5, 0], [([0, 1.5, 0], "which has turned"), ([-1, 1.5, 0], "one step along")]),
        Held([0.5, 2, 0], [([2.5, 2, 0], "which has turned"), ([1.5, 2, 0], "one step along")])],
    "notation.back": [
        Held(seen(90, 2, 1, 2, 2.5), [(0, "points along y₀"), (2, "as it is")]),
        Held(seen(180, 1, 1, -1, 1), [(-2, "points against x₀"), (0, "too little")]),
        Held(seen(-90, -1, 1, -1, -1), [(0, "points against y₀"), (-2, "is positive")])],
    "notation.names": [
        Held(FROM_0, [(FROM_3, "The other way round"), (LEAVE, "its own habit")]),
        Held(FROM_3, [(FROM_0, "The other way round"), (LEAVE, "its own habit")]),
        Held(FROM_0, [(FROM_3, "The other way round"), (LEAVE, "its own habit")]),
        Held(FROM_3, [(FROM_0, "The other way round"), (LEAVE, "its own habit")])],
    "notation.factor": [
        Held("T_12", [("T_21", "twice"), ("T_13", "3 would meet"), ("T_02", "would meet 0")]),
        Held("T_02", [("T_20", "in frame 0"), ("T_12", "in frame 1"), ("T_01", "in frame 1")]),
        Held("T_10", [("T_01", "would meet 0"), ("T_20", "begins with 1"), ("T_21", "meet 0")])],
    "notation.inverse": [
        Held("T_32 @ T_21 @ T_10", [("T_10 @ T_21 @ T_32", "reverse the order"),
                                    ("T_23 @ T_12 @ T_01", "no factor is inverted")])],
}
