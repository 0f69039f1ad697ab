"""What a DH table's editor shows: its state for the browser, its text, and its panels."""
from __future__ import annotations

from collections.abc import Iterable
from html import escape

import numpy as np

from ..arms import printed
from ..arms.arm import CONVENTIONS, Arm
from ..arms.link import PARAMETERS
from ..tables.cells import MILLIMETRES, angle_text, is_plain
from ..tables.ends import ENDS, TURNS, End
from ..tables.numbers import in_python, names_in
from ..tables.other_convention import OtherReading, frame_text
from ..tables.table import LIMITS, RATES, DHTable, Place, Row

_PER = {"speed": "/s", "acceleration": "/s²"}


def state(table: DHTable) -> dict:
    units = [table.unit] if table.unit not in MILLIMETRES else list(
        dict.fromkeys(["mm", "m", table.unit]))
    joints = printed.joint_numbers(table.rows)
    rates = [rate for rate in RATES if any(getattr(row, rate) for row in table.rows)]
    return {
        "convention": table.convention, "conventions": list(CONVENTIONS), "angles": table.angles,
        "unit": table.unit, "units": units, "ends": {end: _end(table, end) for end in ENDS},
        "columns": list(printed.HEADS[table.convention]),
        "rows": [_row(table, row, i, joint, rates)
                 for i, (row, joint) in enumerate(zip(table.rows, joints), start=1)],
        "lengths": [{"name": name, "text": text, "error": table.errors.get(Place(k, "length"), "")}
                    for k, (name, text) in enumerate(table.lengths, start=1)],
        "wrong": len(table.errors)}


def _row(table: DHTable, row: Row, i: int, joint: int, rates: list[str]) -> dict:
    low, high = (table.values.get(Place(i, column)) for column in ("low", "high"))
    has_limits = row.variable or any(getattr(row, column) for column in LIMITS)
    columns = [*PARAMETERS, *(LIMITS if has_limits else ()), *(
        rate for rate in rates if row.variable or getattr(row, rate))]
    return {"key": row.key, "kind": row.kind, "variable": row.variable, "name": row.name,
            "joint": joint, "flip": row.flip, "locked": low is not None and low == high,
            "cells": {column: _cell(table, Place(i, column), getattr(row, column),
                                    row.is_angle(column)) for column in columns}}


def _end(table: DHTable, end: str) -> dict | None:
    """The base or the tool: how it is typed, and its cells."""
    frame: End | None = getattr(table, end)
    if frame is None:
        return None
    return {"form": frame.form, "cells": {
        column: _cell(table, Place(end, column), text, column in TURNS)
        for column, text in frame.cells(table.angles).items()}}


def _cell(table: DHTable, place: Place, text: str, angle: bool) -> dict:
    value, per = table.values.get(place), _PER.get(place.column, "")
    unit = (table.angles if angle else table.unit) + per
    said = is_plain(text) and not (angle and table.angles == "rad" and value)
    reads = ""
    if value is not None and text and not said:
        reads = (f"{float(angle_text(value, 'deg')):.5g}°" if angle else f"{value:.5g}") + per
    return {"text": text, "error": table.errors.get(place, ""), "reads": reads,
            "hint": table.hints.get(place, ""), "unit": unit}


def table_text(table: DHTable) -> list[list[str]]:
    heads, joints = printed.HEADS[table.convention], printed.joint_numbers(table.rows)
    return [["i", "joint", *heads.values()]] + [
        [str(i), row.kind, *(_starred(row, column, joint) for column in heads)]
        for i, (row, joint) in enumerate(zip(table.rows, joints), start=1)]


def _starred(row: Row, column: str, joint: int) -> str:
    text, letter = getattr(row, column), "θ" if column == "theta" else column
    return f"{'-' * row.flip}{letter}{joint}* {text}" if column == row.variable else text


