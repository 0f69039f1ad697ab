"""Lesson 05b, practice with the DH recipe: what it asks before its arms move.

Its exercises are numbered on from lesson 05; their judges are in `dh_recipe`.
"""
from __future__ import annotations

from collections.abc import Sequence
from math import pi

from ..answers.prediction import Asked, Choice, Direction, Mark, Number, Signs
from ..arms import robots
from ..arms.arm import Arm, to_modified
from ..arms.link import prismatic, revolute
from ..views.arm_view import ArmView
from .asked import angle

SHOWN = ("frames", "labels", "axes")

# ---- The cylindrical arm ----------------------------------------------------------------


def cylindrical_view() -> ArmView:
    """The cylindrical arm with all its frames and joint axes."""
    return ArmView(robots.cylindrical(), [0, 0.3, 0.4], show=SHOWN)


def textbook_arm() -> Arm:
    """The cylindrical arm with the frames of many textbooks: alpha_2 = -90 degrees, no offset."""
    links = [revolute(d=0.4), prismatic(alpha=-pi / 2, limits=(0.1, 0.6)),
             prismatic(limits=(0.1, 0.6))]
    return Arm(links, name="Cylindrical, textbook frames", unit="m", home=[0, 0.3, 0.3])


def _textbook_view() -> ArmView:
    return ArmView(textbook_arm(), [0, 0.3, 0.4], show=SHOWN)


_TABLE = Signs(
    ask="Which of the twelve numbers of the table are zero, which are constants, and which three "
        "are the joints?",
    why="θ₁ turns the column; d₂ and d₃ slide. Row 2 has 90° twice: from x₁ to x₂, and from z₁ to "
        "z₂.",
    rows=("link 1", "link 2", "link 3"), columns=("θ", "d", "a", "α"),
    right=("*c00", "c*0c", "0*00"),
    among={"*": "the joint variable", "c": "a constant that is not zero", "0": "zero"})


def _x_2(theta: float, why: str, slip: str = "There z₂ points, the direction of the reach.",
         ) -> Direction:
    return Direction(
        ask=f"x₂ is perpendicular to z₁ and to z₂. θ₁ goes to {angle(theta)}. Turn the arrow to "
            "where x₂ will point.",
        why=why, of="frame-2-x", about="z", begin=90, seen="top", slips=[(theta, slip)],
        start=dict(theta_1=0), shows=dict(theta_1=theta))


_X_2 = [_x_2(90, "The reach turned by 90° too: z₂ points along y₀, and x₂ a quarter turn on."),
        _x_2(-45, "θ₂ = 90°: x₂ is always a quarter turn on from x₁, which is at −45°."),
        _x_2(135, "θ₂ = 90°: x₂ is always a quarter turn on from x₁, which is at 135°.")]


def _height(start: float, end: float, reach: float, why: str,
            slip: tuple[tuple[float, float, float], str]) -> Mark:
    return Mark(
        ask=f"d₁ = 0.4 m. d₂ goes from {start:g} m to {end:g} m, and d₃ to {reach:g} m. Set the "
            "mark where O₂ will be.",
        why=why, of="frame-2-x", axes="xz", tolerance=0.06, seen="front", slips=[slip],
        start=dict(theta_1=0, d_2=start, d_3=0.4), shows=dict(d_2=end, d_3=reach))


_HEIGHT = [
    _height(0.1, 0.5, 0.4, "Two slides along one line add up: 0.4 + 0.5 = 0.9 m.",
            ((0, 0, 0.5), "The column's height d₁ counts as well.")),
    _height(0.5, 0.2, 0.6, "O₂ is on the column, at 0.4 + 0.2 = 0.6 m. d₃ moves O₃ only.",
            ((0.6, 0, 0.6), "That is O₃. O₂ does not move with d₃.")),
]


def _textbook(wanted: str, right: float, why: str) -> Number:
    return Number(
        ask="These are a textbook's frames of the same arm: θ₂ = 0, α₂ = −90°. At θ₁ = 0 it "
            f"reaches along y₀. With which θ₁ does it reach {wanted}?",
        why=why, right=right, tolerance=1, unit="°", turn=360,
        slips=[(right + 180, "That is the opposite direction."),
               (right + 90, "Our arm has that θ₁. The textbook counts from another zero.")],
        start=dict(theta_1=0), shows=dict(theta_1=right))


