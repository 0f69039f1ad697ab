"""The view's buttons, keys, mouse and themes, and Python's hand on it, in a real JupyterLab."""
import numpy as np
import pytest
from grades import chosen
from lab import run_all, run_code, set_theme
from playwright.sync_api import expect
from reading import (
    assert_picture,
    assert_table,
    from_units,
    numbers,
    read,
    settle,
    steady,
    wait_for_kernel,
    wait_for_readouts,
)

import kinlab as kl

ALPHA = kl.robots.alpha_ii
SHOW = "import kinlab as kl, numpy as np\nview = kl.ArmView(kl.robots.alpha_ii())\nview"
THREE_D = (-60, 24, 1)
BUTTONS = ["Home", "Zero", "Step back", "Play", "Step forward", "Full screen", "3-D", "Top",
           "Front", "Side", "Perspective", "Frames", "Labels", "Joint axes", "Names", "Floor",
           "Trace", "Ghost", "Which frames"]


def button(view, name):
    return view.get_by_role("button", name=name, exact=True)


def picture(view):
    return view.locator(".kl-picture")


def assert_drawn(view, values, camera=THREE_D, robot=ALPHA):
    """The sliders show these values, and the picture and the table agree with them."""
    wait_for_readouts(view, values)
    seen = read(view)
    assert_picture(seen, robot, from_units(robot, values), camera)
    assert_table(seen, robot, from_units(robot, values), 1)
    return seen


def test_python_moves_the_picture_and_the_sliders(live):
    view, again, other = live(SHOW, "view", "other = kl.ArmView(kl.robots.alpha_ii())\nother",
                              views=3)
    page, home = view.page, [0, 0, 0, -90, 0]
    run_code(page, "view.q = np.radians([10, -20, 30.3, -40, 50])")
    exact = [10, -20, 30.3, -40, 50]
    for place in (view, again):
        wait_for_readouts(place, [10, -20, 30.3, -40, 50])
        assert_picture(read(place), ALPHA, np.radians(exact), THREE_D)
    np.testing.assert_allclose(wait_for_kernel(page, ALPHA, exact), np.radians(exact))
    run_code(page, "view.joints[1].value = 45")
    exact[1] = 45
    wait_for_readouts(view, [10, 45, 30.3, -40, 50])
    assert_picture(read(view), ALPHA, np.radians(exact), THREE_D)
    assert_drawn(other, home)

    view.get_by_role("slider").nth(1).press("ArrowRight")
    exact[1] = 46
    for place in (view, again):
        wait_for_readouts(place, [10, 46, 30.3, -40, 50])
        assert_picture(read(place), ALPHA, np.radians(exact), THREE_D)
    again.get_by_role("slider").nth(1).press("ArrowLeft")
    exact[1] = 45
    wait_for_readouts(view, [10, 45, 30.3, -40, 50])
    np.testing.assert_allclose(wait_for_kernel(page, ALPHA, exact), np.radians(exact))
    assert_drawn(other, home)
    text = run_code(page, "print(repr(other))")
    assert "q=[0, 0, 0, -90, 0] deg" in text


def test_a_pose_from_python_appears_as_a_whole(live):
    (view,) = live(SHOW)
    view.evaluate("""view => {
        window.tools = new Set();
        const tool = view.querySelector('#tool path');
        new MutationObserver(() => tools.add(tool.getAttribute('d'))).observe(
            tool, {attributes: true});
    }""")
    for _ in range(4):
        for q in ([0.1] * 5, [-1, 1, -1, 1, 1]):
            run_code(view.page, f"view.q = {q}")
            wait_for_readouts(view, np.degrees(q))
            settle(view.page)
    assert view.page.evaluate("tools.size") == 2  # no pose with only some joints moved


@pytest.mark.parametrize("times", chosen([1, 2], ["2"]))
def test_python_sets_any_value_exactly(live, times):
    robot, views = kl.robots.cylindrical, ["view"] * times
    cell = "import kinlab as kl\nview = kl.ArmView(kl.robots.cylindrical())"
    view = live(cell, *views, views=times)[0]
    q = [0.123456789123, 0.123456789123, 0.6 / 1.7]
    run_code(view.page, f"view.q = {q}")
    wait_for_readouts(view, [np.degrees(q[0])])
    assert_picture(read(view), robot, q, THREE_D)
    view.get_by_role("slider").nth(0).press("ArrowRight")
    wait_for_readouts(view, [8])
    after = wait_for_kernel(view.page, robot, [8, *q[1:]])
    np.testing.assert_allclose(after, [np.radians(8), *q[1:]], rtol=1e-12)


