"""The same hands on the same pages in Firefox, in WebKit and in Chromium."""
import io
import itertools
import re
import zlib

import numpy as np
import pytest
from engines import A4, WATCH, engine_or_skip
from grades import every
from lesson_views import VIEWS
from PIL import Image
from reading import READ, assert_picture, assert_table, at_rest, from_units
from test_predictions import prediction

import kinlab as kl

ALPHA = kl.robots.alpha_ii
HOME = (-60, 24, 1)
# One of each kind that a page can show.
KINDS = {"spatial": lambda: kl.ArmView(ALPHA(), closed_form=True),
         "plane": lambda: kl.ArmView(kl.robots.two_link()),
         "slides": lambda: kl.ArmView(kl.robots.cylindrical()),
         "target": lambda: kl.TargetView(kl.robots.two_link(), [0.3, 0.9]),
         "cloud": kl.lessons.workspace.reach_view,
         "number": lambda: prediction("number"), "choice": lambda: prediction("choice"),
         "mark": lambda: prediction("mark"), "signs": lambda: prediction("signs")} | {
    kind: VIEWS[kind] for kind in (
        "solve", "velocity", "stages", "all frames", "limits", "parameters", "path", "gimbal")}
ALL = VIEWS | {"exam": kl.lessons.dh_practice.exam_view}
FIELDS = """() => [...document.querySelectorAll('.kl-field')]
    .filter(field => field.checkVisibility()).map(field => Number(field.value))"""
SLIDER = "document.querySelectorAll('.kl-knob [type=range]')"
SHOWN = "() => document.querySelector('.kl-picture svg, .kl-predict') != null"


@pytest.fixture(scope="module", params=[
    "firefox", "webkit", pytest.param("chromium", marks=pytest.mark.thorough)])
def engine(request):
    yield from engine_or_skip(request.param)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("engines")


@pytest.fixture
def visit(engine, folder):
    """A function that opens the page of a view, which then must not report any trouble."""
    opened = []

    def visit(kind, *, end="", size=(1280, 800), make=None):
        path = folder / f"{kind}.html"
        if not path.exists():
            (make or KINDS[kind])().save_html(path)
            text = path.read_text(encoding="utf-8")
            path.write_text(text.replace("<head>", f"<head>{WATCH}", 1), encoding="utf-8")
        engine.resize(*size)
        engine.open(path.as_uri() + end)
        engine.wait(SHOWN)
        engine.settle()
        opened.append(engine)
        return engine

    yield visit
    for page in opened[-1:]:
        assert not page.errors()


def seen(page):
    """What the view shows once it rests: READ of reading.py."""
    page.evaluate(at_rest(PAINTED))
    return page.evaluate(f"() => ({READ})(document.querySelector('.kl-view'))")


def stands_at(page, i, value):
    page.wait(f"(i, value) => ({FIELDS})()[i] === value", i, value)


# ---- every kind of view ----

PAINTED = """() => [...document.querySelectorAll('.kl-picture svg g[id] path')]
    .map(path => path.getAttribute('d'))"""
FITS = """() => [...document.querySelectorAll('html, .kl-side, .kl-picture, .kl-toolbar')]
    .filter(node => node.scrollWidth > node.clientWidth + 1)
    .map(node => node.className || 'page')"""
MOVABLE = f"""() => [...{SLIDER}].findIndex(range => range.checkVisibility() && !range.disabled)"""


def moves(page):
    """A key on the first slider that moves changes its number and the picture."""
    k = page.evaluate(MOVABLE)
    before = page.evaluate(f"() => ({PAINTED})().join()")
    page.evaluate(f"k => {SLIDER}[k].focus()", k)
    low = page.evaluate(f"k => {SLIDER}[k].value >= ({SLIDER}[k].max - {SLIDER}[k].min) / 2 + "
                        f"Number({SLIDER}[k].min)", k)
    page.press("PageDown" if low else "PageUp")
    page.wait(f"before => ({PAINTED})().join() !== before", before)


def assert_shown(page, kind):
    box = page.box(".kl-view")
    assert box[3] > 150, kind
    assert page.evaluate(FITS) == [], kind
    if page.evaluate("() => document.querySelector('.kl-picture') != null"):
        assert sum(map(bool, page.evaluate(PAINTED))) > 3, kind
        assert page.box(".kl-picture")[3] > 200
    if page.evaluate(MOVABLE) >= 0:
        moves(page)


@pytest.mark.parametrize("kind", every(4, KINDS))
def test_a_view_of_each_kind_is_drawn_and_moves(visit, kind):
    page = visit(kind, size=(390, 844))
    assert_shown(page, kind)


