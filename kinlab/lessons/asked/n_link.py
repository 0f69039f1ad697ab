"""Predictions of lesson 06, Practical 3."""
from __future__ import annotations

from functools import partial

import numpy as np

from ...answers.prediction import Asked, Choice, Direction, Mark, Number, Several
from ...arms import robots
from ..views.four_motions import four_motions
from ..views.n_link import (
    both_conventions,
    flat_view,
    misread,
    six_view,
    two_link,
    two_view,
    zyz_view,
)
from . import said

# ---- One link ---------------------------------------------------------------------------


def _signed(length: float) -> str:
    return f"{length:.2f}".replace("-", "−")


def _slide(alpha: float, d: float, place: tuple, slips: list) -> Mark:
    a = 0.8
    up = ((a, 0.0, d), "That is straight up. The slide goes along z of the frame that moves, and "
                       "α has tilted it.")
    return Mark(
        ask=f"Three motions are done: a turn about x by α = {said(alpha)}°, a slide along x, a "
            f"turn about z. The last one is a slide along z by d = {said(d)} m. Where will the "
            "frame's origin be?",
        why="The slide goes along the tilted z₁ = (0, −sin α, cos α): it adds "
            f"{_signed(place[1])} m in y and {_signed(place[2])} m in z, so d enters rows 2 and 3.",
        start={"alpha": alpha, "d": d, "a": a, "motion": 3}, shows={"motion": 4},
        of="tip", axes="yz", seen="side", tolerance=0.2, slips=[up, *slips])


def _hint() -> Several:
    return Several(
        ask="Compare the printed hint with the matrix that we derived. Which of these differ?",
        options={"the entry in row 1, column 4": "Both have a of the row before.",
                 "the entry in row 2, column 3": "Both have −sin α of the row before.",
                 "the entry in row 3, column 3": "Printed is the cosine of αᵢ; ours has that of "
                                                 "αᵢ₋₁.",
                 "the entry in row 3, column 4": "Both have d cos α, with α of the row before.",
                 "the number of rows": "The hint has three; the row 0 0 0 1 is missing."},
        right=("the entry in row 3, column 3", "the number of rows"),
        why="In every other entry the two agree.")


def _flat(twist: float, height: float) -> Mark:
    return Mark(
        ask="A cube 1 m high stands on the ground. Take the printed matrix with αᵢ₋₁ = 0° and "
            f"αᵢ = {said(twist)}°: its entry (3, 3) is cos {said(twist)}°. Where does it take the "
            "corner P = (0.5, −0.5, 1)?",
        why=f"Every height is multiplied by cos {said(twist)}° = {said(height)}; x and y stay. "
            + ("The cube is pressed flat, and no inverse brings it back." if height == 0 else
               "A matrix that moves a rigid link would leave the cube as it is."),
        start={"alpha_i": 0, "theta_i": 0}, shows={"alpha_i": twist}, of="point-P", axes="xz",
        seen="front", tolerance=0.12,
        slips=[((0.5, -0.5, 1.0), "That is where P is now. Row 3 of the matrix multiplies its "
                                  "height by the cosine.")])


# ---- Two links --------------------------------------------------------------------------

_FROM_ROOM = "You counted θ₂ from the x axis of the room. It is counted from link 1."


def _tip(theta_1: float, theta_2: float, why: str, slip: tuple) -> Mark:
    return Mark(
        ask=f"The arm goes to θ₁ = {said(theta_1)}°, θ₂ = {said(theta_2)}°. Both links are 1 m "
            "long. Where is the tip then?",
        why=why, shows={"theta_1": theta_1, "theta_2": theta_2}, of="tip", axes="xy",
        tolerance=0.2, slips=[slip])


