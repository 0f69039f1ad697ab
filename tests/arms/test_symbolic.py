"""Closed forms: the lectures' own matrices as text, and every form equal to the numbers."""
import math
import re
from dataclasses import replace
from math import pi, radians

import numpy as np
import pytest
import sympy as sp
import textbook
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import arms, exact_angles, poses, right_angles, typed_lengths

import kinlab as kl
from kinlab.arms import notation
from kinlab.arms.rounded import looks_rounded, plain_angle
from kinlab.arms.symbolic import exact_angle, exact_length

close = np.testing.assert_allclose
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
course = pytest.mark.parametrize("robot", COURSE, ids=lambda robot: robot.__name__)

# Twists of any multiple of 15 degrees make long forms, so these arms are short.
exact_arms = (
    arms(angle=exact_angles, length=typed_lengths, most=3, ends=None)
    | arms(angle=right_angles, length=typed_lengths, most=5,
           ends=lambda: poses(right_angles, typed_lengths)))

# Lecture 2.8, T_base^tool of the Alpha II, entry by entry.
ALPHA_II = (
    ("C1*C234*C5 + S1*S5", "-C1*C234*S5 + S1*C5", "-C1*S234",
     "C1*(177.8*C2 + 177.8*C23 - 129.5*S234)"),
    ("S1*C234*C5 - C1*S5", "-S1*C234*S5 - C1*C5", "-S1*S234",
     "S1*(177.8*C2 + 177.8*C23 - 129.5*S234)"),
    ("-S234*C5", "S234*S5", "-C234", "215 - 177.8*S2 - 177.8*S23 - 129.5*C234"),
    ("0", "0", "0", "1"))


def stretch(arm, q, start, stop):
    """T_start^stop from the textbook's frames; `stop` None is the tool."""
    frames = textbook.frames(arm, q)
    first = frames[start] if start else np.eye(4)
    return np.linalg.inv(first) @ frames[-1 if stop is None else stop]


def values(form, q):
    return dict(zip(form.joints, q)) | form.lengths


def numbers(form, q):
    names = values(form, q)
    evaluate = sp.lambdify([*names], form.matrix.tolist(), "math")
    return np.array(evaluate(*names.values()), dtype=float)


def read(entry, form, q):
    """What a student's eye makes of an entry: C23 is cos(theta_2 + theta_3), and so on."""
    def trig(match):
        letter, index = match.groups()
        pattern = r"[+-]?\d+" if len(q) > 9 or "(" in index else r"\d"
        places = [int(place) for place in re.findall(pattern, index)]
        angle = sum(math.copysign(q[abs(place) - 1], place * q[abs(place) - 1]) for place in places)
        return f"({(math.cos if letter == 'C' else math.sin)(angle)!r})"

    names = {str(symbol).replace("_", ""): value for symbol, value in values(form, q).items()}
    names |= {str(symbol): value for symbol, value in values(form, q).items()}
    entry = re.sub(r"\b([CS])(\d[\d,]*|\([^()]*\))", trig, entry)
    return eval(entry, {"cos": math.cos, "sin": math.sin, "sqrt": math.sqrt, "pi": pi}, names)


def plain(latex):
    """LaTeX of an entry as plain text."""
    latex = latex.replace(r"\left", "").replace(r"\right", "").replace(r"\theta", "theta")
    latex = re.sub(r"\\sqrt\{(\d+)\}", r"sqrt(\1)", latex).replace(r"\pi", "pi")
    latex = re.sub(r"\\frac\{([^{}]+)\}\{([^{}]+)\}", r"((\1)/(\2))", latex)
    latex = re.sub(r"\b(\w+)_\{([^{}]*)\}", r"\1\2", latex)
    latex = re.sub(r"\\(cos|sin)\{(\(.*?\))\}", r"\1\2", latex)
    latex = re.sub(r"\s*([()])\s*", lambda m: m.group().strip() if m.group(1) == ")" and
                   not m.group().endswith(" ") else m.group(), latex)
    return re.sub(r"(?<=[\w)]) +(?=[\w(])", "*", latex)


