"""Random arms, other frame assignments of them, and an oracle for what a change alters."""
import re
from dataclasses import replace
from itertools import pairwise
from math import pi

import numpy as np
from textbook import rigid

import kinlab as kl
from kinlab.arms.kinematics import axis_frames

ANGLES = {"theta", "alpha"}


def random_arm(rng, n=None, kinds=(kl.revolute, kl.revolute, kl.prismatic)):
    """An arm with many right angles, zero lengths, parallel, meeting and coincident axes."""
    lazy = rng.choice([0, 0.5, 0.9])  # how much of it is degenerate
    links = [rng.choice(kinds)(theta=random_angle(rng, lazy), d=random_length(rng, lazy),
                               a=random_length(rng, lazy), alpha=random_angle(rng, lazy))
             for _ in range(n or rng.integers(1, 8))]
    return kl.Arm(links, convention=rng.choice(["standard", "modified"]),
                  base=random_pose(rng), tool=random_pose(rng))


def random_angle(rng, lazy):
    if rng.random() < lazy:
        return rng.integers(-2, 3) * pi / 2
    return rng.integers(-12, 13) * pi / 12 if rng.random() < 0.3 else rng.uniform(-pi, pi)


def random_length(rng, lazy):
    if rng.random() < lazy:
        return 0.0
    return rng.integers(-20, 21) / 20 if rng.random() < 0.3 else rng.uniform(-1, 1)


def random_direction(rng):
    v = rng.normal(size=3)
    return v / np.linalg.norm(v)


def random_pose(rng):
    return frame(random_direction(rng), random_direction(rng), rng.uniform(-1, 1, 3))


def frame(z, near_x, origin):
    """The frame with this z whose x is as near as can be to the one given."""
    x = near_x - near_x @ z * z
    x = x / np.linalg.norm(x)
    return rigid(np.column_stack([x, np.cross(z, x), z]), origin)


def reassigned(arm, rng, flip=0.5, slide=0.5):
    """Another assignment of frames to the same arm, and its pose q0 and signs.

    The new arm moves as the old one: T_new(signs * (q - q0)) = T_old(q).
    """
    q0 = rng.uniform(-3, 3, arm.n) * (rng.random(arm.n) < 0.7)
    signs = np.where(rng.random(arm.n) < flip, -1, 1)
    frames = kl.link_frames(arm, q0)[axis_frames(arm)]
    z, points = frames[:, :3, 2] * signs[:, None], frames[:, :3, 3].copy()
    for i, link in enumerate(arm.links):  # the place of a prismatic axis means nothing
        if link.kind == "prismatic" and rng.random() < slide:
            points[i] += rng.uniform(-1, 1, 3)
    lines = [*zip(z, points), end_line(z[-1], points[-1], rng)]
    new = [frame(z[0], random_direction(rng), points[0] + slid(rng, slide) * z[0])]
    for before, after in pairwise(lines):
        new.append(next_frame(before, after, rng, flip, slide))
    links = [row(kl.revolute if link.kind == "revolute" else kl.prismatic, T, U)
             for link, T, U in zip(arm.links, new, new[1:])]
    tool = np.linalg.inv(new[-1]) @ kl.forward_kinematics(arm, q0)
    return kl.Arm(links, base=new[0], tool=tool), q0, signs


def slid(rng, slide):
    return rng.uniform(-1, 1) * (rng.random() < slide)


def end_line(z, point, rng):
    """The z axis of the last frame: on the last joint's axis, or anywhere."""
    return (z, point) if rng.random() < 0.5 else (random_direction(rng), rng.uniform(-1, 1, 3))


def next_frame(before, after, rng, flip, slide):
    """A frame on the line `after` that keeps rules 1 and 2 towards the line `before`."""
    (z0, p0), (z1, p1) = before, after
    normal, span = np.cross(z0, z1), p1 - p0
    side = -1 if rng.random() < flip else 1
    if np.linalg.norm(normal) > 1e-9:
        along = np.linalg.lstsq(np.column_stack([z0, -z1, normal]), span, rcond=None)[0][1]
        return frame(z1, side * normal, p1 + along * z1)
    across = span - span @ z0 * z0
    if np.linalg.norm(across) < 1e-9:
        across = random_direction(rng)
    return frame(z1, side * across, p1 + slid(rng, slide) * z1)


