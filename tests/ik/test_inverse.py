"""Inverse kinematics: what is called a success is one, and a failure says why."""
from dataclasses import replace
from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import arms, poses
from test_kinematics import COURSE, course
from textbook import frames, rigid, turn

import kinlab as kl
from kinlab.arms.joints import joint_ranges
from kinlab.arms.kinematics import reach
from kinlab.ik.descent import Lanes, Search
from kinlab.ik.task import Task, rotation_vectors, seen_from

close = np.testing.assert_allclose


def reachable(arm, count, seed=0):
    """Poses at random joint values within the limits, made by the textbook's matrices."""
    rng = np.random.default_rng(seed)
    q = np.stack([rng.uniform(*(link.limits or (-pi, pi)), count) for link in arm.joints], axis=1)
    return np.array([frames(arm, row)[-1] for row in q]), q


def tool(arm, q):
    return frames(arm, q)[-1]


def is_at(arm, q, target, tolerance=1e-6):
    """Judged by the textbook's matrices: position and rotation, and the limits."""
    T = tool(arm, q)
    spin = T[:3, :3].T @ target[:3, :3]
    angle = np.arctan2(np.linalg.norm(spin - spin.T) / 8 ** 0.5, (np.trace(spin) - 1) / 2)
    near = np.linalg.norm(T[:3, 3] - target[:3, 3]) <= tolerance * max(reach(arm), 1) * 1.01
    return near and angle <= tolerance * 1.01 and within(arm, q)


def within(arm, q):
    return all(link.limits is None or link.limits[0] <= x <= link.limits[1]
               for link, x in zip(arm.joints, q))


@course
def test_reachable_poses_are_reached_and_kept_within_limits(robot):
    arm = robot()
    targets, _ = reachable(arm, 40)
    found = kl.inverse_kinematics_batch(arm, targets)
    assert found.success.all()
    assert all(is_at(arm, q, T) for q, T in zip(found.q, targets))
    assert set(found.message) <= {f"reached in {k} steps" for k in found.iterations}


@course
def test_one_target_at_a_time(robot):
    arm = robot()
    for target in reachable(arm, 4, seed=1)[0]:
        result = kl.inverse_kinematics(arm, target)
        assert result.success and is_at(arm, result.q, target)
        close(result.pose, tool(arm, result.q), atol=1e-9)
        assert result.message.startswith("reached in ")


@given(arms(most=6), st.integers(0, 10**6))
@settings(max_examples=25)
def test_success_is_never_wrong(arm, seed):
    """Random arms, some of which reach nothing but a point: whatever is claimed is true."""
    target = tool(arm, np.random.default_rng(seed).uniform(-1, 1, arm.n))
    result = kl.inverse_kinematics(arm, target, restarts=3, steps=40)
    assert np.isfinite(result.q).all() and np.isfinite(result.position_error)
    if result.success:
        close(tool(arm, result.q), target, atol=3e-6 * max(1, np.abs(target).max() * 9))


@given(arms(most=6), poses())
@settings(max_examples=25)
def test_any_target_ends_in_numbers(arm, target):
    result = kl.inverse_kinematics(arm, target, restarts=2, steps=30)
    assert np.isfinite([*result.q, result.position_error, result.rotation_error]).all()
    T = tool(arm, result.q)
    close(np.linalg.norm(T[:3, 3] - target[:3, 3]), result.position_error, atol=1e-9)


def far_targets(arm, count=1000):
    """Poses beyond the reach, at 1.001 to 3 times the arm's length."""
    rng = np.random.default_rng(2)
    way = rng.normal(size=(count, 3))
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    targets, _ = reachable(arm, count)
    base = arm.base[:3, 3]
    targets[:, :3, 3] = base + way * reach(arm) * rng.uniform(1.001, 3, (count, 1))
    return targets


