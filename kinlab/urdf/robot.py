"""What a URDF says of its joints, checked and in numbers."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any
from xml.etree.ElementTree import Element

import numpy as np

from ..arms import inputs
from .document import root_of
from .numbers import XACRO, axis, number, pose, turns

CONTINUOUS = "continuous"
TURNS = ("revolute", CONTINUOUS)
SLIDES = ("prismatic",)
BOUNDLESS = 1e6  # rad/s, m/s, N or Nm, where an arm has no such bound: no joint comes near
_KINDS = (*TURNS, *SLIDES, "fixed", "floating", "planar")
_OTHER = {"sdf": "which is SDF, of Gazebo; convert it, or look for the robot's .urdf",
          "mujoco": "which is MJCF, of MuJoCo; look for the robot's .urdf"}


@dataclass(frozen=True)
class Joint:
    """A joint between two links, as the file has it.

    Attributes
    ----------
    kind : str
        The URDF's type: revolute, continuous, prismatic, fixed, floating or planar.
    parent, child : str
        Names of links.
    element : Element
        Where its other numbers stand: they are read if the joint is on the way to the tip.
    """

    name: str
    kind: str
    parent: str
    child: str
    element: Element

    @property
    def what(self) -> str:
        """The joint in a sentence."""
        return f"joint {inputs.brief(self.name)}"

    def origin(self) -> np.ndarray:
        """Pose of the joint, and of its child at q = 0, in the parent: shape (4, 4)."""
        return pose(self.what, self.element.find("origin"))

    def rpy(self) -> np.ndarray:
        """Roll, pitch and yaw of the joint in the parent, as the file has them: shape (3,)."""
        return turns(self.what, self.element.find("origin"))

    def axis(self) -> np.ndarray:
        """Unit vector of the joint's axis, in the child's frame: shape (3,)."""
        return axis(self.what, self.element.find("axis"))

    def limits(self) -> tuple[float, float] | None:
        """Lowest and highest value; None where the joint has none."""
        limit = self.element.find("limit")
        if self.kind == CONTINUOUS or limit is None:
            return None
        low, high = (number(f"{self.what}, {end}", limit.get(end, "0"))
                     for end in ("lower", "upper"))
        if low > high:
            raise ValueError(f"{self.what}: expected lower up to upper, got lower {low:g} and "
                             f"upper {high:g}; exchange them")
        if self.kind in TURNS:
            inputs.in_radians(f"{self.what}, limits", (low, high))
        return low, high

    def speed(self) -> float | None:
        """The largest rate; None where the file has none, or 0, or one beyond all joints."""
        limit = self.element.find("limit")
        rate = 0.0 if limit is None else number(f"{self.what}, velocity",
                                                limit.get("velocity", "0"))
        if rate < 0:
            raise ValueError(f"{self.what}: expected a velocity above zero, got {rate:g}; "
                             "take away the minus")
        return rate if 0 < rate < BOUNDLESS else None


@dataclass(frozen=True)
class Robot:
    """Names of all links, and all joints, of a file whose XML is a robot's."""

    name: str
    links: tuple[str, ...]
    joints: tuple[Joint, ...]


def robot_of(source: Any) -> Robot:
    """The robot in a file, or in the text of one."""
    root = root_of(source)
    if root.tag != "robot":
        hint = _OTHER.get(root.tag, "which is another kind of XML; give a URDF")
        raise ValueError("path_or_text: expected a <robot> as the outermost element, "
                         f"got <{inputs.brief(root.tag)[1:-1]}>, {hint}")
    if found := next((element.tag for element in root.iter() if element.tag[:6] == "xacro:"), ""):
        raise ValueError(f"URDF: expected links and joints, got <{inputs.brief(found)[1:-1]}>; "
                         f"{XACRO}")
    links = tuple(_named("link", element) for element in root.findall("link"))
    joints = tuple(_joint(element, set(links)) for element in root.findall("joint"))
    _once("link", links)
    _once("joint", tuple(joint.name for joint in joints))
    return Robot(inputs.line("name", root.get("name", "")), links, joints)


def listed(names: Sequence, most: int = 12, show: Callable[[Any], str] = inputs.brief) -> str:
    """Names in a sentence, and how many more there are."""
    more = [f"and {len(names) - most} more"] if len(names) > most else []
    return ", ".join([*map(show, names[:most]), *more])


def _named(kind: str, element: Element) -> str:
    if not (name := element.get("name", "")):
        raise ValueError(f'URDF: expected a name for each {kind}, got a {kind} without one; '
                         f'write <{kind} name="...">')
    return inputs.line(f"{kind} name", name)


def _once(kind: str, names: tuple[str, ...]) -> None:
    seen: set[str] = set()
    for name in names:
        if name in seen:
            raise ValueError(f"URDF: expected each {kind} once, got two of name "
                             f"{inputs.brief(name)}; give one of them another name")
        seen.add(name)


def _joint(element: Element, links: set[str]) -> Joint:
    name = _named("joint", element)
    kind = element.get("type", "")
    if kind not in _KINDS:
        raise ValueError(f"joint {inputs.brief(name)}: expected one of the types "
                         f"{listed(_KINDS)}, got {inputs.brief(kind)}; URDF has no other")
    parent, child = (_end(name, element, end, links) for end in ("parent", "child"))
    return Joint(name, kind, parent, child, element)


def _end(joint: str, element: Element, end: str, links: set[str]) -> str:
    found = element.find(end)
    link = "" if found is None else found.get("link", "")
    if not link:
        raise ValueError(f"joint {inputs.brief(joint)}: expected a {end}, got none; "
                         f'write <{end} link="..."/>')
    if link not in links:
        raise ValueError(f"joint {inputs.brief(joint)}: expected a link of this file as its {end}, "
                         f"got {inputs.brief(link)}; there are {listed(sorted(links)) or 'none'}")
    return link
