"""Frames that show velocities: columns of the Jacobian, and the ellipsoid of all velocities."""
import numpy as np
from hypothesis import given, settings
from strategies import arms_and_q

import kinlab as kl
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.readings import Vector, Volume
from kinlab.drawing.scene import ARROW, Item, Scene, Step, Velocity, at

close = np.testing.assert_allclose


def shown(arm, q, rates):
    """Frames of the columns and of the ellipsoid, and the tool's pose."""
    scene = arm_scene(arm)
    tip = len(scene.motions)
    extra = (*(Velocity(tip, rates, i) for i in range(arm.n)), Velocity(tip, rates))
    frames = Scene((*scene.motions, *extra), scene.items, tip, scene.center, 1.0).frames(q)
    return frames[tip + 1:-1], frames[-1], frames[tip]


@settings(max_examples=60)
@given(arms_and_q())
def test_columns_are_those_of_the_jacobian(arm_and_q):
    arm, q = arm_and_q
    rates = tuple(np.linspace(0.5, 2, arm.n).tolist())
    columns, ellipsoid, tool = shown(arm, q, rates)
    J = kl.jacobian(arm, q)[:3] * rates
    close(columns[:, :3, 3].T - tool[:3, 3:], J, atol=1e-9)
    close(ellipsoid[:3, 3], tool[:3, 3], atol=1e-9)


@settings(max_examples=60)
@given(arms_and_q())
def test_the_ellipsoid_is_the_image_of_the_unit_ball(arm_and_q):
    arm, q = arm_and_q
    _, ellipsoid, _ = shown(arm, q, (1.0,) * arm.n)
    J, L = kl.jacobian(arm, q)[:3], ellipsoid[:3, :3]
    close(L @ L.T, J @ J.T, atol=1e-9 * max(1, np.sum(J**2)))
    close(L, np.tril(L))


def test_a_stretched_arm_has_a_flat_ellipse():
    arm = kl.robots.two_link()
    _, ellipse, _ = shown(arm, [0.0, 0.0], (1.0, 1.0))
    close(ellipse[:3, :3], [[0, 0, 0], [0, np.sqrt(5), 0], [0, 0, 0]], atol=1e-12)


def test_two_links_by_hand():
    """theta = (0, 90 deg), links of 1 m: J = [[-1, -1], [1, 0]], |det J| = 1."""
    scene = arm_scene(kl.robots.two_link())
    tip = len(scene.motions)
    motions = (*scene.motions, *(Velocity(tip, (0.5, 0.5), i) for i in (0, 1)),
               Velocity(tip, (0.5, 0.5)))
    column = Vector((tip, 0, 0, 0), (tip + 1, 0, 0, 0), scale=2)
    item = Item("arrow", ARROW, "vector", at(tip, (0, 0, 0), (1, 0, 0)))
    scene = Scene(motions, (item,), tip, (0, 0, 0), 1.0)
    q = [0, np.pi / 2]
    frames = scene.frames(q)
    close(column.read(scene.motions, frames, q), [-1, 1], atol=1e-12)
    close(Volume(tip + 3, 2, 4.0).read(scene.motions, frames, q), 1, atol=1e-12)


def test_a_track_is_looked_up():
    step = Step("rotate", 2, joint=0, track=(1.0, 3.0, -1.0))
    close([step.value([place]) for place in (-1, 0, 0.5, 1, 1.75, 2, 9)], [1, 1, 2, 3, 0, -1, -1])
