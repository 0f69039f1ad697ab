"""The DH lesson's views: what is drawn measures the table, and the motions end at A_i."""
from functools import cache, reduce
from math import degrees, pi

import numpy as np
import pytest
import textbook

import kinlab as kl
from kinlab.arms.joints import joint_range
from kinlab.drawing.curves import is_there
from kinlab.drawing.still import still
from kinlab.lessons.dh_recipe import numbers_view, parameters_view, rules_view

close = np.testing.assert_allclose
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
ARMS = [convert(robot()) for robot in COURSE for convert in (kl.to_standard, kl.to_modified)]
LINKS = [(arm, link) for arm in ARMS for link in range(1, arm.n + 1)]
every_link = pytest.mark.parametrize(
    "arm, link", LINKS, ids=[f"{arm.name}-{arm.convention}-{link}" for arm, link in LINKS])
ORDERS = {"standard": ("theta", "d", "a", "alpha"), "modified": ("alpha", "a", "theta", "d")}
shown = cache(parameters_view)  # of one arm and link, to be looked at in several tests
AXES = {"theta": 2, "d": 2, "a": 0, "alpha": 0}


def poses(arm, count=4):
    low, high = np.array([joint_range(arm, i) for i in range(arm.n)]).T
    return low + np.random.default_rng(arm.n).random((count, arm.n)) * (high - low)


def row(arm, link, q):
    """The parameters of a link at joint values q, as its table says."""
    values = {name: getattr(arm.links[link - 1], name) for name in AXES}
    values[arm.links[link - 1].variable] += q[link - 1]
    return values


def turn_by(about, angle):
    return textbook.rigid(textbook.turn(about, angle))


def done(arm, link, q, share=4.0):
    """The product of the four elementary matrices, as far as `share` of the motions are done."""
    T, unit = [np.eye(4)], np.eye(3)
    for k, name in enumerate(ORDERS[arm.convention]):
        part = row(arm, link, q)[name] * min(1, max(0, share - k))
        axis = unit[AXES[name]]
        T.append(turn_by(axis, part) if name in ("theta", "alpha")
                 else textbook.rigid(o=part * axis))
    return reduce(np.matmul, T)


def drawn(view, q):
    """Frames of the view's scene at q, and every item's points in the room, by gid."""
    frames = view._scene.frames(q)
    return frames, {item.gid: np.array([(frames[k] @ (*p, 1))[:3] for k, *p in item.points])
                    for item in view._scene.items}


@every_link
def test_arcs_and_dimension_lines_measure_the_table(arm, link):
    view = shown(arm, link)
    for q in poses(arm):
        _, places = drawn(view, q)
        T = kl.link_frames(arm, q)[link - 1]
        for k, name in enumerate(ORDERS[arm.convention]):
            axis, value = (T @ done(arm, link, q, k))[:3, AXES[name]], row(arm, link, q)[name]
            constant = name != arm.links[link - 1].variable
            assert (f"arc-{k}" in places or f"dimension-{k}" in places) != (constant and not value)
            if f"arc-{k}" in places:
                assert_arc(places[f"arc-{k}"], (T @ done(arm, link, q, k))[:3], name, value)
            if f"dimension-{k}" in places:
                tail, head = places[f"dimension-{k}"]
                close(head - tail, value * axis, atol=1e-9)


def assert_arc(points, frame, name, angle):
    """A circular arc about the frame's axis, from its other axis, through the angle."""
    local = (points - frame[:, 3]) @ frame[:, :3]
    u, v = (0, 1) if name == "theta" else (2, 1)  # x towards y about z; z towards -y about x
    sign = 1 if name == "theta" else -1
    radius = np.linalg.norm(local, axis=1)
    close(radius, radius[0], rtol=1e-9)
    marks = np.linspace(0, angle, len(points))
    close(local[:, u] / radius[0], np.cos(marks), atol=1e-9)
    close(sign * local[:, v] / radius[0], np.sin(marks), atol=1e-9)


