"""What a view does while it is dragged, and when its kernel, its page or its notebook goes."""
import time

import nbformat
import numpy as np
import pytest
from grades import chosen
from lab import open_notebook, run_all, run_code, shut_down_kernels
from playwright.sync_api import expect
from reading import (
    assert_picture,
    assert_table,
    read,
    settle,
    take,
    wait_for_kernel,
    wait_for_readouts,
)

import kinlab as kl

pytestmark = pytest.mark.usefixtures("own_kernel")
THREE_D = (-60, 24, 1)
ALPHA = kl.robots.alpha_ii
SHOW = "import kinlab as kl, numpy as np\nview = kl.ArmView(kl.robots.alpha_ii())\nview"

BUSY = ("import threading\n"
        "threading.Thread(target=lambda: [sum(range(10**6)) for _ in range(150)]).start()")

# Notes each value sent to the kernel, each value that a slider shows, and each picture.
LISTEN = """view => {
    const kernel = jupyterapp.shell.currentWidget.sessionContext.session.kernel;
    Object.assign(window, {said: [], shown: [], drawn: new Set()});
    kernel.anyMessage.connect((_, {direction, msg}) => {
        const [value] = Object.entries(msg.content.data?.state ?? {})
            .filter(([name]) => name.startsWith('theta_')).map(([, angle]) => angle);
        if (direction === 'send' && value !== undefined)
            said.push([msg.content.comm_id, performance.now(), value]);
    });
    const range = view.querySelectorAll('[type=range]')[1];
    const value = () => shown.push(range.valueAsNumber);
    new MutationObserver(value).observe(range, {attributeFilter: ['aria-valuetext']});
    const tool = view.querySelector('#tool path');
    const picture = () => drawn.add(tool.getAttribute('d'));
    new MutationObserver(picture).observe(tool, {attributes: true});
}"""


def drag(view, k, start, end, seconds):
    """Pull slider k's handle from one share of its track to another, each move painted.

    Sixty moves a second at most; on a busy machine it takes longer, and holds the same.
    """
    page, handle = view.page, view.get_by_role("slider").nth(k)
    _, y = take(handle)
    track, began = handle.bounding_box(), time.perf_counter()
    for count, share in enumerate(np.linspace(start, end, round(60 * seconds))):
        page.mouse.move(track["x"] + share * track["width"], y)
        settle(page)
        time.sleep(max(0, began + count / 60 - time.perf_counter()))
    page.mouse.up()


def most_in_a_second(said):
    """The most messages of one slider within any second."""
    times = {}
    for slider, time_, _ in said:
        times.setdefault(slider, []).append(time_)
    return max(sum(0 <= t - first < 1000 for t in found)
               for found in times.values() for first in found)


@pytest.mark.parametrize("busy", chosen(["", BUSY], ["idle"], ["idle", "busy"]))
def test_a_drag_tells_python_ten_times_a_second_and_the_last_value(live, busy):
    (view,) = live(SHOW)
    page = view.page
    run_code(page, busy)
    view.evaluate(LISTEN)
    drag(view, 1, 0.5, 0.85, 1.0)
    page.wait_for_function("said.length && said.at(-1)[2] === shown.at(-1)")
    said, shown, drawn = page.evaluate("[said, shown, drawn.size]")
    assert shown == sorted(shown)  # no echo of an older value moved the slider back
    assert most_in_a_second(said) <= 11 and len(said) > 3
    assert drawn >= len(set(shown)) > 10  # every step, whatever Python does
    value = shown[-1]
    assert said[-1][2] == value
    np.testing.assert_allclose(wait_for_kernel(page, ALPHA, [0, value, 0, -90, 0]),
                               np.radians([0, value, 0, -90, 0]), atol=1e-12)
    assert read(view)["readouts"][1] == value


