"""Who cannot see, or has no mouse, sees no motion or few colours: what they get of each page."""
import shutil

import nbformat
import numpy as np
import pytest
from access import stops, violations
from lab import set_theme
from lesson_views import path_view
from playwright.sync_api import expect
from reading import RESTED, settle
from test_predictions import ASKED, prediction
from test_site import visit  # noqa: F401  # the site's own

import kinlab as kl
from kinlab.course import doors
from kinlab.course.notebooks import FOLDER

SCHEMES = ["light", "dark"]
PAGES = ["index", *sorted(path.stem for path in FOLDER.glob("*.ipynb"))]
VIEWS = {
    "arm": lambda: kl.ArmView(kl.robots.alpha_ii(), closed_form=True),
    "target": lambda: kl.TargetView(kl.robots.two_link()),
    "link": lambda: kl.link_view(kl.robots.alpha_ii(), 2),
    "steps": lambda: kl.solve_view(kl.robots.two_link(), [1, 0.5, 0]),
    "path": path_view,
}


@pytest.fixture
def shown(browser, watched, tmp_path):
    """A function that shows a view in a page of its own; the page and the view's element."""
    pages = []

    def show(view, width=1280, height=800, **options):
        path = view.save_html(tmp_path / "view.html")
        pages.append(watched(browser.new_page(viewport={"width": width, "height": height},
                                              **options)))
        pages[-1].goto(path.as_uri())
        pages[-1].locator(".kl-view button").first.wait_for()
        pages[-1].evaluate(RESTED)
        return pages[-1], pages[-1].locator(".kl-view")

    yield show
    for page in pages:
        page.close()


def stop_clock(page):
    """Let time go on in the page only where a test says so, however fast the machine is."""
    page.clock.install(time="2030-01-01T00:00:00")
    page.clock.pause_at("2030-01-01T01:00:00")


# ---- axe-core ----


@pytest.mark.parametrize("name", VIEWS)
def test_nothing_is_wrong_in_a_page(shown, name):
    page, view = shown(VIEWS[name]())
    assert violations(page) == []
    for opener in view.locator("[aria-expanded]:visible").all():
        opener.click()
        assert violations(page) == []


@pytest.mark.parametrize("kind", ASKED)
def test_nothing_is_wrong_in_a_prediction(shown, kind):
    page, view = shown(prediction(kind), color_scheme="dark")
    assert violations(page) == []
    view.get_by_role("button", name="Commit").click()   # without an answer: a reason is told
    assert violations(page) == []
    if view.get_by_role("button", name="I do not know").count():
        view.get_by_role("button", name="I do not know").click()
    expect(view.locator(".kl-told")).to_be_focused()
    page.evaluate(RESTED)
    assert violations(page) == []


@pytest.mark.parametrize("theme", ["JupyterLab Light", "JupyterLab Dark"])
def test_nothing_is_wrong_in_a_view_and_an_editor_in_jupyterlab(live, theme):
    view, _ = live("import kinlab as kl\nkl.ArmView(kl.robots.alpha_ii(), closed_form=True)",
                       "kl.DHTableEditor(kl.robots.alpha_ii())", views=2)
    page, editor = view.page, view.page.locator(".jp-Notebook:visible .kl-editor")
    try:
        set_theme(page, theme)
        assert violations(page, ".jp-Notebook .kl-view") == []
        assert violations(page, ".kl-editor") == []
        for name in ("Limits, home", "Closed form", "Save, load", "+ Tool"):
            editor.get_by_role("button", name=name, exact=True).click()
        editor.locator(".kl-end .kl-cell").first.wait_for()
        cell = editor.locator(".kl-cell").first
        cell.fill("1,5")
        cell.press("Enter")
        expect(editor.locator(".kl-spoken").first).to_contain_text("One cell is wrong.")
        assert violations(page, ".kl-editor") == []
    finally:
        set_theme(page, "JupyterLab Light")


def opened(page):
    """The page with all that is folded in it opened, and all its views there."""
    page.evaluate("document.querySelectorAll('details').forEach(one => { one.open = true; })")
    page.evaluate(RESTED)
    return page


def test_nothing_is_wrong_in_the_sites_map_and_a_lesson(visit):  # noqa: F811
    for name in ("index", "07_alpha_ii"):
        assert violations(opened(visit(name))) == [], name


