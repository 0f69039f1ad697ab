"""Predictions of lesson 04, the two-link arm by both methods."""
from __future__ import annotations

from functools import partial

from ...answers.prediction import Asked, Choice, Direction, Mark, Several
from ..views.two_link import both_methods, n_links
from . import angle

# ---- Where Q is, and which way link 2 points ----------------------------------------------


def _tip(theta_1: float, theta_2: float, why: str, *slips: tuple) -> Mark:
    return Mark(ask="The links have the lengths l₁ = 2 and l₂ = 1.5. "
                    f"θ₁ goes to {angle(theta_1)}, θ₂ to {angle(theta_2)}. Where will Q be?",
                why=why, shows={"theta_1": theta_1, "theta_2": theta_2},
                of="point-Q", tolerance=0.2, slips=slips)


_FROM_X = "That counts θ₂ from x₀. It is counted from link 1."
_TIP = [
    _tip(90, -90, "Link 1 stands upright, so P = (0, 2). Link 2 is turned back by 90° and is "
                  "level: Q = (1.5, 2).",
         ((0, 0.5, 0), _FROM_X), ((-1.5, 2, 0), "That is θ₂ = +90°, counter-clockwise."),
         ((0, 3.5, 0), "That is θ₂ = 0.")),
    _tip(180, -90, "Link 1 points back, so P = (−2, 0). Link 2 is at 180° − 90° = 90° and points "
                   "up: Q = (−2, 1.5).",
         ((-2, -1.5, 0), _FROM_X), ((-3.5, 0, 0), "That is θ₂ = 0.")),
    _tip(-90, 90, "Link 1 hangs down, so P = (0, −2). Link 2 is at −90° + 90° = 0° and points "
                  "along x₀: Q = (1.5, −2).",
         ((0, -0.5, 0), _FROM_X), ((-1.5, -2, 0), "That is θ₂ = −90°, clockwise.")),
]


def _bearing(theta_2: float, theta_1: float, why: str, *slips: tuple) -> Direction:
    return Direction(
        ask=f"θ₁ = 0 and θ₂ = {angle(theta_2)}. Now only θ₁ turns, to {angle(theta_1)}. "
            "Which way will link 2 (its x₂) point?",
        why=why, start={"theta_1": 0, "theta_2": theta_2}, shows={"theta_1": theta_1},
        of="frame-2-x", begin=-90.0, slips=slips)


_RIDES = "Link 2 rides on link 1, so it turns as well."
_ONE = "That is link 1. θ₂ is counted from there."
_BEARING = [
    _bearing(30, 60, "Both joints turn link 2. Its angle with x₀ is 60° + 30° = 90°.",
             (30, _RIDES), (60, _ONE)),
    _bearing(-45, 90, "Both joints turn link 2. Its angle with x₀ is 90° − 45° = 45°.",
             (-45, _RIDES), (90, _ONE), (135, "θ₂ is negative: it turns clockwise.")),
    _bearing(60, 150, "Both joints turn link 2. Its angle with x₀ is 150° + 60° = 210°.",
             (60, _RIDES), (150, _ONE)),
]

# ---- The product ----------------------------------------------------------------------------

_ORIGIN = Choice(
    ask="Frame 2 sits at P and is turned by θ₂ against frame 1. What is o₂¹, its origin seen from "
        "frame 1?",
    why="Frame 1 turns with link 1, so it always sees P at the same place, l₁ ahead on x₁. θ₁ does "
        "not appear in H₂¹.",
    right="(l₁, 0)",
    options={"(0, 0)": "That is the origin of frame 1 itself, at O.", "(l₁, 0)": "",
             "(l₁ cos θ₁, l₁ sin θ₁)": "That is P seen from frame 0."})
_SUM = Choice(
    ask="Behind l₂ stands cos θ₁ cos θ₂ − sin θ₁ sin θ₂ in the first row. What is that in short?",
    why="It is the cosine of a sum. In the picture it is link 2 with both turns: the matrices "
        "found the sum by themselves.",
    right="cos(θ₁ + θ₂)",
    options={"cos(θ₁ + θ₂)": "", "cos(θ₁ − θ₂)": "The cosine of a difference has a plus in it.",
             "sin(θ₁ + θ₂)": "A sine of a sum mixes sines with cosines."})
_SPECIAL = Choice(
    ask="All three formulas agree at θ₁ = 20°, θ₂ = 25°. What is special about this pose?",
    why="At 45° sine and cosine are equal, so a cosine in the place of a sine is not seen.",
    right="θ₁ + θ₂ = 45°",
    options={"θ₁ + θ₂ = 45°": "", "both angles are positive": "At 30° and 40° both are positive, "
             "and the printed formula is wrong there.",
             "l₁ is longer than l₂": "The slip is in the angles, not in the lengths.",
             "nothing, so all three are right": "Take θ₁ = 0, θ₂ = 0: the printed y is l₂ and not "
             "0."})


def _second(theta_1: float, theta_2: float, why: str, *slips: tuple) -> Direction:
    return Direction(
        ask="The upper left block of H₂⁰ holds x₂ and y₂, seen from frame 0. θ₁ goes to "
            f"{angle(theta_1)}, θ₂ to {angle(theta_2)}. Which way will y₂ point?",
        why=why, shows={"theta_1": theta_1, "theta_2": theta_2}, of="frame-2-y",
        begin=-45.0, slips=slips)


