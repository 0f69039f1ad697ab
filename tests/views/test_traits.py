"""Knobs as traits: named, in the slider's unit, within their limits, and one message for many."""
from math import degrees, pi, radians

import ipywidgets
import numpy as np
import pytest

import kinlab as kl
from kinlab.drawing.controls import Knob
from kinlab.drawing.sketch import Sketch
from kinlab.views.live import LiveView

close = np.testing.assert_allclose


def slide():
    return kl.Arm([kl.revolute(a=1, limits=(-1, 2), name="shoulder"),
                   kl.prismatic(limits=(0.1, 0.6))], name="Slide")


@pytest.fixture
def sent(monkeypatch):
    """Every state that goes to the browser."""
    states = []

    def note(widget, message, buffers=None):
        if message["method"] == "update":
            states.append(message["state"])

    monkeypatch.setattr(ipywidgets.Widget, "_send", note)
    return states


def test_each_joint_is_a_trait_in_the_sliders_unit():
    view = kl.ArmView(slide())
    view.theta_1, view.d_2 = 30, 0.25
    close(view.q, [radians(30), 0.25])
    close(view.T, kl.forward_kinematics(slide(), [radians(30), 0.25]), atol=1e-12)
    view.q = [radians(-45), 0.5]
    close([view.theta_1, view.d_2], [-45, 0.5])
    assert view.has_trait("theta_1") and view.trait_metadata("theta_1", "sync")
    assert {"theta_1", "d_2"} <= set(view.get_state())


def test_knobs_of_a_sketch_are_traits_too():
    view = kl.lessons.translation.sliding_view()
    view.o_x = -1.5
    assert view["o_x"].value == -1.5
    view["o_y"].value = 0.5
    assert view.o_y == 0.5
    close(view.q, [-1.5, 0.5])
    close(view.readings["c0"][0], [-1.5, 0.5])


def test_observers_of_a_joint_and_of_the_pose_find_both_set():
    view, heard = kl.ArmView(slide()), []
    view.observe(lambda change: heard.append((change.name, change.old, change.new, *view.q)),
                 "theta_1")
    view.observe(lambda change: heard.append((change.name, *change.new, view.theta_1)), "q")
    view.theta_1 = 30
    (pose, joint) = sorted(heard)
    assert (pose[0], joint[0]) == ("q", "theta_1")
    close(joint[1:], [0, 30, radians(30), 0.1])
    close(pose[1:], [radians(30), 0.1, 30])
    heard.clear()
    view.q = [radians(60), 0.4]
    assert sorted(name for name, *_ in heard) == ["q", "theta_1"]
    for name, *values in heard:
        close(values, [30, 60, radians(60), 0.4] if name == "theta_1" else [radians(60), 0.4, 60])
    heard.clear()
    view.q = [radians(60), 0.4]
    assert heard == []  # nothing moved


def test_a_knob_stops_at_its_limits_and_takes_numbers_only():
    view = kl.ArmView(slide())
    view.theta_1 = 500
    close(view.q[0], 2)
    close(view.theta_1, degrees(2))
    for wrong in ("30", None, np.nan, [1, 2], np.inf):
        with pytest.raises(ValueError, match=r"^theta_1: expected") as error:
            view.theta_1 = wrong
        assert "\n" not in str(error.value)
    close(view.q, [2, 0.1])
    with pytest.raises(ValueError, match="name: expected 'theta_1' or 'd_2', got 'theta_2'"):
        view["theta_2"]


def test_python_tells_the_browser_of_many_joints_in_one_message(sent):
    view = kl.ArmView(kl.robots.alpha_ii())
    sent.clear()
    view.q = [0.1, 0.2, 0.3, 0.4, 0.5]
    (state,) = sent
    assert set(state) == {f"theta_{k}" for k in range(1, 6)}
    close([state[f"theta_{k}"] for k in range(1, 6)], np.degrees([0.1, 0.2, 0.3, 0.4, 0.5]))
    sent.clear()
    view.q = [9, 0.2, 0.3, 0.4, 0.5]
    (state,) = sent
    assert set(state) == {"theta_1", "note"}


def test_a_target_and_its_arm_are_one_message(sent):
    view = kl.TargetView(kl.robots.two_link())
    sent.clear()
    view.target = (0, 1, 0)
    (state,) = sent
    assert set(state) == {"theta_1", "theta_2", "x", "y"}


def test_the_browsers_values_arrive_together_and_are_not_sent_back(sent):
    view, heard = kl.ArmView(kl.robots.alpha_ii()), []
    view.observe(lambda change: heard.append(change.new), "q")
    sent.clear()
    view.set_state({"theta_1": 10.0, "theta_3": -20.0})
    assert len(heard) == 1 and sent == []
    close(heard[0], np.radians([10, 0, -20, -90, 0]))
    view.set_state({"theta_1": 999.0})  # beyond the limit: the browser is told
    assert sent == [{"theta_1": 150.0}]


@pytest.mark.parametrize("make", [
    lambda: kl.ArmView(kl.robots.practical_six_link(), closed_form=True),
    lambda: kl.TargetView(kl.robots.alpha_ii()), kl.DHTableEditor,
    lambda: kl.velocity_view(kl.robots.two_link()), kl.lessons.workspace.limits_view],
    ids=["arm", "target", "editor", "velocity", "sketch"])
def test_a_view_is_two_models_and_leaves_none(make):
    """The view itself and its layout."""
    alive = ipywidgets.widgets.widget._instances
    before = set(alive)
    view = make()
    assert len(set(alive) - before) == 2
    view.close()
    assert set(alive) == before


