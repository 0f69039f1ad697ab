"""Predictions of lesson 09, the workspace."""
from __future__ import annotations

from ...answers.prediction import Asked, Choice, Mark, Number, Several
from ...arms import robots
from ...views.arm_view import ArmView
from ..views.reach import reach_view
from ..views.workspace import dexterous_view, limits_view, ring_view

# ---- Section 1: two links -------------------------------------------------------------

_SHAPE = Choice(
    ask="Link 1 is 1 m long, link 2 is 0.6 m, and both joints turn all the way round. Which shape "
        "do the points fill that the tool Q can reach?",
    why="Joint 1 turns whatever joint 2 has made, so the shape is made of full circles about O. "
        "Nearer than 0.4 m Q cannot come: links of different length leave a hole.",
    options={"a disc about O": "Fold the arm: link 2 is too short to bring Q back to O.",
             "a ring about O": "",
             "half a ring": "Joint 1 turns all the way round, and all it carries with it.",
             "two circles": "The elbow takes every angle between stretched and folded."},
    right="a ring about O", start={"swept": 0}, shows={"swept": 100})

_TURN = [
    Mark(ask="θ₁ = 35°, and Q is 1.4 m from O. Joint 1 alone turns on by 85°, to θ₁ = 120°. Where "
             "will the tool Q be?",
         why="Joint 1 turns the whole arm about O, so Q stays on its circle of 1.4 m and goes on "
             "by 85°.",
         of="point-Q", start={"theta_1": 35, "theta_2": 60, "swept": 0}, shows={"theta_1": 120},
         tolerance=0.15,
         slips=[((-0.5523, 1.4637, 0), "That is link 1 turned by 85°, and link 2 as it was: all of "
                 "the arm turns."),
                ((-0.7, 1.2124, 0), "That is at 120°. Q was at 57° before, not at 35°: it goes on "
                 "from there.")]),
    Mark(ask="θ₁ = 35°. Joint 2 alone folds the arm, from θ₂ = 60° to θ₂ = 180°. Where will the "
             "tool Q be?",
         why="Folded, link 2 lies back over link 1: Q is 1 − 0.6 = 0.4 m from O, along link 1.",
         of="point-Q", start={"theta_1": 35, "theta_2": 60, "swept": 0}, shows={"theta_2": 180},
         tolerance=0.12,
         slips=[((1.3106, 0.9177, 0), "That is the stretched arm, θ₂ = 0°."),
                ((0, 0, 0), "Link 2 is shorter than link 1: it does not reach back to O.")]),
]


def _nearest(l1: float, l2: float, right: float, *slips: tuple[float, str]) -> Number:
    return Number(
        ask=f"Link 1 is {l1:g} m long and link 2 is {l2:g} m. How near to O can the tool come?",
        why=f"Folded, link 2 lies back over link 1: |{l1:g} − {l2:g}| = {right:g} m. A distance is "
            "never negative, whichever link is longer.",
        right=right, unit="m", tolerance=0.01, slips=slips,
        start={"theta_1": 35, "theta_2": 60, "l_1": l1, "l_2": l2, "swept": 0},
        shows={"theta_2": 180, "swept": 100})


_FOLD = [
    _nearest(1.0, 0.6, 0.4, (0, "It would have to fold back onto O, but link 2 is too short."),
             (1.6, "That is how far it reaches.")),
    _nearest(0.5, 0.8, 0.3, (-0.3, "A distance is never negative."),
             (1.3, "That is how far it reaches."), (0, "Link 2 reaches beyond O.")),
]

# ---- Section 2: limits ----------------------------------------------------------------

_CURVES = {"an arc about O": "About O joint 1 turns.", "an arc about P": "About P joint 2 turns.",
           "a straight line": "Each joint turns, and what turns draws an arc."}
