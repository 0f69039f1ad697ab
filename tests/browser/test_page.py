"""Saved pages in a real browser: from the disk, with the network off, on a desk and on a phone."""
import numpy as np
import pytest
from playwright.sync_api import expect
from reading import READ, SETTLE, assert_picture, assert_table, from_units, read

import kinlab as kl

HOME = (-60, 24, 1)
ALPHA = kl.robots.alpha_ii


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Pages of three views."""
    folder = tmp_path_factory.mktemp("pages")
    kl.ArmView(ALPHA(), closed_form=True).save_html(folder / "alpha.html")
    kl.ArmView(kl.robots.cylindrical()).save_html(folder / "slides.html")
    kl.lessons.rotation.axes_view().save_html(folder / "axes.html")
    return folder


@pytest.fixture
def visit(lend, folder, watched):
    """A function that opens a saved page, all network off, and gives the page and its view."""
    def visit(name, *, end="", width=1280, height=800, watch=watched, **options):
        page = watch(lend(offline=True, viewport={"width": width, "height": height}, **options))
        asked = []
        page.route("**/*", lambda route: (asked.append(route.request.url), route.continue_()))
        page.goto((folder / f"{name}.html").as_uri() + end)
        assert len(asked) <= 1, asked  # the page itself and nothing else
        return page, page.locator(".kl-view")

    return visit


def range_of(view, i):
    return view.locator("input[type=range]").nth(i)


def field_of(view, i):
    return view.locator(".kl-field").nth(i)


def fields(view):
    return [float(field.input_value()) for field in view.locator(".kl-field").all()]


def drag(page, view, i, share):
    """Take a slider's knob and pull it to a share of its way."""
    box = range_of(view, i).bounding_box()
    y, place = box["y"] + box["height"] / 2, lambda part: box["x"] + part * box["width"]
    value = range_of(view, i).evaluate("s => (s.valueAsNumber - s.min) / (s.max - s.min)")
    page.mouse.move(place(value), y)
    page.mouse.down()
    for step in np.linspace(value, share, 9):
        page.mouse.move(place(step), y)
    page.mouse.up()


def test_sliders_move_the_arm_and_the_table(visit):
    page, view = visit("alpha")
    seen = read(view)
    assert_picture(seen, ALPHA, ALPHA().home, HOME)
    drag(page, view, 0, 0.72)
    drag(page, view, 2, 0.3)
    values = fields(view)
    assert values[0] > 40 and values[2] < -20
    assert values == [round(value) for value in values]  # a hand stops at whole steps
    q = from_units(ALPHA, values)
    seen = read(view)
    assert_picture(seen, ALPHA, q, HOME)
    assert_table(seen, ALPHA, q, 1)


def test_keys_and_numbers_as_in_the_notebook(visit):
    _, view = visit("slides")
    slider = range_of(view, 0)
    for key, value in {"ArrowRight": 1, "Shift+ArrowUp": 1.1, "PageUp": 11, "ArrowLeft": 10,
                       "Shift+ArrowDown": 9.9, "Home": -180, "End": 180}.items():
        slider.press(key)
        assert fields(view)[0] == value, key
    field_of(view, 0).fill("12.34")
    field_of(view, 0).press("Enter")
    assert float(range_of(view, 0).input_value()) == pytest.approx(12.34)
    field_of(view, 0).fill("")
    field_of(view, 0).blur()
    assert fields(view)[0] == 12.3
    field_of(view, 1).fill("99")
    field_of(view, 1).press("Tab")
    assert fields(view)[1] == 0.6
    seen = read(view)
    assert seen["remark"] == "d₂ is at its limit, 0.6 m"
    assert_picture(seen, kl.robots.cylindrical, [np.radians(12.34), 0.6, 0.3], HOME)


