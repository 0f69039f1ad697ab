"""The floor on the picture, by hand and by what a light straight above must do."""
from itertools import product

import numpy as np
import pytest

from kinlab.drawing.camera import Camera, lens
from kinlab.drawing.floor import (
    FADE,
    Drop,
    RulerNumber,
    Solid,
    Words,
    drop,
    faded,
    give_way,
    ground,
    number,
    said_once,
    shadow,
    strength,
)
from kinlab.drawing.scene import Floor, Scene

SIZE = (400.0, 300.0)
FLOOR = Floor(height=0.0, step=0.5, reach=2.0)
TOP, FRONT = Camera(-90, 90), Camera(-90, 0)


def seen(camera, scale=100.0, size=SIZE):
    """A lens with the room's origin in the middle of the picture."""
    radius = (min(size) / 2 - 10) / scale
    return lens(Scene((), (), 0, (0.0, 0.0, 0.0), radius), camera, size)


def texts(numbers, axis):
    return [one.words.text for one in numbers if one.axis == axis]


def test_the_grid_from_above():
    view = ground(FLOOR, seen(TOP), SIZE)
    x, y = [[0, 150], [400, 150]], [[200, 350], [200, -50]]
    assert view.rulers == pytest.approx(np.array([x, y]))
    x_one = [[300, 150 + 100 * np.sqrt(3)], [300, 150 - 100 * np.sqrt(3)]]   # a chord at x = 1
    assert any(np.allclose(line, x_one) for line in view.grid)
    assert len(view.grid) == 16                                # 4 lines on either side, both ways
    assert np.hypot(*(view.rim - [200, 150]).T) == pytest.approx(200)
    assert not view.below


def test_numbers_stand_on_the_viewers_side():
    above, below = (ground(FLOOR, seen(Camera(-60, e)), SIZE) for e in (30, -30))
    assert (above.below, below.below) == (False, True)
    for view, sign in ((above, 1), (below, -1)):
        for one in view.numbers:
            ruler = view.rulers["xy".index(one.axis)]
            along, away = ruler[1] - ruler[0], np.array(one.words.place) - ruler[0]
            over = along[0] * away[1] - along[1] * away[0]     # y points down
            assert np.sign(over) == sign * np.sign(along[0]), one


@pytest.mark.parametrize("scale, wanted", [
    (100, ["−1.5", "−1", "−0.5", "0.5", "1", "1.5"]), (30, ["−1", "1"]), (1, []),
])
def test_as_many_numbers_as_have_room(scale, wanted):
    assert texts(ground(FLOOR, seen(TOP, scale), SIZE).numbers, "x") == wanted


@pytest.mark.parametrize("step, reach, wanted", [
    (100, 400, "−300 −200 −100 100 200 300"), (0.25, 1, "−0.75 −0.5 −0.25 0.25 0.5 0.75"),
    (0.002, 0.008, "−0.004 0.004"), (1, 4, "−3 −2 −1 1 2 3"),   # 100 px for −0.008, not 50
])
def test_numbers_are_in_the_arms_own_unit(step, reach, wanted):
    floor = Floor(0.0, step, reach)
    numbers = ground(floor, seen(TOP, 200 / reach), SIZE).numbers
    assert texts(numbers, "x") == wanted.split()


def test_numbers_have_a_true_minus_and_no_negative_zero():
    assert [number(v, 2) for v in (-0.004, 0.125, -0.125, 1e-9, -1.255)] == [
        "0.00", "0.13", "−0.13", "0.00", "−1.25"]              # 1.255 is a little less than that
    assert [number(v, 0) for v in (-0.4, 177.5, -2.5)] == ["0", "178", "−3"]


def test_no_numbers_overlap_and_all_are_inside():
    for azimuth, elevation in product(range(-180, 180, 35), (90, 60, 24, 5, 0, -30)):
        for size in ((340, 330), (1280, 700)):
            boxes = [one.words.box for one in
                     ground(FLOOR, seen(Camera(azimuth, elevation), 60, size), size).numbers]
            for i, (x, y, w, h) in enumerate(boxes):
                assert w / 2 <= x <= size[0] - w / 2 and h / 2 <= y <= size[1] - h / 2
                assert not any(abs(x - u) < (w + a) / 2 - 1e-9 and abs(y - v) < (h + b) / 2 - 1e-9
                               for u, v, a, b in boxes[i + 1:])


