"""What Python computes, for the tests of the JavaScript under Node.

``python tests/browser/fixtures.py`` writes the files anew; test_fixtures.py compares them.
"""
from __future__ import annotations

import json
import math
import sys
from pathlib import Path

import numpy as np
from camera_fixtures import framings, orders
from ground_fixtures import floor, labels
from study_fixtures import charts, cloud, curves, timed
from turned_fixtures import turned

import kinlab as kl
from kinlab.arms.motions import ROTATE, TRANSLATE
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.camera import Camera
from kinlab.drawing.paints import PAINTS
from kinlab.drawing.scene import Scene, Step, Velocity
from kinlab.drawing.solids import Face, faces, shades
from kinlab.tables.cells import angle_text, read_angle, read_length

HERE = Path(__file__).parent
FOLDER = HERE / "js"
X, Y, Z = 0, 1, 2


def bent() -> kl.Arm:
    """An arm with a base and a tool, standing on its side; one row is fixed, one joint flipped."""
    links = [kl.revolute(d=0.3, a=0.1, alpha=0.7, flip=True), kl.fixed(theta=0.2, d=-0.1),
             kl.prismatic(theta=0.4, alpha=-1.1, limits=(0, 1)), kl.revolute(theta=-0.2, a=0.5)]
    base = kl.homogeneous(kl.rotation_y(0.5), [1, 2, 3])
    return kl.Arm(links, base=base, tool=kl.homogeneous(np.eye(3), [0, 0.2, 0.1]))


def driven() -> Scene:
    """Motions that knobs scrub, lists of values, branches, and frames that show velocities."""
    return _scene(
        Step(ROTATE, Z, 0.3, joint=0, gain=2.0),
        Step(TRANSLATE, X, 0.8),
        Step(ROTATE, Z, joint=1, gain=-1.5, start=0.5),
        Step(TRANSLATE, X, 0.6, scrub=(2, 1.0)),
        Step(ROTATE, X, joint=1, gain=0.4, start=0.0, scrub=(2, 0.25), parent=2),
        Step(TRANSLATE, Y, joint=2, track=(0.0, 0.4, -0.2, 1.0)),
        Step(TRANSLATE, Z, joint=0, gain=0.5),
        Velocity(7, (1.0, 0.5, 0.25), joint=0),
        Velocity(7, (1.0, 0.5, 0.25)),
    )


def target() -> Scene:
    """Two links of 1 m and a point in their plane."""
    return _scene(Step(ROTATE, Z, joint=0), Step(TRANSLATE, X, 1.0), Step(ROTATE, Z, joint=1),
                  Step(TRANSLATE, X, 1.0), Step(TRANSLATE, X, joint=2, parent=0),
                  Step(TRANSLATE, Y, joint=3))


def _scene(*motions: Step | Velocity) -> Scene:
    return Scene(motions, (), len(motions), (0.0, 0.0, 0.0), 1.0)


CASES = {
    "planar": (arm_scene(kl.robots.two_link()), [[0.4, -1.2]]),
    "prismatic": (arm_scene(kl.robots.cylindrical()), [[0.7, 0.4, 0.25]]),
    "modified": (arm_scene(kl.to_modified(kl.robots.alpha_ii())), [[0.1, -0.7, 1.3, 0.2, -2.0]]),
    "base and tool": (arm_scene(bent()), [[-0.3, 0.6, 2.0]]),
    "driven": (driven(), [[0.2, 0.1, 0.1], [0.2, 0.9, 1.4], [-1.0, 7.0, 2.5], [0.5, 1.2, 9.0]]),
    "target": (target(), [[0.3, 0.5, 1.0, 0.5]]),
}


def frames() -> dict:
    """Scenes with their frames at some knobs' values: of each frame x, y, z and the origin."""
    return {name: {"motions": scene.data()["motions"], "poses": [
        {"q": q, "frames": _columns(scene.frames(q))} for q in poses]}
        for name, (scene, poses) in CASES.items()}


def _columns(T: np.ndarray) -> list:
    return np.round(np.swapaxes(T[:, :3, :], 1, 2), 12).tolist()


