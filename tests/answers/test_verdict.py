"""Where a verdict says that the fault is, by row and column of the table as it was written."""
import ast
from dataclasses import replace
from math import pi, radians
from pathlib import Path

import mechanisms as m
import numpy as np
import pytest
import sympy as sp
from solved.dh_recipe import table as exam_table

import kinlab as kl
from kinlab.answers.verdict import CORRECT, NOT_YET, Fault, Verdict

RIGHT, R, P, row = pi / 2, kl.revolute, kl.prismatic, m.retyped
ALPHA_II, SIX_LINK, EXAM = (kl.robots.alpha_ii(), kl.robots.practical_six_link(),
                            kl.robots.exam_2018())
check = kl.exercises.check

SLIDES = kl.Arm([R(alpha=RIGHT), P(alpha=RIGHT), R(alpha=RIGHT)])
FAULTS = [
    (row(ALPHA_II, 2, a=170), ALPHA_II, Fault(2, "a")),
    (row(ALPHA_II, 3, a=-100), ALPHA_II, Fault(3, "a")),
    (row(ALPHA_II, 1, alpha=0), ALPHA_II, Fault(1, "alpha")),
    (row(ALPHA_II, 3, d=10), ALPHA_II, Fault(3, "d")),
    (row(SLIDES, 2, theta=1), SLIDES, Fault(2, "theta")),
    # A modified table holds a and alpha one row further down than the standard one.
    (row(SIX_LINK, 4, alpha=0), SIX_LINK, Fault(4, "alpha")),
    (row(SIX_LINK, 3, a=0.4), SIX_LINK, Fault(3, "a")),
    (row(SIX_LINK, 4, d=1.5), SIX_LINK, Fault(4, "d")),
    (row(kl.to_modified(ALPHA_II), 3, a=170), ALPHA_II, Fault(3, "a")),
    (row(kl.to_standard(SIX_LINK), 3, alpha=0), SIX_LINK, Fault(3, "alpha")),
    (kl.Arm([R(), R(), P()]), kl.robots.cylindrical(), Fault(2, "kind")),
    (kl.Arm([P(), P(), P()]), kl.robots.cylindrical(), Fault(1, "kind")),
]
STRICT = [
    (row(ALPHA_II, 3, theta=1), ALPHA_II, Fault(3, "theta")),
    (row(EXAM, 2, theta=0), EXAM, Fault(2, "theta")),
    (row(kl.robots.cylindrical(), 3, d=0.2), kl.robots.cylindrical(), Fault(3, "d")),
    (row(row(ALPHA_II, 2, theta=1), 4, theta=2), ALPHA_II, Fault(4, "theta")),
    (row(ALPHA_II, 5, d=100), ALPHA_II, Fault(5, "d")),
    (replace(ALPHA_II, tool=kl.translation([1, 0, 0])), ALPHA_II, Fault(5)),  # it, or the tool
    (row(SIX_LINK, 2, d=0.5), SIX_LINK, Fault(2, "d")),
    (row(kl.to_standard(SIX_LINK), 2, d=0.5), SIX_LINK, Fault(2, "d")),
    (row(ALPHA_II, 2, a=170), ALPHA_II, Fault(2, "a")),  # as without strict
]
# Nothing is wrong, or it is in no one place of the table.
NOWHERE = [
    (ALPHA_II, ALPHA_II, True),
    (kl.to_modified(ALPHA_II), ALPHA_II, True),
    (kl.Arm(ALPHA_II.links[:4]), ALPHA_II, False),
    (kl.Arm([*ALPHA_II.links, R()]), ALPHA_II, False),
    (replace(SIX_LINK, convention="standard"), SIX_LINK, False),
]


@pytest.mark.parametrize("answer, reference, fault", FAULTS)
def test_a_wrong_table_has_its_fault_in_a_cell(answer, reference, fault):
    verdict = kl.same_mechanism(answer, reference)
    assert (verdict.word, verdict.fault) == ("Not yet", fault), verdict


@pytest.mark.parametrize("answer, reference, fault", STRICT)
def test_a_table_that_does_not_stand_as_drawn_has_its_fault_in_a_cell(answer, reference, fault):
    verdict = kl.same_mechanism(answer, reference, strict=True)
    assert (verdict.word, verdict.fault) == ("Not yet", fault), verdict


def test_a_length_of_the_wrong_sign_is_in_the_row_where_the_answer_holds_it():
    """Turned round, a2 gives the same mechanism with other zeros of several joints."""
    drawn = kl.Arm([R(alpha=-RIGHT), R(theta=RIGHT, a=0.5, alpha=-RIGHT), R(theta=RIGHT)])
    modified = kl.Arm([R(), R(theta=RIGHT, alpha=-RIGHT), R(theta=RIGHT, a=-0.5, alpha=-RIGHT)],
                      convention="modified")
    for answer, held_in, name in ((row(drawn, 2, a=-0.5), 2, "a2"), (modified, 3, "a2 (in row 3)")):
        verdict = kl.same_mechanism(answer, drawn, strict=True)
        assert f"The length {name} should be 0.5: its sign is wrong." in verdict.message
        assert verdict.fault == Fault(held_in, "a")


