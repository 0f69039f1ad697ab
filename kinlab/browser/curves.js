// Curves that knobs shape, as in kinlab/drawing/curves.py: where a motion carries a point, and a
// way as far as it has gone.

import { ROTATE, roomPoint, travel } from "./frames.js";
import { clip } from "./steps.js";
import { cross, dot, minus, partway, plus, times } from "./vectors.js";

/** @import { Elementary, Frame, Item, Knob, Motion, Triple } from "./types.js" */
/** @typedef {{ motions: Motion[], all: Frame[], q: number[], knobs?: Knob[] }} Now */

const ARC_STEP = Math.PI / 60;                      // rad from corner to corner of an arc

/**
 * What carries points from where motion `first` leaves them to where motion `last` would: both
 * begin at the same frame and are of one kind, about or along the same axis.
 * @param {number} first
 * @param {number} last
 * @param {Now} now
 */
function carrier(first, last, { motions, all, q }) {
  const [motion, end] = [first, last].map((k) => /** @type {Elementary} */ (motions[k - 1]));
  const way = travel(end, q) - travel(motion, q), turns = motion.kind === ROTATE;
  const axis = all[first][motion.axis], origin = all[first][3];
  const pieces = turns ? Math.max(1, Math.ceil(Math.abs(way) / ARC_STEP - 1e-9)) : 1;
  /** @type {(point: Triple, share: number) => Triple} */
  const carried = (point, share) => {
    const go = share * way;
    if (!turns) return plus(point, times(axis, go));
    const arm = minus(point, origin), side = cross(axis, arm);
    const along = dot(axis, arm), c = Math.cos(go), s = Math.sin(go);
    return arm.map((e, k) =>
      origin[k] + along * axis[k] * (1 - c) + c * e + s * side[k]);
  };
  return { carried, shares: Array.from({ length: pieces + 1 }, (_, k) => k / pieces) };
}

/** @type {(room: Triple[], size: number[], now: Now) => Triple[]} */
function sweptCurve([point], [first, last], now) {
  const { carried, shares } = carrier(first, last, now);
  return shares.map((share) => carried(point, share));
}

/**
 * The outline of what a point sweeps with two motions: each at an end while the other goes.
 * @type {(room: Triple[], size: number[], now: Now) => Triple[]}
 */
function sweptPatch([point], [first, last, inner, end], now) {
  const near = carrier(first, last, now), far = carrier(inner, end, now);
  const at = (/** @type {number} */ s, /** @type {number} */ t) =>
    near.carried(far.carried(point, t), s);
  return [...near.shares.map((s) => at(s, 0)), ...far.shares.map((t) => at(1, t)),
          ...near.shares.map((s) => at(1 - s, 1)), ...far.shares.map((t) => at(0, 1 - t))];
}

/** @type {(room: Triple[], size: number[], now: Now) => Triple[]} */
function wayGone(room, [knob], { q }) {
  const place = clip(q[knob], 0, room.length - 1), k = Math.floor(place);
  const way = room.slice(0, k + 1);
  if (place > k) way.push(partway(room[k], room[k + 1], place - k));
  return way;
}

/** @type {Record<string, (room: Triple[], size: number[], now: Now) => Triple[]>} */
const SHAPED = { sweep: sweptCurve, patch: sweptPatch, way: wayGone };

/**
 * Whether a knob lets an item be seen.
 * @param {Pick<Item, "when">} item
 * @param {number[]} q
 */
export function isThere({ when }, q) {
  if (!when) return true;
  const [knob, low, high] = when, value = q[knob];
  return low > high ? value <= high || value >= low : value >= low && value <= high;
}

/**
 * Points of an item in the room.
 * @param {Pick<Item, "shape" | "points" | "size">} item
 * @param {Now} now
 * @returns {Triple[]}
 */
export function cornersOf({ shape, points, size = [] }, now) {
  const room = points.map((point) => roomPoint(now.all, point));
  return SHAPED[shape]?.(room, size, now) ?? room;
}
