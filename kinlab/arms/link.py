"""A link: one row of a DH table, with the joint that drives it."""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from . import inputs

REVOLUTE, PRISMATIC = "revolute", "prismatic"
PARAMETERS = ("theta", "d", "a", "alpha")
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
        for parameter in PARAMETERS:
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
    >>> from math import pi
    >>> revolute(d=215, alpha=-pi / 2).kind
    'revolute'
    """
    return Link(REVOLUTE, theta, d, a, alpha, limits, name)


def prismatic(*, theta: float = 0, d: float = 0, a: float = 0, alpha: float = 0,
              limits: tuple[float, float] | None = None, name: str | None = None) -> Link:
    """A link driven by a prismatic joint: it slides along z by ``q + d``.

    Parameters are those of `revolute`; here `d` is the joint's offset and `limits` are lengths.

    Examples
    --------
    >>> from math import pi
    >>> prismatic(theta=pi / 2, limits=(0, 0.4)).limits
    (0.0, 0.4)
    """
    return Link(PRISMATIC, theta, d, a, alpha, limits, name)


def with_numbers(link: Link, **numbers: float) -> Link:
    """The row with some of theta, d, a and alpha replaced."""
    return replace(link, **numbers)  # type: ignore[arg-type]  # mypy sees no names in a **dict


def _limits(limits: Any) -> tuple[float, float]:
    low, high = inputs.shaped("limits", limits, (2,), "two numbers (lowest, highest)")
    if not low < high:
        raise ValueError(f"limits: expected lowest < highest, got ({low:g}, {high:g}); "
                         "swap them")
    return float(low), float(high)
