"""Bad input is refused with one sentence that begins with the argument's name, never computed."""
import datetime
import re
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import example, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays

import kinlab as kl
from kinlab.arms.inputs import Note

ARM = kl.robots.alpha_ii()
ONE = kl.Arm([kl.revolute()])
TWO = kl.robots.two_link()
EYE = np.eye(4)
FLAT = kl.zyz_angles(np.eye(3))
LINKS = [kl.revolute(), kl.prismatic()]
FORK = """<robot name="Fork"> <link name="0"/> <link name="left"/> <link name="right"/>
    <joint name="l" type="continuous"> <parent link="0"/> <child link="left"/> </joint>
    <joint name="r" type="continuous"> <parent link="0"/> <child link="right"/> </joint> </robot>"""

HOME = ARM.home
POSE = kl.forward_kinematics(ARM, [0.1] * 5)


def solve(target=POSE, **options):
    return kl.inverse_kinematics(ARM, target, **{"restarts": 2, "steps": 9, **options})


def solve_all(targets=POSE[None], **options):
    return kl.inverse_kinematics_batch(ARM, targets, **{"restarts": 2, "steps": 9, **options})


def go(**options):
    return kl.straight_path(TWO, **({"T0": [1, 1, 0], "T1": [1.1, 1, 0], "duration": 1} | options))


def few(samples):
    """Whole numbers that are not too many to wait for."""
    return 1 + samples % 99 if isinstance(samples, int) and 0 < samples < 10**9 else samples


