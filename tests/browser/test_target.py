"""The target in the browser: the joints follow it, by the pointer and by the keys."""
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from plain import LOAD, MOUNT, SOURCE
from reading import kernel_q, middle, settle, wait_for_kernel
from test_plain_page import COURSE, js_frames

import kinlab as kl

REACH = "([scene, q, goal]) => kinlab.reach(scene, q, goal)"
# A target drawn along a straight line in fifty steps, as a hand does: the last solve.
DRAW = """([scene, q, from, to]) => {
    let found;
    for (let k = 0; k <= 50; k++) {
        const goal = from.map((v, i) => v + k / 50 * (to[i] - v));
        scene.target.knobs.forEach((knob, i) => { q[knob] = goal[i]; });
        found = kinlab.reach(scene, q, goal);
        q = found.q;
    }
    return found;
}"""
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)
few = settings(max_examples=30, suppress_health_check=[HealthCheck.function_scoped_fixture])


def ranges(view):
    joints = view.scene["knobs"][:view.arm.n]
    return np.array([[joint["low"], joint["high"]] for joint in joints]).T


@few
@given(robot=st.sampled_from(COURSE), seed=st.integers(0, 10**6))
def test_frames_of_velocities_and_tracks_equal_pythons(blank, robot, seed):
    arm, rng = robot(), np.random.default_rng(seed)
    q = rng.uniform(-3, 3, arm.n)
    scene = kl.velocity_view(arm)._scene
    np.testing.assert_allclose(js_frames(blank, scene, q), scene.frames(q), rtol=1e-9, atol=1e-9)


def test_frames_of_a_solve_equal_pythons(blank):
    scene = kl.solve_view(kl.robots.two_link(), [0.5, 1, 0], [0.2, 0.4])._scene
    for step in (-1, 0, 0.3, 1, 2.5, 99):
        np.testing.assert_allclose(js_frames(blank, scene, [step]), scene.frames([step]), atol=1e-9)


@course
def test_the_browser_never_claims_what_forward_kinematics_denies(blank, robot):
    """From anywhere to anywhere: within the limits, no error hidden, none made larger."""
    view, rng = kl.TargetView(robot()), np.random.default_rng(3)
    low, high = ranges(view)
    for _ in range(20):
        q = low + rng.random(view.arm.n) * (high - low)
        goal = rng.uniform(-1.5, 1.5, 3) * view._scene.radius
        if len(view._scene.presets) == 1:
            goal[2] = view.T[2, 3]
        values = [*q.tolist(), *goal[:view._axes].tolist()]
        found = blank.evaluate(REACH, [view.scene, values, goal.tolist()])
        end = np.array(found["q"][:view.arm.n])
        assert np.all((end >= low - 1e-9) & (end <= high + 1e-9))
        miss = np.linalg.norm(kl.forward_kinematics(view.arm, end)[:3, 3] - goal)
        assert found["error"] == pytest.approx(miss, abs=1e-9 * view._scene.radius)
        began = np.linalg.norm(kl.forward_kinematics(view.arm, q)[:3, 3] - goal)
        assert found["error"] <= began * (1 + 1e-9)


@pytest.mark.parametrize("robot", [r for r in COURSE if r is not kl.robots.alpha_ii],
                         ids=lambda robot: robot.__name__)
def test_a_dragged_target_is_reached(blank, robot):
    view, rng = kl.TargetView(robot()), np.random.default_rng(4)
    low, high = ranges(view)
    home = view.T[:3, 3]
    ends = kl.forward_kinematics(view.arm, low + rng.random((10, view.arm.n)) * (high - low))
    for end in ends[:, :3, 3]:
        end = np.where(np.arange(3) < view._axes, end, home)
        start = np.concatenate([view.q, home[:view._axes]])
        found = blank.evaluate(DRAW, [view.scene, *map(list, (start, home, end))])
        assert found["error"] < 1e-6 * view._scene.radius


def test_a_joint_at_its_limit_leaves_the_work_to_the_others(blank):
    arm = kl.Arm([kl.revolute(a=1, limits=(-0.5, 0.5)), kl.revolute(a=1), kl.revolute(a=0.5)])
    view = kl.TargetView(arm, q=[0.5, 0.6, 0.4])
    goal = kl.forward_kinematics(arm, [0.5, 2.0, 0.2])[:3, 3].tolist()
    found = blank.evaluate(REACH, [view.scene, [*view.q, *goal[:2]], goal])
    assert found["error"] < 1e-6 and found["steps"] < 30


