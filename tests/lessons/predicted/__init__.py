"""Right answers to the predictions of each lesson, computed or typed by hand, and wrong ones."""
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any


@dataclass
class Held:
    """What one case of a prediction is held against.

    `right` comes from numpy, from `forward_kinematics` or from a book, never from the case itself;
    `wrong` holds two answers or more, each with words of what is said to them.
    """

    right: Any
    wrong: Sequence[tuple[Any, str]]
