"""Judge a student's DH table by what the arm does: every valid choice of frames is right."""
from __future__ import annotations

from dataclasses import replace
from math import degrees, pi, sin

import numpy as np

from ..arms.arm import CONVENTIONS, Arm, check_arm
from .mechanism import (
    SIXTH_DECIMAL,
    WORDS,
    Axes,
    Deviation,
    Layout,
    Match,
    apart,
    axes_of,
    differ,
    matched,
    own_row,
    turned_bend,
    wrapped,
)
from .verdict import CORRECT, NOT_YET, Fault, Verdict
from .zero_pose import misplaced


def same_mechanism(answer: Arm, reference: Arm, *, strict: bool = False) -> Verdict:
    """Whether two arms are the same mechanism, whatever frames were chosen.

    They are when a rigid placement of the base, a sign and an offset for each joint, and a tool
    transform make them move alike for all q. The conventions may differ. Angles count as equal
    within 5e-7 rad (pi/2 may be typed as 1.570796) and lengths within 5e-7 of themselves. The
    unit names of the arms are not compared: both must use the same unit.

    Parameters
    ----------
    answer, reference : Arm
    strict : bool
        Also ask that both stand alike at q = 0 and carry the same tool frame. Then no offset and
        no tool transform is free: forward_kinematics(answer, s * q) equals, after one placement
        of the base, forward_kinematics(reference, q) for some signs s and all q.

    Returns
    -------
    Verdict
        With `ok` and `message`: which joint is off and what it should be, or what was chosen
        differently in a right answer. One slip is named at a time, the twists before the lengths.
        `fault` says where it is, by `row` and `column` of the answer's own table.

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
    check_arm(answer)
    check_arm(reference)
    if other := _other_joints(answer, reference):
        return other
    mine, theirs = axes_of(answer), axes_of(reference)
    layout = Layout(theirs)
    match = matched(mine, layout)
    if match.deviations:
        return _refusal(answer, mine, layout, match)
    signs = _plainest(mine, theirs, match.signs)
    if strict and (stance := misplaced(mine, theirs, signs, answer.convention)):
        return stance
    return Verdict(CORRECT, _praise(mine, theirs, answer, reference, signs))


def _other_joints(answer: Arm, reference: Arm) -> Verdict | None:
    """How the joints differ in number or type, or None."""
    if answer.n != reference.n:
        rule = ("One row belongs to each joint." if answer.n < reference.n else
                "Only joints have rows: put a fixed tool into the tool frame.")
        return Verdict(NOT_YET, f"Your table has {_count(answer.n)}, the arm has {reference.n}. "
                                f"{rule}")
    for i, (row, joint) in enumerate(zip(answer.links, reference.links), start=1):
        if row.kind != joint.kind:
            message = (f"Joint {i} is {joint.kind} on the arm and {row.kind} in your table: its "
                       f"variable is {joint.variable}{i}, so {joint.variable}{i} varies and "
                       f"{row.variable}{i} is constant.")
            return Verdict(NOT_YET, message, Fault(i, "kind"))
    return None


def _count(n: int) -> str:
    return "1 joint" if n == 1 else f"{n} joints"


# ---- A wrong table -------------------------------------------------------------------------------


def _refusal(answer: Arm, mine: Axes, layout: Layout, match: Match) -> Verdict:
    other, = set(CONVENTIONS) - {answer.convention}
    if not match.single and not matched(axes_of(replace(answer, convention=other)),
                                        layout).deviations:
        return Verdict(NOT_YET, f"These numbers fit the {other} convention and were read as "
                                f"{answer.convention}. Say convention='{other}', or move alpha and "
                                "a by one row.")
    off = match.deviations[0]
    speak = {"alpha": _twisted, "theta": _bent, "a": _long, "d": _off}[off.parameter]
    fault = Fault(own_row(off.row, off.parameter, answer.convention), off.parameter)
    return Verdict(NOT_YET, speak(off, answer, mine, layout, match) + _rounded(off), fault)


def _start(off: Deviation, answer: Arm) -> str:
    """Joint, parameter and its value, named as in the student's own table."""
    row = own_row(off.row, off.parameter, answer.convention)
    where = f"{off.parameter}{off.row + 1}" + f" (in row {row})" * (row > off.row + 1)
    return f"Joint {row}: the {WORDS[off.parameter]} {where} is {_shown(off)[0]}"


