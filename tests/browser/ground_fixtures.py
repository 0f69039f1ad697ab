"""What Python computes of labels and of the floor, for fixtures.py."""
from __future__ import annotations

from dataclasses import asdict, replace
from itertools import cycle

import numpy as np

import kinlab as kl
from kinlab.drawing.camera import Camera, lens
from kinlab.drawing.floor import Solid, drop, ground, shadow
from kinlab.drawing.labels import Bar, Label, place, text_size
from kinlab.drawing.scene import Floor, Scene

CROWDS = {  # arm, its pose, picture
    "six links at home": (kl.robots.practical_six_link, [0, 90, -90, 0, 0, 0], (580, 520)),
    "six links on a phone": (kl.robots.practical_six_link, [20, 10, -130, 40, 70, 5], (340, 330)),
    "shoulder of three frames": (kl.robots.intelledex_660t, [10, 80, 40, 30, 60, -20], (900, 700)),
    "wrist": (kl.robots.alpha_ii, [0, 20, 30, -40, 90], (390, 380)),
}


TEXTS_SHOWN = ("x₀", "z₁₂", "(−1.25, 0.30)", "shoulder", "WAIST", "θ₁ + θ₂", "ẋ", "v_C/B · 2", "")


def labels() -> dict:
    """Labels of an arm's frames, new and then while the picture is turned and stands again."""
    crowds = {name: {"size": size, "pictures": _turned(make(), np.radians(q), size)}
              for name, (make, q, size) in CROWDS.items()}
    return {"texts": [[text, *text_size(text)] for text in TEXTS_SHOWN], "crowds": crowds}


def _turned(arm: kl.Arm, q: np.ndarray, size: tuple[float, float]) -> list[dict]:
    pictures: list[dict] = []
    states = {}
    for turn in (0, 3, 6, 6, 6):
        arrows, *crowd = crowded(arm, q, Camera(-60 + turn, 24), size)
        arrows = [replace(label, state=states.get(i)) for i, label in enumerate(arrows)]
        places, restless = place(arrows, *crowd, size)
        states = {i: one.state for i, one in enumerate(places) if one}
        pictures.append(_plain({
            "labels": [[label.anchor, label.start, label.w, label.h] for label in arrows],
            "crowd": [[[bar.a, bar.b, bar.radius] for bar in bars] for bars in crowd[:2]],
            "fixed": crowd[2], "restless": restless,
            "places": [one and [one.x, one.y, one.state.spot, one.leader] for one in places]}))
    return pictures


def crowded(arm: kl.Arm, q: np.ndarray, camera: Camera, size: tuple[float, float]) -> tuple:
    """Labels of all arrows of an arm's frames on a picture, strokes, solids and what is fixed."""
    T = kl.link_frames(arm, q)
    radius = 1.2 * np.max(np.linalg.norm(kl.link_frames(arm, arm.home)[:, :3, 3], axis=-1))
    look = lens(Scene((), (), 0, (0.0, 0.0, 0.3 * radius), radius), camera, size)
    origins = np.round(look.see(T[:, :3, 3])[:, :2], 2)
    words = [_arrow(pose, k, look, f"{'xyz'[k]}{subscript(i)}", i, size)
             for i, pose in enumerate(T) for k in range(3)]
    solids = [Bar(tuple(a), tuple(b), 0.022 * min(size))
              for a, b in zip(origins.tolist(), origins[1:].tolist())]
    tip = origins[-1].tolist()
    return (words, [Bar(tuple(tip), (tip[0], size[1] - 40.0))], solids,
            [(tip[0], size[1] - 30.0, 74.0, 15.0)])


def _arrow(pose: np.ndarray, k: int, look, text: str, i: int, size) -> Label:
    length = (0.075 + 0.02 * (i % 3)) * min(size) / look.scale
    tail, tip = (tuple(np.round(look.see(pose[:3, 3] + far * pose[:3, k])[:2], 2).tolist())
                 for far in (0.0, length))
    return Label(tip, tail, *text_size(text))


def subscript(number: int) -> str:
    """A number as a subscript."""
    return "".join(chr(ord("₀") + int(digit)) for digit in str(number))


SOLIDS = [Solid("tube", np.array([[0, 0, 0], [1, 0.2, 0.5]]), (0.1, 0.05)),
          Solid("tube", np.array([[0, 0, 0], [0, 0, 0.5]]), (0.1, 0.1)),
          Solid("tube", np.array([[0.1, 0, 0], [0.1, 0, 0]]), (0.1, 0.1)),
          Solid("ball", np.array([[1, 0.2, 0.5]]), (0.1,)),
          Solid("box", np.array([[0, 0, 0], [0.3, 0.1, 0.1], [0, 0.1, 0], [0.02, 0, 0.1]]), ())]
GROUNDS = {  # azimuth, elevation, perspective; floor; point of a drop line
    "from a corner": ((-60, 24, False), Floor(-0.2, 0.5, 2.6, (), 2), (1.0, 0.7, 0.9)),
    "in perspective": ((30, 40, True), Floor(0.0, 0.25, 2.0, (), 3), (-0.125, 0.0625, 0.4)),
    "from above": ((-90, 90, False), Floor(0.0, 0.5, 2.5, (), 2), (-1.0, 0.005, 0.0)),
    "from the front": ((-90, 0, False), Floor(-0.3, 0.2, 1.5, (), 1), (0.2, 0.3, -1.2)),
    "from the side": ((0, 0, False), Floor(-0.3, 1.0, 4.0, (), 0), (2.5, -0.4, 1.0)),
    "from below": ((20, -35, False), Floor(0.1, 0.1, 1.0, (), 2), (0.4, -0.3, -0.001)),
    "upside down": ((-90, -90, False), Floor(0.0, 0.5, 2.5, (), 2), (0.3, 0.1, 0.5)),
}
LENS_SCENE = Scene((), (), 0, (0.2, 0.1, 0.3), 1.6)
FRAMING = ("center", "radius", "size", "presets", "preset", "fit")


def floor() -> dict:
    """The floor, shadows and a drop line from all sides, on wide and on narrow pictures."""
    sizes = cycle([(340, 330), (1280, 700), (580, 520)])
    return {name: _floor(view, area, point, next(sizes))
            for name, (view, area, point) in GROUNDS.items()}


def _floor(view: tuple, area: Floor, point: tuple, size: tuple[float, float]) -> dict:
    camera = Camera(*view[:2], perspective=view[2])
    look = lens(LENS_SCENE, camera, size)
    seen, line = ground(area, look, size), drop(area, look, size, point)
    numbers = [{"axis": one.axis, "opacity": one.opacity, **_words(one.words)}
               for one in seen.numbers]
    return _plain({
        "floor": asdict(area), "camera": asdict(camera), "size": size, "point": point,
        "scene": {name: LENS_SCENE.data()[name] for name in FRAMING},
        "solids": [one._asdict() for one in SOLIDS],
        "ground": {**vars(seen), "numbers": numbers, "fade": seen.fade._asdict()},
        "drop": {**vars(line), "texts": list(map(_words, line.texts))},
        "shadow": shadow(area, look, SOLIDS)})


def _words(words) -> dict:
    return {"text": words.text, "place": words.place, "w": words.w, "h": words.h}


def _plain(data):
    """Arrays as lists, however deep they lie."""
    if isinstance(data, dict):
        return {key: _plain(value) for key, value in data.items()}
    if isinstance(data, list | tuple | np.ndarray):
        return [_plain(value) for value in data]
    return round(float(data), 6) if isinstance(data, float) else data
