"""Lit faces of solids against what can be worked out without them."""
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import points, poses, rotations

from kinlab.drawing.paints import PAINTS
from kinlab.drawing.solids import OFFSETS, Across, Round, faces, hull, shades

close = np.testing.assert_allclose
LIGHT = np.array([-0.5, 0.72, 0.62]) / np.sqrt(0.5 ** 2 + 0.72 ** 2 + 0.62 ** 2)
PLAIN, CAPPED, HUBBED = PAINTS["steel"], PAINTS["base"], PAINTS["iron"]
ROOM = np.eye(4)
radii = st.sampled_from([0.0, 0.2, 1.0]) | st.floats(0, 2, allow_subnormal=False)


@dataclass
class Camera:
    """Rows right, up and near; with `distance`, how far away the viewer is from the origin."""

    rows: np.ndarray
    scale: float = 10.0
    distance: float = np.inf

    def see(self, p):
        right, up, near = self.rows @ np.moveaxis(np.asarray(p, float), -1, 0)
        size = 1 / (1 - near / self.distance)
        s = self.scale * size
        return np.stack([300 + s * right, 200 - s * up, size + 0 * s], axis=-1)

    def eye(self, p):
        near = self.rows[2]
        return near if np.isinf(self.distance) else self.distance * near - p

    def turn(self, d):
        return self.rows @ d


TOP, FRONT = Camera(np.eye(3)), Camera(np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]]))
cameras = st.builds(Camera, rotations(), st.sampled_from([10.0, 40.0]), st.just(np.inf))
eyes = st.builds(Camera, rotations(), st.sampled_from([10.0, 40.0]),
                 st.sampled_from([30.0, np.inf]))


def tilted(degrees):
    """A camera that looks at the room's z axis: 90 from its tip, 0 from beside it."""
    s, c = np.sin(np.radians(degrees)), np.cos(np.radians(degrees))
    return Camera(np.array([[1, 0, 0], [0, s, c], [0, -c, s]]))


def tube(camera, ends, sizes, paint=PLAIN, frame=ROOM):
    return faces("tube", camera, np.array(ends, float), sizes, paint, frame)


def box(camera, ends, paint=PLAIN, *, ahead=(), frame=ROOM):
    return faces("box", camera, np.array(ends, float), ahead, paint, frame)


def only(role, found):
    return [face for face in found if face.role == role]


def brightness(n):
    """The law of light, typed a second time."""
    return np.clip(-0.06 + 0.76 * (0.5 + 0.5 * n @ LIGHT) ** 1.3 + 0.36 * max(0, n[2]), 0, 1)


SLOTS = np.linspace(-0.7, 0.7, 71)
BRIGHTEST = max(((x, y, np.sqrt(1 - x * x - y * y)) for x in SLOTS for y in SLOTS),
                key=lambda n: brightness(np.array(n)))


def reach(corners, directions):
    """How far points reach in each direction: two convex outlines are one if these are."""
    return np.max(directions @ np.asarray(corners).T, axis=-1)


def around(count=24):
    angles = np.arange(count) * 2 * np.pi / count
    return np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def area(corners):
    (x, y), (u, v) = np.transpose(corners), np.transpose(np.roll(corners, -1, axis=0))
    return abs(np.sum(x * v - u * y)) / 2


def inside(p, ends, sizes):
    """Whether a point lies within a tube, well off its surface."""
    along = ends[1] - ends[0]
    share = (p - ends[0]) @ along / (along @ along)
    far = np.linalg.norm(p - ends[0] - share * along)
    return 1e-9 < share < 1 - 1e-9 and far < sizes[0] + share * (sizes[1] - sizes[0]) - 1e-9


# ---- outlines ----

def test_a_hull_leaves_out_what_lies_within_and_on_its_sides():
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    close(hull([*square, (2, 2), (2, 0), (0, 0), (4, 3)]), square)


def test_a_hull_of_points_on_a_line_is_its_two_ends():
    close(hull([(1, 1), (3, 3), (2, 2), (0, 0)]), [(0, 0), (3, 3)])
    close(np.unique(hull([(5, 7)] * 3), axis=0), [(5, 7)])