def test_labels_say_name_and_unit(visit):
    _, view = visit("slides")
    knobs = view.locator(".kl-knob")
    assert knobs.all_inner_texts() == ["θ₁\n°", "d₂\nm", "d₃\nm"]
    assert range_of(view, 1).get_attribute("aria-valuetext") == "0.30 m"
    assert range_of(view, 0).get_attribute("aria-label").startswith("θ₁")


def test_the_address_sets_the_joints_and_follows_them(visit):
    page, view = visit("alpha", end="#q=30,40,-20,0,5.5")
    assert fields(view) == [30, 40, -20, 0, 5.5]
    assert_picture(read(view), ALPHA, from_units(ALPHA, [30, 40, -20, 0, 5.5]), HOME)
    page.evaluate("location.hash = '#q=10,0,0,-90,0'")
    expect(field_of(view, 0)).to_have_value("10.0")
    range_of(view, 0).press("ArrowRight")
    page.wait_for_function("location.hash === '#q=11,0,0,-90,0'")
    page.reload()
    assert fields(view) == [11, 0, 0, -90, 0]


def test_an_address_follows_a_drag_without_a_flood(visit):
    page, view = visit("alpha")
    assert page.evaluate("location.hash") == ""
    page.evaluate("""() => {
        window.written = [];
        const replace = history.replaceState;
        history.replaceState = (...a) => {
            written.push(performance.now());
            replace.apply(history, a);
        };
    }""")
    for _ in range(40):
        range_of(view, 0).press("ArrowRight")
    page.wait_for_function("location.hash.startsWith('#q=40,')")
    written = page.evaluate("written")
    assert written and np.all(np.diff(written) > 290)  # ms: browsers refuse 100 in half a minute


@pytest.mark.parametrize("end", ["#q=1,2", "#q=a,b,c,d,e", "#q=", "#q=1,2,3,4,1e999", "#q=,,,,"])
def test_a_wrong_address_changes_nothing_and_says_so(visit, end):
    _, view = visit("alpha", end=end)
    assert fields(view) == [0, 0, 0, -90, 0]
    assert read(view)["remark"] == (
        "The address should hold 5 numbers, as in #q=0,0,0,-90,0")


def test_an_address_beyond_the_limits_stops_there(visit):
    _, view = visit("slides", end="#q=0,99,-3")
    assert fields(view)[1:] == [0.6, 0.1]
    assert "d₂ is at its limit, 0.6 m; d₃" in read(view)["remark"]


@pytest.mark.parametrize("allowed", [True, False])
def test_a_link_can_be_copied_from_a_file(visit, allowed):
    page, view = visit("alpha", permissions=["clipboard-read", "clipboard-write"])
    if not allowed:
        page.evaluate("""() => Object.defineProperty(navigator, 'clipboard', {
            value: {writeText: () => Promise.reject(new Error('not allowed'))}})""")
    range_of(view, 1).press("ArrowRight")
    view.get_by_role("button", name="Copy link").click()
    remark = view.locator(".kl-remark")
    expect(remark).to_contain_text("#q=0,1,0,-90,0")
    expect(remark).to_contain_text("This page is a file: put that behind the address")
    if allowed:
        assert page.evaluate("navigator.clipboard.readText()") == "#q=0,1,0,-90,0"
    else:
        expect(remark).to_contain_text("Copy this by hand")


def test_a_published_page_copies_its_whole_address(browser, folder, watched):
    context = browser.new_context(permissions=["clipboard-read", "clipboard-write"])
    page = watched(context.new_page())
    page.route("**/*", lambda route: route.fulfill(
        body=(folder / "axes.html").read_text(encoding="utf-8"), content_type="text/html"))
    page.goto("https://course.example/week1/axes.html#q=20")
    page.get_by_role("button", name="Copy link").click()
    expect(page.locator(".kl-remark")).to_have_text("Copied the link.")
    copied = page.evaluate("navigator.clipboard.readText()")
    assert copied == "https://course.example/week1/axes.html#q=20"
    context.close()


