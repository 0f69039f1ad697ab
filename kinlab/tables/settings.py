"""What the words around a table say of it: convention, units, name, lengths, base and tool."""
from __future__ import annotations

import csv
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

from ..arms import inputs
from .cells import line
from .ends import End
from .headings import UNITS
from .table import MOST_LENGTHS

_CONVENTIONS = {"standard": "standard", "classic": "standard", "classical": "standard",
                "distal": "standard", "dh": "standard", "modified": "modified", "mdh": "modified",
                "craig": "modified", "proximal": "modified"}
_ANGLES = {word: unit for word, unit in UNITS.items() if unit in ("deg", "rad")}
_LENGTHS = {word: unit for word, unit in UNITS.items() if unit not in ("deg", "rad")}
_SAID = re.compile(r"[-*%#>/\s]{0,6}([A-Za-z]{4,10})\s?[:=]\s?(.{1,2000})")
_TITLE = re.compile(r"(?:\w+\('?)?(.{0,200}?)'?:? ?(standard|modified) DH, lengths in (.{1,60}), "
                    r"\* marks the joint variable\)?")
_MODIFIED = re.compile(r"\bmodified\W{1,3}(?:dh|d-h|denavit)|\bcraig\b|\bmdh\b", re.IGNORECASE)
_STANDARD = re.compile(r"\b(?:standard|classic|classical)\W{1,3}(?:dh|d-h|denavit)", re.IGNORECASE)
_ANGLE = re.compile(r"\b(?:angles?\b[^.;]{0,30}?\b|in )(degrees?|deg|radians?|rad)\b",
                    re.IGNORECASE)
_LENGTH = re.compile(
    r"\b(?:(?:lengths?|distances?|dimensions?|units?)\b[^.;]{0,30}?[\s(\[]|in )"
    r"(mm|cm|m|millimet(?:er|re)s?|centimet(?:er|re)s?|met(?:er|re)s?|inch|inches)\b",
    re.IGNORECASE)
_NAMED = re.compile(r"(?<![\w.])([A-Za-z]{1,8}_?\{?[0-9]{0,3}\}?)\s?=\s?"
                    r"([-−]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+))(?![\w.]|\s?[-+*/^])")


@dataclass(frozen=True)
class Said:
    """What a text says of its table; None or empty where it says nothing.

    `named` are values such as ``L1 = 0.5`` in its words, for lengths that cells name.
    """

    convention: str | None = None
    angles: str | None = None
    unit: str | None = None
    name: str = ""
    lengths: tuple[tuple[str, str], ...] = ()
    base: End | None = None
    tool: End | None = None
    named: dict[str, str] = field(default_factory=dict)

    @property
    def says_all(self) -> bool:
        """Whether nothing is left to assume, as in what kinlab wrote."""
        return None not in (self.convention, self.angles, self.unit)


def said_in(lines: Iterable[Sequence[str]]) -> Said:
    """What lines say: settings such as ``angles,deg`` or ``angles: deg``, and plain words.

    Examples
    --------
    >>> said = said_in([["convention", "modified"], ["All lengths are in mm."]])
    >>> said.convention, said.unit, said.angles
    ('modified', 'mm', None)
    """
    said, words = Said(), []
    for cells in lines:
        word, given = setting(cells)
        if word in _SETTINGS:
            said = _SETTINGS[word](said, given)
        else:
            words.append(" ".join(cells)[:300])
    return _with_words(said, words)


def settings_in(lines: Iterable[Sequence[str]]) -> Said:
    """What lines say that are all settings, as kinlab wrote them; KeyError if one is none."""
    said = Said()
    for word, *given in lines:
        said = replace(said, unit=line(given[0])) if word == "lengths" and given else \
            _SETTINGS[word](said, [*given, ""])
    return said


def _bare(given: Sequence[str]) -> list[str]:
    """What is given, as a cell holds it, without the empty cells of a spreadsheet behind it."""
    words = [line(word) for word in given]
    while words and not words[-1]:
        words.pop()
    return words


