"""The right table that is nearest to a wrong one: what the examiner's advice leads to.

Every refusal names a cell of *one* right table. Whoever obeys changes that cell to its value, so
fewer cells are left to change; no other right table comes nearer by more than one cell, and
those that do not hold the new value come no nearer at all. Doubts (below) only fall, too. So advice
ends after as many steps as there are cells to change, and never takes back what it said.

Right tables are the reference's own, and those whose frames are turned and slid:

* z of frame i turned round (s_i = -1) and x turned round (e_i = -1) make of a row
  theta, d, a, alpha the row  s (theta + pi [e != e']), s d, e' a, e' (alpha + pi [s != s']);
  s and e belong to the frame before the row, s' and e' to the one behind it;
* frames that may slide or turn about their z let some cells trade with each other. How is worked
  out once for all signs, from the lines of the reference's axes (`Freedom`).

The reference's own table wins ties, and where there is doubt another one has to be nearer by more.
So a number of the reference is called wrong only where many others speak of other frames.
"""
from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations, product
from typing import NamedTuple

import numpy as np

from ..arms.arm import Arm, row_of, to_modified, to_standard
from ..arms.kinematics import forward_kinematics
from ..arms.link import PARAMETERS, REVOLUTE, Link, revolute, with_numbers
from .mechanism import FLAT, ROUNDING, SIXTH_DECIMAL, wrapped

THETA, D, A, ALPHA = range(4)
STATES = np.array(list(product((1, -1), (1, -1))))  # signs of z and x of a frame
A_TURN = 1e-3  # what a turned axis counts beside a cell
MUCH = 3  # two slips with a and d swapped are four wrong cells
MOST_TABLES, MOST_TOGETHER = 200, 3


class Deviation(NamedTuple):
    """One number of the answer's table that is off, and what it should be.

    `row` counts from 0 in the standard table; `parameter` is alpha, theta, a or d. `only_strict`
    where the number does not count for the mechanism.
    """

    parameter: str
    row: int
    got: float
    expected: float
    only_strict: bool = False


class Block(NamedTuple):
    """Cells that may trade with each other as long as `held` @ their numbers stays the same."""

    places: list[tuple[int, int]]
    held: np.ndarray
    whole_turns: bool  # angles: only up to whole turns


class Freedom(NamedTuple):
    """Which cells of the reference's table are decided, one by one or together."""

    pinned: np.ndarray  # (n, 4) bool
    blocks: list[Block]


# ---- Rows ----------------------------------------------------------------------------------------


def standard_rows(arm: Arm) -> np.ndarray:
    """The numbers (n, 4) of an arm's table, a and alpha in the row of the standard convention.

    What is in no row, before the first z or behind the last one, is left out.
    """
    rows = np.array([[getattr(link, name) for name in PARAMETERS] for link in arm.links])
    if arm.convention == "modified":
        rows[:, A:] = np.vstack([rows[1:, A:], [0, 0]])
    return rows


def with_rows(arm: Arm, rows: np.ndarray) -> Arm:
    """The arm with other numbers; the inverse of `standard_rows`."""
    rows = rows.copy()
    if arm.convention == "modified":
        first = arm.links[0]
        rows[:, A:] = np.vstack([[first.a, first.alpha], rows[:-1, A:]])
    return replace(arm, links=tuple(map(_with_row, arm.links, rows)))


def _with_row(link: Link, row: np.ndarray) -> Link:
    return with_numbers(link, **dict(zip(PARAMETERS, map(float, row))))


def _matrix(row: np.ndarray) -> np.ndarray:
    return forward_kinematics(Arm([_with_row(revolute(), row)]), [0])


