"""The drawing beside the kernel: the same pictures, and no process that stays."""
import subprocess
import sys
import time

import pytest

import kinlab as kl
from kinlab import draw, studio
from kinlab.arm_scene import arm_scene

ARM = kl.robots.two_link()
JOB = arm_scene(ARM), ARM.home, "top", ("frames", "labels")


@pytest.fixture(autouse=True)
def end():
    yield
    if studio._hand is not None:
        studio._hand.kill()
        studio._hand.wait()


def test_a_view_leaves_matplotlib_out_of_its_own_process():
    code = ("import sys, kinlab as kl; view = kl.ArmView(kl.robots.two_link())\n"
            "view._repr_mimebundle_(); print('matplotlib' in sys.modules)")
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "False" and run.stderr == ""


def test_the_editor_leaves_it_out_too():
    code = ("import sys, kinlab as kl; editor = kl.DHTableEditor()\n"
            "editor._hear(None, {'do': 'open', 'with': ['compare']}, [])\n"
            "print('data:image/png' in editor._html.value, 'matplotlib' in sys.modules)")
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.split() == ["True", "False"]


def test_the_pictures_are_those_that_would_be_drawn_here():
    assert studio.svg(*JOB) == draw.svg(draw.figure(*JOB))
    assert studio.png(*JOB) == draw.png(draw.figure(*JOB))


def test_the_drawing_process_ends_when_idle_and_starts_again(monkeypatch):
    monkeypatch.setattr(studio, "IDLE", 0.5)
    picture = studio.svg(*JOB)
    first = studio._hand
    assert studio.svg(*JOB) == picture and studio._hand is first
    assert first.wait(timeout=30) == 0
    assert studio.svg(*JOB) == picture and studio._hand is not first


def test_a_drawing_process_that_dies_is_replaced():
    picture = studio.svg(*JOB)
    studio._hand.kill()
    time.sleep(0.1)
    assert studio.svg(*JOB) == picture


def test_without_processes_the_picture_is_drawn_here(monkeypatch):
    def refuse():
        raise OSError("no processes here")

    monkeypatch.setattr(studio, "_hand", None)
    monkeypatch.setattr(studio, "_start", refuse)
    assert studio.svg(*JOB) == draw.svg(draw.figure(*JOB))


def test_an_error_in_the_drawing_is_raised_here_and_the_next_picture_is_whole():
    with pytest.raises(KeyError, match="nowhere"):
        studio.svg(JOB[0], JOB[1], "nowhere", ())
    assert studio.svg(*JOB) == draw.svg(draw.figure(*JOB))
