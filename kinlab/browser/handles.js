// From the pointer to the knobs: how a point of the room that a hand holds is made to follow it.
// One joint follows on its own circle or line; several share the work in damped steps.

import { descend, kept } from "./chase.js";
import { ROTATE, branch, frames, inRoom, roomPoint, travel } from "./frames.js";
import { clip, replaced } from "./steps.js";
import { cross, dot, minus, norm, plus, times, unit } from "./vectors.js";

/** @import { Elementary, Frame, Handle, Item, Lens, Motion, Scene, Triple } from "./types.js" */
/** @typedef {number[]} Spot right and down on the picture, px */
/**
 * @typedef {(hand: Spot, lens: Lens, q: number[]) => number[]} Pull
 *   the knobs' values that bring what is held to the hand
 */

const SLANT = 0.2;        // sine of the angle at which a circle counts as seen from its edge
const LEVER = 9;         // px from an axis at which a hand begins to say how far to turn
const DEPTH = 0.3;       // how much it counts to stay as near to the viewer as before
const NUDGE = 1e-6;       // of a knob, for slopes

// ---- where things are ----

/** @type {(motions: Motion[], frame: number) => number[]} */
const wayTo = (motions, frame) => branch(motions, frame).reverse().map((k) => k - 1);

/**
 * The same motions as a chain without branches. Nobody holds the end of a velocity.
 * @param {Motion[]} motions
 * @param {number} frame
 */
export const chainTo = (motions, frame) => wayTo(motions, frame).map((k) =>
  ({ .../** @type {Elementary} */ (motions[k]), parent: undefined }));

/** @type {(motion: Motion, knob: number) => boolean} */
const drives = (motion, knob) => motion.kind !== "velocity" &&
  (motion.joint === knob || motion.scrub?.knob === knob);

/**
 * How fast a motion goes while a knob moves at one.
 * @type {(motion: Elementary, q: number[], knob: number) => number}
 */
function slope(motion, q, knob) {
  if (!drives(motion, knob)) return 0;
  const [ahead, behind] = [NUDGE, -NUDGE].map((by) =>
    travel(motion, replaced(q, knob, q[knob] + by)));
  return (ahead - behind) / (2 * NUDGE);
}

/**
 * Velocities of a point at the end of a chain for each of some knobs.
 * @param {Elementary[]} chain
 * @param {Frame[]} all the frames along it
 * @param {Triple} place of the point in the room
 * @param {number[]} q
 * @param {number[]} movers
 */
export const speeds = (chain, all, place, q, movers) => movers.map((knob) =>
  chain.reduce((sum, motion, k) => {
    const rate = slope(motion, q, knob), frame = all[k + 1], direction = frame[motion.axis];
    if (!rate) return sum;
    const way = motion.kind === ROTATE ? cross(direction, minus(place, frame[3])) : direction;
    return plus(sum, times(way, rate));
  }, /** @type {Triple} */ ([0, 0, 0])));

/**
 * The point under the hand that is as far from the viewer as another.
 * @param {Spot} hand
 * @param {Triple} point
 * @param {Lens} lens
 */
export function under(hand, point, lens) {
  const [right, down, size] = lens.see(point), s = 1 / (lens.scale * size);
  return plus(point, plus(times(lens.right, (hand[0] - right) * s),
                          times(lens.up, (down - hand[1]) * s)));
}

/**
 * The radius of a round body, 0 of another.
 * @param {Item} item
 */
export const roundness = ({ shape, size }) => shape === "box" ? 0 : size?.[0] ?? 0;

/**
 * How far a hand is from the middle line of a solid (px), and the point of the room it holds there.
 * @param {Item} item
 * @param {Frame[]} all
 * @param {Spot} hand
 * @param {Lens} lens
 */
