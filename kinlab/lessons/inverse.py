"""Lesson 10, inverse kinematics: the judges of its exercises, and its predictions."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import degrees

import numpy as np

from ..answers.conditions import (
    degrees_slip,
    exactly,
    meet,
    one_of_many,
    one_pose,
    straight_down,
    within_limits,
)
from ..answers.judges import Judge, choices, function
from ..answers.matrices import BY_ENTRY
from ..arms import kinematics, robots
from .asked.inverse import PREDICTIONS
from .views.inverse import eight_view, leap_view, newton_view, tilt_view

__all__ = ["JUDGES", "PREDICTIONS", "eight_view", "leap_view", "newton_view", "tilt_view"]

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


def _all_from_the_start(q: np.ndarray, target: np.ndarray, steps: int) -> np.ndarray:
    q = np.array(q, dtype=float)
    return q + steps * np.linalg.solve(_jacobian(q), np.array(target) - _tool(q))


def _error_from_the_start(q: np.ndarray, target: np.ndarray, steps: int) -> np.ndarray:
    q = np.array(q, dtype=float)
    e = np.array(target) - _tool(q)
    for _ in range(steps):
        q = q + np.linalg.solve(_jacobian(q), e)
    return q


def _with_all_rows(q: np.ndarray, target: np.ndarray, steps: int) -> np.ndarray:
    """The pseudoinverse of all six rows asks for a tool that does not turn, too."""
    q = np.array(q, dtype=float)
    for _ in range(steps):
        e = np.append(np.array(target) - _tool(q), np.zeros(4))
        q = q + np.linalg.pinv(kinematics.jacobian(_TWO, q)) @ e
    return q


def _last_step(q: np.ndarray, target: np.ndarray, steps: int) -> np.ndarray:
    before = _SOLVED(q, target, steps - 1)
    return _SOLVED(before, target, 1) - before

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
    ("J and the error are computed once. The arm moves: take both afresh in each step, inside the "
     "loop.", _all_from_the_start),
    ("The error is computed once. The tool moves: take the error afresh in each step.",
     _error_from_the_start),
    ("Only one step is taken, whatever `steps` says. Does return stand inside the loop?",
     lambda q, target, steps: _SOLVED(q, target, 1)),
    ("That is one step too many: range(steps) counts them.",
     lambda q, target, steps: _SOLVED(q, target, steps + 1)),
    ("That is one step too few: range(steps) counts them.",
     lambda q, target, steps: _SOLVED(q, target, steps - 1)),
    ("It goes on until it arrives. Take `steps` steps, no more.",
     lambda q, target, steps: _SOLVED(q, target, 50)),
    ("It does not move: return the joint values after the steps.",
     lambda q, target, steps: q),
    ("It begins at zero. Begin at the q that you were given.",
     lambda q, target, steps: _SOLVED(0 * q + [0, 1e-9], target, steps)),
    ("J has six rows. Take the first two, those of x and y; the others would hold the tool's "
     "direction.", _with_all_rows),
    ("This is the last step alone. Add it to q.", _last_step),
    ("Half a step is taken each time; Newton's method takes whole ones.",
     _newton(lambda J, e: np.linalg.solve(J, e) / 2)),
    ("The step is added in degrees; q is in radians.",
     _newton(lambda J, e: np.degrees(np.linalg.solve(J, e)))),
    ("This is the sum of the steps. Add them to the q that you were given.",
     lambda q, target, steps: _SOLVED(q, target, steps) - q),
]

# ---- Exercise 2: a damped step ----------------------------------------------------------


def _damped(J: np.ndarray, e: np.ndarray, damping: float) -> np.ndarray:
    return J.T @ np.linalg.solve(J @ J.T + damping**2 * np.eye(len(e)), e)


def _factors_exchanged(J: np.ndarray, e: np.ndarray, damping: float) -> np.ndarray:
    """It works for a square J only."""
    return np.linalg.solve(J @ J.T + damping**2 * np.eye(len(J)), J.T @ e)


def _grams_exchanged(J: np.ndarray, e: np.ndarray, damping: float) -> np.ndarray:
    """It works for a square J only."""
    return J.T @ np.linalg.solve(J.T @ J + damping**2 * np.eye(J.shape[1]), e)


def _damping_in_j(J: np.ndarray, e: np.ndarray, damping: float) -> np.ndarray:
    wider = J + damping**2 * np.eye(*J.shape)
    return J.T @ np.linalg.solve(wider @ wider.T, e)


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
    ("The factors have changed places: J^T stands on the left of the inverse.", _factors_exchanged),
    ("The factors have changed places: the bracket holds J J^T, which has as many rows as e.",
     _grams_exchanged),
    ("The bracket is not inverted: np.linalg.solve(bracket, e), or np.linalg.inv(bracket) @ e.",
     lambda J, e, damping: J.T @ (J @ J.T + damping**2 * np.eye(len(e))) @ e),
    ("The damping is subtracted; it is added.", lambda J, e, damping: J.T @ np.linalg.solve(
        J @ J.T - damping**2 * np.eye(len(e)), e)),
    ("The damping should make the bracket larger: lambda² I is added to J J^T, not to J.",
     _damping_in_j),
    (BY_ENTRY, lambda J, e, damping: J.T @ np.linalg.solve(
        J * J + damping**2 * np.eye(len(e)), e)),
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

_pair = exactly((2, 2), "two rows of two joint values")


def _both_reach(point: np.ndarray, pair: np.ndarray) -> str:
    for row, q in zip(("first", "second"), pair):
        miss = float(np.linalg.norm(_tool(q) - point))
        if miss > 1e-3:
            return f"With the {row} joint values the tool misses the point by {miss:.3g} m."
    return ""


def _on_both_sides(pair: np.ndarray) -> str:
    one, two = np.sin(pair[:, 1])
    return "" if one * two < 0 else ("Both reach the point, but with the elbow on the same side: "
                                     "the second should bend the other way.")


def _with_relative_elbow(pair: np.ndarray) -> np.ndarray:
    return np.column_stack([pair[:, 0], pair[:, 1] - pair[:, 0]])


def _halved(pair: np.ndarray) -> np.ndarray:
    """The pair, if the first angles were a whole bend from the line to the point."""
    middle = pair[:, 0].mean()
    return np.column_stack([middle + (pair[:, 0] - middle) / 2, pair[:, 1]])


def _other_elbow(pair: np.ndarray) -> bool:
    return np.isclose(pair[0, 0], pair[1, 0]) and np.isclose(pair[0, 1], -pair[1, 1])


def _supplements(pair: np.ndarray) -> np.ndarray:
    return np.column_stack([pair[:, 0], np.sign(pair[:, 1]) * np.pi - pair[:, 1]])


def both_ways_judge(x: float, y: float) -> Judge:
    """Judge of both poses of the two-link arm that reach a point (m)."""
    point = np.array([x, y])
    conditions = (partial(_both_reach, point), _on_both_sides)

    def after(change: Callable[[np.ndarray], np.ndarray]) -> Callable[[np.ndarray], bool]:
        """Whether the pair is right after a change."""
        return lambda pair: meet(conditions, change(pair))

    slips = [
        degrees_slip(conditions[:1], subject="These", hint="write np.radians([...])"),
        ("Bending the elbow the other way moves the tool, unless joint 1 turns as well.",
         _other_elbow),
        ("Rows and columns have changed places: each row is one answer, (theta_1, theta_2).",
         after(np.transpose)),
        ("theta_1 comes first in each row, then theta_2.", after(lambda pair: pair[:, ::-1])),
        ("The elbow bends to the wrong side: with theta_2 above 0 link 1 lies below the line to "
         "the point.", after(lambda pair: pair * [1, -1])),
        ("Link 1 is half the bend away from the line to the point, for the links are equally long.",
         after(_halved)),
        ("theta_2 is counted from link 1, not from the x axis.", after(_with_relative_elbow)),
        ("That is the angle between the links. theta_2 is what is missing to a straight arm.",
         after(_supplements)),
    ]
    away = float(np.hypot(x, y))
    return one_of_many(
        _pair, conditions, slips=slips, noun="two pairs of joint values",
        praise=f"One point, two arms. Its distance is {away:.4g} m, so the elbow is bent by "
               f"{degrees(np.arccos(away ** 2 / 2 - 1)):.2f}° to one side or the other.")


# ---- Exercise 5: the Alpha II from above --------------------------------------------------

NEAR = 0.5  # mm, as near as sliders bring it that stop at tenths of a degree


def _away(q: np.ndarray, point: np.ndarray) -> float:
    """How far the tip is from a point."""
    return float(np.linalg.norm(kinematics.forward_kinematics(_ALPHA_II, q)[:3, 3] - point))


def _there(part: np.ndarray, q: np.ndarray) -> str:
    x, y, z = part
    return "" if (miss := _away(q, part)) <= NEAR else (
        f"The tip is {miss:.4g} mm from the part at ({x:g}, {y:g}, {z:g}); {NEAR} mm is allowed.")


def _approach(q: np.ndarray) -> np.ndarray:
    return kinematics.forward_kinematics(_ALPHA_II, q)[:3, 2]


def pick_judge(x: float, y: float, z: float) -> Judge:
    """Judge of joint values that take a part (mm) from straight above."""
    part = np.array([x, y, z], dtype=float)
    conditions = (within_limits(_ALPHA_II), straight_down(_ALPHA_II), partial(_there, part))
    mirrored = part * np.array([[1, -1, 1], [-1, 1, 1], [-1, -1, 1]])
    slips = [
        degrees_slip(conditions, hint="q is in radians"),
        ("The tip is in place, but the tool leans. A target that is only a point says nothing of "
         "the tool's direction: hand over a whole pose.", lambda q: not _there(part, q)),
        ("The tool points up: the third column of the target's rotation is the approach vector, "
         "and down is (0, 0, -1).", lambda q: _approach(q)[2] > 0.99),
        ("The tool lies level. The third column of the target's rotation is the approach vector: "
         "down is (0, 0, -1).", lambda q: abs(_approach(q)[2]) < 0.01),
        ("It points straight down, beside the part: x and y have changed places.",
         lambda q: _away(q, part[[1, 0, 2]]) <= NEAR),
        ("It points straight down, on the other side: look at the signs of x and y.",
         lambda q: any(_away(q, other) <= NEAR for other in mirrored)),
        ("Lengths of the Alpha II are in millimetres.", lambda q: _away(q, part / 1000) <= NEAR),
        (f"The wrist is at the part, not the tip, which is {_ALPHA_II.links[4].d} mm farther on.",
         lambda q: np.linalg.norm(kinematics.link_frames(_ALPHA_II, q)[3, :3, 3] - part) < NEAR),
    ]
    return one_of_many(
        one_pose(_ALPHA_II), conditions, slips=slips,
        praise="The tip is at the part, straight down, within the limits. The turn of the gripper "
               "is free, and joint 5 alone decides it.")


JUDGES: dict[str, Judge] = {
    "inverse.1": function(
        _SOLVED, _NEWTON_CASES, slips=_NEWTON_SLIPS, angles=True,
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
    "inverse.4": both_ways_judge(1.2, 0.9),
    # From soft home a search for the mere point ends with the tool 39° from straight down, so the
    # exercise tells a target that is a point from one that is a pose.
    "inverse.5": pick_judge(120, 100, 40),
}
