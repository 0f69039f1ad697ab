"""What is kept of a student's work, in one kernel and over several."""
import re

import pytest

import kinlab as kl
from kinlab.marks import record
from kinlab.marks.record import Session, Work, together


@pytest.fixture
def work(monkeypatch):
    """An empty record of this kernel."""
    monkeypatch.setattr(record, "WORK", Work())
    return record.WORK


def test_a_check_is_a_try_until_it_is_right(work):
    kl.exercises.check("translation.3", ...)
    assert work == Work(), "who has not begun has not tried"
    kl.exercises.check("translation.3", [0, 0])
    kl.exercises.check("translation.3", [1, 2])
    kl.exercises.check("translation.3", [7, 7])
    assert work.tries == {"translation.3": 2}
    assert list(work.solved) == ["translation.3"]
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", work.solved["translation.3"])


def test_an_answer_that_never_comes_back_was_tried(work):
    def endless(theta):
        while True:
            pass

    kl.exercises.check("rotation.1", endless, seconds=0.2)
    assert work.tries == {"rotation.1": 1} and not work.solved


def test_the_first_answer_to_a_prediction_counts(work):
    prediction = kl.predict("start_here.ways")
    prediction.commit("one")
    prediction.ask()
    prediction.commit(prediction.cases[1].right)
    assert work.predicted == {"start_here.ways": {"0": False, "1": True}}
    again = kl.predict("start_here.ways")
    again.commit("two")
    assert work.predicted["start_here.ways"]["0"] is False


def test_an_answer_from_the_browser_is_kept_too(work):
    prediction = kl.predict("start_here.ways")
    prediction.record = [{"case": 0, "answer": "two"}]
    assert work.predicted == {"start_here.ways": {"0": True}}


def test_no_guess_is_no_right_answer(work):
    kl.predict("start_here.column").commit(None)
    assert work.predicted == {"start_here.column": {"0": False}}


def test_sessions_are_put_together_in_their_order():
    first = Work(tries={"a.1": 2, "a.2": 1}, predicted={"a.x": {"0": False}})
    second = Work(tries={"a.1": 1, "a.3": 1}, solved={"a.1": "2026-01-02T00:00:00Z"},
                  predicted={"a.x": {"0": True, "1": True}})
    third = Work(tries={"a.1": 1}, solved={"a.1": "2026-01-03T00:00:00Z"})
    whole = together([first, second, third])
    assert whole.tries == {"a.1": 3, "a.2": 1, "a.3": 1}, "tries after the solution do not count"
    assert whole.solved == {"a.1": "2026-01-02T00:00:00Z"}
    assert whole.predicted == {"a.x": {"0": False, "1": True}}, "the first answer counts"


@pytest.mark.parametrize("wrong", [
    {"tries": None}, {"tries": {"a.1": "2"}}, {"tries": {"a.1": True}}, {"solved": []},
    {"predicted": {"a.x": [True]}}, {"predicted": {"a.x": {"0": 1}}}])
def test_what_is_no_work_is_refused(wrong):
    right = {"tries": {"a.1": 2}, "solved": {}, "predicted": {"a.x": {"0": True}}}
    whole = {"began": "2026-01-01T00:00:00Z", "version": "0.1.0", "work": right}
    assert Session.of(whole).work == Work(**right)
    with pytest.raises(ValueError):
        Session.of(whole | {"work": right | wrong})


@pytest.mark.parametrize("wrong", [{"began": 1}, {"began": "now"}, {"version": None},
                                   {"version": "0\x1b[31m"}, {"work": []}])
def test_what_is_no_session_is_refused(wrong):
    whole = {"began": "2026-01-01T00:00:00Z", "version": "0.1.0",
             "work": {"tries": {}, "solved": {}, "predicted": {}}}
    with pytest.raises(ValueError):
        Session.of(whole | wrong)
    for other in (None, [], {}):
        with pytest.raises(ValueError):
            Session.of(other)
