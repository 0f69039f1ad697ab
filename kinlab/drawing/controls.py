"""What stands beside a picture, as data: knobs, switches, the table of a pose, a target."""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from ..arms import inputs
from ..arms.arm import Arm
from ..arms.joints import joint_range
from ..arms.link import REVOLUTE

LAYERS = ("frames", "labels", "axes", "names", "floor", "trace", "ghost")


@dataclass(frozen=True)
class Knob:
    """What one slider drives.

    `low`, `high` and `home` are in the scene's units (rad or length). The slider shows them
    divided by `scale`, in `unit`, and an arrow key moves it by `step` of those.

    The whole numbers of a `whole` knob are stages, from one to the next of which steps and Play
    go; `names` are what they are called, each on a button. Two knobs with the same `pair` are the
    ends of one range, the lower first: one slider with two handles, named by the pair, that cannot
    pass each other.
    """

    name: str
    label: str
    low: float
    high: float
    home: float = 0.0
    unit: str = ""
    scale: float = 1.0
    step: float = 1.0
    title: str = ""
    whole: bool = False
    pair: str = ""
    quantity: str = ""  # "angle", "length", "target": the colour of its name
    names: tuple[str, ...] = ()

    @classmethod
    def angle(cls, name: str, label: str, low: float = -math.pi, high: float = math.pi,
              home: float = 0.0, title: str = "") -> Knob:
        """A knob in degrees for an angle in radians."""
        return cls(name, label, low, high, home, "°", math.radians(1), 1.0, title, quantity="angle")

    @classmethod
    def length(cls, name: str, label: str, low: float, high: float, home: float = 0.0,
               unit: str = "", title: str = "") -> Knob:
        """A knob for a length; an arrow key moves it by about a fiftieth of its way."""
        step = 10.0 ** math.floor(math.log10(((high - low) or 1.0) / 20))
        return cls(name, label, low, high, home, unit, 1.0, step, title, quantity="length")

    @property
    def ends(self) -> tuple[float, float]:
        """Lowest and highest value as the slider shows them: -120, not -119.99999999999999."""
        low, high = (float(f"{end / self.scale:.12g}") for end in (self.low, self.high))
        return low, high

    @property
    def digits(self) -> int:
        """Decimals that the slider shows: enough to tell one step from the next."""
        way = ((self.high - self.low) or abs(self.high) or 1.0) / self.scale  # one value: a lock
        steps = math.ceil(-math.log10(self.step) - 1e-9)
        return max(1 if self.unit == "°" else 0, math.ceil(1 - math.log10(way)), steps)

    @property
    def suffix(self) -> str:
        """The unit as it follows a number: '°' at once, others after a space."""
        return self.unit if self.unit in ("", "°") else f" {self.unit}"

    def said(self, value: float) -> str:
        """Its name with a value in the scene's units, as the browser writes it: "θ₁ = −90.0°"."""
        shown = f"{value / self.scale:.{self.digits}f}"
        shown = shown.lstrip("-") if float(shown) == 0 else shown.replace("-", "−")
        return f"{self.label} = {shown}{self.suffix}"

    def within(self, value: float) -> float:
        """The value, or the limit that it is beyond."""
        return min(max(value, self.low), self.high)

    def data(self) -> dict:
        """Plain data for the browser; what few knobs have is left out of the others."""
        rare = {name for name in ("whole", "pair", "names") if not getattr(self, name)}
        told = {name: value for name, value in asdict(self).items() if name not in rare}
        return told | {"suffix": self.suffix, "digits": self.digits}


@dataclass(frozen=True)
class Switch:
    """A button that shows and hides a layer of the picture."""

    layer: str
    label: str
    title: str
    on: bool = False


@dataclass(frozen=True)
class PoseTable:
    """The matrix of the scene's tip: axes and origin as columns, or only `rows` axes.

    `columns` are pairs of a name and a title. The frame is seen from frame `base`; `said` is what
    a screen reader calls its origin.
    """

    title: str
    columns: tuple[tuple[str, str], ...]
    unit: str = ""
    decimals: int = 3
    said: str = "origin"
    base: int = 0
    rows: int | None = None

    @classmethod
    def of_frame(cls, title: str, frame: str, axes: str, **options: Any) -> PoseTable:
        """The table of frame number `frame`, with its axes and its origin, such as x₁ y₁ o₁."""
        letters = [(letter, f"{letter} axis of frame {frame}") for letter in axes]
        named = letters if "rows" in options else [*letters, ("o", f"origin of frame {frame}")]
        return cls(title, tuple((letter + subscript(frame), words) for letter, words in named),
                   **options)

    def data(self) -> dict:
        """Plain data for the browser."""
        columns = [{"name": name, "title": title} for name, title in self.columns]
        return asdict(self) | {"columns": columns}


