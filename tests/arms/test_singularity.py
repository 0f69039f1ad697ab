"""Manipulability, rank, singular directions, and the Jacobian in closed form."""
import warnings
from math import pi

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from strategies import arms, exact_angles, typed_lengths
from test_kinematics import course, finite_difference, q_of

import kinlab as kl
from kinlab.arms import symbolic as symbolic_module
from kinlab.arms.inputs import Note

close = np.testing.assert_allclose


def symbolic(arm, q):
    form = kl.jacobian_form(arm)
    return np.array(form.matrix.subs(dict(zip(form.joints, q))).evalf(), dtype=float)


@course
def test_closed_form_equals_numbers_and_finite_difference(robot):
    for arm in (kl.to_standard(robot()), kl.to_modified(robot())):
        q = q_of(arm, seed=3)
        close(symbolic(arm, q), kl.jacobian(arm, q), atol=1e-9)
        close(symbolic(arm, q), finite_difference(arm, q), rtol=1e-6, atol=1e-5)


@given(arms(exact_angles, typed_lengths, most=3))
@settings(max_examples=15)
def test_closed_form_of_random_arms(arm):
    q = q_of(arm)
    close(symbolic(arm, q), kl.jacobian(arm, q), atol=1e-9)


def test_six_odd_twists_stay_in_factors():
    """Multiplied out, an entry would have some two hundred products."""
    arm = kl.Arm([kl.revolute(d=0.1, a=0.1, alpha=np.radians(40)) for _ in range(6)])
    form, q = kl.jacobian_form(arm), q_of(arm)
    value = sp.lambdify(form.joints, form.matrix.tolist(), "math", cse=True)
    close(np.array(value(*q)), kl.jacobian(arm, q), atol=1e-9)
    assert len(form.entries[0][5]) < 8_000
    three = kl.jacobian_form(kl.Arm(arm.links[:3]))
    assert not any(entry.is_Mul and entry.has(sp.Add) for entry in three.matrix)


def test_a_formula_that_takes_minutes_says_so_before(monkeypatch):
    arm = kl.Arm([kl.revolute(a=0.1, alpha=0.7) for _ in range(3)])
    monkeypatch.setattr(symbolic_module, "LONG", 6)  # the tip has 1 + 2 + 5 products in x
    for form in (kl.closed_form, kl.jacobian_form):
        with pytest.warns(Note, match=r"^this formula has entries of 8 products, .*start, stop\)$"):
            form(arm)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        kl.closed_form(arm, 1)


def test_closed_form_of_the_alpha_ii_as_a_textbook_writes_it():
    form = kl.jacobian_form(kl.robots.alpha_ii(), lengths="symbols")
    assert form.matrix.shape == (6, 5)
    assert form.entries[2] == ("0", "-a2*C2 - a3*C23 + d5*S234", "-a3*C23 + d5*S234",
                               "d5*S234", "0")
    assert form.entries[4] == ("0", "C1", "C1", "C1", "-S1*S234")
    assert r"C_{234}" in form.latex and form.lengths[sp.Symbol("d_5")] == 129.5


@course
def test_velocity_rows_are_the_derivative_of_the_position(robot):
    arm = robot()
    form, p = kl.jacobian_form(arm), kl.closed_form(arm).matrix[:3, 3]
    difference = form.matrix[:3, :] - p.jacobian(form.joints)
    assert difference.applyfunc(sp.expand) == sp.zeros(3, arm.n)


def test_manipulability_of_the_two_link_is_a1_a2_sin():
    arm = kl.Arm([kl.revolute(a=2), kl.revolute(a=0.5)])
    q = np.random.default_rng(0).uniform(-3, 3, (50, 2))
    close(kl.manipulability(arm, q, [0, 1]), np.abs(np.sin(q[:, 1])), atol=1e-12)
    assert kl.manipulability(arm, [0.3, 0], [0, 1]) == pytest.approx(0, abs=1e-12)


@course
def test_manipulability_of_square_jacobians_is_the_determinant(robot):
    arm = robot()
    rows = range(6) if arm.n == 6 else range(arm.n)
    q = q_of(arm, (20,))
    want = np.abs(np.linalg.det(kl.jacobian(arm, q)[:, list(rows), :]))
    close(kl.manipulability(arm, q, rows), want, rtol=1e-7, atol=1e-9)


def test_rank_of_the_intelledex():
    arm = kl.robots.intelledex_660t()
    assert kl.rank(arm, arm.home) == 4
    ranks = kl.rank(arm, q_of(arm, (1000,)))
    assert ranks.shape == (1000,) and (ranks == 6).all()


def test_rank_in_any_unit():
    """A metre or a millimetre, the rank is the same: lengths are measured in reaches."""
    for scale in (1e-3, 1, 1e3, 1e6):
        arm = kl.Arm([kl.revolute(d=scale, alpha=pi / 2), kl.revolute(a=scale),
                      kl.revolute(a=scale)])
        assert kl.rank(arm, [0.1, 0.4, 0.8]) == 3
        assert kl.rank(arm, [0.1, 0.4, 0], rows=[0, 1, 2]) == 2
        assert kl.rank(arm, [0.1, 0.4, 1e-3], rows=[0, 1, 2]) == 3
        assert kl.rank(arm, [0.1, 0.4, 1e-3], rows=[0, 1, 2], tolerance=0.01) == 2


@course
def test_singular_directions_are_those_no_joint_gives(robot):
    arm = robot()
    length = kl.arms.kinematics.typical_length(arm)
    for q in (arm.home, np.zeros(arm.n), q_of(arm)):
        lost = kl.singular_directions(arm, q)
        assert lost.shape == (6, 6 - kl.rank(arm, q))
        close(lost.T @ lost, np.eye(lost.shape[1]), atol=1e-12)
        scaled = kl.jacobian(arm, q) / np.repeat([length, 1], 3)[:, None]
        close(lost.T @ scaled, 0, atol=1e-6)


def test_a_stretched_two_link_cannot_move_along_itself():
    arm = kl.robots.two_link()
    lost = kl.singular_directions(arm, [0.3, 0], rows=[0, 1])
    close(np.abs(lost[:, 0]), [np.cos(0.3), np.sin(0.3)], atol=1e-12)
    assert kl.singular_directions(arm, [0.3, 1], rows=[0, 1]).shape == (2, 0)


def test_an_arm_that_moves_nothing_but_its_angle():
    arm = kl.Arm([kl.revolute()])
    assert kl.rank(arm, [0.2]) == 1 and kl.rank(arm, [0.2], rows=[0, 1, 2]) == 0
    assert kl.manipulability(arm, [0.2], rows=[0]) == 0
