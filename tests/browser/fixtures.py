"""What Python computes, for the tests of the JavaScript under Node.

``python tests/browser/fixtures.py`` writes the files anew; test_fixtures.py compares them.
"""
from __future__ import annotations

import json
import math
import sys
from pathlib import Path

import numpy as np

import kinlab as kl
from kinlab.arms.motions import ROTATE, TRANSLATE
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.scene import Scene, Step, Velocity
from kinlab.tables.cells import angle_text, read_angle, read_length

HERE = Path(__file__).parent
FOLDER = HERE / "js"
X, Y, Z = 0, 1, 2


def bent() -> kl.Arm:
    """An arm with a base and a tool, standing on its side."""
    links = [kl.revolute(d=0.3, a=0.1, alpha=0.7),
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


TEXTS = ["30", "-90", "0.1", "+7", "1e2", "1e-12", "1e-9", "1e9", "1e10", "1e4", "2*45", "pi",
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
    sys.path.insert(0, str(HERE.parent / "tables"))
    from test_numbers import BAD, GOOD

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


FIXTURES = {"frames": frames, "numbers": numbers}


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
