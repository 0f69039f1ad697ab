"""JupyterLab itself in Firefox: views, the editor and a prediction live there, and Python hears."""
import ast

import nbformat
import pytest
from engines import engine_or_skip
from lab import NOTEBOOK, run_code
from test_predictions import CELL

pytestmark = pytest.mark.thorough

KERNEL = {"name": "python3", "display_name": "Python 3", "language": "python"}
CELLS = ["import kinlab as kl\nview = kl.ArmView(kl.robots.alpha_ii(), closed_form=True)\nview",
         "editor = kl.DHTableEditor(kl.robots.cylindrical())\neditor", CELL]
IDLE = """() => window.jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel
    ?.status === 'idle' && !document.querySelector('#jupyterlab-splash')"""
RAN = """() => jupyterapp.commands.execute('notebook:run-all-cells').then(() =>
    NOTEBOOK.cells.flatMap(cell => cell.outputs ?? [])
        .filter(output => output.output_type === 'error').map(output => output.evalue))"""
ALIVE = """count => [...document.querySelectorAll('.kl-view')].filter(
    view => view.querySelector('.kl-picture svg path[d]')).length === count"""
ANGLES = """() => [...document.querySelectorAll("[data-cell='0'] .kl-field")]
    .map(field => Number(field.value))"""
# Marks what stands in the output of a cell, so that a selector can name it.
MARK = """() => document.querySelectorAll('.jp-Notebook .jp-CodeCell').forEach(
    (cell, k) => cell.setAttribute('data-cell', k))"""


@pytest.fixture(scope="module")
def page(firefox, root, lab):
    """The notebook, run."""
    code = [nbformat.v4.new_code_cell(cell) for cell in CELLS]
    book = nbformat.v4.new_notebook(cells=code, metadata={"kernelspec": KERNEL})
    nbformat.write(book, root / "firefox.ipynb")
    firefox.resize(1280, 1000)
    firefox.open(lab.page_url("firefox.ipynb"))
    firefox.wait(IDLE)
    assert firefox.evaluate(RAN.replace("NOTEBOOK", NOTEBOOK)) == []
    firefox.wait(ALIVE, 3)
    firefox.evaluate(MARK)
    return firefox


@pytest.fixture(scope="module")
def firefox():
    yield from engine_or_skip("firefox")


def hears(page, code, wanted):
    """Wait until Python says this."""
    for _ in range(300):
        if (now := ast.literal_eval(run_code(page, f"print(({code}))"))) == wanted:
            return
        page.settle()
    assert now == wanted


def test_a_slider_by_keys_and_by_the_mouse(page):
    slider = "[data-cell='0'] .kl-knob [type=range]"
    page.press("ArrowRight", "Shift+ArrowRight", on=slider)
    hears(page, "round(view.theta_1, 3)", 1.1)
    x, y, width, height = page.box(slider)
    page.drag([(x + part * width, y + height / 2) for part in (0.5, 0.6, 0.7)])
    page.settle()
    value = page.evaluate(ANGLES)[0]
    assert value > 40 and value == round(value)
    hears(page, "round(view.theta_1, 6)", value)
    run_code(page, "view.theta_1 = -30")
    page.wait("slider => document.querySelector(slider).valueAsNumber === -30", slider)


def test_a_link_is_dragged(page):
    run_code(page, "view.q = view.arm.home")
    page.wait(f"() => ({ANGLES})()[0] === 0")
    page.settle()
    spot = page.middle("[data-cell='0'] #link-2-0 path")
    page.drag([spot, (spot[0], spot[1] - 20), (spot[0], spot[1] - 40)])
    page.settle()
    value = page.evaluate(ANGLES)[1]
    assert abs(value) > 5
    hears(page, "round(view.theta_2, 1)", value)


def test_the_editor_takes_a_cell_and_its_arm_follows(page):
    cell = "[data-cell='1'] .kl-cell[aria-label^='a₂']"
    page.press("Control+a", *"0.25", "Enter", on=cell)
    hears(page, "editor.arm.links[1].a", 0.25)
    page.press("Control+a", *"x", "Enter", on=cell)
    page.wait("cell => document.querySelector(cell).getAttribute('aria-invalid') === 'true'", cell)
    hears(page, "editor.arm.links[1].a", 0.25)


def test_a_prediction_is_judged_and_python_knows(page):
    field = "[data-cell='2'] .kl-knob[data-quantity=mark] .kl-field"
    page.press("Control+a", "1", "Enter", on=field)
    page.click("[data-cell='2'] .kl-commit")
    page.wait("() => /Your mark is 2.236 m away/.test("
              "document.querySelector(\"[data-cell='2'] .kl-told\").textContent)")
    hears(page, "prediction.answers[0].answer[:2], prediction.told.ok", ([1, 0], False))


def test_saved_and_opened_again_a_view_moves(page, lab):
    for last in ("commands.execute('docmanager:save')", "serviceManager.sessions.shutdownAll()"):
        page.evaluate(f"() => jupyterapp.{last}.then(() => 0)")
    page.open(lab.page_url("firefox.ipynb"))
    page.wait(IDLE)
    page.wait(ALIVE, 3)
    page.evaluate(MARK)
    (before, *_) = page.evaluate(ANGLES)
    page.press("ArrowRight", on="[data-cell='0'] .kl-knob [type=range]")
    page.wait(f"before => ({ANGLES})()[0] === before + 1", before)


def test_nothing_went_wrong_meanwhile(page):
    assert page.logged == []
