"""One turn about one axis: as axis and angle, and as a unit quaternion."""
from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest
import sympy as sp
import textbook
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from strategies import batch_shapes

import kinlab as kl
from kinlab.arms.inputs import Note

close = np.testing.assert_allclose
FEW_ULP = 16 * np.finfo(float).eps
small = st.sampled_from([1e-8, 1e-7, 1e-12, 1e-15, 1e-5])
turns = st.floats(0, pi, allow_subnormal=False) | small | small.map(lambda angle: pi - angle)
components = st.sampled_from([0.0, 1.0, -1.0]) | st.floats(-1, 1, allow_subnormal=False)


def units(n):
    """Vectors of length 1."""
    vectors = arrays(float, n, elements=components).filter(lambda v: np.linalg.norm(v) > 1e-3)
    return vectors.map(lambda v: v / np.linalg.norm(v))


@given(units(3), st.floats(-7, 7))
def test_a_turn_about_an_axis_is_rodrigues(axis, angle):
    R = kl.rotation_about(axis, angle)
    close(R, textbook.turn(axis, angle), atol=FEW_ULP)
    close(R @ axis, axis, atol=FEW_ULP)
    close(kl.rotation_about(1000 * axis, angle), R, atol=FEW_ULP)


@pytest.mark.parametrize("axis, rotation", [((1, 0, 0), kl.rotation_x), ((0, 1, 0), kl.rotation_y),
                                            ((0, 0, 1), kl.rotation_z)])
def test_turns_about_the_three_axes(axis, rotation):
    for angle in (0, 0.3, -2.5, pi / 2, pi, 1e-8):
        close(kl.rotation_about(axis, angle), rotation(angle), rtol=0, atol=2.3e-16)
    for quarter in (-pi / 2, pi / 2, pi, 2 * pi):
        assert (kl.rotation_about(axis, quarter) == rotation(quarter)).all()


def test_the_worked_examples_of_craig_and_spong():
    """Craig, section 2.8: 30 degrees about (0.707, 0.707, 0). Spong, section 2.5.3: Rx(60) Ry(30)
    Rz(90) turns by 120 degrees about (1, 1/2 - sqrt(3)/2, 1/2 + sqrt(3)/2) / sqrt(3)."""
    close(kl.rotation_about([0.707, 0.707, 0], radians(30)), [[0.933, 0.067, 0.354],
                                                              [0.067, 0.933, -0.354],
                                                              [-0.354, 0.354, 0.866]], atol=5e-4)
    R = [[0, -sqrt(3) / 2, 1 / 2],
         [1 / 2, -sqrt(3) / 4, -3 / 4],
         [sqrt(3) / 2, 1 / 4, sqrt(3) / 4]]
    axis, angle = kl.axis_angle(R)
    assert angle == pytest.approx(radians(120))
    close(axis, [1 / sqrt(3), 1 / (2 * sqrt(3)) - 1 / 2, 1 / (2 * sqrt(3)) + 1 / 2], atol=1e-15)


@given(units(3), turns)
def test_axis_and_angle_come_back(axis, angle):
    R = kl.rotation_about(axis, angle)
    got = kl.axis_angle(R)
    close(got.angle, angle, rtol=FEW_ULP, atol=FEW_ULP)
    for solution in got.solutions:
        close(kl.rotation_about(*solution), R, atol=FEW_ULP)
    if 0 < angle < pi - 1e-15:
        close(got.axis, axis, atol=FEW_ULP)
    assert not got.singular or angle < 2e-6
    assert got.singular or angle > 1e-6


def test_the_tiniest_axis_is_a_direction():
    close(kl.rotation_about([5e-324, 5e-324, 0], 1), kl.rotation_about([1, 1, 0], 1), rtol=1e-15)


@pytest.mark.parametrize("angle", [1e-300, 1e-100, 1e-20, 1e-8])
def test_the_smallest_angles_keep_their_digits(angle):
    axis, got = kl.axis_angle(kl.rotation_about([3, 0, 4], angle))
    assert got == pytest.approx(angle, rel=1e-15, abs=0)
    close(axis, [0.6, 0, 0.8], atol=2.3e-16)


