// What stands under the picture and follows it: the tool's pose, formulas, a target's error.
// @ts-nocheck

import { make, number } from "./dom.js";
import { ROTATE, dot, inRoom, travel } from "./frames.js";

/** The matrix of the tip's frame: axes and origin as columns, or only `rows` axes as columns. */
export function poseTable(pose) {
  const rows = pose.rows ?? pose.columns.length - 1;   // 3 in space, 2 in the plane
  const whole = pose.columns.length > rows;            // with an origin and a last row
  const sources = [...Array(rows).keys(), 3];       // the frame's axes, then its origin
  const style = (k) => ({ class: k < rows ? `kl-column-${"xyz"[k]}` : "kl-column-o" });
  const head = make("tr", {}, ...pose.columns.map(({ name, title }, k) =>
    make("th", { ...style(k), scope: "col", title },
         k === rows && pose.unit ? `${name} (${pose.unit})` : name)));
  const cells = pose.columns.map(() => pose.columns.map((_, k) => make("td", style(k))));
  const table = make("table", { class: "kl-pose" }, make("caption", {}, pose.title),
    make("thead", {}, head),
    make("tbody", {}, ...cells.map((row) => make("tr", {}, ...row))));
  cells[rows]?.forEach((cell, k) => { cell.textContent = k < rows ? "0" : "1"; });
  const update = (frame) => {
    cells.slice(0, rows).forEach((row, i) => row.forEach((cell, k) => {
      cell.textContent = number(frame[sources[k]][i], k < rows ? 3 : pose.decimals);
    }));
  };
  const text = () => cells.slice(0, rows).map((row) => row[rows].textContent).join(", ");
  const said = () => whole ? `${pose.said ?? "origin"} at ${text()} ${pose.unit}` : "";
  return { node: table, update, text: said };
}

/** Formulas under the picture, whose vectors and amounts follow the knobs. */
export function readingLines({ readings, decimals, motions }) {
  const box = make("div", { class: "kl-readings" }), spans = [];
  for (const { text, vectors } of readings) {
    const [first, ...rest] = text.split("{}"), line = make("div", {}, first);
    rest.forEach((words, k) => {
      spans.push([make("span", { class: "kl-number" }), vectors[k]]);
      line.append(spans.at(-1)[0], words);
    });
    box.append(line);
  }
  const vector = ({ tail, head, frame, size, scale }, all) => {
    const [from, to] = [tail, head].map(([k, ...local]) => inRoom(all[k], local));
    const arrow = to.map((e, k) => e - from[k]);
    const parts = all[frame].slice(0, size)
      .map((axis) => number(scale * dot(axis, arrow), decimals));
    return size > 1 ? `(${parts.join(", ")})` : parts[0];
  };
  const amount = (motion, q) => motion[0] === ROTATE
    ? number(travel(motion, q) * 180 / Math.PI, 1) : number(travel(motion, q), decimals);
  const volume = ({ ellipsoid, size, scale }, all) =>
    number(all[ellipsoid].slice(0, size).reduce((v, side, k) => v * side[k], scale), decimals);
  const entry = ({ knob, texts }, q) =>
    texts[Math.max(0, Math.min(texts.length - 1, Math.round(q[knob])))];
  const update = (all, q) => {
    for (const [span, part] of spans) {
      span.textContent = part.step ? amount(motions[part.step - 1], q)
        : part.texts ? entry(part, q) : part.ellipsoid ? volume(part, all) : vector(part, all);
    }
  };
  return { node: box, update, text: () => [...box.children].map((l) => l.textContent).join("; ") };
}

/** What the error of a chased target is, and what the last solve took. */
export function missed(scene, all, solved) {
  const { frame, tip, unit } = scene.target, gap = all[frame][3].map((v, k) => v - all[tip][3][k]);
  const error = Math.hypot(...gap), far = error > 1e-4 * scene.radius;
  const taken = solved ? ` after ${solved.steps} iteration${solved.steps === 1 ? "" : "s"}` : "";
  return `error |p* − p| = ${number(error, scene.decimals)} ${unit}${taken}` +
    (far && solved ? ": the arm gets no nearer from here" : "");
}
