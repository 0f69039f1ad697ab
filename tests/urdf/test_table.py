"""A table is found for any chain of joints, and what is said of its frames is true."""
import re
from math import pi
from xml.sax.saxutils import escape

import numpy as np
import plain_reader
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from robots import KNOWN, held, robot, sliding, turning

import kinlab as kl
from kinlab.urdf.rows import clean_angle

pytestmark = pytest.mark.filterwarnings("ignore::kinlab.arms.inputs.Note")
decimals = st.integers(-2000, 2000).map(lambda k: k / 1000)
lengths = st.sampled_from([0.0, 0.0, 0.25]) | decimals | st.floats(-2, 2, allow_subnormal=False)
turns = st.sampled_from([0.0, pi / 2, -pi / 2, pi]) | st.floats(-pi, pi, allow_subnormal=False)


@st.composite
def rounded_turns(draw):
    """Right angles with as many digits as a file has."""
    return round(draw(turns), draw(st.integers(1, 16)))


def three(numbers):
    return st.tuples(numbers, numbers, numbers).map(lambda each: " ".join(map(repr, each)))


axes = st.sampled_from(["1 0 0", "0 1 0", "0 0 1", "0 0 -1", "0 -1 0", "-1 0 0"]) | three(
    st.floats(0.1, 2)) | st.just("0 1e-7 1")


@st.composite
def chains(draw, angle=None):
    """Two to seven joints and more, some fixed, in any places, about any axes."""
    places = st.tuples(three(lengths), three(angle or rounded_turns()))
    kinds = draw(st.lists(st.sampled_from([turning, turning, turning, sliding, held]), min_size=1,
                          max_size=7))
    joints = [turning("first", *draw(places), draw(axes))]
    for k, kind in enumerate(kinds):
        more = [] if kind is held else [draw(axes)]
        joints.append(kind(f"j{k}", *draw(places), *more))
    return robot("Any", *joints), f"{joints[-1][0]}_link"


@given(chains(), st.integers(0, 2**32))
def test_poses_of_any_chain_are_those_of_a_second_reader(chain, seed):
    text, tip = chain
    arm = kl.from_urdf(text)
    for q in np.random.default_rng(seed).uniform(-3, 3, (3, arm.n)):
        np.testing.assert_allclose(kl.forward_kinematics(arm, q),
                                   plain_reader.pose(text, tip, q), rtol=0, atol=1e-9)


@given(chains(), st.integers(0, 2**32))
def test_a_link_frame_of_the_file_is_where_the_record_says(chain, seed):
    text, _ = chain
    record = kl.urdf_frames(text)
    q = np.random.default_rng(seed).uniform(-3, 3, record.arm.n)
    frames = kl.link_frames(record.arm, q)
    for k, link in enumerate(record.links):
        moved = len(plain_reader.movable(text, link.link))
        theirs = plain_reader.pose(text, link.link, q[:moved])
        np.testing.assert_allclose(frames[link.frame] @ link.T, theirs, rtol=0, atol=2e-9)
        assert link.same == np.allclose(link.T, np.eye(4), rtol=0, atol=1e-9)
        assert (link in record.differ) != link.same, k


@pytest.mark.parametrize("right", ["1.57079632679", "1.57079632"])
@pytest.mark.parametrize("length", [0.001, 1, 100, 1e5])
def test_poses_are_exact_to_a_billionth_of_the_arms_length(length, right):
    """Pi with twelve digits is off by some 1e-12, which 1e5 m make 1e-7 m of."""
    places = [" ".join(f"{share * length:.9g}" for share in shares)
              for shares in ((0, 0.1, 0.3), (0.4, -0.2, 0), (0.3, 0.1, 0.2))]
    text = robot("Long", *(turning(f"j{k}", place, f"{right} 0 -{right}")
                           for k, place in enumerate(places)))
    arm, whole = kl.from_urdf(text), max(1.0, 1.2 * length)
    for q in np.random.default_rng(7).uniform(-3, 3, (20, 3)):
        np.testing.assert_allclose(kl.forward_kinematics(arm, q),
                                   plain_reader.pose(text, "j2_link", q), rtol=0,
                                   atol=1e-9 * whole)


def two(rpy, place="0.4 0 0", axis="0 0 1"):
    """Two axes, the second turned by rpy, and a tip."""
    return robot("Two", turning("one", "0 0 0.3"), turning("two", place, rpy, axis),
                 held("tip", "0.2 0 0.1"))


def worst(text, tip="tip_link"):
    arm = kl.from_urdf(text)
    q = np.random.default_rng(0).uniform(-3, 3, (50, arm.n))
    return max(np.abs(kl.forward_kinematics(arm, one) - plain_reader.pose(text, tip, one)).max()
               for one in q)


@given(st.floats(-18, -0.5).map(lambda power: 10**power), st.sampled_from(["1 0 0", "0 1 0"]),
       lengths, lengths, st.booleans())
@example(1.0e-9, "0 1 0", 0.4, 0.0, False)
@example(3.67e-6, "0 1 0", 0.4, 0.0, True)
def test_axes_of_any_small_tilt_keep_the_poses(tilt, about, x, y, upside_down):
    rpy = np.array([float(word) for word in about.split()]) * tilt + [pi * upside_down, 0, 0]
    assert worst(two(" ".join(map(repr, rpy.tolist())), f"{x} {y} 0")) < 1e-9


def test_axes_that_are_almost_parallel_get_a_fixed_row_and_not_a_row_of_kilometres():
    """3.1416 for pi, about the line that lies across: the common normal is 54 km away."""
    arm = kl.from_urdf(two("0 3.1416 0"))
    assert [link.kind for link in arm.links] == ["revolute", "fixed", "revolute"]
    assert arm.links[0].a == 0.4 and arm.links[0].alpha == 0
    assert arm.links[1].alpha == pytest.approx(3.1416 - pi, abs=1e-12)
    assert max(abs(link.d) for link in arm.links) < 1


