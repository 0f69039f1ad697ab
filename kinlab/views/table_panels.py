"""What a DH table's editor shows: its state for the browser, its text, and its panels."""
from __future__ import annotations

from html import escape

import numpy as np

from ..arms import printed
from ..arms.arm import CONVENTIONS, Arm
from ..tables.as_csv import to_csv
from ..tables.cells import MILLIMETRES, angle_text, is_plain
from ..tables.ends import ENDS
from ..tables.other_convention import OtherReading, frame_text
from ..tables.table import COLUMNS, DHTable, Place, Row


def state(table: DHTable) -> dict:
    ends = {end: frame_text(T, table.unit) if (T := table.end(end)) is not None else ""
            for end in ENDS}
    units = [table.unit] if table.unit not in MILLIMETRES else list(
        dict.fromkeys(["mm", "m", table.unit]))
    return {
        "convention": table.convention, "conventions": list(CONVENTIONS), "angles": table.angles,
        "unit": table.unit, "units": units, "ends": ends,
        "columns": list(printed.HEADS[table.convention]),
        "rows": [{"key": row.key, "kind": row.kind, "variable": row.variable, "name": row.name,
                  "cells": {column: _cell(table, i, row, column) for column in COLUMNS}}
                 for i, row in enumerate(table.rows, start=1)],
        "lengths": [{"name": name, "text": text, "error": table.errors.get(Place(k, "length"), "")}
                    for k, (name, text) in enumerate(table.lengths, start=1)],
        "wrong": len(table.errors), "csv": to_csv(table)}


def _cell(table: DHTable, i: int, row: Row, column: str) -> dict:
    text, place = getattr(row, column), Place(i, column)
    value, angle = table.values.get(place), row.is_angle(column)
    said = is_plain(text) and not (angle and table.angles == "rad" and value)
    reads = ""
    if value is not None and text and not said:
        reads = f"{float(angle_text(value, 'deg')):.5g}°" if angle else f"{value:.5g}"
    return {"text": text, "error": table.errors.get(place, ""), "reads": reads,
            "unit": table.angles if angle else table.unit}


def table_text(table: DHTable) -> list[list[str]]:
    heads = printed.HEADS[table.convention]
    return [["i", "joint", *heads.values()]] + [
        [str(i), row.kind, *(_starred(row, column, i) for column in heads)]
        for i, row in enumerate(table.rows, start=1)]


def _starred(row: Row, column: str, i: int) -> str:
    letter = "θ" if column == "theta" else column
    return f"{letter}{i}* {getattr(row, column)}" if column == row.variable \
        else getattr(row, column)


def lengths_text(table: DHTable) -> list[str]:
    pairs = ", ".join(f"{name} = {text}" for name, text in table.lengths)
    return [f"with {pairs}"] if pairs else []


def reasons(table: DHTable) -> list[str]:
    return [f"Length {place.row}: {reason}" if place.column == "length"
            else f"Row {place.row}, {place.column}: {reason}"
            for place, reason in table.errors.items()]


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
