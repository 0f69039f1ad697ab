"""The views of the workspace lesson in a plain page: their curves follow the knobs."""
import numpy as np
import pytest
from plain import LOAD, MOUNT, PAINTED, SOURCE
from reading import numbers, projected
from test_workspace_lesson import LIMITS, tip

from kinlab.lessons import workspace

TOP = (-90, 90, 1)
MOVE = "q => { joints.write(q); }"


def mounted(page, view):
    page.evaluate(LOAD, SOURCE)
    page.evaluate(MOUNT, [view.scene, view._values.tolist()])
    return view._scene


def on_picture(scene, places):
    flat = np.column_stack([places, np.zeros(len(places))])
    return projected(scene, flat, TOP)[:, :2]


@pytest.mark.parametrize("ends", LIMITS)
def test_the_region_follows_its_limits(page, ends):
    scene = mounted(page, workspace.limits_view())
    low_1, high_1, low_2, high_2 = np.radians(ends)
    page.evaluate(MOVE, [low_1, high_1, low_2, high_2, 0.25, 0.75])
    paths = page.evaluate(PAINTED)["paths"]
    turns = np.linspace(low_1, high_1, 41)
    bends = np.linspace(low_2, high_2, 29)
    arm = tip(0.75 * low_1 + 0.25 * high_1, 0.25 * low_2 + 0.75 * high_2)
    for name, places in {"bend-0": tip(turns, low_2), "bend-8": tip(turns, high_2),
                         "turn-0": tip(low_1, bends), "turn-8": tip(high_1, bends),
                         "straightest": tip(turns, max(low_2, 0))}.items():
        drawn = numbers(paths[name])
        np.testing.assert_allclose(drawn, on_picture(scene, places), atol=0.01, err_msg=name)
    np.testing.assert_allclose(numbers(paths["link-2"])[1], on_picture(scene, [arm])[0], atol=0.01)


def test_the_trace_is_where_the_tool_went(page):
    scene = mounted(page, workspace.ring_view())
    assert not page.locator("#trace").is_visible()
    page.get_by_role("button", name="Trace").click()
    poses = np.array(workspace.ring_view().scene["poses"])
    for q in poses:
        page.evaluate(MOVE, q.tolist())
        page.evaluate(PAINTED)
    assert page.locator("#trace").is_visible()
    drawn = numbers(page.evaluate(PAINTED)["paths"]["trace"])
    went = on_picture(scene, tip(poses[:, 0], poses[:, 1]))
    assert all(np.abs(drawn - place).max(axis=1).min() < 0.01 for place in went)
