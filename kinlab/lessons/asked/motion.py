"""Predictions of lesson 12, motion in time."""
from __future__ import annotations

from collections.abc import Mapping

from ...answers.prediction import Asked, Choice, Mark, Number
from ...arms import robots
from ...views.arm_view import ArmView
from ..views.motion import dots_view


def _two_links() -> ArmView:
    return ArmView(robots.two_link(), show=())


def _traced() -> ArmView:
    """The way of the tip is drawn while the arm goes to where the answer is."""
    return ArmView(robots.two_link(), show="trace")


def _pose(theta_1: float, theta_2: float) -> Mapping[str, float]:
    return {"theta_1": theta_1, "theta_2": theta_2}


# ---- Section 1: two ways ----------------------------------------------------------------

_MIDDLE = [
    Mark(ask="A joint-space motion goes from (θ₁, θ₂) = (−30°, 60°) to (60°, 60°). Where is the "
             "tip when half of the way is done? Both links are 1 m long.",
         why="θ₂ stays, so the tip is always 1.73 m from the base: it runs on a circle. Half-way "
             "θ₁ is 15°, and the tip is straight out at 45°.",
         start=_pose(-30, 60), shows=_pose(15, 60), tolerance=0.12,
         slips=[((0.866, 0.866, 0), "That is half-way on the straight line between both points. "
                                    "The joints share the way, not the tip.")]),
    Mark(ask="Now from (0°, 90°) to (90°, −90°). At both ends the tip is at (1, 1). Where is it "
             "when half of the way is done?",
         why="Half-way the joints are at 45° and 0°: the arm is stretched. The tip has gone out "
             "by 0.59 m, and comes back.",
         start=_pose(0, 90), shows=_pose(45, 0), tolerance=0.12, begin=(0.6, 1.5, 0),
         slips=[((1, 1, 0), "It comes back to (1, 1), but the joints move all the time."),
                ((0, 0, 0), "Folded it would be there; the elbow goes from 90° to −90° through "
                            "0°.")]),
]

_ELBOW = Choice(
    ask="The tip goes straight from (1.73, 0) to (0, 1.73). At both ends θ₂ is 60°. What does "
        "joint 2 do on the way?",
    why="The middle of the line is 1.22 m from the base, nearer than both ends. So the arm bends, "
        "up to 104°, and stretches again.",
    options={"it stays at 60°": "Then the tip would keep its distance from the base, and run on a "
             "circle.",
             "it bends more, then comes back": "",
             "it stretches, then comes back": "The line passes nearer to the base than both ends."},
    right="it bends more, then comes back", start=_pose(-30, 60),
    shows=_pose(-7.238756, 104.477512))

# ---- Section 2: the cubic ---------------------------------------------------------------

_JUMP = Choice(
    ask="A joint is at rest. From now on it is to turn at 0.5 rad/s. Which acceleration does "
        "the first instant ask for?",
    why="The rate is to jump from 0 to 0.5 rad/s in no time. 0.5 divided by no time is beyond any "
        "motor; what comes is a knock through gears and tool.",
    options={"none, since the rate is constant": "It is constant afterwards. Before it was zero.",
             "0.5 rad/s²": "With it the joint needs a second to get to its rate.",
             "more than any motor has": ""},
    right="more than any motor has")


def _quarter(profile: str, rail: float, formula: str, sum_: str, at: str) -> Mark:
    return Mark(
        ask=f"With τ = t / T, the {profile} goes s = {formula}. All dots begin at 0 and arrive at "
            f"1 together. A quarter of the time is over, τ = 0.25. Where is the {profile}'s dot?",
        why=f"s(0.25) = {sum_} = {at}: it has to pick up speed first, and is behind.",
        of=f"point-{profile}", start={"time": 0}, shows={"time": 0.25}, tolerance=0.03, axes="x",
        unit="rad", slips=[((0.25, rail, 0), "There it would be at a constant rate.")])


