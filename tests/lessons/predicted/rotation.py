"""Lesson 02: by the textbook's rotations, by hand where a hand is quick."""
from math import atan2, cos, degrees, radians, sin

import numpy as np
from textbook import turn

from . import Held

C_1, C_0 = np.array([1.2, 0.5]), np.array([0.5, 1.2])


def plane(theta):
    t = radians(theta)
    return np.array([[cos(t), -sin(t)], [sin(t), cos(t)]])


def about(letter, theta):
    return turn(np.eye(3)["xyz".index(letter)], radians(theta))


def angle(vector, letter):
    """Degrees of a vector, from the next axis about the one with this letter."""
    k = "xyz".index(letter)
    return degrees(atan2(vector[(k + 2) % 3], vector[(k + 1) % 3]))


def carried(theta):
    return (*plane(theta) @ C_1, 0)


def foot(theta):
    x_1 = plane(theta)[:, 0]
    return (*(x_1 @ C_0) * x_1, 0)


PREDICTED = {
    "rotation.quarter": [
        Held(angle([*plane(theta)[:, 1], 0], "z"), [
            (theta, "There x₁ points"), (theta - 90, "behind x₁"), (90, "does not stay on y₀")])
        for theta in (120, 60, -60)],
    "rotation.signs": [Held(
        tuple("".join("+" if entry > 0 else "-" for entry in row) for row in plane(35)), [
            (("++", "-+"), "2 of 4"), (("++", "++"), "3 of 4"), (("+0", "0+"), "2 of 4")])],
    "rotation.riding": [
        Held(carried(90), [((0.5, 1.2, 0), "to the left now"), ((0.5, -1.2, 0), "clockwise"),
                           ((1.2, 0.5, 0), "rides on frame 1")]),
        Held(carried(180), [((-1.2, 0.5, 0), "points down now"),
                            ((1.2, -0.5, 0), "to the left now"),
                            ((-0.5, 1.2, 0), "by one more")]),
        Held(carried(-90), [((-0.5, 1.2, 0), "turn by +90°"), ((-0.5, -1.2, 0), "to the right now"),
                            ((1.2, 0.5, 0), "rides on frame 1")])],
    "rotation.shadow": [
        Held(foot(-90), [((0, -1.2, 0), "behind the origin"), ((0.5, 0, 0), "foot on x₀"),
                         ((0.5, 1.2, 0), "That is c.")]),
        Held(foot(180), [((-0.5, 0, 0), "behind the origin"), ((0, 1.2, 0), "foot on y₁"),
                         ((0.5, 1.2, 0), "That is c.")])],
    "rotation.seen": [Held(
        "({:.1f}, {:.1f})".format(*plane(90).T @ C_0).replace("-", "−"), [
            ("(−0.5, 1.2)", "rides on the frame"), ("(0.5, 1.2)", "has turned"),
            ("(1.2, 0.5)", "points to the left")])],
    "rotation.undo": [Held("a turn by −θ", [
        ("a turn by θ once more", "2θ"), ("a turn by 180° − θ", "half a turn"),
        ("a turn by 90° − θ", "quarter turn")])],
    "rotation.mirror": [Held(tuple(np.diag([1, -1, -1]) @ [0.8, 1, 0]), [
        ((-0.8, 1, 0), "to the left"), ((-0.8, -1, 0), "half a turn"),
        ((1, -0.8, 0), "exchanges nothing")])],
    "rotation.paper": [Held("for no θ", [
        ("for θ = 90°", "on its side"), ("for θ = 180°", "point to the left"),
        ("for θ = 360°", "mirror image still")])],
    "rotation.sum": [
        Held(angle([*(plane(first) @ plane(second))[:, 0], 0], "z"), [
            (first, "There x₁ points"), (second, "not from x₀"), (first - second, "goes on from")])
        for first, second in ((50, 30), (120, -45), (-30, -40))],
    "rotation.about_z": [Held(("cc0", "cc0", "001"), [
        (("ccc", "ccc", "ccc"), "4 of 9"), (("1cc", "0cc", "0cc"), "3 of 9"),
        (("cc0", "cc0", "00c"), "8 of 9")])],
    "rotation.about_x": [
        Held(angle(about("x", 90)[:, 2], "x"), [(0, "That is +y₀"), (90, "Only x₁ stays")]),
        Held(angle(about("x", -120)[:, 2], "x"), [(210, "+120°"), (90, "Only x₁ stays")])],
    "rotation.about_y": [
        Held(angle(about("y", 60)[:, 0], "y"), [(30, "That is up"), (90, "Only y₁ stays")]),
        Held(angle(about("y", -90)[:, 0], "y"), [(180, "That is down"), (90, "Only y₁ stays")])],
    "rotation.book": [
        Held(angle((about("x", 90) @ about("z", 90))[:, 2], "x"), [
            (90, "tips it over"), (0, "That is +y₀")])],
}
