// Steps and Play: from pose to pose, or from one whole number of a knob to the next.

import { clip, replaced } from "./steps.js";

/** @import { Scene } from "./types.js" */

const THERE = 1e-6;                                  // of a knob's whole way

/**
 * The poses that steps and Play go through, from where the knobs are now. A knob whose whole
 * numbers are stages goes through those and leaves the others where they are.
 * @param {Pick<Scene, "knobs" | "poses">} scene
 * @param {number[]} q
 */
export function stages({ knobs, poses }, q) {
  const knob = knobs.findIndex(({ whole }) => whole);
  if (knob < 0) return poses;
  const { low, high } = knobs[knob];
  return Array.from({ length: Math.round(high - low) + 1 }, (_, k) =>
    replaced(q, knob, low + k));
}

/** Goes through the stages one by one, and remembers at which it is. */
export class Walk {
  at = -1;

  /** @param {Pick<Scene, "knobs" | "poses" | "target">} scene */
  constructor(scene) {
    this.scene = scene;
    this.whole = scene.knobs.findIndex(({ whole }) => whole);
  }

  /** Whether there is somewhere to go. */
  get has() { return this.whole >= 0 || this.scene.poses.length > 1; }

  /**
   * The next stage one way or the other; behind the last of a list of poses comes the first.
   * @param {number[]} q where the knobs are
   * @param {number} by 1 or -1
   */
  next(q, by) {
    const all = stages(this.scene, q);
    return this.whole < 0 ? this.beside(all, q, by) : this.counted(all, q, by);
  }

  /**
   * At which stage the knobs stand, more or less.
   * @param {number[]} q
   */
  stage(q) { return Math.round(q[this.whole] - this.scene.knobs[this.whole]?.low); }

  /**
   * All stages on the way to one.
   * @param {number[]} q
   * @param {number} stage
   */
  to(q, stage) {
    const all = stages(this.scene, q), way = [], goal = all[stage][this.whole];
    for (let at = q; at[this.whole] !== goal;) {
      way.push(at = this.counted(all, at, goal - at[this.whole]));
    }
    return way;
  }

  /** @type {(all: number[][], q: number[], by: number) => number[]} */
  counted(all, q, by) {
    const since = q[this.whole] - this.scene.knobs[this.whole].low;
    const next = by > 0 ? Math.floor(since + THERE) + 1 : Math.ceil(since - THERE) - 1;
    return all[clip(next, 0, all.length - 1)];
  }

  /**
   * From the pose where the knobs are, or to the nearest. A pose may come more than once, so it
   * is not looked for while the knobs are still where the last step led.
   * @type {(all: number[][], q: number[], by: number) => number[]}
   */
  beside(all, q, by) {
    const gaps = all.map((pose) => this.gap(pose, q));
    if (!(gaps[this.at] < THERE)) this.at = gaps.indexOf(Math.min(...gaps));
    if (gaps[this.at] < THERE) this.at = (this.at + by + all.length) % all.length;
    return all[this.at];
  }

  /**
   * How far a pose is from the knobs' values, in shares of their ways; where a target leads, only
   * its coordinates count.
   * @type {(pose: number[], q: number[]) => number}
   */
  gap(pose, q) {
    const { knobs, target } = this.scene, led = target?.knobs ?? knobs.map((_, i) => i);
    return Math.max(...led.map((i) => Math.abs(pose[i] - q[i]) / (knobs[i].high - knobs[i].low)));
  }
}