def lengths_text(table: DHTable) -> list[str]:
    pairs = ", ".join(f"{name} = {text}" for name, text in table.lengths)
    return [f"with {pairs}"] if pairs else []


def ends_text(table: DHTable) -> list[str]:
    """What changes at the ends, as typed; a frame that changes nothing is left out."""
    return [f"{end}: " + ", ".join(f"{column} {text}" for column, text in changed.items())
            for end in ENDS if (frame := getattr(table, end)) and (changed := {
                column: text for column, text in frame.cells(table.angles).items()
                if text != "0"})]


def reasons(table: DHTable) -> list[str]:
    return [f"{_where(place)}: {reason}" for place, reason in table.errors.items()]


def hints(table: DHTable) -> list[str]:
    return [f"{_where(place)}: {hint}" for place, hint in table.hints.items()]


def _where(place: Place) -> str:
    if place.column == "length":
        return f"Length {place.row}"
    return f"{place.row.capitalize() if place.row in ENDS else f'Row {place.row}'}, {place.column}"


def named_cells(table: DHTable) -> dict[Place, str]:
    """The texts of the lengths that name others, as Python spells them.

    Examples
    --------
    >>> named_cells(DHTable((Row(a="2*L1", d="3"),), lengths=(("L1", "0.5"),)))
    {Place(row=1, column='a'): '2 * L1'}
    """
    names = {name: table.values[Place(k, "length")] for k, (name, _)
             in enumerate(table.lengths, start=1) if Place(k, "length") in table.values}
    texts = {Place(i, column): getattr(row, column) for i, row in enumerate(table.rows, start=1)
             for column in ("d", "a")}
    return {place: in_python(text, names) for place, text in texts.items()
            if place in table.values and names_in(text) & names.keys()}


def lengths_in(table: DHTable, texts: Iterable[str]) -> dict[str, float]:
    """The named lengths of a table that stand in some texts."""
    used = set().union(*map(names_in, texts))
    return {name: table.values[Place(k, "length")]
            for k, (name, _) in enumerate(table.lengths, start=1) if name in used}


def left_out_text(places: list[Place]) -> str:
    """Which names do not stand in a formula; "" if all do."""
    where = ", ".join(map(_where, places))
    return where and (f"{where}: the text does not stand in the formula, where a name of it means "
                      "something else, or does not say its value.")


def signs_html(arm: Arm) -> str:
    signs = printed.html(printed.sign_rows(arm.links), '<table aria-label="Signs">')
    return (f'<div class="kl-signs">{signs}<div>'
            "<p>The signs of the table's numbers; "
            "* marks the joint variable, a sign behind it its offset.</p>"
            "<p>Right tables of one arm may differ in signs: a z axis that points the other way "
            "changes the signs of α beside it.</p></div></div>")


def compared_html(arm: Arm, reading: OtherReading, at: str, png: str) -> str:
    """What the same numbers are in the other convention, and how the same arm is written there."""
    other = reading.numbers.convention
    verdict = ("Both readings are the same mechanism." if reading.same else
               f"Read as {other} DH, these numbers are another mechanism.")
    moved = "".join(f"<li>{escape(text)}</li>" for text in reading.moved)
    where = f"<p>At q = {escape(at)}:</p><ul>{moved}</ul>" if moved else ""
    ends = "".join(f"<p>The {end} frame is {escape(frame_text(T, arm.unit))}.</p>"
                   for end in ("base", "tool")
                   if not np.array_equal(T := getattr(reading.converted, end), np.eye(4)))
    return (f'<div class="kl-compare"><section><h4>The same numbers, read as {other}</h4>'
            f"<p>{verdict}</p>{where}</section>"
            f'<img alt="The arm that the same numbers describe as {other} DH" '
            f'src="data:image/png;base64,{png}">'
            f"<section><h4>The same arm, written as {other}</h4>"
            f"{reading.converted._repr_html_()}{ends}</section></div>")
