"""Answers to the exercises of Practical 3: right, typically wrong, and not attempted."""
from dataclasses import replace
from math import atan2, cos, hypot, pi

import numpy as np
import textbook

import kinlab as kl


def link_matrix(alpha, a, d, theta):
    return textbook.modified(theta, d, a, alpha)


def forward(table, tool, link=link_matrix):
    T = np.eye(4)
    for row in table:
        T = T @ link(*row)
    return T, (T @ [*tool, 1])[:3]


ALPHA, A, D = [0, 90, 0, -90, 90, -90], [0, 0, 0.5, 0, 0, 0], [0, -0.5, 0, 1, 0, 0]


def six(alpha=ALPHA, a=A, d=D, theta=(0,) * 6, tool=(0, 0, 1), convention="modified",
        turn=np.radians):
    rows = zip(turn(alpha), a, d, np.radians(theta))
    links = [kl.revolute(alpha=al, a=a_i, d=d_i, theta=t) for al, a_i, d_i, t in rows]
    return kl.Arm(links, convention=convention, tool=kl.translation(tool))


def zyz(R):
    s = hypot(R[0, 2], R[1, 2])
    return [[atan2(R[1, 2], R[0, 2]), atan2(s, R[2, 2]), atan2(R[2, 1], -R[2, 0])],
            [atan2(-R[1, 2], -R[0, 2]), atan2(-s, R[2, 2]), atan2(-R[2, 1], R[2, 0])]]


RIGHT = {
    "n_link.1": link_matrix,
    "n_link.2": forward,
    "n_link.3": six(),
    "n_link.4": zyz,
    "n_link.5": np.radians([0, 90, -50, 0, -40, 0]),
}


def turned(function):
    return lambda *row: function(link_matrix(*row))


def with_entry(row, column, value):
    def link(alpha, a, d, theta):
        T = link_matrix(alpha, a, d, theta)
        T[row, column] = value(alpha, d, theta)
        return T
    return link


def degrees_again(alpha, a, d, theta):
    return link_matrix(np.radians(alpha), a, d, np.radians(theta))


def standard(alpha, a, d, theta):
    return textbook.standard(theta, d, a, alpha)


def as_printed(table, tool):
    T = np.eye(4)
    for k, row in enumerate(table):
        A = link_matrix(*row)
        A[2, 2] = cos(table[k + 1][0]) if k + 1 < len(table) else 1
        T = T @ A
    return T, (T @ [*tool, 1])[:3]


def reversed_chain(table, tool):
    return forward(table[::-1], tool)


def printed_zyz(R):
    first, second = zyz(R)
    return [first, [*second[:2], atan2(-R[1, 2], R[2, 0])]]


def same_psi(R):
    first, second = zyz(R)
    return [first, [*second[:2], first[2]]]


def unsigned(R):
    first, second = zyz(R)
    return [[*first[:2], atan2(R[2, 1], R[2, 0])], second]


# z2, z3 and z4 turned round: their joints count backwards, and joint 2 starts half a turn away
TURNED = kl.Arm([kl.revolute(), kl.revolute(alpha=-pi / 2, d=0.5), kl.revolute(a=0.5),
                 kl.revolute(alpha=pi / 2, d=1), kl.revolute(alpha=pi / 2),
                 kl.revolute(alpha=-pi / 2)], convention="modified", tool=kl.translation([0, 0, 1]))

# (exercise, answer, words of the praise)
ALSO = [
    ("n_link.3", kl.to_standard(six()), "standard DH instead of modified"),
    ("n_link.3", six(tool=(0, 0, 0), d=[0, -0.5, 0, 1, 0, 1]), "another tool frame"),
    ("n_link.3", replace(six(), base=kl.translation([1, 2, 3])), "another base frame"),
    ("n_link.3", TURNED, "points the other way"),
]

