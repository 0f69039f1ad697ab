"""The course as a JupyterLite site: notebooks that run in a browser, with no server behind them.

JupyterLab and Python run in the student's browser. What kinlab needs there is packed into wheels
from what is installed here, so that a site is built without a network; the browser loads them
before the first cell runs. Python itself (Pyodide) comes from its public address, or from a folder
that becomes a part of the site.
"""
from __future__ import annotations

import base64
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable, Iterator
from importlib.metadata import Distribution, distribution
from pathlib import Path
from typing import Any

import nbformat

from ..browser import bundle
from . import doors
from .handout import FOLDER, all_notebooks, writing

_HERE = Path(__file__).parent
_KERNEL = "@jupyterlite/pyodide-kernel-extension"
_PICTURES = _HERE.parent / "browser" / "labextension"
# The front ends of the widgets and the kernel, and who brings them. Others that are installed here
# are none of the course's.
_EXTENSIONS = {"anywidget": "anywidget", "@jupyter-widgets/jupyterlab-manager":
               "jupyterlab_widgets", _KERNEL: "jupyterlite_pyodide_kernel"}
# What Pyodide has, and what is packed here. All of it is there before the first cell.
_FROM_PYODIDE = ("ipython", "jedi", "matplotlib", "micropip", "numpy", "pillow", "sqlite3", "ssl")
_PACKED = ("anywidget", "comm", "ipywidgets", "jinja2", "latex2mathml", "markupsafe", "mpmath",
           "psygnal", "rjsmin", "sympy", "tqdm", "typing_extensions")
# From the kernel's script, which loads them, to the folder of the site.
_UP = "../" * (len(Path(_KERNEL).parts) + 2)
# JupyterLab's settings: dark where the system is; cells that are out of sight keep their views; a
# button for a fresh copy.
_OVERRIDES = {
    "@jupyterlab/apputils-extension:themes": {"adaptive-theme": True},
    "@jupyterlab/notebook-extension:tracker": {"windowingMode": "none"},
    "@jupyterlab/notebook-extension:panel": {"toolbar": [
        {"name": "fresh-copy", "command": "kinlab:fresh-copy", "rank": 40}]},
    "@jupyterlab/apputils-extension:notification": {"fetchNews": "false",
                                                    "checkForUpdates": False}}
# Parts of sympy that it does not load by itself: not worth their size, compiled.
_RARE = tuple(f"sympy/{part}/" for part in (
    "categories", "codegen", "combinatorics", "crypto", "diffgeom", "holonomic", "liealgebras",
    "parsing/autolev", "physics", "stats", "unify", "vector"))
_BROWSERS = (3, 12)  # Python, in that Pyodide
PYODIDE = "0.27."  # the versions that the kernel knows


def build(folder: Path, pyodide: Path | None = None,
          tell: Callable[[str], Any] = lambda line: None) -> None:
    """Write the site into a folder, beside the pages of `site.build` if they are there.

    Parameters
    ----------
    folder : path
    pyodide : path, optional
        A folder with Pyodide, which is copied; without it, browsers load Pyodide from its
        public address.
    tell : callable, optional
        Takes one line of text for each step.

    Raises
    ------
    ValueError
        If `pyodide` is not such a folder, or `folder` cannot be made or written to.
    """
    if pyodide:
        _check_pyodide(pyodide)
    with writing("OUT", folder):
        folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        work, made = Path(name), Path(name) / "made"
        tell(f"Packing kinlab and the {len(_PACKED)} packages that it needs")
        python = _compiler()
        if not python:
            tell("  (with Python {}.{} on the path the site would start faster)".format(*_BROWSERS))
        wheels = _pack(work / "wheels", python)
        tell(f"Building JupyterLite with {len(all_notebooks())} notebooks")
        editions = _write_lessons(work / "files")
        _write_settings(work, wheels, pyodide is not None)
        _run_jupyterlite(work, wheels, made)
        _add_script(made / "lab", editions)
        for icons in made.glob("build/fa-*"):
            if icons.suffix in (".eot", ".svg", ".ttf"):  # browsers that run Python take others
                icons.unlink()
        with writing("OUT", folder):
            _move_in(made, folder)
            doors.say_so(folder)
    if pyodide:
        tell("Copying Pyodide")
        with writing("OUT", folder):
            shutil.copytree(pyodide, folder / "static" / "pyodide", dirs_exist_ok=True)
    tell(f"Done: put {folder} on any web server; the lessons are at {doors.LAB}")