TEXTS = ["pi/2 + 90", "90 + pi/2 rad", "2*pi - pi/3", "pi**2", "pi*pi/pi", "sqrt(pi)",
         "1/(pi - 2*pi)", "30", "-90", "0.1", "+7", "1e2", "1e-12", "1e-9", "1e9", "1e10", "1e4",
         "2*45", "pi",
         "2*pi", "-pi/6", "π", "3*pi/4", "π rad", "1 rad", "-0.5 rad", "90 deg", "37.3°",
         "123.456º", "0 deg", "1e6 deg", "pi*1e9", "sin(pi)", "cos(pi/2)", "177.8*cos(pi/2)",
         "sqrt(2)*pi", "sin(30 deg)*2", "2**0.5", "2**3**2", "-2**2", "2**-2", "(1+2)*(3-4)", "1/3",
         "7 / 2 / 2", "8 - 3 - 2", "2--3", "2*-3", "-(3)", "--3", "+-3", "3 -", "* 3", "2**2 deg",
         "1/2 deg", "-45 deg + 90 deg", "90 deg*2 - 1 rad", "2 deg/3", "2/3 deg", "1/(2 deg)",
         "sin(1)(2)", "pi(2)", "sin 2", "sin(sin)", "sqrt(sqrt(16))", "sqrt(2", "sin()", "sin(*5)",
         "sin(**5)", "10 mm", "5m", "tan(1)", "exp(1)", "e", "inf", "1e400", "1e-400", "0/0",
         "0**0", "1/0*0", "(((1)))", "(" * 50 + "1" + ")" * 50, "-" * 150 + "1", "1" + "+1" * 99,
         "1 000", "1'000", "1_000", "5\n+\n5", "\t7 ", "7\u00a0", "٣", "１", "½", "2×3", "2·3",
         "2^3", "5–2", "5−2", "3 ** ** 2", "5 deg deg", "deg 5", "pi deg", "45°30", "(45)°",
         "(1 2)", "..5", "5..", "1.e3", "1e", "1e+", "e5", ".e5", "1.5e3.2", "_", "__class__",
         "eval(1)"]


def numbers() -> list[dict]:
    """Texts with what a cell reads: as an angle in degrees and in radians, and as a length.

    Texts with commas are left out: a field also reads decimal ones.
    """
    sys.path.insert(0, str(HERE.parent))
    from typed_numbers import BAD, GOOD

    texts = dict.fromkeys([*GOOD, *BAD, *TEXTS])
    return [{"text": text, "deg": _read(_degrees, text), "length": _read(read_length, text),
             "rad": _read(lambda text: read_angle(text, "rad"), text)}
            for text in texts if "," not in text and len(text) < 1000]


def _degrees(text: str) -> float:
    return float(angle_text(read_angle(text, "deg"), "deg"))


def _read(how, text: str) -> float | None:
    try:
        value = how(text)
    except ValueError:
        return None
    assert math.isfinite(value)
    return value


class Look:
    """A camera in the simplest words; with `far`, that far from the room's origin."""

    def __init__(self, azimuth: float, elevation: float, scale: float, far: float | None = None):
        self.rows, self.scale, self.far = Camera(azimuth, elevation).axes, scale, far

    def see(self, points: np.ndarray) -> np.ndarray:
        right, up, near = self.rows @ np.moveaxis(points, -1, 0)
        size = 1.0 if self.far is None else self.far / (self.far - near)
        return np.stack([300 + self.scale * size * right, 200 - self.scale * size * up,
                         size + 0 * near], axis=-1)

    def eye(self, point: np.ndarray) -> np.ndarray:
        return self.rows[2] if self.far is None else self.far * self.rows[2] - point

    def turn(self, direction: np.ndarray) -> np.ndarray:
        return self.rows @ direction

    def data(self) -> dict:
        return {"rows": np.round(self.rows, 12).tolist(), "scale": self.scale, "far": self.far}


LOOKS = {"3-D": Look(-60, 24, 40), "top": Look(-90, 90, 40), "side": Look(0, 0, 12),
         "below": Look(75, -40, 12), "near": Look(-60, 24, 40, far=9)}
