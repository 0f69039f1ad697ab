"""Lesson 00, start here: its views, predictions, its exercises' references and typical slips."""
from __future__ import annotations

from functools import partial
from math import cos, degrees, inf, pi, radians, sin
from typing import Any

import numpy as np

from ..answers.conditions import degrees_slip, exactly, meet, one_of_many
from ..answers.judges import Judge, choices, values
from ..answers.prediction import Asked, Choice, Direction, Mark, Number, Several
from ..answers.words import fixed
from ..arms import kinematics, robots
from ..arms.motions import Numbers
from ..drawing.scene import LINE, at, circle, origin_of
from ..drawing.sketch import Sketch
from ..views.arm_view import ArmView
from ..views.live import LiveView
from . import notation
from .asked import angle, said

_ARM = robots.two_link()
TARGET = np.array([cos(radians(20)) + cos(radians(80)), sin(radians(20)) + sin(radians(80))])
NEAR = 0.02  # m

# ---- Views: the same arm, asked forwards and backwards ---------------------------------


def reach_view(target: Numbers = (1.0, 1.0)) -> LiveView:
    """The two-link arm and a target that its tip may reach."""
    sketch = Sketch.of(_ARM, np.radians([-40, 60]), name="Two-link arm and a target",
                       keep=lambda item: not item.layer)
    sketch.bare()
    sketch.axes("0", 0, 0.6)
    ring = 0.1 * circle(33) + [*target, 0]
    tip, (middle, above) = origin_of(sketch.tip), at(0, (*target, 0), ring[8] + [0.07, 0.07, 0])
    sketch.add("target", LINE, "target", at(0, *ring), lift=sketch.radius)
    sketch.label(f"target ({target[0]:.3g}, {target[1]:.3g})", (above, middle), "target")
    sketch.add("gap", LINE, "miss", (tip, middle), lift=sketch.radius)
    sketch.reading("p", "forward: the tip is at p = {} m", sketch.vector(0, tip))
    sketch.reading("gap", "error: target - p = {} m", sketch.vector(tip, middle))
    return LiveView(sketch.scene())


def two_ways_view() -> LiveView:
    """The target of exercise 3."""
    return reach_view(TARGET)


def cylindrical_view() -> ArmView:
    """The arm with one joint that turns and two that slide."""
    return ArmView(robots.cylindrical())


def two_link_view() -> ArmView:
    """The two-link arm, stretched along x₀."""
    return ArmView(_ARM, [0, 0])


def colours() -> Any:
    """A picture of what the colours of all pictures, formulas and numbers mean."""
    from ..drawing.legend import colours_picture  # matplotlib: only who asks waits for it

    return colours_picture()


# ---- Predictions --------------------------------------------------------------------------

_TURNS, _LIFTS, _REACHES = ("joint 1: the column turns", "joint 2: the lift slides up and down",
                            "joint 3: the reach slides in and out")


def _joints(ask: str, right: str, why: str, **shows: float) -> Several:
    """Which of the three joints can change something of the tool?"""
    turns = "A turn about the upright column keeps height and distance, and turns the tool."
    return Several(ask=f"Which joints can change {ask}?", right=[right], why=why, shows=shows,
                   options={_TURNS: turns, _LIFTS: "The lift moves the tool along z₀ only.",
                            _REACHES: "The reach moves the tool away from the column, on a level."})


def _turned(theta: float, right: str, wrong: tuple[float, float], slip: str,
            reach: float = 0.3) -> Mark:
    """Where the tool is when the column has turned."""
    return Mark(
        ask=f"The tool is {reach:g} m away from the column, along x₀. Then the column turns by "
            f"{angle(theta)}. Where is the tool? Set the mark, as seen from above.",
        why=f"It is still {reach:g} m away from the column, now {right}, and still 0.7 m high.",
        start={"theta_1": 0, "d_3": reach}, shows={"theta_1": theta}, seen="top", of="tip",
        unit="m", tolerance=0.06, slips=[((*wrong, 0.7), slip)])


