"""The workspace by sampling: its shape, its evenness, its memory, its pictures."""
import io
import sys
import tracemalloc
from math import pi

import numpy as np
import pytest
from nbclient import NotebookClient
from nbformat.v4 import new_code_cell, new_notebook
from test_kinematics import course

import kinlab as kl
from kinlab.arms import workspace
from kinlab.arms.kinematics import reach
from kinlab.arms.workspace import r_sequence
from kinlab.course.notebooks import steady

close = np.testing.assert_allclose


def test_two_link_reaches_an_annulus():
    arm = kl.Arm([kl.revolute(a=1), kl.revolute(a=0.4)])
    points = kl.workspace(arm, 200_000).points
    radius = np.linalg.norm(points, axis=1)
    assert 0.6 - 1e-9 <= radius.min() < 0.6001 and 1.3999 < radius.max() <= 1.4 + 1e-9
    angle = np.arctan2(points[:, 1], points[:, 0])
    counts, _ = np.histogram(angle, bins=36, range=(-pi, pi))
    close(counts, counts.mean(), rtol=0.01)


def test_limits_bound_the_sweep():
    arm = kl.Arm([kl.revolute(a=1, limits=(0, pi / 2)), kl.revolute(a=1, limits=(0, pi / 2))])
    points = kl.workspace(arm, 50_000).points
    close(np.linalg.norm(points, axis=1).min(), 2 ** 0.5, atol=1e-3)
    assert points[:, 1].min() > -1e-9 and points[:, 0].min() > -1 - 1e-9


def test_cylindrical_reaches_a_tube():
    reached = kl.workspace(kl.robots.cylindrical(), 100_000)
    radius, height = reached.radii_and_heights()
    close([radius.min(), radius.max()], [0.1, 0.6], atol=1e-3)
    close([height.min(), height.max()], [0.5, 1.0], atol=1e-3)
    heights, nearest, farthest = reached.envelope(20)
    close(heights, 0.5 + 0.025 * (np.arange(20) + 0.5), atol=1e-3)
    close(nearest, 0.1, atol=1e-2)
    close(farthest, 0.6, atol=1e-2)


@course
def test_points_are_those_of_forward_kinematics(robot):
    arm = robot()
    ends = np.array([link.limits or (-pi, pi) for link in arm.links])
    q = ends[:, 0] + (ends[:, 1] - ends[:, 0]) * r_sequence(arm.n, 0, 5000, 3).T
    points = kl.workspace(arm, 5000, seed=3).points
    close(points, kl.forward_kinematics(arm, q)[:, :3, 3], atol=1e-9)
    assert np.linalg.norm(points - arm.base[:3, 3], axis=1).max() <= reach(arm)


def test_a_base_and_a_tilt():
    tilt = kl.homogeneous(kl.rotation_x(1.0), [3, 4, 5])
    arm = kl.robots.cylindrical()
    moved = kl.Arm(arm.links, base=tilt)
    there, here = kl.workspace(moved, 5000), kl.workspace(arm, 5000)
    close(there.points, kl.apply(tilt, here.points), atol=1e-12)
    close(there.radii_and_heights(), here.radii_and_heights(), atol=1e-12)


@pytest.mark.parametrize("dimensions", range(1, 8))
def test_the_sequence_is_even(dimensions):
    """Every box of an eighth holds its share, far closer than random numbers would."""
    u = r_sequence(dimensions, 0, 20_000, 0)
    assert u.shape == (dimensions, 20_000) and 0 <= u.min() and u.max() < 1
    for row in u:
        close(np.histogram(row, bins=8, range=(0, 1))[0], 2500, atol=25)
    close(r_sequence(dimensions, 700, 5, 0), u[:, 700:705], atol=1e-9)
    assert not np.allclose(r_sequence(dimensions, 0, 5, 1), u[:, :5])


def test_the_same_seed_gives_the_same_points():
    arm = kl.robots.alpha_ii()
    assert np.array_equal(kl.workspace(arm, 999, seed=4).points,
                          kl.workspace(arm, 999, seed=4).points)


def test_memory_is_that_of_the_points():
    arm = kl.robots.intelledex_660t()
    tracemalloc.start()
    reached = kl.workspace(arm, 300_000)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < reached.points.nbytes + 6e6


def test_progress_is_told():
    told = []
    kl.workspace(kl.robots.two_link(), 10_000, progress=lambda *state: told.append(state))
    assert told[-1] == (10_000, 10_000) and told == sorted(told) and len(told) == 3


class Terminal(io.StringIO):
    def isatty(self):
        return True

    def line(self):
        """What is to be read on it in the end: a return begins the line anew."""
        line = []
        for text in self.getvalue().split("\r"):
            line[:len(text)] = text
        return "".join(line).rstrip()


