"""Lesson 11: by the textbook's turns, by hand where a hand is quick."""
from math import atan2, cos, degrees, radians

import numpy as np
from textbook import turn

from . import Held

X, Y, Z = np.eye(3)


def quarter(axis):
    return turn(axis, radians(90))


def angle(vector, letter="z"):
    """Degrees of a vector, from the next axis about the one with this letter."""
    k = "xyz".index(letter)
    return degrees(atan2(vector[(k + 2) % 3], vector[(k + 1) % 3]))


def attitude(yaw, pitch, roll):
    return turn(Z, radians(yaw)) @ turn(Y, radians(pitch)) @ turn(X, radians(roll))


def instead(roll):
    """The yaw that does what roll does while the nose points up, read off where y goes."""
    return angle(attitude(0, -90, roll)[:, 1]) - angle(attitude(0, -90, 0)[:, 1])


C, D = quarter(Z) @ quarter(X), quarter(X) @ quarter(Z)  # about own axes, in both orders

PREDICTED = {
    "turns.own": [
        Held(angle(C @ Z), [(-90, "book A's cover"), (180, "the other way round")]),
        Held(angle(D @ Z), [(0, "book B's cover"), (90, "on to −y")])],
    "turns.same": [Held("x, then z", [
        ("z, then x", "That is book A"), ("there are none", "covers of B and C")])],
    "turns.nose": [
        Held(angle(attitude(0, pitch, 0)[:, 0], "y"), [
            (90 - pitch, "takes the nose down"), (pitch, "begins along x₀")])
        for pitch in (35, -60)],
    "turns.yaw": [Held("z₀, the vertical line", [
        ("z₁, the line up from the cabin", "z₁ moves"), ("x₁, the line of the nose", "roll")])],
    "turns.instead": [
        Held(instead(roll), [(-roll, "both turn the same way"), (0, "has not turned")])
        for roll in (50, -70)],
    "turns.stuck": [Held("none of them", [
        ("roll", "level flight"), ("yaw", "stays at its height"), ("pitch", "It stays")])],
    "turns.one": [Held(degrees(np.arccos((np.trace(C) - 1) / 2)), [
        (180, "do not add up"), (90, "Four turns"), (240, "the way back")])],
    "turns.opposite": [Held("by −60°", [
        ("by 60°", "the turn back"), ("by 120°", "180°"), ("by 180°", "Look at x₁")])],
    "turns.half": [
        Held(cos(radians(45)), [(0, "whole angle"), (1, "no turn at all")]),
        Held(cos(radians(60)), [(-0.5, "whole angle"), (0.866, "the sine of half")])],
    "turns.round": [Held("(−1, 0, 0, 0)", [
        ("(1, 0, 0, 0)", "half-way round"), ("(0, 1, 0, 0)", "about x"),
        ("(0, 0, 0, 0)", "length 1")])],
}
