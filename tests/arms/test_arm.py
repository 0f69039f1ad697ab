"""The arm's data: defaults, checks, the printed table, and the two conventions."""
from dataclasses import FrozenInstanceError
from math import pi, radians

import numpy as np
import pytest
import textbook
from hypothesis import given
from strategies import arms, arms_and_q

import kinlab as kl
from kinlab.arms.motions import ROTATE, TRANSLATE, Motion, X, Z

close = np.testing.assert_allclose


def rows(arm):
    return [(link.kind, link.theta, link.d, link.a, link.alpha) for link in arm.links]


def test_a_link_holds_its_row():
    link = kl.revolute(theta=0.1, d=2, a=3, alpha=0.4, limits=(-1, 2), name="elbow")
    assert (link.kind, link.variable) == ("revolute", "theta")
    assert (link.theta, link.d, link.a, link.alpha) == (0.1, 2.0, 3.0, 0.4)
    assert (link.limits, link.name) == ((-1.0, 2.0), "elbow")
    slide = kl.prismatic(theta=0.1, d=2, a=3, alpha=0.4, limits=[0, 1], name="lift")
    assert (slide.kind, slide.variable) == ("prismatic", "d")
    assert (slide.theta, slide.d, slide.a, slide.alpha) == (0.1, 2.0, 3.0, 0.4)
    assert (slide.limits, slide.name) == ((0.0, 1.0), "lift")


@pytest.mark.parametrize("make", [kl.revolute, kl.prismatic])
def test_a_link_is_zero_and_unlimited_unless_told(make):
    link = make()
    assert (link.theta, link.d, link.a, link.alpha) == (0, 0, 0, 0)
    assert link.limits is None and link.name is None
    assert link == kl.Link(link.kind)


@pytest.mark.parametrize("make", [kl.revolute, kl.prismatic])
def test_a_joint_may_say_how_fast_it_goes(make):
    assert (make().speed, make().acceleration) == (None, None)
    link = make(speed=2, acceleration=5.5)
    assert (link.speed, link.acceleration) == (2.0, 5.5)
    arm = kl.to_modified(kl.Arm([link, make(a=1)]))
    assert (arm.links[0].speed, arm.links[0].acceleration) == (2.0, 5.5)


@pytest.mark.parametrize("rate", ["speed", "acceleration"])
@pytest.mark.parametrize("wrong", [0, -1, float("inf"), "fast"])
def test_a_joint_that_goes_no_way_is_refused(rate, wrong):
    with pytest.raises(ValueError, match=rf"^{rate}: expected"):
        kl.revolute(**{rate: wrong})


def test_an_arm_stands_at_the_origin_with_zero_home_unless_told():
    arm = kl.Arm(kl.revolute() for _ in range(3))
    assert (arm.n, arm.convention, arm.name, arm.unit) == (3, "standard", "", "m")
    assert np.array_equal(arm.base, np.eye(4)) and np.array_equal(arm.tool, np.eye(4))
    assert arm.home.tolist() == [0, 0, 0]


def test_an_arm_cannot_change_under_its_users():
    base = np.eye(4)
    arm = kl.Arm([kl.revolute()], base=base, home=[0.5])
    base[0, 3] = 7
    assert arm.base[0, 3] == 0
    for array in (arm.base, arm.tool, arm.home):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1
    with pytest.raises(FrozenInstanceError):
        arm.name = "other"
    with pytest.raises(FrozenInstanceError):
        arm.links[0].a = 1
    with pytest.raises(FrozenInstanceError):
        kl.closed_form(arm).lengths = {}
    with pytest.raises(FrozenInstanceError):
        kl.zyz_angles(np.eye(3)).fixed = 1


def test_all_but_the_links_is_given_by_name():
    with pytest.raises(TypeError):
        kl.Arm([kl.revolute()], "modified")
    with pytest.raises(TypeError):
        kl.revolute(0.1)


def test_arms_are_told_apart_by_identity():
    one, other = kl.robots.alpha_ii(), kl.robots.alpha_ii()
    assert one != other and len({one, other, one}) == 2


def test_the_chain_is_base_links_tool():
    arm = kl.Arm([kl.revolute(theta=0.1, d=2, a=3, alpha=0.4), kl.prismatic(d=5)],
                 tool=textbook.rigid(o=(0, 0, 6)))
    assert arm.chain == (
        (),
        (Motion(ROTATE, Z, 0.1, 0), Motion(TRANSLATE, Z, 2.0), Motion(TRANSLATE, X, 3.0),
         Motion(ROTATE, X, 0.4)),
        (Motion(ROTATE, Z, 0.0), Motion(TRANSLATE, Z, 5.0, 1), Motion(TRANSLATE, X, 0.0),
         Motion(ROTATE, X, 0.0)),
        (Motion(TRANSLATE, Z, 6.0),))


def test_a_modified_row_begins_about_x():
    arm = kl.Arm([kl.revolute(theta=0.1, d=2, a=3, alpha=0.4)], convention="modified")
    assert arm.chain[1] == (Motion(ROTATE, X, 0.4), Motion(TRANSLATE, X, 3.0),
                            Motion(ROTATE, Z, 0.1, 0), Motion(TRANSLATE, Z, 2.0))


