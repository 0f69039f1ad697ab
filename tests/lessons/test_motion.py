"""What the view of lesson 12 draws is what the textbooks' profiles say."""
import warnings
from pathlib import Path

import nbformat
import numpy as np
import pytest

import kinlab as kl
from kinlab.course.notebooks import FOLDER

# Part of the way that is gone at a quarter of the time, at a half and at three quarters.
# Cubic: 3/16 - 2/64. Quintic: 10/64 - 15/256 + 6/1024. Trapezoidal, a third of the time to speed
# up: half of 4.5 times 1/16; then 1/2 by symmetry.
WAYS = {"constant rate": (0.25, 0.5, 0.75), "cubic": (0.15625, 0.5, 0.84375),
        "quintic": (0.103515625, 0.5, 0.896484375), "trapezoidal": (0.140625, 0.5, 0.859375)}
LARGEST = {"constant rate": 1, "cubic": 1.5, "quintic": 1.875, "trapezoidal": 1.5}
HARDEST = {"cubic": 6, "quintic": 5.7735, "trapezoidal": 4.5}
LOW, MIDDLE, HIGH = -0.56, -0.32, -0.08  # of both charts, on the sketch


@pytest.fixture
def view():
    return kl.lessons.motion.race_view()


def item(view, gid):
    return next(item for item in view._scene.items if item.gid == gid)


def corners(view, gid):
    return np.array([point[1:3] for point in item(view, gid).points])


@pytest.mark.parametrize("name", WAYS)
def test_a_dot_is_where_its_profile_has_it(view, name):
    at = []
    for time in (0, 0.25, 0.5, 0.75, 1):
        view["time"].value = time
        point = item(view, f"point-{name}").points[0]
        at.append((view._scene.frames(view._values)[point[0]] @ (*point[1:], 1))[0])
    np.testing.assert_allclose(at, [0, *WAYS[name], 1], atol=1e-12)


@pytest.mark.parametrize("name", LARGEST)
def test_the_chart_of_rates_has_the_largest_one(view, name):
    heights = corners(view, f"rate (rad/s)-{name}")[:, 1]
    assert heights.max() == pytest.approx(LOW + LARGEST[name] * (MIDDLE - LOW), abs=1e-4)
    if name != "constant rate":
        np.testing.assert_allclose(heights[[0, -1]], LOW, atol=1e-12)


@pytest.mark.parametrize("name", HARDEST)
def test_the_chart_of_accelerations_has_the_largest_one_and_its_opposite(view, name):
    heights = corners(view, f"acceleration (rad/s²)-{name}")[:, 1]
    most = HARDEST[name] / 6 * (HIGH - MIDDLE)
    assert heights.max() == pytest.approx(MIDDLE + most, abs=1e-3)
    assert heights.min() == pytest.approx(MIDDLE - most, abs=1e-3)
    assert heights[0] == pytest.approx(MIDDLE if name == "quintic" else MIDDLE + most, abs=1e-3)


def test_curves_are_drawn_as_far_as_the_time_has_gone(view):
    from kinlab.drawing.curves import corners as drawn
    curve = item(view, "rate (rad/s)-cubic")
    for time in (0, 0.25, 1):
        view["time"].value = time
        scene, q = view._scene, view._values
        gone = drawn(curve, scene.motions, scene.frames(q), scene.places(q))
        assert gone[-1, 0] == pytest.approx(0.42 * time)


def test_a_constant_rate_leaps_once_the_time_runs(view):
    from kinlab.drawing.curves import is_there
    seen = {}
    for time in (0, 0.5, 1):
        view["time"].value = time
        places = view._scene.places(view._values)
        seen[time] = [is_there(item(view, f"acceleration (rad/s²)-leap-{end}"), places)
                      for end in (0, 1)]
    assert seen == {0: [False, False], 0.5: [True, False], 1: [True, True]}