_SIDES = [
    Choice(ask="θ₂ is held at its limit, 150°, and θ₁ sweeps its range. Which curve does the tool "
               "draw?",
           why="Only joint 1 moves, and it turns the arm about O, as stiff as it is.",
           options=_CURVES | {"an arc about O": ""}, right="an arc about O"),
    Choice(ask="θ₁ is held at its limit, 130°, and θ₂ sweeps its range. Which curve does the tool "
               "draw?",
           why="Only joint 2 moves, and it turns link 2 about the elbow P, which stands still.",
           options=_CURVES | {"an arc about P": ""}, right="an arc about P"),
]

_CORNERS = [
    Mark(ask="θ₁ goes from −20° to 130°, θ₂ from 0° to 150°. s₁ and s₂ say how far each joint is "
             "on its way. Where will Q be with s₁ = 0 % and s₂ = 100 %?",
         why="θ₁ is at its lower limit, −20°, and θ₂ at its upper one, 150°: Q is in the inner "
             "corner of the region, 0.57 m from O.",
         of="point-Q", start={"s_1": 50, "s_2": 40}, shows={"s_1": 0, "s_2": 100}, tolerance=0.12,
         slips=[((1.5035, -0.5472, 0), "That is s₂ = 0 %, the arm stretched: θ₂ = 0°."),
                ((-0.5386, 0.1752, 0), "That is s₁ = 100 %: θ₁ = 130°.")]),
    Mark(ask="θ₁ goes from −20° to 130°, θ₂ from 0° to 150°. Now s₁ = 100 % and s₂ = 0 %: where "
             "will Q be?",
         why="θ₁ is at 130° and θ₂ at 0°: the arm is stretched, 1.6 m long.",
         of="point-Q", start={"s_1": 50, "s_2": 40}, shows={"s_1": 100, "s_2": 0}, tolerance=0.12,
         slips=[((1.5035, -0.5472, 0), "That is s₁ = 0 %: θ₁ = −20°."),
                ((-0.5386, 0.1752, 0), "That is s₂ = 100 %, the arm bent by 150°.")]),
]

_EDGE = Choice(
    ask="The outer edge is drawn by the arm with θ₂ = 0°, its lower limit. Now that limit goes "
        "down to −90°. What will draw the outer edge?",
    why="The stretched arm, θ₂ = 0°, still reaches farthest. But 0° is now in the middle of the "
        "range: this edge belongs to no limit.",
    options={"the arm with θ₂ = −90°": "Bent by 90° it reaches only 1.17 m.",
             "the stretched arm, as before": "",
             "joint 1 at its limits": "They draw the ends of the fan."},
    right="the stretched arm, as before", start={"from_2": 0}, shows={"from_2": -90, "s_2": 0})

_NEAREST = Number(
    ask="θ₂ goes from 0° to 150°. What is the smallest distance of the tool from O? (r² = l₁² + "
        "l₂² + 2 l₁ l₂ cos θ₂, with 1 m and 0.6 m.)",
    why="The arm folds most at θ₂ = 150°: r² = 1 + 0.36 + 1.2 cos 150° = 0.321, so r = 0.566 m.",
    right=0.5664, unit="m", tolerance=0.01, start={"s_1": 50, "s_2": 40}, shows={"s_2": 100},
    slips=[(0.4, "That is the arm folded to 180°, beyond the limit."),
           (0.321, "That is r²: take the root."),
           (1.549, "The sign of cos 150° is lost: it is negative.")])

# ---- Sections 3 and 4: samples --------------------------------------------------------

_DENSE = Choice(
    ask="All pairs of joint values are tried equally often, with both joints turning all the way "
        "round. Where do the tool positions gather?",
    why="Where the arm is nearly stretched or folded, a small change of θ₂ hardly changes r: many "
        "joint values lead to nearly the same distance. That is at both edges.",
    options={"in the middle of the ring": "There a change of θ₂ changes r most: samples are thin.",
             "at the outer edge only": "The folded arm is singular as well.",
             "at both edges": "",
             "nowhere, they are spread evenly": "Equal steps in the joints are not equal steps in "
             "the room."},
    right="at both edges")

