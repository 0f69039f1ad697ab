"""What the examiner says of a wrong table: a sentence on one number, or on what joins them all."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import degrees, pi

import numpy as np

from ..arms.arm import CONVENTIONS, Arm
from ..arms.link import PRISMATIC, REVOLUTE
from ..arms.rounded import pi_text, plain_angle
from .mechanism import FLAT, SIXTH_DECIMAL, apart, own_row
from .nearest_table import ALPHA, Comparison, D, Deviation, Nearest
from .verdict import NOT_YET, Fault, Verdict

WORDS = {"alpha": "twist", "theta": "angle", "a": "length", "d": "offset"}
ANGLES = ("alpha", "theta")
# Between metres, centimetres, millimetres, inches and feet, and one decimal place.
_UNITS = (1000.0, 100.0, 10.0, 25.4, 2.54, 304.8, 1000 / 25.4, 1 / 0.3048, 12.0)
FACTORS = (*_UNITS, *(1 / factor for factor in _UNITS))
ROUNDED = 2e-3  # rad
_STANCE = "The mechanism is right, but at q = 0 it does not stand as drawn"
_TOOL = "The mechanism is right, but the tool frame sits elsewhere on the last link"


@dataclass(frozen=True)
class Wrong:
    """A table that is wrong, beside the nearest right one."""

    answer: Arm
    reference: Arm
    nearest: Nearest
    mechanism: bool  # the mechanism is right, but not where it stands
    first: int = 0  # rows of the student's table that stand before this one


def other_joints(answer: Arm, reference: Arm) -> Verdict | None:
    """How the joints differ in number or type, or None."""
    if answer.n != reference.n:
        rule = ("One row belongs to each joint." if answer.n < reference.n else
                "Only joints have rows: put a fixed first row into the base, a fixed last row "
                "into the tool.")
        return Verdict(NOT_YET, f"Your table has {_count(answer.n)}, the arm has {reference.n}. "
                                f"{rule}")
    for i, (row, link, joint) in enumerate(zip(answer.rows, answer.joints, reference.joints), 1):
        if link.kind != joint.kind:
            message = (f"Joint {i} is {joint.kind} on the arm and {link.kind} in your table: its "
                       f"variable is {joint.variable}{i}, so {joint.variable}{i} varies and "
                       f"{link.variable}{i} is constant.")
            return Verdict(NOT_YET, message, Fault(row + 1, "kind", link.kind, joint.kind))
    return None


def _count(n: int) -> str:
    return "1 joint" if n == 1 else f"{n} joints"


def refusal(wrong: Wrong, right: Callable[[Arm], bool]) -> Verdict:
    """What there is to say of a wrong table; `right` says of an arm whether it is a right one."""
    answer = wrong.answer
    if not wrong.nearest.cells:
        last = len(answer.links) + wrong.first
        return Verdict(NOT_YET, f"{_TOOL}: check row {last} and the tool.", Fault(last))
    other, = set(CONVENTIONS) - {answer.convention}
    if len(wrong.nearest.cells) > 1 and not wrong.mechanism:
        if right(replace(answer, convention=other)):
            return Verdict(NOT_YET, f"These numbers fit the {other} convention and were read as "
                                    f"{answer.convention}. Say convention='{other}', or move alpha "
                                    "and a by one row.")
        if factor := _unit(*_lengths(wrong.nearest.compared)):
            return Verdict(NOT_YET, _units(factor, wrong.reference))
    return _named(wrong, wrong.nearest.cells[0])


def _units(factor: float, reference: Arm) -> str:
    return (f"All lengths are {_times_too(factor)}: units. The arm's lengths are in "
            f"{reference.unit}.")


def _times_too(factor: float) -> str:
    return f"{factor:.6g} times too large" if factor > 1 else f"{1 / factor:.6g} times too small"


def _lengths(compared: Comparison) -> tuple[np.ndarray, np.ndarray]:
    """Lengths that count, and that both tables have."""
    mine, theirs = (np.abs(rows[:, D:ALPHA]) for rows in (compared.rows, compared.right))
    both = compared.held[:, D:ALPHA] & (mine > compared.noise) & (theirs > compared.noise)
    return mine[both], theirs[both]


def _unit(mine: np.ndarray, theirs: np.ndarray, fewest: int = 2) -> float:
    """How many times too large lengths are in another unit, or 0 if they are not."""
    ratios = mine / np.where(theirs == 0, np.inf, theirs)
    if np.any(np.isclose(ratios, 1, rtol=FLAT)):
        return 0.0
    return next((factor for factor in FACTORS
                 if np.isclose(ratios, factor, rtol=1e-5, atol=0).sum() >= fewest), 0.0)


# ---- One number ----------------------------------------------------------------------------------


def _named(wrong: Wrong, cell: Deviation) -> Verdict:
    row = own_row(cell.row, cell.parameter, wrong.answer.convention)
    if wrong.mechanism and cell.parameter == wrong.answer.links[row - 1].variable:
        text = _zero(cell, wrong)
    elif wrong.mechanism:
        text = _stance(cell, wrong)
    else:
        speak = {"alpha": _twisted, "theta": _bent, "a": _long, "d": _off}[cell.parameter]
        text = speak(cell, wrong)
    fault = Fault(row + wrong.first, cell.parameter, cell.got, cell.expected)
    return Verdict(NOT_YET, text + _hint(cell), fault)


def _name(cell: Deviation, wrong: Wrong) -> str:
    return f"{cell.parameter}{cell.row + 1 + wrong.first}"


def _start(cell: Deviation, wrong: Wrong) -> str:
    """Joint, parameter and its value, named as in the student's own table."""
    row = own_row(cell.row, cell.parameter, wrong.answer.convention)
    return (f"{_joint(row, wrong)}: the {WORDS[cell.parameter]} {_where(cell, wrong)} is "
            f"{_shown(cell)[0]}")


