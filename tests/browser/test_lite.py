"""The course in JupyterLite: built, served on this machine, and used with the network off."""
import json
import os
import shutil

import nbformat
import pytest
from access import violations
from lite_site import (
    OPEN,
    RUN,
    SECONDS,
    build,
    open_lesson,
    pyodide,
    python,
    run_all,
    served,
    tools,
)
from playwright.sync_api import expect

from kinlab.course import site
from kinlab.course.handout import FOLDER

pytestmark = pytest.mark.thorough
COURSE = [FOLDER / f"{name}.ipynb" for name in (
    "00_start_here", "02_rotation", "07_alpha_ii", "09_workspace")]
ROTATION = "02_rotation.ipynb"
VIEW = "import kinlab as kl\n\nview = kl.ArmView(kl.robots.alpha_ii())\nview"
# JupyterLab's own: front ends built for another of its versions work with this one.
FRONT = ".jp-NotebookPanel:not(.lm-mod-hidden) "


@pytest.fixture(scope="module")
def made(tmp_path_factory, pytestconfig):
    """The folder with pages and JupyterLite, and what the command said."""
    try:
        folder = pyodide(pytestconfig.cache.mkdir("lite"))
        tool = tools(tmp_path_factory.mktemp("tools"))
    except AssertionError as error:
        if os.environ.get("KINLAB_REQUIRE_BROWSER") == "1":
            pytest.fail(f"KINLAB_REQUIRE_BROWSER=1 but Pyodide or JupyterLite is missing: {error}")
        pytest.skip("no Pyodide or JupyterLite here, and neither can be downloaded")
    out = tmp_path_factory.mktemp("lite") / "course"
    site.build(out, COURSE)
    return out, build(tool, out, "--pyodide", folder), tool


@pytest.fixture(scope="module")
def address(made):
    with served(made[0]) as address:
        yield address


@pytest.fixture
def page(browser, address, watched):
    """A fresh browser's page; a request that leaves this machine fails the test."""
    beyond = []

    def guard(route):
        if route.request.url.startswith(address):
            return route.continue_()
        beyond.append(route.request.url)
        route.abort()

    context = browser.new_context(viewport={"width": 1280, "height": 900})
    context.route("**/*", guard)
    page = watched(context.new_page())
    page.set_default_timeout(1000 * SECONDS)
    expect.set_options(timeout=1000 * SECONDS)
    yield page
    expect.set_options(timeout=5000)
    context.close()
    assert beyond == []


@pytest.fixture
def published(made):
    """A function that publishes a lesson with another text; afterwards it is as it was."""
    out, before = made[0], {}

    def publish(name):
        for path in (out / "files" / name, out / "lab" / "index.html"):
            before[path] = path.read_text(encoding="utf-8")
        notebook = nbformat.read(out / "files" / name, as_version=4)
        old = notebook.metadata.kinlab["edition"]
        notebook.cells[0].source += "\n\nThis is new."
        notebook.metadata.kinlab["edition"] = "another"
        nbformat.write(notebook, out / "files" / name)
        page = out / "lab" / "index.html"
        page.write_text(before[page].replace(old, "another"), encoding="utf-8")

    yield publish
    for path, text in before.items():
        path.write_text(text, encoding="utf-8")


def fill(page, cell, source):
    """Type into a cell, by its name."""
    page.evaluate("""([id, source]) => {
        const {model} = jupyterapp.shell.currentWidget.content;
        [...model.cells].find(cell => cell.id === id).sharedModel.setSource(source);
    }""", [cell, source])


def run(page, cell, source):
    """Run a cell, by its name, with another text."""
    fill(page, cell, source)
    page.evaluate("""id => {
        const {content} = jupyterapp.shell.currentWidget;
        content.activeCellIndex = [...content.model.cells].findIndex(cell => cell.id === id);
        return jupyterapp.commands.execute('notebook:run-cell');
    }""", cell)


def hears(page, code, wanted):
    """Wait until a piece of code prints what is wanted."""
    page.wait_for_function(f"([code, wanted]) => ({RUN})(code).then(said => said === wanted)",
                           arg=[code, wanted])


def text_of_first_cell(page):
    return page.evaluate("jupyterapp.shell.currentWidget.content.model.cells.get(0)"
                         ".sharedModel.source")


def saved(page):
    page.evaluate("jupyterapp.commands.execute('docmanager:save')")