# Every argument of every public function, with a call that puts a value in its place.
NUMBERS = {
    "kl.revolute theta": lambda x: kl.revolute(theta=x),
    "kl.revolute d": lambda x: kl.revolute(d=x),
    "kl.revolute a": lambda x: kl.revolute(a=x),
    "kl.revolute alpha": lambda x: kl.revolute(alpha=x),
    "kl.fixed theta": lambda x: kl.fixed(theta=x),
    "kl.fixed d": lambda x: kl.fixed(d=x),
    "kl.fixed a": lambda x: kl.fixed(a=x),
    "kl.fixed alpha": lambda x: kl.fixed(alpha=x),
    "kl.prismatic theta": lambda x: kl.prismatic(theta=x),
    "kl.prismatic d": lambda x: kl.prismatic(d=x),
    "kl.prismatic a": lambda x: kl.prismatic(a=x),
    "kl.prismatic alpha": lambda x: kl.prismatic(alpha=x),
    "kl.Link theta": lambda x: kl.Link("revolute", theta=x),
    "kl.ZYZAngles phi": FLAT.member,
    "kl.axis_angle R": kl.axis_angle,
    "kl.quaternion R": kl.quaternion,
    "kl.AxisAngle axis": kl.axis_angle(np.eye(3)).member,
    "kl.RPYAngles yaw": kl.rpy_angles(kl.rotation_y(np.pi / 2)).member,
    "kl.forward_kinematics q": lambda x: kl.forward_kinematics(ARM, x),
    "kl.link_frames q": lambda x: kl.link_frames(ARM, x),
    "kl.jacobian q": lambda x: kl.jacobian(ARM, x),
    "kl.zyz_angles R": kl.zyz_angles,
    "kl.rpy_angles R": kl.rpy_angles,
    "kl.manipulability q": lambda x: kl.manipulability(ARM, x),
    "kl.rank q": lambda x: kl.rank(ARM, x),
    "kl.rank tolerance": lambda x: kl.rank(ARM, ARM.home, tolerance=x),
    "kl.singular_directions q": lambda x: kl.singular_directions(ARM, x),
    "kl.singular_directions tolerance": lambda x: kl.singular_directions(ARM, HOME, tolerance=x),
    "kl.inverse_kinematics target": lambda x: solve(x),
    "kl.inverse_kinematics tolerance": lambda x: solve(tolerance=x),
    "kl.inverse_kinematics_batch targets": lambda x: solve_all(x),
    "kl.inverse_kinematics_batch tolerance": lambda x: solve_all(tolerance=x),
    "kl.joint_path q0": lambda x: kl.joint_path(TWO, x, [0, 0], 1),
    "kl.joint_path q1": lambda x: kl.joint_path(TWO, [0, 0], x, 1),
    "kl.joint_path duration": lambda x: kl.joint_path(TWO, [0, 0], [1, 1], x),
    "kl.joint_path ramp": lambda x: kl.joint_path(TWO, [0, 0], [1, 1], 1, ramp=x),
    "kl.straight_path T0": lambda x: go(T0=x),
    "kl.straight_path T1": lambda x: go(T1=x),
    "kl.straight_path duration": lambda x: go(duration=x),
    "kl.straight_path ramp": lambda x: go(ramp=x),
}
SYMBOLS_TOO = {
    "kl.rotation_2d theta": kl.rotation_2d,
    "kl.rotation_x angle": kl.rotation_x,
    "kl.rotation_y angle": kl.rotation_y,
    "kl.rotation_z angle": kl.rotation_z,
    "kl.homogeneous R": lambda x: kl.homogeneous(x, [0, 0, 0]),
    "kl.homogeneous o": lambda x: kl.homogeneous(np.eye(3), x),
    "kl.translation o": kl.translation,
    "kl.inverse T": kl.inverse,
    "kl.apply T": lambda x: kl.apply(x, [0, 0, 0]),
    "kl.apply p": lambda x: kl.apply(EYE, x),
    "kl.compose transforms": kl.compose,
    "kl.compose transforms second": lambda x: kl.compose(EYE, x),
    "kl.zyz_matrix phi": lambda x: kl.zyz_matrix(x, 0, 0),
    "kl.zyz_matrix theta": lambda x: kl.zyz_matrix(0, x, 0),
    "kl.zyz_matrix psi": lambda x: kl.zyz_matrix(0, 0, x),
    "kl.rotation_about axis": lambda x: kl.rotation_about(x, 1),
    "kl.rotation_about angle": lambda x: kl.rotation_about([0, 0, 1], x),
    "kl.quaternion_matrix q": kl.quaternion_matrix,
    "kl.rpy_matrix roll": lambda x: kl.rpy_matrix(x, 0, 0),
    "kl.rpy_matrix pitch": lambda x: kl.rpy_matrix(0, x, 0),
    "kl.rpy_matrix yaw": lambda x: kl.rpy_matrix(0, 0, x),
}
NONE_TOO = {
    "kl.revolute limits": lambda x: kl.revolute(limits=x),
    "kl.prismatic limits": lambda x: kl.prismatic(limits=x),
    "kl.Arm base": lambda x: kl.Arm(LINKS, base=x),
    "kl.Arm tool": lambda x: kl.Arm(LINKS, tool=x),
    "kl.Arm home": lambda x: kl.Arm(LINKS, home=x),
    "kl.inverse_kinematics q0": lambda x: solve(q0=x),
    "kl.inverse_kinematics weights": lambda x: solve(weights=x),
    "kl.inverse_kinematics_batch q0": lambda x: solve_all(q0=x),
    "kl.inverse_kinematics_batch weights": lambda x: solve_all(weights=x),
    "kl.straight_path q0": lambda x: go(q0=x),
    "kl.straight_path weights": lambda x: go(weights=x),
}
OTHERS = {
    "kl.manipulability arm": lambda x: kl.manipulability(x, [0]),
    "kl.rank arm": lambda x: kl.rank(x, [0]),
    "kl.singular_directions arm": lambda x: kl.singular_directions(x, [0]),
    "kl.jacobian_form arm": kl.jacobian_form,
    "kl.workspace arm": kl.workspace,
    "kl.density_picture reached": kl.density_picture,
    "kl.envelope_picture reached": kl.envelope_picture,
    "kl.slice_picture reached": kl.slice_picture,
    "kl.joint_path arm": lambda x: kl.joint_path(x, [0], [1], 1),
    "kl.straight_path arm": lambda x: kl.straight_path(x, [0, 0, 0], [1, 1, 1], 1),
    "kl.inverse_kinematics arm": lambda x: kl.inverse_kinematics(x, [0, 0, 0]),
    "kl.inverse_kinematics_batch arm": lambda x: kl.inverse_kinematics_batch(x, [[0, 0, 0]]),
    "kl.Arm links": kl.Arm,
    "kl.forward_kinematics arm": lambda x: kl.forward_kinematics(x, [0]),
    "kl.link_frames arm": lambda x: kl.link_frames(x, [0]),
    "kl.jacobian arm": lambda x: kl.jacobian(x, [0]),
    "kl.closed_form arm": kl.closed_form,
    "kl.to_modified arm": kl.to_modified,
    "kl.to_standard arm": kl.to_standard,
    "kl.to_urdf arm": kl.to_urdf,
    "kl.from_urdf path_or_text": kl.from_urdf,
    "kl.urdf_frames path_or_text": kl.urdf_frames,
    "kl.from_urdf tip": lambda x: kl.from_urdf(FORK, x),
    "kl.urdf_frames tip": lambda x: kl.urdf_frames(FORK, x),
}
WORDS = {
    "kl.rpy_angles order": lambda x: kl.rpy_angles(np.eye(3), x),
    "kl.rpy_matrix order": lambda x: kl.rpy_matrix(0, 0, 0, x),
    "kl.Link kind": kl.Link,
    "kl.Arm convention": lambda x: kl.Arm(LINKS, convention=x),
    "kl.closed_form lengths": lambda x: kl.closed_form(ONE, lengths=x),
    "kl.jacobian_form lengths": lambda x: kl.jacobian_form(ONE, lengths=x),
    "kl.inverse_kinematics method": lambda x: solve(method=x),
    "kl.inverse_kinematics limits": lambda x: solve(limits=x),
    "kl.inverse_kinematics_batch method": lambda x: solve_all(method=x),
    "kl.inverse_kinematics_batch limits": lambda x: solve_all(limits=x),
    "kl.joint_path profile": lambda x: kl.joint_path(TWO, [0, 0], [1, 1], 1, x),
    "kl.straight_path profile": lambda x: go(profile=x),
}
LINES = {
    "kl.Arm name": lambda x: kl.Arm(LINKS, name=x),
    "kl.Arm unit": lambda x: kl.Arm(LINKS, unit=x),
    "kl.revolute name": lambda x: kl.revolute(name=x),
    "kl.prismatic name": lambda x: kl.prismatic(name=x),
    "kl.fixed name": lambda x: kl.fixed(name=x),
}
FRAMES = {
    "kl.closed_form start": lambda x: kl.closed_form(ONE, x),
    "kl.closed_form stop": lambda x: kl.closed_form(ONE, 0, x),
}
COUNTS = {
    "kl.workspace samples": lambda x: kl.workspace(ARM, few(x)).points,
    "kl.workspace seed": lambda x: kl.workspace(ARM, 9, seed=x).points,
    "kl.inverse_kinematics restarts": lambda x: solve(restarts=x),
    "kl.inverse_kinematics seed": lambda x: solve(seed=x),
    "kl.inverse_kinematics steps": lambda x: solve(steps=x),
    "kl.inverse_kinematics_batch restarts": lambda x: solve_all(restarts=x),
    "kl.inverse_kinematics_batch seed": lambda x: solve_all(seed=x),
    "kl.inverse_kinematics_batch steps": lambda x: solve_all(steps=x),
}
ROWS = {
    "kl.manipulability rows": lambda x: kl.manipulability(ARM, HOME, x),
    "kl.rank rows": lambda x: kl.rank(ARM, HOME, x),
    "kl.singular_directions rows": lambda x: kl.singular_directions(ARM, HOME, x),
}
EVERY = NUMBERS | SYMBOLS_TOO | NONE_TOO | OTHERS | WORDS | LINES | FRAMES | COUNTS | ROWS
every = pytest.mark.parametrize("call", EVERY)

