// A button that opens a panel of further controls. Escape closes it; arrow keys walk through it.

import { button, claim, hear, make } from "./dom.js";
import { rove } from "./roving.js";

let panels = 0;                                     // so far: each has an id of its own

/**
 * A button and its panel, as two elements that follow each other.
 *
 * A panel that lies over the page closes when the hand goes elsewhere; one that stands in the page
 * (`stays`) does not, for all below it would jump.
 * @param {string} text
 * @param {string} title
 * @param {HTMLElement} panel
 * @param {Record<string, unknown>} attributes
 * @param {boolean} stays
 */
export function menu(text, title, panel, attributes = {}, stays = false) {
  panel.id ||= `kl-panel-${++panels}`;
  const opener = button(text, title, () => open(Boolean(panel.hidden)),
    { "aria-expanded": "false", "aria-controls": panel.id, ...attributes });
  const inside = (/** @type {Event} */ { target }) =>
    target instanceof Node && (panel.contains(target) || opener.contains(target));
  const elsewhere = (/** @type {Event} */ event) => {
    if (!inside(event) || !panel.isConnected) open(false);
  };
  let ignore = () => {};
  const open = (/** @type {boolean} */ on) => {
    panel.hidden = !on;
    opener.setAttribute("aria-expanded", String(on));
    ignore();
    if (on && !stays) ignore = hear(document, { pointerdown: elsewhere, focusin: elsewhere }, true);
  };
  const leave = (/** @type {KeyboardEvent} */ event) => {
    if (event.key !== "Escape" || panel.hidden) return;
    open(false);
    opener.focus();
    claim(event);
  };
  const enter = (/** @type {KeyboardEvent} */ event) => {
    const end = { ArrowDown: 0, ArrowUp: -1 }[event.key];
    if (end == null) return;
    open(true);
    /** @type {NodeListOf<HTMLElement>} */
    const controls = panel.querySelectorAll("button, input");
    [...controls].at(end)?.focus();
    claim(event);
  };
  panel.hidden = true;
  for (const node of [opener, panel]) node.addEventListener("keydown", leave);
  if (!stays) {                                     // the other one's controls are its toolbar's
    opener.addEventListener("keydown", enter);
    rove(panel);
  }
  return [opener, panel];
}

/**
 * A list to choose from that does something with each choice and then asks again.
 * @param {string} prompt
 * @param {string} title
 * @param {{ label: string, options: string[] }[]} groups
 * @param {(choice: string) => void} choose
 */
export function picker(prompt, title, groups, choose) {
  const list = make("select", { class: "kl-button", title, "aria-label": title },
    make("option", { value: "" }, prompt),
    ...groups.map(({ label, options }) => make("optgroup", { label },
      ...options.map((text) => make("option", {}, text)))));
  list.addEventListener("change", () => list.value && choose(list.value));
  list.addEventListener("blur", () => { list.value = ""; });
  list.addEventListener("keydown", (event) => {
    if (event.key !== "Tab") event.stopPropagation();
  });
  return list;
}
