"""Pointer to picture while a target is dragged: TargetView, and ipympl with the kernel solving.

Both solve inverse kinematics at every move; the peer as one would write it with a matplotlib
figure whose mouse events run in Python, its solver kinlab's own.
"""
from __future__ import annotations

import time
from pathlib import Path

import numpy as np
from measure import NOT_INSTALLED, goal, header, table
from slider_latency import WATCH, Subject, measured, wait_until_still, write

# slider_latency has put the browser tests' helpers on the path
from lab import Lab, open_and_run, shut_down_kernels  # isort: skip
from playwright.sync_api import Locator, Page  # isort: skip

MOVES, MOVES_PER_SECOND = 120, 60
GOAL_MS = 33
# Notes when the pointer moved while its button was down.
POINTER = """window.moves = [];
window.addEventListener("pointermove", (e) => { if (e.buttons) moves.push(e.timeStamp); }, true);
"""
OURS = "import kinlab as kl\nkl.TargetView(kl.robots.{robot}())"
PEER = """\
%matplotlib widget
import matplotlib.pyplot as plt
import numpy as np
import kinlab as kl

arm = kl.robots.two_link()
q = arm.home
with plt.ioff():
    figure = plt.figure(figsize=(5, 5))
axes = figure.add_subplot(xlim=(-2.5, 2.5), ylim=(-2.5, 2.5))
line = axes.plot(*kl.link_frames(arm, q)[:, :2, 3].T, "o-", lw=4)[0]

def move(event):
    global q
    if event.button and event.inaxes:
        place = [event.xdata, event.ydata, 0]
        q = kl.inverse_kinematics(arm, place, q, weights=[1, 1, 0], restarts=0).q
        line.set_data(*kl.link_frames(arm, q)[:, :2, 3].T)
        figure.canvas.draw_idle()

figure.canvas.mpl_connect("motion_notify_event", move)
figure.canvas
"""


def subjects() -> list[Subject]:
    return [
        Subject("TargetView, two links", [OURS.format(robot="two_link")], "svg", ".kl-picture"),
        Subject("TargetView, Alpha II", [OURS.format(robot="alpha_ii")], "svg", ".kl-picture"),
        Subject("TargetView, six-link", [OURS.format(robot="practical_six_link")], "svg",
                ".kl-picture"),
        Subject("ipympl, two links", [PEER], "canvas", ".jupyter-matplotlib-figure", "ipympl"),
    ]


def start_of(page: Page, picture: Locator) -> tuple[float, float]:
    """The middle of the ring, or for the peer a place within its axes."""
    ring = page.locator("#target-0")
    box = (ring if ring.count() else picture).bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def drag(page: Page, picture: Locator) -> tuple[list[float], dict[str, float]]:
    """Milliseconds from each move to the next painted change, and pictures per second."""
    x, y = start_of(page, picture)
    angles = np.linspace(0, 2 * np.pi, MOVES + 1)
    page.mouse.move(x, y)
    page.mouse.down()
    wait_until_still(page)
    page.evaluate("takeLog(), moves.length = 0")
    began = time.perf_counter()
    for count, angle in enumerate(angles[1:], start=1):
        page.mouse.move(x - 60 * (1 - np.cos(angle)), y + 60 * np.sin(angle))
        time.sleep(max(0, began + count / MOVES_PER_SECOND - time.perf_counter()))
    seconds = time.perf_counter() - began
    page.mouse.up()
    wait_until_still(page)
    painted = np.array([shown["time"] for shown in page.evaluate("takeLog()")["pictures"]])
    moves = np.array(page.evaluate("moves"))
    late = [painted[painted > move][0] - move for move in moves if np.any(painted > move)]
    return late, {"moves": len(moves), "pictures": len(painted), "rate": len(painted) / seconds}


def measure(page: Page, lab: Lab, root: Path, subject: Subject) -> None:
    open_and_run(page, lab, write(root, subject))
    page.evaluate("jupyterapp.commands.execute('application:toggle-left-area')")
    picture = page.locator(subject.picture).first
    picture.wait_for()
    picture.scroll_into_view_if_needed()
    page.wait_for_timeout(2000)
    page.evaluate("([kind, box]) => { watch(kind, box, document.body); }",
                  [subject.kind, picture.element_handle()])
    late, figures = drag(page, picture)
    subject.latencies += late
    subject.drags.append(figures)
    shut_down_kernels(page)


def row(subject: Subject) -> list:
    if not subject.drags:
        return [subject.name, NOT_INSTALLED, *[""] * 5]
    p50, p95 = np.percentile(subject.latencies, [50, 95])
    moves, pictures, rate = (float(np.median([figures[key] for figures in subject.drags]))
                             for key in ("moves", "pictures", "rate"))
    return [subject.name, moves, pictures, rate, p50, p95, max(subject.latencies)]


def main() -> None:
    header("Pointer to picture, a target dragged", "jupyterlab", "ipywidgets", "ipympl",
           "playwright")
    rows = [row(subject) for subject in measured(subjects(), measure, WATCH + POINTER)]
    table(["", "moves", "pictures", "pictures/s", "p50 ms", "p95 ms", "max ms"], rows)
    worst = max(line[5] for line in rows[:3])
    goal(f"p95 from pointer to painted change at most {GOAL_MS} ms: {worst:.1f} ms",
         worst <= GOAL_MS)


if __name__ == "__main__":
    main()