def test_a_lesson_is_run_moved_answered_and_judged(page, address):
    open_lesson(page, address, ROTATION)
    fill(page, "exercise-2", "R_01 = [[0.6, -0.8], [0.8, 0.6]]")
    fill(page, "exercise-3", "c_1 = [-1, 2]")
    fill(page, "predict-riding", 'riding = kl.predict("rotation.riding")\nriding')
    run_all(page)
    verdicts = page.locator(f"{FRONT} .jp-OutputArea").filter(has_text="Correct")
    expect(verdicts.first).to_be_attached()
    expect(page.locator(FRONT).get_by_text("in another order")).to_be_attached()

    view = page.locator(f"{FRONT} .kl-view").filter(has_text="c is fixed in frame 1").first
    view.get_by_label("x of your mark, number").fill("-0.5")
    view.get_by_label("x of your mark, number").press("Enter")
    view.get_by_label("y of your mark, number").fill("1.2")
    view.get_by_label("y of your mark, number").press("Enter")
    view.get_by_role("button", name="Commit").click()
    expect(view.get_by_role("status").filter(has_text="Right.")).to_be_visible()
    assert "Right." in python(page, "print(riding.told.said)")


def test_an_arm_moves_by_the_keys_and_python_hears_of_it(page, address):
    open_lesson(page, address, "07_alpha_ii.ipynb")
    fill(page, "arm", "arm = kl.robots.alpha_ii()\nview = kl.ArmView(arm)\nview")
    run_all(page)
    assert page.locator(f"{FRONT} .kl-picture svg").count() > 5
    assert python(page, "print(view.theta_1)") == "0.0\n"
    moved(page)
    hears(page, "print(view.theta_1 > 0)", "True\n")
    assert violations(page, f"{FRONT} .kl-view") == []


def moved(page):
    """Move the first view's first joint by a key, and see that its picture follows."""
    view = page.locator(f"{FRONT} .kl-view").first
    picture = view.locator(".kl-picture svg")
    before = picture.inner_html()
    view.get_by_role("slider").first.press("ArrowRight")
    expect(view.get_by_role("slider").first).not_to_have_value("0")
    page.wait_for_function("([node, before]) => node.innerHTML !== before",
                           arg=[picture.element_handle(), before])
    return view


def test_a_saved_view_moves_again_before_anything_is_run(page, address):
    open_lesson(page, address, ROTATION)
    run(page, "setup", VIEW)
    page.locator(f"{FRONT} .kl-view svg").first.wait_for()
    saved(page)
    page.goto("about:blank")  # and with it goes Python
    page.goto(f"{address}/lab/index.html?path={ROTATION}")
    page.locator(f"{FRONT} .kl-view svg").first.wait_for()
    expect(moved(page).get_by_text("Python no longer listens")).to_be_visible()
    expect(page.get_by_text("Loading widget")).to_have_count(0)


def test_a_lesson_that_is_closed_and_opened_again_still_tells_python(page, address):
    open_lesson(page, address, ROTATION)
    run(page, "setup", VIEW)
    page.locator(f"{FRONT} .kl-view svg").first.wait_for()
    saved(page)
    page.evaluate("jupyterapp.shell.currentWidget.dispose()")
    page.evaluate("""path => { jupyterapp.commands.execute('docmanager:open', {path}); }""",
                  ROTATION)
    page.wait_for_function(OPEN, arg=ROTATION)
    page.locator(f"{FRONT} .kl-view svg").first.wait_for()
    moved(page)
    hears(page, "print(view.theta_1 > 0)", "True\n")


def test_a_lesson_that_nobody_ran_has_pictures_with_words(page, address):
    open_lesson(page, address, ROTATION)
    picture = page.locator(f"{FRONT} .jp-RenderedImage img").first
    assert picture.get_attribute("alt").startswith("Picture of ")


def test_a_table_is_typed_and_python_has_the_arm(page, address):
    open_lesson(page, address, ROTATION)
    run(page, "setup", "import kinlab as kl\n\n"
                       "editor = kl.DHTableEditor(kl.robots.alpha_ii())\neditor")
    editor = page.locator(f"{FRONT} .kl-editor")
    length = editor.get_by_label("a₂, ", exact=False).and_(editor.locator(".kl-cell"))
    length.fill("200")
    length.press("Enter")
    hears(page, "print(editor.arm.links[1].a)", "200.0\n")
    assert violations(page, f"{FRONT} .kl-editor") == []


