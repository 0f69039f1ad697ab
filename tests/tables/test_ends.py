"""Base and tool as typed: the matrices of hand-typed cells, and what is shown of a matrix."""
from math import cos, pi, radians, sin

import numpy as np
import pytest

import kinlab as kl
from kinlab.tables.as_code import from_code, to_code
from kinlab.tables.as_csv import to_csv
from kinlab.tables.ends import End, pose_of, row_of
from kinlab.tables.read import read_table
from kinlab.tables.table import DHTable, Place, Row

ONE = DHTable((Row(a="1"),))
C, S = cos(radians(30)), sin(radians(30))
ODD = kl.homogeneous(kl.rotation_z(0.3) @ kl.rotation_y(0.2) @ kl.rotation_x(0.1), [1, 2, 3])


def typed(table, end, **cells):
    for column, text in cells.items():
        table = table.with_cell(end, column, text)
    return table


@pytest.mark.parametrize("cells, T", [
    ({"z": "0.303"}, [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.303]]),
    ({"yaw": "pi/2", "x": "2"}, [[0, -1, 0, 2], [1, 0, 0, 0], [0, 0, 1, 0]]),
    ({"roll": "-90"}, [[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0]]),
    # First about x, then about the fixed y: z goes to -y and stays there, x goes to -z.
    ({"roll": "90", "pitch": "90"}, [[0, 1, 0, 0], [0, 0, -1, 0], [-1, 0, 0, 0]]),
    ({"pitch": "30"}, [[C, 0, S, 0], [0, 1, 0, 0], [-S, 0, C, 0]])])
def test_a_typed_pose_is_a_frame(cells, T):
    arm = typed(ONE, "tool", **cells).arm
    np.testing.assert_allclose(arm.tool[:3], T, atol=1e-15)
    np.testing.assert_array_equal(arm.base, np.eye(4))


@pytest.mark.parametrize("convention, T", [
    ("standard", [[1, 0, 0, 3], [0, 0, -1, 0], [0, 1, 0, 2]]),
    ("modified", [[1, 0, 0, 3], [0, 0, -1, -2], [0, 1, 0, 0]])])
def test_a_typed_row_is_a_frame_of_its_convention(convention, T):
    table = typed(ONE.read_as(convention), "base", a="3", d="2", alpha="90")
    np.testing.assert_array_equal(table.arm.base[:3], T)


def test_cells_of_an_end_take_what_other_cells_take():
    table = typed(ONE.with_length(1, "L1", "0.25"), "tool", x="-2*L1", roll="(60-15) deg")
    assert table.values[Place("tool", "x")] == -0.5
    assert table.values[Place("tool", "roll")] == pytest.approx(pi / 4)


def test_a_wrong_cell_of_an_end_is_marked():
    table = typed(ONE, "tool", z="0,303", yaw="90")
    assert "decimal point" in table.errors[Place("tool", "z")]
    assert table.arm is None and table.end("tool") is None
    assert typed(table, "tool", z="0.303").arm.tool[2, 3] == 0.303


def test_a_matrix_is_shown_and_stays_until_a_cell_is_typed():
    table = DHTable.of(kl.Arm([kl.revolute(a=1)], tool=ODD))
    np.testing.assert_array_equal(table.arm.tool, ODD)
    assert list(table.tool.cells("deg").values())[:3] == ["1", "2", "3"]
    np.testing.assert_allclose([float(text) for text in table.tool.cells("rad").values()],
                               [1, 2, 3, 0.1, 0.2, 0.3])
    moved = table.with_cell("tool", "x", "7")
    np.testing.assert_allclose(moved.arm.tool[:3, 3], [7, 2, 3])
    np.testing.assert_allclose(moved.arm.tool[:3, :3], ODD[:3, :3], atol=1e-14)


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_a_row_and_a_pose_are_one_frame(convention):
    row = typed(ONE.read_as(convention), "tool", theta="40", d="-0.3", a="0.2", alpha="-70")
    pose = row.with_end("tool", "pose")
    np.testing.assert_allclose(pose.arm.tool, row.arm.tool, atol=1e-15)
    again = row_of(pose.end("tool"), convention)
    np.testing.assert_allclose(list(again.values()), [radians(40), -0.3, 0.2, radians(-70)])
    assert pose.with_end("tool", "row").tool.form == "row"
    assert row.with_end("tool", "row") is not None and row.with_end("tool", "row") == row


