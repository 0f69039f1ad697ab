"""Labels that make room for each other, by numbers typed here and at poses of the course's arms."""
from dataclasses import replace

import numpy as np
import pytest
from ground_fixtures import crowded

import kinlab as kl
from kinlab.drawing.camera import Camera
from kinlab.drawing.labels import Bar, Label, LabelState, place, text_size

SIZE = (580.0, 520.0)
ARMS = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
        kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]


def arrow(start, tip, state=None):
    return Label(tip, start, 17.0, 14.0, state)


def words(anchor, w=60.0):
    return Label(anchor, None, w, 14.0)


def overlaps(labels, places, fixed=(), by=2.0):
    """How many pairs of labels, or of a label and something fixed, overlap by more than so much."""
    boxes = [(one.x, one.y, label.w, label.h) for one, label in zip(places, labels) if one]
    rest = [*boxes, *fixed]
    return sum(abs(x - u) < (w + a) / 2 - by and abs(y - v) < (h + b) / 2 - by
               for i, (x, y, w, h) in enumerate(boxes) for u, v, a, b in rest[i + 1:])


def carried(labels, places):
    """The labels as the next picture has them."""
    return [replace(label, state=one and one.state) for label, one in zip(labels, places)]


def rested(labels, *crowd):
    """Places after all have come to rest, and how many pictures that took."""
    for count in range(200):
        places, restless = place(labels, *crowd)
        if not restless:
            return places, count
        labels = carried(labels, places)
    raise AssertionError("labels never come to rest")


def some_pose(arm, rng):
    return np.array([rng.uniform(*link.limits) if link.limits else rng.uniform(-np.pi, np.pi)
                     for link in arm.links])


def test_widths_of_words():
    assert text_size("x₁") == pytest.approx((8.3 + 5.4, 14))
    assert text_size("−1.5") == pytest.approx((11.6 + 8.3 + 5 + 8.3, 14))
    assert text_size("e\u0307") == text_size("e")   # a dot over it takes no room
    assert text_size("") == (0, 14)


@pytest.mark.parametrize("start, tip, wanted", [
    ((100, 100), (150, 100), (150 + 8.5 + 3, 100 + 4)),   # half the width, 3 px, and 4 aside
    ((150, 100), (100, 100), (100 - 8.5 - 3, 100 - 4)),
    ((300, 150), (300, 100), (300 + 4, 100 - 7 - 3)),
    ((300, 100), (300, 150), (300 - 4, 150 + 7 + 3)),
    ((100, 300), (100, 300), (110, 291)),                 # seen end-on: above, to the right
    (None, (400, 400), (400, 400)),
])
def test_a_label_alone_stands_where_it_wants_to(start, tip, wanted):
    (one,), restless = place([arrow(start, tip)], [], [], [], SIZE)
    assert (one.x, one.y) == pytest.approx(wanted)
    assert one.leader is None
    assert restless                                       # one more picture, in which it stands
    (same,), restless = place([arrow(start, tip, one.state)], [], [], [], SIZE)
    assert ((same.x, same.y), restless) == ((one.x, one.y), False)


def test_what_asks_for_one_place_stands_side_by_side():
    labels, fixed = [words((300, 200))] * 8, [(300, 200, 50, 20)]
    places, _ = place(labels, [], [], fixed, SIZE)
    assert overlaps(labels, places, fixed) == 0
    assert overlaps(labels, [place([one], [], [], [], SIZE)[0][0] for one in labels]) == 28


def test_labels_stay_inside_the_picture():
    corners = [(0, 0), (580, 0), (0, 520), (580, 520), (290, 0)]
    places, _ = place([words(corner) for corner in corners], [], [], [], SIZE)
    for one in places:
        assert 32 <= one.x <= 548
        assert 9 <= one.y <= 511
    assert [place([words(p)], [], [], [], SIZE)[0] for p in ((-1, 50), (50, 521))] == [[None]] * 2


def test_a_picture_narrower_than_a_label_holds_it_in_its_middle():
    (one,), _ = place([words((5, 5), w=300)], [], [], [], (100, 40))
    assert one.x == 50


def test_labels_keep_off_strokes_and_solids():
    label = [words((300, 200), w=20)]
    (over,), _ = place(label, [Bar((200, 203), (400, 203))], [], [], SIZE)
    assert over.y < 197.5
    (off,), _ = place(label, [], [Bar((300, 210), (300, 210), 15)], [], SIZE)
    assert off.y < 194
    (free,), _ = place(label, [Bar((200, 240), (400, 240))], [Bar((300, 280), (400, 280), 50)], [],
                       SIZE)
    assert (free.x, free.y) == (300, 200)