def test_on_a_phone_the_lesson_has_the_room_and_it_is_said_that_python_starts(page, address):
    page.set_viewport_size({"width": 390, "height": 844})
    page.goto(f"{address}/lab/index.html?path={ROTATION}")
    expect(page.get_by_text("Python is starting in this browser.")).to_be_visible()
    page.wait_for_function(OPEN, arg=ROTATION)
    expect(page.get_by_text("Python is starting in this browser.")).to_have_count(0)
    assert page.locator(FRONT).bounding_box()["width"] > 300
    page.get_by_role("tab", name="File Browser").click()
    expect(page.get_by_text("07_alpha_ii.ipynb")).to_be_visible()


def test_pictures_of_a_workspace_are_drawn(page, address):
    open_lesson(page, address, "09_workspace.ipynb")
    run_all(page)
    drawn = page.locator(f"{FRONT} .jp-RenderedImage img")
    expect(drawn.first).to_be_attached()


def test_a_fresh_copy_keeps_what_the_student_wrote(page, address):
    open_lesson(page, address, ROTATION)
    fill(page, "exercise-2", "R_01 = 'mine'")
    page.locator(FRONT).get_by_role("button", name="Fresh copy of this lesson").click()
    page.wait_for_function(OPEN, arg=ROTATION)
    tabs = page.get_by_role("tab").filter(has_text="02_rotation")
    expect(tabs).to_have_count(2)
    cells = "path => jupyterapp.serviceManager.contents.get(path, {content: true})" \
            ".then(file => JSON.stringify(file.content.cells))"
    kept, fresh = (page.evaluate(cells, path) for path in ("02_rotation my copy.ipynb", ROTATION))
    assert "R_01 = 'mine'" in kept and "R_01 = 'mine'" not in fresh


def test_a_saved_copy_says_when_a_newer_edition_is_there(page, address, published):
    open_lesson(page, address, ROTATION)
    fill(page, "exercise-2", "R_01 = 'mine'")
    saved(page)
    open_lesson(page, address, ROTATION)
    expect(page.get_by_text("newer version of this lesson")).to_have_count(0)

    published(ROTATION)
    open_lesson(page, address, ROTATION)
    assert "This is new." not in text_of_first_cell(page)
    expect(page.get_by_text("A newer version of this lesson is here.")).to_be_visible()
    assert violations(page, ".Toastify__toast-body") == []
    page.get_by_role("button", name="Fresh copy", exact=True).click()
    page.wait_for_function("""() => jupyterapp.shell.currentWidget?.content?.model?.cells?.get(0)
        ?.sharedModel.source.includes('This is new.')""")


def test_a_page_leads_to_its_lesson(page, address, made):
    page.goto(f"{address}/02_rotation.html")
    page.get_by_role("link", name="Run this lesson", exact=True).click()
    page.wait_for_function(OPEN, arg=ROTATION)
    assert not (made[0] / "02_rotation.html").read_text("utf-8").count("JupyterLab: open")


def test_the_front_page_stays_the_sites_and_the_site_is_small(made):
    out, said, _ = made
    assert "Course map" in (out / "index.html").read_text("utf-8")
    assert "begin here" in (out / "index.html").read_text("utf-8")
    whole = sum(path.stat().st_size for path in out.rglob("*") if path.is_file()
                and path.parent != out and (out / "static" / "pyodide") not in path.parents)
    assert whole < 40_000_000
    assert said.count("\n") >= 4


def test_a_folder_that_is_no_pyodide_is_refused_in_a_sentence(made, tmp_path):
    tool = made[2]
    (tmp_path / "old").mkdir()
    (tmp_path / "old" / "pyodide-lock.json").write_text(json.dumps(
        {"info": {"version": "0.23.4"}, "packages": {}}))
    shutil.copytree(made[0] / "static" / "pyodide", tmp_path / "part")
    (tmp_path / "part" / "pyodide.js").unlink()
    for name, words in {"none": "holds no readable pyodide-lock.json", "old": "Pyodide 0.23.4",
                        "part": "lacks pyodide.js"}.items():
        with pytest.raises(AssertionError, match=words) as error:
            build(tool, tmp_path / "out", "--pyodide", tmp_path / name)
        assert "Traceback" not in str(error.value)
    assert not (tmp_path / "out").exists()
