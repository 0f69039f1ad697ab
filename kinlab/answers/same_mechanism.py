"""Judge a student's DH table by what the arm does: every valid choice of frames is right."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from math import degrees, sin

import numpy as np

from ..arms.arm import Arm, check_arm
from ..arms.link import Link
from .fixed_rows import joints_only, kinds, without_ends
from .handed import arm_in, red_cell
from .mechanism import (
    SIXTH_DECIMAL,
    Axes,
    apart,
    axes_of,
    differ,
    fitting,
    layout_of,
    turned_bend,
    wrapped,
)
from .nearest_table import hidden_cells, nearest_table, with_rows
from .refusal import Wrong, axis_name, other_joints, refusal
from .tip import tip_elsewhere
from .verdict import CORRECT, Fault, Verdict
from .zero_pose import stand_alike


def same_mechanism(answer: Arm, reference: Arm, *, strict: bool = False,
                   tip: bool = True) -> Verdict:
    """Whether two arms are the same mechanism, whatever frames were chosen.

    They are when a rigid placement of the base, and a sign and an offset for each joint, make
    their tips move alike for all q; how the tool frame is turned is free. The conventions may
    differ. Angles count as equal
    within 5e-7 rad (pi/2 may be typed as 1.570796) and lengths within 5e-7 of themselves. The
    unit names of the arms are not compared: both must use the same unit.

    Parameters
    ----------
    answer, reference : Arm
        Or an editor that has one. While one of its cells is red there is nothing to judge.
    strict : bool
        Also ask that both stand alike at q = 0 and carry the same tool frame. Then no offset and
        no tool transform is free: forward_kinematics(answer, s * q) equals, after one placement
        of the base, forward_kinematics(reference, q) for some signs s and all q.
    tip : bool
        Whether the tip counts. If not, two arms with the same joint axes are the same mechanism,
        wherever their tools are.

    Returns
    -------
    Verdict
        With `ok` and `message`: which joint is off and what it should be, or what was chosen
        differently in a right answer. One slip is named at a time, the twists before the lengths,
        and who changes what is named, one number after the other, ends in a right table.
        `fault` says where the slip is, by `row` and `column` of the answer's own table, and what
        stands there and should, `value` and `expected`.

    Raises
    ------
    ValueError
        If `answer` or `reference` is not an Arm.

    Examples
    --------
    >>> from kinlab import robots, to_modified
    >>> arm = robots.alpha_ii()
    >>> same_mechanism(to_modified(arm), arm)
    ✓ Correct. The same mechanism. Chosen differently: modified DH instead of standard.
    """
    answer, reference = arm_in(answer), arm_in(reference)
    check_arm(answer)
    check_arm(reference)
    if red := red_cell(answer) or red_cell(reference):
        return red
    if other := other_joints(answer, reference):
        return other
    layout = layout_of(reference)
    theirs = layout.axes

    def moves_alike(arm: Arm) -> bool:
        return len(fitting(axes_of(arm), layout)) > 0

    def right(arm: Arm) -> bool:
        return moves_alike(arm) and not (strict and not stand_alike(axes_of(arm), theirs))

    mine = axes_of(answer)
    signs = fitting(mine, layout)
    if len(signs) and not (strict and not stand_alike(mine, theirs)):
        elsewhere = tip and not strict and tip_elsewhere(
            answer, reference, partial(same_mechanism, tip=False))
        return elsewhere or Verdict(CORRECT, _praise(mine, theirs, answer, reference,
                                        _plainest(mine, theirs, signs)))
    return _refused(answer, reference, strict, len(signs) > 0, right)


def _refused(answer: Arm, reference: Arm, strict: bool, mechanism: bool,
             right: Callable[[Arm], bool], first: int = 0) -> Verdict:
    """What there is to say of a table that is wrong, or right but for a little rounding."""
    if kinds(answer) != kinds(reference):
        return _without_fixed_rows(answer, reference, strict, mechanism, right)
    nearest = nearest_table(answer, reference, strict, right)
    if not nearest.cells and right(plain := with_rows(answer, nearest.held)):
        return same_mechanism(plain, reference, strict=strict, tip=False)
    if not nearest.cells and not mechanism:
        nearest = nearest._replace(cells=hidden_cells(answer, nearest, right))
    return refusal(Wrong(answer, reference, nearest, mechanism, first), right)


def _without_fixed_rows(answer: Arm, reference: Arm, strict: bool, mechanism: bool,
                        right: Callable[[Arm], bool]) -> Verdict:
    """The verdict on a table without its fixed rows, its fault in the student's own row."""
    (mine, first), (theirs, _) = without_ends(answer), without_ends(reference)
    if kinds(mine) == kinds(theirs):
        return _refused(mine, theirs, strict, mechanism, right, first)
    verdict = _refused(joints_only(mine), joints_only(theirs), strict, mechanism, right)
    fault = verdict.fault and Fault(answer.rows[verdict.fault.row - 1] + 1)
    return replace(verdict, fault=fault, message="In standard DH, without rows that are fixed: "
                                                 f"{verdict.message}")


# ---- A right table -------------------------------------------------------------------------------