def _check_pyodide(folder: Path) -> None:
    """ValueError if it is not a Pyodide of the right version with all that the course needs."""
    lock = folder / "pyodide-lock.json"
    try:
        held = json.loads(lock.read_text(encoding="utf-8"))
        version, packages = held["info"]["version"], held["packages"]
    except (OSError, ValueError, KeyError, TypeError):
        raise ValueError(f"--pyodide: {str(folder)!r} holds no readable pyodide-lock.json; name a "
                         "folder with an unpacked Pyodide") from None
    if not version.startswith(PYODIDE):
        raise ValueError(f"--pyodide: {str(folder)!r} holds Pyodide {version}; the site needs "
                         f"{PYODIDE}x")
    missing = [name for name in ("pyodide.js", "pyodide.asm.wasm") if not (folder / name).is_file()]
    missing += [name for name in _FROM_PYODIDE if name not in packages
                or not (folder / packages[name]["file_name"]).is_file()]
    if missing:
        raise ValueError(f"--pyodide: {str(folder)!r} lacks {', '.join(missing)}; name a folder "
                         "with a whole Pyodide")


# ---- The packages --------------------------------------------------------------------------------


def _pack(folder: Path, python: str | None) -> list[Path]:
    folder.mkdir()
    made = []
    for name in ("kinlab", *_PACKED):
        installed = distribution(name)
        files = dict(_own() if name == "kinlab" else _pure(installed))
        made.append(_wheel(installed, _compiled(files, python) if python else files, folder))
    return made


def _own() -> Iterator[tuple[str, bytes]]:
    """The files of kinlab, but for those that make the course."""
    package = _HERE.parent
    for path in sorted(package.rglob("*")):
        name = path.relative_to(package)
        if path.is_file() and name.parts[0] != "course" and "__pycache__" not in name.parts:
            yield f"kinlab/{name.as_posix()}", path.read_bytes()


def _pure(installed: Distribution) -> Iterator[tuple[str, bytes]]:
    """The files of an installed package, but for its tests and its compiled doubles."""
    for file in installed.files or ():
        if not (file.parts[0] == ".." or file.parts[0].endswith(".dist-info")
                or file.suffix in (".pyc", ".so", ".pyd")
                or {"tests", "benchmarks"} & {*file.parts}):
            yield file.as_posix(), Path(str(installed.locate_file(file))).read_bytes()


def _wheel(installed: Distribution, files: dict[str, bytes], folder: Path) -> Path:
    """A package as a wheel for every machine."""
    name = f"{installed.name.replace('-', '_').lower()}-{installed.version}"
    path, about = folder / f"{name}-py3-none-any.whl", f"{name}.dist-info"
    metadata = installed.read_text("METADATA") or installed.read_text("PKG-INFO") or ""
    files |= {f"{about}/METADATA": metadata.encode(),
              f"{about}/WHEEL": b"Wheel-Version: 1.0\nGenerator: kinlab\n"
                                b"Root-Is-Purelib: true\nTag: py3-none-any\n"}
    record = "".join(f"{file},{_digest(data)},{len(data)}\n" for file, data in files.items())
    files[f"{about}/RECORD"] = f"{record}{about}/RECORD,,\n".encode()
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as wheel:
        for file, data in files.items():
            wheel.writestr(file, data)
    return path


def _compiler() -> str | None:
    """A Python whose compiled files the browser's Python reads, if there is one here."""
    if sys.version_info[:2] == _BROWSERS:
        return sys.executable
    found = shutil.which("python{}.{}".format(*_BROWSERS))
    works = found and not subprocess.run([found, "--version"], capture_output=True).returncode
    return found if works else None


def _compiled(files: dict[str, bytes], python: str) -> dict[str, bytes]:
    """The files, and beside each module what Python would make of it at its first import."""
    with tempfile.TemporaryDirectory() as name:
        for file, data in files.items():
            if file.startswith(_RARE):
                continue
            path = Path(name, file)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
        # Not every file of a library is meant for every Python; what cannot be compiled stays.
        subprocess.run([python, "-m", "compileall", "-q", "-s", name, "-j", "0",
                        "--invalidation-mode", "unchecked-hash", name],
                       capture_output=True, env=os.environ | {"PYTHONPATH": ""})
        made = Path(name).rglob("__pycache__/*.pyc")
        return files | {path.relative_to(name).as_posix(): path.read_bytes() for path in made}


