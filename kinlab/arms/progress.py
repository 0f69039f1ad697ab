"""How far long work has come: a bar in a notebook or in a terminal, if it takes long enough."""
from __future__ import annotations

import builtins
import math
import sys
import time
from importlib import import_module
from typing import Any

PATIENCE = 1.0  # seconds before a bar appears


class Progress:
    """Told how much is done, shows it once the work has taken a while.

    As a context it tidies up at the end of the work, and where the work was stopped.

    Parameters
    ----------
    title : str
        What is being done.

    Examples
    --------
    >>> with Progress("workspace") as report:
    ...     report(50, 100)
    """

    def __init__(self, title: str) -> None:
        self.title, self.begun, self.percent = title, time.perf_counter(), 0
        self.bar: Any = None

    def __call__(self, done: int, total: int) -> None:
        percent = math.floor(100 * done / total)
        if percent == self.percent:
            return
        self.percent = percent
        if done < total and self.bar is None and time.perf_counter() - self.begun > PATIENCE:
            self.bar = _bar(self.title)
        if self.bar is not None:
            self.bar.show(percent)

    def __enter__(self) -> Progress:
        return self

    def __exit__(self, *_: Any) -> None:
        if self.bar is not None:
            self.bar.close()


class TerminalBar:
    """A line of signs, written over and over; nothing where nobody looks at a terminal."""

    def __init__(self, title: str) -> None:
        self.title = title
        self.stream = sys.stderr if sys.stderr is not None and sys.stderr.isatty() else None

    def show(self, percent: int) -> None:
        self._write(f"\r{self.title} |{'#' * (percent // 4):25}| {percent} %")

    def close(self) -> None:
        self._write("\r\x1b[K")

    def _write(self, text: str) -> None:
        if self.stream is not None:
            print(text, end="", file=self.stream, flush=True)


def _bar(title: str) -> Any:
    """The bar for where Python runs.

    That of a notebook needs ipywidgets, so it is loaded here, when there is a notebook to show it:
    the mathematics that calls this does without.
    """
    shell = getattr(builtins, "get_ipython", lambda: None)()
    if getattr(shell, "kernel", None) is None:
        return TerminalBar(title)
    return import_module("kinlab.views.notebook_bar").NotebookBar(title)
