"""A DH table as a student types it: frozen text, what it says, and the edits that change it."""
from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import count
from typing import Any, NamedTuple

import numpy as np

from ..arms import inputs
from ..arms.arm import CONVENTIONS, Arm, to_modified, to_standard
from ..arms.link import FIXED, KINDS, PARAMETERS, REVOLUTE, Link, variable_of
from ..arms.printed import joint_numbers
from .cells import (
    ANGLES,
    MILLIMETRES,
    angle_hint,
    angle_in,
    angle_text,
    length_in,
    line,
    number_text,
    read_angle,
    read_length,
)
from .ends import ENDS, FORMS, POSE, ROW, TURNS, End
from .measures import angle_of, length_text
from .numbers import name_refused
from .spelling import plain
from .variables import variable

LIMITS = ("low", "high", "home")
RATES = ("speed", "acceleration")
COLUMNS = PARAMETERS + LIMITS + RATES
MOST_ROWS = MOST_LENGTHS = 60
_NARROWEST = 1e-6  # rad or length, between the limits of a joint
_keys = count()


@dataclass(frozen=True)
class Row:
    """One row: its type and the text of its cells.

    The cell of the joint variable (theta or d) holds the joint's offset; a fixed row has none.
    Limits, home and rates may be empty; two equal limits lock the joint. The rates, its largest
    speed and acceleration, are in the joint's unit per s and per s^2. A joint with `flip` counts
    the other way. `key` stays with a row while rows come, go and move.
    """

    kind: str = REVOLUTE
    theta: str = "0"
    d: str = "0"
    a: str = "0"
    alpha: str = "0"
    low: str = ""
    high: str = ""
    home: str = ""
    name: str = ""
    flip: bool = False
    speed: str = ""
    acceleration: str = ""
    key: int = field(default_factory=_keys.__next__, compare=False)

    @property
    def variable(self) -> str | None:
        """The column that holds the joint's offset; None for a fixed row."""
        return variable_of(self.kind)

    def with_cells(self, cells: Mapping[str, Any]) -> Row:
        """The row with the texts of some cells changed."""
        return replace(self, **cells)

    def is_angle(self, column: str) -> bool:
        """Whether a column holds an angle: those of limits, home and rates do as the joint does."""
        its_own = column in LIMITS or column in RATES
        return column in ("theta", "alpha") or (its_own and self.kind == REVOLUTE)


class Place(NamedTuple):
    """Where something stands: row (from 1) and column, a named length (from 1), or a cell of the
    base or the tool, whose name stands for a row's number.
    """

    row: int | str
    column: str


