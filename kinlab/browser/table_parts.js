// The pieces of the DH table's editor: cells, lists and buttons.

import { button, make } from "./dom.js";

/** @import { Action } from "./dom.js" */
/** @import { Field } from "./types.js" */

const LONGEST = 200;                                // characters in a cell

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
  input.value = input.committed = text;
  const commit = () => {
    if (input.value === input.committed) return;
    input.committed = input.value;
    send(input.value);
  };
  input.addEventListener("change", commit);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") commit();
    if (event.key === "Escape") input.value = input.committed ?? text;
  });
  return input;
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
