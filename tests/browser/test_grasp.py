"""What can be grasped in a picture: links, the arm's tip, points, origins and axes of frames."""
import numpy as np
import pytest
from plain import LOAD, MOUNT, SOURCE
from playwright.sync_api import expect
from reading import SETTLE, kernel_q, middle, settle

import kinlab as kl
from kinlab.browser import bundle

# Where points of the room are on the page, as the picture's camera sees them now.
SEEN = """points => {
    const { svg, lens } = live.picture, page = svg.getScreenCTM();
    return points.map(point => {
        const [x, y] = lens.see(point), { x: right, y: down } = new DOMPoint(x, y)
            .matrixTransform(page);
        return [right, down];
    });
}"""
HAND = "document.querySelector('.kl-picture').dataset.hand"


@pytest.fixture(scope="module")
def desk(browser):
    """A page with the style of a plain page, for one view after another."""
    page = browser.new_page(viewport={"width": 1100, "height": 900})
    prepare(page)
    yield page
    page.close()


def prepare(page):
    page.evaluate(LOAD, SOURCE)
    page.add_style_tag(content=bundle.page_style())


class Shown:
    """A view in a page, and a hand on it."""

    def __init__(self, page, view, q=None, side=None):
        self.page, self.scene = page, view._scene
        page.evaluate("window.live?.dismount()")
        page.evaluate(MOUNT, [view.scene, self.scene.begin if q is None else list(q)])
        page.wait_for_timeout(50)
        if side:
            page.get_by_role("button", name=side, exact=True).click()
        settle(page)

    @property
    def q(self):
        return np.array(self.page.evaluate("joints.q"))

    def seen(self, *points):
        return np.array(self.page.evaluate(SEEN, [np.asarray(p)[:3].tolist() for p in points]))

    def place(self, frame, local=(0, 0, 0), q=None):
        """A point of a frame in the room, by Python's frames."""
        return (self.scene.frames(self.q if q is None else q)[frame] @ [*local, 1])[:3]

    def skin(self, gid, share=0.5):
        """A tube's frame, and the point on its side towards the viewer, so far along, there."""
        item = next(item for item in self.scene.items if item.gid == gid)
        (start, *a), (frame, *b) = item.points[:2]
        if item.shape == "box":                       # a rod, near its end
            return frame, np.array(b) - [0, 0, self.scene.fit.thick]
        assert start == frame
        near = np.array(self.page.evaluate("live.picture.lens.near"))
        middle = np.array(a) + share * np.subtract(b, a)
        radius = item.size[0] + share * (item.size[-1] - item.size[0])
        across = near @ self.scene.frames(self.q)[frame][:3, :3]
        along = np.subtract(b, a) / np.linalg.norm(np.subtract(b, a))
        across -= (across @ along) * along
        return frame, middle + radius * across / np.linalg.norm(across)

    def take(self, spot):
        self.page.mouse.move(*spot)
        self.page.mouse.down()

    def carry(self, spot, steps=12):
        self.page.mouse.move(*spot, steps=steps)
        self.page.evaluate(SETTLE)

    def drag(self, spot, by, steps=12):
        """Take, carry, let go; where the hand was then."""
        self.take(spot)
        end = np.add(spot, by, dtype=float)
        self.carry(end, steps)
        self.page.mouse.up()
        return end


def apart(a, b):
    return float(np.linalg.norm(np.subtract(a, b)))


# ---- links ----

LINKS = [("alpha_ii", "3-D", "link-3-0", 2, -0.4), ("alpha_ii", "Front", "link-2-0", 1, 0.5),
         ("alpha_ii", "3-D", "link-1-0", 0, 0.5),
         ("two_link", "Top", "link-1-1", 0, 0.7), ("two_link", "Top", "link-2-0", 1, -1.2),
         ("two_link", "3-D", "link-2-0", 1, 0.6), ("practical_six_link", "3-D", "link-2-1", 1, 0.4),
         ("cylindrical", "3-D", "rod-3", 2, 0.1), ("cylindrical", "Front", "rod-2", 1, -0.15)]


