"""A link in stages: its normal and marks stand right, and the product grows as numpy multiplies."""
from functools import reduce

import numpy as np
import pytest
import sympy as sp
import textbook

import kinlab as kl
from kinlab.arms.growing import growing_product
from kinlab.arms.joints import joint_range
from kinlab.drawing.curves import corners, is_there
from kinlab.drawing.stages_picture import stages_sketch

close = np.testing.assert_allclose
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
ARMS = [convert(robot()) for robot in COURSE for convert in (kl.to_standard, kl.to_modified)]
LINKS = [(arm, link) for arm in ARMS for link in range(1, arm.n + 1)]
every_link = pytest.mark.parametrize(
    "arm, link", LINKS, ids=[f"{arm.name}-{arm.convention}-{link}" for arm, link in LINKS])
ORDERS = {"standard": ("theta", "d", "a", "alpha"), "modified": ("alpha", "a", "theta", "d")}
X, Z = np.eye(3)[[0, 2]]


def pose_of(arm):
    low, high = np.array([joint_range(arm, i) for i in range(arm.n)]).T
    return low + np.random.default_rng(arm.n).random(arm.n) * (high - low)


def row(arm, link, q):
    """The parameters of a link at joint values q, as its table says."""
    values = {name: getattr(arm.links[link - 1], name) for name in ORDERS["standard"]}
    values[arm.links[link - 1].variable] += q[link - 1]
    return values


def after(arm, link, q, done):
    """The product of the first motions, from matrices typed by hand."""
    factors = [np.eye(4)]
    for name in ORDERS[arm.convention][:done]:
        value, axis = row(arm, link, q)[name], Z if name in ("theta", "d") else X
        turns = name in ("theta", "alpha")
        factors.append(textbook.rigid(textbook.turn(axis, value)) if turns
                       else textbook.rigid(o=value * axis))
    return reduce(np.matmul, factors)


def places(scene, q, gid):
    """An item's points in the room, or None while it is not there."""
    item = next(item for item in scene.items if item.gid == gid)
    if not is_there(item, q):
        return None
    return corners(item, scene.motions, scene.frames(q), q)


@every_link
def test_the_table_shows_the_product_of_the_motions_done(arm, link):
    scene, q = stages_sketch(arm, link, arm.home).scene(), pose_of(arm)
    for stage in range(7):
        frames = scene.frames([*q, stage])
        T = np.linalg.inv(frames[scene.pose.base]) @ frames[scene.tip]
        close(T, after(arm, link, q, max(0, stage - 2)), atol=1e-9)


@every_link
def test_the_letters_stand_for_the_same_product(arm, link):
    sketch, q = stages_sketch(arm, link, arm.home), pose_of(arm)
    names = [sketch.symbol_of(k) for k in range(4)]
    values = dict(zip(map(sp.Symbol, names),
                      (row(arm, link, q)[name] for name in ORDERS[arm.convention])))
    for done, form in enumerate(growing_product(arm, link, names)):
        close(np.array(form.matrix.subs(values), dtype=float), after(arm, link, q, done),
              atol=1e-9)


@every_link
def test_the_common_normal_meets_both_axes_at_right_angles(arm, link):
    scene, q = stages_sketch(arm, link, arm.home).scene(), pose_of(arm)
    before, behind = kl.link_frames(arm, q)[link - 1:link + 1]
    for stage in (1, 4.5):
        foot, end = places(scene, [*q, stage], "normal")
        for T in (before, behind):
            assert abs((end - foot) @ T[:3, 2]) < 1e-9
        a = arm.links[link - 1].a
        if a:
            close(np.linalg.norm(end - foot), abs(a))
            for point, T in ((foot, before), (end, behind)):
                close(np.cross(point - T[:3, 3], T[:3, 2]), 0, atol=1e-9)
        owner = behind if arm.convention == "standard" else before
        close(np.cross(end - foot, owner[:3, 0]), 0, atol=1e-9)
    assert len(places(scene, [*q, 0], "normal")) == 1


@every_link
def test_right_angle_marks_lie_in_the_corners(arm, link):
    scene, q = stages_sketch(arm, link, arm.home).scene(), pose_of(arm)
    normal = places(scene, [*q, 1], "normal")
    for gid, T, at in (("right-first", kl.link_frames(arm, q)[link - 1], 0),
                       ("right-second", kl.link_frames(arm, q)[link], 1)):
        assert places(scene, [*q, 0], gid) is None
        up, corner, side = places(scene, [*q, 1], gid)
        close((up - corner) @ (side - corner), 0, atol=1e-9 * scene.radius**2)
        close(np.cross(corner - side, T[:3, 2]), 0, atol=1e-9)
        if arm.links[link - 1].a:  # the side lies on the normal, towards the other foot
            way = normal[1 - at] - normal[at]
            close((side - normal[at]) / np.linalg.norm(side - normal[at]),
                  way / np.linalg.norm(way), atol=1e-9)


def there(view, stage):
    q = [*view._scene.begin[:-1], stage]
    return {item.gid for item in view._scene.items if is_there(item, q)}


@pytest.mark.parametrize("convert, early, late", [
    (kl.to_standard, {"frame-1-x", "frame-1-z", "frame-2-z"}, {"frame-2-x", "frame-2-y"}),
    (kl.to_modified, {"frame-1-z", "frame-2-z"}, {"frame-1-x", "frame-1-y", "frame-2-x"})])
