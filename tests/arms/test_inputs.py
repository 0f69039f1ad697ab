"""What is no number is refused before numpy makes one of it."""
import warnings
from decimal import Decimal
from fractions import Fraction
from math import pi

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from strategies import rotations
from textbook import rigid, turn

import kinlab as kl
from kinlab.arms import inputs
from kinlab.arms.inputs import RIGID_TOLERANCE, Note, note, real_array, rotation


@pytest.mark.parametrize("value", [[Decimal(1), "2"], [Fraction(1, 2), b"2"],
                                   [[sp.Integer(1), "1"]]])
def test_text_among_other_numbers_is_no_number(value):
    """numpy would read it as one."""
    with pytest.raises(ValueError, match=r"^q: expected two numbers, got .*; give plain numbers$"):
        real_array("q", value, "two numbers")


@pytest.mark.parametrize("value", [sp.nan, [sp.nan, 0], [[sp.nan]]])
def test_sympys_nan_is_refused_without_a_warning(value):
    """numpy 1.26 warns where it makes a float of it."""
    with warnings.catch_warnings(), pytest.raises(ValueError, match=r"^q: expected finite"):
        warnings.simplefilter("error")
        real_array("q", value, "two numbers")


@pytest.mark.parametrize("value, floats", [
    ([Decimal("0.5"), Fraction(1, 4), sp.Rational(3, 4)], [0.5, 0.25, 0.75]),
    ([[sp.pi, 1]], [[3.141592653589793, 1.0]]), (sp.Integer(2), 2.0),
    (np.array([], dtype=object), []), ([10**30, 1], [1e30, 1.0])])
def test_numbers_of_other_kinds_are_read_in_their_shape(value, floats):
    array = real_array("q", value, "numbers")
    assert array.dtype == float and array.tolist() == floats


def test_a_note_names_the_line_outside_the_package():
    inside = {"__name__": "kinlab.some.module", "note": note}
    exec("def taken(): deeper()\ndef deeper(): note('q: taken as it is')", inside)
    with pytest.warns(Note, match=r"^q: taken as it is$") as caught:
        inside["taken"]()
    assert caught[0].filename == __file__
    line = open(__file__).read().splitlines()[caught[0].lineno - 1]
    assert line.strip() == 'inside["taken"]()'


def test_a_note_of_a_script_that_calls_it_itself_names_that_line():
    with pytest.warns(Note) as caught:
        note("q: taken as it is")
    assert caught[0].filename == __file__


def test_a_package_with_a_longer_name_is_the_students():
    students = {"__name__": "kinlab_solutions.week_2", "note": note}
    exec(compile("def taken(): note('q: taken')", "week_2.py", "exec"), students)
    with pytest.warns(Note) as caught:
        students["taken"]()
    assert caught[0].filename == "week_2.py"


AS_PRINTED = [[0.866, -0.5, 0], [0.5, 0.866, 0], [0, 0, 1]]
THIRTY_DEGREES = [[3**0.5 / 2, -0.5, 0], [0.5, 3**0.5 / 2, 0], [0, 0, 1]]


def test_a_rotation_as_printed_is_taken_as_the_nearest_with_a_word():
    """1 - 0.866**2 - 0.5**2 is 0.000044."""
    with pytest.warns(Note) as caught:
        R = rotation("R", AS_PRINTED)
    assert [str(word.message) for word in caught] == [
        "R: taken as the nearest rotation; its entries are rounded, off by 4.4e-05"]
    np.testing.assert_allclose(R.T @ R, np.eye(3), atol=1e-15)
    np.testing.assert_allclose(R, THIRTY_DEGREES, atol=3e-5)
    assert (R[:, 2] == [0, 0, 1]).all() and (R[2] == [0, 0, 1]).all()


def nearest(matrix):
    """The polar factor by a singular value decomposition."""
    left, _, right = np.linalg.svd(matrix)
    return left @ right


@given(rotations(st.floats(-7, 7)), st.integers(3, 5))
@pytest.mark.filterwarnings("ignore::kinlab.arms.inputs.Note")
def test_every_rotation_of_three_decimals_or_more_is_taken(R, decimals):
    rounded = np.round(R, decimals)
    taken = rotation("R", rounded)
    np.testing.assert_allclose(taken, nearest(rounded), atol=2e-6)
    assert (taken == rounded).all() or abs(taken.T @ taken - np.eye(3)).max() < 2e-15
    planar = np.round(kl.rotation_2d(R[0, 0]), decimals)
    np.testing.assert_allclose(rotation("R", planar), nearest(planar), atol=2e-6)


def test_the_worst_rotation_of_three_decimals_is_taken():
    """Its third column is off by nearly half of the last decimal in all entries, one way."""
    third = np.array([0.57749, 0.57749, 0.57708])
    first = np.array([1, -1, 0]) / 2**0.5
    R = np.stack([first, np.cross(third, first), third], axis=-1)
    with pytest.warns(Note):
        rotation("R", np.round(R / np.linalg.norm(R, axis=0), 3))


