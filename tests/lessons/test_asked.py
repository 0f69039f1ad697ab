"""What a newcomer meets in the notebooks: asked before it is shown, and left open by Run All."""
import re
from pathlib import Path

import nbformat
import pytest

from kinlab import lessons
from kinlab.answers.prediction import Direction, Mark
from kinlab.course.notebooks import FOLDER

NOTEBOOKS = sorted(path for path in FOLDER.rglob("*.ipynb") if path.parent.name != "solutions")
LESSONS = [path for path in NOTEBOOKS if path.stem[:2].isdigit()]
ASKS = re.compile(r'kl\.predict\("([\w.]+)"')
every = pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)


def cells(path):
    return nbformat.read(path, as_version=4).cells


def asked(path):
    return [name for cell in cells(path) if cell.cell_type == "code"
            for name in ASKS.findall(cell.source)]


def known():
    return {name: one for lesson in lessons.names()
            for name, one in lessons.predictions(lesson).items()}


@pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)
def test_a_lesson_asks_five_times_at_least(path):
    assert len(set(asked(path))) >= 5


def test_the_course_asks_each_prediction_once_and_many_in_the_picture():
    names = [name for path in NOTEBOOKS for name in asked(path)]
    assert sorted(names) == sorted(known())
    marked = [name for name in names
              if any(isinstance(case, Mark | Direction) for case in known()[name].cases)]
    assert len(marked) >= 25


@every
def test_every_prompt_is_a_question_that_can_be_answered(path):
    """Where a text says Predict, the next cell that is run asks."""
    all_cells = cells(path)
    for k, cell in enumerate(all_cells):
        if cell.cell_type == "markdown" and re.search(r"\*\*Predict\b", shown(cell.source)):
            following = next(one for one in all_cells[k:] if one.cell_type == "code")
            assert ASKS.search(following.source), cell.source[:80]


@every
def test_run_all_leaves_every_prediction_open(path):
    for cell in cells(path):
        if cell.cell_type == "code" and ASKS.search(cell.source):
            assert not cell.metadata.get("jupyter", {}).get("outputs_hidden")
            text = cell.outputs[-1]["data"]["text/plain"]
            assert text.startswith("Prediction(")
            assert text.removesuffix("\nRun this cell to answer.").endswith("\nopen")
            assert ".commit(" not in cell.source


@every
def test_no_later_cell_moves_a_prediction(path):
    """A cell asks and does nothing else; where it gives the question a name, that is only read."""
    one = re.compile(r'(?:(\w+) = )?kl\.predict\("[\w.]+"(?:, \w+)?\)(?:\n\1)?')
    code = [cell.source.strip() for cell in cells(path) if cell.cell_type == "code"]
    for source in filter(ASKS.search, code):
        found = one.fullmatch(source)
        assert found, source
        if found[1]:
            moves = re.compile(rf"\b{found[1]}(\.|\[)\S* =|\b{found[1]}\.(move|commit)\(")
            assert not any(map(moves.search, code))


def shown(text):
    """A text without what is folded in it."""
    return re.sub(r"<details>.*?</details>", "", text, flags=re.DOTALL)


def read():
    """What a student reads: the lessons' texts, the questions, and what the browser says."""
    for path in sorted(FOLDER.rglob("*.ipynb")):
        yield path.name, "\n".join(cell.source for cell in cells(path)
                                   if cell.cell_type == "markdown")
    package = Path(lessons.__file__).parents[1]
    for path in [*package.glob("lessons/asked/*.py"), *package.glob("browser/*.js")]:
        yield path.name, path.read_text(encoding="utf-8")


def test_no_text_names_the_ink_by_its_colour():
    """What is black on light paper is white on dark paper."""
    inks = re.compile(r".*\b(?:black|white) (?:dot|arrow|one|line|point).*")
    assert [(name, found) for name, text in read() for found in inks.findall(text)] == []