@pytest.mark.parametrize("scheme", SCHEMES)
def test_nothing_is_wrong_where_a_lesson_can_be_run_at_once(page, course_site, tmp_path, scheme):
    folder = shutil.copytree(course_site, tmp_path / "site")
    doors.say_so(folder)
    page.emulate_media(color_scheme=scheme)
    for name in ("index", "01_translation"):
        page.goto((folder / f"{name}.html").as_uri())
        expect(page.locator("a[href^='lab/']").first).to_be_visible()
        assert violations(opened(page)) == [], name


@pytest.mark.thorough
@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("width", [1280, 640])
@pytest.mark.parametrize("name", PAGES)
def test_nothing_is_wrong_in_any_page_of_the_site(visit, name, width, scheme):  # noqa: F811
    assert violations(opened(visit(name, width, color_scheme=scheme))) == []


# ---- the Tab key and the arrow keys ----


def test_the_buttons_of_a_view_are_one_stop(shown):
    page, view = shown(VIEWS["arm"]())
    names = stops(view)
    assert len(names) == 13  # picture, buttons, five sliders with their fields, formula
    assert names[0].startswith("Alpha II: picture") and names[1] == "Home"
    at = view.locator(":focus")
    view.get_by_role("button", name="Home").focus()
    for key, name in {"ArrowRight": "Zero", "End": "Which frames", "Home": "Home",
                      "ArrowLeft": "Which frames", "ArrowUp": "frame 5"}.items():
        page.keyboard.press(key)
        assert (at.get_attribute("aria-label") or at.inner_text()) == name, key
    page.keyboard.press("ArrowDown")
    expect(at).to_have_attribute("aria-label", "frame 0")
    page.keyboard.press("Escape")
    expect(at).to_have_text("Which frames")
    assert stops(view)[1] == "Which frames"  # where one was is where one comes back to
    at_list = view.get_by_label("Look along an axis")
    at_list.focus()
    page.keyboard.press("ArrowLeft")
    expect(at).to_have_text("Side")  # left and right leave a list; up and down are its own


def test_the_stop_is_never_at_what_is_hidden_or_cannot_be_pressed(shown):
    page, view = shown(VIEWS["arm"](), width=390)
    view.get_by_role("button", name="More").click()
    view.get_by_role("button", name="Trace").focus()
    assert stops(view)[1] == "Trace"
    view.get_by_role("button", name="More").click()
    expect(view.get_by_role("button", name="Trace")).to_be_hidden()
    settle(page)
    names = stops(view)
    assert names[1] == "More" and len(names) <= 14  # a formula column's buttons are a stop, too
    page.set_viewport_size({"width": 1280, "height": 800})
    trace, clear = (view.get_by_role("button", name=name) for name in ("Trace", "Clear"))
    trace.click()
    clear.focus()
    assert stops(view)[1] == "Clear"
    trace.evaluate("node => node.click()")           # which takes the focus of nobody
    expect(clear).to_be_disabled()
    assert stops(view)[1] == "Home"
    trace.focus()
    page.set_viewport_size({"width": 390, "height": 800})
    expect(trace).to_be_hidden()
    settle(page)
    assert stops(view)[1] == "Home"
    view.locator(".kl-columns button").last.focus()
    page.keyboard.press("Home")
    expect(view.locator(".kl-columns button").first).to_be_focused()


def test_the_row_buttons_of_an_editor_are_one_stop(live):
    (under,) = live("import kinlab as kl\nkl.DHTableEditor(kl.robots.alpha_ii())")
    page, editor = under.page, under.page.locator(".jp-Notebook:visible .kl-editor")
    table = editor.locator(".kl-dh")
    assert len(stops(table)) == 5 * 5 + 1  # a list and four cells in each row, and one button
    assert len(stops(editor)) < 50
    at = editor.locator(":focus")
    editor.get_by_role("button", name="θ₁ counts the other way").focus()
    for key, name in {"ArrowDown": "θ₂ counts the other way", "ArrowLeft": "Remove row 1",
                      "ArrowUp": "Remove row 5", "Home": "θ₁ counts the other way"}.items():
        page.keyboard.press(key)
        assert at.get_attribute("aria-label").startswith(name), key
    editor.get_by_role("button", name="Undo").or_(editor.get_by_label("Convention")).first.focus()
    page.keyboard.press("ArrowRight")
    expect(at).to_have_attribute("aria-label", "Angles")
    expect(editor.get_by_label("Convention")).to_have_value("standard")


# ---- what is heard ----

