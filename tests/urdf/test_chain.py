"""What is wrong with a URDF is said in one sentence, and what it leaves open has its default."""
import re
import warnings
from math import pi

import numpy as np
import pytest
from hostile import CONTROL, TEXTS
from robots import held, sliding, turning
from robots import robot as urdf

import kinlab as kl
from kinlab.arms.inputs import Note

pytestmark = pytest.mark.filterwarnings("ignore::kinlab.arms.inputs.Note")


def joint(name="j", kind="revolute", parent="a", child="b", rest='<limit lower="-1" upper="1"/>'):
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/>'
            f'<child link="{child}"/>{rest}</joint>')


def robot(*joints, links="ab"):
    named = "".join(map("<link name='{}'/>".format, links))
    return f'<robot name="R">{named}{"".join(joints)}</robot>'


def refused(text, tip=None):
    with pytest.raises(ValueError) as caught:
        kl.from_urdf(text, tip)
    assert len(str(caught.value).splitlines()) == 1
    return str(caught.value)


def read(text, tip=None):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        arm = kl.from_urdf(text, tip)
    return arm, [str(word.message) for word in caught]


LIMIT = '<limit lower="-1" upper="1"/>'
WRONG = {
    "no link": ("<robot/>", r"^URDF: expected one root, .* got none; write a <link> for each body"),
    "no joint": (robot(links="a"), "^URDF: expected a joint that moves .* got a tip, 'a', that is "
                 "the root itself; give a robot whose joints move$"),
    "only fixed ones": (robot(joint(kind="fixed")), "got only fixed ones between 'a' and 'b'; g"),
    "two roots": (robot(joint(), links="abc"), "got 2: 'a', 'c'; tie them together with fixed"),
    "a circle": (robot(joint(), joint("k", parent="b", child="a")), "got none; the joints go in a"),
    "a circle beside": (robot(joint(), joint("k", parent="c", child="d"),
                              joint("l", parent="d", child="c"), links="abcd"),
                        "joints in a circle: 'c', 'd'"),
    "a loop": (robot(joint(), joint("k", parent="c"), joint("l", child="c"), links="abc"),
               "expected one joint above each link, got 'k' and 'j' above 'b'"),
    "its own parent": (robot(joint(), joint("k", parent="b", child="b")), "got 'k' and 'j' above"),
    "a link twice": (robot(joint(), links="aab"), "expected each link once, got two of name 'a'"),
    "a joint twice": (robot(joint(), joint(child="c"), links="abc"), "each joint once, got two of"),
    "a link without a name": (robot(joint()) .replace("<link name='a'/>", "<link/>"),
                              r"expected a name for each link.* write <link name=\"...\">"),
    "a joint without a name": (robot(joint("")), "expected a name for each joint"),
    "no parent": (robot(joint()).replace('<parent link="a"/>', ""), "^joint 'j': expected a par"),
    "no child": (robot(joint()).replace('<child link="b"/>', "<child/>"), "expected a child, got"),
    "another parent": (robot(joint(parent="x")), "expected a link of this file as its parent, got "
                       "'x'; there are 'a', 'b'"),
    "no type": (robot(joint(kind="")), "expected one of the types 'revolute', .*, got ''"),
    "another type": (robot(joint(kind="ball")), "'planar', got 'ball'; URDF has no other"),
    "floating": (robot(joint(kind="floating")), "turns or slides, got a floating one; choose"),
    "planar": (robot(joint(kind="planar")), "got a planar one"),
    "mimic": (robot(joint(rest='<mimic joint="k"/>')), "got one that follows another"),
    "two numbers": (robot(joint(rest=f'<origin rpy="0 1"/>{LIMIT}')),
                    "^joint 'j': expected three numbers in rpy, got '0 1'; write rpy=\"0 0 0\""),
    "four numbers": (robot(joint(rest=f'<axis xyz="0 0 0 1"/>{LIMIT}')), "three numbers in xyz"),
    "commas": (robot(joint(rest=f'<origin xyz="0, 0, 0.2"/>{LIMIT}')),
               "^joint 'j': expected three numbers in xyz, with spaces between them and no commas, "
               "got '0, 0, 0.2'; write xyz=\"0 0 0.2\"$"),
    "commas alone": (robot(joint(rest=f'<axis xyz="0,1,-2e1"/>{LIMIT}')), 'write xyz="0 1 -2e1"$'),
    "commas and points": (robot(joint(rest=f'<origin xyz="1.5,2 0,3 4"/>{LIMIT}')),
                          'write xyz="0 0 0"$'),
    "pi": (robot(joint(rest=f'<origin rpy="pi/2 0 0"/>{LIMIT}')), "^joint 'j', rpy: expected a "
           "number, got 'pi/2'; write 1.5707963267948966$"),
    "parts of pi": (robot(joint(rest='<limit lower="-2*pi/3" upper="1"/>')),
                    "^joint 'j', lower: .* got '-2\\*pi/3'; write -2.0943951023931953$"),
    "a part of pi that is none": (robot(joint(rest=f'<origin rpy="pi/0 0 0"/>{LIMIT}')),
                             "got 'pi/0'; write it as 0.25$"),
    "no digit of pi": (robot(joint(rest=f'<origin rpy=".pi 0 0"/>{LIMIT}')), "write it as 0.25$"),
    "a quaternion": (robot(joint(rest=f'<origin quat_xyzw="0 0 0 1"/>{LIMIT}')),
                     "^joint 'j': expected the turn as rpy, got quat_xyzw; "),
    "a word": (robot(joint(rest=f'<origin xyz="0 0 up"/>{LIMIT}')),
               "^joint 'j', xyz: expected a number, got 'up'; write it as 0.25"),
    "a comma": (robot(joint(rest=f'<origin xyz="0 0 0,5"/>{LIMIT}')), 'write xyz="0 0 0.5"$'),
    "a limit with a comma": (robot(joint(rest='<limit lower="0,5" upper="1"/>')),
                             "write the decimal point as .$"),
    "NaN": (robot(joint(rest=f'<origin xyz="0 0 nan"/>{LIMIT}')), "expected a number, got 'nan'"),
    "infinity": (robot(joint(rest=f'<origin xyz="0 0 inf"/>{LIMIT}')), "expected a number, got 'i"),
    "too large": (robot(joint(rest=f'<origin xyz="0 0 1e999"/>{LIMIT}')), "xyz: expected finite n"),
    "Python's numbers": (robot(joint(rest=f'<origin xyz="0 0 1_0"/>{LIMIT}')), "got '1_0'"),
    "a million signs": (robot(joint(rest=f'<origin xyz="0 0 {"1" * 10**6}"/>')), "got '1111"),
    "no axis at all": (robot(joint(rest=f'<axis xyz="0 0 0"/>{LIMIT}')), "axis that points some"),
    "exchanged limits": (robot(joint(rest='<limit lower="2" upper="1"/>')),
                         "^joint 'j': expected lower up to upper, got lower 2 and upper 1"),
    "no number as a limit": (robot(joint(rest='<limit lower="a" upper="1"/>')), "^joint 'j', low"),
    "a speed below zero": (robot(joint(rest='<limit lower="0" upper="1" velocity="-1"/>')),
                           "expected a velocity above zero, got -1"),
    "a macro of xacro": ('<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arm/></robot>',
                         "got <xacro:arm>; this is xacro, .*: xacro robot.urdf.xacro > robot.urdf"),
    "a value of xacro": (robot(joint(rest=f'<origin xyz="0 0 ${{h/2}}"/>{LIMIT}')),
                         r"got '\$\{h/2\}'; this is xacro"),
    "a limit of xacro": (robot(joint(rest='<limit lower="0" upper="${pi}"/>')), "this is xacro"),
}


