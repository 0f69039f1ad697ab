"""The time that a notebook states is the time that it takes."""
import re
from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from kinlab.course import minutes, site
from kinlab.course.notebooks import FOLDER

LESSONS = sorted(FOLDER.glob("*.ipynb"))
TESTS = sorted((FOLDER / "tests").glob("*.ipynb"))
each = {"ids": lambda path: path.stem}


@pytest.mark.parametrize("path", [*LESSONS, *TESTS], **each)
def test_a_notebook_states_its_honest_time_in_parts_of_a_class_hour(path):
    assert list(minutes.faults(nbformat.read(path, as_version=4))) == []


@pytest.mark.parametrize("path", LESSONS, **each)
def test_the_lists_of_lessons_say_the_same_time_and_title(path):
    notebook = nbformat.read(path, as_version=4)
    total, parts = minutes.opening(notebook)
    title = re.search("^# (.+)$", notebook.cells[0].source, re.MULTILINE)[1]
    for text, folder in (("\n".join(cell.source for cell in nbformat.read(
            LESSONS[0], as_version=4).cells), ""),
            (Path(FOLDER.parent / "README.md").read_text(encoding="utf-8"), "notebooks/")):
        (row,) = re.findall(rf"^\| (?:\[[^]]+\]\({folder}{path.name}\)|00 Start here) "
                            rf"\| {re.escape(title)} \| (\d+) \| (\d+) \|$", text, re.MULTILINE)
        assert tuple(map(int, row)) == (total, parts)


def prose(count):
    return new_markdown_cell(" ".join(["word"] * count))


def part(said, count=0):
    """A cell that opens a part, with so many more words."""
    return new_markdown_cell(f"---\n\n**{said}** " + "word " * count,
                             metadata={"tags": ["part"]})


def exercise():
    return [new_code_cell("x = ...", metadata={"tags": ["exercise"]}),
            new_code_cell("check(x)", metadata={"tags": ["check"]})]


def sums(count):
    return [new_code_cell("1 + 1") for _ in range(count)]


def a_notebook():
    """Part 1: 250 words and a few, 6 cells; part 2: 2 exercises and 2 cells."""
    first = new_markdown_cell("# Why?\n\nTime: 50 minutes in 2 parts. You need: " + "word " * 150)
    return new_notebook(cells=[
        first, part("Part 1 of 2 · 25 minutes.", 100), *sums(6),
        part("Part 2 of 2 · 25 minutes."), *exercise(), *exercise(), *sums(2)])


def test_a_minute_is_25_words_a_cell_two_an_exercise_ten_and_a_check_none():
    one, two = minutes.parts(a_notebook())
    assert one.estimate == pytest.approx((150 + 100 + 7 + 3) / 25 + 6 * 2)
    assert two.estimate == pytest.approx(3 / 25 + 2 * 10 + 2 * 2)
    assert [part.honest for part in (one, two)] == [25, 25]
    assert list(minutes.faults(a_notebook())) == []


@pytest.mark.parametrize("text, count", [
    ("", 0), ("one two-three don't", 4), ("$a + b$, $$c = d$$", 2), ("`T_01 @ T_12` and `T`", 3),
    ("[three more words](#kl:frame=1&joint=2)", 3), ("a <br> b <!-- c d -->", 2),
    ("<details><summary>Look</summary>\n\nnot read\n\n</details> read", 1),
    ("| one | 2 |\n|:--|--:|\n| θ and α | 3.5 |", 4),
])
def test_what_is_read_as_a_word(text, count):
    assert minutes.words(text) == count


def test_a_whole_hour_is_no_minute_too_much():
    """Ten times 0.1 is not quite 1 in a computer; an estimate of 45 is 45."""
    assert minutes.Part("", 45, 45 + 1e-12).honest == 45
    assert minutes.Part("", 45, 45.01).honest == 50


def test_a_notebook_without_parts_is_one():
    notebook = new_notebook(cells=[
        new_markdown_cell("# Why?\n\nTime: 15 minutes. You need: nothing."), *exercise()])
    assert list(minutes.faults(notebook)) == []
    assert [part.stated for part in minutes.parts(notebook)] == [15]


def say(k, old, new):
    def plant(cells):
        assert old in cells[k].source
        cells[k].source = cells[k].source.replace(old, new)
    return plant


PLANTED = {
    "state 25": say(1, "25 minutes", "20 minutes"),
    "the first cell says 45 minutes": say(0, "50 minutes", "45 minutes"),
    "in 3 parts": say(0, "2 parts", "3 parts"),
    "expected Part 2 of 2": say(8, "Part 2 of 2", "Part 3 of 3"),
    "Part 2 of 2 takes 55 minutes; a class hour holds 45":
        lambda cells: cells.extend([*exercise(), *exercise(), *exercise()]),
}


@pytest.mark.parametrize("fault", PLANTED)
def test_the_guard_sees(fault):
    notebook = a_notebook()
    PLANTED[fault](notebook.cells)
    found = next(minutes.faults(notebook))
    assert fault in found


@pytest.mark.parametrize("k, words", [(0, "no line like"), (8, "no line like")])
def test_a_time_that_cannot_be_read_is_named(k, words):
    notebook = a_notebook()
    notebook.cells[k].source = "In a while."
    with pytest.raises(ValueError, match=words):
        list(minutes.faults(notebook))


def test_the_course_map_says_minutes_and_parts(tmp_path):
    path = tmp_path / "a.ipynb"
    nbformat.write(a_notebook(), path)
    assert site.Lesson.read(path, "").minutes == "50 minutes in 2 parts"
