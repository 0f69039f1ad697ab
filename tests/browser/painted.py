"""What both hands paint, in the same words: the browser's SVG and Python's `still`.

A picture becomes a list of strokes in the order of painting: every line, outline or text with its
group's name, its points (px) and its paint. live.css is loaded, in light colours.
"""
from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np
from matplotlib.colors import to_hex, to_rgba

from kinlab.browser import bundle
from kinlab.drawing.paints import COLOURS
from kinlab.drawing.solids import OFFSETS, Across
from kinlab.drawing.still import still

SOURCE = bundle.module("picture.js")
STYLE = bundle.style("live.css")
PIXELS = 0.11                    # the browser has one decimal
WALKED = 0.5                     # words walk 140 steps to their places, which sum up roundings
LEADER = 0.8                     # px: the width of a line that leads to words
ON_THE_WAY = 4.0                 # px: names of a view that was mounted just now
GROUND = ("numbers", "coordinates")  # words of the floor: they give way to names
AROUND = np.linspace(0, 2 * np.pi, 48, endpoint=False)
RAYS = np.stack([np.cos(AROUND), np.sin(AROUND)])


# Draws a scene that nobody has looked at yet, and tells all that is seen of it.
DRAW = """([scene, q, preset, show, size]) => {
    const picture = new kinlab.Picture(scene);
    document.body.innerHTML = '<div class="kl-view"><div class="kl-picture"></div></div>';
    document.querySelector('.kl-picture').append(picture.svg);
    for (const {layer} of scene.layers) picture.show(layer, show.includes(layer));
    picture.resize(...size);
    picture.reset(preset);
    picture.draw(q);
    window.picture = picture;
}"""
TELL = """() => {
    const {svg} = window.picture ?? {svg: document.querySelector('.kl-picture svg')};
    const gradient = fill => {
        const node = fill.startsWith('url') && svg.querySelector(fill.match(/#[^")]+/)[0]);
        if (!node) return null;
        const told = Object.fromEntries([...node.attributes].map(a => [a.name, a.value]));
        return {...told, round: node.tagName === 'radialGradient',
            stops: [...node.children].map(s => [Number(s.getAttribute('offset')),
                getComputedStyle(s).stopColor, Number(getComputedStyle(s).stopOpacity)])};
    };
    const seen = node => getComputedStyle(node).visibility === 'visible' &&
        getComputedStyle(node).opacity > 0 && !node.closest('defs, [style*="display: none"]');
    return [...svg.querySelectorAll('path, text')].filter(node => seen(node) &&
        (node.tagName === 'text' || node.getAttribute('d'))).map(node => {
        const style = getComputedStyle(node), group = node.closest('[data-part]');
        return {group: group.dataset.pieceOf || group.id || group.dataset.part, tag: node.tagName,
            d: node.getAttribute('d'), text: node.textContent,
            at: [Number(node.getAttribute('x')), Number(node.getAttribute('y'))],
            fill: style.fill, stroke: style.stroke, width: parseFloat(style.strokeWidth),
            dash: style.strokeDasharray, join: style.strokeLinejoin,
            weight: Number(style.fontWeight), opacity: Number(style.opacity),
            light: gradient(style.fill), inked: gradient(style.stroke)};
    });
}"""


@dataclass
class Stroke:
    """One line, closed outline or text of a picture."""

    group: str
    points: np.ndarray
    closed: bool = False
    text: str = ""
    fill: str = "none"
    stroke: str = "none"
    width: float = 0.0
    dash: tuple[float, ...] = ()
    join: str = ""
    opacity: float = 1.0
    bold: bool = False
    light: dict | None = field(default=None)  # kind, ends, stops


def lines(d: str) -> list[np.ndarray]:
    """The points of each line of a path."""
    return [np.array(re.findall(r"-?[\d.]+", line), dtype=float).reshape(-1, 2)
            for line in d.split("M")[1:]]


def browsers(page, scene, q, preset="", show=("frames", "labels", "floor"), size=None):
    """What picture.js draws."""
    page.evaluate(DRAW, [scene.data(), list(map(float, q)), preset or scene.seen_from, list(show),
                         list(size or scene.size)])
    return strokes(page.evaluate(TELL))


def strokes(told: list[dict]) -> list[Stroke]:
    """Strokes of the SVG's nodes; the floor's that fade keep their gradient as a light."""
    found = []
    for node in told:
        group = node["group"]
        if node["tag"] == "text":
            found.append(Stroke(group, np.array([node["at"]]), text=node["text"],
                                fill=_colour(node["fill"]), opacity=node["opacity"],
                                bold=node["weight"] >= 600))
            continue
        light = node["light"] or node["inked"]
        found += [Stroke(
            group, line, node["d"].endswith("Z"), fill="light" if light else _colour(node["fill"]),
            stroke="light" if node["inked"] else _colour(node["stroke"]), width=node["width"],
            dash=_dash(node["dash"]), join=node["join"], opacity=node["opacity"],
            light=light and _light(light)) for line in lines(node["d"])]
    return found


