// The matrix under a picture. Where it is wider than the page it is shown column by column, each
// entry in lines as long as the page, so that nobody has to scroll for the position.

import { button, hear, make } from "./dom.js";
import { rove } from "./roving.js";

/** @import { Pose } from "./types.js" */

const MATHML = "http://www.w3.org/1998/Math/MathML";
const SIGNS = ["+", "-", "\u2212"];

/**
 * @param {string} tag
 * @param {(Node | string)[]} children
 */
function math(tag, ...children) {
  const node = document.createElementNS(MATHML, tag);
  node.append(...children);
  return node;
}

/**
 * The parts of an entry between which a line may break: each begins with a sign.
 * @param {Node[]} symbols
 */
function pieces(symbols) {
  /** @type {Node[][]} */
  const all = [[]];
  symbols.forEach((symbol, k) => {
    const last = symbols[k - 1]?.textContent, sign = SIGNS.includes(symbol.textContent ?? "");
    const binary = sign && k > 0 && last !== "(" && last !== "[";
    if (binary) all.push([]);
    const copy = symbol.cloneNode(true);
    if (binary) /** @type {Element} */ (copy).setAttribute("form", "infix");
    all[all.length - 1].push(copy);
  });
  return all.map((part) => math("math", math("mrow", ...part)));
}

/**
 * One entry as a line of text, called by its column and row.
 * @param {Element} entry
 * @param {string} column
 * @param {number} row
 */
function line(entry, column, row) {
  const name = math("math", math("mrow", math("msub", math("mi", column), math("mi", "xyz"[row])),
                                 math("mo", "=")));
  const node = make("div", { class: "kl-entry" }, name);
  for (const part of pieces([...entry.childNodes])) node.append(" ", part);
  for (const { name: key, value } of entry.attributes) {
    if (key.startsWith("data-")) node.setAttribute(key, value);
  }
  return node;
}

/**
 * Show a formula's matrix as a whole while it fits, and else a column of it, the last one first.
 * @param {HTMLElement} node with the formula
 * @param {Pose["columns"]} names of the columns
 * @returns {() => void} lets go of it
 */
export function fitFormula(node, names) {
  const whole = node.querySelector("math"), matrix = whole?.querySelector("mtable");
  const rows = [...matrix?.children ?? []].slice(0, 3);
  if (!whole || !matrix || names.length !== rows[0]?.children.length) return () => {};
  const lines = make("div", { class: "kl-lines" });
  const tabs = names.map(({ name, title }, k) => button(`${name} `, `Column ${name}, ${title}`,
    () => choose(k)));
  tabs.forEach((tab, k) => tab.append(make("span", { class: "kl-short" }, names[k].title ?? "")));
  const choose = (/** @type {number} */ column) => {
    tabs.forEach((tab, k) => tab.setAttribute("aria-pressed", String(k === column)));
    lines.replaceChildren(...rows.map(({ children }, row) =>
      line(children[column], names[column].name, row)));
    /** @type {NodeListOf<MathMLElement>} */
    const factors = lines.querySelectorAll("[data-factor]");
    factors.forEach((factor, k) => { factor.tabIndex = k ? -1 : 0; });
  };
  const paper = make("div", { class: "kl-on-paper" });   // where nobody can choose
  const printing = () => paper.replaceChildren(...names.flatMap(({ name }, column) =>
    rows.map(({ children }, row) => line(children[column], name, row))));
  const choice = make("span", { class: "kl-group", role: "toolbar",
    "aria-label": "Columns of the matrix" }, ...tabs);
  const columns = make("div", { class: "kl-columns", hidden: "" }, choice, lines, paper);
  rove(choice);
  const ruler = make("div");                        // as wide as the page, and never higher
  const sizes = new ResizeObserver(() => {
    whole.style.display = "";
    const wide = matrix.getBoundingClientRect().width > ruler.clientWidth + 1;
    whole.style.display = wide ? "none" : "";
    columns.hidden = !wide;
    if (wide && !lines.hasChildNodes()) choose(names.length - 1);
  });
  node.append(columns, ruler);
  sizes.observe(ruler);
  const deaf = hear(window, { beforeprint: printing, afterprint: () => paper.replaceChildren() });
  return () => {
    sizes.disconnect();
    deaf();
  };
}
