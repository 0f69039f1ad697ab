"""The lessons' sketches: what moves stays in the picture, and at home it fills it."""
import numpy as np
import pytest

from kinlab.drawing.curves import corners
from kinlab.lessons import (
    dh_recipe,
    homogeneous,
    n_link,
    notation,
    rotation,
    translation,
    turns,
    two_link,
    workspace,
)

STANDING = {  # the room stands still in these
    "axes": rotation.axes_view,
    "turning": rotation.riding_view, "still": rotation.still_view,
    **{axis: lambda axis=axis: rotation.spatial_view(axis) for axis in "xyz"},
    "order": homogeneous.order, "fixed": homogeneous.fixed, "rules": dh_recipe.rules_view,
    "zyz": n_link.zyz_view, "flat": n_link.flat_view,
    **{order: lambda order=order: n_link.four_motions(order) for order in ("standard", "modified")},
    "ring": workspace.ring_view, "books": turns.books_view, "attitude": turns.attitude_view,
    "gimbal": turns.gimbal_view, "one axis": turns.axis_view}
FOLLOWED = {
    "sliding": translation.sliding_view, "riding": translation.riding_view,
    "two slides": translation.chain_view, "pose": notation.pose_view,
    "combined": homogeneous.combined, "seen back": homogeneous.seen_back,
    "chain": homogeneous.chain, "spatial": homogeneous.spatial,
    "both methods": two_link.both_methods, "n links": two_link.n_links,
    "four numbers": dh_recipe.numbers_view,
    "limits": workspace.limits_view}
each = {"argvalues": STANDING.values(), "ids": STANDING}


def strokes(scene):
    """All that is drawn with ends of its own; names and axes have their room."""
    return [item for item in scene.items if item.shape not in ("text", "name", "trace")
            and item.style != "axis"]


def places(scene, q):
    """Points of all strokes on the picture that the scene begins with, seen from its centre."""
    azimuth, elevation = np.radians(scene.presets[scene.seen_from])
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0])
    up = np.array([-np.sin(elevation) * np.cos(azimuth), -np.sin(elevation) * np.sin(azimuth),
                   np.cos(elevation)])
    room = np.concatenate(ends(scene, q))
    return (room - scene.center) @ np.array([right, up]).T


def ends(scene, q):
    """The points of every stroke in the room."""
    frames = scene.frames(q)
    return [corners(item, scene.motions, frames, q)[:1 if item.shape == "axis" else None]
            for item in strokes(scene)]


def poses(scene, count=40):
    low, high = np.array([(knob.low, knob.high) for knob in scene.knobs]).T
    shares = np.random.default_rng(5).choice([0, 0.25, 0.5, 0.75, 1], (count, len(low)))
    return low + shares * (high - low)


@pytest.mark.parametrize("make", **each)
def test_nothing_leaves_a_room_that_stands_still(make):
    scene = make()._scene
    assert scene.fit is None
    assert max(np.abs(places(scene, q)).max() for q in poses(scene)) < scene.radius


@pytest.mark.parametrize("make", **each)
def test_a_room_that_stands_still_is_filled_once_its_motion_has_run(make):
    """At home, or where the knob of a motion, which begins at nought, has gone through."""
    scene = make()._scene
    run = [knob.high if knob.whole else value for knob, value in zip(scene.knobs, scene.begin)]
    assert np.ptp(places(scene, run), axis=0).max() > 0.45 * 2 * scene.radius


@pytest.mark.parametrize("make", FOLLOWED.values(), ids=FOLLOWED)
def test_a_picture_that_follows_has_the_ball_round_its_home(make):
    scene = make()._scene
    drawn = np.concatenate(ends(scene, scene.begin))
    low, high = drawn.min(axis=0), drawn.max(axis=0)
    np.testing.assert_allclose(scene.fit.middle, (low + high) / 2, atol=1e-9)
    np.testing.assert_allclose(2 * scene.fit.radius, np.linalg.norm(high - low))