# (exercise, answer, words of the message)
WRONG = [
    ("n_link.1", standard, "standard link matrix"),
    ("n_link.1", degrees_again, "radians"),
    ("n_link.1", textbook.modified, "order of the table"),
    ("n_link.1", lambda al, a, d, t: link_matrix(al, d, a, t), "changed places"),
    ("n_link.1", turned(np.transpose), "transpose"),
    ("n_link.1", turned(np.linalg.inv), "inverse"),
    ("n_link.1", lambda al, a, d, t: link_matrix(-al, a, d, t), "sign of alpha"),
    ("n_link.1", lambda al, a, d, t: link_matrix(al, a, d, -t), "sign of theta"),
    ("n_link.1", with_entry(2, 2, lambda al, d, t: cos(t)), "not of theta"),
    ("n_link.1", lambda al, a, d, t: link_matrix(al, a, 0, t) + d * np.eye(4)[[2]].T
     @ np.eye(4)[[3]], "rows 2 and 3"),
    ("n_link.1", turned(lambda T: T[:3]), "four rows of four numbers; your function gave three"),
    ("n_link.1", np.eye(4), "Expected a function"),
    ("n_link.2", lambda table, tool: forward(table, [0, 0, 0]), "tool vector is forgotten"),
    ("n_link.2", lambda table, tool: (forward(table, tool)[0],
                                      forward(table, [0, 0, 0])[1] + tool), "turn it by R"),
    ("n_link.2", lambda table, tool: forward(table, tool, standard), "table is modified"),
    ("n_link.2", lambda table, tool: forward(table, tool, degrees_again), "radians"),
    ("n_link.2", as_printed, "the hint as printed"),
    ("n_link.2", reversed_chain, "reverse order"),
    ("n_link.2", lambda table, tool: forward(table[:-1], tool), "last link is missing"),
    ("n_link.2", lambda table, tool: forward(table[1:], tool), "first link is missing"),
    ("n_link.2", lambda table, tool: forward(table, tool)[0], "return T, p"),
    ("n_link.2", lambda table, tool: forward(table, tool)[::-1], "T and p have changed places"),
    ("n_link.2", lambda table, tool: (forward(table, tool)[0], forward(table, tool)[1] + 1),
     "x of p_E should be"),
    ("n_link.2", forward([[0, 0, 0, 0]], [0, 0, 0]), "Expected a function"),
    ("n_link.3", six(convention="standard"), "convention='modified'"),
    ("n_link.3", six(tool=(0, 0, 0)), "tool is forgotten"),
    ("n_link.3", six(tool=(1, 0, 0)), "not along x6"),
    ("n_link.3", six(d=np.abs(D)), "-d2"),
    ("n_link.3", six(turn=np.array), "Angles are in radians"),
    ("n_link.3", six(a=[0, 0, 0.4, 0, 0, 0]), "Joint 3: the length a2 (in row 3) is 0.4"),
    ("n_link.3", six(d=[0, -0.5, 0, 0, 0, 0]), "Joint 4: the offset d4 is 0; it should be 1"),
    ("n_link.3", six(alpha=[0, 90, 0, -90, 0, -90]), "alpha4 (in row 5) is 0°"),
    ("n_link.3", six(theta=[0, 0, 30, 0, 0, 0]), "theta3 should hold the offset 0°"),
    ("n_link.3", kl.Arm([*six().links[:5], kl.prismatic(alpha=-pi / 2)], tool=six().tool,
                        convention="modified"), "Joint 6 is revolute on the arm"),
    ("n_link.3", six(alpha=-np.array(ALPHA)), "all turned round"),
    ("n_link.3", six(alpha=np.roll(ALPHA, -1), a=np.roll(A, -1)), "one row too high"),
    ("n_link.3", six(theta=[0, 90, -90, 0, 0, 0]), "not offsets"),
    ("n_link.3", kl.robots.two_link(), "has 2 joints, the arm has 6"),
    ("n_link.3", "arm", "Expected an arm"),
    ("n_link.4", printed_zyz, "the printed atan2(-r23, r31)"),
    ("n_link.4", same_psi, "turn round"),
    ("n_link.4", unsigned, "minus is missing"),
    ("n_link.4", lambda R: np.degrees(zyz(R)), "leave them in radians"),
    ("n_link.4", lambda R: zyz(R)[::-1], "comes first"),
    ("n_link.4", lambda R: zyz(R.T), "transpose"),
    ("n_link.4", lambda R: np.array(zyz(R))[:, ::-1], "phi and psi have changed places"),
    ("n_link.4", lambda R: zyz(R)[0], "two rows of three numbers; your function gave three"),
    ("n_link.5", [0, 90, -50, 0, -40, 0], "np.radians"),
    ("n_link.5", np.radians([0, 90, -50, 0, 40, 0]), "sign of theta_5"),
    ("n_link.5", np.radians([0, 90, 50, 0, 40, 0]), "straight down"),
    ("n_link.5", np.radians([0, 90, -90, 0, 0, 0]), "lean the forearm"),
    ("n_link.5", np.radians([0, 90, -80, 0, -10, 0]), "bends the wrist by 10"),
    ("n_link.5", np.radians([0, 90, -50, 0, -60, 0]), "20° away"),
    ("n_link.5", [0, pi, 0], "expected six joint values; you gave three"),
    ("n_link.5", [[0] * 6] * 2, "six joint values; you gave two rows"),
]