def test_play_and_keys_tell_python_ten_times_a_second(live):
    (view,) = live(SHOW)
    page, home = view.page, [0, 0, 0, -90, 0]
    view.evaluate(LISTEN)
    view.locator("[data-part=play]").click()
    page.wait_for_function("said.length > 3 && drawn.size > 3")
    view.locator("[data-part=play]").click()
    said, drawn = page.evaluate("[said, drawn.size]")
    assert most_in_a_second(said) <= 11 and drawn > 3
    view.get_by_role("button", name="Home", exact=True).click()
    wait_for_readouts(view, home)
    np.testing.assert_allclose(wait_for_kernel(page, ALPHA, home), ALPHA().home, atol=1e-12)
    page.evaluate("said.length = 0")
    for _ in range(60):
        view.get_by_role("slider").nth(1).press("ArrowRight")
    said = page.evaluate("said")
    assert most_in_a_second(said) <= 11
    wait_for_readouts(view, [0, 60, 0, -90, 0])
    np.testing.assert_allclose(wait_for_kernel(page, ALPHA, [0, 60, 0, -90, 0]),
                               np.radians([0, 60, 0, -90, 0]), atol=1e-12)


KERNEL = "jupyterapp.shell.currentWidget.sessionContext.session.kernel"
DEAF = "Python no longer listens to this view."
RESTART = f"() => {KERNEL}.restart()"
DIE = "{code: 'import os; os._exit(1)'}"
KILL = f"() => {{ {KERNEL}.requestExecute({DIE}).done.catch(() => 0); }}"
SHUT_DOWN = "() => jupyterapp.shell.currentWidget.sessionContext.shutdown()"


def silence(view):
    return view.locator(".kl-silence")


def assert_moves_alone(view, k=1):
    """A key on a slider moves picture, table and read-out as ever."""
    before = read(view)["readouts"]
    view.get_by_role("slider").nth(k).press("ArrowRight")
    values = [value + (i == k) for i, value in enumerate(before)]
    wait_for_readouts(view, values)
    seen = read(view)
    assert_picture(seen, ALPHA, np.radians(values), THREE_D)
    assert_table(seen, ALPHA, np.radians(values), 1)


@pytest.mark.parametrize("end", chosen(
    [RESTART, KILL, SHUT_DOWN], ["restart"], ["restart", "kill", "shut down"]))
def test_without_its_kernel_a_view_moves_and_says_that_python_is_gone(live, end):
    view, again = live(SHOW, "view", views=2)
    page = view.page
    expect(silence(view)).to_be_empty()
    page.evaluate(end)
    for place in (view, again):
        expect(silence(place)).to_contain_text(DEAF)
    if end == KILL:
        page.get_by_role("button", name="Ok").click()  # JupyterLab's own word on it
    assert_moves_alone(view)
    drag(view, 1, 0.5, 0.7, 0.3)
    page.wait_for_timeout(300)
    assert_moves_alone(again)
    assert_no_error_box(page)
    if end == SHUT_DOWN:
        return
    page.wait_for_function(f"{KERNEL}?.status === 'idle'")
    run_all(page)
    for place in (view, again):
        expect(silence(place)).to_be_empty()
    view.get_by_role("slider").nth(1).press("ArrowRight")
    np.testing.assert_allclose(wait_for_kernel(page, ALPHA, [0, 1, 0, -90, 0])[1], np.radians(1))


