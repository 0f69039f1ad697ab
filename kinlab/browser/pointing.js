// What is pointed at in a view. Picture, sliders, tables and formulas tell it when a hand is on one
// of their parts, and hear of it, so that all that belongs to a joint lights up together.

import { valued } from "./dom.js";
import { cornersOf } from "./curves.js";
import { branch, frames } from "./frames.js";
import { Listeners } from "./listeners.js";
import { clip, replaced } from "./steps.js";

/** @import { Elementary, Item, Knob, Motion, Pointed, Scene, Spot } from "./types.js" */
/** @typedef {{ before: string | null, after: string | null }} Tie */
/** @typedef {"hover" | "tap" | "word" | "focus"} Source */

/** @type {Source[]} */
const SOURCES = ["hover", "word", "tap", "focus"];  // the first of them that points counts

/** @type {(motions: Motion[], way: number[], joint: number) => boolean} */
const carries = (motions, way, joint) =>
  way.some((k) => /** @type {Elementary} */ (motions[k - 1]).joint === joint);

/**
 * For each joint the named frames that its motion leads from and to: of those that it carries the
 * one with the fewest motions, and on the way there the last one that it does not carry.
 * @param {Pick<Scene, "motions" | "items" | "knobs">} scene
 * @returns {Tie[]}
 */
export function ties({ motions, items, knobs }) {
  const named = new Map(items.flatMap(({ frame, points }) => frame ? [[frame, points[0][0]]] : []));
  const ways = [...named].map(([name, at]) => ({ name, at, way: branch(motions, at) }))
    .sort((a, b) => a.way.length - b.way.length);
  return knobs.map((_, joint) => {
    const after = ways.find(({ way }) => carries(motions, way, joint));
    const before = after && ways.filter(({ way, at }) =>
      (at === 0 || after.way.includes(at)) && !carries(motions, way, joint)).at(-1);
    return { before: before?.name ?? null, after: after?.name ?? null };
  });
}

/**
 * All that lights up with what is pointed at.
 * @param {Spot} spot
 * @param {Tie[]} all
 * @returns {Pointed}
 */
export function belonging({ joints = [], frames = [], links = [] }, all) {
  const carried = all.flatMap(({ after }, i) => after && frames.includes(after) ? [i + 1] : []);
  const moved = [...joints, ...links, ...carried].filter((joint) => joint >= 1);
  const beside = frames.length ? frames
    : moved.flatMap((joint) => Object.values(all[joint - 1] ?? {}));
  return { joints: new Set(moved), links: new Set([...links, ...moved]),
           frames: new Set(beside.filter((name) => name != null)) };
}

/**
 * Whether a scene has a picture of anything that is pointed at; where it has none, nothing steps
 * back.
 * @param {Item[]} items
 * @param {Pointed} pointed
 */
export const pictured = (items, { joints, frames, links }) =>
  items.some(({ joint, frame, link }) => (joint != null && joints.has(joint)) ||
    (frame && frames.has(frame)) || (link != null && links.has(link)));

/** @type {(pointed: Pointed | null) => string} */
const spelled = (pointed) => pointed == null ? ""
  : JSON.stringify(Object.values(pointed).map((set) => [...set].sort()));

/** The one place of a view that knows what is pointed at. */
export class Pointing {
  /** @type {Pointed | null} */
  now = null;

  /** @type {Tie[]} */
  ties = [];

  /** @type {Partial<Record<Source, Spot | null>>} */
  spots = {};

  /** @type {Listeners<[now: Pointed | null]>} */
  listeners = new Listeners();

  /**
   * Follow a scene from now on.
   * @param {Scene} scene
   */
  follow(scene) {
    this.ties = ties(scene);
    this.spots = {};
    this.settle();
  }

  /**
   * @param {Spot | null} spot
   * @param {Source} source a hand over something, a word of the text, a tap, or the keyboard
   */
  point(spot, source = "hover") {
    this.spots[source] = spot;
    this.settle();
  }

  /** Point at nothing. */
  clear() {
    this.spots = {};
    this.settle();
  }

  /** Point at the next joint, or the one before; beyond the last there is none. */
  step(/** @type {1 | -1} */ way) {
    const [joint = way > 0 ? 0 : this.ties.length + 1] = this.spots.focus?.joints ?? [];
    const next = clip(joint + way, 0, this.ties.length + 1);
    const none = next < 1 || next > this.ties.length;
    this.point(none ? null : { joints: [next] }, "focus");
  }

  settle() {
    const spot = SOURCES.map((source) => this.spots[source]).find((one) => one != null);
    const next = spot ? belonging(spot, this.ties) : null;
    if (spelled(next) === spelled(this.now)) return;
    this.now = next;
    this.listeners.tell(next);
  }

  /**
   * @param {(now: Pointed | null) => void} listener
   * @returns {() => void} ends it
   */
  listen(listener) { return this.listeners.add(listener); }
}

const ELSEWHERE = ["ghost", "trace"];               // layers of where the arm is not
const SHARES = [0.23, 0.61], GOLDEN = 0.618;        // of the knobs' ranges: poses like any other

/**
 * The numbers of the joints on which each of some texts depends.
 * @param {Knob[]} knobs
 * @param {(q: number[]) => string[]} read
 */
export function holdings(knobs, read) {
  const within = (/** @type {number} */ share) => knobs.map(({ low, high }, i) =>
    low + ((share + GOLDEN * i) % 1) * (high - low));
  const poses = SHARES.map(within), others = SHARES.map((share) => within(share + 0.37));
  const before = poses.map(read), moves = poses.map(() => /** @type {string[][]} */ ([]));
  return before[0].map((_, k) => knobs.flatMap((__, joint) => poses.some((pose, p) => {
    const moved = moves[p][joint] ??= read(replaced(pose, joint, others[p][joint]));
    return moved[k] !== before[p][k];
  }) ? [joint + 1] : []));
}

/**
 * The joints that move each item of a sketch that does not say what it is a picture of: arrows,
 * lines, and points with their names.
 * @param {Pick<Scene, "items" | "knobs" | "motions" | "radius">} scene
 * @returns {Map<string, number[]>} by the items' gid
 */
export function moversOf({ items, knobs, motions, radius }) {
  const points = new Set(items.flatMap(({ part, frame }) => part === "point" ? [frame] : []));
  const silent = items.filter(({ joint, link, frame, layer = "" }) => joint == null &&
    link == null && (!frame || points.has(frame)) && !ELSEWHERE.includes(layer));
  const held = holdings(knobs, (q) => {
    const all = frames(motions, q), near = (/** @type {number} */ e) => (e / radius).toFixed(9);
    return silent.map((item) => cornersOf(item, { motions, all, q }).flat().map(near).join());
  });
  return new Map(silent.map(({ gid }, k) => [gid, held[k]]));
}

/**
 * What is pointed at, in words: for those who cannot see it light up, and beside what does.
 * @param {Pointed} pointed
 * @param {Scene} scene
 * @param {number[]} q
 */
export function inWords({ joints, frames, links }, { knobs, items }, q) {
  const of = [...joints].flatMap((joint) => {
    const knob = knobs[joint - 1];
    if (!knob || knob.quantity === "time") return [];
    return `${knob.title}${knob.title && ": "}${valued(knob, q[joint - 1])}`;
  });
  const others = [...frames].map((name) =>
    `${items.some(({ frame, part }) => frame === name && part === "point") ? "point" : "frame"} ` +
    name);
  return (of.length ? of : others.length ? others : links.has(0) ? ["the base"] : []).join("; ");
}