def test_beyond_a_limit_the_arm_stops_and_the_remark_says_so(live):
    (view,) = live(SHOW)
    page, remark = view.page, view.locator(".kl-remark")
    expect(remark).to_have_text("")
    run_code(page, "view.q = [9, 0, 0, 0, 0]")
    assert_drawn(view, [150, 0, 0, 0, 0])
    expect(remark).to_have_text("θ₁ stops at its limit, 150°")
    run_code(page, "view.joints[0].value = 30")
    assert_drawn(view, [30, 0, 0, 0, 0])
    expect(remark).to_have_text("")
    run_code(page, "view.joints[2].value = 500")
    assert_drawn(view, [30, 0, 135, 0, 0])
    expect(remark).to_have_text("θ₃ is at its limit, 135°")


def type_in(view, k, text):
    view.locator(".kl-field").nth(k).click()
    view.page.keyboard.press("Control+a")
    view.page.keyboard.type(text)
    view.page.keyboard.press("Enter")


def test_a_typed_number_moves_the_arm_and_stops_at_the_limit(live):
    (view,) = live(SHOW)
    type_in(view, 1, "-33")
    values = [0, -33, 0, -90, 0]
    assert_drawn(view, values)
    type_in(view, 0, "12.5")
    values[0] = 12.5
    assert_drawn(view, values)
    type_in(view, 2, "400")
    values[2] = 135
    assert_drawn(view, values)
    expect(view.locator(".kl-remark")).to_have_text("θ₃ is at its limit, 135°")
    np.testing.assert_allclose(wait_for_kernel(view.page, ALPHA, values), np.radians(values))


def test_home_zero_and_play_move_smoothly(live):
    (view,) = live(SHOW.replace("_ii()", "_ii(), poses=[[0.5, 0, 0, 0, 0], [0, 0, 0, 0, 1]]"))
    page, home = view.page, [0, 0, 0, -90, 0]
    view.evaluate("""view => {
        window.steps = new Set();
        const tool = view.querySelector('#tool path');
        new MutationObserver(() => steps.add(tool.getAttribute('d'))).observe(
            tool, {attributes: true});
    }""")
    with steady(page):
        button(view, "Zero").click()
        assert_drawn(view, [0] * 5)
    assert page.evaluate("steps.size") > 5  # moved there, did not jump
    np.testing.assert_allclose(wait_for_kernel(page, ALPHA, [0] * 5), 0, atol=1e-12)
    button(view, "Home").click()
    assert_drawn(view, home)
    np.testing.assert_allclose(wait_for_kernel(page, ALPHA, home), ALPHA().home, atol=1e-12)

    play = view.locator("[data-part=play]")
    play.click()
    expect(play).to_contain_text("Pause")
    assert play.get_attribute("aria-pressed") == "true"
    far = "() => Number(document.querySelectorAll('.kl-view .kl-field')[{}].value) > {}"
    page.wait_for_function(far.format(0, 20))
    page.wait_for_function(far.format(4, 40))
    play.click()
    expect(play).to_contain_text("Play")
    assert_stands_still(view)

    play.click()
    expect(play).to_contain_text("Pause")
    page.wait_for_timeout(200)
    view.get_by_role("slider").nth(3).press("ArrowRight")  # a hand on a slider takes over
    expect(play).to_contain_text("Play")
    assert play.get_attribute("aria-pressed") == "false"
    assert_stands_still(view)


def drawn(seen):
    """What is drawn, without the lines to names that still go to their places."""
    return {gid: path for gid, path in seen["paths"].items()
            if not gid.startswith(("label-", "name-"))}


def assert_stands_still(view):
    first = read(view)
    view.page.wait_for_timeout(300)
    assert len(drawn(first)) > 30 and drawn(read(view)) == drawn(first)
    values = first["readouts"]
    q = wait_for_kernel(view.page, ALPHA, values)
    assert_picture(first, ALPHA, q, THREE_D)


