"""One student's report: a small file for people to read, sealed so that an edit shows.

The seal is a checksum. It tells a file that was edited by hand from one that was not; it is no
secret, and who reads this source can make one. A file is only ever read as data.
"""
from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field
from hashlib import sha256
from html import escape
from pathlib import Path
from typing import Any

from .. import __version__
from ..arms import files, inputs
from .record import Session, Work, now, time_of, together

FILE = "kinlab_report.json"
EDITED = "edited by hand: its seal does not fit what it says"
_FORMAT = 1
_MOST = 1_000_000  # bytes; a whole course takes about ten thousand
_LONGEST = 200     # letters of a name


@dataclass(frozen=True)
class Report:
    """What somebody has solved, tried and predicted.

    Attributes
    ----------
    name : str
        Whose it is.
    sessions : {key: Session}
        What each kernel has seen.
    written : str
        When, in UTC.
    formerly : tuple of str
        Other names that it had.
    edited : bool
        Whether its file says anything else than what was written.
    path : Path, optional
        Where it is kept.
    """

    name: str
    sessions: Mapping[str, Session]
    written: str = field(default_factory=now)
    formerly: tuple[str, ...] = ()
    edited: bool = False
    path: Path | None = None

    @property
    def work(self) -> Work:
        """All sessions together."""
        in_order = sorted(self.sessions.values(), key=lambda session: session.began)
        return together(session.work for session in in_order)

    @property
    def doubts(self) -> list[str]:
        """Why it cannot be trusted; empty if it can."""
        others = sorted({one.version for one in self.sessions.values()} - {__version__})
        return ([EDITED] if self.edited else []) + (
            [f"other version: made with kinlab {', '.join(others)}, and this is {__version__}"]
            if others else []) + (
            [f"its name was another one before: {', '.join(self.formerly)}"]
            if self.formerly else [])

    def lines(self) -> list[list[str]]:
        """A heading, and for each lesson what was solved, tried and predicted."""
        work = self.work
        lessons = dict.fromkeys(map(_lesson_of, (*work.tries, *work.predicted)))
        return [["Lesson", "Solved", "Tried", "Predictions right"],
                *(_line(lesson, work) for lesson in lessons)]

    def __repr__(self) -> str:
        rows = self.lines()
        wide = [max(map(len, column)) for column in zip(*rows)]
        table = ["  ".join(cell.ljust(width) for cell, width in zip(row, wide)).rstrip()
                 for row in rows]
        return "\n".join([self._title(), *(table if len(rows) > 1 else [
            "Nothing yet. Run the checks and predictions of a lesson first."])])

    def _repr_html_(self) -> str:
        head, *rows = ["".join(f'<td style="text-align: left">{escape(cell)}</td>' for cell in row)
                       for row in self.lines()]
        body = "".join(f"<tr>{row}</tr>" for row in rows)
        return (f"<p>{escape(self._title())}</p>"
                f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>")

    def _title(self) -> str:
        before = f", until now that of {self.formerly[-1]}" if self.formerly else ""
        where = f", kept in {self.path}" if self.path else ""
        return f"Report of {self.name or 'somebody without a name'}{before}{where}"


def _lesson_of(name: str) -> str:
    return name.partition(".")[0]


def _line(lesson: str, work: Work) -> list[str]:
    answers = [ok for name, cases in work.predicted.items() if _lesson_of(name) == lesson
               for ok in cases.values()]
    return [lesson, _numbers(lesson, work.solved), _numbers(lesson, work.unsolved),
            f"{sum(answers)} of {len(answers)}" if answers else ""]


def _numbers(lesson: str, names: Iterable[str]) -> str:
    """The numbers of a lesson's exercises, and of variants with their seeds: "2, 3 (Ada)"."""
    own = (name.partition(".")[2].partition(" ") for name in sorted(names)
           if _lesson_of(name) == lesson)
    return ", ".join(f"{number} ({seed})" if seed else number for number, _, seed in own)


def write(report: Report, path: Path) -> None:
    """Write it as JSON, which stays the same however its lines are broken."""
    told = {"kinlab report": _FORMAT, "name": report.name, "formerly": list(report.formerly),
            "written": report.written,
            "sessions": {key: asdict(one) for key, one in report.sessions.items()}}
    text = json.dumps(told | {"seal": _seal(told)}, indent=1, ensure_ascii=False)
    files.write("path", path, f"{text}\n".encode())


def read(path: Path) -> Report:
    """A report out of its file; ValueError says why it is none."""
    told = _json(path)
    if not isinstance(told, dict) or "kinlab report" not in told:
        raise ValueError("it is no report of kinlab")
    if told["kinlab report"] != _FORMAT:
        raise ValueError(f"it was written by another kinlab than this one, {__version__}")
    seal = told.pop("seal", None)
    try:
        return Report(_name(told["name"]), {key: Session.of(one) for key, one in
                                            told["sessions"].items()}, time_of(told["written"]),
                      tuple(map(_name, told["formerly"])), seal != _seal(told), path)
    except (ValueError, KeyError, TypeError, AttributeError):
        raise ValueError("edited by hand: a part of it is missing, or no part of a report"
                         ) from None


def _json(path: Path) -> Any:
    try:
        size, text = path.stat().st_size, b""
        if size <= _MOST:
            text = path.read_bytes()
    except OSError as error:
        raise ValueError(f"it cannot be read ({error.strerror})") from None
    if size > _MOST:
        raise ValueError("it is too large for a report")
    try:
        return json.loads(text.decode("utf-8-sig"))
    except (ValueError, RecursionError):  # of letters, of JSON, of a number without an end
        raise ValueError("it is no JSON, or damaged") from None


def _name(name: Any) -> str:
    return inputs.line("name", name)[:_LONGEST]


def _seal(told: Mapping[str, Any]) -> str:
    text = json.dumps(told, sort_keys=True, separators=(",", ":"))
    return sha256(f"kinlab report {text}".encode()).hexdigest()


def who() -> str:
    """The name of whoever is logged in, on a hub or here; "" where nobody is."""
    import getpass

    if named := os.environ.get("JUPYTERHUB_USER"):
        return named
    try:
        return getpass.getuser()
    except (OSError, KeyError, ImportError):  # in a browser there are no users
        return ""
