"""The six arms of the course: their tables, sources and poses, typed from the documents.

Nothing here multiplies DH matrices: each pose is a formula or a number of its own.
"""
from math import cos, pi, radians, sin

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import kinlab as kl

Q = pi / 2
# Rows (theta, d, a, alpha) at q = 0, in the order of the columns of a standard table.
TABLES = {
    kl.robots.two_link: ("modified", "RR", "m", [(0, 0, 0, 0), (0, 0, 1, 0)]),
    kl.robots.practical_six_link: ("modified", "RRRRRR", "m", [
        (0, 0, 0, 0), (0, -0.5, 0, Q), (0, 0, 0.5, 0), (0, 1, 0, -Q), (0, 0, 0, Q), (0, 0, 0, -Q)]),
    kl.robots.cylindrical: ("standard", "RPP", "m", [(0, 0.4, 0, 0), (Q, 0, 0, Q), (0, 0, 0, 0)]),
    kl.robots.exam_2018: ("standard", "RRP", "m", [(0, 0.5, 0, Q), (Q, 0.2, 0.4, Q), (Q, 0, 0, 0)]),
    kl.robots.alpha_ii: ("standard", "RRRRR", "mm", [
        (0, 215, 0, -Q), (0, 0, 177.8, 0), (0, 0, 177.8, 0), (0, 0, 0, -Q), (0, 129.5, 0, 0)]),
    kl.robots.intelledex_660t: ("standard", "RRRRRR", "mm", [
        (0, 373.4, 0, Q), (0, 0, 0, Q), (0, 0, 304.8, 0), (0, 0, 304.8, 0), (0, 0, 0, Q),
        (0, 228.6, 0, 0)]),
}
HOMES = {
    kl.robots.two_link: np.radians([30, 45]),
    kl.robots.practical_six_link: np.radians([0, 90, -90, 0, 0, 0]),
    kl.robots.cylindrical: [0, 0.3, 0.3],
    kl.robots.exam_2018: [0, 0, 0.4],
    kl.robots.alpha_ii: np.radians([0, 0, 0, -90, 0]),
    kl.robots.intelledex_660t: np.radians([90, -90, 90, 0, 90, 0]),
}
LIMITS = {
    kl.robots.two_link: [None] * 2,
    kl.robots.practical_six_link: [None] * 6,
    kl.robots.cylindrical: [None, (0.1, 0.6), (0.1, 0.6)],
    kl.robots.exam_2018: [None, None, (0.2, 0.8)],
    kl.robots.alpha_ii: [(-radians(x), radians(x)) for x in (150, 120, 135, 135, 180)],
    kl.robots.intelledex_660t: [None] * 6,
}
every = pytest.mark.parametrize("robot", TABLES, ids=lambda robot: robot.__name__)


def pose(robot, q):
    return kl.forward_kinematics(robot(), q)


def close(got, want, atol=1e-12):
    np.testing.assert_allclose(got, np.asarray(want, dtype=float), atol=atol)


def joints(n, low=-3.2, high=3.2):
    return st.lists(st.floats(low, high), min_size=n, max_size=n)


@every
def test_table(robot):
    arm = robot()
    convention, kinds, unit, rows = TABLES[robot]
    assert (arm.convention, arm.unit) == (convention, unit)
    assert "".join(link.kind[0].upper() for link in arm.links) == kinds
    assert [(link.theta, link.d, link.a, link.alpha) for link in arm.links] == rows


@every
def test_home_lies_within_the_limits(robot):
    arm = robot()
    close(arm.home, HOMES[robot], atol=1e-15)
    assert [link.limits for link in arm.links] == [
        limits and pytest.approx(limits) for limits in LIMITS[robot]]
    for q, link in zip(arm.home, arm.links):
        assert link.limits is None or link.limits[0] <= q <= link.limits[1]


@every
def test_base_and_tool(robot):
    tool = {kl.robots.two_link: (1, 0, 0), kl.robots.practical_six_link: (0, 0, 1)}
    arm = robot()
    close(arm.base, np.eye(4), atol=0)
    close(arm.tool[:3, :3], np.eye(3), atol=0)
    close(arm.tool[:3, 3], tool.get(robot, (0, 0, 0)), atol=0)


