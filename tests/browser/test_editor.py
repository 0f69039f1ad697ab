"""The DH table driven in a real JupyterLab: by mouse and keyboard, light and dark."""
import re
from dataclasses import replace

import numpy as np
import pytest
from lab import run_code, set_theme
from playwright.sync_api import expect
from reading import assert_picture, at_rest, read, settle

import kinlab as kl

CELL = "import kinlab as kl\neditor = kl.DHTableEditor(kl.robots.alpha_ii())\neditor"


@pytest.fixture
def table(live):
    """The editor's element, alive, with the arm below it."""
    def show(*cells, views=1):
        found = live(*(cells or [CELL]), views=views)[0].page.locator(
            ".jp-Notebook:visible .kl-editor")
        found.nth(views - 1).locator(".kl-dh").wait_for()
        return found.nth(0) if views == 1 else [found.nth(k) for k in range(views)]

    return show


def cell(editor, row, letter):
    """A cell by its accessible name: 'a' of row 2 begins with 'a₂, '."""
    return editor.get_by_label(f"{letter}{'₀₁₂₃₄₅₆₇₈₉'[row]}, ", exact=False).and_(
        editor.locator(".kl-cell"))


def button(editor, name):
    return editor.get_by_role("button", name=name, exact=True)


def type_in(found, text, key="Enter"):
    found.fill(text)
    found.press(key)


def python(editor, expression):
    return run_code(editor.page, f"print({expression})").strip()


def position(editor):
    """p of T_0n as the page shows it."""
    return [row[3] for row in read(editor)["cells"][:3]]


def wait_for_position(editor, p):
    for text, value in zip(range(3), p):
        expect(editor.locator(".kl-pose tbody tr").nth(text).locator("td").nth(3)).to_have_text(
            f"{value:.1f}".replace("-", "−"))


def longer():
    """The Alpha II whose second link is 300 mm long."""
    arm = kl.robots.alpha_ii()
    return kl.Arm([replace(link, a=300) if k == 1 else link for k, link in enumerate(arm.links)],
                  convention=arm.convention, name=arm.name, unit=arm.unit, base=arm.base,
                  tool=arm.tool, home=arm.home)


def test_a_wrong_cell_its_reason_and_the_arm_that_moves(table):
    editor = table()
    a2, drawn = cell(editor, 2, "a"), read(editor)["paths"]["tool"]
    wait_for_position(editor, [485.1, 0, 215])
    type_in(a2, "1,5")
    expect(a2).to_have_attribute("aria-invalid", "true")
    reason = editor.locator(f"#{a2.get_attribute('aria-describedby')}")
    expect(reason).to_have_text("a₂: '1,5': expected a number such as -90 deg, pi/2 or 177.8; "
                                "write the decimal point as . and not as ,")
    below, above = reason.bounding_box(), a2.bounding_box()
    assert 0 <= below["y"] - above["y"] - above["height"] < 12  # right under its cell
    expect(editor.get_by_role("status").first).to_have_text(
        "One cell is wrong. The arm below is the last one that could be read.")
    assert read(editor)["paths"]["tool"] == drawn
    assert python(editor, "editor.arm.links[1].a, editor.table.arm") == "177.8 None"

    type_in(a2, "300")
    wait_for_position(editor, [607.3, 0, 215])
    expect(a2).to_have_attribute("aria-invalid", "false")
    expect(reason).to_be_hidden()
    expect(a2).to_be_focused()
    assert read(editor)["paths"]["tool"] != drawn
    assert_picture(read(editor), longer, longer().home, (-60, 24, 1))
    assert python(editor, "editor.arm.links[1].a") == "300.0"


