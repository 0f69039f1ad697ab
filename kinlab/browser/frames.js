// Where frames go: the recurrence of kinlab/arms/motions.py at the knobs' values.

import { clip } from "./steps.js";
import { cross, dot } from "./vectors.js";

/** @import { Elementary, Frame, Motion, Point, Triple, Velocity } from "./types.js" */

export const ROTATE = "rotate";
const VELOCITY = "velocity";

/** @type {(since: number) => number} */
const run = (since) => clip(since, 0, 1);

/**
 * What a list holds at 0, 1, 2, ..., and straight between them.
 * @param {number[]} values
 * @param {number} place
 */
export function between(values, place) {
  const at = clip(place, 0, values.length - 1), k = Math.floor(at);
  return values[k] + (at - k) * ((values[k + 1] ?? values[k]) - values[k]);
}

/**
 * How far a motion goes: amount + gain q, as far as knobs have scrubbed it.
 * @param {Elementary} motion
 * @param {number[]} q
 */
export function travel({ amount = 0, joint, gain = 1, start, scrub, track }, q) {
  const share = scrub ? run(q[scrub.knob] - scrub.start) : 1;
  if (joint == null) return share * amount;
  if (track) return between(track, q[joint]);
  return share * (amount + gain * (start == null ? q[joint] : run(q[joint] - start)));
}

/**
 * Every frame along the motions at the knobs' values q; frame 0 is the room.
 * @param {Motion[]} motions
 * @param {number[]} q
 */
export function frames(motions, q) {
  /** @type {Frame[]} */
  const all = [[[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]]];
  motions.forEach((motion, k) => {
    all.push(motion.kind === VELOCITY ? velocityFrame(motions, all, motion)
      : moved(motion, all[motion.parent ?? k], q));
  });
  return all;
}

/** @type {(motion: Elementary, parent: Frame, q: number[]) => Frame} */
function moved(motion, parent, q) {
  const { kind, axis } = motion, value = travel(motion, q), frame = parent.slice();
  if (kind === ROTATE) {
    const i = (axis + 1) % 3, j = (axis + 2) % 3, c = Math.cos(value), s = Math.sin(value);
    const [u, v] = [frame[i], frame[j]];
    frame[i] = u.map((_, k) => c * u[k] + s * v[k]);
    frame[j] = u.map((_, k) => c * v[k] - s * u[k]);
  } else {
    frame[3] = frame[3].map((o, k) => o + value * frame[axis][k]);
  }
  return frame;
}

/**
 * Velocity of the origin of frame `of` for a unit rate of each of n knobs, as in
 * kinlab/drawing/scene.py.
 * @param {Motion[]} motions
 * @param {Frame[]} all
 * @param {number} of
 * @param {number} n
 */
export function velocities(motions, all, of, n) {
  const columns = Array.from({ length: n }, () => [0, 0, 0]), tip = all[of][3];
  for (let k = of, parent; k > 0; k = parent) {
    const motion = /** @type {Elementary} */ (motions[k - 1]);   // no motion begins at a velocity
    const { kind, axis, joint, gain = 1 } = motion, direction = all[k][axis];
    parent = motion.parent ?? k - 1;
    if (joint == null) continue;
    const arm = tip.map((e, i) => e - all[k][3][i]);
    const turning = kind === ROTATE ? cross(direction, arm) : direction;
    columns[joint] = columns[joint].map((e, i) => e + gain * turning[i]);
  }
  return columns;
}

/**
 * The end of a Jacobian's column, or the ellipsoid of all velocities.
 * @type {(motions: Motion[], all: Frame[], velocity: Velocity) => Frame}
 */
function velocityFrame(motions, all, { of, rates, joint }) {
  const tip = all[of][3];
  const columns = velocities(motions, all, of, rates.length)
    .map((column, i) => column.map((e) => e * rates[i]));
  if (joint != null) return [...all[0].slice(0, 3), tip.map((e, k) => e + columns[joint][k])];
  return [...root([0, 1, 2].map((i) => [0, 1, 2].map((j) =>
    columns.reduce((sum, column) => sum + column[i] * column[j], 0)))), tip];
}

/**
 * Columns of the lower triangle L with L Lᵀ = square; a direction that is flat gets zeros.
 * @param {number[][]} square
 */
function root(square) {
  const columns = [0, 1, 2].map(() => [0, 0, 0]), size = square[0][0] + square[1][1] + square[2][2];
  columns.forEach((column, k) => {
    const left = square.map((row, i) => row[k] - columns.reduce((sum, c) => sum + c[i] * c[k], 0));
    if (left[k] <= 1e-12 * size) return;
    for (let i = k; i < 3; i++) column[i] = left[i] / Math.sqrt(left[k]);
  });
  return columns;
}

/**
 * A frame as another frame sees it.
 * @type {(frame: Frame, other: Frame) => Frame}
 */
export const seenFrom = ([x, y, z, o], [u, v, w, p]) =>
  [x, y, z, o.map((e, k) => e - p[k])].map((column) => [u, v, w].map((e) => dot(e, column)));

/**
 * A point of a frame, in the room.
 * @type {(frame: Frame, point: Triple) => Triple}
 */
export const inRoom = ([x, y, z, o], [a, b, c]) =>
  o.map((_, k) => o[k] + a * x[k] + b * y[k] + c * z[k]);

/**
 * A point of a scene, in the room.
 * @type {(all: Frame[], point: Point) => Triple}
 */
export const roomPoint = (all, [k, ...local]) => inRoom(all[k], local);

/**
 * The motions from a frame back to the room, by the numbers of the frames that they lead to.
 * @param {Motion[]} motions
 * @param {number} frame
 */
export function branch(motions, frame) {
  const way = [];
  for (let k = frame; k > 0; k = motions[k - 1].parent ?? k - 1) way.push(k);
  return way;
}
