"""Which cases of a kind the README's test command runs; `.ci/thorough` runs the others."""
from itertools import product

import pytest


def chosen(cases, names, ids=None):
    """Parameters of these names by the README's command; the others are thorough."""
    ids = [str(case) for case in cases] if ids is None else list(ids)
    assert set(names) <= set(ids), "each name is a case"
    return [_graded(name in names, name, case) for name, case in zip(ids, cases)]


def every(step, cases, ids=None):
    """One parameter of so many by the README's command; the others are thorough."""
    ids = [str(case) for case in cases] if ids is None else list(ids)
    return [_graded(k % step == 0, name, case) for k, (name, case) in enumerate(zip(ids, cases))]


def crossed(rows, columns, rare=()):
    """Each row with each column. By the README's command each row once, with columns in turn, but
    for the rare ones.
    """
    return [_graded((i + j) % len(columns) == 0 and row not in rare, f"{row}-{column}", row, column)
            for (i, row), (j, column) in product(enumerate(rows), enumerate(columns))]


def common(cases, rare):
    """Parameters of a dictionary's cases; the rare ones are thorough."""
    return [_graded(name not in rare, name, case) for name, case in cases.items()]


def _graded(ordinary, name, *values):
    return pytest.param(*values, id=name, marks=[] if ordinary else pytest.mark.thorough)
