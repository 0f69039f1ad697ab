"""Predictions of lesson 03, homogeneous transforms."""
from __future__ import annotations

from functools import partial
from math import sqrt

from ...answers.prediction import Asked, Choice, Direction, Mark, Number, Several, Signs
from ..views.homogeneous import chain, combined, fixed, order, seen_back, spatial
from . import angle

# ---- Slide and turn together ------------------------------------------------------------


def _combined(theta: str, degrees: float, turned: str, place: str, slips: list) -> Mark:
    return Mark(
        ask=f"c is fixed in frame 1, at c¹ = (1.5, 1). Frame 1 turns to θ = {theta}; its origin "
            "stays at (1.5, −1). Where will c be?",
        why=f"The turn takes (1.5, 1) to R₁⁰ c¹ = {turned}. With o₁⁰ = (1.5, −1) that makes "
            f"c⁰ = {place}.",
        start={"theta": 0}, shows={"theta": degrees}, of="point-c", tolerance=0.2,
        slips=[*slips, ((3, 0, 0), "There c is without a turn.")])


_ALONE = "That is R₁⁰ c¹ alone, from the origin of frame 0. Add o₁⁰ = (1.5, −1)."
_COMBINED = [
    _combined("90°", 90, "(−1, 1.5)", "(0.5, 0.5)", [
        ((-1, 1.5, 0), _ALONE),
        ((2.5, 0.5, 0), "The turn takes 1 along y₁ to the left, not to the right."),
        ((2.5, -2.5, 0), "That is a turn clockwise.")]),
    _combined("180°", 180, "(−1.5, −1)", "(0, −2)", [
        ((-1.5, -1, 0), _ALONE), ((0, 0, 0), "y₁ points down at 180°, so 1 along y₁ goes down.")]),
    _combined("−90°", -90, "(1, −1.5)", "(2.5, −2.5)", [
        ((1, -1.5, 0), _ALONE), ((0.5, 0.5, 0), "That is the turn by +90°.")]),
]

# ---- Many frames ------------------------------------------------------------------------

_STRAIGHT = ((3.6, 2.7, 0), "There it is without the turn. It comes after that joint, so it moves.")
_WHOLE = (-2.7, 3.6, 0)
_CHAIN = [
    Mark(ask="All three angles are 0, and every frame stands at (1.2, 0.9) in the one before. Now "
             "θ₂ goes to 90°. Where will the origin of frame 3 be?",
         why="The origin of frame 2 stays at (2.4, 1.8). From there (1.2, 0.9) is turned to "
             "(−0.9, 1.2), which leads to (1.5, 3).",
         start={"theta_1": 0, "theta_2": 0, "theta_3": 0}, shows={"theta_2": 90},
         of="frame-3-x", tolerance=0.2,
         slips=[_STRAIGHT, (_WHOLE, "That turns the whole chain. Only what comes after joint 2 "
                                    "turns.")]),
    Mark(ask="All three angles are 0, and every frame stands at (1.2, 0.9) in the one before. Now "
             "θ₁ goes to 90°. Where will the origin of frame 3 be?",
         why="The origin of frame 1 stays at (1.2, 0.9). From there two arrows are turned to "
             "(−0.9, 1.2) each, which leads to (−0.6, 3.3).",
         start={"theta_1": 0, "theta_2": 0, "theta_3": 0}, shows={"theta_1": 90},
         of="frame-3-x", tolerance=0.2,
         slips=[_STRAIGHT, (_WHOLE, "That turns o₁⁰, too. But frame 1 turns about its own origin, "
                                    "at the tip of o₁⁰.")]),
]

