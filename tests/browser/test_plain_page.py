"""mount.js without Jupyter: the same frames and the same picture in a plain HTML page."""
import itertools

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from plain import LOAD, MOUNT, PAINTED, SOURCE
from reading import numbers, projected
from strategies import arms_and_q

import kinlab as kl
from kinlab.drawing import figure
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.scene import SPATIAL

COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)


def matrices(frames):
    """4x4 matrices from frames.js' lists of axes and origin."""
    T = np.tile(np.eye(4), (len(frames), 1, 1))
    T[:, :3, :] = np.swapaxes(np.array(frames), 1, 2)
    return T


def js_frames(page, scene, q):
    motions = scene.data()["motions"]
    return matrices(page.evaluate("([m, q]) => kinlab.frames(m, q)", [motions, list(q)]))


@course
def test_frames_equal_pythons(blank, robot):
    scene = arm_scene(robot())
    for q in np.random.default_rng(5).uniform(-4, 4, (20, robot().n)).tolist():
        np.testing.assert_allclose(js_frames(blank, scene, q), scene.frames(q), atol=1e-9)


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(arms_and_q())
def test_frames_of_any_arm_equal_pythons(blank, arm_and_q):
    arm, q = arm_and_q
    scene = arm_scene(arm)
    np.testing.assert_allclose(js_frames(blank, scene, q), scene.frames(q), atol=1e-9)


def mounted(page, arm, q, show=("frames", "labels")):
    """The arm's data, drawn in the page at joint values q."""
    view = kl.ArmView(arm, show=show, preset="3-D")
    page.evaluate(MOUNT, [view.scene, list(q)])
    return arm_scene(arm)


def assert_same_picture(page, scene, q, camera):
    """Every item's path is Python's outline of the same points, nearer bodies over farther."""
    seen, frames, near = page.evaluate(PAINTED), scene.frames(q), {}
    for item in scene.items:
        room = [frames[k][:3, :3] @ p + frames[k][:3, 3] for k, *p in item.points]
        points = projected(scene, room, camera)
        if item.body >= 0:
            near.setdefault(item.body, []).append(item.lift + points[:, 2].mean())
        if item.shape == "text":
            assert abs(seen["texts"][item.gid][0] - points[0, 0]) < 0.02
            assert abs(seen["texts"][item.gid][1] - points[0, 1]) < 6
        else:
            assert_same_path(item, seen["paths"][item.gid], points)
        if item.shape in ("face", "hull", "arrow"):
            assert seen["fills"][item.gid] != "none"
    under = [item.gid for item in scene.items if item.body < 0]
    bodies = {item.gid: item.body for item in scene.items if item.body >= 0}
    drawn = [gid for gid in seen["order"] if gid in {*under, *bodies}]
    assert drawn[:len(under)] == under
    heights = [np.mean(near[bodies[gid]]) for gid in drawn[len(under):]]
    assert np.all(np.diff(heights) >= -1e-9 * scene.radius)
    stays = [bodies[gid] for gid in drawn[len(under):]]
    assert sum(a != b for a, b in itertools.pairwise(stays)) == len(near) - 1


def assert_same_path(item, path, points):
    outline = figure.outline(item.shape, points)
    if item.shape == "face":
        x, y = points[:, 0], points[:, 1]
        area = np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))
        if abs(area) < 0.5:  # seen edge on: either way is right
            return
    if outline is None:
        assert path == ""
        return
    corners = numbers(path)
    if item.shape == "hull":  # equal hulls reach equally far in every direction
        turns = np.linspace(0, 2 * np.pi, 48)
        rays = np.stack([np.cos(turns), np.sin(turns)])
        np.testing.assert_allclose((corners @ rays).max(0), (outline @ rays).max(0), atol=0.03)
    elif item.shape == "trace":
        np.testing.assert_allclose(corners[-1], outline[-1], atol=0.25)
    else:
        np.testing.assert_allclose(corners, outline, atol=0.02)
    assert path.endswith("Z") == (item.shape in ("face", "hull"))


@course
def test_every_shape_is_drawn_as_matplotlib_would(page, robot):
    arm = robot()
    page.evaluate(LOAD, SOURCE)
    low_high = [(-3, 3) if link.kind == "revolute" else (0.1, 0.6) for link in arm.links]
    poses = np.random.default_rng(2).uniform(*np.array(low_high).T, (3, arm.n))
    scene = mounted(page, arm, arm.home, show=("frames", "labels", "axes", "trace", "ghost"))
    assert_same_picture(page, scene, arm.home, (-60, 24, 1))
    for name, q in zip(["Top", "Front", "Side"], poses.tolist()):
        page.evaluate("q => joints.write(q)", q)
        page.get_by_role("button", name=name, exact=True).click()
        assert_same_picture(page, scene, q, (*SPATIAL[name.lower()], 1))
    page.get_by_role("button", name="3-D", exact=True).click()
    picture = page.locator(".kl-picture")
    for key in [*["ArrowRight"] * 17, *["ArrowDown"] * 9, "+", "+"]:
        picture.press(key)
    q = poses[-1].tolist()
    assert_same_picture(page, scene, q, (-60 - 85, 24 - 45, 1.15**2))


