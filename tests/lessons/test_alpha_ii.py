"""The Alpha II lesson's exercises: what else must count, and that the answers are true."""
from math import pi

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from solved.alpha_ii import RIGHT, c1, c2, c23, s1, s2, s23, t1, t2, t3

import kinlab as kl

check = kl.exercises.check
q1, q2, q3 = sp.symbols("theta_1 theta_2 theta_3", real=True)
d1, a2, a3, d5 = sp.symbols("d_1 a_2 a_3 d_5")


@pytest.mark.parametrize("answer", [
    tuple(RIGHT["alpha_ii.2"]),
    sp.Matrix(RIGHT["alpha_ii.2"]),
    np.array(RIGHT["alpha_ii.2"]),
    [sp.expand_trig(part) for part in RIGHT["alpha_ii.2"]],
    [part.subs({t1: q1, t2: q2, t3: q3}) for part in RIGHT["alpha_ii.2"]],
    [f * (a2 * c2 + a3 * c23) for f in (c1, s1)] + [d1 - a2 * s2 - a3 * s23 - d5],
], ids=["tuple", "matrix", "array", "expanded", "real symbols", "length symbols"])
def test_expressions_count_in_any_equivalent_form(answer):
    assert check("alpha_ii.2", answer).ok


@pytest.mark.parametrize("answer", [
    [(2, 3, 4), [4, 3, 2, 1], range(1, 6)],
    (np.array([2, 3, 4]), frozenset({1, 2, 3, 4}), {1: 0, 2: 0, 3: 0, 4: 0, 5: 0}),
])
def test_joint_numbers_come_in_any_collection(answer):
    assert check("alpha_ii.3", answer).ok


@given(st.floats(-1, 1), st.floats(-0.5, 0.5), st.floats(-3, 3), st.sampled_from([1, -1]))
def test_any_way_to_touch_the_table_is_correct(turn, shoulder, roll, elbow):
    forearm = np.arcsin(85.5 / 177.8 - np.sin(shoulder))
    forearm = forearm if elbow == 1 else pi - forearm
    q = [turn, shoulder, forearm - shoulder, -forearm, roll]
    limits = [link.limits for link in kl.robots.alpha_ii().links]
    inside = all(low <= value <= high for value, (low, high) in zip(q, limits))
    verdict = check("alpha_ii.4", q)
    assert verdict.ok == inside and (inside or "limits" in verdict.message)


def test_which_joints_change_what_is_true_of_the_arm():
    arm, poses = kl.robots.alpha_ii(), np.random.default_rng(1).uniform(-2, 2, (50, 5))
    entries = {"p_z": (2, 3), "a": (slice(3), 2), "n": (slice(3), 0)}
    for (name, entry), right in zip(entries.items(), RIGHT["alpha_ii.3"]):
        moves = {i + 1 for i in range(5)
                 if np.ptp([kl.forward_kinematics(arm, poses + step * np.eye(5)[i])[:, *entry]
                            for step in (0, 0.5)], axis=0).max() > 1e-9}
        assert moves == right, name
