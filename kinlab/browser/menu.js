// A button that opens a panel of further controls. Escape closes it; arrow keys walk through it.

import { button, claim, hear, make } from "./dom.js";

const ONWARD = ["ArrowDown", "ArrowRight"], BACKWARD = ["ArrowUp", "ArrowLeft"];
let panels = 0;                                     // so far: each has an id of its own

/**
 * Move the focus to the next or the last control of a panel, round its ends.
 * @param {HTMLElement} panel
 * @param {1 | -1} by
 */
function focusNext(panel, by) {
  /** @type {NodeListOf<HTMLElement>} */
  const found = panel.querySelectorAll("button, input, select");
  const controls = [...found].filter((node) => node.offsetParent && !node.matches(":disabled"));
  const at = controls.indexOf(/** @type {HTMLElement} */ (document.activeElement));
  const next = at < 0 && by < 0 ? controls.length - 1 : at + by;
  controls.at(next % (controls.length || 1))?.focus();
}

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
  const key = (/** @type {KeyboardEvent} */ event) => {
    const by = ONWARD.includes(event.key) ? 1 : BACKWARD.includes(event.key) ? -1 : 0;
    if (event.key === "Escape" && !panel.hidden) {
      open(false);
      opener.focus();
    } else if (by && !panel.hidden && !(event.target instanceof HTMLSelectElement)) {
      focusNext(panel, by);
    } else return;
    claim(event);
  };
  panel.hidden = true;
  for (const node of [opener, panel]) node.addEventListener("keydown", key);
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
