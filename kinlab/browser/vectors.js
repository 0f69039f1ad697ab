// Arithmetic with points and directions of the room. Written out: a picture needs it often.

/** @import { Triple } from "./types.js" */

/** @type {(u: Triple, v: Triple) => number} */
export const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];

/** @type {(u: Triple, v: Triple) => Triple} */
export const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];

/** @type {(u: Triple, v: Triple) => Triple} */
export const plus = (u, v) => [u[0] + v[0], u[1] + v[1], u[2] + v[2]];

/** @type {(u: Triple, v: Triple) => Triple} */
export const minus = (u, v) => [u[0] - v[0], u[1] - v[1], u[2] - v[2]];

/** @type {(u: Triple, s: number) => Triple} */
export const times = (u, s) => [u[0] * s, u[1] * s, u[2] * s];

/** @type {(u: Triple) => number} */
export const norm = (u) => Math.sqrt(dot(u, u));

/**
 * The direction of a vector; one without length stays what it is.
 * @type {(u: Triple) => Triple}
 */
export const unit = (u) => times(u, 1 / (norm(u) || 1));

/**
 * The point so far on the way from one to another.
 * @type {(u: Triple, v: Triple, share: number) => Triple}
 */
export const partway = (u, v, share) => plus(u, times(minus(v, u), share));
