"""Answers to the Intelledex lesson's exercises: right, typically wrong, and not attempted."""
from math import pi

import numpy as np
import sympy as sp

import kinlab as kl

t1, t2, t3, t4 = sp.symbols("theta_1 theta_2 theta_3 theta_4")
R = pi / 2


def arm(alpha=(R, R, 0, 0, R, 0), a=(0, 0, 304.8, 304.8, 0, 0), d=(373.4, 0, 0, 0, 0, 228.6),
        theta=(0,) * 6, **options):
    rows = zip(theta, d, a, alpha)
    return kl.Arm([kl.revolute(theta=t, d=d, a=a, alpha=al) for t, d, a, al in rows], **options)


def wrist(forearm=t3 + t4, length=304.8, height=373.4, side=1):
    out = 304.8 * sp.cos(t3) + length * sp.cos(forearm)
    along = 304.8 * sp.sin(t3) + length * sp.sin(forearm)
    return [out * sp.cos(t1) * sp.cos(t2) + side * along * sp.sin(t1),
            out * sp.sin(t1) * sp.cos(t2) - side * along * sp.cos(t1), height + out * sp.sin(t2)]


RIGHT = {
    "intelledex.1": arm(),
    "intelledex.2": wrist(),
    "intelledex.3": [{1, 2, 3, 4}, {2, 3, 4, 5}, {1, 2, 3, 4, 5}],
    "intelledex.4": np.radians([90, 0, 90, 0, 45, 0]),
}

# (exercise, answer, words of the praise)
ALSO = [
    ("intelledex.1", kl.to_modified(arm()), "modified DH instead of standard"),
    ("intelledex.1", arm(alpha=(R, -R, 0, 0, -R, 0)), "z2 points the other way: your q3 turns"),
    ("intelledex.1", arm(alpha=(-R, -R, 0, 0, -R, 0)), "z1 points the other way: your q2 turns"),
    ("intelledex.1", arm(alpha=(R, R, pi, 0, R, 0)), "z3 points the other way: your q4 turns"),
    ("intelledex.1", arm(a=(0, 0, -304.8, 304.8, 0, 0)), "x3 points the other way"),
    ("intelledex.1", arm(d=(373.4, 0, 50, -80, 30, 228.6)), "slid along it"),
    ("intelledex.1", arm(d=(-373.4, 0, 0, 0, 0, 228.6)), "another base frame"),  # z0 points down
    ("intelledex.1", arm(d=(0, 0, 0, 0, 0, 228.6), base=kl.translation([0, 0, 373.4])), "base"),
    ("intelledex.1", arm(d=(373.4, 0, 0, 0, 0, 0), tool=kl.translation([0, 0, 228.6])), "tool"),
    ("intelledex.1", arm(theta=np.radians([90, -90, 90, 0, 90, 0])), "from a zero 90° away"),
]