def _second(theta_1: float, theta_2: float, elbow: tuple, tip: tuple) -> Mark:
    return Mark(
        ask="The table is modified: frame i sits at the near end of link i. Where is the origin of "
            f"frame 2 at θ₁ = {said(theta_1)}°, θ₂ = {said(theta_2)}°?",
        why=f"Link 2 begins at the elbow, ({said(elbow[0])}, {said(elbow[1])}): its length stands "
            "in no row, it is the tool.",
        shows={"theta_1": theta_1, "theta_2": theta_2}, of="frame-2-x", axes="xy", tolerance=0.2,
        begin=(0.5, 0.5, 0.0),
        slips=[((*tip, 0.0), "That is the tip. In a modified table frame 2 sits at the near end of "
                             "link 2."),
               ((0.0, 0.0, 0.0), "That is frame 1: link 1 begins at the base.")])


def _header(theta_2: float, true_tip: tuple) -> Mark:
    return Mark(
        ask="The thin line is the arm as a standard table would mean it: link 1 has no length, and "
            f"a₁ = 1 m belongs to link 2. θ₁ stays at 30°. Where will its tip "
            f"p′ be at θ₂ = {said(theta_2)}°?",
        why="Both joints of the misread arm sit at the base, and its two lengths make one rigid "
            f"bar of 2 m. It points at θ₁ + θ₂ = {said(30 + theta_2)}°.",
        start={"theta_1": 30, "theta_2": 45}, shows={"theta_2": theta_2}, of="point-p′", axes="xy",
        tolerance=0.3,
        slips=[((*true_tip, 0.0), "That is the tip of the real arm. In the misread one, joint 2 "
                                  "sits at the base.")])


# ---- Six links --------------------------------------------------------------------------

_ZERO = {f"theta_{k}": 0 for k in range(1, 7)}
_GIVEN = _ZERO | {"theta_2": 90, "theta_3": -90}
_REGULAR = dict(zip(_ZERO, (30, 40, -20, 50, 60, 70)))


def _given(theta_2: float, theta_3: float, why: str, slips: list,
           begin: tuple[float, float, float] | None = None) -> Mark:
    return Mark(
        ask="You see the arm at q = 0, from the front: z₂ and z₃ point towards you. θ₂ turns to "
            f"{said(theta_2)}°, θ₃ to {said(theta_3)}°, the others stay at 0°. a₂ = 0.5 m, d₄ = d₆ "
            "= 1 m. Where is the tip then?",
        why=why, start=_ZERO, shows={"theta_2": theta_2, "theta_3": theta_3}, of="tip", axes="xz",
        seen="front", tolerance=0.3, begin=begin, slips=slips)


def _tool(theta_5: float, degrees: float, way: str) -> Direction:
    return Direction(
        ask="The arm stands as given, straight up. z₅ points towards you in this picture. Only "
            f"θ₅ turns, to {said(theta_5)}°. Which way will z₆, the tool, point? "
            "(0° is up, 90° along x₀.)",
        why=f"A right-handed turn by {said(theta_5)}° about z₅ = (0, −1, 0) takes z₆ from straight "
            f"up to {way}.",
        start=_GIVEN, shows={"theta_5": theta_5}, of="frame-6-z", about="y", seen="front",
        slips=[(-degrees, "That is a turn the other way. The thumb of your right hand points along "
                          "z₅, towards you; the fingers show a positive turn.")])


_BOTTOM = Choice(
    ask="The practical writes the bottom row of T as [oᵀ 1], after o has just been the origin of "
        "frame 6. What is oᵀ?",
    options={"the origin, as a row": "Multiply: the tip's last component would not be 1.",
             "three zeros": "",
             "it does not matter": "It does: the row gives the last component of every point."},
    right="three zeros",
    why="A point ends in 1, before and after: only the row 0 0 0 1 leaves that 1 alone.")

_WRIST = Several(
    ask="Which joints can move the wrist, the origin of frame 6?",
    options={"θ₁": "Joint 1 turns the whole arm about z₀.",
             "θ₂": "Joint 2 swings upper arm and forearm.",
             "θ₃": "Joint 3 swings the forearm.",
             "θ₄": "Joint 4 turns about the forearm, and the wrist lies on that line.",
             "θ₅": "Joint 5 has its axis through the wrist.",
             "θ₆": "Joint 6 has its axis through the wrist."},
    right=("θ₁", "θ₂", "θ₃"),
    why="The axes of joints 4, 5 and 6 all go through the wrist, so they only turn the tool.",
    start=_REGULAR, shows={"theta_4": -40, "theta_5": -50, "theta_6": -20})

