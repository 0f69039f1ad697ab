"""The progress bar of a notebook: a widget that goes when the work is done."""
from __future__ import annotations

import ipywidgets
from IPython.display import display


class NotebookBar:
    """A bar under the cell that is running.

    It is shown as a widget and nothing else, and in the end its place is emptied. So a cell's
    output, as it is saved and compared, holds the same whether the work was long or short.
    """

    def __init__(self, title: str) -> None:
        self.bar = ipywidgets.IntProgress(description=title, style={"description_width": "initial"})
        view = self.bar._repr_mimebundle_()
        data = view[0] if isinstance(view, tuple) else view
        kind = "application/vnd.jupyter.widget-view+json"
        self.place = display({kind: data[kind]}, raw=True, display_id=True)

    def show(self, percent: int) -> None:
        self.bar.value = percent

    def close(self) -> None:
        self.place.update({}, raw=True)
        self.bar.close()
