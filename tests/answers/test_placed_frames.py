"""Frames placed on a drawn arm: valid ones give a table, broken ones are named.

KINLAB_EXAMINER sets on how many random arms, four times over.
"""
import os
import re
from math import pi, radians

import mechanisms as m
import numpy as np
import pytest

import kinlab as kl
from kinlab.arms import robots

COUNT = int(os.environ.get("KINLAB_EXAMINER", 400)) // 4
Y, Z = np.eye(3)[1:]
ARMS = [robots.two_link, robots.practical_six_link, robots.cylindrical, robots.exam_2018,
        robots.alpha_ii, robots.intelledex_660t]
SCARA = kl.Arm([kl.revolute(d=0.3, a=0.4), kl.revolute(a=0.3, alpha=pi), kl.prismatic()])
BENT = kl.Arm([kl.revolute(d=300, a=100, alpha=pi / 2), kl.revolute(a=200, alpha=pi / 2),
               kl.revolute(d=150)], unit="mm")


def triples(arm, q):
    """The frames of a standard table as a student would hand them over."""
    return [(T[:3, 2], T[:3, 0], T[:3, 3]) for T in kl.link_frames(arm, q)]


def moved(frames, i, *, z=None, x=None, origin=None):
    """The frames with one of them placed anew."""
    new = [old if given is None else given for given, old in zip((z, x, origin), frames[i])]
    return [*frames[:i], new, *frames[i + 1:]]


def turned(v, axis, degrees):
    """A vector turned about a unit axis that is perpendicular to it."""
    return np.cos(radians(degrees)) * v + np.sin(radians(degrees)) * np.cross(axis, v)


GOOD = triples(BENT, [0, 0, 0])


def refused(frames, arm, q, words):
    placement = kl.examine_frames(frames, arm, q)
    assert not placement.ok and placement.arm is None
    assert words in placement.message


@pytest.mark.parametrize("make", ARMS)
def test_the_frames_of_a_table_give_the_table_back(make):
    arm = make()
    standard = kl.to_standard(arm)
    placement = kl.examine_frames(triples(standard, arm.home), arm)
    assert placement.ok and repr(placement) == "✓ Correct. All frames keep the rules."
    found = placement.arm
    assert kl.same_mechanism(found, arm, tip=False).ok
    assert np.allclose(kl.link_frames(found, found.home), kl.link_frames(standard, arm.home))
    for link, original in zip(found.links, standard.links):
        assert (link.kind, link.name) == (original.kind, original.name)
        assert [link.a, link.alpha] == pytest.approx([original.a, original.alpha])


def test_random_valid_frames_give_the_same_mechanism():
    rng = np.random.default_rng(5)
    for _ in range(COUNT):
        arm = m.random_arm(rng)
        new, q0, _ = m.reassigned(arm, rng)
        placement = kl.examine_frames(triples(new, np.zeros(arm.n)), arm, q0)
        assert placement.ok, placement.message
        verdict = kl.same_mechanism(placement.arm, arm, tip=False)
        assert verdict.ok, verdict.message
        assert np.allclose(kl.link_frames(placement.arm, placement.arm.home),
                           kl.link_frames(new, np.zeros(arm.n)), atol=1e-9)


def test_random_frames_with_one_off_its_axis_are_refused():
    rng = np.random.default_rng(6)
    for _ in range(COUNT):
        arm = m.random_arm(rng, kinds=(kl.revolute,), n=int(rng.integers(2, 6)))
        new, q0, _ = m.reassigned(arm, rng)
        frames, i = triples(new, np.zeros(arm.n)), int(rng.integers(arm.n))
        z, x, origin = frames[i]
        away = np.cross(z, m.random_direction(rng))
        refused(moved(frames, i, origin=origin + away), arm, q0, f"The origin of frame {i} is")
        refused(moved(frames, i, z=z + 0.1 * x), arm, q0,
                f"z{i} must lie along the axis of joint {i + 1}, either way: turn it by 5.711°.")


def obey(frames, message):
    """The frames after what the message asks for, where it says how far and along or about what."""
    slide = re.search(r"slide the origin by (\S+) m along z(\d)", message)
    turn = re.search(r" by (\S+)° about z(\d)", message)
    i = int((slide or turn)[2])
    z, x, origin = frames[i]
    if slide:
        return moved(frames, i, origin=origin + float(slide[1]) * z)
    return moved(frames, i, x=turned(x, z, float(turn[1])))


