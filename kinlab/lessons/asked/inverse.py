"""Predictions of lesson 10, inverse kinematics."""
from __future__ import annotations

from ...answers.prediction import Asked, Choice, Mark, Number
from ...arms import robots
from ...views.arm_view import ArmView
from ...views.live import LiveView
from ...views.studies import velocity_view
from ..views.inverse import (
    eight_view,
    leap_view,
    newton_view,
    race_view,
    stop_view,
    tilt_view,
    unreachable_view,
)


def _two_links() -> ArmView:
    return ArmView(robots.two_link(), show=())


def _arrows() -> LiveView:
    return velocity_view(robots.two_link())


# ---- Section 1: the question turned round -----------------------------------------------

_COUNT = Choice(
    ask="The arm has two links of 1 m each. How many different poses bring its tool to a point "
        "1.5 m away from the base?",
    why="The elbow can be on either side of the line from the base to the tool: two poses. Only "
        "stretched, 2 m out, are they one.",
    options={"one": "Hold your hand still: your elbow can still be elsewhere.", "two": "",
             "infinitely many": "That is so for the base itself, and for arms with more joints."},
    right="two")


def _other(ask: str, start: tuple[float, float], shows: tuple[float, float],
           slips: list) -> Mark:
    return Mark(
        ask=ask, why="The two links and the line from the base to the tool form a triangle. The "
        "other pose is its mirror image in that line.",
        of="frame-2-x", start=dict(zip(("theta_1", "theta_2"), start)),
        shows=dict(zip(("theta_1", "theta_2"), shows)), tolerance=0.15, slips=slips)


_ELBOW = [
    _other("The tool is at (1.2, 0.9), with the elbow on the right of the line to it. In the "
           "other pose the tool is at the same point. Where will the elbow be?",
           (-4.54, 82.82), (78.28, -82.82),
           [((1.2, 0.9, 0), "That is the tool, which stays."),
            ((0.6, 0.45, 0), "Half-way the elbow would be if the arm were stretched to 1.2 m and "
             "0.9 m; each link is 1 m long.")]),
    _other("The tool is at (0, 1). Where will the elbow be in the other pose?",
           (30, 120), (150, -120),
           [((0, 1, 0), "That is the tool, which stays."),
            ((0.866, -0.5, 0), "That is the mirror image in the x axis; mirror the elbow in the "
             "line from the base to the tool.")]),
]


def _beyond(x: float, y: float, theta_1: float) -> Mark:
    return Mark(
        ask=f"The tool must come as near as it can to the point ({x:g}, {y:g}), which is 3 m "
            "away. Both links are 1 m long. Where will the tool stop?".replace("-", "−"),
        why="Out of reach the best pose is the stretched arm, 2 m long, straight towards the "
            "point: two thirds of the way.",
        start={"theta_1": -30, "theta_2": 60}, shows={"theta_1": theta_1, "theta_2": 0},
        tolerance=0.15,
        slips=[((x / 3, y / 3, 0), "That is 1 m out: one link. The arm has two."),
               ((x, y, 0), "That is the point itself, out of reach.")])


_BEYOND = [_beyond(2.4, 1.8, 36.8699), _beyond(-1.8, 2.4, 126.8699)]

# ---- Section 2: small steps -------------------------------------------------------------

_LINEAR = Choice(
    ask="For a small step J Δq is a good guess of how the tool moves: 0.09 mm are missing. The "
        "step is made ten times as large. How much larger will the mistake be?",
    why="The guess leaves out the square of the step and what follows. Ten times the step makes "
        "its square a hundred times as large: 8.9 mm.",
    options={"as large as before": "The guess is exact only for no step at all.",
             "about ten times": "The guess itself grows ten times; its mistake grows faster.",
             "about a hundred times": ""},
    right="about a hundred times")

_LINES = {"link 1": "Link 1 leads from the base to the elbow: the tool is not on its line.",
          "link 2": "Link 2 joins the tool to the elbow, not to the base.",
          "the line from the base to the tool": "That line joins the tool to joint 1, not to "
          "joint 2.", "the x axis": "The arrow turns with the arm; the x axis does not."}
