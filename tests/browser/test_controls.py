"""A view's own controls: what is typed into a field, what a screen reader hears, other widgets."""
import numpy as np
import pytest
from lab import run_code
from playwright.sync_api import expect
from reading import assert_picture, from_units, kernel_q, read, settle, take, wait_for_kernel

import kinlab as kl

ALPHA = kl.robots.alpha_ii
HOME = [0, 0, 0, -90, 0]


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    """A page with the Alpha II."""
    path = tmp_path_factory.mktemp("controls") / "alpha.html"
    return kl.ArmView(ALPHA()).save_html(path).as_uri()


@pytest.fixture
def view(page, address):
    page.goto(address)
    return page.locator(".kl-view")


def field(view, k):
    return view.locator(".kl-field").nth(k)


def values(view):
    return [float(one.input_value()) for one in view.locator(".kl-field").all()]


@pytest.fixture(scope="module")
def still_there(browser, address):
    """The same view for many texts: each of them leaves it at home."""
    page = browser.new_page()
    page.goto(address)
    yield page.locator(".kl-view")
    page.close()


@pytest.mark.parametrize("text, degrees", [
    ("45,5", 45.5), ("45.5", 45.5), ("pi/2", 90), ("-pi/4", -45), ("1/3 pi", None), ("30 deg", 30),
    ("0.5 rad", np.degrees(0.5)), ("2*(10+5)", 30), ("−33", -33), ("  12  ", 12), ("90°", 90),
    ("1e1", 10), ("200", 150), ("1,000", None), ("abc", None), ("1 2", None), ("alert(1)", None),
    ("1/0", None), ("--", None), ("nan", None), ("1e999", None), ("5 mm", None)])
def test_a_field_reads_a_number_or_says_why_not(still_there, text, degrees):
    view, box = still_there, field(still_there, 0)
    box.fill("0")
    box.press("Enter")
    assert values(view) == HOME
    box.fill(text)
    box.press("Enter")
    if degrees is None:
        expect(box).to_have_attribute("aria-invalid", "true")
        expect(box).to_have_value(text)  # what was typed is not lost
        expect(view.locator(".kl-remark")).to_contain_text("θ₁: ")
        box.press("Escape")
        expect(box).to_have_value("0.0")
        expect(box).to_have_attribute("aria-invalid", "false")
        degrees = 0
    assert values(view)[0] == round(degrees, 1)
    assert_picture(read(view), ALPHA, np.radians([degrees, *HOME[1:]]), (-60, 24, 1))


def test_a_wrong_number_is_gone_once_the_slider_moves(view):
    field(view, 0).fill("x")
    field(view, 0).blur()
    expect(field(view, 0)).to_have_attribute("aria-invalid", "true")
    view.get_by_role("slider").nth(0).press("ArrowRight")
    expect(field(view, 0)).to_have_value("1.0")
    expect(field(view, 0)).to_have_attribute("aria-invalid", "false")
    expect(view.locator(".kl-remark")).to_have_text("")


def test_what_is_being_typed_is_not_touched(view):
    field(view, 0).focus()
    view.page.keyboard.type("12")  # over what was selected
    view.get_by_role("button", name="Zero", exact=True).evaluate("button => button.click()")
    expect(field(view, 3)).to_have_value("0.0")
    expect(field(view, 0)).to_have_value("12")
    view.page.keyboard.press("Enter")
    expect(field(view, 0)).to_have_value("12.0")
    assert values(view) == [12, 0, 0, 0, 0]


