"""Predictions of lesson 02, rotation."""
from __future__ import annotations

from functools import partial

from ...answers.prediction import Asked, Choice, Direction, Mark, Signs
from ..views.rotation import (
    axes_view,
    book_view,
    mirror_view,
    riding_view,
    spatial_view,
    still_view,
    turning_view,
    two_turns_view,
)
from . import angle

# ---- A frame that turns -----------------------------------------------------------------


def _quarter(theta: float) -> Direction:
    return Direction(
        ask=f"Frame 1 lies on frame 0 now. It will turn to θ = {angle(theta)}. Which way will y₁ "
            "point?",
        why=f"x₁ points to {angle(theta)}. y₁ is a quarter turn ahead of it, at "
            f"{angle(theta)} + 90° = {angle(theta + 90)}.",
        start={"theta": 0}, shows={"theta": theta}, of="frame-1-y",
        slips=[(theta, "There x₁ points. y₁ is a quarter turn ahead of it."),
               (theta - 90, "That is a quarter turn behind x₁: y₁ lies on its left."),
               (90, "y₁ does not stay on y₀: it turns with the frame.")])


def _carried(theta: float, where: str, slips: list) -> Mark:
    return Mark(
        ask=f"c is fixed in frame 1, at c¹ = (1.2, 0.5). Where will c be at θ = {angle(theta)}?",
        why=f"At θ = {angle(theta)} {where}.",
        start={"theta": 0}, shows={"theta": theta}, of="point-c", tolerance=0.15, slips=slips)


_CARRIED = [
    _carried(90, "x₁ points up and y₁ to the left: 1.2 up, then 0.5 to the left", [
        ((0.5, 1.2, 0), "1.2 up is right. Then go along y₁, which points to the left now."),
        ((0.5, -1.2, 0), "That is a turn clockwise; a positive angle turns counter-clockwise."),
        ((1.2, 0.5, 0), "The point does not stay: it rides on frame 1.")]),
    _carried(180, "x₁ points to the left and y₁ down: 1.2 to the left, then 0.5 down", [
        ((-1.2, 0.5, 0), "1.2 to the left is right. Then go along y₁, which points down now."),
        ((1.2, -0.5, 0), "0.5 down is right. But x₁ points to the left now."),
        ((-0.5, 1.2, 0), "That is a quarter turn; go on by one more.")]),
    _carried(-90, "x₁ points down and y₁ to the right: 1.2 down, then 0.5 to the right", [
        ((-0.5, 1.2, 0), "That is the turn by +90°; a negative angle turns clockwise."),
        ((-0.5, -1.2, 0), "1.2 down is right. Then go along y₁, which points to the right now."),
        ((1.2, 0.5, 0), "The point does not stay: it rides on frame 1.")]),
]

# ---- A point that stays -----------------------------------------------------------------

_FOOT = ("Drop a line from c to x₁, or to the line that goes on behind it, at a right angle. "
         "Where does it meet that line ")
_SHADOWS = [
    Mark(ask=f"c stands still at (0.5, 1.2). {_FOOT}when θ = −90°?",
         why="At θ = −90° the line of x₁ is the vertical one. The foot lies at the height of c, "
             "1.2 behind the origin if you look along x₁: the first component of c¹ is −1.2.",
         start={"theta": 0}, shows={"theta": -90}, of="drop-x", tolerance=0.15,
         slips=[((0, -1.2, 0), "x₁ points down, but c is above: its foot lies behind the origin."),
                ((0.5, 0, 0), "That is the foot on x₀. x₁ points down now."),
                ((0.5, 1.2, 0), "That is c. Its foot lies on the line of x₁.")]),
    Mark(ask=f"c stands still at (0.5, 1.2). {_FOOT}when θ = 180°?",
         why="At θ = 180° the line of x₁ is the horizontal one. The foot lies under c, 0.5 behind "
             "the origin if you look along x₁: the first component of c¹ is −0.5.",
         start={"theta": 45}, shows={"theta": 180}, of="drop-x", tolerance=0.15,
         slips=[((-0.5, 0, 0), "x₁ points to the left, but c is on the right: its foot lies "
                               "behind the origin."),
                ((0, 1.2, 0), "That is the foot on y₁. x₁ lies on the horizontal line."),
                ((0.5, 1.2, 0), "That is c. Its foot lies on the line of x₁.")]),
]

