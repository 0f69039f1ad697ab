"""One solve of inverse kinematics, step by step, two methods side by side."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import forward_kinematics
from ..arms.motions import TRANSLATE
from .arm_scene import arm_scene, is_planar
from .controls import Knob, superscript
from .readings import Entry, Point
from .scene import LINE, TEXT, Scene, Step, at, circle
from .sketch import Sketch

SIZE, HEART = (940.0, 570.0), (470.0, 208.0)   # px: the picture, and the middle of the arms
_LEFT, _RIGHT, _TOP, _BOTTOM = 70.0, 915.0, 436.0, 540.0  # px: the error curve
_HIGH, _LOW = 1, -9  # decades of the error that the curve shows
_STYLES = ("first", "second")


class Tried(Protocol):
    """One step of a solve, as inverse kinematics keeps it."""

    @property
    def q(self) -> np.ndarray: ...

    @property
    def error(self) -> float: ...

    @property
    def condition(self) -> float: ...


def solve_scene(arm: Arm, goal: np.ndarray, trails: Mapping[str, Sequence[Tried]]) -> Scene:
    """The arm twice, on its way to a point by two methods, and the error of each step."""
    last = max(map(len, trails.values())) - 1
    sketch = _Solves(arm, goal)
    sketch.name = f"{sketch.name}: {' and '.join(trails)}"
    for k, (method, trail) in enumerate(trails.items()):
        sketch.stand(k, method, trail)
    sketch.chart(trails, max(last, 1))
    sketch.knob(Knob("step", "step", 0.0, float(max(last, 1)), title="step of the solve",
                     whole=True))
    sketch.poses = [[float(k)] for k in range(last + 1)]
    return sketch.scene()


class _Solves(Sketch):
    """Two arms in one room, a curve on paper under them."""

    def __init__(self, arm: Arm, goal: np.ndarray) -> None:
        self.arm, self.drawing, self.goal = arm, arm_scene(arm), goal
        reach = self.drawing.radius
        self.px = reach / (HEART[1] - 6)   # length units to a pixel
        super().__init__(arm.name or "Arm", (min(SIZE) / 2 - 10) * self.px, planar=is_planar(arm),
                         grid=False)
        self.size, self.place, self.aside = SIZE, HEART, 1.06 * reach
        self.presets.pop("side", None)     # there one arm hides the other

    def stand(self, k: int, method: str, trail: Sequence[Tried]) -> None:
        """One arm on its side of the room, moving along its trail, with the tool's path."""
        root = self._root((2 * k - 1) * self.aside)
        tracks = np.array([step.q for step in trail]).T.tolist()
        for step in self.drawing.motions:
            if isinstance(step, Step) and step.joint is not None:
                step = replace(step, joint=0, track=tuple(
                    step.amount + step.gain * value for value in tracks[step.joint]))
            self.steps.append(step)
        self.lay((item for item in self.drawing.items if not item.layer), root, f"{method}-")
        places = forward_kinematics(self.arm, np.array(tracks).T)[:, :3, 3]
        self.add(f"{method}-path", LINE, "trace", at(root, *places), lift=2 * self.radius)
        ring = self.goal + 0.05 * self.drawing.radius * circle(25)
        self.add(f"{method}-target", LINE, "target", at(root, *ring), lift=3 * self.radius)
        self._word(method, (HEART[0] + (2 * k - 1) * 0.25 * SIZE[0], 14.0), _STYLES[k])

    def chart(self, trails: Mapping[str, Sequence[Tried]], last: int) -> None:
        """The errors in powers of ten, a dot on each curve at the step shown."""
        self._grid(last)
        for (method, trail), style in zip(trails.items(), _STYLES):
            heights = [_decade(step.error) for step in trail]
            curve = [self._place(j / last, height) for j, height in enumerate(heights)]
            self._draw(f"{method}-curve", style, at(0, *curve))
            short = 1e-3 * self.radius
            self._draw(f"{method}-dot", f"{style}-dot",
                       at(self._dot(curve, last), (0, 0, 0), (short, short, 0)), self.radius)
            self.reading(method, f"{method}: error {{}}, condition number {{}}",
                         Entry(0, tuple(f"{step.error:.3g}" for step in trail)),
                         Entry(0, tuple("∞" if np.isinf(step.condition) else
                                        f"{step.condition:.3g}" for step in trail)))

    def _root(self, aside: float) -> int:
        """A frame at the foot of one arm, so that the middle of its reach is in its place."""
        shift = np.array([aside, 0, 0]) - self.drawing.center
        for axis, way in enumerate(shift.tolist()):
            self.move(TRANSLATE, axis, way, parent=None if axis else 0)
        return len(self.steps)

    def _dot(self, curve: Sequence[tuple[float, float, float]], last: int) -> int:
        """A frame that runs along a curve with the step."""
        ends = [*curve, *[curve[-1]] * (last + 1 - len(curve))]
        for axis, track in enumerate(np.array(ends).T[:2].tolist()):
            self.move(TRANSLATE, axis, knob=0, parent=None if axis else 0, track=tuple(track))
        return len(self.steps)

    def _grid(self, last: int) -> None:
        for height in range(_LOW, _HIGH + 1, 2):
            ends = [self._place(share, height) for share in (0, 1)]
            self.add(f"decade{height}", LINE, "ground", at(0, *ends), body=-1, paper=True)
            self._word(f"10{superscript(height)}", (_LEFT - 26, _down(height)), "ink")
        for step in range(0, last + 1, max(1, round(last / 10))):
            self._word(str(step), (_LEFT + step / last * (_RIGHT - _LEFT), _BOTTOM + 18), "ink")
        self._word("error at each step", (_LEFT + 50, _TOP - 14), "ink")

    def _place(self, share: float, height: float) -> tuple[float, float, float]:
        """A point of the curve as paper has it: share of the width, decade of the error."""
        return self._paper(_LEFT + share * (_RIGHT - _LEFT), _down(height))

    def _paper(self, x: float, y: float) -> tuple[float, float, float]:
        return (self.px * (x - HEART[0]), self.px * (HEART[1] - y), 0.0)

    def _word(self, text: str, place: tuple[float, float], style: str) -> None:
        self.add(f"word-{len(self.items)}", TEXT, style, at(0, self._paper(*place)), text,
                 paper=True)

    def _draw(self, gid: str, style: str, points: Iterable[Point], lift: float = 0.0) -> None:
        self.add(gid, LINE, style, points, lift=lift, paper=True)


def _down(height: float) -> float:
    """How far down the picture a decade of the error lies (px)."""
    return _TOP + (_HIGH - height) / (_HIGH - _LOW) * (_BOTTOM - _TOP)


def _decade(error: float) -> float:
    return float(np.clip(np.log10(max(error, 1e-300)), _LOW, _HIGH))
