"""The lesson on homogeneous transforms: what its views draw, and where they begin."""
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import kinlab as kl

VIEWS = kl.lessons.homogeneous
close = np.testing.assert_allclose
angles = st.integers(-180, 180)


def plane(theta, x=0.0, y=0.0):
    c, s = np.cos(np.radians(theta)), np.sin(np.radians(theta))
    return np.array([[c, -s, x], [s, c, y], [0, 0, 1]])


@pytest.mark.parametrize("make", [VIEWS.order, VIEWS.fixed])
def test_motions_begin_at_the_start_and_go_in_steps(make):
    scene = make()._scene
    assert scene.begin == [0] and scene.knobs[0].whole
    assert scene.poses == ((0,), (1,), (2,))
    for origin, axis in scene.read([0]).values():
        close([*origin, *axis], [0, 0, 1, 0], atol=1e-12)


@pytest.mark.parametrize(("make", "ends"), [
    (VIEWS.order, {"A": plane(0, 2) @ plane(60), "B": plane(60) @ plane(0, 2)}),
    (VIEWS.fixed, {"A": plane(0, 2) @ plane(60), "F": plane(60) @ plane(0, 2)})])
def test_motions_end_where_the_products_say(make, ends):
    read = make()._scene.read([2])
    for name, T in ends.items():
        close(read[name], [T[:2, 2], T[:2, 0]], atol=1e-12)


@given(st.tuples(angles, angles, angles))
def test_the_arrows_of_a_chain_add_up_to_the_product(thetas):
    scene = VIEWS.chain()._scene
    *rows, c_0 = (vector for vector, in scene.read(np.radians(thetas)).values())
    one, two, three = (plane(theta, 1.2, 0.9) for theta in thetas)
    close(np.sum(rows, axis=0), c_0, atol=1e-12)
    close(c_0, (one @ two @ three @ [1.2, 0.9, 1])[:2], atol=1e-12)


@pytest.mark.parametrize("theta", [-90, 0, 30, 180])
def test_the_way_back_is_the_inverse(theta):
    read = VIEWS.seen_back()._scene.read([2, -0.5, np.radians(theta)])
    back = np.linalg.inv(plane(theta, 2, -0.5))
    close(read["o0"][0], back[:2, 2], atol=1e-12)
    close(read["c1"][0], (back @ [1, 2, 1])[:2], atol=1e-12)
