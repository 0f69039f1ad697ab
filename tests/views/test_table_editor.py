"""The DH table in a notebook, without a browser. KINLAB_EDITS sets the number of random edits."""
import json
import math
import os
import time

import ipywidgets
import numpy as np
import pytest
from edits import edits
from hypothesis import given, settings
from hypothesis import strategies as st

import kinlab as kl
from kinlab.drawing.controls import joint_knobs
from kinlab.drawing.scene import Scene
from kinlab.tables.table import DHTable, Place
from kinlab.views import arm_view
from kinlab.views.table_editor import EDITS, PANELS

MANY = int(os.environ.get("KINLAB_EDITS", 2000))
SEQUENCE = 20


@pytest.fixture
def editor():
    return kl.DHTableEditor(kl.robots.alpha_ii())


def tell(editor, what, *arguments):
    """What the browser sends when the student does something."""
    editor._hear(editor, {"do": what, "with": list(arguments)}, [])
    return editor.cells


def widgets():
    return len(ipywidgets.widgets.widget._instances)


# ---- from Python ----


def test_it_begins_with_two_links():
    editor = kl.DHTableEditor()
    assert repr(editor) == """\
DHTableEditor(standard DH, lengths in m, * marks the joint variable)
i  joint         θ  d  a  α
1  revolute  θ1* 0  0  1  0
2  revolute  θ2* 0  0  1  0"""
    assert editor.arm.n == 2 and editor.arm.links[0].a == 1


def test_its_text_names_wrong_cells(editor):
    editor.set(2, "alpha", "x")
    editor.table = editor.table.with_length(1, "d2", "500")
    text = repr(editor)
    assert text.splitlines()[0] == ("DHTableEditor('Alpha II': standard DH, lengths in mm, "
                                    "* marks the joint variable)")
    assert text.splitlines()[-2:] == [
        "with d2 = 500", "Row 2, alpha: 'x': expected a number such as -90 deg, pi/2 or 177.8; "
        "'x' is not known; known are pi, deg, rad"]


def test_a_notebook_without_a_kernel_shows_the_text(editor):
    bundle = editor._repr_mimebundle_()
    assert bundle["text/plain"] == f"{editor!r}\nRun this cell to type in the table."
    assert "application/vnd.jupyter.widget-view+json" in bundle


def test_an_arm_goes_in_and_comes_out(editor):
    for robot in (kl.robots.exam_2018, kl.robots.practical_six_link):
        editor.arm = robot()
        assert repr(editor.arm) == repr(robot())
        assert repr(editor.view.arm) == repr(robot())
        np.testing.assert_allclose(editor.view.T, kl.forward_kinematics(robot(), robot().home),
                                   atol=1e-12)


def test_lengths_given_beside():
    editor = kl.DHTableEditor(lengths={"d2": 500, "l1": 0.25})
    editor.set(1, "d", "-d2")
    assert editor.arm.links[0].d == -500
    assert editor.table.lengths == (("d2", "500"), ("l1", "0.25"))


def test_angles_may_be_in_radians():
    editor = kl.DHTableEditor(kl.robots.alpha_ii(), angles="rad")
    assert editor.table.rows[0].alpha == "-pi/2"
    editor.set(1, "alpha", "0.5")
    assert editor.arm.links[0].alpha == 0.5


@pytest.mark.parametrize("angles, text, reads", [
    ("deg", "90", ""), ("deg", "pi/2", "90°"), ("deg", "2*45", "90°"), ("rad", "90", "5156.6°"),
    ("rad", "0", ""), ("rad", "-pi/4", "-45°"), ("deg", "x", "")])
def test_what_a_cell_says_stands_beside_it(angles, text, reads):
    editor = kl.DHTableEditor(angles=angles)
    editor.set(1, "alpha", text)
    assert editor.cells["rows"][0]["cells"]["alpha"]["reads"] == reads


