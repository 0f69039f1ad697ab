"""XML that somebody else wrote, as elements; nothing in it is resolved, fetched or run."""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any, NoReturn
from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers import expat

from ..arms import inputs

LARGEST = 20_000_000  # bytes; descriptions of whole humanoids have 200,000
DEEPEST = 100         # elements inside each other; a description has 5
_MARK, _EMPTY = "\ufeff", " \t\r\n"  # what may stand before XML: a mark of encoding, empty lines


def root_of(source: Any) -> Element:
    """The outermost element of a file, or of the XML itself.

    A document that declares a type or an entity is refused before anything of it is used: that is
    how XML reads other files, asks the network and grows without end.

    Examples
    --------
    >>> root_of('<robot name="R"/>').get("name")
    'R'
    """
    text = _text(source)
    if len(text) > LARGEST:
        raise ValueError(f"path_or_text: expected a file of up to {LARGEST // 10**6} MB, "
                         f"got {len(text) / 10**6:.0f} MB; take out what is no link and no joint")
    return _parsed(text)


def _text(source: Any) -> bytes | str:
    if isinstance(source, bytes):
        return source.lstrip(_EMPTY.encode())
    if isinstance(source, str) and source.lstrip(_MARK + _EMPTY).startswith("<"):
        return source.lstrip(_MARK + _EMPTY)
    if isinstance(source, str) and not source.strip():
        raise ValueError("path_or_text: expected a file's name or the text of a URDF, "
                         f"got {inputs.brief(source)}, which is empty; "
                         "write kl.from_urdf(\"robot.urdf\")")
    if isinstance(source, str | os.PathLike):
        return _file(source).lstrip(_EMPTY.encode())
    raise ValueError("path_or_text: expected a file's name or the text of a URDF, "
                     f"got {inputs.brief(source)}; write kl.from_urdf(\"robot.urdf\")")


def _file(name: str | os.PathLike) -> bytes:
    said = f"path_or_text: expected a URDF file, got {inputs.brief(os.fspath(name))}, "
    try:
        with Path(name).expanduser().open("rb") as file:
            return file.read(LARGEST + 1)
    except IsADirectoryError:
        raise ValueError(f"{said}which is a folder; name a file in it") from None
    except (FileNotFoundError, NotADirectoryError, ValueError, RuntimeError):
        # ValueError is of a name with a zero in it, RuntimeError of ~nobody
        raise ValueError(f"{said}which is not there; look at its name and its folder, "
                         "or give the text itself") from None
    except OSError as error:
        raise ValueError(f"{said}which cannot be read ({error.strerror}); "
                         "give another file") from None


def _parsed(text: bytes | str) -> Element:
    elements, depth = TreeBuilder(), 0

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal depth
        depth += 1
        if depth > DEEPEST:
            raise ValueError(f"path_or_text: expected elements in up to {DEEPEST} others, got one "
                             "in more; this is no robot")
        elements.start(tag, attributes)

    def end(tag: str) -> None:
        nonlocal depth
        depth -= 1
        elements.end(tag)

    parser = expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.StartDoctypeDeclHandler = parser.EntityDeclHandler = _declared
    try:
        parser.Parse(text, True)
    except (expat.ExpatError, LookupError, UnicodeError) as error:  # not XML; no such encoding
        raise ValueError(f"path_or_text: expected XML, got {inputs.brief(text, 40)}, which cannot "
                         f"be read ({error}); open it in an editor and look there") from None
    return elements.close()


def _declared(*_: Any) -> NoReturn:
    raise ValueError("path_or_text: expected a file without a document type, got one that declares "
                     "a type or an entity (<!DOCTYPE, <!ENTITY); take it out, as it may load other "
                     "files")