def test_a_bar_appears_in_a_terminal_and_goes(monkeypatch):
    monkeypatch.delenv("COLUMNS", raising=False)    # a bar is as long as the terminal is wide
    monkeypatch.setattr("sys.stderr", Terminal())
    monkeypatch.setattr(workspace, "PATIENCE", -1)
    kl.workspace(kl.robots.two_link(), 20_000)
    text = sys.stderr.getvalue()
    assert "workspace:  20%|##        | 4096/20000" in text and sys.stderr.line() == ""
    assert text.endswith("\r") and "\n" not in text


def test_no_bar_for_short_work_or_without_a_terminal(monkeypatch, capsys):
    monkeypatch.setattr(workspace, "PATIENCE", -1)
    kl.workspace(kl.robots.two_link(), 20_000)
    assert capsys.readouterr().err == ""
    monkeypatch.setattr("sys.stderr", Terminal())
    monkeypatch.setattr(workspace, "PATIENCE", 60)
    kl.workspace(kl.robots.two_link(), 20_000)
    assert sys.stderr.getvalue() == ""


def test_no_bar_where_there_is_nothing_to_write_to(monkeypatch):
    """Python without a console, as under pythonw."""
    monkeypatch.setattr("sys.stderr", None)
    monkeypatch.setattr(workspace, "PATIENCE", -1)
    assert kl.workspace(kl.robots.two_link(), 20_000).points.shape == (20_000, 3)


def test_a_bar_goes_when_the_work_is_stopped(monkeypatch):
    monkeypatch.setattr("sys.stderr", Terminal())
    monkeypatch.setattr(workspace, "PATIENCE", -1)
    with pytest.raises(KeyboardInterrupt), workspace.ProgressBar("work") as report:
        report(1, 3)
        raise KeyboardInterrupt
    assert "work:  33%|###" in sys.stderr.getvalue()
    assert sys.stderr.getvalue().endswith("\r") and sys.stderr.line() == ""


LONG = """import kinlab as kl
from kinlab.arms import workspace
workspace.PATIENCE = {patience}
kl.workspace(kl.robots.two_link(), 20_000).points.shape"""

STOPPED = """from kinlab.arms import workspace
workspace.PATIENCE = {patience}
try:
    with workspace.ProgressBar("work") as report:
        report(1, 3)
        raise KeyboardInterrupt
except KeyboardInterrupt:
    shape = 20000, 3
shape"""


@pytest.mark.parametrize("patience", [-1, 60])
@pytest.mark.parametrize("work", [LONG, STOPPED], ids=["long", "stopped"])
def test_a_bar_in_a_notebook_leaves_no_trace(work, patience):
    """What is saved is the same whether the work was long or short, but a bar was there."""
    code = new_code_cell(work.format(patience=patience), id="long")
    notebook, shown = new_notebook(cells=[code]), []
    client = NotebookClient(notebook, kernel_name="python3", store_widget_state=False)
    process = client.process_message
    client.process_message = lambda msg, *rest: (shown.append(msg), process(msg, *rest))[1]
    client.execute()
    kinds = [msg["msg_type"] for msg in shown]
    opened = [msg for msg in shown if msg["msg_type"] == "comm_open"]
    assert (len(opened) > 0) == (patience < 0) == ("update_display_data" in kinds)
    left = {msg["content"]["comm_id"]: msg["content"]["data"]["state"]["_model_name"]
            for msg in opened}
    for msg in shown:
        if msg["msg_type"] == "comm_close":
            del left[msg["content"]["comm_id"]]
    assert all(name.endswith(("LayoutModel", "StyleModel")) for name in left.values()), left
    assert kinds.count("display_data") == kinds.count("update_display_data") == (patience < 0)
    for output in steady(notebook).cells[0].outputs:
        assert output.output_type == "execute_result"
        assert output.data == {"text/plain": "(20000, 3)"}


def test_slices():
    reached = kl.workspace(kl.robots.alpha_ii(), 20_000)
    slab = reached.slice("z", 215, 20)
    assert 0 < len(slab) < 20_000 and np.abs(slab[:, 2] - 215).max() <= 10
    assert len(reached.slice("x", 1e6)) == 0 and len(reached.slice("y", 0)) > 0


def test_density_is_highest_where_poses_gather():
    counts, radii, heights = kl.workspace(kl.robots.cylindrical(), 200_000).density(10)
    assert counts.shape == (10, 10) and counts.max() == 1 and len(radii) == len(heights) == 11
    close(counts[0], 1, atol=0.1)     # poses per volume fall as 1/r on a cylindrical arm
    close(counts[-1], 0.15 / 0.6, atol=0.06)


@pytest.mark.parametrize("picture, words", [
    (kl.slice_picture, "slice y = 0 mm"), (kl.envelope_picture, "reach envelope"),
    (kl.density_picture, "density")])
