// The ground as points of the picture: a grid with numbers, shadows, and lines dropped on it.
// kinlab/drawing/floor.py does the same.

import { onPicture } from "./camera.js";
import { number } from "./dom.js";
import { extent, keep, textSize } from "./labels.js";
import { circleOf, hull } from "./solids.js";
import { clip } from "./steps.js";
import { minus, plus, times } from "./vectors.js";

/** @import { Box, Px } from "./labels.js" */
/** @import { Floor, Lens, Shape, Triple } from "./types.js" */

/** @typedef {{ text: string, place: Px, w: number, h: number }} Words */
/** @typedef {Words & { axis: "x" | "y", opacity: number }} RulerNumber */
/** @typedef {{ center: Px, radius: number, squeeze: number }} Fade  A circle, flattened. */
/**
 * What stands on the floor and is seen through a lens: `rim` is the outline of all of it, rulers
 * are lines along x and y, and `below` says that the viewer looks at it from underneath.
 * @typedef {{ below: boolean, grid: Px[][], rulers: Px[][], rim: Px[], numbers: RulerNumber[],
 *             fade: Fade }} Ground
 */
/** @typedef {{ shape: Shape, ends: Triple[], size: number[] }} Solid  As its item tells of it. */
/**
 * A line from a point to the floor, with its ends in the room; a ring round its foot, guides from
 * there to the rulers, and at most two texts: where the foot stands, and how high the point.
 * @typedef {{ ends: Triple[], line: Px[], foot: Px[], guides: Px[][], texts: Words[] }} Drop
 */

/** How strongly the floor is drawn, so far from its middle: shares of the radius, opacities. */
export const FADE = [[0, 1], [0.55, 0.8], [1, 0]];

const MOST_LINES = 200, RIM_SIDES = 48, DISC_SIDES = 16, RING_SIDES = 18, FLATTEST = 0.2;
const RING = 5, NUMBER_GAP = 5, BETWEEN = 6, PALEST = 0.3, SHORTEST = 1e-3, INSIDE = 2;   // px
const FOOT_DOWN = 15, FOOT_ASIDE = 44, NEAR_MIDDLE = 150, HIGH_ASIDE = 6, LONG = 40;      // px
const EVERY = [1, 2, 5, 10, 20, 50, 100];
const SQUARE = [[1, 1], [1, -1], [-1, -1], [-1, 1]];

const RIM_CIRCLE = circleOf(RIM_SIDES), DISC = circleOf(DISC_SIDES),
      SMALL_RING = circleOf(RING_SIDES);

/**
 * The floor as seen through a lens, on a picture of this size.
 * @param {Floor} floor
 * @param {Lens} lens
 * @param {number[]} size
 * @returns {Ground}
 */
export function ground(floor, lens, size) {
  const { height, reach } = floor, middle = [0, 0, height], fade = fadeOf(floor, lens);
  const across = (/** @type {number} */ k, /** @type {number} */ at) => [-1, 1].map((side) => {
    const half = side * Math.sqrt(Math.max(0, reach * reach - at * at));
    return onPicture(lens, k ? [at, half, height] : [half, at, height]);
  });
  const grid = [1, 0].flatMap((k) => marks(floor).map((i) => across(k, i * floor.step)));
  const below = lens.eye(middle)[2] < 0;
  const x = numbersOn(floor, lens, size, "x", fade, below);
  const y = giveWay(numbersOn(floor, lens, size, "y", fade, below), x.map(boxOf));
  return { below, grid, rulers: [across(0, 0), across(1, 0)], fade,
           rim: RIM_CIRCLE.map(([c, s]) => onPicture(lens, [reach * c, reach * s, height])),
           numbers: [...x, ...y.filter(({ opacity }) => opacity > 0)] };
}

/**
 * Numbers of the lines on either side of the middle.
 * @param {Floor} floor
 */
function marks({ reach, step }) {
  const count = Math.min(MOST_LINES, Math.floor(reach / step + 1e-9));
  const up = Array.from({ length: count }, (_, k) => k + 1);
  return [...up.map((k) => -k).reverse(), ...up];
}

/** @type {(floor: Floor, lens: Lens) => Fade} */
function fadeOf({ height, reach }, lens) {
  const [right, down, large] = lens.see([0, 0, height]);
  return { center: [right, down], radius: reach * lens.scale * large,
           squeeze: Math.max(FLATTEST, Math.abs(lens.turn([0, 0, 1])[2])) };
}

