"""Photograph every view of every lesson, and measure what can be measured in a picture.

Run with: python docs/contact_sheet.py OUT [--views NAME ...] (needs the `test` extra and Chromium).

    python docs/contact_sheet.py build/sheet                  # all views, a few minutes
    python docs/contact_sheet.py build/sheet --views 04 ring  # whose names hold "04" or "ring"
    python docs/contact_sheet.py build/sheet --widths 390 --themes light
    python docs/contact_sheet.py build/sheet --views 07 --side-by-side firefox webkit chromium

A view is known by its lesson and by the cell that shows it: "04 n-view". They are found by running
the notebooks, so that none is forgotten. OUT gets

- sheet-THEME-WIDTH-K.png: a few views side by side, under their names,
- views/NAME-THEME-WIDTH.png: each page in full,
- measured.csv, which is also printed: a line for each view and width, with

  ========= =====================================================================================
  text      height of the smallest letters in the picture (px); 12 or more is wanted
  page      of the smallest beside it, formulas aside
  overlap   pairs of names in the picture that cover each other by more than 2 px, and the worst
  fill      the longer side of all that is drawn, floor and names aside, as a share of the picture
  outside   what is drawn beyond the picture's edge
  scroll    what is wider than its place, so that one has to scroll sideways
  ========= =====================================================================================

or, where browsers stand side by side, only NAME-THEME-WIDTH.png for each view.
"""
from __future__ import annotations

import argparse
import ast
import contextlib
import csv
import io
import sys
import tempfile
from collections.abc import Sequence
from itertools import product
from pathlib import Path
from typing import Any

import nbformat
from PIL import Image, ImageDraw, ImageFont
from playwright.sync_api import Page
from tqdm import tqdm

from kinlab.course.handout import FOLDER

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tests" / "browser"))

from engines import open_engine  # noqa: E402
from lab import open_browser  # noqa: E402
from measured import DRAWN, MEASURE  # noqa: E402
from reading import RESTED  # noqa: E402

WIDTHS, THEMES = (390, 1280, 1920), ("light", "dark")
HEIGHTS = {390: 844, 1280: 800, 1920: 1080}
TILES = {390: (6, 2), 1280: (3, 3), 1920: (3, 3)}  # columns and rows of a sheet
TILE = {390: 300, 1280: 620, 1920: 620}            # px, width of a tile
TALLEST, TITLE = 1.9, 24                           # of a tile's width; px
COLUMNS = ("view", "width", "text", "page", "overlap", "fill", "outside", "scroll")


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="Photograph and measure the lessons' views.")
    parser.add_argument("out", type=Path, help="folder for the pictures")
    parser.add_argument("--views", nargs="+", default=[""], help="parts of the names to take")
    parser.add_argument("--widths", nargs="+", type=int, default=WIDTHS)
    parser.add_argument("--themes", nargs="+", default=THEMES, choices=THEMES)
    parser.add_argument("--side-by-side", nargs="+", metavar="ENGINE", default=[],
                        help="the same pages in firefox, webkit and chromium")
    asked = parser.parse_args(arguments)
    (asked.out / "views").mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        pages = save_pages(Path(folder), asked.views)
        if asked.side_by_side:
            return side_by_side(pages, asked.out, asked.widths, asked.themes, asked.side_by_side)
        measured = photograph(pages, asked.out, asked.widths, asked.themes)
    for theme in asked.themes:
        for width in asked.widths:
            tile(asked.out, list(pages), theme, width)
    tell(measured, asked.out / "measured.csv")


# ---- The views ---------------------------------------------------------------------------


def save_pages(folder: Path, wanted: Sequence[str]) -> dict[str, Path]:
    """A page of each view, as the lesson's cell leaves it, whose name holds one of the words."""
    pages = {}
    for path in tqdm(sorted(FOLDER.glob("*.ipynb")), "lessons"):
        room: dict[str, Any] = {}
        cells = [cell for cell in nbformat.read(path, as_version=4).cells
                 if cell.cell_type == "code"]
        while cells and not _wanted(path, cells[-1], wanted):
            cells.pop()  # nothing to be seen from here on
        for cell in cells:
            view = _run(cell.source, room)
            if _wanted(path, cell, wanted) and hasattr(view, "save_html"):
                pages[_name(path, cell)] = view.save_html(folder / f"{_name(path, cell)}.html")
    return pages


def _name(path: Path, cell: Any) -> str:
    return f"{path.stem.partition('_')[0]} {cell.id}"


def _wanted(path: Path, cell: Any, words: Sequence[str]) -> bool:
    return any(word in _name(path, cell) for word in words)