def test_pictures_name_what_they_show(picture, words):
    reached = kl.workspace(kl.robots.alpha_ii(), 5000)
    fig = picture(reached)
    ax = fig.axes[0]
    assert ax.get_title() == f"Alpha II: {words}"
    assert "(mm)" in ax.get_xlabel() and "(mm)" in ax.get_ylabel()
    out = io.BytesIO()
    fig.savefig(out)
    assert out.tell() > 5000


@pytest.mark.parametrize("picture", [kl.slice_picture, kl.envelope_picture, kl.density_picture])
def test_a_notebook_shows_a_picture_with_words(picture):
    fig = picture(kl.workspace(kl.robots.alpha_ii(), 5000))
    data, notes = fig._repr_mimebundle_()
    assert data["image/png"][1:4] == b"PNG" and data["text/plain"] == repr(fig) == fig.words
    assert notes["image/png"]["alt"] == f"Picture of a workspace. {fig.words}"
    assert fig.words.startswith("Alpha II: ") and fig.words.endswith(" mm")


def test_words_say_how_far_the_points_go():
    reached = kl.workspace(kl.robots.cylindrical(), 50_000)
    assert kl.envelope_picture(reached).words == (
        "Cylindrical: reach envelope, distance from the base's axis from 0.10 to 0.60 m, "
        "height from 0.50 to 1.00 m")
    assert kl.slice_picture(reached, "z", 9).words == "Cylindrical: slice z = 9 m, no points"


def test_the_arm_at_home_is_drawn_in_each_picture():
    """Shoulder, elbow, wrist and tip of the Alpha II, level at a height of 215 mm.

    Envelope and density show distances from the axis, so that a turn of the base is not seen.
    """
    arm = kl.robots.alpha_ii()
    turned = kl.Arm(arm.links, home=[2, *arm.home[1:]])
    here, there = kl.workspace(arm, 5000), kl.workspace(turned, 5000)
    for fig in (kl.slice_picture(here), kl.envelope_picture(here), kl.density_picture(here),
                kl.envelope_picture(there), kl.density_picture(there)):
        close(np.unique(drawn(fig, "arm at home").round(6), axis=0),
              [[0, 0], [0, 215], [177.8, 215], [355.6, 215], [485.1, 215]], atol=1e-6)


def drawn(fig, label):
    return next(line for line in fig.axes[0].lines if line.get_label() == label).get_xydata()


def test_the_envelope_of_a_planar_arm_is_a_ring():
    arm = kl.Arm([kl.revolute(a=1), kl.revolute(a=0.4)],
                 base=kl.homogeneous(kl.rotation_x(0.7), [1, 2, 3]))
    fig = kl.envelope_picture(kl.workspace(arm, 200_000), 36)
    for label, radius in (("farthest", 1.4), ("nearest", 0.6)):
        ring = drawn(fig, label)
        assert len(ring) == 37
        close(np.linalg.norm(ring, axis=1), radius, atol=2e-3)
        close(ring[0], ring[-1])


def test_the_envelope_of_a_planar_arm_with_limits_begins_after_its_gap():
    arm = kl.Arm([kl.revolute(a=1, limits=(2, 4)), kl.revolute(a=0.5, limits=(0, 0.1))])
    ends = drawn(kl.envelope_picture(kl.workspace(arm, 50_000), 360), "farthest")
    angles = np.unwrap(np.arctan2(*ends.T[::-1]))
    assert np.all(np.diff(angles) > 0)
    close(np.mod(angles[[0, -1]], 2 * pi), [2, 4 + 0.1 / 3], atol=0.02)


def test_pictures_of_a_planar_arm():
    reached = kl.workspace(kl.robots.two_link(), 2000)
    for fig in (kl.envelope_picture(reached), kl.density_picture(reached),
                kl.slice_picture(reached, "z")):
        assert fig.axes[0].get_xlabel() == "x (m)" and fig.axes[0].get_ylabel() == "y (m)"
        fig.savefig(io.BytesIO())


def test_bad_input():
    with pytest.raises(ValueError, match=r"^arm: expected limits on every prismatic joint"):
        kl.workspace(kl.Arm([kl.prismatic()]))
    reached = kl.workspace(kl.robots.two_link(), 10)
    for call, name in [(lambda: reached.slice("w", 0), "axis"),
                       (lambda: reached.slice("x", "0"), "at"),
                       (lambda: reached.slice("x", 0, -1), "thickness"),
                       (lambda: reached.envelope(0), "bins"),
                       (lambda: reached.density(2.5), "bins"),
                       (lambda: kl.envelope_picture(reached, 0), "bins"),
                       (lambda: kl.density_picture(reached, 2.5), "bins"),
                       (lambda: kl.slice_picture(reached.points), "reached")]:
        with pytest.raises(ValueError, match=f"^{name}: expected "):
            call()