@pytest.mark.parametrize(("text", "said"), WRONG.values(), ids=WRONG)
def test_what_is_wrong_is_said_in_a_sentence(text, said):
    assert re.search(said, refused(text))


def test_a_name_that_is_no_link_is_answered_with_those_that_there_are():
    two = robot(joint(), joint("k", parent="b", child="c"), links="abc")
    assert refused(two, "tool") == ("tip: expected the name of a link, got 'tool'; "
                                    "there are 'c', 'b', 'a'")
    many = robot(joint(), *(joint(f"j{k}", child=f"link{k}", kind="fixed") for k in range(40)),
                 links=["a", "b", *(f"link{k}" for k in range(40))])
    assert re.search(r"there are 'link7', .*, and 30 more$", refused(many, "link77"))


def test_the_end_of_the_longest_chain_is_the_example():
    text = robot(joint("wheel", child="w"), joint("j", child="b"),
                 joint("k", parent="b", child="c"), links="awbc")
    assert refused(text) == ("tip: expected one end of the arm, got 2: 'w', 'c'; choose one, or a "
                             "link before it: kl.from_urdf(..., tip='c')")


def test_a_tip_before_a_joint_that_is_none_of_an_arm_is_taken():
    text = robot(joint(), joint("k", "floating", "b", "c"), joint("m", "planar", "c", "d"),
                 links="abcd")
    assert kl.from_urdf(text, "b").n == 1
    assert refused(text, "a") == ("URDF: expected a joint that moves between root and tip, got a "
                                  "tip, 'a', that is the root itself; name another tip")