_ROWS = Several(
    ask="Only θ₂ moves. Which of the four arrows get other numbers, seen from frame 0?",
    why="θ₂ stands in R₂¹ only, and that factor enters with the third arrow. All that comes after "
        "joint 2 turns with it.",
    shows={"theta_2": -20}, right=("R₁⁰R₂¹ o₃²", "R₁⁰R₂¹R₃² c³"),
    options={"o₁⁰": "It comes before both turns; no θ is in it.",
             "R₁⁰ o₂¹": "θ₁ is in R₁⁰. θ₂ turns frame 2 about its own origin, the tip of this "
                        "arrow.",
             "R₁⁰R₂¹ o₃²": "θ₂ is in R₂¹.", "R₁⁰R₂¹R₃² c³": "θ₂ is in R₂¹."})

_LETTERS = Number(
    ask="For n = 1 the formula c⁰ = o₁⁰ + R₁⁰ c¹ holds one letter R, for n = 2 it holds three. How "
        "many letters R does it hold for n = 6?",
    why="The seven terms hold 0, 1, 2, 3, 4, 5 and 6 of them: 21 together.",
    right=21, tolerance=0.4,
    slips=[(6, "There are six different R, but each of them stands in many terms."),
           (11, "It does not grow by two each time. n = 3 adds a term with three R."),
           (7, "That is the number of terms."), (15, "That is for n = 5.")])

_PRODUCTS = [
    Number(ask="The first component of c⁰ is a sum of 3 products for n = 1 and of 7 for n = 2. Of "
               "how many for n = 3?",
           why="Each step puts a sine or a cosine before all that was there, for x and for y, and "
               "adds one: 2 · 7 + 1 = 15.",
           right=15, tolerance=0.4,
           slips=[(11, "It does not grow by 4 each time."), (14, "Twice 7, and one more: x₁ itself."
                                                                 ""),
                  (10, "It grows faster than that: it more than doubles.")]),
    Number(ask="The first component of c⁰ is a sum of 3 products for n = 1, of 7 for n = 2 and of "
               "15 for n = 3. Of how many for n = 6?",
           why="Each step doubles the number and adds one: 31, 63, 127.",
           right=127, tolerance=0.4,
           slips=[(31, "That is for n = 4."), (63, "That is for n = 5."),
                  (30, "It does not double with n: it doubles with every single frame."),
                  (120, "Doubling alone is not enough: every step adds one, too.")]),
]

_ZERO = Choice(
    ask="Append a 0 to c¹ in place of the 1, and multiply by H. What becomes of the translation?",
    why="The last column of H is multiplied by the 0, so only R₁⁰ c¹ is left: a direction is "
        "turned, not moved.",
    right="it drops out",
    options={"it is added as before": "The appended number multiplies the last column, which holds "
                                      "the origin.",
             "it drops out": "",
             "it changes its sign": "0 times the origin is 0, not minus the origin.",
             "the product does not exist": "Three numbers meet three columns: it exists."})

# ---- The way back -----------------------------------------------------------------------

_BACK = Choice(
    ask="Frame 1 has its origin at o₁⁰ = (2, 0) and turns to θ = 90°. Where is the origin of frame "
        "0, seen from frame 1?",
    why="From frame 1 you go 2 to the left, and left is +y₁ there: o₀¹ = −(R₁⁰)ᵀ o₁⁰ = (0, 2).",
    start={"o_x": 2, "o_y": 0, "theta": 0}, shows={"theta": 90}, right="(0, 2)",
    options={"(−2, 0)": "That is the way back seen from frame 0. Frame 1 is turned.",
             "(2, 0)": "That is o₁⁰ itself, the other way and seen from frame 0.",
             "(0, −2)": "The way back goes to the left. There +y₁ points at θ = 90°.",
             "(0, 2)": ""})

_TRANSPOSE = Choice(
    ask="A rotation matrix is inverted by its transpose. Is a homogeneous matrix, too?",
    why="Hᵀ carries the origin in its last row, where only 0 0 1 may stand. With o = 0 nothing is "
        "wrong with it.",
    right="only if o = 0",
    options={"always": "Write Hᵀ down: where does the origin stand?",
             "only if o = 0": "", "only if θ = 0": "Then H is a slide. Its inverse slides back, by "
                                                   "−o.",
             "never": "If nothing slides, H is a rotation, with a 1 added."})

