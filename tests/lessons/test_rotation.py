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

VIEWS = kl.lessons.rotation
# Made once: drawing a view takes longer than all that is asked of it.
axes, riding, still, spatial = map(cache, (VIEWS.axes_view, VIEWS.riding_view, VIEWS.still_view,
                                           VIEWS.spatial_view))
angles = st.floats(-pi, pi)


def drawn(view, theta):
    """Where the items of a view stand in the room, by their gid, at an angle."""
    view["theta"].value = degrees(theta)
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
    marks = {item.text: at[item.gid][0] for item in view._scene.items if item.text}
    assert np.allclose(marks["cos θ"], (c / 2, 0, 0))
    assert np.allclose(marks["sin θ"], (c, s / 2, 0))


@given(angles)
def test_the_point_rides_with_the_frame(theta):
    view = riding()
    (tail, tip), R = drawn(view, theta)["arrow-c"], turn(theta)
    assert np.allclose(tip, (*(R @ [1.2, 0.5]), 0)) and np.allclose(tail, 0)
    assert np.allclose(view.readings["c0"], [1.2 * R[:, 0], 0.5 * R[:, 1], R @ [1.2, 0.5]])
    assert np.allclose(view.readings["c1"], [[1.2, 0.5]])


@given(angles)
def test_the_point_stays_while_the_frame_turns(theta):
    view, R, c = still(), turn(theta), np.array([0.5, 1.2])
    at = drawn(view, theta)
    assert np.allclose(at["arrow-c"][1], (*c, 0))
    assert np.allclose(at["legs-c1"], flat((0, 0), (c @ R[:, 0]) * R[:, 0], c))
    assert np.allclose(view.readings["c1"], [R.T @ c])
    assert np.allclose(view.readings["c0"], [c])


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
    for gid, points in arcs.items():
        unit = 0.75 * np.eye(3)[int(gid[-1])]
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
