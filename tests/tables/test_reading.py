"""Tables as people have them: each kind of text, with what it means typed by hand."""
import random
import re
from dataclasses import replace
from math import pi, radians

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from wild_texts import wild_texts

import kinlab as kl
from kinlab.tables.as_code import to_code
from kinlab.tables.as_csv import to_csv
from kinlab.tables.as_document import to_latex, to_markdown
from kinlab.tables.ends import End
from kinlab.tables.question import Ambiguous
from kinlab.tables.read import read_table
from kinlab.tables.table import DHTable, Place, Row

DEGREES = DHTable((Row(),))
RADIANS = DHTable((Row(),), angles="rad")
LETTERS = {"revolute": "R", "prismatic": "P", "fixed": "F"}


def read(text, like=DEGREES, **choices):
    return read_table(text, like, **choices).table


def told(table):
    """Rows as (joint, theta, d, a, alpha): a letter for the joint, a minus if it is flipped."""
    return [("-" * row.flip + LETTERS[row.kind], row.theta, row.d, row.a, row.alpha)
            for row in table.rows]


# ---- what parts the cells ----

ONE = [("R", "0", "0.1", "0", "90"), ("R", "0", "0", "1", "0")]
FORMS = {
    "commas": "theta,d,a,alpha\n0,0.1,0,90\n0,0,1,0\n",
    "semicolons": "theta;d;a;alpha\r\n0;0.1;0;90\r\n0;0;1;0\r\n",
    "tabs": "theta\td\ta\talpha\n0\t0.1\t0\t90\n0\t0\t1\t0",
    "blanks": "theta d a alpha\n0 0.1 0 90\n0 0 1 0",
    "many blanks": "   theta   d    a   alpha\n\n   0      0.1  0   90\n   0      0    1   0\n",
    "byte order mark": "\ufefftheta,d,a,alpha\n0,0.1,0,90\n0,0,1,0\n",
    "the sep line of Excel": "sep=;\ntheta;d;a;alpha\n0;0.1;0;90\n0;0;1;0\n",
    "Markdown": """
| theta |  d  | a | alpha |
|:-----:|:---:|---|------:|
|   0   | 0.1 | 0 |    90 |
|   0   |  0  | 1 |     0 |""",
    "Markdown without edges": """
theta | d | a | alpha
--- | --- | --- | ---
0 | 0.1 | 0 | 90
0 | 0 | 1 | """,
    "Markdown in a comment": """
% | theta | d | a | alpha |
% |--|--|--|--|
% | 0 | 0.1 | 0 | 90 |
% |0|0|1|0|""",
    "a box": """
┌───┬─────┬───┬────┐
│ θ │  d  │ a │ α  │
├───┼─────┼───┼────┤
│ 0 │ 0.1 │ 0 │ 90 │
│ 0 │  0  │ 1 │  0 │
└───┴─────┴───┴────┘""",
    "org mode": """
| theta | d   | a | alpha |
|-------+-----+---+-------|
| 0     | 0.1 | 0 | 90    |
| 0     | 0   | 1 | 0     |""",
    "LaTeX tabular": r"""
\begin{tabular}{|c|c|c|c|} \hline
$\theta_i$ & $d_i$ & $a_i$ & $\alpha_i$ \\ \hline
0 & 0.1 & 0 & 90 \\[2pt]
0 & 0 & 1 & 0 \\ \hline
\end{tabular}""",
    "LaTeX array": r"\[\begin{array}{cccc}\theta&d&a&\alpha\\0&0.1&0&90\\0&0&1&0\end{array}\]",
    "LaTeX matrix": r"$\begin{bmatrix}\theta & d & a & \alpha\\ 0&0.1&0&90\\ 0&0&1&0\end{bmatrix}$",
    "HTML": """<p>The arm</p><table border=1><tr><th>θ<th>d<th>a<th>α</tr>
<tr><td>0</td><td>0.1</td><td>0</td><td>90</td></tr>
<tr><td>0</td><td>0</td><td>1</td><td>0</td></tr></table>""",
    "turned": "theta, 0, 0\nd, 0.1, 0\na, 0, 1\nalpha, 90, 0\n",
    "an index without a head": "   theta   d  a  alpha\n0   0   0.1  0   90\n1   0    0   1   0\n",
    "words around": """# My arm

Here is its table, measured today:

theta | d | a | alpha
--|--|--|--
0 | 0.1 | 0 | 90
0 | 0 | 1 | 0

The last link, of 1 m, is long.""",
    "blank lines between the rows": "theta,d,a,alpha\n0,0.1,0,90\n\n\n\n0,0,1,0\n",
    "Jira": "||i||theta||d||a||alpha||\n|1|0|0.1|0|90|\n|2|0|0|1|0|",
    "Wikipedia": """{| class="wikitable"
|+ The arm
|-
! i !! θ !! d !! a !! α
|-
| 1 || 0 || 0.1 || 0 || 90
|-
| 2 || 0 || 0 || 1 || 0
|}""",
    "units below the heads": "theta,d,a,alpha\n[deg],[m],[m],[deg]\n0,0.1,0,90\n0,0,1,0\n",
}