@pytest.mark.parametrize("make, message", [
    (lambda: kl.DHTableEditor(3), "arm: expected a kinlab Arm, got 3"),
    (lambda: kl.DHTableEditor(angles="grad"), "angles: expected 'deg' or 'rad', got 'grad'"),
    (lambda: kl.DHTableEditor(lengths=[1]), "lengths: expected names with their lengths"),
    (lambda: kl.DHTableEditor(lengths={"pi": 1}), "lengths: 'pi' cannot be a length's name"),
    (lambda: kl.DHTableEditor(lengths={2: 1}), "text: expected text"),
    (lambda: kl.DHTableEditor(lengths={"l": "1"}), r"lengths\['l'\]: expected a number"),
    (lambda: kl.DHTableEditor(kl.Arm([kl.revolute(a=1e20)])), "arm: expected numbers that fit")])
def test_bad_input_is_refused(make, message):
    with pytest.raises(ValueError, match=f"^{message}"):
        make()


@pytest.mark.parametrize("do, message", [
    (lambda e: setattr(e, "arm", None), "arm: expected a kinlab Arm, got None"),
    (lambda e: setattr(e, "arm", kl.Arm([kl.revolute(a=1e-12)])), "arm: expected numbers that fit"),
    (lambda e: setattr(e, "table", 3), "table: expected a DHTable, got 3"),
    (lambda e: e.set(9, "a", "1"), "row: expected a number from 1 to 5, got 9"),
    (lambda e: e.set(1, "b", "1"), "column: expected 'theta' or"),
    (lambda e: e.load("hello"), "text: expected a header"),
    (lambda e: e.load(None), "text: expected"),
    (lambda e: e.load("Arm(1)"), "text: line 1: expected code such as")])
def test_a_refusal_changes_nothing(editor, do, message):
    before = editor.table, repr(editor), repr(editor.view)
    with pytest.raises(ValueError, match=f"^{message}"):
        do(editor)
    assert (editor.table, repr(editor), repr(editor.view)) == before


# ---- the arm follows ----


def test_a_wrong_cell_keeps_the_last_arm_and_the_right_one_moves_it(editor):
    last = editor.arm
    state = tell(editor, "with_cell", 2, "a", "1,5")
    assert editor.arm is last and editor.view.arm is last and editor.table.arm is None
    assert "decimal point" in state["rows"][1]["cells"]["a"]["error"] and state["wrong"] == 1
    state = tell(editor, "with_cell", 2, "a", "300")
    assert editor.arm.links[1].a == 300 and editor.view.arm is editor.arm
    assert state["wrong"] == 0 and not state["rows"][1]["cells"]["a"]["error"]
    np.testing.assert_allclose(editor.view.T[:3, 3], [607.3, 0, 215], atol=1e-9)


def test_joint_values_stay_with_their_joints(editor):
    q = np.radians([10, -20, 30.3, -40, 50])
    editor.view.q = q
    editor.set(1, "d", "300")
    np.testing.assert_allclose(editor.view.q, q)
    tell(editor, "without_row", 2)
    np.testing.assert_allclose(editor.view.q, np.delete(q, 1))
    tell(editor, "with_row", 1)
    np.testing.assert_allclose(editor.view.q, [q[0], 0, *q[2:]])
    tell(editor, "with_row_moved", 1, 5)
    np.testing.assert_allclose(editor.view.q, [0, *q[2:], q[0]])
    tell(editor, "with_kind", 5, "prismatic")
    np.testing.assert_allclose(editor.view.q, [0, *q[2:], 0])


def test_slides_keep_their_place_in_another_unit():
    editor = kl.DHTableEditor(kl.robots.cylindrical())
    editor.view.q = [0.1, 0.25, 0.45]
    tell(editor, "in_unit", "mm")
    np.testing.assert_allclose(editor.view.q, [0.1, 250, 450])
    assert editor.view.joints[1].max == 600


def test_an_edit_while_a_cell_is_wrong_loses_no_joint_value(editor):
    q = np.radians([10, -20, 30.3, -40, 50])
    editor.view.q = q
    editor.set(2, "a", "x")
    tell(editor, "without_row", 1)
    editor.set(1, "a", "100")
    np.testing.assert_allclose(editor.view.q, q[1:])


