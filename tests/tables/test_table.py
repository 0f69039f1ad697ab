"""DH tables as typed. KINLAB_EDITS sets how many random edits are made."""
import math
import os
import re
from dataclasses import replace

import numpy as np
import pytest
from edits import BAD, GOOD, START, after, edits, tables, typed
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import arms, arms_and_q, joints

import kinlab as kl
from kinlab.arms.printed import sign_rows
from kinlab.tables.as_code import from_code, to_code
from kinlab.tables.as_csv import to_csv
from kinlab.tables.as_document import to_latex, to_markdown
from kinlab.tables.cells import (
    angle_in,
    angle_text,
    length_in,
    number_text,
    read_angle,
    read_length,
)
from kinlab.tables.other_convention import frame_text, other_reading
from kinlab.tables.read import read_table
from kinlab.tables.table import DHTable, Place, Row

EDITS = int(os.environ.get("KINLAB_EDITS", 4000))
SEQUENCE = 40
COURSE = [kl.robots.two_link, kl.robots.practical_six_link, kl.robots.cylindrical,
          kl.robots.exam_2018, kl.robots.alpha_ii, kl.robots.intelledex_660t]
ROBOTS = [getattr(kl.robots, name) for name in kl.robots.__all__]
every_robot = pytest.mark.parametrize("robot", ROBOTS, ids=lambda robot: robot.__name__)
OTHER = {"standard": "modified", "modified": "standard"}
NAMES = {"d2": 500.0, "l1": 0.3}
EMPTY = DHTable((Row(),))


def read(text):
    return read_table(text, EMPTY).table


def same_arm(a, b, tolerance=0.0):
    """Equal in every number and name."""
    def told(arm):
        links = [(link.theta, link.d, link.a, link.alpha, *(link.limits or ()), link.speed or 0,
                  link.acceleration or 0) for link in arm.links]
        return np.concatenate([*links, arm.base.flat, arm.tool.flat, arm.home])

    words = [[(arm.name, arm.unit, arm.convention), *((link.kind, link.name) for link in arm.links)]
             for arm in (a, b)]
    np.testing.assert_allclose(told(a), told(b), rtol=tolerance, atol=tolerance)
    return words[0] == words[1]


# ---- cells ----


@pytest.mark.parametrize("text, unit, degrees", [
    ("-90", "deg", -90), ("pi/2", "deg", 90), ("π/2", "deg", 90), ("-90 deg", "rad", -90),
    ("2*45", "deg", 90), ("0.5 rad", "deg", math.degrees(0.5)), ("0.5", "rad", math.degrees(0.5)),
    ("(30+15)", "deg", 45), ("-pi", "rad", -180), ("45 deg + pi/4 rad", "deg", 90)])
def test_angles_are_read_in_the_tables_unit(text, unit, degrees):
    assert read_angle(text, unit) == pytest.approx(math.radians(degrees), rel=1e-15)


@pytest.mark.parametrize("text, length", [
    ("-d2", -500), ("d2 + 100", 600), ("177.8", 177.8), ("177.8*cos(pi/2)", 0), ("0", 0),
    ("2*l1", 0.6), ("1e-9", 1e-9)])
def test_lengths_are_read_with_the_names_beside(text, length):
    assert read_length(text, NAMES) == pytest.approx(length, rel=1e-15)


@pytest.mark.parametrize("read, text, reason", [
    (read_length, "90 deg", "expected a length, got an angle"),
    (read_length, "1e12", "from 1e-09 to 1e\\+09, or 0"), (read_length, "1e-12", "or 0"),
    (read_length, "x2", "'x2' is not known"), (lambda t: read_angle(t, "deg"), "d2", "not known"),
    (lambda t: read_angle(t, "deg"), "1e9", "1,600 turns"),
    *((lambda t: read_angle(t, "deg"), text, "pi is in radians and other numbers are in degrees")
      for text in ("pi/2 + 90", "45 - pi", "90*cos(pi/3)", "π/4 + 0.5"))])
def test_what_fits_no_arm_is_refused(read, text, reason):
    with pytest.raises(ValueError, match=reason):
        read(text)


