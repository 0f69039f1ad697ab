"""Exercises of the lessons with other numbers, a module for each lesson that has some.

A module has a dictionary VARIED, from names such as "translation.1" to `Varied`.
"""
from __future__ import annotations

import numpy as np

DIGITS = 4  # decimals of a matrix that is handed out


def given(matrix: np.ndarray) -> np.ndarray:
    """A matrix as a task hands it out."""
    return np.round(matrix, DIGITS) + 0.0


def latex(matrix: np.ndarray) -> str:
    """The same for a formula.

    Examples
    --------
    >>> print(latex(np.eye(2)))
    \\begin{bmatrix} 1.0000 & 0.0000 \\\\ 0.0000 & 1.0000 \\end{bmatrix}
    """
    rows = (" & ".join(f"{entry:.{DIGITS}f}" for entry in row) for row in given(matrix))
    return r"\begin{bmatrix} " + r" \\ ".join(rows) + r" \end{bmatrix}"
