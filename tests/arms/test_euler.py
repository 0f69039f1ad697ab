"""ZYZ and roll-pitch-yaw: both branches, the singular families, the trap of Practical 3."""
from itertools import product
from math import copysign, cos, degrees, pi, radians

import numpy as np
import pytest
import sympy as sp
import textbook
from hypothesis import given
from hypothesis import strategies as st
from strategies import angles

import kinlab as kl
from kinlab.arms.inputs import Note

close = np.testing.assert_allclose
# R is taken with entries that are off by 1e-6: the two of sin(theta) by sqrt(2) of that.
SINGULAR = 2**0.5 * 1e-6
tilts = st.floats(1e-5, pi - 1e-5)
half_turns = st.floats(-pi, pi)


def apart(a, b):
    """Difference of two angles, as an angle of at most half a turn."""
    return (a - b + pi) % (2 * pi) - pi


@given(angles, angles, angles)
def test_matrix(phi, theta, psi):
    close(kl.zyz_matrix(phi, theta, psi), textbook.zyz(phi, theta, psi), atol=1e-14)


@given(half_turns, tilts, half_turns)
def test_both_branches_give_the_rotation_back(phi, theta, psi):
    R = textbook.zyz(phi, theta, psi)
    angles = kl.zyz_angles(R)
    assert not angles.singular and angles.fixed is None and len(angles) == 2
    for solution in angles:
        close(textbook.zyz(*solution), R, atol=1e-9)
    first, second = angles.solutions
    assert first[1] > 0 > second[1]
    assert first[1] == pytest.approx(-second[1])
    assert abs(apart(first[0], second[0])) == pytest.approx(pi)
    assert abs(apart(first[2], second[2])) == pytest.approx(pi)


@given(half_turns, st.floats(0.01, pi - 0.01), half_turns)
def test_the_first_branch_has_the_angles_that_went_in(phi, theta, psi):
    got = kl.zyz_angles(textbook.zyz(phi, theta, psi))[0]
    for one, other in zip(got, (phi, theta, psi)):
        assert apart(one, other) == pytest.approx(0, abs=1e-9)


@given(half_turns, half_turns, half_turns)
def test_no_tilt_fixes_only_the_sum(phi, psi, chosen):
    R = textbook.zyz(phi, 0, psi)
    angles = kl.zyz_angles(R)
    assert angles.singular and len(angles) == 1
    assert apart(angles.fixed, phi + psi) == pytest.approx(0, abs=1e-12)
    close(textbook.zyz(*angles[0]), R, atol=1e-12)
    assert angles.member(chosen)[:2] == (chosen, 0)
    close(textbook.zyz(*angles.member(chosen)), R, atol=1e-12)


@given(half_turns, half_turns, half_turns)
def test_a_half_turn_of_tilt_fixes_only_the_difference(phi, psi, chosen):
    R = textbook.zyz(phi, pi, psi)
    angles = kl.zyz_angles(R)
    assert angles.singular and len(angles) == 1
    assert apart(angles.fixed, phi - psi) == pytest.approx(0, abs=1e-12)
    close(textbook.zyz(*angles[0]), R, atol=1e-12)
    assert angles.member(chosen)[:2] == (chosen, pi)
    close(textbook.zyz(*angles.member(chosen)), R, atol=1e-12)


@pytest.mark.parametrize("tilt", [SINGULAR / 10, SINGULAR * 0.9, SINGULAR * 1.1, 1e-8, 1e-5])
@pytest.mark.parametrize("upside_down", [False, True])
def test_near_the_singular_tilts_nothing_is_wrong(tilt, upside_down):
    R = textbook.zyz(0.4, pi - tilt if upside_down else tilt, 0.7)
    angles = kl.zyz_angles(R)
    assert angles.singular == (tilt < SINGULAR)
    for solution in angles:
        close(textbook.zyz(*solution), R, atol=2 * SINGULAR)


