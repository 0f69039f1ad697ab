"""A text as lines of cells: CSV, tabs, blanks, Markdown, LaTeX, HTML, lines of programs."""
from __future__ import annotations

import csv
import io
import re
from collections import Counter
from collections.abc import Iterator

from .assigned import assigned_lines
from .programs import program_lines

Lines = list[list[str]]

_HTML = re.compile(r"<(?:table|tr|td|th)\b", re.IGNORECASE)
_HTML_PIECE = re.compile(r"<(/?)([A-Za-z][A-Za-z0-9]{0,15})([^<>]{0,400})>|([^<]+|<)")
_SPAN = re.compile(r"colspan\s*=\s*[\"']?([0-9]{1,2})", re.IGNORECASE)
_LONGEST_CELL, _MOST_CELLS = 1000, 30
_COMMENTED = re.compile(r"^[ \t]*(?:%+|#+|//+)[ \t]?")
_IN_BRACKETS = re.compile(r"^[ \t]*[\[(]", re.MULTILINE)
_ASSIGNED = re.compile(r"=\s{0,9}[\w.]{0,30}\(?[ \t]*[\[(]")
_SIGNS = {"sub": "_{", "sup": "^{"}
_BLOCKS = ("table", "caption", "p", "div", "br", "h1", "h2", "h3", "li")
_LATEX = re.compile(r"\\begin\s*\{(tabular[x*]?|longtable|array|[bBpvV]?matrix\*?|aligned|cases)\}")
_LATEX_COLUMNS = re.compile(r"\s*(?:\[[^\]]{0,20}\])?(?:\s*\{(?:[^{}]|\{[^{}]{0,40}\}){0,120}\})")
_LATEX_LINES = re.compile(r"\\(?:hline|toprule|midrule|bottomrule|addlinespace|centering|small|"
                          r"(?:cmidrule|cline)(?:\([^)]{0,10}\))?\s*\{[^{}]{0,20}\})(?![A-Za-z])")
_LATEX_SPAN = re.compile(r"\\multicolumn\s*\{([0-9]{1,2})\}\s*\{[^{}]{0,20}\}\s*\{([^{}]{0,80})\}")
_LATEX_ROWS = re.compile(r"\\multirow\s*\{[^{}]{0,20}\}\s*\{[^{}]{0,20}\}\s*\{([^{}]{0,80})\}")
_COMMENT = re.compile(r"(?<!\\)%.*")
_BOX = str.maketrans("│┃║¦", "||||")
_RULE = re.compile(r"[\s|+:=\-\u2013\u2014\u2500-\u257f]+")
_JIRA = re.compile(r"\s*\|\|(?:[^|]+\|\|){3,}")  # its headings
_WIKI = re.compile(r"^\{\|.*\n", re.MULTILINE)  # begins a table of Wikipedia
_WIKI_RULE = re.compile(r"^\|[-+}].*\n?", re.MULTILINE)
_WIKI_BAR = re.compile(r"!!|\|\||^!", re.MULTILINE)
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
    if _WIKI.search(text):
        yield _piped(_WIKI_BAR.sub("|", _WIKI_RULE.sub("", _WIKI.sub("", text))))
    if text.count("|") > 1 or text.translate(_BOX).count("|") > 1:
        yield _piped(text)
    if "&" in text and "\\\\" in text and not match:
        yield _latex_rows(text)
    bare = _uncommented(text)
    if len(_IN_BRACKETS.findall(bare)) > 1 or _ASSIGNED.search(bare):
        yield program_lines(bare)
    for sign in "\t;,":
        if sign in bare:
            yield _separated(bare, sign)
    yield from _blank_lines(bare)
    yield from assigned_lines(bare)


def _separated(text: str, sign: str) -> Lines:
    try:
        return [list(map(str.strip, cells))
                for cells in csv.reader(io.StringIO(text), delimiter=sign)]
    except csv.Error:  # a quotation mark in prose
        return [[cell.strip() for cell in line.split(sign)] for line in text.splitlines()]


def _uncommented(text: str) -> str:
    """The text of a table that stands in the comments of a program."""
    lines = text.splitlines()
    return "\n".join(_COMMENTED.sub("", line) for line in lines) if 2 * sum(
        bool(_COMMENTED.match(line)) for line in lines) > len(lines) else text


# ---- blanks ----


def _blank_lines(text: str) -> Iterator[Lines]:
    """Lines parted by blanks into equally many cells; what cannot be cut so is words.

    A cell may have blanks in it, such as q2 - 90 or 100 mm, so lines are cut in several ways, and
    the numbers of cells that most lines have are tried. The headings may lack that of an index.
    """
    lines = [line.strip() for line in text.splitlines() if not _is_rule(line)]
    cuts = [(line, [cut(line) for cut in (_by_gaps, _by_blanks, _by_blanks_of_sums)])
            for line in lines]
    counts = Counter(count for _, ways in cuts for count in {len(cells) for cells in ways})
    likely = sorted((count for count in counts if 2 < count <= _MOST_CELLS and counts[count] > 1),
                    key=lambda count: (-counts[count], -count))
    for count in likely[:3]:
        yield [next((cells for size in (count, count - 1) for cells in ways if len(cells) == size),
                    [line]) for line, ways in cuts]


def _by_gaps(line: str) -> list[str]:
    return re.split(r"[ \t]{2,}|\t", line.strip())


def _by_blanks(line: str) -> list[str]:
    """Cells that are parted by single blanks; a unit in brackets belongs to what is before it."""
    return re.sub(r"\s+(?=[\[(])", "", _PAIRS.sub(r"\1_\2", line)).split()


def _by_blanks_of_sums(line: str) -> list[str]:
    return _by_blanks(re.sub(r"(?<=[\w)°*])\s*(?:([+*/])\s*|\s([-−])\s+)(?=[\w(.])", r"\1\2", line))


# ---- Markdown, and boxes of characters ----


def _piped(text: str) -> Lines:
    lines = [_REMARKED.sub("", line).rstrip() for line in text.translate(_BOX).splitlines()]
    lines = [line for line in lines if not _is_rule(line)]
    lines = [line.replace("||", "|") if _JIRA.fullmatch(line) else line for line in lines]
    barred = [line for line in lines if "|" in line]
    edged = 2 * sum(line.lstrip().startswith("|") for line in barred) >= len(barred)
    mixed = 2 * len(barred) > sum(bool(line) for line in lines)  # headings may have no bars
    return [_piped_cells(line.strip(), edged) if "|" in line or not mixed else
            gaps if len(gaps := _by_gaps(line)) > 2 else [line] for line in lines]


def _is_rule(line: str) -> bool:
    """Whether a line is drawn, as under a head; a row of single dashes holds zeros."""
    return bool(_RULE.fullmatch(line)) and bool(_DRAWN.search(line))


def _piped_cells(line: str, edged: bool) -> list[str]:
    """The cells between bars; where most lines begin with a bar, it is the table's edge."""
    if "|" not in line:
        return [line]
    cells = re.split(r"(?<!\\)\|", line.removeprefix("|") if edged else line)
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
        if tag in ("td", "th") and not end:
            self._cell(attributes)
        elif tag in _SIGNS and not self._hidden:
            self.write("}" if end else _SIGNS[tag])
        elif tag == "tr":
            self._in_row = not end
            self.lines.append([""] if end else [])
        elif tag in ("script", "style"):
            self._hidden = not end
        elif tag in _BLOCKS and not self._in_row:
            self.lines.append([""])

    def _cell(self, attributes: str) -> None:
        span = _SPAN.search(attributes)
        self.lines[-1].extend([""] * min(int(span[1]) if span else 1, 40))
