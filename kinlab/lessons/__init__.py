"""What each lesson needs of its own, a module each: views, predictions, judges of exercises.

A module has a dictionary JUDGES, from names such as "alpha_ii.1" to judges made by `answers`, and
a dictionary PREDICTIONS, from names such as "rotation.riding" to what is asked (`Asked`).
"""
from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from ..answers.judges import Judge
from ..answers.prediction import Asked


def names() -> tuple[str, ...]:
    """The lessons that have a module here."""
    return tuple(module.name for module in iter_modules(__path__) if not module.ispkg)


def judges(lesson: str) -> dict[str, Judge]:
    """The judges of one lesson's exercises, by name."""
    return getattr(import_module(f"{__name__}.{lesson}"), "JUDGES", {})


def predictions(lesson: str) -> dict[str, Asked]:
    """What one lesson asks before something moves, by name."""
    return getattr(import_module(f"{__name__}.{lesson}"), "PREDICTIONS", {})


def __getattr__(name: str) -> Any:
    """Load a lesson's module where it is first used."""
    if name not in names():
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return import_module(f"{__name__}.{name}")
