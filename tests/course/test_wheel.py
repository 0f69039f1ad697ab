"""kinlab as it is for somebody who installed a wheel: built, installed afresh, used elsewhere."""
import json
import os
import shutil
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

import nbformat
import pytest

pytestmark = pytest.mark.thorough
ROOT = Path(__file__).parents[2]
EXTENSION = ROOT / "kinlab" / "browser" / "labextension"
# Stands in for JupyterLab: it says how it was started.
LAB = """import json, os

class LabApp:
    @staticmethod
    def launch_instance(arguments):
        print(json.dumps({"opened": arguments}))
"""


def done(*command, **options):
    """What a command prints; it must end well."""
    run = subprocess.run([str(part) for part in command], capture_output=True, text=True, **options)
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel, made from the source archive as an index of packages would have it.

    Of a copy: what earlier builds left beside the sources would help this one.
    """
    source, out = tmp_path_factory.mktemp("source") / "kinlab", tmp_path_factory.mktemp("dist")
    shutil.copytree(ROOT, source, ignore=shutil.ignore_patterns(
        ".*", "*.egg-info", "__pycache__", "build", "dist", "node_modules"))
    done(sys.executable, "-m", "build", "--outdir", out, source)
    (made,) = out.glob("*.whl")
    return made


@pytest.fixture(scope="module")
def scripts(wheel, tmp_path_factory):
    """Where the commands of a fresh environment are. What kinlab needs is lent from this one."""
    home = tmp_path_factory.mktemp("fresh")
    venv.create(home, with_pip=False, symlinks=os.name != "nt")
    paths = sysconfig.get_paths("venv", {"base": str(home), "platbase": str(home)})
    done(sys.executable, "-m", "pip", "--python", home, "install", "--no-deps", wheel)
    (Path(paths["purelib"]) / "lent.pth").write_text(sysconfig.get_path("purelib"))
    return Path(paths["scripts"])


@pytest.fixture
def here(tmp_path):
    (tmp_path / "here").mkdir()
    return tmp_path / "here"


@pytest.fixture
def kinlab(scripts, here, tmp_path):
    """Run the command in an empty folder, with a stand-in for JupyterLab before the real one."""
    (tmp_path / "stub" / "jupyterlab").mkdir(parents=True)
    (tmp_path / "stub" / "jupyterlab" / "__init__.py").touch()
    (tmp_path / "stub" / "jupyterlab" / "labapp.py").write_text(LAB)
    return lambda *arguments: done(
        scripts / "kinlab", *arguments, cwd=here,
        env={**os.environ, "PYTHONPATH": str(tmp_path / "stub")})


def names(folder):
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*.ipynb")
            if ".ipynb_checkpoints" not in path.parts}


def test_the_installed_package_is_the_one_in_use(scripts, here):
    where = done(scripts / "python", "-c", "import kinlab; print(kinlab.__file__)", cwd=here,
                 env={key: text for key, text in os.environ.items() if key != "PYTHONPATH"})
    assert Path(where).is_relative_to(scripts.parent)


def test_jupyterlab_finds_what_gives_pictures_their_words(scripts):
    own = scripts.parent / "share" / "jupyter" / "labextensions" / "kinlab"
    for name in ("package.json", "static/pictures.js"):
        assert (own / name).read_bytes() == (EXTENSION / name).read_bytes()


def test_lessons_and_solutions_are_copied_and_the_first_is_opened(kinlab, here):
    said = kinlab("lessons")
    copies = here / "kinlab_lessons"
    assert names(copies) == names(ROOT / "notebooks") and len(names(copies)) >= 26
    for name in names(copies):
        assert (copies / name).read_bytes() == (ROOT / "notebooks" / name).read_bytes()
    assert json.loads(said.splitlines()[-1]) == {"opened": [str(copies / "00_start_here.ipynb")]}


def test_the_second_time_a_changed_lesson_is_kept_and_a_lost_one_comes_back(kinlab, here):
    kinlab("lessons", "mine", "--copy-only")
    changed, lost = here / "mine" / "01_translation.ipynb", here / "mine" / "02_rotation.ipynb"
    changed.write_text("what I did")
    lost.unlink()
    said = kinlab("lessons", "mine", "--copy-only")
    assert changed.read_text() == "what I did" and lost.is_file()
    copied, kept = said.partition("Kept as they are:")[::2]
    assert "Copied: 02_rotation\n" in copied and "01_translation" in kept
    assert "opened" not in said


def test_a_copied_lesson_runs_and_gives_the_saved_results(kinlab, here):
    kinlab("lessons", "--copy-only")
    kinlab("notebooks", "--check", "kinlab_lessons/01_translation.ipynb")


def test_its_kernel_runs_the_installed_package(kinlab, scripts, here):
    cell = nbformat.v4.new_code_cell("import kinlab\nprint(kinlab.__file__)")
    nbformat.write(nbformat.v4.new_notebook(cells=[cell]), here / "where.ipynb")
    kinlab("notebooks", "where.ipynb")
    (output,) = nbformat.read(here / "where.ipynb", as_version=4).cells[0].outputs
    assert Path(output.text).is_relative_to(scripts.parent)


def test_the_site_is_built_from_the_lessons_in_the_wheel(scripts, here):
    """One page is enough to show that template, styles and scripts came along."""
    code = ("from kinlab.course import handout, site; from pathlib import Path\n"
            "site.build(Path('out'), [handout.FOLDER / '00_start_here.ipynb'])")
    done(scripts / "python", "-c", code, cwd=here)
    assert '<div class="kl-view' in (here / "out" / "00_start_here.html").read_text("utf-8")
    assert {path.name for path in (here / "out").iterdir()} == {
        "index.html", "00_start_here.html", "kinlab.js", "kinlab.css"}
