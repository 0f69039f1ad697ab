"""The examiner's advice ends: who does what is said comes to a right table, and is never misled."""
from dataclasses import replace
from math import pi, radians

import advice
import mechanisms as m
import numpy as np
import pytest
from advice import course, followed, published, with_cells
from hypothesis import given, settings
from hypothesis import strategies as st

import kinlab as kl

RIGHT, R, P, row = pi / 2, kl.revolute, kl.prismatic, m.retyped
ALPHA_II, SIX_LINK = kl.robots.alpha_ii(), kl.robots.practical_six_link()
PUMA, KR210, UR5, PANDA, STANFORD, SCARA = published()


def told(answer, reference, **options):
    """Row, column, value and expected value of what is named, one after the other."""
    walk = followed(answer, reference, reference, **options)
    assert walk.ended and not walk.right_named and not walk.twice
    return [(fault.row, fault.column, fault.value, fault.expected)
            for fault in (verdict.fault for verdict in walk.said)]


# ---- Two slips, told by hand ---------------------------------------------------------------------

TWO_SLIPS = [
    # a length typed one row too high
    (row(row(SIX_LINK, 2, a=0.5), 3, a=0), SIX_LINK, [(2, "a", 0.5, 0), (3, "a", 0, 0.5)]),
    (row(row(PUMA, 3, a=0.4318), 4, d=0), PUMA,
     [(3, "a", 0.4318, 0.0203), (4, "d", 0, 0.4318)]),
    (row(row(UR5, 1, a=-0.425), 2, a=0), UR5, [(1, "a", -0.425, 0), (2, "a", 0, -0.425)]),
    # one length divided among two rows
    (row(row(KR210, 4, d=0.96), 5, d=0.54), KR210, [(4, "d", 0.96, 1.5), (5, "d", 0.54, 0)]),
    (row(row(PANDA, 5, d=0.2), 6, d=0.184), PANDA, [(5, "d", 0.2, 0.384), (6, "d", 0.184, 0)]),
    # a sign, and a length left out
    (row(row(PANDA, 5, a=0.0825), 3, d=0), PANDA,
     [(3, "d", 0, 0.316), (5, "a", 0.0825, -0.0825)]),
    # a and d of a row
    (row(STANFORD, 2, d=0, a=0.154), STANFORD, [(2, "d", 0, 0.154), (2, "a", 0.154, 0)]),
    # a twist and a length: the twist first
    (row(row(ALPHA_II, 2, a=170), 4, alpha=0), ALPHA_II,
     [(4, "alpha", 0, -RIGHT), (2, "a", 170, 177.8)]),
    (row(row(ALPHA_II, 2, alpha=radians(30)), 3, alpha=radians(40)), ALPHA_II,
     [(2, "alpha", radians(30), 0), (3, "alpha", radians(40), 0)]),
]


@pytest.mark.parametrize("strict", [False, True])
@pytest.mark.parametrize("answer, reference, path", TWO_SLIPS)
def test_two_slips_are_named_one_after_the_other(answer, reference, path, strict):
    assert told(answer, reference, strict=strict) == path


def test_three_slips_are_named_one_after_the_other():
    wrong = row(row(row(PUMA, 1, alpha=0), 2, a=0.0203), 3, a=0)
    assert told(wrong, PUMA) == [(1, "alpha", 0, RIGHT), (2, "a", 0.0203, 0.4318),
                                 (3, "a", 0, 0.0203)]


def test_a_modified_table_of_a_standard_arm_is_advised_in_its_own_rows():
    right = kl.to_modified(PUMA)
    walk = followed(row(row(right, 3, a=0.0203), 4, a=0.4318), right, PUMA)
    assert walk.ended and [(v.fault.row, v.fault.column, v.fault.expected) for v in walk.said] == [
        (3, "a", 0.4318), (4, "a", 0.0203)]


def test_the_strict_words_ask_for_the_same_number_before_and_after():
    """The sign of d4 is never turned round to fit another slip."""
    divided = kl.same_mechanism(row(row(KR210, 4, d=0.96), 5, d=0.54), KR210, strict=True)
    turned = kl.same_mechanism(row(KR210, 4, d=-1.5), KR210, strict=True)
    assert divided.message == "Joint 4: the offset d4 is 0.96; it should be 1.5."
    assert "The offset d4 should be 1.5: its sign is wrong." in turned.message


