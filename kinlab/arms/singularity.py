"""How well an arm moves its tool at a pose: manipulability, rank, and what it cannot do."""
from __future__ import annotations

from collections.abc import Sequence
from numbers import Integral
from typing import Any

import numpy as np

from . import inputs
from .arm import Arm, check_arm
from .kinematics import jacobian, typical_length


def manipulability(arm: Arm, q: Any, rows: Sequence[int] = range(6)) -> Any:
    """Yoshikawa's manipulability: the product of the Jacobian's singular values.

    For as many rows as joints it is ``|det J|``: how much velocity of the tool the joints make in
    the direction where they make least counts as much as where they make most. It is 0 at
    singular poses, and its unit is that of the rows.

    Parameters
    ----------
    arm : Arm
    q : array, shape (..., n)
        Joint values, radians or the arm's unit.
    rows : sequence of int
        Rows of the Jacobian that count: 0, 1, 2 for velocity along x, y, z and 3, 4, 5 for
        angular velocity about them.

    Returns
    -------
    float, or array of shape (...)

    Examples
    --------
    >>> from kinlab import robots
    >>> round(float(manipulability(robots.two_link(), [0.3, np.pi / 2], rows=[0, 1])), 6)
    1.0
    """
    J = jacobian(arm, q)[..., _rows(rows), :]
    return np.prod(np.linalg.svd(J, compute_uv=False), axis=-1)


def rank(arm: Arm, q: Any, rows: Sequence[int] = range(6), *, tolerance: float = 1e-6) -> Any:
    """In how many independent directions the tool can move.

    Lengths are measured in the arm's reach, so that millimetres and radians compare. A
    singular value of at most `tolerance` times the largest counts as zero.

    Parameters
    ----------
    arm : Arm
    q : array, shape (..., n)
        Joint values, radians or the arm's unit.
    rows : sequence of int
        Rows of the Jacobian that count, as in `manipulability`.
    tolerance : float

    Returns
    -------
    int, or array of int of shape (...)

    Examples
    --------
    >>> from kinlab import robots
    >>> arm = robots.intelledex_660t()
    >>> int(rank(arm, arm.home))
    4
    """
    sizes = np.linalg.svd(_in_reaches(arm, q)[..., _rows(rows), :], compute_uv=False)
    return np.sum(sizes > _threshold(tolerance, sizes[..., :1]), axis=-1)


def singular_directions(arm: Arm, q: Any, rows: Sequence[int] = range(6), *,
                        tolerance: float = 1e-6) -> np.ndarray:
    """Directions [v; w] in which the tool cannot move, as columns; none where the rank is full.

    Parameters
    ----------
    arm : Arm
    q : array, shape (n,)
        Joint values, radians or the arm's unit.
    rows : sequence of int
        Rows of the Jacobian that count, as in `manipulability`.
    tolerance : float
        As in `rank`. The columns have length 1, with lengths measured in the arm's reach.

    Returns
    -------
    array, shape (rows, rows - rank)

    Examples
    --------
    >>> from kinlab import robots
    >>> arm = robots.intelledex_660t()
    >>> singular_directions(arm, arm.home).shape
    (6, 2)
    """
    check_arm(arm)
    J = _in_reaches(arm, inputs.shaped("q", q, (arm.n,), f"{arm.n} joint values"))[_rows(rows)]
    U, sizes, _ = np.linalg.svd(J)
    return U[:, np.sum(sizes > _threshold(tolerance, sizes[0])):]


def _in_reaches(arm: Arm, q: Any) -> np.ndarray:
    """The Jacobian with lengths measured in the arm's reach."""
    return jacobian(arm, q) / np.repeat([typical_length(arm), 1], 3)[:, None]


def _threshold(tolerance: float, largest: Any) -> Any:
    """What counts as zero; never zero itself, for an arm whose joints move nothing."""
    return np.maximum(inputs.positive("tolerance", tolerance) * largest, np.finfo(float).tiny)


def _rows(rows: Sequence[int]) -> list[int]:
    try:
        chosen = list(rows)
    except TypeError:
        chosen = []
    if not chosen or not all(isinstance(row, Integral) and 0 <= row < 6 for row in chosen):
        raise ValueError("rows: expected rows 0 to 5 of the Jacobian, "
                         f"got {inputs.brief(rows)}; 0, 1, 2 are velocity along x, y, z")
    return [int(row) for row in chosen]
