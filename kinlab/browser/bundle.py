"""The JavaScript's modules joined into one text, for a widget and for a page of its own.

anywidget takes one module, and browsers load no modules from a disk. So the modules that an entry
imports are put before it, each after those it needs itself; all then share one scope. Comments
and spaces, which are for whoever reads the source, stay behind.
"""
from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Collection
from pathlib import Path

from rjsmin import jsmin

HERE = Path(__file__).parent
_DARK = re.compile(r"\[data-jp-theme-light=\"false\"] (:is\(.*?\n\})", re.DOTALL)
_REMARK = re.compile(r"/\*.*?\*/", re.DOTALL)
_AIR = re.compile(r"[\s;]*(\})\s*|\s*([{;,])\s*|(?<=:)\s+")  # in a style; no ; is needed before }
_IMPORT = re.compile(r'^import \{([^}]*)\} from "\./([\w.]+)";\n', re.MULTILINE)
# rjsmin would take the spaces out of a text in backquotes within another one.
_NESTED = re.compile(r"`[^`]*\$\{[^}`]*`")
_NOT_ASCII = re.compile(r"[^\x00-\x7f]+")
_EXPORT = re.compile(r"^export (?!default\b)", re.MULTILINE)
# The names that a line at the margin defines: "const A = 1, B = 2;" defines two.
_NAMES = re.compile(r"^(export )?(?:(?:async )?function\*?|class|const|let) "
                    r"((?:\w+ = [^,;({[]+, )*\w+)", re.MULTILINE)


def module(entry: str, folder: Path = HERE) -> str:
    """One ES module with the exports of the entry module alone, in ASCII: it takes half the memory.

    Raises ValueError, in one sentence, where the modules cannot stand in one scope.
    """
    text = f"{jsmin(_joined(entry, folder))}\n"
    return _NOT_ASCII.sub(lambda found: json.dumps(found[0])[1:-1], text)


def script(entry: str, folder: Path = HERE, without: Collection[str] = ()) -> str:
    """One classic script that leaves no names behind and may stand inside a page.

    Modules `without` which the page does as well are left out: their names stand for nothing.
    """
    plain = jsmin(_EXPORT.sub("", _joined(entry, folder, without)))
    return f"(() => {{{plain}}})();\n".replace("</script", r"<\/script")


def style(*names: str) -> str:
    """Style sheets joined into one. As text: a widget would watch a file for changes for ever."""
    return "\n".join((HERE / name).read_text(encoding="utf-8") for name in names)


def page_style(*more: str) -> str:
    """The style sheet of a plain page, with more sheets than those of a view.

    Where the system is dark its inks are dark JupyterLab's.
    """
    sheets = style("live.css", *more, "page.css")
    (inks,) = _DARK.findall(sheets)
    dark = f"\n@media screen and (prefers-color-scheme: dark) {{\n{inks}\n}}\n"
    return _AIR.sub(r"\1\2", _REMARK.sub("", sheets + dark))


def _joined(entry: str, folder: Path, without: Collection[str] = ()) -> str:
    *needed, last = _in_order(entry, folder, without)
    return "".join([_EXPORT.sub("", text) for text in needed] + [last])


def _in_order(entry: str, folder: Path, without: Collection[str] = ()) -> list[str]:
    """The texts without their imports, what is needed first."""
    texts: dict[str, str] = {}

    def add(name: str, asked: tuple[str, ...]) -> None:
        if name in asked:
            raise ValueError(f"{' > '.join([*asked, name])}: these modules import each other in a "
                             "circle; move what both need into a third")
        if name in texts:
            return
        text = (folder / name).read_text(encoding="utf-8")
        if name in without:
            text = f"export const {' = 0, '.join(_names(text, exported=True))} = 0;\n"
        for wanted, source in _IMPORT.findall(text):
            add(source, (*asked, name))
            for one in re.split(r",\s*", wanted.strip().rstrip(",")):
                if one not in _names(texts[source], exported=True):
                    raise ValueError(f"{name}: imports {one!r} from {source}, which exports no "
                                     "such name")
        texts[name] = text

    add(entry, ())
    _check(texts)
    return [_IMPORT.sub("", text) for text in texts.values()]


def _names(text: str, *, exported: bool = False) -> list[str]:
    return [one.split(" = ")[0] for export, names in _NAMES.findall(text)
            if export or not exported for one in names.split(", ")]


def _check(texts: dict[str, str]) -> None:
    """That the texts can stand in one scope."""
    owners: dict[str, str] = {}
    for name, text in texts.items():
        if nested := _NESTED.search(text):
            raise ValueError(f"{name}: holds {nested[0]!r}; give the text within the other one a "
                             "name of its own")
        if found := re.search(r"^import\b.*", _IMPORT.sub("", text), re.MULTILINE):
            raise ValueError(f"{name}: cannot follow {found[0]!r}; write "
                             'import { name } from "./module.js";')
        for one, count in Counter(_names(text)).items():
            if one in owners or count > 1:
                raise ValueError(f"{name}: defines {one!r}, which {owners.get(one, name)} defines "
                                 "too; joined modules share one scope, so give one another name")
            owners[one] = name