def _tip(first: float, second: float, why: str, wrong: tuple[float, float],
         slip: str = "That is where it would be if θ₂ were measured from x₀.") -> Mark:
    """The forward question."""
    return Mark(
        ask=f"θ₁ = {angle(first)}, θ₂ = {angle(second)}. Where is the tip? θ₂ is measured "
            "from the first link.",
        why=why, start={"theta_1": 0, "theta_2": 0}, shows={"theta_1": first, "theta_2": second},
        of="tip", unit="m", tolerance=0.2,
        slips=[((*wrong, 0), slip)])


def _bend(first: float, right: float, why: str, *slips: tuple[float, str]) -> Number:
    """The inverse question, with one of the two angles given."""
    return Number(
        ask=f"θ₁ = {angle(first)}. Which θ₂ brings the tip into the ring at (1, 1)?",
        why=why, start={"theta_1": first, "theta_2": 0}, shows={"theta_2": right}, unit="°",
        right=right, tolerance=5, turn=360, slips=[
            *slips, (45, "The ring is at 45° as the base sees it; θ₂ is measured from link 1."),
            (-right, "By that angle it bends to the other side.")])


def _ways(target: str, right: str, why: str, **said: str) -> Choice:
    """How many answers the inverse question has."""
    options = {word: said.get(word.split()[0], "") for word in ("none", "one", "two",
                                                                "infinitely many")}
    return Choice(ask=f"How many poses (θ₁, θ₂) of this arm, with two links of 1 m, bring its tip "
                      f"to {target}? Whole turns do not count.", why=why, options=options,
                  right=right)


def _points(first: float, second: float, begin: float, why: str,
            *slips: tuple[float, str]) -> Direction:
    """Which way the last link points."""
    return Direction(
        ask=f"θ₁ = {angle(first)}, θ₂ = {angle(second)}. Which way does the last link point?",
        why=why, start={"theta_1": 0, "theta_2": 0}, shows={"theta_1": first, "theta_2": second},
        of="frame-E-x", begin=begin, slips=slips)


def _on_the_way(turn: float, wrong: tuple[float, float], slip: str) -> Mark:
    """A point of the path on which both joints turn alike."""
    x, y = cos(radians(turn)) + cos(radians(2 * turn)), sin(radians(turn)) + sin(
        radians(2 * turn))
    return Mark(
        ask=f"Both joints turn alike, from 0° on. Where is the tip when θ₁ = θ₂ = "
            f"{angle(turn)}?",
        why=f"The first link points at {angle(turn)}, the second at {angle(2 * turn)}: "
            f"the tip is at ({_number(x)}, {_number(y)}).",
        start={"theta_1": 0, "theta_2": 0}, shows={"theta_1": turn, "theta_2": turn}, of="tip",
        unit="m",
        tolerance=0.2, slips=[((*wrong, 0), slip)])


def _number(value: float) -> str:
    return said(round(value, 2))


_NOT_ADDED = "There both links would point the same way; θ₂ is measured from the first link."