@pytest.mark.thorough
@pytest.mark.parametrize("kind", ALL)
def test_every_view_is_drawn_and_moves(visit, kind):
    page = visit(f"every {kind}", make=ALL[kind])
    assert_shown(page, kind)


# ---- hands ----


def test_a_slider_is_dragged_and_picture_and_table_follow(visit):
    page = visit("spatial")
    for i, share in ((0, 0.72), (2, 0.3)):
        x, y, width, height = page.box(".kl-knob [type=range]", i)
        at = page.evaluate(f"i => {{ const s = {SLIDER}[i];"
                           " return (s.valueAsNumber - s.min) / (s.max - s.min); }", i)
        page.drag([(x + part * width, y + height / 2) for part in np.linspace(at, share, 6)])
    values = page.evaluate(FIELDS)
    assert values[0] > 40 and values[2] < -20
    assert values == [round(value) for value in values]   # a hand stops at whole steps
    now, q = seen(page), from_units(ALPHA, values)
    assert_picture(now, ALPHA, q, HOME)
    assert_table(now, ALPHA, q, 1)


def test_the_picture_turns_and_zooms(visit):
    page = visit("spatial")
    x, y, width, height = page.box(".kl-picture")
    beside = x + 0.25 * width, y + 0.9 * height
    page.drag([beside, (beside[0] + 20, beside[1]), (beside[0] + 40, beside[1] + 10)])
    assert_picture(seen(page), ALPHA, ALPHA().home, (-80, 29, 1))
    page.turn_wheel(beside, -120)
    assert_picture(seen(page), ALPHA, ALPHA().home, (-80, 29, np.exp(0.18)))
    page.press("0", "ArrowRight", "ArrowUp", on=".kl-picture")
    assert_picture(seen(page), ALPHA, ALPHA().home, (-65, 29, 1))


def test_a_link_is_dragged_and_stays_under_the_hand(visit):
    page = visit("plane", end="#q=20,50")
    first, second = page.evaluate(FIELDS)
    spot = page.middle("#link-2-0 path")
    to = spot[0] - 50, spot[1] + 10
    page.drag([spot, (spot[0] - 25, spot[1] + 5), to])
    now = page.evaluate(FIELDS)
    assert now[0] == first and now[1] > second + 10
    assert_picture(seen(page), kl.robots.two_link, np.radians(now), (-90, 90, 1))


def test_keys_of_sliders_and_numbers(visit):
    page = visit("slides")
    for key, value in {"ArrowRight": 1, "Shift+ArrowUp": 1.1, "PageUp": 11, "ArrowLeft": 10,
                       "Shift+ArrowDown": 9.9, "Home": -180, "End": 180}.items():
        page.press(key, on=".kl-knob [type=range]")
        assert page.evaluate(FIELDS)[0] == value, key
    page.press(*"12,34", "Enter", on=".kl-field")
    assert page.evaluate(f"() => {SLIDER}[0].valueAsNumber") == pytest.approx(12.34)
    page.evaluate("() => document.querySelectorAll('.kl-field')[1].focus()")
    page.press("Control+a", *"99", "Tab")
    assert page.evaluate(FIELDS)[1] == 0.6
    page.wait("() => /d₂ is at its limit, 0.6 m/.test("
              "document.querySelector('.kl-remark').textContent)")


def test_handles_are_moved_by_keys_and_the_move_is_taken_back(visit):
    page = visit("plane")
    before = page.evaluate(FIELDS)
    page.press("Enter", on=".kl-picture")
    assert page.evaluate("() => document.activeElement.className") == "kl-hold"
    page.press("ArrowLeft", "ArrowLeft")
    assert page.evaluate(FIELDS) != before
    page.press("Control+z", "Control+z", "Escape")
    assert page.evaluate(FIELDS) == before
    assert page.evaluate("() => document.activeElement.className").startswith("kl-picture")


def test_an_arm_follows_a_target_under_a_finger(visit):
    page = visit("target", size=(390, 844))
    before, dot = page.evaluate(FIELDS), page.middle("#target-0 path")
    page.touch([np.add(dot, step) for step in ((0, 0), (-45, 30), (-90, 60))])
    page.wait("() => / 0.000 m/.test(document.querySelector('.kl-readings').textContent)")
    theta_1, theta_2, x, y = page.evaluate(FIELDS)
    left, down = np.subtract(before[2:], (x, y))
    assert left > 0.4 and left / down == pytest.approx(90 / 60, rel=0.3)   # they are rounded
    tool = kl.forward_kinematics(kl.robots.two_link(), np.radians([theta_1, theta_2]))[:2, 3]
    np.testing.assert_allclose(tool, [x, y], atol=0.06)