def test_numbers_give_way():
    numbers = [RulerNumber("x", Words(str(k), (100.0 * k, 50.0), 20.0, 14.0), 0.8)
               for k in (1, 2, 3)]
    after = give_way(numbers, [(215.0, 60.0, 11.0, 10.0), (300.0, 63.0, 30.0, 11.0)])
    assert [one.opacity for one in after] == [0.8, 0.0, 0.8]   # 15.5 px reach 2; 12.5 px miss 3


def test_the_floor_fades():
    view = ground(FLOOR, seen(Camera(0, 30)), SIZE)
    assert view.fade.center == pytest.approx((200, 150))
    assert (view.fade.radius, view.fade.squeeze) == pytest.approx((200, 0.5))
    points = [(200, 150), (310, 150), (200, 150 + 55), (200, 150 - 77.5), (500, 150)]
    assert strength(view.fade, np.array(points)) == pytest.approx([1, 0.8, 0.8, 0.4, 0])
    assert np.transpose(FADE)[0].tolist() == [0, 0.55, 1]
    assert ground(FLOOR, seen(FRONT), SIZE).fade.squeeze == 0.2
    far = [one.opacity for one in ground(FLOOR, seen(TOP), SIZE).numbers if one.words.text == "1.5"]
    assert far == pytest.approx([0.8 * 0.25 / 0.45])


def test_lines_are_cut_where_there_are_no_gradients():
    fade = ground(FLOOR, seen(TOP), SIZE).fade
    pieces, opacity = faded(fade, np.array([[[200, 150], [400, 150]], [[450, 0], [460, 0]]]), 50)
    assert pieces[:, 0, 0].tolist() == [200, 250, 300, 350]    # beyond the rim nothing is drawn
    assert opacity == pytest.approx(strength(fade, pieces.mean(axis=1)))
    assert np.all(np.diff(opacity) < 0)
    assert faded(fade, np.zeros((0, 2, 2)))[0].shape == (0, 2, 2)


# ---- shadows ----

def skin(solid, count=400):
    """Points on a solid, found in another way: turned by a matrix that takes z to its axis."""
    rng, ends = np.random.default_rng(1), np.array(solid.ends, dtype=float)
    if solid.shape == "ball":
        d = rng.normal(size=(count, 3))
        return ends[0] + solid.size[0] * d / np.linalg.norm(d, axis=1, keepdims=True)
    a, b = ends[:2]
    if solid.shape == "box":
        u, v = ends[2:] - a
        s = rng.uniform(-1, 1, (count, 2))
        return a + rng.uniform(size=(count, 1)) * (b - a) + s[:, :1] * u + s[:, 1:] * v
    basis, _ = np.linalg.qr(np.column_stack([b - a, rng.normal(size=(3, 2))]))
    angle, share = rng.uniform(0, 2 * np.pi, count), rng.uniform(size=count).round()
    radius = solid.size[0] + share * (solid.size[1] - solid.size[0])
    ring = np.outer(np.cos(angle), basis[:, 1]) + np.outer(np.sin(angle), basis[:, 2])
    return a + share[:, None] * (b - a) + radius[:, None] * ring


def outside(points, outline):
    """How far the farthest point lies outside a convex outline."""
    edges = np.roll(outline, -1, axis=0) - outline
    normals = np.stack([edges[:, 1], -edges[:, 0]], axis=-1)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    middle = outline.mean(axis=0)
    normals *= np.sign(np.einsum("ij,ij->i", normals, outline - middle))[:, None]
    return float(np.einsum("ijk,jk->ij", points[:, None] - outline, normals).max())


