"""The solids of an arm: on their axes, together at every pose, none in another's place."""
import numpy as np
import pytest
import textbook
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import arms

import kinlab as kl
from kinlab.arms.joints import joint_ranges
from kinlab.arms.kinematics import axis_frames
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.controls import LAYERS
from kinlab.drawing.scene import BOX, SOLIDS
from kinlab.drawing.still import still

close = np.testing.assert_allclose
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)
few = settings(max_examples=20, deadline=None)
shares = st.lists(st.floats(0, 1) | st.sampled_from([0.0, 1.0]), min_size=7, max_size=7)
RIGHT = np.pi / 2


def within(arm, share):
    """A pose within the arm's limits."""
    low, high = joint_ranges(arm)
    return low + np.array(share[:arm.n]) * (high - low)


def solids(scene, q):
    """Every solid that is there with its points in the room, by its name."""
    frames = scene.frames(q)
    found = {}
    for item in scene.items:
        if item.shape in SOLIDS:
            room = np.array([(frames[k] @ (*p, 1))[:3] for k, *p in item.points])
            ahead = frames[item.points[0][0]][:3, 2]
            if item.size != (1.0,) or item.shape != BOX or (room[1] - room[0]) @ ahead > 0:
                found[item.gid] = item, room
    return found


def stretched(item, room):
    """The line in the middle of a solid, and how far it reaches from there."""
    if item.shape == BOX:
        return room[0], room[1], float(np.linalg.norm(room[2:] - room[0], axis=1).max())
    return room[0], room[-1], max(item.size)


def gap(one, other):
    """How far two solids are apart; below zero where they touch."""
    (a, b, r), (c, d, s) = one, other
    return min(float(from_line(c, d, a + np.linspace(0, 1, 41)[:, None] * (b - a)).min()),
               float(from_line(a, b, c + np.linspace(0, 1, 41)[:, None] * (d - c)).min())) - r - s


def from_line(a, b, points):
    """Distances of points from a straight piece of a line."""
    way = b - a
    share = np.clip((points - a) @ way / (way @ way or 1), 0, 1)
    return np.linalg.norm(points - a - share[:, None] * way, axis=1)


def pieces(scene, q, near):
    """Into how many pieces an arm falls whose solids hold together where they are so near."""
    bodies = [stretched(*solid) for solid in solids(scene, q).values()]
    left, count = set(range(len(bodies))), 0
    while left:
        count, edge = count + 1, [left.pop()]
        while edge:
            k = edge.pop()
            met = {m for m in left if gap(bodies[k], bodies[m]) < near}
            left -= met
            edge += met
    return count


def assert_whole(arm, *poses):
    assert_scene_whole(arm_scene(arm), *poses)


def assert_scene_whole(scene, *poses):
    for q in poses:
        assert pieces(scene, q, 0.25 * scene.fit.thick) == 1, q


@course
def test_an_arm_of_the_course_never_falls_to_pieces(robot):
    arm, rng = robot(), np.random.default_rng(4)
    low, high = joint_ranges(arm)
    assert_whole(arm, arm.home, low, high, *rng.uniform(low, high, (5, arm.n)))


@few
@given(arms(most=5), shares)
def test_no_arm_falls_to_pieces(arm, share):
    assert_whole(arm, arm.home, within(arm, share))


@pytest.mark.parametrize("limits", [(0, 1), (-1, 0), (-0.5, 0.5), (0.3, 1), (-1, -0.3)])
@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_a_rod_reaches_what_it_carries_wherever_it_slides(limits, convention):
    slide = kl.prismatic(a=0.3, alpha=RIGHT, limits=limits)
    for links in ([slide, kl.revolute(a=0.5)], [kl.revolute(d=1, alpha=RIGHT), slide],
                  [kl.revolute(a=0.6), slide, slide]):
        arm = kl.Arm(links, convention=convention)
        low, high = joint_ranges(arm)
        assert_whole(arm, *(low + share * (high - low) for share in (0, 0.25, 0.5, 1)))


@pytest.mark.parametrize("d", [-1, -0.5, 0.5])
@pytest.mark.parametrize("flip", [False, True])
def test_a_slide_counted_from_elsewhere_holds_together(d, flip):
    for links in ([kl.prismatic(d=d, flip=flip, limits=(0, 1))],
                  [kl.revolute(alpha=RIGHT), kl.prismatic(d=d, flip=flip, limits=(-0.2, 0.7))],
                  [kl.prismatic(d=d, flip=flip, limits=(0, 0)), kl.revolute(a=0.3)]):
        arm = kl.Arm(links)
        low, high = joint_ranges(arm)
        assert_whole(arm, *(low + share * (high - low) for share in (0, 0.5, 1)))


