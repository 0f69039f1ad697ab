"""The course in JupyterLite: from a link to the first live arm, cold; the size of the site."""
from __future__ import annotations

import argparse
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from measure import goal, header, progress, table

sys.path.insert(0, str(Path(__file__).parent.parent / "tests" / "browser"))

from lab import open_browser
from lite_site import SECONDS, build, pyodide, served, tools
from playwright.sync_api import Browser

CACHE = Path(__file__).parent.parent / ".benchmarks"
LESSON = "07_alpha_ii.ipynb"
ROUNDS = 5
FIRST_ARM_S, SIZE_MB = 15, 40
STEPS = ("the notebook is open", "Python has started", "the first arm", "the last cell")


def main() -> None:
    """Build the site, open a lesson in fresh browsers, run all cells; print times and size."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=ROUNDS)
    rounds = parser.parse_args().rounds
    header(__doc__)
    CACHE.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        out, own = Path(name, "course"), pyodide(CACHE)
        build(tools(Path(name, "tools")), out, "--pyodide", own)
        size = sum(path.stat().st_size for path in out.rglob("*") if path.is_file()
                   and out / "static" / "pyodide" not in path.parents) / 1e6
        with served(out) as address:
            runs = []
            for turn in range(rounds):
                progress(f"round {turn + 1} of {rounds}")
                runs.append(_cold(address))
            progress()
    table(["s after the link was opened", "median", "best"],
          [[step, f"{median(times):.1f}", f"{min(times):.1f}"]
           for step, times in zip(STEPS, zip(*runs))])
    print(f"\nsize without Pyodide: {size:.1f} MB")
    goal(f"first arm within {FIRST_ARM_S} s (best)", min(run[2] for run in runs) <= FIRST_ARM_S)
    goal(f"the site under {SIZE_MB} MB, Pyodide aside", size < SIZE_MB)


def _cold(address: str) -> tuple[float, ...]:
    """One visit with nothing in the browser's store, all cells run as soon as Python is there."""
    with open_browser() as browser:
        return _visit(browser, address)


def _visit(browser: Browser, address: str) -> tuple[float, ...]:
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.set_default_timeout(1000 * SECONDS)
    begun, laps = time.perf_counter(), []

    def lap() -> None:
        laps.append(time.perf_counter() - begun)

    page.goto(f"{address}/lab/index.html?path={LESSON}")
    page.locator(".jp-NotebookPanel .jp-Cell").first.wait_for()
    lap()
    page.wait_for_function("jupyterapp.shell.currentWidget?.sessionContext?.session?.kernel"
                           "?.status === 'idle'")
    lap()
    page.evaluate("""() => {
        window.allRan = false;
        jupyterapp.commands.execute('notebook:run-all-cells').then(() => window.allRan = true);
    }""")
    page.locator(".kl-view .kl-picture svg").first.wait_for(state="attached")
    lap()
    page.wait_for_function("window.allRan")
    lap()
    return tuple(laps)


if __name__ == "__main__":
    main()
