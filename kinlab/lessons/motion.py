"""Lesson 12, motion in time: the judges of its exercises, and its predictions."""
from __future__ import annotations

from collections.abc import Callable
from math import radians

import numpy as np
from numpy.polynomial import Polynomial

from ..answers.conditions import exactly, meet, one_of_many
from ..answers.judges import Judge, function, values
from ..arms.arm import Arm
from ..arms.link import revolute
from ..paths.straight import straight_path
from .asked.motion import PREDICTIONS
from .views.motion import dots_view, race_view

__all__ = ["JUDGES", "PREDICTIONS", "dots_view", "race_view"]

# ---- Exercise 1: the cubic from rest to rest ----------------------------------------------


def cubic_judge(start: float, end: float, T: float) -> Judge:
    """Judge of the coefficients of a cubic between two angles (degrees) in T seconds."""
    first, change = radians(start), radians(end - start)

    def row(a_2: float = 3.0, a_3: float = -2.0, *, a_0: float = first, by: float = change,
            powers: tuple[int, int] = (2, 3)) -> np.ndarray:
        """The coefficients; a slip has other factors, or the duration in other powers."""
        return np.array([a_0, 0.0, a_2 * by / T**powers[0], a_3 * by / T**powers[1]])

    slips = [
        (f"These are degrees and degrees per second to some power: put {start:g}° and {end:g}° in "
         "as radians.", np.degrees(row())),
        ("The coefficients are in the wrong order: asked is a_0 first, a_3 last.", row()[::-1]),
        ("This is motion at a constant rate: the joint would have to start and stop in no time. "
         "Use the four conditions.", [first, change / T, 0, 0]),
        (_NO_REST, row(1.0, 0.0)), (_NO_REST, row(0.0, 1.0)),
        *((_POWERS, row(powers=powers)) for powers in ((1, 1), (1, 2))),
        ("T enters a_3 as its cube.", row(powers=(2, 2))),
        ("These belong to s = t / T. Here they are asked for t, in seconds: where does T stand?",
         row(powers=(0, 0))),
        ("The sign of a_3 is wrong: after the middle the joint slows down.", row(a_3=2.0)),
        (f"The change counts, {end - start:g}°, not the value at the end, {end:g}°.",
         row(by=radians(end))),
        (f"The joint begins at {start:g}°: a_0 is missing.", row(a_0=0.0)),
    ]
    mean = (end - start) / T
    return values(
        row(), entry=lambda index: f"a_{index[0]}", slips=slips,
        praise=f"From rest to rest. Its largest rate is 1.5 times {mean:g}°/s, in the middle: "
               f"{1.5 * mean:g}°/s.")


_NO_REST = ("It begins at rest and arrives, but its rate at the end is not zero: that is the "
            "fourth condition.")
_POWERS = "T enters a_2 as its square, and a_3 as its cube."

# ---- Exercise 2: the quintic, with rate and acceleration ----------------------------------


def _quintic(q0: float, q1: float, T: float, t: float) -> list[float]:
    return _polynomial([10, -15, 6], 3)(q0, q1, T, t)


def _polynomial(factors: list[int], lowest: int, powers: tuple[int, int] = (1, 2)) -> Callable:
    """Value, rate and acceleration for s to the powers from the lowest one on.

    `powers` are those in which T divides rate and acceleration; a slip has others.
    """
    share = Polynomial([0] * lowest + factors)

    def motion(q0: float, q1: float, T: float, t: float) -> list[float]:
        rate, acceleration = share.deriv(1)(t / T), share.deriv(2)(t / T)
        return [q0 + (q1 - q0) * share(t / T), (q1 - q0) * rate / T**powers[0],
                (q1 - q0) * acceleration / T**powers[1]]
    return motion


def _by_entry(change: Callable[[np.ndarray, float, float], np.ndarray]) -> Callable:
    """The right numbers, after a change that knows where the joint begins and how far it goes."""
    return lambda q0, q1, T, t: change(np.array(_quintic(q0, q1, T, t)), q0, q1 - q0)


_QUINTIC_CASES = [{"q0": q0, "q1": q1, "T": T, "t": t} for q0, q1, T, t in (
    (0.2, 1.4, 2.0, 0.5), (1.0, -0.5, 4.0, 3.0), (0.5, 0.9, 0.8, 0.6))]

