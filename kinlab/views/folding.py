"""Answers that stay folded when a whole notebook is run.

A cell whose output answers a prediction has ``"jupyter": {"outputs_hidden": true}`` in its
metadata. JupyterLab opens such an output as soon as its cell is run, and drops the mark. But it
sends the mark along with the code, so the kernel can fold the output itself: in HTML, and in a
live view. Whoever sends no mark (nbclient, nbval) gets the output as it is.
"""
from __future__ import annotations

import sys
from html import escape
from typing import Any

WIDGET = "application/vnd.jupyter.widget-view+json"
SUMMARY = "The answer. Open it when you have committed yours."


def is_folded() -> bool:
    """Whether the cell that runs is marked as one whose output stays folded."""
    kernel = getattr(_shell(), "kernel", None)
    if kernel is None:
        return False
    sent = kernel.get_parent().get("metadata") or {}
    return bool((sent.get("jupyter") or {}).get("outputs_hidden"))


def fold_answers() -> None:
    """From now on, fold the results of marked cells; where there is no kernel, do nothing."""
    hook = getattr(_shell(), "displayhook", None)
    if hook is not None and hasattr(hook, "register_hook"):  # from ipykernel 7 on
        hook.unregister_hook(folded)
        hook.register_hook(folded)


def folded(message: dict) -> dict:
    """A result of a marked cell as one that opens; any other as it is."""
    data = message["content"]["data"]
    if WIDGET not in data and is_folded():
        data["text/html"] = (f"<details class='kl-answer'><summary>{SUMMARY}</summary>"
                             f"{_inside(data)}</details>")
    return message


def _inside(data: dict) -> str:
    """What there is to see, in HTML."""
    if "text/html" in data:
        return str(data["text/html"])
    if "text/latex" in data:
        return escape(str(data["text/latex"]), quote=False)
    return f"<pre>{escape(str(data.get('text/plain', '')))}</pre>"


def _shell() -> Any:
    """The running IPython, if there is one; it is not loaded for this."""
    ipython = sys.modules.get("IPython")
    return ipython.get_ipython() if ipython else None
