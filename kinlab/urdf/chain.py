"""The way from the root of a robot to its tip, joint by joint."""
from __future__ import annotations

from dataclasses import dataclass
from difflib import get_close_matches
from itertools import accumulate

import numpy as np

from ..arms import inputs
from .robot import SLIDES, TURNS, Joint, Robot, listed

MOVING = (*TURNS, *SLIDES)


@dataclass(frozen=True)
class Chain:
    """The joints from root to tip, and where the links' frames are at q = 0.

    Attributes
    ----------
    links : tuple of str
        Names, from the root to the tip: one more than joints.
    poses : array, shape (len(links), 4, 4)
        Poses of the links' frames in the root's, at q = 0.
    """

    robot: Robot
    joints: tuple[Joint, ...]
    links: tuple[str, ...]
    poses: np.ndarray

    @property
    def moving(self) -> list[int]:
        """Places in `joints` of those that move."""
        return [k for k, joint in enumerate(self.joints) if joint.kind in MOVING]

    def ridden(self) -> list[int]:
        """How many joints carry each link: the number of the body that its frame is fixed to."""
        return list(accumulate((joint.kind in MOVING for joint in self.joints), initial=0))


def chain_of(robot: Robot, tip: str | None) -> Chain:
    """The chain to a link by its name; to the only end there is, if it is None."""
    above = _parents(robot)
    root = _root(robot, above)
    end = _tip(robot, above, tip)
    joints = _way(above, end)
    for joint in joints:
        _serial(joint)
    if not any(joint.kind in MOVING for joint in joints):
        raise ValueError("URDF: expected a joint that moves between root and tip, got "
                         f"{_still(root, end)}; "
                         + ("name another tip" if tip else "give a robot whose joints move"))
    poses = [np.eye(4)]
    for joint in joints:
        poses.append(poses[-1] @ joint.origin())
    return Chain(robot, joints, (root, *(joint.child for joint in joints)), np.array(poses))


def _parents(robot: Robot) -> dict[str, Joint]:
    """The joint above each link that has one."""
    above: dict[str, Joint] = {}
    for joint in robot.joints:
        if joint.child in above:
            other, child = above[joint.child].name, inputs.brief(joint.child)
            raise ValueError("URDF: expected one joint above each link, got "
                             f"{inputs.brief(joint.name)} and {inputs.brief(other)} above {child}; "
                             "a closed loop is no serial arm")
        above[joint.child] = joint
    return above


def _root(robot: Robot, above: dict[str, Joint]) -> str:
    roots = [link for link in robot.links if link not in above]
    if len(roots) == 1:
        _all_tied(robot, roots[0])
        return roots[0]
    raise ValueError("URDF: expected one root, a link that is no joint's child, got "
                     + (f"{len(roots)}: {listed(roots)}; tie them together with fixed joints"
                        if roots else "none; " + ("the joints go in a circle" if robot.links
                                                  else "write a <link> for each body")))


def _all_tied(robot: Robot, root: str) -> None:
    """Refuse links that no joints tie to the root: theirs go in a circle."""
    under: dict[str, list[str]] = {link: [] for link in robot.links}
    for joint in robot.joints:
        under[joint.parent].append(joint.child)
    tied, new = {root}, [root]
    while new:
        new = [child for link in new for child in under[link]]
        tied.update(new)
    if loose := [link for link in robot.links if link not in tied]:
        raise ValueError(f"URDF: expected joints from {inputs.brief(root)} to every link, got "
                         f"joints in a circle: {listed(loose)}; look at their parents")


def _tip(robot: Robot, above: dict[str, Joint], tip: str | None) -> str:
    if tip is not None:
        if not isinstance(tip, str) or tip not in robot.links:
            nearest = get_close_matches(str(tip), robot.links, len(robot.links), 0)
            raise ValueError(f"tip: expected the name of a link, got {inputs.brief(tip)}; "
                             f"there are {listed(nearest)}")
        return tip
    parents = {joint.parent for joint in robot.joints}
    moved = {link: _moves(link, above) for link in robot.links if link not in parents}
    ends = [link for link, moves in moved.items() if moves]
    if len(ends) > 1:
        longest = inputs.brief(max(ends, key=lambda link: moved[link]))
        raise ValueError(f"tip: expected one end of the arm, got {len(ends)}: {listed(ends)}; "
                         f"choose one, or a link before it: kl.from_urdf(..., tip={longest})")
    return ends[0] if ends else robot.links[-1]


def _moves(link: str, above: dict[str, Joint]) -> int:
    """How many joints above the link move."""
    return sum(joint.kind != "fixed" for joint in _way(above, link))


def _way(above: dict[str, Joint], tip: str) -> tuple[Joint, ...]:
    """The joints above a link, from the root."""
    joints: list[Joint] = []
    while tip in above:
        joints.append(above[tip])
        tip = above[tip].parent
    return tuple(reversed(joints))


def _still(root: str, tip: str) -> str:
    """Why nothing moves a tip."""
    if tip == root:
        return f"a tip, {inputs.brief(tip)}, that is the root itself"
    return f"only fixed ones between {inputs.brief(root)} and {inputs.brief(tip)}"


def _serial(joint: Joint) -> None:
    """Refuse a joint that is none of a serial arm's."""
    if joint.kind in ("floating", "planar"):
        raise ValueError(f"{joint.what}: expected a joint that turns or slides, got a "
                         f"{joint.kind} one; choose a tip before it, or make it fixed")
    if joint.element.find("mimic") is not None:
        raise ValueError(f"{joint.what}: expected a joint with a value of its own, got one that "
                         "follows another (<mimic>); choose a tip before it")
