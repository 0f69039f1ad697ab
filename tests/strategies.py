"""Random arms, poses and joint values for the property tests."""
from math import pi

import numpy as np
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from textbook import rigid, zyz

import kinlab as kl

right_angles = st.integers(-4, 4).map(lambda k: k * pi / 2)
exact_angles = right_angles | st.integers(-24, 24).map(lambda k: k * pi / 12)
angles = exact_angles | st.floats(-7, 7, allow_subnormal=False)
typed_lengths = st.integers(-2000, 2000).map(lambda k: k / 1000)  # decimals, as a student types
lengths = st.just(0.0) | typed_lengths | st.floats(-2, 2, allow_subnormal=False)
points = arrays(float, 3, elements=lengths)
batch_shapes = st.sampled_from([(), (0,), (1,), (3,), (2, 3), (2, 0), (1, 2, 2), (3, 4)])


@st.composite
def rotations(draw, angle=angles):
    return zyz(draw(angle), draw(angle), draw(angle))


@st.composite
def poses(draw, angle=angles, length=lengths):
    return rigid(draw(rotations(angle)), [draw(length) for _ in range(3)])


@st.composite
def joints(draw, angle=angles, length=lengths, odd=False):
    """Revolute and prismatic rows; if `odd`, some that count the other way or are locked."""
    make = draw(st.sampled_from([kl.revolute, kl.prismatic]))
    lock = draw(st.none() | st.floats(-1, 1)) if odd else None
    return make(theta=draw(angle), d=draw(length), a=draw(length), alpha=draw(angle),
                flip=odd and draw(st.booleans()), limits=None if lock is None else (lock, lock))


@st.composite
def fixed_rows(draw, angle=angles, length=lengths):
    return kl.fixed(theta=draw(angle), d=draw(length), a=draw(length), alpha=draw(angle))


@st.composite
def tables(draw, angle=angles, length=lengths, most=7):
    """Rows with 1 to `most` joints, sometimes fixed ones before, between and behind them."""
    rows = draw(st.lists(joints(angle, length, True), min_size=1, max_size=most))
    for row in draw(st.lists(fixed_rows(angle, length), max_size=2)):
        rows.insert(draw(st.integers(0, len(rows))), row)
    return rows


@st.composite
def arms(draw, angle=angles, length=lengths, most=7, ends=poses, rows=None):
    """Arms of 1 to 7 joints in both conventions, some with fixed rows, a base and a tool."""
    end = st.none() if ends is None else st.none() | ends()
    return kl.Arm(draw(tables(angle, length, most) if rows is None else rows),
                  convention=draw(st.sampled_from(["standard", "modified"])),
                  base=draw(end), tool=draw(end))


@st.composite
def arms_and_q(draw, batch=None, **kinds):
    """An arm with joint values of shape (..., n): one pose, or a batch from a strategy."""
    arm = draw(arms(**kinds))
    shape = (*(() if batch is None else draw(batch)), arm.n)
    return arm, draw(arrays(float, shape, elements=st.floats(-3, 3, allow_subnormal=False)))


def flat(q):
    """The single poses of a batch, one row each."""
    return np.reshape(q, (-1, np.shape(q)[-1]))
