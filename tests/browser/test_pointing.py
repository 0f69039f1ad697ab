"""Picture, sliders, tables and formulas point at each other."""
import re

import nbformat
import numpy as np
import pytest
from playwright.sync_api import expect

import kinlab as kl
from kinlab.browser import bundle

KERNEL = {"name": "python3", "display_name": "Python 3", "language": "python"}
ARC = 60  # px: radius of an arc
POSE = np.radians([20, -30, 40, 25, 60])
TEXT = """<p style="margin-top: 40px">See <a id="term" href="#kl:joints=2,3">C₂₃</a>,
<a id="frame" href="#kl:frame=1">frame 1</a> and <a id="none" href="#kl:joint=9">joint 9</a>.</p>"""
CENTRE = """node => { const r = node.getBoundingClientRect();
    return [r.left + r.width / 2, r.top + r.height / 2]; }"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Pages of the Alpha II and of an arm that slides."""
    here = tmp_path_factory.mktemp("pointing")
    kl.ArmView(kl.robots.alpha_ii(), q=POSE, closed_form=True).save_html(here / "alpha.html")
    kl.ArmView(kl.robots.exam_2018(), closed_form=True).save_html(here / "exam.html")
    kl.lessons.dh_recipe.parameters_view(kl.robots.exam_2018(), 2).save_html(here / "link.html")
    two = [kl.ArmView(arm()).html() for arm in (kl.robots.two_link, kl.robots.alpha_ii)]
    (here / "lesson.html").write_text(
        f"<style>{bundle.page_style()}</style>{two[0]}{TEXT}{two[1]}"
        f"<script>{bundle.script('host_page.js')}</script>", encoding="utf-8")
    return here


@pytest.fixture
def visit(lend, folder, watched):
    def open_page(name, **options):
        page = watched(lend(**{"viewport": {"width": 1280, "height": 1000}} | options))
        page.goto((folder / f"{name}.html").as_uri())
        page.locator(".kl-picture svg").first.wait_for()
        return page

    return open_page


def row(view, joint):
    return view.locator(f".kl-knob[data-joint='{joint}']")


def marks(view, joint=None):
    return view.locator(".kl-marks > g" + (f"[data-joint='{joint}']" if joint else ""))


def has_class(locator, name):
    expect(locator).to_have_class(re.compile(rf"(^| ){name}( |$)"))


def lacks_class(locator, name):
    expect(locator).not_to_have_class(re.compile(rf"(^| ){name}( |$)"))


def factor(view, name):
    return view.locator(f"[data-factor='{name}']").first


def test_a_factor_shows_its_two_angles_as_arcs(visit):
    view = visit("alpha")
    assert marks(view).count() == 0
    factor(view, "C23").hover()
    expect(marks(view)).to_have_count(2)
    expect(marks(view, 2).locator("text")).to_have_text("θ₂ = −30.0°")
    expect(marks(view, 3).locator("text")).to_have_text("θ₃ = 40.0°")
    expect(view.locator(".kl-pointed")).to_have_text("shoulder: θ₂ = −30.0°; elbow: θ₃ = 40.0°")
    for joint, held in enumerate([False, True, True, False, False], start=1):
        has_class(row(view, joint), "kl-held" if held else "kl-back")
    view.mouse.move(1, 1)
    expect(marks(view)).to_have_count(0)
    for joint in range(1, 6):
        lacks_class(row(view, joint), "kl-back")


def test_an_arc_goes_with_its_joint(visit):
    view = visit("alpha")
    row(view, 2).locator(".kl-field").focus()
    way = marks(view, 2).locator(".kl-mark-way")
    before = way.get_attribute("d")
    row(view, 2).locator(".kl-field").fill("90")
    row(view, 2).locator(".kl-field").press("Enter")
    expect(marks(view, 2).locator("text")).to_have_text("θ₂ = 90.0°")
    assert way.get_attribute("d") != before


def test_the_arc_is_where_the_arm_turns(visit):
    """Seen from the front, joint 2 of the Alpha II turns in the plane of the picture."""
    view = visit("alpha")
    view.get_by_role("button", name="Front", exact=True).click()
    for joint, degrees in ((1, 0), (2, -30)):
        row(view, joint).locator(".kl-field").fill(str(degrees))
        row(view, joint).locator(".kl-field").press("Enter")
    row(view, 2).hover(position={"x": 4, "y": 4})
    points = marks(view, 2).locator(".kl-mark-way").evaluate(
        "path => [0, 0.5, 1].map(s => path.getPointAtLength(s * path.getTotalLength()))"
        ".map(p => [p.x, p.y])")
    start, middle, end = map(np.array, points)
    # theta_2 = -30 lifts the link: from the level x axis, 30 degrees up, about one centre.
    chord = 2 * ARC * np.sin(np.radians(15))
    assert np.hypot(*(end - start)) == pytest.approx(chord, abs=0.3)
    assert end[1] < start[1]
    assert np.degrees(np.arctan2(*(end - start)[::-1])) == pytest.approx(-105, abs=0.5)
    assert np.hypot(*(middle - (start + end) / 2)) == pytest.approx(
        ARC * (1 - np.cos(np.radians(15))), abs=0.3)