def test_every_control_has_a_role_a_name_and_a_value_with_its_unit(page, tmp_path):
    arm = kl.Arm([kl.revolute(a=1, name="shoulder"), kl.prismatic(limits=(0.1, 0.6))], name="Slide")
    page.goto(kl.ArmView(arm, [0.5, 0.3]).save_html(tmp_path / "slide.html").as_uri())
    sliders = page.get_by_role("slider")
    assert [sliders.nth(k).get_attribute("aria-label") for k in (0, 1)] == [
        "θ₁, shoulder", "d₂, joint 2"]
    assert [sliders.nth(k).get_attribute("aria-valuetext") for k in (0, 1)] == ["28.6°", "0.30 m"]
    for name in ("θ₁, shoulder, number in °", "d₂, joint 2, number in m"):
        expect(page.get_by_role("textbox", name=name, exact=True)).to_be_visible()
    nameless = page.locator(".kl-view").evaluate("""view => [...view.querySelectorAll(
        'input, button, select, [role=application]')].filter(node =>
            !(node.ariaLabel || node.textContent.trim())).map(node => node.outerHTML)""")
    assert nameless == []


@pytest.mark.parametrize("name", [False, True], ids=["as it is", "hostile"])
def test_names_of_joints_are_words_and_nothing_more(page, tmp_path, name):
    evil = "<img src=x onerror=window.hit=1>\"'" if name else "elbow"
    arm = kl.Arm([kl.revolute(a=1, name=evil)], name=evil, unit=evil if name else "m")
    page.goto(kl.ArmView(arm).save_html(tmp_path / "arm.html").as_uri())
    assert page.get_by_role("slider").get_attribute("aria-label") == f"θ₁, {evil}"
    settle(page)
    assert page.evaluate("window.hit") is None and page.locator("img").count() == 0


OWN = ["import kinlab as kl, numpy as np, ipywidgets\nown = kl.ArmView(kl.robots.two_link())",
       "both = ipywidgets.FloatSlider(min=-180, max=180, description='both')\n"
       "for name in ('theta_1', 'theta_2'):\n"
       "    ipywidgets.jslink((both, 'value'), (own, name))\n"
       "ipywidgets.VBox([both, own])",
       "def distance(theta_1, theta_2):\n"
       "    print(f'{np.hypot(*own.T[:2, 3]):.2f} m away')\n"
       "ipywidgets.interactive_output(distance, {k: own[k] for k in ('theta_1', 'theta_2')})"]


def test_other_widgets_move_a_view_and_hear_of_it(live):
    """As the end of lesson 00 shows: VBox, jslink and interactive_output beside a view."""
    (view,) = live(*OWN)
    page, robot = view.page, kl.robots.two_link
    both = page.locator(".widget-slider [role=slider]").first
    expect(field(view, 0)).to_have_value("0.0")  # jslink has brought both to the slider's value
    expect(page.get_by_text("2.00 m away")).to_be_visible()
    both.focus()
    for _ in range(3):
        page.keyboard.press("PageUp")
    expect(field(view, 1)).not_to_have_value("0.0")
    settle(page)
    seen = read(view)
    assert seen["readouts"][0] == seen["readouts"][1] != 0
    assert_picture(seen, robot, from_units(robot, seen["readouts"]), (-90, 90, 1))
    tip = np.hypot(*kl.forward_kinematics(robot(), from_units(robot, seen["readouts"]))[:2, 3])
    expect(page.get_by_text(f"{tip:.2f} m away")).to_be_visible()
    q = wait_for_kernel(page, robot, seen["readouts"], "own")
    np.testing.assert_allclose(q, from_units(robot, seen["readouts"]), atol=1e-9)
    view.get_by_role("slider").nth(0).press("Home")  # and the other way round
    expect(page.locator(".widget-readout").first).to_have_text("\u2212180.00")
    run_code(page, "own.theta_2 = 90")
    expect(field(view, 1)).to_have_value("90.0")
    expect(page.locator(".widget-readout").first).to_have_text("90.00")
    expect(field(view, 0)).to_have_value("90.0")


