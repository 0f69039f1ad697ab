"""A class's reports in one table: rows, doubts, and what a spreadsheet must not calculate."""
import csv
import json
from pathlib import Path

import pytest
from hostile import TEXTS

import kinlab as kl
from kinlab import __main__ as command
from kinlab.marks import report, table
from kinlab.marks.record import Session, Work

EXERCISES = ("rotation.1", "rotation.2", "translation.1")
PREDICTIONS = ("rotation.riding",)


def handed_in(folder, name, *works, key=None, path=None, written="2026-10-09T12:00:00Z"):
    """A student's file."""
    sessions = {f"{key or name}-{k}": Session(f"2026-10-0{k + 1}T08:00:00Z", kl.__version__, work)
                for k, work in enumerate(works)}
    target = folder / (path or f"{name}.json")
    target.parent.mkdir(exist_ok=True)
    report.write(report.Report(name, sessions, written), target)
    return target


def worked(solved=(), tried=(), predicted=()):
    work = Work()
    for name in (*tried, *solved):
        work.checked(name, name in solved)
    for k, ok in enumerate(predicted):
        work.answered("rotation.riding", k, ok)
    return work


def rows(folder, exercises=EXERCISES):
    text = table.as_csv(table.collect(folder, exercises, PREDICTIONS), exercises)
    head, *others = csv.reader(text.splitlines())
    return [dict(zip(head, row)) for row in others]


def test_a_row_for_each_student_by_name(tmp_path):
    handed_in(tmp_path, "Grace", worked(["rotation.1"], ["rotation.2"], [True, False, True]))
    handed_in(tmp_path, "ada", worked(["rotation.1"]), worked(["rotation.2", "translation.1"]))
    ada, grace = rows(tmp_path)
    assert ada == {
        "file": "ada.json", "name": "ada", "written": "2026-10-09T12:00:00Z", "trusted": "yes",
        "remarks": "", "solved": "3", "tried": "0", "predicted": "0", "right": "0",
        "variants solved": "",
        "rotation.1": "1", "rotation.2": "1", "translation.1": "1"}
    assert grace | {"file": "", "written": ""} == {
        "file": "", "name": "Grace", "written": "", "trusted": "yes", "remarks": "", "solved": "1",
        "tried": "1", "predicted": "3", "right": "2", "variants solved": "", "rotation.1": "1",
        "rotation.2": "0", "translation.1": ""}


def test_what_cannot_be_trusted_is_said_with_its_reason(tmp_path):
    path = handed_in(tmp_path, "Ada", worked(["rotation.1"]))
    path.write_text(path.read_text(encoding="utf-8").replace("rotation.1", "rotation.2"))
    handed_in(tmp_path, "Grace", worked(["rotation.9"]))
    (tmp_path / "Emmy.json").write_text("{")
    ada, grace, emmy = rows(tmp_path)
    assert (ada["trusted"], ada["remarks"]) == ("no", report.EDITED)
    assert (grace["trusted"], grace["remarks"]) == (
        "no", "other version: it holds what this one does not ask: rotation.9")
    assert (emmy["trusted"], emmy["remarks"], emmy["name"]) == ("no", "it is no JSON, or damaged",
                                                                "")


def test_the_same_work_under_two_names_is_said_of_both(tmp_path):
    handed_in(tmp_path, "Ada", worked(["rotation.1"]), key="k")
    handed_in(tmp_path, "Bob", worked(["rotation.1"]), key="k")
    handed_in(tmp_path, "Grace", worked(["rotation.1"]))
    ada, bob, grace = rows(tmp_path)
    assert ada["remarks"] == "the same work as somebody else's: Bob.json"
    assert bob["remarks"] == "the same work as somebody else's: Ada.json"
    assert grace["trusted"] == "yes"


def test_variants_stand_apart_from_their_exercises(tmp_path):
    handed_in(tmp_path, "Ada", worked(["rotation.2 Ada Lovelace"], ["rotation.2", "rotation.1 7"]))
    (ada,) = rows(tmp_path)
    assert (ada["solved"], ada["tried"], ada["rotation.2"]) == ("0", "1", "0")
    assert ada["variants solved"] == "rotation.2 Ada Lovelace" and ada["trusted"] == "yes"


def test_a_file_from_another_computer_of_the_same_student_is_told(tmp_path):
    handed_in(tmp_path, "Ada", worked(["rotation.1"]), key="k", path="home/r.json")
    handed_in(tmp_path, "Ada", worked(["rotation.2"]), key="l", path="lab/r.json")
    home, lab = rows(tmp_path)
    assert home["trusted"] == lab["trusted"] == "yes"
    assert home["remarks"] == f"another file has this name, too: {Path('lab', 'r.json')}"
    assert lab["remarks"] == f"another file has this name, too: {Path('home', 'r.json')}"


