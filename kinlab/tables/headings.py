"""What the headings of a table's columns say: which parameter, in which unit, of which row."""
from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from .spelling import plain

IGNORED, LABEL, KIND, OFFSET = "", "label", "joint", "offset"
_WORDS = {
    "theta": "theta teta tetha th thi vartheta varphi jointangle angle phi theta0 gelenkwinkel "
             "winkel drehwinkel angulo rotationangle jointrotation thetaz rotz",
    "d": "d linkoffset jointdistance gelenkversatz versatz distance linkdistance transz tz depth "
         "hebelarmversatz gelenkabstand",
    "a": "a linklength length commonnormal armlength armlange gliedlange lange longitud longueur "
         "transx tx",
    "alpha": "alpha alfa alph al linktwist twist twistangle linktwistangle verwindung "
             "verwindungswinkel verdrehung torsion rotx",
    "low": "low min lower lowerlimit minimum qmin thetamin minangle",
    "high": "high max upper upperlimit maximum qmax thetamax maxangle",
    "home": "home zero homeposition qhome",
    "name": "name jointname linkname bezeichnung nom nombre", "flip": "flip",
    KIND: "type jointtype kind typ sigma gelenktyp gelenkart r/p rp p/r tipo jtype",
    OFFSET: "offset jointoffset qoffset thetaoffset offsettheta angleoffset",
    LABEL: "i j k n # no nr num number joint joints link links frame frames axis row index gelenk "
           "achse glied element step transform transformation articulation id jointi linki t "
           "joint# link# jointnumber linknumber jointno linkno joint/link parent child from to "
           "body bodies i-1 linki-1toi i-1->i",
    # theta, a and d, where no other column is
    "q": "q v variable jointvariable var variables", "r": "r l", "s": "s b",
}
_MEANS = {word: column for column, words in _WORDS.items() for word in words.split()}
_LENGTH_WORDS = {"mm": "mm", "millimeter": "mm", "millimeters": "mm", "millimetre": "mm",
                 "millimetres": "mm", "cm": "cm", "centimeter": "cm", "centimeters": "cm",
                 "m": "m", "meter": "m", "meters": "m", "metre": "m", "metres": "m", "in": "in",
                 "inch": "in", "inches": "in", '"': "in"}
_ANGLE_WORDS = {"°": "deg", "deg": "deg", "degs": "deg", "degree": "deg", "degrees": "deg",
                "grad": "deg", "rad": "rad", "rads": "rad", "radian": "rad", "radians": "rad"}
UNITS = _LENGTH_WORDS | _ANGLE_WORDS
_UNIT = re.compile(r"(?:[\[(<]\s?([A-Za-z°\"]{1,12})\.?\s?[\])>]"
                   r"|(?:[/,:]|\bin\b)\s?([A-Za-z°\"]{1,12})|[\s_](mm|cm|m|deg|rad)|(°))$")
_PREVIOUS = re.compile(r"(?<=.)(?:[ijkn]?(?:-|m|minus)1|[ijkn]1|prev|previous)$")
_LIMITS = {"q⁻": "low", "q⁺": "high"}
_KHALIL = {"d": "a", "r": "d"}
_FUNCTION = re.compile(r"\b(?:sin|cos|tan|max|min|dot)\b|[cs]alpha|[cs]theta")
_FOREIGN = re.compile("[\u2e80-\u9fff\uac00-\ud7af\uff00-\uffef]+")
_LONGEST = 60


@dataclass(frozen=True)
class Heading:
    """A column's meaning: a parameter, a word of `_WORDS`, or "" if it is not known.

    Attributes
    ----------
    column, text : str
        What it means, and what is written.
    unit : str
        The unit that it names, or "".
    previous : bool
        Whether its index is i-1: alpha and a of a modified table.
    sure : bool
        Whether all of it says so, and not one of several words.
    """

    column: str
    text: str = ""
    unit: str = ""
    previous: bool = False
    sure: bool = True


