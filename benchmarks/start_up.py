"""Start-up: importing kinlab, Run All to the first live arm, memory of an open lesson's kernel."""
from __future__ import annotations

import argparse
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from statistics import median

import nbformat
import psutil
from jupyter_client.blocking import BlockingKernelClient
from jupyter_client.manager import start_new_kernel
from measure import goal, header, progress, table

LESSON = Path(__file__).parent.parent / "notebooks" / "07_alpha_ii.ipynb"
ROUNDS = 9
KERNEL_ROUNDS = 3
GOAL_MS = 30
FIRST_ARM_S, LESSON_S = 1.0, 3.0
LIVE = "application/vnd.jupyter.widget-view+json"

IMPORTS = {
    "numpy": "import numpy",
    "kinlab": "import kinlab",
    "kinlab, used: forward kinematics": "import kinlab; kinlab.forward_kinematics",
    "kinlab, used: closed form": "import kinlab; kinlab.closed_form",
    "kinlab, used: live arm": "import kinlab; kinlab.ArmView",
}
KERNELS = {
    "bare": "",
    "numpy": "import numpy",
    "what kinlab stands on": "import numpy, sympy, matplotlib.figure, ipywidgets, anywidget",
}


def import_seconds(statement: str) -> float:
    """Time of an import in a fresh process, the start of Python itself left out."""
    code = ("import time; start = time.perf_counter()\n"
            f"{statement}\nprint(time.perf_counter() - start)")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return float(done.stdout)


def import_times() -> dict[str, list[float]]:
    """Milliseconds of each import, one figure per round."""
    times = {name: [] for name in IMPORTS}
    for turn in range(ROUNDS + 1):  # round 0 brings the files into the disk cache
        for name, statement in IMPORTS.items():
            progress(f"imports, round {turn} of {ROUNDS}: {name}")
            times[name].append(1e3 * import_seconds(statement))
    progress()
    return {name: found[1:] for name, found in times.items()}


@contextmanager
def kernel(folder: Path) -> Iterator[tuple[BlockingKernelClient, psutil.Process, float]]:
    """A real kernel, its process, and the seconds it took to start."""
    start = time.perf_counter()
    manager, client = start_new_kernel(cwd=str(folder), stderr=subprocess.DEVNULL)
    try:
        yield client, psutil.Process(manager.provisioner.pid), time.perf_counter() - start
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)


def run(client: BlockingKernelClient, code: str) -> bool:
    """Run one cell; True if it showed a live view. An error in it ends the benchmark."""
    shown = []
    reply = client.execute_interactive(
        code, timeout=120, output_hook=lambda message: shown.append(message["content"]))
    content = reply["content"]
    if content["status"] != "ok":
        raise SystemExit(f"a cell failed: {content['ename']}: {content['evalue']}")
    return any(LIVE in content.get("data", {}) for content in shown)


def lesson(path: Path) -> dict[str, float]:
    """Run All in a fresh kernel: seconds to the kernel, the first live arm and the end; memory."""
    with kernel(path.parent) as (client, process, started):
        start, live = time.perf_counter(), None
        for cell in nbformat.read(path, as_version=4).cells:
            if cell.cell_type == "code" and run(client, cell.source):
                live = live or time.perf_counter() - start
        end = time.perf_counter() - start
        return dict(started=started, live=live or float("nan"), end=end) | memory(process)


def imported(folder: Path, code: str) -> dict[str, float]:
    """Memory of a fresh kernel that has run one statement."""
    with kernel(folder) as (client, process, _):
        run(client, code)
        return memory(process)


def memory(process: psutil.Process) -> dict[str, float]:
    """Megabytes in use; PSS shares out what processes have in common, and only Linux counts it."""
    info = process.memory_full_info()
    return {"rss": info.rss / 1e6, "pss": getattr(info, "pss", float("nan")) / 1e6}


def kernel_figures(path: Path) -> dict[str, list[dict[str, float]]]:
    figures = {name: [] for name in (*KERNELS, "lesson")}
    for turn in range(1, KERNEL_ROUNDS + 1):
        for name, found in figures.items():
            progress(f"kernels, round {turn} of {KERNEL_ROUNDS}: {name}")
            found.append(lesson(path) if name == "lesson" else imported(path.parent, KERNELS[name]))
    progress()
    return figures


def show_imports(times: dict[str, list[float]]) -> None:
    added = {name: min(found) - min(times["numpy"]) for name, found in times.items()}
    table(["import in a fresh process", "median ms", "best ms", "best, more than numpy"],
          [[name, median(found), min(found), added[name]] for name, found in times.items()])
    for name in ("kinlab", "kinlab, used: forward kinematics"):
        goal(f"import {name}: at most {GOAL_MS} ms more than numpy: {added[name]:+.1f} ms",
             added[name] <= GOAL_MS)
    print()


def show_lesson(path: Path, figures: dict[str, list[dict[str, float]]]) -> None:
    middle = {name: {key: median(figure[key] for figure in found) for key in found[0]}
              for name, found in figures.items()}
    seconds = middle["lesson"]
    table([f"Run All of {path.name}", "median s"],
          [["kernel started", seconds["started"]], ["Run All to first live arm", seconds["live"]],
           ["Run All to last cell", seconds["end"]]])
    goal(f"first live arm within {FIRST_ARM_S} s: {seconds['live']:.2f} s",
         seconds["live"] <= FIRST_ARM_S)
    goal(f"the whole lesson within {LESSON_S} s: {seconds['end']:.2f} s",
         seconds["end"] <= LESSON_S)
    bare, numpy = middle["bare"], middle["numpy"]
    table(["kernel", "RSS MB", "PSS MB", "PSS times bare", "PSS more than numpy, MB"],
          [[name, found["rss"], found["pss"], found["pss"] / bare["pss"],
            found["pss"] - numpy["pss"]] for name, found in middle.items()])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("notebook", nargs="?", type=Path, default=LESSON)
    path = parser.parse_args().notebook
    header("Start-up", "matplotlib", "ipywidgets", "jupyterlab")
    show_imports(import_times())
    show_lesson(path, kernel_figures(path))


if __name__ == "__main__":
    main()
