"""Where a file may be written, checked before anything is made for it."""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from . import inputs


def target(name: str, value: Any, endings: tuple[str, ...], why: str) -> Path:
    """The path of a file to be written, whose name ends as its kind does.

    `why` says what the ending is for. ValueError for what is no name, has another ending, or lies
    in a folder that is not there.
    """
    if not isinstance(value, str | os.PathLike) or not isinstance(os.fspath(value), str):
        raise ValueError(f"{name}: expected the name of a file such as 'arm{endings[0]}', "
                         f"got {inputs.brief(value)}")
    path = Path(value)
    if path.suffix.lower() not in endings:
        raise ValueError(f"{name}: expected a name that ends in {endings[0]}, got {str(path)!r}; "
                         f"{why}")
    if not path.parent.is_dir():
        raise ValueError(f"{name}: there is no folder {str(path.parent)!r}; make it first, or "
                         "choose another")
    return path


def write(name: str, path: Path, data: bytes) -> Path:
    """Write a file, replacing one of this name; ValueError where that cannot be."""
    try:
        path.write_bytes(data)
    except (OSError, ValueError) as error:  # ValueError: a name with a zero byte
        reason = getattr(error, "strerror", None) or error
        raise ValueError(f"{name}: cannot write {str(path)!r} ({reason}); choose a folder of "
                         "your own, or another name") from None
    return path
