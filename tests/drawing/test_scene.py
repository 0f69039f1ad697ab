"""What is drawn: in its place at every pose, whole within the picture, and plain data."""
import json

import numpy as np
import pytest
import textbook
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import arms, arms_and_q

import kinlab as kl
from kinlab.arms.joints import joint_range
from kinlab.arms.kinematics import axis_frames
from kinlab.drawing.arm_scene import arm_scene, is_planar
from kinlab.drawing.controls import LAYERS, subscript
from kinlab.drawing.scene import SPATIAL, TEXT, Scene

close = np.testing.assert_allclose
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)
few = settings(max_examples=25)
fractions = st.floats(0, 1, allow_subnormal=False) | st.sampled_from([0.0, 0.5, 1.0])
spreads = st.lists(fractions, min_size=7, max_size=7)
directions = st.sampled_from(list(SPATIAL.values())) | st.tuples(st.floats(-180, 180),
                                                                 st.floats(-90, 90))


def rows(direction):
    """Right and up on the picture, in the room: turn the room by -azimuth, then tip it."""
    azimuth, elevation = np.radians(direction)
    room = textbook.turn((0, 1, 0), elevation) @ textbook.turn((0, 0, 1), -azimuth)
    return room[1:]


def in_the_room(scene, q):
    """Every item's points at a pose, by gid."""
    frames = scene.frames(q)
    return {item.gid: np.array([frames[k][:3, :3] @ p + frames[k][:3, 3]
                                for k, *p in item.points]) for item in scene.items}


def on_the_picture(scene, points, direction):
    right, up = rows(direction) @ (points - np.array(scene.center)).T
    width, height = scene.size
    return np.stack([width / 2 + scene.scale * right, height / 2 - scene.scale * up], axis=-1)


def pose_within(arm, spread):
    low, high = np.array([joint_range(arm, i) for i in range(arm.n)]).T
    return low + np.array(spread[:arm.n]) * (high - low)


def margin(scene, points):
    """How far (px) the outermost point of a scene stays from the edge of the picture."""
    return float(np.minimum(points, np.array(scene.size) - points).min())


@course
def test_nothing_is_clipped_at_any_pose_from_any_side(robot):
    arm, rng = robot(), np.random.default_rng(7)
    scene = arm_scene(arm)
    corners = rng.choice([0, 0.25, 0.5, 0.75, 1], (150, arm.n))
    for spread in np.vstack([corners, rng.random((150, arm.n))]):
        places = in_the_room(scene, pose_within(arm, spread))
        points = np.vstack(list(places.values()))
        names = np.vstack([places[item.gid] for item in scene.items if item.shape == TEXT])
        for direction in [*SPATIAL.values(), (rng.uniform(-180, 180), rng.uniform(-90, 90))]:
            assert margin(scene, on_the_picture(scene, points, direction)) > 4
            assert margin(scene, on_the_picture(scene, names, direction)) > 9  # half a name


@given(arms(), spreads, directions)
def test_no_arm_leaves_the_picture(arm, spread, direction):
    scene = arm_scene(arm)
    points = np.vstack(list(in_the_room(scene, pose_within(arm, spread)).values()))
    assert margin(scene, on_the_picture(scene, points, direction)) > 0


@course
def test_the_arm_is_not_lost_in_the_picture(robot):
    arm = robot()
    scene, rng = arm_scene(arm), np.random.default_rng(3)
    q = [pose_within(arm, rng.random(arm.n)) for _ in range(500)]
    tips = kl.forward_kinematics(arm, q)[:, :3, 3] - scene.center
    assert np.linalg.norm(tips, axis=1).max() * scene.scale > 0.5 * min(scene.size) / 2