@pytest.mark.parametrize("form", FORMS)
def test_a_table_is_read_whatever_parts_its_cells(form):
    assert told(read(FORMS[form])) == ONE


# ---- tables in programs ----

PROGRAMS = {
    "Python lists": """
# DH parameters [theta, d, a, alpha]
dh = [[q[0], 0.1, 0, np.pi / 2],
      [q[1], 0, 1, 0]]""",
    "Python tuples": """
# (theta, d, a, alpha_deg)
LINKS = (
    (0, 0.1, 0, 90),  # shoulder
    (0, 0, 1, 0),     # elbow, the longer one
)""",
    "MATLAB matrix": """
% theta  d  a  alpha
DH = [q1   0.1  0  pi/2;
      q2   0    1  0   ];""",
    "MATLAB links": """
%             th   d    a   alpha
L(1) = Link([ 0    0.1  0   pi/2   0]);
L(2) = Link([ 0    0    1   0      0]);  % the elbow""",
    "numbered names": """
s = {alpha1: 90, a1: 0, d1: 0.1, q1: q1,
     alpha2: 0,  a2: 1, d2: 0,   q2: q2}""",
    "assignments": """
alpha1 = pi/2; a1 = 0; d1 = 0.1;
alpha2 = 0;    a2 = 1; d2 = 0;""",
    "calls with names": """
L1 = RevoluteDH(d=0.1, a=0, alpha=pi/2)
L2 = RevoluteDH(d=0, a=1, alpha=0)""",
    "calls with words": """
L(1) = Link('d', 0.1, 'a', 0, 'alpha', pi/2);
L(2) = Link('d', 0, 'a', 1, 'alpha', 0);""",
    "JSON": """
[{"theta": 0, "d": 0.1, "a": 0, "alpha": 90},
 {"theta": 0, "d": 0, "a": 1, "alpha": 0}]""",
    "YAML": """
joints:
  - {a: 0, alpha: 90, d: 0.1, theta: 0}
  - {a: 1, alpha: 0, d: 0, theta: 0}""",
    "a comment": """
# theta   d    a   alpha
# theta1  0.1  0   90
# theta2  0    1   0""",
}


@pytest.mark.parametrize("form", PROGRAMS)
def test_a_table_in_a_program_is_read_and_never_run(form):
    table = read(PROGRAMS[form])
    assert told(table) == ONE or told(table) == [(*ONE[0][:4], "pi/2"), ONE[1]] or told(
        table) == [(*ONE[0][:4], "pi / 2"), ONE[1]]


@pytest.mark.parametrize("words, angles, unit", [
    ("Angles are in radians", "rad", "m"), ("Lengths in mm; angles in degrees", "deg", "mm"),
    ("Units: lengths in mm, angles in radians", "rad", "mm"),
    ("All dimensions in cm", "deg", "cm")])
def test_comments_above_that_of_the_columns_are_words(words, angles, unit):
    table = read(f"# {words}\n# theta, d, a, alpha\ndh = [[0, 100, 0, 1],\n      [0, 0, 200, 0]]")
    assert told(table) == [("R", "0", "100", "0", "1"), ("R", "0", "0", "200", "0")]
    assert (table.angles, table.unit) == (angles, unit)


@pytest.mark.parametrize("words, convention", [
    ("Modified DH (Craig)", "modified"), ("classical DH", "standard"), ("DH", "standard"),
    ("the distal one", "standard"), ("MDH", "modified")])
def test_a_convention_among_other_words(words, convention):
    assert read(f"Convention: {words}\ntheta,d,a,alpha\n0,1,0,9\n").convention == convention


def test_the_index_before_in_numbered_names_is_modified():
    table = read("{alpha0: 0, a0: 0, d1: 0.75, alpha1: -pi/2, a1: 0.35, d2: 0, q2: q2 - pi/2}")
    assert table.convention == "modified"
    assert [(row.theta, row.d, row.a, row.alpha) for row in table.rows] == [
        ("0", "0.75", "0", "0"), ("-pi/2", "0", "0.35", "-pi/2")]


def test_calls_name_kinds_and_convention():
    table = read("RevoluteMDH(d=0.1, a=0, alpha=0)\nPrismaticMDH(theta=0, a=0.5, alpha=90)")
    assert table.convention == "modified"
    assert [row.kind for row in table.rows] == ["revolute", "prismatic"]


def test_the_fifth_number_of_a_link_is_its_kind():
    text = "% th d a alpha\nL(1) = Link([0 0.1 0 0 0]);\nL(2) = Link([0 0 1 0 1]);"
    assert [row.kind for row in read(text).rows] == ["revolute", "prismatic"]


# ---- headings ----


def test_khalils_d_is_along_x():
    table = read("j;σj;αj;dj;θj;rj\n1;0;0;0;θ1;0.4\n2;1;90;0.3;0;r2\n")
    assert table.convention == "modified"
    assert [(row.kind, row.d, row.a, row.alpha) for row in table.rows] == [
        ("revolute", "0.4", "0", "0"), ("prismatic", "r2", "0.3", "90")]


