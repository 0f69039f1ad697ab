"""matplotlib's hand: SVG that the browser can move, and a picture that stands still."""
import os
import subprocess
import sys
import xml.etree.ElementTree as ET

import matplotlib
import numpy as np
import pytest
import textbook
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import arms_and_q

import kinlab as kl
from kinlab.drawing import figure
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.controls import LAYERS
from kinlab.drawing.scene import SPATIAL

close = np.testing.assert_allclose
few = settings(max_examples=15)
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)
presets = pytest.mark.parametrize("preset", SPATIAL)
SVG = "{http://www.w3.org/2000/svg}"
DIGEST = """if True:
    import hashlib, kinlab as kl
    from kinlab.drawing import figure
    from kinlab.drawing.arm_scene import arm_scene
    arm = kl.robots.exam_2018()
    print(hashlib.sha256(figure.svg(figure.figure(arm_scene(arm), arm.home)).encode()).hexdigest())
"""


def drawn(arm, q=None, preset="3-D", show=LAYERS):
    scene = arm_scene(arm)
    q = arm.home if q is None else q
    return scene, figure.svg(figure.figure(scene, q, preset, show))


def groups(text):
    """Every group of the SVG by its id, in the order of painting."""
    return [(group.get("id"), group[0]) for group in ET.fromstring(text).iter(f"{SVG}g")
            if len(group) == 1 and group.get("id") != "figure_1"]


def rows(azimuth, elevation):
    """Towards the viewer, right and up, in the room: turn it by -azimuth, then tip it."""
    a, e = np.radians([azimuth, elevation])
    return textbook.turn((0, 1, 0), e) @ textbook.turn((0, 0, 1), -a)


def in_the_room(scene, q):
    frames = scene.frames(q)
    return {item.gid: np.array([frames[k][:3, :3] @ p + frames[k][:3, 3]
                                for k, *p in item.points]) for item in scene.items}


def numbers(path):
    words = path.get("d", "").replace("z", "").split()
    return np.array([float(word) for word in words if word not in "ML"]).reshape(-1, 2)


@course
def test_every_item_is_drawn_under_its_name_once(robot):
    scene, text = drawn(robot())
    names = [name for name, _ in groups(text)]
    for item in scene.items:
        assert names.count(item.gid) == 1 and text.count(f'id="{item.gid}"') == 1
    assert text.startswith("<svg") and text.rstrip().endswith("</svg>")
    shapes = {name: node.tag.removeprefix(SVG) for name, node in groups(text)}
    assert {i.gid: "text" if i.shape == "text" else "path" for i in scene.items} == {
        i.gid: shapes[i.gid] for i in scene.items}


@course
def test_the_svg_restyles_and_clips_nothing(robot):
    _, text = drawn(robot())
    assert "<style" not in text and "<?xml" not in text and "<!DOCTYPE" not in text
    assert "clip" not in text.lower() and "<use" not in text


@course
def test_names_of_axes_stay_text(robot):
    scene, text = drawn(robot())
    shown = {name: (node.text or "").strip() for name, node in groups(text)
             if node.tag == f"{SVG}text"}
    assert shown == {item.gid: item.text for item in scene.items if item.text}
    assert shown["label-0-x"] == "x₀"


def test_the_svg_is_the_same_from_run_to_run():
    scene, text = drawn(kl.robots.alpha_ii())
    assert figure.svg(figure.figure(scene, kl.robots.alpha_ii().home, show=LAYERS)) == text
    runs = {subprocess.run([sys.executable, "-c", DIGEST], check=True, capture_output=True,
                           env=os.environ | {"PYTHONHASHSEED": seed}).stdout for seed in "12"}
    assert len(runs) == 1


@few
@given(arms_and_q(most=4), st.sampled_from(list(SPATIAL)))
def test_points_stand_where_a_camera_sees_them(arm_and_q, preset):
    arm, q = arm_and_q
    scene, text = drawn(arm, q, preset)
    places, drawn_at = in_the_room(scene, q), dict(groups(text))
    _, right, up = rows(*SPATIAL[preset])
    width, height = scene.size
    for item in scene.items:
        away = places[item.gid] - np.array(scene.center)
        flat = np.stack([width / 2 + scene.scale * away @ right,
                         height / 2 - scene.scale * away @ up], axis=-1)
        node = drawn_at[item.gid]
        if item.shape == "text":
            close(float(node.get("x")), flat[0, 0], atol=1e-5)
            close(float(node.get("y")), flat[0, 1], atol=8)  # its middle, not its foot
        elif item.shape in ("line", "trace"):
            close(numbers(node), flat, atol=1e-5)
        elif item.shape == "arrow":
            close(numbers(node)[[0, 3]], flat, atol=1e-5)


@few
@given(arms_and_q(most=4), st.sampled_from(list(SPATIAL)))
def test_nearer_bodies_are_painted_later(arm_and_q, preset):
    arm, q = arm_and_q
    scene, text = drawn(arm, q, preset)
    places, viewer = in_the_room(scene, q), rows(*SPATIAL[preset])[0]
    order = {name: k for k, (name, _) in enumerate(groups(text))}
    nearness = {}
    for item in scene.items:
        if item.body >= 0:
            near = item.lift + (places[item.gid] @ viewer).mean()
            nearness.setdefault(item.body, []).append((order[item.gid], near))
    under = [order[item.gid] for item in scene.items if item.body < 0]
    assert under == sorted(under) and max(under) == len(under)
    bodies = sorted(nearness.values())
    means = [np.mean([near for _, near in body]) for body in bodies]
    assert np.all(np.diff(means) >= -1e-9 * scene.radius)
    for body in bodies:  # nothing of another body comes between
        places_in_line = [k for k, _ in body]
        assert places_in_line == list(range(places_in_line[0], places_in_line[0] + len(body)))


