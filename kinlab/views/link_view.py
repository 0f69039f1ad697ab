"""A link of an arm in stages, from the axes of its joints to its matrix."""
from __future__ import annotations

import re
from functools import partial
from typing import Any

from ..arms.arm import Arm
from ..arms.joints import first_pose
from ..drawing.controls import subscript
from ..drawing.frames_picture import frames_scene
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


def frames_view(arm: Arm, q: Any = None) -> LiveView:
    """All frames of an arm, and a button for each link that draws its four parameters.

    Below stands the matrix of the link that is chosen, or the product of all of them.

    Parameters
    ----------
    arm : Arm
        In either convention.
    q : array, shape (n,), optional
        Joint values to begin with (rad or length); the arm's home if left out.

    Returns
    -------
    LiveView
        Its knobs are the arm's joints and "link", 0 for none. Its reading "row" is the row of the
        table.

    Raises
    ------
    ValueError
        If `arm` is no arm, or `q` does not fit it.

    Examples
    --------
    >>> from kinlab import robots
    >>> view = frames_view(robots.cylindrical())
    >>> view["link"].value = 2
    >>> view.readings["row"]
    ('Row 2: θ₂ = 90°, d₂ = d₂*, a₂ = 0, α₂ = 90°',)
    """
    scene = frames_scene(arm, first_pose(arm, q))
    return LiveView(scene, formula="".join(map(partial(_of_link, arm), range(len(arm.links) + 1))))


def _of_link(arm: Arm, link: int) -> str:
    """The matrix of a link, or with 0 the one of all links, in HTML."""
    from ..arms.symbolic import closed_form

    last = len(arm.links)
    form = closed_form(arm, *((link - 1, link) if link else (0, last)), lengths="symbols")
    name = (f"A{subscript(link)}, frame {link} seen from frame {link - 1}" if link else
            f"{' '.join(f'A{subscript(row)}' for row in range(1, last + 1))}, "
            f"frame {last} seen from frame 0")
    return f'<div data-stages="{link}"><p>{name}</p>{formula_of(arm, form.latex)}</div>'


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
