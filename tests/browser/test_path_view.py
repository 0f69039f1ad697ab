"""A path's view in Chromium: played in its own time, scrubbed, singled out, and told in words."""
import numpy as np
import pytest
from lesson_views import path_view
from plain import LOAD, MOUNT, PAINTED, SOURCE
from playwright.sync_api import expect
from reading import RESTED
from test_access import shown, stop_clock  # noqa: F401  a fixture

import kinlab as kl

LINK = '.kl-picture [data-link="2"][data-part="link"]'
WAIT = 20  # ms: a picture or so


@pytest.fixture
def path_page(shown):  # noqa: F811
    """A page with the two links, whose clock stands still, and the view's element."""
    page, view = shown(path_view())
    stop_clock(page)
    return page, view


def time_of(view):
    return float(view.locator(".kl-field").input_value())


def values(view):
    """What stands beside the names of the curves: degrees, degrees and m/s."""
    texts = view.locator(".kl-name .kl-number").all_inner_texts()
    return [float(text.replace("−", "-").rstrip("°").split(" ")[0]) for text in texts]


def test_play_takes_as_long_as_the_motion_and_stops_at_its_end(path_page):
    page, view = path_page
    play = view.locator('[data-part="play"]')
    play.click()
    page.clock.run_for(500)
    assert time_of(view) == pytest.approx(0.5, abs=0.05)
    page.clock.run_for(1000)
    assert time_of(view) == pytest.approx(1.5, abs=0.05)
    expect(play).to_have_text("❚❚Pause")
    page.clock.run_for(600)
    assert time_of(view) == 2
    expect(play).to_have_text("▶Play")
    play.click()  # from the start again
    page.clock.run_for(300)
    assert time_of(view) == pytest.approx(0.3, abs=0.05)


def test_pause_and_a_hand_stop_it_where_it_is_and_play_goes_on_from_there(path_page):
    page, view = path_page
    play, slider = view.locator('[data-part="play"]'), view.locator("input[type=range]")
    play.click()
    page.clock.run_for(600)
    play.click()
    paused = time_of(view)
    page.clock.run_for(400)
    assert time_of(view) == paused == pytest.approx(0.6, abs=0.05)
    play.click()
    page.clock.run_for(200)
    assert time_of(view) == pytest.approx(paused + 0.2, abs=0.05)
    slider.focus()
    slider.press("ArrowRight")
    at = time_of(view)
    page.clock.run_for(400)
    assert time_of(view) == at
    expect(play).to_have_text("▶Play")


def test_keys_scrub_and_all_numbers_are_those_of_the_path(path_page):
    page, view = path_page
    path, slider = path_view().path, view.locator("input[type=range]")
    slider.focus()
    for key, time in (("PageUp", 0.1), ("ArrowRight", 0.11), ("Shift+ArrowRight", 0.111),
                      ("End", 2.0), ("ArrowLeft", 1.99), ("Home", 0.0)):
        slider.press(key)
        page.clock.run_for(WAIT)
        assert slider.get_attribute("aria-valuetext") == f"{time:.2f} s"
        q = path.at(float(view.locator("input[type=range]").input_value()))
        tip = kl.forward_kinematics(path.arm, q)[:2, 3]
        place = view.locator(".kl-pose tbody tr td:last-child").all_inner_texts()[:2]
        assert [float(x.replace("−", "-")) for x in place] == pytest.approx(tip, abs=1.5e-3)
        assert values(view)[:2] == pytest.approx(np.degrees(q), abs=0.6)


def test_a_hand_in_a_chart_drags_the_time(path_page):
    page, view = path_page
    box = view.locator(".kl-over-time").nth(1).bounding_box()
    left, wide = box["x"] + 54, box["width"] - 66
    page.mouse.move(left + 0.25 * wide, box["y"] + 60)
    page.mouse.down()
    page.clock.run_for(WAIT)
    assert time_of(view) == pytest.approx(0.5, abs=0.02)
    page.mouse.move(left + 0.75 * wide, box["y"] + 70)
    page.clock.run_for(WAIT)
    assert time_of(view) == pytest.approx(1.5, abs=0.02)
    page.mouse.up()
    page.mouse.move(left, box["y"] + 60)
    page.clock.run_for(WAIT)
    assert time_of(view) == pytest.approx(1.5, abs=0.02)


STRONG = """view => [...view.querySelectorAll('[data-course]')].filter(
    curve => Number(getComputedStyle(curve).opacity) === 1).map(curve => curve.dataset.course)"""


def test_a_name_singles_its_joint_out_pressed_or_pointed_at(path_page):
    page, view = path_page
    second = view.get_by_role("button", name="θ₂")
    assert view.evaluate(STRONG) == ["θ₁", "θ₂", "θ₁", "θ₂", "θ₁", "θ₂", "tip", "tip"]
    second.hover()
    page.clock.run_for(200)
    assert view.evaluate(STRONG) == [*["θ₂"] * 3, "tip", "tip"]
    page.mouse.move(5, 5)
    page.clock.run_for(200)
    assert len(view.evaluate(STRONG)) == 8
    second.click()
    page.mouse.move(5, 5)
    page.clock.run_for(200)
    assert view.evaluate(STRONG) == [*["θ₂"] * 3, "tip", "tip"]
    assert second.get_attribute("aria-pressed") == "true"
    second.click()
    page.mouse.move(5, 5)
    page.clock.run_for(200)
    assert len(view.evaluate(STRONG)) == 8
    assert second.get_attribute("aria-pressed") == "false"


