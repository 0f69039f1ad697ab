"""Answers to the exercises on the two-link arm: right, typically wrong, and not attempted."""
from math import cos, pi, sin

import numpy as np
import sympy as sp

t1, t2, l1, l2, h = sp.symbols("theta_1 theta_2 l_1 l_2 h")
c1, s1, c12, s12 = sp.cos(t1), sp.sin(t1), sp.cos(t1 + t2), sp.sin(t1 + t2)
Q_X, Q_Y = l1 * c1 + l2 * c12, l1 * s1 + l2 * s12


def positions(theta_1, theta_2, l_1, l_2, second=sin):
    x, y, phi = l_1 * cos(theta_1), l_1 * sin(theta_1), theta_1 + theta_2
    return np.array([[x, y], [x + l_2 * cos(phi), y + l_2 * second(phi)]])


def unturned(a, b, p, q):
    P = positions(a, b, p, q)[0]
    return np.array([P, P + q * np.array([cos(b), sin(b)])])


def from_origin(a, b, p, q):
    P, Q = positions(a, b, p, q)
    return np.array([P, Q - P])


def after(change):
    return lambda *case: change(positions(*case))


def tip(lengths, angles):
    phi = np.cumsum(angles)
    return np.array([np.dot(lengths, np.cos(phi)), np.dot(lengths, np.sin(phi)), phi[-1]])


def bent(directions, last):
    """A tip whose links have the given directions, with the given last component."""
    return lambda lengths, angles: [np.dot(lengths, np.cos(directions(angles))),
                                    np.dot(lengths, np.sin(directions(angles))), last(angles)]


def shorter(lengths, angles):
    if len(lengths) == 1:
        return [0, 0, angles[0]]
    return [*tip(lengths[:-1], angles[:-1])[:2], sum(angles)]


RIGHT = {
    "two_link.1": positions,
    "two_link.2": [Q_X - h * s12, Q_Y + h * c12],
    "two_link.3": tip,
    "two_link.4": np.radians([60, 120]),
}

# (exercise, answer, words of the praise)
ALSO = [
    ("two_link.4", [np.radians([60, 120]), 2], "Two answers"),
    ("two_link.4", (np.radians([-60, 240]), 2), "Two answers"),
    ("two_link.4", np.radians([[60], [120]]), "Link 2 is level"),
    ("two_link.3", lambda lengths, a: tip(lengths, a) + [0, 0, 2 * pi], "any number of links"),
]

# (exercise, answer, words of the message)
WRONG = [
    ("two_link.3", lambda links, a: tip(links, a) * [1, 1, 180 / pi], "phi is in degrees"),
    ("two_link.4", [np.radians([60, 120]), 1], "is not 1. Where does P lie?"),
    ("two_link.4", [np.radians([60, 120]), ...], "how many answers there are is still to do"),
    ("two_link.4", [np.radians([60, 180]), 2], "counts from link 1"),
    ("two_link.4", [..., 2], "The two angles are still to do"),
    ("two_link.4", [pi / 3, ...], "theta_2 is still to do"),
    ("two_link.4", np.radians([60, 120, 0]), "two angles, theta_1 and theta_2; you gave three"),
    ("two_link.1", after(lambda PQ: -PQ), "All signs are turned round"),
    ("two_link.2", [Q_X - h * s12, ...], "x is right; y is still to do."),
    ("two_link.1", lambda a, b, p, q: positions(*np.radians([a, b]), p, q), "radians"),
    ("two_link.1", unturned, "turned by theta_1 + theta_2"),
    ("two_link.1", lambda *case: positions(*case, second=cos), "takes the sine"),
    ("two_link.1", from_origin, "begins at P"),
    ("two_link.1", after(lambda PQ: PQ[::-1]), "P and Q have changed places"),
    ("two_link.1", after(lambda PQ: PQ[:, ::-1]), "Sine and cosine"),
    ("two_link.1", after(np.transpose), "as rows"),
    ("two_link.1", lambda a, b, p, q: positions(a, b, q, p), "l_1 and l_2"),
    ("two_link.1", lambda a, b, p, q: positions(a, -b, p, q), "sign of theta_2"),
    ("two_link.1", after(lambda PQ: PQ[1]), "two rows of two numbers; your function gave two"),
    ("two_link.1", after(lambda PQ: PQ + 0.1), "P_x should be 2, got 2.1"),
    ("two_link.2", [Q_X, Q_Y], "step h is forgotten"),
    ("two_link.2", [Q_X, Q_Y + h], "not along y_0"),
    ("two_link.2", [Q_X + h * s12, Q_Y - h * c12], "sign of h"),
    ("two_link.2", [Q_X - h * sp.sin(t2), Q_Y + h * sp.cos(t2)], "not by theta_2 alone"),
    ("two_link.2", [Q_X + h * c12, Q_Y + h * s12], "that direction is x_2"),
    ("two_link.2", [Q_X - h * s12 - l1 * c1, Q_Y + h * c12 - l1 * s1], "Link 1 is forgotten"),
    ("two_link.2", [l1 + l2 * c12 - h * s12, l2 * s12 + h * c12], "wrong order"),
    ("two_link.2", [Q_X - h * s12, "y"], "leave out the quotes"),
    ("two_link.3", lambda links, a: tip(links, np.radians(a)), "radians"),
    ("two_link.3", bent(lambda a: a, sum), "add them up"),
    ("two_link.3", bent(lambda a: a, lambda a: a[-1]), "add them up"),
    ("two_link.3", bent(lambda a: np.cumsum(a) - a, sum), "one too early"),
    ("two_link.3", shorter, "last link is forgotten"),
    ("two_link.3", bent(np.cumsum, lambda a: a[-1]), "direction of the last link"),
    ("two_link.3", lambda links, a: tip(links, a)[[1, 0, 2]], "x takes the cosine"),
    ("two_link.3", lambda links, a: tip(links, a)[:2], "lengths = [1], angles = [0.5]: expected"),
    ("two_link.4", [60, 120], "np.radians"),
    ("two_link.4", np.radians([60, 180]), "counts from link 1"),
    ("two_link.4", np.radians([60, -120]), "do not go together"),
    ("two_link.4", np.radians([60, -60]), "It points along +x_0"),
    ("two_link.4", np.radians([50, 130]), "Q is at x = 0.2856"),
    ("two_link.4", [pi / 3], "two angles"),
]

STUBS = [("two_link.1", ...), ("two_link.1", lambda theta_1, theta_2, l_1, l_2: ...),
         ("two_link.2", [..., ...]), ("two_link.3", lambda lengths, angles: ...),
         ("two_link.4", ...), ("two_link.4", None)]
