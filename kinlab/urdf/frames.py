"""Which frames of an arm's table are not those of the file's links."""
from __future__ import annotations

import math
from dataclasses import dataclass
from html import escape

import numpy as np

from ..arms import printed
from ..arms.arm import Arm
from ..arms.kinematics import link_frames
from ..arms.quaternions import axis_angle
from ..arms.transforms import inverse
from .chain import Chain
from .table import arm_of, tidy

_SAME = 1e-9


@dataclass(frozen=True, eq=False)
class LinkFrame:
    """A link frame of a URDF, seen from the arm's frame on the same link.

    Attributes
    ----------
    link : str
        The link's name in the file.
    frame : int
        The number of the arm's frame that moves with this link.
    T : array, shape (4, 4)
        Pose of the file's frame in the arm's; it is the same for every q.
    """

    link: str
    frame: int
    T: np.ndarray

    @property
    def same(self) -> bool:
        """Whether the two frames are one."""
        return bool(np.allclose(self.T, np.eye(4), rtol=0, atol=_SAME))

    @property
    def moved(self) -> str:
        """Where the file's origin is in the arm's frame; "" where it is the arm's."""
        o = self.T[:3, 3]
        return _point(o) if np.abs(o).max() > _SAME else ""

    @property
    def turned(self) -> str:
        """The turn from the arm's frame to the file's; "" where there is none."""
        axis, angle = axis_angle(self.T[:3, :3])
        if angle <= _SAME:
            return ""
        k = int(np.abs(axis).argmax())
        plain = abs(axis[k]) > 1 - _SAME
        return (f"{math.degrees(angle):.6g}° about "
                + ("-" * bool(axis[k] < 0) + "xyz"[k] if plain else _point(axis)))


@dataclass(frozen=True, eq=False)
class UrdfFrames:
    """What became of a URDF's link frames.

    Attributes
    ----------
    arm : Arm
        The arm, as `from_urdf` returns it.
    why : str
        Why its table has this convention.
    links : tuple of LinkFrame
        A record for each link from the root to the tip.
    """

    arm: Arm
    why: str
    links: tuple[LinkFrame, ...]

    @property
    def differ(self) -> tuple[LinkFrame, ...]:
        """The links whose frame in the file is another one."""
        return tuple(link for link in self.links if not link.same)

    def __repr__(self) -> str:
        lines = printed.lines(self._rows(), words=0)
        return "\n".join([self._title(), *(line.rstrip() for line in lines)])

    def _repr_html_(self) -> str:
        rows = [[escape(cell) for cell in row] for row in self._rows()]
        return printed.html(rows, '<table><caption style="text-align: left">'
                            f"{escape(self._title())}</caption>")

    def _title(self) -> str:
        return f"{self.arm.name or 'Arm'} in {self.arm.convention} DH: {self.why}."

    def _rows(self) -> list[list[str]]:
        heads = ["link", "frame", f"moved by ({self.arm.unit})", "turned by"]
        return [heads, *([link.link, str(link.frame), *(["the same", ""] if link.same
                                                        else [link.moved, link.turned])]
                         for link in self.links)]


def frames_of(chain: Chain) -> UrdfFrames:
    """The arm of a chain, and how its frames stand to those of the chain's links."""
    arm, why = arm_of(chain)
    frames, rows = link_frames(arm, np.zeros(arm.n)), [0, *(row + 1 for row in arm.rows)]
    links = (LinkFrame(link, rows[body], tidy(inverse(frames[rows[body]]) @ pose, 1.0))
             for link, body, pose in zip(chain.links, chain.ridden(), chain.poses))
    return UrdfFrames(arm, why, tuple(links))


def _point(values: np.ndarray) -> str:
    return f"({', '.join(f'{value:.6g}' for value in np.round(values, 9) + 0.0)})"
