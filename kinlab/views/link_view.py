"""A link of an arm in stages, from the axes of its joints to its matrix."""
from __future__ import annotations

import re
from typing import Any

from ..arms.arm import Arm
from ..arms.joints import first_pose
from ..drawing.controls import subscript
from ..drawing.stages_picture import GIVEN, StagesSketch, stages_sketch
from .arm_view import formula_of
from .live import LiveView

_BRACKETS = re.compile(r"\\(cos|sin)\{\\left\((\\\w+_\{\d+\}) \\right\)\}")


def link_view(arm: Arm, link: int, q: Any = None) -> LiveView:
    """A link in seven stages: axes of action, common normal, x axis, then the four motions.

    Each stage has a button; Back, Step and Play go through them. Two more buttons look along the
    z axis and the x axis about which the link is measured. Beside the picture grows the product of
    the motions that are done, in letters and in numbers.

    Parameters
    ----------
    arm : Arm
        In either convention.
    link : int
        1 to n.
    q : array, shape (n,), optional
        Joint values to begin with (rad or length); the arm's home if left out.

    Returns
    -------
    LiveView
        Its knobs are the arm's joints and "stage", 0 to 6. Its readings are "stage", the stage in
        words, and "theta", "d", "a" and "alpha".

    Raises
    ------
    ValueError
        If `arm` is no arm, has no such link, or `q` does not fit it.

    Examples
    --------
    >>> from kinlab import robots
    >>> view = link_view(robots.exam_2018(), 2)
    >>> view["stage"].value = 3
    >>> view.readings["stage"]
    ('4. Turn about z₁ by θ₂, until x is parallel to x₂.',)
    """
    sketch = stages_sketch(arm, link, first_pose(arm, q))
    return LiveView(sketch.scene(), formula=_growing(sketch))


def _growing(sketch: StagesSketch) -> str:
    """The product so far, a part for each number of motions done, in HTML."""
    from ..arms.growing import growing_product  # sympy takes a while

    forms = growing_product(sketch.arm, sketch.link, [sketch.symbol_of(k) for k in range(4)])
    return "".join(_so_far(sketch, done, form.latex) for done, form in enumerate(forms))


def _so_far(sketch: StagesSketch, done: int, latex: str) -> str:
    """The product of the motions that are done, as factors and as a matrix."""
    name = f"A{subscript(sketch.link)}{' so far' if done < 4 else ''}"
    factors = " · ".join(map(sketch.factor, range(done))) or "1, nothing has moved"
    stages = " ".join(map(str, range(GIVEN))) if done == 0 else str(done + GIVEN - 1)
    matrix = formula_of(sketch.arm, _BRACKETS.sub(r"\\\1 \2", latex))
    return f'<div data-stages="{stages}"><p>{name} = {factors}</p>{matrix}</div>'
