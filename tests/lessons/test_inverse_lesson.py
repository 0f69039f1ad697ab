"""What the views of lesson 10 draw is what its words say."""
import numpy as np

import kinlab as kl
from kinlab.lessons.views import inverse as views

close = np.testing.assert_allclose


def test_all_eight_ways_lead_to_one_pose_in_two_shapes():
    arm, view = kl.robots.intelledex_660t(), views.eight_view()
    wanted = kl.forward_kinematics(arm, [0.3, 0.4, -0.5, 0.6, 0.5, 0.3])
    elbows = []
    for way in range(1, 9):
        view["way"].value = way
        drawn = view._scene.frames(view._values)
        close(drawn[view._scene.tip], wanted, atol=1e-3)
        elbows.append(kl.link_frames(arm, views.eight_ways()[way - 1])[3, 2, 3])
    close(elbows[:4], elbows[0], atol=1e-3)
    close(elbows[4:], elbows[4], atol=1e-3)
    assert elbows[0] > elbows[4] + 10


def test_the_ways_of_one_shape_are_the_zyz_pair_and_turned_pitch_axes():
    ways = np.array(views.eight_ways())[:4]
    first = ways[2]
    pair = first * [1, -1, 1, 1, 1, 1] + [np.pi, 0, np.pi, 0, 0, 0]
    turned = first * [1, 1, -1, -1, -1, 1] + [0, np.pi, np.pi, 0, np.pi, np.pi]
    for one in (pair, turned):
        gaps = np.abs(np.exp(1j * ways) - np.exp(1j * one)).max(axis=1)
        assert np.count_nonzero(gaps < 1e-3) == 1


def test_a_solve_alone_stands_where_its_arm_stands():
    view, arm = views.stop_view(), kl.robots.two_link()
    assert list(view.readings) == ["damped"]
    steps = kl.inverse_kinematics(arm, [2, 1, 0], [0.2, 0.4], weights=[1, 1, 0], restarts=0,
                                  steps=15).history
    for k in (0, 3, 15):
        view["step"].value = k
        (tool,) = (item for item in view._scene.items if item.gid == "damped-tool")
        frame = view._scene.frames(view._values)[tool.points[0][0]]
        close(frame[:3, 3], kl.forward_kinematics(arm, steps[k].q)[:3, 3], atol=1e-9)


def test_the_wanted_frame_is_tilted_to_the_side():
    scene = views.tilt_view()._scene
    (axis,) = (item for item in scene.items if item.gid == "frame-*-z")
    frame = scene.frames(scene.begin)[axis.points[0][0]]
    close(frame[:3, 3], [300, 0, 80])
    close(frame[:3, 2], [0, -np.sin(np.radians(20)), -np.cos(np.radians(20))], atol=1e-12)