_QUARTER = [_quarter("cubic", 0.38, "3τ² − 2τ³", "3/16 − 2/64", "0.156"),
            _quarter("quintic", 0.26, "10τ³ − 15τ⁴ + 6τ⁵", "10/64 − 15/256 + 6/1024", "0.104")]


def _peak(change: float, T: float, unit: str, right: float) -> Number:
    mean = change / T
    return Number(
        ask=f"By the cubic a joint goes {change:g} {unit} in {T:g} s, so {mean:g} {unit}/s on "
            "average. What is its largest rate?".replace(" °", "°"),
        why=f"1.5 times the average: 1.5 · {mean:g} = {right:g} {unit}/s, in the middle of the "
            "time.".replace(" °", "°"),
        right=right, tolerance=0.02 * right, unit=f"{unit}/s",
        slips=[(mean, "That is the average. The joint begins and ends slower, so it must be "
                      "faster in between."),
               (2 * mean, "So it would be if the rate rose and fell in straight lines.")])


_PEAK = [_peak(90, 2, "°", 67.5), _peak(0.6, 3, "m", 0.3)]

_HARD = Choice(
    ask="When does the cubic ask for the largest acceleration?",
    why="s'' = (6 − 12τ) / T² is 6 / T² at the start, zero in the middle and −6 / T² at the end. "
        "So the acceleration still jumps, at both ends.",
    options={"in the middle, where it is fastest": "There the rate is largest, and its slope is "
             "zero.",
             "at both ends": "",
             "it is the same all the time": "A parabola has a constant second derivative; this is "
             "a cubic."},
    right="at both ends")

# ---- Section 3: quintic and trapezoidal -------------------------------------------------

_PRICE = Choice(
    ask="The quintic starts and stops more softly than the cubic, in the same time T. What is its "
        "largest rate?",
    why="1.875 / T, and the cubic's is 1.5 / T. Whoever starts later must hurry in between.",
    options={"smaller": "It must go the same way in the same time, and starts later.",
             "the same": "Look at the dots: at a quarter of the time it is behind the cubic.",
             "larger": ""},
    right="larger")


def _whole(way: float, speed: float, acceleration: float, right: float, why: str,
           *slips: tuple[float, str]) -> Number:
    return Number(
        ask=f"A joint has to go {way:g} rad. Its largest speed is {speed:g} rad/s, its largest "
            f"acceleration {acceleration:g} rad/s². How long does it take at least, from rest to "
            "rest?", why=why, right=right, tolerance=0.02, unit="s", slips=slips)


_WHOLE = [
    _whole(2, 1, 2, 2.5, "0.5 s to speed up (0.25 rad), 1.5 s at full speed (1.5 rad), 0.5 s to "
           "slow down (0.25 rad).",
           (2, "That is 2 rad at full speed, without speeding up and slowing down."),
           (2.25, "Slowing down takes time, too."),
           (3, "While it speeds up and slows down it also moves, 0.25 rad each.")),
    _whole(0.5, 2, 2, 1, "It speeds up for half of the way: 0.25 = 2 t² / 2, so t = 0.5 s, and "
           "slows down as long. It never gets to 2 rad/s.",
           (1.25, "That is 0.5 / 2 + 2 / 2: on so short a way it does not get to its full speed."),
           (0.25, "That is 0.5 rad at full speed."),
           (0.7071, "Then it arrives with 1.41 rad/s. It has to slow down.")),
]

# ---- Section 4: limits ------------------------------------------------------------------

_NEAR = (-48.217365, 105.962014)   # degrees: the tip at (1.2, 0.1)
_NEAREST = (2.865984, 174.268032)  # and at (0, 0.1)

_RACES = Choice(
    ask="In 2 s the tip goes along a straight line from (1.2, 0.1) to (−1.2, 0.1). It passes the "
        "base at a distance of 0.1 m. Which joint has to be fastest there?",
    why="By a quintic the tip has 1.875 · 2.4 m / 2 s = 2.25 m/s there. Joint 1 turns the line "
        "from the base to the tip: 2.25 / 0.1 = 22.5 rad/s. Joint 2 stands still for a moment.",
    options={"joint 1": "", "joint 2": "It changes the distance from the base, which is smallest "
             "there: it neither grows nor shrinks.",
             "both alike": "One turns the arm about the base, the other changes the distance."},
    right="joint 1", start=_pose(*_NEAR), shows=_pose(*_NEAREST))

