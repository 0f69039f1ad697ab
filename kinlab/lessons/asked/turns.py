"""Predictions of lesson 11, turns in space."""
from __future__ import annotations

from ...answers.prediction import Asked, Choice, Direction, Number
from ..views.turns import DIAGONAL, attitude_view, axis_view, books_view, gimbal_view
from . import angle, said

# ---- Fixed and moving axes ------------------------------------------------------------------

_ALONG_X, _ALONG_Y = 0.0, -90.0  # where covers point in the end: degrees from x₀ about z₀

_OWN = [
    Direction(
        ask="Book C is turned by 90° about its own z, then by 90° about its own x. Which way will "
            "its front cover, zC, point?",
        why="After the first turn xC points along y₀. The second turn is about that line, and "
            "takes the cover from z₀ to x₀.",
        start={"t": 0}, shows={"t": 2}, of="frame-C-z", begin=135.0,
        slips=[(_ALONG_Y, "There book A's cover points: its second turn is about x₀. Book C turns "
                          "about its own x, which has moved."),
               (180, "That is a turn the other way round. With the thumb along xC, which points "
                     "along y₀, the fingers go from z₀ to x₀.")]),
    Direction(
        ask="Book D is turned by 90° about its own x, then by 90° about its own z. Which way will "
            "its front cover, zD, point?",
        why="The first turn takes the cover from z₀ to −y₀. The second turn is about zD itself, "
            "which comes out of the cover: so the cover stays where it points.",
        start={"t": 0}, shows={"t": 2}, of="frame-D-z", begin=135.0,
        slips=[(_ALONG_X, "There book B's cover points: its second turn is about z₀. Book D turns "
                          "about its own z, which keeps its direction."),
               (90, "With the thumb along x, the fingers go from y to z, and on to −y.")]),
]

_SAME = Choice(
    ask="Book C was turned about its own axes: z, then x. Which turns about the axes of the room "
        "bring a book to the same place?",
    why="Rz Rx, read from the left to the right, is: own z, then own x. Read from the right to "
        "the left it is: x of the room, then z of the room. It is one and the same product.",
    start={"t": 0}, shows={"t": 2}, right="x, then z",
    options={"z, then x": "That is book A. Compare the covers of A and C.",
             "x, then z": "Book B ends like book C.",
             "there are none": "Compare the covers of B and C."})

# ---- Yaw, pitch, roll -----------------------------------------------------------------------


def _nose(pitch: float, where: str) -> Direction:
    return Direction(
        ask=f"Yaw and roll are 0. Pitch goes from 0 to {angle(pitch)}. Which way will the nose, "
            "x₁, point? Use your right hand: thumb along y₀.",
        why=f"Pitch is a turn about y. A positive one takes z to x and x to −z: the nose {where}.",
        start={"yaw": 0, "pitch": 0, "roll": 0}, shows={"yaw": 0, "pitch": pitch, "roll": 0},
        of="frame-1-x", about="y", begin=90.0,
        slips=[(90 - pitch, "With z up, a positive pitch takes the nose down, a negative one up."),
               (pitch, "The nose begins along x₀. Turn it from there.")])


_YAW = Choice(
    ask="The nose points 40° up, and one wing hangs. You drag yaw only. About which line does the "
        "aircraft turn?",
    why="R = Rz(yaw) Ry(pitch) Rx(roll). Yaw stands on the left: it is a turn about an axis of the "
        "room, whatever the other two are.",
    start={"yaw": 0, "pitch": -40, "roll": 30}, shows={"yaw": 70, "pitch": -40, "roll": 30},
    right="z₀, the vertical line",
    options={"z₀, the vertical line": "",
             "z₁, the line up from the cabin": "z₁ moves when yaw does. So it is not the axis.",
             "x₁, the line of the nose": "That is roll: it stands on the right."})

# ---- Gimbal lock ----------------------------------------------------------------------------

_UP = {"yaw": 0, "pitch": -90, "roll": 0}


def _instead(roll: float) -> Number:
    return Number(
        ask=f"Pitch is −90°, so the nose points straight up. Roll goes from 0 to {angle(roll)}. "
            "Which yaw, with roll still at 0, would have brought the aircraft to the same place?",
        why="The axis of roll, x₁, lies along the axis of yaw, z₀. Both angles turn the aircraft "
            "about one line, so only their sum counts.",
        start=_UP, shows=_UP | {"roll": roll}, right=roll, tolerance=2.0, unit="°", turn=360.0,
        slips=[(-roll, "x₁ points along z₀, not against it: both turn the same way."),
               (0, "With yaw = 0 and roll = 0 the aircraft has not turned.")])


