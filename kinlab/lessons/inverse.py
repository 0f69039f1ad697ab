"""Lesson 10, inverse kinematics: the judges of its exercises."""
from __future__ import annotations

from collections.abc import Callable
from math import degrees
from typing import Any

import numpy as np

from ..answers.conditions import degrees_slip, one_of_many, one_pose, straight_down, within_limits
from ..answers.judges import Judge, choices, function
from ..arms import inputs, kinematics, robots

_TWO, _ALPHA_II = robots.two_link(), robots.alpha_ii()


def _tool(q: np.ndarray) -> np.ndarray:
    return kinematics.forward_kinematics(_TWO, q)[:2, 3]


def _jacobian(q: np.ndarray) -> np.ndarray:
    return kinematics.jacobian(_TWO, q)[:2]


# ---- Exercise 1: Newton's method --------------------------------------------------------


def _newton(step: Callable, fresh: bool = True) -> Callable:
    """A loop that takes a step (J, e) each time, with J taken afresh or once and for all."""
    def run(q: np.ndarray, target: np.ndarray, steps: int) -> np.ndarray:
        q, first = np.array(q, dtype=float), _jacobian(q)
        for _ in range(steps):
            q = q + step(_jacobian(q) if fresh else first, np.array(target) - _tool(q))
        return q
    return run


_SOLVED = _newton(np.linalg.solve)

_NEWTON_CASES = [{"q": np.array(q), "target": np.array(target), "steps": steps}
                 for q, target, steps in (([0.2, 0.8], [0.9, 1.2], 1),
                                          ([1.0, -1.2], [1.2, -0.3], 2),
                                          ([0.5, 1.2], [0.2, 1.1], 3))]

_NEWTON_SLIPS = [
    ("The error is taken the wrong way round: target minus tool.",
     _newton(lambda J, e: -np.linalg.solve(J, e))),
    ("This multiplies by the transpose of J; Newton's method takes its inverse.",
     _newton(lambda J, e: J.T @ e)),
    ("J is multiplied, not its inverse: solve J step = error.", _newton(lambda J, e: J @ e)),
    ("The error stands on the wrong side of the inverse: the step is inv(J) @ error.",
     _newton(lambda J, e: np.linalg.solve(J.T, e))),
    ("J is computed once. The arm moves: take J afresh in each step.",
     _newton(np.linalg.solve, fresh=False)),
    ("Only one step is taken, whatever `steps` says.",
     lambda q, target, steps: _SOLVED(q, target, 1)),
    ("The step is added in degrees; q is in radians.",
     _newton(lambda J, e: np.degrees(np.linalg.solve(J, e)))),
    ("This is the sum of the steps. Add them to the q that you were given.",
     lambda q, target, steps: _SOLVED(q, target, steps) - q),
]

# ---- Exercise 2: a damped step ----------------------------------------------------------


def _damped(J: np.ndarray, e: np.ndarray, damping: float) -> np.ndarray:
    return J.T @ np.linalg.solve(J @ J.T + damping**2 * np.eye(len(e)), e)


_DAMPED_CASES = [
    {"J": np.array([[0.0, 0.0], [2.0, 1.0]]), "e": np.array([-0.5, 1.0]), "damping": 0.3},
    {"J": np.array([[-1.0, -0.5], [1.5, 0.9]]), "e": np.array([0.2, 0.1]), "damping": 0.1},
    {"J": np.array([[1.0, 0.5, 0.2], [0.0, 1.0, 0.4]]), "e": np.array([0.3, -0.2]), "damping": 0.5},
]

_DAMPED_SLIPS = [
    ("The damping enters as its square.", lambda J, e, damping: _damped(J, e, damping**0.5)),
    ("There is no damping in it: this is the pseudoinverse.",
     lambda J, e, damping: np.linalg.pinv(J) @ e),
    ("This is the transpose method: the bracket is missing.", lambda J, e, damping: J.T @ e),
    ("The transpose in front of the bracket is missing.",
     lambda J, e, damping: np.linalg.solve(J @ J.T + damping**2 * np.eye(len(e)), e)),
    ("The sign is wrong: the step leads away from the target.",
     lambda J, e, damping: -_damped(J, e, damping)),
    ("The damping is added to every entry; it belongs on the diagonal, so take np.eye.",
     lambda J, e, damping: J.T @ np.linalg.pinv(J @ J.T + damping**2) @ e),
]

# ---- Exercise 3: which joints move the tip of the stretched Alpha II ----------------------

_MOVERS = {"x": set(), "y": {1}, "z": {2, 3, 4}}