NEVER_A_NUMBER = [
    "1", "", "half a turn", b"1", object(), object, len, {}, {"q": 1}, {1.0}, 1j, 1 + 0j,
    [1, "2"], ["1", "2", "3"], [[1, 2], [3]], [None], [1, None, 3], [object()], [[[]], 1],
    float("nan"), float("inf"), -float("inf"), [float("nan")] * 3, [1, 2, float("inf")], 10**400,
    [10**400, 1, 2], 1e200, -1e200, [1e308] * 3, np.full((4, 4), np.nan), np.full(5, np.inf),
    np.float64("nan"), Decimal("NaN"), Decimal("Infinity"), datetime.datetime(2024, 1, 1),
    np.datetime64("2024-01-01"), np.array(["a", "b", "c"]), np.zeros(3, dtype="c16"),
    np.zeros(3, dtype=[("x", float)]), (k for k in range(3)), range, slice(3), ..., NotImplemented,
    sp.nan, sp.zoo, sp.oo, sp.I, [sp.oo, 0, 0], [sp.Symbol("x"), "1", 0],
    [sp.Symbol("x"), float("nan"), 0], sp.Eq(sp.Symbol("x"), 1), sp.Symbol("x") < 1,
    sp.FiniteSet(1), kl, kl.Arm, ARM, kl.revolute(), lambda q: q, Exception("no"),
]