def meant(arm):
    """The arm with the angles that its rounded ones stand for; itself if there are none."""
    def angle(value):
        return float(plain_angle(value) * pi) if looks_rounded(value) else value

    links = [replace(link, theta=angle(link.theta), alpha=angle(link.alpha)) for link in arm.links]
    return arm if links == [*arm.links] else replace(arm, links=links)


def joint_array(arm, seed=0):
    return np.random.default_rng(seed).uniform(-3, 3, arm.n).tolist()


def test_alpha_ii_in_the_lectures_form():
    assert kl.closed_form(kl.robots.alpha_ii()).entries == ALPHA_II
    assert kl.closed_form(kl.robots.alpha_ii(), 0, 5).entries == ALPHA_II


def test_alpha_ii_with_symbols():
    form = kl.closed_form(kl.robots.alpha_ii(), lengths="symbols")
    assert [row[3] for row in form.entries] == [
        "C1*(a2*C2 + a3*C23 - d5*S234)", "S1*(a2*C2 + a3*C23 - d5*S234)",
        "d1 - a2*S2 - a3*S23 - d5*C234", "1"]
    assert [row[:3] for row in form.entries] == [row[:3] for row in ALPHA_II]
    assert {str(k): v for k, v in form.lengths.items()} == {
        "d_1": 215, "a_2": 177.8, "a_3": 177.8, "d_5": 129.5}


def test_alpha_ii_base_to_wrist():
    assert kl.closed_form(kl.robots.alpha_ii(), 0, 3, lengths="symbols").entries == (
        ("C1*C23", "-C1*S23", "-S1", "C1*(a2*C2 + a3*C23)"),
        ("S1*C23", "-S1*S23", "C1", "S1*(a2*C2 + a3*C23)"),
        ("-S23", "-C23", "0", "d1 - a2*S2 - a3*S23"),
        ("0", "0", "0", "1"))


def test_alpha_ii_wrist_to_tool():
    form = kl.closed_form(kl.robots.alpha_ii(), 3, 5, lengths="symbols")
    assert form.entries == (
        ("C4*C5", "-C4*S5", "-S4", "-d5*S4"), ("S4*C5", "-S4*S5", "C4", "d5*C4"),
        ("-S5", "-C5", "0", "0"), ("0", "0", "0", "1"))
    assert form.text.splitlines() == [
        "[C4*C5, -C4*S5, -S4, -d5*S4]", "[S4*C5, -S4*S5, C4 , d5*C4]",
        "[-S5  , -C5   , 0  , 0]", "[0    , 0     , 0  , 1]"]
    assert repr(form) == form.text


def test_the_links_of_the_alpha_ii():
    arm = kl.robots.alpha_ii()
    assert kl.closed_form(arm, 0, 1, lengths="symbols").entries == (
        ("C1", "0", "-S1", "0"), ("S1", "0", "C1", "0"), ("0", "-1", "0", "d1"),
        ("0", "0", "0", "1"))
    assert kl.closed_form(arm, 1, 2, lengths="symbols").entries == (
        ("C2", "-S2", "0", "a2*C2"), ("S2", "C2", "0", "a2*S2"), ("0", "0", "1", "0"),
        ("0", "0", "0", "1"))


def test_alpha_ii_in_latex():
    form = kl.closed_form(kl.robots.alpha_ii())
    assert form.latex.startswith(r"\begin{bmatrix}C_{1} C_{234} C_{5} + S_{1} S_{5} & ")
    assert r" & C_{1} \left(177.8 C_{2} + 177.8 C_{23} - 129.5 S_{234}\right) \\ " in form.latex
    assert form.latex.endswith(r" \\ 0 & 0 & 0 & 1\end{bmatrix}")
    assert form._repr_latex_() == f"$\\displaystyle {form.latex}$"
    symbols = kl.closed_form(kl.robots.alpha_ii(), lengths="symbols")
    assert r"d_{1} - a_{2} S_{2} - a_{3} S_{23} - d_{5} C_{234}" in symbols.latex


