"""The arm: frozen data, checked once, in either Denavit-Hartenberg convention."""
from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import cached_property
from html import escape
from typing import Any

import numpy as np

from . import inputs
from .motions import ROTATE, TRANSLATE, Frame, Motion, X, Z, follow, matrix, motions_of

REVOLUTE, PRISMATIC = "revolute", "prismatic"

# A DH convention is only an order of the same four motions.
CONVENTIONS = {
    "standard": ((ROTATE, Z, "theta"), (TRANSLATE, Z, "d"), (TRANSLATE, X, "a"),
                 (ROTATE, X, "alpha")),
    "modified": ((ROTATE, X, "alpha"), (TRANSLATE, X, "a"), (ROTATE, Z, "theta"),
                 (TRANSLATE, Z, "d")),
}
_VARIABLE = {REVOLUTE: "theta", PRISMATIC: "d"}


@dataclass(frozen=True)
class Link:
    """One row of a DH table. Make it with `revolute` or `prismatic`."""

    kind: str
    theta: float = 0.0
    d: float = 0.0
    a: float = 0.0
    alpha: float = 0.0
    limits: tuple[float, float] | None = None
    name: str | None = None

    def __post_init__(self) -> None:
        inputs.choice("kind", self.kind, (REVOLUTE, PRISMATIC))
        for parameter in ("theta", "d", "a", "alpha"):
            value = inputs.number(parameter, getattr(self, parameter))
            object.__setattr__(self, parameter, value)
        if self.limits is not None:
            object.__setattr__(self, "limits", _limits(self.limits))
        if self.name is not None:
            inputs.line("name", self.name)

    @property
    def variable(self) -> str:
        """The parameter that the joint moves: 'theta' or 'd'."""
        return _VARIABLE[self.kind]


def revolute(*, theta: float = 0, d: float = 0, a: float = 0, alpha: float = 0,
             limits: tuple[float, float] | None = None, name: str | None = None) -> Link:
    """A link driven by a revolute joint: it turns about z by ``q + theta``.

    Parameters
    ----------
    theta : float
        Joint angle at q = 0, the joint's offset (rad).
    d : float
        Link offset along z (the arm's unit).
    a : float
        Link length along x (the arm's unit).
    alpha : float
        Link twist about x (rad).
    limits : (float, float), optional
        Smallest and largest q (rad).
    name : str, optional
        The joint's name on the arm, such as 'shoulder'.

    Returns
    -------
    Link

    Raises
    ------
    ValueError
        If a parameter is not a finite number or the limits are reversed.

    Examples
    --------
    >>> revolute(d=215, alpha=-math.pi / 2).kind
    'revolute'
    """
    return Link(REVOLUTE, theta, d, a, alpha, limits, name)


def prismatic(*, theta: float = 0, d: float = 0, a: float = 0, alpha: float = 0,
              limits: tuple[float, float] | None = None, name: str | None = None) -> Link:
    """A link driven by a prismatic joint: it slides along z by ``q + d``.

    Parameters are those of `revolute`; here `d` is the joint's offset and `limits` are lengths.

    Examples
    --------
    >>> prismatic(theta=math.pi / 2, limits=(0, 0.4)).limits
    (0.0, 0.4)
    """
    return Link(PRISMATIC, theta, d, a, alpha, limits, name)


@dataclass(frozen=True, eq=False)
class Arm:
    """A serial arm: one DH row per joint, with an optional base, tool and home.

    Parameters
    ----------
    links : sequence of Link
        From base to tool, each made with `revolute` or `prismatic`.
    convention : {"standard", "modified"}
        standard: A_i = Rz(theta) Tz(d) Tx(a) Rx(alpha) (Spong, Schilling).
        modified: A_i = Rx(alpha) Tx(a) Rz(theta) Tz(d) (Craig); row i then holds
        alpha_{i-1} and a_{i-1}.
    name, unit : str
        The arm's name, and the unit of all its lengths.
    base, tool : array, shape (4, 4), optional
        Pose of frame 0 in the room, and of the tool frame in frame n.
    home : sequence of n floats, optional
        Joint values (rad or length) at the arm's home; zeros if left out.

    Raises
    ------
    ValueError
        If there is no link, a matrix is not rigid, or home does not fit.

    Examples
    --------
    >>> arm = Arm([revolute(a=1), revolute(a=0.5)], name="Two links")
    >>> arm.n
    2
    """

    links: tuple[Link, ...]
    convention: str = field(default="standard", kw_only=True)
    name: str = field(default="", kw_only=True)
    unit: str = field(default="m", kw_only=True)
    base: np.ndarray | None = field(default=None, kw_only=True)
    tool: np.ndarray | None = field(default=None, kw_only=True)
    home: np.ndarray | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        object.__setattr__(self, "links", _links(self.links))
        inputs.choice("convention", self.convention, tuple(CONVENTIONS))
        inputs.line("name", self.name)
        inputs.line("unit", self.unit)
        for end in ("base", "tool"):
            object.__setattr__(self, end, _pose(end, getattr(self, end)))
        home = np.zeros(self.n) if self.home is None else self.home
        home = inputs.shaped("home", home, (self.n,), f"{self.n} joint values, one per joint")
        home.flags.writeable = False
        object.__setattr__(self, "home", home)

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.links)

    @cached_property
    def chain(self) -> tuple[tuple[Motion, ...], ...]:
        """The elementary motions of the base, of each link, and of the tool: n + 2 stretches."""
        links = (_link_motions(link, i, self.convention) for i, link in enumerate(self.links))
        return (motions_of(self.base), *links, motions_of(self.tool))

    def __repr__(self) -> str:
        rows = self.table()
        widths = [max(map(len, column)) for column in zip(*rows)]
        lines = ["  ".join(cell.rjust(w) for cell, w in zip(row, widths)) for row in rows]
        return "\n".join([f"{self._title()}", *lines])

    def _repr_html_(self) -> str:
        head, *rows = self.table()
        tag = lambda name, cells: "".join(f"<{name}>{cell}</{name}>" for cell in cells)  # noqa: E731
        body = "".join(f"<tr>{tag('td', row)}</tr>" for row in rows)
        return ('<table><caption style="text-align: left; white-space: nowrap">'
                f"{escape(self._title())}</caption><thead><tr>{tag('th', head)}</tr></thead>"
                f"<tbody>{body}</tbody></table>")

    def table(self) -> list[list[str]]:
        """The DH table as text: a header and one row per joint, in the convention's order."""
        shift = {"alpha": "α", "a": "a", "theta": "θ", "d": "d"}
        order = [parameter for _, _, parameter in CONVENTIONS[self.convention]]
        if self.convention == "modified":
            shift |= {"alpha": "α(i-1)", "a": "a(i-1)"}
            order = ["alpha", "a", "d", "theta"]
        head = ["i", *(shift[parameter] for parameter in order)]
        return [head] + [[str(i), *(_cell(link, parameter, i) for parameter in order)]
                         for i, link in enumerate(self.links, start=1)]

    def _title(self) -> str:
        name = f"{self.name}: " if self.name else ""
        return f"{name}{self.convention} DH, lengths in {self.unit}, * marks the joint variable"


