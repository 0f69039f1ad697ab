"""The arms that people know: tables, limits and poses, typed from the sources.

Nothing here multiplies DH matrices: each pose is a number or a formula that somebody published,
and where one was worked out by hand the test says so. The books were not at hand: their formulas
are as commonly quoted. What was read is named by its address.
"""
from dataclasses import dataclass, field, replace
from math import cos, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import kinlab as kl

Q = pi / 2
BASE = 0.672  # m, from the floor to the shoulder of the PUMA 560


@dataclass(frozen=True)
class Known:
    """What a source says of an arm. Angles of limits, home and speeds are in degrees, but for the
    Panda's, which are published in radians.
    """

    rows: list  # (theta, d, a, alpha) at q = 0
    home: list
    limits: list
    convention: str = "standard"
    kinds: str = "RRRRRR"
    unit: str = "m"
    base: float = 0  # along z, as the tool
    tool: float = 0
    speeds: list = field(default_factory=list)
    accelerations: list = field(default_factory=list)


KNOWN = {
    "puma_560": Known(
        [(0, 0.672, 0, Q), (0, 0, 0.4318, 0), (0, 0.15005, 0.0203, -Q), (0, 0.4318, 0, Q),
         (0, 0, 0, -Q), (0, 0, 0, 0)], home=[0, 45, -180, 0, 45, 0],
        limits=[(-160, 160), (-45, 225), (-225, 45), (-110, 170), (-100, 100), (-266, 266)]),
    "puma_560_craig": Known(
        [(0, 0, 0, 0), (0, 0, 0, -Q), (0, 0.15005, 0.4318, 0), (0, 0.4318, 0.0203, -Q),
         (0, 0, 0, Q), (0, 0, 0, -Q)], convention="modified", base=BASE,
        home=[0, -45, 0, 0, -45, 0], limits=[None] * 6),
    "stanford": Known(
        [(0, 0.412, 0, -Q), (0, 0.154, 0, Q), (0, 0, 0, 0), (0, 0, 0, -Q), (0, 0, 0, Q),
         (0, 0.263, 0, 0)], kinds="RRPRRR", home=[0, 75, 0.6, 0, 45, 0],
        limits=[(-170, 170), (-170, 170), (0.3048, 1.27), (-170, 170), (-90, 90), (-170, 170)]),
    "scara": Known(
        [(0, 877, 425, pi), (0, 0, 375, 0), (0, 0, 0, 0), (0, 200, 0, 0)], kinds="RRPR", unit="mm",
        home=[40, 80, 100, -40], limits=[(-150, 150), (-150, 150), (0, 195), (-180, 180)]),
    "ur5": Known(
        [(0, 0.089159, 0, Q), (0, 0, -0.425, 0), (0, 0, -0.39225, 0), (0, 0.10915, 0, Q),
         (0, 0.09465, 0, -Q), (0, 0.0823, 0, 0)], home=[0, -90, -90, -90, 90, 0],
        limits=[(-360, 360)] * 6, speeds=[180] * 6),
    "panda": Known(
        [(0, 0.333, 0, 0), (0, 0, 0, -Q), (0, 0.316, 0, Q), (0, 0, 0.0825, Q),
         (0, 0.384, -0.0825, -Q), (0, 0, 0, Q), (0, 0, 0.088, Q)],
        convention="modified", kinds="RRRRRRR", tool=0.107, home=[0, -45, 0, -135, 0, 90, 45],
        limits=[(-2.8973, 2.8973), (-1.7628, 1.7628), (-2.8973, 2.8973), (-3.0718, -0.0698),
                (-2.8973, 2.8973), (-0.0175, 3.7525), (-2.8973, 2.8973)],
        speeds=[2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61],
        accelerations=[15, 7.5, 10, 12.5, 15, 20, 20]),
    "kr210": Known(
        [(0, 0.75, 0, 0), (-Q, 0, 0.35, -Q), (0, 0, 1.25, 0), (0, 1.5, -0.054, -Q), (0, 0, 0, Q),
         (0, 0, 0, -Q)], convention="modified", tool=0.303, home=[0, -15, 30, 0, 75, 0],
        limits=[(-185, 185), (-45, 85), (-210, 65), (-350, 350), (-125, 125), (-350, 350)],
        speeds=[123, 115, 112, 179, 172, 219]),
}
every = pytest.mark.parametrize("name", KNOWN)


