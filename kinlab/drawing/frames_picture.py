"""All frames of an arm, and the four parameters of the link that is chosen."""
from __future__ import annotations

from dataclasses import replace
from typing import Any

from ..arms.arm import Arm, check_arm
from .controls import Knob
from .link_picture import LinkSketch
from .readings import Entry
from .scene import Item, Scene, Step
from .sketch import Sketch


def frames_scene(arm: Arm, q: Any) -> Scene:
    """The arm with its frames; the knob "link" says whose parameters are drawn, 0 for none."""
    check_arm(arm)
    sketch = Sketch.of(arm, q, name=f"Frames of {arm.name or 'the arm'}",
                       show=("frames", "labels", "axes"))
    sketch.planar = False
    sketch.presets, sketch.poses = dict(sketch.scene().presets), []
    sketch.knobs = [replace(knob, label=f"{knob.label}*") for knob in sketch.knobs]
    rows = range(1, len(arm.links) + 1)
    chosen = sketch.knob(Knob("link", "link", 0, len(rows), title="Links", whole=True,
                              names=("All", *(f"Link {row}" for row in rows))))
    sketch.start.append(0.0)
    studies = [LinkSketch(arm, row, q) for row in rows]
    for study in studies:
        _measure(sketch, study, chosen)
    sketch.reading("row", "{}", Entry(chosen, (_all(arm), *(study.row() for study in studies))))
    return sketch.scene()


def _measure(sketch: Sketch, study: LinkSketch, chosen: int) -> None:
    """Arcs and dimension lines of one link, taken over from its own picture."""
    arm, before = len(study.steps) - 4, len(study.items)  # frames of the arm itself
    study.axes_of_action()
    for k in range(4):
        study.mark(k, study.frames)
    shift = len(sketch.steps) - arm

    def moved(frame: int) -> int:
        return frame if frame <= arm else frame + shift

    for number, step in enumerate(study.steps[arm:], start=arm):
        assert isinstance(step, Step)
        parent = number if step.parent is None else step.parent
        sketch.steps.append(replace(step, parent=moved(parent)))
    sketch.items += [_taken(item, study.link, sketch.body(), [
        (moved(frame), x, y, z) for frame, x, y, z in item.points], chosen)
        for item in study.items[before:]]


def _taken(item: Item, link: int, body: int, points: list, chosen: int) -> Item:
    return replace(item, gid=f"link-{link}-{item.gid}", points=tuple(points), body=body,
                   when=(chosen, link - 0.5, link + 0.5))


def _all(arm: Arm) -> str:
    names = ", ".join(str(row) for row in range(len(arm.links)))
    return f"All frames: {names} and {len(arm.links)}. Choose a link to see its four numbers."
