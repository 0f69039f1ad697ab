"""Paths along a line in space: on the line, on one branch, and right about their rates."""
import numpy as np
import pytest

import kinlab as kl
from kinlab.paths.along import Along
from kinlab.paths.branch import Lost, Walk

TWO = kl.robots.two_link()
SIX = kl.robots.intelledex_660t()
Q0, Q1 = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], [0.5, 0.4, 0.5, 0.1, 0.9, 0.2]


def six_joints(profile="quintic"):
    T0, T1 = (kl.forward_kinematics(SIX, q) for q in (Q0, Q1))
    return T0, T1, kl.straight_path(SIX, T0, T1, 3, profile, Q0)


def off_line(path):
    """How far the tool point is from the line between its first and its last place."""
    way, along = path.tip - path.tip[0], path.tip[-1] - path.tip[0]
    return np.linalg.norm(np.cross(way, along), axis=1).max() / np.linalg.norm(along)


def test_two_links_by_hand():
    """From (1, 1) to (1, -1) on links of 1 m: at x = 1, y = 0 the elbow is at 60 degrees.

    There J = [[0, s], [1, 1/2]] with s = sin 60, v = (0, -2 * 1.875 / 2): the second joint rests.
    """
    path = kl.straight_path(TWO, [1, 1, 0], [1, -1, 0], 2, q0=[0, np.pi / 2])
    assert path.q[0] == pytest.approx([0, np.pi / 2], abs=1e-9)
    assert path.q[-1] == pytest.approx([-np.pi / 2, np.pi / 2], abs=1e-9)
    middle = int(np.flatnonzero(path.t == 1)[0])
    assert path.at(1) == pytest.approx([-np.pi / 3, 2 * np.pi / 3], abs=1e-9)
    assert path.rates[middle] == pytest.approx([-1.875, 0], abs=1e-9)
    assert path.tip_speed[middle] == pytest.approx(1.875)
    assert off_line(path) < 1e-12


@pytest.mark.parametrize("profile", ("cubic", "quintic", "trapezoidal"))
def test_a_whole_pose_goes_evenly_along_a_line_and_about_one_axis(profile):
    T0, T1, path = six_joints(profile)
    assert path.T[0] == pytest.approx(T0, abs=1e-8) and path.T[-1] == pytest.approx(T1, abs=1e-8)
    assert off_line(path) < 1e-9
    axis, angle = kl.axis_angle(T1[:3, :3] @ T0[:3, :3].T)
    gone = np.linalg.norm(path.tip - path.tip[0], axis=1) / np.linalg.norm(T1[:3, 3] - T0[:3, 3])
    turned = path.T[:, :3, :3] @ T0[:3, :3].T
    assert turned == pytest.approx(kl.rotation_about(axis, gone * angle), abs=1e-8)


def numerically(path, h=1e-3):
    """Rates and accelerations by fine differences of `at`, and the path's own, inside it."""
    t = path.duration * np.array([0.0531, 0.213, 0.377, 0.5123, 0.67, 0.811, 0.957])
    far, near, here, after, beyond = (path.at(t + k * h) for k in (-2, -1, 0, 1, 2))
    rates = (8 * (after - near) - (beyond - far)) / (12 * h)
    bends = (16 * (near + after) - 30 * here - far - beyond) / (12 * h**2)
    return rates, bends, path._motion.states(t)[1:]


def paths():
    home = [0, -0.6, 1.2, -0.6, 0]  # the tool points down
    tool = kl.forward_kinematics(kl.robots.alpha_ii(), home)
    moved = kl.translation([-60, 100, 40]) @ tool
    return {
        "two links": lambda: kl.straight_path(TWO, [1.5, 0.5, 0], [0.5, 1.5, 0], 2),
        "six joints": lambda: six_joints()[2],
        "five joints, a point": lambda: kl.straight_path(
            kl.robots.alpha_ii(), tool[:3, 3], moved[:3, 3], 3, q0=home),
        "five joints, roll left free": lambda: kl.straight_path(
            kl.robots.alpha_ii(), tool, moved, 3, q0=home, weights=[1, 1, 1, 1, 1, 0]),
        "six joints, a direction left free": lambda: kl.straight_path(
            SIX, *(kl.forward_kinematics(SIX, q) for q in (Q0, Q1)), 3, q0=Q0,
            weights=[1, 1, 0, 1, 1, 1]),
        "close by the base": lambda: kl.straight_path(
            TWO, [1, 0.02, 0], [-1, 0.02, 0], 2, q0=[np.pi / 3, -2 * np.pi / 3]),
    }


@pytest.mark.parametrize("which", paths())
def test_rates_and_accelerations_are_those_of_fine_differences(which):
    path = paths()[which]()
    rates, bends, (own_rates, own_bends) = numerically(path, 1e-4 if "base" in which else 1e-3)
    assert own_rates == pytest.approx(rates, abs=2e-6 * np.abs(rates).max())
    assert own_bends == pytest.approx(bends, abs=2e-4 * np.abs(bends).max())