/**
 * How strongly the floor is drawn at a point of the picture, from 0 to 1.
 * @param {Fade} fade
 * @param {Px} point
 */
export function strength({ center, radius, squeeze }, [x, y]) {
  const far = Math.hypot(x - center[0], (y - center[1]) / squeeze) / radius;
  const k = FADE.findIndex(([share]) => far < share);
  if (k < 1) return k < 0 ? 0 : FADE[0][1];
  const [[from, strong], [to, weak]] = [FADE[k - 1], FADE[k]];
  return strong + (weak - strong) * (far - from) / (to - from);
}

/** @type {(words: Words) => Box} */
export const boxOf = ({ place: [x, y], w, h }) => [x, y, w, h];

/**
 * Numbers of which those that a box covers are not to be seen.
 * @param {RulerNumber[]} numbers
 * @param {Box[]} boxes
 */
export function giveWay(numbers, boxes) {
  return numbers.map((one) => boxes.some(([x, y, w, h]) =>
    2 * Math.abs(x - one.place[0]) < w + one.w && 2 * Math.abs(y - one.place[1]) < h + one.h)
    ? { ...one, opacity: 0 } : one);
}

/**
 * Numbers beside a ruler on the viewer's side of it: as many as have room, paler farther out.
 * @param {Floor} floor
 * @param {Lens} lens
 * @param {number[]} size
 * @param {"x" | "y"} axis
 * @param {Fade} fade
 * @param {boolean} below
 * @returns {RulerNumber[]}
 */
function numbersOn(floor, lens, size, axis, fade, below) {
  const { step, height } = floor, all = marks(floor);
  const at = (/** @type {number} */ i) =>
    onPicture(lens, axis === "x" ? [i * step, 0, height] : [0, i * step, height]);
  const [from, to] = [at(0), at(1)], gap = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (gap < SHORTEST || !all.length) return [];
  const way = to.map((e, k) => (e - from[k]) / gap), side = viewersSide(way, below);
  const every = spacing(floor, way, gap, all[0]), digits = decimalsOf(step);
  return all.filter((i) => i % every === 0).flatMap((i) => {
    const point = at(i), opacity = strength(fade, point);
    const words = besideRuler(marked(i * step, digits), point, side);
    const shown = opacity >= PALEST && fits(words, size);
    return shown ? [{ ...words, axis, opacity }] : [];
  });
}

/** @type {(text: string, point: Px, side: number[]) => Words} */
function besideRuler(text, point, [x, y]) {
  const [w, h] = textSize(text), far = extent({ w, h }, x, y) + NUMBER_GAP;
  return { text, place: [point[0] + far * x, point[1] + far * y], w, h };
}

/**
 * The direction to the viewer's side of a ruler: down, or up if he looks from below; to the left
 * of one that goes straight up.
 * @type {(way: number[], below: boolean) => number[]}
 */
function viewersSide([x, y], below) {
  const down = below ? -x : x, turned = Math.abs(x) > 1e-6 ? down < 0 : y < 0;
  return turned ? [y, -x] : [-y, x];
}

/**
 * Every which line has a number.
 * @type {(floor: Floor, way: number[], gap: number, last: number) => number}
 */
function spacing({ step }, [x, y], gap, last) {
  return EVERY.find((every) => {
    const [w, h] = textSize(number(last * step, decimalsOf(every * step)));
    return every * gap * Math.abs(x) >= w + BETWEEN || every * gap * Math.abs(y) >= h + 2;
  }) ?? Infinity;
}

/** @type {(words: Words, size: number[]) => boolean} */
const fits = ({ place, w, h }, size) => [w, h].every((length, k) =>
  place[k] - length / 2 >= INSIDE && place[k] + length / 2 <= size[k] - INSIDE);

/**
 * Decimals of a ruler's step.
 * @param {number} step
 */
function decimalsOf(step) {
  let digits = 0;
  while (digits < 9 && Math.abs(Number(step.toFixed(digits)) - step) > 1e-9 * step) digits++;
  return digits;
}

/** @type {(value: number, digits: number) => string} */
const marked = (value, digits) =>
  digits ? number(value, digits).replace(/\.?0+$/, "") : number(value, 0);

/**
 * The outline of every solid's shadow, straight under it.
 * @param {Floor} floor
 * @param {Lens} lens
 * @param {Solid[]} solids
 */
