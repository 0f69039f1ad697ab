"""Texts that nobody should paste into a table, and tables of all forms to spoil."""
import random
from math import pi

from typed_numbers import formula, strings

import kinlab as kl
from kinlab.tables.as_csv import to_csv
from kinlab.tables.as_document import to_latex, to_markdown
from kinlab.tables.table import DHTable

PIECES = ["1", "90", ".5", "1e3", "9" * 40, "1e308", "pi", "π", "d2", "q1", "θ2*", "deg", "°",
          " mm",
          "+", "-", "*", "/", "**", "^", "(", ")", "[", "]", "{", "}", ",", ";", "\t", "\n",
          "\r\n", "|",
          "||", "|---|", "&", "\\\\", "\\", "$", "\\frac{", "\\begin{array}{", "\\end{array}",
          "\\multicolumn{9}{c}{", "\\hline", "%", "<table>", "<tr>", "<td>", "</td>",
          "<td colspan=99>",
          "<sub>", "<script>", "<!--", "&lt;", "theta", "alpha(i-1)", "a_{i-1}", "d", "α", "θ [°]",
          "joint", "type", "r", "offset", "name", "low", "convention,", "angles: ", "length,",
          "tool,", "- name: ", "% name: ", "sep=;",
          "\ufeff", "\x00", "\ud800", "١", "½", "²", "🦾", "'", '"',
          "kl.Arm([", "import ", "__import__('os')", "lengths in m, * marks the joint variable",
          " in degrees", "L1 = 0.5", "1,250", "0,5", " ", "  ", "\u00a0", "\u2028", "_", "=", "-1",
          "i-1"]
WRITTEN = [
    "i | alpha_{i-1} | a_{i-1} | d_{i} | theta_{i}\n--- | --- | --- | --- | ---\n"
    "1 | 0 | 0 | 0.75 |\n2 | -pi/2 | 0.35 | 0 | q2 - pi/2\n7 | 0 | 0 | 0.303 | 0\n",
    "sep=;\r\nGelenk;θ [°];d [mm];a [mm];α [°]\r\n1;0;0,5;1.250,75;-90\r\n",
    r"\begin{tabular}{|c|c|c|c|c|}\hline Link & $a_i$ & $\alpha_i$ & $d_i$ & $\theta_i$ \\"
    r"\hline 1 & 0 & $\frac{\pi}{2}$ & $d_1$ & $\theta_1^*$ \\ 2 & 0.4 & 0 & $d_2^*$ & $0$"
    r"\\\end{tabular}",
    "<table><tr><th>θ<sub>i</sub><th>d (m)<th>a<th>α</tr>"
    "<tr><td>q1<td>0.1<td>0<td>90°</tr></table>",
    "Joint theta d a alpha\nshoulder -q1 100mm 0 90°\nelbow q2 - 90 0 L_1 -\nL1 = 0.5\n",
    "┌───┬───┬───┬───┐\n│ θ │ d │ a │ α │\n├───┼───┼───┼───┤\n│ 1 │ 2 │ 3 │ 4 │\n└───┴───┴───┴───┘",
    "0 0.1 0 pi/2\nq2 0 1 0\n", "theta\tq1\tq2\nd\t0.1\t0\na\t0\t1\nalpha\t90\t0\n"]


def tables():
    """Tables as kinlab writes them, and as others do."""
    arms = [kl.robots.alpha_ii(), kl.robots.exam_2018(), kl.robots.practical_six_link(),
            kl.Arm([kl.revolute(a=0.1, alpha=pi / 2, flip=True), kl.fixed(d=0.3)] * 15)]
    made = [DHTable.of(arm) for arm in arms]
    return [*WRITTEN, *map(str, arms), *(arm._repr_html_() for arm in arms),
            *(write(table) for table in made for write in (to_csv, to_markdown, to_latex))]


def wild_texts(count, rng: random.Random):
    """Pieces, characters, what is typed for numbers, tables of it, and spoilt tables; by turns."""
    good, typed = tables(), strings(count)
    for turn, text in enumerate(typed):
        yield (_pieces, _characters, _typed, _cells, _spoilt)[turn % 5](rng, good, text)


def _pieces(rng, *_):
    return "".join(rng.choices(PIECES, k=rng.choice((1, 5, 30, 200, 2000))))


def _characters(rng, *_):
    highest = rng.choice((128, 0x400, 0x110000))
    return "".join(map(chr, rng.choices(range(highest), k=rng.choice((1, 10, 150, 3000)))))


def _typed(rng, _, text):
    return text


def _cells(rng, _, text):
    """A table of formulas, in one of whose cells something is typed."""
    sign = rng.choice((",", ";", "\t", " | ", " & ", "  "))
    rows = [[formula(rng, 2) for _ in range(4)] for _ in range(rng.choice((1, 6, 58)))]
    rng.choice(rows)[rng.randrange(4)] = text
    lines = (sign.join(row) for row in [["theta", "d", "a", "alpha"], *rows])
    return (" \\\\\n" if sign == " & " else "\n").join(lines)


def _spoilt(rng, good, _):
    text = rng.choice(good)
    for _ in range(rng.choice((1, 3, 20))):
        at = rng.randrange(len(text) + 1)
        text = text[:at] + rng.choice(PIECES) * rng.choice((1, 1, 1,
                                                            50)) + text[at + rng.randrange(4):]
    return text
