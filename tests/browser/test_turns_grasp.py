"""Turns in space by hand: axes, rings and books are dragged, and all descriptions follow."""
import numpy as np
import pytest
from reading import SETTLE
from test_grasp import HAND, Shown, apart, prepare

from kinlab.lessons import turns

LINES = "Object.fromEntries([...document.querySelectorAll('[data-reading]')].map(" \
        "line => [line.dataset.reading, line.textContent]))"
UP = np.radians([0, -90, 0])


@pytest.fixture(scope="module")
def desk(browser):
    page = browser.new_page(viewport={"width": 1100, "height": 900})
    prepare(page)
    yield page
    page.close()


def handle(shown, name):
    """Where a handle is on the page, and the frame and the place of its point."""
    (one,) = [one for one in shown.scene.handles if one.name == name]
    frame, *local = one.point
    return shown.seen(shown.place(frame, local))[0], frame, local


def dragged(shown, name, wanted):
    """Drag a handle to where its point is at the knobs' values wanted; how far off it ends."""
    spot, frame, local = handle(shown, name)
    (hand,) = shown.seen(shown.place(frame, local, wanted))
    shown.take(spot)
    assert shown.page.evaluate(HAND) == "held"
    shown.carry(hand)
    shown.page.mouse.up()
    return apart(handle(shown, name)[0], hand)


@pytest.mark.parametrize("name, wanted", [
    ("tip of x₁", (40, -50, 25)), ("tip of y₁", (30, -25, 60)), ("tip of z₁", (15, -10, 5))])
def test_the_tip_of_an_axis_follows_and_every_description_with_it(desk, name, wanted):
    shown = Shown(desk, turns.attitude_view())
    before = desk.evaluate(LINES)
    assert dragged(shown, name, np.radians(wanted)) < 3
    after = desk.evaluate(LINES)
    assert all(before[line] != after[line] for line in ("rpy", "turn", "quaternion"))
    table = desk.locator(".kl-pose tbody").inner_text().replace("−", "-").split()
    R = shown.scene.frames(shown.q)[shown.scene.tip][:3, :3]
    np.testing.assert_allclose(np.array(table, float).reshape(3, 3), R, atol=6e-4)


def test_where_the_gimbal_is_locked_a_wing_cannot_be_lifted(desk):
    """The nose points up: yaw and roll both turn the wing about the vertical."""
    shown = Shown(desk, turns.gimbal_view(), UP, side="Side")
    shown.drag(handle(shown, "tip of y₁")[0], (0, -60))
    np.testing.assert_allclose(shown.q, UP, atol=1e-6)


def test_there_a_nose_goes_to_one_side_at_once_and_to_the_other_by_a_leap_of_yaw(desk):
    shown = Shown(desk, turns.gimbal_view(), UP, side="Top")
    shown.drag(handle(shown, "tip of x₁")[0], (60, 0))       # along x₀, as seen from the top
    yaw, pitch, roll = np.degrees(shown.q)
    assert abs(pitch + 90) > 10 and abs(yaw) < 1e-6 and roll == 0
    shown = Shown(desk, turns.gimbal_view(), UP, side="Top")
    shown.drag(handle(shown, "tip of x₁")[0], (0, -60))      # along y₀
    yaw, pitch, roll = np.degrees(shown.q)
    assert abs(pitch + 90) > 10 and abs(yaw) == pytest.approx(90, abs=1) and roll == 0


@pytest.mark.parametrize("ring, knob", [("ring-1-3", 0), ("ring-2-9", 1)])
def test_a_ring_turns_by_its_own_knob(desk, ring, knob):
    shown = Shown(desk, turns.gimbal_view())
    before, (frame, held) = shown.q, shown.skin(ring)
    shown.drag(shown.seen(shown.place(frame, held))[0], (12, 8))
    assert np.flatnonzero(shown.q != before).tolist() == [knob]


def test_the_axis_of_a_turn_is_dragged_and_the_angle_stays(desk):
    shown = Shown(desk, turns.axis_view())
    assert dragged(shown, "tip of u", np.radians([70, 20, 60])) < 3
    assert np.degrees(shown.q[2]) == pytest.approx(60)
    assert "by 60.0°" in desk.evaluate(LINES)["turn"]


def test_no_sign_jumps_where_an_angle_passes_half_a_turn(desk):
    """From −240° on to −120° by the keys of its slider: w passes 0."""
    shown = Shown(desk, turns.axis_view(), np.radians([30, 50, -240]))
    slider = desk.get_by_role("slider").nth(2)
    slider.focus()
    seen = []
    for _ in range(12):
        slider.press("PageUp")
        desk.evaluate(SETTLE)
        line = desk.evaluate(LINES)["quaternion"].replace("−", "-")
        seen.append([float(n) for n in line.split("(")[-1].rstrip(")").split(",")])
    assert np.degrees(shown.q[2]) == pytest.approx(-120)
    assert np.abs(np.diff(seen, axis=0)).max() < 0.1


@pytest.mark.parametrize("book", "ABCD")
def test_a_corner_of_a_book_carries_its_turns_out(desk, book):
    shown = Shown(desk, turns.books_view(), [0.4])
    assert dragged(shown, f"corner of book {book}", [0.8]) < 3
    assert shown.q[0] == pytest.approx(0.8, abs=0.03)


def test_a_handle_is_moved_by_keys(desk):
    shown = Shown(desk, turns.axis_view())
    desk.locator(".kl-picture").focus()
    desk.keyboard.press("Enter")
    (right, down), angle = handle(shown, "tip of u")[0], shown.q[2]
    desk.keyboard.press("ArrowUp")
    now = handle(shown, "tip of u")[0]
    assert now[1] < down - 10 and now[0] == pytest.approx(right, abs=2) and shown.q[2] == angle