@few
@given(arms_and_q())
def test_frames_stand_where_kinematics_puts_them(arm_and_q):
    arm, q = arm_and_q
    scene = arm_scene(arm)
    frames, drawn = scene.frames(q), {item.gid: item for item in scene.items}
    for i, T in enumerate(kl.link_frames(arm, q)):
        for letter in "xyz":
            close(frames[drawn[f"frame-{i}-{letter}"].points[0][0]], T, atol=1e-11)
    tool = kl.forward_kinematics(arm, q)
    for gid in ("tool", "gripper", "trace"):
        close(frames[drawn[gid].points[0][0]], tool, atol=1e-11)
    close(frames[scene.tip], tool, atol=1e-11)
    assert len(frames) == len(scene.motions) + 1 == scene.tip + 1


@few
@given(arms_and_q())
def test_axes_of_a_frame_are_its_columns(arm_and_q):
    arm, q = arm_and_q
    scene = arm_scene(arm)
    places, names = in_the_room(scene, q), [str(i) for i in range(arm.n + 1)]
    texts = {item.gid: item.text for item in scene.items}
    tool = kl.forward_kinematics(arm, q)
    frames = dict(zip(names, kl.link_frames(arm, q)))
    if "frame-E-x" in places:
        frames["E"] = tool
    for name, T in frames.items():
        for axis, letter in enumerate("xyz"):
            tail, tip = places[f"frame-{name}-{letter}"]
            close(tail, T[:3, 3], atol=1e-11)
            length = np.linalg.norm(tip - tail)
            close(tip - tail, length * T[:3, axis], atol=1e-11)
            label = places[f"label-{name}-{letter}"][0]
            ahead = (label - tail) @ T[:3, axis]
            close(label - tail, ahead * T[:3, axis], atol=1e-11)
            assert length < ahead < 1.5 * length
            assert texts[f"label-{name}-{letter}"] == letter + subscript(name)


@few
@given(arms_and_q())
def test_joint_axes_lie_along_the_joints(arm_and_q):
    arm, q = arm_and_q
    scene = arm_scene(arm)
    places, frames = in_the_room(scene, q), textbook.frames(arm, q)
    # z of frame i-1 (standard) or i (modified) is joint i's axis, in either convention.
    for i, k in enumerate(axis_frames(arm), start=1):
        for point in places[f"axis-{i}"]:
            close(np.cross(point - frames[k][:3, 3], frames[k][:3, 2]), 0, atol=1e-10)
        assert np.ptp(places[f"axis-{i}"] @ frames[k][:3, 2]) > 0.1 * scene.radius


@few
@given(arms_and_q(most=5))
def test_links_are_strokes_along_the_slides(arm_and_q):
    arm, q = arm_and_q
    scene = arm_scene(arm)
    places, origins = in_the_room(scene, q), scene.frames(q)[:, :3, 3]
    for k, motion in enumerate(scene.motions):
        strokes = [place for gid, place in places.items() if gid.startswith(f"link-{k}-")]
        assert bool(strokes) == (motion.kind == "translate")
        ends = np.vstack([origins[k], *strokes, origins[k + 1]]).reshape(-1, 2, 3)
        close(ends[:, 0], ends[:, 1], atol=1e-11)  # each begins where the one before ended


@few
@given(arms(), spreads)
def test_joint_bodies_sit_on_their_axes_within_reach(arm, spread):
    scene, q = arm_scene(arm), pose_within(arm, spread)
    places, frames = in_the_room(scene, q), textbook.frames(arm, q)
    for i, k in enumerate(axis_frames(arm), start=1):
        body = np.vstack([p for gid, p in places.items() if gid.startswith(f"joint-{i}-")])
        away = body.mean(axis=0) - frames[k][:3, 3]
        close(np.cross(away, frames[k][:3, 2]), 0, atol=1e-9)
        assert np.linalg.norm(body - scene.center, axis=1).max() < scene.radius


def joint_middles(arm):
    scene = arm_scene(arm)
    places = in_the_room(scene, arm.home)
    return scene, np.array([np.vstack([p for gid, p in places.items()
                                       if gid.startswith(f"joint-{i}-")]).mean(axis=0)
                            for i in range(1, arm.n + 1)])


