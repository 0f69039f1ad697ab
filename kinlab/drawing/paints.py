"""How each style is painted: one recipe for both hands, with SVG's names for its parts.

Each quantity has one colour, in pictures, formulas and numbers of all lessons. Widths and dashes
are in pixels of the picture. An open line is never filled.
"""
from __future__ import annotations

from typing import NamedTuple, TypedDict

INK, STEEL, FAINT = "#2b3138", "#7d8b99", "#d5dae0"
HOLDS = "#0f870f"  # of no quantity; what breaks a rule is dashed in the colour of a miss


class Colour(NamedTuple):
    """Of lines and of words on light paper, and of both on dark paper."""

    line: str
    words: str
    dark: str


# kinlab/browser/live.css says the same once more, as --kl-x, --kl-angle, ... Words are told from
# their paper by 4.5:1 at least. Colour is never the only cue: axes, angles and lengths carry
# names, angles are arcs and lengths are dimension lines, a target is a ring, what is missing to
# it is dashed, and so is the second of two curves.
COLOURS = {
    "x": Colour("#D55E00", "#B84F00", "#FF8A3D"),       # axes: those of Okabe and Ito
    "y": Colour("#009E73", "#007D5B", "#2FD0A0"),
    "z": Colour("#0072B2", "#0068A8", "#56B4E9"),
    "angle": Colour("#7A3E9D", "#7A3E9D", "#C79BE8"),
    "length": Colour("#8A5A00", "#8A5A00", "#D9B25F"),
    "point": Colour("#B0457F", "#B0457F", "#F08CC0"),   # a point, the tool's tip and its way
    "target": Colour("#A3123A", "#A3123A", "#FF7D97"),
    "first": Colour(INK, INK, "#E3E7EA"),               # of two curves
    "second": Colour("#5F6B00", "#5F6B00", "#B9C84A"),
    "pointed": Colour("#E69F00", INK, "#FFB935"),       # what is pointed at; words on it are ink
}

Paint = TypedDict("Paint", {"stroke": str, "stroke-width": float, "stroke-linejoin": str,
                            "fill": str, "stroke-dasharray": tuple[float, ...], "words": str,
                            "ramp": tuple[str, str, str], "hub": tuple[str, str, str],
                            "cap": bool, "faded": bool}, total=False)


def pen(stroke: str, width: float, *, fill: str = "", dash: tuple[float, ...] = ()) -> Paint:
    """A line with round corners, and what it holds."""
    paint: Paint = {"stroke": stroke, "stroke-width": width, "stroke-linejoin": "round"}
    if fill:
        paint["fill"] = fill
    if dash:
        paint["stroke-dasharray"] = dash
    return paint


def _quantity(name: str, width: float, *, filled: bool = True,
              dash: tuple[float, ...] = ()) -> Paint:
    """Lines, arrows and words in the colour of a quantity."""
    line, words, _ = COLOURS[name]
    paint = pen(line, width, fill=line if filled else "", dash=dash)
    paint["words"] = words
    return paint


def _solid(*ramp: str, hub: tuple[str, ...] = (), cap: bool = False) -> Paint:
    """Colours in the shade, between, and in the light; `hub` those of the disc on its ends."""
    paint = pen("#242c34", 0.9)
    paint["ramp"] = ramp  # type: ignore[typeddict-item]  # three of them
    if hub:
        paint["hub"] = hub  # type: ignore[typeddict-item]
    if cap:
        paint["cap"] = True
    return paint


_IRON, _HUB = ("#2e3945", "#576878", "#a5b4c2"), ("#2479ae", "#54b2e8", "#b4dffa")

PAINTS: dict[str, Paint] = {
    "steel": _solid("#6f7c89", "#b3bec9", "#f6f8fa"),         # links
    "iron": _solid(*_IRON, hub=_HUB, cap=True),               # joints that turn
    "sleeve": _solid(*_IRON, hub=_HUB),                       # joints that slide
    "base": _solid(*_IRON, cap=True),
    "grip": _solid("#333d47", "#63717e", "#adb9c5"),
    "amber": _solid("#a86400", "#e69f00", "#ffdd94"),         # a link that is pointed at
    "mesh": pen("#a9bccd", 1.0),
    "region": pen("none", 1.0, fill="#56b4e92e"),          # what is reached
    "cloud": pen("#3f7ca8", 2.8),
    "section": pen("#0b5c8f", 2, fill="#56b4e92e"),        # what is reached in a plane
    "hole": pen("#0b5c8f", 1.4, fill="#ffffff"),
    "ghost": pen(FAINT, 6),
    "axis": pen(INK, 1, dash=(6, 3, 1.5, 3)),
    "dashed": pen(STEEL, 1.4, dash=(5.6, 4.2)),
    "vector": pen(INK, 2, fill=INK),
    "ellipse": pen("#5b6770", 1.6, fill="#5b677030"),
    "arc": _quantity("angle", 1.6, filled=False),
    "tool": _quantity("point", 6, filled=False),              # a dot
    "trace": _quantity("point", 1.6, filled=False),
    "guess": pen(INK, 11),                                   # a dot that a student sets
    "miss": _quantity("target", 1.4, filled=False, dash=(5.6, 4.2)),
    "ink": {"fill": INK},
    **{axis: _quantity(axis, 1.8) for axis in "xyz"},
    **{f"{axis}-wide": _quantity(axis, 4) for axis in "xyz"},      # a multiple of an axis
    **{f"{axis}-leg": _quantity(axis, 1.4, filled=False, dash=(5.6, 4.2)) for axis in "xyz"},
    "cover": pen("#242c34", 1, fill="#8db4cf"),            # of a book, and what it holds
    "pages": pen("#242c34", 1, fill="#f3ecdb"),
    "print": pen("#242c34", 1, fill="#ffffff"),
    **{name: _quantity(name, 1.6) for name in ("angle", "length")},
    "limit": _quantity("angle", 1.6, filled=False, dash=(7, 4)),   # where a joint's angle ends
    "holds": pen(HOLDS, 2.6) | {"words": HOLDS},              # a rule that is kept
    "point": _quantity("point", 2),
    "target": _quantity("target", 2.2),
    "first": _quantity("first", 2),
    "second": _quantity("second", 2, dash=(10, 4)),
    # More curves than two: each ink with another dash.
    **{f"{ink}-solid": _quantity(ink, 2) for ink in ("second",)},
    **{f"{ink}-dash": _quantity(ink, 2, dash=(10, 4)) for ink in ("first", "angle")},
    **{f"{ink}-dots": _quantity(ink, 2, dash=(1.5, 4.5)) for ink in ("first", "second", "angle")},
    "coming": pen("#eccbdc", 4.5),  # a way as a whole, pale under what is gone of it
}
# Solids that step back behind what is drawn over them.
FAR = [style for style, paint in PAINTS.items() if "ramp" in paint]
PAINTS.update({f"{style}-far": PAINTS[style] | {"faded": True} for style in FAR})
