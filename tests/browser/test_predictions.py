"""Predictions under real hands: answered, kept, looked back at, and the same words as Python's."""
import importlib
import json
import math
import re

import numpy as np
import pytest
from lab import run_code
from playwright.sync_api import expect
from reading import RESTED, middle, settle

import kinlab as kl
from kinlab import lessons
from kinlab.answers.prediction import Asked, Choice, Direction, Mark, Number, Several, Signs
from kinlab.browser import bundle
from kinlab.views.prediction import Prediction

HOMES = {"theta_1": 0, "theta_2": 0}
TIP = [Mark(ask=f"Where will the tip be when θ₁ = {t}°?", why="The arm is stretched.", of="tip",
            start=HOMES, shows={"theta_1": t}, tolerance=0.15, unit="m",
            slips=[((0, -2, 0), "Positive angles turn to the left.")]) for t in (90, 180)]


def arm():
    return kl.ArmView(kl.robots.two_link())


ASKED = {
    "mark": Asked(arm, TIP),
    "point": Asked(lessons.rotation.riding_view, [
        Mark(ask="Where will c be?", why="It rides.", of="point-c", tolerance=0.1, begin=(1, 1, 0),
             start={"theta": 0}, shows={"theta": 90})]),
    "traced": Asked(lambda: kl.ArmView(kl.robots.two_link(), show="trace"), TIP),
    "direction": Asked(arm, [Direction(ask="Which way will x₂ point?", why="Angles add up.",
                                       of="frame-2-x", start=HOMES,
                                       shows={"theta_1": 30, "theta_2": 60})]),
    "choice": Asked(None, [Choice(ask="Which <b>one</b>?", why="So it is.", right="b & c",
                                  options={"a": "No: see b.", "b & c": "", "<i>d</i>": "No."})]),
    "several": Asked(None, [Several(ask="Which?", why="So it is.", right=("a", "c"),
                                    options={"a": "It is one.", "b": "It is none.", "c": ""})]),
    "number": Asked(arm, [Number(ask="At which angle?", why="Angles add up.", right=90, unit="°",
                                 tolerance=2, turn=360, start=HOMES, shows={"theta_1": 90},
                                 slips=[(45, "That is half of it.")])]),
    "signs": Asked(None, [Signs(ask="Which entries change?", why="z stays.", rows=("x", "y"),
                                columns=("x₁", "y₁"), right=("-0", "+-"),
                                among={"0": "stays", "+": "grows", "-": "falls"})]),
}
# Answers of each kind: right ones, wrong ones, slips, and none.
ANSWERS = {"mark": [None, [0, 2, 0], [0.1, 1.9, 0], [0, -2.1, 0], [1, 1, 0.5],
                    [0, 2 + 8e-6, 0], [0, 2.00015, 0], [3e6, 0, 0]],
           "direction": [None, 90, 450, 76, 74.5, -90, 0],
           "choice": [None, "a", "b & c", "<i>d</i>"],
           "several": [None, [], ["a"], ["b"], ["a", "c"], ["a", "b", "c"]],
           "number": [None, 90, -270, 91.9, 45, 0.125, 271, 1e5, 1e6, 1e-9],
           "signs": [None, ["-0", "+-"], ["00", "00"], ["+0", "+-"]]}


def prediction(kind):
    return Prediction(f"trial.{kind}", ASKED[kind])


def cases():
    """Every case of this file and of the course, and answers to it."""
    for kind, answers in ANSWERS.items():
        yield prediction(kind), 0, answers
    for lesson in lessons.names():
        if not (known := lessons.predictions(lesson)):
            continue
        held = importlib.import_module(f"predicted.{lesson}").PREDICTED
        for name in known:
            made = kl.predict(name)
            for k, fixed in enumerate(held[name]):
                yield made, k, [None, fixed.right, *[answer for answer, _ in fixed.wrong]]


def test_both_hands_say_the_same(page):
    """Word by word, to every answer that the tests of the course know."""
    page.evaluate("""async source => {
        window.hand = await import(URL.createObjectURL(new Blob([source],
                                                                {type: 'text/javascript'})));
    }""", bundle.module("verdicts.js"))
    all_cases = []
    for made, k, answers in cases():
        one, truth = made.cases[k], made.truth(k)
        plain = [None if answer is None else one.read(answer) for answer in answers]
        said = [one.told(answer, truth) for answer in plain]
        all_cases.append((made.question["cases"][k], plain, [[*told] for told in said]))
    assert len(all_cases) > 6
    heard = page.evaluate("""all => all.map(([one, answers]) => answers.map(answer => {
        const { ok, said } = hand.verdict(one, answer);
        return [ok, said];
    }))""", json.loads(json.dumps([case[:2] for case in all_cases])))
    for (one, answers, said), got in zip(all_cases, heard):
        assert got == said, (one["ask"], answers)


