"""Curves over time: where they lie, which limits are seen, and the still picture of them."""
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from lesson_views import path_view

import kinlab as kl
from kinlab.drawing.path_picture import STYLES, path_scene, seen
from kinlab.drawing.timed import Band, Bound, Course, Panel, Timed, laid, place
from kinlab.drawing.timed_marks import timed_height, timed_marks

close = np.testing.assert_allclose
SIZE = (266.0, 128.0)  # leaves 200 by 80 px for the curves


def panel(*values, bounds=(), bands=()):
    courses = tuple(Course(f"θ{k}", "first", row, "°", k) for k, row in enumerate(values, 1))
    return Panel("angles", courses, tuple(Bound(level, "first", joint) for level, joint in bounds),
                 bands)


def test_a_place_among_samples_that_are_not_evenly_apart():
    times = (0, 0.1, 0.4, 2)
    assert [place(times, t) for t in (-1, 0, 0.1, 1.2, 2, 9)] == [0, 0, 1, 2.5, 3, 3]
    assert place(times, 0.25) == pytest.approx(1.5)


def test_a_panel_by_hand():
    data = panel((0.0, 10.0, 20.0), bounds=[(15, 1)], bands=(Band(0.75, 1, 1),)).data()
    at = laid(data | {"low": -10.0, "high": 30.0}, (0.0, 0.5, 1.0), SIZE, 0.75)
    assert at.box == (54, 26, 254, 106)
    close(at.whole, [[(54, 86), (154, 66), (254, 46)]])
    close(at.gone, [[(54, 86), (154, 66), (204, 56)]])
    assert (at.bounds, at.bands, at.zero, at.now) == ((56,), ((204, 254),), 86, 204)
    assert at.signs == ((229, 35),)
    assert at.up == ((86, "0"), (46, "20"))
    assert at.across == ((54, "0.0 s"), (154, "0.5"), (254, "1.0"))


@pytest.mark.parametrize("low, high, words", [
    (-1e7, 1e7, ["−1e7", "−5e6", "0", "5e6", "1e7"]),
    (-1.5e6, 2.5e6, ["−1e6", "0", "1e6", "2e6"]), (1.05e6, 1.2e6, ["1.05e6", "1.1e6", "1.15e6",
                                                                   "1.2e6"]),
    (-4e-6, 4e-6, ["−4e−6", "−2e−6", "0", "2e−6", "4e−6"]),
    (-5e4, 5e4, ["−40000", "−20000", "0", "20000", "40000"])])
def test_long_numbers_on_an_axis_are_written_short(low, high, words):
    data = panel((0.0, 1.0)).data() | {"low": low, "high": high}
    at = laid(data, (0.0, 1e5), (266.0, 178.0), 0)
    assert [text for _, text in at.up] == words
    assert [text for _, text in at.across] == ["0 s", "50000", "1e5"]


def test_a_limit_is_drawn_where_its_own_joint_comes_near():
    """The range is 100: 20 beyond a joint's own values its limit is seen, farther it is not."""
    seen_ = panel((0.0, 50.0), (0.0, 100.0), bounds=[(69, 1), (-21, 1), (119, 2), (160, 2)])
    assert [bound.level for bound in seen_.near] == [69, 119]
    low, high = seen_.ends
    assert low == pytest.approx(-7.14) and high == pytest.approx(126.14)


def test_signs_stand_in_the_panel_and_in_rows_where_they_would_meet():
    """Each is 34 px wide and 15 px high; the curves lie from 54 to 254 px."""
    bands = [Band(0, 0.1, 1), Band(0.02, 0.2, 2), Band(0.15, 0.4, 3), Band(0.9, 1, 4)]
    at = laid(panel((0.0, 1.0), bands=tuple(bands)).data(), (0.0, 1.0), SIZE, 0)
    close(at.signs, [(71, 35), (76, 50), (109, 35), (237, 35)])


def test_what_is_infinite_ends_at_the_edge_and_what_rests_has_a_range():
    data = panel((float("inf"), 1.0, -float("inf"))).data()
    low, high = data["low"], data["high"]
    assert data["courses"][0]["values"] == pytest.approx([high, 1.0, low])
    assert low < 1 < high
    assert panel((0.0, 0.0)).ends == (-1, 1)


@given(st.lists(st.floats(-1e5, 1e5), min_size=2, max_size=40), st.floats(0.01, 500),
       st.floats(200, 1500), st.floats(100, 400), st.floats(-0.1, 1.1))
