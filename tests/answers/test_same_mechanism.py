"""The examiner: right tables are accepted, wrong ones refused by name.

KINLAB_EXAMINER sets how many random arms each property is tried on.
"""
import os
from dataclasses import replace
from itertools import product
from math import pi, radians

import mechanisms as m
import numpy as np
import pytest

import kinlab as kl
from kinlab.arms import robots

COUNT = int(os.environ.get("KINLAB_EXAMINER", 400))
ARMS = [getattr(robots, name) for name in ("two_link", "practical_six_link", "cylindrical",
                                           "exam_2018", "alpha_ii", "intelledex_660t")]
RIGHT = pi / 2
R, P, row = kl.revolute, kl.prismatic, m.retyped
STANFORD = kl.Arm([R(alpha=-RIGHT), R(d=0.15, alpha=RIGHT), P(), R(alpha=-RIGHT), R(alpha=RIGHT),
                   R(d=0.25)], name="Stanford arm")
STANFORD_MODIFIED = kl.Arm([R(), R(alpha=-RIGHT, d=0.15), P(alpha=RIGHT), R(), R(alpha=-RIGHT),
                            R(alpha=RIGHT)], convention="modified")


def refused(answer, reference, *words, **options):
    verdict = kl.same_mechanism(answer, reference, **options)
    assert not verdict.ok and len(verdict.message.splitlines()) == 1
    for word in words:
        assert word in verdict.message
    return verdict.message


def accepted(answer, reference, *words, **options):
    verdict = kl.same_mechanism(answer, reference, **options)
    assert verdict.ok, verdict.message
    for word in words:
        assert word in verdict.message


# ---- Known pairs ---------------------------------------------------------------------------------


@pytest.mark.parametrize("make", ARMS)
@pytest.mark.parametrize("strict", [False, True])
def test_an_arm_is_itself_in_both_conventions(make, strict):
    accepted(make(), make(), "with the same frames", strict=strict)
    for convert in (kl.to_modified, kl.to_standard):
        accepted(convert(make()), make(), strict=strict)
        accepted(make(), convert(make()), strict=strict)


def test_every_two_arms_of_the_course_differ():
    for one, other in product(ARMS, ARMS):
        assert kl.same_mechanism(one(), other()).ok == (one is other)


def test_the_cylindrical_arm_of_the_lecture_and_of_textbooks():
    textbook = kl.Arm([R(d=0.4), P(alpha=-RIGHT), P()])
    accepted(textbook, robots.cylindrical())
    accepted(robots.cylindrical(), textbook)


def test_the_stanford_arm_in_both_conventions():
    accepted(STANFORD_MODIFIED, STANFORD, "modified DH instead of standard", "another tool frame",
             tip=False)
    refused(STANFORD_MODIFIED, STANFORD, "Joint 6: the offset d6 is 0; it should be 0.25.")
    refused(row(STANFORD_MODIFIED, 2, d=0.16), STANFORD, "Joint 2: the offset d2 is 0.16",
            "should be 0.15")
    refused(row(STANFORD_MODIFIED, 3, theta=RIGHT, alpha=0), STANFORD, "Joint 3",
            "alpha2 (in row 3)")


def test_the_six_link_in_the_wrong_convention():
    arm = robots.practical_six_link()
    refused(replace(arm, convention="standard"), arm, "fit the modified convention",
            "read as standard")


# ---- What the messages say -----------------------------------------------------------------------

ALPHA_II, SIX_LINK, EXAM = robots.alpha_ii(), robots.practical_six_link(), robots.exam_2018()
SLIPS = [
    (row(ALPHA_II, 2, a=170), ALPHA_II, "Joint 2: the length a2 is 170; it should be 177.8."),
    (row(ALPHA_II, 1, alpha=0), ALPHA_II,
     "Joint 1: the twist alpha1 is 0°; from z0 to z1 it should be 90° or -90°."),
    (row(ALPHA_II, 1, alpha=-90), ALPHA_II, "Angles are in radians: write radians(90) for 90°."),
    (row(ALPHA_II, 1, alpha=1.57), ALPHA_II, "It looks rounded: write pi/2 rather than 1.57."),
    (row(ALPHA_II, 3, d=10), ALPHA_II, "Joint 3: the offset d3 is 10; it should be 0. These "
     "axes are parallel: d2, d3, d4 count only together."),
    (row(SIX_LINK, 4, alpha=0), SIX_LINK, "Joint 4: the twist alpha3 (in row 4) is 0°; from z3 to "
     "z4 it should be 90° or -90°."),
    (row(EXAM, 2, alpha=radians(60)), EXAM, "Joint 2: the twist alpha2 is 60°"),
    (kl.Arm([*EXAM.links[:1], R(), *EXAM.links[2:]]), EXAM, "alpha2"),
    (kl.Arm([R(), R(), P()]), robots.cylindrical(), "Joint 2 is prismatic on the arm and revolute "
     "in your table: its variable is d2, so d2 varies and theta2 is constant."),
    (kl.Arm(ALPHA_II.links[:4]), ALPHA_II, "Your table has 4 joints, the arm has 5. One row "
     "belongs to each joint."),
    (kl.Arm([*ALPHA_II.links, R()]), ALPHA_II, "put a fixed first row into the base, a fixed last "
     "row into the tool"),
    (kl.Arm([R(alpha=RIGHT), P(alpha=RIGHT, theta=1), R(alpha=RIGHT)]),
     kl.Arm([R(alpha=RIGHT), P(alpha=RIGHT), R(alpha=RIGHT)]), "Joint 2: the angle theta2 is "
     "57.2958°; it should be 0°. A prismatic joint does not turn, so q cannot make up for this"),
]


