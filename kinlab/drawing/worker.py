"""Pictures of scenes, drawn by matplotlib in a process of its own.

matplotlib takes 30 MB, and each figure leaves a megabyte until Python next tidies up. A kernel
needs neither between two pictures, and a class of thirty has thirty kernels. So the drawing is
done beside it, by a process that ends once it has waited IDLE seconds for another picture.
"""
from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from threading import Lock, Timer
from typing import Any

from ..arms.motions import Numbers
from .scene import Scene

IDLE = 20.0  # seconds
# In a browser's Python there is no process but the kernel: matplotlib would take longer than all
# else before the first view is seen. So only pictures that are asked for are drawn there.
ASKED_ONLY = sys.platform == "emscripten"

Job = tuple[Scene, Numbers, str, Sequence[str], str]  # what `figure` takes, and words

_lock = Lock()
_hand: subprocess.Popen[bytes] | None = None


def begin() -> None:
    """Start the drawing process, which takes half a second, before the first picture is wanted."""
    with _lock, suppress(OSError):
        _running()


def png(scene: Scene, q: Numbers, preset: str, show: Sequence[str], words: str = "") -> bytes:
    """The scene at joint values `q` as a PNG picture; see `figure.png`."""
    return _ask((scene, q, preset, show, words))


def _draw(job: Job) -> Any:
    from . import figure

    scene, q, preset, show, words = job
    return figure.png(figure.figure(scene, q, preset, show), words)


def _ask(job: Job) -> Any:
    """What the drawing process answers; where none can run, the picture is drawn here."""
    with _lock:
        for _ in range(2):  # it may have ended just now, having waited long enough
            try:
                answer = _exchange(job)
            except (OSError, EOFError):
                continue
            if isinstance(answer, Exception):
                raise answer
            return answer
    return _draw(job)


def _exchange(job: Job) -> Any:
    hand = _running()
    assert hand.stdin and hand.stdout  # both are pipes
    try:
        pickle.dump(job, hand.stdin)
        hand.stdin.flush()
        return pickle.load(hand.stdout)
    except BaseException:  # an interrupt, too: half an answer must not be read as the next one
        hand.kill()
        hand.wait()
        raise


def _running() -> subprocess.Popen[bytes]:
    global _hand
    if _hand is None or _hand.poll() is not None:
        _hand = _start()
    return _hand


def _start() -> subprocess.Popen[bytes]:
    code = f"import sys; sys.path[:] = {sys.path!r}; from {__name__} import work; work({IDLE})"
    return subprocess.Popen([sys.executable, "-c", code], stdin=subprocess.PIPE,
                            stdout=subprocess.PIPE)


def work(idle: float) -> None:
    """Answer jobs from standard input until it closes or none comes for `idle` seconds."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # it is the kernel that is interrupted
    if hasattr(os, "nice"):
        os.nice(5)  # while a whole class starts, kernels come first: they show the first arm
    from . import figure

    figure.prepare()  # matplotlib and its letters are there when the first job comes
    answers, sys.stdout = sys.stdout.buffer, sys.stderr
    while True:
        waiting = Timer(idle, os._exit, [0])
        waiting.daemon = True
        waiting.start()
        try:
            job = pickle.load(sys.stdin.buffer)
        except EOFError:
            return
        waiting.cancel()
        pickle.dump(_answer(job), answers)
        answers.flush()


def _answer(job: Job) -> Any:
    try:
        return _draw(job)
    except Exception as error:
        return error
