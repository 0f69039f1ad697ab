"""Counts of the examiner's judgements: random arms, other frames, every number changed, and slips.

The arms have 1 to 7 revolute and prismatic joints, and neighbouring axes that are skew, meet, are
parallel or coincide. Whether a changed number alters the mechanism is decided without the
examiner: by what the change does to the tool at forty random poses, less what base, tool and
joint offsets can do as well.

Columns: *named*, the message names the joint that was changed; *mends*, it names another one whose
change also makes the table right; *below*, the number hardly counts (by the square of its change,
or by a lever of micrometres) and the arm moves less differently than the tolerance, so that either
verdict is right.

Then the examiner's advice is followed, word for word, in tables with two and three slips: numbers
with the other sign, zeros, numbers of the row above or below, of another unit, 90° off, and a with
d swapped. Every table is tried in both conventions, strictly and not. *in time*: right after at
most as many steps as there are wrong numbers, and one; *right named*: numbers called wrong that
are the reference's own; *twice*: numbers named once more after they were changed as told.
"""
from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from collections import Counter
from functools import partial
from itertools import pairwise
from multiprocessing import Pool
from pathlib import Path

import numpy as np
from measure import goal, header, progress, table

import kinlab as kl
from kinlab.arms.kinematics import axis_frames

sys.path.insert(0, str(Path(__file__).parent.parent / "tests"))
import advice
import mechanisms as m

COUNT = 20_000  # of valid assignments, and of changes: a third of them alter the mechanism
ARMS, TABLES, RANDOM_TABLES = 2_000, 200, 2  # tables of each arm, for each way to judge them
# Shares of the z and x axes that are flipped, and of the origins that slide where they may.
WAYS = {"another base and tool": (0, 0), "z and x flipped": (1, 0), "origins slid": (0, 1),
        "all at random": (0.5, 0.5)}
GOAL_NAMED = 0.95


def converted(arm: kl.Arm, other: bool) -> kl.Arm:
    if not other:
        return arm
    return kl.to_modified(arm) if arm.convention == "standard" else kl.to_standard(arm)


def pairs(arm: kl.Arm) -> list[str]:
    """How each two neighbouring axes lie to each other."""
    frames = kl.link_frames(arm, np.zeros(arm.n))[axis_frames(arm)]
    found = []
    for (z0, p0), (z1, p1) in pairwise((T[:3, 2], T[:3, 3]) for T in frames):
        normal, span = np.cross(z0, z1), p1 - p0
        if np.linalg.norm(normal) < 1e-9:
            found.append("parallel" if np.linalg.norm(np.cross(z0, span)) > 1e-9 else "coincident")
        else:
            found.append("skew" if abs(normal @ span) > 1e-9 else "intersecting")
    return found


def moves_alike(new: kl.Arm, arm: kl.Arm, q0: np.ndarray, signs: np.ndarray,
                rng: np.random.Generator) -> bool:
    q = rng.uniform(-3, 3, (3, arm.n))
    return np.allclose(kl.forward_kinematics(new, signs * (q - q0)),
                       kl.forward_kinematics(arm, q), atol=1e-7)


