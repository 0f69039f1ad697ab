"""The live view: one widget that draws a scene in the browser and holds its knobs as traits."""
from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, ClassVar

import anywidget
import numpy as np
import traitlets

from ..arms import inputs
from ..arms.motions import Numbers
from ..browser import bundle, page
from ..drawing import worker
from ..drawing.controls import Knob, decimals
from ..drawing.readings import TURNS
from ..drawing.scene import CLOUD, SOLIDS, Scene
from .folding import is_folded

DECIMALS = 4  # of numbers in words, where nothing asks for more

class KnobValue(traitlets.TraitType):
    """The value of a knob in its slider's unit, kept within the knob's limits."""

    name: str  # a view gives each one its name

    def validate(self, view: LiveView, value: Any) -> float:
        low, high = view.knob(self.name).ends
        return min(max(inputs.number(self.name, value), low), high)


class KnobValues(traitlets.TraitType):
    """The values of several knobs in the scene's units (rad or length); what is read is a copy."""

    default_value = np.zeros(0)

    def get(self, view: traitlets.HasTraits, cls: type | None = None) -> np.ndarray:
        return np.array(super().get(view, cls))

    def set(self, view: LiveView, value: Any) -> None:  # type: ignore[override]  # views only
        if isinstance(value, np.ndarray) and np.array_equal(value, self.get(view)):
            return  # traitlets sets each value once more before it tells of a change
        if view.settling:
            super().set(view, np.array(value))
        else:
            view.move(value)


class Control:
    """One knob of a view, to be read and set like a slider: in degrees or in the view's unit.

    Attributes
    ----------
    value : float
        Setting it moves the picture; it stops at `min` and `max`.
    name, description : str
        The name of the view's trait, and what stands beside the slider.
    min, max : float
    """

    def __init__(self, view: LiveView, knob: Knob) -> None:
        self._view, self._knob = view, knob
        self.name, (self.min, self.max) = knob.name, knob.ends
        self.description = knob.label + (f" ({knob.unit})" if knob.unit else "")

    @property
    def value(self) -> float:
        return getattr(self._view, self.name)

    @value.setter
    def value(self, value: float) -> None:
        setattr(self._view, self.name, value)

    def observe(self, handler: Callable, names: str = "value") -> None:
        """Call `handler` with each change of the value, as `traitlets` does."""
        inputs.choice("names", names, ("value",))
        self._view.observe(handler, self.name)

    def __repr__(self) -> str:
        value = numbers([self.value], self._view.decimals)
        return f"{self.description}: {value}, from {self.min:g} to {self.max:g}"