def to_modified(arm: Arm) -> Arm:
    """The same arm in the modified (Craig) convention; its pose is unchanged for every q.

    Twist and length move one row down; those of the last row go into the tool.

    Examples
    --------
    >>> arm = Arm([revolute(a=2), revolute(a=1)])
    >>> [link.a for link in to_modified(arm).links]
    [0.0, 2.0]
    """
    _check_arm(arm)
    if arm.convention == "modified":
        return arm
    last = arm.links[-1]
    base, (a, alpha) = _split_x_screw(arm.base)
    pairs = [(a, alpha), *((link.a, link.alpha) for link in arm.links[:-1])]
    links = [replace(link, a=a, alpha=alpha) for link, (a, alpha) in zip(arm.links, pairs)]
    tool = _x_screw(last.a, last.alpha) @ arm.tool
    return replace(arm, links=links, convention="modified", base=base, tool=tool)


def to_standard(arm: Arm) -> Arm:
    """The same arm in the standard (Spong, Schilling) convention; its pose is unchanged.

    Twist and length move one row up; those of the first row go into the base.

    Examples
    --------
    >>> arm = Arm([revolute(), revolute(a=2)], convention="modified")
    >>> [link.a for link in to_standard(arm).links]
    [2.0, 0.0]
    """
    _check_arm(arm)
    if arm.convention == "standard":
        return arm
    first = arm.links[0]
    tool, (a, alpha) = _split_x_screw(arm.tool)
    pairs = [*((link.a, link.alpha) for link in arm.links[1:]), (a, alpha)]
    links = [replace(link, a=a, alpha=alpha) for link, (a, alpha) in zip(arm.links, pairs)]
    base = arm.base @ _x_screw(first.a, first.alpha)
    return replace(arm, links=links, convention="standard", base=base, tool=tool)


def _x_screw(a: float, alpha: float) -> np.ndarray:
    return matrix(follow([Motion(TRANSLATE, X, a), Motion(ROTATE, X, alpha)], (), Frame()))


def _split_x_screw(T: np.ndarray) -> tuple[np.ndarray, tuple[float, float]]:
    """Hand a matrix that is all Tx(a) Rx(alpha) to the table; leave any other where it is."""
    a, alpha = float(T[0, 3]), math.atan2(T[2, 1], T[1, 1])
    if np.allclose(T, _x_screw(a, alpha), rtol=0, atol=1e-12):
        return np.eye(4), (a, alpha)
    return T, (0.0, 0.0)


def _link_motions(link: Link, joint: int, convention: str) -> tuple[Motion, ...]:
    return tuple(Motion(kind, axis, getattr(link, parameter),
                        joint if parameter == link.variable else None)
                 for kind, axis, parameter in CONVENTIONS[convention])


def _limits(limits: Any) -> tuple[float, float]:
    low, high = inputs.shaped("limits", limits, (2,), "two numbers (lowest, highest)")
    if not low < high:
        raise ValueError(f"limits: expected lowest < highest, got ({low:g}, {high:g}); "
                         "swap them")
    return float(low), float(high)


def _links(links: Any) -> tuple[Link, ...]:
    try:
        rows = tuple(links)
    except TypeError:
        rows = ()
    if not rows or not all(isinstance(link, Link) for link in rows):
        raise ValueError("links: expected at least one link, "
                         f"got {inputs.brief(links)}; make them with revolute() and prismatic()")
    return rows


def _pose(end: str, T: Any) -> np.ndarray:
    T = np.eye(4) if T is None else inputs.rigid(end, T)
    T.flags.writeable = False
    return T


def _check_arm(arm: Any) -> None:
    if not isinstance(arm, Arm):
        raise ValueError(f"arm: expected a kinlab Arm, got {inputs.brief(arm)}; "
                         "build one with Arm([revolute(...), ...])")


def _cell(link: Link, parameter: str, i: int) -> str:
    value = getattr(link, parameter)
    angle = parameter in ("theta", "alpha")
    text = f"{math.degrees(value):.6g}°" if angle else f"{value:.6g}"
    if parameter != link.variable:
        return text.replace("-0°", "0°") if text in ("-0°",) else text
    variable = f"{'θ' if angle else 'd'}{i}*"
    return f"{variable} {'-' if value < 0 else '+'} {text.lstrip('-')}" if value else variable
