"""Regenerate the outputs of the notebooks, or say which ones would differ.

    python -m kinlab.course.notebooks                  run every notebook in notebooks/ and save it
    python -m kinlab.course.notebooks --check          only report; fails if one would differ
    python -m kinlab.course.notebooks notebooks/x.ipynb

Each notebook runs in a fresh kernel. What would change from run to run is not saved: the ids of
widgets (the picture and the text of a live view stay) and the times of execution.
"""
from __future__ import annotations

import argparse
import sys
from copy import deepcopy
from pathlib import Path

import nbformat
from nbclient import NotebookClient

FOLDER = Path(__file__).resolve().parents[2] / "notebooks"
CELL_SECONDS = 120
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
                   store_widget_state=False, resources={"metadata": {"path": str(FOLDER)}},
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


def all_notebooks() -> list[Path]:
    """Every notebook of the course, JupyterLab's own checkpoints aside."""
    return sorted(path for path in FOLDER.rglob("*.ipynb")
                  if ".ipynb_checkpoints" not in path.parts)


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


def main(arguments: list[str] | None = None) -> int:
    """Run the command; the number of notebooks that would differ is its exit status."""
    parser = argparse.ArgumentParser(prog="python -m kinlab.course.notebooks",
                                     description="Regenerate the outputs of the notebooks.")
    parser.add_argument("--check", action="store_true", help="report only, write nothing")
    parser.add_argument("paths", nargs="*", type=Path, help="default: all in notebooks/")
    options = parser.parse_args(arguments)
    paths = options.paths or all_notebooks()
    return sum(_refresh(path, options.check) for path in paths)


def _refresh(path: Path, check: bool) -> bool:
    print(path.name, file=sys.stderr)
    saved = nbformat.read(path, as_version=4)
    fresh = run(saved, progress=True)
    changed = differs(saved, fresh)
    if not check:
        nbformat.write(fresh, path)
    word = ("differs" if check else "updated") if changed else "unchanged"
    print(f"\r  {word}{' ' * 20}", file=sys.stderr)
    return changed and check


if __name__ == "__main__":
    sys.exit(main())
