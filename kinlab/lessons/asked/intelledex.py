"""Predictions of lesson 08, the Intelledex 660T."""
from __future__ import annotations

from ...answers.prediction import Asked, Choice, Direction, Mark, Number, Several, Signs
from ...arms import robots
from ...views.live import LiveView
from ...views.studies import velocity_view
from ..views.intelledex import (
    meeting_view,
    names_view,
    pitch_view,
    plane_view,
    wrist_view,
    yaw_view,
)


def _at(*degrees: float) -> dict[str, float]:
    return {f"theta_{k}": value for k, value in enumerate(degrees, start=1)}


_HOME = _at(90, -90, 90, 0, 90, 0)

# ---- Section 1: axes and frames -----------------------------------------------------------------

_AXES = Several(
    ask="The arm is at soft home, stretched out level. Which of its joint axes lie along the line "
        "in which it is stretched?",
    why="A roll turns about the arm's own length: the shoulder roll z₁ and the tool roll z₅ lie in "
        "one line here. The pitches lie across the arm, and the base axis stands upright.",
    options={"z₀, the base": "It stands upright: it is the column.",
             "z₁, the shoulder roll": "A roll turns about the arm's own length.",
             "z₂, the shoulder pitch": "A pitch bends the arm, so its axis lies across it.",
             "z₄, the tool pitch": "A pitch bends the arm, so its axis lies across it.",
             "z₅, the tool roll": "A roll turns about the tool's own length."},
    right=("z₁, the shoulder roll", "z₅, the tool roll"))


def _rolled(to: float, where: str, slip: float, other: str) -> Direction:
    return Direction(
        ask="Now z₄, the axis of the tool pitch, points to the right, along −y₀. The shoulder roll "
            f"θ₂ goes from −90° to {to:g}°. Which way will z₄ point?".replace("-", "−"),
        why=f"All three pitch axes roll with the shoulder: they stand upright now, and z₄ points "
            f"{where}. A pitch about an upright axis is a yaw.",
        of="frame-4-z", about="x", begin=180, start=_HOME, shows={"theta_2": to},
        slips=[(slip, other), (180, "The shoulder roll carries all that comes after it.")])


_ROLL = [_rolled(0, "down", 90, "It is upright, but the other way round: by the right hand about "
                 "z₁, which points out along the arm, −y₀ turns towards −z₀."),
         _rolled(-180, "up", -90, "It is upright, but the other way round: a negative angle turns "
                 "back, by the left hand about z₁.")]

_FREE = Several(
    ask="Turn z₂, z₃ and z₄ round and keep every x axis. Which twists change their sign, and which "
        "joints count backwards?",
    why="A twist changes its sign where one of its two z axes has turned round and the other has "
        "not: at α₂ and α₅. The joints 3, 4 and 5 turn about z₂, z₃ and z₄.",
    options={"α₁": "It leads from z₀ to z₁, and both are as they were.",
             "α₂": "It leads from z₁, as it was, to z₂, turned round.",
             "α₅": "It leads from z₄, turned round, to z₅, as it was.",
             "joint 2": "Joint 2 turns about z₁.",
             "joints 3, 4 and 5": "They turn about z₂, z₃ and z₄.",
             "joint 6": "Joint 6 turns about z₅."},
    right=("α₂", "α₅", "joints 3, 4 and 5"))

# ---- Sections 3 and 4: u, v, w, and soft home ---------------------------------------------------

_SUMS = Choice(
    ask="Which angles will appear in the arm matrix only as a sum?",
    why="Turns about parallel axes add up: z₂, z₃ and z₄ are parallel, so θ₃, θ₄ and θ₅ become "
        "C₃₄₅ and S₃₄₅.",
    options={"θ₁ and θ₂": "z₀ and z₁ are at a right angle; such turns do not add up.",
             "θ₂ and θ₃": "z₁ and z₂ are at a right angle; such turns do not add up.",
             "θ₃, θ₄ and θ₅": "",
             "θ₅ and θ₆": "z₄ and z₅ are at a right angle; such turns do not add up."},
    right="θ₃, θ₄ and θ₅")