_STUCK = Choice(
    ask="The nose points straight up, yaw and roll are 0. You take y₁, the axis along the left "
        "wing, by its tip, and pull it up. Which angle lifts it?",
    why="Roll turns about x₁, which points up now; yaw turns about z₀, which points up, too. Both "
        "swing the wing round, level. Pitch turns about the line of the wing itself.",
    start=_UP, shows=_UP | {"roll": 40}, right="none of them",
    options={"roll": "So it is in level flight. Here roll turns the wing about the vertical.",
             "yaw": "Yaw turns about z₀, the vertical: the tip stays at its height.",
             "pitch": "y₁ is the axis of pitch now. It stays.",
             "none of them": ""})

# ---- Axis and angle -------------------------------------------------------------------------

_DIAGONAL = dict(zip(("azimuth", "elevation"), DIAGONAL))

_ONE = Number(
    ask="Book C ends with x along y₀, y along z₀ and z along x₀. One single turn about the "
        "diagonal (1, 1, 1) does the same. By how many degrees? Hint: how often must you repeat it "
        "until all axes are back?",
    why="Each time every axis moves on to the next place. After three times all are back: three "
        "equal turns make 360°.",
    start=_DIAGONAL | {"angle": 0}, shows=_DIAGONAL | {"angle": 120}, right=120, tolerance=3,
    unit="°",
    slips=[(180, "Angles about different axes do not add up. Three of these turns make 360°."),
           (90, "Four turns by 90° make a whole one. Here three bring all axes back."),
           (240, "That is the same turn twice, or the way back.")])

_OPPOSITE = Choice(
    ask="A frame was turned by 60° about u. Which turn about the opposite axis, −u, gives the same "
        "place?",
    why="Seen along the opposite axis, counter-clockwise becomes clockwise.",
    start={"angle": 60}, right="by −60°",
    options={"by 60°": "That is the turn back: together they are none.",
             "by −60°": "",
             "by 120°": "Together with the turn back by 60° about u that would be 180°.",
             "by 180°": "Then u would have to be special. Look at x₁."})

# ---- Quaternions ----------------------------------------------------------------------------


def _w(degrees: float, right: float, slips: list) -> Number:
    return Number(
        ask=f"A frame turns by {angle(degrees)} about z. What is w, the first number of its "
            "quaternion?",
        why=f"w is the cosine of half the angle: cos {angle(degrees / 2)} = {said(right)}.",
        start={"azimuth": 0, "elevation": 90, "angle": 0},
        shows={"azimuth": 0, "elevation": 90, "angle": degrees}, right=right, tolerance=0.02,
        slips=slips)


_HALF = [
    _w(90, 0.7071, [(0, "That is the cosine of the whole angle. Take half of it."),
                    (1, "w = 1 is no turn at all.")]),
    _w(120, 0.5, [(-0.5, "That is the cosine of the whole angle. Take half of it."),
                  (0.866, "That is the sine of half the angle; it belongs to x, y, z.")]),
]

_ROUND = Choice(
    ask="The angle goes on from 0 to 360°, and the frame is back where it was. q began at "
        "(1, 0, 0, 0). Where is q now?",
    why="Half of 360° is 180°, and cos 180° = −1. After 720° q is back as well. Every turn has two "
        "quaternions, q and −q.",
    start={"angle": 0}, shows={"angle": 360}, right="(−1, 0, 0, 0)",
    options={"(1, 0, 0, 0)": "The frame is back; half the angle is only half-way round.",
             "(−1, 0, 0, 0)": "",
             "(0, 1, 0, 0)": "That is half a turn, about x.",
             "(0, 0, 0, 0)": "A quaternion of a turn has length 1."})

PREDICTIONS: dict[str, Asked] = {
    "turns.own": Asked(books_view, _OWN),
    "turns.same": Asked(books_view, [_SAME]),
    "turns.nose": Asked(attitude_view, [_nose(35, "sinks"), _nose(-60, "rises")]),
    "turns.yaw": Asked(attitude_view, [_YAW]),
    "turns.instead": Asked(gimbal_view, [_instead(50), _instead(-70)]),
    "turns.stuck": Asked(gimbal_view, [_STUCK]),
    "turns.one": Asked(axis_view, [_ONE]),
    "turns.opposite": Asked(axis_view, [_OPPOSITE]),
    "turns.half": Asked(axis_view, _HALF),
    "turns.round": Asked(axis_view, [_ROUND]),
}