@given(st.floats(-1e4, 1e4) | st.integers(-48, 48).map(lambda k: k * math.pi / 12),
       st.sampled_from(["deg", "rad"]))
def test_an_angle_reads_as_it_was_written(angle, unit):
    assert math.isclose(read_angle(angle_text(angle, unit), unit), angle,
                        rel_tol=2e-15, abs_tol=1e-300) or abs(angle) > 9999


@given(st.floats(1e-9, 1e9))
def test_a_length_reads_as_it_was_written(length):
    assert read_length(number_text(length)) == length


@given(st.integers(-720, 720) | st.integers(-7200, 7200).map(lambda k: k / 10))
def test_degrees_survive_radians(degrees):
    text = number_text(float(degrees))
    assert angle_in(angle_in(text, "deg", "rad"), "rad", "deg") == text


@given(st.integers(-10**6, 10**6).map(lambda k: k / 1000))
def test_millimetres_survive_metres(length):
    text = number_text(length)
    there = length_in(text, "mm", "m", {}, {})
    assert length_in(there, "m", "mm", {}, {}) == text
    assert read_length(there) == pytest.approx(length / 1000, rel=1e-15)


@pytest.mark.parametrize("text, there", [
    ("-d2", "-d2"), ("2*d2 + l1/3", "2*d2 + l1/3"), ("sqrt(d2**2+l1^2)", "sqrt(d2**2+l1^2)"),
    ("d2 + 100", "0.6"), ("d2 - 500", "0"), ("1/3", "0.000333333333333333"), ("100+50", "0.15"),
    ("d2*l1", "0.15"), ("0.1 + 0.2", "0.0003"), ("100*cos(pi/2)", "100*cos(pi/2)")])
def test_a_formula_in_another_unit_stays_or_becomes_its_value(text, there):
    metres = {name: value / 1000 for name, value in NAMES.items()}
    assert length_in(text, "mm", "m", NAMES, metres) == there
    assert read_length(there, metres) == pytest.approx(read_length(text, NAMES) / 1000, rel=1e-12)
    back = length_in(there, "m", "mm", metres, NAMES)
    assert read_length(back, NAMES) == pytest.approx(read_length(text, NAMES), rel=1e-12)
    assert there != text or back == text


def test_a_length_that_scales_by_itself_stays_as_typed():
    metres = {name: value / 1000 for name, value in NAMES.items()}
    assert length_in("-d2", "mm", "m", NAMES, metres) == "-d2"
    assert angle_in("pi/3", "deg", "rad") == "pi/3"
    assert angle_in("30 deg", "deg", "rad") == "30 deg"


@pytest.mark.parametrize("text, unit", [
    ("pi/2 + 0.5", "rad"), ("2*pi/3", "deg"), ("pi/2 - pi/4", "deg"), ("-(pi - pi/2)", "deg"),
    ("pi/2 + 0", "deg"), ("90 deg + 45 deg", "deg"), ("90 + 45", "deg")])
def test_angles_in_one_unit_are_read(text, unit):
    read_angle(text, unit)


@pytest.mark.parametrize("text, unit, hint", [
    ("1.5708", "deg", "pi/2"), ("-1.571", "deg", "-pi/2"), ("0.785398", "deg", "pi/4"),
    ("90", "rad", "90 deg"), ("-180", "rad", "-180 deg"), ("90", "deg", ""), ("1.5", "deg", ""),
    ("1.5708", "rad", ""), ("pi/2", "deg", ""), ("1", "deg", ""), ("6", "rad", "")])
def test_an_angle_that_was_hardly_meant_so_has_a_hint(text, unit, hint):
    table = DHTable((Row(alpha=text),), angles=unit)
    assert table.hints == ({Place(1, "alpha"): f"did you mean {hint}?"} if hint else {})
    assert not table.errors


@pytest.mark.parametrize("row, column, text, cell, flip", [
    (1, "theta", "q1", "0", False), (1, "theta", "θ1*", "0", False), (1, "theta", "theta1", "0",
                                                                      False),
    (1, "theta", "q1 - 90", "-90", False), (1, "theta", "-q1", "0", True),
    (3, "d", "d2*", "0", False), (3, "d", "q2 + 0.5", "0.5", False), (3, "d", "0.5 - q2", "0.5",
                                                                      True)])