def test_what_a_message_asks_for_mends_the_frame():
    """Frames turned and slid at random: each message names the first broken one and repairs it."""
    rng, said = np.random.default_rng(7), {"Rule 1": 0, "Rule 2": 0}
    for _ in range(COUNT):
        arm = m.random_arm(rng, n=int(rng.integers(2, 7)))
        new, q0, _ = m.reassigned(arm, rng)
        frames = triples(new, np.zeros(arm.n))
        for i in range(1, arm.n + 1):
            z, x, origin = frames[i]
            x, origin = turned(x, z, rng.uniform(-80, 80)), origin + rng.uniform(-1, 1) * z
            frames = moved(frames, i, x=x, origin=origin)
        named = []
        while not (placement := kl.examine_frames(frames, arm, q0)).ok:
            said[placement.message[:6]] += 1
            named.append(int(re.search(r"[xz](\d)", placement.message)[1]))
            frames = obey(frames, placement.message)
            assert len(named) <= 2 * arm.n, placement.message
        assert named == sorted(named)
        assert kl.same_mechanism(placement.arm, arm, tip=False).ok
    assert min(said.values()) > COUNT / 2


def test_four_decimals_are_enough_and_the_table_is_exact():
    rng = np.random.default_rng(9)
    for _ in range(COUNT):
        arm = m.random_arm(rng)
        new, q0, _ = m.reassigned(arm, rng)
        if np.ptp(kl.link_frames(arm, q0)[:, :3, 3], axis=0).max() < 0.5:
            continue  # four decimals of a metre are rough for a small arm
        frames = [np.round(frame, 4) for frame in triples(new, np.zeros(arm.n))]
        placement = kl.examine_frames(frames, arm, q0)
        assert placement.ok, placement.message
        verdict = kl.same_mechanism(placement.arm, arm, tip=False)
        assert verdict.ok, verdict.message


def test_a_slide_typed_near_a_turning_axis_sits_on_it():
    base = m.random_pose(np.random.default_rng(2))
    lift = kl.Arm([kl.revolute(), kl.prismatic(), kl.revolute(a=0.5)], base=base)
    frames = [np.round(frame, 4) for frame in triples(lift, [0.3, 0.2, 0.1])]
    found = kl.examine_frames(frames, lift, [0.3, 0.2, 0.1]).arm
    assert [link.a for link in found.links] == pytest.approx([0, 0, 0.5], abs=1e-4)
    assert [link.a for link in found.links[:2]] == pytest.approx([0, 0], abs=1e-9)
    assert found.home == pytest.approx([0.3, 0.2, 0.1], abs=1e-3)


def test_a_frame_far_down_its_axis_loosens_no_other():
    z, _, origin = GOOD[0]
    far = moved(GOOD, 0, origin=origin - 1e6 * z)
    assert kl.examine_frames(far, BENT).ok
    refused(moved(far, 2, origin=GOOD[2][2] + GOOD[2][0]), BENT, None,
            "slide the origin by -1 mm along z2.")


def test_rule_1_is_named_with_the_turn():
    z, x, _ = GOOD[1]
    refused(moved(GOOD, 1, x=turned(x, z, 10)), BENT, None,
            "Rule 1: x1 is not perpendicular to z0 (they are ")
    message = kl.examine_frames(moved(GOOD, 1, x=turned(x, z, 10)), BENT).message
    assert message.endswith("apart): turn x1 by -10° about z1.")


@pytest.mark.parametrize("shift", [30, -12.5])
def test_rule_2_is_named_with_the_slide(shift):
    z, _, origin = GOOD[2]
    broken = moved(GOOD, 2, origin=origin + shift * z)
    refused(broken, BENT, None, "Rule 2: x2 is perpendicular to z1 but does not meet it: slide "
            f"the origin by {-shift:g} mm along z2.")


def test_rule_2_between_parallel_axes_asks_for_another_x():
    q = [0.3, 0.4, 0.1]
    frames = triples(SCARA, q)
    refused(moved(frames, 1, x=turned(frames[1][1], Z, 20)), SCARA, q, "Rule 2: x1 is "
            "perpendicular to z0 but does not meet it: z0 and z1 are parallel, so point x1 "
            "straight from one to the other. Turn it by -20° about z1.")


