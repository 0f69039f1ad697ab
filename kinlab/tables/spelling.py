"""What people write for the signs of a table: LaTeX, HTML, Greek letters, other minus signs."""
from __future__ import annotations

import html
import re
import unicodedata
from functools import lru_cache

_CHARACTERS = str.maketrans({
    **dict.fromkeys("−–—‐‑‒⁻", "-"), **dict.fromkeys("º˚∘ᵒ", "°"), **dict.fromkeys("×·⋅∗", "*"),
    **dict.fromkeys("\u200b\u200c\u200d\u2060\ufeff", None), "⁄": "/", "÷": "/",
    "θ": "theta", "ϑ": "theta", "Θ": "theta", "α": "alpha", "⍺": "alpha",
    "√": "sqrt", "π": "pi", "φ": "phi", "ϕ": "phi",
    "σ": "sigma", "∗": "*", "⋆": "*", "★": "*"})
_POWER = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+")
_TAGS = {"<sub>": "_{", "</sub>": "}", "<sup>": "^{", "</sup>": "}"}
_TAG = re.compile(r"</?[A-Za-z][A-Za-z0-9]{0,9}(?:\s[^<>]{0,80})?/?>")
_WRAPPED = re.compile(r"\\(?:mathrm|mathbf|mathit|mathsf|text|textbf|textit|textrm|operatorname|"
                      r"boldsymbol|bm|mbox|hbox|hat|bar|tilde)\s*\{([^{}]{0,80})\}")
_SPACES = re.compile(r"\\(?:left|right|displaystyle|quad|qquad|bf|rm|it|limits|large|Large)"
                     r"(?![A-Za-z])|\\[,;:! ]|~|\$|\\[()\[\]]")
_DEGREES = re.compile(r"\^?\s?\{?\s?\\(?:circ|degree|textdegree|deg)(?![A-Za-z])\s?\}?"
                      r"|\^\{?o\}?(?![A-Za-z])")
_FRACTION = re.compile(r"\\[dt]?frac\s*(?:\{([^{}]{0,80})\}|(\\pi|[0-9]))"
                       r"\s*(?:\{([^{}]{0,80})\}|(\\pi|[0-9]))")
_ROOT = re.compile(r"\\sqrt\s*\{([^{}]{0,80})\}")
_TIMES = re.compile(r"\\(?:cdot|times|ast|star)(?![A-Za-z])")
_ABOVE = re.compile(r"[0-9.]*\s?(?:\\pi|[A-Za-z]\w*)|[0-9.]+")
_BELOW = re.compile(r"\\pi|[A-Za-z]\w*|[0-9.]+")
_BOLD = re.compile(r"(?<![\w)*])(\*\*|__)(?=\S)(.{1,80})(?<=\S)\1(?![\w(*])")  # 9**9**9 is a power
_LIBRARY = re.compile(r"\b(?:np|numpy|math|sp|sympy|Math)\.(?=[A-Za-z])")
_TURNED = re.compile(r"\b(?:[A-Za-z]{1,8}\.)?(?:deg2rad|radians)\(([^()]{1,60})\)")
_PI = re.compile(r"\b(?:PI|Pi|M_PI)\b|(?<=[0-9])PI\b")
_LONGEST = 300


@lru_cache(maxsize=4096)  # a cell is asked for its kind of joint, its unit and its number
def plain(text: str) -> str:
    """A cell or a heading in the signs that kinlab reads; what is not known stays.

    Examples
    --------
    >>> [plain(text) for text in (r"$-\\frac{\\pi}{2}$", "½π", "θ₂* − 90º", r"\\alpha_{i-1}")]
    ['-pi/2', '1/2*pi', 'theta2* - 90°', 'alpha_i-1']
    """
    if len(text) > _LONGEST:
        return text
    text = _BOLD.sub(r"\2", text.replace(":math:", "").strip().strip("`"))
    text = _unwrapped(_untagged(html.unescape(text)))
    text = _POWER.sub(lambda power: f"^{unicodedata.normalize('NFKC', power[0])}", text)
    text = unicodedata.normalize("NFKC", text.translate(_CHARACTERS)).translate(_CHARACTERS)
    text = _LIBRARY.sub("", _PI.sub("pi", _TURNED.sub(r"(\1) deg", text)))
    text = re.sub(r"([0-9)])\s?(pi(?![A-Za-z])|sqrt)", r"\1*\2", text)
    return " ".join(text.split())


def _untagged(text: str) -> str:
    for tag, sign in _TAGS.items():
        text = text.replace(tag, sign)
    return _TAG.sub("", text) if "<" in text else text


def _unwrapped(text: str) -> str:
    """LaTeX as plain text."""
    if not set(text) & set("\\$^_{}~"):
        return text
    text = _DEGREES.sub("°", _SPACES.sub(" ", text))
    for _ in range(3):  # one in another
        text = _WRAPPED.sub(r"\1", text)
        text = _ROOT.sub(r"sqrt(\1)", _FRACTION.sub(_fraction, text))
    text = re.sub(r"\\([&%#_{}|*<>-])", r"\1", _TIMES.sub("*", text))
    text = re.sub(r"\\([A-Za-z]{1,12})(?:\s+(?=[_^]))?", r"\1", text)
    return re.sub(r"[{}]", "", text)


def _fraction(match: re.Match[str]) -> str:
    above, below = match[1] or match[2] or "", match[3] or match[4] or ""
    above = above.strip() if _ABOVE.fullmatch(above.strip()) else f"({above})"
    below = below.strip() if _BELOW.fullmatch(below.strip()) else f"({below})"
    return f"{above}/{below}"