# ---- in a page without Python ----


@pytest.fixture
def opened(page, tmp_path):
    """A function that opens a prediction in a page of its own, and gives its element."""
    def open_it(kind, again=False):
        if again:
            page.reload()
        else:
            path = prediction(kind).save_html(tmp_path / f"{kind}.html")
            page.goto(path.as_uri())
        view = page.locator(".kl-view")
        view.locator(".kl-predict").wait_for()
        page.evaluate(RESTED)
        return view
    return open_it


def angles(view):
    return [float(field.input_value()) for field in view.locator(".kl-field:visible").all()]


def commit(view):
    view.get_by_role("button", name="Commit").click()


def test_a_mark_is_dragged_committed_and_measured(opened, page):
    view = opened("mark")
    dot = view.locator("#guess-dot path")
    expect(view.locator("#gap-tip")).to_have_count(0)
    start = middle(dot)
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move(start[0] - 60, start[1] - 60, steps=4)
    page.mouse.up()
    settle(page)
    assert np.allclose(middle(dot), np.add(start, (-60, -60)), atol=3)
    x, y = angles(view)
    commit(view)
    expect(view.locator(".kl-told")).to_contain_text("away")
    said = view.locator(".kl-told").inner_text()
    assert float(re.search(r"is ([\d.]+) m away", said)[1]) == pytest.approx(
        np.hypot(x, y - 2), abs=0.1)   # the fields are rounded
    expect(view.get_by_label("θ₁, shoulder, number")).to_have_value("90.0")
    expect(view.locator("#gap-tip")).to_be_visible()
    expect(view.get_by_role("button", name="Commit")).to_have_count(0)


def test_a_committed_mark_stays_whoever_pulls_at_it(opened, page):
    view = opened("point")
    view.get_by_label("x of your mark, number").fill("0.5")
    page.keyboard.press("Enter")
    commit(view)
    expect(view.get_by_label("θ, number")).to_have_value("90.0")
    page.evaluate(RESTED)
    dot = view.locator("#guess-dot path")
    kept = middle(dot)
    page.mouse.move(*kept)
    page.mouse.down()
    page.mouse.move(kept[0] + 50, kept[1], steps=4)
    page.mouse.up()
    settle(page)
    assert middle(dot) == kept


def test_in_a_plane_the_mark_comes_to_a_click(opened, page):
    view = opened("mark")
    box = view.locator(".kl-picture").bounding_box()
    place = box["x"] + 0.3 * box["width"], box["y"] + 0.3 * box["height"]
    page.mouse.click(*place)
    settle(page)
    assert np.allclose(middle(view.locator("#guess-dot path")), place, atol=3)


def test_while_it_is_open_the_arm_stands_still_and_shows_no_number(opened, page):
    view = opened("mark")
    expect(view.get_by_label("θ₁, shoulder, number")).to_be_hidden()
    expect(view.locator(".kl-pose")).to_have_count(0)
    for name in ("Home", "Play"):
        expect(view.get_by_role("button", name=name)).to_have_count(0)
    link = view.locator("#link-1-0 path").first
    before = link.get_attribute("d")
    at = middle(view.locator("#joint-2 path").first)
    for start in (middle(link), at, (at[0] - 25, at[1])):
        page.mouse.move(*start)
        page.mouse.down()
        page.mouse.move(start[0], start[1] - 80, steps=4)
        page.mouse.up()
        settle(page)
        assert link.get_attribute("d") == before
        for name in ("θ₁, shoulder", "θ₂, elbow"):
            expect(view.get_by_label(f"{name}, number")).to_have_value("0.0")


def test_nothing_is_committed_before_there_is_an_answer(opened):
    for kind, words in (("mark", "Move your mark first"), ("direction", "Move your arrow first"),
                        ("choice", "Choose one"), ("number", "Type a number"),
                        ("signs", "Fill every entry")):
        view = opened(kind)
        commit(view)
        expect(view.locator(".kl-told")).to_contain_text(words)
        expect(view.get_by_role("button", name="Commit")).to_be_visible()


