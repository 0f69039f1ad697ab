// The pieces of the DH table's editor: cells, lists and buttons.

import { button, make } from "./dom.js";

/** @import { Action } from "./dom.js" */
/** @import { Field } from "./types.js" */

const LONGEST = 200;                                // characters in a cell
const CELL_ROOM = 9;                                // of them are seen at once
const EXPONENT = /^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)e[-+]?[0-9]{1,2}$/i;   // it has an exponent

/**
 * A list to choose from; `take` hears the choice.
 * @param {string} label
 * @param {string[][]} options the value and the words of each
 * @param {string} value
 * @param {(value: string, list: HTMLSelectElement) => void} take
 */
export function choose(label, options, value, take) {
  const list = make("select", { "aria-label": label, "data-at": label },
    ...options.map(([key, text]) => make("option", { value: key }, text)));
  list.value = value;
  list.addEventListener("change", () => take(list.value, list));
  return list;
}

/**
 * A button that is found again after the table is built anew.
 * @param {string} text
 * @param {string} title
 * @param {Action} action
 * @param {Record<string, unknown>} extra
 */
export function press(text, title, action, extra = {}) {
  return button(text, title, action,
    { "data-at": title, "aria-label": text.length > 1 ? null : title, ...extra });
}

/**
 * What a cell shows while nobody types in it: of a long number with an exponent so few digits that
 * the exponent is seen, too.
 * @param {string} text
 */
export const briefly = (text) => (EXPONENT.test(text) && text.length > CELL_ROOM
  ? Number(text).toExponential(2) : text);

/**
 * Whether a cell holds what was committed last.
 * @param {Field} input
 */
export const untouched = (input) => input.value === cellText(input);

/**
 * Commit a text that comes from elsewhere, and show it if nobody has typed something else.
 * @param {Field} input
 * @param {string} text
 * @param {boolean} keep what was typed
 */
export function commitTo(input, text, keep) {
  input.committed = text;
  if (!keep) input.value = cellText(input);
}

/** @type {(input: Field) => string} */
const cellText = ({ committed = "", resting }) => (resting ? briefly(committed) : committed);

/**
 * A cell of text that is sent when it is left or Enter is pressed; Escape takes it back.
 * @param {string} at
 * @param {string} label
 * @param {string} text
 * @param {(text: string) => void} send
 */
export function typed(at, label, text, send) {
  /** @type {HTMLInputElement & Field} */
  const input = make("input", { type: "text", "data-at": at, "aria-label": label, class: "kl-cell",
                                spellcheck: "false", autocomplete: "off", maxlength: LONGEST });
  input.resting = true;
  commitTo(input, text, false);
  const commit = () => {
    if (untouched(input)) return;
    input.committed = input.value;
    send(input.value);
  };
  input.addEventListener("change", commit);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") commit();
    if (event.key === "Escape") input.value = input.committed ?? text;
  });
  input.addEventListener("focus", () => restCell(input, false));
  input.addEventListener("blur", () => restCell(input, true));
  return input;
}

/**
 * A cell that is left, or taken in hand: then all digits are there, and selected, as what was
 * selected in the shorter text is gone.
 * @param {HTMLInputElement & Field} input
 * @param {boolean} resting
 */
function restCell(input, resting) {
  const same = untouched(input);
  input.resting = resting;
  const text = cellText(input);
  if (!same || input.value === text) return;        // the caret stays where it is
  input.value = text;
  if (!resting) input.select();
}

/**
 * A question with a button for each answer, and Cancel; Escape cancels, too. It is found again by
 * `data-at`: "answer 0" is its first answer.
 * @param {string} label
 * @param {string} words what is asked; may be empty where the answers say it
 * @param {[string, () => void, Record<string, unknown>?][]} answers
 * @param {() => void} cancel
 */
export function ask(label, words, answers, cancel) {
  const buttons = answers.map(([text, act, extra], k) =>
    press(text, text, act, { "data-at": `answer ${k}`, ...extra }));
  const asked = make("div", { class: "kl-ask", role: "group", "aria-label": label },
    ...(words ? [make("span", {}, words)] : []), ...buttons, press("Cancel", "Cancel", cancel));
  asked.addEventListener("keydown", (event) => { if (event.key === "Escape") cancel(); });
  return asked;
}
