"""One link of an arm as textbooks draw it: its four parameters measured.

Other links are paler, and of the frames only i-1 and i stay. Angles (theta, alpha) are arcs,
lengths (d, a) are dimension lines, each kind in the colour that it has in formulas.
"""
from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from numbers import Integral
from typing import Any

import numpy as np

from ..arms import inputs
from ..arms.arm import CONVENTIONS, Arm, check_arm
from ..arms.joints import joint_range, joints_before
from ..arms.motions import ROTATE, Motion, X, Z
from .arm_scene import link_ends
from .camera import Camera
from .controls import PoseTable, decimals, subscript
from .readings import Amount
from .scene import SOLIDS, SPATIAL, Item, Scene, at
from .sketch import Sketch

_AXES, _VIEW = np.eye(3), Camera(*SPATIAL["3-D"]).axes[2]
LETTERS = {"theta": "θ", "d": "d", "a": "a", "alpha": "α"}
_RAISED = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_HALF = 8  # frame in the middle of a sweep


def parameters_scene(arm: Arm, link: int, q: Any) -> Scene:
    """The four DH parameters of a link, measured on the arm."""
    sketch = LinkSketch(arm, link, q)
    sketch.measure()
    sketch.tell()
    sketch.pose = sketch.table(f"A{subscript(link)}", str(link))
    return sketch.scene()


