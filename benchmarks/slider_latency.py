"""Slider to picture: ArmView, interact, ipympl and an Image widget in a real JupyterLab.

Two figures each: key press to painted change, and distinct pictures during a mouse drag.
"""
from __future__ import annotations

import random
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import nbformat
import numpy as np
from measure import NOT_INSTALLED, goal, header, peer, progress, table
from peers import COMMON, IMAGE, INTERACT, IPYMPL

sys.path.insert(0, str(Path(__file__).parent.parent / "tests" / "browser"))
from lab import Lab, open_and_run, open_browser, shut_down_kernels, start_lab
from playwright.sync_api import Locator, Page

ROUNDS, PRESSES = 3, 30
MOVES, MOVES_PER_SECOND = 120, 60
GOAL_MS, GOAL_RATIO = 33, 5
JOINT = 1  # the shoulder: everything beyond it moves
WATCH = (Path(__file__).parent / "watch.js").read_text()


@dataclass
class Subject:
    """A way to move the arm: its notebook, its picture, and what was measured."""

    name: str
    cells: list[str]
    kind: str
    picture: str
    needs: str = "kinlab"
    latencies: list[float] = field(default_factory=list)
    drags: list[dict[str, float]] = field(default_factory=list)


def subjects() -> list[Subject]:
    return [
        Subject("ArmView", ["import kinlab as kl", "kl.ArmView(kl.robots.alpha_ii())"],
                "svg", ".kl-picture"),
        Subject("interact, inline figure", [COMMON, INTERACT], "img", ".widget-output"),
        Subject("ipympl, set_data", [COMMON, IPYMPL], "canvas", ".jupyter-matplotlib-figure",
                "ipympl"),
        Subject("Agg figure in an Image", [COMMON, IMAGE], "img", "img.widget-image"),
    ]


def write(root: Path, subject: Subject) -> str:
    """The subject's notebook below the root; its file name."""
    cells = [nbformat.v4.new_code_cell(code) for code in subject.cells]
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    notebook = nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": kernel})
    name = subject.name.replace(" ", "_").replace(",", "") + ".ipynb"
    nbformat.write(notebook, root / name)
    return name


def set_up(page: Page, lab: Lab, notebook: str, subject: Subject) -> Locator:
    """Open and run the notebook, watch picture and slider; the slider's handle."""
    open_and_run(page, lab, notebook)
    page.evaluate("jupyterapp.commands.execute('application:toggle-left-area')")
    picture = page.locator(subject.picture).first
    picture.wait_for()
    picture.scroll_into_view_if_needed()
    handle = page.get_by_role("slider").nth(JOINT)
    page.wait_for_timeout(2000)  # let the kernel and the page come to rest
    page.evaluate("([kind, box, handle]) => { watch(kind, box, handle); }",
                  [subject.kind, picture.element_handle(), handle.element_handle()])
    for part in (picture, handle):
        assert in_sight(page, part), f"{subject.name}: picture and slider do not fit the window"
    return handle


def in_sight(page: Page, part: Locator) -> bool:
    box, window = part.bounding_box(), page.viewport_size
    return box["y"] >= 0 and box["y"] + box["height"] <= window["height"]


def press_keys(page: Page, handle: Locator) -> list[float]:
    """Milliseconds from key press to painted change, one press at a time."""
    handle.focus()
    latencies = []
    for _ in range(PRESSES):
        page.wait_for_timeout(random.uniform(150, 200))  # the last is over; any point of a frame
        page.evaluate("takeLog()")
        page.keyboard.press("ArrowRight")
        page.wait_for_function("countPictures()", polling=20, timeout=10_000)
        log = page.evaluate("takeLog()")
        latencies.append(log["pictures"][0]["time"] - log["keys"][0])
    return latencies


