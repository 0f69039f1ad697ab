// Inverse kinematics under the hand: knobs bring what is held to the hand. Damped steps as in
// kinlab/ik/descent.py, for points alone; a student's own targets go to kinlab's
// inverse_kinematics, which explains itself.

import { clip } from "./steps.js";
import { cross, dot, norm, times } from "./vectors.js";

/** @import { Knob, Triple } from "./types.js" */
/** @typedef {{ e: Triple, columns: () => Triple[] }} Aim how far off, and what each mover does */
/** @typedef {Aim & { q: number[], cost: number }} Look */
/**
 * @typedef {object} Descent
 * @property {Knob[]} knobs all of the scene's
 * @property {number[]} movers numbers of those that may move
 * @property {number} radius the picture's: what counts as one of a length, as a radian of an angle
 * @property {number} idle the gain, as a part of the cost, that is none
 * @property {(q: number[]) => Aim} aim lengths in it are parts of the radius
 */

const STEPS = 60, CLOSE = 1e-7, IDLE = 1e-12;      // lengths as parts of the picture's radius
const FULL_TURN = 2 * Math.PI - 1e-9;

/**
 * Solve the 3 x 3 system (Σ c cᵀ + damping) x = e by Cramer's rule.
 * @param {Triple[]} columns
 * @param {Triple} e
 * @param {number} damping
 */
function damped(columns, e, damping) {
  const [a, b, c] = [0, 1, 2].map((i) => [0, 1, 2].map((j) =>
    columns.reduce((sum, column) => sum + column[i] * column[j], i === j ? damping : 0)));
  const volume = dot(a, cross(b, c));
  return [cross(b, c), cross(c, a), cross(a, b)]
    .reduce((x, row, i) => x.map((v, k) => v + row[k] * e[i] / volume), [0, 0, 0]);
}

/**
 * A joint value within its range; a joint that turns right round, once or more often, has no end.
 * @param {number} value
 * @param {Pick<Knob, "low" | "high" | "unit">} knob
 */
export function kept(value, { low, high, unit }) {
  const round = unit === "°" ? 2 * Math.PI * Math.floor((high - low) / FULL_TURN) : 0;
  if (round) return value - round * Math.floor((value - low) / round);
  return clip(value, low, high);
}

/**
 * Values of knobs that bring what is aimed to its goal, or as near as steps from q lead.
 * @param {Descent} descent
 * @param {number[]} q
 */
export function descend({ knobs, movers, radius, idle, aim }, q) {
  const moving = movers.map((knob) => knobs[knob]);
  const sizes = moving.map(({ unit }) => unit === "°" ? 1 : radius);
  /** @type {(at: number[]) => Look} */
  const look = (at) => {
    const aimed = aim(at);
    return { ...aimed, q: at, cost: dot(aimed.e, aimed.e) };
  };
  let best = look(q.slice()), damping = 1e-3, steps = 0, pushed = false, now = best;
  while (steps < STEPS && best.cost > CLOSE * CLOSE) {
    const next = look(step(now, damping));
    steps += 1;
    const gain = now.cost - next.cost;
    if (gain > 0) now = next;
    damping = gain > 0 ? Math.max(1e-6, damping / 4) : damping * 4;
    if (now.cost < best.cost) best = now;
    if (gain > idle * now.cost || (gain <= 0 && damping < 1e4)) continue;
    if (pushed) break;
    // A stretched arm cannot tell on which side to fold: push it a little, once. A joint that does
    // not move the tool, such as a tool's roll, would stay turned by that, so it is left alone.
    pushed = true;
    damping = 1e-3;
    const columns = now.columns(), push = (/** @type {number} */ i) =>
      norm(columns[i]) * sizes[i] > IDLE * radius ? 0.03 * (-1) ** i * sizes[i] : 0;
    now = look(put(now.q, moving.map((knob, i) => kept(now.q[movers[i]] + push(i), knob))));
  }
  return { q: best.q, steps, error: Math.sqrt(best.cost) * radius };

  /**
   * All values, with those of the movers in their places.
   * @param {number[]} from
   * @param {number[]} values
   */
  function put(from, values) {
    const all = from.slice();
    movers.forEach((knob, i) => { all[knob] = values[i]; });
    return all;
  }

  /**
   * @param {Look} from
   * @param {number} mu
   */
  function step(from, mu) {
    const columns = from.columns().map((column, i) => times(column, sizes[i] / radius));
    const before = movers.map((knob) => from.q[knob]);
    for (let round = 0; ; round++) {
      const y = damped(columns, from.e, mu * (from.cost + 1e-9));
      const moves = columns.map((column, i) => dot(column, y) * sizes[i]);
      // A joint that does not move the tool stays where it is, rounding aside.
      const ahead = before.map((value, i) =>
        Math.abs(moves[i]) > IDLE * sizes[i] ? value + moves[i] : value);
      const held = moving.map((knob, i) => kept(ahead[i], knob));
      // A joint that stands at its limit and would go on leaves the work to the others.
      const stuck = held.flatMap((value, i) =>
        value === before[i] && ahead[i] !== value ? [i] : []);
      if (!stuck.length || round === movers.length) return put(from.q, held);
      for (const i of stuck) columns[i] = [0, 0, 0];
    }
  }
}