def test_two_fingers_zoom(visit):
    page = visit("spatial", size=(390, 844))
    if page.name == "webkit":
        pytest.skip("WebKitGTK's driver has no fingers, and events that are told have no pointer")
    x, y, _, height = page.box(".kl-picture")
    x, y = x + 150, y + 0.85 * height
    page.touch([(x, y), (x - 25, y)], [(x + 50, y), (x + 75, y)])
    assert_picture(seen(page), ALPHA, ALPHA().home, (-60, 24, 2))


# ---- what is seen ----


def test_formulas_are_laid_out(visit):
    page = visit("spatial")
    boxes = page.evaluate("""() => {
        const box = node => { const {x, y, right, bottom, width, height}
            = node.getBoundingClientRect(); return {x, y, right, bottom, width, height}; };
        const rows = [...document.querySelectorAll('.kl-math mtable')[0].children];
        const [letter, index] = document.querySelector('.kl-math msub').children;
        return { rows: rows.map(row => [...row.children].map(box)), letter: box(letter),
                 index: box(index),
                 size: parseFloat(getComputedStyle(index).fontSize) };
    }""")
    rows, letter, index = boxes["rows"], boxes["letter"], boxes["index"]
    assert len(rows) == 4 and all(len(row) == 4 for row in rows)
    for above, below in itertools.pairwise(rows):
        assert above[0]["bottom"] <= below[0]["y"] + 1
    for row in rows:
        assert all(a["right"] <= b["x"] + 1 for a, b in itertools.pairwise(row))
    assert np.ptp([row[3]["x"] for row in rows]) < 2
    assert index["x"] >= letter["right"] - 2 and index["bottom"] > letter["bottom"] + 1
    assert boxes["size"] >= 12
    page.press("ArrowRight", on=".kl-knob [type=range]")
    page.settle()
    assert page.evaluate(SEEN, ".kl-columns button") == 0   # the whole matrix has its place


def test_dark_where_the_system_is_dark(visit, engine):
    paint = """() => [getComputedStyle(document.querySelector('.kl-view')).backgroundColor,
        getComputedStyle(document.querySelector('.kl-x path')).stroke]"""
    try:
        engine.look("dark")
        page = visit("spatial")
        assert page.evaluate(paint) == ["rgb(17, 20, 23)", "rgb(255, 138, 61)"]
        assert max(colours(page, *page.middle(".kl-pose td"))[0]) < 60
        page = visit("choice")
        assert max(colours(page, *page.middle(".kl-option input"), 2)[0]) < 60   # not chosen
        page.press("Space", on=".kl-option input")
        x, y = page.middle(".kl-option input")
        assert colours(page, x - 6, y, 1)[0] == (86, 180, 233)
    finally:
        engine.look("light")
    page = visit("spatial")
    assert page.evaluate(paint) == ["rgb(255, 255, 255)", "rgb(213, 94, 0)"]


def colours(page, x, y, around=12):
    """The colours near a spot of the window, the most frequent first."""
    photo = Image.open(io.BytesIO(page.photo())).convert("RGB")
    near = photo.crop((int(x) - around, int(y) - around, int(x) + around, int(y) + around))
    return [colour for _, colour in sorted(near.getcolors(10_000), reverse=True)]


def test_what_is_pointed_at_is_tinted(visit):
    page = visit("spatial")
    page.press("Shift+Tab", "Tab", on=".kl-knob [type=range]")
    page.wait("() => document.querySelector('.kl-pose td.kl-held') != null")
    page.wait("() => document.getAnimations().length === 0")
    red, green, blue = colours(page, *page.middle(".kl-pose td.kl-held"))[0]
    assert red > 240 and 215 < green < 245 and blue < 215, (red, green, blue)


def test_a_slider_looks_alike_everywhere(visit):
    page = visit("plane", end="#q=90,0")
    x, y, width, height = page.box(".kl-knob [type=range]")
    photo = Image.open(io.BytesIO(page.photo())).convert("RGB")
    accent, rest = (0, 114, 178), (213, 218, 224)
    at = page.evaluate(f"() => {{ const {{value, min, max}} = {SLIDER}[0];"
                       " return (value - min) / (max - min); }")
    handle = 11 + at * (width - 22)
    for part, colour in ((6, accent), (handle, accent), (handle + 6, accent), (handle + 16, rest),
                         (width - 6, rest)):
        assert photo.getpixel((round(x + part), round(y + height / 2))) == colour, part
    assert photo.getpixel((round(x + handle), round(y + height / 2 - 6))) == accent
    assert photo.getpixel((round(x + 6), round(y + height / 2 - 6))) == (255, 255, 255)


SEEN = """selector => [...document.querySelectorAll(selector)].filter(
    node => node.checkVisibility() && node.getBoundingClientRect().width > 20).length"""
