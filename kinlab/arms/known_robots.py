"""Arms that people know: the arms of textbooks, laboratories and factories.

Each docstring says whose numbers these are and which of them are ours. Names of joints are ours
where no other source is given.
"""
from __future__ import annotations

from functools import partial
from math import pi, radians

import numpy as np

from .arm import Arm
from .link import prismatic, revolute
from .transforms import translation

RIGHT = pi / 2
_INCH = 0.0254


def puma_560() -> Arm:
    """Unimation PUMA 560, six revolute joints, lengths in m.

    Source: P. Corke, Robotics Toolbox, model Puma560 (standard DH), after P. Corke and B.
    Armstrong-Helouvry, A search for consensus among model parameters reported for the PUMA 560
    robot, ICRA 1994: table, and joint limits, which the toolbox takes from Wang and Chen, 1991.
    d1 = 0.672 m, from the mounting surface to the shoulder, is in the toolbox for Python; the one
    for MATLAB has d1 = 0. The tool is frame 6, in the middle of the wrist. No speeds of this arm
    were found. Home: the toolbox's nominal pose, q = (0, 45, -180, 0, 45, 0) degrees; the toolbox
    writes 180, which is the same pose beyond the limit.

    `kl.to_modified` gives it in the modified convention. Craig's own modified table is
    `puma_560_craig`, which says what differs.

    Examples
    --------
    >>> puma_560().links[1].a
    0.4318
    """
    links = [
        revolute(d=0.672, alpha=RIGHT, limits=between(-160, 160), name="waist"),
        revolute(a=0.4318, limits=between(-45, 225), name="shoulder"),
        revolute(d=0.15005, a=0.0203, alpha=-RIGHT, limits=between(-225, 45), name="elbow"),
        revolute(d=0.4318, alpha=RIGHT, limits=between(-110, 170), name="wrist rotation"),
        revolute(alpha=-RIGHT, limits=between(-100, 100), name="wrist bend"),
        revolute(limits=between(-266, 266), name="flange rotation")]
    return Arm(links, name="PUMA 560", unit="m", home=np.radians([0, 45, -180, 0, 45, 0]))


def puma_560_craig() -> Arm:
    """The PUMA 560 by Craig's own table, six revolute joints, lengths in m.

    Source: J. J. Craig, Introduction to Robotics: Mechanics and Control, chapter 3, link
    parameters of the PUMA 560 (modified DH), with the letters a2, a3, d3 and d4. Ours: their
    values, those of `puma_560`, so that the two tables describe one arm; the base, 0.672 m below
    Craig's frame 0, which lies in the shoulder; the home q = (0, -45, 0, 0, -45, 0) degrees.
    Craig gives no limits.

    It is the same mechanism as `puma_560`, as `kl.same_mechanism` says, too: all axes point the
    same way, no joint counts backwards, the tool is the same, and in the modified convention
    frames 2 to 6 are. Two things differ. Craig's frame 0 lies in the shoulder. And joints 1 and 2
    count from zeros half a turn away: this arm at (q1, q2, q3, ...) stands as `puma_560` at
    (q1 + 180, q2 + 180, q3, ...) degrees. So at q1 = 0 Craig's shoulder is on the other side, a
    left arm, and at q2 = q3 = 0 its forearm hangs down where the other one's stands up.

    Examples
    --------
    >>> puma_560_craig().convention
    'modified'
    """
    links = [
        revolute(name="waist"), revolute(alpha=-RIGHT, name="shoulder"),
        revolute(a=0.4318, d=0.15005, name="elbow"),
        revolute(a=0.0203, alpha=-RIGHT, d=0.4318, name="wrist rotation"),
        revolute(alpha=RIGHT, name="wrist bend"), revolute(alpha=-RIGHT, name="flange rotation")]
    return Arm(links, convention="modified", name="PUMA 560 (Craig)", unit="m",
               base=translation([0, 0, 0.672]), home=np.radians([0, -45, 0, 0, -45, 0]))


