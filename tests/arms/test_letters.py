"""Symbols in closed forms: the textbook's, a student's own names, and what they are worth."""
from math import pi, radians

import numpy as np
import pytest
import sympy as sp

import kinlab as kl

r, p = kl.revolute, kl.prismatic
TWO = kl.Arm([r(a=0.5), r(a=0.3)])
L1, L2 = sp.symbols("L1 L2")


def worth(form):
    return {str(symbol): value for symbol, value in form.lengths.items()}


def test_own_names_stand_where_the_arm_has_their_lengths():
    form = kl.closed_form(TWO, lengths={"L1": 0.5, "L2": 0.3})
    assert form.entries[0] == ("C12", "-S12", "0", "L1*C1 + L2*C12")
    assert r"L_{1} C_{1} + L_{2} C_{12}" in form.latex
    assert worth(form) == {"L1": 0.5, "L2": 0.3}
    back = kl.closed_form(kl.Arm([r(a=-0.5), r(a=0.25)]), lengths={"L1": 0.5, "unused": 7})
    assert back.entries[0][3] == "-L1*C1 + 0.25*C12"
    assert worth(back) == {"L1": 0.5}


def test_own_names_in_a_jacobian():
    form = kl.jacobian_form(TWO, lengths={"upper": 0.5, "lower": 0.3})
    assert form.entries[0] == ("-upper*S1 - lower*S12", "-lower*S12")
    assert r"-upper S_{1} - lower S_{12}" in form.latex


def test_what_stands_in_which_cell():
    cells = {(1, "a"): "L1", (2, "a"): "2*L1 - 0.7"}
    form = kl.closed_form(TWO, symbols=cells)
    assert form.entries[1][3] == "L1*S1 + S12*(-0.7 + 2*L1)"
    assert worth(form) == {"L1": 0.5}
    form = kl.closed_form(TWO, lengths={"L1": 0.5, "L2": 0.3},
                          symbols={(1, "a"): "L1", (2, "a"): "L2"})
    assert form.entries[0][3] == "L1*C1 + L2*C12"
    same = kl.closed_form(kl.Arm([r(a=1), r(a=-1)]), symbols={(1, "a"): L1, (2, "a"): -L1})
    assert same.entries[0][3] == "L1*(C1 - C12)"
    assert kl.closed_form(TWO, lengths={"L1": 0.5}, symbols={}).text == kl.closed_form(TWO).text
    one = kl.closed_form(kl.Arm([r(a=1), r(a=1)]), lengths={"L1": 1}, symbols={(1, "a"): "L1"})
    assert one.entries[0][3] == "L1*C1 + C12"  # the other 1 is a number there


@pytest.mark.parametrize("text, value, want", [
    ("L1", 0.5, "L1*C1"), ("-L1", -0.5, "-L1*C1"), ("L1/2", 0.25, "0.5*L1*C1"),
    ("3*L1 + 1", 2.5, "C1*(1 + 3*L1)"), ("L1**2", 0.25, "L1**2*C1"), ("(L1)", 0.5, "L1*C1"),
    ("sqrt(2)*L1", 0.5 * 2**0.5, "sqrt(2)*L1*C1")])
def test_texts_of_cells(text, value, want):
    arm = kl.Arm([r(a=value)])
    assert kl.closed_form(arm, lengths={"L1": 0.5}, symbols={(1, "a"): text}).entries[0][3] == want


def test_a_value_that_follows_from_the_rows_before():
    form = kl.closed_form(kl.Arm([r(a=0.8), r(a=0.3)]),
                          symbols={(1, "a"): "L1 + L2", (2, "a"): "L2"})
    assert worth(form) == pytest.approx({"L1": 0.5, "L2": 0.3})


