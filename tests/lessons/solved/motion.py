"""Answers to the lesson on motion in time: right, typically wrong, and not attempted."""
import numpy as np

# Exercise 1: 3 * 90° / 2² = 67.5°/s², and -2 * 90° / 2³ = -22.5°/s³.
CUBIC = np.radians([30, 0, 67.5, -22.5])


def quintic(q0, q1, T, t):
    s, by = t / T, q1 - q0
    return [q0 + by * (10 * s**3 - 15 * s**4 + 6 * s**5),
            by / T * 30 * s**2 * (1 - s)**2,
            by / T**2 * 60 * s * (1 - s) * (1 - 2 * s)]


def entries(change):
    def changed(q0, q1, T, t):
        return change(np.array(quintic(q0, q1, T, t)), q0, q1, T)
    return changed


def cubic(q0, q1, T, t):
    s, by = t / T, q1 - q0
    return [q0 + by * (3 * s**2 - 2 * s**3), by / T * (6 * s - 6 * s**2),
            by / T**2 * (6 - 12 * s)]


def exchanged(q0, q1, T, t):
    s, by = t / T, q1 - q0
    return [q0 + by * (6 * s**3 - 15 * s**4 + 10 * s**5),
            by / T * (18 * s**2 - 60 * s**3 + 50 * s**4),
            by / T**2 * (36 * s - 180 * s**2 + 200 * s**3)]


def plus_15(q0, q1, T, t):
    s, by = t / T, q1 - q0
    return [q0 + by * (10 * s**3 + 15 * s**4 + 6 * s**5),
            by / T * (30 * s**2 + 60 * s**3 + 30 * s**4),
            by / T**2 * (60 * s + 180 * s**2 + 120 * s**3)]


def trapezoid(way, speed, acceleration):
    ramp = speed / acceleration
    if acceleration * ramp**2 > way:            # both ramps together
        ramp = np.sqrt(way / acceleration)
        return ramp, 2 * ramp
    return ramp, 2 * ramp + (way - acceleration * ramp**2) / speed


def no_brake(way, speed, acceleration):
    ramp = speed / acceleration
    if acceleration * ramp**2 / 2 > way:
        ramp = np.sqrt(2 * way / acceleration)
        return ramp, ramp
    return ramp, ramp + (way - acceleration * ramp**2 / 2) / speed


def unchecked(way, speed, acceleration):
    ramp = speed / acceleration
    return ramp, 2 * ramp + (way - acceleration * ramp**2) / speed


def short_as(short):
    def times(way, speed, acceleration):
        enough = way >= speed**2 / acceleration
        return trapezoid(way, speed, acceleration) if enough else short(way, acceleration)
    return times


def slower(rates, accelerations, speed, acceleration):
    fast = (abs(rates) / speed).max()
    hard = (abs(accelerations) / acceleration).max()
    return max(1, fast, np.sqrt(hard))


def ratios(of):
    return lambda rates, accelerations, speed, acceleration: of(
        (abs(rates) / speed).max(), (abs(accelerations) / acceleration).max())


RIGHT = {
    "motion.1": CUBIC,
    "motion.2": quintic,
    "motion.3": trapezoid,
    "motion.4": slower,
    "motion.5": (0, 1),
}

ALSO = [
    ("motion.1", [np.pi / 6, 0, 3 * np.pi / 8, -np.pi / 8], "From rest to rest"),
    ("motion.2", lambda *given: np.array(quintic(*given)), "from rest to rest"),
    ("motion.3", lambda *given: list(trapezoid(*given)), "on a short one a triangle"),
    ("motion.4", lambda *given: np.array(slower(*given)), "one limit is just met"),
    ("motion.5", np.array([0, 1.4]), "no joint is too fast"),
    ("motion.5", [-0.1, 0.9], "no joint is too fast"),
]

