// How a frame is turned from the room, as in kinlab/drawing/turned.py: as a quaternion, an axis and
// an angle, and as roll, pitch and yaw.

import { number } from "./dom.js";
import { ROTATE, branch, travel } from "./frames.js";
import { cross, dot, norm, times } from "./vectors.js";

/** @import { Elementary, Frame, Motion, Turned } from "./types.js" */
/** @typedef {{ motions: Motion[], all: Frame[], q: number[] }} Pose */
/** @typedef {(turn: Turned, pose: Pose, decimals: number) => string} Written */

const NO_AXIS = 1e-6;      // sine of half an angle: none that can be told from 0
const LOCKED = 1.41e-6;    // cosine of pitch: none that can be told from 0, as in arms/euler.py
const LEAST = -179.95;     // degrees: below, -180.0 would be shown
const IN_DEGREES = 180 / Math.PI;

/**
 * The unit quaternion [w, x, y, z] of a frame, followed along the motions that lead to it: it moves
 * smoothly with every knob, and its sign never jumps.
 * @param {Motion[]} motions
 * @param {number} frame
 * @param {number[]} q
 */
export function followed(motions, frame, q) {
  let w = 1, v = [0, 0, 0];
  for (const k of branch(motions, frame)) {
    const motion = /** @type {Elementary} */ (motions[k - 1]);   // nothing begins at a velocity
    if (motion.kind !== ROTATE) continue;
    const half = travel(motion, q) / 2, c = Math.cos(half), u = [0, 0, 0];
    u[motion.axis] = Math.sin(half);
    const across = cross(u, v), along = dot(u, v), before = w;
    w = c * before - along;
    v = v.map((e, i) => c * e + before * u[i] + across[i]);
  }
  return [w, ...v];
}

/**
 * Axis, null where any axis will do, and angle (degrees, 0 to 360) of a unit quaternion.
 * @param {number[]} quaternion
 * @returns {{ axis: number[] | null, angle: number }}
 */
export function axisAndAngle([w, ...v]) {
  const sine = norm(v);
  return { axis: sine <= NO_AXIS ? null : times(v, 1 / sine),
           angle: 2 * Math.atan2(sine, w) * IN_DEGREES };
}

/**
 * Degrees, above -180 as they are shown: half a turn has one sign, else it would flicker.
 * @type {(y: number, x: number) => number}
 */
function angleOf(y, x) {
  const angle = Math.atan2(y, x) * IN_DEGREES;
  return angle < LEAST ? angle + 360 : angle;
}

/**
 * Roll, pitch and yaw of a frame in degrees, pitch within 90; at 90 what is left, in words.
 * @param {Frame} frame
 * @returns {number[] | string}
 */
export function rollPitchYaw([[r11, r21, r31], [r12, r22, r32], [, , r33]]) {
  const level = Math.hypot(r11, r21);
  if (level > LOCKED) return [angleOf(r32, r33), angleOf(-r31, level), angleOf(r21, r11)];
  const up = r31 < 0, left = number(angleOf(-r12, r22), 1);
  return `pitch ${number(up ? 90 : -90, 1)}, yaw ${up ? "−" : "+"} roll = ${left}`;
}

/** @type {(numbers: number[], decimals: number) => string} */
const listed = (numbers, decimals) => `(${numbers.map((e) => number(e, decimals)).join(", ")})`;

/** @type {Record<Turned["kind"], Written>} */
const WRITTEN = {
  quaternion: ({ frame }, { motions, q }, decimals) =>
    listed(followed(motions, frame, q), decimals),
  axis: ({ frame }, { motions, q }, decimals) => {
    const { axis } = axisAndAngle(followed(motions, frame, q));
    return axis ? listed(axis, decimals) : "any axis";
  },
  angle: ({ frame }, { motions, q }) => number(axisAndAngle(followed(motions, frame, q)).angle, 1),
  rpy: ({ frame }, { all }) => {
    const angles = rollPitchYaw(all[frame]);
    return typeof angles === "string" ? angles : listed(angles, 1);
  },
};

/**
 * How a frame is turned, in one of these ways, as it stands in a formula.
 * @type {Written}
 */
export const turnedAs = (turn, pose, decimals) => WRITTEN[turn.kind](turn, pose, decimals);