PREDICTIONS: dict[str, Asked] = {
    "start_here.joints": Asked(cylindrical_view, [
        _joints("the height of the tool", _LIFTS, d_2=0.5,
                why="Only the lift slides upwards; the others move the tool on a level."),
        _joints("the distance between the tool and the column", _REACHES, d_3=0.5,
                why="Only the reach slides away from the column. On a turn the distance stays."),
        _joints("the direction in which the tool points", _TURNS, theta_1=60,
                why="Only a joint that turns can turn the tool. Slides keep all directions.")]),
    "start_here.column": Asked(cylindrical_view, [
        _turned(90, "along y₀", (0, -0.3), "That is a turn clockwise, by −90°."),
        _turned(-90, "against y₀", (0, 0.5), "That is a turn counterclockwise, by +90°.", 0.5),
        _turned(180, "against x₀", (0, 0.4), "That is half of the turn: 90°.", 0.4)]),
    "start_here.tip": Asked(reach_view, [
        _tip(90, 90, "The first link points up the page, the second one to the left: (−1, 1).",
             (0, 2)),
        _tip(0, -90, "The first link lies along x₀, the second one points down: (1, −1).",
             (1, 1), "That is a turn counterclockwise, by +90°."),
        _tip(180, 90, "The first link points to the left, the second one down: (−1, −1).",
             (-1, 1))]),
    "start_here.ring": Asked(reach_view, [
        _bend(0, 90, "The first link ends at (1, 0); from there the ring is straight up."),
        _bend(90, -90, "The first link ends at (0, 1); from there the ring is to the right, and "
                       "that is a turn clockwise.",
              (0, "With θ₂ = 0° both links point up the page."))]),
    "start_here.ways": Asked(None, [
        _ways("(1, 1)", "two", "The elbow may bend to either side: (0°, 90°) and (90°, −90°).",
              none="The target is 1.41 m away, and the arm is 2 m long.",
              one="Mirror the arm about the line from the base to the tip.",
              infinitely="Two circles, about the base and about the target, meet in two points."),
        _ways("(2, 0)", "one", "The tip gets there only with both links in one line.",
              two="Try to bend the elbow: the tip comes nearer to the base.",
              none="Stretch both links.",
              infinitely="Bend the elbow, and the tip comes nearer to the base."),
        _ways("(2, 1)", "none", "(2, 1) is 2.24 m away from the base, and the arm is 2 m long.",
              **dict.fromkeys(("one", "two", "infinitely"), "How far is it from the base?")),
        _ways("(0, 0), the base", "infinitely many",
              "With θ₂ = 180° the second link lies on the first one, and θ₁ may be anything.",
              none="Fold the arm.", one="Fold the arm, then turn it.",
              two="Fold the arm, then turn it.")]),
    "start_here.pointing": Asked(two_link_view, [
        _points(90, -90, 180, "Angles add up: 90° − 90° = 0°, along x₀.",
                (-90, "θ₂ is measured from the first link, not from x₀."),
                (90, "That is where the first link points.")),
        _points(90, 90, 0, "Angles add up: 90° + 90° = 180°, against x₀.",
                (90, "That is where the first link points; the second one bends on from there.")),
        _points(120, -30, 0, "Angles add up: 120° − 30° = 90°, along y₀.",
                (-30, "θ₂ is measured from the first link, not from x₀."),
                (120, "That is where the first link points."))]),
    "start_here.way": Asked(two_link_view, [
        _on_the_way(30, (2 * cos(pi / 6), 1), _NOT_ADDED),
        _on_the_way(60, (1, 2 * sin(pi / 3)), _NOT_ADDED),
        _on_the_way(-60, (1, -2 * sin(pi / 3)), _NOT_ADDED)]),
    "start_here.radians": Asked(None, [Choice(
        ask="You want θ₁ = 10° and write 10 in a function of kinlab. What happens?",
        why="Functions read radians, and 10 radians is an angle too: 573°, or one turn and 213°.",
        options={"kinlab stops with an error": "No rule is broken: 10 is a good angle in radians.",
                 "θ₁ is 10°": "Sliders read degrees; functions read radians.",
                 "θ₁ is 213°, and nobody says a word": "",
                 "θ₁ is 0.17°": "10° are 0.17 radians; but the function takes the 10 as it is."},
        right="θ₁ is 213°, and nobody says a word")]),
}

# ---- Exercise 1: forward or inverse? -----------------------------------------------------

_QUESTIONS = {"forward": {1, 4, 5}, "inverse": {2, 3, 6}}
_JOINTS_KNOWN = "Question {}: are the joint values given, or asked for?"
_QUESTION_HINTS = {(name, k): _JOINTS_KNOWN.format(k) for name in _QUESTIONS for k in range(1, 7)}

