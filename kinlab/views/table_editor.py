"""The DH table in a notebook: typed cells, and the live arm that follows them."""
from __future__ import annotations

import base64
from collections import deque
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from threading import RLock
from typing import Any

import numpy as np
import traitlets

from ..answers.handed import marked
from ..arms import inputs, printed
from ..arms.arm import Arm, check_arm
from ..arms.joints import first_pose
from ..arms.link import Link, revolute
from ..arms.rounded import plain_angle
from ..browser import bundle
from ..drawing import worker
from ..drawing.arm_scene import arm_scene
from ..drawing.controls import tool_name
from ..tables.as_code import to_code
from ..tables.as_csv import to_csv
from ..tables.as_document import to_latex, to_markdown
from ..tables.cells import MILLIMETRES, angle_text, number_text
from ..tables.ends import End
from ..tables.other_convention import other_reading
from ..tables.question import Ambiguous
from ..tables.read import read_table
from ..tables.table import DHTable, Place, Row
from .arm_view import ArmView, formula_of, joints_text, remarks_html
from .table_panels import (
    compared_html,
    ends_text,
    hints,
    left_out_text,
    lengths_in,
    lengths_text,
    named_cells,
    reasons,
    signs_html,
    state,
    table_text,
)

EDITS = ("with_cell", "with_kind", "with_row", "without_row", "with_row_moved", "with_length",
         "without_length", "with_end", "without_end", "with_flip", "read_as", "converted_to",
         "in_angles", "in_unit")
# What else the browser asks for, and who does it.
_DOES = {"undo": "undo", "redo": "redo", "lock": "lock", "unlock": "unlock", "load": "_read",
         "answer": "_answer", "dismiss": "_dismiss", "open": "_open_panel"}
PANELS = ("", "closed", "symbols", "signs", "compare")
MOST_STEPS = 200  # that can be undone
LONGEST_FORMULA = 30_000  # characters of LaTeX; more takes the browser minutes
MOST_ODD_ANGLES = 4
_ODD = ("With so many angles that are not multiples of 90° the closed form would fill pages. "
        "The numbers of T₀ₙ stand beside the picture.")


@dataclass(frozen=True)
class _Asked:
    """A pasted text that may be read in more than one way, and what was answered so far."""

    question: Ambiguous
    text: str
    choices: Mapping[str, str]


