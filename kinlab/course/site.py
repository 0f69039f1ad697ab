"""The course as a site: pages in which every view moves, without Jupyter and without a network.

There is a page for each lesson, a course map, and the script and the style that they share. Open
index.html from the disk, or put the folder on any web server. The lessons are run for it, each in a
kernel of its own, where a view is shown as a piece of a page. So build it from notebooks that you
trust: the HTML that their code shows stands in the page as it is. All else is escaped, such as what
the code prints, and tags in the Markdown that are not in `_TAGS`.
"""
from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from dataclasses import dataclass
from html import escape, unescape
from pathlib import Path
from typing import Any
from urllib.parse import quote

import nbformat
from nbconvert import TemplateExporter
from nbconvert.filters.highlight import Highlight2HTML
from nbconvert.filters.markdown_mistune import IPythonRenderer, MarkdownWithMath
from pygments.formatters import HtmlFormatter

from ..arms.robots import alpha_ii
from ..browser import bundle, mathml
from ..views.arm_view import ArmView
from . import doors, minutes, pieces
from .handout import FOLDER, writing
from .notebooks import run

_HERE = Path(__file__).parent
_TAGS = re.compile(r"(</?(?:details|summary|sub|sup|br)\s*/?>)")  # that a lesson's text may have
_WELCOME = """# Forward kinematics of robot arms

**Drag a joint, and the arm, its frames and its numbers answer together.**
"""
_HEAD = "| lesson | question | time |\n|:--|:--|:--|\n"


@dataclass(frozen=True)
class Lesson:
    """One notebook and what the site says of it."""

    path: Path
    notebook: nbformat.NotebookNode
    name: str

    @classmethod
    def read(cls, path: Path, course: str) -> Lesson:
        """A lesson, by the name that the text of the course's map gives it: '01 Translation'."""
        named = re.search(rf"\[([^][]+)\]\({re.escape(path.name)}\)", course)
        number, _, words = path.stem.replace("_", " ").partition(" ")
        return cls(path, nbformat.read(path, as_version=4),
                   named[1] if named else f"{number} {words.capitalize()}")

    @property
    def page(self) -> str:
        return quote(f"{self.path.stem}.html")

    @property
    def opening(self) -> str:
        return "".join(cell.source for cell in self.notebook.cells[:1])

    @property
    def title(self) -> str:
        if found := re.search(r"^# (.+)$", self.opening, re.MULTILINE):
            return found[1]
        raise ValueError(f"{self.path}: expected a lesson, whose first cell begins with '# ' and a "
                         "question; move other notebooks out of this folder")

    @property
    def minutes(self) -> str:
        total, parts = minutes.opening(self.notebook)
        return f"{total} minutes" + f" in {parts} parts" * (parts > 1)


class _Renderer(IPythonRenderer):
    """Markdown as HTML: formulas as MathML, links to notebooks as links to their pages."""

    def block_html(self, html: str) -> str:
        return f"{_plain_tags(html)}\n"

    def inline_html(self, html: str) -> str:
        return _plain_tags(html)

    def inline_math(self, body: str) -> str:
        return mathml.mathematics(body)

    def block_math(self, body: str) -> str:
        return f'<span class="kl-mathematics">{mathml.mathematics(body, display=True)}</span>'

    def heading(self, text: str, level: int, **attributes: Any) -> str:
        name = re.sub(r"\W+", "-", re.sub(r"<[^>]+>|&\w+;", "", text)).strip("-").lower()
        return (f'<h{level} id="{name}">{text}<a class="anchor-link" href="#{name}" '
                f'aria-label="This section">¶</a></h{level}>\n')

    def link(self, text: str, url: str, title: str | None = None) -> str:
        if url.startswith("#kl:"):  # a term that lights a view (kinlab/browser/terms.js)
            return f'<a role="button" href="{escape(url)}">{text}</a>'
        return super().link(text, re.sub(r"\.ipynb(?=$|#)", ".html", url), title)

    def image(self, text: str, url: str, title: str | None = None) -> str:
        """A picture that the notebook holds; of others the words, as a page loads nothing."""
        return super().image(text, url, title) if url.startswith("data:") else text

    def paragraph(self, text: str) -> str:
        return super().paragraph(_tied(text))

    def list_item(self, text: str) -> str:
        return super().list_item(_tied(text))

    def table_cell(self, text: str, align: str | None = None, head: bool = False) -> str:
        """A cell; an empty one heads nothing, and a formula that heads a column is its name."""
        tag, look = ("th" if head and text else "td",
                     f' style="text-align:{align}"' if align else "")
        if head:
            text = re.sub(r"<math\b(.*?)</math>", _with_name, text, flags=re.DOTALL)
        return f"  <{tag}{look}>{text}</{tag}>\n"

    def table(self, text: str) -> str:
        return f'<div class="kl-site-table"><table>{_tied(text)}</table></div>'


def exporter() -> TemplateExporter:
    """nbconvert's, with a template of our own, and with formulas as MathML."""
    return TemplateExporter(
        raw_template=(_HERE / "site.html.j2").read_text(encoding="utf-8"),
        filters={"markdown2html": _markdown,
                 "highlight_code": Highlight2HTML()})


def _markdown(source: str) -> str:
    """Markdown as HTML; links that would run something lead nowhere."""
    reader = MarkdownWithMath(_Renderer(escape=False, allow_harmful_protocols=False))
    return str(reader(source))


