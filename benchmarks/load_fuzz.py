"""Random texts given to the reader of tables: what comes out, what is raised, how long it takes.

A fifth each: pieces of tables thrown together; characters at random; what is thrown at
`kl.parse_number`; tables with such a text in a cell; and real tables of all forms, spoilt.
"""
from __future__ import annotations

import argparse
import random
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from measure import goal, header, progress, table

from kinlab.tables.question import Ambiguous
from kinlab.tables.read import read_table
from kinlab.tables.table import DHTable, Row

sys.path.insert(0, str(Path(__file__).parent.parent / "tests"))
from wild_texts import wild_texts

LIKE = (DHTable((Row(),)), DHTable((Row(),), "modified", "rad", "mm", (("L1", "100"),)))
SLOWEST = 50  # ms
KNOWN = ("read", "asked", "refused")


def seconds(text: str, like: DHTable) -> tuple[float, str]:
    """How long it takes to read a text, and what comes of it."""
    start = time.thread_time()
    try:
        outcome = "read" if read_table(text, like).table.rows else "empty"
    except Ambiguous:
        outcome = "asked"
    except ValueError:
        outcome = "refused"
    except Exception as error:
        outcome = f"{type(error).__name__} {text[:80]!r}"
    return time.thread_time() - start, outcome


def timed(count: int, seed: int) -> Iterator[tuple[float, str, str]]:
    """The time, the outcome and the text of each; a slow one counts by the best of three."""
    for k, text in enumerate(wild_texts(count, random.Random(seed))):
        took, outcome = seconds(text, LIKE[k % 2])
        if took > SLOWEST / 1e3:
            took = min(took, *(seconds(text, LIKE[k % 2])[0] for _ in range(2)))
        yield took, outcome, text


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--texts", type=int, default=100_000)
    arguments.add_argument("--seed", type=int, default=1)
    given = arguments.parse_args()
    header("random texts, read as tables")
    times, outcomes, slowest = [], Counter(), (0.0, "")
    for k, (took, outcome, text) in enumerate(timed(given.texts, given.seed)):
        if not k % 1000:
            progress(f"{k:,} of {given.texts:,}")
        times.append(1e3 * took)
        outcomes[outcome] += 1
        slowest = max(slowest, (1e3 * took, text))
    progress()
    times.sort()
    strange = [outcome for outcome in outcomes if outcome not in KNOWN]
    table(["texts", *KNOWN, "other errors", "median ms", "99.9 % ms", "slowest ms"],
          [[len(times), *(outcomes[word] for word in KNOWN), sum(outcomes[o] for o in strange),
            times[len(times) // 2], times[int(0.999 * len(times))], times[-1]]])
    print(f"The slowest has {len(slowest[1]):,} characters: {slowest[1][:80]!r}...")
    print(*strange[:10], sep="\n")
    goal("no error but ValueError", not strange)
    goal(f"no text over {SLOWEST} ms", times[-1] < SLOWEST)


if __name__ == "__main__":
    main()