SOLIDS = [
    ("tube", "iron", [(0.2, 0.1, -0.5), (0.2, 0.1, 0.6)], (0.8, 0.8)),
    ("tube", "iron", [(-1, 0.3, 0.2), (0.7, 0.1, 0.4)], (0.5, 0.5)),
    ("tube", "steel", [(1, 0, 2), (-0.4, 1.3, 0.2)], (0.7, 0.4)),
    ("tube", "steel", [(1, 0, 0), (1, 0, 2)], (0.4, 0.7)),
    ("tube", "base", [(0, 0, 0), (0, 0, 0.3)], (2, 1.9)),
    ("tube", "iron", [(0.5, 0.5, 0.5), (0.5, 0.5, 0.5)], (0.3, 0.3)),
    ("tube", "steel", [(0, 0, 0), (1, 1, 0)], (0, 0)),
    ("ball", "steel", [(0.5, -0.2, 0.1)], (0.9,)),
    ("box", "sleeve", [(0, 0, -1), (0, 0, 1), (0.6, 0, -1), (0, 0.5, -1)], ()),
    ("box", "steel", [(0, 0, 0), (-0.2, 0.5, 1), (0.6, 0.1, 0), (0, 0.5, 0.2)], (1.0,)),
    ("box", "steel", [(0, 0, 0), (0, 0, -1), (0.6, 0, 0), (0, 0.5, 0)], (1.0,)),
    ("box", "grip", [(0, 0, 0), (0, 0, 1), (0, 0, 0), (0, 0.5, 0)], ()),
    ("box", "grip", [(0, 0, 0), (0, 0, 1), (0, 0.5, 0), (0.6, 0, 0)], ()),
]


def solids() -> dict:
    """Faces of solids from several sides, in a frame that is turned a little; and ramps."""
    pose = kl.homogeneous(kl.rotation_z(0.4) @ kl.rotation_x(0.2), [0, 0, 0])
    seen = [{"shape": shape, "points": points, "size": size, "style": style, "look": name,
             "faces": [_plain(face) for face in faces(shape, look, np.array(points, float), size,
                                                      PAINTS[style], pose)]}
            for shape, style, points, size in SOLIDS for name, look in LOOKS.items()]
    styles = {style: {**PAINTS[style], "shades": shades(PAINTS[style]["ramp"])}
              for style in ("iron", "sleeve", "steel", "base", "grip")}
    return {"frame": _columns(pose[None])[0], "styles": styles,
            "looks": {name: look.data() for name, look in LOOKS.items()}, "seen": seen}


AROUND = np.arange(24) * np.pi / 12


def _plain(face: Face) -> dict:
    """A face as data. Of an outline only how far it reaches: its corners hang on the last bit."""
    data = {"role": face.role, "level": face.level, "gradient": face.gradient and [
        np.round(part, 9).tolist() for part in face.gradient]}
    if face.role == "side":
        x, y = face.points.T
        far = np.outer(np.cos(AROUND), x) + np.outer(np.sin(AROUND), y)
        return data | {"reach": np.round(far.max(axis=1), 9).tolist()}
    return data | {"points": np.round(face.points, 9).tolist()}


FIXTURES = {"frames": frames, "numbers": numbers, "solids": solids, "labels": labels,
            "floor": floor, "camera": framings, "order": orders, "chart": charts, "timed": timed,
            "curves": curves, "cloud": cloud, "turned": turned}


def path(name: str) -> Path:
    """Where a fixture is kept."""
    return FOLDER / f"{name}.json"


def written(data: dict | list) -> str:
    """A fixture as text, an entry a line."""
    if isinstance(data, list):
        lines = [json.dumps(entry, ensure_ascii=True) for entry in data]
        return "[\n" + ",\n".join(lines) + "\n]\n"
    lines = [f"{json.dumps(name)}: {json.dumps(entry)}" for name, entry in data.items()]
    return "{\n" + ",\n".join(lines) + "\n}\n"


if __name__ == "__main__":
    for name, make in FIXTURES.items():
        path(name).write_text(written(make()), encoding="utf-8")