def test_twists_as_symbols():
    """The general matrix of a row, as the books print it."""
    arm = kl.Arm([r(d=2, a=3, alpha=0.7)])
    form = kl.closed_form(arm, lengths="symbols", symbols="alpha")
    assert form.entries == (
        ("C1", "-S1*cos(alpha1)", "S1*sin(alpha1)", "a1*C1"),
        ("S1", "C1*cos(alpha1)", "-C1*sin(alpha1)", "a1*S1"),
        ("0", "sin(alpha1)", "cos(alpha1)", "d1"), ("0", "0", "0", "1"))
    assert r"-S_{1} \cos{\left(\alpha_{1} \right)}" in form.latex
    assert worth(form) == {"d_1": 2, "a_1": 3, "alpha_1": 0.7}
    assert kl.closed_form(arm, symbols="all").entries == form.entries
    assert kl.closed_form(arm, symbols=("d", "a", "alpha")).entries == form.entries


def test_an_angle_keeps_its_sign_and_its_row():
    rows = [r(alpha=-pi / 2), r(a=1, alpha=0.2)]
    modified = kl.closed_form(kl.Arm(rows, convention="modified"), symbols="alpha")
    assert worth(modified) == {"alpha_0": -pi / 2, "alpha_1": 0.2}
    standard = kl.closed_form(kl.Arm(rows), symbols={(1, "alpha"): "-beta"})
    assert worth(standard) == {"beta": pi / 2}
    assert standard.entries[0][2].startswith("0.198669330795*C1*S2")


def test_offsets_as_symbols():
    arm = kl.Arm([r(theta=0.3), p(theta=pi / 4, d=0.2)])
    form = kl.closed_form(arm, symbols=("theta", "d"))
    assert form.entries[0][0] == "cos(theta_1 + offset1 + theta2)"
    assert form.entries[2][3] == "offset2 + d2"
    assert worth(form) == {"offset_1": 0.3, "theta_2": pi / 4, "offset_2": 0.2}


def test_every_symbol_has_the_value_that_makes_it_the_arm():
    arm = kl.robots.exam_2018()
    form, q = kl.closed_form(arm, symbols="all"), [0.4, -0.7, 0.3]
    T = form.matrix.subs(form.lengths | dict(zip(form.joints, q)))
    np.testing.assert_allclose(np.array(T, float), kl.forward_kinematics(arm, q), atol=1e-12)


@pytest.mark.parametrize("arm, options, words", [
    (TWO, {"lengths": {"L 1": 0.5}}, "'L 1' cannot stand for a number"),
    (TWO, {"lengths": {"C1": 0.5}}, "'C1' cannot stand for a number"),
    (TWO, {"lengths": {"L1": "0.5"}}, "lengths['L1']: expected a number"),
    (TWO, {"lengths": {"L1": 50}}, "names of lengths that the arm has, got {'L1': 50.0}"),
    (kl.Arm([r(a=1), r(a=1)]), {"lengths": {"L1": 1, "L2": 1}},
     "both L1 and L2 are 1; say which stands where, symbols={(1, 'a'): 'L1'}"),
    (TWO, {"symbols": "beta"}, "symbols: expected 'theta' or 'd' or 'a' or 'alpha', got 'beta'"),
    (TWO, {"symbols": 3}, "expected 'all', some of theta, d, a, alpha"),
    (TWO, {"symbols": {(3, "a"): "L1"}}, "rows 1 to 2"),
    (TWO, {"symbols": {"a1": "L1"}}, "expected cells such as (1, 'a')"),
    (TWO, {"symbols": {(1, "r"): "L1"}}, "columns theta, d, a, alpha"),
    (TWO, {"symbols": {(1, "a"): "L1 L2"}}, "such as '2*L1', got 'L1 L2'"),
    (TWO, {"symbols": {(1, "a"): "__import__('os')"}}, "such as '2*L1'"),
    (TWO, {"symbols": {(1, "a"): "L1/0"}}, "such as '2*L1'"),
    (TWO, {"symbols": {(1, "a"): "9**9**9**9"}}, "such as '2*L1'"),
    (TWO, {"symbols": {(1, "a"): "(((9**20)**20)**20)**20"}}, "such as '2*L1'"),
    (TWO, {"symbols": {(1, "a"): "L1\0"}}, "such as '2*L1'"),
    (TWO, {"symbols": {(1, "a"): 0.5}}, "such as '2*L1', got 0.5"),
    (TWO, {"symbols": {(1, "a"): "L1 + L2"}}, "does not say what L1 and L2 are"),
    (TWO, {"symbols": {(1, "a"): "L1", (2, "a"): "L1"}}, "row 2 has a = 0.3, but L1 is 0.5"),
    (TWO, {"lengths": {"L1": 0.4}, "symbols": {(1, "a"): "L1"}},
     "row 1 has a = 0.5, but L1 is 0.4; correct one of them"),
    (TWO, {"symbols": {(1, "theta"): "theta_1"}}, "theta_1 is the variable of joint 1"),
    (TWO, {"symbols": {(1, "a"): "theta1"}}, "theta1 is the variable of joint 1"),
    (kl.Arm([p(a=1)]), {"lengths": {"d1": 1}}, "d1 is the variable of joint 1"),
])
def test_names_that_do_not_fit(arm, options, words):
    with pytest.raises(ValueError) as caught:
        kl.closed_form(arm, **options)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_right_angles_stay_numbers_beside_own_names():
    arm = kl.Arm([r(d=1, alpha=radians(90)), r(a=2)])
    assert kl.closed_form(arm, lengths={"h": 1}).entries[2][3] == "h + 2*S2"