def test_widgets_do_not_pile_up(editor):
    edit = [("with_cell", 2, "a", "300"), ("with_row",), ("with_kind", 6, "prismatic"),
            ("in_unit", "m"), ("without_row", 6), ("in_unit", "mm"), ("with_cell", 2, "a", "177.8")]
    for step in edit:
        tell(editor, *step)
    count = widgets()
    for step in edit * 2:
        tell(editor, *step)
    assert widgets() == count
    assert editor.view is editor


def test_what_says_the_same_is_not_drawn_again(editor):
    scene, arm = editor.scene, editor.arm
    tell(editor, "with_cell", 1, "alpha", "-pi/2")
    assert editor.arm is arm and editor.scene is scene


def test_an_edit_is_answered_at_once(editor):
    tell(editor, "with_cell", 2, "a", "250")
    began = time.perf_counter()
    for k in range(5):
        tell(editor, "with_cell", 2, "a", str(300 + k))
    assert (time.perf_counter() - began) / 5 < 1.0  # 0.15 s on a laptop


# ---- the view that follows ----


def test_a_view_follows_another_arm():
    view = kl.ArmView(kl.robots.alpha_ii(), show=["labels", "trace"])
    view.follow(kl.robots.cylindrical(), [1, 0.2, 9])
    assert [s.description for s in view.joints] == ["θ₁ (°)", "d₂ (m)", "d₃ (m)"]
    np.testing.assert_allclose(view.q, [1, 0.2, 0.6])
    assert view.note == "d₃ stops at its limit, 0.6 m"
    assert not view.settling
    scene = view.scene
    assert [layer["layer"] for layer in scene["layers"] if layer["on"]] == [
        "labels", "floor", "trace"]
    fresh = kl.ArmView(kl.robots.cylindrical(), show=["labels", "trace"]).scene
    assert json.dumps(scene) == json.dumps(fresh)


def test_a_view_refuses_what_is_no_arm():
    view = kl.ArmView(kl.robots.alpha_ii())
    before = repr(view), view.scene
    for arm, q in ((None, None), (kl.robots.alpha_ii(), [1]), (kl.robots.alpha_ii(), "q")):
        with pytest.raises(ValueError):
            view.follow(arm, q)
    assert (repr(view), view.scene) == before


# ---- undo, panels, files ----


def test_undo_and_redo(editor):
    tables = [editor.table]
    for step in (("with_cell", 2, "a", "x"), ("converted_to", "modified"), ("in_angles", "rad"),
                 ("with_cell", 2, "a", "9"), ("converted_to", "modified"), ("with_row",)):
        state = tell(editor, *step)
        if editor.table != tables[-1]:
            tables.append(editor.table)
    assert len(tables) == 6 and state["undo"] and not state["redo"]
    for table in tables[-2::-1]:
        tell(editor, "undo")
        assert editor.table == table
    assert repr(editor.arm) == repr(kl.robots.alpha_ii())
    for table in tables[1:]:
        tell(editor, "redo")
        assert editor.table == table
    tell(editor, "undo")
    tell(editor, "undo")
    assert not tell(editor, "with_cell", 1, "a", "7")["redo"]


def test_undo_at_the_start_does_nothing(editor):
    before = editor.table
    editor.undo()
    editor.redo()
    assert editor.table is before


def test_what_cannot_be_done_is_said(editor):
    tell(editor, "with_cell", 2, "a", "x")
    state = tell(editor, "converted_to", "modified")
    assert state["said"].startswith("convention: expected a table that can be read; correct")
    assert tell(editor, "load", "hello")["said"].startswith("text: expected a header")
    assert editor.said == editor.cells["said"]
    assert tell(editor, "with_cell", 2, "a", "1")["said"] == ""


def test_the_closed_form_on_demand(editor):
    tell(editor, "open", "closed")
    assert "177.8 C_{23}" in editor.panel and "T_0^{5}" in editor.panel
    tell(editor, "open", "symbols")
    assert "a_{3} C_{23}" in editor.panel
    tell(editor, "with_cell", 3, "a", "0")
    assert "a_{3}" not in editor.panel
    tell(editor, "open", "")
    assert editor.panel == ""


def test_a_closed_form_that_would_fill_pages_is_not_written():
    arm = kl.Arm([kl.revolute(theta=0.3 * k, a=1, alpha=0.2 * k) for k in range(1, 7)])
    editor = kl.DHTableEditor(arm)
    began = time.perf_counter()
    tell(editor, "open", "closed")
    assert "would fill pages" in editor.panel and time.perf_counter() - began < 1


