"""The lesson on turns in space: what its views draw, how they are dragged, and its answers."""
from functools import cache
from math import radians

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from solved.turns import DIAGONAL, LEFT, LOCKED, ROUND
from textbook import turn

import kinlab as kl
from kinlab.drawing.curves import corners

VIEWS = kl.lessons.turns
books, attitude, gimbal, axis = map(cache, (VIEWS.books_view, VIEWS.attitude_view,
                                            VIEWS.gimbal_view, VIEWS.axis_view))
X, Y, Z = np.eye(3)
degrees = st.floats(-180, 180)
close = np.testing.assert_allclose


def frames_at(view, **knobs):
    """All frames of a view at these values of its sliders."""
    for name, value in knobs.items():
        view[name].value = value
    return view._scene.frames(view._values)


def orientation(view, **knobs):
    """Of the frame that the table shows."""
    return frames_at(view, **knobs)[view._scene.tip][:3, :3]


def about(axis, angle):
    return turn(axis, radians(angle))


def of_book(name, t):
    """How a book is turned."""
    frames = frames_at(books(), t=t)
    (item,) = [item for item in books()._scene.items if item.gid == f"frame-{name}-z"]
    return frames[item.points[0][0]][:3, :3]


@given(st.floats(0, 2))
def test_axes_of_the_room_stand_on_the_left_and_own_axes_on_the_right(t):
    first, second = 90 * min(t, 1), 90 * max(t - 1, 0)
    close(of_book("A", t), about(X, second) @ about(Z, first), atol=1e-12)
    close(of_book("B", t), about(Z, second) @ about(X, first), atol=1e-12)
    close(of_book("C", t), about(Z, first) @ about(X, second), atol=1e-12)
    close(of_book("D", t), about(X, first) @ about(Z, second), atol=1e-12)


def test_own_axes_in_one_order_are_the_rooms_in_the_other():
    # x to y, y to z, z to x; and z to -y, x to z, y to -x.
    close(of_book("C", 2), [[0, 0, 1], [1, 0, 0], [0, 1, 0]], atol=1e-12)
    close(of_book("B", 2), of_book("C", 2), atol=1e-12)
    close(of_book("A", 2), [[0, -1, 0], [0, 0, -1], [1, 0, 0]], atol=1e-12)
    close(of_book("D", 2), of_book("A", 2), atol=1e-12)


@given(degrees, degrees, degrees)
@pytest.mark.parametrize("make", [attitude, gimbal])
def test_an_aircraft_yaws_pitches_and_rolls(make, yaw, pitch, roll):
    R = about(Z, yaw) @ about(Y, pitch) @ about(X, roll)
    close(orientation(make(), yaw=yaw, pitch=pitch, roll=roll), R, atol=1e-12)
    w, x, y, z = make().readings["quaternion"][0]
    close(kl.quaternion_matrix([w, x, y, z]), R, atol=1e-12)


def at_knobs(view, gid, **knobs):
    """Points of all items whose name begins so."""
    frames = frames_at(view, **knobs)
    return np.array([[(frames[k] @ (*local, 1))[:3] for k, *local in item.points]
                     for item in view._scene.items if item.gid.startswith(gid)])


def test_the_outer_ring_stays_upright_and_holds_the_axis_of_pitch():
    ring = at_knobs(gimbal(), "ring-1", yaw=90, pitch=40, roll=10)
    close(np.linalg.norm(ring, axis=-1), 1)
    close(ring[..., 1], 0, atol=1e-12)  # it lay across y, and has turned about z
    pins = at_knobs(gimbal(), "pin-1", yaw=90, pitch=40, roll=10)
    close(np.cross(pins, X), 0, atol=1e-12)  # y after a yaw of 90 degrees is -x


def test_the_inner_ring_holds_the_axis_of_roll():
    ring = at_knobs(gimbal(), "ring-2", yaw=0, pitch=-90, roll=10)
    close(np.linalg.norm(ring, axis=-1), 0.84)
    close(ring[..., 0], 0, atol=1e-12)  # it lay flat, and stands across x now
    pins = at_knobs(gimbal(), "pin-2", yaw=0, pitch=-90, roll=10)
    close(np.cross(pins, Z), 0, atol=1e-12)  # roll turns about the axis of yaw


@pytest.mark.parametrize("pitch, said", [(-90, "pitch −90.0, yaw + roll = 50.0"),
                                         (90, "pitch 90.0, yaw − roll = 10.0")])
def test_where_the_gimbal_is_locked_a_sum_or_a_difference_is_left(pitch, said):
    frames_at(gimbal(), yaw=30, pitch=pitch, roll=20)
    assert gimbal().readings["rpy"] == (said,)


@given(degrees, st.floats(-90, 90), st.floats(-360, 360))
def test_one_turn_about_any_axis(azimuth, elevation, angle):
    u = about(Z, azimuth) @ about(Y, -elevation) @ X
    R = about(u, angle)
    close(orientation(axis(), azimuth=azimuth, elevation=elevation, angle=angle), R, atol=1e-12)
    half = radians(angle / 2)
    close(axis().readings["quaternion"][0], [np.cos(half), *np.sin(half) * u], atol=1e-12)


def test_the_diagonal_of_the_prediction_is_that_of_the_room():
    (case,) = VIEWS.PREDICTIONS["turns.one"].cases
    close(orientation(axis(), **case.shows), of_book("C", 2), atol=1e-12)


@given(degrees, st.floats(-90, 90), st.floats(-360, 360))
def test_tips_run_on_circles_from_where_they_were_to_where_they_are(azimuth, elevation, angle):
    R = orientation(axis(), azimuth=azimuth, elevation=elevation, angle=angle)
    scene, q = axis()._scene, axis()._values
    for letter, unit, tip in zip("xyz", np.eye(3), R.T):
        (item,) = [item for item in scene.items if item.gid == f"way-{letter}"]
        way = corners(item, scene.motions, scene.frames(q), q)
        close(way[[0, -1]], [unit, tip], atol=1e-12)


def test_the_matrices_of_the_exercises_are_what_the_solutions_say():
    close(turn(DIAGONAL, radians(60)), ROUND, atol=1e-12)
    close(about(Z, np.degrees(LEFT)) @ about(Y, 90), LOCKED, atol=1e-12)
