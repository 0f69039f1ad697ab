"""A view in each host that brings its own environment: it shows, moves, and Python has the value.

JupyterLab as it is installed here is in all other browser tests; this one has it once more, so that
the same is asked of all hosts. docs/hosts.md has the table. Run with -s to see the releases.
"""
import re
import sys
from contextlib import contextmanager
from dataclasses import dataclass

import nbformat
import numpy as np
import pytest
from environments import NEEDED, PROJECT, oldest, python_with, version
from lab import run_all, start_lab
from playwright.sync_api import expect
from reading import READ, SETTLE, assert_picture, assert_table, middle, take

import kinlab as kl
from kinlab.course.notebooks import METADATA

pytestmark = pytest.mark.thorough
ALPHA = kl.robots.alpha_ii
LAB = PROJECT["optional-dependencies"]["lab"]
CONTENT = "window.jupyterapp?.shell.currentWidget?.content"
ACTIVE = f"{CONTENT}?.activeCellIndex"
CELLS = [
    "import ipywidgets\nimport kinlab as kl",
    "arm = kl.ArmView(kl.robots.alpha_ii(), closed_form=True)\narm",
    "said = ipywidgets.Label('nothing yet')\n"
    "def say(change):\n    said.value = f'Python has {change.new:g} degrees'\n"
    "arm.observe(say, 'theta_2')\nsaid",
    "editor = kl.DHTableEditor(kl.robots.two_link())\neditor",
    "typed = ipywidgets.Label('nothing yet')\n"
    "def tell(change):\n    typed.value = f'Python has a = {editor.arm.links[1].a:g}'\n"
    "editor.observe(tell, 'cells')\ntyped",
]


@dataclass(frozen=True)
class Host:
    """How a host is installed and opened."""

    app: str
    package: str
    requirements: tuple[str, ...] = ()  # none: it is here already

    def python(self):
        return python_with(*self.requirements) if self.requirements else sys.executable


HOSTS = {
    "jupyterlab": Host("jupyterlab", "jupyterlab"),
    "jupyterlab-oldest": Host("jupyterlab", "jupyterlab", (*oldest(NEEDED), *oldest(LAB))),
    "notebook": Host("notebook", "notebook", (*NEEDED, "notebook>=7")),
    "voila": Host("voila", "voila", (*NEEDED, "voila>=0.5", "ipykernel")),
}
every_host = pytest.mark.parametrize("host", HOSTS, scope="module", indirect=True)
every_notebook = pytest.mark.parametrize("host", [name for name in HOSTS if name != "voila"],
                                         scope="module", indirect=True)


@pytest.fixture(scope="module")
def host(request, browser, tmp_path_factory):
    """The page of a notebook with an arm and an editor, run in the host."""
    kind = HOSTS[request.param]
    root = tmp_path_factory.mktemp(request.param)
    cells = [nbformat.v4.new_code_cell(cell) for cell in CELLS]
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata=METADATA), root / "arm.ipynb")
    python = kind.python()
    print(f"\n{request.param}: {kind.package} {version(python, kind.package)}")
    with start_lab(root, python, kind.app) as server:
        page = browser.new_page(viewport={"width": 1280, "height": 900})
        page.goto(address(server, kind.app))
        if kind.app != "voila":
            wait_for_kernel(page)
            run_all(page)
        page.locator(".kl-editor .kl-picture svg").wait_for(timeout=120_000)
        yield page
        page.close()


def address(server, app):
    at = {"jupyterlab": "/lab/tree/arm.ipynb", "notebook": "/notebooks/arm.ipynb",
          "voila": "/"}[app]
    return f"{server.url}{at}?token={server.token}"


def wait_for_kernel(page):
    page.wait_for_function("window.jupyterapp?.shell.currentWidget?.sessionContext?.session"
                           "?.kernel?.status === 'idle'", timeout=120_000)


def arm_of(page):
    view = page.locator(".kl-view").first
    page.evaluate(f"{CONTENT}?.scrollToItem?.(1)")  # JupyterLab 4.2 hides cells that are far away
    view.scroll_into_view_if_needed()
    return view


def value(view):
    """What the field of the second joint says."""
    return float(view.locator(".kl-field").nth(1).input_value().replace("\u2212", "-"))


def heard(page, degrees):
    expect(page.get_by_text(re.compile(rf"^Python has {degrees:g} degrees$"))).to_be_visible(
        timeout=20_000)


