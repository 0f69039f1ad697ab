"""Formulas as MathML, which browsers typeset themselves, spaced as in print."""
from __future__ import annotations

import re
from collections.abc import Collection
from html import escape
from xml.etree import ElementTree

_SPACE = "http://www.w3.org/1998/Math/MathML"
_INDEXED = (f"{{{_SPACE}}}msub", f"{{{_SPACE}}}msubsup")
_TURNING = ("C", "S", "θ")  # what turns with the joints in its index
_ACTIVE = ("href", "style", "class", "id")  # what \href and the like would put into a page
_SIGN = re.compile(r"&amp;(#x?[0-9A-Fa-f]+;)")
ElementTree.register_namespace("", _SPACE)
# Space about sin and cos, none between a sign and what it belongs to, no group of one.
_OPERAND, _FUNCTION = r"(</(?:mi|mn|msub|msup|msubsup|mrow)>)", "((?:<msup>)?<mi>(?:sin|cos)</mi>)"
_TYPOGRAPHY = (
    (r"<mrow>(<(m[ni])>[^<]*</\2>)</mrow>", r"\1"),
    (_OPERAND + _FUNCTION, r'\1<mspace width="0.17em"/>\2'),
    (_FUNCTION + "(<mi>|<mn>|<msub>|<msubsup>)", r'\1<mspace width="0.17em"/>\2'),
    (r"(<mo[^>]*>(?!\)|\]|&#x00029;|&#x0005D;|&#x02026;|&#x022EF;)[^<]*</mo>)"
     "<mo>(&#x02212;|&#x0002B;)</mo>", r'\1<mo form="prefix">\2</mo>'),
    (r"<mo[^>]*>(\||&#x0007C;)</mo>", r'<mo lspace="0" rspace="0">\1</mo>'),
    # Few phones have a font with tall brackets: live.css draws those of matrices.
    (r"<mo[^>]*>(?:\[|&#x0005B;)</mo><mtable>(.*?)</mtable><mo[^>]*>(?:\]|&#x0005D;)</mo>",
     r'<mtable class="kl-matrix">\1</mtable>'),
)


def mathematics(latex: str, *, display: bool = False) -> str:
    r"""LaTeX as MathML, which browsers typeset themselves; nothing in it becomes HTML or a link.

    Raises ValueError if it is no LaTeX.

    >>> mathematics(r"\text{<b>}")[66:]
    '<mrow><mtext>&lt;b&gt;</mtext></mrow></math>'
    >>> mathematics("x_1")[66:]
    '<mrow><msub><mi>x</mi><mn>1</mn></msub></mrow></math>'
    """
    from latex2mathml.converter import convert_to_element

    latex = latex.replace("{aligned}", "{align*}")  # the same, and known to the converter
    try:
        math = convert_to_element(latex, display="block" if display else "inline")
    except Exception as error:  # one of twenty, half of them not the converter's own
        raise ValueError(f"latex: cannot be read as a formula ({type(error).__name__}): "
                         f"{latex[:80]!r}") from None
    for part in math.iter():
        for name in _ACTIVE:
            part.attrib.pop(name, None)
    # The converter writes signs as "&#x02212;". Its own text form would let "<" through as well.
    mathml = _SIGN.sub(r"&\1", ElementTree.tostring(math, encoding="unicode"))
    for pattern, better in _TYPOGRAPHY:
        mathml = re.sub(pattern, better, mathml, flags=re.DOTALL)
    return mathml


def typeset(text: str) -> str:
    """A text with formulas between dollar signs, with those as MathML."""
    words = re.split(r"\$([^$]+)\$", text)
    return "".join(mathematics(part) if k % 2 else escape(part) for k, part in enumerate(words))


def named(latex: str, joints: int, slides: Collection[int] = ()) -> str:
    """A matrix in closed form as MathML whose parts carry names, with its LaTeX as text beside it.

    Rows have `data-row`, entries `data-entry` (row and column, from 1) and `data-holds`, the
    numbers of the joints in them. What moves with joints has `data-factor` and their numbers,
    `data-joints`: sines and cosines, and d of the joints in `slides`. With more than nine joints
    of an arm, indices are separated by commas. Angles and lengths have classes of their own.

    >>> '<msub data-factor="S23" data-joints="2 3" class="kl-of-angle">' in named("S_{23}", 6)
    True
    """
    math = ElementTree.fromstring(mathematics(latex, display=True))
    for symbol in (part for part in math.iter() if part.tag in _INDEXED):
        letter, index, *_ = ("".join(part.itertext()) for part in symbol)
        numbers = re.findall(r"\d+" if joints > 9 else r"\d", index)
        if letter in _TURNING or (letter == "d" and {*map(int, numbers)} <= {*slides}):
            symbol.set("data-factor", letter + index)
            symbol.set("data-joints", " ".join(numbers))
        symbol.set("class", "kl-of-angle" if letter in (*_TURNING, "α") else "kl-of-length")
    for i, row in enumerate(math.iter(f"{{{_SPACE}}}mtr"), start=1):
        row.set("data-row", str(i))
        for j, entry in enumerate(row, start=1):
            entry.set("data-entry", f"{i},{j}")
            entry.set("data-holds", " ".join(map(str, sorted(_held(entry)))))
    math.set("alttext", latex)
    return ElementTree.tostring(math, encoding="unicode")


def _held(entry: ElementTree.Element) -> set[int]:
    """The numbers of the joints in an entry."""
    return {int(number) for part in entry.iter() for number in part.get("data-joints", "").split()}