def test_a_slide_is_a_dimension_line(visit):
    view = visit("exam")
    row(view, 3).hover(position={"x": 4, "y": 4})
    expect(marks(view)).to_have_count(1)
    assert marks(view, 3).get_attribute("data-part") == "dimension"
    expect(marks(view, 3).locator("text")).to_have_text("d₃ = 0.40 m")
    has_class(factor(view, "d3"), "kl-held")


def test_a_slider_lights_factors_entries_and_numbers_that_hold_it(visit):
    view = visit("exam")
    row(view, 3).hover(position={"x": 4, "y": 4})
    has_class(row(view, 3), "kl-held")
    # d_3 moves the origin and no axis: hand-typed from the closed form.
    for i in range(1, 4):
        for j in range(1, 5):
            name = "kl-held" if j == 4 else "kl-back"
            has_class(view.locator(f"td[data-entry='{i},{j}']"), name)
            has_class(view.locator(f".kl-math [data-entry='{i},{j}']"), name)
    for name in ("C1", "S2"):
        has_class(factor(view, name), "kl-back")


def test_what_steps_back_is_paler(visit):
    view = visit("exam")
    opacity = "node => Number(getComputedStyle(node).opacity)"
    row(view, 3).hover(position={"x": 4, "y": 4})
    has_class(row(view, 1), "kl-back")
    view.wait_for_function("""() => ['.kl-knob.kl-back', 'td.kl-back'].every(name =>
        Number(getComputedStyle(document.querySelector(name)).opacity) < 0.6)""")
    assert row(view, 3).evaluate(opacity) == 1


def test_the_keyboard_points(visit):
    view = visit("alpha")
    factor(view, "C1").focus()
    view.keyboard.press("ArrowRight")               # C1 C234 C5: a step on is C234
    expect(marks(view)).to_have_count(3)
    view.keyboard.press("Escape")
    expect(marks(view)).to_have_count(0)
    row(view, 5).locator("[type=range]").focus()
    view.keyboard.press("ArrowRight")
    expect(marks(view, 5).locator("text")).to_have_text("θ₅ = 61.0°")
    view.locator(".kl-picture").focus()
    for joint in (1, 2):
        view.keyboard.press("j")
        expect(marks(view, joint)).to_have_count(1)
    view.keyboard.press("Shift+J")
    expect(marks(view, 1)).to_have_count(1)


def test_a_formula_is_one_stop_of_the_tab_key(visit):
    view = visit("alpha")
    stops = view.locator("math [tabindex]").evaluate_all("nodes => nodes.map(n => n.tabIndex)")
    assert len(stops) > 20 and stops.count(0) == 1
    factor(view, "C1").focus()
    view.keyboard.press("ArrowRight")
    assert view.locator("math [tabindex='0']").get_attribute("data-factor") == "C234"


def test_a_finger_taps(visit):
    view = visit("alpha", has_touch=True, is_mobile=True)
    factor(view, "C23").tap()
    expect(marks(view)).to_have_count(2)
    row(view, 4).locator("span").first.tap()
    expect(marks(view, 4)).to_have_count(1)
    expect(marks(view)).to_have_count(1)
    view.locator(".kl-pose caption").tap()
    expect(marks(view)).to_have_count(0)


def test_a_hand_that_drags_points_at_nothing_else(visit):
    view = visit("alpha")
    x, y = view.locator(".kl-pose caption").evaluate(CENTRE)
    over = row(view, 3).locator("span").first.evaluate(CENTRE)
    view.mouse.move(x, y)
    view.mouse.down()
    view.mouse.move(*over, steps=5)
    view.wait_for_timeout(150)                      # longer than a hand has to rest
    assert not row(view, 3).evaluate("r => r.classList.contains('kl-held')")
    view.mouse.up()


FLASHED = """() => {
    window.flashes = {};
    new MutationObserver(changes => changes.forEach(({target, oldValue}) => {
        const at = target.getAttribute('data-entry');
        const was = (oldValue ?? '').includes('kl-flash');
        if (!was && target.classList.contains('kl-flash')) flashes[at] = (flashes[at] ?? 0) + 1;
    })).observe(document.body, {subtree: true, attributeFilter: ['class'],
                                attributeOldValue: true});
}"""


