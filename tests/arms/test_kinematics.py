"""Forward kinematics, link frames and the Jacobian, against the textbooks' own matrices."""
from math import pi

import numpy as np
import pytest
import textbook
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import arms, arms_and_q, batch_shapes, flat

import kinlab as kl
from kinlab.arms.kinematics import CHUNK, axis_frames

close = np.testing.assert_allclose
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)


def q_of(arm, shape=(), seed=0):
    return np.random.default_rng(seed).uniform(-3, 3, (*shape, arm.n))


@given(arms_and_q())
def test_frames_are_products_of_dh_matrices(arm_and_q):
    arm, q = arm_and_q
    want = textbook.frames(arm, q)
    close(kl.link_frames(arm, q), want[:-1], atol=1e-11)
    close(kl.forward_kinematics(arm, q), want[-1], atol=1e-11)


@given(arms_and_q())
def test_pose_is_a_product_of_exponentials(arm_and_q):
    arm, q = arm_and_q
    close(kl.forward_kinematics(arm, q), textbook.exponentials(arm, q), atol=1e-10)


@given(arms_and_q(batch=batch_shapes, most=4))
def test_a_batch_is_many_single_poses(arm_and_q):
    arm, q = arm_and_q
    shape, n = q.shape[:-1], arm.n
    frames, pose, J = kl.link_frames(arm, q), kl.forward_kinematics(arm, q), kl.jacobian(arm, q)
    assert frames.shape == (*shape, len(arm.links) + 1, 4, 4)
    assert pose.shape == (*shape, 4, 4) and J.shape == (*shape, 6, n)
    for index in np.ndindex(shape):
        close(frames[index], kl.link_frames(arm, q[index]), atol=1e-11)
        close(pose[index], kl.forward_kinematics(arm, q[index]), atol=1e-11)
        close(J[index], kl.jacobian(arm, q[index]), atol=1e-11)


