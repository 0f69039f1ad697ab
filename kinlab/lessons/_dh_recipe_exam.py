"""Lesson 05, exercises 2 to 5 and 7: judges of the 2018 exam arm's table, matrices and frames."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from itertools import product
from math import pi
from typing import Any

import numpy as np

from ..answers.judges import Blank, Wrong, evaluated, expressions, first_of, is_stub
from ..answers.placed_frames import examine_frames
from ..answers.table_judge import examined
from ..arms import robots
from ..arms.arm import Arm
from ..arms.kinematics import forward_kinematics, link_frames
from ..arms.link import prismatic, revolute

_EXAM = robots.exam_2018()
_LENGTHS = dict(d_1=0.5, L_off=0.2, a_2=0.4)
_D1, _L, _A2 = _LENGTHS.values()
_JOINTS = ("theta_1", "theta_2", "d_3")
_POINTS = [dict(zip(_JOINTS, q)) for q in ((0.3, 0.7, 0.45), (-1.2, 0.4, 0.6), (2.0, -0.9, 0.25))]
Rows = np.ndarray


def _rows(q1: float, q2: float, q3: float) -> Rows:
    """The table: a row (theta, d, a, alpha) for each link."""
    return np.array([[q1, _D1, 0, pi / 2], [q2 + pi / 2, _L, _A2, pi / 2], [pi / 2, q3, 0, 0]])


def _changed(change: Callable[[Rows], Any], *q: float) -> Rows:
    rows = _rows(*q)
    change(rows)
    return rows


def _without_offset(rows: Rows) -> None:
    rows[1, 0] -= pi / 2


def _twisted_back(rows: Rows) -> None:
    rows[:, 3] *= -1


def _lengths_swapped(rows: Rows) -> None:
    rows[:, [1, 2]] = rows[:, [2, 1]]


def _moved_down(rows: Rows) -> None:
    rows[:, 2:] = np.vstack([[0, 0], rows[:-1, 2:]])


_OFFSET = ("The offset of joint 2 is missing: when theta_2* is 0, x2 already stands 90° away from "
           "x1.", _without_offset)
_TWIST = ("The sign of alpha is wrong: turn z_{i-1} to z_i about x_i by the right-hand rule.",
          _twisted_back)
_SWAPPED = ("d and a have changed places: d is measured along z, a along x.", _lengths_swapped)
_MOVED = ("a and alpha stand one row too low: that is the modified (Craig) table. In the standard "
          "one row i holds a_i and alpha_i.", _moved_down)

# ---- Exercise 2: the table --------------------------------------------------------------

_PLACES = [f"{name} of row {i}" for i in (1, 2, 3) for name in ("theta", "d", "a", "alpha")]


def _table(answer: Any) -> str:
    points = [dict.fromkeys(_JOINTS, 0.0), *_POINTS]
    arm = _arm(np.reshape(evaluated(answer, _PLACES, points, _LENGTHS), (-1, 3, 4)))
    slips = [(message, _arm_of(_changed(change, 0, 0, 0)))
             for message, change in (_SWAPPED, _MOVED)]
    praise = examined(arm, _EXAM, ends=True, slips=slips,
                      praise="Twelve numbers, three of them variables.")
    if not _stands_as(arm, _EXAM):
        hints = first_of((_OFFSET, _TWIST), lambda change: _stands_as(
            arm, _arm_of(_changed(change, 0, 0, 0))))
        raise Wrong(" ".join(["The mechanism is right, but where theta_2* = 0 and d_3* = 0 it does "
                              "not stand as in the view.", *hints]))
    return praise


def _arm(tables: np.ndarray) -> Arm:
    """The arm of a table that is known with all joints at zero, and at the points."""
    moved = tables[1:] - tables[0]
    kinds = []
    for i, joint in enumerate(_JOINTS):
        q = [point[joint] for point in _POINTS]
        places = [k for k in range(4) if np.abs(moved[:, i, k]).max() > 1e-9]
        if places not in ([0], [1]) or not np.allclose(np.abs(moved[:, i, places[0]]), np.abs(q)):
            hint = f" {_SWAPPED[0]}" * (places == [2])
            raise Wrong(f"Row {i + 1}: its joint variable is {joint}. It stands in theta or in d, "
                        f"alone or with a constant added, and in no other place.{hint}")
        kinds.append((revolute, prismatic)[places[0]])
    return _arm_of(tables[0], kinds)


def _arm_of(rows: Rows, kinds: Sequence[Callable] = (revolute, revolute, prismatic)) -> Arm:
    return Arm([make(**dict(zip(("theta", "d", "a", "alpha"), row)))
                for make, row in zip(kinds, rows)])


def _stands_as(answer: Arm, reference: Arm) -> bool:
    """Whether the tip is as far from the floor's origin as it should be, in every pose.

    That depends on the zeros of theta_2 and d_3, but neither on frames nor on signs of joints.
    """
    poses = np.random.default_rng(0).uniform(-2, 2, (9, 3))
    wanted = np.linalg.norm(forward_kinematics(reference, poses)[:, :3, 3], axis=1)
    return any(np.allclose(np.linalg.norm(forward_kinematics(answer, poses * signs)[:, :3, 3],
                                          axis=1), wanted) for signs in product((1, -1), repeat=3))


# ---- Exercises 3 to 5: the matrices of the view's frames --------------------------------


def _link(row: Any, convention: str = "standard") -> np.ndarray:
    theta, d, a, alpha = row
    return forward_kinematics(Arm([revolute(d=d, a=a, alpha=alpha)], convention=convention),
                              [theta])


def _product(links: slice, rows: Rows, convention: str = "standard") -> np.ndarray:
    """The transform over a stretch of links, its entries row by row."""
    return reduce(np.matmul, [_link(row, convention) for row in rows[links]]).ravel()


def _matrix_judge(links: slice, praise: str, slips: Sequence = ()) -> Callable[[Any], str]:
    """Judge of the sixteen entries of a product of link matrices."""
    def right(*q: float) -> np.ndarray:
        return _product(links, _rows(*q))

    known = [
        *slips,
        ("This is the transpose: the axes of the new frame are columns.",
         lambda *q: right(*q).reshape(4, 4).T.ravel()),
        ("This is the inverse: it takes coordinates the other way.",
         lambda *q: np.linalg.inv(right(*q).reshape(4, 4)).ravel()),
        ("This is the modified (Craig) order, Rx Tx Rz Tz; the lecture's is Rz Tz Tx Rx.",
         lambda *q: _product(links, _rows(*q), "modified")),
        *((message, lambda *q, change=change: _product(links, _changed(change, *q)))
          for message, change in (_OFFSET, _TWIST, _SWAPPED)),
    ]
    return expressions(_ENTRIES, right, _POINTS, constants=_LENGTHS, slips=known, praise=praise)


_ENTRIES = tuple(f"row {i}, column {j}" for i in range(1, 5) for j in range(1, 5))
_REVERSED = [("The factors stand in the wrong order: H_2^0 is A_1 times A_2.",
              lambda *q: _product(slice(1, None, -1), _rows(*q)))]

# ---- Exercise 7: frames of one's own ----------------------------------------------------


def _frames(answer: Any) -> str:
    if _untouched(answer):
        raise Blank("Replace every ... by three numbers.")
    try:
        placement = examine_frames(answer, _EXAM)
    except ValueError as error:
        raise Wrong(f"{error}.") from None
    if not placement.ok:
        raise Wrong(placement.message)
    view, own = link_frames(_EXAM, _EXAM.home), link_frames(placement.arm, placement.arm.home)
    turned = [i for i in range(3) if view[i, :3, 2] @ own[i, :3, 2] < 0]
    if not turned:
        raise Wrong("All frames keep the rules, but every z points as in the view: turn z0, z1 or "
                    "z2 round, and see which x axes may stay.")
    return "All frames keep the rules. " + " ".join(
        f"z{i} points the other way, so joint {i + 1} counts backwards." for i in turned)


def _untouched(answer: Any) -> bool:
    """Whether all that is in nested lists is still the stub."""
    if isinstance(answer, (list, tuple)):
        return bool(answer) and all(map(_untouched, answer))
    return is_stub(answer)


JUDGES: dict[str, Callable[[Any], str]] = {
    "dh_recipe.2": _table,
    "dh_recipe.3": _matrix_judge(slice(0, 1), "A_1 turns the column and lifts it by d_1."),
    "dh_recipe.4": _matrix_judge(slice(1, 2), "The offset has turned cosines into sines."),
    "dh_recipe.5": _matrix_judge(
        slice(0, 2), "Column 4 is the elbow, column 3 the direction in which joint 3 will slide.",
        _REVERSED),
    "dh_recipe.7": _frames,
}