class DHTableEditor(ArmView):
    """A live arm with its DH table above it, to type in.

    The arm follows each edit at once. While a cell cannot be read it is marked, the reason stands
    below its row, and the arm stays as it was: it is not that of the table then. All that an
    `ArmView` has is here, too: `q`, `T`, `joints`, a trait for each joint.

    A table that is pasted into any cell is loaded, as `load` does it.

    `save_html` writes a page of the arm alone, without the table: it needs Python to be read. For
    the table there are `to_csv`, `to_code`, `to_markdown` and `to_latex`.

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
        What the picture shows: the arm of the table. While a cell is marked it is the arm of the
        last table that could be read, which no check judges; `table.arm` is None then. Setting
        it loads an arm.
    table : DHTable
        The table as typed: its `errors`, and its edits, each of which gives a new table.
        Setting it is one step that `undo` takes back.
    base, tool : array, shape (4, 4)
        Pose of frame 0 in the room, and of the tool in the last frame. Setting one is one step
        that `undo` takes back; `set` types into its cells.
    said : str
        What was said last: what was assumed of a text, or why something could not be done.
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
    tool: x 1
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
        self._asked: _Asked | None = None
        self._seen: dict[tuple[int, str], tuple[float, str]] = {}  # joints' values, with their unit
        self._filled: tuple[str, Arm | None, dict] = "", None, {}
        assert self._table.arm is not None  # `_first` lets no errors through
        super().__init__(self._table.arm)
        self.on_msg(self._hear)
        self._tell()

    # ---- from Python ----

    @property
    def arm(self) -> Arm:
        return marked(self._arm, "" if self._table.arm else reasons(self._table)[0])

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
        self._accept(table)

    @property
    def base(self) -> np.ndarray:
        return self._arm.base

    @base.setter
    def base(self, T: Any) -> None:
        self.table = self._table.with_frame("base", End.of(inputs.rigid("base", T)))

    @property
    def tool(self) -> np.ndarray:
        return self._arm.tool

    @tool.setter
    def tool(self, T: Any) -> None:
        self.table = self._table.with_frame("tool", End.of(inputs.rigid("tool", T)))

    @property
    def said(self) -> str:
        return self._said

    def set(self, row: int | str, column: str, text: str) -> None:
        """Type into a cell: 'theta', 'd', 'a', 'alpha', 'low', 'high', 'home', 'speed' (the
        largest, per s) or 'acceleration' (per s^2) of a row.

        Row "base" or "tool" is that frame: 'x', 'y', 'z' and the turns 'roll', 'pitch', 'yaw'
        about the fixed axes x, y and z, in this order.

        Examples
        --------
        >>> editor = DHTableEditor()
        >>> editor.set("tool", "z", "0.303")
        >>> float(editor.arm.tool[2, 3])
        0.303
        """
        self.table = self._table.with_cell(row, column, text)

    def lock(self, row: int) -> None:
        """Lock a joint where it is now: both of its limits become its value."""
        text = self._text_of(row)
        self.table = self._table.with_limits(row, text, text)

    def unlock(self, row: int) -> None:
        """Take the limits of a joint away."""
        self.table = self._table.with_limits(row, "", "")

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

    def to_markdown(self) -> str:
        """The table in Markdown, as GitHub and notebooks show it; `load` reads it."""
        return to_markdown(self._table)

    def to_latex(self) -> str:
        """The table as a LaTeX array; `load` reads it."""
        return to_latex(self._table)

    def load(self, text: str, **choices: str) -> None:
        """Load a table from text, as people have it; what was assumed stands in `said`.

        Read are CSV, tabs, blanks, Markdown, LaTeX, an HTML table, what kinlab prints, and kinlab
        code, which is never run. What the text leaves open is as in the table that is there.

        Parameters
        ----------
        text : str
        **choices
            Answers where a text may be read in more than one way: ``angles="deg"`` or ``"rad"``,
            ``convention="standard"`` or ``"modified"``, ``decimal="."`` or ``","``.

        Raises
        ------
        ValueError
            If the text is no table, or may be read in more than one way; it says how to answer.

        Examples
        --------
        >>> editor = DHTableEditor()
        >>> editor.load("theta,d,a,alpha\\n0,0.2,0,90\\n")
        >>> editor.arm.n
        1
        """
        loaded = read_table(text, self._table, **choices)
        self._accept(loaded.table, loaded.remark)

    def __repr__(self) -> str:
        table = self._table
        title = printed.title(repr(table.name) if table.name else "", table.convention, table.unit)
        return "\n".join([f"{type(self).__name__}({title})",
                          *printed.lines(table_text(table), words=1),
                          *lengths_text(table), *ends_text(table), *reasons(table), *hints(table)])

    def _elsewhere(self) -> tuple[dict, dict]:
        return {"text/plain": f"{self!r}\nRun this cell to type in the table."}, {}

    # ---- from the browser ----

    def _hear(self, _: Any, content: Any, buffers: Any) -> None:
        """What the student did. What cannot be done is said beside the table."""
        with self._one_at_a_time:
            try:
                self._do(content["do"], content.get("with", []))
            except ValueError as error:
                self._asked, self._said = None, str(error)
                self._tell()

    def _do(self, what: str, arguments: Sequence) -> None:
        if what in EDITS:
            self.table = getattr(self._table, what)(*arguments)
        elif what in _DOES:
            getattr(self, _DOES[what])(*arguments)

    def _read(self, text: str, **choices: str) -> None:
        """Load a pasted text; what it leaves open becomes a question."""
        try:
            self.load(text, **choices)
        except Ambiguous as question:
            self._asked, self._said = _Asked(question, text, choices), ""
            self._tell()

    def _answer(self, k: int) -> None:
        """Load the text with the answer number k, from 0."""
        if self._asked and k in range(len(self._asked.question.options)):
            asked, (_, choices) = self._asked, self._asked.question.options[k]
            self._read(asked.text, **{**asked.choices, **choices})

    def _dismiss(self) -> None:
        self._asked = None
        self._tell()

    def _open_panel(self, panel: str) -> None:
        self._open, self._said = inputs.choice("panel", panel, PANELS), ""
        self._tell()

    # ---- to the browser ----

    def _accept(self, table: DHTable, said: str = "") -> None:
        """Take a table as one step that can be undone."""
        with self._one_at_a_time, self.hold_sync():
            self._asked, self._said = None, said
            if table != self._table:
                self._past.append(self._table)
                self._future.clear()
                self._show(table)
            self._tell()

    def _step(self, back: deque[DHTable], ahead: deque[DHTable]) -> None:
        with self._one_at_a_time, self.hold_sync():
            self._asked, self._said = None, ""
            if back:
                ahead.append(self._table)
                self._show(back.pop())
            self._tell()

    def _show(self, table: DHTable) -> None:
        """Take a table; the arm follows if the table can be read."""
        self._table, arm = table, table.arm
        if arm is not None and not _alike(arm, self._arm):
            self._look()
            super().follow(arm, [self._value_of(table, row, home)
                                 for row, home in zip(_joints(table), arm.home.tolist())])
        if arm is not None:
            self._shown_table = table

    def _look(self) -> None:
        """Keep the joints' values; a row that comes back finds its own."""
        for row, value in zip(_joints(self._shown_table), self.q.tolist()):
            self._seen[row.key, row.kind] = value, self._shown_table.unit

    def _value_of(self, table: DHTable, row: Row, home: float) -> float:
        """A joint's value as it was seen last, else at home."""
        value, unit = self._seen.get((row.key, row.kind), (home, table.unit))
        old, new = MILLIMETRES.get(unit), MILLIMETRES.get(table.unit)
        return value * float(old / new) if old and new and not row.is_angle("home") else value

    def _text_of(self, row: int) -> str:
        """A joint's value now, as the text of a cell."""
        self._look()
        there = self._table.with_cell(row, "home", "").rows[row - 1]  # refuses what is no row
        value = self._value_of(self._table, there, 0.0)
        return angle_text(value, self._table.angles) if there.is_angle("home") \
            else number_text(value)

    def _tell(self) -> None:
        """Bring the browser's table and panel up to date."""
        with self.hold_sync():
            self.cells = state(self._table) | {
                "undo": bool(self._past), "redo": bool(self._future), "open": self._open,
                "said": self._said, "question": _question(self._asked),
                "texts": _texts(self._table)}
            shown = self._open, self._arm, named_cells(self._shown_table)
            if self._filled != shown:
                self._filled = shown
                self.panel = self._panel()

    def _panel(self) -> str:
        """What is open under the table, as HTML."""
        if self._open == "signs":
            return signs_html(self._arm)
        if self._open == "compare":
            return self._compared()
        return self._formula() if self._open else ""

    def _formula(self) -> str:
        """The arm matrix; where a cell names a length, its text stands there."""
        from ..arms.symbolic import closed_form

        if sum(map(_is_odd, self._arm.links)) > MOST_ODD_ANGLES:
            return _ODD
        named, left_out = self._written()
        form = closed_form(self._arm, symbols=named, lengths=self._lengths(named.values()))
        if len(form.latex) > LONGEST_FORMULA:
            return _ODD
        formula = formula_of(self._arm, f"T_0^{{{tool_name(self._arm)}}} = {form.latex}")
        return formula + remarks_html(form.remark, left_out_text(left_out))

    def _lengths(self, texts: Collection[str]) -> Any:
        """How lengths stand in a formula that has these texts of the table in it."""
        if self._open == "symbols":
            return "symbols"
        return lengths_in(self._shown_table, texts) if texts else "numbers"

    def _written(self) -> tuple[dict, list[Place]]:
        """The texts that stand for numbers in a formula, and where a text cannot."""
        from ..arms.letters import letters

        named, left_out = {}, []
        for place, text in named_cells(self._shown_table).items():
            try:
                letters(self._arm, self._lengths([text]), {tuple(place): text})
                named[tuple(place)] = text
            except ValueError:  # such as d2 where joint 2 slides
                left_out.append(place)
        return named, left_out

    def _compared(self) -> str:
        arm, q = self._arm, self.q
        reading = other_reading(arm, q)
        still = worker.png(arm_scene(reading.numbers), q, "3-D", ("frames", "labels"))
        picture = base64.b64encode(still).decode()
        at = joints_text(arm, [joint.value for joint in self.joints])
        return compared_html(arm, reading, at, picture)


def _is_odd(link: Link) -> int:
    """How many angles of a row are no multiples of 90°."""
    parts = map(plain_angle, (link.theta, link.alpha))
    return sum(part is None or (2 * part).denominator != 1 for part in parts)


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


def _joints(table: DHTable) -> list[Row]:
    """The rows that move, one for each value in q."""
    return [row for row in table.rows if row.variable]


def _texts(table: DHTable) -> dict[str, str]:
    """The table in all formats; as code while all cells can be read."""
    return {"csv": to_csv(table), "markdown": to_markdown(table), "latex": to_latex(table),
            "code": to_code(table) if table.arm else ""}


def _question(asked: _Asked | None) -> dict | None:
    """A question for the browser: its words, and those of its answers."""
    if asked is None:
        return None
    return {"text": asked.question.question,
            "options": [label for label, _ in asked.question.options]}


def _alike(a: Arm, b: Arm) -> bool:
    words = [(arm.links, arm.convention, arm.name, arm.unit) for arm in (a, b)]
    return words[0] == words[1] and all(
        np.array_equal(getattr(a, part), getattr(b, part)) for part in ("base", "tool", "home"))
