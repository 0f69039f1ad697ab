// Solids as lit faces on the picture, as in kinlab/drawing/solids.py. A round body is one outline
// with a gradient across it: it looks like many narrow faces, without their seams.

import { onPicture } from "./camera.js";
import { clip } from "./steps.js";
import { cross, dot, minus, norm, partway, plus, times, unit } from "./vectors.js";

/** @import { Across, Face, Frame, Lens, Paint, Shape, Triple } from "./types.js" */
/** @typedef {[first: Triple, second: Triple]} Ends */

// ---- light ----

const BRIGHTEST = 27;                               // levels go from 0, which lies in the shade
const LIGHT = unit([-0.5, 0.72, 0.62]);             // to the right, up, towards the viewer
const EDGE_ON = 1e-9;                               // what is turned away by less is not seen

/**
 * How bright a surface is, from 0 to 1, that looks in a direction (right, up, near). Without the
 * last term a drum whose end points at the light would look flat.
 * @param {Triple} normal
 */
function shine(normal) {
  const lit = Math.max(0, 0.5 + 0.5 * dot(normal, LIGHT));
  return clip(-0.06 + 0.76 * lit ** 1.3 + 0.36 * Math.max(0, normal[2]), 0, 1);
}

/** @type {(brightness: number) => number} */
const levelOf = (brightness) => Math.floor(BRIGHTEST * brightness + 0.5);

/** @type {(colour: string) => number[]} */
const channels = (colour) => [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16));

/** @type {(one: string, other: string, share: number) => string} */
const blend = (one, other, share) => `#${partway(channels(one), channels(other), share)
  .map((c) => Math.floor(c + 0.5).toString(16).padStart(2, "0")).join("")}`;

/**
 * The colours of all levels, made from those in the shade, between, and in the light.
 * @param {string[]} ramp
 */
export const shades = ([shade, middle, light]) => Array.from({ length: BRIGHTEST + 1 }, (_, k) => {
  const share = 2 * k / BRIGHTEST;
  return share < 1 ? blend(shade, middle, share) : blend(middle, light, share - 1);
});

/**
 * A colour that steps back into the paper, whatever the theme's paper is. It may stand in an
 * attribute of SVG, which costs no more than a style.
 * @type {(colour: string) => string}
 */
export const dimmed = (colour) => `color-mix(in srgb, ${colour} 22%, var(--kl-paper))`;

/**
 * A colour that steps back half of the way, behind what is drawn over it.
 * @type {(colour: string) => string}
 */
export const pale = (colour) => `color-mix(in srgb, ${colour} 45%, var(--kl-paper))`;

// ---- outlines ----

/**
 * Directions of so many corners of a circle of radius 1.
 * @type {(count: number) => number[][]}
 */
export const circleOf = (count) => Array.from({ length: count }, (_, k) => 2 * Math.PI * k / count)
  .map((angle) => [Math.cos(angle), Math.sin(angle)]);

const COARSE = circleOf(18), FINE = circleOf(36), SMALL = 34;   // px: the radius of a coarse one

/** @type {(radius: number) => number[][]} */
const circleFor = (radius) => radius > SMALL ? FINE : COARSE;

/** @type {(o: number[], a: number[], b: number[]) => number} */
const bend = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);

/** @param {number[][]} chain */
function halfHull(chain) {
  /** @type {number[][]} */
  const kept = [];
  for (const p of chain) {
    for (let k = kept.length; k > 1 && bend(kept[k - 2], kept[k - 1], p) <= 0; k--) kept.pop();
    kept.push(p);
  }
  return kept;
}

/**
 * Corners of the convex outline round points of the picture, by Andrew's monotone chain.
 * @param {number[][]} points
 */
export function hull(points) {
  const ordered = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const under = halfHull(ordered), over = halfHull(ordered.reverse());
  return [...under.slice(0, -1), ...over.slice(0, -1)];
}

/** @type {(...details: [Face["role"], number[][], number]) => Face} */
const flat = (role, points, level) => ({ role, points, level, gradient: null });

// ---- tubes ----

const HUB = 0.66;                                   // radius of the disc on an end
const LIGHTER = 5;                                  // levels by which an end stands out
const STOPS = [-1, -0.65, 0, 0.65, 1];              // across a tube, where its levels are told
/** Where a gradient's levels stand on its way, from 0 to 1. */
export const OFFSETS = { across: STOPS.map((u) => (u + 1) / 2), round: [0, 0.5, 1] };

