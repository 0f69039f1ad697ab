"""Each of the course's arms in a real JupyterLab: what is drawn is what kinematics says."""
import numpy as np
import pytest
from grades import chosen
from lab import run_code
from reading import (
    assert_picture,
    assert_table,
    from_units,
    in_units,
    read,
    scene_of,
    settle,
    take,
    wait_for_kernel,
)

import kinlab as kl

COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
WATCH = """(view, k) => {
    const field = view.querySelectorAll('.kl-field')[k], values = new Set();
    const range = view.querySelectorAll('[type=range]')[k];
    const tool = view.querySelector('#tool path'), pictures = new Set();
    new MutationObserver(() => values.add(field.value)).observe(
        range, {attributeFilter: ['aria-valuetext']});
    new MutationObserver(() => pictures.add(tool.getAttribute('d'))).observe(
        tool, {attributes: true});
    window.watched = () => [[...values], [...pictures]];
}"""


def check(view, robot, camera):
    """The picture and the table agree with the sliders' values; those values."""
    seen = read(view)
    q = from_units(robot, seen["readouts"])
    decimals = 3 if robot().unit == "m" else 1
    assert_picture(seen, robot, q, camera)
    assert_table(seen, robot, q, decimals)
    return np.array(seen["readouts"])


@pytest.mark.parametrize("robot", chosen(
    COURSE, ["intelledex_660t"], [robot.__name__ for robot in COURSE]))
def test_sliders_move_the_arm_as_kinematics_says(live, robot):
    arm, name = robot(), robot.__name__
    (view,) = live(f"import kinlab as kl\nview = kl.ArmView(kl.robots.{name}())\nview")
    page = view.page
    camera = (*scene_of(robot).presets["top" if name == "two_link" else "3-D"], 1)
    assert run_code(page, "print(kl.__file__)").strip() == kl.__file__
    values = check(view, robot, camera)
    np.testing.assert_allclose(values, in_units(robot, arm.home), atol=1e-9)
    steps = [1 if link.kind == "revolute" else 0.01 for link in arm.links]
    for i, handle in enumerate(view.get_by_role("slider").all()):
        handle.focus()
        for key in ("ArrowRight", "ArrowUp", "ArrowRight", "ArrowLeft", "ArrowRight"):
            page.keyboard.press(key)
        values[i] += 3 * steps[i]
        np.testing.assert_allclose(check(view, robot, camera), values, atol=1e-9)
    q = wait_for_kernel(page, robot, values)
    np.testing.assert_allclose(in_units(robot, q), values, atol=1e-9)

    drag(page, view, -1, 80)
    moved = check(view, robot, camera)
    assert moved[-1] > values[-1] + 3 * steps[-1]
    np.testing.assert_allclose(moved[:-1], values[:-1], atol=1e-9)
    q = wait_for_kernel(page, robot, moved)
    np.testing.assert_allclose(in_units(robot, q), moved, atol=1e-9)


def drag(page, view, k, distance, steps=8):
    """Drag slider k's handle by some pixels, with a painted frame after each small move."""
    x, y = take(view.get_by_role("slider").nth(k))
    for step in range(1, steps + 1):
        page.mouse.move(x + distance * step / steps, y)
        settle(page)
    page.mouse.up()


def test_every_step_of_a_drag_is_drawn(live):
    (view,) = live("import kinlab as kl\nview = kl.ArmView(kl.robots.alpha_ii())\nview")
    page = view.page
    view.evaluate(WATCH, 1)
    drag(page, view, 1, -60, steps=30)
    values, pictures = page.evaluate("window.watched()")
    assert len(values) >= 20 and len(pictures) == len(values)
    assert all(value.endswith(".0") for value in values)