_OUTWARDS = Choice(
    ask="The tip goes straight outwards, at a steady 0.5 m/s, until the arm is stretched. "
        "What becomes of the rate of joint 2?",
    why="The tip's distance r from the base changes by sin θ₂ / r for each radian of joint 2. "
        "Stretched, sin θ₂ = 0: for the same 0.5 m/s it needs an ever larger rate.",
    options={"it falls to zero": "The tip is to keep its speed to the end, and a stretched arm "
             "hardly moves it outwards.",
             "it stays as it is": "The same turn of the elbow brings the tip less and less.",
             "it grows beyond every limit": ""},
    right="it grows beyond every limit", start=_pose(-60, 120), shows=_pose(0, 0))

_BETWEEN = Choice(
    ask="At the start and at the end every joint is within its limits. In which motion can a "
        "joint pass a limit in between?",
    why="In joint space a joint stays between its two ends. On a line the elbow may have to bend "
        "more than at both ends: so it was in section 1.",
    options={"in joint space only": "There each joint stays between its values at the ends.",
             "on a straight line only": "",
             "in both": "In joint space each joint stays between its values at the ends.",
             "in neither": "Remember the elbow in section 1: 60°, 104°, 60°."},
    right="on a straight line only")

# ---- Section 5: slower ------------------------------------------------------------------

_HALVES = Choice(
    ask="The tip is to go along the same line in half the time. The joints follow by inverse "
        "kinematics. What becomes of their largest rates and accelerations?",
    why="The joints go through the same values, only in half the time: on a line, too, q depends "
        "on t / T. So rates are doubled, and accelerations, of two derivatives, are four times as "
        "large.",
    options={"both are doubled": "An acceleration is a change of rate in a time: the change is "
             "doubled, and the time is halved.",
             "rates are doubled, accelerations are four times as large": "",
             "rates are doubled, accelerations stay": "The rates are larger, and have to be "
             "reached in half the time."},
    right="rates are doubled, accelerations are four times as large")


def _factor(fast: str, hard: str, right: float, why: str, *slips: tuple[float, str]) -> Number:
    return Number(
        ask=f"In a motion one rate is {fast} its limit, and one acceleration is {hard} its "
            "limit. How many times as long must the motion take, at least?",
        why=why, right=right, tolerance=0.02, slips=slips)


_FACTOR = [
    _factor("2 times", "3 times", 2, "2 for the rate, √3 = 1.73 for the acceleration. The larger "
            "factor keeps both.",
            (3, "Accelerations fall with the square: √3 is enough for them."),
            (1.7321, "That is enough for the acceleration, but not for the rate."),
            (6, "Slower helps both at once.")),
    _factor("1.5 times", "9 times", 3, "1.5 for the rate, √9 = 3 for the acceleration.",
            (9, "Accelerations fall with the square: √9 is enough."),
            (1.5, "That is enough for the rate, but not for the acceleration."),
            (4.5, "Slower helps both at once.")),
]

PREDICTIONS: dict[str, Asked] = {
    "motion.middle": Asked(_traced, _MIDDLE),
    "motion.elbow": Asked(_two_links, [_ELBOW]),
    "motion.jump": Asked(None, [_JUMP]),
    "motion.quarter": Asked(dots_view, _QUARTER),
    "motion.peak": Asked(None, _PEAK),
    "motion.hard": Asked(None, [_HARD]),
    "motion.price": Asked(None, [_PRICE]),
    "motion.whole": Asked(None, _WHOLE),
    "motion.races": Asked(_two_links, [_RACES]),
    "motion.outwards": Asked(_two_links, [_OUTWARDS]),
    "motion.between": Asked(None, [_BETWEEN]),
    "motion.halves": Asked(None, [_HALVES]),
    "motion.factor": Asked(None, _FACTOR),
}
