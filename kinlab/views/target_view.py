"""A target to drag, and an arm that follows it: inverse kinematics under the hand."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import ipywidgets
import numpy as np

from ..arms import inputs
from ..arms.arm import Arm
from ..arms.joints import first_pose, one_pose
from ..arms.kinematics import forward_kinematics
from ..arms.motions import TRANSLATE
from ..drawing.arm_scene import arm_scene, is_planar
from ..drawing.scene import (
    LINE,
    PLANAR,
    SPATIAL,
    TEXT,
    Item,
    Reading,
    Scene,
    Step,
    Vector,
    at,
    circle,
)
from ..ik.solve import inverse_kinematics
from .arm_view import (
    joint_knob,
    joints_text,
    layers,
    pose_table,
    switches,
    tour,
)
from .live import Knob, LiveView, numbers

_AXES = np.eye(3)


class TargetView(LiveView):
    """An arm that follows a target which is dragged in the picture.

    Drag the ring, or set its coordinates by their sliders: the joints follow by damped steps of
    inverse kinematics, for the tool point alone. Move a joint, and the target rides on the tool.
    A planar arm keeps to its plane; in space the ring moves in the plane of the picture.

    Parameters
    ----------
    arm : Arm
    q : array, shape (n,), optional
        Joint values to begin with (rad or length); the arm's home if left out.
    show : sequence of {"frames", "labels", "axes", "trace", "ghost"}
        What is switched on to begin with.

    Attributes
    ----------
    q : array, shape (n,)
        Joint values (rad or length). Setting it takes the target along.
    target : array, shape (3,)
        Where the tool point is wanted, in the room. Setting it moves the arm by
        `inverse_kinematics`, as near to the target as it gets.
    error : float
        Distance from the tool point to the target.
    T : array, shape (4, 4)
        Pose of the tool, `forward_kinematics(arm, q)`.
    joints : list of ipywidgets.FloatSlider
        One per joint, in degrees or the arm's unit.

    Raises
    ------
    ValueError
        If an argument does not fit the arm.

    Examples
    --------
    >>> from kinlab import robots
    >>> view = TargetView(robots.two_link(), q=[0, np.pi / 2])
    >>> view.target = (0, 1, 0)
    >>> round(view.error, 6)
    0.0
    """

    def __init__(self, arm: Arm, q: Any = None, *, show: Sequence[str] = ("labels", "frames")
                 ) -> None:
        start = first_pose(arm, q)
        self.arm, show = arm, layers(show)
        axes = 2 if is_planar(arm) else 3
        scene, place = _scene(arm, axes), _tool(arm, start)
        joints = [joint_knob(arm, i) for i in range(arm.n)]
        knobs = [*(replace(knob, home=value) for knob, value in zip(joints, start.tolist())),
                 *(_knob(arm, scene, axis, place) for axis in range(axes))]
        ring = {"frame": len(scene.motions), "tip": scene.tip, "joints": arm.n, "unit": arm.unit,
                "knobs": list(range(arm.n, arm.n + axes))}
        panels = {"target": ring, "pose": pose_table(arm, scene.radius), "layers": switches(show),
                  "poses": [[*pose, *_tool(arm, pose)[:axes]] for pose in tour(joints).tolist()]}
        super().__init__(scene, knobs, name=arm.name or "Arm", panels=panels, show=show)
        self.q = start

    @property
    def joints(self) -> list[ipywidgets.FloatSlider]:
        return self.sliders[:self.arm.n]

    @property
    def q(self) -> np.ndarray:
        return self._values[:self.arm.n]

    @q.setter
    def q(self, q: Any) -> None:
        q = one_pose(self.arm, q)
        self._move(np.concatenate([q, _tool(self.arm, q)[:self._axes]]))

    @property
    def target(self) -> np.ndarray:
        return np.concatenate([self._values[self.arm.n:], self._height])

    @target.setter
    def target(self, place: Any) -> None:
        place = inputs.shaped("target", place, (3,), "a point (x, y, z)")
        weights = (_AXES[:self._axes].sum(axis=0)).tolist()
        found = inverse_kinematics(self.arm, place, self.q, weights=weights)
        self._move(np.concatenate([found.q, place[:self._axes]]))

    @property
    def error(self) -> float:
        return float(np.linalg.norm(self.target - self.T[:3, 3]))

    @property
    def T(self) -> np.ndarray:
        return forward_kinematics(self.arm, self.q)

    def __repr__(self) -> str:
        name = f"{self.arm.name!r}, " if self.arm.name else ""
        q = joints_text(self.arm, [slider.value for slider in self.joints])
        return (f"TargetView({name}q={q}, target=[{numbers(self.target)}] {self.arm.unit}, "
                f"error={numbers([self.error])} {self.arm.unit})")

    @property
    def _axes(self) -> int:
        return len(self.sliders) - self.arm.n

    @property
    def _height(self) -> np.ndarray:
        """The coordinates of the target that a planar arm cannot change."""
        return self.T[self._axes:3, 3]


def _tool(arm: Arm, q: Any) -> np.ndarray:
    return forward_kinematics(arm, q)[:3, 3]


def _knob(arm: Arm, scene: Scene, axis: int, place: np.ndarray) -> Knob:
    low, high = (scene.center[axis] + side * scene.radius for side in (-1, 1))
    letter = "xyz"[axis]
    return Knob.length(letter, f"{letter}*", low, high, float(place[axis]), arm.unit,
                       f"target along {letter}")


def _scene(arm: Arm, axes: int) -> Scene:
    """The arm, a ring at the target, and a dashed line for what is missing."""
    scene = arm_scene(arm)
    tip, size = len(scene.motions), scene.radius
    height = float(_tool(arm, arm.home)[2]) if axes == 2 else 0.0
    steps = [Step(TRANSLATE, axis, 0.0, arm.n + axis, parent=None if axis else 0)
             for axis in range(axes)]
    if axes == 2:
        steps.append(Step(TRANSLATE, 2, height))
    ring = tip + len(steps)
    items = (Item("miss", LINE, "miss", (*at(tip, (0, 0, 0)), *at(ring, (0, 0, 0))), 9998,
                  lift=4 * size), *_ring(ring, size))
    presets = dict(PLANAR if axes == 2 else SPATIAL)
    readings = tuple(
        Reading(name, f"{name} {letter} = {{}} {arm.unit}",
                (Vector((0, 0.0, 0.0, 0.0), (frame, 0.0, 0.0, 0.0), size=axes),))
        for name, letter, frame in (("target", "p*", ring), ("tool", "p", tip)))
    return replace(scene, motions=(*scene.motions, *steps), items=(*scene.items, *items),
                   presets=presets, readings=readings)


def _ring(frame: int, size: float) -> list[Item]:
    """Three circles, so that a ring is seen from every side, and a star beside it."""
    rings = [np.roll(0.045 * size * circle(25), turn, axis=1) for turn in range(3)]
    items = [Item(f"target-{k}", LINE, "target", at(frame, *ring), 9999, lift=5 * size)
             for k, ring in enumerate(rings)]
    name = Item("target-name", TEXT, "ink", at(frame, (0.09 * size, 0.05 * size, 0.05 * size)),
                9999, text="p*", lift=5 * size)
    return [*items, name]
