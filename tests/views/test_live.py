"""The view from Python: sliders and joint values agree, limits hold, bad input leaves nothing."""
import json
import re
from html import unescape
from math import degrees, pi, radians

import ipywidgets
import numpy as np
import pytest
import textbook
from hypothesis import given, settings
from strategies import arms_and_q

import kinlab as kl
from kinlab.drawing import worker

close = np.testing.assert_allclose
few = settings(max_examples=10)
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
SWITCHED = ("frames", "labels", "axes", "trace", "ghost")
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)


def slide(limits=(0.1, 0.6)):
    return kl.Arm([kl.revolute(a=1, limits=(-1, 2)), kl.prismatic(limits=limits)], name="Slide")


@course
def test_a_view_starts_at_home(robot):
    arm = robot()
    view = kl.ArmView(arm)
    close(view.q, arm.home, atol=1e-12)
    close(view.T, kl.forward_kinematics(arm, arm.home), atol=1e-9)
    assert view.note == "" and len(view.joints) == arm.n


@few
@given(arms_and_q())
def test_joint_values_go_in_and_come_out(arm_and_q):
    arm, q = arm_and_q
    low, high = np.array([link.limits or ((-pi, pi) if link.kind == "revolute" else (0, np.inf))
                          for link in arm.joints]).T
    view = kl.ArmView(arm)
    view.q = q
    reach = [slider.max for slider in view.joints]
    high = np.where(np.isinf(high), reach, high)
    close(view.q, np.clip(q, low, high), atol=1e-9)
    close(view.T, textbook.frames(arm, view.q)[-1], atol=1e-9)
    values = [slider.value for slider in view.joints]
    units = [degrees(1) if link.kind == "revolute" else 1 for link in arm.joints]
    close(values, view.q * units, atol=1e-9)


def test_sliders_are_in_degrees_and_in_the_arms_unit():
    view = kl.ArmView(slide())
    view.joints[0].value, view.joints[1].value = 45, 0.25
    close(view.q, [pi / 4, 0.25])
    close(view.T, kl.forward_kinematics(slide(), [pi / 4, 0.25]), atol=1e-12)
    view.q = [radians(-30), 0.5]
    close([slider.value for slider in view.joints], [-30, 0.5])
    assert [s.description for s in view.joints] == ["θ₁ (°)", "d₂ (m)"]


def test_sliders_end_at_the_limits_and_move_in_round_steps():
    arm = kl.Arm([kl.revolute(limits=(-radians(120), 1)), kl.revolute(), kl.prismatic(a=2),
                  kl.prismatic(limits=(-200, 300))])
    view = kl.ArmView(arm)
    ends = [(s.min, s.max) for s in view.joints]
    close(ends, [(-120, degrees(1)), (-180, 180), (0, 2), (-200, 300)], atol=1e-8)
    assert view.joints[0].min == -120  # not -119.99999999999999
    assert [joint["step"] for joint in view.scene["knobs"]] == [1, 1, 0.1, 10]
    low_high = [(joint["low"], joint["high"]) for joint in view.scene["knobs"]]
    close(low_high, [(-radians(120), 1), (-pi, pi), (0, 2), (-200, 300)])


@course
def test_any_value_stays_what_it_was(robot):
    arm = robot()
    view, rng = kl.ArmView(arm), np.random.default_rng(1)
    for _ in range(5):
        q = [rng.uniform(*np.multiply([s.min, s.max], scale)) for s, scale in zip(
            view.joints, [radians(1) if k.kind == "revolute" else 1 for k in arm.links])]
        view.q = q
        close(view.q, q, atol=1e-12)
        assert view.note == ""