@dataclass(frozen=True)
class DHTable:
    """A DH table as typed. Rows and named lengths count from 1.

    Attributes
    ----------
    rows : tuple of Row
    convention : {"standard", "modified"}
    angles : {"deg", "rad"}
        The unit of an angle without one.
    unit : str
        The unit of all lengths.
    lengths : tuple of (name, text)
        Lengths that cells may name.
    base, tool : End or None
        The frames at both ends: typed, or a matrix that is carried along unchanged.
    errors : dict
        The reason, in one line, for each place that cannot be read.
    hints : dict
        For each angle that can be read, but was hardly meant so, what may have been meant.
    arm : Arm or None
        The arm that the table describes, if it can be read.

    Examples
    --------
    >>> table = DHTable((Row(), Row())).with_cell(1, "a", "l1").with_length(1, "l1", "0.5")
    >>> table.arm.links[0].a
    0.5
    >>> table.with_cell(2, "alpha", "90 grad").errors
    {Place(row=2, column='alpha'): "'90 grad': expected a number such as -90 deg, pi/2 or 177.8; \
'grad' is not known; known are pi, deg, rad"}
    """

    rows: tuple[Row, ...]
    convention: str = "standard"
    angles: str = "deg"
    unit: str = "m"
    lengths: tuple[tuple[str, str], ...] = ()
    name: str = ""
    base: End | None = None
    tool: End | None = None

    @classmethod
    def of(cls, arm: Arm, angles: str = "deg") -> DHTable:
        """The table of an arm."""
        homes = dict(zip(arm.rows, arm.home.tolist()))
        rows = tuple(_row(link, homes.get(k, 0.0), angles) for k, link in enumerate(arm.links))
        return cls(rows, arm.convention, angles, line(arm.unit), (), line(arm.name),
                   End.of(arm.base), End.of(arm.tool))

    # ---- what it says ----

    @property
    def errors(self) -> dict[Place, str]:
        return self._reading[1]

    @property
    def values(self) -> dict[Place, float]:
        """What each place says, where it can be read: radians and lengths."""
        return self._reading[0]

    @property
    def hints(self) -> dict[Place, str]:
        angles = {Place(i, column): getattr(row, column)
                  for i, row in enumerate(self.rows, start=1)
                  for column in PARAMETERS + LIMITS if row.is_angle(column)}
        angles |= {Place(end, column): text for end, frame in self._ends() if frame.texts
                   for column, text in zip(frame.columns, frame.texts) if column in TURNS}
        return {place: hint for place, text in angles.items()
                if (hint := angle_hint(text, self.angles))}

    @cached_property
    def arm(self) -> Arm | None:
        if self.errors:
            return None
        links = [self._link(i, row) for i, row in enumerate(self.rows, start=1)]
        home = [self.values.get(Place(i, "home"), link.lock or 0.0)
                for i, link in enumerate(links, start=1) if link.kind != FIXED]
        return Arm(links, convention=self.convention, name=self.name, unit=self.unit,
                   base=self.end("base"), tool=self.end("tool"), home=home)

    def end(self, end: str) -> np.ndarray | None:
        """The base or the tool as a matrix, shape (4, 4); None if a cell of it cannot be read."""
        frame = getattr(self, end)
        if frame is None:
            return np.eye(4)
        values = {place.column: value for place, value in self.values.items() if place.row == end}
        return None if frame.texts and len(values) < len(frame.texts) \
            else frame.matrix(values, self.convention)

    @cached_property
    def _reading(self) -> tuple[dict[Place, float], dict[Place, str]]:
        values: dict[Place, float] = {}
        errors: dict[Place, str] = {}
        names = self._names(values, errors)
        for i, row in enumerate(self.rows, start=1):
            for column in COLUMNS:
                text = getattr(row, column)
                if text or column in PARAMETERS:
                    read = self._reading_of(row.is_angle(column), names)
                    _note(Place(i, column), read, text, values, errors)
            _check_limits(i, row, values, errors)
            _check_rates(i, row, values, errors)
        for end, frame in self._ends():
            for column, text in frame.cells(self.angles).items() if frame.texts else ():
                read = self._reading_of(column in TURNS, names)
                _note(Place(end, column), read, text, values, errors)
        for place, name in self._waiting(names, errors):
            errors[place] = f"give {inputs.brief(name)} a value first"
        if all(row.kind == FIXED for row in self.rows):
            errors.setdefault(Place(1, "theta"), "expected at least one joint; make a row revolute "
                                                 "or prismatic")
        return values, errors

    def _waiting(self, names: Mapping[str, float], errors: Mapping[Place, str]
                 ) -> list[tuple[Place, str]]:
        """The cells of rows that name a length which has no value yet."""
        open_ = {name for name, _ in self.lengths if name not in names and not name_refused(name)}
        cells = ((place, getattr(self.rows[place.row - 1], place.column)) for place in errors
                 if isinstance(place.row, int) and place.column in COLUMNS)
        words = ((place, re.findall(r"[A-Za-z_]\w*", text)) for place, text in cells)
        return [(place, next(filter(open_.__contains__, found))) for place, found in words
                if open_ & set(found)]

    def _ends(self) -> list[tuple[str, End]]:
        """The base and the tool, as far as there are any."""
        return [(end, frame) for end in ENDS if (frame := getattr(self, end))]

    def _names(self, values: dict, errors: dict) -> dict[str, float]:
        """The lengths given beside, as far as they can be read."""
        names: dict[str, float] = {}
        for k, (name, text) in enumerate(self.lengths, start=1):
            place = Place(k, "length")
            _note(place, read_length, text, values, errors)
            if name in names:
                errors[place] = f"{inputs.brief(name)} is there twice; rename one"
            elif place in values and not (reason := name_refused(name)):
                names[name] = values[place]
            elif place in values:
                errors[place] = reason
        return names

    def _reading_of(self, angle: bool, names: dict[str, float]) -> Callable[[str], float]:
        if angle:
            return lambda text: read_angle(text, self.angles)
        return lambda text: read_length(text, names)

    def _link(self, i: int, row: Row) -> Link:
        theta, d, a, alpha = (self.values[Place(i, column)] for column in PARAMETERS)
        low, high = Place(i, "low"), Place(i, "high")
        limits = (self.values[low], self.values[high]) if row.low else None
        rates = {column: self.values.get(Place(i, column)) for column in RATES}
        return Link(row.kind, theta, d, a, alpha, limits, row.name or None, row.flip, **rates)

    # ---- edits: each gives a new table, and refuses what makes no table at all ----

    def with_cell(self, row: int | str, column: str, text: str) -> DHTable:
        """The text of a cell changed, to anything.

        "base" or "tool" for a row types into that frame; its columns are x, y, z, roll, pitch,
        yaw, or those of a DH row. The joint's own variable, q2 or θ2* in row 2, is left out: its
        cell holds the offset. A minus before it makes the joint count the other way. What cannot
        be read as it stands is written as a pasted table would be: np.pi/2 as pi/2.
        """
        if isinstance(row, str):
            return self._with_end_cell(row, column, text)
        inputs.choice("column", column, COLUMNS)
        text = line(text)
        its = variable(text, column) if column == self._row(row).variable else None
        if its is None or text in dict(self.lengths) or its.number not in (
                None, joint_numbers(self.rows)[row - 1]):
            return self._with(row, **{column: self._spelled(row, column, text)})
        offset = self._spelled(row, column, its.offset)
        return self._with(row, **{column: offset, "flip": its.flip})

    def _spelled(self, row: int, column: str, text: str) -> str:
        """The text of a cell; where it cannot be read, as a pasted table would have it."""
        angle = self._row(row).is_angle(column)
        read, plainly = self._reading_of(angle, self._names({}, {})), plain(text)
        other = angle_of(plainly, self.angles, self.angles) if angle \
            else length_text(plainly, self.unit, self.unit)
        return next((words for words in (text, other) if _can(read, words)), text)

    def _with_end_cell(self, end: str, column: str, text: str) -> DHTable:
        frame = self._end(end) or End.empty(ROW if column in FORMS[ROW] else POSE)
        inputs.choice("column", column, frame.columns)
        return self.with_frame(end, frame.with_cells({column: line(text)}, self.angles))

    def with_kind(self, row: int, kind: str) -> DHTable:
        """The joint's type changed. Limits, home and rates, in another unit now, are emptied."""
        inputs.choice("kind", kind, KINDS)
        if self._row(row).kind == kind:
            return self
        flip = self._row(row).flip and kind != FIXED
        return self._with(row, kind=kind, flip=flip, **dict.fromkeys(LIMITS + RATES, ""))

    def with_flip(self, row: int, flip: bool) -> DHTable:
        """The joint made to count the other way, or as z says again."""
        return self._with_joint(row, flip=inputs.yes_or_no("flip", flip))

    def with_limits(self, row: int, low: str, high: str) -> DHTable:
        """Both limits of a joint changed: two equal ones lock it, two empty ones are none."""
        return self._with_joint(row, low=line(low), high=line(high))

    def with_row(self, after: int | None = None) -> DHTable:
        """A new row of zeros below another; the last if left out."""
        at = len(self.rows) if after is None else _position("row", after, len(self.rows))
        if len(self.rows) >= MOST_ROWS:
            raise ValueError(f"row: expected at most {MOST_ROWS} rows; remove one first")
        return replace(self, rows=(*self.rows[:at], Row(), *self.rows[at:]))

    def without_row(self, row: int) -> DHTable:
        if len(self.rows) == 1:
            raise ValueError("row: expected at least one row in the table; add another first")
        at = _position("row", row, len(self.rows))
        return replace(self, rows=self.rows[:at - 1] + self.rows[at:])

    def with_row_moved(self, row: int, to: int) -> DHTable:
        rows = list(self.rows)
        moved = rows.pop(_position("row", row, len(rows)) - 1)
        rows.insert(_position("to", to, len(self.rows)) - 1, moved)
        return replace(self, rows=tuple(rows))

    def with_length(self, k: int, name: str, text: str) -> DHTable:
        """A named length changed, or one more named at the end of the list."""
        at = _position("length", k, min(len(self.lengths) + 1, MOST_LENGTHS)) - 1
        pair = (line(name), line(text))
        return replace(self, lengths=(*self.lengths[:at], pair, *self.lengths[at + 1:]))

    def without_length(self, k: int) -> DHTable:
        at = _position("length", k, len(self.lengths))
        return replace(self, lengths=self.lengths[:at - 1] + self.lengths[at:])

    def with_end(self, end: str, form: str = POSE) -> DHTable:
        """The base or the tool frame to be typed: as a 'pose' (x, y, z and the turns roll, pitch,
        yaw about the fixed axes x, y, z), or as one DH 'row'. A frame that is there stays.
        """
        frame, T = self._end(end), self.end(end)
        inputs.choice("form", form, tuple(FORMS))
        if T is None:
            raise ValueError(f"{end}: expected cells that can be read; correct the marked ones "
                             "first")
        if frame is None:
            return self.with_frame(end, End.empty(form))
        return self if frame.form == form else self.with_frame(
            end, frame.in_form(form, T, self.angles, self.convention))

    def without_end(self, end: str) -> DHTable:
        """The base or the tool frame left out."""
        return self.with_frame(end, None)

    def with_frame(self, end: str, frame: End | None) -> DHTable:
        """Another frame at one end; None for one that changes nothing."""
        inputs.choice("end", end, ENDS)
        return replace(self, base=frame) if end == "base" else replace(self, tool=frame)

    def _end(self, end: str) -> End | None:
        return getattr(self, inputs.choice("end", end, ENDS))

    def read_as(self, convention: str) -> DHTable:
        """The same numbers read in the other convention: in general another arm."""
        return replace(self, convention=inputs.choice("convention", convention, tuple(CONVENTIONS)))

    def converted_to(self, convention: str) -> DHTable:
        """The same arm in the other convention: twists and lengths move by one row."""
        inputs.choice("convention", convention, tuple(CONVENTIONS))
        if self.arm is None:
            raise ValueError("convention: expected a table that can be read; "
                             "correct the marked cells first")
        if convention == self.convention:
            return self
        arm = (to_modified if convention == "modified" else to_standard)(self.arm)
        shift = -1 if convention == "modified" else 1
        rows = tuple(row.with_cells({column: self._moved_text(i + shift, column, link)
                                     for column in ("a", "alpha")})
                     for i, (row, link) in enumerate(zip(self.rows, arm.links), start=1))
        return replace(self, rows=rows, convention=convention,
                       base=self._moved_end("base", arm), tool=self._moved_end("tool", arm))

    def in_angles(self, unit: str) -> DHTable:
        """The same table with its plain angles in degrees or radians."""
        inputs.choice("angles", unit, tuple(ANGLES))
        return self._rewritten(True, lambda text: angle_in(text, self.angles, unit), angles=unit)

    def in_unit(self, unit: str) -> DHTable:
        """The same arm with its lengths in another unit: mm, cm, m or in."""
        old, new = self.unit, inputs.choice("unit", unit, tuple(MILLIMETRES))
        if old not in MILLIMETRES:
            raise ValueError(f"unit: lengths in {inputs.brief(old)} cannot be converted; "
                             f"expected {' or '.join(MILLIMETRES)}")
        lengths = tuple((name, length_in(text, old, new, {}, {})) for name, text in self.lengths)
        there = replace(self, lengths=lengths, unit=new)
        names, new_names = self._names({}, {}), there._names({}, {})
        factor = float(MILLIMETRES[old] / MILLIMETRES[new])
        scaled = self
        for end, frame in self._ends():
            scaled = scaled.with_frame(end, frame.scaled(factor))
        return scaled._rewritten(False, lambda text: length_in(text, old, new, names, new_names),
                                 lengths=lengths, unit=new)

    def _with_joint(self, row: int, **changes: Any) -> DHTable:
        if self._row(row).kind == FIXED:
            raise ValueError(f"row: expected a joint in row {row}, got a fixed row")
        return self._with(row, **changes)

    def _with(self, row: int, **changes: Any) -> DHTable:
        changed = replace(self._row(row), **changes)
        return replace(self, rows=(*self.rows[:row - 1], changed, *self.rows[row:]))

    def _row(self, row: int) -> Row:
        return self.rows[_position("row", row, len(self.rows)) - 1]

    def _moved_text(self, row: int, column: str, link: Link) -> str:
        """A cell that moved: as it was typed, where it came from a row of this table."""
        value = getattr(link, column)
        if self.values.get(Place(row, column)) == value:
            return getattr(self.rows[row - 1], column)
        return angle_text(value, self.angles) if column == "alpha" else number_text(value)

    def _moved_end(self, end: str, arm: Arm) -> End | None:
        """An end of the arm in the other convention: as it was typed, where it is the same."""
        frame, T = self._end(end), getattr(arm, end)
        same = np.allclose(getattr(self.arm, end), T, rtol=0, atol=1e-15)
        return frame if same and frame is not None and frame.form == POSE else End.of(T)

    def _rewritten(self, turns: bool, rewrite: Callable[[str], str], **changes: Any) -> DHTable:
        """The table with all its angles, or all its lengths, written anew."""
        rows = tuple(row.with_cells({column: rewrite(getattr(row, column)) for column in COLUMNS
                                     if row.is_angle(column) == turns and getattr(row, column)})
                     for row in self.rows)
        table = replace(self, rows=rows)
        for end, frame in self._ends():
            texts = {column: rewrite(text) for column, text in frame.cells(self.angles).items()
                     if (column in TURNS) == turns}
            table = table.with_frame(end, frame.with_cells(texts, self.angles)
                                     if frame.texts else frame)
        return replace(table, **changes)