@settings(max_examples=15, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(arms_and_q(most=5), st.sampled_from(["3-D", "Top", "Front", "Side"]))
def test_any_arm_is_drawn_as_matplotlib_would(blank, arm_and_q, preset):
    arm, q = arm_and_q
    scene = mounted(blank, arm, q)
    blank.get_by_role("button", name=preset, exact=True).click()
    angles = {name.lower(): camera for name, camera in SPATIAL.items()}[preset.lower()]
    assert_same_picture(blank, scene, q.tolist(), (*angles, 1))
    blank.evaluate("live.dismount()")


def test_dismount_cleans_up(page):
    page.evaluate(LOAD, SOURCE)
    page.evaluate("""() => {
        window.held = 0;
        const {addEventListener: add, removeEventListener: remove} = document;
        document.addEventListener = (...a) => { held++; add.apply(document, a); };
        document.removeEventListener = (...a) => { held--; remove.apply(document, a); };
    }""")
    arm = kl.robots.alpha_ii()
    mounted(page, arm, arm.home)
    assert page.evaluate("[listeners.size, held]") == [1, 1]
    page.get_by_role("button", name="Play").click()
    page.wait_for_function("joints.q[3] > -1.5 || joints.q[0] > 0.05")
    page.evaluate("live.dismount()")
    assert page.evaluate("[listeners.size, held, document.getElementById('arm').innerHTML]") == [
        0, 0, ""]
    before = page.evaluate("joints.q")
    page.wait_for_timeout(150)
    assert page.evaluate("joints.q") == before


def test_who_prefers_less_motion_gets_none(page):
    page.emulate_media(reduced_motion="reduce")
    page.evaluate(LOAD, SOURCE)
    arm = kl.robots.alpha_ii()
    mounted(page, arm, arm.home)
    page.evaluate("""() => {
        window.seen = new Set();
        listeners.add(() => seen.add(String(joints.q)));
    }""")
    page.get_by_role("button", name="Zero").click()
    page.wait_for_function("joints.q.every(q => q === 0)")
    assert page.evaluate("seen.size") == 1


def test_remarks_name_the_joints_at_their_limits(page):
    page.evaluate(LOAD, SOURCE)
    arm = kl.robots.cylindrical()
    mounted(page, arm, [0, 0.6, 0.3])
    remark = page.locator(".kl-remark")
    assert remark.inner_text() == "d₂ is at its limit, 0.6 m"
    page.evaluate("live.note('Well done')")
    assert remark.inner_text() == "Well done"
    page.evaluate("joints.write([0, 0.3, 0.1])")
    page.evaluate(PAINTED)
    assert remark.inner_text() == "d₃ is at its limit, 0.1 m"
    page.evaluate("joints.write([0, 0.3, 0.3])")
    page.evaluate(PAINTED)
    assert remark.inner_text() == ""


def test_a_screen_reader_hears_where_the_tool_is(page):
    page.evaluate(LOAD, SOURCE)
    arm = kl.robots.alpha_ii()
    mounted(page, arm, arm.home)
    page.wait_for_function("document.querySelector('svg').getAttribute('aria-label')")
    assert page.get_by_role("img").get_attribute("aria-label") == (
        "Alpha II, tool at 485.1, 0.0, 215.0 mm")
    assert "Arrow keys" in page.locator(".kl-picture").get_attribute("aria-label")


def touches(page):
    """A function that makes a touch screen's events, as Chromium gets them from the system."""
    wire = page.context.new_cdp_session(page)

    def touch(kind, *points):
        wire.send("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": [
            {"x": x, "y": y, "id": k} for k, (x, y) in enumerate(points)]})

    return touch


def test_one_finger_turns_the_picture_and_two_zoom_it(browser, watched):
    page = watched(browser.new_page(viewport={"width": 390, "height": 844}, has_touch=True))
    page.evaluate(LOAD, SOURCE)
    arm, touch = kl.robots.alpha_ii(), touches(page)
    scene = mounted(page, arm, arm.home)
    touch("Start", (150, 300))
    touch("Move", (190, 300))
    touch("Move", (190, 320))
    touch("End")
    assert_same_picture(page, scene, arm.home, (-60 - 20, 24 + 10, 1))
    touch("Start", (150, 300), (250, 300))
    touch("Move", (100, 300), (300, 300))
    touch("End")
    assert_same_picture(page, scene, arm.home, (-60 - 20, 24 + 10, 2))
    page.close()


def test_a_finger_on_a_flat_picture_scrolls_the_page(page):
    view = kl.lessons.rotation.axes_view()
    page.evaluate(LOAD, SOURCE)
    page.evaluate(MOUNT, [view.scene, [0.5]])
    assert page.locator(".kl-picture").evaluate("box => box.style.touchAction") == "pan-y"