def test_two_link():
    assert kl.closed_form(kl.robots.two_link(), lengths="symbols").entries == (
        ("C12", "-S12", "0", "a1*C1 + a2*C12"), ("S12", "C12", "0", "a1*S1 + a2*S12"),
        ("0", "0", "1", "0"), ("0", "0", "0", "1"))


def test_cylindrical():
    assert kl.closed_form(kl.robots.cylindrical(), lengths="symbols").entries == (
        ("-S1", "0", "C1", "C1*d3"), ("C1", "0", "S1", "S1*d3"), ("0", "1", "0", "d1 + d2"),
        ("0", "0", "0", "1"))
    assert kl.closed_form(kl.robots.cylindrical()).entries[2][3] == "0.4 + d2"


def test_exam_2018():
    assert kl.closed_form(kl.robots.exam_2018(), 0, 2, lengths="symbols").entries == (
        ("-C1*S2", "S1", "C1*C2", "-a2*C1*S2 + d2*S1"),
        ("-S1*S2", "-C1", "S1*C2", "-d2*C1 - a2*S1*S2"),
        ("C2", "0", "S2", "d1 + a2*C2"), ("0", "0", "0", "1"))
    assert [row[3] for row in kl.closed_form(kl.robots.exam_2018()).entries] == [
        "-0.4*C1*S2 + 0.2*S1 + C1*C2*d3", "-0.2*C1 - 0.4*S1*S2 + S1*C2*d3",
        "0.5 + 0.4*C2 + S2*d3", "1"]


def test_six_link_wrist_point():
    form = kl.closed_form(kl.robots.practical_six_link(), 0, 6, lengths="symbols")
    assert [row[3] for row in form.entries] == [
        "a2*C1*C2 - d2*S1 - d4*C1*S23", "d2*C1 + a2*S1*C2 - d4*S1*S23", "a2*S2 + d4*C23", "1"]
    tool = kl.closed_form(kl.robots.practical_six_link(), 6, lengths="symbols")
    assert tool.entries[2][3] == "d6"


def test_intelledex():
    form = kl.closed_form(kl.robots.intelledex_660t(), lengths="symbols")
    assert [row[2] for row in form.entries] == [
        "C1*C2*S345 - S1*C345", "S1*C2*S345 + C1*C345", "S2*S345", "0"]
    assert form.entries[2][0] == "S2*C345*C6 - C2*S6"
    assert form.entries[0][3] == (
        "a3*(C1*C2*C3 + S1*S3) + a4*(C1*C2*C34 + S1*S34) + d6*(C1*C2*S345 - S1*C345)")
    assert form.entries[2][3] == "d1 + a3*S2*C3 + a4*S2*C34 + d6*S2*S345"


@course
@pytest.mark.parametrize("lengths", ["numbers", "symbols"])
def test_every_stretch_equals_the_numbers(robot, lengths):
    arm = robot()
    q = joint_array(arm)
    for start in range(arm.n + 1):
        for stop in [*range(start, arm.n + 1), None]:
            form = kl.closed_form(arm, start, stop, lengths=lengths)
            close(numbers(form, q), stretch(arm, q, start, stop), atol=1e-9)


@course
def test_every_entry_reads_as_its_number(robot):
    arm = robot()
    q = joint_array(arm)
    for lengths in ("numbers", "symbols"):
        form = kl.closed_form(arm, lengths=lengths)
        got = [[read(entry, form, q) for entry in row] for row in form.entries]
        close(got, textbook.frames(arm, q)[-1], atol=1e-9)


