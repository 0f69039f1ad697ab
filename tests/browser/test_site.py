"""The site in a real browser, from the disk and with the network off: it moves and is readable."""
import numpy as np
import pytest
from grades import chosen
from playwright.sync_api import expect
from reading import SETTLE, assert_picture, assert_table, from_units, read

import kinlab as kl
from kinlab.course.notebooks import FOLDER

LESSONS = sorted(path.stem for path in FOLDER.glob("*.ipynb"))
HOME = (-60, 24, 1)
NEIGHBOUR = """(term, view) => {
    const all = [...document.querySelectorAll('.kl-view, a[href^="#kl:"]')]
        .filter(node => node === term || node.matches('.kl-view'));
    return Math.abs(all.indexOf(view) - all.indexOf(term)) === 1;
}"""
PATHS = """view => [...view.querySelectorAll('.kl-picture path')]
    .map(path => path.getAttribute('d')).join()"""


@pytest.fixture
def visit(lend, course_site, watched):
    """A function that opens a page of the site; any request beyond the folder fails the test."""
    beyond = []

    def guard(route):
        if route.request.url.startswith(course_site.as_uri()):
            return route.continue_()
        beyond.append(route.request.url)
        route.abort()

    def visit(name, width=1280, height=800, **options):
        page = watched(lend(offline=True, viewport={"width": width, "height": height}, **options))
        page.route("**/*", guard)
        page.goto((course_site / f"{name}.html").as_uri())
        return page

    yield visit
    assert beyond == []


def move_each(page):
    """Press an arrow key on the first slider of each view; how many pictures answer.

    A prediction is committed first, and a folded answer is opened.
    """
    answered = 0
    page.evaluate("document.querySelectorAll('details').forEach(one => { one.open = true; })")
    page.evaluate(SETTLE)
    for view in page.locator(".kl-view:has(.kl-picture svg)").all():
        if view.get_by_role("button", name="I do not know").count():
            view.get_by_role("button", name="I do not know").click()
            view.get_by_role("button", name="See it again").wait_for()
        before = view.evaluate(PATHS)
        view.locator("input[type=range]:visible").first.press("PageUp")
        page.evaluate(SETTLE)
        answered += view.evaluate(PATHS) != before
    return answered


def assert_fits_phones(page):
    for width in (390, 360):
        page.set_viewport_size({"width": width, "height": 844})
        assert page.evaluate("document.documentElement.scrollWidth") == width


@pytest.mark.parametrize("name", chosen(LESSONS, ["01_translation", "07_alpha_ii"]))
def test_a_lessons_views_move_its_formulas_are_drawn_and_it_fits_phones(visit, name):
    page = visit(name)
    views = page.locator(".kl-view:has(.kl-picture svg)").count()
    assert views and move_each(page) == views
    sizes = page.evaluate("""() => [...document.querySelectorAll('main math')]
        .filter(m => m.checkVisibility()).map(m => m.getBoundingClientRect())
        .map(box => Math.min(box.width, box.height))""")
    assert len(sizes) > 10 and min(sizes) > 2
    assert_fits_phones(page)


@pytest.mark.parametrize("name", chosen(
    [name for name in LESSONS if not name.startswith("appendix")], ["07_alpha_ii"]))
def test_every_term_of_a_lesson_lights_its_view(visit, name):
    """The view that stands right above or below it in the lesson, and no other."""
    page = visit(name)
    page.locator(".kl-picture svg").last.wait_for(state="attached")
    terms = page.locator("a[href^='#kl:']")
    assert terms.count() >= 2
    for term in terms.all():
        term.focus()
        page.evaluate(SETTLE)
        expect(page.locator(".kl-pointed:not(:empty)")).to_have_count(1)
        beside = page.locator(".kl-view:has(.kl-pointed:not(:empty))")
        assert term.evaluate(NEIGHBOUR, beside.element_handle()), term.get_attribute("href")
        assert beside.locator(".kl-picture .kl-dim").count() > 0, term.get_attribute("href")


def test_a_view_behind_a_fold_is_as_wide_as_any_other(visit):
    page = visit("01_translation", width=1920, height=1080)
    page.evaluate(SETTLE)
    before, after, column, summary = page.evaluate("""() => {
        const width = node => Math.round(node.getBoundingClientRect().width);
        const left = node => Math.round(node.getBoundingClientRect().left);
        const output = document.querySelector("main > .kl-output:has(> .kl-view)");
        const before = width(output), fold = document.createElement("details");
        fold.append(document.createElement("summary"));
        fold.open = true;
        output.before(fold);
        fold.append(output);
        return [before, width(output), left(document.querySelector("main > h1")),
            left(fold.firstChild)];
    }""")
    assert before == after > 1400
    assert column == summary