def test_an_end_that_never_moves_is_no_tip():
    """`base` of many robots: a second frame on the root."""
    text = robot(joint(), joint("k", "fixed", "a", "c"), links="abc")
    assert kl.from_urdf(text).n == 1


def test_joints_in_other_elements_are_none():
    text = robot(joint()).replace("</robot>", '<transmission name="t"><joint name="j"/>'
                                  '</transmission><gazebo><link name="x"/></gazebo></robot>')
    assert kl.from_urdf(text).n == 1


# ---- Defaults: https://wiki.ros.org/urdf/XML/joint


def test_an_axis_that_is_left_out_is_x():
    arm = kl.from_urdf(robot(joint(kind="prismatic")))
    np.testing.assert_allclose(kl.forward_kinematics(arm, [0.5])[:3, 3], [0.5, 0, 0], atol=1e-15)


def test_an_axis_of_another_length_is_a_direction():
    arm = kl.from_urdf(robot(joint(kind="prismatic", rest=f'<axis xyz="0 3 4"/>{LIMIT}')))
    np.testing.assert_allclose(kl.forward_kinematics(arm, [0.5])[:3, 3], [0, 0.3, 0.4], atol=1e-15)


def test_an_origin_may_have_one_attribute_or_none():
    for origin, z in (("<origin/>", 0), ('<origin xyz="0 0 2"/>', 2), ("", 0)):
        arm = kl.from_urdf(robot(joint(rest=origin + LIMIT)))
        assert kl.forward_kinematics(arm, [0])[2, 3] == z


def test_a_continuous_joint_has_no_limits_whatever_is_written():
    arm, said = read(robot(joint(kind="continuous", rest='<limit velocity="3"/>'
                                 '<axis xyz="0 0 1"/>')))
    assert (arm.links[0].limits, arm.links[0].speed, said) == (None, 3, [])


def test_limits_that_are_left_out_are_said():
    arm, said = read(robot(joint(rest='<axis xyz="0 0 1"/>')))
    assert arm.links[0].limits is None
    assert said == ["from_urdf: 'j' got no limits, as the file has no <limit> there"]


def test_limits_without_ends_lock_a_joint_and_that_is_said():
    arm, said = read(robot(joint(rest='<axis xyz="0 0 1"/><limit effort="1" velocity="1"/>')))
    assert arm.links[0].lock == 0
    assert said == ["from_urdf: 'j' cannot move, as a <limit> without lower and upper is 0 to 0 in "
                    "URDF; write both"]


def test_limits_in_degrees_are_said():
    _, said = read(robot(joint(rest='<limit lower="-180" upper="180"/><axis xyz="0 0 1"/>')))
    assert said == ["joint 'j', limits: -180 is 28.6 turns; angles are in radians: "
                    "np.radians(-180)"]


def test_turns_in_degrees_are_said_and_taken_as_radians():
    arm, said = read(robot(joint(rest=f'<origin rpy="0 0 90"/><axis xyz="0 0 1"/>{LIMIT}')))
    assert said[0] == ("joint 'j', rpy: 90 is 14.3 turns; angles are in radians: np.radians(90)")
    assert not [one for one in said[1:] if "turns" in one]
    c, s = np.cos(90), np.sin(90)
    np.testing.assert_allclose(kl.forward_kinematics(arm, [0])[:2, :2], [[c, -s], [s, c]],
                               atol=1e-12)


def test_a_slide_of_many_metres_is_no_angle():
    _, said = read(robot(joint(kind="prismatic", rest='<axis xyz="0 0 1"/>'
                               '<limit lower="-20" upper="20"/>')))
    assert said == []


