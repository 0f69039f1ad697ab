"""The lesson on rotation: what its views draw, and that its answers are true."""
from functools import cache
from math import cos, degrees, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from solved.rotation import CAMERA, RIGHT, turn
from textbook import turn as spatial_turn

import kinlab as kl
from kinlab.arms import inputs
from kinlab.drawing.curves import is_there

VIEWS = kl.lessons.rotation
# Made once: drawing a view takes longer than all that is asked of it.
axes, riding, still, spatial, mirror, two_turns, book = map(cache, (
    VIEWS.axes_view, VIEWS.riding_view, VIEWS.still_view, VIEWS.spatial_view, VIEWS.mirror_view,
    VIEWS.two_turns_view, VIEWS.book_view))
angles = st.floats(-pi, pi)


def drawn(view, theta=None, **angles):
    """Where the items of a view stand in the room, by their gid, at these angles."""
    for name, angle in (angles | ({} if theta is None else {"theta": theta})).items():
        view[name].value = degrees(angle)
    frames = view._scene.frames(view._values)
    return {item.gid: np.array([(frames[k] @ (*local, 1))[:3] for k, *local in item.points])
            for item in view._scene.items}


def table(view, theta):
    """The axes that the table shows, as columns."""
    view["theta"].value = degrees(theta)
    return view._scene.frames(view._values)[view._scene.tip][:3, :3]


def flat(*points):
    return np.array([(*point, 0) for point in points])


@given(angles)
def test_dashed_lines_are_the_components_of_the_axes(theta):
    view, c, s = axes(), cos(theta), sin(theta)
    at = drawn(view, theta)
    assert np.allclose(at["legs-x"], flat((0, 0), (c, 0), (c, s)))
    assert np.allclose(at["legs-y"], flat((0, 0), (-s, 0), (-s, c)))
    assert np.allclose(at["frame-1-x"], flat((0, 0), (c, s)))
    assert np.allclose(at["frame-1-y"], flat((0, 0), (-s, c)))
    assert np.allclose([*view.readings["x"], *view.readings["y"]], turn(theta).T)
    marks = {(item.style, item.text): at[item.gid][0] for item in view._scene.items if item.text}
    assert np.allclose(marks["x", "cos θ"], (c / 2, 0, 0))
    assert np.allclose(marks["x", "sin θ"], (c, s / 2, 0))
    assert np.allclose(marks["y", "−sin θ"], (-s / 2, 0, 0))
    assert np.allclose(marks["y", "cos θ"], (-s, c / 2, 0))


@pytest.mark.parametrize(("theta", "named"), [(-90, True), (0, False), (35, True)])
def test_a_leg_has_no_name_while_it_has_no_length(theta, named):
    """So that the picture does not answer which sign it will have."""
    seen = [is_there(item, [np.radians(theta)]) for item in axes()._scene.items
            if item.text == "−sin θ"]
    assert any(seen) is named and sum(seen) <= 1


@given(angles)
def test_the_point_rides_with_the_frame(theta):
    view = riding()
    at, R = drawn(view, theta), turn(theta)
    corner, c = 1.2 * R[:, 0], R @ [1.2, 0.5]
    for name, ends in (("arrow-c", ((0, 0), c)), ("sum-x", ((0, 0), corner)),
                       ("sum-y", (corner, c))):
        assert np.allclose(at[name], flat(*ends))
    assert np.allclose(view.readings["c0"], [1.2 * R[:, 0], 0.5 * R[:, 1], R @ [1.2, 0.5]])
    assert np.allclose(view.readings["c1"], [[1.2, 0.5]])


@given(angles)
def test_the_point_stays_while_the_frame_turns(theta):
    view, R, c = still(), turn(theta), np.array([0.5, 1.2])
    at = drawn(view, theta)
    assert np.allclose(at["arrow-c"][1], (*c, 0))
    for letter, axis in zip("xy", R.T):
        foot = (c @ axis) * axis
        assert np.allclose(at[f"sum-{letter}"], flat((0, 0), foot))
        assert np.allclose(at[f"drop-{letter}"], flat(foot, c))
    assert np.allclose(view.readings["c1"], [R.T @ c])
    assert np.allclose(view.readings["c0"], [c])


