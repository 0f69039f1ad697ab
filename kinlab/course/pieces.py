"""For a kernel that makes the site: a view is shown as a piece of a page that moves by itself.

``%load_ext kinlab.course.pieces`` switches it on.
"""
from __future__ import annotations

from typing import Any

from ..views.live import LiveView
from ..views.table_editor import DHTableEditor


def load_ipython_extension(shell: Any) -> None:
    """Show each view as HTML, in the place of a widget and its still picture."""
    formatter = shell.display_formatter.mimebundle_formatter
    formatter.for_type(LiveView, _piece)
    formatter.for_type(DHTableEditor, _text)  # without Python nobody answers its cells


def _piece(view: LiveView) -> dict[str, str]:
    return {"text/html": view.html()}


def _text(editor: DHTableEditor) -> dict[str, str]:
    return {"text/plain": repr(editor)}
