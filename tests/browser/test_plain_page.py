"""mount.js without Jupyter: the same frames and the same picture in a plain HTML page."""
from dataclasses import replace

import numpy as np
import pytest
from grades import every
from hypothesis import HealthCheck, given, settings
from painted import STYLE, TELL, assert_same, pythons, strokes
from plain import LOAD, MOUNT, PAINTED, SOURCE
from reading import SETTLE
from strategies import arms_and_q

import kinlab as kl
from kinlab.arms.joints import joint_ranges
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.scene import AXIS, SOLIDS

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
    return matrices(page.evaluate("([m, q]) => kinlab.frames(m, q)",
                                  [motions, list(scene.places(q))]))


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
    return arm_scene(arm, preset="3-D")


def assert_seen_from(page, azimuth, elevation, zoom):
    """Where the view is seen from, after what was asked for has been painted."""
    page.evaluate(SETTLE)
    seen = page.evaluate("live.picture.camera")
    assert [seen[name] for name in ("azimuth", "elevation", "zoom")] == pytest.approx(
        [azimuth, elevation, zoom])


def assert_same_bodies(page, scene, q, side):
    """The view's solids and arrows are those that `still` paints from this side."""
    assert_seen_from(page, *side, 1)
    drawn = {item.gid for item in scene.items if item.shape in (*SOLIDS, AXIS)}
    here = replace(scene, presets={**scene.presets, "here": side})
    size = page.evaluate("live.picture.size")
    both = strokes(page.evaluate(TELL)), pythons(here, q, "here", size=size)
    assert_same(*([one for one in hand if one.group in drawn] for hand in both))


@pytest.mark.parametrize("robot", every(3, COURSE, [robot.__name__ for robot in COURSE]))
def test_buttons_keys_and_joints_lead_to_python_s_picture(page, robot):
    arm = robot()
    page.evaluate(LOAD, SOURCE)
    page.add_style_tag(content=STYLE)
    scene, (low, high) = mounted(page, arm, arm.home), joint_ranges(arm)
    assert_same_bodies(page, scene, arm.home, (-60, 24))
    q = np.random.default_rng(2).uniform(low, high).tolist()
    page.evaluate("q => joints.write(q)", q)
    page.evaluate("live.look('front')")
    assert_same_bodies(page, scene, q, (-90, 0))
    page.evaluate("live.look('3-D')")
    for key in [*["ArrowRight"] * 17, *["ArrowDown"] * 9]:
        page.locator(".kl-picture").press(key)
    assert_same_bodies(page, scene, q, (-60 - 85, 24 - 45))


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
    page.evaluate("joints.write([-Math.PI, 0.3, 0.3])")
    page.evaluate(PAINTED)
    assert remark.inner_text() == "θ₁ is at its limit, −180°"
    page.evaluate("joints.write([-1e-9, 0.3, 0.3])")
    page.evaluate(PAINTED)
    assert remark.inner_text() == ""
    assert page.locator(".kl-field").first.input_value() == "0.0"


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
    mounted(page, arm, arm.home)
    touch("Start", (150, 300))
    touch("Move", (190, 300))
    touch("Move", (190, 320))
    touch("End")
    assert_seen_from(page, -60 - 20, 24 + 10, 1)
    touch("Start", (150, 300), (250, 300))
    touch("Move", (100, 300), (300, 300))
    touch("End")
    assert_seen_from(page, -60 - 20, 24 + 10, 2)
    page.close()


def test_a_finger_on_a_flat_picture_scrolls_the_page(page):
    view = kl.lessons.rotation.axes_view()
    page.evaluate(LOAD, SOURCE)
    page.evaluate(MOUNT, [view.scene, [0.5]])
    assert page.locator(".kl-picture").evaluate("box => box.style.touchAction") == "pan-y"