@every
def test_name_and_source(robot):
    assert robot().name and "Source: " in robot.__doc__ and "ome" in robot.__doc__
    assert robot() is not robot()


@given(joints(2))
def test_two_link(q):
    q1, q2 = q
    c, s = cos(q1 + q2), sin(q1 + q2)
    close(pose(kl.robots.two_link, q), [
        [c, -s, 0, cos(q1) + c], [s, c, 0, sin(q1) + s], [0, 0, 1, 0], [0, 0, 0, 1]])


def test_six_link_in_the_configuration_of_the_practical():
    arm = kl.robots.practical_six_link()
    q = np.radians([0, 90, -90, 0, 0, 0])
    frames = kl.link_frames(arm, q)
    close(frames[1:, :3, 3], [[0, 0, 0], [0, 0.5, 0], [0, 0.5, 0.5], [0, 0.5, 1.5],
                              [0, 0.5, 1.5], [0, 0.5, 1.5]])
    close(kl.forward_kinematics(arm, q), [[1, 0, 0, 0], [0, 1, 0, 0.5], [0, 0, 1, 2.5],
                                          [0, 0, 0, 1]])


def test_six_link_in_a_regular_configuration():
    T = pose(kl.robots.practical_six_link, np.radians([30, 40, -20, 50, 60, 70]))
    close(T[:3, 3], [-0.483900, -0.468074, 1.540540], atol=1e-6)


@given(joints(6))
def test_six_link_wrist_point(q):
    c1, s1, c2, s2 = cos(q[0]), sin(q[0]), cos(q[1]), sin(q[1])
    c23, s23 = cos(q[1] + q[2]), sin(q[1] + q[2])
    o6 = [0.5 * c1 * c2 - 0.5 * s1 - c1 * s23, 0.5 * s1 * c2 + 0.5 * c1 - s1 * s23, 0.5 * s2 + c23]
    arm = kl.robots.practical_six_link()
    close(kl.link_frames(arm, q)[6, :3, 3], o6)
    T = kl.forward_kinematics(arm, q)
    close(T[:3, 3], o6 + T[:3, 2])


def test_six_link_read_in_the_wrong_convention():
    arm = kl.robots.practical_six_link()
    wrong = kl.Arm(arm.links, tool=arm.tool)
    close(kl.forward_kinematics(wrong, arm.home)[:3, 3], [1, 1, -1])


@given(joints(3))
def test_cylindrical(q):
    c1, s1, d2, d3 = cos(q[0]), sin(q[0]), q[1], q[2]
    close(pose(kl.robots.cylindrical, q), [
        [-s1, 0, c1, c1 * d3], [c1, 0, s1, s1 * d3], [0, 1, 0, 0.4 + d2], [0, 0, 0, 1]])
    close(kl.link_frames(kl.robots.cylindrical(), q)[2], [
        [-s1, 0, c1, 0], [c1, 0, s1, 0], [0, 1, 0, 0.4 + d2], [0, 0, 0, 1]])


@given(joints(3))
def test_exam_2018(q):
    c1, s1, c2, s2, d3 = cos(q[0]), sin(q[0]), cos(q[1]), sin(q[1]), q[2]
    d1, offset, a2 = 0.5, 0.2, 0.4
    frames = kl.link_frames(kl.robots.exam_2018(), q)
    close(frames[1], [[c1, 0, s1, 0], [s1, 0, -c1, 0], [0, 1, 0, d1], [0, 0, 0, 1]])
    close(frames[2], [
        [-c1 * s2, s1, c1 * c2, offset * s1 - a2 * c1 * s2],
        [-s1 * s2, -c1, s1 * c2, -offset * c1 - a2 * s1 * s2],
        [c2, 0, s2, d1 + a2 * c2], [0, 0, 0, 1]])
    approach = np.array([c1 * c2, s1 * c2, s2])
    close(frames[3, :3, 3], frames[2, :3, 3] + d3 * approach)
    close(frames[3, :3, 2], approach)
    close(frames[3, :3, 0], [s1, -c1, 0])


