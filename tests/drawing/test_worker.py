"""The drawing beside the kernel: the same pictures, and no process that stays."""
import subprocess
import sys
import time

import pytest

import kinlab as kl
from kinlab.drawing import figure, worker
from kinlab.drawing.arm_scene import arm_scene

ARM = kl.robots.two_link()
JOB = arm_scene(ARM), ARM.home, "top", ("frames", "labels")


@pytest.fixture(autouse=True)
def end():
    yield
    if worker._hand is not None:
        worker._hand.kill()
        worker._hand.wait()


def test_a_view_leaves_matplotlib_out_of_its_own_process():
    code = ("import sys, kinlab as kl; view = kl.ArmView(kl.robots.two_link())\n"
            "view._repr_mimebundle_(); print('matplotlib' in sys.modules)")
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "False" and run.stderr == ""


def test_the_editor_leaves_it_out_too():
    code = ("import sys, kinlab as kl; editor = kl.DHTableEditor()\n"
            "editor._hear(None, {'do': 'open', 'with': ['compare']}, [])\n"
            "print('data:image/png' in editor.panel, 'matplotlib' in sys.modules)")
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.split() == ["True", "False"]


def test_the_pictures_are_those_that_would_be_drawn_here():
    assert worker.png(*JOB) == figure.png(figure.figure(*JOB))
    assert worker.png(*JOB) == figure.png(figure.figure(*JOB))


def test_the_drawing_process_ends_when_idle_and_starts_again(monkeypatch):
    monkeypatch.setattr(worker, "IDLE", 0.5)
    picture = worker.png(*JOB)
    first = worker._hand
    assert worker.png(*JOB) == picture and worker._hand is first
    assert first.wait(timeout=30) == 0
    assert worker.png(*JOB) == picture and worker._hand is not first


def test_a_drawing_process_that_dies_is_replaced():
    picture = worker.png(*JOB)
    worker._hand.kill()
    time.sleep(0.1)
    assert worker.png(*JOB) == picture


def test_without_processes_the_picture_is_drawn_here(monkeypatch):
    def refuse():
        raise OSError("no processes here")

    monkeypatch.setattr(worker, "_hand", None)
    monkeypatch.setattr(worker, "_start", refuse)
    assert worker.png(*JOB) == figure.png(figure.figure(*JOB))


def test_an_error_in_the_drawing_is_raised_here_and_the_next_picture_is_whole():
    with pytest.raises(KeyError, match="nowhere"):
        worker.png(JOB[0], JOB[1], "nowhere", ())
    assert worker.png(*JOB) == figure.png(figure.figure(*JOB))
