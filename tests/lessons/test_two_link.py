"""What the lessons on homogeneous transforms and on the two-link arm draw is where it should be."""
import numpy as np
import pytest

import kinlab as kl

SKIN = 0.1593648  # m: 0.93 of a joint's radius, which is 0.034 of 1.05 * 4 * 1.2 m
ANGLES = [(0.4, 0.7), (-2.0, 1.1), (3.0, -2.5)]


def places(view, gid):
    """The points of one drawn item, in the room's plane."""
    frames = view._scene.frames(view._values)
    item = next(item for item in view._scene.items if item.gid == gid)
    return np.array([(frames[k] @ (*local, 1))[:2] for k, *local in item.points])


def polar(length, angle):
    return length * np.array([np.cos(angle), np.sin(angle)])


@pytest.mark.parametrize("t1, t2", ANGLES)
def test_the_dashed_legs_are_the_components_of_the_links(t1, t2):
    view, l1, l2 = kl.lessons.two_link.both_methods(), 1.7, 0.9
    for name, value in dict(theta_1=np.degrees(t1), theta_2=np.degrees(t2), l_1=l1, l_2=l2).items():
        view[name].value = value
    P = polar(l1, t1)
    Q = P + polar(l2, t1 + t2)
    np.testing.assert_allclose(places(view, "legs-l₁C₁"), [[0, 0], [P[0], 0], P], atol=1e-12)
    np.testing.assert_allclose(places(view, "legs-l₂C₁₂"), [P, [Q[0], P[1]], Q], atol=1e-12)
    skin = 0.12648  # of a joint with a radius of 0.136
    np.testing.assert_allclose(places(view, "link-1"), [polar(skin, t1), P - polar(skin, t1)],
                               atol=1e-9)
    np.testing.assert_allclose(places(view, "link-2"), [P + polar(skin, t1 + t2), Q], atol=1e-9)
    for name, right in dict(P_trig=P, P_H=P, leg=Q - P, Q_trig=Q, Q_H=Q).items():
        np.testing.assert_allclose(view.readings[name][0], right, atol=1e-12)


def test_the_arcs_of_an_arm_run_to_the_cumulative_angles():
    view = kl.lessons.two_link.n_links(4)
    phi, joint = np.cumsum(view._values), np.zeros(2)
    for k, angle in enumerate(phi):
        arc = places(view, f"arc-φ{'₁₂₃₄'[k]}") - joint
        np.testing.assert_allclose(arc, [polar(0.5, share * angle) for share in
                                         np.linspace(0, 1, 9)], atol=1e-12)
        link = polar(1, angle)
        np.testing.assert_allclose(places(view, f"link-{k + 1}"), [
            joint + SKIN * link, joint + (1.2 - SKIN * (k < 3)) * link], atol=1e-9)
        joint = joint + view.readings[f"link-{k + 1}"][0]
    np.testing.assert_allclose(view.readings["Q"][0], joint)


@pytest.mark.parametrize("view, degrees", [
    (kl.lessons.two_link.both_methods, {"theta_1": 35, "theta_2": 25}),
    (kl.lessons.two_link.n_links, {"theta_1": 30, "theta_2": 40, "theta_3": -65, "theta_4": 80}),
    (kl.lessons.homogeneous.chain, {"theta_1": 50, "theta_2": -80, "theta_3": 60}),
    (kl.lessons.workspace.ring_view, {"theta_1": 35, "theta_2": 60})])
def test_angles_begin_where_the_lesson_says(view, degrees):
    live = view()
    assert {name: live[name].value for name in degrees} == degrees
    assert [live[name].description for name in ("theta_1", "theta_2")] == ["θ₁ (°)", "θ₂ (°)"]


@pytest.mark.parametrize("n", range(1, 7))
def test_the_arrows_of_a_chain_run_head_to_tail(n):
    view = kl.lessons.homogeneous.chain(n)
    *terms, total = [vector for vector, in view.readings.values()]
    assert len(terms) == n + 1
    np.testing.assert_allclose(np.sum(terms, axis=0), total)
    arrows = np.array([places(view, item.gid) for item in view._scene.items
                       if item.gid.startswith("arrow-")])
    np.testing.assert_allclose(arrows[1:, 0], arrows[:-1, 1])
    np.testing.assert_allclose(arrows[:, 1] - arrows[:, 0], terms)


@pytest.mark.parametrize("view, other", [("order", "B"), ("fixed", "F")])
def test_slide_and_turn_end_where_their_order_says(view, other):
    live = getattr(kl.lessons.homogeneous, view)()
    live["t"].value = 2
    np.testing.assert_allclose(live.readings["A"], [[2, 0], polar(1, np.pi / 3)], atol=1e-12)
    np.testing.assert_allclose(live.readings[other], [polar(2, np.pi / 3), polar(1, np.pi / 3)])
    live["t"].value = 1
    first = [[0, 0], polar(1, np.pi / 3)] if other == "B" else [[2, 0], [1, 0]]
    np.testing.assert_allclose(live.readings[other], first, atol=1e-12)