@pytest.mark.parametrize("extra, cell", [
    ("cos α", "0"), ("DXL angle (rad)", "3"), ("v_max", "2"), ("Link mass", "4"), ("Notes", "a, d"),
    ("Range", "-90 to 90")])
def test_a_column_that_is_no_parameter_is_left_out(extra, cell):
    loaded = read_table(f"{extra};theta;d;a;alpha\n{cell};0;0.1;0;90\n", DEGREES)
    assert told(loaded.table) == ONE[:1]
    assert f"left out: {extra!r}" in loaded.remark


def test_empty_cells_among_variables_are_variables_and_zeros_are_not():
    table = read("θ;d;a;α\n;0.1;0;0\nq2 - 90;0;1;0\n0;0.3;0;0\n")
    assert [(row.kind, row.theta) for row in table.rows] == [
        ("revolute", "0"), ("revolute", "-90"), ("fixed", "0")]


def test_variables_may_count_on_from_another_arm():
    assert not read("θ;d;a;α\nq15;0;0;0\n-90+q16;0;0;0\nq17;0;1;0").errors


@pytest.mark.parametrize("cell, value", [
    ("d1 = 0.75", 0.75), ("$L_{base}$ (1.5)", 1.5), ("**0.5**", 0.5), ("√(0.3²+0.4²)", 0.5),
    ("333 / 1000.0", 0.333), ("`0.25`", 0.25), ("cos(0)", 1), ("1e3", 1000), ("2.5e-2", 0.025),
    ("0.5 (m)", 0.5), ("0.1 [m]", 0.1)])
def test_a_length_beside_its_name_or_worked_out(cell, value):
    table = read(f"θ;d;a;α\nq1;{cell};0;90")
    assert table.values[Place(1, "d")] == pytest.approx(value, rel=1e-15) and not table.lengths


@pytest.mark.parametrize("cell", ["rand(5)", "tan(1)", "alert(1)"])
def test_a_function_is_no_symbol_with_its_value(cell):
    assert Place(1, "d") in read(f"θ;d;a;α\nq1;{cell};0;90").errors


@pytest.mark.parametrize("theta, d, a, alpha", [
    ("teta", "d", "a", "al"),
    ("θ", "d", "a", "α"), ("Theta", "D", "A", "Alpha"), ("θ*", "d", "r", "α"), ("th", "s", "a",
                                                                                "alfa"),
    ("theta_i", "d_i", "a_i", "alpha_i"), ("θᵢ", "dᵢ", "aᵢ", "αᵢ"), ("θ(i)", "d(i)", "a(i)",
                                                                     "α(i)"),
    ("joint angle", "link offset", "link length", "link twist"), ("Angle", "Offset", "Length",
                                                                  "Twist"),
    ("Joint angle θ_i", "Link offset d_i", "Link length a_i", "Link twist α_i"), ("q", "b", "a",
                                                                                  "α"),
    ("Gelenkwinkel", "Gelenkversatz", "Gliedlänge", "Verwindung"),
    (r"$\theta_{i}$", r"$d_{i}$", r"$a_{i}$", r"$\alpha_{i}$"), ("**θ**", "**d**", "**a**",
                                                                 "**α**"),
    ("θ<sub>i</sub>", "d<sub>i</sub>", "a<sub>i</sub>", "α<sub>i</sub>"), ("𝜃", "𝑑", "𝑎", "𝛼"),
    ("Joint angle (θ)", "Offset (d)", "Length (a)", "Twist (α)")])
def test_headings_in_all_usual_spellings(theta, d, a, alpha):
    table = read(f"{d};{theta};{alpha};{a}\n0.1;30;90;2\n")
    assert told(table) == [("R", "30", "0.1", "2", "90")]
    assert table.convention == "standard"


@pytest.mark.parametrize("alpha, a", [
    ("alpha(i-1)", "a(i-1)"), ("α(i-1)", "a(i-1)"), ("alpha_{i-1}", "a_{i-1}"), ("α_{i−1}",
                                                                                 "a_{i−1}"),
    ("αᵢ₋₁", "aᵢ₋₁"), ("alpha_i-1", "a_i-1"), ("alpha i-1", "a i-1"), ("αi−1", "ai−1"),
    ("alpha_{n-1}", "a_{n-1}"), ("alpha_im1", "a_im1"), ("alphai_1", "ai_1"),
    ("alpha_prev", "a_prev"),
    (r"$\alpha_{i-1}$", "$a_{i-1}$"), ("α<sub>i-1</sub>", "a<sub>i-1</sub>"), ("α (i-1) [deg]",
                                                                               "a (i-1) [m]")])
def test_the_index_before_is_the_modified_convention(alpha, a):
    table = read(f"i;{alpha};{a};d(i);theta(i)\n1;0;0;0.75;0\n2;-pi/2;0.35;0;-pi/2\n")
    assert table.convention == "modified"
    assert told(table) == [("R", "0", "0.75", "0", "0"), ("R", "-pi/2", "0", "0.35", "-pi/2")]