def refuse(call, value):
    """The message of the ValueError that the value must raise."""
    with warnings.catch_warnings(), pytest.raises(ValueError) as caught:
        warnings.simplefilter("error")
        EVERY[call](value)
    assert call.split()[1] in names_in(caught.value)
    return str(caught.value)


def names_in(error):
    """The arguments that a message of one line is about."""
    start = re.match(r"(\w+(, \w+)*)(\[\d+\])?(\[:3, :3\])?: expected ", str(error))
    assert start and len(str(error).splitlines()) == 1, str(error)
    return start.group(1).split(", ")


def is_finite(result):
    """No NaN and no infinity anywhere in what a call returned."""
    if isinstance(result, np.ndarray) and result.dtype != object:
        return np.isfinite(result).all()
    if isinstance(result, kl.Arm):
        return all(map(is_finite, (result.base, result.tool, result.home)))
    if isinstance(result, kl.Link):
        return all(map(np.isfinite, (result.theta, result.d, result.a, result.alpha)))
    if isinstance(result, kl.Quaternion):
        return np.isfinite(result.array).all()
    if isinstance(result, kl.ClosedForm):
        return not result.matrix.has(sp.nan, sp.oo, sp.zoo)
    if isinstance(result, kl.InverseResult | kl.InverseBatch):
        return all(map(np.all, map(np.isfinite, (result.q, result.position_error))))
    if isinstance(result, kl.Path):  # singular places have infinite rates
        return np.isfinite(result.q).all() and np.isfinite(result.tip_speed).all()
    if isinstance(result, kl.ZYZAngles | kl.RPYAngles | kl.AxisAngle | tuple):
        return all(np.isfinite(part).all() for part in result)
    return not any(entry != entry or entry in (sp.oo, -sp.oo, sp.zoo) for entry in result.flat)


@pytest.mark.parametrize("call", NUMBERS | SYMBOLS_TOO | NONE_TOO)
def test_what_is_no_number_is_refused(call):
    for value in NEVER_A_NUMBER:
        refuse(call, value)


@pytest.mark.parametrize("call", NUMBERS | SYMBOLS_TOO)
def test_none_is_refused(call):
    refuse(call, None)


