"""A DH table from text, as people have it."""
from __future__ import annotations

from dataclasses import dataclass

from .as_code import from_code
from .as_csv import from_csv
from .table import DHTable

_IMPORTS = ("import ", "from ")


@dataclass(frozen=True)
class Loaded:
    """A table that was read, and what was assumed on the way: "" or one line."""

    table: DHTable
    remark: str = ""


def read_table(text: str, like: DHTable, **choices: str) -> Loaded:
    """The table that a text describes; what it leaves open is as in the table `like`.

    Raises
    ------
    ValueError
        If the text is no table; an `Ambiguous` one if it may be read in more than one way.

    Examples
    --------
    >>> from .table import Row
    >>> read_table("theta,d,a,alpha\\n0,215,0,-90\\n", DHTable((Row(),))).table.rows[0].d
    '215'
    """
    code = isinstance(text, str) and ("Arm(" in text or text.lstrip().startswith(_IMPORTS))
    return Loaded(from_code(text).in_angles(like.angles) if code else from_csv(text))