def test_each_stage_brings_its_part(convert, early, late):
    view = kl.link_view(convert(kl.robots.exam_2018()), 2)
    seen = [there(view, stage) for stage in range(7)]
    assert early <= seen[0] and not late & (seen[0] | seen[1]) and late <= seen[2]
    assert "right-first" in seen[1] - seen[0] and "frame--x" in seen[2] - seen[1]
    shapes = {"theta": "arc", "alpha": "arc", "d": "dimension", "a": "dimension"}
    for k, name in enumerate(view._scene.knobs[-1].names[3:]):
        plain = {"θ": "theta", "α": "alpha"}.get(name[0], name[0])
        gid = f"{shapes[plain]}-{k}"
        assert (gid in seen[6]) == (gid in seen[3 + k]) and gid not in seen[2 + k]


def test_stages_are_named_by_the_link_s_own_parameters():
    names = [kl.link_view(arm, 2)._scene.knobs[-1].names for arm in
             (kl.robots.exam_2018(), kl.robots.two_link())]
    assert names == [("Axes", "Normal", "x", "θ₂", "d₂", "a₂", "α₂"),
                     ("Axes", "Normal", "x", "α₁", "a₁", "θ₂", "d₂")]


@pytest.mark.parametrize("arm, link, words", [
    (kl.robots.exam_2018(), 2, "It meets z₁ and z₂ at right angles. There is only one."),
    (kl.robots.exam_2018(), 1, "z₀ and z₁ meet, so it has no length."),
    (kl.robots.alpha_ii(), 2, "z₁ and z₂ are parallel and have many"),
    (kl.robots.cylindrical(), 1, "z₀ and z₁ are one line"),
    (kl.to_modified(kl.robots.alpha_ii()), 2, "z₁ and z₂ meet, so it has no length.")])
def test_the_normal_is_told_as_it_is(arm, link, words):
    view = kl.link_view(arm, link)
    view["stage"].value = 1
    assert words in view.readings["stage"][0]


@pytest.mark.parametrize("arm, link, words", [
    (kl.robots.exam_2018(), 1, "z₀ is the axis of joint 1, z₁ is the axis of joint 2."),
    (kl.robots.exam_2018(), 3, "z₂ is the axis of joint 3, z₃ is no joint's axis"),
    (kl.to_modified(kl.robots.exam_2018()), 1, "z₀ is no joint's axis: it is ours to choose, "
                                               "z₁ is the axis of joint 1.")])
def test_the_axes_are_told_with_their_joints(arm, link, words):
    assert words in kl.link_view(arm, link).readings["stage"][0]


def test_the_variable_has_its_star_on_the_slider_and_in_the_reading():
    view = kl.link_view(kl.robots.exam_2018(), 2, [0, np.radians(20), 0.4])
    assert [knob.label for knob in view._scene.knobs] == ["θ₁*", "θ₂*", "d₃*", "stage"]
    assert "θ₂ = θ₂* + 90° = 110°" in repr(view)


def test_each_number_of_motions_has_its_part_of_the_formula():
    formula = kl.link_view(kl.robots.alpha_ii(), 2).formula
    parts = formula.split("<div data-stages=")[1:]
    assert [part[1:part.index('"', 1)] for part in parts] == ["0 1 2", "3", "4", "5", "6"]
    assert "Rot(z, θ₂)" in parts[1] and "Trans(z, 0)" in parts[2] and "Rot(x, 0)" in parts[4]
    assert "A₂ so far" in parts[3] and "A₂ = " in parts[4]


@pytest.mark.parametrize("arm, link, q, words", [
    (kl.robots.alpha_ii(), 0, None, "link: expected a whole number from 1 to 5, got 0"),
    (kl.robots.alpha_ii(), "2", None, "got '2'"), (np.eye(4), 1, None, "arm: expected a kinlab"),
    (kl.robots.alpha_ii(), 2, [0, 0], "q: expected")])
def test_bad_input_is_refused(arm, link, q, words):
    with pytest.raises(ValueError, match=words):
        kl.link_view(arm, link, q)


# ---- All frames of an arm ----


@pytest.mark.parametrize("arm", ARMS, ids=[f"{arm.name}-{arm.convention}" for arm in ARMS])
def test_the_chosen_link_is_measured_where_its_table_says(arm):
    q = pose_of(arm)
    scene = kl.frames_view(arm, q)._scene
    for link in range(1, arm.n + 1):
        at = [*q, link]
        T = kl.link_frames(arm, q)[link - 1]
        for k, name in enumerate(ORDERS[arm.convention]):
            value, frame = row(arm, link, q)[name], T @ after(arm, link, q, k)
            gid = f"link-{link}-{'dimension' if name in 'da' else 'arc'}-{k}"
            if gid not in {item.gid for item in scene.items}:
                assert value == 0 and name != arm.links[link - 1].variable
            elif name in "da":
                tail, head = places(scene, at, gid)
                close(head - tail, value * frame[:3, 2 if name == "d" else 0], atol=1e-9)
            else:
                first, *_, last = (places(scene, at, gid) - frame[:3, 3]) @ frame[:3, :3]
                about = textbook.turn(Z if name == "theta" else X, value)
                close(last, about @ first, atol=1e-9)
    assert not [item.gid for item in scene.items if item.gid.startswith("link-")
                and is_there(item, [*q, 0]) and "-arc-" in item.gid]


def test_a_row_is_told_with_its_star_and_its_matrix():
    view = kl.frames_view(kl.robots.exam_2018())
    view["link"].value = 2
    assert view.readings["row"] == ("Row 2: θ₂ = θ₂* + 90°, d₂ = 0.2 m, a₂ = 0.4 m, α₂ = 90°",)
    assert view.formula.count("data-stages") == 4 and "A₁ A₂ A₃, frame 3" in view.formula
    assert view._scene.knobs[-1].names == ("All", "Link 1", "Link 2", "Link 3")
