"""A student's report: what it shows, how its file grows, and what is said of other files."""
import json
from pathlib import Path

import pytest
from hostile import TEXTS

import kinlab as kl
from kinlab.marks import record, report
from kinlab.marks.record import Session, Work


@pytest.fixture(autouse=True)
def kernel(monkeypatch, tmp_path):
    """A new kernel in a new folder."""
    monkeypatch.chdir(tmp_path)
    return begin(monkeypatch, "k1", "2026-10-01T08:00:00Z")


def begin(monkeypatch, key, began):
    this = Session(began, kl.__version__, Work())
    monkeypatch.setattr(record, "KEY", key)
    monkeypatch.setattr(record, "THIS", this)
    monkeypatch.setattr(record, "WORK", this.work)
    return this.work


def edited(path, **changes):
    path.write_text(json.dumps(json.loads(path.read_text()) | changes))


def test_it_shows_what_was_solved_tried_and_predicted(kernel):
    kernel.checked("rotation.2", True)
    kernel.checked("rotation.1", False)
    kernel.checked("rotation.3 Ada", True)
    kernel.checked("rotation.3", False)
    kernel.answered("rotation.riding", 0, True)
    kernel.answered("rotation.riding", 1, False)
    kernel.answered("translation.sum", 0, True)
    assert repr(kl.exercises.report("Ada")).splitlines() == [
        "Report of Ada, kept in kinlab_report.json",
        "Lesson       Solved      Tried  Predictions right",
        "rotation     2, 3 (Ada)  1, 3   1 of 2",
        "translation                     1 of 1"]


def test_it_says_so_if_nothing_was_done():
    assert "Nothing yet. Run the checks and predictions" in repr(kl.exercises.report("Ada"))


def test_it_is_small_and_holds_what_it_says(kernel):
    kernel.checked("rotation.2", True)
    made = kl.exercises.report("Ada")
    told = json.loads(Path("kinlab_report.json").read_text(encoding="utf-8"))
    assert told["name"] == "Ada" and len(told["seal"]) == 64
    assert told["sessions"]["k1"]["version"] == kl.__version__
    assert told["sessions"]["k1"]["work"]["tries"] == {"rotation.2": 1}
    assert Path("kinlab_report.json").stat().st_size < 1000
    assert report.read(Path("kinlab_report.json")) == made and not made.doubts


def test_writing_twice_counts_once(kernel):
    kernel.checked("rotation.1", False)
    kl.exercises.report("Ada")
    assert kl.exercises.report().work.tries == {"rotation.1": 1}


def test_it_grows_from_kernel_to_kernel(monkeypatch, kernel):
    kernel.checked("rotation.1", False)
    kl.exercises.report("Ada Lovelace")
    begin(monkeypatch, "k2", "2026-10-02T08:00:00Z").checked("rotation.1", True)
    made = kl.exercises.report()
    assert made.name == "Ada Lovelace" and made.work.tries == {"rotation.1": 2}
    assert list(made.work.solved) == ["rotation.1"]


def test_a_change_of_name_is_said(kernel):
    """Whoever hands in a friend's file under their own name is seen, and so is a slip mended."""
    kl.exercises.report("Ada")
    made = kl.exercises.report("Grace")
    assert repr(made).startswith("Report of Grace, until now that of Ada, kept in kinlab_report")
    assert kl.exercises.report().doubts == ["its name was another one before: Ada"]
    assert kl.exercises.report("Ada").formerly == ("Grace",)


def test_the_name_is_whoever_is_logged_in(monkeypatch):
    monkeypatch.setenv("JUPYTERHUB_USER", "ada")
    assert kl.exercises.report(path="hub.json").name == "ada"
    monkeypatch.delenv("JUPYTERHUB_USER")
    monkeypatch.setenv("LOGNAME", "grace")
    assert kl.exercises.report(path="here.json").name == "grace"


def test_in_a_browser_nobody_is_logged_in(monkeypatch):
    monkeypatch.delenv("JUPYTERHUB_USER", raising=False)
    monkeypatch.setattr("getpass.getuser", lambda: (_ for _ in ()).throw(OSError))
    assert kl.exercises.report().name == ""


@pytest.mark.parametrize("change", [
    {"name": "Grace"}, {"written": "2020-01-01T00:00:00Z"}, {"seal": "0" * 64}, {"seal": None},
    {"more": 1}, {"formerly": ["Bob"]}])
