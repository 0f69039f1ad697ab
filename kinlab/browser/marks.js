// What a joint that is pointed at has done, drawn on the picture: the angle by which it has turned
// as an arc, the length by which it has slid as a dimension line, each with its name and value.

import { valued } from "./dom.js";
import { ROTATE, branch, travel } from "./frames.js";
import { textSize } from "./labels.js";
import { drawn, polygon, polyline, px } from "./svg.js";
import { minus, plus, times } from "./vectors.js";

/** @import { Elementary, Frame, Lens, Pointed, Scene, Triple } from "./types.js" */
/** @typedef {{ at: Frame[], lens?: Pick<Lens, "see" | "scale"> | null, svg: SVGElement }} Shown */
/**
 * @typedef {object} Figure
 * @property {number[][][]} thin dashed lines that lead to it
 * @property {number[][]} way the arc or the line
 * @property {number[][][]} heads where it ends
 * @property {number[]} name where its name stands
 */

const ARC = 60, FARTHER = 18;                    // px: of the arc of one joint; of a next one
const SIDEWAYS = 20, OUTWARDS = 15, POINT = 8;           // px
const ARC_PIECE = 0.1;                                  // rad

/**
 * An arrow head that ends at b and comes from a.
 * @param {number[]} a
 * @param {number[]} b
 */
function arrowHead(a, b) {
  const [x, y] = [b[0] - a[0], b[1] - a[1]], length = Math.hypot(x, y) || 1;
  const [u, v] = [POINT * x / length, POINT * y / length];
  return [b, [b[0] - u - 0.4 * v, b[1] - v + 0.4 * u], [b[0] - u + 0.4 * v, b[1] - v - 0.4 * u]];
}

/**
 * The arc from an axis of the frame before a turn to the same axis after it.
 * @param {Frame} before
 * @param {number} axis that it turns about
 * @param {number} angle
 * @param {number} radius
 * @param {(point: Triple) => number[]} see
 * @returns {Figure}
 */
export function arcFigure(before, axis, angle, radius, see) {
  const [u, v, o] = [before[(axis + 1) % 3], before[(axis + 2) % 3], before[3]];
  const at = (/** @type {number} */ turn, far = 1) => see(plus(o,
    plus(times(u, far * radius * Math.cos(turn)), times(v, far * radius * Math.sin(turn)))));
  const count = Math.max(1, Math.ceil(Math.abs(angle) / ARC_PIECE));
  const way = Array.from({ length: count + 1 }, (_, k) => at(angle * k / count));
  const long = Math.hypot(...minus(way[count], way[count - 1]).slice(0, 2)) > 0.5;
  return { thin: [0, angle].map((turn) => [see(o), at(turn, 1.15)]), way,
           heads: long ? [arrowHead(way[count - 1], way[count])] : [], name: at(angle / 2, 1.3) };
}

/**
 * The line beside a slide, from where it begins to where it ends.
 * @param {Triple} from
 * @param {Triple} to
 * @param {(point: Triple) => number[]} see
 * @returns {Figure}
 */
export function slideFigure(from, to, see) {
  const [a, b] = [see(from), see(to)], [x, y] = [b[0] - a[0], b[1] - a[1]];
  const length = Math.hypot(x, y), [u, v] = length > 1e-9 ? [x / length, y / length] : [0, 1];
  const aside = (/** @type {number[]} */ p, /** @type {number} */ far) =>
    [p[0] + far * v, p[1] - far * u];
  const way = [a, b].map((p) => aside(p, SIDEWAYS));
  const heads = length > 2 * POINT ? [arrowHead(way[1], way[0]), arrowHead(way[0], way[1])] : [];
  return { thin: [a, b].map((p) => [p, aside(p, SIDEWAYS + 4)]), way, heads,
           name: aside([a[0] + x / 2, a[1] + y / 2], SIDEWAYS + OUTWARDS) };
}

/**
 * The frame that a joint's motion leads to, the first on the way to the tip; null for a joint whose
 * angle the picture shows already, and for a knob that only scrubs.
 * @param {Scene} scene
 * @param {number} joint
 */
function stepOf({ motions, tip, items }, joint) {
  if (items.some((item) => item.part === "arc" && item.joint === joint + 1)) return null;
  return [...branch(motions, tip).reverse(), ...motions.map((_, k) => k + 1)].find((k) => {
    const motion = /** @type {Elementary} */ (motions[k - 1]);
    return motion.joint === joint && !motion.track && !motion.scrub && motion.start == null;
  }) ?? null;
}

/** The marks of all joints that are pointed at. */
export class Marks {
  group = drawn("g", { class: "kl-marks" });

  /** @param {Scene} scene */
  constructor(scene) {
    this.scene = scene;
    this.steps = scene.knobs.map((_, joint) => stepOf(scene, joint));
  }

  /**
   * @param {Pointed | null} pointed
   * @param {number[]} q
   * @param {Shown} picture
   */
  draw(pointed, q, { at, lens, svg }) {
    /** @type {SVGElement[]} */
    const marks = [];
    /** @type {Triple[]} */
    const taken = [];
    for (const joint of [...pointed?.joints ?? []].sort((a, b) => a - b)) {
      const step = this.steps[joint - 1];
      if (step != null && lens) marks.push(this.mark(joint, step, q, at, lens, taken));
    }
    if (marks.length || this.group.hasChildNodes()) this.group.replaceChildren(...marks);
    if (marks.length && svg.lastChild !== this.group) svg.append(this.group);
  }

  /**
   * @param {number} joint
   * @param {number} step the frame that its motion leads to
   * @param {number[]} q
   * @param {Frame[]} at
   * @param {Pick<Lens, "see" | "scale">} lens
   * @param {Triple[]} taken origins of arcs that are there already
   */
  mark(joint, step, q, at, { see, scale }, taken) {
    const motion = /** @type {Elementary} */ (this.scene.motions[step - 1]);
    const before = at[motion.parent ?? step - 1], value = travel(motion, q);
    const turns = motion.kind === ROTATE;
    const near = taken.filter((o) => Math.hypot(...minus(o, before[3])) * scale < ARC).length;
    if (turns) taken.push(before[3]);
    const figure = turns
      ? arcFigure(before, motion.axis, value, (ARC + FARTHER * near) / scale, see)
      : slideFigure(before[3], at[step][3], see);
    const text = valued(this.scene.knobs[joint - 1], value);
    if (turns) figure.name = keptClear(figure.name, see(before[3]), text);
    return markOf(figure, turns, joint, text);
  }
}


/**
 * The middle of a name that begins or ends at a place, away from another.
 * @param {number[]} place
 * @param {number[]} from
 * @param {string} text
 */
function keptClear([x, y], [u, v], text) {
  const level = (x - u) / (Math.hypot(x - u, y - v) || 1);
  return [x + textSize(text)[0] / 2 * level, y];
}

/** @type {(figure: Figure, turns: boolean, joint: number, text: string) => SVGElement} */
function markOf({ thin, way, heads, name: [x, y] }, turns, joint, text) {
  const path = (/** @type {string} */ kind, /** @type {string} */ d) =>
    drawn("path", { class: `kl-mark-${kind}`, d });
  return drawn("g", { class: turns ? "kl-angle" : "kl-length", "data-joint": joint,
                      "data-part": turns ? "arc" : "dimension" },
    path("rim", polyline(way)), path("thin", thin.map(polyline).join("")),
    path("way", polyline(way)),
    path("head", heads.map(polygon).join("")),
    drawn("text", { x: px(x), y: px(y) }, text));
}