def test_the_trap_of_the_practical():
    """At the given configuration R is the identity; printed formulas return psi = 180 degrees."""
    arm = kl.robots.practical_six_link()
    R = kl.forward_kinematics(arm, arm.home)[:3, :3]
    angles = kl.zyz_angles(R)
    assert angles.singular and angles.fixed == pytest.approx(0, abs=1e-12)
    close(textbook.zyz(*angles[0]), np.eye(3), atol=1e-12)
    assert np.degrees(np.arctan2(0.0, -0.0)) == 180  # the trap itself
    close(textbook.zyz(0, 0, pi), np.diag([-1, -1, 1]), atol=1e-12)


@pytest.mark.parametrize("noise", [1e-17, -1e-17, 1e-12, -0.0])
def test_the_trap_with_rounding_noise(noise):
    R = np.eye(3) + noise * np.array([[0, 1, -1], [-1, 0, 1], [1, -1, 0]])
    angles = kl.zyz_angles(R)
    assert angles.singular and angles.fixed == pytest.approx(0, abs=1e-11)


@pytest.mark.parametrize("zero", [0.0, -0.0])
def test_the_sign_of_a_zero_does_not_matter(zero):
    """R = Ry(-45 degrees): phi is 180, not -180 degrees."""
    h = np.sqrt(0.5)
    first = kl.zyz_angles([[h, zero, -h], [zero, 1, zero], [h, zero, h]])[0]
    assert first == pytest.approx((pi, pi / 4, pi))


def test_the_regular_companion_of_the_practical():
    R = kl.forward_kinematics(kl.robots.practical_six_link(),
                              np.radians([30, 40, -20, 50, 60, 70]))[:3, :3]
    got = [[round(degrees(angle), 4) for angle in solution] for solution in kl.zyz_angles(R)]
    assert got == [[-106.2953, 73.7724, -94.1646], [73.7047, -73.7724, 85.8354]]


def test_the_corrected_second_branch():
    """psi = atan2(-r32, r31), not the practical's atan2(-r23, r31)."""
    R = textbook.zyz(0.3, 0.5, 0.9)
    second = kl.zyz_angles(R)[1]
    assert second[2] == pytest.approx(np.arctan2(-R[2, 1], R[2, 0]))
    assert second[2] != pytest.approx(np.arctan2(-R[1, 2], R[2, 0]))


def test_what_the_angles_say():
    assert kl.zyz_angles(textbook.zyz(0.1, 0.2, 0.3)).message == (
        "(5.7296, 11.4592, 17.1887) or (-174.2704, -11.4592, -162.8113) degrees")
    assert kl.zyz_angles(textbook.zyz(radians(20), 0, radians(10))).message == (
        "theta = 0 degrees: any phi and psi with phi + psi = 30.0000 degrees")
    upside_down = kl.zyz_angles(textbook.zyz(radians(20), pi, radians(50)))
    assert kl.zyz_angles(np.diag([-1, 1, -1])).message.endswith("phi - psi = 0.0000 degrees")
    assert repr(upside_down) == (
        "ZYZ: theta = 180 degrees: any phi and psi with phi - psi = -30.0000 degrees")


def test_only_a_singular_rotation_has_members():
    with pytest.raises(ValueError, match=r"^phi: expected a singular rotation"):
        kl.zyz_angles(textbook.zyz(0.1, 0.2, 0.3)).member(0.5)


def test_matrices_broadcast_and_take_symbols():
    assert kl.zyz_matrix(np.zeros((2, 1)), np.zeros(3), 0.1).shape == (2, 3, 3, 3)
    phi, theta, psi = sp.symbols("phi theta psi")
    R = sp.Matrix(kl.zyz_matrix(phi, theta, psi))
    assert R[2, :] == sp.Matrix([[-sp.sin(theta) * sp.cos(psi), sp.sin(theta) * sp.sin(psi),
                                  sp.cos(theta)]])
    values = {phi: 0.1, theta: 0.2, psi: 0.3}
    close(np.array(R.subs(values), dtype=float), textbook.zyz(0.1, 0.2, 0.3), atol=1e-14)
    assert kl.zyz_matrix(phi, 0, 0)[0, 0] == sp.cos(phi)  # not 1.0*cos(phi)