_QUINTIC_SLIPS = [
    ("This is the cubic: its acceleration does not begin at zero.", _polynomial([3, -2], 2)),
    ("This is motion at a constant rate. The quintic has the factors 10, -15 and 6.",
     _polynomial([1], 1)),
    ("The factors are in the wrong order: 10 belongs to the third power, 6 to the fifth.",
     _polynomial([6, -15, 10], 3)),
    ("The sign of 15 is wrong: 10 - 15 + 6 = 1, so that the joint arrives.",
     _polynomial([10, 15, 6], 3)),
    ("The rate is divided by T, and the acceleration by T squared: each derivative brings 1 / T.",
     _polynomial([10, -15, 6], 3, (0, 0))),
    ("The acceleration is divided by T squared: each of both derivatives brings 1 / T.",
     _polynomial([10, -15, 6], 3, (1, 1))),
    ("The rate is divided by T: the derivative of t / T is 1 / T.",
     _polynomial([10, -15, 6], 3, (0, 2))),
    ("The polynomial takes the share s = t / T, not the time itself.",
     lambda q0, q1, T, t: _quintic(q0, q1, 1.0, t)),
    ("The polynomial goes from 0 to 1. Begin at q0 and multiply it by the change, q1 - q0.",
     lambda q0, q1, T, t: _quintic(0.0, 1.0, T, t)),
    ("Where it begins is missing: q = q0 + ...", _by_entry(lambda r, q0, by: r - [q0, 0, 0])),
    ("It is multiplied by q1; the change is q1 - q0.",
     lambda q0, q1, T, t: _quintic(q0, q0 + q1, T, t)),
    ("Rate and acceleration are to be multiplied by the change, q1 - q0, as well.",
     _by_entry(lambda r, q0, by: r / [1, by, by])),
    ("The rate is the derivative of q, so q0 is not in it; nor is it in the acceleration.",
     _by_entry(lambda r, q0, by: r + [0, q0, q0])),
    ("It goes from q1 to q0: the change is q1 - q0.",
     lambda q0, q1, T, t: _quintic(q1, q0, T, t)),
]

# ---- Exercise 3: how long a trapezoidal motion takes --------------------------------------


def _trapezoid(way: float, speed: float, acceleration: float) -> list[float]:
    if way < speed**2 / acceleration:
        return [(way / acceleration)**0.5, 2 * (way / acceleration)**0.5]
    return _long(way, speed, acceleration)


def _long(way: float, speed: float, acceleration: float) -> list[float]:
    """As if the way were always long enough for the full speed."""
    return [speed / acceleration, way / speed + speed / acceleration]


def _total(total: Callable[[float, float, float], float]) -> Callable:
    """The right time to speed up, with another total, on ways that are long enough."""
    def times(way: float, speed: float, acceleration: float) -> list[float]:
        ramp, right = _trapezoid(way, speed, acceleration)
        return [ramp, total(way, speed, acceleration) if way > speed**2 / acceleration else right]
    return times


def _both(short: Callable[[float, float], list[float]]) -> Callable:
    """Right on a long way, with other times on a short one."""
    def times(way: float, speed: float, acceleration: float) -> list[float]:
        enough = way >= speed**2 / acceleration
        return _long(way, speed, acceleration) if enough else short(way, acceleration)
    return times


def _half_checked(way: float, speed: float, acceleration: float) -> list[float]:
    """As if the way were long enough for full speed once one of the two ramps fits into it."""
    enough = way >= speed**2 / (2 * acceleration)
    return (_long if enough else _trapezoid)(way, speed, acceleration)


def _without_brake(way: float, speed: float, acceleration: float) -> list[float]:
    """As if the joint arrived at the speed that it has."""
    if way < speed**2 / (2 * acceleration):
        return [(2 * way / acceleration)**0.5] * 2
    return [speed / acceleration, way / speed + speed / (2 * acceleration)]


_TRAPEZOID_CASES = [{"way": way, "speed": speed, "acceleration": acceleration}
                    for way, speed, acceleration in (
    (1.5, 1.0, 2.0), (2.4, 0.8, 0.5), (0.4, 1.0, 2.0), (0.9, 1.2, 0.4))]

_NO_BRAKE = ("The end is missing: slowing down takes as long as speeding up, and the joint covers "
             "as much of its way in it.")
_UNCHECKED = ("On a short way the joint never gets to its full speed: it has to slow down after "
              "half of the way. Where is way < speed**2 / acceleration?")
