"""The camera and how it frames what has to be seen: by rays and by points of surfaces."""
from dataclasses import replace
from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import kinlab as kl
from kinlab.arms.joints import joint_ranges
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.camera import Camera, lens
from kinlab.drawing.scene import Fit, Scene

SIZES = [(300, 300), (320, 900), (580, 520), (900, 300), (1280, 720), (1900, 1000)]
sizes = st.sampled_from(SIZES) | st.tuples(st.integers(300, 1900), st.integers(300, 1000))
cameras = st.builds(Camera, st.floats(-180, 180), st.floats(-90, 90),
                    perspective=st.booleans())
places = st.tuples(*[st.floats(-1, 1)] * 3)
balls = st.lists(st.tuples(places, st.floats(0, 0.3)), max_size=8)
SCENE = Scene((), (), 0, (0.1, 0.2, 0.3), 1.75)
ROBOTS = ["two_link", "practical_six_link", "cylindrical", "exam_2018", "alpha_ii",
          "intelledex_660t"]


def directions(count=400):
    """Unit vectors all round, by the golden angle."""
    z = 1 - 2 * (np.arange(count) + 0.5) / count
    turn = pi * (3 - sqrt(5)) * np.arange(count)
    return np.stack([np.sqrt(1 - z**2) * np.cos(turn), np.sqrt(1 - z**2) * np.sin(turn), z], 1)


def surface(extents):
    """Points all over the balls, shape (n, 3)."""
    return np.concatenate([np.array(middle) + radius * directions() for middle, radius in extents])


def inside(made, points, size, margin):
    """Whether all points are seen with a margin (px)."""
    flat = made.see(points)[:, :2]
    return np.all(flat >= margin - 1e-6) and np.all(flat <= np.array(size) - margin + 1e-6)


def framed(arm):
    """The arm's scene, framed as solids would be, and what has to be seen at joint values."""
    scene = arm_scene(arm)
    origins = scene.frames(scene.begin)[:, :3, 3]
    middle = (origins.min(axis=0) + origins.max(axis=0)) / 2
    reach = max(np.linalg.norm(origins - middle, axis=1))
    thick = 0.08 * reach

    def extents(q):
        points = scene.frames(q)[:, :3, 3]
        foot = (*points[scene.tip][:2], -4 * thick)
        return [*((point, thick) for point in points), (foot, 0.0)]
    return replace(scene, fit=Fit(tuple(middle), reach + thick, thick)), extents


# ---- what the lens makes of points ----

def test_axes_of_named_sides():
    np.testing.assert_allclose(Camera(-90, 90).axes, np.eye(3), atol=1e-15)
    np.testing.assert_allclose(Camera(-90, 0).axes, [[1, 0, 0], [0, 0, 1], [0, -1, 0]], atol=1e-15)
    np.testing.assert_allclose(Camera(0, 0).axes, [[0, 1, 0], [0, 0, 1], [1, 0, 0]], atol=1e-15)


@given(st.floats(-360, 360), st.floats(-90, 90))
def test_the_viewer_stands_where_azimuth_and_elevation_say(azimuth, elevation):
    right, up, near = Camera(azimuth, elevation).axes
    a, e = radians(azimuth), radians(elevation)
    np.testing.assert_allclose(near, [cos(a) * cos(e), sin(a) * cos(e), sin(e)], atol=1e-12)
    np.testing.assert_allclose(np.cross(right, up), near, atol=1e-12)
    assert right[2] == 0 and up[2] >= -1e-15   # upright, whatever the side


@given(cameras, sizes, st.lists(places, min_size=1, max_size=5))
def test_many_points_are_seen_as_each_is(camera, size, points):
    made = lens(SCENE, camera, size)
    for way in (made.see, made.eye, made.turn):
        got = way(points)
        assert got.shape == (len(points), 3)
        for one, point in zip(got, points):
            np.testing.assert_allclose(one, way(point), atol=1e-9)


@given(cameras, places, st.floats(0.05, 0.9))
def test_a_ray_to_the_viewer_is_one_point_of_the_picture(camera, point, share):
    made = lens(SCENE, camera, (580, 520))
    along = point + share * made.eye(point)
    np.testing.assert_allclose(made.see(along)[:2], made.see(point)[:2], atol=1e-6)
    assert (made.see(along)[2] > made.see(point)[2]) == camera.perspective


def test_the_size_factor_is_what_a_ruler_seen_there_says():
    made = lens(SCENE, Camera(-60, 24, perspective=True), (580, 520))
    for point in directions(20):
        a, b = made.see([point, point + 0.01 * made.right])
        assert np.hypot(*(b - a)[:2]) == pytest.approx(0.01 * made.scale * a[2])