_TEXTBOOK = [
    _textbook("along x₀, as ours does at θ₁ = 0", -90, "A quarter turn back from y₀."),
    _textbook("along 30° from x₀ to y₀, as ours does at θ₁ = 30°", -60,
              "Each direction needs 90° less than in our table: 30° − 90°."),
    _textbook("along −x₀, as ours does at θ₁ = 180°", 90, "A quarter turn on from y₀."),
]

# ---- The exam arm -----------------------------------------------------------------------


def exam_view() -> ArmView:
    """The exam arm with its frames and joint axes, at θ₁ = θ₂* = 0."""
    return ArmView(robots.exam_2018(), [0, 0, 0.4], show=SHOWN)


def _modified_view() -> ArmView:
    return ArmView(to_modified(robots.exam_2018()), [0, 0, 0.4], show=SHOWN)


def _z_1(theta: float, why: str) -> Direction:
    return Direction(
        ask=f"z₁ lies along the level axis of joint 2. θ₁ goes from 0 to {angle(theta)}. Turn the "
            "arrow to where z₁ will point.",
        why=why, of="frame-1-z", about="z", begin=-90, seen="top",
        slips=[(theta, "There x₁ points. z₁ is a quarter turn behind it."),
               (theta + 90, "That is −z₁: the axis is right, its direction is the other one.")],
        start=dict(theta_1=0), shows=dict(theta_1=theta))


_Z_1 = [_z_1(60, "At θ₁ = 0 it points along −y₀, that is −90°. Joint 1 carries it 60° on."),
        _z_1(180, "At θ₁ = 0 it points along −y₀. Half a turn makes that y₀."),
        _z_1(-45, "At θ₁ = 0 it points along −y₀, that is −90°. Joint 1 carries it 45° back.")]


def _tip(theta: float, slide: float, why: str,
         slip: tuple[tuple[float, float, float], str]) -> Mark:
    return Mark(
        ask=f"θ₁ = 0, and z₁ points at you. θ₂* goes from 0 to {angle(theta)}, d₃ to {slide:g} m; "
            "d₁ is 0.5 m and a₂ 0.4 m. Set the mark where the tip will be.",
        why=why, axes="xz", tolerance=0.08, seen="front", slips=[slip],
        start=dict(theta_1=0, theta_2=0, d_3=0.4), shows=dict(theta_2=theta, d_3=slide))


_OTHER_WAY = "z₁ points at you, so a positive θ₂* turns anticlockwise."
_TIP = [
    _tip(90, 0.4, "a₂ lies to the left now, and the slide points up: (−0.4, −0.2, 0.5 + 0.4).",
         ((0.4, -0.2, 0.1), _OTHER_WAY)),
    _tip(90, 0.7, "a₂ lies to the left now, and the slide points up: (−0.4, −0.2, 0.5 + 0.7).",
         ((0.4, -0.2, -0.2), _OTHER_WAY)),
    _tip(-90, 0.4, "a₂ lies to the right now, and the slide points down: (0.4, −0.2, 0.5 − 0.4).",
         ((-0.4, -0.2, 0.9), _OTHER_WAY)),
]

# ---- The other order --------------------------------------------------------------------

_FIRST = [
    Choice(
        ask="Modified order, link 2: Rx(α₁) Tx(a₁) Rz(θ₂) Tz(d₂). About which axis does the "
            "travelling frame move first?",
        why="It lies on frame 1 at the beginning, and the first factor turns it about its x axis.",
        options={"about x₁": "",
                 "about z₁": "That is the standard order. Here the x pair is first.",
                 "about x₂": "The travelling frame is still on frame 1.",
                 "about z₂": "z₂ is reached by that first turn; it is not there yet."},
        right="about x₁"),
    Choice(
        ask="In the modified order θ₂ comes after the x pair. Which z axis lies on the axis of "
            "joint 2 then?",
        why="The x pair brings the frame onto the joint's axis, and θ₂ turns it about its own z "
            "there.",
        options={"z₁": "So it is in the standard order. Here z₁ lies on the axis of joint 1.",
                 "z₂": "", "z₃": "z₃ lies on the axis of joint 3."},
        right="z₂"),
]