@pytest.mark.parametrize("answer, reference, words", SLIPS)
def test_a_slip_is_named_with_what_to_do(answer, reference, words):
    refused(answer, reference, words)


def test_a_twist_that_turns_the_wrong_way_for_its_length():
    arm = kl.Arm([R(a=1, alpha=radians(60)), R(d=0.5, a=0.3, alpha=RIGHT), R()])
    refused(row(arm, 1, alpha=radians(-60)), arm,
            "Joint 1: the twist alpha1 is -60°; from z0 to z1 it should be 60°.")
    accepted(row(arm, 1, alpha=radians(-60), a=-1), arm, "x1 points the other way")


def test_what_was_chosen_differently():
    arm = kl.Arm([R(alpha=radians(30)), R(d=1, a=1, alpha=radians(30)), R(a=2, alpha=radians(40)),
                  R(d=1)])
    flipped = kl.Arm([R(alpha=radians(30)), R(d=1, a=1, alpha=radians(-150)),
                      R(a=2, alpha=radians(-140)), R(d=1)])
    accepted(flipped, arm, "z2 points the other way: your q3 turns backwards")
    turned = row(row(robots.intelledex_660t(), 2, alpha=-RIGHT), 5, alpha=-RIGHT)
    accepted(turned, robots.intelledex_660t(), "Chosen differently: z2 points the other way: your "
             "q3 turns backwards; z3 points the other way: your q4 turns backwards; z4 points the "
             "other way: your q5 turns backwards.")
    accepted(row(arm, 2, theta=RIGHT), arm, "q2 counts from a zero 90° away")
    accepted(row(arm, 1, d=1), arm, "another base frame")
    accepted(row(arm, 4, d=3), arm, "another tool frame", tip=False)
    accepted(row(arm, 4, alpha=1), arm, "another tool frame")
    accepted(row(row(ALPHA_II, 2, d=5), 4, d=-5), ALPHA_II, "the origin on z1 slid along it")
    accepted(row(ALPHA_II, 3, theta=1), ALPHA_II, "where some q count from")


# ---- The zero position and the tool --------------------------------------------------------------


def test_the_strict_mode_asks_for_the_zero_position():
    arm = row(ALPHA_II, 2, theta=-RIGHT)
    accepted(ALPHA_II, arm)
    for number in (2, 3, 4, 5):
        refused(row(arm, number, theta=1), arm, f"Joint {number}: theta{number} should hold the "
                f"offset {-90 if number == 2 else 0}°.", strict=True)
    refused(row(EXAM, 2, theta=0), EXAM, "theta2 should hold the offset 90°", strict=True)
    slid = row(robots.cylindrical(), 3, d=0.2)
    refused(slid, robots.cylindrical(), "Joint 3: d3 should hold the offset 0.", strict=True)


def test_the_strict_mode_asks_for_the_tool():
    for other in (row(ALPHA_II, 5, d=100), row(ALPHA_II, 5, a=1), row(ALPHA_II, 5, alpha=1),
                  replace(ALPHA_II, tool=kl.translation([1, 0, 0]))):
        accepted(other, ALPHA_II, "another tool frame", tip=False)
        refused(other, ALPHA_II, "the tool frame sits elsewhere on the last link", strict=True)


def test_the_strict_mode_names_a_length_whose_sign_is_wrong():
    """Without it the mechanism is the same, but only with other zeros of several joints."""
    wrong = row(SIX_LINK, 2, d=0.5)
    accepted(wrong, SIX_LINK)
    refused(wrong, SIX_LINK, "The offset d2 should be -0.5: its sign is wrong.", strict=True)