def test_beyond_a_limit_a_joint_stops_and_the_view_says_so():
    view = kl.ArmView(slide())
    view.q = [3, 0.2]
    close(view.q, [2, 0.2])
    assert view.note == "θ₁ stops at its limit, 114.592°"
    view.q = [-3, 7]
    close(view.q, [-1, 0.6])
    assert view.note == "θ₁ stops at its limit, -57.2958°; d₂ stops at its limit, 0.6 m"
    view.q = [0, 0.3]
    assert view.note == ""
    view.q = [0, 7]
    view.joints[0].value = 400
    close(view.q, [2, 0.6])
    assert view.note == ""  # it told of another pose


def test_a_view_can_start_beyond_its_limits():
    view = kl.ArmView(slide(), q=[9, 0.3])
    close(view.q, [2, 0.3])
    assert view.note.startswith("θ₁ stops")
    at_the_limit = kl.ArmView(slide(), q=[2, 0.6])
    assert at_the_limit.note == ""


def test_a_home_beyond_the_limits_is_brought_within():
    arm = kl.Arm([kl.revolute(limits=(1, 2)), kl.prismatic(limits=(0.5, 1))])
    view = kl.ArmView(arm)
    close(view.q, [1, 0.5])
    data = view.scene
    close(data["home"], [1, 0.5])
    close(data["zero"], [1, 0.5])
    assert np.all(np.array(data["poses"]) >= [1, 0.5])


def test_a_view_reads_as_one_line():
    assert repr(kl.ArmView(kl.robots.alpha_ii())) == (
        "ArmView('Alpha II', q=[0, 0, 0, -90, 0] deg, p=[485.1, 0, 215] mm)")
    assert repr(kl.ArmView(slide(), q=[pi / 2, 0.25])) == (
        "ArmView('Slide', q=[90 deg, 0.25 m], p=[0, 1, 0.25] m)")
    assert repr(kl.ArmView(kl.Arm([kl.revolute(a=2)]))) == "ArmView(q=[0] deg, p=[2, 0, 0] m)"


def test_where_no_widget_runs_there_is_a_text_and_a_picture():
    view = kl.ArmView(kl.robots.two_link(), q=[0, pi / 2])
    bundle, metadata = view._repr_mimebundle_()
    assert bundle["text/plain"] == repr(view)
    assert bundle["image/png"] == worker.png(view._scene, view._values, view._scene.seen_from,
                                             view._scene.shown, "Run this cell to move the arm")
    assert bundle["application/vnd.jupyter.widget-view+json"]["model_id"] == view.model_id
    assert metadata["image/png"]["alt"] == f"Picture of the arm. {view!r}"
    view.q = [0, 0]
    moved, _ = view._repr_mimebundle_()
    assert moved["image/png"] != bundle["image/png"] and "1, 1, 0" not in moved["text/plain"]


def test_the_closed_form_stands_beside_the_arm_when_asked():
    def formulas(view):
        return [unescape(view.formula)] if view.formula else []

    assert formulas(kl.ArmView(kl.robots.alpha_ii())) == []
    (formula,) = formulas(kl.ArmView(kl.robots.alpha_ii(), closed_form=True))
    assert kl.closed_form(kl.robots.alpha_ii()).latex in formula


def test_play_goes_through_the_poses_given():
    data = kl.ArmView(slide(), poses=[[0, 0.2], [5, 0.4], [1, 0.6]]).scene
    close(data["poses"], [[0, 0.2], [2, 0.4], [1, 0.6]])


@course
def test_play_shows_each_joint_in_turn_unless_told(robot):
    arm = robot()
    data = kl.ArmView(arm).scene
    poses = np.array(data["poses"])
    assert len(poses) == 2 * arm.n
    for i, (home, out) in enumerate(zip(poses[::2], poses[1::2])):
        close(home, arm.home)
        assert np.flatnonzero(np.abs(out - home)).tolist() == [i]
        low, high = data["knobs"][i]["low"], data["knobs"][i]["high"]
        assert low <= out[i] <= high and abs(out - home).max() > 0.1 * (high - low)