@pytest.mark.parametrize("robot, side, body, joint, way", LINKS)
def test_a_link_goes_by_its_joint_and_stays_under_the_hand(desk, robot, side, body, joint, way):
    shown = Shown(desk, kl.ArmView(getattr(kl.robots, robot)()), side=side)
    frame, held = shown.skin(body)
    before, wanted = shown.q, shown.q
    wanted[joint] += way
    shown.take(shown.seen(shown.place(frame, held))[0])
    (hand,) = shown.seen(shown.place(frame, held, wanted))
    shown.carry(hand)
    assert np.flatnonzero(shown.q != before).tolist() == [joint]
    assert abs(shown.q[joint] - wanted[joint]) < 0.02
    assert apart(shown.seen(shown.place(frame, held))[0], hand) < 3
    desk.mouse.up()


@pytest.mark.parametrize("camera", [
    {"azimuth": -60, "elevation": 24, "zoom": 1, "perspective": True},
    {"azimuth": 130, "elevation": 50, "zoom": 1.3, "perspective": True},
    {"azimuth": -100, "elevation": -35, "zoom": 1, "perspective": False}])
def test_a_link_is_held_in_perspective_and_from_below(desk, camera):
    shown = Shown(desk, kl.ArmView(kl.robots.alpha_ii()))
    desk.evaluate("to => { Object.assign(live.picture.camera, to); live.redraw(); }", camera)
    settle(desk)
    frame, held = shown.skin("link-2-0")
    wanted = shown.q
    wanted[1] += 0.4
    shown.take(shown.seen(shown.place(frame, held))[0])
    (hand,) = shown.seen(shown.place(frame, held, wanted))
    shown.carry(hand)
    assert apart(shown.seen(shown.place(frame, held))[0], hand) < 3
    desk.mouse.up()
    np.testing.assert_allclose(shown.q, wanted, atol=0.03)


def test_the_picture_stands_still_while_it_is_held_and_finds_its_frame_then(desk):
    shown = Shown(desk, kl.ArmView(kl.robots.two_link()), side="Top")
    base = desk.locator("#base").bounding_box()
    shown.take(shown.seen(shown.place(shown.scene.tip))[0])
    shown.carry(shown.seen([-0.4, 1.2, 0])[0])
    assert desk.locator("#base").bounding_box() == base
    desk.mouse.up()
    desk.wait_for_function("!live.picture.steady.moving")
    settle(desk)
    assert desk.locator("#base").bounding_box() != base
    wanted = desk.evaluate("live.picture.lens.scale")
    desk.evaluate("joints.write(joints.q)")           # drawn anew, from the pose alone
    settle(desk)
    assert desk.evaluate("live.picture.lens.scale") == pytest.approx(wanted, rel=1e-9)


def test_beyond_its_limit_a_joint_waits(desk):
    links = [kl.revolute(a=1, limits=(-0.5, 0.5)), kl.revolute(a=1)]
    shown = Shown(desk, kl.ArmView(kl.Arm(links, home=[0, 0.3])), side="Top")
    held = [0.5, 0, 0]
    shown.take(shown.seen(held)[0])
    for angle in (0.4, 0.8, 1.6):
        shown.carry(shown.seen([0.5 * np.cos(angle), 0.5 * np.sin(angle), 0])[0])
        assert shown.q[0] == pytest.approx(min(angle, 0.5), abs=0.02)
    shown.carry(shown.seen([0.5 * np.cos(0.2), 0.5 * np.sin(0.2), 0])[0])
    assert shown.q[0] == pytest.approx(0.2, abs=0.02)
    desk.mouse.up()
    assert shown.q[1] == 0.3


def test_beside_the_arm_the_picture_is_turned(desk):
    shown = Shown(desk, kl.ArmView(kl.robots.alpha_ii()))
    before = shown.q
    box = desk.locator(".kl-picture").bounding_box()
    shown.drag((box["x"] + 30, box["y"] + 30), (40, 20))
    assert desk.evaluate("live.picture.camera.azimuth") == pytest.approx(-80)
    assert shown.q.tolist() == before.tolist()


# ---- points ----


def test_the_tip_of_a_planar_arm_takes_both_joints_along(desk):
    shown = Shown(desk, kl.ArmView(kl.robots.two_link()), side="Top")
    before, tip = shown.q, shown.scene.tip
    shown.take(np.add(shown.seen(shown.place(tip))[0], [3, -2]))   # not quite on it
    for by in ((-60, 40), (-120, 60), (-100, 150)):
        wanted = shown.seen(shown.place(tip, q=before))[0] + by
        shown.carry(wanted + [3, -2])
        assert apart(shown.seen(shown.place(tip))[0], wanted) < 2
    desk.mouse.up()
    assert np.all(np.abs(shown.q - before) > 0.1)


