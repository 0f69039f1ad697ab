// Terms of a lesson's text that light up a view: [the wrist](#kl:joints=4,5,6). The view that is
// nearest above or below the text answers, if it has what the term names.

import { hear } from "./dom.js";

/** @import { Live, Spot } from "./types.js" */

const TERM = 'a[href^="#kl:"]';

/** @type {(text: string) => string} */
function decoded(text) {
  try { return decodeURIComponent(text); } catch { return ""; }   // "100%" is no address
}

/**
 * What a term names: joints, frames and links, such as #kl:joints=2,3 and #kl:frame=1.
 * @param {string} href
 * @returns {Spot | null} null where nothing can be read
 */
export function readTerm(href) {
  const asked = new URLSearchParams(decoded(href.split("#kl:")[1] ?? ""));
  const list = (/** @type {string} */ name) =>
    [`${name}s`, name].flatMap((key) => asked.get(key)?.split(",") ?? []).filter(Boolean);
  const [joints, links] = ["joint", "link"].map((name) => list(name).map(Number));
  const frames = list("frame"), good = [...joints, ...links].every(Number.isInteger);
  if (!good || joints.length + links.length + frames.length === 0) return null;
  return { ...(joints.length && { joints }), ...(frames.length && { frames }),
           ...(links.length && { links }) };
}

/** @type {(view: Element, spot: Spot) => boolean} */
const holds = (view, { joints = [], frames = [], links = [] }) =>
  Object.entries({ joint: joints, frame: frames, link: links }).every(([kind, all]) =>
    all.every((one) => view.querySelector(`[data-${kind}="${CSS.escape(String(one))}"]`)));

/** @type {(term: Element, view: Element) => number} */
function gap(term, view) {
  const [text, picture] = [term, view].map((node) => node.getBoundingClientRect());
  return Math.max(0, picture.top - text.bottom, text.top - picture.bottom);
}

/**
 * The view that answers a term.
 * @param {Element} term
 * @param {Spot} spot
 */
function answering(term, spot) {
  const views = [...term.ownerDocument.querySelectorAll(".kl-view")]
    .filter((view) => view.getClientRects().length && holds(view, spot));
  return views.sort((a, b) => gap(term, a) - gap(term, b))[0];
}

/**
 * Let the terms of the page light a view.
 * @param {HTMLElement} element that the view stands in
 * @param {() => Live | undefined} view
 * @returns {() => void} ends it
 */
export function followTerms(element, view) {
  const page = element.ownerDocument;
  /** @typedef {(live: Live, spot: Spot, term: HTMLElement) => void} Act */
  /** @type {(act: Act) => (event: Event) => void} */
  const onTerm = (act) => (event) => {
    const term = event.target instanceof Element &&
      /** @type {HTMLElement | null} */ (event.target.closest(TERM));
    const spot = term ? readTerm(term.getAttribute("href") ?? "") : null, live = view();
    if (term && spot && live && answering(term, spot) === element) act(live, spot, term);
  };
  const lead = onTerm((live, spot, term) => {
    term.focus();                                   // Safari does not give a clicked link the focus
    live.point(spot, "word");
    element.scrollIntoView({ block: "nearest" });
  });
  return hear(page, {
    pointerover: onTerm((live, spot) => live.point(spot)),
    pointerout: onTerm((live) => live.point(null)),
    focusin: onTerm((live, spot) => live.point(spot, "word")),
    focusout: onTerm((live) => live.point(null, "word")),
    click: (/** @type {Event} */ event) => {        // no address has this end
      if (event.target instanceof Element && event.target.closest(TERM)) event.preventDefault();
      lead(event);
    },
  });
}
