// Pointers and keys on the picture: drag or arrows orbit; wheel, pinch or +/- zoom; double click
// resets. What can be held there (grasp.js) is asked first.

import { claim, hear } from "./dom.js";
import { seenFlat } from "./holds.js";
import { clip } from "./steps.js";

/** @import { Grasp, Grip } from "./grasp.js" */
/** @import { Picture } from "./picture.js" */

/**
 * Turn and zoom the picture by the pointers and keys of its box.
 * @param {HTMLElement} box
 * @param {Picture} picture
 * @param {() => void} redraw
 * @param {() => void} resetView
 * @param {Grasp} hands
 * @returns {() => void} lets go of the page
 */
export function orbit(box, picture, redraw, resetView, hands) {
  const flat = seenFlat(picture.scene);
  /** @type {(right: number, up: number) => void} */
  const rotate = (right, up) => {
    if (flat) return;
    const camera = picture.camera;
    camera.azimuth -= right;
    camera.elevation = clip(camera.elevation + up, -90, 90);
    redraw();
  };
  const zoom = (/** @type {number} */ factor) => {
    picture.camera.zoom = clip(picture.camera.zoom * factor, 0.4, 8);
    redraw();
  };
  /** @type {Map<number, number[]>} */
  const held = new Map();                          // where each finger or the mouse is
  const spread = () => {
    const [[x, y], [u, v]] = held.values();
    return Math.max(1, Math.hypot(x - u, y - v));
  };
  /** @type {Grip | null} */
  let grip = null;
  let scrolled = 0;
  box.style.touchAction = flat ? "pan-y" : "none";  // a page scrolls on past a flat picture
  const letGo = () => {
    const last = grip;
    grip = null;
    last?.drop();
  };
  box.addEventListener("pointerdown", (event) => {
    const first = !held.size;
    letGo();                                        // a second finger zooms
    if (first) grip = hands.grab(event);
    held.set(event.pointerId, [event.clientX, event.clientY]);
    box.setPointerCapture(event.pointerId);
  });
  box.addEventListener("pointermove", (event) => {
    const last = held.get(event.pointerId), before = held.size === 2 && spread();
    if (!last) return;
    const [x, y] = last;
    held.set(event.pointerId, [event.clientX, event.clientY]);
    if (held.size === 1 && grip) grip.carry(event);
    else if (held.size === 1) rotate((event.clientX - x) * 0.5, (event.clientY - y) * 0.5);
    if (before) zoom(spread() / before);
  });
  const end = (/** @type {PointerEvent} */ event) => {
    held.delete(event.pointerId);
    letGo();
  };
  hear(box, { pointerup: end, pointercancel: end, dblclick: resetView });
  box.addEventListener("wheel", (event) => {
    if (event.timeStamp - scrolled < 250) { scrolled = event.timeStamp; return; }
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * 0.0015));
  }, { passive: false });
  // A page that is being scrolled past the picture goes on scrolling.
  const elsewhere = (/** @type {WheelEvent} */ event) => {
    if (!box.contains(/** @type {Node} */ (event.target))) scrolled = event.timeStamp;
  };
  document.addEventListener("wheel", elsewhere, { passive: true, capture: true });
  /** @type {Record<string, () => void>} */
  const keys = {
    ArrowLeft: () => rotate(-5, 0), ArrowRight: () => rotate(5, 0),
    ArrowUp: () => rotate(0, 5), ArrowDown: () => rotate(0, -5),
    "+": () => zoom(1.15), "=": () => zoom(1.15), "-": () => zoom(1 / 1.15), 0: resetView,
  };
  box.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    keys[event.key]();
    claim(event);
  });
  return () => document.removeEventListener("wheel", elsewhere, { capture: true });
}
