"""Predictions of lesson 07, the Alpha II."""
from __future__ import annotations

from functools import partial

import numpy as np

from ...answers.prediction import Asked, Choice, Direction, Mark, Number, Several, Signs
from ...arms import robots
from ...views.arm_view import ArmView
from ..views.four_motions import four_motions
from . import said

_JOINTS = tuple(f"theta_{k}" for k in range(1, 6))
_HOME = (0, 0, 0, -90, 0)


def arm_view() -> ArmView:
    """The Alpha II at its soft home."""
    return ArmView(robots.alpha_ii())


def _roll_view() -> ArmView:
    return ArmView(robots.alpha_ii(), np.radians([30, -40, 60, 20, 0]), closed_form=True)


def _at(*degrees: float) -> dict[str, float]:
    return dict(zip(_JOINTS, degrees))


# ---- Positions --------------------------------------------------------------------------


def _base(theta_1: float, why: str, slip: tuple) -> Mark:
    return Mark(
        ask="The arm is stretched out level along x₀, 485 mm long, seen from above. Joint 1 turns "
            f"everything about the vertical z₀. Where will the tip be at θ₁ = {said(theta_1)}°?",
        why=why, shows={"theta_1": theta_1}, of="tip", axes="xy", seen="top", tolerance=60,
        slips=[slip])


_CLOCKWISE = ("Seen from above, a positive turn about z₀ is counter-clockwise: from x₀ towards y₀.")


def _bend(pose: dict, ask: str, why: str, slips: list) -> Mark:
    return Mark(ask=ask, why=why, start=_at(*_HOME), shows=pose, of="tip", axes="xz", seen="front",
                tolerance=60, slips=slips)


def _pose(number: str, why: str, *degrees: float, slips: list) -> Mark:
    told = ", ".join(f"{said(value)}°" for value in degrees)
    return Mark(ask=f"You see soft home. Then q = ({told}){number}. Where is the tip?",
                why=why, start=_at(*_HOME), shows=_at(*degrees), of="tip", axes="xz",
                seen="front", tolerance=60, slips=slips)


_POSES = [
    _pose(": all zero", "Upper arm and forearm are level. The tool hangs down: its 129.5 mm leave "
          "85.5 of the 215 mm.", 0, 0, 0, 0, 0,
          slips=[((485.1, 0, 215), "The tool is level at θ₄ = −90°. Here θ₄ is 0."),
                 ((355.6, 0, 344.5), "The tool hangs down: a = (−S₂₃₄, 0, −C₂₃₄) is (0, 0, −1).")]),
    _pose("", "θ₂ = −90° raises the upper arm, and all else goes on in its line: 215 + 485.1 mm.",
          0, -90, 0, -90, 0,
          slips=[((0, 0, -270.1), "A negative θ₂ raises the arm, a positive one lowers it.")]),
    _pose("", "Upper arm up, forearm level, tool down: 177.8 mm out, and 215 + 177.8 − 129.5 high.",
          0, -90, 90, 0, 0,
          slips=[((177.8, 0, 392.8), "That is the wrist: the tool hangs 129.5 mm below it."),
                 ((177.8, 0, 522.3), "The tool points down: θ₂ + θ₃ + θ₄ = 0.")]),
    _pose("", "The same place as without the roll: the tip lies on the axis of joint 5.",
          0, -90, 90, 0, 90,
          slips=[((307.3, 0, 392.8), "θ₅ rolls the tool about its own line, no more.")]),
]

# ---- Directions -------------------------------------------------------------------------


def _carried(alpha: float, degrees: float, why: str) -> Direction:
    return Direction(
        ask="θ = 0°, and the last of the four motions turns the frame about its x axis, which "
            f"points towards you, by α = {said(alpha)}°. Which way will its z axis point? (0° is "
            "along y₀, 90° up.)",
        why=why, start={"theta": 0, "d": 0.9, "a": 0, "alpha": alpha, "motion": 3},
        shows={"motion": 4}, of="frame-1-z", about="x", seen="side", begin=90,
        slips=[(180 - degrees, "That is a turn the other way. A positive one goes from y towards "
                               "z, counter-clockwise in this picture.")])


