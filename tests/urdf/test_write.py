"""An arm written as URDF and read again, by kinlab and by a second reader, has the same poses."""
import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from math import pi

import numpy as np
import plain_reader
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import angles, arms, lengths

import kinlab as kl

pytestmark = pytest.mark.filterwarnings("ignore::kinlab.arms.inputs.Note")
ARMS = [name for name, make in vars(kl.robots).items()
        if name[0] != "_" and getattr(make, "__annotations__", None) == {"return": "Arm"}]
METRES = {"m": 1.0, "mm": 0.001}


def in_metres(arm, q):
    """Poses of the arm and its joint values, as metres have them."""
    scale = METRES[arm.unit]
    T, q = kl.forward_kinematics(arm, q), np.array(q)
    T[..., :3, 3] *= scale
    q[..., [link.kind == "prismatic" for link in arm.joints]] *= scale
    return T, q


def check(arm, q, atol=1e-9):
    text = kl.to_urdf(arm)
    T, q = in_metres(arm, q)
    np.testing.assert_allclose(kl.forward_kinematics(kl.from_urdf(text), q), T, rtol=0, atol=atol)
    for pose, values in zip(T, q):
        np.testing.assert_allclose(plain_reader.pose(text, "tool0", values), pose, rtol=0,
                                   atol=atol)
    return text


def test_all_arms_of_kinlab_are_tried():
    assert {"two_link", "alpha_ii", "scara", "panda", "kr210", "puma_560_craig"} <= {*ARMS}
    assert len(ARMS) >= 13


@pytest.mark.parametrize("name", ARMS)
def test_arms_of_kinlab_come_back(name):
    arm = getattr(kl.robots, name)()
    check(arm, np.random.default_rng(2).uniform(-3, 3, (20, arm.n)), 1e-12)


@pytest.mark.parametrize("name", ["two_link", "cylindrical", "exam_2018", "alpha_ii", "stanford",
                                  "puma_560", "ur5"])
def test_tables_come_back_as_books_have_them(name):
    """The link frames of what kinlab writes have their z and x where the book has them."""
    arm = kl.to_standard(getattr(kl.robots, name)())
    again = kl.to_standard(kl.from_urdf(kl.to_urdf(arm)))
    for mine, theirs in zip(again.links, arm.links, strict=True):
        scale = METRES[arm.unit]
        assert (mine.theta, mine.alpha) == (theirs.theta, theirs.alpha)
        assert (mine.a, mine.d) == pytest.approx((theirs.a * scale, theirs.d * scale), abs=1e-15)


@given(arms(), st.integers(0, 2**32))
def test_any_arm_comes_back(arm, seed):
    check(arm, np.random.default_rng(seed).uniform(-3, 3, (4, arm.n)))


small = st.sampled_from([0.0, 1e-16, 1e-12, 1e-11, 4e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4,
                         1e-3, 1e-2])
almost = st.builds(lambda angle, off, side: angle + side * off,
                   st.sampled_from([0.0, pi / 2, pi, -pi / 2]), small, st.sampled_from([1, -1]))


@given(arms(angle=almost, length=st.just(0.0) | lengths | small), st.integers(0, 2**32))
def test_axes_that_are_almost_parallel_lose_no_digits(arm, seed):
    check(arm, np.random.default_rng(seed).uniform(-3, 3, (4, arm.n)))


@given(arms(angle=almost | angles, length=st.just(0.0) | lengths))
def test_no_row_is_far_longer_than_the_arm(arm):
    """A common normal that is far away is not taken."""
    text = kl.to_urdf(arm)
    size = sum(np.linalg.norm([float(word) for word in origin.get("xyz").split()])
               for origin in ET.fromstring(text).findall("joint/origin"))
    for link in kl.from_urdf(text).links:
        assert max(abs(link.a), abs(link.d)) <= 25 * size + 1e-6


def test_what_is_written_is_what_urdf_has_for_it():
    arm = kl.Arm([kl.revolute(d=250, a=0, alpha=pi / 2, limits=(-1, 2), speed=3, name="waist"),
                  kl.prismatic(limits=(100, 400), speed=50, flip=True, name="boom"),
                  kl.revolute(a=30)], name="Crane", unit="mm", home=[0, 200, 0])
    robot = ET.fromstring(kl.to_urdf(arm))
    waist, boom, last, tool = robot.findall("joint")
    assert robot.get("name") == "Crane"
    assert [joint.get("type") for joint in (waist, boom, last, tool)] == [
        "revolute", "prismatic", "continuous", "fixed"]
    assert waist.find("limit").attrib == {"lower": "-1", "upper": "2", "effort": "1000000",
                                          "velocity": "3"}
    assert boom.find("limit").attrib == {"lower": "0.1", "upper": "0.4", "effort": "1000000",
                                         "velocity": "0.05"}
    assert last.find("limit").attrib == {"effort": "1000000", "velocity": "1000000"}
    assert boom.find("axis").get("xyz") == "0 0 -1"
    assert boom.find("origin").attrib == {"xyz": "0 0 0.25", "rpy": "1.5707963267948966 0 0"}
    assert tool.find("origin").attrib == {"xyz": "0.03 0 0", "rpy": "0 0 0"}
    again = kl.from_urdf(kl.to_urdf(arm))
    assert [(link.limits, link.speed) for link in again.links] == [
        ((-1, 2), 3), ((0.1, 0.4), 0.05), (None, None)]