@pytest.mark.parametrize("head, expected", [
    ("theta,d,a,alpha,offset\nq1,0.1,0,90,45", ("R", "45", "0.1", "0", "90")),   # theta's own
    ("offset,d,a,alpha\n45,0.1,0,90", ("R", "45", "0.1", "0", "90")),            # theta's
    ("theta,offset,a,alpha\n45,0.1,0,90", ("R", "45", "0.1", "0", "90"))])       # d's
def test_an_offset_belongs_to_what_is_not_there(head, expected):
    assert told(read(head)) == [expected]


@pytest.mark.parametrize("label", ["i", "Joint", "Link", "#", "", "Frame", "No.", "Gelenk",
                                   "Joint i"])
@pytest.mark.parametrize("first, second", [("1", "2"), ("J1", "J2"), ("Link 1", "Link 2"), ("0-1",
                                                                                            "1-2"),
                                           ("0→1", "1→2"), ("1.", "2.")])
def test_labels_are_only_labels(label, first, second):
    table = read(f"{label},theta,d,a,alpha\n{first},0,0.1,0,90\n{second},0,0,1,0\n")
    assert told(table) == ONE
    assert [row.name for row in table.rows] == ["", ""]


def test_labels_that_are_words_are_names():
    table = read("Joint,theta,d,a,alpha\nShoulder pan,0,0.1,0,90\nElbow,0,0,1,0\n")
    assert [row.name for row in table.rows] == ["Shoulder pan", "Elbow"]


def test_other_columns_are_left_out_and_named():
    loaded = read_table("theta,d,a,alpha,mass\n0,0.1,0,90,4\n", DEGREES)
    assert told(loaded.table) == ONE[:1] and "left out: 'mass'" in loaded.remark


# ---- units ----


@pytest.mark.parametrize("heads, angles, unit", [
    ("θ [°],d [mm],a [mm],α [°]", "deg", "mm"), ("theta (rad),d (m),a (m),alpha (rad)", "rad", "m"),
    ("θ (deg),d (cm),a (cm),α (deg)", "deg", "cm"), ("θ / °,d / mm,a / mm,α / °", "deg", "mm"),
    ("theta in rad,d in mm,a in mm,alpha in rad", "rad", "mm"), ("θ rad,d mm,a mm,α rad", "rad",
                                                                 "mm"),
    ("theta [radians],d [inches],a [inches],alpha [radians]", "rad", "in"),
    ("θ°,d(mm),a(mm),α°", "deg", "mm")])
def test_units_are_taken_from_the_headings(heads, angles, unit):
    for like in (DEGREES, RADIANS):
        table = read(f"{heads}\n0,100,0,90\n", like)
        assert (table.angles, table.unit) == (angles, unit)
        assert table.values[Place(1, "alpha")] == (90 if angles == "rad" else pi / 2)


def test_columns_in_two_units_become_one():
    table = read("theta (rad),d [mm],a (m),alpha [deg]\n1.5,100,0.5,-90\n")
    assert (table.angles, table.unit) == ("rad", "mm")
    assert told(table) == [("R", "1.5", "100", "500", "-pi/2")]


@pytest.mark.parametrize("words, angles, unit", [
    ("Angles in degrees, lengths in mm:", "deg", "mm"), ("All angles are given in radians.", "rad",
                                                         "m"),
    ("DH parameters (lengths in millimeters)", "deg", "mm"), ("angles: radians\nlengths: cm",
                                                              "rad", "cm"),
    ("angles,degrees\nunit,mm,,", "deg", "mm"), ("Units: meters and radians", "rad", "m"),
    ("Units: lengths in mm, angles in degrees", "deg", "mm"), ("units: mm, rad", "rad", "mm"),
    ("Units: inches", "deg", "in")])
def test_units_are_taken_from_the_words_above(words, angles, unit):
    table = read(f"{words}\n\ntheta,d,a,alpha\n0,100,0,1\n")
    assert (table.angles, table.unit) == (angles, unit)


def test_units_in_the_cells():
    table = read("theta,d,a,alpha\n0°,100 mm,0,90°\n0.5 rad,0,0.2 m,-45 deg\n")
    assert table.unit == "mm" and table.angles == "deg"
    assert told(table) == [("R", "0", "100", "0", "90"), ("R", "0.5 rad", "0", "200", "-45")]
    assert told(read("θ,d,a,α\nq1,1,0,90°\n", RADIANS))[0][4] == "pi/2"


@pytest.mark.parametrize("like", [DEGREES, RADIANS, replace(RADIANS, convention="modified",
                                                            unit="mm")])
def test_what_a_text_leaves_open_is_as_it_was(like):
    table = read("theta,d,a,alpha\n0,L1,0,pi/2\n", replace(like, lengths=(("L1", "0.5"),)))
    assert (table.angles, table.convention, table.unit, table.lengths) == (
        like.angles, like.convention, like.unit, (("L1", "0.5"),))


def test_radians_stay_radians():
    arm = read("theta,d,a,alpha\n0,0.1,0,1.5708\n0,0,1,0\n", RADIANS).arm
    assert arm.links[0].alpha == 1.5708


# ---- numbers ----