def test_the_table_of_a_standard_arm():
    assert kl.robots.exam_2018().table() == [
        ["i", "θ", "d", "a", "α"],
        ["1", "θ1*", "0.5", "0", "90°"],
        ["2", "θ2* + 90°", "0.2", "0.4", "90°"],
        ["3", "90°", "d3*", "0", "0°"]]


def test_the_table_of_a_modified_arm():
    assert kl.robots.practical_six_link().table()[:3] == [
        ["i", "α(i-1)", "a(i-1)", "d", "θ"],
        ["1", "0°", "0", "0", "θ1*"],
        ["2", "90°", "0", "-0.5", "θ2*"]]


def test_offsets_in_the_table():
    arm = kl.Arm([kl.revolute(theta=-pi / 3, alpha=-0.0), kl.prismatic(d=-0.25),
                  kl.prismatic(d=1.5)])
    assert [row[1:3] for row in arm.table()[1:]] == [
        ["θ1* - 60°", "0"], ["0°", "d2* - 0.25"], ["0°", "d3* + 1.5"]]
    assert arm.table()[1][4] == "0°"


def test_the_text_of_an_arm():
    assert repr(kl.robots.alpha_ii()).splitlines() == [
        "Alpha II: standard DH, lengths in mm, * marks the joint variable",
        "i    θ      d      a     α",
        "1  θ1*    215      0  -90°",
        "2  θ2*      0  177.8    0°",
        "3  θ3*      0  177.8    0°",
        "4  θ4*      0      0  -90°",
        "5  θ5*  129.5      0    0°"]
    assert repr(kl.Arm([kl.revolute()])).startswith("standard DH, lengths in m,")


def test_the_html_of_an_arm():
    html = kl.robots.cylindrical()._repr_html_()
    assert ">Cylindrical: standard DH, lengths in m, * marks" in html
    assert "<th>θ</th>" in html and "<td>d2*</td>" in html
    assert html.count("<tr>") == html.count("</tr>") == 4


@given(arms_and_q())
def test_the_other_convention_has_the_same_pose(arm_and_q):
    arm, q = arm_and_q
    want = textbook.frames(arm, q)[-1]
    for convert, convention in ((kl.to_modified, "modified"), (kl.to_standard, "standard")):
        other = convert(arm)
        assert other.convention == convention and other.n == arm.n
        close(textbook.frames(other, q)[-1], want, atol=1e-11)
        close(kl.forward_kinematics(other, q), want, atol=1e-11)


@given(arms_and_q())
def test_there_and_back_has_the_same_pose(arm_and_q):
    arm, q = arm_and_q
    for back in (kl.to_standard(kl.to_modified(arm)), kl.to_modified(kl.to_standard(arm))):
        close(kl.forward_kinematics(back, q), textbook.frames(arm, q)[-1], atol=1e-11)


@given(arms(ends=None))
def test_there_and_back_gives_the_table_back(arm):
    there, back = ((kl.to_modified, kl.to_standard) if arm.convention == "standard"
                   else (kl.to_standard, kl.to_modified))
    again = back(there(arm))
    close(again.base, np.eye(4), atol=1e-12)
    close(again.tool, np.eye(4), atol=1e-12)
    for old, new in zip(arm.links, again.links):
        assert (new.kind, new.theta, new.d) == (old.kind, old.theta, old.d)
        assert new.a == pytest.approx(old.a, abs=1e-12)
        close(textbook.turn((1, 0, 0), new.alpha), textbook.turn((1, 0, 0), old.alpha), atol=1e-12)


def test_twist_and_length_move_one_row():
    arm = kl.robots.alpha_ii()
    modified = kl.to_modified(arm)
    assert [(link.a, link.alpha) for link in modified.links] == [
        (0, 0), (0, -pi / 2), (177.8, 0), (177.8, 0), (0, -pi / 2)]
    assert [(link.theta, link.d) for link in modified.links] == [
        (link.theta, link.d) for link in arm.links]
    assert np.array_equal(modified.tool, np.eye(4))
    assert rows(kl.to_standard(modified)) == rows(arm)


def test_the_last_row_goes_into_the_tool_and_the_first_into_the_base():
    tool, base = textbook.rigid(o=(0.1, 0.2, 0.3)), textbook.rigid(o=(1, 2, 3))
    screw = textbook.rigid(textbook.turn((1, 0, 0), 0.4), (2, 0, 0))
    links = [kl.revolute(a=2, alpha=0.4)]
    close(kl.to_modified(kl.Arm(links, tool=tool)).tool, screw @ tool)
    arm = kl.Arm(links, convention="modified", base=base)
    close(kl.to_standard(arm).base, base @ screw)


def test_conversion_keeps_everything_else():
    arm = kl.Arm([kl.revolute(a=1, limits=(-1, 2), name="elbow")], name="One", unit="mm",
                 home=[0.3])
    other = kl.to_modified(arm)
    assert (other.name, other.unit, other.home.tolist()) == ("One", "mm", [0.3])
    assert (other.links[0].limits, other.links[0].name) == ((-1, 2), "elbow")
    assert kl.to_standard(arm) is arm and kl.to_modified(other) is other


def test_home_may_lie_beyond_the_limits():
    link = kl.revolute(limits=(radians(-10), radians(10)))
    assert kl.Arm([link], home=[1]).home[0] == 1
