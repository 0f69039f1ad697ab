// Pointers and keys on the picture: drag or arrows orbit; wheel, pinch or +/- zoom; double click
// resets; a target can be taken hold of.

import { clip } from "./steps.js";

/** @import { Picture } from "./picture.js" */
/** @import { TargetScene, Triple } from "./types.js" */
/** @typedef {(event: PointerEvent | MouseEvent) => void} Carry */

/**
 * Turn and zoom the picture by the pointers and keys of its box.
 * @param {HTMLElement} box
 * @param {Picture} picture
 * @param {() => void} redraw
 * @param {() => void} resetView
 * @param {((event: PointerEvent) => Carry | null) | null} [grab]
 *   takes hold of something under the pointer and gives what carries it
 * @returns {() => void} lets go of the page
 */
export function orbit(box, picture, redraw, resetView, grab) {
  const flat = Object.keys(picture.scene.presets).length === 1;   // a plane is seen from above
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
  /** @type {Carry | null | undefined} */
  let carry = null, scrolled = 0;
  // A page scrolls on past a flat picture in which nothing can be taken hold of.
  box.style.touchAction = flat && !grab ? "pan-y" : "none";
  box.addEventListener("pointerdown", (event) => {
    carry = held.size ? null : grab?.(event);
    held.set(event.pointerId, [event.clientX, event.clientY]);
    box.setPointerCapture(event.pointerId);
  });
  box.addEventListener("pointermove", (event) => {
    const last = held.get(event.pointerId), before = held.size === 2 && spread();
    if (!last) return;
    const [x, y] = last;
    held.set(event.pointerId, [event.clientX, event.clientY]);
    if (held.size === 1 && carry) carry(event);
    else if (held.size === 1) rotate((event.clientX - x) * 0.5, (event.clientY - y) * 0.5);
    if (before) zoom(spread() / before);
  });
  const end = (/** @type {PointerEvent} */ event) => {
    held.delete(event.pointerId);
    carry = null;
  };
  box.addEventListener("pointerup", end);
  box.addEventListener("pointercancel", end);
  box.addEventListener("dblclick", resetView);
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
    event.preventDefault();
    event.stopPropagation();                       // the notebook has uses for these keys too
  });
  return () => document.removeEventListener("wheel", elsewhere, { capture: true });
}

const GRASP = 26;                                   // px: a finger's width

/**
 * Takes hold of the target under the pointer; in a plane the target comes to the pointer.
 * @param {Picture} picture
 * @param {{ to(place: Triple): void }} chase
 * @returns {(event: PointerEvent) => Carry | null}
 */
export function grasp(picture, chase) {
  const { svg } = picture, scene = /** @type {TargetScene} */ (picture.scene);
  const at = (/** @type {MouseEvent} */ event) =>
    new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()?.inverse());
  return (event) => {
    const place = picture.at[scene.target.frame][3], { lens } = picture;
    if (!lens) return null;
    const { right, up } = lens, [x, y, size] = lens.see(place), scale = lens.scale * size;
    const hand = at(event), far = Math.hypot(hand.x - x, hand.y - y) > GRASP;
    if (far && Object.keys(scene.presets).length > 1) return null;
    const offset = far ? [0, 0] : [hand.x - x, hand.y - y];
    const take = (/** @type {MouseEvent} */ e) => {
      const now = at(e), across = now.x - offset[0] - x, above = y + offset[1] - now.y;
      chase.to(place.map((v, k) => v + (across * right[k] + above * up[k]) / scale));
    };
    if (far) take(event);
    return take;
  };
}