def test_close_to_a_singular_place_the_branch_is_kept_and_the_rates_are_told():
    """1 mm from the base at 1.875 m/s the first joint turns at 1875 rad/s; the elbow stays."""
    path = kl.straight_path(TWO, [1, 1e-3, 0], [-1, 1e-3, 0], 2, q0=[np.pi / 3, -2 * np.pi / 3])
    assert np.abs(path.rates[:, 0]).max() == pytest.approx(1875, rel=1e-3)
    assert np.all(path.q[:, 1] < 0) and np.all(path.q[:, 1] > -np.pi)
    assert np.ptp(path.q[:, 0]) > 3
    assert np.abs(np.diff(path.q, axis=0)).max() < 0.0801


@pytest.mark.parametrize("beside", (1e-5, 1e-6))
def test_a_hair_beside_the_base_the_rates_are_finite_and_true(beside):
    path = kl.straight_path(TWO, [1, beside, 0], [-1, beside, 0], 2)
    assert np.abs(path.rates[:, 0]).max() == pytest.approx(1.875 / beside, rel=1e-3)
    assert np.isfinite(path.accelerations).all()
    middle = int(np.flatnonzero(path.t == 1)[0])
    assert np.abs(path.accelerations[middle - 20:middle + 20]).max() == pytest.approx(
        3 * np.sqrt(3) / 8 * (1.875 / beside)**2, rel=0.02)  # of arctan(v t / beside)


def test_through_a_singular_place_it_goes_on_evenly():
    """Right through the base the elbow passes 180 degrees, at twice the rate of the shoulder."""
    path = kl.straight_path(TWO, [1, 0, 0], [-1, 0, 0], 2, q0=[np.pi / 3, -2 * np.pi / 3])
    middle = int(np.flatnonzero(path.t == 1)[0])
    assert path.q[middle] == pytest.approx([np.pi / 2, -np.pi], abs=1e-5)
    assert path.rates[middle] == pytest.approx([0.9375, -1.875], rel=1e-4)
    assert path.accelerations[middle] == pytest.approx([0, 0], abs=1e-3)
    assert path.q[-1] == pytest.approx([2 * np.pi / 3, -4 * np.pi / 3])


def test_from_the_stretched_pose_no_finite_acceleration_leads_on():
    """The elbow opens with the square root of the way: t^1.5 with a quintic, t with a cubic."""
    quintic = kl.straight_path(TWO, [2, 0, 0], [0.5, 0, 0], 2, q0=[0, 0])
    assert quintic.q[0].tolist() == [0, 0] and np.all(quintic.q[1:, 1] > 0)
    assert np.isinf(quintic.accelerations[0]).all()
    assert quintic.rates[0] == pytest.approx(0, abs=0.01)
    # 2 - 2 cos(q2 / 2) = 1.5 * 3 tau^2: q2 = sqrt(18) tau, and a second is half of tau
    cubic = kl.straight_path(TWO, [2, 0, 0], [0.5, 0, 0], 2, "cubic", q0=[0, 0])
    assert cubic.rates[0, 1] == pytest.approx(np.sqrt(18) / 2, rel=1e-3)
    assert np.isfinite(cubic.accelerations).all()


def test_a_line_on_the_spot():
    path = kl.straight_path(TWO, [1, 1, 0], [1, 1, 0], 1)
    assert np.ptp(path.q, axis=0).max() == 0 and not path.rates.any()


def test_beyond_a_limit_the_path_is_made_and_its_breach_is_marked():
    arm = kl.Arm([kl.revolute(a=1), kl.revolute(a=1, limits=(-2, 1.75), speed=0.5)])
    path = kl.straight_path(arm, [1, 1, 0], [1, -1, 0], 2, q0=[0, np.pi / 2])
    limit, *speeds = path.broken
    q2 = path.at([limit.start, limit.end])[:, 1]
    assert q2 == pytest.approx(1.75, abs=1e-8) and limit.worst == pytest.approx(2 * np.pi / 3)
    assert [b.kind for b in speeds] == ["speed", "speed"]
    assert speeds[0].end < 1 < speeds[1].start
    assert "joint 2 is beyond its limit of 100.3 deg from" in repr(path)


def test_the_first_posture_is_q0_and_another_one_gives_the_other_branch():
    up, down = (kl.straight_path(TWO, [1, 1, 0], [1, -1, 0], 2, q0=q)
                for q in ([0, np.pi / 2], [np.pi / 2, -np.pi / 2]))
    assert np.all(up.q[:, 1] > 0) and np.all(down.q[:, 1] < 0)
    assert up.tip == pytest.approx(down.tip, abs=1e-9)