def setting(cells: Sequence[str]) -> tuple[str, list[str]]:
    """The word of a setting and what is given; ("", []) for other lines."""
    given = [word.strip() for word in cells]
    while given and not given[-1]:
        given.pop()
    if given and (match := _SAID.fullmatch(given[0])) and (
            len(given) == 1 or match[1].lower() in _SETTINGS):
        given = [match[1], *next(csv.reader([match[2]], skipinitialspace=True), []), *given[1:]]
    return (given[0].strip(" -*%#").lower(), given[1:]) if len(given) > 1 else ("", [])


def _word(name: str, given: Sequence[str], known: dict[str, str]) -> str:
    words = {known[word] for word in re.findall(r"[a-z°]+", given[0].lower()) if word in known}
    if len(words) > 1:  # "modified DH": the words beside the first only name the thing
        words -= {known.get("dh")}
    if len(words) != 1:
        raise ValueError(f"text: {name} is {inputs.brief(given[0])}; expected "
                         f"{' or '.join(dict.fromkeys(known.values()))}")
    return words.pop()


def _with_length(said: Said, given: Sequence[str]) -> Said:
    given = given[:2] if not any(given[2:]) else given
    if len(given) > 2 or len(said.lengths) >= MOST_LENGTHS:
        raise ValueError(f"text: length is {inputs.brief(','.join(given))}; expected a name and "
                         f"its value such as length,d2,0.5, at most {MOST_LENGTHS} times")
    name, text = (*given, "")[:2]
    return replace(said, lengths=(*said.lengths, (line(name), line(text))))


def _with_unit(said: Said, given: Sequence[str]) -> Said:
    """The unit of lengths, or both units: ``Units: meters and radians``."""
    words = re.findall(r"[a-z°\"]+", " ".join(given).lower())
    words = words if words == ["in"] else [word for word in words if word != "in"]
    unit, angles = (_only(known[word] for word in words if word in known)
                    for known in (_LENGTHS, _ANGLES))
    return replace(said, unit=unit or line(given[0]), angles=said.angles or angles)


def _with_angles(said: Said, given: Sequence[str]) -> Said:
    return replace(said, angles=_word("angles", given, _ANGLES))


_SETTINGS = {
    "name": lambda said, given: replace(said, name=line(given[0])),
    "convention": lambda said, given: replace(
        said, convention=_word("convention", given, _CONVENTIONS)),
    "angles": _with_angles, "angle": _with_angles, "lengths": _with_unit, "unit": _with_unit,
    "units": _with_unit, "length": _with_length,
    "base": lambda said, given: replace(said, base=End.read("base", _bare(given))),
    "tool": lambda said, given: replace(said, tool=End.read("tool", _bare(given))),
}


def _with_words(said: Said, lines: Sequence[str]) -> Said:
    """What sentences say, where no setting says it."""
    text = "\n".join(lines)
    if title := next(filter(None, map(_TITLE.search, lines)), None):
        return replace(said, name=said.name or line(title[1]), named=_named(text),
                       convention=said.convention or title[2], unit=said.unit or line(title[3]))
    conventions = [word for word, pattern in (("modified", _MODIFIED), ("standard", _STANDARD))
                   if pattern.search(text)]
    angles = _only(_ANGLES[word.lower()] for word in _ANGLE.findall(text))
    unit = _only(_LENGTHS[word.lower()] for word in _LENGTH.findall(text))
    return replace(said, named=_named(text), angles=said.angles or angles, unit=said.unit or unit,
                   convention=said.convention or _only(conventions))


def _only(words: Iterable[str]) -> str | None:
    found = set(words)
    return found.pop() if len(found) == 1 else None


def _named(text: str) -> dict[str, str]:
    return {re.sub("[{}]", "", name): value.replace("−", "-") for name,
            value in _NAMED.findall(text)}