def test_the_joints_own_variable_is_left_out_of_its_cell(row, column, text, cell, flip):
    rows = (Row(), Row("fixed"), Row("prismatic", flip=not flip), Row())
    table = DHTable(rows).with_cell(row, column, text)
    assert (getattr(table.rows[row - 1], column), table.rows[row - 1].flip) == (cell, flip)
    assert not table.errors


@pytest.mark.parametrize("row, column, text", [
    (2, "theta", "q1"), (1, "alpha", "q1"), (1, "theta", "2*q1"), (1, "theta", "q1 + q2"), (2, "a",
                                                                                            "θ2")])
def test_a_variable_elsewhere_is_refused_with_a_word(row, column, text):
    table = DHTable((Row(), Row())).with_cell(row, column, text)
    assert getattr(table.rows[row - 1], column) == text
    assert re.search(r"leave (q|theta)[12] out", table.errors[Place(row, column)])


def test_a_length_of_the_name_of_a_variable_stays_a_length():
    table = DHTable((Row("prismatic"),), lengths=(("d1", "0.5"),)).with_cell(1, "d", "d1")
    assert table.arm.links[0].d == 0.5


# ---- tables of arms ----


@every_robot
def test_a_table_of_an_arm_is_that_arm(robot):
    for angles in ("deg", "rad"):
        assert same_arm(DHTable.of(robot(), angles).arm, robot(), 1e-15)


@given(arms())
def test_a_table_of_any_arm_is_that_arm(arm):
    table = DHTable.of(arm)
    if not table.errors:  # lengths below 1e-9
        assert same_arm(table.arm, arm, 1e-14)


@every_robot
def test_files_bring_the_arm_back(robot):
    table = DHTable.of(robot())
    assert read(to_csv(table)) == table
    assert from_code(to_code(table)) == table
    assert same_arm(from_code(to_code(DHTable.of(robot(), "rad"))).arm, robot(), 1e-15)


@every_robot
def test_the_code_is_what_python_runs(robot):
    space = {}
    exec(to_code(DHTable.of(robot())), space)  # written by kinlab, from its own arms
    assert same_arm(space["arm"], robot(), 0 if robot in COURSE else 1e-15)


# ---- the largest speed and acceleration of a joint ----

FAST = DHTable((Row(a="0.4", speed="180", acceleration="pi/2"), Row("prismatic", low="0", high="1",
                                                                  speed="0.25", name="lift")))


def test_rates_are_read_in_the_unit_of_the_joint():
    turning, sliding = FAST.arm.links
    assert (turning.speed, turning.acceleration) == (math.pi, math.pi / 2)
    assert (sliding.speed, sliding.acceleration) == (0.25, None)
    assert FAST.values[Place(1, "speed")] == math.pi
    assert not FAST.in_angles("rad").with_cell(1, "speed", "20").hints  # no angle: no word


def test_rates_stand_in_files_and_come_back():
    assert to_csv(FAST) == (
        "convention,standard\nangles,deg\nlengths,m\n"
        "joint,theta,d,a,alpha,low,high,speed,acceleration,name\n"
        "revolute,0,0,0.4,0,,,180,pi/2,\nprismatic,0,0,0,0,0,1,0.25,,lift\n")
    assert "kl.revolute(a=0.4, speed=radians(180), acceleration=pi/2)," in to_code(FAST)
    for write in (to_csv, to_markdown, to_latex):
        assert read(write(FAST)) == FAST
    assert from_code(to_code(FAST)) == FAST
    named = "v = 0.3\nkl.Arm([kl.prismatic(speed=v, acceleration=None)])"
    assert from_code(named).arm.links[0].speed == 0.3


@pytest.mark.parametrize("write", [to_csv, to_markdown, to_latex, to_code])
def test_a_table_without_rates_says_nothing_of_them(write):
    for robot in (*COURSE, kl.robots.puma_560, kl.robots.stanford):
        assert "speed" not in write(DHTable.of(robot())) and "accel" not in write(
            DHTable.of(robot()))