_TRAPEZOID_SLIPS = [
    (_NO_BRAKE, _total(lambda way, v, a: way / v + v / (2 * a))),
    (_NO_BRAKE, lambda way, v, a: [v / a, way / v + v / (2 * a)]),
    (_NO_BRAKE, _without_brake),
    (_UNCHECKED, _long),
    ("Full speed is reached only if the way holds both, speeding up and slowing down: "
     "speed**2 / acceleration in all.", _half_checked),
    ("Speeding up and slowing down take time, too: this is the time at full speed all the way.",
     _total(lambda way, v, a: way / v)),
    ("Speeding up and slowing down take time, too: this is the time at full speed all the way.",
     lambda way, v, a: [v / a, way / v]),
    ("While it speeds up, the joint moves as well: with half of its speed on average. So the way "
     "at full speed is shorter.", _total(lambda way, v, a: way / v + 2 * v / a)),
    ("While it speeds up, the joint moves as well: with half of its speed on average. So the way "
     "at full speed is shorter.", lambda way, v, a: [v / a, way / v + 2 * v / a]),
    ("The time to speed up is speed / acceleration.",
     lambda way, v, a: [a / v, way / v + a / v]),
    ("On a short way it speeds up for half of the way: way / 2 = acceleration * time**2 / 2.",
     _both(lambda way, a: [(way / (2 * a))**0.5, 2 * (way / (2 * a))**0.5])),
    ("On a short way it speeds up for half of the way: way / 2 = acceleration * time**2 / 2.",
     _both(lambda way, a: [(2 * way / a)**0.5, 2 * (2 * way / a)**0.5])),
    ("On a short way this is the time to speed up alone; slowing down takes as long again.",
     _both(lambda way, a: [(way / a)**0.5] * 2)),
]

# ---- Exercise 4: how many times slower ----------------------------------------------------

Ratios = tuple[np.ndarray, np.ndarray]


def _ratios(rates: np.ndarray, accelerations: np.ndarray, speed: np.ndarray,
            acceleration: np.ndarray) -> Ratios:
    """How many times too large each rate and each acceleration is."""
    return (np.abs(rates) / np.asarray(speed),
            np.abs(accelerations) / np.asarray(acceleration))


def _factor(of: Callable[[np.ndarray, np.ndarray], float]) -> Callable:
    return lambda *numbers: float(of(*_ratios(*numbers)))


_slower = _factor(lambda fast, hard: max(1.0, fast.max(), hard.max()**0.5))


def _signed(fast_of: Callable = np.abs, hard_of: Callable = np.abs, least: float = 1.0) -> Callable:
    """As if rates or accelerations had no sign that counts, or as if they had: by np.abs or not."""
    def factor(rates: np.ndarray, accelerations: np.ndarray, speed: np.ndarray,
               acceleration: np.ndarray) -> float:
        fast = (fast_of(rates) / np.asarray(speed)).max()
        hard = (hard_of(accelerations) / np.asarray(acceleration)).max()
        return float(max(least, fast, hard**0.5))
    return factor


def _over_all(rates: np.ndarray, accelerations: np.ndarray, speed: np.ndarray,
              acceleration: np.ndarray) -> float:
    """The largest rate of all joints by the largest limit of all joints."""
    fast = np.abs(rates).max() / np.max(speed)
    return float(max(1.0, fast, (np.abs(accelerations).max() / np.max(acceleration))**0.5))


_SLOWER_CASES = [
    {"rates": np.array(rates), "accelerations": np.array(accelerations),
     "speed": np.array(speed), "acceleration": np.array(acceleration)}
    for rates, accelerations, speed, acceleration in (
        ([[0, 0], [1.2, -3], [0, 0]], [[4, -10], [0, 0], [-4, 10]], [1, 2], [2, 4]),
        ([[0, 0], [-3.5, 1], [0, 0]], [[-3, 2], [0, 0], [3, -2]], [1.4, 3], [2, 5]),
        ([[0, 0], [0.5, 0.8], [0, 0]], [[1, 2], [0, 0], [-1, -2]], [1, 2], [4, 4]),
        ([[0, 0], [1, -2], [0, 0]], [[2, -5], [0, 0], [-18, 5]], [2, 2], [2, 6]),
        ([[0, 0], [2.4, 1], [0, 0]], [[2, 1], [0, 0], [-2, -1]], [1, 2], [4, 4]))]

_NO_HARD = "Only the rates are looked at. Accelerations have limits as well."
_NO_FAST = "Only the accelerations are looked at. Rates have limits as well."
_BACKWARDS = "A joint that turns backwards has a negative rate: take np.abs of the rates first."
_BRAKING = ("A joint that slows down has a negative acceleration: take np.abs of the accelerations "
            "first.")
