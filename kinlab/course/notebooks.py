"""Regenerate the outputs of the notebooks, or say which ones would differ.

Each notebook runs in a fresh kernel. What would change from run to run is not saved: the ids of
widgets (the picture and the text of a live view stay) and the times of execution.
"""
from __future__ import annotations

import sys
from collections.abc import Sequence
from copy import deepcopy
from pathlib import Path

import nbformat
from nbclient import NotebookClient

from .handout import CARRIED, FOLDER, all_notebooks

CELL_SECONDS = 120
QUIET = "--log-level=40"  # errors only: a kernel's remarks would stand in the line of the progress
WIDGET = "application/vnd.jupyter.widget-view+json"
METADATA = {"kernelspec": {"display_name": "Python 3 (ipykernel)", "language": "python",
                           "name": "python3"},
            "language_info": {"name": "python"}}


def run(notebook: nbformat.NotebookNode, progress: bool = False) -> nbformat.NotebookNode:
    """The notebook with the outputs and execution counts of a fresh kernel.

    Raises
    ------
    nbclient.exceptions.CellExecutionError
        If a cell raises an exception or takes longer than two minutes.
    """
    fresh = deepcopy(notebook)
    total = len(fresh.cells)

    def show(cell: nbformat.NotebookNode, cell_index: int) -> None:
        print(f"\r  cell {cell_index + 1} of {total}", end="", file=sys.stderr, flush=True)

    NotebookClient(fresh, timeout=CELL_SECONDS, kernel_name="python3", record_timing=False,
                   store_widget_state=False, extra_arguments=[QUIET],
                   resources={"metadata": {"path": str(FOLDER)}},
                   on_cell_start=show if progress else None).execute()
    return steady(fresh)


def steady(notebook: nbformat.NotebookNode) -> nbformat.NotebookNode:
    """The notebook without what changes from run to run or from machine to machine."""
    notebook.metadata = nbformat.from_dict(METADATA)
    for output in _outputs(notebook):
        output.get("data", {}).pop(WIDGET, None)
    for cell in notebook.cells:
        if "outputs" in cell:  # of a progress bar nothing is left but its empty place
            cell.outputs = [output for output in cell.outputs if output.get("data", True)]
    return notebook


def differs(saved: nbformat.NotebookNode, fresh: nbformat.NotebookNode) -> bool:
    """True if the two would not be the same file, pictures aside.

    The bytes of a picture depend on the machine's fonts; its text beside it is compared.
    """
    return _without_pictures(saved) != _without_pictures(fresh)


def _outputs(notebook: nbformat.NotebookNode) -> list[nbformat.NotebookNode]:
    return [output for cell in notebook.cells for output in cell.get("outputs", ())]


def _without_pictures(notebook: nbformat.NotebookNode) -> nbformat.NotebookNode:
    bare = deepcopy(notebook)
    for output in _outputs(bare):
        output.get("data", {}).pop("image/png", None)
    return bare


def refresh(paths: Sequence[Path] = (), *, check: bool = False) -> bool:
    """Run notebooks, all of the course if none is named, and save them or only report.

    Returns
    -------
    bool
        True if only reporting and a notebook would differ.

    Raises
    ------
    ValueError
        If there is no such notebook, or if those of an installed kinlab would be written over.
    """
    for path in paths:
        if not path.is_file():
            raise ValueError(f"PATHS: there is no notebook {str(path)!r}; name .ipynb files")
    if not (paths or check) and FOLDER == CARRIED:
        raise ValueError("PATHS: name the notebooks to run; kinlab's own stay as they came")
    return sum(_refresh(path, check) for path in paths or all_notebooks()) > 0


def _refresh(path: Path, check: bool) -> bool:
    print(path.name, file=sys.stderr)
    try:
        saved = nbformat.read(path, as_version=4)
    except (ValueError, nbformat.ValidationError):
        raise ValueError(f"PATHS: {str(path)!r} is not a notebook; name .ipynb files") from None
    fresh = run(saved, progress=True)
    changed = differs(saved, fresh)
    if not check:
        try:
            nbformat.write(fresh, path)
        except OSError as error:
            raise ValueError(f"PATHS: cannot write {str(path)!r} ({error.strerror})") from None
    word = ("differs" if check else "updated") if changed else "unchanged"
    print(f"\r  {word}{' ' * 20}", file=sys.stderr)
    return changed and check