def made(name):
    return getattr(kl.robots, name)()


def close(got, want, atol=1e-12):
    np.testing.assert_allclose(got, np.asarray(want, dtype=float), atol=atol, rtol=0)


def joints(n):
    return st.lists(st.floats(-3.2, 3.2), min_size=n, max_size=n)


def turned(kinds, values, name=""):
    """Values in the arm's units: radians where a joint turns."""
    return [values if values is None or kind == "P" or name == "panda" else np.radians(values)
            for kind, values in zip(kinds, values)]


@every
def test_table(name):
    arm, known = made(name), KNOWN[name]
    assert (arm.convention, arm.unit) == (known.convention, known.unit)
    assert "".join(link.kind[0].upper() for link in arm.links) == known.kinds
    assert [(link.theta, link.d, link.a, link.alpha) for link in arm.links] == known.rows
    assert not any(link.flip for link in arm.links)
    for end, high in ((arm.base, known.base), (arm.tool, known.tool)):
        close(end, [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, high], [0, 0, 0, 1]], atol=0)


@every
def test_limits_home_and_rates(name):
    arm, known = made(name), KNOWN[name]
    close(arm.home, turned(known.kinds, known.home))
    for link, q, limits in zip(arm.links, arm.home, turned(known.kinds, known.limits, name)):
        assert (link.limits is None) == (limits is None)
        if limits is not None:
            close(link.limits, limits)
            assert link.limits[0] < q < link.limits[1]
    speeds = [link.speed for link in arm.links if link.speed]
    close(speeds, turned(known.kinds, known.speeds, name))
    close([link.acceleration for link in arm.links if link.acceleration], known.accelerations)
    assert all(rates in ([], [None] * arm.n) or None not in rates for rates in (
        [link.speed for link in arm.links], [link.acceleration for link in arm.links]))


@every
def test_name_source_and_names_of_joints(name):
    made_by, arm = getattr(kl.robots, name), made(name)
    assert arm.name and "Source: " in made_by.__doc__ and "ome" in made_by.__doc__
    assert made_by() is not made_by()
    names = [link.name for link in arm.links if link.name]
    assert len(set(names)) == len(names) in (0, arm.n)


@every
def test_at_home_the_arm_is_bent_and_can_move_any_way(name):
    """Not stretched, not on the floor, and no two axes of its wrist on one line."""
    arm = made(name)
    J, far = kl.jacobian(arm, arm.home), np.abs(kl.link_frames(arm, arm.home)[:, :3, 3]).max()
    J[:3] /= far
    J[:, [link.kind == "prismatic" for link in arm.links]] *= far
    assert np.linalg.svd(J)[1][min(6, arm.n) - 1] > 0.05
    assert kl.link_frames(arm, arm.home)[1:, 2, 3].min() >= 0


# ---- PUMA 560 ------------------------------------------------------------------------------------


@pytest.mark.parametrize("q, pose", [
    # petercorke/robotics-toolbox-matlab, README.md: p560.fkine([0 0 0 0 0 0])
    ([0, 0, 0, 0, 0, 0], [[1, 0, 0, 0.4521], [0, 1, 0, -0.15], [0, 0, 1, 0.4318 + BASE]]),
    # P. Corke, Robotics, Vision and Control, chapter 7: p560.fkine(qn)
    ([0, 45, 180, 0, 45, 0], [[0, 0, 1, 0.5963], [0, 1, 0, -0.1501], [-1, 0, 0, -0.0144 + BASE]]),
])
def test_puma_560_in_the_poses_of_the_toolbox(q, pose):
    """The shoulder is the origin there; here it stands 0.672 m above it."""
    arm = kl.robots.puma_560()
    close(kl.forward_kinematics(arm, np.radians(q))[:3], pose, atol=6e-5)


