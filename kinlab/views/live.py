"""The live view: ipywidgets sliders beside a picture that the browser moves."""
from __future__ import annotations

import math
import os
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import anywidget
import ipywidgets
import numpy as np
import traitlets

from ..arms import inputs
from ..browser import page
from ..drawing import worker
from ..drawing.scene import Scene


class Canvas(anywidget.AnyWidget):
    """The moving picture, its buttons and its table; mount.js and host_jupyter.js do the work."""

    _esm = page.script("jupyter")
    # As text: anywidget would watch a file, and keep every canvas for ever to tell it of a change.
    _css = (page.HERE / "live.css").read_text(encoding="utf-8")
    svg = traitlets.Unicode().tag(sync=True)
    scene = traitlets.Dict().tag(sync=True)
    sliders = traitlets.List().tag(sync=True, **ipywidgets.widget_serialization)
    note = traitlets.Unicode().tag(sync=True)
    hold = traitlets.Bool(False).tag(sync=True)  # True while several knobs are being set


@dataclass(frozen=True)
class Knob:
    """What one slider drives.

    `low`, `high` and `home` are in the scene's units (rad or length). The slider shows them
    divided by `scale`, in `unit`, and an arrow key moves it by `step` of those.
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

    @classmethod
    def angle(cls, name: str, label: str, low: float = -math.pi, high: float = math.pi,
              home: float = 0.0, title: str = "") -> Knob:
        """A knob in degrees for an angle in radians."""
        return cls(name, label, low, high, home, "°", math.radians(1), 1.0, title)

    @classmethod
    def length(cls, name: str, label: str, low: float, high: float, home: float = 0.0,
               unit: str = "", title: str = "") -> Knob:
        """A knob for a length; an arrow key moves it by about a fiftieth of its way."""
        step = 10.0 ** math.floor(math.log10((high - low) / 20))
        return cls(name, label, low, high, home, unit, 1.0, step, title)

    def slider(self) -> ipywidgets.FloatSlider:
        """An ordinary slider; host_jupyter.js makes its steps (see Joint there)."""
        return ipywidgets.FloatSlider(step=None, **self._looks())

    def fitted(self, slider: ipywidgets.FloatSlider | None) -> ipywidgets.FloatSlider:
        """A slider made over to this knob, if one is given whose numbers look alike."""
        looks = self._looks()
        if slider is None or slider.readout_format != looks["readout_format"]:
            return self.slider()
        with slider.hold_sync():
            slider.max = max(slider.max, looks["max"])  # never below the lower end
            for trait in ("min", "max", "description", "tooltip"):
                setattr(slider, trait, looks[trait])
        return slider

    def _looks(self) -> dict[str, Any]:
        low, high = (round(end / self.scale, 9) for end in (self.low, self.high))
        unit = f" ({self.unit})" if self.unit else ""
        return {"min": low, "max": high, "value": min(max(self.home / self.scale, low), high),
                "readout_format": f".{self.digits}f", "description": self.label + unit,
                "tooltip": self.title or self.label}

    @property
    def digits(self) -> int:
        """Decimals that the slider shows."""
        way = (self.high - self.low) / self.scale
        return max(1 if self.unit == "°" else 0, math.ceil(1 - math.log10(way)))

    @property
    def suffix(self) -> str:
        """The unit as it follows a number: '°' at once, others after a space."""
        return self.unit if self.unit in ("", "°") else f" {self.unit}"


class LiveView(ipywidgets.Box):
    """A scene, the sliders of its knobs, and the numbers that follow them.

    Parameters
    ----------
    scene : Scene
    knobs : sequence of Knob
        One per value in the scene's `q`.
    name : str
        What the picture shows.
    panels : dict
        Further data for mount.js: switches, table, poses.
    below : sequence of widgets
        Shown under the picture.
    preset : str
        Where the picture is seen from, one of the scene's.
    show : sequence of str
        Layers that are on to begin with.

    Examples
    --------
    A view is indexed by the names of its knobs: ``view["theta"].value = 30``.
    """

    ALT = "Picture of the arm."  # how the words for the picture begin

    def __init__(self, scene: Scene, knobs: Sequence[Knob], *, name: str = "",
                 panels: dict | None = None, below: Sequence[ipywidgets.Widget] = (),
                 preset: str | None = None, show: Sequence[str] = ()) -> None:
        self._show, self.sliders = tuple(show), []
        self._take(scene, knobs, name, preset)
        self._canvas = Canvas(**self._picture(panels))
        self._panel = ipywidgets.VBox(self.sliders)
        self._panel.add_class("kl-joints")
        super().__init__([self._canvas, self._panel, *below])
        self.add_class("kl-view")
        if scene.wide:
            self.add_class("kl-wide")

    def __getitem__(self, name: str) -> ipywidgets.FloatSlider:
        names = [knob.name for knob in self._knobs]
        return self.sliders[names.index(inputs.choice("name", name, tuple(names)))]

    def close(self) -> None:
        """Close the view and everything that it is made of; its memory is free again."""
        for slider in getattr(self, "sliders", ()):  # none where a wrong argument was refused
            slider.unobserve_all()
        for part in parts(self):
            ipywidgets.Widget.close(part)

    @property
    def readings(self) -> dict[str, tuple[np.ndarray, ...]]:
        """The parts of each formula under the picture, by its name."""
        return self._scene.read(self._values)

    @property
    def _values(self) -> np.ndarray:
        """Values of the knobs in the scene's units."""
        return np.array([slider.value for slider in self.sliders]) * self._scales

    def save_html(self, path: str | os.PathLike) -> Path:
        """Write the view, as it stands now, as one page that moves without Jupyter and network.

        The page holds all it needs and may be opened from a disk, put on a web server or into a
        course system. ``#q=30,40,-20`` behind its address sets the sliders; **Copy link** copies
        that. Widgets beside the view that need Python stay behind, and the page says so. An
        older file of this name is replaced.

        Parameters
        ----------
        path : str or path
            Where to write it; ends in ``.html``.

        Returns
        -------
        Path

        Raises
        ------
        ValueError
            If the name does not end in ``.html``, or the file cannot be written there.

        Examples
        --------
        >>> import tempfile
        >>> from kinlab import ArmView, robots
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     ArmView(robots.alpha_ii()).save_html(folder + "/arm.html").name
        'arm.html'
        """
        return page.save(path, self._name, self.html(address=True))

    def html(self, *, address: bool = False) -> str:
        """The view as a piece of a page, for `page.script` and `page.style` to move."""
        off = {entry["layer"] for entry in self._canvas.scene["layers"] if not entry["on"]}
        parts = [item.gid for item in self._scene.items if item.layer in off]
        data = {"scene": self._canvas.scene, "q": self._values.tolist()}
        return page.part(page.hidden(self._still(), parts), data, repr(self),
                         map(_carried, self.children[2:]), address=address)

    def _still(self) -> str:
        """The picture as it stands now, with every layer, as SVG."""
        every = {item.layer for item in self._scene.items}
        return worker.svg(self._scene, self._values, self._preset, tuple(every))

    def _take(self, scene: Scene, knobs: Sequence[Knob], name: str, preset: str | None) -> None:
        """Show another scene. Sliders stay where they fit, so that nothing piles up."""
        spare = self.sliders
        self._scene, self._knobs, self._name = scene, tuple(knobs), name
        self._preset = preset or next(iter(scene.presets))
        self._scales = np.array([knob.scale for knob in knobs])
        self.sliders = [knob.fitted(spare[k] if k < len(spare) else None)
                        for k, knob in enumerate(knobs)]
        for slider in self.sliders:
            if slider not in spare:
                slider.observe(self._forget, "value")
        for slider in spare:
            if slider not in self.sliders:
                for part in parts(slider):
                    part.close()

    def _picture(self, panels: dict | None) -> dict:
        """What the canvas needs."""
        return {"svg": self._still(), "scene": self._data() | (panels or {}),
                "sliders": self.sliders}

    def _replace(self, scene: Scene, knobs: Sequence[Knob], values: np.ndarray, name: str,
                 panels: dict, preset: str) -> None:
        """Another scene in the place of this one, in one step for the browser."""
        self._canvas.hold = True
        self._take(scene, knobs, name, preset)
        note = self._set(values)
        if self._panel.children != tuple(self.sliders):
            self._panel.children = self.sliders
        with self._canvas.hold_sync():
            for trait, value in self._picture(panels).items():
                setattr(self._canvas, trait, value)
            self._canvas.note, self._canvas.hold = note, False

    def _move(self, values: np.ndarray) -> None:
        """Set all knobs at once; those beyond a limit stop there, and the view says so."""
        self._canvas.hold = True
        note = self._set(values)
        self._canvas.hold = False
        self._canvas.note = note

    def _set(self, values: np.ndarray) -> str:
        """Set all sliders within their limits, and say which stopped there."""
        low, high = np.array([(knob.low, knob.high) for knob in self._knobs]).T
        allowed = np.clip(values, low, high)
        for slider, value in zip(self.sliders, allowed / self._scales):
            slider.value = value
        stopped = np.abs(allowed - values) > 1e-9 * (high - low)
        return "; ".join(
            f"{knob.label} stops at its limit, {slider.value:.6g}{knob.suffix}"
            for knob, slider, beyond in zip(self._knobs, self.sliders, stopped) if beyond)

    def __repr__(self) -> str:
        values = [f"{knob.name}={numbers([slider.value])}{knob.suffix}"
                  for knob, slider in zip(self._knobs, self.sliders)]
        formulas = [reading.text.format(*map(_said, self.readings[reading.name]))
                    for reading in self._scene.readings]
        return "\n".join([f"{type(self).__name__}({', '.join([repr(self._name), *values])})",
                          *formulas])

    def _repr_mimebundle_(self, **kwargs: Any) -> tuple[dict, dict] | dict:
        """The widget, and for places where none runs a still picture and a text."""
        bundle = super()._repr_mimebundle_(**kwargs)
        if bundle is None:
            return {}
        still = worker.png(self._scene, self._values, self._preset, self._show)
        bundle |= {"text/plain": repr(self), "image/png": still}
        return bundle, {"image/png": {"alt": f"{self.ALT} {self!r}"}}

    def _forget(self, _: Any) -> None:
        """A knob has moved: what was remarked about the setting before no longer holds."""
        self._canvas.note = ""

    def _data(self) -> dict:
        knobs = self._knobs
        home = [min(max(knob.home, knob.low), knob.high) for knob in knobs]
        return self._scene.data() | {
            "name": self._name, "preset": self._preset, "layers": [], "pose": None,
            "joints": [asdict(knob) | {"suffix": knob.suffix, "digits": knob.digits}
                       for knob in knobs],
            "decimals": decimals(self._scene.radius), "home": home, "poses": [],
            "target": None, "radius": self._scene.radius,
            "zero": [min(max(0.0, knob.low), knob.high) for knob in knobs],
        }


