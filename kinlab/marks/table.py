"""The reports of a class in one table, as CSV. Nothing in a file is ever run."""
from __future__ import annotations

import csv
import io
import os
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from pathlib import Path

from ..arms import files
from .report import Report, read

_ALWAYS = ("file", "name", "written", "trusted", "remarks", "solved", "tried", "predicted", "right",
           "variants solved")
_FORMULA = ("=", "+", "-", "@", "\t", "\r")  # what a spreadsheet takes for a formula


@dataclass(frozen=True)
class Row:
    """One file of a folder: its report, or none, why it cannot be trusted, and what else to know.

    `file` is its path within the folder.
    """

    file: str
    report: Report | None
    doubts: tuple[str, ...]
    remarks: tuple[str, ...] = ()


def collect(folder: Path, exercises: Collection[str], predictions: Collection[str]) -> list[Row]:
    """All reports in a folder and in those within it, by the names of their students.

    Parameters
    ----------
    folder : path
    exercises, predictions : names
        Those that there are: a report that holds others is of another course.
    """
    if not folder.is_dir():
        raise ValueError(f"FOLDER: there is no folder {str(folder)!r}; give the one that holds "
                         "your students' files")
    reports: dict[str, Report] = {}
    rows = []
    for path in _files(folder):
        file = str(path.relative_to(folder))
        try:
            reports[file] = read(path)
        except ValueError as error:
            rows.append(Row(file, None, (str(error),)))
    if not reports and not rows:
        raise ValueError(f"FOLDER: there is no .json file in {str(folder)!r}; students write one "
                         "with kl.exercises.report()")
    known = {*exercises, *predictions}
    return [*(_row(file, reports, known) for file in
              sorted(reports, key=lambda file: (reports[file].name.casefold(), file))), *rows]


def _files(folder: Path) -> list[Path]:
    """What may be a report, whatever a mail program has made of its name; no checkpoints."""
    return [path for path in sorted(folder.rglob("*")) if ".json" in path.name.lower()
            and ".ipynb_checkpoints" not in path.parts and not path.is_dir()]


def _row(file: str, reports: dict[str, Report], known: Collection[str]) -> Row:
    report, others = reports[file], {name: one for name, one in reports.items() if name != file}
    mine = {name: one for name, one in others.items() if one.name == report.name}
    twins = [name for name, one in others.items() if set(one.sessions) & set(report.sessions)]
    later = [name for name in twins if name in mine and not mine[name].edited
             and (mine[name].written, name) > (report.written, file)]
    doubts = [*report.doubts, *_unknown(report, known),
              *_with_files("handed in again, later", later),
              *_with_files("the same work as somebody else's",
                           [name for name in twins if name not in mine])]
    return Row(file, report, tuple(doubts), tuple(_with_files(
        "another file has this name, too", [name for name in mine if name not in later])))


def _unknown(report: Report, known: Collection[str]) -> list[str]:
    done = {name.partition(" ")[0] for name in (*report.work.tries, *report.work.predicted)}
    beyond = sorted(done - set(known))
    return [f"other version: it holds what this one does not ask: {', '.join(beyond[:3])}"
            ] if beyond else []


def _with_files(words: str, files: Sequence[str]) -> list[str]:
    more = " and more" if len(files) > 3 else ""
    return [f"{words}: {', '.join(files[:3])}{more}"] if files else []


def as_csv(rows: Sequence[Row], exercises: Sequence[str]) -> str:
    """The table: a row for each file, a column for each exercise (1 solved, 0 tried)."""
    text = io.StringIO()
    out = csv.writer(text, lineterminator="\r\n")  # as CSV has it
    out.writerow([*_ALWAYS, *exercises])
    for row in rows:
        out.writerow([_harmless(cell) for cell in _cells(row, exercises)])
    return text.getvalue()


def _cells(row: Row, exercises: Sequence[str]) -> list[str | int]:
    said = "; ".join([*row.doubts, *row.remarks])
    if row.report is None:
        return [row.file, "", "", "no", said, *[""] * (len(_ALWAYS) - 5 + len(exercises))]
    work = row.report.work
    variants = sorted(name for name in work.solved if " " in name)
    return [row.file, row.report.name, row.report.written, "no" if row.doubts else "yes", said,
            len(set(work.solved) - set(variants)),
            len([name for name in work.unsolved if " " not in name]),
            len(work.first_answers), sum(work.first_answers), "; ".join(variants),
            *(1 if name in work.solved else 0 if name in work.tries else "" for name in exercises)]


def write(text: str, path: Path) -> None:
    """Write the table so that a spreadsheet reads its letters right; never over another file."""
    target = files.target("--out", path, (".csv",), "spreadsheets open a table by its ending")
    if os.path.lexists(target):
        raise ValueError(f"--out: {str(path)!r} is there already and stays as it is; take it away, "
                         "or give another name with --out")
    files.write("--out", target, text.encode("utf-8-sig", "replace"))


def _harmless(cell: str | int) -> str | int:
    """A text that a spreadsheet shows and does not calculate."""
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(_FORMULA) else cell
