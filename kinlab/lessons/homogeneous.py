"""Lesson 03, homogeneous transforms: the growing expression, and the judges of its exercises."""
from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from math import pi, radians

import numpy as np
import sympy as sp

from ..answers.judges import Judge, expressions, function
from ..answers.matrices import matrix_entry
from ..arms import transforms
from .asked.homogeneous import PREDICTIONS
from .views.homogeneous import chain, combined, fixed, order, seen_back, spatial

__all__ = ["JUDGES", "PREDICTIONS", "chain", "combined", "expansion", "fixed", "growth", "order",
           "seen_back", "spatial", "spelled_out"]


def expansion(n: int) -> sp.Expr:
    """c^0 by n steps of p -> o + R p, from the inside out, with every bracket multiplied out."""
    def letter(name: str, k: int) -> sp.Symbol:
        return sp.Symbol(f"{name}_{k}^{k - 1}", commutative=False)

    p = sp.Symbol(f"c^{n}", commutative=False)
    for k in range(n, 0, -1):
        p = sp.expand(letter("o", k) + letter("R", k) * p)
    return p


def spelled_out(n: int) -> sp.Matrix:
    """The same in components: frame k is turned by theta_k and has its origin at x_k, y_k."""
    p = sp.Matrix(sp.symbols("x_c y_c"))
    for k in range(n, 0, -1):
        o = sp.Matrix(sp.symbols(f"x_{k} y_{k}"))
        p = sp.expand(o + sp.Matrix(transforms.rotation_2d(sp.Symbol(f"theta_{k}"))) * p)
    return p


@dataclass(frozen=True)
class Rows:
    """Formulas one under another."""

    text: str
    latex: str

    def __repr__(self) -> str:
        return self.text

    def _repr_latex_(self) -> str:
        return self.latex


def growth(most: int = 6) -> Rows:
    """The expansions for 1 to `most` frames, in the lecture's order."""
    text, latex = [], []
    for n in range(1, most + 1):
        terms = sorted(sp.Add.make_args(expansion(n)), key=lambda term: len(term.args))
        text.append(f"c^0 = {' + '.join(str(term).replace('*', ' ') for term in terms)}")
        latex.append(f"n = {n}: && c^0 &= {' + '.join(map(sp.latex, terms))}")
    body = r" \\ ".join(latex)
    return Rows("\n".join(text), rf"$\displaystyle \begin{{aligned}}{body}\end{{aligned}}$")


# ---- Exercise 1: the planar homogeneous matrix ---------------------------------------


def _H(theta: float, x: float, y: float) -> np.ndarray:
    return transforms.homogeneous(transforms.rotation_2d(theta), [x, y])


_turn, _slide = partial(_H, x=0, y=0), partial(_H, 0)


def _origin_below(theta: float, x: float, y: float) -> np.ndarray:
    T = _turn(theta)
    T[2, :2] = x, y
    return T


_H_CASES = [dict(zip(("theta", "o_x", "o_y"), case))
            for case in ((0.0, 0.0, 0.0), (pi / 2, 2.0, 1.0), (pi / 6, -1.0, 0.5), (-0.8, 1.2, -2))]

_H_SLIPS = [
    ("The angle arrives in radians; do not convert it.", lambda t, x, y: _H(radians(t), x, y)),
    ("This is the transpose: the axes of frame 1 are columns, and so is its origin.",
     lambda t, x, y: _H(t, x, y).T),
    ("The rotation is transposed (or theta has the wrong sign): the minus stands at the sine in "
     "the first row.", lambda t, x, y: _H(-t, x, y)),
    ("The origin belongs in the last column, not in the last row.", _origin_below),
    ("The factors stand in the wrong order: you turn first and slide along the turned axes. The "
     "origin is given in frame 0 and enters as it is.", lambda t, x, y: _turn(t) @ _slide(x, y)),
    ("This is the inverse: it takes coordinates from frame 0 to frame 1.",
     lambda t, x, y: np.linalg.inv(_H(t, x, y))),
    ("The translation is left out.", lambda t, x, y: _turn(t)),
    ("The rotation is left out.", lambda t, x, y: _slide(x, y)),
    ("o_x and o_y have changed places.", lambda t, x, y: _H(t, y, x)),
]

# ---- Exercise 2: the origin of frame 0, seen from frame 1 ----------------------------


def _back(theta: float, x: float, y: float) -> np.ndarray:
    return np.linalg.inv(_H(theta, x, y))[:2, 2]


