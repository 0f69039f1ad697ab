"""Elementary motions and the frame recurrence against matrices multiplied by hand."""
from functools import reduce
from math import cos, pi, sin

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from strategies import angles, lengths, poses, rotations
from textbook import rigid, turn

from kinlab.arms.motions import (
    ROTATE,
    TRANSLATE,
    Frame,
    Motion,
    X,
    Y,
    Z,
    along,
    cos_sin,
    follow,
    matrix,
    motions_of,
    stack,
)

A = 0.3
C, S = cos(A), sin(A)
ONE_MOTION = {
    (ROTATE, X): [[1, 0, 0, 0], [0, C, -S, 0], [0, S, C, 0], [0, 0, 0, 1]],
    (ROTATE, Y): [[C, 0, S, 0], [0, 1, 0, 0], [-S, 0, C, 0], [0, 0, 0, 1]],
    (ROTATE, Z): [[C, -S, 0, 0], [S, C, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
    (TRANSLATE, X): [[1, 0, 0, A], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
    (TRANSLATE, Y): [[1, 0, 0, 0], [0, 1, 0, A], [0, 0, 1, 0], [0, 0, 0, 1]],
    (TRANSLATE, Z): [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, A], [0, 0, 0, 1]],
}


@st.composite
def motions(draw, n=3):
    """A motion by a constant, or by one of n joint variables."""
    kind = draw(st.sampled_from([ROTATE, TRANSLATE]))
    amount = draw(angles if kind == ROTATE else lengths)
    return Motion(kind, draw(st.integers(0, 2)), amount, draw(st.none() | st.integers(0, n - 1)))


def by_hand(motion, q):
    value = motion.amount + (0 if motion.joint is None else q[motion.joint])
    axis = np.eye(3)[motion.axis]
    return rigid(turn(axis, value)) if motion.kind == ROTATE else rigid(o=value * axis)


@pytest.mark.parametrize("kind, axis", ONE_MOTION)
def test_one_motion(kind, axis):
    got = matrix(follow([Motion(kind, axis, A)], ()))
    np.testing.assert_allclose(got, ONE_MOTION[kind, axis], atol=1e-15)


@given(st.lists(motions(), max_size=12), st.tuples(angles, angles, angles))
def test_a_sequence_is_the_product_of_its_matrices(sequence, q):
    want = reduce(np.matmul, (by_hand(motion, q) for motion in sequence), np.eye(4))
    np.testing.assert_allclose(matrix(follow(sequence, q)), want, atol=1e-12)


@given(st.lists(motions(), max_size=8))
def test_a_batch_of_values_is_many_single_ones(sequence):
    values = np.random.default_rng(1).uniform(-3, 3, (3, 5))
    got = np.broadcast_to(matrix(follow(sequence, values)), (5, 4, 4))
    for k in range(5):
        want = matrix(follow(sequence, values[:, k].tolist()))
        np.testing.assert_allclose(got[k], want, atol=1e-12)


@given(st.lists(motions(), max_size=6), st.lists(motions(), max_size=6))
def test_following_on_from_a_frame(first, second):
    q = (0.1, 0.2, 0.3)
    halfway = follow(first, q)
    whole = matrix(follow(first + second, q))
    np.testing.assert_allclose(matrix(follow(second, q, halfway)), whole, atol=1e-12)
    ends = [matrix(frame) for frame in along([first, second], q)]
    np.testing.assert_allclose(ends, [matrix(halfway), whole], atol=1e-12)


def test_angles_of_parallel_axes_add_before_any_cosine():
    a, b, length = sp.symbols("a b length")
    sequence = [Motion(ROTATE, Z, 0, 0), Motion(TRANSLATE, Z, 2), Motion(ROTATE, Z, 0, 1),
                Motion(TRANSLATE, X, length)]
    got = sp.Matrix(matrix(follow(sequence, (a, b))))
    assert got == sp.Matrix([[sp.cos(a + b), -sp.sin(a + b), 0, length * sp.cos(a + b)],
                             [sp.sin(a + b), sp.cos(a + b), 0, length * sp.sin(a + b)],
                             [0, 0, 1, 2], [0, 0, 0, 1]])


@pytest.mark.parametrize("k", range(-4, 5))
def test_quarter_turns_are_exact(k):
    want = [(1, 0), (0, 1), (-1, 0), (0, -1)][k % 4]
    assert cos_sin(k * pi / 2) == want
    assert cos_sin(float(np.radians(90 * k))) == want


def test_an_angle_beside_a_quarter_turn_is_not_rounded():
    assert cos_sin(pi / 2 + 1e-9)[0] == cos(pi / 2 + 1e-9) != 0


@given(poses())
def test_motions_of_a_matrix_give_it_back(T):
    np.testing.assert_allclose(matrix(follow(motions_of(T), ())), T, atol=1e-12)


@pytest.mark.parametrize("pitch", [pi / 2, -pi / 2])
@given(R=rotations())
def test_motions_of_a_frame_whose_x_points_straight_up_or_down(pitch, R):
    yaw = np.arctan2(R[1, 0], R[0, 0])
    T = rigid(turn((0, 0, 1), yaw) @ turn((0, 1, 0), pitch) @ turn((1, 0, 0), R[0, 1]))
    np.testing.assert_allclose(matrix(follow(motions_of(T), ())), T, atol=1e-12)


def test_rounding_noise_makes_no_odd_angles():
    noise = 1e-16 * np.array([[-1, 1, 0], [1, 0, 1], [0, 1, 1]])
    T = rigid(turn((0, 1, 0), -pi / 2) @ turn((1, 0, 0), 0.5) + noise)
    assert [(m.axis, m.amount) for m in motions_of(T)] == [
        (Y, pytest.approx(-pi / 2)), (X, pytest.approx(0.5))]


def test_the_identity_needs_no_motions():
    assert motions_of(np.eye(4)) == ()
    assert [m.axis for m in motions_of(rigid(o=(1, 0, 2)))] == [X, Z]


def test_a_motion_by_nothing_is_idle_unless_a_joint_drives_it():
    assert Motion(ROTATE, Z).idle
    assert not Motion(ROTATE, Z, 0.1).idle
    assert not Motion(ROTATE, Z, 0, 0).idle
    assert Frame().moved(Motion(TRANSLATE, X), ()) == Frame()


def test_stack_broadcasts_its_components():
    batch = np.arange(6.0).reshape(2, 3)
    got = stack([[1, batch], [batch[:, :1], 0.5]])
    assert got.shape == (2, 3, 2, 2) and got.dtype == float
    assert got[1, 2].tolist() == [[1, 5], [3, 0.5]]
    assert stack([[sp.Symbol("x"), 1.0]]).tolist() == [[sp.Symbol("x"), 1]]