def _carried(widget: ipywidgets.Widget) -> str:
    """What a page can show of a widget beside the view: its text, or that it stayed behind."""
    if isinstance(widget, ipywidgets.HTMLMath):
        return f'<div class="kl-math">{page.typeset(widget.value)}</div>'
    if isinstance(widget, ipywidgets.HTML):
        return f"<div>{widget.value}</div>"
    return '<p class="kl-needs">What stands here in the notebook needs JupyterLab.</p>'


def parts(widget: ipywidgets.Widget) -> list[ipywidgets.Widget]:
    """A widget, its layout and style, and those of all widgets within it."""
    own = [getattr(widget, name) for name in ("layout", "style") if widget.has_trait(name)]
    inner = [part for child in getattr(widget, "children", ()) for part in parts(child)]
    return [widget, *own, *inner]


def decimals(size: float) -> int:
    """Decimals that tell a thousandth of a picture's size: 1 for millimetres, 3 for metres."""
    return min(3, max(1, 3 - math.floor(math.log10(size))))


def _said(values: Sequence[float] | str) -> str:
    if isinstance(values, str):
        return values
    return f"({numbers(values)})" if len(values) > 1 else numbers(values)


def numbers(values: Sequence[float]) -> str:
    """Values as text, rounded to four decimals."""
    return ", ".join(f"{round(float(value), 4) + 0.0:.8g}" for value in values)
