"""Lesson 12: by forward kinematics, by geometry, and by the textbooks' profiles."""
import numpy as np

import kinlab as kl

from . import Held

ARM = kl.robots.two_link()


def tip(*q):
    return kl.forward_kinematics(ARM, np.radians(q))[:3, 3]


def joints(x, y):
    """Both joint values (degrees) that bring the tip to (x, y), with θ₂ above 0."""
    bend = np.arccos((x**2 + y**2 - 2) / 2)
    return np.degrees([np.arctan2(y, x) - bend / 2, bend])


END = np.sqrt(3)  # m: how far the tip is from the base with θ₂ = 60°
assert np.allclose(tip(-30, 60), [END, 0, 0]) and np.allclose(tip(60, 60), [0, END, 0])
assert np.allclose(joints(END / 2, END / 2), [-7.238756, 104.477512])
assert round(np.hypot(END / 2, END / 2), 2) == 1.22 and round(joints(END / 2, END / 2)[1]) == 104
assert np.allclose(tip(0, 90), [1, 1, 0]) and np.allclose(tip(90, -90), [1, 1, 0])
assert round(2 - np.sqrt(2), 2) == 0.59
# The quintic's largest rate over 2.4 m in 2 s, 0.1 m from the axis of the base.
assert np.isclose(1.875 * 2.4 / 2, 2.25) and np.isclose(2.25 / 0.1, 22.5)
# Outwards: the elbow's rate for 1 m/s, at 1 m from the base and 1 mm before it is stretched.
RATES = [np.diff(np.radians([joints(r, 0)[1], joints(r + 1e-6, 0)[1]]))[0] / 1e-6
         for r in (1.0, 1.999)]
assert np.isclose(RATES[0], -1.1547, atol=1e-3) and RATES[1] < -20

PREDICTED = {
    "motion.middle": [
        Held([END / np.sqrt(2), END / np.sqrt(2), 0],
             [((0.866, 0.866, 0), "not the tip"), ((1.73, 0, 0), "away")]),
        Held([np.sqrt(2), np.sqrt(2), 0],
             [((1, 1, 0), "move all the time"), ((0, 0, 0), "Folded")])],
    "motion.elbow": [Held("it bends more, then comes back", [
        ("it stays at 60°", "on a circle"), ("it stretches, then comes back", "nearer")])],
    "motion.jump": [Held("more than any motor has", [
        ("none, since the rate is constant", "Before it was zero"), ("0.5 rad/s²", "a second")])],
    "motion.quarter": [
        Held([0.15625, 0.38, 0], [((0.25, 0.38, 0), "constant rate"), ((0.5, 0.38, 0), "away")]),
        Held([0.103515625, 0.26, 0],
             [((0.25, 0.26, 0), "constant rate"), ((0.2, 0.26, 0), "away")])],
    "motion.peak": [Held(67.5, [(45, "You said 45°/s, 22.5°/s too little. That is the average"),
                                (90, "straight lines")]),
                    Held(0.3, [(0.2, "the average"), (0.4, "straight lines")])],
    "motion.hard": [Held("at both ends", [
        ("in the middle, where it is fastest", "slope is zero"),
        ("it is the same all the time", "parabola")])],
    "motion.price": [Held("larger", [("smaller", "starts later"), ("the same", "behind")])],
    "motion.whole": [
        Held(2.5, [(2, "at full speed"), (2.25, "Slowing down"), (3, "also moves")]),
        Held(1, [(1.25, "full speed"), (0.25, "full speed"), (0.7071, "slow down")])],
    "motion.races": [Held("joint 1", [("joint 2", "distance from the base"),
                                      ("both alike", "the other changes")])],
    "motion.outwards": [Held("it grows beyond every limit", [
        ("it falls to zero", "keep its speed"), ("it stays as it is", "less and less")])],
    "motion.between": [Held("on a straight line only", [
        ("in joint space only", "between its values"), ("in both", "between its values"),
        ("in neither", "104°")])],
    "motion.halves": [Held("rates are doubled, accelerations are four times as large", [
        ("both are doubled", "the time is halved"),
        ("rates are doubled, accelerations stay", "half the time")])],
    "motion.factor": [
        Held(2, [(3, "the square"), (1.7321, "not for the rate"), (6, "both at once")]),
        Held(3, [(9, "the square"), (1.5, "not for the acceleration"), (4.5, "both at once")])],
}