def test_puma_560_ready_and_stretched():
    """Worked out by hand for Corke's qr and qs: straight up, and level along x."""
    up, level = (kl.forward_kinematics(kl.robots.puma_560(), np.radians(q))[:3, 3]
                 for q in ([0, 90, -90, 0, 0, 0], [0, 0, -90, 0, 0, 0]))
    close(up, [0.0203, -0.15005, 0.672 + 0.8636])
    close(level, [0.8636, -0.15005, 0.672 - 0.0203])


@given(joints(6))
def test_puma_560_by_paul_and_zhang(q):
    """R. Paul, H. Zhang, Computationally efficient kinematics for manipulators with spherical
    wrists, 1986, as http://robotmechanicscontrol.info/FundamentalsOfRobotMechanics/Chapter03/
    Puma560ForwardKinematics.html writes it out.
    """
    (c1, c2, _, c4, c5, c6), (s1, s2, _, s4, s5, s6) = np.cos(q), np.sin(q)
    c23, s23 = cos(q[1] + q[2]), sin(q[1] + q[2])
    a2, a3, d3, d4 = 0.4318, 0.0203, 0.15005, 0.4318
    U512, U522 = -c5 * s6, -s5 * s6
    U412, U413 = -s4 * c6 + c4 * U512, -c4 * s5
    U422, U423 = c4 * c6 + s4 * U512, -s4 * s5
    U212, U213 = c23 * U412 - s23 * U522, -s23 * c5 + c23 * U413
    U222, U223 = s23 * U412 + c23 * U522, c23 * c5 + s23 * U413
    U214 = a2 * c2 - d4 * s23 + a3 * c23
    T = kl.forward_kinematics(kl.robots.puma_560(), q)
    close(T[:3, 1], [U212 * c1 - U422 * s1, U212 * s1 + U422 * c1, U222])
    close(T[:3, 2], [U213 * c1 - U423 * s1, U213 * s1 + U423 * c1, U223])
    close(T[:3, 3], [U214 * c1 + d3 * s1, U214 * s1 - d3 * c1,
                     a2 * s2 + a3 * s23 + d4 * c23 + BASE])


@given(joints(6))
def test_puma_560_by_craig(q):
    """J. J. Craig, Introduction to Robotics, chapter 3, kinematic equations of the PUMA 560."""
    (c1, c2, _, c4, c5, c6), (s1, s2, _, s4, s5, s6) = np.cos(q), np.sin(q)
    c23, s23 = cos(q[1] + q[2]), sin(q[1] + q[2])
    a2, a3, d3, d4 = 0.4318, 0.0203, 0.15005, 0.4318
    r11 = c1 * (c23 * (c4 * c5 * c6 - s4 * s6) - s23 * s5 * c6) + s1 * (s4 * c5 * c6 + c4 * s6)
    r21 = s1 * (c23 * (c4 * c5 * c6 - s4 * s6) - s23 * s5 * c6) - c1 * (s4 * c5 * c6 + c4 * s6)
    r31 = -s23 * (c4 * c5 * c6 - s4 * s6) - c23 * s5 * c6
    r12 = c1 * (c23 * (-c4 * c5 * s6 - s4 * c6) + s23 * s5 * s6) + s1 * (c4 * c6 - s4 * c5 * s6)
    r22 = s1 * (c23 * (-c4 * c5 * s6 - s4 * c6) + s23 * s5 * s6) - c1 * (c4 * c6 - s4 * c5 * s6)
    r32 = -s23 * (-c4 * c5 * s6 - s4 * c6) + c23 * s5 * s6
    r13 = -c1 * (c23 * c4 * s5 + s23 * c5) - s1 * s4 * s5
    r23 = -s1 * (c23 * c4 * s5 + s23 * c5) + c1 * s4 * s5
    r33 = s23 * c4 * s5 - c23 * c5
    px = c1 * (a2 * c2 + a3 * c23 - d4 * s23) - d3 * s1
    py = s1 * (a2 * c2 + a3 * c23 - d4 * s23) + d3 * c1
    pz = -a3 * s23 - a2 * s2 - d4 * c23
    close(kl.forward_kinematics(kl.robots.puma_560_craig(), q), [
        [r11, r12, r13, px], [r21, r22, r23, py], [r31, r32, r33, pz + BASE], [0, 0, 0, 1]])


