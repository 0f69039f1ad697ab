"""Tables with rows that no joint drives, and joints that count the other way."""
from dataclasses import replace
from math import pi, radians

import advice
import mechanisms as m
import numpy as np
import pytest

import kinlab as kl
from kinlab.answers.fixed_rows import joints_only, without_ends

RIGHT, R, P, F, row = pi / 2, kl.revolute, kl.prismatic, kl.fixed, m.retyped
PUMA, KR210, *_ = advice.published()
GRIPPER = kl.Arm([*KR210.links, F(d=0.303)], convention="modified", name="KR 210")
ELBOW = kl.Arm([R(d=0.4, alpha=RIGHT), F(theta=radians(30), a=0.2), R(a=0.5), F(a=0.1, d=0.05),
                R(alpha=RIGHT), R(d=0.3)])


def random_rows(rng):
    """An arm with fixed rows anywhere between its joints."""
    arm = m.random_arm(rng, n=int(rng.integers(2, 7)))
    links = []
    for link in arm.links:
        while rng.random() < 0.3:
            links.append(F(theta=m.random_angle(rng, 0.5), d=m.random_length(rng, 0.5),
                           a=m.random_length(rng, 0.5), alpha=m.random_angle(rng, 0.5)))
        links.append(replace(link, flip=bool(rng.random() < 0.3)))
    return replace(arm, links=links)


def test_a_table_of_joints_alone_moves_as_the_one_with_fixed_rows():
    rng = np.random.default_rng(1)
    for _ in range(100):
        arm = random_rows(rng)
        q = rng.uniform(-3, 3, (3, arm.n))
        for same in (joints_only(arm), without_ends(arm)[0]):
            assert np.allclose(kl.forward_kinematics(same, q), kl.forward_kinematics(arm, q))
        assert all(link.kind != "fixed" for link in joints_only(arm).links)
        assert kl.same_mechanism(joints_only(arm), arm, strict=True).ok
        assert kl.same_mechanism(arm, joints_only(arm), strict=True).ok


def test_a_last_fixed_row_is_a_tool():
    assert kl.same_mechanism(GRIPPER, KR210, strict=True).ok
    assert kl.same_mechanism(KR210, GRIPPER, strict=True).ok
    short = row(GRIPPER, 7, d=0.3)
    assert kl.same_mechanism(short, KR210, tip=False).ok
    verdict = kl.same_mechanism(short, GRIPPER, strict=True)
    assert verdict.message == ("The mechanism is right, but the tool frame sits elsewhere on the "
                               "last link: the offset d7 is 0.3; it should be 0.303.")
    assert (verdict.fault.row, verdict.fault.column) == (7, "d")


def test_a_slip_beside_a_last_fixed_row_is_named():
    for reference in (KR210, GRIPPER):
        verdict = kl.same_mechanism(row(GRIPPER, 4, d=1.6), reference)
        assert verdict.message == "Joint 4: the offset d4 is 1.6; it should be 1.5."
        assert (verdict.fault.row, verdict.fault.column, verdict.fault.expected) == (4, "d", 1.5)


def test_a_slip_behind_a_first_fixed_row_is_named_in_its_own_row():
    """Joint 2 stands in row 3; lengths carry the number of their row."""
    column = kl.Arm([F(d=1, alpha=pi), *PUMA.links])
    assert kl.same_mechanism(column, PUMA).ok
    verdict = kl.same_mechanism(row(column, 3, a=0.4), PUMA)
    assert verdict.message == "Joint 2: the length a3 (in row 3) is 0.4; it should be 0.4318."
    assert (verdict.fault.row, verdict.fault.column, verdict.fault.expected) == (3, "a", 0.4318)


@pytest.mark.parametrize("number, typed, start", [
    (2, {"a": 0.3}, "Row 2: the length a2 is 0.3; it should be 0.2."),
    (3, {"a": 0.4}, "Joint 2: the length a3 (in row 3) is 0.4; it should be 0.5."),
    (1, {"alpha": 0}, "Joint 1: the twist alpha1 is 0°; from z0 to z1 it should be 90°."),
    (4, {"a": 0.2}, "Row 4: the length a4 is 0.2; it should be 0.1."),
])
def test_a_slip_among_fixed_rows_of_the_reference_is_named(number, typed, start):
    verdict = kl.same_mechanism(row(ELBOW, number, **typed), ELBOW)
    (column, _), = typed.items()
    assert verdict.message == start
    assert (verdict.fault.row, verdict.fault.column) == (number, column)


def test_the_kind_of_a_joint_is_told_in_its_own_row():
    other = [*ELBOW.links[:2], P(a=0.5), *ELBOW.links[3:]]
    fault = kl.same_mechanism(kl.Arm(other), ELBOW).fault
    assert (fault.row, fault.column, fault.expected) == (3, "kind", "revolute")


def test_other_fixed_rows_than_the_references_are_judged_by_what_the_arm_does():
    plain = joints_only(ELBOW)
    assert kl.same_mechanism(ELBOW, plain).ok
    verdict = kl.same_mechanism(row(ELBOW, 3, a=0.6), plain)
    assert not verdict.ok and "without rows that are fixed: Joint" in verdict.message
    assert verdict.fault.row in (3, 5)


@pytest.mark.parametrize("strict", [False, True])
def test_advice_ends_among_fixed_rows(strict):
    rng = np.random.default_rng(2)
    for arm in (ELBOW, GRIPPER, *(random_rows(rng) for _ in range(20))):
        for answer, wrong in advice.tables(arm, rng, 3):
            walk = advice.followed(answer, arm, arm, strict=strict)
            assert walk.ended and walk.steps <= wrong + 1 and not walk.twice


def test_a_joint_that_counts_the_other_way_is_a_choice():
    flipped = row(PUMA, 3, flip=True)
    for strict in (False, True):
        assert kl.same_mechanism(flipped, PUMA, strict=strict).message == (
            "The same mechanism. Chosen differently: your q3 turns backwards.")
        assert kl.same_mechanism(flipped, flipped, strict=strict).message == (
            "The same mechanism, with the same frames.")
    fault = kl.same_mechanism(row(flipped, 2, a=0.4), PUMA).fault
    assert (fault.row, fault.column, fault.expected) == (2, "a", 0.4318)


def test_a_locked_joint_is_a_joint():
    locked = row(PUMA, 3, limits=(0.5, 0.5))
    assert kl.same_mechanism(locked, PUMA).ok and kl.same_mechanism(PUMA, locked).ok
