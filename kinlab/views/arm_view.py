"""The live arm: a slider per joint, and the picture, frames and numbers that answer."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import ipywidgets
import numpy as np

from ..arms import inputs
from ..arms.arm import Arm
from ..arms.joints import first_pose, joint_array, joint_range, one_pose
from ..arms.kinematics import forward_kinematics
from ..arms.link import REVOLUTE
from ..drawing.arm_scene import LAYERS, arm_scene, is_planar
from ..drawing.scene import SPATIAL, Scene, subscript
from .live import Knob, LiveView, decimals, numbers

_SWITCHES = (("frames", "Frames", "Frames of the links"), ("labels", "Labels", "Names of the axes"),
             ("axes", "Joint axes", "Axes of the joints"), ("trace", "Trace", "Path of the tool"),
             ("ghost", "Ghost", "The arm at home, for comparison"))
_COLUMNS = (("n", "normal vector"), ("s", "sliding vector"), ("a", "approach vector"),
            ("p", "position"))


class ArmView(LiveView):
    """A live arm: a slider per joint, and the picture, frames and numbers that answer.

    Parameters
    ----------
    arm : Arm
    q : array, shape (n,), optional
        Joint values to begin with (rad or length); the arm's home if left out.
    closed_form : bool
        Typeset the matrix in closed form under the picture.
    show : sequence of {"frames", "labels", "axes", "trace", "ghost"}
        What is switched on to begin with.
    preset : {"3-D", "top", "front", "side"}, optional
        Where the picture is seen from; planar arms are seen from the top.
    poses : array, shape (m, n), optional
        Poses that Play moves between; by default each joint is shown in turn.

    Attributes
    ----------
    q : array, shape (n,)
        Joint values (rad or length). Setting it moves the arm; values beyond a limit stop there,
        and the view says so.
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
    >>> view = ArmView(robots.two_link(), q=[0, 0])
    >>> view.joints[1].value = 90
    >>> view
    ArmView('Two-link', q=[0, 90] deg, p=[1, 1, 0] m)
    """

    def __init__(self, arm: Arm, q: Any = None, *, closed_form: bool = False,
                 show: Sequence[str] = ("frames", "labels"), preset: str | None = None,
                 poses: Any = None) -> None:
        start = first_pose(arm, q)
        preset = preset or _preset(arm)
        inputs.choice("preset", preset, tuple(SPATIAL))
        self.arm, show = arm, layers(show)
        knobs = [joint_knob(arm, i) for i in range(arm.n)]
        scene, poses = arm_scene(arm), None if poses is None else _poses(arm, poses)
        super().__init__(scene, knobs, name=arm.name or "Arm", preset=preset, show=show,
                         panels=_panels(arm, scene, knobs, show, poses),
                         below=[_formula(arm)] if closed_form else [])
        self.q = start

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
        knobs, scene = [joint_knob(arm, i) for i in range(arm.n)], arm_scene(arm)
        self._replace(scene, knobs, q, arm.name or "Arm",
                      _panels(arm, scene, knobs, self._show, None), _preset(arm))
        self.arm = arm

    @property
    def joints(self) -> list[ipywidgets.FloatSlider]:
        return self.sliders

    @property
    def q(self) -> np.ndarray:
        return self._values

    @q.setter
    def q(self, q: Any) -> None:
        self._move(one_pose(self.arm, q))

    @property
    def T(self) -> np.ndarray:
        return forward_kinematics(self.arm, self.q)

    def __repr__(self) -> str:
        name = f"{self.arm.name!r}, " if self.arm.name else ""
        return (f"ArmView({name}q={self._q_text()}, "
                f"p=[{numbers(self.T[:3, 3])}] {self.arm.unit})")

    def _q_text(self) -> str:
        return joints_text(self.arm, [slider.value for slider in self.joints])


def joints_text(arm: Arm, values: Sequence[float]) -> str:
    """Joint values in degrees and lengths, as text with their units."""
    units = ["deg" if link.kind == REVOLUTE else arm.unit for link in arm.links]
    if set(units) == {"deg"}:
        return f"[{numbers(values)}] deg"
    return "[" + ", ".join(f"{numbers([v])} {unit}" for v, unit in zip(values, units)) + "]"


def switches(show: Sequence[str]) -> list[dict]:
    """Buttons that show and hide the layers of an arm's picture."""
    return [{"layer": layer, "label": label, "title": title, "on": layer in show}
            for layer, label, title in _SWITCHES]


def joint_knob(arm: Arm, i: int) -> Knob:
    """The knob of joint i: its textbook name, its limits, its home."""
    link, (low, high), home = arm.links[i], joint_range(arm, i), float(arm.home[i])
    number, title = str(i + 1), link.name or f"joint {i + 1}"
    if link.kind == REVOLUTE:
        return Knob.angle(f"theta_{number}", f"θ{subscript(number)}", low, high, home, title)
    return Knob.length(f"d_{number}", f"d{subscript(number)}", low, high, home, arm.unit, title)


def _preset(arm: Arm) -> str:
    return "top" if is_planar(arm) else "3-D"


def _panels(arm: Arm, scene: Scene, knobs: Sequence[Knob], show: Sequence[str],
            poses: np.ndarray | None) -> dict:
    return {"poses": (tour(knobs) if poses is None else poses).tolist(),
            "pose": pose_table(arm, scene.radius), "layers": switches(show)}


def pose_table(arm: Arm, size: float) -> dict:
    """The table of the tool's pose beside a picture of this size."""
    tool = str(arm.n) if np.array_equal(arm.tool, np.eye(4)) else "E"
    columns = [{"name": name, "title": title} for name, title in _COLUMNS]
    return {"title": f"T₀{subscript(tool)}, the pose of the tool", "said": "tool",
            "columns": columns, "decimals": decimals(size), "unit": arm.unit}


def tour(knobs: Sequence[Knob]) -> np.ndarray:
    """Home, then each joint out and back, towards its farther limit."""
    low, high, home = np.array([(knob.low, knob.high, knob.home) for knob in knobs]).T
    home = np.clip(home, low, high)
    away = np.minimum(np.maximum(high - home, home - low), 0.3 * (high - low))
    away *= np.where(high - home >= home - low, 1, -1)
    return np.concatenate([[home, home + out] for out in np.diag(away)])


def _formula(arm: Arm) -> ipywidgets.HTMLMath:
    from ..arms.symbolic import closed_form

    formula = ipywidgets.HTMLMath(f"$\\displaystyle {closed_form(arm).latex}$")
    formula.add_class("kl-math")
    return formula


def layers(show: Any) -> tuple[str, ...]:
    """Names of layers, checked."""
    try:
        names = (show,) if isinstance(show, str) else tuple(show)
    except TypeError:
        names = (show,)
    return tuple(inputs.choice("show", name, LAYERS) for name in names)


def _poses(arm: Arm, poses: Any) -> np.ndarray:
    poses = joint_array(arm, poses, "poses")
    if poses.ndim != 2 or not len(poses):
        raise ValueError(f"poses: expected shape (m, {arm.n}) with m > 0, got {poses.shape}; "
                         "give a list of joint vectors")
    low, high = np.array([joint_range(arm, i) for i in range(arm.n)]).T
    return np.clip(poses, low, high)