def test_rates_follow_their_units_and_their_joint():
    assert FAST.in_angles("rad").rows[0].speed == "pi"
    assert FAST.in_unit("mm").rows[1].speed == "250"
    assert FAST.in_unit("mm").in_angles("rad").in_unit("m").in_angles("deg").arm.links \
        == FAST.arm.links
    slides = FAST.with_kind(1, "prismatic").rows[0]  # its numbers were of another unit
    assert (slides.speed, slides.acceleration) == ("", "")
    for convention in ("modified", "standard"):
        moved = FAST.converted_to(convention).arm
        assert [link.speed for link in moved.links] == [math.pi, 0.25]
    assert FAST.with_row_moved(2, 1).arm.links[0].speed == 0.25


@pytest.mark.parametrize("text, reason", [
    ("0", "expected a number above 0; leave the cell empty if it is not known"),
    ("-180", "expected a number above 0"), ("fast", "expected a number such as")])
def test_a_rate_that_is_none_is_marked(text, reason):
    for column in ("speed", "acceleration"):
        wrong = FAST.with_cell(1, column, text)
        assert list(wrong.errors) == [Place(1, column)] and wrong.arm is None
        assert reason in wrong.errors[Place(1, column)]
    flange = replace(FAST, rows=(*FAST.rows, Row("fixed", speed="1")))
    assert flange.errors == {Place(3, "speed"): "a fixed row has no joint; leave this cell empty"}


@given(arms(rows=st.lists(joints(), min_size=1, max_size=7)))
def test_files_bring_base_and_tool_back(arm):
    table = DHTable.of(arm)
    if not table.errors:
        assert read(to_csv(table)) == table
        assert same_arm(from_code(to_code(table)).arm, arm, 1e-14)


def test_named_lengths_are_named_in_the_code():
    table = DHTable((Row(a="-l1", d="2*d2^2"),), lengths=(("l1", "0.5"), ("d2", "1/4")))
    code = to_code(table)
    assert "l1 = 0.5\n" in code and "a=-l1" in code and "d=2*d2**2" in code
    assert from_code(code).lengths == (("l1", "0.5"), ("d2", "0.25"))
    assert same_arm(from_code(code).arm, table.arm)


@given(arms_and_q())
def test_a_converted_table_is_the_same_arm(pair):
    arm, q = pair
    table = DHTable.of(arm)
    if table.errors:
        return
    there = table.converted_to(OTHER[arm.convention])
    np.testing.assert_allclose(kl.forward_kinematics(there.arm, q), kl.forward_kinematics(arm, q),
                               atol=1e-12)
    back = there.converted_to(arm.convention)
    np.testing.assert_allclose(kl.forward_kinematics(back.arm, q), kl.forward_kinematics(arm, q),
                               atol=1e-12)


def test_converting_moves_texts_as_they_were_typed():
    table = START.with_cell(3, "a", "0").converted_to("modified")
    assert [row.a for row in table.rows] == ["0", "l1", "0"]
    assert [row.alpha for row in table.rows] == ["0", "0", "-90"]
    assert table.converted_to("standard") == START


def test_reading_as_the_other_convention_keeps_the_numbers():
    table = START.read_as("modified")
    assert table.rows == START.rows and table.arm.convention == "modified"
    assert not kl.same_mechanism(table.arm, START.arm).ok


@pytest.mark.parametrize("unit, factor", [("mm", 1000), ("cm", 100), ("in", 1 / 0.0254)])
def test_another_unit_is_the_same_arm(unit, factor):
    arm = kl.to_modified(kl.robots.exam_2018())
    table = DHTable.of(replace(arm, tool=kl.translation([0.1, 0, 0]))).in_unit(unit)
    there = kl.forward_kinematics(table.arm, [0.3, 0.4, 0.5 * factor])
    here = kl.forward_kinematics(replace(arm, tool=kl.translation([0.1, 0, 0])), [0.3, 0.4, 0.5])
    np.testing.assert_allclose(there[:3, 3], factor * here[:3, 3], rtol=1e-12)
    assert table.in_unit("m").rows[1:] == DHTable.of(arm).rows[1:]


