"""The first lesson: what its view draws, and that its answers are true."""
from functools import cache
from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from solved.start_here import WAYS

import kinlab as kl

check = kl.exercises.check
START = kl.lessons.start_here
REACH, TWO_WAYS = cache(START.reach_view), cache(START.two_ways_view)
each_target = pytest.mark.parametrize("reach, target", [(REACH, (1, 1)), (TWO_WAYS, START.TARGET)],
                                      ids=["section 2", "exercise 3"])
angles = st.floats(-pi, pi)


def tips(q):
    return kl.forward_kinematics(kl.robots.two_link(), q)[..., :2, 3]


@each_target
@given(q1=angles, q2=angles)
def test_the_view_says_where_the_tip_is_and_how_far_from_the_target(reach, target, q1, q2):
    view = reach()
    view["theta_1"].value, view["theta_2"].value = np.degrees([q1, q2])
    tip = tips([q1, q2])
    assert np.allclose(view.readings["p"], [tip])
    assert np.allclose(view.readings["gap"], [target - tip])


@each_target
def test_the_ring_stands_around_the_target_and_the_dashed_line_leads_to_it(reach, target):
    scene = reach()._scene
    items = {item.gid: np.array(item.points) for item in scene.items}
    ring, gap = items["target"], items["gap"]
    assert np.allclose(np.linalg.norm(ring[:, 1:3] - target, axis=1), 0.1)
    assert not ring[:, 0].any() and gap[:, 0].tolist() == [scene.tip, 0]
    assert np.allclose(gap[1, 1:3], target)


def test_both_ways_reach_the_target():
    assert np.allclose(tips(WAYS), START.TARGET)


@pytest.mark.parametrize("answer", [
    WAYS[::-1], WAYS + 2 * pi, WAYS + np.radians([[0.4, 0], [0, -0.4]])])
def test_any_two_ways_count_within_two_centimetres(answer):
    assert check("start_here.5", answer).ok


def test_a_way_that_misses_by_more_does_not_count():
    assert "Pair 1" in check("start_here.5", WAYS + [[0.008, 0.008], [0, 0]]).message


def test_which_products_mean_something_is_true_of_them():
    """The product of two poses is the pose that its indices say, for those that fit."""
    T_01, T_12 = (kl.homogeneous(kl.rotation_z(a), o) for a, o in ((0.3, [1, 2, 3]),
                                                                  (-1.2, [4, 0, 1])))
    T_02, T_21 = T_01 @ T_12, kl.inverse(T_12)
    p_2 = np.array([0.5, -1, 2, 1])
    p_1, p_0 = T_12 @ p_2, T_01 @ T_12 @ p_2
    assert np.allclose(T_02 @ p_2, p_0) and np.allclose(kl.inverse(T_01) @ p_0, p_1)
    assert np.allclose(T_01 @ kl.inverse(T_21), T_02)
    assert not np.allclose(T_12 @ T_01, T_02) and not np.allclose(T_01 @ p_0, p_1)
