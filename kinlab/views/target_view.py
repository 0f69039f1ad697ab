"""A target to drag, and an arm that follows it: inverse kinematics under the hand."""
from __future__ import annotations

from typing import Any

import numpy as np

from ..arms import inputs
from ..arms.arm import Arm
from ..arms.joints import first_pose, one_pose
from ..arms.kinematics import forward_kinematics
from ..drawing.target_picture import target_scene
from ..ik.solve import inverse_kinematics
from .arm_view import JointView
from .live import numbers


class TargetView(JointView):
    """An arm that follows a target which is dragged in the picture.

    Drag the target, or set its coordinates by their sliders: the joints follow by damped steps of
    inverse kinematics, for the tool point alone. Move a joint, and the target rides on the tool.
    A planar arm keeps to its plane, and its target is a ring. In space the target has three rings
    and moves in the plane of the picture.

    Parameters
    ----------
    arm : Arm
    q : array, shape (n,), optional
        Joint values to begin with (rad or length); the arm's home if left out.

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
    joints : list of Control
        One per joint, with its `value` in degrees or the arm's unit.

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

    def __init__(self, arm: Arm, q: Any = None) -> None:
        self._arm = arm
        self._followed = False  # True while the browser, which follows by itself, tells of a move
        super().__init__(target_scene(arm, first_pose(arm, q)))

    def set_state(self, sync_data: dict) -> None:
        """Take what the browser sends."""
        self._followed = True
        try:
            super().set_state(sync_data)
        finally:
            self._followed = False

    def move(self, q: Any) -> None:
        self._move(self._riding(one_pose(self.arm, q)))

    @property
    def target(self) -> np.ndarray:
        return np.concatenate([self._values[self.arm.n:], self.T[self._axes:3, 3]])

    @target.setter
    def target(self, place: Any) -> None:
        place = inputs.shaped("target", place, (3,), "a point (x, y, z)")
        n = self.arm.n
        within = self._within([*self.q, *place[:self._axes]])[n:]
        self._move([*self._reaching(within), *place[:self._axes]])

    @property
    def error(self) -> float:
        return float(np.linalg.norm(self.target - self.T[:3, 3]))

    def __repr__(self) -> str:
        target, error = (numbers(values, self.decimals) for values in (self.target, [self.error]))
        return (f"TargetView({self._words()}, target=[{target}] {self.arm.unit}, "
                f"error={error} {self.arm.unit})")

    def _riding(self, q: np.ndarray) -> list[float]:
        """Joint values, and after them the coordinates of a target that rides on the tool."""
        return [*q, *forward_kinematics(self.arm, q)[:self._axes, 3]]

    def _reaching(self, place: np.ndarray) -> np.ndarray:
        """Joint values that bring the tool to the coordinates, or as near as it gets."""
        weights = [float(axis < self._axes) for axis in range(3)]
        goal = [*place, *self.T[self._axes:3, 3]]
        return inverse_kinematics(self.arm, goal, self.q, weights=weights).q

    def _follow(self, moved: list[int]) -> None:
        """The arm follows the target, and the target rides on the tool."""
        n = self.arm.n
        if self._followed or moved[0] < n <= moved[-1]:
            return
        if moved[0] >= n:
            self._values[:n] = self._reaching(self._values[n:])
        else:
            self._values[n:] = self._within(self._riding(self._values[:n]))[n:]
        self._show_values()

    @property
    def _axes(self) -> int:
        """How many coordinates of the target can be set: two where the arm is planar."""
        return len(self._scene.knobs) - self.arm.n