@given(rotations(st.floats(-7, 7)), st.floats(0, 0.2 * RIGID_TOLERANCE))
def test_a_rotation_that_is_right_stays_as_it_is(R, noise):
    R = R + noise * np.array([[1, -1, 1], [1, 1, -1], [-1, 1, 1]])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert (rotation("R", R) == R).all()


def test_many_rotations_have_one_word_and_the_right_ones_stay():
    right = turn((0.6, 0, 0.8), 0.3)
    with pytest.warns(Note) as caught:
        R = rotation("R", [right, AS_PRINTED, right, np.round(right, 4)])
    assert len(caught) == 1
    assert (R[0] == right).all() and (R[2] == right).all()
    np.testing.assert_allclose(np.swapaxes(R, 1, 2) @ R, [np.eye(3)] * 4, atol=1e-15)


@pytest.mark.parametrize("R, off", [
    ([[0.87, -0.5, 0], [0.5, 0.87, 0], [0, 0, 1]], "0.0069"),
    ([[1, 0.01], [0, 1]], "0.01"), (np.diag([2.0, 1, 1]), "3")])
def test_what_is_no_rounded_rotation_is_told_how_far_off_it_is(R, off):
    with pytest.raises(ValueError, match=f"^R: expected a rotation .*, got one that is off by {off}"
                       "; check its entries, or give at least 3 decimals$"):
        rotation("R", R)


def test_a_rounded_mirror_image_is_a_mirror_image():
    with pytest.raises(ValueError, match="mirror image"):
        rotation("R", np.array(AS_PRINTED) * [1, 1, -1])


POSE = rigid(AS_PRINTED, (1, 2, 3))
EXACT = rigid(THIRTY_DEGREES, (1, 2, 3))
BACK = [3**0.5 / -2 - 1, 0.5 - 3**0.5, -3]


@pytest.mark.parametrize("argument, taken, exact", [
    ("base", lambda: kl.Arm([kl.revolute()], base=POSE).base, EXACT),
    ("tool", lambda: kl.Arm([kl.revolute()], tool=POSE).tool, EXACT),
    ("R", lambda: kl.homogeneous(AS_PRINTED, [1, 2, 3]), EXACT),
    ("R", lambda: kl.homogeneous([[0.866, -0.5], [0.5, 0.866]], [1, 2]), EXACT[np.ix_([0, 1, 3],
                                                                                  [0, 1, 3])]),
    ("T", lambda: kl.inverse(POSE), rigid(np.transpose(THIRTY_DEGREES), BACK)),
    ("T", lambda: kl.apply(POSE, [0, 0, 0]), [1, 2, 3]),
    ("transforms", lambda: kl.compose(np.eye(4), POSE), EXACT),
    ("R", lambda: kl.zyz_angles(AS_PRINTED).fixed, np.radians(30)),
])
def test_every_argument_that_is_a_rotation_may_be_rounded(argument, taken, exact):
    with pytest.warns(Note, match=rf"^{argument}\b.*: taken as the nearest rotation") as caught:
        result = taken()
    assert len(caught) == 1 and caught[0].filename == __file__
    np.testing.assert_allclose(np.asarray(result, dtype=float), exact, atol=1e-4)


def test_targets_as_printed_are_reached():
    arm = kl.robots.intelledex_660t()
    T = kl.forward_kinematics(arm, np.linspace(0.1, 0.6, 30).reshape(5, 6))
    with pytest.warns(Note, match=r"^target\[:3, :3\]: taken"):
        one = kl.inverse_kinematics(arm, np.round(T[0], 4))
    with pytest.warns(Note, match=r"^targets\[:3, :3\]: taken") as caught:
        many = kl.inverse_kinematics_batch(arm, np.round(T, 4))
    assert one.success and many.success.all() and len(caught) == 1
    np.testing.assert_allclose(kl.forward_kinematics(arm, many.q), T, atol=1e-3)


def test_symbols_beside_a_rounded_rotation_stay():
    x = sp.Symbol("x")
    with pytest.warns(Note):
        T = kl.homogeneous(np.array(AS_PRINTED, dtype=object), [x, 0, 0])
    assert T[0, 3] == x and float(T[0, 0]) == pytest.approx(3**0.5 / 2, abs=3e-5)


def test_exact_numbers_stay_exact():
    half = sp.sqrt(3) / 2
    T = kl.homogeneous([[half, -sp.Rational(1, 2)], [sp.Rational(1, 2), half]], [0, 0])
    assert T[0, 0] == half


