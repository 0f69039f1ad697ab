"""What the colours of all pictures, formulas and numbers mean, as one small picture."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes

from .paints import COLOURS, INK
from .workspace_figures import Picture

_WIDTH, _HEIGHT, _ROWS = 560.0, 150.0, 4  # px
_ENTRIES = (
    ("x", "x axis, vermilion"), ("y", "y axis, green"), ("z", "z axis, blue"),
    ("angle", "angle: a violet arc"), ("length", "length: a brown line"),
    ("point", "point, tip: a pink dot"), ("target", "target: a crimson ring"),
    ("miss", "still missing: dashed"), ("first", "first of two curves"),
    ("second", "second: dashed"), ("pointed", "pointed at: amber"),
)


def colours_picture() -> Picture:
    """Each quantity's colour with the shape that it is drawn in.

    Returns
    -------
    matplotlib.figure.Figure
    """
    fig = Picture(figsize=(_WIDTH / 72, _HEIGHT / 72))
    fig.about, fig.words = "Legend.", "; ".join(words for _, words in _ENTRIES)
    ax = fig.add_axes((0, 0, 1, 1), xlim=(0, _WIDTH), ylim=(_HEIGHT, 0))
    ax.axis("off")
    for k, (name, words) in enumerate(_ENTRIES):
        x, y = 16 + k // _ROWS * _WIDTH / 3, 22 + k % _ROWS * (_HEIGHT - 8) / _ROWS
        _SHAPES.get(name, _line)(ax, x, y, name)
        colour = COLOURS["target" if name == "miss" else name].words
        ax.text(x + 44, y, words, color=colour, va="center", fontsize=10.5, family="sans-serif")
    return fig


def _line(ax: Axes, x: float, y: float, name: str) -> None:
    ax.plot([x, x + 34], [y, y], color=COLOURS[name].line, linewidth=2.2)


def _dashed(ax: Axes, x: float, y: float, name: str) -> None:
    colour = COLOURS["target" if name == "miss" else name].line
    ax.plot([x, x + 34], [y, y], color=colour, linewidth=2, linestyle=(0, (4, 2.5)))


def _arrow(style: str) -> Callable[[Axes, float, float, str], None]:
    """An arrow of matplotlib's, such as "-|>"."""
    def draw(ax: Axes, x: float, y: float, name: str) -> None:
        ax.annotate("", (x + 36, y), (x, y), arrowprops={
            "arrowstyle": style, "color": COLOURS[name].line, "linewidth": 2, "shrinkA": 0,
            "shrinkB": 0, "mutation_scale": 12})
    return draw


def _arc(ax: Axes, x: float, y: float, name: str) -> None:
    turn = np.radians(np.linspace(0, 70, 30))
    ax.plot([x + 30, x, x + 10], [y + 10, y + 10, y - 15], color=INK, linewidth=0.8)
    ax.plot(x + 24 * np.cos(turn), y + 10 - 24 * np.sin(turn), color=COLOURS[name].line,
            linewidth=2.2)


def _dot(ax: Axes, x: float, y: float, name: str) -> None:
    ax.plot(x + 17, y, "o", color=COLOURS[name].line, markersize=7)


def _ring(ax: Axes, x: float, y: float, name: str) -> None:
    ax.plot(x + 17, y, "o", color=COLOURS[name].line, markersize=13, markerfacecolor="none",
            markeredgewidth=2.2)


def _bar(ax: Axes, x: float, y: float, name: str) -> None:
    ax.plot([x + 2, x + 32], [y, y], color=COLOURS[name].line, linewidth=11)


_SHAPES = {**{axis: _arrow("-|>") for axis in "xyz"}, "angle": _arc, "length": _arrow("<|-|>"),
           "point": _dot, "target": _ring, "miss": _dashed, "second": _dashed, "pointed": _bar}