def test_no_turn_has_any_axis():
    none = kl.axis_angle(np.eye(3))
    assert none.singular is True and none.angle == 0 and none.axis.tolist() == [0, 0, 1]
    assert none.message == "0 degrees about any axis"
    axis, angle = none.member([0, 3, 4])
    assert angle == 0 and axis.tolist() == [0, 0.6, 0.8]
    with pytest.raises(ValueError, match=r"^axis: expected a rotation by 0 degrees"):
        kl.axis_angle(kl.rotation_x(1)).member([0, 0, 1])


def test_a_turn_within_the_error_of_the_matrix_has_any_axis():
    """sqrt(3) of 1e-6: each of the three numbers that make the axis may be off by 1e-6."""
    for angle, singular in ((1e-8, True), (1.7e-6, True), (1.8e-6, False)):
        assert kl.axis_angle(kl.rotation_x(angle)).singular == singular
    printed = [[0.866, -0.5, 0], [0.5, 0.866, 0], [0, 0, 1]]
    with pytest.warns(Note, match=r"^R: taken as the nearest rotation"):
        assert kl.axis_angle(printed).angle == pytest.approx(radians(30), abs=3e-5)


def test_half_a_turn_goes_both_ways():
    R = np.diag([-1, 1, -1])
    half = kl.axis_angle(R)
    assert half.message == ("180.0000 degrees about (0.0000, 1.0000, 0.0000), "
                            "or -180.0000 degrees about the opposite axis")
    assert repr(half) == f"Axis and angle: {half.message}"
    (axis, angle), (opposite, back) = half.solutions
    assert (angle, back) == (pi, -pi) and (axis == -opposite).all()
    close(kl.rotation_about(opposite, angle), R, atol=FEW_ULP)


def test_the_quaternion_of_a_quarter_turn():
    q = kl.quaternion([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    close(q, [sqrt(0.5), 0, 0, sqrt(0.5)], atol=1e-15)
    assert repr(q) == ("(w, x, y, z) = (0.7071, 0.0000, 0.0000, 0.7071) "
                       "or (-0.7071, 0.0000, 0.0000, -0.7071)")


def test_the_quaternion_that_corke_prints():
    """Robotics, Vision and Control: of roll, pitch, yaw 0.1, 0.2, 0.3."""
    close(kl.quaternion(kl.rpy_matrix(0.1, 0.2, 0.3)), [0.98335, 0.034271, 0.10602, 0.14357],
          atol=5e-6)


@given(units(3), turns)
def test_the_quaternion_of_an_axis_and_an_angle(axis, angle):
    """cos(angle / 2) and sin(angle / 2) times the axis."""
    q = np.array(kl.quaternion(textbook.turn(axis, angle)))
    want = np.array([cos(angle / 2), *sin(angle / 2) * axis])
    close(q * np.sign(q @ want), want, atol=FEW_ULP)
    close(q @ q, 1, atol=FEW_ULP)
    assert q[0] >= 0


@given(units(4))
def test_quaternions_come_back(q):
    R = kl.quaternion_matrix(q)
    back = np.array(kl.quaternion(R))
    close(back * np.sign(back @ q), q, atol=FEW_ULP)
    for sign in kl.quaternion(R).solutions:
        close(kl.quaternion_matrix(sign), R, atol=FEW_ULP)
    close(R.T @ R, np.eye(3), atol=FEW_ULP)


@given(units(4), units(4))
def test_products_of_quaternions_are_products_of_rotations(p, q):
    product = [p[0] * q[0] - p[1:] @ q[1:], *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))]
    close(kl.quaternion_matrix(product), kl.quaternion_matrix(p) @ kl.quaternion_matrix(q),
          atol=FEW_ULP)


@pytest.mark.parametrize("axis, q", [((1, 0, 0), (0, 1, 0, 0)), ((0, 0, -1), (0, 0, 0, 1)),
                                     ((0, -3, 4), (0, 0, 0.6, -0.8))])