@few
@given(arms(), shares)
def test_a_drum_lies_on_its_axis_and_turns_with_its_joint(arm, share):
    scene, q = arm_scene(arm), within(arm, share)
    frames, drawn = textbook.frames(arm, q), solids(scene, q)
    for i, k in enumerate(axis_frames(arm), start=1):
        item, room = drawn[f"joint-{i}"]
        axis, origin = frames[k][:3, 2], frames[k][:3, 3]
        close(np.cross(room[:2] - origin, axis), 0, atol=1e-9)
        assert np.linalg.norm(room[1] - room[0]) > scene.fit.thick
        joint = arm.joints[i - 1]
        if joint.kind == "revolute":
            number, more = item.points[0][0], q + 0.4 * np.eye(arm.n)[i - 1]
            before, after = (scene.frames(at)[number][:3, :3] for at in (q, more))
            close(after, textbook.turn(axis, -0.4 if joint.flip else 0.4) @ before, atol=1e-9)


@few
@given(arms(), shares)
def test_what_says_that_it_moves_with_a_link_does(arm, share):
    scene, q = arm_scene(arm), within(arm, share)
    for i in range(arm.n):
        more = q + 0.1 * np.eye(arm.n)[i]
        before, after = (scene.frames(at) for at in (q, more))
        for item in scene.items:
            if item.link is not None and item.gid.split("-")[0] not in ("rod", "tail"):
                for k in {point[0] for point in item.points}:
                    assert item.link > i or np.allclose(before[k], after[k], atol=1e-12), item.gid


def has_flange(drawn, arm, thick):
    """Whether the last joint is drawn as the flange of a hand: a disc before the wrist."""
    item, room = drawn[f"joint-{arm.n}"]
    return item.shape != BOX and np.linalg.norm(room[1] - room[0]) < thick


def assert_apart(arm):
    """No joint stands in another's place at home. A flange, a thin disc, touches the next one."""
    scene = arm_scene(arm)
    drawn = solids(scene, arm.home)
    middles = np.array([drawn[f"joint-{i}"][1][:2].mean(axis=0) for i in range(1, arm.n + 1)])
    apart = np.linalg.norm(middles[:, None] - middles, axis=-1) + 1e9 * np.eye(arm.n)
    if has_flange(drawn, arm, scene.fit.thick):
        assert apart[-1].min() > 1.01 * scene.fit.thick
        apart = apart[:-1, :-1]
    assert apart.min() > 1.9 * scene.fit.thick


@course
def test_no_joint_of_the_course_hides_another(robot):
    assert_apart(robot())


@settings(max_examples=60, deadline=None)
@given(arms(most=3))
def test_joints_on_one_point_are_drawn_apart(arm):
    assert_apart(arm)


def test_a_wrist_with_three_crossing_axes_shows_three_joints():
    assert_apart(kl.Arm([kl.revolute(a=1), kl.revolute(alpha=RIGHT), kl.revolute(alpha=-RIGHT),
                         kl.revolute()]))
    assert_apart(kl.Arm([kl.revolute(), kl.prismatic(), kl.revolute(a=1)]))


@few
@given(arms(), shares)
def test_fingers_end_at_the_tool_point(arm, share):
    scene, q = arm_scene(arm), within(arm, share)
    drawn, T = solids(scene, q), kl.forward_kinematics(arm, q)
    ends = np.array([drawn[f"finger-{side}"][1][1] for side in ("left", "right")])
    palm = drawn["gripper"][1][:2].mean(axis=0)
    ahead = ends.mean(axis=0) - palm
    if has_flange(drawn, arm, scene.fit.thick):
        return assert_hand_on_flange(drawn, arm, ends.mean(axis=0), ahead, T, scene.fit.thick)
    close(np.linalg.norm(ends.mean(axis=0) - T[:3, 3]), 0.1 * scene.fit.thick, rtol=1e-6)
    close(np.linalg.norm(ahead), 2.5 * scene.fit.thick, rtol=1e-6)


def assert_hand_on_flange(drawn, arm, end, ahead, T, thick):
    """It points away from the wrist along the last axis. Where there is room it is small and ends
    at the tool; else it stands beyond, clear of the wrist.
    """
    _, disc = drawn[f"joint-{arm.n}"]
    size, away = np.linalg.norm(ahead) / 2.5, ahead / np.linalg.norm(ahead)
    face = max(disc @ away)
    close(np.linalg.norm(np.cross(away, disc[1] - disc[0])), 0, atol=1e-9 * thick)
    assert size <= 1.0001 * thick and end @ away - 2.5 * size - face > -0.2 * thick
    if T[:3, 3] @ away - face > 0.51 * thick:
        close(np.linalg.norm(end - T[:3, 3]), 0.1 * size, rtol=1e-6)
    else:
        close(size, 0.8 * thick, rtol=1e-6)
        close(end @ away - face, 2.8 * size, rtol=1e-6)


@pytest.mark.parametrize("name, beyond", [("puma_560", True), ("puma_560_craig", True),
                                          ("kr210", False)])