STUBS = [("n_link.1", ...), ("n_link.1", lambda alpha, a, d, theta: ...),
         ("n_link.2", None), ("n_link.2", lambda table, tool: ...),
         ("n_link.2", lambda table, tool: None), ("n_link.3", ...), ("n_link.3", None),
         ("n_link.4", lambda R: ...), ("n_link.4", ...), ("n_link.5", ...)]


# ---- Slips that classes are likely to make ------------------------------------------------------

def four(alpha, a, d, theta):
    """The four motions of a modified link: Rx, Tx, Rz, Tz."""
    return [link_matrix(alpha, 0, 0, 0), link_matrix(0, a, 0, 0), link_matrix(0, 0, 0, theta),
            link_matrix(0, 0, d, 0)]


def wrong_sign(*places):
    def link(*row):
        T = link_matrix(*row)
        for place in places:
            T[place] = -T[place]
        return T
    return link


def standard_column(*row):
    T = link_matrix(*row)
    T[:, 3] = standard(*row)[:, 3]
    return T


def by_entry(table, tool):
    T = np.eye(4)
    for row in table:
        T = T * link_matrix(*row)
    return T, T @ [*tool, 1]


def to_the_tip(table, tool):
    T, p = forward(table, tool)
    return T @ kl.translation(tool), p


def tool_twice(table, tool):
    T = to_the_tip(table, tool)[0]
    return T, (T @ [*tool, 1])[:3]


def as_direction(table, tool):
    T, _ = forward(table, tool)
    return T, (T @ [*tool, 0])[:3]


def in_a_column(table, tool):
    T, p = forward(table, tool)
    return T, p[:, None]


def with_arctan(R):
    s = hypot(R[0, 2], R[1, 2])
    phi, theta = np.arctan(R[1, 2] / R[0, 2]), np.arctan(s / R[2, 2])
    psi = np.arctan(R[2, 1] / -R[2, 0])
    return [[phi, theta, psi], [phi, -theta, psi]]


def phi_by_arctan(R):
    first, second = zyz(R)
    return [[np.arctan(R[1, 2] / R[0, 2]), *first[1:]],
            [np.arctan(R[1, 2] / R[0, 2]), *second[1:]]]


def theta_by_arcsin(R):
    first, second = zyz(R)
    s = np.arcsin(hypot(R[0, 2], R[1, 2]))
    return [[first[0], s, first[2]], [second[0], -s, second[2]]]


def exchanged_atan2(R):
    first, second = zyz(R)
    return [[atan2(R[0, 2], R[1, 2]), *first[1:]], [atan2(-R[0, 2], -R[1, 2]), *second[1:]]]


def counted_from_one(R):
    return [[atan2(R[2, 3], R[1, 3]), 0, 0], [0, 0, 0]]