def test_a_joint_of_another_type_loses_limits_of_another_unit():
    table = DHTable.of(kl.robots.alpha_ii()).with_kind(1, "prismatic")
    assert (table.rows[0].low, table.rows[0].d) == ("", "215")
    assert table.arm.links[0].limits is None


@pytest.mark.parametrize("edit, place, reason", [
    (("with_cell", [2, "a", "1,5"]), Place(2, "a"), "decimal point as ."),
    (("with_cell", [1, "d", ""]), Place(1, "d"), "the cell is empty"),
    (("with_cell", [1, "low", "3"]), Place(1, "high"), "both limits, or neither"),
    (("with_cell", [3, "low", "2"]), Place(3, "high"), "above the lower"),
    (("with_cell", [3, "low", "1 - 1e-8"]), Place(3, "high"), "above the lower"),
    (("with_length", [1, "l1", "3"]), Place(2, "length"), "'l1' is there twice"),
    (("with_length", [1, "pi", "3"]), Place(1, "length"), "cannot be a length's name"),
    (("with_length", [1, "d2", "l1"]), Place(1, "length"), "'l1' is not known"),
    (("without_length", [2]), Place(1, "a"), "'l1' is not known")])
def test_the_wrong_cell_and_its_reason(edit, place, reason):
    table = after(START, *edit)
    assert reason in table.errors[place]
    assert table.arm is None


@pytest.mark.parametrize("edit, reason", [
    (lambda t: t.with_cell(4, "a", "1"), "row: expected a number from 1 to 3, got 4"),
    (lambda t: t.with_cell(0, "a", "1"), "row: expected a number from 1 to 3, got 0"),
    (lambda t: t.with_cell(1, "q", "1"), "column: expected 'theta' or"),
    (lambda t: t.with_cell(1, "a", 1), "text: expected text"),
    (lambda t: t.with_kind(1, "screw"), "kind: expected 'revolute' or"),
    (lambda t: DHTable((Row(),)).without_row(1), "at least one row"),
    (lambda t: DHTable((Row(),) * 60).with_row(), "at most 60 rows"),
    (lambda t: t.with_cell(1, "a", "x").converted_to("modified"), "correct the marked cells"),
    (lambda t: replace(t, unit="furlong").in_unit("m"), "cannot be converted"),
    (lambda t: t.without_end("top"), "end: expected"),
    (lambda t: to_code(t.with_cell(2, "a", "x")), "table: expected cells that can be read; row 2")])
def test_edits_that_make_no_table_are_refused(edit, reason):
    with pytest.raises(ValueError, match=reason):
        edit(START)


# ---- random edits ----