def test_the_tip_of_a_spatial_arm_follows_in_the_plane_of_the_picture(desk):
    shown = Shown(desk, kl.ArmView(kl.robots.alpha_ii()))
    tip, knobs = shown.scene.tip, shown.scene.knobs
    shown.take(shown.seen(shown.place(tip))[0])
    start = shown.place(tip)
    hand = shown.seen(start)[0] + [-40, 30]
    shown.carry(hand)
    assert apart(shown.seen(shown.place(tip))[0], hand) < 2
    near = np.array(desk.evaluate("live.picture.lens.near"))
    assert abs(near @ (shown.place(tip) - start)) < 0.01 * shown.scene.radius
    shown.carry(shown.seen(start)[0] + [400, -200])    # beyond its reach
    desk.mouse.up()
    assert all(knob.low <= v <= knob.high for knob, v in zip(knobs, shown.q))


POINTS = [(kl.lessons.translation.sliding_view, 0, (-50, -40), [0, 1]),
          (kl.lessons.translation.riding_view, 1, (50, -30), [0, 1]),
          (kl.lessons.translation.chain_view, 1, (40, 30), [2, 3]),
          (kl.lessons.homogeneous.combined, 0, (-60, -30), [0, 1]),
          (kl.lessons.homogeneous.chain, 2, (-40, 30), [0, 1, 2]),
          (kl.lessons.homogeneous.spatial, 0, (20, -30), [0, 1, 2]),
          (kl.lessons.two_link.both_methods, 0, (-40, 30), [0, 1]),
          (kl.lessons.two_link.n_links, 0, (-40, 30), [0, 1, 2, 3]),
          (kl.lessons.workspace.ring_view, 0, (-40, 30), [0, 1]),
          (kl.lessons.workspace.limits_view, 0, (30, -20), [4, 5]),
          (kl.lessons.start_here.reach_view, 0, (-30, 20), [0, 1]),
          (kl.lessons.n_link.zyz_view, 0, (-25, 15), [0, 1])]


@pytest.mark.parametrize("make, k, by, knobs", POINTS, ids=lambda e: getattr(e, "__name__", ""))
def test_a_point_comes_to_the_hand(desk, make, k, by, knobs):
    shown = Shown(desk, make())
    handle, before = shown.scene.handles[k], shown.q
    frame, *local = handle.point
    (spot,) = shown.seen(shown.place(frame, local))
    shown.take(spot)
    assert desk.evaluate(HAND) == "held"
    shown.carry(spot + by)
    assert apart(shown.seen(shown.place(frame, local))[0], spot + by) < 2
    desk.mouse.up()
    moved = np.flatnonzero(np.abs(shown.q - before) > 1e-6).tolist()
    assert moved and set(moved) <= set(knobs)
    assert set(moved) == set(knobs) or len(knobs) > 2


AXES = [(kl.lessons.rotation.axes_view, 0, 0), (kl.lessons.rotation.axes_view, 1, 0),
        (kl.lessons.rotation.riding_view, 2, 0), (kl.lessons.homogeneous.combined, 1, 2),
        (lambda: kl.lessons.rotation.spatial_view("x"), 0, 0),
        (kl.lessons.homogeneous.spatial, 1, 3), (kl.lessons.homogeneous.spatial, 3, 4)]


@pytest.mark.parametrize("make, k, knob", AXES)
def test_the_tip_of_an_axis_turns_its_frame(desk, make, k, knob):
    """The hand goes where the tip is when the knob is 40 degrees on."""
    shown = Shown(desk, make())
    frame, *local = shown.scene.handles[k].point
    wanted = shown.q
    wanted[knob] += np.radians(40)
    shown.take(shown.seen(shown.place(frame, local))[0])
    shown.carry(shown.seen(shown.place(frame, local, wanted))[0])
    desk.mouse.up()
    np.testing.assert_allclose(shown.q, wanted, atol=1e-6)


def test_a_frame_turns_round_and_round(desk):
    shown = Shown(desk, kl.lessons.rotation.axes_view())
    frame, *local = shown.scene.handles[0].point
    shown.take(shown.seen(shown.place(frame, local))[0])
    for angle in np.radians(np.arange(35, 800, 45)):
        shown.carry(shown.seen([np.cos(angle), np.sin(angle), 0])[0], 3)
        assert abs(np.exp(1j * shown.q[0]) - np.exp(1j * angle)) < 0.02
    desk.mouse.up()


