"""The command: its verbs, and the words it has for what cannot be done."""
import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import nbformat
import pytest
from nbclient.exceptions import CellExecutionError
from nbformat.v4 import new_code_cell, new_notebook

from kinlab import __main__ as command
from kinlab.course import handout, notebooks, site

ROOT = Path(__file__).parents[2]
VERBS = ("lessons", "site", "lite", "marks", "notebooks")


def refused(capsys, *arguments):
    """What the command says when it stops."""
    with pytest.raises(SystemExit) as stop:
        command.main([str(argument) for argument in arguments])
    assert stop.value.code == 2
    return capsys.readouterr().err


def loaded_by(*arguments):
    code = (f"import sys; from kinlab.__main__ import main; main({arguments!r})\n"
            "print(*sys.modules, file=sys.stderr)")
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(run.stderr.split())


@pytest.fixture
def small(tmp_path, monkeypatch):
    """A course of two lessons and a solution."""
    folder = tmp_path / "course"
    for name in ("00_start_here", "01_next", "solutions/00_start_here",
                 ".ipynb_checkpoints/01_next-checkpoint"):
        path = folder / f"{name}.ipynb"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"this is {name}", encoding="utf-8")
    monkeypatch.setattr(handout, "FOLDER", folder)
    return folder


@pytest.fixture
def opened(monkeypatch):
    """The files that JupyterLab was asked to open."""
    from jupyterlab.labapp import LabApp
    asked = []
    monkeypatch.setattr(LabApp, "launch_instance", asked.append)
    return asked


def test_help_names_every_verb(capsys):
    said = refused(capsys)
    assert all(f"\n    {verb}" in said for verb in VERBS)


@pytest.mark.parametrize("verb", VERBS)
def test_every_verb_has_help(verb, capsys):
    with pytest.raises(SystemExit) as stop:
        command.main([verb, "--help"])
    assert stop.value.code == 0 and f"usage: kinlab {verb}" in capsys.readouterr().out


def test_a_mistaken_verb_is_named_with_those_that_there_are(capsys):
    said = refused(capsys, "lesson")
    assert "'lesson'" in said and all(verb in said for verb in VERBS)


def test_lessons_are_copied_and_opened(small, opened, tmp_path, capsys):
    out = tmp_path / "new" / "mine"
    assert command.main(["lessons", str(out)]) == 0
    assert {path.relative_to(out).as_posix() for path in out.rglob("*") if path.is_file()} == {
        "00_start_here.ipynb", "01_next.ipynb", "solutions/00_start_here.ipynb"}
    assert (out / "01_next.ipynb").read_text() == "this is 01_next"
    assert opened == [[str(out / "00_start_here.ipynb")]]
    assert capsys.readouterr().out == (f"The lessons are in {out}\n"
                                       "Copied: 00_start_here, 01_next, 1 in solutions\n")


def test_the_work_of_a_student_is_kept(small, opened, tmp_path, capsys):
    out = tmp_path / "mine"
    out.mkdir()
    (out / "01_next.ipynb").write_text("my answer")
    assert command.main(["lessons", str(out), "--copy-only"]) == 0
    assert (out / "01_next.ipynb").read_text() == "my answer" and opened == []
    assert capsys.readouterr().out == (f"The lessons are in {out}\n"
                                       "Copied: 00_start_here, 1 in solutions\n"
                                       "Kept as they are: 01_next\n")


def test_a_link_that_leads_nowhere_is_not_written_through(small, tmp_path):
    out = tmp_path / "mine"
    out.mkdir()
    (out / "01_next.ipynb").symlink_to(tmp_path / "elsewhere")
    assert command.main(["lessons", str(out), "--copy-only"]) == 0
    assert not (tmp_path / "elsewhere").exists()