@given(st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9)), min_size=3, max_size=30))
def test_a_hull_is_convex_and_reaches_as_far_as_its_points(given_points):
    corners = hull(given_points)
    close(reach(corners, around()), reach(given_points, around()), atol=1e-12)
    assert {tuple(corner) for corner in corners} <= set(given_points)
    if len(corners) > 2:
        after, next_ = np.roll(corners, -1, axis=0), np.roll(corners, -2, axis=0)
        (a, b), (c, d) = (after - corners).T, (next_ - after).T
        assert np.all(a * d - b * c > 0)


@given(cameras, points, points, radii, radii)
def test_the_outline_of_a_tube_is_that_of_its_two_discs(camera, p, q, first, second):
    """A disc reaches as far in a direction as the part of it that lies in the disc's plane."""
    assume(np.linalg.norm(q - p) > 1e-3)
    along = (q - p) / np.linalg.norm(q - p)
    across = around() @ (camera.rows[:2] * [[1], [-1]])   # down on the picture is not up
    share = np.linalg.norm(across - np.outer(across @ along, along), axis=-1)
    middles = camera.see(np.array([p, q]))[:, :2] @ around().T
    true = np.max(middles + camera.scale * np.outer((first, second), share), axis=0)
    got = reach(tube(camera, [p, q], (first, second))[0].points, around())
    radius = camera.scale * max(first, second)
    missing = 1 - np.cos(np.pi / (36 if radius > 34 else 18))
    assert np.all(got <= true + 1e-8) and np.all(got >= true - missing * radius - 1e-8)


@given(eyes, points, points, radii, radii, st.floats(0, 7), st.floats(0, 1))
def test_no_point_of_a_tube_lies_outside_its_outline(camera, p, q, first, second, angle, share):
    assume(np.linalg.norm(q - p) > 1e-3)
    along = (q - p) / np.linalg.norm(q - p)
    u = np.cross(along, np.eye(3)[np.argmin(abs(along))])
    u /= np.linalg.norm(u)
    out = np.cos(angle) * u + np.sin(angle) * np.cross(along, u)
    point = p + share * (q - p) + (first + share * (second - first)) * out
    outline = tube(camera, [p, q], (first, second))[0].points
    room = 0.02 * camera.scale * 1.3 * max(first, second) + 1e-8
    seen = around(60) @ camera.see(point)[:2]
    assert np.all(seen <= reach(outline, around(60)) + room)


@pytest.mark.parametrize(("radius", "sides"), [(3.4, 18), (3.41, 36)])
def test_circles_are_finer_when_they_are_large(radius, sides):
    (cap,) = only("cap", tube(TOP, [(0, 0, 0), (0, 0, 1)], (radius, 1), CAPPED))
    (ball,) = faces("ball", TOP, np.zeros((1, 3)), (radius,), PLAIN, ROOM)
    assert len(cap.points) == len(ball.points) == sides


@pytest.mark.parametrize("sizes", [(2, 1), (1, 2)])
def test_seen_end_on_the_wider_end_is_the_outline(sizes):
    outline = tube(TOP, [(0, 0, 0), (0, 0, 5)], sizes)[0].points - (300, 200)
    close(np.hypot(*outline.T), 20.0)
    assert len(outline) == 18


# ---- ends ----

@given(eyes, points, points, radii, radii)
def test_an_end_is_seen_where_nothing_of_the_tube_is_before_it(camera, p, q, first, second):
    ends, sizes = np.array([p, q]), (max(first, 0.1), max(second, 0.1))
    assume(np.linalg.norm(q - p) > 1e-2)
    looks = [camera.eye(end) / np.linalg.norm(camera.eye(end)) for end in ends]
    along = (q - p) / np.linalg.norm(q - p)
    assume(all(abs(look @ along) > 1e-4 for look in looks))
    free = [not inside(end + 1e-3 * look, ends, sizes) for end, look in zip(ends, looks)]
    caps = only("cap", tube(camera, ends, sizes, CAPPED))
    assert len(caps) == sum(free) <= 1
    for cap in caps:
        k = free.index(True)
        true = camera.see(ends[k])[:2]
        close(cap.points.mean(axis=0), true, atol=0.2 * camera.scale * sizes[k])
        assert np.all(reach(cap.points - true, around(8)) <= 1.3 * camera.scale * sizes[k])


