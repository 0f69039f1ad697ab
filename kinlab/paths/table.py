"""A path as a table: one line for each sample, for a spreadsheet or a robot's controller."""
from __future__ import annotations

import csv
import io
from collections.abc import Sequence

import numpy as np

from ..arms.arm import Arm
from ..arms.link import REVOLUTE

_PER = ("", "/s", "/s^2")


def headings(arm: Arm) -> list[str]:
    """What stands over the columns: names with their units.

    Examples
    --------
    >>> from ..arms.link import prismatic, revolute
    >>> headings(Arm([revolute(), prismatic()], unit="mm"))[:4]
    ['t (s)', 'theta_1 (rad)', 'd_2 (mm)', 'theta_1 rate (rad/s)']
    """
    joints = [(f"theta_{i}", "rad") if link.kind == REVOLUTE else (f"d_{i}", arm.unit)
              for i, link in enumerate(arm.joints, start=1)]
    whats = ("", " rate", " acceleration")
    return ["t (s)", *(f"{name}{what} ({unit}{per})" for what, per in zip(whats, _PER)
                       for name, unit in joints), *(f"{axis} ({arm.unit})" for axis in "xyz")]


def as_csv(arm: Arm, t: np.ndarray, series: Sequence[np.ndarray]) -> str:
    """Times, then the columns of each of the series, shape (m, k), as CSV."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(headings(arm))
    for row in np.column_stack([t, *series]).tolist():
        writer.writerow([f"{value + 0.0:.10g}" for value in row])  # no -0
    return text.getvalue()
