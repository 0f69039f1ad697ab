"""The lesson on notation: what its view draws, and what its exercise stands on."""
from functools import cache

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from solved.notation import T_01, T_02, T_12

import kinlab as kl

NOTATION = kl.lessons.notation
pose = cache(NOTATION.pose_view)


@given(st.floats(-180, 180), st.floats(-2.5, 2.5), st.floats(-2.5, 2.5))
def test_the_view_says_the_columns_of_the_pose_and_both_coordinates_of_the_point(theta, x, y):
    view = pose()
    view.theta_1, view.o_x, view.o_y = theta, x, y
    c, s = np.cos(np.radians(theta)), np.sin(np.radians(theta))
    assert np.allclose(view.readings["axes"], [[c, s], [-s, c]])
    assert np.allclose(view.readings["origin"], [[x, y]])
    assert np.allclose(view.readings["p"], [[x + c, y + s], [1, 0]])


def test_the_poses_of_the_last_exercise_are_those_of_its_text():
    assert np.allclose(NOTATION.T_01, T_01) and np.allclose(NOTATION.T_02, T_02)
    assert np.allclose(np.array(T_01) @ T_12, T_02)
