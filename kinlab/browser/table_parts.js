// The pieces of the DH table's editor: cells, lists and buttons.

import { button, make } from "./dom.js";

const LONGEST = 200;                                // characters in a cell

/** A number in the digits of an index. */
export const lowered = (number) => String(number).replace(/\d/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[digit]);

/** A list to choose from; `take` hears the choice. */
export function choose(label, options, value, take) {
  const list = make("select", { "aria-label": label, "data-at": label },
    ...options.map(([key, text]) => make("option", { value: key }, text)));
  list.value = value;
  list.addEventListener("change", () => take(list.value, list));
  return list;
}

/** A button that is found again after the table is built anew. */
export function press(text, title, action, extra = {}) {
  return button(text, title, action,
    { "data-at": title, "aria-label": text.length > 1 ? null : title, ...extra });
}

/** A cell of text that is sent when it is left or Enter is pressed; Escape takes it back. */
export function typed(at, label, text, send) {
  const input = make("input", { type: "text", "data-at": at, "aria-label": label, spellcheck: "false",
                                autocomplete: "off", maxlength: LONGEST, class: "kl-cell" });
  input.value = input.committed = text;
  const commit = () => {
    if (input.value === input.committed) return;
    input.committed = input.value;
    send(input.value);
  };
  input.addEventListener("change", commit);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") commit();
    if (event.key === "Escape") input.value = input.committed;
  });
  return input;
}
