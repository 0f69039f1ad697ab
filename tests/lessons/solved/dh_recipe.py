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

X, Y, Z = np.eye(3)
O_1, O_2, O_3 = (0, 0, 0.5), (0, -0.2, 0.9), (0.4, -0.2, 0.9)
VIEW = [(Z, X, (0, 0, 0)), (-Y, X, O_1), (X, Z, O_2), (X, -Y, O_3)]
FRAMES = [(Z, X, (0, 0, 0)), (Y, X, O_1), (X, Z, O_2), (X, Z, O_3)]

RIGHT = {
    "dh_recipe.1": [{1, 3, 4, 5}, {1, 2, 4}, {1, 4}],
    "dh_recipe.2": TABLE,
    "dh_recipe.3": A_1,
    "dh_recipe.4": A_2,
    "dh_recipe.5": H_2,
    "dh_recipe.6": MEASURED,
    "dh_recipe.7": FRAMES,
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


def frames(i, z=None, x=None, origin=None):
    """FRAMES with one of them placed anew."""
    new = [old if given is None else given for given, old in zip((z, x, origin), FRAMES[i])]
    return [*FRAMES[:i], tuple(new), *FRAMES[i + 1:]]


BACK_1 = sp.Matrix([[c1, 0, -s1, 0], [s1, 0, c1, 0], [0, -1, 0, d1], [0, 0, 0, 1]])
BACK_2 = sp.Matrix([[-s2, 0, -c2, -a2 * s2], [c2, 0, -s2, a2 * c2], [0, -1, 0, L], [0, 0, 0, 1]])
PLAIN_2 = sp.Matrix([[c2, 0, s2, a2 * c2], [s2, 0, -c2, a2 * s2], [0, 1, 0, L], [0, 0, 0, 1]])
SWAPPED_2 = sp.Matrix([[-s2, 0, c2, -L * s2], [c2, 0, s2, L * c2], [0, 1, 0, a2], [0, 0, 0, 1]])

HALF = sp.pi


def in_degrees(theta, d, a, alpha):
    """A standard link matrix whose degrees are taken for radians."""
    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
    return sp.Matrix([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d],
                      [0, 0, 0, 1]])


# (exercise, answer, words of the praise)
ALSO = [
    ("dh_recipe.6", [radians(-210), 0.3, -0.5, radians(300)], "Four numbers out"),
    ("dh_recipe.3", list(A_1), "A_1 turns"),
    ("dh_recipe.2", table(r3c0=0), "another tool frame"),
    ("dh_recipe.2", table(r1c0=t1 + HALF, r1c3=-RIGHT_ANGLE, r2c0=t2 - RIGHT_ANGLE), "x1 points"),
    ("dh_recipe.2", table(r1c3=-RIGHT_ANGLE, r2c0=-t2 - RIGHT_ANGLE, r2c1=-L,
                          r2c3=-RIGHT_ANGLE), "same mechanism"),
    ("dh_recipe.2", table(r2c0=t2 - RIGHT_ANGLE, r2c2=-a2, r2c3=-RIGHT_ANGLE), "same mechanism"),
    ("dh_recipe.2", table(r2c2=0, r3c0=0, r3c2=a2), "same mechanism"),
    ("dh_recipe.7", [(-z, x, o) for z, x, o in VIEW], "z0 points the other way"),
    ("dh_recipe.7", frames(2, z=-X), "z2 points the other way"),
    ("dh_recipe.7", frames(3, z=Y, x=-Z), "z1 points the other way, so joint 2 counts backwards"),
    ("dh_recipe.7", [(5 * Z, Y, (0, 0, -2)), *FRAMES[1:]], "z1 points"),
    ("dh_recipe.7", [*FRAMES[:2], (X, Z, (0, -1, 3)), (X, (0, 0.8, -2.1), O_3)], "z1 points"),
]