export function shadow({ height }, lens, solids) {
  return solids.map((solid) =>
    hull(casting(solid).map(([x, y]) => onPicture(lens, [x, y, height]))));
}

/**
 * Points whose shadows' outline is that of the solid.
 * @param {Solid} solid
 */
function casting({ shape, ends, size }) {
  if (shape === "ball") return disc(ends[0], size[0], [0, 0, 1]);
  const [a, b, ...sides] = ends;
  if (shape === "tube") return [a, b].flatMap((end, k) => disc(end, size[k], minus(b, a)));
  const [u, v] = sides.map((side) => minus(side, a));
  return [a, b].flatMap((end) =>
    SQUARE.map(([i, j]) => plus(end, plus(times(u, i), times(v, j)))));
}

/**
 * A disc at right angles to a direction; only x and y count.
 * @type {(middle: Triple, radius: number, direction: Triple) => Triple[]}
 */
function disc([x, y], radius, [a, b, c]) {
  const flat = Math.hypot(a, b), length = Math.hypot(flat, c);
  const [u, v] = flat > 1e-9 * length ? [a / flat, b / flat] : [1, 0];
  const thin = length ? c / length : 1;
  return DISC.map(([p, q]) =>
    [x + radius * (p * thin * u - q * v), y + radius * (p * thin * v + q * u), 0]);
}

/**
 * The line dropped on the floor from a point of the room.
 * @param {Floor} floor
 * @param {Lens} lens
 * @param {number[]} size
 * @param {Triple} point
 * @returns {Drop}
 */
export function drop(floor, lens, size, point) {
  const [x, y, z] = point, { height, decimals } = floor, below = [x, y, height];
  const [from, foot, origin] = [point, below, [0, 0, height]].map((p) => onPicture(lens, p));
  const guides = [[x, 0, height], [0, y, height]].map((end) => [foot, onPicture(lens, end)]);
  const ring = SMALL_RING.map(([c, s]) =>
    onPicture(lens, plus(below, times([c, s, 0], RING / lens.scale))));
  const [p, q, r] = [x, y, z].map((value) => number(value, decimals));
  const texts = [footWords(`(${p}, ${q})`, from, foot, origin, size),
                 heightWords(`z ${r}`, from, foot, origin, size)];
  return { ends: [point, below], line: [from, foot], foot: ring, guides,
           texts: texts.filter((words) => words != null) };
}

/**
 * Below the foot, above it if the line comes from below; near the arm's base away from it.
 * @type {(text: string, from: Px, foot: Px, origin: Px, size: number[]) => Words | null}
 */
function footWords(text, from, foot, origin, size) {
  if (foot.some((e, k) => e < 0 || e > size[k])) return null;
  const [dx, dy] = [foot[0] - origin[0], foot[1] - origin[1]];
  const away = clip(dx / 30, -1, 1) * clip((NEAR_MIDDLE - Math.hypot(dx, dy)) / 60, 0, 1);
  const down = 1 - 2 * clip((from[1] - foot[1] - 5) / 20, 0, 1);
  return words(text, [foot[0] + FOOT_ASIDE * away, foot[1] + FOOT_DOWN * down], size);
}

/**
 * Beside the middle of a line that is long enough, on the side away from the arm's base.
 * @type {(text: string, from: Px, foot: Px, origin: Px, size: number[]) => Words | null}
 */
function heightWords(text, from, foot, origin, size) {
  if (Math.hypot(from[0] - foot[0], from[1] - foot[1]) <= LONG) return null;
  const [w] = textSize(text), x = (from[0] + foot[0]) / 2;
  const y = (clip(from[1], 0, size[1]) + clip(foot[1], 0, size[1])) / 2;
  const side = clip((from[0] - origin[0] + 12) / 12, -1, 1);
  return words(text, [x + side * (w / 2 + HIGH_ASIDE), y], size);
}

/** @type {(text: string, place: Px, size: number[]) => Words} */
function words(text, place, size) {
  const [w, h] = textSize(text);
  return { text, place: [w, h].map((length, k) => keep(place[k], length, size[k])), w, h };
}

/**
 * The texts of all drops; what stands on itself, as a target's on the tool's, is said once.
 * @param {Pick<Drop, "texts">[]} drops
 */
export const saidOnce = (drops) => drops.flatMap(({ texts }) => texts).filter((one, k, all) =>
  all.findIndex(({ text, place: [x, y], h }) =>
    text === one.text && Math.hypot(x - one.place[0], y - one.place[1]) < h) === k);
