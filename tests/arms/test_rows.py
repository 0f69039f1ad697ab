"""Rows as people have them: without a joint, with a joint that counts the other way, locked."""
from dataclasses import FrozenInstanceError, replace
from math import cos, pi, sin

import numpy as np
import pytest
from hypothesis import given
from strategies import arms_and_q, poses

import kinlab as kl
from kinlab.arms.joints import joint_ranges, joints_before

# A gripper of 0.303 m that is no joint, as in the KUKA KR 210's table (Udacity, Pick and Place).
WRIST = kl.Arm([kl.revolute(d=0.5), kl.fixed(a=0.2, alpha=pi / 2), kl.revolute(a=1),
                kl.fixed(a=0.303)], name="wrist")
BACK = kl.Arm([kl.revolute(a=1), kl.revolute(a=1, theta=pi / 2, flip=True)])


def test_a_fixed_row_has_a_frame_and_no_value():
    assert WRIST.n == 2
    assert WRIST.rows == (0, 2)
    assert [link.kind for link in WRIST.joints] == ["revolute", "revolute"]
    frames = kl.link_frames(WRIST, [0, 0])
    assert frames.shape == (5, 4, 4)
    assert frames[:, :3, 3] == pytest.approx(np.array(
        [[0, 0, 0], [0, 0, 0.5], [0.2, 0, 0.5], [1.2, 0, 0.5], [1.503, 0, 0.5]]))


def test_the_tool_beyond_fixed_rows():
    # Joint 2 turns about -y of the room: cos and sin of 30 degrees lift the last 1.303 m.
    tip = kl.forward_kinematics(WRIST, [0, pi / 6])[:3, 3]
    assert tip == pytest.approx([0.2 + 1.303 * cos(pi / 6), 0, 0.5 + 1.303 * 0.5])


def test_joints_are_numbered_by_joints_and_lengths_by_rows():
    assert kl.closed_form(WRIST, lengths="symbols").entries[0][3] == \
        "C1*(a2 + a3*C2 + a4*C2)"
    assert WRIST.table() == [["i", "θ", "d", "a", "α"], ["1", "θ1*", "0.5", "0", "0°"],
                             ["2", "0°", "0", "0.2", "90°"], ["3", "θ2*", "0", "1", "0°"],
                             ["4", "0°", "0", "0.303", "0°"]]
    assert [joints_before(WRIST, row) for row in range(5)] == [0, 1, 1, 2, 2]


def test_a_length_behind_a_fixed_row_is_not_taken_for_a_joint():
    """Joint 2 slides by d_2; row 2 has a constant d, which needs another name."""
    arm = kl.Arm([kl.revolute(), kl.fixed(d=0.4), kl.prismatic(limits=(0, 1))])
    form = kl.closed_form(arm, lengths="symbols")
    assert form.entries[2][3] == "offset2 + d2"
    assert list(form.lengths.values()) == [0.4]


def test_a_table_needs_a_joint():
    with pytest.raises(ValueError, match=r"^links: expected at least one joint, got only fixed"):
        kl.Arm([kl.fixed(a=1)])
    with pytest.raises(ValueError, match=r"^limits, flip: a fixed row has no joint"):
        replace(kl.fixed(), limits=(0, 1))


def test_a_joint_that_counts_the_other_way():
    # theta_2 = 90 degrees - q2: at q2 = 90 degrees both links lie along x.
    assert kl.forward_kinematics(BACK, [0, pi / 2])[:2, 3] == pytest.approx([2, 0])
    assert kl.forward_kinematics(BACK, [0, pi / 6])[:2, 3] == pytest.approx(
        [1 + cos(pi / 3), sin(pi / 3)])
    assert BACK.table()[2] == ["2", "-θ2* + 90°", "0", "1", "0°"]
    # At q = 0 the tip is at (1, 1): q1 carries it along (-1, 1), q2 turns clockwise about (1, 0).
    assert kl.jacobian(BACK, [0, 0])[[0, 1, 5]] == pytest.approx(
        np.array([[-1, 1], [1, 0], [1, -1]]))


def test_the_algebra_of_a_joint_that_counts_the_other_way():
    arm = kl.Arm([kl.revolute(a=1, flip=True), kl.prismatic(d=0.5, flip=True)])
    form = kl.closed_form(arm)
    assert [form.entries[k][3] for k in range(3)] == ["C1", "-S1", "0.5 - d2"]
    assert kl.jacobian_form(arm).entries[2] == ("0", "-1")
    assert kl.jacobian_form(arm).entries[5] == ("-1", "0")


def test_a_locked_joint_stays_where_it_is():
    arm = kl.Arm([kl.revolute(a=1), kl.revolute(a=1, limits=(0.5, 0.5)), kl.revolute(a=1)])
    assert arm.home.tolist() == [0, 0.5, 0]
    assert joint_ranges(arm)[:, 1].tolist() == [0.5, 0.5]
    target = kl.forward_kinematics(arm, [0.3, 0.5, -0.8])[:3, 3]
    for limits in ("keep", "ignore"):
        found = kl.inverse_kinematics(arm, target, [0, 0.3, 0.1], limits=limits)
        assert found.success and found.q[1] == 0.5
        assert kl.forward_kinematics(arm, found.q)[:3, 3] == pytest.approx(target, abs=1e-5)


def test_limits_of_one_value_lock():
    assert kl.prismatic(limits=(0.2, 0.2)).lock == 0.2
    assert kl.prismatic(limits=(0, 0.2)).lock is None
    assert kl.revolute().lock is None


def test_numbers_without_names():
    with pytest.raises(TypeError, match=r"^revolute: expected numbers with their names, got 0, 1; "
                                        r"write revolute\(theta=\.\.\., d=\.\.\., a=\.\.\., "):
        kl.revolute(0, 1)


@pytest.mark.parametrize("lasting, name", [(kl.revolute(), "a"), (BACK, "links")])
def test_data_that_does_not_change(lasting, name):
    with pytest.raises(FrozenInstanceError, match=rf"^{name}: this (Link|Arm) does not change; "
                                                  r"make another one with dataclasses\.replace"):
        setattr(lasting, name, 5)


@given(arms_and_q())
def test_the_jacobian_is_the_derivative(arm_and_q):
    arm, q = arm_and_q
    h = 1e-6
    moved = [kl.forward_kinematics(arm, q + h * e) - kl.forward_kinematics(arm, q - h * e)
             for e in np.eye(arm.n)]
    slopes = np.array([T[:3, 3] for T in moved]).T / (2 * h)
    assert kl.jacobian(arm, q)[:3] == pytest.approx(slopes, abs=1e-5)


@given(arms_and_q(), poses())
def test_conversion_keeps_every_pose(arm_and_q, tool):
    arm, q = arm_and_q
    arm = replace(arm, tool=tool)
    for there, back in ((kl.to_modified, kl.to_standard), (kl.to_standard, kl.to_modified)):
        other = back(there(arm))
        assert kl.forward_kinematics(there(arm), q) == pytest.approx(
            kl.forward_kinematics(arm, q), abs=1e-9)
        assert [link.kind for link in other.links] == [link.kind for link in arm.links]
        assert [link.flip for link in other.links] == [link.flip for link in arm.links]
