"""Studies of an arm: what its joints do to the tool, how a link is measured, how a solve goes."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..arms import inputs
from ..arms.arm import Arm, check_arm
from ..arms.joints import first_pose
from ..arms.kinematics import is_planar
from ..drawing.link_picture import parameters_scene
from ..drawing.solve_picture import solve_scene
from ..drawing.velocity_picture import velocity_scene
from ..ik.descent import METHODS
from ..ik.solve import inverse_kinematics
from .live import LiveView


def velocity_view(arm: Arm, q: Any = None) -> LiveView:
    """The columns of the Jacobian as arrows at the tool, and the velocity ellipse round it.

    Column i is the velocity of the tool point while joint i alone moves: at 1 rad/s if it turns,
    at one reach of the arm per second if it slides. The ellipse (in space an ellipsoid) holds the
    velocities of all joint rates whose squares add up to at most 1. The arrows show 0.3 s.

    Parameters
    ----------
    arm : Arm
    q : array, shape (n,), optional
        Joint values to begin with (rad or length); the arm's home if left out.

    Returns
    -------
    LiveView
        Its knobs are the arm's joints, its readings the columns "J1", "J2", ... (length per rad,
        or without unit), and "w", the manipulability, for a planar arm.

    Raises
    ------
    ValueError
        If an argument does not fit the arm.

    Examples
    --------
    >>> from kinlab import robots
    >>> view = velocity_view(robots.two_link(), q=[0, np.pi / 2])
    >>> view.readings["J2"][0].round(3) + 0.0
    array([-1.,  0.])
    >>> view.readings["w"][0].round(3)
    array([1.])
    """
    return LiveView(velocity_scene(arm, first_pose(arm, q)))


def parameters_view(arm: Arm, link: int, q: Any = None) -> LiveView:
    """The four DH parameters of a link, drawn on the arm and moving with it.

    Angles are arcs, lengths are dimension lines; other links are pale. Beside the picture stand the
    matrix from frame i-1 to frame i and how each parameter is measured; what is zero for ever is
    not drawn.

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
        Its knobs are the arm's joints, its readings "theta", "d", "a" and "alpha".

    Raises
    ------
    ValueError
        If `arm` is no arm, has no such link, or `q` does not fit it.

    Examples
    --------
    >>> from kinlab import robots
    >>> view = parameters_view(robots.alpha_ii(), 2)
    >>> view["theta_2"].value = 40
    >>> view.readings["theta"]
    (array([40.]),)
    """
    return LiveView(parameters_scene(arm, link, first_pose(arm, q)))


def solve_view(arm: Arm, target: Any, q0: Any = None, *, weights: Any = None,
               methods: Sequence[str] = ("newton", "damped"), steps: int = 20,
               limits: str = "keep") -> LiveView:
    """Two methods on the way from one start to one target: scrub through their steps.

    The picture shows the arms at the step, with the way of the tool so far; the chart beside it the
    error of each step so far, in powers of ten. Errors are in the arm's unit; for
    a whole pose a turn counts as the way that it makes at the arm's reach. Each method begins at
    `q0` and is not started again.

    Parameters
    ----------
    arm : Arm
    target : array, shape (4, 4) or (3,)
        Pose of the tool in the room, or the tool point alone.
    q0 : array, shape (n,), optional
        Where to begin; the arm's home if left out.
    weights : six numbers, or three for a point, optional
        As in `inverse_kinematics`. For a point and a planar arm, 1, 1, 0.
    methods : two of {"newton", "damped", "pseudoinverse", "transpose"}
    steps : int
        At most so many.
    limits : {"keep", "ignore"}
        Whether joint limits hold.

    Returns
    -------
    LiveView
        Its knob is "step", its readings are named by the methods: the errors at this step.

    Raises
    ------
    ValueError
        If an argument does not fit.

    Examples
    --------
    >>> from kinlab import robots
    >>> view = solve_view(robots.two_link(), [0.5, 1, 0], q0=[0.2, 0.4])
    >>> view["step"].value = 3
    >>> [reading[0] for reading in view.readings.values()]
    ['0.153', '0.000701']
    """
    check_arm(arm)
    methods = _two(methods)
    if weights is None and is_planar(arm) and np.shape(target) == (3,):
        weights = (1, 1, 0)
    trails = {method: inverse_kinematics(arm, target, q0, method=method, weights=weights,
                                         steps=steps, restarts=0, limits=limits).history
              for method in methods}
    target = np.asarray(target, dtype=float)
    return LiveView(solve_scene(arm, target[:3, 3] if target.ndim == 2 else target, trails))


def _two(methods: Any) -> tuple[str, str]:
    pair = tuple(methods) if isinstance(methods, (list, tuple)) else (methods,)
    if len(pair) != 2 or pair[0] == pair[1]:
        raise ValueError(f"methods: expected two different ones, got {inputs.brief(methods)}; "
                         f"choose from {', '.join(METHODS)}")
    first, second = (inputs.choice("methods", method, tuple(METHODS)) for method in pair)
    return first, second
