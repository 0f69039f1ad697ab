// Elements of a page, buttons, and numbers as print has them.

/** @import { Knob } from "./types.js" */
/** @typedef {(pressed: HTMLButtonElement) => void} Action */

/**
 * An element with attributes, those that are absent or false left out, and children.
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, unknown>} attributes
 * @param {(Node | string)[]} children
 */
export function make(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value != null && value !== false) node.setAttribute(name, String(value));
  }
  node.append(...children);
  return node;
}

/**
 * A button that calls `action` with itself.
 * @param {string} text
 * @param {string} title
 * @param {Action} action
 * @param {Record<string, unknown>} attributes
 */
export function button(text, title, action, attributes = {}) {
  const node = make("button", { type: "button", class: "kl-button", title, ...attributes }, text);
  node.addEventListener("click", () => action(node));
  return node;
}

/**
 * Buttons that belong together.
 * @param {string} label
 * @param {Node[]} buttons
 */
export const group = (label, ...buttons) =>
  make("span", { class: "kl-group", role: "group", "aria-label": label }, ...buttons);

/**
 * Keep an event to oneself: a page would scroll, and a notebook has uses for the keys, too.
 * @param {Event} event
 */
export function claim(event) {
  event.preventDefault();
  event.stopPropagation();
}

/**
 * Hear of events by their names.
 * @param {EventTarget} target
 * @param {Record<string, (event: any) => void>} heard
 * @param {boolean} early before the parts of the target hear of them
 * @returns {() => void} ends it
 */
export function hear(target, heard, early = false) {
  const all = Object.entries(heard);
  for (const [name, act] of all) target.addEventListener(name, act, early);
  return () => {
    for (const [name, act] of all) target.removeEventListener(name, act, early);
  };
}

/**
 * Set an element's text, if it is another: a page need not be laid out for what it shows.
 * @param {Element} node
 * @param {string} text
 */
export function write(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

/**
 * Set the texts of elements; those that showed another one before.
 * @param {Element[]} nodes
 * @param {string[]} texts
 */
export function rewrite(nodes, texts) {
  return nodes.filter((node, k) => {
    const before = node.textContent;
    write(node, texts[k]);
    return before && before !== texts[k];
  });
}

/**
 * A number as people write it: no more digits than it needs.
 * @param {number} value
 */
export const tidy = (value) => Number(value.toPrecision(6));

/**
 * A number with so many decimals, a true minus sign and no negative zero.
 * @param {number} value
 * @param {number} decimals
 */
export function number(value, decimals) {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? (0).toFixed(decimals) : text.replace("-", "\u2212");
}

/**
 * The value of a knob with its name and unit, as its slider shows it.
 * @param {Knob} knob
 * @param {number} value in the scene's units
 */
export const valued = ({ label, scale, digits, suffix }, value) =>
  `${label} = ${number(value / scale, digits)}${suffix}`;

/**
 * Digits, and the tool's E, as an index: what subscript in kinlab/drawing/controls.py does.
 * @param {string | number} name
 */
export const lowered = (name) => String(name).replace(/\d/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[Number(digit)])
  .replaceAll("E", "ₑ");