# (exercise, answer, words of the message)
WRONG = [
    ("intelledex.1", arm(alpha=(90, 90, 0, 0, 90, 0)), "radians"),
    ("intelledex.1", arm(alpha=(R, R, 0, 0, 0, 0)), "row 5 is missing"),
    ("intelledex.1", arm(alpha=(R, 0, 0, 0, R, 0)), "row 2 is missing"),
    ("intelledex.1", arm(d=(373.4, 0, 0, 0, 0, 0)), "tool is forgotten"),
    ("intelledex.1", arm(a=(0, 0, 304.8, 304.8, 0, 228.6), d=(373.4, 0, 0, 0, 0, 0)), "along z"),
    ("intelledex.1", arm(d=(0, 0, 0, 0, 0, 228.6)), "column is forgotten"),
    ("intelledex.1", arm(a=(0,) * 6, d=(373.4, 0, 304.8, 304.8, 0, 228.6)), "along x"),
    ("intelledex.1", arm(a=(0, 304.8, 304.8, 0, 0, 0)), "one row too high"),
    ("intelledex.1", arm(convention="modified"), "were read as modified"),
    ("intelledex.1", arm(d=(373.4, 0, 0, 0, 0, 200)), "Joint 6: the offset d6 is 200"),
    ("intelledex.1", arm(d=(300, 0, 0, 0, 0, 228.6)), "Joint 1: the offset d1 is 300"),
    ("intelledex.1", arm(a=(0, 0, 304.8, 300, 0, 0)), "Joint 4: the length a4 is 300"),
    ("intelledex.1", arm(d=(373.4, 10, 0, 0, 0, 228.6)), "Joint 2: the offset d2 is 10"),
    ("intelledex.1", arm(d=(373.4, 0, 0, 0, 20, 228.6)), "d3, d4, d5 count only together"),
    ("intelledex.1", kl.Arm([kl.revolute()] * 5 + [kl.prismatic()]), "Joint 6 is revolute"),
    ("intelledex.1", kl.robots.alpha_ii(), "Your table has 5 joints, the arm has 6"),
    ("intelledex.1", [[0, 373.4, 0, 90]] * 6, "Expected an arm"),
    ("intelledex.2", wrist(length=0), "forearm is forgotten"),
    ("intelledex.2", wrist(forearm=t4), "not by theta_4 alone"),
    ("intelledex.2", wrist(forearm=t3), "not by theta_3 alone"),
    ("intelledex.2", wrist(height=0), "height of the shoulder"),
    ("intelledex.2", wrist(side=-1), "along v"),
    ("intelledex.2", [wrist()[k] for k in (1, 0, 2)], "changed places"),
    ("intelledex.2", [part / 1000 for part in wrist()], "millimetres"),
    ("intelledex.2", [*wrist()[:2], sp.Symbol("theta_5")], "theta_5"),
    ("intelledex.3", [{1, 2, 3}, {2, 3, 4, 5}, {1, 2, 3, 4, 5}], "swings the forearm"),
    ("intelledex.3", [{1, 2, 3, 4, 5}, {2, 3, 4, 5}, {1, 2, 3, 4, 5}], "axis of joint 5"),
    ("intelledex.3", [{1, 2, 3, 4}, {1, 2, 3, 4, 5}, {1, 2, 3, 4, 5}], "about the vertical"),
    ("intelledex.3", [{1, 2, 3, 4}, {2, 3, 4, 5}, {1, 3, 4, 5}], "one is missing"),
    ("intelledex.4", [90, 0, 90, 0, 45, 0], "np.radians"),
    ("intelledex.4", np.radians([90, 0, 90, 0, 135, 0]), "to the right"),
    ("intelledex.4", np.radians([90, -90, 90, 0, 45, 0]), "only nod"),
    ("intelledex.4", np.radians([135, -90, 90, 0, 90, 0]), "whole arm"),
    ("intelledex.4", np.radians([90, 0, 60, 0, 45, 0]), "mm away"),
    ("intelledex.4", [0, 0, 0], "expected six joint values; you gave three"),
]

STUBS = [("intelledex.1", ...), ("intelledex.2", [..., ..., ...]), ("intelledex.3", ...),
         ("intelledex.4", ...)]


# ---- Slips that classes are likely to make ------------------------------------------------------

c1, s1, c2, s2 = sp.cos(t1), sp.sin(t1), sp.cos(t2), sp.sin(t2)
c34, s34 = sp.cos(t3 + t4), sp.sin(t3 + t4)


def by_parts(c34=c34, s34=s34, a3=304.8, a4=304.8, c1=c1, s1=s1, c2=c2,
             s2=s2):
    out, along = a3 * sp.cos(t3) + a4 * c34, a3 * sp.sin(t3) + a4 * s34
    return [out * c1 * c2 + along * s1, out * s1 * c2 - along * c1, 373.4 + out * s2]


