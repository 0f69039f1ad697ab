"""What the questions of the test are held against: both versions, by matrices or by hand."""
from math import sqrt

import numpy as np

from . import Held

S = sqrt(3) / 2
BESIDE = "the first joint stands 1 m beside the base, and the last link is missing"
SAME = "both joints turn about the same axis, at the base"
ERROR, ARM = "an error", "the same arm"


def R(axis, degrees):
    """A turn about an axis of the room."""
    k, c, s = "xyz".index(axis), np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    i, j = (k + 1) % 3, (k + 2) % 3
    made = np.eye(3)
    made[[i, i, j, j], [i, j, i, j]] = c, -s, s, c
    return made


def arrow(first, second, along):
    """Where an arrow points after two turns about axes of the room, as an option has it."""
    end = R(second, 90) @ R(first, 90) @ np.eye(3)["xyz".index(along)]
    k = int(np.argmax(np.abs(end)))
    return f"{'along' if end[k] > 0 else 'against'} {'xyz'[k]}₀"


def turned(degrees, *point):
    return (R("z", degrees) @ (*point, 0)).tolist()


def letters(degrees):
    rows = np.sign(np.round(R("z", degrees)[:2, :2], 9))
    return ["".join("0+-"[int(entry)] for entry in row) for row in rows]


SIDES = {"own": "T R: R stands on the right", "room": "R T: R stands on the left",
         "either": "either: the order does not matter"}

PREDICTED = {
    "pretest.shift": [Held("(−2, 3)", [("(4, 5)", "added"), ("(2, −3)", "back to the origin"),
                                       ("(1, 4)", "belong to a frame")])],
    "pretest.shift_again": [Held("(−3, 4)", [("(1, 2)", "added"), ("(3, −4)", "back to")])],
    "pretest.turned": [Held(turned(90, 2, 1), [([1, -2, 0], "the other way round"),
                                               ([-2, -1, 0], "half a turn"),
                                               ([2, 1, 0], "away")])],
    "pretest.turned_again": [Held(turned(-90, 1, 2), [([-2, 1, 0], "the other way round"),
                                                      ([-1, -2, 0], "half a turn")])],
    "pretest.axis": [Held(120, [(60, "along the row"), (30, "first column")])],
    "pretest.axis_again": [Held(150, [(30, "along the row"), (60, "first column")])],
    "pretest.walk": [Held([0, 2, 0], [([2, 0, 0], "slid along x₀"),
                                      ([0, -2, 0], "the other way round")])],
    "pretest.walk_again": [Held([0, -1.5, 0], [([1.5, 0, 0], "slid along x₀"),
                                               ([0, 1.5, 0], "the other way round")])],
    "pretest.side": [Held(SIDES["own"], [(SIDES["room"], "the z axis of the room"),
                                         (SIDES["either"], "do not commute"),
                                         ("T + R", "multiplied")])],
    "pretest.side_again": [Held(SIDES["room"], [(SIDES["own"], "its own z axis"),
                                                (SIDES["either"], "do not commute")])],
    "pretest.book": [Held(arrow("z", "x", "x"), [(arrow("x", "z", "x"), "other order"),
                                                 ("along x₀", "at least one"),
                                                 ("against z₀", "clockwise")])],
    "pretest.book_again": [Held(arrow("x", "y", "y"), [(arrow("y", "x", "y"), "other order"),
                                                       ("along y₀", "at least one")])],
    "pretest.belong": [Held(["θᵢ", "dᵢ"], [(["θᵢ", "αᵢ"], "α is the angle about xᵢ"),
                                           (["dᵢ", "aᵢ"], "a is the distance along xᵢ")])],
    "pretest.belong_again": [Held(["aᵢ", "αᵢ"], [(["θᵢ", "αᵢ"], "θ is the angle about zᵢ₋₁"),
                                                 (["dᵢ", "aᵢ"], "d is the distance along")])],
    "pretest.link": [Held("aᵢ = 0.4 m, αᵢ = 0", [("aᵢ = 0, αᵢ = 0", "one line"),
                                                 ("aᵢ = 0.4 m, αᵢ = 90° or −90°", "no angle")])],
    "pretest.link_again": [Held("aᵢ = 0.3 m, αᵢ = 90° or −90°", [
        ("aᵢ = 0.3 m, αᵢ = 0", "parallel"), ("aᵢ = 0, αᵢ = 90° or −90°", "that meet")])],
    "pretest.offset": [Held("θ = q₂ + 90°", [("θ = q₂", "against the drawing"),
                                             ("θ = 90°", "not turn at all"),
                                             ("θ = q₂ − 90°", "put q = 0")])],
    "pretest.offset_again": [Held("θ = q₃ − 90°", [("θ = q₃", "against the drawing"),
                                                   ("θ = −90°", "not turn at all")])],
    "pretest.twist": [Held(-90, [(90, "thumb of the right hand"), (0, "not parallel")])],
    "pretest.twist_again": [Held(90, [(-90, "thumb of the right hand"), (180, "not parallel")])],
    "pretest.signs": [Held(letters(30), [(["++", "-+"], "entries"), (["+-", "-+"], "entries")])],
    "pretest.signs_again": [Held(letters(120), [(["-+", "--"], "entries"),
                                                (["+-", "++"], "entries")])],
    "pretest.misread": [Held(SAME, [(ERROR, "No rule is broken"), (ARM, "another order")])],
    "pretest.misread_again": [Held(BESIDE, [(ERROR, "No rule"), (ARM, "another order")])],
}
