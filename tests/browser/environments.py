"""Environments of their own for the hosts in which a view must move: made once, then used again."""
from __future__ import annotations

import os
import subprocess
import sys
import tomllib
import venv
from hashlib import sha256
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PLACE = ROOT / "build" / "hosts"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
NEEDED = PROJECT["dependencies"]


def oldest(requirements: list[str]) -> list[str]:
    """The same requirements, each at the oldest release that it allows."""
    return [line.replace(">=", "==") for line in requirements]


def python_with(*packages: str) -> Path:
    """The Python of an environment that has these packages; kinlab itself is the one in use here.

    Where it cannot be made the test skips, or fails if KINLAB_REQUIRE_BROWSER is 1.
    """
    home = PLACE / sha256("\n".join([sys.version, *packages]).encode()).hexdigest()[:12]
    python = home / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    done = home / "packages.txt"
    if not done.exists():
        venv.create(home, with_pip=True, clear=True)
        made = subprocess.run([python, "-m", "pip", "install", "--quiet", *packages],
                              capture_output=True, text=True)
        if made.returncode:
            stop = pytest.fail if os.environ.get("KINLAB_REQUIRE_BROWSER") == "1" else pytest.skip
            stop(f"cannot install {', '.join(packages)}: {made.stderr.strip()[-400:]}")
        done.write_text("\n".join(packages), encoding="utf-8")
    return python


def version(python: Path | str, package: str) -> str:
    """The release of a package in an environment."""
    code = f"from importlib.metadata import version; print(version({package!r}))"
    return subprocess.run([python, "-c", code], capture_output=True, text=True,
                          check=True).stdout.strip()