WRONG += [
    ("intelledex.1", kl.robots.intelledex_660t(), "kinlab has ready"),
    ("intelledex.1", arm(alpha=(0, R, 0, 0, R, 0)), "alpha1"),
    ("intelledex.1", arm(a=(0, 0, 0, 304.8, 304.8, 0)), "a3 is 0; it should be 304.8"),
    ("intelledex.1", arm(a=(0, 0, 609.6, 0, 0, 0)), "a3 is 609.6; it should be 304.8"),
    ("intelledex.1", arm(a=(0, 0, 30.48, 30.48, 0, 0), d=(37.34, 0, 0, 0, 0, 22.86)),
     "All lengths are 10 times too small"),
    ("intelledex.1", arm(d=(0, 373.4, 0, 0, 0, 228.6)), "Joint 2: the offset d2 is 373.4"),
    ("intelledex.1", arm(d=(373.4, 0, 0, 0, 228.6, 0)), "d"),
    ("intelledex.2", by_parts(c34=sp.cos(t3) + sp.cos(t4), s34=sp.sin(t3) + sp.sin(t4)),
     "not the sum of two cosines"),
    ("intelledex.2", by_parts(c34=sp.cos(t3) + sp.cos(t4)), "not the sum of two cosines"),
    ("intelledex.2", by_parts(s34=sp.sin(t3) * sp.sin(t4)), "product of two cosines"),
    ("intelledex.2", by_parts(a3=0), "upper arm is forgotten"),
    ("intelledex.2", by_parts(a4=304.8 + 228.6), "a tool held straight"),
    ("intelledex.2", by_parts(c2=1, s2=0), "theta_2, is left out"),
    ("intelledex.2", by_parts(c1=1, s1=0), "Joint 1 is left out"),
    ("intelledex.2", by_parts(s2=-s2), "The sign in w_z is wrong"),
    ("intelledex.2", by_parts(c1=c2, s1=s2, c2=c1, s2=s1), "theta_1 and theta_2 have changed"),
    ("intelledex.2", [by_parts()[0], by_parts()[1], ...], "w_z is still to do"),
    ("intelledex.2", [by_parts()[0], by_parts()[1], 373.4], "w_z should be"),
    ("intelledex.3", [{0, 1, 2, 3}, {1, 2, 3, 4}, {0, 1, 2, 3, 4}], "Joints count from 1"),
    ("intelledex.3", [{1, 2, 3, 4}, {3, 5}, {1, 2, 3, 4, 5}], "two are missing"),
    ("intelledex.3", [{1, 2, 3, 4}, {2, 3, 4, 5, 6}, {1, 2, 3, 4, 5}], "axis of joint 6"),
    ("intelledex.3", [{1, 2, 3, 4}, {2, 3, 4, 5}, set(range(1, 7))], "along the axis of joint 6"),
    ("intelledex.3", [{1, 2, 3, 4}, {2, 3, 4, 5}, ...], "a is still to do"),
    ("intelledex.4", np.radians([90, 0, 90, 0, 90, 0]), "in line with the forearm"),
    ("intelledex.4", np.radians([90, 0, 90, 0, 0, 0]), "45° away from 45° to the left"),
    ("intelledex.4", np.radians([90, 180, 90, 0, 45, 0]), "to the right"),
    ("intelledex.4", np.radians([90, 0, 90, 0, 45]), "you gave five"),
    ("intelledex.4", kl.inverse_kinematics(arm(), [600, 100, 300]),
     "Hand over its .q"),
    ("intelledex.4", [pi / 2, 0, pi / 2, 0, ..., 0], "still to do"),
]

ALSO += [
    ("intelledex.1", arm(alpha=(R, R, 0, 0, -R, 0)), "x5 points the other way"),
    ("intelledex.1", arm(alpha=(R, -R, 0, 0, R, 0)), "x2 points the other way"),
    ("intelledex.4", np.radians([90, 360, 90, 0, 45, 77]), "has yawed the tool"),
    ("intelledex.4", np.radians([90, 180, 90, 0, 135, 0]), "has yawed the tool"),
    ("intelledex.2", [[part] for part in by_parts()], "Four joints"),
]
