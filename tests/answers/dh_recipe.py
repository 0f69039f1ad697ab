"""Answers to the DH recipe's exercises: right, typically wrong, and not attempted."""
from math import pi, radians

import numpy as np
import sympy as sp

t1, t2, d3 = sp.symbols("theta_1 theta_2 d_3")
d1, L, a2 = sp.symbols("d_1 L_off a_2")
c1, s1, c2, s2 = sp.cos(t1), sp.sin(t1), sp.cos(t2), sp.sin(t2)
RIGHT_ANGLE = sp.pi / 2

TABLE = np.array([[t1, d1, 0, RIGHT_ANGLE], [t2 + RIGHT_ANGLE, L, a2, RIGHT_ANGLE],
                  [RIGHT_ANGLE, d3, 0, 0]], dtype=object)
A_1 = sp.Matrix([[c1, 0, s1, 0], [s1, 0, -c1, 0], [0, 1, 0, d1], [0, 0, 0, 1]])
A_2 = sp.Matrix([[-s2, 0, c2, -a2 * s2], [c2, 0, s2, a2 * c2], [0, 1, 0, L], [0, 0, 0, 1]])
H_2 = sp.Matrix([[-c1 * s2, s1, c1 * c2, L * s1 - a2 * c1 * s2],
                 [-s1 * s2, -c1, s1 * c2, -L * c1 - a2 * s1 * s2],
                 [c2, 0, s2, d1 + a2 * c2], [0, 0, 0, 1]])
MEASURED = [radians(150), 0.3, -0.5, radians(-60)]

RIGHT = {
    "dh_recipe.1": [{1, 3, 4, 5}, {1, 2, 4}, {1, 4}],
    "dh_recipe.2": TABLE,
    "dh_recipe.3": A_1,
    "dh_recipe.4": A_2,
    "dh_recipe.5": H_2,
    "dh_recipe.6": MEASURED,
}


def table(**changes):
    """The table with some entries changed, named by row and column: r2c0=..."""
    rows = TABLE.copy()
    for place, entry in changes.items():
        rows[int(place[1]) - 1, int(place[3])] = entry
    return rows


def modified(theta, d, a, alpha):
    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
    return sp.Matrix([[c, -s, 0, a], [s * ca, c * ca, -sa, -d * sa], [s * sa, c * sa, ca, d * ca],
                      [0, 0, 0, 1]])


BACK_1 = sp.Matrix([[c1, 0, -s1, 0], [s1, 0, c1, 0], [0, -1, 0, d1], [0, 0, 0, 1]])
BACK_2 = sp.Matrix([[-s2, 0, -c2, -a2 * s2], [c2, 0, -s2, a2 * c2], [0, -1, 0, L], [0, 0, 0, 1]])
PLAIN_2 = sp.Matrix([[c2, 0, s2, a2 * c2], [s2, 0, -c2, a2 * s2], [0, 1, 0, L], [0, 0, 0, 1]])
SWAPPED_2 = sp.Matrix([[-s2, 0, c2, -L * s2], [c2, 0, s2, L * c2], [0, 1, 0, a2], [0, 0, 0, 1]])

