// Inverse kinematics under the hand: the joints follow a target that is dragged. Damped steps as
// in kinlab/ik/descent.py, for the tool point alone; a student's own targets go to kinlab's
// inverse_kinematics, which explains itself.

import { frames, velocities } from "./frames.js";
import { clip } from "./steps.js";
import { cross, dot } from "./vectors.js";

/** @import { Drive, Frame, Knob, Scene, Solved, TargetScene, Triple } from "./types.js" */
/** @typedef {{ q: number[], all: Frame[], e: Triple, cost: number }} Look */

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
 * A joint value within its range; a joint that turns right round has no end.
 * @param {number} value
 * @param {Pick<Knob, "low" | "high" | "unit">} knob
 */
function kept(value, { low, high, unit }) {
  if (unit === "°" && high - low >= FULL_TURN) {
    const turns = Math.floor((value - low) / (2 * Math.PI));
    return value - 2 * Math.PI * turns;
  }
  return clip(value, low, high);
}

/**
 * Joint values whose tool point is at the goal, or as near as steps from q lead.
 * @param {TargetScene} scene
 * @param {number[]} q
 * @param {Triple} goal
 * @returns {Solved}
 */
export function reach(scene, q, goal) {
  const { motions, radius, target } = scene, { tip, joints: n } = target;
  const joints = scene.knobs.slice(0, n);
  const sizes = joints.map(({ unit }) => unit === "°" ? 1 : radius);
  /** @type {(at: number[]) => Look} */
  const look = (at) => {
    const all = frames(motions, at), e = goal.map((g, k) => (g - all[tip][3][k]) / radius);
    return { q: at, all, e, cost: dot(e, e) };
  };
  let best = look(q.slice()), damping = 1e-3, steps = 0, pushed = false, now = best;
  while (steps < STEPS && best.cost > CLOSE * CLOSE) {
    const next = look(step(now, damping));
    steps += 1;
    const gain = now.cost - next.cost;
    if (gain > 0) now = next;
    damping = gain > 0 ? Math.max(1e-6, damping / 4) : damping * 4;
    if (now.cost < best.cost) best = now;
    if (gain > 1e-4 * now.cost || (gain <= 0 && damping < 1e4)) continue;
    if (pushed) break;
    // A stretched arm cannot tell on which side to fold: push it a little, once.
    pushed = true;
    damping = 1e-3;
    now = look(now.q.map((value, i) =>
      i < n ? kept(value + 0.03 * (-1) ** i * sizes[i], joints[i]) : value));
  }
  return { q: best.q, steps, error: Math.sqrt(best.cost) * radius };

  /**
   * @param {Look} from
   * @param {number} mu
   */
  function step(from, mu) {
    const columns = velocities(motions, from.all, tip, n)
      .map((column, i) => column.map((v) => v * sizes[i] / radius));
    for (let round = 0; ; round++) {
      const y = damped(columns, from.e, mu * (from.cost + 1e-9));
      const moves = columns.map((column, i) => dot(column, y) * sizes[i]);
      // A joint that does not move the tool stays where it is, rounding aside.
      const ahead = from.q.map((value, i) =>
        Math.abs(moves[i]) > IDLE * sizes[i] ? value + moves[i] : value);
      const held = joints.map((joint, i) => kept(ahead[i], joint));
      // A joint that stands at its limit and would go on leaves the work to the others.
      const stuck = joints.flatMap((joint, i) =>
        held[i] === from.q[i] && ahead[i] !== held[i] ? [i] : []);
      if (!stuck.length || round === n) return [...held, ...from.q.slice(n)];
      for (const i of stuck) columns[i] = [0, 0, 0];
    }
  }
}

/**
 * Ties a target to the arm: where the target goes the joints follow, and where the joints go the
 * target rides on the tool.
 * @param {TargetScene} scene
 * @param {Drive} joints of the joints and, after them, the target's coordinates
 * @param {(found: Solved | null) => void} tell hears of each solve, and of moves without one
 */
export function follower(scene, joints, tell) {
  const { knobs, tip, joints: n } = scene.target;
  let last = joints.read(), writing = false;
  /** @type {(q: number[], from: number, to: number) => boolean} */
  const moved = (q, from, to) => q.slice(from, to).some((v, k) => v !== last[from + k]);
  const write = (/** @type {number[]} */ q) => {
    writing = true;
    joints.write(q);
    writing = false;
    last = joints.read();
  };
  const goal = (/** @type {number[]} */ q) => {
    const place = frames(scene.motions, q)[tip][3].slice();
    knobs.forEach((knob, k) => { place[k] = q[knob]; });
    return place;
  };
  const ride = (/** @type {number[]} */ q) => {
    const place = frames(scene.motions, q)[tip][3];
    return q.map((v, i) => knobs.includes(i) ? place[knobs.indexOf(i)] : v);
  };
  const solve = (/** @type {number[]} */ q) => {
    const found = reach(scene, q, goal(q));
    tell(found);
    write(found.q);
  };
  return {
    /**
     * Take the target to a place in the room.
     * @param {Triple} place
     */
    to(place) {
      const q = joints.read().slice();
      knobs.forEach((knob, k) => {
        const { low, high } = scene.knobs[knob];
        q[knob] = clip(place[k], low, high);
      });
      solve(q);
    },
    /**
     * Joints that Play moves: the target leads.
     * @type {Drive}
     */
    lead: { read: joints.read, write(q) { solve([...joints.read().slice(0, n), ...q.slice(n)]); } },
    /**
     * Joints that Home moves: the target rides.
     * @type {Drive}
     */
    drive: { read: joints.read, write(q) { tell(null); write(ride(q)); } },
    /** Something else has moved joints or target, one or both. */
    changed() {
      if (writing) return;
      const q = joints.read(), arm = moved(q, 0, n), target = moved(q, n, q.length);
      last = q;
      if (target && !arm) solve(q);
      if (arm && !target) { tell(null); write(ride(q)); }
      if (arm && target) tell(null);
    },
  };
}
