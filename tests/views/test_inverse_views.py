"""The views of inverse kinematics from Python: the target, the steps of a solve, the columns."""
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import kinlab as kl
from kinlab.arms.kinematics import typical_length
from kinlab.drawing.curves import corners

close = np.testing.assert_allclose
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)


@course
def test_the_target_begins_on_the_tool(robot):
    view = kl.TargetView(robot())
    close(view.target, view.T[:3, 3], atol=1e-9)
    assert view.error < 1e-9 and len(view.joints) == view.arm.n


@course
def test_the_arm_goes_to_a_target_set_from_python(robot):
    arm = robot()
    near = arm.home + 0.1 * np.array([1.0 if link.kind == "revolute" else 0.1
                                      for link in arm.links])
    place = kl.forward_kinematics(arm, near)[:3, 3]
    view = kl.TargetView(arm)
    view.target = place
    close(view.target, place, atol=1e-6 * np.abs(place).max())
    close(kl.forward_kinematics(arm, view.q)[:3, 3], place, atol=1e-5 * np.abs(place).max())


def test_a_target_out_of_reach_is_approached():
    view = kl.TargetView(kl.robots.two_link(), q=[0.4, 0.5])
    view.target = (0, 2.2, 0)
    close(view.T[:3, 3], (0, 2, 0), atol=1e-5)
    assert view.error == pytest.approx(0.2, abs=1e-6)
    assert "target=[0, 2.2, 0] m, error=0.2 m" in repr(view)


def test_a_target_beyond_the_picture_stops_at_its_edge():
    view = kl.TargetView(kl.robots.two_link())
    view.target = (9, 0, 0)
    assert view.target[0] == view["x"].max < 9
    assert view.note.startswith("x* stops at its limit")


def test_the_target_rides_when_joints_are_set():
    view = kl.TargetView(kl.robots.alpha_ii())
    view.q = [0.3, -0.4, 0.5, -0.2, 0.1]
    close(view.q, [0.3, -0.4, 0.5, -0.2, 0.1])
    close(view.target, view.T[:3, 3], atol=1e-9)


@pytest.mark.parametrize("bad", [(1, 2), "far", None, (1, 2, np.nan), [[1, 2, 3]]])
def test_a_bad_target_leaves_everything(bad):
    view = kl.TargetView(kl.robots.alpha_ii())
    before = repr(view)
    with pytest.raises(ValueError, match=r"^target: expected"):
        view.target = bad
    assert repr(view) == before


@pytest.mark.parametrize("make", [kl.TargetView, kl.velocity_view,
                                  lambda arm, *q: kl.solve_view(arm, [1, 1, 0], *q)])
def test_bad_arms_and_poses_are_refused(make):
    with pytest.raises(ValueError, match="arm: expected a kinlab Arm"):
        make("two-link")
    with pytest.raises(ValueError, match=r"q0?: expected shape .*\(3,\)"):
        make(kl.robots.two_link(), [1, 2, 3])


@course
def test_columns_read_as_the_jacobian(robot):
    arm = robot()
    view = kl.velocity_view(arm)
    low, high = np.array([(slider.min, slider.max) for slider in view.controls]).T
    for slider, value in zip(view.controls, low + 0.4 * (high - low)):
        slider.value = value
    J = kl.jacobian(arm, view._values)
    for i in range(arm.n):
        (column,) = view.readings[f"J{i + 1}"]
        close(column, J[:len(column), i], atol=1e-9 * np.abs(J).max())


@settings(max_examples=20)
@given(st.floats(-3, 3), st.floats(-3, 3))
def test_manipulability_of_two_links(one, two):
    view = kl.velocity_view(kl.robots.two_link(), [one, two])
    close(view.readings["w"][0], abs(np.sin(two)), atol=1e-6)


def frames_at(view, step):
    """Joint-driven frames of both arms: what the picture holds at a step."""
    view["step"].value = step
    return view._scene.frames([step])