def _words(text: str) -> str:
    """Markdown that shows a text as it is."""
    return re.sub(r"([!-/:-@[-`{-~])", r"\\\1", text)


def _plain_tags(html: str) -> str:
    """HTML in a text with a few tags left, and all others shown as they were written."""
    return "".join(part if k % 2 else escape(unescape(part), quote=False)
                   for k, part in enumerate(_TAGS.split(html)))


def _with_name(formula: re.Match) -> str:
    """A formula with its letters as its name, for who asks a page for the names of its columns."""
    letters = re.sub(r"<[^>]+>", "", formula[0]).replace('"', "&quot;")
    return f'<math aria-label="{letters}"{formula[1]}</math>'


def _tied(text: str) -> str:
    """The text with no comma or full stop parted from the formula before it."""
    return re.sub(r"(<math\b(?:(?!<math).)*?</math>[,.;:?!)]+)", r'<span class="kl-tied">\1</span>',
                  text, flags=re.DOTALL)


def build(folder: Path, lessons: Sequence[Path] | None = None, progress: bool = False) -> None:
    """Write the site of these notebooks (all lessons, if left out) into a folder.

    Raises
    ------
    ValueError
        If the folder cannot be made or written to.
    """
    with writing("OUT", folder):  # before any lesson is run
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "kinlab.js").write_text(bundle.script("host_course.js"), encoding="utf-8")
        (folder / "kinlab.css").write_text(style(), encoding="utf-8")
    paths = lessons or sorted(FOLDER.glob("*.ipynb"))
    names = "\n".join(cell.source for cell in nbformat.read(paths[0], as_version=4).cells)
    course = [Lesson.read(path, names) for path in paths]
    front = course_map(course)  # before any lesson is run: one may be no lesson
    export, around, lite = exporter(), [None, *course, None], doors.has_lite(folder)
    for k, (lesson, made) in enumerate(_run_two_at_a_time(course)):
        if progress:
            print(f"\r  {k + 1} of {len(course)}  {lesson.path.stem:<32}", end="", file=sys.stderr)
        _write(export, folder / f"{lesson.path.stem}.html", made, title=lesson.title,
               how=doors.lesson(lesson.path.name, lite),
               check=doors.check(lesson.path.name, lite), previous=around[k], next=around[k + 2],
               map=True)
    _write(export, folder / "index.html", front, title="Course map",
           how=f"{doors.front(lite)}\n{_arm()}", next=course[0])
    if progress:
        print(f"\r  {len(course)} lessons: open {folder / 'index.html'}{' ' * 20}", file=sys.stderr)


def _run_two_at_a_time(
        course: Sequence[Lesson]) -> Iterator[tuple[Lesson, nbformat.NotebookNode]]:
    """Each lesson, run: most of the time is spent in starting kernels."""
    with ThreadPoolExecutor(2) as pool:
        yield from zip(course, pool.map(still, [lesson.notebook for lesson in course]))


def still(notebook: nbformat.NotebookNode) -> nbformat.NotebookNode:
    """The notebook, run, with every output as HTML and every view as a piece of the page."""
    made = deepcopy(notebook)
    made.cells.insert(0, nbformat.v4.new_code_cell(f"%load_ext {pieces.__name__}"))
    made = run(made)
    del made.cells[0]
    for cell in made.cells:
        for output in cell.get("outputs", ()):
            output.html = _output(output)
    return made


def _arm() -> str:
    """An arm that a visitor drags at once, without a lesson around it."""
    return f'<div class="kl-output">{ArmView(alpha_ii()).html()}</div>'


def course_map(course: Sequence[Lesson]) -> nbformat.NotebookNode:
    """The page that leads to all lessons, as a notebook."""
    rows = "".join(f"| [{_words(lesson.name)}](./{lesson.page}) | {_words(lesson.title)} | "
                   f"{lesson.minutes} |\n" for lesson in course)
    return nbformat.v4.new_notebook(cells=[
        nbformat.v4.new_markdown_cell(text) for text in (_WELCOME, _HEAD + rows)])


def style() -> str:
    """The style sheet of all pages."""
    light, dark = (HtmlFormatter(style=name).get_style_defs(".highlight")
                   for name in ("default", "github-dark"))
    own = (_HERE / "site.css").read_text(encoding="utf-8")
    return (f"{bundle.page_style('predict.css', 'timed.css')}\n{light}\n"
            f"@media screen and (prefers-color-scheme: dark) {{\n{dark}\n}}\n{own}")


def _output(output: nbformat.NotebookNode) -> str:
    """An output as HTML: the picture, the formula, the view or table, the text."""
    data = output.get("data", {"text/plain": output.get("text", "")})
    if "image/png" in data:
        alt = output.get("metadata", {}).get("image/png", {}).get("alt", "")
        return (f'<img alt="{escape(alt)}" '
                f'src="data:image/png;base64,{escape(data["image/png"].strip())}">')
    if "text/latex" in data:
        return f'<div class="kl-mathematics">{mathml.typeset(data["text/latex"])}</div>'
    return data.get("text/html") or f'<pre>{escape(data.get("text/plain", ""))}</pre>'


def _write(export: TemplateExporter, path: Path, notebook: nbformat.NotebookNode,
           **site: Any) -> None:
    text, _ = export.from_notebook_node(notebook, resources={"site": site})
    path.write_text(text, encoding="utf-8")