def _where(cell: Deviation, wrong: Wrong) -> str:
    """The number's name, with its row where the name does not say it."""
    row, name = own_row(cell.row, cell.parameter, wrong.answer.convention), _name(cell, wrong)
    own = name == f"{cell.parameter}{_joint(row, wrong).split()[1]}"
    return name + f" (in row {row + wrong.first})" * (not own)


def _joint(row: int, wrong: Wrong) -> str:
    """What a row, counted from 1, is called: by its joint, if one drives it."""
    rows = wrong.answer.rows
    return f"Joint {rows.index(row - 1) + 1}" if row - 1 in rows else f"Row {row + wrong.first}"


def _shown(cell: Deviation, expected: float | None = None) -> tuple[str, str]:
    """Both values, with as many digits as it takes to tell them apart."""
    values = cell.got, cell.expected if expected is None else expected
    if cell.parameter in ANGLES:
        got, right = apart(*map(degrees, values))
        return f"{got}°", f"{right}°"
    return apart(*values)


def _twisted(cell: Deviation, wrong: Wrong) -> str:
    allowed = {cell.expected}
    if wrong.nearest.compared.either[cell.row] and abs(cell.expected) < pi - SIXTH_DECIMAL:
        allowed.add(-cell.expected)
    texts = " or ".join(_shown(cell, value + 0.0)[1] for value in sorted(allowed, reverse=True))
    a, b = (axis_name(wrong.answer, cell.row + wrong.first + k) for k in (0, 1))
    return f"{_start(cell, wrong)}; from {a} to {b} it should be {texts}."


def _bent(cell: Deviation, wrong: Wrong) -> str:
    text = f"{_start(cell, wrong)}; it should be {_shown(cell)[1]}."
    if wrong.answer.links[cell.row].kind != PRISMATIC:
        return text
    return (f"{text} A prismatic joint does not turn, so q cannot make up for this angle: the row "
            "has to hold it.")


def _long(cell: Deviation, wrong: Wrong) -> str:
    text = f"{_start(cell, wrong)}; it should be {_shown(cell)[1]}"
    return f"{text}: its sign is wrong." if _opposite(cell) else f"{text}."


def _off(cell: Deviation, wrong: Wrong) -> str:
    run = _parallel(wrong.nearest.compared.right[:, ALPHA], cell.row)
    turning = [f"d{i + 1 + wrong.first}" for i in run if wrong.answer.links[i].kind == REVOLUTE]
    text = _long(cell, wrong)
    if len(turning) < 2:
        return text
    return f"{text} These axes are parallel: {', '.join(turning)} count only together."


def _parallel(twists: np.ndarray, row: int) -> range:
    """The rows whose z axes are parallel to that of a row."""
    bent = np.flatnonzero(np.abs(np.sin(twists)) > SIXTH_DECIMAL)
    return range(max(bent[bent < row] + 1, default=0),
                 min(bent[bent >= row] + 1, default=len(twists)))


def _zero(cell: Deviation, wrong: Wrong) -> str:
    got, expected = _shown(cell)
    joint = _joint(cell.row + 1, wrong)
    return (f"{_STANCE}. {joint}: {cell.parameter}{joint.removeprefix('Joint ')} should hold the "
            f"offset {expected}. It holds {got}.")


def _stance(cell: Deviation, wrong: Wrong) -> str:
    """A number that only the zero position or the tool tells."""
    got, expected = _shown(cell)
    the = f"he {WORDS[cell.parameter]} {_where(cell, wrong)}"
    if _opposite(cell) and cell.row < wrong.answer.rows[-1]:
        return f"{_STANCE}. T{the} should be {expected}: its sign is wrong."
    where = _TOOL if cell.row >= wrong.answer.rows[-1] else _STANCE
    return f"{where}: t{the} is {got}; it should be {expected}."


def _opposite(cell: Deviation) -> bool:
    return abs(cell.got + cell.expected) <= SIXTH_DECIMAL * abs(cell.got)


def _hint(cell: Deviation) -> str:
    """What the number looks like: rounded, in degrees, in another unit."""
    if cell.parameter not in ANGLES:
        return _unit_hint(cell)
    if abs(cell.got - cell.expected) < ROUNDED and cell.expected:
        return f" It looks rounded: write {_in_full(cell.expected)} rather than {cell.got:.10g}."
    if abs(cell.got) > 2 * pi + SIXTH_DECIMAL:
        return " Angles are in radians: write radians(90) for 90°."
    return ""


def _in_full(angle: float) -> str:
    multiple = plain_angle(angle)
    return f"radians({degrees(angle):.6g})" if multiple is None else pi_text(multiple)


def _unit_hint(cell: Deviation) -> str:
    factor = _unit(np.array([cell.got]), np.array([cell.expected]), 1)
    return f" It is {_times_too(factor)}: look at its unit." if factor else ""


def axis_name(answer: Arm, i: int) -> str:
    """The z that lies along the axis of a joint; joints count from 0 here."""
    return f"z{i + (answer.convention == 'modified')}"