@every_link
def test_readings_say_the_table(arm, link):
    q = poses(arm, 1)[0]
    view = parameters_view(arm, link, q)
    for name, value in row(arm, link, q).items():
        scale = degrees(1) if name in ("theta", "alpha") else 1
        close(view.readings[name][0], value * scale, atol=1e-9)


@every_link
def test_frames_and_table_are_those_of_the_link(arm, link):
    view = shown(arm, link)
    for q in poses(arm):
        frames, places = drawn(view, q)
        for i in (link - 1, link):
            T = kl.link_frames(arm, q)[i]
            tails, heads = zip(*(places[f"frame-{i}-{letter}"] for letter in "xyz"))
            close(tails, [T[:3, 3]] * 3, atol=1e-9)
            length = np.linalg.norm(heads[0] - tails[0])
            close((np.array(heads) - tails) / length, T[:3, :3].T, atol=1e-9)
        pose = view.scene["pose"]
        T = kl.inverse(frames[pose["base"]]) @ frames[view._scene.tip]
        close(T, done(arm, link, q), atol=1e-9)


@every_link
def test_a_view_is_about_its_link(arm, link):
    """Both frames lie well inside the picture, at any pose; other links step back."""
    view = shown(arm, link)
    scene = view._scene
    for q in poses(arm, 3):
        marks = {part.gid: part.marks for part in still(scene, q)}
        for gid in (f"frame-{i}-{letter}" for i in (link - 1, link) for letter in "xyz"):
            (arrow,) = marks[gid][0].lines
            assert np.all((arrow > 0) & (arrow < scene.size)), gid
    assert all(item.style.endswith("-far") == (item.link != link)
               for item in scene.items if item.part in ("link", "joint", "gripper", "base"))
    close(view._values, np.clip(arm.home, *np.array([joint_range(arm, i) for i in range(arm.n)]).T),
          atol=1e-12)


def test_rules_say_how_a_parameter_is_measured():
    arm = kl.robots.alpha_ii()
    assert "d₁ = 215 mm, from x₀ to x₁ along z₀" in repr(parameters_view(arm, 1))
    assert "θ₂* = 0°, from x₁ to x₂ about z₁" in repr(parameters_view(arm, 2))
    text = repr(parameters_view(kl.to_modified(arm), 2))
    assert "α₁ = -90°, from z₁ to z₂ about x₁" in text
    assert "θ₂* = 0°, from x₁ to x₂ about z₂" in text
    assert "θ₂ = θ₂* + 90° = 90°" in repr(parameters_view(kl.robots.exam_2018(), 2))


@pytest.mark.parametrize("arm, link, q, words", [
    (kl.robots.alpha_ii(), 0, None, "link: expected a whole number from 1 to 5, got 0"),
    (kl.robots.alpha_ii(), 6, None, "got 6"), (kl.robots.alpha_ii(), 2.0, None, "got 2.0"),
    (kl.robots.alpha_ii(), "2", None, "got '2'"), (np.eye(4), 1, None, "arm: expected a kinlab"),
    (kl.robots.alpha_ii(), 2, [0, 0], "q: expected"),
], ids=["zero", "beyond", "float", "text", "no arm", "short q"])
def test_bad_input_is_refused(arm, link, q, words):
    with pytest.raises(ValueError, match=words):
        parameters_view(arm, link, q)


@pytest.mark.parametrize("tilt, miss", [(0, 0), (25, 1), (-40, 0), (0, -0.7), (50, 1.5)])
def test_the_rules_are_read_from_the_matrix(tilt, miss):
    view = rules_view()
    view["tilt"].value, view["miss"].value = tilt, miss
    T = view._scene.frames(view._values)[view._scene.tip]
    x, o, z = T[:3, 0], T[:3, 3], np.array([0, 0, 1])
    close(view.readings["rule 1"][0], T[2, 0], atol=1e-12)
    normal = np.cross(z, x)
    close(view.readings["rule 2"][0], o @ normal / np.linalg.norm(normal), atol=1e-12)
    close(T[2, 0], -np.sin(np.radians(tilt)), atol=1e-12)