def test_arrow_keys_lead_from_name_to_name(path_page):
    _, view = path_page
    first = view.get_by_role("button", name="θ₁")
    first.focus()
    first.press("ArrowRight")
    expect(view.get_by_role("button", name="θ₂")).to_be_focused()
    view.get_by_role("button", name="θ₂").press("ArrowRight")
    expect(view.get_by_role("button", name="Acceleration")).to_be_focused()
    stops = view.locator('.kl-names button[tabindex="0"]')
    assert stops.count() == 1


def test_broken_limits_are_marked_and_said(path_page):
    page, view = path_page
    path = path_view().path
    assert view.locator(".kl-broken > div").all_inner_texts() == [b.text for b in path.broken]
    shown_ = view.locator(".kl-over-time:visible")
    counts = {kind: sum(b.kind == kind for b in path.broken) for kind in ("limit", "speed")}
    for k, kind in enumerate(counts):
        assert shown_.nth(k).locator('[data-part="band"]').count() == counts[kind] > 0
    signs = shown_.nth(0).locator('[data-part="sign"] text').all_text_contents()
    assert signs == ["! θ₂"]
    view.get_by_role("button", name="Acceleration").click()
    page.clock.run_for(WAIT)
    assert shown_.count() == 4
    assert shown_.nth(2).locator('[data-part="band"]').count() == sum(
        b.kind == "acceleration" for b in path.broken) > 0
    assert shown_.nth(2).locator("svg").get_attribute("aria-label") == (
        "Chart over time: accelerations (deg/s²)")


def test_a_screen_reader_hears_time_and_joints_once_it_rests(path_page):
    page, view = path_page
    slider = view.locator("input[type=range]")
    slider.focus()
    slider.press("PageUp")
    page.clock.run_for(500)
    label = view.locator(".kl-picture svg").get_attribute("aria-label")
    assert label.startswith("Two links: a path of 2 s, time 0.10 s, θ₁ ")
    assert "tip" in label and "tool at" in label


def test_who_wants_less_motion_sees_stops_on_the_way(shown):  # noqa: F811
    page, view = shown(path_view(), reduced_motion="reduce")
    stop_clock(page)
    view.locator('[data-part="play"]').click()
    seen = set()
    for _ in range(45):
        page.clock.run_for(50)
        seen.add(time_of(view))
    assert seen == {0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2}


def test_the_arm_itself_is_not_dragged_here(path_page):
    """A hand on a link turns the picture, or does nothing: no joint is free."""
    page, view = path_page
    link = view.locator(LINK).first.bounding_box()
    page.mouse.move(link["x"] + link["width"] / 2, link["y"] + link["height"] / 2)
    page.mouse.down()
    page.mouse.move(link["x"] + 80, link["y"] - 60, steps=4)
    page.mouse.up()
    page.clock.run_for(WAIT)
    assert time_of(view) == 0


def test_pointing_at_a_link_lights_its_curves(path_page):
    page, view = path_page
    view.locator(LINK).first.dispatch_event("pointerover", {"pointerType": "mouse"})
    page.clock.run_for(200)
    assert view.evaluate(STRONG) == [*["θ₂"] * 3, "tip", "tip"]


def test_a_saved_state_shows_the_same_again(page):
    """What a notebook keeps of the widget is all that the view needs."""
    view = path_view()
    view.time = 1.2
    state = view.get_state()
    page.evaluate(LOAD, SOURCE)
    page.add_style_tag(content=view._css)
    page.evaluate(MOUNT, [state["scene"], [state["time"]]])
    page.evaluate(PAINTED)
    page.evaluate(RESTED)
    element = page.locator(".kl-view")
    assert time_of(element) == 1.2
    assert values(element)[:2] == pytest.approx(np.degrees(view.path.at(1.2)), abs=0.6)


@pytest.mark.parametrize("width", [390, 1280, 1920])
def test_words_of_the_charts_can_be_read_at_every_width(page, width):
    page.set_viewport_size({"width": width, "height": 900})
    view = path_view()
    page.evaluate(LOAD, SOURCE)
    page.add_style_tag(content=view._css)
    page.evaluate(MOUNT, [view.scene, [1.2]])
    page.wait_for_function("() => document.querySelector('.kl-over-time svg text')")
    page.evaluate(PAINTED)
    for chart in page.locator(".kl-over-time:visible").all():
        box = chart.bounding_box()
        assert box["x"] >= 0 and box["x"] + box["width"] <= width
        scale, least = chart.evaluate("""node => {
            const svg = node.querySelector('svg'), wide = svg.viewBox.baseVal.width;
            const letters = [...svg.querySelectorAll('text')].map(
                text => parseFloat(getComputedStyle(text).fontSize));
            return [svg.getBoundingClientRect().width / wide, Math.min(...letters)];
        }""")
        assert scale * least >= 12