@pytest.mark.parametrize("half_turn", [pi + 8.7e-8, float(np.float32(pi)), 3.141593])
def test_a_half_turn_in_the_digits_of_others_is_singular(half_turn):
    """pi in single precision, and pi with six decimals."""
    R = textbook.zyz(0.3, half_turn, 0.4)
    assert kl.zyz_angles(R).message == (
        "theta = 180 degrees: any phi and psi with phi - psi = -5.7296 degrees")
    assert kl.zyz_angles(R.astype(np.float32)).singular


@given(half_turns, half_turns, st.sampled_from([0.0, pi]), st.integers(3, 5))
@pytest.mark.filterwarnings("ignore::kinlab.arms.inputs.Note")
def test_a_singular_rotation_as_printed_is_singular(phi, psi, theta, decimals):
    angles = kl.zyz_angles(np.round(textbook.zyz(phi, theta, psi), decimals))
    assert angles.singular
    assert apart(angles.fixed, phi + cos(theta) * psi) == pytest.approx(0, abs=10**-decimals)


def test_a_rounded_rotation_is_singular_as_far_as_it_is_off():
    """Off by 4.4e-05: a tilt of 5e-05 may be none at all, one of 1e-04 is a tilt."""
    R = [[0.866, -0.5, 0], [0.5, 0.866, 0], [0, 0, 1]]
    for tilt, singular in ((5e-5, True), (1e-4, False)):
        with pytest.warns(Note, match=r"off by 4\.4e-05"):
            assert kl.zyz_angles(R @ textbook.zyz(0, tilt, 0)).singular == singular


# Craig's moving axes, from the first turn to the last: yaw, pitch, roll.
AXES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}
ORDERS = ["zyx", "xyz", "yxz", "xzy", "yzx", "zxy"]
orders = st.sampled_from(ORDERS)
pitches = st.floats(-pi / 2 + 1e-5, pi / 2 - 1e-5)
in_each_order = pytest.mark.parametrize("order", ORDERS)


def rpy(roll, pitch, yaw, order="zyx"):
    first, middle, last = (AXES[letter] for letter in order)
    return (textbook.turn(first, yaw) @ textbook.turn(middle, pitch) @ textbook.turn(last, roll))


@given(angles, angles, angles, orders)
def test_roll_pitch_and_yaw_are_turns_about_moving_axes(roll, pitch, yaw, order):
    close(kl.rpy_matrix(roll, pitch, yaw, order), rpy(roll, pitch, yaw, order), atol=1e-14)


@given(half_turns, pitches, half_turns, orders)
def test_both_branches_of_roll_pitch_and_yaw(roll, pitch, yaw, order):
    R = rpy(roll, pitch, yaw, order)
    angles = kl.rpy_angles(R, order)
    assert not angles.singular and angles.fixed is None and len(angles) == 2
    for solution in angles:
        close(rpy(*solution, order), R, atol=1e-9)
    first, second = angles
    assert cos(first[1]) > 0 > cos(second[1])
    assert first[1] == pytest.approx(pitch, abs=1e-9)


@given(half_turns, st.floats(-1.5, 1.5), half_turns, orders)
def test_the_first_branch_is_what_went_in(roll, pitch, yaw, order):
    got = kl.rpy_angles(kl.rpy_matrix(roll, pitch, yaw, order), order)[0]
    for one, other in zip(got, (roll, pitch, yaw)):
        assert apart(one, other) == pytest.approx(0, abs=1e-13)


@in_each_order
def test_half_turns_are_never_negative(order):
    """The sign of a zero would choose between -180 and 180 degrees."""
    assert kl.rpy_angles(np.eye(3), order)[1] == (pi, pi, pi)
    assert kl.rpy_angles(-np.diag([-1.0, 1, 1]), order)[0][1] == 0


