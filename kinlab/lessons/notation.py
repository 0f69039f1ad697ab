"""Lesson 03b, notation: its view, predictions, exercises' references and typical slips."""
from __future__ import annotations

from math import radians

import numpy as np

from ..answers.judges import Judge, choices, values
from ..answers.prediction import Asked, Choice, Direction, Mark, Number
from ..arms.transforms import homogeneous, inverse, rotation_2d
from ..drawing.controls import Knob
from ..drawing.scene import at
from ..drawing.sketch import Sketch
from ..views.live import LiveView
from .asked import angle, pair

# ---- View: a pose in the plane ---------------------------------------------------------------


def pose_view() -> LiveView:
    """Frame 1, seen from frame 0, and a point at (1, 0) of frame 1."""
    sketch = Sketch("A pose, and a point in its frame", 3.5)
    sketch.follows = True
    sketch.axes("0", 0, 1.0)
    x, y = (sketch.knob(Knob.length(f"o_{axis}", label, -2.5, 2.5, -1))
            for axis, label in zip("xy", ("oₓ", "oᵧ")))
    frame = sketch.frame("1", x=x, y=y, theta=sketch.theta(1, 0), length=1.0)
    point = sketch.point("p", frame, (1, 0))
    sketch.arrow("arrow-o", at(0, (0, 0, 0))[0], at(frame, (0, 0, 0))[0], "length")
    x_1, y_1 = at(frame, (1, 0, 0), (0, 1, 0))
    sketch.reading("axes", "columns of T₀₁: x₁ = {}, y₁ = {},", sketch.vector(frame, x_1),
                   sketch.vector(frame, y_1))
    sketch.reading("origin", "and its origin o₁⁰ = {}", sketch.vector(0, frame))
    sketch.reading("p", "p⁰ = {}, p¹ = {}", sketch.vector(0, point),
                   sketch.vector(frame, point, frame))
    sketch.decimals = 2
    return LiveView(sketch.scene())


# ---- Predictions -----------------------------------------------------------------------------


def _posed(theta: float, x: float, y: float) -> dict[str, float]:
    return {"theta_1": theta, "o_x": x, "o_y": y}


def _points(axis: str, theta: float, rows: str, begin: float, why: str,
            *slips: tuple[float, str]) -> Direction:
    """Where an axis points, by the columns of a matrix."""
    return Direction(
        ask=f"The rows of T₀₁ are {rows} and (0, 0, 1). Which way does {axis}₁ point, as frame 0 "
            "sees it?",
        why=why, start=_posed(0, -1, -1), shows=_posed(theta, 2, 1), of=f"frame-1-{axis}",
        begin=begin, slips=slips)


def _lands(theta: float, origin: tuple[float, float], why: str) -> Mark:
    """Where a point of frame 1 is in frame 0."""
    x, y = origin
    return Mark(
        ask=f"The origin of frame 1 is at {pair(x, y)}. The frame turns by {angle(theta)} and "
            "takes the point p¹ = (1, 0) along. Where is p then, as frame 0 sees it?",
        why=why, start=_posed(0, x, y), shows=_posed(theta, x, y), of="point-p", tolerance=0.25,
        slips=[((x + 1, y, 0), "You added p¹ as it is. It is measured along x₁, which has turned."),
               ((x, y, 0), "That is the origin of frame 1; the point is one step along x₁."),
               ((1, 0, 0), "That is p¹, measured from frame 0.")])


def _back(theta: float, origin: tuple[float, float], point: tuple[float, float], right: float,
          why: str, *slips: tuple[float, str]) -> Number:
    """The first coordinate that frame 1 sees."""
    return Number(
        ask=f"Frame 1 is turned by {angle(theta)}, and its origin is at {pair(*origin)}. A "
            f"bolt is at {pair(*point)} in frame 0. What is its coordinate along x₁, in frame 1?",
        why=why, start=_posed(theta, *origin), right=right, tolerance=0.05, slips=slips)


def _name(symbol: str, source: str, right: str, wrong: str, why: str) -> Choice:
    """Which pose a symbol stands for."""
    poses = dict(sorted({right: "", wrong: "The other way round."}.items(), reverse=True))
    never = {"it depends on the page": "Each of the lectures keeps its own habit on all its pages."}
    return Choice(ask=f"{source} writes {symbol}. What is it?", why=why, right=right,
                  options=poses | never)


