"""Checks of exercises: right answers pass, slips are named, and nothing makes a check raise."""
from dataclasses import FrozenInstanceError
from math import pi

import numpy as np
import pytest
import sympy as sp
import textbook
from hypothesis import given
from hypothesis import strategies as st

import kinlab as kl
from kinlab.exercises import Verdict
from kinlab.lesson_checks import JUDGES

check = kl.exercises.check
t1, t2, t3 = sp.symbols("theta_1 theta_2 theta_3")
c1, s1, c2, s2 = sp.cos(t1), sp.sin(t1), sp.cos(t2), sp.sin(t2)
c23, s23 = sp.cos(t2 + t3), sp.sin(t2 + t3)
OUT, DROP = 177.8 * (c2 + c23), 177.8 * (s2 + s23)
BEND = np.arcsin(85.5 / 177.8)

RIGHT = {
    "alpha_ii.1": textbook.standard,
    "alpha_ii.2": [c1 * OUT, s1 * OUT, 85.5 - DROP],
    "alpha_ii.3": [{2, 3, 4}, {1, 2, 3, 4}, {1, 2, 3, 4, 5}],
    "alpha_ii.4": [0, 0, BEND, -BEND, 0],
}


def swapped(theta, d, a, alpha):
    return textbook.standard(theta, a, d, alpha)


def turned(function):
    return lambda theta, d, a, alpha: function(textbook.standard(theta, d, a, alpha))


def part_transposed(T):
    T = T.copy()
    T[:3, :3] = T[:3, :3].T
    return T


def bare_slides(theta, d, a, alpha):
    T = textbook.standard(theta, 0, 0, alpha)
    T[:3, 3] = a, 0, d
    return T


def crash(theta, d, a, alpha):
    return np.cos(theta) / None


# (exercise, answer, words of the message)
WRONG = [
    ("alpha_ii.1", textbook.modified, "reverse order"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(np.radians(t), d, a, np.radians(al)),
     "radians"),
    ("alpha_ii.1", turned(np.transpose), "the transpose"),
    ("alpha_ii.1", turned(part_transposed), "rotation is transposed"),
    ("alpha_ii.1", turned(np.linalg.inv), "inverse"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(t, d, a, -al), "sign of alpha"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(-t, d, a, al), "sign of theta"),
    ("alpha_ii.1", swapped, "changed places"),
    ("alpha_ii.1", bare_slides, "slide along x comes after"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(t, 0, a, al), "d along z is left out"),
    ("alpha_ii.1", lambda t, d, a, al: textbook.standard(t, d, 0, al), "a along x is left out"),
    ("alpha_ii.1", turned(lambda T: T[:3, :3]), "shape (4, 4), got (3, 3)"),
    ("alpha_ii.1", turned(lambda T: T + 0.01), "row 1, column 1 should be 1, got 1.01"),
    ("alpha_ii.1", turned(lambda T: T * np.nan), "finite"),
    ("alpha_ii.1", turned(str), "numbers of shape"),
    ("alpha_ii.1", lambda theta: theta, "raised TypeError"),
    ("alpha_ii.1", crash, "raised TypeError"),
    ("alpha_ii.1", np.eye(4), "Expected a function"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, 215 - DROP], "forgotten"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, 215 - DROP + 129.5], "lowers the tip"),
    ("alpha_ii.2", [c1 * (OUT + 129.5), s1 * (OUT + 129.5), 215 - DROP], "not to the reach"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, 85.5 + DROP], "subtracted"),
    ("alpha_ii.2", [c1 * 177.8 * (c2 + sp.cos(t3)), s1 * 177.8 * (c2 + sp.cos(t3)),
                    85.5 - 177.8 * (s2 + sp.sin(t3))], "theta_2 + theta_3"),
    ("alpha_ii.2", [f * 177.8 * (c2 + c2 * sp.cos(t3)) for f in (c1, s1)] + [85.5 - DROP],
     "product of two cosines"),
    ("alpha_ii.2", [s1 * OUT, c1 * OUT, 85.5 - DROP], "changed places"),
    ("alpha_ii.2", [part / 1000 for part in RIGHT["alpha_ii.2"]], "millimetres"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, sp.Symbol("theta_4")], "p_z holds theta_4"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, "215"], "leave out the quotes"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, sp.sqrt(t2 - 9)], "not a real number"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, ...], "p_z: this expression is still the stub"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT], "got 2"),
    ("alpha_ii.2", "c1 * out", "in a list"),
    ("alpha_ii.2", [c1 * OUT, s1 * OUT, 85.5 - DROP + 1], "p_z should be"),
    ("alpha_ii.3", [{1, 2, 3, 4}, {1, 2, 3, 4}, {1, 2, 3, 4, 5}], "not joint 1"),
    ("alpha_ii.3", [{2, 3, 4}, {1, 2, 3, 4, 5}, {1, 2, 3, 4, 5}], "approach vector lies along"),
    ("alpha_ii.3", [{2, 3, 4}, {1, 2, 3, 4}, {1, 2, 3, 4}], "one is missing"),
    ("alpha_ii.3", [{0, 1, 2}, {0}, {0}], "no joint 0"),
    ("alpha_ii.3", [2, 3, 4], "set of joint numbers"),
    ("alpha_ii.4", np.degrees(RIGHT["alpha_ii.4"]), "np.radians"),
    ("alpha_ii.4", [0, 0, BEND, BEND, 0], "sign of theta_4"),
    ("alpha_ii.4", [0, 0, BEND, pi - BEND, 0], "limits"),
    ("alpha_ii.4", [-3, 0, BEND, -BEND, 0], "Joint 1 is at -171.887°, 21.89° beyond"),
    ("alpha_ii.4", [0, 0, -BEND, BEND - pi + 1, 0], "away from straight down"),
    ("alpha_ii.4", [0, -BEND, pi / 2, pi / 2 + BEND, 0], "straight up"),
    ("alpha_ii.4", [0, np.arcsin(107.5 / 177.8), 0, -np.arcsin(107.5 / 177.8), 0], "the wrist"),
    ("alpha_ii.4", [0, 0, 0, 0, 0], "85.5 mm above the table"),
    ("alpha_ii.4", [0, 0, 0, 0], "expected shape (..., 5)"),
    ("alpha_ii.4", [[0, 0, 0, 0, 0]], "five joint values"),
    ("alpha_ii.4", "home", "plain numbers"),
]

