"""A table with a red cell is not judged, and never as the arm that it was before."""
from dataclasses import replace

import numpy as np
import pytest

import kinlab as kl
from kinlab.answers.table_judge import table

EXAM = kl.robots.exam_2018()
JUDGE = table(EXAM, praise="Well done.")
RED = "A cell is red; the table cannot be judged."


def red(row=2, column="d", text="0,,2"):
    editor = kl.DHTableEditor(replace(EXAM, name="mine"))
    editor.set(row, column, text)
    assert editor.table.errors
    return editor


@pytest.mark.parametrize("cell", [(2, "d", "-L"), (1, "theta", "90 grad"), (3, "low", "x"),
                                  ("tool", "z", "?")])
@pytest.mark.parametrize("hand", [lambda editor: editor, lambda editor: editor.arm,
                                  lambda editor: editor.table], ids=["editor", "arm", "table"])
def test_a_red_cell_is_said(cell, hand):
    answer = hand(red(*cell))
    for verdict in (JUDGE(answer), kl.same_mechanism(answer, EXAM),
                    kl.same_mechanism(answer, EXAM, strict=True)):
        assert verdict.word == "Not yet" and verdict.message.startswith(RED)


def test_the_reason_is_told_with_its_cell():
    assert "Row 2, d: '0,,2': expected a number" in kl.same_mechanism(red().arm, EXAM).message


def test_a_cell_that_is_mended_is_judged_again():
    editor = red()
    editor.set(2, "d", "0.3")
    assert "the offset d2 is 0.3; it should be 0.2" in kl.same_mechanism(editor.arm, EXAM).message
    editor.set(2, "d", "0.2")
    for answer in (editor, editor.arm, editor.table):
        assert kl.same_mechanism(answer, EXAM).ok and JUDGE(answer).ok


def test_the_earlier_arm_can_be_shown_and_computed_with():
    arm = red().arm
    assert np.allclose(kl.forward_kinematics(arm, EXAM.home),
                       kl.forward_kinematics(EXAM, EXAM.home))
    assert repr(arm) == repr(replace(EXAM, name="mine")) and kl.to_modified(arm).n == 3