@course
@presets
def test_faces_turned_away_are_not_painted_but_keep_their_paint(robot, preset):
    arm = robot()
    scene, text = drawn(arm, preset=preset)
    places, viewer = in_the_room(scene, arm.home), rows(*SPATIAL[preset])[0]
    nodes, seen = dict(groups(text)), []
    for item in scene.items:
        if item.shape == "face":
            a, b, c = places[item.gid][:3]
            facing = np.cross(b - a, c - b) @ viewer / np.linalg.norm(np.cross(b - a, c - b))
            if abs(facing) > 1e-9:
                assert bool(nodes[item.gid].get("d")) == (facing > 0)
                seen.append(facing > 0)
            assert "fill: #" in nodes[item.gid].get("style")
            assert "stroke: #2b3138" in nodes[item.gid].get("style")
    assert preset != "3-D" or {True, False} == set(seen)


@few
@given(arms_and_q(most=3), st.sampled_from(list(SPATIAL)))
def test_a_solid_is_the_hull_of_its_points(arm_and_q, preset):
    arm, q = arm_and_q
    scene = arm_scene(arm)
    frames, view = scene.frames(q), figure.Camera(*SPATIAL[preset]).axes
    for item in scene.items:
        if item.shape == "hull":
            points = figure.project(scene, frames, view, item)
            hull = figure.outline(item.shape, points)
            sides = np.roll(hull, -1, axis=0) - hull
            away = points[:, None, :2] - hull
            turns = sides[:, 0] * away[..., 1] - sides[:, 1] * away[..., 0]
            assert np.all(turns >= -1e-6)
            assert all(np.abs(points[:, :2] - corner).sum(axis=1).min() == 0 for corner in hull)


@pytest.mark.parametrize("tip, head", [((100, 0), 9), ((10, 0), 5), ((0, -4), 2), ((0, 0), 0)])
def test_an_arrow_has_a_head_that_shrinks_with_it(tip, head):
    tail = np.array([3.0, 4.0, 0.0])
    path = figure.outline("arrow", np.array([tail, tail + [*tip, 0]]))
    close(path[0], tail[:2])
    close(path[3], tail[:2] + tip)
    close(path[-1], path[0])
    close(np.linalg.norm(path[3] - path[1]), head, atol=1e-12)
    close(np.linalg.norm(path[2] - path[4]), 0.72 * head, atol=1e-12)


def test_the_camera_is_a_right_handed_frame():
    for preset in SPATIAL.values():
        R = figure.Camera(*preset).axes
        close(R @ R.T, np.eye(3), atol=1e-12)
        close(np.cross(R[0], R[1]), R[2], atol=1e-12)


@pytest.mark.parametrize("show", [(), ("frames",), ("labels", "ghost"), ("axes", "trace")])
def test_hidden_layers_are_hidden_in_the_still_picture(show):
    scene, text = drawn(kl.robots.cylindrical(), show=show)
    visible = {name for name, _ in groups(text)}
    assert {item.gid for item in scene.items if item.gid in visible} == {
        item.gid for item in scene.items if not item.layer or item.layer in show}


def test_frames_and_names_are_shown_unless_told():
    arm = kl.robots.cylindrical()
    scene = arm_scene(arm)
    visible = {name for name, _ in groups(figure.svg(figure.figure(scene, arm.home)))}
    hidden = {item.layer for item in scene.items if item.gid not in visible}
    assert hidden == {"axes", "trace", "ghost"}


def test_the_still_picture_is_a_png_of_its_layers():
    arm = kl.robots.two_link()
    scene = arm_scene(arm)
    plain = figure.png(figure.figure(scene, arm.home, "top", ()))
    assert plain.startswith(b"\x89PNG\r\n\x1a\n")
    size = np.frombuffer(plain[16:24], ">u4")
    close(size, np.multiply(scene.size, 1.5), atol=1)
    assert figure.png(figure.figure(scene, arm.home, "top", ("frames",))) != plain


@pytest.mark.parametrize("setting", [{"svg.fonttype": "path"}, {"axes.facecolor": "red"}])
def test_the_users_settings_stay_and_do_not_spoil_the_svg(setting):
    expected = drawn(kl.robots.two_link())[1]
    with matplotlib.rc_context(setting):
        before = dict(matplotlib.rcParams)
        text = drawn(kl.robots.two_link())[1]
        figure.png(figure.figure(arm_scene(kl.robots.two_link()), [0, 0]))
        assert dict(matplotlib.rcParams) == before
    assert [name for name, _ in groups(text)] == [name for name, _ in groups(expected)]


def test_drawing_needs_no_pyplot():
    code = "import sys, kinlab.drawing.figure; print('matplotlib.pyplot' in sys.modules)"
    out = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert out.stdout.strip() == "False"