@given(exact_arms, st.integers(0, 99))
@settings(max_examples=25)
def test_random_arms_equal_their_numbers_and_read_so(arm, seed):
    q = joint_array(arm, seed)
    want = textbook.frames(arm, q)[-1]
    for lengths in ("numbers", "symbols"):
        form = kl.closed_form(arm, lengths=lengths)
        assert not form.matrix.atoms(sp.Float)
        close(numbers(form, q), want, atol=1e-9)
        close([[read(entry, form, q) for entry in row] for row in form.entries], want, atol=1e-9)
        rows = form.latex[len(r"\begin{bmatrix}"):-len(r"\end{bmatrix}")].split(r" \\ ")
        got = [[read(plain(entry), form, q) for entry in row.split(" & ")] for row in rows]
        close(got, want, atol=1e-9)


@given(arms(most=3))
@settings(max_examples=20)
def test_any_angle_equals_its_number(arm):
    form, q = kl.closed_form(arm), joint_array(arm)
    close(numbers(form, q), textbook.frames(meant(arm), q)[-1], atol=1e-9)
    assert form.remark or meant(arm) is arm


@given(exact_arms, st.data())
@settings(max_examples=20)
def test_stretches_chain(arm, data):
    middle = data.draw(st.integers(1, arm.n))  # the room (0) has the base in it
    q = joint_array(arm)
    first, second = kl.closed_form(arm, 0, middle), kl.closed_form(arm, middle)
    close(numbers(first, q) @ numbers(second, q), textbook.frames(arm, q)[-1], atol=1e-9)
    assert kl.closed_form(arm, middle, middle).matrix == sp.eye(4)


def test_the_base_begins_in_the_room_and_the_tool_ends_the_chain():
    base, tool = textbook.rigid(o=(1, -2, 0.5)), textbook.rigid(o=(0.1, 0.2, 0.3))
    arm = kl.Arm([kl.revolute(a=1)], base=base, tool=tool)
    assert [row[3] for row in kl.closed_form(arm, 0, 0).entries] == ["1", "-2", "0.5", "1"]
    assert [row[3] for row in kl.closed_form(arm, 1).entries] == ["0.1", "0.2", "0.3", "1"]
    form = kl.closed_form(arm, lengths="symbols")
    assert {str(k): v for k, v in form.lengths.items()} == {
        "x_B": 1, "y_B": 2, "z_B": 0.5, "a_1": 1, "x_E": 0.1, "y_E": 0.2, "z_E": 0.3}
    assert form.matrix[1, 3].coeff(sp.Symbol("y_B")) == -1


def test_the_names_of_lengths():
    def names(arm):
        return sorted(map(str, kl.closed_form(arm, lengths="symbols").lengths))

    tool = textbook.rigid(o=(1, 0, 2))
    rows = [kl.prismatic(a=1, d=2), kl.revolute(a=3, d=4)]
    assert names(kl.Arm(rows)) == ["a_1", "a_2", "d_2", "offset_1"]
    assert names(kl.Arm(rows, tool=tool)) == ["a_1", "a_2", "d_2", "offset_1", "x_E", "z_E"]
    modified = kl.Arm(rows, tool=tool, convention="modified")
    assert names(modified) == ["a_0", "a_1", "a_2", "d_2", "offset_1", "z_E"]
    bare = [kl.revolute(a=1), kl.revolute()]
    assert names(kl.Arm(bare, tool=tool)) == ["a_1", "a_2", "z_E"]
    assert names(kl.Arm(bare, tool=tool, convention="modified")) == ["a_0", "a_2", "d_2"]
    slide = [kl.revolute(), kl.prismatic()]
    assert names(kl.Arm(slide, tool=tool, convention="modified")) == ["a_2", "z_E"]


def test_joint_variables():
    form = kl.closed_form(kl.robots.cylindrical(), 2, 3)
    assert [str(joint) for joint in form.joints] == ["theta_1", "d_2", "d_3"]
    assert form.lengths == {}


def test_numpy_integers_name_frames():
    form = kl.closed_form(kl.robots.alpha_ii(), np.int64(3), np.int64(5))
    assert form.entries[0][0] == "C4*C5"


