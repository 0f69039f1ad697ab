"""A real JupyterLab in a real Chromium, for the browser tests and the benchmarks.

    with start_lab(root) as lab, open_browser() as browser:
        page = browser.new_page()
        open_and_run(page, lab, "lesson.ipynb")
        page.get_by_role("slider").first.press("ArrowRight")
"""
from __future__ import annotations

import json
import os
import secrets
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from urllib.error import HTTPError, URLError
from urllib.request import urlopen

from playwright.sync_api import Browser, Page, Playwright, sync_playwright

CHROMIUM_ARGS = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                 "--disable-background-networking", "--disable-component-update",
                 "--disable-sync"]
START_SECONDS = 180
# What kinlab adds to JupyterLab itself.
EXTENSION = Path(__file__).parents[2] / "kinlab" / "browser" / "labextension"

# Without these JupyterLab asks, over the page, whether it may fetch news and updates.
QUIET = {"@jupyterlab/apputils-extension/notification.jupyterlab-settings":
         {"fetchNews": "false", "checkForUpdates": False}}

# The circling moons over the page while JupyterLab starts or changes its theme.
SPLASH = "#jupyterlab-splash"

# What the notebook in front holds: its model, as it would be saved.
NOTEBOOK = "jupyterapp.shell.currentWidget.content.model.toJSON()"

KERNEL = {"name": "python3", "display_name": "Python 3", "language": "python"}
# Whether the notebook of a path is in front, and its kernel waits.
READY = """path => {
    const front = window.jupyterapp?.shell.currentWidget;
    return front?.context?.path === path && front.sessionContext.session?.kernel?.status === 'idle';
}"""


@dataclass(frozen=True)
class Lab:
    """A running server: its address, its secret word and its log."""

    url: str
    token: str
    log: Path

    def page_url(self, notebook: str) -> str:
        """Address that opens a notebook, by its path below the root, in a fresh workspace."""
        return f"{self.url}/lab/tree/{notebook}?reset&token={self.token}"


@contextmanager
def start_lab(root: Path | str, python: Path | str = sys.executable,
              app: str = "jupyterlab") -> Iterator[Lab]:
    """A JupyterLab server that shows `root`, untouched by the user's own settings.

    `python` is whose packages it uses, `app` the module it runs: "notebook" is Notebook 7, and
    "voila" shows the only notebook in `root`.
    """
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as home:
        port, token = _free_port(), secrets.token_hex(16)
        lab = Lab(f"http://127.0.0.1:{port}", token, Path(home, "server.log"))
        command = [str(python), "-m", app, "--no-browser", *_options(app, port, token, root)]
        with lab.log.open("wb") as log:
            server = subprocess.Popen(command, stdout=log, stderr=log, env=_private(Path(home)))
        try:
            _wait(server, lab)
            yield lab
        finally:
            _stop(server)


_room, _users = ExitStack(), []


@contextmanager
def _playwright() -> Iterator[Playwright]:
    """Playwright, which runs once in a thread: browsers that are open together share it."""
    _users.append(_users[0] if _users else _room.enter_context(sync_playwright()))
    try:
        yield _users[0]
    finally:
        _users.pop()
        if not _users:
            _room.close()


@contextmanager
def open_browser(*args: str) -> Iterator[Browser]:
    """Headless Chromium: the system's, or Playwright's own where there is none."""
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    with _playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium,
                                             args=[*CHROMIUM_ARGS, *args])
        try:
            yield browser
        finally:
            browser.close()


def open_notebook(page: Page, lab: Lab, notebook: str) -> None:
    """Open a notebook and wait until its kernel is ready."""
    page.goto(lab.page_url(notebook))
    page.wait_for_function(
        "window.jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel"
        "?.status === 'idle'", timeout=1000 * START_SECONDS)
    page.wait_for_selector(SPLASH, state="detached")


