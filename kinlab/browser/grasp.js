// Hands on the picture: what can be held there is dragged by a pointer or moved by keys.

import { onPicture } from "./camera.js";
import { claim, hear } from "./dom.js";
import { chainTo, pullHandle, pullJoint, roundness, speeds, touched } from "./handles.js";
import { frames } from "./frames.js";
import { holdsOf, seenFlat } from "./holds.js";
import { KEYS, replaced, stepped, stopsOf } from "./steps.js";
import { drawn } from "./svg.js";

/** @import { Hold } from "./holds.js" */
/** @import { Spot } from "./handles.js" */
/** @import { Picture } from "./picture.js" */
/** @import { Item, Joints, Lens } from "./types.js" */
/** @typedef {{ hold: Hold, item: Item | null, far: number }} Found what a pointer is at */
/** @typedef {{ carry(event: MouseEvent): void, drop(): void }} Grip a hand that holds something */
const FINGER = 22, POINTER = 14;                    // px: how far from a handle a hand may be
const FRONT = 0.99;                                 // cosine of how far from straight on
const DRAGS = 100;                                  // that are remembered

const BODY = ".kl-shape-tube, .kl-shape-ball, .kl-shape-box";

/** @type {Record<string, Spot>} */
const TOWARDS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** All that can be held in one picture, the hand on it, and what hands have done. */
export class Grasp {
  /** @type {Hold | null} */
  held = null;

  /** @type {Hold | null} */
  near = null;

  /** @type {{ knobs: number[], values: number[] }[]} */
  past = [];

  /**
   * @param {HTMLElement} box
   * @param {Picture} picture
   * @param {Joints} joints
   * @param {() => void} redraw
   */
  constructor(box, picture, joints, redraw) {
    this.redraw = redraw;
    this.box = box;
    this.picture = picture;
    this.joints = joints;
    this.scene = picture.scene;
    const { holds, bodies } = holdsOf(this.scene);
    this.holds = holds;
    this.bodies = bodies;
    this.flat = seenFlat(this.scene);
    box.classList.toggle("kl-turns", !this.flat);
    this.rings = drawn("g", { "data-part": "handles" }, ...holds.map(({ ring }) => ring));
    box.append(...holds.map(({ node }) => node));
    this.always = matchMedia("(hover: none)").matches;   // no pointer that finds them
    this.listen();
  }

  listen() {
    const { box } = this;
    // A finger that holds something does not scroll the page.
    const stay = (/** @type {Event} */ event) => { if (this.held) event.preventDefault(); };
    for (const touch of ["touchstart", "touchmove"]) {
      box.addEventListener(touch, stay, { passive: false });
    }
    hear(box, { pointermove: (event) => this.hover(event), pointerleave: () => this.approach(null),
                keydown: (event) => this.command(event) });
    for (const hold of this.holds) {
      hear(hold.node, { blur: () => this.leave(hold), keydown: (event) => this.key(event, hold) });
    }
  }

  /** How the picture was seen when it was drawn last. */
  get lens() { return /** @type {Lens} */ (this.picture.lens); }

  /** Where the knobs are and the frames with them, drawn or not. */
  now() {
    const q = this.joints.read();
    return { q, all: frames(this.scene.motions, q) };
  }

  // ---- what a pointer is at ----

  /**
   * @param {MouseEvent} event
   * @returns {{ hand: Spot, px: number }} the place on the picture, and how long a pixel is there
   */
  at({ clientX, clientY }) {
    const inverse = this.picture.svg.getScreenCTM()?.inverse();
    const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(inverse);
    return { hand: [x, y], px: inverse?.a ?? 1 };
  }

  /**
   * The nearest handle, else the body under the pointer; a finger need not be so exact.
   * @param {PointerEvent} event
   * @returns {Found | null}
   */
  find(event) {
    const { hand, px } = this.at(event), finger = event.pointerType === "touch";
    const reach = px * (finger ? FINGER : POINTER), { lens, picture: { at: all } } = this;
    const [point] = this.holds.filter(({ handle }) => handle).map((hold) => {
      const [x, y] = lens.see(hold.place(all));
      return { hold, item: null, far: Math.hypot(hand[0] - x, hand[1] - y) };
    }).filter(({ far }) => far <= reach).sort((a, b) => a.far - b.far);
    return point ?? this.body(event) ?? (finger ? this.around(hand, reach) : null);
  }

  /**
   * The front body under the pointer, if it can be held; arrows and words do not hide it.
   * @param {PointerEvent} event
   * @returns {Found | null}
   */
  body({ clientX, clientY }) {
    const page = /** @type {Document} */ (this.box.getRootNode());
    const front = page.elementsFromPoint(clientX, clientY)
      .map((node) => node.closest(BODY)).find((group) => group && this.box.contains(group));
    const body = front && this.bodies.get(front.getAttribute("data-piece-of") ?? front.id);
    return body ? { ...body, far: 0 } : null;
  }