def sign_of_alpha(row):
    return six(alpha=[-angle if k == row else angle for k, angle in enumerate(ALPHA, start=1)])


ALSO += [
    ("n_link.2", in_a_column, "two, three and six links"),
    ("n_link.2", lambda table, tool: [forward(table, tool)[0].tolist(),
                                      [*forward(table, tool)[1], 1]], "two, three and six links"),
    ("n_link.4", lambda R: np.array(zyz(R)) + [[2 * pi, 0, -2 * pi], [0, 2 * pi, 0]],
     "Both branches"),
    ("n_link.4", lambda R: [zyz(R)[0], np.array(zyz(R)[0]) * [1, -1, 1] + [pi, 0, pi]],
     "Both branches"),
    ("n_link.5", np.radians([0, 450, -50, 0, -40, 0]), "degenerate"),
    ("n_link.5", [0, pi / 2, -pi / 4, 0, -pi / 4, 0], "degenerate"),
]

WRONG += [
    ("n_link.1", wrong_sign((1, 2), (1, 3)), "sign of sin(alpha) is wrong"),
    ("n_link.1", wrong_sign((2, 0), (2, 1)), "sign of sin(alpha) is wrong"),
    ("n_link.1", wrong_sign((1, 2)), "Only the sign of the entry in row 2, column 3 is wrong"),
    ("n_link.1", wrong_sign((1, 3)), "Only the sign of the entry in row 2, column 4 is wrong"),
    ("n_link.1", wrong_sign((0, 1)), "Only the sign of the entry in row 1, column 2 is wrong"),
    ("n_link.1", standard_column, "last column is that of the standard matrix"),
    ("n_link.1", lambda al, a, d, t: link_matrix(t, a, d, al), "theta and alpha have changed"),
    ("n_link.1", lambda al, a, d, t: link_matrix(al, a, d, pi / 2 - t), "cosine of theta"),
    ("n_link.1", lambda al, a, d, t: link_matrix(pi / 2 - al, a, d, t), "cosine of alpha"),
    ("n_link.1", lambda al, a, d, t: link_matrix(al, 0, d, t), "a along x is left out"),
    ("n_link.1", lambda al, a, d, t: link_matrix(al, a, 0, t), "d along z is left out"),
    ("n_link.1", lambda *row: np.prod(four(*row), axis=0), "multiplies entry by entry"),
    ("n_link.1", lambda al, a, d, t: link_matrix(al, a, 0, 0) * link_matrix(0, 0, d, t),
     "multiplies entry by entry"),
    ("n_link.1", lambda al, a, d: link_matrix(al, a, d, 0), "takes 3 arguments"),
    ("n_link.2", by_entry, "multiplies entry by entry"),
    ("n_link.2", lambda table, tool: forward(table, tool, lambda *row: np.prod(four(*row), axis=0)),
     "multiplies entry by entry"),
    ("n_link.2", to_the_tip, "T reaches to the tip"),
    ("n_link.2", tool_twice, "counted twice"),
    ("n_link.2", as_direction, "that of a direction 0"),
    ("n_link.2", lambda table, tool: forward(table[:2], tool), "Only the first two rows"),
    ("n_link.2", lambda table, tool: forward(table[-1:], tool), "last link alone"),
    ("n_link.2", lambda table, tool: forward(table, tool, lambda *row: link_matrix(*row[::-1])),
     "alpha, a, d, theta, in this order"),
    ("n_link.2", lambda table, tool: (forward(table, tool)[0].T, forward(table, tool)[1]),
     "T is transposed"),
    ("n_link.2", lambda table, tool: (forward(table, tool)[0], ...), "T is right; p is still to"),
    ("n_link.2", lambda table, tool: (..., forward(table, tool)[1]), "p is right; T is still to"),
    ("n_link.4", lambda R: [zyz(R)[0], ...], "the first branch is right; the second branch is"),
    ("n_link.2", lambda table, tool: forward(table, tool)[1], "your function gave one. End with"),
    ("n_link.2", lambda table, tool: (*forward(table, tool), 1), "your function gave 3"),
    ("n_link.2", lambda table, tool: (forward(table, tool)[0], forward(table, tool)[1][:2]),
     "p should be three numbers; yours is a list of 2"),
    ("n_link.2", lambda table, tool: (forward(table, tool)[0][:3], forward(table, tool)[1]),
     "T should be a 4x4 matrix; yours is a matrix of 3 x 4"),
    ("n_link.2", lambda table, tool: (forward(table, tool)[0],
                                      forward(table, tool)[0] * [*tool, 1]),
     "p should be three numbers; yours is a matrix of 4 x 4"),
    ("n_link.2", lambda table, tool: (forward(table, tool)[0], forward(table, tool)[0] @ tool),
     "two matrices do not fit"),
    ("n_link.3", kl.robots.practical_six_link(), "kinlab has ready"),
    ("n_link.3", kl.to_standard(kl.robots.practical_six_link()), "kinlab has ready"),
    ("n_link.3", sign_of_alpha(2), "The sign of alpha in row 2 is wrong"),
    ("n_link.3", sign_of_alpha(4), "alpha3 (in row 4) should be -90°: its sign is wrong"),
    ("n_link.3", sign_of_alpha(5), "alpha4 (in row 5) should be 90°: its sign is wrong"),
    ("n_link.3", sign_of_alpha(6), "alpha5 (in row 6) should be -90°: its sign is wrong"),
    ("n_link.3", six(a=[0, 0.5, 0, 0, 0, 0]), "a2 = 0.5 stands in row 2. It belongs in row 3"),
    ("n_link.3", six(a=[0, 0, 0, 0.5, 0, 0]), "a2 = 0.5 stands in row 4. It belongs in row 3"),
    ("n_link.3", six(a=[0, 0, -0.5, 0, 0, 0]), "a2 (in row 3) should be 0.5: its sign is wrong"),
    ("n_link.3", six(d=[0, -0.5, 0, -1, 0, 0]), "d4"),
    ("n_link.3", six(d=[0, -0.5, 0, 1, 0, 1]), "d6 = 1 is counted twice"),
    ("n_link.3", six(tool=(0, 0, -1)), "points backwards"),
    ("n_link.3", six(tool=(0, 1, 0)), "check row 6 and the tool"),
    ("n_link.3", six(d=A, a=D), "a and d have changed places"),
    ("n_link.4", with_arctan, "cannot tell opposite directions apart"),
    ("n_link.4", phi_by_arctan, "arctan(r23 / r13) cannot tell"),
    ("n_link.4", theta_by_arcsin, "arcsin cannot tell 80° from 100°"),
    ("n_link.4", exchanged_atan2, "atan2 takes y first"),
    ("n_link.4", counted_from_one, "there is no index 3. Python counts from 0"),
    ("n_link.4", lambda R: [zyz(R)[0], np.array(zyz(R)[0]) * [1, -1, 1]], "theta turned round"),
    ("n_link.4", lambda R: [zyz(R)[0], [*zyz(R)[1][:1], zyz(R)[0][1], zyz(R)[1][2]]],
     "In the second its sine is negative"),
    ("n_link.4", lambda R: kl.zyz_angles(R).solutions, "kinlab's own `zyz_angles`"),
    ("n_link.4", lambda R: kl.zyz_angles(R), "kinlab's own `zyz_angles`"),
    ("n_link.5", np.radians([0, 90, -50, 0, -40]), "you gave five"),
    ("n_link.5", np.radians([0, 0, 0, 0, -40, 0]), "away from straight up"),
    ("n_link.5", np.radians([0, 90, 0, 0, 90, 0]), "away from straight up"),
    ("n_link.5", kl.inverse_kinematics(six(), [0, 0, 2]), "Hand over its .q"),
]

STUBS += [("n_link.2", lambda table, tool: (..., ...)), ("n_link.5", [...] * 6)]
