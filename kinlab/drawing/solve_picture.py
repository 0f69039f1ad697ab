"""One solve of inverse kinematics, step by step: by one method, or by two side by side."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from ..arms.arm import Arm
from ..arms.kinematics import frame_poses, is_planar, tool_poses, typical_length
from ..arms.motions import TRANSLATE
from .arm_scene import arm_scene
from .chart import Chart, Curve
from .controls import Knob
from .readings import Entry
from .scene import LINE, TEXT, WAY, Fit, Scene, Step, at, circle
from .sketch import Sketch

SIZE = (940.0, 560.0)  # px
_STYLES, _MARKERS = ("first", "second"), ("dot", "square")
_GAP, _EDGE = 0.35, 0.12  # of the reach: between the arms, and round them


class Tried(Protocol):
    """One step of a solve, as inverse kinematics keeps it."""

    @property
    def q(self) -> np.ndarray: ...

    @property
    def error(self) -> float: ...


def solve_scene(arm: Arm, goal: np.ndarray, trails: Mapping[str, Sequence[Tried]]) -> Scene:
    """The arm on its way to a point, once for each method, and the error of each step.

    Errors, which a solve keeps as parts of the reach, are shown in the arm's unit.
    """
    last = max(map(len, trails.values())) - 1
    sketch = _Solves(arm, goal, alone=len(trails) == 1)
    sketch.name = f"{sketch.name}: {' and '.join(trails)}"
    for k, (method, trail) in enumerate(trails.items()):
        sketch.stand(k, method, trail)
    sketch.knob(Knob("step", "step", 0.0, float(max(last, 1)), title="step of the solve",
                     whole=True))
    sketch.poses = [[float(k)] for k in range(last + 1)]
    sketch.joints = ()
    return sketch.framed()


class _Solves(Sketch):
    """Two arms in one room, or one where it stands, and a chart."""

    def __init__(self, arm: Arm, goal: np.ndarray, alone: bool) -> None:
        self.arm, self.drawing, self.goal, self.alone = arm, arm_scene(arm), goal, alone
        self.reach = typical_length(arm)
        super().__init__(arm.name or "Arm", planar=is_planar(arm), unit=arm.unit, grid=False)
        self.size = SIZE
        self.presets.pop("side", None)     # there one arm hides the other
        self.curves: list[Curve] = []
        self.boxes: list[np.ndarray] = []  # lowest and highest corner of what each arm needs

    def stand(self, k: int, method: str, trail: Sequence[Tried]) -> None:
        """One arm on its side of the room, moving along its trail, with the tool's path."""
        joints = np.array([step.q for step in trail])
        root = self._root(k, joints)
        tracks = joints.T.tolist()
        for step in self.drawing.motions:
            if isinstance(step, Step) and step.joint is not None:
                step = replace(step, joint=0, track=tuple(
                    step.amount + step.gain * value for value in tracks[step.joint]))
            self.steps.append(step)
        self.lay((item for item in self.drawing.items if not item.layer), root, f"{method}-")
        self._way(method, root, tool_poses(self.arm, joints)[:, :3, 3])
        self._target(method, root)
        self._name(k, method)
        self._errors(k, method, trail)

    def framed(self) -> Scene:
        """The scene, in a frame that holds both arms at every step."""
        low, high = np.min(self.boxes, axis=(0, 1)), np.max(self.boxes, axis=(0, 1))
        corners = np.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)]
                            for k in range(8)])
        middle, radius = (low + high) / 2, float(np.sort(high - low)[1]) / 2
        self.center, self.radius = (*middle.tolist(),), radius
        thick = self.drawing.fit.thick if self.drawing.fit else 0.0
        fit = Fit((*middle.tolist(),), radius, thick, at(0, *corners))
        return replace(self.scene(), fit=fit,
                       chart=Chart(tuple(self.curves), "step", f"error ({self.unit})"))

    def _root(self, k: int, joints: np.ndarray) -> int:
        """A frame at the foot of one arm: the first one ends where the second begins."""
        box, gap = self._box(joints), _GAP * self.reach
        aside = -box[1, 0] - gap / 2 if k == 0 else gap / 2 - box[0, 0]
        aside *= not self.alone
        self.boxes.append(box + [aside, 0, 0])
        return self.move(TRANSLATE, 0, float(aside), parent=0)

    def _box(self, joints: np.ndarray) -> np.ndarray:
        """Lowest and highest corner of what an arm needs at all its steps, and of the goal."""
        places = np.concatenate([frame_poses(self.arm, joints)[..., :3, 3].reshape(-1, 3),
                                 tool_poses(self.arm, joints)[:, :3, 3], [self.goal]])
        edge = _EDGE * self.reach
        return np.array([places.min(axis=0) - edge, places.max(axis=0) + edge])

    def _way(self, method: str, root: int, places: np.ndarray) -> None:
        """The tool's way up to the step."""
        self.add(f"{method}-path", WAY, "trace", at(root, *places), lift=2 * self.reach, size=(0,),
                 part="trace")

    def _target(self, method: str, root: int) -> None:
        body = self.body()
        for k in range(1 if self.planar else 3):
            ring = self.goal + np.roll(0.05 * self.reach * circle(25), k, axis=1)
            self.add(f"{method}-target-{k}", LINE, "target", at(root, *ring),
                     lift=3 * self.reach, body=body, part="target")

    def _name(self, k: int, method: str) -> None:
        """The name of the method, over its arm."""
        low, high = self.boxes[k]
        top = [(low[0] + high[0]) / 2, high[1], high[2]]
        self.boxes[k][1, 1 if self.planar else 2] += 0.5 * _EDGE * self.reach
        self.add(f"{method}-name", TEXT, _STYLES[k], at(0, top), method, part="label")

    def _errors(self, k: int, method: str, trail: Sequence[Tried]) -> None:
        """The curve of the errors, and what is said of them at each step."""
        errors = [self.reach * step.error for step in trail]
        self.curves.append(Curve(method, _STYLES[k], _MARKERS[k], tuple(errors)))
        self.reading(method, f"{method}: error {{}} {self.unit}",
                     Entry(0, tuple(f"{error:.3g}" for error in errors)))
