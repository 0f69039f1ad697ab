"""Make the README's pictures.

docs/alpha_ii.gif films the Alpha II view in a real JupyterLab. The others show saved pages: one
solve by two methods, and an arm on a telephone.

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

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tests" / "browser"))

from lab import open_and_run, open_browser, run_code, start_lab  # noqa: E402

# Poses in degrees; the film goes round them once and ends where it began.
POSES = np.array([[0, 0, 0, -90, 0], [40, -50, 50, -60, 0], [40, -50, 50, -60, 90],
                  [-30, -75, 60, -60, 90], [-30, -10, 30, -120, 0]])
STEPS, MILLISECONDS = 14, 60
CELL = "import kinlab as kl\nview = kl.ArmView(kl.robots.alpha_ii(), closed_form=True)\nview"


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        with open_browser() as browser:
            solve(browser.new_page(viewport={"width": 900, "height": 760}), Path(folder))
            phone(browser.new_page(viewport={"width": 390, "height": 844}, has_touch=True,
                                   device_scale_factor=1.5), Path(folder))
    film()


def solve(page: Page, folder: Path) -> None:
    """Newton's method and the damped one, on the way from an almost stretched arm."""
    view = kl.solve_view(kl.robots.two_link(), [0.5, 1, 0], q0=[0.2, 0.1])
    view["step"].value = 5
    page.goto(view.save_html(folder / "solve.html").as_uri())
    page.locator(".kl-view").screenshot(path=ROOT / "docs" / "solve.png")


def phone(page: Page, folder: Path) -> None:
    """One file, one arm, on a telephone."""
    view = kl.ArmView(kl.robots.intelledex_660t(), q=np.radians([110, -70, 60, 20, 60, 0]))
    page.goto(view.save_html(folder / "arm.html").as_uri())
    page.screenshot(path=ROOT / "docs" / "phone.png")


def film() -> None:
    with tempfile.TemporaryDirectory() as folder:
        notebook = nbformat.v4.new_notebook(
            cells=[nbformat.v4.new_code_cell(CELL)],
            metadata={"kernelspec": {"name": "python3", "display_name": "Python 3"}})
        nbformat.write(notebook, Path(folder, "film.ipynb"))
        with start_lab(folder) as lab, open_browser() as browser:
            page = browser.new_page(viewport={"width": 1240, "height": 900})
            open_and_run(page, lab, "film.ipynb")
            page.evaluate("jupyterapp.commands.execute('application:toggle-left-area')")
            page.get_by_role("button", name="Trace").click()
            frames = [_shot(page, q) for q in _path()]
    target = ROOT / "docs" / "alpha_ii.gif"
    palette = frames[len(frames) // 2].quantize(96)
    first, *rest = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    first.save(target, save_all=True, append_images=rest, duration=MILLISECONDS, loop=0,
               optimize=True)
    print(f"{target.name}: {len(frames)} pictures, {target.stat().st_size / 1000:.0f} kB")


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