def test_the_strict_mode_names_offsets_one_after_the_other():
    wrong = row(row(ALPHA_II, 2, theta=1), 4, theta=2)
    message = refused(wrong, ALPHA_II, "Joint 4: theta4 should hold the offset 0°.", strict=True)
    refused(row(wrong, 4, theta=0), ALPHA_II, "Joint 2: theta2 should hold the offset 0°.",
            strict=True)
    assert "theta2" not in message


def test_the_strict_mode_leaves_base_and_signs_free():
    accepted(replace(ALPHA_II, base=kl.translation([1, 2, 3])), ALPHA_II, strict=True)
    flipped = row(row(row(STANFORD, 1, alpha=RIGHT), 2, alpha=-RIGHT, d=-0.15), 3, d=0)
    accepted(flipped, STANFORD, "z1 points the other way: your q2 turns backwards", strict=True)


def test_strict_random_arms_with_the_zero_kept():
    rng = np.random.default_rng(8)
    for _ in range(COUNT // 7):
        arm = m.random_arm(rng)
        new, q0, signs = m.reassigned(arm, rng)
        zeroed = [replace(link, **{link.variable: getattr(link, link.variable) - s * q})
                  for link, s, q in zip(new.links, signs, q0)]
        accepted(replace(new, links=zeroed), arm, strict=True)


# ---- Random arms ---------------------------------------------------------------------------------


def test_every_valid_assignment_is_accepted():
    rng = np.random.default_rng(1)
    for _ in range(COUNT):
        arm = m.random_arm(rng)
        new, q0, signs = m.reassigned(arm, rng)
        q = rng.uniform(-3, 3, (3, arm.n))
        assert np.allclose(kl.forward_kinematics(new, signs * (q - q0)),
                           kl.forward_kinematics(arm, q), atol=1e-7)  # it is valid indeed
        accepted(kl.to_modified(new) if rng.random() < 0.5 else new, arm)


def test_every_change_that_alters_the_mechanism_is_refused_by_name():
    rng = np.random.default_rng(2)
    altered, named, works = 0, 0, 0
    for turn in range(COUNT):
        arm = m.random_arm(rng)
        answer = arm if turn % 2 else m.reassigned(arm, rng)[0]
        answer = kl.to_modified(answer) if turn % 4 == 0 else answer
        index, parameter, change = m.random_change(rng, answer)
        wrong = m.changed(answer, index, parameter, change)
        verdict = kl.same_mechanism(wrong, arm, tip=False)
        alters = m.alters(answer, index, parameter, change, rng)
        assert alters is None or verdict.ok != alters, (turn, verdict)
        if not verdict.ok:
            altered += 1
            right = verdict.message.startswith(f"Joint {index + 1}:")
            named += right
            works += not right and m.repair_works(wrong, arm, verdict.message)
    print(f"{COUNT} changes, {altered} alter the mechanism and are refused; {named} name the row "
          f"that was changed, {works} another one whose change also mends it")
    assert altered > COUNT / 6 and named >= 0.95 * altered


@pytest.mark.parametrize("seed", range(4))
def test_a_search_for_base_tool_and_offsets_agrees(seed):
    """Big changes (other signs, right angles) against a search that knows poses only."""
    rng = np.random.default_rng(seed)
    arm = m.random_arm(rng, n=2 + (seed == 3))
    index, parameter = int(rng.integers(arm.n)), str(rng.choice(["d", "a", "alpha"]))
    answer = m.changed(m.reassigned(arm, rng)[0], index, parameter, pi / 2)
    found = any(m.fits(answer, arm, np.array(signs), rng, starts=3, steps=20)
                for signs in product([1, -1], repeat=arm.n))
    assert kl.same_mechanism(answer, arm, tip=False).ok == found


@pytest.mark.parametrize("n", [8, 10, 12, 16])
def test_long_arms(n):
    rng = np.random.default_rng(n)
    for kinds in ((R,), (R, P), (P,)):
        arm = m.random_arm(rng, n=n, kinds=kinds)
        accepted(m.reassigned(arm, rng)[0], arm)
    snake = kl.Arm([R(d=0.1 * (i % 2), alpha=RIGHT * (-1) ** i) for i in range(n)])
    accepted(m.reassigned(snake, rng)[0], snake)
    refused(row(snake, n // 2 * 2 - 2, d=0.2), snake, f"Joint {n // 2 * 2 - 2}: the offset")


# ---- Tolerance, bad input ------------------------------------------------------------------------


@pytest.mark.parametrize("scale", [1e-3, 1, 1e6])
def test_the_tolerance_is_relative(scale):
    def arm(factor=1, turn=0.0):
        return kl.Arm([R(a=scale, alpha=RIGHT + turn),
                       R(d=2 * scale * factor, a=3 * scale, alpha=1), R(d=scale, alpha=0.5), R()])
    for factor in (1 + 1e-6, 1 - 1e-6, 1 + 1e-5):
        refused(arm(factor), arm(), "Joint 2: the offset d2")
    for turn in (1e-6, -1e-6):
        refused(arm(1, turn), arm(), "Joint 1: the twist alpha1")
    accepted(arm(1 + 1e-7, 1.570796 - RIGHT), arm())


@pytest.mark.parametrize("name", ["answer", "reference"])
def test_only_arms_are_judged(name):
    arms = {"answer": ALPHA_II, "reference": ALPHA_II, name: "Alpha II"}
    with pytest.raises(ValueError, match="arm: expected a kinlab Arm, got 'Alpha II'"):
        kl.same_mechanism(**arms)


def test_an_angle_counts_where_the_frame_of_a_slide_stands_aside():
    """Joints 1 to 3 share a line, so theta2 is free there; in a frame 0.9 aside it moves axis 3."""
    reference = kl.Arm([R(), P(), R(alpha=RIGHT), R(a=1)])
    aside = kl.Arm([R(a=0.9), P(a=0.9, theta=pi), R(alpha=RIGHT), R(a=1)])
    assert kl.same_mechanism(aside, reference).ok
    verdict = kl.same_mechanism(row(aside, 2, theta=pi + 1e-4), reference)
    assert (verdict.ok, verdict.fault.row, verdict.fault.column) == (False, 2, "theta")
    assert verdict.fault.expected == pytest.approx(pi)


# ---- The tip -------------------------------------------------------------------------------------


def tip_of(arm, q=None):
    return kl.forward_kinematics(arm, arm.home if q is None else q)[:3, 3]


@pytest.mark.parametrize("typed, far", [(0, 0.2), (-0.2, 0.4), (0.3, 0.1)])
@pytest.mark.parametrize("convert", [lambda arm: arm, kl.to_modified])
def test_a_link_offset_before_a_slide_moves_the_tip(typed, far, convert):
    """The axes are alike: a slide has no place. With q = (0, 0, 0.4) the tip tells."""
    wrong = row(EXAM, 2, d=typed)
    assert np.linalg.norm(tip_of(wrong, [0, 0, 0.4]) - [0.4, -0.2, 0.9]) == pytest.approx(far)
    sign = ": its sign is wrong" if typed < 0 else ""
    verdict = kl.same_mechanism(convert(wrong), EXAM)
    assert repr(verdict) == (
        f"✗ Not yet. Joint 2: the offset d2 is {typed:g}; it should be 0.2{sign}. The joint axes "
        f"are alike, but the tip is {far:g} m away from where it should be.")
    assert (verdict.fault.row, verdict.fault.column, verdict.fault.expected) == (2, "d", 0.2)


@pytest.mark.parametrize("arm, number, typed, far", [
    (ALPHA_II, 5, {"d": 0}, "129.5 mm"), (ALPHA_II, 5, {"d": 100}, "29.5 mm"),
    (robots.intelledex_660t(), 6, {"d": 200}, "28.6 mm"), (robots.two_link(), 2, {"a": 0.5}, None)])
def test_a_tool_of_another_length_is_not_correct(arm, number, typed, far):
    message = refused(row(arm, number, **typed), arm)
    assert far is None or (f"Joint {number}: " in message and f"the tip is {far} away" in message)


def test_a_tool_that_is_elsewhere_is_not_correct():
    aside = replace(ALPHA_II, tool=kl.translation([3, 4, 0]))
    assert refused(aside, ALPHA_II) == (
        "The arm is right, but its tip is not: check the tool. The joint axes are alike, but the "
        "tip is 5 mm away from where it should be.")
    turned = replace(ALPHA_II, tool=kl.homogeneous(kl.rotation_z(1.0), [0, 0, 0]))
    accepted(turned, ALPHA_II, "another tool frame")


def test_where_a_slide_counts_from_and_where_its_frame_sits_stays_free():
    arm = robots.cylindrical()
    accepted(row(arm, 3, d=0.2), arm)
    accepted(row(row(EXAM, 2, a=0), 3, theta=0, a=0.4), EXAM)  # the slide's frame sits at d2


def test_a_slide_that_runs_backwards_is_a_choice_that_angles_show():
    """With z2 of the exam's arm turned round, row 2 turns the other way about x2."""
    own = row(row(EXAM, 2, alpha=-RIGHT), 3, theta=RIGHT)
    q = np.array([0.3, -0.4, 0.5])
    assert np.allclose(tip_of(own, q * [1, 1, -1]), tip_of(EXAM, q))
    accepted(own, EXAM, "your q3 slides backwards")
