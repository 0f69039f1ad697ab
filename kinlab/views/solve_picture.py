"""One solve of inverse kinematics, step by step, two methods side by side."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..arms import inputs
from ..arms.arm import Arm, _check_arm
from ..arms.kinematics import forward_kinematics
from ..arms.motions import TRANSLATE
from ..drawing.arm_scene import arm_scene, is_planar
from ..drawing.scene import LINE, PLANAR, TEXT, Entry, Item, Point, Reading, Scene, Step, at, circle
from ..ik.descent import METHODS
from ..ik.solve import inverse_kinematics
from .live import Knob, LiveView

SIZE, HEART = (940.0, 570.0), (470.0, 208.0)   # px: the picture, and the middle of the arms
_LEFT, _RIGHT, _TOP, _BOTTOM = 70.0, 915.0, 436.0, 540.0  # px: the error curve
_HIGH, _LOW = 1, -9  # decades of the error that the curve shows
_STYLES, _WORDS = ("first", "second"), ("x", "z")
_HIDDEN = ("frame-", "label-", "axis-", "trace", "ghost")
_PRESETS = {"3-D": (-60.0, 24.0), "top": (-90.0, 90.0), "front": (-90.0, 0.0)}


def solve_view(arm: Arm, target: Any, q0: Any = None, *, weights: Any = None,
               methods: Sequence[str] = ("newton", "damped"), steps: int = 20,
               limits: str = "keep") -> LiveView:
    """Two methods on the way from one start to one target: scrub through their steps.

    Above stand the arms at the step, with the path of the tool so far and to come; below, the
    error of each step in powers of ten. Each method begins at `q0` and is not started again.

    Parameters
    ----------
    arm : Arm
    target : array, shape (4, 4) or (3,)
        Pose of the tool in the room, or the tool point alone.
    q0 : array, shape (n,), optional
        Where to begin; the arm's home if left out.
    weights : six numbers, or three for a point, optional
        As in `inverse_kinematics`. For a point and a planar arm, 1, 1, 0.
    methods : two of {"newton", "damped", "pseudoinverse", "transpose"}
    steps : int
        At most so many.
    limits : {"keep", "ignore"}
        Whether joint limits hold.

    Returns
    -------
    LiveView
        Its knob is "step", its readings are named by the methods: error and condition number.

    Raises
    ------
    ValueError
        If an argument does not fit.

    Examples
    --------
    >>> from kinlab import robots
    >>> view = solve_view(robots.two_link(), [0.5, 1, 0], q0=[0.2, 0.4])
    >>> view["step"].value = 3
    >>> [reading[0] for reading in view.readings.values()]
    ['0.0765', '0.000351']
    """
    _check_arm(arm)
    methods = _two(methods)
    if weights is None and is_planar(arm) and np.shape(target) == (3,):
        weights = (1, 1, 0)
    trails = [inverse_kinematics(arm, target, q0, method=method, weights=weights, steps=steps,
                                 restarts=0, limits=limits).history for method in methods]
    last = max(map(len, trails)) - 1
    sketch = _Solves(arm, np.asarray(target, dtype=float))
    for k, (method, trail) in enumerate(zip(methods, trails)):
        sketch.stand(k, method, trail)
    sketch.chart(methods, trails, max(last, 1))
    knob = Knob("step", "step", 0.0, float(max(last, 1)), 0.0, "", 1.0, 1.0, "step of the solve")
    return LiveView(sketch.scene(), [knob], name=f"{arm.name or 'Arm'}: {' and '.join(methods)}",
                    panels={"poses": [[float(k)] for k in range(last + 1)]})


def _two(methods: Any) -> tuple[str, str]:
    pair = tuple(methods) if isinstance(methods, (list, tuple)) else (methods,)
    if len(pair) != 2 or pair[0] == pair[1]:
        raise ValueError(f"methods: expected two different ones, got {inputs.brief(methods)}; "
                         f"choose from {', '.join(METHODS)}")
    return tuple(inputs.choice("methods", method, tuple(METHODS)) for method in pair)


class _Solves:
    """The picture under construction: two arms in one room, a curve on paper under them."""

    def __init__(self, arm: Arm, target: np.ndarray) -> None:
        self.arm, self.drawing = arm, arm_scene(arm)
        self.goal = target[:3, 3] if target.ndim == 2 else target
        self.steps: list[Step] = []
        self.items: list[Item] = []
        self.readings: list[Reading] = []
        reach = self.drawing.radius
        self.px = reach / (HEART[1] - 6)   # length units to a pixel
        self.radius = (min(SIZE) / 2 - 10) * self.px
        self.aside = 1.06 * reach

    def stand(self, k: int, method: str, trail: Sequence) -> None:
        """One arm on its side of the room, moving along its trail, with the tool's path."""
        root = self._root((2 * k - 1) * self.aside)
        tracks = np.array([step.q for step in trail]).T.tolist()
        for step in self.drawing.motions:
            if step.joint is not None:
                step = replace(step, joint=0, track=tuple(
                    step.amount + step.gain * value for value in tracks[step.joint]))
            self.steps.append(step)
        for item in self.drawing.items:
            if not item.gid.startswith(_HIDDEN):
                points = tuple((frame + root, *local) for frame, *local in item.points)
                body = item.body if item.body < 0 else item.body + 1000 * k
                self.items.append(replace(item, gid=f"{method}-{item.gid}", points=points,
                                          body=body))
        places = forward_kinematics(self.arm, np.array(tracks).T)[:, :3, 3]
        self._add(f"{method}-path", "trace", at(root, *places), lift=2 * self.radius)
        ring = self.goal + 0.05 * self.drawing.radius * circle(25)
        self._add(f"{method}-target", "target", at(root, *ring), lift=3 * self.radius)
        self._word(method, (HEART[0] + (2 * k - 1) * 0.25 * SIZE[0], 14.0), _WORDS[k])

    def chart(self, methods: Sequence[str], trails: Sequence, last: int) -> None:
        """The errors in powers of ten, a dot on each curve at the step shown."""
        self._grid(last)
        for method, style, trail in zip(methods, _STYLES, trails):
            heights = [_decade(step.error) for step in trail]
            curve = [self._place(j / last, height) for j, height in enumerate(heights)]
            self._add(f"{method}-curve", style, at(0, *curve), paper=True)
            dot = self._dot(curve, last)
            short = 1e-3 * self.radius
            self._add(f"{method}-dot", f"{style}-dot", at(dot, (0, 0, 0), (short, short, 0)),
                      paper=True, lift=self.radius)
            self.readings.append(Reading(method, f"{method}: error {{}}, condition number {{}}", (
                Entry(0, tuple(f"{step.error:.3g}" for step in trail)),
                Entry(0, tuple("∞" if np.isinf(step.condition) else f"{step.condition:.3g}"
                               for step in trail)))))

    def scene(self) -> Scene:
        """What has been drawn."""
        presets = PLANAR if is_planar(self.arm) else _PRESETS
        return Scene(tuple(self.steps), tuple(self.items), 0, (0.0, 0.0, 0.0), self.radius, SIZE,
                     dict(presets), tuple(self.readings), place=HEART)

    def _root(self, aside: float) -> int:
        """A frame at the foot of one arm, so that the middle of its reach is in its place."""
        shift = np.array([aside, 0, 0]) - self.drawing.center
        for axis, way in enumerate(shift.tolist()):
            self.steps.append(Step(TRANSLATE, axis, way, parent=None if axis else 0))
        return len(self.steps)

    def _dot(self, curve: Sequence[Point], last: int) -> int:
        """A frame that runs along a curve with the step."""
        ends = [*curve, *[curve[-1]] * (last + 1 - len(curve))]
        for axis, track in enumerate(np.array(ends).T[:2].tolist()):
            self.steps.append(Step(TRANSLATE, axis, joint=0, track=tuple(track),
                                   parent=None if axis else 0))
        return len(self.steps)

    def _grid(self, last: int) -> None:
        for height in range(_LOW, _HIGH + 1, 2):
            ends = [self._place(share, height) for share in (0, 1)]
            self._add(f"decade{height}", "ground", at(0, *ends), paper=True, body=-1)
            x, y = _LEFT - 26, _TOP + (_HIGH - height) / (_HIGH - _LOW) * (_BOTTOM - _TOP)
            self._word(f"10{_raised(height)}", (x, y), "ink")
        for step in range(0, last + 1, max(1, round(last / 10))):
            self._word(str(step), (_LEFT + step / last * (_RIGHT - _LEFT), _BOTTOM + 18), "ink")
        self._word("error at each step", (_LEFT + 50, _TOP - 14), "ink")

    def _place(self, share: float, height: float) -> tuple[float, float, float]:
        """A point of the curve as paper has it: share of the width, decade of the error."""
        x = _LEFT + share * (_RIGHT - _LEFT)
        y = _TOP + (_HIGH - height) / (_HIGH - _LOW) * (_BOTTOM - _TOP)
        return self._paper(x, y)

    def _paper(self, x: float, y: float) -> tuple[float, float, float]:
        return (self.px * (x - HEART[0]), self.px * (HEART[1] - y), 0.0)

    def _word(self, text: str, place: tuple[float, float], style: str) -> None:
        self.items.append(Item(f"word-{len(self.items)}", TEXT, style, at(0, self._paper(*place)),
                               5000 + len(self.items), text=text, paper=True))

    def _add(self, gid: str, style: str, points: tuple[Point, ...], *, body: int | None = None,
             **options: Any) -> None:
        body = 5000 + len(self.items) if body is None else body
        self.items.append(Item(gid, LINE, style, points, body, **options))


def _decade(error: float) -> float:
    return float(np.clip(np.log10(max(error, 1e-300)), _LOW, _HIGH))


def _raised(power: int) -> str:
    return str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