# (exercise, answer, words of the message)
WRONG = [
    ("dh_recipe.6", [2.618, 0.3, -0.5, -1.047], "np.radians turns degrees"),
    ("dh_recipe.6", [MEASURED[0], ..., ..., ...], "theta is right; d, a and alpha are"),
    ("dh_recipe.2", table(r2c0=t2 - RIGHT_ANGLE), "The offset of joint 2 has the wrong sign"),
    ("dh_recipe.2", table(r1c3=90, r2c0=t2 + 90, r2c3=90, r3c0=90), "write sp.pi/2 for 90"),
    ("dh_recipe.2", TABLE[:2].tolist() + [[...] * 4], "for the frames of the view; theta of row"),
    ("dh_recipe.3", A_1.tolist(), "Wrap it in sp.Matrix"),
    ("dh_recipe.3", in_degrees(t1, d1, 0, 90), "write sp.pi/2 for 90°"),
    ("dh_recipe.4", in_degrees(t2 + 90, L, a2, 90), "write sp.pi/2 for 90°"),
    ("dh_recipe.4", A_2.subs(t2, t2 - sp.pi), "The offset of joint 2 has the wrong sign"),
    ("dh_recipe.3", -A_1, "All signs are turned round"),
    ("dh_recipe.1", [{1, 2, 3, 4, 5}, {1, 2, 4}, {1, 4}], "Where does Ry(90°) take"),
    ("dh_recipe.1", [{1, 3, 4}, {1, 2, 4}, {1, 4}], "Rx(90°) leaves the x axis"),
    ("dh_recipe.1", [{1, 3, 4, 5}, {1, 2, 3, 4}, {1, 4}], "how near does it come to z0"),
    ("dh_recipe.1", [{1, 3, 4, 5}, {1, 2, 4, 5}, {1, 4}], "slides along the z axis after"),
    ("dh_recipe.1", [{1, 3, 4, 5}, {1, 4}, {1, 4}], "share the origin"),
    ("dh_recipe.1", [{1, 3, 4, 5}, {1, 2, 4}, {1}], "keeps both rules"),
    ("dh_recipe.1", [{1, 3, 4, 5}, {1, 2, 4}, {7}], "no transform 7"),
    ("dh_recipe.2", table(r1c3=90, r2c0=t2 + 90, r2c3=90, r3c0=90), "Angles are in radians"),
    ("dh_recipe.2", table(r2c0=t2), "offset of joint 2"),
    ("dh_recipe.2", table(r1c3=-RIGHT_ANGLE, r2c3=-RIGHT_ANGLE), "sign of alpha"),
    ("dh_recipe.2", TABLE[:, [0, 2, 1, 3]], "changed places"),
    ("dh_recipe.2", np.array([[t1, d1, 0, 0], [t2 + RIGHT_ANGLE, L, 0, RIGHT_ANGLE],
                              [RIGHT_ANGLE, d3, a2, RIGHT_ANGLE]]), "modified (Craig) table"),
    ("dh_recipe.2", table(r3c1=0), "Row 3: its joint variable is d_3"),
    ("dh_recipe.2", table(r1c0=2 * t1), "Row 1: its joint variable is theta_1"),
    ("dh_recipe.2", table(r2c2=t2), "Row 2: its joint variable is theta_2"),
    ("dh_recipe.2", table(r3c0=d3, r3c1=0), "Joint 3 is prismatic on the arm"),
    ("dh_recipe.2", table(r1c1=0), "Joint 1: the offset d1 is 0"),
    ("dh_recipe.2", table(r1c1=d1 + L), "Joint 1: the offset d1 is 0.7"),
    ("dh_recipe.2", table(r1c3=0), "Joint 1: the twist alpha1 is 0°"),
    ("dh_recipe.2", table(r2c3=0), "Joint 2: the twist alpha2 is 0°"),
    ("dh_recipe.2", table(r2c1=0), "Joint 2: the offset d2 is 0"),
    ("dh_recipe.2", table(r2c2=2 * a2), "Joint 2: the length a2 is 0.8; it should be 0.4"),
    ("dh_recipe.2", table(r3c1=d3 + L), "does not stand as in the view"),
    ("dh_recipe.2", table(r3c1=sp.Symbol("q_3")), "d of row 3 holds q_3"),
    ("dh_recipe.2", table(r2c1=...), "for the frames of the view; d of row 2 is still to do."),
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
    ("dh_recipe.6", MEASURED[:3], "expected four numbers; you gave three"),
    ("dh_recipe.2", table(r2c1=-L), "the offset d2 is -0.2; it should be 0.2: its sign is"),
    ("dh_recipe.2", table(r2c1=-L), "but the tip is 0.4 m away from where it should be"),
    ("dh_recipe.2", table(r1c3=-RIGHT_ANGLE, r2c0=-t2 - RIGHT_ANGLE, r2c1=L, r2c3=-RIGHT_ANGLE),
     "Row 2: the sign of d is wrong."),
    ("dh_recipe.7", frames(3, origin=(0.5, -0.2, 0.9)), "O_3 is 0.1 m away from the tip"),
    ("dh_recipe.7", VIEW, "every z points as in the view"),
    ("dh_recipe.7", frames(1, x=Z), "Rule 1: x1 is not perpendicular to z0"),
    ("dh_recipe.7", frames(2, x=-Y), "turn x2 by 90° about z2"),
    ("dh_recipe.7", frames(2, origin=(0.1, -0.2, 0.9)), "slide the origin by -0.1 m along z2"),
    ("dh_recipe.7", frames(1, origin=(0, 0, 0.6)), "0.1 m away from the axis of joint 2"),
    ("dh_recipe.7", frames(1, z=X), "z1 must lie along the axis of joint 2"),
    ("dh_recipe.7", frames(3, x=X), "x3 and z3 are 0° apart"),
    ("dh_recipe.7", FRAMES[:3], "expected 4 frames"),
    ("dh_recipe.7", frames(2, origin=...),
     "Two frames placed well so far: frame 0 and frame 1. Still to do: O2."),
    ("dh_recipe.7", [FRAMES[0], ..., [..., X, O_2], [..., ..., ...]],
     "Still to do: z1, x1, O1, z2 and 3 more."),
    ("dh_recipe.7", [*frames(1, x=Z)[:3], ...], "Rule 1: x1 is not perpendicular to z0"),
    ("dh_recipe.7", [(..., X, (0, 0, 0)), *FRAMES[1:]], "Still to do: z0."),
    ("dh_recipe.7", frames(2, x=(0, 0, 0)), "expected a direction for x"),
]

STUBS = [("dh_recipe.1", [..., ..., ...]), ("dh_recipe.1", ...),
         ("dh_recipe.2", np.array([[...] * 4] * 3, dtype=object)), ("dh_recipe.2", None),
         ("dh_recipe.3", ...), ("dh_recipe.4", ...), ("dh_recipe.5", ...),
         ("dh_recipe.6", [..., ..., ..., ...]), ("dh_recipe.6", ...),
         ("dh_recipe.7", [[..., ..., ...]] * 4), ("dh_recipe.7", ...)]
