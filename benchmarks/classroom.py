"""A class at once: a real JupyterHub, and students who log in, run Alpha II and drag sliders.

    python benchmarks/classroom.py --students 30

The hub runs from deploy/jupyterhub_config.py, on this machine only; its proxy is
configurable-http-proxy from node_modules/.bin or the path. See benchmarks/README.md.
"""
from __future__ import annotations

import argparse
import os
import random
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median

import nbformat
import numpy as np
import psutil
import requests
from measure import goal, header, progress, table
from peers import COMMON, INTERACT
from student import BROWSER_SECONDS, KINLAB_SECONDS, Drag, Student

ROOT = Path(__file__).parent.parent
LESSON = ROOT / "notebooks" / "07_alpha_ii.ipynb"
CONFIG = ROOT / "deploy" / "jupyterhub_config.py"
ALONE, DRAG_SECONDS, ROUNDS = 3, 2.0, 5  # students who drag alone; then all drag, with pauses
REST = 25  # seconds until the drawing processes have ended: kinlab/drawing/worker.py, IDLE
GOAL_MB, GOAL_RATIO = 20, 10
VIEWS = re.compile(r"\b(ArmView|predict|\w*_view)\b")


@dataclass
class Class:
    """A class: what its students run, and what was measured."""

    name: str
    cells: list[str]
    pause: float  # seconds between two messages of a dragged slider
    first_view: str  # part of the first cell that shows an arm
    dragged: str  # part of the cell that makes the sliders which are dragged
    failed: list[str] = field(default_factory=list)
    views: list[float] = field(default_factory=list)  # login to first arm, seconds
    work: list[float] = field(default_factory=list)   # processor seconds of server and kernel
    ends: list[float] = field(default_factory=list)
    memory: dict[str, float] = field(default_factory=dict)
    alone: list[dict[str, float]] = field(default_factory=list)
    drags: list[Drag] = field(default_factory=list)


def classes() -> list[Class]:
    """The lesson with its live views; and the same cells with `interact` for its views."""
    lesson = [cell.source for cell in nbformat.read(LESSON, as_version=4).cells
              if cell.cell_type == "code"]
    others = [code for code in lesson if not VIEWS.search(code)]
    return [Class("kinlab", lesson, KINLAB_SECONDS, "predict(", "ArmView("),
            Class("interact, inline figure", [COMMON, INTERACT, *others], BROWSER_SECONDS,
                  "interact(", "FloatSlider(")]


@contextmanager
def hub(homes: Path) -> Iterator[tuple[str, psutil.Process]]:
    """The hub of deploy/, with test accounts on loopback; its address and its process."""
    port, inside = _free_ports(2)
    options = {"JupyterHub.authenticator_class": "dummy", "JupyterHub.spawner_class": "simple",
               "Authenticator.allow_all": "True", "JupyterHub.bind_url": f"http://127.0.0.1:{port}",
               "JupyterHub.hub_port": inside, "JupyterHub.db_url": "sqlite://",
               "ConfigurableHTTPProxy.api_url": f"http://127.0.0.1:{_free_ports(1)[0]}",
               "SimpleLocalProcessSpawner.home_dir_template": f"{homes}/{{username}}",
               "JupyterHub.cookie_secret_file": f"{homes}/cookie_secret",
               "ConfigurableHTTPProxy.pid_file": f"{homes}/proxy.pid"}
    if os.geteuid() == 0:  # as in a container; the servers of a real hub are their users' own
        options["Spawner.cmd"] = "['jupyterhub-singleuser', '--allow-root']"
    with (homes / "hub.log").open("wb") as log:
        process = subprocess.Popen(
            [sys.executable, "-m", "jupyterhub", "-f", str(CONFIG),
             *(f"--{name}={value}" for name, value in options.items())],
            cwd=homes, stdout=log, stderr=log, env=_environment())
    try:
        address = f"http://127.0.0.1:{port}"
        _wait(process, address, homes / "hub.log")
        yield address, psutil.Process(process.pid)
    finally:
        family = psutil.Process(process.pid).children(recursive=True)
        process.terminate()
        _, alive = psutil.wait_procs(family, timeout=60)
        for child in alive:
            child.kill()
        process.wait()


