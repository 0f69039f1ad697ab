"""What Python computes of charts, of curves that knobs shape and of clouds, for fixtures.py."""
from __future__ import annotations

from dataclasses import asdict

import numpy as np

import kinlab as kl
from kinlab.arms.motions import ROTATE, TRANSLATE
from kinlab.drawing.camera import Camera
from kinlab.drawing.chart import Chart, Curve, plot
from kinlab.drawing.cloud import layers, packed, unpacked
from kinlab.drawing.curves import corners, is_there
from kinlab.drawing.path_picture import path_scene
from kinlab.drawing.scene import AREA, LINE, PATCH, SWEEP, WAY, Item, Scene, Step, at
from kinlab.drawing.timed import Course, Panel, laid

X, Y, Z = 0, 1, 2
FALLING = Curve("newton", "first", "dot", (1.5, 0.4, 3e-3, 2e-7, 0.0))
SLOW = Curve("transpose", "second", "square", tuple(300 * 0.93 ** k for k in range(61)))
CHARTS = {"two": (Chart((FALLING, SLOW), "step", "error (mm)"), [0.0, 2.25, 4.0, 17.5, 99.0]),
          "one step": (Chart((Curve("a", "first", "dot", (1.0,)),), "step", "m"), [-1.0, 0.0]),
          "another knob": (Chart((FALLING,), "k", "e", 1), [3.0])}


def timed() -> dict:
    """Panels over time laid out on pictures of some sizes, at some times; a joint that slides."""
    arm = kl.Arm([kl.revolute(a=1, speed=0.9, acceleration=4), kl.prismatic(limits=(-1, 0.5))])
    path = kl.joint_path(arm, [0.2, -0.8], [1.4, 0.7], 2.0, "trapezoidal", ramp=0.25)
    told = path_scene(arm, path).timed
    data = told.data()
    few = slice(0, None, 30)  # samples
    times = [*data["times"][few], data["times"][-1]]
    for course in (course for panel in data["panels"] for course in panel["courses"]):
        course["values"] = [*course["values"][few], course["values"][-1]]
    for size in (1.3e7, 3e-6):  # numbers that are too long for an axis
        values = tuple(size * (time - 0.7) for time in times)
        data["panels"].append(Panel("far", (Course("tip", "trace", values, "m"),)).data())
    return {"times": times, "panels": [{"panel": panel, "plots": [
        {"size": size, "time": time, "plot": _plain(asdict(laid(panel, times, size, time)))}
        for size in ((320.0, 118.0), (560.0, 150.0), (1400.0, 200.0))
        for time in (0.0, 0.731, 1.2, 2.0, 9.0)]} for panel in data["panels"]]}


def charts() -> dict:
    """Charts laid out on pictures from a phone's to a wall's, at some steps."""
    return {name: {"chart": chart.data(), "plots": [
        {"size": size, "q": q, "plot": _plain(asdict(plot(chart, size, q)))}
        for size in ((320.0, 190.0), (560.0, 260.0), (1400.0, 420.0)) for q in _knobs(chart, steps)
    ]} for name, (chart, steps) in CHARTS.items()}


def _knobs(chart: Chart, steps: list[float]) -> list[list[float]]:
    return [[*[0.0] * chart.knob, step] for step in steps]


def swept() -> Scene:
    """Motions in pairs from one frame, and curves between them, of all kinds."""
    steps = (Step(TRANSLATE, X, 0.4), Step(ROTATE, Y, 0.7),
             Step(ROTATE, Z, joint=0, parent=2), Step(ROTATE, Z, joint=1, parent=2),
             Step(TRANSLATE, X, 1.0, parent=3),
             Step(ROTATE, X, joint=1, gain=-0.5), Step(ROTATE, X, 1.2, parent=5),
             Step(TRANSLATE, Y, joint=0, parent=5), Step(TRANSLATE, Y, joint=1, parent=5))
    items = (Item("turn", SWEEP, "mesh", at(5, (0.2, 0, 0.3)), size=(3, 4)),
             Item("slide", SWEEP, "mesh", at(8, (0, 0.1, 0)), size=(8, 9)),
             Item("patch", PATCH, "region", at(6, (0, 0.5, 0.1)), size=(3, 4, 6, 7)),
             Item("way", WAY, "trace", at(2, (0, 0, 0), (1, 0, 0), (1, 2, 0)), size=(1,)),
             Item("area", AREA, "region", at(1, (0, 0, 0), (1, 0, 0), (0, 1, 0)), when=(0, -1, 1)),
             Item("beyond", LINE, "mesh", at(4, (0, 0, 0), (1, 2, 3)), when=(0, 1.0, -0.5)),
             Item("line", LINE, "mesh", at(4, (0, 0, 0), (1, 2, 3)), when=(1, 2.0, 3.0)))
    return Scene(steps, items, 5, (0.0, 0.0, 0.0), 2.0)


def curves() -> dict:
    """The corners of each item, and whether it is there, at some knobs' values."""
    scene, poses = swept(), [[0.3, 2.0], [-1.0, 0.5], [1.5, 1.5], [-3.0, 2.5]]
    return {"scene": {"motions": scene.data()["motions"], "items": scene.data()["items"]},
            "poses": [{"q": q, "items": {item.gid: {
                "there": is_there(item, q),
                "corners": _plain(corners(item, scene.motions, scene.frames(q), q).tolist())}
                for item in scene.items}} for q in poses]}


def cloud() -> dict:
    """Dots as letters, and what is left of them in layers, from some sides."""
    dots = np.random.default_rng(5).uniform(-400, 400, (60, 3))
    corner, letters = packed(dots, 3.0)
    plane = Scene((Step(ROTATE, Z, 0.4), Step(TRANSLATE, Y, 30.0)), (), 2, (0.0, 0.0, 0.0),
                  1.0).frames([])[-1]
    middle, kept = [0.0, 10.0, 20.0], unpacked(corner, letters, 3.0)
    return {"corner": list(corner), "letters": letters, "step": 3.0,
            "plane": np.swapaxes(plane[:3], 0, 1).tolist(), "middle": middle, "radius": 500.0,
            "views": [{"camera": [azimuth, elevation], "cut": cut, "layers": _plain([
                layer.tolist() for layer in layers(
                    kept, plane if cut else None, Camera(azimuth, elevation).axes[2],
                    np.array(middle), 500.0)])}
                for azimuth, elevation in ((-60, 24), (-90, 90), (130, -30))
                for cut in (True, False)]}


def _plain(part: object) -> object:
    """Numbers to a billionth, tuples as lists."""
    if isinstance(part, dict):
        return {key: _plain(value) for key, value in part.items()}
    if isinstance(part, (list, tuple)):
        return [_plain(value) for value in part]
    return round(part, 9) if isinstance(part, float) else part
