"""Rotations and homogeneous matrices: typed values, group axioms, batches, symbols."""
from math import cos, pi, sin

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from strategies import angles, lengths, points, poses, rotations
from textbook import rigid, turn

import kinlab as kl

AXES = {kl.rotation_x: (1, 0, 0), kl.rotation_y: (0, 1, 0), kl.rotation_z: (0, 0, 1)}
SHAPES = [(), (0,), (1,), (3,), (2, 3)]
close = np.testing.assert_allclose


@st.composite
def planar_poses(draw):
    angle, x, y = draw(angles), draw(lengths), draw(lengths)
    return np.array([[cos(angle), -sin(angle), x], [sin(angle), cos(angle), y], [0, 0, 1]])


any_pose = poses() | planar_poses()

POSE = rigid(turn((0, 0, 1), 0.4), (1, 2, 3))


def many(shape, pose=POSE):
    return np.broadcast_to(pose, (*shape, *pose.shape)).copy()


@given(angles)
def test_planar_rotation(angle):
    close(kl.rotation_2d(angle), [[cos(angle), -sin(angle)], [sin(angle), cos(angle)]], atol=1e-15)


@pytest.mark.parametrize("rotation", AXES, ids=lambda f: f.__name__)
@given(angle=angles)
def test_rotation_about_each_axis(rotation, angle):
    close(rotation(angle), turn(AXES[rotation], angle), atol=1e-14)


@pytest.mark.parametrize("rotation, want", [
    (kl.rotation_x, [[1, 0, 0], [0, 0, -1], [0, 1, 0]]),
    (kl.rotation_y, [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]),
    (kl.rotation_z, [[0, -1, 0], [1, 0, 0], [0, 0, 1]]),
    (kl.rotation_2d, [[0, -1], [1, 0]])])
def test_a_quarter_turn_is_exact(rotation, want):
    assert rotation(pi / 2).tolist() == want


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("rotation", [*AXES, kl.rotation_2d], ids=lambda f: f.__name__)
def test_rotations_keep_the_leading_axes(rotation, shape):
    angle = np.random.default_rng(0).uniform(-3, 3, shape)
    got = rotation(angle)
    size = 2 if rotation is kl.rotation_2d else 3
    assert got.shape == (*shape, size, size)
    for index in np.ndindex(shape):
        close(got[index], rotation(angle[index]), atol=1e-15)


@given(rotations(), points)
def test_homogeneous_puts_rotation_and_origin_in_place(R, o):
    T = kl.homogeneous(R, o)
    close(T, rigid(R, o))
    assert T[3].tolist() == [0, 0, 0, 1]
    close(kl.translation(o), rigid(o=o))


def test_planar_homogeneous():
    assert kl.homogeneous([[0, -1], [1, 0]], [2, 3]).tolist() == [[0, -1, 2], [1, 0, 3], [0, 0, 1]]
    assert kl.translation([2, 3]).tolist() == [[1, 0, 2], [0, 1, 3], [0, 0, 1]]


@given(any_pose)
def test_inverse(T):
    identity = np.eye(len(T))
    close(kl.inverse(T) @ T, identity, atol=1e-12)
    close(T @ kl.inverse(T), identity, atol=1e-12)
    close(kl.inverse(kl.inverse(T)), T, atol=1e-12)
    close(kl.inverse(T), np.linalg.inv(T), atol=1e-12)


@given(poses(), poses(), poses())
def test_compose_is_the_product_in_order(T_ab, T_bc, T_cd):
    close(kl.compose(T_ab, T_bc), T_ab @ T_bc, atol=1e-12)
    left, right = kl.compose(kl.compose(T_ab, T_bc), T_cd), kl.compose(T_ab, kl.compose(T_bc, T_cd))
    close(left, right, atol=1e-12)
    close(kl.compose(T_ab, T_bc, T_cd), left, atol=1e-12)
    inverse = kl.compose(kl.inverse(T_cd), kl.inverse(T_bc), kl.inverse(T_ab))
    close(kl.inverse(left), inverse, atol=1e-12)


@given(any_pose)
def test_the_identity_is_neutral(T):
    identity = np.eye(len(T))
    close(kl.compose(identity, T), T)
    close(kl.compose(T, identity), T)
    close(kl.compose(T), T)
    close(kl.inverse(identity), identity)


@given(poses(), poses(), points)
def test_apply_follows_compose(T_ab, T_bc, p_c):
    close(kl.apply(T_ab, p_c), (T_ab @ [*p_c, 1])[:3], atol=1e-12)
    close(kl.apply(kl.compose(T_ab, T_bc), p_c), kl.apply(T_ab, kl.apply(T_bc, p_c)), atol=1e-12)
    close(kl.apply(kl.inverse(T_ab), kl.apply(T_ab, p_c)), p_c, atol=1e-12)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("size", [3, 4])
