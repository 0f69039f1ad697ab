// Labels that make room for each other: a spring draws each to where it wants to stand, strokes
// and solids push it off, and no two may overlap. kinlab/drawing/labels.py does the same.

import { clip } from "./steps.js";

/** @import { Nothing } from "./types.js" */

/** @typedef {number[]} Px  A point of the picture: right, down. */
/**
 * Words at the tip of an arrow that comes `from` somewhere, or without that at their own anchor,
 * and the `state` that the last picture gave them; without one they are new.
 * @typedef {{ anchor: Px, from?: Px | Nothing, w: number, h: number,
 *             state?: LabelState | Nothing }} Label
 */
/**
 * Where a label stands seen from its anchor, which spot it wants, for how many pictures all have
 * stood still, and where its anchor was.
 * @typedef {{ x: number, y: number, spot: number, age: number, anchor: Px }} LabelState
 */
/** @typedef {{ x: number, y: number, leader: Px[] | null, state: LabelState }} Placed */
/** @typedef {{ a: Px, b: Px, radius?: number }} Bar  A stroke, or a solid with its radius. */
/** @typedef {number[]} Box  The middle of a box, then its width and height. */
/**
 * A label on its way from one point (x, y) to the next (u, v), wanting to be at (s, t); pushes on
 * it are added up in (fx, fy), and only one that is free gives way.
 * @typedef {{ label: Label, index: number, spot: number, w: number, h: number, x: number,
 *             y: number, u: number, v: number, s: number, t: number, fx: number, fy: number,
 *             free: boolean }} Seat
 */
/** @typedef {{ a: Px, b: Px, radius: number, gain: number, owner: number }} Obstacle */
/** @typedef {{ seats: Seat[], bars: Obstacle[], fixed: Box[], size: number[] }} Crowd */

const LETTER_WIDTHS = /** @type {[string, number][]} */ ([
  ["₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ⁰¹²³⁻′", 5.4], [" .,:;'|!ijlI()[]ft/-r·", 5],
  ["mwMW@%—−", 11.6], ["ABCDEFGHKNOPQRSTUVXYZ=+<>×°θ", 9.2],
]);
const LETTER = 8.3, LINE_HEIGHT = 14;
const BESIDE = 3, ASIDE = 4, END_ON = 12, LEADER_GAP = 8.5;             // px
const SPRING = 0.22, OFF_STROKE = 0.5, OFF_SOLID = 0.34, DEEPEST = 12;  // a push grows no further
const EASE = 0.5;                           // of a step: nobody trembles between two others
const TOUCH = 1, OVERLAP = 1, RIM = 2, STILL = 0.01, TINY = 1e-6;
const NEW_STEPS = 140, AGAIN = 40, ROUNDS = 4, NEW_PX = 3, MOST_PX = 2;
const QUIET = 0.06, PATIENCE = 90, SLOWER = 60;                         // pictures
const GAPS = [4, 12, 22, 34, 48], WAYS = 8, SPOTS = GAPS.length * WAYS;

/** @param {string} letter */
function letterWidth(letter) {
  if (letter >= "\u0300" && letter < "\u0370") return 0;                // stands on the one before
  return LETTER_WIDTHS.find(([some]) => some.includes(letter))?.[1] ?? LETTER;
}

/**
 * Width and height of words in bold letters of 12.5 px, by a rule that needs no page.
 * @param {string} text
 */
export const textSize = (text) =>
  [[...text].reduce((sum, letter) => sum + letterWidth(letter), 0), LINE_HEIGHT];

/**
 * Where labels stand, and whether they are still on their way: then place them again with the
 * states they got, though nothing else has moved.
 *
 * New labels find their places at once; others go on by `steps` steps of 2 px at most. A label
 * whose anchor is outside the picture gets null. The labels' own arrows are strokes for others.
 * @param {Label[]} labels
 * @param {Bar[]} strokes
 * @param {Bar[]} solids
 * @param {Box[]} fixed  what stays where it is
 * @param {number[]} size  of the picture
 * @returns {{ places: (Placed | null)[], restless: boolean }}
 */
