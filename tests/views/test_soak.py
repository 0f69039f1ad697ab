"""A long lesson in one kernel: many slider events, many views made and closed."""
import subprocess
from contextlib import contextmanager

import psutil
import pytest
from jupyter_client.manager import start_new_kernel

EVENTS, VIEWS, ALLOWED_MB = 10_000, 200, 5
PREPARE = """
import gc, kinlab as kl
from kinlab.drawing import worker
from ipywidgets.widgets import widget

arm = kl.robots.alpha_ii()

def drag(view, events):
    for k in range(events):
        state = {f"theta_{k % 5 + 1}": float(k % 90)}
        view.comm.handle_msg(
            {"content": {"data": {"method": "update", "state": state}}, "buffers": []})

def show(times):
    for k in range(times):
        view = kl.ArmView(arm, closed_form=k == 0)
        if k == 0:
            view._repr_mimebundle_()
        view.close()

show(3)
view = kl.ArmView(arm)
drag(view, 200)
drawn = worker.png(view._scene, view._values, "3-D", ())
worker.png = lambda *job: drawn  # another process draws, and takes most of the time
show(3)
"""


@contextmanager
def kernel():
    manager, client = start_new_kernel(stderr=subprocess.DEVNULL)
    try:
        yield psutil.Process(manager.provisioner.pid), client
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)


def run(client, code):
    """What the code prints, run in the kernel."""
    printed = []
    reply = client.execute_interactive(
        code, timeout=120, store_history=False,
        output_hook=lambda message: printed.append(message["content"].get("text", "")))
    assert reply["content"]["status"] == "ok", reply["content"]
    return "".join(printed)


@pytest.mark.thorough
def test_a_long_lesson_leaves_no_memory_behind():
    def state():
        widgets = int(run(client, "gc.collect(); print(len(widget._instances))"))
        return process.memory_full_info().uss / 1e6, widgets

    with kernel() as (process, client):
        run(client, PREPARE)
        memory, widgets = state()
        for _ in range(0, EVENTS, 200):  # few enough for the messages not to be dropped
            run(client, "drag(view, 200)")
        assert float(run(client, "print(view.controls[4].value)")) == 199 % 90
        after_events, _ = state()
        for _ in range(0, VIEWS, 10):
            run(client, "show(10)")
        after_views, left = state()
        loaded = run(client, "import sys; print('matplotlib' in sys.modules)")
    assert after_events - memory < ALLOWED_MB
    assert after_views - memory < ALLOWED_MB
    assert left == widgets
    assert loaded.strip() == "False"  # the drawing is done beside the kernel
