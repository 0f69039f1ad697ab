"""A frame that four motions carry to its place, in the order of either convention."""
from __future__ import annotations

from math import pi, radians

from ...arms.arm import CONVENTIONS
from ...arms.motions import ROTATE
from ...drawing.controls import Knob, PoseTable
from ...drawing.readings import Amount
from ...drawing.scene import origin_of
from ...drawing.sketch import Sketch
from ...views.live import LiveView

_LETTERS = {"theta": "θ", "d": "d", "a": "a", "alpha": "α"}
_LONGEST = 1.0  # m, of the two slides


def four_motions(convention: str) -> LiveView:
    """A link's four motions, one after another; each of the four numbers has a slider.

    The knob "motion" says how many are done: at 0 the frame lies on frame 0, at 4 it is frame 1.
    """
    sketch = Sketch(f"Four motions of a link, {convention}", 1.8, planar=False, unit="m",
                    center=(0.2, 0, 0.1), grid=0)
    knobs = {name: _knob(sketch, name) for name in ("theta", "d", "a", "alpha")}
    done = sketch.knob(Knob("motion", "motion", 0, 4, 4, step=0.1, title="motions done",
                              whole=True))
    frames = [0]
    for k, (kind, axis, name) in enumerate(CONVENTIONS[convention]):
        frames.append(sketch.move(kind, axis, 0.0, knobs[name], frames[-1], scrub=(done, k)))
        verb = "turn about" if kind == ROTATE else "slide along"
        sketch.reading(name, f"{k + 1}. {verb} {'xyz'[axis]} by {_LETTERS[name]}: "
                       f"{{}}{'°' if kind == ROTATE else ' m'}", Amount(frames[-1]))
    sketch.tip = frames[-1]
    sketch.axes("0", 0, 1.1)
    sketch.line("path", map(origin_of, frames), "trace")
    sketch.axes("1", sketch.tip, 0.8)
    sketch.pose = PoseTable.of_frame("The frame on its way, seen from frame 0", "1", "xyz",
                                     unit="m")
    sketch.start = [*(knob.home for knob in sketch.knobs)]
    sketch.poses = [[*sketch.start[:4], float(step)] for step in range(5)]
    return LiveView(sketch.scene())


def _knob(sketch: Sketch, name: str) -> int:
    """A slider for one of the four numbers."""
    home = {"theta": 40, "d": 0.9, "a": 0.8, "alpha": -60}[name]
    if name in ("theta", "alpha"):
        return sketch.knob(Knob.angle(name, _LETTERS[name], -pi, pi, radians(home)))
    return sketch.knob(Knob.length(name, name, 0.0, _LONGEST, home, "m"))