@given(angles)
def test_the_right_angles_lie_at_the_feet_and_towards_c(theta):
    view, c = still(), np.array([0.5, 1.2, 0])
    at = drawn(view, theta)
    for letter in "xy":
        (mark, *_), foot = [at[item.gid] for item in view._scene.items
                            if item.gid.startswith(f"right-angle-{letter}")
                            and is_there(item, [theta])], at[f"drop-{letter}"][0]
        one, corner, other = mark - foot
        assert np.isclose(one @ other, 0) and np.allclose(one + other, corner)
        ways = [way / (np.linalg.norm(way) or 1) for way in (-foot, c - foot)]
        if min(np.linalg.norm(foot), np.linalg.norm(c - foot)) > 1e-6:
            assert np.allclose(corner, 0.09 * (ways[0] + ways[1]))


def test_a_flipped_sheet_shows_the_mirror_image():
    at = drawn(mirror(), theta=0, phi=pi)
    assert np.allclose(at["letter"][:, :2], at["outline"][:, :2] * [1, -1])
    assert np.allclose(at["point-c"][0], (0.8, -1, 0))


def test_the_mirrored_letter_is_upright_after_half_a_turn_but_points_to_the_left():
    *_, foot, top, end = drawn(mirror(), theta=pi, phi=pi)["letter"]
    assert np.allclose(top - foot, (0, 0.8, 0)) and np.allclose(end - top, (-0.5, 0, 0))


@given(angles, angles)
def test_two_turns_add_up_and_their_product_carries_a_point(one, two):
    view, c_2 = two_turns(), np.array([1.2, 0.3])
    at = drawn(view, theta_1=one, theta_2=two)
    assert np.allclose(at["frame-2-x"][1][:2], 0.95 * turn(one + two)[:, 0])
    assert np.allclose(at["point-c"][0][:2], turn(one) @ turn(two) @ c_2)
    assert np.allclose([view.readings[name][0] for name in ("c²", "c¹", "c⁰")],
                       [c_2, turn(two) @ c_2, turn(one) @ turn(two) @ c_2])


def test_the_books_end_as_the_products_say():
    view, (x, _, z) = book(), np.eye(3)
    view["t"].value = 2
    frames = view._scene.frames(view._values)
    for name, R in (("A", spatial_turn(x, pi / 2) @ spatial_turn(z, pi / 2)),
                    ("B", spatial_turn(z, pi / 2) @ spatial_turn(x, pi / 2))):
        (axis,) = [item for item in view._scene.items if item.gid == f"frame-{name}-z"]
        assert np.allclose(frames[axis.points[0][0]][:3, :3], R)
    assert np.allclose(view.readings["A"], [[0, -1, 0]])
    assert np.allclose(view.readings["B"], [[1, 0, 0]])


@given(angles)
@pytest.mark.parametrize("make", [axes, riding, still])
def test_planar_tables_hold_the_rotation(make, theta):
    assert np.allclose(table(make(), theta)[:2, :2], turn(theta))


@given(angles)
@pytest.mark.parametrize("axis", "xyz")
def test_spatial_tables_hold_the_elementary_rotation(axis, theta):
    view, R = spatial(axis), spatial_turn(np.eye(3)["xyz".index(axis)], theta)
    assert np.allclose(table(view, theta), R)
    assert np.allclose([view.readings[letter][0] for letter in "xyz"], R.T)
    arcs = {gid: points for gid, points in drawn(view, theta).items() if "arc" in gid}
    assert len(arcs) == 2
    for (gid, points), radius in zip(arcs.items(), (0.75, 0.55)):
        unit = radius * np.eye(3)["xyz".index(gid[-1])]
        assert np.allclose(points[[0, -1]], [unit, R @ unit])


def test_which_matrices_are_rotations_is_true_of_them():
    matrices = [[[.6, -.8], [.8, .6]], [[.6, .8], [.8, -.6]], [[1, -1], [1, 1]],
                [[0, 1], [-1, 0]], [[1, .6], [0, .8]], [[-1, 0], [0, -1]]]

    def is_rotation(matrix):
        try:
            return inputs.rotation("R", matrix) is not None
        except ValueError:
            return False

    assert [{k for k, matrix in enumerate(matrices, 1) if is_rotation(matrix)}] \
        == RIGHT["rotation.4"]


def test_the_camera_looks_ahead():
    assert np.allclose(CAMERA @ [0, 0, 2], [2, 0, 0]) and np.isclose(np.linalg.det(CAMERA), 1)
    assert np.allclose(CAMERA @ [0, 1, 0], [0, 0, -1])


def test_the_second_frame_is_seen_by_its_transpose():
    assert np.allclose(np.array(RIGHT["rotation.2"]).T @ [2, 1], RIGHT["rotation.3"])