def test_a_thousand_unreachable_targets_are_all_reported():
    arm = kl.robots.alpha_ii()
    found = kl.inverse_kinematics_batch(arm, far_targets(arm), restarts=3, steps=30)
    assert not found.success.any() and np.isfinite(found.q).all()
    assert all(message.startswith("out of reach: the target is") for message in found.message)


def test_unreachable_targets_within_the_reach_are_reported():
    """Inside the hole of a two-link with unequal links: no bound on the reach shows it."""
    arm = kl.Arm([kl.revolute(a=1), kl.revolute(a=0.4)], unit="m")
    angle = np.linspace(0, 2 * pi, 50)
    points = np.stack([0.55 * np.cos(angle), 0.55 * np.sin(angle), 0 * angle], axis=1)
    found = kl.inverse_kinematics_batch(arm, points)
    assert not found.success.any()
    close(found.position_error, 0.05, atol=1e-3)
    assert all(m.startswith("out of reach: the nearest pose found misses") for m in found.message)


def test_out_of_limits_is_said():
    arm = kl.Arm([kl.revolute(a=1, limits=(0, 1)), kl.revolute(a=1, limits=(0, 1))], unit="m")
    beyond = kl.forward_kinematics(arm, [-0.5, 0.4])
    result = kl.inverse_kinematics(arm, beyond)
    assert not result.success and result.message.startswith("out of limits: ")
    assert within(arm, result.q)
    free = kl.inverse_kinematics(arm, beyond, limits="ignore")
    assert free.success and not within(arm, free.q)


def test_singular_start_is_said():
    """A stretched arm cannot move along itself: every method stands still there."""
    arm, target = kl.robots.two_link(), [1, 0, 0]
    for method in ("damped", "newton", "pseudoinverse", "transpose"):
        weights = [1, 1, 0]
        result = kl.inverse_kinematics(arm, target, [0, 0], method=method, weights=weights,
                                       restarts=0)
        assert not result.success
        assert result.message.startswith("singular start: the Jacobian has rank 1 there, not 2")
        close(result.q, [0, 0], atol=1e-12)
        again = kl.inverse_kinematics(arm, target, [0, 0], method=method, weights=weights,
                                      restarts=10)
        assert again.success, method


def test_too_few_steps_are_said():
    arm = kl.robots.practical_six_link()
    target, _ = reachable(arm, 1)
    result = kl.inverse_kinematics(arm, target[0], np.full(6, 0.4), steps=2, restarts=0)
    assert not result.success
    assert result.message.startswith("not reached in 2 steps of 'damped'")


@pytest.mark.parametrize("method", ["damped", "newton", "pseudoinverse", "transpose"])
def test_every_method_reaches_a_near_pose(method):
    arm = kl.robots.practical_six_link()
    q = np.array([0.3, 1.0, -1.2, 0.4, 0.7, 0.2])
    result = kl.inverse_kinematics(arm, tool(arm, q + 0.05), q, method=method, steps=3000,
                                   tolerance=1e-4)
    assert result.success and is_at(arm, result.q, tool(arm, q + 0.05), 1e-4)
    close(result.q, q + 0.05, atol=0.02)


def test_newton_squares_the_error_and_transpose_does_not():
    arm = kl.robots.practical_six_link()
    q = np.array([0.3, 1.0, -1.2, 0.4, 0.7, 0.2])
    runs = {m: kl.inverse_kinematics(arm, tool(arm, q + 0.05), q, method=m, steps=500)
            for m in ("newton", "damped", "transpose")}
    newton = [step.error for step in runs["newton"].history]
    assert len(newton) <= 5 and newton[2] < 5 * newton[1] ** 2 / newton[0] < newton[1]
    assert len(runs["damped"].history) < 12 < len(runs["transpose"].history)


def test_newton_wants_a_square_jacobian():
    arm = kl.robots.two_link()
    with pytest.raises(ValueError, match=r"^method: .* for 'newton', got 2 and 3; take 'damped'"):
        kl.inverse_kinematics(arm, [1, 1, 0], method="newton")
    assert kl.inverse_kinematics(arm, [1, 1, 0], method="newton", weights=[1, 1, 0]).success


