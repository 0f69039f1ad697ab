"""Appendix, the lectures' misprints: its exercises' references and typical slips."""
from __future__ import annotations

from math import cos, sin
from typing import Any

import numpy as np

from ..answers.conditions import degrees_slip, one_of_many
from ..answers.judges import Judge, choices, expressions
from ..arms import inputs


def _column(theta: float, d: float, a: float, alpha: float) -> list[float]:
    return [a * cos(theta), a * sin(theta), d]


_LINKS = [dict(theta=0.4, d=0.3, a=0.7, alpha=1.1), dict(theta=-1.2, d=-0.5, a=0.9, alpha=0.6),
          dict(theta=2.0, d=1.3, a=0.2, alpha=-0.8)]
_COLUMN_SLIPS = [
    ("The turn by alpha comes last and moves no origin: no alpha in this column.",
     lambda t, d, a, al: [a * cos(t), a * sin(t) * cos(al), d]),
    ("This is the printed entry; a lies along x after the turn by theta, so a sin(theta).",
     lambda t, d, a, al: [a * cos(t), a * cos(t) * sin(al), d]),
    ("Sine and cosine have changed places.", lambda t, d, a, al: [a * sin(t), a * cos(t), d]),
    ("This is the last column of the modified matrix.",
     lambda t, d, a, al: [a, -d * sin(al), d * cos(al)]),
    ("a and d have changed places.", lambda t, d, a, al: [d * cos(t), d * sin(t), a]),
]


def _four_twists(answer: Any) -> np.ndarray:
    return inputs.shaped("twists", answer, (4,), "four angles in radians")


def _none_zero(twists: np.ndarray) -> str:
    zero = np.flatnonzero(np.abs(np.sin(twists / 2)) < 1e-9)
    return f"alpha_{zero[0]} is zero, or a full turn." if len(zero) else ""


def _hidden(twists: np.ndarray) -> str:
    shown = np.flatnonzero(np.abs(np.diff(np.cos(twists))) > 1e-9)
    if not len(shown):
        return ""
    i = shown[0] + 1
    return (f"In link {i} the entry should be cos(alpha_{i - 1}) = {np.cos(twists[i - 1]):.3f}, "
            f"but the page prints cos(alpha_{i}) = {np.cos(twists[i]):.3f}.")


_TWIST_SLIPS = [
    degrees_slip(hint="write np.radians([...])"),
    ("Different twists can hide it, too, but their cosines must be equal.",
     lambda twists: len(np.unique(np.round(np.abs(twists), 9))) == 4),
]

JUDGES: dict[str, Judge] = {
    "errata.1": choices(
        {"wrong lines": {3, 4}}, {1, 2, 3, 4},
        {("wrong lines", 1): "Try both joints at zero, then at 90°.",
         ("wrong lines", 2): "Multiply the two rotations.",
         ("wrong lines", 3): "Multiply it by H and look at the last column.",
         ("wrong lines", 4): "Where is the origin after each?"},
        noun="line", praise="Two lines are right, and two fail a small test."),
    "errata.2": expressions(
        ("p_x", "p_y", "p_z"), _column, _LINKS, constants={}, slips=_COLUMN_SLIPS,
        praise="The last column holds no alpha."),
    "errata.3": one_of_many(
        _four_twists, (_none_zero, _hidden), slips=_TWIST_SLIPS,
        praise="Equal cosines hide the slip, in every pose. A test needs a case that can fail."),
}