def _environment() -> dict[str, str]:
    places = f"{ROOT / 'node_modules' / '.bin'}:{Path(sys.executable).parent}:{os.environ['PATH']}"
    if not shutil.which("configurable-http-proxy", path=places):
        raise SystemExit("configurable-http-proxy is missing; run: "
                         "npm install --no-save configurable-http-proxy")
    return os.environ | {"PATH": places}


def _free_ports(count: int) -> list[int]:
    probes = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [probe.getsockname()[1] for probe in probes]
    for probe in probes:
        probe.close()
    return ports


def _wait(process: subprocess.Popen, address: str, log: Path) -> None:
    for _ in range(300):
        try:
            if requests.get(f"{address}/hub/api", timeout=5).ok:
                return
        except requests.ConnectionError:
            pass
        if process.poll() is not None:
            break
        time.sleep(0.2)
    raise SystemExit(f"the hub did not start:\n{log.read_text()}")


def attend(student: Student, lesson: Class, homes: Path) -> None:
    """Log in and run the lesson; what fails is noted."""
    home = homes / student.name
    home.mkdir(exist_ok=True)
    shutil.copy(LESSON, home)
    began = time.perf_counter()
    student.log_in()
    student.open_kernel(LESSON.name)
    first = next(cell for cell in lesson.cells if lesson.first_view in cell)
    for number, cell in enumerate(lesson.cells):
        before = len(student.sliders)
        student.run(cell)
        if cell is first:
            lesson.views.append(time.perf_counter() - began)
            lesson.work.append(work(student))
        if lesson.dragged in cell:
            student.sliders = student.sliders[before:]
        progress(f"{lesson.name}: {student.name} has run {number + 1} of {len(lesson.cells)} cells")
    lesson.ends.append(time.perf_counter() - began)


def each(students: Sequence[Student], lesson: Class, act: Callable[[Student], None]) -> None:
    """Let all students act at once; those who fail are out."""
    def one(student: Student) -> None:
        try:
            act(student)
        except Exception as error:
            lesson.failed.append(f"{student.name}: {type(error).__name__}: {error}")

    with ThreadPoolExecutor(len(students)) as pool:
        list(pool.map(one, students))


def process_of(student: Student) -> psutil.Process:
    """The process of a student's kernel; the server is its parent."""
    return psutil.Process(int(student.run("import os; print(os.getpid())")))


def work(student: Student) -> float:
    """Processor time that a student's server, kernel and drawing process have taken."""
    kernel = process_of(student)
    family = [kernel.parent(), kernel, *kernel.children(recursive=True)]
    return sum(sum(process.cpu_times()[:2]) for process in family)


def used(processes: Sequence[psutil.Process]) -> tuple[float, float]:
    """Median megabytes of processes: USS, their own alone, and PSS, with their share of others'."""
    found = [process.memory_full_info() for process in processes]
    return median(f.uss for f in found) / 1e6, median(f.pss for f in found) / 1e6


def weigh(address: str, lesson: Class, students: Sequence[Student], homes: Path,
          top: psutil.Process) -> None:
    """Memory of the class at rest, beside that of a kernel that has imported numpy alone."""
    plain = Student(address, "plain")
    (homes / plain.name).mkdir()
    plain.log_in()
    plain.open_kernel("plain.ipynb")
    plain.run("import numpy")
    time.sleep(REST)
    kernels = [process_of(student) for student in students]
    plain_uss, _ = used([process_of(plain)])
    plain.run("import sympy")
    sympy_uss, _ = used([process_of(plain)])
    kernel_uss, kernel_pss = used(kernels)
    server_uss, server_pss = used([kernel.parent() for kernel in kernels])
    family = [top, *top.children(recursive=True)]
    lesson.memory = {
        "server": server_uss, "server PSS": server_pss, "kernel": kernel_uss,
        "kernel PSS": kernel_pss, "numpy": plain_uss, "above": kernel_uss - plain_uss,
        "ours": kernel_uss - sympy_uss,
        "all": sum(p.memory_full_info().pss for p in family) / 1e6}
    plain.close()


