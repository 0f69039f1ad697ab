"""Matrices that several lessons ask for: the link matrix, and how the entries are called."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import reduce
from itertools import combinations

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import forward_kinematics
from ..arms.link import revolute

Place = tuple[int, int]
BY_ENTRY = "`*` multiplies entry by entry. A product of matrices is written A @ B."


def link_matrix(theta: float, d: float, a: float, alpha: float,
                convention: str = "standard") -> np.ndarray:
    """The pose of a link's frame in the frame before it.

    Examples
    --------
    >>> link_matrix(0, 0.5, 0.2, 0)[:3, 3]
    array([0.2, 0. , 0.5])
    """
    return forward_kinematics(Arm([revolute(d=d, a=a, alpha=alpha)], convention=convention),
                              [theta])


def matrix_place(index: tuple[int, int]) -> str:
    """Where an entry of a matrix stands."""
    row, column = index
    return f"row {row + 1}, column {column + 1}"


def matrix_entry(index: tuple[int, int]) -> str:
    """What an entry of a matrix is called in a message."""
    return f"the entry in {matrix_place(index)}"


def motions(theta: float, d: float, a: float, alpha: float) -> list[np.ndarray]:
    """The four motions of a standard link, in their order: Rz, Tz, Tx, Rx."""
    return [link_matrix(theta, 0, 0, 0), link_matrix(0, d, 0, 0), link_matrix(0, 0, a, 0),
            link_matrix(0, 0, 0, alpha)]


def entry_by_entry(factors: Sequence[np.ndarray]) -> np.ndarray:
    """What `*` makes of matrices in place of `@`."""
    return np.asarray(reduce(np.multiply, factors))


def with_signs(link: Callable[..., np.ndarray], places: Iterable[Place]) -> Callable:
    """The link matrix with some entries of the wrong sign: a slip."""
    signs = np.ones((4, 4))
    for place in places:
        signs[place] = -1
    return lambda *row: link(*row) * signs


def sign_slips(link: Callable[..., np.ndarray], groups: Sequence[Sequence[Place]],
               said: str) -> list[tuple[str, Callable]]:
    """The slips of wrong signs.

    Parameters
    ----------
    link : callable
        The right link matrix.
    groups : sequence of places
        The entries whose sign is that of sin(alpha), those that go wrong together in one group.
    said : str
        Said where some of the groups are wrong.
    """
    some = [[place for group in chosen for place in group]
            for n in range(1, len(groups) + 1) for chosen in combinations(groups, n)]
    single = [(i, j) for i in range(3) for j in range(4)]
    return [*((said, with_signs(link, places)) for places in some),
            *((f"Only the sign of {matrix_entry(place)} is wrong.", with_signs(link, [place]))
              for place in single)]