_PLANE = [
    Direction(
        ask="θ₁ = 0° and θ₂ = 0°: u points along x₀. The shoulder rolls to θ₂ = 90°, about v. "
            "Which way will u point?",
        why="u = (C₁C₂, S₁C₂, S₂) = (0, 0, 1). Here v points along −y₀, and by the right hand "
            "about it a positive roll lifts u.",
        of="u", about="y", begin=90, start=_at(0, 0), shows={"theta_2": 90},
        slips=[(180, "v = (0, −1, 0) here. By the right hand about v, x₀ turns up, not down.")]),
    Direction(
        ask="θ₁ = 0°: v points to the right, along −y₀. The base turns to θ₁ = 90°. Which way will "
            "v, the roll axis, point?",
        why="v = (S₁, −C₁, 0) = (1, 0, 0). The base turns all that it carries by 90°, from −y₀ to "
            "x₀.",
        of="v", about="z", begin=-90, start=_at(0, 0), shows={"theta_1": 90},
        slips=[(180, "Seen from above, a positive turn goes to the left: −y₀ comes to x₀.")]),
]

_SOFT = [
    Mark(ask="The joints go to soft home, q = (90°, −90°, 90°, 0°, 90°, 0°), where the arm is "
             "stretched along x₀. Column 373.4, links 304.8 each, tool 228.6 mm. Where will the "
             "tip be?",
         why="304.8 + 304.8 + 228.6 = 838.2 mm out, at the height of the shoulder, 373.4 mm.",
         start=_at(90, -90, 30, 70, 60, 0), shows=_HOME, seen="front", axes="xz", tolerance=60,
         slips=[((838.2, 0, 0), "The arm begins at the shoulder, on top of a column of 373.4 mm."),
                ((609.6, 0, 373.4), "That is the wrist: the tool goes on for 228.6 mm.")]),
    Mark(ask="From soft home the shoulder pitch alone goes from θ₃ = 90° to 180°. It lifts the "
             "arm, straight as it is. Where will the tip be?",
         why="Straight up over the shoulder: 373.4 + 838.2 = 1211.6 mm.",
         start=_HOME, shows={"theta_3": 180}, seen="front", axes="xz", tolerance=80,
         slips=[((0, 0, 838.2), "The arm is lifted at the shoulder, which is 373.4 mm up.")]),
]

# ---- Section 5: yaw and rank --------------------------------------------------------------------


def _yawed(to: float, side: str, slip: float) -> Direction:
    return Direction(
        ask="The shoulder has been rolled by 90°, to θ₂ = 0°. The tool points along x₀. Now θ₅, "
            f"the tool pitch, goes from 90° to {to:g}°. Which way will the tool, z₆, point?",
        why=f"To the {side}: the axis of the tool pitch stands upright and points down, so the "
            "tool swings level. A pitch joint has done the work of a yaw joint.",
        of="frame-6-z", about="z", begin=0, start=_HOME | {"theta_2": 0}, shows={"theta_5": to},
        slips=[(slip, "It swings level, but to the other side: z₄ points down, so θ₅ counts "
                "clockwise, seen from above.")])


_YAW = [_yawed(0, "left", -90), _yawed(180, "right", 90)]

_ROWS, _COLUMNS = ("along x₀", "along y₀", "along z₀"), tuple("J₁ J₂ J₃ J₄ J₅ J₆".split())
_NEVER = {"0": "does not move the tip this way", "×": "moves it"}

_MOVERS = Signs(
    ask="The arrows at the tip show its velocity when one joint alone turns at 1 rad/s. Now the "
        "arm is bent. It goes to soft home, stretched along x₀. Which joint will move the tip "
        "along x₀, y₀, z₀ there?",
    why="A turn moves the tip at right angles to the line from its axis. All axes meet the line of "
        "the stretched arm, so none moves the tip along x₀.",
    rows=_ROWS, columns=_COLUMNS, right=("000000", "×00000", "00×××0"), among=_NEVER,
    start=_at(90, -90, 130, -50, 60, 0), shows=_HOME)