def _row(link: Link, home: float, angles: str) -> Row:
    row = Row(link.kind, flip=link.flip)
    low, high = link.limits or (None, None)
    values = {parameter: getattr(link, parameter) for parameter in PARAMETERS}
    at_home = home == (link.lock or 0.0)
    values |= {"low": low, "high": high, "home": None if at_home else home}
    values |= {rate: getattr(link, rate) for rate in RATES}
    texts = {column: "" if value is None else angle_text(value, angles) if row.is_angle(column)
             else number_text(value) for column, value in values.items()}
    return row.with_cells(texts | {"name": line(link.name or "")})


def _note(place: Place, read: Callable, text: str, values: dict, errors: dict) -> None:
    try:
        values[place] = read(text)
    except ValueError as error:
        errors[place] = str(error)


def _can(read: Callable[[str], float], text: str) -> bool:
    try:
        read(text)
    except ValueError:
        return False
    return True


def _check_limits(i: int, row: Row, values: dict, errors: dict) -> None:
    low, high = (values.get(Place(i, column)) for column in ("low", "high"))
    if row.kind == FIXED:
        errors |= {Place(i, column): "a fixed row has no joint; leave this cell empty"
                   for column in LIMITS + RATES if getattr(row, column)}
    elif bool(row.low) != bool(row.high):
        column = "high" if row.low else "low"
        errors[Place(i, column)] = "expected both limits, or neither"
    elif low is not None and high is not None and low != high and high - low < _NARROWEST:
        errors[Place(i, "high")] = ("expected an upper limit above the lower one, or equal to it: "
                                    "that locks the joint")


def _check_rates(i: int, row: Row, values: dict, errors: dict) -> None:
    for place in (Place(i, column) for column in RATES):
        if row.kind != FIXED and values.get(place, 1.0) <= 0:
            errors[place] = "expected a number above 0; leave the cell empty if it is not known"


def _position(name: str, value: Any, last: int) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= last:
        raise ValueError(f"{name}: expected a number from 1 to {last}, got {inputs.brief(value)}")
    return value