@given(st.lists(edits, min_size=SEQUENCE, max_size=SEQUENCE))
@settings(max_examples=max(1, EDITS // SEQUENCE), deadline=None)
def test_no_sequence_of_edits_breaks_the_table(sequence):
    table = START
    for name, arguments in sequence:
        table = after(table, name, arguments)
        assert (table.arm is None) == bool(table.errors)
        assert 1 <= len(table.rows) <= 60
        assert all(len(reason.splitlines()) == 1 for reason in table.errors.values())
    assert read(to_csv(table)) == table
    assert len(to_csv(table)) < 60_000


@given(tables(), typed)
def test_typing_changes_one_cell_and_keeps_the_text(table, edit):
    name, (row, column, text) = edit
    changed = after(table, name, [row, column, text])
    if row > len(table.rows):
        assert changed == table
        return
    assert getattr(changed.rows[row - 1], column) == " ".join(
        "".join(c if c.isprintable() else " " for c in text).split())
    before = getattr(table.rows[row - 1], column)
    assert changed.with_cell(row, column, before) == table


@given(tables())
def test_units_are_changed_there_and_back(table):
    if table.arm is None:
        return
    for there, back in (("in_angles", table.angles), ("in_unit", table.unit)):
        for unit in ("rad", "deg") if there == "in_angles" else ("m", "mm"):
            returned = getattr(getattr(table, there)(unit), there)(back)
            assert returned.arm is None or same_arm(returned.arm, table.arm, 1e-9)


@given(tables())
def test_code_brings_any_arm_back(table):
    if table.arm is not None:
        code, space = to_code(table), {}
        assert same_arm(from_code(code).arm, table.arm, 1e-14)
        exec(code, space)  # only what parse_number reads stands in it
        assert same_arm(space["arm"], table.arm, 1e-14)


# ---- files ----


@pytest.mark.parametrize("text", [
    "theta,d,a,alpha\n0,215,0,-90\n", "\ufeffθ;d;a;α\r\n0;215;0;-90\r\n",
    "joint\ttheta\td\ta\talpha\nR\t0\t215\t0\t-90\n\n", "alpha,a,d,theta\n-90,0,215,0\n",
    "d,alpha\n215,-90", "name,Mine,,,\n\ntheta,d,a,alpha,\n0,215,0,-90,\n,,,,\n"])
def test_spreadsheets_are_read(text):
    table = read(text)
    assert (table.rows[0].d, table.rows[0].alpha, table.rows[0].kind) == ("215", "-90", "revolute")
    assert table.arm.n == 1


@pytest.mark.parametrize("cell", ["math.radians(-90)", "np.radians(-90)", "-pi/2", "-np.pi/2",
                                  "-RIGHT", "radians(-(45*2))", "-1.5707963267948966",
                                  "radians(angle)", "-radians(90)"])
def test_angles_in_code_are_read(cell):
    code = f"RIGHT = math.pi / 2\nangle = -90\narm = kl.Arm([revolute(alpha={cell}, d=1)])"
    assert from_code(code).arm.links[0].alpha == pytest.approx(-math.pi / 2, rel=1e-15)


def test_code_with_names_for_lists_is_read():
    code = ("import numpy as np\nimport kinlab as kl\n'''The exam'''\nl = 3\n"
            "rows = [kl.revolute(d=l, limits=np.radians([-90, 90])), kl.prismatic(name='slide')]\n"
            "arm = kl.Arm(rows, unit='mm', home=[radians(10), 2],\n"
            "             tool=[[1, 0, 0, l], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])\narm\n")
    arm = from_code(code).arm
    assert arm.links[0].limits == (math.radians(-90), math.radians(90))
    assert arm.tool[0, 3] == 3 and arm.links[1].name == "slide" and arm.unit == "mm"
    np.testing.assert_allclose(arm.home, [math.radians(10), 2])


ARMS = ["", "[]", "[1]", "rows", "[kl.revolute(q=1)]", "[kl.revolute(1)]", "[kl.revolute(**x)]",
        "[kl.revolute()], *x", "[kl.revolute()], **x", "[kl.revolute(a=b)]",
        "[kl.revolute()], convention='craig'", "[kl.revolute()], tool=[[1]]",
        "[kl.revolute()], home=[1, 2]", "[kl.revolute(limits=(1,))]", "[kl.revolute(name=3)]",
        "[kl.revolute()] * 10**9", "[kl.revolute(a=9**9**9**9)]", "[kl.revolute()," * 21,
        "[kl.revolute() for _ in range(10**9)]", "[" + "kl.revolute()," * 61 + "]",
        "[kl.revolute(a=" + "(" * 150 + "1" + ")" * 150 + "+x)]", "[(lambda: 1)()]",
        "[kl.revolute(a=1 if 1 else 2)]", "[kl.revolute(a=int('1' * 9999))]"]
NO_ARM = ["", "x", "1", "(((", "a = [a]\nkl.Arm(a)", "-" * 9000 + "1", "\ud800", "\0", "[" * 5000,
          "while True: pass", "x = y = 1\nkl.Arm([kl.revolute()])", b"kl.Arm()",
          *(f"kl.Arm({inside})" for inside in ARMS)]


@pytest.mark.parametrize("text", NO_ARM, ids=range(len(NO_ARM)))
def test_what_is_no_arm_in_code_is_refused(text):
    with pytest.raises(ValueError) as caught:
        from_code(text)
    assert re.match(r"(text|convention|tool|home): .*(expected|line \d)", str(caught.value))
    assert len(str(caught.value).splitlines()) == 1, caught.value


@pytest.mark.parametrize("evil", ["__import__('os').system('touch {}')", "open('{}', 'w')",
                                  "exec(\"open('{}', 'w')\")", "(lambda: open('{}', 'w'))()"])
def test_code_is_never_run(evil, tmp_path):
    path = tmp_path / "run"
    for place in ("{}", "kl.Arm([kl.revolute(a={})])", "x = {}", "kl.Arm([{}])", "kl.Arm({})"):
        with pytest.raises(ValueError):
            from_code(place.format(evil.format(path)))
    assert not path.exists()


def mutated(draw):
    code = to_code(DHTable.of(draw(st.sampled_from(ROBOTS))()))
    for _ in range(draw(st.integers(1, 6))):
        at = draw(st.integers(0, len(code)))
        piece = draw(st.sampled_from([*"()[],=-.'9x:{#\n ", "**", "kl", "pi", "radians", "lambda",
                                      "\\d", "limits=", "home=[0]", "name=None"]))
        code = code[:at] + piece + code[at + draw(st.integers(0, 3)):]
    return code


@given(st.composite(mutated)() | st.text(max_size=40))
@settings(deadline=None)
def test_any_text_is_loaded_or_refused_in_one_line(text):
    for load in (from_code, read):
        try:
            assert isinstance(load(text), DHTable)
        except ValueError as error:
            assert len(str(error).splitlines()) == 1


# ---- comparing ----


def test_the_same_numbers_in_the_other_convention():
    reading = other_reading(kl.robots.practical_six_link(), np.zeros(6))
    assert not reading.same and reading.numbers.convention == "standard"
    assert kl.same_mechanism(reading.converted, kl.robots.practical_six_link()).ok
    assert reading.moved[0] == "the axis of joint 2 is turned by 90°"


def test_numbers_that_mean_the_same_in_both_conventions():
    reading = other_reading(kl.Arm([kl.revolute(d=1)]), [0.3])
    assert reading.same and reading.moved == []


def test_what_moves_is_told_with_its_amount():
    arm = kl.Arm([kl.revolute(a=2), kl.revolute(a=0, alpha=math.pi / 2)], unit="mm")
    assert other_reading(arm, [0, 0]).moved == [
        "the axis of joint 1 is shifted by 2 mm", "the axis of joint 2 is turned by 90°"]


def test_signs_are_those_of_the_numbers():
    assert sign_rows(kl.robots.alpha_ii().links)[1:] == [
        ["1", "*", "+", "0", "−"], ["2", "*", "0", "+", "0"], ["3", "*", "0", "+", "0"],
        ["4", "*", "0", "0", "−"], ["5", "*", "+", "0", "0"]]


def test_frames_in_words():
    assert frame_text(np.eye(4), "m") == ""
    assert frame_text(kl.translation([0, 0.5, 0]), "m") == "moved by (0, 0.5, 0) m"


def test_lists_of_texts_are_what_they_say():
    table = DHTable((Row(),), lengths=(("d2", "1"), ("l1", "1")))
    for text in BAD:
        assert table.with_cell(1, "a", text).errors, text
    good = [text for text in GOOD if "deg" not in text and "rad" not in text and "°" not in text]
    for text in filter(None, good):
        assert not table.with_cell(1, "a", text).errors, text


@pytest.mark.parametrize("row, column, typed, text", [
    (1, "theta", "*", "0"), (1, "theta", "q", "0"), (1, "theta", "q1 + np.pi/2", "pi/2"),
    (1, "alpha", "np.pi/2", "pi/2"), (1, "alpha", "PI/2", "pi/2"), (1, "alpha", "3pi/2", "3*pi/2"),
    (1, "alpha", "np.radians(90)", "(90) deg"), (1, "alpha", "90 degrees", "90"),
    (1, "alpha", r"\frac{\pi}{2}", "pi/2"), (1, "alpha", "½π", "1/2*pi"),
    (2, "d", "100 mm", "0.1"), (2, "d", "0.1 [m]", "0.1"), (2, "a", "√(2)", "sqrt(2)"),
    (1, "alpha", "90°", "90°"), (1, "alpha", "1,5", "1,5"), (1, "a", "100 apples", "100 apples")])
def test_a_cell_is_read_as_in_a_pasted_table(row, column, typed, text):
    table = DHTable((Row(), Row("prismatic"))).with_cell(row, column, typed)
    assert getattr(table.rows[row - 1], column) == text