# ---- Two conventions --------------------------------------------------------------------

_TURNING = Several(
    ask="Frames with a prime are those of a standard table. Only θ₂ will move. Which frames turn?",
    options={"frame 1": "It rides on link 1, and link 1 stands still.",
             "frame 1′": "It sits at the elbow, but it rides on link 1.",
             "frame 2": "It rides on link 2.",
             "frame 2′": "It rides on link 2, at its far end."},
    right=("frame 2", "frame 2′"),
    why="Frame i and frame i′ ride on the same link i: one at its near end, one at its far end.",
    start={"theta_1": 30, "theta_2": 45}, shows={"theta_2": 100})


def _far_axis(theta_3: float, degrees: float, near: str) -> Direction:
    return Direction(
        ask="Frames 3 and 3′ share their origin. z₃ is the axis of joint 3, z₃′ that of joint 4, "
            f"the line of the forearm. θ₂ stays at 45°, θ₃ goes to {said(theta_3)}°. Which way "
            "will z₃′ point? (0° is up, 90° along x₀.)",
        why=f"The forearm leans by θ₂ + θ₃ = {said(45 + theta_3)}° about an axis that points "
            f"towards you: {near}. z₃ itself does not move.",
        start={"theta_1": 0, "theta_2": 45, "theta_3": -75}, shows={"theta_3": theta_3},
        of="frame-3′-z", about="y", seen="front", begin=30.0,
        slips=[(-degrees, "That is the lean to the other side: a positive turn about z₃, which "
                          "points towards you, is counter-clockwise.")])


def _six_ends() -> object:
    return both_conventions(robots.practical_six_link(), 3,
                            q=np.radians([0, 45, -75, 0, 40, 0]))


# ---- ZYZ angles -------------------------------------------------------------------------


def _sum(phi: float, psi: float) -> Direction:
    return Direction(
        ask=f"φ = {said(phi)}° and ψ = {said(psi)}°. θ goes from 50° to 0°. Which way will x "
            "point, in degrees from x₀?",
        why=f"At θ = 0 both turns are about z₀ and add up: {said(phi)}° {'−' if psi < 0 else '+'} "
            f"{said(abs(psi))}° = {said(phi + psi)}°. Only their sum can be seen.",
        start={"phi": phi, "theta": 50, "psi": psi}, shows={"theta": 0}, of="frame--x",
        about="z", seen="top", tolerance=10,
        slips=[(phi, "That is φ alone. ψ turns about the same axis once θ is 0."),
               (phi - psi, "Both turns are about z₀: add them, each with its own sign."),
               (psi, "That is ψ alone; φ came first, about the same axis.")])


_BASE = Several(
    ask="Only joint 1, the base, turns: one more turn about z₀, on the left of R. Which of the ZYZ "
        "angles change?",
    options={"φ": "φ is the first turn, about z₀: the base adds to it.",
             "θ": "θ is the angle between z₀ and the tool's z; the base does not change it.",
             "ψ": "ψ is the last turn, about the tool's own z; the base does not touch it."},
    right=("φ",),
    why="Rz(θ₁) Rz(φ) Ry(θ) Rz(ψ): the first two are turns about one axis and add up in φ.")

_TRAP = Number(
    ask="R is the identity. A program takes φ = atan2(0, 0) = 0 and ψ = atan2(r₃₂, −r₃₁). Here r₃₁ "
        "is 0. What does the program say for ψ, in degrees?",
    right=180.0, tolerance=1.0, unit="°", turn=360.0,
    slips=[(0.0, "So one should think. But the computer's −r₃₁ is −0.0, a zero with a sign.")],
    why="In floating point −r₃₁ is −0.0, and atan2(0, −0.0) is π: the formula answers where it has "
        "no meaning.")