class LinkSketch(Sketch):
    """The arm, and on it a link's frames, arcs and dimension lines."""

    def __init__(self, arm: Arm, link: Any, q: Any) -> None:
        check_arm(arm)
        if not isinstance(link, Integral) or not 1 <= int(link) <= len(arm.links):
            raise ValueError(f"link: expected a whole number from 1 to {len(arm.links)}, "
                             f"got {inputs.brief(link)}")
        super().__init__(f"Link {link} of {arm.name or 'the arm'}, {arm.convention} DH",
                         planar=False, unit=arm.unit, grid=0)
        self.lay_arm(arm, q, keep=lambda item: not item.layer and item.part != "tip")
        body = joints_before(arm, int(link))
        self.items = [_stepped_back(item, body) for item in self.items]
        self.arm, self.link = arm, int(link)
        self.knobs = [replace(knob, label=f"{knob.label}*") for knob in self.knobs]
        self.bare()
        self.follows = True  # one link is looked at, not the arm
        self.floor = self.floor and replace(self.floor, drops=())
        self.motions = arm.chain[self.link]
        self.parameters = [parameter for _, _, parameter in CONVENTIONS[arm.convention]]
        self.radius = _closeness(arm, self.motions, self.radius)
        ends = link_ends(arm)
        self.first, self.tip = ends[self.link - 1], ends[self.link]
        self.frames = self._walk(self.motions)

    def table(self, title: str, name: str) -> PoseTable:
        """The matrix of the last frame, as frame i-1 sees it."""
        name, before = subscript(name), subscript(self.link - 1)
        columns = (*((letter + name, f"{letter} axis") for letter in "xyz"),
                   (f"o{name}", f"origin, from O{before}"))
        return PoseTable(f"{title}, seen from frame {self.link - 1}", columns, self.unit,
                         decimals(self.radius), base=self.first)

    def tell(self) -> None:
        """A line for each parameter: how it is measured, and its value."""
        for k, parameter in enumerate(self.parameters):
            self.reading(parameter, self.rule(k), Amount(self.frames[k + 1]))

    def _walk(self, motions: Iterable[Motion], slides: float = 1.0) -> list[int]:
        """The frames before, between and after the motions, on a branch of their own."""
        frames = [self.first]
        for motion in motions:
            share = 1.0 if motion.kind == ROTATE else slides
            frames.append(self.move(motion.kind, motion.axis, share * motion.amount, motion.joint,
                                    frames[-1], gain=share * motion.sign))
        return frames

    def measure(self) -> None:
        """All four parameters, the axes of action, and both frames."""
        for k in range(4):
            self.mark(k, self.frames)
        self.axes_of_action()
        for name, frame, length in self.both_frames():
            self.axes(name, frame, length)

    def mark(self, k: int, frames: Sequence[int]) -> None:
        """The k-th parameter between frames before and after the motions: an arc or a length."""
        motion = self.motions[k]
        if not motion.idle:
            draw = self._arc if motion.kind == ROTATE else self._dimension
            draw(k, motion.axis, frames[k], frames[k + 1])

    def axes_of_action(self) -> None:
        """The lines of z, before the link and behind it."""
        for name, frame in (("before", self.first), ("after", self.tip)):
            reach = 0.42 * self.radius * _AXES[Z]
            self.line(f"z-{name}", at(frame, -reach, reach), "axis")

    def both_frames(self) -> list[tuple[str, int, float]]:
        """The frames' names and numbers, and how long their axes are drawn."""
        apart = any(not m.idle for m in self.motions if m.kind != ROTATE)
        return [(str(self.link - 1), self.first, 0.22 * self.radius),
                (str(self.link), self.tip, (0.22 if apart else 0.28) * self.radius)]

    def _arc(self, k: int, axis: int, before: int, after: int) -> None:
        """From the other axis as it was to where the turn leaves it, with both drawn as rays."""
        place = self.radius * (0.32 * _AXES[X] if axis == Z else 0.37 * _AXES[Z])
        for frame in (before, after):
            self.line(f"ray-{k}-{frame}", at(frame, (0, 0, 0), 1.08 * place))
        marks = self.sweep(f"arc-{k}", after, place)
        self.label(self.name_of(k), at(marks[_HALF], place, (0, 0, 0)), "angle")

    def _dimension(self, k: int, axis: int, before: int, after: int) -> None:
        """Beside the link, between two short lines out from where the slide begins and ends."""
        beside = 0.16 * self.radius * self._sideways(before, axis, X if axis == Z else Z)
        for frame in (before, after):
            self.line(f"edge-{k}-{frame}", at(frame, (0, 0, 0), 1.2 * beside), "length")
        tail, head = (at(frame, beside)[0] for frame in (before, after))
        self.arrow(f"dimension-{k}", tail, head, "length")
        middle = self._part(self._step(after), before, 0.5)
        self.label(self.name_of(k), at(middle, beside, (0, 0, 0)), "length")

    def _sideways(self, frame: int, axis: int, other: int) -> np.ndarray:
        """Across an axis of a frame and across the view at first; not towards the other axis."""
        R = self.scene().frames(self.start)[frame][:3, :3]
        across = R.T @ np.cross(_VIEW, R[:, axis])
        if np.linalg.norm(across) < 0.1:  # seen end on: any direction serves
            across = _AXES[other]
        return across / np.linalg.norm(across) * (-1 if across[other] > 0 else 1)

    def name_of(self, k: int) -> str:
        """The k-th parameter with its index: a and alpha of a modified row i have i-1.

        A joint variable has the number of its joint.
        """
        parameter, joint = self.parameters[k], self.motions[k].joint
        if joint is not None:
            return LETTERS[parameter] + subscript(joint + 1)
        behind = self.arm.convention == "modified" and parameter in ("a", "alpha")
        return LETTERS[parameter] + subscript(self.link - behind)

    def symbol_of(self, k: int) -> str:
        """The k-th parameter's name as a symbol: "theta_2"."""
        letter, index = self.name_of(k)[0], self.name_of(k)[1:]
        plain = {mark: name for name, mark in LETTERS.items()}[letter]
        return f"{plain}_{index.translate(_RAISED)}"

    def rule(self, k: int) -> str:
        """How the k-th parameter is measured, with its name in front and a place for its value."""
        turns, axis = self.motions[k].kind == ROTATE, self.motions[k].axis
        old, new = (subscript(i) for i in (self.link - 1, self.link))
        other, own = ("x", "z") if axis == Z else ("z", "x")
        first = (axis == Z) == (self.arm.convention == "standard")
        return (f"{self._equation(k)} = {{}}{self._unit(self.motions[k])}, from {other}{old} "
                f"to {other}{new} {'about' if turns else 'along'} {own}{old if first else new}")

    def _equation(self, k: int) -> str:
        """The name; for a joint variable with its star, and with the joint's offset."""
        name, motion = self.name_of(k), self.motions[k]
        if motion.joint is None:
            return name
        variable = f"{'-' * (motion.sign < 0)}{name}*"
        if not motion.amount:
            return variable
        offset = math.degrees(motion.amount) if motion.kind == ROTATE else motion.amount
        sign = "-" if offset < 0 else "+"
        return f"{name} = {variable} {sign} {abs(offset):.6g}{self._unit(motion)}"

    def row(self) -> str:
        """The link's row of the table: numbers, and the joint variable with its star."""
        return f"Row {self.link}: {', '.join(map(self._cell, range(4)))}"

    def _cell(self, k: int) -> str:
        motion, equation = self.motions[k], self._equation(k)
        if motion.joint is not None:
            return equation if "=" in equation else f"{self.name_of(k)} = {equation}"
        turns = motion.kind == ROTATE
        value = math.degrees(motion.amount) if turns else motion.amount
        return f"{equation} = {value:.6g}{self._unit(motion) if value else ''}"

    def _unit(self, motion: Motion) -> str:
        return "°" if motion.kind == ROTATE else f" {self.unit}"


def _stepped_back(item: Item, link: int) -> Item:
    """A solid in paler colours, unless it belongs to the link."""
    pale = item.shape in SOLIDS and item.link != link
    return replace(item, style=f"{item.style}-far") if pale else item


def _closeness(arm: Arm, motions: Iterable[Motion], radius: float) -> float:
    """Half the width of what is shown: the link and its frames, not the whole arm."""
    reach = math.hypot(*(abs(m.amount) if m.joint is None
                         else max(map(abs, joint_range(arm, m.joint)))
                         for m in motions if m.kind != ROTATE))
    return min(radius, max(0.95 * reach, 0.3 * radius))