def test_words_that_urdf_does_not_know_are_said():
    _, said = read(robot(joint(rest='<origin rp="1 0 0"/><axis xyz="0 0 1" order="zyx"/>'
                                    '<limit lower="-1" uper="1" drake:acceleration="2"/>')
                         ).replace("<robot", '<robot xmlns:drake="http://drake.mit.edu"'))
    assert said == [
        "from_urdf: 'order' in the <axis> of 'j' is not read; URDF has xyz there",
        "from_urdf: 'rp' in the <origin> of 'j' is not read; is rpy meant?",
        "from_urdf: 'uper' in the <limit> of 'j' is not read; is upper meant?"]


def test_one_word_of_many_joints_is_said_once():
    rest = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" jerk="1"/>'
    _, said = read(robot(joint(rest=rest), joint("k", parent="b", child="c", rest=rest),
                         links="abc"))
    assert said == ["from_urdf: 'jerk' in the <limit> of 'j', 'k' is not read; URDF has lower, "
                    "upper, velocity, effort there"]


@pytest.mark.parametrize("element", ['<origin xyz="0 0 1"/>', '<axis xyz="0 0 1"/>', LIMIT,
                                     '<parent link="a"/>', '<child link="b"/>'])
def test_a_second_element_is_said_and_the_first_is_read(element):
    tag = re.match(r"<\w+", element)[0]
    first = '<origin xyz="0 0 2"/><axis xyz="0 0 1"/>' + LIMIT
    arm, said = read(robot(joint(rest=first + element)))
    assert said == [f"from_urdf: the second {tag}> of 'j' is not read; leave one"]
    assert kl.forward_kinematics(arm, [0])[2, 3] == 2


def test_words_beside_the_way_to_the_tip_are_nobodys_business():
    text = robot(joint(rest='<axis xyz="0 0 1"/>' + LIMIT),
                 joint("k", "fixed", "a", "c", '<origin rp="1 0 0"/>'), links="abc")
    assert read(text)[1] == []


@pytest.mark.parametrize(("height", "remarks"), [("49", 0), ("812.5", 1)])
def test_millimetres_are_said(height, remarks):
    _, said = read(urdf("R", turning("j", "0 0 0"), held("tip", f"0 0 {height}")))
    assert [one for one in said if "long" in one] == remarks * [
        "from_urdf: the arm is 812.5 m long, as lengths in URDF are in metres; if the file's are "
        "in millimetres, divide them by 1000"]


def test_frames_that_differ_are_said_with_the_convention():
    text = urdf("R", turning("one", "0 0 0", axis="0 1 0"), turning("two", "1 0 0", axis="0 1 0"),
                held("tip", "0 0 0", f"{-pi / 2} 0 0"))
    _, said = read(text)
    assert said == ["from_urdf: modified DH, as standard would need a matrix for the base, too; "
                    "the frames of 2 of 4 links are not the file's own: kl.urdf_frames(...) lists "
                    "them"]


def test_a_rounded_right_angle_is_said():
    text = urdf("R", turning("one", "0 0 1"), turning("two", "0 0 0", "1.5708 0 0"),
                held("tip", "0 0 0"))
    arm, said = read(text)
    assert arm.links[1].alpha == pytest.approx(1.5708, abs=1e-15)
    assert said[-1] == ("from_urdf: angles of 'two' in the file are rounded, such as 1.5708 for "
                        "pi/2; so angles in row 2 are not exact; write 1.5707963267948966 for pi/2")


def test_a_rounded_turn_of_the_base_is_said():
    text = urdf("R", turning("one", "0 0 1", "-1.0472 0 0"), turning("two", "0 0 0", "1.2 0 0"))
    arm, said = read(text)
    assert not np.array_equal(arm.base, np.eye(4))
    assert said[-1] == ("from_urdf: angles of 'one' in the file are rounded, such as -1.0472 for "
                        "-pi/3; so angles in the base are not exact; write -1.0471975511965976 for "
                        "-pi/3")


def lite6(right, half):
    """The turns of the Lite 6 in its maker's file, and its lengths."""
    return urdf("Lite 6", turning("joint1", "0 0 0.2435"),
                turning("joint2", "0 0 0", f"{right} -{right} {half}"),
                turning("joint3", "0.2002 0 0", f"-{half} 0 {right}"),
                turning("joint4", "0.087 -0.22761 0", f"{right} 0 0"),
                turning("joint5", "0 0 0", f"{right} 0 0"),
                turning("joint6", "0 0.0625 0", f"-{right} 0 0"))


