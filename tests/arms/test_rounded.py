"""Angles that came rounded: the digits that count, and those that do not."""
from fractions import Fraction
from math import nan, pi

import numpy as np
import pytest

from kinlab.arms.rounded import looks_rounded, pi_text, plain_angle

# What people type, by the twelfth of pi that it stands for.
TYPED = {
    1: (0.262, 0.261, 0.2618, 0.26179, 0.261799),
    2: (0.524, 0.523, 0.5236, 0.52359, 0.523599),
    3: (0.785, 0.7854, 0.7853, 0.785398, 0.78539816),
    4: (1.047, 1.0472, 1.0471, 1.047198),
    5: (1.309, 1.30900, 1.3089),
    6: (1.57, 1.571, 1.5708, 1.5707, 1.57079, 1.5708, 1.570796, 1.5707963, 1.570796327),
    7: (1.833, 1.8326),
    8: (2.094, 2.0944, 2.09439, 2.0943951),
    9: (2.356, 2.3562, 2.35619),
    10: (2.618, 2.61799, 2.617994),
    12: (3.14, 3.142, 3.1416, 3.1415, 3.14159, 3.141593, 3.1415927),
    18: (4.71, 4.712, 4.7124, 4.712389),
    24: (6.28, 6.283, 6.2832, 6.283185),
}


@pytest.mark.parametrize("twelfths", TYPED)
def test_digits_of_a_part_of_pi_count(twelfths):
    for angle in TYPED[twelfths]:
        for sign in (1, -1):
            assert plain_angle(sign * angle) == Fraction(sign * twelfths, 12), angle
            assert looks_rounded(sign * angle), angle


@pytest.mark.parametrize("angle", [
    3.14 / 2, 3.14159 / 2, 3.1416 / 4 * 2, 90 * 3.14 / 180, 90 * 3.14159 / 180, 90 * 0.0174533,
    90 * 0.01745, 90 / 57.3, 90 / 57.2958, 1.5708 + 1e-13, float(np.float32(pi / 2)),
    1.5707963 + 2e-7])
def test_a_quarter_turn_by_other_ways(angle):
    assert plain_angle(angle) == Fraction(1, 2)


@pytest.mark.parametrize("angle", [
    1.5, 1.6, 1.05, 2.09, 0.79, 5.76, 0.3, 1.572, 1.569, 1.5709, 1.5706, 1.57081, 1.570798, 0.7,
    3.1, 3.15, 3.1417, 1.2217, 0.6981, 0.001, 90, 45, 180, -90, 11, 22, 1e5, 1e100, nan])
def test_other_angles_do_not(angle):
    assert plain_angle(angle) is None
    assert not looks_rounded(angle)


def test_exact_multiples_do_not_look_rounded():
    for twelfths in range(-100, 101):
        angle = twelfths * pi / 12
        for near in (angle, angle + 9e-13, angle - 9e-13, np.radians(15 * twelfths)):
            assert plain_angle(near) == Fraction(twelfths, 12)
            assert not looks_rounded(near)
    assert plain_angle(-0.0) == 0


def test_few_numbers_look_so_by_chance():
    """Of all with two, three and four decimals between 0 and 2 pi."""
    for decimals in (2, 3, 4):
        steps = range(1, int(2 * pi * 10**decimals))
        found = sum(plain_angle(k / 10**decimals) is not None for k in steps)
        assert 0 < found / len(steps) < 0.01


@pytest.mark.parametrize("multiple, text", [
    (Fraction(1, 2), "pi/2"), (Fraction(-1, 2), "-pi/2"), (Fraction(1), "pi"),
    (Fraction(-1), "-pi"), (Fraction(2), "2*pi"), (Fraction(-2, 3), "-2*pi/3"),
    (Fraction(5, 12), "5*pi/12"), (Fraction(0), "0")])
def test_parts_of_pi_as_they_are_typed(multiple, text):
    assert pi_text(multiple) == text