  /**
   * The body that is nearest to a finger.
   * @param {Spot} hand
   * @param {number} reach
   * @returns {Found | undefined}
   */
  around(hand, reach) {
    const { lens, picture: { at: all } } = this;
    return [...this.bodies.values()].map(({ item, hold }) => {
      const thick = roundness(item) * lens.scale;
      return { item, hold, far: touched(item, all, hand, lens).far - thick };
    }).filter(({ far }) => far <= reach).sort((a, b) => a.far - b.far)[0];
  }

  /** @param {PointerEvent} event */
  hover(event) {
    if (event.buttons || event.pointerType === "touch") return;
    this.approach(this.find(event)?.hold ?? null);
  }

  /** @param {Hold | null} hold */
  approach(hold) {
    if (hold === this.near) return;
    this.near = hold;
    this.drawn();
  }

  // ---- a hand that drags ----

  /**
   * Take hold of what is under the pointer.
   * @param {PointerEvent} event
   * @returns {Grip | null}
   */
  grab(event) {
    const found = event.button ? null : this.find(event) ?? this.called(event);
    if (!found) return null;
    const { hold, item } = found, { lens } = this, { hand } = this.at(event);
    const { all, q } = this.now(), reached = Number.isFinite(found.far), before = q.slice();
    const place = item ? touched(item, all, hand, lens).place : hold.place(all);
    const [x, y] = onPicture(lens, place), off = reached ? [hand[0] - x, hand[1] - y] : [0, 0];
    const start = { all, q, hand: [x, y], lens };
    const pull = hold.handle ? pullHandle(this.scene, hold.handle, start)
      : pullJoint(this.scene, hold.motion, place, start);
    this.held = hold;
    this.picture.steady.hold(lens);
    for (const knob of hold.knobs) this.joints.gripped?.add(this.scene.knobs[knob].name);
    const carry = (/** @type {MouseEvent} */ moved) => {
      const now = this.at(moved).hand, values = this.joints.read();
      const next = pull([now[0] - off[0], now[1] - off[1]], lens, values);
      if (next.some((value, i) => value !== values[i])) this.joints.write(next);
    };
    if (!reached) carry(event);
    this.drawn();
    return { carry, drop: () => this.drop(hold, before) };
  }

  /**
   * In a plane a target comes to the pointer from anywhere, and so does a mark whose plane is seen
   * from its front.
   * @param {PointerEvent} event
   * @returns {Found | null}
   */
  called({ pointerType }) {
    const { target, across } = this.scene, hold = this.holds[0];
    const comes = across == null ? target && this.flat : Math.abs(this.lens.near[across]) > FRONT;
    return comes && hold && pointerType !== "touch"
      ? { hold, item: null, far: Infinity } : null;
  }

  /**
   * Let go, and remember where the knobs were.
   * @param {Hold} hold
   * @param {number[]} before
   */
  drop(hold, before) {
    this.held = null;
    this.picture.steady.release();
    for (const knob of hold.knobs) this.joints.gripped?.delete(this.scene.knobs[knob].name);
    this.remember(before);
    this.enter(hold);                               // keys go on from here
    this.redraw();
  }

  /** @param {number[]} before */
  remember(before) {
    const q = this.joints.read(), knobs = [...q.keys()].filter((i) => q[i] !== before[i]);
    if (!knobs.length) return;
    this.past.push({ knobs, values: knobs.map((i) => before[i]) });
    if (this.past.length > DRAGS) this.past.shift();
  }

  /** Take the last drag back. */
  undo() {
    const last = this.past.pop();
    if (!last) return;
    const q = this.joints.read().slice();
    last.knobs.forEach((knob, i) => { q[knob] = last.values[i]; });
    this.joints.write(q);
  }

  // ---- keys ----

  /**
   * Keys of the picture: the first or the last thing to hold, and undo.
   * @param {KeyboardEvent} event
   */
  command(event) {
    const { key, ctrlKey, metaKey, shiftKey } = event;
    const inside = event.target !== this.box, ends = { Enter: 0, "]": 0, "[": -1 };
    const undo = key.toLowerCase() === "z" && (ctrlKey || metaKey) && !shiftKey;
    const end = inside ? undefined : ends[/** @type {keyof ends} */ (key)];
    if (!undo && (end == null || !this.holds.length)) return;
    if (undo) this.undo();
    else this.enter(this.holds[end === -1 ? this.holds.length - 1 : 0]);
    claim(event);
  }

  /**
   * Give something the focus, with its state for a screen reader. It is there only meanwhile.
   * @param {Hold} hold
   */
  enter(hold) {
    const { all, q } = this.now();
    hold.describe(all, q);
    hold.node.hidden = false;
    hold.node.focus({ preventScroll: true });
    this.drawn();
  }

