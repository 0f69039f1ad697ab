"""What judges of functions and of numbers say of results that are right but for their digits."""
import numpy as np
import pytest

import kinlab as kl
from kinlab.answers.judges import function, values

CASES = [{"a": 1.0, "b": 2.0}, {"a": 5.0, "b": 9.0}]
THIRDS = function(lambda a, b: np.array([a / 3, b / 7]), CASES,
                  entry=lambda index: f"entry {index[0] + 1}", praise="Good.",
                  slips=[("The sign is wrong.", lambda a, b: -np.array([a / 3, b / 7]))])


def link(alpha, a, d, theta):
    arm = kl.Arm([kl.revolute(d=d, a=a, alpha=alpha)], convention="modified")
    return kl.forward_kinematics(arm, [theta])


@pytest.mark.parametrize("digits", [2, 3, 4, 5])
def test_a_function_that_rounds_its_result(digits):
    verdict = THIRDS(lambda a, b: [round(a / 3, digits), round(b / 7, digits)])
    assert verdict.message.startswith("For a = 1, b = 2: entry 1 should be 0.333333, got 0.33")
    assert verdict.message.endswith("It looks rounded: return all digits.")


@pytest.mark.parametrize("digits", [2, 3, 4])
def test_an_exercise_whose_matrix_is_rounded(digits):
    verdict = kl.exercises.check("n_link.1", lambda *row: np.round(link(*row), digits))
    assert f"should be 0.825336, got {round(0.825336, digits)}." in verdict.message
    assert verdict.message.endswith("It looks rounded: return all digits.")
    assert kl.exercises.check("n_link.1", link).ok


def test_numbers_that_were_typed_rounded():
    judge = values([1 / 3, 2 / 7], entry=lambda index: f"entry {index[0] + 1}", praise="Good.")
    assert judge([0.333, 0.286]).message == ("Your answer: entry 1 is not 0.333. It looks rounded: "
                                             "give all digits.")
    assert judge([0.333333333, 0.285714286]).ok


@pytest.mark.parametrize("wrong", [
    lambda a, b: [a / 3 + 0.001, b / 7],  # near, but no rounding
    lambda a, b: [round(a / 3, 3), b / 6],  # one of them is wrong
    lambda a, b: [round(a / 3, 3), round(b / 7, 4) + 0.0001],
])
def test_what_is_not_rounded_is_not_called_so(wrong):
    assert "rounded" not in THIRDS(wrong).message


def test_a_slip_is_named_before_rounding():
    assert THIRDS(lambda a, b: [-a / 3, -b / 7]).message.endswith("The sign is wrong.")