def test_the_sign_pattern_on_demand(editor):
    tell(editor, "open", "signs")
    assert "<td>−</td>" in editor.panel
    shown = editor.panel
    tell(editor, "with_cell", 1, "alpha", "90")
    assert editor.panel.count("−") == shown.count("−") - 1


def test_the_other_convention_side_by_side(editor):
    tell(editor, "open", "compare")
    for words in ("read as modified", "another mechanism", "the axis of joint 1 is turned by 90°",
                  "α(i-1)", "data:image/png", "At q = [0, 0, 0, -90, 0] deg"):
        assert words in editor.panel


def test_names_do_not_become_html():
    evil = kl.Arm([kl.revolute(a=1)], name="<img src=x onerror=alert(1)>", unit="<b>",
                  tool=kl.translation([1, 0, 0]))
    editor = kl.DHTableEditor(evil)
    for panel in PANELS:
        tell(editor, "open", panel)
        assert "<b>" not in editor.panel and "<img src=x" not in editor.panel


def test_files_bring_the_table_back(editor):
    editor.set(2, "a", "x")
    wrong = editor.to_csv()
    with pytest.raises(ValueError, match="table: expected cells that can be read; row 2, a: 'x'"):
        editor.to_code()
    editor.undo()
    code, table = editor.to_code(), editor.table
    editor.load(wrong)
    assert editor.table.errors.keys() == {Place(2, "a")}
    editor.load(code)
    assert editor.table == table
    editor.table = editor.table.in_angles("rad")
    editor.load(code)
    assert editor.table.angles == "rad" and editor.table.rows[0].alpha == "-pi/2"


# ---- pasted tables ----

TYPED = "theta,d,a,alpha\n0,0.1,0,1.5708\n0,0,1,0\n"


def test_what_was_assumed_is_said(editor):
    editor.load("α (deg) | a (m) | d (m) | θ\n90 | 0 | 0.1 | q1\n0 | 1 | 0 | q2\n")
    assert "degrees" in editor.said and "\n" not in editor.said
    assert editor.cells["said"] == editor.said
    editor.set(1, "a", "2")
    assert editor.said == ""


def test_what_is_ambiguous_is_asked_and_answered(editor):
    before = editor.table
    with pytest.raises(ValueError, match='angles="rad"'):
        editor.load(TYPED)
    assert editor.cells["question"] is None  # Python asks with an exception
    state = tell(editor, "load", TYPED)
    assert state["question"]["options"] == ["degrees", "radians"]
    assert state["question"]["text"].startswith("Are the angles in") and state["said"] == ""
    assert editor.table is before
    state = tell(editor, "answer", 1)
    assert state["question"] is None and editor.arm.links[0].alpha == 1.5708
    editor.undo()
    assert editor.table == before
    editor.load(TYPED, angles="deg")
    assert math.degrees(editor.arm.links[0].alpha) == pytest.approx(1.5708)


def test_answers_add_up(editor):
    state = tell(editor, "load", "0 0.1 0 1.5708\n0 0 1 0\n")
    assert "in which order" in state["question"]["text"]
    state = tell(editor, "answer", state["question"]["options"].index("theta d a alpha"))
    assert state["question"]["options"] == ["degrees", "radians"]
    tell(editor, "answer", 1)
    assert editor.cells["question"] is None and "theta d a alpha" in editor.said
    assert (editor.arm.n, editor.arm.links[0].alpha, editor.arm.links[1].a) == (2, 1.5708, 1)


@pytest.mark.parametrize("step", [("dismiss",), ("with_cell", 1, "a", "3"), ("undo",),
                                  ("load", "hello"), ("load", TYPED.replace("1.5708", "90"))])
def test_a_question_is_gone_when_something_else_is_done(editor, step):
    tell(editor, "load", TYPED)
    assert tell(editor, *step)["question"] is None
    table = editor.table
    tell(editor, "answer", 0)
    assert editor.table is table


