"""URDFs of known arms, written by hand: their poses, their tables, and kinlab's own arms."""
from math import pi

import numpy as np
import plain_reader
import pytest
from robots import KNOWN, PANDA, PUMA, SCARA, STANFORD, UR5, turning
from robots import robot as urdf
from textbook import rigid, turn

import kinlab as kl

pytestmark = pytest.mark.filterwarnings("ignore::kinlab.arms.inputs.Note")
Z = [0, 0, 1]
TIPS = {name: "tool0_link" for name in KNOWN} | {
    "panda": "flange_link", "puma_560": "flange_link", "scara": "roll_link"}
# Where the tip is at q = 0, added up on paper.
ZERO = {"ur5": (0.425 + 0.39225, 0.10915 + 0.0823, 0.089159 - 0.09465),
        "panda": (0.088, 0, 0.333 + 0.316 + 0.384 - 0.107),
        "kr210": (0.35 + 1.5 + 0.303, 0, 0.75 + 1.25 - 0.054),
        "puma_560": (0.4318 + 0.0203, -0.15005, 0.672 + 0.4318),
        "scara": (0.425 + 0.375, 0, 0.877 - 0.2),
        "stanford": (0, 0.154, 0.412 + 0.263)}
# Whose q is which, and the base and tool between: from the documentation of their makers.
COUNTED = {"ur5": ([1, 1, 1, 1, 1, 1], rigid(turn(Z, pi)), np.eye(4)),  # base_link and UR's base
           "panda": ([1] * 7, np.eye(4), np.eye(4)),
           # At q = 0 x of tool0 points down, that of the table's frame 6 up.
           "kr210": ([-1, 1, 1, -1, 1, -1], np.eye(4), rigid(turn(Z, pi))),
           "puma_560": ([1] * 6, np.eye(4), np.eye(4)),
           "scara": ([1, -1, 1, 1], np.eye(4), np.eye(4)),  # the book's elbow turns about -z
           "stanford": ([1] * 6, np.eye(4), np.eye(4))}


@pytest.fixture(params=KNOWN)
def name(request):
    return request.param


def poses(arm, seed=1, many=50):
    return np.random.default_rng(seed).uniform(-3, 3, (many, arm.n))


def test_the_tip_at_zero_is_where_the_lengths_put_it(name):
    arm = kl.from_urdf(KNOWN[name])
    np.testing.assert_allclose(kl.forward_kinematics(arm, np.zeros(arm.n))[:3, 3], ZERO[name],
                               atol=1e-12)


def test_poses_are_those_of_another_reader(name):
    arm = kl.from_urdf(KNOWN[name])
    for q in poses(arm):
        np.testing.assert_allclose(kl.forward_kinematics(arm, q),
                                   plain_reader.pose(KNOWN[name], TIPS[name], q), atol=1e-12)


def test_poses_are_those_of_the_arm_in_kinlab(name):
    """The table of `kl.robots` is from a book, the URDF from a drawing: both are one arm."""
    arm, book = kl.from_urdf(KNOWN[name]), getattr(kl.robots, name)()
    signs, base, tool = COUNTED[name]
    q = poses(arm)
    metres = {"m": 1, "mm": 0.001}[book.unit]
    theirs = q * signs
    theirs[:, [link.kind == "prismatic" for link in book.joints]] /= metres
    T = kl.forward_kinematics(book, theirs)
    T[:, :3, 3] *= metres
    np.testing.assert_allclose(kl.forward_kinematics(arm, q), base @ T @ tool, atol=1e-9)


def test_the_table_of_the_ur5_is_urs_but_for_the_way_x_points():
    """UR prints a2 = -0.425, a3 = -0.39225, and alpha = 90, 0, 0, 90, -90, 0 degrees."""
    assert repr(kl.from_urdf(UR5)) == """\
UR5: standard DH, lengths in m, * marks the joint variable
i           θ         d        a     α
1         θ1*  0.089159        0  -90°
2         θ2*         0    0.425    0°
3         θ3*         0  0.39225    0°
4  θ4* + 180°   0.10915        0   90°
5         θ5*   0.09465        0  -90°
6         θ6*    0.0823        0    0°"""


def test_the_table_of_the_panda_is_craigs_and_its_frames_are_the_files():
    frames = kl.urdf_frames(PANDA)
    assert repr(frames.arm) == """\
Panda: modified DH, lengths in m, * marks the joint variable
i  α(i-1)   a(i-1)      d    θ
1      0°        0  0.333  θ1*
2    -90°        0      0  θ2*
3     90°        0  0.316  θ3*
4     90°   0.0825      0  θ4*
5    -90°  -0.0825  0.384  θ5*
6     90°        0      0  θ6*
7     90°    0.088  0.107  θ7*"""
    assert [link.link for link in frames.differ] == ["joint7_link"]
    assert frames.why == "its frames are the file's own"


def test_the_table_of_the_puma_is_the_books():
    assert repr(kl.from_urdf(PUMA)) == """\
PUMA 560: standard DH, lengths in m, * marks the joint variable
i    θ        d       a     α
1  θ1*    0.672       0   90°
2  θ2*        0  0.4318    0°
3  θ3*  0.15005  0.0203  -90°
4  θ4*   0.4318       0   90°
5  θ5*        0       0  -90°
6  θ6*        0       0    0°"""


def test_a_sliding_axis_stands_where_its_neighbours_meet_it():
    """The file has the quill's joint 5 cm beside its axis; the boom's axis meets the shoulder's."""
    assert [(link.a, link.d) for link in kl.from_urdf(SCARA).links] == [
        (0.425, 0.877), (0.375, 0), (0, 0), (0, -0.2)]
    assert [(link.a, link.d) for link in kl.from_urdf(STANFORD).links] == [
        (0, 0.412), (0, 0.154), (0, 0), (0, 0), (0, 0), (0, 0.263)]


def test_names_limits_and_speeds_are_the_files():
    waist, _, boom, *_ = kl.from_urdf(STANFORD).links
    assert (waist.name, waist.limits, waist.speed) == ("waist", (-3, 3), 2)
    assert (boom.kind, boom.name, boom.limits, boom.speed) == ("prismatic", "boom", (0.3, 1.2), 1)


def test_home_is_zero_or_the_limit_next_to_it():
    np.testing.assert_array_equal(kl.from_urdf(STANFORD).home, [0, 0, 0.3, 0, 0, 0])
    below = urdf("R", turning("j", "0 0 1", limit='lower="-2" upper="-1"'))
    assert kl.from_urdf(below).home == -1


@pytest.mark.parametrize("make", [kl.ArmView, kl.TargetView, kl.DHTableEditor])
def test_a_view_opens_with_it(make):
    arm = kl.from_urdf(SCARA)
    assert make(arm).arm.n == 4