export function place(labels, strokes, solids, fixed, size, steps = 3) {
  const seats = labels.map(seat).filter(({ label }) => within(label.anchor, size));
  const crowd = { seats, bars: obstacles(labels, strokes, solids), fixed, size };
  const fresh = seats.filter(({ label }) => !label.state);
  const old = seats.filter(({ label }) => label.state), age = ageOf(fresh, old);
  settleNew(fresh, crowd);
  const calm = clip((PATIENCE - age) / SLOWER, 0, 1);
  const moved = walk(old, crowd, steps, MOST_PX * calm);
  const turned = calm > 0 && moved < QUIET && old.some((one) => moves(one, crowd, false));
  const places = /** @type {(Placed | null)[]} */ (labels.map(() => null));
  for (const one of seats) places[one.index] = placed(one, age);
  return { places, restless: turned || moved >= QUIET || fresh.length > 0 };
}

/** @type {(point: Px, size: number[]) => boolean} */
const within = ([x, y], [width, height]) => x >= 0 && x <= width && y >= 0 && y <= height;

/** @type {(label: Label, index: number) => Seat} */
function seat(label, index) {
  const { anchor: [x, y], w, h, state } = label, spot = state?.spot ?? 0;
  const [s, t] = wanted(label, spot), { x: dx, y: dy } = state ?? { x: s, y: t };
  return { label, index, spot, w, h, x: x + dx, y: y + dy, u: x + dx, v: y + dy, s: x + s, t: y + t,
           fx: 0, fy: 0, free: false };
}

/**
 * How far a box reaches from its middle in a direction.
 * @type {(box: { w: number, h: number }, x: number, y: number) => number}
 */
export const extent = ({ w, h }, x, y) => (Math.abs(x) * w + Math.abs(y) * h) / 2;

/**
 * Where a label wants to stand, seen from its anchor: spot 0 is beside the arrowhead, the others
 * lie round it in eight directions, ever farther out.
 * @param {Label} label
 * @param {number} spot
 */
function wanted(label, spot) {
  if (spot) return around(label, (spot - 1) % WAYS, GAPS[Math.floor((spot - 1) / WAYS)]);
  if (!label.from) return [0, 0];
  const [dx, dy] = label.anchor.map((e, k) => e - (label.from?.[k] ?? 0)), d = Math.hypot(dx, dy);
  const share = Math.min(1, d / END_ON), [x, y] = d > TINY ? [dx / d, dy / d] : [0, 0];
  const far = share * (extent(label, x, y) + BESIDE), rest = 1 - share;   // end-on: up, right
  return [far * x - share * ASIDE * y + rest * 10, far * y + share * ASIDE * x - rest * 9];
}

/** @type {(label: Label, way: number, gap: number) => number[]} */
function around(label, way, gap) {
  const x = Math.cos(2 * Math.PI * way / WAYS), y = Math.sin(2 * Math.PI * way / WAYS);
  const far = extent(label, x, y) + gap;
  return [far * x, far * y];
}

/** @type {(labels: Label[], strokes: Bar[], solids: Bar[]) => Obstacle[]} */
function obstacles(labels, strokes, solids) {
  const own = labels.flatMap(({ from, anchor }, owner) =>
    from ? [{ a: from, b: anchor, radius: 0, gain: OFF_STROKE, owner }] : []);
  const other = (/** @type {number} */ gain) => (/** @type {Bar} */ { a, b, radius = 0 }) =>
    ({ a, b, radius, gain, owner: -1 });
  return [...own, ...strokes.map(other(OFF_STROKE)), ...solids.map(other(OFF_SOLID))];
}

/**
 * For how many pictures no anchor has moved; a new label begins anew.
 * @type {(fresh: Seat[], old: Seat[]) => number}
 */
function ageOf(fresh, old) {
  if (fresh.length || !old.every(stands)) return 0;
  return 1 + Math.max(0, ...old.map(({ label }) => label.state?.age ?? 0));
}

/** @param {Seat} one */
function stands({ label: { anchor, state } }) {
  return state?.anchor.every((e, k) => Math.abs(e - anchor[k]) < 0.01) ?? false;
}

/**
 * Places for new labels: a long walk, then other spots for those that still overlap something.
 * @param {Seat[]} fresh
 * @param {Crowd} crowd
 */
function settleNew(fresh, crowd) {
  if (!fresh.length) return;
  walk(fresh, crowd, NEW_STEPS, NEW_PX);
  for (let round = 0; round < ROUNDS; round++) {
    if (!fresh.filter((one) => moves(one, crowd, true)).length) return;
    walk(fresh, crowd, AGAIN, NEW_PX);
  }
}