@in_each_order
@pytest.mark.parametrize("small", [1e-8, 1e-12, 1e-300])
def test_small_angles_keep_their_digits(order, small):
    got = kl.rpy_angles(kl.rpy_matrix(small, -2 * small, 3 * small, order), order)[0]
    assert got == pytest.approx((small, -2 * small, 3 * small), rel=1e-7, abs=0)


@given(half_turns, st.sampled_from([pi / 2, -pi / 2, pi / 2 + 1e-7, -1.570796]), half_turns,
       half_turns, orders)
def test_a_quarter_turn_of_pitch_leaves_a_family(roll, pitch, yaw, chosen, order):
    R = rpy(roll, pitch, yaw, order)
    angles = kl.rpy_angles(R, order)
    assert angles.singular and len(angles) == 1
    assert angles[0][:2] == (0, copysign(pi / 2, pitch))
    assert angles.member(chosen)[2] == chosen
    for solution in (angles[0], angles.member(chosen)):
        close(rpy(*solution, order), R, atol=2e-6)
    assert apart(angles.fixed, yaw + angles.sign * roll) == pytest.approx(0, abs=2e-6)


def test_the_worked_matrices_of_craig_and_corke():
    """Craig, Matlab exercise 2A: alpha = 10, beta = 20, gamma = 30 degrees about z, y, x.
    Corke, Robotics, Vision and Control: rpy2r(0.1, 0.2, 0.3) and eul2r(0.1, 0.2, 0.3)."""
    close(kl.rpy_matrix(*np.radians([30, 20, 10])), [[0.9254, 0.0180, 0.3785],
                                                     [0.1632, 0.8826, -0.4410],
                                                     [-0.3420, 0.4698, 0.8138]], atol=5e-5)
    close(kl.rpy_matrix(0.1, 0.2, 0.3), [[0.9363, -0.2751, 0.2184],
                                         [0.2896, 0.9564, -0.0370],
                                         [-0.1987, 0.0978, 0.9752]], atol=6e-5)
    close(kl.zyz_matrix(0.1, 0.2, 0.3), [[0.9021, -0.3836, 0.1977],
                                         [0.3875, 0.9216, 0.0198],
                                         [-0.1898, 0.0587, 0.9801]], atol=6e-5)


def test_the_printed_formula_of_craig_in_symbols():
    """Craig, equation 2.64: X-Y-Z fixed angles gamma, beta, alpha."""
    gamma, beta, alpha = sp.symbols("gamma beta alpha")
    (ca, cb, cg), (sa, sb, sg) = ([f(angle) for angle in (alpha, beta, gamma)]
                                  for f in (sp.cos, sp.sin))
    assert sp.Matrix(kl.rpy_matrix(gamma, beta, alpha)).expand() == sp.Matrix([
        [ca * cb, ca * sb * sg - sa * cg, ca * sb * cg + sa * sg],
        [sa * cb, sa * sb * sg + ca * cg, sa * sb * cg - ca * sg],
        [-sb, cb * sg, cb * cg]])
    assert kl.rpy_matrix(0, 0, alpha)[0, 0] == sp.cos(alpha)  # not 1.0*cos(alpha)


def test_fixed_axes_are_moving_axes_the_other_way_round():
    """Turned about fixed x, then fixed y, then fixed z: each new turn stands in front."""
    roll, pitch, yaw = 0.3, -0.7, 1.9
    R = np.eye(3)
    for axis, angle in zip("xyz", (roll, pitch, yaw)):
        R = textbook.turn(AXES[axis], angle) @ R
    close(kl.rpy_matrix(roll, pitch, yaw, order="zyx"), R, atol=1e-15)


@pytest.mark.parametrize("name, order", [("vehicle", "zyx"), ("arm", "xyz"), ("camera", "yxz")])
def test_orders_by_their_use(name, order):
    R = kl.rpy_matrix(0.1, 0.2, 0.3, name)
    close(R, rpy(0.1, 0.2, 0.3, order), atol=1e-15)
    assert kl.rpy_angles(R, name)[0] == pytest.approx((0.1, 0.2, 0.3))


