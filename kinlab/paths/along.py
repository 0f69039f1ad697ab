"""Joints that follow a line in time: at the samples, between them, and how fast."""
from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from .branch import Branch, Lost, Walk
from .core import Core
from .path import States
from .profiles import Profile

STRIDE = 1e-3  # rad: how far joints are moved along the line to see dq/ds change
NEAR = 5e-4    # of the duration: the times beside a singular one that say what holds there

Postures = Callable[[np.ndarray], np.ndarray]  # values of joints (m, k) at times


@dataclass(frozen=True, eq=False)
class Along:
    """The joints of a core that follow a line in time. Samples are known; what lies between starts
    from one.
    """

    core: Core
    branch: Branch
    duration: float
    profile: Profile
    times: np.ndarray   # (m,)
    values: np.ndarray  # (m, k), of the core's joints

    def joints(self, times: np.ndarray) -> np.ndarray:
        """Joint values of the arm."""
        return self.core.joints(self._near(times))

    def states(self, times: np.ndarray) -> States:
        """Joint values, rates and accelerations of the arm."""
        return self._derived(times, self._near(times), self._near)

    def samples(self) -> States:
        """The same, at the samples.

        Raises
        ------
        Lost
            If no posture leads on beside one of them that is singular.
        """
        return self._derived(self.times, self.values, self._followed)

    def _derived(self, times: np.ndarray, q: np.ndarray, beside: Postures) -> States:
        rates, accelerations, regular = self._regular(times, q)
        for k in np.flatnonzero(~regular):
            rates[k], accelerations[k] = self._limits(float(times[k]), beside)
        return self.core.joints(q), self.core.rates(rates), self.core.rates(accelerations)

    def _regular(self, times: np.ndarray, q: np.ndarray
                 ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Rates and accelerations by the Jacobian, and where they hold.

        The rate is dq/ds s', exactly. d2q/ds2 is how dq/ds changes on a stride along the line, by
        four of its values (an error of the fourth order); a stride is short beside the way to a
        singular place.
        """
        s, ds, dds = self.profile.curve(times / self.duration)
        slopes, ratios = self.branch.slopes(s, q)
        size = np.abs(slopes).max(axis=1)
        h = STRIDE * np.minimum(1.0, 10 * ratios + 1e-6) / np.maximum(1.0, size)
        bends = sum(weight * self.branch.slopes(s + k * h, q + (k * h)[:, None] * slopes)[0]
                    for k, weight in ((-2, 1), (-1, -8), (1, 8), (2, -1))) / (12 * h)[:, None]
        rate, acceleration = ds[:, None] / self.duration, dds[:, None] / self.duration**2
        return (slopes * rate, bends * rate**2 + slopes * acceleration,
                self.branch.sure(s, q))

    def _followed(self, times: np.ndarray) -> np.ndarray:
        """Values of the core's joints (m, k), each by a step from the sample before."""
        return self._each(times, self._after)

    def _near(self, times: np.ndarray) -> np.ndarray:
        """The same, where no such step leads there by one back from the sample behind."""
        return self._each(times, self._between)

    def _each(self, times: np.ndarray, posture: Callable[[int, float], np.ndarray]) -> np.ndarray:
        values = np.empty((len(times), self.values.shape[1]))
        for i, time in enumerate(times.tolist()):
            k = int(np.searchsorted(self.times, time, "right")) - 1
            values[i] = self.values[k] if self.times[k] == time else posture(k, time)
        return values

    def _after(self, k: int, time: float) -> np.ndarray:
        return self._step(k, k + 1, time)

    def _between(self, k: int, time: float) -> np.ndarray:
        for start, other in ((k, k + 1), (k + 1, k)):
            with suppress(Lost):
                return self._step(start, other, time)
        part = (time - self.times[k]) / (self.times[k + 1] - self.times[k])
        return self.values[k] + part * (self.values[k + 1] - self.values[k])

    def _step(self, k: int, other: int, time: float) -> np.ndarray:
        """From sample k on the way to another one."""
        ahead = self.share(self.times[other]) - self.share(self.times[k])
        slope = (self.values[other] - self.values[k]) / ahead if ahead else None
        walk = Walk(self.branch, self.share, [float(self.times[k])], [self.values[k]], slope)
        walk.on(time)
        return walk.joints[-1]

    def share(self, time: float) -> float:
        """The part of the line that is gone."""
        return float(self.profile.curve(np.asarray(time / self.duration))[0])

    def _limits(self, time: float, beside: Postures) -> tuple[np.ndarray, np.ndarray]:
        """What rates and accelerations come to near a singular place, from the side of the path
        that is longer.
        """
        side = NEAR * self.duration * (1 if time < self.duration / 2 else -1)
        times = time + side * np.array([1, 2, 4])
        rates, accelerations, _ = self._regular(times, beside(times))
        return _limit(*rates), _limit(*accelerations)


def _limit(near: np.ndarray, middle: np.ndarray, far: np.ndarray) -> np.ndarray:
    """Where three values go that were read at 1, 2 and 4 steps from a place (Aitken's rule).

    Infinite if they grow without end: by steps that do not become shorter.
    """
    last, before = near - middle, middle - far
    ratio = last / np.where(before == 0, 1, before)
    moves = np.abs(last) > 1e-9 * (1 + np.abs(near))
    grows = moves & (np.abs(ratio) >= 0.999) & (np.abs(near) > np.abs(middle))
    steady = np.where(moves & (np.abs(ratio) < 0.999), ratio, 0)
    return np.where(grows, np.copysign(np.inf, near), near + last * steady / (1 - steady))