def test_more_than_nine_joints():
    """C12 is cos(theta_12) there, so the sum of two angles needs a comma."""
    arm = kl.Arm([kl.revolute(a=1, alpha=pi / 2 if i == 10 else 0) for i in range(12)])
    form, q = kl.closed_form(arm), joint_array(arm)
    assert form.entries[2][0] == "S12"
    assert form.entries[0][2] == "S1,2,3,4,5,6,7,8,9,10,11"
    assert " + C1 + C1,2 + C1,2,3 + " in form.entries[0][3]
    got = [[read(entry, form, q) for entry in row] for row in form.entries]
    close(got, textbook.frames(arm, q)[-1], atol=1e-9)
    assert r"S_{1,2,3,4,5,6,7,8,9,10,11}" in form.latex
    ten = kl.closed_form(kl.Arm([kl.revolute() for _ in range(10)]))
    assert ten.entries[0][0] == "C1,2,3,4,5,6,7,8,9,10"
    nine = kl.closed_form(kl.Arm([kl.revolute() for _ in range(9)]))
    assert nine.entries[0][0] == "C123456789"


def test_angles_of_thirty_degrees_keep_their_roots():
    form = kl.closed_form(kl.Arm([kl.revolute(alpha=radians(30), a=0.5)]))
    assert form.entries[0] == ("C1", "-sqrt(3)/2*S1", "0.5*S1", "0.5*C1")
    assert form.entries[2] == ("0", "0.5", "sqrt(3)/2", "0")
    assert r"- \frac{\sqrt{3}}{2} S_{1}".replace("- ", "-") in form.latex


def test_odd_offsets_are_written_out():
    form = kl.closed_form(kl.Arm([kl.revolute(theta=0.3)]))
    assert form.entries[0][0] == "cos(theta_1 + 0.3)"
    assert r"\cos{\left(\theta_{1} + 0.3 \right)}" in form.latex


def test_long_lengths_stay_readable():
    def position(**row):
        return kl.closed_form(kl.Arm([kl.revolute(**row)])).entries[2][3]

    assert position(d=177.8) == "177.8"
    assert position(d=0.0254 * 12) == "0.3048"  # 0.30479999999999996 as a double
    assert position(d=1 / 3) == "0.333333333333"
    assert position(d=-0.125) == "-0.125"
    assert position(d=1e6) == "1000000"


@pytest.mark.parametrize("k", range(-25, 26))
def test_multiples_of_fifteen_degrees_are_exact(k):
    angle = radians(15 * k)
    for near in (angle, angle + 9e-13, angle - 9e-13):
        assert exact_angle(near) == k * sp.pi / 12
    assert exact_angle(angle + 4e-7) == k * sp.pi / 12
    assert exact_angle(angle + 1e-5) == sp.Float(angle + 1e-5)


@pytest.mark.parametrize("typed, turn", [
    (1.570796327, pi / 2), (1.5708, pi / 2), (1.57, pi / 2), (1.571, pi / 2),
    (-0.7854, -pi / 4), (2.0944, 2 * pi / 3), (3.1416, pi), (90 * 3.14159 / 180, pi / 2)])
def test_an_angle_that_looks_rounded_is_written_as_what_was_meant(typed, turn):
    def arm(angle):
        return kl.Arm([kl.revolute(d=0.1, alpha=angle), kl.revolute(a=0.4, theta=-angle),
                       kl.prismatic(theta=angle, alpha=-angle)])

    form, exact = kl.closed_form(arm(typed)), kl.closed_form(arm(turn))
    assert form.text == exact.text and form.latex == exact.latex
    assert form.matrix == exact.matrix and not form.matrix.atoms(sp.Float)
    assert form.remark.startswith(f"alpha1 = {typed:.10g}, offset2 = {-typed:.10g}, theta3 = ")
    assert exact.remark == ""
    jacobian = kl.jacobian_form(arm(typed))
    assert jacobian.text == kl.jacobian_form(arm(turn)).text
    assert jacobian.remark == form.remark
    T = kl.forward_kinematics(arm(typed), [0.1, 0.2, 0.3])  # the numbers stay as they were typed
    close(T, textbook.frames(arm(typed), [0.1, 0.2, 0.3])[-1], atol=1e-15)


