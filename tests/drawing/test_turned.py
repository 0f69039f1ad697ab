"""How a frame is turned: each description gives its rotation back, and no sign jumps."""
from math import pi, radians, sqrt

import numpy as np
import pytest
import textbook
from hypothesis import given
from hypothesis import strategies as st

import kinlab as kl
from kinlab.arms.motions import ROTATE, TRANSLATE
from kinlab.drawing.readings import RollPitchYaw, TurnAngle, TurnAxis, Turned
from kinlab.drawing.scene import Scene, Step
from kinlab.drawing.turned import axis_and_angle, followed, roll_pitch_yaw

close = np.testing.assert_allclose
angles = st.floats(-2 * pi, 2 * pi)
three = st.tuples(angles, angles, angles)
# Yaw, pitch and roll; a slide on the way turns nothing.
STEPS = (Step(ROTATE, 2, joint=0), Step(TRANSLATE, 0, 0.4), Step(ROTATE, 1, joint=1),
         Step(ROTATE, 0, joint=2))
BODY = len(STEPS)


def read(part, yaw=0.0, pitch=0.0, roll=0.0):
    """What a part reads at these angles in degrees."""
    q = np.radians([yaw, pitch, roll])
    scene = Scene(STEPS, (), BODY, (0.0, 0.0, 0.0), 1.0)
    return part(BODY).read(STEPS, scene.frames(q), q)


def rotation(q):
    """By the textbook's turns: about z, then y, then x, each of the moving frame."""
    z, y, x = (textbook.turn(np.eye(3)[k], angle) for k, angle in zip((2, 1, 0), q))
    return z @ y @ x


@given(three)
def test_the_quaternion_is_that_of_the_frame(q):
    close(kl.quaternion_matrix(followed(STEPS, BODY, q)), rotation(q), atol=1e-12)


@given(three)
def test_axis_and_angle_are_those_of_the_frame(q):
    axis, angle = axis_and_angle(followed(STEPS, BODY, q))
    assert 0 <= angle <= 360
    turned = np.eye(3) if axis is None else textbook.turn(axis, radians(angle))
    close(turned, rotation(q), atol=1e-5)


@given(three)
def test_roll_pitch_and_yaw_are_those_of_the_frame(q):
    found = roll_pitch_yaw(rotation(q))
    if not isinstance(found, str):
        roll, pitch, yaw = np.radians(found)
        close(rotation((yaw, pitch, roll)), rotation(q), atol=1e-9)
        assert abs(pitch) <= pi / 2 + 1e-12 and found.min() > -179.95


@given(three, st.integers(0, 2))
def test_no_sign_jumps_while_a_knob_moves(q, knob):
    moved = np.array(q)
    moved[knob] += 1e-3
    close(followed(STEPS, BODY, moved), followed(STEPS, BODY, q), atol=6e-4)


half = sqrt(0.5)


@pytest.mark.parametrize("at, quaternion, axis, angle", [
    ({"yaw": 90}, (half, 0, 0, half), (0, 0, 1), 90),
    ({"pitch": 90}, (half, 0, half, 0), (0, 1, 0), 90),
    ({"roll": -90}, (half, -half, 0, 0), (-1, 0, 0), 90),
    ({"yaw": 90, "roll": 90}, (.5, .5, .5, .5), (3**-.5,) * 3, 120),
    ({"yaw": 180}, (0, 0, 0, 1), (0, 0, 1), 180),
    ({"yaw": 270}, (-half, 0, 0, half), (0, 0, 1), 270),
])
def test_by_hand(at, quaternion, axis, angle):
    close(read(Turned, **at), quaternion, atol=1e-12)
    close(read(TurnAxis, **at), axis, atol=1e-12)
    close(read(TurnAngle, **at), [angle], atol=1e-9)


def test_a_frame_that_is_not_turned_has_any_axis():
    assert read(TurnAxis) == read(TurnAxis, yaw=360) == "any axis"
    close(read(TurnAngle), [0])
    close(read(Turned, yaw=360), [-1, 0, 0, 0], atol=1e-12)  # the opposite one, the same turn


@pytest.mark.parametrize("yaw, pitch, roll, said", [
    (50, 90, 20, "pitch 90.0, yaw − roll = 30.0"), (20, 90, 50, "pitch 90.0, yaw − roll = −30.0"),
    (50, -90, 20, "pitch −90.0, yaw + roll = 70.0"), (0, 90, 0, "pitch 90.0, yaw − roll = 0.0"),
    (90, 90, -90, "pitch 90.0, yaw − roll = 180.0"),
])
def test_where_pitch_is_a_quarter_turn_a_sum_or_a_difference_is_left(yaw, pitch, roll, said):
    assert read(RollPitchYaw, yaw, pitch, roll) == said


def test_beyond_a_quarter_turn_the_other_branch_is_read():
    close(read(RollPitchYaw, 40, 20, -30), (-30, 20, 40))
    close(read(RollPitchYaw, 40, 110, -30), (150, 70, -140))
    close(read(RollPitchYaw, yaw=-180), (0, 0, 180), atol=1e-9)


