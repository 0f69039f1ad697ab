"""Read what a live view draws, and say where it should stand by formulas typed here.

Nothing here goes through kinlab/drawing/figure.py or kinlab/browser/picture.js: only the arm's
frames and an orthographic projection; of Python's framing only the scale is taken.
"""
from __future__ import annotations

import ast
import time
from contextlib import contextmanager
from functools import cache

import numpy as np
from lab import run_code
from playwright.sync_api import Locator, Page, expect

import kinlab as kl
from kinlab.drawing.arm_scene import arm_scene
from kinlab.drawing.camera import Camera
from kinlab.drawing.still import _Still

PIXELS = 0.16  # a path has one decimal
READ = """view => {
    const svg = view.querySelector('.kl-picture svg'), text = node => node.textContent;
    const named = [...svg.querySelectorAll('g[id]')].filter(g => g.firstElementChild);
    const of = (tag, take) => Object.fromEntries(named
        .filter(g => g.firstElementChild.tagName === tag)
        .map(g => [g.id, take(g.firstElementChild)]));
    return {
        paths: of('path', node => node.getAttribute('d')),
        arrows: Object.fromEntries([...svg.querySelectorAll('path.kl-hint')]
            .map(path => [path.id, path.getAttribute('d') ?? ''])),
        size: [svg.viewBox.baseVal.width, svg.viewBox.baseVal.height],
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


def at_rest(look: str) -> str:
    """JavaScript that gives what `look` sees of a node, once it has been the same for 20 frames."""
    return f"""node => new Promise(done => {{
        let last = '', same = 0;
        const look = () => {{
            const now = ({look})(node);
            same = now.join() === last ? same + 1 : 0;
            last = now.join();
            if (same === 20) done(now);
            else requestAnimationFrame(look);
        }};
        look();
    }})"""


# Where all views of a page are, once they stay there: JupyterLab lays cells out anew as they come
# into sight.
RESTED = at_rest("""() => [...document.querySelectorAll('.kl-view')].map(view => {
    const { x, y, width, height } = view.getBoundingClientRect();
    return [x, y, width, height].join(' ');
})""")


# Each picture comes so many ms after the last one, by the page's own clock.
STEADY = """ms => {
    const [ask, clock] = [requestAnimationFrame, performance.now];
    let now = performance.now();
    window.requestAnimationFrame = draw => ask(() => draw(now += ms));
    performance.now = () => now;
    window.unsteady = () => {
        window.requestAnimationFrame = ask;
        performance.now = clock;
    };
}"""


@contextmanager
def steady(page: Page, ms: float = 8):
    """Within it, a movement has as many pictures as on any machine."""
    page.evaluate(STEADY, ms)
    try:
        yield
    finally:
        page.evaluate("unsteady()")


@cache
def scene_of(robot):
    return arm_scene(robot())


def settle(page: Page) -> None:
    """Wait until what was asked for has been painted."""
    page.evaluate(SETTLE)


def middle(locator: Locator) -> tuple[float, float]:
    """The middle of an element in the window (px)."""
    box = locator.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def take(handle: Locator) -> tuple[float, float]:
    """Press on the middle of a slider once the page rests, and say where that is (px)."""
    page = handle.page
    handle.scroll_into_view_if_needed()
    page.evaluate(RESTED)
    handle.hover()
    page.mouse.down()
    expect(handle).to_be_focused()  # what was pressed is the slider
    settle(page)  # its own step is a picture, too
    return middle(handle)


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
    """Frames and tool stand where the arm's kinematics puts them, seen from this camera.

    Where the picture's middle is and how large the arm is drawn is the framing's business: one
    place and one scale must fit all frames, and the scale must be the one that Python finds.
    """
    arm = robot()
    frames = dict(zip(map(str, range(arm.n + 1)), kl.link_frames(arm, q)))
    tool = kl.forward_kinematics(arm, q)
    if "frame-E-x" in seen["paths"]:
        frames["E"] = tool
    drawn = {name: [numbers(seen["arrows"][f"frame-{name}-{letter}-hint"])[[0, 3]]
                    for letter in "xyz"] for name in frames}
    right, up = _screen(*camera[:2])
    flat = np.array([[right @ T[:3, 3], -up @ T[:3, 3]] for T in frames.values()]
                    + [[right @ tool[:3, 3], -up @ tool[:3, 3]]])
    marked = np.array([axes[0][0] for axes in drawn.values()] + [numbers(seen["paths"]["tool"])[1]])
    scale, place = _fitted(flat, marked)
    assert np.abs(scale * flat + place - marked).max() < PIXELS, (scale * flat + place - marked)
    assert abs(scale / _scale(robot, q, camera, seen["size"]) - 1) < 2e-3
    for name, T in frames.items():
        for k, (tail, tip) in enumerate(drawn[name]):
            way, axis = tip - tail, np.array([right @ T[:3, k], -up @ T[:3, k]])
            assert np.abs(tail - drawn[name][0][0]).max() < PIXELS
            assert abs(way[0] * axis[1] - way[1] * axis[0]) < PIXELS, (name, k)
            assert way @ axis >= -PIXELS
            assert np.linalg.norm(way) > 15 * np.linalg.norm(axis) - PIXELS, (name, k)


def _screen(azimuth, elevation):
    """The directions to the right and up on the picture, in the room."""
    a, e = np.radians([azimuth, elevation])
    return (np.array([-np.sin(a), np.cos(a), 0]),
            np.array([-np.sin(e) * np.cos(a), -np.sin(e) * np.sin(a), np.cos(e)]))


def _fitted(flat, marked):
    """The scale and the place that bring points onto marks best."""
    off, to = flat - flat.mean(axis=0), marked - marked.mean(axis=0)
    scale = float((off * to).sum() / (off * off).sum())
    return scale, marked.mean(axis=0) - scale * flat.mean(axis=0)


def _scale(robot, q, camera, size):
    scene = scene_of(robot)
    shown = _Still(scene, q, scene.seen_from, scene.shown, tuple(size))
    return shown.framed(Camera(*camera)).scale


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
    """Wait until Python's joint values are those of the sliders, rounded, and rest; those values.

    Python hears of a move every tenth of a second: near its end it is within the rounding, too.
    """
    rounding = np.where([link.kind == "revolute" for link in robot().links], 0.051, 0.0051)
    end, before = time.monotonic() + 60, np.array([])
    while time.monotonic() < end:
        q = kernel_q(page, name)
        near = np.abs(in_units(robot, q)[:len(values)] - values) < rounding[:len(values)]
        if np.all(near) and np.array_equal(q, before):
            return q
        before = q
        page.wait_for_timeout(150)
    raise AssertionError(f"Python has {in_units(robot, q)}, the sliders show {values}")