@pytest.mark.parametrize("k", [2, -1, "0", None, 1.5])
def test_an_answer_that_is_none_changes_nothing(editor, k):
    table = editor.table
    tell(editor, "load", TYPED)
    assert tell(editor, "answer", k)["question"] and editor.table is table


@pytest.mark.parametrize("form", ["to_csv", "to_markdown", "to_latex", "to_code"])
def test_all_formats_are_read_back(form):
    editor = kl.DHTableEditor(kl.robots.practical_six_link())
    editor.table = editor.table.with_kind(6, "fixed").with_flip(2, True).with_limits(3, "10", "10")
    editor.set("tool", "z", "0.303")
    table, text = editor.table, getattr(editor, form)()
    assert editor.cells["texts"][form.removeprefix("to_")] == text
    other = kl.DHTableEditor()
    other.load(text)
    assert other.arm.links == editor.arm.links and repr(other.arm) == repr(editor.arm)
    np.testing.assert_array_equal(other.arm.tool, editor.arm.tool)
    if form != "to_code":  # which keeps a tool as a matrix
        assert other.table == table


# ---- rows as people have them ----


def test_a_fixed_row_has_no_star_and_counts_no_joint(editor):
    state = tell(editor, "with_kind", 2, "fixed")
    assert [row["joint"] for row in state["rows"]] == [1, 1, 2, 3, 4]
    assert state["rows"][1]["variable"] is None
    assert list(state["rows"][1]["cells"]) == ["theta", "d", "a", "alpha"]
    assert editor.arm.n == 4 and len(editor.q) == 4
    lines = repr(editor).splitlines()
    assert lines[3].split() == ["2", "fixed", "0", "0", "177.8", "0"]
    assert lines[4].split()[:4] == ["3", "revolute", "θ2*", "0"]


def test_a_joint_counts_the_other_way(editor):
    editor.q = np.radians([0, 30, 0, -90, 0])
    ahead = editor.T[2, 3]
    state = tell(editor, "with_flip", 2, True)
    assert state["rows"][1]["flip"] and "-θ2* 0" in repr(editor)
    assert editor.arm.links[1].flip
    assert 215 - editor.T[2, 3] == pytest.approx(ahead - 215)
    tell(editor, "with_cell", 2, "theta", "q2 + 10")
    assert not editor.table.rows[1].flip and editor.table.rows[1].theta == "10"


def test_a_joint_is_locked_where_it_is(editor):
    editor.q = np.radians([10, 25, 30, -90, 0])
    state = tell(editor, "lock", 2)
    assert (editor.table.rows[1].low, editor.table.rows[1].high) == ("25", "25")
    assert state["rows"][1]["locked"] and not state["rows"][2]["locked"]
    assert editor.arm.links[1].limits == pytest.approx((math.radians(25),) * 2)
    np.testing.assert_allclose(np.degrees(editor.q), [10, 25, 30, -90, 0])
    state = tell(editor, "unlock", 2)
    assert not state["rows"][1]["locked"] and editor.arm.links[1].limits is None
    editor.arm = kl.robots.cylindrical()
    editor.q = [0, 0.25, 0.5]
    editor.lock(2)
    assert editor.table.rows[1].low == "0.25"
    tell(editor, "with_kind", 3, "fixed")
    before = editor.table
    assert "got a fixed row" in tell(editor, "lock", 3)["said"] and editor.table is before


def test_rates_have_cells_where_a_table_has_any(editor):
    plain = ["theta", "d", "a", "alpha", "low", "high", "home"]
    state = tell(editor, "with_kind", 3, "fixed")
    assert [list(row["cells"]) for row in state["rows"][1:3]] == [plain, plain[:4]]
    state = tell(editor, "with_cell", 2, "speed", "pi/2")
    assert [list(row["cells"]) for row in state["rows"][:3]] == [
        [*plain, "speed"], [*plain, "speed"], plain[:4]]
    assert state["rows"][1]["cells"]["speed"] == {
        "text": "pi/2", "error": "", "reads": "90°/s", "hint": "", "unit": "deg/s"}
    assert editor.arm.links[1].speed == pytest.approx(math.pi / 2)
    state = tell(editor, "with_cell", 2, "acceleration", "-1")
    assert state["wrong"] == 1 and "above 0" in state["rows"][1]["cells"]["acceleration"]["error"]
    assert state["rows"][0]["cells"]["acceleration"]["unit"] == "deg/s²"