@pytest.mark.parametrize("theta, d, a, alpha", [(40, 0.6, 0.9, 30), (-120, -0.4, 1, 90),
                                                (0, 0, -0.7, -150)])
def test_the_four_numbers_are_drawn_and_end_in_the_link_matrix(theta, d, a, alpha):
    view = numbers_view()
    for name, value in dict(theta=theta, d=d, a=a, alpha=alpha).items():
        view[name].value = value
    frames, places = drawn(view, view._values)
    T = textbook.standard(np.radians(theta), d, a, np.radians(alpha))
    close(frames[view._scene.tip], T, atol=1e-12)
    close(np.diff(places["d"], axis=0), [[0, 0, d]], atol=1e-12)
    close(np.diff(places["a"], axis=0), [a * T[:3, 0]], atol=1e-12)
    start, end = places["arc-alpha"][[0, -1]] - T[:3, 3]
    close(start, [0, 0, np.linalg.norm(start)], atol=1e-12)
    close(end, np.linalg.norm(start) * T[:3, 2], atol=1e-12)


@pytest.mark.parametrize("tilt, miss, kept, broken", [
    (0, 0, {"square-kept", "meeting"}, set()), (25, 0, {"meeting"}, {"square-broken", "tilt"}),
    (0, -0.5, {"square-kept"}, {"gap"}), (-40, 1.5, set(), {"square-broken", "tilt", "gap"})])
def test_a_mark_is_green_while_its_rule_is_kept(tilt, miss, kept, broken):
    view = rules_view()
    view["tilt"].value, view["miss"].value = tilt, miss
    there = {item.gid: item.style for item in view._scene.items if is_there(item, view._values)}
    assert {gid for gid, style in there.items() if style == "holds"} - {
        gid for gid in there if gid.startswith("words")} == kept
    assert broken <= set(there)
    assert not {"square-broken", "tilt", "gap"} - broken & set(there)


@pytest.mark.parametrize("tilt, miss", [(25, 1), (-40, -0.7)])
def test_tilt_and_miss_are_drawn_as_large_as_they_are(tilt, miss):
    view = rules_view()
    view["tilt"].value, view["miss"].value = tilt, miss
    frames, places = drawn(view, view._values)
    tail, head = places["gap"]
    x = frames[view._scene.tip][:3, 0]
    close(np.linalg.norm(head - tail), abs(miss), atol=1e-12)
    close((head - tail) @ np.array([[0, 0, 1], x]).T, 0, atol=1e-12)  # the shortest way
    arc = places["tilt"] - head
    ends = arc[[0, -1]] / np.linalg.norm(arc[0])
    close(ends, [[*x[:2] / np.linalg.norm(x[:2]), 0], x], atol=1e-12)
    words = {mark.text for part in still(view._scene, view._values) for mark in part.marks}
    assert {text.replace("-", "−") for text in (f"tilt = {tilt:.1f}°",
                                                f"miss = {miss:.1f}")} <= words


def transform(k):
    """The six transforms of exercise 1."""
    x, y, z = np.eye(3)
    slide = textbook.rigid
    return [turn_by(z, pi / 6) @ slide(o=2 * z) @ slide(o=x) @ turn_by(x, -pi / 2),
            turn_by(y, pi / 2), slide(o=y), slide(o=y) @ turn_by(z, pi / 2),
            turn_by(x, pi / 2) @ slide(o=z), turn_by(y, pi / 9) @ slide(o=y)][k - 1]


def test_which_transforms_keep_the_rules_is_true_of_them():
    keep = {"rule 1": set(), "rule 2": set()}
    for k in range(1, 7):
        x, o = transform(k)[:3, 0], transform(k)[:3, 3]
        if abs(x[2]) < 1e-12:
            keep["rule 1"].add(k)
        if abs(o @ np.cross([0, 0, 1], x)) < 1e-12:  # the lines meet; never parallel here but in 2
            keep["rule 2"].add(k)
    links = keep["rule 1"] & keep["rule 2"]
    assert kl.exercises.check("dh_recipe.1", [keep["rule 1"], keep["rule 2"], links]).ok