def test_the_exercise_gives_the_same_advice():
    bad = row(row(replace(SIX_LINK, name="mine"), 2, a=0.4), 3, a=0)
    first = kl.exercises.check("n_link.3", bad)
    assert first.message == "Joint 2: the length a1 (in row 2) is 0.4; it should be 0."
    assert (first.fault.value, first.fault.expected) == (0.4, 0)
    second = kl.exercises.check("n_link.3", row(bad, 2, a=0))
    assert second.message == "Joint 3: the length a2 (in row 3) is 0; it should be 0.5."
    assert kl.exercises.check("n_link.3", row(row(bad, 2, a=0), 3, a=0.5)).ok


# ---- Own frames ----------------------------------------------------------------------------------


def test_one_slip_in_a_table_with_own_frames_is_found_there():
    """z1 and z2 of the PUMA turned round: a twist and an offset change their signs."""
    own = row(PUMA, 3, alpha=RIGHT, d=-0.15005)
    assert kl.same_mechanism(own, PUMA).ok
    fault = kl.same_mechanism(row(own, 2, a=0.4), PUMA).fault
    assert (fault.row, fault.column, fault.expected) == (2, "a", 0.4318)


def test_a_twist_off_by_half_a_turn_speaks_of_own_frames():
    arm = kl.Arm([R(a=0.2, alpha=radians(30)), R(d=0.4, a=0.3, alpha=radians(50)), R()])
    own = row(row(arm, 1, alpha=radians(-150)), 2, d=-0.4, alpha=radians(-130))
    assert kl.same_mechanism(own, arm).ok
    fault = kl.same_mechanism(row(own, 2, d=-0.5), arm).fault
    assert (fault.row, fault.column, fault.expected) == (2, "d", -0.4)


def test_slid_origins_are_left_where_they_are():
    """The d of parallel axes count together; only what is wrong beside them is named."""
    own = row(row(ALPHA_II, 2, d=5), 4, d=-5)
    fault = kl.same_mechanism(row(own, 3, a=100), ALPHA_II).fault
    assert (fault.row, fault.column, fault.expected) == (3, "a", 177.8)


@given(st.integers(0, 10_000), st.integers(2, 3), st.booleans(), st.booleans())
@settings(max_examples=60, deadline=None)
def test_advice_ends_for_slips_in_any_table(seed, together, strict, other):
    rng = np.random.default_rng(seed)
    arm = m.random_arm(rng)
    right = advice.converted(arm, ("standard", "modified")[other])
    for answer, wrong in advice.tables(right, rng, 2, together):
        walk = followed(answer, right, arm, strict=strict)
        assert walk.ended and walk.steps <= wrong + 1 and not walk.twice
        assert not walk.right_named or together == 3


@given(st.integers(0, 10_000), st.booleans())
@settings(max_examples=40, deadline=None)
def test_advice_ends_for_slips_in_a_table_with_own_frames(seed, other):
    rng = np.random.default_rng(seed)
    arm = m.random_arm(rng)
    own = advice.converted(m.reassigned(arm, rng)[0], ("standard", "modified")[other])
    for answer, _ in advice.tables(own, rng, 2):
        walk = followed(answer, own, arm)
        assert walk.ended and not walk.twice


@pytest.mark.parametrize("arm", [*course(), *published()], ids=lambda arm: arm.name)
def test_advice_ends_for_arms_that_everybody_knows(arm):
    walks = advice.judged(arm, np.random.default_rng(3), 6)
    assert walks["tables"] > 12 and walks["in time"] == walks["tables"]
    assert not walks["right named"] and not walks["twice"]


# ---- What joins all numbers ----------------------------------------------------------------------


def times(arm, factor):
    return replace(arm, links=[replace(link, d=link.d * factor, a=link.a * factor)
                               for link in arm.links])


@pytest.mark.parametrize("factor, words", [
    (1e-3, "1000 times too small"), (1e3, "1000 times too large"), (0.1, "10 times too small"),
    (100, "100 times too large"), (1 / 25.4, "25.4 times too small"), (25.4, "25.4 times")])
@pytest.mark.parametrize("arm", [ALPHA_II, SIX_LINK, PUMA, kl.to_modified(UR5)],
                         ids=lambda arm: arm.name)
def test_lengths_in_another_unit(arm, factor, words):
    verdict = kl.same_mechanism(times(arm, factor), arm)
    assert verdict.message.startswith(f"All lengths are {words}") and "unit" in verdict.message
    assert verdict.message.endswith(f"lengths are in {arm.unit}.") and verdict.fault is None


def test_one_length_in_another_unit():
    verdict = kl.same_mechanism(row(ALPHA_II, 2, a=0.1778), ALPHA_II)
    assert verdict.message == ("Joint 2: the length a2 is 0.1778; it should be 177.8. It is 1000 "
                               "times too small: look at its unit.")


