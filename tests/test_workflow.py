"""The workflow that a Git host runs: what it runs is what is run here, and what it publishes."""
import re
import shutil
import subprocess
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[1]
PATH = ROOT / ".github" / "workflows" / "course.yml"
WORKFLOW = yaml.safe_load(PATH.read_text(encoding="utf-8"))
STARTED = WORKFLOW[True]  # YAML takes the word "on" for true
JOBS = WORKFLOW["jobs"]


def commands(job):
    return [step["run"] for step in JOBS[job]["steps"] if "run" in step]


def told():
    """Every command that README and CONTRIBUTING tell people to run."""
    text = "".join((ROOT / name).read_text(encoding="utf-8")
                   for name in ("README.md", "CONTRIBUTING.md"))
    blocks = re.findall(r"^ *```sh\n(.*?)^ *```", text, re.MULTILINE | re.DOTALL)
    return {line.strip() for block in blocks for line in block.splitlines()}


def test_every_change_must_pass_what_it_must_pass_here():
    assert commands("tests") == [".ci/run"]
    assert (ROOT / ".ci" / "run").stat().st_mode & 0o111


def test_every_night_the_slow_tests_run_too_and_on_changes_they_do_not():
    (night,) = STARTED["schedule"]
    assert re.fullmatch(r"\d+ \d+ \* \* \*", night["cron"])
    assert commands("nightly") == [".ci/run", ".ci/thorough"]
    assert (ROOT / ".ci" / "thorough").stat().st_mode & 0o111
    assert JOBS["nightly"]["if"] == "github.event_name == 'schedule'"
    assert JOBS["tests"]["if"] == "github.event_name != 'schedule'"


def test_pages_are_built_by_the_commands_that_people_are_told():
    assert commands("pages") and set(commands("pages")) <= told()


def test_nothing_is_published_but_what_was_built_from_tested_sources():
    pages = JOBS["pages"]
    assert pages["needs"] == "tests" and "refs/heads/main" in pages["if"]
    (sent,) = [step["with"]["path"] for step in pages["steps"]
               if "upload-pages-artifact" in step.get("uses", "")]
    built = [line.split()[-1] for line in commands("pages") if " -m kinlab " in line]
    assert built == [sent, sent]


def test_what_others_wrote_is_the_hosts_own_and_of_a_named_release():
    steps = [step["uses"] for job in JOBS.values() for step in job["steps"] if "uses" in step]
    assert steps and all(re.fullmatch(r"actions/[\w-]+@v\d+", one) for one in steps)


def test_the_python_is_the_oldest_that_kinlab_allows():
    asked = re.search(r'requires-python = ">=([\d.]+)"', (ROOT / "pyproject.toml").read_text())
    for job in JOBS.values():
        assert job["container"].startswith(f"python:{asked[1]}-")


@pytest.mark.thorough
def test_the_pages_are_built_from_a_fresh_copy(tmp_path):
    copy = tmp_path / "copy"
    shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(
        ".git", ".venv", "build", "dist", "node_modules", "*.egg-info", "__pycache__"))
    for line in commands("pages"):
        run = subprocess.run(["bash", "-euo", "pipefail", "-c", line], cwd=copy,
                             capture_output=True, text=True)
        assert run.returncode == 0, f"{line}\n{run.stdout[-2000:]}{run.stderr[-2000:]}"
    site = copy / "build" / "site"
    assert "07_alpha_ii.html" in (site / "index.html").read_text(encoding="utf-8")
    assert (site / "lab" / "index.html").is_file() and (site / "07_alpha_ii.html").is_file()