def test_batches_keep_their_leading_axes(shape, size):
    T = many(shape)[..., -size:, -size:] if size == 4 else many(shape, np.eye(3))
    p = np.ones((*shape, size - 1))
    assert kl.inverse(T).shape == kl.compose(T, T).shape == (*shape, size, size)
    assert kl.homogeneous(T[..., :-1, :-1], p).shape == kl.translation(p).shape == T.shape
    assert kl.apply(T, p).shape == p.shape
    for index in np.ndindex(shape):
        close(kl.inverse(T)[index], kl.inverse(T[index]))
        close(kl.compose(T, T)[index], T[index] @ T[index])
        close(kl.apply(T, p)[index], kl.apply(T[index], p[index]))


def test_leading_axes_broadcast():
    T, p = many((2, 1)), np.ones((3, 3))
    assert kl.apply(T, p).shape == (2, 3, 3)
    assert kl.compose(T, many((3,))).shape == (2, 3, 4, 4)
    assert kl.homogeneous(np.eye(3), p).shape == (3, 4, 4)
    assert kl.homogeneous(many((2, 1))[..., :3, :3], p).shape == (2, 3, 4, 4)


def test_symbols():
    theta, x, y = sp.symbols("theta x y")
    c, s = sp.cos(theta), sp.sin(theta)
    T = kl.homogeneous(kl.rotation_2d(theta), [x, y])
    assert sp.Matrix(T) == sp.Matrix([[c, -s, x], [s, c, y], [0, 0, 1]])
    assert sp.Matrix(kl.inverse(T)) == sp.Matrix([[c, s, -c * x - s * y], [-s, c, s * x - c * y],
                                                  [0, 0, 1]])
    assert sp.Matrix(kl.apply(T, [2, 0])) == sp.Matrix([2 * c + x, 2 * s + y])
    assert sp.Matrix(kl.rotation_x(theta)) == sp.Matrix([[1, 0, 0], [0, c, -s], [0, s, c]])
    assert sp.Matrix(kl.rotation_y(theta)) == sp.Matrix([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    assert sp.Matrix(kl.rotation_z(theta)) == sp.Matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    assert sp.Matrix(kl.compose(T, kl.translation([x, 0])))[0, 2] == c * x + x


def test_a_batch_of_symbols():
    angles = np.array(sp.symbols("a b"))
    assert kl.rotation_z(angles).shape == (2, 3, 3)
    assert kl.rotation_z(angles)[1, 0, 0] == sp.cos(angles[1])


def test_whole_numbers_stay_whole_beside_symbols():
    x = sp.Symbol("x")
    T = kl.compose(kl.homogeneous(kl.rotation_2d(x), [0, 1]), kl.translation([2.0, 0.5]))
    assert T[0, 2] == 2 * sp.cos(x) - 0.5 * sp.sin(x)
    assert kl.apply(T, [1.0, 0])[1] == 3 * sp.sin(x) + 0.5 * sp.cos(x) + 1


def test_exact_numbers_stay_exact():
    assert kl.rotation_z(sp.pi / 6)[0, 0] == sp.sqrt(3) / 2
    assert kl.translation([sp.Rational(1, 3), 0])[0, 2] == sp.Rational(1, 3)


def test_a_sympy_matrix_with_decimals_beside_symbols():
    x = sp.Symbol("x")
    T = sp.Matrix(kl.homogeneous(kl.rotation_2d(x), [1, 2])).evalf()
    got = sp.Matrix(kl.compose(T, kl.inverse(T))).subs(x, 0.7)
    close(np.array(got, dtype=float), np.eye(3), atol=1e-12)


def test_a_bare_rotation_is_not_a_homogeneous_matrix():
    with pytest.raises(ValueError, match=r"^T: expected the last row 0 0 1"):
        kl.inverse(kl.rotation_y(0.4))


def test_a_mirror_image_is_not_a_rotation():
    with pytest.raises(ValueError, match=r"^R: expected a right-handed rotation"):
        kl.homogeneous(np.diag([1, 1, -1]), [0, 0, 0])
    with pytest.raises(ValueError, match=r"^T: expected a right-handed rotation"):
        kl.inverse(np.diag([1, 1, -1, 1]))


def test_a_stretched_sympy_matrix_is_refused_like_a_numeric_one():
    with pytest.raises(ValueError, match=r"^T: expected a rotation"):
        kl.inverse(sp.diag(2, 2, 2, 1))


def test_arguments_are_left_alone():
    T = many((2,))
    before = T.copy()
    kl.inverse(T)[...] = 0
    kl.compose(T)[...] = 0
    assert np.array_equal(T, before)
