"""What a text leaves open: a question with its answers."""
from __future__ import annotations

Options = tuple[tuple[str, dict[str, str]], ...]


class Ambiguous(ValueError):
    """A text may be read in more than one way; `options` are the answers.

    Attributes
    ----------
    question : str
        What to ask.
    options : tuple of (label, choices)
        What to call each answer, and the arguments of `read_table` that give it.

    Examples
    --------
    >>> error = Ambiguous("Are the angles in degrees?", (("degrees", {"angles": "deg"}),))
    >>> str(error)
    'text: Are the angles in degrees? From Python: load(text, angles="deg")'
    """

    def __init__(self, question: str, options: Options) -> None:
        calls = " or ".join(
            f"load(text, {', '.join(f'{name}={value!r}' for name, value in choices.items())})"
            for _, choices in options).replace("'", '"')
        super().__init__(f"text: {question} From Python: {calls}")
        self.question, self.options = question, options
