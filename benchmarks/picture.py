"""The moving picture: script per step, frames lost in a drag, and nodes, in a real Chromium.

On saved pages, which need no kernel: a six-joint arm with everything on, Alpha II, an arm of
thirty joints, and all views of the lessons side by side. The peer is the same page at rest.
"""
from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from measure import goal, header, progress, table

ROOT = Path(__file__).parent.parent
sys.path[:0] = [str(ROOT / "tests" / "browser"), str(ROOT / "tests")]

from lab import open_browser  # noqa: E402
from lesson_views import VIEWS  # noqa: E402
from playwright.sync_api import Browser, CDPSession, Page  # noqa: E402

import kinlab as kl  # noqa: E402
from kinlab.browser import page as saved  # noqa: E402

ROUNDS, STEPS = 5, 300
LOST_MS = 20            # ms: a longer gap between two frames has lost one
GOAL_MS = 4
EVERYTHING = ("frames", "labels", "axes", "names", "floor", "trace", "ghost")
# Adds up the time of all that a page does in its animation frames.
WATCH = """(() => {
    const ask = window.requestAnimationFrame.bind(window);
    window.script = 0;
    window.timed = work => {
        const start = performance.now();
        work();
        window.script += performance.now() - start;
    };
    window.requestAnimationFrame = callback => ask(now => timed(() => callback(now)));
    window.frame = ask;
})()"""
# Goes so many frames on, and at each moves the slider of a view by one step, or does nothing.
GO = """([view, steps, moving]) => new Promise(done => {
    const box = document.querySelectorAll('.kl-view')[view], gaps = [], scripts = [];
    const ranges = box.querySelectorAll("input[type='range']"), range = ranges[1] ?? ranges[0];
    const low = Number(range.min), high = Number(range.max), nodes = box.querySelectorAll(
        '.kl-picture svg *').length;
    let count = 0, last = 0;
    const move = () => {
        range.value = low + (high - low) * (0.5 - 0.5 * Math.cos(2 * Math.PI * count / 150));
        range.dispatchEvent(new Event('input', {bubbles: true}));
    };
    const step = now => {
        if (count > 1) { gaps.push(now - last); scripts.push(window.script); }
        last = now;
        window.script = 0;
        if (count++ > steps) return done({gaps, scripts, nodes});
        if (moving) timed(move);
        frame(step);
    };
    frame(step);
})"""


@dataclass
class Subject:
    """A page, which of its views is moved, and what was measured in each round."""

    name: str
    make: Callable[[], list]
    view: int = 0
    nodes: int = 0
    rest: list[dict] = field(default_factory=list)
    drag: list[dict] = field(default_factory=list)

    @property
    def quietest(self) -> int:
        """The round in which the page at rest lost least, and of those the fastest."""
        return min(range(len(self.rest)), key=lambda k: (
            lost(self.rest[k]), np.median(self.drag[k]["scripts"])))


def subjects() -> list[Subject]:
    """The pages; each is made when it is wanted."""
    six, alpha = kl.robots.practical_six_link, kl.robots.alpha_ii
    return [
        Subject("six joints, everything on", lambda: [kl.ArmView(six(), show=EVERYTHING)]),
        Subject("Alpha II", lambda: [kl.ArmView(alpha())]),
        Subject("30 joints", lambda: [kl.ArmView(long_arm(30))]),
        Subject(f"Alpha II among {len(VIEWS)} views",
                lambda: [make() for make in VIEWS.values()], list(VIEWS).index("alpha_ii")),
    ]


def long_arm(n: int) -> kl.Arm:
    """An arm of so many joints that turn, their axes in all directions."""
    links = [kl.revolute(a=0.3, alpha=np.pi / 2 * (k % 3 - 1), d=0.1) for k in range(n)]
    return kl.Arm(links, name=f"{n} joints")


def open_page(browser: Browser, folder: Path, name: str, views: list) -> Page:
    """The views on one saved page, drawn and at rest."""
    path = folder / f"{name.replace(' ', '_')}.html"
    if not path.exists():
        saved.save(path, name, "".join(view.html() for view in views))
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.add_init_script(WATCH)
    page.goto(path.as_uri())
    page.locator(".kl-picture svg").first.wait_for()
    page.wait_for_timeout(1500)
    return page


