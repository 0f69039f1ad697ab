"""Every lesson is clean, reproducible, and passes its own checks once it is solved."""
import re
from collections import Counter
from copy import deepcopy

import nbformat
import pytest
from grades import chosen
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_output

from kinlab.__main__ import main
from kinlab.course import notebooks

ALL = notebooks.all_notebooks()
LESSONS = [path for path in ALL if path.parent == notebooks.FOLDER]
MOST_LINES, MOST_BYTES, FEWEST_EXERCISES = 12, 1_000_000, 3
BANNED = {r";\s*$": "trailing semicolon", r"^\s*class ": "class", r"\binteract\(": "interact",
          r"^\s*[!%]": "magic or shell", r"sys\.path": "path trick", r"pip install": "install"}
ABSOLUTE = re.compile(r"(?<![\w.:/])/(home|root|usr|tmp|opt|Users|mnt)/|\b[A-Z]:\\|site-packages")


def name(path):
    return path.relative_to(notebooks.FOLDER).as_posix()


def read(path):
    return nbformat.read(path, as_version=4)


def code_cells(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def tagged(notebook, tag):
    return {cell.id: cell for cell in code_cells(notebook)
            if tag in cell.metadata.get("tags", ())}


def faults(notebook):
    """All that a notebook of the course must not be, in words."""
    cells = code_cells(notebook)
    if [cell.execution_count for cell in cells] != list(range(1, len(cells) + 1)):
        yield "execution counts are not 1, 2, 3, ...; nbval skips cells that were not run"
    if notebook.metadata != notebooks.METADATA:
        yield "metadata is not neutral"
    if not tagged(notebook, "exercise") and "kl.lessons.pretest" not in cells[-1].source:
        yield "no cell is tagged exercise"  # only a test of predictions has none
    for cell in cells:
        yield from (f"{cell.id}: {fault}" for fault in cell_faults(cell))
    for cell in notebook.cells:
        if cell.cell_type == "markdown" and re.search(r"!\[\s*\]\(|<img(?![^>]*alt=)", cell.source):
            yield f"{cell.id}: picture without alt text"


def cell_faults(cell):
    if len(cell.source.splitlines()) > MOST_LINES:
        yield f"more than {MOST_LINES} lines"
    for pattern, fault in BANNED.items():
        if re.search(pattern, cell.source, re.MULTILINE):
            yield fault
    for output in cell.outputs:
        yield from output_faults(output)


def output_faults(output):
    if output.output_type == "error":
        yield "error output"
    if output.get("name") == "stderr":
        yield "warning in the output"
    if ABSOLUTE.search(str({**output, "data": readable(output)})):
        yield "absolute path in the output"
    if notebooks.WIDGET in output.get("data", {}):
        yield "id of a widget that is gone"
    if "image/png" in output.get("data", {}):
        if len(output.metadata.get("image/png", {}).get("alt", "")) < 20:
            yield "picture without alt text"


def readable(output):
    return {kind: data for kind, data in output.get("data", {}).items() if kind != "image/png"}


@pytest.mark.parametrize("path", ALL, ids=name)
def test_notebook_is_clean(path):
    assert list(faults(read(path))) == []
    assert path.stat().st_size < MOST_BYTES


@pytest.mark.parametrize("path", LESSONS, ids=name)
def test_lesson_has_exercises_with_checks_and_a_solution_for_each(path):
    lesson, solutions = read(path), read(path.parent / "solutions" / path.name)
    exercises = tagged(lesson, "exercise")
    assert set(exercises) == set(tagged(solutions, "exercise"))
    assert len(tagged(lesson, "check")) == len(exercises)
    order = [cell.id for cell in code_cells(lesson)
             if {"exercise", "check"} & {*cell.metadata.get("tags", ())}]
    assert [id.split("-")[0] for id in order] == ["exercise", "check"] * len(exercises)


@pytest.mark.parametrize("path", LESSONS, ids=name)
def test_the_first_arm_waits_for_no_algebra(path):
    sources = [cell.source for cell in code_cells(read(path))]
    shows = re.compile(r"View\(|_view\(|predict\(").search
    first = next(k for k, code in enumerate(sources) if shows(code))
    assert "sympy" not in "".join(sources[:first])


def checks(path):
    """The names of a notebook's checks, such as "dh_recipe.1"."""
    return {said for cell in tagged(read(path), "check").values()
            for said in re.findall(r'check\("([\w.]+)"', cell.source)}


def test_a_lesson_has_exercises_enough():
    """The DH recipe goes on in a second notebook, and so do the numbers of its exercises."""
    every = [set(checks(path)) for path in LESSONS]
    assert sum(map(len, every)) == len(set.union(*every)), "an exercise stands in two notebooks"
    by_lesson = Counter(check.partition(".")[0] for check in set.union(*every))
    assert min(by_lesson.values()) >= FEWEST_EXERCISES
    assert all(every), "a notebook has no exercise"


@pytest.mark.parametrize("path", LESSONS, ids=name)
def test_stubs_are_not_attempted_yet(path):
    for cell in tagged(read(path), "check").values():
        assert "Not attempted yet" in cell.outputs[0].data["text/plain"]


@pytest.mark.parametrize("path", chosen(
    LESSONS, ["01_translation.ipynb", "05b_dh_practice.ipynb"], map(name, LESSONS)))
def test_solved_lesson_passes_every_check(path):
    solved = solve(read(path), read(path.parent / "solutions" / path.name))
    said = {id: cell.outputs[0].data["text/plain"]
            for id, cell in tagged(notebooks.run(solved), "check").items()}
    assert said
    assert all(text.startswith("✓ Correct") for text in said.values()), said


def solve(lesson, solutions):
    answers = tagged(solutions, "exercise")
    for id, cell in tagged(lesson, "exercise").items():
        cell.source = answers[id].source
    return lesson


def a_notebook():
    code = new_code_cell("1 + 1", id="sum", execution_count=1, metadata={"tags": ["exercise"]},
                         outputs=[new_output("execute_result", {"text/plain": "2"},
                                             execution_count=1)])
    return new_notebook(cells=[code], metadata=notebooks.METADATA)


def output(**data):
    return new_output("display_data", {key.replace("_", "/"): text for key, text in data.items()})


PLANTED = {
    "execution counts": lambda nb, cell: cell.update(execution_count=None),
    "metadata": lambda nb, cell: nb.metadata.kernelspec.update(name="my-env"),
    "tagged": lambda nb, cell: cell.metadata.clear(),
    "more than": lambda nb, cell: cell.update(source="\n".join("1" * 13)),
    "semicolon": lambda nb, cell: cell.update(source="x = 1;\nx"),
    "class": lambda nb, cell: cell.update(source="class Arm: pass"),
    "interact": lambda nb, cell: cell.update(source="interact(f, x=1)"),
    "magic": lambda nb, cell: cell.update(source="%matplotlib inline"),
    "error": lambda nb, cell: cell.outputs.append(new_output("error")),
    "warning": lambda nb, cell: cell.outputs.append(new_output("stream", name="stderr")),
    "path": lambda nb, cell: cell.outputs.append(output(text_plain="'/home/ann/arm.py'")),
    "widget": lambda nb, cell: cell.outputs.append(new_output("display_data",
                                                              {notebooks.WIDGET: {}})),
    "without alt": lambda nb, cell: cell.outputs.append(output(image_png="aGk=")),
    "picture": lambda nb, cell: nb.cells.append(new_markdown_cell("![](arm.png)")),
}


def test_the_guard_passes_a_clean_notebook():
    assert list(faults(a_notebook())) == []


@pytest.mark.parametrize("fault", PLANTED)
def test_the_guard_sees(fault):
    notebook = deepcopy(a_notebook())
    PLANTED[fault](notebook, notebook.cells[0])
    found = list(faults(notebook))
    assert len(found) == 1 and fault in found[0]


def test_the_command_regenerates_and_then_finds_nothing_to_do(tmp_path, capsys):
    path = tmp_path / "small.ipynb"
    stale = a_notebook()
    stale.cells[0].outputs[0].data["text/plain"] = "3"
    nbformat.write(stale, path)
    before = path.read_bytes()
    assert main(["notebooks", "--check", str(path)]) == 1
    assert path.read_bytes() == before
    assert "differs" in capsys.readouterr().err
    assert main(["notebooks", str(path)]) == 0
    assert read(path).cells[0].outputs[0].data["text/plain"] == "2"
    assert main(["notebooks", "--check", str(path)]) == 0
    assert "unchanged" in capsys.readouterr().err


def test_a_cell_that_fails_stops_the_command(tmp_path):
    path = tmp_path / "broken.ipynb"
    broken = a_notebook()
    broken.cells[0].source = "1 / 0"
    nbformat.write(broken, path)
    with pytest.raises(Exception, match="ZeroDivisionError"):
        main(["notebooks", str(path)])