def test_it_is_played_in_its_own_second(view):
    times, stops = view._scene.timed.times, [stop for stop, in view._scene.poses]
    assert (times[0], times[60], times[-1]) == pytest.approx((0, 0.5, 1))
    assert (stops[0], stops[5], stops[-1]) == pytest.approx((0, 0.5, 1))


# ---- a robot of one's own: the lesson's cells, with another file ------------------------------

PUBLIC = Path(__file__).parents[1] / "urdf" / "public"
LESSON = nbformat.read(FOLDER / "12_motion_in_time.ipynb", as_version=4)
OTHERS = {"q_start = np.radians([0, -90, -90, -90, 90, 0])": "q_start = robot.home + 0.9",
          "way = np.array([0, 0.4, 0])": "way = -0.2 * start[:3, 3]"}  # as the lesson's text says


def cell(name):
    return next(one.source for one in LESSON.cells if one.id == name)


@pytest.mark.filterwarnings("ignore::kinlab.arms.inputs.Note")
@pytest.mark.parametrize("name, tip", [
    ("al5d", "link4"), ("so100", "jaw"), ("irb140", "tool0"), ("panda", "panda_hand"),
    ("pr2", "r_gripper_tool_frame")])
def test_its_cells_move_other_robots_by_the_numbers_that_it_names(name, tip):
    assert all(words in cell("own-line-text") for words in OTHERS.values())
    source = cell("own-line")
    for own, other in OTHERS.items():
        assert own in source
        source = source.replace(own, other)
    moves(source, kl.from_urdf(PUBLIC / f"{name}.urdf", tip=tip))


def test_they_move_an_arm_that_cannot_hold_its_tool():
    source = cell("own-line")
    for own, other in OTHERS.items():
        source = source.replace(own, other)
    moves(source, kl.robots.exam_2018())


def moves(source, robot):
    path = run(source, robot=robot)["aside"]
    there = kl.forward_kinematics(robot, path.q[[0, -1]])[:, :3, 3]
    np.testing.assert_allclose(there[1], 0.8 * there[0], atol=1e-6)


def run(source, **names):
    scope = {"kl": kl, "np": np, **names}
    exec(source, scope)
    return scope


def test_it_hears_all_that_is_said_of_a_file_but_of_its_frames(tmp_path):
    """A file whose angles are degrees, and whose joint cannot move."""
    (tmp_path / "robot.urdf").write_text('''<robot name="R"> <link name="a"/> <link name="b"/>
      <link name="c"/> <joint name="one" type="revolute"> <parent link="a"/> <child link="b"/>
        <origin xyz="1 0 0" rpy="90 0 0"/> <axis xyz="0 1 0"/> <limit effort="1" velocity="1"/>
      </joint> <joint name="two" type="revolute"> <parent link="b"/> <child link="c"/>
        <origin xyz="0 1 0"/> <axis xyz="1 0 0"/> <limit lower="-1" upper="1"/> </joint>
      </robot>''', encoding="utf-8")
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        kl.from_urdf(tmp_path / "robot.urdf")
    every = [str(one.message) for one in caught]
    assert any("kl.urdf_frames" in said for said in every) and len(every) > 1
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        run(cell("own-read"), folder=tmp_path)
    heard = [str(one.message) for one in caught]
    assert heard == [said for said in every if "kl.urdf_frames" not in said]
    assert any("cannot move" in said for said in heard)


# ---- no answer before its question -------------------------------------------------------------


def place(name):
    return [one.id for one in LESSON.cells].index(name)


def test_the_charts_come_after_the_questions_that_they_answer(view):
    asked = ("quarter-predict", "peak-predict", "hard-predict", "price-predict", "whole-predict")
    assert max(map(place, asked)) < place("race")
    dots = kl.predict("motion.quarter")
    assert not {item.gid for item in dots._scene.items if "rate (" in item.gid}
    assert {item.gid for item in view._scene.items if "rate (" in item.gid}