def test_entries_rows_factors_and_readings_have_names(page, tmp_path):
    """The table's entry and the formula's are called alike, so that one can point at the other."""
    view = kl.TargetView(kl.robots.two_link())
    page.goto(view.save_html(tmp_path / "target.html").as_uri())
    named = "(key) => [...document.querySelectorAll(`[data-${key}]`)].map(n => n.dataset[key])"
    assert page.evaluate(named, "row") == list("1234")
    assert page.evaluate(named, "reading") == ["target", "tool"]
    page.goto(kl.ArmView(ALPHA(), closed_form=True).save_html(tmp_path / "arm.html").as_uri())
    entries = [f"{i},{j}" for i in range(1, 5) for j in range(1, 5)]
    for place in (".kl-pose td", "math mtd"):
        assert page.locator(place).evaluate_all("all => all.map(n => n.dataset.entry)") == entries
    factors = page.locator('math [data-entry="1,4"] [data-factor]')
    assert factors.evaluate_all("all => all.map(n => [n.dataset.factor, n.dataset.joints])") == [
        ["C1", "1"], ["C2", "2"], ["C23", "2 3"], ["S234", "2 3 4"]]


def test_the_reason_stays_as_long_as_what_cannot_be_read(view):
    field(view, 0).fill("xyz")
    field(view, 0).blur()
    remark = view.locator(".kl-remark")
    expect(remark).to_contain_text("θ₁: 'xyz': expected a number")
    view.get_by_role("slider").nth(1).press("ArrowRight")
    expect(field(view, 1)).to_have_value("1.0")
    expect(remark).to_contain_text("θ₁: 'xyz': expected a number")
    field(view, 0).fill("5")
    field(view, 0).press("Enter")
    expect(remark).to_have_text("")


TABLE = "import kinlab as kl\neditor = kl.DHTableEditor(kl.robots.alpha_ii())\neditor"


def grip(view, k):
    """Take slider k in its middle and pull it a little."""
    x, y = take(view.get_by_role("slider").nth(k))
    view.page.mouse.move(x + 12, y, steps=3)
    settle(view.page)
    return x, y


def test_another_arm_takes_nothing_out_of_the_hand(live):
    """The table changes while a slider is held, and while a number is half typed."""
    (view,) = live(TABLE)
    page = view.page
    x, y = grip(view, 0)
    before = values(view)[0]
    run_code(page, "editor.set(1, 'd', '330')")
    expect(view.locator(".kl-pose tbody tr").nth(2).locator("td").nth(3)).to_have_text("330.0")
    page.mouse.move(x + 45, y, steps=3)
    settle(page)
    assert values(view)[0] > before + 5
    page.mouse.up()
    box = field(view, 1)
    box.focus()
    page.keyboard.type("12")
    run_code(page, "editor.set(1, 'd', '340')")
    expect(view.locator(".kl-pose tbody tr").nth(2).locator("td").nth(3)).to_have_text("340.0")
    expect(box).to_be_focused()
    expect(box).to_have_value("12")
    assert kernel_q(page, "editor")[1] == 0  # not committed by itself
    page.keyboard.press("Enter")
    expect(box).to_have_value("12.0")
    run_code(page, "editor.follow(kl.robots.cylindrical())")
    expect(view.get_by_role("slider")).to_have_count(3)
    assert values(view) == [0, 0.3, 0.3]


def test_python_does_not_move_a_slider_that_a_hand_holds(live):
    (view,) = live("import kinlab as kl\nview = kl.ArmView(kl.robots.alpha_ii())\nview")
    page = view.page
    grip(view, 0)
    held = values(view)[0]
    assert held > 0
    run_code(page, "import time\nfor k in range(20):\n"
                   "    view.theta_1, view.theta_2 = -100 + k, k\n    time.sleep(0.02)")
    expect(field(view, 1)).to_have_value("19.0")
    assert values(view)[0] == held
    page.mouse.up()
    page.wait_for_timeout(300)
    run_code(page, "view.theta_1 = -50")
    expect(field(view, 0)).to_have_value("-50.0")


def test_a_vector_under_a_picture_is_not_torn(page, tmp_path):
    page.set_viewport_size({"width": 390, "height": 800})
    view = kl.lessons.two_link.both_methods()
    page.goto(view.save_html(tmp_path / "arm.html").as_uri())
    heights = page.locator(".kl-readings .kl-number").evaluate_all(
        "all => all.map(one => one.getBoundingClientRect().height)")
    line = min(heights)
    assert line > 0 and heights == pytest.approx([line] * len(heights), abs=1)
