"""Formulas as MathML, which browsers typeset themselves, spaced as in print."""
from __future__ import annotations

import re

# Space about sin and cos, and none between a sign and what it belongs to.
_OPERAND, _FUNCTION = r"(</(?:mi|mn|msub|msup|msubsup|mrow)>)", "((?:<msup>)?<mi>(?:sin|cos)</mi>)"
_TYPOGRAPHY = (
    (_OPERAND + _FUNCTION, r'\1<mspace width="0.17em"/>\2'),
    (_FUNCTION + "(<mi>|<mn>|<msub>|<msubsup>)", r'\1<mspace width="0.17em"/>\2'),
    (r"(<mo[^>]*>(?!\)|\]|&#x00029;|&#x0005D;|&#x02026;|&#x022EF;)[^<]*</mo>)"
     "<mo>(&#x02212;|&#x0002B;)</mo>", r'\1<mo form="prefix">\2</mo>'),
    (r"<mo[^>]*>(\||&#x0007C;)</mo>", r'<mo lspace="0" rspace="0">\1</mo>'),
    # Few phones have a font with tall brackets: page.css draws those of matrices.
    (r"<mo[^>]*>(?:\[|&#x0005B;)</mo><mtable>(.*?)</mtable><mo[^>]*>(?:\]|&#x0005D;)</mo>",
     r'<mtable class="kl-matrix">\1</mtable>'),
)


def mathematics(latex: str, *, display: bool = False) -> str:
    """LaTeX as MathML, which browsers typeset themselves.

    >>> mathematics("x_1")[66:]
    '<mrow><msub><mi>x</mi><mn>1</mn></msub></mrow></math>'
    """
    from latex2mathml.converter import convert

    latex = latex.replace("{aligned}", "{align*}")  # the same, and known to the converter
    mathml = convert(latex, display="block" if display else "inline")
    for pattern, better in _TYPOGRAPHY:
        mathml = re.sub(pattern, better, mathml, flags=re.DOTALL)
    return mathml


def typeset(text: str) -> str:
    """A text with formulas between dollar signs, with those as MathML."""
    return re.sub(r"\$([^$]+)\$", lambda found: mathematics(found[1]), text)