  /** @param {Hold} hold */
  leave(hold) {
    hold.node.hidden = true;
    this.drawn();
  }

  /**
   * Keys of something that has the focus.
   * @param {KeyboardEvent} event
   * @param {Hold} hold
   */
  key(event, hold) {
    const { key, shiftKey, ctrlKey, metaKey } = event, k = this.holds.indexOf(hold);
    if (ctrlKey || metaKey) return;
    const on = { "]": 1, "[": -1, Tab: shiftKey ? -1 : 1 }[key];
    const to = k + (on ?? 0), { length } = this.holds;
    const next = this.holds[key === "Tab" ? to : (to + length) % length];
    if (key === "Tab" && !next) return;             // out of the picture
    if (key === "Escape") this.box.focus();
    else if (on) this.enter(next);
    else if (key in (hold.alone ? KEYS : TOWARDS)) this.nudge(hold, key, shiftKey);
    else return;
    claim(event);
  }

  /**
   * Move what has the focus by one step, or a tenth of one.
   * @param {Hold} hold
   * @param {string} key
   * @param {boolean} fine
   */
  nudge(hold, key, fine) {
    const q = this.joints.read(), before = q.slice();
    const [knob, steps] = hold.alone ? [hold.knobs[0], KEYS[key]] : this.along(hold, TOWARDS[key]);
    const one = this.scene.knobs[knob], { scale } = one;
    this.joints.write(steps
      ? replaced(q, knob, stepped(q[knob] / scale, steps, fine, stopsOf(one)) * scale)
      : this.carried(hold, TOWARDS[key], fine));
    this.remember(before);
  }

  /**
   * The slide among a handle's knobs that goes in a direction of the picture, and which way; a
   * handle that turns as well has none.
   * @param {Hold} hold
   * @param {Spot} way
   * @returns {[knob: number, steps: number]}
   */
  along({ handle, knobs }, [right, down]) {
    if (!handle || knobs.some((knob) => this.scene.knobs[knob].unit === "°")) return [knobs[0], 0];
    const q = this.joints.read(), chain = chainTo(this.scene.motions, handle.point[0]);
    const all = frames(chain, q), ways = speeds(chain, all, all[chain.length][3], q, knobs);
    for (const [i, speed] of ways.entries()) {
      const [a, b] = this.lens.turn(speed), straight = (a * right - b * down);
      if (Math.abs(straight) > 0.98 * Math.hypot(...speed)) return [knobs[i], Math.sign(straight)];
    }
    return [knobs[0], 0];
  }

  /**
   * The knobs' values with a handle one step farther to a side of the picture.
   * @param {Hold} hold
   * @param {Spot} way
   * @param {boolean} fine
   */
  carried(hold, [right, down], fine) {
    const { lens, scene } = this, { all, q } = this.now();
    const [x, y] = onPicture(lens, hold.place(all)), start = { all, q, hand: [x, y], lens };
    const step = 10 ** Math.floor(Math.log10(scene.radius / 10)) * lens.scale / (fine ? 10 : 1);
    if (!hold.handle) return q;
    return pullHandle(scene, hold.handle, start)([x + right * step, y + down * step], lens, q);
  }

  // ---- what a picture shows of it ----

  /** Put rings where the picture, which has been drawn, has what is held. */
  drawn() {
    const { lens, picture: { svg, at: all }, held, near, box, rings } = this;
    if (!lens) return;                              // before the first picture
    if (svg.lastElementChild !== rings) svg.append(rings);
    box.dataset.hand = held ? "held" : near ? "near" : "";
    for (const hold of this.holds) {
      const state = hold === held ? "held" : hold.node.matches(":focus") ? "focus"
        : hold === near ? "near" : "";
      if (state || hold.shown || (this.always && hold.handle)) hold.draw(state, all, lens);
    }
  }

  /**
   * Tell assistive technology where everything is; what there is to say of what has the focus, if
   * that is no slider, which says it itself.
   */
  describe() {
    const q = this.joints.read(), { at: all } = this.picture;
    for (const hold of this.holds) hold.describe(all, q);
    const now = this.holds.find(({ node, alone }) => !alone && node.matches(":focus"));
    return now ? `${now.name}, ${now.state(all, q)}` : "";
  }

  /** What the keys do here, for the picture's description. */
  help() {
    const { length } = this.holds;
    return length ? ` Enter goes to what can be moved in the picture: ${length} ` +
      `${length === 1 ? "handle" : "handles"}. There arrow keys move it, with Shift in small ` +
      "steps; Tab goes to the next one, Escape back to the picture. Control Z takes a move back."
      : "";
  }
}
