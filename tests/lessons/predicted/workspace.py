"""Lesson 09: by trigonometry, and by poses of the arms."""
import numpy as np

import kinlab as kl

from . import Held


def tool(turn, bend, l1=1.0, l2=0.6):
    """The tool of the planar arm, angles in degrees."""
    one, both = np.radians(turn), np.radians(turn + bend)
    return [l1 * np.cos(one) + l2 * np.cos(both), l1 * np.sin(one) + l2 * np.sin(both), 0]


def tip(*degrees):
    return kl.forward_kinematics(kl.robots.alpha_ii(), np.radians(degrees))[:3, 3]


TURNS = kl.workspace(kl.Arm([kl.revolute(a=1), kl.revolute(a=0.6)]), 20_000)
RADII = np.linalg.norm(TURNS.points, axis=1)
COUNTED = np.histogram(RADII, np.linspace(0.4, 1.6, 7))[0] / (np.pi * np.diff(
    np.linspace(0.4, 1.6, 7)**2))
assert COUNTED.argmin() in (2, 3, 4) and COUNTED[0] > COUNTED[3] < COUNTED[5]  # at both edges
GRID = np.stack(np.meshgrid(*[np.linspace(*link.limits, 10) for link in
                              kl.robots.alpha_ii().links]), axis=-1).reshape(-1, 5)
DIFFERENT = len(np.unique(np.round(kl.forward_kinematics(kl.robots.alpha_ii(), GRID)[:, :3, 3], 6),
                          axis=0))
POINTS = {"(300, 0, 400)": (300, 0, 400), "(500, 0, 300)": (500, 0, 300),
          "(−400, 0, 200)": (-400, 0, 200)}
REACHED = [name for name, point in POINTS.items()
           if kl.inverse_kinematics(kl.robots.alpha_ii(), point).success]
FOLDED = kl.inverse_kinematics(kl.robots.intelledex_660t(), [0, 0, 373.4])
assert FOLDED.success  # so the answer of "back" is yes

PREDICTED = {
    "workspace.shape": [Held("a ring about O", [("a disc about O", "too short"),
                                                ("half a ring", "all the way round"),
                                                ("two circles", "every angle")])],
    "workspace.turn": [
        Held(tool(120, 60), [(tool(120, 0, 1.4, 0), "57°"), (tool(35, 60), "away"),
                             (tool(120, 95 - 120), "all of the arm turns")]),
        Held(tool(35, 180), [(tool(35, 0), "stretched"), ((0, 0, 0), "shorter")])],
    "workspace.fold": [
        Held(1 - 0.6, [(0, "too short"), (1.6, "how far it reaches"), (-0.4, "too little")]),
        Held(0.8 - 0.5, [(-0.3, "never negative"), (1.3, "how far it reaches")])],
    "workspace.sides": [
        Held("an arc about O", [("an arc about P", "joint 2"), ("a straight line", "an arc")]),
        Held("an arc about P", [("an arc about O", "joint 1"), ("a straight line", "an arc")])],
    "workspace.corners": [
        Held(tool(-20, 150), [(tool(-20, 0), "stretched"), (tool(130, 150), "100 %")]),
        Held(tool(130, 0), [(tool(-20, 0), "0 %"), (tool(130, 150), "bent by 150°")])],
    "workspace.edge": [Held("the stretched arm, as before",
                            [("the arm with θ₂ = −90°", "1.17 m"),
                             ("joint 1 at its limits", "ends of the fan")])],
    "workspace.nearest": [Held(np.linalg.norm(tool(0, 150)),
                               [(0.4, "beyond the limit"), (0.321, "take the root"),
                                (1.549, "negative")])],
    "workspace.dense": [Held("at both edges", [("in the middle of the ring", "thin"),
                                               ("at the outer edge only", "singular as well")])],
    "workspace.enough": [Held("too little, then too much",
                              [("too little, then the right area", "in full"),
                               ("too much both times", "3 000 squares")])],
    "workspace.grid": [Held(DIFFERENT, [(100_000, "does not move the tip"), (50, "multiply")])],
    "workspace.reach": [
        Held(tip(0, -90, 0, -90, 0), [((0, 0, 485.1), "215 mm up"),
                                      ((0, 0, 570.6), "129.5 mm more")]),
        Held(tip(0, -120, 0, -90, 0), [((242.5, 0, 635.1), "still in front"),
                                       ((-485.1, 0, 215), "−180°")])],
    "workspace.slice": [Held("the full half of a disc", [("less and less", "comes closer"),
                                                         ("the same as before", "Up to 30°")])],
    "workspace.level": [Held("a disc without a wedge of 60°",
                             [("a full circle", "cannot point"),
                              ("a disc without a wedge of 30°", "either side")])],
    "workspace.points": [Held(REACHED, [(list(POINTS), "507.2"), ([], "in front")])],
    "workspace.circle": [
        Held([1.6 - 0.2, 0, 0], [((1.6, 0, 0), "outside"), ((1.8, 0, 0), "farthest")]),
        Held([0.4 + 0.2, 0, 0], [((0.4, 0, 0), "in the hole"), ((0.2, 0, 0), "nearest Q")])],
    "workspace.back": [Held("yes", [("no, the tool is too short", "as near"),
                                    ("no, the links are too long", "fold onto")])],
}
