"""The arm that is handed over to be judged: by itself, or as the view or the table that has it.

While a cell of a table is red, its editor shows the arm of the last table that could be read. That
arm is marked here, so that no check takes it for the arm of the table.
"""
from __future__ import annotations

from typing import Any
from weakref import WeakKeyDictionary

from ..arms.arm import Arm
from ..arms.link import revolute
from .verdict import NOT_YET, Verdict

_RED: WeakKeyDictionary[Arm, str] = WeakKeyDictionary()


def marked(arm: Arm, reason: str) -> Arm:
    """The same arm, marked with why its table cannot be read, or with "" as one that can be."""
    if reason:
        _RED[arm] = reason
    else:
        _RED.pop(arm, None)
    return arm


def arm_in(answer: Any) -> Any:
    """The arm of a view, of an editor or of its table; anything else as it is.

    Examples
    --------
    >>> from kinlab import DHTableEditor
    >>> arm_in(DHTableEditor()).n
    2
    """
    if isinstance(answer, Arm):
        return answer
    arm, errors = (getattr(answer, name, None) for name in ("arm", "errors"))
    if arm is None and isinstance(errors, dict) and errors:
        return marked(Arm([revolute()]), next(iter(errors.values())))
    return arm if isinstance(arm, Arm) else answer


def red_cell(arm: Any) -> Verdict | None:
    """What there is to say of the arm of a table with a cell that cannot be read, or None."""
    reason = _RED.get(arm, "") if isinstance(arm, Arm) else ""
    return Verdict(NOT_YET, f"A cell is red; the table cannot be judged. {reason}.") \
        if reason else None
