"""What the views of the workspace lesson draw is where it should be, and its answers are true."""
from math import pi

import numpy as np
import pytest
from test_two_link import places

import kinlab as kl
from kinlab.drawing.curves import corners
from kinlab.lessons import workspace as lesson

close = np.testing.assert_allclose
LIMITS = [(-20, 130, 0, 150), (-180, 180, -180, 180), (-90, 45, 30, 120), (0, 10, -90, 60)]


def tip(t1, t2, l1=1.0, l2=0.6):
    return np.stack([l1 * np.cos(t1) + l2 * np.cos(t1 + t2),
                     l1 * np.sin(t1) + l2 * np.sin(t1 + t2)], axis=-1)


def set_to(view, **values):
    for name, value in values.items():
        view[name].value = value
    return view


@pytest.mark.parametrize("l1, l2", [(1, 0.6), (0.5, 1.0), (0.8, 0.8)])
def test_the_circles_are_those_of_the_stretched_and_the_folded_arm(l1, l2):
    view = set_to(lesson.ring_view(), l_1=l1, l_2=l2, theta_1=50, theta_2=-70)
    for name, radius in (("stretched", l1 + l2), ("folded", abs(l1 - l2))):
        circle = curve(view, name)
        close(np.linalg.norm(circle, axis=1), radius, atol=1e-12)
        close(circle[0], circle[-1], atol=1e-12)
    close(view.readings["stretched"][0], [l1 + l2])
    close(view.readings["folded"][0], [abs(l1 - l2)])
    t1, t2 = np.radians([50, -70])
    close(view.readings["p"][0], tip(t1, t2, l1, l2))
    close(view.readings["p_1"][0], tip(0, t2, l1, l2))
    close(places(view, "reach"), [[0, 0], tip(t1, t2, l1, l2)], atol=1e-12)


def test_zero_moves_joints_and_leaves_lengths_and_limits():
    assert lesson.ring_view().scene["zero"] == [0, 0, None, None, None]
    assert lesson.limits_view().scene["zero"] is None
    assert kl.solve_view(kl.robots.two_link(), [0.5, 1, 0]).scene["zero"] is None
    assert kl.ArmView(kl.robots.alpha_ii()).scene["zero"] == [0] * 5


def test_the_sweep_goes_all_over_the_ring():
    poses = np.array(lesson.ring_view().scene["poses"])
    assert set(poses[:, 0]) == {-pi, 0, pi} and poses[0, 1] == 0 and poses[-1, 1] == pi
    assert np.all(np.diff(poses[:, 1]) >= 0)


def limited(low_1, high_1, low_2, high_2):
    return set_to(lesson.limits_view(), from_1=low_1, to_1=high_1, from_2=low_2, to_2=high_2)


def curve(view, gid):
    """The corners of a curve, in the room's plane."""
    scene = view._scene
    (item,) = (item for item in scene.items if item.gid == gid)
    return corners(item, scene.motions, scene.frames(view._values), view._values)[:, :2]


def along(drawn, place, low, high):
    """That a curve is an arm's way from one joint value to the other."""
    close(drawn, place(np.linspace(low, high, len(drawn))), atol=1e-12)
    assert len(drawn) == 1 + max(1, np.ceil(round((high - low) / np.radians(3), 6)))


@pytest.mark.parametrize("ends", LIMITS)
def test_the_edges_are_the_sides_of_the_rectangle(ends):
    view = limited(*ends)
    low_1, high_1, low_2, high_2 = np.radians(ends)
    for k, bend in ((0, low_2), (4, (low_2 + high_2) / 2), (8, high_2)):
        along(curve(view, f"bend-{k}"), lambda turn, bend=bend: tip(turn, bend), low_1, high_1)
    for k, turn in ((0, low_1), (4, (low_1 + high_1) / 2), (8, high_1)):
        along(curve(view, f"turn-{k}"), lambda bend, turn=turn: tip(turn, bend), low_2, high_2)


@pytest.mark.parametrize("ends", LIMITS)
def test_the_straightest_arm_is_the_farthest(ends):
    line = curve(limited(*ends), "straightest")
    bends = np.radians(np.linspace(*ends[2:], 3001))
    farthest = np.linalg.norm(tip(0, bends), axis=1).max()
    close(np.linalg.norm(line, axis=1), farthest, atol=1e-6)