@pytest.mark.parametrize("cell, text", [
    ("−90", "-90"), ("–90", "-90"), ("pi/2", "pi/2"), ("π/2", "pi/2"), ("-π/2", "-pi/2"), ("½π",
                                                                                           "1/2*pi"),
    (r"$\pi$", "pi"), (r"-\frac{\pi}{2}", "-pi/2"), (r"$-\pi/2$", "-pi/2"), (r"$90^\circ$", "90"),
    (r"90^{\circ}", "90"), ("3π/2", "3*pi/2"), ("0.5pi", "0.5*pi"), ("2*pi/3", "2*pi/3"), ("+90",
                                                                                           "+90"),
    (r"\tfrac{3\pi}{2}", "3*pi/2"), ("90º", "90"), ("90 degrees", "90"), ("-90deg", "-90"),
    ("1 radian", "1 rad"), ("-", "0"), ("–", "0"), ("—", "0"), ("", "0"),
    ("-90,5", "-90.5"), ("- 90", "- 90")])
def test_angles_as_people_write_them(cell, text):
    table = read(f"theta;d;a;alpha\n0;0.1;0;{cell}\n0;0;1;0")
    assert told(table)[0] == ("R", "0", "0.1", "0", text)
    assert not table.errors


@pytest.mark.parametrize("cells, texts", [
    (("0,5", "12,25"), ("0.5", "12.25")), (("1,250", "0,5"), ("1.250", "0.5")),
    (("1,250", "0.5"), ("1250", "0.5")), (("1.250,5", "3"), ("1250.5", "3")),
    (("1,250,000", "3"), ("1250000", "3")), (("0,250", "0"), ("0.250", "0"))])
def test_decimal_commas_where_they_are_plain(cells, texts):
    assert told(read(f"theta;d;a;alpha\n0;{cells[0]};{cells[1]};90\n"))[0][2:4] == texts


def test_a_comma_beside_no_digits_is_not_asked_for():
    assert Place(1, "alpha") in read("theta;d;a;alpha\n0;1;0;[-90, 90]\n").errors


def test_a_comma_that_may_part_thousands_is_asked_for():
    text = "theta;d;a;alpha\n0;1,250;0;90\n"
    with pytest.raises(ValueError, match=r"Is 1,250 a decimal number") as asked:
        read(text)
    assert [told(read(text, **choices))[0][2] for _, choices in asked.value.options] == ["1.250",
                                                                                         "1250"]


# ---- the joint variable ----


@pytest.mark.parametrize("cell, joint, offset", [
    ("q2", "R", "0"), ("θ2", "R", "0"), ("θ2*", "R", "0"), ("theta2", "R", "0"), ("theta_2", "R",
                                                                                  "0"),
    ("θ₂", "R", "0"), (r"$\theta_{2}$", "R", "0"), (r"$\theta_2^*$", "R", "0"), ("q_2", "R", "0"),
    ("q2 - 90", "R", "-90"), ("q2-90", "R", "-90"), ("θ2 + π/2", "R", "pi/2"), ("-90 + q2", "R",
                                                                                "-90"),
    ("90 - q2", "-R", "90"), ("-q2", "-R", "0"), ("−θ2*", "-R", "0"), ("-q2 + 90", "-R", "90"),
    (r"q_2-\frac{\pi}{2}", "R", "-pi/2"), ("*", "R", "0"), ("var", "R", "0"), ("θ*", "R", "0"),
    ("90*", "R", "90"), ("θ2 - 90°", "R", "-90"), ("(q2 + 90)", "R", "90"), ("θ2* 30", "R", "30"),
    ("θ<sub>2</sub> + 90", "R", "90"), ("q[1]", "R", "0"), ("theta2(t)", "R", "0")])
def test_the_joint_variable_in_its_own_cell(cell, joint, offset):
    first = "q[0]" if "[" in cell else "q1"
    table = read(f"theta;d;a;alpha\n{first};0.1;0;90\n{cell};0;1;0")
    assert told(table) == [ONE[0], (joint, offset, "0", "1", "0")]
    assert not table.errors


@pytest.mark.parametrize("cell, offset", [
    ("d2*", "0"), ("q2", "0"), ("d2", "0"), ("d_2^*", "0"), ("*", "0"), ("d2 + 0.1", "0.1"),
    ("0.1 + q2", "0.1")])
def test_a_variable_under_d_slides(cell, offset):
    loaded = read_table(f"theta;d;a;alpha\nq1;0.1;0;90\n90;{cell};1;0", DEGREES)
    assert told(loaded.table) == [ONE[0], ("P", "90", offset, "1", "0")]
    assert "row 2 slides" in loaded.remark


def test_a_flipped_slide():
    assert told(read("θ;d;a;α\n0;-d1*;0;0"))[0] == ("-P", "0", "0", "0", "0")


def test_a_row_without_a_variable_among_others_is_fixed():
    loaded = read_table("θ;d;a;α\nq1;0.1;0;90\n0;0.3;0;0", DEGREES)
    assert told(loaded.table) == [ONE[0], ("F", "0", "0.3", "0", "0")]
    assert loaded.remark.endswith("row 2 is fixed.")