def _factor(product: str, right: str, why: str, **said: str) -> Choice:
    """The factor that is missing."""
    return Choice(ask=f"{product} Which factor is missing?", why=why, right=right,
                  options=dict(sorted((said | {right: ""}).items())))


_FROM_0 = "the pose of frame 3, seen from frame 0"
_FROM_3 = "the pose of frame 0, seen from frame 3"

PREDICTIONS: dict[str, Asked] = {
    "notation.columns": Asked(pose_view, [
        _points("y", 90, "(0, −1, 2), (1, 0, 1)", 0,
                "The second column is y₁ = (−1, 0): it points to the left.",
                (90, "That is x₁, the first column."),
                (0, "Read down the column, (−1, 0), not along the row.")),
        _points("x", -90, "(0, 1, 2), (−1, 0, 1)", 180,
                "The first column is x₁ = (0, −1): it points down.",
                (0, "That is y₁, the second column."),
                (90, "Read down the column, (0, −1), not along the row.")),
        _points("y", 180, "(−1, 0, 2), (0, −1, 1)", 0,
                "The second column is y₁ = (0, −1): it points down.",
                (180, "That is x₁, the first column."))]),
    "notation.landing": Asked(pose_view, [
        _lands(90, (2, 1), "x₁ points along y₀: one step from (2, 1) along it is (2, 2)."),
        _lands(-90, (-1, 1.5), "x₁ points against y₀: one step from (−1, 1.5) along it is "
                               "(−1, 0.5)."),
        _lands(180, (1.5, 2), "x₁ points against x₀: one step from (1.5, 2) along it is "
                              "(0.5, 2).")]),
    "notation.back": Asked(pose_view, [
        _back(90, (2, 1), (2, 2.5), 1.5, "From (2, 1) the bolt is 1.5 along y₀, and that is x₁.",
              (0, "You subtracted the origin; now measure along x₁, which points along y₀."),
              (2, "You left frame 0's coordinate as it is.")),
        _back(180, (1, 1), (-1, 1), 2, "From (1, 1) the bolt is 2 against x₀, and x₁ points that "
                                       "way.",
              (-2, "You subtracted the origin; now measure along x₁, which points against x₀.")),
        _back(-90, (-1, 1), (-1, -1), 2, "From (−1, 1) the bolt is 2 against y₀, and x₁ points "
                                         "that way.",
              (0, "You subtracted the origin; now measure along x₁, which points against y₀."),
              (-2, "x₁ points against y₀, so the coordinate along it is positive."))]),
    "notation.names": Asked(None, [
        _name("H₃⁰", "Robotics and Controls", _FROM_0, _FROM_3,
              "In Robotics and Controls the upper index is the frame you look from."),
        _name("T₃⁰", "Lecture 2.8", _FROM_3, _FROM_0,
              "In lecture 2.8 the lower index is the frame you look from: here 3."),
        _name("⁰T₃", "Forward and inverse kinematics", _FROM_0, _FROM_3,
              "With an index on each side, the one on the left is the frame you look from."),
        _name("T_30", "kinlab", _FROM_3, _FROM_0, "kinlab writes the frame you look from first.")]),
    "notation.factor": Asked(None, [
        _factor("T_03 = T_01 @ ... @ T_23.", "T_12", "1 meets 1, and 2 meets 2; both drop out.",
                T_21="Then 1 would meet 2, twice.",
                T_13="Then 3 would meet the 2 of T_23.",
                T_02="Then 1 would meet 0."),
        _factor("p_0 = ... @ p_2.", "T_02", "The last index of the pose meets that of the point.",
                T_20="It takes coordinates in frame 0; p_2 has those in frame 2.",
                T_12="It gives coordinates in frame 1.",
                T_01="It takes coordinates in frame 1."),
        _factor("T_12 = ... @ T_02.", "T_10", "0 meets 0 and drops out: T_10 is the inverse of "
                "T_01.",
                T_01="Its last index, 1, would meet 0.",
                T_20="Its first index is 2; the product begins with 1.",
                T_21="Its last index, 1, would meet 0.")]),
    "notation.inverse": Asked(None, [Choice(
        ask="T_03 = T_01 @ T_12 @ T_23. Which product is its inverse, T_30?",
        why="T_32 @ T_21 @ T_10: neighbours agree, it begins with 3 and ends with 0.",
        options={"T_10 @ T_21 @ T_32": "Each factor is inverted, but 0 meets 2: reverse the order.",
                 "T_32 @ T_21 @ T_10": "",
                 "T_23 @ T_12 @ T_01": "The order is reversed, but no factor is inverted."},
        right="T_32 @ T_21 @ T_10")]),
}