def run_all(page: Page, seconds: float = 180) -> None:
    """Run all cells of the notebook in front; AssertionError if one of them fails."""
    page.evaluate("""() => {
        window.allRan = false;
        jupyterapp.commands.execute('notebook:run-all-cells').then(() => window.allRan = true);
    }""")
    page.wait_for_function("window.allRan", timeout=1000 * seconds)
    failed = errors(page)
    assert not failed, f"cells failed: {failed}"


def open_and_run(page: Page, lab: Lab, notebook: str, seconds: float = 180) -> None:
    """Open a notebook and run all of its cells."""
    open_notebook(page, lab, notebook)
    run_all(page, seconds)


def errors(page: Page) -> list[str]:
    """The errors that stand in the notebook's outputs."""
    return page.evaluate(f"""() => {NOTEBOOK}.cells.flatMap(cell => cell.outputs ?? [])
        .filter(output => output.output_type === 'error')
        .map(output => output.ename + ': ' + output.evalue)""")


def set_theme(page: Page, theme: str) -> None:
    """Change to 'JupyterLab Light' or 'JupyterLab Dark'."""
    page.evaluate("theme => jupyterapp.commands.execute('apputils:change-theme', {theme})", theme)
    light = str("Light" in theme).lower()
    page.wait_for_selector(f"body[data-jp-theme-light='{light}']", state="attached")
    page.wait_for_selector(SPLASH, state="detached")


def run_code(page: Page, code: str) -> str:
    """Run code in the kernel of the notebook in front, beside its cells; what it prints."""
    return page.evaluate("""async code => {
        const kernel = jupyterapp.shell.currentWidget.sessionContext.session.kernel;
        const request = kernel.requestExecute({code, store_history: false});
        let printed = '';
        request.onIOPub = ({content}) => {
            printed += content.text ?? '';
            if (content.ename) throw new Error(content.ename + ': ' + content.evalue);
        };
        await request.done;
        return printed;
    }""", code)


def shut_down_kernels(page: Page) -> None:
    """End all kernels of the server, so that the next notebook has the machine to itself."""
    page.evaluate("jupyterapp.serviceManager.sessions.shutdownAll()")


def _private(home: Path) -> dict[str, str]:
    """Environment of a server that reads and writes its settings in `home` only."""
    for name, settings in QUIET.items():
        path = home / "config" / "lab" / "user-settings" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(settings))
    own = home / "data" / "labextensions" / "kinlab"  # where an installed kinlab has it, or near
    shutil.copytree(EXTENSION, own, dirs_exist_ok=True)
    places = {"JUPYTER_CONFIG_DIR": "config", "JUPYTER_DATA_DIR": "data",
              "JUPYTER_RUNTIME_DIR": "runtime", "IPYTHONDIR": "ipython"}
    return os.environ | {name: str(home / place) for name, place in places.items()}


def _options(app: str, port: int, token: str, root: Path | str) -> list[str]:
    if app == "voila":                              # shows the one notebook that is in the folder
        (notebook,) = Path(root).resolve().glob("*.ipynb")
        return [str(notebook), f"--port={port}", f"--token={token}"]
    return ["--allow-root", "--expose-app-in-browser",
            f"--ServerApp.root_dir={Path(root).resolve()}", f"--ServerApp.port={port}",
            "--ServerApp.port_retries=0", f"--IdentityProvider.token={token}"]


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def _wait(server: subprocess.Popen, lab: Lab) -> None:
    end = time.monotonic() + START_SECONDS
    while time.monotonic() < end and server.poll() is None:
        try:
            with urlopen(f"{lab.url}/api?token={lab.token}", timeout=5):
                return
        except HTTPError:                           # Voila has no such address, but it answers
            return
        except (URLError, OSError):
            time.sleep(0.1)
    raise RuntimeError(f"The server did not start:\n{lab.log.read_text()}")


def _stop(server: subprocess.Popen) -> None:
    """Ask the server to end, with its kernels; make it if it does not."""
    server.terminate()
    try:
        server.wait(15)
    except subprocess.TimeoutExpired:
        server.kill()
        server.wait()
