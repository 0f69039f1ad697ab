"""Both hands paint one picture: points, paint and order of the browser's are those of `still`."""
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from lesson_views import VIEWS
from painted import SOURCE, STYLE, assert_same, browsers, pythons
from plain import LOAD
from strategies import arms_and_q

import kinlab as kl
from kinlab.arms.joints import joint_ranges
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.controls import LAYERS
from kinlab.drawing.scene import SPATIAL

COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)
SIZES = [(390, 350), (580, 520), (1100, 800)]


@pytest.fixture(scope="module")
def paper(browser):
    """A page with picture.js and the style of a view."""
    page = browser.new_page(viewport={"width": 1300, "height": 900})
    page.evaluate(LOAD, SOURCE)
    page.add_style_tag(content=STYLE)
    yield page
    page.close()


def assert_one_picture(page, scene, q, preset, show, size):
    assert_same(browsers(page, scene, q, preset, show, size),
                pythons(scene, q, preset, show, size))


@course
@pytest.mark.parametrize("preset", SPATIAL)
def test_arms_of_the_course_are_the_same_in_both_hands(paper, robot, preset):
    arm, rng = robot(), np.random.default_rng(11)
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


@pytest.mark.parametrize("make", VIEWS.values(), ids=VIEWS)
def test_every_view_of_the_lessons_is_the_same_in_both_hands(paper, make):
    scene = make()._scene
    rng = np.random.default_rng(5)
    low, high = np.array([(knob.low, knob.high) for knob in scene.knobs]).T
    for q in (scene.begin, rng.uniform(low, high)):
        assert_one_picture(paper, scene, q, scene.seen_from, scene.shown, scene.size)