def test_tab_goes_through_the_cells_and_commits(table):
    editor = table()
    page = editor.page
    cell(editor, 1, "θ").focus()
    for text in ("10", "200", "50", "-80"):
        page.keyboard.press("Control+a")
        page.keyboard.type(text)
        page.keyboard.press("Tab")
    expect(editor.get_by_label("Type of row 2")).to_be_focused()
    page.keyboard.press("Tab")
    expect(cell(editor, 2, "θ")).to_be_focused()
    expect(cell(editor, 1, "α")).to_have_value("-80")
    row = "['1', 'revolute', 'θ1*', '10', '200', '50', '-80']"
    for _ in range(300):  # the last cell may still be on its way to Python
        if python(editor, "repr(editor).splitlines()[2].split()") == row:
            break
        page.wait_for_timeout(100)
    assert python(editor, "repr(editor).splitlines()[2].split()") == row
    page.keyboard.press("ArrowDown")
    expect(cell(editor, 3, "θ")).to_be_focused()
    page.keyboard.type("x")
    page.keyboard.press("Escape")
    expect(cell(editor, 3, "θ")).to_have_value("0")
    button(editor, "Sign pattern").focus()
    for key in ("b", "a", "m"):
        page.keyboard.press(key)
    settle(page)
    expect(page.locator(".jp-Notebook:visible .jp-Cell")).to_have_count(1)  # no shortcut was heard


def test_rows_come_go_and_move(table):
    editor = table()
    page = editor.page
    cell(editor, 2, "a").focus()
    page.keyboard.press("Alt+ArrowDown")
    expect(cell(editor, 2, "a")).to_have_value("177.8")
    expect(cell(editor, 3, "a")).to_be_focused()
    type_in(cell(editor, 3, "a"), "99")
    button(editor, "+ Joint").click()
    expect(cell(editor, 6, "θ")).to_be_focused()
    expect(editor.locator(".kl-joints").get_by_role("slider")).to_have_count(6)
    editor.get_by_label("Type of row 6").select_option("prismatic")
    expect(editor.locator(".kl-knob").nth(5)).to_have_text("d₆mm")
    expect(editor.locator(".kl-star").nth(5)).to_contain_text("d₆*")
    editor.get_by_role("button", name="Remove row 1").click()
    expect(editor.get_by_label("Type of row 6")).to_have_count(0)
    expect(editor.locator(".kl-joints").get_by_role("slider")).to_have_count(5)
    assert python(editor, "[link.a for link in editor.arm.links]") == "[177.8, 99.0, 0.0, 0.0, 0.0]"
    for _ in range(5):
        button(editor, "↶ Undo").click()
    expect(button(editor, "↶ Undo")).to_be_disabled()
    wait_for_position(editor, [485.1, 0, 215])
    assert python(editor, "editor.arm.links == kl.robots.alpha_ii().links") == "True"


def test_the_convention_is_asked_for_plainly(table):
    editor = table()
    convention = editor.get_by_label("Convention", exact=True)
    convention.select_option("modified")
    expect(convention).to_have_value("standard")
    expect(button(editor, "Read the same numbers as modified")).to_be_focused()
    button(editor, "Cancel").click()
    expect(editor.get_by_role("group", name="Change of convention")).to_have_count(0)
    convention.select_option("modified")
    button(editor, "Convert to modified: the same arm").click()
    expect(convention).to_have_value("modified")
    expect(editor.get_by_label("α₁, link twist, row 2, deg")).to_have_value("-90")
    wait_for_position(editor, [485.1, 0, 215])
    convention.select_option("standard")
    button(editor, "Read the same numbers as standard").click()
    expect(convention).to_have_value("standard")
    expect(editor.get_by_label("α₂, link twist, row 2, deg")).to_have_value("-90")
    assert position(editor) != [485.1, 0, 215]


@pytest.mark.thorough
def test_units_and_named_lengths(table):
    editor = table()
    editor.get_by_label("Angles", exact=True).select_option("rad")
    expect(cell(editor, 1, "α")).to_have_value("-pi/2")
    editor.get_by_label("Lengths", exact=True).select_option("m")
    expect(cell(editor, 2, "a")).to_have_value("0.1778")
    button(editor, "+ Named length").click()
    name = editor.get_by_label("Name of length 1")
    expect(name).to_be_focused()
    type_in(name, "d2", "Tab")
    type_in(editor.get_by_label("Length d2, m"), "0.5")
    type_in(cell(editor, 2, "d"), "-d2")
    expect(cell(editor, 2, "d")).to_have_attribute("title", "-d2 = -0.5")
    assert python(editor, "editor.arm.links[1].d, editor.arm.unit") == "-0.5 m"


