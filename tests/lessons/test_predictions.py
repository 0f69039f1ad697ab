"""Every prediction of the course: its right answers against computation, wrong ones with words."""
import math
from importlib import import_module

import pytest

import kinlab as kl
from kinlab import lessons
from kinlab.answers.prediction import Choice, Direction, Mark, Number, Several, Signs

ALL = [(lesson, name) for lesson in lessons.names() for name in lessons.predictions(lesson)]
NAMES = [name for _, name in ALL]


def held(lesson, name):
    """What the cases of a prediction are held against."""
    return import_module(f"predicted.{lesson}").PREDICTED[name]


@pytest.fixture(scope="module")
def made():
    """Predictions by name, each made once."""
    cache = {}

    def make(name):
        if name not in cache:
            cache[name] = kl.predict(name)
        return cache[name]
    return make


@pytest.mark.parametrize(("lesson", "name"), ALL, ids=NAMES)
def test_each_right_answer_is_right_and_each_wrong_one_gets_a_word(lesson, name, made):
    prediction, against = made(name), held(lesson, name)
    assert len(against) == len(prediction.cases), "every case is held"
    for k, (case, fixed) in enumerate(zip(prediction.cases, against)):
        told = case.told(case.read(fixed.right), prediction.truth(k))
        assert told.ok, f"case {k}: {told.said}"
        close(case, fixed.right, prediction.truth(k))
        assert len(fixed.wrong) >= 2, f"case {k} has two wrong answers"
        for answer, words in fixed.wrong:
            told = case.told(case.read(answer), prediction.truth(k))
            assert not told.ok, f"case {k}: {answer} is not right"
            assert words in told.said


def close(case, right, truth):
    """The case is as exact as what it is held against, not only within its tolerance."""
    near = {"rel": 1e-6, "abs": 1e-6 + 0.02 * getattr(case, "tolerance", 0)}
    if isinstance(case, Mark):
        assert truth == pytest.approx(right, **near)
    if isinstance(case, Number):
        off = case.right - right
        assert off - case.turn * round(off / (case.turn or 1)) == pytest.approx(0, **near)
    if isinstance(case, Direction):
        assert math.sin(math.radians(truth - right) / 2) == pytest.approx(0, abs=1e-4)


@pytest.mark.parametrize(("lesson", "name"), ALL, ids=NAMES)
def test_each_question_can_be_asked(lesson, name, made):
    prediction = made(name)
    for k, case in enumerate(prediction.cases):
        for text in (case.ask, case.why):
            assert text and text == text.strip() and "$" not in text
            assert text.endswith((".", "?", "!", ")")), text
        assert len(case.ask) < 330 and len(case.why) < 330
        for knob, value in [*case.start.items(), *case.shows.items()]:
            low, high = prediction.knob(knob).ends
            assert low <= value <= high, f"{knob} cannot be at {value}"
        assert not case.seen or case.seen in prediction.scene["presets"]
        if isinstance(case, Choice | Several):
            taken = case.right if isinstance(case, Several) else [case.right]
            assert set(taken) <= set(case.options) and len(case.options) > 1
        if isinstance(case, Signs):
            assert case.read(list(case.right)) == list(case.right)
            assert len({case.right[0][0], *"".join(case.right)}) > 1, "not all the same"
        if isinstance(case, Mark):
            assert moves(prediction, k), "the mark does not wait at the right place"
        if isinstance(case, Direction):
            q = prediction._at(case.start, case.shows)
            assert abs(prediction._guess.slant(case.of, case.about, q)) < 1, "turns in its plane"
            off = prediction.truth(k) - case.begin
            assert abs(off - 360 * round(off / 360)) > case.tolerance, "waits elsewhere"


def moves(prediction, k):
    """Whether a mark that stays where it waits is wrong."""
    waiting = prediction._started(k)[prediction._own:][:3]
    return not prediction.cases[k].told(waiting, prediction.truth(k)).ok