def test_half_a_turn_has_a_quaternion_of_one_sign(axis, q):
    close(kl.quaternion(kl.rotation_about(axis, pi)), q, atol=2.3e-16)


def test_a_quaternion_is_an_array_to_numpy():
    q = kl.quaternion(kl.rotation_about([0, 0.6, 0.8], pi / 2))
    w, x, y, z = q
    close((w, x, y, z), [sqrt(0.5), 0, 0.6 * sqrt(0.5), 0.8 * sqrt(0.5)], atol=1e-15)
    assert len(q) == 4 and q[0] == w and np.linalg.norm(q) == pytest.approx(1)
    assert (np.array(-q) == q.solutions[1]).all()
    assert np.asarray(q, dtype=np.float32).dtype == np.float32


def test_a_rounded_quaternion_is_taken_at_length_1():
    with pytest.warns(Note, match=r"^q: taken at length 1; its numbers are rounded, off by 0.0003"):
        R = kl.quaternion_matrix([0.707, 0, 0, 0.707])
    close(R, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-15)
    with pytest.raises(ValueError, match=r"^q: expected a unit .* of length 1.414; give num"):
        kl.quaternion_matrix([1, 0, 0, 1])


@given(arrays(float, 4, elements=components).filter(lambda v: np.linalg.norm(v) > 0.1))
@pytest.mark.filterwarnings("ignore::kinlab.arms.inputs.Note")
def test_every_quaternion_of_three_decimals_is_taken(v):
    q = v / np.linalg.norm(v)
    close(kl.quaternion_matrix(np.round(q, 3)), kl.quaternion_matrix(q), atol=4e-3)


@given(batch_shapes, st.integers(0, 1000))
def test_batches_of_any_shape_are_each_as_one(shape, seed):
    q = np.random.default_rng(seed).normal(size=(*shape, 4))
    q /= np.linalg.norm(q, axis=-1, keepdims=True)
    R = kl.quaternion_matrix(q)
    turns, back = kl.axis_angle(R), kl.quaternion(R)
    assert R.shape == (*shape, 3, 3) and np.shape(back) == (*shape, 4)
    assert np.shape(turns.axis) == (*shape, 3) and np.shape(turns.angle) == shape
    assert np.shape(turns.singular) == shape
    close(kl.rotation_about(*turns), R, atol=FEW_ULP)
    for place in np.ndindex(shape):
        one = kl.axis_angle(R[place])
        close(turns.axis[place], one.axis, atol=1e-15)
        close(np.asarray(back)[place], kl.quaternion(R[place]), atol=1e-15)


def test_what_many_rotations_say():
    R = kl.rotation_about([[0, 0, 1], [1, 0, 0]], [[0], [1], [2]])
    assert R.shape == (3, 2, 3, 3)
    assert kl.axis_angle(R).message == (
        "6 rotations, 2 of them by 0 degrees; see .axis, .angle and .singular")
    assert kl.quaternion(R).message == (
        "6 rotations; see .solutions for both signs, each (w, x, y, z)")


def test_symbols():
    theta = sp.Symbol("theta")
    assert kl.rotation_about([0, 0, 1], theta).tolist() == kl.rotation_z(theta).tolist()
    w, x, y, z = sp.symbols("w x y z")
    assert kl.quaternion_matrix([w, x, y, z])[0, 1] == 2 * x * y - 2 * w * z
    R = kl.rotation_about([x, y, z], theta)
    values = {x: 0.0, y: 0.6, z: 0.8, theta: 0.7}
    close(np.array(sp.Matrix(R).subs(values), dtype=float),
          textbook.turn((0, 0.6, 0.8), 0.7), atol=1e-15)
    third = sp.Rational(1, 3)
    assert kl.rotation_about([sp.Integer(1)] * 3, 2 * sp.pi / 3).tolist() == [
        [0, 0, 1], [1, 0, 0], [0, 1, 0]]
    assert kl.rotation_about([sp.Integer(1)] * 3, sp.pi)[0, 0] == -third
