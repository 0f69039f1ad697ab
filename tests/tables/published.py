"""A DH table as somebody published it, and what it means: data for test_published.py."""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

Numbers = tuple[float, float, float, float]


@dataclass(frozen=True)
class Published:
    """A table typed anew in its source's own layout, and its meaning typed by hand.

    Attributes
    ----------
    name : str
        The arm, and whose table it is if there are several: the test's id.
    source : str
        Where it was published: an address, a DOI, a manual with its section.
    text : str
        As the source lays it out: its headings, its order of columns, its blanks and dashes.
    rows : tuple of (theta, d, a, alpha)
        In this order whatever the text's. The cell of a joint variable holds the offset alone.
    angles : {"deg", "rad"}
        The unit of the angles in `rows`; the text may have another.
    unit : str
        The unit of all lengths. Where the text does not say one it is "m", the editor's own.
    convention : {"standard", "modified"}
        What the source means, by its heads, or by its words if `choices` has it.
    kinds : str
        A letter for each row: R revolute, P prismatic, F fixed. All revolute if left out.
    flips : tuple of int
        The rows, from 1, whose joint counts the other way.
    lengths : {name: number}
        Named lengths of the editor that the text is pasted into, in its unit: metres.
    choices : {name: word}
        What the reader is told besides the text, since the source says it elsewhere.
    asks : bool
        Whether the reader must ask for these choices before it takes the text.
    marked : tuple of (row, column)
        Cells that name an angle whose value the source says elsewhere: they are kept and marked.
        The numbers of `rows` do not count there.
    poses : tuple of (joint values, (x, y, z))
        Where the tool is, after the source, its drawing or the arm's known reach: joint values in
        degrees or the table's unit. A second witness of the whole table.
    within : float
        How exactly the poses are known, in the table's unit.
    """

    name: str
    source: str
    text: str
    rows: tuple[Numbers, ...]
    angles: str = "deg"
    unit: str = "m"
    convention: str = "standard"
    kinds: str = ""
    flips: tuple[int, ...] = ()
    lengths: Mapping[str, float] = field(default_factory=dict)
    choices: Mapping[str, str] = field(default_factory=dict)
    asks: bool = False
    marked: tuple[tuple[int, str], ...] = ()
    poses: tuple[tuple[tuple[float, ...], tuple[float, float, float]], ...] = ()
    within: float = 1e-9


# The KUKA KR 210 of a course, of which many students published their own table: six joints, then a
# fixed gripper, 0.35 + 1.5 + 0.303 in front of the base and 0.75 + 1.25 - 0.054 above it.
KR210: tuple[Numbers, ...] = (
    (0, 0.75, 0, 0), (-90, 0, 0.35, -90), (0, 0, 1.25, 0), (0, 1.5, -0.054, -90), (0, 0, 0, 90),
    (0, 0, 0, -90), (0, 0.303, 0, 0))
KR210_AT_ZERO = (((0, 0, 0, 0, 0, 0), (2.153, 0, 1.946)),)
