"""Numbers as a URDF writes them: decimals with spaces between."""
from __future__ import annotations

import re
from xml.etree.ElementTree import Element

import numpy as np

from ..arms import inputs
from ..arms.euler import rpy_matrix

_DECIMAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_LONGEST = 100  # signs in one number: nobody writes more
XACRO = ("this is xacro, from which URDF is made; convert it first, in ROS: "
         "xacro robot.urdf.xacro > robot.urdf")


def number(what: str, text: str) -> float:
    """One finite number, or a ValueError that says of which attribute."""
    word = text.strip()
    if "${" in word or "$(" in word:
        raise ValueError(f"{what}: expected a number, got {inputs.brief(text)}; {XACRO}")
    if len(word) > _LONGEST or not _DECIMAL.fullmatch(word):
        point = "; write the decimal point as ." if "," in word else "; write it as 0.25"
        raise ValueError(f"{what}: expected a number, got {inputs.brief(text)}{point}")
    return inputs.number(what, float(word))


def vector(what: str, element: Element | None, name: str, default: str) -> np.ndarray:
    """Three numbers of an attribute; the default where it, or its element, is left out."""
    text = default if element is None else element.get(name, default)
    words = text.split()
    if "$" not in text and len(words) != 3:
        raise ValueError(f"{what}: expected three numbers in {name}, got {inputs.brief(text)}; "
                         f'write {name}="{default}"')
    return np.array([number(f"{what}, {name}", word) for word in (words if len(words) == 3
                                                                  else [text])])


def pose(what: str, element: Element | None) -> np.ndarray:
    """The matrix (4, 4) of an <origin>: moved by xyz, and turned by rpy about fixed axes."""
    T = np.eye(4)
    T[:3, 3] = vector(what, element, "xyz", "0 0 0")
    T[:3, :3] = rpy_matrix(*vector(what, element, "rpy", "0 0 0").tolist())
    return T


def axis(what: str, element: Element | None) -> np.ndarray:
    """The unit vector of an <axis>: x where there is none."""
    direction = vector(what, element, "xyz", "1 0 0")
    length = float(np.linalg.norm(direction))
    if not length > 1e-9:
        raise ValueError(f"{what}: expected an axis that points somewhere, got xyz=\"0 0 0\"; "
                         'write xyz="0 0 1" for z')
    return direction / length