_BACK_SLIPS = [
    ("This is -o: seen from frame 1, the way back is also turned by the transpose of R.",
     lambda t, x, y: np.array([-x, -y])),
    ("The sign is missing: the way back to frame 0 is the opposite of o.",
     lambda t, x, y: -_back(t, x, y)),
    ("This is -R o: to see a vector of frame 0 from frame 1 takes the transpose of R.",
     lambda t, x, y: -_H(t, x, y)[:2, :2] @ [x, y]),
    ("The two components have changed places.", lambda t, x, y: _back(t, x, y)[::-1]),
]

# ---- Exercise 3: how fast does the expansion grow? -----------------------------------

_COUNT_SLIPS = [
    ("The last bracket is missing: the term with c^n holds n rotations and adds 2^n products.",
     lambda n: [n * (n - 1) / 2, 2.0 ** (n + 1) - 1]),
    ("The last bracket is missing: the term with c^n holds n rotations and adds 2^n products.",
     lambda n: [n * (n - 1) / 2, 2.0 ** n - 1]),
    ("The last bracket is missing: the term with c^n adds 2^n products.",
     lambda n: [n * (n + 1) / 2, 2.0 ** n - 1]),
    ("There are n different rotations, but each stands in many terms. Count them all.",
     lambda n: [n, 2.0 ** (n + 1) - 1]),
    ("Look at n = 1: x_1 + x_c cos - y_c sin is 3 terms, and 3 = 4 - 1.",
     lambda n: [n * (n + 1) / 2, 2.0 ** (n + 1)]),
]

# ---- Exercise 4: a cart on a turntable -----------------------------------------------


def _cart(d: float, theta: float, phi: float, e: float) -> np.ndarray:
    return _turn(phi) @ _slide(d, 0) @ _turn(theta) @ _slide(e, 0)


_CART_CASES = [dict(zip(("d", "theta", "phi", "e"), case))
               for case in ((1.0, 0.0, 0.0, 0.0), (2.0, 0.0, pi / 2, 0.0), (2.0, pi / 3, 0.4, 1.0),
                            (1.5, -0.7, 1.1, 0.5))]

_CART_SLIPS = [
    ("The angles arrive in radians; do not convert them.",
     lambda d, t, p, e: _cart(d, radians(t), radians(p), e)),
    ("The turntable turns about the fixed origin of frame 0, so its factor goes on the left of "
     "all that happened before.",
     lambda d, t, p, e: _slide(d, 0) @ _turn(t) @ _turn(p) @ _slide(e, 0)),
    ("The last drive goes along the cart's own x axis, so its factor goes on the right.",
     lambda d, t, p, e: _slide(e, 0) @ _turn(p) @ _slide(d, 0) @ _turn(t)),
    ("All factors stand in reverse order: motions about the cart's own axes multiply on the "
     "right.", lambda d, t, p, e: _slide(e, 0) @ _turn(t) @ _slide(d, 0) @ _turn(p)),
    ("The cart drives first and turns then; its own motions read from left to right.",
     lambda d, t, p, e: _turn(p) @ _turn(t) @ _slide(d, 0) @ _slide(e, 0)),
    ("This is the inverse: frame 0 as the cart sees it.",
     lambda d, t, p, e: np.linalg.inv(_cart(d, t, p, e))),
]


JUDGES: dict[str, Judge] = {
    "homogeneous.1": function(
        _H, _H_CASES, entry=matrix_entry, slips=_H_SLIPS,
        without="The task is to build the matrix yourself, from np.cos and np.sin.",
        praise="Rotation and origin stand side by side, and the last row makes room for both."),
    "homogeneous.2": expressions(
        ("x", "y"), _back, _H_CASES[1:], constants={}, slips=_BACK_SLIPS,
        praise="The origin of frame 0, seen from frame 1, is -R^T o: turned back and reversed."),
    "homogeneous.3": expressions(
        ("rotations", "products"), lambda n: [n * (n + 1) / 2, 2.0 ** (n + 1) - 1],
        [dict(n=1), dict(n=4), dict(n=9)], constants={}, slips=_COUNT_SLIPS,
        praise="Ten frames: 55 rotations and 2047 products in one component, or ten matrices H."),
    "homogeneous.4": function(
        _cart, _CART_CASES, entry=matrix_entry, slips=_CART_SLIPS,
        praise="Fixed axes on the left, own axes on the right, in the order of time."),
}