@pytest.mark.parametrize("ends", [[(0, 0, 0), (0, 0, 1)], [(0, 0, 1), (0, 0, 0)]])
def test_a_cap_is_lighter_than_its_hub_which_is_smaller(ends):
    (cap,), (hub,) = (only(role, tube(TOP, ends, (2, 2), HUBBED)) for role in ("cap", "hub"))
    assert (cap.level, hub.level) == (27, 23)
    close(np.hypot(*(cap.points - (300, 200)).T), 20.0)
    close(np.hypot(*(hub.points - (300, 200)).T), 13.2)


@pytest.mark.parametrize(("style", "roles"), [
    ("steel", ["side"]), ("base", ["side", "cap"]), ("iron", ["side", "cap", "hub", "mark"]),
    ("sleeve", ["side", "hub", "mark"])])
def test_the_paint_says_what_an_end_has(style, roles):
    found = tube(TOP, [(0, 0, 0), (0, 0, 1)], (1, 1), PAINTS[style])
    assert [face.role for face in found] == roles


def test_from_beside_no_end_is_seen():
    found = tube(FRONT, [(0, 0, 0), (0, 0, 1)], (1, 1), HUBBED)
    assert not only("cap", found) and not only("hub", found)


# ---- the stripe ----

@pytest.mark.parametrize("degrees", [0, 30, 90, 200])
def test_the_stripe_on_an_end_turns_with_the_frame(degrees):
    a = np.radians(degrees)
    c, s = np.cos(a), np.sin(a)
    frame = np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    (mark,) = only("mark", tube(TOP, [(0, 0, 0), (0, 0, 1)], (2, 2), HUBBED, frame))
    close(mark.points, [(300 + r * c, 200 - r * s) for r in (13.2, 20)], atol=1e-9)


def test_a_tube_across_its_frame_has_its_stripe_at_the_z_axis():
    (mark,) = only("mark", tube(TOP, [(-1, 0, 0), (1, 0, 0)], (1, 1), HUBBED))
    close(mark.points, [(310, 200), (290, 200)], atol=1e-9)   # looks up at the viewer


@given(eyes, poses())
def test_the_stripe_runs_down_the_skin_where_it_is_seen(camera, frame):
    camera.distance *= 2                                # nothing may stand behind the viewer
    ends = frame[:3, 3] + np.outer((0, 2), frame[:3, 2])
    rims = ends + frame[:3, 0]
    look = camera.eye(rims.mean(axis=0))
    look = look / np.linalg.norm(look)
    assume(abs(look @ frame[:3, 0]) > 1e-3)
    seen = not inside(rims.mean(axis=0) + 1e-3 * look, ends, (1, 1))
    marks = only("mark", tube(camera, ends, (1, 1), HUBBED, frame))
    pixels = camera.see(rims)[:, :2]
    drawn = [] if not marks else [np.any(np.all(np.isclose(marks[0].points, p), axis=-1))
                                  for p in pixels]
    caps = len(only("cap", tube(camera, ends, (1, 1), HUBBED, frame)))
    assert sum(drawn) == (2 if seen else caps)


# ---- light ----

@pytest.mark.parametrize(("camera", "levels"), [
    (FRONT, (12, 23, 23, 16, 2)),                       # light comes from the left
    (TOP, (23, 23, 23, 23, 23)),                        # its end is all that is seen
])
def test_levels_of_an_upright_tube_worked_out_by_hand(camera, levels):
    (side,) = tube(camera, [(0, 0, 0), (0, 0, 4)], (1, 1))
    assert side.gradient.levels == levels


def test_levels_run_across_a_tube_as_wide_as_it_is():
    (side,) = tube(FRONT, [(0, 0, 0), (0, 0, 4)], (1, 0.5))
    start, end, _ = side.gradient
    close([start, end], [(290, 180), (310, 180)])
    assert OFFSETS[Across] == pytest.approx((0, 0.175, 0.5, 0.825, 1))