@pytest.mark.parametrize("order", ["zyz", "ZYX", "x", "", None, 1, ("z", "y", "x"), "zyx "])
def test_an_unknown_order_is_refused(order):
    for call in (lambda: kl.rpy_angles(np.eye(3), order), lambda: kl.rpy_matrix(0, 0, 0, order)):
        with pytest.raises(ValueError, match=r"^order: expected 'zyx' or 'xyz' or .*, got "):
            call()


def test_what_roll_pitch_and_yaw_say():
    assert repr(kl.rpy_angles(rpy(0.1, 0.2, 0.3, "xyz"), "xyz")) == (
        "(roll, pitch, yaw), order xyz: (5.7296, 11.4592, 17.1887) or "
        "(-174.2704, 168.5408, -162.8113) degrees")
    assert kl.rpy_angles(rpy(radians(10), pi / 2, radians(30))).message == (
        "pitch = 90 degrees: any yaw and roll with yaw - roll = 20.0000 degrees")
    assert kl.rpy_angles(rpy(radians(10), -pi / 2, radians(30))).message == (
        "pitch = -90 degrees: any yaw and roll with yaw + roll = 40.0000 degrees")
    assert kl.rpy_angles(rpy(0.1, pi / 2, 0.3, "xyz"), "xyz").message == (
        "pitch = 90 degrees: any yaw and roll with yaw + roll = 22.9183 degrees")
    with pytest.raises(ValueError, match=r"^yaw: expected a singular rotation"):
        kl.rpy_angles(np.eye(3)).member(0.5)


SOLVERS = {"zyz": (kl.zyz_angles, kl.zyz_matrix)} | {
    order: (lambda R, order=order: kl.rpy_angles(R, order),
            lambda *angles, order=order: kl.rpy_matrix(*angles, order)) for order in ORDERS}


@pytest.mark.parametrize("name", SOLVERS)
def test_many_rotations_at_once_are_each_as_one(name):
    solve, matrix = SOLVERS[name]
    some = [0, 0.3, pi / 2, -pi / 2, 1e-8, 2.5, pi]
    R = matrix(*np.array(list(product(some, some, some))).T).reshape(7, 49, 3, 3)
    many = solve(R)
    assert many.singular.shape == many.fixed.shape == (7, 49) and len(many) == 2
    assert many.message == f"343 rotations, {many.singular.sum()} of them singular; see " \
                           ".solutions and .singular"
    for solution in many:
        close(matrix(*solution), R, atol=2e-8)
    for place in np.ndindex(7, 49):
        one = solve(R[place])
        assert one.singular == many.singular[place] == (not np.isnan(many.fixed[place]))
        for branch, alone in zip(many, (one[0], one[-1])):
            assert tuple(angle[place] for angle in branch) == alone


def test_no_rotations_at_all():
    assert [angle.shape for angle in kl.zyz_angles(np.zeros((0, 3, 3)))[0]] == [(0,)] * 3


def test_many_families_have_members():
    angles = kl.zyz_angles(textbook.turn((0, 0, 1), 0.5) @ np.stack([np.eye(3)] * 2))
    close(np.transpose(angles.member(0.2)), [(0.2, 0, 0.3)] * 2, atol=1e-15)
    with pytest.raises(ValueError, match=r"^phi: expected a singular rotation"):
        kl.zyz_angles([np.eye(3), textbook.zyz(0, 1, 0)]).member(0.2)


def test_one_rotation_gives_plain_numbers():
    regular, family = kl.rpy_angles(rpy(0.1, 0.2, 0.3)), kl.zyz_angles(np.eye(3))
    assert {type(angle) for angles in (*regular, *family) for angle in angles} == {float}
    assert regular.singular is False and family.singular is True
    assert regular == kl.rpy_angles(rpy(0.1, 0.2, 0.3))
