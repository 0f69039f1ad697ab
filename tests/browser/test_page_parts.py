"""Pages that `save_html` writes: whole, small, safe, and with the state of the view."""
import json
import re
from base64 import b64decode
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from grades import common
from lesson_views import RARE, VIEWS
from markup import Reader
from PIL import Image

import kinlab as kl
from kinlab.browser import bundle


def write(view, folder):
    return view.save_html(folder / "arm.html").read_text(encoding="utf-8")


def state(text):
    """The data that a page brings for its script."""
    return json.loads(Reader(text).scripts[0])


@pytest.mark.parametrize("make", common(VIEWS, RARE))
def test_every_view_of_the_course_is_one_small_whole_page(make, tmp_path):
    text = write(make(), tmp_path)
    assert len(text.encode()) < 200_000
    reader = Reader(text)
    assert [address[:23] for address in reader.loads] == ["data:image/webp;base64,"]
    assert not re.search(r"url\((?!#)|@import|\bimport\b.*from|fetch\(", text)
    assert not [address for address in re.findall(r"https?://[^\s\"'<>]+", text)
                if "www.w3.org" not in address]  # names of formats, which nobody loads
    assert reader.tags.count("h1") == 1 and "title" in reader.tags and 'lang="en"' in text
    assert 'name="viewport" content="width=device-width, initial-scale=1"' in text


def test_it_says_where_it_was_written(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    view = kl.ArmView(kl.robots.two_link())
    assert view.save_html("arm.html") == Path("arm.html")
    assert view.save_html(str(tmp_path / "Arm.HTM")) == tmp_path / "Arm.HTM"
    assert "<title>Two-link</title>" in Path("arm.html").read_text(encoding="utf-8")


def test_a_newer_page_replaces_an_older_one(tmp_path):
    view = kl.ArmView(kl.robots.alpha_ii())
    first = write(view, tmp_path)
    view.q = [0.5, 0, 0, 0, 0]
    second = write(view, tmp_path)
    assert first != second and list(tmp_path.iterdir()) == [tmp_path / "arm.html"]


def test_the_page_begins_where_the_view_stands(tmp_path):
    view = kl.ArmView(kl.robots.alpha_ii(), show=["ghost"], preset="side")
    view.q = [0.1, -0.2, 0.3, -0.4, 0.5]
    before = write(kl.ArmView(kl.robots.alpha_ii(), show=["ghost"], preset="side"), tmp_path)
    text = write(view, tmp_path)
    np.testing.assert_allclose(state(text)["q"], view.q, atol=1e-12)
    assert state(text)["scene"]["preset"] == "side"
    assert Reader(text).loads != Reader(before).loads
    assert "Picture of the arm. ArmView(&#39;Alpha II&#39;, q=[5.7296, " in text


def test_without_a_script_the_picture_shows_what_is_switched_on(tmp_path):
    shown = [Reader(write(kl.ArmView(kl.robots.two_link(), show=show), tmp_path)).loads
             for show in ((), ("ghost",), ("frames",), ("frames", "labels"))]
    pictures = [np.asarray(Image.open(BytesIO(b64decode(address.split(",")[1]))).convert("L"))
                for (address,) in shown]
    assert {picture.shape for picture in pictures} == {(433, 483)}
    dark = [int((picture < 200).sum()) for picture in pictures]
    assert dark[0] < dark[2] < dark[3]  # arrows are dark, and so are their names
    assert (pictures[0] != pictures[1]).any()


def test_the_closed_form_keeps_the_textbooks_letters(tmp_path):
    text = write(kl.ArmView(kl.robots.alpha_ii(), closed_form=True), tmp_path)
    assert '<mtable class="kl-matrix">' in text and "$" not in Reader(text).words
    assert text.count("<mtr ") == 4
    assert ('<msub data-factor="S234" data-joints="2 3 4" class="kl-of-angle"><mi>S</mi>'
            "<mn>234</mn></msub>") in text
    assert "<math" not in write(kl.ArmView(kl.robots.alpha_ii()), tmp_path)


EVIL = "</script><script>alert(1)</script><!-- \"'&"


def test_a_question_stands_under_the_title(tmp_path):
    view = kl.ArmView(kl.robots.two_link())
    text = view.save_html(tmp_path / "arm.html", question=f"Where? {EVIL}").read_text("utf-8")
    reader = Reader(text)
    assert f"Where? {EVIL}" in "".join(reader.words) and reader.tags.count("script") == 2
    assert text.index("<h1>") < text.index('<p class="kl-question">') < text.index("kl-view\"")
    assert 'class="kl-question"' not in write(view, tmp_path)
    with pytest.raises(ValueError, match="question: expected"):
        view.save_html(tmp_path / "arm.html", question=3)


def test_names_cannot_break_the_page(tmp_path):
    arm = kl.Arm([kl.revolute(a=1, name=EVIL)], name=EVIL, unit="</script>")
    text = write(kl.ArmView(arm), tmp_path)
    reader = Reader(text)
    assert reader.tags.count("script") == 2 and "alert(1)" in "".join(reader.words)
    assert state(text)["scene"]["name"] == EVIL
    assert state(text)["scene"]["knobs"][0]["title"] == EVIL


def test_the_script_is_a_classic_one():
    script = bundle.script("host_page.js")
    assert not re.search(r"^\s*(export|import)\b", script, re.MULTILINE)
    assert "</script" not in script and script.startswith("(() => {") and script.endswith("})();\n")
    assert bundle.module("steps.js").removeprefix("export ").split(";")[0] in script


def refusal(path):
    view = kl.ArmView(kl.robots.two_link())
    with pytest.raises(ValueError) as error:
        view.save_html(path)
    return str(error.value)


@pytest.mark.parametrize("path, words", [
    (3, "expected the name of a file such as 'arm.html', got 3"),
    (None, "expected the name of a file"),
    (b"arm.html", "expected the name of a file"),
    ("", "a name that ends in .html, got '.'"),
    ("arm", "a name that ends in .html, got 'arm'"),
    ("arm.pdf", "a name that ends in .html, got 'arm.pdf'"),
    ("nowhere/arm.html", "there is no folder 'nowhere'; make it first"),
    ("a\0b.html", "cannot write"),
])
def test_a_path_that_will_not_do(path, words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    message = refusal(path)
    assert message.startswith("path: ") and words in message and "\n" not in message
    assert list(tmp_path.iterdir()) == []


def test_a_folder_of_that_name_is_refused(tmp_path):
    (tmp_path / "arm.html").mkdir()
    assert "cannot write" in refusal(tmp_path / "arm.html")


def test_a_page_has_no_module_that_its_view_does_without(tmp_path):
    arm, solve = write(kl.ArmView(kl.robots.two_link()), tmp_path), write(
        kl.solve_view(kl.robots.two_link(), [1, 1, 0]), tmp_path)
    assert "class Chart" not in arm and "class Cloud" not in arm
    assert "class Chart" in solve and "class Cloud" not in solve
    assert "any axis" not in arm and "any axis" not in solve  # how a frame is turned