@pytest.mark.thorough
def test_what_is_being_typed_is_never_touched(table):
    editor = table()
    a3 = cell(editor, 3, "a")
    a3.focus()
    a3.fill("12")
    run_code(editor.page, "editor.set(2, 'a', '50'); editor.table = editor.table.with_row()")
    expect(editor.get_by_label("Type of row 6")).to_have_count(1)
    expect(cell(editor, 2, "a")).to_have_value("50")
    expect(a3).to_be_focused()
    expect(a3).to_have_value("12")
    assert python(editor, "editor.table.rows[2].a") == "177.8"
    run_code(editor.page, "editor.set(3, 'a', '77')")
    expect(editor.locator(".kl-pose td").nth(3)).to_have_text("256.5")
    expect(a3).to_have_value("12")
    a3.press("Enter")
    wait_for_position(editor, [191.5, 0, 215])


def steady(seen):
    """What another arm and back leaves as it was: words are placed anew for each arm."""
    paths = {gid: path for gid, path in seen["paths"].items()
             if gid != "trace" and not gid.startswith(("label-", "name-"))}
    return paths, seen["shown"], seen["arrows"], seen["size"]


# Where the words stand and what leads to them, once they stand still.
LABELS = at_rest("""editor => [...editor.querySelectorAll(
        '.kl-picture :is([id^=label-], [id^=name-]) > *')]
    .filter(name => getComputedStyle(name).visibility === 'visible')
    .map(name => ['d', 'x', 'y'].map(key => name.getAttribute(key)).join(' '))""")


def test_the_view_stays_as_it_was_turned(table):
    editor = table()
    editor.locator(".kl-view").evaluate("view => { window.kept = view; }")
    button(editor, "Ghost").click()
    editor.locator(".kl-picture").press("ArrowLeft")
    editor.get_by_role("slider").first.press("ArrowRight")
    before, labels = steady(read(editor)), []
    for _ in range(3):
        type_in(cell(editor, 2, "a"), "300")
        wait_for_position(editor, [607.2, 10.6, 215])
        type_in(cell(editor, 2, "a"), "177.8")
        wait_for_position(editor, [485.0, 8.5, 215])
        labels.append(editor.evaluate(LABELS))
        assert steady(read(editor)) == before
    assert len(labels[0]) >= 15 and labels[1:] == labels[:1] * 2
    assert editor.evaluate("e => e.querySelector('.kl-view') === window.kept")
    expect(button(editor, "Ghost")).to_have_attribute("aria-pressed", "true")
    editor.get_by_role("slider").nth(1).press("ArrowRight")
    settle(editor.page)
    assert_turned = np.degrees(eval(python(editor, "editor.view.q.tolist()")))
    np.testing.assert_allclose(assert_turned, [1, 1, 0, -90, 0], atol=1e-9)


@pytest.mark.thorough
def test_no_blank_picture_between_two_arms(table):
    """Every frame that is painted holds a whole picture of the same height."""
    editor = table()
    editor.evaluate("""editor => {
        window.painted = [];
        const look = () => {
            const path = editor.querySelector('.kl-picture svg #tool path');
            const box = editor.querySelector('.kl-picture')?.getBoundingClientRect();
            painted.push([Boolean(path), Math.round(box?.height ?? 0)].join());
            window.looking = requestAnimationFrame(look);
        };
        look();
    }""")
    for k in range(6):
        type_in(cell(editor, 2, "a"), str(200 + k))
        wait_for_position(editor, [307.3 + 200 + k, 0, 215])
    seen = editor.page.evaluate(
        "() => { cancelAnimationFrame(looking); return [...new Set(painted)]; }")
    assert len(seen) == 1 and seen[0].startswith("true"), seen