_BENT = {"theta_1": 30.0, "theta_2": 90.0}
_COLUMNS = [
    Choice(ask="The arrows J₁ and J₂ at the tool are columns of the Jacobian. The arm moves on. To "
               "which line will J₂ be at right angles in every pose?",
           why="Joint 2 turns the tool about the elbow, so it moves at right angles to the line "
               "from the elbow to the tool: link 2.",
           options=_LINES | {"link 2": ""}, right="link 2", start=_BENT,
           shows={"theta_1": 60, "theta_2": 130}),
    Choice(ask="To which line will J₁ be at right angles in every pose?",
           why="Joint 1 turns the tool about the base, so it moves at right angles to the line "
               "from the base to the tool.",
           options=_LINES | {"the line from the base to the tool": ""},
           right="the line from the base to the tool", start=_BENT,
           shows={"theta_1": 60, "theta_2": 130}),
    Choice(ask="The arm is stretched: θ₂ goes to 0°. What becomes of the two arrows, and of the "
               "ellipse of all velocities?",
           why="Stretched, both lines are one, so both arrows lie in one line and the ellipse is "
               "flat: w = |det J| = l₁ l₂ |sin θ₂| = 0.",
           options={"the arrows lie in one line, the ellipse is flat": "",
                    "the arrows are at right angles": "They would be if both lines were.",
                    "both arrows shrink to nothing": "The tool still moves fast, but across the "
                    "arm only."},
           right="the arrows lie in one line, the ellipse is flat", start=_BENT,
           shows={"theta_2": 0}),
]

# ---- Sections 3 and 4: Newton's method --------------------------------------------------

_FIRST = Choice(
    ask="The tool is 0.63 m away from the target. Newton takes one step. How far away will it be?",
    why="0.22 m: the linear guess is only roughly true for so large a step, and leads to about a "
        "third of the distance.",
    options={"0, it arrives": "It would if the tool moved in a straight line as fast as at first.",
             "about 0.2 m": "", "about 0.6 m, hardly nearer": "The arm is well bent; the guess is "
             "useful."},
    right="about 0.2 m", start={"step": 0}, shows={"step": 1})

_FAST = Choice(
    ask="Newton goes on, step by step. How will the error fall once the tool is near its goal?",
    why="0.63, 0.22, 0.02, 0.0002, 0.00000002 m: close to the target each error is about the "
        "square of the one before, so the number of right digits doubles.",
    options={"by the same factor each time": "The nearer the tool, the better the linear guess.",
             "it falls faster and faster": "",
             "it falls more and more slowly": "The guess gets better, not worse."},
    right="it falls faster and faster", start={"step": 0}, shows={"step": 4})

_LEAP = Choice(
    ask="Now the arm is almost stretched: θ₂ is less than 6°. The target is well inside the ring. "
        "By how much will Newton's first step turn the elbow?",
    why="By 1451°, four turns: the tool is to move inwards, there the joints hardly move it, and "
        "J⁻¹ divides by det J = sin θ₂ = 0.1.",
    options={"by less than 90°": "Inwards, a stretched arm moves slowly: it takes large turns.",
             "by about half a turn": "That would be enough to fold it, but Newton does not know.",
             "by several whole turns": ""},
    right="by several whole turns", start={"step": 0}, shows={"step": 1})

_STRETCHED = Choice(
    ask="And from an arm that is stretched exactly, θ₂ = 0°? What will Newton's first step be?",
    why="det J = sin θ₂ = 0, so J has no inverse, and there is no step at all.",
    options={"even larger": "So it would be for ever smaller θ₂; at 0 there is nothing to divide "
             "by.", "there is none": "", "zero, it stays": "The method says nothing, not even to "
             "stay: the equations have no solution."},
    right="there is none")

_NEVER = Choice(
    ask="The target (2, 1) is out of reach: the nearest the arm gets is 0.24 m. What do Newton's "
        "steps do?",
    why="Near its best the arm is stretched, and there it is singular: each time it comes near it "
        "is thrown off again.",
    options={"they come to rest at 0.24 m": "There the arm is stretched, so singular.",
             "they never settle": "",
             "there is no first step": "The arm begins bent, and J has an inverse."},
    right="they never settle", start={"step": 0}, shows={"step": 11})

# ---- Section 5: damping -----------------------------------------------------------------


def _factor(sigma: float, right: float, why: str, *slips: tuple[float, str]) -> Number:
    return Number(
        ask=f"In a direction where a joint rate of 1 gives the velocity σ = {sigma:g}, Newton "
            "multiplies the error by 1/σ. Damping puts σ / (σ² + λ²) in its place. What is that "
            "with λ = 0.1?",
        why=why, right=right, tolerance=0.02, slips=slips)


_FACTORS = [
    _factor(1, 1 / 1.01, "1 / (1 + 0.01) = 0.99: a good direction is hardly touched.",
            (0.909, "λ enters as its square, 0.01."), (1.1, "λ enters as its square, below.")),
    _factor(0.01, 0.01 / 0.0101, "0.01 / (0.0001 + 0.01) = 0.99 where Newton has 100: in a bad "
            "direction the step stays small.",
            (100, "That is Newton's 1/σ, without damping."), (0.0909, "λ enters as its square.")),
]

