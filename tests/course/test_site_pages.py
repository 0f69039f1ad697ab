"""The site of the course: every link leads somewhere, nothing comes from elsewhere."""
import itertools
import re
from html import escape, unescape
from pathlib import Path
from urllib.parse import unquote, urlparse

import nbformat
import pytest
from grades import chosen
from markup import Reader

from kinlab.__main__ import main
from kinlab.browser import bundle
from kinlab.browser.mathml import mathematics
from kinlab.course import site
from kinlab.course.notebooks import FOLDER

LESSONS = sorted(path.stem for path in FOLDER.glob("*.ipynb"))
PAGES = {f"{name}.html" for name in ("index", *LESSONS)}
FEW = ["01_translation", "07_alpha_ii"]
every_page = pytest.mark.parametrize("name", chosen(["index", *LESSONS], ["index", *FEW]))
every_lesson = pytest.mark.parametrize("name", chosen(LESSONS, FEW))


@pytest.fixture
def folder(course_site):
    return course_site


@pytest.fixture
def text(folder, name):
    return (folder / f"{name}.html").read_text(encoding="utf-8")


@pytest.fixture
def saved(name):
    return nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)


def views_of(notebook):
    """The saved pictures of live views; other pictures stay pictures."""
    return [output for cell in notebook.cells for output in cell.get("outputs", ())
            if output.get("metadata", {}).get("image/png", {}).get("alt", "")
            .startswith("Picture of the arm.")]


def bare_questions(notebook):
    """How many predictions have no picture."""
    return sum(output.get("data", {}).get("text/plain", "").startswith("Prediction(")
               and "image/png" not in output["data"]
               for cell in notebook.cells for output in cell.get("outputs", ()))


def anchors(folder, name):
    return set(re.findall(r'\bid="([^"]+)"', (folder / name).read_text(encoding="utf-8")))


@every_page
def test_every_link_leads_somewhere(folder, name, text):
    for link in set(re.findall(r'<a [^>]*href="([^"]+)"', text)):
        parts = urlparse(link)
        if link.startswith("#kl:"):  # it leads to a part of a view; test_site.py follows it
            continue
        if parts.scheme:  # a reader may follow it out of the course
            assert parts.scheme in ("http", "https")
            continue
        target = parts.path.removeprefix("./") or f"{name}.html"
        assert target in PAGES, link
        if parts.fragment and (folder / target).is_file():
            assert unquote(parts.fragment) in anchors(folder, target), link


@every_page
def test_nothing_comes_from_elsewhere(folder, name, text):
    wanted = [address for address in Reader(text).loads
              if not re.search(r"\.html(#|$)|^https?:|^data:image/(png|webp);base64,", address)]
    assert sorted(wanted) == ["kinlab.css", "kinlab.js"]
    assert not re.search(r'<img (?![^>]*src="data:image/(png|webp);base64,)', text)
    assert not re.search(r"<(iframe|object|embed|video|audio|source|base)\b", text)
    assert not re.search(r"url\((?!#)|@import|type=\"module\"|mathjax|require\.js", text, re.I)
    assert not re.search(r'(?:src|srcset|poster)="(?:[a-z]+:)?//', text)


@pytest.mark.thorough
def test_shared_files_ask_for_nothing_either(folder):
    style, script = ((folder / f"kinlab.{end}").read_text("utf-8") for end in ("css", "js"))
    assert "url(" not in style and "@import" not in style
    assert script == bundle.script("host_course.js")
    assert {path.name for path in folder.iterdir()} == {
        "kinlab.css", "kinlab.js", "index.html", *(f"{name}.html" for name in LESSONS)}


@every_page
def test_pages_are_whole_titled_and_fit_a_phone(name, text):
    reader = Reader(text)
    assert reader.tags.count("h1") == 1 and reader.tags.count("title") == 1
    assert '<html lang="en">' in text and 'name="viewport"' in text
    title, heading = (unescape(re.search(f"<{tag}[^>]*>(.*?)<", text)[1])
                      for tag in ("title", "h1"))
    assert title == ("Course map" if name == "index" else heading)
    named = re.findall(r'<h\d id="([^"]*)"', text)
    assert "" not in named and len(named) == len(set(named))


@every_lesson
def test_every_view_moves_and_no_cell_is_lost(saved, text):
    views = views_of(saved)
    pictures = sum("image/png" in output.get("data", {})
                   for cell in saved.cells for output in cell.get("outputs", ()))
    stills = len(re.findall('<img class="kl-still" [^>]*src="data:image/webp;base64,', text))
    assert (stills, text.count("<img ")) == (len(views), pictures)
    assert views and len(re.findall('<div class="kl-view[ "][^>]*>\n<img class="kl-still"',
                                    text)) == len(views)
    assert text.count('<script type="application/json">') == len(views) + bare_questions(saved)
    checks = [cell for cell in saved.cells if "check" in cell.metadata.get("tags", ())]
    code = [cell for cell in saved.cells if cell.cell_type == "code"]
    assert text.count('<div class=" highlight') == len(code) - len(checks)
    headings = sum(len(re.findall(r"^#+ ", cell.source, re.MULTILINE)) for cell in saved.cells
                   if cell.cell_type == "markdown")
    assert len(re.findall(r"<h[1-6]\b", text)) == headings


@every_lesson
def test_views_begin_as_their_cells_left_them(saved, text):
    """Not as a later cell leaves them: it is the picture that the text beside it describes."""
    views = views_of(saved)
    spoken = re.findall(r'<img class="kl-still" alt="Picture of the arm. ([^"]*)"', text)
    assert [view.data["text/plain"] for view in views] == list(map(unescape, spoken))