def drag(page: Page, handle: Locator) -> dict[str, float]:
    """Pull the handle along its track; see `drag_figures`."""
    ipywidgets = handle.locator("xpath=ancestor::*[contains(@class, 'noUi-base')]")
    track = (ipywidgets if ipywidgets.count() else handle).bounding_box()
    path = track["x"] + track["width"] * np.linspace(0.05, 0.95, MOVES + 1)
    y = track["y"] + track["height"] / 2
    if ipywidgets.count():
        handle.hover()
    else:
        page.mouse.move(path[0], y)
    page.mouse.down()
    page.mouse.move(path[0], y)
    wait_until_still(page)
    page.evaluate("takeLog()")
    start, began = page.evaluate("performance.now()"), time.perf_counter()
    for count, x in enumerate(path[1:], start=1):
        page.mouse.move(x, y)
        time.sleep(max(0, began + count / MOVES_PER_SECOND - time.perf_counter()))
    end = page.evaluate("performance.now()")
    page.mouse.up()
    wait_until_still(page)
    return drag_figures(page.evaluate("takeLog()"), start, end)


def drag_figures(log: dict, start: float, end: float) -> dict[str, float]:
    """Moves and distinct pictures per second of the drag; distinct values and pictures in all."""
    during = {shown["picture"] for shown in log["pictures"] if start <= shown["time"] <= end}
    return {"rate": len(during) / (end - start) * 1000, "values": len(set(log["values"])),
            "pictures": len({shown["picture"] for shown in log["pictures"]}),
            "moves": MOVES / (end - start) * 1000}


def wait_until_still(page: Page) -> None:
    """Wait until no new picture has come for a second."""
    count, before = page.evaluate("countPictures()"), -1
    while count != before:
        page.wait_for_timeout(1000)
        count, before = page.evaluate("countPictures()"), count


def measure(page: Page, lab: Lab, root: Path, subject: Subject) -> None:
    """One round: key presses, then a drag, in a freshly opened notebook."""
    handle = set_up(page, lab, write(root, subject), subject)
    subject.latencies += press_keys(page, handle)
    subject.drags.append(drag(page, handle))
    shut_down_kernels(page)


def measured(found: list[Subject], measure: Callable[[Page, Lab, Path, Subject], None],
             script: str = WATCH) -> list[Subject]:
    """All subjects that are installed, their rounds interleaved, each in a page with a script."""
    with tempfile.TemporaryDirectory() as root, start_lab(root) as lab, open_browser() as browser:
        for turn in range(1, ROUNDS + 1):
            for subject in (s for s in found if peer(s.needs)):
                progress(f"round {turn} of {ROUNDS}: {subject.name}")
                page = browser.new_page(viewport={"width": 1400, "height": 1100})
                page.add_init_script(script)
                measure(page, lab, Path(root), subject)
                page.close()
    progress()
    return found


def row(subject: Subject, ours: Subject) -> list:
    if not subject.latencies:
        return [subject.name, NOT_INSTALLED, *[""] * 8]
    p50, p95 = np.percentile(subject.latencies, [50, 95])
    return [subject.name, len(subject.latencies), p50, p95, max(subject.latencies),
            p95 / np.percentile(ours.latencies, 95), middle(subject, "moves"),
            middle(subject, "rate"), middle(subject, "values"), middle(subject, "pictures")]


def middle(subject: Subject, key: str) -> float:
    return float(np.median([figures[key] for figures in subject.drags]))


def show_goals(ours: Subject, interact: Subject) -> None:
    p95 = np.percentile(ours.latencies, 95)
    goal(f"ArmView: p95 from key press to painted change at most {GOAL_MS} ms: {p95:.1f} ms",
         p95 <= GOAL_MS)
    times = np.percentile(interact.latencies, 95) / p95
    goal(f"at least {GOAL_RATIO} times below interact: {times:.1f} times", times >= GOAL_RATIO)
    lost = [figures["values"] - figures["pictures"] for figures in ours.drags]
    goal(f"every step of a drag drawn: {max(lost)} of {ours.drags[0]['values']} steps lost "
         f"in the worst of {len(lost)} drags", max(lost) <= 0)


def main() -> None:
    header("Slider to picture, Alpha II", "jupyterlab", "ipywidgets", "ipympl", "playwright")
    found = measured(subjects(), measure)
    table(["", "presses", "p50 ms", "p95 ms", "max ms", "p95 times ArmView", "drag: moves/s",
           "pictures/s", "values", "pictures"],
          [row(subject, found[0]) for subject in found])
    show_goals(*found[:2])


if __name__ == "__main__":
    main()
