"""Answers to the Alpha II lesson's exercises: right, typically wrong, and not attempted."""
from math import pi

import numpy as np
import sympy as sp
import textbook

import kinlab as kl

t1, t2, t3 = sp.symbols("theta_1 theta_2 theta_3")
c1, s1, c2, s2 = sp.cos(t1), sp.sin(t1), sp.cos(t2), sp.sin(t2)
c23, s23 = sp.cos(t2 + t3), sp.sin(t2 + t3)
OUT, DROP = 177.8 * (c2 + c23), 177.8 * (s2 + s23)
BEND = np.arcsin(85.5 / 177.8)

RIGHT = {
    "alpha_ii.1": textbook.standard,
    "alpha_ii.2": [c1 * OUT, s1 * OUT, 85.5 - DROP],
    "alpha_ii.3": [{2, 3, 4}, {1, 2, 3, 4}, {1, 2, 3, 4, 5}],
    "alpha_ii.4": [0, 0, BEND, -BEND, 0],
}


def swapped(theta, d, a, alpha):
    return textbook.standard(theta, a, d, alpha)


def turned(function):
    return lambda theta, d, a, alpha: function(textbook.standard(theta, d, a, alpha))


def part_transposed(T):
    T = T.copy()
    T[:3, :3] = T[:3, :3].T
    return T


def bare_slides(theta, d, a, alpha):
    T = textbook.standard(theta, 0, 0, alpha)
    T[:3, 3] = a, 0, d
    return T


def crash(theta, d, a, alpha):
    return np.cos(theta) / None


# (exercise, answer, words of the message)
WRONG = [
    ("alpha_ii.1", textbook.modified, "reverse order"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(np.radians(t), d, a, np.radians(al)),
     "radians"),
    ("alpha_ii.1", turned(np.transpose), "the transpose"),
    ("alpha_ii.1", turned(part_transposed), "rotation is transposed"),
    ("alpha_ii.1", turned(np.linalg.inv), "inverse"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(t, d, a, -al), "sign of alpha"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(-t, d, a, al), "sign of theta"),
    ("alpha_ii.1", swapped, "changed places"),
    ("alpha_ii.1", bare_slides, "slide along x comes after"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(t, 0, a, al), "d along z is left out"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(t, d, 0, al), "a along x is left out"),
    ("alpha_ii.1", turned(lambda T: T[:3, :3]), "four rows of four numbers; your function gave"),
    ("alpha_ii.1", turned(lambda T: T + 0.01), "row 1, column 1 should be 1, got 1.01"),
    ("alpha_ii.1", turned(lambda T: T * np.nan), "finite"),
    ("alpha_ii.1", turned(str), "expected four rows of four numbers"),
    ("alpha_ii.1", lambda theta: theta, "raised TypeError"),
    ("alpha_ii.1", crash, "raised TypeError"),
    ("alpha_ii.1", np.eye(4), "Expected a function"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, 215 - DROP], "forgotten"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, 215 - DROP + 129.5], "lowers the tip"),
    ("alpha_ii.2", [c1 * (OUT + 129.5), s1 * (OUT + 129.5), 215 - DROP], "not to the reach"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, 85.5 + DROP], "subtracted"),
    ("alpha_ii.2", [c1 * 177.8 * (c2 + sp.cos(t3)), s1 * 177.8 * (c2 + sp.cos(t3)),
                    85.5 - 177.8 * (s2 + sp.sin(t3))], "theta_2 + theta_3"),
    ("alpha_ii.2", [f * 177.8 * (c2 + c2 * sp.cos(t3)) for f in (c1, s1)] + [85.5 - DROP],
     "product of two cosines"),
    ("alpha_ii.2", [s1 * OUT, c1 * OUT, 85.5 - DROP], "changed places"),
    ("alpha_ii.2", [part / 1000 for part in RIGHT["alpha_ii.2"]], "millimetres"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, sp.Symbol("theta_4")], "p_z holds theta_4"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, "215"], "leave out the quotes"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, sp.sqrt(t2 - 9)], "not a real number"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, ...], "p_x and p_y are right; p_z is still to do."),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT], "got 2"),
    ("alpha_ii.2", "c1 * out", "in a list"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, 85.5 - DROP + 1], "p_z should be"),
    ("alpha_ii.3", [{1, 2, 3, 4}, {1, 2, 3, 4}, {1, 2, 3, 4, 5}], "not joint 1"),
    ("alpha_ii.3", [{2, 3, 4}, {1, 2, 3, 4, 5}, {1, 2, 3, 4, 5}], "approach vector lies along"),
    ("alpha_ii.3", [{2, 3, 4}, {1, 2, 3, 4}, {1, 2, 3, 4}], "one is missing"),
    ("alpha_ii.3", [{0, 1, 2}, {0}, {0}], "no joint 0"),
    ("alpha_ii.3", [2, 3, 4], "set of joint numbers"),
    ("alpha_ii.4", np.degrees(RIGHT["alpha_ii.4"]), "np.radians"),
    ("alpha_ii.4", [0, 0, BEND, BEND, 0], "sign of theta_4"),
    ("alpha_ii.4", [0, 0, BEND, pi - BEND, 0], "limits"),
    ("alpha_ii.4", [-3, 0, BEND, -BEND, 0], "Joint 1 is at -171.887°, 21.89° beyond"),
    ("alpha_ii.4", [0, 0, -BEND, BEND - pi + 1, 0], "away from straight down"),
    ("alpha_ii.4", [0, -BEND, pi / 2, pi / 2 + BEND, 0], "straight up"),
    ("alpha_ii.4", [0, np.arcsin(107.5 / 177.8), 0, -np.arcsin(107.5 / 177.8), 0], "the wrist"),
    ("alpha_ii.4", [0, 0, 0, 0, 0], "85.5 mm above the table"),
    ("alpha_ii.4", [0, 0, 0, 0], "expected five joint values; you gave four"),
    ("alpha_ii.4", [[0, 0, 0, 0, 0]] * 2, "five joint values; you gave two rows"),
    ("alpha_ii.4", "home", "plain numbers"),
]