@course
def test_the_arms_stand_at_the_steps_of_their_solves(robot):
    arm = robot()
    q0 = np.array(arm.home) + 0.05
    target = kl.forward_kinematics(arm, np.array(arm.home) - 0.02)[:3, 3]
    methods = ("pseudoinverse", "damped")
    view = kl.solve_view(arm, target, q0, methods=methods, limits="ignore")
    weights = (1, 1, 0) if len(view._scene.presets) == 1 else None
    trails = [kl.inverse_kinematics(arm, target, q0, method=method, weights=weights, steps=20,
                                    restarts=0, limits="ignore").history for method in methods]
    count, reach = len(kl.views.arm_view.arm_scene(arm).motions), typical_length(arm)
    for step in range(max(map(len, trails))):
        frames = frames_at(view, step)
        for k, trail in enumerate(trails):
            tool = frames[(k + 1) * (count + 1)][:3, 3]
            root = frames[k * (count + 1) + 1][:3, 3]
            q = trail[min(step, len(trail) - 1)].q
            close(tool - root, kl.forward_kinematics(arm, q)[:3, 3], atol=1e-9 * 1000)
            missed = np.linalg.norm((tool - root - target)[:2 if weights else 3])
            error = view.readings[methods[k]][0]
            assert float(error) == pytest.approx(missed, rel=5e-3, abs=1e-9 * reach)


def test_a_singular_start_shows_as_such():
    """theta2 = 0: Newton's Jacobian cannot be inverted, so it has no first step to show."""
    view = kl.solve_view(kl.robots.two_link(), [0.5, 1, 0], q0=[0, 0])
    assert len(set(view._scene.chart.curves[0].values)) == 1
    view["step"].value = view["step"].max
    assert float(view.readings["damped"][0]) < 1e-5


def test_the_chart_holds_the_errors_in_the_unit_of_the_arm():
    """What the tool misses at each step, by forward kinematics."""
    arm, target = kl.robots.two_link(), np.array([0.5, 1, 0])
    view = kl.solve_view(arm, target, q0=[0.2, 0.4])
    chart = view._scene.chart
    assert (chart.across, chart.up) == ("step", "error (m)")
    for curve in chart.curves:
        trail = kl.inverse_kinematics(arm, target, [0.2, 0.4], weights=(1, 1, 0), restarts=0,
                                      method=curve.name).history
        missed = [np.linalg.norm(kl.forward_kinematics(arm, step.q)[:3, 3] - target)
                  for step in trail]
        close(curve.values, missed, rtol=1e-6, atol=1e-12)
    assert "newton: error 1.33 m\n" in repr(view)


def test_the_way_is_drawn_as_far_as_the_step():
    view = kl.solve_view(kl.robots.two_link(), [0.5, 1, 0], q0=[0.2, 0.4])
    scene = view._scene
    items = {item.gid: item for item in scene.items}
    for step in (0, 1, 2.5, 4):
        q, frames = [step], scene.frames([step])
        way = corners(items["damped-path"], scene.motions, frames, q)
        assert len(way) == 1 + np.ceil(step)
    assert not any(name.endswith("rest") for name in items)  # what comes is not given away


@course
def test_the_frame_holds_both_arms_at_every_step(robot):
    """No joint, no tool and no target leaves the points that stay in the picture."""
    arm = robot()
    target = kl.forward_kinematics(arm, np.array(arm.home) - 0.2)[:3, 3]
    view = kl.solve_view(arm, target, methods=("damped", "pseudoinverse"), limits="ignore")
    scene = view._scene
    held = np.array([point[1:] for point in scene.fit.points])
    low, high = held.min(axis=0), held.max(axis=0)
    drawn = [item for item in scene.items if item.part in ("joint", "target", "trace")]
    for step in range(int(view["step"].max) + 1):
        frames = scene.frames([step])
        for item in drawn:
            places = corners(item, scene.motions, frames, [step])
            assert np.all((places >= low - 0.01 * np.ptp(held)) &
                          (places <= high + 0.01 * np.ptp(held))), (item.gid, step)


@pytest.mark.parametrize("methods", ["newton", ("newton",), ("newton", "newton"), 3, ("a", "b")])
def test_methods_must_be_two_known_ones(methods):
    with pytest.raises(ValueError, match=r"^methods: expected"):
        kl.solve_view(kl.robots.two_link(), [1, 1, 0], methods=methods)


def test_a_pose_is_a_target_too():
    arm = kl.robots.intelledex_660t()
    target = kl.forward_kinematics(arm, [0.3, 0.4, -0.5, 0.6, 0.5, 0.3])
    view = kl.solve_view(arm, target, [0.1, 0.2, -0.3, 0.4, 0.3, 0.1])
    view["step"].value = view["step"].max
    assert re.search(r"newton: error \S+e-\d\d", repr(view))