def assert_apart(arm):
    scene, middles = joint_middles(arm)
    apart = np.linalg.norm(middles[:, None] - middles, axis=-1) + 1e9 * np.eye(arm.n)
    body = np.array([p[1:] for item in scene.items if item.gid == "joint-1-1"
                     for p in item.points])
    assert apart.min() > 1.9 * np.linalg.norm(body[:, :2], axis=1).max() / np.sqrt(2)


@course
def test_no_joint_of_the_course_hides_another(robot):
    assert_apart(robot())


@few
@given(arms(most=3))
def test_joints_on_one_point_are_drawn_apart(arm):
    assert_apart(arm)


def test_a_wrist_with_three_crossing_axes_shows_three_joints():
    right = np.pi / 2
    assert_apart(kl.Arm([kl.revolute(a=1), kl.revolute(alpha=right), kl.revolute(alpha=-right),
                         kl.revolute()]))
    assert_apart(kl.Arm([kl.revolute(), kl.prismatic(), kl.revolute(a=1)]))


@course
def test_faces_look_outwards(robot):
    arm = robot()
    scene, middles = joint_middles(arm)
    places = in_the_room(scene, arm.home)
    for i, middle in enumerate(middles, start=1):
        faces = [item.gid for item in scene.items
                 if item.gid.startswith(f"joint-{i}-") and item.shape == "face"]
        assert len(faces) == (2 if arm.links[i - 1].kind == "revolute" else 6)
        for gid in faces:
            a, b, c = places[gid][:3]
            assert np.cross(b - a, c - b) @ (places[gid].mean(axis=0) - middle) > 0


@course
def test_the_gripper_reaches_forward(robot):
    arm = robot()
    scene = arm_scene(arm)
    places = in_the_room(scene, arm.home)
    near_tip, palm = places["gripper"][[0, 3]], places["gripper"][[1, 2]]
    tool = kl.forward_kinematics(arm, arm.home)[:3, 3]
    close(near_tip.mean(axis=0), tool, atol=1e-9)
    close(places["tool"], [tool, tool], atol=1e-12)
    ahead = near_tip.mean(axis=0) - palm.mean(axis=0)
    corner = next(point for item in reversed(scene.items) if item.gid.startswith("link-")
                  for point in places[item.gid][::-1] if np.linalg.norm(point - tool) > 1e-6)
    assert ahead @ (tool - corner) / np.linalg.norm(tool - corner) > 0.99 * np.linalg.norm(ahead)


@few
@given(arms())
def test_the_ghost_stands_at_home(arm):
    ghost = in_the_room(arm_scene(arm), arm.home + 0.3)["ghost"]
    home = textbook.frames(arm, arm.home)[:, :3, 3]
    for origin in home:
        assert np.linalg.norm(ghost - origin, axis=1).min() < 1e-10
    close(ghost[-1], home[-1], atol=1e-11)


@few
@given(arms())
def test_the_ground_is_a_grid_of_round_steps(arm):
    lines = [np.array(item.points)[:, 1:] for item in arm_scene(arm).items
             if item.style == "ground"]
    step = np.unique(np.array(lines)[:7, 0, 0])
    close(np.diff(step), step[4] - step[3])
    assert f"{step[4]:e}"[0] in "125" and step[3] == 0
    assert len(lines) == 14 and not np.array(lines)[:, :, 2].any()


@few
@given(arms())
def test_items_are_named_once_and_bodies_stay_together(arm):
    scene = arm_scene(arm)
    gids, bodies = [i.gid for i in scene.items], [i.body for i in scene.items if i.body >= 0]
    assert len(set(gids)) == len(gids)
    assert sorted(set(bodies)) == list(range(max(bodies) + 1))
    assert all(item.layer in ("", *LAYERS) for item in scene.items)
    assert all(0 <= k <= len(scene.motions) for item in scene.items for k, *_ in item.points)
    switched = {layer: [g for g in gids if g.startswith(start)] for layer, start in
                [("frames", "frame-"), ("labels", "label-"), ("axes", "axis-"),
                 ("trace", "trace"), ("ghost", "ghost")]}
    for layer, names in switched.items():
        assert [item.gid for item in scene.items if item.layer == layer] == names