@pytest.mark.parametrize("call", NUMBERS | NONE_TOO)
def test_symbols_are_refused_where_only_numbers_work(call):
    refuse(call, sp.Symbol("x"))
    refuse(call, [sp.Symbol("x"), 0])


@pytest.mark.parametrize("call", OTHERS)
def test_what_is_no_arm_is_refused(call):
    for value in [*NEVER_A_NUMBER, None, 1, [], (), np.zeros(3), "abc", [1, 2], [None]]:
        if value is not ARM:
            refuse(call, value)


@pytest.mark.parametrize("call", WORDS)
def test_unknown_words_are_refused(call):
    for value in [*NEVER_A_NUMBER, None, 1, "Standard", "standard ", "craig", ["standard"]]:
        assert "or '" in refuse(call, value)


@pytest.mark.parametrize("call", LINES)
def test_names_are_one_line_of_text(call):
    for value in (1, b"arm", ["arm"], object(), float("nan"), "two\nlines"):
        refuse(call, value)


@pytest.mark.parametrize("call", FRAMES)
def test_frames_that_do_not_exist_are_refused(call):
    for value in [*NEVER_A_NUMBER, -1, 2, 99, 0.0, 0.5, "0", [0], np.array([0, 1])]:
        refuse(call, value)


@pytest.mark.parametrize("call", COUNTS)
def test_counts_are_whole_numbers(call):
    for value in [*NEVER_A_NUMBER, None if "restarts" not in call else -2, -1, 0.5, "0", [1]]:
        refuse(call, value)


@pytest.mark.parametrize("call", ROWS)
def test_rows_are_those_of_a_jacobian(call):
    for value in (None, 1, "", "0", [], [-1], [6], [0.0], [0, "1"], [[0]], 1j, object()):
        refuse(call, value)


def test_frames_in_the_wrong_order_are_refused():
    with pytest.raises(ValueError, match=r"^start, stop: expected frames 0 <= start <= stop <= 5"):
        kl.closed_form(ARM, 4, 3)
    with pytest.raises(ValueError, match="start=None"):
        kl.closed_form(ARM, None)


numbers = st.floats() | st.sampled_from([0, 1, -1, 0.0, -0.0, 5e-324, 1e-300, 1e99, -1e99, 1e101])
junk = st.one_of(
    numbers, st.integers(), st.booleans(), st.text(max_size=3), st.none(), st.binary(max_size=2),
    st.complex_numbers(), st.fractions(), st.decimals(), st.dates(),
    st.sampled_from([v for v in NEVER_A_NUMBER if not isinstance(v, type(k for k in ()))]),
    st.sampled_from([sp.Symbol("x"), sp.pi, sp.Rational(1, 3), sp.sin(sp.Symbol("x"))]),
    st.lists(numbers | st.none() | st.text(max_size=2), max_size=6),
    st.lists(st.lists(numbers, max_size=4), max_size=4),
    arrays(float, array_shapes(max_dims=4, max_side=5, min_side=0), elements=numbers),
    arrays(float, st.sampled_from([(5,), (2, 5), (3,), (3, 3), (4, 4), (2, 4, 4)]),
           elements=st.sampled_from([0.0, 1.0, -1.0])),
    arrays(st.sampled_from([bool, int, complex, "U2", "M8[s]", object, np.float32, np.uint8]),
           array_shapes(max_dims=2, max_side=5), fill=st.nothing()),
)


@every
@given(value=junk)
@example(value=np.eye(4))
@example(value=np.eye(3))
@settings(max_examples=40)
def test_anything_is_computed_or_refused_in_one_sentence(call, value):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", Note)
        try:
            result = EVERY[call](value)
        except ValueError as error:
            arguments = {other.split()[1] for other in EVERY if other.split()[0] == call.split()[0]}
            assert arguments.intersection(names_in(error))
        else:
            assert is_finite(result)


