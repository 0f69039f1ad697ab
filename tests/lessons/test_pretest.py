"""The test before and after the course: twelve questions in two versions, and their result."""
import itertools

import numpy as np
import pytest
from predicted.pretest import PREDICTED

import kinlab as kl

TEST = kl.lessons.pretest
WORDS = [name.removeprefix("pretest.") for name in TEST.PREDICTIONS]
FIRST = [word for word in WORDS if not word.endswith("_again")]


def answered(version, wrong=()):
    """All questions of a version, answered rightly but for some."""
    asked = [kl.predict(f"pretest.{word}{version}") for word in FIRST]
    for word, prediction in zip(FIRST, asked):
        (held,) = PREDICTED[prediction.name]
        prediction.commit(held.wrong[0][0] if word in wrong else held.right)
    return asked


def test_twelve_questions_come_in_two_versions_of_one_kind():
    assert len(FIRST) == 12 and WORDS == [*FIRST, *(f"{word}_again" for word in FIRST)]
    for word in FIRST:
        (before,), (after,) = (TEST.PREDICTIONS[f"pretest.{word}{version}"].cases
                               for version in ("", "_again"))
        assert type(before) is type(after)
        assert before.ask != after.ask and before.data() != after.data()


def test_each_question_belongs_to_one_idea():
    assert sorted(itertools.chain(*TEST.IDEAS.values())) == sorted(FIRST)


@pytest.mark.parametrize("version", ["", "_again"])
def test_the_result_counts_what_is_right_idea_by_idea(version):
    result = TEST.result(*answered(version, wrong=("book", "side", "twist")))
    assert result.right == 9
    assert repr(result).splitlines() == [
        "9 of 12 right", "  3 of 3  frames (lessons 01 to 03)",
        "  1 of 3  order of motions (lessons 02, 03)", "  3 of 3  DH parameters (lesson 05)",
        "  1 of 2  signs (lessons 02, 05)", "  1 of 1  the other convention (lessons 05, 06)"]


def test_no_result_is_told_while_a_question_is_open():
    asked = [*answered("")[:-2], kl.predict("pretest.signs"), kl.predict("pretest.misread")]
    assert repr(TEST.result(*asked)) == "2 of 12 questions are still open."


def two_link(rows, convention, tool):
    make = [kl.revolute(a=a) for a in rows]
    slide = np.eye(4)
    slide[0, 3] = tool
    return kl.Arm(make, convention=convention, tool=slide)


@pytest.mark.parametrize("q", [(0.3, 1.1), (-1, 0.4)])
def test_what_the_misread_tables_do_is_true(q):
    """By the package: rows of a modified table, and of a standard one, read the other way."""
    joined = kl.forward_kinematics(two_link((0, 1), "standard", 1), q)
    assert np.allclose(joined[:2, 3], 2 * np.array([np.cos(sum(q)), np.sin(sum(q))]))
    beside = kl.forward_kinematics(two_link((1, 1), "modified", 0), q)
    assert np.allclose(beside[:2, 3], [1 + np.cos(q[0]), np.sin(q[0])])
