"""The lesson on translation: what its views draw, and what else must count as right."""
from functools import cache

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from solved.translation import B, K, P

import kinlab as kl

VIEWS = kl.lessons.translation
# Made once: drawing a view takes longer than all that is asked of it.
sliding, riding, chained = map(cache, (VIEWS.sliding_view, VIEWS.riding_view, VIEWS.chain_view))
slides = st.floats(-2, 2)


def drawn(view, **values):
    """Where the items of a view stand in the room's plane, by their gid, with its knobs set."""
    for name, value in values.items():
        view[name].value = value
    frames = view._scene.frames(view._values)
    return {item.gid: np.array([(frames[k] @ (*local, 1))[:2] for k, *local in item.points])
            for item in view._scene.items}


@given(slides, slides)
def test_the_point_stays_while_the_frame_slides(x, y):
    view = sliding()
    at = drawn(view, o_x=x, o_y=y)
    assert np.allclose(at["arrow-o"], [[0, 0], [x, y]])
    assert np.allclose(at["arrow-c1"], [[x, y], [1, 2]])
    assert np.allclose(at["arrow-c0"], [[0, 0], [1, 2]])
    assert np.allclose(at["legs-c1"], [[x, y], [1, y], [1, 2]])
    assert np.allclose(at["point-c"], [1, 2], atol=0.01)
    assert np.allclose(view.readings["c0"], [[x, y], [1 - x, 2 - y], [1, 2]])


@given(slides, slides)
def test_the_point_rides_with_the_frame(x, y):
    view = riding()
    at = drawn(view, o_x=x, o_y=y)
    assert np.allclose(at["arrow-c1"], [[x, y], [x + 1, y + 2]])
    assert np.allclose(at["arrow-c0"], [[0, 0], [x + 1, y + 2]])
    assert np.allclose(at["legs-c1"], [[x, y], [x + 1, y], [x + 1, y + 2]])
    assert np.allclose(view.readings["c0"], [[x, y], [1, 2], [x + 1, y + 2]])


@given(slides, slides, slides, slides)
def test_both_orders_of_two_slides_end_in_frame_2(x, y, u, v):
    view = chained()
    at = drawn(view, o1_x=x, o1_y=y, o2_x=u, o2_y=v)
    end = [x + u, y + v]
    assert np.allclose(at["arrow-o2"], [[x, y], end])
    assert np.allclose(at["arrow-sum"], [[0, 0], end])
    assert np.allclose(at["other-order"], [[0, 0], [u, v], end])
    assert np.allclose(view.readings["o2"], [[x, y], [u, v], end])
    assert np.allclose(view.readings["other"], [[u, v], [x, y], end])


@pytest.mark.parametrize("answer", [
    sp.Matrix(K - B + P), tuple(K + P - B), [sp.expand(2 * part) / 2 for part in K + P - B]])
def test_expressions_count_in_any_equivalent_form(answer):
    assert kl.exercises.check("translation.2", answer).ok


def test_numbers_count_in_any_container():
    assert kl.exercises.check("translation.1", sp.Matrix([[1, 3], [-2, 3], [-3, 1]])).ok
    assert kl.exercises.check("translation.3", (sp.Integer(1), 2.0)).ok