def replayed(motions, q):
    """Frames from the plain data alone: matrices multiplied one after the other."""
    T = [np.eye(4)]
    for motion in motions:
        value = motion.get("amount", 0) + (q[motion["joint"]] if "joint" in motion else 0)
        along = np.eye(3)[motion["axis"]]
        step = textbook.rigid(o=value * along) if motion["kind"] == "translate" else textbook.rigid(
            textbook.turn(along, value))
        T.append(T[-1] @ step)
    return np.array(T)


@few
@given(arms_and_q())
def test_data_is_plain_and_complete(arm_and_q):
    arm, q = arm_and_q
    scene = arm_scene(arm)
    text = json.dumps(scene.data(), allow_nan=False)
    data = json.loads(text)
    assert json.dumps(data) == text
    close(replayed(data["motions"], q), scene.frames(q), atol=1e-11)
    assert [item["gid"] for item in data["items"]] == [item.gid for item in scene.items]
    assert set(data["items"][0]) == set(vars(scene.items[0]))
    close(data["center"], scene.center)
    assert (data["scale"], data["tip"], data["size"]) == (scene.scale, scene.tip,
                                                          list(scene.size))
    assert data["presets"] == {name: list(angles) for name, angles in SPATIAL.items()}


def test_scenes_of_equal_arms_are_equal():
    assert arm_scene(kl.robots.alpha_ii()) == arm_scene(kl.robots.alpha_ii())


def test_presets_look_along_the_axes():
    close(rows(SPATIAL["top"]), [[1, 0, 0], [0, 1, 0]], atol=1e-12)
    close(rows(SPATIAL["front"]), [[1, 0, 0], [0, 0, 1]], atol=1e-12)
    close(rows(SPATIAL["side"]), [[0, 1, 0], [0, 0, 1]], atol=1e-12)


def planar(*twists, base=None, kind=kl.revolute):
    return kl.Arm([kind(a=1, alpha=twist) for twist in twists], base=base)


def test_planar_arms_turn_about_the_rooms_z():
    turned = textbook.rigid(textbook.turn((0, 0, 1), 0.7), [1, 2, 3])
    tipped = textbook.rigid(textbook.turn((1, 0, 0), 0.7))
    assert is_planar(kl.robots.two_link())
    assert is_planar(planar(0, 0, 0)) and is_planar(planar(0, np.pi))
    assert is_planar(planar(0, 0, base=turned))
    assert not is_planar(planar(0, 0, base=tipped))
    assert not is_planar(planar(0, np.pi / 2))
    assert not is_planar(planar(0, 0, kind=kl.prismatic))
    assert not any(is_planar(robot()) for robot in COURSE[1:])


def test_joint_ranges_are_the_limits_or_what_shows_the_joint():
    arm = kl.Arm([kl.revolute(a=-2, limits=(-1, 2)), kl.revolute(d=3), kl.prismatic(a=1),
                  kl.prismatic(limits=(-0.2, 0.3))])
    ranges = [joint_range(arm, i) for i in range(4)]
    assert ranges == [(-1, 2), (-np.pi, np.pi), (0, 6), (-0.2, 0.3)]
    assert joint_range(kl.Arm([kl.prismatic()]), 0) == (0, 1)


def test_an_arm_without_length_can_be_drawn():
    scene = arm_scene(kl.Arm([kl.revolute(), kl.revolute()]))
    assert isinstance(scene, Scene) and np.isfinite(scene.scale) and scene.scale > 0
