"""The course from the command line: ``python -m kinlab``, or ``kinlab`` where it is installed."""
from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from textwrap import fill

from . import __version__


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; its exit status, 0 if all went well."""
    parser = _parser()
    options = parser.parse_args(arguments)
    try:
        return options.run(options)
    except ValueError as error:
        parser.exit(2, f"kinlab: {error}\n")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="kinlab", description="The lessons of kinlab. 'kinlab VERB --help' says more of each.")
    parser.add_argument("--version", action="version", version=f"kinlab {__version__}")
    parser.set_defaults(run=lambda options: parser.exit(2, parser.format_help()))
    verbs = parser.add_subparsers(title="verbs", metavar="VERB")

    def verb(run: Callable[[argparse.Namespace], int]) -> argparse.ArgumentParser:
        about = str(run.__doc__)
        made = verbs.add_parser(run.__name__.strip("_"), description=about,
                                help=about.partition(".")[0])
        made.set_defaults(run=run)
        return made

    lessons = verb(_lessons)
    lessons.add_argument("folder", metavar="FOLDER", type=Path, nargs="?",
                         default=Path("kinlab_lessons"),
                         help="where the copies go; default: %(default)s, in this folder")
    lessons.add_argument("--copy-only", action="store_true", help="do not open JupyterLab")
    verb(_site).add_argument("out", metavar="OUT", type=Path, help="the folder for the pages")
    lite = verb(_lite)
    lite.add_argument("out", metavar="OUT", type=Path, help="the folder for the site")
    lite.add_argument("--pyodide", metavar="FOLDER", type=Path,
                      help="a folder with Pyodide 0.27, for places without a network; "
                           "without it, browsers load Pyodide from its public address")
    marks = verb(_marks)
    marks.add_argument("folder", metavar="FOLDER", type=Path, help="the folder with the files")
    marks.add_argument("--out", metavar="FILE", type=Path,
                       help="where the table goes, a new file; default: marks.csv, here")
    notebooks = verb(_notebooks)
    notebooks.add_argument("--check", action="store_true",
                           help="write nothing; fail if a notebook would change")
    notebooks.add_argument("paths", metavar="PATHS", type=Path, nargs="*",
                           help="default: all in notebooks/")
    return parser


def _lessons(options: argparse.Namespace) -> int:
    """Copy the lessons into a folder and open them in JupyterLab. A file that is there already
    stays as it is. For a fresh copy of a lesson, give yours another name and run this again.
    """
    from .course import handout

    copied, kept = handout.copy_lessons(options.folder)
    print(f"The lessons are in {options.folder.resolve()}")
    for word, names in (("Copied", copied), ("Kept as they are", kept)):
        if names:
            print(fill(f"{word}: {_listed(names)}", 80, subsequent_indent="  "))
    return 0 if options.copy_only else handout.open_lab(options.folder)


def _listed(names: Sequence[str]) -> str:
    lessons = [name.removesuffix(".ipynb") for name in names if "/" not in name]
    solutions = len(names) - len(lessons)
    return ", ".join([*lessons, *[f"{solutions} in solutions"] * (solutions > 0)])


def _site(options: argparse.Namespace) -> int:
    """Turn the lessons into pages that move. Open OUT/index.html, or put the folder on any web
    server. Older files of the same names are replaced.
    """
    _need("site")
    from .course import site

    site.build(options.out, progress=True)
    return 0


def _need(extra: str) -> None:
    """Stop with a sentence if what a verb needs is not installed."""
    from .course.handout import not_installed

    if lacking := not_installed(extra):
        raise ValueError(lacking)


def _lite(options: argparse.Namespace) -> int:
    """Turn the lessons into notebooks that run in a browser, with nothing to install. Put OUT on
    any web server; it may hold the pages of 'kinlab site', which then lead to the notebooks.
    """
    _need("lite")
    from .course import lite

    lite.build(options.out, options.pyodide, tell=lambda line: print(line, file=sys.stderr))
    return 0


def _marks(options: argparse.Namespace) -> int:
    """Collect a class's reports into one table (CSV). Students write a report with
    kl.exercises.report(). Says which files cannot be trusted, and why. Runs none of them.
    """
    from . import lessons
    from .marks import table

    exercises, out = lessons.exercises(), options.out or Path("marks.csv")
    rows = table.collect(options.folder, exercises, lessons.predictions_asked())
    table.write(table.as_csv(rows, exercises), out)
    print(f"{len(rows)} files in {out}")
    for row in rows:
        for words, said in (("Not to be trusted", row.doubts), ("Note", row.remarks)):
            if said:
                print(fill(f"{words}: {row.file}: {'; '.join(said)}", 100, subsequent_indent="  "))
    return 0


def _notebooks(options: argparse.Namespace) -> int:
    """Run notebooks afresh and save their outputs. Says which of them changed."""
    _need("site")
    from .course import notebooks

    return notebooks.refresh(options.paths, check=options.check)


if __name__ == "__main__":
    sys.exit(main())
