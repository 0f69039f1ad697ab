"""Exercises with other numbers: each is judged by its own, which a formula of its own answers."""
from math import acos, asin, atan2, cos, hypot, pi, radians, sin

import numpy as np
import pytest
from hostile import TEXTS
from solved import RIGHT

import kinlab as kl
from kinlab import lessons
from kinlab.answers.varied import Draw
from kinlab.marks import record

SEEDS = range(40)
VARIED = lessons.variants()


def two_links(x, y):
    """Both poses of two links of length 1, by the cosine rule."""
    bend = acos((x * x + y * y - 2) / 2)
    return [[atan2(y, x) - one / 2, one] for one in (bend, -bend)]


def pose(turn, o):
    c, s = cos(radians(turn)), sin(radians(turn))
    return np.array([[c, -s, o[0]], [s, c, o[1]], [0, 0, 1]])


def straight_down(r, z):
    """Joints 2 to 4 of the Alpha II with the tip r mm out and z mm high, elbow up."""
    high = z + 129.5 - 215
    line, elbow = atan2(high, r), acos(hypot(r, high) / (2 * 177.8))
    q2, q3 = -(line + elbow), 2 * elbow
    return q2, q3, -q2 - q3


ANSWERS = {
    "start_here.2": lambda turn, lift, reach: [turn * pi / 180, lift / 1000, reach / 100],
    "start_here.5": lambda target: two_links(*target),
    "translation.1": lambda o, c_1, d_0: [[o[0] + c_1[0], o[1] + c_1[1]],
                                          [d_0[0] - o[0], d_0[1] - o[1]], [-o[0], -o[1]]],
    "translation.3": lambda c, d: [(c[0] + d[0]) / 2, (c[1] + d[1]) / 2],
    "rotation.2": lambda x_1: [[x_1[0], -x_1[1]], [x_1[1], x_1[0]]],
    "rotation.3": lambda x_1, c_0: [x_1[0] * c_0[0] + x_1[1] * c_0[1],
                                    x_1[0] * c_0[1] - x_1[1] * c_0[0]],
    "notation.3": lambda turn_1, turn_2, o_1, o_2: np.linalg.solve(pose(turn_1, o_1),
                                                                   pose(turn_2, o_2)),
    "turns.3": lambda axis, angle: [np.array(axis) / np.sqrt(np.dot(axis, axis)), radians(angle)],
    "turns.5": lambda left: [0.2, pi / 2, 0.2 + radians(left)],
    "two_link.4": lambda l_1, l_2: [acos(l_2 / l_1), pi - acos(l_2 / l_1)],
    "dh_recipe.6": lambda theta, d, a, alpha: [radians(theta), d, a, radians(alpha)],
    "alpha_ii.4": lambda height: [0.3, asin((215 - 129.5 - height) / (2 * 177.8)), 0,
                                  -asin((215 - 129.5 - height) / (2 * 177.8)), 1],
    "intelledex.4": lambda yaw: np.radians([90, 0, 90, 0, 90 - yaw, 0]),
    "workspace.2": lambda near, far: [(far - near) / 2, (far + near) / 2],
    "workspace.3": lambda l_1, l_2: [0, pi - atan2(l_2, l_1)],
    "workspace.5": lambda ahead, high: [0, -atan2(high - 215, ahead), 0, -pi / 2, 0],
    "inverse.4": lambda x, y: two_links(x, y),
    "motion.1": lambda start, end, T: [radians(start), 0, radians(end - start) * 3 / T**2,
                                       -radians(end - start) * 2 / T**3],
    "inverse.5": lambda x, y, z: [atan2(y, x), *straight_down(hypot(x, y), z), 0],
}


BACKWARDS = ("dh_recipe.6", "turns.3", "turns.5")  # a matrix is given, its numbers are asked for


def judged(name, answer, **numbers):
    return kl.exercises.judged(VARIED[name].judge(**numbers), answer)


def drawn(name, seed):
    """The numbers behind a variant, those that are asked for, too."""
    return dict(VARIED[name].draw(Draw(f"{name} {seed}")))


def test_each_exercise_with_variants_is_answered_here():
    assert set(VARIED) == set(ANSWERS) and set(VARIED) <= set(lessons.exercises())


@pytest.mark.parametrize("name", VARIED)
def test_the_right_answer_is_right_for_every_seed(name):
    for seed in SEEDS:
        numbers = drawn(name, seed)
        verdict = judged(name, ANSWERS[name](**numbers), **numbers)
        assert verdict.ok, (numbers, verdict)


@pytest.mark.parametrize("name", VARIED)
def test_the_answer_to_other_numbers_is_wrong(name):
    """Whoever copies an answer needs the same numbers."""
    seen = {repr(drawn(name, seed)): seed for seed in SEEDS}
    assert len(seen) >= 10
    one, other, *_ = (drawn(name, seed) for seed in seen.values())
    assert not judged(name, ANSWERS[name](**one), **other).ok
    verdict = judged(name, RIGHT[name], **other)
    assert not verdict.ok and verdict.word == "Not yet"