def _last_row(answer: Arm, typed: np.ndarray, reference: Arm, own: np.ndarray) -> np.ndarray | None:
    """The last row that puts the answer's tool where the reference's is.

    None where there is none, or where the row is the reference's own: then the tool is wrong.
    """
    T = _matrix(own) @ reference.tool @ np.linalg.inv(answer.tool)
    numbers = row_of(T)
    row = np.array([numbers[name] for name in PARAMETERS])
    apart = np.where([True, False, False, True], wrapped(row - own), row - own)
    row = np.where(np.abs(apart) <= FLAT, own, row)
    fits = np.allclose(_matrix(row), T, atol=FLAT) and (
        answer.convention == "standard" or np.allclose(row[A:], 0, atol=FLAT))
    return row if fits and not (np.any(row != own) and np.allclose(typed, own)) else None


# ---- What counts ---------------------------------------------------------------------------------


def freedom(rows: np.ndarray, links: tuple[Link, ...], zeros: bool, tool: bool) -> Freedom:
    """Which cells of a table are decided by its mechanism.

    Parameters
    ----------
    rows : array, shape (n, 4)
    links : tuple of Link
        For their kinds.
    zeros : bool
        Whether joints may count from other zeros.
    tool : bool
        Whether the tool frame may sit elsewhere on the last link.
    """
    variable = np.array([[name == link.variable for name in PARAMETERS] for link in links])
    moving = np.flatnonzero(variable.any(axis=1))
    free = variable & zeros
    free[:moving[0]], free[moving[0], THETA] = True, True
    if tool:
        free[moving[-1]:] = True
    angles, pinned = _angles(rows, free), np.ones_like(free)
    pinned[:, THETA], pinned[:, ALPHA] = False, ~free[:, ALPHA]
    lengths, pinned[:, [D, A]] = _lengths(rows, [link.kind == REVOLUTE for link in links], free,
                                          tool)
    for block in angles:
        if len(block.places) == 1:
            pinned[block.places[0]] = True
    return Freedom(pinned, [*lengths, *(block for block in angles if len(block.places) > 1)])


def _angles(rows: np.ndarray, free: np.ndarray) -> list[Block]:
    """Angles about the same line count together, and not at all with one that is free."""
    groups: list[list[int]] = [[]]
    for i, row in enumerate(rows):
        groups[-1].append(i)
        if abs(np.sin(row[ALPHA])) > SIXTH_DECIMAL or row[A]:
            groups.append([])
    signs = np.sign(np.cos(rows[:, ALPHA]))
    blocks = []
    for group in filter(None, groups):
        if not free[group, THETA].any():
            held = np.cumprod([1, *signs[group[:-1]]])
            blocks.append(Block([(i, THETA) for i in group], held[None], whole_turns=True))
    return blocks


