"""Lesson 10: by geometry, and by steps taken here."""
from itertools import pairwise

import numpy as np

import kinlab as kl
from kinlab.lessons.views import inverse as views

from . import Held

ARM, PLANE = kl.robots.two_link(), [1, 1, 0]


def elbow(x, y, side):
    """The elbow of two links of 1 m whose tool is at (x, y), to the left of that line or not."""
    middle, across = np.array([x, y]) / 2, np.array([-y, x]) / np.hypot(x, y)
    return [*(middle + side * np.sqrt(1 - middle @ middle) * across), 0]


def errors(target, q, count):
    """How far the tool is away after each of Newton's steps."""
    q, left = np.array(q, dtype=float), []
    for _ in range(count + 1):
        e = np.array(target) - kl.forward_kinematics(ARM, q)[:2, 3]
        left.append(np.linalg.norm(e))
        q = q + np.linalg.solve(kl.jacobian(ARM, q)[:2], e)
        q = np.remainder(q + np.pi, 2 * np.pi) - np.pi
    return left


def mistake(size):
    q, step = np.array([0.5, 1.0]), size * np.array([0.01, -0.02])
    moved = kl.forward_kinematics(ARM, q + step) - kl.forward_kinematics(ARM, q)
    return np.linalg.norm(kl.jacobian(ARM, q)[:2] @ step - moved[:2, 3])


assert 90 < mistake(10) / mistake(1) < 110 and abs(1000 * mistake(1) - 0.09) < 0.005
STEPS = errors((1.2, 0.9), (0.5, 1.0), 4)
assert np.allclose(STEPS[:2], [0.63, 0.22], atol=0.01)
assert all(b < 0.6 * a**2 for a, b in pairwise(STEPS[1:]))
FIRST = np.linalg.solve(kl.jacobian(ARM, [0.2, 0.1])[:2],
                        [0.5, 1] - kl.forward_kinematics(ARM, [0.2, 0.1])[:2, 3])
assert round(np.degrees(FIRST[1])) == 1451
assert np.linalg.matrix_rank(kl.jacobian(ARM, [0.3, 0])[:2]) == 1
NEVER = errors((2, 1), (0.2, 0.4), 12)
assert min(NEVER) > 0.23 and max(NEVER[-4:]) > 0.4  # thrown off again
RACE = {method: [step.position_error for step in kl.inverse_kinematics(
    ARM, [0.5, 1, 0], [0.2, 0.1], weights=PLANE, method=method, restarts=0).history]
    for method in ("newton", "damped")}
assert RACE["damped"][5] < 2e-5 and RACE["newton"][5] > 0.9 and RACE["newton"][12] < 1e-6
WAYS = np.array(views.eight_ways())
SHAPES = {tuple(np.round(kl.link_frames(kl.robots.intelledex_660t(), way)[:, :3, 3].ravel()) + 0.0)
          for way in WAYS}

PREDICTED = {
    "inverse.count": [Held("two", [("one", "elsewhere"), ("infinitely many", "the base itself")])],
    "inverse.elbow": [
        Held(elbow(1.2, 0.9, 1), [((1.2, 0.9, 0), "the tool"), (elbow(1.2, 0.9, -1), "away")]),
        Held(elbow(0, 1, 1), [((0, 1, 0), "the tool"), ((0.866, -0.5, 0), "x axis")])],
    "inverse.beyond": [
        Held([1.6, 1.2, 0], [((0.8, 0.6, 0), "one link"), ((2.4, 1.8, 0), "out of reach")]),
        Held([-1.2, 1.6, 0], [((-0.6, 0.8, 0), "one link"), ((-1.8, 2.4, 0), "out of reach")])],
    "inverse.linear": [Held("about a hundred times", [("about ten times", "faster"),
                                                      ("as large as before", "no step")])],
    "inverse.columns": [
        Held("link 2", [("link 1", "not on its line"), ("the x axis", "turns with the arm")]),
        Held("the line from the base to the tool", [("link 2", "not to the base"),
                                                    ("the x axis", "turns with the arm")]),
        Held("the arrows lie in one line, the ellipse is flat",
             [("the arrows are at right angles", "They would be"),
              ("both arrows shrink to nothing", "across the arm")])],
    "inverse.first_step": [Held("about 0.2 m", [("0, it arrives", "straight line"),
                                                ("about 0.6 m, hardly nearer", "well bent")])],
    "inverse.fast": [Held("it falls faster and faster", [
        ("by the same factor each time", "better"),
        ("it falls more and more slowly", "not worse")])],
    "inverse.leap": [Held("by several whole turns", [("by less than 90°", "large turns"),
                                                     ("by about half a turn", "does not know")])],
    "inverse.stretched": [Held("there is none", [("even larger", "nothing to divide by"),
                                                 ("zero, it stays", "no solution")])],
    "inverse.never": [Held("they never settle", [("they come to rest at 0.24 m", "singular"),
                                                 ("there is no first step", "has an inverse")])],
    "inverse.factor": [
        Held(1 / (1 + 0.1**2), [(0.909, "square"), (1.1, "square")]),
        Held(0.01 / (0.01**2 + 0.1**2), [(100, "without damping"), (0.0909, "square")])],
    "inverse.race": [Held("damped", [("Newton", "four times round"),
                                     ("both after as many steps", "differ most")])],
    "inverse.stop": [Held([*(2 * np.array([2, 1]) / np.sqrt(5)), 0],
                          [((2, 1, 0), "the target"), ((0, 2, 0), "away")])],
    "inverse.answers": [Held("infinitely many", [("two", "in a plane"), ("eight", "whole pose")])],
    "inverse.same": [Held("perhaps, perhaps others", [
        ("yes, that is where the pose came from", "remember"),
        ("no, it cannot reach the pose", "It can")])],
    "inverse.shapes": [Held(len(SHAPES), [(8, "most look the same"), (4, "the links stay"),
                                          (1, "either side")])],
    "inverse.tilt": [Held("none can", [("the tool pitch", "upright plane"),
                                       ("the base", "leave its place"),
                                       ("the tool roll", "own line")])],
}
assert len(WAYS) == 8