_RANK = Number(
    ask="A column of the Jacobian has six numbers: the velocity of the tip and the angular "
        "velocity of the tool. At soft home, how many of the six columns are independent? (What "
        "is the rank?)",
    why="Columns 2 and 6 are equal, for both rolls turn about one line: one of them goes. Columns "
        "3, 4 and 5 hold two motions only, up and a turn about y₀: another one goes. 6 − 2 = 4.",
    right=4, tolerance=0.01,
    slips=[(6, "That is the rank of a bent arm."),
           (5, "The motion along x₀ is not the only one that is missing: along y₀ the tip goes "
            "only if the tool yaws with it.")])

# ---- Section 6: the wrist -----------------------------------------------------------------------

_WRIST = [
    Mark(ask="Frame 5 stands at the wrist. From soft home the elbow pitch, joint 4, turns by 90°, "
             "to θ₄ = 90°: it lifts the forearm of 304.8 mm. Where will the wrist be?",
         why="Joint 4 swings the forearm, and the wrist is at its end: (304.8, 0, 373.4 + 304.8). "
             "So it takes four joints to place this wrist.",
         of="frame-5-x", start=_HOME, shows={"theta_4": 90}, seen="front", axes="xz", tolerance=60,
         slips=[((609.6, 0, 373.4), "The elbow pitch does move the wrist: it is at the end of the "
                 "forearm."),
                ((304.8, 0, 906.8), "That is the tip, 228.6 mm farther on.")]),
    Mark(ask="From soft home the tool pitch, joint 5, turns by 90°, to θ₅ = 180°. Where will the "
             "wrist, the origin of frame 5, be?",
         why="It stays at (609.6, 0, 373.4): it lies on the axis of joint 5.",
         of="frame-5-x", start=_HOME, shows={"theta_5": 180}, seen="front", axes="xz", tolerance=60,
         begin=(760.0, 0.0, 500.0),
         slips=[((609.6, 0, 602), "That is the tip. The wrist lies on the axis that turns.")]),
]

_MEET = Choice(
    ask="The picture shows the axes of all six joints. Three of them meet in one point, whatever "
        "the joints do. Which?",
    why="Base, shoulder roll and shoulder pitch meet at the top of the column, in every pose: the "
        "position of O₂ is (0, 0, d₁).",
    options={"1, 2 and 3": "", "3, 4 and 5": "The three pitches are parallel: they never meet.",
             "4, 5 and 6": "Axes 5 and 6 meet at the wrist, but axis 4 is parallel to axis 5.",
             "2, 5 and 6": "Axes 2 and 6 lie in one line at soft home, not in every pose."},
    right="1, 2 and 3", start=_at(110, -70, 120, -60, 60, 0), shows=_at(60, -60, 120, -50, 90, 0))


def _speeds() -> LiveView:
    return velocity_view(robots.intelledex_660t())


PREDICTIONS: dict[str, Asked] = {
    "intelledex.axes": Asked(names_view, [_AXES]),
    "intelledex.roll": Asked(pitch_view, _ROLL),
    "intelledex.free": Asked(None, [_FREE]),
    "intelledex.sums": Asked(None, [_SUMS]),
    "intelledex.plane": Asked(plane_view, _PLANE),
    "intelledex.soft_home": Asked(names_view, _SOFT),
    "intelledex.yaw": Asked(yaw_view, _YAW),
    "intelledex.movers": Asked(_speeds, [_MOVERS]),
    "intelledex.rank": Asked(None, [_RANK]),
    "intelledex.wrist": Asked(wrist_view, _WRIST),
    "intelledex.meet": Asked(meeting_view, [_MEET]),
}
