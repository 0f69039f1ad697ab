"""The picture at one pose, as marks on paper: what is painted where, from the back to the front.

kinlab/browser/picture.js does the same at every step of a drag. Here nothing moves: names are
placed once, and layers that are switched off are left out.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from .camera import Camera
from .paints import Paint
from .scene import Item
from .solids import Across, Round

_PAPER = Camera(-90.0, 90.0)    # x to the right, y up
_AXIS = (0.075, 30.0, 54.0)     # length of an arrow: of the smaller side; at least; at most (px)
_PER_SHARED = 0.36              # longer for each frame at the same origin
_SKIN = 1.04                    # where an arrow begins, in radii of the solid that it comes out of
_HEAD = 9.0                     # px: of an arrow
_LEAST_CUT = 0.02               # of a tube: shorter ends are not cut off at the floor
_TOUCH = 0.05                   # of a joint's radius: what is sunk by less lies on the floor


@dataclass(frozen=True)
class Mark:
    """One path, or words, in px. With a gradient, `fill` holds a colour for each of its levels."""

    points: np.ndarray
    paint: Paint
    closed: bool = False
    light: Across | Round | None = None
    fill: Sequence[str] = ()
    text: str = ""
    faint: float = 1.0


@dataclass(frozen=True)
class Drawn:
    """All marks of one item, under its name."""

    gid: str
    marks: list[Mark] = field(default_factory=list)
    item: Item | None = None
