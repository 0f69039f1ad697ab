"""Profiles and paths in joint space, against numbers typed from textbooks."""
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import kinlab as kl
from kinlab.paths.profiles import given_profile

NAMES = ("cubic", "quintic", "trapezoidal")
ONE = kl.Arm([kl.revolute(a=1)])


def curve(name, *tau, **options):
    return [part.tolist() for part in given_profile(name, **options).curve(np.array(tau))]


def test_textbook_values_of_the_profiles():
    """Spong, section 5.5; Craig, section 7.3: over one second and one unit of way."""
    s, rate, acceleration = curve("cubic", 0, 0.5, 1)
    assert (s, rate, acceleration) == ([0, 0.5, 1], [0, 1.5, 0], [6, 0, -6])
    peak = 0.5 - np.sqrt(3) / 6
    s, rate, acceleration = curve("quintic", 0, peak, 0.5, 1)
    assert [s[0], s[2], s[3]] == [0, 0.5, 1] and rate[2] == 1.875
    assert rate[::3] == [0, 0] and acceleration[::3] == [0, 0]
    assert acceleration[1] == pytest.approx(5.7735, abs=5e-5)
    s, rate, acceleration = curve("trapezoidal", 0, 0.25, 0.5, 0.75, 1, ramp=0.25)
    assert s == pytest.approx([0, 1 / 6, 0.5, 5 / 6, 1])
    assert rate == pytest.approx([0, 4 / 3, 4 / 3, 4 / 3, 0])
    assert acceleration == pytest.approx([16 / 3, 16 / 3, 0, -16 / 3, -16 / 3])


def test_a_trapeze_without_its_top_is_a_triangle():
    s, rate, acceleration = curve("trapezoidal", 0.25, 0.5, 0.75, ramp=0.5)
    assert s == pytest.approx([0.125, 0.5, 0.875]) and rate == pytest.approx([1, 2, 1])
    assert acceleration[::2] == pytest.approx([4, -4])


def test_craig_example_7_1():
    """From 15 to 75 degrees in 3 s: theta = 15 + 20 t^2 - 4.44 t^3."""
    path = kl.joint_path(ONE, np.radians([15]), np.radians([75]), 3, "cubic")
    t = np.array([0, 0.7, 1.5, 2.2, 3])
    assert np.degrees(path.at(t)[:, 0]) == pytest.approx(15 + 20 * t**2 - 40 / 9 * t**3)
    assert np.degrees(path.rates[[0, 91, 181 - 1], 0]).round(6).tolist()[::2] == [0, 0]
    assert np.degrees(np.abs(path.rates).max()) == pytest.approx(30)
    assert np.degrees(path.accelerations[[0, -1], 0]) == pytest.approx([40, -40])


def test_spong_example_5_22_lspb():
    """With blends of 1/3 of a second: from 0 to 40 at 60 a second at most, as far as 1 s."""
    path = kl.joint_path(ONE, [0], np.radians([40]), 1, "trapezoidal", ramp=1 / 3)
    assert np.degrees(np.abs(path.rates).max()) == pytest.approx(60)
    assert np.degrees(path.at([1 / 3, 2 / 3])[:, 0]) == pytest.approx([10, 30])
    assert np.degrees(path.accelerations[0, 0]) == pytest.approx(180)


@pytest.mark.parametrize("name", NAMES)
def test_rates_and_accelerations_are_the_derivatives(name):
    curve, h = given_profile(name, 0.3).curve, 1e-5
    tau = np.array([0.07, 0.21, 0.4, 0.55, 0.68, 0.81, 0.97])
    before, here, after = (curve(tau + k * h) for k in (-1, 0, 1))
    assert (after[0] - before[0]) / (2 * h) == pytest.approx(here[1], rel=1e-6)
    assert (after[1] - before[1]) / (2 * h) == pytest.approx(here[2], rel=1e-6)


@settings(max_examples=40, deadline=None)
@given(st.sampled_from(NAMES), st.floats(0.01, 100), st.floats(0.01, 0.5),
       st.lists(st.tuples(st.floats(-3, 3), st.floats(-3, 3)), min_size=1, max_size=3))
def test_every_joint_goes_from_its_first_to_its_last_value_at_rest(name, duration, ramp, ends):
    arm = kl.Arm([kl.revolute(a=1) for _ in ends])
    q0, q1 = np.array(ends).T
    path = kl.joint_path(arm, q0, q1, duration, name, ramp=ramp)
    assert path.t[0] == 0 and path.t[-1] == pytest.approx(duration, rel=1e-15)
    assert np.all(np.diff(path.t) > 0)
    assert path.q[[0, -1]] == pytest.approx(np.array([q0, q1]), abs=1e-12)
    assert path.rates[[0, -1]] == pytest.approx(0, abs=1e-9 / duration)
    whole = np.linspace(0, duration, 7)
    assert path.at(whole) + path.at(whole[::-1]) == pytest.approx(
        np.broadcast_to(q0 + q1, (7, len(ends))), abs=1e-9)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("duration", (0.2, 3, 30))