def _approach(why: str, *degrees: float, slips: list) -> Direction:
    told = ", ".join(f"{said(value)}°" for value in degrees)
    return Direction(
        ask=f"You see soft home: the tool points along x₀. Then q = ({told}). Which way will the "
            "tool's z axis, z₅, point? (0° is up, 90° along x₀, 180° down.)",
        why=why, start=_at(*_HOME), shows=_at(*degrees), of="frame-5-z", about="y", seen="front",
        begin=90, slips=slips)


_APPROACH = [
    _approach("θ₂ + θ₃ + θ₄ grew by 45° from soft home, and positive turns lower the tool: half "
              "way between level and down.", 0, 0, 0, -45, 0,
              slips=[(45, "A positive turn about z₃ lowers the tool.")]),
    _approach("The three turns add up to −120°, 30° less than at soft home: the tool rises by 30°.",
              0, -30, 0, -90, 0,
              slips=[(120, "A negative turn raises."),
                     (90, "The shoulder takes the whole arm with it, the tool too.")]),
    _approach("The three turns add up to 0: the tool hangs down, whatever the arm does above it.",
              0, -60, 100, -40, 0,
              slips=[(0, "At θ₂ + θ₃ + θ₄ = 0 the tool points down, not up.")]),
]

# ---- Matrices ---------------------------------------------------------------------------

_ORDER = Choice(
    ask="Each of the four motions goes along or about an axis of the frame that moves. On which "
        "side of the first matrix does that of the second motion stand?",
    options={"on its left": "On the left stands a motion about fixed axes.",
             "on its right": "",
             "either: the product is the same": "Two such matrices need not change places."},
    right="on its right",
    why="A motion about the moving frame's own axes multiplies on the right, so the product reads "
        "in the order of the motions.")

_FIXED = Choice(
    ask="Someone reads the axes as fixed axes of frame k−1. A motion about a fixed axis multiplies "
        "on the left. What becomes of the product?",
    options={"it is the inverse": "In the inverse the motions go backwards as well, by the "
                                  "opposite amounts.",
             "it is the transpose": "Each factor stays as it is; only their order changes.",
             "the factors stand in reverse order": "",
             "it stays the same": "Turns about x and z do not change places."},
    right="the factors stand in reverse order",
    why="The last motion stands on the far left: that is the order of the modified (Craig) table.")

_INVERSE = Choice(
    ask="The lecture prints −Cα in row 3, column 3 of the inverse. In the link transform that "
        "entry is +Cα. What must it be in the inverse?",
    options={"+Cα": "", "−Cα": "The rotation of the inverse is the transpose: what stands on the "
                                "diagonal stays.",
             "Sα": "The transpose moves no entry of the diagonal."},
    right="+Cα",
    why="Rᵀ has the same diagonal as R.")

_BRACKET = Choice(
    ask="The first entry of the product becomes C₁ (C₂C₃ − S₂S₃). Of which angle is the bracket "
        "the cosine?",
    options={"θ₂ − θ₃": "That would be C₂C₃ + S₂S₃.", "θ₂ + θ₃": "",
             "θ₂ · θ₃": "Angles of turns add up; they are not multiplied."},
    right="θ₂ + θ₃",
    why="The axes of joints 2 and 3 are parallel, so their turns add up.")

_CIRCLE = Choice(
    ask="Only θ₄ changes. Seen from frame 3, the wrist's, on which curve does the tip run?",
    options={"a circle in the x₃z₃ plane": "Joint 4 turns about z₃, and nothing moves along that "
                                           "axis.",
             "a circle about the base": "That is what joint 1 does.",
             "a circle in the x₃y₃ plane": "",
             "a line": "Joint 4 turns; it does not slide."},
    right="a circle in the x₃y₃ plane",
    why="The tip is 129.5 mm from the axis z₃ and stays at one height along it.")

