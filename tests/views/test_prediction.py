"""A prediction in Python: answered once, kept, refused with a sentence, shown as a text."""
import numpy as np
import pytest

import kinlab as kl
from kinlab.answers.prediction import Asked, Choice, Direction, Mark, Number, Several, Signs
from kinlab.views.prediction import Prediction

FLAT = {"theta_1": 0, "theta_2": 0}
MARKS = Asked(lambda: kl.ArmView(kl.robots.two_link()), [
    Mark(ask="Where will the tip be?", why="The arm is stretched.", tolerance=0.1, start=FLAT,
         shows={"theta_1": turn}) for turn in (90, 180)])
ARROW = Asked(MARKS.view, [Direction(ask="Which way?", why="Angles add up.", of="frame-2-x",
                                     start=FLAT, shows={"theta_1": 30, "theta_2": 60})])
NUMBER = Asked(None, [Number(ask="How far?", why="So.", right=2, tolerance=0.1, unit="m")])
CHOICE = Asked(None, [Choice(ask="Which?", why="So.", options={"a": "", "b": "No."}, right="a")])
SEVERAL = Asked(None, [Several(ask="Which?", why="So.", options={"a": "", "b": "No."},
                               right=["a"])])
SIGNS = Asked(None, [Signs(ask="Which?", why="So.", rows="xy", columns="xy", right=("+0", "0+"),
                           among={"+": "grows", "0": "stays"})])


def made(asked, view=None):
    return Prediction("trial.one", asked, view)


def test_a_mark_is_measured_from_where_the_arm_comes_to():
    prediction = made(MARKS)
    assert prediction.truth(0) == pytest.approx([0, 2, 0])
    np.testing.assert_allclose(prediction.q, [0, 0])
    prediction.commit([0, 1.5, 0])
    assert prediction.told == (False, "Your mark is 0.5 m away. It is at x, y = 0, 2 m.")
    np.testing.assert_allclose(np.degrees(prediction.q), [90, 0], atol=1e-9)
    prediction.theta_1 = 20             # a live view from then on
    assert prediction.told.said.startswith("Your mark is 0.5 m away.")


def test_an_answer_is_not_changed_and_another_case_is_asked_once():
    prediction = made(MARKS)
    prediction.commit([0, 2, 0])
    with pytest.raises(ValueError, match="has been committed and stays as it is"):
        prediction.commit([1, 1, 0])
    prediction.ask()
    assert (prediction.case, prediction.committed) == (1, False)
    np.testing.assert_allclose(prediction.q, [0, 0])
    prediction.commit()
    assert prediction.told == (False, "No guess. It is at x, y = −2, 0 m.")
    with pytest.raises(ValueError, match="no other case"):
        prediction.ask()
    assert [one.case for one in prediction.answers] == [0, 1]


def test_an_arrow_stands_where_the_axis_comes_to():
    prediction = made(ARROW)
    assert prediction.truth(0) == pytest.approx(90)
    prediction.commit(75)
    assert prediction.told == (True, "Right. Your arrow is 15° off.")
    place = prediction.mark_x, prediction.mark_y
    np.testing.assert_allclose(place, [np.cos(np.pi / 6), 0.5], atol=1e-9)  # the elbow


def test_a_view_that_is_handed_over_goes_along():
    view = kl.ArmView(kl.robots.two_link(), [0.3, 0.4])
    prediction = made(Asked(None, MARKS.cases), view)
    assert view.q == pytest.approx([0.3, 0.4])
    prediction.commit()
    assert np.degrees(view.q) == pytest.approx([90, 0])
    view.theta_1 = 10                   # and does not move the prediction's picture
    assert prediction.theta_1 == pytest.approx(90)


@pytest.mark.parametrize("asked, answer, words", [
    (MARKS, [1, 2], "a point (x, y, z)"), (MARKS, [1, 2, np.nan], "answer"),
    (MARKS, "1, 2, 0", "answer"), (ARROW, True, "expected a number, got True"),
    (ARROW, [1], "answer"), (NUMBER, True, "expected a number"), (NUMBER, "2", "answer"),
    (NUMBER, float("inf"), "answer"), (CHOICE, "c", "'a' or 'b'"), (CHOICE, 0, "'a' or 'b'"),
    (SEVERAL, "a", "a list of texts"), (SEVERAL, ["a", "c"], "'a' or 'b'"),
    (SIGNS, ["+0"], "2 texts of 2 letters"), (SIGNS, ["+0", "0-"], "each one of + 0"),
    (SIGNS, 3, "got 3")])
def test_what_is_no_answer_is_refused_and_nothing_is_committed(asked, answer, words):
    prediction = made(asked)
    with pytest.raises(ValueError) as error:
        prediction.commit(answer)
    assert words in str(error.value) and not prediction.committed and prediction.answers == []


def test_a_view_that_has_not_what_is_asked_for_is_refused_by_its_name():
    with pytest.raises(ValueError, match="view: 'Two-link' has nothing called 'point-c'"):
        kl.predict("rotation.riding", kl.ArmView(kl.robots.two_link()))
    with pytest.raises(ValueError, match="view: has no slider 'theta_1'"):
        made(Asked(None, MARKS.cases), kl.ArmView(kl.Arm([kl.prismatic()])))
    with pytest.raises(ValueError, match="view: expected a view such as"):
        kl.predict("rotation.riding", 3)


@pytest.mark.parametrize("name", ["rotation", "rotation.none", "nowhere.riding", 3, None])
def test_an_unknown_name_is_answered_with_the_known_ones(name):
    with pytest.raises(ValueError, match="name: "):
        kl.predict(name)


def test_its_text_asks_and_does_not_tell():
    prediction = made(MARKS)
    assert repr(prediction) == "Prediction('trial.one'): Where will the tip be?\nopen"
    assert repr(made(CHOICE)).splitlines()[1:] == ["( ) a", "( ) b", "open"]
    prediction.commit([0, 2, 0])
    assert repr(prediction).splitlines()[1:] == ["Right. Your mark is 0 m away.",
                                                 "The arm is stretched."]


def test_a_picture_of_it_for_where_no_widget_runs_has_words():
    shown, words = made(MARKS)._repr_mimebundle_()
    assert shown["image/png"] and "Where will the tip be?" in words["image/png"]["alt"]
    plain = made(CHOICE)._repr_mimebundle_()
    words = plain[0] if isinstance(plain, tuple) else plain
    assert "image/png" not in words and words["text/plain"].endswith("Run this cell to answer.")