def test_a_stretched_arm_folds(blank):
    """Its Jacobian cannot shorten it: without a push it would stay."""
    view = kl.TargetView(kl.robots.two_link(), q=[0, 0])
    found = blank.evaluate(REACH, [view.scene, [0, 0, 1.2, 0], [1.2, 0, 0]])
    assert found["error"] < 1e-6


def test_home_and_joints_take_the_target_along(page):
    view = kl.TargetView(kl.robots.two_link())
    page.evaluate(LOAD, SOURCE)
    start = [*view.q.tolist(), *view.target[:2].tolist()]
    page.evaluate(MOUNT, [view.scene, start])
    page.evaluate("joints.write([0, Math.PI / 2, ...joints.q.slice(2)])")
    np.testing.assert_allclose(page.evaluate("joints.q.slice(2)"), [1, 1], atol=1e-12)
    page.evaluate("joints.write([...joints.q.slice(0, 2), 0.5, 1.2])")
    q = page.evaluate("joints.q")
    np.testing.assert_allclose(kl.forward_kinematics(view.arm, q[:2])[:2, 3], [0.5, 1.2], atol=1e-6)
    page.get_by_role("button", name="Home").click()
    page.wait_for_function("q => joints.q.every((v, k) => Math.abs(v - q[k]) < 1e-9)", arg=start)


def joints_of(view, n):
    """What the fields of the joints show."""
    return [float(field.input_value()) for field in view.locator(".kl-field").all()[:n]]


def test_drag_the_target_in_jupyterlab(live):
    (view,) = live("import kinlab as kl\nview = kl.TargetView(kl.robots.two_link())\nview")
    page, arm = view.page, kl.robots.two_link()
    before, (x, y) = kernel_q(page), middle(view.locator("#target-0"))
    first, second = (middle(view.locator(f"#joint-{k}")) for k in (1, 2))
    scale = np.hypot(*np.subtract(second, first))   # pixels to a metre, as long as link 1
    page.mouse.move(x, y)
    page.mouse.down()
    for k in range(1, 21):
        page.mouse.move(x - 5 * k, y + 3 * k)
    settle(page)
    right, down = middle(view.locator("#target-0"))
    assert abs(right - (x - 100)) < 1.5 and abs(down - (y + 60)) < 1.5
    tool = middle(view.locator("#tool"))
    assert np.hypot(tool[0] - right, tool[1] - down) < 2
    assert "error |p* − p| = 0.000 m after" in view.locator(".kl-readings").inner_text()
    page.mouse.up()
    after = wait_for_kernel(page, kl.robots.two_link, joints_of(view, 2))
    assert np.max(np.abs(after - before)) > 0.1
    moved = kl.forward_kinematics(arm, after)[:2, 3] - kl.forward_kinematics(arm, before)[:2, 3]
    np.testing.assert_allclose(moved, np.array([-100, -60]) / scale, atol=2 / scale)


def test_the_keys_move_the_target_too(live):
    """Straight back from the stretched arm, whose Jacobian cannot shorten it."""
    (view,) = live("import kinlab as kl\nview = kl.TargetView(kl.robots.alpha_ii())\nview")
    page, arm = view.page, kl.robots.alpha_ii()
    before = kl.forward_kinematics(arm, kernel_q(page))[:3, 3]
    slider = view.get_by_role("slider").nth(arm.n)
    slider.focus()
    for _ in range(3):
        slider.press("ArrowDown")
    settle(page)
    after = wait_for_kernel(page, kl.robots.alpha_ii, joints_of(view, arm.n))
    moved = kl.forward_kinematics(arm, after)[:3, 3] - before
    assert -36 < moved[0] < -20 and np.max(np.abs(moved[1:])) < 1e-3


def test_a_drag_beside_the_target_turns_the_picture(live):
    (view,) = live("import kinlab as kl\nview = kl.TargetView(kl.robots.alpha_ii())\nview")
    page, before = view.page, kernel_q(view.page)
    ring = view.locator("#target-0 path").get_attribute("d")
    box = view.locator(".kl-picture").bounding_box()
    page.mouse.move(box["x"] + 30, box["y"] + 30)
    page.mouse.down()
    page.mouse.move(box["x"] + 90, box["y"] + 50)
    page.mouse.up()
    settle(page)
    assert view.locator("#target-0 path").get_attribute("d") != ring
    np.testing.assert_allclose(kernel_q(page), before)