@pytest.mark.parametrize("ends", LIMITS)
def test_the_region_is_all_that_is_reached_and_no_more(ends):
    """Tools at random joint values lie in it; so many random points as lie in it are reached."""
    view, rng = limited(*ends), np.random.default_rng(1)
    outlines = [curve(view, f"region-{k}") for k in (0, 1)]
    low, high = np.radians(ends[::2]), np.radians(ends[1::2])
    inner = low + rng.uniform(0.02, 0.98, (400, 2)) * (high - low)
    inner = inner[np.abs(np.sin(inner[:, 1])) > 0.12]  # not on the very edge
    assert _within(outlines, tip(*inner.T)).all()
    points = rng.uniform(-1.65, 1.65, (1500, 2))
    for place, held in zip(points, _within(outlines, points)):
        assert held == _reached(place, low, high) or _is_near(place, view)


def _within(outlines, points):
    """Where a line that may run round twice goes round a point."""
    return np.any([[abs(_rounds(loop, point)) > 0.5 for point in points]
                   for loop in outlines], axis=0)


def _rounds(loop, point):
    way = (loop - point) @ [1, 1j]
    return np.angle(np.roll(way, -1) / way).sum() / (2 * pi)


def _reached(place, low, high):
    """By the law of cosines, elbow to one side or to the other."""
    r, angle = np.hypot(*place), np.arctan2(*place[::-1])
    cosine = (r * r - 1.36) / 1.2
    if abs(cosine) > 1:
        return False
    for bend in (np.arccos(cosine), -np.arccos(cosine)):
        turn = angle - np.arctan2(0.6 * np.sin(bend), 1 + 0.6 * np.cos(bend))
        if low[1] <= bend <= high[1] and (turn - low[0]) % (2 * pi) <= high[0] - low[0]:
            return True
    return False


def _is_near(place, view):
    """Within what an arc's corners leave of it."""
    names = ("bend-0", "bend-8", "turn-0", "turn-8", "straightest")
    return min(np.linalg.norm(curve(view, name) - place, axis=1).min() for name in names) < 0.06


@pytest.mark.parametrize("ends", LIMITS)
@pytest.mark.parametrize("sweeps", [(0, 100), (30, 60)])
def test_the_arm_keeps_its_limits(ends, sweeps):
    view = set_to(limited(*ends), s_1=sweeps[0], s_2=sweeps[1])
    t1, t2 = (low + share / 100 * (high - low) for low, high, share in
              zip(np.radians(ends[::2]), np.radians(ends[1::2]), sweeps))
    close(view.readings["p"][0], tip(t1, t2), atol=1e-12)


def test_limits_to_begin_with():
    view = lesson.limits_view((-90, 90), (30, 120))
    assert [view[name].value for name in ("from_1", "to_1", "from_2", "to_2")] == pytest.approx(
        [-90, 90, 30, 120])


def test_the_wall_is_the_widest():
    """By brute force: no wider range of the shoulder keeps the tool on its side."""
    bends = np.radians(np.arange(0, 90.01, 0.1))
    turns = np.radians(np.arange(-180, 180, 0.1))
    clear = np.array([tip(t, bends)[:, 1].min() >= -1e-9 for t in turns])
    close(np.degrees(turns[clear][[0, -1]]), [0, 149.0], atol=0.06)
    assert clear.sum() == np.ptp(np.flatnonzero(clear)) + 1


def test_nothing_comes_closer_to_the_shoulder_or_to_the_target():
    """The solver, which knows nothing of triangles, misses both points by as much."""
    for point, least in ((lesson._SHOULDER, lesson._CLOSEST),
                         ([600, 0, 500], lesson.misses(600, 500))):
        found = kl.inverse_kinematics(kl.robots.alpha_ii(), point)
        assert not found.success
        close(found.position_error, least, rtol=1e-5)


def test_the_ring_is_drawn_as_far_as_it_is_swept():
    view = lesson.ring_view()
    for share, angle in ((0.0, 0), (0.25, pi / 2), (1.0, 2 * pi)):
        view["swept"].value = 100 * share
        end = curve(view, "stretched")[-1]
        close(end, 1.6 * np.array([np.cos(angle), np.sin(angle)]), atol=1e-12)


def test_the_circle_of_wrists_lies_in_the_ring_from_06_to_14():
    view = lesson.dexterous_view()
    for r in (0.6, 0.9, 1.4):
        radii = []
        for phi in range(-180, 180, 10):
            set_to(view, r=r, phi=phi)
            radii.append(view.readings["w"][0][0])
        assert min(radii) >= 0.4 - 1e-9 and max(radii) <= 1.6 + 1e-9
    set_to(view, r=0.5, phi=0)
    close(view.readings["w"][0], [0.3])
