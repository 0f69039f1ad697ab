"""A path's view from Python: its time, its words, its table and its film."""
import csv
import io
import json
import math

import numpy as np
import pytest
from lesson_views import path_view
from PIL import Image, ImageChops

import kinlab as kl

ARM = kl.robots.two_link()
PATH = kl.joint_path(ARM, [0, 0.5], [1, -0.5], 0.4)


@pytest.fixture
def view():
    return kl.PathView(ARM, PATH)


def test_its_knob_is_the_time(view):
    assert [control.name for control in view.controls] == ["time"]
    assert (view["time"].min, view["time"].max, view["time"].description) == (0, 0.4, "t (s)")
    view.time = 0.2
    assert view.q.tolist() == [0.2]
    assert view.T == pytest.approx(kl.forward_kinematics(ARM, [0.5, 0]))
    view.time = 99
    assert view.time == 0.4 and view.T == pytest.approx(kl.forward_kinematics(ARM, [1, -0.5]))


@pytest.mark.parametrize("path, length", [
    (kl.straight_path(ARM, [1.2, 0.1, 0], [-1.2, 0.1, 0], 2), 2.4),
    (kl.joint_path(ARM, [0, 2 * math.pi / 3], [math.pi / 2, 2 * math.pi / 3], 2), math.pi / 2)])
def test_the_way_of_the_tip_is_as_long_as_its_line_or_its_arc(path, length):
    """With the elbow at 120 degrees the tip is 1 m from the base: a quarter turn is pi / 2."""
    (way,) = [panel.courses[0] for panel in kl.PathView(ARM, path)._scene.timed.panels
              if panel.title == "way of the tip (m)"]
    assert way.values[0] == 0 and way.values[-1] == pytest.approx(length, rel=1e-4)


def test_its_words_say_where_the_arm_is_and_what_is_broken():
    view = path_view()
    view.time = 1
    first, *broken = repr(view).splitlines()
    assert first.startswith("PathView('Two links', t=1 s of 2 s, q=[")
    assert broken == [breach.text for breach in view.path.broken]
    assert {breach.kind for breach in view.path.broken} == {"limit", "speed", "acceleration"}


def test_an_arm_made_anew_is_the_same_one():
    assert kl.PathView(kl.robots.two_link(), PATH).path is PATH


@pytest.mark.parametrize("arguments, words", [
    ((None, PATH), "arm: expected"), ((ARM, None), "path: expected a path, got None; make one"),
    ((kl.robots.alpha_ii(), PATH), "arm, path: expected the arm that the path was made for"),
])
def test_what_does_not_fit_is_refused(arguments, words):
    with pytest.raises(ValueError, match=words):
        kl.PathView(*arguments)


def test_a_saved_state_holds_all_that_the_browser_needs(view):
    view.time = 0.3
    state = json.loads(json.dumps(view.get_state(["scene", "time", "formula"])))
    assert state["time"] == 0.3
    timed = state["scene"]["timed"]
    assert timed["times"][-1] == 0.4 and [knob["name"] for knob in state["scene"]["knobs"]] == [
        "time"]
    assert math.isfinite(sum(value for panel in timed["panels"] for course in panel["courses"]
                             for value in course["values"]))


# ---- files ----

def test_the_table_has_each_sample_with_its_units(tmp_path):
    arm = kl.Arm([kl.revolute(a=100), kl.prismatic(limits=(0, 90))], unit="mm")
    path = kl.joint_path(arm, [0, 0], [1, 90], 2, "cubic")
    file = kl.PathView(arm, path).save_csv(tmp_path / "path.csv")
    with file.open(encoding="utf-8", newline="") as lines:
        head, *rows = csv.reader(lines)
    assert head == [
        "t (s)", "theta_1 (rad)", "d_2 (mm)", "theta_1 rate (rad/s)", "d_2 rate (mm/s)",
        "theta_1 acceleration (rad/s^2)", "d_2 acceleration (mm/s^2)", "x (mm)", "y (mm)", "z (mm)"]
    rows = np.array(rows, float)
    assert rows.shape == (len(path.t), 10)
    middle = rows[rows[:, 0] == 1][0]
    assert middle == pytest.approx([1, 0.5, 45, 0.75, 67.5, 0, 0, 100 * np.cos(0.5),
                                    100 * np.sin(0.5), 45], abs=1e-6)


