// Movement between poses.

import { clip } from "./steps.js";

/** @import { Drive } from "./types.js" */

/**
 * How far of its way something is at the time t from 0 to 1; it starts and ends at rest.
 * @param {number} t
 */
export const smooth = (t) => t * t * t * (10 - 15 * t + 6 * t * t);

/** Whether the reader has asked the system for less motion. */
export const wantsCalm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

export class Mover {
  request = 0;

  writing = false;

  /**
   * Where it goes to now.
   * @type {number[]}
   */
  goal = [];

  /** @param {() => void} onStop */
  constructor(onStop) {
    this.onStop = onStop;
  }

  /**
   * Move joints through poses, each in `duration` ms, for ever if `loop`. Who prefers less motion
   * sees each pose stand still for as long.
   * @param {Drive} joints
   * @param {number[][]} poses
   * @param {number} duration
   */
  start(joints, poses, duration, loop = false) {
    this.stop();
    const still = wantsCalm();
    if (still && !loop) duration = 0;
    let from = joints.read(), next = 0, began = performance.now();
    this.goal = poses[0];
    const step = (/** @type {number} */ now) => {
      const t = duration ? clip((now - began) / duration, 0, 1) : 1;
      const to = poses[next], s = smooth(t), between = t < 1 && !still;
      this.write(joints, between ? from.map((q, i) => q + s * (to[i] - q)) : to);
      if (t === 1) {
        [from, began, next] = [to, now, next + 1];
        if (next === poses.length) {
          if (!loop) return this.stop();
          next = 0;
        }
        this.goal = poses[next];
      }
      this.request = requestAnimationFrame(step);
    };
    this.request = requestAnimationFrame(step);
  }

  /**
   * @param {Drive} joints
   * @param {number[]} q
   */
  write(joints, q) {
    this.writing = true;
    joints.write(q);
    this.writing = false;
  }

  stop() {
    cancelAnimationFrame(this.request);
    this.request = 0;
    this.onStop();
  }
}
