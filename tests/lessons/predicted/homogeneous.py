"""Lesson 03: by products of matrices written out here, by hand where a hand is quick."""
from math import cos, radians, sin

import numpy as np
import sympy as sp
from textbook import turn

from . import Held

O_1, C_1 = np.array([1.5, -1]), np.array([1.5, 1])


def plane(theta, x=0.0, y=0.0):
    c, s = cos(radians(theta)), sin(radians(theta))
    return np.array([[c, -s, x], [s, c, y], [0, 0, 1]])


def carried(theta):
    return (*(O_1 + plane(theta)[:2, :2] @ C_1), 0)


def third_origin(theta_1, theta_2):
    T = plane(theta_1, 1.2, 0.9) @ plane(theta_2, 1.2, 0.9) @ plane(0, 1.2, 0.9)
    return (*T[:2, 2], 0)


def rows(theta_2):
    """The arrows of the chain in frame 0, turned by the angles of the view."""
    way, arrows = np.eye(2), []
    for theta in (50, theta_2, 60):
        arrows.append(way @ [1.2, 0.9])
        way = way @ plane(theta)[:2, :2]
    return np.array([*arrows, way @ [1.2, 0.9]])


def products(n):
    """How many products the first component holds, by multiplying out with letters."""
    p = sp.Matrix(sp.symbols("x y"))
    for k in range(n, 0, -1):
        c, s, x, y = sp.symbols(f"c{k} s{k} x{k} y{k}")
        p = (sp.Matrix([x, y]) + sp.Matrix([[c, -s], [s, c]]) * p).expand()
    return len(p[0].args)


def in_space(phi=40.0, o_y=0.5):
    H = np.eye(4)
    H[:3, :3] = turn(np.array([0, 0, 1]), radians(-30)) @ turn(np.array([1, 0, 0]), radians(phi))
    H[:3, 3] = 1, o_y, 0.8
    return H


def changed(after):
    moved = ~np.isclose(in_space(), after)
    return tuple("".join("c" if entry else "s" for entry in row) for row in moved)


ROWS = ["o₁⁰", "R₁⁰ o₂¹", "R₁⁰R₂¹ o₃²", "R₁⁰R₂¹R₃² c³"]

PREDICTED = {
    "homogeneous.combined": [
        Held(carried(90), [((-1, 1.5, 0), "alone"), ((2.5, 0.5, 0), "not to the right"),
                           ((2.5, -2.5, 0), "clockwise"), ((3, 0, 0), "without a turn")]),
        Held(carried(180), [((-1.5, -1, 0), "alone"), ((0, 0, 0), "goes down"),
                            ((3, 0, 0), "without a turn")]),
        Held(carried(-90), [((1, -1.5, 0), "alone"), ((0.5, 0.5, 0), "by +90°")])],
    "homogeneous.chain": [
        Held(third_origin(0, 90), [((3.6, 2.7, 0), "without the turn"),
                                   ((-2.7, 3.6, 0), "after joint 2")]),
        Held(third_origin(90, 0), [((3.6, 2.7, 0), "without the turn"),
                                   ((-2.7, 3.6, 0), "turns o₁⁰, too")])],
    "homogeneous.rows": [Held(
        [name for name, *both in zip(ROWS, rows(-80), rows(-20)) if not np.allclose(*both)],
        [(ROWS, "before both turns"), (ROWS[1:], "its own origin"), (ROWS[3:], "is missing")])],
    "homogeneous.letters": [Held(sum(range(7)), [
        (6, "many terms"), (11, "three R"), (7, "number of terms"), (15, "n = 5")])],
    "homogeneous.products": [
        Held(products(3), [(11, "by 4"), (14, "one more"), (10, "doubles")]),
        Held(products(6), [(31, "n = 4"), (63, "n = 5"), (30, "every single frame"),
                           (120, "adds one")])],
    "homogeneous.zero": [Held("it drops out", [
        ("it is added as before", "last column"), ("it changes its sign", "is 0"),
        ("the product does not exist", "exists")])],
    "homogeneous.back": [Held(
        "({:.0f}, {:.0f})".format(*np.round(np.linalg.inv(plane(90, 2, 0))[:2, 2]) + 0.0), [
            ("(−2, 0)", "Frame 1 is turned"), ("(2, 0)", "o₁⁰ itself"),
            ("(0, −2)", "+y₁ points")])],
    "homogeneous.transpose": [Held("only if o = 0", [
        ("always", "where does the origin stand"), ("only if θ = 0", "by −o"),
        ("never", "H is a rotation")])],
    "homogeneous.order": [
        Held((*(plane(60) @ plane(0, 2))[:2, 2], 0), [((2, 0, 0), "turned first"),
                                                      ((3 ** 0.5, 1, 0), "at 30°")])],
    "homogeneous.fixed": [Held((*(plane(60) @ plane(0, 2))[:2, 2], 0), [
        ((2, 0, 0), "does not stay"), ((3 ** 0.5, 1, 0), "at 30°")])],
    "homogeneous.space": [
        Held(changed(in_space(phi=75)), [
            (("cccs", "cccs", "cccs", "ssss"), "13 of 16"), (("ssss",) * 4, "10 of 16")]),
        Held(changed(in_space(o_y=-0.5)), [
            (("sssc", "sssc", "sssc", "ssss"), "14 of 16"), (("ssss",) * 4, "15 of 16")])],
    "homogeneous.heading": [
        Held(theta, [(theta + phi, "added φ"), (0, "away from x₀")])
        for theta, phi in ((120, -60), (-135, 90))],
}