@given(joints(6))
def test_puma_560_by_craig_from_frame_1_to_3_and_4(q):
    """T13 and T34 as M. Nechyba's course prints them: http://mil.ufl.edu/nechyba/www/
    __eel6667.f2003/course_materials/t5.inverse_kinematics/puma_inv_kinematics/HTMLLinks/
    index_2.html
    """
    c2, s2, c4, s4 = cos(q[1]), sin(q[1]), cos(q[3]), sin(q[3])
    c23, s23 = cos(q[1] + q[2]), sin(q[1] + q[2])
    frames = kl.link_frames(kl.robots.puma_560_craig(), q)
    close(np.linalg.inv(frames[1]) @ frames[3], [
        [c23, -s23, 0, 0.4318 * c2], [0, 0, 1, 0.15005], [-s23, -c23, 0, -0.4318 * s2],
        [0, 0, 0, 1]])
    close(np.linalg.inv(frames[3]) @ frames[4], [
        [c4, -s4, 0, 0.0203], [0, 0, 1, 0.4318], [-s4, -c4, 0, 0], [0, 0, 0, 1]])


@given(joints(6))
def test_both_tables_of_the_puma_560_are_one_arm(q):
    """Joints 1 and 2 count from zeros half a turn away; frames 2 to 6 are the same."""
    craig, corke = kl.robots.puma_560_craig(), kl.robots.puma_560()
    there = np.add(q, [pi, pi, 0, 0, 0, 0])
    close(kl.forward_kinematics(craig, q), kl.forward_kinematics(corke, there))
    close(kl.link_frames(craig, q)[2:], kl.link_frames(kl.to_modified(corke), there)[2:])
    close(kl.link_frames(craig, q)[0, 2, 3] - kl.link_frames(corke, there)[0, 2, 3], BASE)


def test_the_examiner_takes_both_tables_of_the_puma_560_for_one_mechanism():
    craig, corke = kl.robots.puma_560_craig(), kl.robots.puma_560()
    for strict in (False, True):
        verdict = kl.same_mechanism(kl.to_standard(craig), corke, strict=strict)
        assert verdict.ok and verdict.message == (
            "The same mechanism. Chosen differently: x1 points the other way; another base frame.")
        assert kl.same_mechanism(corke, craig, strict=strict).ok


# ---- Stanford arm --------------------------------------------------------------------------------