@pytest.mark.parametrize("arguments, words", [
    (dict(T0=[3, 0, 0]), "T0: expected a start that the arm reaches, got one that is out of reach"),
    (dict(T1=[3, 1, 0]), r"T0, T1: expected a line within reach, got one that leaves it at 37% of "
                         r"its way, after 0.855 s, at \(1.732, 1, 0\) m"),
    (dict(T1=np.eye(4)), "T0, T1: expected two poses .* got one of each"),
    (dict(duration=-1), "duration: expected a number above zero"),
    (dict(profile="linear"), "profile: expected 'cubic'"),
    (dict(q0=[1]), "q0: expected shape"),
])
def test_what_cannot_be_is_refused_with_a_word(arguments, words):
    with pytest.raises(ValueError, match=words):
        kl.straight_path(TWO, **(dict(T0=[1, 1, 0], T1=[1, -1, 0], duration=2) | arguments))


def test_too_few_joints_for_a_pose_are_told_so():
    arm = kl.robots.alpha_ii()
    T = kl.forward_kinematics(arm, arm.home + [0, 0.4, -0.8, 0.2, 0])
    with pytest.raises(ValueError, match="5 joints do not reach every pose, leave a direction"):
        kl.straight_path(arm, T, kl.translation([0, 80, 0]) @ T, 1)


def test_a_line_that_needs_a_jump_says_so():
    """A wrist whose first and third axis are one turns about the other two: not about both."""
    half = np.pi / 2
    wrist = kl.Arm([kl.revolute(alpha=-half), kl.revolute(alpha=half), kl.revolute()])
    turned = [kl.homogeneous(R, [0, 0, 0]) for R in (kl.rotation_y(0.5), kl.rotation_x(0.5))]
    weights = [0, 0, 0, 1, 1, 1]
    path = kl.straight_path(wrist, np.eye(4), turned[0], 1, weights=weights)
    assert path.q[-1] == pytest.approx([0, 0.5, 0])
    with pytest.raises(ValueError, match="needs a jump of the joints at 0% of its way"):
        kl.straight_path(wrist, np.eye(4), turned[1], 1, weights=weights)


def test_a_folded_arm_that_would_have_to_turn_at_once_is_told_so():
    """From the base the tip of a folded arm leaves at right angles to its links only."""
    arm = kl.Arm([kl.revolute(a=1), kl.revolute(a=1)], home=[0, 1])
    with pytest.raises(ValueError, match="needs a jump of the joints at 0% of its way"):
        kl.straight_path(arm, [0, 0, 0], [-1.2, 0.1, 0], 2, q0=[-1.487655, np.pi])


# ---- units, locks, first postures ----

RAIL = [kl.prismatic(alpha=np.pi / 2, limits=(-1000, 1000)), kl.revolute(a=400), kl.revolute(a=300)]


def point(arm, q):
    return kl.forward_kinematics(arm, q)[:3, 3]


def test_of_many_ways_that_is_taken_on_which_joints_move_least():
    """A slide on a rail in mm, beside radians: its reach is 1000 + 400 + 300 mm."""
    arm, unit = kl.Arm(RAIL, unit="mm"), np.array([1700, 1, 1])
    q0, q1 = [100, 0.3, 0.8], [300, 0.6, 0.5]
    path = kl.straight_path(arm, point(arm, q0), point(arm, q1), 2, q0=q0)
    assert len(path.t) == 123
    for q, rates in zip(path.q[10:-10:20], path.rates[10:-10:20]):
        others = np.linalg.svd(kl.jacobian(arm, q)[:3] * unit)[2][-1]  # the tip stays
        assert np.abs(kl.jacobian(arm, q)[:3] @ (unit * others)).max() < 1e-9
        assert np.dot(rates / unit, others) == pytest.approx(0, abs=1e-9)


def test_slides_without_an_end_have_finite_rates_in_every_unit():
    half, states = np.pi / 2, []
    for size in (1, 1000):
        arm = kl.Arm([kl.revolute(d=0.412 * size, alpha=-half), kl.revolute(
            d=0.154 * size, alpha=half), kl.prismatic(), kl.revolute(alpha=-half),
            kl.revolute(alpha=half), kl.revolute(d=0.263 * size)])
        poses = [kl.forward_kinematics(arm, q) for q in (
            [0, 1.3, 0.6 * size, 0.3, 0.8, 0], [0.6, 1.1, 0.8 * size, -0.2, 1, 0.4])]
        path = kl.straight_path(arm, *poses, 2, q0=[0, 1.3, 0.6 * size, 0.3, 0.8, 0])
        assert np.isfinite(path.accelerations).all() and not path.rates[[0, -1]].any()
        states.append(path.accelerations / [1, 1, size, 1, 1, 1])
    assert states[0] == pytest.approx(states[1], abs=1e-6)