@pytest.mark.parametrize("edit, reason", [
    (lambda t: typed(t, "tool", x="1", y="2", pitch="30").with_end("tool", "row"),
     "form: expected a frame that one DH row makes"),
    (lambda t: typed(t, "tool", x="a").with_end("tool", "row"), "tool: expected cells that can be"),
    (lambda t: t.with_end("hand"), "end: expected 'base' or 'tool', got 'hand'"),
    (lambda t: t.with_end("tool", "matrix"), "form: expected 'pose' or 'row'"),
    (lambda t: t.with_cell("hand", "x", "1"), "end: expected"),
    (lambda t: t.with_end("tool").with_cell("tool", "alpha", "1"), "column: expected 'x' or"),
    (lambda t: t.with_cell("tool", "low", "1"), "column: expected 'x' or")])
def test_what_is_no_end_is_refused(edit, reason):
    with pytest.raises(ValueError, match=f"^{reason}"):
        edit(ONE)


def test_an_opened_end_changes_nothing_and_can_be_left_out():
    table = ONE.with_end("base")
    np.testing.assert_array_equal(table.arm.base, np.eye(4))
    assert table != ONE and table.without_end("base") == ONE


def test_ends_in_other_units():
    table = typed(ONE, "tool", x="0.5", z="-0.25", yaw="90")
    other = table.in_unit("mm").in_angles("rad")
    assert other.tool.cells("rad") == {"x": "500", "y": "0", "z": "-250", "roll": "0",
                                       "pitch": "0", "yaw": "pi/2"}
    given = DHTable.of(kl.Arm([kl.revolute(a=1)], tool=ODD)).in_unit("mm").in_angles("rad")
    np.testing.assert_allclose(given.arm.tool[:3, 3], [1000, 2000, 3000])


def test_the_same_arm_in_the_other_convention():
    table = typed(typed(ONE, "tool", z="0.3", y="0.1"), "base", a="1", theta="90")
    other = table.converted_to("modified")
    for q in ([0.0], [0.7]):
        np.testing.assert_allclose(kl.forward_kinematics(other.arm, q),
                                   kl.forward_kinematics(table.arm, q), atol=1e-14)
    deep = typed(DHTable((Row(), Row(a="1")), "modified"), "base", x="2 - 1", pitch="45")
    assert deep.converted_to("standard").base == deep.base  # as it was typed


def test_files_keep_what_was_typed():
    table = typed(typed(ONE, "tool", z="0.303", roll=""), "base", a="1", alpha="")
    assert to_csv(table).splitlines()[-4:-2] == ["base,row,0,0,1,", "tool,pose,0,0,0.303,,0,0"]
    assert read_table(to_csv(table), table).table == table
    given = DHTable.of(kl.Arm([kl.revolute(a=1)], tool=ODD))
    assert read_table(to_csv(given), given).table == given
    right = typed(ONE, "tool", z="0.303", roll="pi/2")
    np.testing.assert_array_equal(from_code(to_code(right)).arm.tool, right.arm.tool)


def test_no_file_has_a_zero_with_a_sign():
    shifted = np.array([[1, 0, 0, -0.0], [0, 1, 0, -0.0], [-0.0, 0, 1, 2], [0, 0, 0, 1]])
    table = DHTable.of(kl.Arm([kl.revolute(a=-0.0, theta=-0.0, alpha=-0.0, limits=(-0.0, 1))],
                              base=shifted, tool=shifted, home=[-0.0]))
    for text in (to_csv(table), to_code(table)):
        assert "-0" not in text


def test_a_frame_that_changes_nothing_is_none():
    assert End.of(np.eye(4)) is None
    assert pose_of(np.eye(4)) == dict.fromkeys(["x", "y", "z", "roll", "pitch", "yaw"], 0)