/**
 * Go some steps, each at most so far; gives how far the last one went.
 * @param {Seat[]} movers
 * @param {Crowd} crowd
 * @param {number} steps
 * @param {number} most
 */
function walk(movers, crowd, steps, most) {
  let moved = steps && Infinity;
  for (const one of movers) one.free = true;
  for (let k = 0; k < steps && moved > STILL; k++) {
    for (const one of movers) drawOn(one, crowd.bars, most);
    for (let sweep = 0; sweep < 2; sweep++) partAll(movers, crowd);
    moved = Math.max(0, ...movers.map((one) => goOn(one, most, crowd.size)));
  }
  for (const one of movers) one.free = false;
  return moved;
}

/** @type {(one: Seat, bars: Obstacle[], most: number) => void} */
function drawOn(one, bars, most) {
  let [fx, fy] = [SPRING * (one.s - one.x), SPRING * (one.t - one.y)];
  for (const bar of bars) {
    if (bar.owner === one.index) continue;
    const [push, x, y] = offBar(one, one.x, one.y, bar);
    fx += push * x;
    fy += push * y;
  }
  const far = Math.hypot(fx, fy), share = far > most ? most / far : 1;
  one.u = one.x + share * fx;
  one.v = one.y + share * fy;
}

/**
 * How hard a bar pushes a box in the middle (x, y), and which way.
 * @type {(box: { w: number, h: number }, x: number, y: number, bar: Obstacle) => number[]}
 */
function offBar(box, x, y, { a, b, radius, gain }) {
  const ex = b[0] - a[0], ey = b[1] - a[1], square = ex * ex + ey * ey;
  const along = square > TINY ? clip(((x - a[0]) * ex + (y - a[1]) * ey) / square, 0, 1) : 0;
  const dx = x - a[0] - along * ex, dy = y - a[1] - along * ey;
  const d = Math.sqrt(dx * dx + dy * dy);
  const nx = d > TINY ? dx / d : Math.SQRT1_2, ny = d > TINY ? dy / d : -Math.SQRT1_2;
  const deep = radius + TOUCH + extent(box, nx, ny) - d;
  return [deep > 0 ? gain * Math.min(deep, DEEPEST) : 0, nx, ny];
}

/**
 * Push labels that overlap out of each other, half the way each, and out of what is fixed.
 * @param {Seat[]} movers
 * @param {Crowd} crowd
 */
function partAll(movers, { seats, fixed }) {
  for (let i = 0; i < seats.length; i++) {
    for (let j = i + 1; j < seats.length; j++) partTwo(seats[i], seats[j]);
  }
  for (const one of movers) {
    for (const box of fixed) shove(one, parting(one, one.u, one.v, box, 1), 1);
    one.u += one.fx;
    one.v += one.fy;
    one.fx = one.fy = 0;
  }
}

/** @type {(one: Seat, other: Seat) => void} */
function partTwo(one, other) {
  if (Math.abs(one.v - other.v) > one.h + other.h) return;              // most are far apart
  const way = parting(one, one.u, one.v, [other.u, other.v, other.w, other.h], -1);
  const share = one.free && other.free ? 0.5 : 1;
  if (one.free) shove(one, way, share);
  if (other.free) shove(other, way, -share);
}

/** @type {(one: Seat, way: number[], share: number) => void} */
function shove(one, [x, y], share) {
  one.fx += share * x;
  one.fy += share * y;
}

/**
 * The shortest way of a box out of another one; `order` decides between two in one place.
 * @param {{ w: number, h: number }} one
 * @param {number} x
 * @param {number} y
 * @param {Box} box
 * @param {number} order
 */
function parting({ w, h }, x, y, [bx, by, bw, bh], order) {
  const dx = x - bx, dy = y - by;
  const across = (w + bw) / 2 + TOUCH - Math.abs(dx), up = (h + bh) / 2 + TOUCH - Math.abs(dy);
  if (across <= 0 || up <= 0) return [0, 0];
  const way = (/** @type {number} */ e) => Math.abs(e) > TINY ? Math.sign(e) : order < 0 ? -1 : 1;
  return across < up - TINY ? [across * way(dx), 0] : [0, up * way(dy)];
}