def test_a_fixed_row_that_comes_of_rounding_is_explained():
    arm, said = read(lite6("1.5708", "3.1416"))
    assert [link.kind for link in arm.links].index("fixed") == 2 and len(arm.links) == 7
    assert said[-1] == (
        "from_urdf: angles of 'joint2', 'joint3', 'joint4', 'joint5', 'joint6' in the file are "
        "rounded, such as 1.5708 for pi/2; so angles in rows 1, 2, 3, 4, 5, 6 are not exact, and "
        "row 3 without a joint came in, as axes that should be parallel are not quite so; write "
        "1.5707963267948966 for pi/2")
    arm, said = read(lite6("1.5707963267948966", "3.141592653589793"))
    assert len(arm.links) == 6 and not [one for one in said if "rounded" in one]


def test_an_angle_that_is_meant_so_is_not_called_rounded():
    _, said = read(urdf("R", turning("one", "0 0 1"), turning("two", "0.3 0 0", "1.5718 0 0")))
    assert not [one for one in said if "rounded" in one]


def test_twelve_digits_of_pi_are_pi():
    text = urdf("R", turning("one", "0 0 1"), turning("two", "0 0 0", "1.57079632679 0 0"))
    assert kl.from_urdf(text).links[1].alpha == pi / 2


def test_the_line_of_the_student_is_the_one_that_is_warned_of():
    with pytest.warns(Note, match="got no limits") as caught:
        kl.from_urdf(robot(joint(rest="")))
    assert {word.filename for word in caught} == {__file__}


# ---- Names


@pytest.mark.parametrize("name", TEXTS.values(), ids=TEXTS)
def test_names_are_text_and_stay_what_they_are(name):
    arm = kl.Arm([kl.revolute(name=name, a=1), kl.prismatic(limits=(0, 1))], name=name)
    again = kl.from_urdf(kl.to_urdf(arm))
    assert (again.name, again.links[0].name) == (name, name)
    assert "<img" not in again._repr_html_() and "<script" not in again._repr_html_()
    shown = kl.urdf_frames(kl.to_urdf(arm))._repr_html_()
    assert set(re.findall(r"<(\w+)", shown)) <= {"table", "caption", "thead", "tbody", "tr", "th",
                                                 "td"}


@pytest.mark.parametrize("name", TEXTS.values(), ids=TEXTS)
def test_a_link_of_any_name_is_found(name):
    from xml.sax.saxutils import quoteattr
    text = robot(joint()).replace('"b"', quoteattr(name)).replace("'b'", quoteattr(name))
    assert kl.from_urdf(text, name).n == 1
    frames = kl.urdf_frames(text)
    assert frames.links[-1].link == name
    assert "<img" not in frames._repr_html_() and "<svg" not in frames._repr_html_()


def test_a_name_of_a_million_signs_is_shortened_in_a_sentence():
    long = "n" * 10**6
    for text in (robot(joint(long, "planar")), robot(joint(kind=long)), robot(joint(long, rest="")),
                 robot(joint(child=long)), robot(joint(), links=["a", "b", long, long]),
                 robot(joint(), joint(long)), f"<{long}/>"):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                kl.from_urdf(text)
            except ValueError as error:
                assert len(str(error)) < 400
        assert all(len(str(word.message)) < 400 for word in caught)


def test_a_name_of_two_lines_is_refused():
    assert refused(robot(joint(name="a&#10;b"))).startswith("joint name: expected one line of text")
    assert refused(robot(joint(), links=["a", "b", "c\u2028"])).startswith("link name: expected")
    assert refused(robot(joint()).replace('"R"', '"a&#x2029;"')).startswith("name: expected one")


@pytest.mark.parametrize("kind", CONTROL)
def test_signs_that_no_text_has_are_refused(kind):
    """XML itself makes spaces of the ends of lines in a name."""
    text = robot(joint(name=CONTROL[kind]))
    if kind in ("lines", "end of a line", "return"):
        assert kl.from_urdf(text).links[0].name == re.sub("[\r\n]", " ", CONTROL[kind])
    else:
        assert "expected" in refused(text)


def test_a_chain_of_a_thousand_links_is_read():
    joints = [turning(f"j{k}", "0.001 0 0", "0.1 0.2 0.3") for k in range(1000)]
    arm = kl.from_urdf(urdf("Snake", *joints, sliding("last", "0 0 0")))
    assert arm.n == 1001