def test_a_target_comes_from_anywhere_and_a_link_takes_it_along(desk):
    shown = Shown(desk, kl.TargetView(kl.robots.two_link()))
    (spot,) = shown.seen([0.9, 0.9, 0])
    shown.take(spot)
    shown.carry(spot + [10, 5])
    tool, ring = shown.scene.target.tip, shown.scene.target.frame
    for frame in (ring, tool):
        assert apart(shown.seen(shown.place(frame))[0], spot + [10, 5]) < 2
    desk.mouse.up()
    frame, held = shown.skin("link-2-0")
    shown.drag(shown.seen(shown.place(frame, held))[0], (-40, 0))
    np.testing.assert_allclose(shown.place(ring), shown.place(tool), atol=1e-9)


# ---- what can be grasped shows it ----


def test_what_can_be_held_shows_it(desk):
    shown = Shown(desk, kl.ArmView(kl.robots.two_link()), side="Top")
    box = desk.locator(".kl-picture")
    cursor = "box => getComputedStyle(box).cursor"
    (tip,) = shown.seen(shown.place(shown.scene.tip))
    rings = desk.locator(".kl-ring:visible")
    for off, ring, kind in (((300, 300), 0, "move"), ((10, 8), 1, "grab")):
        desk.mouse.move(*tip + off)
        expect(rings).to_have_count(ring)
        assert box.evaluate(cursor) == kind
    desk.mouse.down()
    assert box.evaluate(cursor) == "grabbing"
    desk.mouse.up()
    desk.mouse.move(*shown.seen([0.5, 0.28, 0])[0])
    assert box.evaluate(cursor) == "grab"


# ---- keys ----


def test_handles_are_reached_and_moved_by_keys(desk):
    shown = Shown(desk, kl.ArmView(kl.robots.two_link()), side="Top")
    picture, focused = desk.locator(".kl-picture"), desk.locator(".kl-hold:focus")
    picture.focus()
    picture.press("Enter")
    expect(focused).to_have_attribute("aria-label", "tip of the arm, at 1.125, 1.466, 0.000 m")
    before = shown.place(shown.scene.tip)
    desk.keyboard.press("ArrowLeft")
    np.testing.assert_allclose(shown.place(shown.scene.tip) - before, [-0.1, 0, 0], atol=1e-4)
    desk.keyboard.press("Shift+ArrowUp")
    np.testing.assert_allclose(shown.place(shown.scene.tip) - before, [-0.1, 0.01, 0], atol=1e-4)
    expect(focused).to_have_attribute("aria-label", "tip of the arm, at 1.025, 1.476, 0.000 m")
    expect(desk.locator(".kl-spoken")).to_have_text("tip of the arm, at 1.025, 1.476, 0.000 m")
    desk.keyboard.press("]")
    expect(focused).to_have_attribute("aria-label", "θ₁, shoulder")
    assert desk.evaluate("[...live.highlight.pointing.now.joints]") == [1]
    desk.keyboard.press("Tab")
    expect(focused).to_have_attribute("aria-label", "θ₂, elbow")
    assert focused.get_attribute("role") == "slider"
    elbow = round(float(np.degrees(shown.q[1])))
    desk.keyboard.press("ArrowUp")
    assert elbow <= np.degrees(shown.q[1]) <= elbow + 1
    expect(focused).to_have_attribute("aria-valuetext", f"{np.degrees(shown.q[1]):.1f}°")
    desk.keyboard.press("Home")
    assert np.degrees(shown.q[1]) == pytest.approx(np.degrees(shown.scene.knobs[1].low))
    desk.keyboard.press("[")
    desk.keyboard.press("Shift+Tab")
    assert focused.get_attribute("aria-label").startswith("tip")
    camera = desk.evaluate("live.picture.camera")
    desk.keyboard.press("Escape")
    expect(picture).to_be_focused()
    desk.keyboard.press("ArrowLeft")
    assert desk.evaluate("live.picture.camera.azimuth") != camera["azimuth"]


def test_tab_leaves_the_picture_after_its_last_handle(desk):
    Shown(desk, kl.lessons.translation.sliding_view())
    desk.locator(".kl-picture").focus()
    desk.keyboard.press("Enter")
    desk.keyboard.press("Tab")
    assert not desk.evaluate("document.querySelector('.kl-picture:focus-within')")
    assert desk.evaluate("document.activeElement.closest('.kl-view') !== null")