@pytest.mark.parametrize("cell", ["q1", "θ3", "q2 + q3", "2*q2"])
def test_the_variable_of_another_joint_is_an_error_in_its_cell(cell):
    table = read(f"θ;d;a;α\nq1;0.1;0;90\n{cell};0;1;0")
    assert Place(2, "theta") in table.errors and len(table.errors) == 1


@pytest.mark.parametrize("first", [0, 1])
def test_variables_may_count_from_zero(first):
    assert not read(f"θ;d;a;α\nq{first};0;0;0\nq{first + 1};0;0;0").errors


@pytest.mark.parametrize("heads, words, letters", [
    ("type", ("R", "P", "F"), "RPF"), ("joint", ("revolute", "prismatic", "fixed"), "RPF"),
    ("σ", ("0", "1", "0"), "RPR"), ("Joint type", ("Revolute", "Prismatic", "Revolute"), "RPR"),
    ("Gelenktyp", ("rotatorisch", "translatorisch", "fest"), "RPF"), ("Joint", ("R", "R", "P"),
                                                                      "RRP")])
def test_kinds_of_joints(heads, words, letters):
    table = read(f"{heads},theta,d,a,alpha\n" + "".join(f"{word},0,1,0,0\n" for word in words))
    assert "".join(LETTERS[row.kind] for row in table.rows) == letters


def test_a_kind_that_nobody_knows_is_refused():
    with pytest.raises(ValueError,
                       match="line 2 has a joint 'screw'; expected revolute, prismatic"):
        read("type,theta,d,a,alpha\nscrew,0,1,0,0\n")


def test_a_label_tool_is_a_name():
    table = read("Link,θ,d,a,α\nBase,q1,0.1,0,90\nTool,0,0.2,0,0")
    assert [(row.name, row.kind) for row in table.rows] == [("Base", "revolute"), ("Tool", "fixed")]


@pytest.mark.parametrize("text", [
    "type,theta,d,a,alpha,low,high,home\nR,0,1,0,0,-1,1,0\nfixed,0,1,0,0,-1,1,0.5\n",
    "convention,standard\nangles,deg\nlengths,m\njoint,flip,theta,d,a,alpha,low,high\n"
    "revolute,,0,1,0,0,-1,1\nfixed,-,0,1,0,0,-1,1\n"])
def test_limits_of_a_fixed_row_are_kept_and_marked(text):
    table = read(text)
    assert (table.rows[1].low, table.rows[1].high) == ("-1", "1")
    assert {place.row for place in table.errors} == {2}
    assert {"low", "high"} <= {place.column for place in table.errors}


# ---- named lengths ----


def test_lengths_that_are_named_stay_names():
    like = replace(DEGREES, lengths=(("L1", "0.5"), ("a2", "0.3")))
    table = read("θ;d;a;α\nq1;L_1;0;90\nq2;0;$a_{2}$;0\nq3;0;2L1;0", like)
    assert [row.d for row in table.rows] == ["L1", "0", "0"]
    assert [row.a for row in table.rows] == ["0", "a2", "2*L1"]
    assert not table.errors


def test_lengths_without_a_value_wait_for_it():
    loaded = read_table("θ;d;a;α\nq1;d_1;0;90\nq2;0;a_2;0\n\nwith d_1 = 0.4\n", DEGREES)
    assert loaded.table.lengths == (("d1", "0.4"), ("a2", ""))
    assert loaded.remark.endswith("give a2 a value.")
    assert loaded.table.errors[Place(2, "a")] == "give 'a2' a value first"
    assert not loaded.table.with_length(2, "a2", "0.3").errors


def test_a_second_table_is_left_out_and_named():
    loaded = read_table("theta,d,a,alpha\n0,0.1,0,90\n0,0,1,0\n\ntheta,d,a,alpha\n0,5,5,5", DEGREES)
    assert told(loaded.table) == ONE and loaded.remark.endswith("; the first of the tables.")


# ---- what is asked ----


@pytest.mark.parametrize("like, cell, options", [
    (DEGREES, "1.5708", ["degrees", "radians"]), (DEGREES, "-1.571", ["degrees", "radians"]),
    (RADIANS, "90", ["degrees", "radians"]), (RADIANS, "-180", ["degrees", "radians"])])
def test_a_unit_that_the_numbers_speak_against_is_asked_for(like, cell, options):
    text = f"theta,d,a,alpha\n0,0.1,0,{cell}\n"
    with pytest.raises(Ambiguous) as asked:
        read(text, like)
    assert [label for label, _ in asked.value.options] == options
    assert [read(text, like, **choices).angles for _, choices in asked.value.options] == ["deg",
                                                                                          "rad"]
    assert len(str(asked.value).splitlines()) == 1


@pytest.mark.parametrize("like, cell", [(DEGREES, "90"), (DEGREES, "1.5"), (RADIANS, "1.5708"),
                                        (DEGREES, "pi/2"), (RADIANS, "90 deg"), (DEGREES, "45.5")])
def test_what_is_plain_is_not_asked_for(like, cell):
    assert read(f"theta,d,a,alpha\n0,0.1,0,{cell}\n", like).angles == like.angles


