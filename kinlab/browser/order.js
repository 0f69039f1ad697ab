// Painter's order: which body is drawn over which, as in kinlab/drawing/order.py. A plane between
// two bodies tells: the one on the viewer's side of it is in front.

import { clip } from "./steps.js";
import { dot, minus, norm, partway, plus, times } from "./vectors.js";

/** @import { Lens, Triple } from "./types.js" */
/**
 * @typedef {{ p: Triple, q: Triple, r: number,
 *   plane?: { normal: Triple, at: Triple } | null }} Body
 *   what lies within r of the line from p to q; beyond the plane of a flat base everything else
 *   stands before or behind it as a whole
 */
/** @typedef {{ a: Triple, b: Triple, r: number, depth: number, box: number[] }} Seen */

const STROKE = 1.5;                                 // px: half a stroke and a little air
const LEVEL = 1e-9;                                 // of a length: side by side, none in front
const TUCKED = 0.8, ENDS = 0.01;                    // radii: a line that begins inside a solid
const SAME = 1e-6;                                  // px: depths that differ less are the same

/**
 * Indices of bodies from the farthest to the nearest. Nothing is remembered from one picture to
 * the next: the same pose gives the same order. Where several may come next, and where bodies
 * cover each other in a circle, the farthest does, and of equal ones the first.
 * @param {Body[]} bodies
 * @param {Lens} lens
 */
export function backToFront(bodies, lens) {
  const seen = bodies.map((body) => seenBody(body, lens)), n = bodies.length;
  /** @type {number[][]} */
  const over = bodies.map(() => []), below = new Array(n).fill(0);
  for (let i = 0; i < n; i++) for (let j = i + 1; j < n; j++) {
    if (!(bodies[i].r || bodies[j].r) || !meet(seen[i], seen[j])) continue;
    const front = inFront(bodies[i], bodies[j], lens) || seen[j].depth - seen[i].depth;
    if (front === 0) continue;
    const [back, fore] = front > 0 ? [i, j] : [j, i];
    over[back].push(fore);
    below[fore]++;
  }
  return sorted(seen.map((body) => body.depth), over, below);
}

/**
 * @param {number[]} depths
 * @param {number[][]} over what has to come later than each
 * @param {number[]} below how many have to come before each
 */
function sorted(depths, over, below) {
  const left = depths.map((_, i) => i).sort((i, j) => depths[i] - depths[j] || i - j), order = [];
  while (left.length) {
    const k = Math.max(0, left.findIndex((i) => below[i] === 0)), [next] = left.splice(k, 1);
    order.push(next);
    for (const i of over[next]) below[i]--;
  }
  return order;
}

/**
 * A body on the picture: a stroke with its half width (px), and how near its middle is.
 * @type {(body: Body, lens: Lens) => Seen}
 */
function seenBody({ p, q, r }, { see, near, scale }) {
  const [x, y, f] = see(p), [u, v, g] = see(q), wide = r * scale * Math.max(f, g) + STROKE;
  return { a: [x, y, 0], b: [u, v, 0], r: wide,
           depth: Math.floor(dot(partway(p, q, 0.5), near) * scale / SAME + 0.5),
           box: [Math.min(x, u) - wide, Math.max(x, u) + wide,
                 Math.min(y, v) - wide, Math.max(y, v) + wide] };
}

/**
 * Whether two bodies lie over each other on the picture.
 * @param {Seen} one
 * @param {Seen} other
 */
function meet({ a, b, r, box: P }, { a: c, b: d, r: s, box: Q }) {
  if (P[0] > Q[1] || Q[0] > P[1] || P[2] > Q[3] || Q[2] > P[3]) return false;
  const gap = minus(...nearest(a, b, c, d));
  return dot(gap, gap) <= (r + s) ** 2;
}

/**
 * Above zero where `other` is in front of `one`, below where it is behind, zero where the plane
 * between them says nothing.
 * @param {Body} one
 * @param {Body} other
 * @param {Lens} lens
 */
function inFront(one, other, lens) {
  if (one.plane) return sideOf(one.plane, other, lens);
  if (other.plane) return -sideOf(other.plane, one, lens);
  const [a, b] = nearest(one.p, one.q, other.p, other.q), d = minus(b, a), gap = norm(d);
  if (!one.r && tucked(other, b, gap)) return 1;
  if (!other.r && tucked(one, a, gap)) return -1;
  const middle = gap ? clip((gap + one.r - other.r) / (2 * gap), 0, 1) : 0;   // of what is free
  const eye = lens.eye(plus(a, times(d, middle))), front = dot(d, eye);
  return Math.abs(front) > LEVEL * (gap + one.r + other.r) ? front : 0;
}

/**
 * Above zero where a body is on the viewer's side of a plane, below where it is beyond.
 * @param {NonNullable<Body["plane"]>} plane
 * @param {Body} body
 * @param {Lens} lens
 */
const sideOf = ({ normal, at }, { p, q }, { eye }) =>
  Math.sign(dot(minus(partway(p, q, 0.5), at), normal)) * Math.sign(dot(normal, eye(at)));

/**
 * Whether a line comes out of a solid's side: the solid covers what is inside it.
 * @type {(solid: Body, at: Triple, gap: number) => boolean}
 */
const tucked = ({ p, q, r }, at, gap) => gap < TUCKED * r &&
  Math.min(norm(minus(at, p)), norm(minus(at, q))) > ENDS * r;

/**
 * The points of two segments that are nearest to each other; of parallel ones, those in the middle
 * of what lies side by side: so it is all the same which of the two comes first.
 * @param {Triple} p
 * @param {Triple} q
 * @param {Triple} s
 * @param {Triple} t
 * @returns {[Triple, Triple]}
 */
function nearest(p, q, s, t) {
  const d = minus(q, p), e = minus(t, s), r = minus(p, s);
  const dd = dot(d, d), ee = dot(e, e), de = dot(d, e), dr = dot(d, r), er = dot(e, r);
  const square = dd * ee - de * de;
  const beside = dd ? (clip(-dr / dd, 0, 1) + clip((de - dr) / dd, 0, 1)) / 2 : 0;
  const first = square > 1e-9 * dd * ee ? clip((de * er - dr * ee) / square, 0, 1) : beside;
  const along = ee ? clip((de * first + er) / ee, 0, 1) : 0;
  return [plus(p, times(d, dd ? clip((de * along - dr) / dd, 0, 1) : 0)), plus(s, times(e, along))];
}
