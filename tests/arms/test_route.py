"""A single pose in plain floats is what the recurrence of `Frame` gives, to the last bit."""
from itertools import chain
from math import pi

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from strategies import arms, exact_angles

import kinlab as kl
from kinlab.arms.kinematics import tool_and_twists
from kinlab.arms.motions import along, matrix, stack


@st.composite
def arms_and_floats(draw):
    """Also sums of parallel joints that are quarter turns, whose cosines are exact."""
    arm = draw(arms())
    value = exact_angles | st.floats(-7, 7)
    return arm, [draw(value) for _ in range(arm.n)]


@given(arms_and_floats())
def test_poses_are_those_of_the_recurrence(arm_and_q):
    arm, q = arm_and_q
    want = [matrix(frame) for frame in along(arm.chain, q)]
    assert np.array_equal(kl.link_frames(arm, q), want[:-1])
    assert np.array_equal(kl.forward_kinematics(arm, q), want[-1])


@given(arms_and_floats())
def test_the_jacobian_is_that_of_the_recurrence(arm_and_q):
    arm, q = arm_and_q
    _, twists = tool_and_twists(chain(*arm.chain), q)
    assert np.array_equal(kl.jacobian(arm, q), stack([*zip(*twists)]))


@given(arms(), st.integers(0, 10**6))
def test_a_route_may_start_anywhere(arm, seed):
    """From another frame it leads to that frame's pose times the arm's."""
    q = np.random.default_rng(seed).uniform(-3, 3, arm.n)
    start = kl.homogeneous(kl.rotation_x(0.3) @ kl.rotation_z(1.1), [1.0, -2.0, 0.5])
    place = start[:3, :3].T.tolist(), start[:3, 3].tolist()
    axes, origin = arm.route.places(q.tolist(), place)[-1]
    want = start @ kl.forward_kinematics(arm, q)
    np.testing.assert_allclose(np.transpose(axes), want[:3, :3], atol=1e-11)
    np.testing.assert_allclose(origin, want[:3, 3], atol=1e-11)


def test_turns_of_parallel_joints_add_up_before_any_cosine():
    """0.1 + 0.2 - 0.3 is not 0 in floats; 90 and -90 degrees are, and 45 twice is a quarter."""
    arm = kl.Arm([kl.revolute(a=1), kl.revolute(a=1)])
    R = kl.forward_kinematics(arm, [0.7, -0.7])[:3, :3]
    assert np.array_equal(R, np.eye(3))
    assert np.array_equal(kl.forward_kinematics(arm, [pi / 4, pi / 4])[:3, 0], [0, 1, 0])


def test_there_is_one_nought():
    """-0.0 would be printed as -0."""
    frames = kl.link_frames(kl.robots.alpha_ii(), [2.5, -1, 0, -pi / 2, 3])
    for array in (frames, kl.jacobian(kl.robots.alpha_ii(), [2.5, -1, 0, -pi / 2, 3])):
        assert not np.signbit(array[array == 0]).any()
