"""The edge of what three parallel joints reach: by geometry, by brute force, by the solver."""
from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

import kinlab as kl
from kinlab.arms.section import Arc, Chain, edge

close = np.testing.assert_allclose
UPPER, FORE, TOOL, SHOULDER = 177.8, 177.8, 129.5, 215.0
LIMITS = ((-radians(120), radians(120)), (-radians(135), radians(135)),
          (-radians(225), radians(45)))
ALPHA = Chain((UPPER, FORE, TOOL), LIMITS)
WHOLE = ((-pi, pi),) * 3


def outline(rows, near=1e-3):
    return [np.concatenate([arc.corners(near)[:-1] for arc in row]) for row in rows]


def area(loop):
    """Positive if it goes round counter-clockwise."""
    return 0.5 * np.sum((loop.conjugate() * np.roll(loop, -1)).imag)


@pytest.fixture(scope="module")
def rows():
    return edge(ALPHA)


def test_arcs_by_hand():
    arc = Arc(1 + 1j, 2.0, 0.0, pi / 2)
    close(arc.at(np.array([0, 1])), [3 + 1j, 1 + 3j], atol=1e-12)
    close(arc.reversed().at(np.array([0, 1])), [1 + 3j, 3 + 1j], atol=1e-12)
    close(arc.mirrored().at(np.array([0, 1])), [-3 + 1j, -1 + 3j], atol=1e-12)
    middles = (arc.corners(1e-3)[1:] + arc.corners(1e-3)[:-1]) / 2
    assert 0 < (2 - np.abs(middles - arc.center)).max() <= 1e-3


def test_the_far_edge_of_the_alpha_ii_is_three_arcs(rows):
    """The stretched arm about the shoulder; at the shoulder's limits, forearm and tool straight."""
    elbow = UPPER * np.exp(1j * radians(120))
    found = {(round(arc.center.real, 6), round(arc.center.imag, 6), round(arc.radius, 6))
             for arc in rows[0]}
    assert found == {(0, 0, 485.1), (round(elbow.real, 6), round(elbow.imag, 6), 307.3),
                     (round(elbow.real, 6), -round(elbow.imag, 6), 307.3)}


def test_how_far_the_alpha_ii_reaches(rows):
    (outer, _), aside, up = outline(rows), UPPER * sin(radians(30)), UPPER * cos(radians(30))
    close([outer.real.max(), outer.imag.max(), outer.imag.min()], [485.1, 485.1, -485.1], atol=1e-3)
    close(outer.real.min(), -aside - FORE - TOOL, atol=1e-2)
    notch = -aside - sqrt((FORE + TOOL) ** 2 - up**2)  # where the arcs of both elbows meet
    assert np.abs(outer - notch).min() < 1e-3


def test_the_area_by_hand(rows):
    """Two thirds of a disc; on each side a sector about the elbow and a triangle to the notch."""
    long, up = FORE + TOOL, UPPER * cos(radians(30))
    notch = UPPER / 2 + sqrt(long**2 - up**2)
    sector = radians(60) + np.arcsin(up / long)
    by_hand = 2 / 3 * pi * 485.1**2 + sector * long**2 + notch * up
    outer, hole = outline(rows)
    close(area(outer), by_hand, rtol=1e-5)
    assert area(hole) < 0


def test_the_hole_is_as_near_as_the_tool_comes_to_the_shoulder(rows):
    """Elbow at its limit, the tool folded back: lesson 09, exercise 4."""
    _, hole = outline(rows)
    nearest = abs(2 * UPPER * sin(radians(22.5)) - TOOL)
    close(np.abs(hole).min(), nearest, rtol=1e-5)
    close(nearest, 6.58, atol=5e-3)


def test_a_base_that_turns_half_round_reaches_a_disc():
    outer, hole = outline(edge(ALPHA, both_sides=True))
    close(area(outer), pi * 485.1**2, rtol=1e-5)
    close(np.abs(outer), 485.1, rtol=1e-9)
    assert np.abs(hole).max() < 10


