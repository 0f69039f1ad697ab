"""The DH table in a notebook: typed cells, and the live arm that follows them."""
from __future__ import annotations

import base64
from collections import deque
from collections.abc import Mapping, Sequence
from threading import RLock
from typing import Any

import numpy as np
import traitlets

from ..arms import inputs, printed
from ..arms.arm import Arm, check_arm
from ..arms.joints import first_pose
from ..arms.link import REVOLUTE, revolute
from ..browser import bundle
from ..drawing import worker
from ..drawing.arm_scene import arm_scene
from ..drawing.controls import tool_name
from ..tables.as_code import to_code
from ..tables.as_csv import to_csv
from ..tables.cells import MILLIMETRES
from ..tables.other_convention import other_reading
from ..tables.read import read_table
from ..tables.table import DHTable
from .arm_view import ArmView, formula_of, joints_text
from .table_panels import compared_html, lengths_text, reasons, signs_html, state, table_text

EDITS = ("with_cell", "with_kind", "with_row", "without_row", "with_row_moved", "with_length",
         "without_length", "without_end", "read_as", "converted_to", "in_angles", "in_unit")
PANELS = ("", "closed", "symbols", "signs", "compare")
MOST_STEPS = 200  # that can be undone
LONGEST_FORMULA = 30_000  # characters of LaTeX; more takes the browser minutes
MOST_ODD_ANGLES = 4
_ODD = ("With so many angles that are not multiples of 90° the closed form would fill pages. "
        "The numbers of T₀ₙ stand beside the picture.")