SHEET = """() => {
    const cut = [], sheet = document.documentElement.clientWidth;
    for (const node of document.querySelectorAll('.kl-picture, .kl-pose td, .kl-field, .kl-entry,'
                                                 + '.kl-math > math, .kl-readings, h1')) {
        const {left, right} = node.getBoundingClientRect();
        if (node.checkVisibility() && (left < -1 || right > sheet + 1)) cut.push(node.className
            || node.tagName);
    }
    return cut;
}"""


def test_on_paper_is_what_can_be_seen_and_nothing_is_cut(visit):
    page = visit("spatial", size=A4)
    try:
        page.paper(True)
        page.evaluate("() => dispatchEvent(new Event('beforeprint'))")
        for selector in (".kl-toolbar", ".kl-page-foot", ".kl-knob [type=range]"):
            assert page.evaluate(SEEN, selector) == 0, selector
        for selector in (".kl-picture svg", ".kl-pose", ".kl-math math", ".kl-field"):
            assert page.evaluate(SEEN, selector) > 0, selector
        assert page.evaluate(SHEET) == []
    finally:
        page.evaluate("() => dispatchEvent(new Event('afterprint'))")
        page.paper(False)
    if page.name == "webkit":
        return                                            # it prints nothing without a window
    whole = unpacked(page.pdf())
    assert re.findall(rb"/Count (\d+)", whole) == [b"1"]
    page.evaluate("() => document.querySelectorAll('.kl-picture text').forEach(t => t.remove())")
    wordless = unpacked(page.pdf())
    page.evaluate("() => document.querySelector('.kl-picture svg').replaceChildren()")
    bare = unpacked(page.pdf())
    assert len(bare) + 5000 < len(wordless) < len(whole) - 5000   # bodies and names are printed


def unpacked(pdf):
    """A PDF with what it has packed."""
    packed = re.findall(rb"stream\r?\n(.*?)\r?\nendstream", pdf, re.DOTALL)
    return pdf + b"".join(zlib.decompressobj().decompress(one) for one in packed
                          if one[:1] == b"x")


# ---- questions, addresses, the screen ----


def test_a_number_is_asked_and_judged(visit):
    page = visit("number")
    page.press(*"pi/4", on=".kl-predict .kl-field")
    page.click(".kl-commit")
    page.wait("() => document.querySelector('.kl-told').textContent.includes('That is half')")
    assert "You said 45°, 45° off." in page.text(".kl-told")


def test_a_choice_is_made_by_keys(visit):
    page = visit("choice")
    page.press("Space", "ArrowDown", "Tab", "Enter", on=".kl-option input")
    page.wait("() => document.activeElement.textContent.includes('Right.')")
    assert page.evaluate("() => document.querySelectorAll('.kl-option :disabled').length") == 3


def test_a_mark_is_dragged_and_measured(visit):
    page = visit("mark")
    spot = page.middle("#guess-dot path")
    to = spot[0] - 60, spot[1] - 60
    page.drag([spot, (spot[0] - 30, spot[1] - 30), to])
    page.settle()
    assert page.middle("#guess-dot path") == pytest.approx(to, abs=3)
    x, y = page.evaluate(FIELDS)
    page.click(".kl-commit")
    page.wait("() => document.querySelector('.kl-told').textContent.includes('away')")
    said = re.search(r"is ([\d.]+) m away", page.text(".kl-told"))
    assert float(said[1]) == pytest.approx(np.hypot(x, y - 2), abs=0.1)   # the fields are rounded


def test_the_address_sets_the_joints_and_follows_them(visit):
    page = visit("spatial", end="#q=30,40,-20,0,5.5")
    assert page.evaluate(FIELDS) == [30, 40, -20, 0, 5.5]
    page.press("ArrowRight", on=".kl-knob [type=range]")
    page.wait("() => location.hash === '#q=31,40,-20,0,5.5'")
    page.click("[aria-label=Share] button")
    page.wait("() => /#q=31,40,-20,0,5.5/.test(document.querySelector('.kl-remark').textContent)")


def test_it_fills_the_screen(visit):
    page = visit("spatial")
    page.click("[aria-label=Screen] button")
    page.wait("() => document.fullscreenElement != null")
    page.wait("() => document.querySelector('.kl-picture').getBoundingClientRect().height"
              " > 0.6 * innerHeight")
    page.click("[aria-label=Screen] button")
    page.wait("() => document.fullscreenElement == null")
    page.look("light")   # WebKit's window has its toolbar again: it needs another one


def test_play_goes_from_pose_to_pose(visit):
    page = visit("spatial")
    page.click("[data-part=play]")
    page.wait(f"() => ({FIELDS})()[0] !== 0")
    page.click("[data-part=play]")
    page.wait("() => document.querySelector('[data-part=play]').textContent.includes('Play')")
