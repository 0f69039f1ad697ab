"""The predictions of lessons that have many, a module each."""


def said(value: float) -> str:
    """A number in a sentence: with a minus sign, not with a hyphen."""
    return f"{value:g}".replace("-", "−")