_SEEN = Choice(
    ask="c stands still at c⁰ = (0.5, 1.2). The frame turns from θ = 0 to θ = 90°. What is c¹ then?"
        "",
    why="x₁ points up, and c lies 1.2 up. y₁ points to the left, and c lies 0.5 to the right. Seen "
        "from the frame, c has gone round clockwise.",
    right="(1.2, −0.5)",
    options={"(−0.5, 1.2)": "There a point goes that rides on the frame. Seen from the frame, c "
                            "goes the other way round.",
             "(1.2, −0.5)": "",
             "(0.5, 1.2)": "The point stays. Its coordinates do not: the frame in which they are "
                           "measured has turned.",
             "(1.2, 0.5)": "c lies on the right, but y₁ points to the left."})

_UNDO = Choice(
    ask="A turn by θ is to be undone. Which turn does that?",
    why="A turn by θ and then by −θ ends where it began, so the inverse of R(θ) is R(−θ).",
    right="a turn by −θ",
    options={"a turn by θ once more": "That makes a turn by 2θ.",
             "a turn by −θ": "",
             "a turn by 180° − θ": "Together that makes half a turn, at every θ.",
             "a turn by 90° − θ": "Together that makes a quarter turn, at every θ."})

# ---- Mirror images ----------------------------------------------------------------------

_MIRRORED = Mark(
    ask="The matrix M has the columns (1, 0) and (0, −1). Where does it take c = (0.8, 1), the end "
        "of the letter F?",
    why="M c = 0.8 (1, 0) + 1 (0, −1) = (0.8, −1). The whole letter lands on the other side of x₀.",
    start={"phi": 0}, shows={"phi": 180}, of="point-c", tolerance=0.15,
    slips=[((-0.8, 1, 0), "That is the mirror image to the left. The first column is (1, 0): "
                          "0.8 stays."),
           ((-0.8, -1, 0), "That is half a turn. The first column is (1, 0): 0.8 stays."),
           ((1, -0.8, 0), "That is a quarter turn clockwise. M exchanges nothing.")])

_PAPER = Choice(
    ask="The F is its mirror image now. You turn the sheet on the table by θ. For which θ does the "
        "F cover its dashed outline again?",
    why="A turn on the table never makes a mirror image good. The sheet has to be flipped over.",
    start={"phi": 180, "theta": 0}, shows={"phi": 180, "theta": 180}, right="for no θ",
    options={"for θ = 90°": "Then the F lies on its side.",
             "for θ = 180°": "Then the F stands upright again, but its bars point to the left.",
             "for θ = 360°": "A whole turn changes nothing: it is the mirror image still.",
             "for no θ": ""})

# ---- Two turns in the plane -------------------------------------------------------------


def _summed(first: float, second: float) -> Direction:
    return Direction(
        ask=f"Frame 1 is turned by θ₁ = {angle(first)} in frame 0. Frame 2 is turned by θ₂ = "
            f"{angle(second)} in frame 1. Which way will x₂ point?",
        why=f"The second turn begins where the first one ended: {angle(first)} + "
            f"{angle(second) if second > 0 else f'({angle(second)})'} = "
            f"{angle(first + second)} from x₀.",
        start={"theta_1": 0, "theta_2": 0}, shows={"theta_1": first, "theta_2": second},
        of="frame-2-x", begin=-135.0,
        slips=[(first, "There x₁ points. Frame 2 is turned from there."),
               (second, "θ₂ is measured from x₁, not from x₀."),
               (first - second, "That is θ₁ − θ₂. A turn goes on from where the frame is.")])


# ---- In space ---------------------------------------------------------------------------

_ABOUT_Z = Signs(
    ask="The frame turns about z. θ grows from 0 to 90°. What does each entry of R₁⁰ do?",
    why="z₁ stays on z₀, so column 3 is (0, 0, 1). x₁ and y₁ stay in the plane of x₀ and y₀, so "
        "their z component is 0. The rest is the matrix of the plane.",
    start={"theta": 0}, shows={"theta": 90},
    rows=("x₀", "y₀", "z₀"), columns=("x₁", "y₁", "z₁"), right=("cc0", "cc0", "001"),
    among={"c": "changes", "0": "is always 0", "1": "is always 1"})


