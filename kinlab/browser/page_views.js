// Ties live views (mount.js) to a plain page, whose address can hold the values of their knobs.

import { button, group, tidy } from "./dom.js";
import { Listeners } from "./listeners.js";
import { letAllScroll } from "./scrolls.js";
import { clip } from "./steps.js";
import { followTerms } from "./terms.js";

/** @import { Joints, Knob, Live, Question, Scene } from "./types.js" */
/**
 * @typedef {(element: HTMLElement, scene: Scene, joints: Joints, formula: string,
 *            question?: Question) => Live} Put
 */

/**
 * The joints of a view in a plain page: their values, and who listens.
 * @param {number[]} start
 * @returns {Joints}
 */
function pageJoints(start) {
  const listeners = new Listeners();
  let q = start;
  return {
    read: () => q,
    write(wanted) {
      q = wanted;
      listeners.tell();
    },
    listen: (listener) => listeners.add(listener),
  };
}

// ---- the address: #q=30,40,-20, in the sliders' units ----

const ADDRESS_EVERY = 300;                          // ms; browsers refuse more than 100 in 30 s

/** @type {(q: number[], knobs: Knob[]) => string} */
const written = (q, knobs) => `#q=${q.map((value, i) => tidy(value / knobs[i].scale)).join(",")}`;

/**
 * The joint values in an address; null if it has none, and words if they do not fit.
 * @param {string} hash
 * @param {Knob[]} knobs
 */
function parsed(hash, knobs) {
  if (!hash.startsWith("#q=")) return null;
  const values = hash.slice(3).replaceAll("%2C", ",").split(",").map((v) => (v ? Number(v) : NaN));
  if (values.length !== knobs.length || !values.every(Number.isFinite)) {
    return `The address should hold ${knobs.length} numbers, as in ` +
           `${written(knobs.map((knob) => knob.home), knobs)}`;
  }
  return values.map((v, i) => clip(v * knobs[i].scale, knobs[i].low, knobs[i].high));
}

/** @type {(knobs: Knob[], joints: Joints, live: Live) => void} */
function followAddress(knobs, joints, live) {
  const take = () => {
    const q = parsed(location.hash, knobs);
    if (typeof q === "string") return live.note(q);
    if (q && written(q, knobs) !== written(joints.read(), knobs)) joints.write(q);
  };
  let timer = 0;
  const keep = () => {
    timer = 0;
    // A page inside another one, without an address of its own, may not have one written.
    try { history.replaceState(null, "", written(joints.read(), knobs)); } catch { /* no matter */ }
  };
  take();
  joints.listen(() => { timer ||= setTimeout(keep, ADDRESS_EVERY); });
  window.addEventListener("hashchange", take);
}

/**
 * Copy the address with the joint values; of a page on one's own disk only its end.
 * @param {Knob[]} knobs
 * @param {Joints} joints
 * @param {Live} live
 */
async function copyLink(knobs, joints, live) {
  const end = written(joints.read(), knobs), published = /^https?:/.test(location.protocol);
  const text = published ? location.href.split("#")[0] + end : end;
  const advice = published ? "" : " This page is a file: put that behind the address where it is " +
                                  "published.";
  try {
    await navigator.clipboard.writeText(text);
    live.note(`Copied ${published ? "the link" : text}.${advice}`);
  } catch {
    live.note(`Copy this by hand: ${text}${published ? "" : " ."}${advice}`);
  }
}

// ---- every view of the page ----

/**
 * @param {HTMLElement} view
 * @param {Put} put
 */
function start(view, put) {
  const data = view.querySelector("script[type='application/json']");
  const { scene, q, question } = JSON.parse(data?.textContent ?? "");
  const formula = view.querySelector(".kl-math")?.innerHTML ?? "";
  const joints = pageJoints(q), knobs = scene.knobs;
  view.replaceChildren();
  const live = put(view, scene, joints, formula, question);
  followTerms(view, () => live);
  const opening = document.querySelectorAll(".kl-page > main > .kl-opening > *");
  view.querySelector(".kl-head")?.prepend(...opening);
  if (!("address" in view.dataset)) return;
  followAddress(knobs, joints, live);
  view.querySelector(".kl-more")?.prepend(group("Share",
    button("Copy link", "Copy a link to this pose", () => copyLink(knobs, joints, live))));
}

// What may be wider than a page.
const MAY_BE_WIDE = ".kl-mathematics, .kl-site-table, .kl-output, .kl-site :is(pre, p, ul, ol)";

/**
 * Start every view of the page.
 * @param {Put} put puts one there
 */
export function startViews(put) {
  /** @type {NodeListOf<HTMLElement>} */
  (document.querySelectorAll(".kl-view")).forEach((view) => start(view, put));
  letAllScroll(document, MAY_BE_WIDE);
}
