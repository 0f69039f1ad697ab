"""What each lesson needs of its own, a module each: views, predictions, judges of exercises.

A module has a dictionary JUDGES, from names such as "alpha_ii.1" to judges made by `answers`, and
a dictionary PREDICTIONS, from names such as "rotation.riding" to what is asked (`Asked`). Of some
there is one in `varied/`, with exercises whose numbers may be others.
"""
from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from ..answers.judges import Judge
from ..answers.prediction import Asked
from ..answers.varied import Varied
from . import varied


def names() -> tuple[str, ...]:
    """The lessons that have a module here."""
    return tuple(module.name for module in iter_modules(__path__) if not module.ispkg)


def judges(lesson: str) -> dict[str, Judge]:
    """The judges of one lesson's exercises, by name."""
    return getattr(import_module(f"{__name__}.{lesson}"), "JUDGES", {})


def predictions(lesson: str) -> dict[str, Asked]:
    """What one lesson asks before something moves, by name."""
    return getattr(import_module(f"{__name__}.{lesson}"), "PREDICTIONS", {})


def exercises() -> tuple[str, ...]:
    """The names of all exercises there are."""
    return tuple(name for lesson in names() for name in judges(lesson))


def predictions_asked() -> tuple[str, ...]:
    """The names of all predictions there are."""
    return tuple(name for lesson in names() for name in predictions(lesson))


def variants() -> dict[str, Varied]:
    """The exercises with other numbers, by name."""
    modules = (module.name for module in iter_modules(varied.__path__, f"{varied.__name__}."))
    return {name: one for module in modules for name, one in import_module(module).VARIED.items()}


def __getattr__(name: str) -> Any:
    """Load a lesson's module where it is first used."""
    if name not in names():
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return import_module(f"{__name__}.{name}")