def test_panels_on_demand(table):
    editor = table()
    panel = editor.locator(".kl-panel")
    button(editor, "Closed form").click()
    editor.locator(".kl-panel math").first.wait_for()
    button(editor, "Sign pattern").click()
    expect(editor.get_by_role("table", name="Signs")).to_be_visible()
    button(editor, "Compare with modified").click()
    expect(panel.first).to_contain_text("Read as modified DH, these numbers are another mechanism.")
    expect(panel.locator("img")).to_be_visible()
    button(editor, "Compare with modified").click()
    expect(panel.locator("img")).to_have_count(0)
    for k in range(2):
        expect(panel.nth(k)).to_be_hidden()


def test_saving_and_loading(table, tmp_path):
    editor = table()
    button(editor, "Save, load").click()
    area = editor.get_by_label("The table as text")
    expect(area).to_have_value(python(editor, "editor.to_csv()") + "\n")
    editor.get_by_label("Format").select_option("code")
    expect(area).to_have_value(python(editor, "editor.to_code()") + "\n")
    for form, name in [("markdown", "dh_table.md"), ("latex", "dh_table.tex"),
                       ("code", "dh_table.py")]:
        editor.get_by_label("Format").select_option(form)
        expect(area).to_have_value(python(editor, f"editor.to_{form}()") + "\n")
        with editor.page.expect_download() as saved:
            button(editor, "Download").click()
        assert saved.value.suggested_filename == name
    saved.value.save_as(tmp_path / "saved.py")
    area.fill("import os\nos.remove('x')")
    button(editor, "Load this text").click()
    expect(editor.get_by_role("status").first).to_contain_text("line 2: expected code such as")
    area.fill("kl.Arm([kl.revolute(a=2), kl.prismatic(alpha=pi/2)])")
    button(editor, "Load this text").click()
    expect(editor.get_by_label("Type of row 2")).to_have_value("prismatic")
    editor.get_by_label("Open a file").set_input_files(tmp_path / "saved.py")
    expect(editor.get_by_label("Type of row 5")).to_have_value("revolute")
    assert python(editor, "repr(editor.arm) == repr(kl.robots.alpha_ii())") == "True"


# ---- pasted tables ----

# Paste into the element, as a browser does it: the clipboard holds a plain text and perhaps HTML.
PASTE = """(node, [plain, html]) => {
    const clipboard = new DataTransfer();
    clipboard.setData('text/plain', plain);
    if (html) clipboard.setData('text/html', html);
    const event = new ClipboardEvent('paste',
        { clipboardData: clipboard, bubbles: true, cancelable: true });
    node.focus();
    return node.dispatchEvent(event);
}"""
UNCLEAR = "theta\td\ta\talpha\n0\t0.1\t0\t1.5708\n0\t0\t1\t0\n"


def paste(found, plain, html=""):
    """Whether the browser goes on with an ordinary paste."""
    return found.evaluate(PASTE, [plain, html])


def test_a_table_is_pasted_into_any_cell_and_taken_back(table):
    editor = table()
    head = "i\tθ (deg)\td (mm)\ta (mm)\tα (deg)\n"
    assert not paste(cell(editor, 2, "a"), head + "1\tq1\t300\t0\t90\n2\tq2\t0\t250\t0\n")
    expect(editor.get_by_label("Type of row 3")).to_have_count(0)
    expect(cell(editor, 2, "a")).to_have_value("250")
    expect(editor.get_by_role("status").first).to_contain_text("Read as standard DH")
    expect(cell(editor, 1, "θ")).to_be_focused()  # the cell that was pasted into has gone
    button(editor, "↶ Undo").click()
    expect(cell(editor, 5, "d")).to_have_value("129.5")
    assert python(editor, "repr(editor.arm) == repr(kl.robots.alpha_ii())") == "True"


@pytest.mark.thorough
def test_a_number_is_pasted_as_ever(table):
    editor = table()
    assert paste(cell(editor, 2, "a"), "0.5\r\n", "<table><tr><td>0.5</td></tr></table>")
    assert paste(cell(editor, 2, "a"), "-pi/2")
    settle(editor.page)
    assert python(editor, "repr(editor.arm) == repr(kl.robots.alpha_ii())") == "True"


