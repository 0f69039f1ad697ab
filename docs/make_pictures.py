"""Make the README's pictures.

docs/alpha_ii.gif films the Alpha II view in a real JupyterLab; docs/lesson.png and docs/editor.png
are photographs from there: an answer with what is said to it, and a table that is typed. The others
show saved pages: a prediction and what came, the stages of a link, one solve by two methods, an arm
on its way along a line, an aircraft in a gimbal, and an arm on a telephone.

Run with: python docs/make_pictures.py (needs the `test` extra and Chromium).
"""
from __future__ import annotations

import io
import sys
import tempfile
from pathlib import Path

import nbformat
import numpy as np
from PIL import Image
from playwright.sync_api import Page

import kinlab as kl
from kinlab.drawing.paints import COLOURS, PAINTS

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tests" / "browser"))

from lab import Lab, open_and_run, open_browser, run_code, start_lab  # noqa: E402

# Poses in degrees; the film goes round them once and ends where it began.
POSES = np.array([[0, 0, 0, -90, 0], [40, -50, 50, -60, 0], [40, -50, 50, -60, 90],
                  [-30, -75, 60, -60, 90], [-30, -10, 30, -120, 0]])
STEPS, MILLISECONDS = 10, 80
CELL = "import kinlab as kl\nview = kl.ArmView(kl.robots.alpha_ii(), closed_form=True)\nview"
LESSON = ["import numpy as np\nimport kinlab as kl",
          "kl.lessons.start_here.two_ways_view()",
          "two_ways = np.radians([[50, -60], [50, 60]])\n"
          'kl.exercises.check("start_here.5", two_ways)']
EDITOR = ["import kinlab as kl\neditor = kl.DHTableEditor(kl.robots.cylindrical())\neditor"]


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        with open_browser() as browser:
            predict(browser.new_page(viewport={"width": 1180, "height": 860}), Path(folder))
            stages(browser.new_page(viewport={"width": 1180, "height": 860}), Path(folder))
            solve(browser.new_page(viewport={"width": 1280, "height": 860}), Path(folder))
            line(browser.new_page(viewport={"width": 1280, "height": 860}), Path(folder))
            gimbal(browser.new_page(viewport={"width": 1280, "height": 860}), Path(folder))
            phone(browser.new_page(viewport={"width": 390, "height": 844}, has_touch=True,
                                   device_scale_factor=1.5), Path(folder))
    film()


def predict(page: Page, folder: Path) -> None:
    """A mark that was set, the arm that went elsewhere, and the gap."""
    page.goto(kl.predict("intelledex.wrist").save_html(folder / "predict.html").as_uri())
    for letter, place in (("x", "450"), ("z", "150")):
        page.get_by_label(f"{letter} of your mark, number").fill(place)
        page.keyboard.press("Enter")
    page.get_by_role("button", name="Commit").click()
    page.wait_for_timeout(1500)
    page.locator(".kl-view").screenshot(path=ROOT / "docs" / "predict.png")


def stages(page: Page, folder: Path) -> None:
    """How a link comes by its frame: here the common normal."""
    view = kl.link_view(kl.robots.exam_2018(), 2, [-0.35, -0.6, 0.4])
    page.goto(view.save_html(folder / "stages.html").as_uri())
    page.get_by_role("button", name="Normal", exact=True).click()
    page.wait_for_timeout(1500)
    page.locator(".kl-view").screenshot(path=ROOT / "docs" / "stages.png")


def solve(page: Page, folder: Path) -> None:
    """Newton's method and the damped one, on the way from an almost stretched arm."""
    view = kl.solve_view(kl.robots.two_link(), [0.5, 1, 0], q0=[0.2, 0.1])
    view["step"].value = 5
    page.goto(view.save_html(folder / "solve.html").as_uri())
    page.locator(".kl-view").screenshot(path=ROOT / "docs" / "solve.png")


def line(page: Page, folder: Path) -> None:
    """A Panda along a line, faster than one of its joints can."""
    arm = kl.robots.panda()
    start = kl.forward_kinematics(arm, arm.home)
    aside = kl.homogeneous(start[:3, :3], start[:3, 3] + [0.2, 0.45, 0])
    view = kl.PathView(arm, kl.straight_path(arm, start, aside, 1), show=("names",))
    view.time = 0.7
    page.goto(view.save_html(folder / "path.html").as_uri())
    page.wait_for_timeout(1500)
    page.locator(".kl-view").screenshot(path=ROOT / "docs" / "path.png")


