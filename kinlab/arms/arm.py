"""The arm: frozen data, checked once, in either Denavit-Hartenberg convention."""
from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from html import escape
from itertools import accumulate
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import inputs, printed
from .link import FIXED, REVOLUTE, Link
from .motions import ROTATE, TRANSLATE, Frame, Motion, X, Z, follow, matrix, motions_of
from .route import Route

# A DH convention is only an order of the same four motions.
CONVENTIONS = {
    "standard": ((ROTATE, Z, "theta"), (TRANSLATE, Z, "d"), (TRANSLATE, X, "a"),
                 (ROTATE, X, "alpha")),
    "modified": ((ROTATE, X, "alpha"), (TRANSLATE, X, "a"), (ROTATE, Z, "theta"),
                 (TRANSLATE, Z, "d")),
}


@inputs.lasting
@dataclass(frozen=True, eq=False, init=False)
class Arm:
    """A serial arm: one DH row per joint, with an optional base, tool and home.

    Parameters
    ----------
    links : sequence of Link
        From base to tool, each made with `revolute`, `prismatic` or `fixed`. A fixed row has a
        frame of its own, and no joint: q has one value for each of the others.
    convention : {"standard", "modified"}
        standard: A_i = Rz(theta) Tz(d) Tx(a) Rx(alpha) (Spong, Schilling).
        modified: A_i = Rx(alpha) Tx(a) Rz(theta) Tz(d) (Craig); row i then holds
        alpha_{i-1} and a_{i-1}.
    name, unit : str
        The arm's name, and the unit of all its lengths.
    base, tool : array, shape (4, 4), optional
        Pose of frame 0 in the room, and of the tool frame in frame n.
    home : sequence of n floats, optional
        Joint values (rad or length) at the arm's home. If left out: zeros, and for a locked
        joint the value at which it is locked.

    Raises
    ------
    ValueError
        If there is no joint, a matrix is not rigid, or home does not fit.

    Examples
    --------
    >>> from kinlab import revolute
    >>> arm = Arm([revolute(a=1), revolute(a=0.5)], name="Two links")
    >>> arm.n
    2
    """

    links: tuple[Link, ...]
    convention: str
    name: str
    unit: str
    base: np.ndarray
    tool: np.ndarray
    home: np.ndarray

    def __init__(self, links: Iterable[Link], *, convention: str = "standard", name: str = "",
                 unit: str = "m", base: ArrayLike | None = None, tool: ArrayLike | None = None,
                 home: ArrayLike | None = None) -> None:
        rows = _links(links)
        values = {"links": rows,
                  "convention": inputs.choice("convention", convention, tuple(CONVENTIONS)),
                  "name": inputs.line("name", name), "unit": inputs.line("unit", unit),
                  "base": _pose("base", base), "tool": _pose("tool", tool),
                  "home": _home(home, _moving(rows))}
        for field, value in values.items():
            object.__setattr__(self, field, value)

    @property
    def n(self) -> int:
        """Number of joints: of values in q."""
        return len(self.joints)

    @cached_property
    def joints(self) -> tuple[Link, ...]:
        """The rows that a joint moves, one for each value in q; `links` has the fixed ones too."""
        return _moving(self.links)

    @cached_property
    def rows(self) -> tuple[int, ...]:
        """The number of each joint's row, from 0: its place in `links`."""
        return tuple(k for k, link in enumerate(self.links) if link.kind != FIXED)

    @cached_property
    def chain(self) -> tuple[tuple[Motion, ...], ...]:
        """The elementary motions of the base, of each row, and of the tool."""
        joints = accumulate((int(link.kind != FIXED) for link in self.links), initial=0)
        links = (_link_motions(link, i, self.convention) for link, i in zip(self.links, joints))
        return (motions_of(self.base), *links, motions_of(self.tool))

    @cached_property
    def route(self) -> Route:
        """The chain, ready for single poses in plain floats."""
        return Route.along(self.chain)

    def __repr__(self) -> str:
        return "\n".join([self._title(), *printed.lines(self.table())])

    def _repr_html_(self) -> str:
        return printed.html(self.table(), '<table><caption style="text-align: left; '
                            f'white-space: nowrap">{escape(self._title())}</caption>')

    def table(self) -> list[list[str]]:
        """The DH table as text: a header and one row per joint, in the convention's order."""
        return printed.number_rows(self.links, self.convention)

    def _title(self) -> str:
        return printed.title(self.name, self.convention, self.unit)