_ROLL = Several(
    ask="Only θ₅ will move, from 0° to 75°. Which columns of the arm matrix change?",
    options={"n": "The normal vector is the tool's x axis: it turns with the roll.",
             "s": "The sliding vector is the tool's y axis: it turns with the roll.",
             "a": "The approach vector lies along the axis of joint 5.",
             "p": "The tip lies on the axis of joint 5."},
    right=("n", "s"),
    why="Joint 5 turns about z₄. The tip lies on that axis and a points along it: both stay.",
    start=_at(30, -40, 60, 20, 0), shows={"theta_5": 75})

_SOFT_HOME = Signs(
    ask="Arm and tool are level and point along x₀; x₅ points up. Each column of R is an axis of "
        "the tool, seen from the base. Fill in its signs.",
    rows=("x₀", "y₀", "z₀"), columns=("n", "s", "a"), right=("00+", "0-0", "+00"),
    among={"+": "one", "-": "minus one", "0": "zero"},
    why="a = (1, 0, 0) points forwards, n = (0, 0, 1) up, and s = a × n = (0, −1, 0) to the right.",
    start=_at(*_HOME), shows=_at(*_HOME))

_REACH = Number(
    ask="20 000 random poses inside the limits. What is about the largest distance of the tip from "
        "the shoulder?",
    right=485.1, tolerance=10, unit="mm",
    slips=[(355.6, "That is the wrist of the stretched arm: the tool is 129.5 mm longer."),
           (700.1, "That is the largest height. Here the distance begins at the shoulder, 215 mm "
                   "up.")],
    why="Nothing reaches farther than the stretched arm: 177.8 + 177.8 + 129.5 = 485.1 mm.")

PREDICTIONS: dict[str, Asked] = {
    "alpha_ii.base": Asked(arm_view, [
        _base(90, "Every point keeps its distance from z₀: 485.1 mm, now along y₀.",
              ((0, -485.1, 215), _CLOCKWISE)),
        _base(-135, "The tip stays 485.1 mm from z₀: 343 mm towards −x₀, and as much towards −y₀.",
              ((-343, 343, 215), _CLOCKWISE)),
        _base(30, "The tip stays 485.1 mm from z₀: 485.1 cos 30° = 420 and 485.1 sin 30° = 243 mm.",
              ((420.1, -242.6, 215), _CLOCKWISE))]),
    "alpha_ii.motions": Asked(partial(four_motions, "standard"), [
        _carried(-90, 0, "A turn by −90° about x takes z from straight up to y₀. So the axis of "
                         "joint 2 is level."),
        _carried(90, 180, "A turn by 90° about x takes z from straight up to −y₀."),
        _carried(-45, 45, "A turn by −45° takes z half way from straight up to y₀.")]),
    "alpha_ii.order": Asked(None, [_ORDER]),
    "alpha_ii.fixed": Asked(None, [_FIXED]),
    "alpha_ii.inverse": Asked(None, [_INVERSE]),
    "alpha_ii.bend": Asked(arm_view, [
        _bend({"theta_2": 20}, "z₁ points along y₀, away from you in this picture. θ₂ goes to "
              "+20°. Where will the tip be?",
              "A right-handed turn about y₀ takes x₀ downwards: the tip sinks from 215 to 49 mm.",
              [((455.8, 0, 380.9), "A positive turn about y₀ takes x₀ downwards.")]),
        _bend({"theta_3": -90}, "z₂ points along y₀, away from you. θ₃ goes to −90°: the elbow "
              "bends. Where will the tip be?",
              "The upper arm stays level; forearm and tool point straight up: 215 + 307.3 mm high.",
              [((177.8, 0, -92.3), "A negative turn raises: it is the opposite of θ₂ = +20°.")])]),
    "alpha_ii.bracket": Asked(None, [_BRACKET]),
    "alpha_ii.circle": Asked(None, [_CIRCLE]),
    "alpha_ii.roll": Asked(_roll_view, [_ROLL]),
    "alpha_ii.home": Asked(arm_view, [_SOFT_HOME]),
    "alpha_ii.poses": Asked(arm_view, _POSES),
    "alpha_ii.approach": Asked(arm_view, _APPROACH),
    "alpha_ii.reach": Asked(None, [_REACH]),
}