def _shown(off: Deviation, expected: float | None = None) -> tuple[str, str]:
    """Both values, with as many digits as it takes to tell them apart."""
    values = off.got, off.expected if expected is None else expected
    if off.parameter in ("alpha", "theta"):
        got, right = apart(*map(degrees, values))
        return f"{got}°", f"{right}°"
    return apart(*values)


def _twisted(off: Deviation, answer: Arm, mine: Axes, layout: Layout, match: Match) -> str:
    i, angle, theirs = off.row, off.expected, layout.axes
    length = mine.a[i] * theirs.a[i] * np.sign(theirs.x[i] @ theirs.normal(i))
    side = match.signs[0, i] * match.signs[0, i + 1] * np.sign(length)
    if mine.turns[i] and mine.turns[i + 1] and abs(length) > SIXTH_DECIMAL * mine.longest ** 2:
        allowed = [side * angle]  # the length tells which way x points
    else:
        allowed = sorted({angle, -angle if angle < pi - SIXTH_DECIMAL else angle}, reverse=True)
    texts = " or ".join(dict.fromkeys(_shown(off, value)[1] for value in allowed))
    a, b = _z(answer, i), _z(answer, i + 1)
    return f"{_start(off, answer)}; from {a} to {b} it should be {texts}."


def _bent(off: Deviation, answer: Arm, mine: Axes, layout: Layout, match: Match) -> str:
    return (f"{_start(off, answer)}; it should be {_shown(off)[1]}. A prismatic joint does "
            "not turn, so q cannot make up for this angle: the row has to hold it.")


def _long(off: Deviation, answer: Arm, mine: Axes, layout: Layout, match: Match) -> str:
    i = off.row
    text = f"{_start(off, answer)}; it should be {_shown(off)[1]}"
    if abs(off.got + off.expected) > SIXTH_DECIMAL * abs(off.got):
        return f"{text}."
    if abs(sin(answer_twist := mine.arm.links[i].alpha)) > SIXTH_DECIMAL:
        turned = apart(degrees(-answer_twist), degrees(answer_twist))[0]
        return (f"{text}; or the twist alpha{i + 1} turns the wrong way and should be {turned}°: "
                "the two must fit together.")
    return f"{text}: its sign is wrong."


def _off(off: Deviation, answer: Arm, mine: Axes, layout: Layout, match: Match) -> str:
    run = next(run for run in layout.runs if off.row in run)
    turning = [f"d{i + 1}" for i in run if mine.turns[i]]
    text = f"{_start(off, answer)}; it should be {_shown(off)[1]}"
    if len(turning) < 2:
        return f"{text}."
    return f"{text}. These axes are parallel: {', '.join(turning)} count only together."


def _rounded(off: Deviation) -> str:
    close = abs(abs(off.got) - abs(off.expected)) < 2e-3
    if close and off.expected and off.parameter in ("alpha", "theta"):
        return " It looks rounded: write pi/2 rather than 1.57."
    if abs(off.got) > 2 * pi + SIXTH_DECIMAL and off.parameter in ("alpha", "theta"):
        return " Angles are in radians: write radians(90) for 90°."
    return ""


def _z(answer: Arm, i: int) -> str:
    """The z that lies along the axis of a joint; joints count from 0 here."""
    return f"z{i + (answer.convention == 'modified')}"


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
    chosen += [f"{_z(answer, i)} points the other way: your q{i + 1} "
               f"{'turns' if mine.turns[i] else 'slides'} backwards"
               for i in np.flatnonzero(signs < 0).tolist()]
    chosen += [f"x{i + 1} points the other way"
               for i in np.flatnonzero(_sides(mine, theirs, signs[None])[0] < 0)]
    chosen += [f"q{i + 1} counts from a zero {apart(abs(degrees(gap)), np.inf)[0]}° away"
               for i, gap in enumerate(_zero_gaps(mine, theirs, signs[None])[0])
               if abs(gap) > SIXTH_DECIMAL]
    chosen += [f"the origin on {_z(answer, i)} slid along it" for i in range(1, mine.n - 1)
               if mine.turns[i] and _unequal(mine.d[i] * signs[i], theirs.d[i], mine)]
    chosen += _other_ends(mine, theirs)
    if not chosen:
        here, there = ([(link.theta, link.d) for link in axes.arm.links] for axes in (mine, theirs))
        chosen = ["where some q count from"] * (not np.allclose(here, there))
    if not chosen:
        return "The same mechanism, with the same frames."
    more = [f"and {len(chosen) - 4} more"] if len(chosen) > 4 else []
    return f"The same mechanism. Chosen differently: {'; '.join(chosen[:4] + more)}."


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