def test_every_public_function_is_listed_here():
    elsewhere = {"ArmView", "ClosedForm", "DHTableEditor", "InverseBatch", "InverseResult",
                 "Path", "PathView", "Quaternion", "TargetView", "Workspace", "examine_frames",
                 "exercises", "frames_view", "lessons", "link_view", "parse_number", "predict",
                 "robots", "same_mechanism", "show", "solve_view", "velocity_view"}
    listed = {call.split()[0].removeprefix("kl.") for call in EVERY}
    assert set(kl.__all__) - elsewhere <= listed


@given(value=junk)
@example(value=float("nan"))
@example(value=[[1, 2], [3]])
def test_anything_can_be_shown(value):
    assert repr(kl.show(value=value)).startswith("value = ")


@pytest.mark.parametrize("digits", [-1, 2.5, "3", None])
def test_digits_that_cannot_be_are_refused(digits):
    with pytest.raises(ValueError, match="digits: "):
        kl.show(digits=digits, c=1)


@pytest.mark.parametrize("call", ["kl.forward_kinematics q", "kl.link_frames q", "kl.jacobian q"])
def test_shapes_of_joint_values(call):
    for value in (0, [], [0] * 4, [0] * 6, np.zeros((5, 4)), np.zeros((5, 1)), np.zeros((2, 3, 4))):
        got = re.escape(str(np.shape(value)))
        message = refuse(call, value)
        assert re.match(rf"q: expected shape \(\.\.\., 5\) for arm 'Alpha II', got {got}", message)


def test_an_unnamed_arm_in_a_message():
    with pytest.raises(ValueError, match=r"^q: expected shape \(\.\.\., 1\) for this arm, got"):
        kl.forward_kinematics(ONE, [0, 0])


@pytest.mark.parametrize("limits", [(1, -1), (1,), (1, 2, 3), [[1, 2]], [[1, 2], [3, 4]],
                                    [[1, 2], [3, 4], [5, 6]], 1, ()])
def test_limits(limits):
    assert "two numbers" in refuse("kl.revolute limits", limits) or limits == (1, -1)


def test_reversed_limits_say_what_to_do():
    assert refuse("kl.revolute limits", (1, -1)).endswith("got (1, -1); swap them")


def test_an_arm_needs_a_link():
    assert refuse("kl.Arm links", []) == (
        "links: expected at least one link, got []; make them with revolute() and prismatic()")


@pytest.mark.parametrize("home", [0.0, [], [0], [0, 0, 0], [[0, 0]], [[0, 0], [0, 0]]])
def test_home_fits_the_arm(home):
    assert "2 joint values" in refuse("kl.Arm home", home)


def bent(i, j, by):
    T = np.eye(4)
    T[i, j] += by
    return T


@pytest.mark.parametrize("call", ["kl.Arm base", "kl.Arm tool"])
@pytest.mark.parametrize("T", [
    2 * np.eye(4), np.diag([2.0, 1, 1, 1]), np.diag([1.0, 1, -1, 1]), np.diag([1.0, 1, 1, 2]),
    np.zeros((4, 4)), np.ones((4, 4)), np.eye(3), np.eye(5), np.zeros((0, 4, 4)),
    np.stack([np.eye(4)] * 2), np.eye(4)[None], np.zeros(3),
    *(bent(i, j, 1e-2) for i in range(4) for j in range(4) if j < 3 or i == 3)])
def test_base_and_tool_are_rigid(call, T):
    refuse(call, T)


def test_what_a_rigid_matrix_lacks_is_named():
    assert "off by 3" in refuse("kl.Arm base", np.diag([2.0, 1, 1, 1]))
    assert "mirror image" in refuse("kl.Arm base", np.diag([1.0, 1, -1, 1]))
    assert "last row 0 0 0 1, got [1.0, 0.0, 0.0, 1.0]; the origin is the last column" in refuse(
        "kl.Arm base", bent(3, 0, 1))
    assert "4x4 homogeneous matrix, as homogeneous(R, o) makes it, got shape (3, 3)" in refuse(
        "kl.Arm tool", np.eye(3))