def test_an_arrow_pushes_the_labels_of_others_but_not_its_own():
    """The second label wants to stand on the first one's arrow."""
    first, second = arrow((100, 100), (200, 100)), words((150, 103), w=20)
    places, _ = place([first, second], [], [], [], SIZE)
    assert (places[0].x, places[0].y) == pytest.approx((211.5, 104))
    assert places[1].y > 105.5


def test_a_leader_ends_at_the_words():
    (one,), _ = place([words((300, 200))], [], [], [(300, 200, 80, 60)], SIZE)
    (start, end), up = one.leader, np.sign(one.y - 200)
    assert start == pytest.approx((300, 200 + 2 * up))
    assert end == pytest.approx((300, one.y - 7 * up))
    assert abs(one.y - 200) >= 30 + 7


def test_a_label_without_words_is_no_trouble():
    (one,), _ = place([Label((300, 200), None, *text_size(""))], [], [], [], SIZE)
    assert (one.x, one.y, one.leader) == (300, 200, None)
    assert place([], [], [], [], SIZE) == ([], False)


def test_nothing_jumps_while_an_arm_moves_and_all_comes_to_rest():
    arm, rng = kl.robots.practical_six_link(), np.random.default_rng(3)
    start, end = some_pose(arm, rng), some_pose(arm, rng)
    places, crowd = None, None
    for share in np.linspace(0, 1, 40):
        labels, *crowd = crowded(arm, start + share * (end - start), Camera(-60, 24), SIZE)
        labels = carried(labels, places) if places else labels
        places, _ = place(labels, *crowd, SIZE)
        for label, one in zip(labels, places):
            if label.state and one and 40 < one.x < 540 and 20 < one.y < 500:
                step = np.hypot(one.state.x - label.state.x, one.state.y - label.state.y)
                assert step <= 6 + 1e-9
    places, pictures = rested(carried(labels, places), *crowd, SIZE)
    assert pictures <= 91
    assert overlaps(labels, places, crowd[2]) == 0
    still, restless = place(carried(labels, places), *crowd, SIZE)
    assert not restless
    assert max(np.hypot(a.x - b.x, a.y - b.y) for a, b in zip(still, places) if a) < 0.2


def test_a_new_label_does_not_move_the_others_by_more_than_a_step():
    old = [words((300, 200)), words((330, 210))]
    places, _ = rested(old, [], [], [], SIZE)
    joined, _ = place([*carried(old, places), words((315, 205))], [], [], [], SIZE)
    for was, now in zip(places, joined):
        assert np.hypot(now.x - was.x, now.y - was.y) <= 6 + 1e-9
    assert overlaps([*old, words((315, 205))], joined) == 0


def test_a_label_comes_back_when_its_usual_spot_is_free():
    stood = LabelState(0.0, 45.0, 19, 5, (300.0, 200.0))   # two rings out, below its anchor
    label, box = replace(words((300.0, 200.0), w=20), state=stood), (300.0, 200.0, 20.0, 20.0)
    away, _ = rested([label], [], [], [box], SIZE)
    assert (away[0].x, away[0].y, away[0].state.spot) == pytest.approx((300, 229, 19), abs=0.5)
    back, _ = rested(carried([label], away), [], [], [], SIZE)
    assert (back[0].x, back[0].y, back[0].state.spot) == pytest.approx((300, 200, 0), abs=0.5)


@pytest.mark.parametrize("size", [(340, 330), (390, 380), (580, 520), (1280, 700), (1900, 950)])
@pytest.mark.parametrize("make", ARMS, ids=lambda make: make.__name__)
def test_no_two_labels_of_an_arm_overlap(make, size):
    """At home none do; at other poses there may not be room for all."""
    arm, rng = make(), np.random.default_rng(size[0])
    found = []
    for q in [np.array(arm.home), *(some_pose(arm, rng) for _ in range(9))]:
        labels, *crowd = crowded(arm, q, Camera(-60, 24), size)
        places, _ = place(labels, *crowd, size)
        found.append(overlaps(labels, places, crowd[2]))
    assert found[0] == 0
    assert np.mean(found) <= 0.2
