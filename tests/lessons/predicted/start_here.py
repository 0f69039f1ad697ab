"""What the predictions of "Start here" are held against."""
from math import cos, pi, sin

import kinlab as kl

from . import Held

TURNS, LIFTS, REACHES = ("joint 1: the column turns", "joint 2: the lift slides up and down",
                         "joint 3: the reach slides in and out")
NONE, ONE, TWO, MANY = "none", "one", "two", "infinitely many"
SILENT = "θ₁ is 213°, and nobody says a word"


def tip(*degrees):
    """Of the two-link arm, by hand."""
    first, second = (angle * pi / 180 for angle in degrees)
    return [cos(first) + cos(first + second), sin(first) + sin(first + second), 0]


def cylindrical(turn, reach):
    q = [turn * pi / 180, 0.3, reach]
    return kl.forward_kinematics(kl.robots.cylindrical(), q)[:3, 3].tolist()


PREDICTED = {
    "start_here.joints": [
        Held([LIFTS], [([LIFTS, TURNS], "keeps height and distance"),
                       ([REACHES], "is missing. The lift moves the tool along z₀ only")]),
        Held([REACHES], [([REACHES, TURNS], "keeps height"), ([], "away from the column")]),
        Held([TURNS], [([LIFTS], "turns the tool"), ([TURNS, REACHES], "does not belong")])],
    "start_here.column": [
        Held(cylindrical(90, 0.3), [([0, -0.3, 0.7], "clockwise"), ([0.3, 0, 0.7], "y = 0, 0.3")]),
        Held([0, -0.5, 0.7], [([0, 0.5, 0.7], "counterclockwise"), ([0.5, 0, 0.7], "away")]),
        Held([-0.4, 0, 0.7], [([0, 0.4, 0.7], "half of the turn"), ([0, -0.4, 0.7], "away")])],
    "start_here.tip": [
        Held(tip(90, 90), [([0, 2, 0], "measured from x₀"), ([1, 1, 0], "−1, 1 m")]),
        Held([1, -1, 0], [([1, 1, 0], "counterclockwise"), ([-1, -1, 0], "1, −1 m")]),
        Held(tip(180, 90), [([-1, 1, 0], "measured from x₀"), ([1, 1, 0], "−1, −1 m")])],
    "start_here.ring": [
        Held(90, [(45, "as the base sees it"), (-90, "to the other side"), (0, "90° off")]),
        Held(-90, [(45, "as the base sees it"), (90, "to the other side"),
                   (0, "both links point up")])],
    "start_here.ways": [
        Held(TWO, [(NONE, "1.41 m"), (ONE, "Mirror the arm"), (MANY, "meet in two points")]),
        Held(ONE, [(TWO, "Try to bend"), (NONE, "Stretch")]),
        Held(NONE, [(ONE, "How far"), (MANY, "How far")]),
        Held(MANY, [(NONE, "Fold the arm."), (TWO, "then turn it")])],
    "start_here.pointing": [
        Held(0, [(-90, "measured from the first link"), (90, "where the first link points")]),
        Held(180, [(90, "bends on from there"), (0, "180° off")]),
        Held(90, [(-30, "measured from the first link"), (120, "where the first link points")])],
    "start_here.way": [
        Held(tip(30, 30), [([3 ** 0.5, 1, 0], "both links would point the same way"),
                           ([2, 0, 0], "away")]),
        Held([0, 3 ** 0.5, 0], [([1, 3 ** 0.5, 0], "the same way"), ([2, 0, 0], "away")]),
        Held([0, -3 ** 0.5, 0], [([1, -3 ** 0.5, 0], "the same way"), ([0, 3 ** 0.5, 0], "away")])],
    "start_here.radians": [
        Held(SILENT, [("θ₁ is 10°", "Sliders read degrees"),
                      ("kinlab stops with an error", "10 is a good angle"),
                      ("θ₁ is 0.17°", "takes the 10 as it is")])],
}
