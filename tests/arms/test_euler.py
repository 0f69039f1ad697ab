"""ZYZ angles: both branches, the singular families, and the trap of Practical 3."""
from math import degrees, pi, radians

import numpy as np
import pytest
import sympy as sp
import textbook
from hypothesis import given
from hypothesis import strategies as st
from strategies import angles

import kinlab as kl
from kinlab.arms.euler import SINGULAR

close = np.testing.assert_allclose
tilts = st.floats(1e-6, pi - 1e-6)
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


@pytest.mark.parametrize("tilt", [SINGULAR / 10, SINGULAR * 0.9, SINGULAR * 1.1, 1e-8, 1e-7])
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