@pytest.mark.parametrize("lengths, radii", [((1.0, 0.6, 0.2), (1.8, 0.2)),
                                            ((0.3, 0.5, 2.0), (2.8, 1.2)),
                                            ((1.0, 0.7, 0.5), (2.2,))])
def test_without_limits_it_is_a_ring_or_a_disc(lengths, radii):
    loops = outline(edge(Chain(lengths, WHOLE)), 1e-5)
    assert len(loops) == len(radii)
    for loop, radius, way in zip(loops, radii, (1, -1)):
        close(np.abs(loop), radius, rtol=1e-9)
        close(area(loop), way * pi * radius**2, rtol=1e-4)


CHAINS = [ALPHA, Chain((1.0, 0.6, 0.3), ((-0.4, 2.2), (0.2, 2.0), (-1.0, 0.5))),
          Chain((0.5, 1.0, 0.4), ((0.0, 1.0), (-2.5, -0.5), (-3.0, 3.0))),
          Chain((0.5, 0.5, 0.8), ((-3.0, 3.0), (-0.2, 0.3), (1.0, 2.0)))]


def rounds(loops, points):
    """How often closed lines go round each point."""
    turns = np.zeros(len(points))
    for loop in loops:
        ways = loop[None] - points[:, None]
        turns += np.angle(np.roll(ways, -1, axis=1) / ways).sum(axis=1) / (2 * pi)
    return np.round(turns).astype(int)


@pytest.mark.parametrize("chain", CHAINS)
def test_all_that_is_tried_lies_inside(chain):
    low, high = np.transpose(chain.limits)
    tips = chain.tip(low + np.random.default_rng(2).random((1500, 3)) * (high - low))
    assert chain.inside(tips).all()
    loops = outline(edge(chain), 5e-4 * chain.reach)
    off = np.array([min(np.abs(loop - tip).min() for loop in loops) for tip in tips])
    assert np.all(rounds(loops, tips[off > 0.02 * chain.reach]) == 1)


@pytest.mark.parametrize("chain", CHAINS)
def test_the_edge_parts_what_is_reached_from_what_is_not(chain):
    """By brute force: all poses of a fine grid, and points that are not too near to the edge."""
    grid = np.stack(np.meshgrid(*(np.linspace(*ends, 70) for ends in chain.limits)), axis=-1)
    tips, cell = chain.tip(grid.reshape(-1, 3)), 0.03 * chain.reach
    held = set(map(tuple, np.unique(_cells(tips, cell), axis=0).tolist()))
    corners = (np.random.default_rng(3).uniform(-1, 1, (300, 2)) * chain.reach)
    points, loops = corners @ [1, 1j], outline(edge(chain), 5e-4 * chain.reach)
    off = np.array([min(np.abs(loop - point).min() for loop in loops) for point in points])
    points = points[off > 0.06 * chain.reach]
    reached = [tuple(place) in held for place in _cells(points, cell).tolist()]
    assert np.array_equal(rounds(loops, points) == 1, reached)
    assert np.array_equal(chain.inside(points), reached)


def _cells(points, side):
    return np.floor(np.stack([points.real, points.imag], axis=-1) / side).astype(int)


def test_the_solver_of_inverse_kinematics_agrees(rows):
    """It knows nothing of arcs: points of the plane y = 0, not too near to the edge."""
    rng, loops = np.random.default_rng(4), outline(rows)
    points = rng.uniform(-520, 520, (40, 2)) @ [1, 1j]
    off = np.array([min(np.abs(loop - point).min() for loop in loops) for point in points])
    points = points[off > 8]
    targets = np.stack([points.real, 0 * points.real, SHOULDER + points.imag], axis=-1)
    solved = kl.inverse_kinematics_batch(kl.robots.alpha_ii(), targets).success
    assert np.array_equal(solved, rounds(loops, points) == 1)