_MOVER_HINTS = {
    **{("x", joint): "The arm is stretched along x: every velocity is perpendicular to the line "
       "from the joint's axis to the tip." for joint in (1, 2, 3, 4)},
    ("x", 5): "The tip lies on the axis of joint 5.",
    ("y", 1): "Joint 1 turns about the vertical, and the tip is straight ahead.",
    ("y", 5): "The tip lies on the axis of joint 5.",
    ("z", 5): "The tip lies on the axis of joint 5.",
    ("z", 1): "Joint 1 turns about the vertical: can that lift the tip?",
    ("z", 2): "The shoulder turns about a level axis: what does that do to the tip?",
    ("z", 3): "The elbow's axis is parallel to the shoulder's.",
    ("z", 4): "The tool has a length: the tip is 129.5 mm from the axis of joint 4.",
}

# ---- Exercise 4: two ways to one point ----------------------------------------------------

POINT = np.array([1.2, 0.9])


def _pair(answer: Any) -> np.ndarray:
    return inputs.shaped("both", answer, (2, 2), "two rows of two joint values")


def _both_reach(pair: np.ndarray) -> str:
    for row, q in zip(("first", "second"), pair):
        miss = float(np.linalg.norm(_tool(q) - POINT))
        if miss > 1e-3:
            return f"With the {row} joint values the tool misses the point by {miss:.3g} m."
    return ""


def _on_both_sides(pair: np.ndarray) -> str:
    one, two = np.sin(pair[:, 1])
    return "" if one * two < 0 else ("Both reach the point, but with the elbow on the same side: "
                                     "the second should bend the other way.")


def _other_elbow(pair: np.ndarray) -> bool:
    return np.isclose(pair[0, 0], pair[1, 0]) and np.isclose(pair[0, 1], -pair[1, 1])


_PAIR_SLIPS = [
    degrees_slip((_both_reach,), subject="These", hint="write np.radians([...])"),
    ("Bending the elbow the other way moves the tool, unless joint 1 turns as well.", _other_elbow),
]

# ---- Exercise 5: the Alpha II from above --------------------------------------------------

PLACE = np.array([250.0, 150.0, 60.0])  # mm


def _there(q: np.ndarray) -> str:
    miss = float(np.linalg.norm(kinematics.forward_kinematics(_ALPHA_II, q)[:3, 3] - PLACE))
    return "" if miss <= 0.1 else f"The tip is {miss:.4g} mm from the part; 0.1 mm is allowed."


_PICK = (within_limits(_ALPHA_II), straight_down(_ALPHA_II), _there)
_PICK_SLIPS = [
    degrees_slip(_PICK, hint="q is in radians"),
    ("The tip is in place. A target that is only a point says nothing of the tool's direction: "
     "hand over a whole pose.", lambda q: not _there(q)),
    ("The tool points up: the third column of the target's rotation is the approach vector.",
     lambda q: kinematics.forward_kinematics(_ALPHA_II, q)[2, 2] > 0.99),
    (f"The wrist is at the part, not the tip, which is {_ALPHA_II.links[4].d} mm farther on.",
     lambda q: np.linalg.norm(kinematics.link_frames(_ALPHA_II, q)[3, :3, 3] - PLACE) < 0.1),
]

JUDGES: dict[str, Judge] = {
    "inverse.1": function(
        _SOLVED, _NEWTON_CASES, slips=_NEWTON_SLIPS,
        entry=lambda index: f"theta_{index[0] + 1} (rad)",
        praise="This is the Jacobian inverse technique. Try it on other targets, and from a "
               "stretched arm."),
    "inverse.2": function(
        _damped, _DAMPED_CASES, slips=_DAMPED_SLIPS,
        entry=lambda index: f"the step of joint {index[0] + 1}",
        praise="It gives a step at a singular Jacobian too, and for more joints than directions."),
    "inverse.3": choices(
        _MOVERS, {1, 2, 3, 4, 5}, _MOVER_HINTS,
        praise="No joint moves the tip along x: the arm is stretched, and inwards it can only "
               "start by bending."),
    "inverse.4": one_of_many(
        _pair, (_both_reach, _on_both_sides), slips=_PAIR_SLIPS, noun="two pairs of joint values",
        praise=f"One point, two arms. Its distance is 1.5 m, so the elbow is bent by "
               f"{degrees(np.arccos(0.125)):.2f}° to one side or the other."),
    "inverse.5": one_of_many(
        one_pose(_ALPHA_II, "five"), _PICK, slips=_PICK_SLIPS,
        praise="The tip is at the part, straight down, within the limits. The turn of the gripper "
               "is free, and joint 5 alone decides it."),
}
