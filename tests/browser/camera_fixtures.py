"""What Python makes of cameras and of painter's order, for the tests of the JavaScript."""
from __future__ import annotations

from dataclasses import asdict

import numpy as np

from kinlab.drawing.camera import Camera, lens
from kinlab.drawing.order import Body, back_to_front
from kinlab.drawing.scene import Fit, Scene


def framings() -> list[dict]:
    """Scenes, framed in both ways and from all sides, with what the lens makes of points."""
    rng = np.random.default_rng(10)
    return [_framing(rng, fits=k % 3 > 0, perspective=k % 2 > 0) for k in range(24)]


def _framing(rng: np.random.Generator, *, fits: bool, perspective: bool) -> dict:
    scene, camera, size = _framed(rng, fits), _camera(rng, perspective), _size(rng)
    extents, home, points = _balls(rng, 7), _balls(rng, 7), _numbers(rng, (4, 3))
    middle = scene.center if fits else tuple(_numbers(rng, 3).tolist())
    made, told = lens(scene, camera, size, extents, home, middle), scene.data()
    return {"scene": {key: told[key] for key in FRAMED}, "camera": asdict(camera), "size": size,
            "extents": extents, "home": home, "middle": middle, "points": points.tolist(),
            "lens": {"scale": made.scale, "shrunk": made.shrunk, "see": made.see(points).tolist(),
                     "eye": made.eye(points).tolist(), "turn": made.turn(points).tolist()}}


FRAMED = ("presets", "preset", "center", "radius", "fit")


def _framed(rng: np.random.Generator, fits: bool) -> Scene:
    center, middle = (tuple(_numbers(rng, 3).tolist()) for _ in range(2))
    return Scene((), (), 0, center, 2.5, fit=Fit(middle, 1.2, 0.1) if fits else None)


def _camera(rng: np.random.Generator, perspective: bool) -> Camera:
    azimuth, elevation, zoom = rng.uniform([-180, -90, 0.4], [180, 90, 3]).round(2).tolist()
    return Camera(azimuth, elevation, zoom, perspective)


def _size(rng: np.random.Generator) -> tuple[int, int]:
    width, height = rng.integers(300, (1900, 1000)).tolist()
    return width, height


def _numbers(rng: np.random.Generator, shape: int | tuple[int, int]) -> np.ndarray:
    return rng.uniform(-1, 1, shape).round(3)


def _balls(rng: np.random.Generator, count: int) -> list:
    radii = rng.uniform(0, 0.3, count).round(3).tolist()
    return list(zip(_numbers(rng, (count, 3)).tolist(), radii))


def orders() -> list[dict]:
    """Bodies with their painter's order: many on a lattice, where much is side by side."""
    rng = np.random.default_rng(11)
    return [_order(rng, digits=k % 3, perspective=k % 2 > 0) for k in range(12)]


def _order(rng: np.random.Generator, *, digits: int, perspective: bool) -> dict:
    scene = Scene((), (), 0, (0.0, 0.0, 0.0), 2.0)
    camera = Camera(-60, 24, 1.0, perspective) if digits else Camera(-90, 0, 1.0, perspective)
    ends = rng.uniform(-1, 1, (40, 2, 3)).round(digits).tolist()
    radii = rng.choice([0, 0.05, 0.1], 40).tolist()
    bodies = [Body(p, q, r) for (p, q), r in zip(ends, radii)]
    bodies.append(Body([0, 0, -0.5], [0, 0, -0.4], 0.3, ([0, 0, 1], [0, 0, -0.4])))
    return {"camera": asdict(camera), "bodies": [_told(body) for body in bodies],
            "order": back_to_front(bodies, lens(scene, camera, (580, 520)))}


def _told(body: Body) -> dict:
    plane = body.plane and dict(zip(("normal", "at"), body.plane))
    return {"p": body.p, "q": body.q, "r": body.r, "plane": plane}
