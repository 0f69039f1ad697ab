"""Live views in plain pages: one file, no kernel, nothing loaded from anywhere.

The picture, its data and its script are those of the notebook; host_page.js brings sliders of its
own.
"""
from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable
from html import escape
from pathlib import Path
from typing import Any

from ..arms import inputs
from . import bundle
from .mathml import mathematics, typeset  # noqa: F401 - where callers look for them

HERE = Path(__file__).parent
_PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="kinlab">
<title>{title}</title>
<style>
{style}</style>
</head>
<body class="kl-page">
<h1>{title}</h1>
{body}
<p class="kl-foot">Drag a slider, or the picture to turn it. The arrow keys do the same; wheel or
two fingers zoom. Made with kinlab; this page needs no network.</p>
<script>
{script}</script>
</body>
</html>
"""


def script(host: str) -> str:
    """The live picture's JavaScript, and what ties it to its host: one module."""
    return bundle.module(f"host_{host}.js")


def classic_script() -> str:
    """The script of a plain page. It is no module: browsers load none from a disk."""
    return bundle.script("host_page.js")


def style() -> str:
    """The style sheet of a plain page; the pictures' dark inks are those of dark JupyterLab."""
    live, own = ((HERE / f"{name}.css").read_text(encoding="utf-8") for name in ("live", "page"))
    dark = re.search(r"\[data-jp-theme-light=\"false\"] (\.kl-view \{.*?\n\})", live, re.DOTALL)[1]
    return f"{live}{own}\n@media screen and (prefers-color-scheme: dark) {{\n{dark}\n}}\n"


def part(svg: str, data: dict, text: str, below: Iterable[str] = (), *,
         address: bool = False) -> str:
    """One view as HTML, to stand in any page that has the script and the style.

    `svg` is the still picture, `data` the scene and the values `q` to begin with, `text` says the
    state in words, `below` is HTML; with `address` the page's address holds the joint values.
    """
    plain = json.dumps(data, ensure_ascii=False, separators=(",", ":")).replace("<", r"\u003c")
    named = escape(f"Picture of the arm. {text}")
    wide = " kl-wide" if data["scene"]["wide"] else ""
    return (f'<div class="kl-view{wide}"{" data-address" if address else ""}>\n'
            f'<div class="kl-still" role="img" aria-label="{named}">{svg}</div>\n'
            f'{"".join(below)}\n<script type="application/json">{plain}</script>\n</div>')


def hidden(svg: str, gids: Iterable[str]) -> str:
    """The picture with some of its parts switched off, to be switched on by the script."""
    for gid in gids:
        svg = svg.replace(f'<g id="{gid}"', f'<g id="{gid}" style="display: none"')
    return svg


def save(path: Any, title: str, body: str) -> Path:
    """Write one page, replacing a file of this name."""
    target = _target(path)
    text = _PAGE.format(title=escape(title), style=style(), body=body, script=classic_script())
    try:
        target.write_text(text, encoding="utf-8")
    except (OSError, ValueError) as error:  # ValueError: a name with a zero byte
        reason = getattr(error, "strerror", None) or error
        raise ValueError(f"path: cannot write {str(target)!r} ({reason}); choose a folder of "
                         "your own, or another name") from None
    return target


def _target(path: Any) -> Path:
    if not isinstance(path, str | os.PathLike) or not isinstance(os.fspath(path), str):
        raise ValueError(f"path: expected the name of a file such as 'arm.html', "
                         f"got {inputs.brief(path)}")
    target = Path(path)
    if target.suffix.lower() not in (".html", ".htm"):
        raise ValueError(f"path: expected a name that ends in .html, got {str(target)!r}; "
                         "browsers open a page by its ending")
    if not target.parent.is_dir():
        raise ValueError(f"path: there is no folder {str(target.parent)!r}; make it first, or "
                         "choose another")
    return target
