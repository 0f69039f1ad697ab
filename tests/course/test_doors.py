"""Pages and JupyterLite in one folder, built in either order: the pages say what is true there."""
import re
from urllib.parse import parse_qs, urlparse

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from kinlab.course import doors, site

LESSON = "01_a & b's lesson.ipynb"


@pytest.fixture
def lessons(tmp_path):
    """One small lesson with an exercise, by a name that HTML and addresses have to escape."""
    path = tmp_path / LESSON
    cells = [new_markdown_cell("# Why?\n\nTime: 10 minutes."),
             new_code_cell("1 + 1"),
             new_code_cell("2", metadata={"tags": ["check"]})]
    nbformat.write(new_notebook(cells=cells), path)
    return [path]


def lite(folder):
    """What `kinlab lite` leaves of itself where the pages look for it."""
    (folder / "lab").mkdir(parents=True, exist_ok=True)
    (folder / doors.LAB).write_text("JupyterLab")


def pages(folder):
    return {path.name: path.read_text("utf-8") for path in folder.glob("*.html")}


def test_both_orders_give_the_same_pages(lessons, tmp_path):
    first, second = tmp_path / "first", tmp_path / "second"
    lite(first)
    site.build(first, lessons)
    site.build(second, lessons)
    alone = pages(second)
    lite(second)
    doors.say_so(second)
    assert pages(first) == pages(second) != alone and len(alone) == 2
    doors.say_so(second)
    assert pages(first) == pages(second)


def test_pages_alone_lead_to_jupyterlab_and_beside_lite_to_the_lesson(lessons, tmp_path):
    site.build(tmp_path / "out", lessons)
    for text in pages(tmp_path / "out").values():
        assert doors.LAB not in text and "JupyterLab" in text
    lite(tmp_path / "out")
    doors.say_so(tmp_path / "out")
    texts = pages(tmp_path / "out")
    links = {name: re.findall(rf'href="({doors.LAB}[^"]*)"', text) for name, text in texts.items()}
    assert [parse_qs(urlparse(link).query)["path"] for link in links.pop("index.html")] == [
        ["00_start_here.ipynb"]]
    (links,) = links.values()
    assert [parse_qs(urlparse(link).query)["path"] for link in links] == [[LESSON]] * 2
    assert not any("JupyterLab" in text for text in texts.values())
    assert "Run All Cells" in texts[f"{LESSON.removesuffix('.ipynb')}.html"]  # a check needs them