def test_presets_and_switches(live):
    (view,) = live(SHOW)
    home = [0, 0, 0, -90, 0]
    for name, camera in {"Top": (-90, 90, 1), "Front": (-90, 0, 1), "Side": (0, 0, 1),
                         "3-D": THREE_D}.items():
        button(view, name).click()
        assert_drawn(view, home, camera)
    layers = {"Frames": "frame-", "Labels": "label-", "Joint axes": "axis-", "Trace": "trace",
              "Ghost": "ghost"}
    for name, start in layers.items():
        switch = button(view, name)
        on = name in ("Frames", "Labels")
        assert switch.get_attribute("aria-pressed") == str(on).lower()
        assert shown(view, start) == {on}
        switch.click()
        assert switch.get_attribute("aria-pressed") == str(not on).lower()
        assert shown(view, start) == {not on}
    assert shown(view, "joint-") == {True}
    assert_drawn(view, home)


def shown(view, start):
    return {on for gid, on in read(view)["shown"].items() if gid.startswith(start)}


@pytest.mark.thorough
def test_the_trace_follows_the_tool(live):
    (view,) = live(SHOW)
    button(view, "Trace").click()
    slider = view.get_by_role("slider").nth(0)
    for _ in range(4):
        slider.press("ArrowRight")
        settle(view.page)
    seen = read(view)["paths"]
    went = numbers(seen["trace"])
    assert len(went) == 5
    np.testing.assert_allclose(went[-1], numbers(seen["tool"])[1], atol=0.11)
    assert np.all(np.linalg.norm(np.diff(went, axis=0), axis=1) > 1)
    button(view, "Clear").click()
    assert len(numbers(read(view)["paths"]["trace"])) == 1
    slider.press("ArrowRight")
    assert len(numbers(read(view)["paths"]["trace"])) == 2
    for _ in range(2):
        button(view, "Trace").click()
    assert len(numbers(read(view)["paths"]["trace"])) == 1
    assert button(view, "Clear").is_enabled()
    button(view, "Trace").click()
    assert button(view, "Clear").is_disabled()


def test_full_screen_and_back(live):
    (view,) = live(SHOW)
    page = view.page
    button(view, "Full screen").click()
    page.wait_for_function("document.fullscreenElement?.classList.contains('kl-view')")
    size = view.evaluate("view => parseFloat(getComputedStyle(view).fontSize)")
    box = picture(view).locator("svg").bounding_box()
    assert size > 15 and box["height"] > 0.7 * page.viewport_size["height"]
    view.get_by_role("slider").nth(1).press("ArrowLeft")
    assert_drawn(view, [0, -1, 0, -90, 0])
    button(view, "Full screen").click()
    page.wait_for_function("!document.fullscreenElement")


def test_the_mouse_orbits_zooms_and_resets(live):
    (view,) = live(SHOW)
    page, home = view.page, [0, 0, 0, -90, 0]
    box = picture(view).bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + 0.8 * box["height"]
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 40, y + 10, steps=4)
    page.mouse.up()
    page.mouse.move(x + 90, y + 90)  # no button held: nothing turns
    assert_drawn(view, home, (-80, 29, 1))
    page.wait_for_timeout(300)
    page.mouse.wheel(0, -100)
    settle(page)
    page.wait_for_timeout(100)
    assert_drawn(view, home, (-80, 29, np.exp(0.15)))
    page.mouse.down()
    page.mouse.move(x + 90, y + 900, steps=3)
    page.mouse.up()
    assert_drawn(view, home, (-80, 90, np.exp(0.15)))  # tips no farther than straight down
    page.mouse.dblclick(x, y)
    assert_drawn(view, home)


def test_the_wheel_scrolls_a_page_on_its_way(live):
    (view,) = live(SHOW)
    wheel = """(view, elsewhere) => {
        const turn = node => node.dispatchEvent(
            new WheelEvent('wheel', {deltaY: -100, bubbles: true, cancelable: true}));
        if (elsewhere) turn(document.body);
        return turn(view.querySelector('.kl-picture'));   // false: the picture keeps the event
    }"""
    assert view.evaluate(wheel, True) is True
    assert_drawn(view, [0, 0, 0, -90, 0])
    view.page.wait_for_timeout(400)
    assert view.evaluate(wheel, False) is False
    assert_drawn(view, [0, 0, 0, -90, 0], (-60, 24, np.exp(0.15)))


