// What can be held in a picture: points that knobs bring to the hand, and joints by their links.
// Each has an element that takes the focus, tells its name and state, and a ring in the picture.

import { make, number, tidy } from "./dom.js";
import { roomPoint } from "./frames.js";
import { jointMotion } from "./handles.js";
import { drawn, put } from "./svg.js";

/** @import { Frame, Handle, Item, Lens, Scene } from "./types.js" */

const BODIES = ["tube", "ball", "box"];
const RING_RADIUS = 13;                                    // px

/**
 * Whether a scene is seen from one side only.
 * @param {Scene} scene
 */
export const seenFlat = ({ presets }) => Object.keys(presets).length === 1;

/** A point or a joint that can be held. */
export class Hold {
  shown = "";

  /**
   * @param {Scene} scene
   * @param {number[]} knobs
   * @param {Handle | null} handle
   * @param {number} motion of the joint, where there is no handle
   */
  constructor(scene, knobs, handle, motion) {
    this.scene = scene;
    this.knobs = knobs;
    this.handle = handle;
    this.motion = motion;
    const [{ label, title, low, high, scale }] = knobs.map((k) => scene.knobs[k]);
    const joint = title ? `${label}, ${title}` : label;
    this.name = handle ? handle.name : joint;
    this.alone = knobs.length === 1;
    this.node = make("div", { class: "kl-hold", tabindex: "-1", hidden: "", "aria-label": this.name,
      "data-joint": handle ? null : knobs[0] + 1, role: this.alone ? "slider" : "button",
      "aria-roledescription": this.alone ? null : "handle",
      "aria-valuemin": this.alone ? tidy(low / scale) : null,
      "aria-valuemax": this.alone ? tidy(high / scale) : null });
    this.ring = drawn("circle", { r: RING_RADIUS, class: handle ? "kl-ring kl-point" : "kl-ring" });
    put(this.ring, "data-state", "");
  }

  /**
   * Where it is in the room; a joint is where its axis is.
   * @param {Frame[]} all
   */
  place(all) {
    return this.handle ? roomPoint(all, this.handle.point) : all[this.motion + 1][3];
  }

  /**
   * What to say of where it is.
   * @param {Frame[]} all
   * @param {number[]} q
   */
  state(all, q) {
    if (this.alone) {
      const { scale, digits, suffix } = this.scene.knobs[this.knobs[0]];
      return (q[this.knobs[0]] / scale).toFixed(digits) + suffix;
    }
    const { decimals } = this.scene, unit = this.handle?.unit ?? "";
    const place = this.place(all).slice(0, seenFlat(this.scene) ? 2 : 3);
    return `at ${place.map((e) => number(e, decimals)).join(", ")} ${unit}`.trim();
  }

  /**
   * Tell assistive technology of its state.
   * @param {Frame[]} all
   * @param {number[]} q
   */
  describe(all, q) {
    const state = this.state(all, q), { node } = this;
    if (!this.alone) return node.setAttribute("aria-label", `${this.name}, ${state}`);
    const { scale } = this.scene.knobs[this.knobs[0]];
    node.setAttribute("aria-valuenow", String(tidy(q[this.knobs[0]] / scale)));
    node.setAttribute("aria-valuetext", state);
  }

  /**
   * Put the ring round it, in one of the states "", "near", "focus" and "held".
   * @param {string} state
   * @param {Frame[]} all
   * @param {Lens} lens
   */
  draw(state, all, lens) {
    this.shown = state;
    const [x, y] = lens.see(this.place(all));
    put(this.ring, "data-state", state);
    put(this.ring, "cx", x.toFixed(2));
    put(this.ring, "cy", y.toFixed(2));
  }
}

/**
 * The motion of the joint that goes when a body is dragged; -1 if none does.
 * @param {Scene} scene
 * @param {Item} item
 */
function jointOf({ knobs, motions }, item) {
  const body = BODIES.includes(item.shape) && (item.link || item.joint);
  const motion = body ? jointMotion(motions, item) : -1, knob = knobs[motions[motion]?.joint ?? -1];
  return knob?.low === knob?.high ? -1 : motion;    // a locked joint does not go
}

/**
 * All that can be held: handles first, then joints in their order; and the bodies of joints.
 * @param {Scene} scene
 */
export function holdsOf(scene) {
  const bodies = scene.items.map((item) => ({ item, motion: jointOf(scene, item) }))
    .filter(({ motion }) => motion >= 0);
  const joints = [...new Set(bodies.map(({ motion }) => motion))].sort((a, b) => a - b)
    .map((k) => new Hold(scene, [scene.motions[k].joint ?? 0], null, k));
  const points = scene.handles.map((handle) => new Hold(scene, handle.knobs, handle, -1));
  const hold = (/** @type {number} */ motion) => joints.filter((joint) => joint.motion === motion);
  return { holds: [...points, ...joints], bodies: new Map(bodies.flatMap(({ item, motion }) =>
    hold(motion).map((joint) => [item.gid, { item, hold: joint }]))) };
}