@dataclass(frozen=True)
class Target:
    """A frame that a hand drags, and the tip that follows it by the first `joints` knobs.

    `knobs` are the numbers of those that hold the target's coordinates.
    """

    frame: int
    tip: int
    joints: int
    knobs: tuple[int, ...]
    unit: str


@dataclass(frozen=True)
class Handle:
    """A point that a hand drags: the knobs with these numbers bring it to the hand.

    `name` says what it is, "origin of frame 1"; where it is follows, in `unit`.
    """

    name: str
    point: tuple[int, float, float, float]
    knobs: tuple[int, ...]
    unit: str = ""


def joint_knob(arm: Arm, i: int) -> Knob:
    """The knob of joint i: its textbook name, its limits, its home."""
    link, (low, high), home = arm.joints[i], joint_range(arm, i), float(arm.home[i])
    number, title = str(i + 1), link.name or f"joint {i + 1}"
    if link.kind == REVOLUTE:
        return Knob.angle(f"theta_{number}", f"θ{subscript(number)}", low, high, home, title)
    return Knob.length(f"d_{number}", f"d{subscript(number)}", low, high, home, arm.unit, title)


def joint_knobs(arm: Arm) -> list[Knob]:
    """A knob for every joint."""
    return [joint_knob(arm, i) for i in range(arm.n)]


def tip_handle(arm: Arm, frame: int) -> Handle:
    """The tip of an arm, which all its joints bring to the hand."""
    return Handle("tip of the arm", (frame, 0.0, 0.0, 0.0), tuple(range(arm.n)), arm.unit)


def tour(knobs: Sequence[Knob]) -> np.ndarray:
    """Home, then each joint out and back, towards its farther limit."""
    low, high, home = np.array([(knob.low, knob.high, knob.home) for knob in knobs]).T
    home = np.clip(home, low, high)
    away = np.minimum(np.maximum(high - home, home - low), 0.3 * (high - low))
    away *= np.where(high - home >= home - low, 1, -1)
    moves = np.diag(away)[away != 0]  # a locked joint goes nowhere
    return np.concatenate([[home, home + out] for out in moves]) if len(moves) else home[None]


_SWITCHES = {"frames": ("Frames", "Frames of the links"), "labels": ("Labels", "Names of the axes"),
             "axes": ("Joint axes", "Axes of the joints"), "trace": ("Trace", "Path of the tool"),
             "names": ("Names", "What the joints are called"),
             "floor": ("Floor", "Grid, shadow, and the lines dropped from tool and target"),
             "ghost": ("Ghost", "The arm where it began, for comparison")}


def arm_switches(show: Any) -> tuple[Switch, ...]:
    """Switches of an arm's layers, the floor and those in `show` on.

    ValueError for an unknown layer.
    """
    try:
        names = (show,) if isinstance(show, str) else tuple(show)
    except TypeError:
        names = (show,)
    on = [inputs.choice("show", name, LAYERS) for name in names]
    return tuple(Switch(layer, *_SWITCHES[layer], layer in (*on, "floor")) for layer in LAYERS)


_COLUMNS = (("n", "normal"), ("s", "sliding"), ("a", "approach"), ("p", "position"))


def tool_table(arm: Arm, size: float) -> PoseTable:
    """The table of the tool's pose beside a picture of this size."""
    return PoseTable(f"T₀{subscript(tool_name(arm))}, the pose of the tool", _COLUMNS, arm.unit,
                     decimals(size), "tool")


_TINY = 0.01  # of its unit: three decimals would not tell where such an arm is


def tool_name(arm: Arm) -> str:
    """The name of the tool's frame: n, or E where the tool has a frame of its own."""
    return str(len(arm.links)) if np.array_equal(arm.tool, np.eye(4)) else "E"


def decimals(size: float) -> int:
    """Decimals that tell a thousandth of a picture's size: 1 for millimetres, 3 for metres."""
    wanted = 3 - math.floor(math.log10(size))
    return max(1, wanted if size < _TINY else min(3, wanted))


def subscript(name: str | int) -> str:
    """Digits lowered as in print: '12' becomes '₁₂'; the tool's E becomes 'ₑ'."""
    return str(name).translate(str.maketrans("0123456789E", "₀₁₂₃₄₅₆₇₈₉ₑ"))


def superscript(power: int) -> str:
    """Digits raised as in print: -2 becomes '⁻²'."""
    return str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