FOCUSED = """() => {
    const at = document.activeElement, view = at.closest('.kl-view');
    if (!view) return '';
    if (at.type === 'range')
        return 'slider ' + [...view.querySelectorAll('[type=range]')].indexOf(at);
    return at.classList.contains('kl-picture') ? 'picture' : at.ariaLabel ||
        (at.dataset.part === 'play' ? 'Play' : at.textContent);
}"""


def test_everything_works_from_the_keyboard_alone(live):
    (view,) = live("1", SHOW, "2")
    page, values = view.page, [0, 0, 0, -90, 0]
    picture(view).focus()
    seen = [page.evaluate(FOCUSED)]
    page.keyboard.press("Tab")                      # all buttons are one stop
    seen.append(page.evaluate(FOCUSED))
    for _ in BUTTONS:                               # and a list among them
        page.keyboard.press("ArrowRight")
        seen.append(page.evaluate(FOCUSED))
    for _ in range(10):
        page.keyboard.press("Tab")
        seen.append(page.evaluate(FOCUSED))
    wanted = ["picture", *BUTTONS, *(f"slider {i}" for i in range(5))]
    assert [name for name in seen if name in wanted] == wanted

    button(view, "Top").focus()
    page.keyboard.press("Enter")
    assert_drawn(view, values, (-90, 90, 1))
    button(view, "3-D").focus()
    page.keyboard.press("Space")
    assert_drawn(view, values)
    button(view, "Zero").focus()
    page.keyboard.press("Enter")
    assert_drawn(view, [0] * 5)
    button(view, "Ghost").focus()
    page.keyboard.press("Space")
    assert shown(view, "ghost") == {True}

    active = "jupyterapp.shell.currentWidget.content.activeCellIndex"
    picture(view).click()
    at = page.evaluate(active)
    for key in ("ArrowLeft", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowUp", "ArrowDown"):
        page.keyboard.press(key)
    assert_drawn(view, [0] * 5, (-55, 29, 1))
    for key in ("+", "=", "-", "+"):
        page.keyboard.press(key)
    assert_drawn(view, [0] * 5, (-55, 29, 1.15**2))
    page.keyboard.press("0")
    assert_drawn(view, [0] * 5)

    view.get_by_role("slider").nth(1).focus()
    for key, value in {"PageDown": -10, "ArrowRight": -9, "Shift+ArrowRight": -8.9,
                       "End": 120, "Home": -120}.items():
        page.keyboard.press(key)
        assert_drawn(view, [0, value, 0, 0, 0])
    assert page.evaluate(active) == at  # no key reached the notebook
    assert page.locator(".jp-Notebook:visible .jp-Cell").count() == 3


LOOK = """view => {
    const style = (selector, property) =>
        getComputedStyle(view.querySelector(selector))[property];
    const axes = ['x', 'y', 'z'];
    return {
        strokes: axes.map(axis => style(`#frame-0-${axis} path`, 'stroke')),
        names: axes.map(axis => style(`#label-0-${axis} text`, 'fill')),
        words: ['.kl-pose td', '.kl-button', '.kl-remark'].map(s => style(s, 'color')),
        paper: getComputedStyle(view).backgroundColor,
        button: style('.kl-button', 'backgroundColor'),
    };
}"""


def luminance(colour):
    """Relative luminance of rgb(r, g, b), WCAG 2."""
    channels = np.array([float(part) for part in colour[colour.index("(") + 1:-1].split(",")][:3])
    s = channels / 255
    linear = np.where(s <= 0.04045, s / 12.92, ((s + 0.055) / 1.055) ** 2.4)
    return float(linear @ [0.2126, 0.7152, 0.0722])


def contrast(one, other):
    low, high = sorted([luminance(one), luminance(other)])
    return (high + 0.05) / (low + 0.05)


def test_light_and_dark_themes(live, tmp_path):
    (view,) = live(SHOW)
    page, looks = view.page, {}
    try:
        for theme in ("JupyterLab Light", "JupyterLab Dark"):
            set_theme(page, theme)
            settle(page)
            looks[theme] = look = view.evaluate(LOOK)
            page.screenshot(path=tmp_path / f"{theme}.png")
            assert min(contrast(name, look["paper"]) for name in look["names"]) >= 3
            assert min(contrast(stroke, look["paper"]) for stroke in look["strokes"]) >= 3
            assert min(contrast(word, look["paper"]) for word in look["words"]) >= 4.5
            assert contrast(look["words"][1], look["button"]) >= 4.5
            assert len(set(look["strokes"])) == 3
    finally:
        set_theme(page, "JupyterLab Light")
    light, dark = looks.values()
    for part in ("strokes", "names", "words"):
        assert all(one != other for one, other in zip(light[part], dark[part]))
    assert luminance(light["paper"]) > 0.9 and luminance(dark["paper"]) < 0.05


ICONS = """() => [...document.querySelectorAll('#jp-main-dock-panel svg, #jp-left-stack svg')]
    .filter(svg => !svg.closest('.kl-view')).slice(0, 40)
    .flatMap(svg => [...svg.querySelectorAll('path')])
    .map(path => getComputedStyle(path)).map(s => s.strokeLinecap + s.strokeLinejoin)"""


def test_other_icons_of_the_page_keep_their_strokes(notebook):
    page = notebook(SHOW, run=False)
    before = page.evaluate(ICONS)
    run_all(page)
    page.locator(".kl-picture svg").wait_for()
    settle(page)
    after = page.evaluate(ICONS)
    assert before and set(after) == set(before)


def test_a_closed_form_is_typeset_below(live):
    (view,) = live(SHOW.replace("_ii()", "_ii(), closed_form=True"))
    view.locator(".kl-math math").first.wait_for()
    assert "234" in view.locator(".kl-math").inner_text()
    below = view.locator(".kl-math").bounding_box()["y"]
    box = picture(view).bounding_box()
    assert below >= box["y"] + box["height"] - 1


def test_a_view_that_is_closed_leaves_nothing_behind(live):
    (view,) = live(SHOW)
    page = view.page
    button(view, "Play").click()
    page.evaluate("jupyterapp.commands.execute('notebook:clear-all-cell-outputs')")
    expect(page.locator(".kl-view")).to_have_count(0)
    first = run_code(page, "print(view.q.tolist())")
    page.wait_for_timeout(300)
    assert run_code(page, "print(view.q.tolist())") == first


@pytest.mark.parametrize("width", chosen([1280, 640], ["1280"]))
def test_nothing_lies_over_anything_else(live, width):
    (view,) = live(SHOW.replace("_ii()", "_ii(), closed_form=True"))
    page = view.page
    page.set_viewport_size({"width": width, "height": 900})
    try:
        settle(page)
        parts = [".kl-toolbar", ".kl-picture", ".kl-joints", ".kl-pose", ".kl-math"]
        boxes = [view.locator(part).first.bounding_box() for part in parts]
    finally:
        page.set_viewport_size({"width": 1280, "height": 900})
    for i, a in enumerate(boxes):
        assert a["width"] > 100 and a["height"] > 20
        for b in boxes[:i]:
            across = min(a["x"] + a["width"], b["x"] + b["width"]) - max(a["x"], b["x"])
            down = min(a["y"] + a["height"], b["y"] + b["height"]) - max(a["y"], b["y"])
            assert min(across, down) <= 1




def test_a_view_in_a_notebook_has_no_scrollbar(notebook):
    """A pixel too much is enough for one, and the first turn of the wheel would go into it."""
    page = notebook("import kinlab as kl\nkl.ArmView(kl.robots.two_link())")
    view = page.locator(".jp-Notebook:visible .kl-view")
    view.locator("svg").first.wait_for()
    size = page.viewport_size
    try:
        for width in (1300, 1366, 1500, 1920):
            page.set_viewport_size({"width": width, "height": 800})
            settle(page)
            assert view.evaluate("""node => node.closest('.jp-OutputArea-output').scrollHeight
                - node.closest('.jp-OutputArea-output').clientHeight""") == 0
    finally:
        page.set_viewport_size(size)