def test_a_mark_that_a_widget_has_rounded_is_not_moved(page, tmp_path):
    """A widget's numbers have 13 digits: the tip of this arm does not begin at one of them."""
    asked = Asked(arm, [Mark(ask="Where?", why="There.", of="tip", unit="m", tolerance=0.1,
                             start={"theta_1": 30, "theta_2": 30}, shows={"theta_1": 0})])
    path = Prediction("trial.rounded", asked).save_html(tmp_path / "rounded.html")
    text = path.read_text(encoding="utf-8")
    x = math.cos(math.radians(30)) + math.cos(math.radians(60))
    shown = f"{x:.13g}"
    assert shown in text and float(shown) != x
    head, tail = text.split('"question":')
    path.write_text(f'{head.replace(shown, repr(x))}"question":{tail}', encoding="utf-8")
    page.goto(path.as_uri())
    view = page.locator(".kl-view")
    commit(view)
    expect(view.locator(".kl-told")).to_contain_text("Move your mark first")


def test_by_the_keyboard_alone_and_told_to_a_screen_reader(opened, page):
    view = opened("choice")
    view.get_by_role("radio").first.focus()
    page.keyboard.press("Space")
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Tab")
    expect(view.get_by_role("button", name="Commit")).to_be_focused()
    page.keyboard.press("Enter")
    told = view.get_by_role("status").filter(has_text="Right.")
    expect(told).to_be_focused()
    expect(told).to_contain_text("So it is.")
    expect(view.locator(".kl-ask")).to_have_text("Which <b>one</b>?")
    assert view.locator("b, i").count() == 0
    for box in view.get_by_role("radio").all():
        expect(box).to_be_disabled()


def test_a_mark_and_an_arrow_are_set_by_keys(opened, page):
    view = opened("mark")
    view.get_by_label("x of your mark, number").fill("0")
    page.keyboard.press("Enter")
    view.get_by_label("y of your mark, number").fill("2")
    page.keyboard.press("Enter")
    commit(view)
    expect(view.locator(".kl-told")).to_contain_text("Right. Your mark is 0 m away.")
    view = opened("direction")
    slider = view.get_by_role("slider", name="your arrow, turn of your arrow")
    slider.focus()
    for _ in range(8):
        page.keyboard.press("PageUp")
    commit(view)
    expect(view.locator(".kl-told")).to_contain_text("Right. Your arrow is 10° off.")
    expect(view.locator("#guess-arrow-z")).to_be_visible()


def test_a_number_with_a_slip_and_several_with_marks(opened):
    view = opened("number")
    view.get_by_label("A number in °").fill("pi/4")
    commit(view)
    expect(view.locator(".kl-told")).to_contain_text(
        "You said 45°, 45° off. That is half of it. It is 90°. Angles add up.",
        use_inner_text=True)
    view = opened("several")
    view.get_by_label("b").check()
    commit(view)
    expect(view.locator(".kl-told")).to_contain_text("“b” does not belong. It is none.")
    view = opened("signs")
    for cell in view.locator(".kl-letters").all():
        cell.select_option("+")
    commit(view)
    expect(view.locator(".kl-told")).to_contain_text("1 of 4 entries are as you said")
    assert view.locator("td.kl-missed").count() == 3


def test_another_one_looking_back_and_kept_when_the_page_is_opened_again(opened, page):
    view = opened("mark")
    view.get_by_role("button", name="I do not know").click()
    expect(view.locator(".kl-told")).to_contain_text("No guess. It is at x, y = 0, 2 m.")
    view.get_by_role("button", name="Another one").click()
    expect(view.locator(".kl-ask")).to_contain_text("θ₁ = 180°")
    view.get_by_label("x of your mark, number").fill("-2")
    page.keyboard.press("Enter")
    commit(view)
    expect(view.locator(".kl-told")).to_contain_text("Right.")
    expect(view.get_by_role("button", name="Another one")).to_have_count(0)
    view.get_by_text("Looking back").click()
    expect(view.locator(".kl-past")).to_contain_text("No guess. It is at x, y = 0, 2 m.")
    view = opened("mark", again=True)
    expect(view.locator(".kl-told")).to_contain_text("Right.")
    expect(view.get_by_label("θ₁, shoulder, number")).to_have_value("180.0")
    view.get_by_role("button", name="See it again").click()
    expect(view.get_by_label("θ₁, shoulder, number")).to_have_value("180.0")


