"""The arms that kinlab has: those of the course here, those that people know beside it.

Tables of the course's arms are as the course prints them; where it prints no number, the choice
made here is named. Their joint limits are generous and illustrative: no reliable ones were found.
"""
from __future__ import annotations

import numpy as np

from .arm import Arm
from .known_robots import (
    RIGHT,
    between,
    kr210,
    panda,
    puma_560,
    puma_560_craig,
    scara,
    stanford,
    ur5,
)
from .link import prismatic, revolute
from .transforms import translation

__all__ = ["alpha_ii", "cylindrical", "exam_2018", "intelledex_660t", "kr210", "panda",
           "practical_six_link", "puma_560", "puma_560_craig", "scara", "stanford", "two_link",
           "ur5"]


def two_link() -> Arm:
    """Planar two-link arm, a1 = a2 = 1 m.

    Source: IIT Jodhpur, Robotics, Practical 3 (modified DH; its header must be read
    alpha_{i-1}, a_{i-1}); the same arm by homogeneous transforms in Robotics and Controls,
    lecture 4. Home, a choice of ours: q = (30, 45) degrees.

    Examples
    --------
    >>> two_link().convention
    'modified'
    """
    return Arm([revolute(name="shoulder"), revolute(a=1, name="elbow")], convention="modified",
               name="Two-link", unit="m", tool=translation([1, 0, 0]), home=np.radians([30, 45]))


def practical_six_link() -> Arm:
    """Six-link arm of Practical 3, a2 = d2 = 0.5 m, d4 = d6 = 1 m.

    Source: IIT Jodhpur, Robotics, Practical 3, figure 1 (modified DH). d6 stands in no row of
    the table: it enters as the tool point (0, 0, d6) in frame 6. Home: the practical's own
    configuration q = (0, 90, -90, 0, 0, 0) degrees.

    Examples
    --------
    >>> practical_six_link().n
    6
    """
    links = [revolute(), revolute(alpha=RIGHT, d=-0.5), revolute(a=0.5),
             revolute(alpha=-RIGHT, d=1), revolute(alpha=RIGHT), revolute(alpha=-RIGHT)]
    return Arm(links, convention="modified", name="Practical 3 six-link", unit="m",
               tool=translation([0, 0, 1]), home=np.radians([0, 90, -90, 0, 0, 0]))


def cylindrical() -> Arm:
    """Cylindrical arm, one revolute and two prismatic joints.

    Source: DH convention lecture, worked example (standard DH). It leaves the lengths open;
    ours: d1 = 0.4 m, slides of 0.1 to 0.6 m. Home: q = (0, 0.3 m, 0.3 m).

    Examples
    --------
    >>> [link.kind for link in cylindrical().links]
    ['revolute', 'prismatic', 'prismatic']
    """
    links = [revolute(d=0.4, name="column"),
             prismatic(theta=RIGHT, alpha=RIGHT, limits=(0.1, 0.6), name="lift"),
             prismatic(limits=(0.1, 0.6), name="reach")]
    return Arm(links, name="Cylindrical", unit="m", home=[0, 0.3, 0.3])


def exam_2018() -> Arm:
    """The arm of the 2018 exam: two revolute joints and a prismatic one.

    Source: DH convention lecture, assignment (standard DH). It leaves the lengths open;
    ours: d1 = 0.5 m, L_off = 0.2 m, a2 = 0.4 m, slide of 0.2 to 0.8 m.
    Home: q = (0, 0, 0.4 m).

    Examples
    --------
    >>> exam_2018().links[1].d
    0.2
    """
    links = [revolute(d=0.5, alpha=RIGHT), revolute(theta=RIGHT, d=0.2, a=0.4, alpha=RIGHT),
             prismatic(theta=RIGHT, limits=(0.2, 0.8))]
    return Arm(links, name="2018 exam", unit="m", home=[0, 0, 0.4])


def alpha_ii() -> Arm:
    """Microbot Alpha II, five revolute joints, lengths in mm.

    Source: T. Asokan, Introduction to Robotics (IIT Madras), lecture 2.8 (standard DH). Its
    arm matrix was checked entry by entry. Soft home q = (0, 0, 0, -90, 0) degrees is from a
    secondary source; another one has d1 = 215.9 mm (8.5 in), the lecture's 215 mm stands.

    Examples
    --------
    >>> alpha_ii().links[4].d
    129.5
    """
    links = [revolute(d=215, alpha=-RIGHT, limits=between(-150, 150), name="base"),
             revolute(a=177.8, limits=between(-120, 120), name="shoulder"),
             revolute(a=177.8, limits=between(-135, 135), name="elbow"),
             revolute(alpha=-RIGHT, limits=between(-135, 135), name="tool pitch"),
             revolute(d=129.5, limits=between(-180, 180), name="tool roll")]
    return Arm(links, name="Alpha II", unit="mm", home=np.radians([0, 0, 0, -90, 0]))


def intelledex_660t() -> Arm:
    """Intelledex 660T, six revolute joints, lengths in mm.

    Source: the lecture (T. Asokan, lecture 2.8) sets its table as homework and prints none.
    Table and soft home q = (90, -90, 90, 0, 90, 0) degrees come from several public student
    codes that follow Schilling's textbook; a product-of-exponentials model of 1991 agrees.
    Schilling's printed page was not seen.

    Examples
    --------
    >>> intelledex_660t().links[0].d
    373.4
    """
    links = [revolute(d=373.4, alpha=RIGHT, name="base"),
             revolute(alpha=RIGHT, name="shoulder roll"),
             revolute(a=304.8, name="shoulder pitch"), revolute(a=304.8, name="elbow pitch"),
             revolute(alpha=RIGHT, name="tool pitch"), revolute(d=228.6, name="tool roll")]
    return Arm(links, name="Intelledex 660T", unit="mm", home=np.radians([90, -90, 90, 0, 90, 0]))

