"""Appendix, the lectures' misprints: what it asks, its exercises' references and slips."""
from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from ..answers.conditions import exactly, one_of_many
from ..answers.judges import Judge, choices, expressions
from ..answers.prediction import Asked, Mark, Number
from ..arms import robots
from ..arms.arm import Arm
from ..arms.link import revolute
from ..views.arm_view import ArmView
from .asked import angle
from .rotation import riding_view
from .views.homogeneous import order

# ---- Predictions ------------------------------------------------------------------------


def _two_link() -> ArmView:
    return ArmView(robots.two_link(), np.radians([40, 50]))


def misread_bar() -> ArmView:
    """The two-link table under the printed header: link 1 has no length, link 2 has a₁."""
    return ArmView(Arm([revolute(), revolute(a=1)], name="Two-link, misread", unit="m"), [0, 0])


def _ride(turn: float, why: str, slip: str) -> Mark:
    return Mark(ask=f"Frame 1 turns to θ = {turn:g}°. Set the mark where c will be in the room.",
                why=why, of="point-c", tolerance=0.2, slips=[((1.2, 0.5, 0), slip)],
                start=dict(theta=0), shows=dict(theta=turn))


_LEFT_OUT = "That is the printed chain: it leaves c as it was."
_CHAIN = [
    _ride(90, "A quarter turn takes (x, y) to (−y, x): c⁰ = R₁⁰ c¹ = (−0.5, 1.2).", _LEFT_OUT),
    _ride(180, "Half a turn takes (x, y) to (−x, −y): c⁰ = R₁⁰ c¹ = (−1.2, −0.5).", _LEFT_OUT),
]


def _tip(angles: tuple[float, float], where: str, why: str, printed: tuple[float, float]) -> Mark:
    return Mark(ask=f"Both links are 1 m long. The joints go to {where}. Set the mark where the "
                    "tip will be.", why=why, tolerance=0.15,
                slips=[((*printed, 0), "That is what the printed formula says.")],
                shows=dict(zip(("theta_1", "theta_2"), angles)))


_TIP = [
    _tip((0, 0), "0° and 0°", "The arm lies along x: height 0. The printed formula has height 1.",
         (2, 1)),
    _tip((90, 0), "90° and 0°", "The arm stands upright: height 2. The printed formula has height "
         "1 + cos 90° = 1.", (0, 1)),
]


def _bar(angles: tuple[float, float], where: str, why: str, right: tuple[float, float]) -> Mark:
    return Mark(ask=f"The misread arm: joint 2 stands where joint 1 stands. The joints go to "
                    f"{where}. Set the mark where the tip will be.", why=why, tolerance=0.12,
                slips=[((*right, 0), "There the right arm has its tip. This arm has one link.")],
                start=dict(theta_1=0, theta_2=0), shows=dict(zip(("theta_1", "theta_2"), angles)))


_BAR = [
    _bar((0, 90), "0° and 90°", "Both joints turn about one point: the tip stays 1 m from it.",
         (1, 1)),
    _bar((90, 90), "90° and 90°", "The two turns add up to 180°, and the tip stays 1 m from the "
         "base.", (-1, 1)),
]

_ORDER = [Mark(
    ask="Frame B turns by 60° about its z first, then it slides by 2 along its own x. Set the mark "
        "where its origin will be.",
    why="The turned x axis points to 60°, and the slide goes that way: (2 cos 60°, 2 sin 60°).",
    of="frame-B-x", tolerance=0.2, start=dict(t=0), shows=dict(t=2),
    slips=[((2, 0, 0), "That is frame A: it slides first.")])]


def _determinant(after: float, value: float, why: str) -> Number:
    return Number(ask=f"α before the link is 0°, α after it is {angle(after)}. The page puts the "
                      "cosine of the wrong one into entry (3,3). What is the determinant of "
                      "that matrix?",
                  why=why, right=value, tolerance=0.01,
                  slips=[(1, "That is the determinant of a rotation; this matrix is none.")])


_HINT = [
    _determinant(-90, 0, "Row 3 is (0, 0, cos α). With cos(−90°) = 0 the whole row is zero."),
    _determinant(60, 0.5, "Row 3 is (0, 0, cos α). So the determinant is cos 60°."),
]


def _atan2(y: str, x: str, right: float, why: str) -> Number:
    return Number(ask=f"A zero in a computer can carry a sign. What is atan2({y}, {x})?",
                  why=why, right=right, tolerance=0.5, unit="°",
                  slips=[(180 - right, "Look at the sign of the second zero.")])


_ZERO = [
    _atan2("0", "−0", 180, "The sign says from which side x came to zero: from the left, so 180°."),
    _atan2("0", "0", 0, "Both zeros are positive: as for (0, small x), the angle is 0°."),
]

