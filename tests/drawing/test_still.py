"""The picture as marks: framed, named, in its layers, finite from every side."""
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import arms

import kinlab as kl
from kinlab.arms.joints import joint_ranges
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.controls import LAYERS
from kinlab.drawing.labels import text_size
from kinlab.drawing.scene import AXIS, NAME, SOLIDS, SPATIAL
from kinlab.drawing.still import arrow, outline, still

close = np.testing.assert_allclose
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)
SIZES = [(390, 350), (580, 520), (1100, 800)]
sizes = pytest.mark.parametrize("size", SIZES, ids=lambda size: f"{size[0]}x{size[1]}")
TIPS, NAMES = 8.0, 0.0           # px by which arrows and names may leave the picture


def box(drawn, shapes):
    """Lowest and highest right and down of what is painted of some shapes."""
    points = []
    for part in drawn:
        if part.item and part.item.shape in shapes and not part.gid.endswith("-hint"):
            for mark in part.marks:
                spread = np.array(text_size(mark.text)) / 2 if mark.text else np.zeros(2)
                points += [line + way * spread for line in mark.lines for way in (-1, 1)]
    points = np.vstack(points)
    return points.min(axis=0), points.max(axis=0)


def from_side(scene, direction):
    return replace(scene, presets={**scene.presets, "here": direction}, preset=scene.seen_from)


@course
@sizes
def test_at_home_the_arm_fills_the_picture(robot, size):
    scene = arm_scene(robot())
    low, high = box(still(scene, robot().home, size=size), (*SOLIDS, AXIS, NAME))
    assert max((high - low) / size) > 0.65


@course
@sizes
def test_nothing_leaves_the_picture_at_any_pose_from_any_side(robot, size):
    arm, rng = robot(), np.random.default_rng(7)
    scene, (low, high) = arm_scene(arm), joint_ranges(arm)
    sides = [*SPATIAL.values(), (rng.uniform(-180, 180), rng.uniform(-90, 90))]
    for direction in [sides[k] for k in rng.permutation(5)[:3]]:
        q = np.where(rng.random(arm.n) < 0.3, high, rng.uniform(low, high))
        assert_inside(still(from_side(scene, direction), q, "here", size=size), size)


@settings(max_examples=20, deadline=None)
@given(arms(), st.floats(0, 1), st.tuples(st.floats(-180, 180), st.floats(-90, 90)),
       st.sampled_from(SIZES))
def test_no_arm_leaves_the_picture(arm, share, direction, size):
    low, high = joint_ranges(arm)
    scene = from_side(arm_scene(arm), direction)
    assert_inside(still(scene, low + share * (high - low), "here", size=size), size)


def assert_inside(drawn, size):
    for shapes, beyond in ((SOLIDS, 0.0), ([AXIS], TIPS), ([NAME], NAMES)):
        low, high = box(drawn, shapes)
        assert min(*low, *(np.array(size) - high)) >= -beyond - 1e-6, shapes


@course
def test_everything_is_painted_under_its_name(robot):
    arm = robot()
    scene = arm_scene(arm)
    drawn = {part.gid for part in still(scene, arm.home, show=LAYERS)}
    missing = {item.gid for item in scene.items} - drawn
    assert {gid.split("-")[0] for gid in missing} <= {"label", "axis", "name"}  # out of the picture
    assert {"ground", "shadow", "foot", "numbers", "coordinates"} <= drawn
    assert len([gid for gid in drawn if gid.startswith("dropline-")]) == 1


@pytest.mark.parametrize("show", [(), ("frames",), ("labels", "ghost"), ("axes", "trace"),
                                  ("floor", "frames")])
def test_layers_that_are_off_are_left_out(show):
    arm = kl.robots.cylindrical()
    scene = arm_scene(arm)
    drawn = still(scene, arm.home, show=show)
    layers = {part.item.layer for part in drawn if part.item}
    assert layers == {"", *show} - {"floor"}
    floor = {part.gid for part in drawn if part.item is None and any(
        len(line) for mark in part.marks for line in mark.lines)}
    assert bool(floor) == ("floor" in show)


def test_the_floor_lies_under_the_arm_and_words_over_all():
    arm = kl.robots.alpha_ii()
    order = [part.gid for part in still(arm_scene(arm), arm.home)]
    first = {name: min(k for k, gid in enumerate(order) if gid.startswith(name)) for name in
             ("ground", "shadow", "numbers", "link-", "frame-0-x-hint", "tool", "label-")}
    assert list(first) == sorted(first, key=first.get)


def test_a_face_is_painted_from_one_side_only():
    corners = np.array([[0, 0], [0, 4], [4, 0]], dtype=float)  # y points down
    assert len(outline("face", corners)) == 1 and outline("face", corners[::-1]) == []


@pytest.mark.parametrize("tip, head", [((100, 0), 9), ((10, 0), 5), ((0, -4), 2), ((0, 0), 0)])
def test_an_arrow_has_a_head_that_shrinks_with_it(tip, head):
    tail = np.array([3.0, 4.0])
    path = arrow(np.array([tail, tail + tip]))
    close(path[[0, 3, -1]], [tail, tail + tip, tail])
    close(np.linalg.norm(path[3] - path[1]), head, atol=1e-12)
    close(np.linalg.norm(path[2] - path[4]), 0.72 * head, atol=1e-12)


def test_a_bent_arrow_has_its_head_on_its_last_way():
    path = arrow(np.array([(0, 0), (50, 0), (50, 20)]))
    close(path, [(0, 0), (50, 0), (50, 11), (46.76, 11), (50, 20), (53.24, 11), (50, 11), (50, 0),
                 (0, 0)])


@pytest.mark.parametrize("degrees", [-170, -90, -5, 5, 90, 170])
def test_the_head_of_an_arc_says_which_way_it_turns(degrees):
    t = np.radians(degrees) * np.linspace(0, 1, 17)
    path = arrow(80 * np.stack([np.cos(t), np.sin(t)], axis=-1))
    one, tip, other = path[len(path) // 2 - 1:][:3]
    tangent = np.sign(degrees) * np.array([-np.sin(t[-1]), np.cos(t[-1])])
    assert (tip - (one + other) / 2) @ tangent > 0.99 * np.linalg.norm(tip - (one + other) / 2) > 0


def test_an_arrow_without_length_is_a_point():
    close(arrow(np.full((17, 2), 3.0)), 3.0)