@pytest.mark.parametrize("lock, first", [
    (kl.revolute(a=1, limits=(0.3, 0.3)), kl.fixed(a=1, theta=0.3)),
    (kl.revolute(a=1, limits=(0.3, 0.3), flip=True), kl.fixed(a=1, theta=-0.3)),
    (kl.prismatic(a=1, d=0.1, limits=(0.2, 0.2), flip=True), kl.fixed(a=1, d=-0.1)),
])
def test_a_lock_is_a_row_without_a_joint(lock, first):
    links = [kl.revolute(a=1), kl.revolute(a=0.5)]
    arm, bare = kl.Arm([lock, *links]), kl.Arm([first, *links])
    start, end = point(bare, [0.5, 0.5]), point(bare, [0.9, 0.3])
    path = kl.straight_path(arm, start, end, 1, q0=[lock.limits[0], 0.5, 0.5])
    same = kl.straight_path(bare, start, end, 1, q0=[0.5, 0.5])
    assert np.all(path.q[:, 0] == lock.limits[0]) and not path.rates[:, 0].any()
    assert path.q[:, 1:] == pytest.approx(same.q) and path.t == pytest.approx(same.t)
    assert path.rates[:, 1:] == pytest.approx(same.rates)


def test_an_arm_of_locks_stays_where_it_is():
    arm = kl.Arm([kl.revolute(a=1, limits=(0.5, 0.5)), kl.prismatic(limits=(1, 1))])
    here = point(arm, [0.5, 1])
    assert kl.straight_path(arm, here, here, 1).q[-1].tolist() == [0.5, 1]
    with pytest.raises(ValueError, match="leaves it at 0% of its way"):
        kl.straight_path(arm, here, here + [0, 0, 0.1], 1)


@pytest.mark.parametrize("T0, T1, name", [([1, 1, 0], [1, 1, 0.5], "T1"),
                                          ([1, 1, 0.5], [1, 1, 0.5], "T0")])
def test_a_place_beside_the_plane_of_an_arm_is_refused(T0, T1, name):
    with pytest.raises(ValueError, match=f"^{name}: expected a place in the plane in which this "
                                         "arm moves, z = 0, got z = 0.5; write z = 0, or leave z"):
        kl.straight_path(TWO, T0, T1, 1)
    assert kl.straight_path(TWO, T0, T1, 1, weights=[1, 1, 0]).tip[-1] == pytest.approx([1, 1, 0])


def test_a_turn_that_cannot_be_followed_is_refused():
    T = kl.forward_kinematics(TWO, [0.3, 0.8])
    with pytest.raises(ValueError, match=r"2 joints do not reach every pose, leave a direction "
                                         r"free by weights\); hand over the tool points alone"):
        kl.straight_path(TWO, T, kl.translation([0.1, 0.2, 0]) @ T, 1)
    three = kl.Arm([kl.revolute(a=1), kl.revolute(a=1), kl.revolute(a=0.5)])
    poses = [kl.forward_kinematics(three, q) for q in ([0, 0.5, 0.5], [0.2, 0.6, 0])]
    path = kl.straight_path(three, *poses, 1, q0=[0, 0.5, 0.5])
    assert path.q[-1] == pytest.approx([0.2, 0.6, 0])
    tilted = poses[1].copy()
    tilted[:3, :3] = tilted[:3, :3] @ kl.rotation_x(0.1)
    with pytest.raises(ValueError, match="expected a line within reach"):
        kl.straight_path(three, poses[0], tilted, 1)


def test_a_first_posture_beyond_a_limit_is_kept_and_marked():
    arm = kl.Arm([kl.revolute(a=1, limits=(-1, 1)), kl.revolute(a=1, limits=(-2.5, 2.5))])
    path = kl.straight_path(arm, point(arm, [1.2, -0.8]), [1.2, 0.5, 0], 1, q0=[1.2, -0.8])
    assert path.q[0] == pytest.approx([1.2, -0.8], abs=1e-12)
    assert (path.broken[0].joint, path.broken[0].kind, path.broken[0].start) == (1, "limit", 0)
    other = kl.straight_path(arm, point(arm, [1.2, -0.8]), [1.2, 0.5, 0], 1)
    assert other.q[0] == pytest.approx([0.4, 0.8], abs=1e-9) and not other.broken


def test_a_time_has_joint_values_where_no_step_leads_there(monkeypatch):
    path = kl.straight_path(TWO, [1.5, 0.5, 0], [0.5, 1.5, 0], 2)
    monkeypatch.setattr(Walk, "on", lost)
    monkeypatch.setattr(Along, "_regular", None)  # rates are not worked out for that
    middle = path.at((path.t[40] + path.t[41]) / 2)
    assert middle == pytest.approx((path.q[40] + path.q[41]) / 2)


def lost(*_):
    raise Lost(0.0)
