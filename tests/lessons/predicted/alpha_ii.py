"""Lesson 07: by forward kinematics, by the arm's derivatives where a question is for all poses."""
import numpy as np
import sympy as sp

import kinlab as kl

from . import Held

ARM = kl.robots.alpha_ii()


def pose(*degrees):
    return kl.forward_kinematics(ARM, np.radians(degrees))


def tip(*degrees):
    return pose(*degrees)[:3, 3]


def approach(*degrees):
    """Degrees of z5 from straight up, towards x0."""
    x, _, z = pose(*degrees)[:3, 2]
    return np.degrees(np.arctan2(x, z))


def carried(alpha):
    """Degrees of the z axis from y, towards z."""
    _, y, z = kl.rotation_x(np.radians(alpha))[:, 2]
    return np.degrees(np.arctan2(z, y))


def signs(R):
    return ["".join("-0+"[int(entry) + 1] for entry in row) for row in np.round(R)]


def rolled():
    """Columns of the arm matrix that the roll changes, whatever the pose."""
    form = kl.closed_form(ARM)
    change = form.matrix.diff(form.joints[4])
    return [name for k, name in enumerate("nsap") if change[:, k] != sp.zeros(4, 1)]


PREDICTED = {
    "alpha_ii.base": [
        Held(tip(theta_1, 0, 0, -90, 0), [(tip(-theta_1, 0, 0, -90, 0), "counter-clockwise"),
                                          ((485.1, 0, 215), "away")])
        for theta_1 in (90, -135, 30)],
    "alpha_ii.motions": [
        Held(carried(alpha), [(180 - carried(alpha), "the other way"), (-60, "off")])
        for alpha in (-90, 90, -45)],
    "alpha_ii.order": [Held("on its right", [
        ("on its left", "fixed axes"), ("either: the product is the same", "need not change")])],
    "alpha_ii.fixed": [Held("the factors stand in reverse order", [
        ("it is the inverse", "opposite amounts"), ("it is the transpose", "only their order"),
        ("it stays the same", "do not change places")])],
    "alpha_ii.inverse": [Held("+Cα", [("−Cα", "on the diagonal stays"), ("Sα", "no entry")])],
    "alpha_ii.bend": [
        Held(tip(0, 20, 0, -90, 0), [(tip(0, -20, 0, -90, 0), "downwards"),
                                     ((485.1, 0, 215), "away")]),
        Held(tip(0, 0, -90, -90, 0), [(tip(0, 0, 90, -90, 0), "A negative turn raises"),
                                      ((0, 0, 700), "away")])],
    "alpha_ii.bracket": [Held("θ₂ + θ₃", [("θ₂ − θ₃", "C₂C₃ + S₂S₃"), ("θ₂ · θ₃", "add up")])],
    "alpha_ii.circle": [Held("a circle in the x₃y₃ plane", [
        ("a circle in the x₃z₃ plane", "nothing moves along"),
        ("a circle about the base", "joint 1"), ("a line", "does not slide")])],
    "alpha_ii.roll": [Held(rolled(), [(["n"], "“s” is missing"), (["n", "s", "a"], "lies along"),
                                      (["n", "s", "p"], "lies on the axis")])],
    "alpha_ii.home": [Held(signs(pose(0, 0, 0, -90, 0)[:3, :3]), [
        (["00+", "0+0", "+00"], "8 of 9"), (["+00", "0+0", "00+"], "entries")])],
    "alpha_ii.poses": [
        Held(tip(0, 0, 0, 0, 0), [((485.1, 0, 215), "level at θ₄ = −90°"),
                                  ((355.6, 0, 344.5), "hangs down")]),
        Held(tip(0, -90, 0, -90, 0), [((0, 0, -270.1), "raises the arm"),
                                      ((485.1, 0, 215), "away")]),
        Held(tip(0, -90, 90, 0, 0), [((177.8, 0, 392.8), "That is the wrist"),
                                     ((177.8, 0, 522.3), "The tool points down")]),
        Held(tip(0, -90, 90, 0, 90), [((307.3, 0, 392.8), "rolls the tool"),
                                      ((0, 0, 700.1), "away")])],
    "alpha_ii.approach": [
        Held(approach(0, 0, 0, -45, 0), [(45, "lowers the tool"), (0, "off")]),
        Held(approach(0, -30, 0, -90, 0), [(120, "raises"), (90, "takes the whole arm")]),
        Held(approach(0, -60, 100, -40, 0), [(0, "points down, not up"), (90, "off")])],
    "alpha_ii.reach": [Held(177.8 + 177.8 + 129.5, [(355.6, "That is the wrist"),
                                                    (700.1, "begins at the shoulder")])],
}
