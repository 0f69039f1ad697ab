"""Live views in plain pages: one file, no kernel, nothing loaded from anywhere.

The picture, its data, its controls and its script are those of the notebook.
"""
from __future__ import annotations

import base64
import io
import json
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Any

from ..arms import files
from . import bundle

_HERE = Path(__file__).parent


def part(still: bytes | None, data: dict, text: str, formula: str = "", *,
         address: bool = False) -> str:
    """One view as HTML, to stand in any page that has the script and the style.

    `still` is a picture as PNG for where no script runs, if there is something to see, `data` the
    scene and the values `q` to begin with, `text` says the state in words, `formula` is MathML;
    with `address` the page's address holds the joint values.
    """
    plain = json.dumps(_short(data), ensure_ascii=False, separators=(",", ":"))
    plain = plain.replace("<", r"\u003c")  # no text in it can end the script
    picture = base64.b64encode(_smaller(still)).decode() if still else ""
    return _filled("view.html.j2", still=picture, text=text, formula=formula, data=plain,
                   wide=data["scene"]["wide"], address=address)


def _smaller(still: bytes) -> bytes:
    """The picture in fewer pixels, for where no script draws a better one."""
    from PIL import Image

    picture, small = Image.open(io.BytesIO(still)).convert("RGB"), io.BytesIO()
    width, height = (side * 5 // 9 for side in picture.size)
    fewer = picture.resize((width, height), Image.Resampling.LANCZOS)
    fewer.save(small, "WEBP", quality=28, method=6)
    return small.getvalue()


def _filled(template: str, **parts: Any) -> str:
    """A template with its parts; what is not marked safe in it is escaped."""
    from jinja2 import Environment, FileSystemLoader  # only who writes a page waits for it

    templates = Environment(loader=FileSystemLoader(_HERE), autoescape=True)
    return templates.get_template(template).render(parts)


def _short(data: Any) -> Any:
    """The same data in short: 1 for 1.0, 0.975 for 0.9750000000000001. A page holds thousands."""
    if isinstance(data, dict):
        return {key: _short(value) for key, value in data.items()}
    if isinstance(data, (list, tuple)):
        return [_short(value) for value in data]
    if not isinstance(data, float):
        return data
    return int(data) if data.is_integer() else float(f"{data:.13g}")


def save(path: Any, title: str, view: str, question: str = "", *, script: str = "host_page.js",
         styles: Sequence[str] = (), without: Collection[str] = ()) -> Path:
    """Write the page of one view, replacing a file of this name.

    `script` is its entry module, and `without` those that this view does not need; `styles` are
    the sheets that it needs besides those of a view.
    """
    target = files.target("path", path, (".html", ".htm"), "browsers open a page by its ending")
    text = _filled("page.html.j2", title=title, question=question, view=view,
                   style=bundle.page_style(*styles), script=bundle.script(script, without=without))
    data = text.encode("utf-8", "replace")  # a name may hold half a character
    return files.write("path", target, data)
