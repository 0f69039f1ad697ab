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
                  seeds={"a.1": ["7"]}, predicted={"a.x": {"0": True, "1": True}})
    third = Work(tries={"a.1": 1}, solved={"a.1": "2026-01-03T00:00:00Z"},
                 seeds={"a.1": ["7", "8"]})
    whole = together([first, second, third])
    assert whole.tries == {"a.1": 3, "a.2": 1, "a.3": 1}, "tries after the solution do not count"
    assert whole.solved == {"a.1": "2026-01-02T00:00:00Z"}
    assert whole.seeds == {"a.1": ["7", "8"]}
    assert whole.predicted == {"a.x": {"0": False, "1": True}}, "the first answer counts"


@pytest.mark.parametrize("wrong", [
    None, [], {"began": "x"}, {"began": 1, "version": "0", "work": {}},
    {"began": "x", "version": "0", "work": {"tries": {}, "solved": {}, "seeds": {}}},
    {"began": "x", "version": "0", "work": {"tries": {"a.1": "2"}, "solved": {}, "seeds": {},
                                            "predicted": {}}},
    {"began": "x", "version": "0", "work": {"tries": {"a.1": True}, "solved": {}, "seeds": {},
                                            "predicted": {}}},
    {"began": "x", "version": "0", "work": {"tries": {}, "solved": {}, "seeds": {"a.1": [3]},
                                            "predicted": {}}},
    {"began": "x", "version": "0", "work": {"tries": {}, "solved": {}, "seeds": {},
                                            "predicted": {"a.x": [True]}}}])
def test_what_is_no_session_is_refused(wrong):
    with pytest.raises(ValueError):
        Session.of(wrong)