STUBS = [("alpha_ii.1", ...), ("alpha_ii.1", None), ("alpha_ii.1", lambda theta, d, a, alpha: ...),
         ("alpha_ii.1", lambda theta, d, a, alpha: None), ("alpha_ii.2", [..., ..., ...]),
         ("alpha_ii.3", [..., ..., ...]), ("alpha_ii.3", ...), ("alpha_ii.4", ...)]


@pytest.mark.parametrize("name", JUDGES)
def test_the_solution_is_correct(name):
    verdict = check(name, RIGHT[name])
    assert verdict.ok and verdict.word == "Correct" and verdict.message


@pytest.mark.parametrize("name, answer, words", WRONG)
def test_a_wrong_answer_is_told_what_is_wrong(name, answer, words):
    verdict = check(name, answer)
    assert not verdict.ok and verdict.word == "Not yet"
    assert words in verdict.message


@pytest.mark.parametrize("name, answer", STUBS)
def test_a_stub_is_not_attempted_yet(name, answer):
    verdict = check(name, answer)
    assert not verdict.ok and verdict.word == "Not attempted yet"


@pytest.mark.parametrize("name", JUDGES)
def test_each_exercise_has_wrong_answers_here(name):
    assert sum(name == wrong for wrong, *_ in WRONG) >= 3


q1, q2, q3 = sp.symbols("theta_1 theta_2 theta_3", real=True)
d1, a2, a3, d5 = sp.symbols("d_1 a_2 a_3 d_5")


@pytest.mark.parametrize("answer", [
    tuple(RIGHT["alpha_ii.2"]),
    sp.Matrix(RIGHT["alpha_ii.2"]),
    np.array(RIGHT["alpha_ii.2"]),
    [sp.expand_trig(part) for part in RIGHT["alpha_ii.2"]],
    [part.subs({t1: q1, t2: q2, t3: q3}) for part in RIGHT["alpha_ii.2"]],
    [f * (a2 * c2 + a3 * c23) for f in (c1, s1)] + [d1 - a2 * s2 - a3 * s23 - d5],
], ids=["tuple", "matrix", "array", "expanded", "real symbols", "length symbols"])
def test_expressions_count_in_any_equivalent_form(answer):
    assert check("alpha_ii.2", answer).ok


@pytest.mark.parametrize("answer", [
    [(2, 3, 4), [4, 3, 2, 1], range(1, 6)],
    (np.array([2, 3, 4]), frozenset({1, 2, 3, 4}), {1: 0, 2: 0, 3: 0, 4: 0, 5: 0}),
])
def test_joint_numbers_come_in_any_collection(answer):
    assert check("alpha_ii.3", answer).ok