@given(eyes, points, points, radii, radii)
def test_a_capped_tube_is_lit_by_where_its_skin_looks(camera, p, q, first, second):
    """Normals by differences of the skin's own points, on the side that is seen."""
    along, L, look = q - p, np.linalg.norm(q - p), camera.eye((p + q) / 2)
    assume(L > 1e-2 and max(first, second) > 0.05)
    along, across = along / L, np.cross(along, look / np.linalg.norm(look))
    assume(np.linalg.norm(across) > 1e-3)
    across /= np.linalg.norm(across)
    ahead = np.cross(across, along)
    ahead *= np.sign(ahead @ look)
    gradient = tube(camera, [p, q], (first, second), CAPPED)[0].gradient
    way = (camera.turn(across)[:2] * (1, -1)) @ (gradient.end - gradient.start)
    for u, level in zip((-1, -0.65, 0, 0.65, 1), gradient.levels):
        out = u * np.sign(way) * across + np.sqrt(1 - u * u) * ahead
        down_skin, round_it = L * along + (second - first) * out, np.cross(along, out)
        normal = np.cross(round_it, down_skin)
        normal *= np.sign(normal @ out) / np.linalg.norm(normal)
        assert abs(level - 27 * brightness(camera.turn(normal))) < 0.5 + 1e-6


@given(eyes, points, rotations())
def test_a_gradient_runs_across_its_tube(camera, p, axes):
    """As the tube appears: in perspective, too."""
    along = 1e-3 * axes[0]
    look = camera.eye(p) / np.linalg.norm(camera.eye(p))
    assume(np.linalg.norm(np.cross(axes[0], look)) > 0.1)
    gradient = tube(camera, [p - along, p + along], (1, 1))[0].gradient
    shaft = np.diff(camera.see(np.array([p - along, p + along]))[:, :2], axis=0)[0]
    way = gradient.end - gradient.start
    assert abs(shaft @ way) < 1e-3 * np.linalg.norm(shaft) * np.linalg.norm(way)


def test_a_link_that_turns_its_end_to_the_viewer_never_flickers():
    looks = [tube(tilted(degrees), [(0, 0, 0), (0, 0, 4)], (1, 0.8))[0].gradient.levels
             for degrees in range(-90, 91)]
    assert np.max(np.abs(np.diff(looks, axis=0))) <= 2
    assert set(looks[-1]) == {23} and set(looks[0]) == {23}   # a disc across the line of sight


# ---- balls ----

@given(eyes, points, radii)
def test_a_ball_is_round_and_brightest_where_the_law_says(camera, p, radius):
    (face,) = faces("ball", camera, p[None], (radius,), PLAIN, ROOM)
    *middle, near = camera.see(p)
    r = radius * camera.scale * near
    close(np.hypot(*(face.points - middle).T), r, atol=1e-9)
    spot = r * np.array(BRIGHTEST[:2]) * (1, -1)
    close(face.gradient.center, middle + spot, atol=0.02 * r + 1e-9)


def test_levels_of_a_ball_worked_out_by_hand():
    (face,) = faces("ball", TOP, np.zeros((1, 3)), (1.0,), PLAIN, ROOM)
    assert face.gradient.levels == (26, 20, 0) and OFFSETS[Round] == (0, 0.5, 1)
    close(face.gradient.center, (297, 195.7))
    close(face.gradient.radius, 10 * (1 + np.hypot(0.3, 0.43)))


# ---- boxes ----

UPRIGHT = [(0, 0, 0), (0, 0, 4), (1, 0, 0), (0, 2, 0)]


def test_a_box_from_above_is_its_upper_end():
    (end,) = box(TOP, UPRIGHT, PAINTS["sleeve"])
    assert (end.role, end.level) == ("hub", 23)
    assert {tuple(p) for p in end.points} == {(x, y) for x in (290, 310) for y in (180, 220)}
    assert box(TOP, UPRIGHT)[0].role == "face"


def test_levels_of_a_box_worked_out_by_hand():
    """Faces look half at the viewer, and half to the right, to the left, up and down."""
    half = np.sqrt(0.5)
    right = Camera(np.array([[half, half, 0], [0, 0, 1], [half, -half, 0]]))
    assert sorted(face.level for face in box(right, UPRIGHT)) == [14, 22]
    above = Camera(np.array([[1, 0, 0], [0, half, half], [0, -half, half]]))
    assert sorted(face.level for face in box(above, UPRIGHT)) == [13, 24]


