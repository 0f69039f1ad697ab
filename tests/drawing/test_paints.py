"""One colour for each quantity: readable, told apart, and the same in both hands."""
import re
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

from kinlab.browser import bundle
from kinlab.drawing.paints import COLOURS, PAINTS

LIGHT, DARK = "#ffffff", "#111417"  # papers of live.css and page.css
OKABE_ITO = {"x": "#D55E00", "y": "#009E73", "z": "#0072B2"}
STYLE = (Path(bundle.HERE) / "live.css").read_text(encoding="utf-8")


def linear(colour):
    """Red, green and blue as amounts of light (IEC 61966-2-1)."""
    sent = np.array([int(colour[k:k + 2], 16) for k in (1, 3, 5)]) / 255
    return np.where(sent <= 0.04045, sent / 12.92, ((sent + 0.055) / 1.055) ** 2.4)


def contrast(one, other):
    """WCAG's ratio, 1 to 21."""
    dark, light = sorted(float(linear(c) @ [0.2126, 0.7152, 0.0722]) for c in (one, other))
    return (light + 0.05) / (dark + 0.05)


def lab(colour):
    """CIE L*a*b* under D65."""
    mixed = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    t = mixed @ linear(colour) / [0.9505, 1.0, 1.089]
    x, y, z = np.where(t > 216 / 24389, np.cbrt(t), (24389 / 27 * t + 16) / 116)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


def variables(sheet):
    return dict(re.findall(r"--kl-([a-z-]+): (#[0-9a-f]{6});", sheet))


SHEETS = STYLE.split('[data-jp-theme-light="false"]')
LIGHT_SHEET, DARK_SHEET = map(variables, SHEETS[:2])


def test_the_measures_are_right():
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.01)
    assert lab("#ffffff") == pytest.approx([100, 0, 0], abs=0.02)


def test_axes_have_the_colours_of_the_lectures():
    assert {axis: COLOURS[axis].line for axis in "xyz"} == OKABE_ITO


@pytest.mark.parametrize("name", COLOURS)
def test_words_are_readable_on_both_papers(name):
    assert contrast(COLOURS[name].words, LIGHT) >= 4.5
    assert contrast(COLOURS[name].dark, DARK) >= 4.5


@pytest.mark.parametrize("name", COLOURS)
def test_lines_are_seen_on_both_papers(name):
    least = 2 if name == "pointed" else 3  # what is pointed at is also wider, or lies behind ink
    assert contrast(COLOURS[name].line, LIGHT) >= least
    assert contrast(COLOURS[name].dark, DARK) >= 3


@pytest.mark.parametrize("paper", ["line", "dark"])
def test_quantities_are_told_apart(paper):
    for one, other in combinations(COLOURS, 2):
        apart = lab(getattr(COLOURS[one], paper)) - lab(getattr(COLOURS[other], paper))
        assert np.linalg.norm(apart) > 20, (one, other)


@pytest.mark.parametrize("name", COLOURS)
def test_the_browser_has_the_same_colours(name):
    line, words, dark = (colour.lower() for colour in COLOURS[name])
    assert LIGHT_SHEET[name] == line
    assert DARK_SHEET[name] == dark
    if name != "pointed":  # no words have it
        assert LIGHT_SHEET.get(f"{name}-words", line) == words
        assert DARK_SHEET.get(f"{name}-words", dark) == dark


def test_angles_and_lengths_have_no_colour_of_an_axis():
    used = {style: PAINTS[style]["stroke"] for style in ("arc", "angle", "length", "point", "tool",
                                                         "trace", "target", "miss", "first",
                                                         "second", "limit")}
    assert not set(used.values()) & set(OKABE_ITO.values())
    assert used["arc"] == used["angle"] == used["limit"] == "#7A3E9D"
    assert used["target"] == used["miss"] == "#A3123A"
    assert used["point"] == used["tool"] == used["trace"] == "#B0457F"


@pytest.mark.parametrize("style", ["miss", "second", "limit"])
def test_colour_is_not_the_only_cue(style):
    assert PAINTS[style]["stroke-dasharray"]


@pytest.mark.parametrize("style", [style for style in PAINTS if "words" in PAINTS[style]])
def test_every_style_of_a_quantity_is_taken_over_by_the_theme(style):
    style = style.partition("-")[0]  # "x-wide" is of the classes kl-x and kl-wide
    assert re.search(rf"\.kl-{style}\b[^{{}}]*\{{ --line:", STYLE)
    assert re.search(rf":is\([^)]*\.kl-{style}\b[^)]*\) path \{{ stroke: var\(--line\)", STYLE)


def test_the_legend_names_every_colour():
    from kinlab.drawing.legend import _ENTRIES, colours_picture

    picture = colours_picture()
    assert {name for name, _ in _ENTRIES} - {"miss"} == set(COLOURS)
    shown = {text.get_text(): text.get_color() for text in picture.axes[0].texts if text.get_text()}
    assert shown["angle: a violet arc"] == "#7A3E9D"
    assert shown["x axis, vermilion"] == "#B84F00"
    assert list(shown) == picture.words.split("; ")
    _, metadata = picture._repr_mimebundle_()
    assert metadata["image/png"]["alt"] == f"Legend. {picture.words}"