def test_an_origin_may_slide_along_parallel_axes_and_a_z_may_turn_round():
    q = [0.3, 0.4, 0.1]
    frames = triples(SCARA, q)
    z, _, origin = frames[1]
    placement = kl.examine_frames(moved(frames, 1, z=-z, origin=origin + 0.7 * z), SCARA, q)
    assert placement.ok
    assert [link.d for link in placement.arm.links[:2]] == pytest.approx([1, 0.7])


def test_a_frame_must_be_square_and_on_its_axis():
    refused(moved(GOOD, 0, x=(1, 0, 1)), BENT, None, "x0 and z0 are 45° apart")
    refused(moved(GOOD, 0, z=Y), BENT, None, "z0 must lie along the axis of joint 1, either way: "
            "turn it by 90°.")
    refused(moved(GOOD, 0, origin=(0, 40, 0)), BENT, None,
            "The origin of frame 0 is 40 mm away from the axis of joint 1: move it onto the axis.")


def test_a_prismatic_axis_has_no_place():
    """Of the lift's two parallel axes only the turning one has to be met."""
    arm = kl.Arm([kl.prismatic(), kl.revolute()])
    frames = [(Z, (1, 0, 0), (5, 7, 0)), (Z, (1, 0, 0), (0, 7, 0)), (Z, (1, 0, 0), (0, 7, 0))]
    refused(frames, arm, [0, 0], "The origin of frame 1 is 7 m away from the axis of joint 2")
    frames = [(Z, (1, 0, 0), (5, 0, 0)), (Z, (1, 0, 0), (0, 0, 0)), (Z, (1, 0, 0), (0, 0, 0))]
    assert kl.examine_frames(frames, arm, [0, 0]).ok


def test_directions_may_have_any_length():
    assert kl.examine_frames([(5 * z, 0.1 * x, o) for z, x, o in GOOD], BENT).ok


@pytest.mark.parametrize("frames, q, words", [
    (GOOD[:3], None, r"frames: expected 4 frames \(z, x, origin\)"),
    (moved(GOOD, 1, z=(0, 0, 0)), None, r"frames\[1\]: expected a direction for z, got zeros"),
    (moved(GOOD, 2, x=(0, 0, 0)), None, r"frames\[2\]: expected a direction for x, got zeros"),
    (moved(GOOD, 2, x=(np.nan, 0, 0)), None, "frames: expected finite numbers"),
    ("frames", None, "frames: expected 4 frames"), (None, None, "frames"),
    (GOOD, [0, 0], "q: expected shape"), (GOOD, np.zeros((2, 3)), "q: expected one pose"),
])
def test_bad_input_is_refused_by_name(frames, q, words):
    with pytest.raises(ValueError, match=words):
        kl.examine_frames(frames, BENT, q)


def test_only_arms_are_drawn():
    with pytest.raises(ValueError, match="arm: expected a kinlab Arm"):
        kl.examine_frames(GOOD, "BENT")


def test_fixed_rows_need_no_frames():
    arm = kl.Arm([kl.revolute(a=1), kl.fixed(a=0.5), kl.revolute(a=1), kl.fixed(d=0.2)])
    up, ahead = (0, 0, 1), (1, 0, 0)
    frames = [(up, ahead, (x, 0, 0)) for x in (0, 1.5, 2.5)]
    placed = kl.examine_frames(frames, arm, [0, 0])
    assert placed.ok and [link.a for link in placed.arm.links] == pytest.approx([1.5, 1])
    frames[1] = (up, ahead, (1.4, 0, 0))
    assert "0.1 m away from the axis of joint 2" in kl.examine_frames(frames, arm, [0, 0]).message


def test_a_table_of_frames_counts_along_their_axes():
    """The drawn arm's joint 2 counts the other way; the frames' own table does not."""
    arm = kl.Arm([kl.revolute(a=1), kl.revolute(a=1, flip=True)])
    frames = [((0, 0, 1), (1, 0, 0), (0, 0, 0)), ((0, 0, 1), (1, 0, 0), (1, 0, 0)),
              ((0, 0, 1), (0, -1, 0), (1, -1, 0))]
    placed = kl.examine_frames(frames, arm, [0, np.pi / 2])
    assert placed.ok and placed.arm.home == pytest.approx([0, -np.pi / 2])
    tip = kl.forward_kinematics(placed.arm, placed.arm.home)[:3, 3]
    assert tip == pytest.approx([1, -1, 0])
