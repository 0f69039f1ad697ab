"""matplotlib's hand: the marks of the still picture, each in a named group, and a small PNG."""
import io
import os
import subprocess
import sys

import matplotlib
import numpy as np
import pytest
from grades import common
from lesson_views import RARE, VIEWS
from matplotlib.backends.backend_svg import RendererSVG
from matplotlib.transforms import IdentityTransform
from PIL import Image

import kinlab as kl
from kinlab.drawing import figure
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.controls import LAYERS
from kinlab.drawing.still import still

close = np.testing.assert_allclose
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)
DIGEST = """if True:
    import hashlib, kinlab as kl
    from kinlab.drawing import figure
    from kinlab.drawing.arm_scene import arm_scene
    arm = kl.robots.exam_2018()
    print(hashlib.sha256(figure.png(figure.figure(arm_scene(arm), arm.home))).hexdigest())
"""


def pixels(fig):
    """The PNG's colours, (height, width, 3)."""
    return np.asarray(Image.open(io.BytesIO(figure.png(fig))).convert("RGB")).astype(int)


class Groups(RendererSVG):
    """Keeps the names of groups and what is drawn in each."""

    def __init__(self, fig):
        super().__init__(*fig.size, io.StringIO(), image_dpi=72)
        self.found = []

    def open_group(self, s, gid=None):
        if s == "part":
            self.found.append([gid, 0])
        return super().open_group(s, gid)

    def draw_path(self, gc, path, transform, rgbFace=None):
        self.found[-1][1] += 1


@course
def test_every_mark_is_drawn_in_a_group_with_its_name(robot):
    arm = robot()
    scene = arm_scene(arm)
    fig = figure.figure(scene, arm.home, show=LAYERS)
    groups = Groups(fig)
    fig.draw(groups, IdentityTransform())
    drawn = still(scene, arm.home, show=LAYERS)
    assert [gid for gid, _ in groups.found] == [part.gid for part in drawn]
    full = [sum(2 if mark.text else 1 for mark in part.marks if any(map(len, mark.lines)))
            for part in drawn]
    assert [count for _, count in groups.found] == full


@pytest.mark.parametrize("make", common(VIEWS, RARE))
def test_still_pictures_of_lessons_are_small(make):
    scene = make()._scene
    fig = figure.figure(scene, scene.begin, show=scene.shown)
    picture = figure.png(fig)
    assert picture.startswith(b"\x89PNG\r\n\x1a\n") and len(picture) < 80_000
    close(np.frombuffer(picture[16:24], ">u4"), 1.5 * np.array(fig.size), atol=1)


@pytest.mark.thorough
@pytest.mark.parametrize("make", VIEWS.values(), ids=VIEWS)
def test_with_words_a_picture_has_no_empty_frame(make):
    scene = make()._scene
    fig = figure.figure(scene, scene.begin, show=scene.shown)
    plain, framed = pixels(fig), np.asarray(Image.open(io.BytesIO(
        figure.png(fig, "Run this cell"))).convert("RGB")).astype(int)
    drawn = plain.min(axis=2) < 240
    assert len(figure.png(fig, "Run this cell")) < 80_000
    inked = framed[:-66].min(axis=2) < 240  # what is drawn, and no line of it, is above them
    assert inked.sum() == pytest.approx(drawn.sum(), rel=0.02)
    cropped = np.asarray(figure._cropped(figure._pixels(fig))).min(axis=2) < 246
    assert cropped.shape == inked.shape
    for edge in (cropped[:20], cropped[-20:], cropped[:, :20], cropped[:, -20:]):
        assert edge.any()
    words = framed[-66:].min(axis=2) < 100
    assert words.sum() > 300
    left, right = np.flatnonzero(words.any(axis=0))[[0, -1]]
    assert left + right == pytest.approx(framed.shape[1], abs=60)  # in the middle


@pytest.mark.parametrize("side", ["left", "right", "middle"])
def test_words_have_their_side_where_it_is_wanted(side):
    """All lines under a picture begin below each other, however long they are."""
    for text in ("i", "speeds up or slows down by more than 143.2 deg/s²"):
        path, left = figure._letters(text, "normal", side)
        across = path.vertices[:, 0] - left + 100
        low, high = across.min(), across.max()
        assert {"left": low, "right": high, "middle": (low + high) / 2}[side] == pytest.approx(100)
        assert high > low


def test_words_have_room_under_a_small_picture():
    arm = kl.robots.two_link()
    fig = figure.figure(arm_scene(arm), arm.home, "top", ())
    narrow = Image.fromarray(np.full((50, 80, 3), 255, np.uint8))
    both = figure._under(narrow, "Run this cell to move the arm")
    assert both.width > 350 and both.height == 50 + 66
    assert figure._cropped(narrow).size == (80, 50)  # nothing is drawn: nothing is cut
    assert figure._cropped(figure._pixels(fig)).width < figure._pixels(fig).width


def test_a_pixel_has_the_colour_of_what_is_painted_there():
    arm = kl.robots.two_link()
    scene = arm_scene(arm)
    seen = pixels(figure.figure(scene, arm.home, "top", ("frames",)))
    for name, colour in (("x", (0xD5, 0x5E, 0)), ("y", (0, 0x9E, 0x73))):
        (part,) = [one for one in still(scene, arm.home, "top", ("frames",))
                   if one.gid == f"frame-E-{name}"]
        tip, wing, other = part.marks[0].lines[0][[3, 2, 4]]
        right, down = np.rint(1.5 * (tip + wing + other) / 3).astype(int)
        close(seen[down, right], colour, atol=12)


def test_the_picture_is_the_same_from_run_to_run():
    runs = {subprocess.run([sys.executable, "-c", DIGEST], check=True, capture_output=True,
                           env=os.environ | {"PYTHONHASHSEED": seed}).stdout for seed in "12"}
    assert len(runs) == 1


def test_other_layers_make_another_picture():
    arm = kl.robots.two_link()
    scene = arm_scene(arm)
    plain, framed, moved = (figure.png(figure.figure(scene, q, "top", show)) for q, show in
                            [(arm.home, ()), (arm.home, ("frames",)), ([0.1, 0.2], ())])
    assert len({plain, framed, moved}) == 3


@pytest.mark.parametrize("setting", [{"axes.facecolor": "red"}, {"font.size": 30},
                                     {"path.simplify": True}, {"savefig.facecolor": "red"}])
def test_the_users_settings_stay_and_do_not_spoil_the_picture(setting):
    arm = kl.robots.two_link()
    expected = figure.png(figure.figure(arm_scene(arm), arm.home))
    with matplotlib.rc_context(setting):
        before = dict(matplotlib.rcParams)
        assert figure.png(figure.figure(arm_scene(arm), arm.home)) == expected
        assert dict(matplotlib.rcParams) == before


def test_drawing_needs_no_pyplot_and_no_axes():
    """Nobody waits for them before a first picture."""
    code = "import sys, kinlab.drawing.figure; print(*sys.modules)"
    out = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert not {"matplotlib.pyplot", "matplotlib.axes"} & set(out.stdout.split())
    assert "matplotlib.path" in out.stdout.split()