def test_an_edited_copy_does_not_take_the_place_of_the_honest_file(tmp_path):
    handed_in(tmp_path, "Ada", worked(["rotation.1"]), path="Ada.json")
    later = handed_in(tmp_path, "Ada", worked(["rotation.1"]), path="later.json",
                      written="2026-11-01T00:00:00Z")
    later.write_text(later.read_text(encoding="utf-8").replace("rotation.1", "rotation.2"))
    honest, edited = rows(tmp_path)
    assert (honest["file"], honest["trusted"]) == ("Ada.json", "yes")
    assert edited["trusted"] == "no" and report.EDITED in edited["remarks"]


def test_files_are_found_whatever_a_mail_program_calls_them(tmp_path):
    for name in ("A.JSON", "B.json.txt", "kinlab_report.json(1)"):
        handed_in(tmp_path, name[0], worked(), path=name)
    (tmp_path / "gone.json").symlink_to(tmp_path / "nowhere")
    (tmp_path / "folder.json").mkdir()
    found = {row["file"]: row["trusted"] for row in rows(tmp_path)}
    assert found == {"A.JSON": "yes", "B.json.txt": "yes", "kinlab_report.json(1)": "yes",
                     "gone.json": "no"}


def test_only_the_last_of_two_by_one_student_counts(tmp_path):
    first, more = worked(["rotation.1"]), worked(["rotation.2"])
    handed_in(tmp_path, "Ada", first, path="one/report.json", written="2026-10-01T00:00:00Z")
    handed_in(tmp_path, "Ada", first, more, path="two/report.json")
    old, new = rows(tmp_path)
    assert (old["trusted"], old["remarks"]) == (
        "no", f"handed in again, later: {Path('two', 'report.json')}")
    assert (new["trusted"], new["solved"]) == ("yes", "2")


@pytest.mark.parametrize("text", [text for text in TEXTS.values() if text.isprintable()])
def test_no_text_is_a_formula_of_a_spreadsheet(tmp_path, text):
    handed_in(tmp_path, text, worked(), path="x.json")
    (row,) = rows(tmp_path)
    assert row["name"] == ("'" if text[0] in "=+-@\t\r" else "") + text[:200]


def test_notebooks_and_checkpoints_are_not_opened(tmp_path):
    handed_in(tmp_path, "Ada", worked())
    (tmp_path / "lesson.ipynb").write_text('{"kinlab report": 1}')
    (tmp_path / ".ipynb_checkpoints").mkdir()
    (tmp_path / ".ipynb_checkpoints" / "Ada-checkpoint.json").write_text("{")
    assert [row["file"] for row in rows(tmp_path)] == ["Ada.json"]


def test_a_class_of_thirty_becomes_one_table(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    students = tmp_path / "handed in"
    students.mkdir()
    for k in range(30):
        handed_in(students, f"Student {k:02}", worked(["translation.1"]), path=f"{k:02}/r.json")
    told = json.loads((students / "07" / "r.json").read_text())
    (students / "07" / "r.json").write_text(json.dumps(told | {"name": "Another"}))
    assert command.main(["marks", str(students)]) == 0
    said = capsys.readouterr().out
    assert said.splitlines()[0] == "30 files in marks.csv"
    assert f"Not to be trusted: {Path('07', 'r.json')}: edited by hand" in said
    text = Path("marks.csv").read_text(encoding="utf-8-sig")
    lines = list(csv.DictReader(text.splitlines()))
    assert len(lines) == 30 and sum(line["trusted"] == "yes" for line in lines) == 29
    assert all(line["translation.1"] == "1" for line in lines)
    assert set(kl.lessons.exercises()) <= set(lines[0])


@pytest.mark.parametrize("arguments, words", [
    (["no folder"], "there is no folder 'no folder'"),
    (["."], "there is no .json file"),
    ([".", "--out", "no/marks.csv"], "--out: there is no folder 'no'"),
    ([".", "--out", "Ada.json"], "--out: expected a name that ends in .csv, got 'Ada.json'"),
    ([".", "--out", "old.csv"], "--out: 'old.csv' is there already and stays as it is")])
def test_what_cannot_be_done_is_one_sentence(tmp_path, capsys, monkeypatch, arguments, words):
    monkeypatch.chdir(tmp_path)
    if "--out" in arguments:
        handed_in(tmp_path, "Ada", worked())
        Path("old.csv").write_text("an older one")
    with pytest.raises(SystemExit) as stop:
        command.main(["marks", *arguments])
    assert stop.value.code == 2 and words in capsys.readouterr().err
