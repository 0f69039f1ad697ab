"""A limit of time for what students hand over: whatever it does, its check comes back.

An answer may loop for ever, sleep, fill the memory, or be inside C code that listens to nobody. So
it is judged where it can be left behind:

* on Linux in a copy of this process. It is killed when the time is over, whatever it is doing, and
  all that it changed is gone with it: the student's objects stay as they were, and the same
  answer has the same verdict for ever;
* on Windows, on macOS (where libraries forbid such copies), and where no copy can be made, in a
  thread. It is told to stop and not waited for. Only C code that lets no other thread run, such as
  ``sum(itertools.repeat(1))``, keeps everybody waiting;
* in a browser's Python there is neither: an endless loop takes a restart of the kernel.

What is printed meanwhile is kept, up to a page of it, and printed when the check is over.
"""
from __future__ import annotations

import builtins
import ctypes
import io
import os
import signal
import sys
import tempfile
import threading
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout, suppress
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from typing import Any, BinaryIO, NoReturn, TypeVar

MOST_PRINTED, MOST_LINES = 2000, 12  # characters and lines
MOST_MEMORY = 2 * 1024**3  # bytes that an answer may take beside what the process has
_STOPPING = 30.0  # seconds for which a thread that does not stop is told so again

Result = TypeVar("Result")


class TimeIsOver(Exception):
    """The work did not come back in time."""


class Ended(Exception):
    """The work ended the process it ran in."""


class _Heard(BaseException):
    """A word to stop has arrived, and meant nothing."""


def within(seconds: float, work: Callable[[], Result]) -> Result:
    """The result of some work, if it comes within a time.

    Parameters
    ----------
    seconds : float
    work : callable
        Takes nothing. Its result can be pickled; no error should leave it.

    Raises
    ------
    TimeIsOver
        If it does not come back in time.
    Ended
        If it ends its process.

    Examples
    --------
    >>> within(5, lambda: 6 * 7)
    42
    """
    if sys.platform == "linux":
        with suppress(OSError):  # no more processes, no more files
            return _in_a_copy(seconds, work)
    if sys.platform == "emscripten":
        return work()
    return _in_a_thread(seconds, work)


# ---- In a copy of this process -------------------------------------------------------------------


def _in_a_copy(seconds: float, work: Callable[[], Result]) -> Result:
    with tempfile.TemporaryFile() as printed:
        here, there = Pipe(duplex=False)
        copy = _fork()
        if copy == 0:
            _be_the_copy(seconds, there, printed, work)
        there.close()
        try:
            if not here.poll(seconds):
                raise TimeIsOver
            return here.recv()
        except EOFError:
            raise Ended from None
        finally:
            with suppress(ProcessLookupError, ChildProcessError):
                os.kill(copy, signal.SIGKILL)
                os.waitpid(copy, 0)
            here.close()
            printed.seek(0)
            _tell(printed.read(4 * MOST_PRINTED).decode(errors="replace"))


def _fork() -> int:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # of the threads that the copy lacks
        return os.fork()


def _be_the_copy(seconds: float, there: Connection, printed: BinaryIO,
                 work: Callable[[], Any]) -> NoReturn:
    """Do the work, send its result and end, whatever happens."""
    try:
        os.setpgid(0, 0)  # the Stop button is for the process that waits
        _end_after(seconds + 1)
        _hear_what_was_said()
        _limit_memory()
        for stream in (1, 2):
            os.dup2(printed.fileno(), stream)
        builtins.input = _no_input
        sys.stdout = sys.stderr = _Page(lambda text: os.write(1, text.encode(errors="replace")))
        there.send(work())
    finally:
        os._exit(0)


def _end_after(seconds: float) -> None:
    """End this process, should the one that waits be killed before it."""
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_REAL, seconds)


def _hear_what_was_said() -> None:
    """Take a word to stop off the air that was on its way to a thread which the copy lacks.

    While one is pending, CPython 3.11 enters no function that is watched by a profiler.
    """
    with suppress(_Heard):
        _say(threading.get_ident(), _Heard)
        for _ in range(100):  # it is heard at the next turn
            pass


def _limit_memory() -> None:
    import resource  # POSIX only

    with suppress(OSError, ValueError):
        with open("/proc/self/statm", encoding="ascii") as sizes:
            taken = int(sizes.read().split()[0]) * resource.getpagesize()
        _, most = resource.getrlimit(resource.RLIMIT_AS)
        resource.setrlimit(resource.RLIMIT_AS, (taken + MOST_MEMORY, most))


def _no_input(*_: Any) -> NoReturn:
    raise EOFError("nobody answers input() while a check runs")


# ---- In a thread ---------------------------------------------------------------------------------


def _in_a_thread(seconds: float, work: Callable[[], Result]) -> Result:
    results: list[Result] = []
    over = threading.Event()

    def run() -> None:
        with suppress(SystemExit):  # it was told to stop
            try:
                results.append(work())
            finally:
                over.set()

    thread = threading.Thread(target=run, daemon=True)
    in_time = False
    with _kept():
        thread.start()
        try:
            in_time = _wait(over, seconds)
        finally:
            if not in_time:
                threading.Thread(target=_stop, args=(thread,), daemon=True).start()
    if not in_time:
        raise TimeIsOver
    if not results:
        raise Ended
    return results[0]


def _wait(over: threading.Event, seconds: float) -> bool:
    """Wait in short steps: on Windows the Stop button is not heard within one."""
    while seconds > 0 and not over.wait(min(0.1, seconds)):
        seconds -= 0.1
    return over.is_set()


def _stop(thread: threading.Thread) -> None:
    """Raise SystemExit in a thread, again and again: it may be caught there by a bare except."""
    pause, left = 0.01, _STOPPING
    while thread.is_alive() and left > 0:
        _say(thread.ident or 0, SystemExit)
        thread.join(pause)
        pause, left = min(2 * pause, 1.0), left - pause


def _say(thread: int, word: type[BaseException]) -> None:
    """Raise an error in a thread, at its next step in Python."""
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), ctypes.py_object(word))


# ---- What is printed -----------------------------------------------------------------------------


class _Page(io.TextIOBase):
    """Takes all that is printed and keeps the first page of it."""

    def __init__(self, keep: Callable[[str], Any]) -> None:
        super().__init__()
        self._keep, self._left = keep, MOST_PRINTED

    def writable(self) -> bool:
        return True

    def write(self, text: str) -> int:
        if self._left > 0:
            self._keep(text[:self._left])
        self._left -= len(text)
        return len(text)


@contextmanager
def _kept() -> Iterator[None]:
    """Keep what is printed, and print it at the end."""
    lines: list[str] = []
    page = _Page(lines.append)
    try:
        with redirect_stdout(page), redirect_stderr(page):
            yield
    finally:
        _tell("".join(lines))


def _tell(text: str) -> None:
    lines = text[:MOST_PRINTED].splitlines(keepends=True)
    if len(text) >= MOST_PRINTED or len(lines) > MOST_LINES:
        text = f"{''.join(lines[:MOST_LINES]).rstrip()}\n... and more, which is left out.\n"
    print(text, end="")