def measure(page: Page, subject: Subject) -> None:
    """One round: the page at rest, then a drag."""
    page.locator(".kl-picture").nth(subject.view).scroll_into_view_if_needed()
    page.evaluate(GO, [subject.view, 60, True])  # until the script is compiled
    subject.rest.append(page.evaluate(GO, [subject.view, STEPS, False]))
    with processor(page) as used:
        drag = page.evaluate(GO, [subject.view, STEPS, True])
    subject.drag.append(drag | {name: 1e3 * seconds / STEPS for name, seconds in used.items()})
    subject.nodes = drag["nodes"]


@contextmanager
def processor(page: Page) -> Iterator[dict[str, float]]:
    """Seconds that the page's thread had the processor: for scripts, and for everything."""
    session, used = page.context.new_cdp_session(page), {}
    session.send("Performance.enable", {"timeDomain": "threadTicks"})
    before = counters(session)
    yield used
    after = counters(session)
    used.update({"cpu": after["ScriptDuration"] - before["ScriptDuration"],
                 "all": after["TaskDuration"] - before["TaskDuration"]})
    session.detach()


def counters(session: CDPSession) -> dict[str, float]:
    found = session.send("Performance.getMetrics")["metrics"]
    return {one["name"]: one["value"] for one in found}


def lost(found: dict) -> int:
    """Frames that were lost: those of 60 a second that would have stood in the gaps."""
    return sum(max(1, round(gap * 60 / 1000) - 1) for gap in found["gaps"] if gap > LOST_MS)


def rate(found: dict) -> float:
    return 1000 / float(np.mean(found["gaps"]))


def row(subject: Subject) -> list:
    k = subject.quietest
    rest, drag = subject.rest[k], subject.drag[k]
    median, p95 = np.percentile(drag["scripts"], [50, 95])
    cpu, all_ = (min(one[name] for one in subject.drag) for name in ("cpu", "all"))
    return [subject.name, subject.nodes, median, p95, cpu, all_, lost(drag), rate(drag),
            lost(rest), rate(rest)]


def every_view(browser: Browser, folder: Path, name: str) -> list[tuple[str, float, int]]:
    """Median script per step of each view on the page of all views, and its nodes."""
    page, found = open_page(browser, folder, name, []), []
    for k, view in enumerate(VIEWS):
        progress(f"each of the {len(VIEWS)} views: {view}")
        page.locator(".kl-picture").nth(k).scroll_into_view_if_needed()
        drag = page.evaluate(GO, [k, 60, True])
        found.append((view, float(np.median(drag["scripts"])), drag["nodes"]))
    page.close()
    progress()
    return sorted(found, key=lambda one: -one[1])


def measured(rounds: int) -> tuple[list[Subject], list[tuple[str, float, int]]]:
    """All pages in turn, so many times, then every view of the lessons."""
    found = subjects()
    with tempfile.TemporaryDirectory() as folder, open_browser() as browser:
        views = {subject.name: subject.make() for subject in found}
        for turn in range(1, rounds + 1):
            for subject in found:
                progress(f"round {turn} of {rounds}: {subject.name}")
                page = open_page(browser, Path(folder), subject.name, views[subject.name])
                measure(page, subject)
                page.close()
        return found, every_view(browser, Path(folder), found[-1].name)


def show_goals(six: Subject) -> None:
    _, _, median, _, _, _, gone, _, idle, _ = row(six)
    goal(f"six joints: median script per step at most {GOAL_MS} ms: {median:.1f} ms",
         median <= GOAL_MS)
    goal(f"six joints: no frame lost in {STEPS} steps: {gone} lost, {idle} at rest", gone == 0)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=ROUNDS)
    rounds = parser.parse_args().rounds
    header("The moving picture", "playwright")
    found, views = measured(rounds)
    table(["quietest round", "SVG nodes", "script/step: median ms", "p95 ms", "cpu ms",
           "all cpu ms", "drag: frames lost", "frames/s", "at rest: frames lost", "frames/s"],
          [row(subject) for subject in found])
    table([f"slowest of {len(views)} views", "median ms", "SVG nodes"],
          [list(one) for one in views[:5]])
    show_goals(found[0])


if __name__ == "__main__":
    main()
