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
from kinlab.arms.kinematics import axis_frames, is_planar
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.controls import LAYERS, Knob, subscript
from kinlab.drawing.scene import AXIS, NAME, SPATIAL, Item, Scene

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


def pose_within(arm, spread):
    low, high = np.array([joint_range(arm, i) for i in range(arm.n)]).T
    return low + np.array(spread[:arm.n]) * (high - low)


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
    for gid in ("tool", "gripper", "finger-left", "trace"):
        close(frames[drawn[gid].points[0][0]], tool, atol=1e-11)
    close(frames[scene.tip], tool, atol=1e-11)
    assert len(frames) == len(scene.motions) + 1 == scene.tip + 1


@few
@given(arms_and_q())
def test_axes_of_a_frame_are_its_columns(arm_and_q):
    arm, q = arm_and_q
    scene = arm_scene(arm)
    places, names = in_the_room(scene, q), [str(i) for i in range(arm.n + 1)]
    items = {item.gid: item for item in scene.items}
    frames = dict(zip(names, kl.link_frames(arm, q)))
    if "frame-E-x" in places:
        frames["E"] = kl.forward_kinematics(arm, q)
    for name, T in frames.items():
        for axis, letter in enumerate("xyz"):
            gids = f"frame-{name}-{letter}", f"label-{name}-{letter}"
            for gid in gids:
                close(places[gid], [T[:3, 3], T[:3, 3] + T[:3, axis]], atol=1e-11)
                assert (items[gid].frame, items[gid].style) == (name, letter)
            arrow, label = (items[gid] for gid in gids)
            assert (arrow.shape, label.shape) == (AXIS, NAME) and arrow.size == label.size
            assert label.text == letter + subscript(name)


@course
def test_frames_that_share_an_origin_have_axes_of_different_length(robot):
    scene, found = arm_scene(robot()), {}
    places = in_the_room(scene, robot().home)
    for item in scene.items:
        if item.shape == AXIS and item.style == "x":
            mates = found.setdefault(tuple(np.round(places[item.gid][0] / scene.fit.thick)), [])
            assert item.size[1] == len(mates)
            mates.append(item)


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
@given(arms())
def test_the_ghost_stands_at_home(arm):
    ghost = in_the_room(arm_scene(arm), arm.home + 0.3)["ghost"]
    home = textbook.frames(arm, arm.home)[:, :3, 3]
    for origin in home:
        assert np.linalg.norm(ghost - origin, axis=1).min() < 1e-10
    close(ghost[-1], home[-1], atol=1e-11)


@few
@given(arms())
def test_the_floor_has_round_steps_and_holds_the_arm(arm):
    scene = arm_scene(arm)
    floor = scene.floor
    assert f"{floor.step:e}"[0] in "125" and float(f"{floor.step:.0e}") == pytest.approx(floor.step)
    assert scene.fit.radius / 7 < floor.step < scene.fit.radius / 2.3
    assert abs(floor.reach / floor.step - round(floor.reach / floor.step)) < 1e-9
    assert floor.reach > scene.radius and floor.drops == (scene.tip,)
    assert 10.0**-floor.decimals < 0.02 * scene.radius
    base = in_the_room(scene, arm.home)["base"]
    close(base[0], [0, 0, floor.height], atol=1e-12)
    assert base[1][2] > floor.height


@few
@given(arms())
def test_items_are_named_once_and_bodies_stay_together(arm):
    scene = arm_scene(arm)
    gids, bodies = [i.gid for i in scene.items], [i.body for i in scene.items if i.body >= 0]
    assert len(set(gids)) == len(gids)
    assert sorted(set(bodies)) == list(range(max(bodies) + 1))
    assert all(item.layer in ("", *LAYERS) for item in scene.items)
    assert all(0 <= k <= len(scene.motions) for item in scene.items for k, *_ in item.points)
    assert all(item.part and (item.frame or item.joint is not None or item.link is not None
                              or item.part in ("ghost", "trace")) for item in scene.items)
    switched = {layer: [g for g in gids if g.startswith(start)] for layer, start in
                [("frames", "frame-"), ("labels", "label-"), ("axes", "axis-"),
                 ("names", "name-"), ("trace", "trace"), ("ghost", "ghost")]}
    for layer, names in switched.items():
        assert [item.gid for item in scene.items if item.layer == layer] == names


def replayed(motions, q):
    """Frames from the plain data alone: matrices multiplied one after the other."""
    T = [np.eye(4)]
    for motion in motions:
        gone = motion.get("gain", 1) * q[motion["joint"]] if "joint" in motion else 0
        value = motion.get("amount", 0) + gone
        along = np.eye(3)[motion["axis"]]
        step = textbook.rigid(o=value * along) if motion["kind"] == "translate" else textbook.rigid(
            textbook.turn(along, value))
        T.append(T[-1] @ step)
    return np.array(T)


def _tuples(item):
    """Fields of an item from its plain data."""
    return {name: tuple(map(_tuple, value)) if isinstance(value, list) else value
            for name, value in item.items()}


def _tuple(value):
    return tuple(value) if isinstance(value, list) else value


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
    assert [Item(**_tuples(item)) for item in data["items"]] == list(scene.items)
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


def test_a_locked_joint_has_no_part_in_the_tour():
    arm = kl.Arm([kl.revolute(a=1), kl.revolute(a=1, limits=(0.5, 0.5))])
    home, away = arm_scene(arm).poses
    close(home, [0, 0.5])
    close(away, [0.6 * np.pi, 0.5])
    assert arm_scene(kl.Arm([kl.revolute(limits=(0.5, 0.5))])).poses == ((0.5,),)


@pytest.mark.parametrize("way", [0.3, 2.5, 4, 13.9, 24, 100])
def test_a_slider_shows_every_step(way):
    knob = Knob.length("x", "x", 0.0, way)
    assert f"{knob.step:.{knob.digits}f}" != f"{0:.{knob.digits}f}"