@lru_cache(maxsize=4096)  # the same words come again, in other cuts of a text and in other texts
def heading(text: str) -> Heading:
    """The meaning of one heading.

    Examples
    --------
    >>> heading("α(i-1) [°]")
    Heading(column='alpha', text='α(i-1) [°]', unit='deg', previous=True, sure=True)
    >>> heading("Link length").column, heading("mass").column
    ('a', '')
    """
    if len(text) > _LONGEST:
        return Heading(IGNORED, text)
    if text.strip() in _LIMITS:
        return Heading(_LIMITS[text.strip()], text)
    words, unit = _without_unit(plain(text).lower().replace("**", ""))
    for k, candidate in enumerate(_candidates(words)):
        column, previous = _meaning(_bare(candidate))
        if column is not None and not (k and column == LABEL):  # "Link mass" is no label
            return Heading(column, text, unit, previous and column in ("a", "alpha", "r"), not k)
    return Heading(IGNORED, text, unit)


def headings(cells: Sequence[str]) -> tuple[Heading, ...]:
    """The meanings of a row of headings; what depends on its neighbours is decided here."""
    heads = _as_khalil([heading(cell) for cell in cells])
    for word, column in (("q", "theta"), ("r", "a"), ("s", "d")):
        heads = _decided(heads, word, column)
    heads = [replace(head, column=IGNORED) if not head.sure and any(
        other.column == head.column and other.sure for other in heads) else head for head in heads]
    there = {head.column for head in heads}
    if "theta" in there and "d" not in there and OFFSET in there:
        heads = _decided(heads, OFFSET, "d")
    elif "theta" not in there and OFFSET in there:
        heads = _decided(heads, OFFSET, "theta")
    return tuple(heads)


def _as_khalil(heads: list[Heading]) -> list[Heading]:
    """Headings of Khalil and Kleinfinger: d along x and r along z, of a modified table.

    Their tables have a column σ, or the order α, d, θ, r.
    """
    columns = [head.column for head in heads]
    own = [column for column in columns if column in ("alpha", "d", "theta", "r")]
    if "a" in columns or sorted(own) != ["alpha", "d", "r", "theta"] or not (
            own == ["alpha", "d", "theta", "r"] or any(_bare(head.text.lower())[:1] == "σ"
                                                       for head in heads)):
        return heads
    return [replace(head, column=_KHALIL[head.column], previous=True) if head.column in _KHALIL
            else head for head in heads]


def _decided(heads: list[Heading], word: str, column: str) -> list[Heading]:
    """A word that may be another column's: it is that column, unless that one is there."""
    free = all(head.column != column for head in heads)
    return [replace(head, column=column if free else IGNORED) if head.column == word else head
            for head in heads]


def _without_unit(text: str) -> tuple[str, str]:
    match = _UNIT.search(text.rstrip())
    word = next(filter(None, match.groups()), "") if match else ""
    if match and word in UNITS and text[:match.start()].strip():
        return text[:match.start()].rstrip(), UNITS[word]
    return text, ""


def _candidates(text: str) -> list[str]:
    """The heading itself, and its parts where a word and a symbol stand side by side."""
    if _FUNCTION.search(text):
        return [text]
    if "/" in text:
        return [text, text.split("/")[0]]
    if foreign := _FOREIGN.sub("", text).strip():
        text = foreign if foreign != text else text
    elif text:
        return [""]  # words that name no parameter
    if inside := re.fullmatch(r"(.{2,40}?)\s*[(,:]\s*([^()]{1,12}?)\s*\)?", text):
        return [text, inside[2], inside[1]] if len(inside[1].strip()) > 2 else [text, inside[1]]
    return [text, *text.rsplit(" ", 1)[::-1]] if " " in text else [text]


def _bare(text: str) -> str:
    text = re.sub(r"[\s_*^{}()\[\]\\.:'´`~+]", "", text)
    return text.replace("ä", "a").replace("á", "a").replace("ó", "o").replace("é", "e")


def _meaning(bare: str) -> tuple[str | None, bool]:
    """The column of a bare word and whether it has the index i-1."""
    if bare in _MEANS:
        return _MEANS[bare], False
    if not bare:
        return LABEL, False
    base = _PREVIOUS.sub("", bare)
    if base != bare:
        return _MEANS.get(base), True
    return _MEANS.get(bare[:-1]) if bare[-1:] in tuple("ijkn") else None, False