def to_modified(arm: Arm) -> Arm:
    """The same arm in the modified (Craig) convention; its pose is unchanged for every q.

    Twist and length move one row down; those of the last row go into the tool.

    Examples
    --------
    >>> from kinlab import revolute
    >>> arm = Arm([revolute(a=2), revolute(a=1)])
    >>> [link.a for link in to_modified(arm).links]
    [0.0, 2.0]
    """
    check_arm(arm)
    if arm.convention == "modified":
        return arm
    last = arm.links[-1]
    base, (a, alpha) = _split_x_screw(arm.base)
    pairs = [(a, alpha), *((link.a, link.alpha) for link in arm.links[:-1])]
    links = tuple(replace(link, a=a, alpha=alpha) for link, (a, alpha) in zip(arm.links, pairs))
    tool = _x_screw(last.a, last.alpha) @ arm.tool
    return replace(arm, links=links, convention="modified", base=base, tool=tool)


def to_standard(arm: Arm) -> Arm:
    """The same arm in the standard (Spong, Schilling) convention; its pose is unchanged.

    Twist and length move one row up; those of the first row go into the base.

    Examples
    --------
    >>> from kinlab import revolute
    >>> arm = Arm([revolute(), revolute(a=2)], convention="modified")
    >>> [link.a for link in to_standard(arm).links]
    [2.0, 0.0]
    """
    check_arm(arm)
    if arm.convention == "standard":
        return arm
    first = arm.links[0]
    tool, (a, alpha) = _split_x_screw(arm.tool)
    pairs = [*((link.a, link.alpha) for link in arm.links[1:]), (a, alpha)]
    links = tuple(replace(link, a=a, alpha=alpha) for link, (a, alpha) in zip(arm.links, pairs))
    base = arm.base @ _x_screw(first.a, first.alpha)
    return replace(arm, links=links, convention="standard", base=base, tool=tool)


def row_of(T: np.ndarray) -> dict[str, float]:
    """The four numbers of a matrix (4, 4) that one row of a standard table makes.

    Examples
    --------
    >>> T = np.eye(4)
    >>> T[:3, 3] = 1, 0, 2
    >>> row_of(T)
    {'theta': 0.0, 'd': 2.0, 'a': 1.0, 'alpha': 0.0}
    """
    theta = math.atan2(T[1, 0], T[0, 0])
    return {"theta": theta, "d": float(T[2, 3]),
            "a": float(T[0, 3] * math.cos(theta) + T[1, 3] * math.sin(theta)),
            "alpha": math.atan2(T[2, 1], T[2, 2])}


def _x_screw(a: float, alpha: float) -> np.ndarray:
    return matrix(follow([Motion(TRANSLATE, X, a), Motion(ROTATE, X, alpha)], (), Frame()))


def _split_x_screw(T: np.ndarray) -> tuple[np.ndarray, tuple[float, float]]:
    """Hand a matrix that is all Tx(a) Rx(alpha) to the table; leave any other where it is."""
    a, alpha = float(T[0, 3]), math.atan2(T[2, 1], T[1, 1])
    if np.allclose(T, _x_screw(a, alpha), rtol=0, atol=1e-12):
        return np.eye(4), (a, alpha)
    return T, (0.0, 0.0)


def _link_motions(link: Link, joint: int, convention: str) -> tuple[Motion, ...]:
    sign = -1 if link.flip else 1
    return tuple(Motion(kind, axis, getattr(link, parameter), joint, sign)
                 if parameter == link.variable else Motion(kind, axis, getattr(link, parameter))
                 for kind, axis, parameter in CONVENTIONS[convention])


def _links(links: Any) -> tuple[Link, ...]:
    try:
        rows = tuple(links)
    except TypeError:
        rows = ()
    if not rows:
        raise ValueError("links: expected at least one link, "
                         f"got {inputs.brief(links)}; make them with revolute() and prismatic()")
    for i, row in enumerate(rows, start=1):
        if not isinstance(row, Link):
            raise ValueError(f"links: expected links, got {inputs.brief(row)} as row {i}; name its "
                             "numbers: revolute(theta=0, d=0.1, a=0, alpha=np.radians(90))")
    if not _moving(rows):
        raise ValueError("links: expected at least one joint, got only fixed rows; "
                         "make one with revolute() or prismatic()")
    return rows


def _moving(rows: Iterable[Link]) -> tuple[Link, ...]:
    return tuple(link for link in rows if link.kind != FIXED)


def _pose(end: str, T: Any) -> np.ndarray:
    T = np.eye(4) if T is None else inputs.rigid(end, T)
    T.flags.writeable = False
    return T


def _home(q: Any, joints: tuple[Link, ...]) -> np.ndarray:
    n, locks = len(joints), [link.lock or 0.0 for link in joints]
    home = inputs.shaped("home", locks if q is None else q, (n,),
                         f"{n} joint values, one per joint")
    inputs.in_radians("home", home[[link.kind == REVOLUTE for link in joints]])
    home.flags.writeable = False
    return home


def check_arm(arm: Any) -> None:
    if not isinstance(arm, Arm):
        raise ValueError(f"arm: expected a kinlab Arm, got {inputs.brief(arm)}; "
                         "build one with Arm([revolute(...), ...])")
