"""A view in marimo: another host of widgets, which knows nothing of ipywidgets' own sliders."""
import re
import socket
import subprocess
import sys
import time
from urllib.error import URLError
from urllib.request import urlopen

import numpy as np
import pytest
from playwright.sync_api import expect
from reading import READ, SETTLE, assert_picture, assert_table, take

import kinlab as kl

pytestmark = pytest.mark.thorough
ALPHA = kl.robots.alpha_ii
APP = """
import marimo

app = marimo.App()


@app.cell
def _():
    import kinlab as kl
    import marimo as mo
    return kl, mo


@app.cell
def _(kl, mo):
    said, say = mo.state("nothing yet")
    arm = kl.ArmView(kl.robots.alpha_ii(), closed_form=True)
    arm.observe(lambda change: say(f"Python has {change.new:g} degrees"), "theta_2")
    arm
    return arm, said


@app.cell
def _(mo, said):
    mo.md(said())
    return
"""


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    """The address of marimo's own server, which shows an arm."""
    folder = tmp_path_factory.mktemp("marimo")
    (folder / "arm.py").write_text(APP, encoding="utf-8")
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = [sys.executable, "-m", "marimo", "--yes", "run", "arm.py", "--headless",
               "--no-token", "--host", "127.0.0.1", "--port", str(port)]
    with (folder / "log").open("wb") as log:
        process = subprocess.Popen(command, cwd=folder, stdout=log, stderr=log)
    address = f"http://127.0.0.1:{port}"
    try:
        wait_for(address, process, folder / "log")
        yield address
    finally:
        process.terminate()
        process.wait(20)


def wait_for(address, process, log):
    end = time.monotonic() + 60
    while time.monotonic() < end and process.poll() is None:
        try:
            with urlopen(f"{address}/health", timeout=5):
                return
        except (URLError, OSError):
            time.sleep(0.1)
    raise RuntimeError(f"marimo did not start:\n{log.read_text()}")


def heard(page, degrees):
    said = page.get_by_text(re.compile(f"^Python has {degrees} degrees$"))
    expect(said).to_be_visible(timeout=20_000)


def test_an_arm_shows_itself_moves_and_tells_python(server, browser):
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    troubles = []
    page.on("pageerror", lambda error: troubles.append(str(error)))
    page.goto(server)
    view = page.locator(".kl-view")
    view.locator(".kl-picture svg").wait_for(timeout=60_000)
    expect(view.locator("math mtable")).to_be_visible()
    slider, field = view.get_by_role("slider").nth(1), view.locator(".kl-field").nth(1)
    assert slider.get_attribute("aria-label").startswith("θ₂")
    for _ in range(3):
        slider.press("ArrowRight")
    expect(field).to_have_value("3.0")
    page.evaluate(SETTLE)
    seen = view.evaluate(READ)
    assert_picture(seen, ALPHA, np.radians([0, 3, 0, -90, 0]), (-60, 24, 1))
    assert_table(seen, ALPHA, np.radians([0, 3, 0, -90, 0]), 1)
    heard(page, "3")
    x, y = take(slider)
    page.mouse.move(x + 20, y, steps=4)
    page.mouse.up()
    assert field.input_value() not in ("3.0", "0.0")
    heard(page, f"{float(field.input_value()):g}")
    assert troubles == []
    page.close()
