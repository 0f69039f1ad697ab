"""The public way in: a robot's URDF as an arm, with a word about what is not as in the file."""
from __future__ import annotations

import os

from ..arms import inputs
from ..arms.arm import Arm
from .chain import chain_of
from .frames import UrdfFrames, frames_of
from .remarks import remarks
from .robot import robot_of


def from_urdf(path_or_text: str | os.PathLike | bytes, tip: str | None = None) -> Arm:
    """The arm that a URDF file describes, with a Denavit-Hartenberg table found for it.

    Parameters
    ----------
    path_or_text : str, path or bytes
        The name of a URDF file, or what stands in it.
    tip : str, optional
        The link that is the tool. A robot with one end needs none; where it has branches, fingers
        or cameras, the error says which ends there are.

    Returns
    -------
    Arm
        In metres and radians, its base the file's root. `forward_kinematics(arm, q)` is the pose of
        the tip in the root as the file has it, with the same q: to 1e-9 in each entry, and in an
        arm of more than 1 m to 1e-9 of its length. It has the file's names, limits and speeds; its
        home is 0, or the limit that is nearest to 0.

    Raises
    ------
    ValueError
        If the file cannot be read, is no robot, has no way to the tip, or has a joint on it that
        no serial arm has (floating, planar, mimic).

    See Also
    --------
    urdf_frames : which link frames are other ones than the file's.
    to_urdf : the way back.

    Notes
    -----
    Rows come from the common normals of the joints' axes (Spong, Hutchinson and Vidyasagar, section
    3.2). Fixed joints are part of the links. The convention is the one that leaves less over for
    the matrices of base and tool; if both fit alike, modified where the frames are the file's
    own, else standard. A joint whose axis points against the one before it is flipped. Axes that
    are almost parallel have their common normal far away: a fixed row tilts them instead. A file
    that has 1.5708 for pi/2 may have such axes; a note says so, and which rows are not exact.

    A file that declares a document type or an entity is refused, and nothing that it names is
    opened.

    Examples
    --------
    >>> arm = from_urdf('''<robot name="Crane"> <link name="floor"/> <link name="post"/>
    ...   <link name="hook"/>
    ...   <joint name="turn" type="continuous"> <parent link="floor"/> <child link="post"/>
    ...     <origin xyz="0 0 0.5"/> <axis xyz="0 0 1"/> </joint>
    ...   <joint name="reach" type="prismatic"> <parent link="post"/> <child link="hook"/>
    ...     <origin rpy="0 1.5707963267948966 0"/> <axis xyz="0 0 1"/>
    ...     <limit lower="0.4" upper="1"/> </joint> </robot>''')
    >>> arm
    Crane: standard DH, lengths in m, * marks the joint variable
    i          θ    d  a    α
    1  θ1* + 90°  0.5  0  90°
    2       -90°  d2*  0   0°
    >>> arm.home
    array([0. , 0.4])
    """
    chain = chain_of(robot_of(path_or_text), tip)
    frames = frames_of(chain)
    for remark in remarks(chain, frames):
        inputs.note(f"from_urdf: {remark}")
    return frames.arm


def urdf_frames(path_or_text: str | os.PathLike | bytes, tip: str | None = None) -> UrdfFrames:
    """Which frames of `from_urdf`'s arm differ from the link frames of the file.

    A URDF puts a link's frame on the joint that moves it, turned in any way. A DH table has rules
    for its frames, so most of them stand elsewhere on the same link.

    Parameters
    ----------
    path_or_text, tip
        As in `from_urdf`.

    Returns
    -------
    UrdfFrames
        It prints a line for each link: where the file's frame is and how it is turned, seen from
        the arm's frame.

    Raises
    ------
    ValueError
        As `from_urdf`.

    Examples
    --------
    >>> urdf_frames('''<robot name="Arm"> <link name="base"/> <link name="upper arm"/>
    ...   <joint name="shoulder" type="continuous"> <parent link="base"/> <child link="upper arm"/>
    ...     <axis xyz="0 0 1"/> </joint>
    ...   <link name="tool"/> <joint name="end" type="fixed"> <parent link="upper arm"/>
    ...     <child link="tool"/> <origin xyz="0.3 0 0"/> </joint> </robot>''')
    Arm in standard DH: modified would need a matrix for the tool, too.
    link       frame  moved by (m)  turned by
    base           0      the same
    upper arm      1  (-0.3, 0, 0)
    tool           1      the same
    """
    return frames_of(chain_of(robot_of(path_or_text), tip))