def test_the_remark_stands_beside_the_form():
    form = kl.closed_form(kl.Arm([kl.revolute(alpha=1.5708)]))
    assert form.entries[1] == ("S1", "0", "-C1", "0")
    assert form.remark == "alpha1 = 1.5708 looks rounded: it is taken as pi/2."
    assert repr(form).splitlines() == [*form.text.splitlines(), form.remark]
    assert form._repr_latex_() == f"$\\displaystyle {form.latex}$\n\n{form.remark}"
    two = kl.closed_form(kl.Arm([kl.revolute(alpha=1.5708), kl.revolute(alpha=-2.0944)],
                                convention="modified"))
    assert two.remark == ("alpha0 = 1.5708 and alpha1 = -2.0944 look rounded: "
                          "they are taken as pi/2, -2*pi/3.")
    assert kl.closed_form(two_rows(alpha=1.5708), 1, 2).remark == ""  # not in this stretch
    turned = kl.Arm([kl.revolute()], base=textbook.rigid(textbook.turn((1, 0, 0), 1.5708)))
    assert kl.closed_form(turned).remark == "rxB = 1.5708 looks rounded: it is taken as pi/2."


def two_rows(**first):
    return kl.Arm([kl.revolute(**first), kl.revolute(a=1)])


@pytest.mark.parametrize("row, entry, want", [
    (dict(alpha=pi / 6), (0, 1), "-sqrt(3)/2*S1"),
    (dict(alpha=1.5709), (0, 1), "0.000103673204918*S1"),
    (dict(alpha=1.5709), (1, 2), "-0.999999994626*C1"),
    (dict(alpha=1.57079695), (0, 1), "0.000000623205103461*S1"),
    (dict(alpha=1.57079695), (1, 2), "-C1"),  # no 1*: the first twelve digits are those of 1
    (dict(alpha=0.698), (2, 2), "0.766129092116"),
    (dict(theta=1 / 3), (0, 0), "cos(theta_1 + 0.333333333333)"),
    (dict(theta=1e-5), (0, 0), "cos(theta_1 + 0.00001)"),
    (dict(theta=-1.0), (0, 0), "cos(theta_1 - 1)"),
    (dict(theta=pi / 6), (0, 0), "cos(theta_1 + pi/6)"),
    (dict(d=1e-7), (2, 3), "0.0000001"),
    (dict(d=1e20), (2, 3), "100000000000000000000"),
    (dict(a=123456.789012345), (0, 3), "123456.789012*C1")])
def test_numbers_are_written_as_people_do(row, entry, want):
    assert kl.closed_form(kl.Arm([kl.revolute(**row)])).entries[entry[0]][entry[1]] == want


def test_a_long_decimal_takes_a_root_in():
    arm = kl.Arm([kl.revolute(d=0.2027816549469513, alpha=pi / 3),
                  kl.revolute(d=0.2027816549469513)])
    assert kl.closed_form(arm).entries[0][3] == "0.175614064606*S1"  # 0.20278... sqrt(3)/2


@given(arms(most=4), st.integers(0, 9))
@settings(max_examples=25)
def test_no_number_of_any_arm_is_ugly_and_all_read_right(arm, seed):
    q, size = joint_array(arm, seed), 1 + sum(abs(row.a) + abs(row.d) for row in arm.links)
    want = textbook.frames(meant(arm), q)[-1]
    for lengths in ("numbers", "symbols"):
        form = kl.closed_form(arm, lengths=lengths)
        for i, j in np.ndindex(4, 4):
            for written in (form.entries[i][j], plain(notation.latex(form.matrix[i, j],
                                                                     form.joints))):
                assert not re.search(r"(?<![\w.])1\*(?!\*)|[\d.]e[-+\d]", written), written
                for number in re.findall(r"(?<![CS\d])[\d.]+", written):
                    assert len(number.replace(".", "").strip("0")) <= 12, written
            close(read(form.entries[i][j], form, q), want[i, j], atol=1e-9 * size)


