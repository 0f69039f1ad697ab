"""Where the parts of a view stand on a phone, a desk and a wide screen, and what its buttons do."""
import math
import re
from dataclasses import replace

import pytest
from grades import chosen, crossed
from lesson_views import VIEWS
from playwright.sync_api import expect
from reading import settle, steady

from kinlab.drawing.controls import Knob
from kinlab.drawing.scene import at
from kinlab.drawing.sketch import Sketch
from kinlab.views.live import LiveView

WIDTHS = {340: 740, 390: 844, 768: 1024, 1280: 800, 1920: 1080}
PHONES = [340, 390]
SHOWN = ["alpha_ii", "intelledex_660t", "limits", "solve", "spatial", "combined", "velocity"]


def overlapping_ends():
    """A view whose two knobs are the ends of one range and could pass each other."""
    sketch = Sketch("Ends", 1.5)
    for word, home in (("from", -30), ("to", 60)):
        knob = Knob.angle(f"{word}_1", f"θ₁ {word}", home=math.radians(home))
        sketch.knob(replace(knob, pair="θ₁"))
    sketch.line("line", at(0, (0, 0, 0), (1, 0, 0)))
    return LiveView(sketch.scene())


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A page for each view."""
    folder = tmp_path_factory.mktemp("layout")
    for name in SHOWN:
        VIEWS[name]().save_html(folder / f"{name}.html")
    VIEWS["order"]().save_html(folder / "order.html")
    VIEWS["alpha_ii"]().save_html(folder / "asked.html", question="Which way does x₅ point?")
    overlapping_ends().save_html(folder / "ends.html")
    return folder


@pytest.fixture
def visit(lend, folder, watched):
    """A function that opens the page of a view at a width and gives the view."""
    def visit(name, width=1280):
        page = watched(lend(viewport={"width": width, "height": WIDTHS[width]},
                            has_touch=width in PHONES))
        page.goto((folder / f"{name}.html").as_uri())
        view = page.locator(".kl-view")
        view.locator(".kl-picture svg").wait_for()
        settle(page)
        return view

    return visit


def button(view, name):
    return view.get_by_role("button", name=name, exact=True)


def slider(view, name):
    return view.get_by_role("slider", name=name, exact=True)


def box(view, selector):
    found = view.locator(selector).first.bounding_box()
    return {**found, "right": found["x"] + found["width"], "bottom": found["y"] + found["height"]}


# ---- Readable, and nothing over anything else ----

SMALL = """view => {
    const words = document.createTreeWalker(view, NodeFilter.SHOW_TEXT), small = [];
    while (words.nextNode()) {
        const node = words.currentNode, parent = node.parentElement;
        if (!node.data.trim() || !parent.checkVisibility({visibilityProperty: true})) continue;
        const scale = parent.closest('svg')?.getScreenCTM().a ?? 1;
        const size = parseFloat(getComputedStyle(parent).fontSize) * scale;
        if (size < 11.99) small.push([node.data.trim(), size]);
    }
    for (const field of view.querySelectorAll('input, select')) {
        const size = parseFloat(getComputedStyle(field).fontSize);
        if (field.checkVisibility() && size < 11.99) small.push([field.value, size]);
    }
    return small;
}"""
PARTS = [".kl-head", ".kl-picture", ".kl-toolbar", ".kl-joints", ".kl-pose", ".kl-readings",
         ".kl-remark", ".kl-below"]
BOXES = """(view, parts) => parts.flatMap(part => {
    const node = view.querySelector(part), box = node?.getBoundingClientRect();
    return box?.width && box.height ? [[part, box.left, box.top, box.right, box.bottom]] : [];
})"""


def assert_stands_apart(boxes, width):
    for k, (name, left, top, right, bottom) in enumerate(boxes):
        assert left >= -0.5 and right <= width + 0.5, (name, left, right)
        for other, a, b, c, d in boxes[:k]:
            over = min(right, c) - max(left, a), min(bottom, d) - max(top, b)
            assert min(over) <= 1, (name, other, over)


@pytest.mark.parametrize("name, width", crossed(SHOWN, WIDTHS))
def test_all_can_be_read_and_nothing_overlaps_or_sticks_out(visit, name, width):
    view = visit(name, width)
    more = button(view, "More")
    if more.is_visible():
        more.click()  # what it hides has to be readable, too
    assert view.evaluate(SMALL) == []
    assert view.page.evaluate("document.documentElement.scrollWidth") == width
    assert_stands_apart(view.evaluate(BOXES, PARTS), width)


def test_a_wide_page_is_filled_and_all_is_beside_the_picture(visit):
    view = visit("alpha_ii", 1920)
    picture = box(view, ".kl-picture")
    assert picture["width"] > 1000 and picture["height"] > 850
    assert box(view, ".kl-side")["right"] > 1880
    for part in ("h1", ".kl-joints", ".kl-pose", "math"):
        assert box(view, part)["x"] > picture["right"], part
    assert box(view, ".kl-below")["bottom"] < 1080 and box(view, ".kl-toolbar")["bottom"] < 1080
    for part in (".kl-pose td", ".kl-knob span", ".kl-field"):  # to be read from the last row
        size = view.locator(part).first.evaluate("n => parseFloat(getComputedStyle(n).fontSize)")
        assert size > 20, part


@pytest.mark.parametrize("width", [1280, 1920])
def test_a_question_stands_beside_the_picture(visit, width):
    view = visit("asked", width)
    question = view.get_by_text("Which way does x₅ point?").bounding_box()
    assert question["x"] > box(view, ".kl-picture")["right"]
    assert box(view, "h1")["bottom"] <= question["y"] < box(view, ".kl-joints")["y"]


def test_two_arms_side_by_side_are_no_strip_on_a_phone(visit):
    picture = visit("solve", 390).locator(".kl-picture").bounding_box()
    assert picture["height"] > 0.7 * picture["width"]


@pytest.mark.parametrize("name", chosen(
    ["alpha_ii", "intelledex_660t", "limits", "solve"], ["alpha_ii", "limits"]))
def test_a_full_screen_is_filled_and_all_of_it_is_seen(visit, name):
    view = visit(name, 1920)
    button(view, "Full screen").click()
    view.page.wait_for_function("document.fullscreenElement?.classList.contains('kl-view')")
    settle(view.page)
    picture = box(view, ".kl-picture")
    assert picture["width"] > 1000 and picture["height"] > 850
    boxes = view.evaluate(BOXES, [*PARTS, ".kl-pose thead th:last-child", ".kl-unit"])
    assert max(bottom for *_, bottom in boxes) <= 1080
    assert_stands_apart([one for one in boxes if one[0] in PARTS], 1920)
    assert all(right <= 1920 for _, _, _, right, _ in boxes)
    large = "node => parseFloat(getComputedStyle(node).fontSize) > 20"
    assert view.locator(".kl-knob span").first.evaluate(large)
    assert view.evaluate(SMALL) == []


def test_at_1280_the_formula_is_seen_without_scrolling(visit):
    view = visit("alpha_ii", 1280)
    assert box(view, "math")["bottom"] <= 800
    assert box(view, ".kl-joints")["x"] > box(view, ".kl-picture")["right"]


@pytest.mark.parametrize("width", PHONES)
def test_a_phone_shows_picture_one_row_of_buttons_and_sliders(visit, width):
    view = visit("alpha_ii", width)
    picture, bar, sliders = (box(view, part) for part in
                             (".kl-picture", ".kl-toolbar", ".kl-joints"))
    assert picture["width"] > width - 20 and picture["y"] < 50
    assert picture["bottom"] <= bar["y"] + 1 and bar["bottom"] <= sliders["y"] + 1
    assert 44 <= bar["height"] <= 56  # one row
    shown = [node.inner_text() for node in view.locator(".kl-toolbar button").all()
             if node.is_visible()]
    assert len(shown) == 6 and shown[0] == "Home" and shown[-1] == "More"
    for node in view.locator(".kl-toolbar button").all():
        if node.is_visible():
            size = node.bounding_box()
            assert size["width"] >= 44 and size["height"] >= 44, node.inner_text()
    for node in view.get_by_role("slider").all():
        assert node.bounding_box()["height"] >= 44


def test_all_of_the_table_editor_can_be_read(live):
    (view,) = live("import kinlab as kl\nkl.DHTableEditor(kl.robots.alpha_ii())")
    editor = view.page.locator(".jp-Notebook:visible .kl-editor")
    editor.get_by_role("button", name="Closed form", exact=True).click()
    editor.locator(".kl-panel math").wait_for()
    assert editor.evaluate(SMALL) == []


# ---- Menus ----


def test_more_opens_and_closes_and_stays_while_one_goes_elsewhere(visit):
    view = visit("alpha_ii", 390)
    more = button(view, "More")
    assert more.get_attribute("aria-expanded") == "false"
    assert not button(view, "Top").is_visible()
    more.click()
    assert more.get_attribute("aria-expanded") == "true" and button(view, "Top").is_visible()
    slider(view, "θ₁, base").press("ArrowRight")
    assert button(view, "Top").is_visible()
    more.press("Escape")
    assert more.get_attribute("aria-expanded") == "false"
    expect(more).to_be_focused()


def test_frames_are_hidden_one_by_one(visit):
    view = visit("alpha_ii")
    page, opener = view.page, button(view, "Which frames")
    opener.press("Enter")
    boxes = view.get_by_role("checkbox")
    assert [node.get_attribute("aria-label") for node in boxes.all()] == [
        f"frame {k}" for k in range(6)]
    opener.press("ArrowDown")
    expect(boxes.nth(0)).to_be_focused()
    page.keyboard.press("ArrowDown")
    expect(boxes.nth(1)).to_be_focused()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("ArrowUp")
    expect(boxes.nth(5)).to_be_focused()
    boxes.nth(2).uncheck()
    settle(page)
    assert axes_of(view, 2) == [] and axes_of(view, 3) == ["x", "y", "z"]
    for _ in range(2):  # the layer goes and comes: the frame stays away
        button(view, "Frames").click()
        settle(page)
    assert axes_of(view, 2) == [] and axes_of(view, 3) == ["x", "y", "z"]
    assert opener.get_attribute("aria-expanded") == "false"  # the hand went elsewhere
    opener.click()
    boxes.nth(2).check()
    settle(page)
    assert axes_of(view, 2) == ["x", "y", "z"]
    page.keyboard.press("Escape")
    assert not boxes.first.is_visible()
    expect(opener).to_be_focused()


def axes_of(view, frame):
    return [letter for letter in "xyz" if view.locator(f"[id='frame-{frame}-{letter}']").count()
            and view.locator(f"[id='frame-{frame}-{letter}']").first.is_visible()]


# ---- Looking and stepping ----


def test_one_looks_along_an_axis_of_a_frame(visit):
    view = visit("alpha_ii")
    along = view.get_by_label("Look along an axis")
    assert along.locator("option").all_inner_texts() == [
        "Along …", *(f"{letter}{digit}" for letter in "zx" for digit in "₀₁₂₃₄₅")]
    before = drawn_length(view, "frame-5-x")
    along.select_option("x₅")
    settle(view.page)
    assert before > 20 and drawn_length(view, "frame-5-x") < 8  # it points at the viewer
    along.select_option("z₁")
    settle(view.page)
    assert drawn_length(view, "frame-5-x") > 20


def drawn_length(view, name):
    size = view.locator(f"[id='{name}'] path").last.bounding_box()
    return math.hypot(size["width"], size["height"]) if size else 0.0


def test_steps_go_to_whole_numbers(visit):
    view = visit("order")
    motion = view.get_by_role("slider")
    view.locator(".kl-field").fill("1.5")
    view.page.keyboard.press("Enter")
    for name, value in (("Step forward", "2.0"), ("Step back", "1.0"), ("Step back", "0.0")):
        button(view, name).click()
        expect(view.locator(".kl-field")).to_have_value(value)
    button(view, "Play").click()
    view.page.wait_for_function("() => document.querySelector('.kl-field').value > 0.2")
    button(view, "Pause").click()
    assert motion.is_visible()


def test_steps_go_from_pose_to_pose(visit):
    view = visit("alpha_ii")
    first, second = view.locator(".kl-field").nth(0), view.locator(".kl-field").nth(1)
    button(view, "Step forward").click()
    expect(first).to_have_value("90.0")
    button(view, "Step forward").click()
    expect(first).to_have_value("0.0")
    for _ in range(3):  # faster than the arm: home, the second joint out, and back again
        button(view, "Step forward").click()
    button(view, "Step back").click()
    button(view, "Step back").click()
    expect(second).to_have_value("72.0")


def test_without_motion_a_step_is_there_at_once(browser, folder):
    page = browser.new_page(reduced_motion="reduce")
    page.goto((folder / "order.html").as_uri())
    page.get_by_role("button", name="Step forward").click()
    settle(page)
    assert page.locator(".kl-field").input_value() == "1.0"
    page.close()


def test_without_motion_play_shows_one_pose_after_another(browser, folder):
    page = browser.new_page(reduced_motion="reduce")
    page.goto((folder / "alpha_ii.html").as_uri())
    page.evaluate("""() => {
        window.shown = new Map();
        const look = (now) => {
            const q = [...document.querySelectorAll(".kl-field")].map(field => field.value).join();
            const [first] = shown.get(q) ?? [now];
            shown.set(q, [first, now]);
            requestAnimationFrame(look);
        };
        look(performance.now());
    }""")
    with steady(page, 16):
        page.get_by_role("button", name="Play").click()
        page.wait_for_function("shown.size > 2")
    stood = page.evaluate("[...shown.values()].slice(1, -1).map(([from, to]) => to - from)")
    assert min(stood) > 500  # ms: they do not flicker
    assert page.get_by_role("button", name="Pause").is_visible()
    page.close()


def test_a_picture_that_was_made_smaller_says_so(visit):
    view = visit("alpha_ii")
    note = view.locator(".kl-shrunk")
    expect(note).to_have_text("")
    view.locator(".kl-field").nth(1).fill("-90")
    view.locator(".kl-field").nth(1).press("Enter")
    view.locator(".kl-field").nth(3).fill("0")
    view.locator(".kl-field").nth(3).press("Enter")
    settle(view.page)
    assert re.fullmatch(r"drawn at [4-9]\d %", note.inner_text())
    button(view, "Home").click()
    expect(note).to_have_text("")


def test_perspective_makes_the_far_grid_finer_and_stays_when_one_looks_elsewhere(visit):
    view = visit("alpha_ii")
    switch = button(view, "Perspective")
    flat = view.locator(".kl-picture svg").inner_html()
    switch.click()
    settle(view.page)
    assert switch.get_attribute("aria-pressed") == "true"
    assert view.locator(".kl-picture svg").inner_html() != flat
    button(view, "Top").click()
    button(view, "3-D").click()
    settle(view.page)
    assert view.locator(".kl-picture svg").inner_html() != flat
    assert not button(visit("combined"), "Perspective").count()  # a plane has none


# ---- Two handles on one track ----


def test_two_handles_share_a_track_and_do_not_pass(visit):
    view = visit("ends")
    low, high = slider(view, "θ₁ from"), slider(view, "θ₁ to")
    first, second = low.bounding_box(), high.bounding_box()
    assert first == second and view.locator(".kl-pair").count() == 1
    low.press("End")
    assert values(view) == [60, 60]
    high.press("PageDown")
    assert values(view) == [60, 60]
    low.press("PageDown")
    assert values(view) == [50, 60]
    field = view.get_by_role("textbox", name="θ₁ to, number in °")
    field.fill("-100")
    field.press("Enter")
    assert values(view) == [50, 50]
    high.press("Home")
    assert values(view) == [50, 50]
    high.press("End")
    assert values(view) == [50, 180]


def test_a_mouse_takes_either_handle_and_the_track_between(visit):
    view = visit("ends")
    page, track = view.page, slider(view, "θ₁ from").bounding_box()
    y = track["y"] + track["height"] / 2
    place = lambda degrees: (track["x"] + 11  # noqa: E731
                             + (degrees + 180) / 360 * (track["width"] - 22))
    page.mouse.move(place(-30), y)
    page.mouse.down()
    page.mouse.move(place(0), y, steps=4)
    page.mouse.move(place(120), y, steps=4)
    settle(page)
    assert values(view) == [60, 60]
    assert float(slider(view, "θ₁ from").input_value()) == pytest.approx(60)
    page.mouse.up()
    page.mouse.click(place(170), y)
    low, high = values(view)
    assert low == 60 and 166 <= high <= 174
    slider(view, "θ₁ to").press("End")
    slider(view, "θ₁ from").press("End")
    page.mouse.move(place(180), y)
    page.mouse.down()
    page.mouse.move(place(90), y, steps=4)
    page.mouse.up()
    assert 86 <= values(view)[0] <= 94 and values(view)[1] == 180  # not stuck at the end
    high = 180
    page.mouse.click(place(-100), y)
    assert -104 <= values(view)[0] <= -96 and values(view)[1] == high


def values(view):
    return [float(field.input_value()) for field in view.locator(".kl-field").all()]


# ---- Columns ----


def test_columns_are_explained_where_they_stand(visit):
    heads = visit("alpha_ii", 390).locator(".kl-pose th")
    assert [head.inner_text().split("\n") for head in heads.all()] == [
        ["n", "normal"], ["s", "sliding"], ["a", "approach"], ["p (mm)", "position"]]


@pytest.mark.parametrize("width", [390, 1280])
def test_a_wide_matrix_is_shown_by_columns(visit, width):
    view = visit("intelledex_660t", width)
    whole, lines = view.locator(".kl-math > math"), view.locator(".kl-entry")
    assert not whole.is_visible()
    assert [line.get_attribute("data-entry") for line in lines.all()] == ["1,4", "2,4", "3,4"]
    for line in lines.all():
        assert line.evaluate("""line => [...line.querySelectorAll('math')].every(part =>
            part.getBoundingClientRect().right <= innerWidth)""")
    words = re.sub(r"\s", "", lines.nth(2).text_content())
    assert words == "pz=373.4+304.8S2C3+304.8S2C34+228.6S2S345"
    view.get_by_role("button", name="a approach").click()
    assert lines.first.get_attribute("data-entry") == "1,3"
    expect(lines.first).to_be_visible()


def test_a_matrix_that_fits_stays_whole(visit):
    view = visit("alpha_ii", 1280)
    assert view.locator(".kl-math > math").is_visible()
    assert not view.locator(".kl-columns").is_visible()
    view.page.set_viewport_size({"width": 390, "height": 844})
    expect(view.locator(".kl-columns")).to_be_visible()
    view.page.set_viewport_size({"width": 1280, "height": 800})
    expect(view.locator(".kl-math > math")).to_be_visible()