class LiveView(anywidget.AnyWidget):
    """A scene with its knobs, and the numbers that follow them.

    Each knob is a trait of the view, in the unit of its slider (degrees or a length):
    ``view.theta = 30`` moves the picture, ``view.observe(f, "theta")`` hears of it, and
    ``ipywidgets.jslink((slider, "value"), (view, "theta"))`` ties it to any other widget.

    Parameters
    ----------
    scene : Scene

    Attributes
    ----------
    q : array
        Values of the knobs (rad or length); setting it moves all at once.

    Examples
    --------
    A view is indexed by the names of its knobs, too: ``view["theta"].value = 30``.
    """

    ALT = "Picture of the arm."  # how the words for the picture begin

    _esm = bundle.module("host_jupyter.js")
    _css = bundle.style("live.css")
    _page: ClassVar[dict] = {}  # what a page with this view needs besides
    scene = traitlets.Dict().tag(sync=True)
    note = traitlets.Unicode().tag(sync=True)
    folded = traitlets.Bool().tag(sync=True)  # drawn when it is opened
    formula = traitlets.Unicode().tag(sync=True)  # MathML
    q = KnobValues()

    def __init__(self, scene: Scene, *, formula: str = "") -> None:
        self.settling = False  # True while traits that belong together are being set
        self._named: dict[str, Knob] = {}
        self._knobs_ever: set[str] = set()
        self._take(scene, scene.begin)
        super().__init__(scene=scene.data(), formula=formula)

    # ---- knobs ----

    def knob(self, name: str) -> Knob:
        """The knob of this name; ValueError if this view has none."""
        return self._named[inputs.choice("name", name, tuple(self._named))]

    def __getitem__(self, name: str) -> Control:
        return Control(self, self.knob(name))

    @property
    def decimals(self) -> int:
        """Decimals of numbers in words; an arm of a few hundredths of its unit has more."""
        return max(DECIMALS, decimals(self._scene.radius))

    @property
    def controls(self) -> list[Control]:
        """Every knob, in order."""
        return [Control(self, knob) for knob in self._scene.knobs]

    def move(self, q: Any) -> None:
        """Set `q`; what is beyond a limit stops there, and the view says so."""
        n = len(self._scene.knobs)
        self._move(inputs.shaped("q", q, (n,), f"{n} values, one for each slider"))

    @property
    def readings(self) -> dict[str, tuple[np.ndarray | str, ...]]:
        """The parts of each formula under the picture, by its name."""
        return self._scene.read(self._values)

    def copied(self) -> tuple[Scene, np.ndarray]:
        """The scene and the values of all its knobs, for another picture of it."""
        return self._scene, self._values.copy()

    # ---- pages ----

    def save_html(self, path: str | os.PathLike, question: str = "") -> Path:
        """Write the view, as it stands now, as one page that moves without Jupyter and network.

        The page holds all it needs and may be opened from a disk, put on a web server or into a
        course system. ``#q=30,40,-20`` behind its address sets the sliders; **Copy link** copies
        that. An older file of this name is replaced.

        Parameters
        ----------
        path : str or path
            Where to write it; ends in ``.html``.
        question : str
            What to find out with it; stands under the title, beside the picture.

        Returns
        -------
        Path

        Raises
        ------
        ValueError
            If the name does not end in ``.html``, or the file cannot be written there; if the
            question is not a line of text.

        Examples
        --------
        >>> import tempfile
        >>> from kinlab import ArmView, robots
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     ArmView(robots.alpha_ii()).save_html(folder + "/arm.html").name
        'arm.html'
        """
        inputs.line("question", question)
        return page.save(path, self._scene.name, self.html(address=True), question,
                         without=self._without(), **self._page)

    def _without(self) -> list[str]:
        """Modules that a page of this view alone can do without."""
        shapes = {item.shape for item in self._scene.items}
        kinds = {part.kind for reading in self._scene.readings for part in reading.parts}
        needed = {"chart.js": self._scene.chart is not None, "cloud.js": CLOUD in shapes,
                  "timed.js": self._scene.timed is not None,
                  "following.js": self._scene.target is not None,
                  "marks.js": self._scene.timed is None, "formula.js": bool(self.formula),
                  "turned.js": bool(kinds & TURNS)}
        return [module for module, wanted in needed.items() if not wanted]

    def html(self, *, address: bool = False) -> str:
        """The view as a piece of a page that has kinlab's script and style (`bundle`)."""
        data = {"scene": self.scene, "q": self._values.tolist()}
        return page.part(self._still(), data, repr(self), self.formula, address=address)

    # ---- the picture for places where no widget runs ----

    def _still(self, words: str = "") -> bytes:
        """The picture as it stands now, as PNG."""
        return worker.png(self._scene, self._values, self._scene.seen_from, self._scene.shown,
                          words)

    def _run(self) -> str:
        """What to do where no widget runs."""
        arm = any(item.shape in SOLIDS for item in self._scene.items)
        return f"Run this cell to move the {'arm' if arm else 'picture'}"

    def __repr__(self) -> str:
        values = [f"{knob.name}={numbers([getattr(self, knob.name)], self.decimals)}{knob.suffix}"
                  for knob in self._scene.knobs]
        read = self.readings
        formulas = [
            reading.said(_said(part, self.decimals) for part in read[reading.name])
            for reading in self._scene.readings]
        return "\n".join([f"{type(self).__name__}({', '.join([repr(self._scene.name), *values])})",
                          *formulas])

    def _repr_mimebundle_(  # type: ignore[override]  # IPython takes a dict alone, too
            self, **kwargs: Any) -> tuple[dict, dict] | dict:
        """The widget, and for places where none runs a still picture and a text."""
        self.folded = is_folded()
        shown = super()._repr_mimebundle_(**kwargs)
        if shown is None:
            return {}
        widget, metadata = shown if isinstance(shown, tuple) else (shown, {})
        others, words = self._elsewhere()
        return (widget | others, metadata | words) if metadata | words else widget | others

    def _elsewhere(self) -> tuple[dict, dict]:
        """A text and a picture, with words for those who cannot see it."""
        if worker.ASKED_ONLY:
            return {"text/plain": repr(self)}, {}
        return ({"text/plain": repr(self), "image/png": self._still(self._run())},
                {"image/png": {"alt": f"{self.ALT} {self!r}"}})

    def close(self) -> None:
        """Close the view; its memory is free again."""
        if self.comm is not None:
            self.unobserve_all()
            self.layout.close()
            super().close()

    # ---- values: the knobs, `q` and the picture agree whoever has set one of them ----

    def _take(self, scene: Scene, values: Numbers) -> None:
        """Show a scene from now on, at these values; its knobs become traits."""
        self._scene = scene
        self._named = {knob.name: knob for knob in scene.knobs}
        self._in_q = slice(0, self._joints_of(scene))
        self._scales = np.array([knob.scale for knob in scene.knobs])
        self._values = self._within(values)
        fresh = [knob.name for knob in scene.knobs if knob.name not in self._knobs_ever]
        for name in fresh:
            if not name.isidentifier() or hasattr(self, name) or fresh.count(name) > 1:
                raise ValueError(f"name: a knob cannot be called {name!r}; choose a name for "
                                 "Python that the view does not have yet")
        self._knobs_ever.update(fresh)
        self.add_traits(**{name: KnobValue(0.0).tag(sync=True) for name in fresh})
        self.observe(self._heard, fresh)
        with self._settled():
            self._show_values()

    def _joints_of(self, scene: Scene) -> int:
        """How many of the knobs are in `q`: not those of a target."""
        return scene.target.joints if scene.target else len(scene.knobs)

    def _replace(self, scene: Scene, values: np.ndarray) -> None:
        """Another scene in the place of this one, in one step for the browser."""
        with self.hold_sync(), self.hold_trait_notifications():
            gone = set(self._named) - {knob.name for knob in scene.knobs}
            self._take(scene, values)
            kept = [key for key in self.keys if key not in gone]
            self.keys: list[str] = kept + [name for name in self._named if name not in kept]
            self.scene = scene.data()
            self.note = self._stops(values)

    def _move(self, values: Numbers) -> None:
        """Set all knobs at once; those beyond a limit stop there, and the view says so."""
        wanted, self._values = np.asarray(values, float), self._within(values)
        with self.hold_sync(), self._settled():
            self._show_values()
            self.note = self._stops(wanted)

    def _show_values(self) -> None:
        """Bring the traits to the values; 30 degrees are 30.0, not 29.999999999999996."""
        for name, value in zip(self._named, self._values / self._scales):
            setattr(self, name, float(f"{value:.13g}"))
        self._shown = [getattr(self, name) for name in self._named]
        self.q = self._values[self._in_q]

    @contextmanager
    def _settled(self) -> Iterator[None]:
        """Set several traits; who observes one of them finds all of them set, and may set more."""
        with self.hold_trait_notifications():
            before, self.settling = self.settling, True
            try:
                yield
            finally:
                self.settling = before

    def _heard(self, _: Any) -> None:
        """A knob has been set, by Python or by a hand: those that moved, and nothing else."""
        now = [getattr(self, name) for name in self._named]
        moved = [k for k, (a, b) in enumerate(zip(now, self._shown)) if a != b]
        if not moved:
            return
        self._shown = now
        self._values[moved] = np.multiply(now, self._scales)[moved]
        with self._settled():
            self._follow(moved)
            self.q = self._values[self._in_q]
            self.note = ""  # what was remarked about the setting before no longer holds

    def _follow(self, moved: list[int]) -> None:
        """Move further knobs after some have moved, where they depend on each other."""

    def _within(self, values: Numbers) -> np.ndarray:
        return np.array([knob.within(float(value))
                         for knob, value in zip(self._scene.knobs, values)])

    def _stops(self, wanted: np.ndarray) -> str:
        """Which knobs stopped at a limit on their way to the values wanted."""
        return "; ".join(
            f"{knob.label} stops at its limit, {shown:.6g}{knob.suffix}"
            for knob, shown, value, reached in zip(self._scene.knobs, self._shown, wanted,
                                                   self._values)
            if abs(reached - value) > 1e-9 * (knob.high - knob.low))


def _said(values: Numbers | str, digits: int) -> str:
    if isinstance(values, str):
        return values
    return f"({numbers(values, digits)})" if len(values) > 1 else numbers(values, digits)


def numbers(values: Numbers, digits: int = DECIMALS) -> str:
    """Values as text, rounded to so many decimals."""
    return ", ".join(f"{round(float(value), digits) + 0.0:.8g}" for value in values)