# ---- The order of motions ---------------------------------------------------------------

_ROOT = sqrt(3)
_ALONG_X = (2, 0, 0)
_ORDER = [
    Mark(ask="Frame B turns by 60°. Then it slides by 2 along its own x axis. Where will its "
             "origin be?",
         why="Its own x axis points to 60° when it slides: 2 (cos 60°, sin 60°) = (1, 1.73).",
         start={"t": 0}, shows={"t": 2}, of="frame-B-x", tolerance=0.2,
         slips=[(_ALONG_X, "That is along x₀. B has turned first, and slides along its own x axis."
                           ""),
                ((_ROOT, 1, 0), "That is at 30°. The turn is by 60°.")]),
]

_FIXED = [
    Mark(ask="Frame F slides by 2 along x₀. Then it turns by 60° about the origin of frame 0. "
             "Where will its origin be?",
         why="It runs on a circle of radius 2 about the origin, by 60°: to (1, 1.73). There B "
             "ended, too.",
         start={"t": 0}, shows={"t": 2}, of="frame-F-x", tolerance=0.2,
         slips=[(_ALONG_X, "It does not stay there: the turn is about the origin of frame 0, which "
                           "is 2 away."),
                ((_ROOT, 1, 0), "That is at 30°. The turn is by 60°.")]),
]

# ---- In space ---------------------------------------------------------------------------

_entries = partial(Signs, rows=("x₀", "y₀", "z₀", "1"), columns=("x₁", "y₁", "z₁", "o₁"),
                   among={"s": "stays", "c": "changes"})
_SPACE = [
    _entries(ask="You drag φ, the turn about the frame's own x axis. Which entries of H₁⁰ change?",
             why="That turn is about x₁ itself, so column 1 stays, and the origin stays, too. The "
                 "last row never changes.",
             shows={"phi": 75}, right=("sccs", "sccs", "sccs", "ssss")),
    _entries(ask="You drag the slide along y₀. Which entries of H₁⁰ change?",
             why="A slide moves the origin and turns nothing: only the y of the last column "
                 "changes.",
             shows={"o_y": -0.5}, right=("ssss", "sssc", "ssss", "ssss")),
]


def _heading(theta: float, phi: float) -> Direction:
    told, turn = angle(theta), angle(phi)
    return Direction(
        ask=f"Frame 1 turns about its own z by θ = {told}, then about its own x by φ = {turn}. "
            "Which way will x₁ point, seen from the top?",
        why=f"θ takes x₁ to {told} from x₀. The second turn is about x₁ itself and leaves it there."
            "",
        start={"theta": 0, "phi": 0}, shows={"theta": theta, "phi": phi}, of="frame-1-x",
        slips=[(theta + phi, "You added φ. That turn is about x₁ itself, so x₁ stays."),
               (0, "θ turns x₁ away from x₀.")])


PREDICTIONS: dict[str, Asked] = {
    "homogeneous.combined": Asked(combined, _COMBINED),
    "homogeneous.chain": Asked(chain, _CHAIN),
    "homogeneous.rows": Asked(chain, [_ROWS]),
    "homogeneous.letters": Asked(None, [_LETTERS]),
    "homogeneous.products": Asked(None, _PRODUCTS),
    "homogeneous.zero": Asked(None, [_ZERO]),
    "homogeneous.back": Asked(seen_back, [_BACK]),
    "homogeneous.transpose": Asked(None, [_TRANSPOSE]),
    "homogeneous.order": Asked(order, _ORDER),
    "homogeneous.fixed": Asked(fixed, _FIXED),
    "homogeneous.space": Asked(spatial, _SPACE),
    "homogeneous.heading": Asked(spatial, [_heading(120, -60), _heading(-135, 90)]),
}