@pytest.mark.parametrize("count", [1, CHUNK - 1, CHUNK, CHUNK + 1, 2 * CHUNK])
def test_poses_at_the_edges_of_a_chunk(count):
    arm = kl.robots.exam_2018()
    q = q_of(arm, (count,))
    frames, pose, J = kl.link_frames(arm, q), kl.forward_kinematics(arm, q), kl.jacobian(arm, q)
    for k in {0, count // 2, count - 2, count - 1, min(CHUNK, count) - 1, min(CHUNK, count - 1)}:
        close(frames[k], textbook.frames(arm, q[k])[:-1], atol=1e-12)
        close(pose[k], kl.forward_kinematics(arm, q[k]), atol=1e-12)
        close(J[k], kl.jacobian(arm, q[k]), atol=1e-12)
    close(np.linalg.norm(pose[:, :3, :3], axis=1), 1, atol=1e-12)


def test_strided_batches():
    arm = kl.robots.alpha_ii()
    q = q_of(arm, (4, 6)).transpose(1, 0, 2)[::-1, ::2]
    want = [kl.forward_kinematics(arm, row) for row in flat(q)]
    close(kl.forward_kinematics(arm, q).reshape(-1, 4, 4), want, atol=1e-11)


@course
def test_the_tool_stands_on_the_last_frame(robot):
    arm = robot()
    q = q_of(arm, (7,))
    close(kl.forward_kinematics(arm, q), kl.link_frames(arm, q)[:, -1] @ arm.tool, atol=1e-11)


@given(arms_and_q())
def test_every_frame_is_rigid(arm_and_q):
    arm, q = arm_and_q
    frames = kl.link_frames(arm, q)
    R = frames[:, :3, :3]
    close(R @ R.swapaxes(1, 2), np.broadcast_to(np.eye(3), R.shape), atol=1e-12)
    close(np.linalg.det(R), 1, atol=1e-12)
    assert (frames[:, 3] == [0, 0, 0, 1]).all()
    close(frames[0], arm.base, atol=1e-12)


def finite_difference(arm, q, step=1e-6):
    """Twist of the tool per joint, from textbook poses a small step to either side."""
    columns = []
    for k in range(arm.n):
        move = step * np.eye(arm.n)[k]
        after, before = (textbook.frames(arm, q + s * move)[-1] for s in (1, -1))
        rate = (after - before) / (2 * step)
        spin = rate[:3, :3] @ textbook.frames(arm, q)[-1, :3, :3].T
        columns.append([*rate[:3, 3], spin[2, 1], spin[0, 2], spin[1, 0]])
    return np.transpose(columns)


@given(arms_and_q(most=5))
@settings(max_examples=40)
def test_jacobian_is_the_finite_difference(arm_and_q):
    arm, q = arm_and_q
    close(kl.jacobian(arm, q), finite_difference(arm, q), atol=2e-7)


@course
@given(seed=st.integers(0, 10**6))
@settings(max_examples=5)
def test_jacobian_of_the_course_arms(robot, seed):
    arm = robot()
    q = q_of(arm, seed=seed)
    close(kl.jacobian(arm, q), finite_difference(arm, q), atol=1e-6, rtol=1e-6)


def test_jacobian_of_the_planar_two_link():
    q1, q2 = 0.3, 0.5
    s1, c1, s12, c12 = np.sin(q1), np.cos(q1), np.sin(q1 + q2), np.cos(q1 + q2)
    want = [[-s1 - s12, -s12], [c1 + c12, c12], [0, 0], [0, 0], [0, 0], [1, 1]]
    close(kl.jacobian(kl.robots.two_link(), [q1, q2]), want, atol=1e-15)


def test_jacobian_of_the_cylindrical_arm():
    q1, d3 = 0.3, 0.5
    s1, c1 = np.sin(q1), np.cos(q1)
    want = [[-s1 * d3, 0, c1], [c1 * d3, 0, s1], [0, 1, 0], [0, 0, 0], [0, 0, 0], [1, 0, 0]]
    close(kl.jacobian(kl.robots.cylindrical(), [q1, 0.2, d3]), want, atol=1e-15)


def test_rank_of_the_intelledex():
    arm = kl.robots.intelledex_660t()
    rank = np.linalg.matrix_rank
    scale = np.array([1 / 300] * 3 + [1] * 3)[:, None]  # millimetres beside radians
    assert rank(scale * kl.jacobian(arm, arm.home), tol=1e-9) == 4
    assert (rank(scale * kl.jacobian(arm, q_of(arm, (200,))), tol=1e-6) == 6).all()


def test_the_wrist_of_the_intelledex_is_not_spherical():
    """The wrist point moves with q4: the first three joints do not place it alone."""
    arm = kl.robots.intelledex_660t()
    before, after = kl.link_frames(arm, [[0.1] * 6, [0.1, 0.1, 0.1, 0.5, 0.1, 0.1]])[:, 5, :3, 3]
    assert np.linalg.norm(after - before) > 100


@given(arms())
@settings(max_examples=30)
def test_axis_frames_hold_the_joint_axes(arm):
    """A joint that moves alone leaves the frame with its axis where it is, up to that motion."""
    q = np.zeros((2, arm.n))
    for k, frame in enumerate(axis_frames(arm)):
        q[:, k] = 0, 0.4
        still, moved = kl.link_frames(arm, q)[:, frame]
        close(moved[:3, 2], still[:3, 2], atol=1e-12)
        close(np.cross(still[:3, 2], moved[:3, 3] - still[:3, 3]), 0, atol=1e-12)
        q[:, k] = 0


@course
def test_lists_tuples_and_integers_are_joint_values(robot):
    arm = robot()
    want = kl.forward_kinematics(arm, np.ones(arm.n))
    for q in ([1] * arm.n, (1.0,) * arm.n, np.ones(arm.n, dtype=np.int8)):
        assert np.array_equal(kl.forward_kinematics(arm, q), want)
    close(kl.forward_kinematics(arm, [[1] * arm.n]), want[None], atol=1e-12)


def test_values_beyond_the_limits_are_computed():
    arm = kl.robots.cylindrical()
    assert kl.forward_kinematics(arm, [0, 5, 7])[:3, 3] == pytest.approx([7, 0, 5.4])


def test_q_is_left_alone_and_results_are_fresh():
    arm, q = kl.robots.alpha_ii(), np.full((2, 5), 0.1)
    first = kl.forward_kinematics(arm, q)
    first[...] = 0
    assert (q == 0.1).all() and kl.forward_kinematics(arm, q)[0, 3, 3] == 1
    kl.link_frames(arm, q[0])[0, 0, 3] = 9
    assert arm.base[0, 3] == 0


def test_poses_do_not_mind_a_full_turn():
    arm = kl.robots.intelledex_660t()
    q = q_of(arm)
    close(kl.forward_kinematics(arm, q + 2 * pi), kl.forward_kinematics(arm, q), atol=1e-9)