def _plainest(mine: Axes, theirs: Axes, signs: np.ndarray) -> np.ndarray:
    """Of the sign patterns that fit, the one by which the fewest choices differ.

    A turned first axis counts twice: the base frame turns with it.
    """
    zeros = (np.abs(_zero_gaps(mine, theirs, signs)) > SIXTH_DECIMAL).sum(axis=1)
    turned = (signs < 0).sum(axis=1) + (signs[:, 0] < 0)
    count = turned + (_sides(mine, theirs, signs) < 0).sum(axis=1) + zeros
    return signs[np.lexsort((zeros, count))[0]]


def _praise(mine: Axes, theirs: Axes, answer: Arm, reference: Arm, signs: np.ndarray) -> str:
    chosen = []
    if answer.convention != reference.convention:
        chosen.append(f"{answer.convention} DH instead of {reference.convention}")
    for i, sign in enumerate(signs):
        other_way = sign * _counts(answer.joints[i]) * _counts(reference.joints[i]) < 0
        moves = "turns" if mine.turns[i] else "slides"
        said = [f"{axis_name(answer, i)} points the other way"] * bool(sign < 0) + [
            f"your q{i + 1} {moves} backwards"] * bool(other_way)
        chosen += [": ".join(said)] * bool(said)
    chosen += [f"x{i + 1} points the other way"
               for i in np.flatnonzero(_sides(mine, theirs, signs[None])[0] < 0)]
    chosen += [f"q{i + 1} counts from a zero {apart(abs(degrees(gap)), np.inf)[0]}° away"
               for i, gap in enumerate(_zero_gaps(mine, theirs, signs[None])[0])
               if abs(gap) > SIXTH_DECIMAL]
    chosen += [f"the origin on {axis_name(answer, i)} slid along it" for i in range(1, mine.n - 1)
               if mine.turns[i] and _unequal(mine.d[i] * signs[i], theirs.d[i], mine)]
    chosen += _other_ends(mine, theirs)
    if not chosen:
        here, there = ([(link.theta, link.d) for link in axes.arm.links] for axes in (mine, theirs))
        chosen = ["where some q count from"] * (not np.allclose(here, there))
    if not chosen:
        return "The same mechanism, with the same frames."
    more = [f"and {len(chosen) - 4} more"] if len(chosen) > 4 else []
    return f"The same mechanism. Chosen differently: {'; '.join(chosen[:4] + more)}."


def _counts(joint: Link) -> int:
    return -1 if joint.flip else 1


def _unequal(a: float, b: float, axes: Axes) -> bool:
    return abs(a - b) > 1e-6 * axes.longest


def _sides(mine: Axes, theirs: Axes, signs: np.ndarray) -> np.ndarray:
    """Whether each x between two axes points as theirs (1), the other way (-1), or freely (0)."""
    sides = np.zeros((len(signs), mine.n))
    for i in range(mine.n - 1):
        turned = signs[:, i] * signs[:, i + 1] if sin(theirs.twist(i)) > SIXTH_DECIMAL else 1
        sides[:, i] = _side(mine, i) * _side(theirs, i) * turned
    return sides


def _side(axes: Axes, i: int) -> float:
    """Whether x points along the normal from axis i to axis i + 1 (1), against it, or neither."""
    if sin(axes.twist(i)) > SIXTH_DECIMAL:
        return np.sign(axes.x[i] @ axes.normal(i))
    both = axes.turns[i] and axes.turns[i + 1] and _unequal(axes.a[i], 0, axes)
    return np.sign(axes.a[i]) if both else 0.0


def _zero_gaps(mine: Axes, theirs: Axes, signs: np.ndarray) -> np.ndarray:
    """How far the zeros of revolute joints are apart, where axes that are not parallel tell."""
    gaps = np.zeros((len(signs), mine.n))
    for i in range(1, mine.n - 1):
        bent = min(sin(theirs.twist(i - 1)), sin(theirs.twist(i))) > SIXTH_DECIMAL
        if mine.turns[i] and bent:
            here = turned_bend(mine.bend(i, i), signs, i, i)
            gaps[:, i] = wrapped(here - theirs.bend(i, i))
    return gaps


def _other_ends(mine: Axes, theirs: Axes) -> list[str]:
    """Base and tool frames that differ. Both arms are in the standard convention here."""
    first, other_first = mine.arm.links[0], theirs.arm.links[0]
    last, other_last = mine.arm.links[-1], theirs.arm.links[-1]
    base = not np.allclose(mine.arm.base, theirs.arm.base, atol=1e-6 * mine.longest) or (
        differ(first.theta, other_first.theta) or _unequal(first.d, other_first.d, mine))
    tool = not np.allclose(mine.arm.tool, theirs.arm.tool, atol=1e-6 * mine.longest) or (
        differ(last.theta, other_last.theta) or differ(last.alpha, other_last.alpha)
        or _unequal(last.d, other_last.d, mine) or _unequal(last.a, other_last.a, mine))
    if mine.n == 1:
        tool, base = tool or base, False
    return ["another base frame"] * bool(base) + ["another tool frame"] * bool(tool)