def test_a_number_that_was_changed_is_found_again():
    """In tables of either convention, with any frames; now and then another one explains it too."""
    rng, places, found = np.random.default_rng(11), 0, 0
    for turn in range(300):
        arm = m.random_arm(rng, kinds=(R,))
        answer = m.reassigned(arm, rng)[0]
        answer = kl.to_modified(answer) if turn % 2 else answer
        index, column, change = m.random_change(rng, answer)
        verdict = kl.same_mechanism(m.changed(answer, index, column, change), arm, tip=False)
        if not verdict.ok:
            places += 1
            found += verdict.fault == Fault(index + 1, column)
    assert places > 50 and found > 0.9 * places, (places, found)


@pytest.mark.parametrize("answer, reference, ok", NOWHERE)
def test_there_is_no_fault_where_no_cell_is_wrong(answer, reference, ok):
    verdict = kl.same_mechanism(answer, reference)
    assert verdict.ok == ok and verdict.fault is None


MODIFIED = kl.to_modified(kl.robots.intelledex_660t())


def intelledex(number, **values):
    return row(kl.robots.intelledex_660t(), number, **values)


@pytest.mark.parametrize("name, answer, fault", [
    ("intelledex.1", intelledex(4, a=300), Fault(4, "a")),
    ("intelledex.1", intelledex(5, alpha=0), Fault(5, "alpha")),  # a slip, named alone
    ("intelledex.1", intelledex(6, d=200), Fault(6, "d")),  # the tip
    ("intelledex.1", intelledex(1, d=300), Fault(1, "d")),  # the floor
    ("intelledex.1", replace(MODIFIED, tool=kl.translation([50, 0, 0])), None),  # in no row
    ("n_link.3", row(SIX_LINK, 3, theta=radians(30)), Fault(3, "theta")),
    ("n_link.3", row(SIX_LINK, 2, d=0.5), Fault(2, "d")),
    ("n_link.3", kl.robots.two_link(), None),
    ("dh_recipe.2", exam_table(r2c3=0), Fault(2, "alpha")),
    ("dh_recipe.2", exam_table(r1c1=0), Fault(1, "d")),
    ("dh_recipe.2", exam_table(r3c1=0), Fault(3)),  # its joint variable is missing
    ("dh_recipe.2", exam_table(r2c0=sp.Symbol("theta_2")), Fault(2, "theta")),
    ("dh_recipe.2", exam_table(r3c1=sp.Symbol("d_3") + 0.2), Fault(3, "d")),
    ("n_link.3", "arm", None),
    ("n_link.3", ..., None),
])
def test_an_exercise_passes_the_fault_on(name, answer, fault):
    verdict = check(name, answer)
    assert not verdict.ok and verdict.fault == fault, verdict


def test_what_is_right_has_no_fault():
    assert check("n_link.3", SIX_LINK).fault is None


def test_two_verdicts_differ_by_their_fault_only_where_it_differs():
    here, there = (Verdict(NOT_YET, "Look.", Fault(1, column)) for column in ("a", "d"))
    assert here != there and here == Verdict(NOT_YET, "Look.", Fault(1, "a"))
    assert hash(here) == hash(Verdict(NOT_YET, "Look.", Fault(1, "a")))
    assert Verdict(CORRECT, "Good.").fault is None and repr(here) == "✗ Not yet. Look."


# ---- Messages are for people ---------------------------------------------------------------------

PACKAGE = Path(kl.__file__).parent
DECIDING = sorted([PACKAGE / "exercises.py", *(
    path for room in ("answers", "lessons", "tables") for path in (PACKAGE / room).glob("*.py"))])


def is_message(node, caught):
    """Whether a node is somebody's `.message`, or the text of an error that was caught."""
    if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "str":
        return getattr(node.args[0], "id", "") in caught
    return isinstance(node, ast.Attribute) and node.attr == "message"


def read_as_code(source):
    """Lines that ask how a message is worded: methods of its text, comparisons with it."""
    nodes = list(ast.walk(ast.parse(source)))
    caught = {node.name for node in nodes if isinstance(node, ast.ExceptHandler) and node.name}
    asked = [(node.value, node) for node in nodes if isinstance(node, ast.Attribute)]
    asked += [(side, node) for node in nodes if isinstance(node, ast.Compare)
              for side in (node.left, *node.comparators)]
    return [node.lineno for text, node in asked if is_message(text, caught)]


@pytest.mark.parametrize("path", DECIDING, ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_nothing_is_decided_by_the_wording_of_a_message(path):
    assert not read_as_code(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize("source", [
    "if verdict.message.startswith('Joint 7'): pass", "found = 'tool' in verdict.message",
    "try: pass\nexcept ValueError as error: text = str(error).removeprefix('names: ')",
    "try: pass\nexcept ValueError as error: same = str(error) == 'no'",
])
def test_such_a_decision_would_be_seen(source):
    assert read_as_code(source)
