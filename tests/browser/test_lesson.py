"""The lessons as a student meets them: Run All in JupyterLab, then a hand on a slider."""
from pathlib import Path

import numpy as np
import pytest
from reading import assert_picture, from_units, read, scene_of, settle, take, wait_for_kernel

import kinlab as kl

LESSONS = Path(__file__).parents[2] / "notebooks"


@pytest.mark.parametrize("name, robot", [("07_alpha_ii", kl.robots.alpha_ii)])
def test_a_lesson_runs_and_its_first_arm_moves(live, name, robot):
    (view,) = live(LESSONS / f"{name}.ipynb")
    page = view.page
    before = read(view)["readouts"]
    x, y = take(view.get_by_role("slider").nth(1))
    for step in range(1, 9):
        page.mouse.move(x - 5 * step, y)
        settle(page)
    page.mouse.up()
    seen = read(view)
    assert seen["readouts"][1] < before[1] - 5
    q = wait_for_kernel(page, robot, seen["readouts"])
    np.testing.assert_allclose(q, from_units(robot, seen["readouts"]), atol=1e-9)
    assert_picture(seen, robot, q, (*scene_of(robot).presets["3-D"], 1))