STUBS = [("alpha_ii.1", ...), ("alpha_ii.1", None), ("alpha_ii.1", lambda theta, d, a, alpha: ...),
         ("alpha_ii.1", lambda theta, d, a, alpha: None), ("alpha_ii.2", [..., ..., ...]),
         ("alpha_ii.3", [..., ..., ...]), ("alpha_ii.3", ...), ("alpha_ii.4", ...)]


# ---- Slips that classes are likely to make ------------------------------------------------------

def four(theta, d, a, alpha):
    """The four motions of a standard link: Rz, Tz, Tx, Rx."""
    return [textbook.standard(theta, 0, 0, 0), textbook.standard(0, d, 0, 0),
            textbook.standard(0, 0, a, 0), textbook.standard(0, 0, 0, alpha)]


def wrong_sign(*places):
    def link(*row):
        T = textbook.standard(*row)
        for place in places:
            T[place] = -T[place]
        return T
    return link


def modified_column(*row):
    T = textbook.standard(*row)
    T[:, 3] = textbook.modified(*row)[:, 3]
    return T


def exchanged_column(theta, d, a, alpha):
    T = textbook.standard(theta, d, a, alpha)
    T[[0, 1], 3] = T[[1, 0], 3]
    return T


def tip(c23=c23, s23=s23, a2=177.8, a3=177.8, d1=215, c1=c1, s1=s1):
    out, drop = a2 * c2 + a3 * c23, a2 * s2 + a3 * s23
    return [c1 * out, s1 * out, d1 - drop - 129.5]


c3, s3 = sp.cos(t3), sp.sin(t3)

