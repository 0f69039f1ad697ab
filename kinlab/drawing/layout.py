"""Where the parts of an arm lie along its motions, and how large they are drawn."""
from __future__ import annotations

import numpy as np

from ..arms.arm import Arm
from ..arms.joints import joint_range, joint_ranges
from ..arms.kinematics import frame_poses, tool_poses
from ..arms.link import PRISMATIC
from ..arms.motions import Motion, Numbers, along, matrix

THICK = 0.082    # radius of a joint, as a part of the arm's at home
_CROWDED = 0.42  # of the usual way from joint to joint: thicker ones would touch
_SLIM = 0.25     # of its thickness: no joint is thinner than this
_FOLDED = 0.4    # of its reach: an arm that is smaller at home is drawn as if it were so large


class Layout:
    """The chain of an arm, its frames at home, and the size of what is drawn on it."""

    def __init__(self, arm: Arm, q: Numbers | None = None) -> None:
        self.arm, self.start = arm, arm.home if q is None else np.asarray(q)
        self.motions: list[Motion] = []
        self.joints = [0] * arm.n            # frame just before each joint moves
        self.ends = [self._walk(stretch) for stretch in arm.chain]
        self.poses = _poses_tried(arm)
        self.center, self.reach = _reach(arm, self.poses)
        self.home = self.frames(arm.home)
        self.middle, self.radius = self._ball()
        self.thick = THICK * self._slender()
        self.bodies = 0

    @property
    def last(self) -> int:
        """The frame of the tool."""
        return len(self.motions)

    def frames(self, q: Numbers) -> list[np.ndarray]:
        """The frames along the motions at joint values within their ranges."""
        values = np.clip(q, *joint_ranges(self.arm))
        return [matrix(frame) for frame in along(((), *((m,) for m in self.motions)), values)]

    def slides(self, i: int) -> bool:
        """Whether joint i (from 0) is prismatic."""
        return self.arm.joints[i].kind == PRISMATIC

    def range(self, i: int) -> tuple[float, float]:
        """How far joint i (from 0) stands along or about its axis, at the least and at the most."""
        motion, ends = self.motions[self.joints[i]], joint_range(self.arm, i)
        low, high = sorted(motion.amount + motion.sign * end for end in ends)
        return low, high

    def body(self) -> int:
        """A new number for things that stay together."""
        self.bodies += 1
        return self.bodies - 1

    def _walk(self, stretch: tuple[Motion, ...]) -> int:
        for motion in stretch:
            if motion.joint is not None:
                self.joints[motion.joint] = len(self.motions)
            if not motion.idle:
                self.motions.append(motion)
        return len(self.motions)

    def _ball(self) -> tuple[np.ndarray, float]:
        """Middle and radius of a ball round the arm at home, as it stands on the ground."""
        points = np.array([frame[:3, 3] for frame in self.home])
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        farthest = float(np.linalg.norm(points - middle, axis=1).max())
        return middle, max(farthest, _FOLDED * self.reach)

    def _slender(self) -> float:
        """The arm's radius, or less where its joints would touch each other."""
        places = np.array([self.home[k][:3, 3] for k in self.joints] + [self.home[-1][:3, 3]])
        ways = np.linalg.norm(np.diff(places, axis=0), axis=1)
        ways = ways[ways > 1e-3 * self.radius]
        # np.median would load numpy's masked arrays, a megabyte that nobody else needs.
        usual = float(np.quantile(ways, 0.5)) if len(ways) else self.radius
        return max(_SLIM * self.radius, min(self.radius, _CROWDED * usual / THICK))


def _poses_tried(arm: Arm) -> np.ndarray:
    """Poses all over the joint ranges; in half of them every slide is right in or right out."""
    low, high = joint_ranges(arm)
    slides = [i for i, link in enumerate(arm.joints) if link.kind == PRISMATIC]
    spread = np.random.default_rng(0).random((2000, arm.n))
    spread[::2, slides] = spread[::2, slides].round()
    return np.vstack([low + spread * (high - low), arm.home, np.clip(0, low, high)])


def _reach(arm: Arm, poses: np.ndarray) -> tuple[np.ndarray, float]:
    """Centre and radius of a sphere that holds the arm at every pose."""
    points = np.concatenate([frame_poses(arm, poses)[..., :3, 3].reshape(-1, 3),
                             tool_poses(arm, poses)[..., :3, 3], np.zeros((1, 3))])
    center = (points.min(axis=0) + points.max(axis=0)) / 2
    center[np.abs(center) < 0.05 * np.ptp(points)] = 0
    farthest = float(np.max(np.linalg.norm(points - center, axis=1)))
    return center, 1.17 * farthest or 1.0
