// How a hand points at parts of a view, by mouse, finger or keyboard, and how parts of a page
// light up. A part carries the number of its joint in data-joint (of several in data-joints), or
// the name of its frame in data-frame, or the number of its link in data-link. What only listens
// carries data-holds.

import { claim, hear } from "./dom.js";

/** @import { Pointing } from "./pointing.js" */
/** @import { Pointed, Spot } from "./types.js" */

const NAMED_PARTS = "[data-joint], [data-joints], [data-frame], [data-link]";
const HOLDERS = "[data-joint], [data-joints], [data-holds]";
const PAUSE = 60;                                   // ms: a hand that only passes by lights nothing
const TAPPED = 8;                                    // px: a finger that went no farther has tapped

/** @type {(node: Element) => number[]} */
const jointsOf = (node) =>
  (node.getAttribute("data-joints") ?? node.getAttribute("data-joint") ??
   node.getAttribute("data-holds") ?? "").split(" ").filter(Boolean).map(Number);

/**
 * What a part of a view stands for.
 * @param {EventTarget | null} target
 * @returns {Spot | null}
 */
export function pointedAt(target) {
  const part = target instanceof Element ? target.closest(NAMED_PARTS) : null;
  if (!part) return null;
  const joints = jointsOf(part);
  if (joints.length) return { joints };
  const frame = part.getAttribute("data-frame"), link = part.getAttribute("data-link");
  return frame ? { frames: [frame] } : link ? { links: [Number(link)] } : null;
}

/**
 * Let hands point from an element.
 * @param {HTMLElement} root
 * @param {Pointing} bus
 * @returns {() => void} ends it
 */
export function pointFrom(root, bus) {
  let timer = 0, begun = [0, 0];
  /** @type {Spot | null} */
  let pressed = null;                               // a picture takes the pointer from its parts
  const hover = (/** @type {Spot | null} */ spot) => {
    clearTimeout(timer);
    timer = setTimeout(() => bus.point(spot), PAUSE);
  };
  /** @type {Record<string, (event: any) => void>} */
  const heard = {
    pointerover({ pointerType, buttons, target }) {
      if (pointerType !== "touch" && !buttons) hover(pointedAt(target));
    },
    pointerleave() { hover(null); },
    focusin({ target }) {
      if (target.matches(":focus-visible")) bus.point(pointedAt(target), "focus");
    },
    focusout() { bus.point(null, "focus"); },
    pointerdown({ clientX, clientY, target }) {
      begun = [clientX, clientY];
      pressed = pointedAt(target);
    },
    pointerup({ pointerType, clientX, clientY }) {
      const far = Math.hypot(clientX - begun[0], clientY - begun[1]);
      if (pointerType !== "mouse" && far < TAPPED) bus.point(pressed, "tap");
    },
    keydown({ key }) { if (key === "Escape") bus.clear(); },
  };
  const ignore = hear(root, heard, true);
  return () => {
    clearTimeout(timer);
    ignore();
  };
}

/**
 * Light what holds the joints that are pointed at, and let the rest step back.
 * @param {HTMLElement} root
 * @param {Pointed | null} pointed
 */
export function lightUp(root, pointed) {
  const on = pointed != null && pointed.joints.size > 0;
  root.classList.toggle("kl-pointing", on);
  for (const part of root.querySelectorAll(HOLDERS)) {
    if (part instanceof SVGElement) continue;       // the picture's own business
    const lit = on && jointsOf(part).some((joint) => pointed.joints.has(joint));
    part.classList.toggle("kl-held", lit);
    part.classList.toggle("kl-back", on && !lit);
  }
}

/**
 * Make the factors of a formula one stop of the Tab key; arrows lead from factor to factor.
 * @param {HTMLElement} formula
 */
export function walkThrough(formula) {
  const all = () => /** @type {MathMLElement[]} */ ([...formula.querySelectorAll("[data-factor]")]);
  all().forEach((factor, k, { [k - 1]: before }) => {
    factor.tabIndex = before?.closest("math") === factor.closest("math") ? -1 : 0;
  });
  formula.addEventListener("keydown", (event) => {
    const factors = all().filter((factor) => factor.getClientRects().length);
    const at = factors.indexOf(/** @type {MathMLElement} */ (event.target));
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    const next = at >= 0 && step && factors[at + step];
    if (!next) return;
    factors[at].tabIndex = -1;
    next.tabIndex = 0;
    next.focus();
    claim(event);
  });
}
