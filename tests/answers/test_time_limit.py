"""Whatever is handed over, a check comes back, and Python is as it was before."""
import itertools
import os
import signal
import subprocess
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

import kinlab as kl
from kinlab.answers import time_limit
from kinlab.answers.time_limit import Ended, TimeIsOver, within

SOON = 0.3  # seconds that are over before an endless loop is


@pytest.fixture(params=["linux", "win32"])
def way(request, monkeypatch):
    """In a copy of the process, and in a thread."""
    monkeypatch.setattr(sys, "platform", request.param)
    return request.param


class Endless:
    """An object whose questions are never answered."""

    def __len__(self, *_):
        while True:
            pass

    __array__ = __iter__ = __eq__ = __repr__ = __float__ = __index__ = __bool__ = __len__
    __hash__ = None


class LongList(Endless, list):
    pass


def loop(*_):
    while True:
        pass


def stubborn(*_):
    while True:
        with suppress(BaseException):
            loop()


def talkative(*_):
    while True:
        print("still here")


def one_after_the_other(*_):
    while True:
        yield 0


LOOPS = {"loop": loop, "stubborn": stubborn,
         "generator": lambda *_: any(one_after_the_other())}


@pytest.mark.parametrize("work", LOOPS.values(), ids=LOOPS)
def test_what_does_not_come_back_is_left_behind(way, work):
    with pytest.raises(TimeIsOver):
        within(SOON, work)
    assert within(60, lambda: 6 * 7) == 42


@pytest.mark.parametrize("work", [
    lambda *_: sum(itertools.repeat(1)), lambda *_: 3**10**9, lambda *_: "a" * 10 in
    itertools.repeat("b"), lambda *_: np.linalg.svd(np.ones((9000, 9000))), lambda *_:
    time.sleep(999)], ids=["sum", "power", "search", "numpy", "sleep"])
def test_code_that_cannot_be_told_to_stop_is_left_behind_in_a_copy(work):
    with pytest.raises(TimeIsOver):
        within(SOON, work)


@pytest.mark.parametrize("name", ["rotation.1", "two_link.3", "n_link.2", "n_link.4"])
def test_a_function_without_end_is_asked_about_its_loop(way, name):
    verdict = kl.exercises.check(name, loop, seconds=SOON)
    assert repr(verdict) == ("✗ Not yet. Your function did not come back within 0.3 seconds: is "
                             "there an endless loop?")


ANSWERS = {"object": Endless(), "list": LongList([1]), "inside": [Endless(), Endless()],
           "rows": [[Endless()] * 3] * 3, "sets": [LongList([1])] * 2}


@pytest.mark.parametrize("name", ["start_here.1", "start_here.5", "translation.1", "translation.2",
                                  "rotation.2", "dh_recipe.7", "n_link.3", "alpha_ii.4"])
def test_an_answer_that_never_ends_is_left_behind(name):
    for answer in ANSWERS.values():
        verdict = kl.exercises.check(name, answer, seconds=SOON)
        assert verdict.word == "Not yet" and len(verdict.message) < 300


DEEP = []
for _ in range(100_000):
    DEEP = [DEEP]


@pytest.mark.parametrize("name", ["start_here.2", "translation.1", "two_link.2", "rotation.4",
                                  "dh_recipe.2", "dh_recipe.7", "intelledex.1"])
@pytest.mark.parametrize("answer", ["x" * 10**7, [0.0] * 10**6, np.zeros(10**6), 10**5000,
                                    [10**5000] * 3, DEEP, {1: DEEP}, range(10**9), b"x" * 10**7,
                                    np.broadcast_to(0.0, (10**9,))],
                         ids=["text", "list", "array", "huge", "huge list", "deep", "dict", "range",
                              "bytes", "view"])
def test_large_answers_are_refused_in_short_words(name, answer):
    verdict = kl.exercises.check(name, answer, seconds=60)
    assert verdict.word == "Not yet" and 0 < len(verdict.message) < 300


