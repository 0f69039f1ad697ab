"""Descriptions that makers and labs publish (`public/`), against a second reader."""
import re
from pathlib import Path

import numpy as np
import plain_reader
import pytest

import kinlab as kl

pytestmark = pytest.mark.filterwarnings("ignore::kinlab.arms.inputs.Note")
FOLDER = Path(__file__).with_name("public")
# The tip, how many joints q has, and the convention.
ROBOTS = {
    "al5d": ("link4", 4, "standard"), "baxter": ("left_gripper", 7, "standard"),
    "iiwa14": ("tool0", 7, "standard"), "irb140": ("tool0", 6, "standard"),
    "kinova": ("j2s6s200_end_effector", 6, "standard"), "kr210l150": ("tool0", 6, "standard"),
    "panda": ("panda_hand", 7, "modified"), "pr2": ("r_gripper_tool_frame", 8, "standard"),
    "puma560": ("link7", 6, "standard"), "so100": ("jaw", 6, "standard"),
    "ur5": ("tool0", 6, "standard"), "xarm7": ("link7", 7, "standard"),
}
every = pytest.mark.parametrize("name", ROBOTS)


def text(name):
    return (FOLDER / f"{name}.urdf").read_text(encoding="utf-8")


def test_all_of_them_are_tried():
    assert {path.stem for path in FOLDER.glob("*.urdf")} == {*ROBOTS}


@every
def test_a_file_says_where_it_is_from_and_under_which_licence(name):
    assert re.match(r"<!-- From the package [\w-]+ [\d.]+, [\w.]+; upstream \S+.*\. Licence: .*"
                    r"(BSD|MIT|Apache-2\.0)", text(name))


@every
def test_poses_are_those_of_a_second_reader(name):
    tip, n, _ = ROBOTS[name]
    arm = kl.from_urdf(FOLDER / f"{name}.urdf", tip)
    assert arm.n == n
    assert [link.name for link in arm.joints] == plain_reader.movable(text(name), tip)
    for q in np.random.default_rng(3).uniform(-3, 3, (40, n)):
        np.testing.assert_allclose(kl.forward_kinematics(arm, q),
                                   plain_reader.pose(text(name), tip, q), rtol=0, atol=1e-9)


@every
def test_a_table_has_a_row_for_each_joint_unless_axes_are_almost_parallel(name):
    """The AL5D's file has pi/2 with seven digits between its parallel axes."""
    tip, n, convention = ROBOTS[name]
    arm = kl.from_urdf(FOLDER / f"{name}.urdf", tip)
    assert len(arm.links) - n == {"al5d": 2}.get(name, 0)
    assert arm.convention == convention


@every
def test_no_number_is_rounding_noise(name):
    arm = kl.from_urdf(FOLDER / f"{name}.urdf", ROBOTS[name][0])
    numbers = [getattr(link, column) for link in arm.links for column in ("a", "d", "theta")]
    numbers += [*arm.base[:3, 3], *arm.tool[:3, 3]]
    assert not [number for number in numbers if 0 < abs(number) < 1.5e-10]
    assert not [number for number in numbers if number == 0 and np.signbit(number)]


@every
def test_it_comes_back_from_what_kinlab_writes(name):
    arm = kl.from_urdf(FOLDER / f"{name}.urdf", ROBOTS[name][0])
    again = kl.from_urdf(kl.to_urdf(arm))
    q = np.random.default_rng(4).uniform(-3, 3, (40, arm.n))
    np.testing.assert_allclose(kl.forward_kinematics(again, q), kl.forward_kinematics(arm, q),
                               rtol=0, atol=1e-9)


def test_a_robot_with_branches_asks_for_its_tip():
    with pytest.raises(ValueError) as caught:
        kl.from_urdf(text("ur5"))
    assert str(caught.value) == (
        "tip: expected one end of the arm, got 2: 'ee_link', 'tool0'; choose one, or a link before "
        "it: kl.from_urdf(..., tip='ee_link')")


def test_fingers_beyond_the_tip_do_no_harm_and_are_none_themselves():
    assert kl.from_urdf(text("panda"), "panda_hand").n == 7
    with pytest.raises(ValueError, match=r"^joint 'panda_finger_joint2': expected a joint with a "
                       "value of its own, got one that follows another"):
        kl.from_urdf(text("panda"), "panda_rightfinger")