def _lengths(rows: np.ndarray, turns: list[bool], free: np.ndarray,
             tool: bool) -> tuple[list[Block], np.ndarray]:
    """Lengths that count together, and which (n, 2) of d and a count by themselves.

    Seen from the tool, every revolute axis has to lie where it does. That holds lengths by linear
    equations; what a free length does to them is taken out.
    """
    slopes = _slopes(rows, turns)
    loose = [slopes[:, 2 * i] for i in np.flatnonzero(free[:, D])]
    if tool:
        loose += list(_across(rows, turns).reshape(-1, 3).T)
    held = _without(np.array(loose).T, slopes) if loose else slopes
    _, sizes, V = np.linalg.svd(held, full_matrices=False)
    V = V[sizes > FLAT]
    kept = V.T @ V  # projects on what is held
    alone, nothing = np.diag(kept) > 1 - FLAT, np.diag(kept) < FLAT
    together = np.flatnonzero(~alone & ~nothing)
    return [Block([(k // 2, (D, A)[k % 2]) for k in block], kept[np.ix_(block, block)], False)
            for block in _connected(kept, list(together))], alone.reshape(-1, 2)


def _directions(rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """z of the frames before the rows, and x of those behind them."""
    R, z, x = np.eye(3), [], []
    for theta, _, _, alpha in rows:
        c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
        z.append(R[:, 2])
        R = R @ [[c, -s * ca, s * sa], [s, c * ca, -c * sa], [0, sa, ca]]
        x.append(R[:, 0])
    return np.array(z), np.array(x)


def _across(rows: np.ndarray, turns: list[bool]) -> np.ndarray:
    """Projectors (joints, 3, 3) across the axes that turn."""
    z = _directions(rows)[0][turns]
    return np.eye(3) - z[:, :, None] * z[:, None, :]


def _slopes(rows: np.ndarray, turns: list[bool]) -> np.ndarray:
    """How far the tool moves across each revolute axis by each length d and a before it."""
    steps = np.stack(_directions(rows), axis=1).reshape(-1, 3)
    moved = np.einsum("kij,mj->kim", _across(rows, turns), steps)
    behind = np.arange(len(steps)) // 2 >= np.flatnonzero(turns)[:, None]
    return (moved * behind[:, None]).reshape(-1, len(steps))


def _without(loose: np.ndarray, slopes: np.ndarray) -> np.ndarray:
    U, sizes, _ = np.linalg.svd(loose, full_matrices=False)
    U = U[:, sizes > FLAT]
    return slopes - U @ (U.T @ slopes)


def _connected(kept: np.ndarray, places: list[int]) -> Iterator[list[int]]:
    while places:
        block, found = {places[0]}, {places[0]}
        while found:
            found = {k for k in places if np.any(np.abs(kept[k, list(found)]) > FLAT)} - block
            block |= found
        yield sorted(block)
        places = [k for k in places if k not in block]


# ---- The nearest table ---------------------------------------------------------------------------


@dataclass(frozen=True)
class Comparison:
    """An answer's rows beside those of the reference, and what counts of them."""

    rows: np.ndarray
    right: np.ndarray
    counts: Freedom

    @cached_property
    def noise(self) -> float:
        return ROUNDING * max(*(np.abs(rows[:, [D, A]]).max() for rows in (self.rows, self.right)),
                              FLAT)

    @cached_property
    def held(self) -> np.ndarray:
        held = self.counts.pinned.copy()
        for block in self.counts.blocks:
            held[_index(block)] = True
        return held

    def off(self, table: np.ndarray) -> np.ndarray:
        """Where the answer's cells differ from those of a table (..., n, 4), and that counts."""
        return self.held & ~self.equal(self.rows, table)

    def equal(self, rows: np.ndarray, table: np.ndarray) -> np.ndarray:
        apart = np.abs(rows - table)
        near = apart <= SIXTH_DECIMAL * np.maximum(np.abs(rows), np.abs(table)) + self.noise
        near[..., [THETA, ALPHA]] = np.abs(wrapped(apart[..., [THETA, ALPHA]])) <= SIXTH_DECIMAL
        return near

    @cached_property
    def either(self) -> np.ndarray:
        """(n,) where x may point either way, and only the sign of the twist tells."""
        angle = np.append(self.held[:, THETA], True)
        length = self.held[:, A] & (np.abs(self.right[:, A]) > self.noise)
        return ~(angle[:-1] | angle[1:] | length)

    def own(self) -> np.ndarray:
        """The reference's own table, with x as the answer has it where it may point either way."""
        table = self.right.copy()
        far = np.abs(wrapped(self.rows - table)) > np.abs(wrapped(self.rows + table)) + FLAT
        table[self.either & far[:, ALPHA], ALPHA] *= -1
        return table

    def nearest(self, valid: Callable[[np.ndarray], bool]) -> np.ndarray:
        """The reference's own table, or one that is nearer by enough."""
        own = best = self.own()
        cost = float(self.off(own).sum())
        for bound, states in self._turned() if cost > 1 else ():
            if bound >= cost:
                break
            trial = self._slid(states)
            total = self.off(trial).sum() + self._doubt(trial, own) + bound % 1
            if total < cost and valid(trial):
                best, cost = trial, total
        return best

    def _doubt(self, table: np.ndarray, own: np.ndarray) -> int:
        """How many cells nearer another table has to be than the reference's own.

        Much, where it would call a number wrong that is the reference's; a little, where it wants
        a number otherwise than the reference has it. A twist that is off by half a turn takes
        this little doubt, for nobody mistypes one so.
        """
        mine, strange = self.equal(self.rows, own), ~self.equal(table, own)
        if np.any(self.held & strange & mine):
            return MUCH
        turned = self.equal(self.rows, own + np.pi) & ~self.equal(self.rows, -own)
        own_frames = np.any((turned & self.equal(self.rows, table) & self.held)[:, ALPHA])
        return int(not own_frames and np.any(self.off(table) & strange))

    def _turned(self) -> Iterator[tuple[float, np.ndarray]]:
        """Signs of z and x of all frames, those first that leave the fewest pinned cells off.

        The bound before them is the number of these cells, and a little for each turned axis.
        """
        before, after = np.repeat(STATES, 4, axis=0), np.tile(STATES, (4, 1))
        tables = _turned_rows(self.right, before.T[..., None], after.T[..., None])
        off = (self.off(tables) & self.counts.pinned).sum(axis=-1).T.reshape(-1, 4, 4)
        costs = off + A_TURN * (STATES < 0).sum(axis=1)
        ends = [np.array([0, np.inf, np.inf, np.inf])]
        for cost in costs[::-1]:
            ends.insert(0, (cost + ends[0]).min(axis=1))
        queue: list[tuple[float, tuple[int, ...]]] = [(ends[0][0], (0,)),
                                                      (ends[0][2] + A_TURN, (2,))]
        for _ in range(MOST_TABLES * len(costs)):
            if not queue:
                return
            bound, path = heapq.heappop(queue)
            i = len(path) - 1
            if i == len(costs):
                yield bound, STATES[list(path)]
                continue
            for k in range(4):
                further = bound - ends[i][path[-1]] + costs[i][path[-1], k] + ends[i + 1][k]
                if np.isfinite(further):
                    heapq.heappush(queue, (further, (*path, k)))

    def _slid(self, states: np.ndarray) -> np.ndarray:
        """The table whose frames are turned so, and slid to where the answer has them."""
        before, after = states[:-1].T, states[1:].T
        table = _turned_rows(self.right, before, after)
        signs = np.stack([before[0], before[0], after[1], after[1]], axis=1)
        for block in self.counts.blocks:
            index = _index(block)
            table[index] = _mended(self.rows[index], table[index],
                                   self.equal(self.rows, table)[index],
                                   block._replace(held=block.held * signs[index]), self.noise)
        return table


def _index(block: Block) -> tuple[list[int], list[int]]:
    rows, columns = zip(*block.places)
    return list(rows), list(columns)


def _turned_rows(rows: np.ndarray, before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """Rows (..., n, 4) once the frames before and behind them are turned."""
    (s, e), (further_s, further_e) = before, after
    theta, d, a, alpha = np.moveaxis(rows, -1, 0)
    return np.stack([s * (theta + np.pi * (e != further_e)), s * d, further_e * a,
                     further_e * (alpha + np.pi * (s != further_s))], axis=-1)


def _mended(mine: np.ndarray, own: np.ndarray, equal: np.ndarray, block: Block,
            noise: float) -> np.ndarray:
    """The numbers of a block with as few changes as it takes, the fewest strange ones."""
    gap = block.held @ (own - mine)
    gap = wrapped(gap) if block.whole_turns else gap
    near = SIXTH_DECIMAL * (1 if block.whole_turns else np.abs(mine).sum()) + noise
    for size in range(min(MOST_TOGETHER + 1, int((~equal).sum()))):
        found = []
        for chosen in map(list, combinations(range(len(mine)), size)):
            slopes = block.held[:, chosen]
            change = np.linalg.lstsq(slopes, gap, rcond=None)[0]
            if np.linalg.norm(slopes @ change - gap) <= near:
                new = mine.copy()
                new[chosen] += change
                strange = np.abs(new - own) > near
                found.append((int(strange[chosen].sum()), int(equal[chosen].sum()), chosen, new))
        if found:
            return min(found, key=lambda option: option[:3])[-1]
    return np.where(equal, mine, own)


class Nearest(NamedTuple):
    """The standard rows of the nearest right table, and the cells of the answer that differ from
    it, in the order in which they are named."""

    rows: np.ndarray
    cells: list[Deviation]
    compared: Comparison

    @property
    def held(self) -> np.ndarray:
        """The answer's rows with the numbers that count as the right table has them."""
        return np.where(self.compared.held, self.rows, self.compared.rows)


def nearest_table(answer: Arm, reference: Arm, strict: bool,
                  valid: Callable[[Arm], bool]) -> Nearest:
    """The right table that is nearest to an answer; `valid` says of an arm whether it is right."""
    reference = (to_modified if answer.convention == "modified" else to_standard)(reference)
    rows, right = standard_rows(answer), standard_rows(reference)
    last = _last_row(answer, rows[-1], reference, right[-1]) if strict else None
    moves = freedom(right, reference.links, zeros=True, tool=True)
    counts = moves
    if strict:
        counts = freedom(right, reference.links, zeros=False, tool=last is None)
    if last is not None:
        right[-1] = last
    compared = Comparison(rows, right, counts)
    table = compared.nearest(lambda trial: valid(with_rows(answer, trial)))
    mechanism = Comparison(rows, right, moves).held
    off = [Deviation(PARAMETERS[k], int(i), float(rows[i, k]),
                     _plain(table[i, k], right[i, k], k), not mechanism[i, k])
           for i, k in np.argwhere(compared.off(table))]
    return Nearest(table, sorted(off, key=lambda cell: _turn(cell, answer.links)), compared)


def hidden_cells(answer: Arm, nearest: Nearest, right: Callable[[Arm], bool]) -> list[Deviation]:
    """Numbers that count in the answer's frames, though they do not in the reference's.

    Where the frame of a slide sits aside, an angle moves it that is free in the line of the axes.
    The one number that mends the table, or all that differ but the joints' own.
    """
    rows, table = nearest.compared.rows, nearest.rows
    apart = np.argwhere(~nearest.compared.equal(rows, table)).tolist()
    cells = [(i, k) for i, k in apart if PARAMETERS[k] != answer.links[i].variable]
    mending = [cell for cell in cells if right(_with_cell(answer, rows, table, cell))]
    return [Deviation(PARAMETERS[k], i, float(rows[i, k]),
                      _plain(table[i, k], nearest.compared.right[i, k], k))
            for i, k in mending[:1] or cells]


def _with_cell(answer: Arm, rows: np.ndarray, table: np.ndarray, cell: tuple[int, int]) -> Arm:
    trial = rows.copy()
    trial[cell] = table[cell]
    return with_rows(answer, trial)


def _plain(value: float, own: float, column: int) -> float:
    """An angle as the reference has it, or within half a turn."""
    if column in (D, A):
        return float(value) + 0.0
    if abs(wrapped(value - own)) <= FLAT:
        return float(own)
    angle = float(wrapped(value)) + 0.0
    return np.pi if abs(angle + np.pi) <= FLAT else angle


def _turn(cell: Deviation, links: tuple[Link, ...]) -> tuple[int, int]:
    """When a cell is named: twists, angles, lengths; zeros last, the one nearest the tool first."""
    if not cell.only_strict:
        return {"alpha": 0, "theta": 1}.get(cell.parameter, 2), cell.row
    if cell.parameter != links[cell.row].variable:
        return 3, cell.row
    return 4, -cell.row
