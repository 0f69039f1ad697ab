"""How a motion spends its time: the part s of its way that is gone, and how fast that grows.

Each profile goes from s = 0 to s = 1 while the part tau of the time goes from 0 to 1, from rest to
rest. Sources: Spong, Hutchinson and Vidyasagar, section 5.5; Craig, section 7.3.
"""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import sqrt
from typing import Any

import numpy as np

from ..arms import inputs

Curve = tuple[np.ndarray, np.ndarray, np.ndarray]  # s, ds/dtau, d2s/dtau2
RAMP = 1 / 3
SHORTEST, LONGEST = 1e-3, 1e5  # s
JUMP = 1e-6  # of the time: so soon after a jump its other side is a mark, too


@dataclass(frozen=True)
class Profile:
    """A profile by its name.

    Attributes
    ----------
    curve : function
        Of tau, an array: s and its first and second derivative by tau.
    marks : tuple of float
        The tau, between 0 and 1, at which a derivative is largest, or jumps.
    """

    name: str
    curve: Callable[[np.ndarray], Curve]
    marks: tuple[float, ...]


def given_duration(duration: Any) -> float:
    """Seconds that a motion takes, checked."""
    seconds = inputs.positive("duration", duration)
    if not SHORTEST <= seconds <= LONGEST:
        raise ValueError(f"duration: expected seconds, from {SHORTEST:g} to {LONGEST:g}, got "
                         f"{seconds:g}; look for a slip in the unit")
    return seconds


def given_profile(name: Any, ramp: Any = RAMP) -> Profile:
    """The profile that the arguments of a path name, checked."""
    inputs.choice("profile", name, (*_POLYNOMIALS, "trapezoidal"))
    ramp = inputs.number("ramp", ramp)
    if not 0 < ramp <= 0.5:
        raise ValueError("ramp: expected the part of the time that is spent speeding up, above 0 "
                         f"and up to 0.5, got {ramp:g}; write ramp=1/3")
    if name != "trapezoidal":
        return Profile(name, *_POLYNOMIALS[name])
    ends = (ramp, 1 - ramp)
    beside = (ramp + JUMP, 1 - ramp - JUMP)
    return Profile(name, partial(trapezoidal, ramp=ramp), tuple(sorted({*ends, *beside})))


def cubic(tau: np.ndarray) -> Curve:
    """s = 3 tau^2 - 2 tau^3: its rate is 1.5 at most, its acceleration begins at 6.

    Examples
    --------
    >>> [float(value) for value in cubic(np.array(0.5))]
    [0.5, 1.5, 0.0]
    """
    return tau**2 * (3 - 2 * tau), 6 * tau * (1 - tau), 6 - 12 * tau


def quintic(tau: np.ndarray) -> Curve:
    """s = 10 tau^3 - 15 tau^4 + 6 tau^5: its acceleration, too, begins and ends at 0.

    Examples
    --------
    >>> [float(value) for value in quintic(np.array(0.5))]
    [0.5, 1.875, 0.0]
    """
    return (tau**3 * (10 - 15 * tau + 6 * tau**2), 30 * tau**2 * (1 - tau)**2,
            60 * tau * (1 - tau) * (1 - 2 * tau))


def trapezoidal(tau: np.ndarray, ramp: float) -> Curve:
    """Speeds up evenly for the part `ramp` of the time, then goes evenly, then slows down evenly.

    Examples
    --------
    >>> [round(float(value), 9) for value in trapezoidal(np.array(0.25), ramp=0.25)]
    [0.166666667, 1.333333333, 5.333333333]
    """
    top = 1 / (1 - ramp)
    left = np.minimum(tau, 1 - tau)  # the second half is the first one, backwards
    half = np.where(left < ramp, 0.5 * top * left**2 / ramp, top * (left - 0.5 * ramp))
    speeds = (top / ramp) * (left <= ramp * (1 + 1e-12))  # its ends too, whatever they round to
    return (np.where(tau <= 0.5, half, 1 - half), top * np.minimum(left / ramp, 1.0),
            np.where(tau <= 0.5, speeds, -speeds))


_POLYNOMIALS: dict[str, tuple[Callable[[np.ndarray], Curve], tuple[float, ...]]] = {
    "cubic": (cubic, (0.5,)),
    "quintic": (quintic, (0.5 - sqrt(3) / 6, 0.5, 0.5 + sqrt(3) / 6)),
}