@pytest.mark.parametrize("name", VARIED)
def test_the_task_holds_all_its_numbers(name):
    """Whoever reads it can answer: each number stands in the text, as it is."""
    for seed in SEEDS:
        variant = kl.exercises.variant(name, seed)
        if name in BACKWARDS:
            assert r"\begin{bmatrix}" in variant.ask
            continue
        assert dict(variant.numbers) == drawn(name, seed)
        for value in np.concatenate([*map(np.ravel, variant.numbers.values())]).tolist():
            assert f"{value:g}" in variant.ask, (value, variant)


@pytest.mark.parametrize("name", BACKWARDS)
def test_a_matrix_is_given_and_what_made_it_is_not(name):
    variant = kl.exercises.variant(name, "Ada")
    (matrix,) = variant.numbers.values()
    assert all(f"{entry:.4f}" in variant.ask for entry in matrix.ravel() + 0.0)
    assert variant.check(ANSWERS[name](**drawn(name, "Ada"))).ok
    assert not set(variant.numbers) & set(drawn(name, "Ada"))


def test_the_lost_matrix_is_that_of_its_row():
    """By the printed form of A: column 4 is (a cos, a sin, d), row 3 (0, sin, cos of alpha, d)."""
    variant = kl.exercises.variant("dh_recipe.6", "Ada")
    theta, d, a, alpha = drawn("dh_recipe.6", "Ada").values()
    for entry in (cos(radians(theta)), a * sin(radians(theta)), sin(radians(alpha)), d):
        assert f"{entry:.4f}" in variant.ask


def test_the_matrices_of_turns_are_those_of_their_numbers():
    """The trace is 1 + 2 cos(angle); at pitch 90 degrees r22 = cos(yaw - roll)."""
    one, other = (kl.exercises.variant(name, "Ada") for name in ("turns.3", "turns.5"))
    rows = [[float(x) for x in row.split("&")] for row in
            one.ask.split("bmatrix}")[1].removesuffix(r"\end{").split(r"\\")]
    assert sum(rows[k][k] for k in range(3)) == pytest.approx(
        1 + 2 * cos(radians(drawn("turns.3", "Ada")["angle"])), abs=2e-4)
    assert f"{cos(radians(drawn('turns.5', 'Ada')['left'])):.4f}" in other.ask


def test_a_seed_has_the_same_numbers_everywhere():
    """Typed from what it drew once: a seed on a task sheet must not change its meaning."""
    assert dict(kl.exercises.variant("translation.3", seed="Ada").numbers) == {
        "c": (4, 1), "d": (-2, 5)}
    assert dict(kl.exercises.variant("start_here.2", seed=7).numbers) == {
        "turn": 100, "lift": 400, "reach": 15}


@pytest.mark.parametrize("name", ["rotation.2", "turns.3"])
def test_a_number_and_its_text_are_one_seed(name):
    assert kl.exercises.variant(name, 7) == kl.exercises.variant(name, "7")
    assert kl.exercises.variant(name, 7) != kl.exercises.variant(name, 8)


def test_without_a_seed_there_are_others_each_time_and_the_seed_is_said():
    variants = [kl.exercises.variant("translation.1") for _ in range(20)]
    assert len({one.ask for one in variants}) > 10
    assert all(one.seed in repr(one) and one.ask in repr(one) for one in variants)
    assert kl.exercises.variant("translation.1", variants[0].seed) == variants[0]


@pytest.mark.parametrize("wrong", [1.5, [1], True, b"Ada", "two\nlines"])
def test_a_seed_is_a_number_or_a_line(wrong):
    with pytest.raises(ValueError, match=r"^seed: expected"):
        kl.exercises.variant("translation.1", wrong)


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_a_seed_cannot_be_markdown_or_html(text):
    try:
        shown = kl.exercises.variant("translation.3", text)._repr_markdown_().splitlines()[0]
    except ValueError as error:
        assert str(error).startswith("seed: expected one line")
    else:
        assert not set(shown[2:-2]) & set("<>&[]()`*\"'$\\{}")


def test_an_exercise_without_numbers_has_no_variants():
    with pytest.raises(ValueError, match=r"^name: expected .*'translation.1'.*, got 'rotation.4'"):
        kl.exercises.variant("rotation.4")


def test_spaces_around_a_seed_do_not_count():
    assert kl.exercises.variant("rotation.2", " Ada ") == kl.exercises.variant("rotation.2", "Ada")


def test_a_variant_is_checked_and_kept_apart_from_its_exercise(monkeypatch):
    monkeypatch.setattr(record, "WORK", record.Work())
    variant = kl.exercises.variant("translation.3", "Ada")
    assert variant.check(...).word == "Not attempted yet"
    assert not variant.check([0, 0]).ok and variant.check([1, 3]).ok
    assert record.WORK.tries == {"translation.3 Ada": 2}
    assert list(record.WORK.solved) == ["translation.3 Ada"]
