"""Checks of exercises: right answers pass, slips are named, and nothing makes a check raise."""
from dataclasses import FrozenInstanceError

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from solved import ALSO, JUDGES, RIGHT, STUBS, WRONG

import kinlab as kl
from kinlab import lessons
from kinlab.exercises import Verdict

check = kl.exercises.check


def here(name, answer):
    """What a check says, found in this process: a copy of it takes ten times as long."""
    return kl.exercises.judged(lessons.judges(name.partition(".")[0])[name], answer)


t1 = sp.Symbol("theta_1")
TABLES = ("dh_recipe.2", "intelledex.1", "n_link.3")  # a place in them can be at fault


@pytest.mark.parametrize("name", JUDGES)
def test_the_solution_is_correct(name):
    verdict = check(name, RIGHT[name])
    assert verdict.ok and verdict.word == "Correct" and verdict.message


@pytest.mark.parametrize("name, answer, words", ALSO)
def test_another_right_answer_is_correct_too(name, answer, words):
    verdict = check(name, answer)
    assert verdict.ok and words in verdict.message, verdict


@pytest.mark.parametrize("name, answer, words", WRONG)
def test_a_wrong_answer_is_told_what_is_wrong(name, answer, words):
    verdict = here(name, answer)
    assert not verdict.ok and verdict.word == "Not yet"
    assert words in verdict.message
    assert verdict.fault is None or name in TABLES


@pytest.mark.parametrize("name, answer", STUBS)
def test_a_stub_is_not_attempted_yet(name, answer):
    verdict = check(name, answer)
    assert not verdict.ok and verdict.word == "Not attempted yet"


@pytest.mark.parametrize("name", JUDGES)
def test_each_exercise_has_wrong_answers_here(name):
    assert sum(name == wrong for wrong, *_ in WRONG) >= 3


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


@given(answer=garbage)
def test_no_answer_makes_a_check_raise(answer):
    for name in JUDGES:
        verdict = here(name, answer)
        assert isinstance(verdict, Verdict) and not verdict.ok, name
        assert verdict.message and verdict.word in repr(verdict), name


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
        said += [here(name, bomb), here(name, [bomb] * 3), here(name, lambda *_: bomb)]
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


def test_a_check_says_all_in_its_verdict(recwarn):
    """A word on degrees comes from the judge, and not from the judge's own use of the answer."""
    degrees = kl.Arm([kl.revolute(d=1), kl.revolute(a=1)], home=[3, 4])
    in_degrees = lambda alpha, a, d, theta: kl.forward_kinematics(  # noqa: E731
        kl.Arm([kl.revolute(alpha=alpha * 57.3, a=a, d=d)]), [theta * 57.3])
    for name, answer in (("n_link.1", in_degrees), ("n_link.3", degrees)):
        assert not here(name, answer).ok
    assert not recwarn.list


# ---- Nothing is changed --------------------------------------------------------------------------


def spoil(value):
    """Write into all that can be written into."""
    if isinstance(value, np.ndarray):
        value *= 0
    elif isinstance(value, list):
        value.clear()


def greedy(function):
    """The same function, which spoils its arguments once it has used them."""
    def changed(*arguments):
        result = function(*arguments)
        for argument in arguments:
            spoil(argument)
        return result
    return changed


FUNCTIONS = [name for name in JUDGES if callable(RIGHT[name])]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_may_do_with_its_arguments_what_it_likes(name):
    """It gets copies, so that its next answer is judged by the same cases."""
    for _ in range(3):
        assert here(name, greedy(RIGHT[name])).ok
        assert not here(name, greedy(lambda *_: 1.0)).ok
    assert here(name, RIGHT[name]).ok


def test_a_loop_that_adds_to_its_own_argument_is_right_and_told_so():
    def newton(q, target, steps):
        arm = kl.robots.two_link()
        for _ in range(steps):
            e = target - kl.forward_kinematics(arm, q)[:2, 3]
            q += np.linalg.solve(kl.jacobian(arm, q)[:2], e)
        return q

    for _ in range(5):
        verdict = here("inverse.1", newton)
        assert verdict.ok and verdict.message.endswith(
            "One remark: your function changes the q that it is given. Take a copy of it first, "
            "with np.array(...).")
    once = here("inverse.1", lambda q, target, steps: newton(q, target, 1))
    assert "Only one step is taken" in once.message


def test_a_function_may_hand_out_the_same_array_again_and_again():
    kept = np.eye(2)

    def rotation(theta):
        kept[:] = RIGHT["rotation.1"](theta)
        return kept

    assert here("rotation.1", rotation).ok


@pytest.mark.parametrize("name", [name for name in JUDGES if not callable(RIGHT[name])])
def test_an_answer_is_only_read(name):
    for answer in [RIGHT[name], *(answer for other, answer, _ in WRONG if other == name)]:
        if isinstance(answer, (list, dict, set, np.ndarray)):
            before = repr(answer)
            here(name, answer)
            assert repr(answer) == before


def test_a_function_that_keeps_something_is_told_so():
    calls = []

    def counting(theta):
        calls.append(theta)
        return RIGHT["rotation.1"](theta) + (len(calls) > 4)

    said = {check("rotation.1", counting).message for _ in range(3)}
    assert said == {"Called with the same numbers again, your function should give the same again. "
                    "For theta = 0: the entry in row 1, column 1 should be 1, got 2. Does it keep "
                    "something between two calls?"}
    assert calls == []  # what it keeps is gone after a check


@pytest.mark.parametrize("answer", [
    kl.rotation_2d, lambda t: kl.rotation_2d(t), lambda t: kl.rotation_z(t)[:2, :2],
    np.vectorize(kl.rotation_2d, signature="()->(2,2)"),
], ids=["itself", "lambda", "another", "in numpy"])
def test_kinlabs_own_function_is_no_answer_where_the_task_forbids_it(answer):
    verdict = check("rotation.1", answer)
    assert verdict.word == "Not yet" and "without kinlab" in verdict.message
    assert "calls kinlab's own `rotation_" in verdict.message


def test_a_print_is_no_help_from_kinlab(capsys):
    def told(theta):
        print("here", theta)
        return RIGHT["rotation.1"](theta)

    assert check("rotation.1", told).ok
    assert capsys.readouterr().out.startswith("here 0")