def _run(source: str, room: dict[str, Any]) -> Any:
    """What the last line of a cell gives; what the cell prints is dropped."""
    lines = ast.parse(source).body
    last = lines.pop() if lines and isinstance(lines[-1], ast.Expr) else None
    with (contextlib.chdir(FOLDER), contextlib.redirect_stdout(io.StringIO()),
          contextlib.redirect_stderr(io.StringIO())):
        exec(compile(ast.Module(lines, []), "cell", "exec"), room)
        return last and eval(compile(ast.Expression(last.value), "cell", "eval"), room)


# ---- Photographs ---------------------------------------------------------------------------


def photograph(pages: dict[str, Path], out: Path, widths: Sequence[int],
               themes: Sequence[str]) -> list[dict]:
    """Save a picture of each page at each width in each theme; what was measured on them."""
    measured = []
    with open_browser() as browser:
        page = browser.new_page()
        for name, path in tqdm(pages.items(), "photographs"):
            for width in widths:
                _open(page, path, width)
                measured.append({"view": name, "width": width, **page.evaluate(MEASURE)})
                for theme in themes:
                    page.emulate_media(color_scheme=theme)
                    page.evaluate(DRAWN)
                    page.screenshot(path=_photo(out, name, theme, width), full_page=True)
    return measured


def _open(page: Page, path: Path, width: int) -> None:
    page.set_viewport_size({"width": width, "height": HEIGHTS.get(width, 900)})
    page.goto(path.as_uri())
    page.locator(".kl-picture svg").wait_for()
    page.evaluate(DRAWN)


def _photo(out: Path, name: str, theme: str, width: int | str) -> Path:
    return out / "views" / f"{name.replace(' ', '-')}-{theme}-{width}.png"


def side_by_side(pages: dict[str, Path], out: Path, widths: Sequence[int],
                 themes: Sequence[str], engines: Sequence[str]) -> None:
    """Save each page at each width in each theme, as these browsers show it, on one sheet."""
    for engine in engines:
        with open_engine(engine) as page:
            for theme in themes:
                page.look(theme)
                for (name, path), width in product(pages.items(), widths):
                    page.resize(width, HEIGHTS.get(width, 900))
                    page.open(path.as_uri())
                    page.evaluate(RESTED)
                    _photo(out, name, theme, f"{width}-{engine}").write_bytes(page.photo())
    for name, theme, width in product(pages, themes, widths):
        photos = [Image.open(_photo(out, name, theme, f"{width}-{engine}")).convert("RGB")
                  for engine in engines]
        _sheet(engines, photos, len(engines)).save(out / f"{name}-{theme}-{width}.png")


# ---- Sheets --------------------------------------------------------------------------------


def tile(out: Path, names: Sequence[str], theme: str, width: int) -> None:
    """The pictures of a theme and a width, as many on a sheet as can be looked at."""
    columns, rows = TILES.get(width, (3, 3))
    for first in range(0, len(names), columns * rows):
        taken = names[first:first + columns * rows]
        pictures = [_small(_photo(out, name, theme, width), TILE.get(width, 620))
                    for name in taken]
        sheet = _sheet(taken, pictures, columns)
        sheet.save(out / f"sheet-{theme}-{width}-{first // (columns * rows) + 1}.png")


def _small(path: Path, width: int) -> Image.Image:
    picture = Image.open(path).convert("RGB")
    small = picture.resize((width, round(picture.height * width / picture.width)),
                           Image.Resampling.LANCZOS)
    return small.crop((0, 0, width, min(small.height, round(TALLEST * width))))


def _sheet(names: Sequence[str], pictures: Sequence[Image.Image], columns: int) -> Image.Image:
    width = pictures[0].width
    lines = [range(k, min(k + columns, len(pictures))) for k in range(0, len(pictures), columns)]
    heights = [TITLE + max(pictures[k].height for k in line) for line in lines]
    sheet = Image.new("RGB", (columns * (width + 8), sum(heights)), "#888888")
    pen, font, top = ImageDraw.Draw(sheet), ImageFont.load_default(16), 0
    for line, height in zip(lines, heights):
        for column, k in enumerate(line):
            pen.text((column * (width + 8) + 4, top + 3), names[k], "white", font)
            sheet.paste(pictures[k], (column * (width + 8), top + TITLE))
        top += height
    return sheet


def tell(measured: Sequence[dict], path: Path) -> None:
    """Print what was measured, and save it as a table."""
    with path.open("w", newline="") as file:
        table = csv.DictWriter(file, COLUMNS)
        table.writeheader()
        table.writerows(measured)
    print(f"{'view':22} width  text  page  fill  overlap | outside | scroll")
    for row in measured:
        print(f"{row['view']:22} {row['width']:5} {row['text']:>5} {row['page']:>5} "
              f"{row['fill']:>5}  {row['overlap']} | {row['outside']} | {row['scroll']}")


if __name__ == "__main__":
    main()
