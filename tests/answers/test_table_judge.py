"""Tables that lessons ask for: right in any frames, and wrong where an end is out of place."""
import re
from dataclasses import replace
from math import pi

import mechanisms as m
import numpy as np
import pytest

import kinlab as kl
from kinlab.answers.table_judge import table
from kinlab.lessons.dh_recipe import stands_as

ARMS = [kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]


@pytest.mark.parametrize("make", ARMS)
def test_any_frames_are_right_and_both_ends_count(make):
    rng = np.random.default_rng(3)
    arm = make()
    judge = table(arm, ends=True, praise="Well done.")
    step = 0.3 if arm.unit == "m" else 100
    for turn in range(40):
        new, *_ = m.reassigned(arm, rng)
        answer = kl.to_modified(new) if turn % 2 else new
        assert said(judge(answer), "Correct").endswith("Well done.")
        aside = step * across(new.links[-1], kl.inverse(new.tool), rng)
        wrong = judge(replace(answer, tool=answer.tool @ kl.translation(aside)))
        assert re.search(f"^Joint [{arm.n - 1}{arm.n}]: |check the tool", said(wrong, "Not yet"))
        wrong = judge(replace(new, base=kl.translation(step * new.base[:3, 2]) @ new.base))
        assert re.search(r"^Joint 1: the offset d1 is .* frame 0 on the floor",
                         said(wrong, "Not yet"))


def said(verdict, word):
    assert verdict.word == word
    return verdict.message


def across(last, T, rng):
    """A direction in which a tip counts, in the tool's axes: not along a slide."""
    z = (T @ kl.inverse(kl.forward_kinematics(kl.Arm([last]), [0])))[:3, 2]
    v = np.cross(z, m.random_direction(rng))
    return v / np.linalg.norm(v) if last.kind == "prismatic" else z


def test_the_exam_arm_has_to_stand_as_drawn_whatever_frames_were_chosen():
    arm, rng = kl.robots.exam_2018(), np.random.default_rng(4)
    for _ in range(20):
        new, q0, signs = m.reassigned(arm, rng)
        links = [replace(link, flip=bool(link.kind == "prismatic" and s < 0),
                         **{link.variable: getattr(link, link.variable) - s * q})
                 for link, s, q in zip(new.links, signs, q0)]
        assert stands_as(replace(new, links=links), arm)
        for i, name in ((1, "theta"), (2, "d")):
            off = replace(links[i], **{name: getattr(links[i], name) + pi / 2})
            assert not stands_as(replace(new, links=[*links[:i], off, *links[i + 1:]]), arm)
