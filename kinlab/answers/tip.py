"""Whether the tip is where it should be, once the joint axes are.

Joint axes leave the tool's place open, and a slide has a direction but no place: with a link offset
left out before a slide, the axes are still alike. So the tip counts by itself. A joint added at the
tip pins it: across the last axis as far away as the tip is, or along it, if the last joint slides.
"""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import atan2, hypot, pi
from typing import NamedTuple

import numpy as np

from ..arms.arm import Arm, to_modified, to_standard
from ..arms.kinematics import forward_kinematics
from ..arms.link import PRISMATIC, REVOLUTE, revolute, with_numbers
from .fixed_rows import kinds, without_ends
from .mechanism import axes_of, differ, fitting, layout_of
from .verdict import NOT_YET, Fault, Verdict
from .words import apart

_TOOL = "The arm is right, but its tip is not: check the tool"
_WORDS = {"a": "length", "d": "offset"}


class Cell(NamedTuple):
    """A length of a table, by its row from 0, and what it should be."""

    row: int
    column: str
    got: float
    expected: float


def with_tip(arm: Arm) -> Arm:
    """The arm with a joint at its tip, whose axis lies alike for all choices of the last frame."""
    *links, last = to_standard(arm).links
    tool = to_standard(arm).tool
    end = replace(last, alpha=pi / 2 if last.kind == REVOLUTE else 0)
    if tool[:3, 3].any():
        x, y, d = forward_kinematics(Arm([last], tool=tool), [0])[:3, 3]
        a = hypot(x, y)
        theta, a = (atan2(y, x), a) if a > 1e-9 * (a + abs(d)) else (last.theta, 0)
        end = replace(end, theta=theta, d=d, a=a)
    longer = Arm([*links, end, revolute()], base=to_standard(arm).base)
    return to_modified(longer) if arm.convention == "modified" else longer


def tip_elsewhere(answer: Arm, reference: Arm,
                  judged: Callable[[Arm, Arm], Verdict]) -> Verdict | None:
    """What there is to say of a tip that is elsewhere, though the joint axes are alike, or None.

    Parameters
    ----------
    answer, reference : Arm
    judged : callable
        Judges the joint axes of two arms.
    """
    (mine, first), (theirs, _) = without_ends(answer), without_ends(reference)
    here, there = with_tip(mine), with_tip(theirs)
    verdict = judged(here, there)
    typed = (to_modified if mine.convention == "modified" else to_standard)(theirs)
    own = _only_length(mine, typed)
    if verdict.ok and not (own and _runs_backwards(here, there)):
        return None
    if own:
        return _named(mine, own, first)
    right_tool = replace(mine, tool=typed.tool)
    if judged(with_tip(right_tool), there).ok:
        return Verdict(NOT_YET, f"{_TOOL}. {_how_far(mine, right_tool)}")
    return _told(mine, verdict, first)


def _only_length(answer: Arm, reference: Arm) -> Cell | None:
    """The one length that is not the reference's, in a table that has all other numbers of it."""
    if (answer.convention, kinds(answer)) != (reference.convention, kinds(reference)) or (
            not np.allclose(answer.tool, reference.tool)):
        return None
    off = []
    for i, (link, right) in enumerate(zip(answer.links, reference.links)):
        if differ(link.theta, right.theta) or differ(link.alpha, right.alpha):
            return None
        off += [Cell(i, column, getattr(link, column), getattr(right, column)) for column in "da"
                if not np.isclose(getattr(link, column), getattr(right, column))]
    return off[0] if len(off) == 1 and off[0].column != answer.links[off[0].row].variable else None


def _runs_backwards(answer: Arm, reference: Arm) -> bool:
    """Whether the axes fit only if a slide counts the other way."""
    axes = axes_of(answer)
    ways = [-1 if mine.flip != theirs.flip else 1
            for mine, theirs in zip(answer.joints, reference.joints)]
    signs = fitting(axes, layout_of(reference)) * ways
    slides = [joint.kind == PRISMATIC for joint in reference.joints]
    return bool(len(signs)) and not np.any(np.all(signs[:, slides] > 0, axis=1))


def _named(answer: Arm, cell: Cell, first: int) -> Verdict:
    """The words on one length of a table."""
    row = cell.row + 1 + first
    got, expected = apart(cell.got, cell.expected)
    joint = (f"Joint {answer.rows.index(cell.row) + 1}" if cell.row in answer.rows
             else f"Row {row}")
    sign = ": its sign is wrong" if np.isclose(cell.got, -cell.expected) else ""
    mended = _with(answer, cell)
    return Verdict(NOT_YET, f"{joint}: the {_WORDS[cell.column]} {cell.column}{row} is {got}; it "
                            f"should be {expected}{sign}. {_how_far(answer, mended)}",
                   Fault(row, cell.column, cell.got, cell.expected))


def _told(answer: Arm, verdict: Verdict, first: int) -> Verdict:
    """What the examiner says of the arm with a joint at its tip, with how far the tip is off."""
    fault, with_tool = verdict.fault, bool(answer.tool[:3, 3].any())
    if fault is None or fault.row + with_tool > len(answer.links):
        return Verdict(NOT_YET, f"{_TOOL}.")
    said = verdict.message
    if fault.column in _WORDS and isinstance(fault.expected, float):
        cell = Cell(fault.row - 1, str(fault.column), 0.0, fault.expected)
        said = f"{said} {_how_far(answer, _with(answer, cell))}"
    return replace(verdict, message=said, fault=replace(fault, row=fault.row + first))


def _with(answer: Arm, cell: Cell) -> Arm:
    links = list(answer.links)
    links[cell.row] = with_numbers(links[cell.row], **{cell.column: cell.expected})
    return replace(answer, links=tuple(links))


def _how_far(answer: Arm, mended: Arm) -> str:
    home = answer.home
    here, there = (forward_kinematics(arm, home)[:3, 3] for arm in (answer, mended))
    return (f"The joint axes are alike, but the tip is {np.linalg.norm(here - there):.4g} "
            f"{answer.unit} away from where it should be.")
