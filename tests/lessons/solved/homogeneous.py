"""Answers to the exercises on homogeneous transforms: right, wrong, and not attempted."""
from math import cos, sin

import numpy as np
import sympy as sp

import kinlab as kl

t, x, y, n = sp.symbols("theta o_x o_y n")
c, s = sp.cos(t), sp.sin(t)


def H(theta, o_x, o_y):
    return np.array([[cos(theta), -sin(theta), o_x], [sin(theta), cos(theta), o_y], [0, 0, 1]])


def after(change):
    return lambda *arguments: change(H(*arguments))


def origin_below(T):
    T = T.copy()
    T[2, :2], T[:2, 2] = T[:2, 2], 0
    return T


def cart(*order):
    """The product of the named motions, in the order given."""
    def product(d, theta, phi, e):
        T = dict(d=H(0, d, 0), theta=H(theta, 0, 0), phi=H(phi, 0, 0), e=H(0, e, 0))
        return np.linalg.multi_dot([T[name] for name in order])
    return product


right_cart = cart("phi", "d", "theta", "e")


def cut(theta, o_x, o_y):
    """An array that was begun with whole numbers keeps nothing else."""
    T = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    T[:] = H(theta, o_x, o_y)
    return T


RIGHT = {
    "homogeneous.1": H,
    "homogeneous.2": [-c * x - s * y, s * x - c * y],
    "homogeneous.3": [n * (n + 1) / 2, 2**(n + 1) - 1],
    "homogeneous.4": right_cart,
}

# (exercise, answer, words of the message)
WRONG = [
    ("homogeneous.1", lambda t, x, y: kl.homogeneous(kl.rotation_2d(t), [x, y]), "kinlab's own"),
    ("homogeneous.1", cut, "Your array holds whole numbers"),
    ("homogeneous.2", [-c * x - s * y, ...], "x is right; y is still to do."),
    ("homogeneous.1", lambda t, x, y: H(np.radians(t), x, y), "radians"),
    ("homogeneous.1", after(np.transpose), "This is the transpose"),
    ("homogeneous.1", lambda t, x, y: H(-t, x, y), "rotation is transposed"),
    ("homogeneous.1", after(origin_below), "last column, not in the last row"),
    ("homogeneous.1", lambda t, x, y: H(t, 0, 0) @ H(0, x, y), "wrong order"),
    ("homogeneous.1", after(np.linalg.inv), "inverse"),
    ("homogeneous.1", lambda t, x, y: H(t, 0, 0), "translation is left out"),
    ("homogeneous.1", lambda t, x, y: H(0, x, y), "rotation is left out"),
    ("homogeneous.1", lambda t, x, y: H(t, y, x), "changed places"),
    ("homogeneous.1", after(lambda T: T[:2]), "three rows of three numbers; your function gave"),
    ("homogeneous.1", H(1, 2, 3), "Expected a function"),
    ("homogeneous.2", [-x, -y], "This is -o"),
    ("homogeneous.2", [c * x + s * y, -s * x + c * y], "sign is missing"),
    ("homogeneous.2", [-c * x + s * y, -s * x - c * y], "This is -R o"),
    ("homogeneous.2", [s * x - c * y, -c * x - s * y], "changed places"),
    ("homogeneous.2", [-c * x - s * y, s * x + c * y], "y should be"),
    ("homogeneous.2", [-c * x - s * sp.Symbol("oy"), s * x], "x holds oy"),
    ("homogeneous.3", [n * (n - 1) / 2, 2**(n + 1) - 1], "n rotations and adds 2^n"),
    ("homogeneous.3", [n * (n - 1) / 2, 2**n - 1], "n rotations and adds 2^n"),
    ("homogeneous.3", [n * (n + 1) / 2, 2**n - 1], "adds 2^n products"),
    ("homogeneous.3", [n, 2**(n + 1) - 1], "Count them all"),
    ("homogeneous.3", [n * (n + 1) / 2, 2**(n + 1)], "3 = 4 - 1"),
    ("homogeneous.3", [21, 127], "rotations should be 1"),
    ("homogeneous.4", lambda d, t, p, e: right_cart(d, np.radians(t), np.radians(p), e),
     "radians"),
    ("homogeneous.4", cart("d", "theta", "phi", "e"), "on the left of all"),
    ("homogeneous.4", cart("e", "phi", "d", "theta"), "on the right"),
    ("homogeneous.4", cart("e", "theta", "d", "phi"), "reverse order"),
    ("homogeneous.4", cart("phi", "theta", "d", "e"), "drives first"),
    ("homogeneous.4", lambda *a: np.linalg.inv(right_cart(*a)), "inverse"),
    ("homogeneous.4", cart("d", "theta"), "should be"),
]

STUBS = [("homogeneous.1", ...), ("homogeneous.1", lambda theta, o_x, o_y: ...),
         ("homogeneous.2", [..., ...]), ("homogeneous.3", [..., ...]), ("homogeneous.3", None),
         ("homogeneous.4", lambda d, theta, phi, e: ...)]