def test_names_about_fixed_rows_and_joints_that_count_the_other_way():
    """Joint 2 stands in row 3: its variable is theta_2, its lengths are those of row 3."""
    rows = [r(d=1), kl.fixed(theta=0.3, d=0.4, a=0.5), r(a=2, alpha=0.7, flip=True)]
    form = kl.closed_form(kl.Arm(rows), lengths="symbols", symbols="theta")
    assert form.entries[0][0] == "cos(theta_1 - theta_2 + offset2)"
    assert form.entries[0][3] == "a2*cos(theta_1 + offset2) + a3*cos(theta_1 - theta_2 + offset2)"
    assert form.entries[2][3] == "d1 + d2"
    assert worth(form) == {"d_1": 1, "offset_2": 0.3, "d_2": 0.4, "a_2": 0.5, "a_3": 2}
    modified = kl.closed_form(kl.Arm(rows, convention="modified"), symbols=("a", "alpha"))
    assert worth(modified) == {"a_1": 0.5, "a_2": 2, "alpha_2": 0.7}


def test_own_names_in_fixed_rows():
    arm = kl.Arm([r(), kl.fixed(a=0.5), r(a=2, flip=True), kl.fixed(d=0.5, alpha=0.2)])
    cells = {(2, "a"): "L1", (4, "d"): "-L1 + 1", (4, "alpha"): "beta"}
    form = kl.closed_form(arm, symbols=cells)
    assert [form.entries[k][3] for k in (0, 2)] == ["L1*C1 + 2*C(1-2)", "1 - L1"]
    assert form.entries[2][1] == "sin(beta)"
    assert kl.closed_form(arm, 1, 2, symbols=cells).entries[0][3] == "L1"
    assert [kl.jacobian_form(arm, symbols=cells).entries[k] for k in (0, 5)] == [
        ("-L1*S1 - 2*S(1-2)", "2*S(1-2)"), ("1", "-1")]


def test_a_rounded_angle_in_a_fixed_row():
    arm = kl.Arm([r(), kl.fixed(alpha=1.5708), r(theta=1.5708, flip=True)])
    form = kl.closed_form(arm)
    assert form.remark == ("alpha2 = 1.5708 and offset3 = 1.5708 look rounded: "
                           "they are taken as pi/2, pi/2.")
    assert form.entries[2][:3] == ("C2", "S2", "0")  # sin and cos of 90 degrees - theta_2
