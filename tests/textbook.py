"""The textbooks' formulas, typed by hand: nothing here goes through kinlab's mathematics.

Standard DH: Spong, Hutchinson and Vidyasagar, chapter 3; lecture 2.8, "DH matrix".
Modified DH: Craig, chapter 3. Product of exponentials: Lynch and Park, chapter 4.
"""
from math import cos, sin

import numpy as np


def standard(theta, d, a, alpha):
    return np.array([
        [cos(theta), -cos(alpha) * sin(theta), sin(alpha) * sin(theta), a * cos(theta)],
        [sin(theta), cos(alpha) * cos(theta), -sin(alpha) * cos(theta), a * sin(theta)],
        [0, sin(alpha), cos(alpha), d],
        [0, 0, 0, 1]])


def modified(theta, d, a, alpha):
    return np.array([
        [cos(theta), -sin(theta), 0, a],
        [sin(theta) * cos(alpha), cos(theta) * cos(alpha), -sin(alpha), -d * sin(alpha)],
        [sin(theta) * sin(alpha), cos(theta) * sin(alpha), cos(alpha), d * cos(alpha)],
        [0, 0, 0, 1]])


DH = {"standard": standard, "modified": modified}


def frames(arm, q):
    """T_00 ... T_0n and T_0E: DH matrices multiplied one after the other."""
    T, values = [arm.base], iter(q)
    for link in arm.links:
        value = 0 if link.kind == "fixed" else next(values) * (-1 if link.flip else 1)
        turn, slide = (value, 0) if link.kind == "revolute" else (0, value)
        row = DH[arm.convention](link.theta + turn, link.d + slide, link.a, link.alpha)
        T.append(T[-1] @ row)
    return np.array([*T, T[-1] @ arm.tool])


def turn(axis, angle):
    """Rodrigues: the rotation by an angle about a unit axis."""
    x, y, z = axis
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + sin(angle) * K + (1 - cos(angle)) * K @ K


def rigid(R=None, o=(0, 0, 0)):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = np.eye(3) if R is None else R, o
    return T


def exponentials(arm, q):
    """T_0E as a product of exponentials: each joint moves all that follows it in the room."""
    zero = frames(arm, np.zeros(arm.n))
    first = 0 if arm.convention == "standard" else 1
    T = np.eye(4)
    values = iter(q)
    for link, frame in zip(arm.links, zero[first:]):
        if link.kind == "fixed":
            continue
        value = next(values)
        axis, point = (-frame[:3, 2] if link.flip else frame[:3, 2]), frame[:3, 3]
        if link.kind == "revolute":
            R = turn(axis, value)
            T = T @ rigid(R, point - R @ point)
        else:
            T = T @ rigid(o=value * axis)
    return T @ zero[-1]


def zyz(phi, theta, psi):
    return turn((0, 0, 1), phi) @ turn((0, 1, 0), theta) @ turn((0, 0, 1), psi)