WRONG = [
    ("motion.1", np.degrees(CUBIC), "These are degrees"),
    ("motion.1", CUBIC[::-1], "wrong order"),
    ("motion.1", [np.pi / 6, np.pi / 4, 0, 0], "constant rate"),
    ("motion.1", [np.pi / 6, 0, np.pi / 8, 0], "rate at the end is not zero"),
    ("motion.1", [np.pi / 6, 0, 0, np.pi / 16], "rate at the end is not zero"),
    ("motion.1", [np.pi / 6, 0, 3 * np.pi / 4, -np.pi / 2], "a_2 as its square"),
    ("motion.1", [np.pi / 6, 0, 3 * np.pi / 4, -np.pi / 4], "a_2 as its square"),
    ("motion.1", [np.pi / 6, 0, 3 * np.pi / 8, -np.pi / 4], "a_3 as its cube"),
    ("motion.1", [np.pi / 6, 0, 3 * np.pi / 2, -np.pi], "belong to s = t / T"),
    ("motion.1", [np.pi / 6, 0, 3 * np.pi / 8, np.pi / 8], "sign of a_3"),
    ("motion.1", [np.pi / 6, 0, np.pi / 2, -np.pi / 6], "The change counts"),
    ("motion.1", [0, 0, 3 * np.pi / 8, -np.pi / 8], "a_0 is missing"),
    ("motion.1", [0.5236, 0, 1.1781, -0.3927], "rounded"),
    ("motion.1", [np.pi / 6, 0, 1.2, ...], "Besides"),
    ("motion.1", [np.pi / 6, 0, 0, 10, -15, 6], "four"),
    ("motion.2", cubic, "This is the cubic"),
    ("motion.2", lambda q0, q1, T, t: [q0 + (q1 - q0) * t / T, (q1 - q0) / T, 0],
     "constant rate"),
    ("motion.2", exchanged, "The factors are in the wrong order"),
    ("motion.2", plus_15, "sign of 15"),
    ("motion.2", entries(lambda r, q0, q1, T: r * [1, T, T**2]), "each derivative brings 1 / T"),
    ("motion.2", entries(lambda r, q0, q1, T: r * [1, 1, T]), "each of both derivatives"),
    ("motion.2", entries(lambda r, q0, q1, T: r * [1, T, 1]), "The rate is divided by T"),
    ("motion.2", lambda q0, q1, T, t: quintic(q0, q1, 1, t), "not the time itself"),
    ("motion.2", lambda q0, q1, T, t: quintic(0, 1, T, t), "Begin at q0"),
    ("motion.2", entries(lambda r, q0, q1, T: r - [q0, 0, 0]), "Where it begins is missing"),
    ("motion.2", lambda q0, q1, T, t: quintic(q0, q0 + q1, T, t), "the change is q1 - q0"),
    ("motion.2", entries(lambda r, q0, q1, T: r / [1, q1 - q0, q1 - q0]), "Rate and acceleration"),
    ("motion.2", entries(lambda r, q0, q1, T: r + [0, q0, q0]), "q0 is not in it"),
    ("motion.2", lambda q0, q1, T, t: quintic(q1, q0, T, t), "from q1 to q0"),
    ("motion.2", entries(lambda r, q0, q1, T: r[:2]), "three numbers"),
    ("motion.2", lambda q0, q1, T: 0, "raised TypeError"),
    ("motion.3", no_brake, "The end is missing"),
    ("motion.3", lambda way, v, a: [v / a, way / v + v / (2 * a)], "The end is missing"),
    ("motion.3", lambda way, v, a: [trapezoid(way, v, a)[0], no_brake(way, v, a)[1]
                                    if way > v**2 / a else trapezoid(way, v, a)[1]],
     "The end is missing"),
    ("motion.3", unchecked, "On a short way"),
    ("motion.3", lambda way, v, a: trapezoid(way, v, a) if way < v * v / a / 2 else
     unchecked(way, v, a), "holds both"),
    ("motion.3", lambda way, v, a: [v / a, way / v], "full speed all the way"),
    ("motion.3", lambda way, v, a: [v / a, way / v + 2 * v / a], "half of its speed"),
    ("motion.3", lambda way, v, a: [a / v, way / v + a / v], "speed / acceleration"),
    ("motion.3", short_as(lambda way, a: [np.sqrt(way / 2 / a), 2 * np.sqrt(way / 2 / a)]),
     "half of the way"),
    ("motion.3", short_as(lambda way, a: [np.sqrt(2 * way / a), 2 * np.sqrt(2 * way / a)]),
     "half of the way"),
    ("motion.3", short_as(lambda way, a: [np.sqrt(way / a)] * 2), "slowing down takes as long"),
    ("motion.3", lambda way, v, a: trapezoid(way, v, a)[::-1], "another order"),
    ("motion.3", lambda way, v, a: trapezoid(way, v, a)[1], "two numbers"),
    ("motion.4", ratios(lambda fast, hard: max(1, fast, hard)), "the root"),
    ("motion.4", ratios(lambda fast, hard: max(1, fast**0.5, hard**0.5)), "Rates fall with k"),
    ("motion.4", ratios(lambda fast, hard: max(1, fast)), "Only the rates"),
    ("motion.4", ratios(lambda fast, hard: max(1, hard**0.5)), "Only the accelerations"),
    ("motion.4", ratios(lambda fast, hard: fast), "Only the rates"),
    ("motion.4", ratios(lambda fast, hard: hard**0.5), "Only the accelerations"),
    ("motion.4", ratios(lambda fast, hard: max(1, min(fast, hard**0.5))), "not the smaller one"),
    ("motion.4", ratios(lambda fast, hard: max(fast, hard**0.5)), "k is 1 at least"),
    ("motion.4", lambda rates, accelerations, speed, acceleration: max(
        1, (rates / speed).max(), (accelerations / acceleration).max()**0.5), "np.abs"),
    ("motion.4", lambda rates, accelerations, speed, acceleration: max(
        1, (rates / speed).max(), (abs(accelerations) / acceleration).max()**0.5),
     "np.abs of the rates"),
    ("motion.4", lambda rates, accelerations, speed, acceleration: max(
        (rates / speed).max(), (abs(accelerations) / acceleration).max()**0.5),
     "np.abs of the rates"),
    ("motion.4", lambda rates, accelerations, speed, acceleration: max(
        1, (abs(rates) / speed).max(), (accelerations / acceleration).max()**0.5),
     "np.abs of the accelerations"),
    ("motion.4", lambda rates, accelerations, speed, acceleration: max(
        1, abs((rates / speed).max()), abs((accelerations / acceleration).max())**0.5), "np.abs"),
    ("motion.4", lambda rates, accelerations, speed, acceleration: max(
        1, abs(rates).max() / max(speed), (abs(accelerations).max() / max(acceleration))**0.5),
     "divide first"),
    ("motion.4", ratios(lambda fast, hard: 1 / max(1, fast, hard**0.5)), "1 / k"),
    ("motion.4", ratios(lambda fast, hard: max(1, fast**2, hard)), "square of k"),
    ("motion.4", ratios(lambda fast, hard: max(1, fast) * max(1, hard**0.5)),
     "One after the other"),
    ("motion.4", lambda *given: [1, 2], "number"),
    ("motion.5", (1, 0), "x and y have changed places"),
    ("motion.5", (0, 1000), "millimetres"),
    ("motion.5", (0, -1.2), "On the other side"),
    ("motion.5", (0, 0.1), "has to race"),
    ("motion.5", (0, 0.3), "On the second line joint 1 has to turn by 2.36 rad/s"),
    ("motion.5", (0.5, 1), "much longer"),
    ("motion.5", (0, 1.8), "So far out"),
    ("motion.5", (0, 2.5), "2.5 m from the base"),
    ("motion.5", (0, 2), "stretched, and that is singular"),
    ("motion.5", (1.2, 1.6), "stretched, and that is singular"),
    ("motion.5", (1.2, 0.1), "at one end of the way"),
    ("motion.5", (0, 0), "cannot go on"),
    ("motion.5", (0, 1, 0), "two numbers"),
    ("motion.5", 1, "two numbers"),
]

STUBS = [("motion.1", ...), ("motion.1", [..., ..., ..., ...]),
         ("motion.2", lambda q0, q1, T, t: ...), ("motion.3", ...),
         ("motion.4", lambda *given: ...), ("motion.5", ...), ("motion.5", (..., ...))]
