"""Judges of DH tables by what the arm does: every valid choice of frames is right.

The tip counts, and where a lesson says where the arm stands, the floor does as well. A joint added
there pins it, wherever frame 0 was put: across the first axis, as high as the room's origin, so
that the first row has to hold the height above it.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from math import pi
from typing import Any

import numpy as np

from ..arms.arm import Arm, to_standard
from ..arms.kinematics import forward_kinematics
from ..arms.link import revolute, with_numbers
from ..arms.motions import Numbers
from .fixed_rows import without_ends
from .handed import arm_in, red_cell
from .judges import Judge, first_of, is_stub
from .same_mechanism import same_mechanism
from .verdict import BLANK, NOT_YET, Fault, Verdict

Slips = Sequence[tuple[str, Arm]]


def table(reference: Arm, *, ends: bool = False, strict: bool = False, upright: bool = False,
          slips: Slips = (), praise: str) -> Judge:
    """Judge of an arm, made from a table.

    Parameters
    ----------
    reference : Arm
    ends : bool
        Also ask for the floor, on which frame 0 stands.
    strict : bool
        As in `same_mechanism`: also ask for the zero position and the tool frame.
    upright : bool
        With `strict`: also ask that the first axis points up as the reference's does.
    slips : sequence of (message, wrong arm)
        One with the answer's own numbers is named alone; one that is the same as the answer,
        other frames aside, is named behind what the examiner says. A slip speaks of cells, so
        the answer must be wrong in those cells too.
    praise : str
    """
    def judge(answer: Any) -> Verdict:
        if is_stub(answer):
            return Verdict(BLANK, "Replace the ... by kl.Arm([kl.revolute(...), ...]).")
        answer = arm_in(answer)
        if red := red_cell(answer):
            return red
        if not isinstance(answer, Arm):
            return Verdict(NOT_YET, "Expected an arm, made with kl.Arm([kl.revolute(...), ...]).")
        if _ready_made(answer, reference):
            return Verdict(NOT_YET, "This is the arm that kinlab has ready. Write its rows "
                                    "yourself: kl.Arm([kl.revolute(...), ...]).")
        verdict = examined(answer, reference, ends=ends, strict=strict, slips=slips, praise=praise)
        if verdict.ok and upright and not _stands_up(answer, reference):
            return Verdict(NOT_YET, " ".join(first_of(slips, partial(_same_numbers, answer)) or [
                "The mechanism is right, but it does not stand upright: z0 has to point up. Look "
                "at the first twist."]))
        return verdict
    return judge


def examined(answer: Arm, reference: Arm, *, ends: bool, strict: bool = False, slips: Slips = (),
             praise: str) -> Verdict:
    """What `table` says of an arm: what was chosen differently and the praise, or the slip."""
    verdict = _compared(answer, reference, ends, strict)
    if verdict.ok:
        said = [verdict.message, praise]
    else:
        said = first_of(slips, lambda wrong: _same_numbers(answer, wrong)) or [
            verdict.message,
            *first_of(slips, lambda wrong: _shares_cells(answer, wrong, reference)
                      and _compared(answer, wrong, ends, strict).ok)]
    return replace(verdict, message=" ".join(said))


def column(arm: Arm, name: str) -> np.ndarray:
    """One column of an arm's table: theta, d, a or alpha."""
    return np.array([getattr(link, name) for link in arm.links])


def with_columns(arm: Arm, **columns: Numbers) -> Arm:
    """The arm with some columns of its table replaced: a slip.

    Examples
    --------
    >>> from kinlab import robots
    >>> column(with_columns(robots.two_link(), a=[2, 3]), "a")
    array([2., 3.])
    """
    return replace(arm, links=tuple(
        with_numbers(link, **{name: float(numbers[i]) for name, numbers in columns.items()})
        for i, link in enumerate(arm.links)))


def _stands_up(answer: Arm, reference: Arm) -> bool:
    """Whether the placement that carries one arm onto the other keeps the vertical."""
    mine, theirs = (forward_kinematics(arm, np.zeros(arm.n)) for arm in (answer, reference))
    return bool(np.isclose((mine @ np.linalg.inv(theirs))[2, 2], 1))


def _ready_made(answer: Arm, reference: Arm) -> bool:
    """Whether it is the reference itself, in either convention: name, home and limits tell."""
    def marks(arm: Arm) -> list:
        return [arm.name, arm.home.tolist(), [joint.limits for joint in arm.joints]]
    return (bool(reference.name) and marks(answer) == marks(reference)
            and _same_numbers(to_standard(answer), to_standard(reference)))


def _same_numbers(answer: Arm, wrong: Arm) -> bool:
    return _alike(answer, wrong) and not _differing(answer, wrong).any()


def _shares_cells(answer: Arm, wrong: Arm, reference: Arm) -> bool:
    """Whether the answer's own cells are wrong wherever a slip's are."""
    return _alike(answer, wrong) and not np.any(
        _differing(wrong, reference) & ~_differing(answer, reference))


def _alike(answer: Arm, other: Arm) -> bool:
    """Whether cells of two tables can be compared one by one."""
    kinds, others = ([link.kind for link in arm.links] for arm in (answer, other))
    return answer.convention == other.convention and kinds == others


def _differing(answer: Arm, other: Arm) -> np.ndarray:
    """Which numbers differ in two tables of one form: theta, d, a, alpha of the rows, the tool."""
    mine, theirs = _described(answer), _described(other)
    return ~np.isclose(mine, theirs)


def _described(arm: Arm) -> np.ndarray:
    """All numbers of a table; angles as points of a circle, for a full turn changes nothing."""
    turns = [np.exp(1j * column(arm, name)) for name in ("theta", "alpha")]
    return np.concatenate([*turns, column(arm, "d"), column(arm, "a"), arm.tool.ravel()])


def _compared(answer: Arm, reference: Arm, ends: bool, strict: bool) -> Verdict:
    verdict = same_mechanism(answer, reference, strict=strict)
    if not (verdict.ok and ends):
        return verdict
    table, first = without_ends(answer)
    return _ends(table, without_ends(reference)[0], first) or verdict


def _ends(answer: Arm, reference: Arm, first: int) -> Verdict | None:
    """What is wrong with the floor; `first` rows of the student's table stand before these."""
    floor = same_mechanism(_on_floor(answer), _on_floor(reference), tip=False)
    return None if floor.ok else _off_floor(answer, floor, first + 1)


def _off_floor(answer: Arm, floor: Verdict, row: int) -> Verdict:
    """What `floor` says of the row behind the floor's own, in words for the row of joint 1."""
    d = answer.links[0].d
    fault, should = Fault(row, "d"), ""
    if floor.fault and floor.fault.column == "d" and isinstance(floor.fault.expected, float):
        expected = floor.fault.expected - _height(answer)
        fault, should = Fault(row, "d", d, expected), f"; it should be {expected:.6g}"
    return Verdict(NOT_YET, f"Joint 1: the offset d{row} is {d:g}{should}. With frame 0 on the "
                            "floor it holds the height of the column.", fault)


def _on_floor(arm: Arm) -> Arm:
    """The arm with a joint where its first axis meets the floor, as high as the room's origin."""
    arm = to_standard(arm)
    first, *links = arm.links
    return Arm([revolute(alpha=pi / 2), replace(first, d=first.d + _height(arm)), *links])


def _height(arm: Arm) -> float:
    """How high frame 0 of a standard table stands above the room's origin, along its z."""
    base = to_standard(arm).base
    return float(base[:3, 3] @ base[:3, 2])