PREDICTIONS: dict[str, Asked] = {
    "errata.chain": Asked(riding_view, _CHAIN),
    "errata.tip": Asked(_two_link, _TIP),
    "errata.hint": Asked(None, _HINT),
    "errata.bar": Asked(misread_bar, _BAR),
    "errata.zero": Asked(None, _ZERO),
    "errata.order": Asked(order, _ORDER),
}

# ---- Exercises ----------------------------------------------------------------------------


def _column(theta: float, d: float, a: float, alpha: float) -> list[float]:
    return [a * cos(theta), a * sin(theta), d]


_LINKS = [dict(theta=0.4, d=0.3, a=0.7, alpha=1.1), dict(theta=-1.2, d=-0.5, a=0.9, alpha=0.6),
          dict(theta=2.0, d=1.3, a=0.2, alpha=-0.8)]
_COLUMN_SLIPS = [
    ("The turn by alpha comes last and moves no origin: no alpha in this column.",
     lambda t, d, a, al: [a * cos(t), a * sin(t) * cos(al), d]),
    ("This is the printed entry; a lies along x after the turn by theta, so a sin(theta).",
     lambda t, d, a, al: [a * cos(t), a * cos(t) * sin(al), d]),
    ("Sine and cosine have changed places.", lambda t, d, a, al: [a * sin(t), a * cos(t), d]),
    ("This is the last column of the modified matrix.",
     lambda t, d, a, al: [a, -d * sin(al), d * cos(al)]),
    ("a and d have changed places.", lambda t, d, a, al: [d * cos(t), d * sin(t), a]),
    ("a lies along x after the turn by theta: its parts are a cos(theta) and a sin(theta).",
     lambda t, d, a, al: [a, 0, d]),
    ("The sign of theta is wrong.", lambda t, d, a, al: [a * cos(t), -a * sin(t), d]),
    ("d is the third component: it is a slide along the old z.",
     lambda t, d, a, al: [a * cos(t), a * sin(t), 0]),
    ("d lies along the old z, which alpha does not tilt: alpha comes last.",
     lambda t, d, a, al: [a * cos(t), a * sin(t), d * cos(al)]),
    ("Theta and alpha have changed places.", lambda t, d, a, al: [a * cos(al), a * sin(al), d]),
    ("This is the first column of the rotation; the last column holds the slides.",
     lambda t, d, a, al: [cos(t), sin(t), 0]),
]


_four_twists = exactly((4,), "four angles in radians")


def _in_radians(twists: np.ndarray) -> str:
    """Equal angles in degrees have equal cosines in radians, too: nothing else would tell."""
    far = np.flatnonzero(np.abs(twists) > 2 * pi)
    if not len(far) or not np.allclose(twists, np.round(twists, 1), rtol=0, atol=1e-9):
        return ""
    return (f"alpha_{far[0]} is {twists[far[0]]:g}. That looks like degrees: write "
            "np.radians([...]).")


def _none_zero(twists: np.ndarray) -> str:
    zero = np.flatnonzero(np.abs(np.sin(twists / 2)) < 1e-9)
    return f"alpha_{zero[0]} is zero, or a full turn." if len(zero) else ""


def _hidden(twists: np.ndarray) -> str:
    shown = np.flatnonzero(np.abs(np.diff(np.cos(twists))) > 1e-9)
    if not len(shown):
        return ""
    i = shown[0] + 1
    return (f"In link {i} the entry should be cos(alpha_{i - 1}) = {np.cos(twists[i - 1]):.3f}, "
            f"but the page prints cos(alpha_{i}) = {np.cos(twists[i]):.3f}.")


_TWIST_SLIPS = [
    ("Different twists can hide it, too, but their cosines must be equal.",
     lambda twists: len(np.unique(np.round(np.abs(twists), 9))) == 4),
]

JUDGES: dict[str, Judge] = {
    "errata.1": choices(
        {"wrong lines": {3, 4}}, {1, 2, 3, 4},
        {("wrong lines", 1): "Try both joints at zero, then at 90°.",
         ("wrong lines", 2): "Multiply the two rotations.",
         ("wrong lines", 3): "Multiply it by H and look at the last column.",
         ("wrong lines", 4): "Where is the origin after each?"},
        noun="line", praise="Two lines are right, and two fail a small test."),
    "errata.2": expressions(
        ("p_x", "p_y", "p_z"), _column, _LINKS, constants={}, slips=_COLUMN_SLIPS,
        praise="The last column holds no alpha."),
    "errata.3": one_of_many(
        _four_twists, (_in_radians, _none_zero, _hidden), slips=_TWIST_SLIPS, noun="four twists",
        praise="Equal cosines hide the slip, in every pose. A test needs a case that can fail."),
}
