"""Tables with slips in them, and what becomes of them when the examiner's advice is followed."""
import re
from collections import Counter
from dataclasses import dataclass, field, replace
from itertools import combinations
from math import degrees, pi

import numpy as np

import kinlab as kl
from kinlab.arms import robots

RIGHT = pi / 2
R, P = kl.revolute, kl.prismatic
LENGTHS, ANGLES = ("d", "a"), ("theta", "alpha")
MOST_STEPS = 9


def published():
    """Arms whose tables everybody copies, as they are printed."""
    puma = kl.Arm([R(d=0.67, alpha=RIGHT), R(a=0.4318), R(a=0.0203, d=0.15005, alpha=-RIGHT),
                   R(d=0.4318, alpha=RIGHT), R(alpha=-RIGHT), R()], name="PUMA 560")
    kr210 = kl.Arm([R(d=0.75), R(theta=-RIGHT, a=0.35, alpha=-RIGHT), R(a=1.25),
                    R(d=1.5, a=-0.054, alpha=-RIGHT), R(alpha=RIGHT), R(alpha=-RIGHT)],
                   convention="modified", tool=kl.translation([0, 0, 0.303]), name="KR 210")
    ur5 = kl.Arm([R(d=0.089159, alpha=RIGHT), R(a=-0.425), R(a=-0.39225),
                  R(d=0.10915, alpha=RIGHT), R(d=0.09465, alpha=-RIGHT), R(d=0.0823)], name="UR5")
    panda = kl.Arm([R(d=0.333), R(alpha=-RIGHT), R(d=0.316, alpha=RIGHT),
                    R(a=0.0825, alpha=RIGHT), R(a=-0.0825, d=0.384, alpha=-RIGHT),
                    R(alpha=RIGHT), R(a=0.088, alpha=RIGHT)], convention="modified",
                   tool=kl.translation([0, 0, 0.107]), name="Panda")
    stanford = kl.Arm([R(d=0.412, alpha=-RIGHT), R(d=0.154, alpha=RIGHT), P(theta=-RIGHT),
                       R(alpha=-RIGHT), R(alpha=RIGHT), R(d=0.263)], name="Stanford")
    scara = kl.Arm([R(d=0.387, a=0.325), R(a=0.275, alpha=pi), P(), R(d=0.05)], name="SCARA")
    return [puma, kr210, ur5, panda, stanford, scara]


def course():
    return [make() for make in (robots.two_link, robots.practical_six_link, robots.cylindrical,
                                robots.exam_2018, robots.alpha_ii, robots.intelledex_660t)]


def converted(arm, convention):
    return {"standard": kl.to_standard, "modified": kl.to_modified}[convention](arm)


# ---- Slips ---------------------------------------------------------------------------------------


def slips(arm):
    """Slips of all kinds in a table: a kind, and the new numbers by their cells."""
    found = []
    for i, link in enumerate(arm.links):
        for column in (*ANGLES, *LENGTHS):
            value = getattr(link, column)
            found += [(kind, {(i, column): new}) for kind, new in typed(arm, i, column, value)
                      if not same_cell(column, value, new)]
        if link.d != link.a:
            found.append(("swapped d and a", {(i, "d"): link.a, (i, "a"): link.d}))
    return found


def typed(arm, i, column, value):
    yield "sign", -value
    yield "zero", 0.0
    for j in (i - 1, i + 1):
        if 0 <= j < arm.n:
            yield "row off", getattr(arm.links[j], column)
    if column in LENGTHS:
        yield "wrong unit", value * 1000
        yield "wrong unit", value / 1000
    else:
        yield "wrong unit", degrees(value)
        yield "90° offset", value + RIGHT
        yield "90° offset", value - RIGHT


def same_cell(column, value, other):
    if column in LENGTHS:
        return abs(value - other) <= 1e-6 * max(abs(value), abs(other)) + 1e-9
    return abs(np.angle(np.exp(1j * (value - other)))) <= 1e-6


def with_cells(arm, cells):
    links = list(arm.links)
    for (i, column), value in cells.items():
        links[i] = replace(links[i], **{column: value})
    return replace(arm, links=links)


def tables(arm, rng, number, together=2):
    """Tables with some slips at once, and how many cells are wrong: all of them, or a sample."""
    every = slips(arm)
    groups = combinations(range(len(every)), together)
    if number is not None and len(every) >= together:
        groups = (rng.choice(len(every), together, replace=False) for _ in range(number))
    for group in groups:
        cells = {}
        for k in group:
            cells = {**every[k][1], **cells}
        if len(cells) == sum(len(every[k][1]) for k in group):  # none typed over another one
            yield with_cells(arm, cells), len(cells)


# ---- Advice --------------------------------------------------------------------------------------


@dataclass
class Walk:
    """What became of a table whose owner does what is said."""

    ended: bool = False
    said: list = field(default_factory=list)
    right_named: int = 0
    twice: int = 0

    @property
    def steps(self):
        return len(self.said)


def followed(answer, right, reference, *, strict=False):
    """Change what is named, and only that, until the table is right or nothing more is said.

    `right` is the reference in the answer's own convention: the table that was copied.
    """
    walk, named = Walk(), set()
    while walk.steps < MOST_STEPS:
        verdict = kl.same_mechanism(answer, reference, strict=strict, tip=False)
        if verdict.ok:
            walk.ended = True
            return walk
        walk.said.append(verdict)
        fault = verdict.fault
        if fault and fault.column:
            cell = (fault.row - 1, fault.column)
            walk.right_named += bool(is_right(answer, right, *cell))
            walk.twice += cell in named
            named.add(cell)
        changed = obeyed(answer, verdict)
        if changed is None:
            return walk
        answer = changed
    return walk


def is_right(answer, right, i, column):
    return column != "kind" and same_cell(column, getattr(answer.links[i], column),
                                          getattr(right.links[i], column))


def obeyed(answer, verdict):
    """The answer once the advice is taken, or None where there is nothing to take."""
    fault, text = verdict.fault, verdict.message
    if fault and fault.column:
        return with_cells(answer, {(fault.row - 1, fault.column): fault.expected})
    if found := re.search(r"Say convention='(\w+)'", text):
        return replace(answer, convention=found[1])
    if found := re.search(r"All lengths are ([\d.]+) times too (large|small)", text):
        factor = float(found[1]) ** (-1 if found[2] == "large" else 1)
        return replace(answer, links=[replace(link, d=link.d * factor, a=link.a * factor)
                                      for link in answer.links])
    return None


def judged(arm, rng, number, together=2, walks=None):
    """What becomes of slips in an arm's table, in both conventions, strictly and not."""
    walks = Counter() if walks is None else walks
    for convention in ("standard", "modified"):
        right = converted(arm, convention)
        for strict in (False, True):
            for answer, wrong in tables(right, rng, number, together):
                walk = followed(answer, right, arm, strict=strict)
                walks["tables"] += 1
                walks["wrong"] += walk.steps > 0
                walks["ended"] += walk.ended
                walks["in time"] += walk.ended and walk.steps <= wrong + 1
                walks["right named"] += walk.right_named
                walks["twice"] += walk.twice
                walks["most"] = max(walks["most"], walk.steps)
                if not walk.ended or walk.right_named or walk.twice or walk.steps > wrong + 1:
                    walks.setdefault("odd", []).append((answer, arm, strict, walk))
    return walks