@pytest.mark.thorough
def test_cells_of_a_page_are_pasted(table):
    editor = table()
    rows = [("theta", "d", "a", "alpha"), ("0°", "10", "20", "-90°"), ("0°", "0", "30", "0°")]
    html = "".join(f"<tr>{''.join(f'<td>{text}</td>' for text in row)}</tr>" for row in rows)
    assert not paste(cell(editor, 1, "d"), "all in one line | ", f"<table>{html}</table>")
    expect(cell(editor, 1, "a")).to_have_value("20")
    assert python(editor, "[link.a for link in editor.arm.links]") == "[20.0, 30.0]"


def test_what_is_unclear_is_asked_and_answered_by_keyboard(table):
    editor = table()
    page = editor.page
    paste(cell(editor, 2, "a"), UNCLEAR)
    expect(button(editor, "degrees")).to_be_focused()
    expect(editor.get_by_role("group", name="Are the angles in degrees or in radians?")
           ).to_have_count(1)
    page.keyboard.press("Escape")
    expect(button(editor, "degrees")).to_have_count(0)
    expect(cell(editor, 2, "a")).to_be_focused()
    assert python(editor, "editor.arm.n") == "5"
    paste(cell(editor, 2, "a"), UNCLEAR)
    expect(button(editor, "degrees")).to_be_focused()
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    expect(cell(editor, 1, "α")).to_have_value("1.5708")
    expect(editor.get_by_role("status").first).to_contain_text("angles in radians")
    assert python(editor, "editor.arm.n, editor.arm.links[0].alpha") == "2 1.5708"


@pytest.mark.thorough
def test_a_table_is_pasted_into_the_box(table):
    editor = table()
    button(editor, "Save, load").click()
    area = editor.get_by_label("The table as text")
    paste(area, "no table\nat all")
    expect(editor.get_by_role("status").first).to_contain_text("expected a header")
    expect(area).to_have_value("no table\nat all")  # to be corrected
    paste(area, "theta,d,a,alpha\n0,1,2,90\n")
    expect(editor.get_by_label("Type of row 2")).to_have_count(0)
    expect(area).to_have_value(python(editor, "editor.to_csv()") + "\n")


@pytest.mark.thorough
def test_a_file_is_dropped_on_the_table(table):
    editor = table()
    editor.locator(".kl-dh").evaluate("""node => {
        const dropped = new DataTransfer();
        dropped.items.add(new File(['theta,d,a,alpha\\n0,1,2,90\\n'], 'arm.csv'));
        node.dispatchEvent(new DragEvent('drop', { dataTransfer: dropped, bubbles: true }));
    }""")
    expect(editor.get_by_label("Type of row 2")).to_have_count(0)
    expect(cell(editor, 1, "a")).to_have_value("2")


# ---- rows and ends as people have them ----


def test_a_fixed_row_and_a_joint_that_counts_the_other_way(table):
    editor = table()
    editor.get_by_label("Type of row 2").select_option("fixed")
    expect(editor.locator(".kl-joints").get_by_role("slider")).to_have_count(4)
    expect(editor.locator(".kl-starred")).to_have_count(4)
    flip = editor.get_by_role("button", name="θ₂ counts the other way")  # it stands in row 3
    expect(flip).to_have_text("θ₂*")
    cell(editor, 3, "a").press("Alt+-")
    expect(flip).to_have_text("−θ₂*")
    expect(flip).to_have_attribute("aria-pressed", "true")
    expect(cell(editor, 3, "a")).to_be_focused()
    assert python(editor, "[link.flip for link in editor.arm.links]") == \
        "[False, False, True, False, False]"
    flip.click()
    expect(flip).to_have_attribute("aria-pressed", "false")


@pytest.mark.thorough
def test_a_joint_is_locked_and_unlocked(table):
    editor = table()
    run_code(editor.page, "editor.theta_2 = 25")
    button(editor, "Limits, home").click()
    lock = editor.locator("[data-at^='lock ']").nth(1)
    lock.click()
    expect(lock).to_have_text("Unlock")
    expect(lock).to_be_focused()
    expect(editor.locator(".kl-locked")).to_have_text("locked")
    expect(editor.get_by_label("row 2, upper limit")).to_have_value("25")
    lock.press("Enter")
    expect(editor.locator(".kl-locked")).to_have_count(0)
    assert python(editor, "editor.arm.links[1].limits") == "None"