def test_a_small_tilt_about_the_line_across_is_a_plain_row():
    arm = kl.from_urdf(two("0.0001 0 0"))
    assert (len(arm.links), arm.links[0].a) == (2, 0.4)
    assert arm.links[0].alpha == pytest.approx(1e-4, abs=1e-15)


def test_axes_that_meet_at_a_small_angle_meet_where_they_do():
    """One degree: they lie in a plane, so a = 0, and d is where they cross."""
    arm = kl.from_urdf(two(f"0 {pi / 180} 0", "0 0 1"))
    assert (arm.links[0].a, arm.links[0].d) == (0, pytest.approx(1.3, abs=1e-12))
    assert abs(arm.links[0].alpha) == pytest.approx(pi / 180, abs=1e-15)


def test_one_and_the_same_axis_twice():
    text = robot("Same", turning("one", "0 0 0.3"), turning("two", "0 0 0.2"),
                 held("tip", "0.5 0 0"))
    assert repr(kl.from_urdf(text)).splitlines()[2:] == ["1  θ1*  0.5    0  0°",
                                                         "2  θ2*    0  0.5  0°"]


@pytest.mark.parametrize("rpy", [f"{pi} 0 0", f"0 {pi} 0"])
def test_an_axis_against_the_one_before_counts_the_other_way(rpy):
    arm = kl.from_urdf(two(rpy))
    assert [link.flip for link in arm.links] == [False, True]
    assert arm.links[0].alpha == 0
    assert worst(two(rpy)) < 1e-12


def test_an_axis_against_the_roots_z_counts_the_other_way():
    text = robot("Down", turning("one", "0 0 1", axis="0 0 -1"), turning("two", "1 0 0"))
    arm = kl.from_urdf(text)
    assert [link.flip for link in arm.links] == [True, False]
    np.testing.assert_array_equal(arm.base, np.eye(4))


def test_the_base_takes_what_no_row_can():
    text = robot("Aside", turning("one", "0.1 0.2 0.3"), turning("two", "1 0 0"))
    arm = kl.from_urdf(text)
    np.testing.assert_array_equal(arm.base, kl.translation([0.1, 0.2, 0]))
    assert arm.links[0].d == 0.3


def test_a_first_axis_that_no_x_of_the_root_is_normal_to_counts_from_zero():
    """The base must be turned anyway: so x0 is x1."""
    text = robot("Aside", turning("one", "0 0 1", axis="1 0 0"),
                 turning("two", "0.5 0.3 0", axis="0 0 1"))
    arm = kl.from_urdf(text)
    assert arm.links[0].theta == 0
    np.testing.assert_array_equal(np.abs(arm.base[:3, 2]), [1, 0, 0])


@pytest.mark.parametrize(("last", "d", "tip"), [
    (turning, 0.3, (0.1, 0.2, 0)), (sliding, 0, (1.1, 0.2, 0.3))])  # it slides on the axis before
def test_of_a_tip_aside_the_last_row_takes_the_height_unless_it_slides(last, d, tip):
    text = robot("Aside", turning("one", "0 0 1"), last("two", "1 0 0"),
                 held("tip", "0.1 0.2 0.3", "0.1 0.2 0.3"))
    arm = kl.from_urdf(text)
    assert arm.links[-1].d == d
    np.testing.assert_allclose(arm.tool[:3, 3], tip, atol=1e-12)


def test_half_a_turn_is_written_in_one_way():
    assert [clean_angle(angle) for angle in (-pi, pi, 3 * pi, -1e-17)] == [pi, pi, pi, 0]


def test_the_convention_is_the_one_that_leaves_less_over():
    down = robot("Crane", turning("one", "0 0 0", axis="0 1 0"),
                 turning("two", "1 0 0", axis="0 1 0"), held("tip", "0 0 0", f"{-pi / 2} 0 0"))
    record = kl.urdf_frames(down)
    assert (record.arm.convention, record.why) == (
        "modified", "standard would need a matrix for the base, too")
    np.testing.assert_array_equal([record.arm.base, record.arm.tool], [np.eye(4)] * 2)
    assert kl.urdf_frames(robot("R", turning("one", "0 0 1"), held("tip", "1 0 0"))).why == (
        "modified would need a matrix for the tool, too")


def test_a_record_says_by_how_much_a_frame_differs():
    record = kl.urdf_frames(KNOWN["puma_560"])
    said = {link.link: (link.frame, link.moved, link.turned) for link in record.links}
    assert said["waist_link"] == (1, "", "90° about -x")
    assert said["shoulder_link"] == (2, "(-0.4318, 0, 0)", "90° about -x")
    assert said["pitch_link"] == (5, "", "")
    lines = repr(record).splitlines()
    assert lines[0] == "PUMA 560 in standard DH: both conventions fit alike."
    assert re.split(r"  +", lines[3].strip()) == ["waist_link", "1", "90° about -x"]
    assert re.split(r"  +", lines[7].strip()) == ["pitch_link", "5", "the same"]


def test_a_record_is_a_table_in_a_notebook():
    html = kl.urdf_frames(KNOWN["ur5"])._repr_html_()
    assert html.count("<tr>") == 9 and escape("120° about (0.57735, 0.57735, 0.57735)") in html


def test_limits_with_twelve_digits_are_whole_turns():
    text = robot("R", turning("j", "0 0 1", limit='lower="-6.28318530718" upper="3.14159265359"'))
    assert kl.from_urdf(text).links[0].limits == (-2 * pi, pi)