def test_a_memory_that_grows_and_grows_is_left_behind():
    greedy = kl.exercises.check("rotation.1", lambda t: np.ones(10**11))
    assert "MemoryError" in greedy.message


def test_a_function_that_ends_python_ends_a_copy_only():
    with pytest.raises(Ended):
        within(60, lambda: os._exit(0))
    assert "ended Python" in kl.exercises.check("rotation.1", lambda t: os._exit(0)).message


def test_what_is_printed_fits_on_a_page(way, capsys):
    with pytest.raises(TimeIsOver):
        within(SOON, talkative)
    said = capsys.readouterr().out
    assert said.startswith("still here\n") and said.endswith("and more, which is left out.\n")
    assert len(said.splitlines()) < 20 and len(said) < 3000


def test_what_a_student_prints_is_seen(way, capsys):
    def rotation(theta):
        print("theta is", theta)
        return np.eye(2)

    kl.exercises.check("rotation.1", rotation)
    assert capsys.readouterr().out.startswith("theta is 0.0\ntheta is 0.52")


def test_what_an_answer_changes_is_gone():
    kept = []
    for _ in range(3):
        kl.exercises.check("rotation.1", lambda theta: kept.append(theta))
    assert kept == [] and sys.getprofile() is None


def test_an_interrupt_becomes_a_verdict(way, monkeypatch):
    """As by the Stop button, while the check waits."""
    def pressed(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(time_limit, "_wait", pressed)
    monkeypatch.setattr("multiprocessing.connection.Connection.poll", pressed)
    assert repr(kl.exercises.check("rotation.1", loop)) == (
        "✗ Not yet. Interrupted. Run the check again when you are ready.")


def test_a_thread_that_was_left_behind_ends():
    before = set(threading.enumerate())
    with pytest.raises(TimeIsOver):
        time_limit._in_a_thread(SOON, loop)
    for thread in set(threading.enumerate()) - before:
        thread.join()


def test_a_thread_that_does_not_hear_yet_keeps_no_copy_waiting():
    deaf = []
    with pytest.raises(TimeIsOver):
        time_limit._in_a_thread(SOON, lambda: [deaf.append(threading.current_thread()),
                                               time.sleep(3)])
    while deaf[0].is_alive():
        verdict = kl.exercises.check("rotation.1", lambda theta: np.eye(2), seconds=60)
        assert "did not come back" not in verdict.message


WAITING = """
import os
from kinlab.answers.time_limit import within

def loop():
    os.write({pipe}, str(os.getpid()).encode())
    while True:
        pass

within(1, loop)
"""


def test_a_copy_ends_although_nobody_waits_for_it_any_more():
    here, there = os.pipe()
    kernel = subprocess.Popen([sys.executable, "-c", WAITING.format(pipe=there)],
                              pass_fds=[there])
    copy = int(os.read(here, 20))
    kernel.kill()  # as a restart does
    kernel.wait()
    end = time.monotonic() + 60
    while (runs := runs_on(copy)) and time.monotonic() < end:
        time.sleep(0.1)
    if runs:
        os.kill(copy, signal.SIGKILL)
    assert not runs


def runs_on(process):
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except FileNotFoundError:
        return False


def test_nobody_is_asked_for_input(way):
    if way == "linux":
        message = kl.exercises.check("rotation.1", lambda t: input()).message
        assert "EOFError: nobody answers input() while a check runs" in message


def test_where_there_is_neither_copy_nor_thread_the_work_is_done_here(monkeypatch):
    monkeypatch.setattr(sys, "platform", "emscripten")
    assert within(1, threading.get_ident) == threading.get_ident()


def test_a_copy_that_cannot_be_made_is_replaced_by_a_thread(monkeypatch):
    def refuse():
        raise OSError("no more processes")

    monkeypatch.setattr(time_limit, "_fork", refuse)
    assert within(60, lambda: 6 * 7) == 42