def test_on_a_phone_everything_fits_and_fingers_work(visit):
    page, view = visit("alpha", width=390, height=844, has_touch=True, is_mobile=True)
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    box, slider = view.locator(".kl-picture").bounding_box(), range_of(view, 0).bounding_box()
    assert slider["y"] + slider["height"] < 844  # arm and slider are seen together
    assert slider["height"] >= 40  # wide enough for a thumb
    page.touchscreen.tap(slider["x"] + 0.75 * slider["width"], slider["y"] + slider["height"] / 2)
    assert fields(view)[0] > 50
    wire = page.context.new_cdp_session(page)
    x, y = box["x"] + 150, box["y"] + 0.8 * box["height"]  # beside the arm

    def touch(kind, *points):
        wire.send("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": [
            {"x": x, "y": y, "id": k} for k, (x, y) in enumerate(points)]})

    touch("Start", (x, y))
    touch("Move", (x + 40, y))
    touch("End")
    q = from_units(ALPHA, fields(view))
    assert_picture(read(view), ALPHA, q, (-80, 24, 1))
    touch("Start", (x, y), (x + 50, y))
    touch("Move", (x - 25, y), (x + 75, y))
    touch("End")
    assert_picture(read(view), ALPHA, q, (-80, 24, 2))


def test_a_name_without_a_space_fits_a_phone(lend, watched, tmp_path):
    name = "the_arm_of_the_laboratory_with_five_joints_as_measured_in_may"
    arm = kl.Arm([kl.revolute(a=1)], name=name)
    page = watched(lend(viewport={"width": 390, "height": 844}))
    page.goto(kl.ArmView(arm).save_html(tmp_path / "long.html", f"{name}?").as_uri())
    page.locator(".kl-picture svg").wait_for()
    assert page.evaluate("document.documentElement.scrollWidth") == 390


@pytest.mark.parametrize("sandbox", ["allow-scripts", "allow-scripts allow-same-origin"])
@pytest.mark.parametrize("way", ["src", "srcdoc"])
def test_it_works_within_another_page(visit, folder, tmp_path, sandbox, way):
    frame = (folder / "axes.html").as_uri()
    # Chromium itself reports the clipboard that it denies to a frame.
    page, _ = visit("axes", watch=lambda page: page)
    troubles = []
    page.on("pageerror", lambda error: troubles.append(str(error)))
    page.set_content(f'<iframe sandbox="{sandbox}" width="800" height="600"></iframe>')
    page.evaluate("([way, text]) => { document.querySelector('iframe')[way] = text; }",
                  [way, frame if way == "src" else (folder / "axes.html").read_text("utf-8")])
    inner = page.frame_locator("iframe").locator(".kl-view")
    range_of(inner, 0).press("ArrowRight")
    expect(field_of(inner, 0)).to_have_value("36.0")
    page.wait_for_timeout(400)  # the address is not written yet, or cannot be
    inner.get_by_role("button", name="Copy link").click()
    expect(inner.locator(".kl-remark")).to_contain_text("#q=36")
    assert troubles == []


def test_on_paper_it_is_the_still_picture_with_its_numbers(visit):
    page, _ = visit("alpha", color_scheme="dark")
    page.emulate_media(media="print", color_scheme="dark")
    for selector in (".kl-toolbar", ".kl-page-foot", "input[type=range]"):
        assert not page.locator(selector).first.is_visible(), selector
    for selector in (".kl-picture svg", ".kl-pose", "math", ".kl-field"):
        assert page.locator(selector).first.is_visible(), selector
    assert page.locator("body").evaluate("b => getComputedStyle(b).color") == "rgb(43, 49, 56)"
    assert page.pdf().count(b"/Type /Page\n") == 1
    page.set_viewport_size({"width": 717, "height": 1000})  # A4 within a browser's usual margins
    last = page.locator(".kl-pose td").last.bounding_box()
    assert last["x"] + last["width"] <= 717