_SLOWER_SLIPS = [
    ("Accelerations fall with the square of k, so k is the root of what is too much.",
     _factor(lambda fast, hard: max(1.0, fast.max(), hard.max()))),
    ("Rates fall with k itself; the root belongs to the accelerations.",
     _factor(lambda fast, hard: max(1.0, fast.max()**0.5, hard.max()**0.5))),
    (_NO_HARD, _factor(lambda fast, hard: max(1.0, fast.max()))),
    (_NO_HARD, _factor(lambda fast, hard: fast.max())),
    (_NO_FAST, _factor(lambda fast, hard: max(1.0, hard.max()**0.5))),
    (_NO_FAST, _factor(lambda fast, hard: hard.max()**0.5)),
    ("Both limits must be kept: take the larger factor, not the smaller one.",
     _factor(lambda fast, hard: max(1.0, min(fast.max(), hard.max()**0.5)))),
    ("A motion within its limits need not be slower: k is 1 at least.",
     _factor(lambda fast, hard: max(fast.max(), hard.max()**0.5))),
    (_BACKWARDS, _signed(np.asarray, np.asarray)),
    (_BACKWARDS, _signed(fast_of=np.asarray)),
    (_BACKWARDS, _signed(fast_of=np.asarray, least=0.0)),
    (_BRAKING, _signed(hard_of=np.asarray)),
    (_BRAKING, _signed(hard_of=np.asarray, least=0.0)),
    ("Each joint has limits of its own: divide first, then take the largest.", _over_all),
    ("That is 1 / k: the motion is to become slower.",
     _factor(lambda fast, hard: 1 / max(1.0, fast.max(), hard.max()**0.5))),
    ("That is the square of k.",
     _factor(lambda fast, hard: max(1.0, fast.max()**2, hard.max()))),
    ("One after the other is too much: slower for the rates makes the accelerations smaller, too.",
     _factor(lambda fast, hard: max(1.0, fast.max()) * max(1.0, hard.max()**0.5))),
]

# ---- Exercise 5: around the base ----------------------------------------------------------

_START, _END = np.array([1.2, 0.1, 0.0]), np.array([-1.2, 0.1, 0.0])  # m
_MOST, _EACH = 2.0, 2.0                                               # rad/s; s for each line
_REACH = 2.0                                                          # m
_MOTORS = Arm([revolute(a=1, speed=_MOST), revolute(a=1, speed=_MOST)], home=[0, 1])


def _in_reach(via: np.ndarray) -> str:
    far = float(np.hypot(*via))
    if abs(far - _REACH) < 5e-4:
        return ("The point is as far from the base as the arm reaches, 2 m. There the arm is "
                "stretched, and that is singular: joint 2 cannot keep to its limit.")
    return "" if far < _REACH else (f"The point is {far:.3g} m from the base; the arm reaches "
                                    f"{_REACH:g} m.")


def _slow_enough(via: np.ndarray) -> str:
    try:
        first = straight_path(_MOTORS, _START, [*via, 0.0], _EACH)
        second = straight_path(_MOTORS, [*via, 0.0], _END, _EACH, q0=first.q[-1])
    except ValueError:
        return ("On these lines the arm comes to a place where it cannot go on: they pass the "
                "base too closely.")
    worst = [(breach.worst, breach.joint, which) for which, path in
             (("first", first), ("second", second)) for breach in path.broken]
    if not worst:
        return ""
    rate, joint, which = max(worst)
    return (f"On the {which} line joint {joint} has to turn by {rate:.3g} rad/s; {_MOST:g} rad/s "
            "are allowed.")


_AROUND = (_in_reach, _slow_enough)
_VIA_SLIPS = [
    ("The point lies at one end of the way, so the other line is the straight one past the base.",
     lambda via: min(np.hypot(*(via - end[:2])) for end in (_START, _END)) < 0.15),
    ("x and y have changed places.", lambda via: meet(_AROUND, via[::-1])),
    ("These look like millimetres; lengths are in metres.",
     lambda via: np.abs(via).max() > 10 and meet(_AROUND, via / 1000)),
    ("The straight line passes above the base. On the other side the way round is longer.",
     lambda via: via[1] < 0),
    ("So near to the base, joint 1 has to race. Go round it in a wider bow.",
     lambda via: np.hypot(*via) < 0.6),
    ("One of the lines is much longer than the other, and has the same time.",
     lambda via: abs(via[0]) > 0.3),
    ("So far out, the lines are long and the arm is almost stretched.",
     lambda via: np.hypot(*via) > 1.6),
]

JUDGES: dict[str, Judge] = {
    "motion.1": cubic_judge(30, 120, 2),
    "motion.2": function(
        _quintic, _QUINTIC_CASES, slips=_QUINTIC_SLIPS,
        entry=lambda index: ("q", "the rate", "the acceleration")[index[0]],
        praise="Position, rate and acceleration, from rest to rest. kl.joint_path does the same "
               "for all joints of an arm."),
    "motion.3": function(
        _trapezoid, _TRAPEZOID_CASES, slips=_TRAPEZOID_SLIPS,
        entry=lambda index: ("the time to speed up (s)", "the whole time (s)")[index[0]],
        praise="On a long way the rate is a trapezoid, on a short one a triangle."),
    "motion.4": function(
        _slower, _SLOWER_CASES, slips=_SLOWER_SLIPS, entry=lambda index: "k",
        praise="So slow, and no slower: one limit is just met, and all others are kept."),
    "motion.5": one_of_many(
        exactly((2,), "two numbers, x and y"), _AROUND, slips=_VIA_SLIPS, noun="point (x, y)",
        praise="Around the singular place, no joint is too fast. Straight through, joint 1 would "
               "have needed 22.5 rad/s."),
}