export function touched(item, all, hand, lens) {
  const ends = item.points.slice(0, 2).map((point) => roomPoint(all, point));
  const [from, to = from] = ends.map((end) => lens.see(end)), [first, last = first] = ends;
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]], square = dx * dx + dy * dy;
  const along = ((hand[0] - from[0]) * dx + (hand[1] - from[1]) * dy) / (square || 1);
  const middle = plus(first, times(minus(last, first), clip(along, 0, 1)));
  const seen = lens.see(middle), far = Math.hypot(hand[0] - seen[0], hand[1] - seen[1]);
  const radius = roundness(item), aside = far / (lens.scale * seen[2]);
  const nearer = Math.sqrt(Math.max(0, radius * radius - aside * aside));
  const held = under(hand, middle, lens);
  return { far, place: plus(held, times(unit(lens.eye(held)), nearer)) };
}

// ---- one joint ----

/**
 * A number that stands for the same angle and lies at most half a turn from 0.
 * @type {(angle: number) => number}
 */
const halfTurn = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

/**
 * Whether a motion goes as its knob goes, all the time.
 * @param {Motion} motion
 */
const plain = (motion) => motion.kind !== "velocity" && motion.scrub == null &&
  motion.track == null && motion.start == null && motion.gain !== 0;

/**
 * The motion by which a body goes with its joint, by its number; -1 if there is none. What stands
 * on the base is the housing of the joint after it.
 * @param {Motion[]} motions
 * @param {Item} item
 */
export function jointMotion(motions, { points, joint, link }) {
  const ends = points.map(([frame]) => frame), knob = (link || joint || 0) - 1;
  const after = ends.filter((frame) => (motions[frame]?.parent ?? frame) === frame);
  const driven = new Set([...ends.flatMap((frame) => wayTo(motions, frame)), ...after]
    .filter((k) => motions[k] && drives(motions[k], knob)));
  const [only] = driven;
  return driven.size === 1 && plain(motions[only]) ? only : -1;
}

/** @typedef {{ middle: Triple, axis: Triple, u: Triple, v: Triple, radius: number }} Circle */

/**
 * The circle of a point that turns about an axis; angles count from the point.
 * @type {(origin: Triple, axis: Triple, place: Triple) => Circle}
 */
function wheelOf(origin, axis, place) {
  const middle = plus(origin, times(axis, dot(minus(place, origin), axis)));
  const out = minus(place, middle), radius = norm(out);
  const any = Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  const u = unit(radius > 0 ? out : cross(axis, any));
  return { middle, axis, u, v: cross(axis, u), radius };
}

/**
 * The angle at which the hand's ray meets a circle's plane; null close to the axis.
 * @type {(circle: Circle, hand: Spot, lens: Lens) => number | null}
 */
function directionOf({ middle, axis, u, v }, hand, lens) {
  const at = under(hand, middle, lens), ray = lens.eye(at);
  const met = plus(at, times(ray, dot(minus(middle, at), axis) / dot(ray, axis)));
  const [x, y] = [u, v].map((side) => dot(minus(met, middle), side));
  return Math.hypot(x, y) * lens.scale < LEVER ? null : Math.atan2(y, x);
}

/**
 * How far a circle seen from its edge turns, as a wheel does under a hand.
 * @type {(circle: Circle, start: Spot, hand: Spot, lens: Lens) => number}
 */
function rolled({ middle, axis, u, radius }, start, hand, lens) {
  const near = unit(lens.eye(middle)), [right, up] = lens.turn(unit(cross(axis, near)));
  const way = (hand[0] - start[0]) * right - (hand[1] - start[1]) * up;
  return (dot(u, near) < -0.5 ? -way : way) / Math.max(2 * LEVER, radius * lens.scale);
}

/** @typedef {(hand: Spot, lens: Lens) => number} Follow how far a joint has gone for the hand */

/**
 * How far a joint has turned about its axis so that what is held follows the hand.
 * @type {(origin: Triple, axis: Triple, place: Triple, start: Spot, lens: Lens) => Follow}
 */