def test_columns_without_headings_are_asked_for():
    with pytest.raises(Ambiguous) as asked:
        read("0,0.1,0,90\n0,0,1,0\n")
    assert ("theta d a alpha", {"columns": "theta d a alpha"}) in asked.value.options
    assert told(read("0,0.1,0,90\n0,0,1,0\n", columns="theta d a alpha")) == ONE
    assert told(read("0 0 0.1 0\n90 1 0 0", columns="alpha a d theta"))[1] == ("R", "0", "0", "1",
                                                                               "90")


def test_columns_are_not_asked_for_where_the_cells_say_it():
    loaded = read_table("90 0 0.1 q1\npi/2 1 0 q2", DEGREES)
    assert told(loaded.table) == [ONE[0], ("R", "0", "0", "1", "pi/2")]
    assert "columns read as alpha a d theta" in loaded.remark


def test_headings_against_words_are_asked_for():
    text = "Standard DH parameters:\ni,alpha(i-1),a(i-1),d,theta\n1,0,0,1,0\n"
    with pytest.raises(Ambiguous, match="Which convention"):
        read(text)
    assert read(text, convention="standard").convention == "standard"


@pytest.mark.parametrize("choices", [{"angles": "grad"}, {"convention": "craig"}, {"decimal": ";"},
                                     {"columns": "a b c d"}, {"unit": "mm"}, {"columns": 3}])
def test_choices_are_checked(choices):
    with pytest.raises(ValueError, match="expected"):
        read("theta,d,a,alpha\n0,1,0,90\n", **choices)


# ---- what is said, and what is refused ----


@pytest.mark.parametrize("text, remark", [
    ("i,alpha(i-1),a(i-1),d,theta\n1,0,0,1,0\n2,90,0,d2*,0\n3,0,0,0,q3",
     "Read as modified DH, angles in degrees, lengths in m; row 1 is fixed; row 2 slides."),
    ("θ (rad),d [mm],a,α\n-q1,1,0,0\n", "Read as standard DH, angles in radians, lengths in mm; "
                                         "row 1 counts the other way.")])
def test_what_was_assumed_is_said_in_one_line(text, remark):
    said = read_table(text, DEGREES).remark
    assert sorted(re.split("[;.] ?", said)) == sorted(re.split("[;.] ?", remark))
    assert len(said.splitlines()) == 1


@pytest.mark.parametrize("word, convention, angles", [
    ("convention,Modified", "modified", "deg"), ("convention,Craig", "modified", "deg"),
    ("convention: standard", "standard", "deg"), ("angles,degrees", "standard", "deg"),
    ("angles,Radians", "standard", "rad"), ("Angles;rad", "standard", "rad")])
def test_words_that_are_nearly_right(word, convention, angles):
    table = read(f"{word}\n" + "theta,d,a,alpha\n0,1,0,90\n".replace(",",
                                                                     ";" if ";" in word else ","))
    assert (table.convention, table.angles) == (convention, angles)


@pytest.mark.parametrize("text, reason", [
    ("", "no such header"), ("1,2,3", "no such header"), ("theta,alpha\n",
                                                              "no line under it"),
    ("alpha,theta,alpha\n1,2,3", "'alpha' twice"), ("alpha,d\n1,2,3", "line 2 has 3 cells under 2"),
    ("theta,d,a,alpha [mm]\n0,0,0,0", "expected an angle in deg or rad"),
    ("theta,d [deg],a,alpha\n0,0,0,0", "or a length in mm"),
    ("convention,hayati\ntheta,alpha\n1,2",
     "convention is 'hayati'; expected standard or modified"),
    ("angles,gon\ntheta,alpha\n1,2", "angles is 'gon'; expected deg or rad"),
    ("tool,1,2\ntheta,alpha\n1,2", "tool: expected"), ("tool,a\ntheta,alpha\n1,2",
                                                       "tool: expected 16"),
    ("theta,alpha\n" + "0,0\n" * 61, "1 to 60 rows"), (3, "text: expected"), (None,
                                                                              "text: expected"),
    ("x" * 100_001, "100000"), ("theta,alpha\n0," + "0" * 300, "at most 200 characters"),
    ("This is no table. It has words, and commas, and more.", "no such header")])
def test_what_is_no_table_is_refused_in_one_line(text, reason):
    with pytest.raises(ValueError, match=reason) as caught:
        read(text)
    assert len(str(caught.value).splitlines()) == 1


# ---- what kinlab writes ----

words = st.text(max_size=12).map(lambda text: " ".join(
    "".join(c if c.isprintable() else " " for c in text).split())) | st.sampled_from(
    ["a|b", "x & y", "\\", "\\\\ \\hline", '"', "'", "a,b", "100 %", "$\\pi$", "<b>", "- name: x",
     "`", "#",
     "[x](y)", "~^_{}", "\\textbackslash{}", "θ2* 0", "|", "||", "=1+1", "sep=;"])
numbers = st.sampled_from(["0", "-90", "pi/2", "-2*pi/3", "0.1", "1e-3", "L1 + 0.5", "2*L1", "1,5",
                           "-", "q1",
                           "θ2*", "90 deg", "d2*"]) | words.filter(bool)