def _colour(text: str) -> str:
    """A computed colour as #rrggbb, or #rrggbbaa where it is not opaque."""
    channels = [float(part) for part in re.findall(r"[\d.]+(?:e-?\d+)?", text)]
    if text.startswith("rgb"):
        channels[:3] = [part / 255 for part in channels[:3]]
    elif not text.startswith("color(srgb"):
        return text
    return to_hex(channels, keep_alpha=len(channels) == 4)


def _dash(text: str) -> tuple[float, ...]:
    return tuple(float(part) for part in re.findall(r"[\d.]+", text))


def _light(told: dict) -> dict:
    moved, round_ = told["gradientTransform"], told["round"]
    light = {"kind": 3 if round_ else 4, "moved": moved, "radius": float(told.get("r", 0)),
             "stops": [(at, _colour(colour)) for at, colour, _ in told["stops"]],
             "strong": [(at, strong) for at, _, strong in told["stops"]]}
    if moved.startswith("matrix"):  # of a gradient of length 1
        a, b, _, _, x, y = map(float, re.findall(r"-?[\d.]+", moved))
        light["ends"] = [x, y, np.hypot(a, b)] if round_ else [x, y, x + a, y + b]
    return light


def pythons(scene, q, preset="", show=("frames", "labels", "floor"), size=None) -> list[Stroke]:
    """What `still` paints."""
    return [stroke for drawn in still(scene, q, preset, show, size) for mark in drawn.marks
            for stroke in _marked(re.sub(r"^dropline-\d+$", "dropline", drawn.gid), mark)]


def _marked(group: str, mark) -> list[Stroke]:
    paint = mark.paint
    if mark.text:
        return [Stroke(group, mark.lines[0], text=mark.text, fill=paint["fill"].lower(),
                       opacity=mark.opacity, bold=mark.weight == "bold")]
    fill = paint.get("fill", "none") if mark.closed else "none"
    light = mark.light and {
        "kind": 4 if isinstance(mark.light, Across) else 3,
        "ends": ([*mark.light.start, *mark.light.end] if isinstance(mark.light, Across)
                 else [*mark.light.center, mark.light.radius]),
        "stops": list(zip(OFFSETS[type(mark.light)], mark.fill))}
    return [Stroke(group, np.asarray(line), mark.closed, fill="light" if light else fill.lower(),
                   stroke=paint["stroke"].lower(), width=paint.get("stroke-width", 1.0),
                   dash=tuple(paint.get("stroke-dasharray", ())),
                   join=paint.get("stroke-linejoin", ""), opacity=mark.opacity, light=light)
            for line in mark.lines if len(line)]


# ---- both hands ----

def assert_same_view(page, scene, q, preset, show) -> None:
    """What a mounted view paints is what `still` does; its names go on finding their places."""
    size = page.evaluate("live.picture.size")
    hands = strokes(page.evaluate(TELL)), pythons(scene, q, preset, show, size)
    assert_same(*([one for one in hand if not _walks(one)] for hand in hands))
    named, wanted = ({one.group: one for one in hand if one.text and one.group not in GROUND}
                     for hand in hands)
    assert {group: one.text for group, one in named.items()} == {
        group: one.text for group, one in wanted.items()}
    for group, one in named.items():
        np.testing.assert_allclose(one.points, wanted[group].points, atol=ON_THE_WAY, err_msg=group)


def _walks(stroke: Stroke) -> bool:
    """Whether a stroke is words, or leads to some."""
    return bool(stroke.text) or stroke.width == LEADER


def assert_same(browser: list[Stroke], python: list[Stroke]) -> None:
    """Both pictures: what is painted, in which order, where, and in which colours."""
    assert_same_floor(_of("ground", browser), _of("ground", python))
    one, other = ([stroke for stroke in hand if stroke.group != "ground"]
                  for hand in (browser, python))
    assert [stroke.group for stroke in one] == [stroke.group for stroke in other]
    for mine, theirs in zip(one, other):
        assert_same_stroke(mine, theirs)


def _of(group: str, hand: list[Stroke]) -> list[Stroke]:
    return [stroke for stroke in hand if stroke.group == group]


def assert_same_stroke(one: Stroke, other: Stroke) -> None:
    """One line, outline or text as both hands paint it."""
    wrong = [*_differing(one, other), *_elsewhere(one, other), *_lit_otherwise(one, other)]
    assert not wrong, f"{wrong}:\n{one}\n{other}"