# ---- Exercise 1: one pose, many names ------------------------------------------------------

_NOTATION_HINTS = {
    ("same pose", 1): "In Robotics and Controls the upper index is the frame you look from.",
    ("same pose", 2): "In Robotics and Controls the upper index is the frame you look from.",
    ("same pose", 3): "In lecture 2.8 the lower index is the frame you look from.",
    ("same pose", 4): "In lecture 2.8 the lower index is the frame you look from.",
    ("same pose", 5): "With an index on each side, the upper left one is the frame you look from.",
    ("same pose", 6): "kinlab writes the frame you look from first.",
}

# ---- Exercise 2: what fits together -------------------------------------------------------

_PRODUCT_HINTS = {
    ("meaningful", 1): "T_01 @ T_12: the inner indices are 1 and 1.",
    ("meaningful", 2): "T_12 @ T_01: the inner indices are 2 and 0.",
    ("meaningful", 3): "T_01 takes coordinates in frame 1. Which ones does p_0 hold?",
    ("meaningful", 4): "T_02 takes coordinates in frame 2, and p_2 holds just those.",
    ("meaningful", 5): "An inverse exchanges the two indices: what is the inverse of T_01?",
    ("meaningful", 6): "First exchange the indices of T_21, then compare the inner ones.",
}

# ---- Exercise 3: the pose that is missing --------------------------------------------------

T_01 = homogeneous(rotation_2d(radians(90)), [2, 1])
T_02 = homogeneous(rotation_2d(radians(120)), [1, 4])


def missing_judge(T_01: np.ndarray, T_02: np.ndarray) -> Judge:
    """Judge of the pose of frame 2 seen from frame 1, both being seen from frame 0."""
    T_12 = inverse(T_01) @ T_02
    slips = [
        ("The factors have changed places: T_02 @ T_10 has 2 and 1 as neighbours.",
         T_02 @ inverse(T_01)),
        ("The pose of frame 1 was not inverted: T_01 @ T_02 has 1 and 0 as neighbours.",
         T_01 @ T_02),
        ("The factors have changed places, and none is inverted: T_02 @ T_01.", T_02 @ T_01),
        ("This is T_21, the pose of frame 1 seen from frame 2: the inverse.", inverse(T_12)),
        ("This is T_02 itself. From which frame is it seen?", T_02),
        ("The origin is o_02 - o_01 with the axes of frame 0; frame 1 measures along its own "
         "axes.", homogeneous(T_12[:2, :2], T_02[:2, 2] - T_01[:2, 2])),
        ("A transpose inverts a rotation, not a pose: use kl.inverse.", T_01.T @ T_02),
    ]
    return values(
        T_12, entry=lambda index: f"row {index[0] + 1}, column {index[1] + 1} of T_12",
        slips=slips, praise="T_10 @ T_02: the two zeros are neighbours and drop out.")


JUDGES: dict[str, Judge] = {
    "notation.1": choices(
        {"same pose": {1, 3, 5, 6}}, {1, 2, 3, 4, 5, 6}, _NOTATION_HINTS, noun="symbol",
        praise="Four ways to write one pose: where frame 2 is, seen from frame 1."),
    "notation.2": choices(
        {"meaningful": {1, 4, 5, 6}}, {1, 2, 3, 4, 5, 6}, _PRODUCT_HINTS, noun="line",
        praise="Neighbouring indices must agree. The last line is T_01 @ T_12 in disguise."),
    "notation.3": missing_judge(T_01, T_02),
}