def row(make, T, U):
    """The standard DH row that leads from frame T to frame U."""
    A = np.linalg.inv(T) @ U
    theta = np.arctan2(A[1, 0], A[0, 0])
    return make(theta=theta, d=A[2, 3], a=A[0, 3] * np.cos(theta) + A[1, 3] * np.sin(theta),
                alpha=np.arctan2(A[2, 1], A[2, 2]))


def retyped(arm, number, **values):
    """The arm with some numbers of one row typed anew."""
    links = list(arm.links)
    links[number - 1] = replace(links[number - 1], **values)
    return replace(arm, links=links)


def changed(arm, index, parameter, change):
    """The arm with one number of its table changed."""
    links = list(arm.links)
    links[index] = replace(links[index],
                           **{parameter: getattr(links[index], parameter) + change})
    return replace(arm, links=links)


def random_change(rng, arm, parameter=None):
    """A row, a parameter and a change of 1e-6 up to 1, relative to what it changes."""
    index, parameter = int(rng.integers(arm.n)), str(rng.choice(["theta", "d", "a", "alpha"]))
    value, change = getattr(arm.links[index], parameter), 10 ** rng.uniform(-6, 0)
    if parameter in ("d", "a"):
        longest = max(max(abs(link.a), abs(link.d)) for link in arm.links)
        change *= abs(value) if abs(value) > 1e-9 else max(longest, 1e-3)
    return index, parameter, change * rng.choice([-1, 1])


def alters(arm, index, parameter, change, rng):
    """Whether a change of one number of the table changes how the arm moves.

    None where it does so by less than the tolerance: a number at an extremum, such as the angle
    of a prismatic joint between parallel links, counts only by the square of its change, and one
    with a lever of micrometres hardly counts. Rounding alone leaves slopes below 1e-8.
    """
    before = slope(arm, index, parameter, rng)
    if before > 1e-5:
        return True
    after = slope(changed(arm, index, parameter, change), index, parameter, rng)
    if max(before, after) < 1e-7:
        return False
    return True if max(before, after) * abs(change) / 2 > 1e-6 else None


def slope(arm, index, parameter, rng):
    """How much a small change of one number changes how the arm moves, for a change of 1.

    By least squares, without a look at any axis: what the change does to the tool at forty
    random poses, less what the base, the tool and the joint offsets can do as well.
    """
    poses = rng.uniform(-3, 3, (40, arm.n))
    T = kl.forward_kinematics(arm, poses)
    h = 1e-6
    effect = body_motion(T, kl.forward_kinematics(changed(arm, index, parameter, h), poses)
                         - kl.forward_kinematics(changed(arm, index, parameter, -h), poses))
    columns = [body_motion(T, 2 * h * T @ unit) for unit in units()]
    columns += [body_motion(T, 2 * h * unit @ T) for unit in units()]
    for joint in np.eye(arm.n):
        columns.append(body_motion(T, kl.forward_kinematics(arm, poses + h * joint)
                                   - kl.forward_kinematics(arm, poses - h * joint)))
    basis = np.column_stack(columns)
    left = effect - basis @ np.linalg.lstsq(basis, effect, rcond=1e-7)[0]
    return np.linalg.norm(left) / (2 * h) / np.sqrt(len(left))


def units():
    """The six infinitesimal rigid motions."""
    found = np.zeros((6, 4, 4))
    for k, (i, j) in enumerate([(0, 1), (0, 2), (1, 2)]):
        found[k, i, j], found[k, j, i], found[3 + k, k, 3] = 1, -1, 1
    return found


