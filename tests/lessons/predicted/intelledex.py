"""Lesson 08: by hand, and by poses of the arm."""
import math

import numpy as np

import kinlab as kl

from . import Held

ARM = kl.robots.intelledex_660t()
JACOBIAN = kl.jacobian(ARM, ARM.home)
RANK = np.linalg.matrix_rank(JACOBIAN / np.repeat([838.2, 1], 3)[:, None], tol=1e-9)


def pose(frame, *degrees):
    return kl.link_frames(ARM, np.radians(degrees))[frame]


def turn(axis, about):
    """Degrees of an axis about one of the room's, as a student counts them."""
    k = (("z", "x", "y").index(about), ("x", "y", "z").index(about))
    zero, one = axis[k[0]], axis[(k[0] + 1) % 3]
    return math.degrees(math.atan2(one, zero))


def crosses(rows):
    return ["".join("×" if abs(value) > 1e-9 else "0" for value in row) for row in rows]


assert np.allclose(pose(1, 90, -90, 90, 0, 90, 0)[:3, 2], [1, 0, 0])  # z1 along the arm
PREDICTED = {
    "intelledex.axes": [Held(["z₁, the shoulder roll", "z₅, the tool roll"],
                             [(["z₁, the shoulder roll"], "“z₅, the tool roll” is missing"),
                              (["z₀, the base", "z₁, the shoulder roll", "z₅, the tool roll"],
                               "It stands upright")])],
    "intelledex.roll": [
        Held(turn(pose(4, 90, 0, 90, 0, 90, 0)[:3, 2], "x"),
             [(90, "the other way round"), (180, "carries all"), (0, "off")]),
        Held(turn(pose(4, 90, -180, 90, 0, 90, 0)[:3, 2], "x"),
             [(-90, "the other way round"), (180, "carries all")])],
    "intelledex.free": [Held(["α₂", "α₅", "joints 3, 4 and 5"],
                             [(["α₂", "joints 3, 4 and 5"], "“α₅” is missing"),
                              (["α₁", "α₂", "α₅", "joints 3, 4 and 5"], "both are as they were"),
                              (["α₂", "α₅"], "They turn about z₂")])],
    "intelledex.sums": [Held("θ₃, θ₄ and θ₅", [("θ₁ and θ₂", "right angle"),
                                               ("θ₅ and θ₆", "z₄ and z₅")])],
    "intelledex.plane": [
        Held(turn([0, 0, 1], "y"), [(180, "not down"), (90, "off")]),
        Held(turn([1, 0, 0], "z"), [(180, "to the left"), (-90, "off")])],
    "intelledex.soft_home": [
        Held([838.2, 0, 373.4], [((838.2, 0, 0), "column"), ((609.6, 0, 373.4), "the wrist")]),
        Held(pose(6, 90, -90, 180, 0, 90, 0)[:3, 3], [((0, 0, 838.2), "373.4 mm up"),
                                                      ((838.2, 0, 373.4), "away")])],
    "intelledex.yaw": [
        Held(turn(pose(6, 90, 0, 90, 0, 0, 0)[:3, 2], "z"), [(-90, "other side"), (0, "off")]),
        Held(turn(pose(6, 90, 0, 90, 0, 180, 0)[:3, 2], "z"), [(90, "other side"), (0, "off")])],
    "intelledex.movers": [Held(crosses(JACOBIAN[:3]), [
        (["×00000", "×00000", "00×××0"], "17 of 18"),
        (["000000", "000000", "00××00"], "16 of 18")])],
    "intelledex.rank": [Held(RANK, [(6, "bent arm"), (5, "not the only one"), (3, "too little")])],
    "intelledex.wrist": [
        Held(pose(5, 90, -90, 90, 90, 90, 0)[:3, 3], [((609.6, 0, 373.4), "does move the wrist"),
                                                      ((304.8, 0, 906.8), "the tip")]),
        Held([609.6, 0, 373.4], [((609.6, 0, 602), "the tip"), ((760, 0, 500), "away")])],
    "intelledex.meet": [Held("1, 2 and 3", [("3, 4 and 5", "parallel"),
                                            ("4, 5 and 6", "parallel"),
                                            ("2, 5 and 6", "not in every pose")])],
}
