"""Cells of the DH table's editor: numbers that are longer than a cell show how large they are."""
import re

import pytest
from editing import shown_in
from playwright.sync_api import expect

import kinlab as kl

# As a URDF with rounded angles gives them.
D, LONG = "-8.360609147639873e-07", "2.2957531898827691e-07"


@pytest.fixture
def editor():
    return kl.DHTableEditor(kl.Arm([
        kl.revolute(d=float(D), a=0.2, alpha=1e-5),
        kl.revolute(d=0.123456789012345, a=float(LONG)), kl.revolute(a=8e-7)]))


@pytest.fixture
def page(lend, watched, editor):
    return shown_in(watched(lend(fresh=True)))(editor)


def cell(page, row, letter):
    return page.get_by_label(re.compile(f"^{letter}{'₀₁₂₃'[row]}, ")).and_(page.locator(".kl-cell"))


def test_the_exponent_of_a_long_number_is_seen(page):
    expect(cell(page, 1, "d")).to_have_value("-8.36e-7")
    expect(cell(page, 2, "a")).to_have_value("2.30e-7")
    expect(cell(page, 1, "α")).to_have_value("0.000572957795130823")
    expect(cell(page, 2, "d")).to_have_value("0.123456789012345")
    expect(cell(page, 3, "a")).to_have_value("8e-07")  # it fits
    assert cell(page, 1, "d").get_attribute("title") == D
    for found in page.locator(".kl-dh .kl-cell").all():
        if "e-" in found.input_value():  # nothing of it is cut off
            assert found.evaluate("cell => cell.scrollWidth <= cell.clientWidth")


def test_all_digits_are_kept_and_are_there_to_be_edited(page, editor):
    before = editor.to_csv()
    assert D in before
    for leave in ("Tab", "Enter", "Escape"):
        cell(page, 1, "d").focus()
        expect(cell(page, 1, "d")).to_have_value(D)
        cell(page, 1, "d").press(leave)
        cell(page, 1, "a").focus()
        expect(cell(page, 1, "d")).to_have_value("-8.36e-7")
    assert editor.to_csv() == before and not editor.cells["undo"]


def test_a_number_that_is_reached_with_tab_is_selected(page):
    cell(page, 1, "θ").focus()
    page.keyboard.press("Tab")
    expect(cell(page, 1, "d")).to_be_focused()
    page.keyboard.type("0.5")
    page.keyboard.press("Tab")
    expect(cell(page, 1, "d")).to_have_value("0.5")


def test_what_is_shown_may_be_typed_and_is_meant_then(page, editor):
    cell(page, 1, "d").fill("-8.36e-7")
    cell(page, 1, "d").press("Tab")
    expect(page.locator('[data-at="Undo"]')).to_be_enabled()
    assert editor.arm.links[0].d == -8.36e-7
    expect(cell(page, 1, "d")).to_have_value("-8.36e-7")


def test_a_long_number_from_python_is_short_unless_somebody_types(page, editor):
    cell(page, 3, "a").fill("4")
    page.evaluate("""() => { const now = structuredClone(window.model.state.cells);
        now.rows[2].cells.a.text = now.rows[0].cells.a.text = "1.23456789e-05";
        window.model.state.cells = now; window.model.told("cells"); }""")
    expect(cell(page, 3, "a")).to_have_value("4")
    expect(cell(page, 1, "a")).to_have_value("1.23e-5")
    cell(page, 3, "a").press("Escape")
    expect(cell(page, 3, "a")).to_have_value("1.23456789e-05")
    cell(page, 2, "θ").focus()
    expect(cell(page, 3, "a")).to_have_value("1.23e-5")


def test_a_cell_in_which_nothing_was_typed_takes_what_python_says(page):
    cell(page, 1, "d").focus()
    page.evaluate("""() => { const now = structuredClone(window.model.state.cells);
        now.rows[0].cells.d.text = "1.23456789e-05";
        window.model.state.cells = now; window.model.told("cells"); }""")
    expect(cell(page, 1, "d")).to_have_value("1.23456789e-05")