_ENOUGH = Choice(
    ask="Squares of 5 cm are laid over the ring, and those that hold a sample are counted. The "
        "true area is 7.54 m². What do 1 000 samples give, and what does a million?",
    why="With 1 000 samples most squares stay empty. With a million each square that the ring "
        "touches counts, also those that lie partly outside.",
    options={"too little, then the right area": "Squares at the edge count in full.",
             "too little, then too much": "",
             "too much both times": "There are some 3 000 squares, more than samples.",
             "too much, then too little": "More samples can only fill more squares."},
    right="too little, then too much")

_GRID = Number(
    ask="A grid takes 10 values for each of the five joints of the Alpha II: 100 000 poses. To how "
        "many different points of the tip do they lead?",
    why="The tool roll, joint 5, does not move the tip: its ten values all give the same point. So "
        "the lecture was right to stop at theta 4.",
    right=10_000, tolerance=1,
    slips=[(100_000, "That many poses; but one joint does not move the tip."),
           (50, "Every value of one joint goes with every value of the others: multiply.")])

# ---- Section 5: the Alpha II ----------------------------------------------------------


def _alpha() -> ArmView:
    return ArmView(robots.alpha_ii(), show=("names",))


_ALPHA = {f"theta_{k}": value for k, value in enumerate((0, 0, 0, -90, 0), start=1)}
_REACH = [
    Mark(ask="The Alpha II: shoulder 215 mm up, links of 177.8 mm each, tool 129.5 mm. It is "
             "stretched along x₀. The shoulder lifts it to the upright, θ₂ = −90°. Where is the "
             "tip, the top of the workspace?",
         why="215 + 177.8 + 177.8 + 129.5 = 700.1 mm: the farthest points form a circle of 485.1 "
             "mm about the shoulder.",
         start=_ALPHA, shows={"theta_2": -90}, seen="front", axes="xz", tolerance=45,
         slips=[((0, 0, 485.1), "The circle is about the shoulder, which is 215 mm up."),
                ((0, 0, 570.6), "The tool is stretched, too: 129.5 mm more.")]),
    Mark(ask="The base cannot turn right round, so at the back the arm leans over backwards. Its "
             "shoulder stops at θ₂ = −120°. From upright it goes there: where is the tip?",
         why="30° beyond the upright: x = −485.1 sin 30° = −242.5 mm and z = 215 + 485.1 cos 30° = "
             "635.1 mm.",
         start=_ALPHA | {"theta_2": -90}, shows={"theta_2": -120}, seen="front", axes="xz",
         tolerance=45,
         slips=[((242.5, 0, 635.1), "That is θ₂ = −60°, still in front."),
                ((-485.1, 0, 215), "For that it would have to turn to θ₂ = −180°.")]),
]

_SLICE = Choice(
    ask="The plane cuts the cloud at y = 0: on the right a large arc, on the left less. The base "
        "turns by 150° to either side. The plane is turned on, past 30°. What will be on its left "
        "side?",
    why="Farther than 30° from x₀ the base can point to both sides of the plane: both halves are "
        "full, and the section is a disc.",
    options={"less and less": "The base comes closer to that side as the plane turns.",
             "the same as before": "Up to 30° it is; beyond, the base can point to that side.",
             "the full half of a disc": ""},
    right="the full half of a disc", start={"slice": 0}, shows={"slice": 40})

_LEVEL = Choice(
    ask="Now a level cut at the height of the shoulder, seen from above. Which outline will it "
        "have?",
    why="The base misses 360° − 300° = 60° behind the arm. Leaning over backwards the arm gets "
        "some of that, but not the outer part.",
    options={"a full circle": "Behind the arm the base cannot point.",
             "a disc without a wedge of 60°": "",
             "a disc without a wedge of 30°": "It is 30° on either side of the back.",
             "half a disc": "The base turns by 150° to either side, not by 90°."},
    right="a disc without a wedge of 60°")