@every_lesson
def test_what_answers_a_prediction_is_folded(saved, text):
    folded = [cell for cell in saved.cells
              if cell.metadata.get("jupyter", {}).get("outputs_hidden") and cell.outputs]
    found = re.findall(r'<details><summary>What this gives</summary>\n<div class="kl-output">.*?'
                       r"</details>", text, re.DOTALL)
    assert len(found) == len(folded)
    for cell, shown in zip(folded, found):
        words = cell.outputs[0].get("data", {}).get("text/plain", "").splitlines()[:1]
        assert "text/html" in cell.outputs[0].data or "text/latex" in cell.outputs[0].data or \
            "image/png" in cell.outputs[0].data or escape(*words) in shown


@every_lesson
def test_exercises_show_their_task_and_say_where_they_are_checked(name, saved, text):
    tags = [tag for cell in saved.cells for tag in cell.metadata.get("tags", ())]
    first = next(cell.id for cell in saved.cells if "check" in cell.metadata.get("tags", ()))
    assert text.count("Checking needs JupyterLab") == tags.count("check")
    assert text.count(f"Exercise {first.removeprefix('check-')}") >= 1
    assert "kl.exercises.check(&quot;" not in text
    assert f"<code>notebooks/{name}.ipynb</code>" in text
    assert "Not attempted yet.</strong>" not in text


@every_lesson
def test_every_formula_is_mathml(saved, text):
    words = "".join(Reader(text).words)
    assert "$" not in words and not re.search(r"\\(?:begin|frac|theta|left|cos|mathsf)", words)
    assert not re.search(r"<m[iot]\w*>[^<]*(?:\\|&amp;|&<)", text)
    wanted = sum(len(re.findall(r"\$\$.+?\$\$|(?<!\$)\$[^$]+\$", _plain(cell.source), re.DOTALL))
                 for cell in saved.cells if cell.cell_type == "markdown")
    wanted += sum("text/latex" in output.get("data", {})
                  for cell in saved.cells for output in cell.get("outputs", ()))
    assert text.count("<math ") >= wanted > 10


def _plain(source):
    """Markdown without code, in which a dollar sign is one."""
    return re.sub(r"`[^`]*`", "", source)


@pytest.mark.thorough
def test_the_map_leads_through_all_lessons_in_order(folder):
    index = (folder / "index.html").read_text(encoding="utf-8")
    links = re.findall(r'<td[^>]*><a href="([^"]+)">([^<]+)</a>', index)
    assert [Path(link).stem for link, _ in links] == LESSONS
    assert links[0][1] == "00 Start here" and links[2][1] == "02 Rotation"
    page_name, way = "index.html", []
    while page_name:
        found = re.search(r'<a href="([^"]+)" rel="next">', (folder / page_name).read_text("utf-8"))
        page_name = found and found[1]
        way.append(page_name)
    assert way == [*(f"{name}.html" for name in LESSONS), None]
    for before, after in itertools.pairwise(LESSONS):
        text = (folder / f"{after}.html").read_text(encoding="utf-8")
        assert f'<a href="{before}.html" rel="prev">' in text


@pytest.mark.parametrize("latex, mathml", [
    (r"\cos\theta", '<mi>cos</mi><mspace width="0.17em"/><mi>'),
    (r"a\sin(x)", '</mi><mspace width="0.17em"/><mi>sin</mi>'),
    ("(1, -1)", '</mo><mo form="prefix">&#x02212;</mo>'),
    ("a - b", "</mi><mo>&#x02212;</mo>"),
    (r"|\det J|", '<mo lspace="0" rspace="0">&#x0007C;</mo>'),
    (r"\dots + b", "</mo><mo>&#x0002B;</mo>"),
    (r"\begin{bmatrix}1\end{bmatrix}", '<mtable class="kl-matrix"><mtr>'),
    (r"\left[\begin{matrix}1\end{matrix}\right]", '<mtable class="kl-matrix"><mtr>'),
])
def test_formulas_are_spaced_as_in_print(latex, mathml):
    assert mathml in mathematics(latex)


def test_the_command_shows_its_progress_and_where_to_look(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(site, "FOLDER", tmp_path)
    (tmp_path / "00_start_here.ipynb").write_bytes((FOLDER / "00_start_here.ipynb").read_bytes())
    assert main(["site", str(tmp_path / "out")]) == 0
    said = capsys.readouterr().err
    assert "1 of 1  00_start_here" in said and str(tmp_path / "out" / "index.html") in said


def test_a_folder_that_cannot_be_made_is_refused_in_a_sentence(tmp_path, capsys):
    (tmp_path / "file").write_text("")
    with pytest.raises(SystemExit):
        main(["site", str(tmp_path / "file" / "course")])
    assert "OUT: cannot make the folder" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["site", str(tmp_path / "file")])
    assert (tmp_path / "file").read_text() == ""


@pytest.mark.parametrize("cells", [[], [nbformat.v4.new_code_cell("1 / 0")]])
def test_a_notebook_that_is_no_lesson_is_named_before_any_is_run(tmp_path, capsys, monkeypatch,
                                                                 cells):
    monkeypatch.setattr(site, "FOLDER", tmp_path)
    monkeypatch.setattr(site, "run", lambda notebook: pytest.fail("a lesson was run"))
    (tmp_path / "00_start_here.ipynb").write_bytes((FOLDER / "00_start_here.ipynb").read_bytes())
    nbformat.write(nbformat.v4.new_notebook(cells=cells), tmp_path / "Untitled.ipynb")
    with pytest.raises(SystemExit):
        main(["site", str(tmp_path / "out")])
    said = capsys.readouterr().err
    assert f"{tmp_path / 'Untitled.ipynb'}: expected a lesson" in said and "move" in said