def test_a_drag_is_told_when_it_rests_and_only_then(shown):
    page, view = shown(VIEWS["arm"]())
    spoken, pose = view.locator(".kl-spoken"), view.locator(".kl-pose tbody")
    box = view.locator("input[type=range]").first.bounding_box()
    y, middle = box["y"] + box["height"] / 2, box["x"] + box["width"] / 2
    stop_clock(page)
    page.mouse.move(middle, y)
    page.mouse.down()
    before = pose.inner_text()
    for step in range(30):                           # 1.5 seconds
        page.mouse.move(middle + 3 * step, y)
        page.clock.run_for(50)
        assert spoken.inner_text() == ""
    assert pose.inner_text() != before
    page.mouse.up()
    page.clock.run_for(500)
    x, y, _ = pose.locator("tr > :last-child").all_inner_texts()[:3]
    assert spoken.inner_text() == f"tool at {x}, {y}, 215.0 mm"
    name = view.locator(".kl-picture svg").get_attribute("aria-label")
    assert name == f"Alpha II, tool at {x}, {y}, 215.0 mm"


@pytest.mark.parametrize("motion", ["reduce", "no-preference"])
def test_play_is_told_when_it_stops(shown, motion):
    page, view = shown(VIEWS["arm"](), reduced_motion=motion)
    stop_clock(page)
    view.get_by_role("button", name="Play").click()
    for _ in range(30):
        page.clock.run_for(100)
        assert view.locator(".kl-spoken").inner_text() == ""
    view.get_by_role("button", name="Pause").click()
    page.clock.run_for(500)
    assert view.locator(".kl-spoken").inner_text().startswith("tool at ")


def test_a_view_that_nobody_is_in_is_silent_but_for_its_remarks(shown):
    page, view = shown(VIEWS["arm"]())
    svg = view.locator(".kl-picture svg")
    before = svg.get_attribute("aria-label")
    page.evaluate("location.hash = '#q=10,0,0,-90,0'")   # somebody else moves it
    expect(svg).not_to_have_attribute("aria-label", before)
    assert view.locator(".kl-spoken").inner_text() == ""
    page.evaluate("location.hash = '#q=1'")
    expect(view.locator(".kl-spoken")).to_contain_text("The address should hold 5 numbers")


def test_what_is_said_to_a_prediction_is_heard(shown):
    _, view = shown(prediction("choice"))
    told = view.locator(".kl-told")
    assert told.get_attribute("role") == "status"
    view.get_by_role("button", name="Commit").click()
    expect(told).to_have_text("Choose one of them first.")
    view.get_by_label("b & c").check()
    view.get_by_role("button", name="Commit").click()
    expect(told).to_be_focused()  # what gets the focus is read
    expect(told).to_contain_text("Right.")


def test_a_verdict_is_a_status():
    verdict = kl.exercises.check("rotation.1", None)
    assert verdict._repr_html_().startswith('<div role="status"')


def test_pictures_of_a_notebook_that_nobody_has_run_have_their_words(notebook):
    path = FOLDER / "02_rotation.ipynb"
    page = notebook(path, run=False)
    pictures = page.locator(".jp-Notebook:visible .jp-RenderedImage img")
    pictures.first.wait_for()
    words = [output.metadata["image/png"]["alt"]
             for cell in nbformat.read(path, as_version=4).cells
             for output in cell.get("outputs", ()) if "image/png" in output.get("data", {})]
    heard = pictures.evaluate_all("all => all.map(picture => picture.alt)")  # cells come in turn
    assert heard and heard == words[:len(heard)]
    assert min(map(len, words)) > 40  # not "a picture": what is to be seen there


# ---- less motion, few colours, large letters ----

LABELS = "() => [...document.querySelectorAll('.kl-picture text')].map(t => t.outerHTML).join()"
# What the first knob is at, and where its labels are, in each picture of the next second.
FILM = f"""view => new Promise(done => {{
    const seen = [], field = view.querySelector('.kl-field');
    const look = () => {{
        seen.push([Number(field.value), ({LABELS})()]);
        if (seen.length < 40) requestAnimationFrame(look);
        else done(seen);
    }};
    requestAnimationFrame(look);
}})"""


@pytest.mark.parametrize("calm", [True, False])
def test_who_wants_less_motion_sees_the_arm_there_at_once(shown, calm):
    page, view = shown(VIEWS["arm"](), reduced_motion="reduce" if calm else "no-preference")
    field = view.locator(".kl-field").first
    field.fill("90")
    field.press("Enter")
    page.evaluate(RESTED)
    view.get_by_role("button", name="Home").evaluate("home => home.click()")
    film = view.evaluate(FILM)
    between = {value for value, _ in film} - {90.0, 0.0}
    assert bool(between) is not calm
    if calm:
        # One picture of the pose, and one with the names where they stay.
        assert len({labels for _, labels in film}) <= 3
        assert view.locator(".kl-flash").count() == 0
        assert view.evaluate("""view => view.getAnimations({ subtree: true }).length""") == 0


