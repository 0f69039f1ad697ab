"""The Alpha II in the cloud of all that it reaches: dots, edge and limits are true of the arm."""
import json

import numpy as np
import pytest

import kinlab as kl
from kinlab.drawing.cloud import layers, unpacked
from kinlab.drawing.curves import corners, is_there
from kinlab.lessons.alpha_ii import level_view
from kinlab.lessons.workspace import reach_view

close = np.testing.assert_allclose
REACH, SHOULDER = 485.1, 215.0  # mm


@pytest.fixture(scope="module")
def view():
    return reach_view()


def items(view, part, slice):
    """Items of a part that are there at an angle of the slice, with their corners in the room."""
    q = [*view._values[:5], np.radians(slice)]
    scene, frames = view._scene, view._scene.frames(q)
    return {item.gid: corners(item, scene.motions, frames, q) for item in scene.items
            if item.part == part and is_there(item, q)}


def test_every_dot_is_reached(view):
    (item,) = (item for item in view._scene.items if item.part == "cloud")
    dots = unpacked(item.points[0], item.text, item.size[1])
    assert 1000 < len(dots) < 4000
    assert np.linalg.norm(dots - [0, 0, SHOULDER], axis=1).max() < REACH + 3
    some = dots[:: len(dots) // 60]
    missed = kl.inverse_kinematics_batch(kl.robots.alpha_ii(), some).position_error
    assert missed.max() < 2.7  # half the diagonal of the lattice


def test_the_dots_are_all_over_the_workspace(view):
    """None of 3000 other samples is farther than two cells from one of them."""
    (item,) = (item for item in view._scene.items if item.part == "cloud")
    dots = unpacked(item.points[0], item.text, item.size[1])
    for point in kl.workspace(kl.robots.alpha_ii(), 3000, seed=7).points:
        assert np.linalg.norm(dots - point, axis=1).min() < 120


@pytest.mark.parametrize("slice, there", [(0, {"front-section", "front-hole"}),
                                          (29, {"front-section", "front-hole"}),
                                          (31, {"right-section", "right-hole"}),
                                          (-31, {"left-section", "left-hole"}),
                                          (90, {"right-section", "right-hole"})])
def test_the_section_changes_where_joint_1_reaches_both_sides(view, slice, there):
    assert set(items(view, "region", slice)) == there


@pytest.mark.parametrize("slice", [0, -20, 29, 45, -70, 90])
def test_the_edge_is_reached_and_nothing_beyond_it(view, slice):
    """By the solver: places a little inside the line, and a little outside."""
    arm, across = kl.robots.alpha_ii(), np.radians(slice)
    line = next(corners for gid, corners in items(view, "region", slice).items()
                if gid.endswith("section"))
    flat = np.stack([line @ [np.cos(across), np.sin(across), 0], line[:, 2]], axis=-1)
    close(line @ [-np.sin(across), np.cos(across), 0], 0, atol=1e-9)
    ways = np.roll(flat, -1, axis=0) - np.roll(flat, 1, axis=0)
    inwards = np.stack([-ways[:, 1], ways[:, 0]], axis=-1)
    inwards /= np.linalg.norm(inwards, axis=1, keepdims=True)
    for aside, reached in ((6.0, True), (-6.0, False)):
        u, z = (flat + aside * inwards)[::9].T
        places = np.stack([u * np.cos(across), u * np.sin(across), z], axis=-1)
        assert np.all(kl.inverse_kinematics_batch(arm, places).success == reached), slice


def test_the_arm_and_its_slice_move(view):
    view["theta_1"].value = 30
    view["slice"].value = 30
    close(view.readings["p"][0], kl.forward_kinematics(
        kl.robots.alpha_ii(), np.radians([30, 0, 0, -90, 0]))[:3, 3], atol=1e-9)
    low, high = np.transpose([link.limits for link in kl.robots.alpha_ii().links])
    for pose in view._scene.poses:
        assert np.all((np.array(pose[:5]) >= low) & (np.array(pose[:5]) <= high))


def test_it_is_small(view):
    assert len(json.dumps(view.scene, ensure_ascii=False).encode()) < 50_000


def test_a_hand_turns_the_slice_by_its_rim(view):
    """Where the stretched arm rises by 45°; the rim is held by that knob alone."""
    (handle,) = (handle for handle in view._scene.handles if handle.name == "slice")
    assert [view._scene.knobs[knob].name for knob in handle.knobs] == ["slice"]
    tip = kl.forward_kinematics(kl.robots.alpha_ii(), np.radians([0, -45, 0, -90, 0]))[:3, 3]
    close(handle.point[1:], tip, atol=1e-9)


# ---- The level plane ----


@pytest.fixture(scope="module")
def level():
    return level_view()


@pytest.mark.parametrize("height", [0, 100, 215, 450, 650])
@pytest.mark.parametrize("name, side", [("forwards", 0), ("backwards", 180)])
def test_the_edge_at_a_height_is_reached_and_nothing_beyond_it(level, height, name, side):
    """By the solver, where joint 1 has one value only: within 30° of its middle."""
    level.height = height
    outline = level_corners(level, name)
    close(outline[:, 2], height, atol=1e-9)
    across = np.radians(side + np.array([-25, 0, 25]))
    radius = np.linalg.norm(outline[:, :2], axis=1).max()
    for aside, reached in ((-3.0, True), (3.0, False)):
        u = radius + aside
        places = np.stack([u * np.cos(across), u * np.sin(across), 0 * across + height], axis=-1)
        found = kl.inverse_kinematics_batch(kl.robots.alpha_ii(), places).success
        assert np.all(found == reached), (height, aside)


def level_corners(level, name):
    (item,) = (item for item in level._scene.items if item.gid == name)
    scene = level._scene
    return corners(item, scene.motions, scene.frames(level._values), level._values)


def test_the_two_ways_fill_what_joint_1_turns_through(level):
    level.height = 100
    for name, middle in (("forwards", 0), ("backwards", 180)):
        x, y, _ = level_corners(level, name).T
        far = np.hypot(x, y) > 100
        turned = (np.degrees(np.arctan2(y, x))[far] - middle + 180) % 360 - 180
        close([turned.min(), turned.max()], [-150, 150], atol=0.1)


def test_what_is_above_the_level_plane_is_cut_away(level):
    (item,) = (item for item in level._scene.items if item.part == "cloud")
    level.height = 300
    plane = level._scene.frames(level._values)[int(item.size[0])]
    dots = unpacked(item.points[0], item.text, item.size[1])
    kept = layers(dots, plane, np.array([0, 0, 1.0]), np.zeros(3), 1000.0)
    assert 0 < sum(map(len, kept)) < len(dots)
    assert max(layer[:, 2].max() for layer in kept if len(layer)) <= 300


def test_a_hand_slides_the_level_plane(level):
    (handle,) = (handle for handle in level._scene.handles if handle.name == "height")
    assert [level._scene.knobs[knob].name for knob in handle.knobs] == ["height"]
    level.height = 215
    x, y, z = level._scene.frames(level._values)[handle.point[0]][:3, 3]
    close([np.hypot(x, y), z], [485.1, 215], atol=0.2)