class DHTableEditor(ArmView):
    """A live arm with its DH table above it, to type in.

    The arm follows each edit at once. While a cell cannot be read it is marked, the reason stands
    below its row, and the arm stays as it was. All that an `ArmView` has is here, too: `q`, `T`,
    `joints`, a trait for each joint.

    Parameters
    ----------
    arm : Arm, optional
        The table to begin with; two links of 1 m if left out.
    angles : {"deg", "rad"}
        The unit of angles without one. Where pi stands in a cell, radians are meant.
    lengths : {name: number}, optional
        Lengths that cells may name, such as ``{"d2": 500}``.

    Attributes
    ----------
    arm : Arm
        The arm of the table, or of the last one that could be read. Setting it loads an arm.
    table : DHTable
        The table as typed: its `errors`, and its edits, each of which gives a new table.
        Setting it is one step that `undo` takes back.
    view : ArmView
        The live arm, which is the editor itself.

    Raises
    ------
    ValueError
        If an argument does not fit.

    Examples
    --------
    >>> from kinlab import robots
    >>> editor = DHTableEditor(robots.two_link())
    >>> editor.set(2, "a", "1.5")
    >>> editor.arm.links[1].a
    1.5
    >>> editor.set(2, "a", "1,5")
    >>> editor
    DHTableEditor('Two-link': modified DH, lengths in m, * marks the joint variable)
    i  joint     α(i-1)  a(i-1)  d      θ
    1  revolute       0       0  0  θ1* 0
    2  revolute       0     1,5  0  θ2* 0
    Row 2, a: '1,5': expected a number such as -90 deg, pi/2 or 177.8; write the decimal point as \
. and not as ,
    """

    _esm = bundle.module("host_table.js")
    _css = bundle.style("live.css", "table.css")
    cells = traitlets.Dict().tag(sync=True)    # the table for the browser
    panel = traitlets.Unicode().tag(sync=True)  # what is open under it, as HTML

    def __init__(self, arm: Arm | None = None, *, angles: str = "deg",
                 lengths: Mapping[str, float] | None = None) -> None:
        self._table = _first(arm, angles, {} if lengths is None else lengths)
        self._past: deque[DHTable] = deque(maxlen=MOST_STEPS)
        self._future: deque[DHTable] = deque()
        self._shown_table, self._one_at_a_time = self._table, RLock()  # cells may run in threads
        self._said, self._open = "", ""
        self._filled: tuple[str, Arm | None] = "", None
        assert self._table.arm is not None  # `_first` lets no errors through
        super().__init__(self._table.arm)
        self.on_msg(self._hear)
        self._tell()

    # ---- from Python ----

    @property
    def arm(self) -> Arm:
        return self._arm

    @arm.setter
    def arm(self, arm: Arm) -> None:
        self.table = _typed(arm, self._table.angles)

    @property
    def view(self) -> DHTableEditor:
        return self

    @property
    def table(self) -> DHTable:
        return self._table

    @table.setter
    def table(self, table: DHTable) -> None:
        if not isinstance(table, DHTable):
            raise ValueError(f"table: expected a DHTable, got {inputs.brief(table)}; "
                             "make one from editor.table")
        with self._one_at_a_time, self.hold_sync():
            self._said = ""
            if table != self._table:
                self._past.append(self._table)
                self._future.clear()
                self._show(table)
            self._tell()

    def set(self, row: int, column: str, text: str) -> None:
        """Type into a cell: 'theta', 'd', 'a', 'alpha', 'low', 'high' or 'home' of a row."""
        self.table = self._table.with_cell(row, column, text)

    def follow(self, arm: Arm, q: Any = None) -> None:
        """Load an arm, and bring it to joint values `q`, its home if left out."""
        q = first_pose(arm, q)
        self.arm = arm
        self.q = q

    def undo(self) -> None:
        """Take back the last edit."""
        self._step(self._past, self._future)

    def redo(self) -> None:
        """Make the edit again that was taken back last."""
        self._step(self._future, self._past)

    def to_csv(self) -> str:
        """The table as CSV, cells that cannot be read included."""
        return to_csv(self._table)

    def to_code(self) -> str:
        """The arm of the table as Python code; ValueError while a cell is wrong."""
        return to_code(self._table)

    def load(self, text: str, **choices: str) -> None:
        """Load a table from text: CSV, Markdown, LaTeX, kinlab code. Nothing is run."""
        self.table = read_table(text, self._table, **choices).table

    def __repr__(self) -> str:
        table = self._table
        title = printed.title(repr(table.name) if table.name else "", table.convention, table.unit)
        return "\n".join([f"{type(self).__name__}({title})",
                          *printed.lines(table_text(table), words=1),
                          *lengths_text(table), *reasons(table)])

    def _elsewhere(self) -> tuple[dict, dict]:
        return {"text/plain": repr(self)}, {}

    # ---- from the browser ----

    def _hear(self, _: Any, content: Any, buffers: Any) -> None:
        """What the student did. What cannot be done is said beside the table."""
        with self._one_at_a_time:
            try:
                self._do(content["do"], content.get("with", []))
            except ValueError as error:
                self._said = str(error).removeprefix("text: ")
                self._tell()

    def _do(self, what: str, arguments: Sequence) -> None:
        if what in EDITS:
            self.table = getattr(self._table, what)(*arguments)
        elif what in ("undo", "redo", "load"):
            getattr(self, what)(*arguments)
        elif what == "open":
            self._open, self._said = inputs.choice("panel", arguments[0], PANELS), ""
            self._tell()

    # ---- to the browser ----

    def _step(self, back: deque[DHTable], ahead: deque[DHTable]) -> None:
        with self._one_at_a_time, self.hold_sync():
            self._said = ""
            if back:
                ahead.append(self._table)
                self._show(back.pop())
            self._tell()

    def _show(self, table: DHTable) -> None:
        """Take a table; the arm follows if the table can be read."""
        self._table, arm = table, table.arm
        if arm is not None and not _alike(arm, self._arm):
            super().follow(arm, self._values_for(table, arm))
        if arm is not None:
            self._shown_table = table

    def _values_for(self, table: DHTable, arm: Arm) -> np.ndarray:
        """Joint values: as they were where the joint was there before, else home."""
        old, new = MILLIMETRES.get(self._shown_table.unit), MILLIMETRES.get(table.unit)
        longer = float(old / new) if old and new else 1.0
        before = {(row.key, row.kind): value * (1.0 if row.kind == REVOLUTE else longer)
                  for row, value in zip(self._shown_table.rows, self.q)}
        return np.array([before.get((row.key, row.kind), home)
                         for row, home in zip(table.rows, arm.home)])

    def _tell(self) -> None:
        """Bring the browser's table and panel up to date."""
        with self.hold_sync():
            self.cells = state(self._table) | {
                "undo": bool(self._past), "redo": bool(self._future), "open": self._open,
                "said": self._said, "code": to_code(self._table) if self._table.arm else ""}
            if self._filled != (self._open, self._arm):
                self._filled = self._open, self._arm
                self.panel = self._panel()

    def _panel(self) -> str:
        """What is open under the table, as HTML."""
        if self._open == "signs":
            return signs_html(self._arm)
        if self._open == "compare":
            return self._compared()
        return self._formula() if self._open else ""

    def _formula(self) -> str:
        from ..arms.symbolic import closed_form

        odd = [angle for link in self._arm.links for angle in (link.theta, link.alpha)
               if abs(np.sin(2 * angle)) > 1e-9]
        if len(odd) > MOST_ODD_ANGLES:
            return _ODD
        lengths = "numbers" if self._open == "closed" else "symbols"
        latex = closed_form(self._arm, lengths=lengths).latex
        if len(latex) > LONGEST_FORMULA:
            return _ODD
        return formula_of(self._arm, f"T_0^{{{tool_name(self._arm)}}} = {latex}")

    def _compared(self) -> str:
        arm, q = self._arm, self.q
        reading = other_reading(arm, q)
        still = worker.png(arm_scene(reading.numbers), q, "3-D", ("frames", "labels"))
        picture = base64.b64encode(still).decode()
        at = joints_text(arm, [joint.value for joint in self.joints])
        return compared_html(arm, reading, at, picture)


def _first(arm: Arm | None, angles: str, lengths: Any) -> DHTable:
    arm = Arm([revolute(a=1), revolute(a=1)]) if arm is None else arm
    table = _typed(arm, inputs.choice("angles", angles, ("deg", "rad")))
    if not isinstance(lengths, Mapping):
        raise ValueError(f"lengths: expected names with their lengths, got "
                         f"{inputs.brief(lengths)}; write {{'d2': 500}}")
    for k, (name, value) in enumerate(lengths.items(), start=1):
        number = inputs.number(f"lengths[{name!r}]", value)
        table = table.with_length(k, name, repr(number).removesuffix(".0"))
    if table.errors:
        raise ValueError(f"lengths: {next(iter(table.errors.values()))}")
    return table


def _typed(arm: Any, angles: str) -> DHTable:
    """The table of an arm, if its numbers are such as a table takes."""
    check_arm(arm)
    table = DHTable.of(arm, angles)
    if table.errors:
        raise ValueError(f"arm: expected numbers that fit a table; {reasons(table)[0]}")
    return table


def _alike(a: Arm, b: Arm) -> bool:
    words = [(arm.links, arm.convention, arm.name, arm.unit) for arm in (a, b)]
    return words[0] == words[1] and all(
        np.array_equal(getattr(a, part), getattr(b, part)) for part in ("base", "tool", "home"))