@pytest.mark.parametrize("solid", [
    Solid("ball", np.array([[0.5, 0.2, 1.0]]), (0.3,)),
    Solid("tube", np.array([[0.1, 0, 0.2], [0.9, 0.4, 0.8]]), (0.3, 0.2)),
    Solid("tube", np.array([[0.1, 0, 0.2], [0.1, 0, 0.8]]), (0.3, 0.2)),
    Solid("tube", np.array([[-0.5, 0, 0.2], [0.3, 0, 0.2]]), (0.1, 0.1)),
    Solid("box", np.array([[0, 0, 0], [0.3, 0.1, 0.1], [0, 0.1, 0], [0.02, 0, 0.1]]), ()),
], ids=["ball", "cone", "upright", "lying", "box"])
def test_a_shadow_is_the_outline_of_a_solid_from_above(solid):
    floor, look = Floor(-0.4, 0.5, 2.0), seen(Camera(30, 40))
    points = skin(solid)
    points[:, 2] = -0.4
    (outline,) = shadow(floor, look, [solid])
    fallen = look.see(points)[:, :2]
    assert outside(fallen, outline) < 0.6       # px: an outline of 16 sides cuts its circle's rim
    for k in range(2):
        assert np.ptp(outline[:, k]) == pytest.approx(np.ptp(fallen[:, k]), abs=4)


# ---- lines dropped on the floor ----

def test_a_drop_line():
    line = drop(FLOOR, seen(FRONT), SIZE, (1.0, -0.004, 0.8))
    assert line.line == pytest.approx(np.array([[300, 70], [300, 150]]))
    assert line.ends == pytest.approx(np.array([[1, -0.004, 0.8], [1, -0.004, 0]]))
    assert line.guides == pytest.approx(np.array([[[300, 150]] * 2, [[300, 150], [200, 150]]]))
    foot, height = line.texts
    assert (foot.text, height.text) == ("(1.00, 0.00)", "z 0.80")
    assert foot.place[1] == 165
    assert height.place == pytest.approx((300 + height.w / 2 + 6, 110))


def test_a_drop_line_from_above_is_a_point_with_guides():
    line = drop(FLOOR, seen(TOP), SIZE, (0.5, 1.0, 0.8))
    assert line.line[0] == pytest.approx(line.line[1])
    assert line.guides == pytest.approx(np.array([[[250, 50], [250, 150]], [[250, 50], [200, 50]]]))
    assert [words.text for words in line.texts] == ["(0.50, 1.00)"]
    assert np.hypot(*(line.foot - [250, 50]).T) == pytest.approx(5)


def test_texts_of_a_drop_line_stay_inside_or_away():
    beyond = drop(FLOOR, seen(FRONT), SIZE, (9.0, 0.0, 0.8)).texts
    assert [words.text for words in beyond] == ["z 0.80"]
    assert beyond[0].place[0] + beyond[0].w / 2 <= 400
    under = drop(FLOOR, seen(FRONT), SIZE, (1.0, 0.0, -0.8)).texts
    assert (under[0].place[1], under[1].text) == (135, "z −0.80")   # over the foot


@pytest.mark.parametrize("perspective", [False, True])
@pytest.mark.parametrize("camera", [(-90, 90), (-90, 0), (0, 0), (0, -90), (45, 1e-9), (0, 90)])
def test_every_number_is_finite_from_every_side(camera, perspective):
    look, floor = seen(Camera(*camera, perspective=perspective)), Floor(0.1, 0.5, 2.0)
    view, line = ground(floor, look, SIZE), drop(floor, look, SIZE, (0.0, 0.0, 0.1))
    flat = Solid("tube", np.zeros((2, 3)), (0.0, 0.0))
    arrays = [view.grid, view.rulers, view.rim, line.line, line.foot, line.guides,
              *shadow(floor, look, [flat]), np.array([view.fade.radius, view.fade.squeeze]),
              np.array([(*one.words.box, one.opacity) for one in view.numbers]),
              np.array([words.box for words in line.texts])]
    assert all(np.isfinite(array).all() for array in arrays)


def test_coordinates_that_stand_on_each_other_are_said_once():
    def texts(*named):
        empty = np.zeros((0, 2))
        said = [Words(text, (x, 100.0), 50.0, 16.0) for text, x in named]
        return Drop(empty, empty, empty, empty, said)
    drops = [texts(("(4, 0)", 30.0), ("z 2", 90.0)), texts(("(4, 0)", 31.0), ("z 2", 140.0))]
    assert [words.place[0] for words in said_once(drops)] == [30, 90, 140]