def test_on_paper_a_wide_matrix_shows_all_its_columns(visit):
    page, view = visit("alpha", width=390)
    lines, buttons = view.locator(".kl-on-paper > div"), view.locator(".kl-columns button")
    expect(buttons.first).to_be_visible()
    page.emulate_media(media="print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert [line.get_attribute("data-entry") for line in lines.all()] == [
        f"{row},{column}" for column in (1, 2, 3, 4) for row in (1, 2, 3)]
    expect(lines.last).to_be_visible()
    expect(buttons.first).to_be_hidden()
    page.emulate_media(media="screen")
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    expect(lines).to_have_count(0)
    expect(buttons.first).to_be_visible()


def test_dark_where_the_system_is_dark(visit):
    paint = """view => [getComputedStyle(view).backgroundColor,
        getComputedStyle(view.querySelector('.kl-x path')).stroke]"""
    _, light = visit("alpha", color_scheme="light")
    _, dark = visit("alpha", color_scheme="dark")
    assert light.evaluate(paint) == ["rgb(255, 255, 255)", "rgb(213, 94, 0)"]
    assert dark.evaluate(paint) == ["rgb(17, 20, 23)", "rgb(255, 138, 61)"]


def test_formulas_are_drawn(visit):
    page, _ = visit("alpha")
    table = page.locator("math mtable").bounding_box()
    assert table["width"] > 300 and table["height"] > 60
    subscript = page.locator("msub mn").first.bounding_box()
    letter = page.locator("msub mi").first.bounding_box()
    assert subscript["x"] > letter["x"] and subscript["y"] > letter["y"]


def test_a_matrix_that_fits_shows_no_buttons_for_its_columns(visit):
    page, view = visit("alpha")
    field_of(view, 0).fill("30")
    field_of(view, 0).press("Enter")
    page.evaluate(SETTLE)
    expect(view.locator(".kl-columns")).to_be_hidden()
    expect(view.locator(".kl-math > math")).to_be_visible()


def test_without_a_script_the_picture_still_stands(visit):
    page, _ = visit("alpha", java_script_enabled=False)
    still = page.get_by_role("img", name="Picture of the arm. ArmView('Alpha II'")
    assert still.bounding_box()["height"] > 300
    assert page.locator("math").is_visible()


def test_play_and_presets_work_as_in_the_notebook(visit):
    page, view = visit("alpha")
    view.get_by_role("button", name="Top", exact=True).click()
    assert_picture(read(view), ALPHA, ALPHA().home, (-90, 90, 1))
    view.get_by_role("button", name="Zero", exact=True).click()
    expect(field_of(view, 3)).to_have_value("0.0")
    page.evaluate(SETTLE)
    assert_picture(view.evaluate(READ), ALPHA, np.zeros(5), (-90, 90, 1))


def test_an_arm_follows_a_target_under_a_finger(visit, folder):
    kl.TargetView(kl.robots.two_link(), [0.3, 0.9]).save_html(folder / "target.html")
    page, view = visit("target", width=390, height=844, has_touch=True)
    wire = page.context.new_cdp_session(page)
    box = view.locator(".kl-picture svg").bounding_box()
    middle, scale = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2), box["width"] / 580
    for kind, points in (("Start", [(40, -60)]), ("Move", [(60, -70)]), ("End", [])):
        wire.send("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": [
            {"x": middle[0] + scale * x, "y": middle[1] + scale * y} for x, y in points]})
    expect(view.locator(".kl-readings")).to_contain_text("p* − p| = 0.000 m")
    theta_1, theta_2, x, y = fields(view)
    tool = kl.forward_kinematics(kl.robots.two_link(), np.radians([theta_1, theta_2]))[:2, 3]
    np.testing.assert_allclose(tool, [x, y], atol=0.06)  # the fields are rounded
    assert abs(x) > 0.1 and page.evaluate("document.documentElement.scrollWidth") == 390
