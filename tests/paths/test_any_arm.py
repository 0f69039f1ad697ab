"""Straight paths of arms of all sorts: one path whatever the unit, and rates that are its own."""
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from strategies import exact_angles, poses

import kinlab as kl

sizes = st.floats(-0.6, 0.6).map(lambda x: x + np.copysign(0.1, x))
values = st.floats(0.2, 1.0)


@st.composite
def rows(draw, kinds="rrrplf"):
    """A joint that turns, one that slides, with limits or without, a lock, or a fixed row."""
    kind = draw(st.sampled_from(kinds))
    numbers = dict(theta=draw(exact_angles), d=draw(sizes), a=draw(sizes), alpha=draw(exact_angles))
    if kind == "f":
        return kl.fixed(**numbers)
    make = draw(st.sampled_from([kl.revolute, kl.prismatic])) if kind == "l" else (
        kl.prismatic if kind == "p" else kl.revolute)
    value = draw(st.floats(-0.5, 0.5))
    limits = (value, value) if kind == "l" else draw(st.sampled_from([None, (-2, 2)]))
    return make(**numbers, flip=draw(st.booleans()), limits=limits)


@st.composite
def lines(draw):
    """An arm, joint values, and the tool points at these and at others near them."""
    table = [*draw(st.lists(rows(), min_size=2, max_size=4)), *draw(st.lists(
        rows("rp"), min_size=2, max_size=2))]
    small = poses(exact_angles, st.floats(-0.5, 0.5))
    arm = kl.Arm(table, convention=draw(st.sampled_from(["standard", "modified"])),
                 base=draw(st.none() | small), tool=draw(small))
    q = np.array([link.limits[0] if link.lock is not None else draw(values) for link in arm.joints])
    moves = np.array([link.lock is None for link in arm.joints])
    q1 = q + moves * [draw(st.floats(-0.3, 0.3)) for _ in arm.joints]
    return arm, q, *(kl.forward_kinematics(arm, here)[:3, 3] for here in (q, q1))


def units(arm, factor):
    return np.array([1.0 if link.kind == "revolute" else factor for link in arm.joints])


def grown(arm, factor):
    """The same arm in another unit."""
    def row(link):
        limits = link.limits and tuple(
            end * (factor if link.kind == "prismatic" else 1) for end in link.limits)
        return replace(link, d=factor * link.d, a=factor * link.a, limits=limits)

    def end(T):
        T = T.copy()
        T[:3, 3] *= factor
        return T

    return kl.Arm([row(link) for link in arm.links], convention=arm.convention, unit="mm",
                  base=end(arm.base), tool=end(arm.tool))


def followed(arm, q, start, end, factor):
    """The path of one second in a unit; its q, rates and accelerations in the first one."""
    arm, unit = grown(arm, factor), units(arm, factor)
    path = kl.straight_path(arm, factor * start, factor * end, 1, q0=q * unit)
    return path, *(series / unit for series in (path.q, path.rates, path.accelerations))


def regular(line, factor):
    """The same, where there is one that stays away from singular places."""
    try:
        path, q, rates, bends = followed(*line, factor)
    except ValueError:
        assume(False)
    assume(np.abs(rates).max() < 20)
    return path, q, rates, bends


@settings(max_examples=30, deadline=None)
@given(lines())
def test_a_path_does_not_depend_on_the_unit(line):
    path, *states = regular(line, 1)
    other, *others = followed(*line, 1000)
    assert len(other.t) == len(path.t) and other.t == pytest.approx(path.t)
    for own, its in zip(states, others):
        assert own == pytest.approx(its, abs=1e-5 * (1 + np.abs(own).max()))


@settings(max_examples=40, deadline=None)
@given(lines(), st.sampled_from([1, 1000]))
def test_rates_are_those_of_the_joint_values_and_of_the_tip(line, factor):
    """Fine differences of `at`, and the Jacobian's speed of the tip: along the line, s' of it."""
    arm, q, start, end = line
    unit = units(arm, factor)
    path, values, rates, bends = regular(line, factor)
    assert values[0] == pytest.approx(q, abs=1e-9)
    k, h = np.array([17, 40, 60, 83, 104]), 1e-4
    far, near, here, after, beyond = (path.at(path.t[k] + i * h) / unit for i in (-2, -1, 0, 1, 2))
    assert (8 * (after - near) - (beyond - far)) / (12 * h) == pytest.approx(
        rates[k], abs=1e-4 * (1 + np.abs(rates).max()))
    assert (after - 2 * here + near) / h**2 == pytest.approx(
        bends[k], abs=1e-2 * (1 + np.abs(bends).max()))
    length, tau = np.linalg.norm(end - start), path.t[k]
    assert path.tip_speed[k] / factor == pytest.approx(
        length * 30 * tau**2 * (1 - tau)**2, abs=1e-6 * (1 + length))
    locked = [link.lock is not None for link in arm.joints]
    assert np.ptp(path.q[:, locked], axis=0).max(initial=0) == 0
    assert not path.rates[:, locked].any() and not path.accelerations[:, locked].any()