def test_without_a_folder_the_copies_are_in_kinlab_lessons(small, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert command.main(["lessons", "--copy-only"]) == 0
    assert (tmp_path / "kinlab_lessons" / "00_start_here.ipynb").is_file()


@pytest.mark.parametrize("occupied", ["mine", "mine/solutions"])
def test_a_folder_that_cannot_be_made_is_refused_in_a_sentence(occupied, small, tmp_path, capsys):
    (tmp_path / occupied).parent.mkdir(exist_ok=True)
    (tmp_path / occupied).write_text("a file")
    said = refused(capsys, "lessons", tmp_path / "mine", "--copy-only")
    assert said.startswith("kinlab: FOLDER: cannot make the folder") and said.count("\n") == 1
    assert (tmp_path / occupied).read_text() == "a file"


def test_half_a_lesson_is_not_left_behind(tmp_path):
    """It would be kept for ever: a disk that is full is played by a limit to a file's size."""
    resource = pytest.importorskip("resource")
    out = tmp_path / "mine"
    run = subprocess.run([sys.executable, "-m", "kinlab", "lessons", str(out), "--copy-only"],
                         capture_output=True, text=True, preexec_fn=lambda: resource.setrlimit(
                             resource.RLIMIT_FSIZE, (1000, 1000)))
    assert run.returncode == 2 and "FOLDER: " in run.stderr
    assert not [path for path in out.rglob("*") if path.is_file()]


def test_without_jupyterlab_the_lessons_are_copied_and_it_says_how_to_install_it(
        small, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(handout, "find_spec", lambda name: None)
    assert command.main(["lessons", str(tmp_path / "mine")]) == 1
    said = capsys.readouterr()
    assert "Copied: 00_start_here" in said.out and "pip install jupyterlab\n" in said.err


@pytest.mark.parametrize("arguments, wanted", [
    (["site", "out"], ["nbconvert", "ipykernel"]), (["notebooks"], ["nbconvert", "ipykernel"]),
    (["lite", "out"], ["jupyterlite_core", "jupyterlite_pyodide_kernel", "nbformat"])])
def test_without_what_runs_notebooks_a_verb_says_how_to_install_it(arguments, wanted, tmp_path):
    """In a Python that has kinlab's own dependencies only, and none of its extras."""
    absent = ["nbconvert", "nbclient", "nbformat", "ipykernel", "jupyterlab", "jupyterlite_core",
              "jupyterlite_pyodide_kernel"]
    code = (f"import sys; sys.modules.update(dict.fromkeys({absent}))\n"
            f"from kinlab.__main__ import main; main({arguments!r})")
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                         cwd=tmp_path)
    assert run.returncode == 2 and "Traceback" not in run.stderr
    assert run.stderr.startswith(f"kinlab: {' and '.join(wanted)} are not installed; run\n")
    assert f"{sys.executable} -m pip install {' '.join(wanted)}\n" in run.stderr
    assert not (tmp_path / "out").exists()


def test_what_a_verb_asks_for_is_what_its_extra_installs():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    for extra, names in handout.EXTRAS.items():
        assert [re.match(r"[\w-]+", line)[0] for line in extras[extra]] == list(names)
    assert not any("jupyterlab" in line for line in project["dependencies"])

def test_lessons_are_copied_without_waiting_for_what_runs_them(tmp_path):
    modules = loaded_by("lessons", str(tmp_path / "mine"), "--copy-only")
    assert not modules & {"numpy", "nbclient", "nbformat", "ipywidgets", "jupyterlab"}


@pytest.mark.parametrize("text", [None, "# no notebook", '{"a": 1}'])
def test_what_is_no_notebook_is_refused_in_a_sentence(text, tmp_path, capsys):
    path = tmp_path / "x.ipynb"
    if text:
        path.write_text(text)
    said = refused(capsys, "notebooks", path)
    assert "kinlab: PATHS: " in said and str(path) in said
    assert text is None or path.read_text() == text


def test_the_notebooks_of_an_installed_kinlab_are_not_written_over(capsys, monkeypatch):
    monkeypatch.setattr(notebooks, "CARRIED", notebooks.FOLDER)
    monkeypatch.setattr(notebooks, "all_notebooks", lambda: pytest.fail("would run them"))
    assert "PATHS: name the notebooks" in refused(capsys, "notebooks")


def test_the_site_shows_a_view_whatever_it_is_called_and_a_plain_picture_as_a_picture():
    """What a cell returned decides, not the words that stand for a picture."""
    cells = [new_code_cell(source) for source in (
        "import kinlab as kl\nfrom IPython.display import Image\nfrom base64 import b64decode",
        "view = kl.ArmView(kl.robots.two_link())\nview.ALT = 'Something else.'\nview",
        "Image(b64decode('iVBORw0KGgo='), alt='Picture of the arm. Not at all.')")]
    first, view, picture = site.still(new_notebook(cells=cells)).cells
    assert first.outputs == []
    assert view.outputs[0].html.startswith('<div class="kl-view')
    assert picture.outputs[0].html.startswith('<img alt="Picture of the arm. Not at all."')


def test_a_view_that_cannot_be_shown_stops_the_site():
    source = ("import kinlab as kl\nview = kl.ArmView(kl.robots.two_link())\n"
              "view.html = lambda: 1 / 0\nview")
    with pytest.raises(CellExecutionError, match="ZeroDivisionError"):
        site.still(new_notebook(cells=[new_code_cell(source)]))


def test_a_notebook_is_run_beside_the_lessons(tmp_path):
    """So a lesson may open a file of the course, wherever the command is called."""
    source = "import os\nsorted(os.listdir())[0]"
    path = tmp_path / "where.ipynb"
    nbformat.write(new_notebook(cells=[new_code_cell(source)]), path)
    assert command.main(["notebooks", str(path)]) == 0
    said = json.loads(path.read_text())["cells"][0]["outputs"][0]["data"]["text/plain"]
    assert "00_start_here.ipynb" in "".join(said)
