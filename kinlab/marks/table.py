"""The reports of a class in one table, as CSV. Nothing in a file is ever run."""
from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from .report import Report, load

_ALWAYS = ("file", "name", "written", "trusted", "why not", "solved", "tried", "predicted", "right")
_FORMULA = ("=", "+", "-", "@", "\t", "\r")  # what a spreadsheet takes for a formula


@dataclass(frozen=True)
class Collected:
    """The reports of a folder, and the files that are none with the reason."""

    reports: tuple[Report, ...]
    others: tuple[tuple[Path, str], ...]

    @property
    def doubtful(self) -> list[tuple[Path, str]]:
        """Each file that cannot be trusted, and why."""
        return [*((report.path or Path(), "; ".join(report.doubts)) for report in self.reports
                  if report.doubts), *self.others]


def collect(folder: Path, exercises: Sequence[str]) -> Collected:
    """All reports in a folder and in those within it.

    Parameters
    ----------
    folder : path
    exercises : sequence of str
        The names there are: a report that holds others is of another course.
    """
    if not folder.is_dir():
        raise ValueError(f"FOLDER: there is no folder {str(folder)!r}; give the one that holds "
                         "your students' files")
    reports, others = [], []
    for path in sorted(folder.rglob("*.json")):
        if ".ipynb_checkpoints" in path.parts or not path.is_file():
            continue
        try:
            reports.append(load(path))
        except ValueError as error:
            others.append((path, str(error)))
    if not reports and not others:
        raise ValueError(f"FOLDER: there is no .json file in {str(folder)!r}; students write one "
                         "with kl.exercises.report()")
    return Collected(tuple(_doubted(_unknown(report, exercises), reports) for report in reports),
                     tuple(others))


def _unknown(report: Report, exercises: Sequence[str]) -> Report:
    """With a doubt, if it holds exercises that there are not."""
    beyond = sorted(set(report.work.tries) - set(exercises))
    return replace(report, doubts=(*report.doubts, "other version: it holds exercises that this "
                                   f"one has not: {', '.join(beyond[:3])}")) if beyond else report


def _doubted(report: Report, all_of_them: Iterable[Report]) -> Report:
    """With a doubt, if it is an older copy, or somebody else has handed in the same work."""
    twins = [other for other in all_of_them if other.path != report.path
             and set(other.sessions) & set(report.sessions)]
    later = [other for other in twins if other.name == report.name
             and (other.written, str(other.path)) > (report.written, str(report.path))]
    others = [other for other in twins if other.name != report.name]
    said = ([f"handed in again, later: {_files(later)}"] if later else []) + (
        [f"the same work as somebody else's: {_files(others)}"] if others else [])
    return replace(report, doubts=(*report.doubts, *said))


def _files(reports: Sequence[Report]) -> str:
    names = [report.path.name for report in reports if report.path]
    return ", ".join(names[:3]) + (" and more" if len(names) > 3 else "")


def as_csv(collected: Collected, exercises: Sequence[str], folder: Path) -> str:
    """The table: a row for each file, a column for each exercise (1 solved, 0 tried)."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\r\n")  # as CSV has it
    rows.writerow([*_ALWAYS, *exercises])
    for row in _rows(collected, exercises, folder):
        rows.writerow([_harmless(cell) for cell in row])
    return text.getvalue()


def save(text: str, path: Path) -> None:
    """Write the table so that a spreadsheet reads its letters right."""
    try:
        path.write_bytes(b"\xef\xbb\xbf" + text.encode("utf-8", "replace"))
    except OSError as error:
        raise ValueError(f"--out: cannot write {str(path)!r} ({error.strerror}); choose a folder "
                         "of your own, or another name") from None


def _rows(collected: Collected, exercises: Sequence[str],
          folder: Path) -> Iterator[list[str | int]]:
    for report in sorted(collected.reports, key=lambda report: report.name.casefold()):
        work, path = report.work, report.path or Path()
        answers = [ok for cases in work.predicted.values() for ok in cases.values()]
        yield [str(path.relative_to(folder)), report.name, report.written,
               "no" if report.doubts else "yes", "; ".join(report.doubts), len(work.solved),
               len(set(work.tries) - set(work.solved)), len(answers), sum(answers),
               *(1 if name in work.solved else 0 if name in work.tries else ""
                 for name in exercises)]
    for path, why in collected.others:
        yield [str(path.relative_to(folder)), "", "", "no", why, *[""] * (4 + len(exercises))]


def _harmless(cell: str | int) -> str | int:
    """A text that a spreadsheet shows and does not calculate."""
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(_FORMULA) else cell
