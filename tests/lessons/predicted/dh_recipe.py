"""What lesson 05 asks, held against matrices that are multiplied here."""
import numpy as np
import textbook

import kinlab as kl

from . import Held

X, Y, Z = np.eye(3)
EXAM, ALPHA = kl.robots.exam_2018(), kl.robots.alpha_ii()


def frame(theta=0.0, d=0.0, a=0.0, alpha=0.0):
    """The link matrix, angles in degrees."""
    return textbook.standard(np.radians(theta), d, a, np.radians(alpha))


def turned(axis, about):
    """Degrees of a direction about an axis of the room: from x about z, y about x, z about y."""
    start = {"x": Y, "y": Z, "z": X}[about]
    across = np.cross({"x": X, "y": Y, "z": Z}[about], start)
    return np.degrees(np.arctan2(axis @ across, axis @ start))


def exam(i, *q):
    """Frame i of the exam arm, angles in degrees."""
    return kl.link_frames(EXAM, [np.radians(q[0]), np.radians(q[1]), q[2]])[i]


def twist(theta, alpha, about, wrong):
    return Held(turned(frame(theta, 0, 0, alpha)[:3, 2], about),
                [(wrong, "Right thumb along"), (45, "off")])


def x_2(theta):
    return Held(turned(exam(2, 0, theta, 0.4)[:3, 0], "y"),
                [(180 - theta, "but the other way"), (90 - theta, "There z₂ points")])


def origin(done, wrong, words):
    """The origin after so many of the four motions of link 2, at zero."""
    motions = [frame(90), frame(d=0.2), frame(a=0.4), frame(alpha=90)]
    T = exam(1, 0, 0, 0.4)
    for motion in motions[:done]:
        T = T @ motion
    return Held(T[:3, 3], [(wrong, words), ((0, 0.3, 0.3), "away")])


def column(row, *wrong):
    return Held(frame(*row)[:3, 3], list(wrong))


def pattern(**fixed):
    """Which entries stay zero for many numbers of a row, but for those that are fixed."""
    rows = [dict(theta=t, d=d, a=a, alpha=al) | fixed for t in (20, 110, 250) for d in (0.3, -2)
            for a in (0.7, -1) for al in (35, 200)]
    zero = np.all(np.abs([frame(**row)[:3] for row in rows]) < 1e-9, axis=0)
    right = ["".join("0" if entry else "·" for entry in line) for line in zero]
    return Held(right, [(["····"] * 3, "the others are marked"),
                        (["00·0"] * 3, "the others are marked")])


PARALLEL, MEET, NOTHING = ("They are parallel.", "They meet, or are one line.",
                           "Nothing: it says how the frames were put.")

PREDICTED = {
    "dh_recipe.twist": [twist(0, 90, "x", 0), twist(0, -90, "x", 180), twist(90, 90, "y", -90)],
    "dh_recipe.which": [
        Held("θ₂", [("d₂", "along z₁"), ("none of them", "one of its numbers is the joint")]),
        Held("none of them", [("θ₂", "from x₁ to x₂"), ("α₂", "one stiff link")]),
        Held("none of them", [("d₂", "Joint 2 turns"), ("a₂", "links are stiff")])],
    "dh_recipe.x2": [x_2(40), x_2(-60), x_2(110)],
    "dh_recipe.zeros": [
        Held(["d₂", "α₂"], [(["d₂"], "parallel axes"), (["d₂", "α₂", "a₂"], "upper arm")]),
        Held(["d₄", "a₄"], [(["d₄"], "one point"), (["d₄", "a₄", "α₄"], "90° apart")]),
        Held(["a₅", "α₅"], [(["d₅", "α₅"], "that is the tool"), ([], "lies on z₄")])],
    "dh_recipe.says": [
        Held(PARALLEL, [(MEET, "a matter of aᵢ"), (NOTHING, "it is not free")]),
        Held(NOTHING, [(PARALLEL, "with any twist"), (MEET, "is aᵢ, not dᵢ")]),
        Held(MEET, [(PARALLEL, "is αᵢ, not aᵢ"), (NOTHING, "distance of two lines")])],
    "dh_recipe.broken": [
        Held("row 3, column 1", [("row 1, column 3", "Column 3 is z₁"),
                                 ("row 3, column 3", "cosine of the twist")]),
        Held("only rule 2", [("only rule 1", "right angle"), ("none", "still wrong")]),
        Held("only rule 1", [("only rule 2", "meets z₀"), ("both", "independent")])],
    "dh_recipe.origin": [origin(2, (0, 0.2, 0.5), "d₂ is positive"),
                         origin(1, (0, 0, 0.9), "comes later"),
                         origin(3, (0, -0.2, 0.5), "is done as well")],
    "dh_recipe.swaps": [Held(
        ["the turn by θ and the slide by d", "the slide by a and the turn by α",
         "the slide by d and the slide by a"],
        [(["the turn by θ and the slide by d"], "Both have the same axis, x"),
         (["the pair of z and the pair of x"], "you end elsewhere")])],
    "dh_recipe.column": [
        column((90, 0.5, 1), ((0, 0.5, 1), "a goes along x₁"), ((0, -1, 0.5), "from x₀ to y₀")),
        column((0, 0.5, 1, 90), ((1, 0, 1), "on that axis"), ((0, 0, 0.5), "away")),
        column((180, 0.5, -0.8), ((-0.8, 0, 0.5), "a is negative"), ((0, 0, 0.5), "away"))],
    "dh_recipe.pattern": [pattern(), pattern(alpha=0), pattern(alpha=90, a=0)],
}


def commute(A, B):
    return np.allclose(A @ B, B @ A)


assert commute(frame(30), frame(d=2)) and commute(frame(a=2), frame(alpha=40))
assert commute(frame(d=2), frame(a=3)) and not commute(frame(30, 2), frame(0, 0, 2, 40))
for _link, _zero in ((2, {"d", "alpha"}), (4, {"d", "a"}), (5, {"a", "alpha"})):
    assert {name for name in ("d", "a", "alpha")
            if not getattr(ALPHA.links[_link - 1], name)} == _zero