def stanford() -> Arm:
    """Stanford arm of V. Scheinman: a revolute-revolute-prismatic arm with a wrist, in m.

    Source: M. Spong, S. Hutchinson, M. Vidyasagar, Robot Dynamics and Control, 2nd ed., 2004, DH
    parameters for the Stanford manipulator (standard DH), with the letters d2 and d6; R. Paul,
    Robot Manipulators, 1981, has the same table without d6. Lengths and limits: P. Corke,
    Robotics Toolbox, model stanford: d1 = 0.412, d2 = 0.154, d6 = 0.263 m, a slide of 12 to 50
    inches, which it estimated from a photograph; the turns are from a paper of IJCAI 1973. d1,
    0 in the books, is the height of the shoulder above the floor. No speeds were found. Joint 3
    has theta = 0 and a = 0 as in the books; the toolbox has -90 degrees and 0.0203 m there.
    Home, ours: q = (0, 75 deg, 0.6 m, 0, 45 deg, 0), the boom's tail clear of the floor.

    Examples
    --------
    >>> [link.kind for link in stanford().links][:3]
    ['revolute', 'revolute', 'prismatic']
    """
    far = between(-170, 170)
    links = [
        revolute(d=0.412, alpha=-RIGHT, limits=far, name="waist"),
        revolute(d=0.154, alpha=RIGHT, limits=far, name="shoulder"),
        prismatic(limits=(12 * _INCH, 50 * _INCH), name="boom"),
        revolute(alpha=-RIGHT, limits=far, name="wrist rotation"),
        revolute(alpha=RIGHT, limits=between(-90, 90), name="wrist bend"),
        revolute(d=0.263, limits=far, name="hand rotation")]
    return Arm(links, name="Stanford arm", unit="m",
               home=[0, radians(75), 0.6, 0, radians(45), 0])


def scara() -> Arm:
    """AdeptOne, a SCARA: two parallel revolute joints, a slide and a roll, lengths in mm.

    Source: R. Schilling, Fundamentals of Robotics, 1990, kinematic parameters of the four-axis
    SCARA robot (standard DH; the book was not seen, lectures that follow it agree): the table,
    d1 = 877, a1 = 425, a2 = 375, d4 = 200 mm, and a slide of 0 to 195 mm. Since alpha1 = 180
    degrees, joints 2 and 4 turn about axes that point down. Limits of the turns, ours: 150, 150
    and 180 degrees either way. No speeds were found.
    Home, ours: q = (40 deg, 80 deg, 100 mm, -40 deg); the book's, (0, 0, 100, 90), is stretched.

    Examples
    --------
    >>> [link.kind for link in scara().links]
    ['revolute', 'revolute', 'prismatic', 'revolute']
    """
    links = [
        revolute(d=877, a=425, alpha=pi, limits=between(-150, 150), name="shoulder"),
        revolute(a=375, limits=between(-150, 150), name="elbow"),
        prismatic(limits=(0, 195), name="quill"),
        revolute(d=200, limits=between(-180, 180), name="tool roll")]
    return Arm(links, name="SCARA", unit="mm",
               home=[radians(40), radians(80), 100, radians(-40)])


def ur5() -> Arm:
    """Universal Robots UR5, six revolute joints, lengths in m.

    Source: Universal Robots, manual of the UR5 with CB3, Denavit-Hartenberg parameters of the UR5
    series 3 (standard DH). The maker's "base" frame is frame 0; ROS turns it by half a turn about
    z. Limits of 360 degrees either way, the elbow too, and a speed of 180 degrees/s of every
    joint are from the maker's UR5 manual, version 3.13, as ros-industrial/universal_robot
    copied them; accelerations are not published. The names are the maker's, too.
    Home, ours: q = (0, -90, -90, -90, 90, 0) degrees, forearm level, tool down.

    Examples
    --------
    >>> ur5().links[1].a
    -0.425
    """
    joint = partial(revolute, limits=between(-360, 360), speed=pi)
    links = [
        joint(d=0.089159, alpha=RIGHT, name="base"), joint(a=-0.425, name="shoulder"),
        joint(a=-0.39225, name="elbow"), joint(d=0.10915, alpha=RIGHT, name="wrist 1"),
        joint(d=0.09465, alpha=-RIGHT, name="wrist 2"), joint(d=0.0823, name="wrist 3")]
    return Arm(links, name="UR5", unit="m", home=np.radians([0, -90, -90, -90, 90, 0]))