def trace(page):
    """Corners of the trace in the picture, once all rests."""
    settle(page)
    page.evaluate(RESTED)
    (way,) = page.locator("#trace path").evaluate_all(
        "all => all.map(node => node.getAttribute('d'))")
    return np.array(re.findall(r"-?[\d.]+", way), float).reshape(-1, 2)


def turn(view, page, name, angle):
    view.get_by_label(f"{name}, number").fill(str(angle))
    page.keyboard.press("Enter")


def test_no_trace_leads_from_one_case_to_the_next(opened, page):
    """Else it would run from where the tip was to where it begins: an arrow to the answer."""
    view = opened("traced")
    expect(view.locator("#trace")).to_have_count(0)
    view.get_by_role("button", name="I do not know").click()
    expect(view.get_by_label("θ₁, shoulder, number")).to_have_value("90.0")
    assert len(trace(page)) > 2
    view.get_by_role("button", name="Another one").click()
    page.evaluate(RESTED)
    expect(view.locator("#trace")).to_have_count(0)
    view.get_by_role("button", name="I do not know").click()
    expect(view.get_by_label("θ₁, shoulder, number")).to_have_value("180.0")
    turn(view, page, "θ₁, shoulder", 0)              # where the case began
    way = trace(page)
    np.testing.assert_allclose(way[0], way[-1], atol=1)


def test_a_trace_begins_anew_when_it_is_seen_again(opened, page):
    view = opened("traced")
    view.get_by_role("button", name="I do not know").click()
    expect(view.get_by_label("θ₁, shoulder, number")).to_have_value("90.0")
    turn(view, page, "θ₂, elbow", 90)                # the arm bends: off the circle of radius 2 m
    trace(page)
    view.get_by_role("button", name="See it again").click()
    expect(view.get_by_label("θ₂, elbow, number")).to_have_value("0.0")
    expect(view.get_by_label("θ₁, shoulder, number")).to_have_value("90.0")
    way = trace(page)                                # a quarter of the circle, and nothing else
    base = np.array([way[-1, 0], way[0, 1]])
    np.testing.assert_allclose(np.linalg.norm(way - base, axis=1), way[0, 0] - base[0], atol=2)


# ---- in JupyterLab ----

CELL = """import kinlab as kl
from kinlab.answers.prediction import Asked, Mark
from kinlab.views.prediction import Prediction
partner = kl.ArmView(kl.robots.two_link(), [0, 0])
asked = Asked(None, [Mark(ask="Where?", why="Stretched.", of="tip", tolerance=0.15, unit="m",
                          shows={"theta_1": 90})])
prediction = Prediction("trial.lab", asked, partner)
prediction"""


def said(page, code):
    return run_code(page, f"print(({code}))").strip()


def until(page, code, wanted):
    """Wait until Python says this."""
    for _ in range(100):
        if (now := said(page, code)) == wanted:
            return
        page.wait_for_timeout(100)
    assert now == wanted


KEPT = "() => jupyterapp.shell.currentWidget.context.model.getMetadata('kinlab')"


def test_python_hears_of_it_and_the_notebook_keeps_it(notebook):
    page = notebook(CELL)
    view = page.locator(".jp-Notebook:visible .kl-view")
    view.locator(".kl-predict").wait_for()
    view.get_by_label("x of your mark, number").fill("1")
    page.keyboard.press("Enter")
    commit(view)
    expect(view.locator(".kl-told")).to_contain_text("Your mark is 2.236 m away.")
    assert said(page, "prediction.answers[0].answer[:2] == [1, 0], prediction.told.ok") == (
        "(True, False)")
    until(page, "partner.theta_1, prediction.theta_1", "(90.0, 90.0)")
    assert page.evaluate(KEPT)["predictions"] == {
        "trial.lab": [{"case": 0, "answer": [1, 0, 0]}]}
    page.evaluate("jupyterapp.commands.execute('notebook:run-all-cells')")
    expect(view.locator(".kl-told")).to_contain_text("Your mark is 2.236 m away.")
    until(page, "prediction.committed, prediction.theta_1", "(True, 90.0)")


def test_what_python_commits_is_seen(notebook):
    page = notebook(CELL, "prediction.commit([0, 2, 0])")
    view = page.locator(".jp-Notebook:visible .kl-view")
    expect(view.locator(".kl-told")).to_contain_text("Right. Your mark is 0 m away.")
