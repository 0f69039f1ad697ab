"""Lesson 06: by forward kinematics of both tables, by hand where a hand is quick."""
from math import cos, radians, sin

import numpy as np

import kinlab as kl

from . import Held

SIX = kl.robots.practical_six_link()
ROWS = [kl.revolute(), kl.revolute(a=1)]
TOOL = kl.translation([1, 0, 0])
TWO, MISREAD = (kl.Arm(ROWS, convention=name, tool=TOOL) for name in ("modified", "standard"))


def tip(arm, *degrees):
    return kl.forward_kinematics(arm, np.radians(degrees))[:3, 3]


def elbow(*degrees):
    return kl.link_frames(TWO, np.radians(degrees))[2, :3, 3]


def slid(alpha, d):
    return (0.8, -d * sin(radians(alpha)), d * cos(radians(alpha)))


def tool_turn(theta_5):
    """Degrees of z6 from straight up, towards x0."""
    x, _, z = kl.forward_kinematics(SIX, np.radians([0, 90, -90, 0, theta_5, 0]))[:3, 2]
    return np.degrees(np.arctan2(x, z))


def axis_4(theta_3):
    """Degrees of the axis of joint 4 from straight up, towards x0."""
    x, _, z = kl.link_frames(SIX, np.radians([0, 45, theta_3, 0, 40, 0]))[4, :3, 2]
    return np.degrees(np.arctan2(x, z))


def x_turn(phi, psi):
    x, y, _ = kl.zyz_matrix(*np.radians([phi, 0, psi]))[:, 0]
    return np.degrees(np.arctan2(y, x))


AWAY = (0.1, 0.1, 3.0)  # of a mark, for all
PREDICTED = {
    "n_link.slide": [
        Held(slid(60, 1), [((0.8, 0, 1), "α has tilted it"),
                           ((0.8, 0.866, 0.5), "tilt to the other side")]),
        Held(slid(-90, 0.8), [((0.8, 0, 0.8), "α has tilted it"),
                              ((0.8, -0.8, 0), "takes z towards +y")]),
        Held(slid(150, 1), [((0.8, 0, 1), "α has tilted it"),
                            ((0.8, 0.5, -0.866), "towards −y first")])],
    "n_link.hint": [Held(
        ["the entry in row 3, column 3", "the number of rows"],
        [(["the entry in row 3, column 3"], "0 0 0 1 is missing"),
         (["the number of rows"], "cosine of αᵢ"),
         (["the entry in row 2, column 3", "the entry in row 3, column 3", "the number of rows"],
          "Both have −sin α")])],
    "n_link.flat": [
        Held((0.5, -0.5, cos(radians(60))), [((0.5, -0.5, 1), "where P is now"),
                                             ((0.25, -0.5, 1), "away")]),
        Held((0.5, -0.5, 0), [((0.5, -0.5, 1), "where P is now"), ((0, -0.5, 0), "away")])],
    "n_link.two": [
        Held(tip(TWO, 0, 90), [((1, -1, 0), "counter-clockwise"), ((2, 0, 0), "away")]),
        Held(tip(TWO, 90, 90), [((0, 2, 0), "It is counted from link 1"), ((1, 1, 0), "away")]),
        Held(tip(TWO, 90, -90), [((0, 0, 0), "It is counted from link 1"), ((-1, 1, 0), "away")])],
    "n_link.elbow": [
        Held(elbow(0, 90), [((1, 1, 0), "That is the tip"), ((0, 0, 0), "That is frame 1")]),
        Held(elbow(90, 60), [(tip(TWO, 90, 60), "That is the tip"),
                             ((0, 0, 0), "That is frame 1")])],
    "n_link.header": [
        Held(tip(MISREAD, 30, 120), [(tip(TWO, 30, 120), "tip of the real arm"), (AWAY, "away")]),
        Held(tip(MISREAD, 30, -30), [(tip(TWO, 30, -30), "tip of the real arm"), (AWAY, "away")])],
    "n_link.six": [
        Held(tip(SIX, 0, 90, -90, 0, 0, 0), [((0, 0.5, 2), "upper arm stands up"),
                                             ((0, 0.5, 1.5), "That is the wrist")]),
        Held(tip(SIX, 0, 90, 0, 0, 0, 0), [((2, 0.5, 0.5), "The other way"),
                                           ((0, 0.5, 2.5), "θ₃ = −90°")]),
        Held(tip(SIX, 0, 45, -45, 0, 0, 0), [((0, 0.5, 2.5 + 0.2), "only half way"),
                                             ((-0.35, 0.5, 2.35), "away")])],
    "n_link.tool": [Held(tool_turn(theta_5), [(-tool_turn(theta_5), "a turn the other way"),
                                              (0, "off")]) for theta_5 in (90, -90, 45)],
    "n_link.bottom": [Held("three zeros", [
        ("the origin, as a row", "would not be 1"),
        ("it does not matter", "the last component of every point")])],
    "n_link.wrist": [Held(["θ₁", "θ₂", "θ₃"], [
        (["θ₁", "θ₂", "θ₃", "θ₄"], "the wrist lies on that line"), (["θ₂", "θ₃"], "about z₀"),
        (["θ₁", "θ₂", "θ₃", "θ₅", "θ₆"], "has its axis through the wrist")])],
    "n_link.turning": [Held(["frame 2", "frame 2′"], [
        (["frame 1′", "frame 2", "frame 2′"], "rides on link 1"), (["frame 2′"], "rides on link 2"),
        (["frame 2"], "at its far end")])],
    "n_link.ends": [Held(axis_4(theta_3), [(-axis_4(theta_3), "the other side"), (150, "off")])
                    for theta_3 in (-20, -135)],
    "n_link.zyz": [Held(x_turn(phi, psi), [(phi, "That is φ alone"),
                                           (phi - psi, "each with its own sign")])
                   for phi, psi in ((40, 30), (110, -30), (-50, 20))],
    "n_link.base": [Held(["φ"], [(["φ", "ψ"], "the tool's own z"), (["φ", "θ"], "angle between"),
                                 ([], "the first turn")])],
    "n_link.trap": [Held(float(np.degrees(np.arctan2(0.0, -0.0))), [
        (0, "a zero with a sign"), (90, "off")])],
}


