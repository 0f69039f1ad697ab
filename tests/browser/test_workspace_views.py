"""The views of the workspace lesson in a plain page: their curves follow the knobs."""
import numpy as np
import pytest
from grades import every
from plain import LOAD, MOUNT, PAINTED, SOURCE
from reading import numbers
from test_workspace_lesson import LIMITS, tip

import kinlab as kl
from kinlab.lessons import workspace

MOVE = "q => { joints.write(q); }"
PIXELS = 0.25  # coordinates are written to a tenth, and so are the two points of the ruler
# Pixels of the page to each of the SVG's, and the smallest letters.
SIZES = """() => [...document.querySelectorAll('svg')].map(svg => {
    const box = svg.getBoundingClientRect();
    const [,, wide, high] = svg.getAttribute('viewBox').split(' ');
    const letters = [...svg.querySelectorAll('text')].map(
        text => parseFloat(getComputedStyle(text).fontSize));
    return {scale: [box.width / wide, box.height / high], side: Math.min(box.width, box.height),
            least: Math.min(...letters)};
})"""
CHART = """() => Object.fromEntries([...document.querySelectorAll('[data-curve]')].map(g => [
    g.dataset.curve, Object.fromEntries([...g.children].map(
        path => [path.dataset.part, path.getAttribute('d')]))]))"""


def mounted(page, view):
    page.evaluate(LOAD, SOURCE)
    page.add_style_tag(content=view._css)
    page.evaluate(MOUNT, [view.scene, view._values.tolist()])
    page.evaluate(PAINTED)


def ruler(paths, arm):
    """Where places of the plane are drawn, told from O and Q: x to the right, y up, alike."""
    (o, q), length = (numbers(paths[f"point-{name}"])[0] for name in "OQ"), np.linalg.norm(arm)
    scale = np.linalg.norm(q - o) / length
    np.testing.assert_allclose(q - o, scale * arm * [1, -1], atol=PIXELS)
    return lambda places: o + scale * np.asarray(places) * [1, -1]


@pytest.mark.parametrize("ends", LIMITS)
def test_the_region_follows_its_limits(page, ends):
    mounted(page, workspace.limits_view())
    low_1, high_1, low_2, high_2 = np.radians(ends)
    page.evaluate(MOVE, [low_1, high_1, low_2, high_2, 0.25, 0.75])
    paths = page.evaluate(PAINTED)["paths"]
    arm = tip(0.75 * low_1 + 0.25 * high_1, 0.25 * low_2 + 0.75 * high_2)
    drawn = ruler(paths, arm)
    for name, (place, low, high) in {
            "bend-0": (lambda turn: tip(turn, low_2), low_1, high_1),
            "bend-8": (lambda turn: tip(turn, high_2), low_1, high_1),
            "turn-0": (lambda bend: tip(low_1, bend), low_2, high_2),
            "turn-8": (lambda bend: tip(high_1, bend), low_2, high_2),
            "straightest": (lambda turn: tip(turn, max(low_2, 0)), low_1, high_1)}.items():
        curve = numbers(paths[name])
        assert len(curve) > (high - low) / np.radians(3)
        np.testing.assert_allclose(curve, drawn(place(np.linspace(low, high, len(curve)))),
                                   atol=2 * PIXELS, err_msg=name)


def test_the_trace_is_where_the_tool_went(page):
    mounted(page, workspace.ring_view())
    assert not page.locator("#trace").is_visible()
    page.get_by_role("button", name="Trace").click()
    poses = np.array(workspace.ring_view().scene["poses"])
    for q in poses:
        page.evaluate(MOVE, q.tolist())
        page.evaluate(PAINTED)
    assert page.locator("#trace").is_visible()
    paths = page.evaluate(PAINTED)["paths"]
    went = ruler(paths, tip(*poses[-1, :2]))(tip(poses[:, 0], poses[:, 1]))
    trace = numbers(paths["trace"])
    assert all(np.abs(trace - place).max(axis=1).min() < 2 * PIXELS for place in went)


def test_a_plane_cuts_the_cloud_open(page):
    """Without the slice all dots are there; the section is that of the knob's side."""
    mounted(page, workspace.reach_view())
    dots = "() => [...document.querySelectorAll('#cloud path')].map(p => p.getAttribute('d'))"
    page.evaluate(PAINTED)
    cut = sum(path.count("M") for path in page.evaluate(dots))
    page.get_by_role("button", name="Slice").click()
    page.evaluate(PAINTED)
    whole = sum(path.count("M") for path in page.evaluate(dots))
    assert 0.35 * whole < cut < 0.65 * whole
    page.get_by_role("button", name="Slice").click()
    for degrees, name in ((0, "front"), (29, "front"), (31, "right"), (-40, "left")):
        page.evaluate(f"joints.write([...joints.q.slice(0, 5), {np.radians(degrees)}])")
        page.evaluate(PAINTED)
        there = {side for side in ("front", "left", "right")
                 if page.locator(f"#{side}-section").is_visible()}
        assert there == {name}


@pytest.mark.parametrize("width", every(3, [340, 390, 720, 820, 1000, 1100, 1280, 1920]))
def test_words_of_a_chart_are_as_large_at_every_width(page, width):
    page.set_viewport_size({"width": width, "height": 900})
    view = kl.solve_view(kl.robots.two_link(), [0.5, 1, 0], [0.2, 0.1])
    mounted(page, view)
    page.evaluate(MOVE, [2])
    page.wait_for_function("() => document.querySelector('.kl-chart svg text')")
    page.evaluate(PAINTED)
    picture, plot = page.evaluate(SIZES)
    np.testing.assert_allclose(picture["scale"], np.clip(picture["side"] / 620, 1, 1.6), atol=0.02)
    np.testing.assert_allclose(plot["scale"], 1, atol=0.02)
    assert min(picture["least"], plot["least"]) >= 12
    chart = page.locator(".kl-chart").bounding_box()
    assert chart["width"] > 280 and chart["x"] + chart["width"] <= width


def test_a_curve_is_drawn_as_far_as_the_step(page):
    view = kl.solve_view(kl.robots.two_link(), [0.5, 1, 0], [0.2, 0.1])
    mounted(page, view)
    page.wait_for_function("() => document.querySelector('.kl-chart svg text')")
    lengths = {curve.name: len(curve.values) for curve in view._scene.chart.curves}
    for step in (0, 3, 5.5, lengths["newton"] - 1):
        page.evaluate(MOVE, [step])
        page.evaluate(PAINTED)
        chart = page.evaluate(CHART)
        for name, count in lengths.items():
            assert len(numbers(chart[name]["gone"])) == 1 + np.ceil(min(step, count - 1))
        way = numbers(page.evaluate(PAINTED)["paths"]["newton-path"])
        assert len(way) == 1 + np.ceil(step)
