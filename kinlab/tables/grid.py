"""A text as lines of cells: CSV, tabs, blanks, Markdown, LaTeX, HTML."""
from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Iterator

Lines = list[list[str]]

_HTML = re.compile(r"<(?:table|tr|td|th)\b", re.IGNORECASE)
_HTML_PIECE = re.compile(r"<(/?)([A-Za-z][A-Za-z0-9]{0,15})([^<>]{0,400})>|([^<]+|<)")
_SPAN = re.compile(r"colspan\s*=\s*[\"']?([0-9]{1,2})", re.IGNORECASE)
_LONGEST_CELL = 1000
_INLINE = ("sub", "sup")
_LATEX = re.compile(r"\\begin\s*\{(tabular[x*]?|longtable|array|[bBpvV]?matrix\*?|aligned|cases)\}")
_LATEX_COLUMNS = re.compile(r"\s*(?:\[[^\]]{0,20}\])?(?:\s*\{(?:[^{}]|\{[^{}]{0,40}\}){0,120}\})")
_LATEX_LINES = re.compile(r"\\(?:hline|toprule|midrule|bottomrule|addlinespace|centering|small|"
                          r"(?:cmidrule|cline)(?:\([^)]{0,10}\))?\s*\{[^{}]{0,20}\})(?![A-Za-z])")
_LATEX_SPAN = re.compile(r"\\multicolumn\s*\{([0-9]{1,2})\}\s*\{[^{}]{0,20}\}\s*\{([^{}]{0,80})\}")
_LATEX_ROWS = re.compile(r"\\multirow\s*\{[^{}]{0,20}\}\s*\{[^{}]{0,20}\}\s*\{([^{}]{0,80})\}")
_COMMENT = re.compile(r"(?<!\\)%.*")
_BOX = str.maketrans("│┃║¦", "||||")
_RULE = re.compile(r"[\s|+:=\-\u2013\u2014\u2500-\u257f]+")
_DRAWN = re.compile(r"[-=\u2013\u2014]{2}|[\u2500-\u257f]|:-|-:|^\|?-\|")
_REMARKED = re.compile(r"^\s*(?:%+|#+|//+|\*|>)\s*(?=\|)")
_PAIRS = re.compile(r"\b(link|joint|axis)\s+(angle|twist|length|offset|type|name|variable|no\.?)\b",
                    re.IGNORECASE)


def grids(text: str) -> Iterator[Lines]:
    """The ways in which a text may be cut into cells, the likeliest first.

    Examples
    --------
    >>> next(grids("| i | d |\\n|---|---|\\n| 1 | 2 |"))
    [['i', 'd'], ['1', '2']]
    """
    if match := _LATEX.search(text):
        yield _latex(text, match)
    if _HTML.search(text):
        yield _html(text)
    if text.count("|") > 1 or text.translate(_BOX).count("|") > 1:
        yield _piped(text)
    if "&" in text and "\\\\" in text and not match:
        yield _latex_rows(text)
    for sign in "\t;,":
        if sign in text:
            yield _separated(text, sign)
    for cut in (_by_gaps, _by_blanks, _by_blanks_of_sums):
        yield [cut(line) for line in text.splitlines()]


def _separated(text: str, sign: str) -> Lines:
    try:
        return [list(map(str.strip, cells))
                for cells in csv.reader(io.StringIO(text), delimiter=sign)]
    except csv.Error:  # a quotation mark in prose
        return [[cell.strip() for cell in line.split(sign)] for line in text.splitlines()]


# ---- blanks ----


def _by_gaps(line: str) -> list[str]:
    return re.split(r"[ \t]{2,}|\t", line.strip())


def _by_blanks(line: str) -> list[str]:
    """Cells that are parted by single blanks; a unit in brackets belongs to what is before it."""
    return re.sub(r"\s+(?=[\[(])", "", _PAIRS.sub(r"\1_\2", line)).split()


