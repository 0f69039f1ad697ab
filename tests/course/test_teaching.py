"""The teaching plan names every question in its hour, and the key of the test is true."""
import re
from pathlib import Path

import nbformat
import pytest
from predicted.pretest import PREDICTED

from kinlab.answers.prediction import Direction, Mark
from kinlab.course import minutes
from kinlab.course.notebooks import FOLDER
from kinlab.lessons import names, predictions

ROOT = Path(__file__).parents[2]
PLAN = (ROOT / "docs" / "teaching.md").read_text(encoding="utf-8")
LESSONS = sorted(FOLDER.glob("*.ipynb"))
ASKED = re.compile(r'kl\.predict\("([\w.]+)"')
TEST = {name for name in predictions("pretest") if not name.endswith("_again")}


def asked(cells):
    """The questions and the exercises of some cells, in order, as the plan writes them."""
    for cell in cells:
        if cell.cell_type == "code":
            yield from (f"`{name}`" for name in ASKED.findall(cell.source))
            if "exercise" in cell.metadata.get("tags", ()):
                yield f"exercise {cell.id.removeprefix('exercise-')}"


def hours(path):
    """What the notebook asks: {hour: questions and exercises}, the hour with its minutes."""
    notebook = nbformat.read(path, as_version=4)
    starts = [k for k, cell in enumerate(notebook.cells) if "part" in cell.metadata.get("tags", ())]
    edges = [0, *starts[1:], len(notebook.cells)]
    return {f"{k + 1}, {part.stated} minutes": list(asked(notebook.cells[edges[k]:edges[k + 1]]))
            for k, part in enumerate(minutes.parts(notebook))}


def planned(path):
    """What the plan asks, in the same form."""
    number = path.name.partition("_")[0].capitalize()
    section = re.search(rf"^### {number}\b.*?(?=^##)", PLAN, re.MULTILINE | re.DOTALL)
    found, hour = {}, ""
    for row in section[0].splitlines()[4:]:
        part, ask, *_ = (word.strip() for word in row.strip("|").split("|")) if row else ("", "")
        hour = part or hour
        found.setdefault(hour, []).extend(_said(ask))
    return found


def _said(ask):
    if listed := re.fullmatch(r"\*exercises? ([\d, ]+)\*", ask):
        return [f"exercise {number}" for number in listed[1].split(", ")]
    return [ask] if ask.startswith("`") else []


@pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)
def test_the_plan_names_each_question_in_its_hour(path):
    assert planned(path) == hours(path)


def test_every_question_of_the_course_is_asked_in_a_lesson_and_named_in_the_plan():
    lessons = {name for lesson in names() if lesson != "pretest" for name in predictions(lesson)}
    shown = {name for path in LESSONS for name in ASKED.findall(path.read_text("utf-8")
                                                                .replace('\\"', '"'))}
    assert shown == lessons
    named = set(re.findall(r"`(\w+\.\w+)`", PLAN))
    assert lessons | TEST <= named
    assert {name for name in named if name.split(".")[0] in names()} <= {
        *lessons, *predictions("pretest")}


def key():
    """The rows of the test's key, by name of the question."""
    rows = re.findall(r"^\| (\d+) `(pretest\.\w+)` \|(.*)\|$", PLAN, re.MULTILINE)
    return {name: [word.strip() for word in rest.split("|")] for _, name, rest in rows}


def test_the_key_has_every_question_of_the_test_in_its_order():
    assert list(key()) == [name for name in predictions("pretest") if name in TEST]
    for version, suffix in (("before", ""), ("after", "_again")):
        text = (FOLDER / "tests" / f"{version}.ipynb").read_text(encoding="utf-8")
        assert ASKED.findall(text.replace('\\"', '"')) == [f"{name}{suffix}" for name in key()]


@pytest.mark.parametrize("name", sorted(TEST))
@pytest.mark.parametrize("column, suffix", [(1, ""), (2, "_again")], ids=["before", "after"])
def test_the_key_is_true(name, column, suffix):
    (held,), (case,) = PREDICTED[name + suffix], predictions("pretest")[name + suffix].cases
    assert written(case, held.right) == key()[name][column]


def written(case, right):
    """An answer as the key has it."""
    number = lambda value: f"{round(value, 2) + 0.0:g}".replace("-", "−")  # noqa: E731
    if isinstance(case, Mark):
        return f"mark at ({number(right[0])}, {number(right[1])})"
    if isinstance(case, Direction):
        return f"arrow at {number(right)}°"
    if isinstance(right, list):
        return ", ".join(right if case.kind == "several" else
                         [" ".join(row).replace("-", "−") for row in right])
    return right if isinstance(right, str) else f"{number(right)}°"