function turningBy(origin, axis, place, start, lens) {
  const circle = wheelOf(origin, axis, place);
  if (Math.abs(dot(unit(lens.eye(circle.middle)), axis)) < SLANT) {
    return (hand, seen) => rolled(circle, start, hand, seen);
  }
  let turned = 0, last = directionOf(circle, start, lens);
  return (hand, seen) => {
    const now = directionOf(circle, hand, seen);
    if (now != null && last != null) turned += halfTurn(now - last);
    last = now;
    return turned;
  };
}

/**
 * How far a joint has slid so that what is held is as near to the hand as its line comes; along
 * a line that points at the viewer, up is out.
 * @type {(axis: Triple, place: Triple, start: Spot) => Follow}
 */
const slidingBy = (axis, place, start) => (hand, lens) => {
  const [right, up] = lens.turn(axis);
  if (right * right + up * up < SLANT * SLANT) return (start[1] - hand[1]) / lens.scale;
  let way = 0;
  for (let round = 0; round < 4; round++) {          // one is enough without perspective
    const [here, next] = [0, 1].map((by) =>
      lens.see(plus(place, times(axis, way + by / lens.scale))));
    const [dx, dy] = [next[0] - here[0], next[1] - here[1]];
    way += ((hand[0] - here[0]) * dx + (hand[1] - here[1]) * dy)
      / (dx * dx + dy * dy) / lens.scale;
  }
  return way;
};

/** @typedef {{ all: Frame[], q: number[], hand: Spot, lens: Lens }} Start where a hand begins */

/**
 * What makes the joint that a motion is carry a place of its link after the hand.
 * @param {Scene} scene
 * @param {number} k of the motion
 * @param {Triple} place in the room, under the hand
 * @param {Start} start
 * @returns {Pull}
 */
export function pullJoint(scene, k, place, { all, q, hand: start, lens }) {
  const motion = /** @type {Elementary} */ (scene.motions[k]), { kind, axis, gain = 1 } = motion;
  const frame = all[k + 1], knob = /** @type {number} */ (motion.joint);
  const follow = kind === ROTATE ? turningBy(frame[3], frame[axis], place, start, lens)
    : slidingBy(frame[axis], place, start);
  return (hand, seen, now) =>
    replaced(now, knob, kept(q[knob] + follow(hand, seen) / gain, scene.knobs[knob]));
}

// ---- several joints ----

/**
 * What makes the knobs of a handle carry its point after the hand. Where there are more than two
 * the point stays about as near to the viewer as it was.
 * @param {Scene} scene
 * @param {Handle} handle
 * @param {Triple} place of its point now
 * @returns {Pull}
 */
export function pullPoint(scene, { point: [frame, ...local], knobs: movers }, place) {
  const chain = chainTo(scene.motions, frame), { radius, knobs } = scene;
  const deep = movers.length > 2 ? DEPTH : 0;
  return (hand, lens, q) => descend({ knobs, movers, radius, idle: 1e-7, aim: (at) => {
    const all = frames(chain, at), now = inRoom(all[chain.length], local);
    const [right, down, size] = lens.see(now), px = lens.scale * size * radius;
    const e = [(hand[0] - right) / px, (down - hand[1]) / px,
               deep * dot(minus(place, now), lens.near) / radius];
    return { e, columns: () => speeds(chain, all, now, at, movers).map((column) => {
      const [a, b, c] = lens.turn(column);
      return [a, b, deep * c];
    }) };
  } }, q).q;
}

/**
 * What makes a handle follow the hand: by its one joint, or by several knobs together.
 * @param {Scene} scene
 * @param {Handle} handle
 * @param {Start} start the hand on its point
 * @returns {Pull}
 */
export function pullHandle(scene, handle, start) {
  const { point, knobs } = handle, place = roomPoint(start.all, point);
  const driven = wayTo(scene.motions, point[0]).filter((k) => drives(scene.motions[k], knobs[0]));
  return knobs.length === 1 && driven.length === 1 && plain(scene.motions[driven[0]])
    ? pullJoint(scene, driven[0], place, start) : pullPoint(scene, handle, place);
}