def test_it_stays_in_its_frame(values, end, width, height, share):
    times = np.linspace(0, end, len(values)).tolist()
    at = laid(panel(tuple(values)).data(), times, (width, height), share * end)
    left, top, right, bottom = at.box
    for x, y in (*at.whole[0], *at.gone[0]):
        assert left - 1e-6 <= x <= right + 1e-6 and top - 0.01 <= y <= bottom + 0.01
    for ticks, least in ((at.across, 44), (at.up, 26)):
        assert all(np.abs(np.diff([place for place, _ in ticks])) >= least - 1e-6)
        assert len({text for _, text in ticks}) == len(ticks)


def test_curves_are_told_apart_without_colour():
    scene = path_scene(ARM, PATH)
    paints = scene.data()["paints"]
    looks = [(paints[style]["stroke"], paints[style].get("stroke-dasharray")) for style in STYLES]
    assert len(set(looks)) == len(looks) == 9
    for ink in {stroke for stroke, _ in looks}:
        assert len({dash for stroke, dash in looks if stroke == ink}) == 3


ARM = kl.Arm([kl.revolute(a=1)] * 9)
PATH = kl.joint_path(ARM, [0] * 9, np.linspace(-1, 1, 9), 2)


@pytest.mark.parametrize("profile", ("cubic", "quintic", "trapezoidal"))
def test_the_samples_of_a_picture_show_the_same(profile):
    """Straight lines between them miss joints by a thousandth of their range, and less."""
    arm = kl.robots.alpha_ii()
    path = kl.joint_path(arm, arm.home, [1, -0.6, 1, 0.2, 2], 3, profile)
    few = seen(path)
    assert len(few.t) < 0.6 * len(path.t) and few.t[-1] == path.t[-1]
    between = np.array([np.interp(path.t, few.t, column) for column in few.q.T]).T
    assert np.abs(between - path.q).max() <= 5.1e-4 * np.ptp(path.q)
    rates = np.array([np.interp(path.t, few.t, column) for column in few.rates.T]).T
    assert np.abs(rates - path.rates).max() <= 2.1e-3 * np.ptp(path.rates)


def test_the_arm_stands_where_the_path_has_it():
    arm = kl.robots.alpha_ii()
    path = kl.joint_path(arm, arm.home, [1, -0.6, 1, 0.2, 2], 3)
    scene = path_scene(arm, path)
    for time in (0, 0.4, 1.5, 2.71, 3):
        wanted = kl.forward_kinematics(arm, path.at(time))
        close(scene.frames([time])[scene.tip], wanted, atol=0.6)  # mm; the arm reaches 500
    close(scene.frames([0])[scene.tip], kl.forward_kinematics(arm, arm.home), atol=1e-3)


def test_nothing_leaves_the_picture_on_the_way():
    """Whatever is solid lies within the points that frame it, from any side: a long boom, too."""
    arm = kl.robots.stanford()
    scene = path_scene(arm, kl.joint_path(arm, arm.home, arm.home + [1, 0.5, 0.1, -1, 0.5, 1], 2))
    corners = np.array([place for _, *place in scene.fit.points])
    for time in (0, 0.5, 1, 1.4, 2):
        frames = scene.frames([time])
        ends = np.array([(frames[k] @ (*local, 1.0))[:3] for item in scene.items
                         if item.shape in ("tube", "ball", "box") for k, *local in item.points])
        for way in np.random.default_rng(3).normal(size=(50, 3)):
            assert (ends @ way).max() <= (corners @ way).max()


def test_the_still_picture_says_all_of_it():
    view = path_view()
    timed = view._scene.timed
    drawn = timed_marks(timed, 1.0, (580.0, 520.0))
    said = {mark.text for part in drawn for mark in part.marks if mark.text}
    assert {"θ₁", "θ₂", "tip", "joint angles (deg)", "rates (deg/s)", "way of the tip (m)",
            "! θ₁", "! θ₂"} <= said
    assert not {"accelerations (deg/s²)", "speed of the tip (m/s)"} & said  # behind their buttons
    assert {f"! {breach}" for breach in view.path.broken} <= said
    lowest = max(line[:, 1].max() for part in drawn for mark in part.marks for line in mark.lines)
    assert lowest == pytest.approx(520 + timed_height(timed, 580))


def test_the_marks_are_where_the_layout_has_them():
    timed = Timed((0.0, 1.0), (panel((0.0, 1.0)),))
    *_, drawn = timed_marks(timed, 0.5, (580.0, 100.0))
    wanted = laid(timed.data()["panels"][0], timed.times, (580.0, 150.0), 0.5).gone[0]
    lines = [line for mark in drawn.marks for line in mark.lines]
    assert any(line.shape == (2, 2) and np.allclose(line, np.array(wanted) + [0, 124])
               for line in lines)