def test_a_tab_that_slept_wakes_with_the_numbers_of_now(live):
    (view,) = live(SHOW)
    page = view.page
    session = page.context.new_cdp_session(page)
    later = "'import time; time.sleep(1); view.q = np.radians([0, 30, 0, -90, 0])'"
    page.evaluate(f"() => {{ {KERNEL}.requestExecute({{code: {later}}}); }}")
    session.send("Page.setWebLifecycleState", {"state": "frozen"})
    time.sleep(2)  # Python moves the arm meanwhile
    session.send("Page.setWebLifecycleState", {"state": "active"})
    assert_drawn(view, [0, 30, 0, -90, 0])
    view.evaluate("""view => {
        window.heard = [];
        const line = view.querySelector('.kl-silence');
        new MutationObserver(() => heard.push(line.textContent)).observe(line, {childList: true});
    }""")
    view.evaluate(f"""view => {{
        {KERNEL}.reconnect();  // a key goes down before it is back
        view.querySelectorAll('[type=range]')[1].dispatchEvent(
            new KeyboardEvent('keydown', {{key: 'ArrowRight', bubbles: true}}));
    }}""")
    page.wait_for_function("heard.length > 1")  # said, and withdrawn when it was back
    assert page.evaluate("heard[0]").startswith("No connection to Python now.")
    expect(silence(view)).to_be_empty()
    wait_for_kernel(page, ALPHA, [0, 31, 0, -90, 0])
    assert_moves_alone(view)
    wait_for_kernel(page, ALPHA, [0, 32, 0, -90, 0])
    run_all(page)  # and once more: one view, with the numbers of the new one
    assert_drawn(view, [0, 0, 0, -90, 0])
    assert_moves_alone(view)
    wait_for_kernel(page, ALPHA, [0, 1, 0, -90, 0])
    assert_no_error_box(page)


def assert_no_error_box(page):
    assert page.locator(".jp-Dialog").count() == 0
    shown = page.locator(".jp-Notebook:visible .jp-OutputArea-output").all_inner_texts()
    assert not [text for text in shown if "rror" in text]


SAVE = "jupyterapp.commands.execute('docmanager:save')"


def alive(page):
    view = page.locator(".kl-view")
    view.locator(".kl-picture svg").wait_for()
    view.locator(".kl-field").last.wait_for()
    return view


def assert_drawn(view, values):
    wait_for_readouts(view, values)
    seen = read(view)
    assert_picture(seen, ALPHA, np.radians(values), THREE_D)
    assert_table(seen, ALPHA, np.radians(values), 1)


@pytest.mark.thorough
def test_a_page_loaded_again_shows_the_arm_as_it_stands(own_page, lab, root):
    page = own_page(SHOW)
    run_all(page)
    view = alive(page)
    view.get_by_role("slider").nth(1).press("PageUp")
    wait_for_kernel(page, ALPHA, [0, 10, 0, -90, 0])
    page.evaluate(SAVE)
    run_code(page, "view.q = np.radians([0, 20, 0, -90, 0])")
    wait_for_readouts(view, [0, 20, 0, -90, 0])

    page.reload()  # the kernel lives on
    view = alive(page)
    assert_drawn(view, [0, 20, 0, -90, 0])
    expect(silence(view)).to_be_empty()
    assert_moves_alone(view)
    page.wait_for_function(f"{KERNEL}?.status === 'idle'")
    wait_for_kernel(page, ALPHA, [0, 21, 0, -90, 0])
    page.evaluate(SAVE)

    for value in (21, 22):  # opened, not run, moved, saved, and opened again
        shut_down_kernels(page)
        open_notebook(page, lab, "own.ipynb")
        view = alive(page)
        expect(silence(view)).to_contain_text(DEAF)
        assert_drawn(view, [0, value, 0, -90, 0])
        assert_moves_alone(view)
        assert_no_error_box(page)
        page.evaluate(SAVE)
    assert (root / "own.ipynb").stat().st_size < 300_000
    give_away(root / "own.ipynb", root / "theirs.ipynb")
    run_all(page)
    assert_drawn(alive(page), [0, 0, 0, -90, 0])
    page.evaluate(SAVE)
    assert (root / "own.ipynb").stat().st_size < 300_000  # what no cell shows is not kept

    open_notebook(page, lab, "theirs.ipynb")  # somebody else's: JupyterLab does not trust it
    still = page.locator(".jp-OutputArea-output img")
    assert still.evaluate("image => image.naturalWidth") > 400
    assert_no_error_box(page)


def give_away(mine, theirs):
    notebook = nbformat.read(mine, as_version=4)
    notebook.cells[0].source += "  # mine"  # another text than the one that was signed here
    nbformat.write(notebook, theirs)
