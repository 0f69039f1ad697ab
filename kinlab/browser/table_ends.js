// The base and the tool of a DH table, to type in.

import { make } from "./dom.js";
import { choose, press, typed } from "./table_parts.js";

/** @import { Editor } from "./table.js" */
/** @import { End } from "./types.js" */

const BOTH_ENDS = ["base", "tool"];
const FORMS = [["pose", "x, y, z and three turns"], ["row", "one DH row"]];
/** @type {Record<string, string>} */
export const LETTERS = { theta: "θ", alpha: "α" };
/** @type {Record<string, string>} */
const MEANINGS = { x: "shift along x", y: "shift along y", z: "shift along z",
                   roll: "turn about x", pitch: "turn about y", yaw: "turn about z" };

/**
 * Buttons for the ends that are not there.
 * @param {Editor} editor
 */
export const newEnds = (editor) => BOTH_ENDS.filter((end) => !editor.state.ends[end]).map((end) =>
  press(`+ ${end === "base" ? "Base" : "Tool"}`, `Type the ${end} frame`, () => {
    editor.next = `${end} x`;
    editor.send("with_end", end);
  }));

/**
 * The ends that are there, each a line of cells.
 * @param {Editor} editor
 */
export const ends = (editor) => BOTH_ENDS.filter((end) => editor.state.ends[end]).map((end) =>
  typedEnd(editor, end, /** @type {End} */ (editor.state.ends[end])));

/**
 * @param {Editor} editor
 * @param {string} end
 * @param {End} told
 */
function typedEnd(editor, end, { form, cells }) {
  const reason = `kl-reason-${editor.id}-${end}`, title = end === "base" ? "Base" : "Tool";
  const fields = Object.entries(cells).map(([column, { text, unit }]) => {
    const name = `${LETTERS[column] ?? column} of the ${end}`;
    const means = MEANINGS[column] ? `, ${MEANINGS[column]}` : "";
    const input = typed(`${end} ${column}`, `${name}${means}, ${unit}`, text,
                        (typing) => editor.send("with_cell", end, column, typing));
    input.dataset.reason = reason;
    return make("label", { class: "kl-length" }, make("i", {}, LETTERS[column] ?? column), " ",
                input, make("span", { class: "kl-reads" }), ` ${unit}`);
  });
  const how = choose(`How the ${end} is typed`, FORMS, form, (value, list) => {
    list.value = form;                              // until Python has agreed
    editor.send("with_end", end, value);
  });
  const turns = form === "pose" ? [make("span", { class: "kl-muted" },
    "turned about the fixed axes: roll about x, then pitch about y, then yaw about z")] : [];
  return make("div", { class: "kl-end", role: "group", "aria-label": title },
    make("b", {}, title), how, ...fields,
    press("✕", `Leave out the ${end} frame`, () => editor.send("without_end", end)), ...turns,
    editor.reason("div", Object.keys(cells).map((column) => `${end} ${column}`),
                  make("div", { id: reason, role: "alert" })));
}
