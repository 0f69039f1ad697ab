"""DH tables for a report: Markdown and LaTeX, which read back as they were."""
from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from ..arms.printed import HEADS
from .as_csv import csv_line, other_columns, settings
from .cells import MILLIMETRES
from .table import DHTable, Row

# Signs that mean something in LaTeX, and what prints them.
LATEX_SIGNS = {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
               **{sign: f"\\{sign}" for sign in "&%$#_{}"}}
MARKDOWN_SIGNS = "\\`*_|<>[]#~$&"
_FORMULA = re.compile(r"[-+*/().0-9]*(?:pi)?[-+*/().0-9]*")
_LATEX_HEADS = {"θ": r"$\theta_i$", "α": r"$\alpha_i$", "α(i-1)": r"$\alpha_{i-1}$", "a": "$a_i$",
                "a(i-1)": "$a_{i-1}$", "d": "$d_i$"}


def to_markdown(table: DHTable) -> str:
    """The table as Markdown: a list of what it is, and its rows with a star at each variable.

    Examples
    --------
    >>> print(to_markdown(DHTable((Row(alpha="-90", d="215"),), unit="mm")), end="")
    - convention: standard
    - angles: deg
    - lengths: mm
    <BLANKLINE>
    | i | joint | θ [deg] | d [mm] | a [mm] | α [deg] |
    |---|---|---|---|---|---|
    | 1 | revolute | θ1\\* 0 | 215 | 0 | -90 |
    """
    start = [f"- {word}: {_markdown(csv_line(given))}".rstrip("\n")
             for word, *given in settings(table)]
    heads = [*_heads(table, str), *other_columns(table)]
    rows = _rows(table, _markdown, _markdown_variable)
    lines = [*start, "", _piped(heads), "|" + "---|" * len(heads), *map(_piped, rows), ""]
    return "\n".join(lines)


def to_latex(table: DHTable) -> str:
    """The table as a LaTeX tabular; comments above it say what it is.

    Examples
    --------
    >>> print(to_latex(DHTable((Row(alpha="-pi/2"),))), end="")
    % convention: standard
    % angles: deg
    % lengths: m
    \\begin{tabular}{clrrrr}
    \\hline
    $i$ & joint & $\\theta_i$ [deg] & $d_i$ [m] & $a_i$ [m] & $\\alpha_i$ [deg] \\\\
    \\hline
    1 & revolute & $\\theta_{1}^{*}$ $0$ & $0$ & $0$ & $-\\pi/2$ \\\\
    \\hline
    \\end{tabular}
    """
    start = [f"% {word}: {csv_line(given)}".rstrip("\n") for word, *given in settings(table)]
    others = other_columns(table)
    heads = ["$i$", *_heads(table, _LATEX_HEADS.__getitem__)[1:], *others]
    rows = list(_rows(table, _latex, _latex_variable))
    lines = [" & ".join(row) + r" \\" for row in (heads, *rows)]
    begin = rf"\begin{{tabular}}{{clrrrr{'l' * len(others)}}}"
    return "\n".join([*start, begin, r"\hline", lines[0], r"\hline", *lines[1:], r"\hline",
                      r"\end{tabular}", ""])


def _heads(table: DHTable, spelled: Callable[[str], str]) -> list[str]:
    """The headings with their units, in the convention's order."""
    lengths = f" [{table.unit}]" if table.unit in MILLIMETRES else ""
    units = {"theta": f" [{table.angles}]", "alpha": f" [{table.angles}]", "d": lengths,
             "a": lengths}
    return ["i", "joint", *(spelled(head) + units[column]
                            for column, head in HEADS[table.convention].items())]


def _rows(table: DHTable, cell: Callable[[str], str],
          variable: Callable[[Row, int, str], str]) -> Iterator[list[str]]:
    joint = 0
    for i, row in enumerate(table.rows, start=1):
        joint += bool(row.variable)
        texts = {column: cell(getattr(row, column)) for column in HEADS[table.convention]}
        if row.variable:
            texts[row.variable] = variable(row, joint, texts[row.variable])
        yield [str(i), row.kind, *texts.values(),
               *(cell(getattr(row, column)) for column in other_columns(table))]


def _piped(cells: list[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _markdown(text: str) -> str:
    return "".join(f"\\{sign}" if sign in MARKDOWN_SIGNS else sign for sign in text)


def _markdown_variable(row: Row, joint: int, offset: str) -> str:
    letter = HEADS["standard"][str(row.variable)]
    return f"{'-' * row.flip}{letter}{joint}\\* {offset}".rstrip()


def _latex(text: str) -> str:
    if text and _FORMULA.fullmatch(text):
        return "$" + text.replace("*", r"{\cdot}").replace("pi", r"\pi") + "$"
    return "".join(LATEX_SIGNS.get(sign, sign) for sign in text)


def _latex_variable(row: Row, joint: int, offset: str) -> str:
    letter = r"\theta" if row.variable == "theta" else "d"
    return f"${'-' * row.flip}{letter}_{{{joint}}}^{{*}}$ {offset}".rstrip()