@given(joints(6))
def test_stanford(q):
    """M. Spong, S. Hutchinson, M. Vidyasagar, Robot Dynamics and Control, chapter 3, the matrix
    T06 of the Stanford manipulator, whose shoulder is the origin there. R. Paul's is the same with
    d6 = 0.
    """
    (c1, c2, _, c4, c5, c6), (s1, s2, _, s4, s5, s6) = np.cos(q), np.sin(q)
    d1, d2, d3, d6 = 0.412, 0.154, q[2], 0.263
    r11 = c1 * (c2 * (c4 * c5 * c6 - s4 * s6) - s2 * s5 * c6) - s1 * (s4 * c5 * c6 + c4 * s6)
    r21 = s1 * (c2 * (c4 * c5 * c6 - s4 * s6) - s2 * s5 * c6) + c1 * (s4 * c5 * c6 + c4 * s6)
    r31 = -s2 * (c4 * c5 * c6 - s4 * s6) - c2 * s5 * c6
    r12 = c1 * (-c2 * (c4 * c5 * s6 + s4 * c6) + s2 * s5 * s6) - s1 * (-s4 * c5 * s6 + c4 * c6)
    r22 = s1 * (-c2 * (c4 * c5 * s6 + s4 * c6) + s2 * s5 * s6) + c1 * (-s4 * c5 * s6 + c4 * c6)
    r32 = s2 * (c4 * c5 * s6 + s4 * c6) + c2 * s5 * s6
    r13 = c1 * (c2 * c4 * s5 + s2 * c5) - s1 * s4 * s5
    r23 = s1 * (c2 * c4 * s5 + s2 * c5) + c1 * s4 * s5
    r33 = -s2 * c4 * s5 + c2 * c5
    dx = c1 * s2 * d3 - s1 * d2 + d6 * (c1 * c2 * c4 * s5 + c1 * c5 * s2 - s1 * s4 * s5)
    dy = s1 * s2 * d3 + c1 * d2 + d6 * (c1 * s4 * s5 + c2 * c4 * s1 * s5 + c5 * s1 * s2)
    dz = c2 * d3 + d6 * (c2 * c5 - c4 * s2 * s5)
    close(kl.forward_kinematics(kl.robots.stanford(), q), [
        [r11, r12, r13, dx], [r21, r22, r23, dy], [r31, r32, r33, dz + d1], [0, 0, 0, 1]])


def test_stanford_upright_and_level():
    """Worked out by hand: the boom straight up; the boom along x and the hand pitched up."""
    arm = kl.robots.stanford()
    close(kl.forward_kinematics(arm, [0, 0, 0.5, 0, 0, 0]), [
        [1, 0, 0, 0], [0, 1, 0, 0.154], [0, 0, 1, 0.412 + 0.5 + 0.263], [0, 0, 0, 1]])
    close(kl.forward_kinematics(arm, [0, Q, 0.5, 0, -Q, 0]), [
        [1, 0, 0, 0.5], [0, 1, 0, 0.154], [0, 0, 1, 0.412 + 0.263], [0, 0, 0, 1]])


# ---- SCARA ---------------------------------------------------------------------------------------


@given(joints(4))
def test_scara(q):
    """R. Schilling, Fundamentals of Robotics, the arm matrix of the four-axis SCARA robot."""
    c1, s1, c12, s12 = cos(q[0]), sin(q[0]), cos(q[0] - q[1]), sin(q[0] - q[1])
    c124, s124 = cos(q[0] - q[1] - q[3]), sin(q[0] - q[1] - q[3])
    close(kl.forward_kinematics(kl.robots.scara(), q), [
        [c124, s124, 0, 425 * c1 + 375 * c12], [s124, -c124, 0, 425 * s1 + 375 * s12],
        [0, 0, -1, 877 - q[2] - 200], [0, 0, 0, 1]], atol=1e-10)


def test_scara_at_the_home_of_the_book():
    """Schilling's soft home, (0, 0, 100 mm, 90 degrees), and the corner of a square by hand."""
    arm = kl.robots.scara()
    close(kl.forward_kinematics(arm, [0, 0, 100, Q]), [
        [0, -1, 0, 800], [-1, 0, 0, 0], [0, 0, -1, 577], [0, 0, 0, 1]], atol=1e-10)
    close(kl.forward_kinematics(arm, [Q, Q, 0, 0])[:3, 3], [375, 425, 677], atol=1e-10)


# ---- UR5 -----------------------------------------------------------------------------------------


