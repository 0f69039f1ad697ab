"""Charts: which decades, which ticks, how far the curves go; in the browser and in the still."""
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import kinlab as kl
from kinlab.drawing.chart import Chart, Curve, plot
from kinlab.drawing.chart_marks import HEIGHT, chart_marks

close = np.testing.assert_allclose
SIZE = (264.0, 236.0)  # leaves 200 by 160 px for the curves


def chart(*values, **options):
    curves = [Curve(f"curve {k}", ("first", "second")[k], ("dot", "square")[k], tuple(row))
              for k, row in enumerate(values)]
    return Chart(tuple(curves), "step", "error (m)", **options)


@pytest.mark.parametrize("values, decades", [
    ([0.5, 0.02], (-2, 0)), ([1.52, 3e-10], (-10, 1)), ([400, 30], (1, 3)),
    ([1.0], (-1, 0)), ([10, 1], (0, 1)), ([0, 0], (-1, 0)), ([0.3, 0], (-1, 0))])
def test_the_decades_are_those_that_occur(values, decades):
    assert chart(values).decades == decades


def test_a_curve_by_hand():
    laid = plot(chart([100, 1, 0.01]), SIZE, [1.5])
    assert laid.box == (48, 34, 248, 194)
    assert [text for _, text in laid.up] == ["10²", "10¹", "10⁰", "10⁻¹", "10⁻²"]
    close([y for y, _ in laid.up], [34, 74, 114, 154, 194])
    assert laid.across == ((48, "0"), (148, "1"), (248, "2"))
    (track,) = laid.tracks
    close(track.gone, [(48, 34), (148, 114), (198, 154)])
    close(track.markers, [(48, 34), (148, 114)])


def test_a_shorter_curve_stops_at_its_end_and_zero_lies_at_the_bottom():
    laid = plot(chart([1, 0.1, 0], [1, 1, 1, 1, 1]), SIZE, [4.0])
    (ended, whole), bottom = laid.tracks, laid.box[3]
    close(ended.gone[-1], (48 + 2 / 4 * 200, bottom))
    assert len(ended.gone) == 3
    close(whole.gone[-1], (248, 34))


@given(st.lists(st.floats(1e-12, 1e4), min_size=1, max_size=80), st.floats(-2, 90),
       st.floats(300, 1500), st.floats(170, 500))
def test_it_stays_in_its_frame(values, step, width, height):
    laid = plot(chart(values), (width, height), [step])
    left, top, right, bottom = laid.box
    places = [place for track in laid.tracks
              for place in (*track.gone, *track.markers)]
    for x, y in places:
        assert left - 1e-6 <= x <= right + 1e-6 and top - 1e-6 <= y <= bottom + 1e-6
    for ticks, least in ((laid.across, 34), (laid.up, 24)):
        assert all(np.diff([place for place, _ in ticks]) >= least - 1e-6)


def test_the_names_do_not_meet_the_title():
    long = (Curve("pseudoinverse", "first", "dot", (1.0, 0.1)),
            Curve("transpose", "second", "square", (1.0, 0.5)))
    (first, _), (second, _) = plot(Chart(long, "step", "error (mm)"), (330, 200), [0.0]).legend
    assert first > 4 + 7 * len("error (mm)") and second > first + 26 + 7 * len("pseudoinverse")


def test_two_curves_are_told_apart_without_colour():
    scene = kl.solve_view(kl.robots.two_link(), [0.5, 1, 0], [0.2, 0.4])._scene
    one, other = scene.chart.curves
    assert one.marker != other.marker
    dashes = ["stroke-dasharray" in scene.data()["paints"][curve.style] for curve in (one, other)]
    assert dashes == [False, True]


def test_the_still_picture_has_the_same_points():
    told, q = chart([100, 1, 0.01], [100, 50, 20]), [0.5]
    frame, *curves = chart_marks(told, q, (580.0, 520.0))
    for drawn, track in zip(curves, plot(told, (580.0, HEIGHT), q).tracks):
        gone = drawn.marks[0]
        close(gone.lines[0], np.array(track.gone) + [0, 520])
    said = [mark.text for mark in frame.marks if mark.text]
    assert {"error (m)", "step", "10⁰", "0", "2"} <= set(said)