_SECOND = [
    _second(30, 60, "Frame 2 is turned by 30° + 60° = 90°, so y₂ is at 90° + 90° = 180°.",
            (90, "That is x₂. y₂ is 90° ahead of it."),
            (150, "That is a turn by θ₂ alone."), (120, "That is a turn by θ₁ alone.")),
    _second(-60, -30, "Frame 2 is turned by −60° − 30° = −90°, so y₂ is at −90° + 90° = 0°.",
            (-90, "That is x₂. y₂ is 90° ahead of it."),
            (60, "That is a turn by θ₂ alone."), (30, "That is a turn by θ₁ alone.")),
]
_MIDDLE = [
    Mark(ask="Link 1 lies along x₀; l₁ = 2 and l₂ = 1.5. M is the middle of link 2. θ₂ goes from "
             "25° to 90°. Where will M be?",
         why="M² = (0.75, 0) never changes. H₂⁰ turns it by 90° and adds P: M⁰ = (2, 0.75).",
         start={"theta_1": 0, "theta_2": 25}, shows={"theta_2": 90}, of="point-M", tolerance=0.15,
         slips=[((2, 1.5, 0), "That is Q."), ((0.75, 2, 0), "P = (2, 0) has been turned as well, "
                                                            "but it stands before joint 2."),
                ((2, -0.75, 0), "That is θ₂ = −90°, clockwise.")]),
    Mark(ask="The arm is straight, with l₁ = 2 and l₂ = 1.5. M is the middle of link 2. θ₁ goes "
             "from 30° to 90°. Where will M be?",
         why="Joint 1 turns all that comes after it. M is 2.75 from O, now straight up: "
             "M⁰ = (0, 2.75).",
         start={"theta_1": 30, "theta_2": 0}, shows={"theta_1": 90}, of="point-M", tolerance=0.15,
         slips=[((0, 3.5, 0), "That is Q."), ((2, 0.75, 0), "That turns joint 2, not joint 1."),
                ((0.75, 2, 0), "Link 2 rides on link 1, so it turns as well.")]),
]

# ---- Any number of links ----------------------------------------------------------------------

_PHI = Several(
    ask="φₖ is the angle of link k against x₀. Only θ₂ moves, from 40° to 80°. Which of them "
        "change?",
    why="θ₂ is part of φ₂ = θ₁ + θ₂ and of all that comes after it: φₖ = θ₁ + … + θₖ.",
    shows={"theta_2": 80}, right=("φ₂", "φ₃", "φ₄"),
    options={"φ₁": "Link 1 stands before joint 2.", "φ₂": "Joint 2 turns link 2.",
             "φ₃": "Link 3 hangs on link 2.", "φ₄": "Link 4 hangs on link 3, and that on link 2."})
_FLAT = {f"theta_{k}": 0 for k in range(1, 5)}
_END = [
    Mark(ask="All four links lie along x₀, each 1.2 long. Now θ₃ goes to 90°. Where will Q be?",
         why="Links 1 and 2 stay level and reach to x = 2.4. Links 3 and 4 turn together and stand "
             "upright: Q = (2.4, 2.4).",
         start=_FLAT, shows={"theta_3": 90}, of="point-Q", tolerance=0.25,
         slips=[((3.6, 1.2, 0), "Link 3 turns, and link 4 hangs on it: it turns as well."),
                ((1.2, 3.6, 0), "That is joint 2."), ((0, 4.8, 0), "That is joint 1.")]),
    Mark(ask="All four links lie along x₀, each 1.2 long. Now θ₂ goes to 90° and θ₃ to −90°. Where "
             "will Q be?",
         why="φ₂ = 90°, φ₃ = φ₄ = 90° − 90° = 0. Link 2 alone stands upright: Q = (3.6, 1.2).",
         start=_FLAT, shows={"theta_2": 90, "theta_3": -90}, of="point-Q", tolerance=0.25,
         slips=[((1.2, -1.2, 0), "That counts θ₃ from x₀. It is counted from link 2."),
                ((1.2, 3.6, 0), "That is without θ₃.")]),
]
_ANSWERS = Choice(
    ask="Link 2 is to point against x₀, and Q is to lie on y₀. Angles count modulo 360°. How many "
        "pairs (θ₁, θ₂) do that?",
    why="θ₁ + θ₂ = 180° fixes θ₂ once θ₁ is known. l₁ cos θ₁ = l₂ leaves two θ₁, one above x₀ and "
        "one below.",
    right="2",
    options={"1": "A cosine has the same value for θ₁ and for −θ₁.", "2": "",
             "4": "θ₂ = 180° − θ₁ leaves no choice for θ₂.",
             "as many as one likes": "Two conditions for two angles leave single answers."})

PREDICTIONS: dict[str, Asked] = {
    "two_link.tip": Asked(both_methods, _TIP),
    "two_link.bearing": Asked(both_methods, _BEARING),
    "two_link.origin": Asked(None, [_ORIGIN]),
    "two_link.sum": Asked(None, [_SUM]),
    "two_link.special": Asked(None, [_SPECIAL]),
    "two_link.second": Asked(both_methods, _SECOND),
    "two_link.middle": Asked(partial(both_methods, middle=True), _MIDDLE),
    "two_link.phi": Asked(n_links, [_PHI]),
    "two_link.end": Asked(n_links, _END),
    "two_link.answers": Asked(None, [_ANSWERS]),
}