def _differing(one: Stroke, other: Stroke) -> list[str]:
    """Names of what is not the same paint or text."""
    names = ["text", "closed"]
    if one.group != "pane":  # it fades in the browser
        names += ["fill", "bold"] if one.text else ["fill", "stroke"]
    if not one.text and "none" not in (one.stroke, other.stroke):
        names += ["width", "dash"] + (["join"] if len(one.points) > 2 else [])
    wrong = [name for name in names if not _alike(getattr(one, name), getattr(other, name))]
    paler = one.group != "pane" and abs(one.opacity - other.opacity) > 0.006
    return [*wrong, "opacity"] if paler else wrong


def _alike(one, other) -> bool:
    """Whether two values are the same; mixed colours may be rounded either way."""
    if str(one).startswith("#") and str(other).startswith("#"):
        return bool(np.abs(np.subtract(to_rgba(one), to_rgba(other))).max() < 1.01 / 255)
    return one == other


def _elsewhere(one: Stroke, other: Stroke) -> list[str]:
    words = one.text or one.width == LEADER
    if one.points.shape == other.points.shape and (
            np.abs(one.points - other.points).max() <= (WALKED if words else PIXELS)):
        return []
    if one.closed and other.closed:  # an outline has corners only where it needs them
        reach = [np.max(hand.points @ RAYS, axis=0) for hand in (one, other)]
        return [] if np.abs(reach[0] - reach[1]).max() <= PIXELS else ["outline"]
    return ["points"]


def _lit_otherwise(one: Stroke, other: Stroke) -> list[str]:
    """Whether gradients have other ends or stops."""
    mine, theirs = one.light, other.light
    if one.group == "pane" or not (mine and theirs):
        return [] if one.group == "pane" or mine is theirs is None else ["light"]
    same = mine["kind"] == theirs["kind"] and all(
        abs(at - place) < 1e-6 and _alike(colour, ink)
        for (at, colour), (place, ink) in zip(mine["stops"], theirs["stops"], strict=True))
    return [] if same and np.abs(np.subtract(mine["ends"], theirs["ends"])).max() <= PIXELS else [
        "light"]


def assert_same_floor(one: list[Stroke], other: list[Stroke]) -> None:
    """The grid: the browser's fades by a gradient, Python's in short pieces of ten strengths."""
    assert bool(one) == bool(other)
    inks = {"#c3ccd5": 1.0, COLOURS["x"].line.lower(): 1.4, COLOURS["y"].line.lower(): 1.4}
    for ink, width in inks.items():
        whole = [stroke for stroke in one if stroke.light["stops"][0][1] == ink]
        pieces = [stroke for stroke in other if stroke.stroke == ink]
        assert all(stroke.width == width for stroke in [*whole, *pieces])
        assert bool(whole) == bool(pieces)
        if whole:
            _assert_same_lines(whole[0].light, *(np.array([stroke.points for stroke in hand])
                                                 for hand in (whole, pieces)),
                               np.array([piece.opacity for piece in pieces]))


def _assert_same_lines(light: dict, lines: np.ndarray, pieces: np.ndarray,
                       opacity: np.ndarray) -> None:
    """Each piece lies on a line, and so strong; pieces cover of a line what is seen."""
    assert _away(pieces[:, 0], lines).max() < PIXELS and _away(pieces[:, 1], lines).max() < PIXELS
    assert np.abs(_strength(light, pieces.mean(axis=1)) - opacity).max() < 0.11
    shares = np.linspace(0, 1, 23)[:, None, None]
    points = (lines[:, 0] + shares * (lines[:, 1] - lines[:, 0])).reshape(-1, 2)
    seen = points[_strength(light, points) > 0.15]
    assert not len(seen) or _away(seen, pieces).max() < PIXELS


def _away(points: np.ndarray, lines: np.ndarray) -> np.ndarray:
    """How far each point lies from the nearest of straight lines."""
    start, way = lines[:, 0], lines[:, 1] - lines[:, 0]
    since = points[:, None] - start
    square = np.maximum(np.sum(way**2, axis=-1), 1e-9)
    share = np.clip(np.sum(since * way, axis=-1) / square, 0, 1)
    return np.linalg.norm(since - share[..., None] * way, axis=-1).min(axis=1)


def _strength(light: dict, points: np.ndarray) -> np.ndarray:
    x, y, wide, high = map(float, re.findall(r"-?[\d.]+", light["moved"]))
    far = np.hypot((points[:, 0] - x) / wide, (points[:, 1] - y) / high) / light["radius"]
    return np.interp(far, *np.transpose(light["strong"]))
