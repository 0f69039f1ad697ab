"""What the views of the Intelledex lesson draw is where its words say."""
import numpy as np

import kinlab as kl
from kinlab.lessons import intelledex as lesson

close = np.testing.assert_allclose


def test_u_v_and_w_are_the_directions_of_the_text():
    view = lesson.plane_view()
    for t1, t2 in ((0, 0), (25, 70), (-100, 140)):
        view.q = np.radians([t1, t2, 20, 30, 40, 50])
        (c1, c2), (s1, s2) = np.cos(np.radians([t1, t2])), np.sin(np.radians([t1, t2]))
        close(view.readings["u"][0], [c1 * c2, s1 * c2, s2], atol=1e-12)
        close(view.readings["v"][0], [s1, -c1, 0], atol=1e-12)
        close(view.readings["w"][0], [c1 * s2, s1 * s2, -c2], atol=1e-12)


def test_the_arm_bends_in_the_plane_of_u_and_v():
    arm = kl.robots.intelledex_660t()
    for q in np.random.default_rng(3).uniform(-3, 3, (20, 6)):
        frames = kl.link_frames(arm, q)
        close((frames[2:, :3, 3] - [0, 0, 373.4]) @ frames[2, :3, 2], 0, atol=1e-9)


def test_three_turned_axes_give_the_same_arm_with_three_joints_counting_backwards():
    arm, other = kl.robots.intelledex_660t(), lesson.turned_round()
    q = np.random.default_rng(0).uniform(-np.pi, np.pi, (50, 6))
    close(kl.forward_kinematics(other, q * [1, 1, -1, -1, -1, 1]), kl.forward_kinematics(arm, q),
          atol=1e-9)
    axes, turned = (kl.link_frames(one, one.home)[:, :3, 2] for one in (arm, other))
    close([a @ b for a, b in zip(axes, turned)], [1, 1, -1, -1, -1, 1, 1], atol=1e-12)