def test_what_is_shown_and_from_where():
    def layers(view):
        return [layer["layer"] for layer in view.scene["layers"] if layer["on"]]

    plain = kl.ArmView(kl.robots.alpha_ii())
    assert layers(plain) == ["frames", "labels", "names", "floor"]
    assert plain.scene["preset"] == "3-D"
    assert kl.ArmView(kl.robots.two_link()).scene["preset"] == "top"
    view = kl.ArmView(kl.robots.two_link(), show=["ghost", "trace"], preset="side")
    assert layers(view) == ["floor", "trace", "ghost"] and view.scene["preset"] == "side"
    assert layers(kl.ArmView(kl.robots.two_link(), show=())) == ["floor"]
    assert layers(kl.ArmView(kl.robots.two_link(), show="ghost")) == ["floor", "ghost"]


def test_all_layers_are_in_the_picture_that_moves_whatever_is_shown():
    def items(show):
        view = kl.ArmView(kl.robots.two_link(), show=show)
        data = re.search(r"<script[^>]*>(.*?)</script>", view.html(), re.DOTALL)
        return json.loads(unescape(data[1]))["scene"]["items"]

    bare = items(())
    names = [item["gid"] for item in bare]
    assert len(names) == len(set(names)) and bare == items(SWITCHED)
    assert {item["layer"] for item in bare if "layer" in item} >= set(SWITCHED)


def test_the_table_names_the_tool_and_rounds_sensibly():
    pose = {robot.__name__: kl.ArmView(robot()).scene["pose"] for robot in COURSE}
    assert pose["alpha_ii"]["title"].startswith("T₀₅")
    assert pose["two_link"]["title"].startswith("T₀ₑ")
    assert (pose["alpha_ii"]["unit"], pose["alpha_ii"]["decimals"]) == ("mm", 1)
    assert (pose["two_link"]["unit"], pose["two_link"]["decimals"]) == ("m", 3)
    tiny = kl.ArmView(kl.Arm([kl.revolute(a=1e-5), kl.revolute(a=1e-5)])).scene["pose"]
    assert tiny["decimals"] == 8


BAD = {
    "not an arm": (lambda: kl.ArmView("Alpha II"), "arm: expected a kinlab Arm"),
    "no arm but q": (lambda: kl.ArmView(None, q=[1]), "arm: expected a kinlab Arm"),
    "q too short": (lambda: kl.ArmView(slide(), q=[1]), r"q: expected shape .* got \(1,\)"),
    "q a batch": (lambda: kl.ArmView(slide(), q=[[1, 1]]), "q: expected one pose"),
    "q not finite": (lambda: kl.ArmView(slide(), q=[1, np.nan]), "q: expected finite"),
    "q words": (lambda: kl.ArmView(slide(), q=["a", "b"]), "q: expected 2 joint values"),
    "preset": (lambda: kl.ArmView(slide(), preset="left"), "preset: expected '3-D' or 'top'"),
    "preset number": (lambda: kl.ArmView(slide(), preset=3), "preset: expected '3-D'"),
    "show": (lambda: kl.ArmView(slide(), show=["frame"]), "show: expected 'frames' or"),
    "show nothing": (lambda: kl.ArmView(slide(), show=None), "show: expected"),
    "show a number": (lambda: kl.ArmView(slide(), show=3), "show: expected"),
    "poses empty": (lambda: kl.ArmView(slide(), poses=np.zeros((0, 2))), "poses: expected shape"),
    "poses flat": (lambda: kl.ArmView(slide(), poses=[0, 0.2]), "poses: expected shape"),
    "poses short": (lambda: kl.ArmView(slide(), poses=[[1], [2]]), "poses: expected shape"),
    "poses wild": (lambda: kl.ArmView(slide(), poses=[[np.inf, 0]]), "poses: expected finite"),
}


