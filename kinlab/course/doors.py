"""What the pages of the site say of running a lesson: in a browser, or elsewhere.

Both are built into one folder, in either order. Who comes second makes the pages say what is true.
"""
from __future__ import annotations

from html import escape
from pathlib import Path
from urllib.parse import quote

from .handout import FIRST

LAB = "lab/index.html"  # JupyterLite's page, in the folder of the site
_RUN = "The cells of this page have been run: the pictures move as the text says."
# JupyterLite asks its front page for settings, and does not start if that has none.
_SETTINGS = '<script id="jupyter-config-data" type="application/json">{}</script>'
_MOVES = "Everything moves in these pages. To run code and to have answers checked,"
_JUDGED = "It says what is right and names the slip."


def has_lite(folder: Path) -> bool:
    """Whether a folder holds the JupyterLite site."""
    return (folder / LAB).is_file()


def has_pages(folder: Path) -> bool:
    """Whether a folder holds the pages of the site."""
    return (folder / "kinlab.js").is_file()


def lesson(notebook: str, lite: bool) -> str:
    """What stands under the title of a lesson's page, as HTML."""
    if not lite:
        return (f'<p class="kl-check">{_RUN} To change the\ncode, open {_file(notebook)} in '
                "JupyterLab.</p>")
    return (f'<p class="kl-check">{_link(notebook, "Run this lesson", "kl-run")} {_RUN} Run the '
            "lesson to change its code and to have your answers checked: it opens as a notebook "
            "in this browser, with nothing to install. Choose <strong>Run All Cells</strong> in "
            "its menu <strong>Run</strong> first.</p>")


def check(notebook: str, lite: bool) -> str:
    """What stands on a page in the place of an exercise's check, as HTML."""
    where = (f"Checking needs Python: {_link(notebook, 'run this lesson')} and" if lite else
             f"Checking needs JupyterLab: open {_file(notebook)} there and run")
    return (f'<p class="kl-check">{where} all its cells. Put your\nanswer in this place, run that '
            f"cell and then the next one. {_JUDGED}</p>")


def front(lite: bool) -> str:
    """What stands on the front page, as HTML."""
    if not lite:
        return f"<p>{_MOVES} open the\nnotebooks in JupyterLab.</p>"
    return (f"<p>{_MOVES} press <strong>Run this lesson</strong> on its page, or\n"
            f"{_link(FIRST, 'begin here')}: it opens in this browser, with nothing to install."
            f"</p>{_SETTINGS}")


def _file(notebook: str) -> str:
    return f"<code>notebooks/{escape(notebook)}</code>"


def _link(notebook: str, words: str, kind: str = "") -> str:
    own = f' class="{kind}"' if kind else ""
    return f'<a{own} href="{LAB}?path={quote(notebook)}">{words}</a>'


def say_so(folder: Path) -> None:
    """Pages that were built before the JupyterLite site lead to it from now on."""
    for page in folder.glob("*.html"):
        text = page.read_text(encoding="utf-8")
        for words in (lesson, check):
            name = f"{page.stem}.ipynb"
            text = text.replace(words(name, False), words(name, True))
        page.write_text(text.replace(front(False), front(True)), encoding="utf-8")
