"""Lesson 04: by sums of complex numbers, a link each, and by hand where a hand is quick."""
from cmath import exp
from itertools import accumulate
from math import degrees, radians

from . import Held


def ends(lengths, angles):
    """Ends of the links of a planar arm (x, y, 0), each turned by all angles (degrees) so far."""
    turned = accumulate(map(radians, angles))
    points = accumulate(length * exp(1j * turn) for length, turn in zip(lengths, turned))
    return [(point.real, point.imag, 0.0) for point in points]


def tip(*angles, lengths=(2, 1.5)):
    return ends(lengths, angles)[-1]


def middle(*angles):
    return ends((2, 0.75), angles)[-1]


def four(*angles):
    return ends((1.2,) * 4, angles)[-1]


def bearing(*angles):
    return degrees(sum(map(radians, angles)))


PREDICTED = {
    "two_link.tip": [
        Held(tip(90, -90), [((0, 0.5, 0), "counts θ₂ from x₀"), ((-1.5, 2, 0), "counter-clockwise"),
                            ((0, 3.5, 0), "θ₂ = 0")]),
        Held(tip(180, -90), [((-2, -1.5, 0), "counts θ₂ from x₀"), ((-3.5, 0, 0), "θ₂ = 0")]),
        Held(tip(-90, 90), [((0, -0.5, 0), "counts θ₂ from x₀"), ((-1.5, -2, 0), "clockwise"),
                            ((3, 3, 0), "away")])],
    "two_link.bearing": [
        Held(bearing(60, 30), [(30, "rides on link 1"), (60, "That is link 1"), (-90, "180° off")]),
        Held(bearing(90, -45), [(-45, "rides on link 1"), (90, "That is link 1"),
                                (135, "clockwise")]),
        Held(bearing(150, 60), [(60, "rides on link 1"), (150, "That is link 1")])],
    "two_link.origin": [Held("(l₁, 0)", [("(0, 0)", "frame 1 itself"),
                                         ("(l₁ cos θ₁, l₁ sin θ₁)", "from frame 0")])],
    "two_link.sum": [Held("cos(θ₁ + θ₂)", [("cos(θ₁ − θ₂)", "a plus"),
                                           ("sin(θ₁ + θ₂)", "mixes")])],
    "two_link.special": [Held("θ₁ + θ₂ = 45°", [
        ("both angles are positive", "30° and 40°"), ("l₁ is longer than l₂", "in the angles"),
        ("nothing, so all three are right", "the printed y is l₂")])],
    "two_link.second": [
        Held(bearing(30, 60) + 90, [(90, "That is x₂"), (150, "θ₂ alone"), (120, "θ₁ alone")]),
        Held(bearing(-60, -30) + 90, [(-90, "That is x₂"), (60, "θ₂ alone"), (30, "θ₁ alone")])],
    "two_link.middle": [
        Held(middle(0, 90), [((2, 1.5, 0), "That is Q"), ((0.75, 2, 0), "before joint 2"),
                             ((2, -0.75, 0), "clockwise")]),
        Held(middle(90, 0), [((0, 3.5, 0), "That is Q"), ((2, 0.75, 0), "turns joint 2"),
                             ((0.75, 2, 0), "rides on link 1")])],
    "two_link.phi": [Held(["φ₂", "φ₃", "φ₄"], [(["φ₂"], "hangs on link 2"),
                                               (["φ₁", "φ₂", "φ₃", "φ₄"], "before joint 2")])],
    "two_link.end": [
        Held(four(0, 0, 90, 0), [((3.6, 1.2, 0), "hangs on it"), ((1.2, 3.6, 0), "joint 2"),
                                 ((0, 4.8, 0), "joint 1")]),
        Held(four(0, 90, -90, 0), [((1.2, -1.2, 0), "counts θ₃ from x₀"),
                                   ((1.2, 3.6, 0), "without θ₃")])],
    "two_link.answers": [Held("2", [("1", "for −θ₁"), ("4", "no choice"),
                                    ("as many as one likes", "single answers")])],
}
