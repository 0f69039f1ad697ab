"""The live arm: a slider per joint, and the picture, frames and numbers that answer."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from html import escape
from typing import Any

import numpy as np

from ..arms import inputs
from ..arms.arm import Arm
from ..arms.joints import first_pose, joint_array, joint_ranges, one_pose
from ..arms.kinematics import forward_kinematics
from ..arms.link import REVOLUTE
from ..browser import mathml
from ..drawing.arm_scene import arm_scene
from ..drawing.scene import SPATIAL
from .live import DECIMALS, Control, LiveView, numbers


class JointView(LiveView):
    """What every view of an arm has: the arm, its joints and the pose of its tool."""

    @property
    def arm(self) -> Arm:
        return self._arm

    @property
    def joints(self) -> list[Control]:
        return self.controls[:self.arm.n]

    @property
    def T(self) -> np.ndarray:
        return forward_kinematics(self.arm, self.q)

    def move(self, q: Any) -> None:
        self._move(one_pose(self.arm, q))

    def _words(self) -> str:
        """The name, and the joint values as the sliders show them."""
        name = f"{self.arm.name!r}, " if self.arm.name else ""
        values = [joint.value for joint in self.joints]
        return name + f"q={joints_text(self.arm, values, self.decimals)}"


class ArmView(JointView):
    """A live arm: a slider per joint, and the picture, frames and numbers that answer.

    Parameters
    ----------
    arm : Arm
    q : array, shape (n,), optional
        Joint values to begin with (rad or length); the arm's home if left out.
    closed_form : bool
        Typeset the matrix in closed form under the picture.
    show : sequence of {"frames", "labels", "axes", "names", "trace", "ghost"}
        What is switched on to begin with, besides the floor.
    preset : {"3-D", "top", "front", "side"}, optional
        Where the picture is seen from; planar arms are seen from the top.
    poses : array, shape (m, n), optional
        Poses that Play moves between; by default each joint is shown in turn.

    Attributes
    ----------
    arm : Arm
    q : array, shape (n,)
        Joint values (rad or length). Setting it moves the arm; values beyond a limit stop there,
        and the view says so.
    T : array, shape (4, 4)
        Pose of the tool, `forward_kinematics(arm, q)`.
    joints : list of Control
        One per joint, with its `value` in degrees or the arm's unit. Each is a trait, too:
        ``view.theta_1 = 30``.

    Raises
    ------
    ValueError
        If an argument does not fit the arm.

    Examples
    --------
    >>> from kinlab import robots
    >>> view = ArmView(robots.two_link(), q=[0, 0])
    >>> view.joints[1].value = 90
    >>> view
    ArmView('Two-link', q=[0, 90] deg, p=[1, 1, 0] m)
    """

    def __init__(self, arm: Arm, q: Any = None, *, closed_form: bool = False,
                 show: Sequence[str] = ("frames", "labels", "names"), preset: str | None = None,
                 poses: Any = None) -> None:
        start = first_pose(arm, q)
        if preset is not None:
            inputs.choice("preset", preset, tuple(SPATIAL))
        scene = arm_scene(arm, start, show=show, preset=preset or "")
        if poses is not None:
            scene = replace(scene, poses=tuple(map(tuple, _poses(arm, poses).tolist())))
        self._arm = arm
        super().__init__(scene, formula=_closed_form(arm) if closed_form else "")
        self.note = self._stops(start)

    def follow(self, arm: Arm, q: Any = None) -> None:
        """Show another arm in the place of this one.

        The view stays as it was turned, and what was switched on stays on. A closed form under
        the picture stays that of the first arm.

        Parameters
        ----------
        arm : Arm
        q : array, shape (n,), optional
            Joint values (rad or length); the arm's home if left out.

        Examples
        --------
        >>> from kinlab import robots
        >>> view = ArmView(robots.two_link())
        >>> view.follow(robots.exam_2018())
        >>> view
        ArmView('2018 exam', q=[0 deg, 0 deg, 0.4 m], p=[0.4, -0.2, 0.9] m)
        """
        q = first_pose(arm, q)
        self._arm = arm
        self._replace(arm_scene(arm, show=self._scene.shown), q)

    def __repr__(self) -> str:
        p = numbers(self.T[:3, 3], self.decimals)
        return f"ArmView({self._words()}, p=[{p}] {self.arm.unit})"


def joints_text(arm: Arm, values: Sequence[float], digits: int = DECIMALS) -> str:
    """Joint values in degrees and lengths, as text with their units."""
    units = ["deg" if link.kind == REVOLUTE else arm.unit for link in arm.joints]
    if set(units) == {"deg"}:
        return f"[{numbers(values)}] deg"
    texts = (f"{numbers([value], DECIMALS if unit == 'deg' else digits)} {unit}"
             for value, unit in zip(values, units))
    return f"[{', '.join(texts)}]"


def formula_of(arm: Arm, latex: str) -> str:
    """A matrix of the arm as MathML whose factors name their joints."""
    slides = [i for i, link in enumerate(arm.joints, start=1) if link.kind != REVOLUTE]
    return mathml.named(latex, arm.n, slides)


def remarks_html(*remarks: str) -> str:
    """Lines under a formula; empty ones are left out."""
    return "".join(f"<p>{escape(remark)}</p>" for remark in remarks if remark)


def _closed_form(arm: Arm) -> str:
    from ..arms.symbolic import closed_form

    form = closed_form(arm)
    return formula_of(arm, form.latex) + remarks_html(form.remark)


def _poses(arm: Arm, poses: Any) -> np.ndarray:
    poses = joint_array(arm, poses, "poses")
    if poses.ndim != 2 or not len(poses):
        raise ValueError(f"poses: expected shape (m, {arm.n}) with m > 0, got {poses.shape}; "
                         "give a list of joint vectors")
    return np.clip(poses, *joint_ranges(arm))