@contextmanager
def cell_stays(page):
    """The notebook, where there is one, stays at its cell."""
    before = page.evaluate(ACTIVE)
    yield
    assert page.evaluate(ACTIVE) == before


@every_host
def test_arrow_keys_move_the_arm_and_python_has_the_value(host):
    view = arm_of(host)
    expect(view.locator("math mtable")).to_be_visible()
    slider = view.get_by_role("slider", name=re.compile("^θ₂")).first
    slider.focus()
    with cell_stays(host):
        for key in ["ArrowRight", "ArrowUp", "ArrowRight", "ArrowLeft", "ArrowDown", "ArrowUp"]:
            slider.press(key)
        assert value(view) == 2
        heard(host, 2)
        host.evaluate(SETTLE)
        seen = view.evaluate(READ)
        assert_picture(seen, ALPHA, np.radians([0, 2, 0, -90, 0]), (-60, 24, 1))
        assert_table(seen, ALPHA, np.radians([0, 2, 0, -90, 0]), 1)


@every_host
def test_the_mouse_moves_a_slider_and_the_picture_and_python_has_the_value(host):
    view = arm_of(host)
    slider = view.get_by_role("slider", name=re.compile("^θ₂")).first
    before = value(view)
    x, y = take(slider)
    host.mouse.down()
    host.mouse.move(x + 20, y, steps=4)
    host.mouse.up()
    assert value(view) != before
    heard(host, value(view))
    seen = picture(view)
    x, y = middle(view.locator(".kl-picture"))
    host.mouse.move(x, y)
    host.mouse.wheel(0, -200)
    host.evaluate(SETTLE)
    assert picture(view) != seen


@every_host
def test_arrow_keys_turn_the_picture(host):
    view = arm_of(host)
    box = view.locator(".kl-picture")
    box.focus()
    with cell_stays(host):
        for key in ["ArrowLeft", "ArrowUp"]:
            seen = picture(view)
            box.press(key)
            host.evaluate(SETTLE)
            assert picture(view) != seen


def picture(view):
    return view.evaluate(READ)["paths"]


@every_host
def test_a_cell_of_the_editor_is_typed_and_python_has_the_table(host):
    cell = host.get_by_label(re.compile("^a.*, row 2, m$"))
    cell.fill("0.75")
    cell.press("Enter")
    expect(host.get_by_text(re.compile("^Python has a = 0.75$"))).to_be_visible(timeout=20_000)


KEYS = ["ArrowDown", "ArrowRight", "b", "x"]
FOCUSED = """k => {
    const takes = "button, input, select, summary, a[href], [tabindex]";   // -1: by arrow keys
    const fields = "input[type=text], input:not([type]), textarea";
    const ours = [...document.querySelectorAll(".kl-editor, .kl-view, .kl-predict")]
        .flatMap(root => [...root.querySelectorAll(takes)])
        .filter((node, i, all) => all.indexOf(node) === i && node.checkVisibility()
                && !node.matches(fields));
    ours[k]?.focus();
    return k < ours.length ? document.activeElement === ours[k] : null;
}"""
CELLS_OF = "jupyterapp.shell.currentWidget.content.model.cells.length"


@every_notebook
def test_whatever_of_ours_has_the_focus_keeps_its_keys_from_the_notebook(host):
    """A notebook would go to another cell, put one in below, or cut this one out."""
    arm_of(host)
    cells, k, tried = host.evaluate(CELLS_OF), 0, 0
    while (focused := host.evaluate(FOCUSED, k)) is not None:
        if focused:
            with cell_stays(host):
                for key in KEYS:
                    host.keyboard.press(key)
            assert host.evaluate(CELLS_OF) == cells
            tried += 1
        k += 1
    assert tried > 40


@every_notebook
def test_the_notebook_is_still_saved_by_ctrl_s_when_a_view_has_the_focus(host):
    arm_of(host).locator(".kl-picture").focus()
    host.evaluate("jupyterapp.shell.currentWidget.context.model.dirty = true")
    host.keyboard.press("Control+s")
    host.wait_for_function("!jupyterapp.shell.currentWidget.context.model.dirty")


@every_notebook
def test_a_saved_notebook_shows_its_view_when_it_is_opened_again(host):
    host.evaluate("jupyterapp.commands.execute('docmanager:save')")
    host.wait_for_function("!jupyterapp.shell.currentWidget.context.model.dirty")
    host.reload()
    wait_for_kernel(host)
    host.locator(".kl-editor .kl-picture svg").wait_for(timeout=120_000)
    test_arrow_keys_turn_the_picture(host)
