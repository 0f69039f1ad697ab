// What is wider than its place is scrolled by arrow keys, too: while it is, Tab stops there.

const TAKERS = "a[href], button, input, select, textarea, summary, [tabindex='0']";

/**
 * Let an element be scrolled by keys while it is too wide, unless something in it takes the focus.
 * @param {HTMLElement} node
 */
export function letScroll(node) {
  const look = () => {
    const wide = node.scrollWidth > node.clientWidth + 1, inside = node.querySelectorAll(TAKERS);
    if (wide && ![...inside].some((one) => one.getClientRects().length)) node.tabIndex = 0;
    else node.removeAttribute("tabindex");
  };
  const sizes = new ResizeObserver(look);
  for (const part of [node, ...node.children]) sizes.observe(part);
}

/**
 * Let all of these be scrolled by keys.
 * @param {ParentNode} root
 * @param {string} selector
 */
export function letAllScroll(root, selector) {
  /** @type {NodeListOf<HTMLElement>} */
  (root.querySelectorAll(selector)).forEach(letScroll);
}