_POINTS = Several(
    ask="Which of these points (mm) can the Alpha II reach? Its shoulder is at (0, 0, 215), "
        "stretched it is 485.1 mm long, and at the back it reaches less.",
    why="(500, 0, 300) is √(500² + 85²) = 507.2 mm from the shoulder, too far. (−400, 0, 200) is "
        "near enough, but there the limits hold the arm back.",
    options={"(300, 0, 400)": "It is 352 mm from the shoulder, in front.",
             "(500, 0, 300)": "It is 507.2 mm from the shoulder.",
             "(−400, 0, 200)": "It is behind the arm, where base and shoulder meet their "
             "limits."},
    right=("(300, 0, 400)",))

# ---- Sections 7 and 8 -----------------------------------------------------------------

_CIRCLE = [
    Mark(ask="The tool is 0.2 m long, from the wrist W to Q. It can point in every direction as "
             "long as the whole circle of wrists is in the pale ring, 0.4 to 1.6 m. Q goes out "
             "along x. Where is the last such place?",
         why="At r = 1.6 − 0.2 = 1.4 m the circle touches the outer edge from inside.",
         of="point-Q", axes="x", start={"r": 0.9, "phi": 50}, shows={"r": 1.4, "phi": 180},
         tolerance=0.05,
         slips=[((1.6, 0, 0), "There half of the circle is outside."),
                ((1.8, 0, 0), "That is the farthest Q, with one direction only.")]),
    Mark(ask="The tool is 0.2 m long, and the pale ring goes from 0.4 to 1.6 m. Q comes in along "
             "x. Where is the nearest place at which the tool can point in every direction?",
         why="At r = 0.4 + 0.2 = 0.6 m the circle touches the hole from outside.",
         of="point-Q", axes="x", start={"r": 0.9, "phi": 50}, shows={"r": 0.6, "phi": 0},
         tolerance=0.05,
         slips=[((0.4, 0, 0), "There half of the circle is in the hole."),
                ((0.2, 0, 0), "That is the nearest Q, with one direction only.")]),
]

_BACK = Choice(
    ask="The Intelledex: two links of 304.8 mm, a tool of 228.6 mm, no limits. Can it fold up so "
        "far that its tip touches its own shoulder?",
    why="The three lengths form a triangle: 228.6 is less than 304.8 + 304.8. With the elbow at "
        "−136° and the tool folded in, the tip is back at the shoulder.",
    options={"yes": "", "no, the tool is too short": "With equal links the wrist can come as near "
             "to the shoulder as one likes, so also to 228.6 mm.",
             "no, the links are too long": "Links of equal length fold onto each other."},
    right="yes", start={"theta_4": 0, "theta_5": 90}, shows={"theta_4": -135.95, "theta_5": -22.02})


def _intelledex() -> ArmView:
    return ArmView(robots.intelledex_660t(), show=("names",))


PREDICTIONS: dict[str, Asked] = {
    "workspace.shape": Asked(ring_view, [_SHAPE]),
    "workspace.turn": Asked(ring_view, _TURN),
    "workspace.fold": Asked(ring_view, _FOLD),
    "workspace.sides": Asked(None, _SIDES),
    "workspace.corners": Asked(limits_view, _CORNERS),
    "workspace.edge": Asked(limits_view, [_EDGE]),
    "workspace.nearest": Asked(limits_view, [_NEAREST]),
    "workspace.dense": Asked(None, [_DENSE]),
    "workspace.enough": Asked(None, [_ENOUGH]),
    "workspace.grid": Asked(None, [_GRID]),
    "workspace.reach": Asked(_alpha, _REACH),
    "workspace.slice": Asked(reach_view, [_SLICE]),
    "workspace.level": Asked(None, [_LEVEL]),
    "workspace.points": Asked(None, [_POINTS]),
    "workspace.circle": Asked(dexterous_view, _CIRCLE),
    "workspace.back": Asked(_intelledex, [_BACK]),
}