def panda() -> Arm:
    """Franka Emika Panda, seven revolute joints, lengths in m.

    Source: Franka Emika, Franka Control Interface documentation, robot and interface
    specifications: Denavit-Hartenberg parameters (modified DH, as Craig), and the Panda's limits
    of angle, speed and acceleration. The table's row "Flange", d = 0.107 m, is the tool here.
    Home: q = (0, -45, 0, -135, 0, 90, 45) degrees, from which the maker's examples begin.

    Examples
    --------
    >>> panda().n, panda().links[1].acceleration
    (7, 7.5)
    """
    slow, fast, wide = 2.175, 2.61, (-2.8973, 2.8973)
    links = [
        revolute(d=0.333, limits=wide, speed=slow, acceleration=15),
        revolute(alpha=-RIGHT, limits=(-1.7628, 1.7628), speed=slow, acceleration=7.5),
        revolute(alpha=RIGHT, d=0.316, limits=wide, speed=slow, acceleration=10),
        revolute(a=0.0825, alpha=RIGHT, limits=(-3.0718, -0.0698), speed=slow, acceleration=12.5),
        revolute(a=-0.0825, alpha=-RIGHT, d=0.384, limits=wide, speed=fast, acceleration=15),
        revolute(alpha=RIGHT, limits=(-0.0175, 3.7525), speed=fast, acceleration=20),
        revolute(a=0.088, alpha=RIGHT, limits=wide, speed=fast, acceleration=20)]
    return Arm(links, convention="modified", name="Panda", unit="m",
               tool=translation([0, 0, 0.107]), home=np.radians([0, -45, 0, -135, 0, 90, 45]))


def kr210() -> Arm:
    """KUKA KR 210, six revolute joints, lengths in m.

    Source: Udacity, Robotics Software Engineer, kinematics project (repository
    udacity/RoboND-Kinematics-Project): lengths, limits and speeds from its kr210.urdf.xacro; the
    modified DH table, which the project leaves to its students, as many of them published it. The
    gripper is 0.303 m from the wrist: 0.193 m to the flange and 0.11 m beyond. At q = 0 the upper
    arm stands up and the forearm is level. Names A1 to A6 are KUKA's; KUKA counts some of its
    angles the other way and from other zeros.
    Home, ours: q = (0, -15, 30, 0, 75, 0) degrees, tool down.

    Examples
    --------
    >>> kr210().links[2].a
    1.25
    """
    links = [
        revolute(d=0.75, limits=between(-185, 185), speed=radians(123), name="A1"),
        revolute(a=0.35, alpha=-RIGHT, theta=-RIGHT, limits=between(-45, 85), speed=radians(115),
                 name="A2"),
        revolute(a=1.25, limits=between(-210, 65), speed=radians(112), name="A3"),
        revolute(a=-0.054, alpha=-RIGHT, d=1.5, limits=between(-350, 350), speed=radians(179),
                 name="A4"),
        revolute(alpha=RIGHT, limits=between(-125, 125), speed=radians(172), name="A5"),
        revolute(alpha=-RIGHT, limits=between(-350, 350), speed=radians(219), name="A6")]
    return Arm(links, convention="modified", name="KR 210", unit="m",
               tool=translation([0, 0, 0.303]), home=np.radians([0, -15, 30, 0, 75, 0]))



def between(low: float, high: float) -> tuple[float, float]:
    """The limits of a joint, from degrees."""
    return radians(low), radians(high)