def drag_alone(lesson: Class, students: Sequence[Student]) -> None:
    """Processor time that one drag takes of the kernel, while nobody else drags."""
    for student in students[:ALONE]:
        process = process_of(student)
        before = process.cpu_times()
        drag = student.drag(1, DRAG_SECONDS, lesson.pause)
        after = process.cpu_times()
        lesson.alone.append({
            "cpu": sum(after[:2]) - sum(before[:2]), "messages": len(drag.done),
            "echo": median(drag.echoes), "done": median(drag.done)})


def drag_together(lesson: Class, students: Sequence[Student]) -> None:
    """All drag, each at moments of its own."""
    def act(student: Student) -> None:
        for turn in range(ROUNDS):
            time.sleep(random.uniform(0, 2 * DRAG_SECONDS))
            progress(f"{lesson.name}: {student.name}, drag {turn + 1} of {ROUNDS}")
            lesson.drags.append(student.drag(1, DRAG_SECONDS, lesson.pause))

    each(students, lesson, act)


def hold(lesson: Class, count: int) -> None:
    """One class, from the hub's start to its end."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        homes = Path(folder)
        with hub(homes) as (address, top):
            students = [Student(address, f"student{k:02}") for k in range(1, count + 1)]
            each(students, lesson, lambda student: attend(student, lesson, homes))
            here = [s for s in students if not any(f.startswith(s.name) for f in lesson.failed)]
            if here:
                weigh(address, lesson, here, homes, top)
                drag_alone(lesson, here)
                drag_together(lesson, here)
            for student in here:
                student.close()
    progress()


def row(lesson: Class, count: int) -> list:
    echoes = [1e3 * t for drag in lesson.drags for t in drag.echoes]
    done = [1e3 * t for drag in lesson.drags for t in drag.done]
    return [lesson.name, f"{count - len(lesson.failed)} of {count}",
            *np.percentile(lesson.views, [50, 95]), median(lesson.work),
            *np.percentile(lesson.ends, [50, 95]),
            1e3 * alone(lesson, "cpu"), alone(lesson, "messages"), 1e3 * alone(lesson, "done"),
            *np.percentile(echoes, [50, 95]), *np.percentile(done, [50, 95])]


def alone(lesson: Class, key: str) -> float:
    return float(median(figures[key] for figures in lesson.alone))


def show_goals(found: Sequence[Class], count: int) -> None:
    for lesson in found:
        for failure in lesson.failed:
            print(failure)
    ours = found[0]
    goal(f"{count} students, no failed launch: {len(ours.failed)} failed", not ours.failed)
    goal(f"a kernel with the lesson at most {GOAL_MB} MB above one with numpy and sympy: "
         f"{ours.memory['ours']:.0f} MB", ours.memory["ours"] <= GOAL_MB)
    if len(found) > 1:
        ours_s, theirs = (float(median(lesson.views)) for lesson in found[:2])
        goal(f"login to first arm no slower than interact: {ours_s:.0f} to {theirs:.0f} s",
             ours_s <= theirs)
        ratio = alone(found[1], "cpu") / alone(ours, "cpu")
        goal(f"at least {GOAL_RATIO} times less kernel CPU per drag than interact: "
             f"{ratio:.0f} times", ratio >= GOAL_RATIO)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--students", type=int, default=30)
    parser.add_argument("--only", choices=["kinlab", "interact"], help="one of the two classes")
    options = parser.parse_args()
    header(f"A class of {options.students}, Alpha II", "jupyterhub", "jupyterlab", "ipywidgets",
           "matplotlib")
    found = [lesson for lesson in classes() if lesson.name.startswith(options.only or "")]
    for lesson in found:
        hold(lesson, options.students)
    table(["class", "arrived", "login to first arm: p50 s", "p95 s", "processor s",
           "to last cell: p50 s", "p95 s", "alone: kernel ms per drag", "messages",
           "ms until done", "all drag: echo p50 ms", "p95 ms", "done p50 ms", "p95 ms"],
          [row(lesson, options.students) for lesson in found])
    table(["MB per student (median)", "server USS", "PSS", "kernel USS", "PSS",
           "kernel with numpy USS", "above it", "above numpy and sympy", "all processes PSS"],
          [[lesson.name, *(lesson.memory[key] for key in (
              "server", "server PSS", "kernel", "kernel PSS", "numpy", "above", "ours", "all"))]
           for lesson in found])
    show_goals(found, options.students)


if __name__ == "__main__":
    main()