def _about_x(theta: float, slips: list) -> Direction:
    return Direction(
        ask=f"The frame turns about x, to θ = {angle(theta)}. Which way will z₁ point?",
        why=f"A positive turn about x takes y towards z, and z on towards −y. z₁ has gone "
            f"{abs(theta):g}° that way{' backwards' if theta < 0 else ''}.",
        start={"theta": 0}, shows={"theta": theta}, of="frame-1-z", about="x", begin=90.0,
        slips=[*slips, (90, "Only x₁ stays, the axis of the turn. z₁ turns.")])


_ABOUT_X = [
    _about_x(90, [(0, "That is +y₀. Point your right thumb along x₀: the fingers go from y to z, "
                      "and on to −y.")]),
    _about_x(-120, [(210, "That is the turn by +120°. A negative one goes the other way round.")]),
]


def _about_y(theta: float, where: str, slip: tuple[float, str]) -> Direction:
    return Direction(
        ask=f"The frame turns about y, to θ = {angle(theta)}. Which way will x₁ point? Use your "
            "right hand: thumb along y₀.",
        why=f"A positive turn about y takes z towards x, and x on towards −z. So {where}.",
        start={"theta": 0}, shows={"theta": theta}, of="frame-1-x", about="y", begin=90.0,
        slips=[slip, (90, "Only y₁ stays, the axis of the turn. x₁ turns.")])


_ABOUT_Y = [
    _about_y(60, "x₁ sinks", (30, "That is up. With the thumb along y₀ your fingers go from z to "
                                  "x, and on down to −z.")),
    _about_y(-90, "x₁ rises for a negative θ, here all the way to z₀",
             (180, "That is down, as for +90°. A negative turn goes the other way round.")),
]

_BOOK = Direction(
    ask="Book A is turned by 90° about z of the room, then by 90° about x of the room. Which way "
        "will its front cover (z of the book) point?",
    why="The turn about z leaves the cover up. The turn about x takes z to −y. Book B, turned in "
        "the other order, ends with its cover along x.",
    start={"t": 0}, shows={"t": 2}, of="frame-A-z", about="x", begin=90.0,
    slips=[(90, "The first turn leaves the cover up, but the second one tips it over."),
           (0, "That is +y₀. With the thumb along x₀, z goes to −y.")])

PREDICTIONS: dict[str, Asked] = {
    "rotation.quarter": Asked(turning_view, [_quarter(theta) for theta in (120, 60, -60)]),
    "rotation.signs": Asked(axes_view, [Signs(
        ask="The frame turns from θ = 0 to θ = 35°. Which sign will each component of its axes "
            "have, seen from frame 0?",
        why="x₁ points to the right and up: both are positive. y₁ leans to the left: its x "
            "component, row 1 and column 2, is the only negative one.",
        start={"theta": 0}, shows={"theta": 35}, rows=("x₀", "y₀"), columns=("x₁", "y₁"),
        right=("+-", "++"), among={"+": "positive", "-": "negative", "0": "zero"})]),
    "rotation.riding": Asked(riding_view, _CARRIED),
    "rotation.shadow": Asked(still_view, _SHADOWS),
    "rotation.seen": Asked(None, [_SEEN]),
    "rotation.undo": Asked(None, [_UNDO]),
    "rotation.mirror": Asked(mirror_view, [_MIRRORED]),
    "rotation.paper": Asked(mirror_view, [_PAPER]),
    "rotation.sum": Asked(two_turns_view, [_summed(50, 30), _summed(120, -45), _summed(-30, -40)]),
    "rotation.about_z": Asked(partial(spatial_view, "z"), [_ABOUT_Z]),
    "rotation.about_x": Asked(partial(spatial_view, "x"), _ABOUT_X),
    "rotation.about_y": Asked(partial(spatial_view, "y"), _ABOUT_Y),
    "rotation.book": Asked(book_view, [_BOOK]),
}
