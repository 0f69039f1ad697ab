"""Numbers as a URDF writes them: decimals with spaces between."""
from __future__ import annotations

import math
import re
from xml.etree.ElementTree import Element

import numpy as np

from ..arms import inputs
from ..arms.euler import rpy_matrix

_DECIMAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_PART_OF_PI = re.compile(r"([+-]?)([0-9]*\.?[0-9]*)\*?(?:pi|π)(?:/([1-9][0-9]*))?", re.IGNORECASE)
_LONGEST = 100  # signs in one number: nobody writes more
XACRO = ("this is xacro, from which URDF is made; convert it first, in ROS: "
         "xacro robot.urdf.xacro > robot.urdf")


def number(what: str, text: str) -> float:
    """One finite number, or a ValueError that says of which attribute."""
    word = text.strip()
    if "${" in word or "$(" in word:
        raise ValueError(f"{what}: expected a number, got {inputs.brief(text)}; {XACRO}")
    if len(word) > _LONGEST or not _DECIMAL.fullmatch(word):
        raise ValueError(f"{what}: expected a number, got {inputs.brief(text)}; {_advice(word)}")
    return inputs.number(what, float(word))


def _advice(word: str) -> str:
    """How to write what is no number; a part of pi is worked out."""
    if "," in word:
        return "write the decimal point as ."
    part = _PART_OF_PI.fullmatch(word) if len(word) <= _LONGEST else None
    if part is None or part[2] == ".":
        return "write it as 0.25"
    times, parts = float(part[2] or 1), float(part[3] or 1)
    return f"write {part[1].strip('+')}{times * math.pi / parts!r}"


def vector(what: str, element: Element | None, name: str, default: str) -> np.ndarray:
    """Three numbers of an attribute; the default where it, or its element, is left out."""
    text = default if element is None else element.get(name, default)
    words = text.split()
    if "," in text and "$" not in text:
        raise ValueError(f"{what}: expected three numbers in {name}, with spaces between them and "
                         f"no commas, got {inputs.brief(text)}; "
                         f'write {name}="{_without_commas(text) or default}"')
    if "$" not in text and len(words) != 3:
        raise ValueError(f"{what}: expected three numbers in {name}, got {inputs.brief(text)}; "
                         f'write {name}="{default}"')
    return np.array([number(f"{what}, {name}", word) for word in (words if len(words) == 3
                                                                  else [text])])


def _without_commas(text: str) -> str:
    """The three numbers that were meant where commas stand between them or in them; or ""."""
    if len(text) > _LONGEST:
        return ""
    for instead in " .":
        words = text.replace(",", instead).split()
        if len(words) == 3 and all(map(_DECIMAL.fullmatch, words)):
            return " ".join(words)
    return ""


def turns(what: str, element: Element | None) -> np.ndarray:
    """Roll, pitch and yaw of an <origin>, shape (3,)."""
    if element is not None and "quat_xyzw" in element.keys():
        raise ValueError(f"{what}: expected the turn as rpy, got quat_xyzw; "
                         "write it as roll, pitch and yaw, in radians")
    return vector(what, element, "rpy", "0 0 0")


def pose(what: str, element: Element | None) -> np.ndarray:
    """The matrix (4, 4) of an <origin>: moved by xyz, and turned by rpy about fixed axes."""
    T, rpy = np.eye(4), turns(what, element)
    inputs.in_radians(f"{what}, rpy", rpy)
    T[:3, 3] = vector(what, element, "xyz", "0 0 0")
    roll, pitch, yaw = map(_within_two_turns, rpy.tolist())
    T[:3, :3] = rpy_matrix(roll, pitch, yaw)
    return T


def _within_two_turns(angle: float) -> float:
    """The angle, or the same turn, of which `rpy_matrix` has nothing to say."""
    return angle if abs(angle) <= inputs.TWO_TURNS else math.remainder(angle, 2 * math.pi)


def axis(what: str, element: Element | None) -> np.ndarray:
    """The unit vector of an <axis>: x where there is none."""
    direction = vector(what, element, "xyz", "1 0 0")
    length = float(np.linalg.norm(direction))
    if not length > 1e-9:
        raise ValueError(f"{what}: expected an axis that points somewhere, got xyz=\"0 0 0\"; "
                         'write xyz="0 0 1" for z')
    return direction / length
