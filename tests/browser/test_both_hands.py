"""Both hands paint one picture: points, paint and order of the browser's are those of `still`."""
import numpy as np
import pytest
from grades import crossed, every
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from lesson_views import VIEWS
from painted import SOURCE, STYLE, TELL, assert_same, browsers, pythons, strokes
from plain import LOAD
from strategies import arms_and_q

import kinlab as kl
from kinlab.arms.joints import joint_ranges
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.controls import LAYERS
from kinlab.drawing.scene import SPATIAL

COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
SIZES = [(390, 350), (580, 520), (1100, 800)]


@pytest.fixture(scope="module")
def paper(browser):
    """A page with picture.js and the style of a view."""
    page = browser.new_page(viewport={"width": 1300, "height": 900})
    page.evaluate(LOAD, SOURCE)
    page.add_style_tag(content=STYLE)
    yield page
    page.close()


def units(size):
    """Units of the picture in a box of so many px: words are larger in one of more than 620."""
    larger = min(1.6, max(1.0, min(size) / 620))
    return tuple(side / larger for side in size)


def assert_one_picture(page, scene, q, preset, show, size):
    assert_same(browsers(page, scene, q, preset, show, size),
                pythons(scene, q, preset, show, units(size)))


@pytest.mark.parametrize("robot, preset", crossed([robot.__name__ for robot in COURSE], SPATIAL))
def test_arms_of_the_course_are_the_same_in_both_hands(paper, robot, preset):
    arm, rng = getattr(kl.robots, robot)(), np.random.default_rng(11)
    scene, (low, high) = arm_scene(arm), joint_ranges(arm)
    poses = [arm.home, *rng.uniform(low, high, (2, arm.n))]
    for q, size, show in zip(poses, SIZES, [("frames", "labels", "floor"), LAYERS, ("frames",)]):
        assert_one_picture(paper, scene, q, preset, show, size)


@settings(max_examples=30, deadline=None,
          suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(arms_and_q(), st.sampled_from(list(SPATIAL)), st.sets(st.sampled_from(LAYERS)),
       st.sampled_from(SIZES) | st.tuples(st.integers(150, 1200), st.integers(150, 1200)))
def test_any_arm_is_the_same_in_both_hands(paper, arm_and_q, preset, show, size):
    arm, q = arm_and_q
    assert_one_picture(paper, arm_scene(arm), q, preset, show, size)


@pytest.mark.parametrize("make", every(4, VIEWS.values(), VIEWS))
def test_every_view_of_the_lessons_is_the_same_in_both_hands(paper, make):
    scene = make()._scene
    rng = np.random.default_rng(5)
    low, high = np.array([(knob.low, knob.high) for knob in scene.knobs]).T
    for q in (scene.begin, rng.uniform(low, high)):
        assert_one_picture(paper, scene, q, scene.seen_from, scene.shown, scene.size)


PARTS = """() => [...document.querySelectorAll('svg path, svg text')].filter(
    node => !node.closest('defs')).map(node => ({...node.closest('[data-part]')?.dataset}))"""


def test_every_stroke_says_what_it_is_a_picture_of(paper):
    arm = kl.robots.cylindrical()
    browsers(paper, arm_scene(arm), arm.home, show=LAYERS)
    told = paper.evaluate(PARTS)
    assert all("part" in one for one in told)
    assert all({"frame", "joint", "link"} & set(one) for one in told
               if one["part"] not in ("pane", "ghost", "trace"))
    assert {"base", "link", "joint", "gripper", "frame", "label", "axis", "tip", "trace", "ghost",
            "ground", "shadow", "dropline", "foot", "numbers", "coordinates"} <= {
        one["part"] for one in told}


def seen_groups(page):
    return {one.group for one in strokes(page.evaluate(TELL))}


def test_layers_and_frames_are_switched_one_by_one(paper):
    arm = kl.robots.cylindrical()
    browsers(paper, arm_scene(arm), arm.home)
    turn = "([what, name, on]) => { picture[what](name, on); picture.draw(picture.scene.home); }"
    whole = seen_groups(paper)
    paper.evaluate(turn, ["showFrame", "1", False])
    assert whole - seen_groups(paper) == {f"{kind}-1-{axis}{end}" for axis in "xyz" for kind, end in
                                          (("frame", ""), ("frame", "-hint"), ("label", ""))}
    paper.evaluate(turn, ["show", "frames", False])
    paper.evaluate(turn, ["showFrame", "1", True])
    assert not any(group.startswith("frame-") for group in seen_groups(paper))
    paper.evaluate(turn, ["show", "frames", True])
    paper.evaluate(turn, ["show", "floor", False])
    assert whole - seen_groups(paper) == {"ground", "shadow", "foot", "dropline", "coordinates",
                                          "numbers"}
    paper.evaluate(turn, ["show", "floor", True])
    assert seen_groups(paper) == whole


def test_what_is_pointed_at_is_lit_and_all_else_steps_back(paper):
    arm = kl.robots.alpha_ii()
    browsers(paper, arm_scene(arm), arm.home)
    dim = """() => [...document.querySelectorAll('svg g[id]')].filter(
        g => !g.classList.contains('kl-dim')).map(g => g.id)"""
    everything = set(paper.evaluate(dim))
    paper.evaluate("picture.light({joints: new Set([2]), frames: new Set(['2']), "
                   "links: new Set([2])}); picture.draw(picture.scene.home)")
    lit = set(paper.evaluate(dim))
    assert {"joint-2", "frame-2-x", "label-2-x", "link-2-0"} <= lit
    assert not {"joint-1", "joint-3", "frame-1-x", "link-1-0", "gripper"} & lit
    fills = {one.group: one.fill for one in strokes(paper.evaluate(TELL))}
    paper.evaluate("picture.light(null); picture.draw(picture.scene.home)")
    assert set(paper.evaluate(dim)) == everything
    plain = {one.group: one.fill for one in strokes(paper.evaluate(TELL))}
    assert fills["gripper"] != plain["gripper"]  # paler, by its own ramp


def test_a_trace_can_be_cleared(paper):
    arm = kl.robots.two_link()
    browsers(paper, arm_scene(arm), [0, 0.3], show=LAYERS)
    paper.evaluate("[0.1, 0.2, 0.3].forEach(a => picture.draw([a, 0.3]))")
    count = "document.querySelector('#trace path').getAttribute('d').split('L').length"
    assert paper.evaluate(count) == 4
    paper.evaluate("picture.clear(); picture.draw([0.3, 0.3])")
    assert paper.evaluate(count) == 1
