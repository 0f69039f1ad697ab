"""A link's matrix as it grows, motion by motion, in the letters of its table."""
from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from .arm import Arm
from .motions import Motion, follow, keep_whole, matrix
from .symbolic import ClosedForm


def growing_product(arm: Arm, link: int, names: Sequence[str]) -> list[ClosedForm]:
    """The matrix after none, one, ... and all four motions of a link.

    `names` are those of its parameters in the order of the motions; one that is zero for ever
    leaves no letter.

    >>> from kinlab import robots
    >>> growing_product(robots.two_link(), 2, ["alpha_1", "a_1", "theta_2", "d_2"])[3]
    [C2, -S2, 0, a1]
    [S2, C2 , 0, 0]
    [0 , 0  , 1, 0]
    [0 , 0  , 0, 1]
    """
    motions = [Motion(motion.kind, motion.axis, 0 if motion.idle else sp.Symbol(name))
               for motion, name in zip(arm.chain[link], names)]
    angles = tuple(sp.Symbol(f"theta_{k}") for k in range(1, len(arm.links) + 1))
    frames = (matrix(follow(motions[:done], ())).astype(object) for done in range(5))
    return [ClosedForm(sp.Matrix(keep_whole(frame)[0]), angles, {}) for frame in frames]
