"""The hand of an arm: which way it points, how large it is, and the bars it is made of."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..arms.motions import TRANSLATE, Frame, follow, matrix
from .layout import Layout
from .vectors import unit

GRIP = 2.7        # how far a gripper of size 1 reaches
_SMALL = 0.8      # the size of one that stands beyond the tool
_NOTHING = 1e-6   # of the arm's size: a slide that nobody sees
_UPRIGHT = 0.9    # cosine: nearer than this to an axis counts as along it
_AXES = np.eye(3)


@dataclass(frozen=True)
class Hand:
    """A gripper in the tool frame: the way it points, where its fingers end on that way, its size.

    It ends at the tool, 0, unless there is no room for it before the tool.
    """

    way: np.ndarray
    end: float
    size: float

    @property
    def tip(self) -> np.ndarray:
        """Where the fingers end."""
        return self.end * self.way

    def bars(self) -> Iterator[tuple[str, np.ndarray]]:
        """A palm and two fingers that close across the way: name, and four corners of a box."""
        t, w = self.size, self.way
        v = _AXES[1] if abs(w[1]) < _UPRIGHT else _AXES[0]
        v = unit(v - (v @ w) * w)
        u = np.cross(v, w)

        def bar(a: np.ndarray, b: np.ndarray, one: np.ndarray, two: np.ndarray) -> np.ndarray:
            return self.tip + np.array([a, b, a + one, a + two])

        yield "gripper", bar(-2.4 * t * w - 1.15 * t * v, -2.4 * t * w + 1.15 * t * v,
                             0.42 * t * w, 0.5 * t * u)
        for name, side in (("left", -0.88), ("right", 0.88)):
            yield f"finger-{name}", bar(-1.98 * t * w + side * t * v, 0.1 * t * w + side * t * v,
                                        0.2 * t * v, 0.36 * t * u)


def free_hand(layout: Layout) -> Hand:
    """The hand of an arm whose tool has room about it."""
    return Hand(_approach(layout), 0.0, layout.thick)


def flanged_hand(layout: Layout, face: float, tool: float) -> Hand:
    """The hand on a flange whose face is so far along the last joint's axis, and the tool too.

    It is smaller where the tool is near, and stands beyond a tool that lies in the wrist.
    """
    axis = np.sign(face) * layout.home[-1][:3, :3].T @ layout.home[layout.joints[-1]][:3, 2]
    room = np.sign(face) * (tool - face)
    if room > 0.5 * layout.thick:
        return Hand(axis, 0.0, min(room / GRIP, layout.thick))
    size = _SMALL * layout.thick
    return Hand(axis, GRIP * size - room, size)


def _approach(layout: Layout) -> np.ndarray:
    """Direction of the last slide in the tool frame; z where a joint turns after it."""
    turned = max(k for k, motion in enumerate(layout.motions) if motion.joint is not None)
    slides = [k for k, m in enumerate(layout.motions) if m.kind == TRANSLATE and k >= turned
              and (m.joint is not None or abs(m.amount) > _NOTHING * layout.radius)]
    if not slides:
        return _AXES[2]
    last = layout.motions[slides[-1]]
    rest = matrix(follow(layout.motions[slides[-1] + 1:], (), Frame()))
    way = last.amount if last.joint is None else sum(layout.range(last.joint))
    return (-1 if way < 0 else 1) * rest[:3, :3].T @ _AXES[last.axis]