def _digest(data: bytes) -> str:
    return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")


# ---- The notebooks and the settings --------------------------------------------------------------


def _write_lessons(folder: Path) -> dict[str, str]:
    """The notebooks for the browser's kernel; each says which edition of the lesson it is."""
    editions = {}
    for path in all_notebooks():
        notebook, name = nbformat.read(path, as_version=4), path.relative_to(FOLDER)
        target, editions[name.as_posix()] = folder / name, edition(notebook)
        notebook.metadata = nbformat.from_dict({
            "kernelspec": {"display_name": "Python (Pyodide)", "language": "python",
                           "name": "python"},
            "language_info": {"name": "python"},
            "kinlab": {"edition": editions[name.as_posix()]}})
        target.parent.mkdir(parents=True, exist_ok=True)
        nbformat.write(notebook, target)
    return editions


def edition(notebook: nbformat.NotebookNode) -> str:
    """A name for what stands in a notebook; outputs count for nothing."""
    sources = json.dumps([cell.source for cell in notebook.cells])
    return hashlib.sha256(sources.encode()).hexdigest()[:12]


def _write_settings(work: Path, wheels: list[Path], own_pyodide: bool) -> None:
    kernel: dict[str, Any] = {
        "loadPyodideOptions": {"packages": [
            *_FROM_PYODIDE, *(f"{_UP}pypi/{wheel.name}" for wheel in wheels)]}}
    if own_pyodide:
        kernel |= {"pyodideUrl": "./static/pyodide/pyodide.js", "disablePyPIFallback": True}
    settings = {"jupyter-lite-schema-version": 0, "jupyter-config-data": {
        "appName": "kinlab", "exposeAppInBrowser": True,
        "litePluginSettings": {f"{_KERNEL}:kernel": kernel}}}
    (work / "jupyter-lite.json").write_text(json.dumps(settings), encoding="utf-8")
    (work / "overrides.json").write_text(json.dumps(_OVERRIDES), encoding="utf-8")


def _add_script(lab: Path, editions: dict[str, str]) -> None:
    """The part of JupyterLab's page that knows of lessons."""
    (lab / "kinlab.js").write_text(bundle.script("host_lite.js"), encoding="utf-8")
    page = lab / "index.html"
    known = json.dumps(editions).replace("<", r"\u003c")
    added = (f'<script type="application/json" id="kinlab-editions">{known}</script>'
             '<script src="kinlab.js" defer></script></head>')
    page.write_text(page.read_text(encoding="utf-8").replace("</head>", added, 1),
                    encoding="utf-8")


def _run_jupyterlite(work: Path, wheels: list[Path], made: Path) -> None:
    config = {"LiteBuildConfig": {
        "lite_dir": str(work), "output_dir": str(made), "apps": ["lab"],
        "contents": [str(work / "files")], "ignore_sys_prefix": True, "no_sourcemaps": True,
        "no_unused_shared_packages": True,
        "federated_extensions": [str(_PICTURES), *(str(_extension(name, owner))
                                                   for name, owner in _EXTENSIONS.items())]},
        "PipliteAddon": {"piplite_urls": [str(wheel) for wheel in wheels]}}
    (work / "jupyter_lite_config.json").write_text(json.dumps(config), encoding="utf-8")
    ran = subprocess.run([sys.executable, "-m", "jupyterlite_core", "build"], cwd=work,
                         capture_output=True, text=True)
    if ran.returncode:
        raise RuntimeError(f"JupyterLite could not be built:\n{ran.stdout}{ran.stderr}")


def _extension(name: str, owner: str) -> Path:
    """The folder of a front end, wherever the package that brings it was installed."""
    installed = distribution(owner)
    (found,) = (file for file in installed.files or ()
                if file.as_posix().endswith(f"/labextensions/{name}/package.json"))
    return Path(str(installed.locate_file(found))).resolve().parent


def _move_in(made: Path, folder: Path) -> None:
    """What was made takes the place of an older build; a site's own front page stays."""
    for part in made.iterdir():
        target = folder / part.name
        if part.name == "index.html" and doors.has_pages(folder):
            continue
        if target.is_dir():
            shutil.rmtree(target)
        shutil.move(part, target)