@pytest.mark.parametrize("make, message", BAD.values(), ids=BAD)
def test_bad_input_makes_one_clear_sentence_and_no_widget(make, message):
    alive = set(ipywidgets.widgets.widget._instances)
    with pytest.raises(ValueError, match=message) as error:
        make()
    assert "\n" not in str(error.value) and len(str(error.value)) < 250
    assert set(ipywidgets.widgets.widget._instances) == alive


@pytest.mark.parametrize("q", [[1], [[0, 0.2]], [0, np.inf], ["x", "y"], None, 0.5,
                               [0, 0.2, 0.3]])
def test_wrong_joint_values_leave_the_arm_where_it_is(q):
    view = kl.ArmView(slide(), q=[0.5, 0.4])
    with pytest.raises(ValueError, match=r"^q: expected"):
        view.q = q
    close(view.q, [0.5, 0.4])
    assert view.note == ""


def test_two_views_do_not_move_each_other():
    arm = kl.robots.alpha_ii()
    one, other = kl.ArmView(arm), kl.ArmView(arm)
    one.q = np.full(5, 0.5)
    one.joints[0].value = 12
    close(other.q, arm.home)
    assert one.model_id != other.model_id
    one.q[0] = 99  # a copy: changing it moves nothing
    close(one.q[0], radians(12))


@pytest.mark.parametrize("size, words", [
    (1e-7, "ArmView(q=[30 deg, 5.88e-08 m], p=[8.66e-08, 5e-08, 5.88e-08] m)"),
    (1e-5, "ArmView(q=[30 deg, 5.88e-06 m], p=[8.66e-06, 5e-06, 5.88e-06] m)"),
    (4e-3, "ArmView(q=[30 deg, 0.002353 m], p=[0.003464, 0.002, 0.002353] m)"),
    (1, "ArmView(q=[30 deg, 0.5882 m], p=[0.866, 0.5, 0.5882] m)"),
    (1e5, "ArmView(q=[30 deg, 58823.529 m], p=[86602.54, 50000, 58823.529] m)")])
def test_a_pose_has_digits_that_fit_the_arm(size, words):
    """86.6 % of the arm's size is told, whatever that is; metres have four decimals."""
    arm = kl.Arm([kl.revolute(a=size), kl.prismatic(limits=(0, size))])
    view = kl.ArmView(arm, [np.pi / 6, size / 1.7])
    assert repr(view) == words
    assert view.scene["pose"]["decimals"] <= view.decimals
    assert repr(view.joints[1]).startswith(f"d₂ (m): {words.split('deg, ')[1].split(' m')[0]}, ")
    assert repr(view.joints[1]).endswith(f"from 0 to {size:g}")


def test_a_small_target_and_a_small_reading_have_digits():
    arm = kl.Arm([kl.revolute(a=1e-5), kl.revolute(a=1e-5)])
    assert repr(kl.TargetView(arm, [0, np.pi / 2])) == (
        "TargetView(q=[0, 90] deg, target=[1e-05, 1e-05, 0] m, error=0 m)")
    assert "J₁ = (0, 2e-05) m/rad" in repr(kl.velocity_view(arm, [0, 0]))


def test_a_remark_on_rounded_angles_stands_under_the_closed_form():
    arm = kl.Arm([kl.revolute(a=1, alpha=1.5708)])
    formula = kl.ArmView(arm, closed_form=True).formula
    assert formula.endswith("</math><p>alpha1 = 1.5708 looks rounded: it is taken as pi/2.</p>")


@pytest.mark.parametrize("name", ["{raw}", "{0}", "{", "}{", "{} and {}", "%s"])
def test_braces_in_a_name_are_letters_in_a_formula(name):
    arm = kl.Arm([kl.revolute(a=1, name=name), kl.revolute(a=1)], unit=name)
    for view in (kl.link_view(arm, 1), kl.velocity_view(arm)):
        for line in view._scene.data()["readings"]:
            assert len(line["words"]) == len(line["parts"]) + 1
        assert name in repr(view)