@pytest.mark.parametrize("solve", [kl.zyz_angles, kl.rpy_angles, kl.axis_angle, kl.quaternion])
@pytest.mark.parametrize("given, help", [
    (np.eye(4), r"\(4, 4\); take T\[:3, :3\], the rotation of a pose T"),
    (np.eye(2), r"\(2, 2\); a planar rotation has one angle, atan2\(r21, r11\)"),
    ([0.1, 0.2, 0.3], r"\(3,\); give three rows of three numbers"),
    ([[1, 0, 0], [0, 1, 0]], r"\(2, 3\); give three rows of three numbers")])
def test_what_is_no_rotation_in_space_is_told_what_to_give(solve, given, help):
    with pytest.raises(ValueError, match=rf"^R: expected a rotation of shape .*, got {help}$"):
        solve(given)


TWO = kl.robots.two_link()


@pytest.mark.parametrize("call, words", [
    (lambda: kl.revolute(alpha=90), "alpha: 90 is 14.3 turns; angles are in radians: "
                                    "np.radians(90)"),
    (lambda: kl.revolute(theta=-45), "theta: -45 is 7.16 turns; angles are in radians: "
                                    "np.radians(-45)"),
    (lambda: kl.prismatic(alpha=90), "alpha: 90 is"),
    (lambda: kl.fixed(alpha=180), "alpha: 180 is"),
    (lambda: kl.revolute(limits=(-170, 170)), "limits: -170 is"),
    (lambda: kl.forward_kinematics(TWO, [90, 45]), "q: 90 is"),
    (lambda: kl.Arm([kl.prismatic(), kl.revolute()], home=[500, 90]), "home: 90 is"),
    (lambda: kl.forward_kinematics(TWO, np.full((3, 4, 2), -30.5)), "q: -30.5 is 4.85 turns"),
    (lambda: kl.link_frames(TWO, [0, 45]), "q: 45 is"),
    (lambda: kl.jacobian(TWO, [0, 45]), "q: 45 is"),
    (lambda: kl.ArmView(TWO, [0, 45]), "q: 45 is"),
    (lambda: kl.inverse_kinematics(TWO, [1, 1, 0], [0, 45]), "q0: 45 is"),
    (lambda: kl.rotation_z(90), "angle: 90 is"),
])
def test_degrees_are_taken_with_a_word(call, words):
    with pytest.warns(inputs.Note) as said:
        call()
    (note,) = (one for one in said if one.category is inputs.Note)  # traitlets has words, too
    assert str(note.message).startswith(words) and note.filename == __file__


@pytest.mark.parametrize("call", [
    lambda: kl.revolute(alpha=4 * pi, theta=-4 * pi, limits=(-12.5, 12.5), d=900, a=-900),
    lambda: kl.prismatic(d=300, limits=(0, 400)),
    lambda: kl.forward_kinematics(TWO, [4 * pi, -7]),
    lambda: kl.forward_kinematics(kl.robots.cylindrical(), [3, 400, -400]),
    lambda: kl.forward_kinematics(TWO, np.zeros((0, 2))),
    lambda: kl.inverse_kinematics(kl.robots.alpha_ii(), [300, 100, 200]),
    lambda: kl.rotation_x(sp.Symbol("t")),
])
def test_radians_and_lengths_are_taken_without_a_word(call):
    with warnings.catch_warnings():
        warnings.simplefilter("error", inputs.Note)
        call()


@pytest.mark.parametrize("call", [kl.forward_kinematics, kl.link_frames, kl.jacobian, kl.ArmView])
def test_symbols_in_a_pose_lead_to_the_closed_form(call):
    with pytest.raises(ValueError, match=r"got \(q1, q2\); for symbols take kl.closed_form\(arm\)"):
        call(TWO, sp.symbols("q1 q2"))
    with pytest.raises(ValueError, match=r"^q: .* give plain numbers$"):
        call(TWO, ["1", "2"])


def test_symbols_in_a_row_lead_to_the_closed_form():
    with pytest.raises(ValueError, match=r"^a: .* a1; .*kl.closed_form\(arm, symbols=...\)"):
        kl.revolute(a=sp.Symbol("a1"))


@pytest.mark.parametrize("rows", [[[0, 0.1, 0, 90]], np.array([[0, 0.1, 0, 90]]),
                                  [(0, 0.1, 0, 90)], [{"theta": 0}], "abc"])
def test_rows_without_names_are_refused_with_an_example(rows):
    with pytest.raises(ValueError, match=r"as row 1; name its numbers: revolute\(theta=0, d=0.1, "
                                         r"a=0, alpha=np.radians\(90\)\)$"):
        kl.Arm(rows)
    with pytest.raises(ValueError, match="as row 2; "):
        kl.Arm([kl.revolute(), *rows])


def test_a_number_too_long_to_write_is_said_to_be_that():
    with pytest.raises(ValueError, match=r"q: expected a number, got a value of type int that is "
                                         r"too long to show"):
        inputs.number("q", 10**5000)
