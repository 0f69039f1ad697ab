"""Enter to picture: a length typed into a DHTableEditor, until the arm with it is painted.

The whole way: the browser's cell, Python's table and arm, a new scene, the picture of it.
"""
from __future__ import annotations

from pathlib import Path

import numpy as np
from measure import goal, header, table
from slider_latency import Subject, measured, write

# slider_latency has put the browser tests' helpers on the path
from lab import Lab, open_and_run, shut_down_kernels  # isort: skip
from playwright.sync_api import Page  # isort: skip

EDITS = 20
GOAL_MS = 100
CELL = "import kinlab as kl\nkl.DHTableEditor(kl.robots.{robot}())"


def subjects() -> list[Subject]:
    return [Subject(name, [CELL.format(robot=robot)], "svg", ".kl-editor")
            for name, robot in (("two links", "two_link"), ("Alpha II", "alpha_ii"),
                                ("six-link", "practical_six_link"))]


def edit(page: Page) -> list[float]:
    """Milliseconds from Enter to the painted change, one edit at a time."""
    cell, late = page.get_by_label("a₁, ").first, []
    for k in range(EDITS):
        cell.fill(str(1 + 0.05 * (k + 1)))
        page.wait_for_timeout(150)
        page.evaluate("takeLog()")
        cell.press("Enter")
        page.wait_for_function("countPictures()", polling=20, timeout=10_000)
        log = page.evaluate("takeLog()")
        late.append(log["pictures"][0]["time"] - log["keys"][-1])
    return late


def measure(page: Page, lab: Lab, root: Path, subject: Subject) -> None:
    open_and_run(page, lab, write(root, subject))
    page.evaluate("jupyterapp.commands.execute('application:toggle-left-area')")
    editor = page.locator(subject.picture).first
    editor.locator(".kl-picture svg").wait_for()
    page.wait_for_timeout(2000)
    page.evaluate("([kind, box]) => { watch(kind, box, document.body); }",
                  [subject.kind, editor.element_handle()])
    subject.latencies += edit(page)
    shut_down_kernels(page)


def main() -> None:
    header("Enter to picture, a DH table", "jupyterlab", "ipywidgets", "playwright")
    found = measured(subjects(), measure)
    rows = [[subject.name, len(subject.latencies), *np.percentile(subject.latencies, [50, 95]),
             max(subject.latencies)] for subject in found]
    table(["", "edits", "p50 ms", "p95 ms", "max ms"], rows)
    worst = max(line[2] for line in rows)
    goal(f"median from Enter to painted change at most {GOAL_MS} ms: {worst:.1f} ms",
         worst <= GOAL_MS)


if __name__ == "__main__":
    main()