def test_history_is_the_way_from_start_to_result():
    arm = kl.robots.intelledex_660t()
    target = tool(arm, np.full(6, 0.5))
    result = kl.inverse_kinematics(arm, target, np.full(6, 0.3))
    history = result.history
    close(history[0].q, 0.3)
    close(history[-1].q, result.q)
    assert len(history) == result.iterations + 1
    assert history[-1].error < 1e-6 < history[0].error
    for step in history:
        T = tool(arm, step.q)
        offset = np.linalg.norm(T[:3, 3] - target[:3, 3]) / reach(arm)
        R = target[:3, :3].T @ T[:3, :3]
        angle = np.linalg.norm(rotation_vectors(R.T[..., None]))
        close(step.error, np.hypot(offset, angle), rtol=1e-9, atol=1e-12)
        close([step.position_error, step.rotation_error], [offset * reach(arm), angle], atol=1e-9)
        scale = np.repeat([reach(arm), 1], 3)[:, None]
        close(step.condition, np.linalg.cond(kl.jacobian(arm, step.q) / scale), rtol=1e-6)


def test_history_after_restarts_ends_at_the_result():
    arm = kl.robots.alpha_ii()
    for target in reachable(arm, 12, seed=5)[0]:
        result = kl.inverse_kinematics(arm, target)
        assert result.success
        close(tool(arm, result.history[-1].q), result.pose, atol=1e-9 * reach(arm))
    assert kl.inverse_kinematics(kl.robots.two_link(), [1, 0, 0], [0, 0],
                                 restarts=0).history[0].condition == np.inf


def test_condition_is_infinite_where_rank_is_lost():
    result = kl.inverse_kinematics(kl.robots.two_link(), [1, 0, 0], [0, 0], weights=[1, 1, 0])
    assert np.isfinite(result.q).all() and result.success


@course
def test_singular_poses_as_targets_and_starts(robot):
    arm = robot()
    for q in (np.zeros(arm.n), arm.home, np.full(arm.n, pi / 2)):
        target = tool(arm, q)
        for method in ("damped", "pseudoinverse", "transpose"):
            for q0 in (arm.home, np.zeros(arm.n), np.full(arm.n, 0.3)):
                result = kl.inverse_kinematics(arm, target, q0, method=method, steps=30,
                                               limits="ignore")
                assert np.isfinite([*result.q, result.position_error]).all()
                assert not result.success or is_at(free(arm), result.q, target)


def free(arm):
    """The arm without limits."""
    return replace(arm, links=tuple(replace(link, limits=None) for link in arm.links))


def test_targets_on_the_boundary_are_reached():
    arm = kl.robots.two_link()
    angle = np.linspace(-3, 3, 60)
    edge = 2 * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    found = kl.inverse_kinematics_batch(arm, edge)
    assert found.success.all() and found.position_error.max() <= 2e-6
    close(np.sin(found.q[:, 1]), 0, atol=5e-3)
    assert not kl.inverse_kinematics_batch(arm, edge * 1.00001).success.any()


def test_a_half_turn_away():
    """The error's axis is not smooth there, and a start may stand exactly on it."""
    arm = kl.robots.practical_six_link()
    for q in reachable(arm, 5, seed=3)[1]:
        for axis in np.eye(3):
            target = tool(arm, q)
            target[:3, :3] = target[:3, :3] @ turn(axis, pi)
            result = kl.inverse_kinematics(arm, target, q)
            assert np.isfinite(result.q).all()
            assert not result.success or is_at(arm, result.q, target)