def test_limits_of_a_fixed_row_are_marked(editor):
    state = tell(editor, "load", "joint,theta,d,a,alpha,low,high\nrevolute,0,1,0,90,,\n"
                                 "fixed,0,0,1,0,1,2\n")
    assert state["wrong"] == 2 and "no joint" in state["rows"][1]["cells"]["low"]["error"]
    tell(editor, "with_cell", 2, "low", "")
    state = tell(editor, "with_cell", 2, "high", "")
    assert state["wrong"] == 0 and "low" not in state["rows"][1]["cells"]


def test_joint_values_come_back_with_their_rows(editor):
    q = np.radians([10, -20, 30.3, -40, 50])
    editor.q = q
    tell(editor, "without_row", 2)
    tell(editor, "undo")
    np.testing.assert_allclose(editor.q, q)


def test_ends_are_typed(editor):
    editor.set("tool", "z", "100")
    editor.set("base", "yaw", "pi/2")
    assert editor.arm.tool[2, 3] == 100 and editor.arm.base[1, 0] == 1
    assert repr(editor).splitlines()[-2:] == ["base: yaw pi/2", "tool: z 100"]
    ends = editor.cells["ends"]
    assert ends["base"]["cells"]["yaw"]["reads"] == "90°"
    assert ends["tool"]["form"] == "pose" and ends["tool"]["cells"]["z"]["unit"] == "mm"
    tell(editor, "with_cell", "tool", "z", "1,5")
    assert "decimal point" in editor.cells["ends"]["tool"]["cells"]["z"]["error"]
    assert repr(editor).splitlines()[-1].startswith("Tool, z: '1,5'")
    tell(editor, "undo")
    tell(editor, "without_end", "tool")
    assert editor.cells["ends"]["tool"] is None


def test_an_odd_angle_is_hinted_at_and_is_no_error(editor):
    state = tell(editor, "with_cell", 2, "alpha", "1.5708")
    cell = state["rows"][1]["cells"]["alpha"]
    assert "pi/2" in cell["hint"] and not cell["error"] and state["wrong"] == 0
    editor.set("tool", "yaw", "-1.5708")
    assert repr(editor).splitlines()[-2:] == [
        "Row 2, alpha: did you mean pi/2?", "Tool, yaw: did you mean -pi/2?"]


# ---- the formula has the table's names ----


def test_named_lengths_stand_in_the_formula():
    editor = kl.DHTableEditor(lengths={"L1": 0.5, "L2": 0.3})
    editor.set(1, "a", "L1")
    editor.set(2, "a", "L2")
    tell(editor, "open", "closed")
    assert "L_{1} C_{1} + L_{2} C_{12}" in editor.panel
    editor.set(2, "a", "0.3")  # the same arm, another formula
    assert "L_{1} C_{1} + 0.3 C_{12}" in editor.panel


def test_a_name_that_means_a_joint_is_left_out_of_the_formula():
    editor = kl.DHTableEditor(kl.robots.cylindrical(), lengths={"d2": 0.5})
    editor.set(1, "d", "d2")
    editor.table = editor.table.with_length(2, "L", "0.1").with_cell(3, "a", "2·L")
    editor.table = editor.table.with_length(3, "C1", "0.2").with_cell(2, "a", "C1")
    for panel in ("closed", "symbols"):
        tell(editor, "open", panel)
        assert "Row 1, d, Row 2, a: the text does not stand in the formula" in editor.panel
        assert "2 L" in editor.panel


def test_a_rounded_angle_is_named_beside_the_formula():
    editor = kl.DHTableEditor(kl.Arm([kl.revolute(a=1, alpha=1.5708), kl.revolute(a=1)]))
    tell(editor, "open", "closed")
    assert "alpha1 = 1.5708 looks rounded: it is taken as pi/2." in editor.panel


# ---- random edits ----


def still(arm, q=None, **options):
    """A scene that draws nothing, so that many edits can be made."""
    return Scene((), (), 0, (0, 0, 0), 1.0, knobs=tuple(joint_knobs(arm)))


