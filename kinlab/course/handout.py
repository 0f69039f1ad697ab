"""The lessons on their way to a student: found, copied, opened in JupyterLab."""
from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path

_HERE = Path(__file__).resolve().parent
CARRIED = _HERE / "lessons"  # in a wheel; pyproject.toml puts notebooks/ there
FOLDER = CARRIED if CARRIED.is_dir() else _HERE.parents[1] / "notebooks"
FIRST = "00_start_here.ipynb"
# What a verb needs besides what kinlab itself does; pyproject.toml has the same extras.
EXTRAS = {"lab": ("jupyterlab",), "site": ("nbconvert", "ipykernel"),
          "lite": ("jupyterlite_core", "jupyterlite_pyodide_kernel", "jupyter_server", "nbformat")}


def all_notebooks() -> list[Path]:
    """Every notebook of the course, JupyterLab's own checkpoints aside."""
    return sorted(path for path in FOLDER.rglob("*.ipynb")
                  if ".ipynb_checkpoints" not in path.parts)


def copy_lessons(folder: Path) -> tuple[list[str], list[str]]:
    """Copy the lessons into a folder; a file that is there may be a student's work and stays.

    Returns
    -------
    copied, kept : list of str
        Names within the folder.

    Raises
    ------
    ValueError
        If the folder cannot be made, or not be written to.
    """
    told: tuple[list[str], list[str]] = [], []
    with writing("FOLDER", folder):
        for source in all_notebooks():
            name = source.relative_to(FOLDER)
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            told[not _copy(source, folder / name)].append(name.as_posix())
    return told


def _copy(source: Path, target: Path) -> bool:
    """Copy a file, unless something of that name is there."""
    text = source.read_bytes()
    try:
        new = target.open("xb")
    except FileExistsError:
        return False
    try:
        with new:
            new.write(text)
    except OSError:
        target.unlink()  # half a lesson would be kept for ever
        raise
    return True


@contextmanager
def writing(argument: str, folder: Path) -> Iterator[None]:
    """Say in a sentence why a folder that somebody named cannot be written to."""
    try:
        yield
    except OSError as error:
        raise ValueError(f"{argument}: cannot make the folder {str(folder)!r} or write to it "
                         f"({error.strerror}); choose another name") from None


def open_lab(folder: Path) -> int:
    """Open the first lesson in JupyterLab, until it is stopped; 1 if it is not installed."""
    if lacking := not_installed("lab"):
        print(f"The lessons are not opened: {lacking}", file=sys.stderr)
        return 1
    from jupyterlab.labapp import LabApp

    LabApp.launch_instance([str((folder / FIRST).resolve())])
    return 0


def not_installed(extra: str) -> str:
    """Which packages of an extra are not there and how to install them; "" if all are."""
    lacking = [name for name in EXTRAS[extra] if not find_spec(name)]
    if not lacking:
        return ""
    return (f"{' and '.join(lacking)} {'are' if lacking[1:] else 'is'} not installed; run\n"
            f"    {sys.executable} -m pip install {' '.join(lacking)}\nand then this again.")