@given(eyes, points, points, points, points)
def test_the_faces_of_a_box_cover_its_outline_once(camera, p, along, u, v):
    size = max(np.linalg.norm(u), np.linalg.norm(v))
    assume(np.linalg.norm(along) > 0.01 * size)
    found = box(camera, [p, p + along, p + u, p + v])
    corners = [p + i * u + j * v + k * along for i in (-1, 1) for j in (-1, 1) for k in (0, 1)]
    outline = hull(camera.see(np.array(corners))[:, :2])
    assert len(found) <= 3
    close(sum(area(face.points) for face in found), area(outline), rtol=1e-6, atol=1e-4)


@given(cameras, rotations(), points)
def test_the_faces_of_a_box_are_lit_by_where_they_look(camera, axes, sizes):
    sizes = np.abs(sizes) + 0.1
    along, u, v = axes * sizes[:, None]
    looks = [camera.turn(side * axis) for axis in axes for side in (1, -1)]
    assume(all(abs(n[2]) > 1e-6 for n in looks))
    wanted = sorted(27 * brightness(n) for n in looks if n[2] > 0)
    got = sorted(face.level for face in box(camera, [0 * u, along, u, v]))
    close(got, wanted, rtol=0, atol=0.5 + 1e-6)


@pytest.mark.parametrize(("style", "roles"), [
    ("steel", ["face"] * 3), ("sleeve", ["hub", "face", "face"])])
def test_the_ends_of_a_sleeve_have_their_own_colours(style, roles):
    corner = Camera(np.linalg.qr(np.array([[1, 2, 3], [2, 1, 1], [1, 1, 2]]).T)[0].T)
    assert [face.role for face in box(corner, UPRIGHT, PAINTS[style])] == roles


def test_a_rod_wholly_inside_its_sleeve_is_hidden():
    down = [(0, 0, 0), (0, 0, -4), (1, 0, 0), (0, 1, 0)]
    assert box(TOP, UPRIGHT, ahead=(1.0,)) and not box(TOP, down, ahead=(1.0,)) and box(TOP, down)
    over = np.diag([1.0, -1.0, -1.0, 1.0])                    # z of this frame points down
    assert box(TOP, down, ahead=(1.0,), frame=over)
    assert not box(TOP, UPRIGHT, ahead=(1.0,), frame=over)


@pytest.mark.parametrize(("length", "faces_"), [(0.0, 0), (0.0009, 0), (0.0011, 1)])
def test_a_box_shorter_than_a_hair_is_hidden(length, faces_):
    assert len(box(TOP, [(0, 0, 0), (0, 0, length), (1, 0, 0), (0, 1, 0)])) == faces_


# ---- whatever is asked ----

@given(eyes, st.sampled_from(["tube", "ball", "box"]), st.lists(points, min_size=4, max_size=4),
       radii, radii, st.sampled_from([PLAIN, CAPPED, HUBBED]), poses(), st.booleans())
def test_there_is_an_answer_for_every_solid(camera, shape, given_points, first, second, paint,
                                            frame, flat):
    ends = np.array(given_points) * (0 if flat else 1)
    for face in faces(shape, camera, ends, (first, second), paint, frame):
        assert np.all(np.isfinite(face.points)) and face.points.shape[1] == 2
        levels = [face.level] if face.gradient is None else face.gradient.levels
        assert face.role == "mark" or all(level in range(28) for level in levels)
        assert face.gradient is None or np.all(np.isfinite(np.hstack(face.gradient)))


# ---- colours ----

def test_shades_go_evenly_from_the_first_colour_by_the_second_to_the_third():
    grey = shades(("#000000", "#1b1b1b", "#363636"))
    assert grey == [f"#{2 * k:02x}{2 * k:02x}{2 * k:02x}" for k in range(28)]
    steel = shades(PAINTS["steel"]["ramp"])
    assert (steel[0], steel[13], steel[14], steel[27]) == ("#6f7c89", "#b0bcc7", "#b5c0cb",
                                                           "#f6f8fa")