def test_who_wants_less_motion_sees_play_go_from_pose_to_pose(shown):
    page, view = shown(VIEWS["arm"](), reduced_motion="reduce")
    poses = {tuple(np.round(np.degrees(q), 1) + 0.0) for q in VIEWS["arm"]().scene["poses"]}
    stop_clock(page)
    view.get_by_role("button", name="Play").click()
    seen = set()
    for _ in range(40):
        page.clock.run_for(50)
        seen.add(tuple(page.evaluate(
            "[...document.querySelectorAll('.kl-field')].map(f => Number(f.value))")))
    assert len(seen) > 1 and seen <= {*poses, (0, 0, 0, -90, 0)}


@pytest.mark.parametrize("scheme", SCHEMES)
def test_few_colours_leave_picture_buttons_sliders_and_focus_to_be_seen(shown, scheme):
    page, view = shown(kl.lessons.workspace.limits_view(), color_scheme=scheme,
                       forced_colors="active")
    colour = """([node, name, pseudo]) => getComputedStyle(node, pseudo)[name]"""

    def look(selector, name, pseudo=None):
        return page.evaluate(colour, [view.locator(selector).first.element_handle(), name, pseudo])

    system = page.evaluate("""() => Object.fromEntries(['Highlight', 'HighlightText', 'CanvasText']
        .map(name => {
            document.body.insertAdjacentHTML('beforeend', `<i style="forced-color-adjust: none;
                color: ${name}">.</i>`);
            return [name, getComputedStyle(document.body.lastElementChild).color];
        }))""")
    paper = {"light": "rgb(255, 255, 255)", "dark": "rgb(17, 20, 23)"}[scheme]
    assert paper in look(".kl-picture", "backgroundImage")  # its own sky and paper
    assert system["Highlight"] in look(".kl-track", "backgroundImage")
    assert system["CanvasText"] in look(".kl-track", "backgroundImage")
    on, off = '.kl-button[aria-pressed="true"]', ".kl-button:not([aria-pressed])"
    page.goto(page.url)
    view.get_by_role("button", name="Play").click()
    assert look(on, "backgroundColor") == system["Highlight"] != look(off, "backgroundColor")
    assert look(on, "color") == system["HighlightText"]
    page.keyboard.press("ArrowLeft")
    assert look(":focus", "outlineColor") == system["Highlight"]
    assert look(":focus", "outlineStyle") == "solid"


# What is cut off at the side of the page, or lies over another control.
TROUBLES = """() => {
    const name = node => node.ariaLabel || node.textContent.trim() || node.className;
    const all = [...document.querySelectorAll('button, input, select, summary, .kl-pose, math')]
        .filter(node => node.checkVisibility() && !node.closest('.kl-pair'));
    const boxes = all.map(node => node.getBoundingClientRect());
    const cut = all.filter((node, k) => boxes[k].left < 0 || boxes[k].right > innerWidth);
    const over = all.flatMap((node, k) => all.slice(k + 1).filter((other, j) => {
        const a = boxes[k], b = boxes[k + 1 + j];
        return !node.contains(other) && Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1
            && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1;
    }).map(other => `${name(node)} over ${name(other)}`));
    const thin = [...document.querySelectorAll('input[type=range]')]
        .filter(node => node.checkVisibility() && node.clientWidth < 100);
    const wide = document.documentElement.scrollWidth > innerWidth ? ['the page'] : [];
    return [...cut.map(node => 'cut: ' + name(node)), ...over, ...wide,
            ...thin.map(node => 'thin: ' + name(node))];
}"""
LARGE = {"zoom": {"width": 640, "height": 400, "device_scale_factor": 2}, "letters": {}}


@pytest.mark.parametrize("how", LARGE)
@pytest.mark.parametrize("view", [VIEWS["arm"], kl.lessons.workspace.limits_view, VIEWS["link"],
                                  lambda: prediction("signs"), lambda: prediction("mark")])
def test_twice_as_large_everything_is_there_and_nothing_covers_another(shown, how, view):
    page, view = shown(view(), **LARGE[how])
    if how == "letters":
        page.evaluate("document.documentElement.style.fontSize = '200%'")
        page.evaluate(RESTED)
        size = view.locator(".kl-button").first.evaluate("b => getComputedStyle(b).fontSize")
        assert float(size[:-2]) > 24
    for more in view.get_by_role("button", name="More").all():
        if more.is_visible():
            more.click()
    assert page.evaluate(TROUBLES) == []