def test_a_view_stands_beside_other_widgets():
    view = kl.ArmView(kl.robots.two_link())
    box = ipywidgets.VBox([view, ipywidgets.FloatSlider()])
    assert box.children[0] is view
    link = ipywidgets.jslink((box.children[1], "value"), (view, "theta_1"))
    assert link.target == (view, "theta_1")
    said = []
    ipywidgets.interactive_output(lambda **at: said.append(at), {"a": view["theta_1"]})
    view.theta_1 = 12
    assert said == [{"a": 30.0}, {"a": 12.0}]
    tied = ipywidgets.FloatSlider(min=-180, max=180)
    ipywidgets.link((view, "theta_2"), (tied, "value"))
    assert tied.value == 45
    tied.value = 90
    close(view.q, np.radians([12, 90]))


def test_an_arm_that_takes_another_place_brings_its_own_knobs():
    view = kl.ArmView(kl.robots.alpha_ii())
    view.follow(kl.robots.cylindrical())
    state = view.get_state()
    assert {"theta_1", "d_2", "d_3"} <= set(state)
    assert not {"theta_2", "theta_3", "theta_4", "theta_5"} & set(state)
    with pytest.raises(ValueError, match="expected 'theta_1' or 'd_2' or 'd_3'"):
        view.theta_5 = 3
    view.d_2 = 0.4
    close(view.q, [0, 0.4, 0.3])
    view.follow(kl.robots.alpha_ii())
    view.theta_5 = 90
    close(view.q[4], pi / 2)
    assert "theta_5" in view.get_state() and "d_2" not in view.get_state()


def test_home_is_where_a_view_began():
    """The arm's home, unless joint values were given; the same in every kind of view."""
    arm, q = kl.robots.two_link(), [0.3, 0.9]
    for make in (kl.ArmView, kl.velocity_view):
        close(make(arm).scene["home"], arm.home)
        close(make(arm, q).scene["home"], q)
    tip = kl.forward_kinematics(arm, q)[:2, 3]
    close(kl.TargetView(arm, q).scene["home"], [*q, *tip])
    close(kl.lessons.dh_recipe.parameters_view(arm, 2, q).scene["home"], q)
    view = kl.ArmView(arm, q)
    (ghost,) = (item for item in view.scene["items"] if item["gid"] == "ghost")
    close(ghost["points"][-1][1:], kl.forward_kinematics(arm, q)[:3, 3], atol=1e-12)


def test_who_observes_a_joint_may_set_another():
    """Joints that depend on each other: traits, q, T and the text say the same."""
    view = kl.ArmView(kl.robots.two_link(), q=[0, 0])
    view.observe(lambda change: setattr(view, "theta_2", 10), "q")
    view.theta_1 = 30
    assert view.theta_2 == 10
    close(view.q, np.radians([30, 10]))
    close(view.T, kl.forward_kinematics(view.arm, view.q))
    assert "q=[30, 10] deg" in repr(view)
    tied = kl.ArmView(kl.robots.two_link(), q=[0, 0])
    ipywidgets.dlink((tied, "theta_1"), (tied, "theta_2"))
    tied.q = [radians(25), 0]
    close(tied.q, np.radians([25, 25]))
    tied.set_state({"theta_1": 40.0})
    close(tied.q, np.radians([40, 40]))


def test_joint_values_set_by_an_observer_are_checked():
    view = kl.ArmView(kl.robots.two_link(), q=[0, 0])
    view.observe(lambda change: setattr(view, "q", "abc"), "theta_1")
    with pytest.raises(ValueError, match="q: expected 2 joint values"):
        view.theta_1 = 3
    close(view.q, np.radians([3, 0]))


def test_what_is_set_while_notifications_wait_is_not_lost():
    view = kl.ArmView(kl.robots.alpha_ii())
    with view.hold_trait_notifications():
        view.q = [0.2] * 5
        view.theta_1 = 5
    close(view.q, [radians(5), 0.2, 0.2, 0.2, 0.2])


def test_another_arm_in_the_same_pose_moves_nothing():
    heard = []
    editor = kl.DHTableEditor(kl.robots.alpha_ii())
    editor.theta_1 = 30
    editor.observe(lambda change: heard.append(change.name), ["theta_1", "q"])
    editor.set(1, "d", "100")
    assert heard == [] and editor.theta_1 == 30
    editor.follow(kl.robots.alpha_ii(), np.radians([60, 0, 0, 0, 0]))
    assert heard.count("theta_1") >= 1 and editor.theta_1 == 60


@pytest.mark.parametrize("name", ["q", "scene", "note", "keys", "comm", "close", "", "x y"])
def test_a_knob_has_a_name_that_the_view_does_not_have(name):
    sketch = Sketch("Bad")
    sketch.knob(Knob.length(name, "a", 0, 1))
    with pytest.raises(ValueError, match="name: a knob cannot be called"):
        LiveView(sketch.scene())


def test_a_target_is_followed_without_a_browser():
    view = kl.TargetView(kl.robots.two_link(), q=[0.3, 0.9])
    view.x, view.y = 0.5, 1.2
    close(kl.forward_kinematics(view.arm, view.q)[:2, 3], [0.5, 1.2], atol=1e-6)
    assert view.error < 1e-6
    view.theta_1 = 10
    close(view.target, view.T[:3, 3], atol=1e-12)  # the target rides on the tool
    far = kl.TargetView(kl.robots.alpha_ii())
    far.target = (9000, 0, 0)  # as far as the picture goes, and as near to that as the arm gets
    best = kl.inverse_kinematics(far.arm, far.target, far.arm.home, weights=[1, 1, 1])
    assert far.error <= np.linalg.norm(
        kl.forward_kinematics(far.arm, best.q)[:3, 3] - far.target) + 1e-3