@pytest.mark.parametrize("typed", [1.5708, 1.571, 1.57, 1.5707, -1.5708, -1.57])
@pytest.mark.parametrize("strict", [False, True])
def test_a_quarter_turn_that_was_rounded(typed, strict):
    arm = row(UR5, 4, alpha=RIGHT if typed > 0 else -RIGHT)
    verdict = kl.same_mechanism(row(arm, 4, alpha=typed), arm, strict=strict)
    text = "pi/2" if typed > 0 else "-pi/2"
    assert f"It looks rounded: write {text} rather than {typed}." in verdict.message
    assert verdict.fault.expected == arm.links[3].alpha


def test_other_angles_that_were_rounded():
    arm = kl.Arm([R(alpha=pi / 3, a=1), R(alpha=radians(40), a=1), R()])
    assert "write pi/3 rather than 1.047." in kl.same_mechanism(row(arm, 1, alpha=1.047),
                                                                arm).message
    assert "write radians(40) rather than 0.698." in kl.same_mechanism(row(arm, 2, alpha=0.698),
                                                                       arm).message


def test_a_twist_of_the_wrong_sign_is_not_called_rounded():
    arm = kl.Arm([R(alpha=RIGHT, a=1), R(alpha=RIGHT, a=1), R()])
    assert "rounded" not in kl.same_mechanism(row(arm, 1, alpha=-1.5708), arm).message


@pytest.mark.parametrize("lengths", [{"d": -0.28}, {"a": 0.4}])
def test_a_row_too_many_may_stand_at_either_end(lengths):
    arm = kl.Arm([R(alpha=RIGHT, **lengths), R(a=0.4)], base=np.diag([1.0, -1, -1, 1]))
    for answer in ([R(alpha=pi), *arm.links], [*arm.links, R(d=0.1)]):
        verdict = kl.same_mechanism(kl.Arm(answer), arm)
        assert verdict.message == ("Your table has 3 joints, the arm has 2. Only joints have rows: "
                                   "put a fixed first row into the base, a fixed last row into the "
                                   "tool.")
        assert verdict.fault is None


def test_the_kind_of_a_joint_is_told_with_both_words():
    fault = kl.same_mechanism(kl.Arm([R(), R(), P()]), kl.robots.cylindrical()).fault
    assert (fault.row, fault.column, fault.value, fault.expected) == (
        2, "kind", "revolute", "prismatic")
    assert with_cells(STANFORD, {(2, "kind"): "revolute"}).links[2].kind == "revolute"


# ---- Both ends -----------------------------------------------------------------------------------


@pytest.mark.parametrize("number, typed, wanted", [(6, {"d": 200}, 228.6), (1, {"d": 300}, 373.4),
                                                   (4, {"a": 300}, 304.8)])
def test_the_ends_of_an_exercise_are_told_with_their_numbers(number, typed, wanted):
    arm = kl.robots.intelledex_660t()
    verdict = kl.exercises.check("intelledex.1", row(arm, number, **typed))
    (column, value), = typed.items()
    assert (verdict.fault.row, verdict.fault.column, verdict.fault.value,
            verdict.fault.expected) == (number, column, value, pytest.approx(wanted))
    assert f"{column}{number} is {value}; it should be {wanted}" in verdict.message


def test_a_right_zero_is_not_called_wrong_to_fit_three_signs():
    """Another zero of joint 5 would fit the twist of the wrong sign; the table had none."""
    right = kl.to_standard(SIX_LINK)
    wrong = row(row(right, 2, d=0.5, a=-0.5), 4, alpha=-RIGHT)
    walk = followed(wrong, right, SIX_LINK, strict=True)
    assert walk.ended and [(v.fault.row, v.fault.column, v.fault.expected) for v in walk.said] == [
        (4, "alpha", RIGHT), (2, "d", -0.5), (2, "a", 0.5)]


def test_half_a_turn_is_the_same_either_way():
    """The last row turns by -180 degrees; its matrix cannot tell that from 180."""
    arm = kl.Arm([R(alpha=RIGHT), R(), R(alpha=radians(-158.5)), R(theta=-pi, d=-0.35, alpha=-pi)],
                 convention="modified", tool=m.random_pose(np.random.default_rng(1)))
    verdict = kl.same_mechanism(row(arm, 3, alpha=radians(-248.5)), arm, strict=True)
    assert verdict.message == ("Joint 3: the twist alpha2 (in row 3) is -248.5°; from z2 to z3 it "
                               "should be -158.5°.")
