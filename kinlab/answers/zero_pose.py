"""Whether two arms of the same mechanism stand alike at q = 0 and carry the same tool."""
from __future__ import annotations

from dataclasses import replace
from itertools import product
from math import degrees

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import forward_kinematics
from ..arms.link import with_numbers
from .mechanism import (
    SIXTH_DECIMAL,
    WORDS,
    Axes,
    Layout,
    apart,
    axes_of,
    matched,
    own_row,
    wrapped,
)
from .verdict import NOT_YET, Fault, Verdict

_STANCE = "The mechanism is right, but at q = 0 it does not stand as drawn"


def misplaced(mine: Axes, theirs: Axes, signs: np.ndarray, convention: str) -> Verdict | None:
    """How an arm stands other than the reference at q = 0, or None.

    The tool frames are laid upon each other. The first axis out of place, seen from the tool,
    hangs on a joint that counts from another zero: the one whose offset puts it in place. Where
    several would have to change, but turning the sign of one length round does it, that is named,
    in the row where the answer's own convention holds it.
    """
    out = _out_of_place(mine, theirs)[0]
    if not out:
        return None
    if out[-1] == mine.n - 1:
        return _tool_elsewhere(mine.n)
    steps = _zeros(mine, theirs, signs)
    if len(steps) != 1 and (sign := _sign(mine, theirs, convention)):
        return sign
    if steps:
        return _other_zero(mine, *steps[0])
    if mine.turns[-1] and out[-1] == mine.n - 2:
        return _tool_elsewhere(mine.n)
    return Verdict(NOT_YET, f"{_STANCE}: look for a length, a twist or an offset of the wrong "
                            "sign.")


def _tool_elsewhere(n: int) -> Verdict:
    return Verdict(NOT_YET, "The mechanism is right, but the tool frame sits elsewhere on the last "
                            f"link: check row {n} and the tool.", Fault(n))


def _other_zero(mine: Axes, j: int, value: float) -> Verdict:
    variable = str(mine.arm.links[j].variable)
    text = apart(degrees(wrapped(value)) if mine.turns[j] else value, np.inf)[0]
    return Verdict(NOT_YET, f"{_STANCE}. Joint {j + 1}: {variable}{j + 1} should hold the offset "
                            f"{text}{'°' * bool(mine.turns[j])}.", Fault(j + 1, variable))


def _zeros(axes: Axes, theirs: Axes, signs: np.ndarray) -> list[tuple[int, float]]:
    """Offsets that one joint after the other needs, or none where they do not lead there."""
    steps: dict[int, float] = {}
    while True:
        out, z, points = _out_of_place(axes, theirs)
        if not out:
            return list(steps.items())
        k = out[-1]
        for j in set(range(k + 1, axes.n)) - set(steps):
            value = _zero(axes, j, k, signs[k] * z[k], points)
            trial = axes_of(_with(axes.arm, j, str(axes.arm.links[j].variable), value))
            if k not in _out_of_place(trial, theirs)[0]:
                steps[j], axes = value, trial
                break
        else:
            return []


def _sign(mine: Axes, theirs: Axes, convention: str) -> Verdict | None:
    """The one length whose sign, turned round, makes the arm stand as drawn."""
    layout = Layout(theirs)
    for i, name in product(range(mine.n), ("a", "d")):
        value = getattr(mine.arm.links[i], name)
        if not value or name == mine.arm.links[i].variable:
            continue
        trial = axes_of(_with(mine.arm, i, name, -value))
        if not _out_of_place(trial, theirs)[0] and not matched(trial, layout).deviations:
            message = (f"{_STANCE}. The {WORDS[name]} {name}{i + 1} should be "
                       f"{apart(-value, np.inf)[0]}: its sign is wrong.")
            return Verdict(NOT_YET, message, Fault(own_row(i, name, convention), name))
    return None


def _with(arm: Arm, i: int, name: str, value: float) -> Arm:
    """A standard arm with one number of its table replaced."""
    links = list(arm.links)
    links[i] = with_numbers(links[i], **{name: value})
    return replace(arm, links=tuple(links))


def _out_of_place(mine: Axes, theirs: Axes) -> tuple[list[int], np.ndarray, np.ndarray]:
    """Axes that differ once the tools coincide; and where directions and points should be."""
    G = _tool(mine) @ np.linalg.inv(_tool(theirs))
    z, points = theirs.z @ G[:3, :3].T, _points(theirs) @ G[:3, :3].T + G[:3, 3]
    away = np.cross(mine.z, _points(mine) - points)
    away[~mine.turns] = 0  # a prismatic joint has a direction, not a place
    reach = np.abs(mine.steps()).sum() + mine.longest
    turned = np.linalg.norm(np.cross(mine.z, z), axis=1) > mine.n * SIXTH_DECIMAL
    moved = np.linalg.norm(away, axis=1) > mine.n * SIXTH_DECIMAL * reach
    return np.flatnonzero(turned | moved).tolist(), z, points


def _zero(axes: Axes, j: int, k: int, z: np.ndarray, points: np.ndarray) -> float:
    """The offset of joint j that brings axis k towards where it should be."""
    here = _points(axes)
    if axes.turns[j]:
        turn = _turn(axes.z[j], axes.z[k], z, here[k] - here[j], points[k] - here[j])
        return axes.arm.links[j].theta - turn
    across = axes.z[j] - axes.z[j] @ axes.z[k] * axes.z[k]
    return axes.d[j] + (here[k] - points[k]) @ across / max(across @ across, SIXTH_DECIMAL)


def _turn(axis: np.ndarray, z: np.ndarray, wanted: np.ndarray, arm: np.ndarray,
          wanted_arm: np.ndarray) -> float:
    """The turn about an axis that brings a neighbouring axis to where it should be."""
    if np.linalg.norm(np.cross(axis, z)) <= SIXTH_DECIMAL:
        z, wanted = arm, wanted_arm
    across = np.cross(axis, z)
    return float(np.arctan2(across @ wanted, np.cross(across, axis) @ wanted))


def _tool(axes: Axes) -> np.ndarray:
    """The tool at q = 0 in axes like the room's, at the origin of frame 0."""
    T = forward_kinematics(axes.arm, np.zeros(axes.n))
    T[:3, 3] -= axes.arm.base[:3, 3]
    return T


def _points(axes: Axes) -> np.ndarray:
    """A point on each axis at q = 0, in the same frame."""
    return np.vstack([np.zeros(3), np.cumsum(axes.steps(), axis=0)[:-1]])
