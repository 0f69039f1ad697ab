"""How each style is painted: one recipe for both hands, with SVG's names for its parts.

Widths and dashes are in pixels of the picture. An open line is never filled.
"""
from __future__ import annotations

from typing import TypedDict

# Okabe-Ito colours; axes are also labelled, so colour is never the only cue.
INK, STEEL, PALE, FAINT = "#2b3138", "#7d8b99", "#dfe6ee", "#d5dae0"
AXIS_COLOURS = {"x": "#D55E00", "y": "#009E73", "z": "#0072B2"}

Paint = TypedDict("Paint", {"stroke": str, "stroke-width": float, "stroke-linejoin": str,
                            "fill": str, "stroke-dasharray": tuple[float, ...],
                            "ramp": tuple[str, str, str], "hub": tuple[str, str, str],
                            "cap": bool}, total=False)


def _paint(stroke: str, width: float, *, fill: str = "", join: str = "round",
           dash: tuple[float, ...] = ()) -> Paint:
    paint: Paint = {"stroke": stroke, "stroke-width": width, "stroke-linejoin": join}
    if fill:
        paint["fill"] = fill
    if dash:
        paint["stroke-dasharray"] = dash
    return paint


def _solid(*ramp: str, hub: tuple[str, ...] = (), cap: bool = False) -> Paint:
    """Colours in the shade, between, and in the light; `hub` those of the disc on its ends."""
    paint = _paint("#242c34", 0.9)
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
    "ground": _paint(FAINT, 0.8),
    "mesh": _paint("#a9bccd", 1.0),
    "ghost": _paint(FAINT, 6),
    "link": _paint(STEEL, 8),
    "rod": _paint(STEEL, 5),
    "joint": _paint(INK, 1.0, fill="#b4c1cf"),
    "cap": _paint(INK, 1.0, fill=PALE),
    "gripper": _paint(INK, 3.2, join="miter"),
    "tool": _paint("#CC79A7", 6),
    "axis": _paint(INK, 1, dash=(6, 3, 1.5, 3)),
    "dashed": _paint(STEEL, 1.4, dash=(5.6, 4.2)),
    "arc": _paint(INK, 1.4),
    "vector": _paint(INK, 2, fill=INK),
    "ellipse": _paint("#56B4E9", 1.6, fill="#56B4E940"),
    "target": _paint("#D55E00", 2.2),
    "miss": _paint("#D55E00", 1.4, dash=(5.6, 4.2)),
    "first": _paint("#D55E00", 2),
    "second": _paint("#0072B2", 2, dash=(10, 4)),
    "first-dot": _paint("#D55E00", 8),
    "second-dot": _paint("#0072B2", 8),
    "trace": _paint("#CC79A7", 1.6),
    "ink": {"fill": INK},
    **{axis: _paint(colour, 1.8, fill=colour) for axis, colour in AXIS_COLOURS.items()},
}