def _by_blanks_of_sums(line: str) -> list[str]:
    return _by_blanks(re.sub(r"\s*([+*/])\s*|\s+(-)\s+", r"\1\2", line))


# ---- Markdown, and boxes of characters ----


def _piped(text: str) -> Lines:
    lines = (_REMARKED.sub("", line).strip() for line in text.translate(_BOX).splitlines())
    return [_piped_cells(line) for line in lines if not _is_rule(line)]


def _is_rule(line: str) -> bool:
    """Whether a line is drawn, as under a head; a row of single dashes holds zeros."""
    return bool(_RULE.fullmatch(line)) and bool(_DRAWN.search(line))


def _piped_cells(line: str) -> list[str]:
    if "|" not in line:
        return [line]
    cells = re.split(r"(?<!\\)\|", line.removeprefix("|"))
    if line.endswith("|") and not line.endswith("\\|") and len(cells) > 1:
        cells.pop()
    return [cell.strip().strip("`").replace("\\|", "|") for cell in cells]


# ---- LaTeX ----


def _latex(text: str, match: re.Match[str]) -> Lines:
    """What stands before a table, its rows, and what stands behind it."""
    end = text.find(f"\\end{{{match[1]}}}", match.end())
    body = text[match.end():end if end >= 0 else len(text)]
    if not match[1].endswith("matrix") and match[1] not in ("aligned", "cases"):
        for _ in range(2 if match[1][-1] in "x*" else 1):
            body = body[columns.end():] if (columns := _LATEX_COLUMNS.match(body)) else body
    behind = text[end:] if end >= 0 else ""
    return [*([line] for line in text[:match.start()].splitlines()), *_latex_rows(body),
            *([line] for line in behind.splitlines())]


def _latex_rows(body: str) -> Lines:
    body = _LATEX_LINES.sub(" ", _COMMENT.sub("", body))
    body = _LATEX_ROWS.sub(r"\1", _LATEX_SPAN.sub(_spanned, body))
    rows = re.split(r"\\\\\*?(?:\s*\[[^\]]{0,20}\])?|\\tabularnewline\b", body)
    return [[" ".join(cell.split()) for cell in re.split(r"(?<!\\)&", row)] for row in rows]


def _spanned(match: re.Match[str]) -> str:
    return match[2] + " & " * (min(int(match[1]), 40) - 1)


# ---- HTML ----


def _html(text: str) -> Lines:
    """The cells of an HTML table, and the lines of text around it."""
    page = _Page()
    for end, tag, attributes, words in _HTML_PIECE.findall(text):
        if words:
            page.write(words)
        else:
            page.tag(tag.lower(), bool(end), attributes)
    return [[cell.strip() for cell in line] for line in page.lines]


class _Page:
    """The lines of a page, as far as it is read."""

    def __init__(self) -> None:
        self.lines: Lines = [[""]]
        self._hidden = self._in_row = False

    def write(self, words: str) -> None:
        line = self.lines[-1]
        if not self._hidden and line and len(line[-1]) < _LONGEST_CELL:
            line[-1] += " ".join(f"|{words}|".split())[1:-1]

    def tag(self, tag: str, end: bool, attributes: str) -> None:
        doing: dict[str, Callable[[], None]] = {
            "tr": self._row, "td": lambda: self._cell(attributes),
            "th": lambda: self._cell(attributes)}
        if tag in ("script", "style"):
            self._hidden = not end
        elif tag in _INLINE and not self._hidden:
            self.write("}" if end else "_{" if tag == "sub" else "^{")
        elif tag in doing and not end:
            doing[tag]()
        elif tag in ("table", "caption", "p", "div", "br", "h1", "h2", "h3",
                     "li") and not self._in_row:
            self.lines.append([""])
        elif tag == "tr" and end:
            self._in_row = False
            self.lines.append([""])

    def _row(self) -> None:
        self._in_row = True
        self.lines.append([])

    def _cell(self, attributes: str) -> None:
        span = _SPAN.search(attributes)
        self.lines[-1].extend([""] * min(int(span[1]) if span else 1, 40))
