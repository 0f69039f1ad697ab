// A target that is dragged, and the joints that follow it.

import { descend } from "./chase.js";
import { frames, velocities } from "./frames.js";
import { minus, times } from "./vectors.js";

/** @import { Drive, Solved, TargetScene, Triple } from "./types.js" */

/**
 * Joint values whose tool point is at the goal, or as near as steps from q lead.
 * @param {TargetScene} scene
 * @param {number[]} q
 * @param {Triple} goal
 * @returns {Solved}
 */
export function reach({ knobs, motions, radius, target: { tip, joints } }, q, goal) {
  const aim = (/** @type {number[]} */ at) => {
    const all = frames(motions, at);
    return { e: times(minus(goal, all[tip][3]), 1 / radius),
             columns: () => velocities(motions, all, tip, joints) };
  };
  const movers = knobs.slice(0, joints).map((_, i) => i);
  return descend({ knobs, movers, radius, idle: 1e-4, aim }, q);
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
