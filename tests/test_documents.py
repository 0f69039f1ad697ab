"""What a newcomer reads is true: links lead somewhere, files exist, nothing public is left out."""
import re
from pathlib import Path
from urllib.parse import unquote, urlparse

import pytest
import yaml

import kinlab as kl

ROOT = Path(__file__).parents[1]
DOCUMENTS = sorted(path for folder in (".", "docs", "benchmarks")
                   for path in (ROOT / folder).glob("*.md"))
REFERENCE = sorted((ROOT / "docs" / "api").glob("*.rst"))
FENCED = re.compile(r"^ *```.*?^ *```", re.MULTILINE | re.DOTALL)
every_document = pytest.mark.parametrize("path", DOCUMENTS,
                                         ids=lambda path: path.relative_to(ROOT).as_posix())


def prose(path):
    return FENCED.sub("", path.read_text(encoding="utf-8"))


def headings(path):
    """The anchors of a Markdown file, made as GitHub makes them."""
    for title in re.findall(r"^#+ +(.+?) *$", prose(path), re.MULTILINE):
        shown = re.sub(r"\[([^]]*)\]\([^)]*\)|[`*]", r"\1", title)
        yield re.sub(r"[^\w\- ]", "", shown.lower()).replace(" ", "-")


def links(text):
    text = re.sub(r"`[^`\n]+`", "", text)
    return [*re.findall(r"\]\(([^)\s]+)\)", text), *re.findall(r'(?:src|href)="([^"]+)"', text)]


@every_document
def test_every_link_leads_somewhere(path):
    for link in links(prose(path)):
        parts = urlparse(link)
        if parts.scheme:  # a reader may follow it; the tests ask nothing of the network
            assert parts.scheme in ("http", "https"), link
            continue
        target = path.parent / unquote(parts.path) if parts.path else path
        assert target.exists(), link
        if parts.fragment:
            assert parts.fragment in headings(target), link


@every_document
def test_every_file_that_is_named_is_there(path):
    """`kinlab/arms/robots.py` and the like; `notebooks/13_its_name.ipynb` is one to be written."""
    named = re.findall(r"`(?:\.venv/bin/\w+ )?((?:kinlab|tests|notebooks|docs|deploy|benchmarks)"
                       r"/[\w./-]*)`", path.read_text(encoding="utf-8"))
    assert [name for name in named if not (ROOT / name).exists()
            and name != "notebooks/13_its_name.ipynb"] == []


def test_links_are_found_and_anchors_are_those_of_github(tmp_path):
    """The two tests above are only as good as this."""
    path = tmp_path / "a.md"
    path.write_text("# The `kl.robots` & more: *q*!\n[a](b.md#c) `[no](link.md)`\n"
                    "<img src=\"p.png\"> [![p](in.png)](out.md)\n"
                    "```sh\n# no heading\n[no](code.md)\n```\n## A\n")
    assert list(headings(path)) == ["the-klrobots--more-q", "a"]
    assert sorted(links(prose(path))) == ["b.md#c", "in.png", "out.md", "p.png"]


@pytest.mark.parametrize("name", sorted({*kl.__all__} - {"exercises", "lessons", "robots"}))
def test_the_reference_has_every_public_name(name):
    assert listed().count(name) == 1


def test_the_reference_and_the_readme_have_every_arm_and_the_check():
    made = {name for name, maker in vars(kl.robots).items() if name[0] != "_" and getattr(
        maker, "__annotations__", {}).get("return") == "Arm"}
    assert len(made) >= 13 and made == set(kl.robots.__all__)
    assert {*(f"robots.{name}" for name in made), "exercises.check"} <= set(listed())
    rows = re.findall(r"^\| `(\w+)` \|", (ROOT / "README.md").read_text(encoding="utf-8"),
                      re.MULTILINE)
    assert made == set(rows)


def listed():
    text = "".join(path.read_text(encoding="utf-8") for path in REFERENCE)
    return re.findall(r"^\.\. auto(?:class|function):: (?:kinlab\.)?(\S+)$", text, re.MULTILINE)


def test_every_page_of_the_reference_is_in_its_index():
    index = (ROOT / "docs" / "api" / "index.rst").read_text(encoding="utf-8")
    assert all(re.search(rf"^   {path.stem}$", index, re.MULTILINE)
               for path in REFERENCE if path.stem != "index")


def test_checks_before_a_commit_are_those_that_every_change_must_pass():
    steps = re.findall(r"^step (.+)$", (ROOT / ".ci" / "run").read_text(), re.MULTILINE)
    config = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text())
    hooks = [hook["entry"] for repository in config["repos"] for hook in repository["hooks"]]
    assert hooks and set(hooks) <= set(steps)