def test_what_rounding_left_of_zero_is_not_written():
    near = 1.5707 + 2e-5  # five such cosines are 1e-21
    arm = kl.Arm([kl.revolute(d=1, alpha=near) for _ in range(5)],
                 tool=textbook.rigid(o=(1, 6e-17, 0)))
    form = kl.closed_form(arm)
    assert not re.search(r"0\.0{12}", form.text)
    close(numbers(form, [0.1, 0.2, 0.3, 0.4, 0.5]),
          textbook.frames(arm, [0.1, 0.2, 0.3, 0.4, 0.5])[-1], atol=1e-11)
    bare = kl.closed_form(kl.Arm([kl.revolute(a=1)], tool=textbook.rigid(o=(0, 6e-17, 0))))
    assert bare.entries[0][3] == "C1"
    small = kl.closed_form(kl.Arm([kl.revolute(a=1e-5, alpha=0.3)] * 2))
    assert small.entries[0][3].startswith("0.00001*C1 + ")


def test_no_stray_float_beside_a_right_angle():
    """cos(90 degrees) is 6e-17 as a double; no such coefficient may show."""
    nearly = pi / 2 + 1e-13
    form = kl.closed_form(kl.Arm([kl.revolute(alpha=nearly), kl.revolute(alpha=-nearly)]))
    assert not form.matrix.atoms(sp.Float)
    assert form.entries[0] == ("C1*C2", "-S1", "-C1*S2", "0")


@pytest.mark.parametrize("length, want", [(177.8, sp.Rational(889, 5)), (0.1, sp.Rational(1, 10)),
                                          (-2.0, -2), (1e-3, sp.Rational(1, 1000))])
def test_lengths_are_the_decimals_that_were_typed(length, want):
    assert exact_length(length) == want


def test_notation_of_other_expressions():
    t1, t2 = joints = sp.symbols("theta_1 theta_2")
    a = sp.Symbol("a_1")
    cases = {
        sp.Integer(0): ("0", "0"),
        sp.Integer(-3): ("-3", "-3"),
        sp.Rational(1, 3): ("1/3", r"\frac{1}{3}"),
        sp.cos(t1) ** 2: ("C1**2", "C_{1}^{2}"),
        -a * sp.sin(t1 + t2): ("-a1*S12", "-a_{1} S_{12}"),
        sp.cos(t1 - t2): ("C(1-2)", "C_{(1-2)}"),
        sp.sin(t1 - t2): ("S(1-2)", "S_{(1-2)}"),
        sp.cos(2 * t1): ("cos(2*theta_1)", r"\cos{\left(2 \theta_{1} \right)}"),
        sp.Symbol("L"): ("L", "L"),
        sp.sqrt(a): ("sqrt(a_1)", r"\sqrt{a_{1}}"),
        0.5 * sp.sin(t1) / 3: ("0.166666666667*S1", "0.166667 S_{1}"),
        sp.cos(sp.pi / 12) * sp.cos(t2): (
            "(sqrt(2)/4 + sqrt(6)/4)*C2",
            r"\left(\frac{\sqrt{2}}{4} + \frac{\sqrt{6}}{4}\right) C_{2}"),
        (1 - sp.sqrt(3)) * sp.cos(t2): (
            "-(-1 + sqrt(3))*C2", r"-\left(-1 + \sqrt{3}\right) C_{2}"),
    }
    for expression, (text, latex) in cases.items():
        assert notation.text(expression, joints) == text
        assert notation.latex(expression, joints) == latex