def test_an_origin_goes_by_its_sliders_steps(desk):
    shown = Shown(desk, kl.lessons.translation.sliding_view())
    desk.locator(".kl-picture").focus()
    for key in ("Enter", "ArrowRight", "ArrowRight", "ArrowDown"):
        desk.keyboard.press(key)
    np.testing.assert_allclose(shown.q, [2.2, -1.1], atol=1e-12)
    expect(desk.locator(".kl-hold:focus")).to_have_attribute(
        "aria-label", "origin of frame 1, at 2.20, −1.10")


def test_the_picture_says_how_its_handles_are_reached(desk):
    Shown(desk, kl.ArmView(kl.robots.two_link()))
    assert "Enter goes to what can be moved in the picture: 3 handles." in \
        desk.locator(".kl-picture").get_attribute("aria-label")


def test_control_z_takes_moves_back(desk):
    shown = Shown(desk, kl.ArmView(kl.robots.two_link()), side="Top")
    first = shown.q
    shown.drag(shown.seen(shown.place(shown.scene.tip))[0], (-60, 40))
    second = shown.q
    desk.keyboard.press("ArrowUp")
    assert np.any(shown.q != second)
    desk.keyboard.press("Control+z")
    assert shown.q.tolist() == second.tolist()
    desk.keyboard.press("Control+z")
    assert shown.q.tolist() == first.tolist()
    desk.keyboard.press("Control+z")
    assert shown.q.tolist() == first.tolist()


# ---- fingers ----


@pytest.fixture
def phone(browser, watched):
    page = watched(browser.new_page(viewport={"width": 390, "height": 844}, has_touch=True,
                                    is_mobile=True))
    prepare(page)
    page.evaluate("document.body.style.height = '3000px'")
    yield page
    page.close()


def touch_along(page, start, end, steps=8):
    wire = page.context.new_cdp_session(page)
    for k in range(steps + 1):
        x, y = np.add(start, np.subtract(end, start) * k / steps)
        wire.send("Input.dispatchTouchEvent", {"type": "touchMove" if k else "touchStart",
                                               "touchPoints": [{"x": float(x), "y": float(y)}]})
    wire.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    settle(page)


def test_a_finger_holds_what_is_near_and_scrolls_elsewhere(phone):
    shown = Shown(phone, kl.lessons.translation.sliding_view())
    frame, before = shown.scene.handles[0].point[0], shown.q
    there, (spot, zero, one) = shown.place(frame), (
        shown.seen(place)[0] for place in (shown.place(frame), [0, 0, 0], [1, 0, 0]))
    touch_along(phone, spot + [15, -14], spot + [-25, -74])      # from 20 px beside it
    # The picture then goes to its new frame: what counts is the way in the frame of before.
    moved = (shown.place(frame) - there)[..., :2] * apart(zero, one)
    assert np.abs(moved - [-40, 60]).max() < 2
    assert phone.evaluate("scrollY") == 0
    after = shown.q
    assert np.all(after != before)
    (away,) = shown.seen([-2, -2, 0])
    touch_along(phone, away, away - [0, 120])
    phone.wait_for_function("scrollY > 50")
    assert shown.q.tolist() == after.tolist()


def test_a_finger_turns_a_link(phone):
    shown = Shown(phone, kl.ArmView(kl.robots.alpha_ii()))
    before, (frame, held) = shown.q, shown.skin("link-2-0")
    (spot,) = shown.seen(shown.place(frame, held))
    touch_along(phone, spot + [0, 0], spot + [25, 25])
    assert np.flatnonzero(shown.q != before).tolist() == [1]


# ---- in JupyterLab ----


def test_python_hears_of_a_dragged_link(live):
    (view,) = live("import kinlab as kl\nview = kl.ArmView(kl.robots.two_link())\nview")
    page, before = view.page, kernel_q(view.page)
    x, y = middle(view.locator("#link-2-0"))
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 60, y + 10, steps=10)
    page.mouse.up()
    settle(page)
    page.wait_for_timeout(300)
    after = kernel_q(page)
    assert after[0] == before[0] and after[1] > before[1] + 0.2
    shown = [float(field.input_value()) for field in view.locator(".kl-field").all()]
    np.testing.assert_allclose(np.degrees(after), shown, atol=0.06)
