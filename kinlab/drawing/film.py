"""A motion as a GIF: the still pictures of a scene, one after the other, in real time."""
from __future__ import annotations

import io
from collections.abc import Sequence

import numpy as np
from PIL import Image, ImageColor

from ..arms.workspace import ProgressBar
from . import worker
from .paints import COLOURS
from .scene import Scene

MOST = 600            # pictures: a minute and more, which still fit into memory
_COLOURS = 64         # besides those of quantities: a film of 3 s stays under 2 MB
_FADES = (1.0, 0.66, 0.33)
_TICK = 0.01          # s: a GIF counts hundredths
_HOLD = 1.0           # s that the last picture stands before the film begins anew


def gif(scene: Scene, preset: str, show: Sequence[str], end: float, *, fps: int,
        width: int) -> bytes:
    """A film of a scene whose only knob runs from 0 to `end` seconds.

    Each picture stands as long as the motion needs to the next one; together they take `end`
    seconds, to a hundredth.
    """
    times = frame_times(end, fps)

    def taken(time: float) -> Image.Image:
        return _scaled(worker.png(scene, [time], preset, show), width)

    ends = {time: taken(time) for time in (times[0], times[-1])}
    palette, pictures = _palette(*ends.values()), []
    with ProgressBar("film") as done:
        for time in times:
            picture = ends.get(time) or taken(time)
            pictures.append(picture.quantize(palette=palette, dither=Image.Dither.NONE))
            done(len(pictures), len(times))
    first, *others = pictures
    film = io.BytesIO()
    first.save(film, "GIF", save_all=True, append_images=others, loop=0, optimize=False,
               duration=_durations(times))
    return film.getvalue()


def frame_times(end: float, fps: int) -> list[float]:
    """When each picture is taken: `fps` of them in a second or a little more, both ends too."""
    return np.linspace(0.0, end, max(1, round(fps * end)) + 1).tolist()


def _durations(times: Sequence[float]) -> list[int]:
    """How long each picture stands (ms), whole hundredths that add up to the whole time."""
    ticks = np.diff(np.round(np.array(times) / _TICK))
    return [*(np.maximum(ticks, 1) * 1000 * _TICK).astype(int).tolist(), int(1000 * _HOLD)]


def _scaled(png: bytes, width: int) -> Image.Image:
    picture = Image.open(io.BytesIO(png)).convert("RGB")
    height = round(picture.height * width / picture.width)
    return picture.resize((width, height), Image.Resampling.LANCZOS)


def _palette(first: Image.Image, last: Image.Image) -> Image.Image:
    """One set of colours for all pictures: what rests does not flicker, and takes no room.

    Each quantity keeps its colour; the others are those of the first picture and of the last one.
    """
    both = Image.new("RGB", (first.width, 2 * first.height))
    both.paste(first, (0, 0))
    both.paste(last, (0, first.height))
    seen = both.quantize(_COLOURS, Image.Quantize.MEDIANCUT).getpalette() or []
    palette = Image.new("P", (1, 1))
    palette.putpalette([*_quantities(), *seen[:3 * _COLOURS]])
    return palette


def _quantities() -> list[int]:
    """The colours of all quantities and what they are where they fade into the paper: r, g, b."""
    return [round(255 - strong * (255 - level)) for colour in COLOURS.values() for strong in _FADES
            for level in ImageColor.getrgb(colour.line)]