def _o_2(theta: float, why: str, standard: tuple[float, float, float]) -> Mark:
    return Mark(
        ask=f"The modified frames of the exam arm. θ₁ = 0, and θ₂* goes from 0 to {angle(theta)}. "
            "Set the mark where O₂ will be.",
        why=why, of="frame-2-x", axes="xz", tolerance=0.08, begin=(-0.3, -0.2, 0.75), seen="front",
        slips=[(standard, "There the standard O₂ is, at the end of a₂.")],
        start=dict(theta_1=0, theta_2=0), shows=dict(theta_2=theta))


_O_2 = [_o_2(90, "It stays: frame 2 stands on the axis of joint 2 itself, before a₂, and a turn "
             "about an axis moves no point of it.", (-0.4, -0.2, 0.5)),
        _o_2(-90, "It stays on the axis of joint 2; a₂ belongs to the next row.",
             (0.4, -0.2, 0.5))]

_ROWS = {
    1: "Row 1 takes α and a from before joint 1: there is nothing, so both are 0.",
    2: "Row 2 holds the twist from z₁ to z₂, 90°, and the length from z₁ to z₂, 0.",
    3: "Row 3 holds the twist and the length from z₂ to z₃: 90° and a₂ = 0.4."}


def _row(rows: Sequence[str], wrong: int) -> Choice:
    listed = "; ".join(f"row {i}: {row}" for i, row in enumerate(rows, start=1))
    return Choice(
        ask="A student's modified table of the exam arm, in each row α, a, d, θ: "
            f"{listed}. Which row is wrong?",
        why=_ROWS[wrong],
        options={f"row {i}": "" if i == wrong else f"It is right. {said}"
                 for i, said in _ROWS.items()},
        right=f"row {wrong}")


_GOOD = ("0°, 0, 0.5, θ₁*", "90°, 0, 0.2, θ₂* + 90°", "90°, 0.4, d₃*, 90°")
_WRONG_ROW = [_row((_GOOD[0], "90°, 0.4, 0.2, θ₂* + 90°", _GOOD[2]), 2),
              _row(("90°, 0, 0.5, θ₁*", _GOOD[1], _GOOD[2]), 1),
              _row((_GOOD[0], _GOOD[1], "0°, 0, d₃*, 90°"), 3)]

# ---- Frames of one's own ----------------------------------------------------------------


def _turned(what: str, right: float, why: str, slip: str, unit: str = "°", turn: float = 360,
            tolerance: float = 1) -> Number:
    return Number(
        ask="Turn z₁ round: it points along +y₀ now. All x axes and origins stay. θ₁ = θ₂* = 0. "
            f"What is {what}?",
        why=why, right=right, tolerance=tolerance, unit=unit, turn=turn, slips=[(-right, slip)])


_TURNED = [
    _turned("α₁, the angle from z₀ to z₁ about x₁", -90,
            "About x₀ the right hand turns from z to −y. y is the other way.",
            "That is α₁ of the view, where z₁ points along −y₀."),
    _turned("d₂, from O₁ to x₂ along z₁", -0.2,
            "O₂ is at y = −0.2 m, against z₁ now.",
            "d₂ is measured along z₁, and z₁ points away from O₂ now.", "m", 0, 0.01),
    _turned("α₂, the angle from z₁ to z₂ about x₂", -90,
            "x₂ points up and z₂ along x₀: about z the right hand turns from x to y, and this is "
            "the way back.", "Thumb along x₂, that is up: which way from y₀ to x₀?"),
]


PREDICTIONS: dict[str, Asked] = {
    "dh_practice.table": Asked(cylindrical_view, [_TABLE]),
    "dh_practice.x2": Asked(cylindrical_view, _X_2),
    "dh_practice.height": Asked(cylindrical_view, _HEIGHT),
    "dh_practice.textbook": Asked(_textbook_view, _TEXTBOOK),
    "dh_practice.z1": Asked(exam_view, _Z_1),
    "dh_practice.tip": Asked(exam_view, _TIP),
    "dh_practice.first": Asked(None, _FIRST),
    "dh_practice.o2": Asked(_modified_view, _O_2),
    "dh_practice.row": Asked(None, _WRONG_ROW),
    "dh_practice.turned": Asked(exam_view, _TURNED),
}