@given(joints(5))
def test_alpha_ii(q):
    """The twelve entries of T_base^tool that lecture 2.8 prints."""
    c1, s1, c5, s5 = cos(q[0]), sin(q[0]), cos(q[4]), sin(q[4])
    c2, s2, c23, s23 = cos(q[1]), sin(q[1]), cos(q[1] + q[2]), sin(q[1] + q[2])
    c234, s234 = cos(q[1] + q[2] + q[3]), sin(q[1] + q[2] + q[3])
    reach = 177.8 * c2 + 177.8 * c23 - 129.5 * s234
    close(pose(kl.robots.alpha_ii, q), [
        [c1 * c234 * c5 + s1 * s5, -c1 * c234 * s5 + s1 * c5, -c1 * s234, c1 * reach],
        [s1 * c234 * c5 - c1 * s5, -s1 * c234 * s5 - c1 * c5, -s1 * s234, s1 * reach],
        [-s234 * c5, s234 * s5, -c234, 215 - 177.8 * s2 - 177.8 * s23 - 129.5 * c234],
        [0, 0, 0, 1]], atol=1e-10)


@given(joints(5))
def test_alpha_ii_base_to_wrist(q):
    c1, s1, c2, s2 = cos(q[0]), sin(q[0]), cos(q[1]), sin(q[1])
    c23, s23 = cos(q[1] + q[2]), sin(q[1] + q[2])
    reach = 177.8 * (c2 + c23)
    close(kl.link_frames(kl.robots.alpha_ii(), q)[3], [
        [c1 * c23, -c1 * s23, -s1, c1 * reach], [s1 * c23, -s1 * s23, c1, s1 * reach],
        [-s23, -c23, 0, 215 - 177.8 * (s2 + s23)], [0, 0, 0, 1]], atol=1e-10)


def test_alpha_ii_at_soft_home():
    arm = kl.robots.alpha_ii()
    assert kl.forward_kinematics(arm, arm.home).round(9).tolist() == [
        [0, 0, 1, 485.1], [0, -1, 0, 0], [1, 0, 0, 215], [0, 0, 0, 1]]


@given(joints(6))
@settings(max_examples=100)
def test_intelledex(q):
    c1, s1, c2, s2, c6, s6 = cos(q[0]), sin(q[0]), cos(q[1]), sin(q[1]), cos(q[5]), sin(q[5])
    q34, q345 = q[2] + q[3], q[2] + q[3] + q[4]
    c3, s3, c34, s34, C, S = cos(q[2]), sin(q[2]), cos(q34), sin(q34), cos(q345), sin(q345)
    u = np.array([c1 * c2, s1 * c2, s2])
    v = np.array([s1, -c1, 0])
    w = np.array([c1 * s2, s1 * s2, -c2])
    T = pose(kl.robots.intelledex_660t, q)
    close(T[:3, 0], (C * u + S * v) * c6 + w * s6)
    close(T[:3, 1], -(C * u + S * v) * s6 + w * c6)
    close(T[:3, 2], S * u - C * v)
    close(T[:3, 3], [0, 0, 373.4] + (304.8 * c3 + 304.8 * c34 + 228.6 * S) * u
          + (304.8 * s3 + 304.8 * s34 - 228.6 * C) * v, atol=1e-10)


def test_intelledex_at_soft_home():
    arm = kl.robots.intelledex_660t()
    close(kl.forward_kinematics(arm, arm.home), [
        [0, 0, 1, 838.2], [0, -1, 0, 0], [1, 0, 0, 373.4], [0, 0, 0, 1]], atol=1e-10)


def test_intelledex_agrees_with_the_lecture():
    """O1 = O2, z2 z3 z4 parallel, O4 = O5; at home the shoulder roll lies along the arm."""
    arm = kl.robots.intelledex_660t()
    frames = kl.link_frames(arm, np.random.default_rng(0).uniform(-3, 3, 6))
    close(frames[1, :3, 3], frames[2, :3, 3])
    close(frames[4, :3, 3], frames[5, :3, 3])
    close(frames[3:5, :3, 2], [frames[2, :3, 2]] * 2)
    close(kl.link_frames(arm, arm.home)[1, :3, 2], [1, 0, 0])


@every
def test_joint_names(robot):
    """Joints are told apart by their names, where they have any."""
    names = [link.name for link in robot().links if link.name]
    assert len(set(names)) == len(names)