/** @type {(one: Seat, most: number, size: number[]) => number} */
function goOn(one, most, [width, height]) {
  const dx = one.u - one.x, dy = one.v - one.y, far = Math.hypot(dx, dy);
  const share = Math.min(EASE, most / (far || 1)), [x, y] = [one.x, one.y];
  one.x = keep(x + share * dx, one.w, width);
  one.y = keep(y + share * dy, one.h, height);
  one.u = one.x;
  one.v = one.y;
  return Math.hypot(one.x - x, one.y - y);
}

/**
 * The middle of words inside the picture that would stand about there.
 * @type {(middle: number, length: number, room: number) => number}
 */
export function keep(middle, length, room) {
  const half = Math.min(length / 2 + RIM, room / 2);
  return clip(middle, half, room - half);
}

/**
 * Whether a label takes another spot: one that overlaps the best of all, one that stands aside its
 * usual one when that is free. A new label jumps there, another walks.
 * @type {(one: Seat, crowd: Crowd, jump: boolean) => boolean}
 */
function moves(one, crowd, jump) {
  const crowded = clash(one, one.x, one.y, crowd) > OVERLAP;
  if (!crowded && (jump || !one.spot)) return false;
  const last = crowded ? SPOTS : 0, spot = one.spot;
  let best = cost(one, one.x, one.y, crowd) - (crowded ? 0.5 : 10);
  for (let k = 0; k <= last; k++) {
    const [s, t] = spotAt(one, k, crowd.size), price = cost(one, s, t, crowd);
    if (k === spot || price >= best - TINY) continue;
    [best, one.spot, one.s, one.t] = [price, k, s, t];
  }
  if (jump && spot !== one.spot) [one.x, one.y, one.u, one.v] = [one.s, one.t, one.s, one.t];
  return spot !== one.spot;
}

/** @type {(one: Seat, spot: number, size: number[]) => number[]} */
function spotAt({ label, w, h }, spot, [width, height]) {
  const [x, y] = wanted(label, spot);
  return [keep(label.anchor[0] + x, w, width), keep(label.anchor[1] + y, h, height)];
}

/**
 * How deep a label at (x, y) would lie in others and in what is fixed, added up.
 * @type {(one: Seat, x: number, y: number, crowd: Crowd) => number}
 */
function clash(one, x, y, { seats, fixed }) {
  let sum = 0;
  const add = (/** @type {number[]} */ way) => {
    sum += Math.max(0, Math.abs(way[0]) + Math.abs(way[1]) - TOUCH);
  };
  for (const other of seats) {
    if (other !== one) add(parting(one, x, y, [other.x, other.y, other.w, other.h], 1));
  }
  for (const box of fixed) add(parting(one, x, y, box, 1));
  return sum;
}

/** @type {(one: Seat, x: number, y: number, crowd: Crowd) => number} */
function cost(one, x, y, crowd) {
  const deep = clash(one, x, y, crowd), [ax, ay] = one.label.anchor;
  const pushes = crowd.bars.reduce((sum, bar) =>
    sum + (bar.owner === one.index ? 0 : offBar(one, x, y, bar)[0]), 0);
  return (deep > 0 ? 20 + 10 * deep : 0) + 3 * pushes + 0.5 * Math.hypot(x - ax, y - ay);
}

/** @type {(one: Seat, age: number) => Placed} */
function placed({ label, spot, x, y, w, h }, age) {
  const { anchor } = label, dx = x - anchor[0], dy = y - anchor[1];
  return { x, y, leader: leader(anchor, dx, dy, w / 2, h / 2),
           state: { x: dx, y: dy, spot, age, anchor } };
}

/**
 * The line from an anchor to the rim of words that stand far from it.
 * @type {(anchor: Px, dx: number, dy: number, across: number, up: number) => Px[] | null}
 */
function leader([x, y], dx, dy, across, up) {
  const out = Math.max(Math.abs(dx) / (across || TINY), Math.abs(dy) / (up || TINY));
  const d = Math.hypot(dx, dy);
  const gap = out > 1 ? d * (1 - 1 / out) : 0;
  if (gap <= LEADER_GAP) return null;
  const [start, end] = [2 / d, 1 - 1 / out];
  return [[x + start * dx, y + start * dy], [x + end * dx, y + end * dy]];
}