def test_an_angle_before_its_axis_is_told_the_order():
    assert refuse("kl.rotation_about axis", 1) == (
        "axis: expected three numbers, shape (..., 3), got (); give the axis first, then the angle")


def test_a_quaternion_of_another_length_is_told_its_length():
    for q, length in (([0, 0, 0, 0], "0"), ([1, 2, 3, 4], "5.477"), ([0.71, 0, 0, 0.71], "1.004")):
        assert f"got one of length {length}; give numbers whose squares add up to 1" in refuse(
            "kl.quaternion_matrix q", q)


@pytest.mark.parametrize("call", ["kl.inverse T", "kl.apply T", "kl.compose transforms",
                                  "kl.homogeneous R", "kl.zyz_angles R", "kl.rpy_angles R",
                                  "kl.axis_angle R", "kl.quaternion R"])
def test_matrices_that_are_not_rigid_are_refused(call):
    for n in (2, 3, 4, 5):
        for matrix in (2 * np.eye(n), np.zeros((n, n)), np.ones((n, n)), np.diag([1.0] * (n - 1) +
                       [-1]), np.eye(n) + 0.01, np.eye(n)[:-1], np.eye(n)[0], sp.eye(n) * 3):
            refuse(call, matrix)


@pytest.mark.parametrize("names, compute", [
    ("R, o", lambda: kl.homogeneous(np.stack([np.eye(3)] * 3), np.zeros((2, 3)))),
    ("R, o", lambda: kl.homogeneous(np.eye(3), [0, 0])),
    ("T, p", lambda: kl.apply(np.stack([EYE] * 3), np.zeros((2, 3)))),
    ("p", lambda: kl.apply(EYE, [1, 2, 3, 1])),
    ("transforms", lambda: kl.compose(np.stack([EYE] * 3), np.stack([EYE] * 2))),
    ("transforms", lambda: kl.compose(np.eye(3), np.eye(4))),
    ("transforms", lambda: kl.compose()),
    ("phi, theta, psi", lambda: kl.zyz_matrix([1, 2], [1, 2, 3], 0)),
    ("yaw, pitch, roll", lambda: kl.rpy_matrix([1, 2], [1, 2, 3], 0)),
    ("R", lambda: kl.rpy_angles(np.eye(2))),
    ("R", lambda: kl.axis_angle(np.eye(2))),
    ("R", lambda: kl.quaternion(np.eye(2))),
    ("axis, angle", lambda: kl.rotation_about(np.ones((2, 3)), [1, 2, 3])),
    ("axis", lambda: kl.rotation_about([0, 1], 1)),
    ("axis", lambda: kl.rotation_about([0, 0, 0], 1)),
    ("axis", lambda: kl.rotation_about([[0, 0, 1], [0, 0, 0]], 1)),
    ("axis", lambda: kl.axis_angle(np.eye(3)).member([0, 0, 0])),
    ("q", lambda: kl.quaternion_matrix([1, 0, 0])),
    ("q", lambda: kl.quaternion_matrix([1, 1, 0, 0])),
    ("R", lambda: kl.zyz_angles(np.eye(2))),
])
def test_arguments_that_do_not_fit_together(names, compute):
    with pytest.raises(ValueError, match=f"^{names}: expected "):
        compute()


def test_odd_but_good_numbers_are_taken():
    for one in (1, True, np.float32(1), np.int8(1), Fraction(1), Decimal(1), sp.Integer(1)):
        assert kl.revolute(a=one).a == 1
    assert kl.forward_kinematics(ONE, [Fraction(1, 2)])[0, 0] == pytest.approx(np.cos(0.5))
    with pytest.warns(Note):
        assert np.isfinite(kl.forward_kinematics(ARM, np.full((2, 5), 1e99))).all()