WRONG += [
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(al, d, a, t), "theta and alpha have"),
    ("alpha_ii.1", wrong_sign((1, 2)), "sign of sin(alpha) is wrong"),
    ("alpha_ii.1", wrong_sign((0, 2), (1, 2)), "sign of sin(alpha) is wrong"),
    ("alpha_ii.1", wrong_sign((2, 1)), "sign of sin(alpha) is wrong"),
    ("alpha_ii.1", wrong_sign((0, 1)), "Only the sign of the entry in row 1, column 2 is wrong"),
    ("alpha_ii.1", wrong_sign((1, 3)), "Only the sign of the entry in row 2, column 4 is wrong"),
    ("alpha_ii.1", lambda *row: np.prod(four(*row), axis=0), "multiplies entry by entry"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(t, d, 0, 0)
     * textbook.standard(0, 0, a, al), "multiplies entry by entry"),
    ("alpha_ii.1", modified_column, "last column is that of the modified matrix"),
    ("alpha_ii.1", exchanged_column, "a cos(theta) above a sin(theta)"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(pi / 2 - t, d, a, al), "cosine of theta"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(t, d, a, pi / 2 - al), "cosine of alpha"),
    ("alpha_ii.1", lambda t, d, a, al: kl.forward_kinematics(
        kl.Arm([kl.revolute(d=d, a=a, alpha=al)]), [t]), "kinlab's own `"),
    ("alpha_ii.2", tip(c23=c2 + c3, s23=s2 + s3), "not cos(theta_2) + cos(theta_3)"),
    ("alpha_ii.2", tip(c23=c2 + c3), "not cos(theta_2) + cos(theta_3)"),
    ("alpha_ii.2", tip(c23=c3), "not by theta_3 alone"),
    ("alpha_ii.2", tip(s23=s2 * s3), "product of two cosines"),
    ("alpha_ii.2", tip(c23=sp.cos(t2 - t3), s23=sp.sin(t2 - t3)), "not by their difference"),
    ("alpha_ii.2", tip(a3=0), "forearm, a3 = 177.8 mm, is forgotten"),
    ("alpha_ii.2", tip(a2=0), "upper arm, a2 = 177.8 mm, is forgotten"),
    ("alpha_ii.2", tip(d1=0), "d1 = 215 mm, is missing"),
    ("alpha_ii.2", tip(c1=1, s1=0), "lack joint 1"),
    ("alpha_ii.2", [c1 * DROP, s1 * DROP, 85.5 - OUT], "Sines and cosines"),
    ("alpha_ii.2", [..., s1 * OUT, 85.5 + DROP], "p_z should be"),
    ("alpha_ii.3", [{1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3, 4}], "Joints count from 1, not from 0"),
    ("alpha_ii.3", [{2, 3, 4}, {1, 2, 3}, {1, 2, 3, 4, 5}], "one is missing"),
    ("alpha_ii.3", [{2}, {1, 2, 3, 4}, {1, 2, 3, 4, 5}], "two are missing"),
    ("alpha_ii.3", [{2, 3, 4}, {2, 3, 4}, {5}], "Turn the base"),
    ("alpha_ii.3", [set(), {1, 2, 3, 4}, {1, 2, 3, 4, 5}], "three are missing"),
    ("alpha_ii.3", [{2, 3, 4}, ..., {1, 2, 3, 4, 5}], "a is still to do"),
    ("alpha_ii.4", [0, 0, BEND, -BEND + 2 * pi, 0], "limits"),
    ("alpha_ii.4", [0, 0, 0.48, -0.48, 0], "mm above the table; 0.5 mm is allowed"),
    ("alpha_ii.4", [0, 0, BEND, ..., ...], "still to do"),
    ("alpha_ii.4", kl.inverse_kinematics(kl.robots.alpha_ii(), [250, 0, 0]), "Hand over its .q"),
    ("alpha_ii.4", [0, 0, BEND, -BEND, 0, 0], "you gave six"),
]

ALSO = [
    ("alpha_ii.4", np.radians([0, 0, 28.7, -28.7, 0]), "on the table"),  # what sliders show
    ("alpha_ii.4", np.radians([20, 10.6, 6.7, -17.3, 5]), "on the table"),
]
