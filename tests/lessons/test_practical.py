"""Views of lessons 06 and 07, against matrices that are multiplied here."""
import numpy as np
import pytest

import kinlab as kl
from kinlab.lessons import n_link

close = np.testing.assert_allclose


def turn(axis, degrees):
    R = {"x": kl.rotation_x, "z": kl.rotation_z}[axis](np.radians(degrees))
    return kl.homogeneous(R, [0, 0, 0])


MOTIONS = [("θ", turn("z", 40)), ("d", kl.translation([0, 0, 0.9])),
           ("a", kl.translation([0.8, 0, 0])), ("α", turn("x", -60))]


@pytest.mark.parametrize(("convention", "order"), [("standard", (0, 1, 2, 3)),
                                                   ("modified", (3, 2, 0, 1))])
def test_the_four_motions_come_in_the_order_of_the_convention(convention, order):
    view, T = n_link.four_motions(convention), np.eye(4)
    view.motion = 0
    for done, k in enumerate(order):
        close(frame(view), T, atol=1e-12)
        T = T @ MOTIONS[k][1]
        view.motion = done + 1
    close(frame(view), T, atol=1e-12)


def frame(view):
    scene = view._scene
    return scene.frames(view._values)[scene.tip]


@pytest.mark.parametrize(("twist", "height"), [(0, 1), (60, 0.5), (90, 0)])
def test_the_printed_matrix_presses_the_cube_flat(twist, height):
    """Its third column is (0, 0, cos of the next twist) where the twist before is 0."""
    view = n_link.flat_view()
    view.alpha_i, view.theta_i = twist, 30
    printed = kl.rotation_z(np.radians(30)) @ np.diag([1, 1, height])
    close(view.readings["P"][0], printed @ [0.5, -0.5, 1], atol=1e-3)
    close(view.readings["det"][0], [np.linalg.det(printed)], atol=1e-3)


def test_the_six_link_arm_shows_one_frame_at_its_wrist():
    frames = {item.frame for item in n_link.six_view()._scene.items if item.layer == "frames"}
    assert frames == {"0", "3", "6"}