# ---- framing ----

@pytest.mark.parametrize("size, margin", [((580, 520), 10), ((300, 900), 10), ((30, 20), 5)])
@pytest.mark.parametrize("perspective", [False, True])
def test_without_a_fit_the_ball_round_the_scene_just_fits(size, margin, perspective):
    made = lens(SCENE, Camera(20, 35, perspective=perspective), size)
    flat = made.see(SCENE.center + SCENE.radius * directions(20000))[:, :2]
    farthest = np.hypot(*(flat - np.array(size) / 2).T).max()
    assert farthest == pytest.approx(min(size) / 2 - margin, rel=1e-3)


@given(balls, balls, cameras, sizes)
@example([((1, 1, 1), 0.3)], [], Camera(45, 35, perspective=True), (300, 300))
def test_nothing_leaves_the_picture(extents, home, camera, size):
    scene = replace(SCENE, fit=Fit((0.0, 0.0, 0.2), 0.9, 0.08))
    made = lens(scene, camera, size, extents, home)
    assert np.isfinite(made.scale) and made.scale > 0
    assert not extents or inside(made, surface(extents), size, 24)


@pytest.mark.parametrize("name", ROBOTS)
def test_no_pose_of_an_arm_leaves_the_picture_or_becomes_tiny(name):
    arm = getattr(kl.robots, name)()
    scene, extents = framed(arm)
    low, high = joint_ranges(arm)
    rng, home = np.random.default_rng(1), extents(scene.begin)
    for k in range(90):
        pose = extents(low + rng.random(arm.n) * (high - low))
        side = Camera(rng.uniform(-180, 180), rng.uniform(-90, 90), perspective=k % 2 > 0)
        made = lens(scene, side, SIZES[k % len(SIZES)], pose, home)
        assert inside(made, surface(pose), SIZES[k % len(SIZES)], 24)
        assert 0.48 < made.shrunk < 1.09


@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("perspective", [False, True])
def test_at_home_an_arm_fills_the_picture(name, size, perspective):
    scene, extents = framed(getattr(kl.robots, name)())
    first = Camera(*scene.presets[scene.preset], perspective=perspective)
    home = extents(scene.begin)
    made = lens(scene, first, size, home, home)
    sides = np.ptp(made.see(surface(home))[:, :2], axis=0)
    assert max(sides) > 0.68 * min(size) and max(sides / size) < 0.86
    assert made.shrunk == 1


@pytest.mark.parametrize("name", ROBOTS)
def test_the_picture_changes_smoothly_with_pose_and_side(name):
    """A degree changes the scale by less than 2 % and moves the ground by less than 1.2 %."""
    arm = getattr(kl.robots, name)()
    scene, extents = framed(arm)
    low, high = joint_ranges(arm)
    rng, home = np.random.default_rng(2), extents(scene.begin)
    for k in range(60):
        q, i = low + rng.random(arm.n) * (high - low), k % arm.n
        side, size = Camera(rng.uniform(-180, 180), rng.uniform(-90, 90)), SIZES[k % len(SIZES)]
        more = q + np.eye(arm.n)[i] * (pi / 180 if high[i] - low[i] > 2 else (high - low) / 100)
        made = lens(scene, side, size, extents(q), home)
        moved = lens(scene, side, size, extents(more), home)
        turned = lens(scene, replace(side, azimuth=side.azimuth + 1), size, extents(q), home)
        assert abs(moved.scale / made.scale - 1) < 0.02
        assert abs(turned.scale / made.scale - 1) < 0.02
        shift = (moved.see((0, 0, 0)) - made.see((0, 0, 0)))[:2]
        assert np.hypot(*shift) < 0.012 * min(size)


@given(balls, balls, cameras, st.floats(0.4, 8))
def test_a_zoom_is_about_the_middle_of_the_picture(extents, home, camera, zoom):
    scene = replace(SCENE, fit=Fit((0.0, 0.0, 0.2), 0.9, 0.08))
    plain = lens(scene, camera, (580, 520), extents, home)
    zoomed = lens(scene, replace(camera, zoom=zoom), (580, 520), extents, home)
    points = directions(20)
    np.testing.assert_allclose(zoomed.see(points)[:, :2] - [290, 260],
                               zoom * (plain.see(points)[:, :2] - [290, 260]), atol=1e-6)
    assert zoomed.shrunk == plain.shrunk