def test_a_hand_right_before_a_wrist_is_on_a_flange(name, beyond):
    """The tool of the PUMA is in its wrist; that of the KR 210 near it: a small gripper ends there.
    """
    arm = getattr(kl.robots, name)()
    scene = arm_scene(arm)
    drawn, T, thick = solids(scene, arm.home), kl.forward_kinematics(arm, arm.home), scene.fit.thick
    assert has_flange(drawn, arm, thick)
    end = np.mean([drawn[f"finger-{side}"][1][1] for side in ("left", "right")], axis=0)
    assert_hand_on_flange(drawn, arm, end, end - drawn["gripper"][1][:2].mean(axis=0), T, thick)
    assert ((end - T[:3, 3]) @ T[:3, 2] > 3 * thick) == beyond
    assert_apart(arm)
    assert_whole(arm, arm.home, *joint_ranges(arm))


@pytest.mark.parametrize("name", ["stanford", "scara", "ur5", "panda"])
def test_a_hand_with_room_has_a_whole_joint(name):
    arm = getattr(kl.robots, name)()
    scene = arm_scene(arm)
    assert not has_flange(solids(scene, arm.home), arm, scene.fit.thick)


def test_a_first_joint_high_on_its_base_stands_below_the_second():
    """As in a table with d1: a third of the way up the column, and the shoulder is free."""
    scene = arm_scene(kl.robots.puma_560_craig())
    drawn = solids(scene, np.zeros(6))
    close(drawn["joint-1"][1][:2].mean(axis=0), [0, 0, 0.35 * 0.672])
    close(drawn["joint-2"][1][:2].mean(axis=0), [0, 0, 0.672], atol=1e-12)


@course
def test_the_gripper_reaches_forward(robot):
    arm = robot()
    drawn, tool = solids(arm_scene(arm), arm.home), kl.forward_kinematics(arm, arm.home)[:3, 3]
    *_, (_, limb) = [solid for gid, solid in drawn.items() if gid.startswith(("link-", "rod-"))]
    ahead = tool - drawn["gripper"][1][:2].mean(axis=0)
    way = tool - limb[0]
    assert ahead @ way > 0.99 * np.linalg.norm(ahead) * np.linalg.norm(way)


def long_arm(n=30):
    """Every kind of link, with joints on one point, zero lengths, a base and a tool."""
    kinds = [kl.revolute(a=0.4), kl.revolute(alpha=RIGHT), kl.prismatic(limits=(-0.2, 0.3)),
             kl.revolute(d=0.5), kl.revolute(alpha=-RIGHT, a=0.2), kl.revolute()]
    end = textbook.rigid(textbook.turn((0, 1, 0), 0.4), [0.1, 0.2, 0.3])
    return kl.Arm([kinds[i % len(kinds)] for i in range(n)], base=end, tool=end)


EDGES = {"no length": kl.Arm([kl.revolute(), kl.revolute()]),
         "one slide without length": kl.Arm([kl.prismatic()]),
         "one axis": kl.Arm([kl.revolute(d=1), kl.revolute(), kl.prismatic(), kl.revolute()]),
         "far away": kl.Arm([kl.revolute(a=1)], base=textbook.rigid(np.eye(3), [30, -20, 10])),
         "tiny": kl.Arm([kl.revolute(a=1e-6), kl.revolute(a=1e-6)]),
         "huge": kl.Arm([kl.revolute(a=1e7), kl.revolute(d=1e7)]), "thirty joints": long_arm()}


@pytest.mark.parametrize("arm", EDGES.values(), ids=EDGES)
@pytest.mark.parametrize("share", [0.0, 0.4, 1.0])
def test_arms_at_the_edge_are_whole_and_finite(arm, share):
    scene, q = arm_scene(arm), within(arm, [share] * arm.n)
    wordless = [layer for layer in LAYERS if layer not in ("labels", "names")]
    for preset, show in (("3-D", LAYERS), ("top", wordless)):  # words of thirty joints take long
        for drawn in still(scene, q, preset, show):
            for mark in drawn.marks:
                assert all(np.isfinite(line).all() for line in mark.lines), drawn.gid
    assert_scene_whole(scene, q)


@few
@given(arms(), shares)
def test_every_point_of_a_picture_is_finite(arm, share):
    for drawn in still(arm_scene(arm), within(arm, share), "3-D", LAYERS):
        assert all(np.isfinite(line).all() for mark in drawn.marks for line in mark.lines)


def test_a_long_name_does_not_cover_the_picture():
    names = ["elbow", "x" * 20, "a very long name of a joint", None]
    arm = kl.Arm([kl.revolute(a=1, name=name) for name in names])
    shown = [item.text for item in arm_scene(arm).items if item.layer == "names"]
    assert shown == ["elbow", "x" * 20, "a very long name of…"]
