"""The way out: an arm as URDF, which viewers, simulators and other libraries read."""
from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import chain, count
from xml.etree.ElementTree import Element, SubElement, indent, tostring

import numpy as np

from ..arms import inputs
from ..arms.arm import Arm, check_arm
from ..arms.joints import joint_range
from ..arms.link import PRISMATIC, Link
from ..arms.motions import ROTATE, Frame, Motion, follow, matrix, motions_of
from .robot import BOUNDLESS, CONTINUOUS

_METRES = {"m": 1.0, "dm": 0.1, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}
_NO_SIGN = re.compile("[\ufffe\uffff]")  # the two that a line of text may have and XML may not
_THIN = 0.03  # of the longest link: the radius of the tubes that viewers show


def to_urdf(arm: Arm) -> str:
    """A URDF that describes the arm: write it into a file with `Path("arm.urdf").write_text(...)`.

    Parameters
    ----------
    arm : Arm

    Returns
    -------
    str
        XML. Its root is "base_link" and its tip "tool0", and the tip's pose in the root is
        `forward_kinematics(arm, q)` for every q, in metres. Joints keep their names, limits and
        speeds; lengths in mm, cm, dm, in and ft become metres. A link is drawn as a tube.

    Raises
    ------
    ValueError
        If the arm's unit is none of these.

    See Also
    --------
    from_urdf : the way back.

    Notes
    -----
    What URDF has no word for is left out: the convention, the home, names of fixed rows, and
    accelerations. It asks for a speed and an effort of each joint. Where the arm has none,
    1000000 stands there, which `from_urdf` reads as none: simulators take 0 at its word, and the
    joint never moves. A prismatic joint must have limits in URDF: without any it gets those that
    its slider has.

    Examples
    --------
    >>> from kinlab import revolute
    >>> text = to_urdf(Arm([revolute(a=250, name="elbow")], name="One link", unit="mm"))
    >>> print(text[:94])
    <robot name="One link">
      <link name="base_link" />
      <joint name="elbow" type="continuous">
    """
    check_arm(arm)
    if arm.unit not in _METRES:
        raise ValueError(f"arm: expected lengths in {', '.join(_METRES)} to write them in metres, "
                         f"got the unit {inputs.brief(arm.unit)}; "
                         "make the arm again with its lengths in m")
    robot = Element("robot", name=_text(arm.name or "arm"))
    bodies = list(_bodies(arm))
    radius = _THIN * max(math.hypot(*body.way[:3, 3]) for body in bodies)
    link = SubElement(robot, "link", name="base_link")
    for body in bodies:
        _draw(link, body.way, radius)
        joint = SubElement(robot, "joint", name=body.joint, type=body.kind)
        SubElement(joint, "parent", link=link.get("name", ""))
        SubElement(joint, "child", link=body.child)
        SubElement(joint, "origin", _where(body.way))
        for tag, attributes in body.more.items():
            SubElement(joint, tag, attributes)
        link = SubElement(robot, "link", name=body.child)
    indent(robot)
    return tostring(robot, encoding="unicode") + "\n"


@dataclass(frozen=True)
class _Body:
    """A joint, the way to it from the joint before in metres, and the link that it moves.

    `more` has the attributes of what else there is: its axis and its limits.
    """

    way: np.ndarray
    joint: str
    child: str
    kind: str
    more: dict[str, dict[str, str]] = field(default_factory=dict)


def _bodies(arm: Arm) -> Iterator[_Body]:
    metres, way = _METRES[arm.unit], Frame()
    names = _own_names(arm)
    for motion in chain(*arm.chain):
        way = follow([_in_metres(replace(motion, joint=None), metres)], (), way)
        if motion.joint is not None:
            kind = _kind(arm.joints[motion.joint])
            more = {"axis": {"xyz": f"0 0 {motion.sign}"},
                    "limit": _limit(arm, motion.joint, kind, metres)}
            yield _Body(matrix(way), names[motion.joint], f"link_{motion.joint + 1}", kind, more)
            way = Frame()
    yield _Body(matrix(way), _free("to_tool", {*names}), "tool0", "fixed")


def _in_metres(motion: Motion, metres: float) -> Motion:
    return motion if motion.kind == ROTATE else replace(motion, amount=motion.amount * metres)


def _limit(arm: Arm, i: int, kind: str, metres: float) -> dict[str, str]:
    """The joint's limits, if it has any, and its speed."""
    scale = metres if kind == PRISMATIC else 1.0
    ends = {} if kind == CONTINUOUS else dict(zip(("lower", "upper"), joint_range(arm, i)))
    if speed := arm.joints[i].speed:
        ends["velocity"] = speed
    said = {name: value * scale for name, value in ends.items()}
    rates = {"effort": BOUNDLESS, "velocity": BOUNDLESS}
    return {name: _short(value) for name, value in (rates | said).items()}


def _kind(row: Link) -> str:
    return row.kind if row.kind == PRISMATIC or row.limits else CONTINUOUS


def _own_names(arm: Arm) -> list[str]:
    """A name for each joint, each only once."""
    names: list[str] = []
    for i, link in enumerate(arm.joints, start=1):
        names.append(_free(_text(link.name or f"joint_{i}"), {*names}))
    return names


def _free(name: str, taken: set[str]) -> str:
    others = (f"{name}_{k}" for k in count(2))
    return name if name not in taken else next(other for other in others if other not in taken)


def _text(name: str) -> str:
    return _NO_SIGN.sub("\ufffd", name)


def _where(T: np.ndarray) -> dict[str, str]:
    """xyz and rpy of a pose: they are its motions along x, y, z and about z, y, x."""
    moved, turned = [0.0] * 3, [0.0] * 3
    for motion in motions_of(T):
        (turned if motion.kind == ROTATE else moved)[motion.axis] = float(motion.amount)
    return {"xyz": _three(moved), "rpy": _three(turned)}


def _draw(link: Element, way: np.ndarray, radius: float) -> None:
    """A tube from the link's frame to the next joint."""
    x, y, z = way[:3, 3]
    length = math.hypot(x, y, z)
    if length <= radius:
        return
    visual = SubElement(link, "visual")
    SubElement(visual, "origin", xyz=_three([x / 2, y / 2, z / 2]),
               rpy=_three([0.0, math.atan2(math.hypot(x, y), z), math.atan2(y, x)]))
    SubElement(SubElement(visual, "geometry"), "cylinder", radius=f"{radius:.4g}",
               length=f"{length:.6g}")


def _three(values: list[float]) -> str:
    return " ".join(map(_short, values))


def _short(value: float) -> str:
    """All digits that tell, and no -0.0."""
    return f"{value + 0.0:.17g}" if float(f"{value:.15g}") != value else f"{value + 0.0:.15g}"
