// What stands under the picture and follows it: the tool's pose, formulas, a target's error.

import { make, number, rewrite } from "./dom.js";
import { ROTATE, roomPoint, travel } from "./frames.js";
import { clip } from "./steps.js";
import { turnedAs } from "./turned.js";
import { dot, minus, norm } from "./vectors.js";

/** @import { Amount, Distance, Elementary, Entry, Frame, Part, Pose, Scene } from "./types.js" */
/** @import { Solved, TargetScene, Turned, Vector, Volume } from "./types.js" */

/**
 * What explains a column where it stands, if that is one word.
 * @param {string | undefined} title
 */
const shortly = (title) =>
  title && !title.includes(" ") ? [make("span", { class: "kl-short" }, title)] : [];

/**
 * The matrix of the tip's frame: axes and origin as columns, or only `rows` axes as columns.
 * @param {Pose} pose
 */
export function poseTable(pose) {
  const rows = pose.rows ?? pose.columns.length - 1;   // 3 in space, 2 in the plane
  const whole = pose.columns.length > rows;            // with an origin and a last row
  const sources = [...Array(rows).keys(), 3];       // the frame's axes, then its origin
  const style = (/** @type {number} */ k) =>
    ({ class: k < rows ? `kl-column-${"xyz"[k]}` : "kl-column-o" });
  const head = make("tr", {}, ...pose.columns.map(({ name, title }, k) =>
    make("th", { ...style(k), scope: "col", title,
                 "aria-label": title ? `${name}, ${title}` : null },
         k === rows && pose.unit ? `${name} (${pose.unit})` : name, ...shortly(title))));
  const cells = pose.columns.map((_, i) => pose.columns.map((__, k) =>   // named as in formulas
    make("td", { ...style(k), "data-entry": `${i + 1},${k + 1}` })));
  const table = make("table", { class: "kl-pose" }, make("caption", {}, pose.title),
    make("thead", {}, head),
    make("tbody", {}, ...cells.map((row, i) => make("tr", { "data-row": i + 1 }, ...row))));
  cells[rows]?.forEach((cell, k) => {
    cell.textContent = k < rows ? "0" : "1";
    cell.setAttribute("data-holds", "");            // no joint moves the last row
  });
  const entries = cells.slice(0, rows).flat();
  const read = (/** @type {Frame} */ frame) => entries.map((_, at) => {
    const k = at % cells.length, i = Math.floor(at / cells.length);
    return number(frame[sources[k]][i], k < rows ? 3 : pose.decimals);
  });
  const update = (/** @type {Frame} */ frame) => rewrite(entries, read(frame));
  const text = () => cells.slice(0, rows).map((row) => row[rows].textContent).join(", ");
  const said = () => whole ? `${pose.said ?? "origin"} at ${text()} ${pose.unit}` : "";
  return { node: table, entries, read, update, text: said };
}

/**
 * The class of what an amount is, an angle or a length.
 * @param {Part} part
 * @param {Scene["motions"]} motions
 */
function quantityOf(part, motions) {
  if (part.kind === "angle" || part.kind === "rpy") return "kl-of-angle";
  if (part.kind !== "amount") return "";
  return motions[part.step - 1].kind === ROTATE ? "kl-of-angle" : "kl-of-length";
}

/**
 * Formulas under the picture, whose vectors and amounts follow the knobs.
 * @param {Scene} scene
 */
export function readingLines({ readings, decimals, motions }) {
  /** @type {[HTMLElement, Part][]} */
  const spans = [];
  const box = make("div", { class: "kl-readings" });
  for (const { name, words: [first, ...rest], parts } of readings) {
    const line = make("div", { "data-reading": name }, first);
    rest.forEach((after, k) => {
      const span = make("span", { class: `kl-number ${quantityOf(parts[k], motions)}` });
      spans.push([span, parts[k]]);
      line.append(span, after);
    });
    box.append(line);
  }
  /** @type {(part: Vector, all: Frame[]) => string} */
  const vector = ({ tail, head, frame, size, scale }, all) => {
    const arrow = minus(roomPoint(all, head), roomPoint(all, tail));
    const parts = all[frame].slice(0, size)
      .map((axis) => number(scale * dot(axis, arrow), decimals));
    return size > 1 ? `(${parts.join(", ")})` : parts[0];
  };
  /** @type {(part: Distance, all: Frame[]) => string} */
  const distance = ({ tail, head }, all) =>
    number(norm(minus(roomPoint(all, head), roomPoint(all, tail))), decimals);
  /** @type {(part: Amount, all: Frame[], q: number[]) => string} */
  const amount = ({ step }, all, q) => {
    const motion = /** @type {Elementary} */ (motions[step - 1]), way = travel(motion, q);
    return motion.kind === ROTATE ? number(way * 180 / Math.PI, 1) : number(way, decimals);
  };
  /** @type {(part: Volume, all: Frame[]) => string} */
  const volume = ({ ellipsoid, size, scale }, all) =>
    number(all[ellipsoid].slice(0, size).reduce((v, side, k) => v * side[k], scale), decimals);
  /** @type {(part: Entry, all: Frame[], q: number[]) => string} */
  const entry = ({ knob, texts }, all, q) =>
    texts[clip(Math.round(q[knob]), 0, texts.length - 1)];
  /** @type {(part: Turned, all: Frame[], q: number[]) => string} */
  const turn = (part, all, q) => turnedAs(part, { motions, all, q }, decimals);
  /** @type {Record<Part["kind"], (part: any, all: Frame[], q: number[]) => string>} */
  const readers = { vector, distance, amount, volume, entry,
                    quaternion: turn, axis: turn, angle: turn, rpy: turn };
  /** @type {(all: Frame[], q: number[]) => string[]} */
  const read = (all, q) => spans.map(([, part]) => readers[part.kind](part, all, q));
  const entries = spans.map(([span]) => span);
  /** @type {(all: Frame[], q: number[]) => Element[]} */
  const update = (all, q) => rewrite(entries, read(all, q));
  const text = () => [...box.querySelectorAll(":scope > :not(.kl-chart)")]
    .map((line) => line.textContent).join("; ");
  return { node: box, entries, read, update, text };
}

/**
 * What the error of a chased target is, and what the last solve took.
 * @param {TargetScene} scene
 * @param {Frame[]} all
 * @param {Solved | null} solved
 */
export function missed(scene, all, solved) {
  const { frame, tip, unit } = scene.target, error = norm(minus(all[frame][3], all[tip][3]));
  const far = error > 1e-4 * scene.radius;
  const taken = solved ? ` after ${solved.steps} iteration${solved.steps === 1 ? "" : "s"}` : "";
  return `error |p* − p| = ${number(error, scene.decimals)} ${unit}${taken}` +
    (far && solved ? ": the arm gets no nearer from here" : "");
}