def _regular_six() -> object:
    return six_view(np.radians(list(_REGULAR.values())))


PREDICTIONS: dict[str, Asked] = {
    "n_link.slide": Asked(partial(four_motions, "modified"), [
        _slide(60, 1, (0.8, -0.866, 0.5), [((0.8, 0.866, 0.5), "That is the tilt to the other "
                                            "side: a positive turn about x takes z towards −y.")]),
        _slide(-90, 0.8, (0.8, 0.8, 0.0), [((0.8, -0.8, 0.0), "The turn is by −90°: it takes z "
                                            "towards +y.")]),
        _slide(150, 1, (0.8, -0.5, -0.866), [((0.8, 0.5, -0.866), "A positive turn about x takes z "
                                              "towards −y first, then down.")])]),
    "n_link.hint": Asked(None, [_hint()]),
    "n_link.flat": Asked(flat_view, [_flat(60, 0.5), _flat(90, 0)]),
    "n_link.two": Asked(two_view, [
        _tip(0, 90, "Link 1 lies along x, link 2 stands across it: 1 m right, 1 m up.",
             ((1, -1, 0), "A positive angle turns counter-clockwise, from x towards y.")),
        _tip(90, 90, "Link 1 points up; link 2 is turned by 90° more and points to −x.",
             ((0, 2, 0), _FROM_ROOM)),
        _tip(90, -90, "Link 1 points up, link 2 back to the right: the tip of θ = (0°, 90°) by "
                      "another way.", ((0, 0, 0), _FROM_ROOM))]),
    "n_link.elbow": Asked(two_view, [
        _second(0, 90, (1, 0), (1, 1)), _second(90, 60, (0, 1), (-0.866, 1.5))]),
    "n_link.header": Asked(partial(misread, two_link(), np.radians([30, 45])), [
        _header(120, (0.0, 1.0)), _header(-30, (1.866, 0.5))]),
    "n_link.six": Asked(six_view, [
        _given(90, -90, "Upper arm, forearm and tool all point straight up: 0.5 + 1 + 1 = 2.5 m.",
               [((0.0, 0.5, 2.0), "The upper arm stands up as well: add its 0.5 m."),
                ((0.0, 0.5, 1.5), "That is the wrist; the tool is 1 m longer.")]),
        _given(90, 0, "The forearm leans with the upper arm: forearm and tool lie level, 2 m "
                      "towards −x, at the height of the elbow, 0.5 m.",
               [((2.0, 0.5, 0.5), "The other way: a positive turn about z₂, which points towards "
                                  "you, takes “up” to the left."),
                ((0.0, 0.5, 2.5), "That is the arm with θ₃ = −90°.")]),
        _given(45, -45, "The upper arm rises at 45°: 0.35 m out and 0.35 m up. θ₃ takes the turn "
                        "back, so forearm and tool point straight up.",
               [((0.0, 0.5, 2.5), "The upper arm stands only half way up, at 45°.")],
               begin=(1.0, 0.5, 1.0))]),
    "n_link.tool": Asked(six_view, [
        _tool(90, -90, "the left, −x₀"), _tool(-90, 90, "the right, +x₀"),
        _tool(45, -45, "half way between up and −x₀")]),
    "n_link.bottom": Asked(None, [_BOTTOM]),
    "n_link.wrist": Asked(_regular_six, [_WRIST]),
    "n_link.turning": Asked(partial(both_conventions, two_link(), 1, 2,
                                    q=np.radians([30, 45])), [_TURNING]),
    "n_link.ends": Asked(_six_ends, [
        _far_axis(-20, -25, "25° to the left of straight up"),
        _far_axis(-135, 90, "level, along x₀")]),
    "n_link.zyz": Asked(zyz_view, [_sum(40, 30), _sum(110, -30), _sum(-50, 20)]),
    "n_link.base": Asked(None, [_BASE]),
    "n_link.trap": Asked(None, [_TRAP]),
}
