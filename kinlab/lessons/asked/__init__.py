"""The predictions of lessons that have many, a module each, and numbers as sentences have them."""


def said(value: float) -> str:
    """A number in a sentence: with a minus sign, not with a hyphen, and none before zero."""
    return f"{value + 0.0:g}".replace("-", "−")


def angle(degrees: float) -> str:
    """An angle in a sentence."""
    return f"{said(degrees)}°"


def pair(x: float, y: float) -> str:
    """A point of the plane in a sentence."""
    return f"({said(x)}, {said(y)})"