def test_an_edit_by_hand_is_seen_and_nothing_is_lost(kernel, change):
    kl.exercises.report("Ada")
    path = Path("kinlab_report.json")
    edited(path, **change)
    assert report.read(path).edited and report.EDITED in report.read(path).doubts
    before = path.read_bytes()
    with pytest.raises(ValueError, match="was edited by hand; it stays as it is: give another"):
        kl.exercises.report()
    assert path.read_bytes() == before


def test_an_exercise_that_was_never_solved_cannot_be_written_in(kernel):
    kernel.checked("rotation.1", False)
    kl.exercises.report("Ada")
    told = json.loads(Path("kinlab_report.json").read_text())
    told["sessions"]["k1"]["work"]["solved"] = {"rotation.1": "2026-10-01T08:00:00Z"}
    Path("kinlab_report.json").write_text(json.dumps(told))
    assert report.read(Path("kinlab_report.json")).edited


def test_other_line_breaks_and_another_order_are_no_edit():
    kl.exercises.report("Ada")
    path = Path("kinlab_report.json")
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n") + b"\r\n")
    assert not report.read(path).doubts
    path.write_text(json.dumps(dict(reversed(json.loads(path.read_text()).items()))))
    assert not report.read(path).doubts
    path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes())  # as some editors save it
    assert not report.read(path).doubts


def test_another_version_is_said(monkeypatch):
    monkeypatch.setattr(record, "THIS", Session("2026-10-01T08:00:00Z", "0.0.9", Work()))
    kl.exercises.report("Ada")
    assert report.read(Path("kinlab_report.json")).doubts == [
        f"other version: made with kinlab 0.0.9, and this is {kl.__version__}"]


@pytest.mark.parametrize("content, why", [
    (b"", "no JSON, or damaged"), (b"{", "no JSON, or damaged"), (b"\xff\xfe{}", "no JSON"),
    (b"[" * 100_000, "no JSON, or damaged"), (b"3", "no report of kinlab"),
    (b"{}", "no report of kinlab"), (b'{"kinlab report": 2}', "another kinlab"),
    (b'{"kinlab report": 1}', "edited by hand"),
    (b'{"kinlab report": 1, "name": "a", "sessions": []}', "edited by hand"),
    (b'{"kinlab report": 1, "name": 3, "sessions": {}}', "edited by hand"),
    (b'{"kinlab report": 1, "name": "a", "sessions": {"k": 3}}', "edited by hand"),
    (b'{"kinlab report": 1, "name": "a", "sessions": {}, "written": "today", "formerly": []}',
     "edited by hand"), (b"1" * 5000, "no JSON, or damaged"),
    (b" " * 1_000_001, "too large")])
def test_what_is_no_report_is_said_and_kept(content, why):
    path = Path("kinlab_report.json")
    path.write_bytes(content)
    with pytest.raises(ValueError, match=why):
        report.read(path)
    with pytest.raises(ValueError, match=r"is there and is no report \(.*give another name"):
        kl.exercises.report("Ada")
    assert path.read_bytes() == content


@pytest.mark.parametrize("path", [3, None, b"x.json", "no folder/x.json", "zero\0byte.json",
                                  "report.txt"])
def test_a_path_that_cannot_be_written_is_refused(path):
    with pytest.raises(ValueError, match=r"^path: (expected (the|a) name|there is no folder|cannot "
                                         r"write)"):
        kl.exercises.report("Ada", path)


@pytest.mark.parametrize("name", [3, "two\nlines", ["Ada"]])
def test_a_name_is_one_line(name):
    with pytest.raises(ValueError, match=r"^name: expected one line of text"):
        kl.exercises.report(name)
    assert not Path("kinlab_report.json").exists()


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_what_it_shows_is_escaped(text, kernel):
    kernel.checked(f"rotation.{text}", False)
    try:
        shown = kl.exercises.report(text)._repr_html_()
    except ValueError as error:
        assert str(error).startswith("name: expected one line")
    else:
        allowed = {"p", "table", "thead", "tbody", "tr", "td"}
        tags = {part.split(">")[0].split(" ")[0].lstrip("/") for part in shown.split("<")[1:]}
        assert tags <= allowed