def test_no_number_of_the_table_is_a_zero_with_a_sign(tmp_path):
    """At rest, the rate of a joint that turns back is -0 times its way."""
    path = kl.joint_path(kl.robots.two_link(), [0.5, 0], [-0.5, -1], 1)
    assert np.signbit(path.rates[0]).any()
    rows = path.save_csv(tmp_path / "a.csv").read_text().splitlines()[1:]
    cells = {cell for row in rows for cell in row.split(",")}
    assert "0" in cells and "-0" not in cells


def test_a_unit_that_a_spreadsheet_would_run_is_text(tmp_path):
    arm = kl.Arm([kl.prismatic()], unit="=1+1")
    head = kl.joint_path(arm, [0], [1], 1).save_csv(tmp_path / "a.csv").read_text().splitlines()[0]
    assert not any(cell.startswith(("=", "+", "-", "@")) for cell in head.split(","))


def test_the_film_begins_and_ends_as_the_stills_and_takes_its_time(view, tmp_path):
    file = view.save_gif(tmp_path / "film.gif", fps=10, width=240)
    film = Image.open(file)
    assert film.n_frames == 5 and film.width == 240
    lasts, shown = [], []
    for k in range(film.n_frames):
        film.seek(k)
        lasts.append(film.info["duration"])
        shown.append(film.convert("RGB"))
    assert sum(lasts[:-1]) == 400 and lasts[-1] == 1000
    for time, own, other in ((0, shown[0], shown[-1]), (0.4, shown[-1], shown[0])):
        view.time = time
        still = Image.open(io.BytesIO(view._still())).convert("RGB")
        still = still.resize(own.size, Image.Resampling.LANCZOS)
        off, wrong = (np.asarray(ImageChops.difference(still, one), float).mean()
                      for one in (own, other))
        assert off < 3 and off < 0.6 * wrong


@pytest.mark.parametrize("name, words", [
    (3, "expected the name of a file such as 'arm.gif'"), ("film.mp4", "ends in .gif, got"),
    ("nowhere/film.gif", "there is no folder 'nowhere'")])
def test_a_name_that_will_not_do(view, name, words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ValueError, match=f"^path: .*{words}"):
        view.save_gif(name)
    with pytest.raises(ValueError, match=r"^path: .*(\.csv|no folder)"):
        view.save_csv(name)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("options, words", [
    (dict(fps=0), "fps: expected a whole number from 1 to 50, got 0"),
    (dict(fps=2.5), "fps: expected a whole number from 1 to 50, got 2.5"),
    (dict(fps=60), "fps: expected a whole number from 1 to 50, got 60"),
    (dict(width=99), "width: expected a whole number from 100"),
    (dict(width=5000), "width: expected a whole number from 100 to 1600, got 5000")])
def test_a_film_of_no_use_is_refused(view, options, words, tmp_path):
    with pytest.raises(ValueError, match=words):
        view.save_gif(tmp_path / "film.gif", **options)


def test_a_film_of_too_many_pictures_is_refused(tmp_path):
    for seconds, words in ((100, r"at most 600 pictures, got 15 in a second, 1501 in all; "
                                 r"write fps=5 or less"), (3600, "make a shorter path")):
        view = kl.PathView(ARM, kl.joint_path(ARM, [0, 0.5], [1, -0.5], seconds))
        with pytest.raises(ValueError, match=f"^fps: expected a film of {'.*' + words}"):
            view.save_gif(tmp_path / "film.gif")
    assert list(tmp_path.iterdir()) == []
