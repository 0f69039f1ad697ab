"""Painter's order, against rays: of two things on one ray, the one nearer to the viewer is over."""
from itertools import combinations

import numpy as np
from hypothesis import assume, example, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from kinlab.drawing.camera import Camera, lens
from kinlab.drawing.order import Body, back_to_front
from kinlab.drawing.scene import Scene

SCENE = Scene((), (), 0, (0.0, 0.0, 0.0), 2.0)
SIZE = (580, 520)
vectors = arrays(float, 3, elements=st.floats(-1, 1).map(lambda x: round(x, 4)))
cameras = st.builds(Camera, st.floats(-180, 180), st.floats(-90, 90), perspective=st.booleans())
shares = st.floats(0.0, 1.0)


def apart(one, other):
    """The distance between two bodies' skins, at least: by many points of their middle lines."""
    steps = np.linspace(0, 1, 60)[:, None]
    a, b = (np.array(body.p) + steps * (np.array(body.q) - body.p) for body in (one, other))
    gaps = np.linalg.norm(a[:, None] - b[None], axis=-1)
    slack = (np.linalg.norm(a[1] - a[0]) + np.linalg.norm(b[1] - b[0])) / 2
    return float(gaps.min()) - slack - one.r - other.r


def through(point, way, share, r):
    """A body whose middle line goes through a point."""
    return Body(point - share * way, point + (1 - share) * way, r)


@given(cameras, vectors, st.floats(0.02, 0.9), vectors, vectors, shares, shares,
       st.sampled_from([0, 0.03, 0.1]), st.sampled_from([0.03, 0.1]))
def test_what_a_ray_meets_first_is_drawn_last(camera, point, on, way, other, s, t, r, wide):
    made = lens(SCENE, camera, SIZE)
    far = through(point, way, s, r)
    near = through(point + on * made.eye(point), other, t, wide)
    assume(apart(far, near) > 1e-6)
    assert back_to_front([far, near], made) == [0, 1]
    assert back_to_front([near, far], made) == [1, 0]


@given(cameras, vectors, st.floats(0.02, 0.9), vectors, st.sampled_from([0.02, 0.1, 0.3]),
       st.sampled_from([0.02, 0.1, 0.3]))
def test_of_two_balls_the_nearer_is_drawn_last(camera, point, on, aside, r, wide):
    """Their middles may lie on different rays, as long as one ray meets both."""
    made = lens(SCENE, camera, SIZE)
    other = point + on * made.eye(point) + 0.7 * min(r, wide) * aside / 2
    far, near = Body(point, point, r), Body(other, other, wide)
    assume(np.linalg.norm(other - point) > 1.001 * (r + wide))
    assert back_to_front([far, near], made) == [0, 1]


@given(cameras, st.lists(st.tuples(vectors, vectors, st.sampled_from([0, 0.03, 0.06])),
                         max_size=12))
@example(Camera(0, 0, perspective=False), [(np.zeros(3), np.array([x, 0, 0]), r)
                                           for x, r in ((0, 0), (1, 0), (0.5, 0.03))])
def test_an_order_holds_every_body_once_and_any_list_gives_the_same(camera, ends):
    made = lens(SCENE, camera, SIZE)
    bodies = [Body(p, p + 0.3 * d, r) for p, d, r in ends]
    order = back_to_front(bodies, made)
    assert sorted(order) == list(range(len(bodies)))
    assert back_to_front(bodies, made) == order
    depths = [round(float((np.array(body.p) + body.q) @ made.near), 5) for body in bodies]
    if len(set(depths)) == len(depths):
        back = back_to_front(bodies[::-1], made)
        assert [len(bodies) - 1 - k for k in back] == order


def test_many_balls_in_a_row_lie_as_they_are_seen():
    """Balls that do not touch can always be ordered: no pair of them is wrong."""
    rng = np.random.default_rng(3)
    made = lens(SCENE, Camera(30, 20), SIZE)
    points: list = []
    while len(points) < 60:
        point = rng.uniform(-1, 1, 3)
        if all(np.linalg.norm(point - other) > 0.41 for other in points):
            points.append(point)
    order = back_to_front([Body(point, point, 0.2) for point in points], made)
    for back, fore in combinations(order, 2):
        d = points[fore] - points[back]
        overlap = np.linalg.norm(d - (d @ made.near) * made.near) < 0.4
        assert not overlap or d @ made.near > 0


def test_a_plank_under_a_ball_whose_middle_is_farther_away():
    made = lens(SCENE, Camera(-90, 0), SIZE)   # x to the right, z up, -y to the viewer
    plank = Body((0, 0.9, 0), (0.5, -1.5, 0), 0.05)
    behind, before = Body((0, 1.1, 0), (0, 1.1, 0), 0.05), Body((0, 0.7, 0), (0, 0.7, 0), 0.05)
    assert back_to_front([plank, before, behind], made) == [2, 0, 1]


def test_in_perspective_a_plane_is_seen_from_where_the_viewer_stands():
    """Rails along the line of sight: the inner ones hide the outer ones."""
    rails = [Body((x, -1, 0), (x, 1, 0), 0.05) for x in (1, 1.2, -1.2, -1)]
    made = lens(SCENE, Camera(-90, 0, perspective=True), SIZE)
    assert back_to_front(rails, made) == [1, 0, 2, 3]


def test_a_base_lies_under_what_stands_on_it():
    base = Body((0, 0, -0.1), (0, 0, 0), 0.5, ((0, 0, 1), (0, 0, 0)))
    post = Body((0, 0.3, 0.05), (0, 0.3, 0.6), 0.1)
    for perspective in (False, True):
        above, below = (lens(SCENE, Camera(-90, tilt, perspective=perspective), SIZE)
                        for tilt in (30, -30))
        assert back_to_front([base, post], above) == back_to_front([post, base], below) == [0, 1]