# (exercise, answer, words of the message)
WRONG = [
    ("dh_recipe.1", [{1, 2, 3, 4, 5}, {1, 2, 4}, {1, 4}], "Where does Ry(90°) take"),
    ("dh_recipe.1", [{1, 3, 4}, {1, 2, 4}, {1, 4}], "Rx(90°) leaves the x axis"),
    ("dh_recipe.1", [{1, 3, 4, 5}, {1, 2, 3, 4}, {1, 4}], "how near does it come to z0"),
    ("dh_recipe.1", [{1, 3, 4, 5}, {1, 2, 4, 5}, {1, 4}], "slides along the z axis after"),
    ("dh_recipe.1", [{1, 3, 4, 5}, {1, 4}, {1, 4}], "share the origin"),
    ("dh_recipe.1", [{1, 3, 4, 5}, {1, 2, 4}, {1}], "keeps both rules"),
    ("dh_recipe.1", [{1, 3, 4, 5}, {1, 2, 4}, {7}], "no transform 7"),
    ("dh_recipe.2", table(r1c3=90, r2c0=t2 + 90, r2c3=90, r3c0=90), "in degrees"),
    ("dh_recipe.2", table(r2c0=t2), "offset of joint 2"),
    ("dh_recipe.2", table(r1c3=-RIGHT_ANGLE, r2c3=-RIGHT_ANGLE), "sign of alpha"),
    ("dh_recipe.2", TABLE[:, [0, 2, 1, 3]], "changed places"),
    ("dh_recipe.2", np.array([[t1, d1, 0, 0], [t2 + RIGHT_ANGLE, L, 0, RIGHT_ANGLE],
                              [RIGHT_ANGLE, d3, a2, RIGHT_ANGLE]]), "modified (Craig) table"),
    ("dh_recipe.2", table(r3c1=0), "d of row 3 should be 0.45, got 0"),
    ("dh_recipe.2", table(r3c1=sp.Symbol("q_3")), "d of row 3 holds q_3"),
    ("dh_recipe.2", table(r2c1=...), "still the stub"),
    ("dh_recipe.2", TABLE[:2], "got 8"),
    ("dh_recipe.3", A_1.T, "transpose"),
    ("dh_recipe.3", A_1.inv(), "inverse"),
    ("dh_recipe.3", BACK_1, "sign of alpha"),
    ("dh_recipe.3", modified(t1, d1, 0, RIGHT_ANGLE), "modified (Craig) order"),
    ("dh_recipe.3", A_1[:3, :3], "got 9"),
    ("dh_recipe.4", PLAIN_2, "offset of joint 2"),
    ("dh_recipe.4", A_2.T, "transpose"),
    ("dh_recipe.4", BACK_2, "sign of alpha"),
    ("dh_recipe.4", SWAPPED_2, "changed places"),
    ("dh_recipe.4", modified(t2 + RIGHT_ANGLE, L, a2, RIGHT_ANGLE), "modified (Craig) order"),
    ("dh_recipe.4", A_2 + sp.eye(4), "row 1, column 1 should be"),
    ("dh_recipe.5", A_2 * A_1, "wrong order"),
    ("dh_recipe.5", A_1 * PLAIN_2, "offset of joint 2"),
    ("dh_recipe.5", BACK_1 * BACK_2, "sign of alpha"),
    ("dh_recipe.5", (A_1 * A_2).T, "transpose"),
    ("dh_recipe.5", A_1 + A_2, "row 1, column 1 should be"),
    ("dh_recipe.6", [150, 0.3, -0.5, -60], "in degrees"),
    ("dh_recipe.6", [MEASURED[0], 0.3, 0.5, MEASURED[3]], "signed length"),
    ("dh_recipe.6", [MEASURED[0] - pi, 0.3, -0.5, MEASURED[3]], "two quadrants"),
    ("dh_recipe.6", [MEASURED[0] - pi, 0.3, 0.5, MEASURED[3]], "not the x axis"),
    ("dh_recipe.6", [MEASURED[0], 0.3, -0.5, -MEASURED[3]], "sign of alpha"),
    ("dh_recipe.6", [MEASURED[0], -0.5, 0.3, MEASURED[3]], "changed places"),
    ("dh_recipe.6", MEASURED[:3], "shape (4,)"),
]

STUBS = [("dh_recipe.1", [..., ..., ...]), ("dh_recipe.1", ...),
         ("dh_recipe.2", np.array([[...] * 4] * 3, dtype=object)), ("dh_recipe.2", None),
         ("dh_recipe.3", ...), ("dh_recipe.4", ...), ("dh_recipe.5", ...),
         ("dh_recipe.6", [..., ..., ..., ...]), ("dh_recipe.6", ...)]
