"""One JupyterLab and one Chromium for all browser tests, and a notebook for each scenario."""
import os
import shutil
from contextlib import suppress
from itertools import chain

import nbformat
import pytest
from lab import (
    KERNEL,
    READY,
    open_browser,
    open_notebook,
    run_all,
    run_code,
    shut_down_kernels,
    start_lab,
)
from plain import LOAD, SOURCE
from playwright.sync_api import Error, expect
from reading import RESTED

expect.set_options(timeout=30_000)  # a busy machine takes its time
# JupyterLab's own, when a notebook is closed before its debugger has answered, and anywidget's,
# when a script has not been read within two seconds.
HARMLESS = ("Could not restore the debugger state", "[anywidget] Failed to initialize model.")
# As good as a new kernel, at a tenth of the time: a scenario begins where nothing is.
CLEAN = "from ipywidgets import Widget\nWidget.close_all()\n%reset -f"
SCENARIO = "scenario.ipynb"
ALIVE = """['idle', 'busy'].includes(
    jupyterapp.shell.currentWidget.sessionContext.session?.kernel?.status)"""


@pytest.fixture(scope="package")
def browser():
    """Chromium; where there is none, the tests skip unless KINLAB_REQUIRE_BROWSER is 1."""
    opened = open_browser()
    try:
        chromium = opened.__enter__()
    except Error as error:
        if os.environ.get("KINLAB_REQUIRE_BROWSER") == "1":
            pytest.fail(f"KINLAB_REQUIRE_BROWSER=1 but no Chromium starts: {error.message}")
        pytest.skip("no Chromium here: install the system's, or run `playwright install chromium`")
    yield chromium
    opened.__exit__(None, None, None)


@pytest.fixture(scope="package")
def root(tmp_path_factory):
    """The folder that JupyterLab shows."""
    return tmp_path_factory.mktemp("lab")


@pytest.fixture(scope="package")
def lab(root):
    """The server that all scenarios use."""
    with start_lab(root) as server:
        yield server


@pytest.fixture(scope="package")
def lab_page(browser, root, lab):
    """JupyterLab, opened once; each scenario opens its notebook in it."""
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    write(root / "first.ipynb", ["1 + 1"])
    open_notebook(page, lab, "first.ipynb")
    page.evaluate("jupyterapp.commands.execute('application:toggle-left-area')")
    yield page
    page.close()


@pytest.fixture
def watched():
    """A function that makes the test fail if a page reports an error of another beginning."""
    troubles, undo, harmless = [], [], [*HARMLESS]

    def watch(page, *allowed):
        harmless.extend(allowed)
        for event, hear in {"console": lambda m: m.type == "error" and troubles.append(m.text),
                            "pageerror": lambda error: troubles.append(str(error))}.items():
            page.on(event, hear)
            undo.append(lambda event=event, hear=hear: page.remove_listener(event, hear))
        return page

    yield watch
    for stop in undo:
        stop()
    assert [text for text in troubles if not text.startswith(tuple(harmless))] == []


@pytest.fixture(scope="package")
def pool(browser):
    """Pages that are free, by their options: an arm in a new page takes four times as long."""
    free = {}
    yield free
    for page in chain(*free.values()):
        page.close()


@pytest.fixture
def lend(browser, pool):
    """A function that lends a page of these options, which is swept for the next test.

    A clock or a function of Python stays in a page: who installs one asks for a `fresh` page.
    """
    lent, own = [], []

    def lend(fresh=False, **options):
        free = [] if fresh else pool.setdefault(repr(sorted(options.items())), [])
        page = free.pop() if free else browser.new_page(**options)
        if fresh:
            own.append(page)
        else:
            lent.append((page, options, free))
        return page

    yield lend
    for page in own:
        page.close()
    for page, options, free in lent:
        sweep(page, options)
        free.append(page)


def sweep(page, options):
    """Make a page as good as new, which was opened with these options."""
    page.mouse.up()
    with suppress(Error):  # a blank page has no storage
        page.evaluate("localStorage.clear()")
    page.goto("about:blank")
    page.unroute_all()
    page.context.unroute_all()
    page.emulate_media(media="null", color_scheme=options.get("color_scheme", "null"),
                       reduced_motion=options.get("reduced_motion", "null"))
    page.set_viewport_size(options.get("viewport", {"width": 1280, "height": 720}))


@pytest.fixture
def page(lend, watched):
    """A blank page, without Jupyter."""
    return watched(lend())


@pytest.fixture(scope="module")
def blank(browser):
    """A blank page with mount.js loaded as a module."""
    page = browser.new_page()
    page.evaluate(LOAD, SOURCE)
    yield page
    page.close()


@pytest.fixture
def notebook(lab_page, root, watched):
    """A function that opens code cells, or a notebook's file, in JupyterLab and runs them.

    The notebooks have one name, so JupyterLab connects the next one to the kernel of the last.
    """
    page = watched(lab_page)

    def open_cells(*cells, run=True):
        write(root / SCENARIO, cells)
        open_in(page, SCENARIO)
        if run:
            run_all(page)
        return page

    yield open_cells
    if page.evaluate(ALIVE):
        run_code(page, CLEAN)
    page.evaluate("jupyterapp.shell.currentWidget.dispose()")


@pytest.fixture
def own_kernel(lab_page):
    """For a test that harms its kernel: the next one gets a new one."""
    yield
    shut_down_kernels(lab_page)


def write(path, cells):
    if hasattr(cells[0], "read_text"):
        shutil.copy(cells[0], path)
        return
    code = [nbformat.v4.new_code_cell(cell) for cell in cells]
    nbformat.write(nbformat.v4.new_notebook(cells=code, metadata={"kernelspec": KERNEL}), path)


def open_in(page, path):
    page.evaluate("path => { jupyterapp.commands.execute('docmanager:open', {path}); }", path)
    page.wait_for_function(READY, arg=path, timeout=60_000)


@pytest.fixture
def own_page(browser, lab, root, watched):
    """A function that opens a notebook of these cells in a page of its own."""
    pages = []

    def open_cells(*cells):
        write(root / "own.ipynb", cells)
        pages.append(watched(browser.new_page(viewport={"width": 1280, "height": 900})))
        open_notebook(pages[0], lab, "own.ipynb")
        return pages[0]

    yield open_cells
    for page in pages:
        shut_down_kernels(page)
        page.close()


@pytest.fixture
def live(notebook):
    """A function that shows views and returns their elements, once they are alive."""
    def show(*cells, views=1):
        page = notebook(*cells)
        found = page.locator(".jp-Notebook:visible .kl-view")
        found.nth(views - 1).locator(".kl-picture svg").wait_for()
        found.nth(views - 1).locator(".kl-field").last.wait_for()
        page.evaluate(RESTED)
        return [found.nth(k) for k in range(views)]

    return show