def test_a_joint_without_a_speed_may_move_and_comes_back_without_one():
    """A simulator that obeys the file would hold a joint of speed or effort 0 for ever."""
    for unit in ("m", "mm", "in"):
        arm = kl.Arm([kl.revolute(a=1), kl.revolute(limits=(0, 1)), kl.prismatic(limits=(0, 1))],
                     unit=unit)
        text = kl.to_urdf(arm)
        limits = [joint.find("limit") for joint in ET.fromstring(text).findall("joint")[:3]]
        assert all(float(limit.get(name)) == 1e6 for limit in limits
                   for name in ("velocity", "effort"))
        assert [link.speed for link in kl.from_urdf(text).links] == [None] * 3


def test_a_locked_joint_stays_locked_and_home_is_there():
    arm = kl.Arm([kl.revolute(a=1, limits=(0.3, 0.3)), kl.revolute(a=1)])
    again = kl.from_urdf(kl.to_urdf(arm))
    assert again.links[0].lock == 0.3 and again.home[0] == 0.3


def test_a_slide_without_limits_gets_those_of_its_slider():
    arm = kl.Arm([kl.prismatic(), kl.prismatic(a=0.5, d=0.25, alpha=1)])
    assert [link.limits for link in kl.from_urdf(kl.to_urdf(arm)).links] == [(0, 0.75)] * 2


def test_fixed_rows_and_ends_are_part_of_the_links():
    T = kl.homogeneous(kl.rotation_x(0.3) @ kl.rotation_z(0.2), [0.1, 0.2, 0.3])
    arm = kl.Arm([kl.fixed(a=0.1, alpha=1), kl.revolute(), kl.fixed(d=0.2, theta=1),
                  kl.revolute(a=0.3), kl.fixed(a=0.1)], base=T, tool=T)
    text = check(arm, np.random.default_rng(0).uniform(-3, 3, (9, 2)), 1e-10)
    assert len(ET.fromstring(text).findall("joint")) == 3


def test_each_name_is_there_once():
    links = [kl.revolute(name="a"), kl.revolute(name="a"), kl.revolute(),
             kl.revolute(name="to_tool"), kl.revolute(name="joint_3")]
    robot = ET.fromstring(kl.to_urdf(kl.Arm(links)))
    assert [joint.get("name") for joint in robot.findall("joint")] == [
        "a", "a_2", "joint_3", "to_tool", "joint_3_2", "to_tool_2"]


@given(st.text(st.characters(exclude_categories=("Cc", "Cs", "Zl", "Zp"))))
def test_names_of_any_signs_come_back(name):
    """But for two signs that XML does not have."""
    again = kl.from_urdf(kl.to_urdf(kl.Arm([kl.revolute(name=name, a=1)], name=name)))
    said = re.sub("[\ufffe\uffff]", "\ufffd", name)
    assert (again.name, again.links[0].name) == (said or "arm", said or "joint_1")


def test_a_unit_that_nobody_knows_is_refused():
    for unit in ("", "L", "Mm"):
        with pytest.raises(ValueError, match=r"^arm: expected lengths in m, dm, .* got the unit "):
            kl.to_urdf(replace(kl.robots.two_link(), unit=unit))


@pytest.mark.parametrize(("unit", "metres"), [("m", 1), ("dm", 0.1), ("cm", 0.01), ("mm", 0.001),
                                              ("in", 0.0254), ("ft", 0.3048)])
def test_units_become_metres(unit, metres):
    arm = kl.Arm([kl.revolute(a=2), kl.prismatic(d=1, limits=(0, 3))], unit=unit)
    T = kl.forward_kinematics(kl.from_urdf(kl.to_urdf(arm)), [0, 0])
    np.testing.assert_allclose(T[:3, 3], [2 * metres, 0, metres], atol=1e-12)


def test_links_are_drawn_from_joint_to_joint():
    """The tube's two ends are its link's origin and the next joint's."""
    robot = ET.fromstring(kl.to_urdf(kl.robots.puma_560()))
    drawn = {link.get("name"): link.find("visual") for link in robot.findall("link")}
    seen = 0
    for joint in robot.findall("joint"):
        to = np.array([float(word) for word in joint.find("origin").get("xyz").split()])
        visual = drawn[joint.find("parent").get("link")]
        if visual is None:
            assert np.linalg.norm(to) < 0.05
            continue
        middle, rpy = ([float(word) for word in visual.find("origin").get(name).split()]
                       for name in ("xyz", "rpy"))
        half = float(visual.find("geometry/cylinder").get("length")) / 2
        way = plain_reader.rpy(*rpy)[:, 2] * half
        np.testing.assert_allclose([middle - way, middle + way], [[0, 0, 0], to], atol=1e-6)
        seen += 1
    assert seen == 4
