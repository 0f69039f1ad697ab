"""A link: one row of a DH table, with the joint that drives it, if one does."""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from . import inputs

REVOLUTE, PRISMATIC, FIXED = "revolute", "prismatic", "fixed"
KINDS = (REVOLUTE, PRISMATIC, FIXED)
PARAMETERS = ("theta", "d", "a", "alpha")
_FOR_SYMBOLS = "give a number, and kl.closed_form(arm, symbols=...) writes symbols for it"
_VARIABLE = {REVOLUTE: "theta", PRISMATIC: "d", FIXED: None}


@inputs.lasting
@dataclass(frozen=True)
class Link:
    """One row of a DH table. Make it with `revolute`, `prismatic` or `fixed`."""

    kind: str
    theta: float = 0.0
    d: float = 0.0
    a: float = 0.0
    alpha: float = 0.0
    limits: tuple[float, float] | None = None
    name: str | None = None
    flip: bool = False
    speed: float | None = None
    acceleration: float | None = None

    def __post_init__(self) -> None:
        inputs.choice("kind", self.kind, KINDS)
        for parameter in PARAMETERS:
            value = inputs.number(parameter, getattr(self, parameter), _FOR_SYMBOLS)
            object.__setattr__(self, parameter, value)
        if self.limits is not None:
            object.__setattr__(self, "limits", _limits(self.limits))
        if self.name is not None:
            inputs.line("name", self.name)
        object.__setattr__(self, "flip", inputs.yes_or_no("flip", self.flip))
        for rate in ("speed", "acceleration"):
            if (most := getattr(self, rate)) is not None:
                object.__setattr__(self, rate, inputs.positive(rate, most))
        if self.kind == FIXED and (self.flip or self.limits):
            raise ValueError("limits, flip: a fixed row has no joint; leave them out")

    @property
    def variable(self) -> str | None:
        """The parameter that the joint moves: 'theta' or 'd'; None for a fixed row."""
        return variable_of(self.kind)

    @property
    def lock(self) -> float | None:
        """Where the joint is locked, its limits being one value; None for one that moves."""
        return self.limits[0] if self.limits and self.limits[0] == self.limits[1] else None


def revolute(*positional: Any, theta: float = 0, d: float = 0, a: float = 0, alpha: float = 0,
             limits: tuple[float, float] | None = None, name: str | None = None,
             flip: bool = False, speed: float | None = None,
             acceleration: float | None = None) -> Link:
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
        Smallest and largest q (rad). Two equal values lock the joint there.
    name : str, optional
        The joint's name on the arm, such as 'shoulder'.
    flip : bool
        True for a joint that counts the other way: it turns by ``-q + theta``.
    speed : float, optional
        Largest rate of q either way (rad/s), where one is known: paths are held against it.
    acceleration : float, optional
        Largest rate of that rate either way (rad/s^2).

    Returns
    -------
    Link

    Raises
    ------
    ValueError
        If a parameter is not a finite number, the limits are reversed, or a speed or an
        acceleration is not positive.
    TypeError
        If numbers are given without their names.

    Examples
    --------
    >>> from math import pi
    >>> revolute(d=215, alpha=-pi / 2).kind
    'revolute'
    """
    _refuse_unnamed(REVOLUTE, positional)
    return _in_radians(Link(REVOLUTE, theta, d, a, alpha, limits, name, flip, speed, acceleration))


def prismatic(*positional: Any, theta: float = 0, d: float = 0, a: float = 0, alpha: float = 0,
              limits: tuple[float, float] | None = None, name: str | None = None,
              flip: bool = False, speed: float | None = None,
              acceleration: float | None = None) -> Link:
    """A link driven by a prismatic joint: it slides along z by ``q + d``.

    Parameters are those of `revolute`; here `d` is the joint's offset, and `limits`, `speed` and
    `acceleration` are lengths, also per second and per second squared.

    Examples
    --------
    >>> from math import pi
    >>> prismatic(theta=pi / 2, limits=(0, 0.4)).limits
    (0.0, 0.4)
    """
    _refuse_unnamed(PRISMATIC, positional)
    return _in_radians(Link(PRISMATIC, theta, d, a, alpha, limits, name, flip, speed, acceleration))


def fixed(*positional: Any, theta: float = 0, d: float = 0, a: float = 0, alpha: float = 0,
          name: str | None = None) -> Link:
    """A row of the table without a joint: a flange, a bend in a link, a gripper.

    Parameters are those of `revolute`. The row has a frame of its own and no value in q.

    Examples
    --------
    >>> fixed(d=0.303, name="gripper").variable is None
    True
    """
    _refuse_unnamed(FIXED, positional)
    return _in_radians(Link(FIXED, theta, d, a, alpha, name=name))


def variable_of(kind: str) -> str | None:
    """The parameter that a joint of this kind moves; None for a fixed row."""
    return _VARIABLE[kind]


def with_numbers(link: Link, **numbers: float) -> Link:
    """The row with some of theta, d, a and alpha replaced."""
    return replace(link, **numbers)  # type: ignore[arg-type]  # mypy sees no names in a **dict


def _refuse_unnamed(kind: str, positional: tuple) -> None:
    if positional:
        raise TypeError(f"{kind}: expected numbers with their names, got "
                        f"{', '.join(map(inputs.brief, positional))}; write {kind}(theta=..., "
                        "d=..., a=..., alpha=...)")


def _in_radians(link: Link) -> Link:
    """The link, with a word where its angles look like degrees."""
    for name in ("theta", "alpha"):
        inputs.in_radians(name, getattr(link, name))
    if link.kind == REVOLUTE and link.limits:
        inputs.in_radians("limits", link.limits)
    return link


def _limits(limits: Any) -> tuple[float, float]:
    low, high = inputs.shaped("limits", limits, (2,), "two numbers (lowest, highest)")
    if not low <= high:
        raise ValueError(f"limits: expected lowest < highest, got ({low:g}, {high:g}); "
                         "swap them")
    return float(low), float(high)