def accepted(count: int) -> tuple[list[list], Counter]:
    """Valid assignments of each way, alternately in the other convention."""
    rows, seen = [], Counter()
    for way, (flip, slide) in WAYS.items():
        rng, tally = np.random.default_rng(1), Counter()
        for turn in range(count // len(WAYS)):
            progress(f"{way}: {turn}")
            arm = m.random_arm(rng)
            seen.update(pairs(arm))
            new, q0, signs = m.reassigned(arm, rng, flip, slide)
            answer = converted(new, turn % 2)
            tally["valid"] += moves_alike(answer, arm, q0, signs, rng)
            tally["accepted"] += kl.same_mechanism(answer, arm).ok
        rows.append([way, turn + 1, tally["valid"], tally["accepted"]])
    return rows, seen


def changes(count: int) -> dict[str, Counter]:
    """One number of a right table changed, by 1e-6 to 1 of itself: what is said, by parameter."""
    rng = np.random.default_rng(2)
    tallies = {name: Counter() for name in ("theta", "d", "a", "alpha")}
    for turn in range(count):
        progress(f"change {turn} of {count}")
        arm = m.random_arm(rng)
        right = arm if turn % 2 else m.reassigned(arm, rng)[0]
        right = converted(right, turn % 4 == 0)
        index, parameter, change = m.random_change(rng, right)
        wrong = m.changed(right, index, parameter, change)
        tallies[parameter].update(said(wrong, right, arm, index, parameter, change, rng))
    return tallies


def said(wrong: kl.Arm, right: kl.Arm, arm: kl.Arm, index: int, parameter: str, change: float,
         rng: np.random.Generator) -> list[str]:
    """What the verdict on a changed table counts as."""
    verdict = kl.same_mechanism(wrong, arm)
    alters = m.alters(right, index, parameter, change, rng)
    if alters is None:
        return ["below"]
    if not alters:
        return ["harmless", *["accepted"] * verdict.ok]
    if verdict.ok:
        print(f"\naccepted: {parameter}{index + 1} by {change:g} in\n{right}\nfor\n{arm}")
        return ["altering"]
    if verdict.message.startswith(f"Joint {index + 1}:"):
        return ["altering", "refused", "named"]
    if m.repair_works(wrong, arm, verdict.message):
        return ["altering", "refused", "mends"]
    return ["altering", "refused", "other joint"]


def slips_of(arm: kl.Arm, number: int | None, together: int) -> tuple[str, Counter]:
    walks = advice.judged(arm, np.random.default_rng(3), number, together)
    for answer, reference, strict, walk in walks.pop("odd", []):
        if together == 2:
            print(f"\n{walk}\nstrict={strict}\n{answer}\nfor\n{reference}", flush=True)
    return arm.name or "random", walks


def advised(arms: list[kl.Arm], number: int | None, together: int,
            processes: int) -> dict[str, Counter]:
    """What becomes of tables with slips in them, by the arm's name."""
    found: dict[str, Counter] = {}
    with Pool(processes) as pool:
        task = partial(slips_of, number=number, together=together)
        for turn, (name, walks) in enumerate(pool.imap_unordered(task, arms)):
            progress(f"{together} slips: arm {turn} of {len(arms)}")
            most = max(found.get(name, walks)["most"], walks["most"])
            found[name] = found.get(name, Counter()) + walks
            found[name]["most"] = most
    return found


def advice_table(title: str, found: dict[str, Counter]) -> Counter:
    columns = ("tables", "wrong", "ended", "in time", "most", "right named", "twice")
    progress()
    table([title, *columns], [[name, *(walks[column] for column in columns)]
                              for name, walks in sorted(found.items())])
    total = sum(found.values(), Counter())
    total["most"] = max(walks["most"] for walks in found.values())
    return total


def options() -> Namespace:
    parser = ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--judgements", type=int, default=COUNT, metavar="N",
                        help=f"valid tables, and changed ones ({COUNT:,})")
    parser.add_argument("--arms", type=int, default=ARMS, metavar="N",
                        help=f"random arms whose tables get slips ({ARMS:,})")
    parser.add_argument("--tables", type=int, default=TABLES, metavar="N",
                        help=f"tables with slips for each known arm and way ({TABLES})")
    parser.add_argument("--all", action="store_true",
                        help="all tables with two slips of the known arms; some hours")
    parser.add_argument("--processes", type=int, default=None, metavar="N")
    return parser.parse_args()


def main() -> None:
    chosen = options()
    header("Judgements of the examiner, counted")
    if chosen.judgements:
        judgements(chosen.judgements)
    rng = np.random.default_rng(5)
    known = [*advice.course(), *advice.published()]
    unknown = [m.random_arm(rng) for _ in range(chosen.arms)]
    for together, share in ((2, 1), (3, 0.5)):
        number = None if chosen.all and together == 2 else int(chosen.tables * share)
        found = advised(known, number, together, chosen.processes)
        found |= advised(unknown, RANDOM_TABLES, together, chosen.processes)
        total = advice_table(f"{together} slips", found)
        goal(f"advice on {together} slips ends in time: {total['in time']:,} of "
             f"{total['tables']:,}, after at most {total['most']} steps",
             total["in time"] == total["tables"])
        goal(f"it names no right number as wrong: {total['right named']}, and none twice: "
             f"{total['twice']}", not (total["right named"] or total["twice"]))


def judgements(count: int) -> None:
    rows, seen = accepted(count)
    progress()
    table(["other frames for the same arm", "arms", "move alike", "accepted"], rows)
    table(["neighbouring axes of these arms", "pairs"], sorted(seen.items()))
    every, verdicts = changes(count), ("altering", "refused", "named", "mends", "other joint",
                                       "harmless", "accepted", "below")
    progress()
    table(["changed", *verdicts], [[name, *(tally[word] for word in verdicts)]
                                   for name, tally in every.items()])
    total = sum(every.values(), Counter())
    goal("every valid assignment is accepted", all(row[1] == row[2] == row[3] for row in rows))
    goal("every change that alters the mechanism is refused",
         total["refused"] == total["altering"])
    goal("every change that does not is accepted", total["accepted"] == total["harmless"])
    share = total["named"] / total["refused"]
    goal(f"the message names the joint that was changed in {GOAL_NAMED:.0%}: {share:.1%}",
         share >= GOAL_NAMED)


if __name__ == "__main__":
    main()