@st.composite
def rows(draw):
    kind = draw(st.sampled_from(["revolute", "prismatic", "fixed"]))
    row = Row(kind, *(draw(numbers) for _ in range(4)), name=draw(words))
    if kind == "fixed":
        return row
    limits = draw(st.sampled_from([("", ""), ("-1", "2"), ("0.5", "0.5"), ("x", "")]))
    return replace(row, low=limits[0], high=limits[1], home=draw(st.sampled_from(["", "0", "0.7",
                                                                                  "?"])),
                   flip=draw(st.booleans()))


frames = st.sampled_from([
    None, End(given=((1.0, 0.0, 0.0, 0.1), (0.0, 0.0, -1.0, 1 / 3), (0.0, 1.0, 0.0, -2e-7),
                     (0.0, 0.0, 0.0, 1.0))),
    End(("0", "L1", "0.303", "0", "-90", "")), End(("a|b", ",", "&", '"'))])
typed = st.builds(DHTable, st.lists(rows(), min_size=1, max_size=6).map(tuple),
                  st.sampled_from(["standard", "modified"]), st.sampled_from(["deg", "rad"]),
                  st.sampled_from(["m", "mm", "furlong", ""]) | words,
                  st.lists(st.tuples(words, words), max_size=3).map(tuple), words, frames, frames)


@given(typed, st.sampled_from([to_csv, to_markdown, to_latex]))
@settings(deadline=None)
def test_what_is_written_reads_back_as_it_was(table, write):
    loaded = read_table(write(table), DEGREES)
    assert loaded.table == table
    assert loaded.remark == ""


@pytest.mark.parametrize("write", [to_csv, to_markdown, to_latex, to_code])
@pytest.mark.parametrize("joints", [1, 30, 60])
def test_as_many_rows_go_out_as_come_in(write, joints):
    arm = kl.Arm([kl.revolute(a=0.1, alpha=radians(-90), limits=(-1, 2), name="one more")] * joints)
    table = DHTable.of(arm)
    assert read(write(table)) == table


links = st.builds(lambda link, **more: replace(link, **more),
                  st.sampled_from([kl.revolute(theta=pi / 2, d=0.1), kl.prismatic(alpha=-0.3, a=2),
                                   kl.revolute(alpha=radians(37), d=-1 / 3)]),
                  flip=st.booleans(), name=words.map(lambda word: word or None),
                  limits=st.sampled_from([None, (-1.0, 2.0), (0.25, 0.25)])) | st.just(
    kl.fixed(d=0.303, name="hand"))


@given(st.lists(links, min_size=1,
                max_size=6).filter(lambda some: any(link.variable for link in some)),
       st.sampled_from(["standard", "modified"]), st.sampled_from(["deg", "rad"]), words)
@settings(deadline=None)
def test_code_reads_back_as_it_was(some, convention, angles, name):
    table = DHTable.of(kl.Arm(some, convention=convention, name=name), angles)
    assert read_table(to_code(table), table).table == table


def test_a_printed_arm_reads_back():
    arm = kl.Arm([kl.revolute(d=0.5, alpha=pi / 2, flip=True), kl.prismatic(theta=-pi / 4, d=0.25),
                  kl.fixed(a=0.1)], convention="modified", unit="mm", name="Three")
    for text in (str(arm), arm._repr_html_()):
        table = read(text)
        assert told(table) == [("-R", "0", "0.5", "0", "90"), ("P", "-45", "0.25", "0", "0"),
                               ("F", "0", "0", "0.1", "0")]
        assert (table.convention, table.unit, table.name) == ("modified", "mm", "Three")


# ---- whatever is pasted ----


@given(st.integers(0, 2**32))
@settings(deadline=None, max_examples=100)
def test_whatever_is_pasted_is_a_table_a_question_or_one_reason(seed):
    for text in wild_texts(4, random.Random(seed)):
        try:
            assert len(read_table(text, DEGREES).remark.splitlines()) < 2
        except ValueError as error:
            assert len(str(error).splitlines()) == 1, text


@pytest.mark.parametrize("name", ["", "Three"])
def test_a_printed_editor_reads_back(name):
    editor = kl.DHTableEditor(kl.Arm([kl.revolute(d=0.5)], name=name))
    table = read(repr(editor))
    assert told(table) == [("R", "0", "0.5", "0", "0")] and table.name == name


@pytest.mark.parametrize("unit", ["Meter", "mm of the model", "in"])
def test_any_unit_reads_back(unit):
    table = DHTable.of(kl.Arm([kl.revolute(a=1)], unit=unit))
    assert all(read(write(table)) == table for write in (to_csv, to_markdown, to_latex))


def test_a_power_is_not_bold():
    table = read("theta,d,a,alpha\nq1,2**3**1,**0.5**,(2)**2\n")
    assert [table.rows[0].d, table.rows[0].a] == ["2**3**1", "0.5"]
    assert table.arm.links[0].d == 8


def test_a_sentence_below_is_no_row():
    table = read("i theta d a alpha\n1 q1 0.1 0 pi/2\n2 q2 0 1 0\n\nNote: all in m.\n")
    assert [row.d for row in table.rows] == ["0.1", "0"] and not table.errors