@given(st.floats(-1, 1), st.floats(-0.5, 0.5), st.floats(-3, 3), st.sampled_from([1, -1]))
def test_any_way_to_touch_the_table_is_correct(turn, shoulder, roll, elbow):
    forearm = np.arcsin(85.5 / 177.8 - np.sin(shoulder))
    forearm = forearm if elbow == 1 else pi - forearm
    q = [turn, shoulder, forearm - shoulder, -forearm, roll]
    limits = [link.limits for link in kl.robots.alpha_ii().links]
    inside = all(low <= value <= high for value, (low, high) in zip(q, limits))
    verdict = check("alpha_ii.4", q)
    assert verdict.ok == inside and (inside or "limits" in verdict.message)


def test_which_joints_change_what_is_true_of_the_arm():
    arm, poses = kl.robots.alpha_ii(), np.random.default_rng(1).uniform(-2, 2, (50, 5))
    entries = {"p_z": (2, 3), "a": (slice(3), 2), "n": (slice(3), 0)}
    for (name, entry), right in zip(entries.items(), RIGHT["alpha_ii.3"]):
        moves = {i + 1 for i in range(5)
                 if np.ptp([kl.forward_kinematics(arm, poses + step * np.eye(5)[i])[:, *entry]
                            for step in (0, 0.5)], axis=0).max() > 1e-9}
        assert moves == right, name


class Hostile:
    """Every question that is put to it raises."""

    def __getattribute__(self, name):
        raise RuntimeError(name)

    def __repr__(self):
        raise RuntimeError("repr")

    __len__ = __iter__ = __array__ = __call__ = __eq__ = __float__ = __bool__ = __repr__
    __hash__ = None


def leave(*arguments):
    raise SystemExit


class Mute(Exception):
    def __str__(self):
        raise RuntimeError("str")


def mutter(*arguments):
    raise Mute


scalars = (st.none() | st.just(...) | st.booleans() | st.integers() | st.floats() | st.text()
           | st.binary() | st.complex_numbers() | st.sampled_from(
               [leave, mutter, t1, sp.Symbol("x"), sp.zoo, sp.nan, sp.Function("f")(t1),
                sp.Eq(t1, 1), np.eye(4), np.array(["a"]), np.array(None), object, print, int])
           | st.builds(Hostile))
values = st.recursive(scalars, lambda inner: st.lists(inner, max_size=5)
                      | st.tuples(inner, inner, inner) | st.dictionaries(st.text(), inner))
garbage = values | st.functions(like=lambda t, d, a, al: ..., returns=values)


@pytest.mark.parametrize("name", JUDGES)
@given(answer=garbage)
def test_no_answer_makes_a_check_raise(name, answer):
    verdict = check(name, answer)
    assert isinstance(verdict, Verdict) and not verdict.ok
    assert verdict.message and verdict.word in repr(verdict)


@pytest.mark.parametrize("name", JUDGES)
@pytest.mark.parametrize("answer", [
    Hostile, lambda: [Hostile()] * 3, lambda: leave, lambda: mutter,
    lambda: lambda *_: Hostile(), lambda: [[Hostile()], [Hostile()], [Hostile()]],
], ids=["object", "list", "exit", "mute error", "result", "sets"])
def test_hostile_answers_are_refused(name, answer):
    assert check(name, answer()).word == "Not yet"


def test_text_is_never_evaluated():
    said = []
    bomb = "__import__('sys').modules['test_exercises_bomb'] = 1"
    for name in JUDGES:
        said += [check(name, bomb), check(name, [bomb] * 3), check(name, lambda *_: bomb)]
    assert not any(verdict.ok for verdict in said)
    import sys
    assert "test_exercises_bomb" not in sys.modules


def test_a_verdict_is_frozen_and_says_its_word_without_colour():
    verdict = check("alpha_ii.3", [{2, 3}, {1}, {1}])
    html = verdict._repr_html_()
    assert repr(verdict).startswith("✗ Not yet. ") and "<strong>✗ Not yet.</strong>" in html
    assert " color:" not in html  # the text keeps the theme's own colour
    with pytest.raises(FrozenInstanceError):
        verdict.word = "Correct"


def test_html_escapes_what_the_student_wrote():
    assert "<script>" not in check("alpha_ii.2", "<script>")._repr_html_()


def test_an_unknown_exercise_is_named():
    with pytest.raises(ValueError, match=r"name: expected 'alpha_ii.1' or .*, got 'alpha_ii.9'"):
        check("alpha_ii.9", 1)
