"""Read what a live view draws, and say where it should stand by formulas typed here.

Nothing here goes through kinlab/drawing/figure.py or kinlab/browser/picture.js: only the arm's
frames, the scene's centre and scale, and an orthographic projection.
"""
from __future__ import annotations

import ast
from functools import cache

import numpy as np
from lab import run_code
from playwright.sync_api import Locator, Page, expect

import kinlab as kl
from kinlab.drawing.arm_scene import arm_scene

PIXELS = 0.02
READ = """view => {
    const svg = view.querySelector('.kl-picture svg'), text = node => node.textContent;
    const named = [...svg.querySelectorAll('g[id]')].filter(g => g.firstElementChild);
    const of = (tag, take) => Object.fromEntries(named
        .filter(g => g.firstElementChild.tagName === tag)
        .map(g => [g.id, take(g.firstElementChild)]));
    return {
        paths: of('path', node => node.getAttribute('d')),
        texts: of('text', node => [Number(node.getAttribute('x')), Number(node.getAttribute('y'))]),
        shown: Object.fromEntries(named.map(g => [g.id, getComputedStyle(g).display !== 'none'])),
        order: named.map(g => g.id),
        cells: [...view.querySelectorAll('.kl-pose tbody tr')].map(row =>
            [...row.cells].map(cell => Number(cell.textContent.replace('\u2212', '-')))),
        readouts: [...view.querySelectorAll('.kl-field')].map(field => Number(field.value)),
        remark: text(view.querySelector('.kl-remark')),
    };
}"""
SETTLE = """() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(
    () => setTimeout(done, 0))))"""


@cache
def scene_of(robot):
    return arm_scene(robot())


def settle(page: Page) -> None:
    """Wait until what was asked for has been painted."""
    page.evaluate(SETTLE)


def read(view: Locator) -> dict:
    """What the view shows now: paths, names, table, read-outs and remark."""
    settle(view.page)
    return view.evaluate(READ)


def numbers(path: str) -> np.ndarray:
    words = path.replace("M", " ").replace("L", " ").replace("Z", " ").split()
    return np.array(words, dtype=float).reshape(-1, 2)


def projected(scene, points, camera) -> np.ndarray:
    """Where a viewer at (azimuth, elevation, zoom) sees points of the room: x, y, nearness."""
    azimuth, elevation, zoom = camera
    a, e = np.radians(azimuth), np.radians(elevation)
    x, y, z = (np.asarray(points, float).reshape(-1, 3) - scene.center).T
    ahead = x * np.cos(a) + y * np.sin(a)
    right, up = y * np.cos(a) - x * np.sin(a), z * np.cos(e) - ahead * np.sin(e)
    (width, height), s = scene.size, scene.scale * zoom
    near = ahead * np.cos(e) + z * np.sin(e)
    return np.stack([width / 2 + s * right, height / 2 - s * up, near], axis=-1)


def assert_picture(seen: dict, robot, q, camera) -> None:
    """Frames, names, links and tool stand where the arm's kinematics puts them."""
    arm, scene = robot(), scene_of(robot)
    frames = dict(zip(map(str, range(arm.n + 1)), kl.link_frames(arm, q)))
    tool = kl.forward_kinematics(arm, q)
    if "frame-E-x" in seen["paths"]:
        frames["E"] = tool
    lengths = {item.gid: max(item.points[-1][1:]) for item in scene.items}
    worst = {}
    for name, T in frames.items():
        for k, letter in enumerate("xyz"):
            at = lambda gid, T=T, k=k: T[:3, 3] + lengths[gid] * T[:3, k]  # noqa: E731
            arrow, label = f"frame-{name}-{letter}", f"label-{name}-{letter}"
            want = projected(scene, [T[:3, 3], at(arrow), at(label)], camera)[:, :2]
            drawn = numbers(seen["paths"][arrow])
            worst[arrow] = np.abs(drawn[[0, 3]] - want[:2]).max()
            worst[label] = abs(seen["texts"][label][0] - want[2, 0])
            assert abs(seen["texts"][label][1] - want[2, 1]) < 6
    tip = projected(scene, tool[:3, 3], camera)[:, :2]
    worst["tool"] = np.abs(numbers(seen["paths"]["tool"]) - tip).max()
    assert max(worst.values()) < PIXELS, max(worst.items(), key=lambda pair: pair[1])


def assert_table(seen: dict, robot, q, decimals: int) -> None:
    tool = kl.forward_kinematics(robot(), q)
    rounding = np.full((4, 4), 0.5e-3)
    rounding[:, 3] = 0.5 * 10.0**-decimals
    assert np.all(np.abs(np.array(seen["cells"]) - tool) <= rounding * (1 + 1e-6))


def kernel_q(page: Page, name: str = "view") -> np.ndarray:
    """`view.q` as Python has it."""
    return np.array(ast.literal_eval(run_code(page, f"print({name}.q.tolist())")))


def in_units(robot, q) -> np.ndarray:
    """Joint values as the sliders show them: degrees or lengths."""
    return np.array([np.degrees(v) if link.kind == "revolute" else v
                     for link, v in zip(robot().links, q)])


def from_units(robot, values) -> np.ndarray:
    return np.array([np.radians(v) if link.kind == "revolute" else v
                     for link, v in zip(robot().links, values)])


def wait_for_readouts(view: Locator, values, digits: int = 1) -> None:
    """Wait until the sliders show these values."""
    for field, value in zip(view.locator(".kl-field").all(), values):
        expect(field).to_have_value(f"{round(value, digits) + 0.0:.{digits}f}")


def wait_for_kernel(page: Page, robot, values, name: str = "view") -> np.ndarray:
    """Wait until Python's joint values are those of the sliders, rounded; Python's values."""
    rounding = np.where([link.kind == "revolute" for link in robot().links], 0.051, 0.0051)
    for _ in range(60):
        q = kernel_q(page, name)
        if np.all(np.abs(in_units(robot, q) - values) < rounding):
            return q
        page.wait_for_timeout(50)
    raise AssertionError(f"Python has {in_units(robot, q)}, the sliders show {values}")
