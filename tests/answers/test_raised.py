"""What a student's own function raised is said in words, and nothing of numpy's inner life."""
import numpy as np
import pytest

import kinlab as kl
from kinlab.answers.raised import in_words

TWO, WIDE = np.eye(2), np.ones((2, 3))


def rows(values):
    return values[0] + values[1]


def row_and_column(matrix, i, j):
    return matrix[i, j]


# (what a student runs, words of what is said)
RAISED = [
    (lambda: WIDE @ TWO, "the columns of A must be as many as the rows of B; here 3 and 2"),
    (lambda: np.dot(WIDE, TWO), "here 3 and 2"),
    (lambda: WIDE @ 2, "for a number take *"),
    (lambda: WIDE * TWO, "arrays of shapes (2,3) and (2,2) do not fit"),
    (lambda: np.ones(2).__iadd__(TWO), "arrays of shapes (2,) and (2,2) do not fit"),
    (lambda: np.linalg.solve(TWO, np.ones(3)), "rows of b as A has; here 3 and 2"),
    (lambda: np.linalg.inv(WIDE), "only a square matrix has an inverse"),
    (lambda: np.linalg.inv(np.ones((2, 2))), "LinAlgError: this matrix has no inverse"),
    (lambda: np.eye(3)[2, 3], "there is no index 3. Python counts from 0, so 3 entries end before"),
    (lambda: [1, 2][2], "an index is too large"),
    (lambda: np.ones(3)[0, 1], "more indices than the array has directions"),
    (lambda: row_and_column([[1, 2], [3, 4]], 0, 1), "make it an array"),
    (lambda: np.array([[1, 2], [3]]), "rows of an array have different lengths"),
    (lambda: float(np.ones(2)), "where one number is needed"),
    (lambda: rows(1, 2), "it takes 1 arguments and was given 2"),
    (lambda: 2 * ..., "a ... is still in it"),
    (lambda: np.ones(2) @ ..., "@ multiplies matrices and vectors"),
    (lambda: 2 * None, "a None is computed with"),
    (lambda: [1] - [2], "make them arrays"),
    (lambda: [1, 2].T, "a list is no array"),
    (lambda: cos(1), "write np.cos"),  # noqa: F821
    (lambda: 1 / 0, "it divides by zero"),
    (lambda: {}["angle"], "KeyError: 'angle'"),
]


@pytest.mark.parametrize("run, words", RAISED)
def test_an_error_is_said_in_words(run, words):
    with pytest.raises(Exception) as raised:
        run()
    said = in_words(raised.value)
    assert words in said and "gufunc" not in said and "core dimension" not in said


def test_a_check_says_what_the_function_raised():
    verdict = kl.exercises.check("inverse.2", lambda J, e, damping: J.T * e[:, None] @ J)
    assert "your function raised ValueError: " in verdict.message
    assert "gufunc" not in verdict.message