# ---- Exercise 2: units -------------------------------------------------------------------

# Of a metre, by millimetres.
PARTS = {200: "a fifth", 250: "a quarter", 400: "two fifths"}


def units_judge(turn: float, lift: int, reach: int) -> Judge:
    """Judge of joint values that are given in degrees, millimetres and centimetres."""
    q1, d2, d3 = radians(turn), lift / 1000, reach / 100
    part, less = f"{lift} mm is {PARTS[lift]} of a metre.", f"{reach} cm is less than half a metre"
    slips = [
        ("The angle is in degrees and the lengths are not in metres.", [turn, lift, reach]),
        ("The angle is still in degrees: use np.radians.", [turn, d2, d3]),
        ("The angle was converted the wrong way: np.degrees makes degrees of radians.",
         [degrees(turn), d2, d3]),
        ("The lengths belong in the arm's unit, metres.", [q1, lift, reach]),
        (part, [q1, lift, d3]),
        (part, [q1, 10 * d2, d3]),
        (f"{less}.", [q1, d2, reach]),
        (f"{less}; a metre has 100 cm.", [q1, d2, d3 / 10]),
        ("The lengths are in millimetres; this arm's unit is the metre.", [q1, lift, 10 * reach]),
        ("The lengths have changed places: joint 2 lifts, joint 3 reaches.", [q1, d3, d2]),
    ]
    return values(
        [q1, d2, d3], entry=lambda index: f"q[{index[0]}]", slips=slips,
        angles=[True, False, False],
        praise="Radians for the revolute joint, metres for the two that slide.")


# ---- Exercise 3: two ways to reach --------------------------------------------------------


_two_ways = exactly((2, 2), "two pairs of joint values")


def _reaches(k: int, target: np.ndarray, q: np.ndarray) -> str:
    p = kinematics.forward_kinematics(_ARM, q[k])[:2, 3]
    gap = np.linalg.norm(target - p)
    return "" if gap <= NEAR else (
        f"Pair {k + 1} puts the tip at ({fixed(p[0])}, {fixed(p[1])}) m, {gap:.3f} m from "
        f"the target; {NEAR} m is allowed.")


def _elbows_differ(q: np.ndarray) -> str:
    return "" if np.prod(np.sin(q[:, 1])) < 0 else (
        "Both pairs reach the target, but in the same way. Bend the elbow to the other side.")


def two_ways_judge(target: np.ndarray) -> Judge:
    """Judge of two pairs of joint values that bring the tip to a target."""
    both_reach = tuple(partial(_reaches, k, target) for k in range(2))
    slips = [
        degrees_slip(both_reach, inf, subject="These"),
        ("The pairs have to be rows: each holds θ₁ and θ₂.", lambda q: meet(both_reach, q.T)),
        ("Only the sign of θ₂ has changed; θ₁ has to make up for it.",
         lambda q: abs(q[0, 1]) > 0.02 and np.allclose(q[1], q[0] * [1, -1], atol=0.02)),
    ]
    return one_of_many(
        _two_ways, (*both_reach, _elbows_differ), slips=slips,
        parts=("pair 1", "pair 2"), each=both_reach,
        praise="One position, two answers. Forward kinematics never has that trouble: each pair "
               "of joint values has one tip.")


JUDGES: dict[str, Judge] = {
    "start_here.1": choices(
        _QUESTIONS, {1, 2, 3, 4, 5, 6}, _QUESTION_HINTS, noun="question",
        praise="Joint values given: forward. Joint values asked for: inverse."),
    "start_here.2": units_judge(60, 250, 45),
    "start_here.3": notation.JUDGES["notation.1"],  # under these names in copies of lesson 00
    "start_here.4": notation.JUDGES["notation.2"],  # from before lesson 03b
    "start_here.5": two_ways_judge(TARGET),
}