/** @typedef {{ lens: Lens, ends: Triple[], radii: number[], direction: Triple, length: number,
 *              sideways: Triple[] }} Tube */

/**
 * @param {Lens} lens
 * @param {Triple[]} points
 * @param {number[]} radii
 * @param {Paint} paint
 * @param {Frame} frame
 */
function tubeFaces(lens, points, radii, paint, frame) {
  const ends = points.slice(0, 2), along = minus(ends[1], ends[0]), length = norm(along);
  const direction = length > 0 ? unit(along) : frame[2];
  const tube = { lens, ends, radii, direction, length, sideways: sidewaysOf(direction, frame) };
  const seen = seenEnd(tube), outline = hull([...rim(tube, 0, 1), ...rim(tube, 1, 1)]);
  /** @type {Face[]} */
  const all = [{ role: "side", points: outline, level: null, gradient: flank(tube, !paint.cap) }];
  if (seen >= 0) all.push(...discs(tube, seen, paint));
  const stripe = paint.hub ? stripeOf(tube, seen) : [];
  if (stripe.length) all.push({ role: "mark", points: stripe, level: null, gradient: null });
  return all;
}

/**
 * Two directions at right angles to a tube; they turn with its frame.
 * @param {Triple} direction
 * @param {Frame} frame
 */
function sidewaysOf(direction, [x, , z]) {
  const guide = Math.abs(dot(direction, z)) > 0.9 ? x : z;
  const first = unit(minus(guide, times(direction, dot(guide, direction))));
  return [first, cross(direction, first)];
}

/**
 * A circle round one end of a tube, on the picture; `share` of the tube's radius there.
 * @param {Tube} tube
 * @param {number} end
 * @param {number} share
 */
function rim({ lens, ends, radii, sideways: [u, v] }, end, share) {
  const middle = ends[end], radius = share * radii[end];
  const large = Math.max(...radii) * lens.scale * lens.see(middle)[2];
  return circleFor(large).map(([c, s]) =>
    onPicture(lens, plus(middle, plus(times(u, radius * c), times(v, radius * s)))));
}

/**
 * The end that looks at the viewer, -1 for none.
 * @param {Tube} tube
 */
function seenEnd({ lens, ends: [first, second], direction }) {
  if (dot(direction, lens.eye(second)) > EDGE_ON) return 1;
  return dot(direction, lens.eye(first)) < -EDGE_ON ? 0 : -1;
}

/**
 * The disc of an end, and a smaller one on it.
 * @param {Tube} tube
 * @param {number} end
 * @param {Paint} paint
 */
function discs(tube, end, { cap, hub }) {
  const level = levelOf(shine(tube.lens.turn(times(tube.direction, end ? 1 : -1))));
  return [
    ...cap ? [flat("cap", rim(tube, end, 1), Math.min(BRIGHTEST, level + LIGHTER))] : [],
    ...hub ? [flat("hub", rim(tube, end, HUB), level)] : [],
  ];
}

/**
 * The direction in which the skin looks where `side` lies: a cone's leans to its thin end.
 * @param {Tube} tube
 * @param {Triple} side
 * @param {Triple} direction
 */
const skin = ({ length, radii: [first, second] }, side, direction) =>
  unit(plus(times(side, length), times(direction, first - second)));

/**
 * The gradient across a tube. An end that has no disc of its own lends the tube its brightness,
 * the more the more of it is seen.
 * @param {Tube} tube
 * @param {boolean} open
 * @returns {Across}
 */
function flank(tube, open) {
  const { lens, ends: [first, second], radii, direction, length } = tube;
  const middle = partway(first, second, 0.5), place = lens.see(middle), n = lens.turn(direction);
  const eye = unit(lens.turn(lens.eye(middle))), near = dot(n, eye), tall = norm(cross(n, eye));
  const across = tall > EDGE_ON ? unit(cross(n, eye)) : [1, 0, 0], ahead = cross(across, n);
  const share = open ? discShare(tall * length, 2 * radii[near > 0 ? 1 : 0] * near) : 0;
  const end = shine(near > 0 ? n : times(n, -1));
  const levels = STOPS.map((u) => {
    const side = plus(times(across, u), times(ahead, Math.sqrt(1 - u * u)));
    return levelOf((1 - share) * shine(skin(tube, side, n)) + share * end);
  });
  const reach = Math.max(...radii) * lens.scale * place[2];
  return { from: beside(place, across, -reach), to: beside(place, across, reach), levels };
}

