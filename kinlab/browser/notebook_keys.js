// Keys in a view are the view's: a notebook asks each element that has the focus whether it may
// have them, and would go to another cell with an arrow key.

import { hear } from "./dom.js";

const SUPPRESSED = "data-lm-suppress-shortcuts";    // what JupyterLab and Notebook 7 look for
const UNDOES = ["y", "z"];                          // with Ctrl

/**
 * Whether a notebook is to have a key all the same: to save and the like.
 * @param {KeyboardEvent} event
 */
const isNotebooks = ({ key, ctrlKey, metaKey }) =>
  (ctrlKey || metaKey) && !UNDOES.includes(key.toLowerCase());

/**
 * Keep the keys that are pressed in an element from the notebook around it. Asked before the
 * notebook hears of a key, so it holds for whatever has the focus then.
 * @param {HTMLElement} element
 * @returns {() => void} ends it
 */
export const keepKeys = (element) => hear(window, {
  keydown(/** @type {KeyboardEvent} */ event) {
    const { target } = event;
    if (!(target instanceof Element) || !element.contains(target)) return;
    if (isNotebooks(event)) target.removeAttribute(SUPPRESSED);
    else target.setAttribute(SUPPRESSED, "true");
  },
}, true);
