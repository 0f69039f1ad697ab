"""Texts that nobody should type for a name, and how to see that one of them has done something."""
import re

HIT = "window.hit=1"
AWAY = "http://kinlab.invalid/hit"                  # nobody is asked for it, if all goes well
TEXTS = {
    "tag": f"<img src=x onerror={HIT}>",
    "script": f"<script>{HIT}</script>",
    "end of a script": f"</script><script>{HIT}</script>",
    "comment": f"<!--<script> --><svg/onload={HIT}>",
    "end of all": "</script></textarea></title></style></option></math></svg>"
                  f"<img src=x onerror={HIT}>",
    "attribute": f'" autofocus tabindex=1 onfocus={HIT} x="',
    "attribute in single quotes": f"' autofocus tabindex=1 onfocus={HIT} onpointerover={HIT} x='",
    "address": f"javascript:{HIT}",
    "Markdown": f"[x](javascript:{HIT}) ![y]({AWAY}) | `<b>` | **b** <{AWAY}>",
    "Markdown spelled otherwise": f"[x](JaVaScRiPt:{HIT}) [x](java&#115;cript:{HIT}) "
                                  f"[x](&#x6A;avascript&colon;{HIT}) <javascript:{HIT}> "
                                  "[x](data:text/html;base64;PGI+) ![x](data:image/svg+xml;x)",
    "HTML spelled otherwise": f"]]></ScRiPt/x></noscript></xmp>--!><sCrIpT/x>{HIT}</sCrIpT> "
                              "&lt&#60b",
    "entities": f"&lt;img src=x onerror={HIT}&gt; &#x3c;b&#x3e; &amp;lt; &quot;",
    "template": "{{7*7}} {% raw %} {# ${" + HIT + "} #{7*7} %s %(x)s {0} {x!r}",
    "LaTeX": rf"\href{{javascript:{HIT}}}{{x}} \write18{{ls}} $\text{{<img src=x onerror={HIT}>}}$",
    "half a formula": r"$\frac{1} $$ \begin{x} \\ % \end{document} ^^M \input{/etc/passwd}",
    "MathML": f"<math><annotation-xml encoding='text/html'><img src=x onerror={HIT}>"
              f"</annotation-xml></math>",
    "SVG": f"<svg><a xlink:href='javascript:{HIT}'><animate attributeName=href>x</a>",
    "style": f"}}</style>*{{background:url({AWAY})}} url({AWAY}) expression({HIT})",
    "quotes": "'\"`´“”’ \\' \\\" `${" + HIT + "}`",
    "path": r"../../etc/passwd \..\CON NUL.html:stream |nul",
    "prototype": "__proto__",
    "constructor": "constructor",
    "right to left": f"\u202e<b>\u2066 {HIT} \u05d0",
    "no width": "\u200b\u200d\ufeff\u00ad",
    "beyond 16 bits": "🦾e\u0301\u0301\u0301\u0301",
    "spreadsheet": "=cmd|' /C calc'!A0",
    "sum of a spreadsheet": "-2+HYPERLINK(A1)",
    "Python": "__import__('os').system('touch hit')",
    "many tags": "<b>" * 60,
}
# Signs that no text has: a name with one of them is refused.
CONTROL = {"zero": "a\x00b", "escape": "\x1b[2J\x1b]0;x\x07", "lines": "a\nb",
           "end of a line": "a\n", "return": "a\rb", "line separator": "a\u2028b",
           "half a character": "\ud83e"}

# What kinds of elements a document has, and what has run in it or could be run.
SEEN = f"""() => ({{
    hit: window.hit ?? null,
    kinds: [...new Set([...document.querySelectorAll('*')].map(node => node.localName))],
    names: [...new Set([...document.querySelectorAll('*')].flatMap(
        node => node.getAttributeNames()))],
    links: [...document.querySelectorAll('[href], [src], [action], [formaction]')].flatMap(node =>
        ['href', 'src', 'action', 'formaction'].map(name => node.getAttribute(name) ?? ''))
        .filter(link => /^\\s*(javascript:|vbscript:|data:text)/i.test(link)
            || link.startsWith('{AWAY}')),
    handlers: [...document.querySelectorAll('*')].flatMap(node => node.getAttributeNames())
        .filter(name => name.startsWith('on') || name === 'autofocus'),
}})"""


def in_one_line(text):
    """The words of a text, as a page shows them."""
    return re.sub(r"[ \t\n]+", " ", text).strip()