/**
 * How much of what is seen of a tube is its end: all of it when one looks along the tube.
 * @type {(tall: number, deep: number) => number}
 */
const discShare = (tall, deep) => deep ** 2 / (deep ** 2 + tall ** 2) || 0;

/** @type {(place: number[], across: Triple, reach: number) => number[]} */
const beside = ([x, y], [right, up], reach) => [x + reach * right, y - reach * up];

/**
 * A line on the seen end and down the skin, where either is seen: it shows how a tube is turned.
 * @param {Tube} tube
 * @param {number} seen
 */
function stripeOf(tube, seen) {
  const { lens, ends, radii, direction, sideways: [u] } = tube, end = seen < 0 ? 1 : seen;
  const at = (/** @type {number} */ k, share = 1) => plus(ends[k], times(u, share * radii[k]));
  const middle = partway(at(0), at(1), 0.5);
  const down = dot(skin(tube, u, direction), lens.eye(middle)) > EDGE_ON;
  const line = [...seen < 0 ? [] : [at(end, HUB)], ...seen < 0 && !down ? [] : [at(end)],
                ...down ? [at(1 - end)] : []];
  return line.map((point) => onPicture(lens, point));
}

// ---- balls ----

const SPOT = [-0.3, 0.43];                          // where a ball is brightest: right, up
const SPREAD = 1 + Math.hypot(...SPOT);             // from there to the farthest rim

/** The levels of every ball, from its spot through its middle to the rim. */
const BALL = OFFSETS.round.map((share) => {
  const [x, y] = SPOT.map((e) => e * (1 - share * SPREAD / (SPREAD - 1)));
  return levelOf(shine([x, y, Math.sqrt(Math.max(0, 1 - x * x - y * y))]));
});

/**
 * @param {Lens} lens
 * @param {Triple[]} points
 * @param {number[]} size
 * @returns {Face[]}
 */
function ballFaces(lens, [middle], [radius]) {
  const [x, y, near] = lens.see(middle), r = radius * lens.scale * near;
  const points = circleFor(r).map(([c, s]) => [x + r * c, y + r * s]);
  const center = [x + r * SPOT[0], y - r * SPOT[1]];
  const gradient = { center, radius: r * SPREAD, levels: BALL };
  return [{ role: "side", points, level: null, gradient }];
}

// ---- boxes ----

const HAIR = 1e-3;                                  // of a box's width: what is shorter is hidden
const CORNERS = [[-1, -1], [1, -1], [1, 1], [-1, 1]];

/**
 * @param {Lens} lens
 * @param {Triple[]} points
 * @param {number[]} size
 * @param {Paint} paint
 * @param {Frame} frame
 */
function boxFaces(lens, [first, second, third, fourth], [ahead], paint, frame) {
  const along = minus(second, first), u = minus(third, first), v = minus(fourth, first);
  if (norm(along) <= HAIR * Math.max(norm(u), norm(v))) return [];
  if (ahead === 1 && dot(along, frame[2]) < 0) return [];
  const halves = [times(along, 0.5), u, v], middle = plus(first, halves[0]);
  const hand = dot(along, cross(u, v)) < 0 ? -1 : 1;
  return halves.flatMap((half, k) => [-1, 1].flatMap((side) => {
    const p = halves[(k + 1) % 3], q = halves[(k + 2) % 3], at = plus(middle, times(half, side));
    const normal = unit(times(cross(p, q), side * hand));
    if (dot(normal, lens.eye(at)) <= EDGE_ON) return [];
    const points = CORNERS.map(([i, j]) =>
      onPicture(lens, plus(at, plus(times(p, i), times(q, j)))));
    const role = k === 0 && paint.hub ? "hub" : "face";
    return [flat(role, points, levelOf(shine(lens.turn(normal))))];
  }));
}

// ---- all of them ----

/** @typedef {(...given: [Lens, Triple[], number[], Paint, Frame]) => Face[]} Maker */
/** @type {Partial<Record<Shape, Maker>>} */
const MAKERS = { tube: tubeFaces, ball: ballFaces, box: boxFaces };

/**
 * What is seen of a solid, in the order of painting; nothing where it is hidden.
 * @param {Shape} shape
 * @param {Lens} lens
 * @param {Triple[]} points of the item, in the room
 * @param {number[]} size
 * @param {Paint} paint
 * @param {Frame} frame in which the first point stands
 */
export function faces(shape, lens, points, size, paint, frame) {
  return MAKERS[shape]?.(lens, points, size, paint, frame) ?? [];
}
