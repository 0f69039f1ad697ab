"""What the benchmarks share: interleaved timing, peers that may be missing, tables, goals."""
from __future__ import annotations

import importlib
import os
import platform
import statistics
import sys
import time
from collections.abc import Callable, Sequence
from importlib import metadata
from types import ModuleType

SHORTEST = 0.02  # seconds; a task that is faster is repeated, so that the clock can see it
NOT_INSTALLED = "not installed"


def peer(name: str) -> ModuleType | None:
    """The module of a peer, or None where it is not installed."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def interleaved(tasks: dict[str, Callable], rounds: int) -> dict[str, list[float]]:
    """Seconds per call of each task, one figure per round.

    Every round runs every task once, so that all of them meet the same moods of the machine.
    """
    repeats = {name: _repeats(task) for name, task in tasks.items()}
    times = {name: [] for name in tasks}
    for turn in range(1, rounds + 1):
        for name, task in tasks.items():
            progress(f"round {turn} of {rounds}: {name}")
            times[name].append(_seconds(task, repeats[name]))
    progress()
    return times


def ratio(slower: Sequence[float], faster: Sequence[float]) -> float:
    """Median over the rounds of the ratio within one round."""
    return statistics.median(a / b for a, b in zip(slower, faster))


def progress(text: str = "") -> None:
    """Show what is being measured, on one line of the terminal that is written over."""
    if sys.stderr.isatty():
        print(f"\r\x1b[K{text}", end="", file=sys.stderr, flush=True)


def header(title: str, *packages: str) -> None:
    """The title, what it was measured with, and how busy the machine is with other work."""
    found = ", ".join(f"{name} {_version(name)}" for name in ("kinlab", "numpy", *packages))
    print(f"{title}\nPython {platform.python_version()}, {found}\n{_load()}\n")


def table(head: Sequence[str], rows: Sequence[Sequence]) -> None:
    """Print rows in columns, numbers flush right."""
    cells = [list(head), *([_cell(value) for value in row] for row in rows)]
    columns = list(zip(*cells))
    widths = [max(map(len, column)) for column in columns]
    numeric = [any(isinstance(row[i], (int, float)) for row in rows) for i in range(len(columns))]
    cells.insert(1, ["-" * width for width in widths])
    for row in cells:
        print("  ".join(cell.rjust(width) if right else cell.ljust(width)
                        for cell, width, right in zip(row, widths, numeric)).rstrip())
    print()


def goal(text: str, met: bool | None) -> None:
    """Print whether a goal was met in this run; None where it could not be measured."""
    print(f"{ {True: 'met       ', False: 'MISSED    ', None: 'unmeasured'}[met] }  {text}")


def _seconds(task: Callable, repeats: int) -> float:
    start = time.perf_counter()
    for _ in range(repeats):
        task()
    return (time.perf_counter() - start) / repeats


def _repeats(task: Callable) -> int:
    task()
    return max(1, round(SHORTEST / max(_seconds(task, 1), 1e-7)))


def _version(package: str) -> str:
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return NOT_INSTALLED


def _load() -> str:
    """The processes that wanted to run in the last minute: above the cores, milliseconds lie."""
    load = f"load {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else "load unknown"
    return f"{load} on {os.cpu_count()} cores"


def _cell(value: object) -> str:
    if not isinstance(value, (int, float)):
        return str(value)
    return f"{value:,.0f}" if abs(value) >= 100 else f"{value:.3g}"