def test_straight_lines_between_samples_look_like_the_curve(name, duration):
    """Half a turn is nowhere 0.02 degrees off: a seventh of a pixel at the end of 400 px."""
    path = kl.joint_path(ONE, [0], [np.pi], duration, name)
    t = np.linspace(0, duration, 2000)
    off = np.interp(t, path.t, path.q[:, 0]) - path.at(t)[:, 0]
    assert np.degrees(np.abs(off).max()) < 0.02


def test_limits_of_all_kinds_are_marked_where_they_are_broken():
    """A cubic over 2 s and 2 rad: rate 3 (t - t^2/2), acceleration 3 (1 - t)."""
    arm = kl.Arm([kl.revolute(a=1, limits=(-1, 1), speed=1.125, acceleration=1.5)])
    path = kl.joint_path(arm, [0], [2], 2, "cubic")
    limit, speed, *accelerations = path.broken
    assert (limit.joint, limit.kind, limit.limit) == (1, "limit", 1)
    assert (limit.start, limit.end) == pytest.approx((1, 2)) and limit.worst == pytest.approx(2)
    assert speed.kind == "speed" and speed.worst == pytest.approx(1.5)
    assert (speed.start, speed.end) == pytest.approx((0.5, 1.5), abs=1e-9)
    assert [breach.kind for breach in accelerations] == ["acceleration"] * 2
    assert [(b.start, b.end) for b in accelerations] == [
        pytest.approx((0, 0.5), abs=1e-9), pytest.approx((1.5, 2), abs=1e-9)]
    assert all(b.worst == pytest.approx(3) for b in accelerations)
    assert str(speed) == "joint 1 is faster than 64.46 deg/s from 0.5 s to 1.5 s"
    assert str(speed) in repr(path)


def test_the_jump_of_a_trapeze_ends_its_breach():
    arm = kl.Arm([kl.prismatic(acceleration=4), kl.revolute()], unit="mm")
    path = kl.joint_path(arm, [0, 0], [1, 0], 1, "trapezoidal", ramp=0.25)
    first, last = path.broken
    assert (first.start, first.end) == pytest.approx((0, 0.25), abs=1e-9)
    assert (last.start, last.end) == pytest.approx((0.75, 1), abs=1e-9)
    assert str(first) == ("joint 1 speeds up or slows down by more than 4 mm/s² "
                          "from 0 s to 0.25 s")


def test_peaks_are_among_the_samples():
    """A quintic speeds up by 10 / sqrt(3) at most, at (1 - 1 / sqrt(3)) / 2 of its time."""
    path = kl.joint_path(ONE, [0], [1], 1)
    assert path.accelerations.max() == pytest.approx(10 / np.sqrt(3), rel=1e-12)
    assert path.t[path.accelerations[:, 0].argmax()] == pytest.approx(0.21132487)
    ramps = kl.joint_path(ONE, [0], [1], 1, "trapezoidal", ramp=0.123)
    assert {0.123, 0.877} <= set(ramps.t.round(12).tolist())
    jumps = np.flatnonzero(np.abs(np.diff(ramps.accelerations[:, 0])) > 1)
    assert np.diff(ramps.t)[jumps] == pytest.approx([1e-6, 1e-6])  # upright in a chart


def test_a_limit_that_is_just_reached_is_kept():
    arm = kl.Arm([kl.revolute(limits=(0, 1), speed=1.5, acceleration=6)])
    assert kl.joint_path(arm, [0], [1], 1, "cubic").broken == ()


def test_the_tip_and_its_speed():
    """A link of 2 m that turns by 1 rad in 1 s: 2 m times 1.5 rad/s in the middle."""
    path = kl.joint_path(kl.Arm([kl.revolute(a=2)]), [0], [1], 1, "cubic")
    assert path.tip[0] == pytest.approx([2, 0, 0])
    assert path.tip[-1] == pytest.approx([2 * np.cos(1), 2 * np.sin(1), 0])
    assert path.tip_speed.max() == pytest.approx(3)
    assert path.T.shape == (len(path.t), 4, 4)


def test_a_path_does_not_change():
    path = kl.joint_path(ONE, [0], [1], 1)
    with pytest.raises(ValueError, match="read-only"):
        path.q[0] = 1
    with pytest.raises(AttributeError, match="does not change"):
        path.duration = 2


@pytest.mark.parametrize("arguments, words", [
    (dict(duration=0), "duration: expected a number above zero, got 0"),
    (dict(profile="linear"), "profile: expected 'cubic' or 'quintic' or 'trapezoidal'"),
    (dict(ramp=0.6), "ramp: expected the part of the time .* up to 0.5, got 0.6"),
    (dict(q1=[1, 2]), r"q1: expected shape \(..., 1\)"),
    (dict(q0=[[1], [2]]), r"q0: expected one pose, shape \(1,\), got \(2, 1\)"),
])
def test_what_does_not_fit_is_refused_with_a_word(arguments, words):
    with pytest.raises(ValueError, match=words):
        kl.joint_path(ONE, **(dict(q0=[0], q1=[1], duration=1) | arguments))


@pytest.mark.parametrize("time", (-0.1, 1.1, [[0.5]]))
def test_a_time_outside_is_refused(time):
    with pytest.raises(ValueError, match="time: expected seconds from 0 to 1"):
        kl.joint_path(ONE, [0], [1], 1).at(time)
