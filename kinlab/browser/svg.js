// Elements of an SVG picture, which are touched only where something has changed.

const SVG = "http://www.w3.org/2000/svg";

/**
 * What was set last, of each element. Reading it from the element would take longer.
 * @type {WeakMap<Element, Record<string, string>>}
 */
const lastSet = new WeakMap();

/**
 * Whether a property of an element is to be another one from now on.
 * @param {Element} node
 * @param {string} name
 * @param {string} value
 */
function changes(node, name, value) {
  let known = lastSet.get(node);
  if (!known) lastSet.set(node, known = {});
  if (known[name] === value) return false;
  known[name] = value;
  return true;
}

/**
 * An element of an SVG picture.
 * @template {keyof SVGElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, unknown>} attributes those that are absent or "" are left out
 * @param {(Node | string)[]} children
 */
export function drawn(tag, attributes = {}, ...children) {
  const node = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value != null && value !== "") node.setAttribute(name, String(value));
  }
  node.append(...children);
  return node;
}

/**
 * Set an attribute, if it is another one: a picture has hundreds, and few change in a step.
 * @param {Element} node
 * @param {string} name
 * @param {string} value
 */
export function put(node, name, value) {
  if (changes(node, name, value)) node.setAttribute(name, value);
}

/**
 * Set the text of an element, if it is another one.
 * @param {Element} node
 * @param {string} text
 */
export function letter(node, text) {
  if (changes(node, "#text", text)) node.textContent = text;
}

/**
 * Whether an element is to be seen.
 * @param {Element} node
 * @param {boolean} visible
 */
export const reveal = (node, visible) =>
  put(node, "visibility", visible ? "inherit" : "hidden");

/**
 * Whether an element is there at all, to be seen and to be held.
 * @param {SVGElement} node
 * @param {boolean} on
 */
export const display = (node, on) => { node.style.display = on ? "" : "none"; };

/** @type {(value: number) => string} */
export const px = (value) => value.toFixed(1);

const WORD_HALF = 4;                                // px: half the height of small letters

/**
 * Words of a chart beside a place.
 * @type {(text: string, x: number, y: number, anchor?: string) => SVGTextElement}
 */
export const chartWords = (text, x, y, anchor = "start") =>
  drawn("text", { x: px(x), y: px(y + WORD_HALF), "text-anchor": anchor }, text);

/** @type {(point: number[]) => string} */
const spotText = ([x, y]) => `${px(x)} ${px(y)}`;

/** @type {(points: number[][]) => string} */
export const polyline = (points) =>
  points.length ? `M${points.map(spotText).join("L")}` : "";

/** @type {(points: number[][]) => string} */
export const polygon = (points) => points.length ? `${polyline(points)}Z` : "";

/**
 * The order of some elements of one parent, with as few moves as lead there in one walk.
 * @param {Element} parent
 * @param {Element[]} ordered
 */
export function arrange(parent, ordered) {
  let next = parent.firstElementChild;
  for (const node of ordered) {
    if (node === next) next = node.nextElementSibling;
    else parent.insertBefore(node, next);
  }
}

/** A group with as many nodes as are wanted. */
export class Pool {
  /** @type {SVGElement[]} */
  nodes = [];

  /** @param {SVGGElement} group @param {() => SVGElement} make */
  constructor(group, make) {
    this.group = group;
    this.make = make;
  }

  /**
   * Fill a node for each value and hide the rest.
   * @template Value
   * @param {Value[]} values
   * @param {(node: SVGElement, value: Value) => void} fill
   */
  show(values, fill) {
    values.forEach((value, k) => {
      if (!this.nodes[k]) this.group.append(this.nodes[k] = this.make());
      reveal(this.nodes[k], true);
      fill(this.nodes[k], value);
    });
    this.nodes.slice(values.length).forEach((node) => reveal(node, false));
  }
}