def test_speeds_stand_beside_the_limits(table):
    editor = table(CELL.replace("alpha_ii", "ur5"))
    speed = editor.get_by_label("row 2, largest speed, row 2, deg/s")
    expect(speed).to_have_count(0)
    button(editor, "Limits, home").click()
    expect(speed).to_have_value("180")
    expect(editor.get_by_role("columnheader", name="largest acceleration")).to_have_count(0)
    type_in(speed, "-90")
    expect(speed).to_have_attribute("aria-invalid", "true")
    expect(editor.get_by_role("alert").filter(has_text="above 0")).to_have_count(1)
    type_in(speed, "90")
    expect(speed).not_to_have_attribute("aria-invalid", "true")
    assert python(editor, "round(editor.arm.links[1].speed, 6)") == "1.570796"


def test_a_tool_is_typed(table):
    editor = table()
    page = editor.page
    button(editor, "+ Tool").click()
    tool = editor.get_by_role("group", name="Tool")
    expect(tool.get_by_label("x of the tool")).to_be_focused()
    page.keyboard.press("Tab")
    page.keyboard.press("Tab")
    expect(tool.get_by_label("z of the tool")).to_be_focused()
    type_in(tool.get_by_label("z of the tool"), "100")
    wait_for_position(editor, [585.1, 0, 215])
    type_in(tool.get_by_label("yaw of the tool"), "1,5")
    expect(tool.get_by_label("yaw of the tool")).to_have_attribute("aria-invalid", "true")
    expect(tool.get_by_role("alert")).to_contain_text("yaw: '1,5'")
    type_in(tool.get_by_label("yaw of the tool"), "90")
    expect(tool.get_by_role("alert")).to_be_hidden()
    tool.get_by_label("How the tool is typed").select_option("row")
    expect(tool.get_by_label("θ of the tool")).to_have_value("90")
    expect(tool.get_by_label("d of the tool")).to_have_value("100")
    wait_for_position(editor, [585.1, 0, 215])
    button(editor, "Leave out the tool frame").click()
    expect(tool).to_have_count(0)
    wait_for_position(editor, [485.1, 0, 215])


@pytest.mark.thorough
def test_an_odd_angle_is_hinted_at(table):
    editor = table()
    alpha = cell(editor, 1, "α")
    type_in(alpha, "1.5708")
    said = editor.locator(f"#{alpha.get_attribute('data-reason')}")
    expect(said).to_contain_text("pi/2")
    expect(alpha).to_have_attribute("aria-invalid", "false")
    expect(alpha).to_have_attribute("aria-describedby", alpha.get_attribute("data-reason"))


def test_it_is_seen_whole_and_has_names_in_both_themes(table):
    editor = table()
    page = editor.page
    type_in(cell(editor, 2, "a"), "x")
    expect(cell(editor, 2, "a")).to_have_attribute("aria-invalid", "true")
    for theme in ("JupyterLab Dark", "JupyterLab Light"):
        set_theme(page, theme)
        ink, paper = cell(editor, 1, "a").evaluate(
            "e => [getComputedStyle(e).color, getComputedStyle(e).backgroundColor]")
        light = [sum(map(int, re.findall(r"\d+", text)[:3])) / 765 for text in (ink, paper)]
        assert abs(light[0] - light[1]) > 0.6, theme
    nameless = editor.evaluate("""e => [...e.querySelectorAll(
        '.kl-table :is(input, select, button)')].filter(node =>
            !(node.ariaLabel || node.textContent.trim())).length""")
    assert nameless == 0
    wide = editor.locator(".kl-table").evaluate("e => e.scrollWidth <= e.clientWidth")
    assert wide


@pytest.mark.thorough
def test_two_views_of_one_table_agree(table):
    one, two = table(CELL, "editor", views=2)
    type_in(cell(one, 2, "a"), "300")
    for place in (one, two):
        expect(cell(place, 2, "a")).to_have_value("300")
        wait_for_position(place, [607.3, 0, 215])
    type_in(cell(two, 3, "α"), "90")
    expect(cell(one, 3, "α")).to_have_value("90")