@given(joints(6))
def test_ur5(q):
    """ros-industrial/universal_robot, ur_kinematics/src/ur_kin.cpp, function forward.

    Its base is turned by half a turn about z, and its tool frame has our z, -x and -y as its axes.
    """
    (c1, c2, _, _, c5, c6), (s1, s2, _, _, s5, s6) = np.cos(q), np.sin(q)
    d1, a2, a3, d4, d5, d6 = 0.089159, -0.425, -0.39225, 0.10915, 0.09465, 0.0823
    c23, s23 = cos(q[1] + q[2]), sin(q[1] + q[2])
    c234, s234 = cos(q[1] + q[2] + q[3]), sin(q[1] + q[2] + q[3])
    z = [c234 * c1 * s5 - c5 * s1, c1 * c5 + c234 * s1 * s5, -s234 * s5]
    x = [c6 * (s1 * s5 + c234 * c1 * c5) - s234 * c1 * s6,
         -c6 * (c1 * s5 - c234 * c5 * s1) - s234 * s1 * s6, -c234 * s6 - s234 * c5 * c6]
    p = [d6 * z[0] - a3 * c23 * c1 - a2 * c1 * c2 - d5 * s234 * c1 - d4 * s1,
         d6 * z[1] + d4 * c1 - a3 * c23 * s1 - a2 * c2 * s1 - d5 * s234 * s1,
         d1 + a3 * s23 + a2 * s2 - d5 * c234 - d6 * s5 * s234]
    T = kl.forward_kinematics(kl.robots.ur5(), q)
    half = np.array([-1, -1, 1])  # half a turn about z
    close(half * T[:3, 2], z)
    close(half * T[:3, 3], p)
    close(half * T[:3, 0], np.negative(x))


@pytest.mark.parametrize("q, pose", [
    ([0, 0, 0, 0, 0, 0], [[-1, 0, 0, 0.817], [0, 0, 1, 0.191], [0, 1, 0, -0.006]]),
    ([0, -90, 0, 0, 90, 0], [[0, -1, 0, 0.095], [1, 0, 0, 0.109], [0, 0, 1, 0.988]])])
def test_ur5_in_modern_robotics(q, pose):
    """K. Lynch, F. Park, Modern Robotics, example 4.5: lengths in whole mm, the base turned."""
    T = kl.forward_kinematics(kl.robots.ur5(), np.radians(q))[:3]
    close([-T[0], -T[1], T[2]], pose, atol=1e-3)


def test_ur5_at_zero():
    """Along the maker's drawing, by hand: 0.425 + 0.39225 back, 0.10915 + 0.0823 to the side."""
    close(kl.forward_kinematics(kl.robots.ur5(), np.zeros(6))[:3, 3],
          [-0.81725, -0.19145, 0.089159 - 0.09465])


# ---- Panda ---------------------------------------------------------------------------------------


def with_hand(length):
    """The Panda with Franka's hand: turned by -45 degrees on the flange, so long to its grasp."""
    arm, s = kl.robots.panda(), 0.5**0.5
    return replace(arm, tool=[[s, s, 0, 0], [-s, s, 0, 0], [0, 0, 1, 0.107 + length], [0, 0, 0, 1]])


@pytest.mark.parametrize("q, hand, pose, atol", [
    # iamlab-cmu/frankapy, frankapy/franka_constants.py: HOME_JOINTS and HOME_POSE, as measured
    (np.radians([0, -45, 0, -135, 0, 90, 45]), 0.1034,
     [[1, 0, 0, 0.3069], [0, -1, 0, 0], [0, 0, -1, 0.4867]], 3e-4),
    # petercorke/robotics-toolbox-python, README.md: robot.fkine(robot.qr)
    ([0, -0.3, 0, -2.2, 0, 2.0, pi / 4], 0.1034,
     [[0.995, 0, 0.09983, 0.484], [0, -1, 0, 0], [0.09983, 0, -0.995, 0.4126]], 5e-5),
    # the same, tests/test_ETS.py, a model of elementary transforms
    ([1.4, 0.2, 1.8, 0.7, 0.1, 3.1, 2.9], 0.1034,
     [[-0.50827907, -0.57904589, 0.63746234, 0.44707793],
      [0.83014553, -0.52639462, 0.18375824, 0.16175746],
      [0.22915229, 0.62258699, 0.74824773, 0.96828043]], 1e-8),
    # the same, tests/test_DHRobot.py, test_fkine_panda
    ([1, 2, 3, 4, 5, 6, 7], 0.103,
     [[-0.8583, 0.1178, 0.4994, 0.1372], [0.1980, 0.9739, 0.1106, 0.3246],
      [-0.4734, 0.1938, -0.8593, 0.4436]], 6e-5)])