def test_an_arm_is_there_to_drag_on_the_front_page(visit):
    page, robot = visit("index"), kl.robots.alpha_ii
    assert_picture(read(page.locator(".kl-view")), robot, robot().home, HOME)
    page.get_by_role("slider").first.press("PageUp")
    q = from_units(robot, [10, 0, 0, -90, 0])
    assert_picture(read(page.locator(".kl-view")), robot, q, HOME)


def test_the_map_fits_phones(visit):
    assert_fits_phones(visit("index"))


def test_numbers_of_a_lesson_follow_its_arm(visit):
    page = visit("07_alpha_ii")
    view, robot = page.locator(".kl-view").last, kl.robots.alpha_ii
    asked = read(page.locator(".kl-view").first)
    assert_picture(read(view), robot, robot().home, HOME)
    for field, value in zip(view.locator(".kl-field").all(), [30, 40, -20, -60, 10]):
        field.fill(str(value))
        field.press("Enter")
    seen, q = read(view), from_units(robot, [30, 40, -20, -60, 10])
    assert_picture(seen, robot, q, HOME)
    assert_table(seen, robot, q, 1)
    assert read(page.locator(".kl-view").first) == asked  # views of one page are apart
    assert page.evaluate("location.hash") == ""


@pytest.mark.thorough
def test_a_reader_walks_through_the_course(visit):
    page, seen = visit("index"), []
    while page.locator("a[rel=next]").count():
        page.locator("a[rel=next]").first.click()
        page.wait_for_load_state()
        seen.append(page.url.rpartition("/")[2].removesuffix(".html"))
        assert len(seen) <= len(LESSONS)
    assert seen == LESSONS
    page.get_by_role("link", name="Course map").first.click()
    expect(page).to_have_title("Course map")
    page.get_by_role("link", name="02 Rotation").click()
    expect(page.locator("h1")).to_contain_text("A frame turns.")
    page.locator("h2").nth(1).hover()
    page.locator("h2").nth(1).get_by_role("link", name="This section").click()
    assert page.evaluate("document.querySelector(':target').tagName") == "H2"


def test_an_exercise_shows_its_task_and_where_it_is_checked(visit):
    page = visit("01_translation")
    heading = page.get_by_role("heading", name="Exercise 1", exact=False)
    expect(heading).to_be_visible()
    note = page.get_by_text("Checking needs JupyterLab: open notebooks/01_translation.ipynb")
    assert note.count() == 3


@pytest.mark.parametrize("scheme, ink", [("light", (43, 49, 56)), ("dark", (227, 231, 234))])
def test_text_and_code_are_readable_in_both_schemes(visit, scheme, ink):
    page = visit("07_alpha_ii", color_scheme=scheme)
    contrasts = page.evaluate("""() => {
        const light = (colour) => {
            const [r, g, b] = colour.match(/[\\d.]+/g).map(Number).map(v => v / 255)
                .map(v => v <= 0.04 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
            return 0.2126 * r + 0.7152 * g + 0.0722 * b;
        };
        const paper = (node) => {
            for (let at = node; at; at = at.parentElement) {
                const { backgroundColor } = getComputedStyle(at);
                if (!/, 0\\)$|0\\.\\d+\\)$/.test(backgroundColor)) return backgroundColor;
            }
        };
        return [...document.querySelectorAll('main :is(p, li, h2, td, pre span, a, math, button)')]
            .filter(node => node.checkVisibility() && node.textContent.trim())
            .map(node => {
                const pair = [getComputedStyle(node).color, paper(node)].map(light);
                return (Math.max(...pair) + 0.05) / (Math.min(...pair) + 0.05);
            });
    }""")
    assert min(contrasts) > 4
    colour = page.locator("main p").first.evaluate("p => getComputedStyle(p).color")
    assert colour == "rgb({}, {}, {})".format(*ink)


def test_a_lesson_prints_with_its_pictures_and_without_its_buttons(visit):
    page = visit("01_translation", color_scheme="dark")
    page.emulate_media(media="print", color_scheme="dark")
    assert not page.locator("nav").first.is_visible()
    assert not page.locator(".kl-toolbar").first.is_visible()
    assert page.locator(".kl-picture svg").first.is_visible()
    assert np.all(np.array(page.locator("body").evaluate(
        "b => getComputedStyle(b).color.match(/\\d+/g).map(Number)")) < 80)