def test_rotation_vectors_undo_rodrigues_up_to_half_a_turn():
    rng = np.random.default_rng(0)
    axes = rng.normal(size=(300, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    angles = np.concatenate([rng.uniform(0, pi, 100), 10.0 ** -rng.uniform(1, 12, 100),
                             pi - 10.0 ** -rng.uniform(1, 12, 100)])
    R = np.array([turn(axis, angle) for axis, angle in zip(axes, angles)])
    v = rotation_vectors(np.moveaxis(R, (2, 1, 0), (0, 1, 2))).T
    close(np.linalg.norm(v, axis=1), angles, atol=1e-12)
    back = np.array([turn(w / max(np.linalg.norm(w), 1e-300), np.linalg.norm(w)) for w in v])
    close(back, R, atol=1e-9)


@pytest.mark.parametrize("weights", [np.ones(6), [1, 1, 1, 1, 1, 0], [1, 2, 0, 0.5, 0, 1]])
def test_the_error_falls_as_its_jacobian_says(weights):
    """J^T e is the gradient of the error, also where rotations count unequally."""
    arm = kl.robots.practical_six_link()
    task = Task(arm, np.array(weights, float), 1e-6)
    view = seen_from(np.repeat(reachable(arm, 1, seed=8)[0], 13, axis=0))
    q = np.full(6, 0.4)
    around = q[:, None] + 1e-6 * np.hstack([np.zeros((6, 1)), np.eye(6), -np.eye(6)])
    J, e = task.errors(view, around)
    halves = 0.5 * np.sum(e * e, axis=0)
    close(J[:, :, 0] @ e[:, 0], (halves[1:7] - halves[7:]) / 2e-6, rtol=1e-5, atol=1e-7)


def test_a_point_alone():
    arm = kl.robots.alpha_ii()
    points = reachable(arm, 30)[0][:, :3, 3]
    found = kl.inverse_kinematics_batch(arm, points)
    assert found.success.all() and not found.rotation_error.any()
    for q, p in zip(found.q, points):
        close(tool(arm, q)[:3, 3], p, atol=1e-3)
    result = kl.inverse_kinematics(arm, points[0])
    assert result.success and result.rotation_error == 0


def test_five_joints_with_the_roll_left_free():
    """Alpha II points its tool anywhere along a plane through its base; roll is its own joint."""
    arm = kl.robots.alpha_ii()
    targets, _ = reachable(arm, 30, seed=4)
    rolled = targets @ rigid(turn((0, 0, 1), 1.2))
    found = kl.inverse_kinematics_batch(arm, rolled, weights=[1, 1, 1, 1, 1, 0])
    assert found.success.all()
    for q, T in zip(found.q, targets):
        close(tool(arm, q)[:3, 2:], T[:3, 2:], atol=2e-3)


def test_five_joints_do_not_reach_every_pose():
    arm = kl.robots.alpha_ii()
    target = reachable(arm, 1)[0][0] @ rigid(turn((1, 0, 0), 0.5))
    result = kl.inverse_kinematics(arm, target)
    assert not result.success
    assert result.message.endswith("5 joints do not reach every pose, leave a direction free by "
                                   "weights")


def test_weights_say_what_counts():
    """Out of reach, a heavier direction misses by less."""
    arm = kl.robots.two_link()
    light, heavy = (kl.inverse_kinematics(arm, [2, 2, 0], weights=[w, 1, 0]).pose[0, 3]
                    for w in (0.2, 5))
    assert light < 1.2 and heavy > 1.7


def test_the_best_of_several_starts_is_kept():
    arm = kl.robots.two_link()
    found = Search(Task(arm, np.ones(6), 1e-6), seen_from(np.eye(4)[None]), np.zeros((2, 1)), 0, 0)
    q = np.array([[1.0, 2, 3, 4], [5, 6, 7, 8]])
    lanes = Lanes.begin(np.zeros(4, int), found.seen[..., [0] * 4], q)
    lanes.best_error = np.array([3.0, 1, 2, 9])
    found.note(lanes, np.zeros(4, bool))
    assert found.error[0] == 1 and found.q[:, 0].tolist() == [2, 6]
    found.note(lanes, np.array([False, False, False, True]))
    assert found.reached[0] and found.q[:, 0].tolist() == [4, 8]


@given(arms(most=6), st.integers(0, 10**6))
def test_nothing_is_beyond_the_reach(arm, seed):
    if any(link.kind == "prismatic" and link.limits is None for link in arm.links):
        assert reach(arm) == np.inf
    else:
        q = np.random.default_rng(seed).uniform(*joint_ranges(arm))
        distance = np.linalg.norm(tool(arm, q)[:3, 3] - arm.base[:3, 3])
        assert distance <= reach(arm) * (1 + 1e-9) + 1e-9


def test_reach_of_links_and_slides():
    assert reach(kl.Arm([kl.revolute(a=3, d=4)])) == 5
    assert reach(kl.Arm([kl.prismatic(a=3, d=1, limits=(-5, 2))])) == 5


def test_the_same_seed_gives_the_same_result():
    arm = kl.robots.alpha_ii()
    targets, _ = reachable(arm, 20, seed=6)
    one, same, other = (kl.inverse_kinematics_batch(arm, targets, seed=s) for s in (1, 1, 2))
    assert np.array_equal(one.q, same.q) and np.array_equal(one.iterations, same.iterations)
    assert not np.array_equal(one.q, other.q)


def test_solutions_stay_near_the_start():
    """Whole turns are taken off: a joint without limits ends within half a turn of its start."""
    arm = kl.robots.practical_six_link()
    q0 = np.array([7.0, 8.0, -9.0, 20.0, 1.0, -30.0])
    result = kl.inverse_kinematics(arm, tool(arm, q0 + 0.1), q0)
    close(result.q, q0 + 0.1, atol=1e-4)
    far = kl.inverse_kinematics_batch(arm, reachable(arm, 20)[0], q0)
    assert far.success.all() and np.abs(far.q - q0).max() <= pi


def test_starts_beyond_the_limits_are_brought_back():
    arm = kl.robots.cylindrical()
    result = kl.inverse_kinematics(arm, tool(arm, [0.1, 0.3, 0.4]), [0, 9, -9])
    assert result.success and within(arm, result.q)


def test_a_batch_is_its_single_targets():
    arm = kl.robots.exam_2018()
    targets, _ = reachable(arm, 7)
    found = kl.inverse_kinematics_batch(arm, targets, restarts=0)
    for k, target in enumerate(targets):
        result = kl.inverse_kinematics(arm, target, restarts=0)
        assert result.success == found.success[k] and result.iterations == found.iterations[k]
        close(result.q, found.q[k], atol=1e-9)


ROLL_FREE, POINT, LOPSIDED = [1, 1, 1, 1, 1, 0], [1, 1, 1, 0, 0, 0], [1, 2, 0, 0.5, 0, 1]


@course
@pytest.mark.parametrize("weights", [None, ROLL_FREE, POINT, LOPSIDED])
@pytest.mark.parametrize("method, far, most", [("damped", 1, 7), ("transpose", 1, 7),
                                               ("pseudoinverse", 0.2, 2)])
def test_one_target_takes_the_steps_of_many(robot, weights, method, far, most):
    """Plain floats and arrays: the same places after the same steps, at the limits too.

    The pseudoinverse leaps, far away and near a singular pose: there the last bit decides.
    """
    arm = robot()
    targets, q = reachable(arm, 3, seed=9)
    starts = q + far * (q[::-1] - q)
    for steps in (1, 2, most):
        options = dict(weights=weights, method=method, steps=steps, restarts=0)
        found = kl.inverse_kinematics_batch(arm, targets, starts, **options)
        for k, result in enumerate(kl.inverse_kinematics(arm, target, start, **options)
                                   for target, start in zip(targets, starts)):
            close(result.q, found.q[k], atol=1e-7 * max(1, np.abs(result.q).max()))
            assert result.iterations == found.iterations[k]
            assert len(result.history) == result.iterations + 1
            assert result.message == found.message[k]


@given(arms(most=6), st.integers(0, 10**6), st.sampled_from([1, 2, 5]))
@settings(max_examples=50)
def test_error_and_jacobian_at_one_place_are_those_at_many(arm, seed, heavy):
    rng = np.random.default_rng(seed)
    weights = np.array([1, 1, 0.5, 1, 1, 1 / heavy])
    task = Task(arm, weights, 1e-6)
    q, targets = rng.uniform(-3, 3, (4, arm.n)), np.array([tool(arm, rng.uniform(-3, 3, arm.n))])
    targets = np.concatenate([targets, [tool(arm, q[1]) @ rigid(turn((0.6, 0, 0.8), pi - 1e-8))],
                              [tool(arm, q[2])], targets])
    seen = seen_from(targets)
    J, e = task.errors(seen, q.T)
    kept = task.allowed(5 * q.T)
    for k, place in enumerate(seen.transpose(2, 0, 1).tolist()):
        J_one, e_one = task.error((place[:3], place[3]), q[k].tolist())
        close(J_one, J[..., k], atol=1e-9)
        close(e_one, e[:, k], atol=1e-9)
        assert task.is_reached(e_one) == task.reached(e)[k] == (k == 2)
        close(task.kept((5 * q[k]).tolist()), kept[:, k], atol=1e-12)


def test_whole_turns_are_taken_off_about_the_middle_of_the_limits():
    arm = kl.Arm([kl.revolute(a=1, limits=(1, 4)), kl.prismatic(limits=(1, 4)), kl.revolute(a=1)])
    task, q = Task(arm, np.ones(6), 1e-6), [-4.0, -4.0, -4.0]
    close(task.kept(q), [2 * pi - 4, 1, -4])
    close(task.allowed(np.array([q]).T)[:, 0], [2 * pi - 4, 1, -4])


def test_batches_larger_than_a_part_and_empty_ones():
    arm = kl.robots.two_link()
    q = np.random.default_rng(0).uniform(0.1, 3, (5000, 2))
    points = kl.forward_kinematics(arm, q)[:, :3, 3]
    found = kl.inverse_kinematics_batch(arm, points, q + 0.05)
    assert found.success.all() and found.q.shape == (5000, 2) and len(found.message) == 5000
    empty = kl.inverse_kinematics_batch(arm, np.zeros((0, 4, 4)))
    assert empty.q.shape == (0, 2) and empty.message == ()


def test_prismatic_joints_without_limits():
    arm = kl.Arm([kl.prismatic(alpha=pi / 2), kl.prismatic(theta=pi / 2, alpha=pi / 2),
                  kl.prismatic()])
    for point in ([3, 4, 5], [-900, 20, 1e4]):
        result = kl.inverse_kinematics(arm, point, steps=300)
        assert result.success
        close(result.pose[:3, 3], point, atol=1e-5)


def test_an_absurdly_far_target():
    for robot in COURSE:
        result = kl.inverse_kinematics(robot(), [1e99, -1e99, 1e50], restarts=2)
        assert not result.success and np.isfinite(result.q).all()


def test_a_miss_is_told_in_the_directions_that_count():
    far = kl.inverse_kinematics(kl.robots.alpha_ii(), [500, 0, 300]).message
    assert far.endswith("misses it by 22.1 mm")
    pose = kl.homogeneous(kl.rotation_x(np.radians(160)), [300, 0, 80])
    assert " mm and 20 degrees" in kl.inverse_kinematics(kl.robots.alpha_ii(), pose).message


def test_a_joint_that_does_not_count_stays_where_it_was():
    """The tool's roll moves no point: neither steps nor random starts turn it."""
    arm, begin = kl.robots.alpha_ii(), np.radians([0, 0, 0, -90, 25])
    for point in ([300, 0, 215], [250, 150, 60], [500, 0, 300]):
        result = kl.inverse_kinematics(arm, point, begin)
        close(result.q[4], begin[4], atol=1e-9)
        assert result.success == (point[0] != 500)
