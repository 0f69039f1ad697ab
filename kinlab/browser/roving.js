// One stop of the Tab key for controls that stand together; arrow keys lead from one to the next,
// Home and End to the ends.

import { claim } from "./dom.js";

const CONTROLS = "button, select, input";
/** @type {Record<string, -1 | 1>} */
const ACROSS = { ArrowLeft: -1, ArrowRight: 1 };
/** @type {Record<string, -1 | 1>} */
const UPWARDS = { ArrowUp: -1, ArrowDown: 1 };

/** @type {(node: HTMLElement) => boolean} */
const canFocus = (node) => node.getClientRects().length > 0 && !node.matches(":disabled");

/** @type {(all: HTMLElement[], at: number, by: number) => HTMLElement} */
const round = (all, at, by) => all[(at + by + all.length) % all.length];

/**
 * The control of the next row of a table, or the last, that is nearest below or above.
 * @type {(all: HTMLElement[], from: HTMLElement, by: number) => HTMLElement}
 */
function upright(all, from, by) {
  const rowOf = (/** @type {Element} */ node) => node.closest("tr");
  const rows = [...new Set(all.map(rowOf))], left = from.getBoundingClientRect().x;
  const row = rows[(rows.indexOf(rowOf(from)) + by + rows.length) % rows.length];
  const aside = (/** @type {Element} */ node) => Math.abs(node.getBoundingClientRect().x - left);
  return all.filter((node) => rowOf(node) === row)
    .reduce((a, b) => aside(b) < aside(a) ? b : a);
}

/**
 * Where a key leads from one of some controls; nowhere with a key that is not for that.
 * @param {HTMLElement[]} all
 * @param {HTMLElement} from
 * @param {string} key
 */
function led(all, from, key) {
  const own = from.matches("select, [aria-expanded]");   // up and down open it, or change it
  const up = own ? 0 : UPWARDS[key] ?? 0, by = ACROSS[key] ?? up;
  if (up && from.closest("tr")) return upright(all, from, up);
  if (by) return round(all, all.indexOf(from), by);
  return key === "Home" ? all[0] : key === "End" ? all[all.length - 1] : null;
}

/**
 * Make the controls of an element one stop of the Tab key.
 *
 * The stop is the control that had the focus last. Controls may come and go, be hidden and be
 * disabled. Of what lies over the page (a menu) the controls are not counted: it has a stop of
 * its own.
 * @param {HTMLElement} root
 * @param {string} selector of the controls
 */
export function rove(root, selector = CONTROLS) {
  /** @type {HTMLElement | undefined} */
  let stop;
  const found = () => /** @type {HTMLElement[]} */ ([...root.querySelectorAll(selector)])
    .filter((node) => (node.parentElement?.closest(".kl-panel-over") ?? root).contains(root));
  const settle = () => {
    const all = found(), free = all.filter(canFocus);
    if (!stop || !free.includes(stop)) stop = free[0] ?? all[0];
    for (const node of all) {
      if (node.tabIndex !== (node === stop ? 0 : -1)) node.tabIndex = node === stop ? 0 : -1;
    }
  };
  root.addEventListener("focusin", ({ target }) => {
    if (!(target instanceof HTMLElement) || !found().includes(target)) return;
    stop = target;
    settle();
  });
  root.addEventListener("keydown", (event) => {
    const { target, key, ctrlKey, metaKey, altKey } = event, all = found().filter(canFocus);
    if (!(target instanceof HTMLElement) || !all.includes(target)) return;
    const next = ctrlKey || metaKey || altKey ? null : led(all, target, key);
    if (!next) return;
    next.focus();
    claim(event);
  }, true);                                         // a list keeps its keys to itself
  new MutationObserver(settle).observe(root,
    { subtree: true, childList: true, attributes: true, attributeFilter: ["disabled", "hidden"] });
  new ResizeObserver(settle).observe(root);         // where there is little room some are hidden
  settle();
}