_RACE = Choice(
    ask="Both methods begin at the almost stretched arm of section 4. Which arrives first?",
    why="After five steps the damped tool is 0.02 mm from the target. Newton's arm still leaps "
        "about, and arrives after twelve, by luck.",
    options={"Newton": "Its first step turns the elbow four times round.", "damped": "",
             "both after as many steps": "They differ most just where the arm is singular."},
    right="damped", start={"step": 0}, shows={"step": 5})

_STOP = Mark(
    ask="The target ring (2, 1) is out of reach. The damped arm turns towards it. Where will its "
        "tool come to rest?",
    why="Stretched, straight towards the target, on the circle of 2 m: (1.79, 0.89), 0.24 m short.",
    of="damped-tool", start={"step": 0}, shows={"step": 15}, tolerance=0.08,
    begin=(0.5, 1, 0),
    slips=[((2, 1, 0), "That is the target, 2.24 m away: the arm is 2 m long.")])

# ---- Section 6: more joints, whole poses ------------------------------------------------

_ANSWERS = Choice(
    ask="The Alpha II has five joints. A target point asks for three numbers. How many sets of "
        "joint values bring the tip to a point well inside the workspace?",
    why="Two joints more than needed: choose the direction of the tool in the arm's plane and its "
        "roll as you like, and the other joints follow.",
    options={"two": "That is so for two links in a plane.", "eight": "That may be so for six "
             "joints and a whole pose.", "infinitely many": ""},
    right="infinitely many")

_SAME = Choice(
    ask="A pose is made from the joint values (0.3, 0.4, −0.5, 0.6, 0.5, 0.3). Inverse kinematics "
        "is asked for that pose, and begins at soft home. Will it find these values?",
    why="A pose of the tool belongs to several sets of joint values, and the search knows only the "
        "pose. It comes to the set that its steps lead to.",
    options={"yes, that is where the pose came from": "The pose does not remember.",
             "perhaps, perhaps others": "", "no, it cannot reach the pose": "It can: the values "
             "that made the pose are one way."},
    right="perhaps, perhaps others")

_SHAPES = Number(
    ask="Eight sets of joint values bring the tool of the Intelledex to this one pose. Look at the "
        "links only, not at frames and motors: in how many different places do they lie?",
    why="Two: elbow up or down. Four ways share each, and differ in the shoulder: θ₁ + 180°, −θ₂, "
        "θ₃ + 180° is the same arm (a ZYZ pair), and so it is with all pitch axes turned round.",
    right=2, tolerance=0.1, start={"way": 1}, shows={"way": 8},
    slips=[(8, "Step through them and watch the links: most look the same."),
           (4, "Watch the links only: the frame at the shoulder turns round, the links stay."),
           (1, "The elbow can be on either side.")])

_TILT = Choice(
    ask="The tool of the Alpha II must be at (300, 0, 80) mm and point down, but tilted by 20° to "
        "the side, about x: along z*. Which of its joints would have to do that?",
    why="Shoulder, elbow and tool pitch keep the tool in the upright plane of the arm, and the "
        "roll turns it about itself: 20° are missing.",
    options={"the base": "It turns the upright plane; the tip would leave its place.",
             "the tool pitch": "It tilts the tool forwards and backwards, in the upright plane.",
             "the tool roll": "It turns the tool about its own line, which stays upright.",
             "none can": ""},
    right="none can", start={"theta_2": -30, "theta_3": 60, "theta_4": 0},
    shows={"theta_1": 0, "theta_2": -31.4, "theta_3": 64.9, "theta_4": -33.5, "theta_5": 0})

PREDICTIONS: dict[str, Asked] = {
    "inverse.count": Asked(None, [_COUNT]),
    "inverse.elbow": Asked(_two_links, _ELBOW),
    "inverse.beyond": Asked(_two_links, _BEYOND),
    "inverse.linear": Asked(None, [_LINEAR]),
    "inverse.columns": Asked(_arrows, _COLUMNS),
    "inverse.first_step": Asked(newton_view, [_FIRST]),
    "inverse.fast": Asked(newton_view, [_FAST]),
    "inverse.leap": Asked(leap_view, [_LEAP]),
    "inverse.stretched": Asked(None, [_STRETCHED]),
    "inverse.never": Asked(unreachable_view, [_NEVER]),
    "inverse.factor": Asked(None, _FACTORS),
    "inverse.race": Asked(race_view, [_RACE]),
    "inverse.stop": Asked(stop_view, [_STOP]),
    "inverse.answers": Asked(None, [_ANSWERS]),
    "inverse.same": Asked(None, [_SAME]),
    "inverse.shapes": Asked(eight_view, [_SHAPES]),
    "inverse.tilt": Asked(tilt_view, [_TILT]),
}
