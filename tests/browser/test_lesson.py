"""The lessons as a student meets them: Run All in JupyterLab, a prediction, a hand on a slider."""
from pathlib import Path

import numpy as np
import pytest
from reading import from_units, read, settle, take

import kinlab as kl

LESSONS = Path(__file__).parents[2] / "notebooks"


@pytest.mark.parametrize("name, robot, shown", [
    ("07_alpha_ii", kl.robots.alpha_ii, [90, 0, 0, -90, 0])])
def test_a_lesson_runs_and_its_first_arm_moves_once_it_is_predicted(
        notebook, name, robot, shown):
    page = notebook(LESSONS / f"{name}.ipynb")
    view = page.locator(".jp-Notebook:visible .kl-view").first
    view.get_by_role("button", name="Commit").wait_for()
    assert not view.get_by_role("slider", name="base").is_visible()
    view.get_by_role("button", name="I do not know").click()
    view.get_by_role("slider", name="shoulder").wait_for()
    page.wait_for_function("view => view.querySelector('.kl-field').value === '90.0'",
                           arg=view.element_handle())
    before = read(view)["readouts"][:5]
    np.testing.assert_allclose(before, shown, atol=0.051)
    x, y = take(view.get_by_role("slider", name="shoulder"))
    for step in range(1, 9):
        page.mouse.move(x - 5 * step, y)
        settle(page)
    page.mouse.up()
    seen = read(view)
    assert seen["readouts"][1] < before[1] - 5
    q = from_units(robot, seen["readouts"][:5])
    tip = kl.forward_kinematics(robot(), q)[:3, 3]
    np.testing.assert_allclose([row[-1] for row in seen["cells"][:3]], tip, atol=1)