def test_panda_with_its_hand(q, hand, pose, atol):
    close(kl.forward_kinematics(with_hand(hand), q)[:3], pose, atol=atol)


def test_panda_upright():
    """By hand, from Franka's drawing: 0.333 + 0.316 + 0.384 up, the flange 0.107 back down."""
    close(kl.forward_kinematics(kl.robots.panda(), np.zeros(7)), [
        [1, 0, 0, 0.088], [0, -1, 0, 0], [0, 0, -1, 0.333 + 0.316 + 0.384 - 0.107], [0, 0, 0, 1]])


# ---- KR 210 --------------------------------------------------------------------------------------


@pytest.mark.parametrize("q, tip, quaternion, wrist", [
    ([-0.65, 0.45, -0.36, 0.95, 0.79, 0.49], [2.16135, -1.42635, 1.55109],
     [0.708611, 0.186356, -0.157931, 0.661967], [1.89451, -1.44302, 1.69366]),
    ([-0.79, -0.11, -2.33, 1.94, 1.14, -3.68], [-0.56754, 0.93663, 3.0038],
     [0.62073, 0.48318, 0.38759, 0.480629], [-0.638, 0.64198, 2.9988]),
    ([-2.99, -0.12, 0.94, 4.06, 1.29, -4.12], [-1.3863, 0.02074, 0.90986],
     [0.01735, -0.2179, 0.9025, 0.371016], [-1.1669, -0.17989, 0.85137])])
def test_kr210_in_the_cases_of_its_course(q, tip, quaternion, wrist):
    """udacity/RoboND-Kinematics-Project, IK_debug.py: joint values are rounded to 0.01 rad there.

    Its gripper points along x, ours along z; its z is our x. Quaternions are (x, y, z, w).
    """
    arm = kl.robots.kr210()
    T = kl.forward_kinematics(arm, q)
    close(T[:3, 3], tip, atol=0.01)
    close(kl.link_frames(arm, q)[5, :3, 3], wrist, atol=0.01)
    x, y, z, w = quaternion
    ahead = [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)]
    up = [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)]
    close(T[:3, 2], ahead, atol=0.01)
    close(T[:3, 0], up, atol=0.01)


@given(joints(6))
def test_kr210_wrist_point(q):
    """By hand, from the offsets of the joints in kr210.urdf.xacro of the same project."""
    q23 = q[1] + q[2]
    ahead = 0.35 + 1.25 * sin(q[1]) + (0.96 + 0.54) * cos(q23) - 0.054 * sin(q23)
    up = 0.33 + 0.42 + 1.25 * cos(q[1]) - (0.96 + 0.54) * sin(q23) - 0.054 * cos(q23)
    close(kl.link_frames(kl.robots.kr210(), q)[5, :3, 3],
          [ahead * cos(q[0]), ahead * sin(q[0]), up])


def test_kr210_at_zero():
    """By hand, from the same file: 0.35 + 0.96 + 0.54 + 0.193 + 0.11 ahead of the base."""
    close(kl.forward_kinematics(kl.robots.kr210(), np.zeros(6)), [
        [0, 0, 1, 2.153], [0, -1, 0, 0], [1, 0, 0, 0.33 + 0.42 + 1.25 - 0.054], [0, 0, 0, 1]])
