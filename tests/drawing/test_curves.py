"""Curves that knobs shape, and clouds: by hand, and against the arm that would draw them."""
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlab.arms.motions import ROTATE, TRANSLATE
from kinlab.drawing.cloud import layers, packed, unpacked
from kinlab.drawing.curves import corners, is_there
from kinlab.drawing.scene import LINE, PATCH, SWEEP, WAY, Item, Scene, Step, at

close = np.testing.assert_allclose
angles = st.floats(-3, 3)
X, Y, Z = 0, 1, 2


def drawn(item, steps, q):
    scene = Scene(steps, (item,), len(steps), (0.0, 0.0, 0.0), 1.0)
    return corners(item, scene.motions, scene.frames(q), q)


def two_links(first, second):
    """Where two links of 1 and 0.6 end, (..., 2)."""
    return np.stack([np.cos(first) + 0.6 * np.cos(first + second),
                     np.sin(first) + 0.6 * np.sin(first + second)], axis=-1)


# Knobs 0 and 1 are the ends of joint 1, knobs 2 and 3 those of joint 2.
LINKS = (Step(ROTATE, Z, joint=0), Step(ROTATE, Z, joint=1, parent=0), Step(TRANSLATE, X, 1.0,
         parent=1), Step(ROTATE, Z, joint=2), Step(ROTATE, Z, joint=3, parent=3))


@given(angles, angles, angles)
def test_a_sweep_is_where_the_turned_arm_would_be(start, end, bend):
    item = Item("arc", SWEEP, "mesh", at(4, (0.6, 0, 0)), size=(1, 2))
    curve = drawn(item, LINKS, [start, end, bend, 0.0])
    turns = np.linspace(start, end, len(curve))
    close(curve[:, :2], two_links(turns, bend), atol=1e-9)
    assert len(curve) == 1 or np.abs(np.diff(turns)).max() <= np.pi / 60 + 1e-9


@given(angles, angles, angles, angles)
def test_a_patch_has_the_sides_of_the_rectangle_of_joint_values(low_1, high_1, low_2, high_2):
    item = Item("patch", PATCH, "region", at(4, (0.6, 0, 0)), size=(1, 2, 4, 5))
    outline = drawn(item, LINKS, [low_1, high_1, low_2, high_2])[:, :2]
    shares = np.linspace(0, 1, 7)[:, None]
    for first, second in ((low_1 + shares * (high_1 - low_1), low_2), (high_1, high_2),
                          (low_1, low_2 + shares * (high_2 - low_2)), (low_1, high_2)):
        for place in two_links(first, second).reshape(-1, 2):
            ends = np.roll(outline, -1, axis=0)
            assert _off(place, outline, ends).min() < 1.6 * (1 - np.cos(np.pi / 120)) + 1e-9


def _off(place, tails, heads):
    """How far a place is from each segment."""
    way = heads - tails
    square = np.maximum(np.sum(way**2, axis=1), 1e-30)
    share = np.clip(np.sum((place - tails) * way, axis=1) / square, 0, 1)
    return np.linalg.norm(tails + share[:, None] * way - place, axis=1)


def test_a_sweep_about_an_axis_in_space():
    """About y through (1, 0, 0), by a quarter: (2, 5, 0) goes to (1, 5, -1)."""
    steps = (Step(TRANSLATE, X, 1.0), Step(ROTATE, Y, 0.0), Step(ROTATE, Y, np.pi / 2, parent=1))
    curve = drawn(Item("arc", SWEEP, "mesh", at(2, (1, 5, 0)), size=(2, 3)), steps, [])
    close(curve[[0, -1]], [(2, 5, 0), (1, 5, -1)], atol=1e-12)
    close(np.hypot(curve[:, 0] - 1, curve[:, 2]), 1)


def test_a_sweep_of_a_slide_is_a_line():
    steps = (Step(TRANSLATE, Y, 0.5), Step(TRANSLATE, Y, 2.0, parent=0))
    curve = drawn(Item("line", SWEEP, "mesh", at(1, (1, 0, 0)), size=(1, 2)), steps, [])
    close(curve, [(1, 0.5, 0), (1, 2, 0)])


@pytest.mark.parametrize("knob, end", [(-1, (0, 0, 0)), (0, (0, 0, 0)), (0.5, (1, 0, 0)),
                                       (1, (2, 0, 0)), (1.75, (2, 3, 0)), (2, (2, 4, 0)),
                                       (9, (2, 4, 0))])
def test_a_way_ends_where_its_knob_stands(knob, end):
    item = Item("way", WAY, "trace", at(0, (0, 0, 0), (2, 0, 0), (2, 4, 0)), size=(0,))
    curve = drawn(item, (), [knob])
    close(curve[-1], end)
    assert len(curve) == 1 + np.ceil(np.clip(knob, 0, 2))


def test_a_knob_lets_an_item_be_seen():
    item = Item("line", LINE, "mesh", at(0, (0, 0, 0)), when=(1, -0.5, 0.5))
    assert [is_there(item, [9, value]) for value in (-0.6, -0.5, 0, 0.5, 0.6)] == [
        False, True, True, True, False]
    assert is_there(Item("line", LINE, "mesh", at(0, (0, 0, 0))), [])


@pytest.mark.parametrize("value, there", [(-1, True), (-0.5, True), (0, False), (0.5, True)])
def test_with_its_ends_exchanged_a_knob_shows_an_item_beyond_them(value, there):
    item = Item("line", LINE, "mesh", at(0, (0, 0, 0)), when=(0, 0.5, -0.5))
    assert is_there(item, [value]) == there



def test_dots_keep_their_places_to_half_a_step():
    dots = np.random.default_rng(1).uniform(-480, 700, (500, 3))
    corner, letters = packed(dots, 3.0)
    assert letters.isalpha() and len(letters) == 1500
    assert np.abs(unpacked(corner, letters, 3.0) - dots).max() <= 1.5 + 1e-9


def test_a_plane_cuts_a_cloud_open():
    dots = np.array([(0, y, z) for y in (-2.0, 0.0, 2.0) for z in (-0.9, 0.2)])
    plane = np.eye(4)
    kept = layers(dots, plane, np.array([0, 0, 1.0]), np.zeros(3), 1.0)
    assert [len(layer) for layer in kept] == [2, 0, 2, 0]
    assert np.vstack(kept)[:, 1].min() == 0
    whole = layers(dots, None, np.array([0, 0, 1.0]), np.zeros(3), 1.0)
    assert sum(map(len, whole)) == 6