def test_entries_that_change_flash_once_in_a_movement(visit):
    view = visit("exam", fresh=True)
    view.clock.install()                            # so that a slow machine is no rest
    view.clock.pause_at(view.evaluate("Date.now() + 1000"))
    view.evaluate(FLASHED)
    row(view, 3).locator("[type=range]").focus()

    def press(key):
        view.keyboard.press(key)
        view.clock.run_for(100)
        view.evaluate("""document.querySelectorAll('.kl-flash').forEach(
            node => node.dispatchEvent(new Event('animationend')))""")   # it is over by now
        return view.evaluate("flashes")

    for _ in range(6):
        flashed = press("ArrowRight")
    assert row(view, 3).locator(".kl-field").input_value() == "0.46"
    # At theta = 0 the approach vector is x: of the origin only that number changes. In the
    # formula all three entries hold d_3.
    assert flashed == {"1,4": 2, "2,4": 1, "3,4": 1}
    expect(view.locator(".kl-flash")).to_have_count(0)        # animationend has taken it away
    view.clock.run_for(600)                         # the joint has come to rest
    assert press("ArrowLeft")["1,4"] == 4


def test_nothing_flashes_when_a_view_appears(visit):
    view = visit("alpha")
    assert view.locator(".kl-flash").count() == 0


def test_no_flash_for_those_who_want_less_motion(visit):
    view = visit("exam", reduced_motion="reduce")
    view.evaluate(FLASHED)
    row(view, 3).locator("[type=range]").focus()
    view.keyboard.press("ArrowRight")
    expect(row(view, 3).locator(".kl-field")).to_have_value("0.41")
    view.wait_for_timeout(100)
    assert view.evaluate("flashes") == {}


def test_a_term_of_the_text_lights_the_nearest_view_that_has_it(visit):
    page_ = visit("lesson")
    planar, alpha = page_.locator(".kl-view").nth(0), page_.locator(".kl-view").nth(1)
    page_.locator("#term").hover()                  # the planar arm has no joint 3
    expect(marks(alpha)).to_have_count(2)
    assert marks(planar).count() == 0
    page_.mouse.move(1, 1)
    expect(marks(alpha)).to_have_count(0)
    page_.locator("#term").focus()
    expect(marks(alpha)).to_have_count(2)
    page_.locator("#none").focus()
    expect(marks(alpha)).to_have_count(0)


def test_a_clicked_term_keeps_the_address_and_shows_its_view(visit):
    page_ = visit("lesson", viewport={"width": 1280, "height": 500})
    alpha = page_.locator(".kl-view").nth(1)
    address = page_.url
    page_.locator("#term").click()
    expect(marks(alpha)).to_have_count(2)
    expect(alpha).to_be_in_viewport()
    page_.mouse.move(1, 1)
    expect(marks(alpha)).to_have_count(2)           # as long as the term has the focus
    page_.locator("#none").click()
    expect(marks(alpha)).to_have_count(0)
    assert page_.url == address


def test_names_that_a_mouse_is_told_are_names_for_all(visit):
    view = visit("alpha")
    names = view.locator(".kl-pose th").evaluate_all("all => all.map(th => th.ariaLabel)")
    assert names == ["n, normal", "s, sliding", "a, approach", "p, position"]
    view.locator(".kl-picture").press("j")
    spoken = view.locator(".kl-spoken")
    assert spoken.get_attribute("role") == "status"
    expect(spoken).to_contain_text("base: θ₁ = 20.0°")


def test_quantities_have_their_colours_in_rows_and_formulas(visit):
    colour = "node => getComputedStyle(node).color"
    for scheme, angle, length in (("light", "rgb(122, 62, 157)", "rgb(138, 90, 0)"),
                                  ("dark", "rgb(199, 155, 232)", "rgb(217, 178, 95)")):
        view = visit("exam", color_scheme=scheme)
        assert row(view, 1).locator("span").first.evaluate(colour) == angle
        assert row(view, 3).locator("span").first.evaluate(colour) == length
        assert factor(view, "C1").evaluate(colour) == angle
        assert factor(view, "d3").evaluate(colour) == length
        link = visit("link", color_scheme=scheme).locator("[data-reading] .kl-number")
        assert [number.evaluate(colour) for number in link.all()] == [angle, length, length, angle]


def test_in_jupyterlab_rows_of_a_table_and_terms_of_the_text_point(notebook, tmp_path):
    cells = [nbformat.v4.new_code_cell("import kinlab as kl\n"
                                       "kl.DHTableEditor(kl.robots.exam_2018())"),
             nbformat.v4.new_markdown_cell("See [the slide](#kl:joint=3).")]
    path = tmp_path / "terms.ipynb"
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": KERNEL}), path)
    page = notebook(path)
    editor = page.locator(".jp-Notebook:visible .kl-editor")
    rows = editor.locator(".kl-dh tr[data-joint]")
    expect(rows).to_have_count(3)
    editor.locator(".kl-picture svg").wait_for()
    rows.nth(1).locator("th").hover()
    expect(marks(editor, 2)).to_have_count(1)
    has_class(rows.nth(1), "kl-held")
    has_class(rows.nth(0), "kl-back")
    has_class(row(editor, 1), "kl-back")
    row(editor, 3).hover(position={"x": 4, "y": 4})
    has_class(rows.nth(2), "kl-held")
    term = page.locator(".jp-Notebook:visible a", has_text="the slide")
    address = page.url
    term.click()
    expect(editor.locator(".kl-pointed")).to_contain_text("d₃ = ")
    assert page.url == address