def browse(editor, sequence):
    """What a student sees after each edit; nothing raises, nothing is lost."""
    last, tables = editor.arm, [editor.table]
    for what, arguments in sequence:
        state = tell(editor, what, *arguments)
        json.dumps(state, allow_nan=False).encode()
        if editor.table != tables[-1]:
            tables.append(editor.table)
        last = editor.table.arm or last
        assert repr(editor.arm) == repr(last) == repr(editor.view.arm)
        assert len(editor.view.q) == editor.arm.n and np.isfinite(editor.view.q).all()
        assert state["wrong"] == len(editor.table.errors) and "\n" not in state["said"]
        assert bool(state["said"]) <= (editor.table is tables[-1])
        repr(editor).encode()
    for table in tables[-2::-1]:
        assert tell(editor, "undo")["wrong"] == len(table.errors)
        assert editor.table == table
    for table in tables[1:]:
        tell(editor, "redo")
        assert editor.table == table
    assert repr(editor.arm) == repr(last)


loads = st.tuples(st.just("load"), st.lists(st.text(max_size=30) | st.sampled_from(
    ["theta,d,a,alpha\n0,1,0,90", "kl.Arm([kl.revolute(a=1), kl.prismatic()])", "alpha\nx\n", TYPED,
     "joint,alpha\nP,90\nR,1"]), min_size=1, max_size=1))
opened = st.sampled_from([("open", [""]), ("open", ["signs"]), ("answer", [0]), ("dismiss", []),
                          ("lock", [1]), ("lock", [9]), ("unlock", [2])])
sessions = st.lists(edits | loads | opened, min_size=SEQUENCE, max_size=SEQUENCE)


@given(sessions)
@settings(max_examples=max(1, MANY // SEQUENCE), deadline=None)
def test_no_session_loses_anything(sequence):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(arm_view, "arm_scene", still)
        browse(kl.DHTableEditor(kl.robots.cylindrical(), lengths={"d2": 0.5, "l1": 1}), sequence)


@given(sessions)
@settings(max_examples=max(2, MANY // 1000), deadline=None)
def test_no_session_loses_anything_with_the_live_arm(sequence):
    browse(kl.DHTableEditor(kl.robots.exam_2018(), lengths={"d2": 0.5, "l1": 1}), sequence)


LENGTHS = ["0", "1e-9", "1e-6", "1", "1e9", "-1e9"]


@pytest.mark.parametrize("d", LENGTHS)
def test_the_picture_shows_any_arm_that_a_table_takes(d):
    editor = kl.DHTableEditor(kl.robots.exam_2018())
    for a in LENGTHS:
        for alpha in ("0", "1e-9", "36000"):
            editor.table = DHTable(editor.table.rows).with_cell(1, "d", d).with_cell(
                1, "a", a).with_cell(2, "a", "0").with_cell(2, "d", "0").with_cell(
                1, "alpha", alpha).with_cell(3, "low", "").with_cell(3, "high", "").with_cell(
                3, "home", "")
            assert editor.view.arm is editor.arm and math.isfinite(editor.view.T.sum())


def test_every_edit_is_one_of_the_tables():
    assert all(callable(getattr(DHTable, name)) for name in EDITS)


def test_base_and_tool_go_in_and_out_as_matrices():
    editor = kl.DHTableEditor()
    editor.tool = kl.translation([0, 0, 0.303])
    assert editor.arm.tool[2, 3] == editor.tool[2, 3] == 0.303
    editor.undo()
    assert np.array_equal(editor.tool, np.eye(4))
    with pytest.raises(ValueError, match=r"^base\[:3, :3\]: expected a rotation"):
        editor.base = np.zeros((4, 4))
    assert np.array_equal(editor.base, np.eye(4))


def test_a_page_has_the_arm_alone(tmp_path):
    """Its docstring says so: nothing in a page could read what is typed."""
    editor = kl.DHTableEditor(kl.robots.two_link())
    assert "with_cell" in editor._esm  # what a cell sends
    page = editor.save_html(tmp_path / "arm.html").read_text(encoding="utf-8")
    assert "with_cell" not in page and "Two-link" in page
