"""The live view: ipywidgets sliders beside a picture that the browser moves."""
from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import anywidget
import ipywidgets
import numpy as np
import traitlets

from . import checks, draw
from .arm import REVOLUTE, Arm, Link
from .kinematics import forward_kinematics, joint_values
from .scene import LAYERS, PRESETS, arm_scene, is_planar, joint_range, subscript

_HERE = Path(__file__).parent
_LAYERS = (("frames", "Frames", "Frames of the links"), ("labels", "Labels", "Names of the axes"),
           ("axes", "Joint axes", "Axes of the joints"), ("trace", "Trace", "Path of the tool"),
           ("ghost", "Ghost", "The arm at home, for comparison"))


class Canvas(anywidget.AnyWidget):
    """The moving picture, its buttons and its table; live.js does the work."""

    _esm = _HERE / "live.js"
    _css = _HERE / "live.css"
    svg = traitlets.Unicode().tag(sync=True)
    scene = traitlets.Dict().tag(sync=True)
    sliders = traitlets.List().tag(sync=True, **ipywidgets.widget_serialization)
    note = traitlets.Unicode().tag(sync=True)
    hold = traitlets.Bool(False).tag(sync=True)  # True while several joints are being set


class ArmView(ipywidgets.Box):
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
        start = _one_pose(arm, arm.home if isinstance(arm, Arm) and q is None else q)
        preset = preset or ("top" if is_planar(arm) else "3-D")
        checks.choice("preset", preset, tuple(PRESETS))
        poses = None if poses is None else _poses(arm, poses)
        self.arm, self._preset, self._show = arm, preset, _layers(show)
        self._scene = arm_scene(arm)
        self._ranges = np.array([joint_range(arm, i) for i in range(arm.n)])
        self._scales = np.array([math.radians(1) if link.kind == REVOLUTE else 1.0
                                 for link in arm.links])
        self.joints = [self._slider(i) for i in range(arm.n)]
        still = draw.figure(self._scene, arm.home, preset, LAYERS)
        self._canvas = Canvas(svg=draw.svg(still), scene=self._data(poses), sliders=self.joints)
        panel = ipywidgets.VBox(self.joints)
        panel.add_class("kl-joints")
        super().__init__([self._canvas, panel, *([self._formula()] if closed_form else [])])
        self.add_class("kl-view")
        for slider in self.joints:
            slider.observe(self._forget, "value")
        self.q = start

    @property
    def q(self) -> np.ndarray:
        return np.array([slider.value for slider in self.joints]) * self._scales

    @q.setter
    def q(self, q: Any) -> None:
        wanted = _one_pose(self.arm, q)
        low, high = self._ranges.T
        allowed = np.clip(wanted, low, high)
        self._canvas.hold = True
        for slider, value in zip(self.joints, allowed / self._scales):
            slider.value = value
        self._canvas.hold = False
        stopped = np.flatnonzero(np.abs(allowed - wanted) > 1e-9 * (high - low))
        self._canvas.note = "; ".join(
            f"{self.joints[i].description.split()[0]} stops at its limit, "
            f"{self.joints[i].value:.6g}{_unit_text(self.arm.links[i], self.arm)}"
            for i in stopped)

    @property
    def T(self) -> np.ndarray:
        return forward_kinematics(self.arm, self.q)

    def __repr__(self) -> str:
        name = f"{self.arm.name!r}, " if self.arm.name else ""
        position = _numbers(self.T[:3, 3])
        return f"ArmView({name}q={self._q_text()}, p=[{position}] {self.arm.unit})"

    def _repr_mimebundle_(self, **kwargs: Any) -> tuple[dict, dict] | dict:
        """The widget, and for places where none runs a still picture and a text."""
        bundle = super()._repr_mimebundle_(**kwargs)
        if bundle is None:
            return {}
        still = draw.figure(self._scene, self.q, self._preset, self._show)
        bundle |= {"text/plain": repr(self), "image/png": draw.png(still)}
        return bundle, {"image/png": {"alt": f"Picture of the arm. {self!r}"}}

    def _forget(self, _: Any) -> None:
        """A joint has moved: what was remarked about the pose before no longer holds."""
        self._canvas.note = ""

    def _slider(self, i: int) -> ipywidgets.FloatSlider:
        link, scale = self.arm.links[i], self._scales[i]
        low, high = np.round(self._ranges[i] / scale, 9).tolist()  # 120, not 119.99999999999999
        revolute = link.kind == REVOLUTE
        unit, symbol = ("°", "θ") if revolute else (self.arm.unit, "d")
        decimals = 1 if revolute else max(0, 1 - math.floor(math.log10(high - low)))
        return ipywidgets.FloatSlider(
            value=min(max(0.0, low), high), min=low, max=high, step=None,
            readout_format=f".{decimals}f", description=f"{symbol}{subscript(str(i + 1))} ({unit})",
            tooltip=link.name or f"joint {i + 1}")

    def _step(self, i: int) -> float:
        """How far an arrow key moves a joint: one degree, or about a fiftieth of its way."""
        low, high = self._ranges[i]
        revolute = self.arm.links[i].kind == REVOLUTE
        return 1.0 if revolute else 10.0 ** math.floor(math.log10((high - low) / 20))

    def _data(self, poses: np.ndarray | None) -> dict:
        """The scene with what the panels need: joints, poses, table and switches."""
        arm, low_high = self.arm, self._ranges
        tool = "E" if not np.array_equal(arm.tool, np.eye(4)) else str(arm.n)
        digits = min(3, max(1, 3 - math.floor(math.log10(self._scene.radius))))
        return self._scene.data() | {
            "name": arm.name or "Arm",
            "preset": self._preset,
            "joints": [{"label": slider.description.split()[0], "unit": _unit_text(link, arm),
                        "scale": scale, "step": self._step(i), "low": low, "high": high}
                       for i, (slider, link, scale, (low, high))
                       in enumerate(zip(self.joints, arm.links, self._scales, low_high))],
            "layers": [{"layer": layer, "label": label, "title": title, "on": layer in self._show}
                       for layer, label, title in _LAYERS],
            "pose": {"title": f"T₀{subscript(tool)}, the pose of the tool",
                     "decimals": digits, "unit": arm.unit},
            "home": np.clip(arm.home, *low_high.T).tolist(),
            "zero": np.clip(0.0, *low_high.T).tolist(),
            "poses": (self._tour() if poses is None else poses).tolist(),
        }

    def _tour(self) -> np.ndarray:
        """Home, then each joint out and back, towards its farther limit."""
        (low, high), home = self._ranges.T, np.clip(self.arm.home, *self._ranges.T)
        away = np.minimum(np.maximum(high - home, home - low), 0.3 * (high - low))
        away *= np.where(high - home >= home - low, 1, -1)
        return np.concatenate([[home, home + out] for out in np.diag(away)])

    def _formula(self) -> ipywidgets.HTMLMath:
        from .symbolic import closed_form

        formula = ipywidgets.HTMLMath(f"$\\displaystyle {closed_form(self.arm).latex}$")
        formula.add_class("kl-math")
        return formula

    def _q_text(self) -> str:
        values = [slider.value for slider in self.joints]
        units = ["deg" if link.kind == REVOLUTE else self.arm.unit for link in self.arm.links]
        if set(units) == {"deg"}:
            return f"[{_numbers(values)}] deg"
        return "[" + ", ".join(f"{_numbers([v])} {unit}" for v, unit in zip(values, units)) + "]"


def _one_pose(arm: Arm, q: Any) -> np.ndarray:
    q = joint_values(arm, q)
    if q.ndim != 1:
        raise ValueError(f"q: expected one pose, shape ({arm.n},), got {q.shape}; "
                         "a view shows one pose at a time")
    return q


def _layers(show: Any) -> tuple[str, ...]:
    try:
        layers = (show,) if isinstance(show, str) else tuple(show)
    except TypeError:
        layers = (show,)
    return tuple(checks.choice("show", layer, LAYERS) for layer in layers)


def _poses(arm: Arm, poses: Any) -> np.ndarray:
    poses = joint_values(arm, poses, "poses")
    if poses.ndim != 2 or not len(poses):
        raise ValueError(f"poses: expected shape (m, {arm.n}) with m > 0, got {poses.shape}; "
                         "give a list of joint vectors")
    low, high = np.array([joint_range(arm, i) for i in range(arm.n)]).T
    return np.clip(poses, low, high)


def _unit_text(link: Link, arm: Arm) -> str:
    return "°" if link.kind == REVOLUTE else f" {arm.unit}"


def _numbers(values: Sequence[float]) -> str:
    return ", ".join(f"{round(float(value), 4) + 0.0:.8g}" for value in values)