def gimbal(page: Page, folder: Path) -> None:
    """An aircraft in its rings, and the four descriptions of how it is turned."""
    view = kl.lessons.turns.gimbal_view()
    view.yaw, view.pitch, view.roll = -30, -60, 30
    page.goto(view.save_html(folder / "gimbal.html").as_uri())
    page.wait_for_timeout(1500)
    page.locator(".kl-view").screenshot(path=ROOT / "docs" / "gimbal.png")


def phone(page: Page, folder: Path) -> None:
    """One file, one arm, on a telephone."""
    view = kl.ArmView(kl.robots.intelledex_660t(), q=np.radians([110, -70, 60, 20, 60, 0]))
    page.goto(view.save_html(folder / "arm.html").as_uri())
    page.screenshot(path=ROOT / "docs" / "phone.png")


def film() -> None:
    """Photographs and a film from a JupyterLab."""
    notebooks = {"film": [CELL], "lesson": LESSON, "editor": EDITOR}
    with tempfile.TemporaryDirectory() as folder:
        for name, cells in notebooks.items():
            _write(Path(folder, f"{name}.ipynb"), cells)
        with start_lab(folder) as lab, open_browser() as browser:
            page = browser.new_page(viewport={"width": 1240, "height": 980})
            for name in ("lesson", "editor"):
                _open(page, lab, name)
                page.locator(".jp-Notebook:visible").screenshot(path=ROOT / "docs" / f"{name}.png")
            _open(page, lab, "film")
            page.get_by_role("button", name="Trace").click()
            _save([_shot(page, q) for q in _path()])


def _write(path: Path, cells: list[str]) -> None:
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3"}}
    code = [nbformat.v4.new_code_cell(cell) for cell in cells]
    nbformat.write(nbformat.v4.new_notebook(cells=code, metadata=kernel), path)


def _open(page: Page, lab: Lab, name: str) -> None:
    """Open a notebook alone in the window and run it."""
    open_and_run(page, lab, f"{name}.ipynb")
    page.evaluate("jupyterapp.commands.execute('application:toggle-left-area')")
    page.locator(".kl-picture svg").last.wait_for()
    page.wait_for_timeout(1500)


def _save(frames: list[Image.Image]) -> None:
    target = ROOT / "docs" / "alpha_ii.gif"
    palette = _with_swatches(frames[len(frames) // 2]).quantize(128)
    first, *rest = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    first.save(target, save_all=True, append_images=rest, duration=MILLISECONDS, loop=0,
               optimize=True)
    print(f"{target.name}: {len(frames)} pictures, {target.stat().st_size / 1000:.0f} kB")


def _with_swatches(picture: Image.Image) -> Image.Image:
    """The picture above the colours of small things that a palette would leave out."""
    colours = [colour for paints in COLOURS.values() for colour in paints[:2]]
    colours += [*PAINTS["iron"]["hub"], "#fbe8c4"]  # hubs, and entries that have just changed
    tall = Image.new("RGB", (picture.width, picture.height + 120))
    tall.paste(picture)
    side = picture.width // len(colours)
    for k, colour in enumerate(colours):
        tall.paste(colour, (k * side, picture.height, (k + 1) * side, tall.height))
    return tall


def _path() -> np.ndarray:
    """Poses of every picture: eased from each pose to the next, and round again."""
    t = np.linspace(0, 1, STEPS, endpoint=False)[:, None]
    ease = t**3 * (10 - 15 * t + 6 * t**2)
    return np.concatenate([a + ease * (b - a) for a, b in zip(POSES, np.roll(POSES, -1, axis=0))])


def _shot(page, q: np.ndarray) -> Image.Image:
    run_code(page, f"view.q = {np.radians(q).tolist()}")
    page.wait_for_timeout(60)
    picture = page.locator(".kl-view").screenshot()
    return Image.open(io.BytesIO(picture)).convert("RGB")


if __name__ == "__main__":
    main()