def body_motion(T, dT):
    """Small motions as the tool sees them: six numbers for each pose, in one row."""
    D = np.linalg.inv(T) @ dT
    return np.concatenate([D[:, [0, 0, 1], [1, 2, 2]], D[:, :3, 3]], axis=1).ravel()


def repair_works(answer, reference, message):
    """Whether the change that the message asks for makes the answer right."""
    found = re.match(r"Joint (\d+): the \w+ (theta|d|a)\d+.* is .*; it should be (-?[\d.e-]+)(°?)",
                     message)
    if not found:
        return False
    value = float(found[3].rstrip(".")) * (pi / 180 if found[4] else 1)
    row = int(found[1]) - 1
    mended = changed(answer, row, found[2], value - getattr(answer.links[row], found[2]))
    verdict = kl.same_mechanism(mended, reference, tip=False)
    return verdict.ok or ("should be" in verdict.message and close(verdict.message))


def close(message):
    """The message shows six digits: what is left after typing them in is rounding."""
    got, wanted = re.search(r" is (-?[\d.e-]+)°?; .*should be (-?[\d.e-]+)", message).groups()
    return abs(float(got) - float(wanted.rstrip("."))) < 1e-3


def fits(answer, reference, signs, rng, starts=30, steps=60):
    """Whether base, tool and joint offsets can be found that make the arms move alike.

    Levenberg and Marquardt's search on the poses alone, from several starts.
    """
    poses = rng.uniform(-2, 2, (4 * answer.n + 4, answer.n))
    wanted = kl.forward_kinematics(reference, poses)
    return any(_search(answer, poses * signs, wanted, rng, start, steps) < 1e-9
               for start in range(starts))


def _search(arm, poses, wanted, rng, start, steps):
    offsets = rng.uniform(-pi, pi, arm.n) if start else np.zeros(arm.n)
    now = kl.forward_kinematics(arm, poses + offsets)
    tool, damping = random_pose(rng) if start else np.eye(4), 1e-3
    base = wanted[0] @ np.linalg.inv(now[0] @ tool)
    error = _error(arm, poses, wanted, offsets, base, tool)
    for _ in range(steps):
        slopes = _slopes(arm, poses, wanted, offsets, base, tool)
        step = np.linalg.solve(slopes.T @ slopes + damping * np.eye(slopes.shape[1]),
                               -slopes.T @ error)
        trial = (offsets + step[:arm.n], small(step[arm.n:-6]) @ base, tool @ small(step[-6:]))
        better = _error(arm, poses, wanted, *trial)
        if better @ better < error @ error:
            (offsets, base, tool), error, damping = trial, better, damping / 5
        else:
            damping *= 5
        if error @ error < 1e-20 or damping > 1e8:
            break
    return np.sqrt(error @ error)


def _error(arm, poses, wanted, offsets, base, tool):
    T = base @ kl.forward_kinematics(arm, poses + offsets) @ tool
    return (T - wanted)[:, :3].ravel()


def _slopes(arm, poses, wanted, offsets, base, tool, h=1e-6):
    zero = np.zeros(6)
    moves = [(offsets + h * e, base, tool) for e in np.eye(arm.n)]
    moves += [(offsets, small(zero + h * e) @ base, tool) for e in np.eye(6)]
    moves += [(offsets, base, tool @ small(zero + h * e)) for e in np.eye(6)]
    now = _error(arm, poses, wanted, offsets, base, tool)
    return np.column_stack([(_error(arm, poses, wanted, *move) - now) / h for move in moves])


def small(step):
    """The rigid motion of six numbers: a turn and a shift."""
    a, b, c, *shift = step
    angle = np.sqrt(a * a + b * b + c * c)
    W = np.array([[0, a, b], [-a, 0, c], [-b, -c, 0]])
    k = 1 if angle < 1e-9 else np.sin(angle) / angle
    m = 0.5 if angle < 1e-4 else (1 - np.cos(angle)) / angle ** 2
    R = np.eye(3) + k * W + m * W @ W
    U, _, V = np.linalg.svd(R)
    return rigid(U @ V, shift)
